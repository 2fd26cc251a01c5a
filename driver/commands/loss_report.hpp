// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/base/text/json.hpp"
#include "driver/import/loss.hpp"

namespace slipbench::driver::commands {

/// Tells in lines what is approximated, dropped and kept, in this order.
std::string loss_report(const std::vector<import::Loss>& losses);

/// The same for machines: lists of phrases called approximated, dropped, kept.
base::json::Value loss_json(const std::vector<import::Loss>& losses);

}  // namespace slipbench::driver::commands
