// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <new>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "law/friction/exponential_test_data.hpp"
#include "law/friction/friction_law.hpp"
#include "law/friction/generalized_viscous.hpp"
#include "law/friction/law_contract.hpp"
#include "law/friction/law_defaults.hpp"
#include "law/friction/modified_darmstad.hpp"
#include "law/friction/renard.hpp"
#include "law/friction/stribeck.hpp"

namespace slipbench::law {

/// The single list of coefficient laws: the reader, the schema, `slipbench list`, the documentation
/// and the tests fold over it. A new law is one header and one entry here. What a law does not say
/// itself is taken from law_defaults.hpp.
using LawList =
    std::variant<ConstantCoefficient, ExponentialDecay, ExponentialTestData, GeneralizedViscous,
                 ModifiedDarmstad, Renard, Stribeck<>, TabularCoefficient>;
static_assert(keep_contract(std::type_identity<LawList>{}));

template <class Law, class List>
inline constexpr bool kIsIn = false;
template <class Law, class... Listed>
inline constexpr bool kIsIn<Law, std::variant<Listed...>> = (std::is_same_v<Law, Listed> || ...);

/// The laws of a list that FrictionLaw does not name: content of a BoxedLaw.
template <class... Law>
auto unnamed(std::type_identity<std::variant<Law...>>) {
  const auto to_variant = []<class... Boxed>(const std::tuple<std::type_identity<Boxed>...>&) {
    return std::type_identity<std::variant<Boxed...>>{};
  };
  return to_variant(std::tuple_cat(std::conditional_t<kIsIn<Law, FrictionLaw>, std::tuple<>,
                                                      std::tuple<std::type_identity<Law>>>{}...));
}
using UnnamedLaw = decltype(unnamed(std::type_identity<LawList>{}))::type;
static_assert(sizeof(UnnamedLaw) <= BoxedLaw::kBytes && alignof(UnnamedLaw) <= alignof(BoxedLaw),
              "a friction law is too large for BoxedLaw: raise its kBytes");
static_assert(std::is_trivially_copyable_v<UnnamedLaw>,
              "a friction law must be plain numbers: it is copied as bytes");

template <class Law>
void fill(BoxedLaw& box, const Law& law) noexcept {
  new (box.bytes) UnnamedLaw(law);
}
inline const UnnamedLaw& content(const BoxedLaw& box) noexcept {
  return *std::launder(reinterpret_cast<const UnnamedLaw*>(box.bytes));
}
inline UnnamedLaw& content(BoxedLaw& box) noexcept {
  return *std::launder(reinterpret_cast<UnnamedLaw*>(box.bytes));
}

/// Calls visit(law) with the law itself and returns what that returns, which has one type for all.
/// \param law a FrictionLaw, const or not
template <class Visit, class Law>
decltype(auto) visit_law(Visit&& visit, Law& law) {
  return std::visit(
      [&]<class One>(One& one) -> decltype(auto) {
        if constexpr (std::is_same_v<std::remove_const_t<One>, BoxedLaw>) {
          return std::visit(visit, content(one));
        } else {
          return visit(one);
        }
      },
      law);
}

/// Returns the law as a Law of the list, or nullptr if it is another.
template <class Law>
const Law* get_law_if(const FrictionLaw& law) noexcept {
  if constexpr (kIsIn<Law, FrictionLaw>) {
    return std::get_if<Law>(&law);
  } else {
    const auto* box = std::get_if<BoxedLaw>(&law);
    return box == nullptr ? nullptr : std::get_if<Law>(&content(*box));
  }
}
template <class Law>
Law* get_law_if(FrictionLaw& law) noexcept {
  return const_cast<Law*>(get_law_if<Law>(std::as_const(law)));
}

/// Returns dmu/d(number) in the order of a law's fields().
template <class Law>
auto to_numbers(const Law& law, const Ambient& ambient, const SlipArguments& slip) noexcept {
  if constexpr (requires { law.to_numbers(ambient, slip); }) {
    return law.to_numbers(ambient, slip);
  } else {
    return default_to_numbers(law, ambient, slip);
  }
}

}  // namespace slipbench::law
