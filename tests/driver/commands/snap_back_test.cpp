// SPDX-License-Identifier: Apache-2.0
// Wear that the stick spring cannot follow: what a user reads, writes and gets.
#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A limit that wears from 1500 N to 0 over 1 mm on a spring of 1000 N/mm: beta = 1.5. The spring
/// has 1125 mJ when it slips; friction takes 750 of them.
std::string worn(const std::string& integration) {
  return "slipbench: 1\n"
         "title: worn\n"
         "units: {length: mm, force: N, time: s}\n"
         "connector: {type: SLOT}\n"
         "friction:\n"
         "  - name: pad\n"
         "    internal_contact_force: {columns: [F, accumulated_slip], rows: [[6000, 0], [0, 1]]}\n"
         "    component: 1\n"
         "    coefficient: 0.25\n"
         "    stick: {stiffness: 1000}\n" +
         integration +
         "history:\n"
         "  - {step: out, duration: 3.0, increments: 12, motion: {CP1: {to: 3}}}\n";
}

const std::string kWarned =
    "worn.yaml:7:29: warning: friction[0].internal_contact_force: wear may fall faster than the "
    "stick stiffness can follow (snap-back): mu |F'| / k = 0.25 * 6000 / 1000 = 1.5 in the cell "
    "accumulated_slip = 0 .. 1; a run that meets 1 or more ends there; a stick.stiffness above "
    "1500 or a flatter table follows everywhere, 'integration: {snap_back: jump}' goes on behind "
    "the jump\n";

const std::string kStopped =
    "worn.yaml: numerical failure: step 'out', t = 1.75 (total time 1.75): definition 'pad': the "
    "force would jump at constant motion (snap-back): its wear falls faster than the stick "
    "stiffness can follow, mu |F'| / k = 1.5 in this increment where it must stay below 1; a "
    "stick.stiffness above 1500 N/mm follows it here, so does a flatter table; 'integration: "
    "{snap_back: jump}' goes on behind the jump and books the energy lost in it";

TEST_CASE("a run ends where the force would jump, with place, number and what to do") {
  const TemporaryFolder folder;
  folder.write("worn.yaml", worn(""));
  const Ended run = slipbench(folder, "run worn.yaml");
  INFO(run.output);
  CHECK(run.code == 3);
  CHECK(has(run.output, kWarned));
  CHECK(has(run.output, kStopped));
  CHECK_FALSE(has(run.output, "slip rate"));
  // A spring above that follows, and says nothing.
  folder.write("worn.yaml", worn("").replace(worn("").find("1000}"), 4, "1501"));
  const Ended stiffer = slipbench(folder, "run worn.yaml");
  INFO(stiffer.output);
  CHECK(stiffer.code == 0);
  CHECK_FALSE(has(stiffer.output, "snap-back"));
}

TEST_CASE("integration: {snap_back: jump} goes on, and names the energy lost") {
  const TemporaryFolder folder;
  folder.write("worn.yaml", worn("integration: {snap_back: jump}\n"));
  const Ended run = slipbench(folder, "run worn.yaml");
  INFO(run.output);
  CHECK(run.code == 0);
  CHECK(has(run.output, "\n  375.0 mJ were lost in 1 jump (snap-back), the first at t = 1.5 s\n"));
  CHECK(has(run.output, "dissipated 750.0 mJ, stored 0.0 mJ, energy balance 0\n"));
  CHECK_FALSE(has(run.output, "warning"));
  const std::string json = file_text(folder.path() / "worn.json");
  CHECK(has(json, "\"lost_in_jumps\": 375,"));
  CHECK(has(json, "\"jumps\": 1,"));
  const std::string events = file_text(folder.path() / "worn.events.csv");
  CHECK(has(events, "\n1.5,pad,stick,slip,1500,1500,0,1.5\n1.5,pad,slip,jump,0,0,1,1.5\n"));
  const std::string rows = file_text(folder.path() / "worn.csv");
  CHECK(has(rows, ",WORK,LOST\n"));
  // A picture of the result and a page of the case take the events as they are.
  CHECK(slipbench(folder, "plot worn.csv --as bands -o bands.svg").code == 0);
  CHECK(has(file_text(folder.path() / "bands.svg"), "slips"));
  CHECK(has(slipbench(folder, "run worn.yaml --explain 1.75").output, "slip -> jump"));
}

