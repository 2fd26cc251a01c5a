// SPDX-License-Identifier: Apache-2.0
#include "driver/history/csv_reader.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "driver/text/diagnostic.hpp"

namespace slipbench::driver {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;
constexpr int kSkip = -1;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Reads the number at [begin, end) and returns where it stops; null when there is none, or none
/// in the range of a double. The end of the line must lie before `end`.
///
/// Most measured numbers have few digits. Their digits make an integer below 2^53 and their power
/// of ten is exact, so one correctly rounded operation gives the nearest double (Clinger 1990); the
/// rest is left to std::from_chars, with the same result.
const char* read_number(const char* begin, const char* end, double& value) {
  static constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::uint64_t kExactIntegers = std::uint64_t{1} << 53;
  constexpr std::ptrdiff_t kDigitsOf64Bits = 19;

  const char* p = begin;
  const bool negative = *p == '-';
  if (negative || *p == '+') ++p;
  const char* const number = p;
  std::uint64_t digits = 0;
  while (is_digit(*p)) digits = 10 * digits + static_cast<std::uint64_t>(*p++ - '0');
  std::ptrdiff_t count = p - number;
  std::ptrdiff_t decimals = 0;
  if (*p == '.') {
    const char* const fraction = ++p;
    while (is_digit(*p)) digits = 10 * digits + static_cast<std::uint64_t>(*p++ - '0');
    decimals = p - fraction;
    count += decimals;
  }
  if (count > 0 && count <= kDigitsOf64Bits && digits <= kExactIntegers && decimals <= 22 &&
      *p != 'e' && *p != 'E') {
    const double magnitude =
        static_cast<double>(digits) / kPowers[static_cast<std::size_t>(decimals)];
    value = negative ? -magnitude : magnitude;
    return p;
  }
  // from_chars has no leading '+', and reads "nan" and "inf" as well.
  if (*number == '-' || *number == '+') return nullptr;
  const auto [stop, error] = std::from_chars(number, end, value);
  if (error != std::errc{} || !std::isfinite(value)) return nullptr;
  if (negative) value = -value;
  return stop;
}

struct Field {
  std::string_view text;   ///< Without blanks around it and without quotes.
  std::size_t offset = 0;  ///< Of `text` in the line.
};

std::vector<Field> split(std::string_view line, char separator) {
  std::vector<Field> fields;
  const auto add = [&](std::size_t begin, std::size_t end) {
    while (begin < end && (line[begin] == ' ' || line[begin] == '\t')) ++begin;
    while (begin < end && (line[end - 1] == ' ' || line[end - 1] == '\t')) --end;
    if (end - begin >= 2 && line[begin] == '"' && line[end - 1] == '"') {
      ++begin;
      --end;
    }
    fields.push_back({line.substr(begin, end - begin), begin});
  };
  std::size_t begin = 0;
  bool is_quoted_field = false;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    // A quote inside a plain field is a character like any other (an inch mark).
    if (line[i] == '"') {
      is_quoted_field |=
          line.substr(begin, i - begin).find_first_not_of(" \t") == std::string_view::npos;
      quoted ^= is_quoted_field;
    } else if (line[i] == separator && !quoted) {
      add(begin, i);
      begin = i + 1;
      is_quoted_field = false;
    }
  }
  add(begin, line.size());
  return fields;
}

/// The most frequent of the separators in the header, outside quotes.
char detect_separator(std::string_view header) {
  constexpr std::string_view kSeparators = "\t;,";
  std::array<int, kSeparators.size()> counts{};
  bool quoted = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    const std::size_t which = kSeparators.find(c);
    if (!quoted && which != std::string_view::npos) ++counts[which];
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  return *most == 0 ? ',' : kSeparators[static_cast<std::size_t>(most - counts.begin())];
}

std::string_view separator_name(char separator) {
  return separator == '\t' ? "tab" : (separator == ';' ? "';'" : "','");
}

bool is_number(std::string_view text) {
  const std::string line = std::string(text) + '\n';
  double value = 0.0;
  const char* const stop = read_number(line.data(), line.data() + line.size(), value);
  return stop == line.data() + text.size();
}

/// A piece of a foreign file, fit for a message.
std::string quote(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown = "'";
  for (const char c : text.substr(0, kLongest)) {
    shown += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  }
  shown += text.size() > kLongest ? "...'" : "'";
  return shown;
}

