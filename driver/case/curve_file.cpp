// SPDX-License-Identifier: Apache-2.0
#include "driver/case/curve_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "driver/base/csv/csv_reader.hpp"
#include "driver/base/csv/printed_digits.hpp"
#include "driver/base/text/diagnostic.hpp"

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

void CurveFile::read() const {
  golden_ = is_golden_curve(source_.file);
  auto probe = base::CsvReader::open(source_, {});
  if (!probe) {
    fault_ = told(probe.error());
    return;
  }
  header_.assign(probe->header().begin(), probe->header().end());
  for (const std::string& name : wanted_) {
    if (probe->find(name)) {
      names_.push_back(name);
    } else if (remedy_.empty()) {
      remedy_ = probe->remedy(std::span(&name, 1));
    }
  }
  if (names_.empty()) return;
  auto reader = base::CsvReader::open(source_, names_);
  if (!reader) {
    fault_ = told(reader.error());
    return;
  }
  columns_.resize(names_.size());
  std::vector<base::PrintedDigits> digits(names_.size());
  std::vector<double> row(names_.size());
  std::vector<std::string_view> texts(names_.size());
  while (true) {
    const auto more = reader->next(row, texts);
    if (!more) {
      fault_ = told(more.error());
      return;
    }
    if (!*more) break;
    for (std::size_t i = 0; i < row.size(); ++i) {
      columns_[i].values.push_back(row[i]);
      if (!digits[i].exact() && !texts[i].empty()) digits[i].add(texts[i]);
    }
  }
  // A golden curve has every digit of its doubles, however few some of them need.
  for (std::size_t i = 0; i < columns_.size() && !golden_; ++i) {
    columns_[i].resolution = digits[i].resolution();
  }
}

tl::expected<const CurveFile::Column*, std::string> CurveFile::column(
    std::span<const std::string> names) const {
  std::call_once(once_, [this] { read(); });
  if (!fault_.empty()) return tl::unexpected(fault_);
  for (const std::string& name : names) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found != names_.end()) return &columns_[static_cast<std::size_t>(found - names_.begin())];
  }
  const std::vector<std::string_view> wanted(names.begin(), names.end());
  const std::vector<std::string_view> there(header_.begin(), header_.end());
  std::string quoted;
  for (const std::string_view name : wanted) {
    quoted += fmt::format("{}'{}'", quoted.empty() ? "" : " or ", base::printable(name));
  }
  std::string message = fmt::format("{}: no column {}; the columns are {}{}", source_.shown_name,
                                    quoted, base::printable(base::in_words(there, "and")), remedy_);
  if (wanted.size() == 1 && remedy_.empty()) {
    if (const auto nearest = base::nearest_name(wanted.front(), there)) {
      message += fmt::format("; did you mean '{}'?", base::printable(*nearest));
    }
  }
  return tl::unexpected(std::move(message));
}

bool CurveFile::golden() const {
  std::call_once(once_, [this] { read(); });
  return golden_;
}

tl::expected<void, base::HistoryError> openable_curve(const std::filesystem::path& file,
                                                      const std::string& shown_name) {
  const auto opened = base::CsvReader::open(file, {}, shown_name);
  if (opened || opened.error().kind == base::HistoryError::Kind::kInput) return {};
  return tl::unexpected(opened.error());
}

bool is_golden_curve(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string start(kGoldenMark.size(), '\0');
  if (!stream.read(start.data(), static_cast<std::streamsize>(start.size()))) return false;
  if (start != kGoldenMark) return false;
  const int next = stream.get();
  return next == '\n' || next == '\r' || next == std::ifstream::traits_type::eof();
}

}  // namespace slipbench::driver::cases
