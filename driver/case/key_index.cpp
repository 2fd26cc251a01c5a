// SPDX-License-Identifier: Apache-2.0
#include "driver/case/key_index.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "driver/case/case_reference.hpp"

namespace slipbench::driver {

std::string places_of_key(std::string_view key) {
  std::vector<std::string> places;
  for (const KeyRow& row : case_rows()) {
    const std::size_t dot = row.path.rfind('.');
    const std::string_view last = dot == std::string::npos
                                      ? std::string_view(row.path)
                                      : std::string_view(row.path).substr(dot + 1);
    if (last != key) continue;
    std::string place = dot == std::string::npos ? "the top level" : row.path.substr(0, dot);
    if (std::find(places.begin(), places.end(), place) == places.end()) {
      places.push_back(std::move(place));
    }
  }
  if (places.size() > 3) places.resize(3);
  const std::vector<std::string_view> views(places.begin(), places.end());
  return in_words(views);
}

std::optional<std::string_view> later_key(std::string_view key) {
  using Later = std::pair<std::string_view, std::string_view>;
  static constexpr std::array kLater{
      Later{"elasticity",
            "connector elasticity is not in this version: components are driven by "
            "their motion, and friction is the only force"},
      Later{"damping",
            "connector damping is not in this version: components are driven by their "
            "motion, and friction is the only force"},
      Later{"change_friction",
            "a change of friction in a step is not in this version; run two cases"},
      Later{"wrap_angle", "SLIPRING is not in this version"},
      Later{"nodes", "SLIPRING is not in this version"},
      Later{"initial_strain", "SLIPRING is not in this version"},
      Later{"SLIPRING", "SLIPRING is not in this version"},
      Later{"adaptive", "adaptive increments are not in this version; give their number"},
      Later{"exact",
            "exact integration is not in this version; use backward_euler and small increments"},
      Later{"exponential_test_data",
            "this form of the exponential decay is not in this version; use "
            "exponential_decay {static, kinetic, decay}"},
      Later{"generalized_viscous", "the Radioss laws are not in this version"},
      Later{"modified_darmstad", "the Radioss laws are not in this version"},
      Later{"renard", "the Radioss laws are not in this version"},
      Later{"orthotropic", "the Radioss laws are not in this version"},
      Later{"formulation", "the Radioss laws are not in this version"},
      Later{"filter", "the Radioss laws are not in this version"},
      Later{"friction_pairs", "tables of part pairs are not in this version"},
      Later{"parts", "tables of part pairs are not in this version"},
      Later{"dynamics", "dynamics is not in this version"},
      Later{"max", "a potential with operator max is not in this version"},
      Later{"curve",
            "comparison with a curve is not in this version; use an expression or a closed form"},
      Later{"peak", "this criterion is not in this version; use pointwise"},
      Later{"area", "this criterion is not in this version; use pointwise"},
      Later{"loop_energy", "this criterion is not in this version; use pointwise"},
      Later{"breakaway", "this criterion is not in this version; use pointwise"},
      Later{"sprague_geers", "this criterion is not in this version; use pointwise"},
      Later{"iso18571", "this criterion is not in this version; use pointwise"},
      Later{"calibrate", "calibration is not in this version"},
      Later{"sweep", "sweeps are not in this version"}};
  for (const auto& [name, why] : kLater) {
    if (name == key) return why;
  }
  return std::nullopt;
}

}  // namespace slipbench::driver
