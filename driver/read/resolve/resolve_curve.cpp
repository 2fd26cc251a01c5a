// SPDX-License-Identifier: Apache-2.0
#include "driver/read/resolve/resolve_curve.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <variant>

#include "driver/base/text/standard_input.hpp"
#include "driver/case/curve_file.hpp"
#include "driver/check/curves/curve_library.hpp"
#include "driver/read/keys/column_unit.hpp"
#include "driver/read/keys/key_index.hpp"
#include "driver/read/resolve/resolve_expression.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::read {
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

std::optional<results::Column> column_named(const cases::Case& problem, std::string_view name) {
  const std::vector<results::Column> columns = results::result_columns(problem);
  return results::find_column(problem, columns, name);
}

AbscissaChoice over_time() { return {{}, "time", {"time", "t", "T"}, base::kTime}; }

AbscissaChoice over_column(const results::Column& column, std::string text) {
  std::vector<std::string> names{column.name};
  if (text != column.name) names.insert(names.begin(), text);
  return {plain_expression(column.name, {column.name}), std::move(text), std::move(names),
          column.dimension};
}

/// The accumulated slip of the definition that the quantity belongs to, or of the only one.
std::optional<results::Column> accumulated_slip(const cases::Case& problem,
                                                std::string_view quantity) {
  const std::vector<results::Column> columns = results::result_columns(problem);
  int definition = problem.definitions.size() == 1 ? 0 : -1;
  if (const auto name = column_of_quantity(quantity, problem)) {
    const auto column = results::find_column(problem, columns, *name);
    if (column && column->definition >= 0) definition = column->definition;
  }
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const results::Column& column) {
        return results::is_accumulated_slip(column) && column.definition == definition;
      });
  return found == columns.end() ? std::nullopt : std::optional(*found);
}

/// Returns what a name means as an abscissa; nothing if it means nothing.
std::optional<AbscissaChoice> named_abscissa(const std::string& name, std::string_view quantity,
                                             const cases::Case& problem) {
  if (is_time(name)) return over_time();
  if (name == "accumulated_slip") {
    const auto column = accumulated_slip(problem, quantity);
    return column ? std::optional(over_column(*column, name)) : std::nullopt;
  }
  if (const auto column = column_named(problem, name)) return over_column(*column, column->name);
  return std::nullopt;
}

std::optional<AbscissaChoice> own_abscissa(yaml::Binder& binder, const CheckText& text,
                                           const std::vector<std::string>& variables,
                                           const cases::Case& problem) {
  const yaml::At<std::string>& at = text.abscissa;
  if (!at.sound) return std::nullopt;
  if (yaml::Binder::is_expression(*at.node)) {
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
    for (const results::Column& column : results::result_columns(problem)) {
      if (!results::is_accumulated_slip(column)) continue;
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
  binder.error(*at.node, at.path,
               "wanted time, accumulated_slip, a result column or an expression, found '" +
                   base::printable(at.value) + "'",
               origin.empty() ? binder.nearest_or(at.value, names, "an expression begins with '='")
                              : origin);
  return std::nullopt;
}

/// The change of unit of the first column in `names` that the file has.
/// \param file null if it cannot be read
std::optional<base::UnitConversion> conversion(
    yaml::Binder& binder, const yaml::At<MeasuredColumnText>& at, const base::CsvReader* file,
    std::span<const std::string> names, const yaml::At<DataSourceText>& source,
    const std::optional<base::Dimension>& dimension, std::string_view what,
    const base::UnitSystem& system) {
  const yaml::At<std::string>& unit = at.value.unit;
  if (!dimension && !unit.given()) return base::UnitConversion{};
  if (!dimension) {
    if (!unit.sound || binder.unknown_names_excused()) return std::nullopt;
    binder.error(*unit.node, unit.path,
                 "the unit of an expression is not known, so nothing can be converted to it",
                 "leave out 'unit', and convert in the expression of the " + std::string(what));
    return std::nullopt;
  }
  const auto found = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
    return file != nullptr && file->find(name);
  });
  const std::string column = found != names.end() ? *found : (names.empty() ? "" : names.front());
  const auto converted =
      column_unit(binder, file, column, at.given() ? *at.node : *source.node,
                  at.given() ? at.path : source.path, unit, std::span(&*dimension, 1), system);
  return converted ? std::optional(converted->conversion) : std::nullopt;
}

