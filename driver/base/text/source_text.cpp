// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/source_text.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "driver/base/text/inputs_read.hpp"
#include "driver/base/text/standard_input.hpp"
#include "driver/base/text/utf8.hpp"

namespace slipbench::driver::base {

struct SourceText::Data {
  // In a very long line: how many code points stand before a byte of it.
  struct Checkpoint {
    std::uint32_t offset = 0;
    std::uint32_t code_points = 0;
  };

  std::string name{};
  std::string text{};
  std::vector<std::uint32_t> line_starts{};
  std::vector<Checkpoint> checkpoints{};

  // The offset of a line's line feed, or the end of the text.
  [[nodiscard]] std::size_t line_end(std::size_t index) const {
    if (index + 1 < line_starts.size()) return line_starts[index + 1] - 1;
    return !text.empty() && text.back() == '\n' ? text.size() - 1 : text.size();
  }
};

namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

// Drops the carriage return of each CRLF, in place.
void normalise_line_ends(std::string& text) {
  std::size_t to = text.find("\r\n");
  if (to == std::string::npos) return;
  for (std::size_t from = to; from < text.size(); ++from) {
    if (text[from] == '\r' && from + 1 < text.size() && text[from + 1] == '\n') continue;
    text[to++] = text[from];
  }
  text.resize(to);
}

// Closes a file descriptor at the end of a scope.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  [[nodiscard]] int get() const { return value_; }

 private:
  int value_;
};

tl::unexpected<ReadError> failed(ReadFailure failure, const std::string& path, std::string message,
                                 std::string hint = {}) {
  return tl::make_unexpected(ReadError{
      failure, Diagnostic{Severity::kError, path, {}, {}, std::move(message), std::move(hint)}});
}

tl::unexpected<ReadError> failed_with(int error, const std::string& path) {
  return failed(ReadFailure::kEnvironment, path,
                fmt::format("cannot be read: {}", std::strerror(error)));
}

std::string_view kind_of_file(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

std::string size_in_words(std::size_t bytes) {
  constexpr std::size_t kMebi = std::size_t{1} << 20U;
  return bytes % kMebi == 0 ? fmt::format("{} MiB", bytes / kMebi) : fmt::format("{} bytes", bytes);
}

// UTF-16 and UTF-32 by their byte order marks, or by the NUL beside an ASCII first letter.
std::string_view wide_encoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (text.starts_with("\xFF\xFE"sv) || text.starts_with("\xFE\xFF"sv)) return "UTF-16";
  const std::size_t nuls = static_cast<std::size_t>(
      std::count(text.begin(), text.begin() + std::min<std::ptrdiff_t>(8, std::ssize(text)), '\0'));
  if (text.size() < 8 || text.substr(0, 2) == "\0\0"sv) return {};
  if (nuls == 4 && ((text[0] == '\0') != (text[1] == '\0'))) return "UTF-16";
  return {};
}

/// Reads what is left of an open file of that expected size.
tl::expected<SourceText, ReadError> read_all(int file, const std::string& path, std::size_t size,
                                             std::size_t size_limit) {
  const auto too_large = [&] {
    return failed(ReadFailure::kBadInput, path,
                  fmt::format("is larger than the limit of {}", size_in_words(size_limit)),
                  "put long tables and histories into a CSV file");
  };
  if (size > size_limit) return too_large();

  // One byte more than expected shows a file that grows while it is read.
  std::string bytes(size + 1, '\0');
  std::size_t filled = 0;
  for (;;) {
    if (filled == bytes.size()) bytes.resize(filled + 1 + filled / 2);
    const ssize_t got = ::read(file, bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return failed_with(errno, path);
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
    if (filled > size_limit) return too_large();
  }
  bytes.resize(filled);
  return SourceText(path, std::move(bytes));
}

}  // namespace

SourceText::SourceText(std::string name, std::string bytes) {
  if (bytes.starts_with(kUtf8Mark)) bytes.erase(0, kUtf8Mark.size());
  normalise_line_ends(bytes);
  Data data{std::move(name), std::move(bytes), {}};
  const auto line_feeds = std::count(data.text.begin(), data.text.end(), '\n');
  data.line_starts.reserve(static_cast<std::size_t>(line_feeds) + 1);
  data.line_starts.push_back(0);
  for (std::size_t i = data.text.find('\n'); i != std::string::npos;
       i = data.text.find('\n', i + 1))
    data.line_starts.push_back(static_cast<std::uint32_t>(i + 1));
  // What follows the last line feed is a line only if there is something in it.
  if (data.line_starts.size() > 1 && data.line_starts.back() == data.text.size())
    data.line_starts.pop_back();
  // A place in a line is found by counting from its start. Where a line is as long as a file (a
  // table on one line), that would take quadratic time for all its numbers.
  constexpr std::size_t kStride = 4096;
  for (std::size_t i = 0; i < data.line_starts.size(); ++i) {
    const std::size_t end = data.line_end(i);
    std::size_t offset = data.line_starts[i];
    std::uint32_t count = 0;
    while (end - offset > kStride) {
      for (const std::size_t stop = offset + kStride; offset < stop; ++count)
        offset += decode_utf8(std::string_view(data.text).substr(offset)).length;
      data.checkpoints.push_back({static_cast<std::uint32_t>(offset), count});
    }
  }
  data_ = std::make_shared<const Data>(std::move(data));
}

