// SPDX-License-Identifier: Apache-2.0
#include "law/definition/packed_definition.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "law/base/unit_name.hpp"
#include "law/definition/admissible_definition.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::law {
namespace {

/// Of the order of the numbers; to be raised whenever an exchange() below changes.
constexpr double kVersion = 1.0;

/// Order of the numbers, written once for both ways: every exchange() below goes through an object
/// and hands its numbers to one of these.
class Writer {
 public:
  static constexpr bool kReads = false;
  void number(double& x) { numbers.push_back(x); }
  template <class Integer>
  void integer(Integer& x, int /*lowest*/, int /*highest*/) {
    numbers.push_back(static_cast<double>(x));
  }
  std::vector<double> numbers;
};

class Reader {
 public:
  static constexpr bool kReads = true;
  explicit Reader(std::span<const double> numbers) : rest(numbers) {}

  void number(double& x) {
    x = next();
    if (std::isnan(x)) good = false;
  }
  /// Leaves the lowest in place of a number that is none of them, so that it can be used as an
  /// index.
  template <class Integer>
  void integer(Integer& x, int lowest, int highest) {
    const double read = next();
    const bool fits = read >= lowest && read <= highest && read == std::floor(read);
    if (!fits) good = false;
    x = static_cast<Integer>(fits ? static_cast<int>(read) : lowest);
  }

  std::span<const double> rest;
  bool good = true;

 private:
  double next() {
    if (rest.empty()) {
      good = false;
      return 0.0;
    }
    const double x = rest.front();
    rest = rest.subspan(1);
    return x;
  }
};

/// The most entries of anything: a number each, so that damaged numbers ask for no memory.
int most_entries(const Reader& reader) {
  return static_cast<int>(std::min<std::size_t>(reader.rest.size(), 1U << 24U));
}
int most_entries(const Writer& /*writer*/) { return 0; }

void exchange(auto& archive, double& x) { archive.number(x); }
void exchange(auto& archive, int& component) { archive.integer(component, 0, kComponents - 1); }
void exchange(auto& archive, bool& x) { archive.integer(x, 0, 1); }

template <class Entry>
void exchange(auto& archive, std::array<Entry, kComponents>& entries) {
  for (Entry& entry : entries) exchange(archive, entry);
}

void exchange(auto& archive, TableFunction& function) {
  int dependents = function.table().dependents();
  int independents = static_cast<int>(function.independents().size());
  int rows = static_cast<int>(function.table().rows());
  Extrapolation extrapolation = function.table().extrapolation();
  archive.integer(dependents, 1, kComponents);
  archive.integer(independents, 1, kMaxIndependents);
  archive.integer(rows, 1, most_entries(archive));
  const int width = dependents + independents;
  archive.integer(extrapolation, 0, static_cast<int>(Extrapolation::kLinear));
  std::vector<Independent> columns(function.independents().begin(), function.independents().end());
  columns.resize(static_cast<std::size_t>(independents));
  for (Independent& column : columns) {
    archive.integer(column.kind, 0, static_cast<int>(IndependentKind::kConstitutiveMotion));
    const bool is_field = column.kind == IndependentKind::kField;
    archive.integer(column.index, 0, (is_field ? kMaxFields : kComponents) - 1);
  }
  if constexpr (std::remove_reference_t<decltype(archive)>::kReads) {
    // As many numbers as are there, so that damaged counts ask for no memory.
    const auto wanted = static_cast<std::size_t>(rows) * static_cast<std::size_t>(width);
    archive.good = archive.good && wanted <= archive.rest.size();
    if (!archive.good) return;
  }
  std::vector<std::vector<double>> table(static_cast<std::size_t>(rows));
  for (std::size_t r = 0; r < table.size(); ++r) {
    std::vector<double>& row = table[r];
    if constexpr (!std::remove_reference_t<decltype(archive)>::kReads) {
      for (int k = 0; k < dependents; ++k) row.push_back(function.table().ordinate(r, k));
      const std::vector<double> point = function.table().point(r);
      row.insert(row.end(), point.begin(), point.end());
    }
    row.resize(static_cast<std::size_t>(width));
    for (double& x : row) archive.number(x);
  }
  if constexpr (std::remove_reference_t<decltype(archive)>::kReads) {
    Table built;
    TableError error;
    if (!archive.good) return;
    archive.good = Table::build(table, dependents, independents, extrapolation, &built, &error);
    if (archive.good) function = TableFunction(std::move(built), std::move(columns));
  }
}

template <class Content>
void exchange(auto& archive, std::optional<Content>& content) {
  bool there = content.has_value();
  exchange(archive, there);
  if (there && !content) content.emplace();
  if (there) exchange(archive, *content);
}

/// Puts the alternative with that index in place, as it is made without numbers.
template <class Variant>
void choose(Variant& variant, std::size_t index) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    ((index == I ? static_cast<void>(variant.template emplace<I>()) : static_cast<void>(0)), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>{});
}

