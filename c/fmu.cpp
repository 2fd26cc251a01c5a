// SPDX-License-Identifier: Apache-2.0
// A functional mock-up unit for co-simulation (FMI 2.0.3): the library that `slipbench export CASE
// --to fmu` puts into each unit. What the case is, it reads from resources/law.txt; the value
// references count the variables there. Written from the standard; the names of its functions are
// the standard's.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "c/slip_law.h"

namespace {

using Status = int;
constexpr Status kOk = 0, kDiscard = 2, kError = 3;
using Reference = unsigned int;

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

/// Content of resources/law.txt.
struct Model {
  double time_unit = 1.0;  ///< of the case's units of time in a second
  std::array<double, SLIP_COMPONENTS> initial{}, reference{};
  std::vector<double> starts;  ///< of all variables, by value reference
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
    model.starts.push_back(words.number<double>());
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

/// One instance. All that moves is in `now`, so that a saved state is a copy of it.
struct Instance {
  std::string name;
  Callbacks callbacks{};
  Model model;
  std::unique_ptr<slip_law, Destroy> law;

  struct State {
    std::array<double, SLIP_COMPONENTS> position{};     ///< where the last step ended
    std::array<double, SLIP_COMPONENTS> begin_force{};  ///< there
    double begin_temperature = 0.0;
    std::array<double, SLIP_FIELDS> begin_fields{};
    double initialized = 0.0;
    std::vector<double> friction;  ///< of the law
    std::vector<double> values;    ///< of all variables
  };
  State now;
  State before;  ///< the step that is being made: kept, so that a step allocates nothing

