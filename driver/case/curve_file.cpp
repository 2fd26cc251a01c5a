// SPDX-License-Identifier: Apache-2.0
#include "driver/case/curve_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "driver/base/csv/comment_lines.hpp"
#include "driver/base/csv/csv_reader.hpp"
#include "driver/base/csv/printed_digits.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/suggestions.hpp"

namespace slipbench::driver::cases {
namespace {

/// "golden/belt.csv:17:5: column 'fx' is empty".
std::string told(const base::HistoryError& error) {
  std::string place = error.file;
  if (error.line > 0) place += fmt::format(":{}", error.line);
  if (error.column > 0) place += fmt::format(":{}", error.column);
  return fmt::format("{}: {}", place, error.message);
}

bool has(std::span<const std::string> names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Returns how many rows a golden curve had when it was blessed, as it says, or nothing.
std::string blessed_rows(const std::filesystem::path& file) {
  for (std::string& line : base::comment_lines(file)) {
    if (!line.starts_with(kGoldenRows)) continue;
    line.erase(0, kGoldenRows.size());
    line.erase(line.find_last_not_of(" \t") + 1);
    return line;
  }
  return {};
}

}  // namespace

std::span<const std::string> golden_time_names() {
  static const std::vector<std::string> kNames{std::string(kGoldenTime)};
  return kNames;
}

void CurveFile::want(std::span<const std::string> names) {
  for (const std::string& name : names) {
    if (!has(wanted_, name)) wanted_.push_back(name);
  }
}

CurveFile::Contents CurveFile::read() const {
  Contents found;
  found.golden = is_golden_curve(source_.file);
  auto probe = base::CsvReader::open(source_, {});
  if (!probe) {
    found.fault = told(probe.error());
    return found;
  }
  found.header.assign(probe->header().begin(), probe->header().end());
  // A file of another format lacks all that is wanted of it; each try reads its first lines again.
  int tries = 20;
  for (const std::string& name : wanted_) {
    if (probe->find(name)) {
      found.names.push_back(name);
    } else if (found.remedy.empty() && tries-- > 0) {
      found.remedy = probe->remedy(std::span(&name, 1));
    }
  }
  const std::size_t count = found.names.size();
  if (count == 0) return found;
  auto reader = base::CsvReader::open(source_, found.names);
  if (!reader) {
    found.fault = told(reader.error());
    return found;
  }
  // The rows there may be, by the first of them.
  constexpr std::size_t kSample = 64;
  std::error_code unknown;
  std::uintmax_t size = std::filesystem::file_size(source_.file, unknown);
  if (unknown) size = 0;
  std::vector<std::vector<double>> columns(count);
  std::vector<base::PrintedDigits> digits(count);
  std::vector<double> row(count);
  std::vector<std::string_view> texts(count);
  std::size_t bytes = 0;
  while (true) {
    const auto more = reader->next(row, texts);
    if (!more) {
      found.fault = told(more.error());
      return found;
    }
    if (!*more) break;
    for (std::size_t i = 0; i < count; ++i) {
      columns[i].push_back(row[i] + 0.0);
      if (!digits[i].exact() && !texts[i].empty()) digits[i].add(texts[i]);
      bytes += texts[i].size() + 1;
    }
    if (columns.front().size() == kSample) {
      for (auto& column : columns) column.reserve(kSample * size / bytes);
    }
  }
  const std::size_t rows = columns.front().size();
  if (const std::string blessed = found.golden ? blessed_rows(source_.file) : "";
      !blessed.empty() && blessed != std::to_string(rows)) {
    found.fault = fmt::format(
        "{}: its rows are {} in number, and '{}' were blessed: it is cut off or edited; restore "
        "it, or bless the case again",
        source_.shown_name, rows, base::printable(blessed));
    return found;
  }
  for (std::size_t i = 0; i < count; ++i) {
    Column& column = found.columns.emplace_back();
    column.values = std::move(columns[i]);
    // A golden curve has every digit of its doubles, however few some of them need.
    if (!found.golden) column.resolution = digits[i].resolution();
  }
  return found;
}

const CurveFile::Contents& CurveFile::contents() const {
  std::call_once(once_, [this] { contents_ = read(); });
  return contents_;
}

tl::expected<const CurveFile::Column*, std::string> CurveFile::column(
    std::span<const std::string> names) const {
  const Contents& file = contents();
  if (!file.fault.empty()) return tl::unexpected(file.fault);
  for (const std::string& name : names) {
    const auto found = std::find(file.names.begin(), file.names.end(), name);
    if (found != file.names.end()) {
      return &file.columns[static_cast<std::size_t>(found - file.names.begin())];
    }
  }
  const std::vector<std::string_view> wanted(names.begin(), names.end());
  const std::vector<std::string_view> there(file.header.begin(), file.header.end());
  std::string quoted;
  for (const std::string_view name : wanted) {
    quoted += fmt::format("{}'{}'", quoted.empty() ? "" : " or ", base::printable(name));
  }
  for (const std::string_view name : wanted) {
    if (std::count(there.begin(), there.end(), name) < 2) continue;
    return tl::unexpected(
        fmt::format("{}: two columns are named '{}'", source_.shown_name, base::printable(name)));
  }
  std::string message =
      fmt::format("{}: no column {}; the columns are {}{}", source_.shown_name, quoted,
                  base::printable(base::few_in_words(there)), file.remedy);
  if (wanted.size() == 1 && file.remedy.empty()) {
    if (const auto nearest = base::nearest_name(wanted.front(), there)) {
      message += fmt::format("; did you mean '{}'?", base::printable(*nearest));
    }
  }
  return tl::unexpected(std::move(message));
}

tl::expected<void, base::HistoryError> openable_curve(const std::filesystem::path& file,
                                                      const std::string& shown_name) {
  const auto opened = base::CsvReader::open(file, {}, shown_name);
  if (opened || opened.error().kind == base::HistoryError::Kind::kInput) return {};
  return tl::unexpected(opened.error());
}

bool is_golden_curve(const std::filesystem::path& file) {
  const std::vector<std::string> lines = base::comment_lines(file);
  return std::find(lines.begin(), lines.end(), kGoldenMark) != lines.end();
}

}  // namespace slipbench::driver::cases
