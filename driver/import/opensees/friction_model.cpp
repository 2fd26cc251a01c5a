// SPDX-License-Identifier: Apache-2.0
#include "driver/import/opensees/friction_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "driver/base/text/format_number.hpp"

namespace slipbench::driver::opensees {
namespace {

using Kind = import::Loss::Kind;

std::string text_of(double value) { return base::format_number(value); }

/// Type of a model, and the names of its numbers behind the tag.
struct ModelType {
  std::string_view name;
  std::string_view old_name;  ///< of earlier versions
  std::array<std::string_view, 8> numbers{};
};

constexpr std::array kTypes{
    ModelType{"Coulomb", "CoulombFriction", {"mu"}},
    ModelType{"VelDependent", "VDependent", {"muSlow", "muFast", "transRate"}},
    ModelType{"VelPressureDep",
              "VPDependent",
              {"muSlow", "muFast0", "A", "deltaMu", "alpha", "transRate"}},
    ModelType{"VelNormalFrcDep",
              "VNDependent",
              {"aSlow", "nSlow", "aFast", "nFast", "alpha0", "alpha1", "alpha2", "maxMuFact"}},
    ModelType{"VelDepMultiLinear", "VDependentMultiLinear", {}}};

/// Returns x at which exp(-x) is known: straight lines between them are off by at most 1/(2 n^2).
std::vector<double> decay_knots(int intervals) {
  std::vector<double> knots{0.0};
  for (int i = 1; i < intervals; ++i) {
    // Equal falls of exp(-x/2), so that the error h^2 exp(-x)/8 of a chord is that of all others.
    knots.push_back(-2.0 * std::log(1.0 - static_cast<double>(i) / intervals));
  }
  return knots;
}

/// Rows of a table over slip rate and contact force, as lines of YAML.
class RowsText {
 public:
  void add(const std::string& mu, const std::string& rate, const std::string& force) {
    rows_ += fmt::format("{}[{}, {}, {}]", rows_.empty() ? "" : ",\n        ", mu, rate, force);
  }
  std::string table() const {
    return "\n      columns: [mu, slip_rate, contact_force]\n      rows: [" + rows_ + "]";
  }

 private:
  std::string rows_;
};

/// mu = fast - (fast - slow) exp(-rate v).
std::string transition(double slow, double fast, double rate) {
  if (slow == fast || rate == 0.0) return text_of(slow);
  if (slow > fast) {
    return fmt::format("{{exponential_decay: {{static: {}, kinetic: {}, decay: {}}}}}",
                       text_of(slow), text_of(fast), text_of(rate));
  }
  return fmt::format("{{modified_darmstad: {{Fric: {}, C5: {}, C6: {}}}}}", text_of(fast),
                     text_of(slow - fast), text_of(-rate));
}

/// VelPressureDep as a table over slip rate and normal force, up to where both functions end.
std::string pressure_table(const std::vector<double>& n) {
  const double slow = n[0];
  const double fast0 = n[1];
  const double area = n[2];
  const double change = n[3];
  const double alpha = n[4];
  const double rate = n[5];
  constexpr int kForces = 24;
  constexpr double kFlat = 6.0;  // 1 - tanh(6) is 1e-5
  RowsText rows;
  for (int j = 0; j <= kForces; ++j) {
    const double x = kFlat * j / kForces;
    const double force = alpha > 0.0 ? x * area / alpha : static_cast<double>(j);
    const double fast = fast0 - change * (alpha > 0.0 ? std::tanh(x) : 0.0);
    for (const double knot : decay_knots(kForces)) {
      const double mu = fast - (fast - slow) * std::exp(-knot);
      rows.add(text_of(mu), text_of(rate > 0.0 ? knot / rate : knot), text_of(force));
    }
    if (alpha <= 0.0) break;
  }
  return rows.table();
}

/// VelNormalFrcDep around the normal force that the case is given: powers have no scale of their
/// own.
std::string force_table(const std::vector<double>& n) {
  constexpr int kForces = 12;
  constexpr double kDecades = 2.0;
  RowsText rows;
  for (int j = 0; j <= kForces; ++j) {
    const double part = std::pow(10.0, kDecades * (2.0 * j / kForces - 1.0));
    const std::string force = fmt::format("({:.6g}*normal_force)", part);
    const std::string slow = fmt::format("{}*{}^({}-1)", text_of(n[0]), force, text_of(n[1]));
    const std::string fast = fmt::format("{}*{}^({}-1)", text_of(n[2]), force, text_of(n[3]));
    const std::string rate = fmt::format("({}+{}*{}+{}*{}^2)", text_of(n[4]), text_of(n[5]), force,
                                         text_of(n[6]), force);
    for (const double knot : decay_knots(kForces)) {
      rows.add(fmt::format("\"= min({}*{}, {} - ({} - {})*{})\"", text_of(n[7]), fast, fast, fast,
                           slow, text_of(std::exp(-knot))),
               fmt::format("= {}/{}", text_of(knot), rate), "= " + force);
    }
  }
  return rows.table();
}

class ModelReader {
 public:
  ModelReader(const Script& script, base::Diagnostics& out) : script_(script), out_(out) {}

