// SPDX-License-Identifier: Apache-2.0
// A functional mock-up unit for co-simulation (FMI 2.0.3): the library that `slipbench export CASE
// --to fmu` puts into each unit. What the case is, it reads from resources/law.txt; the value
// references count the variables there. Written from the standard; the names of its functions are
// the standard's.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "c/slip_law.h"
#include "law/base/compensated_sum.hpp"

namespace {

using Status = int;
constexpr Status kOk = 0, kDiscard = 2, kError = 3;
using Reference = unsigned int;
constexpr std::string_view kErrorCategory = "logStatusError";
/// The most increments of a step, as modelDescription.xml says: a slip of the host ends in a
/// message, not in hours.
constexpr double kMostIncrements = 100000.0;

using Logger = void (*)(void* environment, const char* instance, Status status,
                        const char* category, const char* message, ...);
/// Functions that a host hands over: fmi2CallbackFunctions.
struct Callbacks {
  Logger logger;
  void* (*allocate)(std::size_t count, std::size_t size);
  void (*release)(void* memory);
  void (*step_finished)(void* environment, Status status);
  void* environment;
};

/// A law's number that follows a parameter.
struct Following {
  std::size_t index = 0;
  bool in_proportion = true;
  double factor = 1.0;
};
struct Parameter {
  double value = 0.0;  ///< in the case
  std::vector<Following> numbers;
};

/// Places of the variables of a role, by component, field, definition or parameter; -1 of those
/// that are not there.
struct Places {
  std::vector<int> place;
  int operator[](std::size_t index) const { return index < place.size() ? place[index] : -1; }
};

constexpr std::array<std::string_view, 17> kRoles{
    "position",      "rate",    "force",      "temperature",      "field",
    "parameter",     "by_rate", "increments", "friction_force",   "limit",
    "normal_force",  "mu",      "regime",     "accumulated_slip", "dissipation",
    "stored_energy", "work"};
enum Role : std::size_t {
  kPosition,
  kRate,
  kForce,
  kTemperature,
  kField,
  kParameter,
  kByRate,
  kIncrements,
  kFrictionForce,
  kLimit,
  kNormalForce,
  kMu,
  kRegime,
  kAccumulatedSlip,
  kDissipation,
  kStoredEnergy,
  kWork
};

enum class Type { kReal, kInteger, kBoolean };
constexpr Type type_of(Role role) {
  if (role == kIncrements || role == kRegime) return Type::kInteger;
  return role == kByRate ? Type::kBoolean : Type::kReal;
}
constexpr bool is_parameter(Role role) {
  return role == kParameter || role == kByRate || role == kIncrements;
}
constexpr bool is_output(Role role) { return role >= kFrictionForce; }

/// Tells whether a variable of the role can have the value.
bool can_be(Role role, double x) {
  if (role == kByRate) return x == 0.0 || x == 1.0;
  return role != kIncrements || (x >= 1.0 && x <= kMostIncrements && x == std::floor(x));
}

/// Content of resources/law.txt.
struct Model {
  double fingerprint = 0.0;  ///< of the unit, so that a state of another one is not taken
  double time_unit = 1.0;    ///< of the case's units of time in a second
  std::array<double, SLIP_COMPONENTS> initial{}, reference{};
  std::vector<double> starts;  ///< of all variables, by value reference
  std::vector<Role> roles;     ///< of all variables
  std::array<Places, kRoles.size()> of;
  std::vector<Parameter> parameters;
  std::vector<double> numbers;
};

/// Words of a text that white space parts. Numbers are read the same way whatever the host's locale
/// is.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  std::string_view next() {
    const std::size_t begin = rest_.find_first_not_of(" \n\r");
    if (begin == std::string_view::npos) return fail<std::string_view>();
    const std::size_t end = std::min(rest_.find_first_of(" \n\r", begin), rest_.size());
    const std::string_view word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return word;
  }
  bool expect(std::string_view word) { return next() == word || fail<bool>(); }
  template <class Number>
  Number number() {
    const std::string_view word = next();
    Number read{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), read);
    return error == std::errc() && end == word.data() + word.size() ? read : fail<Number>();
  }
  /// A count of things that take a character each at least.
  std::size_t count() {
    const auto read = number<std::size_t>();
    return read <= rest_.size() + 1 ? read : fail<std::size_t>();
  }
  bool good() const { return good_; }

 private:
  template <class Result>
  Result fail() {
    good_ = false;
    rest_ = {};
    return Result{};
  }
  std::string_view rest_;
  bool good_ = true;
};

