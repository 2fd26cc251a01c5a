// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/run_suite.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

#include "driver/base/files/work_crew.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::suite {
namespace {

/// A slider of so many increments; with another coefficient than 0.2 its check fails.
std::string slider(int increments, const std::string& coefficient = "0.2") {
  return "slipbench: 1\nunits: {length: mm, force: N, time: s}\nconnector: {type: SLOT}\n"
         "friction: [{predefined: {}, coefficient: " +
         coefficient +
         ", stick: {stiffness: 1000}}]\n"
         "history: [{step: go, increments: " +
         std::to_string(increments) +
         ", motion: {CP1: {to: 0.1}}, force: {f2: 100}}]\n"
         "checks:\n  - name: limit\n    quantity: FLIM\n    against: {expression: = 20}\n"
         "    tolerance: {absolute: 1.0e-9}\n";
}

struct Suite {
  TemporaryFolder folder;
  std::vector<Candidate> cases;

  void add(const std::string& name, const std::string& text) {
    cases.push_back({folder.write(name + ".yaml", text).string(), name});
  }
};

/// Runs a suite; returns a word a case.
std::string told(const Suite& suite, const SuiteOptions& options, bool read_ahead = false) {
  std::string text;
  SuiteListener listener;
  listener.tell = [&](const Candidate& candidate, CaseOutcome&& outcome) {
    text += candidate.label + " " + word_for(outcome.kind) + "\n";
  };
  run_suite(suite.cases, read_ahead ? read_suite(suite.cases, options) : std::vector<Reading>{},
            options, listener);
  return text;
}

TEST_CASE("cases are told in their order whatever the threads, and one bad case stops no other") {
  Suite suite;
  suite.add("long", slider(20000));
  suite.add("fails", slider(10, "0.3"));
  suite.add("bad", "slipbench: 1\n");
  suite.add("no_text", "\xFF\xFE");
  suite.cases.push_back({(suite.folder.path() / "missing.yaml").string(), "missing"});
  suite.add("passes", slider(10));
  const std::string wanted =
      "long passed\nfails failed\nbad not_run\nno_text not_run\nmissing not_run\npasses passed\n";
  for (const unsigned threads : {1U, 2U, 7U}) {
    CHECK(told(suite, {.threads = threads}) == wanted);
    CHECK(told(suite, {.threads = threads}, true) == wanted);
  }
}

TEST_CASE("a suite that fails fast ends with its first failure, whatever the threads have done") {
  Suite suite;
  suite.add("long", slider(20000));
  suite.add("fails", slider(2000, "0.3"));
  suite.add("endless", slider(2000000000));
  suite.add("fails_too", slider(10, "0.3"));
  suite.add("passes", slider(10));
  for (const unsigned threads : {1U, 2U, 7U}) {
    CHECK(told(suite, {.threads = threads, .fail_fast = true}) == "long passed\nfails failed\n");
  }
}

TEST_CASE("the verdicts of what passes are kept only if they are wanted") {
  Suite suite;
  suite.add("passes", slider(10));
  suite.add("fails", slider(10, "0.3"));
  const auto kept = [&](bool keep_passing) {
    std::vector<std::size_t> counts;
    SuiteListener listener;
    listener.tell = [&](const Candidate&, CaseOutcome&& outcome) {
      CHECK(outcome.checks == 1);
      CHECK(outcome.seconds > 0.0);
      counts.push_back(outcome.verdicts.size());
    };
    run_suite(suite.cases, {}, {.threads = 1, .keep_passing = keep_passing}, listener);
    return counts;
  };
  CHECK(kept(false) == std::vector<std::size_t>{0, 1});
  CHECK(kept(true) == std::vector<std::size_t>{1, 1});
}

TEST_CASE("a failed case knows where its check and its error stand") {
  Suite suite;
  suite.add("fails", slider(10, "0.3"));
  suite.add("bad", "slipbench: 1\nconnecter: {type: SLOT}\n");
  std::vector<CaseOutcome> outcomes;
  SuiteListener listener;
  listener.tell = [&](const Candidate&, CaseOutcome&& outcome) {
    outcomes.push_back(std::move(outcome));
  };
  run_suite(suite.cases, {}, {}, listener);
  REQUIRE(outcomes.size() == 2);
  REQUIRE(outcomes[0].verdicts.size() == 1);
  CHECK(outcomes[0].verdicts[0].where.line == 7);
  CHECK(outcomes[0].code == base::kExitCheckFailed);
  CHECK(outcomes[1].fault.file == suite.cases[1].path);
  CHECK(outcomes[1].fault.where.line > 0);
  CHECK(outcomes[1].code == base::kExitBadInput);
}

TEST_CASE("a curve is read beside the run, or after it: what is wrong in it is told alike") {
  Suite suite;
  std::string rows = "time,FLIM\n";
  for (int i = 0; i <= 1000; ++i) rows += std::to_string(i) + "e-3,20\n";
  suite.folder.write("good.csv", rows);
  suite.folder.write("bad.csv", rows + "1.001,twenty\n");
  suite.folder.write("other.csv", rows.substr(0, rows.size() - 3) + "21\n");
  for (const std::string file : {"good", "bad", "other", "missing"}) {
    std::string text = slider(1000);
    const std::string expression = "{expression: = 20}";
    text.replace(text.find(expression), expression.size(), "{curve: " + file + ".csv}");
    suite.add(file, text);
  }
  const auto texts = [&](const Candidate& candidate, unsigned threads) {
    std::string told;
    SuiteListener listener;
    listener.tell = [&](const Candidate&, CaseOutcome&& outcome) {
      told = outcome.messages;
      for (const CheckOutcome& check : outcome.verdicts) told += check.text;
    };
    run_suite({&candidate, 1}, {}, {.threads = threads, .keep_passing = true}, listener);
    return told;
  };
  for (const Candidate& candidate : suite.cases) {
    CHECK(texts(candidate, 1) == texts(candidate, 2));
  }
  CHECK_THAT(texts(suite.cases[1], 2),
             Catch::Contains("bad.csv:1003:7: column 'FLIM' holds 'twenty'"));
  CHECK_THAT(texts(suite.cases[2], 2), Catch::Contains("off by 1 N (limit 1e-09) at t = 1"));
}

TEST_CASE("what a listener throws ends the suite and arrives") {
  Suite suite;
  for (int i = 0; i < 20; ++i) suite.add("case" + std::to_string(i), slider(10));
  std::atomic<int> count{0};
  SuiteListener listener;
  listener.tell = [&](const Candidate&, CaseOutcome&&) {
    ++count;
    throw std::runtime_error("the disk is full");
  };
  CHECK_THROWS_WITH(run_suite(suite.cases, {}, {.threads = 3}, listener), "the disk is full");
  CHECK(count == 1);
}

TEST_CASE("progress counts every case once, and those that do not pass") {
  Suite suite;
  for (int i = 0; i < 6; ++i)
    suite.add("case" + std::to_string(i), slider(10, i == 3 ? "0.3" : "0.2"));
  terminal::WorkDone last;
  SuiteListener listener;
  listener.tell = [](const Candidate&, CaseOutcome&&) {};
  listener.progress = [&](const terminal::WorkDone& work) { last = work; };
  run_suite(suite.cases, {}, {.threads = 2}, listener);
  CHECK(last.done == 6);
  CHECK(last.total == 6);
  CHECK(last.failed == 1);
}

TEST_CASE("every index is worked on once, by however many threads") {
  for (const unsigned threads : {1U, 3U, 50U}) {
    std::vector<std::atomic<int>> counts(40);
    base::for_each_index(counts.size(), threads, [&](std::size_t i) { ++counts[i]; });
    for (const auto& count : counts) CHECK(count == 1);
  }
  base::for_each_index(0, 4, [](std::size_t) { FAIL("there is nothing to do"); });
}

}  // namespace
}  // namespace slipbench::driver::suite
