// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/case/case.hpp"

namespace slipbench::driver::cases {

/// The file of a case and those of its history.
std::vector<std::string> history_files(const Case& problem);

/// The files a case is read from, none of which may be overwritten: those of its history, its
/// tables and the curves of its checks.
std::vector<std::string> input_files(const Case& problem);

}  // namespace slipbench::driver::cases
