// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/packed_run.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "driver/sweep/read_sweep.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::sweep {
namespace {

const std::string kHead = "slipbench: 1\nunits: {length: mm, force: N, time: s}\n";

/// Constants only; the second step drives one of the forces again.
const std::string kSlot =
    kHead +
    "parameters: {mu: 0.2, grip: 10, load: 50, k: 1.0e4, twice: = 2*mu, part: = twice/4 + mu/2}\n"
    "connector: {type: SLOT}\n"
    "friction: [{predefined: {internal_contact_force: = grip}, coefficient: = part,\n"
    "            stick: {stiffness: = k}}]\n"
    "history:\n"
    "  - {step: first, duration: 1.5, increments: 60, force: {f2: = load, f3: 20},\n"
    "     motion: {CP1: {sine: {amplitude: 1, frequency: 1}}}}\n"
    "  - {step: again, duration: 1.5, increments: 60, repeat: 2,\n"
    "     motion: {CP1: {triangle: {amplitude: 0.1, frequency: 2}}}}\n"
    "  - {step: other, increments: 20, force: {f2: = 2*grip - load}, motion: {CP1: {to: 3}}}\n"
    "  - {step: end, increments: 20, force: {f2: {sine: {amplitude: 5, frequency: 2}}, f3: = "
    "load}, motion: {CP1: {to: 0}}}\n"
    "checks: [{name: limit, quantity: FLIM, against: {expression: = mu*load},\n"
    "          tolerance: {relative: 10, why: none}}]\n";

/// Two components, tables, an elastic slip, and fields that change.
const std::string kPlane =
    kHead +
    "parameters: {ms: 1, fs: 1, slip: 0.01, most: 400, load: 500}\n"
    "connector: {type: SLIDE-PLANE}\n"
    "friction:\n"
    "  - predefined:\n"
    "      internal_contact_force:\n"
    "        columns: [force, accumulated_slip]\n"
    "        rows: [[= 100*fs, 0], [= 95*fs, 1], [= 80*fs, 5], [60, 50]]\n"
    "    coefficient:\n"
    "      columns: [mu, slip_rate, field1]\n"
    "      rows: [[= 0.30*ms, 0, 0], [= 0.2*ms, 5, 0], [= 0.25*ms, 0, 9], [= 0.1*ms, 5, 9]]\n"
    "    stick: {elastic_slip: = slip}\n"
    "    force_limit: = most\n"
    "integration: {slip_rate: relative_motion, accumulated_slip: start}\n"
    "history:\n"
    "  - step: cycles\n"
    "    duration: 3\n"
    "    increments: 150\n"
    "    force: {f1: {sine: {amplitude: 200, frequency: 0.31, mean: 100}}}\n"
    "    fields: {field1: {to: 9}}\n"
    "    motion: {CP2: {sine: {amplitude: 1, frequency: 1}}, CP3: {to: 1}}\n"
    "  - {step: press, increments: 20, force: {f1: = load}, motion: {CP2: {to: -1}}}\n";

struct Written {
  TemporaryFolder folder;
  ReadSweep read;

