// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/regular_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace slipbench::driver::base {

tl::expected<std::ifstream, std::string> open_regular(const std::filesystem::path& file) {
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(file, unknown);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return tl::unexpected(file.string() + ": is no regular file");
  }
  std::ifstream in(file, std::ios::binary);
  if (in) return in;
  return tl::unexpected(
      fmt::format("{}: cannot be read: {}", file.string(), std::generic_category().message(errno)));
}

}  // namespace slipbench::driver::base