/// Why `text` is no number.
std::string not_a_number(std::string_view text) {
  if (text.empty()) return "is empty";
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const std::string_view unsigned_text =
      std::string_view(lower).substr(lower[0] == '-' || lower[0] == '+' ? 1 : 0);
  if (unsigned_text.starts_with("nan") || unsigned_text.starts_with("inf")) {
    return fmt::format("holds {}; a finite number is wanted", quote(text));
  }
  if (const std::size_t comma = text.find(','); comma != std::string_view::npos) {
    std::string with_point(text);
    with_point[comma] = '.';
    if (is_number(with_point)) {
      return fmt::format("holds {} with a decimal comma; the decimal mark is '.'", quote(text));
    }
  }
  double value = 0.0;
  const auto [stop, error] =
      std::from_chars(unsigned_text.data(), unsigned_text.data() + unsigned_text.size(), value);
  if (error == std::errc::result_out_of_range &&
      stop == unsigned_text.data() + unsigned_text.size()) {
    return fmt::format("holds {}, which is outside the range of a double", quote(text));
  }
  return fmt::format("holds {}, which is not a number", quote(text));
}

std::string system_message(int error) { return std::generic_category().message(error); }

}  // namespace

struct CsvReader::File {
  std::string name;
  int descriptor = -1;
  std::vector<char> buffer;
  std::size_t begin = 0;      ///< The first byte not yet read.
  std::size_t lines_end = 0;  ///< Behind the last complete line in the buffer.
  std::size_t end = 0;        ///< Behind the last byte in the buffer.
  bool at_end = false;        ///< Whether the file has no more bytes for the buffer.
  off_t buffer_offset = 0;    ///< Where in the file the buffer's first byte comes from.
  long next_line = 1;         ///< The line at `begin`.
  long row_line = 0;
  long blank_line = 0;  ///< The first of the blank lines since the last row; 0 when none.
  long rows = 0;

  std::vector<std::string> header;
  long header_line = 0;
  off_t rows_offset = 0;
  char separator = ',';
  std::vector<int> slots;    ///< For each column of the file, where its number goes, or kSkip.
  std::size_t selected = 0;  ///< How many numbers a row yields.
  std::vector<std::pair<std::size_t, std::size_t>> copies;  ///< Slots of a column asked for twice.

  File() = default;
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (descriptor >= 0) ::close(descriptor);
  }

  tl::unexpected<HistoryError> error(long line, std::size_t offset, std::string message) const {
    return tl::unexpected(HistoryError{HistoryError::Kind::kInput, name, line,
                                       static_cast<int>(offset) + 1, std::move(message)});
  }

  /// Makes at least one complete line available at `begin`, unless the file has ended: then
  /// begin == lines_end. The last line gets the line end it may lack.
  tl::expected<void, HistoryError> fill() {
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

  /// The line at `begin`, which must be there, without its end; `begin` moves behind it.
  std::string_view take_line() {
    const char* const start = buffer.data() + begin;
    const auto* const stop = static_cast<const char*>(std::memchr(start, '\n', lines_end - begin));
    std::string_view line(start, static_cast<std::size_t>(stop - start));
    begin += line.size() + 1;
    ++next_line;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  tl::expected<void, HistoryError> read_header();
  tl::expected<void, HistoryError> choose(std::span<const std::string> columns);
  const char* parse_row(const char* p, const char* stop, std::span<double> values,
                        std::span<std::string_view> texts) const;
  tl::unexpected<HistoryError> diagnose(std::string_view line, long number) const;
};

tl::expected<void, HistoryError> CsvReader::File::read_header() {
  for (bool first = true;; first = false) {
    if (auto filled = fill(); !filled) return filled;
    if (begin == lines_end) {
      return error(next_line > 1 ? next_line - 1 : 1, 0,
                   next_line == 1 ? "the file is empty; a header row and rows of numbers are wanted"
                                  : "there is no header row with the columns' names");
    }
    std::string_view line = take_line();
    if (first && (line.starts_with("\xff\xfe") || line.starts_with("\xfe\xff"))) {
      return error(1, 0, "the file is UTF-16; UTF-8 is wanted");
    }
    if (first && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
    const std::size_t text = line.find_first_not_of(" \t");
    if (text == std::string_view::npos || line[text] == '#') continue;

    header_line = row_line = next_line - 1;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '\r') {
        return error(header_line, i, "lines end with CR only; LF or CRLF is wanted");
      }
      if (static_cast<unsigned char>(line[i]) < 0x20 && line[i] != '\t') {
        return error(header_line, i, "a control character: not a text file");
      }
    }
    separator = detect_separator(line);
    const std::vector<Field> fields = split(line, separator);
    if (fields.size() > 1 && fields.back().text.empty()) {
      return error(header_line, line.size() - 1,
                   fmt::format("the header ends with a separator ({})", separator_name(separator)));
    }
    if (std::all_of(fields.begin(), fields.end(),
                    [](const Field& field) { return is_number(field.text); })) {
      return error(header_line, 0,
                   "numbers where the header row with the columns' names is wanted");
    }
    for (const Field& field : fields) header.emplace_back(field.text);
    rows_offset = buffer_offset + static_cast<off_t>(begin);
    return {};
  }
}