const std::string& SourceText::name() const { return data_->name; }

std::string_view SourceText::text() const { return data_->text; }

int SourceText::line_count() const { return static_cast<int>(data_->line_starts.size()); }

std::string_view SourceText::line(int number) const {
  if (number < 1 || number > line_count()) return {};
  const auto index = static_cast<std::size_t>(number - 1);
  const std::size_t begin = data_->line_starts[index];
  return std::string_view(data_->text).substr(begin, data_->line_end(index) - begin);
}

SourcePosition SourceText::position(std::size_t offset, std::size_t length) const {
  const std::vector<std::uint32_t>& starts = data_->line_starts;
  offset = std::min(offset, data_->text.size());
  const auto after = std::upper_bound(starts.begin(), starts.end(), offset);
  const auto index = static_cast<std::size_t>(after - starts.begin()) - 1;
  const std::string_view text = data_->text;
  const std::size_t line_end = data_->line_end(index);
  const std::size_t begin = std::min(offset, line_end);
  std::size_t counted_to = starts[index];
  std::size_t before = 0;
  const auto checkpoint = std::upper_bound(
      data_->checkpoints.begin(), data_->checkpoints.end(), begin,
      [](std::size_t value, const Data::Checkpoint& c) { return value < c.offset; });
  if (checkpoint != data_->checkpoints.begin() && (checkpoint - 1)->offset > counted_to) {
    counted_to = (checkpoint - 1)->offset;
    before = (checkpoint - 1)->code_points;
  }
  before += count_code_points(text.substr(counted_to, begin - counted_to));
  const std::size_t marked =
      count_code_points(text.substr(begin, std::min(length, line_end - begin)));
  return {static_cast<int>(index) + 1, static_cast<int>(before) + 1,
          std::max(1, static_cast<int>(marked))};
}

tl::expected<SourceText, ReadError> read_source(const std::string& path, std::size_t size_limit) {
  if (path == kStandardInput) {
    note_input(STDIN_FILENO);
    return read_all(STDIN_FILENO, source_name(path), 0, size_limit);
  }
  if (path.empty()) {
    return failed(ReadFailure::kBadInput, "''",
                  "names no file; is a variable of the shell not set?");
  }
  struct stat status {};
  // Asked before opening: to open a device can already act on it.
  if (::stat(path.c_str(), &status) != 0) return failed_with(errno, path);
  if (!S_ISREG(status.st_mode)) {
    return failed(ReadFailure::kEnvironment, path,
                  fmt::format("is {}, not a file", kind_of_file(status.st_mode)));
  }
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0) return failed_with(errno, path);
  // The file could have been exchanged for another between the two calls.
  if (!S_ISREG(status.st_mode)) {
    return failed(ReadFailure::kEnvironment, path,
                  fmt::format("is {}, not a file", kind_of_file(status.st_mode)));
  }
  note_input(file.get());
  return read_all(file.get(), path, static_cast<std::size_t>(status.st_size), size_limit);
}

Diagnostics check_text(const SourceText& source) {
  Diagnostics found;
  const std::string_view text = source.text();
  if (const std::string_view encoding = wide_encoding(text); !encoding.empty()) {
    found.error(source.name(), source.position(0), {}, fmt::format("this is {} text", encoding),
                "save it as UTF-8");
    return found;
  }
  bool seen_invalid = false;
  bool seen_control = false;
  bool seen_return = false;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte >= 0x20 && byte < 0x7F) || byte == '\n' || byte == '\t') {
      ++i;
      continue;
    }
    const CodePoint c = decode_utf8(text.substr(i));
    const bool control = c.value < 0x20 || (c.value >= 0x7F && c.value <= 0x9F);
    if (!c.valid && !seen_invalid) {
      seen_invalid = true;
      found.error(source.name(), source.position(i), {},
                  fmt::format("byte 0x{:02X} is not valid UTF-8", byte), "save the file as UTF-8");
    } else if (c.valid && c.value == '\r' && !seen_return) {
      seen_return = true;
      found.error(source.name(), source.position(i), {}, "carriage return without a line feed",
                  "save the file with LF or CRLF line ends");
    } else if (c.valid && c.value != '\r' && control && !seen_control) {
      seen_control = true;
      found.error(source.name(), source.position(i), {},
                  c.value == 0 ? std::string("NUL character")
                               : fmt::format("control character U+{:04X}", c.value),
                  "is this a text file?");
    }
    i += c.length;
  }
  return found;
}

}  // namespace slipbench::driver::base
