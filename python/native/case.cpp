// SPDX-License-Identifier: Apache-2.0
// Cases and their runs: numbers stay where the run has put them, and NumPy looks at them.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <utility>

#include "driver/analysis/recorded_run.hpp"
#include "driver/base/text/json.hpp"
#include "driver/base/units/units.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/read/read_case.hpp"
#include "driver/results/result_layout.hpp"
#include "python/native/bindings.hpp"

namespace slipbench::python {
namespace {

namespace base = driver::base;

/// Result of a run. The case that it is of lives as long.
struct Run {
  std::shared_ptr<const driver::cases::Case> problem;
  driver::analysis::RecordedRun record;
};

using Settings = std::vector<std::pair<std::string, std::variant<double, std::string>>>;

/// Text of a case with values for its parameters; resolved when it is asked for.
class Case {
 public:
  Case(base::SourceText source, std::string folder, bool allow_outside, const Settings& settings)
      : source_(std::move(source)), folder_(std::move(folder)), allow_outside_(allow_outside) {
    for (const auto& [name, value] : settings) overrides_.push_back({name, value});
    resolve();
    if (const auto parsed = driver::read::ParsedCase::parse(source_, folder_)) {
      if (const auto parameters = parsed->root().find("parameters")) {
        for (const auto& entry : parameters->entries()) order_.emplace_back(entry.key.text());
      }
    }
  }

  const driver::cases::Case& problem() const { return *problem_; }

  void set(const Settings& values) {
    std::vector<base::ParameterText> before = overrides_;
    for (const auto& [name, value] : values) {
      std::erase_if(overrides_, [&own = name](const auto& one) { return one.name == own; });
      overrides_.push_back({name, value});
    }
    try {
      resolve();
    } catch (...) {
      overrides_ = std::move(before);
      throw;
    }
  }

  std::shared_ptr<Run> run(int every, bool with_checks, const std::vector<std::string>& columns) {
    auto run = std::make_shared<Run>();
    const Interruption interruption;
    const base::Diagnostics reading = diagnostics_;  // another thread may set parameters meanwhile
    run->problem = problem_;
    const driver::analysis::RecordOptions options{
        .every = every, .with_checks = with_checks, .columns = columns, .go_on = [&] {
          return interruption.none();
        }};
    auto record = [&] {
      const py::gil_scoped_release released;
      return driver::analysis::record_run(*run->problem, reading, options);
    }();
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
    if (!record) {
      raise_error("RunError", driver::bench::failure_text(*run->problem, record.error()));
    }
    run->record = std::move(*record);
    return run;
  }

  const base::SourceText& source() const { return source_; }
  const std::string& folder() const { return folder_; }
  bool allow_outside() const { return allow_outside_; }
  /// Names of the parameters in the order of the text.
  const std::vector<std::string>& order() const { return order_; }
  Settings overrides() const {
    Settings all;
    for (const base::ParameterText& one : overrides_) all.emplace_back(one.name, one.value);
    return all;
  }

 private:
  void resolve() {
    driver::read::ReadCase read = driver::read::read_case_text(
        source_, folder_, {.overrides = overrides_, .allow_outside = allow_outside_});
    if (!read.value) raise_case_error(read.diagnostics, read.sources);
    warn_all(read.diagnostics, read.sources);
    problem_ = std::make_shared<const driver::cases::Case>(std::move(*read.value));
    diagnostics_ = std::move(read.diagnostics);
  }

