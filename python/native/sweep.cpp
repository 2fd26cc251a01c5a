// SPDX-License-Identifier: Apache-2.0
// Sweeps over arrays of parameters, by the engine of the program's own.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "driver/base/files/work_crew.hpp"
#include "driver/sweep/read_sweep.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "python/native/bindings.hpp"

namespace slipbench::python {
namespace {

namespace base = driver::base;
namespace sweep = driver::sweep;
using Settings = std::vector<std::pair<std::string, std::variant<double, std::string>>>;

/// Runs the samples. Returns the names of what was collected, its numbers, a row a sample, and why
/// which samples failed.
py::tuple swept(const std::string& text, const std::string& name, const std::string& folder,
                bool allow_outside, const Settings& settings,
                const std::vector<std::pair<std::string, std::vector<double>>>& varied,
                const std::string& collect, int threads) {
  check_threads(threads);
  const base::SourceText source(name, text);
  auto parsed = driver::read::ParsedCase::parse(source, folder);
  if (!parsed) raise_case_error(parsed.error(), {&source, 1});
  sweep::GivenSamples given{std::move(*parsed), {}};
  for (const auto& [parameter, values] : varied) {
    given.varied.push_back({parameter, {sweep::Distribution::Kind::kList, values}});
  }
  sweep::ReadSweepOptions options{.allow_outside = allow_outside};
  for (const auto& [parameter, value] : settings) options.overrides.push_back({parameter, value});
  sweep::ReadSweep read = sweep::sweep_of_samples(std::move(given), collect, options);
  read.sources.push_back(source);
  if (!read.value) raise_case_error(read.diagnostics, read.sources);
  const std::size_t width = read.value->collected.size();
  py::array_t<double> numbers(
      {static_cast<py::ssize_t>(read.value->samples), static_cast<py::ssize_t>(width)});
  double* to = numbers.mutable_data();
  std::map<std::size_t, std::string> failures;
  const Interruption interruption;
  {
    const py::gil_scoped_release released;
    sweep::run_sweep(*read.value,
                     {.threads = threads > 0 ? static_cast<unsigned>(threads) : base::core_count(),
                      .go_on = [&] { return interruption.none(); }},
                     [&](const sweep::SampleOutcome& outcome) {
                       to = std::copy(outcome.numbers.begin(), outcome.numbers.end(), to);
                       if (!outcome.failure.empty()) failures.emplace(outcome.id, outcome.failure);
                     });
  }
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  std::vector<std::string> names;
  for (const sweep::Collected& one : read.value->collected) names.push_back(one.name);
  return py::make_tuple(names, numbers, failures);
}

}  // namespace

void bind_sweep(py::module_& module) {
  module.def("sweep", swept, py::arg("text"), py::arg("name"), py::arg("folder"),
             py::arg("allow_outside"), py::arg("settings"), py::arg("varied"), py::arg("collect"),
             py::arg("threads"));
}

}  // namespace slipbench::python