tl::expected<void, HistoryError> CsvReader::File::choose(std::span<const std::string> columns) {
  slots.assign(header.size(), kSkip);
  selected = columns.size();
  for (std::size_t slot = 0; slot < columns.size(); ++slot) {
    const auto found = std::find(header.begin(), header.end(), columns[slot]);
    if (found == header.end()) {
      constexpr std::size_t kListed = 20;
      const std::span<const std::string> listed =
          std::span<const std::string>(header).first(std::min(header.size(), kListed));
      std::string message =
          fmt::format("no column '{}'; the columns are {}{}", columns[slot],
                      fmt::join(listed, ", "), header.size() > kListed ? ", ..." : "");
      const std::vector<std::string_view> names(header.begin(), header.end());
      if (const auto nearest = nearest_name(columns[slot], names)) {
        message += fmt::format("; did you mean '{}'?", *nearest);
      }
      return error(header_line, 0, std::move(message));
    }
    if (std::find(found + 1, header.end(), columns[slot]) != header.end()) {
      return error(header_line, 0, fmt::format("two columns are named '{}'", columns[slot]));
    }
    int& target = slots[static_cast<std::size_t>(found - header.begin())];
    if (target == kSkip) {
      target = static_cast<int>(slot);
    } else {
      copies.emplace_back(static_cast<std::size_t>(target), slot);
    }
  }
  return {};
}

/// Reads the row at `p`, whose line ends before `stop`; returns where its line end is. Null for
/// whatever is not plain: `diagnose` then says what it is. `texts` may be empty.
const char* CsvReader::File::parse_row(const char* p, const char* stop, std::span<double> values,
                                       std::span<std::string_view> texts) const {
  const std::size_t columns = slots.size();
  for (std::size_t column = 0;; ++column, ++p) {
    while (*p == ' ' || (*p == '\t' && separator != '\t')) ++p;
    const bool quoted = *p == '"';
    if (quoted) ++p;
    const int slot = slots[column];
    if (slot != kSkip) {
      const char* const number = p;
      p = read_number(p, stop, values[static_cast<std::size_t>(slot)]);
      if (p == nullptr) return nullptr;
      if (!texts.empty()) {
        texts[static_cast<std::size_t>(slot)] = {number, static_cast<std::size_t>(p - number)};
      }
      if (quoted && *p++ != '"') return nullptr;
    } else {
      for (bool inside = quoted; *p != '\n' && (inside || *p != separator); ++p) {
        inside ^= quoted && *p == '"';
      }
    }
    while (*p == ' ' || *p == '\r' || (*p == '\t' && separator != '\t')) ++p;
    if (column + 1 == columns) return *p == '\n' ? p : nullptr;
    if (*p != separator) return nullptr;
  }
}

tl::unexpected<HistoryError> CsvReader::File::diagnose(std::string_view line, long number) const {
  const std::vector<Field> fields = split(line, separator);
  const std::size_t columns = header.size();
  if (fields.size() == columns + 1 && fields.back().text.empty()) {
    return error(number, line.size() - 1,
                 fmt::format("the row ends with a separator ({})", separator_name(separator)));
  }
  if (fields.size() != columns) {
    const bool decimal_commas = separator == ',' && fields.size() > columns &&
                                std::all_of(fields.begin(), fields.end(), [](const Field& field) {
                                  return is_number(field.text);
                                });
    return error(number, 0,
                 fmt::format("{} field{} where the header has {} column{}{}", fields.size(),
                             fields.size() == 1 ? "" : "s", columns, columns == 1 ? "" : "s",
                             decimal_commas ? " (decimal commas? the decimal mark is '.')" : ""));
  }
  for (std::size_t i = 0; i < columns; ++i) {
    if (slots[i] == kSkip || is_number(fields[i].text)) continue;
    const bool second_header = number == header_line + 1 && !fields[i].text.empty();
    return error(number, fields[i].offset,
                 fmt::format("column '{}' {}{}", header[i], not_a_number(fields[i].text),
                             second_header ? " (one header row is read, numbers follow it)" : ""));
  }
  return error(number, 0, "the row cannot be read (an odd quote?)");
}

