// SPDX-License-Identifier: Apache-2.0
#include "driver/report/drawn_columns.hpp"

#include <algorithm>
#include <unordered_set>

#include "driver/results/plot_data.hpp"

namespace slipbench::driver::report {
namespace {

/// More columns than these are not drawn.
constexpr std::size_t kMostColumns = 24;

class Choice {
 public:
  explicit Choice(const results::ResultLayout& layout)
      : layout_(layout), columns_(layout.columns.begin(), layout.columns.end()) {}

  DrawnColumns take() && { return std::move(drawn_); }

  /// Takes what a picture of friction needs; never left out.
  void take_friction() {
    const results::PlotData plot = results::select_plot_columns(layout_);
    for (const results::PlotColumn& column : plot.columns) add(column.name);
    const auto name = [&](int column) {
      return column < 0 ? std::string() : plot.columns[static_cast<std::size_t>(column)].name;
    };
    for (const results::PlotDefinition& definition : plot.definitions) {
      ReportDefinition one;
      one.name = definition.name;
      one.force = name(definition.total >= 0 ? definition.total : definition.components.front());
      for (const int force : definition.components) one.forces.push_back(name(force));
      for (const int position : definition.positions) one.positions.push_back(name(position));
      one.limit = name(definition.limit);
      one.limit_below = name(definition.limit_below);
      one.status = name(definition.status);
      drawn_.definitions.push_back(std::move(one));
      if (drawn_.definitions.size() == 1) {
        for (const int position : definition.positions) {
          if (position >= 0) drawn_.motions.push_back(static_cast<std::size_t>(position));
        }
      }
      several_ = definition.several;
    }
    for (ReportDefinition& definition : drawn_.definitions) {
      definition.filtered = has_column("ALPHA" + suffix_of(definition));
    }
  }

  void take_energies() {
    for (const ReportDefinition& definition : drawn_.definitions) {
      const std::string suffix = suffix_of(definition);
      take_energy("work", "WORK" + suffix);
      take_energy("dissipated", "DISS" + suffix);
      take_energy("stored", "STRAIN_E" + suffix);
      take_energy("lost", "LOST" + suffix);
    }
    take_energy("dissipated", "VISCOUS_DISS");
    take_energy("stored", "ELASTIC_E");
    take_energy("kinetic", "KINETIC_E");
    take_energy("external", "EXTERNAL_WORK");
  }

  void take_coefficients() {
    for (ReportDefinition& definition : drawn_.definitions) {
      const std::string suffix = suffix_of(definition);
      definition.normal_force = take("FN" + suffix);
      definition.mu = take("MU" + suffix);
    }
  }

 private:
  std::string suffix_of(const ReportDefinition& definition) const {
    return several_ ? "." + definition.name : "";
  }

  bool has_column(const std::string& name) const { return columns_.contains(name); }

  void add(const std::string& name) {
    drawn_.names.push_back(name);
    names_.insert(name);
  }

  /// The name if the result has such a column and there is room for it, else nothing.
  std::string take(const std::string& name) {
    if (names_.contains(name)) return name;
    if (drawn_.names.size() >= kMostColumns || !has_column(name)) return {};
    add(name);
    return name;
  }

  void take_energy(const std::string& kind, const std::string& column) {
    if (take(column).empty()) return;
    const auto known = std::find_if(drawn_.energies.begin(), drawn_.energies.end(),
                                    [&](const auto& energy) { return energy.first == kind; });
    if (known != drawn_.energies.end()) {
      known->second.push_back(column);
    } else {
      drawn_.energies.push_back({kind, {column}});
    }
  }

  const results::ResultLayout& layout_;
  std::unordered_set<std::string> columns_;  ///< of the result
  DrawnColumns drawn_;
  std::unordered_set<std::string> names_;  ///< of the columns in drawn_
  bool several_ = false;
};

}  // namespace

DrawnColumns drawn_columns(const results::ResultLayout& layout) {
  Choice choice(layout);
  choice.take_friction();
  choice.take_energies();
  choice.take_coefficients();
  return std::move(choice).take();
}

void use_energy_unit(CaseReport& report, const std::string& unit) {
  for (const auto& [kind, names] : report.energies) {
    for (ReportColumn& column : report.columns) {
      const bool one_of_them = std::find(names.begin(), names.end(), column.name) != names.end();
      if (one_of_them && !column.unit.empty()) column.unit = unit;
    }
  }
}

}  // namespace slipbench::driver::report
