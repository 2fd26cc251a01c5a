// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/report/table_view.hpp"

#include <catch2/catch.hpp>

#include "tests/driver/calibrate/report/made_fits.hpp"

namespace slipbench::driver::calibrate {
namespace {

TEST_CASE("a table of two independents is a grid with a block for each of the second") {
  const TableView view = table_view(made_table_fit().calibration.tables[0]);
  REQUIRE(view.axes.size() == 2);
  CHECK(view.axes[0].name == "slip rate");
  CHECK(view.axes[0].unit == "mm/s");
  CHECK(view.axes[0].knots == std::vector<double>{0.0, 10.0, 50.0, 200.0, 1000.0});
  CHECK(view.axes[1].knots == std::vector<double>{20.0, 100.0, 250.0, 400.0});
  CHECK(view.grid);
  CHECK(view.cell_grid);
  REQUIRE(view.blocks.size() == 4);
  CHECK(view.blocks[2].label == "temperature 250 degC");
  CHECK(view.blocks[2].first == 10);
}

TEST_CASE("knots that would hide each other are drawn equally far apart") {
  const TableView uneven = table_view(made_table_fit().calibration.tables[0]);
  CHECK(uneven.even);
  CHECK(uneven.blocks[0].place == std::vector<double>{0.0, 1.0, 2.0, 3.0, 4.0});
  const TableView regular = table_view(made_curve_fit().calibration.tables[0]);
  CHECK_FALSE(regular.even);
  CHECK(regular.blocks[0].place == regular.blocks[0].abscissa);
}

TEST_CASE("a table of one independent is one block without a label") {
  const TableView view = table_view(made_curve_fit().calibration.tables[0]);
  REQUIRE(view.blocks.size() == 1);
  CHECK(view.blocks[0].label.empty());
  CHECK(view.blocks[0].abscissa.size() == 9);
  CHECK(view.cell_grid);
}

TEST_CASE("ragged blocks are no grid, and other cells than those between knots are none") {
  FittedTable table;
  table.columns = {"CP1", "temperature"};
  table.points = {{0.0, 20.0}, {1.0, 20.0}, {0.0, 90.0}, {0.5, 90.0}};
  table.count = 4;
  table.cells = {{"a", 1}, {"b", 0}};
  const TableView ragged = table_view(table);
  CHECK_FALSE(ragged.grid);
  CHECK_FALSE(ragged.cell_grid);
  CHECK(ragged.axes[0].knots == std::vector<double>{0.0, 0.5, 1.0});
  REQUIRE(ragged.blocks.size() == 2);
  CHECK(ragged.blocks[1].abscissa == std::vector<double>{0.0, 0.5});
  CHECK(ragged.blocks[1].label == "temperature 90");
  FittedTable curve = made_curve_fit().calibration.tables[0];
  curve.cells.push_back({"below the table", 3});
  CHECK(table_view(curve).grid);
  CHECK_FALSE(table_view(curve).cell_grid);
}

TEST_CASE("a table without rows has no blocks") {
  const TableView view = table_view(FittedTable{});
  CHECK(view.blocks.empty());
  CHECK_FALSE(view.grid);
}

}  // namespace
}  // namespace slipbench::driver::calibrate
