// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "driver/base/text/format_number.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/read/resolve/resolve.hpp"
#include "driver/read/resolve/resolve_definition.hpp"
#include "law/base/component.hpp"

namespace slipbench::driver::read {
namespace {

/// The steps of a case, in order: what a change leaves out stays what an earlier one made it.
class Changes {
 public:
  Changes(yaml::Binder& binder, const CaseText& text, bool definitions_known, cases::Case& out)
      : binder_(binder), text_(text), known_(definitions_known), out_(out) {
    for (const cases::CaseDefinition& definition : out.definitions) {
      in_force_.push_back(definition.law);
      worn_.push_back(law::snap_back(definition.law));
    }
    ever_changed_.resize(in_force_.size(), false);
  }

  void add_step(std::size_t index, const yaml::NamedMap<FrictionChangeText>& changes) {
    index_ = index;
    changed_by_.assign(in_force_.size(), {});
    for (const yaml::Named<FrictionChangeText>& change : changes) add(change);
  }

 private:
  void add(const yaml::Named<FrictionChangeText>& change) {
    const FrictionChangeText& text = change.value;
    if (!change.node->is_map()) return;
    const std::vector<std::size_t> meant = definitions_called(change);
    const bool reset = text.reset.sound && text.reset.value;
    const bool sound = rules_hold(change, reset);
    const auto law =
        coefficient_law(binder_, text.coefficient, {text_.connector.value.area, out_.units});
    const history::Profile* amplitude = amplitude_of(text.amplitude);
    std::optional<law::StickStiffness> stick;
    if (text.stick.sound) {
      stick = stick_stiffness(binder_, text.stick, *change.node, change.path, false, out_.units);
    }
    warn_mixed_units(change, meant);
    if (!meant.empty()) {
      binder_.settle_slip_units(change.path,
                                law::is_rotational(out_.definitions[meant.front()].law.slip));
    }
    if (!sound || amplitude == nullptr || (!law && !reset)) return;
    for (const std::size_t definition : meant) {
      cases::FrictionChange result;
      result.definition = definition;
      result.amplitude = *amplitude;
      const law::FrictionDefinition& before = in_force_[definition];
      const law::FrictionDefinition& own = out_.definitions[definition].law;
      result.law = reset ? own.law : *law;
      if (!reset && !suit_to_slip(binder_, text.coefficient, own.slip, out_.units,
                                  radius_for(text.coefficient, meant, *law), result.law)) {
        continue;
      }
      result.force_limit = reset ? own.force_limit : before.force_limit;
      result.stick = reset ? own.stick : before.stick;
      if (text.force_limit.sound) {
        result.force_limit =
            text.force_limit.value > 0.0 ? text.force_limit.value : law::kNoForceLimit;
      }
      if (stick) result.stick = *stick;
      if (!result_is_possible(change, before, result)) continue;
      if (reset && !has_room_for(own.law, text.reset)) return;
      if (reset && index_ > 0 && !ever_changed_[definition]) {
        binder_.warning(*text.reset.node, text.reset.path,
                        "nothing to reset: no earlier step changes the friction of '" +
                            out_.definitions[definition].name + "'");
      }
      // docs/theory, section 9.2: not with the exponential law, not in the first step.
      result.blends_elastic_slip = index_ > 0 && !law::exponential_decay(result.law) &&
                                   result.stick.mode == law::StickStiffness::Mode::kElasticSlip;
      in_force_[definition].law = result.law;
      in_force_[definition].force_limit = result.force_limit;
      in_force_[definition].stick = result.stick;
      ever_changed_[definition] = true;
      if (index_ < out_.steps.size()) {
        out_.steps[index_].friction_changes.push_back(std::move(result));
      }
    }
  }

