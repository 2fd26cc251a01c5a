// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/report/fit_pictures.hpp"

#include <stdlib.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "driver/calibrate/report/fit_report.hpp"
#include "tests/driver/calibrate/report/made_fits.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::calibrate {
namespace {

namespace fs = std::filesystem;

bool no_gnuplot() {
  if (system("command -v gnuplot > /dev/null 2>&1") == 0) return false;
  WARN("gnuplot is not installed; nothing was drawn");
  return true;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

FitPictures draw_all(const TemporaryFolder& folder, const MadeFit& made) {
  return draw_fit_pictures(made.fit, made.calibration, folder.path(), "fit");
}

TEST_CASE("each experiment has a loop and its residuals, each table its ordinates") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  const FitPictures pictures = draw_all(folder, made_table_fit());
  CHECK(pictures.notes.empty());
  const std::vector<std::string> wanted{"fit.cold.loop.svg", "fit.cold.residuals.svg",
                                        "fit.hot.loop.svg", "fit.hot.residuals.svg",
                                        "fit.pad.coefficient.table.svg"};
  REQUIRE(pictures.written.size() == wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CHECK(pictures.written[i].filename() == wanted[i]);
    CHECK(contains(file_text(pictures.written[i]), "</svg>"));
  }
  const std::string loop = file_text(pictures.written[0]);
  CHECK(contains(loop, "position CP1 [mm]"));
  CHECK(contains(loop, "CSF1 [N]"));
  CHECK(contains(loop, "time t [s]"));
  CHECK(contains(loop, "measured"));
  const std::string table = file_text(pictures.written[4]);
  CHECK(contains(table, "slip rate [mm/s]"));
  CHECK(contains(table, "temperature 250 degC"));
  CHECK(contains(table, "6 of 12 cells never visited: slip_rate 200 .. 1000, temperature 20"));
  // Nothing but the pictures is left in the folder.
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 5);
}

TEST_CASE("a table of one independent has its band, and hatches what was never visited") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  const FitPictures pictures = draw_all(folder, made_curve_fit());
  REQUIRE(pictures.written.size() == 3);
  const std::string table = file_text(pictures.written[2]);
  CHECK(contains(table, "95 % interval"));
  CHECK(contains(table, "never visited"));
  CHECK(contains(table, "CP1 [mm]"));
  CHECK(contains(table, "force [N]"));
}

TEST_CASE("residuals say what they are, a long history is told to be thinned") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  const FitPictures trend = draw_all(folder, made_unconverged_fit());
  REQUIRE(trend.written.size() == 2);
  CHECK(contains(file_text(trend.written[1]), "A trend, no noise"));
  const FitPictures many = draw_all(folder, made_large_fit());
  REQUIRE(many.written.size() == 2);
  CHECK(contains(file_text(many.written[0]), "thinned"));
}

TEST_CASE("no picture has points of no size, which some programs cannot draw") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  for (const MadeFit& made : {made_slider_fit(), made_table_fit(), made_large_fit()}) {
    for (const fs::path& file : draw_all(folder, made).written) {
      CAPTURE(file);
      CHECK_FALSE(contains(file_text(file), "scale(0.00)"));
    }
  }
}

TEST_CASE("a picture does not take the place of an input, by whatever name") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  const MadeFit made = made_slider_fit();
  const std::vector<std::string> names = fit_picture_names(made.fit, "fit");
  const fs::path data = folder.path() / "data.csv";
  std::ofstream(data) << "t,F\n";
  fs::create_symlink("data.csv", folder.path() / names.at(0));
  const std::vector<std::string> inputs{data.string()};
  const FitPictures pictures =
      draw_fit_pictures(made.fit, made.calibration, folder.path(), "fit", {.inputs = inputs});
  CHECK(file_text(data) == "t,F\n");
  CHECK(pictures.written.size() + 1 == names.size());
  REQUIRE(pictures.notes.size() == 1);
  CHECK(contains(pictures.notes[0], "is an input"));
}

TEST_CASE("cells of which increments only met the edge are drawn as never visited") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  MadeFit made = made_table_fit();
  made.calibration.tables[0].cells[0].edge_only = true;
  const FitPictures pictures = draw_all(folder, made);
  REQUIRE(pictures.written.size() == 5);
  CHECK(contains(file_text(pictures.written[4]), "7 of 12 cells never visited: slip_rate 0 .. 10"));
  const std::string document = fit_document(made.fit, made.calibration);
  CHECK(contains(document, "\"visited\":false"));
}

TEST_CASE("names become names of files, and two that become one are numbered") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  MadeFit made = made_curve_fit();
  made.fit.experiments.push_back(made.fit.experiments[0]);
  made.calibration.experiments.push_back(made.calibration.experiments[0]);
  made.calibration.experiments[1].index = 1;
  made.fit.experiments[0].name = "../up and/down";
  made.fit.experiments[1].name = "../up and;down";
  const FitPictures pictures = draw_all(folder, made);
  CHECK(pictures.notes.empty());
  REQUIRE(pictures.written.size() == 5);
  for (const fs::path& file : pictures.written) CHECK(file.parent_path() == folder.path());
  CHECK(pictures.written[0].filename() == "fit.-..-up-and-down.loop.svg");
  CHECK(pictures.written[2].filename() == "fit.-..-up-and-down-2.loop.svg");
}

TEST_CASE("names that look like gnuplot or HTML are shown as they are") {
  if (no_gnuplot()) return;
  const TemporaryFolder folder;
  const FitPictures pictures = draw_all(folder, made_hostile_fit());
  CHECK(pictures.notes.empty());
  REQUIRE(pictures.written.size() == 7);
  const std::string loop = file_text(pictures.written[0]);
  CHECK(contains(loop, "&lt;script>window.broken"));
  CHECK_FALSE(contains(loop, "<script>window"));
}

TEST_CASE("without gnuplot there is a note and no picture") {
  const TemporaryFolder folder;
  const std::string path = getenv("PATH") == nullptr ? "" : getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const FitPictures pictures = draw_all(folder, made_slider_fit());
  setenv("PATH", path.c_str(), 1);
  CHECK(pictures.written.empty());
  REQUIRE(pictures.notes.size() == 1);
  CHECK(contains(pictures.notes[0], "not all pictures were drawn: gnuplot is not installed"));
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("a folder that cannot be written to is one note, no failure") {
  const FitPictures pictures = draw_fit_pictures(
      made_slider_fit().fit, made_slider_fit().calibration, "/proc/nowhere", "fit");
  CHECK(pictures.written.empty());
  REQUIRE(pictures.notes.size() == 1);
  CHECK(contains(pictures.notes[0], "not all pictures were drawn: "));
  CHECK(pictures.notes[0].back() != '\n');
}

}  // namespace
}  // namespace slipbench::driver::calibrate
