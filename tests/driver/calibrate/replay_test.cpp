// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/replay.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "driver/read/read_case.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::driver::calibrate {
namespace {

std::vector<law::FrictionDefinition> laws_of(const cases::Case& problem) {
  std::vector<law::FrictionDefinition> laws;
  for (const cases::CaseDefinition& definition : problem.definitions)
    laws.push_back(definition.law);
  return laws;
}

/// Every row, and the middle between every two rows.
std::vector<Replay::Point> all_points(std::size_t rows) {
  std::vector<Replay::Point> points;
  for (std::size_t i = 0; i < rows; ++i) {
    points.push_back({i, 0.0});
    if (i + 1 < rows) points.push_back({i, 0.5});
  }
  return points;
}

Replay recorded(const cases::Case& problem) {
  auto replay = Replay::record(problem);
  INFO((replay ? std::string() : replay.error()));
  REQUIRE(replay);
  return *std::move(replay);
}

std::string refusal(const cases::Case& problem) {
  const auto replay = Replay::record(problem);
  REQUIRE_FALSE(replay);
  return replay.error();
}

std::uint64_t bits(double x) {
  std::uint64_t result = 0;
  std::memcpy(&result, &x, sizeof x);
  return result;
}

TEST_CASE("a force that jumps ends a replay as it ends a run, unless the case goes through") {
  cases::Case problem = bench::slider_case({bench::step("out", 4, 0, history::LinearTo{2.0})});
  law::Table table;
  law::TableError error;
  REQUIRE(law::Table::build(std::vector<std::vector<double>>{{6000, 0}, {0, 1}}, 1, 1,
                            law::Extrapolation::kConstant, &table, &error));
  problem.definitions[0].law.internal_contact_force =
      law::TableFunction(table, {{law::IndependentKind::kAccumulatedSlip}});
  CHECK_FALSE(recorded(problem).show(laws_of(problem)));
  problem.integration.snap_back = cases::SnapBackAction::kJump;
  CHECK(recorded(problem).show(laws_of(problem)));
}

TEST_CASE("every shipped case is replayed bit by bit, or says why not") {
  const std::filesystem::path root = test::source_dir();
  int replayed = 0;
  int refused = 0;
  for (const char* folder : {"cases/examples", "cases/validation", "cases/verification"}) {
    for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
      if (entry.path().extension() != ".yaml") continue;
      INFO(entry.path().string());
      const read::ReadCase read =
          read::read_case(entry.path().string(), {.curves_may_be_missing = true});
      if (!read.value) continue;  // not a case, or one that is checked elsewhere
      const cases::Case& problem = *read.value;
      const auto replay = Replay::record(problem);
      if (!replay) {
        CHECK(replay.error().size() > 5);
        CHECK(replay.error().find('\n') == std::string::npos);
        ++refused;
        continue;
      }
      ++replayed;
      const std::vector<bench::Row> rows = bench::rows_of(problem);
      REQUIRE(replay->times().size() == rows.size());
      std::vector<Replay::Response> responses;
      for (int c = 0; c < law::kComponents; ++c) {
        responses.push_back({c, 1.0, all_points(rows.size())});
      }
      std::vector<double> values(6 * responses[0].points.size(), -7.0);
      REQUIRE(replay->run(laws_of(problem), responses, values));
      std::vector<law::ConnectorForce> forces(rows.size());
      bool same_times = true;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        same_times = same_times && replay->times()[i] == rows[i].time;
        for (std::size_t d = 0; d < problem.definitions.size(); ++d) {
          const law::ConnectorForce one =
              law::friction_force(problem.definitions[d].law, rows[i].definitions[d].update.state);
          for (int c = 0; c < law::kComponents; ++c) forces[i][c] += one[c];
        }
      }
      CHECK(same_times);
      bool same_rows = true;
      bool same_between = true;
      std::size_t at = 0;
      for (const Replay::Response& response : responses) {
        for (const Replay::Point& point : response.points) {
          const double here = forces[point.row][response.component];
          if (point.fraction == 0.0) {
            // Adding 0 has made +0 of the -0 of the sum above.
            same_rows = same_rows && bits(values[at] + 0.0) == bits(here);
          } else {
            const double next = forces[point.row + 1][response.component];
            same_between = same_between && values[at] == here + 0.5 * (next - here);
          }
          ++at;
        }
      }
      CHECK(same_rows);
      CHECK(same_between);
      CHECK(replay->same_history(problem));
    }
  }
  INFO(replayed << " replayed, " << refused << " refused");
  CHECK(replayed >= 50);
  CHECK(refused >= 20);
}

