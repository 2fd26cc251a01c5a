// SPDX-License-Identifier: Apache-2.0
#include "c/slip_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <new>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "c/handle.hpp"
#include "law/connection/connection_type.hpp"
#include "law/definition/packed_definition.hpp"
#include "law/friction/law_list.hpp"
#include "law/update/connector_tangent.hpp"
#include "law/update/penalty_update.hpp"
#include "law/update/return_mapping.hpp"

namespace {

using namespace slipbench::law;

static_assert(SLIP_COMPONENTS == kComponents && SLIP_FIELDS == kMaxFields);
static_assert(SLIP_STATE_NUMBERS == 2 * kComponents + 3);
static_assert(SLIP_OPEN == static_cast<int>(Regime::kOpen) &&
              SLIP_STICK == static_cast<int>(Regime::kStick) &&
              SLIP_SLIP == static_cast<int>(Regime::kSlip));

/// Formats a sentence in place: nothing is allocated.
template <std::size_t kSize, class... Argument>
void write(char (&text)[kSize], const char* format, Argument... arguments) {
  if constexpr (sizeof...(Argument) == 0) {
    std::snprintf(text, kSize, "%s", format);
  } else {
    std::snprintf(text, kSize, format, arguments...);
  }
}

/// Notes what went wrong, if the caller wants to know.
template <class... Argument>
int fail(slip_error* error, int status, const char* format, Argument... arguments) {
  if (error != nullptr) {
    error->status = status;
    write(error->message, format, arguments...);
  }
  return status;
}

int succeed(slip_error* error) {
  if (error != nullptr) {
    error->status = SLIP_OK;
    error->message[0] = '\0';
  }
  return SLIP_OK;
}

/// Reason why numbers describe no friction; formatted into the caller's memory.
struct Fault {
  char text[sizeof(slip_error::message)] = {};
  template <class... Argument>
  explicit Fault(const char* format, Argument... arguments) {
    write(text, format, arguments...);
  }
};

/// Length of a text for "%.*s".
int size_of(std::string_view text) { return static_cast<int>(text.size()); }

/// Sets one member from its number. Members that are more than a number are those of a YAML text.
template <class Member>
bool set_number(Member& member, double value) {
  if constexpr (std::is_enum_v<Member>) {
    const auto count = static_cast<double>(enum_words(Member{}).size());
    if (!(value >= 0.0 && value < count && value == std::floor(value))) return false;
    member = static_cast<Member>(static_cast<int>(value));
    return true;
  } else if constexpr (std::is_assignable_v<Member&, double>) {
    member = value;
    return true;
  } else {
    return false;
  }
}

/// Sets the numbers of anything that declares its fields: a law, a connection type.
template <class Struct>
void set_numbers(Struct& object, std::string_view name, std::span<const slip_number> numbers) {
  constexpr auto kFields = Struct::fields();
  constexpr std::size_t kCount = std::tuple_size_v<decltype(kFields)>;
  std::array<bool, std::max<std::size_t>(kCount, 1)> given{};
  for (const slip_number& number : numbers) {
    const std::string_view key = number.key == nullptr ? "" : number.key;
    bool found = false;
    std::size_t index = 0;
    const auto take = [&](const auto& field) {
      const std::size_t here = index++;
      if (field.key != key) return;
      found = true;
      if (given[here])
        throw Fault("%.*s: '%s' is given twice", size_of(name), name.data(), number.key);
      given[here] = true;
      if (!std::isfinite(number.value) || !field.bounds.contains(number.value) ||
          !set_number(object.*field.member, number.value)) {
        throw Fault("%.*s: '%s' cannot be %.17g", size_of(name), name.data(), number.key,
                    number.value);
      }
    };
    std::apply([&](const auto&... field) { (take(field), ...); }, kFields);
    if (!found) {
      throw Fault("%.*s has no number '%.*s'", size_of(name), name.data(), size_of(key),
                  key.data());
    }
  }
  std::size_t index = 0;
  const auto look = [&](const auto& field) {
    if (!given[index++] && field.required) {
      throw Fault("%.*s: '%.*s' is missing", size_of(name), name.data(), size_of(field.key),
                  field.key.data());
    }
  };
  std::apply([&](const auto&... field) { (look(field), ...); }, kFields);
  if constexpr (requires { object.violation(); }) {
    if (const auto rule = object.violation()) {
      throw Fault("%.*s: %.*s", size_of(name), name.data(), size_of(*rule), rule->data());
    }
  }
}

std::span<const slip_number> numbers_of(const slip_number* numbers, std::size_t count) {
  return {numbers, numbers == nullptr ? 0 : count};
}

FrictionLaw law_of(const slip_definition& from) {
  const std::string_view wanted = from.law == nullptr ? "" : from.law;
  std::optional<FrictionLaw> made;
  const auto attempt = [&]<class Law>(std::type_identity<Law>) {
    if constexpr (requires { Law::fields(); }) {
      if (Law::kName != wanted) return;
      Law law{};
      set_numbers(law, Law::kName, numbers_of(from.numbers, from.number_count));
      made = law;
    }
  };
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    (attempt(std::type_identity<Law>{}), ...);
  }(std::type_identity<LawList>{});
  if (!made) throw Fault("'%.*s' is no law of numbers", size_of(wanted), wanted.data());
  return *made;
}

