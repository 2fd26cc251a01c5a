// SPDX-License-Identifier: Apache-2.0
// The pictures of `slipbench plot --as`: what they say, and which inputs they refuse.
#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/commands/plot.hpp"
#include "driver/commands/run.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/drawn_coefficients.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/script.hpp"
#include "driver/read/read_case.hpp"
#include "driver/results/summary.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::driver::plot {
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
  const int code = commands::plot_command(options);
  return code == base::kExitOk ? file_text(options.output) : "exit code " + std::to_string(code);
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
  CHECK(contains(loops, ">cycle 2<"));
  // 4 x 20 N x (0.1 - 0.02) mm a cycle; first a quarter with 1.6, at the end another.
  CHECK(contains(loops, "dissipated 12.4 N mm, 6.4 N mm in the last full cycle"));

  const std::string history = picture(folder, file, "history");
  for (const char* text : {"position [mm]", "normal force [N]", "coefficient mu", "energy [N mm]",
                           "dissipated", "stored", "limit", "time t [s]"}) {
    INFO(text);
    CHECK(contains(history, text));
  }

  const std::string bands = picture(folder, file, "bands");
  CHECK(contains(bands, "of the time, 5 stick-slip events and 4 reversals<"));
  CHECK(contains(bands, "slips from here"));
  CHECK_FALSE(contains(bands, "no friction from here"));

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
  CHECK(contains(bands, "slips 66.7 % of the time, 1 stick-slip event<"));
  CHECK(contains(bands, "never slips, open 66.7 % of the time<"));
  CHECK(contains(bands, "no friction from here"));
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

TEST_CASE("the definitions of a result have bands, of very many the first") {
  if (no_gnuplot()) return;
  constexpr int kDefinitions = 400;
  std::string friction = "# title: Many\n# friction: d0 = CSF1.d0";
  std::string header = "t,CSF1.d0,STATUS.d0";
  for (int d = 1; d < kDefinitions; ++d) {
    friction += fmt::format(", d{0} = CSF1.d{0}", d);
    header += fmt::format(",CSF1.d{0},STATUS.d{0}", d);
  }
  std::string text = friction + "\n" + header + "\n";
  for (int i = 0; i < 300; ++i) {
    text += std::to_string(i);
    for (int d = 0; d < kDefinitions; ++d) text += i / 5 % 2 == 0 ? ",1,1" : ",1,2";
    text += '\n';
  }
  const TemporaryFolder folder;
  const std::string bands = picture(folder, folder.write("a.csv", text), "bands");
  CHECK(contains(bands, ">Many (the first 100 of 400 definitions)<"));
  CHECK(contains(bands, ">d99<"));
  CHECK_FALSE(contains(bands, ">d100<"));
  // No text of one is that of another.
  std::size_t facts = 0;
  for (std::size_t at = bands.find(">slips 50.2 %"); at != std::string::npos; ++facts) {
    at = bands.find(">slips 50.2 %", at + 1);
  }
  CHECK(facts == 100);
}

/// 12 increments of a sine, with its events within them.
constexpr const char* kCoarse = R"(slipbench: 1
title: Coarse
units: {length: mm, force: N, time: s}
connector: {type: SLOT}
friction:
  - predefined: {}
    coefficient: 0.2
    stick: {stiffness: 1000}
history:
  - {step: run, duration: 1.0, increments: 12, force: {f2: 500}, motion: {CP1: {sine: {amplitude: 0.5, frequency: 1.25}}}}
)";

TEST_CASE("regimes are those of the events, as the summary of a run tells them") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  const auto file = folder.write("coarse.yaml", kCoarse);
  read::ReadCase read = read::read_case(file.string());
  REQUIRE(read.value);
  results::Summary summary(*read.value);
  REQUIRE(bench::follow_case(*read.value,
                             [&](const bench::Simulation& run) { summary.add(run.row()); }));
  const results::DefinitionSummary& sum = summary.definitions()[0];
  const std::string told =
      fmt::format("slips {:.3g} % of the time, {} stick-slip events and {} reversals<",
                  100.0 * sum.slip_time, sum.events, sum.reversals);
  // By the rows, of which each tells one regime of all its increment, it would be 83.3 %.
  CHECK(sum.slip_time == Approx(0.688).margin(5e-4));
  CHECK(contains(picture(folder, file, "bands"), told));

  commands::RunOptions options;
  options.cases = {file.string()};
  options.folder = folder.path().string();
  REQUIRE(commands::run_command(options) == base::kExitOk);
  const fs::path result = folder.path() / "coarse.csv";
  CHECK(contains(picture(folder, result, "bands"), told));
  // Without the summary the sum is that of the events, without the events that of the rows.
  fs::remove(folder.path() / "coarse.json");
  CHECK(contains(picture(folder, result, "bands"),
                 fmt::format("slips {:.3g} % of the time", 100.0 * sum.slip_time)));
  // Events of another run do not count.
  const fs::path events = folder.path() / "coarse.events.csv";
  std::string others = file_text(events);
  others.replace(others.find("Coarse"), 6, "Course");
  folder.write("coarse.events.csv", others);
  CHECK(contains(picture(folder, result, "bands"), "slips 83.3 % of the time"));
}

