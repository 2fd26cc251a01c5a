// SPDX-License-Identifier: Apache-2.0
// Pictures of columns that are asked for by name, of several inputs, of any size; and of
// vibrations.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "driver/plot/kinds.hpp"
#include "driver/plot/look.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::plot {
namespace {

namespace fs = std::filesystem;

/// A result of a sine of 4 N at 12.5 per unit of time.
std::string result_of(const std::string& title, const std::string& time, const std::string& force) {
  std::string text = fmt::format(
      "# slipbench 0\n# title: {}\n# friction: friction1 = CSF1\n"
      "# columns: t [{}], CP1 [mm], CV1 [mm/{}], CSF1 [{}], FN [{}]\nt,CP1,CV1,CSF1,FN\n",
      title, time, time, force, force);
  for (int i = 0; i <= 2000; ++i) {
    const double turn = 2.0 * std::numbers::pi * 12.5 * 0.001 * i;
    text += fmt::format("{:.10g},{:.10g},{:.10g},{:.10g},{}\n", 0.001 * i, std::cos(turn),
                        -std::sin(turn), 4.0 * std::sin(turn), 100);
  }
  return text;
}

/// Draws; the SVG if that went well, else the message.
std::string drawn(const TemporaryFolder& folder, const PlotOptions& options) {
  const fs::path file = folder.path() / "picture.svg";
  fs::remove(file);
  if (const auto done = draw_picture(options, file); !done) return done.error().message;
  return file_text(file);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_CASE("several results lie over each other, with their names") {
  const TemporaryFolder folder;
  PlotOptions options;
  options.input = folder.write("one.csv", result_of("One", "s", "N")).string();
  options.more = {folder.write("other.csv", result_of("Other", "s", "N")).string()};
  const std::string both = drawn(folder, options);
  for (const char* text : {">one<", ">other<", "friction force CSF1 [N]", "position CP1 [mm]"}) {
    INFO(text);
    CHECK(contains(both, text));
  }
  options.y = {"CSF1", "FN"};
  const std::string four = drawn(folder, options);
  for (const char* text : {">one: CSF1<", ">other: FN<", "time t [s]", "CSF1, FN [N]"}) {
    INFO(text);
    CHECK(contains(four, text));
  }
  options.y = {"CV1"};
  options.x = "CSF1";
  CHECK(contains(drawn(folder, options), "velocity CV1 [mm/s]"));
}

TEST_CASE("curves of other units, and columns that are not there, are told of") {
  const TemporaryFolder folder;
  PlotOptions options;
  options.input = folder.write("one.csv", result_of("One", "s", "N")).string();
  const std::string other = folder.write("other.csv", result_of("Other", "s", "kN")).string();
  options.more = {other};
  CHECK(drawn(folder, options) ==
        fmt::format("slipbench: error: {}: CSF1 is in kN, CSF1 of {} in N; the curves of one "
                    "picture share their axes\n",
                    other, options.input));
  options.more.clear();
  options.y = {"CSF2"};
  CHECK(drawn(folder, options) ==
        fmt::format("slipbench: error: {}: has no column 'CSF2'; did you mean 'CSF1'?; the first "
                    "line without '#' of a result lists its columns, 'slipbench list quantities' "
                    "tells what they are\n",
                    options.input));
  options.y = {"FN", "CP1"};
  CHECK(contains(drawn(folder, options), "CP1 is in mm, FN in N; the curves"));
  options.kind = "history";
  CHECK(contains(drawn(folder, options), "--as history chooses its columns itself"));
  options.y.clear();
  options.more = {other};
  CHECK(contains(drawn(folder, options), "--as history draws one case or result"));
  options.kind.clear();
  options.law = true;
  CHECK(contains(drawn(folder, options), "--law draws the coefficients of one case"));
  options.more.clear();
  options.kind = "hysteresis";
  CHECK(contains(drawn(folder, options), "'--as mu_map', without --law"));
}

/// Returns what `mu` and `load` are is written behind it.
constexpr const char* kLaw = R"(slipbench: 1
title: Law
units: {length: mm, force: N, time: s}
connector: {type: SLOT}
friction:
  - predefined: {}
    coefficient: {exponential_decay: {static: = mu, kinetic: 0.2, decay: 0.05}}
    stick: {stiffness: 1000}
)";

TEST_CASE("a law is drawn without a run where the case has none, and says so") {
  const TemporaryFolder folder;
  PlotOptions options;
  options.law = true;
  const std::string history =
      "history:\n  - {step: press, duration: 1, increments: 1, force: {f2: = load}}\n";
  // A history that is missing, and one that lacks a value.
  for (const std::string& rest :
       {std::string("parameters: {mu: 0.3}\n"), "parameters: {mu: 0.3, load: }\n" + history}) {
    options.input = folder.write("law.yaml", kLaw + rest).string();
    const std::string picture = drawn(folder, options);
    INFO(rest << picture.substr(0, 300));
    CHECK(contains(picture, "no run: the case is not complete"));
    CHECK(contains(picture, "slip rate V [mm/s]"));
    CHECK_FALSE(contains(picture, "visited in"));
  }
  // A value that the law needs is missed as ever.
  options.input =
      folder.write("law.yaml", kLaw + ("parameters: {mu: , load: 5}\n" + history)).string();
  CHECK(contains(drawn(folder, options), "parameters.mu: wanted a number, found nothing"));
  // A table of the temperature only is one for a map.
  std::string table = kLaw;
  const std::string law = "{exponential_decay: {static: = mu, kinetic: 0.2, decay: 0.05}}";
  table.replace(table.find(law), law.size(),
                "{columns: [mu, temperature], rows: [[0.3, 20], [0.2, 80]]}");
  options.input = folder.write("law.yaml", table).string();
  CHECK(contains(drawn(folder, options),
                 "depends on the slip rate or the normal force: '--as mu_map' draws it over"));
  options.input = "exponential_decay";
  CHECK(contains(drawn(folder, options), "exponential_decay with the parameters of its example"));
}

TEST_CASE("a spectrum tells amplitude and frequency in the units of the result") {
  const TemporaryFolder folder;
  PlotOptions options;
  options.kind = "spectrum";
  options.input = folder.write("s.csv", result_of("Seconds", "s", "N")).string();
  const std::string seconds = drawn(folder, options);
  for (const char* text :
       {"4 N at 12.5 Hz", "frequency [Hz]", "amplitude of friction force CSF1 [N]"}) {
    INFO(text);
    CHECK(contains(seconds, text));
  }
  options.input = folder.write("ms.csv", result_of("Milliseconds", "ms", "kN")).string();
  const std::string milliseconds = drawn(folder, options);
  CHECK(contains(milliseconds, "4 kN at 12.5 1/ms"));
  CHECK(contains(milliseconds, "frequency [1/ms]"));
  options.y = {"CV1"};
  CHECK(contains(drawn(folder, options), " mm/ms at 12.5 1/ms"));
  options.y = {"FN"};
  CHECK(contains(drawn(folder, options), "FN does not vibrate: its spectrum has no peak"));
}

TEST_CASE("a phase portrait draws velocity over position, and tells the time") {
  const TemporaryFolder folder;
  PlotOptions options;
  options.kind = "phase_portrait";
  options.input = folder.write("s.csv", result_of("Seconds", "s", "N")).string();
  const std::string portrait = drawn(folder, options);
  for (const char* text : {"velocity CV1 [mm/s]", "position CP1 [mm]", "time t [s]"}) {
    INFO(text);
    CHECK(contains(portrait, text));
  }
}

TEST_CASE("a picture of any size is its layout to scale, with all its text") {
  const TemporaryFolder folder;
  PlotOptions options;
  options.input = folder.write("s.csv", result_of("Seconds", "s", "N")).string();
  CHECK(contains(drawn(folder, options), "width=\"1200\" height=\"500\""));
  options.look = *parse_size("800x500");
  const std::string small = drawn(folder, options);
  CHECK(contains(small, "width=\"800\" height=\"500\""));
  CHECK(contains(small, "viewBox=\"0 0 1200 750\""));
  options.look.dark = true;
  CHECK(contains(drawn(folder, options), "fill=\"#16191d\""));

  const Canvas tall = canvas_of(*parse_size("300x3000"), 500.0);
  CHECK(tall.width == 1200.0);
  CHECK(tall.height == 12000.0);
  CHECK(tall.scale == 0.25);
  const Canvas flat = canvas_of(*parse_size("2000x250"), 500.0);
  CHECK(flat.width == 4000.0);
  CHECK(flat.scale == 0.5);
  for (const char* text :
       {"", "800", "800x", "x500", "800x5e2", "100x500", "800x99999", "8 00x500"}) {
    INFO(text);
    const auto wrong = parse_size(text);
    REQUIRE_FALSE(wrong);
    CHECK(contains(wrong.error(), "wanted WIDTHxHEIGHT in pixels, each from 200 to 10000"));
  }
}

}  // namespace
}  // namespace slipbench::driver::plot