/// The part of a definition that its kind of friction decides.
void add_predefined(const slip_definition& from, const FrictionDefinition& shared,
                    std::vector<FrictionDefinition>& to) {
  const std::string_view wanted = from.connection;
  bool found = false;
  for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if constexpr (HasPredefinedFriction<Type>) {
      if (Type::kInfo.name != wanted) return;
      found = true;
      Type type{};
      set_numbers(type, Type::kInfo.name, numbers_of(from.geometry, from.geometry_count));
      for (PredefinedFriction& check : type.predefined()) {
        if (std::holds_alternative<Capstan>(check.criterion)) {
          throw Fault("%s: the friction of a belt wants its tension and its strain",
                      from.connection);
        }
        FrictionDefinition definition = shared;
        definition.slip = check.slip;
        definition.criterion = check.criterion;
        definition.contact_force = std::move(check.contact_force);
        definition.internal_contact_force = std::move(check.internal_contact_force);
        to.push_back(std::move(definition));
      }
    }
  });
  if (!found) throw Fault("'%s' is no connection type with predefined friction", from.connection);
}

void add_user_defined(const slip_definition& from, FrictionDefinition definition,
                      std::vector<FrictionDefinition>& to) {
  SlipSpace& slip = definition.slip;
  slip.dimension = 0;
  DerivedTerm pressing;
  for (int c = 0; c < kComponents; ++c) {
    const double scale = from.slip_scale[c];
    const double weight = from.contact_weight[c];
    if (!(scale >= 0.0 && std::isfinite(scale)))
      throw Fault("slip_scale[%d] must be finite and not negative", c);
    if (!std::isfinite(weight)) throw Fault("contact_weight[%d] must be finite", c);
    if (scale > 0.0) {
      const auto i = static_cast<std::size_t>(slip.dimension++);
      slip.component[i] = c;
      slip.scale[i] = scale;
    }
    if (weight != 0.0) {
      const auto i = static_cast<std::size_t>(pressing.count++);
      pressing.component[i] = c;
      pressing.weight[i] = weight;
    }
  }
  if (slip.dimension == 0) throw Fault("no component slips: slip_scale is 0 throughout");
  if (pressing.count > 0) definition.contact_force = DerivedComponent{pressing};
  if (!(from.internal_contact_force >= 0.0 && std::isfinite(from.internal_contact_force))) {
    throw Fault("internal_contact_force must be finite and not negative");
  }
  definition.internal_contact_force = from.internal_contact_force;
  to.push_back(std::move(definition));
}

