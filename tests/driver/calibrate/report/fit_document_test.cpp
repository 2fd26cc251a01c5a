// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "driver/calibrate/report/fit_report.hpp"
#include "tests/driver/calibrate/report/made_fits.hpp"
#include "tests/driver/report/case_for_test.hpp"

namespace slipbench::driver::calibrate {
namespace {

yaml::Tree tree_of_fit(const MadeFit& made) {
  return report::tree_of(fit_document(made.fit, made.calibration));
}

yaml::Node member(const yaml::Node& node, const char* name) {
  const auto found = node.find(name);
  INFO(name);
  REQUIRE(found);
  return *found;
}
std::string text(const yaml::Node& node, const char* name) {
  return std::string(member(node, name).text());
}

TEST_CASE("the document of a fit has the verdict, the figures and every unknown") {
  const MadeFit made = made_slider_fit();
  const yaml::Tree tree = tree_of_fit(made);
  const yaml::Node root = tree.root();
  CHECK(text(root, "schema") == "1");
  CHECK(text(root, "title") == made.fit.title);
  CHECK(text(root, "date") == "2026-11-21");
  const yaml::Node verdict = member(root, "verdict");
  CHECK(text(verdict, "converged") == "true");
  CHECK(text(verdict, "start_cost") == "5321.5");
  CHECK(text(verdict, "cost") == "24.11");
  CHECK(text(member(root, "figures"), "data") == "1200");
  CHECK(text(member(root, "figures"), "bootstrap") == "198");
  const yaml::Node unknowns = member(root, "unknowns");
  REQUIRE(unknowns.size() == 3);
  CHECK(text(unknowns[1], "name") == "stick_stiffness");
  CHECK(text(unknowns[1], "scale") == "log");
  CHECK(text(unknowns[1], "value") == "400");
  CHECK(text(unknowns[1], "error") == "12");
  CHECK(text(unknowns[2], "seen") == "weak");
  CHECK(text(unknowns[2], "why") == "only its product with mu is told");
  // No upper bound: JSON has no infinity.
  CHECK(text(unknowns[2], "upper") == "null");
  const yaml::Node profiles = member(root, "profiles");
  REQUIRE(profiles.size() == 3);
  CHECK(text(profiles[2], "open_above") == "true");
  CHECK(member(root, "searches").size() == 8);
  CHECK(member(member(root, "correlation"), "rows").size() == 3);
}

TEST_CASE("experiments carry their points, what is left of them and where they are from") {
  const MadeFit made = made_slider_fit();
  const yaml::Tree tree = tree_of_fit(made);
  const yaml::Node experiments = member(tree.root(), "experiments");
  REQUIRE(experiments.size() == 3);
  CHECK(text(experiments[0], "held_out") == "false");
  CHECK(text(experiments[2], "held_out") == "true");
  CHECK(text(experiments[0], "time_unit") == "s");
  CHECK(text(experiments[0], "hash").size() == 64);
  const yaml::Node response = member(experiments[0], "responses")[0];
  CHECK(member(response, "measured").size() == 600);
  CHECK(member(response, "positions").size() == 600);
  CHECK(text(response, "position_unit") == "mm");
  CHECK(text(response, "points") == "600");
  CHECK(text(response, "thinned") == "false");
  CHECK(member(member(response, "left"), "lags").size() == 40);
  CHECK(text(member(response, "left"), "trend") == "false");
}

TEST_CASE("many points are thinned, what is told of the residuals is that of all") {
  const MadeFit made = made_large_fit();
  const std::string document = fit_document(made.fit, made.calibration);
  const yaml::Tree tree = report::tree_of(document);
  const yaml::Node response = member(member(tree.root(), "experiments")[0], "responses")[0];
  CHECK(text(response, "points") == "20000");
  CHECK(text(response, "thinned") == "true");
  CHECK(member(response, "time").size() <= 3000);
  std::int64_t counted = 0;
  const yaml::Node counts = member(member(response, "left"), "counts");
  for (std::size_t i = 0; i < counts.size(); ++i)
    counted += std::stoll(std::string(counts[i].text()));
  CHECK(counted == 20000);
  CHECK(document.size() < 600000);
}

TEST_CASE("tables have their blocks, cells and the place of their unknowns") {
  const MadeFit made = made_table_fit();
  const yaml::Tree tree = tree_of_fit(made);
  const yaml::Node root = tree.root();
  const yaml::Node table = member(root, "tables")[0];
  CHECK(text(table, "free") == "mu");
  CHECK(text(table, "count") == "20");
  CHECK(text(table, "cell_grid") == "true");
  CHECK(member(table, "blocks").size() == 4);
  CHECK(member(table, "cells").size() == 12);
  const yaml::Node never = member(root, "unknowns")[19];
  CHECK(text(never, "seen") == "never_visited");
  CHECK(text(never, "frozen") == "true");
  CHECK(text(never, "error") == "null");
  CHECK(text(never, "table") == "0");
  // Correlations are shown of those that the data see.
  CHECK(member(member(root, "correlation"), "unknowns").size() == 12);
}

TEST_CASE("of very many unknowns the correlations of those that have the strongest are told") {
  MadeFit made = made_slider_fit();
  Calibration& calibration = made.calibration;
  constexpr std::size_t kMany = 60;
  calibration.unknowns.assign(kMany, calibration.unknowns[0]);
  calibration.statistics.correlation.assign(kMany * kMany, 0.0);
  for (std::size_t i = 0; i < kMany; ++i) calibration.statistics.correlation[i * kMany + i] = 1.0;
  calibration.statistics.correlation[57 * kMany + 3] = -0.99;
  calibration.statistics.correlation[3 * kMany + 57] = -0.99;
  const yaml::Tree tree = tree_of_fit(made);
  const yaml::Node shown = member(member(tree.root(), "correlation"), "unknowns");
  REQUIRE(shown.size() == 40);
  CHECK(shown[3].text() == "3");
  CHECK(shown[39].text() == "57");
}

TEST_CASE("a fit that found nothing is told all the same") {
  MadeFit made = made_unconverged_fit();
  made.calibration.statistics = {};
  made.calibration.fit = {};
  const yaml::Tree tree = tree_of_fit(made);
  CHECK(text(member(tree.root(), "verdict"), "converged") == "false");
  CHECK(text(member(tree.root(), "unknowns")[0], "error") == "null");
  CHECK(member(member(tree.root(), "correlation"), "rows").size() == 0);
}

TEST_CASE("nothing in a document looks like HTML, and the same fit gives the same bytes") {
  const MadeFit made = made_hostile_fit();
  const std::string document = fit_document(made.fit, made.calibration);
  CHECK(document.find('<') == std::string::npos);
  Calibration slower = made.calibration;
  slower.seconds = 99.0;
  CHECK(fit_document(made.fit, slower) == document);
  const yaml::Tree tree = report::tree_of(document);
  CHECK(text(tree.root(), "title") == made.fit.title);
}

}  // namespace
}  // namespace slipbench::driver::calibrate