/// The file of `curve:`, a shipped curve or one of the case's folder.
std::optional<cases::CurveReference> curve_file(yaml::Binder& binder,
                                                const yaml::At<DataSourceText>& source,
                                                const cases::Case& problem, bool may_be_missing,
                                                OpenCurve& open) {
  const yaml::At<std::string>& at = source.value.file;
  if (!at.sound) return std::nullopt;
  cases::CurveReference result;
  result.format = format_of(source.value);
  result.shown_name = base::source_name(at.value);
  if (at.value != base::kStandardInput && check::is_curve_name(at.value)) {
    const auto shipped = check::find_shipped_curve(at.value);
    if (!shipped) {
      const std::vector<check::ShippedCurve> curves = check::shipped_curves();
      std::vector<std::string_view> names;
      names.reserve(curves.size());
      for (const check::ShippedCurve& curve : curves) names.push_back(curve.name);
      binder.error(
          *at.node, at.path, "no curve '" + base::printable(at.value) + "' comes with slipbench",
          binder.nearest_or(at.value, names,
                            "'slipbench list curves' shows them; a file of your own has an "
                            "ending, as in '" +
                                base::printable(at.value) + ".csv'"));
      return std::nullopt;
    }
    result.file = *shipped;
    result.shipped = true;
  } else {
    auto file = binder.data_file(*at.node, at.path, at.value);
    if (!file) return std::nullopt;
    result.file = std::move(*file);
  }
  for (const cases::Check& check : problem.checks) {
    const auto* other = std::get_if<cases::CurveReference>(&check.against);
    if (other == nullptr || other->file != result.file || other->format != result.format) continue;
    result.data = other->data;
    return result;
  }
  base::DataSource data{result.file, result.shown_name, result.format};
  // A file is kept once for each format and each spelling of its path, and two characters of it may
  // be a double: with this effort copies of it take no more than 150 MB and 1 s.
  constexpr std::uintmax_t kKept = 16;
  if (!open.files.insert(result.file.lexically_normal().string()).second &&
      !may_read(binder, data, *at.node, at.path, kKept)) {
    return std::nullopt;
  }
  std::error_code ignored;
  const bool missing = !fs::exists(fs::symlink_status(result.file, ignored));
  if (!missing || !may_be_missing) {
    if (const auto opened = cases::openable_curve(result.file, result.shown_name); !opened) {
      binder.history_error(*at.node, at.path, opened.error(),
                           missing ? "'slipbench bless' makes it of today's result, if it is to be "
                                     "a golden curve"
                                   : "");
      return std::nullopt;
    }
  }
  result.data = std::make_shared<cases::CurveFile>(std::move(data));
  return result;
}

}  // namespace

std::optional<std::string> column_of_quantity(std::string_view quantity,
                                              const cases::Case& problem) {
  while (!quantity.empty() && (quantity.front() == '=' || quantity.front() == ' ')) {
    quantity.remove_prefix(1);
  }
  while (!quantity.empty() && quantity.back() == ' ') quantity.remove_suffix(1);
  const auto column = column_named(problem, quantity);
  return column ? std::optional(std::string(quantity)) : std::nullopt;
}

