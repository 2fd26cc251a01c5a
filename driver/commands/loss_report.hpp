// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/analysis/response.hpp"
#include "driver/base/text/json.hpp"
#include "driver/import/loss.hpp"

namespace slipbench::driver::commands {

/// Difference that a translation makes on a case's own history, or why it is not known.
using MeasuredDifference = tl::expected<analysis::ResponseDifference, std::string>;

/// Tells in lines what is approximated, dropped and kept, in this order.
std::string loss_report(const std::vector<import::Loss>& losses);

/// The same for machines: lists of phrases called approximated, dropped, kept.
base::json::Value loss_json(const std::vector<import::Loss>& losses);

/// Tells a difference in a line.
std::string difference_line(const MeasuredDifference& difference);

/// The same for machines: `text`, and the numbers where it is known.
base::json::Value difference_json(const MeasuredDifference& difference);

}  // namespace slipbench::driver::commands
