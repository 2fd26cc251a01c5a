// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "driver/case/case_codecs.hpp"
#include "driver/case/resolve.hpp"
#include "driver/text/format_number.hpp"

namespace slipbench::driver {
namespace {

using law::ComponentSet;

constexpr double kDefaultSlipTolerance = 1.0e-4;  // the connector default of section 9

/// A contact force comes from constraint forces: those are prescribed.
bool usable_force(Binder& binder, const law::Connection& connection, int component, const Node& at,
                  const Path& path) {
  if (connection.info.held.contains(component)) return true;
  const std::string number = std::to_string(component + 1);
  const std::string what = connection.info.available.contains(component)
                               ? "component " + number + " of " + connector_words(connection) +
                                     " is free: a contact force comes from the constraint forces"
                               : connector_words(connection) + " has no component " + number;
  binder.error(at, path, what + " (" + force_names(connection.info.held) + ")");
  return false;
}

std::optional<law::DerivedTerm> derived_term(Binder& binder, const law::Connection& connection,
                                             const DerivedTermText& text, const Path& path) {
  law::DerivedTerm term;
  term.combine = text.combine.value;
  bool good = true;
  if (text.sign.value == 0) {
    binder.error(*text.sign.node, text.sign.path, "the sign of a term is 1 or -1");
    good = false;
  }
  term.sign = text.sign.value;
  ComponentSet seen;
  for (const At<int>& component : text.components) {
    const int c = component.value - 1;
    if (seen.contains(c)) {
      binder.error(*component.node, component.path,
                   "component " + std::to_string(c + 1) + " stands twice in this term");
      good = false;
      continue;
    }
    seen.insert(c);
    good = usable_force(binder, connection, c, *component.node, component.path) && good;
    term.component[static_cast<std::size_t>(term.count)] = c;
    term.weight[static_cast<std::size_t>(term.count)] = 1.0;
    ++term.count;
  }
  if (term.count == 0) good = false;
  if (text.weights.given()) {
    if (const auto* numbers = std::get_if<std::vector<double>>(&text.weights.value)) {
      if (static_cast<int>(numbers->size()) != static_cast<int>(text.components.size())) {
        binder.error(*text.weights.node, text.weights.path,
                     "wanted one weight for each of the " + std::to_string(text.components.size()) +
                         " components, found " + std::to_string(numbers->size()));
        good = false;
      } else if (good) {
        std::copy(numbers->begin(), numbers->end(), term.weight.begin());
      }
    } else {
      auto weights =
          table_function(binder, std::get<TableText>(text.weights.value), *text.weights.node,
                         text.weights.path, kWeightTable, static_cast<int>(text.components.size()));
      if (!weights) return std::nullopt;
      term.weight_table = std::move(*weights);
    }
  }
  if (!good) return std::nullopt;
  static_cast<void>(path);
  return term;
}

struct DerivedComponents {
  std::vector<std::pair<std::string, law::DerivedComponent>> sound;
  std::vector<std::string> names;  ///< of all, so that a faulty one is not reported as unknown
};

DerivedComponents derived_components(Binder& binder, const CaseText& text, const Case& problem) {
  DerivedComponents result;
  for (const auto& named : text.derived_components) {
    result.names.push_back(named.name);
    law::DerivedComponent component;
    bool norms = false, sums = false, negative = false, others = false;
    for (std::size_t i = 0; i < named.value.size(); ++i) {
      auto term = derived_term(binder, problem.connection, named.value[i], named.path / i);
      if (!term) continue;
      norms = norms || term->combine == law::TermOperator::kNorm;
      sums = sums || term->combine == law::TermOperator::kSum;
      others = others || term->combine != law::TermOperator::kNorm;
      negative = negative || term->sign < 0.0;
      component.push_back(std::move(*term));
    }
    // The rules of specification section 5 on contact forces.
    if (norms && sums) {
      binder.error(*named.key, named.path,
                   "norm and sum terms do not mix in one contact force (macauley_sum and norm do)");
    }
    if (norms && !others && negative) {
      binder.error(*named.key, named.path, "a contact force of norms only needs sign 1 throughout");
    }
    if (named.value.empty()) {
      binder.error(*named.key, named.path, "a derived component needs at least one term");
    }
    if (component.size() == named.value.size() && !component.empty()) {
      result.sound.emplace_back(named.name, std::move(component));
    }
  }
  return result;
}

law::StickStiffness stick_stiffness(Binder& binder, const FrictionText& text, const Node& friction,
                                    const Path& path, const Case& problem) {
  const StickText& stick = text.stick.value;
  const int ways = (stick.slip_tolerance.given() || stick.characteristic_length.given() ? 1 : 0) +
                   (stick.elastic_slip.given() ? 1 : 0) + (stick.stiffness.given() ? 1 : 0);
  if (ways > 1) {
    binder.error(*text.stick.node, text.stick.path,
                 "give one of {slip_tolerance, characteristic_length}, {elastic_slip} and "
                 "{stiffness}");
  }
  using Mode = law::StickStiffness::Mode;
  if (stick.stiffness.given()) return {Mode::kStiffness, stick.stiffness.value};
  if (stick.elastic_slip.given()) return {Mode::kElasticSlip, stick.elastic_slip.value};
  const double tolerance =
      stick.slip_tolerance.given() ? stick.slip_tolerance.value : kDefaultSlipTolerance;
  double length = 1.0;
  if (stick.characteristic_length.given()) {
    length = stick.characteristic_length.value;
  } else {
    const std::string unit = problem.units.length.empty() ? "" : " " + problem.units.length;
    binder.note(text.stick.given() ? *text.stick.node : friction,
                text.stick.given() ? text.stick.path : path,
                "characteristic length not given, 1" + unit +
                    " (1 rad in rotation) used for the stick stiffness: elastic slip " +
                    format_number(tolerance));
  }
  return {Mode::kElasticSlip, tolerance * length};
}

std::optional<law::FrictionLaw> coefficient(Binder& binder, const FrictionText& text,
                                            const Node& friction, const Path& path) {
  if (!text.coefficient.given()) {
    binder.warning(friction, path, "no coefficient: this definition has no effect");
    return law::FrictionLaw(law::ConstantCoefficient{0.0});
  }
  if (const auto* table_text = std::get_if<TableText>(&text.coefficient.value.value)) {
    auto function = table_function(binder, *table_text, *text.coefficient.node,
                                   text.coefficient.path, kCoefficientTable);
    if (!function) return std::nullopt;
    return law::FrictionLaw(law::TabularCoefficient{std::move(*function)});
  }
  return std::get<law::FrictionLaw>(text.coefficient.value.value);
}

/// A falling internal contact force whose fall is steeper than the stick stiffness snaps back: the
/// force drops at constant motion, and no increment can follow it (reference case W1, beta >= 1).
void check_snap_back(Binder& binder, const law::FrictionDefinition& d, const Node& node,
                     const Path& path) {
  const auto* table = std::get_if<law::TableFunction>(&d.internal_contact_force);
  if (table == nullptr || d.stick.mode != law::StickStiffness::Mode::kStiffness) return;
  const int column = table->column_of(law::IndependentKind::kAccumulatedSlip);
  if (column < 0) return;
  const double fall = -table->table().steepest_fall(column);
  const double beta = law::largest(d.law) * fall / d.stick.value;
  if (beta >= 1.0) {
    binder.error(
        node, path,
        "wear falls faster than the stick stiffness can follow (snap-back): mu |F'| / k = " +
            format_number(law::largest(d.law)) + " * " + format_number(fall) + " / " +
            format_number(d.stick.value) + " = " + format_number(beta) + ", it must be below 1",
        "raise stick.stiffness or flatten the table");
  }
}

/// One entry of `friction:` with what its definitions share.
class Resolver {
 public:
  Resolver(Binder& binder, const CaseText& text, Case& out)
      : binder_(binder), text_(text), out_(out), derived_(derived_components(binder, text, out)) {}