  Written(const std::string& problem, const std::string& keys,
          std::vector<base::ParameterText> settings = {}) {
    folder.write("c.yaml", problem);
    const auto file = folder.write("s.yaml", "slipbench: 1\nsweep:\n  case: c.yaml\n" + keys);
    read = read_sweep(file.string(), {.overrides = std::move(settings)});
    std::string errors;
    for (const base::Diagnostic& one : read.diagnostics.sorted()) {
      errors += one.path + ": " + one.message + "\n";
    }
    INFO(errors);
    REQUIRE(read.value.has_value());
  }
  const Sweep& sweep() const { return *read.value; }
};

/// All that comes out of a sweep, by its bits.
struct Outcome {
  std::vector<std::uint64_t> bits;
  std::vector<std::string> failures;
  std::size_t failed = 0;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome outcome(const Sweep& sweep, const SweepOptions& options) {
  Outcome all;
  run_sweep(sweep, options, [&](const SampleOutcome& one) {
    for (const double value : one.values) all.bits.push_back(std::bit_cast<std::uint64_t>(value));
    for (const double number : one.numbers) {
      all.bits.push_back(std::isnan(number) ? 0 : std::bit_cast<std::uint64_t>(number));
    }
    all.failures.emplace_back(one.failure);
    if (!one.failure.empty()) ++all.failed;
  });
  return all;
}

/// Compares packs with single runs; returns how many samples fail.
std::size_t compare(const Sweep& sweep) {
  REQUIRE(packed_run(sweep) != nullptr);
  const Outcome alone = outcome(sweep, {.packs = false});
  CHECK(outcome(sweep, {.threads = 1}) == alone);
  CHECK(outcome(sweep, {.threads = 2}) == alone);
  CHECK(outcome(sweep, {.threads = 4, .chunk = 50}) == alone);
  const std::size_t half = sweep.samples / 2;
  Outcome parts = outcome(sweep, {.end = half});
  const Outcome rest = outcome(sweep, {.threads = 3, .first = half});
  parts.bits.insert(parts.bits.end(), rest.bits.begin(), rest.bits.end());
  parts.failures.insert(parts.failures.end(), rest.failures.begin(), rest.failures.end());
  parts.failed += rest.failed;
  CHECK(parts == alone);
  return alone.failed;
}

const std::string kAll =
    "  collect:\n    {largest: {max: CSF1}, smallest: {min: CSF1}, size: {magnitude: CSF1}, end: "
    "{last: "
    "CSF1},\n     limit: {min: FLIM}, end_limit: {last: FLIM}, used: {max: MU}, status: {last: "
    "STATUS},\n     lost: {last: DISS}, first_loss: {min: DISS}, way: {last: CASU1}, total: {max: "
    "CTF1},\n     slips: {count: stick_to_slip}, sticks: {count: slip_to_stick}}\n";
const std::string kVarySlot =
    "  vary: {mu: {uniform: [0.1, 0.3]}, grip: {normal: [10, 1]}, load: {uniform: [-80, 80]},\n"
    "         k: {loguniform: [100, 10000]}}\n  samples: 300\n";

TEST_CASE("samples in packs have the bits of their own runs: constants, forces of steps") {
  const Written written(kSlot, kVarySlot + kAll);
  CHECK(compare(written.sweep()) == 0);
}

TEST_CASE("samples in packs have the bits of their own runs: tables, two components, fields") {
  const Written written(
      kPlane,
      "  vary: {ms: {uniform: [0.8, 1.2]}, fs: {normal: [1, 0.05]},\n"
      "         slip: {loguniform: [0.001, 0.1]}, most: {uniform: [20, 500]},\n"
      "         load: {uniform: [-100, 500]}}\n"
      "  sampler: random\n  samples: 200\n"
      "  collect: {two: {magnitude: CSF2}, three: {max: CSF3}, limit: {max: FLIM},\n"
      "            way: {last: CASUC}, mu: {min: MU}, lost: {max: DISS},\n"
      "            slips: {count: stick_to_slip}}\n");
  CHECK(compare(written.sweep()) == 0);
}

/// Replaces a part of a text.
std::string with(std::string text, const std::string& part, const std::string& other) {
  const std::size_t at = text.find(part);
  REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), other);
}

TEST_CASE("a formula that stands in several places is varied in each of them") {
  std::string same =
      with(kPlane, "[= 0.2*ms, 5, 0], [= 0.25*ms, 0, 9]", "[= 0.30*ms, 5, 0], [= 0.1*ms, 0, 9]");
  same = with(same, "[= 95*fs, 1]", "[= 100*fs, 1]");
  const Written written(
      same,
      "  vary: {ms: {uniform: [0.8, 1.2]}, fs: {normal: [1, 0.05]}}\n"
      "  samples: 100\n  collect: {two: {magnitude: CSF2}, limit: {max: FLIM}}\n");
  CHECK(compare(written.sweep()) == 0);
}

TEST_CASE("samples that the reader refuses fail beside packs with its sentence") {
  const Written written(kSlot, with(kVarySlot, "[0.1, 0.3]", "[-0.1, 0.3]") + kAll);
  CHECK(compare(written.sweep()) > 30);
  const Outcome all = outcome(written.sweep(), {});
  std::size_t worded = 0;
  for (const std::string& failure : all.failures) {
    if (failure.starts_with("friction[0].coefficient: must be at least 0, found -0.")) ++worded;
  }
  CHECK(worded == all.failed);
}

TEST_CASE("numbers that are set follow into packs") {
  const Written written(kSlot, with(kVarySlot, "grip: {normal: [10, 1]}, ", "") + kAll,
                        {{"grip", "= 50*mu"}, {"twice", 0.3}});
  CHECK(compare(written.sweep()) == 0);
}

TEST_CASE("a measured history is walked once for all samples") {
  TemporaryFolder folder;
  folder.write("m.csv", "t,x,N\n0,0,50\n1,0.1,40\n2,-0.3,60\n3,0.2,10\n4,0.3,-20\n");
  folder.write("c.yaml",
               kHead +
                   "parameters: {mu: 0.2, k: 1.0e4}\nconnector: {type: SLOT}\n"
                   "friction: [{predefined: {}, coefficient: = mu, stick: {stiffness: = k}}]\n"
                   "history: {csv: m.csv, time: t, columns: {CP1: x, f2: N}}\n");
  const auto file = folder.write(
      "s.yaml",
      "slipbench: 1\nsweep:\n  case: c.yaml\n  vary: {mu: {uniform: [0.1, 0.3]}, k: {uniform: "
      "[100, 300]}}\n  samples: 100\n  collect: {end: {last: CSF1}, lost: {last: DISS}}\n");
  const ReadSweep read = read_sweep(file.string());
  REQUIRE(read.value.has_value());
  CHECK(compare(*read.value) == 0);
}

