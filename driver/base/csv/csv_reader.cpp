// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/csv_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include "driver/base/csv/comment_lines.hpp"
#include "driver/base/csv/csv_fields.hpp"
#include "driver/base/csv/csv_guess.hpp"
#include "driver/base/csv/csv_words.hpp"
#include "driver/base/csv/line_reader.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/units/units.hpp"

namespace slipbench::driver::base {
namespace {

constexpr int kUnwanted = -1;

}  // namespace

struct CsvReader::File {
  LineReader lines;
  long row_line = 0;
  long blank_line = 0;  ///< The first of the blank lines since the last row; 0 when none.
  long blank_lines = 0;
  long rows = 0;

  CsvFormat format;
  bool states_format = true;  ///< Whether what names the file can state another format.
  MissingSamples missing;
  std::vector<double> held;  ///< The numbers of the last row, where missing ones are held.
  std::vector<std::string> header;
  std::vector<std::string> units;  ///< Of the columns, where there is a row of units.
  std::map<std::string, std::string, std::less<>> stated;  ///< Units of columns, before the header.
  long header_line = 0;
  long rows_line = 0;
  off_t rows_offset = 0;
  char separator = ',';
  char decimal = '.';
  std::vector<int> slots;    ///< For each column of the file, where its number goes, or kUnwanted.
  std::size_t selected = 0;  ///< How many numbers a row yields.
  std::vector<std::pair<std::size_t, std::size_t>> copies;  ///< Slots of a column asked for twice.

  tl::unexpected<HistoryError> error(long line, std::size_t offset, std::string message) const {
    return lines.error(line, offset, std::move(message));
  }

  /// The line of text at `begin` with its offset, or nothing at the end of the file; blank lines
  /// and comments are passed over.
  tl::expected<std::optional<std::string_view>, HistoryError> next_text();

  /// "; write {file: rig.csv, skip: 4}": the format in which the file's start can be read, if
  /// another one than this is. All advice is empty where a format cannot be stated.
  std::string remedy(std::span<const std::string> wanted) const;
  std::string skipping(std::string_view holding = "") const;
  bool rows_end_alike() const;
  std::string written_as(const CsvFormat& other) const {
    return states_format ? "; write " + in_words(lines.name, other) : "";
  }

