// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/drawn_coefficients.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "driver/bench/connector_increment.hpp"
#include "driver/plot/text_lines.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::plot {
namespace {

bool depends_on_slip(const law::FrictionLaw& law) {
  return law::depends_on_slip_rate(law) || law::depends_on_contact_force(law);
}

bool depends_on_anything(const law::FrictionLaw& law) {
  const auto* table = std::get_if<law::TabularCoefficient>(&law);
  return depends_on_slip(law) || (table != nullptr && !table->table.independents().empty());
}

std::array<DrawnArgument, 2> map_arguments(const law::FrictionLaw& law) {
  std::vector<DrawnArgument> list;
  if (const auto* table = std::get_if<law::TabularCoefficient>(&law)) {
    const auto all = table->table.independents();
    list.assign(all.begin(), all.end());
  } else {
    if (law::depends_on_slip_rate(law)) list.push_back({law::IndependentKind::kSlipRate, 0});
    if (law::depends_on_contact_force(law))
      list.push_back({law::IndependentKind::kContactForce, 0});
  }
  for (const law::IndependentKind more :
       {law::IndependentKind::kSlipRate, law::IndependentKind::kContactForce}) {
    if (list.size() < 2 && (list.empty() || list[0].kind != more)) list.push_back({more, 0});
  }
  return {list[0], list[1]};
}

std::string title_of(const cases::CaseDefinition& definition, bool several,
                     const law::FrictionLaw& law, std::string_view direction) {
  std::string text = several ? one_line(definition.name, kNameLength) + ": " : "";
  if (!direction.empty()) text += std::string(direction) + ": ";
  return text + std::string(law::title_of(law));
}

}  // namespace

void VisitedStates::add(const Visited& state) {
  slip_rate_ = std::max(slip_rate_, state.slip_rate);
  contact_force_ = std::max(contact_force_, state.contact_force);
  for (std::size_t k = 0; k < range_.size(); ++k) {
    const double x = state.argument[k];
    range_[k] = count_ == 0 ? std::array{x, x}
                            : std::array{std::min(range_[k][0], x), std::max(range_[k][1], x)};
  }
  if (count_++ % stride_ != 0) return;
  states_.push_back(state);
  if (states_.size() < kMost) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < states_.size(); i += 2) states_[kept++] = states_[i];
  states_.resize(kept);
  stride_ *= 2;
}

DrawnCoefficients::DrawnCoefficients(const cases::Case& problem, bool any) : case_(&problem) {
  const bool several = problem.definitions.size() > 1;
  for (const cases::CaseDefinition& definition : problem.definitions) {
    std::array<int, 2> entries{-1, -1};
    const auto& formulation = definition.law.formulation;
    const bool orthotropic = formulation && formulation->orthotropy;
    const bool creeps =
        formulation && std::holds_alternative<law::ViscousPenalty>(formulation->penalty);
    const auto add = [&](const law::FrictionLaw& law, std::string_view direction) {
      if (!(any ? depends_on_anything(law) : depends_on_slip(law))) return -1;
      list_.push_back({title_of(definition, several, law, direction),
                       law,
                       results::is_rotational(definition.law),
                       creeps,
                       map_arguments(law),
                       {}});
      return static_cast<int>(list_.size()) - 1;
    };
    entries[0] = add(definition.law.law, orthotropic           ? "direction 1"
                                         : definition.backward ? "forward"
                                                               : "");
    if (definition.backward) entries[1] = add(*definition.backward, "backward");
    if (orthotropic) entries[1] = add(formulation->orthotropy->second, "direction 2");
    of_definition_.push_back(entries);
  }
  slips_.resize(list_.size());
  ambient_.fields = fields_;
}

void DrawnCoefficients::visit(const bench::Simulation& simulation) {
  const bench::Row& all = simulation.row();
  ambient_ = bench::ambient_of(all.quantities, case_->reference);
  std::copy_n(ambient_.fields.begin(), fields_.size(), fields_.begin());
  ambient_.fields = fields_;
  for (std::size_t d = 0; d < of_definition_.size(); ++d) {
    const bench::DefinitionRow& row = all.definitions[d];
    const law::FrictionUpdate& update = row.update;
    // The start is no state of an increment.
    if (update.state.regime == law::Regime::kOpen || all.index == 0) continue;
    const int status = static_cast<int>(update.state.regime);
    const auto& formulation = simulation.definition(d).formulation;
    const bool orthotropic = formulation && formulation->orthotropy;
    for (std::size_t i = 0; i < 2; ++i) {
      if (of_definition_[d][i] < 0) continue;
      if (case_->definitions[d].backward && row.backward != (i == 1)) continue;
      const auto entry = static_cast<std::size_t>(of_definition_[d][i]);
      // A direction of an orthotropic coefficient sees a speed of its own.
      const double rate = orthotropic ? row.penalty.speeds[i] : update.slip_rate;
      const double mu = orthotropic ? row.penalty.mu[i] : update.mu;
      const law::SlipArguments slip{rate, update.normal_force, update.state.accumulated_slip};
      DrawnCoefficient& coefficient = list_[entry];
      slips_[entry] = update.state.accumulated_slip;
      coefficient.visited.add({rate,
                               update.normal_force,
                               mu,
                               status,
                               {law::argument(coefficient.arguments[0], ambient_, slip),
                                law::argument(coefficient.arguments[1], ambient_, slip)}});
    }
  }
}

}  // namespace slipbench::driver::plot