TEST_CASE("what moves by more than the law is refused in a sentence") {
  const auto sliding = [] {
    return bench::slider_case({bench::step("slide", 4, 0, history::LinearTo{0.5})});
  };
  cases::Case problem = sliding();
  problem.dynamics = cases::DynamicsData{};
  CHECK(refusal(problem) == "it has a mass");
  problem = sliding();
  problem.force_driven.insert(0);
  CHECK(refusal(problem) == "it has a component that is driven by force");
  problem = sliding();
  problem.belt = cases::Belt{};
  CHECK(refusal(problem) == "it has a belt");
  problem = sliding();
  problem.integration.method = cases::IntegrationMethod::kExact;
  CHECK(refusal(problem) == "it is integrated exactly");
  problem = sliding();
  problem.definitions[0].law.formulation = law::Formulation{.penalty = law::StiffnessPenalty{}};
  CHECK(refusal(problem) == "its friction is a contact penalty");
  problem = sliding();
  problem.definitions[0].dead_zone = cases::DeadZone{};
  CHECK(refusal(problem) == "it has a dead zone");
  problem = sliding();
  problem.definitions[0].backward = law::ConstantCoefficient{0.1};
  CHECK(refusal(problem) == "its coefficient depends on the direction");
  problem = sliding();
  problem.steps[0].friction_changes.emplace_back();
  CHECK(refusal(problem) == "its friction changes in step 'slide'");
  problem = bench::slider_case({bench::step("slide", 4, 0, history::LinearTo{INFINITY})});
  CHECK(refusal(problem).find("not a finite number") != std::string::npos);
}

TEST_CASE("only the friction may differ in the same history") {
  const history::Profile wave = history::Wave{history::WaveShape::kSine, 0.1, 1.0, 0.0, 0.0};
  const cases::Case base = bench::slider_case({bench::step("slide", 40, 0, wave)});
  const Replay replay = recorded(base);
  const auto same = [&](const auto& change) {
    cases::Case other = base;
    change(other);
    return replay.same_history(other);
  };
  CHECK(same([](cases::Case&) {}));
  CHECK(same([](cases::Case& c) { c.definitions[0].law.law = law::ConstantCoefficient{0.7}; }));
  CHECK(same([](cases::Case& c) { c.parameters["mu"] = 0.7; }));
  CHECK(same([](cases::Case& c) { c.title = "another"; }));
  CHECK_FALSE(same([](cases::Case& c) { c.steps[0].increments = 41; }));
  CHECK_FALSE(same([](cases::Case& c) { c.steps[0].duration = 2.0; }));
  CHECK_FALSE(same([](cases::Case& c) { c.steps[0].repeat = 2; }));
  CHECK_FALSE(same([](cases::Case& c) {
    std::get<history::Wave>(c.steps[0].drives[0].profile).amplitude = 0.2;
  }));
  CHECK_FALSE(same(
      [](cases::Case& c) { std::get<history::Wave>(c.steps[0].drives[0].profile).period = 0.9; }));
  CHECK_FALSE(same(
      [](cases::Case& c) { std::get<history::Wave>(c.steps[0].drives[0].profile).mean = 0.1; }));
  CHECK_FALSE(same(
      [](cases::Case& c) { std::get<history::Wave>(c.steps[0].drives[0].profile).phase = 0.1; }));
  CHECK_FALSE(same([](cases::Case& c) { c.steps[0].drives[0].profile = history::LinearTo{0.1}; }));
  CHECK_FALSE(same([](cases::Case& c) { c.measured_pieces = 2; }));
  CHECK_FALSE(same([](cases::Case& c) {
    c.steps[0].drives.push_back({cases::kFirstForce, history::Constant{1.0}});
  }));
  CHECK_FALSE(same([](cases::Case& c) { c.steps.push_back(c.steps[0]); }));
  CHECK_FALSE(same([](cases::Case& c) { c.initial[0] = 0.1; }));
  CHECK_FALSE(same([](cases::Case& c) { c.reference[0] = 0.1; }));
  CHECK_FALSE(same([](cases::Case& c) { c.measured = history::MeasuredSource{}; }));
  CHECK_FALSE(same([](cases::Case& c) { c.dynamics = cases::DynamicsData{}; }));
}

