// SPDX-License-Identifier: Apache-2.0
// What a closed form is fed with: which columns, and from which row on.
#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "driver/check/check.hpp"
#include "driver/read/read_case.hpp"
#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::check {
namespace {

std::vector<Verdict> verdicts_of(const std::string& text) {
  const read::ReadCase read = read::read_case_text(base::SourceText("case.yaml", text), ".", {});
  INFO(base::render(read.diagnostics, read.sources));
  REQUIRE(read.value.has_value());
  std::vector<CheckProgress> checks;
  for (const cases::Check& check : read.value->checks) checks.emplace_back(*read.value, check);
  for (const bench::Row& row : bench::rows_of(*read.value)) {
    for (CheckProgress& check : checks) check.add(row);
  }
  std::vector<Verdict> verdicts;
  for (const CheckProgress& check : checks) verdicts.push_back(check.verdict());
  return verdicts;
}

void all_pass(const std::vector<Verdict>& verdicts, std::size_t count) {
  REQUIRE(verdicts.size() == count);
  for (const Verdict& verdict : verdicts) {
    INFO(verdict.name << ": " << verdict.message);
    CHECK(verdict.passed);
  }
}

TEST_CASE("a universal joint's closed form takes its angles from the positions, unasked") {
  // alpha starts at 0.5 and grows while gamma turns the other way; beta is held at 0.3. Neither
  // CUR1 = CPR1 - 0.5 nor CPR3 nor 0 gives the same moments. The same formula is evaluated twice:
  // rounding only.
  const std::string text =
      "slipbench: 1\n"
      "connector: {type: UJOINT, initial: {CPR1: 0.5, CPR2: 0.3, CPR3: -0.1}}\n"
      "friction:\n"
      "  - predefined: {R_p: 0.1, R_a: 0.08, L_s: 0.2, L_a: 1, internal_contact_moment_1: 1, "
      "internal_contact_moment_3: 2}\n"
      "    coefficient: 0.1\n"
      "    stick: {elastic_slip: 0.001}\n"
      "history:\n"
      "  - {step: turn, increments: 5, force: {f1: 100, f2: 50, f3: 20, m2: 8}, motion: {CPR1: "
      "{to: "
      "1.5}, CPR3: {to: -0.7}}}\n"
      "checks:\n"
      "  - name: axis 1\n"
      "    quantity: FN.axis1\n"
      "    against: {closed_form: contact_force_ujoint_1, with: {R_p: 0.1, R_a: 0.08, L_s: 0.2, "
      "L_a: 1, internal_contact_moment_1: 1, internal_contact_moment_3: 2}}\n"
      "    tolerance: {relative: 1.0e-12, why: rounding}\n"
      "  - name: axis 3\n"
      "    quantity: FN.axis3\n"
      "    against: {closed_form: contact_force_ujoint_3, with: {R_p: 0.1, R_a: 0.08, L_s: 0.2, "
      "L_a: 1, internal_contact_moment_1: 1, internal_contact_moment_3: 2}}\n"
      "    tolerance: {relative: 1.0e-12, why: rounding}\n";
  all_pass(verdicts_of(text), 2);
}

TEST_CASE("a closed form is fed from the first row of the run, whichever rows are compared") {
  // The path starts at 0.5, slips in the first step and sticks at the start of the second: force,
  // slip and energies at the compared rows hang on what came before. In one dimension the update
  // is exact; running totals of 20 N over 0.1 mm leave their rounding.
  std::string text =
      "slipbench: 1\n"
      "connector: {type: SLOT, initial: {CP1: 0.5}}\n"
      "friction:\n"
      "  - {predefined: {internal_contact_force: 100}, coefficient: 0.2, stick: {stiffness: "
      "1000}}\n"
      "history:\n"
      "  - {step: out, increments: 10, motion: {CP1: {to: 0.6}}}\n"
      "  - {step: back, increments: 20, motion: {CP1: {to: 0.58}}}\n"
      "  - {step: on, increments: 10, motion: {CP1: {to: 0.4}}}\n"
      "checks:\n";
  int count = 0;
  for (const char* rows : {"step: back", "over: {from: 1.5}", "over: {from: 3, to: 3}"}) {
    for (const char* quantity : {"CSF1", "CASU1", "DISS"}) {
      text += "  - name: check " + std::to_string(++count) + "\n    quantity: " + quantity +
              "\n    against: {closed_form: coulomb_slider, with: {mu: 0.2, normal_force: 100, "
              "stick_stiffness: 1000}}\n    " +
              rows + "\n    tolerance: {absolute: 1.0e-11, why: rounding}\n";
    }
  }
  all_pass(verdicts_of(text), 9);
}

}  // namespace
}  // namespace slipbench::driver::check