bool read_model(std::string_view text, Model& model) {
  Words words(text);
  words.expect("slipbench_fmu");
  words.expect("1");
  words.expect("time_unit");
  model.time_unit = words.number<double>();
  words.expect("initial");
  for (double& x : model.initial) x = words.number<double>();
  words.expect("reference");
  for (double& x : model.reference) x = words.number<double>();
  words.expect("variables");
  for (std::size_t i = words.count(); i > 0 && words.good(); --i) {
    const std::string_view word = words.next();
    const auto index = words.number<std::size_t>();
    const auto* const role = std::find(kRoles.begin(), kRoles.end(), word);
    if (role == kRoles.end() || index > 1000) return false;
    std::vector<int>& place = model.of[static_cast<std::size_t>(role - kRoles.begin())].place;
    if (place.size() <= index) place.resize(index + 1, -1);
    place[index] = static_cast<int>(model.starts.size());
    model.roles.push_back(static_cast<Role>(role - kRoles.begin()));
    model.starts.push_back(words.number<double>());
    if (!can_be(model.roles.back(), model.starts.back())) return false;
  }
  words.expect("parameters");
  for (std::size_t i = words.count(); i > 0 && words.good(); --i) {
    Parameter& parameter = model.parameters.emplace_back();
    const std::size_t count = words.count();
    parameter.value = words.number<double>();
    for (std::size_t k = 0; k < count && words.good(); ++k) {
      const auto index = words.number<std::size_t>();
      const int in_proportion = words.number<int>();
      parameter.numbers.push_back({index, in_proportion != 0, words.number<double>()});
    }
  }
  words.expect("numbers");
  for (std::size_t i = words.count(); i > 0 && words.good(); --i)
    model.numbers.push_back(words.number<double>());
  for (const Parameter& parameter : model.parameters) {
    for (const Following& one : parameter.numbers) {
      if (one.index >= model.numbers.size()) return false;
    }
  }
  return words.good();
}

/// The folder that an address names: "file:///a%20b" is "/a b".
std::string folder_of(std::string_view address) {
  for (const std::string_view scheme : {"file://localhost", "file://", "file:"}) {
    if (!address.starts_with(scheme)) continue;
    address.remove_prefix(scheme.size());
    break;
  }
  std::string folder;
  for (std::size_t i = 0; i < address.size(); ++i) {
    unsigned int code = 0;
    const bool coded =
        address[i] == '%' && i + 2 < address.size() &&
        std::from_chars(address.data() + i + 1, address.data() + i + 3, code, 16).ptr ==
            address.data() + i + 3;
    folder += coded ? static_cast<char>(code) : address[i];
    if (coded) i += 2;
  }
  return folder;
}

struct Destroy {
  void operator()(slip_law* law) const { slip_law_destroy(law); }
};

/// States of an instance between its making and its end (section 4.2.4 of the standard).
enum class Mode { kInstantiated, kInitialization, kStepping, kTerminated };

/// A number that tells one unit's guid from another's; exact as a double.
double fingerprint_of(std::string_view guid) {
  std::uint64_t hash = 0xcbf29ce484222325U;  // FNV-1a
  for (const char c : guid) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return static_cast<double>(hash >> 12U);
}

/// One instance. All that moves is in `now`, so that a saved state is a copy of it.
struct Instance {
  std::string name;
  Callbacks callbacks{};
  bool logs = false;  ///< the host wants to hear of errors
  Model model;
  std::unique_ptr<slip_law, Destroy> law;
  std::vector<double> made_of;  ///< values of the parameters that the law was made of
  bool stale = true;            ///< inputs or parameters were set since the outputs were made

  struct State {
    std::array<double, SLIP_COMPONENTS> position{};     ///< where the last step ended
    std::array<double, SLIP_COMPONENTS> begin_force{};  ///< there
    double begin_temperature = 0.0;
    std::array<double, SLIP_FIELDS> begin_fields{};
    double mode = 0.0;             ///< Mode
    double set_up = 0.0;           ///< 1 once the experiment is set up
    double time = 0.0;             ///< of the host [s], where the last step ended
    double stop = 0.0;             ///< of the host [s]; the largest number where it set none
    std::vector<double> friction;  ///< of the law
    /// By rounding, of dissipation and work of each definition.
    std::array<std::array<double, SLIP_DEFINITIONS>, 2> left_out{};
    std::vector<double> values;  ///< of all variables
  };
  State now;
  State before;  ///< the step that is being made: kept, so that a step allocates nothing

