// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/run_sweep.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "driver/sweep/read_sweep.hpp"
#include "driver/sweep/sweep_summary.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/driver/sweep/sweep_for_test.hpp"

namespace slipbench::driver::sweep {
namespace {

struct Written {
  TemporaryFolder folder;
  std::string file;

  explicit Written(const std::string& keys) {
    folder.write("slot.yaml", kSlot);
    file = folder.write("s.yaml", "slipbench: 1\nsweep:\n  case: slot.yaml\n" + keys).string();
  }
  ReadSweep read() const { return read_sweep(file); }
  /// The errors, one a line.
  std::string errors() const {
    std::string text;
    for (const base::Diagnostic& one : read().diagnostics.sorted()) {
      text += one.path + ": " + one.message + "\n";
    }
    return text;
  }
};

struct Row {
  std::vector<double> values, numbers;
  std::string failure;
  friend bool operator==(const Row& a, const Row& b) {
    return a.values == b.values && a.numbers == b.numbers && a.failure == b.failure;
  }
};

std::vector<Row> rows_of(const Sweep& sweep, const SweepOptions& options = {}) {
  std::vector<Row> rows;
  run_sweep(sweep, options, [&](const SampleOutcome& outcome) {
    CHECK(outcome.id == options.first + rows.size());
    rows.push_back({{outcome.values.begin(), outcome.values.end()},
                    {outcome.numbers.begin(), outcome.numbers.end()},
                    std::string(outcome.failure)});
  });
  return rows;
}

const std::string kKeys =
    "  vary: {mu: {uniform: [0.1, 0.3]}, k: {loguniform: [100, 1000]}}\n"
    "  samples: 3000\n"
    "  collect: {end: {last: CSF1}, most: {max: '= 2*CSF1'}, slips: {count: stick_to_slip},\n"
    "            back: {min: CSF1}, size: {magnitude: '= -CSF1'}}\n";

TEST_CASE("What is collected is what the closed form says, for every sample") {
  const Written written(kKeys);
  const ReadSweep read = written.read();
  INFO(written.errors());
  REQUIRE(read.value.has_value());
  const std::vector<Row> rows = rows_of(*read.value);
  REQUIRE(rows.size() == 3000);
  int sticking = 0;
  for (const Row& row : rows) {
    const double limit = 100.0 * row.values[0];
    const double spring = 0.1 * row.values[1];
    const double force = std::min(limit, spring);
    REQUIRE(row.failure.empty());
    REQUIRE(row.numbers[0] == Approx(force).epsilon(1e-12));  // rounding of ten increments
    REQUIRE(row.numbers[1] == Approx(2.0 * force).epsilon(1e-12));
    REQUIRE(row.numbers[2] == (spring > limit ? 1.0 : 0.0));
    REQUIRE(row.numbers[3] == 0.0);
    REQUIRE(row.numbers[4] == row.numbers[0]);
    if (spring < limit) ++sticking;
  }
  CHECK(sticking > 300);
  CHECK(sticking < 2700);
}

TEST_CASE("Threads and parts change nothing") {
  const Written written(kKeys);
  const ReadSweep read = written.read();
  REQUIRE(read.value.has_value());
  const std::vector<Row> whole = rows_of(*read.value);
  const auto same = [&](const std::vector<Row>& rows) {
    REQUIRE(rows.size() == whole.size());
    const auto [mine, other] = std::mismatch(rows.begin(), rows.end(), whole.begin());
    INFO("sample " << mine - rows.begin());
    CHECK(mine == rows.end());
    if (mine == rows.end()) return;
    CHECK(mine->failure == other->failure);
    CHECK(mine->values == other->values);
    CHECK(mine->numbers == other->numbers);
  };
  same(rows_of(*read.value, {.threads = 3}));
  std::vector<Row> parts = rows_of(*read.value, {.end = 1100});
  for (const Row& row : rows_of(*read.value, {.threads = 2, .first = 1100})) parts.push_back(row);
  same(parts);
}

TEST_CASE("A sample that fails leaves nan and its reason, and the others are run") {
  const Written written(
      "  sampler: grid\n  vary: {mu: {grid: [0.2, -0.1, 0.3]}}\n  collect: {end: {last: CSF1}}\n");
  ReadSweep read = written.read();
  // -0.1 stands in the middle of the list: the sweep is refused where all of it must be wrong.
  CHECK_FALSE(read.value.has_value());
  const Written other(
      "  sampler: grid\n  vary: {mu: {grid: [-0.1, 0.2, 0.3]}}\n  collect: {end: {last: CSF1}}\n");
  read = other.read();
  REQUIRE(read.value.has_value());
  const std::vector<Row> rows = rows_of(*read.value);
  REQUIRE(rows.size() == 3);
  CHECK(std::isnan(rows[0].numbers[0]));
  CHECK_THAT(rows[0].failure, Catch::Matchers::Contains("must be at least 0, found -0.1"));
  CHECK(rows[1].numbers[0] == Approx(20.0).epsilon(1e-12));
  SweepSummary summary(*read.value);
  run_sweep(*read.value, {}, [&](const SampleOutcome& outcome) { summary.add(outcome); });
  CHECK(summary.failed() == 1);
  CHECK(summary.text().find("mean 25, standard deviation 7.071, from 20 (sample 1) to 30 (sample "
                            "2)") != std::string::npos);
  // Of two samples a correlation says nothing.
  CHECK(summary.text().find("correlation") == std::string::npos);
  CHECK(summary.text().find("1 of 3 samples failed, the first is 0") != std::string::npos);
}

TEST_CASE("What is the same in every sample has no spread and no correlation") {
  const Written written(
      "  vary: {mu: {uniform: [0.1, 0.3]}}\n  samples: 5\n  collect: {place: {last: CP1}}\n");
  const ReadSweep read = written.read();
  REQUIRE(read.value.has_value());
  SweepSummary summary(*read.value);
  run_sweep(*read.value, {}, [&](const SampleOutcome& outcome) { summary.add(outcome); });
  CHECK(summary.text() == "  place: 0.1 in every sample\n");
}

TEST_CASE("Numbers may carry units, which are converted to the case's") {
  const Written written(
      "  sampler: grid\n  vary: {k: {grid: [100 N/mm, 0.5 kN/mm]}}\n  collect: {end: {last: "
      "CSF1}}\n");
  const ReadSweep read = written.read();
  INFO(written.errors());
  REQUIRE(read.value.has_value());
  CHECK(read.value->varied[0].distribution.numbers == std::vector<double>{100.0, 500.0});
}

TEST_CASE("Faults of a sweep file are told where they are") {
  const auto errors = [](const std::string& keys) { return Written(keys).errors(); };
  const std::string collect = "  samples: 10\n  collect: {end: {last: CSF1}}\n";
  CHECK(errors("  vary: {nu: {uniform: [0, 1]}}\n" + collect) ==
        "sweep.vary.nu: the case has no parameter 'nu'\n");
  CHECK(errors("  vary: {mu: {uniform: [1, 0]}}\n" + collect) ==
        "sweep.vary.mu.uniform: the first number must be below the second\n");
  CHECK(errors("  vary: {mu: {loguniform: [0, 1]}}\n" + collect) ==
        "sweep.vary.mu.loguniform: only numbers greater than 0 have a logarithm\n");
  CHECK(errors("  vary: {mu: {normal: [1, 0]}}\n" + collect) ==
        "sweep.vary.mu.normal: the standard deviation must be greater than 0\n");
  CHECK(errors("  vary: {mu: {uniform: [0, 1], grid: [1]}}\n" + collect) ==
        "sweep.vary.mu: wants one of 'uniform', 'loguniform', 'normal' and 'grid'\n");
  CHECK(errors("  sampler: grid\n  vary: {mu: {uniform: [0, 1]}}\n" + collect)
            .find("takes lists only") != std::string::npos);
  CHECK(errors("  sampler: grid\n  vary: {mu: {grid: [0.1, 0.2]}}\n" + collect) ==
        "sweep.samples: the grid has 2 combinations\n");
  CHECK(errors("  vary: {mu: {uniform: [0, 1]}}\n  collect: {end: {last: CSF1}}\n")
            .find("'samples' is missing") != std::string::npos);
  const std::string vary = "  vary: {mu: {uniform: [0.1, 0.3]}}\n  samples: 10\n";
  CHECK(errors(vary + "  collect: {end: {last: CSF7}}\n").find("sweep.collect.end.last: ") == 0);
  CHECK(errors(vary + "  collect: {mu: {last: CSF1}}\n") ==
        "sweep.collect.mu: another column of the result is called so as well\n");
  CHECK(
      errors(vary + "  collect: {end: {last: CSF1, count: reversal}}\n") ==
      "sweep.collect.end: wants one of 'max', 'min', 'magnitude', 'last', 'count', 'loop_energy', "
      "'quantile' and 'first_passage'\n");
  CHECK(errors(vary + "  collect: {}\n") == "sweep.collect: nothing is collected\n");
}

TEST_CASE("Quantiles and first passages are those of a ramp that ends in slip") {
  // Ten increments of 10 N each, up to 20 N.
  const Written written(
      "  vary: {mu: {grid: [0.2]}, k: {grid: [1000]}}\n  sampler: grid\n"
      "  collect: {tenth: {quantile: {of: CSF1, part: 0.1}}, more: {quantile: {of: CSF1, part: "
      "0.11}},\n"
      "            rises: {first_passage: {of: CSF1, above: 5}},\n"
      "            falls: {first_passage: {of: '= -CSF1', below: -12.5}},\n"
      "            at_once: {first_passage: {of: CSF1, below: 3}},\n"
      "            never: {first_passage: {of: CSF1, above: 20.001}}, loop: {loop_energy: "
      "last}}\n");
  const ReadSweep read = written.read();
  INFO(written.errors());
  REQUIRE(read.value.has_value());
  const std::vector<Row> rows = rows_of(*read.value);
  REQUIRE(rows.size() == 1);
  const std::vector<double>& found = rows[0].numbers;
  CHECK(found[0] == Approx(10.0).epsilon(1e-12));
  CHECK(found[1] == Approx(20.0).epsilon(1e-12));
  CHECK(found[2] == Approx(0.05).epsilon(1e-12));
  CHECK(found[3] == Approx(0.125).epsilon(1e-12));
  CHECK(found[4] == 0.0);
  CHECK(std::isnan(found[5]));
  CHECK(std::isnan(found[6]));
  CHECK(rows[0].failure.empty());
}

TEST_CASE("The energy of a loop is that of a parallelogram") {
  const Written written(
      "  vary: {mu: {uniform: [0.1, 0.3]}}\n  samples: 20\n"
      "  collect: {first: {loop_energy: first}, last: {loop_energy: last}}\n");
  written.folder.write(
      "slot.yaml",
      "slipbench: 1\nunits: {length: mm, force: N, time: s}\nparameters: {mu: 0.2}\n"
      "connector: {type: SLOT}\n"
      "friction: [{predefined: {}, coefficient: = mu, stick: {stiffness: 1000}}]\n"
      "history: [{step: go, duration: 3, increments: 300, force: {f2: 100},\n"
      "  motion: {CP1: {triangle: {amplitude: 0.1, frequency: 1}}}}]\n");
  const ReadSweep read = written.read();
  INFO(written.errors());
  REQUIRE(read.value.has_value());
  for (const Row& row : rows_of(*read.value)) {
    const double limit = 100.0 * row.values[0];
    const double loop = 4.0 * limit * (0.1 - limit / 1000.0);
    // The corners lie inside increments, which book the work by the trapezoid in stick and slip.
    CHECK(row.numbers[1] == Approx(loop).epsilon(0.01));
    // The first cycle begins and ends in the middle: unloaded, and loaded the other way.
    CHECK(row.numbers[0] == Approx(loop - limit * limit / 1000.0).epsilon(0.01));
  }
}

TEST_CASE("Samples come from the columns of a file, in its order") {
  const Written written(
      "  csv: {file: drawn.csv, decimal: ','}\n  samples: 2\n"
      "  collect: {end: {last: CSF1}}\n");
  written.folder.write("drawn.csv", "k;id;mu\n1000;7;0,2\n200;5;0,3\n100;1;0,3\n");
  const ReadSweep read = written.read();
  INFO(written.errors());
  REQUIRE(read.value.has_value());
  const std::vector<Row> rows = rows_of(*read.value);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].values == std::vector<double>{1000.0, 0.2});
  CHECK(rows[1].values == std::vector<double>{200.0, 0.3});
  CHECK(rows[0].numbers[0] == Approx(20.0).epsilon(1e-12));
  CHECK(rows[1].numbers[0] == Approx(20.0).epsilon(1e-12));
  const std::vector<std::string>& files = read.data_files;
  CHECK(std::any_of(files.begin(), files.end(),
                    [](const std::string& file) { return file.ends_with("drawn.csv"); }));
  SweepOptions second;
  second.first = 1;
  CHECK(rows_of(*read.value, second) == std::vector<Row>{rows[1]});
}

