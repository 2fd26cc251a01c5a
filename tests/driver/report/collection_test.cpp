// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

#include "driver/report/report.hpp"

namespace slipbench::driver::report {
namespace {

/// A case with one row; every tenth fails.
CaseReport numbered(std::size_t place) {
  CaseReport report;
  report.name = std::to_string(place);
  report.status = place % 10 == 9 ? ReportStatus::kFailed : ReportStatus::kPassed;
  report.columns = {{"t", "s", ""}};
  report.drawn.rows = {{0}, {0.0}};
  report.checks.resize(1);
  return report;
}

std::vector<bool> detailed(std::span<const CaseReport> cases) {
  std::vector<bool> all;
  for (const CaseReport& one : cases) all.push_back(one.has_details);
  return all;
}

TEST_CASE("failed cases keep their curves before others, whatever the order they come in") {
  constexpr std::size_t kCases = 1000;
  std::vector<std::size_t> order(kCases);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random(3);
  std::vector<bool> first;
  for (int trial = 0; trial < 5; ++trial) {
    ReportCollection collection(kCases);
    for (const std::size_t place : order) collection.put(place, numbered(place));
    const std::vector<bool> kept = detailed(collection.cases());
    CHECK(std::count(kept.begin(), kept.end(), true) == ReportCollection::kMostDetailed);
    for (std::size_t i = 9; i < kCases; i += 10) CHECK(kept[i]);
    // The 100 failed ones leave room for the first 100 others: up to the case of number 110.
    CHECK(kept[110]);
    CHECK_FALSE(kept[111]);
    if (trial == 0) first = kept;
    CHECK(kept == first);
    std::shuffle(order.begin(), order.end(), random);
  }
}

TEST_CASE("cases that turn out not to be run push out nobody's curves, whatever came before") {
  // A suite that ends with its first failure, at the place 250; other threads were further.
  constexpr std::size_t kCases = 400;
  constexpr std::size_t kEnd = 251;
  const auto kept = [](std::size_t further) {
    ReportCollection collection(kCases);
    for (std::size_t i = kCases; i-- > 0;) {
      if (i >= kEnd + further) continue;
      CaseReport report = numbered(i);
      report.status = i >= kEnd - 1 ? ReportStatus::kFailed : ReportStatus::kPassed;
      collection.put(i, std::move(report));
    }
    for (std::size_t i = kEnd; i < kCases; ++i) {
      CaseReport report;
      report.status = ReportStatus::kNotRun;
      collection.put(i, std::move(report));
    }
    const std::vector<bool> all = detailed(collection.cases());
    return std::vector<bool>(all.begin(), all.begin() + kEnd);
  };
  const std::vector<bool> alone = kept(0);
  CHECK(std::count(alone.begin(), alone.end(), true) == ReportCollection::kMostDetailed);
  CHECK(alone[kEnd - 1]);
  CHECK(kept(1) == alone);
  CHECK(kept(149) == alone);
}

TEST_CASE("a case without its curves still has its verdicts") {
  CaseReport report = numbered(0);
  report.drop_details();
  CHECK(report.drawn.rows.numbers.empty());
  CHECK(report.checks.size() == 1);
  CHECK(report.row_count() == 0);
}

TEST_CASE("cases may come from several threads, and are counted") {
  constexpr std::size_t kCases = 400;
  ReportCollection collection(kCases);
  std::vector<std::jthread> threads;
  for (std::size_t t = 0; t < 4; ++t) {
    threads.emplace_back([&collection, t] {
      for (std::size_t i = t; i < kCases; i += 4) collection.put(i, numbered(i));
    });
  }
  threads.clear();
  const ReportTotals totals = collection.totals();
  CHECK(totals.cases == kCases);
  CHECK(totals.failed == 40);
  CHECK(totals.passed == 360);
  CHECK(totals.checks == kCases);
  CHECK(collection.cases()[17].name == "17");
}

TEST_CASE("the size of a page is told in kB and MB") {
  CHECK(size_text(812) == "1 kB");
  CHECK(size_text(12345) == "12 kB");
  CHECK(size_text(812345) == "0.8 MB");
  CHECK(size_text(4912345) == "4.9 MB");
}

}  // namespace
}  // namespace slipbench::driver::report
