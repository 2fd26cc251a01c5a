// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "driver/base/text/format_number.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/resolve/resolve.hpp"
#include "driver/read/resolve/resolve_definition.hpp"
#include "driver/read/resolve/resolve_formulation.hpp"
#include "driver/read/resolve/resolve_potential.hpp"

namespace slipbench::driver::read {
namespace {

using law::ComponentSet;

constexpr double kDefaultSlipTolerance = 1.0e-4;  // the default of docs/theory, section 10

/// Reports a force of a component that the connection does not have.
bool has_component(yaml::Binder& binder, const law::Connection& connection, int component,
                   const yaml::Node& at, const yaml::Path& path) {
  const ComponentSet all = connection.info.held | connection.info.available;
  if (all.contains(component)) return true;
  binder.error(at, path,
               connector_words(connection) + " has no component " + std::to_string(component + 1) +
                   ", it has the forces " + force_names(all));
  return false;
}

std::optional<law::DerivedTerm> derived_term(yaml::Binder& binder,
                                             const law::Connection& connection,
                                             const yaml::At<DerivedTermText>& at) {
  const DerivedTermText& text = at.value;
  law::DerivedTerm term;
  term.combine = text.combine.value;
  bool good = at.sound;
  if (text.sign.value == 0) {
    binder.error(*text.sign.node, text.sign.path, "the sign of a term is 1 or -1, found 0");
    good = false;
  }
  term.sign = text.sign.value;
  ComponentSet seen;
  for (const yaml::At<int>& component : text.components.value) {
    if (!component.sound) continue;
    const int c = component.value - 1;
    if (seen.contains(c)) {
      binder.error(*component.node, component.path,
                   "component " + std::to_string(c + 1) + " stands twice in this term");
      good = false;
      continue;
    }
    seen.insert(c);
    good = has_component(binder, connection, c, *component.node, component.path) && good;
    term.component[static_cast<std::size_t>(term.count)] = c;
    term.weight[static_cast<std::size_t>(term.count)] = 1.0;
    ++term.count;
  }
  const std::size_t count = text.components.value.size();
  if (text.components.sound && count == 0) {
    binder.error(*text.components.node, text.components.path,
                 "a term needs at least one component");
    good = false;
  }
  if (text.weights.sound && text.components.given() && count > 0) {
    if (const auto* numbers = std::get_if<std::vector<double>>(&text.weights.value)) {
      if (numbers->size() != count) {
        binder.error(*text.weights.node, text.weights.path,
                     "wanted one weight for each component (" + std::to_string(count) +
                         "), found " + std::to_string(numbers->size()));
        good = false;
      } else if (good) {
        std::copy(numbers->begin(), numbers->end(), term.weight.begin());
      }
    } else {
      auto weights =
          table_function(binder, std::get<TableText>(text.weights.value), *text.weights.node,
                         text.weights.path, kWeightTable, static_cast<int>(count));
      if (!weights || !independents_available(binder, connection, *weights, *text.weights.node,
                                              text.weights.path)) {
        return std::nullopt;
      }
      term.weight_table = std::move(*weights);
    }
  }
  if (!good) return std::nullopt;
  return term;
}

/// A name that looks like a number or an expression is read as one.
bool can_be_referred_to(std::string_view name) {
  return !name.empty() &&
         std::string_view("+-.0123456789= ").find(name.front()) == std::string_view::npos;
}

struct DerivedComponents {
  std::vector<std::pair<std::string, law::DerivedComponent>> sound;
  std::vector<std::string> names;  ///< of all, so that a faulty one is not reported as unknown
  bool readable = true;            ///< false: not even the names are known
};

DerivedComponents derived_components(yaml::Binder& binder, const CaseText& text,
                                     const cases::Case& problem) {
  DerivedComponents result;
  result.readable = !text.derived_components.given() || text.derived_components.node->is_map();
  for (const auto& named : text.derived_components.value) {
    result.names.push_back(named.name);
    if (!can_be_referred_to(named.name)) {
      binder.error(*named.key, named.path,
                   "a derived component cannot have the name '" + base::printable(named.name) +
                       "': 'contact_force:' reads it as a number");
    }
    law::DerivedComponent component;
    bool norms = false, sums = false, negative = false, others = false;
    for (std::size_t i = 0; i < named.value.size(); ++i) {
      auto term = derived_term(binder, problem.connection, named.value[i]);
      if (!term) continue;
      norms = norms || term->combine == law::TermOperator::kNorm;
      sums = sums || term->combine == law::TermOperator::kSum;
      others = others || term->combine != law::TermOperator::kNorm;
      negative = negative || term->sign < 0.0;
      component.push_back(std::move(*term));
    }
    // The rules of docs/theory, section 6, on contact forces.
    if (norms && sums) {
      binder.error(*named.key, named.path,
                   "norm and sum terms do not mix in one contact force (macauley_sum and norm do)");
    }
    if (norms && !others && negative) {
      binder.error(*named.key, named.path, "a contact force of norms only needs sign 1 throughout");
    }
    if (named.sound && named.value.empty()) {
      binder.error(*named.key, named.path, "a derived component needs at least one term");
    }
    if (component.size() == named.value.size() && !component.empty()) {
      result.sound.emplace_back(named.name, std::move(component));
    }
  }
  return result;
}

}  // namespace

law::StickStiffness stick_stiffness(yaml::Binder& binder, const yaml::At<StickText>& text,
                                    const yaml::Node& parent, const yaml::Path& parent_path,
                                    bool parent_misspelt, const base::UnitSystem& units) {
  const StickText& stick = text.value;
  using Mode = law::StickStiffness::Mode;
  const bool misspelt = parent_misspelt || (text.given() && text.node->is_map() &&
                                            yaml::has_unknown_key<StickText>(*text.node));
  if (text.faulty() || misspelt) return {Mode::kElasticSlip, kDefaultSlipTolerance};
  const int ways = (stick.slip_tolerance.given() || stick.characteristic_length.given() ? 1 : 0) +
                   (stick.elastic_slip.given() ? 1 : 0) + (stick.stiffness.given() ? 1 : 0);
  if (ways > 1) {
    binder.error(*text.node, text.path,
                 "give one of {slip_tolerance, characteristic_length}, {elastic_slip} and "
                 "{stiffness}");
  }
  if (stick.stiffness.given()) return {Mode::kStiffness, stick.stiffness.value};
  if (stick.elastic_slip.given()) return {Mode::kElasticSlip, stick.elastic_slip.value};
  const double tolerance =
      stick.slip_tolerance.given() ? stick.slip_tolerance.value : kDefaultSlipTolerance;
  double length = 1.0;
  if (stick.characteristic_length.given()) {
    length = stick.characteristic_length.value;
  } else {
    const std::string unit = units.length.empty() ? "" : " " + units.length;
    binder.note(text.given() ? *text.node : parent, text.given() ? text.path : parent_path,
                "characteristic length not given, 1" + unit +
                    " (1 rad in rotation) used for the stick stiffness: elastic slip " +
                    base::format_number(tolerance));
  }
  const double elastic_slip = tolerance * length;
  if (!(elastic_slip >= std::numeric_limits<double>::min()) || !std::isfinite(elastic_slip)) {
    binder.error(*text.node, text.path,
                 "slip_tolerance * characteristic_length = " + base::format_number(tolerance) +
                     " * " + base::format_number(length) + " is no elastic slip a double can hold");
  }
  return {Mode::kElasticSlip, elastic_slip};
}

void warn_of_snap_back(yaml::Binder& binder, const law::FrictionDefinition& d, const CaseText& text,
                       const yaml::Node& node, const yaml::Path& path) {
  warn_of_snap_back(binder, law::snap_back(d), d.law, d.stick.value, text, node, path);
}

void warn_of_snap_back(yaml::Binder& binder, const law::SnapBack& snap, const law::FrictionLaw& law,
                       double stiffness, const CaseText& text, const yaml::Node& node,
                       const yaml::Path& path) {
  if (snap.ratio < 1.0 || text.integration.snap_back.value == cases::SnapBackAction::kJump) return;
  const auto cell = [](const law::CellRange& range) {
    return base::format_number(range.begin) + " .. " + base::format_number(range.end);
  };
  const bool uneven = snap.along != 1.0;
  const std::string stick = base::format_number(stiffness);
  std::string message = fmt::format(
      "wear may fall faster than the stick stiffness can follow (snap-back): mu |F'| / {} = {} * "
      "{} "
      "/ {} = {:.6g} in the cell accumulated_slip = {}",
      uneven ? "(|m|^2 k)" : "k", base::format_number(snap.growth), base::format_number(snap.fall),
      uneven ? fmt::format("({:.6g} * {})", snap.along, stick) : stick, snap.ratio,
      cell(snap.slip));
  if (snap.contact) message += " at contact_force = " + cell(*snap.contact);
  if (law::depends_on_contact_force(law)) message += "; mu stands for d(mu F_N)/dF_N";
  if (uneven) message += "; |m|^2 is the least of the potential, where its terms slip together";
  binder.warning(
      node, path, message + "; a run that meets 1 or more ends there",
      fmt::format("a stick.stiffness above {:.6g} or a flatter table follows everywhere, "
                  "'integration: {{snap_back: jump}}' goes on behind the jump",
                  snap.growth * snap.fall / snap.along));
}

namespace {

/// Largest coefficient taken without doubt: dry rubber reaches 2 to 4.
constexpr double kLargestPlausible = 5.0;

void doubt(yaml::Binder& binder, const yaml::At<CoefficientText>& text,
           const std::optional<law::FrictionLaw>& law) {
  const auto* constant = law ? std::get_if<law::ConstantCoefficient>(&*law) : nullptr;
  if (constant == nullptr || !(constant->mu > kLargestPlausible)) return;
  binder.warning(
      *text.node, text.path,
      "a coefficient of " + base::format_number(constant->mu) + " is beyond dry friction",
      "a percentage is written as its fraction: " + base::format_number(constant->mu / 100.0));
}

std::optional<law::FrictionLaw> coefficient(yaml::Binder& binder, const FrictionText& text,
                                            const yaml::Node& friction, const yaml::Path& path,
                                            const LawSurroundings& surroundings) {
  const CoefficientText& coefficient = text.coefficient.value;
  if (coefficient.orthotropic) {
    const yaml::At<DirectionText>& first = coefficient.orthotropic->direction1;
    return coefficient_law(binder, coefficient_of(first), surroundings);
  }
  if (coefficient.with_direction) {
    const yaml::At<DirectionText>& forward = coefficient.with_direction->forward;
    return coefficient_law(binder, coefficient_of(forward), surroundings);
  }
  if (text.coefficient.given()) {
    auto law = coefficient_law(binder, text.coefficient, surroundings);
    doubt(binder, text.coefficient, law);
    return law;
  }
  if (yaml::has_unknown_key<FrictionText>(friction)) return std::nullopt;
  binder.warning(friction, path, "no coefficient: this definition has no effect",
                 "give it a 'coefficient'");
  return law::FrictionLaw(law::ConstantCoefficient{0.0});
}

/// Returns whether a belt over several rings has a friction definition for each of them.
bool has_friction_for_each_ring(const CaseText& text, const cases::Case& problem) {
  return cases::is_belt(problem.connection) && text.friction.value.size() > 1 &&
         text.friction.value.size() ==
             std::get<law::SlipRing>(*problem.connection.type).wrap_angles.size();
}

/// One entry of `friction:` with what its definitions share.
class Resolver {
 public:
  Resolver(yaml::Binder& binder, const CaseText& text, bool derived_known, cases::Case& out)
      : binder_(binder), text_(text), out_(out), derived_(derived_components(binder, text, out)) {
    derived_.readable = derived_.readable && derived_known;
  }

