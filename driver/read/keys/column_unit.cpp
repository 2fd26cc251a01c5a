// SPDX-License-Identifier: Apache-2.0
#include "driver/read/keys/column_unit.hpp"

#include <fmt/format.h>

#include <utility>

#include "driver/base/csv/csv_fields.hpp"

namespace slipbench::driver {
namespace {

tl::expected<ColumnUnit, HistoryError> conversion_from(std::string_view unit,
                                                       std::span<const Dimension> dimensions,
                                                       const UnitSystem& system) {
  std::optional<HistoryError> first;
  for (const Dimension& dimension : dimensions) {
    auto found = conversion_to_case(unit, dimension, system);
    if (found) return ColumnUnit{*found, dimension};
    if (!first) first = std::move(found.error());
  }
  return tl::unexpected(std::move(*first));
}

/// The change from the file's own unit.
std::optional<ColumnUnit> from_file(Binder& binder, const CsvReader& file,
                                    const std::string& column, const Node& at, const Path& path,
                                    std::span<const Dimension> dimensions,
                                    const UnitSystem& system) {
  const ColumnUnit unchanged{{}, dimensions.front()};
  const std::string& name = file.header()[*file.find(column)];
  const std::string shown = fmt::format("{}: column '{}'", file.name(), printable(name));
  const std::string unit(file.unit(column));
  if (unit == "-") return unchanged;
  const std::string own = unit_text(dimensions.front(), system);
  const bool has_dimension = dimensions.front() != Dimension{};
  if (unit.empty()) {
    const std::string bracket(split_column_name(name).unit);
    if (!bracket.empty() && has_dimension && !own.empty()) {
      binder.note(
          at, path,
          fmt::format("{} is taken to be in {}: '{}' is no known unit, but part of the name", shown,
                      own, printable(bracket)));
    }
    return unchanged;
  }
  if (has_dimension && own.empty()) {
    binder.note(at, path,
                fmt::format("{} is in {}, and the case does not state its units: the numbers are "
                            "taken as they are",
                            shown, printable(unit)));
    return unchanged;
  }
  auto found = conversion_from(unit, dimensions, system);
  if (!found) {
    HistoryError error = std::move(found.error());
    error.message = fmt::format("{}: {}", shown, error.message);
    binder.history_error(at, path, error,
                         "a unit stated in the case, {column: ..., unit: ...}, is believed more "
                         "than the file's");
    return std::nullopt;
  }
  if (found->conversion != UnitConversion{}) {
    binder.note(at, path,
                fmt::format("{} is converted from {}, as the file says, to {}", shown,
                            printable(unit), unit_text(found->dimension, system)));
  }
  return *found;
}

}  // namespace

std::optional<ColumnUnit> column_unit(Binder& binder, const CsvReader* file,
                                      const std::string& column, const Node& at, const Path& path,
                                      const At<std::string>& stated,
                                      std::span<const Dimension> dimensions,
                                      const UnitSystem& system) {
  const bool found_in_file = file != nullptr && file->find(column).has_value();
  if (!stated.given()) {
    if (dimensions.empty()) return ColumnUnit{};
    if (!found_in_file) return ColumnUnit{{}, dimensions.front()};
    return from_file(binder, *file, column, at, path, dimensions, system);
  }
  if (!stated.sound) return std::nullopt;
  constexpr Dimension kNone{};
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
                    file->name(), printable(file->header()[*file->find(column)]), printable(unit),
                    stated.value));
  }
  return *found;
}

void note_missing(Binder& binder, const DataSource& source, std::span<const std::string> columns,
                  const Node& at, const Path& path) {
  const auto counted = count_missing(source, columns);
  if (!counted || counted->empty()) return;
  binder.note(at, path, (source.shown_name + ": ").append(*counted));
}

}  // namespace slipbench::driver
