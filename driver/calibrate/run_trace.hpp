// SPDX-License-Identifier: Apache-2.0
// Trace of a run of a case that a fit looks at.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/calibrate/fit.hpp"
#include "driver/case/case.hpp"
#include "driver/check/row_values.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::calibrate {

/// The friction force of one component that a quantity is linear in: "CSF1", "= -CSF1 + offset".
struct ForceResponse {
  int component = 0;         ///< index 0..5
  std::size_t variable = 0;  ///< in ResponseFit::variables
  bool plain = false;        ///< the quantity is the force itself
};

/// The force that a response of a case is linear in; nothing if it uses time or another column, or
/// if it is not linear for forces up to `scale`.
std::optional<ForceResponse> force_response(const cases::Case& problem, const ResponseFit& response,
                                            double scale);

/// The rows of a run, column by column.
struct RunTrace {
  std::vector<double> time;
  struct Response {
    std::vector<double> value;     ///< empty where they were not asked for
    std::vector<double> over;      ///< what loops are compared over; empty over time
    std::vector<double> position;  ///< CP of the force's component; empty where there is none
  };
  std::vector<Response> responses;
};

/// Collects what the responses of an experiment need, row by row.
class RunTracer {
 public:
  /// \param with_values false: the values of the responses are not collected
  /// Errors, in a sentence: a quantity that the case does not have.
  static tl::expected<RunTracer, std::string> make(const cases::Case& problem,
                                                   const ExperimentFit& experiment,
                                                   bool with_values);

  /// Error, in a sentence: a response without a value.
  tl::expected<void, std::string> take(const bench::Row& row);

  RunTrace& trace() { return trace_; }
  /// Names of the columns in RunTrace::Response::position; empty where there is none.
  const std::vector<std::string>& position_names() const { return position_names_; }

 private:
  struct Reader {
    std::optional<check::RowExpression> value;
    std::optional<results::Column> over;
    std::optional<results::Column> position;
  };

  explicit RunTracer(const cases::Case& problem) : case_(&problem) {}

  const cases::Case* case_;
  std::vector<base::Expression> expressions_;  ///< one run's own: they are not for several threads
  std::vector<Reader> readers_;
  std::vector<std::string> position_names_;
  RunTrace trace_;
};

/// Runs a case and collects. Errors: those of the run and of RunTracer.
/// \param[out] positions names of the position columns, if wanted
tl::expected<RunTrace, std::string> trace_run(const cases::Case& problem,
                                              const ExperimentFit& experiment,
                                              std::vector<std::string>* positions = nullptr);

/// Tells whether a column is a relative position, which no law has a say in where motions are
/// prescribed.
bool is_position(const cases::Case& problem, std::string_view name);

}  // namespace slipbench::driver::calibrate