  /// \param index of the entry
  law::FrictionOutline add(const yaml::At<FrictionText>& friction, std::size_t index) {
    const FrictionText& text = friction.value;
    const yaml::Node& node = *friction.node;
    const yaml::Path& path = friction.path;
    if (!node.is_map()) {
      outlines_known_ = false;
      return {};
    }
    if (cases::is_belt(out_.connection) && belt_has_predefined_friction_only(text)) {
      outlines_known_ = false;
      return {};
    }
    const int forms = (text.predefined.given() ? 1 : 0) + (text.component.given() ? 1 : 0) +
                      (text.potential.given() ? 1 : 0);
    if (forms != 1) {
      outlines_known_ = false;
      if (forms > 1 || !yaml::has_unknown_key<FrictionText>(node)) {
        binder_.error(node, path,
                      std::string(forms == 0 ? "needs" : "takes only") +
                          " one of 'predefined', 'component' and 'potential'");
      }
    }
    law::FrictionDefinition shared;
    if (auto law =
            coefficient(binder_, text, node, path, {text_.connector.value.area, out_.units})) {
      shared.law = std::move(*law);
    } else if (is_named_law(text.coefficient)) {
      columns_known_ = false;
    }
    const bool silent =
        yaml::has_unknown_key<FrictionText>(node) || rigid(text) || has_formulation(text);
    shared.stick = stick_stiffness(binder_, text.stick, node, path, silent, out_.units);
    shared.accumulated_slip = text_.integration.accumulated_slip.value;
    shared.slip_rate = text_.integration.slip_rate.value;
    const auto penalty = formulation(binder_, friction, {text_.connector.value.area, out_.units});
    if (penalty) set_formulation(shared, *penalty);
    if (!penalty && has_formulation(text)) columns_known_ = false;
    const std::size_t first = out_.definitions.size();
    if (text.force_limit.sound && text.force_limit.value > 0.0) {
      shared.force_limit = text.force_limit.value;
      if (law::exponential_decay(shared.law)) {
        binder_.error(*text.force_limit.node, text.force_limit.path,
                      "exponential decay takes no force limit");
      }
    }
    law::FrictionOutline outline;
    if (text.predefined.given()) {
      outline.form = law::FrictionForm::kPredefined;
      predefined(friction, index, shared, outline);
    } else if (text.potential.given()) {
      outline.form = law::FrictionForm::kPotential;
      potential(text.potential, shared, outline);
      warn_of_missing_scale(text.potential.value, law::depends_on_slip_rate(shared.law));
      user_defined(friction, shared, true);
    } else if (text.component.given()) {
      if (text.component.sound) {
        shared.slip = law::slip_space({text.component.value});
        outline.components.insert(text.component.value - 1);
      } else {
        outlines_known_ = false;
      }
      user_defined(friction, shared, false);
    }
    if (text.coefficient.value.with_direction) add_backward(friction, first);
    for (std::size_t i = first; i < out_.definitions.size(); ++i) {
      owner_of_definition_.push_back(&text.coefficient);
      out_.definitions[i].entry = index;
    }
    // Where sliding and spinning share a number, it is the sliding one's.
    if (first < out_.definitions.size()) {
      binder_.settle_slip_units(path, law::is_rotational(out_.definitions[first].law.slip));
    }
    for (std::size_t i = first; i < out_.definitions.size() && has_formulation(text); ++i) {
      if (!slip_suits_formulation(binder_, friction, out_.definitions[i].law)) break;
    }
    return outline;
  }

