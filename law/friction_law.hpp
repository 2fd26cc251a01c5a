// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>

#include "law/friction/constant_coefficient.hpp"
#include "law/friction/exponential_decay.hpp"
#include "law/friction/exponential_test_data.hpp"
#include "law/friction/tabular_coefficient.hpp"

namespace slipbench::law {

/// The single list of coefficient laws: the reader, the schema, `slipbench list`, the documentation
/// and the tests fold over it. A new law is one header and one entry here.
using FrictionLaw =
    std::variant<ConstantCoefficient, ExponentialDecay, ExponentialTestData, TabularCoefficient>;

inline CoefficientPoint evaluate(const FrictionLaw& law, const Ambient& ambient,
                                 const SlipArguments& slip) noexcept {
  if (const auto* constant = std::get_if<ConstantCoefficient>(&law)) {
    return constant->evaluate(ambient, slip);
  }
  return std::visit([&](const auto& l) { return l.evaluate(ambient, slip); }, law);
}

inline bool depends_on_slip_rate(const FrictionLaw& law) {
  return std::visit([](const auto& l) { return l.depends_on_slip_rate(); }, law);
}
inline bool depends_on_contact_force(const FrictionLaw& law) {
  return std::visit([](const auto& l) { return l.depends_on_contact_force(); }, law);
}
/// The largest coefficient the law gives inside its data.
inline double largest(const FrictionLaw& law) {
  return std::visit([](const auto& l) { return l.largest(); }, law);
}
/// The largest d(mu F_N)/dF_N the law has: how fast the limit can follow the normal force.
inline double largest_growth(const FrictionLaw& law) {
  return std::visit([](const auto& l) { return l.largest_growth(); }, law);
}
/// max(-dmu/d(slip rate)) [T/L], 0 for a law that never weakens.
inline double steepest_weakening(const FrictionLaw& law) {
  return std::visit([](const auto& l) { return l.steepest_weakening(); }, law);
}
/// The exponential decay that a law is or stands for; nothing for other laws.
inline std::optional<ExponentialDecay> exponential_decay(const FrictionLaw& law) {
  if (const auto* decay = std::get_if<ExponentialDecay>(&law)) return *decay;
  if (const auto* data = std::get_if<ExponentialTestData>(&law)) return data->fit();
  return std::nullopt;
}
/// True if a table is asked outside its data.
inline bool outside(const FrictionLaw& law, const Ambient& ambient, const SlipArguments& slip) {
  return std::visit([&](const auto& l) { return l.outside(ambient, slip); }, law);
}

}  // namespace slipbench::law