  /// The definitions a name means: one, or both checks of a predefined PLANAR or UJOINT.
  std::vector<std::size_t> definitions_called(const yaml::Named<FrictionChangeText>& change) {
    std::vector<std::size_t> meant;
    std::vector<std::string_view> names;
    const auto& friction = text_.friction.value;
    const bool unnamed_pair =
        friction.size() == 1 && !friction[0].value.name.given() && out_.definitions.size() > 1;
    for (std::size_t i = 0; i < out_.definitions.size(); ++i) {
      const std::string& name = out_.definitions[i].name;
      names.push_back(name);
      const bool base = name.size() > change.name.size() && name.starts_with(change.name) &&
                        name[change.name.size()] == '.';
      const bool automatic = unnamed_pair && change.name == "friction1";
      if (name == change.name || base || automatic) meant.push_back(i);
    }
    if (meant.empty() && known_) {
      binder_.error(*change.key, change.path,
                    "unknown friction definition '" + base::printable(change.name) + "'",
                    binder_.nearest_or(change.name, names, "known: " + base::few_in_words(names)));
    }
    std::vector<std::size_t> once;
    for (const std::size_t i : meant) {
      if (changed_by_[i].empty()) {
        changed_by_[i] = change.name;
        once.push_back(i);
      } else {
        binder_.error(*change.key, change.path,
                      "the friction of '" + out_.definitions[i].name +
                          "' is changed twice in this step, also by '" + changed_by_[i] + "'");
      }
    }
    return once;
  }

  bool rules_hold(const yaml::Named<FrictionChangeText>& change, bool reset) {
    const FrictionChangeText& text = change.value;
    bool good = change.sound;
    if (!reset && !text.coefficient.given()) {
      if (!text.reset.faulty() && !yaml::has_unknown_key<FrictionChangeText>(*change.node)) {
        binder_.error(*change.node, change.path,
                      "needs a 'coefficient', or 'reset: true' to go back to the one under "
                      "'friction:'");
      }
      good = false;
    }
    const auto refuse = [&](const auto& at) {
      if (!reset || !at.given()) return;
      binder_.error(*at.node, at.path,
                    "'reset: true' goes back to everything under 'friction:', nothing is given "
                    "beside it but the amplitude");
      good = false;
    };
    refuse(text.coefficient);
    refuse(text.force_limit);
    refuse(text.stick);
    if (text.coefficient.value.orthotropic || text.coefficient.value.with_direction) {
      binder_.error(*text.coefficient.node, text.coefficient.path,
                    "friction changes from one coefficient to another, not to two directions");
      good = false;
    }
    return good;
  }

  /// The friction radius, if the definitions need one and have it; warns once if they have none.
  std::optional<double> radius_for(const yaml::At<CoefficientText>& coefficient,
                                   const std::vector<std::size_t>& group,
                                   const law::FrictionLaw& law) {
    if (!slip_in_two_units(out_, group)) return std::nullopt;
    const yaml::At<double>& radius = text_.connector.value.friction_radius;
    if (radius.sound) return radius.value;
    const law::FrictionLaw& first = out_.definitions[group.front()].law.law;
    const bool said = law::depends_on_slip_rate(first) || law::depends_on_contact_force(first);
    if (!radius.given() && !said && !warned_) {
      warned_ = warn_of_two_units(binder_, coefficient, law, out_.units, 0.0);
    }
    return std::nullopt;
  }

  /// Null after an error.
  const history::Profile* amplitude_of(const yaml::At<AmplitudeText>& amplitude) {
    if (amplitude.faulty()) return nullptr;
    const cases::Step& step = out_.steps[index_];
    const auto* table = std::get_if<history::Tabular>(&amplitude.value.profile);
    if (table == nullptr) return &amplitude.value.profile;
    const double slack = history::kCoverageSlack * step.duration;
    const bool whole = std::abs(table->times.front()) <= slack &&
                       std::abs(table->times.back() - step.duration) <= slack;
    if (whole || text_.history.value.steps[index_].value.duration.faulty()) {
      return &amplitude.value.profile;
    }
    binder_.error(*amplitude.node, amplitude.path,
                  "the amplitude goes from t = " + base::format_number(table->times.front()) +
                      " to " + base::format_number(table->times.back()) + ", the step from 0 to " +
                      base::format_number(step.duration) + ": both must be the same");
    return nullptr;
  }