  Status log(Status status, const char* message) const {
    if (logs && callbacks.logger != nullptr) {
      callbacks.logger(callbacks.environment, name.c_str(), status, kErrorCategory.data(), "%s",
                       message);
    }
    return status;
  }
  Mode mode() const { return static_cast<Mode>(static_cast<int>(now.mode)); }
  void enter(Mode mode) { now.mode = static_cast<double>(mode); }
  double value(Role role, std::size_t index, double otherwise) const {
    const int place = model.of[role][index];
    return place < 0 ? otherwise : now.values[static_cast<std::size_t>(place)];
  }
  void tell(Role role, std::size_t index, double x) {
    const int place = model.of[role][index];
    if (place >= 0) now.values[static_cast<std::size_t>(place)] = x;
  }
  /// Adds to a sum whose place has `left_out`.
  void add(Role role, std::size_t index, double x, double& left_out) {
    double sum = value(role, index, 0.0);
    if (!std::isfinite(sum)) return;  // infinite it stays, and does not become NaN
    slipbench::law::add_compensated(x, &sum, &left_out);
    tell(role, index, sum);
  }
};

/// Puts an instance where it was when it was made.
void restart(Instance& one) {
  one.now.values = one.model.starts;
  one.now.set_up = 0.0;
  one.now.time = 0.0;
  one.now.stop = std::numeric_limits<double>::max();
  one.enter(Mode::kInstantiated);
}

/// Ambient and forces that the host prescribes for the end of a step.
struct Prescribed {
  std::array<double, SLIP_COMPONENTS> force{};
  double temperature = 0.0;
  std::array<double, SLIP_FIELDS> fields{};
};
Prescribed prescribed(const Instance& one) {
  Prescribed end;
  for (std::size_t c = 0; c < SLIP_COMPONENTS; ++c) end.force[c] = one.value(kForce, c, 0.0);
  end.temperature = one.value(kTemperature, 0, 0.0);
  for (std::size_t f = 0; f < SLIP_FIELDS; ++f) end.fields[f] = one.value(kField, f, 0.0);
  return end;
}

/// One increment from where the connector is to `end`; tells what became of it.
Status advance(Instance& one, double duration, const std::array<double, SLIP_COMPONENTS>& end,
               const Prescribed& at_end) {
  slip_increment increment{};
  increment.duration = duration;
  std::copy(one.now.position.begin(), one.now.position.end(), increment.begin);
  std::copy(end.begin(), end.end(), increment.end);
  std::copy(one.model.reference.begin(), one.model.reference.end(), increment.reference);
  std::copy(at_end.force.begin(), at_end.force.end(), increment.force);
  increment.temperature = at_end.temperature;
  increment.fields = at_end.fields.data();
  increment.field_count = at_end.fields.size();
  std::array<double, SLIP_COMPONENTS> force{};
  std::array<slip_result, SLIP_DEFINITIONS> results{};
  slip_error error;
  double* const state = one.now.friction.data();
  if (slip_law_update(one.law.get(), &increment, state, state, force.data(), results.data(),
                      &error) != SLIP_OK) {
    return one.log(kError, error.message);
  }
  one.now.position = end;
  one.now.begin_force = at_end.force;
  one.now.begin_temperature = at_end.temperature;
  one.now.begin_fields = at_end.fields;
  for (std::size_t c = 0; c < SLIP_COMPONENTS; ++c) one.tell(kFrictionForce, c, force[c]);
  for (std::size_t d = 0; d < slip_law_definitions(one.law.get()); ++d) {
    const slip_result& result = results[d];
    one.tell(kLimit, d, result.limit);
    one.tell(kNormalForce, d, result.normal_force);
    one.tell(kMu, d, result.mu);
    one.tell(kRegime, d, result.regime);
    one.tell(kAccumulatedSlip, d, state[d * SLIP_STATE_NUMBERS + 12]);
    one.add(kDissipation, d, result.dissipation, one.now.left_out[0][d]);
    one.tell(kStoredEnergy, d, result.stored_energy);
    one.add(kWork, d, result.work, one.now.left_out[1][d]);
  }
  return kOk;
}

