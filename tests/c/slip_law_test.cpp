// SPDX-License-Identifier: Apache-2.0
#include "c/slip_law.h"

#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "c/slip_law_yaml.h"
#include "law/definition/packed_definition.hpp"
#include "law/update/connector_tangent.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/any_definition.hpp"

namespace {

using namespace slipbench;
using namespace slipbench::test;

struct Destroy {
  void operator()(slip_law* law) const { slip_law_destroy(law); }
};
using Handle = std::unique_ptr<slip_law, Destroy>;

Handle handle_of(const std::vector<law::FrictionDefinition>& definitions) {
  const std::vector<double> numbers = law::pack_all(definitions);
  slip_error error;
  Handle handle(slip_law_unpack(numbers.data(), numbers.size(), &error));
  INFO(error.message);
  REQUIRE(handle);
  return handle;
}

slip_increment increment_of(const HistoryRow& row) {
  slip_increment increment{};
  increment.duration = row.duration;
  for (int c = 0; c < law::kComponents; ++c) {
    increment.begin[c] = row.begin[c];
    increment.end[c] = row.end[c];
    increment.reference[c] = row.reference[c];
    increment.force[c] = row.force[c];
  }
  increment.temperature = row.temperature;
  increment.fields = row.fields.data();
  increment.field_count = row.fields.size();
  return increment;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Runs a history through the C interface; false at the first number that is not that of the law.
/// An update that C refuses must be one that the law cannot make.
bool same_as_law(const law::FrictionDefinition& definition, const std::vector<HistoryRow>& rows) {
  const Handle handle = handle_of({definition});
  std::vector<double> state(slip_law_state_size(handle.get()));
  slip_law_initial_state(handle.get(), state.data());
  law::FrictionState old;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const slip_increment increment = increment_of(rows[i]);
    std::array<double, 6> force{};
    std::array<double, 36> to_motion{}, to_force{};
    slip_result result{};
    const int status =
        slip_law_tangent(handle.get(), &increment, state.data(), state.data(), force.data(),
                         &result, to_motion.data(), to_force.data(), nullptr);
    const law::FrictionUpdate one = any_update(definition, rows[i].increment(), old);
    old = one.state;
    if (status != SLIP_OK) return !law::all_finite(one) || !one.converged;
    const law::ConnectorForce f = law::friction_force(definition, one.state);
    const law::ConnectorTangent slopes =
        law::connector_tangent(definition, rows[i].increment(), one);
    bool same = same_bits(result.limit, one.limit) && same_bits(result.mu, one.mu) &&
                same_bits(result.normal_force, one.normal_force) &&
                same_bits(result.slip_increment, one.slip_increment) &&
                same_bits(result.slip_rate, one.slip_rate) &&
                same_bits(result.dissipation, one.dissipation) &&
                same_bits(result.work, one.work) &&
                same_bits(result.stored_energy, one.stored_energy) &&
                result.regime == static_cast<int>(one.state.regime) &&
                same_bits(state[12], one.state.accumulated_slip) &&
                same_bits(state[13], one.state.accumulated_slip.left_out());
    for (int c = 0; c < law::kComponents; ++c) {
      const auto k = static_cast<std::size_t>(c);
      same = same && force[k] == f[c] && same_bits(state[k], one.state.elastic_slip[k]) &&
             same_bits(state[6 + k], one.state.force[k]);
      for (int j = 0; j < law::kComponents; ++j) {
        const auto at = 6 * k + static_cast<std::size_t>(j);
        same = same && to_motion[at] == slopes.to_motion(c, j) &&
               to_force[at] == slopes.to_force(c, j);
      }
    }
    if (!same) return false;
  }
  return true;
}

TEST_CASE("the law through C is the law, on 2,000 random definitions") {
  for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
    Dice dice(seed);
    const law::FrictionDefinition definition = any_definition(dice);
    INFO("seed " << seed);
    REQUIRE(same_as_law(definition, random_history(&dice, 10)));
  }
}

