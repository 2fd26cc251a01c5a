// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/driver/calibrate/fit_for_test.hpp"
#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

void write_rig(const TemporaryFolder& folder) {
  folder.write("slider.yaml", calibrate::SliderRig::case_text());
  folder.write("rig.csv", calibrate::SliderRig{.noise = 0.3}.data());
  folder.write("fit.yaml", calibrate::kSliderFit);
}

bool contains(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

std::vector<std::string> files_in(const TemporaryFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("calibrate tells the estimates, writes the results, and its case runs") {
  const TemporaryFolder folder;
  write_rig(folder);
  const Ended ended = slipbench(folder, "calibrate fit");
  CAPTURE(ended.output);
  CHECK(ended.code == 0);
  CHECK(contains(ended.output, "converged"));
  CHECK(contains(ended.output, "0.300"));
  for (const char* name : {"fit.json", "fit.html", "slider.calibrated.yaml"}) {
    CAPTURE(name);
    CHECK(fs::is_regular_file(folder.path() / name));
    CHECK(contains(ended.output, name));
  }
  const Ended run = slipbench(folder, "run slider.calibrated.yaml");
  CAPTURE(run.output);
  CHECK(run.code == 0);
  CHECK(contains(run.output, "slip"));
}

TEST_CASE("the same fit writes the same bytes, and without output none at all") {
  const TemporaryFolder folder;
  write_rig(folder);
  const auto before = files_in(folder);
  CHECK(slipbench(folder, "calibrate fit.yaml --no-output").code == 0);
  CHECK(files_in(folder) == before);
  CHECK(slipbench(folder, "calibrate fit.yaml").code == 0);
  const std::string json = file_text(folder.path() / "fit.json");
  const std::string page = file_text(folder.path() / "fit.html");
  const std::string calibrated_text = file_text(folder.path() / "slider.calibrated.yaml");
  CHECK(slipbench(folder, "calibrate fit.yaml").code == 0);
  CHECK(file_text(folder.path() / "fit.json") == json);
  CHECK(file_text(folder.path() / "fit.html") == page);
  CHECK(file_text(folder.path() / "slider.calibrated.yaml") == calibrated_text);
}

TEST_CASE("calibrate ends with 3 and a reason where nothing changes anything") {
  const TemporaryFolder folder;
  write_rig(folder);
  folder.write("rig.csv", "t,F\n0.05,6\n0.1,12\n0.15,18\n");  // it sticks, whatever mu is
  folder.write("fit.yaml",
               "slipbench: 1\n"
               "calibrate:\n"
               "  experiments: [{case: slider.yaml, set: {k: 50}, data: rig.csv, time: t, compare: "
               "{CSF1: F}}]\n"
               "  vary: {mu: {}}\n");
  const Ended ended = slipbench(folder, "calibrate fit.yaml");
  CAPTURE(ended.output);
  CHECK(ended.code == 3);
  CHECK(contains(ended.output, "NOT CONVERGED"));
}

TEST_CASE("faults of the fit end calibrate with 2, those of files with 4") {
  const TemporaryFolder folder;
  write_rig(folder);
  folder.write("bad.yaml", "slipbench: 1\ncalibrate:\n  experimets: []\n");
  const Ended bad = slipbench(folder, "calibrate bad.yaml");
  CHECK(bad.code == 2);
  CHECK(contains(bad.output, "bad.yaml:3:"));
  CHECK(contains(bad.output, "nothing was fitted"));
  CHECK(slipbench(folder, "calibrate nowhere.yaml").code == 4);
  CHECK(slipbench(folder, "calibrate fit.yaml -o rig.csv/results").code == 4);
  CHECK(slipbench(folder, "calibrate fit.yaml --report rig.csv/page.html").code == 4);
  CHECK(slipbench(folder, "calibrate fit.yaml --set mu").code == 2);
  CHECK(slipbench(folder, "calibrate slider.yaml").code == 2);
}

TEST_CASE("data that cannot be compared end calibrate with 2 and are named") {
  const TemporaryFolder folder;
  write_rig(folder);
  folder.write("rig.csv", "t,F\n0.1,1\n0.05,2\n");
  const Ended ended = slipbench(folder, "calibrate fit.yaml");
  CAPTURE(ended.output);
  CHECK(ended.code == 2);
  CHECK(contains(ended.output, "rig.csv:3"));
}

TEST_CASE("calibrate overwrites no file that it reads") {
  const TemporaryFolder folder;
  write_rig(folder);
  fs::copy_file(folder.path() / "rig.csv", folder.path() / "fit.json");
  folder.write("fit.yaml",
               "slipbench: 1\n"
               "calibrate:\n"
               "  experiments: [{case: slider.yaml, data: fit.json, time: t, compare: {CSF1: F}}]\n"
               "  vary: {mu: {}}\n");
  const std::string data = file_text(folder.path() / "fit.json");
  const Ended ended = slipbench(folder, "calibrate fit.yaml");
  CAPTURE(ended.output);
  CHECK(ended.code == 4);
  CHECK(contains(ended.output, "fit.json"));
  CHECK(file_text(folder.path() / "fit.json") == data);
  const Ended page = slipbench(folder, "calibrate fit.yaml --report slider.yaml");
  CHECK(page.code == 4);
  CHECK(file_text(folder.path() / "slider.yaml") == calibrate::SliderRig::case_text());
}

TEST_CASE("no picture of calibrate takes the place of a measurement") {
  const TemporaryFolder folder;
  write_rig(folder);
  const std::string name = "fit.loop.loop.svg";
  fs::copy_file(folder.path() / "rig.csv", folder.path() / name);
  folder.write("fit.yaml",
               "slipbench: 1\n"
               "calibrate:\n"
               "  experiments: [{name: loop, case: slider.yaml, data: fit.loop.loop.svg, time: t, "
               "compare: {CSF1: F}}]\n"
               "  vary: {mu: {}}\n");
  const std::string data = file_text(folder.path() / name);
  const Ended ended = slipbench(folder, "calibrate fit.yaml");
  CAPTURE(ended.output);
  CHECK(ended.code == 4);
  CHECK(contains(ended.output, "is an input"));
  // A link to the measurement where a picture would go.
  fs::create_directory(folder.path() / "out");
  fs::create_symlink("../" + name, folder.path() / "out" / name);
  CHECK(slipbench(folder, "calibrate fit.yaml -o out").code == 4);
  CHECK(file_text(folder.path() / name) == data);
}

TEST_CASE("the page of calibrate is no other result, and is written if it is asked for") {
  const TemporaryFolder folder;
  write_rig(folder);
  const auto before = files_in(folder);
  for (const char* page : {"./fit.json", "slider.calibrated.yaml"}) {
    const Ended ended = slipbench(folder, std::string("calibrate fit.yaml --report ") + page);
    CAPTURE(ended.output);
    CHECK(ended.code == 4);
    CHECK(contains(ended.output, "another result of this fit"));
  }
  const Ended none = slipbench(folder, "calibrate fit.yaml --no-output --report page.html");
  CAPTURE(none.output);
  CHECK(none.code == 2);
  CHECK(contains(none.output, "leave out --report"));
  CHECK(files_in(folder) == before);
}

TEST_CASE("a result that cannot be written is known before the fit") {
  const TemporaryFolder folder;
  write_rig(folder);
  fs::create_directory(folder.path() / "slider.calibrated.yaml");
  const Ended ended = slipbench(folder, "calibrate fit.yaml --report page.html");
  CAPTURE(ended.output);
  CHECK(ended.code == 4);
  CHECK(contains(ended.output, "slider.calibrated.yaml"));
  CHECK_FALSE(contains(ended.output, "converged"));
  CHECK_FALSE(fs::exists(folder.path() / "page.html"));
}

TEST_CASE("a fit file given to another command is told where it belongs") {
  const TemporaryFolder folder;
  write_rig(folder);
  for (const char* command : {"run fit.yaml", "plot fit.yaml", "report fit.yaml -o page.html"}) {
    CAPTURE(command);
    const Ended ended = slipbench(folder, command);
    CHECK(ended.code == 2);
    CHECK(contains(ended.output, "slipbench calibrate"));
  }
}

TEST_CASE("other values are set for the cases of a fit") {
  const TemporaryFolder folder;
  write_rig(folder);
  std::string text = calibrate::SliderRig::case_text();
  text.replace(text.find("N: 100"), 6, "N: 7");
  folder.write("slider.yaml", text);
  const Ended ended = slipbench(folder, "calibrate fit.yaml --set N=100 --no-output");
  CAPTURE(ended.output);
  CHECK(ended.code == 0);
  CHECK(contains(ended.output, "  mu         0.2997"));
}

}  // namespace slipbench::driver::commands
