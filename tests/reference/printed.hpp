// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

/// Matches a number that agrees with a printed one to its last digit: within half a unit of that
/// digit, plus the few roundings of double precision that a closed form costs.
class Printed : public Catch::MatcherBase<double> {
 public:
  explicit Printed(std::string text) : text_(std::move(text)) {
    value_ = std::strtod(text_.c_str(), nullptr);
    const auto exponent = text_.find('e');
    const auto mantissa = text_.substr(0, exponent);
    const auto point = mantissa.find('.');
    const auto decimals = point == std::string::npos ? 0 : mantissa.size() - point - 1;
    const int power = exponent == std::string::npos ? 0 : std::stoi(text_.substr(exponent + 1));
    tolerance_ = 0.5000001 * std::pow(10.0, power - static_cast<int>(decimals)) +
                 16.0 * std::numeric_limits<double>::epsilon() * std::abs(value_);
  }

  bool match(const double& number) const override {
    return std::abs(number - value_) <= tolerance_;
  }

  std::string describe() const override {
    return "agrees with the printed " + text_ + " within " + Catch::Detail::stringify(tolerance_);
  }

 private:
  std::string text_;
  double value_ = 0.0;
  double tolerance_ = 0.0;
};

inline Printed printed(std::string text) { return Printed(std::move(text)); }
