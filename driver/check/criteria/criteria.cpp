// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/criteria.hpp"

#include "driver/check/criteria/arc_length.hpp"
#include "driver/check/criteria/area.hpp"
#include "driver/check/criteria/bounds.hpp"
#include "driver/check/criteria/breakaway.hpp"
#include "driver/check/criteria/iso18571.hpp"
#include "driver/check/criteria/loop_energy.hpp"
#include "driver/check/criteria/peak.hpp"
#include "driver/check/criteria/plateau.hpp"
#include "driver/check/criteria/pointwise.hpp"
#include "driver/check/criteria/reversals.hpp"
#include "driver/check/criteria/sprague_geers.hpp"

namespace slipbench::driver {

CurveComparison compare(Criterion criterion, const Series& result, const Series& reference,
                        const Tolerance& tolerance) {
  switch (criterion) {
    case Criterion::kPointwise:
      return compare_pointwise(result, reference, tolerance);
    case Criterion::kPeak:
      return compare_peak(result, reference, tolerance);
    case Criterion::kArea:
      return compare_area(result, reference, tolerance);
    case Criterion::kLoopEnergy:
      return compare_loop_energy(result, reference, tolerance);
    case Criterion::kBreakaway:
      return compare_breakaway(result, reference, tolerance);
    case Criterion::kPlateau:
      return compare_plateau(result, reference, tolerance);
    case Criterion::kReversals:
      return compare_reversals(result, reference, tolerance);
    case Criterion::kArcLength:
      return compare_arc_length(result, reference, tolerance);
    case Criterion::kSpragueGeers:
      return compare_sprague_geers(result, reference, tolerance);
    case Criterion::kIso18571:
      return compare_iso18571(result, reference, tolerance);
  }
  return incomparable("there is no such criterion");
}

}  // namespace slipbench::driver