TEST_CASE("four threads share one law") {
  Dice dice(3);
  const law::FrictionDefinition definition = random_definition(&dice, 0, {}).build();
  const std::vector<HistoryRow> rows = random_history(&dice, 200);
  const Handle handle = handle_of({definition});
  std::array<std::vector<double>, 4> ends;
  std::vector<std::thread> threads;
  for (std::vector<double>& state : ends) {
    state.resize(slip_law_state_size(handle.get()));
    slip_law_initial_state(handle.get(), state.data());
    threads.emplace_back([&handle, &rows, &state] {
      for (const HistoryRow& row : rows) {
        const slip_increment increment = increment_of(row);
        slip_law_update(handle.get(), &increment, state.data(), state.data(), nullptr, nullptr,
                        nullptr);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<double>& state : ends) CHECK(state == ends.front());
}

TEST_CASE("an increment through C allocates nothing") {
  Dice dice(5);
  std::vector<law::FrictionDefinition> definitions;
  definitions.reserve(kDefinitionKinds);
  for (int kind = 0; kind < kDefinitionKinds; ++kind) {
    definitions.push_back(random_definition(&dice, kind, {}).build());
  }
  const Handle handle = handle_of(definitions);
  std::vector<double> state(slip_law_state_size(handle.get()));
  slip_law_initial_state(handle.get(), state.data());
  std::vector<slip_result> results(slip_law_definitions(handle.get()));
  std::array<double, 6> force{};
  std::array<double, 36> slopes{};
  const std::vector<HistoryRow> rows = random_history(&dice, 50);
  slip_error error;
  const std::size_t allocated = count_allocations([&] {
    for (const HistoryRow& row : rows) {
      slip_increment increment = increment_of(row);
      slip_law_tangent(handle.get(), &increment, state.data(), state.data(), force.data(),
                       results.data(), slopes.data(), nullptr, &error);
      increment.force[0] = std::nan("");
      slip_law_update(handle.get(), &increment, state.data(), state.data(), force.data(),
                      results.data(), &error);
    }
  });
  CHECK(allocated == 0);
}

slip_definition slot(const slip_number* mu, double elastic_slip) {
  slip_definition definition{};
  definition.size = sizeof definition;
  definition.connection = "SLOT";
  definition.law = "constant";
  definition.numbers = mu;
  definition.number_count = 1;
  definition.elastic_slip = elastic_slip;
  return definition;
}

TEST_CASE("a SLOT from numbers is the SLOT of a text, and Coulomb's") {
  const slip_number mu{"mu", 0.2};
  const slip_definition definition = slot(&mu, 1e-3);
  slip_error error;
  const Handle by_numbers(slip_law_create(&definition, 1, &error));
  REQUIRE(by_numbers);
  CHECK(error.status == SLIP_OK);
  const Handle by_text(
      slip_law_create_from_yaml("parameters: {mu: 0.2}\nconnector: {type: SLOT}\nfriction:\n  - "
                                "predefined: {}\n    coefficient: = mu\n"
                                "    stick: {elastic_slip: 1.0e-3}\n",
                                nullptr, &error));
  INFO(error.message);
  REQUIRE(by_text);
  std::vector<double> a(200), b(200);
  a.resize(slip_law_pack(by_numbers.get(), a.data(), a.size()));
  b.resize(slip_law_pack(by_text.get(), b.data(), b.size()));
  CHECK(a == b);

  slip_increment increment{};
  increment.duration = 1.0;
  increment.end[0] = 0.5e-3;
  increment.force[1] = 3.0;
  increment.force[2] = 4.0;
  std::array<double, SLIP_STATE_NUMBERS> state{};
  slip_law_initial_state(by_numbers.get(), state.data());
  std::array<double, 6> force{};
  slip_result result{};
  REQUIRE(slip_law_update(by_numbers.get(), &increment, state.data(), state.data(), force.data(),
                          &result, &error) == SLIP_OK);
  // F_N = 5, the limit 1; half of the elastic slip is half of it. Only rounding is between.
  CHECK(force[0] == Approx(0.5).epsilon(1e-15));
  CHECK(result.regime == SLIP_STICK);
  increment.begin[0] = increment.end[0];
  increment.end[0] = 1.0;
  REQUIRE(slip_law_update(by_numbers.get(), &increment, state.data(), state.data(), force.data(),
                          &result, &error) == SLIP_OK);
  CHECK(force[0] == Approx(1.0).epsilon(1e-15));
  CHECK(result.regime == SLIP_SLIP);
  CHECK(result.slip_increment == Approx(1.0 - 1e-3).epsilon(1e-15));
}

TEST_CASE("user-defined friction from numbers is that of a text") {
  const std::array<slip_number, 3> decay{{{"decay", 0.1}, {"static", 0.3}, {"kinetic", 0.2}}};
  slip_definition definition{};
  definition.size = sizeof definition;
  definition.law = "exponential_decay";
  definition.numbers = decay.data();
  definition.number_count = decay.size();
  definition.slip_scale[3] = 1.0;
  definition.contact_weight[1] = definition.contact_weight[2] = 2.5;
  definition.internal_contact_force = 7.0;
  definition.stick_stiffness = 500.0;
  slip_error error;
  const Handle by_numbers(slip_law_create(&definition, 1, &error));
  INFO(error.message);
  REQUIRE(by_numbers);
  const Handle by_text(slip_law_create_from_yaml(
      "connector: {type: HINGE}\nderived_components: {normal: [{components: [2, 3], weights: [2.5, "
      "2.5]}]}\nfriction:\n  - component: 4\n    contact_force: normal\n"
      "    internal_contact_force: 7\n    coefficient: {exponential_decay: {static: 0.3, kinetic: "
      "0.2, decay: 0.1}}\n"
      "    stick: {stiffness: 500}\n",
      nullptr, &error));
  INFO(error.message);
  REQUIRE(by_text);
  std::vector<double> a(400), b(400);
  a.resize(slip_law_pack(by_numbers.get(), a.data(), a.size()));
  b.resize(slip_law_pack(by_text.get(), b.data(), b.size()));
  CHECK(a == b);
}

TEST_CASE("numbers that make no friction are told in a sentence") {
  slip_error error;
  const auto said = [&](const slip_definition& definition) -> std::string {
    CHECK(slip_law_create(&definition, 1, nullptr) == nullptr);
    CHECK(slip_law_create(&definition, 1, &error) == nullptr);
    CHECK(error.status == SLIP_BAD_DEFINITION);
    return error.message;
  };
  const slip_number mu{"mu", 0.2}, negative{"mu", -0.2}, other{"nu", 0.2}, none{nullptr, 0.2};
  const slip_number endless{"mu", HUGE_VAL};
  CHECK(said(slot(&negative, 1e-3)) == "constant: 'mu' cannot be -0.20000000000000001");
  CHECK(said(slot(&endless, 1e-3)) == "constant: 'mu' cannot be inf");
  CHECK(said(slot(&other, 1e-3)) == "constant has no number 'nu'");
  CHECK(said(slot(&none, 1e-3)) == "constant has no number ''");
  CHECK(said(slot(nullptr, 1e-3)) == "constant: 'mu' is missing");
  CHECK(said(slot(&mu, 0.0)) == "exactly one of elastic_slip and stick_stiffness must be above 0");
  slip_definition definition = slot(&mu, 1e-3);
  definition.connection = "SLOTH";
  CHECK(said(definition) == "'SLOTH' is no connection type with predefined friction");
  definition = slot(&mu, 1e-3);
  definition.law = "coulomb";
  CHECK(said(definition) == "'coulomb' is no law of numbers");
  definition = slot(&mu, 1e-3);
  definition.connection = nullptr;
  CHECK(said(definition) == "no component slips: slip_scale is 0 throughout");
  definition = slot(&mu, 1e-3);
  definition.size = 8;
  CHECK(said(definition).substr(0, 9) == "size is 8");
  CHECK(slip_law_create(nullptr, 1, &error) == nullptr);
  CHECK(std::string(error.message) == "there is no definition");
  const std::array<double, 3> nothing{1.0, 1.0, 0.5};
  CHECK(slip_law_unpack(nothing.data(), nothing.size(), &error) == nullptr);
  CHECK(error.status == SLIP_BAD_DEFINITION);
}

TEST_CASE("faults of a text are told with their places") {
  slip_error error;
  CHECK(slip_law_create_from_yaml(
            "connector: {type: SLOT}\nfriction:\n  - {predefined: {}, coeficient: 0.2}\n", nullptr,
            &error) == nullptr);
  CHECK(error.status == SLIP_BAD_DEFINITION);
  CHECK(std::string(error.message).find("3:") == 0);
  CHECK(std::string(error.message).find("coeficient") != std::string::npos);
  // A message that is cut ends with a whole character, wherever that is.
  for (const std::string before : {"", "a"}) {
    std::string faulty = "slipbench: 1\nconnector: {type: SLOT}\nfriction:\n  - predefined: {}\n";
    for (int i = 0; i < 50; ++i) {
      faulty += "    " + before;
      for (int k = 0; k < 20; ++k) faulty += "\u00e4";
      faulty += std::to_string(i) + ": 1\n";
    }
    CHECK(slip_law_create_from_yaml(faulty.c_str(), nullptr, &error) == nullptr);
    const std::string message = error.message;
    CHECK(message.size() > 500);
    const auto begun = static_cast<std::size_t>(std::count(message.begin(), message.end(), '\xc3'));
    CHECK(static_cast<std::size_t>(std::count(message.begin(), message.end(), '\xa4')) == begun);
  }
  CHECK(slip_law_create_from_yaml("slipbench: 1\nconnector: {type: SLOT}\n", nullptr, &error) ==
        nullptr);
  CHECK(std::string(error.message).find("missing key 'friction'") == 0);
  CHECK(slip_law_create_from_yaml(nullptr, nullptr, &error) == nullptr);
  CHECK(error.message[0] != '\0');
}

TEST_CASE("an update that is not finite leaves the state as it was") {
  const slip_number mu{"mu", 0.2};
  const slip_definition definition = slot(&mu, 1e-3);
  const Handle handle(slip_law_create(&definition, 1, nullptr));
  std::array<double, SLIP_STATE_NUMBERS> state{};
  slip_law_initial_state(handle.get(), state.data());
  const auto before = state;
  slip_increment increment{};
  increment.force[1] = std::nan("");
  increment.end[0] = 1.0;
  std::array<double, 6> force{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  slip_error error;
  CHECK(slip_law_update(handle.get(), &increment, state.data(), state.data(), force.data(), nullptr,
                        &error) == SLIP_NOT_FINITE);
  CHECK(std::string(error.message).find("definition 0") != std::string::npos);
  CHECK(state == before);
  CHECK(force[5] == 6.0);
  CHECK(slip_law_update(nullptr, &increment, state.data(), state.data(), nullptr, nullptr,
                        &error) == SLIP_BAD_ARGUMENT);
}

TEST_CASE("amounts that are negative or not finite are arguments of no connector") {
  const slip_number mu{"mu", 0.2};
  const slip_definition definition = slot(&mu, 1e-3);
  const Handle handle(slip_law_create(&definition, 1, nullptr));
  std::array<double, SLIP_STATE_NUMBERS> state{};
  slip_law_initial_state(handle.get(), state.data());
  const auto before = state;
  slip_increment increment{};
  increment.end[0] = 1.0;
  increment.force[1] = 10.0;
  for (const double amount : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    increment.duration = amount;
    slip_error error;
    CHECK(slip_law_update(handle.get(), &increment, state.data(), state.data(), nullptr, nullptr,
                          &error) == SLIP_BAD_ARGUMENT);
    CHECK(std::string(error.message).find("the duration is") == 0);
    CHECK(state == before);
    double coefficient = 7.0;
    CHECK(slip_law_coefficient(handle.get(), 0, amount, 1.0, 0.0, nullptr, 0, &coefficient, nullptr,
                               nullptr, nullptr) == SLIP_BAD_ARGUMENT);
    CHECK(slip_law_coefficient(handle.get(), 0, 1.0, amount, 0.0, nullptr, 0, &coefficient, nullptr,
                               nullptr, nullptr) == SLIP_BAD_ARGUMENT);
    CHECK(coefficient == 7.0);
  }
}

TEST_CASE("a tangent that is not finite is an error and changes nothing") {
  const slip_number mu{"mu", 0.2};
  // df/du = R^2 kappa = 1e309 is beyond a double; without motion the force is still 0.
  slip_definition definition = slot(&mu, 0.0);
  definition.connection = nullptr;
  definition.slip_scale[0] = 10.0;
  definition.internal_contact_force = 5.0;
  definition.stick_stiffness = 1e307;
  const Handle handle(slip_law_create(&definition, 1, nullptr));
  REQUIRE(handle);
  std::array<double, SLIP_STATE_NUMBERS> state{};
  slip_law_initial_state(handle.get(), state.data());
  const auto before = state;
  const slip_increment increment{};
  CHECK(slip_law_update(handle.get(), &increment, state.data(), state.data(), nullptr, nullptr,
                        nullptr) == SLIP_OK);
  std::array<double, 36> to_motion{};
  to_motion.fill(7.0);
  std::array<double, 6> force{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  slip_error error;
  state = before;
  CHECK(slip_law_tangent(handle.get(), &increment, state.data(), state.data(), force.data(),
                         nullptr, to_motion.data(), nullptr, &error) == SLIP_NOT_FINITE);
  CHECK(std::string(error.message).find("the tangent of definition 0 is not finite") == 0);
  CHECK(state == before);
  CHECK(to_motion[0] == 7.0);
  CHECK(force[5] == 6.0);
}

TEST_CASE("the coefficient alone is that of the law") {
  const std::array<slip_number, 3> decay{{{"static", 0.3}, {"kinetic", 0.2}, {"decay", 0.1}}};
  slip_definition definition = slot(decay.data(), 1e-3);
  definition.law = "exponential_decay";
  definition.number_count = decay.size();
  const Handle handle(slip_law_create(&definition, 1, nullptr));
  double mu = 0.0, to_rate = 0.0, to_force = 1.0;
  REQUIRE(slip_law_coefficient(handle.get(), 0, 5.0, 10.0, 0.0, nullptr, 0, &mu, &to_rate,
                               &to_force, nullptr) == SLIP_OK);
  CHECK(mu == Approx(0.2 + 0.1 * std::exp(-0.5)).epsilon(1e-15));
  CHECK(to_rate == Approx(-0.01 * std::exp(-0.5)).epsilon(1e-14));
  CHECK(to_force == 0.0);
  CHECK(slip_law_coefficient(handle.get(), 1, 5.0, 10.0, 0.0, nullptr, 0, &mu, nullptr, nullptr,
                             nullptr) == SLIP_BAD_ARGUMENT);
}

}  // namespace
