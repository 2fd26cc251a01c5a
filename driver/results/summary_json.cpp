// SPDX-License-Identifier: Apache-2.0
#include "driver/base/units/derived_units.hpp"
#include "driver/results/summary.hpp"

namespace slipbench::driver::results {

base::json::Value Summary::to_json(const StickSlip& all, bool rotational) const {
  const base::UnitSystem& units = case_->units;
  const auto range = [](const Extremes& of, const std::string& unit) {
    base::json::Value value;
    value["lowest"] = of.lowest;
    value["highest"] = of.highest;
    value["unit"] = unit;
    return value;
  };
  base::json::Value value;
  value["cycles"] = all.cycles;
  value["first"] = all.first;
  value["last"] = all.last;
  value["frequency"] = all.frequency();
  value["frequency_unit"] = base::frequency_name(units);
  value["period"] = range(all.period, units.time);
  value["force"] =
      range(all.force, base::unit_text(rotational ? base::kMoment : base::kForce, units));
  if (all.place.highest > all.place.lowest) {
    const std::string unit = base::unit_text(rotational ? base::kAngle : base::kLength, units);
    value["place"] = range(all.place, unit);
    value["amplitude"] = 0.5 * (all.place.highest - all.place.lowest);
    value["amplitude_unit"] = unit;
  }
  value["slip_share"] = all.slip_time / all.time;
  return value;
}

base::json::Value Summary::to_json() const {
  base::json::Value all;
  all["increments"] = increments_;
  all["start_time"] = start_time_;
  all["end_time"] = end_time_;
  base::json::Value list = base::json::Array{};
  for (std::size_t d = 0; d < definitions_.size(); ++d) {
    const DefinitionSummary& sum = definitions_[d];
    base::json::Value one;
    one["name"] = sum.name;
    one["slip_time"] = double{sum.slip_time};
    one["open_time"] = double{sum.open_time};
    one["stick_slip_events"] = sum.events;
    one["reversals"] = sum.reversals;
    if (sum.first_slip) {
      base::json::Value first;
      first["t"] = sum.first_slip->time;
      first["force"] = sum.first_slip->force;
      for (std::size_t p = 0; p < positions_.size(); ++p) {
        first[positions_[p].name] = sum.first_place[p];
      }
      one["first_slip"] = first;
    } else {
      one["first_slip"] = nullptr;
    }
    one["lowest_force"] = sum.lowest_force;
    one["highest_force"] = sum.highest_force;
    one["accumulated_slip"] = sum.accumulated_slip;
    one["dissipation"] = sum.dissipation;
    one["stored_energy"] = sum.stored_energy;
    one["work"] = sum.work;
    if (case_->integration.snap_back == cases::SnapBackAction::kJump) {
      one["lost_in_jumps"] = sum.lost;
      one["jumps"] = sum.jumps;
    }
    one["energy_balance_residual"] = sum.energy_gap();
    one["largest_elastic_slip_in_stick"] = sum.largest_elastic_slip;
    one["largest_creep_in_stick"] = sum.largest_creep;
    if (const CycleEnergy& energy = cycles_.energies()[d]; energy.count > 0) {
      base::json::Value cycles;
      cycles["found_by"] = cycles_.found_by();
      cycles["count"] = energy.count;
      cycles["dissipation_first"] = energy.first;
      cycles["dissipation_last"] = energy.last;
      cycles["change_of_last"] = energy.count > 1
                                     ? base::json::Value(energy.last - energy.before_last)
                                     : base::json::Value(nullptr);
      cycles["dissipation_lowest"] = energy.lowest;
      cycles["dissipation_highest"] = energy.highest;
      one["cycles"] = cycles;
    } else {
      one["cycles"] = nullptr;
    }
    if (sum.stick_slip.cycles > 1) {
      one["stick_slip"] = to_json(sum.stick_slip, is_rotational(case_->definitions[d].law));
    }
    one["increments_with_several_solutions"] = sum.multiple_roots;
    one["increments_too_short"] = sum.short_increments;
    one["increments_clamped"] = sum.clamped;
    if (case_->definitions[d].law.formulation) {
      one["largest_limit_use"] = sum.largest_use;
      one["largest_limit_use_time"] = sum.largest_use_time;
      one["increments_alpha_limited"] = sum.alpha_limited;
      one["increments_alpha_above_1"] = sum.alpha_overshoots;
    }
    if (sum.short_increments > 0) {
      one["smooth_increment"] = sum.worst.smooth;
      one["unique_increment"] = sum.worst.unique;
    }
    list.push_back(one);
  }
  all["definitions"] = list;
  all["tables"] = coverage_.to_json();
  return all;
}

}  // namespace slipbench::driver::results
