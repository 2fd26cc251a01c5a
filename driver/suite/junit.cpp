// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/junit.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "driver/suite/xml_text.hpp"

namespace slipbench::driver::suite {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStart =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"slipbench\"";

/// The folder of a case as its label has it; else the name of the folder that it is in.
std::string suite_of(const Candidate& candidate) {
  const std::size_t slash = candidate.label.rfind('/');
  if (slash != std::string::npos) return candidate.label.substr(0, slash == 0 ? 1 : slash);
  std::error_code ignored;
  const fs::path folder =
      fs::absolute(candidate.path, ignored).lexically_normal().parent_path().filename();
  return folder.empty() ? "/" : folder.string();
}

/// The file of a case as the readers want it, from the current folder.
std::string file_of(const Candidate& candidate) {
  std::error_code ignored;
  const fs::path path = fs::path(candidate.path).lexically_normal();
  const fs::path relative =
      path.is_absolute() ? path.lexically_relative(fs::current_path(ignored)) : path;
  return relative.empty() || *relative.begin() == ".." ? path.string() : relative.string();
}

const char* word_for_code(int code) {
  switch (code) {
    case base::kExitCheckFailed:
      return "check failed";
    case base::kExitBadInput:
      return "bad input";
    case base::kExitNumerical:
      return "numerical failure";
    case base::kExitEnvironment:
      return "file or environment";
    default:
      return "internal error";
  }
}

/// <testcase> with what it contains, if anything. Line 0 leaves the line out.
std::string test_case(const Candidate& candidate, const std::string& name, int line, double seconds,
                      const std::string& content) {
  std::string text = fmt::format(R"(    <testcase classname="{}" name="{}" file="{}")",
                                 xml_attribute(candidate.label), xml_attribute(name),
                                 xml_attribute(file_of(candidate)));
  if (line > 0) text += fmt::format(R"( line="{}")", line);
  text += fmt::format(R"( time="{:.6f}")", seconds);
  text += content.empty() ? "/>\n" : ">\n" + content + "    </testcase>\n";
  return text;
}

std::string content_of(const CheckOutcome& check) {
  const check::Verdict& verdict = check.verdict;
  std::string text;
  if (!verdict.passed) {
    text += fmt::format("      <failure type=\"check failed\" message=\"{}\">{}</failure>\n",
                        xml_attribute(verdict.message), xml_text(check.text));
  }
  if (!verdict.warnings.empty()) {
    text += "      <system-out>";
    for (const std::string& warning : verdict.warnings) {
      text += "warning: " + xml_text(warning) + "\n";
    }
    text += "</system-out>\n";
  }
  return text;
}

}  // namespace

void JunitReport::add(std::size_t place, const Candidate& candidate, const CaseOutcome& outcome) {
  Suite& suite = suites_[suite_of(candidate)];
  Counts& counts = suite.counts;
  counts.seconds += outcome.seconds;
  const auto add_one = [&](const std::string& name, int line, double seconds,
                           const std::string& content) {
    ++counts.tests;
    suite.cases[place] += test_case(candidate, name, line, seconds, content);
  };
  const auto skip = [&](const std::string& reason) {
    ++counts.skipped;
    add_one("case", 0, outcome.seconds,
            fmt::format("      <skipped message=\"{}\"/>\n", xml_attribute(reason)));
  };
  if (outcome.kind == CaseOutcome::Kind::kNotRun && outcome.code == base::kExitOk) {
    skip(outcome.fault.message);
  } else if (outcome.kind == CaseOutcome::Kind::kNotRun) {
    ++counts.errors;
    // A fault may be that of a data file, whose lines are not the case's.
    const CaseFault& fault = outcome.fault;
    add_one("case", fault.file == candidate.path ? fault.where.line : 0, outcome.seconds,
            fmt::format("      <error type=\"{}\" message=\"{}\">{}</error>\n",
                        word_for_code(outcome.code), xml_attribute(fault.message),
                        xml_text(outcome.messages)));
  } else if (outcome.kind == CaseOutcome::Kind::kNoChecks) {
    skip("the case has no checks");
  } else {
    counts.failures += outcome.failed;
    for (const CheckOutcome& check : outcome.verdicts) {
      add_one(check.verdict.name, check.where.line,
              outcome.seconds / static_cast<double>(outcome.verdicts.size()), content_of(check));
    }
  }
}

std::string JunitReport::attributes(const Counts& counts) {
  return fmt::format(R"(tests="{}" failures="{}" errors="{}" time="{:.6f}")", counts.tests,
                     counts.failures, counts.errors, counts.seconds);
}

base::FileMark JunitReport::mark() { return {"a JUnit file of 'slipbench check'", kStart, ""}; }

std::string JunitReport::text() const {
  Counts all;
  using Entry = const std::pair<const std::string, Suite>*;
  std::map<std::size_t, Entry> in_order;  // by the place of the first case
  for (const auto& entry : suites_) {
    in_order[entry.second.cases.begin()->first] = &entry;
    const Counts& counts = entry.second.counts;
    all.tests += counts.tests;
    all.failures += counts.failures;
    all.errors += counts.errors;
    all.seconds += counts.seconds;
  }
  // The readers' schema knows the number of skipped tests of a suite, but not of all.
  std::string text = fmt::format("{} {}>\n", kStart, attributes(all));
  for (const auto& [place, entry] : in_order) {
    const Suite& suite = entry->second;
    text +=
        fmt::format("  <testsuite name=\"{}\" {} skipped=\"{}\">\n", xml_attribute(entry->first),
                    attributes(suite.counts), suite.counts.skipped);
    for (const auto& [case_place, elements] : suite.cases) text += elements;
    text += "  </testsuite>\n";
  }
  return text + "</testsuites>\n";
}

}  // namespace slipbench::driver::suite
