// SPDX-License-Identifier: Apache-2.0
// Contract of a coefficient law: what it must say. A missing piece is the first error of the
// compiler, in words.
#pragma once

#include <concepts>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "law/friction/law_defaults.hpp"

namespace slipbench::law {

/// Returns true if a number of a law follows its number type: it is no plain double.
template <class Struct, class Member>
constexpr bool follows_number(const Field<Struct, Member>&) {
  return !std::is_same_v<Member, double> && !std::is_same_v<Member, std::optional<double>>;
}

/// Returns true if the numbers and the arguments of a law follow its number type.
template <class Law>
constexpr bool follows_number_type() {
  using Number = Dual<double, 1>;
  if constexpr (requires(const Law& l) { over<Number>(l); }) {
    using Other = decltype(over<Number>(std::declval<const Law&>()));
    return OfRate<Law, double> == OfRate<Other, Number> &&
           OfRateAndForce<Law, double> == OfRateAndForce<Other, Number> &&
           OfRateForceAndAmbient<Law, double> == OfRateForceAndAmbient<Other, Number> &&
           std::apply([](const auto&... field) { return (follows_number(field) && ...); },
                      Other::fields());
  }
  return true;
}

/// Checks the pieces that a law may leave out: one of another form would be passed over, so it does
/// not compile.
template <class Law>
consteval void keep_optional_contract() {
  if constexpr (requires { &Law::next_bend; }) {
    static_assert(
        requires(const Law& l, const SlipLine& line) {
          { l.next_bend(line) } -> std::same_as<double>;
        },
        "a friction law's next_bend is double next_bend(const SlipLine&) const");
  }
  if constexpr (requires { &Law::next_belt_bend; }) {
    static_assert(
        requires(const Law& l, const SlipLine& line, double angle, FlowSense sense) {
          { l.next_belt_bend(line, angle, sense) } -> std::same_as<double>;
        },
        "a friction law's next_belt_bend is double next_belt_bend(const SlipLine&, double "
        "wrap_angle, FlowSense) const");
  }
  if constexpr (requires { &Law::range; }) {
    static_assert(
        requires(const Law& l) {
          { l.range() } -> std::same_as<LawRange>;
        },
        "a friction law's range is LawRange range() const");
  }
  if constexpr (requires { &Law::largest; }) {
    static_assert(
        requires(const Law& l) {
          { l.largest() } -> std::same_as<double>;
        },
        "a friction law's largest is double largest() const");
  }
}

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
    static_assert(follows_number_type<Law>(),
                  "a friction law has a double among its numbers, or as an argument of "
                  "coefficient(): write Number, which carries the derivatives along");
  }
  if constexpr (requires { Law::kRules.size(); }) {
    if constexpr (Law::kRules.size() > 0) {
      static_assert(
          requires(const Law& l) { std::optional<std::string_view>(l.violation()); },
          "a friction law with rules lacks the broken one: std::optional<std::string_view> "
          "violation() const");
    }
  }
  keep_optional_contract<Law>();
  return true;
}

/// The same of every law of a list.
template <class... Law>
consteval bool keep_contract(std::type_identity<std::variant<Law...>>) {
  return (keep_contract(std::type_identity<Law>{}) && ...);
}

}  // namespace slipbench::law
