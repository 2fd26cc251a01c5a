// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "driver/base/text/tics.hpp"
#include "driver/case/quantity.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/drawn_coefficients.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/results/coverage.hpp"

namespace slipbench::driver::plot {
namespace {

constexpr std::size_t kMostMaps = 4;
constexpr int kMapColumns = 160;
constexpr int kMapRows = 120;

struct Axis {
  double from = 0.0;
  double to = 1.0;
  double factor = 1.0;  ///< of the argument for one unit of the axis: an area for a pressure
  std::string label;
  bool cut = false;  ///< the run goes further
};

/// Puts a number in the place of an argument.
void put(const DrawnArgument& argument, double value, law::Ambient& ambient,
         std::array<double, law::kMaxFields>& fields, law::SlipArguments& slip) {
  switch (argument.kind) {
    case law::IndependentKind::kSlipRate:
      slip.slip_rate = value;
      break;
    case law::IndependentKind::kContactForce:
      slip.contact_force = value;
      break;
    case law::IndependentKind::kAccumulatedSlip:
      slip.accumulated_slip = value;
      break;
    case law::IndependentKind::kTemperature:
      ambient.temperature = value;
      break;
    case law::IndependentKind::kField:
      fields[static_cast<std::size_t>(argument.index)] = value;
      break;
    case law::IndependentKind::kPosition:
      ambient.position[argument.index] = value;
      break;
    case law::IndependentKind::kConstitutiveMotion:
      ambient.motion[argument.index] = value;
      break;
  }
}

std::string label_of(const DrawnArgument& argument, const DrawnCoefficient& coefficient,
                     double area, const base::UnitSystem& units) {
  const bool turns = coefficient.rotational;
  base::Dimension rate = turns ? base::kAngle : base::kLength;
  rate.time -= 1;
  base::Dimension force = turns ? base::kMoment : base::kForce;
  switch (argument.kind) {
    case law::IndependentKind::kSlipRate:
      return axis_label("slip rate V", {"", base::unit_text(rate, units)});
    case law::IndependentKind::kContactForce:
      if (area > 0.0) {
        force.length -= 2;
        return axis_label("pressure p", {"", base::unit_text(force, units)});
      }
      return axis_label(turns ? "normal moment F_N" : "normal force F_N",
                        {"", base::unit_text(force, units)});
    case law::IndependentKind::kAccumulatedSlip:
      return axis_label("accumulated slip",
                        {"", base::unit_text(turns ? base::kAngle : base::kLength, units)});
    case law::IndependentKind::kTemperature:
      return axis_label("temperature", {"", units.temperature});
    case law::IndependentKind::kField:
      return results::independent_name(argument);
    case law::IndependentKind::kPosition:
    case law::IndependentKind::kConstitutiveMotion:
      return axis_label(
          law::is_rotation(argument.index) ? "angle" : "position",
          {results::independent_name(argument),
           base::unit_text(law::is_rotation(argument.index) ? base::kAngle : base::kLength,
                           units)});
  }
  return {};
}

/// From what the law has to show and what the run visited.
Axis axis_of(const DrawnCoefficient& coefficient, std::size_t k, const base::UnitSystem& units) {
  const DrawnArgument& argument = coefficient.arguments[k];
  const auto [least, most] = coefficient.visited.range(k);
  const bool from_zero = argument.kind == law::IndependentKind::kSlipRate ||
                         argument.kind == law::IndependentKind::kContactForce ||
                         argument.kind == law::IndependentKind::kAccumulatedSlip;
  const double area =
      argument.kind == law::IndependentKind::kContactForce ? law::area_of(coefficient.law) : 0.0;
  Axis axis;
  axis.label = label_of(argument, coefficient, area, units);
  axis.factor = area > 0.0 ? area : 1.0;
  const law::LawRange range = law::range(coefficient.law);
  double from = std::min(least, most);
  double to = most;
  double of_law = argument.kind == law::IndependentKind::kSlipRate       ? range.slip_rate
                  : argument.kind == law::IndependentKind::kContactForce ? range.contact_force
                                                                         : 0.0;
  if (const auto* table = std::get_if<law::TabularCoefficient>(&coefficient.law)) {
    const auto all = table->table.independents();
    const auto found = std::find(all.begin(), all.end(), argument);
    if (found != all.end()) {
      const auto knots = table->table.table().knots(static_cast<int>(found - all.begin()));
      const double room = 0.05 * (knots.back() - knots.front());
      from = std::min(from, knots.front() - room);
      of_law = std::max(of_law, knots.back() + room);
    }
  }
  if (from_zero && of_law > 0.0 && to > kFarthest * of_law) {
    to = kFarthest * of_law;
    axis.cut = true;
  } else {
    to = std::max(of_law, from_zero ? 1.06 * to : to);
  }
  if (from_zero) from = 0.0;
  if (!(to > from) || !std::isfinite(to - from)) {
    from = from_zero ? 0.0 : from - 0.5;
    to = from + 1.0;
  }
  axis.from = from / axis.factor;
  axis.to = to / axis.factor;
  return axis;
}

/// "temperature 80, field1 2, as the run ends": what else the coefficient depends on.
std::string fixed_text(const DrawnCoefficient& coefficient, const law::Ambient& ambient,
                       const law::SlipArguments& slip) {
  const auto* table = std::get_if<law::TabularCoefficient>(&coefficient.law);
  if (table == nullptr) return {};
  std::string text;
  for (const law::Independent& independent : table->table.independents()) {
    if (independent == coefficient.arguments[0] || independent == coefficient.arguments[1]) {
      continue;
    }
    text +=
        fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ", results::independent_name(independent),
                    law::argument(independent, ambient, slip));
  }
  return text.empty() ? text : "at " + text + ", as the run ends";
}

class Maps {
 public:
  Maps(const cases::Case& problem, const DrawnCoefficients& all) : problem_(problem), all_(all) {}