TEST_CASE("slip within an increment begins where its event is, also in the shades of a history") {
  const TemporaryFolder folder;
  PlotOptions options;
  options.input = folder.write("coarse.yaml", kCoarse).string();
  const auto data = result_for_plot(options, folder.path() / "a.svg", results::PlotDetail::kForces);
  REQUIRE(data);
  const results::RegimeHistory& regimes = data->definitions[0].regimes;
  REQUIRE(regimes.spans.size() == 3);
  // The row's increment begins at 0; the limit is reached after 0.1 mm of the 0.304 mm it moves.
  CHECK(regimes.spans[0].from ==
        Approx(0.1 / (0.5 * std::sin(2.5 * std::numbers::pi / 12.0)) / 12.0));
}

TEST_CASE("a cyclic run's loops are whole cycles, told by their numbers") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  const auto cycles = [&](const std::string& length, const std::string& increments) {
    std::string text = kCoarse;
    text.replace(text.find("duration: 1.0, increments: 12"), 29,
                 "duration: " + length + ", increments: " + increments);
    return folder.write("cyclic.yaml", text);
  };
  PlotOptions options;
  options.input = cycles("100", "8000").string();
  const auto data = result_for_plot(options, folder.path() / "a.svg", results::PlotDetail::kState,
                                    WithLoops::kYes);
  REQUIRE(data);
  const results::PlotDefinition& definition = data->definitions[0];
  // Periods of 0.8 s are 64 increments; turning points lie on rows: after 3/4, 7/4 and so on.
  CHECK(definition.cycles == 125);
  std::vector<std::int64_t> numbers;
  for (const results::DrawnLoop& loop : definition.loops) numbers.push_back(loop.cycle);
  CHECK(numbers == std::vector<std::int64_t>{1, 2, 5, 10, 20, 50, 100, 125});
  const std::size_t columns = data->columns.size();
  const std::vector<double>& second = definition.loops[1].rows;
  CHECK(second.front() == Approx(0.75 * 0.8));
  CHECK(second[second.size() - columns] == Approx(1.75 * 0.8));
  // No row between is missing, as far as one could see it: the motion goes on in steps of an
  // increment at the most.
  const auto motion = static_cast<std::size_t>(definition.positions[0]);
  for (std::size_t at = columns; at < second.size(); at += columns) {
    CHECK(std::abs(second[at + motion] - second[at - columns + motion]) <
          0.5 * 2.0 * std::numbers::pi / 64.0);
  }
  for (const char* kind : {"hysteresis", ""}) {
    const std::string loops = picture(folder, options.input, kind);
    for (const char* text : {">cycle 1<", ">cycle 50<", ">cycle 125<", "loops: 8 of 125 cycles"}) {
      INFO(kind << " " << text);
      CHECK(contains(loops, text));
    }
    CHECK_FALSE(contains(loops, ">cycle 3<"));
  }
  // Of three cycles all are drawn, and nothing is told to be left out.
  const std::string three = picture(folder, cycles("2.4", "192"), "hysteresis");
  for (const char* text : {">cycle 1<", ">cycle 2<", ">cycle 3<", ">limit, cycle 3<"}) {
    CHECK(contains(three, text));
  }
  CHECK_FALSE(contains(three, "loops:"));
}

TEST_CASE("what does not move is a point that says so") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  std::string text = kCoarse;
  text.replace(text.find("{sine: {amplitude: 0.5, frequency: 1.25}}"), 41, "{to: 0}");
  CHECK(contains(picture(folder, folder.write("still.yaml", text), "hysteresis"),
                 "neither the motion nor the force changes"));
  CHECK_FALSE(contains(picture(folder, folder.write("coarse.yaml", kCoarse), "hysteresis"),
                       "neither the motion"));
}

