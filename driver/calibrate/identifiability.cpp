// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/identifiability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <string_view>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/calibrate/estimate_text.hpp"
#include "driver/calibrate/resolve_varied.hpp"
#include "driver/calibrate/unseen_combinations.hpp"
#include "driver/calibrate/unvisited_ranges.hpp"
#include "driver/calibrate/varied_case.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::calibrate {
namespace {

/// A derivative below this part of the largest is the rounding of the others.
constexpr double kNoDependence = 1e-9;

std::string independent_unit(const law::Independent& independent, bool rotational,
                             const base::UnitSystem& units) {
  using Kind = law::IndependentKind;
  const int length = rotational ? 0 : 1;
  const int angle = rotational ? 1 : 0;
  switch (independent.kind) {
    case Kind::kSlipRate:
      return base::unit_text({.length = length, .time = -1, .angle = angle}, units);
    case Kind::kContactForce:
      return base::unit_text(rotational ? base::kMoment : base::kForce, units);
    case Kind::kAccumulatedSlip:
      return base::unit_text({.length = length, .angle = angle}, units);
    case Kind::kTemperature:
      return base::unit_text(base::kTemperature, units);
    case Kind::kPosition:
    case Kind::kConstitutiveMotion:
      return base::unit_text(independent.index < 3 ? base::kLength : base::kAngle, units);
    case Kind::kField:
      break;
  }
  return {};
}

std::string_view word_of(VariedTable::Use use) {
  return use == VariedTable::Use::kCoefficient ? "coefficient" : "internal_contact_force";
}

/// Verdict of the derivatives at the optimum on one unknown.
struct Sight {
  std::int64_t points = 0;  ///< compared ones that depend on it
  bool tied = false;        ///< by smoothness
};

std::vector<Sight> sights(const Calibration& calibration) {
  const std::size_t n = calibration.unknowns.size();
  std::vector<Sight> result(n);
  const std::vector<double>& jacobian = calibration.fit.jacobian;
  if (n == 0) return result;
  const std::size_t rows = jacobian.size() / n;
  const std::size_t data = std::min(rows, calibration.problem.data_rows);
  std::vector<double> largest(n, 0.0);
  for (std::size_t row = 0; row < data; ++row) {
    for (std::size_t u = 0; u < n; ++u) {
      largest[u] = std::max(largest[u], std::abs(jacobian[row * n + u]));
    }
  }
  for (std::size_t row = 0; row < data; ++row) {
    for (std::size_t u = 0; u < n; ++u) {
      result[u].points += std::abs(jacobian[row * n + u]) > kNoDependence * largest[u] ? 1 : 0;
    }
  }
  for (std::size_t row = data; row < rows; ++row) {
    for (std::size_t u = 0; u < n; ++u) {
      result[u].tied = result[u].tied || jacobian[row * n + u] != 0.0;
    }
  }
  return result;
}

/// Returns what holds ordinates to their neighbours, in the words of a fit file.
std::string shape_words(const fit::Shape& shape) {
  std::string words;
  if (shape.monotone != fit::Shape::Monotone::kFree) {
    words = shape.monotone == fit::Shape::Monotone::kIncreasing ? "`monotone: increasing`"
                                                                : "`monotone: decreasing`";
  }
  if (shape.curvature != fit::Shape::Curvature::kFree) {
    words += words.empty() ? "" : " and ";
    words +=
        shape.curvature == fit::Shape::Curvature::kConvex ? "`shape: convex`" : "`shape: concave`";
  }
  return words;
}

/// Returns what moves an unknown that no compared point depends on.
/// \param shape of its block; that of a parameter is free
std::string mover_of(const FittedUnknown& unknown, const fit::Shape& shape) {
  std::string words = unknown.tied ? "`smoothness`" : "";
  if (!shape.any()) return words.empty() ? "its bounds" : words;
  return words.empty() ? shape_words(shape) : words + " within " + shape_words(shape);
}

void judge_unseen(std::string_view because, const fit::Shape& shape, FittedUnknown& unknown) {
  unknown.identifiability = Identifiability::kNeverVisited;
  const std::string start = fmt::format("{:.6g}", unknown.range.start);
  const std::string value = fmt::format("{:.6g}", unknown.value);
  unknown.moved_by = value == start ? "" : mover_of(unknown, shape);
  unknown.why = fmt::format("{}: ", because);
  unknown.why += value == start
                     ? "kept at its start"
                     : fmt::format("moved from {} to {} by {}", start, value, unknown.moved_by);
}

/// Marks ordinates that the data tell and that have no room in their shape: equal to a neighbour,
/// or on a straight line with both.
void mark_held(const FittedTable& table, std::vector<FittedUnknown>& unknowns) {
  constexpr double kSumRounding = 1e-12;
  const auto at = [&](std::size_t r) -> FittedUnknown& {
    return unknowns[table.first_unknown + r];
  };
  const auto seen = [&](std::size_t r) { return at(r).visits > 0; };
  const auto same_block = [&](std::size_t r, std::size_t s) {
    const std::vector<double>& a = table.points[r];
    const std::vector<double>& b = table.points[s];
    return std::equal(a.begin() + 1, a.end(), b.begin() + 1, b.end());
  };
  const std::string words = shape_words(table.shape);
  for (std::size_t r = 0; r < table.count; ++r) at(r).held_by.clear();
  for (std::size_t r = 1; r < table.points.size(); ++r) {
    if (!same_block(r, r - 1) || !seen(r) || !seen(r - 1)) continue;
    const double size = kSumRounding * std::abs(at(r).value);
    const double step = at(r).value - at(r - 1).value;
    if (table.shape.monotone != fit::Shape::Monotone::kFree && std::abs(step) <= size) {
      at(r).held_by = at(r - 1).held_by = words;
    }
    if (table.shape.curvature == fit::Shape::Curvature::kFree || r + 1 == table.points.size())
      continue;
    if (!same_block(r, r + 1) || !seen(r + 1)) continue;
    const double next = at(r + 1).value - at(r).value;
    const double ratio = (table.points[r + 1][0] - table.points[r][0]) /
                         (table.points[r][0] - table.points[r - 1][0]);
    if (std::abs(next - ratio * step) <= (1.0 + ratio) * size) at(r).held_by = words;
  }
}

/// "table 'sleeve.coefficient': `monotone: increasing` holds ..".
void note_held(const Fit& fit, const Calibration& calibration, const FittedTable& table,
               std::vector<std::string>& notes) {
  std::size_t held = 0;
  for (std::size_t r = 0; r < table.count; ++r) {
    held += calibration.unknowns[table.first_unknown + r].held_by.empty() ? 0 : 1;
  }
  if (held == 0) return;
  notes.push_back(
      fmt::format("table '{}': {} leaves {} of {} ordinates no room: the data ask for another "
                  "shape, or leave it "
                  "open; their errors are those without it",
                  fit.tables[table.index].name, shape_words(table.shape), held, table.count));
}

/// Returns why an interval says little, or nothing.
std::string width_fault(const FittedUnknown& unknown, double lower, double upper) {
  if (!std::isfinite(lower) || !std::isfinite(upper)) return {};
  const fit::UnknownRange& range = unknown.range;
  const double width = upper - lower;
  const std::string interval =
      fmt::format("its interval, {:.3g} .. {:.3g}, is wider than ", lower, upper);
  const double allowed = range.upper - range.lower;
  if (std::isfinite(allowed) && width >= allowed) return interval + "its bounds";
  // The value of what may have either sign, as an offset, says nothing of its size.
  const bool either_sign = range.lower < 0.0 && range.upper > 0.0;
  if (either_sign && std::isfinite(allowed)) {
    return width > 0.5 * allowed ? interval + "half of what its bounds allow" : "";
  }
  const double size = either_sign ? std::max(std::abs(unknown.value), std::abs(range.start))
                                  : std::abs(unknown.value);
  return width > size ? interval + "the value itself" : "";
}

void judge_one(const Calibration& calibration, std::size_t u, const Sight& sight,
               FittedUnknown& unknown) {
  const fit::FitStatistics& statistics = calibration.statistics;
  unknown.visits = sight.points;
  unknown.tied = sight.tied;
  unknown.why.clear();
  unknown.identifiability = Identifiability::kGood;
  if (sight.points == 0) {
    const double start = unknown.range.start;
    const bool frozen = u < calibration.fit.frozen.size() && calibration.fit.frozen[u] != 0;
    const std::vector<char>& silent = calibration.fit.silent;
    if (u < silent.size() && silent[u] != 0 && unknown.value == start) {
      unknown.identifiability = Identifiability::kWeak;
      unknown.why = fmt::format(
          "at {:.6g} no compared point depends on it, though some do at other values: start it "
          "nearer, or compare several starts (multistart: 8)",
          start);
      return;
    }
    if (!sight.tied && !frozen && unknown.value != start) {
      unknown.identifiability = Identifiability::kWeak;
      unknown.why = fmt::format(
          "moved from {:.6g} to {:.6g}, where no compared point depends on it: other values may "
          "fit "
          "as well",
          start, unknown.value);
      return;
    }
    judge_unseen("no compared point depends on it", {}, unknown);
    return;
  }
  if (u < statistics.identifiable.size() && statistics.identifiable[u] == 0) {
    unknown.identifiability = Identifiability::kWeak;
    unknown.why = "the data see it only in a combination with others";
    return;
  }
  if (u >= statistics.lower.size() || u >= statistics.upper.size()) return;
  unknown.why = width_fault(unknown, statistics.lower[u], statistics.upper[u]);
  if (!unknown.why.empty()) unknown.identifiability = Identifiability::kWeak;
}

/// Increments in the cells around a row of a table: those between it and its neighbours. Nothing
/// if the cells were not counted.
std::optional<std::int64_t> visits_around(const FittedTable& table, std::size_t row) {
  const auto knots = knots_of(table);
  if (table.cells.empty() || table.cells.size() != count_cells(knots)) return std::nullopt;
  std::int64_t visits = 0;
  for (std::size_t cell = 0; cell < table.cells.size(); ++cell) {
    std::size_t stride = 1;
    bool beside = true;
    for (std::size_t k = 0; k < knots.size(); ++k) {
      const std::size_t intervals = std::max<std::size_t>(1, knots[k].size() - 1);
      const std::size_t i = cell / stride % intervals;
      stride *= intervals;
      if (knots[k].size() < 2) continue;
      const auto [before, after] = neighbours(table, row, k);
      beside = beside && knots[k][i + 1] > before && knots[k][i] < after;
    }
    if (beside) visits += table.cells[cell].visits;
  }
  return visits;
}

/// "table 'sleeve.coefficient' was never visited with ..".
std::vector<std::string> table_notes(const Fit& fit, const Calibration& calibration,
                                     const FittedTable& table) {
  const std::string name = "table '" + fit.tables[table.index].name + "'";
  std::size_t unseen = 0;
  std::map<std::string, std::size_t> moved;  ///< by what, and how many
  for (std::size_t r = 0; r < table.count; ++r) {
    const FittedUnknown& unknown = calibration.unknowns[table.first_unknown + r];
    if (unknown.identifiability != Identifiability::kNeverVisited) continue;
    ++unseen;
    ++moved[unknown.moved_by];
  }
  const std::string ranges = unvisited_ranges(table);
  std::vector<std::string> notes;
  if (unseen == 0 && ranges.empty()) return notes;
  std::string fate;
  for (const auto& [mover, count] : moved) {
    fate += fate.empty() ? fmt::format("{} of {} ordinates", count, table.count)
                         : fmt::format(", {}", count);
    fate += mover.empty() ? " kept at their start" : " moved by " + mover;
  }
  if (unseen == 0) fate = "all ordinates are seen from the cells beside";
  if (ranges.empty()) {
    notes.push_back(name + ": no compared point depends on some of it; " + fate);
  } else {
    notes.push_back(name + ": never visited " + ranges + "; " + fate +
                    (unseen > 0 ? "; measure there to know them" : ""));
  }
  return notes;
}

/// As many digits as tell a correlation from 1.
std::string correlation_text(double rho) {
  const double gap = 1.0 - std::abs(rho);
  const int digits =
      gap > 0.0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(gap))), 2, 6) : 6;
  return fmt::format("{:.{}f}", rho, digits);
}

