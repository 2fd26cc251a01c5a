// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace slipbench::driver {

/// How a check compares its quantity with a reference.
enum class Criterion : std::uint8_t {
  kPointwise,
  kPeak,
  kArea,
  kLoopEnergy,
  kBreakaway,
  kPlateau,
  kReversals,
  kArcLength,
  kSpragueGeers,
  kIso18571
};

struct CriterionInfo {
  std::string_view word;  ///< as a case writes it
  std::string_view text;  ///< what it compares, one sentence
};

/// In the order of `Criterion`. The formulas are in docs/theory.md, section 16.
inline constexpr std::array<CriterionInfo, 10> kCriteria{{
    {"pointwise", "Every point: the quantity against the reference."},
    {"peak", "The largest and the smallest value."},
    {"area", "The integral of the quantity over the abscissa."},
    {"loop_energy", "The work of each loop of the quantity over a position."},
    {"breakaway", "Where a curve first leaves its initial slope: force and position."},
    {"plateau", "The mean of the quantity over the abscissa."},
    {"reversals", "The points where the abscissa turns: their number, positions and values."},
    {"arc_length", "The distance of two loops, point by point at equal parts of their lengths."},
    {"sprague_geers", "The comprehensive error of magnitude and phase over time."},
    {"iso18571",
     "One minus the rating of ISO/TS 18571: corridor, phase, magnitude and slope over time."},
}};

constexpr auto criterion_words() {
  std::array<std::string_view, kCriteria.size()> words{};
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = kCriteria[i].word;
  return words;
}

constexpr const CriterionInfo& info_of(Criterion criterion) {
  return kCriteria[static_cast<std::size_t>(criterion)];
}

}  // namespace slipbench::driver
