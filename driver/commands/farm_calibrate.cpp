// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/farm_calibrate.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/sha256.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/calibrate/calibrate.hpp"
#include "driver/calibrate/read_fit.hpp"
#include "driver/farm/run_shared.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {
namespace {

/// Tells whether all ranks read the same files: they do the same fit only then.
bool read_the_same(const farm::Farm& farm, const std::string& file,
                   const std::vector<std::string>& data) {
  std::vector<std::string> files = data;
  files.push_back(file);
  std::string all;
  for (const std::string& one : files) all += base::sha256_of_file(one).value_or("none");
  const std::string own = base::sha256_of(all);
  std::string first = own;
  farm.share(first);
  return first == own;
}

}  // namespace

int farm_calibrate_command(CalibrateOptions options, const farm::Farm& farm) {
  options.threads = 1;
  options.items = [&](std::size_t count, const fit::Item& item) {
    return farm::run_shared(farm, count, item);
  };
  // Rank 0 says what is wrong, and when all is ready; the others wait for that.
  bool asked = false;
  options.ready = [&](const std::vector<std::string>& inputs) {
    asked = true;
    const bool go = farm.agree(true);
    return go && farm.agree(read_the_same(farm, options.file, inputs));
  };
  if (farm.rank == 0) {
    const int code = calibrate_command(options);
    if (!asked) farm.agree(false);
    return code;
  }
  const auto settings = base::parse_settings(options.settings);
  auto read = settings ? calibrate::read_fit(options.file, {*settings, options.allow_outside})
                       : calibrate::ReadFit();
  const bool readable = read.value.has_value() && !read.diagnostics.has_errors();
  if (!farm.agree(readable)) return base::kExitOk;
  if (!farm.agree(read_the_same(farm, options.file, read.data_files))) return base::kExitOk;
  calibrate::Fit& fit = *read.value;
  if (options.bootstrap) fit.bootstrap = *options.bootstrap;
  fit.profile = fit.profile || options.profile;
  (void)calibrate::calibrate(fit, {}, {.threads = 1, .with_hashes = false, .items = options.items});
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