void add_correlated_pairs(const Calibration& calibration, std::vector<std::string>& notes) {
  constexpr std::size_t kMostPairs = 5;
  const std::size_t n = calibration.unknowns.size();
  const std::vector<double>& correlation = calibration.statistics.correlation;
  if (correlation.size() != n * n) return;
  struct Pair {
    std::size_t a, b;
    double rho;
  };
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      const double rho = correlation[a * n + b];
      if (std::abs(rho) >= kStrongCorrelation) pairs.push_back({a, b, rho});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& p, const Pair& q) { return std::abs(p.rho) > std::abs(q.rho); });
  for (std::size_t i = 0; i < std::min(pairs.size(), kMostPairs); ++i) {
    notes.push_back(fmt::format(
        "{} and {} move together (correlation {}): the data tell one combination of them far "
        "better than each",
        told_name(calibration, pairs[i].a), told_name(calibration, pairs[i].b),
        correlation_text(pairs[i].rho)));
  }
  if (pairs.size() > kMostPairs) {
    notes.push_back(
        fmt::format("{} more pairs are as strongly correlated", pairs.size() - kMostPairs));
  }
}

}  // namespace

void add_visits(const VariedTable& table, const cases::Case& problem,
                const results::Coverage& coverage, FittedTable* fitted) {
  const std::vector<std::size_t> wanted = definitions_of(problem, table.definition);
  for (const results::TableCoverage& counted : coverage.tables()) {
    const cases::CaseDefinition& definition = problem.definitions[counted.definition];
    const bool belongs =
        std::find(wanted.begin(), wanted.end(), counted.definition) != wanted.end();
    if (counted.what != word_of(table.use) || !belongs) continue;
    if (fitted->units.empty()) {
      if (const law::TableFunction* function = varied_table(definition.law, table.use)) {
        for (const law::Independent& independent : function->independents()) {
          fitted->units.push_back(
              independent_unit(independent, results::is_rotational(definition.law), problem.units));
        }
      }
    }
    if (fitted->cells.empty()) {
      for (std::size_t cell = 0; cell < counted.visits.size(); ++cell) {
        fitted->cells.push_back({counted.cell_text(cell), 0});
      }
    }
    if (fitted->cells.size() != counted.visits.size()) continue;
    for (std::size_t cell = 0; cell < counted.visits.size(); ++cell) {
      fitted->cells[cell].visits += counted.visits[cell];
    }
  }
}

