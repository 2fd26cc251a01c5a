// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/curve_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "driver/base/text/tics.hpp"

namespace slipbench::driver::base {
namespace {

/// A field of characters; (0, 0) is the lower left one.
class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width),
        rows_(static_cast<std::size_t>(height), std::string(static_cast<std::size_t>(width), ' ')) {
  }

  bool free(int x, int y, int length) const {
    if (x < 0 || y < 0 || x + length > width_ || y >= static_cast<int>(rows_.size())) return false;
    return row(y).find_first_not_of(' ', static_cast<std::size_t>(x)) >=
           static_cast<std::size_t>(x + length);
  }
  void put(int x, int y, std::string_view text) {
    for (const char c : text) {
      rows_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x++)] = c;
    }
  }
  const std::string& row(int y) const { return rows_[static_cast<std::size_t>(y)]; }

 private:
  int width_;
  std::vector<std::string> rows_;
};

std::string without_trailing_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

double largest_value(const CurveDrawing& drawing, int width) {
  double largest = 0.0;
  for (const DrawnCurve& curve : drawing.curves) {
    for (int x = 0; x < width; ++x) {
      const double y = curve.value(drawing.x_end * x / (width - 1));
      if (std::isfinite(y)) largest = std::max(largest, y);
    }
  }
  return largest > 0.0 ? largest : 1.0;
}

/// The curve's character in each column, and in those between two neighbours that lie far apart.
void draw_curve(const DrawnCurve& curve, double x_end, double per_row, int width, int rows,
                Canvas& canvas) {
  int before = -1;
  for (int x = 0; x < width; ++x) {
    const double value = curve.value(x_end * x / (width - 1));
    if (!std::isfinite(value) || value < 0.0) {
      before = -1;
      continue;
    }
    const int y = std::min(static_cast<int>(std::lround(value / per_row)), rows - 1);
    int from = y;
    if (before > y + 1) from = before - 1;
    if (before >= 0 && before < y - 1) from = before + 1;
    for (int k = std::min(from, y); k <= std::max(from, y); ++k) {
      if (canvas.free(x, k, 1)) canvas.put(x, k, std::string_view(&curve.pen, 1));
    }
    before = y;
  }
}

void name_point(const DrawnPoint& point, double x_end, double per_row, int width, Canvas& canvas) {
  const int x = static_cast<int>(std::lround(point.x / x_end * (width - 1)));
  const int y = static_cast<int>(std::lround(point.y / per_row));
  const int length = static_cast<int>(point.name.size());
  // Above the point, below it, or beside it: wherever the curves leave room.
  for (const auto& [dx, dy] :
       {std::pair{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 0}, {0, 2}, {0, -2}}) {
    if (!canvas.free(x + dx, y + dy, length)) continue;
    canvas.put(x + dx, y + dy, point.name);
    return;
  }
}

}  // namespace

std::string draw(const CurveDrawing& drawing, int width, int height) {
  // Whole rows between the tics, so that the numbers at the axis are true.
  const double largest = largest_value(drawing, width);
  const double step = tic_step(largest, 4.0);
  const int intervals = static_cast<int>(std::ceil(largest / step * (1.0 - 1e-12)));
  const int rows_per_step = std::max(1, (height - 1) / intervals);
  const int rows = intervals * rows_per_step + 1;
  const double per_row = step / rows_per_step;

  Canvas canvas(width, rows + 1);  // one row more for the name of a point at the top
  for (const DrawnCurve& curve : drawing.curves) {
    draw_curve(curve, drawing.x_end, per_row, width, rows, canvas);
  }
  for (const DrawnPoint& point : drawing.points) {
    name_point(point, drawing.x_end, per_row, width, canvas);
  }

  std::size_t margin = drawing.y_name.size();
  for (int k = 0; k <= intervals; ++k) {
    margin = std::max(margin, fmt::format("{:.6g}", k * step).size());
  }
  std::string text;
  for (int y = rows; y > 0; --y) {
    std::string name =
        y % rows_per_step == 0 ? fmt::format("{:.6g}", y / rows_per_step * step) : "";
    if (y == rows) name = drawing.y_name;
    text += without_trailing_blanks(fmt::format(
        "{:>{}} {}{}", name, margin, y == rows || name.empty() ? '|' : '+', canvas.row(y)));
  }
  // The axis: where a curve lies on it, the curve is seen.
  std::string axis = canvas.row(0);
  std::replace(axis.begin(), axis.end(), ' ', '-');
  std::string numbers(static_cast<std::size_t>(width) + margin + 8, ' ');
  // Room for the numbers of a narrow drawing.
  const double x_step = tic_step(drawing.x_end, std::clamp(width / 12.0, 1.0, 4.0));
  for (int k = 0; k * x_step <= drawing.x_end * (1.0 + 1e-12); ++k) {
    const auto x = static_cast<std::size_t>(std::lround(k * x_step / drawing.x_end * (width - 1)));
    if (axis[x] == '-') axis[x] = '+';
    const std::string number = fmt::format("{:.6g}", k * x_step);
    numbers.replace(margin + 2 + x - std::min(x + 2, number.size() / 2), number.size(), number);
  }
  text += fmt::format("{:>{}} +{}> {}\n", "0", margin, axis, drawing.x_name);
  text += without_trailing_blanks(numbers);
  std::string legend;
  for (const DrawnCurve& curve : drawing.curves) {
    if (!curve.name.empty()) {
      legend += fmt::format("{}{} {}", legend.empty() ? "" : "    ", curve.pen, curve.name);
    }
  }
  if (!legend.empty()) text += std::string(margin + 2, ' ') + legend + "\n";
  return text;
}

}  // namespace slipbench::driver::base