  std::vector<Found> read() {
    for (const ScriptCommand& one : script_.commands) {
      if (one.words.front() == "frictionModel") read_model(one);
    }
    for (const ScriptCommand& one : script_.commands) {
      if (one.words.front() == "element") read_element(one);
    }
    return std::move(found_);
  }

 private:
  /// Models that become tables, of some 50 KB of text each.
  static constexpr int kMostTables = 2000;

  void fault(const ScriptCommand& command, const std::string& message) {
    out_.error(script_.texts.name(command.where), script_.texts.position(command.where),
               command.words.front(), message);
  }

  std::optional<double> number(const ScriptCommand& command, std::size_t index,
                               std::string_view name) {
    if (index >= command.words.size()) {
      fault(command, fmt::format("{} is missing", name));
      return std::nullopt;
    }
    const auto value = number_of(command, index);
    if (value) return *value;
    fault(command, fmt::format("{}: {}", name, value.error()));
    return std::nullopt;
  }

  void read_model(const ScriptCommand& command) {
    if (command.words.size() < 3) {
      fault(command, "wanted a type, a tag and the numbers of the model");
      return;
    }
    const std::string& type = command.words[1];
    const auto* const known = std::find_if(kTypes.begin(), kTypes.end(), [&](const ModelType& one) {
      return one.name == type || one.old_name == type;
    });
    if (known == kTypes.end()) {
      fault(command, fmt::format("unknown type {}; Coulomb, VelDependent, VelPressureDep, "
                                 "VelDepMultiLinear and VelNormalFrcDep are read",
                                 base::shortened(type, 60)));
      return;
    }
    const auto tag = number(command, 2, "the tag");
    if (!tag) return;
    if (*tag != std::floor(*tag) || std::abs(*tag) > 1e9) {
      fault(command, fmt::format("a tag is a whole number, found {}", text_of(*tag)));
      return;
    }
    if (by_tag_.contains(*tag)) {
      fault(command, fmt::format("the tag {} stands twice", text_of(*tag)));
      return;
    }
    Found found{static_cast<int>(*tag), std::string(known->name), {}};
    found.friction.name = fmt::format("frictionModel {} {}", known->name, found.tag);
    if (known->numbers.front().empty()) {
      if (!read_points(command, found.friction)) return;
    } else {
      std::vector<double> numbers;
      for (std::size_t i = 0; i < known->numbers.size() && !known->numbers[i].empty(); ++i) {
        const auto value = number(command, 3 + i, known->numbers[i]);
        if (!value) return;
        numbers.push_back(*value);
      }
      if (command.words.size() > 3 + numbers.size()) {
        fault(command, fmt::format("'{}' is one too many: {} takes {} number{} behind the tag",
                                   base::shortened(command.words[3 + numbers.size()], 60),
                                   known->name, numbers.size(), numbers.size() == 1 ? "" : "s"));
        return;
      }
      if (!take(command, numbers, found)) return;
    }
    found.friction.losses.push_back(
        {Kind::kApproximated,
         "OpenSees takes the velocity of the nodes, which a static analysis has not: there the "
         "coefficient is that at rest; the case takes the speed of its history"});
    by_tag_.emplace(*tag, found_.size());
    found_.push_back(std::move(found));
  }

  bool take(const ScriptCommand& command, const std::vector<double>& n, Found& found) {
    import::ContactFriction& friction = found.friction;
    const auto positive = [&](bool good, const char* rule) {
      if (!good) fault(command, rule);
      return good;
    };
    if (found.type == "Coulomb") {
      friction.otherwise.coefficient = text_of(n[0]);
      return positive(n[0] >= 0.0, "mu must not be negative");
    }
    if (found.type == "VelDependent") {
      friction.otherwise.coefficient = transition(n[0], n[1], n[2]);
      return positive(n[0] >= 0.0 && n[1] >= 0.0 && n[2] >= 0.0,
                      "muSlow, muFast and transRate must not be negative");
    }
    if (++tables_ > kMostTables) {
      const bool first = tables_ == kMostTables + 1;
      if (first) fault(command, fmt::format("at most {} models of tables are read", kMostTables));
      return false;
    }
    if (found.type == "VelPressureDep") {
      if (!positive(n[0] > 0.0 && n[1] > 0.0 && n[2] > 0.0 && n[4] >= 0.0 && n[5] >= 0.0,
                    "muSlow, muFast0 and A must be positive, alpha and transRate not negative")) {
        return false;
      }
      friction.otherwise.coefficient = pressure_table(n);
      friction.losses.push_back(
          {Kind::kApproximated,
           "VelPressureDep as a table over slip rate and normal force, its tanh and exp as 24 "
           "straight pieces each: off by at most 1 % of the change"});
      return true;
    }
    if (!positive(n[0] > 0.0 && n[2] > 0.0 && n[1] <= 1.0 && n[3] <= 1.0 && n[4] > 0.0,
                  "aSlow, aFast and alpha0 must be positive, nSlow and nFast at most 1")) {
      return false;
    }
    friction.otherwise.coefficient = force_table(n);
    friction.losses.push_back(
        {Kind::kApproximated,
         "VelNormalFrcDep as a table from 0.01 to 100 times the normal force of the case, constant "
         "outside of it; there the model's powers of N go on"});
    return true;
  }

