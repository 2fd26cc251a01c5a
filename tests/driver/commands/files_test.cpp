// SPDX-License-Identifier: Apache-2.0
// Where the program writes, and what it never writes over.
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <string>

#include "tests/driver/commands/program_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSlider = R"(slipbench: 1
title: Slider
units: {length: mm, force: N, time: s}
parameters: {mu: 0.2, k: 1000}
connector: {type: SLOT}
friction:
  - {predefined: {}, coefficient: = mu, stick: {stiffness: = k}}
history:
  - {step: slide, increments: 10, motion: {CP1: {to: 0.1}}, force: {f2: 100}}
checks:
  - {name: limit, quantity: FLIM, against: {expression: = 20}, tolerance: {relative: 1.0e-12, why: rounding}}
)";

constexpr const char* kFit = R"(slipbench: 1
calibrate:
  experiments: [{case: slider.yaml, data: rig.csv, time: t, compare: {CSF1: F}}]
  vary: {mu: {bounds: [0, 1]}}
)";

constexpr const char* kRig = "t,F\n0.1,10\n0.2,20\n0.3,21\n0.4,21\n0.5,21\n0.6,21\n";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    names.insert(entry.path().lexically_relative(folder).string());
  }
  return names;
}

std::string kept(const std::string& file, const std::string& owner) {
  return "slipbench: error: " + file + ": is there already and is not " + owner +
         ", and is kept; choose another folder or name, or replace it with --force\n";
}

bool draws(const TemporaryFolder& folder) { return shell(folder, "command -v gnuplot").code == 0; }

TEST_CASE("run keeps what is no result of the case, whichever of its files that is") {
  for (const std::string ending : {".csv", ".events.csv", ".json", ".solver.csv"}) {
    const TemporaryFolder folder;
    folder.write("slider.yaml", kSlider);
    folder.write("first.yaml", kSlider);
    folder.write("slider" + ending, "rig data\n");
    const Ended ended = slipbench(folder, "run first.yaml slider.yaml --solver-report");
    INFO(ended.output);
    CHECK(ended.code == 4);
    CHECK(ended.output == kept("slider" + ending, "a result of slider.yaml"));
    CHECK(names_in(folder.path()) ==
          std::set<std::string>{"first.yaml", "slider.yaml", "slider" + ending});
    CHECK(file_text(folder.path() / ("slider" + ending)) == "rig data\n");
    CHECK(slipbench(folder, "run slider.yaml --solver-report --force").code == 0);
    CHECK(file_text(folder.path() / ("slider" + ending)) != "rig data\n");
    CHECK(slipbench(folder, "run slider.yaml --solver-report --set mu=0.3").code == 1);
  }
}

TEST_CASE("a result of another case is kept, and so is a golden curve of the same") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  fs::create_directory(folder.path() / "other");
  folder.write("other/rail.yaml", kSlider);
  REQUIRE(slipbench(folder, "run slider.yaml -o results").code == 0);
  fs::copy(folder.path() / "results/slider.csv", folder.path() / "rail.csv");
  CHECK(slipbench(folder, "run other/rail.yaml").output ==
        kept("rail.csv", "a result of rail.yaml"));
  const std::string rows = file_text(folder.path() / "results/slider.csv");
  folder.write("slider.csv", "# slipbench golden curve\n" + rows);
  CHECK(slipbench(folder, "run slider.yaml").output ==
        kept("slider.csv", "a result of slider.yaml"));
}

TEST_CASE("an input stays whatever is forced") {
  const TemporaryFolder folder;
  std::string text = kSlider;
  text.replace(text.find("CP1: {to: 0.1}"), 14, "CP1: {csv: slider.csv, time: t, value: u}");
  folder.write("slider.yaml", text);
  folder.write("slider.csv", "t,u\n0,0\n1,0.1\n");
  const Ended ended = slipbench(folder, "run slider.yaml --force");
  CHECK(ended.code == 4);
  CHECK(contains(ended.output, "slider.csv: is an input (./slider.csv) and is not overwritten"));
  CHECK(file_text(folder.path() / "slider.csv") == "t,u\n0,0\n1,0.1\n");
}