TEST_CASE("a short time late in a run has tics and rows of its own") {
  const TemporaryFolder folder;
  std::string text = "# slipbench 0\n# friction: friction1 = CSF1\nt,CP1,CSF1\n";
  for (int i = 0; i <= 200; ++i) text += fmt::format("{:.10g},0,{}\n", 1000.0 + 5e-5 * i, i % 7);
  PlotOptions options;
  options.input = folder.write("late.csv", text).string();
  const fs::path name = folder.path() / "a.svg";
  const auto data = result_for_plot(options, name, results::PlotDetail::kForces);
  REQUIRE(data);
  PlotScript script;
  tell_rows(script, *data);
  auto begun = begin_picture(name, options, "friction.gp");
  REQUIRE(begun);
  const std::string told = script.text(*begun, "Late", 300);
  CHECK(contains(told, "TIME_FORMAT = '%.8g'"));
  CHECK(contains(told, "\n1000.00005 1 0\n1000.0001 2 0\n1000.00015 3 0\n"));
}

TEST_CASE("long headings of residuals are broken, and the tolerance beyond a panel is explained") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  std::string text = kSlider;
  const std::string check = text.substr(text.find("  - name: force"));
  text += check;
  const std::string name = "the force of a slider that is led to and fro by a triangle as it says";
  text.replace(text.rfind("name: force"), 11, "name: " + name);
  const std::string residuals = picture(folder, folder.write("slider.yaml", text), "residuals");
  CHECK_FALSE(contains(residuals, name));
  CHECK(contains(residuals, "PASS  the force of a slider that is led to and fro<"));
  CHECK(contains(residuals, "by a triangle as it says<"));
  CHECK(contains(residuals, "tolerance 1e-09, larger than this picture"));
}

TEST_CASE("a moment's history tells of moments") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  const auto result = folder.write("a.csv",
                                   "# slipbench 0\n# friction: spin = CSM1\n"
                                   "# columns: t [s], CSM1 [N mm], FN [N mm], CPR1 [rad]\n"
                                   "t,CSM1,FN,CPR1\n0,0,5,0\n1,1,5,1\n");
  const std::string history = picture(folder, result, "history");
  CHECK(contains(history, "normal moment [N mm]"));
  CHECK_FALSE(contains(history, "normal force"));
}

/// The relative luminance of "#rrggbb" (WCAG 2).
double luminance(const std::string& colour) {
  double sum = 0.0;
  constexpr std::array kWeights{0.2126, 0.7152, 0.0722};
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    sum += kWeights[i] * (part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
  }
  return sum;
}

TEST_CASE("in grey the parts of a stack can be told apart") {
  const std::string style = file_text(fs::path(test::source_dir()) / "plots/style.gp");
  std::string line = style.substr(style.find("array stack_colour[6]"));
  line = line.substr(0, line.find('\n'));
  std::vector<double> levels;
  for (std::size_t at = line.find('#'); at != std::string::npos; at = line.find('#', at + 1)) {
    levels.push_back(luminance(line.substr(at, 7)) + 0.05);
  }
  REQUIRE(levels.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = i + 1; k < 6; ++k) {
      INFO("colours " << i + 1 << " and " << k + 1);
      const double contrast = std::max(levels[i], levels[k]) / std::min(levels[i], levels[k]);
      CHECK(contrast > (k == i + 1 ? 2.5 : 1.5));
    }
  }
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
  CHECK(commands::plot_command(both) == base::kExitBadInput);
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
  PlotOptions options;
  options.input = "c.yaml";
  auto begun = begin_picture(folder.path() / "a.pdf", options, "bands.gp");
  REQUIRE(begun);
  PlotScript script;
  script.set("PLAIN", "it's");
  script.add("LIST", 0.1);
  script.add("LIST", std::nan(""));
  script.block("ROWS", "1 2\n");
  const std::string text = script.text(*begun, "A title", 300);
  CHECK(contains(text, "TERMINAL = \"pdfcairo"));
  CHECK(contains(text,
                 "TITLE = 'A title'\nTITLE_2 = ''\nHEIGHT = 300.0\nHEAD = 60.0\nDARK = 0\nPLAIN = "
                 "\"it\\047s\"\n"));
  CHECK(contains(text, "array LIST[2]\nLIST[1] = 0.1\nLIST[2] = NaN\n"));
  CHECK(contains(text, "$ROWS << END\n1 2\nEND\n"));
  CHECK(contains(text, "/style.gp'\n"));
  CHECK_FALSE(begin_picture(folder.path() / "a.gif", options, "bands.gp"));
}

}  // namespace
}  // namespace slipbench::driver::plot
