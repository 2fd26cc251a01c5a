// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/line_reader.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "driver/base/text/inputs_read.hpp"

namespace slipbench::driver::base {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

std::string system_message(int error) { return std::generic_category().message(error); }

}  // namespace

LineReader::~LineReader() {
  if (descriptor >= 0) ::close(descriptor);
}

tl::expected<void, HistoryError> LineReader::open(const std::filesystem::path& file) {
  // Without O_NONBLOCK, opening a FIFO waits for a writer.
  descriptor = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) {
    return environment_error(name, fmt::format("cannot be opened: {}", system_message(errno)));
  }
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) {
    return environment_error(name, fmt::format("cannot be examined: {}", system_message(errno)));
  }
  if (!S_ISREG(status.st_mode)) {
    return environment_error(name,
                             S_ISDIR(status.st_mode) ? "is a directory" : "is not a regular file");
  }
  note_input(descriptor);
  buffer.resize(kBlock);
  return {};
}

tl::expected<void, HistoryError> LineReader::fill() {
  while (begin == lines_end && !at_end) {
    std::memmove(buffer.data(), buffer.data() + begin, end - begin);
    buffer_offset += static_cast<off_t>(begin);
    end -= begin;
    begin = lines_end = 0;
    // One byte is kept free for the last line's end.
    if (end + 1 >= buffer.size()) {
      if (buffer.size() >= kLongestLine) {
        return error(next_line, 0, "the line is longer than a megabyte: not a CSV file");
      }
      buffer.resize(2 * buffer.size());
    }
    const std::size_t old_end = end;
    const ssize_t count = ::read(descriptor, buffer.data() + end, buffer.size() - 1 - end);
    if (count < 0) {
      if (errno == EINTR) continue;
      return environment_error(name, fmt::format("cannot be read: {}", system_message(errno)));
    }
    end += static_cast<std::size_t>(count);
    if (count == 0) {
      at_end = true;
      if (end > 0) buffer[end++] = '\n';
    }
    const void* const last = ::memrchr(buffer.data() + old_end, '\n', end - old_end);
    if (last != nullptr) {
      lines_end = static_cast<std::size_t>(static_cast<const char*>(last) - buffer.data()) + 1;
    }
  }
  return {};
}

std::string_view LineReader::take_line() {
  const char* const start = buffer.data() + begin;
  const auto* const stop = static_cast<const char*>(std::memchr(start, '\n', lines_end - begin));
  std::string_view line(start, static_cast<std::size_t>(stop - start));
  begin += line.size() + 1;
  ++next_line;
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

tl::expected<void, HistoryError> LineReader::go_back(off_t offset, long line) {
  if (::lseek(descriptor, offset, SEEK_SET) != offset) {
    return environment_error(name, fmt::format("cannot be read again: {}", system_message(errno)));
  }
  buffer_offset = offset;
  begin = lines_end = end = 0;
  at_end = false;
  next_line = line;
  return {};
}

std::string LineReader::head() const {
  std::string head(kBlock, '\0');
  const ssize_t count = ::pread(descriptor, head.data(), head.size(), 0);
  head.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return head;
}

tl::unexpected<HistoryError> LineReader::error(long line, std::size_t offset,
                                               std::string message) const {
  return tl::unexpected(HistoryError{HistoryError::Kind::kInput, name, line,
                                     static_cast<int>(offset) + 1, std::move(message)});
}

}  // namespace slipbench::driver::base
