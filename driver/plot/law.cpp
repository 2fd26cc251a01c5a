// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/tics.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/drawn_coefficients.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/law_case.hpp"
#include "driver/plot/script.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::plot {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPictures = 4;
constexpr int kCurvePoints = 400;
constexpr int kSurfaceColumns = 120;
constexpr int kSurfaceRows = 80;

/// Extent of an axis: the features of the law, and the range that the run visited.
struct Extent {
  double end = 1.0;
  bool cut = false;  ///< the run goes further
};
Extent extent(double of_law, double visited) {
  if (of_law > 0.0 && visited > kFarthest * of_law) return {kFarthest * of_law, true};
  const double end = std::max(of_law, 1.06 * visited);
  return {end > 0.0 && std::isfinite(end) ? end : 1.0, false};
}

/// Round numbers from 0 to the end of an axis, at most four.
std::vector<double> levels(double end) {
  const double step = base::tic_step(end, 3.0);
  std::vector<double> list;
  for (int k = 0; k < 4 && k * step <= end * (1.0 + 1e-9); ++k) list.push_back(k * step);
  return list;
}

/// Script of one coefficient: the variables of the template, and the data.
class Script {
 public:
  /// \param without why there are no states of a run; empty if there are
  Script(const cases::Case& problem, const law::Ambient& ambient, std::string without)
      : problem_(problem), ambient_(ambient), without_(std::move(without)) {}

  void add(const DrawnCoefficient& coefficient) {
    ++count_;
    const law::FrictionLaw& law = coefficient.law;
    const bool by_rate = law::depends_on_slip_rate(law);
    const bool by_force = law::depends_on_contact_force(law);
    const law::LawRange range = law::range(law);
    const double area = law::area_of(law);
    const double per_force = area > 0.0 ? area : 1.0;
    const Extent rate =
        extent(by_rate ? range.slip_rate : 0.0, coefficient.visited.largest_slip_rate());
    const Extent force =
        extent(by_force ? range.contact_force : 0.0, coefficient.visited.largest_contact_force());
    const double pressure_end = force.end / per_force;
    const auto mu = [&](double v, double p) {
      return law::evaluate(law, ambient_, {.slip_rate = v, .contact_force = p * per_force}).mu;
    };

    base::Dimension force_dimension = coefficient.rotational ? base::kMoment : base::kForce;
    if (area > 0.0) force_dimension.length -= 2;
    base::Dimension rate_dimension = coefficient.rotational ? base::kAngle : base::kLength;
    rate_dimension.time -= 1;
    const std::string force_unit = base::unit_text(force_dimension, problem_.units);
    const std::string rate_unit = base::unit_text(rate_dimension, problem_.units);
    const std::string force_name = area > 0.0               ? "pressure p"
                                   : coefficient.rotational ? "normal moment F_N"
                                                            : "normal force F_N";
    script_.add("NAME", coefficient.title + ambient_text(law));
    script_.add("RATE_LABEL", axis_label("slip rate V", {"", rate_unit}));
    script_.add("LOAD_LABEL", axis_label(force_name, {"", force_unit}));
    script_.add("RATE_END", rate.end);
    script_.add("LOAD_END", pressure_end);
    script_.add("RATE_STEP", base::tic_step(rate.end, by_rate && by_force ? 4.0 : 6.0));
    script_.add("MAP_STEP", base::tic_step(rate.end, 4.0));
    script_.add("LOAD_STEP", base::tic_step(pressure_end, 4.0));
    script_.add("BY_RATE", by_rate ? 1 : 0);
    script_.add("BY_LOAD", by_force ? 1 : 0);
    std::string cut = without_;
    if (rate.cut)
      cut = fmt::format("the run reaches V = {:.4g}", coefficient.visited.largest_slip_rate());
    if (force.cut) {
      cut += fmt::format("{}the run reaches {} = {:.4g}", cut.empty() ? "" : ", ",
                         area > 0.0 ? "p" : "F_N",
                         coefficient.visited.largest_contact_force() / per_force);
    }
    script_.add("CUT", cut);
    script_.add("STICK_NAME", coefficient.creeps ? "visited below the limit" : "visited in stick");

    const std::vector<double> loads = by_force ? levels(pressure_end) : std::vector<double>{0.0};
    const std::vector<double> rates = by_rate ? levels(rate.end) : std::vector<double>{0.0};
    const char* const load_symbol = area > 0.0 ? "p" : "F_N";
    script_.add("OVER_RATE_NAMES", by_force ? names(load_symbol, loads) : "mu");
    script_.add("OVER_LOAD_NAMES", by_rate ? names("V", rates) : "mu");
    double top = 0.0;
    const auto curve = [&](std::string& out, double end, std::size_t number, const auto& value) {
      for (int k = 0; k <= kCurvePoints; ++k) {
        const double x = end * k / kCurvePoints;
        out += fmt::format("{:.6g}", x);
        for (std::size_t i = 0; i < number; ++i) {
          const double y = value(x, i);
          if (std::isfinite(y)) top = std::max(top, y);
          out += fmt::format(" {:.6g}", y);
        }
        out += '\n';
      }
      out += "\n\n";
    };
    curve(over_rate_, rate.end, loads.size(),
          [&](double v, std::size_t i) { return mu(v, loads[i]); });
    curve(over_load_, pressure_end, rates.size(),
          [&](double p, std::size_t i) { return mu(rates[i], p); });
    for (int r = 0; r < kSurfaceRows; ++r) {
      for (int c = 0; c < kSurfaceColumns; ++c) {
        const double v = rate.end * (c + 0.5) / kSurfaceColumns;
        const double p = pressure_end * (r + 0.5) / kSurfaceRows;
        const double value = mu(v, p);
        map_ += fmt::format("{:.6g} {:.6g} {:.6g}\n", v, p, value);
        if (std::isfinite(value)) top = std::max(top, value);
      }
    }
    map_ += "\n\n";
    for (const law::Landmark& mark : range.landmarks) {
      if (mark.name.empty() || mark.slip_rate > rate.end) continue;
      marks_ +=
          fmt::format("{:.6g} {:.6g} \"{}\"\n", mark.slip_rate, mu(mark.slip_rate, 0.0), mark.name);
    }
    marks_ += "NaN NaN \"\"\n\n\n";  // an empty block cannot be plotted
    add_states(coefficient.visited, rate.end, force.end, per_force, top);
    script_.add("TOP", top > 0.0 ? top : 1.0);
  }

