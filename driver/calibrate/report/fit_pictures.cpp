// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/report/fit_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "driver/base/files/file_part.hpp"
#include "driver/base/text/tics.hpp"
#include "driver/calibrate/report/drawn_points.hpp"
#include "driver/calibrate/report/residual_view.hpp"
#include "driver/calibrate/report/table_view.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/numbers.hpp"
#include "driver/plot/picture_mark.hpp"
#include "driver/plot/script.hpp"
#include "driver/plot/text_lines.hpp"
#include "driver/results/thinning.hpp"

namespace slipbench::driver::calibrate {
namespace fs = std::filesystem;
namespace {

/// Gnuplot takes some 50 ms for the two of an experiment.
constexpr std::size_t kMostDrawn = 20;
constexpr std::size_t kMostResponses = 6;
constexpr std::size_t kMostBlocks = 6;
constexpr std::size_t kPoints = 3000;
/// More points than this are drawn smaller.
constexpr std::size_t kFewPoints = 300;
constexpr std::size_t kTextLength = 130;
constexpr std::size_t kTitleLength = 80;

/// Span of an axis: the range of the numbers with some air, wider where they are all alike.
struct Span {
  double low = 0.0;
  double high = 1.0;
};

Span span_of(std::initializer_list<const std::vector<double>*> lists, double air) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const std::vector<double>* list : lists) {
    for (const double value : *list) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (!(low <= high)) return {};
  const double size = std::max(std::abs(low), std::abs(high));
  if (!(high - low > 1e-9 * size)) {
    const double half = size > 0.0 ? 0.5 * size : 0.5;
    return {low - half, high + half};
  }
  return {low - air * (high - low), high + air * (high - low)};
}

void tell_axis(plot::PlotScript& script, std::string_view from, std::string_view to,
               std::string_view step, std::string_view format, const Span& span) {
  script.add(from, span.low);
  script.add(to, span.high);
  script.add(step, base::tic_step(span.high - span.low, 5.0));
  script.add(format, plot::tic_format(span.low, span.high));
}

double point_size(std::size_t points) { return points > kFewPoints ? 0.25 : 0.5; }

std::string number_with_unit(double value, const std::string& unit) {
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string thinned_note(bool thinned) { return thinned ? "thinned: extremes are kept" : ""; }

std::string title_of(const std::string& name) { return plot::one_line(name, kTitleLength); }

std::string title_of(const Fit& fit, const ExperimentFit& experiment) {
  return title_of(experiment.name + (experiment.held_out ? " (held out): " : ": ") +
                  (fit.title.empty() ? fit.file : fit.title));
}

/// The label of an axis; a name that is longer than the axis stands above the picture, too.
std::string short_label(const std::string& name, const std::string& unit) {
  constexpr std::size_t kLongest = 30;
  return plot::axis_label(name.size() > kLongest ? "value" : name, {"", unit});
}

/// A script and what its picture is called and how high it is.
struct Drawing {
  plot::PlotScript script;
  std::string title;
  std::size_t height = 0;
};

std::size_t drawn_responses(const FittedExperiment& one) {
  return std::min(kMostResponses, one.responses.size());
}

Drawing loops(const Fit& fit, const FittedExperiment& one) {
  const ExperimentFit& asked = fit.experiments.at(one.index);
  Drawing drawing;
  plot::PlotScript& script = drawing.script;
  std::string points;
  bool thinned = false;
  const std::size_t count = drawn_responses(one);
  for (std::size_t r = 0; r < count; ++r) {
    const FittedResponse& response = one.responses[r];
    const LoopAxis axis = loop_axis(response);
    const DrawnPoints drawn = drawn_points(response, kPoints);
    thinned = thinned || drawn.thinned;
    const Span time = span_of({&drawn.time}, 0.0);
    const Span position = span_of({&drawn.position}, 0.04);
    const Span value = span_of({&drawn.measured, &drawn.before, &drawn.after}, 0.06);
    for (std::size_t i = 0; i < drawn.time.size(); ++i) {
      points += fmt::format("{:.{}g} {:.9g} {:.7g} {:.7g} {:.7g}\n", drawn.time[i],
                            plot::drawn_digits(time.low, time.high),
                            drawn.position.empty() ? 0.0 : drawn.position[i], drawn.measured[i],
                            drawn.before[i], drawn.after[i]);
    }
    points += drawn.time.empty() ? "NaN NaN NaN NaN NaN\n\n\n" : "\n\n";
    script.add("LABEL", short_label(response.quantity, response.unit));
    script.add("NAME", plot::one_line(response.quantity, kTitleLength));
    script.add("SAYS",
               fmt::format("root mean square of model minus measurement: {} before, {} after",
                           number_with_unit(response.rmse_before, response.unit),
                           number_with_unit(response.rmse_after, response.unit)));
    script.add("LOOP", axis.name.empty() ? 0 : 1);
    script.add("X_LABEL", plot::axis_label("position", {axis.name, axis.unit}));
    tell_axis(script, "FROM", "TO", "X_STEP", "X_FORMAT", position);
    tell_axis(script, "BEGIN", "END", "T_STEP", "T_FORMAT", time);
    tell_axis(script, "LOW", "HIGH", "Y_STEP", "Y_FORMAT", value);
    script.add("POINT_SIZE", point_size(drawn.time.size()));
  }
  script.set("PANELS", static_cast<int>(count));
  script.set("NOTE", thinned_note(thinned));
  script.set("TIME_LABEL", plot::axis_label("time", {"t", asked.base.units.time}));
  script.block("POINTS", std::move(points));
  drawing.title = title_of(fit, asked);
  drawing.height = 60 + 460 * count;
  return drawing;
}

Drawing residuals(const Fit& fit, const FittedExperiment& one) {
  const ExperimentFit& asked = fit.experiments.at(one.index);
  Drawing drawing;
  plot::PlotScript& script = drawing.script;
  std::string rows;
  std::string bins;
  bool thinned = false;
  const std::size_t count = drawn_responses(one);
  for (std::size_t r = 0; r < count; ++r) {
    const FittedResponse& response = one.responses[r];
    const ResidualView view = residual_view(response, response.after);
    const Span time = span_of({&response.time}, 0.0);
    std::vector<double> table;
    for (std::size_t i = 0; i < std::min(view.residuals.size(), response.time.size()); ++i) {
      table.insert(table.end(), {response.time[i], view.residuals[i]});
    }
    const std::vector<std::size_t> drawn = results::thinned_rows(table, 2, kPoints);
    thinned = thinned || drawn.size() < table.size() / 2;
    for (const std::size_t row : drawn) {
      rows += fmt::format("{:.{}g} {:.7g}\n", table[2 * row],
                          plot::drawn_digits(time.low, time.high), table[2 * row + 1]);
    }
    rows += drawn.empty() ? "NaN NaN\n\n\n" : "\n\n";
    const double width = (view.highest - view.lowest) /
                         static_cast<double>(std::max<std::size_t>(1, view.counts.size()));
    std::int64_t total = 0;
    std::int64_t most = 1;
    for (std::size_t i = 0; i < view.counts.size(); ++i) {
      bins += fmt::format("{:.9g} {}\n", view.lowest + (static_cast<double>(i) + 0.5) * width,
                          view.counts[i]);
      total += view.counts[i];
      most = std::max(most, view.counts[i]);
    }
    bins += view.counts.empty() ? "NaN NaN\n\n\n" : "\n\n";
    const double peak = view.deviation > 0.0
                            ? static_cast<double>(total) * width / (view.deviation * 2.5066282746)
                            : 0.0;
    script.add("NAME", plot::one_line(response.quantity, kTitleLength));
    std::vector<std::string> says = plot::lines_of_length(view.words, kTextLength, 2);
    says.resize(2);
    script.add("SAYS_1", says[0]);
    script.add("SAYS_2", says[1]);
    script.add("LABEL", plot::axis_label("model minus measurement", {"", response.unit}));
    const double largest = std::max(std::abs(view.lowest), std::abs(view.highest));
    const double high = largest > 0.0 ? 1.1 * largest : 1.0;
    script.add("HIGH", high);
    script.add("Y_STEP", base::tic_step(2.0 * high, 4.0));
    const double top = 1.1 * std::max(static_cast<double>(most), peak);
    script.add("TOP", top);
    script.add("COUNT_STEP", std::max(1.0, base::tic_step(top, 5.0)));
    script.add("WIDTH", width);
    script.add("MEAN", view.mean);
    script.add("DEVIATION", view.deviation);
    script.add("TOTAL", static_cast<double>(total));
    tell_axis(script, "BEGIN", "END", "T_STEP", "T_FORMAT", time);
    script.add("POINT_SIZE", drawn.size() > kFewPoints ? 0.0 : 0.4);
  }
  script.set("PANELS", static_cast<int>(count));
  script.set("NOTE", thinned_note(thinned));
  script.set("TIME_LABEL", plot::axis_label("time", {"t", asked.base.units.time}));
  script.block("RESIDUALS", std::move(rows));
  script.block("BINS", std::move(bins));
  drawing.title = title_of(fit, asked);
  drawing.height = 60 + 420 * count;
  return drawing;
}

/// "set xtics (...)" where knots are told one by one, the usual ones elsewhere.
std::string tics_of(const TableView& view, const Span& span) {
  if (!view.even) {
    return fmt::format("set xtics {:.9g}", base::tic_step(span.high - span.low, 8.0));
  }
  std::string text = "set xtics (";
  const std::vector<double>& knots = view.axes[0].knots;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    text += fmt::format("{}\"{:.6g}\" {}", i > 0 ? ", " : "", knots[i], i);
  }
  return text + ")";
}

/// The cells of a table of one independent that were never visited, from and to.
std::string unseen_cells(const TableView& view, const FittedTable& table) {
  std::string rows;
  if (!view.cell_grid || view.axes.size() != 1) return rows;
  const std::vector<double>& knots = view.axes[0].knots;
  for (std::size_t i = 0; i < table.cells.size(); ++i) {
    if (table.cells[i].visited()) continue;
    const auto place = static_cast<double>(i);
    rows += view.even ? fmt::format("{} {}\n", place, place + 1.0)
                      : fmt::format("{:.9g} {:.9g}\n", knots[i], knots[i + 1]);
  }
  return rows;
}

std::string unseen_words(const FittedTable& table) {
  std::vector<std::string> never;
  for (const FittedTable::Cell& cell : table.cells) {
    if (!cell.visited()) never.push_back(cell.text);
  }
  if (never.empty()) return {};
  return fmt::format("{} of {} cells never visited: {}", never.size(), table.cells.size(),
                     fmt::join(never, "; "));
}

Drawing ordinates(const Fit& fit, const Calibration& calibration, const FittedTable& table) {
  const VariedTable& asked = fit.tables.at(table.index);
  const TableView view = table_view(table);
  const fit::FitStatistics& statistics = calibration.statistics;
  Drawing drawing;
  plot::PlotScript& script = drawing.script;
  std::string rows;
  std::vector<double> all;
  std::vector<double> places;
  const std::size_t step = (view.blocks.size() + kMostBlocks - 1) / kMostBlocks;
  int blocks = 0;
  for (std::size_t b = 0; b < view.blocks.size(); b += step, ++blocks) {
    const TableView::Block& block = view.blocks[b];
    for (std::size_t i = 0; i < block.place.size(); ++i) {
      const std::size_t at = table.first_unknown + block.first + i;
      const FittedUnknown& one = calibration.unknowns.at(at);
      const bool known = at < statistics.lower.size() && at < statistics.upper.size();
      const double low = known ? statistics.lower[at] : std::nan("");
      const double high = known ? statistics.upper[at] : std::nan("");
      rows += fmt::format("{:.9g} {:.7g} {:.7g} {} {} {}\n", block.place[i], one.range.start,
                          one.value, std::isfinite(low) ? fmt::format("{:.7g}", low) : "NaN",
                          std::isfinite(high) ? fmt::format("{:.7g}", high) : "NaN",
                          one.identifiability == Identifiability::kNeverVisited ? 1 : 0);
      all.insert(all.end(), {one.range.start, one.value, low, high});
      places.push_back(block.place[i]);
    }
    rows += "\n\n";
    script.add("NAME", plot::one_line(block.label, 40));
  }
  const Span x = span_of({&places}, 0.04);
  const Span y = span_of({&all}, 0.08);
  const TableView::Axis axis = view.axes.empty() ? TableView::Axis{} : view.axes.front();
  script.set("BLOCKS", blocks);
  script.set("FROM", x.low);
  script.set("TO", x.high);
  script.set("LOW", y.low);
  script.set("HIGH", y.high);
  script.set("Y_STEP", base::tic_step(y.high - y.low, 5.0));
  script.set("TICS", tics_of(view, x));
  script.set("X_LABEL", plot::axis_label(axis.name, {"", axis.unit}));
  script.set("LABEL", short_label(asked.free, calibration.unknowns.at(table.first_unknown).unit));
  script.set("INTERVAL", fmt::format("{:.4g} % interval", 100.0 * fit.confidence));
  std::string says = fmt::format(
      "Light before, strong after{}; hollow: never visited.",
      view.blocks.size() > 1 ? fmt::format(", with {:.4g} % intervals", 100.0 * fit.confidence)
                             : "");
  if (view.even) says += " Knots are drawn equally far apart.";
  if (step > 1) says += fmt::format(" {} of {} curves.", blocks, view.blocks.size());
  script.set("SAYS_1", says);
  script.set("SAYS_2", plot::one_line(unseen_words(table), kTextLength));
  std::string unseen = unseen_cells(view, table);
  script.set("UNSEEN", unseen.empty() ? 0 : 1);
  script.block("UNSEEN", unseen.empty() ? "NaN NaN\n" : std::move(unseen));
  script.block("ORDINATES", std::move(rows));
  drawing.title = title_of(asked.name);
  drawing.height = 600;
  return drawing;
}

/// Names of pictures, no two alike.
class PictureNames {
 public:
  explicit PictureNames(std::string_view stem) : stem_(stem) {}

