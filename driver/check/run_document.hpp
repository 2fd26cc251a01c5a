// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/json.hpp"
#include "driver/case/case.hpp"
#include "driver/check/verdict.hpp"
#include "driver/results/summary.hpp"

namespace slipbench::driver::check {

/// All that is told of a run beside its rows: provenance, summary, warnings, checks.
/// \param reading messages of the case's text, of which warnings are told
base::json::Value run_document(const cases::Case& problem, const results::Summary& summary,
                               const base::Diagnostics& reading,
                               std::span<const std::string> warnings,
                               std::span<const Verdict> verdicts);

}  // namespace slipbench::driver::check