  /// Suits the law of every definition to what it slips in; goes after all of them.
  void suit_laws() {
    const yaml::At<double>& radius = text_.connector.value.friction_radius;
    std::vector<std::size_t> all(out_.definitions.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    // A case shares its one coefficient if it is predefined or of the parts that meet.
    const bool shared = out_.pair || text_.friction.value.front().value.predefined.given();
    const bool mixed = shared && slip_in_two_units(out_, all);
    if (radius.sound && !mixed && !is_any_connection(out_.connection)) {
      const auto together = std::find_if(all.begin(), all.end(), [&](std::size_t i) {
        return radius_of_rotation(out_.definitions[i].law.slip).has_value();
      });
      binder_.warning(
          *radius.node, radius.path,
          together == all.end()
              ? "not used: no coefficient is shared by a translation and a rotation"
              : "not used: translation and rotation slip together, at the radius " +
                    base::format_number(*radius_of_rotation(out_.definitions[*together].law.slip)) +
                    " of the rotation's 'scale' or of 'predefined'");
    }
    if (mixed && !radius.given()) {
      warn_of_two_units(binder_, *owner_of_definition_.front(), out_.definitions.front().law.law,
                        out_.units, arm_);
    }
    const yaml::At<CoefficientText>* faulty = nullptr;
    for (const std::size_t i : all) {
      if (owner_of_definition_[i] == faulty) continue;  // the same fault in each of them
      const bool good =
          suit_laws(*owner_of_definition_[i], out_.definitions[i],
                    mixed && radius.sound ? std::optional(radius.value) : std::nullopt);
      if (!good) faulty = owner_of_definition_[i];
    }
  }

  /// Tells whether it is known which components slip.
  [[nodiscard]] bool outlines_known() const { return outlines_known_; }
  /// Tells whether it is known which columns the laws and formulations bring with them.
  [[nodiscard]] bool columns_known() const { return columns_known_; }

 private:
  /// Gives the definitions from `first` on the coefficient of backward slip.
  void add_backward(const yaml::At<FrictionText>& friction, std::size_t first) {
    const yaml::At<DirectionText>& text = friction.value.coefficient.value.with_direction->backward;
    const auto law =
        coefficient_law(binder_, coefficient_of(text), {text_.connector.value.area, out_.units});
    if (!law) return;
    const yaml::At<double>& cap = friction.value.force_limit;
    for (std::size_t i = first; i < out_.definitions.size(); ++i) {
      cases::CaseDefinition& definition = out_.definitions[i];
      definition.backward = *law;
      law::FrictionDefinition other = definition.law;
      other.law = *law;
      warn_of_snap_back(binder_, other, text_, *text.node, text.path);
      if (law::exponential_decay(*law) && !law::exponential_decay(definition.law.law) &&
          other.force_limit != law::kNoForceLimit) {
        binder_.error(*cap.node, cap.path, "exponential decay takes no force limit");
      }
    }
  }
  /// \return false after reporting an error
  bool suit_laws(const yaml::At<CoefficientText>& coefficient, cases::CaseDefinition& definition,
                 std::optional<double> radius) {
    const auto& directions = coefficient.value.orthotropic;
    const auto& senses = coefficient.value.with_direction;
    law::FrictionDefinition& d = definition.law;
    const auto suit = [&](const yaml::At<CoefficientText>& at, law::FrictionLaw& law) {
      return suit_to_slip(binder_, at, d.slip, out_.units, radius, law);
    };
    bool good = suit(directions ? coefficient_of(directions->direction1)
                     : senses   ? coefficient_of(senses->forward)
                                : coefficient,
                     d.law);
    if (definition.backward) {
      good = suit(coefficient_of(senses->backward), *definition.backward) && good;
    }
    if (directions && d.formulation && d.formulation->orthotropy) {
      good =
          suit(coefficient_of(directions->direction2), d.formulation->orthotropy->second) && good;
    }
    return good;
  }
  /// A number and a table have the columns of every law.
  static bool is_named_law(const yaml::At<CoefficientText>& coefficient) {
    return coefficient.given() && coefficient.node->is_map() && !coefficient.node->find("columns");
  }

  /// A mass sticks rigidly: that a stick stiffness is not given need not be said.
  bool rigid(const FrictionText& text) const {
    return text_.dynamics.given() && !text.stick.given();
  }

  /// A belt's limit depends on the sense of its flow: no potential and no contact force says that.
  /// \return whether an error was reported
  bool belt_has_predefined_friction_only(const FrictionText& text) {
    bool found = false;
    const auto refuse = [&](const auto& at, const std::string& message) {
      if (!at.given()) return;
      found = true;
      binder_.error(*at.node, at.path, message,
                    "the friction of a SLIPRING is 'predefined: {}' with its coefficient");
    };
    const std::string band =
        ": the limit of a belt on its ring depends on the sense of its flow (capstan), which only "
        "predefined friction has";
    refuse(text.component, "a SLIPRING takes no 'component'" + band);
    refuse(text.potential, "a SLIPRING takes no 'potential'" + band);
    refuse(
        text.contact_force,
        "a SLIPRING takes no contact force: what presses the belt on its ring is its tension f1");
    refuse(text.internal_contact_force,
           "a SLIPRING takes no internal contact force: what presses the belt on its ring is its "
           "tension f1");
    return found;
  }

  void predefined(const yaml::At<FrictionText>& friction, std::size_t index,
                  const law::FrictionDefinition& shared, law::FrictionOutline& outline) {
    const FrictionText& text = friction.value;
    for (const auto& [given, node, path] :
         {std::tuple{text.contact_force.given(), text.contact_force.node, text.contact_force.path},
          std::tuple{text.internal_contact_force.given(), text.internal_contact_force.node,
                     text.internal_contact_force.path}}) {
      if (given) {
        binder_.error(*node, path,
                      "predefined friction chooses its contact force itself; an internal contact "
                      "force goes inside 'predefined:'");
      }
    }
    // Without its type, nothing is known of the connection's predefined friction.
    if (!text.predefined.sound || is_any_connection(out_.connection)) {
      outlines_known_ = false;
      return;
    }
    const yaml::Node& map = *text.predefined.value.node;
    bool found = false;
    if (out_.connection.type) {
      std::visit(
          [&]<class Type>(const Type& type) {
            if constexpr (law::HasPredefinedFriction<Type>) {
              found = true;
              Type geometry = type;
              if (!yaml::read_struct(binder_, map, text.predefined.path, geometry) ||
                  !tables_available(map, text.predefined.path, geometry)) {
                outlines_known_ = false;
                return;
              }
              if (!is_ring(map, text.predefined.path, geometry)) return;
              note_dropped_terms(map, text.predefined.path, geometry);
              warn_mixed_units(friction, geometry);
              const bool one_a_ring = has_friction_for_each_ring(text_, out_);
              const auto written = std::make_shared<const law::ConnectionType>(geometry);
              for (law::PredefinedFriction& check : geometry.predefined()) {
                if (one_a_ring && check.number != static_cast<int>(index) + 1) continue;
                law::FrictionDefinition d = shared;
                d.slip = check.slip;
                d.contact_force = std::move(check.contact_force);
                d.internal_contact_force = std::move(check.internal_contact_force);
                d.criterion = check.criterion;
                for (int i = 0; i < d.slip.dimension; ++i) {
                  outline.components.insert(d.slip.component[static_cast<std::size_t>(i)]);
                }
                warn_of_snap_back(binder_, d, text_, map, text.predefined.path);
                std::string name = text.name.value;
                if (!check.suffix.empty() && (name.empty() || !one_a_ring)) {
                  name = (name.empty() ? "" : name + ".") + std::string(check.suffix) +
                         (check.number > 0 ? std::to_string(check.number) : std::string());
                }
                out_.definitions.push_back({std::move(name), d.slip.dimension > 1, std::move(d)});
                out_.definitions.back().predefined = written;
              }
            }
          },
          *out_.connection.type);
    }
    if (!found) {
      outlines_known_ = false;
      std::vector<std::string_view> with;
      std::vector<std::string_view> in_pairs;
      law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
        if constexpr (law::HasPredefinedFriction<Type>) {
          with.push_back(Type::kInfo.name);
          if (Type::kInfo.assembly == "basic") in_pairs.push_back(Type::kInfo.name);
        }
      });
      binder_.error(map, text.predefined.path,
                    connector_words(out_.connection) + " has no predefined friction",
                    "those that have: " + base::in_words(with, "and") + ", and " +
                        base::in_words(in_pairs, "and") +
                        " in a pair with any rotation; here give 'component' or 'potential'");
    }
  }