  law::FrictionOutline add(const At<FrictionText>& friction) {
    const FrictionText& text = friction.value;
    const Node& node = *friction.node;
    const Path& path = friction.path;
    const int forms = (text.predefined.given() ? 1 : 0) + (text.component.given() ? 1 : 0) +
                      (text.potential.given() ? 1 : 0);
    if (forms != 1) {
      binder_.error(node, path,
                    std::string(forms == 0 ? "needs" : "takes only") +
                        " one of 'predefined', 'component' and 'potential'");
    }
    law::FrictionDefinition shared;
    if (auto law = coefficient(binder_, text, node, path)) shared.law = std::move(*law);
    shared.stick = stick_stiffness(binder_, text, node, path, out_);
    shared.accumulated_slip = text_.integration.accumulated_slip;
    shared.slip_rate = text_.integration.slip_rate;
    if (text.force_limit.given() && text.force_limit.value > 0.0) {
      shared.force_limit = text.force_limit.value;
      if (std::holds_alternative<law::ExponentialDecay>(shared.law)) {
        binder_.error(*text.force_limit.node, text.force_limit.path,
                      "exponential decay takes no force limit");
      }
    }
    law::FrictionOutline outline;
    if (text.predefined.given()) {
      outline.form = law::FrictionForm::kPredefined;
      predefined(friction, shared, outline);
    } else if (text.potential.given()) {
      outline.form = law::FrictionForm::kPotential;
      shared.slip = potential(text.potential.value, outline);
      user_defined(friction, shared, true);
    } else if (text.component.given()) {
      shared.slip = law::slip_space({text.component.value});
      outline.components.insert(text.component.value - 1);
      user_defined(friction, shared, false);
    }
    return outline;
  }

