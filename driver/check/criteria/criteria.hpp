// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "driver/case/case.hpp"
#include "driver/case/criterion.hpp"
#include "driver/check/criteria/arc_length.hpp"
#include "driver/check/criteria/area.hpp"
#include "driver/check/criteria/breakaway.hpp"
#include "driver/check/criteria/iso18571.hpp"
#include "driver/check/criteria/loop_energy.hpp"
#include "driver/check/criteria/peak.hpp"
#include "driver/check/criteria/plateau.hpp"
#include "driver/check/criteria/pointwise.hpp"
#include "driver/check/criteria/reversals.hpp"
#include "driver/check/criteria/sprague_geers.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

struct CriterionInfo {
  cases::Criterion criterion = cases::Criterion::kPointwise;
  std::string_view word;  ///< as a case writes it
  std::string_view text;  ///< what it compares, one sentence
  CurveComparison (*compare)(const Series& result, const Series& reference,
                             const cases::Tolerance& tolerance) = nullptr;
  bool needs_position = false;      ///< goes over a position, not over time
  bool compares_positions = false;  ///< within the tolerance of the abscissa
  std::string_view one = {};        ///< what a measure of 1 is already, of those without a unit
};

/// In the order of `Criterion`. The formulas are in docs/theory, section 16.
inline constexpr std::array<CriterionInfo, 10> kCriteria{{
    {.criterion = cases::Criterion::kPointwise,
     .word = "pointwise",
     .text = "Every point: the quantity against the reference.",
     .compare = compare_pointwise},
    {.criterion = cases::Criterion::kPeak,
     .word = "peak",
     .text = "The largest and the smallest value.",
     .compare = compare_peak},
    {.criterion = cases::Criterion::kArea,
     .word = "area",
     .text = "The integral of the quantity over the abscissa.",
     .compare = compare_area},
    {.criterion = cases::Criterion::kLoopEnergy,
     .word = "loop_energy",
     .text = "The work of each loop of the quantity over a position.",
     .compare = compare_loop_energy,
     .needs_position = true},
    {.criterion = cases::Criterion::kBreakaway,
     .word = "breakaway",
     .text = "Where a curve first leaves its initial slope: force and position.",
     .compare = compare_breakaway,
     .needs_position = true,
     .compares_positions = true},
    {.criterion = cases::Criterion::kPlateau,
     .word = "plateau",
     .text = "The mean of the quantity over the abscissa.",
     .compare = compare_plateau},
    {.criterion = cases::Criterion::kReversals,
     .word = "reversals",
     .text = "The points where the abscissa turns: their number, positions and values.",
     .compare = compare_reversals,
     .needs_position = true,
     .compares_positions = true},
    {.criterion = cases::Criterion::kArcLength,
     .word = "arc_length",
     .text = "The distance of two loops, point by point at equal parts of their lengths.",
     .compare = compare_arc_length,
     .needs_position = true,
     .one = "the whole width or height of the reference"},
    {.criterion = cases::Criterion::kSpragueGeers,
     .word = "sprague_geers",
     .text = "The comprehensive error of magnitude and phase over time.",
     .compare = compare_sprague_geers,
     .one = "the error of the opposite curve"},
    {.criterion = cases::Criterion::kIso18571,
     .word = "iso18571",
     .text =
         "One minus the rating of ISO/TS 18571: corridor, phase, magnitude and slope over time.",
     .compare = compare_iso18571},
}};

constexpr auto criterion_words() {
  std::array<std::string_view, kCriteria.size()> words{};
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = kCriteria[i].word;
  return words;
}

constexpr const CriterionInfo& info_of(cases::Criterion criterion) {
  return kCriteria[static_cast<std::size_t>(criterion)];
}

static_assert(
    [] {
      for (std::size_t i = 0; i < kCriteria.size(); ++i) {
        if (static_cast<std::size_t>(kCriteria[i].criterion) != i) return false;
      }
      return true;
    }(),
    "the criteria stand in the order of their enumeration");

/// Holds a result against a reference by a criterion. Every criterion refuses empty curves, numbers
/// that are not finite and curves without a common range with a fault in words; none depends on how
/// either curve is sampled but for the errors its own header names, and none on the units.
/// Gives the worst point of kPointwise as one measure; compare_points gives all of them.
inline CurveComparison compare(cases::Criterion criterion, const Series& result,
                               const Series& reference, const cases::Tolerance& tolerance) {
  return info_of(criterion).compare(result, reference, tolerance);
}

}  // namespace slipbench::driver::check
