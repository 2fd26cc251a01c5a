// SPDX-License-Identifier: Apache-2.0
// The update of friction definitions over arrays of increments, without a case's history.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "c/handle.hpp"
#include "c/slip_law.h"
#include "driver/read/law_only.hpp"
#include "python/native/bindings.hpp"

namespace slipbench::python {
namespace {

namespace base = driver::base;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

constexpr py::ssize_t kSix = SLIP_COMPONENTS;
constexpr py::ssize_t kStateSize = SLIP_STATE_NUMBERS;

/// A number of an update, of each definition.
struct Told {
  const char* name;
  const char* text;
  double (*of)(const slip_result& result);
};
constexpr std::array kTold{
    Told{"limit", "Limit of the friction force, F_lim [F].",
         [](const slip_result& one) { return one.limit; }},
    Told{"normal_force", "Normal force, F_N [F].",
         [](const slip_result& one) { return one.normal_force; }},
    Told{"mu", "Coefficient used [1].", [](const slip_result& one) { return one.mu; }},
    Told{"slip_increment", "Equivalent slip of the increment [L].",
         [](const slip_result& one) { return one.slip_increment; }},
    Told{"slip_rate", "Slip rate that the coefficient saw [L/T].",
         [](const slip_result& one) { return one.slip_rate; }},
    Told{"dissipation", "Dissipated energy of the increment [F L], never negative.",
         [](const slip_result& one) { return one.dissipation; }},
    Told{"stored_energy", "Energy of the elastic slip at the end [F L].",
         [](const slip_result& one) { return one.stored_energy; }},
    Told{"work", "Work of the friction force over the increment [F L].",
         [](const slip_result& one) { return one.work; }},
    Told{"regime", "slipbench.OPEN, STICK or SLIP.",
         [](const slip_result& one) { return static_cast<double>(one.regime); }}};

/// Increments that were updated. Numbers are kept in the order in which they are given out.
struct Update {
  bool single = true;
  py::ssize_t count = 0;
  py::ssize_t definitions = 1;
  bool has_tangent = false;
  /// State [count][definitions kStateSize], force [count][6] of all definitions together, told
  /// [kTold][count][definitions], tangent [2][count][6][6] to motion and to force if it is wanted.
  std::vector<double> numbers;

