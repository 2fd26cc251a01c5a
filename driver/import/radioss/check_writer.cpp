// SPDX-License-Identifier: Apache-2.0
#include "driver/import/radioss/check_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

#include "driver/base/text/format_number.hpp"
#include "driver/import/radioss/case_writer.hpp"

namespace slipbench::driver::radioss {
namespace {

/// Number of records that get a check of their own.
constexpr std::size_t kMostRecords = 20;

/// Returns what a coefficient is compared with; nothing if there is no closed form for it.
/// \param speed that it sees, a column or an expression in quotes if need be
std::optional<std::string> reference_text(const DeckFriction& friction, const DeckCoefficients& set,
                                          std::string_view speed) {
  if (is_empty(friction.law, set)) return "{expression: \"= 0\"}";
  const auto& c = set.c;
  const auto form = [&](std::string_view name, std::string constants, std::string inputs) {
    if (constants.starts_with(", ")) constants.erase(0, 2);
    return fmt::format(
        "{{closed_form: {}, with: {{{}}},\n              inputs: {{{}}}, output: coefficient}}",
        name, constants, inputs);
  };
  std::string constants = set.fric == 0.0 ? "" : ", Fric: " + base::format_number(set.fric);
  const auto add = [&](std::size_t count, bool zeros) {
    for (std::size_t i = 0; i < count; ++i) {
      if (zeros || c[i] != 0.0)
        constants += fmt::format(", C{}: {}", i + 1, base::format_number(c[i]));
    }
  };
  const std::string pressed = fmt::format("speed: {}, normal_force: = abs(normal_force)", speed);
  switch (friction.law) {
    case 1:
    case 2:
      add(friction.law == 1 ? 5 : 6, false);
      if (sees_pressure(friction, set)) constants += ", area: = area";
      return form(
          friction.law == 1 ? "generalized_viscous_coefficient" : "modified_darmstad_coefficient",
          constants, pressed);
    case 3:
      if (std::any_of(c.begin(), c.end(), [](double one) { return one < 0.0; })) return {};
      constants.clear();
      add(6, true);
      return form("renard_coefficient", constants, fmt::format("speed: {}", speed));
    case 4:
      if (falls(set)) {
        return form("exponential_decay",
                    fmt::format("static_coefficient: {}, kinetic_coefficient: {}, "
                                "decay_coefficient: {}",
                                base::format_number(set.fric), base::format_number(c[0]),
                                base::format_number(c[1])),
                    fmt::format("slip_rate: {}", speed));
      }
      return form("modified_darmstad_coefficient",
                  fmt::format("Fric: {}, C5: {}, C6: {}", base::format_number(c[0]),
                              base::format_number(set.fric - c[0]), base::format_number(-c[1])),
                  pressed);
    default:
      return fmt::format("{{expression: \"= {}\"}}", base::format_number(set.fric));
  }
}

/// A check of a list, as lines behind two blanks.
std::string check_text(std::string_view name, std::string_view quantity, std::string_view against,
                       std::string_view tolerance) {
  return fmt::format(
      "  - name: {}\n    quantity: {}\n    over: {{from: = 500*time_step}}\n    against: {}\n"
      "    tolerance: {}\n",
      name, quantity, against, tolerance);
}

/// The check of a coefficient; empty if there is none.
std::string coefficient_check(const DeckFriction& friction, const DeckCoefficients& set,
                              std::string_view name, std::string_view quantity,
                              std::string_view speed) {
  const auto against = reference_text(friction, set, speed);
  if (!against) return {};
  return check_text(name, quantity, *against,
                    friction.law == 0 || is_empty(friction.law, set)
                        ? "{absolute: 1.0e-15, why: the number is taken over as it is}"
                        : "{relative: 1.0e-9, why: the speed comes from differences of places}");
}

/// The checks of a record.
std::string record_checks(const DeckFriction& friction, const DeckPair& pair) {
  const std::string name =
      fmt::format("coefficient between {} and {} (line {} of the deck)", side_text(pair.sides[0]),
                  side_text(pair.sides[1]), pair.line);
  if (!pair.second) return coefficient_check(friction, pair.first, name, "MU", "= speed");
  return coefficient_check(friction, pair.first, name + " along direction 1", "MU1", "V1") +
         coefficient_check(friction, *pair.second, name + " along direction 2", "MU2", "V2");
}

/// Lines as a comment of a list.
std::string commented(std::string_view lines) {
  std::string result;
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    result += "  # " + std::string(lines.substr(2, end - 2)) + "\n";
    lines.remove_prefix(end + 1);
  }
  return result;
}

}  // namespace

std::string checks_text(const DeckFriction& friction) {
  std::string text = "checks:\n";
  text += check_text("the force keeps within its limit", "\"= max(UTILISATION, 1)\"",
                     "{expression: \"= 1\"}", "{relative: 1.0e-9, why: rounding}");
  const std::string otherwise = coefficient_check(
      friction, friction.otherwise,
      friction.pairs.empty() ? "coefficient of the deck's constants" : "coefficient of the default",
      "MU", "= speed");
  if (friction.pairs.empty()) return text + otherwise;
  text +=
      "  # Which record holds depends on part1 and part2: take the '# ' away before its checks, "
      "and its\n"
      "  # coefficient is held against the constants of the deck.\n";
  text += commented(otherwise);
  for (std::size_t i = 0; i < std::min(friction.pairs.size(), kMostRecords); ++i) {
    text += commented(record_checks(friction, friction.pairs[i]));
  }
  if (friction.pairs.size() > kMostRecords) {
    text +=
        fmt::format("  # (and so on for {} more records)\n", friction.pairs.size() - kMostRecords);
  }
  return text;
}

}  // namespace slipbench::driver::radioss
