// SPDX-License-Identifier: Apache-2.0
// Contract of a coefficient law: what it must say. A missing piece is the first error of the
// compiler, in words.
#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "law/friction/law_defaults.hpp"

namespace slipbench::law {

/// Returns true if a law is complete; what it lacks does not compile. A law with an evaluate() of
/// its own (a table, a law that proves its bends) need not be a template over its number type.
template <class Law>
consteval bool keep_contract(std::type_identity<Law>) {
  static_assert(
      requires { std::string_view(Law::kName); },
      "a friction law lacks its key: static constexpr std::string_view kName");
  static_assert(
      requires { std::string_view(Law::kTitle); },
      "a friction law lacks its title: static constexpr std::string_view kTitle");
  static_assert(
      requires { std::string_view(Law::kFormula); },
      "a friction law lacks its formula: static constexpr std::string_view kFormula");
  static_assert(
      requires { std::string_view(Law::kSource); },
      "a friction law lacks its source, a key of law/SOURCES.md: kSource");
  static_assert(
      requires { Law::kRules.size(); },
      "a friction law lacks the rules between its numbers: static constexpr "
      "std::array<std::string_view, N> kRules, N may be 0");
  static_assert(
      requires { std::is_same_v<decltype(Law::example()), Law>; },
      "a friction law lacks a set of numbers to show it with: static Law example()");
  if constexpr (!requires(const Law& l, Ambient a, SlipArguments s) { l.evaluate(a, s); }) {
    static_assert(
        requires { Law::fields(); },
        "a friction law lacks the list of its numbers: static constexpr auto fields()");
    static_assert(
        OfRate<Law, double> || OfRateAndForce<Law, double> || OfRateForceAndAmbient<Law, double>,
        "a friction law lacks Number coefficient(V), (V, F_N) or (V, F_N, Ambient), each argument "
        "a const Number&");
    static_assert(
        requires(const Law& l) { over<Dual<double, 1>>(l); },
        "a friction law is a template over its number type: template <class Number = "
        "double> struct, its list entry Law<>");
  }
  if constexpr (requires { Law::kRules.size(); }) {
    if constexpr (Law::kRules.size() > 0) {
      static_assert(
          requires(const Law& l) { std::optional<std::string_view>(l.violation()); },
          "a friction law with rules lacks the broken one: std::optional<std::string_view> "
          "violation() const");
    }
  }
  return true;
}

/// The same of every law of a list.
template <class... Law>
consteval bool keep_contract(std::type_identity<std::variant<Law...>>) {
  return (keep_contract(std::type_identity<Law>{}) && ...);
}

}  // namespace slipbench::law
