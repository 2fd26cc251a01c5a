// SPDX-License-Identifier: Apache-2.0
// Whole messages, as they reach the terminal.
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/driver/read/read_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::read {
namespace {

TEST_CASE("A misspelt key shows its line, a caret under it and the nearest key") {
  CHECK(complaint(changed({{"    coefficient:", "    coeficient:"}})) ==
        "c.yaml:16:5: error: friction[0].coeficient: unknown key; did you mean 'coefficient'?\n"
        "   16 |     coeficient: = mu\n"
        "      |     ^~~~~~~~~~\n");
}

TEST_CASE("A key at the wrong level says where it belongs") {
  CHECK(complaint(changed({{"history:", "elastic_slip: 1\nhistory:"}})) ==
        "c.yaml:18:1: error: elastic_slip: unknown key; 'elastic_slip' belongs to "
        "friction[].stick or history[].change_friction.NAME.stick\n"
        "   18 | elastic_slip: 1\n"
        "      | ^~~~~~~~~~~~\n");
}

TEST_CASE("A motion of a held component names the connection and what is free") {
  CHECK(complaint(changed({{"CP1: {to", "CP2: {to"}})) ==
        "c.yaml:21:14: error: history[0].motion.CP2: a CYLINDRICAL connector holds component 2 "
        "(its constraint force f2 goes under 'force:'); free are CP1, CPR1\n"
        "   21 |     motion: {CP2: {to: 0.45}}\n"
        "      |              ^~~\n");
}

TEST_CASE("All faults of a file are shown at once, in the order of their lines") {
  CHECK(complaint(changed({{"    coefficient:", "    coeficient:"},
                           {"contact_force: normal", "contact_force: norml"},
                           {"{to: 0.45}", "0.45"},
                           {"quantity: FLIM", "quantity: FLIMM"}})) ==
        "c.yaml:15:20: error: friction[0].contact_force: unknown derived component 'norml'; did "
        "you mean 'normal'?\n"
        "   15 |     contact_force: norml\n"
        "      |                    ^~~~~\n"
        "c.yaml:16:5: error: friction[0].coeficient: unknown key; did you mean 'coefficient'?\n"
        "   16 |     coeficient: = mu\n"
        "      |     ^~~~~~~~~~\n"
        "c.yaml:21:19: error: history[0].motion.CP1: a motion needs a profile, found a number; "
        "{to: 0.45} goes there linearly over the step\n"
        "   21 |     motion: {CP1: 0.45}\n"
        "      |                   ^~~~\n"
        "c.yaml:25:15: error: checks[0].quantity: unknown name 'FLIMM'; did you mean 'FLIM'?\n"
        "   25 |     quantity: FLIMM\n"
        "      |               ^~~~~\n");
}

TEST_CASE("A fault in a table names its row and points at the number") {
  const std::string rows =
      "internal_contact_force:\n"
      "      columns: [force, accumulated_slip]\n"
      "      rows:\n"
      "        - [100, 0]\n"
      "        - [90, 10]\n";
  const std::string key = "    contact_force: normal\n    ";
  CHECK(
      complaint(changed({{"    contact_force: normal\n", key + rows + "        - [-1, 20]\n"}})) ==
      "c.yaml:21:12: error: friction[0].internal_contact_force.rows[2][0]: 'force' must be at "
      "least 0, row 3 has -1\n"
      "   21 |         - [-1, 20]\n"
      "      |            ^~\n");
  CHECK(complaint(changed({{"    contact_force: normal\n", key + rows + "        - [80, 5]\n"}})) ==
        "c.yaml:21:16: error: friction[0].internal_contact_force.rows[2][1]: independents must "
        "ascend, the first one fastest: 'accumulated_slip' goes back from 10 in row 2 to 5 in row "
        "3\n"
        "   21 |         - [80, 5]\n"
        "      |                ^\n");
}

TEST_CASE("A unit of another dimension is refused") {
  CHECK(complaint(changed({{"length: mm", "length: N"}})) ==
        "c.yaml:3:17: error: units.length: unit 'N' does not measure a length\n"
        "    3 | units: {length: N, force: N, time: s, temperature: degC}\n"
        "      |                 ^\n");
}

TEST_CASE("An unknown name in an expression has the caret under it") {
  CHECK(complaint(changed({{"scale: = r", "scale: = 2*rr"}})) ==
        "c.yaml:14:57: error: friction[0].potential.terms[1].scale: unknown name 'rr'; define it "
        "under 'parameters:'\n"
        "   14 | ...terms: [{component: 1}, {component: 4, scale: = 2*rr}]\n"
        "      |                                                      ^~\n");
}

TEST_CASE("A length of zero is noted, since its term is dropped") {
  const std::string text =
      changed({{"    potential:\n      terms: [{component: 1}, {component: 4, scale: = r}]\n"
                "    contact_force: normal\n",
                "    predefined: {R: 2, L: 0}\n"}});
  CHECK(complaint(text) ==
        "c.yaml:13:27: note: friction[0].predefined.L: 0 drops the term of the contact force it "
        "belongs to\n"
        "   13 |     predefined: {R: 2, L: 0}\n"
        "      |                           ^\n");
}

TEST_CASE("A stick without a length notes the length it takes") {
  CHECK(complaint(changed({{"    stick: {elastic_slip: 1.0e-4}\n", ""}})) ==
        "c.yaml:12:5: note: friction[0]: characteristic length not given, 1 mm (1 rad in rotation) "
        "used for the stick stiffness: elastic slip 1e-04\n"
        "   12 |   - name: sleeve\n"
        "      |     ^\n");
}

TEST_CASE("A definition without a coefficient is warned of") {
  CHECK(complaint(changed({{"    coefficient: = mu\n", ""}})) ==
        "c.yaml:12:5: warning: friction[0]: no coefficient: this definition has no effect; "
        "give it a 'coefficient'\n"
        "   12 |   - name: sleeve\n"
        "      |     ^\n");
}

TEST_CASE("A faulty --set is told by its name, once") {
  const auto with = [](const std::string& name, std::variant<double, std::string> value) {
    ReadOptions options;
    options.overrides = {{name, std::move(value)}};
    return complaint(kSoundCase, options);
  };
  CHECK(with("mmu", 0.2) ==
        "c.yaml: error: --set mmu: there is no parameter 'mmu'; did you mean 'mu'?\n");
  CHECK(with("zzz", 0.2) ==
        "c.yaml: error: --set zzz: there is no parameter 'zzz'; parameters of this case: r, li and "
        "mu\n");
  CHECK(with("mu", "abc") ==
        "c.yaml: error: --set mu: unknown name 'abc'; parameters of this case: r, li and mu\n");
  CHECK(with("mu", "1/0") == "c.yaml: error: --set mu: 1/0 divides by zero\n");
  CHECK(with("mu", -1.0) ==
        "c.yaml:16:18: error: friction[0].coefficient: must be at least 0, found -1\n"
        "   16 |     coefficient: = mu\n"
        "      |                  ^~~~\n");
}

TEST_CASE("A fault of a data file names the file, the line and the key that named it") {
  const TemporaryFolder folder;
  folder.write("nan.csv", "t,x\n0,0\n1,nan\n");
  folder.write("table.csv", "mu,slip_rate\n0.2,0\n-0.1,1\n");
  CHECK(complaint(changed({{"{to: 0.45}", "{csv: nan.csv, time: t, value: x}"}}), {},
                  folder.path()) ==
        "c.yaml:21:25: error: history[0].motion.CP1.csv: nan.csv:3:3: column 'x' holds 'nan'; a "
        "finite number is wanted; write {file: nan.csv, missing: skip} to leave such rows out, or "
        "'hold' for the value before\n"
        "   21 |     motion: {CP1: {csv: nan.csv, time: t, value: x}}\n"
        "      |                         ^~~~~~~\n");
  CHECK(complaint(changed({{"coefficient: = mu",
                            "coefficient: {columns: [mu, slip_rate], csv: table.csv}"}}),
                  {}, folder.path()) ==
        "c.yaml:16:50: error: friction[0].coefficient.csv: table.csv:3: 'mu' must be at least 0, "
        "line 3 has -0.1\n"
        "   16 |     coefficient: {columns: [mu, slip_rate], csv: table.csv}\n"
        "      |                                                  ^~~~~~~~~\n");
}

TEST_CASE("A missing data file is the machine's fault, a path out of the folder the text's") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& file) {
    return read_text(changed({{"{to: 0.45}", "{csv: " + file + ", time: t, value: x}"}}), {},
                     folder.path());
  };
  CHECK(read("none.csv").environment_failure);
  for (const char* outside : {"../a.csv", "/etc/passwd", "~/a.csv", "file:///etc/passwd"}) {
    const ReadCase refused = read(outside);
    INFO(outside);
    CHECK_FALSE(refused.environment_failure);
    CHECK(refused.diagnostics.count(base::Severity::kError) == 1);
    CHECK(refused.diagnostics.sorted()[0].path == "history[0].motion.CP1.csv");
  }
  std::filesystem::create_symlink("/etc/hostname", folder.path() / "link.csv");
  CHECK(read("link.csv").diagnostics.sorted()[0].message.find("link out of the folder") !=
        std::string::npos);
}

