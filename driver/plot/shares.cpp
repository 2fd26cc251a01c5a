// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "driver/connector_increment.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/plot/numbers.hpp"
#include "driver/plot/text_lines.hpp"
#include "driver/results/columns.hpp"
#include "driver/results/normal_shares.hpp"
#include "driver/results/thinning.hpp"

namespace slipbench::driver {
namespace {

/// More parts than this are drawn as one.
constexpr std::size_t kMostShares = 6;

/// What the normal forces of all drawn definitions are made of at one row.
std::vector<std::vector<NormalShare>> shares_of(const Case& problem, const Simulation& simulation,
                                                std::size_t definitions) {
  const Row& row = simulation.row();
  const law::ConnectorIncrement increment = connector_increment(problem, row);
  std::vector<std::vector<NormalShare>> all;
  for (std::size_t d = 0; d < definitions; ++d) {
    const auto shares =
        normal_shares(simulation.definition(d), row.definitions[d].update, increment);
    std::vector<NormalShare> drawn(
        shares.begin(),
        shares.begin() + static_cast<std::ptrdiff_t>(std::min(kMostShares, shares.size())));
    for (std::size_t k = kMostShares; k < shares.size(); ++k) {
      drawn.back().name = "all others";
      drawn.back().value += shares[k].value;
    }
    all.push_back(std::move(drawn));
  }
  return all;
}

/// Parts above and below zero are stacked apart from each other: the edges of each part at a row.
void append_edges(std::string& text, std::span<const double> shares) {
  double up = 0.0;
  double down = 0.0;
  for (const double share : shares) {
    double& end = share < 0.0 ? down : up;
    text += fmt::format(" {:.9g}", end);
    end += share;
    text += fmt::format(" {:.9g}", end);
  }
}

/// The rows of a run with the parts of all normal forces: time, then of each definition its parts
/// and F_N.
class ShareRows {
 public:
  ShareRows(const Case& problem, std::size_t definitions)
      : problem_(problem), definitions_(definitions) {}

  void add(const Simulation& simulation) {
    const auto all = shares_of(problem_, simulation, definitions_);
    if (names_.empty()) {
      std::size_t columns = 1;
      for (const auto& shares : all) {
        columns += shares.size() + 1;
        names_.emplace_back();
        for (const NormalShare& share : shares) names_.back().push_back(share.name);
      }
      thinner_.emplace(columns, kDrawnRows);
    }
    row_.assign(1, simulation.row().time);
    for (std::size_t d = 0; d < definitions_; ++d) {
      for (const NormalShare& share : all[d]) row_.push_back(share.value);
      row_.push_back(simulation.row().definitions[d].update.normal_force);
    }
    thinner_->add(row_);
  }

  std::size_t columns() const { return row_.size(); }
  std::vector<double> rows() const { return thinner_->rows(); }
  const std::vector<std::string>& names(std::size_t definition) const { return names_[definition]; }

 private:
  const Case& problem_;
  std::size_t definitions_;
  std::vector<std::vector<std::string>> names_;
  std::optional<RowThinner> thinner_;
  std::vector<double> row_;
};

/// What the template is told about one definition, whose columns begin at `first`.
void tell(PlotScript& script, const Case& problem, std::size_t definition, const ShareRows& table,
          const std::vector<double>& rows, std::size_t first) {
  const auto& names = table.names(definition);
  const std::string number = std::to_string(definition + 1);
  const law::FrictionDefinition& law = problem.definitions[definition].law;
  std::string text;
  double low = 0.0;
  double high = 0.0;
  std::vector<bool> used(names.size());
  const int time_digits = drawn_digits(rows.front(), rows[rows.size() - table.columns()]);
  for (std::size_t at = 0; at < rows.size(); at += table.columns()) {
    const std::span<const double> shares(rows.data() + at + first, names.size());
    const double normal = rows[at + first + names.size()];
    double up = 0.0;
    double down = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      (shares[k] < 0.0 ? down : up) += shares[k];
      if (shares[k] != 0.0) used[k] = true;
    }
    low = std::min(low, down);
    high = std::max({high, up, normal});
    text += fmt::format("{:.{}g} {:.9g}", rows[at], time_digits, normal);
    append_edges(text, shares);
    text += '\n';
  }
  script.block("SHARES" + number, std::move(text));
  script.add("NAME", problem.definitions.size() > 1
                         ? one_line(problem.definitions[definition].name, kNameLength)
                         : "");
  script.add("PARTS", static_cast<int>(names.size()));
  // gnuplot's word() takes the double-quoted parts of a text as words.
  std::string titles;
  for (std::size_t k = 0; k < names.size(); ++k) {
    titles += fmt::format("{}\"{}\"", k == 0 ? "" : " ", used[k] ? names[k] : names[k] + ": 0");
  }
  script.add("PART_NAMES", titles);
  const double span = high > low ? high - low : 1.0;
  script.add("LOW", low < 0.0 ? low - 0.05 * span : 0.0);
  script.add("HIGH", high + 0.08 * span);
  const bool moment = is_rotational(law);
  script.add("LABEL", axis_label(moment ? "normal moment" : "normal force",
                                 {"", unit_text(moment ? kMoment : kForce, problem.units)}));
}

}  // namespace

tl::expected<void, PlotFailure> draw_shares(const PlotOptions& options,
                                            const std::filesystem::path& picture) {
  if (is_result(options)) {
    return failed(kExitBadInput, options.input +
                                     ": a result does not say what its normal force is made of; "
                                     "give the case");
  }
  auto begun = begin_picture(picture, options.input, "shares.gp", options.look);
  if (!begun) return tl::unexpected(std::move(begun.error()));
  const auto problem = read_for_plot(options);
  if (!problem) return tl::unexpected(problem.error());
  if (problem->definitions.empty()) {
    return failed(kExitBadInput, options.input + ": has no friction, so nothing presses");
  }
  const std::size_t count = std::min(kMostDefinitions, problem->definitions.size());
  ShareRows table(*problem, count);
  const auto followed =
      follow_for_plot(*problem, [&](const Simulation& simulation) { table.add(simulation); });
  if (!followed) return followed;

  PlotScript script;
  const std::vector<double> rows = table.rows();
  const double begin = rows.front();
  const double end = rows[rows.size() - table.columns()];
  script.set("DEFINITIONS", static_cast<int>(count));
  tell_time(script, problem->units.time, begin, end);
  std::size_t first = 1;
  for (std::size_t d = 0; d < count; ++d) {
    tell(script, *problem, d, table, rows, first);
    first += table.names(d).size() + 1;
  }
  std::string title = picture_title(*problem);
  if (count < problem->definitions.size()) {
    title += fmt::format(" (the first {} of {} definitions)", count, problem->definitions.size());
  }
  return draw(script, title, 60 + 400 * count, *begun);
}

}  // namespace slipbench::driver