  /// The tables of predefined friction depend on motions the connection has.
  template <class Type>
  bool tables_available(const yaml::Node& map, const yaml::Path& path, const Type& geometry) {
    bool good = true;
    yaml::for_each_key<Type>([&](std::string_view key, auto member, const yaml::KeyInfo&) {
      using Member = std::remove_cvref_t<decltype(geometry.*member)>;
      if constexpr (std::is_same_v<Member, law::InternalContactForce>) {
        const auto* function = std::get_if<law::TableFunction>(&(geometry.*member));
        const auto value = map.find(key);
        if (function != nullptr && value) {
          good = independents_available(binder_, out_.connection, *function, *value, path / key) &&
                 good;
        }
      }
    });
    return good;
  }

  /// PLANAR checks a force over a length and a moment over an angle with one set of numbers: what
  /// one number means for both depends on the unit of length.
  template <class Type>
  void warn_mixed_units(const yaml::At<FrictionText>& friction,
                        [[maybe_unused]] const Type& geometry) {
    if constexpr (std::is_same_v<Type, law::Planar>) {
      if (geometry.R > 0.0) arm_ = geometry.mean_arm();
      const FrictionText& text = friction.value;
      const auto warn = [&](const yaml::At<double>& number, std::string_view sliding,
                            std::string_view spinning) {
        if (!number.given() || number.value == 0.0) return;
        binder_.warning(*number.node, number.path,
                        base::format_number(number.value) + " is " + std::string(sliding) +
                            " for sliding and " + std::string(spinning) + " for spinning",
                        "to choose them apart write two definitions: a potential of 2 and 3, and "
                        "component 4");
      };
      warn(text.force_limit, "a force", "a moment");
      warn(text.stick.value.stiffness, "a force per length", "a moment per radian");
      warn(text.formulation.value.tangential_stiffness, "a force per length",
           "a moment per radian");
      warn(text.formulation.value.viscous_coefficient, "a force per speed",
           "a moment per angular speed");
      warn(text.stick.value.elastic_slip, "a length", "an angle");
      warn(text.stick.value.characteristic_length, "a length", "an angle");
    }
  }

