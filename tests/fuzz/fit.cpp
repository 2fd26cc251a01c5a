// SPDX-License-Identifier: Apache-2.0
// A fit file, beside the cases and data of cases/calibration.
#include <string>

#include "driver/calibrate/measurements.hpp"
#include "driver/calibrate/read_fit.hpp"
#include "tests/fuzz/fuzz_files.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace slipbench::fuzz {

void fit(std::string_view input) {
  copy_of_sources("cases/calibration");
  const auto read = driver::calibrate::read_fit(own_file("fuzz_fit.yaml", input).string());
  const std::string messages = driver::base::render(read.diagnostics, read.sources);
  want(read.value.has_value() || !messages.empty(), "a fit that is refused has an error");
  if (!read.value || read.diagnostics.has_errors()) return;
  for (const driver::calibrate::ExperimentFit& experiment : read.value->experiments) {
    const auto data = driver::calibrate::read_measurements(experiment, false);
    want(data.has_value() || !data.error().message.empty(), "an error has a message");
  }
}

}  // namespace slipbench::fuzz

SLIPBENCH_FUZZ_TARGET(fit)
