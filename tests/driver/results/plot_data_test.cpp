// SPDX-License-Identifier: Apache-2.0
#include "driver/results/plot_data.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::results {
namespace {

constexpr const char* kHead =
    "# slipbench 0\n# title: Two, of them\n"
    "# friction: sliding = CSFC(CSF2 CSF3), spinning = CSM1\n"
    "# columns: t [s], CP2 [mm], CSF2 [N], CSFC [N], STATUS.sliding [], FLIM.sliding [N]\n"
    "t,CP2,CSF2,CSFC,STATUS.sliding,FLIM.sliding\n";

TEST_CASE("a result says itself what is to be drawn") {
  const TemporaryFolder folder;
  std::string text = kHead;
  text += "0,0,0,0,1,5\n1,1,5,5,2,5\n";
  const auto file = folder.write("a.csv", text);
  const auto data = read_plot_data(file, "a.csv");
  REQUIRE(data);
  CHECK(data->title == "Two, of them");
  // CSF3 and all of 'spinning' are not in the file.
  REQUIRE(data->definitions.size() == 1);
  const PlotDefinition& sliding = data->definitions[0];
  CHECK(sliding.several);
  REQUIRE(sliding.components.size() == 1);
  CHECK(data->columns[static_cast<std::size_t>(sliding.components[0])].name == "CSF2");
  CHECK(data->columns[static_cast<std::size_t>(sliding.positions[0])].unit == "mm");
  CHECK(data->columns[static_cast<std::size_t>(sliding.limit)].name == "FLIM.sliding");
  REQUIRE(sliding.regimes.spans.size() == 1);
  CHECK(sliding.regimes.spans[0].from == 0.0);
  CHECK(sliding.regimes.spans[0].to == 1.0);
  CHECK(sliding.regimes.spans[0].status == 2);
}

TEST_CASE("a result names a definition once, and not more than it may have columns") {
  const TemporaryFolder folder;
  const auto error_of = [&](const std::string& definitions) {
    const auto file = folder.write("a.csv", "# friction: " + definitions + "\nt,CSF1\n0,1\n1,2\n");
    const auto data = read_plot_data(file, "a.csv");
    return data ? std::string() : data.error().message;
  };
  CHECK(error_of("a = CSF1, b = CSF1").empty());
  CHECK(error_of("a = CSF1, b = CSF1, a = CSF2") ==
        "its line '# friction:' names 'a' twice: run the case again");
  std::string many = "d0 = CSF1";
  for (int d = 1; d <= 10000; ++d) many += ", d" + std::to_string(d) + " = CSF1";
  CHECK(error_of(many) == "its line '# friction:' names 10001 definitions, at most 10000 are read");
}

TEST_CASE("a ring is drawn over its own flow where the result has it") {
  const TemporaryFolder folder;
  const auto file =
      folder.write("belt.csv",
                   "# slipbench 0\n# title: belt\n# friction: r1 = CSF2.r1, r2 = CSF2.r2\n"
                   "# columns: t [s], CP2 [mm], CSF2.r1 [N], CP2.r2 [mm], CSF2.r2 [N]\n"
                   "t,CP2,CSF2.r1,CP2.r2,CSF2.r2\n0,0,0,0,0\n1,1,5,2,6\n");
  const auto data = read_plot_data(file, "belt.csv");
  REQUIRE(data);
  REQUIRE(data->definitions.size() == 2);
  const auto drawn_over = [&](std::size_t d) {
    return data->columns[static_cast<std::size_t>(data->definitions[d].positions[0])].name;
  };
  CHECK(drawn_over(0) == "CP2");
  CHECK(drawn_over(1) == "CP2.r2");
}

TEST_CASE("a long result is thinned but keeps its ends and extremes") {
  const TemporaryFolder folder;
  std::string text = kHead;
  for (int i = 0; i <= 20000; ++i) {
    const int force = i == 12345 ? 99 : i % 7;
    const int status = i > 5000 && i % 2 == 0 ? 2 : 1;
    text +=
        std::to_string(i) + ",0," + std::to_string(force) + ",0," + std::to_string(status) + ",5\n";
  }
  const auto data = read_plot_data(folder.write("a.csv", text), "a.csv", PlotDetail::kForces, 25);
  REQUIRE(data);
  CHECK(data->rows.size() <= std::size_t{104} * data->columns.size());
  CHECK(data->rows.front() == 0.0);
  CHECK(data->rows[data->rows.size() - data->columns.size()] == 20000.0);
  CHECK(std::find(data->rows.begin(), data->rows.end(), 99.0) != data->rows.end());
  const auto force = static_cast<std::size_t>(data->definitions[0].components[0]);
  CHECK(data->highest[force] == 99.0);
  CHECK(data->rows_in_all == 20001);
  // Slip and stick that alternate faster than the picture resolves are one span, which says so.
  const RegimeHistory& regimes = data->definitions[0].regimes;
  REQUIRE(regimes.spans.size() == 1);
  CHECK(regimes.spans[0].merged);
  // Its length is not the time in slip: that is every other second from 5001 to 20000.
  CHECK(regimes.slip_time == 7500.0);
  CHECK(regimes.slip_begins == 7500);
}

TEST_CASE("a file without friction is refused") {
  const TemporaryFolder folder;
  const auto data = read_plot_data(folder.write("a.csv", "t,x\n0,1\n1,2\n"), "a.csv");
  REQUIRE_FALSE(data);
  CHECK(data.error().kind == base::HistoryError::Kind::kInput);
}

}  // namespace
}  // namespace slipbench::driver::results