void add(const slip_definition& from, std::vector<FrictionDefinition>& to) {
  if (from.size != sizeof(slip_definition)) {
    throw Fault(
        "size is %zu, this library has definitions of %zu bytes: set it to "
        "sizeof(slip_definition), or "
        "compile with this library's header",
        from.size, sizeof(slip_definition));
  }
  FrictionDefinition shared;
  shared.law = law_of(from);
  const bool by_slip = from.elastic_slip > 0.0;
  const double stick = by_slip ? from.elastic_slip : from.stick_stiffness;
  if (by_slip == (from.stick_stiffness > 0.0) || !std::isfinite(stick)) {
    throw Fault("exactly one of elastic_slip and stick_stiffness must be above 0");
  }
  shared.stick = {by_slip ? StickStiffness::Mode::kElasticSlip : StickStiffness::Mode::kStiffness,
                  stick};
  if (!(from.force_limit >= 0.0)) throw Fault("force_limit must not be negative");
  if (from.force_limit > 0.0) shared.force_limit = from.force_limit;
  if (from.connection != nullptr) {
    add_predefined(from, shared, to);
  } else {
    add_user_defined(from, std::move(shared), to);
  }
}

/// Runs `make`, which returns definitions, and keeps every exception on this side.
template <class Make>
slip_law* made(slip_error* error, Make make) {
  try {
    slip_law* const law = new slip_law{make()};
    succeed(error);
    return law;
  } catch (const Fault& fault) {
    fail(error, SLIP_BAD_DEFINITION, fault.text);
  } catch (const std::bad_alloc&) {
    fail(error, SLIP_NO_MEMORY, "no memory is left");
  } catch (...) {
    fail(error, SLIP_BAD_DEFINITION, "the definitions cannot be held");
  }
  return nullptr;
}

/// Places in the numbers of a state.
constexpr std::size_t kForceAt = kComponents;
constexpr std::size_t kAccumulatedAt = 2 * std::size_t{kComponents};
constexpr std::size_t kLeftOutAt = kAccumulatedAt + 1;
constexpr std::size_t kRegimeAt = kLeftOutAt + 1;

FrictionState state_of(const double* numbers) {
  FrictionState state;
  std::copy_n(numbers, kComponents, state.elastic_slip.begin());
  std::copy_n(numbers + kForceAt, kComponents, state.force.begin());
  state.accumulated_slip = {numbers[kAccumulatedAt], numbers[kLeftOutAt]};
  // A number that is no regime is one of a state that nobody made: it is at rest.
  const double regime = numbers[kRegimeAt];
  for (const Regime one : {Regime::kOpen, Regime::kSlip}) {
    if (regime == static_cast<double>(one)) state.regime = one;
  }
  return state;
}

void put_state(const FrictionState& state, double* numbers) {
  std::copy_n(state.elastic_slip.begin(), kComponents, numbers);
  std::copy_n(state.force.begin(), kComponents, numbers + kForceAt);
  numbers[kAccumulatedAt] = state.accumulated_slip;
  numbers[kLeftOutAt] = state.accumulated_slip.left_out();
  numbers[kRegimeAt] = static_cast<double>(state.regime);
}

/// Temperature and fields, as many as a table can name.
class Surroundings {
 public:
  Surroundings(double temperature, const double* fields, std::size_t count) {
    std::copy_n(fields, fields == nullptr ? 0 : std::min<std::size_t>(count, kMaxFields),
                fields_.begin());
    ambient_.temperature = temperature;
  }
  /// Only of an object that stays where it is.
  Ambient ambient() const {
    Ambient here = ambient_;
    here.fields = fields_;
    return here;
  }

 private:
  std::array<double, kMaxFields> fields_{};
  Ambient ambient_;
};

using Slopes = Eigen::Matrix<double, kComponents, kComponents>;

