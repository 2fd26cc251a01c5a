// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace slipbench::driver::commands {

/// Returns what the keys of cases and fits are of which this is the name ("elastic_slip") or the
/// end of the path ("stick.elastic_slip", "friction[0].stick.elastic_slip"): meaning, type, unit,
/// default, an example in its place, and the keys below. Keys that mean the same are told once.
/// Empty if there is none.
std::string describe_entries(std::string_view asked);

/// The names of all keys of cases and fits, each once, but for those of the laws' parameters.
std::vector<std::string> key_names();

}  // namespace slipbench::driver::commands