TEST_CASE("a formula is the same while the parameters that it mentions are") {
  const auto with = [](const std::string& text, base::NamedNumbers parameters) {
    auto profile = history::compile_profile(text, parameters);
    REQUIRE(profile);
    cases::Case problem = bench::slider_case({bench::step("slide", 10, 0, *std::move(profile))});
    problem.parameters = std::move(parameters);
    return problem;
  };
  const Replay replay = recorded(with("a*t + a_2", {{"a", 0.1}, {"a_2", 0.0}, {"mu", 0.2}}));
  CHECK(replay.same_history(with("a*t + a_2", {{"a", 0.1}, {"a_2", 0.0}, {"mu", 0.3}})));
  CHECK_FALSE(replay.same_history(with("a*t + a_2", {{"a", 0.2}, {"a_2", 0.0}, {"mu", 0.2}})));
  CHECK_FALSE(replay.same_history(with("a*t + a_2", {{"a", 0.1}, {"a_2", 0.1}, {"mu", 0.2}})));
  CHECK_FALSE(replay.same_history(with("a_2 + a*t", {{"a", 0.1}, {"a_2", 0.0}, {"mu", 0.2}})));
}

TEST_CASE("a measured history is replayed from its file's rows") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "t,u,v,p\n2,0.5,-2,90\n3,0.75,-2,120\n3.5,0.25,-1.5,60\n");
  const std::string text =
      "slipbench: 1\n"
      "connector: {type: SLIDE-PLANE, initial: {CP2: 0.25}, reference: {CP3: -1.5}}\n"
      "friction:\n"
      "  - {predefined: {internal_contact_force: 10}, coefficient: 0.2, stick: {elastic_slip: "
      "0.4}}\n"
      "history:\n"
      "  {csv: rig.csv, time: t, columns: {CP2: u, CP3: v, f1: p}}\n";
  read::ReadCase read =
      read::read_case_text(base::SourceText("case.yaml", text), folder.path(), {});
  INFO(base::render(read.diagnostics, read.sources));
  REQUIRE(read.value);
  const Replay replay = recorded(*read.value);
  const std::vector<bench::Row> rows = bench::rows_of(*read.value);
  REQUIRE(rows.size() == 3);
  const std::vector<Replay::Response> responses = {{1, 1.0, {{0, 0}, {1, 0}, {2, 0}}},
                                                   {2, 1.0, {{0, 0}, {1, 0}, {2, 0}}}};
  std::vector<double> values(6);
  REQUIRE(replay.run(laws_of(*read.value), responses, values));
  for (std::size_t i = 0; i < 3; ++i) {
    const law::FrictionState& state = rows[i].definitions[0].update.state;
    CHECK(values[i] == state.force[0]);
    CHECK(values[3 + i] == state.force[1]);
  }
  CHECK(values[5] != 0.0);
}

