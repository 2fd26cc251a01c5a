// SPDX-License-Identifier: Apache-2.0
// The pictures of `slipbench plot --as`: what they say, and which inputs they refuse.
#include "driver/commands/plot.hpp"

#include <stdlib.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "driver/commands/drawn_coefficients.hpp"
#include "driver/commands/plot_script.hpp"
#include "driver/exit_code.hpp"
#include "tests/driver/history/temporary_folder.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSlider = R"(slipbench: 1
title: Slider
units: {length: mm, force: N, time: s}
parameters: {mu: 0.2}
connector: {type: SLOT}
friction:
  - predefined: {internal_contact_force: 20}
    coefficient: = mu
    stick: {stiffness: 1000}
history:
  - {step: press, duration: 1, increments: 1, force: {f2: 80}}
  - {step: cycle, duration: 2, increments: 80, motion: {CP1: {triangle: {amplitude: 0.1, period: 1}}}}
checks:
  - name: force
    quantity: CSF1
    against: {closed_form: coulomb_slider, with: {mu: 0.2, normal_force: 100, stick_stiffness: 1000}, inputs: {motion: CU1}, output: force}
    tolerance: {absolute: 1.0e-9, why: rounding}
)";

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Draws into the folder; the SVG if that went well, else the exit code as a text.
std::string picture(const TemporaryFolder& folder, const fs::path& input, const std::string& kind,
                    const std::vector<std::string>& settings = {}) {
  PlotOptions options;
  options.input = input.string();
  options.kind = kind;
  options.settings = settings;
  options.output = (folder.path() / "picture.svg").string();
  fs::remove(options.output);
  const int code = plot_command(options);
  return code == kExitOk ? read(options.output) : "exit code " + std::to_string(code);
}

bool no_gnuplot() {
  if (system("command -v gnuplot > /dev/null 2>&1") == 0) return false;
  WARN("gnuplot is not installed; nothing was drawn");
  return true;
}

TEST_CASE("a picture of a case: loops, history, bands, shares and residuals") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  const auto file = folder.write("slider.yaml", kSlider);

  const std::string loops = picture(folder, file, "hysteresis");
  CHECK(contains(loops, "friction force CSF1 [N]"));
  CHECK(contains(loops, "position CP1 [mm]"));
  CHECK(contains(loops, "last full cycle"));
  // 4 x 20 N x (0.1 - 0.02) mm a cycle; first a quarter with 1.6, at the end another.
  CHECK(contains(loops, "dissipated 12.4 N mm, 6.4 N mm in the last full cycle"));

  const std::string history = picture(folder, file, "history");
  for (const char* text : {"position [mm]", "normal force [N]", "coefficient mu", "energy [N mm]",
                           "dissipated", "stored", "limit", "time t [s]"}) {
    INFO(text);
    CHECK(contains(history, text));
  }

  const std::string bands = picture(folder, file, "bands");
  CHECK(contains(bands, "of the time, 9 changes"));
  CHECK(contains(bands, "slips from here"));
  CHECK_FALSE(contains(bands, "lifts off"));

  const std::string shares = picture(folder, file, "shares");
  CHECK(contains(shares, "forces across axis 1 (f2 f3)"));
  CHECK(contains(shares, "internal contact force"));

  const std::string residuals = picture(folder, file, "residuals");
  CHECK(contains(residuals, "PASS  force"));
  CHECK(contains(residuals, "tolerance 1e-09"));
  CHECK(contains(residuals, "residual [N]"));
  const std::string failing = picture(folder, file, "residuals", {"mu=0.25"});
  CHECK(contains(failing, "FAIL  force"));
  // Nothing but the case and the picture is left behind.
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 2);
}

