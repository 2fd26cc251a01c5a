// SPDX-License-Identifier: Apache-2.0
#include "driver/check/golden.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <system_error>
#include <utility>
#include <variant>

#include "driver/base/csv/comment_lines.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/base/text/number.hpp"
#include "driver/case/curve_file.hpp"
#include "driver/check/check_labels.hpp"
#include "driver/results/provenance.hpp"
#include "driver/results/summary.hpp"

namespace slipbench::driver::check {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlessed = "# blessed";
constexpr std::string_view kCase = "# case: ";

/// Adds a column unless it is there; error if its name stands for something else.
tl::expected<void, std::string> add(GoldenColumn column, GoldenCurve& curve) {
  for (const GoldenColumn& other : curve.columns) {
    if (other.name != column.name) continue;
    if (other.text == column.text && other.conversion == column.conversion) return {};
    return tl::unexpected(fmt::format(
        "{}: its column '{}' is '{}' for one check and '{}' for another; give them other columns",
        curve.shown_name, base::printable(column.name), other.text.empty() ? "time" : other.text,
        column.text.empty() ? "time" : column.text));
  }
  curve.columns.push_back(std::move(column));
  return {};
}

tl::expected<void, std::string> add_check(const cases::Case& problem, const cases::Check& check,
                                          GoldenCurve& curve) {
  const auto& reference = std::get<cases::CurveReference>(check.against);
  const std::vector<results::Column> columns = results::result_columns(problem);
  const CheckLabels labels = labels_of(problem, check);
  const auto make =
      [&](const cases::CurveColumn& column, std::string unit, const base::Expression* expression,
          std::span<const std::string> variables) -> tl::expected<GoldenColumn, std::string> {
    const bool own_unit = column.conversion == base::UnitConversion{};
    GoldenColumn result{.name = column.names.front(),
                        .unit = own_unit ? std::move(unit) : std::string(),
                        .conversion = column.conversion};
    if (expression == nullptr) return result;
    auto value = RowExpression::make(problem, columns, *expression, variables);
    if (!value) return tl::unexpected(std::move(value.error()));
    result.text = expression->text();
    result.value = std::move(*value);
    return result;
  };
  const cases::ExpressionReference* abscissa = check.abscissa ? &*check.abscissa : nullptr;
  auto first = make(reference.abscissa, labels.abscissa_unit,
                    abscissa == nullptr ? nullptr : &abscissa->expression,
                    abscissa == nullptr ? std::span<const std::string>() : abscissa->variables);
  if (!first) return tl::unexpected(std::move(first.error()));
  auto second = make(reference.column, labels.unit, &check.quantity, check.variables);
  if (!second) return tl::unexpected(std::move(second.error()));
  if (auto added = add(std::move(*first), curve); !added) return added;
  return add(std::move(*second), curve);
}

/// The case that a golden curve belongs to, as its header says.
std::string case_of(const GoldenHeader& header) {
  for (const std::string& line : header.origin) {
    if (line.starts_with(kCase)) return line.substr(kCase.size());
  }
  return {};
}

/// " 2026-01-31", or nothing.
std::string date_of_blessing() {
  const char* text = std::getenv("SOURCE_DATE_EPOCH");
  if (text == nullptr) return {};
  const auto seconds = base::parse_integer(text);
  constexpr long long kYear10000 = 253402300800;
  if (!seconds || *seconds < 0 || *seconds >= kYear10000) return {};
  return fmt::format(" {:%Y-%m-%d}", fmt::gmtime(static_cast<std::time_t>(*seconds)));
}

std::string in_one_line(std::string_view text) {
  std::string line(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::replace(line.begin(), line.end(), '\r', ' ');
  return base::printable(line);
}

}  // namespace

tl::expected<std::vector<GoldenCurve>, std::string> golden_curves(const cases::Case& problem) {
  std::vector<GoldenCurve> curves;
  std::string foreign;
  for (std::size_t i = 0; i < problem.checks.size(); ++i) {
    const cases::Check& check = problem.checks[i];
    const auto* reference = std::get_if<cases::CurveReference>(&check.against);
    if (reference == nullptr) continue;
    std::error_code ignored;
    const bool there = fs::exists(fs::symlink_status(reference->file, ignored));
    if (reference->shipped || (there && !cases::is_golden_curve(reference->file))) {
      if (foreign.empty()) foreign = reference->shown_name;
      continue;
    }
    auto curve = std::find_if(curves.begin(), curves.end(), [&](const GoldenCurve& known) {
      return known.file == reference->file;
    });
    if (curve == curves.end()) {
      const std::string owner = there ? case_of(read_golden_header(reference->file)) : "";
      if (!owner.empty() && owner != base::in_cells(base::printable(results::case_name(problem)))) {
        return tl::unexpected(
            fmt::format("{} is the golden curve of {}; give this case one of its own, or remove it",
                        reference->shown_name, owner));
      }
      GoldenCurve fresh{.file = reference->file, .shown_name = reference->shown_name};
      fresh.columns.push_back(
          {.name = std::string(cases::kGoldenTime), .unit = problem.units.time});
      curves.push_back(std::move(fresh));
      curve = curves.end() - 1;
    }
    if (auto added = add_check(problem, check, *curve); !added) {
      return tl::unexpected(std::move(added.error()));
    }
    curve->checks.push_back(i);
  }
  if (!curves.empty()) return curves;
  if (foreign.empty()) {
    return tl::unexpected(std::string(
        "no check is against a curve; name the golden one with 'against: {curve: FILE.csv}'"));
  }
  return tl::unexpected(fmt::format(
      "{} is no golden curve but somebody's reference: it is not overwritten", foreign));
}

GoldenHeader read_golden_header(const fs::path& file) {
  GoldenHeader header;
  for (std::string& line : base::comment_lines(file)) {
    if (line == cases::kGoldenMark) continue;
    (line.starts_with(kBlessed) ? header.blessings : header.origin).push_back(std::move(line));
  }
  return header;
}

bool has_golden_rows(const fs::path& file, std::string_view rows) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  while (stream.peek() == '#') std::getline(stream, line);
  std::array<char, std::size_t{1} << 16U> piece{};
  while (stream.read(piece.data(), piece.size()), stream.gcount() > 0) {
    const std::string_view text(piece.data(), static_cast<std::size_t>(stream.gcount()));
    if (!rows.starts_with(text)) return false;
    rows.remove_prefix(text.size());
  }
  return rows.empty();
}