/// Two unknowns, mu and the stiffness; derivatives of both.
std::vector<law::DefinitionSlopes> slopes_of(const law::FrictionDefinition& definition) {
  law::FrictionDefinition more_mu = definition;
  more_mu.law = law::ConstantCoefficient{0.3};
  law::FrictionDefinition stiffer = definition;
  stiffer.stick.value += 100.0;
  std::vector<law::DefinitionSlopes> slopes(1);
  REQUIRE(law::add_slopes(definition, more_mu, 0.1, 0, &slopes[0]));
  REQUIRE(law::add_slopes(definition, stiffer, 100.0, 1, &slopes[0]));
  return slopes;
}

TEST_CASE("derivatives are those of the values, at rows and between them, in any order") {
  const history::Profile wave = history::Wave{history::WaveShape::kSine, 0.1, 1.0, 0.0, 0.0};
  const cases::Case problem = bench::slider_case({bench::step("slide", 40, 0, wave)});
  const Replay replay = recorded(problem);
  const auto definitions = laws_of(problem);
  const std::vector<Replay::Point> points = {{30, 0.25}, {0, 0.0},  {12, 0.75}, {12, 0.0},
                                             {12, 0.75}, {40, 0.0}, {39, 1.0},  {11, 0.5}};
  const std::vector<Replay::Response> responses = {{0, 1.0, points}, {0, -2.0, {{5, 0.5}}}};
  const std::size_t count = points.size() + 1;
  std::vector<double> plain(count), values(count), jacobian(2 * count);
  REQUIRE(replay.run(definitions, responses, plain));
  REQUIRE(replay.run(definitions, slopes_of(definitions[0]), 2, responses, values, jacobian));
  CHECK(values == plain);
  CHECK(values[6] == values[5]);
  CHECK(values[4] == values[2]);

  const double widths[] = {1e-5, 1.0};
  for (std::size_t j = 0; j < 2; ++j) {
    std::vector<double> beside[2] = {values, values};
    for (int side = 0; side < 2; ++side) {
      auto moved = definitions;
      const double width = side == 0 ? widths[j] : -widths[j];
      if (j == 0) moved[0].law = law::ConstantCoefficient{0.2 + width};
      if (j == 1) moved[0].stick.value += width;
      REQUIRE(replay.run(moved, responses, beside[side]));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double difference = (beside[0][i] - beside[1][i]) / (2 * widths[j]);
      INFO("point " << i << ", unknown " << j);
      // Rounding over the width; the square of the width.
      CHECK(jacobian[2 * i + j] == Approx(difference).epsilon(1e-6).margin(1e-9));
    }
  }
}

TEST_CASE("a component without friction, an unknown too many, a point too far") {
  const cases::Case problem =
      bench::slider_case({bench::step("slide", 4, 0, history::LinearTo{0.5})});
  const Replay replay = recorded(problem);
  const auto definitions = laws_of(problem);
  std::vector<double> values(2, -7.0), jacobian(6, -7.0);
  const std::vector<Replay::Response> responses = {{3, 1.0, {{4, 0.0}}}, {0, 1.0, {{4, 0.0}}}};
  REQUIRE(replay.run(definitions, slopes_of(definitions[0]), 3, responses, values, jacobian));
  CHECK(values == std::vector<double>{0.0, 20.0});
  const double expected[] = {0.0, 0.0, 0.0, 100.0, 0.0, 0.0};
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(jacobian[i] == Approx(expected[i]).epsilon(1e-12).margin(1e-12));  // rounding
  }

  const std::vector<Replay::Response> too_far = {{0, 1.0, {{4, 0.5}}}};
  CHECK_FALSE(replay.run(definitions, too_far, values));
  auto broken = definitions;
  broken[0].law = law::ConstantCoefficient{INFINITY};
  CHECK_FALSE(replay.run(broken, responses, values));
  // A definition that no response reads is not run.
  const std::vector<Replay::Response> elsewhere = {{3, 1.0, {{4, 0.0}}}};
  CHECK(replay.run(broken, elsewhere, values));
}

}  // namespace
}  // namespace slipbench::driver::calibrate
