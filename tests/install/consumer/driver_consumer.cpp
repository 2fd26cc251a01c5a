// SPDX-License-Identifier: Apache-2.0
// Links the driver library: its own dependencies must come with the package.
#include <slipbench/driver/base/text/format_number.hpp>

int main() { return slipbench::driver::base::format_number(0.1) == "0.1" ? 0 : 1; }
