// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace slipbench::law {

/// A law of law_list.hpp without its type: a copy of its bytes, nothing allocated. What holds laws
/// need not read their headers, so that a changed one rebuilds the few sources that name it.
class BoxedLaw {
 public:
  /// Holds a law of the list that FrictionLaw does not name itself. Wants law_list.hpp.
  template <class Law>
  requires requires { Law::kFormula; }
  BoxedLaw(const Law& law) {  // NOLINT: a law is a FrictionLaw
    fill(*this, law);
  }

  static constexpr std::size_t kBytes = 16 * sizeof(double);  ///< room for the largest of them
  alignas(double) std::byte bytes[kBytes] = {};               ///< law_list.hpp makes and reads them
};

}  // namespace slipbench::law
