// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "driver/base/units/expression.hpp"

namespace slipbench::driver::base {

/// A parameter as the user wrote it: a number, or the text of an expression over other parameters
/// (with or without its leading '=').
struct ParameterText {
  std::string name;
  std::variant<double, std::string> value;
};

/// Fault of one parameter.
struct ParameterError {
  std::size_t index = 0;       ///< Which of the parameters, or of the overrides.
  bool in_override = false;    ///< Whether `index` counts overrides.
  bool concerns_name = false;  ///< Whether the name is at fault; otherwise the value is.
  ExpressionError error;       ///< Its offset counts in the expression's text.
};

/// Parameters with their values, and the faults of others.
struct ResolvedParameters {
  NamedNumbers values;  ///< of those that neither are faulty nor use one that is
  std::vector<ParameterError> errors;
};

/// So many parameters a case has, at most: the formula of each knows the names of all.
inline constexpr std::size_t kMostParameters = 2000;

/// Gives every parameter its value.
///
/// Parameters may use one another in any order. An override replaces the value of the parameter
/// of its name; of two overrides of one name the last counts. Errors, all of them at once: a name
/// that is no identifier, is reserved or is taken, an override of an unknown parameter, a value
/// that is not finite, whatever `Expression` refuses, and parameters that define each other in a
/// circle (reported once, naming the circle). A parameter that merely uses a faulty one is not
/// reported.
ResolvedParameters resolve_parameters(std::span<const ParameterText> parameters,
                                      std::span<const ParameterText> overrides = {});

/// `--set name=value` taken apart; the value is a number or an expression over other parameters.
/// Errors: no '=', nothing before or after it.
tl::expected<std::vector<ParameterText>, std::string> parse_settings(
    std::span<const std::string> settings);

}  // namespace slipbench::driver::base
