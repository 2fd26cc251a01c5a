// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "driver/base/text/tics.hpp"
#include "driver/plot/chosen_columns.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/plot/loops.hpp"
#include "driver/plot/numbers.hpp"
#include "driver/plot/path_rows.hpp"
#include "driver/plot/text_lines.hpp"
#include "driver/results/pixel_columns.hpp"

namespace slipbench::driver::plot {
namespace {

namespace fs = std::filesystem;

/// More curves than this cannot be told apart.
constexpr std::size_t kMostCurves = 12;
constexpr std::size_t kLegendLength = 34;

/// From the lowest to the highest of some numbers.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double number) {
    low = std::min(low, number);
    high = std::max(high, number);
  }
  double width() const { return high > low ? high - low : 0.0; }
};

/// Data of a picture of several inputs, input by input.
class Curves {
 public:
  Curves(std::string x, std::vector<std::string> y) : x_(std::move(x)), y_(std::move(y)) {}

  /// \param name what the legend calls the input
  tl::expected<void, PlotFailure> add(const ResultRows& rows, const results::ResultLayout& layout,
                                      const std::string& name) {
    if (auto sound = judge(rows, layout); !sound) return sound;
    // A reader wants each column once; the time says how far a curve has come.
    std::vector<std::string> columns{"t"};
    const auto place = [&](const std::string& column) {
      auto found = std::find(columns.begin(), columns.end(), column);
      if (found == columns.end()) found = columns.insert(found, column);
      return static_cast<std::size_t>(found - columns.begin());
    };
    const std::size_t x = place(x_);
    std::vector<std::size_t> y;
    for (const std::string& column : y_) y.push_back(place(column));
    std::vector<Range> ranges(columns.size());
    const auto include = [&](std::span<const double> row, std::int64_t at) {
      for (std::size_t k = 0; k < row.size(); ++k) ranges[k].include(row[k]);
      rows_ = at + 1;
    };
    if (auto read = results::each_row(rows.file, rows.shown_name, columns, include); !read) {
      return unreadable(rows.shown_name, read.error());
    }
    time_.include(ranges[0].low);
    time_.include(ranges[0].high);
    const int digits = drawn_digits(ranges[x].low, ranges[x].high);
    x_range_.include(ranges[x].low);
    x_range_.include(ranges[x].high);
    for (std::size_t i = 0; i < y.size(); ++i) {
      y_range_.include(ranges[y[i]].low);
      y_range_.include(ranges[y[i]].high);
      results::PixelColumns over_time(2, ranges[x].low, ranges[x].high, results::kDrawnPixels);
      PathRows path({{1, ranges[x].width()}, {2, ranges[y[i]].width()}}, kMostLoopRows);
      const auto take = [&](std::span<const double> row, std::int64_t) {
        if (x == 0) over_time.add(std::array{row[x], row[y[i]]});
        if (x != 0) path.add(std::array{row[0], row[x], row[y[i]]});
      };
      if (auto read = results::each_row(rows.file, rows.shown_name, columns, take); !read) {
        return unreadable(rows.shown_name, read.error());
      }
      const std::vector<double> drawn = x == 0 ? over_time.finish() : path.finish();
      const std::size_t width = x == 0 ? 2 : 3;
      for (std::size_t at = 0; at + width <= drawn.size(); at += width) {
        points_ += fmt::format("{:.{}g} {:.9g} {:.9g}\n", drawn[at + width - 2], digits,
                               drawn[at + width - 1], drawn[at]);
      }
      points_ += "\n\n";
      script_.add("NAME", one_line(y_.size() == 1 ? name : name + ": " + y_[i], kLegendLength));
      ++count_;
      if (x != 0 && path.taken() < rows_) {
        note_ = fmt::format("the first {} of {} rows", path.taken(), rows_);
      }
    }
    return {};
  }

  std::string title() const { return fmt::format("{} over {}", fmt::join(y_, ", "), x_); }

  PlotScript finish(bool gradient) {
    script_.set("CURVES", count_);
    script_.set("GRADIENT", gradient ? 1 : 0);
    script_.set("X_LABEL", column_label(x_column_));
    script_.set("Y_LABEL", y_.size() == 1 ? column_label(y_column_)
                                          : axis_label(fmt::format("{}", fmt::join(y_, ", ")),
                                                       {"", y_column_.unit}));
    script_.set("TIME_LABEL", axis_label("time", {"t", time_unit_}));
    script_.set("BEGIN", time_.low);
    script_.set("END_TIME", time_.width() > 0.0 ? time_.high : time_.low + 1.0);
    const auto axis = [&](const std::string& letter, const Range& range, double room) {
      const double half = range.width() > 0.0 ? 0.0
                          : range.low == 0.0  ? 1.0
                                              : 0.5 * std::abs(range.low);
      script_.set(letter + "_FROM", range.low - half - room * range.width());
      script_.set(letter + "_TO", range.high + half + room * range.width());
      script_.set(letter + "_STEP", wide_tic_step(range.low - half, range.high + half, 7.0));
      script_.set(letter + "_FORMAT", tic_format(range.low, range.high));
    };
    axis("X", x_range_, x_ == "t" ? 0.0 : 0.04);
    axis("Y", y_range_, 0.06);
    script_.set("NOTE", note_);
    script_.block("POINTS", std::move(points_));
    return std::move(script_);
  }

