// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/suite_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "driver/exit_code.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

/// Whether two names mean one file, be it there or not.
bool is_same(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  return fs::absolute(a, error).lexically_normal() == fs::absolute(b, error).lexically_normal();
}

std::string overwritten_case(const std::string& target, std::span<const Candidate> cases) {
  std::error_code error;
  if (!fs::exists(target, error)) return {};
  for (const Candidate& candidate : cases) {
    if (fs::equivalent(target, candidate.path, error) && !error) return candidate.path;
  }
  return {};
}

}  // namespace

tl::expected<SuiteFiles, SuiteFilesFault> SuiteFiles::create(const SuiteTargets& targets,
                                                             std::span<const Candidate> cases) {
  const std::pair<const char*, const std::string*> wanted[] = {
      {"--junit", &targets.junit}, {"--json", &targets.json}, {"--report", &targets.report}};
  for (const auto& [option, target] : wanted) {
    if (target->empty()) continue;
    if (const std::string path = overwritten_case(*target, cases); !path.empty()) {
      return tl::unexpected(SuiteFilesFault{
          kExitBadInput,
          fmt::format("{} {}: is one of the cases and is not overwritten", option, *target)});
    }
    for (const auto& [other_option, other] : wanted) {
      if (other == target) break;
      if (!other->empty() && is_same(*target, *other)) {
        return tl::unexpected(SuiteFilesFault{
            kExitBadInput,
            fmt::format("{} and {} would both write {}", other_option, option, *target)});
      }
    }
  }
  SuiteFiles files;
  for (const auto& [option, target] : wanted) {
    if (target->empty()) continue;
    auto file = OutputFile::create(*target);
    if (!file) return tl::unexpected(SuiteFilesFault{kExitEnvironment, file.error()});
    if (target == &targets.junit) files.junit.emplace(std::move(*file));
    if (target == &targets.json) files.json.emplace(std::move(*file));
  }
  return files;
}

std::vector<std::string> SuiteFiles::complete() {
  std::vector<std::string> faults;
  for (std::optional<OutputFile>* file : {&junit, &json}) {
    if (!*file) continue;
    OutputFile* const alone[] = {&**file};
    if (auto done = commit(alone); !done) faults.push_back(done.error());
  }
  return faults;
}

}  // namespace slipbench::driver