/// Values of the parameters in a state.
std::vector<double> parameters_in(const Instance& one, const Instance::State& state) {
  std::vector<double> values;
  for (std::size_t p = 0; p < one.model.parameters.size(); ++p) {
    const int place = one.model.of[kParameter][p];
    values.push_back(place < 0 ? one.model.parameters[p].value
                               : state.values[static_cast<std::size_t>(place)]);
  }
  return values;
}

/// Makes the law of the parameters that a state has, if it is another one; after an error the law
/// is the old one.
Status make_law(Instance& one, const Instance::State& state) {
  std::vector<double> values = parameters_in(one, state);
  if (one.law != nullptr && values == one.made_of) return kOk;
  std::vector<double> numbers = one.model.numbers;
  for (std::size_t p = 0; p < one.model.parameters.size(); ++p) {
    const Parameter& parameter = one.model.parameters[p];
    const double x = values[p];
    if (x == parameter.value) continue;  // as it was exported, in all bits
    for (const Following& number : parameter.numbers) {
      double& n = numbers[number.index];
      n = number.in_proportion ? number.factor * x : n + number.factor * (x - parameter.value);
    }
  }
  std::unique_ptr<slip_law, Destroy> made(slip_law_unpack(numbers.data(), numbers.size(), nullptr));
  if (made == nullptr) {
    return one.log(
        kError,
        "the parameters make no friction: one is out of its bounds, or two do not go together");
  }
  one.law = std::move(made);
  one.made_of = std::move(values);
  return kOk;
}

/// Begins with the parameters and starts as they are, and the state of a connector that has not
/// moved.
Status initialize(Instance& one) {
  if (const Status made = make_law(one, one.now); made != kOk) return made;
  slip_law_initial_state(one.law.get(), one.now.friction.data());
  for (std::size_t c = 0; c < SLIP_COMPONENTS; ++c) {
    one.now.position[c] = one.value(kPosition, c, one.model.initial[c]);
  }
  for (const Role role : {kDissipation, kWork}) {
    for (std::size_t d = 0; d < SLIP_DEFINITIONS; ++d) one.tell(role, d, 0.0);
  }
  one.now.left_out = {};
  // An increment without motion: the limits, coefficients and regimes there.
  return advance(one, 0.0, one.now.position, prescribed(one));
}

/// Runs `body`; after an error the instance is where it was.
template <class Body>
Status undone_on_error(Instance& one, Body body) {
  one.before = one.now;
  const Status status = body();
  if (status != kOk) std::swap(one.now, one.before);
  return status;
}

/// Notes from when on, and if it is defined until when, the host simulates.
Status set_up(Instance& one, double start, bool has_stop, double stop) {
  if (one.now.set_up != 0.0) return one.log(kError, "the experiment was set up already");
  if (!std::isfinite(start)) return one.log(kError, "the start time is not finite");
  if (has_stop && !(stop >= start && std::isfinite(stop)))
    return one.log(kError, "the stop time is before the start time, or not finite");
  one.now.set_up = 1.0;
  one.now.time = start;
  one.now.stop = has_stop ? stop : std::numeric_limits<double>::max();
  return kOk;
}

