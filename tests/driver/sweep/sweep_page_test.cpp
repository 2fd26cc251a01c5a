// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/report/sweep_page.hpp"

#include <catch2/catch.hpp>
#include <regex>
#include <string>

#include "driver/sweep/read_sweep.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/driver/sweep/sweep_for_test.hpp"

namespace slipbench::driver::sweep {
namespace {

std::string page_of(const std::string& keys, const std::string& title = "A study") {
  const TemporaryFolder folder;
  folder.write("slot.yaml", kSlot);
  const auto file = folder.write(
      "s.yaml", "slipbench: 1\ntitle: \"" + title + "\"\nsweep:\n  case: slot.yaml\n" + keys);
  const ReadSweep read = read_sweep(file.string());
  REQUIRE(read.value.has_value());
  const Sweep& sweep = *read.value;
  SweepSummary summary(sweep);
  std::optional<SobolEstimate> indices;
  if (sweep.sobol_indices) indices.emplace(sweep);
  KeptSamples kept(sweep);
  run_sweep(sweep, {}, [&](const SampleOutcome& one) {
    summary.add(one);
    if (indices) indices->add(one);
    kept.add(one);
  });
  return sweep_page(sweep, summary, indices, kept);
}

std::size_t count(const std::string& text, const std::string& pattern) {
  const std::regex wanted(pattern);
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), wanted), {}));
}

const std::string kVaried = "  vary: {mu: {uniform: [0.1, 0.3]}, k: {loguniform: [100, 1000]}}\n";
const std::string kCollected =
    "  collect: {end: {last: CSF1}, place: {last: CP1}, most: {max: '= CSF1*2'}}\n";

TEST_CASE("The page of a sweep shows each number, its extremes and the matrix") {
  const std::string page = page_of(kVaried + "  samples: 500\n" + kCollected);
  CHECK_THAT(page, Catch::StartsWith("<!doctype html>") &&
                       Catch::Contains("<title>A study</title>") &&
                       Catch::Contains("500 samples of slot.yaml") &&
                       Catch::Contains("in every sample that has a value (500)") &&
                       Catch::Contains("All 500 samples.") && Catch::Contains("(logarithmic)"));
  CHECK(count(page, "class=\"histogram\"") == 2);
  CHECK(count(page, "class=\"tornado\"") == 2);
  CHECK(count(page, "class=\"scatter\"") == 4);
  // A dot a sample in each cell of the matrix.
  CHECK(count(page, "h0") == 2000);
  CHECK(count(page,
              "<code>slipbench run /[^ ]*/slot.yaml --set mu=[0-9.]+ --set k=[0-9.]+</code>") == 4);
  CHECK(count(page, "<script|https?://|nan|inf\\b") == 0);
}

TEST_CASE("The page says what it leaves out") {
  const std::string page = page_of(kVaried + "  samples: 5000\n" + kCollected);
  CHECK_THAT(page, Catch::Contains("Every 4th of 5000 samples: 1250 dots."));
  CHECK(count(page, "h0") == 5000);
}

TEST_CASE("The page shows Sobol' indices where they are wanted, and escapes what it is told") {
  const std::string page =
      page_of(kVaried + "  sobol_indices: true\n  samples: 300\n" + kCollected, "a <b> & c");
  CHECK_THAT(page, Catch::Contains("Parts of the variance") &&
                       Catch::Contains("a &lt;b&gt; &amp; c") && !Catch::Contains("<b> & c"));
  CHECK(count(page, "class=\"alone\"") == 4);
}

TEST_CASE("The page tells of samples that failed") {
  const std::string page = page_of(
      "  vary: {mu: {uniform: [-0.1, 0.3]}}\n  samples: 40\n  collect: {end: {last: CSF1}}\n");
  CHECK_THAT(page, Catch::Contains("of 40 samples failed, the first is"));
  CHECK(count(page, "nan") == 0);
}

}  // namespace
}  // namespace slipbench::driver::sweep