void put_matrix(const Slopes& matrix, double* to) {
  if (to == nullptr) return;
  for (int i = 0; i < kComponents; ++i) {
    for (int j = 0; j < kComponents; ++j) to[kComponents * i + j] = matrix(i, j);
  }
}

/// Tells whether a number can be an amount of something that has no sign.
bool is_amount(double x) { return x >= 0.0 && std::isfinite(x); }

int updated(const slip_law* law, const slip_increment* from, const double* old_state,
            double* new_state, double* force, slip_result* results, bool tangent, double* to_motion,
            double* to_force, slip_error* error) {
  if (law == nullptr || from == nullptr || old_state == nullptr || new_state == nullptr) {
    return fail(error, SLIP_BAD_ARGUMENT, "law, increment, old_state and new_state must be there");
  }
  if (!is_amount(from->duration)) {
    return fail(error, SLIP_BAD_ARGUMENT, "the duration is %g: wanted 0 or more, and finite",
                from->duration);
  }
  const Surroundings around(from->temperature, from->fields, from->field_count);
  ConnectorIncrement increment;
  increment.duration = from->duration;
  increment.end = around.ambient();
  for (int c = 0; c < kComponents; ++c) {
    increment.begin_position[c] = from->begin[c];
    increment.end.position[c] = from->end[c];
    increment.end.motion[c] = from->end[c] - from->reference[c];
    increment.force[c] = from->force[c];
  }
  const std::size_t count = law->definitions.size();
  // Made one by one: an update is some 400 bytes, and most connectors have one.
  alignas(FrictionUpdate) std::array<std::byte, SLIP_DEFINITIONS * sizeof(FrictionUpdate)> storage;
  auto* const updates = reinterpret_cast<FrictionUpdate*>(storage.data());
  ConnectorForce sum;
  for (std::size_t d = 0; d < count; ++d) {
    const FrictionDefinition& definition = law->definitions[d];
    const FrictionState old = state_of(old_state + d * SLIP_STATE_NUMBERS);
    new (updates + d)
        FrictionUpdate(definition.formulation ? update_penalty(definition, increment, old)
                                              : update(definition, increment, old));
    if (!all_finite(updates[d])) {
      return fail(error, SLIP_NOT_FINITE,
                  "the update of definition %zu is not finite: look at its increment and "
                  "its forces",
                  d);
    }
    if (!updates[d].converged) {
      return fail(error, SLIP_NO_SOLUTION,
                  "definition %zu: the return to the limit surface found no solution", d);
    }
    const ConnectorForce one = friction_force(definition, updates[d].state);
    for (int c = 0; c < kComponents; ++c) sum[c] += one[c];
  }
  if (tangent) {
    Slopes motion_slopes = Slopes::Zero(), force_slopes = Slopes::Zero();
    for (std::size_t d = 0; d < count; ++d) {
      const ConnectorTangent slopes = connector_tangent(law->definitions[d], increment, updates[d]);
      motion_slopes += slopes.to_motion;
      force_slopes += slopes.to_force;
      if (!motion_slopes.allFinite() || !force_slopes.allFinite()) {
        return fail(error, SLIP_NOT_FINITE,
                    "the tangent of definition %zu is not finite: look at its increment and its "
                    "forces",
                    d);
      }
    }
    put_matrix(motion_slopes, to_motion);
    put_matrix(force_slopes, to_force);
  }
  for (std::size_t d = 0; d < count; ++d) {
    const FrictionUpdate& one = updates[d];
    put_state(one.state, new_state + d * SLIP_STATE_NUMBERS);
    if (results != nullptr) {
      results[d] = {one.limit,          one.normal_force, one.mu,
                    one.slip_increment, one.slip_rate,    one.dissipation,
                    one.stored_energy,  one.work,         static_cast<int>(one.state.regime)};
    }
  }
  if (force != nullptr) {
    for (int c = 0; c < kComponents; ++c) force[c] = sum[c];
  }
  return succeed(error);
}

}  // namespace

int slip_law_version(void) { return SLIP_LAW_VERSION; }