  /// The radius at which a rotation slips together with translations; nothing where none does.
  static std::optional<double> radius_of_rotation(const law::SlipSpace& slip) {
    bool slides = false;
    std::optional<double> radius;
    for (std::size_t i = 0; i < static_cast<std::size_t>(slip.dimension); ++i) {
      if (law::is_rotation(slip.component[i])) {
        radius = slip.scale[i];
      } else {
        slides = true;
      }
    }
    return slides ? radius : std::nullopt;
  }

  /// A rotation that slips with translations and has no radius: its rate is added to theirs.
  void warn_of_missing_scale(const PotentialText& potential, bool rate) {
    const auto rotates = [](const yaml::At<PotentialTermText>& term) {
      return law::is_rotation(term.value.component.value - 1);
    };
    const auto slides = [&](const yaml::At<PotentialTermText>& term) {
      return term.value.component.sound && !rotates(term);
    };
    const auto& terms = potential.terms.value;
    if (std::none_of(terms.begin(), terms.end(), slides)) return;
    for (const yaml::At<PotentialTermText>& term : terms) {
      const PotentialTermText& text = term.value;
      if (!text.component.sound || !rotates(term) || text.scale.given()) continue;
      binder_.warning(*term.node, term.path,
                      "component " + std::to_string(text.component.value) +
                          " is a rotation beside translations: without a 'scale' its " +
                          (rate ? "rate in rad is added to theirs, and the coefficient depends on "
                                  "the sum"
                                : "moment counts like their forces, as at the radius 1"),
                      "'scale' is the radius it rubs at");
      return;
    }
  }