 private:
  void predefined(const At<FrictionText>& friction, const law::FrictionDefinition& shared,
                  law::FrictionOutline& outline) {
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
    const Node& map = *text.predefined.value.node;
    bool found = false;
    if (out_.connection.type) {
      std::visit(
          [&]<class Type>(const Type& type) {
            if constexpr (law::HasPredefinedFriction<Type>) {
              found = true;
              Type geometry = type;
              if (!read_struct(binder_, map, text.predefined.path, geometry)) return;
              note_dropped_terms(map, text.predefined.path, geometry);
              for (law::PredefinedFriction& check : geometry.predefined()) {
                law::FrictionDefinition d = shared;
                d.slip = check.slip;
                d.contact_force = std::move(check.contact_force);
                d.internal_contact_force = std::move(check.internal_contact_force);
                for (int i = 0; i < d.slip.dimension; ++i) {
                  outline.components.insert(d.slip.component[static_cast<std::size_t>(i)]);
                }
                check_snap_back(binder_, d, map, text.predefined.path);
                std::string name = text.name.value;
                if (!check.suffix.empty()) {
                  name = (name.empty() ? "" : name + ".") + std::string(check.suffix);
                }
                out_.definitions.push_back({std::move(name), d.slip.dimension > 1, std::move(d)});
              }
            }
          },
          *out_.connection.type);
    }
    if (!found) {
      std::vector<std::string_view> with;
      law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
        if constexpr (law::HasPredefinedFriction<Type>) with.push_back(Type::kInfo.name);
      });
      binder_.error(
          map, text.predefined.path,
          connector_words(out_.connection) + " has no predefined friction",
          "those that have: " + in_words(with, "and") + "; here give 'component' or 'potential'");
    }
  }

  /// A zero length silently drops its term of the contact force: worth a note if it was written.
  template <class Type>
  void note_dropped_terms(const Node& map, const Path& path, const Type& geometry) {
    for_each_key<Type>([&](std::string_view key, auto member, const KeyInfo&) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(geometry.*member)>, double>) {
        const auto value = map.find(key);
        if (value && geometry.*member == 0.0) {
          binder_.note(*value, path / key, "0 drops the term of the contact force it belongs to");
        }
      }
    });
  }

  law::SlipSpace potential(const PotentialText& text, law::FrictionOutline& outline) {
    law::SlipSpace space;
    space.dimension = 0;
    if (text.terms.value.empty()) {
      binder_.error(*text.terms.node, text.terms.path, "a potential needs at least one term");
      space.dimension = 1;
    }
    for (const PotentialTermText& term : text.terms.value) {
      const int c = term.component.value - 1;
      if (outline.components.contains(c)) {
        binder_.error(*term.component.node, term.component.path,
                      "component " + std::to_string(c + 1) + " stands twice in the potential");
        continue;
      }
      outline.components.insert(c);
      const auto i = static_cast<std::size_t>(space.dimension++);
      space.component[i] = c;
      space.scale[i] = term.scale;
    }
    return space;
  }

  void user_defined(const At<FrictionText>& friction, law::FrictionDefinition d, bool coupled) {
    const FrictionText& text = friction.value;
    bool good = true;
    if (!text.contact_force.given() && !text.internal_contact_force.given()) {
      binder_.error(*friction.node, friction.path,
                    "neither 'contact_force' nor 'internal_contact_force': nothing presses");
      good = false;
    }
    if (text.contact_force.given()) good = contact_force(text.contact_force, d) && good;
    if (text.internal_contact_force.given()) {
      if (const auto* t = std::get_if<TableText>(&text.internal_contact_force.value)) {
        auto function = table_function(binder_, *t, *text.internal_contact_force.node,
                                       text.internal_contact_force.path, kInternalForceTable);
        if (function) {
          d.internal_contact_force = std::move(*function);
          check_snap_back(binder_, d, *text.internal_contact_force.node,
                          text.internal_contact_force.path);
        } else {
          good = false;
        }
      } else {
        d.internal_contact_force = std::get<double>(text.internal_contact_force.value);
      }
    }
    static_cast<void>(good);
    out_.definitions.push_back({text.name.value, coupled, std::move(d)});
  }

  bool contact_force(const At<ContactForceText>& contact, law::FrictionDefinition& d) {
    if (const int* number = std::get_if<int>(&contact.value.value)) {
      d.contact_force = law::ComponentContactForce{*number - 1};
      return usable_force(binder_, out_.connection, *number - 1, *contact.node, contact.path);
    }
    const auto& name = std::get<std::string>(contact.value.value);
    for (const auto& [known, component] : derived_.sound) {
      if (known == name) {
        d.contact_force = component;
        return true;
      }
    }
    if (std::find(derived_.names.begin(), derived_.names.end(), name) != derived_.names.end()) {
      return false;  // its own fault is reported where it stands
    }
    const std::vector<std::string_view> names(derived_.names.begin(), derived_.names.end());
    std::string hint = names.empty() ? "define it under 'derived_components:'"
                                     : "known: " + in_words(names, "and");
    if (const auto nearest = nearest_name(name, names)) {
      hint = "did you mean '" + std::string(*nearest) + "'?";
    }
    binder_.error(*contact.node, contact.path,
                  "unknown derived component '" + printable(name) + "'", std::move(hint));
    return false;
  }

  Binder& binder_;
  const CaseText& text_;
  Case& out_;
  DerivedComponents derived_;
};