Status do_step(Instance& one, double begin, double size) {
  const double duration = size * one.model.time_unit;
  if (!(duration > 0.0 && std::isfinite(duration)))
    return one.log(kError, "a step must be longer than 0, and finite");
  // Rounding of the host's sums and products of steps.
  const double rounding = 1e-6 * size + 64.0 * std::numeric_limits<double>::epsilon() *
                                            std::max(std::abs(begin), std::abs(one.now.time));
  if (!(std::abs(begin - one.now.time) <= rounding))
    return one.log(kError, "a step must begin where the last one ended");
  if (!(begin + size <= one.now.stop + rounding))
    return one.log(kError, "a step beyond the stop time");
  one.now.time = begin + size;
  const double asked = one.value(kIncrements, 0, 1.0);
  const bool by_rate = one.value(kByRate, 0, 0.0) != 0.0;
  const std::array<double, SLIP_COMPONENTS> from = one.now.position;
  std::array<double, SLIP_COMPONENTS> to = from;
  for (std::size_t c = 0; c < SLIP_COMPONENTS; ++c) {
    to[c] =
        by_rate ? from[c] + one.value(kRate, c, 0.0) * duration : one.value(kPosition, c, from[c]);
    if (by_rate) one.tell(kPosition, c, to[c]);
  }
  const Prescribed last = prescribed(one);
  const auto pieces = static_cast<long>(asked);
  const Prescribed first{one.now.begin_force, one.now.begin_temperature, one.now.begin_fields};
  for (long i = 1; i < pieces; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(pieces);
    const auto between = [part](double a, double b) { return a + part * (b - a); };
    std::array<double, SLIP_COMPONENTS> middle{};
    Prescribed there;
    for (std::size_t c = 0; c < SLIP_COMPONENTS; ++c) {
      middle[c] = between(from[c], to[c]);
      there.force[c] = between(first.force[c], last.force[c]);
    }
    there.temperature = between(first.temperature, last.temperature);
    for (std::size_t f = 0; f < SLIP_FIELDS; ++f)
      there.fields[f] = between(first.fields[f], last.fields[f]);
    if (const Status status = advance(one, duration / static_cast<double>(pieces), middle, there);
        status != kOk)
      return status;
  }
  return advance(one, duration / static_cast<double>(pieces), to, last);
}

/// Runs a call of the host; no exception leaves the library.
template <class Body>
Status guarded(void* component, Body body) noexcept {
  if (component == nullptr) return kError;
  Instance& one = *static_cast<Instance*>(component);
  try {
    return body(one);
  } catch (const std::bad_alloc&) {
    return one.log(kError, "no memory is left");
  } catch (const std::exception& exception) {
    return one.log(kError, exception.what());
  } catch (...) {
    return one.log(kError, "an error without a name");
  }
}

/// Runs a call of the host that belongs to one mode.
template <class Body>
Status guarded_in(void* component, Mode mode, const char* otherwise, Body body) noexcept {
  return guarded(component, [&](Instance& one) {
    return one.mode() == mode ? body(one) : one.log(kError, otherwise);
  });
}

/// Tells whether all value references are those of variables of a type.
Status check(const Instance& one, const Reference* references, std::size_t count,
             const void* values, Type type) {
  if (count > 0 && (references == nullptr || values == nullptr))
    return one.log(kError, "value references and values must be there");
  for (std::size_t i = 0; i < count; ++i) {
    if (references[i] >= one.model.roles.size())
      return one.log(kError, "no variable has this value reference");
    if (type_of(one.model.roles[references[i]]) != type)
      return one.log(kError, "a variable is of another type: Real, Integer, Boolean");
  }
  return kOk;
}

template <class Value>
Status get(void* component, const Reference* references, std::size_t count, Value* values,
           Type type) {
  return guarded(component, [&](Instance& one) {
    if (const Status status = check(one, references, count, values, type); status != kOk)
      return status;
    const bool outputs = std::any_of(references, references + count, [&](Reference reference) {
      return is_output(one.model.roles[reference]);
    });
    if (outputs && one.mode() == Mode::kInstantiated)
      return one.log(kError, "outputs are not there before initialization");
    if (outputs && one.stale && one.mode() == Mode::kInitialization) {
      const Status status = undone_on_error(one, [&] { return initialize(one); });
      if (status != kOk) return status;
      one.stale = false;
    }
    for (std::size_t i = 0; i < count; ++i)
      values[i] = static_cast<Value>(one.now.values[references[i]]);
    return kOk;
  });
}

template <class Value>
Status set(void* component, const Reference* references, std::size_t count, const Value* values,
           Type type) {
  return guarded(component, [&](Instance& one) {
    if (const Status status = check(one, references, count, values, type); status != kOk)
      return status;
    if (one.mode() == Mode::kTerminated) return one.log(kError, "a value is set after the end");
    const bool begun = one.mode() != Mode::kInstantiated && one.mode() != Mode::kInitialization;
    const auto number = [&](std::size_t i) {
      const auto x = static_cast<double>(values[i]);
      return type == Type::kBoolean && x != 0.0 ? 1.0 : x;
    };
    for (std::size_t i = 0; i < count; ++i) {
      const Role role = one.model.roles[references[i]];
      if (is_output(role)) return one.log(kError, "an output cannot be set");
      if (begun && is_parameter(role))
        return one.log(kError, "parameters are fixed: they cannot be set after initialization");
      if (!can_be(role, number(i)))
        return one.log(kError, "increments are a whole number from 1 to 100000");
    }
    for (std::size_t i = 0; i < count; ++i) one.now.values[references[i]] = number(i);
    one.stale = true;
    return kOk;
  });
}