  Status log(Status status, const char* message) const {
    if (callbacks.logger != nullptr) {
      callbacks.logger(callbacks.environment, name.c_str(), status, "logStatusError", "%s",
                       message);
    }
    return status;
  }
  double value(Role role, std::size_t index, double otherwise) const {
    const int place = model.of[role][index];
    return place < 0 ? otherwise : now.values[static_cast<std::size_t>(place)];
  }
  void tell(Role role, std::size_t index, double x) {
    const int place = model.of[role][index];
    if (place >= 0) now.values[static_cast<std::size_t>(place)] = x;
  }
  void add(Role role, std::size_t index, double x) {
    tell(role, index, value(role, index, 0.0) + x);
  }
};

/// Puts an instance where it was when it was made.
void restart(Instance& one) {
  one.now.values = one.model.starts;
  one.now.initialized = 0.0;
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
    one.add(kDissipation, d, result.dissipation);
    one.tell(kStoredEnergy, d, result.stored_energy);
    one.add(kWork, d, result.work);
  }
  return kOk;
}

/// Makes the law of the parameters as they are.
Status make_law(Instance& one) {
  std::vector<double> numbers = one.model.numbers;
  for (std::size_t p = 0; p < one.model.parameters.size(); ++p) {
    const Parameter& parameter = one.model.parameters[p];
    const double x = one.value(kParameter, p, parameter.value);
    if (x == parameter.value) continue;  // as it was exported, in all bits
    for (const Following& number : parameter.numbers) {
      double& n = numbers[number.index];
      n = number.in_proportion ? number.factor * x : n + number.factor * (x - parameter.value);
    }
  }
  one.law.reset(slip_law_unpack(numbers.data(), numbers.size(), nullptr));
  if (one.law != nullptr) return kOk;
  return one.log(
      kError,
      "the parameters make no friction: one is out of its bounds, or two do not go together");
}

/// Tells whether two states have the same parameters, so the same law.
bool same_parameters(const Instance& one, const Instance::State& a, const Instance::State& b) {
  const std::vector<int>& place = one.model.of[kParameter].place;
  return std::all_of(place.begin(), place.end(), [&](int at) {
    return at < 0 ||
           a.values[static_cast<std::size_t>(at)] == b.values[static_cast<std::size_t>(at)];
  });
}

/// Begins with the parameters and starts as they are, and the state of a connector that has not
/// moved.
Status initialize(Instance& one) {
  if (const Status made = make_law(one); made != kOk) return made;
  slip_law_initial_state(one.law.get(), one.now.friction.data());
  for (std::size_t c = 0; c < SLIP_COMPONENTS; ++c) {
    one.now.position[c] = one.value(kPosition, c, one.model.initial[c]);
  }
  for (const Role role : {kDissipation, kWork}) {
    for (std::size_t d = 0; d < SLIP_DEFINITIONS; ++d) one.tell(role, d, 0.0);
  }
  // An increment without motion: the limits, coefficients and regimes there.
  const Status status = advance(one, 0.0, one.now.position, prescribed(one));
  one.now.initialized = status == kOk ? 1.0 : 0.0;
  return status;
}

Status do_step(Instance& one, double size) {
  if (one.now.initialized == 0.0) return one.log(kError, "a step before the end of initialization");
  if (!(size > 0.0)) return one.log(kDiscard, "a step must be longer than 0");
  const double asked = one.value(kIncrements, 0, 1.0);
  if (!(asked >= 1.0)) return one.log(kError, "increments must be 1 or more");
  const bool by_rate = one.value(kByRate, 0, 0.0) != 0.0;
  const double duration = size * one.model.time_unit;
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
Status guarded(void* component, Body body) {
  if (component == nullptr) return kError;
  Instance& one = *static_cast<Instance*>(component);
  try {
    return body(one);
  } catch (const std::bad_alloc&) {
    return one.log(kError, "no memory is left");
  }
}

template <class Value>
Status get(void* component, const Reference* references, std::size_t count, Value* values) {
  return guarded(component, [&](const Instance& one) {
    for (std::size_t i = 0; i < count; ++i) {
      if (references[i] >= one.now.values.size())
        return one.log(kError, "no variable has this value reference");
      values[i] = static_cast<Value>(one.now.values[references[i]]);
    }
    return kOk;
  });
}

/// Variables of a role cannot be set, being outputs.
bool is_output(const Model& model, Reference reference) {
  for (std::size_t role = kFrictionForce; role < kRoles.size(); ++role) {
    const std::vector<int>& place = model.of[role].place;
    if (std::find(place.begin(), place.end(), static_cast<int>(reference)) != place.end())
      return true;
  }
  return false;
}

template <class Value>
Status set(void* component, const Reference* references, std::size_t count, const Value* values) {
  return guarded(component, [&](Instance& one) {
    for (std::size_t i = 0; i < count; ++i) {
      if (references[i] >= one.now.values.size())
        return one.log(kError, "no variable has this value reference");
      if (is_output(one.model, references[i])) return one.log(kError, "an output cannot be set");
      one.now.values[references[i]] = static_cast<double>(values[i]);
    }
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
  visit(state.initialized);
  for (auto& x : state.friction) visit(x);
  for (auto& x : state.values) visit(x);
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
FMU_API Status fmi2SetDebugLogging(void* component, int, std::size_t, const char* const*) {
  return component == nullptr ? kError : kOk;
}

FMU_API void* fmi2Instantiate(const char* name, int type, const char* guid, const char* resources,
                              const Callbacks* callbacks, int /*visible*/, int /*logging*/) {
  try {
    auto one = std::make_unique<Instance>();
    one->name = name == nullptr ? "" : name;
    if (callbacks != nullptr) one->callbacks = *callbacks;
    const auto refuse = [&](const std::string& why) -> void* {
      one->log(kError, why.c_str());
      return nullptr;
    };
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
    restart(*one);
    if (make_law(*one) != kOk) return nullptr;
    one->now.friction.resize(slip_law_state_size(one->law.get()));
    return one.release();
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

FMU_API void fmi2FreeInstance(void* component) { delete static_cast<Instance*>(component); }

FMU_API Status fmi2SetupExperiment(void* component, int, double, double, int, double) {
  return component == nullptr ? kError : kOk;
}
FMU_API Status fmi2EnterInitializationMode(void* component) {
  return component == nullptr ? kError : kOk;
}
FMU_API Status fmi2ExitInitializationMode(void* component) {
  return guarded(component, [](Instance& one) { return initialize(one); });
}
FMU_API Status fmi2Terminate(void* component) { return component == nullptr ? kError : kOk; }
FMU_API Status fmi2Reset(void* component) {
  return guarded(component, [](Instance& one) {
    restart(one);
    return kOk;
  });
}

FMU_API Status fmi2GetReal(void* component, const Reference* references, std::size_t count,
                           double* values) {
  return get(component, references, count, values);
}
FMU_API Status fmi2GetInteger(void* component, const Reference* references, std::size_t count,
                              int* values) {
  return get(component, references, count, values);
}
FMU_API Status fmi2GetBoolean(void* component, const Reference* references, std::size_t count,
                              int* values) {
  return get(component, references, count, values);
}
FMU_API Status fmi2SetReal(void* component, const Reference* references, std::size_t count,
                           const double* values) {
  return set(component, references, count, values);
}
FMU_API Status fmi2SetInteger(void* component, const Reference* references, std::size_t count,
                              const int* values) {
  return set(component, references, count, values);
}
FMU_API Status fmi2SetBoolean(void* component, const Reference* references, std::size_t count,
                              const int* values) {
  return set(component, references, count, values);
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

FMU_API Status fmi2DoStep(void* component, double /*begin*/, double size, int) {
  return guarded(component, [&](Instance& one) {
    // A step that cannot be made leaves the connector where it was.
    one.before = one.now;
    const Status status = do_step(one, size);
    if (status != kOk) std::swap(one.now, one.before);
    return status;
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
    const auto& saved = *static_cast<const Instance::State*>(state);
    const bool same = same_parameters(one, saved, one.now);
    one.now = saved;
    return same ? kOk : make_law(one);
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
  return guarded(component, [&](const Instance&) {
    std::size_t count = 0;
    for_each_number(*static_cast<const Instance::State*>(state), [&](const double&) { ++count; });
    *size = count * sizeof(double);
    return kOk;
  });
}
FMU_API Status fmi2SerializeFMUstate(void* component, void* state, char* bytes, std::size_t size) {
  return guarded(component, [&](const Instance& one) {
    std::size_t at = 0;
    bool fits = true;
    for_each_number(*static_cast<const Instance::State*>(state), [&](const double& x) {
      fits = fits && at + sizeof x <= size;
      if (fits) std::memcpy(bytes + at, &x, sizeof x);
      at += sizeof x;
    });
    return fits ? kOk : one.log(kError, "the memory is shorter than the state");
  });
}
FMU_API Status fmi2DeSerializeFMUstate(void* component, const char* bytes, std::size_t size,
                                       void** state) {
  return guarded(component, [&](const Instance& one) {
    auto read = std::make_unique<Instance::State>(one.now);
    std::size_t at = 0;
    for_each_number(*read, [&](double& x) {
      if (at + sizeof x <= size) std::memcpy(&x, bytes + at, sizeof x);
      at += sizeof x;
    });
    if (at != size) return one.log(kError, "the bytes are no state of this unit");
    *state = read.release();
    return kOk;
  });
}
// NOLINTEND(readability-identifier-naming)