  /// Returns true if the inner radius of a PLANAR, if it has one, leaves a ring; else reports it.
  template <class Type>
  bool is_ring(const yaml::Node& map, const yaml::Path& path,
               [[maybe_unused]] const Type& geometry) {
    if constexpr (std::is_same_v<Type, law::Planar>) {
      if (geometry.R_i > 0.0 && geometry.R_i >= geometry.R) {
        binder_.error(*map.find("R_i"), path / "R_i",
                      "the inner radius of a ring must be less than its radius R, " +
                          base::format_number(geometry.R));
        return false;
      }
    }
    return true;
  }

  /// A zero length silently drops its term of the contact force: worth a note if it was written.
  template <class Type>
  void note_dropped_terms(const yaml::Node& map, const yaml::Path& path, const Type& geometry) {
    yaml::for_each_key<Type>([&](std::string_view key, auto member, const yaml::KeyInfo&) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(geometry.*member)>, double>) {
        const auto value = map.find(key);
        if constexpr (std::is_same_v<Type, law::Planar>) {
          if (member == &law::Planar::R_i) return;  // 0 is a disc
        }
        if (value && geometry.*member == 0.0) {
          binder_.note(*value, path / key, "0 drops the term of the contact force it belongs to");
        }
      }
    });
  }

  /// Slip space and criterion of a potential.
  void potential(const yaml::At<PotentialText>& text, law::FrictionDefinition& d,
                 law::FrictionOutline& outline) {
    const ResolvedPotential resolved = resolve_potential(
        binder_, text, [this](const yaml::At<std::string>& name) { return derived(name); });
    d.slip = resolved.slip;
    d.criterion = resolved.criterion;
    outline.components = resolved.components;
    outlines_known_ = outlines_known_ && resolved.components_known;
  }

  void user_defined(const yaml::At<FrictionText>& friction, law::FrictionDefinition d,
                    bool coupled) {
    const FrictionText& text = friction.value;
    if (!text.contact_force.given() && !text.internal_contact_force.given() &&
        !yaml::has_unknown_key<FrictionText>(*friction.node)) {
      binder_.error(*friction.node, friction.path,
                    "neither 'contact_force' nor 'internal_contact_force': nothing presses");
    }
    if (text.contact_force.sound) contact_force(text.contact_force, d);
    if (text.internal_contact_force.sound) {
      if (const auto* t = std::get_if<TableText>(&text.internal_contact_force.value)) {
        auto function = table_function(binder_, *t, *text.internal_contact_force.node,
                                       text.internal_contact_force.path, kInternalForceTable);
        if (function && independents_available(binder_, out_.connection, *function,
                                               *text.internal_contact_force.node,
                                               text.internal_contact_force.path)) {
          d.internal_contact_force = std::move(*function);
          warn_of_snap_back(binder_, d, text_, *text.internal_contact_force.node,
                            text.internal_contact_force.path);
        }
      } else {
        d.internal_contact_force = std::get<double>(text.internal_contact_force.value);
      }
    }
    out_.definitions.push_back({text.name.value, coupled, std::move(d)});
  }

  void contact_force(const yaml::At<ContactForceText>& contact, law::FrictionDefinition& d) {
    if (const int* number = std::get_if<int>(&contact.value.value)) {
      d.contact_force = law::ComponentContactForce{*number - 1};
      // Behind what opens nothing presses: its normal force is one-sided for every definition.
      const auto& type = out_.connection.type;
      if (type && std::holds_alternative<law::Contact>(*type) && *number == 1) {
        d.contact_force = law::Contact::pressing();
      }
      has_component(binder_, out_.connection, *number - 1, *contact.node, contact.path);
      return;
    }
    yaml::At<std::string> name;
    name.value = std::get<std::string>(contact.value.value);
    name.node = contact.node;
    name.path = contact.path;
    const law::DerivedComponent* component = derived(name);
    // More definitions than components are refused in the end: no copy for each of them.
    if (component == nullptr || text_.friction.value.size() > law::kComponents) return;
    d.contact_force = *component;
  }

  /// A derived component by its name; null if it is faulty or unknown, which is reported.
  const law::DerivedComponent* derived(const yaml::At<std::string>& name) {
    for (const auto& [known, component] : derived_.sound) {
      if (known == name.value) return &component;
    }
    // The fault of a faulty one is reported where it stands, and so are faulty names.
    if (std::find(derived_.names.begin(), derived_.names.end(), name.value) !=
            derived_.names.end() ||
        !derived_.readable) {
      return nullptr;
    }
    const std::vector<std::string_view> names(derived_.names.begin(), derived_.names.end());
    binder_.error(*name.node, name.path,
                  "unknown derived component '" + base::printable(name.value) + "'",
                  binder_.nearest_or(name.value, names,
                                     names.empty() ? "define it under 'derived_components:'"
                                                   : "known: " + base::few_in_words(names)));
    return nullptr;
  }

  yaml::Binder& binder_;
  const CaseText& text_;
  cases::Case& out_;
  DerivedComponents derived_;
  std::vector<const yaml::At<CoefficientText>*> owner_of_definition_;  ///< where its law is written
  double arm_ = 0.0;  ///< mean friction arm of a predefined puck [L]
  bool outlines_known_ = true;
  bool columns_known_ = true;
};

