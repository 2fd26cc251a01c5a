// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/tics.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/check/check.hpp"
#include "driver/check/criteria/criteria.hpp"
#include "driver/check/kept_rows.hpp"
#include "driver/check/verdict_text.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/plot/numbers.hpp"
#include "driver/plot/text_lines.hpp"
#include "driver/results/thinning.hpp"

namespace slipbench::driver::plot {
namespace {

constexpr std::size_t kMostPanels = 12;
constexpr std::size_t kRows = 2000;
/// Residuals below this part of the tolerance are drawn at their own size.
constexpr double kTooSmall = 0.02;
/// Letters that fit into a line of a panel, of its heading and of the text below it; as many again
/// if there is one panel only.
constexpr std::size_t kHeadingLength = 52;
constexpr std::size_t kTextLength = 74;

struct Judged {
  const cases::Check* check = nullptr;
  check::Verdict verdict;
  check::CheckTrace trace;
};

class Panels {
 public:
  explicit Panels(std::size_t in_a_row) : in_a_row_(in_a_row) {}

  void add(const Judged& judged) {
    const check::Verdict& verdict = judged.verdict;
    const bool pointwise = verdict.criterion == cases::Criterion::kPointwise;
    check::PointwiseComparison compared =
        check::compare_points(judged.trace.value, judged.trace.reference);
    const double tube = pointwise ? judged.trace.tube : 0.0;
    double worst = 0.0;
    std::vector<double> table;
    double from = std::numeric_limits<double>::infinity();
    double to = -from;
    const check::CurvePoint* at = nullptr;
    for (const check::CurvePoint& point : compared.points) {
      const double residual = point.value - point.reference;
      table.insert(table.end(), {point.abscissa, residual});
      from = std::min(from, point.abscissa);
      to = std::max(to, point.abscissa);
      if (at == nullptr || std::abs(residual) > worst) {
        worst = std::abs(residual);
        at = &point;
      }
    }
    const std::vector<std::size_t> rows = results::thinned_rows(table, 2, kRows);
    for (const std::size_t row : rows) {
      const double residual = table[2 * row + 1];
      points_ += fmt::format("{:.{}g} {:.6g} {}\n", table[2 * row], drawn_digits(from, to),
                             residual, tube > 0.0 && std::abs(residual) > tube ? 1 : 0);
    }
    points_ += rows.empty() ? "NaN NaN 0\n\n\n" : "\n\n";
    script_.add("POINTS", static_cast<int>(rows.size()));
    tell_lines("NAME", (verdict.passed ? "PASS  " : "FAIL  ") + verdict.name, kHeadingLength);
    tell_lines("SAYS", says(judged, compared.fault), kTextLength);
    script_.add("LABEL", axis_label("residual", {"", verdict.unit}));
    script_.add(
        "ABSCISSA",
        axis_label(judged.trace.abscissa_label == "t" ? "time t" : judged.trace.abscissa_label,
                   {"", judged.trace.abscissa_unit}));
    script_.add("TUBE", tube);
    script_.add("POINTWISE", pointwise ? 1 : 0);
    // A flat line in a wide band says nothing: then the band fills the panel.
    const bool small = worst < kTooSmall * tube && worst > 0.0;
    const double high = small ? 1.6 * worst : 1.25 * std::max(tube, worst);
    const double drawn = high > 0.0 && std::isfinite(high) ? high : 1.0;
    script_.add("HIGH", drawn);
    script_.add("Y_STEP", base::tic_step(2.0 * drawn, 4.0));
    script_.add("WIDE", small ? 1 : 0);
    script_.add("WORST_AT", at == nullptr ? std::nan("") : at->abscissa);
    script_.add("WORST", at == nullptr ? std::nan("") : at->value - at->reference);
    if (compared.points.empty()) {
      from = 0.0;
      to = 1.0;
    }
    if (!(to > from)) {
      const double half = from == 0.0 ? 0.5 : 0.5 * std::abs(from);
      from -= half;
      to = from + 2.0 * half;
    }
    script_.add("FORMAT", tic_format(from, to));
    script_.add("FROM", from - 0.02 * (to - from));
    script_.add("TO", to + 0.02 * (to - from));
    script_.add("STEP", base::tic_step(to - from, 5.0));
    ++count_;
  }

  PlotScript finish() {
    script_.set("PANELS", count_);
    script_.block("RESIDUALS", std::move(points_));
    return std::move(script_);
  }

 private:
  static std::string says(const Judged& judged, const std::string& fault) {
    const check::Verdict& verdict = judged.verdict;
    const std::string criterion = verdict.criterion == cases::Criterion::kPointwise
                                      ? ""
                                      : std::string(check::info_of(verdict.criterion).word) + ": ";
    if (!verdict.passed) return criterion + verdict.message;
    std::string text = criterion + check::worst_text(*judged.check, verdict);
    if (!fault.empty()) text += "; point by point it cannot be drawn, for " + fault;
    return text;
  }

  /// The lines of a text, two at most, as the entries NAME_1 and NAME_2.
  void tell_lines(const std::string& name, const std::string& text, std::size_t length) {
    std::vector<std::string> lines = lines_of_length(text, in_a_row_ == 1 ? 2 * length : length, 2);
    lines.resize(2);
    script_.add(name + "_1", lines[0]);
    script_.add(name + "_2", lines[1]);
  }

  PlotScript script_;
  std::size_t in_a_row_;
  int count_ = 0;
  std::string points_;
};

}  // namespace

tl::expected<void, PlotFailure> draw_residuals(const PlotOptions& options,
                                               const std::filesystem::path& picture) {
  if (is_result(options)) {
    return failed(base::kExitBadInput, options.input + ": a result has no checks; give the case");
  }
  auto begun = begin_picture(picture, options, "residuals.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  const auto problem = read_for_plot(options);
  if (!problem) return tl::unexpected(problem.error());
  if (problem->checks.empty()) {
    return failed(base::kExitBadInput,
                  options.input + ": has no checks, so there are no residuals");
  }
  if (const std::string fault = check::memory_fault(*problem, check::Trace::kKeep);
      !fault.empty()) {
    return failed(base::kExitEnvironment, options.input + ": " + fault);
  }
  std::vector<check::CheckProgress> checks;
  for (const cases::Check& check : problem->checks)
    checks.emplace_back(*problem, check, check::Trace::kKeep);
  auto followed = follow_for_plot(*problem, [&](const bench::Simulation& simulation) {
    for (check::CheckProgress& check : checks) check.add(simulation.row());
  });
  if (!followed) return followed;

  std::vector<Judged> all;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    all.push_back({&problem->checks[i], checks[i].verdict(), checks[i].trace()});
  }
  std::stable_partition(all.begin(), all.end(),
                        [](const Judged& one) { return !one.verdict.passed; });
  const std::size_t count = std::min(kMostPanels, all.size());
  Panels panels(count > 1 ? 2 : 1);
  for (std::size_t i = 0; i < count; ++i) panels.add(all[i]);
  std::string title = picture_title(*problem);
  if (count < all.size()) title += fmt::format(" ({} of {} checks)", count, all.size());
  const std::size_t in_columns = count > 1 ? (count + 1) / 2 : 1;
  return draw(panels.finish(), title, 60 + (count > 1 ? 345 : 460) * in_columns, *begun);
}

}  // namespace slipbench::driver::plot