  base::SourceText source_;
  std::string folder_;
  bool allow_outside_;
  std::vector<std::string> order_;
  std::vector<base::ParameterText> overrides_;
  std::shared_ptr<const driver::cases::Case> problem_;
  base::Diagnostics diagnostics_;
};

/// A column as an array that keeps its run alive.
py::array column_of(const py::object& self, const std::string& name) {
  const Run& run = self.cast<const Run&>();
  const auto& record = run.record;
  for (std::size_t c = 0; c < record.columns.size(); ++c) {
    if (record.columns[c].name != name) continue;
    py::array_t<double> view({static_cast<py::ssize_t>(record.rows)},
                             {static_cast<py::ssize_t>(sizeof(double))},
                             record.numbers.get() + c * record.stride, self);
    view.attr("flags").attr("writeable") = false;
    return view;
  }
  throw py::key_error(name);
}

std::string unit_of(const Run& run, const driver::results::Column& column) {
  return base::unit_text(column.dimension, run.problem->units);
}

/// Name of each definition, whether CSFC is its total force, and the columns of its components.
py::list friction_of(const driver::cases::Case& problem) {
  py::list all;
  for (const auto& one : driver::results::friction_columns(problem)) {
    all.append(py::make_tuple(one.name, one.coupled, one.forces));
  }
  return all;
}

py::list events_of(const Run& run) {
  py::list events;
  for (const auto& [event, positions] : run.record.events) {
    py::dict one;
    one["time"] = event.time;
    one["definition"] = run.problem->definitions[event.definition].name;
    one["origin"] = driver::results::regime_name(event.from);
    one["goal"] = driver::results::goal_name(event);
    one["force"] = event.force;
    one["limit"] = event.limit;
    one["accumulated_slip"] = event.accumulated_slip;
    py::dict places;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      places[py::str(run.record.positions[i])] = positions[i];
    }
    one["positions"] = places;
    events.append(one);
  }
  return events;
}

base::SourceText source_of(const std::string& path) {
  auto source = base::read_source(path);
  if (source) return std::move(*source);
  base::Diagnostics diagnostics;
  diagnostics.add(source.error().diagnostic);
  raise_case_error(diagnostics, {});
}

std::string parent_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

void bind_case(py::module_& module) {
  py::class_<Run, std::shared_ptr<Run>>(module, "Run")
      .def(
          "column",
          [](const py::object& self, const std::string& name) { return column_of(self, name); },
          py::arg("name"))
      .def_property_readonly("columns",
                             [](const Run& run) {
                               std::vector<std::string> names;
                               for (const auto& one : run.record.columns) names.push_back(one.name);
                               return names;
                             })
      .def_property_readonly("units",
                             [](const Run& run) {
                               py::dict units;
                               for (const auto& one : run.record.columns) {
                                 units[py::str(one.name)] = unit_of(run, one);
                               }
                               return units;
                             })
      .def_property_readonly("texts",
                             [](const Run& run) {
                               py::dict texts;
                               for (const auto& one : run.record.columns) {
                                 texts[py::str(one.name)] = one.text;
                               }
                               return texts;
                             })
      .def_property_readonly("friction", [](const Run& run) { return friction_of(*run.problem); })
      .def_property_readonly("rows", [](const Run& run) { return run.record.rows; })
      .def_property_readonly("title", [](const Run& run) { return run.problem->title; })
      .def_property_readonly("events", events_of)
      .def_property_readonly("warnings", [](const Run& run) { return run.record.warnings; })
      .def_property_readonly("document", [](const Run& run) { return run.record.document.dump(); });
  py::class_<Case>(module, "Case")
      .def(py::init([](const std::string& path, bool allow_outside, const Settings& settings) {
             return std::make_unique<Case>(source_of(path), parent_of(path), allow_outside,
                                           settings);
           }),
           py::arg("path"), py::arg("allow_outside"), py::arg("settings"))
      .def_static(
          "of_text",
          [](const std::string& text, const std::string& name, const std::string& folder,
             bool allow_outside, const Settings& settings) {
            return std::make_unique<Case>(base::SourceText(name, text), folder, allow_outside,
                                          settings);
          },
          py::arg("text"), py::arg("name"), py::arg("folder"), py::arg("allow_outside"),
          py::arg("settings"))
      .def("copy", [](const Case& one) { return std::make_unique<Case>(one); })
      .def("set", &Case::set, py::arg("values"))
      .def("run", &Case::run, py::arg("every"), py::arg("checks"), py::arg("columns"))
      .def_property_readonly("parameters",
                             [](const Case& one) {
                               py::dict values;
                               for (const std::string& name : one.order()) {
                                 values[py::str(name)] = one.problem().parameters.at(name);
                               }
                               return values;
                             })
      .def_property_readonly("title", [](const Case& one) { return one.problem().title; })
      .def_property_readonly("text",
                             [](const Case& one) { return std::string(one.source().text()); })
      .def_property_readonly("folder", &Case::folder)
      .def_property_readonly("friction", [](const Case& one) { return friction_of(one.problem()); })
      .def_property_readonly(
          "columns", [](const Case& one) { return driver::results::column_names(one.problem()); })
      .def_property_readonly("allow_outside", &Case::allow_outside)
      .def_property_readonly("overrides", [](const Case& one) { return one.overrides(); })
      .def_property_readonly("name", [](const Case& one) { return one.source().name(); })
      .def_property_readonly("definitions", [](const Case& one) {
        std::vector<std::string> names;
        for (const auto& each : one.problem().definitions) names.push_back(each.name);
        return names;
      });
}

}  // namespace slipbench::python