  bool result_is_possible(const yaml::Named<FrictionChangeText>& change,
                          const law::FrictionDefinition& before,
                          const cases::FrictionChange& result) {
    const FrictionChangeText& text = change.value;
    if (before.formulation && text.stick.given()) {
      binder_.error(*text.stick.node, text.stick.path,
                    "this definition has a 'formulation' in place of 'stick': only its coefficient "
                    "and its force limit can change");
      return false;
    }
    if (before.formulation && before.formulation->orthotropy) {
      binder_.error(*change.node, change.path,
                    "the coefficients of an orthotropic definition cannot change");
      return false;
    }
    if (out_.definitions[result.definition].backward) {
      binder_.error(*change.node, change.path,
                    "the coefficients of a direction-dependent definition cannot change");
      return false;
    }
    using Mode = law::StickStiffness::Mode;
    if (result.stick.mode != before.stick.mode) {
      const bool stiffness = before.stick.mode == Mode::kStiffness;
      binder_.error(*text.stick.node, text.stick.path,
                    std::string("the kind of stick stiffness stays over a run: it is ") +
                        (stiffness ? "a 'stiffness'" : "an elastic slip"),
                    stiffness ? "give {stiffness: ...}"
                              : "give {elastic_slip: ...} or {slip_tolerance: ...}");
      return false;
    }
    if (law::exponential_decay(result.law) && result.force_limit != law::kNoForceLimit) {
      const bool given = text.force_limit.given();
      binder_.error(
          given ? *text.force_limit.node : *change.node,
          given ? text.force_limit.path : change.path,
          "exponential decay takes no force limit" +
              std::string(
                  given ? "" : ", and " + base::format_number(result.force_limit) + " is in force"),
          given ? "" : "'force_limit: 0' takes it away");
      return false;
    }
    const law::SnapBack& worn = worn_[result.definition];
    if (!(worn.fall > 0.0)) return true;
    // While one coefficient turns into the other, d(mu F_N)/dF_N lies between theirs.
    const bool grows =
        index_ == 0 || law::largest_growth(result.law) >= law::largest_growth(before.law);
    const law::FrictionLaw& worst = grows ? result.law : before.law;
    warn_of_snap_back(binder_, law::changed_snap_back(worn, worst, result.stick.value), worst,
                      result.stick.value, text_, *change.node, change.path);
    return true;
  }

  /// Counts the rows of tables that resets bring back, each time as a copy. Returns false, the
  /// first time after an error, once they are more than all tables of a case may have from files.
  bool has_room_for(const law::FrictionLaw& own, const yaml::At<bool>& reset) {
    const auto* tabular = std::get_if<law::TabularCoefficient>(&own);
    if (tabular == nullptr || rows_ > yaml::Binder::kMostTableRows) return tabular == nullptr;
    rows_ += tabular->table.table().rows();
    if (rows_ <= yaml::Binder::kMostTableRows) return true;
    binder_.error(*reset.node, reset.path,
                  fmt::format("with this the resets of the case bring back more than {} rows of "
                              "tables",
                              yaml::Binder::kMostTableRows),
                  "let fewer steps reset, or give the table fewer rows");
    return false;
  }

  /// One number for a force over a length and for a moment over an angle.
  void warn_mixed_units(const yaml::Named<FrictionChangeText>& change,
                        const std::vector<std::size_t>& meant) {
    const FrictionChangeText& text = change.value;
    const auto rotational = [&](std::size_t i) {
      return law::is_rotation(out_.definitions[i].law.slip.component[0]);
    };
    if (meant.size() != 2 || rotational(meant[0]) == rotational(meant[1])) return;
    const std::string apart = "change '" + out_.definitions[meant[0]].name + "' and '" +
                              out_.definitions[meant[1]].name + "' apart";
    if (text.force_limit.given() && text.force_limit.value > 0.0) {
      binder_.warning(*text.force_limit.node, text.force_limit.path,
                      base::format_number(text.force_limit.value) +
                          " is a force for one and a moment for the other definition",
                      apart);
    }
    if (text.stick.given()) {
      binder_.warning(*text.stick.node, text.stick.path,
                      "holds for a translation and a rotation alike", apart);
    }
  }

  yaml::Binder& binder_;
  const CaseText& text_;
  bool known_;
  cases::Case& out_;
  std::size_t index_ = 0;
  std::vector<law::FrictionDefinition> in_force_;  ///< at the end of the steps so far
  std::vector<law::SnapBack> worn_;                ///< of the definitions as they are written
  std::vector<bool> ever_changed_;
  std::size_t rows_ = 0;                 ///< that resets have brought back
  bool warned_ = false;                  ///< of a law that sees two units
  std::vector<std::string> changed_by_;  ///< in this step
};

}  // namespace

void resolve_friction_changes(yaml::Binder& binder, const CaseText& text, bool definitions_known,
                              cases::Case& out) {
  Changes changes(binder, text, definitions_known, out);
  const auto& steps = text.history.value.steps;
  for (std::size_t i = 0; i < steps.size() && i < out.steps.size(); ++i) {
    changes.add_step(i, steps[i].value.change_friction);
  }
}

}  // namespace slipbench::driver::read