TEST_CASE(
    "a case that fails leaves no new folder behind but for the case that fails the same way") {
  const TemporaryFolder folder;
  std::string text = kSlider;
  text.replace(text.find("f2: 100"), 7, "f2: {to: 1.0e300}, f3: 0");
  folder.write("slider.yaml", text);
  CHECK(slipbench(folder, "run slider.yaml -o new/deep").code == 3);
  CHECK(names_in(folder.path()) ==
        std::set<std::string>{"slider.yaml", "new", "new/deep", "new/deep/slider.failed.yaml"});
  CHECK(slipbench(folder, "run slider.yaml -o new/deep").code == 3);
  folder.write("slider.failed.yaml", "my own\n");
  const Ended ended = slipbench(folder, "run slider.yaml");
  CHECK(ended.code == 4);
  CHECK(contains(ended.output,
                 kept("slider.failed.yaml", "an unchanged case that fails as slider.yaml did")));
  CHECK(file_text(folder.path() / "slider.failed.yaml") == "my own\n");
}

TEST_CASE("folders are made for every kind of file") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  folder.write("rig.csv", kRig);
  folder.write("fit.yaml", kFit);
  CHECK(slipbench(folder, "run slider.yaml -o a/b").code == 0);
  CHECK(fs::exists(folder.path() / "a/b/slider.csv"));
  CHECK(slipbench(folder, "check slider.yaml --junit c/d.xml --json e/f.json --report g/h.html")
            .code == 0);
  CHECK(fs::exists(folder.path() / "c/d.xml"));
  CHECK(fs::exists(folder.path() / "e/f.json"));
  CHECK(fs::exists(folder.path() / "g/h.html"));
  CHECK(slipbench(folder, "report slider.yaml -o i/j.html").code == 0);
  CHECK(fs::exists(folder.path() / "i/j.html"));
  CHECK(slipbench(folder, "calibrate fit.yaml -o k/l").code == 0);
  CHECK(fs::exists(folder.path() / "k/l/slider.calibrated.yaml"));
  if (!draws(folder)) return;
  CHECK(slipbench(folder, "plot slider.yaml -o m/n.svg").code == 0);
  CHECK(fs::exists(folder.path() / "m/n.svg"));
}

TEST_CASE("verdicts are kept where their page cannot be written") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  // The page alone is larger than a file may be. So are the counters of a build for coverage: cut
  // off half written, they would fail every program after this one.
  const Ended ended =
      shell(folder, "trap '' XFSZ; ulimit -f 100; GCOV_PREFIX=counters '" + kProgram +
                        "' check slider.yaml -q --junit j.xml --json j.json --report r.html");
  CHECK(ended.code == 4);
  const std::string fault = "slipbench: error: r.html: cannot be written: File too large\n";
  CHECK(ended.output.find(fault) != std::string::npos);
  CHECK(ended.output.find("error: ") == ended.output.rfind("error: "));
  CHECK(file_text(folder.path() / "j.xml").find("</testsuites>") != std::string::npos);
  CHECK(file_text(folder.path() / "j.json").back() == '\n');
  CHECK_FALSE(fs::exists(folder.path() / "r.html"));
}

TEST_CASE("files of verdicts and pages are replaced by their kind only") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  const auto told = [&](const std::string& arguments, const std::string& file,
                        const std::string& owner) {
    INFO(arguments);
    folder.write(file, "rig data\n");
    const Ended ended = slipbench(folder, arguments);
    CHECK(ended.code == 4);
    CHECK(ended.output == kept(file, owner));
    CHECK(file_text(folder.path() / file) == "rig data\n");
    CHECK(slipbench(folder, arguments + " --force").code == 0);
    CHECK(slipbench(folder, arguments).code == 0);
  };
  told("check slider.yaml --junit slip.xml", "slip.xml", "a JUnit file of 'slipbench check'");
  told("check slider.yaml --json slip.json", "slip.json", "a JSON file of 'slipbench check'");
  told("check slider.yaml --report page.html", "page.html", "a page of slipbench's reports");
  told("report slider.yaml -o other.html", "other.html", "a page of slipbench's reports");
  CHECK(slipbench(folder, "check slider.yaml --report other.html").code == 0);
  CHECK(slipbench(folder, "check slider.yaml --json slip.xml").code == 4);
}