  /// The script of a picture of all that was added.
  PlotScript finish() {
    script_.set("COEFFICIENTS", count_);
    script_.block("OVER_RATE", std::move(over_rate_));
    script_.block("OVER_LOAD", std::move(over_load_));
    script_.block("MAP", std::move(map_));
    script_.block("MARKS", std::move(marks_));
    script_.block("STATES", std::move(states_));
    return std::move(script_);
  }

 private:
  static std::string names(std::string_view symbol, const std::vector<double>& values) {
    std::string text;
    for (const double value : values) {
      // gnuplot's word() takes the double-quoted parts of a text as words.
      text += fmt::format("{}\"{} = {:.5g}\"", text.empty() ? "" : " ", symbol, value);
    }
    return text;
  }

  /// " at temperature 80, field1 2, as the run ends": what else a table depends on.
  std::string ambient_text(const law::FrictionLaw& law) const {
    const auto* table = std::get_if<law::TabularCoefficient>(&law);
    if (table == nullptr) return {};
    std::string text;
    for (const law::Independent& independent : table->table.independents()) {
      const char* const link = !text.empty()      ? ", "
                               : without_.empty() ? ", as the run ends: "
                                                  : ", at ";
      if (independent.kind == law::IndependentKind::kTemperature) {
        text += fmt::format("{}temperature {:.4g}", link, ambient_.temperature);
      } else if (independent.kind == law::IndependentKind::kField) {
        text += fmt::format("{}field{} {:.4g}", link, independent.index + 1,
                            ambient_.fields[static_cast<std::size_t>(independent.index)]);
      }
    }
    return text;
  }