TEST_CASE("A flood of faults is counted, not printed") {
  std::string rows = "- x";
  for (int i = 0; i < 5000; ++i) rows += "\n  - x";
  const std::string text = changed({{"friction:\n", "friction:\n  " + rows + "\n"}});
  const std::string shown = complaint(text);
  CHECK(shown.size() < 5000);
  // 5001 items that are no maps, and one for there being so many definitions.
  CHECK(shown.ends_with("... and 4982 more errors\n"));
}

/// The text with everything from `key` on replaced.
std::string cut(const std::string& key, const std::string& rest) {
  return kSoundCase.substr(0, kSoundCase.find(key)) + rest;
}

TEST_CASE("Empty lists are no lists of steps, definitions or types") {
  CHECK(messages(cut("history:", "history: []\n")) ==
        std::vector<std::string>{"18:10: error: history: needs at least one step"});
  CHECK(messages(cut("history:", "history:\n")) ==
        std::vector<std::string>{"18:1: error: history: wanted a list of steps, or a measured "
                                 "history {csv: ...}, found nothing"});
  CHECK(messages(cut("friction:", "friction: []\nhistory: [{step: a, increments: 1}]\n")) ==
        std::vector<std::string>{"11:11: error: friction: needs at least one definition"});
  CHECK(messages(cut("checks:", "checks: {name: a}\n")) ==
        std::vector<std::string>{
            "23:9: error: checks: wanted a list, each item a map, found a map; each "
            "item of a list begins with '- '"});
}

