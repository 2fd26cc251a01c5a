// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "driver/base/csv/csv_reader.hpp"
#include "driver/base/units/units.hpp"
#include "driver/yaml/binding.hpp"

namespace slipbench::driver::read {

/// The change from a column's unit to the case's, and what the column measures.
struct ColumnUnit {
  base::UnitConversion conversion;
  base::Dimension dimension;
};

/// The change of unit for a column of a data file: from the unit that the case states beside it, or
/// else from the one that the file states. Says what it takes from the file, and where the two
/// contradict each other (the case is believed).
/// \param column as the case names it, at `at`
/// \param file null if it could not be read: then only what the case states is known
/// \param dimensions that the quantity may have, by the first that fits the unit; empty if they are
///        not known: then the file's unit is not used
/// \return nothing after reporting an error: a unit that does not measure the quantity
std::optional<ColumnUnit> column_unit(yaml::Binder& binder, const base::CsvReader* file,
                                      const std::string& column, const yaml::Node& at,
                                      const yaml::Path& path, const yaml::At<std::string>& stated,
                                      std::span<const base::Dimension> dimensions,
                                      const base::UnitSystem& system);

/// Tells whether the file states no unit for a column, or one of the case, where a unit cannot be
/// converted; false after reporting another. \param what is read: "a table"
bool is_in_units_of_case(yaml::Binder& binder, const base::CsvReader& file,
                         const std::string& column, std::string_view what, const yaml::Node& at,
                         const yaml::Path& path);

/// Says how many samples of these columns are missing, if the source allows for it; warns where it
/// is most of them. Faults of the file are not reported: those that read it do.
void note_missing(yaml::Binder& binder, const base::DataSource& source,
                  std::span<const std::string> columns, const yaml::Node& at,
                  const yaml::Path& path);

/// Counts a source that is read through while the case is (yaml::Binder::may_read). Returns false
/// after reporting that the case reads too often.
/// \param effort of a byte, as a multiple of that of reading it
bool may_read(yaml::Binder& binder, const base::DataSource& source, const yaml::Node& at,
              const yaml::Path& path, std::uintmax_t effort = 1);

}  // namespace slipbench::driver::read
