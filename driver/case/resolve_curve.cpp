// SPDX-License-Identifier: Apache-2.0
#include "driver/case/resolve_curve.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <variant>

#include "driver/case/key_index.hpp"
#include "driver/case/resolve_expression.hpp"
#include "driver/compare/curve_file.hpp"
#include "driver/compare/curve_library.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

bool is_time(std::string_view name) { return name == "time" || name == "t" || name == "T"; }

/// "step_time", "Time [s]", "t_ms", "T (s)": what a column of times is called.
bool sounds_like_time(const std::string& name) {
  std::string lower = name;
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (lower.find("time") != std::string::npos) return true;
  return lower.starts_with("t") &&
         (lower.size() == 1 || std::isalnum(static_cast<unsigned char>(lower[1])) == 0);
}

std::optional<Column> column_named(const Case& problem, std::string_view name) {
  const std::vector<Column> columns = result_columns(problem);
  return find_column(problem, columns, name);
}

AbscissaChoice over_time() { return {{}, "time", {"time", "t", "T"}, kTime}; }

AbscissaChoice over_column(const Column& column, std::string text) {
  std::vector<std::string> names{column.name};
  if (text != column.name) names.insert(names.begin(), text);
  return {plain_expression(column.name, {column.name}), std::move(text), std::move(names),
          column.dimension};
}

/// The accumulated slip of the definition that the quantity belongs to, or of the only one.
std::optional<Column> accumulated_slip(const Case& problem, std::string_view quantity) {
  const std::vector<Column> columns = result_columns(problem);
  int definition = problem.definitions.size() == 1 ? 0 : -1;
  if (const auto name = column_of_quantity(quantity, problem)) {
    const auto column = find_column(problem, columns, *name);
    if (column && column->definition >= 0) definition = column->definition;
  }
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const Column& column) {
    return column.source == ColumnSource::kAccumulatedSlip && column.definition == definition;
  });
  return found == columns.end() ? std::nullopt : std::optional(*found);
}

/// What a name means as an abscissa; nothing if it means nothing.
std::optional<AbscissaChoice> named_abscissa(const std::string& name, std::string_view quantity,
                                             const Case& problem) {
  if (is_time(name)) return over_time();
  if (name == "accumulated_slip") {
    const auto column = accumulated_slip(problem, quantity);
    return column ? std::optional(over_column(*column, name)) : std::nullopt;
  }
  if (const auto column = column_named(problem, name)) return over_column(*column, column->name);
  return std::nullopt;
}

std::optional<AbscissaChoice> own_abscissa(Binder& binder, const CheckText& text,
                                           const std::vector<std::string>& variables,
                                           const Case& problem) {
  const At<std::string>& at = text.abscissa;
  if (!at.sound) return std::nullopt;
  if (Binder::is_expression(*at.node)) {
    auto expression = compile_expression(binder, at, variables);
    if (!expression) return std::nullopt;
    if (expression->variables.empty()) {
      binder.error(*at.node, at.path, "is the same number in every row");
      return std::nullopt;
    }
    return AbscissaChoice{std::move(*expression), at.value, {}, {}};
  }
  if (auto known = named_abscissa(at.value, text.quantity.value, problem)) return known;
  if (binder.unknown_names_excused()) return std::nullopt;
  if (at.value == "accumulated_slip") {
    std::string hint;
    for (const Column& column : result_columns(problem)) {
      if (column.source != ColumnSource::kAccumulatedSlip) continue;
      hint += (hint.empty() ? "there are " : ", ") + column.name;
    }
    binder.error(*at.node, at.path,
                 problem.definitions.empty() ? "there is no friction that could slip"
                                             : "several definitions slip: name the column of one",
                 std::move(hint));
    return std::nullopt;
  }
  std::vector<std::string_view> names(variables.begin(), variables.end());
  names.push_back("time");
  names.push_back("accumulated_slip");
  const std::string origin = origin_of_column(at.value);
  binder.error(
      *at.node, at.path,
      "wanted time, accumulated_slip, a result column or an expression, found '" +
          printable(at.value) + "'",
      origin.empty() ? nearest_or(at.value, names, "an expression begins with '='") : origin);
  return std::nullopt;
}

std::optional<UnitConversion> conversion(Binder& binder, const At<MeasuredColumnText>& at,
                                         const std::optional<Dimension>& dimension,
                                         std::string_view what, const UnitSystem& system) {
  const At<std::string>& unit = at.value.unit;
  if (!unit.given()) return UnitConversion{};
  if (!unit.sound) return std::nullopt;
  if (!dimension) {
    if (binder.unknown_names_excused()) return std::nullopt;
    binder.error(*unit.node, unit.path,
                 "the unit of an expression is not known, so nothing can be converted to it",
                 "leave out 'unit', and convert in the expression of the " + std::string(what));
    return std::nullopt;
  }
  auto found = conversion_to_case(unit.value, *dimension, system);
  if (!found) {
    binder.history_error(*unit.node, unit.path, found.error());
    return std::nullopt;
  }
  return *found;
}