  static tl::expected<CsvReader, HistoryError> open(const DataSource& source,
                                                    std::span<const std::string> columns,
                                                    bool states_format);
  tl::expected<void, HistoryError> read_header(std::span<const std::string> columns);
  tl::expected<void, HistoryError> read_units(std::span<const std::string> columns);
  tl::expected<void, HistoryError> choose(std::span<const std::string> columns);
  const char* parse_row(const char* p, const char* stop, std::span<double> values,
                        std::span<std::string_view> texts) const;
  tl::expected<bool, HistoryError> mend(std::string_view line, std::span<double> values,
                                        std::span<std::string_view> texts);
  tl::unexpected<HistoryError> diagnose(std::string_view line, long number) const;
  tl::unexpected<HistoryError> diagnose_field(std::size_t column, std::span<const Field> fields,
                                              long number,
                                              std::span<const std::string> wanted) const;
  std::string other_mark(std::span<const Field> fields) const;
  std::vector<std::string> wanted() const;
};

std::string CsvReader::File::remedy(std::span<const std::string> wanted) const {
  const auto guess = guess_format(lines.head(), format, wanted);
  return guess ? written_as(*guess) : "";
}

/// Tells whether the rows in the file's start end with a separator.
bool CsvReader::File::rows_end_alike() const {
  std::istringstream head(lines.head());
  std::string row;
  for (long line = 0; std::getline(head, row); ++line) {
    while (!row.empty() && (row.back() == '\r' || row.back() == ' ')) row.pop_back();
    const bool cut_off = head.eof();
    if (line >= header_line && !row.empty() && !cut_off && row.back() != separator) return false;
  }
  return true;
}

std::string CsvReader::File::skipping(std::string_view holding) const {
  if (!states_format) return {};
  CsvFormat other = format;
  other.missing = MissingSample::kSkip;
  return written_as(other) + " to leave such rows out" + std::string(holding);
}

tl::expected<std::optional<std::string_view>, HistoryError> CsvReader::File::next_text() {
  for (;;) {
    if (auto filled = lines.fill(); !filled) return tl::unexpected(std::move(filled.error()));
    if (lines.begin == lines.lines_end) return std::nullopt;
    const bool first = lines.next_line == 1;
    std::string_view line = lines.take_line();
    if (first && (line.starts_with("\xff\xfe") || line.starts_with("\xfe\xff"))) {
      return error(1, 0,
                   "the file is UTF-16; UTF-8 is wanted: iconv -f UTF-16 -t UTF-8 '" + lines.name +
                       "' > utf8.csv");
    }
    if (first && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
    if (lines.next_line <= format.skip + 1) continue;
    const std::size_t text = line.find_first_not_of(" \t");
    if (text != std::string_view::npos && line[text] != '#') return line;
    if (header.empty() && line.starts_with(kColumnsMark)) {
      for (auto& [name, unit] : column_units(line))
        stated.emplace(std::move(name), std::move(unit));
    }
  }
}

tl::expected<void, HistoryError> CsvReader::File::read_header(
    std::span<const std::string> columns) {
  const auto text = next_text();
  if (!text) return tl::unexpected(text.error());
  const long last_line = std::max(lines.next_line - 1, 1L);
  if (!*text) {
    if (lines.next_line == 1) {
      return error(1, 0, "the file is empty; a header row and rows of numbers are wanted");
    }
    if (format.skip > 0) {
      return error(last_line, 0,
                   fmt::format("there is no header row: the file has {} line{}, and 'skip' passes "
                               "over {}{}",
                               last_line, last_line == 1 ? "" : "s", format.skip, remedy(columns)));
    }
    return error(last_line, 0, "there is no header row with the columns' names");
  }
  const std::string_view line = **text;
  header_line = row_line = last_line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\r') {
      return error(header_line, i,
                   "lines end with CR only; LF or CRLF is wanted: tr '\\r' '\\n' < '" + lines.name +
                       "' > lf.csv");
    }
    if (static_cast<unsigned char>(line[i]) < 0x20 && line[i] != '\t') {
      return error(header_line, i, "a control character: not a text file");
    }
  }
  decimal = format.decimal;
  separator = format.separator == '\0' ? detect_separator(line, decimal) : format.separator;
  // Counted before the names are made: a check that names such a file asks for them again.
  if (static_cast<std::size_t>(std::count(line.begin(), line.end(), separator)) < kMostColumns ||
      separator == ' ') {
    header = header_names(line, separator);
  }
  if (header.empty() || header.size() > kMostColumns) {
    return error(header_line, 0, fmt::format("the file has more than {} columns", kMostColumns));
  }
  if (header.size() > 1 && header.back().empty()) {
    return error(header_line, line.size() - 1,
                 fmt::format("the header ends with a separator ({}){}", separator_name(separator),
                             rows_end_alike() ? ", as the rows do" + take_away(separator)
                                              : ": its last column has no name"));
  }
  if (std::all_of(header.begin(), header.end(),
                  [&](const std::string& one) { return number_in(one, decimal).has_value(); })) {
    return error(
        header_line, 0,
        "numbers where the header row with the columns' names is wanted" + remedy(columns));
  }
  if (format.units_row) {
    if (auto read = read_units(columns); !read) return read;
  }
  rows_offset = lines.offset();
  rows_line = lines.next_line;
  return {};
}

tl::expected<void, HistoryError> CsvReader::File::read_units(std::span<const std::string> columns) {
  const auto text = next_text();
  if (!text) return tl::unexpected(text.error());
  if (!*text) return error(header_line, 0, "no row of units follows the header");
  const std::vector<Field> fields = split(**text, separator);
  const long line = lines.next_line - 1;
  const bool numbers = std::any_of(fields.begin(), fields.end(), [&](const Field& field) {
    return number_in(field.text, decimal).has_value();
  });
  if (numbers || fields.size() != header.size()) {
    return error(line, 0,
                 (numbers ? std::string("numbers where 'units_row' says the units of the columns "
                                        "stand")
                          : fmt::format("{} field{} in the row of units where the header has {} "
                                        "column{}",
                                        fields.size(), fields.size() == 1 ? "" : "s", header.size(),
                                        header.size() == 1 ? "" : "s")) +
                     remedy(columns));
  }
  for (const Field& field : fields) {
    std::string& unit = units.emplace_back(as_utf8(field.text));
    const bool in_brackets = unit.size() > 1 && ((unit.front() == '[' && unit.back() == ']') ||
                                                 (unit.front() == '(' && unit.back() == ')'));
    if (in_brackets) unit = unit.substr(1, unit.size() - 2);
  }
  return {};
}