  std::string of(std::string_view name, std::string_view kind) {
    std::string file = fmt::format("{}.{}.{}.svg", stem_, base::file_part(name), kind);
    for (int n = 2; !taken_.insert(file).second; ++n) {
      file = fmt::format("{}.{}-{}.{}.svg", stem_, base::file_part(name), n, kind);
    }
    return file;
  }

 private:
  std::string stem_;
  std::set<std::string> taken_;
};

/// Draws one picture after the other; after one that gnuplot cannot draw it tries no more.
class Pictures {
 public:
  Pictures(fs::path folder, const std::string& fit, const base::Overwriting& overwriting)
      : folder_(std::move(folder)), overwriting_(overwriting) {
    options_.input = fit;
    options_.force = overwriting.force;
  }

  /// \param make the drawing, made only if it is to be drawn
  template <class Make>
  void draw(const std::string& file, std::string_view pattern, Make make) {
    if (given_up_) return;
    const std::string fault =
        base::target_fault(folder_ / file, plot::picture_mark(options_.input), overwriting_);
    if (!fault.empty()) {
      found_.notes.push_back("a picture was not drawn: " + fault);
      return;
    }
    auto picture = plot::begin_picture(folder_ / file, options_, pattern);
    if (!picture) return give_up(picture.error());
    const Drawing drawing = make();
    const auto drawn =
        slipbench::driver::plot::draw(drawing.script, drawing.title, drawing.height, *picture);
    if (!drawn) return give_up(drawn.error());
    found_.written.push_back(folder_ / file);
  }

