// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/plot_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "driver/commands/shared.hpp"
#include "driver/results/columns.hpp"
#include "driver/results/law_range.hpp"
#include "driver/results/provenance.hpp"
#include "driver/text/format_number.hpp"
#include "driver/text/tics.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPictures = 4;
constexpr int kCurvePoints = 400;
constexpr int kMapColumns = 120;
constexpr int kMapRows = 80;
/// A run that goes further than so many times what the law has to show is cut off, and that is
/// said.
constexpr double kFarthest = 6.0;

/// A state that a run visited.
struct Visited {
  double slip_rate = 0.0;      ///< [L/T]
  double contact_force = 0.0;  ///< F_N [F]
  double mu = 0.0;
  int status = 1;  ///< 1 stick, 2 slip
};

/// The states of a run of any length: of a long one every second, every fourth and so on.
class VisitedStates {
 public:
  void add(const Visited& state) {
    slip_rate_ = std::max(slip_rate_, state.slip_rate);
    contact_force_ = std::max(contact_force_, state.contact_force);
    if (count_++ % stride_ != 0) return;
    states_.push_back(state);
    if (states_.size() < kMost) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < states_.size(); i += 2) states_[kept++] = states_[i];
    states_.resize(kept);
    stride_ *= 2;
  }

  const std::vector<Visited>& states() const { return states_; }
  double largest_slip_rate() const { return slip_rate_; }
  double largest_contact_force() const { return contact_force_; }

 private:
  static constexpr std::size_t kMost = 20000;
  std::vector<Visited> states_;
  long count_ = 0;
  long stride_ = 1;
  double slip_rate_ = 0.0;
  double contact_force_ = 0.0;
};

/// One coefficient that is drawn: of a definition, or of one direction of it.
struct Coefficient {
  std::string title;
  law::FrictionLaw law;
  bool rotational = false;
  bool creeps = false;  ///< below the limit, in place of stick
  VisitedStates visited;
};

bool depends_on_anything(const law::FrictionLaw& law) {
  return law::depends_on_slip_rate(law) || law::depends_on_contact_force(law);
}

std::string title_of(const CaseDefinition& definition, bool several, const law::FrictionLaw& law,
                     std::string_view direction) {
  std::string text = several ? definition.name + ": " : "";
  if (!direction.empty()) text += std::string(direction) + ": ";
  return text + std::string(std::visit([](const auto& one) { return one.kTitle; }, law));
}

/// The coefficients of a case, directions of an orthotropic one apart; entries of definitions whose
/// coefficient is constant stay away.
struct Coefficients {
  std::vector<Coefficient> list;
  /// Of each definition, the entries of direction 1 and 2 in `list`; -1 for none.
  std::vector<std::array<int, 2>> of_definition;
};

Coefficients coefficients_of(const Case& problem) {
  Coefficients all;
  const bool several = problem.definitions.size() > 1;
  for (const CaseDefinition& definition : problem.definitions) {
    std::array<int, 2> entries{-1, -1};
    const auto& formulation = definition.law.formulation;
    const bool orthotropic = formulation && formulation->orthotropy;
    const bool creeps =
        formulation && std::holds_alternative<law::ViscousPenalty>(formulation->penalty);
    const auto add = [&](const law::FrictionLaw& law, std::string_view direction) {
      if (!depends_on_anything(law)) return -1;
      all.list.push_back({title_of(definition, several, law, direction),
                          law,
                          is_rotational(definition.law),
                          creeps,
                          {}});
      return static_cast<int>(all.list.size()) - 1;
    };
    entries[0] = add(definition.law.law, orthotropic ? "direction 1" : "");
    if (orthotropic) entries[1] = add(formulation->orthotropy->second, "direction 2");
    all.of_definition.push_back(entries);
  }
  return all;
}

void visit(const Simulation& simulation, Coefficients& all) {
  for (std::size_t d = 0; d < all.of_definition.size(); ++d) {
    const DefinitionRow& row = simulation.row().definitions[d];
    const law::FrictionUpdate& update = row.update;
    // The start is no state of an increment.
    if (update.state.regime == law::Regime::kOpen || simulation.row().index == 0) continue;
    const int status = static_cast<int>(update.state.regime);
    const auto& formulation = simulation.definition(d).formulation;
    const bool orthotropic = formulation && formulation->orthotropy;
    for (std::size_t i = 0; i < 2; ++i) {
      const int entry = all.of_definition[d][i];
      if (entry < 0) continue;
      // A direction of an orthotropic coefficient sees a speed of its own.
      const double rate = orthotropic ? row.penalty.speeds[i] : update.slip_rate;
      const double mu = orthotropic ? row.penalty.mu[i] : update.mu;
      all.list[static_cast<std::size_t>(entry)].visited.add(
          {rate, update.normal_force, mu, status});
    }
  }
}

