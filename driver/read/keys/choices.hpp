// SPDX-License-Identifier: Apache-2.0
// Choices of a case, and the words that they are written with.
#pragma once

#include <array>
#include <string_view>

#include "driver/base/csv/data_source.hpp"
#include "driver/case/integration.hpp"
#include "driver/check/criteria/criteria.hpp"
#include "driver/yaml/binding.hpp"
#include "law/definition/formulation.hpp"
#include "law/definition/friction_definition.hpp"
#include "law/definition/potential_terms.hpp"
#include "law/table/table.hpp"

namespace slipbench::driver::read {

/// Mark before the decimals of a number in a data file.
enum class DecimalMark { kPoint, kComma };

/// Mark between the columns of a data file.
enum class ColumnSeparator { kComma, kSemicolon, kTab, kSpace };

/// Kinds of a contact penalty.
enum class PenaltyKind { kViscous, kStiffness };

/// Meanings of Xfreq: increments of a period, or a ratio of frequencies.
enum class XfreqConvention { kSteps, kRatio };

/// Courses of a change of friction over its step.
enum class AmplitudeShape { kLinear, kSmooth };

/// Places of the play of a dead zone at the start.
enum class PlayPlace { kCentred, kLower, kUpper };

}  // namespace slipbench::driver::read

// Specialisations belong to the namespace of their template.
namespace slipbench::driver::yaml {

template <>
struct EnumWords<read::DecimalMark> {
  static constexpr std::array<std::string_view, 2> kWords{".", ","};
};
template <>
struct EnumWords<read::ColumnSeparator> {
  static constexpr std::array<std::string_view, 4> kWords{",", ";", "tab", "space"};
};
template <>
struct EnumWords<base::MissingSample> {
  static constexpr std::array<std::string_view, 3> kWords{"error", "skip", "hold"};
};
template <>
struct EnumWords<law::Extrapolation> {
  static constexpr std::array<std::string_view, 2> kWords{"constant", "linear"};
};
template <>
struct EnumWords<law::TermOperator> {
  static constexpr std::array<std::string_view, 3> kWords{"norm", "sum", "macauley_sum"};
};
template <>
struct EnumWords<law::ContributionFunction> {
  static constexpr std::array<std::string_view, 3> kWords{"abs", "macauley", "none"};
};
template <>
struct EnumWords<law::PotentialOperator> {
  static constexpr std::array<std::string_view, 2> kWords{"sum", "max"};
};
/// Words that a law says itself of a choice of its own.
template <class T>
requires requires { enum_words(T{}); }
struct EnumWords<T> {
  static constexpr auto kWords = enum_words(T{});
};
template <>
struct EnumWords<law::Orthotropy::Speed> {
  static constexpr std::array<std::string_view, 2> kWords{"component", "total"};
};
template <>
struct EnumWords<read::PenaltyKind> {
  static constexpr std::array<std::string_view, 2> kWords{"viscous", "stiffness"};
};
template <>
struct EnumWords<law::Convention> {
  static constexpr std::array<std::string_view, 2> kWords{"documented", "as_coded"};
};
template <>
struct EnumWords<read::XfreqConvention> {
  static constexpr std::array<std::string_view, 2> kWords{"steps", "ratio"};
};
template <>
struct EnumWords<cases::IntegrationMethod> {
  static constexpr std::array<std::string_view, 2> kWords{"backward_euler", "exact"};
};
template <>
struct EnumWords<cases::SnapBackAction> {
  static constexpr std::array<std::string_view, 2> kWords{"stop", "jump"};
};
template <>
struct EnumWords<law::AccumulatedSlipTiming> {
  static constexpr std::array<std::string_view, 2> kWords{"end", "start"};
};
template <>
struct EnumWords<law::SlipRateMeasure> {
  static constexpr std::array<std::string_view, 2> kWords{"slip", "relative_motion"};
};
template <>
struct EnumWords<read::AmplitudeShape> {
  static constexpr std::array<std::string_view, 2> kWords{"linear", "smooth"};
};
template <>
struct EnumWords<cases::Criterion> {
  static constexpr auto kWords = check::criterion_words();
};
template <>
struct EnumWords<read::PlayPlace> {
  static constexpr std::array<std::string_view, 3> kWords{"centred", "lower", "upper"};
};

}  // namespace slipbench::driver::yaml