  void note(std::string text) { found_.notes.push_back(std::move(text)); }

  FitPictures take() { return std::move(found_); }

 private:
  void give_up(const plot::PlotFailure& failure) {
    constexpr std::string_view kPrefix = "slipbench: error: ";
    std::string_view why = failure.message;
    if (why.starts_with(kPrefix)) why.remove_prefix(kPrefix.size());
    while (why.ends_with('\n')) why.remove_suffix(1);
    found_.notes.push_back(fmt::format("not all pictures were drawn: {}", why));
    given_up_ = true;
  }

  fs::path folder_;
  plot::PlotOptions options_;
  base::Overwriting overwriting_;
  FitPictures found_;
  bool given_up_ = false;
};

}  // namespace

std::vector<std::string> fit_picture_names(const Fit& fit, std::string_view stem) {
  PictureNames names(stem);
  std::vector<std::string> all;
  for (const ExperimentFit& experiment : fit.experiments) {
    all.push_back(names.of(experiment.name, "loop"));
    all.push_back(names.of(experiment.name, "residuals"));
  }
  for (const VariedTable& table : fit.tables) all.push_back(names.of(table.name, "table"));
  return all;
}

FitPictures draw_fit_pictures(const Fit& fit, const Calibration& calibration,
                              const std::filesystem::path& folder, std::string_view stem,
                              const base::Overwriting& overwriting) {
  const std::vector<std::string> names = fit_picture_names(fit, stem);
  Pictures pictures(folder, fit.file, overwriting);
  std::size_t drawn = 0;
  for (const FittedExperiment& one : calibration.experiments) {
    if (one.responses.empty()) continue;
    if (drawn++ == kMostDrawn) {
      pictures.note(fmt::format("pictures show the first {} of {} experiments, the page all",
                                kMostDrawn, calibration.experiments.size()));
      break;
    }
    pictures.draw(names.at(2 * one.index), "fit_loops.gp", [&] { return loops(fit, one); });
    pictures.draw(names.at(2 * one.index + 1), "fit_residuals.gp",
                  [&] { return residuals(fit, one); });
  }
  for (const FittedTable& table : calibration.tables) {
    pictures.draw(names.at(2 * fit.experiments.size() + table.index), "fit_table.gp",
                  [&] { return ordinates(fit, calibration, table); });
  }
  return pictures.take();
}

}  // namespace slipbench::driver::calibrate