/// Definitions need different names, and names that can stand in a column.
void name_definitions(Binder& binder, const CaseText& text, Case& out) {
  for (std::size_t i = 0; i < text.friction.value.size(); ++i) {
    const At<std::string>& name = text.friction.value[i].value.name;
    if (!name.given()) continue;
    if (!is_identifier(name.value)) {
      binder.error(*name.node, name.path,
                   "a name is a letter, then letters, digits and '_', found '" +
                       printable(name.value) + "'");
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (text.friction.value[j].value.name.value == name.value) {
        binder.error(
            *name.node, name.path,
            "the name '" + name.value + "' is already that of friction[" + std::to_string(j) + "]");
      }
    }
  }
  for (std::size_t i = 0; i < out.definitions.size(); ++i) {
    if (out.definitions[i].name.empty()) {
      out.definitions[i].name = "friction" + std::to_string(i + 1);
    }
  }
}

void report(Binder& binder, const CaseText& text, const Case& problem,
            const law::FrictionRuleViolation& violation) {
  using Rule = law::FrictionRuleViolation::Rule;
  const At<FrictionText>& friction =
      text.friction.value[static_cast<std::size_t>(violation.definition)];
  const auto name = [](int i) { return "friction[" + std::to_string(i) + "]"; };
  const std::string component = "component " + std::to_string(violation.component + 1);
  const FrictionText& f = friction.value;
  const Node& node = f.component.given()    ? *f.component.node
                     : f.potential.given()  ? *f.potential.node
                     : f.predefined.given() ? *f.predefined.node
                                            : *friction.node;
  switch (violation.rule) {
    case Rule::kNotAvailable: {
      const law::ConnectionInfo& info = problem.connection.info;
      std::string list;
      for (int c = 0; c < law::kComponents; ++c) {
        if (info.available.contains(c)) list += (list.empty() ? "" : ", ") + std::to_string(c + 1);
      }
      binder.error(node, friction.path,
                   connector_words(problem.connection) +
                       (info.held.contains(violation.component) ? " holds " : " has no ") +
                       component + ": friction acts in free components only" +
                       (list.empty() ? ", and it has none" : " (" + list + ")"));
      break;
    }
    case Rule::kSharedComponent:
      binder.error(node, friction.path,
                   component + " already slips in " + name(violation.other) +
                       ": a free component has one definition at most");
      break;
    case Rule::kTwoPotentials:
      binder.error(
          node, friction.path,
          "a connector has one potential at most, the other is in " + name(violation.other));
      break;
    case Rule::kPredefinedNotAlone:
      binder.error(node, friction.path,
                   "predefined friction must be the only definition, there is also " +
                       name(violation.other));
      break;
  }
}

}  // namespace

void resolve_friction(Binder& binder, const CaseText& text, Case& out) {
  if (text.friction.value.empty()) {
    binder.error(*text.friction.node, text.friction.path, "needs at least one definition");
    return;
  }
  Resolver resolver(binder, text, out);
  std::vector<law::FrictionOutline> outlines;
  for (const At<FrictionText>& friction : text.friction.value) {
    outlines.push_back(resolver.add(friction));
  }
  for (const law::FrictionRuleViolation& violation :
       law::check_rules(out.connection.info, outlines)) {
    report(binder, text, out, violation);
  }
  name_definitions(binder, text, out);
}

}  // namespace slipbench::driver
