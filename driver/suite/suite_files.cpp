// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/suite_files.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/report/page.hpp"
#include "driver/suite/junit.hpp"
#include "driver/suite/suite_json.hpp"

namespace slipbench::driver::suite {
namespace {

using Wanted = std::array<std::pair<const char*, const std::string*>, 3>;

Wanted wanted_files(const SuiteTargets& targets) {
  return {{{"--junit", &targets.junit}, {"--json", &targets.json}, {"--report", &targets.report}}};
}

SuiteFilesFault bad_input(std::string message) { return {base::kExitBadInput, std::move(message)}; }

}  // namespace

std::string overwritten_input(const SuiteTargets& targets, std::span<const std::string> inputs) {
  for (const auto& [option, target] : wanted_files(targets)) {
    if (target->empty()) continue;
    if (const std::string fault = base::input_fault(*target, inputs); !fault.empty()) {
      return fmt::format("{} {}", option, fault);
    }
  }
  return {};
}

tl::expected<SuiteFiles, SuiteFilesFault> SuiteFiles::create(const SuiteTargets& targets,
                                                             std::span<const Candidate> cases) {
  std::vector<std::string> inputs;
  for (const Candidate& candidate : cases) inputs.push_back(candidate.path);
  if (const std::string fault = overwritten_input(targets, inputs); !fault.empty()) {
    return tl::unexpected(SuiteFilesFault{base::kExitEnvironment, fault});
  }
  const Wanted wanted = wanted_files(targets);
  for (const auto& [option, target] : wanted) {
    if (target->empty()) continue;
    if (*target == "-") {
      return tl::unexpected(bad_input(
          fmt::format("{} -: wanted the name of a file; the terminal gets the table", option)));
    }
    for (const auto& [other_option, other] : wanted) {
      if (other == target) break;
      if (!other->empty() && base::is_same_file(*target, *other)) {
        return tl::unexpected(
            bad_input(fmt::format("{} and {} would both write {}", other_option, option, *target)));
      }
    }
  }
  SuiteFiles files;
  for (const auto& [option, target] : wanted) {
    if (target->empty()) continue;
    const base::FileMark mark = target == &targets.junit  ? JunitReport::mark()
                                : target == &targets.json ? SuiteJson::mark()
                                                          : report::report_page_mark();
    auto file = base::OutputFile::create(*target, mark, {.force = targets.force});
    if (!file) return tl::unexpected(SuiteFilesFault{base::kExitEnvironment, file.error()});
    if (target == &targets.junit) files.junit.emplace(std::move(*file));
    if (target == &targets.json) files.json.emplace(std::move(*file));
  }
  return files;
}

std::vector<base::OutputFile*> SuiteFiles::all() {
  std::vector<base::OutputFile*> files;
  for (std::optional<base::OutputFile>* file : {&junit, &json}) {
    if (*file) files.push_back(&**file);
  }
  return files;
}

}  // namespace slipbench::driver::suite
