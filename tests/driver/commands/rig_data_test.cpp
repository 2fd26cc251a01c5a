// SPDX-License-Identifier: Apache-2.0
// One file as the rig wrote it, read by run, check and calibrate.
#include <catch2/catch.hpp>
#include <string>

#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

/// A slider of mu = 0.2 under 100 N that slips, in German: a preamble, decimal commas, a row of
/// units, and a sample that the load cell did not give.
constexpr const char* kRig =
    "Rig 7; operator Meier\r\n"
    "20 Hz\r\n"
    "t;Weg;Kraft (links);Last\r\n"
    "ms;\xb5m;N;kN\r\n"
    "0;0;0,0;0,1\r\n"
    "50;50;20,0;0,1\r\n"
    "100;100;;0,1\r\n"
    "150;150;20,0;0,1\r\n"
    "200;50;-20,0;0,1\r\n";

constexpr const char* kData = "{file: rig.txt, decimal: ',', skip: 2, units_row: true}";
constexpr const char* kDataWithHoles =
    "{file: rig.txt, decimal: ',', skip: 2, units_row: true, missing: skip}";

std::string case_of(const std::string& history, const std::string& curve,
                    const std::string& units = "units: {length: mm, force: N, time: s}\n") {
  return "slipbench: 1\n" + units +
         "parameters: {mu: 0.2}\n"
         "connector: {type: SLOT}\n"
         "friction:\n"
         "  - {predefined: {}, coefficient: = mu, stick: {stiffness: 1000}}\n"
         "history:\n"
         "  csv: " +
         history +
         "\n"
         "  time: t\n"
         "  columns: {CP1: Weg, f2: Last}\n"
         "checks:\n"
         "  - name: force of the rig\n"
         "    quantity: CSF1\n"
         "    against: {curve: " +
         curve +
         ", abscissa: t, column: Kraft (links)}\n"
         "    tolerance: {absolute: 1.0e-9, why: rounding}\n";
}

TEST_CASE("run, check and calibrate read the same file of a rig by the same words") {
  const TemporaryFolder folder;
  folder.write("rig.txt", kRig);
  folder.write("loop.yaml", case_of(kData, kDataWithHoles));
  const Ended check = slipbench(folder, "check loop.yaml");
  INFO(check.output);
  CHECK(check.code == 0);
  CHECK(check.output.find("PASS  loop     1 check   worst 0 of its tolerance") !=
        std::string::npos);

  const Ended run = slipbench(folder, "run loop.yaml");
  INFO(run.output);
  CHECK(run.code == 0);
  CHECK(file_text(folder.path() / "loop.csv").find("\n0.15,0.15,") != std::string::npos);
  CHECK(
      run.output.find(
          "  note: history.time: rig.txt: column 't' is converted from ms, as the file says, to s\n"
          "  note: history.columns.CP1: rig.txt: column 'Weg' is converted from µm, as the file "
          "says, to mm\n"
          "  note: history.columns.f2: rig.txt: column 'Last' is converted from kN, as the file "
          "says, to N\n"
          "  note: checks[0].against.curve: rig.txt: 1 row was left out, as it lacks a sample "
          "(line 7)\n") != std::string::npos);

  folder.write("fit.yaml",
               "slipbench: 1\ncalibrate:\n  experiments:\n    - case: loop.yaml\n      data: " +
                   std::string(kDataWithHoles) +
                   "\n      time: t\n      compare: {CSF1: Kraft (links)}\n"
                   "  vary: {mu: {start: 0.3, bounds: [0, 1]}}\n");
  const Ended calibrate = slipbench(folder, "calibrate fit.yaml");
  INFO(calibrate.output);
  CHECK(calibrate.code == 0);
  CHECK(calibrate.output.find("loop: 1 row was left out, as it lacks a sample (line 7)") !=
        std::string::npos);
  CHECK(file_text(folder.path() / "loop.calibrated.yaml").find("mu: 0.2") != std::string::npos);
}

TEST_CASE("a file of which nothing is said is refused with the words that would read it") {
  const TemporaryFolder folder;
  folder.write("rig.txt", kRig);
  folder.write("loop.yaml", case_of("rig.txt", "rig.txt"));
  const Ended refused = slipbench(folder, "run loop.yaml");
  CHECK(refused.code == 2);
  CHECK(refused.output ==
        "loop.yaml:8:8: error: history.csv: rig.txt:1:1: no column 't'; the columns are Rig 7, "
        "operator Meier; write {file: rig.txt, decimal: \",\", skip: 2, units_row: true}\n"
        "    8 |   csv: rig.txt\n"
        "      |        ^~~~~~~\n"
        "1 error, nothing was run\n");
}

