// SPDX-License-Identifier: Apache-2.0
// The update of friction definitions over arrays of increments, without a case's history.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/read/read_case.hpp"
#include "law/update/connector_tangent.hpp"
#include "law/update/penalty_update.hpp"
#include "law/update/return_mapping.hpp"
#include "python/native/bindings.hpp"

namespace slipbench::python {
namespace {

namespace base = driver::base;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

constexpr py::ssize_t kSix = law::kComponents;
/// Of a definition: elastic slip, force, accumulated slip, regime.
constexpr py::ssize_t kStateSize = 2 * kSix + 2;
/// What is told of an increment and a definition, a number each.
constexpr std::array kTold{"limit",       "normal_force",  "mu",   "slip_increment", "slip_rate",
                           "dissipation", "stored_energy", "work", "regime"};

law::FrictionState state_of(const double* numbers) {
  law::FrictionState state;
  for (std::size_t i = 0; i < law::kComponents; ++i) {
    state.elastic_slip[i] = numbers[i];
    state.force[i] = numbers[kSix + static_cast<py::ssize_t>(i)];
  }
  state.accumulated_slip = numbers[2 * kSix];
  state.regime = static_cast<law::Regime>(static_cast<int>(numbers[2 * kSix + 1]));
  return state;
}

void put_state(const law::FrictionState& state, double* numbers) {
  for (std::size_t i = 0; i < law::kComponents; ++i) {
    numbers[i] = state.elastic_slip[i];
    numbers[kSix + static_cast<py::ssize_t>(i)] = state.force[i];
  }
  numbers[2 * kSix] = state.accumulated_slip;
  numbers[2 * kSix + 1] = static_cast<double>(state.regime);
}

/// Increments that were updated. Numbers are kept in the order in which they are given out.
struct Update {
  bool single = true;
  py::ssize_t count = 0;
  py::ssize_t definitions = 1;
  std::vector<double> state;    ///< [count][definitions kStateSize]
  std::vector<double> force;    ///< [count][6], of all definitions together
  std::vector<double> told;     ///< [kTold][count][definitions]
  std::vector<double> tangent;  ///< [2][count][6][6], to motion and to force; empty if not wanted
};

py::array_t<double> array_of(const double* data, std::vector<py::ssize_t> shape, bool single) {
  if (single) shape.erase(shape.begin());
  py::array_t<double> array(shape);
  std::copy(data, data + array.size(), array.mutable_data());
  return array;
}

py::array_t<double> told_of(const Update& update, std::size_t which) {
  const py::ssize_t each = update.count * update.definitions;
  std::vector<py::ssize_t> shape{update.count};
  if (update.definitions > 1) shape.push_back(update.definitions);
  return array_of(update.told.data() + static_cast<py::ssize_t>(which) * each, shape,
                  update.single);
}

py::array_t<double> tangent_of(const Update& update, int which) {
  if (update.tangent.empty()) {
    throw py::attribute_error("no tangent was asked for: update(.., tangent=True)");
  }
  return array_of(update.tangent.data() + which * update.count * kSix * kSix,
                  {update.count, kSix, kSix}, update.single);
}

/// Array of increments, or one number for all of them.
class Column {
 public:
  Column(const std::optional<Numbers>& numbers, py::ssize_t count, py::ssize_t width, bool single,
         const char* name)
      : width_(width) {
    if (!numbers) return;
    data_ = numbers->data();
    const py::ssize_t size = numbers->size();
    if (size == count * width && (single || numbers->ndim() > (width > 1 ? 1 : 0))) {
      stride_ = width;
    } else if (size != width) {
      throw py::value_error(std::string(name) + ": wanted " + std::to_string(width) +
                            (width == 1 ? " number" : " numbers") + ", or as many for each of " +
                            std::to_string(count) + " increments, found " + std::to_string(size));
    }
  }
  const double* at(py::ssize_t i) const { return data_ == nullptr ? nullptr : data_ + i * stride_; }
  double number(py::ssize_t i, double otherwise) const {
    return data_ == nullptr ? otherwise : data_[i * stride_];
  }
  py::ssize_t width() const { return width_; }

 private:
  const double* data_ = nullptr;
  py::ssize_t stride_ = 0;
  py::ssize_t width_;
};

template <class Vector>
void take(const double* numbers, Vector& vector) {
  if (numbers == nullptr) return;
  for (int c = 0; c < law::kComponents; ++c) vector[c] = numbers[c];
}

class Law {
 public:
  explicit Law(const std::string& text) {
    const base::SourceText source("<law>", text);
    auto parsed = driver::read::ParsedCase::parse(source, ".");
    if (!parsed) raise_case_error(parsed.error(), {&source, 1});
    auto definitions = parsed->resolve_friction_only();
    if (!definitions) raise_case_error(definitions.error(), {&source, 1});
    for (driver::cases::CaseDefinition& one : *definitions) {
      if (one.backward || one.dead_zone ||
          std::holds_alternative<law::Capstan>(one.law.criterion)) {
        raise_error("SlipbenchError",
                    "a Law has no dead zones, directions or belts: run a case that has them");
      }
      names_.push_back(one.name);
      definitions_.push_back(std::move(one.law));
    }
  }

  py::ssize_t state_size() const { return kStateSize * count(); }
  const std::vector<std::string>& names() const { return names_; }

