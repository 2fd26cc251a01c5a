// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// A monotone piece of an abscissa. A row where it turns belongs to both of its branches.
struct Branch {
  std::size_t first = 0;
  std::size_t last = 0;  ///< included
  int direction = 1;     ///< 1 if the abscissa increases, -1 if it decreases
};

/// A turn smaller than this part of the abscissa's range is rounding.
inline constexpr double kSmallestTurn = 1e-9;

/// The last digit of an abscissa explains a turn up to this part of its range: what is larger is a
/// turn even of round numbers, whose digits look few.
inline constexpr double kLargestNoise = 1e-3;

/// Divides an abscissa of finite numbers into its branches. Rows that stay in a place (but for
/// kSameTime of the range) belong to the branch before them, at the start to the first. An abscissa
/// without any motion is one branch, an empty one none. The reversals are the last rows of all
/// branches but the last.
///
/// \param noise of the abscissa, see Series: turns by no more are none, and rows that differ by no
///        more stay in a place, as far as that is no more than kLargestNoise of the range
std::vector<Branch> branches(std::span<const double> abscissa, double noise = 0.0);

/// The noise that counts where two curves are divided into branches: a turn that one of them cannot
/// show is none of the other one, either.
double common_noise(const Series& result, const Series& reference);

/// Two curves of the same branches, cut to what they have in common: where the first branches
/// begin and where the last ones end.
struct MatchedBranches {
  std::string fault;  ///< why they do not match; empty if they do
  Series result;
  Series reference;
  std::vector<Branch> result_branches;
  std::vector<Branch> reference_branches;  ///< as many
  bool first_is_interpolated = false;      ///< the reference's first row is no row of its own
  bool last_is_interpolated = false;
};

/// Faults: unusable curves or nothing in common (common_range.hpp), different numbers of branches,
/// opposite directions, a first or last branch without a common part.
MatchedBranches match_branches(const Series& result, const Series& reference);

}  // namespace slipbench::driver::check