TEST_CASE("forces of steps act until the next that drives their component, in packs as alone") {
  const Written written(
      with(kSlot, "again, duration: 1.5", "again, force: {f3: = load/2}, duration: 1.5"),
      kVarySlot + kAll);
  CHECK(compare(written.sweep()) == 0);
}

TEST_CASE("a pack of many steps knows at once which forces act in them") {
  // Each varied force, in each step, with all the steps in between would be 10^11 comparisons.
  std::string problem =
      kHead +
      "parameters: {mu: 0.2, load: 50}\nconnector: {type: SLOT}\n"
      "friction: [{predefined: {}, coefficient: = mu, stick: {stiffness: 1000}}]\n"
      "history:\n  - {step: s, increments: 1, motion: {CP1: {to: 1}}, force: &f {f2: = load}}\n";
  for (int i = 0; i < 8000; ++i) {
    problem += "  - {step: s" + std::to_string(i) + ", increments: 1, force: *f}\n";
  }
  const Written written(problem,
                        "  vary: {load: {uniform: [90, 110]}}\n  samples: 64\n"
                        "  collect: {end: {last: CSF1}}\n");
  CHECK(packed_run(written.sweep()) != nullptr);
}

TEST_CASE("formulas of checks are told from those of a run by their paths, however many") {
  // Each of 100,000 with all others would be 10^10 comparisons.
  std::string list = "[= 2*mu";
  for (int i = 1; i < 1000; ++i) list += ", = 2*mu";
  list += "]";
  std::string problem =
      kHead +
      "parameters: {mu: 0.2, load: 50}\nconnector: {type: SLOT}\n"
      "friction: [{predefined: {}, coefficient: = mu, stick: {stiffness: 1000}}]\n"
      "history: [{step: s, increments: 4, motion: {CP1: {to: 1}}, force: {f2: = load}}]\nchecks:\n";
  const std::string first = "&w {stick_stiffnesses: " + list + ", limits: " + list + "}";
  for (int i = 0; i < 50; ++i) {
    problem += "  - {name: c" + std::to_string(i) +
               ", quantity: CSF1, tolerance: {absolute: 9, why: none},\n"
               "     against: {closed_form: parallel_sliders, with: " +
               (i == 0 ? first : "*w") + "}}\n";
  }
  const Written written(problem,
                        "  vary: {load: {uniform: [90, 110]}}\n  samples: 64\n"
                        "  collect: {end: {last: CSF1}}\n");
  CHECK(packed_run(written.sweep()) != nullptr);
}

TEST_CASE("a sweep goes alone where a sample is more than the numbers of one definition") {
  const auto packs = [](const std::string& problem, const std::string& keys) {
    const Written written(problem, keys);
    CHECK(packed_run(written.sweep()) == nullptr);
    const Outcome alone = outcome(written.sweep(), {.packs = false});
    return outcome(written.sweep(), {.threads = 2}) == alone;
  };
  const std::string keys = with(kVarySlot, "samples: 300", "samples: 70") + kAll;
  CHECK(packs(kSlot, with(keys, "count: stick_to_slip", "count: reversal")));
  CHECK(packs(kSlot, with(keys, "last: FLIM", "last: '= 2*FLIM'")));
  CHECK(packs(kSlot, with(keys, "last: FLIM", "last: CP1")));
  // In the motion, a count, a tolerance, another dependent number.
  CHECK(packs(with(kSlot, "amplitude: 0.1", "amplitude: = mu"), keys));
  CHECK(packs(
      with(kSlot, "duration: 1.5, increments: 60, repeat", "duration: = mu, increments: 9, repeat"),
      keys));
  CHECK(packs(with(kSlot, "relative: 10", "relative: = mu"), keys));
  CHECK(packs(with(kSlot, "f3: 20", "f3: '= load*sin(t)'"), keys));
  // A force that sets out from one of its own.
  CHECK(packs(with(kSlot, "{sine: {amplitude: 5, frequency: 2}}", "{to: 5}"), keys));
  CHECK(packs(with(kSlot, "stiffness: = k", "characteristic_length: = k"), keys));
}

TEST_CASE("packs of another case are seen not to agree") {
  const Written written(kSlot, kVarySlot + kAll);
  const Written other(with(kSlot, "repeat: 2", "repeat: 3"), kVarySlot + kAll);
  const auto packed = PackedRun::make(other.sweep());
  REQUIRE(packed != nullptr);
  CHECK(agrees(other.sweep(), *packed));
  CHECK_FALSE(agrees(written.sweep(), *packed));
}

}  // namespace
}  // namespace slipbench::driver::sweep
