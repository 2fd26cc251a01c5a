// SPDX-License-Identifier: Apache-2.0
#include "driver/check/run_document.hpp"

#include <utility>

#include "driver/base/text/one_line.hpp"
#include "driver/results/provenance.hpp"

namespace slipbench::driver::check {

base::json::Value run_document(const cases::Case& problem, const results::Summary& summary,
                               const base::Diagnostics& reading,
                               std::span<const std::string> warnings,
                               std::span<const Verdict> verdicts) {
  base::json::Value document;
  document["provenance"] = results::provenance(problem);
  document["summary"] = summary.to_json();
  base::json::Value warning_list = base::json::Array{};
  for (std::string& warning : base::lines_of(reading, base::Severity::kWarning)) {
    warning_list.push_back(std::move(warning));
  }
  for (const std::string& warning : warnings) warning_list.push_back(warning);
  document["warnings"] = warning_list;
  base::json::Value check_list = base::json::Array{};
  for (const Verdict& verdict : verdicts) check_list.push_back(to_json(verdict));
  document["checks"] = check_list;
  return document;
}

}  // namespace slipbench::driver::check