  Update update(const Numbers& state, const Numbers& motion, const std::optional<Numbers>& forces,
                const std::optional<Numbers>& begin, const std::optional<Numbers>& duration,
                const std::optional<Numbers>& temperature, const std::optional<Numbers>& fields,
                bool tangent) const {
    Update made;
    made.single = motion.ndim() == 1;
    made.count = made.single ? 1 : motion.shape(0);
    made.definitions = count();
    if (motion.size() != made.count * kSix) {
      throw py::value_error("motion: wanted 6 components, or rows of 6");
    }
    const Column states(state, made.count, state_size(), made.single, "state");
    const Column motions(motion, made.count, kSix, made.single, "motion");
    const Column constraint(forces, made.count, kSix, made.single, "forces");
    const Column begins(begin, made.count, kSix, made.single, "begin");
    const Column durations(duration, made.count, 1, made.single, "duration");
    const Column temperatures(temperature, made.count, 1, made.single, "temperature");
    const py::ssize_t field_count = !fields               ? 0
                                    : fields->ndim() == 0 ? 1
                                                          : fields->shape(fields->ndim() - 1);
    const Column all_fields(fields, made.count, std::max<py::ssize_t>(1, field_count), made.single,
                            "fields");
    made.state.resize(static_cast<std::size_t>(made.count * state_size()));
    made.force.resize(static_cast<std::size_t>(made.count * kSix));
    made.told.resize(kTold.size() * static_cast<std::size_t>(made.count * count()));
    if (tangent) made.tangent.resize(static_cast<std::size_t>(2 * made.count * kSix * kSix));
    const std::array<double, 16> no_fields{};
    const auto step = [&](py::ssize_t i) {
      law::ConnectorIncrement increment;
      increment.duration = durations.number(i, 1.0);
      take(begins.at(i), increment.begin_position);
      for (int c = 0; c < law::kComponents; ++c) {
        increment.end.position[c] = increment.begin_position[c] + motions.at(i)[c];
        increment.end.motion[c] = increment.end.position[c];
      }
      take(constraint.at(i), increment.force);
      increment.end.temperature = temperatures.number(i, 0.0);
      increment.end.fields =
          fields ? std::span(all_fields.at(i), static_cast<std::size_t>(field_count))
                 : std::span<const double>(no_fields);
      for (py::ssize_t d = 0; d < count(); ++d) put(made, increment, states.at(i), i, d);
    };
    if (made.count > kLong) {
      const py::gil_scoped_release released;
      for (py::ssize_t i = 0; i < made.count; ++i) step(i);
    } else {
      for (py::ssize_t i = 0; i < made.count; ++i) step(i);
    }
    return made;
  }

 private:
  /// From so many increments on other threads are worth a switch.
  static constexpr py::ssize_t kLong = 64;

  py::ssize_t count() const { return static_cast<py::ssize_t>(definitions_.size()); }

  void put(Update& made, const law::ConnectorIncrement& increment, const double* states,
           py::ssize_t i, py::ssize_t d) const {
    const law::FrictionDefinition& definition = definitions_[static_cast<std::size_t>(d)];
    const law::FrictionState old = state_of(states + d * kStateSize);
    const law::FrictionUpdate one = definition.formulation
                                        ? law::update_penalty(definition, increment, old)
                                        : law::update(definition, increment, old);
    put_state(one.state, made.state.data() + i * state_size() + d * kStateSize);
    const law::ConnectorForce force = law::friction_force(definition, one.state);
    double* const sum = made.force.data() + i * kSix;
    for (int c = 0; c < law::kComponents; ++c) sum[c] += force[c];
    const std::array<double, kTold.size()> told{
        one.limit,          one.normal_force, one.mu,
        one.slip_increment, one.slip_rate,    one.dissipation,
        one.stored_energy,  one.work,         static_cast<double>(one.state.regime)};
    const py::ssize_t each = made.count * count();
    for (std::size_t k = 0; k < told.size(); ++k) {
      made.told[static_cast<std::size_t>(static_cast<py::ssize_t>(k) * each + i * count() + d)] =
          told[k];
    }
    if (made.tangent.empty()) return;
    const law::ConnectorTangent slope = law::connector_tangent(definition, increment, one);
    double* const to_motion = made.tangent.data() + i * kSix * kSix;
    double* const to_force = to_motion + made.count * kSix * kSix;
    for (int row = 0; row < law::kComponents; ++row) {
      for (int column = 0; column < law::kComponents; ++column) {
        to_motion[row * kSix + column] += slope.to_motion(row, column);
        to_force[row * kSix + column] += slope.to_force(row, column);
      }
    }
  }

  std::vector<law::FrictionDefinition> definitions_;
  std::vector<std::string> names_;
};

}  // namespace

void bind_law(py::module_& module) {
  py::class_<Update> update(module, "Update");
  update
      .def_property_readonly("state",
                             [](const Update& one) {
                               return array_of(one.state.data(),
                                               {one.count, one.definitions * kStateSize},
                                               one.single);
                             })
      .def_property_readonly("force",
                             [](const Update& one) {
                               return array_of(one.force.data(), {one.count, kSix}, one.single);
                             })
      .def_property_readonly("tangent", [](const Update& one) { return tangent_of(one, 0); })
      .def_property_readonly("force_tangent", [](const Update& one) { return tangent_of(one, 1); });
  for (std::size_t k = 0; k < kTold.size(); ++k) {
    update.def_property_readonly(kTold[k], [k](const Update& one) { return told_of(one, k); });
  }
  py::class_<Law>(module, "Law")
      .def(py::init<const std::string&>(), py::arg("text"))
      .def("update", &Law::update, py::arg("state"), py::arg("motion"),
           py::arg("forces") = py::none(), py::arg("begin") = py::none(),
           py::arg("duration") = py::none(), py::arg("temperature") = py::none(),
           py::arg("fields") = py::none(), py::arg("tangent") = false)
      .def_property_readonly("state_size", &Law::state_size)
      .def_property_readonly("names", &Law::names);
}

}  // namespace slipbench::python
