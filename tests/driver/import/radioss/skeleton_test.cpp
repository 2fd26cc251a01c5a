// SPDX-License-Identifier: Apache-2.0
// From a deck to a case that runs once its parameters have values.
#include <catch2/catch.hpp>
#include <string>
#include <variant>
#include <vector>

#include "driver/import/radioss/case_writer.hpp"
#include "law/friction/law_list.hpp"
#include "tests/driver/import/radioss/deck_for_test.hpp"
#include "tests/driver/read/read_for_test.hpp"
#include "tests/driver/support/checks_for_test.hpp"

namespace slipbench::driver::radioss {
namespace {

const base::UnitSystem kUnits{"mm", "N", "s", {}};
const std::string kHead = "/FRICTION/7\nbrake\n";

std::string case_of(const std::string& deck, std::optional<base::UnitSystem> units = kUnits) {
  const ReadDeck read = read_deck(deck);
  INFO(read.said);
  REQUIRE(read.contents.frictions.size() == 1);
  return import::contact_case(contact_friction(read.contents, read.contents.frictions[0],
                                               {"d.rad", std::move(units), {}}))
      .text;
}

const read::ReadOptions kViscous{
    {{"K", 5000.0}, {"m", 1e-3}, {"normal_force", 100.0}, {"speed", 10.0}, {"time_step", 1e-4}},
    false};

read::ReadOptions with(read::ReadOptions options, std::vector<base::ParameterText> more) {
  for (base::ParameterText& one : more) options.overrides.push_back(std::move(one));
  return options;
}
read::ReadOptions stiffness() {
  read::ReadOptions options = kViscous;
  options.overrides.erase(options.overrides.begin(), options.overrides.begin() + 2);
  options.overrides.push_back({"K_t", 1e4});
  return options;
}

/// Runs a case to its end; all its checks hold.
void run(const cases::Case& problem) {
  REQUIRE_FALSE(problem.checks.empty());
  CHECK(failed_checks(problem).empty());
}

TEST_CASE("A case from a deck is refused until its parameters have values") {
  const std::string text = case_of(kHead + options(0, 0, "", 1) + coulomb(".1"));
  const std::vector<std::string> said = read::messages(text);
  REQUIRE(said.size() == 5);
  CHECK(said[0] ==
        "8:3: error: parameters.K: wanted a number, found nothing; give it one here, or "
        "with --set K=VALUE");
  run(read::sound(text, kViscous));
}

TEST_CASE("A friction without records becomes a coefficient with its formulation and filter") {
  const cases::Case problem =
      read::sound(case_of(kHead + options(0, 1, ".1", 1) + coulomb(".3", "4")), kViscous);
  REQUIRE(problem.definitions.size() == 1);
  const law::FrictionDefinition& d = problem.definitions[0].law;
  CHECK(std::get<law::ConstantCoefficient>(d.law).mu == 0.3);
  REQUIRE(d.formulation);
  CHECK(std::get<law::ViscousPenalty>(d.formulation->penalty).visf == 4.0);
  CHECK(d.formulation->filter.kind == law::Filter::Kind::kSimple);
  CHECK(d.formulation->filter.value == 0.1);
  CHECK(problem.title == "brake");
  CHECK(problem.units.length == "mm");
  run(problem);
}

TEST_CASE("Records become a table of part pairs that --set looks up") {
  const std::string text =
      case_of("/GRPART/PART/100\nbody\n" + integers({1, 2, 3}) + "/GRPART/PART/200\nlid\n" +
              integers({4, 5}) + kHead + options(0, 0, "", 2) + coulomb(".1") +
              sides(100, 200, 0, 0) + coulomb(".2") + sides(0, 0, 2, 4) + coulomb(".3"));
  const auto mu = [&](double a, double b) {
    const cases::Case problem = read::sound(text, with(stiffness(), {{"part1", a}, {"part2", b}}));
    run(problem);
    return std::get<law::ConstantCoefficient>(problem.definitions[0].law.law).mu;
  };
  CHECK(mu(2, 4) == 0.3);
  CHECK(mu(4, 2) == 0.3);
  CHECK(mu(1, 4) == 0.2);
  CHECK(mu(1, 2) == 0.1);
  CHECK(mu(6, 1) == 0.1);
}

TEST_CASE("A group without its parts is refused until they are filled in") {
  const std::string text =
      case_of(kHead + options(0, 0, "", 2) + coulomb(".1") + sides(100, 100, 0, 0) + coulomb(".2"));
  const read::ReadOptions given = with(stiffness(), {{"part1", 1.0}, {"part2", 2.0}});
  const read::ReadCase refused = read::read_text(text, given);
  CHECK_FALSE(refused.value);
  CHECK(base::render(refused.diagnostics)
            .find("friction_pairs.groups.G100: a group needs at least one "
                  "part") != std::string::npos);
  const cases::Case filled =
      read::sound(read::changed({{"G100: []", "G100: [1, 2]"}}, text), given);
  CHECK(std::get<law::ConstantCoefficient>(filled.definitions[0].law.law).mu == 0.2);
}

TEST_CASE("Every Ifric becomes the law of that number") {
  const std::string viscous_set = set({"-2e-4", "-1e-4", "1e-6", "4e-7", "5e-8", "0", ".12", ""});
  const auto law = [](int number, const std::string& coefficients, const read::ReadOptions& given) {
    cases::Case problem =
        read::sound(case_of(kHead + options(number, 0, "", 1) + coefficients), given);
    run(problem);
    return std::move(problem.definitions[0].law.law);
  };
  const read::ReadOptions area = with(kViscous, {{"area", 2.0}});
  const auto viscous = *law::get_law_if<law::GeneralizedViscous>(law(1, viscous_set, area));
  CHECK(viscous.fric == 0.12);
  CHECK(viscous.c5 == 5e-8);
  CHECK(viscous.area == 2.0);
  const auto darmstad = *law::get_law_if<law::ModifiedDarmstad>(
      law(2, set({"1e-6", "-2e-3", "-2e-4", "-1e-3", ".1", "-5e-3", ".08", ""}), area));
  CHECK(darmstad.c6 == -5e-3);
  CHECK(darmstad.fric == 0.08);
  const auto renard = *law::get_law_if<law::Renard>(
      law(3, set({".15", ".10", ".25", ".05", "10", "100", "0", ""}), kViscous));
  CHECK(renard.c3 == 0.25);
  CHECK(renard.c6 == 100.0);
  const auto decay = std::get<law::ExponentialDecay>(
      law(4, set({".2", ".02", "", "", "", "0", ".4", ""}), kViscous));
  CHECK(decay.mu_static == 0.4);
  CHECK(decay.kinetic == 0.2);
  CHECK(decay.decay == 0.02);
  // A coefficient that rises from 0.2 to 0.4 is no decay, but the same curve.
  const auto rise = *law::get_law_if<law::ModifiedDarmstad>(
      law(4, set({".4", ".02", "", "", "", "0", ".2", ""}), kViscous));
  CHECK(rise.raw_coefficient(0.0, 0.0) == Approx(0.2).epsilon(1e-15));
  CHECK(rise.raw_coefficient(0.0, 1e6) == Approx(0.4).epsilon(1e-15));
}

TEST_CASE("A Renard set of another shape is taken over leniently") {
  const cases::Case problem = read::sound(
      case_of(kHead + options(3, 0, "", 1) + set({".3", ".1", ".25", ".05", "10", "100", "0", ""})),
      kViscous);
  CHECK(law::get_law_if<law::Renard>(problem.definitions[0].law.law)->c1 == 0.3);
}

TEST_CASE("A Renard case without units is refused where the deck states none") {
  const std::string text = case_of(
      kHead + options(3, 0, "", 1) + set({".15", ".10", ".25", ".05", "10", "100", "0", ""}), {});
  const read::ReadCase read = read::read_text(text, kViscous);
  CHECK_FALSE(read.value);
  CHECK(text.find("# units: {length: mm, force: N, time: s}") != std::string::npos);
}

TEST_CASE("Xfreq of Ifiltr 2 counts time steps, that of Ifiltr 3 is a frequency") {
  const auto filter = [](int kind, std::string_view xfreq) {
    const cases::Case problem =
        read::sound(case_of(kHead + options(0, kind, xfreq, 1) + coulomb(".3")), kViscous);
    return law::filter_coefficient(problem.definitions[0].law.formulation->filter, 1e-4,
                                   law::Convention::kDocumented);
  };
  constexpr double kTwoPi = 6.283185307179586;
  CHECK(filter(2, "60") == Approx(kTwoPi / 60.0).epsilon(1e-14));
  CHECK(filter(3, "100") == Approx(kTwoPi * 100.0 * 1e-4).epsilon(1e-14));
}

TEST_CASE("An orthotropic record has two coefficients in the case") {
  const cases::Case problem =
      read::sound(case_of(kHead + options(0, 0, "", 2) + coulomb(".1") + sides(0, 0, 1, 2, 1) +
                          coulomb(".3") + coulomb(".2")),
                  with(stiffness(), {{"part1", 2.0}, {"part2", 1.0}}));
  const law::FrictionDefinition& d = problem.definitions[0].law;
  REQUIRE(d.formulation);
  REQUIRE(d.formulation->orthotropy);
  CHECK(std::get<law::ConstantCoefficient>(d.law).mu == 0.3);
  CHECK(std::get<law::ConstantCoefficient>(d.formulation->orthotropy->second).mu == 0.2);
  run(problem);
}

TEST_CASE("The checks of a case notice a constant that is not the deck's") {
  struct Wrong {
    int law;
    std::string set, from, to;
  };
  for (const auto& [law, coefficients, from, to] :
       {Wrong{0, coulomb(".3"), "coefficient: 0.3", "coefficient: 0.31"},
        Wrong{1, set({"1e-4", "1e-3", "", "", "", "0", ".1", ""}), "C2: 0.001", "C2: 0.0011"},
        Wrong{2, set({"", "", "", "", ".1", "-.05", ".1", ""}), "C6: -0.05", "C6: -0.051"},
        Wrong{3, set({".15", ".10", ".25", ".05", "10", "100", "", ""}), "C2: 0.1", "C2: 0.11"},
        Wrong{4, set({".2", ".02", "", "", "", "0", ".4", ""}), "decay: 0.02", "decay: 0.03"},
        Wrong{4, set({".4", ".02", "", "", "", "0", ".2", ""}), "C6: -0.02", "C6: -0.03"}}) {
    INFO("Ifric " << law);
    const std::string text = case_of(kHead + options(law, 0, "", 1) + coefficients);
    read::ReadOptions given = kViscous;
    for (base::ParameterText& one : given.overrides) {
      if (one.name == "speed") one.value = 120.0;
    }
    if (text.find("  area:") != std::string::npos) given = with(given, {{"area", 2.0}});
    run(read::sound(text, given));
    CHECK(failed_checks(read::sound(read::changed({{from, to}}, text), given)) ==
          std::vector<std::string>{"coefficient of the deck's constants"});
  }
}

TEST_CASE("Each record has its checks, as comments, up to a number of them") {
  std::string deck = kHead + options(0, 0, "", 2) + coulomb(".1") + sides(0, 0, 1, 2, 1) +
                     coulomb(".3") + coulomb(".2");
  const std::string two = case_of(deck);
  CHECK(two.find("  # - name: coefficient between 1 and 2 (line 6 of the deck) along direction 2\n"
                 "  #   quantity: MU2\n") != std::string::npos);
  CHECK(two.find("more records") == std::string::npos);
  for (int i = 0; i < 30; ++i) deck += sides(0, 0, 1, 3 + i) + coulomb(".3");
  const std::string many = case_of(deck);
  CHECK(many.find("between 1 and 21 (") != std::string::npos);
  CHECK(many.find("between 1 and 22 (") == std::string::npos);
  CHECK(many.find("(and so on for 11 more records)") != std::string::npos);
}

TEST_CASE("A title of any characters stays a title") {
  const std::string text =
      case_of("/FRICTION/7\npad: \"A\" #1 \\ {x\n" + options(0, 0, "", 1) + coulomb(".3"));
  CHECK(read::sound(text, kViscous).title == "pad: \"A\" #1 \\ {x");
}

}  // namespace
}  // namespace slipbench::driver::radioss