  void add(std::size_t entry) {
    const DrawnCoefficient& coefficient = all_.list()[entry];
    const std::array<Axis, 2> axes{axis_of(coefficient, 0, problem_.units),
                                   axis_of(coefficient, 1, problem_.units)};
    law::Ambient ambient = all_.ambient();
    std::array<double, law::kMaxFields> fields{};
    std::copy_n(ambient.fields.begin(), fields.size(), fields.begin());
    ambient.fields = fields;
    law::SlipArguments slip{0.0, coefficient.visited.largest_contact_force(),
                            all_.accumulated_slip(entry)};
    script_.add("NAME", coefficient.title);
    std::string note = fixed_text(coefficient, ambient, slip);
    for (std::size_t k = 0; k < 2; ++k) {
      if (!axes[k].cut) continue;
      note += fmt::format("{}the run reaches {:.4g} {}", note.empty() ? "" : "; ",
                          coefficient.visited.range(k)[1] / axes[k].factor,
                          k == 0 ? "to the right" : "above");
    }
    script_.add("NOTE", note);
    double low = 0.0;
    double high = 0.0;
    bool any = false;
    // Contours need a grid in rows, which a blank line divides; images do not mind.
    for (int r = 0; r <= kMapRows; ++r) {
      for (int c = 0; c <= kMapColumns; ++c) {
        const double x = axes[0].from + (axes[0].to - axes[0].from) * c / kMapColumns;
        const double y = axes[1].from + (axes[1].to - axes[1].from) * r / kMapRows;
        put(coefficient.arguments[0], x * axes[0].factor, ambient, fields, slip);
        put(coefficient.arguments[1], y * axes[1].factor, ambient, fields, slip);
        const double mu = law::evaluate(coefficient.law, ambient, slip).mu;
        map_ += fmt::format("{:.9g} {:.9g} {:.6g}\n", x, y, mu);
        if (!std::isfinite(mu)) continue;
        low = any ? std::min(low, mu) : mu;
        high = any ? std::max(high, mu) : mu;
        any = true;
      }
      map_ += '\n';
    }
    map_ += '\n';
    add_points(coefficient, axes);
    add_states(coefficient, axes);
    constexpr std::array<const char*, 2> kNames{"X", "Y"};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string name = kNames[k];
      script_.add(name + "_LABEL", axes[k].label);
      script_.add(name + "_FROM", axes[k].from);
      script_.add(name + "_TO", axes[k].to);
      script_.add(name + "_STEP", base::tic_step(axes[k].to - axes[k].from, 6.0));
    }
    // Contours in round numbers; a coefficient that hardly varies here gets the range of its own
    // size, not that of its rounding.
    const double least = 0.02 * std::max(std::abs(high), 1e-12);
    if (high - low < least) {
      high += 0.5 * least;
      low = std::max(0.0, low - 0.5 * least);
    }
    script_.add("MU_LOW", low);
    script_.add("MU_HIGH", high);
    const double step = base::tic_step(high - low, 6.0);
    script_.add("MU_STEP", step);
    script_.add("MU_FIRST", step * std::ceil(low / step));
    script_.add("TABLE", has_grid_ ? 1 : 0);
    script_.add("STICK_NAME", coefficient.creeps ? "visited below the limit" : "visited in stick");
    ++count_;
  }

