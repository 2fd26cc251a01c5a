// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "law/update/return_mapping.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/random_definition.hpp"

namespace slipbench::test {

/// One increment of a history, owning its fields.
struct HistoryRow {
  double duration = 0.0;
  law::RelativePosition begin;
  law::RelativePosition end;
  law::RelativePosition reference;
  law::ConnectorForce force;
  double temperature = 0.0;
  std::array<double, 2> fields{};

  law::ConnectorIncrement increment() const {
    law::ConnectorIncrement result;
    result.duration = duration;
    result.begin_position = begin;
    result.end = {end, law::constitutive_motion(end, reference), temperature, fields};
    result.force = force;
    return result;
  }
};

/// A connected random history: motion in strides from nothing to many elastic slips, forces that
/// drift, jump and vanish, steps in time, changing temperature and fields. All positions are
/// multiples of 2^-24, so that differences of motion are exact.
inline std::vector<HistoryRow> random_history(Dice* dice, int length) {
  std::vector<HistoryRow> rows;
  HistoryRow row;
  for (int c = 0; c < law::kComponents; ++c) {
    row.end[c] = dice->dyadic(-0.5, 0.5);
    row.reference[c] = dice->dyadic(-0.1, 0.1);
    row.force[c] = dice->between(-100.0, 100.0);
  }
  row.temperature = dice->between(0.0, 100.0);
  const std::vector<double> strides = {0.0, 1e-4, 1e-3, 1e-2, 0.1, 1.0};
  for (int i = 0; i < length; ++i) {
    row.begin = row.end;
    const double stride = dice->one_of(strides);
    const bool reverse = dice->chance(0.3);
    for (int c = 0; c < law::kComponents; ++c) {
      const double step = dice->dyadic(-stride, stride);
      row.end[c] += reverse && row.end[c] * step > 0.0 ? -step : step;
    }
    if (dice->chance(0.5)) {
      for (int c = 0; c < law::kComponents; ++c) row.force[c] *= dice->between(0.8, 1.2);
    } else if (dice->chance(0.4)) {
      const bool lift_off = dice->chance(0.3);
      for (int c = 0; c < law::kComponents; ++c) {
        row.force[c] = lift_off ? 0.0 : dice->between(-100.0, 100.0);
      }
    }
    row.duration = dice->chance(0.05) ? 0.0 : dice->one_of(std::vector<double>{1e-3, 0.05, 1.0});
    if (dice->chance(0.5)) row.temperature = dice->between(-20.0, 120.0);
    for (double& field : row.fields) field = dice->between(-1.2, 1.2);
    rows.push_back(row);
  }
  return rows;
}

/// The same history, all its numbers in other units.
inline std::vector<HistoryRow> in_units(std::vector<HistoryRow> rows, const Units& units) {
  for (HistoryRow& row : rows) {
    row.duration /= units.time;
    for (int c = 0; c < law::kComponents; ++c) {
      const double motion = motion_unit(c, units);
      row.begin[c] /= motion;
      row.end[c] /= motion;
      row.reference[c] /= motion;
      row.force[c] /= force_unit(c, units);
    }
  }
  return rows;
}

/// All results along a history, from rest.
inline std::vector<law::FrictionUpdate> run_history(const law::FrictionDefinition& definition,
                                                    const std::vector<HistoryRow>& rows,
                                                    law::FrictionState state = {}) {
  std::vector<law::FrictionUpdate> results;
  for (const HistoryRow& row : rows) {
    results.push_back(law::update(definition, row.increment(), state));
    state = results.back().state;
  }
  return results;
}

/// All numbers of a result, multiplied by the units given. Far down a decay its slope is next to
/// the least normal number, and has not the same digits in all units: it counts as 0.
inline std::vector<double> numbers(const law::FrictionUpdate& u, const SlipUnits& unit = {}) {
  std::vector<double> all;
  for (std::size_t i = 0; i < law::kComponents; ++i) {
    all.push_back(u.state.force[i] * unit.force);
    all.push_back(u.state.elastic_slip[i] * unit.slip);
    all.push_back(u.direction[i]);
    all.push_back(u.motion_direction[i]);
  }
  const double stiffness = unit.force / unit.slip;
  const double energy = unit.force * unit.slip;
  for (const double x :
       {u.state.accumulated_slip * unit.slip, u.tangent.transverse * stiffness,
        u.tangent.radial * stiffness, u.tangent.rate * stiffness, u.tangent.contact,
        u.phi * unit.force, u.normal_force * unit.force, u.contact_force * unit.force, u.mu,
        u.limit * unit.force, u.slip_increment * unit.slip, u.slip_rate * unit.slip / unit.time,
        u.dissipation * energy, u.stored_energy * energy, u.work * energy,
        static_cast<double>(u.state.regime), u.multiple_roots ? 1.0 : 0.0}) {
    all.push_back(std::abs(x) < 1e-250 ? 0.0 : x);
  }
  return all;
}

}  // namespace slipbench::test