tl::expected<void, HistoryError> CsvReader::File::choose(std::span<const std::string> columns) {
  slots.assign(header.size(), kUnwanted);
  selected = columns.size();
  held.assign(selected, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t slot = 0; slot < columns.size(); ++slot) {
    const auto found = match_column(header, columns[slot]);
    if (!found) return error(header_line, 0, found.error());
    if (!*found) {
      constexpr std::size_t kListed = 20;
      const std::span<const std::string> listed =
          std::span<const std::string>(header).first(std::min(header.size(), kListed));
      std::string message =
          fmt::format("no column '{}'; the columns are {}{}", columns[slot],
                      fmt::join(listed, ", "), header.size() > kListed ? ", ..." : "");
      const std::vector<std::string_view> names(header.begin(), header.end());
      const std::string other_format = remedy(columns);
      if (!other_format.empty()) {
        message += other_format;
      } else if (const auto nearest = nearest_name(columns[slot], names)) {
        message += fmt::format("; did you mean '{}'?", *nearest);
      }
      return error(header_line, 0, std::move(message));
    }
    int& target = slots[**found];
    if (target == kUnwanted) {
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
  const bool by_blanks = separator == ' ';
  for (std::size_t column = 0;; ++column) {
    while (*p == ' ' || (*p == '\t' && separator != '\t')) ++p;
    const bool quoted = *p == '"';
    if (quoted) ++p;
    const int slot = slots[column];
    if (slot != kUnwanted) {
      const char* const number = p;
      p = read_number(p, stop, decimal, values[static_cast<std::size_t>(slot)]);
      if (p == nullptr) return nullptr;
      if (!texts.empty()) {
        texts[static_cast<std::size_t>(slot)] = {number, static_cast<std::size_t>(p - number)};
      }
      if (quoted && *p++ != '"') return nullptr;
    } else {
      for (bool inside = quoted; *p != '\n' && (inside || *p != separator); ++p) {
        if (by_blanks && !inside && *p == '\t') break;
        inside ^= quoted && *p == '"';
      }
    }
    const char* const field_end = p;
    while (*p == ' ' || *p == '\r' || (*p == '\t' && separator != '\t')) ++p;
    if (column + 1 == columns) return *p == '\n' ? p : nullptr;
    if (by_blanks) {
      if (p == field_end || *p == '\n') return nullptr;
    } else if (*p++ != separator) {
      return nullptr;
    }
  }
}

/// Reads a row in which samples may be missing; false if it is left out for that.
tl::expected<bool, HistoryError> CsvReader::File::mend(std::string_view line,
                                                       std::span<double> values,
                                                       std::span<std::string_view> texts) {
  const std::vector<Field> fields = split(line, separator);
  if (fields.size() != header.size()) return diagnose(line, lines.next_line);
  long holes = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (slots[i] == kUnwanted) continue;
    const auto slot = static_cast<std::size_t>(slots[i]);
    const auto number = number_in(fields[i].text, decimal);
    if (!number && !is_missing(fields[i].text)) {
      return diagnose_field(i, fields, lines.next_line, {});
    }
    if (!number && format.missing == MissingSample::kHold && rows == 0) {
      return error(lines.next_line, fields[i].offset,
                   fmt::format("column '{}' has no value before the first row to hold{}", header[i],
                               skipping()));
    }
    holes += number ? 0 : 1;
    values[slot] = number.value_or(held[slot]);
    if (!texts.empty()) texts[slot] = number ? fields[i].text : std::string_view();
  }
  if (holes == 0) return diagnose(line, lines.next_line);
  const bool holds = format.missing == MissingSample::kHold;
  missing.add(holds ? holes : 1, lines.next_line);
  return holds;
}

/// The columns that are read, by the names they have in the file.
std::vector<std::string> CsvReader::File::wanted() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (slots[i] != kUnwanted) names.push_back(header[i]);
  }
  return names;
}

