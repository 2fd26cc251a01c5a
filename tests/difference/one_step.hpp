// SPDX-License-Identifier: Apache-2.0
// One increment of the law as plain numbers. one_step.cpp is compiled twice, for double and, behind
// long_double.hpp, for long double: nothing but numbers crosses between the two.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slipbench::test {

template <class Number>
struct PlainState {
  std::array<Number, 6> elastic_slip{}, force{};
  Number accumulated_slip{};
  int regime = 1;
};

/// All that an increment is made of besides the definition: what is prescribed at both ends, and
/// the old state.
template <class Number>
struct PlainIncrement {
  struct End {
    std::array<Number, 6> position{}, motion{}, force{};
    Number temperature{};
    std::array<Number, 2> fields{};
  };
  Number duration{};
  End begin, end;
  Number begin_blend{}, begin_stick{}, begin_wrap_angle{};  ///< of the definition, at the begin
  PlainState<Number> old;
};

/// A number of a result, with the size of the numbers that it is made of.
template <class Number>
struct PlainResult {
  const char* name = "";
  Number value{}, size{};
};

template <class Number>
struct PlainStep {
  PlainState<Number> state;
  std::vector<PlainResult<Number>> results;
};

enum class Way : std::uint8_t {
  kBackwardEuler,
  kExact  ///< gives no results of a definition without a continuous solution, nor of an increment
          ///< of more than 1e13 elastic slips (law::continuous_update)
};

/// Tolerance of kExact, of forces as a part of the limit.
constexpr double kExactness = 1e-10;
/// That of a constant stick stiffness under a coefficient that sees the rate, whatever is asked for
/// (law::continuous_update).
constexpr double kViscousExactness = 1e-7;

/// Makes an increment, in double or in long double.
/// \param definition packed
template <class Number>
PlainStep<Number> one_step(Way way, std::span<const Number> definition,
                           const PlainIncrement<Number>& increment);

}  // namespace slipbench::test