TEST_CASE("A wrong row of a file fails by itself, wherever it stands") {
  for (const std::string rows : {"-0.2\n0.2\n0.3\n", "0.2\n-0.2\n0.3\n", "0.2\n0.3\n-0.2\n"}) {
    INFO(rows);
    const Written written("  csv: drawn.csv\n  collect: {end: {last: CSF1}}\n");
    written.folder.write("drawn.csv", "mu\n" + rows);
    const ReadSweep read = written.read();
    REQUIRE(read.value.has_value());
    int failed = 0;
    for (const Row& row : rows_of(*read.value)) {
      CHECK(row.failure.empty() == (row.values[0] > 0.0));
      failed += row.failure.empty() ? 0 : 1;
    }
    CHECK(failed == 1);
  }
  const Written all_wrong("  csv: drawn.csv\n  collect: {end: {last: CSF1}}\n");
  all_wrong.folder.write("drawn.csv", "mu\n-1\n-2\n");
  CHECK_THAT(all_wrong.errors(), Catch::Contains("at least 0"));
}

TEST_CASE("A quantile at a tie is the lower value, whatever the rounding") {
  for (const int count : {10, 20, 30, 70}) {
    const Written written("  vary: {mu: {grid: [1000]}}\n  sampler: grid\n  collect: {\n" + [&] {
      std::string all;
      for (int k = 1; k < count; ++k) {
        all += "    q" + std::to_string(k) +
               ": {quantile: {of: CSF1, part: " + std::to_string(static_cast<double>(k) / count) +
               "}},\n";
      }
      return all;
    }() + "    last: {last: CSF1}}\n");
    std::string text = kSlot;
    text.replace(text.find("increments: 10"), 14,
                 "duration: 0.3, increments: " + std::to_string(count));
    written.folder.write("slot.yaml", text);
    const ReadSweep read = written.read();
    INFO(written.errors());
    REQUIRE(read.value.has_value());
    const std::vector<Row> rows = rows_of(*read.value);
    for (int k = 1; k < count; ++k) {
      INFO(k << " of " << count);
      // The ramp's k-th value; parts have six digits here, so not all are ties.
      const double part = std::stod(std::to_string(static_cast<double>(k) / count));
      const double rank = std::ceil(part * count * (1.0 - 1e-9));
      CHECK(rows[0].numbers[static_cast<std::size_t>(k - 1)] ==
            Approx(100.0 * rank / count).epsilon(1e-9));
    }
  }
}

