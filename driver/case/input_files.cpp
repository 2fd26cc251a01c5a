// SPDX-License-Identifier: Apache-2.0
#include "driver/case/input_files.hpp"

#include <variant>

namespace slipbench::driver::cases {

std::vector<std::string> history_files(const Case& problem) {
  std::vector<std::string> files = {problem.file};
  if (problem.measured) files.push_back(problem.measured->data.file.string());
  for (const Step& step : problem.steps) {
    for (const Drive& drive : step.drives) {
      if (const auto* csv = std::get_if<history::CsvColumn>(&drive.profile)) {
        files.push_back(csv->data.file.string());
      }
    }
  }
  return files;
}

std::vector<std::string> input_files(const Case& problem) {
  std::vector<std::string> files = history_files(problem);
  files.insert(files.end(), problem.data_files.begin(), problem.data_files.end());
  for (const Check& check : problem.checks) {
    if (const auto* curve = std::get_if<CurveReference>(&check.against)) {
      files.push_back(curve->file.string());
    }
  }
  return files;
}

}  // namespace slipbench::driver::cases