/// How far an axis goes: what the law has to show, and what the run visited.
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
  const double step = tic_step(end, 3.0);
  std::vector<double> list;
  for (int k = 0; k < 4 && k * step <= end * (1.0 + 1e-9); ++k) list.push_back(k * step);
  return list;
}

std::string axis_label(std::string_view name, const std::string& unit) {
  return std::string(name) + (unit.empty() ? "" : " [" + unit + "]");
}

/// Writes what the template is told about one coefficient, and its data.
class Script {
 public:
  Script(const Case& problem, const law::Ambient& ambient) : problem_(problem), ambient_(ambient) {}

  void add(const Coefficient& coefficient) {
    ++count_;
    const law::FrictionLaw& law = coefficient.law;
    const bool by_rate = law::depends_on_slip_rate(law);
    const bool by_force = law::depends_on_contact_force(law);
    const LawRange range = law_range(law);
    const double area = area_of(law);
    const double per_force = area > 0.0 ? area : 1.0;
    const Extent rate =
        extent(by_rate ? range.slip_rate : 0.0, coefficient.visited.largest_slip_rate());
    const Extent force =
        extent(by_force ? range.contact_force : 0.0, coefficient.visited.largest_contact_force());
    const double pressure_end = force.end / per_force;
    const auto mu = [&](double v, double p) {
      return law::evaluate(law, ambient_, {.slip_rate = v, .contact_force = p * per_force}).mu;
    };

    Dimension force_dimension = coefficient.rotational ? kMoment : kForce;
    if (area > 0.0) force_dimension.length -= 2;
    Dimension rate_dimension = coefficient.rotational ? kAngle : kLength;
    rate_dimension.time -= 1;
    const std::string force_unit = unit_text(force_dimension, problem_.units);
    const std::string rate_unit = unit_text(rate_dimension, problem_.units);
    const std::string force_name = area > 0.0               ? "pressure p"
                                   : coefficient.rotational ? "normal moment F_N"
                                                            : "normal force F_N";
    const auto set = [&](const char* name, const std::string& value) {
      variables_ += fmt::format("{}[{}] = {}\n", name, count_, value);
    };
    set("NAME", gnuplot_string(coefficient.title + ambient_of(law)));
    set("RATE_LABEL", gnuplot_string(axis_label("slip rate V", rate_unit)));
    set("LOAD_LABEL", gnuplot_string(axis_label(force_name, force_unit)));
    set("RATE_END", format_number(rate.end));
    set("LOAD_END", format_number(pressure_end));
    set("RATE_STEP", format_number(tic_step(rate.end, by_rate && by_force ? 4.0 : 6.0)));
    set("MAP_STEP", format_number(tic_step(rate.end, 4.0)));
    set("LOAD_STEP", format_number(tic_step(pressure_end, 4.0)));
    set("BY_RATE", by_rate ? "1" : "0");
    set("BY_LOAD", by_force ? "1" : "0");
    std::string cut;
    if (rate.cut)
      cut = fmt::format("the run reaches V = {:.4g}", coefficient.visited.largest_slip_rate());
    if (force.cut) {
      cut += fmt::format("{}the run reaches {} = {:.4g}", cut.empty() ? "" : ", ",
                         area > 0.0 ? "p" : "F_N",
                         coefficient.visited.largest_contact_force() / per_force);
    }
    set("CUT", gnuplot_string(cut));
    set("STICK_NAME",
        gnuplot_string(coefficient.creeps ? "visited below the limit" : "visited in stick"));

    const std::vector<double> loads = by_force ? levels(pressure_end) : std::vector<double>{0.0};
    const std::vector<double> rates = by_rate ? levels(rate.end) : std::vector<double>{0.0};
    const char* const load_symbol = area > 0.0 ? "p" : "F_N";
    set("OVER_RATE_NAMES", by_force ? names(load_symbol, loads) : "'mu'");
    set("OVER_LOAD_NAMES", by_rate ? names("V", rates) : "'mu'");
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
    for (int r = 0; r < kMapRows; ++r) {
      for (int c = 0; c < kMapColumns; ++c) {
        const double v = rate.end * (c + 0.5) / kMapColumns;
        const double p = pressure_end * (r + 0.5) / kMapRows;
        const double value = mu(v, p);
        map_ += fmt::format("{:.6g} {:.6g} {:.6g}\n", v, p, value);
        if (std::isfinite(value)) top = std::max(top, value);
      }
    }
    map_ += "\n\n";
    for (const Landmark& mark : range.landmarks) {
      if (mark.slip_rate > rate.end) continue;
      marks_ +=
          fmt::format("{:.6g} {:.6g} \"{}\"\n", mark.slip_rate, mu(mark.slip_rate, 0.0), mark.name);
    }
    marks_ += "NaN NaN \"\"\n\n\n";  // an empty block cannot be plotted
    add_states(coefficient.visited, rate.end, force.end, per_force, top);
    set("TOP", format_number(top > 0.0 ? top : 1.0));
  }

