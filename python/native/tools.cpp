// SPDX-License-Identifier: Apache-2.0
// Suites of cases, fits and closed forms.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "driver/calibrate/calibrate.hpp"
#include "driver/calibrate/calibrated_case.hpp"
#include "driver/calibrate/calibration_json.hpp"
#include "driver/calibrate/fit_summary.hpp"
#include "driver/calibrate/fit_text.hpp"
#include "driver/calibrate/read_fit.hpp"
#include "driver/suite/candidates.hpp"
#include "python/native/bindings.hpp"
#include "reference/catalogue.hpp"

namespace slipbench::python {
namespace {

namespace base = driver::base;
namespace calibrate = driver::calibrate;

py::dict calibrated(const std::string& path, const std::map<std::string, double>& values,
                    std::optional<int> bootstrap, bool profile, int threads, bool allow_outside) {
  check_threads(threads);
  if (bootstrap && (*bootstrap < 0 || *bootstrap > calibrate::kMostResamplings)) {
    throw py::value_error("bootstrap: wanted 0 to " + std::to_string(calibrate::kMostResamplings) +
                          ", found " + std::to_string(*bootstrap));
  }
  std::vector<base::ParameterText> overrides;
  overrides.reserve(values.size());
  for (const auto& [name, value] : values) overrides.push_back({name, value});
  calibrate::ReadFit read = calibrate::read_fit(path, {overrides, allow_outside});
  if (!read.value || read.diagnostics.has_errors()) {
    raise_case_error(read.diagnostics, read.sources);
  }
  warn_all(read.diagnostics, read.sources);
  calibrate::Fit& fit = *read.value;
  if (bootstrap) fit.bootstrap = *bootstrap;
  fit.profile = fit.profile || profile;
  struct Interrupted {};
  const Interruption interruption;
  auto found = [&]() -> decltype(calibrate::calibrate(fit)) {
    const py::gil_scoped_release released;
    const calibrate::CalibrateProgress progress{[&](const calibrate::CalibrateStep&) {
      if (!interruption.none()) throw Interrupted{};
    }};
    try {
      return calibrate::calibrate(fit, progress, {.threads = static_cast<unsigned>(threads)});
    } catch (const Interrupted&) {
      return tl::unexpected(calibrate::CalibrationFailure{});
    }
  }();
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  if (!found) raise_error("RunError", found.error().message);
  py::dict result;
  result["document"] = calibrate::calibration_json(fit, *found).dump();
  result["text"] = calibrate::fit_summary(fit, *found);
  py::dict cases;
  for (const calibrate::CalibratedCase& one : calibrate::calibrated_cases(fit, *found, "").cases) {
    cases[py::str(one.file_name)] = one.text;
  }
  result["cases"] = cases;
  return result;
}

/// Returns path and fault of each case that `slipbench check` finds; the fault is mostly empty.
std::vector<std::pair<std::string, std::string>> found_cases(const std::vector<std::string>& paths,
                                                             bool allow_outside) {
  std::vector<std::pair<std::string, std::string>> all;
  for (auto& one : driver::suite::find_candidates(paths, allow_outside)) {
    all.emplace_back(std::move(one.path), std::move(one.fault));
  }
  return all;
}

py::dict described(const reference::ClosedForm& form) {
  const auto listed = [](std::span<const reference::Signal> signals) {
    py::list list;
    for (const reference::Signal& one : signals) {
      list.append(
          py::make_tuple(std::string(one.name), std::string(one.dimension), std::string(one.text)));
    }
    return list;
  };
  py::dict entry;
  entry["name"] = std::string(form.name);
  entry["title"] = std::string(form.title);
  entry["formula"] = std::string(form.formula);
  entry["source"] = std::string(form.source);
  entry["range"] = std::string(form.range);
  py::list parameters;
  for (const reference::Parameter& one : form.parameters) {
    py::dict parameter;
    parameter["name"] = std::string(one.name);
    parameter["dimension"] = std::string(one.dimension);
    parameter["text"] = std::string(one.text);
    parameter["default"] =
        one.default_value ? py::object(py::float_(*one.default_value)) : py::object(py::none());
    parameter["list"] = one.list;
    parameters.append(parameter);
  }
  entry["parameters"] = parameters;
  entry["inputs"] = listed(form.inputs);
  entry["outputs"] = listed(form.outputs);
  return entry;
}

void check_bounds(const reference::Parameter& parameter, const std::vector<double>& values) {
  for (const double value : values) {
    const bool low =
        parameter.lower_open ? !(value > parameter.lower) : !(value >= parameter.lower);
    if (low || !(value <= parameter.upper)) {
      throw py::value_error(std::string(parameter.name) + ": " + std::to_string(value) +
                            " is out of its range");
    }
  }
}

/// The outputs of a closed form along a path, a row each.
py::array_t<double> evaluated(
    const std::string& name, const std::vector<std::vector<double>>& parameters,
    const py::array_t<double, py::array::c_style | py::array::forcecast>& inputs) {
  const reference::ClosedForm* const form = reference::find(name);
  if (form == nullptr) throw py::key_error(name);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    check_bounds(form->parameters[i], parameters[i]);
  }
  if (const auto fault = form->violation(parameters)) throw py::value_error(*fault);
  const auto rows = inputs.shape(0);
  const auto width = static_cast<py::ssize_t>(form->inputs.size());
  const auto made = static_cast<py::ssize_t>(form->outputs.size());
  py::array_t<double> outputs({rows, made});
  const reference::PathEvaluator step = form->make(parameters);
  double* const to = outputs.mutable_data();
  for (py::ssize_t row = 0; row < rows; ++row) {
    step({inputs.data() + row * width, static_cast<std::size_t>(width)},
         {to + row * made, static_cast<std::size_t>(made)});
  }
  return outputs;
}

}  // namespace

void bind_tools(py::module_& module) {
  module.def("find_cases", found_cases, py::arg("paths"), py::arg("allow_outside"));
  module.def("calibrate", calibrated, py::arg("path"), py::arg("values"), py::arg("bootstrap"),
             py::arg("profile"), py::arg("threads"), py::arg("allow_outside"));
  module.def("closed_forms", [] {
    py::list all;
    for (const reference::ClosedForm& form : reference::catalogue()) all.append(described(form));
    return all;
  });
  module.def("closed_form", evaluated, py::arg("name"), py::arg("parameters"), py::arg("inputs"));
}

}  // namespace slipbench::python