template <class... Alternative>
void exchange(auto& archive, std::variant<Alternative...>& variant) {
  std::size_t index = variant.index();
  archive.integer(index, 0, static_cast<int>(sizeof...(Alternative)) - 1);
  if (index != variant.index()) choose(variant, index);
  std::visit([&](auto& content) { exchange(archive, content); }, variant);
}

void exchange(auto& archive, SlipSpace& space) {
  archive.integer(space.dimension, 1, kComponents);
  exchange(archive, space.component);
  exchange(archive, space.scale);
}

void exchange(auto& /*archive*/, EuclideanPotential& /*criterion*/) {}
void exchange(auto& archive, Capstan& belt) { exchange(archive, belt.wrap_angle); }
void exchange(auto& archive, PotentialLeaf& leaf) {
  archive.integer(leaf.kind, 0, static_cast<int>(PotentialLeaf::Kind::kHalfLine));
  exchange(archive, leaf.part);
  exchange(archive, leaf.direction);
  exchange(archive, leaf.factor);
  exchange(archive, leaf.center);
}
void exchange(auto& archive, Potential& potential) {
  archive.integer(potential.combine, 0, static_cast<int>(PotentialOperator::kMax));
  exchange(archive, potential.exponent);
  archive.integer(potential.parts, 1, kComponents);
  exchange(archive, potential.offset);
  archive.integer(potential.leaves, 1, kComponents);
  exchange(archive, potential.leaf);
  exchange(archive, potential.homogeneous);
}

void exchange(auto& /*archive*/, NoContactForce& /*contact*/) {}
void exchange(auto& archive, ComponentContactForce& contact) {
  exchange(archive, contact.component);
}
void exchange(auto& archive, DerivedTerm& term) {
  archive.integer(term.combine, 0, static_cast<int>(TermOperator::kMacauleySum));
  exchange(archive, term.sign);
  archive.integer(term.count, 0, kComponents);
  exchange(archive, term.component);
  exchange(archive, term.weight);
  exchange(archive, term.weight_table);
}
void exchange(auto& archive, DerivedComponent& terms) {
  std::size_t count = terms.size();
  archive.integer(count, 0, most_entries(archive));
  terms.resize(count);
  for (DerivedTerm& term : terms) exchange(archive, term);
}
void exchange(auto& archive, UniversalJointContact& contact) {
  archive.integer(contact.axis, 1, 3);
  for (double* x : {&contact.R_p, &contact.R_a, &contact.L_s, &contact.L_a}) archive.number(*x);
  // The shares follow from the arms' slenderness.
  if constexpr (std::remove_reference_t<decltype(archive)>::kReads) {
    contact.shares = hinge_shares(contact.L_a / contact.R_p);
  }
}

template <class Struct, class Member>
void exchange_field(auto& archive, const Field<Struct, Member>& field, Struct& law) {
  Member& member = law.*field.member;
  if constexpr (std::is_enum_v<Member>) {
    archive.integer(member, 0, static_cast<int>(enum_words(Member{}).size()) - 1);
  } else if constexpr (!std::is_same_v<Member, UnitName>) {
    exchange(archive, member);
  }
}