  /// \param picture its final name \param output where it is written first
  std::string text(const std::string& title, const fs::path& picture, const fs::path& output,
                   const fs::path& pattern) const {
    std::string text =
        fmt::format("TERMINAL = \"{}\"\nPICTURE = {}\nTITLE = {}\nCOEFFICIENTS = {}\n",
                    terminal_for(picture, 60 + 440 * count_), gnuplot_string(output.string()),
                    gnuplot_string(title), count_);
    for (const char* name :
         {"NAME", "RATE_LABEL", "LOAD_LABEL", "RATE_END", "LOAD_END", "RATE_STEP", "LOAD_STEP",
          "MAP_STEP", "BY_RATE", "BY_LOAD", "CUT", "OVER_RATE_NAMES", "OVER_LOAD_NAMES", "TOP",
          "STICKS", "SLIPS", "STICK_NAME"}) {
      text += fmt::format("array {}[{}]\n", name, count_);
    }
    text += variables_;
    for (const auto& [name, data] : {std::pair{"OVER_RATE", &over_rate_},
                                     {"OVER_LOAD", &over_load_},
                                     {"MAP", &map_},
                                     {"MARKS", &marks_},
                                     {"STATES", &states_}}) {
      text += fmt::format("${} << END\n{}END\n", name, *data);
    }
    return text + "load " + gnuplot_string(pattern.string()) + "\n";
  }

 private:
  static std::string names(std::string_view symbol, const std::vector<double>& values) {
    std::string text;
    for (const double value : values) {
      // gnuplot's word() takes the double-quoted parts of a text as words.
      text += fmt::format("{}\"{} = {:.5g}\"", text.empty() ? "" : " ", symbol, value);
    }
    return gnuplot_string(text);
  }

  /// " at temperature 80, field1 2, as the run ends": what else a table depends on.
  std::string ambient_of(const law::FrictionLaw& law) const {
    const auto* table = std::get_if<law::TabularCoefficient>(&law);
    if (table == nullptr) return {};
    std::string text;
    for (const law::Independent& independent : table->table.independents()) {
      const char* const link = text.empty() ? ", as the run ends: " : ", ";
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
    variables_ +=
        fmt::format("STICKS[{0}] = {1}\nSLIPS[{0}] = {2}\n", count_, sticks ? 1 : 0, slips ? 1 : 0);
  }

  const Case& problem_;
  const law::Ambient& ambient_;
  std::size_t count_ = 0;
  std::string variables_;
  std::string over_rate_;
  std::string over_load_;
  std::string map_;
  std::string marks_;
  std::string states_;
};

/// What a table may depend on besides the slip, as the run left it.
struct FinalAmbient {
  std::array<double, law::kMaxFields> fields{};
  law::Ambient ambient;
};

void take_ambient(const Row& row, FinalAmbient& out) {
  out.ambient.temperature = row.quantities[kTemperatureQuantity];
  for (std::size_t f = 0; f < out.fields.size(); ++f) {
    out.fields[f] = row.quantities[kFirstField + f];
  }
  out.ambient.fields = out.fields;
}

}  // namespace

tl::expected<void, PlotFailure> draw_laws(const PlotOptions& options, const fs::path& picture) {
  if (terminal_for(picture, 0).empty()) {
    return failed(kExitBadInput, fmt::format("{}: wanted a picture that ends in .svg, .png or .pdf",
                                             picture.string()));
  }
  if (fs::path(options.input).extension() == ".csv") {
    return failed(kExitBadInput,
                  options.input + ": a result does not say its coefficients; give the case");
  }
  const auto pattern = find_template("coefficient.gp");
  if (!pattern) {
    return failed(kExitEnvironment, "the plot template plots/coefficient.gp is not installed");
  }
  const std::array<std::string, 1> inputs{options.input};
  auto output = OutputFile::create(picture, inputs);
  if (!output) return failed(kExitEnvironment, output.error());
  const auto read = read_for_plot(options);
  if (!read) return tl::unexpected(read.error());
  const Case& problem = *read;

  Coefficients all = coefficients_of(problem);
  if (all.list.empty()) {
    return failed(kExitBadInput,
                  options.input +
                      ": no coefficient of this case depends on the slip rate or the "
                      "normal force: there is nothing to draw");
  }
  FinalAmbient end;
  const auto ended = [&] {
    Progress progress(case_stem(problem));
    return follow_case(problem, [&](const Simulation& simulation) {
      visit(simulation, all);
      take_ambient(simulation.row(), end);
      progress.step(simulation.row());
    });
  }();
  if (!ended) {
    return tl::unexpected(
        PlotFailure{exit_code(ended.error()), failure_text(problem, ended.error())});
  }
  Script script(problem, end.ambient);
  for (std::size_t i = 0; i < std::min(kMostPictures, all.list.size()); ++i) {
    script.add(all.list[i]);
  }
  const std::string title = problem.title.empty() ? case_stem(problem) : problem.title;
  return draw_script(script.text(title, picture, output->temporary(), *pattern), picture, *output);
}

}  // namespace slipbench::driver