TEST_CASE("Steps, checks and definitions have names of their own") {
  CHECK(messages(changed({{"checks:", "  - {step: press, increments: 3}\nchecks:"}})) ==
        std::vector<std::string>{
            "23:12: error: history[1].step: the name 'press' is already that of history[0]"});
  CHECK(messages(kSoundCase + "  - name: limit\n    quantity: FLIM\n    against: {expression: 1}\n"
                              "    tolerance: {relative: 1, why: x}\n") ==
        std::vector<std::string>{
            "28:11: error: checks[1].name: the name 'limit' is already that of checks[0]"});
}

TEST_CASE("All faults of a measured history are shown at once") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "t,x,load\n0,0,1\n1,1,2\n");
  const std::string faulty =
      "history:\n  csv: rig.csv\n  time: t\n  columns:\n    CP1: x\n"
      "    f2: {column: load, unit: lb}\n    CP2: x\n    foo: x\n"
      "    temperature: {colum: x}\n  hold: maybe\n";
  CHECK(messages(cut("history:", faulty), {}, folder.path()) ==
        std::vector<std::string>{
            // NOLINTNEXTLINE(bugprone-suspicious-missing-comma): each message is one text
            "23:30: error: history.columns.f2.unit: unit 'lb' does not measure a force; it is a "
            "mass, the force is 'lbf'",
            "24:5: error: history.columns.CP2: a CYLINDRICAL connector holds component 2 (its "
            "constraint force f2 goes under 'force:'); free are CP1, CPR1",
            "25:5: error: history.columns.foo: unknown quantity 'foo'; known here: CP1, CPR1, f2, "
            "f3, m2, m3, temperature, field1 .. field16",
            "26:19: error: history.columns.temperature.colum: unknown key; did you mean 'column'?",
            "27:9: error: history.hold: wanted true or false, found 'maybe'"});
  CHECK(messages(cut("history:", "history: {csv: rig.csv, time: t, columns: {}}\n"), {},
                 folder.path()) ==
        std::vector<std::string>{
            "18:43: error: history.columns: needs at least one column to drive"});
}

TEST_CASE("A faulty connection type makes nothing else look wrong, but hides no other fault") {
  CHECK(messages(changed({{"CYLINDRICAL", "CYLINDRIC"}})) ==
        std::vector<std::string>{"6:9: error: connector.type: unknown connection type "
                                 "'CYLINDRIC'; did you mean 'CYLINDRICAL'?"});
  CHECK(messages(changed({{"CYLINDRICAL", "CYLINDRIC"},
                          {"coefficient: = mu",
                           "coefficient: {columns: [mu, slip_rate], rows: [[-1, 0]]}"}}))
            .size() == 2);
}

TEST_CASE("Faulty parameters are reported where they stand, not where they are used") {
  CHECK(messages(changed({{"mu: 0.15", "mu: = 2*nu"}, {"li: 0.55", "li: = lii"}})) ==
        std::vector<std::string>{
            "4:29: error: parameters.li: unknown name 'lii'; did you mean 'li'?",
            "4:42: error: parameters.mu: unknown name 'nu'; define it under 'parameters:'"});
  // Other parameters are judged all the same, however long the chain of faulty ones.
  CHECK(messages(changed({{"li: 0.55", "li: = lii"}, {"mu: 0.15", "mu: -1"}})).size() == 2);
  std::string chain = "li: = c0, c0: = nowhere";
  for (int i = 1; i < 20; ++i) {
    chain += ", c" + std::to_string(i) + ": = c" + std::to_string(i - 1);
  }
  const auto both = messages(changed({{"li: 0.55", chain}, {"mu: 0.15", "mu: -1"}}));
  REQUIRE(both.size() == 2);
  CHECK(both[0] ==
        "4:39: error: parameters.c0: unknown name 'nowhere'; define it under "
        "'parameters:'");
  CHECK(both[1].starts_with("16:18: error: friction[0].coefficient: must be at least 0"));
}

}  // namespace
}  // namespace slipbench::driver::read
