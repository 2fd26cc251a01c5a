// SPDX-License-Identifier: Apache-2.0
// Friction blocks for programs that state it of contacts, read back and run.
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "driver/commands/exported_case.hpp"
#include "driver/export/contact/contact_block.hpp"
#include "driver/read/keys/case_text.hpp"
#include "driver/read/read_case.hpp"

namespace slipbench::driver::commands {
namespace {

struct Exported {
  exports::ExportedDeck deck;
  analysis::ResponseDifference difference;

  bool tells(exports::Loss::Kind kind, const std::string& part) const {
    for (const exports::Loss& one : deck.losses) {
      if (one.kind == kind && one.text.find(part) != std::string::npos) return true;
    }
    return false;
  }
  bool has(const std::string& part) const { return deck.text.find(part) != std::string::npos; }
};

struct Source {
  read::CaseText written;
  cases::Case problem;
};

Source read_source(const std::string& text) {
  Source source;
  read::ReadCase read =
      read::read_case_text(base::SourceText("c", text), ".", {.text = &source.written});
  INFO(base::render(read.diagnostics, read.sources));
  REQUIRE(read.value);
  source.problem = std::move(*read.value);
  return source;
}

Exported take(const std::string& program, const std::string& text, int digits = 0) {
  const Source source = read_source(text);
  auto deck = exported_case(program, source.problem, source.written, {false, digits});
  INFO(program << "\n" << text << (deck ? "" : deck.error()));
  REQUIRE(deck);
  INFO(deck->text);
  auto difference = measured_difference(program, source.problem, source.written, deck->text);
  INFO((difference ? "" : difference.error()));
  REQUIRE(difference);
  return {std::move(*deck), *difference};
}

std::string refusal(const std::string& program, const std::string& text) {
  const Source source = read_source(text);
  const auto deck = exported_case(program, source.problem, source.written, {});
  REQUIRE_FALSE(deck);
  return deck.error();
}

/// A contact of 4 mm^2 that slides to and fro under a force that changes, with a law.
std::string contact(const std::string& coefficient, const std::string& more = "") {
  return "slipbench: 1\ntitle: pad\nunits: {length: mm, force: N, time: s}\n"
         "connector: {type: CONTACT, area: 4}\nfriction:\n  - predefined: {}\n    coefficient: " +
         coefficient + "\n" + more +
         "history:\n"
         "  - {step: press, increments: 2, force: {f1: {to: 20}}}\n"
         "  - {step: rub, duration: 2, increments: 100, motion: {CP2: {sine: {amplitude: 30, "
         "period: 1}}, "
         "CP3: {sine: {amplitude: 10, period: 0.7}}}, force: {f1: {to: 80}}}\n";
}

const std::string kConstant = "0.123456789012345";
const std::string kDecay =
    "{exponential_decay: {static: 0.31234567890123, kinetic: 0.123456789012345, decay: 0.0213}}";
const std::string kTable =
    "{columns: [mu, slip_rate, contact_force], rows: [[0.3, 0, 20], [0.2, 100, 20], [0.2, 0, 80], "
    "[0.1, 100, 80]]}";

TEST_CASE("A constant and a decay go to every program that has them, and back in all digits") {
  for (const std::string& law : {kConstant, kDecay}) {
    for (const std::string program : {"radioss", "lsdyna", "opensees"}) {
      const Exported found = take(program, contact(law));
      INFO(program << "\n" << found.deck.text << analysis::difference_text(found.difference));
      CHECK(found.difference.is_none());
      CHECK(found.tells(exports::Loss::Kind::kKept, "coefficient"));
    }
    const Exported table = take("table", contact(law));
    // Straight lines between points that are off by 1e-4 of the largest coefficient.
    CHECK(table.difference.force.most <= 1e-4 * table.difference.force.largest);
  }
}

TEST_CASE("A connector's friction leaves its geometry behind, and says so") {
  const std::string slot =
      "slipbench: 1\ntitle: t\nconnector: {type: SLOT}\nfriction:\n"
      "  - {predefined: {internal_contact_force: 20}, coefficient: 0.3}\n"
      "history: [{step: a, increments: 10, motion: {CP1: {to: 3}}, force: {f2: 10}}]\n";
  const Exported found = take("lsdyna", slot);
  CHECK(found.difference.is_none());
  CHECK(found.tells(exports::Loss::Kind::kDropped, "SLOT: the contact force of its geometry"));
  CHECK(found.tells(exports::Loss::Kind::kDropped, "internal contact force"));
}

TEST_CASE("Coefficients over rate and force become a table where a program has one") {
  const Exported lsdyna = take("lsdyna", contact(kTable));
  CHECK(lsdyna.has("*DEFINE_TABLE"));
  CHECK(lsdyna.difference.force.most <= 2e-4 * lsdyna.difference.force.largest);
  CHECK(refusal("radioss", contact(kTable)).find("no coefficient table") != std::string::npos);
  CHECK(refusal("opensees", contact(kTable)).find("contact force") != std::string::npos);
  const Exported table = take("table", contact(kTable));
  CHECK(table.difference.force.most <= 2e-4 * table.difference.force.largest);
}

TEST_CASE("A program's own laws go back to it in all digits") {
  for (const std::string law :
       {"{generalized_viscous: {Fric: 0.2, C1: 0.001, C2: 1e-3, C3: 0.01, C4: 1e-5, C5: 1e-7}}",
        "{modified_darmstad: {Fric: 0.2, C1: 1e-4, C2: -0.01, C3: 0.005, C4: -0.02, C5: 0.1, C6: "
        "-0.05}}",
        "{renard: {C1: 0.1, C2: 0.15, C3: 0.3, C4: 0.05, C5: 40, C6: 120}}"}) {
    const Exported radioss = take("radioss", contact(law));
    INFO(radioss.deck.text << analysis::difference_text(radioss.difference));
    CHECK(radioss.difference.is_none());
    const Exported lsdyna = take("lsdyna", contact(law));
    INFO(lsdyna.deck.text << analysis::difference_text(lsdyna.difference));
    CHECK(lsdyna.difference.force.most <= 3e-4 * lsdyna.difference.force.largest);
    CHECK(lsdyna.tells(exports::Loss::Kind::kApproximated, "FS 2"));
  }
}

TEST_CASE("What a program has no word for is dropped, and its size is measured") {
  const std::string capped = "    force_limit: 3\n";
  const Exported opensees = take("opensees", contact("0.3", capped));
  CHECK(opensees.tells(exports::Loss::Kind::kDropped, "force_limit"));
  CHECK(opensees.difference.force.most == Approx(0.3 * 80 - 3).epsilon(0.05));
  const Exported lsdyna = take("lsdyna", contact("0.3", capped));
  CHECK(lsdyna.difference.is_none());
  const Exported creeps = take(
      "lsdyna", contact("0.3", "    formulation: {penalty: viscous, VISF: 1, K: 100, m: 1e-3}\n"));
  CHECK(creeps.tells(exports::Loss::Kind::kDropped, "viscous penalty"));
  CHECK(creeps.difference.creep > 0.0);
  CHECK(creeps.difference.other_creep == 0.0);
}

TEST_CASE("Springs, stops and changes of friction are dropped with a word, and changes measured") {
  const std::string slot =
      "slipbench: 1\ntitle: t\nconnector: {type: SLOT}\nfriction:\n"
      "  - {predefined: {}, coefficient: 0.3}\n"
      "elasticity: [{component: 1, stiffness: 5}]\n"
      "history:\n"
      "  - {step: a, increments: 10, motion: {CP1: {to: 3}}, force: {f2: 10}}\n"
      "  - {step: b, increments: 10, motion: {CP1: {to: 6}}, change_friction: {friction1: "
      "{coefficient: 0.8}}}\n";
  for (const std::string program : {"radioss", "lsdyna", "opensees", "table"}) {
    const Exported found = take(program, slot);
    INFO(program << "\n" << analysis::difference_text(found.difference));
    CHECK(found.tells(exports::Loss::Kind::kDropped, "springs, dampers and stops"));
    CHECK(found.tells(exports::Loss::Kind::kDropped, "changes of friction in steps"));
    CHECK(found.difference.force.most == Approx(5.0));
  }
  const Exported plain = take("lsdyna", contact("0.3"));
  CHECK_FALSE(plain.tells(exports::Loss::Kind::kDropped, "springs"));
  CHECK_FALSE(plain.tells(exports::Loss::Kind::kDropped, "changes of friction"));
}

TEST_CASE("A contact is a SLIDE-PLANE with user-defined friction in Abaqus, and lifts off there") {
  const std::string lifts =
      "slipbench: 1\ntitle: pad\nconnector: {type: CONTACT}\nfriction:\n"
      "  - {predefined: {}, coefficient: 0.3, formulation: {penalty: stiffness, K_t: 1000}}\n"
      "integration: {slip_rate: slip}\nhistory:\n"
      "  - {step: rub, increments: 40, motion: {CP2: {to: 3}, CP3: {to: 1}}, force: {f1: {sine: "
      "{amplitude: 20, period: 1}}}}\n";
  const Exported found = take("abaqus", lifts);
  INFO(found.deck.text << analysis::difference_text(found.difference));
  CHECK(found.difference.is_none());
  CHECK(found.difference.dissipation > 0.0);
  CHECK(found.has("SLIDE-PLANE"));
  CHECK(found.has("OPERATOR=MACAULEY SUM"));
  CHECK(found.has("STICK STIFFNESS=1000"));
}

TEST_CASE("Laws that Abaqus has not become points, and the rest says what they cost") {
  for (const std::string law :
       {"{renard: {C1: 0.1, C2: 0.15, C3: 0.3, C4: 0.05, C5: 40, C6: 120}}",
        "{stribeck: {static: 0.3, kinetic: 0.1, stribeck_rate: 10, viscous: 1e-4}}"}) {
    const std::string slot =
        "slipbench: 1\ntitle: t\nunits: {length: mm, force: N, time: s}\n"
        "connector: {type: SLOT}\nfriction:\n  - {predefined: {}, coefficient: " +
        law + "}\nhistory: [{step: a, increments: 50, motion: {CP1: {to: 30}}, force: {f2: 10}}]\n";
    const Exported found = take("abaqus", slot);
    INFO(found.deck.text << analysis::difference_text(found.difference));
    CHECK(found.tells(exports::Loss::Kind::kApproximated, "points over slip rate"));
    CHECK(found.difference.force.most <= 5e-4 * found.difference.force.largest);
  }
}

TEST_CASE("Records of part pairs go to Radioss and LS-DYNA, and back") {
  const std::string text =
      "slipbench: 1\ntitle: t\nconnector: {type: CONTACT, area: 4, parts: [7, 9]}\nfriction: "
      "[{predefined: {}}]\n"
      "friction_pairs:\n  groups: {G100: [1, 2, 7], G101: [9, 10]}\n  default: {coefficient: "
      "0.1}\n  pairs:\n"
      "    - {parts: [G100, G101], coefficient: {exponential_decay: {static: 0.4, kinetic: 0.25, "
      "decay: 0.013}}}\n    - {parts: [7, 3], coefficient: 0.7}\n"
      "history: [{step: a, increments: 50, motion: {CP2: {sine: {amplitude: 30, period: 1}}}, "
      "force: {f1: 10}}]\n";
  for (const std::string program : {"radioss", "lsdyna"}) {
    const Exported found = take(program, text);
    INFO(found.deck.text << analysis::difference_text(found.difference));
    CHECK(found.difference.is_none());
    CHECK(found.tells(exports::Loss::Kind::kKept, "2 records of part pairs"));
  }
  CHECK(refusal("opensees", text).find("part pairs") != std::string::npos);
  CHECK(refusal("table", text).find("pairs") != std::string::npos);
}

TEST_CASE("Numbers that need more than a field's columns are not cut without a word") {
  const Exported exact = take("lsdyna", contact(kDecay));
  CHECK(exact.has("_ID +\n"));
  const Exported rounded = take("lsdyna", contact(kDecay), 4);
  CHECK(rounded.has("    0.3123    0.1235    0.0213"));
  CHECK(rounded.tells(exports::Loss::Kind::kApproximated, "numbers: 2 rounded"));
  CHECK(rounded.difference.force.most > 0.0);
  CHECK(rounded.difference.force.most < 1e-3 * rounded.difference.force.largest);
}

}  // namespace
}  // namespace slipbench::driver::commands