/// Definitions need different names, and names that can stand in a column.
/// \return whether they have
bool name_definitions(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  const std::vector<yaml::At<FrictionText>>& all = text.friction.value;
  const auto automatic = [](std::size_t i) { return "friction" + std::to_string(i + 1); };
  bool good = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const yaml::At<std::string>& name = all[i].value.name;
    if (name.faulty()) good = false;
    if (!name.sound) continue;
    if (!base::is_identifier(name.value)) {
      binder.error(*name.node, name.path,
                   "a name is a letter, then letters, digits and '_', found '" +
                       base::printable(name.value) + "'");
      good = false;
    }
    for (std::size_t j = 0; j < all.size(); ++j) {
      const yaml::At<std::string>& other = all[j].value.name;
      const bool same =
          other.given() ? j < i && other.value == name.value : j != i && automatic(j) == name.value;
      if (!same) continue;
      binder.error(*name.node, name.path,
                   "the name '" + base::printable(name.value) + "' is already that of friction[" +
                       std::to_string(j) + "]");
      good = false;
      break;
    }
  }
  for (std::size_t i = 0; i < out.definitions.size(); ++i) {
    if (out.definitions[i].name.empty()) out.definitions[i].name = automatic(i);
  }
  return good;
}

/// Returns where a definition says that it slips in `component` (index 0..5), or that it slips at
/// all.
std::pair<yaml::Node, yaml::Path> place_of(const yaml::At<FrictionText>& friction,
                                           const CaseText& all, int component) {
  const FrictionText& text = friction.value;
  if (text.component.given()) return {*text.component.node, text.component.path};
  if (text.potential.given()) return place_in_potential(text.potential, all, component);
  if (text.predefined.given()) return {*text.predefined.node, text.predefined.path};
  return {*friction.node, friction.path};
}

