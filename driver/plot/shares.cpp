// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "driver/bench/connector_increment.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/plot/numbers.hpp"
#include "driver/plot/text_lines.hpp"
#include "driver/results/columns.hpp"
#include "driver/results/normal_shares.hpp"
#include "driver/results/pixel_columns.hpp"

namespace slipbench::driver::plot {
namespace {

/// More parts than this are drawn as one.
constexpr std::size_t kMostShares = 6;

/// Returns what the normal forces of all drawn definitions are made of at one row.
std::vector<std::vector<results::NormalShare>> shares_of(const cases::Case& problem,
                                                         const bench::Simulation& simulation,
                                                         std::size_t definitions) {
  const bench::Row& row = simulation.row();
  const law::ConnectorIncrement increment = bench::connector_increment(problem, row);
  std::vector<std::vector<results::NormalShare>> all;
  for (std::size_t d = 0; d < definitions; ++d) {
    const auto shares =
        results::normal_shares(simulation.definition(d), row.definitions[d].update, increment);
    std::vector<results::NormalShare> drawn(
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

/// Returns when a run without interruption ends.
double end_time(const cases::Case& problem) {
  double end = 0.0;
  for (const cases::Step& step : problem.steps) {
    end += step.duration * std::max(1, step.repeat);
  }
  return end;
}

/// The rows of a run with the parts of all normal forces: time, then of each definition F_N and the
/// two edges of each part. Parts above and below zero are stacked apart from each other.
class ShareRows {
 public:
  ShareRows(const cases::Case& problem, std::size_t definitions)
      : problem_(problem), definitions_(definitions) {}

  void add(const bench::Simulation& simulation) {
    const auto all = shares_of(problem_, simulation, definitions_);
    row_.assign(1, simulation.row().time);
    for (std::size_t d = 0; d < definitions_; ++d) {
      row_.push_back(simulation.row().definitions[d].update.normal_force);
      double up = 0.0;
      double down = 0.0;
      for (const results::NormalShare& share : all[d]) {
        double& end = share.value < 0.0 ? down : up;
        row_.push_back(end);
        end += share.value;
        row_.push_back(end);
      }
    }
    if (!columns_) {
      for (const auto& shares : all) {
        names_.emplace_back();
        for (const results::NormalShare& share : shares) names_.back().push_back(share.name);
      }
      columns_.emplace(row_.size(), row_[0], end_time(problem_), results::kDrawnPixels);
    }
    columns_->add(row_);
  }

  std::size_t columns() const { return row_.size(); }
  std::vector<double> finish() { return columns_->finish(); }
  const std::vector<std::string>& names(std::size_t definition) const { return names_[definition]; }

 private:
  const cases::Case& problem_;
  std::size_t definitions_;
  std::vector<std::vector<std::string>> names_;
  std::optional<results::PixelColumns> columns_;
  std::vector<double> row_;
};

/// Tells the template about one definition, whose columns begin at `first`.
void tell(PlotScript& script, const cases::Case& problem, std::size_t definition,
          const ShareRows& table, const std::vector<double>& rows, std::size_t first) {
  const auto& names = table.names(definition);
  const std::string number = std::to_string(definition + 1);
  const law::FrictionDefinition& law = problem.definitions[definition].law;
  std::string text;
  double low = 0.0;
  double high = 0.0;
  std::vector<bool> used(names.size());
  const int time_digits = drawn_digits(rows.front(), rows[rows.size() - table.columns()]);
  for (std::size_t at = 0; at < rows.size(); at += table.columns()) {
    const std::span<const double> numbers(rows.data() + at + first, 1 + 2 * names.size());
    low = std::min(low, *std::min_element(numbers.begin(), numbers.end()));
    high = std::max(high, *std::max_element(numbers.begin(), numbers.end()));
    text += fmt::format("{:.{}g}", rows[at], time_digits);
    for (const double value : numbers) text += fmt::format(" {:.9g}", value);
    text += '\n';
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (numbers[1 + 2 * k] != numbers[2 + 2 * k]) used[k] = true;
    }
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
  const bool moment = results::is_rotational(law);
  script.add(
      "LABEL",
      axis_label(moment ? "normal moment" : "normal force",
                 {"", base::unit_text(moment ? base::kMoment : base::kForce, problem.units)}));
}

}  // namespace

tl::expected<void, PlotFailure> draw_shares(const PlotOptions& options,
                                            const std::filesystem::path& picture) {
  if (is_result(options)) {
    return failed(base::kExitBadInput,
                  options.input +
                      ": a result does not say what its normal force is made of; "
                      "give the case");
  }
  auto begun = begin_picture(picture, options, "shares.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  const auto problem = read_for_plot(options);
  if (!problem) return tl::unexpected(problem.error());
  if (problem->definitions.empty()) {
    return failed(base::kExitBadInput, options.input + ": has no friction, so nothing presses");
  }
  const std::size_t count = std::min(kMostDefinitions, problem->definitions.size());
  ShareRows table(*problem, count);
  auto followed = follow_for_plot(
      *problem, [&](const bench::Simulation& simulation) { table.add(simulation); });
  if (!followed) return followed;

  PlotScript script;
  const std::vector<double> rows = table.finish();
  const double begin = rows.front();
  const double end = rows[rows.size() - table.columns()];
  script.set("DEFINITIONS", static_cast<int>(count));
  tell_time(script, problem->units.time, begin, end);
  std::size_t first = 1;
  for (std::size_t d = 0; d < count; ++d) {
    tell(script, *problem, d, table, rows, first);
    first += 1 + 2 * table.names(d).size();
  }
  std::string title = picture_title(*problem);
  if (count < problem->definitions.size()) {
    title += fmt::format(" (the first {} of {} definitions)", count, problem->definitions.size());
  }
  return draw(script, title, 60 + 400 * count, *begun);
}

}  // namespace slipbench::driver::plot
