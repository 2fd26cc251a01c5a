// SPDX-License-Identifier: Apache-2.0
#include "driver/export/fmu/parameter_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include "driver/export/fmu/formula_names.hpp"
#include "law/definition/packed_definition.hpp"

namespace slipbench::driver::exports {
namespace {

constexpr const char* kCurve = "the friction follows it by a curve, or together with others";
constexpr const char* kPlace = "the connector begins at another place with it";
constexpr const char* kTooLong =
    "the friction is too long to be read again for as many parameters as it has";
/// Numbers and characters of formulas that are read again for all parameters together, a second or
/// two.
constexpr std::size_t kMostRead = 2'000'000;

/// The case with other values of its parameters.
class Varied {
 public:
  Varied(const read::ParsedCase& parsed, const std::vector<base::ParameterText>& settings)
      : parsed_(parsed), settings_(settings) {}

  /// Packed numbers of the friction; nothing where the value is refused.
  std::optional<std::vector<double>> numbers(const std::string& name, double value) const {
    const auto definitions =
        parsed_.resolve_friction_only({.overrides = with(name, value), .allow_outside = true});
    if (!definitions) return std::nullopt;
    std::vector<law::FrictionDefinition> laws;
    laws.reserve(definitions->size());
    for (const cases::CaseDefinition& one : *definitions) laws.push_back(one.law);
    return law::pack_all(laws);
  }

  /// Tells whether the connector begins at another place, or counts its motion from another.
  bool moves_the_begin(const std::string& name, double value, const cases::Case& problem) const {
    const auto other = parsed_.resolve({.overrides = with(name, value), .allow_outside = true});
    return other.value &&
           (other.value->initial != problem.initial || other.value->reference != problem.reference);
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

/// Names that the formulas of a case mention, by what the formulas are about.
class Formulas {
 public:
  Formulas(const read::ParsedCase& parsed, const std::vector<base::ParameterText>& settings) {
    std::map<std::string, std::string> parameters;  // those that are formulas
    if (const auto map = parsed.root().find("parameters"); map && map->is_map()) {
      for (const yaml::Entry entry : map->entries()) {
        const std::string_view text = entry.value.text();
        if (text.starts_with('=')) parameters[std::string(entry.key.text())] = text;
      }
    }
    for (const base::ParameterText& one : settings) {
      parameters.erase(one.name);
      if (const auto* text = std::get_if<std::string>(&one.value)) parameters[one.name] = *text;
    }
    for (const auto& [name, text] : parameters) {
      length_ += text.size();
      in_pieces_.merge(names_in_pieces(text));
      const auto& mentioned = defined_by_.emplace(name, names_in(text)).first->second;
      for (const std::string& one : mentioned) followers_[one].push_back(name);
    }
    std::vector<yaml::Formula> all;
    parsed.resolve({.overrides = settings, .allow_outside = true, .formulas = &all});
    for (const yaml::Formula& one : all) {
      const std::string_view path = one.path;
      if (path.starts_with("history") || path.starts_with("output") || path.starts_with("checks"))
        continue;
      if (path.starts_with("connector.initial") || path.starts_with("connector.reference")) {
        place_.merge(names_in(one.text));
      } else {
        length_ += one.text.size();
        friction_.merge(names_in(one.text));
        in_pieces_.merge(names_in_pieces(one.text));
      }
    }
  }

  /// Characters in all formulas of the parameters and of the friction.
  std::size_t length() const { return length_; }
  /// Tells whether a parameter is defined by other ones.
  bool is_defined(const std::string& name, const base::NamedNumbers& parameters) const {
    const auto found = defined_by_.find(name);
    return found != defined_by_.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [&](const std::string& one) { return parameters.contains(one); });
  }
  /// The parameter and all that are defined by it.
  std::set<std::string> with_followers(const std::string& name) const {
    std::set<std::string> found{name};
    for (std::vector<std::string> next{name}; !next.empty();) {
      const auto direct = followers_.find(next.back());
      next.pop_back();
      if (direct == followers_.end()) continue;
      for (const std::string& one : direct->second) {
        if (found.insert(one).second) next.push_back(one);
      }
    }
    return found;
  }
  bool place_mentions(const std::set<std::string>& names) const { return share(place_, names); }
  bool friction_mentions(const std::set<std::string>& names) const {
    return share(friction_, names);
  }
  /// Tells whether the friction depends on one of the names in pieces.
  bool friction_has_pieces(const std::set<std::string>& names) const {
    return friction_mentions(names) && share(in_pieces_, names);
  }

 private:
  static bool share(const std::set<std::string>& all, const std::set<std::string>& names) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& one) { return all.contains(one); });
  }

  std::map<std::string, std::set<std::string>> defined_by_;    ///< of parameters with a formula
  std::map<std::string, std::vector<std::string>> followers_;  ///< that mention a name
  std::set<std::string> friction_, place_, in_pieces_;
  std::size_t length_ = 0;
};

/// The friction at another value of a parameter.
struct Sample {
  double value = 0.0;
  std::vector<double> numbers;
};