/// Calls visit(number) for all numbers of a state, in one order.
template <class State, class Visit>
void for_each_number(State& state, Visit visit) {
  for (auto& x : state.position) visit(x);
  for (auto& x : state.begin_force) visit(x);
  visit(state.begin_temperature);
  for (auto& x : state.begin_fields) visit(x);
  visit(state.mode);
  visit(state.set_up);
  visit(state.time);
  visit(state.stop);
  for (auto& x : state.friction) visit(x);
  for (auto& of_sum : state.left_out) {
    for (auto& x : of_sum) visit(x);
  }
  for (auto& x : state.values) visit(x);
}

/// Tells whether a state that was read from bytes is one that an instance can be in.
bool is_state_of(const Instance& one, const Instance::State& state) {
  if (state.values.size() != one.now.values.size() ||
      state.friction.size() != one.now.friction.size())
    return false;
  const bool mode = state.mode >= 0.0 && state.mode <= static_cast<double>(Mode::kTerminated) &&
                    state.mode == std::floor(state.mode);
  for (std::size_t i = 0; i < state.values.size(); ++i) {
    const Role role = one.model.roles[i];
    const bool regime = role != kRegime || (state.values[i] >= 0.0 && state.values[i] <= 2.0);
    if (!regime || !can_be(role, state.values[i])) return false;
  }
  const bool times = (state.set_up == 1.0 || (state.set_up == 0.0 && state.mode == 0.0)) &&
                     std::isfinite(state.time) && std::isfinite(state.stop);
  return mode && times;
}

Status nothing_pending(void* component) {
  return guarded(component, [](const Instance& one) {
    return one.log(kDiscard, "no step is pending: they end when they return");
  });
}

}  // namespace

// NOLINTBEGIN(readability-identifier-naming): the standard's
#define FMU_API extern "C" __attribute__((visibility("default")))

FMU_API const char* fmi2GetTypesPlatform() { return "default"; }
FMU_API const char* fmi2GetVersion() { return "2.0"; }
FMU_API Status fmi2SetDebugLogging(void* component, int on, std::size_t count,
                                   const char* const* categories) {
  return guarded(component, [&](Instance& one) {
    bool wanted = count == 0;
    for (std::size_t i = 0; categories != nullptr && i < count; ++i) {
      if (categories[i] == nullptr || categories[i] != kErrorCategory)
        return one.log(kError, "the one category of messages is logStatusError");
      wanted = true;
    }
    if (wanted) one.logs = on != 0;
    return kOk;
  });
}

FMU_API void* fmi2Instantiate(const char* name, int type, const char* guid, const char* resources,
                              const Callbacks* callbacks, int /*visible*/, int logging) {
  std::unique_ptr<Instance> one;
  const auto refuse = [&](const std::string& why) -> void* {
    if (one != nullptr) one->log(kError, why.c_str());
    return nullptr;
  };
  try {
    one = std::make_unique<Instance>();
    one->name = name == nullptr ? "" : name;
    if (callbacks != nullptr) one->callbacks = *callbacks;
    one->logs = true;  // the only way to tell why there is no instance
    constexpr int kCoSimulation = 1;
    if (type != kCoSimulation) return refuse("this unit is one for co-simulation");
    const std::string file = folder_of(resources == nullptr ? "" : resources) + "/law.txt";
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return refuse("cannot read " + file);
    const std::string text{std::istreambuf_iterator<char>(stream),
                           std::istreambuf_iterator<char>()};
    const std::size_t end = text.find('\n');
    if (end == std::string::npos || !text.starts_with("guid "))
      return refuse(file + " is of no unit");
    if (guid == nullptr || std::string_view(text).substr(5, end - 5) != guid) {
      return refuse("modelDescription.xml and " + file + " are of two units: their guid differs");
    }
    if (!read_model(std::string_view(text).substr(end + 1), one->model))
      return refuse(file + " is damaged, or of another version");
    one->model.fingerprint = fingerprint_of(guid);
    restart(*one);
    if (make_law(*one, one->now) != kOk) return nullptr;
    one->now.friction.resize(slip_law_state_size(one->law.get()));
    one->logs = logging != 0;
    return one.release();
  } catch (const std::exception& exception) {
    return refuse(exception.what());
  } catch (...) {
    return nullptr;
  }
}

