// SPDX-License-Identifier: Apache-2.0
#include "driver/import/abaqus/profile_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "driver/base/text/format_number.hpp"
#include "driver/base/units/expression.hpp"

namespace slipbench::driver::abaqus {
namespace {

using Points = std::vector<std::pair<double, double>>;  ///< time, value

/// An amplitude that is a polyline, constant outside of it; a deck may have thousands of steps,
/// each of which sees a part.
class Polyline {
 public:
  /// \param begin total time at which the step begins
  Polyline(const Amplitude& amplitude, double begin)
      : amplitude_(amplitude),
        spaced_(amplitude.kind == Amplitude::Kind::kEquallySpaced),
        before_(amplitude.total_time ? begin : 0.0) {}

  std::size_t size() const { return amplitude_.numbers.size() / (spaced_ ? 1 : 2); }

  /// Cuts it to 0 .. period of the step, whose ends it gets.
  Points covering(double period) const {
    Points cut{{0.0, value_at(0.0)}};
    for (std::size_t i = first([&](double t) { return t > 0.0; }); i < size() && time(i) < period;
         ++i) {
      cut.emplace_back(time(i), value(i));
    }
    cut.emplace_back(period, value_at(period));
    return cut;
  }

 private:
  double time(std::size_t i) const {
    return (spaced_ ? amplitude_.begin + static_cast<double>(i) * amplitude_.interval
                    : amplitude_.numbers[2 * i]) -
           before_;
  }
  double value(std::size_t i) const { return amplitude_.numbers[spaced_ ? i : 2 * i + 1]; }

