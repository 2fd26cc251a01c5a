// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <system_error>
#include <thread>

#include "driver/commands/shared.hpp"
#include "driver/results/provenance.hpp"
#include "driver/text/utf8.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

/// A case to check: where it is, and what it is called in the table.
struct Candidate {
  std::string path;
  std::string label;
};

struct Outcome {
  enum class Kind { kPassed, kFailed, kNoChecks, kNotRun } kind = Kind::kNotRun;
  int code = kExitOk;
  std::size_t checks = 0;
  std::string remark;               ///< beside a passed case
  std::vector<std::string> faults;  ///< of failed checks, one each
  std::string messages;             ///< of the reader or of a failed run, as printed
};

std::string without_extension(const fs::path& path) {
  return (path.parent_path() / path.stem()).lexically_normal().generic_string();
}

/// The cases in a folder, sorted by name.
tl::expected<std::vector<Candidate>, std::string> search(const std::string& folder, bool only) {
  std::vector<Candidate> found;
  std::error_code error;
  fs::recursive_directory_iterator it(folder, error);
  for (; !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (it->is_directory() && (name == "bad" || name.starts_with('.'))) {
      it.disable_recursion_pending();
    } else if (it->is_regular_file() && it->path().extension() == ".yaml") {
      const fs::path shown = only ? it->path().lexically_relative(folder) : it->path();
      found.push_back({it->path().string(), without_extension(shown)});
    }
  }
  if (error) return tl::unexpected(fmt::format("{}: {}", folder, error.message()));
  std::sort(found.begin(), found.end(),
            [](const Candidate& a, const Candidate& b) { return a.label < b.label; });
  return found;
}

Outcome check_one(const Candidate& candidate, const ReadOptions& options) {
  Outcome outcome;
  const ReadCase read = read_case(candidate.path, options);
  if (!read.value || read.diagnostics.has_errors()) {
    outcome.code = read.environment_failure ? kExitEnvironment : kExitBadInput;
    outcome.messages = render(read.diagnostics, read.sources);
    return outcome;
  }
  const Case& problem = *read.value;
  outcome.checks = problem.checks.size();
  std::vector<CheckProgress> checks;
  checks.reserve(problem.checks.size());
  for (const Check& check : problem.checks) checks.emplace_back(problem, check);
  const auto ended = run_case(problem, [&](const Row& row) {
    for (CheckProgress& check : checks) check.add(row);
  });
  if (!ended) {
    outcome.code = exit_code(ended.error());
    outcome.messages = failure_text(problem, ended.error());
    return outcome;
  }
  outcome.kind = checks.empty() ? Outcome::Kind::kNoChecks : Outcome::Kind::kPassed;
  double worst = -1.0;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const Verdict verdict = checks[i].verdict();
    if (!verdict.passed) {
      outcome.kind = Outcome::Kind::kFailed;
      outcome.code = kExitCheckFailed;
      outcome.faults.push_back(verdict_text(problem.checks[i], verdict));
    } else if (verdict.worst_fraction() > worst) {
      worst = verdict.worst_fraction();
      outcome.remark = worst_text(problem.checks[i], verdict);
    }
  }
  return outcome;
}

/// Exceptions end at the edge of a thread.
Outcome guarded_check(const Candidate& candidate, const ReadOptions& options) {
  try {
    return check_one(candidate, options);
  } catch (const std::exception& error) {
    Outcome outcome;
    outcome.code = kExitInternal;
    outcome.messages = fmt::format("{}: internal error: {}\n", candidate.path, error.what());
    return outcome;
  }
}

std::vector<Outcome> check_all(const std::vector<Candidate>& candidates, const ReadOptions& options,
                               unsigned jobs) {
  std::vector<Outcome> outcomes(candidates.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < candidates.size(); i = next++) {
      outcomes[i] = guarded_check(candidates[i], options);
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 1; i < std::min<std::size_t>(jobs, candidates.size()); ++i) {
    threads.emplace_back(work);
  }
  work();
  threads.clear();
  return outcomes;
}

