// SPDX-License-Identifier: Apache-2.0
// The table of part pairs: which record holds, what it hands over, and what is said of it.
#include <catch2/catch.hpp>
#include <string>
#include <variant>
#include <vector>

#include "law/friction/friction_law.hpp"
#include "tests/driver/read/read_for_test.hpp"

namespace slipbench::driver::read {
namespace {

const std::string kTable =
    "slipbench: 1\n"
    "units: {length: mm, force: N, time: s}\n"
    "parameters: {a: 2, b: 4}\n"
    "connector: {type: SLOT, parts: [= a, = b]}\n"
    "friction_pairs:\n"
    "  parts: [1, 2, 3, 4, 5, 6]\n"
    "  groups: {G100: [1, 2, 3], G200: [4, 5]}\n"
    "  default: {coefficient: 0.1}\n"
    "  pairs:\n"
    "    - {parts: [G100, G200], coefficient: 0.2}\n"
    "    - {parts: [2, 4], coefficient: 0.3}\n"
    "friction:\n"
    "  - predefined: {}\n"
    "    stick: {stiffness: 1000}\n"
    "history:\n"
    "  - {step: slide, increments: 2, motion: {CP1: {to: 1}}, force: {f2: 100}}\n";

double coefficient(const cases::Case& problem) {
  REQUIRE(problem.definitions.size() == 1);
  const auto* constant = std::get_if<law::ConstantCoefficient>(&problem.definitions[0].law.law);
  REQUIRE(constant != nullptr);
  return constant->mu;
}

TEST_CASE("The parts of the connector pick the record, and --set can change them") {
  struct Wanted {
    double a, b, mu;
    std::string record;
  };
  for (const auto& [a, b, mu, record] :
       {Wanted{2, 4, 0.3, "friction_pairs.pairs[1]"}, Wanted{4, 2, 0.3, "friction_pairs.pairs[1]"},
        Wanted{1, 4, 0.2, "friction_pairs.pairs[0]"}, Wanted{1, 2, 0.1, "friction_pairs.default"},
        Wanted{6, 1, 0.1, "friction_pairs.default"}}) {
    INFO(a << " and " << b);
    const cases::Case problem = sound(kTable, {{{"a", a}, {"b", b}}, false});
    CHECK(coefficient(problem) == mu);
    REQUIRE(problem.pair);
    CHECK(problem.pair->record() == record);
    CHECK(problem.pair->parts == std::array{static_cast<int>(a), static_cast<int>(b)});
  }
}

TEST_CASE("A run says which record holds") {
  const std::vector<std::string> said = messages(kTable);
  REQUIRE(said.size() == 1);
  CHECK(said[0] ==
        "4:32: note: connector.parts: parts 2 and 4 take the friction of friction_pairs.pairs[1]");
}

TEST_CASE("A part is an integer, also from an expression") {
  const auto said = messages(changed({{"b: 4", "b: 4.5"}}, kTable));
  REQUIRE(said.size() == 1);
  CHECK(said[0] == "4:38: error: connector.parts[1]: wanted an integer, found 4.5");
}

TEST_CASE("Every definition without a coefficient takes the record's") {
  const cases::Case problem = sound(changed({{"{type: SLOT, ", "{type: CYLINDRICAL, "},
                                             {"  - predefined: {}\n",
                                              "  - component: 4\n    internal_contact_force: 1\n"
                                              "    stick: {stiffness: 10}\n"
                                              "  - component: 1\n    internal_contact_force: 2\n"}},
                                            kTable));
  REQUIRE(problem.definitions.size() == 2);
  for (const cases::CaseDefinition& definition : problem.definitions) {
    CHECK(std::get<law::ConstantCoefficient>(definition.law.law).mu == 0.3);
  }
}

TEST_CASE("A record of another law takes the place of a coefficient like any other") {
  const std::string law = "{exponential_decay: {static: 0.4, kinetic: 0.2, decay: 1}}";
  const cases::Case problem = sound(changed({{"coefficient: 0.3", "coefficient: " + law}}, kTable));
  const auto* decay = std::get_if<law::ExponentialDecay>(&problem.definitions[0].law.law);
  REQUIRE(decay != nullptr);
  CHECK(decay->mu_static == 0.4);
}

TEST_CASE("Laws of two kinds in one table are a warning, a law beside numbers is none") {
  const std::string decay =
      "coefficient: {exponential_decay: {static: 0.4, kinetic: 0.2, decay: 1}}";
  const std::string other = "coefficient: {generalized_viscous: {Fric: 0.3, C2: -1e-4}}";
  const std::string one = changed({{"coefficient: 0.2", decay}}, kTable);
  CHECK(messages(one).size() == 1);  // the note on the record that holds
  const std::string both = complaint(changed({{"coefficient: 0.3", other}}, one));
  CHECK(both.find("warning: friction_pairs.pairs[1].coefficient: is generalized_viscous where "
                  "friction_pairs.pairs[0].coefficient is exponential_decay") != std::string::npos);
  CHECK(both.find("a Radioss table has one law (Ifric) for all its records") != std::string::npos);
}

TEST_CASE("A record that does not hold is judged all the same") {
  const std::string table = "{columns: [mu, slip_rate], rows: [[0.2, 1], [0.3, 0]]}";
  const auto said = messages(changed({{"coefficient: 0.2", "coefficient: " + table}}, kTable));
  REQUIRE(said.size() == 2);
  CHECK(said[0].find("error") == std::string::npos);
  CHECK(said[1].starts_with("10:"));
  CHECK(said[1].find("error: friction_pairs.pairs[0].coefficient") != std::string::npos);
}

TEST_CASE("A misspelt key of the table is reported alone") {
  const auto said = messages(changed({{"friction_pairs:", "friction_pair:"}}, kTable));
  REQUIRE(said.size() == 2);
  CHECK(said[0] == "5:1: error: friction_pair: unknown key; did you mean 'friction_pairs'?");
  CHECK(said[1].find("no coefficient: this definition has no effect") != std::string::npos);
  CHECK(
      messages(changed({{"parts: [= a", "prts: [= a"}}, kTable)) ==
      std::vector<std::string>{"4:25: error: connector.prts: unknown key; did you mean 'parts'?"});
}

TEST_CASE("A parameter without a value waits for one") {
  const std::string waiting = changed({{"{a: 2, b: 4}", "{a: 2, b: }"}}, kTable);
  CHECK(messages(waiting) ==
        std::vector<std::string>{"3:20: error: parameters.b: wanted a number, found nothing; give "
                                 "it one here, or with --set b=VALUE"});
  CHECK(coefficient(sound(waiting, {{{"b", 5.0}}, false})) == 0.2);
}

TEST_CASE("A record's VISF takes the place of the formulation's") {
  const std::string viscous = changed(
      {{"{type: SLOT, ", "{type: CONTACT, "},
       {"    stick: {stiffness: 1000}",
        "    formulation: {penalty: viscous, VISF: 2, K: 5000, m: 0.001}"},
       {"coefficient: 0.3", "coefficient: 0.3, VISF: 4"},
       {"motion: {CP1: {to: 1}}, force: {f2: 100}", "motion: {CP2: {to: 1}}, force: {f1: 100}"}},
      kTable);
  const auto visf = [](const cases::Case& problem) {
    REQUIRE(problem.definitions.size() == 1);
    REQUIRE(problem.definitions[0].law.formulation);
    return std::get<law::ViscousPenalty>(problem.definitions[0].law.formulation->penalty).visf;
  };
  CHECK(visf(sound(viscous)) == 4.0);
  // Without one of its own a record keeps the formulation's; 0 means 1.
  CHECK(visf(sound(viscous, {{{"a", 1.0}}, false})) == 2.0);
  CHECK(visf(sound(changed({{"VISF: 4", "VISF: 0"}}, viscous))) == 1.0);
}

TEST_CASE("A VISF that nothing uses gets a note") {
  const auto said = messages(changed({{"coefficient: 0.3", "coefficient: 0.3, VISF: 4"}}, kTable));
  REQUIRE(said.size() == 2);
  CHECK(said[1].find("note: friction_pairs.pairs[1].VISF: has no effect") != std::string::npos);
}

TEST_CASE("Parts may be listed in any order, and by the thousand") {
  // Groups of many parts in many records: sides are looked up, not gone through or copied.
  constexpr int kParts = 20000;
  std::string ids;
  for (int i = kParts; i > 0; --i) ids += (ids.empty() ? "" : ", ") + std::to_string(i);
  std::string records;
  for (int i = 0; i < 1000; ++i) records += "    - {parts: [many, many], coefficient: 0.2}\n";
  const std::string table = changed(
      {{"[1, 2, 3, 4, 5, 6]", "[" + ids + "]"},
       {"{G100: [1, 2, 3],", "{many: [" + ids + "], G100: [3, 2, 1],"},
       {"    - {parts: [G100", records + "    - {parts: [G100"},
       {"coefficient: 0.2}\n    - {parts: [2, 4]", "coefficient: 0.4}\n    - {parts: [2, 4]"}},
      kTable);
  const auto mu = [&](double a, double b) {
    return coefficient(sound(table, {{{"a", a}, {"b", b}}, false}));
  };
  CHECK(mu(1, 4) == 0.4);
  CHECK(mu(5, 3) == 0.4);
  CHECK(mu(kParts, 1) == 0.2);
  const ReadCase none = read_text(table, {{{"a", 1.0}, {"b", kParts + 1.0}}, false});
  CHECK_FALSE(none.value);
}

}  // namespace
}  // namespace slipbench::driver::read
