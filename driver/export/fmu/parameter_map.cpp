// SPDX-License-Identifier: Apache-2.0
#include "driver/export/fmu/parameter_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "law/definition/packed_definition.hpp"

namespace slipbench::driver::exports {
namespace {

/// Friction of the case with other values of its parameters.
class Varied {
 public:
  Varied(const read::ParsedCase& parsed, const std::vector<base::ParameterText>& settings)
      : parsed_(parsed), settings_(settings) {}

  /// Packed numbers; nothing where the value is refused.
  std::optional<std::vector<double>> numbers(const std::string& name, double value) const {
    const auto definitions =
        parsed_.resolve_friction_only({.overrides = with(name, value), .allow_outside = true});
    if (!definitions) return std::nullopt;
    std::vector<law::FrictionDefinition> laws;
    laws.reserve(definitions->size());
    for (const cases::CaseDefinition& one : *definitions) laws.push_back(one.law);
    return law::pack_all(laws);
  }

  /// Parameters whose values change with it, itself left out.
  std::set<std::string> followers(const std::string& name, double value,
                                  const base::NamedNumbers& now) const {
    std::set<std::string> found;
    const auto changed = parsed_.resolve_parameters_only({.overrides = with(name, value)});
    if (!changed) return found;
    for (const auto& [other, number] : *changed) {
      const auto before = now.find(other);
      if (other != name && before != now.end() && before->second != number) found.insert(other);
    }
    return found;
  }

 private:
  std::vector<base::ParameterText> with(const std::string& name, double value) const {
    std::vector<base::ParameterText> all = settings_;
    all.push_back({name, value});
    return all;
  }

  const read::ParsedCase& parsed_;
  const std::vector<base::ParameterText>& settings_;
};

/// The number as a function of the parameter, from its values at two others; nothing where it is no
/// straight line.
std::optional<FollowingNumber> follow(std::size_t index, double p, double n,
                                      const std::array<double, 2>& other,
                                      const std::array<double, 2>& number) {
  const double ratio = n / p;
  if (p != 0.0 && number[0] == ratio * other[0] && number[1] == ratio * other[1]) {
    return FollowingNumber{index, true, ratio};
  }
  const double slope = (number[1] - number[0]) / (other[1] - other[0]);
  const double middle = number[0] + slope * (p - other[0]);
  const double size = std::max({std::abs(n), std::abs(number[0]), std::abs(number[1])});
  // Rounding of the formula; a curve differs by far more over the width of the two.
  constexpr double kStraight = 1e-12;
  if (!(std::abs(middle - n) <= kStraight * size)) return std::nullopt;
  return FollowingNumber{index, false, slope};
}

}  // namespace

ParameterMap map_parameters(const read::ParsedCase& parsed, const cases::Case& problem,
                            const std::vector<base::ParameterText>& settings,
                            const std::vector<double>& numbers) {
  const Varied varied(parsed, settings);
  ParameterMap map;
  std::set<std::string> followers;
  std::map<std::size_t, int> users;
  for (const auto& [name, value] : problem.parameters) {
    // On either side, by a part that changes no kind of anything; one that is 0 by a little.
    const double width = value != 0.0 ? value / 16.0 : 1.0 / 1024.0;
    std::array<double, 2> other{value - width, value + width};
    followers.merge(varied.followers(name, other[1], problem.parameters));
    auto low = varied.numbers(name, other[0]);
    if (!low) {
      other[0] = value + width / 2.0;  // a bound: both above it
      low = varied.numbers(name, other[0]);
    }
    const auto high = varied.numbers(name, other[1]);
    MappedParameter mapped{name, value, {}};
    bool straight = low && high && low->size() == numbers.size() && high->size() == numbers.size();
    for (std::size_t i = 0; straight && i < numbers.size(); ++i) {
      if ((*low)[i] == numbers[i] && (*high)[i] == numbers[i]) continue;
      const auto one = follow(i, value, numbers[i], other, {(*low)[i], (*high)[i]});
      straight = one.has_value();
      if (one) mapped.numbers.push_back(*one);
    }
    if (!straight) {
      map.fixed.push_back(name);
      continue;
    }
    for (const FollowingNumber& one : mapped.numbers) ++users[one.index];
    if (!mapped.numbers.empty()) map.parameters.push_back(std::move(mapped));
  }
  const auto defined = [&](const std::string& name) { return followers.contains(name); };
  for (const MappedParameter& one : map.parameters) {
    if (!defined(one.name)) continue;
    for (const FollowingNumber& number : one.numbers) --users[number.index];
  }
  std::erase_if(map.parameters, [&](const MappedParameter& one) { return defined(one.name); });
  std::erase_if(map.fixed, defined);
  // Two parameters of one number multiply each other, or may do.
  std::erase_if(map.parameters, [&](const MappedParameter& one) {
    const bool shared =
        std::any_of(one.numbers.begin(), one.numbers.end(),
                    [&](const FollowingNumber& number) { return users[number.index] > 1; });
    if (shared) map.fixed.push_back(one.name);
    return shared;
  });
  return map;
}

}  // namespace slipbench::driver::exports