  /// The first point whose time is one of those that `has_come` holds for, from some time on.
  template <class HasCome>
  std::size_t first(const HasCome& has_come) const {
    std::size_t low = 0;
    for (std::size_t high = size(); low < high;) {
      const std::size_t middle = low + (high - low) / 2;
      if (has_come(time(middle))) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }

  double value_at(double when) const {
    const std::size_t i = first([&](double t) { return t >= when; });
    if (i == 0) return value(0);
    if (i == size()) return value(i - 1);
    const double t0 = time(i - 1);
    const double t1 = time(i);
    return value(i - 1) + (value(i) - value(i - 1)) * ((when - t0) / (t1 - t0));
  }

  const Amplitude& amplitude_;
  bool spaced_;
  double before_;
};

std::string table_text(const std::string& name, const Points& points) {
  std::string rows;
  for (const auto& [time, value] : points) {
    rows +=
        fmt::format("{}[{}, {}]", rows.empty() ? "" : ", ", number_text(value), number_text(time));
  }
  return fmt::format("{{columns: [{}, t], rows: [{}]}}", name, rows);
}

/// A formula of an amplitude over the time of the step: "(t - 0.5)" is its time. Nothing where it
/// has none, or one that is too long.
std::string formula_of(const Amplitude& amplitude) {
  const std::string time = amplitude.total_time ? "T" : "t";
  const auto at = [&](std::size_t i) {
    return i < amplitude.numbers.size() ? amplitude.numbers[i] : 0.0;
  };
  const auto since = [&](double t0) {
    return t0 == 0.0 ? time : fmt::format("({} - ({}))", time, number_text(t0));
  };
  const auto after = [&](double t0, const std::string& before, const std::string& formula) {
    if (t0 <= 0.0) return formula;
    return fmt::format("({} < {} ? {} : {})", time, number_text(t0), before, formula);
  };
  switch (amplitude.kind) {
    case Amplitude::Kind::kPeriodic: {
      // N, omega, t0, A0; then A, B of each harmonic.
      const auto count = static_cast<std::size_t>(std::clamp(at(0), 0.0, 1000.0));
      std::string sum = number_text(at(3));
      for (std::size_t n = 1; n <= count; ++n) {
        const std::string angle = fmt::format("{}*{}*{}", n, number_text(at(1)), since(at(2)));
        const double a = at(4 + 2 * (n - 1));
        const double b = at(5 + 2 * (n - 1));
        if (a != 0.0) sum += fmt::format(" + {}*cos({})", number_text(a), angle);
        if (b != 0.0) sum += fmt::format(" + {}*sin({})", number_text(b), angle);
      }
      return after(at(2), number_text(at(3)), "(" + sum + ")");
    }
    case Amplitude::Kind::kDecay: {
      // A0, A, t0, t_d.
      if (at(3) <= 0.0) return {};
      return after(at(2), number_text(at(0)),
                   fmt::format("({} + {}*exp(-{}/{}))", number_text(at(0)), number_text(at(1)),
                               since(at(2)), number_text(at(3))));
    }
    case Amplitude::Kind::kSmoothStep: {
      std::string text = number_text(at(amplitude.numbers.size() - 1));
      for (std::size_t i = amplitude.numbers.size() / 2; i-- > 1;) {
        const double t0 = at(2 * i - 2);
        const double width = at(2 * i) - t0;
        if (!(width > 0.0)) return {};
        const std::string x = fmt::format("({}/{})", since(t0), number_text(width));
        const std::string piece =
            fmt::format("{} + {}*{}^3*(10 - 15*{} + 6*{}^2)", number_text(at(2 * i - 1)),
                        number_text(at(2 * i + 1) - at(2 * i - 1)), x, x, x);
        text = fmt::format("({} < {} ? {} : {})", time, number_text(at(2 * i)), piece, text);
        if (text.size() > base::kLongestFormula) return {};
      }
      return after(at(0), number_text(at(1)), text);
    }
    default:
      return {};
  }
}

/// The value of an amplitude that formula_of writes, at a time of its own.
double value_of(const Amplitude& amplitude, double time) {
  const auto at = [&](std::size_t i) {
    return i < amplitude.numbers.size() ? amplitude.numbers[i] : 0.0;
  };
  if (amplitude.kind == Amplitude::Kind::kPeriodic) {
    double sum = at(3);
    if (time < at(2)) return sum;
    const auto count = static_cast<std::size_t>(std::clamp(at(0), 0.0, 1000.0));
    for (std::size_t n = 1; n <= count; ++n) {
      const double angle = static_cast<double>(n) * at(1) * (time - at(2));
      sum += at(2 * n + 2) * std::cos(angle) + at(2 * n + 3) * std::sin(angle);
    }
    return sum;
  }
  if (amplitude.kind == Amplitude::Kind::kDecay) {
    return time < at(2) ? at(0) : at(0) + at(1) * std::exp(-(time - at(2)) / at(3));
  }
  for (std::size_t i = 1; i < amplitude.numbers.size() / 2; ++i) {
    if (time >= at(2 * i)) continue;
    const double x = std::max(0.0, (time - at(2 * i - 2)) / (at(2 * i) - at(2 * i - 2)));
    return at(2 * i - 1) + (at(2 * i + 1) - at(2 * i - 1)) * x * x * x * (10 - 15 * x + 6 * x * x);
  }
  return at(amplitude.numbers.size() - 1);
}

constexpr int kPieces = 20;  ///< straight ones of an arc

/// Integral of a polyline of velocities, at enough points that its arcs are straight.
Points integrated(const Points& velocities, double start) {
  Points points{{velocities.front().first, start}};
  for (std::size_t i = 1; i < velocities.size(); ++i) {
    const auto& [t0, v0] = velocities[i - 1];
    const auto& [t1, v1] = velocities[i];
    const double position = points.back().second;
    const int pieces = v0 == v1 ? 1 : kPieces;
    for (int k = 1; k <= pieces; ++k) {
      const double way = (t1 - t0) * k / pieces;
      const double slope = t1 > t0 ? (v1 - v0) / (t1 - t0) : 0.0;
      points.emplace_back(k == pieces ? t1 : t0 + way,
                          position + v0 * way + 0.5 * slope * way * way);
    }
  }
  return points;
}

/// The number of fewest digits whose frequency is the given one.
double period_of(double frequency) {
  const double period = 2.0 * std::numbers::pi / frequency;
  constexpr int kAllDigits = 17;
  for (int digits = 1; digits <= kAllDigits; ++digits) {
    const double shorter = base::rounded_number(period, digits);
    if (2.0 * std::numbers::pi / shorter == frequency) return shorter;
  }
  return period;
}

/// A smooth step over the whole step, or a single sine, which cases have words for.
std::optional<DriveProfile> plain_profile(const Amplitude& amplitude, const Step& step,
                                          double factor, double initial, double current) {
  const std::vector<double>& n = amplitude.numbers;
  if (amplitude.total_time) return std::nullopt;
  if (amplitude.kind == Amplitude::Kind::kSmoothStep && n.size() == 4 && n[0] == 0.0 &&
      n[2] == step.period && factor * n[1] + initial == current) {
    const double end = factor * n[3] + initial;
    return DriveProfile{fmt::format("{{smooth_to: {}}}", number_text(end)), end};
  }
  const bool sine = amplitude.kind == Amplitude::Kind::kPeriodic && n.size() == 6 && n[0] == 1.0 &&
                    n[1] > 0.0 && n[2] == 0.0 && n[4] == 0.0;
  if (!sine) return std::nullopt;
  const double mean = factor * n[3] + initial;
  const double height = factor * n[5];
  const double end = mean + height * std::sin(n[1] * step.period);
  return DriveProfile{fmt::format("{{sine: {{amplitude: {}, period: {}{}}}}}", number_text(height),
                                  number_text(period_of(n[1])),
                                  mean == 0.0 ? std::string() : ", mean: " + number_text(mean)),
                      end};
}

}  // namespace

std::string number_text(double number) { return base::format_number(number); }

DriveProfile profile_of(const KeywordDeck& deck, const Model& model, const Step& step,
                        const Drive& drive, const std::string& name, double initial, double current,
                        double begin) {
  const std::string place = deck.place(drive.where);
  if (drive.user) {
    return {{},
            current,
            fmt::format("{} ({}): USER, a subroutine gives its values, which are asked for here",
                        name, place)};
  }
  if (drive.fixed) return {fmt::format("{{to: {}}}", number_text(current)), current};
  if (drive.type == "ACCELERATION" && !drive.is_load) {
    return {{}, current, fmt::format("{} ({}): an acceleration is not taken over", name, place)};
  }
  const bool velocity = !drive.is_load && drive.type == "VELOCITY";
  if (drive.amplitude.empty()) {
    if (velocity) {
      const double end = current + drive.magnitude * step.period;
      return {fmt::format("{{to: {}}}", number_text(end)), end, {}, drive.magnitude};
    }
    const double end = initial + drive.magnitude;
    if (step.at_once.value_or(drive.is_load && !step.is_static)) {
      if (drive.is_load) return {number_text(end), end};
      // A motion goes over a time: there from the start on, it is made in the first increment.
      return {table_text(name, {{0.0, end}, {step.period, end}}), end};
    }
    return {fmt::format("{{to: {}}}", number_text(end)), end};
  }
  const Amplitude* const amplitude = find_amplitude(model, drive.amplitude);
  if (amplitude == nullptr) {
    return {{}, current, fmt::format("{} ({}): there is no *AMPLITUDE of that name", name, place)};
  }
  const double factor = amplitude->absolute ? 1.0 : drive.magnitude;
  const bool polyline = amplitude->kind == Amplitude::Kind::kTabular ||
                        amplitude->kind == Amplitude::Kind::kEquallySpaced;
  if (polyline) {
    const Polyline whole(*amplitude, begin);
    if (whole.size() == 0) {
      return {{}, current, fmt::format("{} ({}): its amplitude is empty", name, place)};
    }
    Points points = whole.covering(step.period);
    constexpr std::size_t kMostPoints = 100'000;
    if (points.size() * static_cast<std::size_t>(velocity ? kPieces : 1) > kMostPoints) {
      return {
          {},
          current,
          fmt::format("{} ({}): its amplitude has more points than are taken over", name, place)};
    }
    for (auto& point : points) point.second *= factor;
    std::string note;
    if (amplitude->smoothed) {
      note = fmt::format("{} ({}): SMOOTH rounds the corners of its amplitude, which stay here",
                         name, place);
    }
    const double rate = velocity ? points.back().second : 0.0;
    if (velocity) {
      points = integrated(points, current);
      note += note.empty() ? "" : "; ";
      note += fmt::format("{} ({}): the integral of its velocity is drawn with straight pieces",
                          name, place);
    } else {
      for (auto& point : points) point.second += initial;
    }
    return {table_text(name, points), points.back().second, note, rate};
  }
  if (auto plain = plain_profile(*amplitude, step, factor, initial, current); plain && !velocity) {
    return *plain;
  }
  const std::string formula = velocity ? std::string() : formula_of(*amplitude);
  if (formula.empty() || formula.size() > base::kLongestFormula) {
    return {{},
            current,
            fmt::format("{} ({}): its amplitude ({}) is not taken over", name, place,
                        deck.place(amplitude->where))};
  }
  std::string text = fmt::format("{}*{}", number_text(factor), formula);
  if (initial != 0.0) text = fmt::format("{} + {}", number_text(initial), text);
  // The value at the end matters to steps that set out from it.
  const double time = step.period + (amplitude->total_time ? begin : 0.0);
  return {fmt::format("\"= {}\"", text), initial + factor * value_of(*amplitude, time)};
}

}  // namespace slipbench::driver::abaqus