void report(yaml::Binder& binder, const CaseText& text, const cases::Case& problem,
            const law::FrictionRuleViolation& violation) {
  using Rule = law::FrictionRuleViolation::Rule;
  const yaml::At<FrictionText>& friction =
      text.friction.value[static_cast<std::size_t>(violation.definition)];
  const auto name = [](int i) { return "friction[" + std::to_string(i) + "]"; };
  const std::string component = "component " + std::to_string(violation.component + 1);
  const auto [node, path] = place_of(friction, text, violation.component);
  switch (violation.rule) {
    case Rule::kNotAvailable: {
      const law::ConnectionInfo& info = problem.connection.info;
      std::string list;
      for (int c = 0; c < law::kComponents; ++c) {
        if (info.available.contains(c)) list += (list.empty() ? "" : ", ") + std::to_string(c + 1);
      }
      binder.error(node, path,
                   connector_words(problem.connection) +
                       (info.held.contains(violation.component) ? " holds " : " has no ") +
                       component + ": friction acts in free components only" +
                       (list.empty() ? ", and it has none" : " (" + list + ")"));
      break;
    }
    case Rule::kSharedComponent:
      binder.error(node, path,
                   component + " already slips in " + name(violation.other) +
                       ": a free component has one definition at most");
      break;
    case Rule::kTwoPotentials:
      binder.error(
          node, path,
          "a connector has one potential at most, the other is in " + name(violation.other));
      break;
    case Rule::kPredefinedNotAlone:
      binder.error(node, path,
                   "predefined friction must be the only definition, there is also " +
                       name(violation.other));
      break;
  }
}

}  // namespace

bool resolve_friction(yaml::Binder& binder, const CaseText& text, bool derived_known,
                      cases::Case& out) {
  if (text.friction.sound && text.friction.value.empty()) {
    binder.error(*text.friction.node, text.friction.path, "needs at least one definition");
  }
  if (text.friction.value.empty()) return false;
  Resolver resolver(binder, text, derived_known, out);
  std::vector<law::FrictionOutline> outlines;
  for (const yaml::At<FrictionText>& friction : text.friction.value) {
    outlines.push_back(resolver.add(friction, outlines.size()));
  }
  resolver.suit_laws();
  // The rings of a belt slip in one flow.
  if (has_friction_for_each_ring(text, out)) outlines.resize(1);
  const bool rings_known = !text.connector.value.wrap_angle.faulty();
  if (cases::is_belt(out.connection) && outlines.size() > 1 && rings_known) {
    const auto& rings = std::get<law::SlipRing>(*out.connection.type).wrap_angles;
    binder.error(*text.friction.node, text.friction.path,
                 "a belt over " + std::to_string(rings.size()) +
                     (rings.size() == 1 ? " ring" : " rings") + " has one definition" +
                     (rings.size() == 1 ? "" : ", which all rings share, or one for each") +
                     "; found " + std::to_string(outlines.size()),
                 "'wrap_angle' lists the angle of each ring: [= pi/2, = pi/3]");
    return false;
  }
  if (outlines.size() > static_cast<std::size_t>(law::kComponents)) {
    binder.error(*text.friction.node, text.friction.path,
                 "has " + std::to_string(outlines.size()) + " definitions: a connector has " +
                     std::to_string(law::kComponents) +
                     " components, and each takes one definition at most");
    return false;
  }
  bool good = resolver.outlines_known();
  using Rule = law::FrictionRuleViolation::Rule;
  const auto violations = law::check_rules(out.connection.info, outlines);
  for (const law::FrictionRuleViolation& violation : violations) {
    good = false;
    // One fault is one error: of two predefined definitions the second is too many, and that two
    // potentials share components, or two definitions one that is not free, follows from those.
    const auto says_it_all = [&](const law::FrictionRuleViolation& other) {
      return other.definition == violation.definition &&
             ((other.rule == Rule::kTwoPotentials && other.other == violation.other) ||
              (other.rule == Rule::kNotAvailable && other.component == violation.component));
    };
    const bool consequence =
        violation.rule == Rule::kPredefinedNotAlone
            ? violation.other > violation.definition &&
                  outlines[static_cast<std::size_t>(violation.other)].form ==
                      law::FrictionForm::kPredefined
            : violation.rule == Rule::kSharedComponent &&
                  std::any_of(violations.begin(), violations.end(), says_it_all);
    if (!consequence) report(binder, text, out, violation);
  }
  return name_definitions(binder, text, out) && good && resolver.columns_known();
}

}  // namespace slipbench::driver::read