tl::unexpected<HistoryError> CsvReader::File::diagnose(std::string_view line, long number) const {
  const std::vector<Field> fields = split(line, separator);
  const std::size_t columns = header.size();
  const std::vector<std::string> names = rows == 0 ? wanted() : std::vector<std::string>();
  if (fields.size() == columns + 1 && fields.back().text.empty()) {
    return error(number, line.size() - 1,
                 fmt::format("the row ends with a separator ({}){}", separator_name(separator),
                             take_away(separator)));
  }
  if (fields.size() != columns) {
    const bool decimal_commas = separator == ',' && fields.size() > columns &&
                                std::all_of(fields.begin(), fields.end(), [](const Field& field) {
                                  return number_in(field.text, '.').has_value() &&
                                         field.text.find('.') == std::string_view::npos;
                                });
    if (fields.size() < columns && fields.back().text.starts_with('"')) {
      return error(number, fields.back().offset, "the quote \" is not closed in its line");
    }
    return error(
        number, 0,
        fmt::format("{} field{} where the header has {} column{}{}", fields.size(),
                    fields.size() == 1 ? "" : "s", columns, columns == 1 ? "" : "s",
                    decimal_commas ? " (decimal commas between commas: nothing tells them apart; "
                                     "write the file anew with ';' between its columns)"
                                   : (rows == 0 ? remedy(names) : "")));
  }
  for (std::size_t i = 0; i < columns; ++i) {
    if (slots[i] == kUnwanted || number_in(fields[i].text, decimal)) continue;
    return diagnose_field(i, fields, number, names);
  }
  return error(number, 0, "the row cannot be read (an odd quote?)");
}

/// "; write {file: rig.csv, decimal: ","}" if the whole row can be read so.
std::string CsvReader::File::other_mark(std::span<const Field> fields) const {
  CsvFormat other = format;
  other.decimal = decimal == '.' ? ',' : '.';
  if (separator == other.decimal) return {};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (slots[i] != kUnwanted && !number_in(fields[i].text, other.decimal)) return {};
  }
  return written_as(other);
}

tl::unexpected<HistoryError> CsvReader::File::diagnose_field(
    std::size_t column, std::span<const Field> fields, long number,
    std::span<const std::string> wanted) const {
  const Field& field = fields[column];
  std::string message =
      fmt::format("column '{}' {}", header[column], not_a_number(field.text, decimal));
  if (is_missing(field.text)) {
    return error(number, field.offset, message + skipping(", or 'hold' for the value before"));
  }
  std::string better = rows == 0 ? remedy(wanted) : "";
  if (better.empty()) better = other_mark(fields);
  const char mark = decimal == '.' ? ',' : '.';
  if (may_be_thousands(field.text, mark)) {
    better += fmt::format("{} a '{}' between thousands is left out", better.empty() ? ";" : ", but",
                          mark);
  }
  const bool second_header =
      better.empty() && number == rows_line && !field.text.empty() && !number_in(field.text, mark);
  if (second_header) better = " (one header row is read, numbers follow it)";
  return error(number, field.offset, message + better);
}

CsvReader::CsvReader(std::unique_ptr<File> file) : file_(std::move(file)) {}
CsvReader::CsvReader(CsvReader&&) noexcept = default;
CsvReader& CsvReader::operator=(CsvReader&&) noexcept = default;
CsvReader::~CsvReader() = default;

tl::expected<CsvReader, HistoryError> CsvReader::open(const std::filesystem::path& file,
                                                      std::span<const std::string> columns,
                                                      std::string shown_name) {
  return File::open(DataSource{file, std::move(shown_name), {}}, columns, false);
}

tl::expected<CsvReader, HistoryError> CsvReader::open(const DataSource& source,
                                                      std::span<const std::string> columns) {
  return File::open(source, columns, true);
}