/// Other values of a parameter: of no symmetry, near and far, on both sides of it and of 0. Values
/// that a law refuses are no part of the line.
std::vector<double> other_values(double value) {
  constexpr std::array kParts{0.0625, -0.0546875, -0.13,  0.21,  -0.29,  0.43,  -0.61, 0.83,
                              -0.87,  1.3,        -1.7,   2.9,   -3.1,   11.0,  -13.0, 97.0,
                              -103.0, 1013.0,     -997.0, 2.1e5, -1.9e5, 3.7e8, -4.1e8};
  constexpr std::array kAnywhere{0.0, 1e-3, 0.047, 0.53, 1.9, -1.1, 23.0, -17.0, 1.7e3, -2.3e3};
  const double size = value != 0.0 ? value : 1.0 / 64.0;
  std::vector<double> values;
  values.reserve(kParts.size() + kAnywhere.size());
  for (const double part : kParts) values.push_back(value + part * size);
  for (const double x : kAnywhere) {
    if (x != value) values.push_back(x);
  }
  return values;
}

/// The number as a function of the parameter; nothing where it is no straight line.
std::optional<FollowingNumber> follow(std::size_t index, double p, double n,
                                      const std::vector<Sample>& samples) {
  const double ratio = n / p;
  const auto in_proportion = [&](const Sample& one) {
    return one.numbers[index] == ratio * one.value;
  };
  if (p != 0.0 && std::all_of(samples.begin(), samples.end(), in_proportion)) {
    return FollowingNumber{index, true, ratio};
  }
  const Sample& far =
      *std::max_element(samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) {
        return std::abs(a.value - p) < std::abs(b.value - p);
      });
  const double slope = (far.numbers[index] - n) / (far.value - p);
  const auto on_line = [&](const Sample& one) {
    const double step = slope * (one.value - p);
    const double x = one.numbers[index];
    // Rounding of the formula; a curve differs by far more at some of so many values.
    constexpr double kStraight = 1e-12;
    return std::abs(n + step - x) <=
           kStraight * std::max({std::abs(n), std::abs(x), std::abs(step)});
  };
  if (!std::all_of(samples.begin(), samples.end(), on_line)) return std::nullopt;
  return FollowingNumber{index, false, slope};
}

/// The friction at all values that are not refused.
std::vector<Sample> samples_of(const Varied& varied, const std::string& name, double value) {
  std::vector<Sample> samples;
  for (const double x : other_values(value)) {
    if (auto numbers = varied.numbers(name, x)) samples.push_back({x, *std::move(numbers)});
  }
  return samples;
}

/// All numbers that follow a parameter; nothing where one does so by a curve, or is not known to do
/// otherwise.
std::optional<MappedParameter> mapped(const std::string& name, double value,
                                      const std::vector<Sample>& samples,
                                      const std::vector<double>& numbers) {
  MappedParameter found{name, value, {}};
  for (const Sample& one : samples) {
    if (one.numbers.size() != numbers.size()) return std::nullopt;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto same = [&](const Sample& one) { return one.numbers[i] == numbers[i]; };
    if (std::all_of(samples.begin(), samples.end(), same)) continue;
    const auto one = follow(i, value, numbers[i], samples);
    if (!one) return std::nullopt;
    found.numbers.push_back(*one);
  }
  return found;
}

}  // namespace

ParameterMap map_parameters(const read::ParsedCase& parsed, const cases::Case& problem,
                            const std::vector<base::ParameterText>& settings,
                            const std::vector<double>& numbers) {
  const Varied varied(parsed, settings);
  const Formulas formulas(parsed, settings);
  ParameterMap map;
  std::map<std::size_t, int> users;
  std::size_t read = 0;
  for (const auto& parameter : problem.parameters) {
    const std::string& name = parameter.first;
    const double value = parameter.second;
    if (formulas.is_defined(name, problem.parameters)) continue;
    const std::set<std::string> names = formulas.with_followers(name);
    if (!formulas.friction_mentions(names) && !formulas.place_mentions(names)) continue;
    if (read >= kMostRead) {
      map.fixed.push_back({name, kTooLong});
      continue;
    }
    const std::vector<Sample> samples = samples_of(varied, name, value);
    read += other_values(value).size() * (numbers.size() + formulas.length());
    auto found = mapped(name, value, samples, numbers);
    // Two values beside its own are the least that tell a line from a curve.
    constexpr std::size_t kLeast = 2;
    if (samples.size() < kLeast || formulas.friction_has_pieces(names)) found.reset();
    if (!found) {
      map.fixed.push_back({name, kCurve});
      continue;
    }
    const bool places =
        formulas.place_mentions(names) ||
        std::any_of(samples.begin(), samples.begin() + kLeast, [&](const Sample& one) {
          return varied.moves_the_begin(name, one.value, problem);
        });
    for (const FollowingNumber& one : found->numbers) ++users[one.index];
    if (places)
      map.fixed.push_back({name, kPlace});
    else if (!found->numbers.empty())
      map.parameters.push_back(*std::move(found));
  }
  // Two parameters of one number multiply each other, or may do.
  std::erase_if(map.parameters, [&](const MappedParameter& one) {
    const bool shared =
        std::any_of(one.numbers.begin(), one.numbers.end(),
                    [&](const FollowingNumber& number) { return users[number.index] > 1; });
    if (shared) map.fixed.push_back({one.name, kCurve});
    return shared;
  });
  return map;
}

}  // namespace slipbench::driver::exports