  void make_room() {
    numbers.resize(
        static_cast<std::size_t>(tangent_at() + (has_tangent ? 2 * count * kSix * kSix : 0)));
  }
  py::ssize_t force_at() const { return count * definitions * kStateSize; }
  py::ssize_t told_at() const { return force_at() + count * kSix; }
  py::ssize_t tangent_at() const {
    return told_at() + static_cast<py::ssize_t>(kTold.size()) * count * definitions;
  }
  double* state() { return numbers.data(); }
  double* force() { return numbers.data() + force_at(); }
  double* told() { return numbers.data() + told_at(); }
  double* tangent() { return numbers.data() + tangent_at(); }
};

py::array_t<double> array_of(const double* data, std::vector<py::ssize_t> shape, bool single) {
  if (single) shape.erase(shape.begin());
  py::array_t<double> array(shape);
  std::copy(data, data + array.size(), array.mutable_data());
  return array;
}

py::array_t<double> told_of(Update& update, std::size_t which) {
  const py::ssize_t each = update.count * update.definitions;
  std::vector<py::ssize_t> shape{update.count};
  if (update.definitions > 1) shape.push_back(update.definitions);
  return array_of(update.told() + static_cast<py::ssize_t>(which) * each, shape, update.single);
}

py::array_t<double> tangent_of(Update& update, int which) {
  if (!update.has_tangent) {
    throw py::attribute_error("no tangent was asked for: update(.., tangent=True)");
  }
  return array_of(update.tangent() + which * update.count * kSix * kSix, {update.count, kSix, kSix},
                  update.single);
}

std::string shape_of(const Numbers& numbers) {
  std::string text = "(";
  for (py::ssize_t k = 0; k < numbers.ndim(); ++k)
    text += (k > 0 ? ", " : "") + std::to_string(numbers.shape(k));
  return text + (numbers.ndim() == 1 ? ",)" : ")");
}

/// Array of increments, a row each, or one row for all of them.
class Column {
 public:
  /// \param width of a row; 1: a number for each, and a row need not be an array
  Column(const std::optional<Numbers>& numbers, py::ssize_t count, py::ssize_t width,
         const char* name, bool number)
      : width_(width) {
    if (!numbers) return;
    data_ = numbers->data();
    const py::ssize_t dimension = numbers->ndim();
    const py::ssize_t first = dimension > 0 ? numbers->shape(0) : 1;
    const bool rows = dimension == 2 && numbers->shape(1) == width;
    bool fits = false;
    if (number) {
      fits = dimension == 0 || dimension == 1 || rows;
    } else {
      fits = rows || (dimension == 1 && first == width);
      if (!rows && fits) return;
    }
    fits = fits && (first == count || first == 1);
    if (!fits) {
      const std::string each = std::to_string(width);
      const std::string all = std::to_string(count);
      throw py::value_error(
          std::string(name) + ": wanted " +
          (number ? "a number, or an array of shape (" + all + ",)"
                  : "an array of shape (" + each + ",) or (" + all + ", " + each + ")") +
          ", found shape " + shape_of(*numbers));
    }
    if (first == count) stride_ = width;
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

/// Counts fields: (F,) are those of all increments, (N, F) those of each. A list as
/// long as there are increments could be either, and is refused.
py::ssize_t count_of_fields(const std::optional<Numbers>& fields, py::ssize_t count) {
  if (!fields) return 0;
  const py::ssize_t dimension = fields->ndim();
  const py::ssize_t each = dimension == 0 ? 1 : fields->shape(dimension - 1);
  if (dimension == 1 && each == count && count > 1) {
    const std::string n = std::to_string(count);
    throw py::value_error("fields: shape (" + n + ",) may be a field for each of " + n +
                          " increments or " + n + " fields for all: say which by shape (" + n +
                          ", 1) or (1, " + n + ")");
  }
  if (each > SLIP_FIELDS) {
    throw py::value_error("fields: wanted " + std::to_string(SLIP_FIELDS) +
                          " at most, found shape " + shape_of(*fields));
  }
  return each;
}

/// Refuses durations that no increment has.
void check_durations(const Column& durations, py::ssize_t count) {
  for (py::ssize_t i = 0; i < count; ++i) {
    const double duration = durations.number(i, 1.0);
    if (duration >= 0.0 && std::isfinite(duration)) continue;
    throw py::value_error("duration: wanted 0 or more, found " +
                          std::string(py::str(py::float_(duration))));
  }
}

void take(const double* numbers, double* to) {
  if (numbers != nullptr) std::copy_n(numbers, kSix, to);
}

class Law {
 public:
  explicit Law(const std::string& text) {
    const base::SourceText source("<law>", text);
    auto read = driver::read::read_law_only(source, ".");
    if (!read) raise_case_error(read.error(), {&source, 1});
    names_ = std::move(read->names);
    law_.definitions = std::move(read->definitions);
  }
  /// Makes a law of packed numbers, which hold no names.
  Law(const Numbers& numbers, std::vector<std::string> names) : names_(std::move(names)) {
    slip_error error;
    slip_law* const made =
        slip_law_unpack(numbers.data(), static_cast<std::size_t>(numbers.size()), &error);
    if (made == nullptr) throw py::value_error(error.message);
    law_ = std::move(*made);
    slip_law_destroy(made);
    if (names_.empty()) names_.resize(law_.definitions.size());
    if (names_.size() != law_.definitions.size()) {
      throw py::value_error("names: wanted " + std::to_string(law_.definitions.size()) +
                            ", one of each definition, found " + std::to_string(names_.size()));
    }
  }

  py::array_t<double> numbers() const {
    py::array_t<double> packed(static_cast<py::ssize_t>(slip_law_pack(&law_, nullptr, 0)));
    slip_law_pack(&law_, packed.mutable_data(), static_cast<std::size_t>(packed.size()));
    return packed;
  }

  py::ssize_t state_size() const { return kStateSize * count(); }
  const std::vector<std::string>& names() const { return names_; }

  Update update(const Numbers& state, const Numbers& motion, const std::optional<Numbers>& forces,
                const std::optional<Numbers>& begin, const std::optional<Numbers>& duration,
                const std::optional<Numbers>& temperature, const std::optional<Numbers>& fields,
                bool tangent, const std::optional<Numbers>& end,
                const std::optional<Numbers>& reference) const {
    Update made;
    made.single = motion.ndim() == 1;
    made.count = made.single ? 1 : motion.shape(0);
    made.definitions = count();
    if (motion.ndim() < 1 || motion.ndim() > 2 || motion.shape(motion.ndim() - 1) != kSix) {
      throw py::value_error("motion: wanted 6 components, or rows of 6, found shape " +
                            shape_of(motion));
    }
    const py::ssize_t n = made.count;
    const Column states(state, n, state_size(), "state", false);
    const Column motions(motion, n, kSix, "motion", false);
    const Column constraint(forces, n, kSix, "forces", false);
    const Column begins(begin, n, kSix, "begin", false);
    const Column ends(end, n, kSix, "end", false);
    const Column references(reference, n, kSix, "reference", false);
    const Column durations(duration, n, 1, "duration", true);
    check_durations(durations, n);
    const Column temperatures(temperature, n, 1, "temperature", true);
    const py::ssize_t field_count = count_of_fields(fields, n);
    const bool one_field = fields && fields->ndim() == 0;
    const Column all_fields(fields, n, std::max<py::ssize_t>(1, field_count), "fields", one_field);
    made.has_tangent = tangent;
    made.make_room();
    const auto step = [&](py::ssize_t i) {
      slip_increment increment{};
      increment.duration = durations.number(i, 1.0);
      take(begins.at(i), increment.begin);
      for (int c = 0; c < kSix; ++c) increment.end[c] = increment.begin[c] + motions.at(i)[c];
      take(ends.at(i), increment.end);
      take(references.at(i), increment.reference);
      take(constraint.at(i), increment.force);
      increment.temperature = temperatures.number(i, 0.0);
      increment.fields = all_fields.at(i);
      increment.field_count = static_cast<std::size_t>(field_count);
      return put(made, increment, states.at(i), i);
    };
    Failure failure;
    const auto all = [&] {
      for (py::ssize_t i = 0; i < made.count && failure.error.status == SLIP_OK; ++i) {
        failure = {i, step(i)};
      }
    };
    if (made.count > kLong) {
      const py::gil_scoped_release released;
      all();
    } else {
      all();
    }
    if (failure.error.status != SLIP_OK) {
      const std::string place =
          made.single ? "" : "increment " + std::to_string(failure.increment) + ": ";
      raise_error("RunError", place + failure.error.message);
    }
    return made;
  }

 private:
  /// From so many increments on other threads are worth a switch.
  static constexpr py::ssize_t kLong = 64;

  struct Failure {
    py::ssize_t increment = 0;
    slip_error error{};
  };

  py::ssize_t count() const { return static_cast<py::ssize_t>(law_.definitions.size()); }

  slip_error put(Update& made, const slip_increment& increment, const double* old_state,
                 py::ssize_t i) const {
    slip_error error;
    std::array<slip_result, SLIP_DEFINITIONS> results;
    double* const state = made.state() + i * state_size();
    double* const force = made.force() + i * kSix;
    if (!made.has_tangent) {
      slip_law_update(&law_, &increment, old_state, state, force, results.data(), &error);
    } else {
      double* const to_motion = made.tangent() + i * kSix * kSix;
      slip_law_tangent(&law_, &increment, old_state, state, force, results.data(), to_motion,
                       to_motion + made.count * kSix * kSix, &error);
    }
    const py::ssize_t each = made.count * count();
    for (std::size_t k = 0; k < kTold.size(); ++k) {
      double* const column = made.told() + static_cast<py::ssize_t>(k) * each + i * count();
      for (py::ssize_t d = 0; d < count(); ++d) {
        column[d] = kTold[k].of(results[static_cast<std::size_t>(d)]);
      }
    }
    return error;
  }

  slip_law law_;
  std::vector<std::string> names_;
};

/// The array of an argument; nothing for None. One that is as wanted is not copied.
std::optional<Numbers> numbers_of(PyObject* argument, const char* name) {
  if (argument == Py_None) return std::nullopt;
  const py::handle given(argument);
  if (Numbers::check_(given)) return py::reinterpret_borrow<Numbers>(given);
  Numbers made = Numbers::ensure(given);
  if (!made) throw py::value_error(std::string(name) + ": wanted numbers");
  return made;
}

constexpr std::array kArguments{"state",       "motion", "forces",  "begin", "duration",
                                "temperature", "fields", "tangent", "end",   "reference"};

/// Law.update of a row of all its arguments. pybind11's own way to a function takes as long as the
/// increment and all of this.
PyObject* update_of(PyObject* self, PyObject* const* given, Py_ssize_t count) noexcept {
  try {
    if (count != static_cast<Py_ssize_t>(kArguments.size()))
      throw py::type_error("update: wanted 10 arguments");
    const auto at = [&](std::size_t i) { return numbers_of(given[i], kArguments[i]); };
    const int tangent = PyObject_IsTrue(given[7]);
    if (tangent < 0) throw py::error_already_set();
    const auto state = at(0);
    const auto motion = at(1);
    if (!state || !motion) throw py::value_error("update: wanted a state and a motion");
    const Law& law = py::cast<const Law&>(py::handle(self));
    return py::cast(law.update(*state, *motion, at(2), at(3), at(4), at(5), at(6), tangent != 0,
                               at(8), at(9)))
        .release()
        .ptr();
  } catch (py::error_already_set& error) {
    error.restore();
  } catch (const py::builtin_exception& error) {
    error.set_error();
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
  }
  return nullptr;
}

}  // namespace

void bind_law(py::module_& module) {
  py::class_<Update> update(module, "Update",
                            "Increments that were updated: a row of each array is one of them.");
  update
      .def_property_readonly(
          "state",
          [](Update& one) {
            return array_of(one.state(), {one.count, one.definitions * kStateSize}, one.single);
          },
          "States at the end, as `update` takes them.")
      .def_property_readonly(
          "force",
          [](Update& one) {
            return array_of(one.force(), {one.count, kSix}, one.single);
          },
          "Friction forces and moments on the six components [F, F L].")
      .def_property_readonly(
          "tangent", [](Update& one) { return tangent_of(one, 0); },
          "Slopes of the force to the positions at the end, 6 by 6.")
      .def_property_readonly(
          "force_tangent", [](Update& one) { return tangent_of(one, 1); },
          "Slopes of the force to the constraint forces at the end, 6 by 6.");
  for (std::size_t k = 0; k < kTold.size(); ++k) {
    update.def_property_readonly(
        kTold[k].name, [k](Update& one) { return told_of(one, k); }, kTold[k].text);
  }
  py::class_<Law> law(module, "Law");
  law.def(py::init<const std::string&>(), py::arg("text"))
      .def(py::init<const Numbers&, std::vector<std::string>>(), py::arg("numbers"),
           py::arg("names") = std::vector<std::string>())
      .def_property_readonly("numbers", &Law::numbers)
      .def_property_readonly("state_size", &Law::state_size)
      .def_property_readonly("names", &Law::names);
  static PyMethodDef update_method{
      "update", reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(update_of)),
      METH_FASTCALL, nullptr};
  law.attr("update") = py::reinterpret_steal<py::object>(
      PyDescr_NewMethod(reinterpret_cast<PyTypeObject*>(law.ptr()), &update_method));
}

}  // namespace slipbench::python