 private:
  /// Returns whether the input has the columns, in the units of those before it.
  tl::expected<void, PlotFailure> judge(const ResultRows& rows,
                                        const results::ResultLayout& layout) {
    const auto agrees = [&](const std::string& name,
                            results::PlotColumn& known) -> tl::expected<void, PlotFailure> {
      const auto column = chosen_column(rows, layout, name);
      if (!column) return tl::unexpected(column.error());
      if (known.name.empty()) {
        known = *column;
        known_in_ = known_in_.empty() ? rows.shown_name : known_in_;
      }
      if (known.unit == column->unit || known.unit.empty() || column->unit.empty()) return {};
      const bool here = known_in_ == rows.shown_name;
      return failed(
          base::kExitBadInput,
          fmt::format("{}: {} is in {}, {}{} in {}; the curves of one picture share their "
                      "axes",
                      rows.shown_name, name, column->unit, known.name,
                      here ? "" : " of " + known_in_, known.unit));
    };
    if (auto sound = agrees(x_, x_column_); !sound) return sound;
    for (const std::string& name : y_) {
      if (auto sound = agrees(name, y_column_); !sound) return sound;
    }
    const auto unit = layout.column_units.find("t");
    if (unit != layout.column_units.end()) time_unit_ = unit->second;
    return {};
  }

  std::string x_;
  std::vector<std::string> y_;
  results::PlotColumn x_column_;
  results::PlotColumn y_column_;
  std::string known_in_;  ///< the input that said the units first
  std::string time_unit_;
  Range time_;
  Range x_range_;
  Range y_range_;
  std::int64_t rows_ = 0;
  int count_ = 0;
  std::string points_;
  std::string note_;
  PlotScript script_;
};

/// Returns what the legend calls inputs: their stems, or if two of them are alike the inputs as
/// typed.
std::vector<std::string> names_of(const std::vector<std::string>& inputs) {
  std::vector<std::string> stems;
  for (const std::string& input : inputs) stems.push_back(fs::path(input).stem().string());
  const std::set<std::string> different(stems.begin(), stems.end());
  return different.size() == stems.size() ? stems : inputs;
}

tl::expected<void, PlotFailure> draw_over_each_other(PlotOptions options, const fs::path& picture,
                                                     bool portrait) {
  auto begun = begin_picture(picture, options, "curves.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  std::vector<std::string> inputs{options.input};
  inputs.insert(inputs.end(), options.more.begin(), options.more.end());
  if (inputs.size() * std::max<std::size_t>(1, options.y.size()) > kMostCurves) {
    return failed(
        base::kExitBadInput,
        fmt::format("more than {} curves cannot be told apart in one picture", kMostCurves));
  }
  const std::vector<std::string> names = names_of(inputs);
  std::string title;
  std::optional<Curves> curves;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    options.input = inputs[i];
    const auto rows = rows_for_plot(options, picture);
    if (!rows) return tl::unexpected(rows.error());
    const auto layout = layout_for_plot(*rows);
    if (!layout) return tl::unexpected(layout.error());
    if (!curves) {
      std::string x = options.x;
      std::vector<std::string> y = options.y;
      const auto usual = usual_columns(*rows, *layout);
      if (!usual) return tl::unexpected(usual.error());
      const std::string& up = portrait ? usual->velocity : usual->force;
      if (portrait && up.empty() && y.empty()) {
        return failed(base::kExitBadInput,
                      options.input +
                          ": nothing moves, or its velocity is no column of this "
                          "result; name the columns with --x and --y");
      }
      // Over time, unless one of the usual pair is drawn: columns that were not named go together.
      if (x.empty()) {
        x = y.empty() || portrait ? usual->position : "t";
        if (x.empty()) x = "t";
      }
      if (y.empty()) y = {up};
      if (y.front().empty()) {
        return failed(base::kExitBadInput,
                      options.input + ": has no friction force; name a column with --y");
      }
      curves.emplace(x, y);
      title = inputs.size() > 1       ? curves->title()
              : rows->problem         ? picture_title(*rows->problem)
              : layout->title.empty() ? names[i]
                                      : layout->title;
    }
    if (auto added = curves->add(*rows, *layout, names[i]); !added) return added;
  }
  const bool gradient = portrait && inputs.size() == 1 && options.y.size() <= 1;
  return draw(curves->finish(gradient), title, 640, *begun);
}

}  // namespace

tl::expected<void, PlotFailure> draw_curves(const PlotOptions& options, const fs::path& picture) {
  return draw_over_each_other(options, picture, false);
}

tl::expected<void, PlotFailure> draw_phase_portrait(const PlotOptions& options,
                                                    const fs::path& picture) {
  return draw_over_each_other(options, picture, true);
}

}  // namespace slipbench::driver::plot
