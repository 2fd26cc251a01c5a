// SPDX-License-Identifier: Apache-2.0
#include "driver/read/keys/column_unit.hpp"

#include <fmt/format.h>

#include <utility>

#include "driver/base/csv/csv_fields.hpp"

namespace slipbench::driver::read {
namespace {

tl::expected<ColumnUnit, base::HistoryError> conversion_from(
    std::string_view unit, std::span<const base::Dimension> dimensions,
    const base::UnitSystem& system) {
  std::optional<base::HistoryError> first;
  for (const base::Dimension& dimension : dimensions) {
    auto found = base::conversion_to_case(unit, dimension, system);
    if (found) return ColumnUnit{*found, dimension};
    if (!first) first = std::move(found.error());
  }
  return tl::unexpected(std::move(*first));
}

/// The change from the file's own unit.
std::optional<ColumnUnit> from_file(yaml::Binder& binder, const base::CsvReader& file,
                                    const std::string& column, const yaml::Node& at,
                                    const yaml::Path& path,
                                    std::span<const base::Dimension> dimensions,
                                    const base::UnitSystem& system) {
  const ColumnUnit unchanged{{}, dimensions.front()};
  const std::string& name = file.header()[*file.find(column)];
  const std::string shown = fmt::format("{}: column '{}'", file.name(), base::printable(name));
  const std::string unit(file.unit(column));
  if (unit == "-") return unchanged;
  const std::string own = base::unit_text(dimensions.front(), system);
  const bool has_dimension = dimensions.front() != base::Dimension{};
  if (unit.empty()) {
    const std::string bracket(base::split_column_name(name).unit);
    if (!bracket.empty() && has_dimension && !own.empty()) {
      binder.note(
          at, path,
          fmt::format("{} is taken to be in {}: '{}' is no known unit, but part of the name", shown,
                      own, base::printable(bracket)));
    }
    return unchanged;
  }
  if (has_dimension && own.empty()) {
    binder.note(at, path,
                fmt::format("{} is in {}, and the case does not state its units: the numbers are "
                            "taken as they are",
                            shown, base::printable(unit)));
    return unchanged;
  }
  auto found = conversion_from(unit, dimensions, system);
  if (!found) {
    base::HistoryError error = std::move(found.error());
    error.message = fmt::format("{}: {}", shown, error.message);
    binder.history_error(at, path, error,
                         "a unit stated in the case, {column: ..., unit: ...}, is believed more "
                         "than the file's");
    return std::nullopt;
  }
  if (found->conversion != base::UnitConversion{}) {
    binder.note(at, path,
                fmt::format("{} is converted from {}, as the file says, to {}", shown,
                            base::printable(unit), base::unit_text(found->dimension, system)));
  }
  return *found;
}

}  // namespace

std::optional<ColumnUnit> column_unit(yaml::Binder& binder, const base::CsvReader* file,
                                      const std::string& column, const yaml::Node& at,
                                      const yaml::Path& path, const yaml::At<std::string>& stated,
                                      std::span<const base::Dimension> dimensions,
                                      const base::UnitSystem& system) {
  const bool found_in_file = file != nullptr && file->find(column).has_value();
  if (!stated.given()) {
    if (dimensions.empty()) return ColumnUnit{};
    if (!found_in_file) return ColumnUnit{{}, dimensions.front()};
    return from_file(binder, *file, column, at, path, dimensions, system);
  }
  if (!stated.sound) return std::nullopt;
  constexpr base::Dimension kNone{};
  if (dimensions.empty()) dimensions = std::span(&kNone, 1);
  auto found = conversion_from(stated.value, dimensions, system);
  if (!found) {
    binder.history_error(*stated.node, stated.path, found.error());
    return std::nullopt;
  }
  const std::string unit(found_in_file ? file->unit(column) : std::string_view());
  if (unit.empty() || unit == "-" || unit == stated.value) return *found;
  const auto of_file = conversion_from(unit, dimensions, system);
  if (!of_file || of_file->conversion != found->conversion) {
    binder.warning(
        *stated.node, stated.path,
        fmt::format("{} says that column '{}' is in {}; it is read in {}, as stated here",
                    file->name(), base::printable(file->header()[*file->find(column)]),
                    base::printable(unit), stated.value));
  }
  return *found;
}

bool is_in_units_of_case(yaml::Binder& binder, const base::CsvReader& file,
                         const std::string& column, std::string_view what, const yaml::Node& at,
                         const yaml::Path& path) {
  const std::string unit(file.unit(column));
  if (unit.empty() || unit == "-") return true;
  if (unit == file.unit_above(column) && !binder.is_foreign_unit(unit)) return true;
  binder.error(at, path,
               fmt::format("{} states column '{}' in {}, and {} is read in the case's units",
                           file.name(), base::printable(column), base::printable(unit), what),
               "convert the column, and leave its unit out of the file");
  return false;
}

void note_missing(yaml::Binder& binder, const base::DataSource& source,
                  std::span<const std::string> columns, const yaml::Node& at,
                  const yaml::Path& path) {
  std::string key = base::in_words(source.file.string(), source.format);
  for (const std::string& column : columns) key += "\n" + column;
  const std::string& missing = binder.words_of(
      std::move(key), [&] { return base::count_missing(source, columns).value_or(""); });
  if (missing.empty()) return;
  std::string text = source.shown_name + ": " + missing;
  if (missing.ends_with(base::kMostIsMissing)) {
    binder.warning(at, path, std::move(text));
  } else {
    binder.note(at, path, std::move(text));
  }
}

bool may_read(yaml::Binder& binder, const base::DataSource& source, const yaml::Node& at,
              const yaml::Path& path, std::uintmax_t effort) {
  // Rows in which samples may be missing are read field by field.
  const bool by_fields = source.format.missing != base::MissingSample::kError;
  return binder.may_read(at, path, source.file, by_fields ? 4 * effort : effort);
}

}  // namespace slipbench::driver::read