TEST_CASE("a sample that is missing in mid-run names what to do about it, and nothing is written") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "t,u,F\n0,0,100\n1,nan,100\n");
  folder.write(
      "a.yaml",
      "slipbench: 1\nconnector: {type: SLOT}\nfriction:\n  - {predefined: {}, coefficient: "
      "0.2, stick: {stiffness: 1000}}\nhistory: {csv: rig.csv, time: t, columns: {CP1: u, "
      "f2: F}}\n");
  const Ended refused = slipbench(folder, "run a.yaml");
  CHECK(refused.code == 2);
  CHECK(refused.output ==
        "a.yaml: error: rig.csv:3:3: column 'u' holds 'nan'; a finite number is wanted; write "
        "{file: rig.csv, missing: skip} to leave such rows out, or 'hold' for the value before\n");
  CHECK_FALSE(std::filesystem::exists(folder.path() / "a.csv"));
}

TEST_CASE("the unit that the case states is believed more than the file's, with a warning") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "t,u (mm),F (kN)\n0,0,100\n1,,100\n2,0.1,-\n");
  folder.write("a.yaml",
               "slipbench: 1\nunits: {length: mm, force: N, time: s}\nconnector: {type: SLOT}\n"
               "friction:\n  - {predefined: {}, coefficient: 0.2, stick: {stiffness: 1000}}\n"
               "history:\n  csv: {file: rig.csv, missing: hold}\n  time: t\n"
               "  columns: {CP1: u, f2: {column: F, unit: N}}\n");
  const Ended run = slipbench(folder, "run a.yaml");
  INFO(run.output);
  CHECK(run.code == 0);
  CHECK(
      run.output.find("history.columns.f2.unit: rig.csv says that column 'F (kN)' is in kN; it is "
                      "read in N, as stated here") != std::string::npos);
  CHECK(run.output.find("note: history.csv: rig.csv: 2 missing samples were held at the values "
                        "before (first in line 3)") != std::string::npos);
  const std::string result = file_text(folder.path() / "a.csv");
  CHECK(result.find("\n1,0,") != std::string::npos);
  CHECK(result.find("\n2,0.1,") != std::string::npos);
}

TEST_CASE("data come from standard input too, for history and curve at once") {
  const TemporaryFolder folder;
  folder.write("rig.txt", kRig);
  const std::string from_input =
      "{file: '-', decimal: ',', skip: 2, units_row: true, missing: skip}";
  folder.write("loop.yaml", case_of(from_input, from_input));
  const Ended check = slipbench(folder, "check loop.yaml < rig.txt");
  INFO(check.output);
  CHECK(check.code == 0);
  const Ended empty = slipbench(folder, "check loop.yaml < /dev/null");
  CHECK(empty.code == 2);
  CHECK(empty.output.find("history.csv: stdin:1:1: the file is empty; a header row and rows of "
                          "numbers are wanted") != std::string::npos);
}

TEST_CASE("a table is not read in units that are not the case's") {
  const TemporaryFolder folder;
  folder.write("mu.csv", "mu;slip_rate (m/s)\n0,3;0\n0,2;1\n");
  folder.write(
      "a.yaml",
      "slipbench: 1\nunits: {length: mm, force: N, time: s}\nconnector: {type: SLOT}\n"
      "friction:\n  - predefined: {}\n    coefficient: {columns: [mu, slip_rate], csv: {file: "
      "mu.csv, decimal: ','}}\n    stick: {stiffness: 1000}\nhistory:\n  - {step: go, "
      "increments: 2, force: {f2: 100}, motion: {CP1: {to: 1}}}\n");
  const Ended refused = slipbench(folder, "run a.yaml");
  CHECK(refused.code == 2);
  CHECK(
      refused.output.find("mu.csv states column 'slip_rate' in m/s, and a table is read in the "
                          "case's units; convert the column, and leave its unit out of the file") !=
      std::string::npos);
  folder.write("mu.csv", "mu;slip_rate\n0,3;0\n0,2;1\n");
  const Ended run = slipbench(folder, "run a.yaml");
  INFO(run.output);
  CHECK(run.code == 0);
}

}  // namespace
}  // namespace slipbench::driver::commands