  bool read_points(const ScriptCommand& command, import::ContactFriction& friction) {
    const auto velocities = std::find(command.words.begin(), command.words.end(), "-vel");
    const auto values = std::find(command.words.begin(), command.words.end(), "-frn");
    if (velocities >= values || values == command.words.end()) {
      fault(command, "wanted -vel v1 v2 .. -frn mu1 mu2 ..");
      return false;
    }
    const auto first = static_cast<std::size_t>(velocities - command.words.begin()) + 1;
    const auto second = static_cast<std::size_t>(values - command.words.begin()) + 1;
    const std::size_t count = second - 1 - first;
    if (count < 2 || command.words.size() - second != count) {
      fault(command, "wanted as many points behind -frn as behind -vel, two at least");
      return false;
    }
    std::string rows;
    double last = -1.0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto velocity = number(command, first + i, "-vel");
      const auto mu = number(command, second + i, "-frn");
      if (!velocity || !mu) return false;
      if (*velocity <= last || *mu < 0.0) {
        fault(command, "velocities must increase from 0 on, and no coefficient be negative");
        return false;
      }
      last = *velocity;
      rows += fmt::format("{}[{}, {}]", rows.empty() ? "" : ", ", text_of(*mu), text_of(*velocity));
    }
    friction.otherwise.coefficient =
        "{columns: [mu, slip_rate], rows: [" + rows + "], extrapolate: linear}";
    friction.notes.emplace_back(
        "OpenSees goes on beyond the last point with the slope of the last piece; so does the "
        "case");
    return true;
  }

  void read_element(const ScriptCommand& command) {
    if (command.words.size() < 7) return;
    const std::string& type = command.words[1];
    const bool flat =
        type == "flatSliderBearing" || type == "RJWatsonEqsBearing" || type == "RJWatsonEQSBearing";
    const bool pendulum = type == "singleFPBearing" || type == "SinglePendulum";
    if (!flat && !pendulum) return;
    const auto tag = number_of(command, 5);
    const auto model = tag ? by_tag_.find(*tag) : by_tag_.end();
    if (model == by_tag_.end()) return;
    import::ContactFriction& friction = found_[model->second].friction;
    const std::size_t at = pendulum ? 7 : 6;
    const auto stiffness = number(command, at, "kInit");
    if (!stiffness) return;
    if (*stiffness <= 0.0) {
      fault(command, "kInit must be greater than 0, found " + text_of(*stiffness));
      return;
    }
    if (!friction.tangential_stiffness) {
      friction.tangential_stiffness = *stiffness;
      friction.notes.push_back(fmt::format("K_t is kInit of {} {}", type, command.words[2]));
    } else if (*friction.tangential_stiffness != *stiffness) {
      friction.losses.push_back(
          {Kind::kDropped, fmt::format("kInit {} of {} {}, which another bearing has otherwise",
                                       text_of(*stiffness), type, command.words[2])});
    }
    if (pendulum) {
      friction.losses.push_back(
          {Kind::kDropped, fmt::format("the restoring force N/Reff of {} {}: give it as "
                                       "'elasticity', or see the friction alone",
                                       type, command.words[2])});
    }
    if (type.starts_with("RJ")) {
      friction.losses.push_back(
          {Kind::kDropped, fmt::format("the springs of {} {}", type, command.words[2])});
    }
  }

  const Script& script_;
  base::Diagnostics& out_;
  std::vector<Found> found_;
  std::map<double, std::size_t> by_tag_;  ///< their places
  int tables_ = 0;                        ///< models of two independents so far
};

}  // namespace

std::vector<Found> read_models(const Script& script, base::Diagnostics& out) {
  return ModelReader(script, out).read();
}

}  // namespace slipbench::driver::opensees
