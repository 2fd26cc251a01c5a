// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// The integral of q dx over the rows first..last of a curve [quantity x abscissa], by trapezoids.
double work(const Series& curve, std::size_t first, std::size_t last);

/// The integral of q |dx| over a whole curve [quantity x abscissa], by trapezoids.
double integral_over_way(const Series& curve);

/// The integral of |q dx| over a whole curve [quantity x abscissa], exact for the curve that is
/// straight between its rows.
double magnitude_integral(const Series& curve);

/// The integral of |dx| over a whole curve: the way of the abscissa.
double way(const Series& curve);

}  // namespace slipbench::driver::check
