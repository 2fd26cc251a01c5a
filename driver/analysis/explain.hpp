// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "driver/case/case.hpp"

namespace slipbench::driver::analysis {

/// Failure of an explanation: a message with a line feed, and the exit code.
struct ExplainFailure {
  int code = 0;
  std::string message;
};

/// `slipbench run --explain TIME`: why each definition does what it does at that instant. Takes the
/// first increment that ends at `time` or after it, and tells regime and forces, P and Phi, limit,
/// coefficient and its table cell, normal force with every term of the contact force, internal
/// contact force with its cell, slip direction, and the events before and after. The numbers have
/// six digits, so that what is printed as a product is one.
/// Errors: a time outside the history; a run that fails.
tl::expected<std::string, ExplainFailure> explain(const cases::Case& problem, double time);

}  // namespace slipbench::driver::analysis