void exchange(auto& archive, TabularCoefficient& law) { exchange(archive, law.table); }
template <class Law>
requires requires { Law::fields(); }
void exchange(auto& archive, Law& law) {
  std::apply([&](const auto&... field) { (exchange_field(archive, field, law), ...); },
             Law::fields());
  if constexpr (requires { law.speed_factor; }) archive.number(law.speed_factor);
  if constexpr (std::remove_reference_t<decltype(archive)>::kReads) {
    const auto in_bounds = [&](const auto& field) {
      const auto& member = law.*field.member;
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, double>) {
        return std::isfinite(member) && field.bounds.contains(member);
      } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>,
                                          std::optional<double>>) {
        return !member || (std::isfinite(*member) && field.bounds.contains(*member));
      } else {
        return true;
      }
    };
    archive.good =
        archive.good &&
        std::apply([&](const auto&... field) { return (in_bounds(field) && ...); }, Law::fields());
    if constexpr (requires { law.violation(); }) archive.good = archive.good && !law.violation();
  }
}
/// Counts a law in the list of laws: how a FrictionLaw keeps it is nothing to the numbers.
void exchange_law(auto& archive, FrictionLaw& law) {
  LawList listed = visit_law([](const auto& one) { return LawList(one); }, std::as_const(law));
  exchange(archive, listed);
  std::visit([&](const auto& one) { law = one; }, listed);
}

void exchange(auto& archive, Orthotropy& orthotropy) {
  exchange_law(archive, orthotropy.second);
  for (double& x : orthotropy.first) archive.number(x);
  archive.integer(orthotropy.speed, 0, static_cast<int>(Orthotropy::Speed::kTotal));
}
void exchange(auto& archive, ViscousPenalty& penalty) {
  exchange(archive, penalty.visf);
  exchange(archive, penalty.stiffness);
  exchange(archive, penalty.mass);
  exchange(archive, penalty.coefficient);
}
void exchange(auto& archive, StiffnessPenalty& penalty) { exchange(archive, penalty.stiffness); }
void exchange(auto& archive, Formulation& formulation) {
  exchange(archive, formulation.penalty);
  archive.integer(formulation.filter.kind, 0, static_cast<int>(Filter::Kind::kFrequency));
  exchange(archive, formulation.filter.value);
  exchange(archive, formulation.filter.clip);
  archive.integer(formulation.convention, 0, static_cast<int>(Convention::kAsCoded));
  exchange(archive, formulation.orthotropy);
}

void exchange(auto& archive, FrictionDefinition& definition) {
  exchange(archive, definition.slip);
  exchange(archive, definition.criterion);
  exchange(archive, definition.contact_force);
  exchange(archive, definition.internal_contact_force);
  exchange_law(archive, definition.law);
  exchange(archive, definition.blend.start);
  exchange(archive, definition.blend.weight);
  exchange(archive, definition.force_limit);
  archive.integer(definition.stick.mode, 0, static_cast<int>(StickStiffness::Mode::kStiffness));
  exchange(archive, definition.stick.value);
  archive.integer(definition.accumulated_slip, 0, static_cast<int>(AccumulatedSlipTiming::kStart));
  archive.integer(definition.slip_rate, 0, static_cast<int>(SlipRateMeasure::kRelativeMotion));
  exchange(archive, definition.formulation);
}

}  // namespace

std::vector<double> pack(const FrictionDefinition& definition) {
  Writer writer;
  FrictionDefinition copy = definition;
  exchange(writer, copy);
  return std::move(writer.numbers);
}

std::optional<FrictionDefinition> unpack(std::span<const double>& numbers) {
  Reader reader(numbers);
  FrictionDefinition definition;
  exchange(reader, definition);
  if (!reader.good || !is_admissible(definition)) return std::nullopt;
  numbers = reader.rest;
  return definition;
}

std::vector<double> pack_all(std::span<const FrictionDefinition> definitions) {
  std::vector<double> numbers{kVersion, static_cast<double>(definitions.size())};
  for (const FrictionDefinition& definition : definitions) {
    const std::vector<double> one = pack(definition);
    numbers.insert(numbers.end(), one.begin(), one.end());
  }
  return numbers;
}

std::optional<std::vector<FrictionDefinition>> unpack_all(std::span<const double> numbers) {
  if (numbers.size() < 2 || numbers[0] != kVersion) return std::nullopt;
  const double count = numbers[1];
  std::vector<FrictionDefinition> definitions;
  for (numbers = numbers.subspan(2); !numbers.empty();) {
    auto definition = unpack(numbers);
    if (!definition) return std::nullopt;
    definitions.push_back(*std::move(definition));
  }
  if (static_cast<double>(definitions.size()) != count) return std::nullopt;
  return definitions;
}

}  // namespace slipbench::law