TEST_CASE("calibrate keeps what is no result of the fit, before it begins") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  folder.write("rig.csv", kRig);
  folder.write("fit.yaml", kFit);
  const auto told = [&](const std::string& file, const std::string& owner) {
    folder.write(file, "my own\n");
    const auto before = names_in(folder.path());
    const Ended ended = slipbench(folder, "calibrate fit.yaml");
    CHECK(ended.code == 4);
    CHECK(ended.output == kept(file, owner));
    CHECK(names_in(folder.path()) == before);
    CHECK(slipbench(folder, "calibrate fit.yaml --force").code == 0);
    CHECK(slipbench(folder, "calibrate fit.yaml").code == 0);
  };
  told("fit.json", "a result of fit.yaml");
  told("slider.calibrated.yaml", "an unchanged case calibrated by fit.yaml");
  told("fit.html", "the page of fit.yaml");
  told("fit.slider.loop.svg", "a picture of fit");
  const fs::path calibrated = folder.path() / "slider.calibrated.yaml";
  std::ofstream(calibrated, std::ios::app) << "# a thought about it\n";
  CHECK(slipbench(folder, "calibrate fit.yaml").output ==
        kept("slider.calibrated.yaml", "an unchanged case calibrated by fit.yaml"));
  CHECK(slipbench(folder, "run slider.calibrated.yaml --no-output").code == 1);
}

TEST_CASE("pictures carry whose they are, and keep what is none") {
  const TemporaryFolder folder;
  if (!draws(folder)) {
    WARN("gnuplot is not installed; nothing was drawn");
    return;
  }
  folder.write("a--b.yaml", kSlider);
  folder.write("other.yaml", kSlider);
  for (const std::string ending : {".svg", ".png", ".pdf"}) {
    const std::string file = "drawing" + ending;
    INFO(file);
    folder.write(file, "my own\n");
    const Ended ended = slipbench(folder, "plot a--b.yaml -o " + file);
    CHECK(ended.code == 4);
    CHECK(ended.output == kept(file, "a picture of a--b"));
    CHECK(file_text(folder.path() / file) == "my own\n");
    CHECK(slipbench(folder, "plot a--b.yaml --force -o " + file).code == 0);
    CHECK(slipbench(folder, "plot a--b.yaml --as history -o " + file).code == 0);
    CHECK(contains(file_text(folder.path() / file), "slipbench picture (a%2D%2Db)"));
    CHECK(slipbench(folder, "plot other.yaml -o " + file).code == 4);
  }
  CHECK(shell(folder, "xmllint --noout drawing.svg").code == 0);
  CHECK(shell(folder,
              "python3 -c \"import zlib, struct; b = open('drawing.png', 'rb').read(); i = 8\n"
              "while i < len(b):\n"
              "  n, = struct.unpack('>I', b[i:i + 4]); c = b[i + 4:i + 8 + n]\n"
              "  assert zlib.crc32(c) == struct.unpack('>I', b[i + 8 + n:i + 12 + n])[0]\n"
              "  i += 12 + n\n"
              "assert c == b'IEND'\"")
            .code == 0);
}