  /// States that would cover one another in the picture are drawn once.
  void add_states(const VisitedStates& visited, double rate_end, double force_end, double per_force,
                  double top) {
    bool sticks = false;
    bool slips = false;
    std::set<std::array<int, 4>> drawn;
    for (const Visited& state : visited.states()) {
      if (state.slip_rate > rate_end || state.contact_force > force_end) continue;
      const auto cell = [](double x, double end, double cells) {
        return static_cast<int>(std::lround(cells * x / end));
      };
      const bool fresh = drawn
                             .insert({state.status, cell(state.slip_rate, rate_end, 100.0),
                                      cell(state.contact_force, force_end, 80.0),
                                      top > 0.0 ? cell(std::min(state.mu, top), top, 60.0) : 0})
                             .second;
      if (!fresh) continue;
      (state.status == 2 ? slips : sticks) = true;
      states_ += fmt::format("{} {:.6g} {:.6g} {:.6g}\n", state.status, state.slip_rate,
                             state.contact_force / per_force, state.mu);
    }
    states_ += "0 NaN NaN NaN\n\n\n";
    script_.add("STICKS", sticks ? 1 : 0);
    script_.add("SLIPS", slips ? 1 : 0);
  }

  const cases::Case& problem_;
  const law::Ambient& ambient_;
  std::string without_;
  int count_ = 0;
  PlotScript script_;
  std::string over_rate_;
  std::string over_load_;
  std::string map_;
  std::string marks_;
  std::string states_;
};

}  // namespace

tl::expected<void, PlotFailure> draw_laws(const PlotOptions& options, const fs::path& picture) {
  if (is_result(options)) {
    return failed(base::kExitBadInput,
                  options.input + ": a result does not say its coefficients; give the case");
  }
  auto begun = begin_picture(picture, options, "coefficient.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  // Why there are no states of a run; empty if there are.
  std::string without;
  std::error_code error;
  std::optional<cases::Case> problem;
  if (!fs::exists(options.input, error)) problem = case_of_law(options.input);
  if (problem) {
    without = "no run: an example";
  } else if (auto read = read_for_plot(options)) {
    problem = std::move(*read);
  } else {
    problem = case_of_friction(options);
    if (!problem) return tl::unexpected(std::move(read.error()));
    without = "no run: the case is not complete";
  }
  auto all = std::make_unique<DrawnCoefficients>(*problem, false);
  if (all->list().empty()) {
    const bool map = !DrawnCoefficients(*problem, true).list().empty();
    return failed(base::kExitBadInput,
                  fmt::format("{}: no coefficient {} depends on the slip rate or the normal force: "
                              "{}",
                              options.input, map ? "here" : "of this case",
                              map ? "'--as mu_map' draws it over what it depends on"
                                  : "there is nothing to draw"));
  }
  if (without.empty()) {
    auto followed = follow_for_plot(
        *problem, [&](const bench::Simulation& simulation) { all->visit(simulation); });
    if (!followed && followed.error().code != base::kExitNumerical) return followed;
    if (!followed) {
      all = std::make_unique<DrawnCoefficients>(*problem, false);
      without = "no run: it fails";
    }
  }
  Script script(*problem, all->ambient(), without);
  const std::size_t count = std::min(kMostPictures, all->list().size());
  for (std::size_t i = 0; i < count; ++i) script.add(all->list()[i]);
  auto drawn = draw(script.finish(), picture_title(*problem), 60 + 440 * count, *begun);
  if (drawn && without != "" && without != "no run: an example") {
    terminal::print_error(fmt::format(
        "slipbench: note: {} cannot run ('slipbench run' tells why): its coefficients are drawn "
        "without the states of a run\n",
        options.input));
  }
  return drawn;
}

}  // namespace slipbench::driver::plot