std::string counted(std::size_t count, const char* thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

/// `left` and `right` on one line of the table's width.
std::string two_ends(const std::string& left, const std::string& right) {
  constexpr std::size_t kWidth = 72;
  const std::size_t used = left.size() + right.size();
  return left + std::string(used + 3 < kWidth ? kWidth - used : 3, ' ') + right + "\n";
}

class Paint {
 public:
  explicit Paint(bool wanted) : wanted_(wanted) {}
  std::string operator()(const char* colour, const std::string& text) const {
    return wanted_ ? fmt::format("\033[{}m{}\033[0m", colour, text) : text;
  }

 private:
  bool wanted_;
};

void print_table(const std::vector<Candidate>& candidates, const std::vector<Outcome>& outcomes) {
  const Paint paint(colour_wanted(STDOUT_FILENO));
  const std::string pass = paint("32", "PASS");
  const std::string fail = paint("31", "FAIL");
  std::size_t width = 0;
  for (const Candidate& candidate : candidates) {
    width = std::max(width, count_code_points(candidate.label));
  }
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Outcome& outcome = outcomes[i];
    const std::string label = printable(candidates[i].label);
    const std::string padded = label + std::string(width - count_code_points(label), ' ');
    switch (outcome.kind) {
      case Outcome::Kind::kPassed:
        print(fmt::format("  {}  {}   {:>9}   {}\n", pass, padded, counted(outcome.checks, "check"),
                          outcome.remark));
        break;
      case Outcome::Kind::kNoChecks:
        print(fmt::format("  ----  {}   no checks\n", padded));
        break;
      case Outcome::Kind::kFailed:
        for (const std::string& fault : outcome.faults) {
          print(fmt::format("  {}  {}   {}\n", fail, padded, fault));
        }
        break;
      case Outcome::Kind::kNotRun:
        print(fmt::format("  {}  {}   {}\n", fail, padded,
                          outcome.code == kExitNumerical ? "numerical failure, see below"
                                                         : "cannot be run, see below"));
        break;
    }
  }
}

}  // namespace

int check_command(const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto settings = parse_settings(options.settings);
  if (!settings) {
    print_error("slipbench: error: " + settings.error() + "\n");
    return kExitBadInput;
  }
  std::vector<Candidate> candidates;
  for (const std::string& path : options.paths) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) {
      candidates.push_back({path, without_extension(path)});
      continue;
    }
    auto found = search(path, options.paths.size() == 1);
    if (!found) {
      print_error("slipbench: error: " + found.error() + "\n");
      return kExitEnvironment;
    }
    candidates.insert(candidates.end(), found->begin(), found->end());
  }
  if (candidates.empty()) {
    print_error("slipbench: error: no case (*.yaml) found; nothing was checked\n");
    return kExitBadInput;
  }

  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const unsigned jobs = options.jobs > 0 ? static_cast<unsigned>(options.jobs) : cores;
  const std::vector<Outcome> outcomes =
      check_all(candidates, {*settings, options.allow_outside}, jobs);

  std::size_t checks = 0;
  std::size_t count[4] = {};
  int code = kExitOk;
  for (const Outcome& outcome : outcomes) {
    checks += outcome.checks;
    ++count[static_cast<std::size_t>(outcome.kind)];
    code = worse(code, outcome.code);
  }
  print(two_ends(fmt::format("slipbench {}   {}, {}", program_version(),
                             counted(candidates.size(), "case"), counted(checks, "check")),
                 counted(jobs, options.jobs > 0 ? "thread" : "core")));
  print_table(candidates, outcomes);
  const auto of_kind = [&](Outcome::Kind kind) { return count[static_cast<std::size_t>(kind)]; };
  std::string totals =
      fmt::format("  {} passed, {} failed", counted(of_kind(Outcome::Kind::kPassed), "case"),
                  of_kind(Outcome::Kind::kFailed));
  if (const auto n = of_kind(Outcome::Kind::kNotRun); n > 0) {
    totals += fmt::format(", {} not run", n);
  }
  if (const auto n = of_kind(Outcome::Kind::kNoChecks); n > 0) {
    totals += fmt::format(", {} without checks", n);
  }
  print(two_ends(totals, elapsed_text(std::chrono::steady_clock::now() - start)));
  for (const Outcome& outcome : outcomes) print_error(outcome.messages);
  return code;
}

}  // namespace slipbench::driver