TEST_CASE("run -o - prints the rows and nothing else there, as they would be written") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  REQUIRE(slipbench(folder, "run slider.yaml -o files").code == 0);
  const Ended rows = slipbench(folder, "run slider.yaml -o - 2>told");
  CHECK(rows.code == 0);
  CHECK(rows.output == file_text(folder.path() / "files/slider.csv"));
  CHECK(contains(file_text(folder.path() / "told"), "slider: 10 increments, "));
  CHECK(contains(file_text(folder.path() / "told"), "  PASS  check 'limit'"));
  CHECK_FALSE(fs::exists(folder.path() / "slider.json"));
  CHECK_FALSE(fs::exists(folder.path() / "-"));
  const Ended two = slipbench(folder, "run slider.yaml files/x.yaml -o -");
  CHECK(two.code == 2);
  CHECK(two.output ==
        "slipbench: error: -o - prints the rows of one case, found 2; run them one by one, or into "
        "a folder\n");
  std::string text = kSlider;
  text.replace(text.find("f2: 100"), 7, "f2: {to: 1.0e300}, f3: 0");
  folder.write("fails.yaml", text);
  const Ended failed = slipbench(folder, "run fails.yaml -o - 2>told");
  CHECK(failed.code == 3);
  CHECK(failed.output.empty());
  CHECK_FALSE(fs::exists(folder.path() / "fails.failed.yaml"));
}

TEST_CASE("a case can come from standard input, with data of the current folder") {
  const TemporaryFolder folder;
  std::string text = kSlider;
  text.replace(text.find("CP1: {to: 0.1}"), 14, "CP1: {csv: rig.csv, time: t, value: u}");
  folder.write("slider", text);
  folder.write("rig.csv", "t,u\n0,0\n1,0.1\n");
  const Ended ran = slipbench(folder, "run - < slider");
  INFO(ran.output);
  CHECK(ran.code == 0);
  CHECK(contains(ran.output, "stdin: 10 increments, "));
  CHECK(contains(ran.output, "  stdin.csv  stdin.events.csv  stdin.json\n"));
  CHECK(contains(file_text(folder.path() / "stdin.csv"), "\n# case: stdin\n"));
  const Ended rows = shell(folder, "cat slider | '" + kProgram + "' run - -q -o -");
  CHECK(rows.code == 0);
  CHECK(rows.output == file_text(folder.path() / "stdin.csv"));
  const Ended checked = slipbench(folder, "check - < slider");
  CHECK(checked.code == 0);
  CHECK(contains(checked.output, "  PASS  stdin "));
  CHECK(contains(slipbench(folder, "check - < rig.csv").output, "stdin:1:1: error: "));
  if (!draws(folder)) return;
  const Ended drawn = slipbench(folder, "plot - < slider");
  CHECK(drawn.code == 0);
  CHECK(drawn.output == "stdin.svg\n");
}

TEST_CASE("run --quiet tells only what is doubtful or wrong") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  folder.write("rail.yaml", kSlider);
  const Ended well = slipbench(folder, "run -q slider.yaml rail.yaml");
  CHECK(well.code == 0);
  CHECK(well.output.empty());
  CHECK(fs::exists(folder.path() / "rail.json"));
  const Ended failed = slipbench(folder, "run -q slider.yaml --set mu=0.3");
  CHECK(failed.code == 1);
  CHECK(failed.output ==
        "slider:\n  FAIL  check 'limit': FLIM off by 10 N (limit 2e-11) at t = 0, first at 0, last "
        "at 1, 11 of 11 points\n");
}

TEST_CASE("a reader that has seen enough is no error, a full disk is one") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  // As head does, but for sure before anything is written.
  const auto unread = [&](const std::string& arguments) {
    return shell(folder,
                 "{ sleep 0.1; '" + kProgram + "' " + arguments +
                     "; echo $? >code; } | true; while ! test -s code; do sleep 0.02; done; "
                     "cat code; rm code");
  };
  CHECK(unread("list").output == "141\n");
  CHECK(unread("run slider.yaml -o -  2>told").output == "141\n");
  CHECK(unread("check slider.yaml --set mu=0.3 2>told").output == "1\n");
  const Ended full = slipbench(folder, "list >/dev/full");
  CHECK(full.code == 4);
  CHECK(contains(full.output, "standard output cannot be written: No space left on device"));
  CHECK(slipbench(folder, "run slider.yaml -o - >/dev/full 2>told").code == 4);
}