TEST_CASE("What is wrong with a file of samples is told") {
  const std::string collect = "  collect: {end: {last: CSF1}}\n";
  const auto errors = [&](const std::string& keys, const std::string& csv) {
    const Written written(keys + collect);
    written.folder.write("drawn.csv", csv);
    return written.errors();
  };
  CHECK_THAT(errors("  csv: drawn.csv\n", "mu,kk\n0.2,3\n"),
             Catch::Contains("the case has no parameter 'kk'"));
  CHECK_THAT(errors("  csv: drawn.csv\n", "mu\n0.2\nx\n"), Catch::Contains("'x'"));
  CHECK_THAT(errors("  csv: drawn.csv\n", "id\n1\n"), Catch::Contains("no column of a parameter"));
  CHECK_THAT(errors("  csv: drawn.csv\n  samples: 3\n", "mu\n0.2\n0.3\n"),
             Catch::Contains("the file has 2 samples"));
  CHECK_THAT(errors("  csv: drawn.csv\n  vary: {mu: {grid: [1]}}\n", "mu\n0.2\n"),
             Catch::Contains("in place of 'vary'"));
  CHECK_THAT(errors("  csv: drawn.csv\n  sampler: sobol\n", "mu\n0.2\n"),
             Catch::Contains("'sampler' is csv"));
  CHECK_THAT(errors("  csv: other.csv\n", ""), Catch::Contains("cannot be opened"));
  CHECK_THAT(errors("  sampler: csv\n  vary: {mu: {grid: [1]}}\n", ""),
             Catch::Contains("wants a file of samples"));
  CHECK_THAT(errors("", ""), Catch::Contains("nothing is varied"));
}

TEST_CASE("Wrong quantiles, passages and loops are refused") {
  const auto errors = [](const std::string& one) {
    return Written("  vary: {mu: {grid: [0.2]}}\n  sampler: grid\n  collect: {a: " + one + "}\n")
        .errors();
  };
  CHECK_THAT(errors("{quantile: {of: CSF1, part: 1.5}}"), Catch::Contains("between 0 and 1"));
  CHECK_THAT(errors("{quantile: {of: CSF1}}"), Catch::Contains("part"));
  CHECK_THAT(errors("{quantile: {of: CSF9, part: 0.5}}"), Catch::Contains("CSF9"));
  CHECK_THAT(errors("{first_passage: {of: CSF1}}"),
             Catch::Contains("wants one of 'above' and 'below'"));
  CHECK_THAT(errors("{first_passage: {of: CSF1, above: 1, below: 2}}"),
             Catch::Contains("wants one of 'above' and 'below'"));
  CHECK_THAT(errors("{first_passage: {of: CSF1, above: 1}, max: CSF1}"),
             Catch::Contains("wants one of"));
  CHECK_THAT(errors("{loop_energy: middle}"), Catch::Contains("first or last"));
}

}  // namespace
}  // namespace slipbench::driver::sweep