  PlotScript finish() {
    script_.set("MAPS", count_);
    script_.block("MAP", std::move(map_));
    script_.block("POINTS", std::move(points_));
    script_.block("STATES", std::move(states_));
    return std::move(script_);
  }

 private:
  /// The points of a table over both arguments. Those that would cover one another are drawn once.
  void add_points(const DrawnCoefficient& coefficient, const std::array<Axis, 2>& axes) {
    has_grid_ = false;
    if (const auto* table = std::get_if<law::TabularCoefficient>(&coefficient.law)) {
      const auto all = table->table.independents();
      std::array<std::size_t, 2> columns{};
      for (std::size_t k = 0; k < 2; ++k) {
        columns[k] = static_cast<std::size_t>(
            std::find(all.begin(), all.end(), coefficient.arguments[k]) - all.begin());
      }
      const bool over_both = columns[0] < all.size() && columns[1] < all.size();
      const law::Table& points = table->table.table();
      std::set<std::array<long, 2>> drawn;
      for (std::size_t row = 0; over_both && row < points.rows(); ++row) {
        const std::vector<double> point = points.point(row);
        std::array<double, 2> at{};
        std::array<long, 2> place{};
        for (std::size_t k = 0; k < 2; ++k) {
          at[k] = point[columns[k]] / axes[k].factor;
          const double part = (at[k] - axes[k].from) / (axes[k].to - axes[k].from);
          place[k] = std::lround(1000.0 * std::clamp(part, -1.0, 2.0));
        }
        if (!drawn.insert(place).second) continue;
        points_ += fmt::format("{:.9g} {:.9g}\n", at[0], at[1]);
        has_grid_ = true;
      }
    }
    points_ += "NaN NaN\n\n\n";  // an empty block cannot be plotted
  }

  /// States that would cover one another in the picture are drawn once.
  void add_states(const DrawnCoefficient& coefficient, const std::array<Axis, 2>& axes) {
    bool sticks = false;
    bool slips = false;
    std::set<std::array<int, 3>> drawn;
    for (const Visited& state : coefficient.visited.states()) {
      std::array<double, 2> at{};
      std::array<int, 3> cell{state.status, 0, 0};
      bool inside = true;
      for (std::size_t k = 0; k < 2; ++k) {
        at[k] = state.argument[k] / axes[k].factor;
        const double width = axes[k].to - axes[k].from;
        inside = inside && at[k] >= axes[k].from && at[k] <= axes[k].to;
        if (inside)
          cell[k + 1] = static_cast<int>(std::lround(100.0 * (at[k] - axes[k].from) / width));
      }
      if (!inside || !drawn.insert(cell).second) continue;
      (state.status == 2 ? slips : sticks) = true;
      states_ += fmt::format("{} {:.9g} {:.9g}\n", state.status, at[0], at[1]);
    }
    states_ += "0 NaN NaN\n\n\n";
    script_.add("STICKS", sticks ? 1 : 0);
    script_.add("SLIPS", slips ? 1 : 0);
  }

  const cases::Case& problem_;
  const DrawnCoefficients& all_;
  PlotScript script_;
  int count_ = 0;
  bool has_grid_ = false;  ///< of the last one added
  std::string map_;
  std::string points_;
  std::string states_;
};

}  // namespace

tl::expected<void, PlotFailure> draw_mu_map(const PlotOptions& options,
                                            const std::filesystem::path& picture) {
  if (is_result(options)) {
    return failed(base::kExitBadInput,
                  options.input + ": a result does not say its coefficients; give the case");
  }
  auto begun = begin_picture(picture, options, "mu_map.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  const auto problem = read_for_plot(options);
  if (!problem) return tl::unexpected(problem.error());
  DrawnCoefficients all(*problem, true);
  if (all.list().empty()) {
    return failed(base::kExitBadInput,
                  options.input +
                      ": no coefficient of this case depends on anything: there is no map to draw");
  }
  auto followed = follow_for_plot(
      *problem, [&](const bench::Simulation& simulation) { all.visit(simulation); });
  if (!followed) return followed;
  Maps maps(*problem, all);
  const std::size_t count = std::min(kMostMaps, all.list().size());
  for (std::size_t i = 0; i < count; ++i) maps.add(i);
  std::string title = picture_title(*problem);
  if (count < all.list().size()) {
    title += fmt::format(" (the first {} of {} coefficients)", count, all.list().size());
  }
  return draw(maps.finish(), title, 60 + 520 * count, *begun);
}

}  // namespace slipbench::driver::plot
