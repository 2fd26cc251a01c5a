// SPDX-License-Identifier: Apache-2.0
// Switches of the mutants that rewrite.py writes into a copy of law/. A site is the number of the
// first of its mutants; while none is chosen every function here does what its name says.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <type_traits>
#include <utility>

namespace slipbench::mutation {

inline constexpr int kNone = -1000;
inline constexpr int kMost = 1 << 16;

/// Number of the mutant that this run has, of the environment variable SLIPBENCH_MUTANT.
extern const int active;
/// Sites that were reached, for the listener of the tests.
extern unsigned char reached[kMost];

/// The mutant of a site that is chosen, from 0; anything else is none.
[[gnu::always_inline]] constexpr int chosen(int site) noexcept {
  if (std::is_constant_evaluated()) return kNone;
  reached[site] = 1;
  return active - site;
}
constexpr bool is_chosen(int site) noexcept { return chosen(site) == 0; }

/// A value that does not refer to what goes at the end of the call, as sums of Eigen may.
template <class T>
constexpr decltype(auto) value_of(T&& x) {
  if constexpr (requires { typename std::decay_t<T>::PlainObject; }) {
    return typename std::decay_t<T>::PlainObject(x);
  } else {
    return std::decay_t<T>(std::forward<T>(x));
  }
}

// By value: a constant that a lambda does not capture may be an operand.
// NOLINTBEGIN: one line a mutator
#define SLIPBENCH_BINARY(name, op, other)                   \
  template <class A, class B>                               \
  constexpr auto name(int site, A a, B b) {                 \
    using Value = std::decay_t<decltype(value_of(a op b))>; \
    if constexpr (requires { Value(a other b); }) {         \
      if (is_chosen(site)) return Value(a other b);         \
    }                                                       \
    return Value(a op b);                                   \
  }
SLIPBENCH_BINARY(plus, +, -)
SLIPBENCH_BINARY(minus, -, +)
SLIPBENCH_BINARY(times, *, /)
SLIPBENCH_BINARY(over, /, *)
SLIPBENCH_BINARY(equal, ==, !=)
SLIPBENCH_BINARY(unequal, !=, ==)
#undef SLIPBENCH_BINARY

#define SLIPBENCH_ORDER(name, op, near, opposite) \
  template <class A, class B>                     \
  constexpr bool name(int site, A a, B b) {       \
    const int mutant = chosen(site);              \
    if (mutant == 0) return a near b;             \
    if (mutant == 1) return a opposite b;         \
    return a op b;                                \
  }
SLIPBENCH_ORDER(less, <, <=, >=)
SLIPBENCH_ORDER(less_equal, <=, <, >)
SLIPBENCH_ORDER(greater, >, >=, <=)
SLIPBENCH_ORDER(greater_equal, >=, >, <)
#undef SLIPBENCH_ORDER

#define SLIPBENCH_ASSIGN(name, op, other)                      \
  template <class A, class B>                                  \
  constexpr decltype(auto) name(int site, A&& a, const B& b) { \
    if constexpr (requires { a other b; }) {                   \
      if (is_chosen(site)) return a other b;                   \
    }                                                          \
    return a op b;                                             \
  }
SLIPBENCH_ASSIGN(add_to, +=, -=)
SLIPBENCH_ASSIGN(take_from, -=, +=)
SLIPBENCH_ASSIGN(scale_by, *=, /=)
SLIPBENCH_ASSIGN(divide_by, /=, *=)
#undef SLIPBENCH_ASSIGN

#define SLIPBENCH_EXTREME(name, one, other)                     \
  template <class T>                                            \
  constexpr const T& name(int site, const T& a, const T& b) {   \
    return is_chosen(site) ? std::other(a, b) : std::one(a, b); \
  }                                                             \
  template <class T>                                            \
  constexpr T name(int site, std::initializer_list<T> all) {    \
    return is_chosen(site) ? std::other(all) : std::one(all);   \
  }
SLIPBENCH_EXTREME(smallest, min, max)
SLIPBENCH_EXTREME(largest, max, min)
#undef SLIPBENCH_EXTREME
// NOLINTEND

template <class A>
constexpr auto negative(int site, const A& a) {
  using Value = std::decay_t<decltype(value_of(-a))>;
  return is_chosen(site) ? Value(a) : Value(-a);
}
/// A condition. `a && b` is made `a || b` by three of them, since not (not a and not b) is a or b.
template <class A>
constexpr bool truth(int site, const A& a) {
  return static_cast<bool>(a) != is_chosen(site);
}
/// A number of the text: 0 is made 1e-3 and 1, others are doubled.
constexpr double number(int site, double x) {
  const int mutant = chosen(site);
  if (x != 0.0) return mutant == 0 ? 2.0 * x : x;
  return mutant == 0 ? 1e-3 : mutant == 1 ? 1.0 : x;
}

}  // namespace slipbench::mutation