FMU_API void fmi2FreeInstance(void* component) { delete static_cast<Instance*>(component); }

FMU_API Status fmi2SetupExperiment(void* component, int, double, double start, int has_stop,
                                   double stop) {
  return guarded_in(component, Mode::kInstantiated, "the experiment is set up after initialization",
                    [&](Instance& one) { return set_up(one, start, has_stop != 0, stop); });
}
FMU_API Status fmi2EnterInitializationMode(void* component) {
  return guarded_in(component, Mode::kInstantiated, "initialization was entered already",
                    [](Instance& one) {
                      if (one.now.set_up == 0.0)
                        return one.log(kError, "the experiment was not set up");
                      one.enter(Mode::kInitialization);
                      one.stale = true;
                      return kOk;
                    });
}
FMU_API Status fmi2ExitInitializationMode(void* component) {
  return guarded_in(component, Mode::kInitialization, "initialization was not entered",
                    [](Instance& one) {
                      return undone_on_error(one, [&] {
                        const Status status = initialize(one);
                        if (status == kOk) one.enter(Mode::kStepping);
                        return status;
                      });
                    });
}
FMU_API Status fmi2Terminate(void* component) {
  return guarded_in(component, Mode::kStepping, "there is no simulation to terminate",
                    [](Instance& one) {
                      one.enter(Mode::kTerminated);
                      return kOk;
                    });
}
FMU_API Status fmi2Reset(void* component) {
  return guarded(component, [](Instance& one) {
    restart(one);
    return kOk;
  });
}

FMU_API Status fmi2GetReal(void* component, const Reference* references, std::size_t count,
                           double* values) {
  return get(component, references, count, values, Type::kReal);
}
FMU_API Status fmi2GetInteger(void* component, const Reference* references, std::size_t count,
                              int* values) {
  return get(component, references, count, values, Type::kInteger);
}
FMU_API Status fmi2GetBoolean(void* component, const Reference* references, std::size_t count,
                              int* values) {
  return get(component, references, count, values, Type::kBoolean);
}
FMU_API Status fmi2SetReal(void* component, const Reference* references, std::size_t count,
                           const double* values) {
  return set(component, references, count, values, Type::kReal);
}
FMU_API Status fmi2SetInteger(void* component, const Reference* references, std::size_t count,
                              const int* values) {
  return set(component, references, count, values, Type::kInteger);
}
FMU_API Status fmi2SetBoolean(void* component, const Reference* references, std::size_t count,
                              const int* values) {
  return set(component, references, count, values, Type::kBoolean);
}
FMU_API Status fmi2GetString(void* component, const Reference*, std::size_t count, const char**) {
  return guarded(component, [&](const Instance& one) {
    return count == 0 ? kOk : one.log(kError, "there are no strings");
  });
}
FMU_API Status fmi2SetString(void* component, const Reference*, std::size_t count,
                             const char* const*) {
  return guarded(component, [&](const Instance& one) {
    return count == 0 ? kOk : one.log(kError, "there are no strings");
  });
}