GoldenHeader golden_header(const cases::Case& problem, const GoldenCurve& curve,
                           std::string_view reason, const GoldenHeader& before) {
  constexpr std::size_t kMostBlessings = 20;
  GoldenHeader header;
  const std::string lines = results::provenance_lines(problem);
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = lines.find('\n', begin);
    header.origin.push_back(lines.substr(begin, end - begin));
    begin = end + 1;
  }
  std::string columns;
  for (const GoldenColumn& column : curve.columns) {
    columns += fmt::format("{}{} [{}]", columns.empty() ? base::kColumnsMark : ", ",
                           in_one_line(column.name), column.unit);
  }
  header.origin.push_back(std::move(columns));
  header.origin.push_back(fmt::format("{}{}", cases::kGoldenRows, curve.rows));
  header.blessings.push_back(
      fmt::format("{}{}: {}", kBlessed, date_of_blessing(), in_one_line(reason)));
  for (const std::string& blessing : before.blessings) {
    if (header.blessings.size() == kMostBlessings) break;
    if (blessing != header.blessings.front()) header.blessings.push_back(blessing);
  }
  return header;
}

std::string to_text(const GoldenHeader& header) {
  std::string text(cases::kGoldenMark);
  text += '\n';
  for (const auto* lines : {&header.origin, &header.blessings}) {
    for (const std::string& line : *lines) text += base::in_cells(line) + "\n";
  }
  return text;
}

std::string names_row(const GoldenCurve& curve) {
  std::string names;
  for (const GoldenColumn& column : curve.columns) {
    // A separator in a name, as in an expression's, needs quotes.
    const bool quoted = column.name.find_first_of(",;\t") != std::string::npos;
    const std::string shown = base::in_cell(column.name);
    names += (names.empty() ? "" : ",") + (quoted ? '"' + shown + '"' : shown);
  }
  return names + "\n";
}

tl::expected<void, std::string> append_golden_row(GoldenCurve& curve, const bench::Row& row,
                                                  std::string& text) {
  for (GoldenColumn& column : curve.columns) {
    double number = row.time;
    if (column.value) {
      const auto value = (*column.value)(row);
      if (!value || !std::isfinite(*value)) {
        return tl::unexpected(fmt::format(
            "the column '{}' of {} has no value at t = {}{}", base::printable(column.name),
            curve.shown_name, base::rounded(row.time), value ? "" : ": " + value.error().message));
      }
      number = *value;
    }
    if (!(column.conversion == base::UnitConversion{})) {
      number = (number - column.conversion.offset) / column.conversion.scale;
    }
    base::append_number(text, number);
    text += ',';
  }
  text.back() = '\n';
  ++curve.rows;
  return {};
}

}  // namespace slipbench::driver::check