TEST_CASE("a file where a folder is wanted is told with what writes one") {
  const TemporaryFolder folder;
  folder.write("slider.yaml", kSlider);
  folder.write("fit.yaml", kFit);
  folder.write("plain", "");
  const Ended ran = slipbench(folder, "run slider.yaml -o out.csv");
  CHECK(ran.code == 2);
  CHECK(ran.output ==
        "slipbench: error: -o out.csv: wanted a folder, not a file: results are called after their "
        "case; '-o - > FILE' writes the rows of one case to any file\n");
  CHECK(slipbench(folder, "calibrate fit.yaml -o out.json").output ==
        "slipbench: error: -o out.json: wanted a folder, not a file: results are called after "
        "their fit\n");
  CHECK(slipbench(folder, "run slider.yaml -o plain").output ==
        "slipbench: error: plain/slider.csv: plain is not a folder\n");
  CHECK(names_in(folder.path()) == std::set<std::string>{"fit.yaml", "plain", "slider.yaml"});
  fs::create_directory(folder.path() / "out.csv");
  CHECK(slipbench(folder, "run slider.yaml -o out.csv").code == 0);
}

TEST_CASE("pictures go where they are wanted, and that is told") {
  const TemporaryFolder folder;
  if (!draws(folder)) {
    WARN("gnuplot is not installed; nothing was drawn");
    return;
  }
  fs::create_directory(folder.path() / "rig");
  folder.write("rig/slider.yaml", kSlider);
  folder.write("rig/rig.csv", kRig);
  folder.write("rig/fit.yaml", kFit);
  CHECK(slipbench(folder, "plot rig/slider.yaml").output == "slider.svg\n");
  CHECK(slipbench(folder, "plot rig/slider.yaml --as history -o rig").output ==
        "rig/slider.history.svg\n");
  CHECK(slipbench(folder, "plot rig/slider.yaml -o new/").output == "new/slider.svg\n");
  const Ended fitted = slipbench(folder, "calibrate rig/fit.yaml -o out --report pages/a.html");
  INFO(fitted.output);
  CHECK(contains(fitted.output,
                 "  out/fit.json  out/slider.calibrated.yaml  pages/a.html  "
                 "pages/fit.slider.loop.svg  pages/fit.slider.residuals.svg\n"));
}

TEST_CASE("an interruption takes the folders along that were made for the results") {
  const TemporaryFolder folder;
  std::string text = kSlider;
  text.replace(text.find("increments: 10"), 14, "increments: 100000000");
  folder.write("long.yaml", text);
  for (const char* signal : {"INT", "TERM"}) {
    const Ended ended = shell(folder, "timeout --preserve-status -s " + std::string(signal) +
                                          " 0.3 '" + kProgram + "' run long.yaml -o new/deep");
    CHECK(ended.code == (signal == std::string("INT") ? 130 : 143));
    CHECK(names_in(folder.path()) == std::set<std::string>{"long.yaml"});
  }
}

TEST_CASE("import never replaces a case that somebody may have worked on") {
  const TemporaryFolder folder;
  folder.write("model_0000.rad",
               "#RADIOSS STARTER\n/BEGIN\nmodel\n      2022         0\n                   g"
               "                  mm                  ms\n"
               "                   g                  mm                  ms\n"
               "/FRICTION/1\npad\n         0         0            0.0         0\n"
               "                 0.0                 0.0                 0.0                 0.0"
               "                 0.0\n                 0.0                 0.2                 0.0"
               "\n/END\n");
  const Ended first = slipbench(folder, "import model_0000.rad -o cases/pad.yaml");
  INFO(first.output);
  REQUIRE(first.code == 0);
  const std::string text = file_text(folder.path() / "cases/pad.yaml");
  const Ended second = slipbench(folder, "import model_0000.rad -o cases/pad.yaml");
  CHECK(second.code == 4);
  CHECK(contains(second.output,
                 "cases/pad.yaml: is there already, and is kept; choose another folder or name, "
                 "or replace it with --force\n"));
  CHECK(slipbench(folder, "import model_0000.rad -o cases/pad.yaml --force").code == 0);
  CHECK(file_text(folder.path() / "cases/pad.yaml") == text);
}

}  // namespace
}  // namespace slipbench::driver::commands
