// SPDX-License-Identifier: Apache-2.0
// Golden curves: a case's own past as the reference of its checks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/check/row_values.hpp"

namespace slipbench::driver::check {

/// A column of a golden curve: total time, or an expression of a check.
struct GoldenColumn {
  std::string name;
  std::string text = {};                 ///< the expression; empty for total time
  std::string unit = {};                 ///< empty where it is not known or not the case's own
  base::UnitConversion conversion = {};  ///< from the file's unit to the case's, as the check says
  /// Nothing for total time.
  std::optional<RowExpression> value = {};
};

/// A golden curve that the checks of a case name: total time, then for each of these checks its
/// abscissa and its quantity, each name once. A row is a row of the run, and all of them are in it.
struct GoldenCurve {
  std::filesystem::path file;
  std::string shown_name;
  std::vector<GoldenColumn> columns = {};
  std::vector<std::size_t> checks = {};  ///< of the case
  std::int64_t rows = 0;                 ///< appended so far
};

/// The curves that `slipbench bless` may write: those of the case's checks that are missing or
/// golden. Errors, in a sentence: no check names a curve; all of them have another origin; a golden
/// one is that of another case; two checks mean different things by one column.
tl::expected<std::vector<GoldenCurve>, std::string> golden_curves(const cases::Case& problem);

/// Head above the numbers. Of blessings, the latest comes first.
struct GoldenHeader {
  std::vector<std::string> origin;  ///< lines on program, case, units, parameters, columns and rows
  std::vector<std::string> blessings;  ///< "# blessed: new liner" or "# blessed 2026-01-31: .."
};

/// That of a golden curve which is there.
GoldenHeader read_golden_header(const std::filesystem::path& file);

/// Tells whether these rows, that of the names included, are all that stands in a golden curve
/// behind its comments; a file that is cut off has others.
bool has_golden_rows(const std::filesystem::path& file, std::string_view rows);

/// That of a curve whose rows are all appended and which is about to be written. The date of a
/// blessing is that of SOURCE_DATE_EPOCH, or none: the same input gives the same bytes. At most 20
/// blessings are kept.
GoldenHeader golden_header(const cases::Case& problem, const GoldenCurve& curve,
                           std::string_view reason, const GoldenHeader& before);

/// The comments of a golden curve.
std::string to_text(const GoldenHeader& header);
/// The row of its columns' names.
std::string names_row(const GoldenCurve& curve);

/// Appends a row; every number is the shortest text that reads back to the same double. Error: a
/// column without a value, in a sentence.
tl::expected<void, std::string> append_golden_row(GoldenCurve& curve, const bench::Row& row,
                                                  std::string& text);

}  // namespace slipbench::driver::check