std::optional<AbscissaChoice> read_abscissa(yaml::Binder& binder, const CheckText& text,
                                            const std::vector<std::string>& variables,
                                            const cases::Case& problem) {
  if (text.abscissa.given()) return own_abscissa(binder, text, variables, problem);
  const AgainstText& against = text.against.value;
  const yaml::At<std::string>& column = against.abscissa.value.column;
  if (!against.curve.given() || !against.abscissa.given()) return over_time();
  if (!against.abscissa.sound || !column.sound) return std::nullopt;
  if (auto known = named_abscissa(column.value, text.quantity.value, problem)) return known;
  const yaml::At<std::string>& unit = against.abscissa.value.unit;
  const bool has_unit_of_time =
      unit.sound && base::conversion_to_case(unit.value, base::kTime, problem.units).has_value();
  if (has_unit_of_time || sounds_like_time(column.value)) return over_time();
  if (binder.unknown_names_excused()) return std::nullopt;
  binder.error(
      *column.node, column.path,
      "it is not known what of the result belongs to '" + base::printable(column.value) + "'",
      "give the check its own 'abscissa': time, accumulated_slip, a result column or an "
      "expression");
  return std::nullopt;
}

std::optional<cases::CurveReference> read_curve(yaml::Binder& binder, const CheckText& text,
                                                const AbscissaChoice& abscissa,
                                                const cases::Case& problem, bool may_be_missing,
                                                OpenCurve& open) {
  const AgainstText& against = text.against.value;
  if (!against.curve.sound || against.abscissa.faulty() || against.column.faulty()) {
    return std::nullopt;
  }
  auto result = curve_file(binder, against.curve, problem, may_be_missing, open);
  const auto quantity = column_of_quantity(text.quantity.value, problem);
  std::optional<base::Dimension> dimension;
  if (quantity) dimension = column_named(problem, *quantity)->dimension;

  std::vector<std::string> abscissa_names = abscissa.columns;
  if (against.abscissa.given()) abscissa_names = {against.abscissa.value.column.value};
  std::vector<std::string> column_names;
  if (against.column.given()) {
    column_names = {against.column.value.column.value};
  } else if (quantity) {
    column_names = {*quantity};
  }
  // Only the units are read here; the check judges the rows.
  const base::CsvReader* header = nullptr;
  if (result) {
    base::DataSource source{result->file, result->shown_name, result->format};
    if (open.source != source) {
      auto opened = base::CsvReader::open(source, {});
      open.source = std::move(source);
      open.file = opened ? std::optional(std::move(*opened)) : std::nullopt;
    }
    if (open.file) header = &*open.file;
  }
  const auto over = conversion(binder, against.abscissa, header, abscissa_names, against.curve,
                               abscissa.dimension, "abscissa", problem.units);
  const auto compared = conversion(binder, against.column, header, column_names, against.curve,
                                   dimension, "quantity", problem.units);
  if (!result || !over || !compared) return std::nullopt;
  if (abscissa_names.empty()) {
    binder.missing_key(
        *text.against.node, text.against.path, "abscissa",
        "the curve's column that belongs to '" + base::printable(abscissa.text) + "'");
    return std::nullopt;
  }
  if (column_names.empty()) {
    if (!binder.unknown_names_excused() && text.quantity.sound) {
      binder.missing_key(
          *text.against.node, text.against.path, "column",
          "the curve's column that belongs to '" + base::printable(text.quantity.value) + "'");
    }
    return std::nullopt;
  }
  std::vector<std::string> compared_names;
  for (const auto& names : {abscissa_names, column_names}) {
    const auto found = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
      return header != nullptr && header->find(name);
    });
    if (found != names.end()) compared_names.push_back(*found);
  }
  const base::DataSource source{result->file, result->shown_name, result->format};
  // To count what is missing reads the file once for each pair of columns, some 7 ns a byte.
  constexpr std::uintmax_t kCounted = 2;
  if (source.format.missing != base::MissingSample::kError &&
      open.counted.emplace(result->data.get(), compared_names).second &&
      !binder.may_read(*against.curve.node, against.curve.path, source.file, kCounted)) {
    return std::nullopt;
  }
  note_missing(binder, source, compared_names, *against.curve.node, against.curve.path);
  result->abscissa = {std::move(abscissa_names), *over};
  result->column = {std::move(column_names), *compared};
  return result;
}

}  // namespace slipbench::driver::read
