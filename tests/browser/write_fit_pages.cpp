// SPDX-License-Identifier: Apache-2.0
// Writes the pages of fits made by hand into a folder: write_fit_pages FOLDER [NAME...]
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "driver/calibrate/report/fit_report.hpp"
#include "tests/driver/calibrate/report/made_fits.hpp"

int main(int count, char** arguments) {
  using namespace slipbench::driver;
  if (count < 2) return 2;
  const std::filesystem::path folder = arguments[1];
  const std::vector<std::string> wanted(arguments + 2, arguments + count);
  for (const auto& [name, make] : calibrate::made_fits()) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
    const calibrate::MadeFit made = make();
    const auto page =
        calibrate::write_fit_report(made.fit, made.calibration, folder / (name + ".html"));
    if (!page) {
      fmt::print(stderr, "{}\n", page.error());
      return 1;
    }
  }
  return 0;
}
