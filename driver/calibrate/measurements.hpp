// SPDX-License-Identifier: Apache-2.0
// Measured data, read and cleaned: what the residuals are taken against.
#pragma once

#include <cstddef>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/text/history_error.hpp"
#include "driver/calibrate/fit.hpp"

namespace slipbench::driver::calibrate {

/// The measurement of one response, in the case's units, in the order of the file.
struct MeasuredSeries {
  std::vector<double> time;   ///< [T], ascending
  std::vector<double> value;  ///< as many
  std::vector<double> over;   ///< the abscissa of loops, as many; empty over time
  std::vector<double> line;   ///< of the file, as many; empty where a row is made of several
};

struct Measurements {
  std::vector<MeasuredSeries> responses;  ///< in the order of ExperimentFit::responses
  std::size_t rows_read = 0;
  std::size_t rows_used = 0;          ///< of the response with the most
  std::vector<std::string> cleaning;  ///< what was done, a sentence each
  std::string hash;                   ///< SHA-256 of the file, hexadecimal
};

/// Reads the data file of an experiment and cleans it, in this order: unit, factor and offset of
/// every column; the time range; the dead band; the mean cycle; the resampling; the range of each
/// response. Neither mean cycle nor resampling interpolates across rows that the dead band left
/// out.
/// \param with_hash false leaves `hash` empty, where no provenance is written: it takes about as
/// long again as reading the numbers, or more
/// Errors, with the file's line where one is concerned: what CsvReader refuses, times that do not
/// ascend, nothing left to compare, less than one whole cycle.
tl::expected<Measurements, base::HistoryError> read_measurements(const ExperimentFit& experiment,
                                                                 bool with_hash = true);

}  // namespace slipbench::driver::calibrate
