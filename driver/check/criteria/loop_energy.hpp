// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// The work of each loop, the integral of q dx around it: positive where energy is put in, as in
/// friction. One measure a loop and, if there are several, one of their total
/// [quantity x abscissa]; `tolerance.absolute` is in the same unit. Trapezoids, second order.
///
/// A loop goes from one turning point to the next but one. Turning points are the reversals, the
/// start and the end; counting begins at the first or the second of them, with whichever the loops
/// of the reference close better (smaller mean gap between their ends, as a part of the longer
/// branch, and at most a quarter), the first if there is no difference. A loop is whole if its gap
/// is less than a quarter; those that are not do not count. Without a whole loop the one measure is
/// the work over the whole range, and its name says so. A relative tolerance is relative to the
/// reference's energy of the loop; where that is next to nothing (1e-9) of range x range of the
/// loop, to this product.
///
/// Faults: as of compare_area.
CurveComparison compare_loop_energy(const Series& result, const Series& reference,
                                    const cases::Tolerance& tolerance);

}  // namespace slipbench::driver::check