FMU_API Status fmi2DoStep(void* component, double begin, double size, int) {
  return guarded(component, [&](Instance& one) {
    if (one.mode() == Mode::kTerminated) return one.log(kError, "a step after the end");
    if (one.mode() != Mode::kStepping)
      return one.log(kError, "a step before the end of initialization");
    return undone_on_error(one, [&] { return do_step(one, begin, size); });
  });
}
FMU_API Status fmi2CancelStep(void* component) { return nothing_pending(component); }
FMU_API Status fmi2GetStatus(void* component, int, Status*) { return nothing_pending(component); }
FMU_API Status fmi2GetRealStatus(void* component, int, double*) {
  return nothing_pending(component);
}
FMU_API Status fmi2GetIntegerStatus(void* component, int, int*) {
  return nothing_pending(component);
}
FMU_API Status fmi2GetBooleanStatus(void* component, int, int*) {
  return nothing_pending(component);
}
FMU_API Status fmi2GetStringStatus(void* component, int, const char**) {
  return nothing_pending(component);
}
FMU_API Status fmi2SetRealInputDerivatives(void* component, const Reference*, std::size_t,
                                           const int*, const double*) {
  return guarded(component, [](const Instance& one) {
    return one.log(kError, "inputs are not interpolated");
  });
}
FMU_API Status fmi2GetRealOutputDerivatives(void* component, const Reference*, std::size_t,
                                            const int*, double*) {
  return guarded(component, [](const Instance& one) {
    return one.log(kError, "outputs have no derivatives");
  });
}
FMU_API Status fmi2GetDirectionalDerivative(void* component, const Reference*, std::size_t,
                                            const Reference*, std::size_t, const double*, double*) {
  return guarded(component, [](const Instance& one) {
    return one.log(kError, "there are no directional derivatives");
  });
}

FMU_API Status fmi2GetFMUstate(void* component, void** state) {
  return guarded(component, [&](const Instance& one) {
    if (state == nullptr) return one.log(kError, "there is no place for a state");
    if (*state != nullptr) {
      *static_cast<Instance::State*>(*state) = one.now;
    } else {
      *state = new Instance::State(one.now);
    }
    return kOk;
  });
}
FMU_API Status fmi2SetFMUstate(void* component, void* state) {
  return guarded(component, [&](Instance& one) {
    if (state == nullptr) return one.log(kError, "there is no state");
    // A copy first: what fails leaves the instance as it was.
    Instance::State saved = *static_cast<const Instance::State*>(state);
    if (!is_state_of(one, saved)) return one.log(kError, "the state is none of this unit");
    // Before its initialization ends an instance may have parameters that make no law yet.
    const bool begun = saved.mode >= static_cast<double>(Mode::kStepping);
    if (begun && make_law(one, saved) != kOk) return kError;
    one.now = std::move(saved);
    one.stale = true;
    return kOk;
  });
}
FMU_API Status fmi2FreeFMUstate(void* component, void** state) {
  return guarded(component, [&](const Instance&) {
    if (state == nullptr) return kOk;
    delete static_cast<Instance::State*>(*state);
    *state = nullptr;
    return kOk;
  });
}
FMU_API Status fmi2SerializedFMUstateSize(void* component, void* state, std::size_t* size) {
  return guarded(component, [&](const Instance& one) {
    if (state == nullptr || size == nullptr) return one.log(kError, "there is no state");
    std::size_t count = 1;
    for_each_number(*static_cast<const Instance::State*>(state), [&](const double&) { ++count; });
    *size = count * sizeof(double);
    return kOk;
  });
}
FMU_API Status fmi2SerializeFMUstate(void* component, void* state, char* bytes, std::size_t size) {
  return guarded(component, [&](const Instance& one) {
    if (state == nullptr || bytes == nullptr) return one.log(kError, "there is no state");
    std::size_t at = 0;
    bool fits = true;
    const auto put = [&](const double& x) {
      fits = fits && at + sizeof x <= size;
      if (fits) std::memcpy(bytes + at, &x, sizeof x);
      at += sizeof x;
    };
    put(one.model.fingerprint);
    for_each_number(*static_cast<const Instance::State*>(state), put);
    return fits ? kOk : one.log(kError, "the memory is shorter than the state");
  });
}
FMU_API Status fmi2DeSerializeFMUstate(void* component, const char* bytes, std::size_t size,
                                       void** state) {
  return guarded(component, [&](const Instance& one) {
    if (bytes == nullptr || state == nullptr) return one.log(kError, "there are no bytes");
    auto read = std::make_unique<Instance::State>(one.now);
    std::size_t at = 0;
    double fingerprint = 0.0;
    const auto take = [&](double& x) {
      if (at + sizeof x <= size) std::memcpy(&x, bytes + at, sizeof x);
      at += sizeof x;
    };
    take(fingerprint);
    for_each_number(*read, take);
    if (at != size || fingerprint != one.model.fingerprint || !is_state_of(one, *read))
      return one.log(kError, "the bytes are no state of this unit");
    *state = read.release();
    return kOk;
  });
}
// NOLINTEND(readability-identifier-naming)