tl::expected<CsvReader, HistoryError> CsvReader::File::open(const DataSource& source,
                                                            std::span<const std::string> columns,
                                                            bool states_format) {
  auto opened = std::make_unique<File>();
  opened->lines.name = source.shown_name.empty() ? source.file.string() : source.shown_name;
  opened->format = source.format;
  opened->states_format = states_format;
  if (auto found = opened->lines.open(source.file); !found) {
    return tl::unexpected(std::move(found.error()));
  }
  if (auto read = opened->read_header(columns); !read)
    return tl::unexpected(std::move(read.error()));
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
  LineReader& lines = file.lines;
  assert(values.size() == file.selected && (texts.empty() || texts.size() == file.selected));
  for (;;) {
    if (lines.begin == lines.lines_end) {
      if (auto filled = lines.fill(); !filled) return tl::unexpected(std::move(filled.error()));
      if (lines.begin == lines.lines_end) {
        if (file.rows > 0) return false;
        return file.error(file.header_line, 0,
                          file.missing.count == 0 ? "no rows follow the header"
                                                  : "every row lacks a sample, so none is left");
      }
    }
    const char* const start = lines.buffer.data() + lines.begin;
    const char* const stop = lines.buffer.data() + lines.lines_end;
    const char* p = start;
    while (*p == ' ' || *p == '\t') ++p;
    if (*p == '#') {
      lines.take_line();
      continue;
    }
    if (*p == '\n' || (*p == '\r' && p[1] == '\n')) {
      if (file.blank_lines++ == 0) file.blank_line = lines.next_line;
      lines.take_line();
      continue;
    }
    if (file.blank_line != 0) {
      if (file.format.missing != MissingSample::kSkip) {
        return file.error(file.blank_line, 0, "a blank line before the last row" + file.skipping());
      }
      file.missing.add(file.blank_lines, file.blank_line);
      file.blank_line = file.blank_lines = 0;
    }
    const char* line_end = file.parse_row(start, stop, values, texts);
    if (line_end == nullptr) {
      line_end = static_cast<const char*>(
          std::memchr(start, '\n', static_cast<std::size_t>(stop - start)));
      std::string_view line(start, static_cast<std::size_t>(line_end - start));
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (file.format.missing == MissingSample::kError) return file.diagnose(line, lines.next_line);
      auto whole = file.mend(line, values, texts);
      if (!whole) return whole;
      if (!*whole) {
        lines.take_line();
        continue;
      }
    }
    if (file.format.missing == MissingSample::kHold) {
      std::copy(values.begin(), values.end(), file.held.begin());
    }
    lines.begin += static_cast<std::size_t>(line_end - start) + 1;
    file.row_line = lines.next_line++;
    ++file.rows;
    for (const auto& [from, to] : file.copies) {
      values[to] = values[from];
      if (!texts.empty()) texts[to] = texts[from];
    }
    return true;
  }
}

void CsvReader::note_place(Place* place) const {
  const File& file = *file_;
  place->offset = file.lines.offset();
  place->next_line = file.lines.next_line;
  place->row_line = file.row_line;
  place->rows = file.rows;
  if (file.format.missing == MissingSample::kHold) place->held = file.held;
}

tl::expected<void, HistoryError> CsvReader::go_back(const Place& place) {
  File& file = *file_;
  file.row_line = place.row_line;
  file.blank_line = 0;
  file.blank_lines = 0;
  file.rows = place.rows;
  if (!place.held.empty()) file.held = place.held;
  return file.lines.go_back(place.offset, place.next_line);
}

tl::expected<void, HistoryError> CsvReader::rewind() {
  File& file = *file_;
  file.missing = {};
  return go_back({file.rows_offset, file.rows_line, file.header_line, 0});
}

long CsvReader::line() const { return file_->row_line; }

std::span<const std::string> CsvReader::header() const { return file_->header; }

std::optional<std::size_t> CsvReader::find(std::string_view column) const {
  return match_column(file_->header, column).value_or(std::nullopt);
}

std::string_view CsvReader::unit(std::string_view column) const {
  const auto found = find(column);
  if (!found) return {};
  if (!file_->units.empty() && !file_->units[*found].empty()) return file_->units[*found];
  const std::string_view unit = split_column_name(file_->header[*found]).unit;
  return is_unit_or_dash(unit) ? unit : unit_above(column);
}

std::string_view CsvReader::unit_above(std::string_view column) const {
  const auto found = find(column);
  if (!found) return {};
  const auto stated = file_->stated.find(file_->header[*found]);
  const bool known = stated != file_->stated.end() && is_unit_or_dash(stated->second);
  return known ? std::string_view(stated->second) : std::string_view();
}

std::string CsvReader::remedy(std::span<const std::string> columns) const {
  return file_->remedy(columns);
}

const MissingSamples& CsvReader::missing() const { return file_->missing; }

const std::string& CsvReader::name() const { return file_->lines.name; }

tl::unexpected<HistoryError> CsvReader::error_here(std::string message) const {
  return file_->error(file_->row_line, 0, std::move(message));
}

tl::expected<std::string, HistoryError> count_missing(const DataSource& source,
                                                      std::span<const std::string> columns) {
  if (source.format.missing == MissingSample::kError) return std::string();
  auto reader = CsvReader::open(source, columns);
  if (!reader) return tl::unexpected(std::move(reader.error()));
  std::vector<double> row(columns.size());
  long rows = 0;
  for (;; ++rows) {
    const auto more = reader->next(row);
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
  }
  const MissingSamples& missing = reader->missing();
  const bool holds = source.format.missing == MissingSample::kHold;
  const long there = holds ? rows * static_cast<long>(row.size()) - missing.count : rows;
  std::string text = in_words(missing, source.format.missing);
  if (missing.count > there) text += kMostIsMissing;
  return text;
}

}  // namespace slipbench::driver::base
