// SPDX-License-Identifier: Apache-2.0
// Abscissa of a check, and the reference curve it names.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "driver/base/csv/csv_reader.hpp"
#include "driver/base/csv/data_source.hpp"
#include "driver/case/case.hpp"
#include "driver/read/keys/case_text.hpp"
#include "driver/yaml/binding.hpp"

namespace slipbench::driver::read {

/// Abscissa of a comparison.
struct AbscissaChoice {
  std::optional<cases::ExpressionReference> value;  ///< nothing for total time
  std::string text = "time";                        ///< as the case names it
  std::vector<std::string> columns;          ///< of a curve that hold it unless the case says else
  std::optional<base::Dimension> dimension;  ///< unknown of an expression
};

/// The check's own `abscissa:`, else what the curve's column of the abscissa is called, else time.
/// \param variables what an expression of a check may name
/// \return nothing after reporting an error, or if it cannot be judged yet
std::optional<AbscissaChoice> read_abscissa(yaml::Binder& binder, const CheckText& text,
                                            const std::vector<std::string>& variables,
                                            const cases::Case& problem);

/// State of reading the curves of a case's checks: the one whose header was read last, which as a
/// rule the next check names again, and which files and samples are there.
struct OpenCurve {
  base::DataSource source;
  std::optional<base::CsvReader> file;  ///< nothing if it cannot be read
  std::set<std::string> files;          ///< one for all spellings of its path
  /// Columns of a file in which samples may be missing, counted already.
  std::set<std::pair<const cases::CurveFile*, std::vector<std::string>>> counted;
};

/// The curve under `against:`.
/// \param may_be_missing the file need not be there: it is about to be made
/// \param open is brought up to the curve
std::optional<cases::CurveReference> read_curve(yaml::Binder& binder, const CheckText& text,
                                                const AbscissaChoice& abscissa,
                                                const cases::Case& problem, bool may_be_missing,
                                                OpenCurve& open);

/// The column that is named by a check's quantity and nothing else.
std::optional<std::string> column_of_quantity(std::string_view quantity,
                                              const cases::Case& problem);

}  // namespace slipbench::driver::read