CsvReader::CsvReader(std::unique_ptr<File> file) : file_(std::move(file)) {}
CsvReader::CsvReader(CsvReader&&) noexcept = default;
CsvReader& CsvReader::operator=(CsvReader&&) noexcept = default;
CsvReader::~CsvReader() = default;

tl::expected<CsvReader, HistoryError> CsvReader::open(const std::filesystem::path& file,
                                                      std::span<const std::string> columns,
                                                      std::string shown_name) {
  auto opened = std::make_unique<File>();
  opened->name = shown_name.empty() ? file.string() : std::move(shown_name);
  // Without O_NONBLOCK, opening a FIFO waits for a writer.
  opened->descriptor = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (opened->descriptor < 0) {
    return environment_error(opened->name,
                             fmt::format("cannot be opened: {}", system_message(errno)));
  }
  struct stat status {};
  if (::fstat(opened->descriptor, &status) != 0) {
    return environment_error(opened->name,
                             fmt::format("cannot be examined: {}", system_message(errno)));
  }
  if (!S_ISREG(status.st_mode)) {
    return environment_error(opened->name,
                             S_ISDIR(status.st_mode) ? "is a directory" : "is not a regular file");
  }
  opened->buffer.resize(kBlock);
  if (auto read = opened->read_header(); !read) return tl::unexpected(std::move(read.error()));
  if (auto chosen = opened->choose(columns); !chosen) {
    return tl::unexpected(std::move(chosen.error()));
  }
  return CsvReader(std::move(opened));
}

tl::expected<bool, HistoryError> CsvReader::next(std::span<double> values) {
  return next(values, {});
}

tl::expected<bool, HistoryError> CsvReader::next(std::span<double> values,
                                                 std::span<std::string_view> texts) {
  File& file = *file_;
  assert(values.size() == file.selected && (texts.empty() || texts.size() == file.selected));
  for (;;) {
    if (file.begin == file.lines_end) {
      if (auto filled = file.fill(); !filled) return tl::unexpected(std::move(filled.error()));
      if (file.begin == file.lines_end) {
        if (file.rows == 0) return file.error(file.header_line, 0, "no rows follow the header");
        return false;
      }
    }
    const char* const start = file.buffer.data() + file.begin;
    const char* const stop = file.buffer.data() + file.lines_end;
    const char* p = start;
    while (*p == ' ' || *p == '\t') ++p;
    if (*p == '#') {
      file.take_line();
      continue;
    }
    if (*p == '\n' || (*p == '\r' && p[1] == '\n')) {
      if (file.blank_line == 0) file.blank_line = file.next_line;
      file.take_line();
      continue;
    }
    if (file.blank_line != 0) {
      return file.error(file.blank_line, 0, "a blank line before the last row");
    }
    const char* const line_end = file.parse_row(start, stop, values, texts);
    if (line_end == nullptr) {
      const auto* const newline = static_cast<const char*>(
          std::memchr(start, '\n', static_cast<std::size_t>(stop - start)));
      std::string_view line(start, static_cast<std::size_t>(newline - start));
      if (line.ends_with('\r')) line.remove_suffix(1);
      return file.diagnose(line, file.next_line);
    }
    file.begin += static_cast<std::size_t>(line_end - start) + 1;
    file.row_line = file.next_line++;
    ++file.rows;
    for (const auto& [from, to] : file.copies) {
      values[to] = values[from];
      if (!texts.empty()) texts[to] = texts[from];
    }
    return true;
  }
}

tl::expected<void, HistoryError> CsvReader::rewind() {
  File& file = *file_;
  if (::lseek(file.descriptor, file.rows_offset, SEEK_SET) != file.rows_offset) {
    return environment_error(file.name,
                             fmt::format("cannot be read again: {}", system_message(errno)));
  }
  file.buffer_offset = file.rows_offset;
  file.begin = file.lines_end = file.end = 0;
  file.at_end = false;
  file.next_line = file.header_line + 1;
  file.row_line = file.header_line;
  file.blank_line = 0;
  file.rows = 0;
  return {};
}

long CsvReader::line() const { return file_->row_line; }

std::span<const std::string> CsvReader::header() const { return file_->header; }

const std::string& CsvReader::name() const { return file_->name; }

tl::unexpected<HistoryError> CsvReader::error_here(std::string message) const {
  return file_->error(file_->row_line, 0, std::move(message));
}

}  // namespace slipbench::driver