/// The file of `curve:`, a shipped curve or one of the case's folder.
std::optional<CurveReference> curve_file(Binder& binder, const At<std::string>& at,
                                         const Case& problem, bool may_be_missing) {
  CurveReference result;
  result.shown_name = at.value;
  if (is_curve_name(at.value)) {
    const auto shipped = find_shipped_curve(at.value);
    if (!shipped) {
      const std::vector<ShippedCurve> curves = shipped_curves();
      std::vector<std::string_view> names;
      for (const ShippedCurve& curve : curves) names.push_back(curve.name);
      binder.error(*at.node, at.path, "no curve '" + printable(at.value) + "' comes with slipbench",
                   nearest_or(at.value, names,
                              "'slipbench list curves' shows them; a file of your own has an "
                              "ending, as in '" +
                                  printable(at.value) + ".csv'"));
      return std::nullopt;
    }
    result.file = *shipped;
    result.shipped = true;
  } else {
    auto file = binder.data_file(*at.node, at.path, at.value);
    if (!file) return std::nullopt;
    result.file = std::move(*file);
  }
  for (const Check& check : problem.checks) {
    const auto* other = std::get_if<CurveReference>(&check.against);
    if (other == nullptr || other->file != result.file) continue;
    result.data = other->data;
    return result;
  }
  std::error_code ignored;
  const bool missing = !fs::exists(fs::symlink_status(result.file, ignored));
  if (!missing || !may_be_missing) {
    if (const auto opened = openable_curve(result.file, result.shown_name); !opened) {
      binder.history_error(*at.node, at.path, opened.error(),
                           missing ? "'slipbench bless' makes it of today's result, if it is to be "
                                     "a golden curve"
                                   : "");
      return std::nullopt;
    }
  }
  result.data = std::make_shared<CurveFile>(result.file, result.shown_name);
  return result;
}

}  // namespace

bool needs_position(Criterion criterion) {
  return criterion == Criterion::kLoopEnergy || criterion == Criterion::kBreakaway ||
         criterion == Criterion::kReversals || criterion == Criterion::kArcLength;
}

std::optional<std::string> column_of_quantity(std::string_view quantity, const Case& problem) {
  while (!quantity.empty() && (quantity.front() == '=' || quantity.front() == ' ')) {
    quantity.remove_prefix(1);
  }
  while (!quantity.empty() && quantity.back() == ' ') quantity.remove_suffix(1);
  const auto column = column_named(problem, quantity);
  return column ? std::optional(std::string(quantity)) : std::nullopt;
}

std::optional<AbscissaChoice> read_abscissa(Binder& binder, const CheckText& text,
                                            const std::vector<std::string>& variables,
                                            const Case& problem) {
  if (text.abscissa.given()) return own_abscissa(binder, text, variables, problem);
  const AgainstText& against = text.against.value;
  const At<std::string>& column = against.abscissa.value.column;
  if (!against.curve.given() || !against.abscissa.given()) return over_time();
  if (!against.abscissa.sound || !column.sound) return std::nullopt;
  if (auto known = named_abscissa(column.value, text.quantity.value, problem)) return known;
  const At<std::string>& unit = against.abscissa.value.unit;
  const bool has_unit_of_time =
      unit.sound && conversion_to_case(unit.value, kTime, problem.units).has_value();
  if (has_unit_of_time || sounds_like_time(column.value)) return over_time();
  if (binder.unknown_names_excused()) return std::nullopt;
  binder.error(*column.node, column.path,
               "it is not known what of the result belongs to '" + printable(column.value) + "'",
               "give the check its own 'abscissa': time, accumulated_slip, a result column or an "
               "expression");
  return std::nullopt;
}

std::optional<CurveReference> read_curve(Binder& binder, const CheckText& text,
                                         const AbscissaChoice& abscissa, const Case& problem,
                                         bool may_be_missing) {
  const AgainstText& against = text.against.value;
  if (!against.curve.sound || against.abscissa.faulty() || against.column.faulty()) {
    return std::nullopt;
  }
  auto result = curve_file(binder, against.curve, problem, may_be_missing);
  const auto over =
      conversion(binder, against.abscissa, abscissa.dimension, "abscissa", problem.units);
  const auto quantity = column_of_quantity(text.quantity.value, problem);
  std::optional<Dimension> dimension;
  if (quantity) dimension = column_named(problem, *quantity)->dimension;
  const auto compared = conversion(binder, against.column, dimension, "quantity", problem.units);
  if (!result || !over || !compared) return std::nullopt;

  result->abscissa.conversion = *over;
  result->column.conversion = *compared;
  if (against.abscissa.given()) {
    result->abscissa.names = {against.abscissa.value.column.value};
  } else if (!abscissa.columns.empty()) {
    result->abscissa.names = abscissa.columns;
  } else {
    binder.missing_key(*text.against.node, text.against.path, "abscissa",
                       "the curve's column that belongs to '" + printable(abscissa.text) + "'");
    return std::nullopt;
  }
  if (against.column.given()) {
    result->column.names = {against.column.value.column.value};
  } else if (quantity) {
    result->column.names = {*quantity};
  } else {
    if (!binder.unknown_names_excused() && text.quantity.sound) {
      binder.missing_key(
          *text.against.node, text.against.path, "column",
          "the curve's column that belongs to '" + printable(text.quantity.value) + "'");
    }
    return std::nullopt;
  }
  return result;
}

}  // namespace slipbench::driver
