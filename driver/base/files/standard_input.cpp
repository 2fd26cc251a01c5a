// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/standard_input.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <string>
#include <system_error>
#include <vector>

#include "driver/base/text/inputs_read.hpp"
#include "driver/base/text/standard_input.hpp"

namespace slipbench::driver::base {
namespace {

tl::unexpected<HistoryError> failed(const char* what) {
  return environment_error(std::string(kStandardInputName),
                           fmt::format("{}: {}", what, std::generic_category().message(errno)));
}

tl::expected<std::filesystem::path, HistoryError> copy_to_memory() {
  note_input(STDIN_FILENO);
  const int memory = ::memfd_create("stdin", MFD_CLOEXEC);
  if (memory < 0) return failed("cannot be kept in memory");
  std::vector<char> block(std::size_t{1} << 16U);
  for (;;) {
    const ssize_t count = ::read(STDIN_FILENO, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failed("cannot be read");
    if (count == 0) break;
    for (ssize_t written = 0; written < count;) {
      const ssize_t more =
          ::write(memory, block.data() + written, static_cast<std::size_t>(count - written));
      if (more < 0 && errno == EINTR) continue;
      if (more < 0) return failed("cannot be kept in memory");
      written += more;
    }
  }
  // Opened by this name, it has a place in the file of its own.
  return std::filesystem::path(fmt::format("/proc/self/fd/{}", memory));
}

}  // namespace

tl::expected<std::filesystem::path, HistoryError> standard_input_file() {
  static const auto file = copy_to_memory();
  return file;
}

}  // namespace slipbench::driver::base