slip_law* slip_law_create(const slip_definition* definitions, size_t count, slip_error* error) {
  return made(error, [&] {
    std::vector<FrictionDefinition> all;
    for (std::size_t i = 0; definitions != nullptr && i < count; ++i) add(definitions[i], all);
    if (all.empty()) throw Fault("there is no definition");
    if (all.size() > SLIP_DEFINITIONS) throw Fault("more than %d definitions", SLIP_DEFINITIONS);
    return all;
  });
}

slip_law* slip_law_unpack(const double* numbers, size_t count, slip_error* error) {
  return made(error, [&] {
    auto all = unpack_all({numbers, numbers == nullptr ? 0 : count});
    if (!all || all->empty() || all->size() > SLIP_DEFINITIONS) {
      throw Fault("the %zu numbers are no packed friction, or that of another version", count);
    }
    for (const FrictionDefinition& one : *all) {
      if (std::holds_alternative<Capstan>(one.criterion)) {
        throw Fault("the friction of a belt wants its tension and its strain");
      }
    }
    return *std::move(all);
  });
}

size_t slip_law_pack(const slip_law* law, double* numbers, size_t capacity) {
  if (law == nullptr) return 0;
  try {
    const std::vector<double> all = pack_all(law->definitions);
    if (numbers != nullptr) std::copy_n(all.begin(), std::min(capacity, all.size()), numbers);
    return all.size();
  } catch (...) {
    return 0;
  }
}

void slip_law_destroy(slip_law* law) { delete law; }

size_t slip_law_definitions(const slip_law* law) {
  return law == nullptr ? 0 : law->definitions.size();
}

size_t slip_law_state_size(const slip_law* law) {
  return slip_law_definitions(law) * SLIP_STATE_NUMBERS;
}

void slip_law_initial_state(const slip_law* law, double* state) {
  for (std::size_t d = 0; state != nullptr && d < slip_law_definitions(law); ++d) {
    put_state({}, state + d * SLIP_STATE_NUMBERS);
  }
}

int slip_law_update(const slip_law* law, const slip_increment* increment, const double* old_state,
                    double* new_state, double* force, slip_result* results, slip_error* error) {
  return updated(law, increment, old_state, new_state, force, results, false, nullptr, nullptr,
                 error);
}

int slip_law_tangent(const slip_law* law, const slip_increment* increment, const double* old_state,
                     double* new_state, double* force, slip_result* results, double* to_motion,
                     double* to_force, slip_error* error) {
  return updated(law, increment, old_state, new_state, force, results, true, to_motion, to_force,
                 error);
}

int slip_law_coefficient(const slip_law* law, size_t definition, double slip_rate,
                         double contact_force, double temperature, const double* fields,
                         size_t field_count, double* mu, double* to_slip_rate,
                         double* to_contact_force, slip_error* error) {
  if (law == nullptr || definition >= law->definitions.size() || mu == nullptr) {
    return fail(error, SLIP_BAD_ARGUMENT, "a law, one of its definitions and mu must be there");
  }
  if (!is_amount(slip_rate) || !is_amount(contact_force)) {
    return fail(error, SLIP_BAD_ARGUMENT,
                "slip rate %g, contact force %g: wanted 0 or more, and finite", slip_rate,
                contact_force);
  }
  const Surroundings around(temperature, fields, field_count);
  const CoefficientPoint point =
      evaluate(law->definitions[definition].law, around.ambient(),
               SlipArguments{.slip_rate = slip_rate, .contact_force = contact_force});
  if (!std::isfinite(point.mu)) {
    return fail(error, SLIP_NOT_FINITE, "the coefficient at the slip rate %g is not finite",
                slip_rate);
  }
  *mu = point.mu;
  if (to_slip_rate != nullptr) *to_slip_rate = point.to_slip_rate;
  if (to_contact_force != nullptr) *to_contact_force = point.to_contact_force;
  return succeed(error);
}