TEST_CASE("exact integration ends at the same place, and loses the same energy") {
  const TemporaryFolder folder;
  folder.write("worn.yaml", worn("integration: {method: exact}\n"));
  const Ended stopped = slipbench(folder, "run worn.yaml");
  INFO(stopped.output);
  CHECK(stopped.code == 3);
  CHECK(has(stopped.output, kWarned));
  CHECK(has(stopped.output, kStopped));
  folder.write("worn.yaml", worn("integration: {method: exact, snap_back: jump}\n"));
  const Ended run = slipbench(folder, "run worn.yaml");
  INFO(run.output);
  CHECK(run.code == 0);
  CHECK(has(run.output, "\n  375.0 mJ were lost in 1 jump (snap-back), the first at t = 1.5 s\n"));
  CHECK(has(run.output, "dissipated 750.0 mJ, stored 0.0 mJ, energy balance "));
  CHECK_FALSE(has(run.output, "warning"));
  CHECK(has(file_text(folder.path() / "worn.csv"), ",WORK,LOST\n"));
  CHECK(has(file_text(folder.path() / "worn.json"), "\"jumps\": 1,"));
}

TEST_CASE("a cell that makes the bound and that no run reaches is named, and does not end it") {
  const TemporaryFolder folder;
  folder.write("far.yaml",
               worn("").replace(worn("").find("coefficient: 0.25"), 17,
                                "coefficient: {columns: [mu, contact_force], rows: [[0.01, 0], "
                                "[0.01, 7000], [0.8, 7010]]}"));
  const Ended run = slipbench(folder, "run far.yaml");
  INFO(run.output);
  CHECK(run.code == 0);
  CHECK(has(run.output,
            "accumulated_slip = 0 .. 1 at contact_force = 7000 .. 7010; mu stands for "
            "d(mu F_N)/dF_N; a run that meets 1 or more ends there"));
}

TEST_CASE("of a potential, the stiffness that is said to follow everywhere does") {
  const auto plane = [](const std::string& stiffness) {
    return "slipbench: 1\ntitle: plane\nunits: {length: mm, force: N, time: s}\n"
           "connector: {type: SLIDE-PLANE}\n"
           "friction:\n"
           "  - potential: {exponent: 4, terms: [{component: 2}, {component: 3}]}\n"
           "    internal_contact_force: {columns: [F, accumulated_slip], rows: [[6000, 0], [1000, "
           "1]]}\n"
           "    coefficient: 0.25\n"
           "    stick: {stiffness: " +
           stiffness +
           "}\nhistory:\n  - {step: out, duration: 3.0, increments: 70, motion: {CP2: {to: 3}, "
           "CP3: {to: 3}}}\n";
  };
  const TemporaryFolder folder;
  // Above mu |F'| = 1250, which is enough along an axis.
  folder.write("plane.yaml", plane("1700"));
  const Ended soft = slipbench(folder, "run plane.yaml");
  INFO(soft.output);
  CHECK(soft.code == 3);
  CHECK(has(soft.output,
            "mu |F'| / (|m|^2 k) = 0.25 * 5000 / (0.707107 * 1700) = 1.03986 in the cell "
            "accumulated_slip = 0 .. 1; |m|^2 is the least of the potential, where its terms slip "
            "together; a run that meets 1 or more ends there; a stick.stiffness above 1767.77 or a "
            "flatter table follows everywhere, "));
  CHECK(has(soft.output,
            "mu |F'| / (|m|^2 k) = 1.03986 in this increment where it must stay below 1; a "
            "stick.stiffness above 1767.77 N/mm follows it here, "));
  folder.write("plane.yaml", plane("1768"));
  const Ended stiff = slipbench(folder, "run plane.yaml");
  INFO(stiff.output);
  CHECK(stiff.code == 0);
  CHECK_FALSE(has(stiff.output, "snap-back"));
}

TEST_CASE("with the slip of the increment's start nothing is warned of") {
  const TemporaryFolder folder;
  folder.write("worn.yaml", worn("integration: {accumulated_slip: start}\n"));
  const Ended run = slipbench(folder, "run worn.yaml --solver-report");
  INFO(run.output);
  CHECK(run.code == 0);
  CHECK_FALSE(has(run.output, "snap-back"));
}

TEST_CASE(
    "what slipped and wore its limit away within one increment is not told as never slipping") {
  const TemporaryFolder folder;
  folder.write("worn.yaml", worn("").replace(worn("").find("1000}"), 4, "9000"));
  const Ended coarse = shell(folder, "sed -i 's/increments: 12/increments: 1/' worn.yaml; '" +
                                         kProgram + "' run worn.yaml");
  INFO(coarse.output);
  CHECK(coarse.code == 0);
  CHECK_FALSE(has(coarse.output, "never slips"));
  // 1500 N are met at 1/6 mm; the limit is gone within the increment.
  CHECK(has(coarse.output,
            "1 stick-slip event, first slip at t = 0.1667 s (CP1 = 0.1667 mm) at "
            "1500.0 N"));
  CHECK(has(file_text(folder.path() / "worn.events.csv"), ",pad,stick,slip,1500,1500,0,"));
  CHECK(has(file_text(folder.path() / "worn.events.csv"), "\n3,pad,slip,open,0,0,1,3\n"));
}

}  // namespace
}  // namespace slipbench::driver::commands