TEST_CASE("a picture of a result needs only what it shows") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  const auto result = folder.write(
      "a.csv",
      "# slipbench 0\n# title: Two\n# friction: sleeve = CSF1, spin = CSM1\n"
      "# columns: t [s], CSF1 [N], STATUS.sleeve [], CSM1 [N mm], STATUS.spin []\n"
      "t,CSF1,STATUS.sleeve,CSM1,STATUS.spin\n0,0,1,0,1\n1,5,2,0,1\n2,5,2,0,0\n3,1,1,0,0\n");
  const std::string bands = picture(folder, result, "bands");
  CHECK(contains(bands, "sleeve"));
  CHECK(contains(bands, "slip 66.7 % of the time, 1 change<"));
  CHECK(contains(bands, "no contact 66.7 %, 1 change<"));
  CHECK(contains(bands, "lifts off"));
  // No motion, no energy, no limit: panels without curves, not a failure.
  CHECK(contains(picture(folder, result, "history"), "Two"));
  CHECK(contains(picture(folder, result, "hysteresis"), "Two"));

  for (const char* kind : {"shares", "mu_map", "residuals"}) {
    INFO(kind);
    CHECK(picture(folder, result, kind) == "exit code 2");
  }
  const auto plain = folder.write("b.csv", "# friction: friction1 = CSF1\nt,CSF1\n0,0\n1,5\n");
  CHECK(picture(folder, plain, "bands") == "exit code 2");
}

TEST_CASE("what a case does not have is not drawn") {
  const TemporaryFolder folder;
  std::string text = kSlider;
  text.erase(text.find("checks:"));
  const auto file = folder.write("slider.yaml", text);
  CHECK(picture(folder, file, "residuals") == "exit code 2");
  CHECK(picture(folder, file, "mu_map") == "exit code 2");
  CHECK(picture(folder, file, "volcano") == "exit code 2");
  PlotOptions both;
  both.input = file.string();
  both.output = (folder.path() / "a.svg").string();
  both.kind = "history";
  both.law = true;
  CHECK(plot_command(both) == kExitBadInput);
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("a map is drawn over the first two arguments of a coefficient") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  std::string text = kSlider;
  text.replace(text.find("coefficient: = mu"), 17,
               "coefficient: {columns: [mu, temperature, field1], rows: [[0.3, 20, 0], [0.2, 120, "
               "0], [0.25, 20, 1], [0.1, 120, 1]]}");
  text.replace(text.find("force: {f2: 80}"), 15,
               "force: {f2: 80}, temperature: 20, fields: {field1: 0.5}");
  const std::string map = picture(folder, folder.write("table.yaml", text), "mu_map");
  INFO(map.substr(0, 200));
  CHECK(contains(map, "temperature"));
  CHECK(contains(map, "field1"));
  CHECK(contains(map, "point of the table"));
  CHECK(contains(map, "visited in slip"));
}

TEST_CASE("visited states of a long run are thinned, their ranges are not") {
  VisitedStates visited;
  for (int i = 0; i < 100000; ++i) {
    visited.add({.slip_rate = i == 77777 ? 9.0 : 1.0, .argument = {i == 12345 ? -3.0 : 1.0, 0.0}});
  }
  CHECK(visited.states().size() < 20000);
  CHECK(visited.states().size() > 5000);
  CHECK(visited.largest_slip_rate() == 9.0);
  CHECK(visited.range(0)[0] == -3.0);
  CHECK(visited.range(0)[1] == 1.0);
}

TEST_CASE("a script tells numbers and texts so that gnuplot reads them back") {
  const TemporaryFolder folder;
  auto begun = begin_picture(folder.path() / "a.pdf", "c.yaml", "bands.gp");
  REQUIRE(begun);
  PlotScript script;
  script.set("PLAIN", "it's");
  script.add("LIST", 0.1);
  script.add("LIST", std::nan(""));
  script.block("ROWS", "1 2\n");
  const std::string text = script.text(*begun, "A title", 300);
  CHECK(contains(text, "TERMINAL = \"pdfcairo"));
  CHECK(contains(text, "TITLE = 'A title'\nHEIGHT = 300.0\nPLAIN = 'it''s'\n"));
  CHECK(contains(text, "array LIST[2]\nLIST[1] = 0.1\nLIST[2] = NaN\n"));
  CHECK(contains(text, "$ROWS << END\n1 2\nEND\n"));
  CHECK(contains(text, "/style.gp'\n"));
  CHECK_FALSE(begin_picture(folder.path() / "a.gif", "c.yaml", "bands.gp"));
}

}  // namespace
}  // namespace slipbench::driver