void judge_identifiability(Calibration* calibration) {
  const std::vector<Sight> all = sights(*calibration);
  for (std::size_t u = 0; u < all.size(); ++u) {
    judge_one(*calibration, u, all[u], calibration->unknowns[u]);
  }
  for (const UnseenCombination& combination : unseen_combinations(*calibration)) {
    for (const std::size_t u : combination.unknowns) {
      calibration->unknowns[u].identifiability = Identifiability::kWeak;
      calibration->unknowns[u].why = combination.sentence;
    }
  }
  // Of an ordinate it can be said where nothing went.
  for (FittedTable& table : calibration->tables) {
    std::vector<char> seen(table.count, 1);
    for (std::size_t r = 0; r < table.count; ++r) {
      FittedUnknown& unknown = calibration->unknowns[table.first_unknown + r];
      seen[r] = unknown.visits > 0 ? 1 : 0;
      if (unknown.identifiability != Identifiability::kNeverVisited) continue;
      const auto around = visits_around(table, r);
      judge_unseen(around && *around == 0 ? "its cells were never visited"
                                          : "no compared point depends on it",
                   table.shape, unknown);
    }
    mark_edge_cells(seen, &table);
    mark_held(table, calibration->unknowns);
  }
}

std::vector<std::string> identifiability_notes(const Fit& fit, const Calibration& calibration) {
  std::vector<std::string> notes;
  for (std::size_t u = 0; u < calibration.unknowns.size() && u < fit.vary.size(); ++u) {
    const FittedUnknown& unknown = calibration.unknowns[u];
    if (unknown.identifiability == Identifiability::kNeverVisited) {
      notes.push_back(unknown.name + " is not identifiable: " + unknown.why +
                      "; compare a quantity or a time in which it acts");
    }
  }
  for (const FittedTable& table : calibration.tables) {
    for (std::string& note : table_notes(fit, calibration, table)) notes.push_back(std::move(note));
    note_held(fit, calibration, table, notes);
  }
  for (const UnseenCombination& combination : unseen_combinations(calibration)) {
    notes.push_back(combination.sentence + "; set one of them, or add data that tell them apart");
  }
  for (std::size_t u = 0; u < calibration.unknowns.size() && u < fit.vary.size(); ++u) {
    const FittedUnknown& unknown = calibration.unknowns[u];
    const fit::FitStatistics& statistics = calibration.statistics;
    const bool in_combination =
        unknown.visits > 0 && u < statistics.identifiable.size() && statistics.identifiable[u] == 0;
    if (unknown.identifiability == Identifiability::kWeak && !in_combination) {
      notes.push_back(unknown.name + " is only weakly known: " + unknown.why);
    }
  }
  add_correlated_pairs(calibration, notes);
  return notes;
}

}  // namespace slipbench::driver::calibrate
