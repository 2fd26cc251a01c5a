// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/report/sweep_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "driver/base/text/shell_word.hpp"
#include "driver/report/page_parts.hpp"
#include "driver/report/page_text.hpp"
#include "driver/results/provenance.hpp"
#include "driver/sweep/part.hpp"
#include "driver/sweep/samples.hpp"

namespace slipbench::driver::sweep {
namespace {

using report::escape_html;

std::string digits(double number) { return fmt::format("{:.4g}", number); }

/// Ends of an axis, and where a value stands on it between 0 and 1.
struct Axis {
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;

  double place(double value) const {
    if (logarithmic) return std::log(value / low) / std::log(high / low);
    return (value - low) / (high - low);
  }
};

/// Bars of a histogram, some bins together, with the median and the 5 and 95 % quantiles.
std::string histogram(const SweepSummary::Spread& spread) {
  constexpr double kWidth = 420.0;
  constexpr double kHeight = 120.0;
  constexpr std::size_t kBars = 42;
  if (spread.histogram == nullptr) return {};
  const RunningHistogram& bins = *spread.histogram;
  const std::size_t together = (bins.counts().size() + kBars - 1) / kBars;
  std::vector<std::uint64_t> bars((bins.counts().size() + together - 1) / together);
  for (std::size_t i = 0; i < bins.counts().size(); ++i) bars[i / together] += bins.counts()[i];
  const double width = bins.width() * static_cast<double>(together);
  const Axis axis{bins.begin(), bins.begin() + width * static_cast<double>(bars.size())};
  const auto most = static_cast<double>(*std::max_element(bars.begin(), bars.end()));
  std::string svg = fmt::format(
      "<svg class=\"histogram\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"histogram\">",
      kWidth, kHeight + 34.0);
  const double step = kWidth / static_cast<double>(bars.size());
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double height = kHeight * static_cast<double>(bars[i]) / most;
    const double from = axis.low + width * static_cast<double>(i);
    svg += fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"><title>{} .. {}: "
        "{}</title></rect>",
        step * static_cast<double>(i), kHeight - height, std::max(step - 1.0, 0.5), height,
        digits(from), digits(from + width), bars[i]);
  }
  svg += fmt::format("<path class=\"rail\" d=\"M0 {0}H{1}\"/>", kHeight, kWidth);
  constexpr std::array kNames{"5 %", "median", "95 %"};
  for (std::size_t q = 0; q < kNames.size(); ++q) {
    const double x = kWidth * std::clamp(axis.place(spread.quantiles[q]), 0.0, 1.0);
    svg += fmt::format("<path class=\"mark\" d=\"M{0:.2f} 0V{1}\"><title>{2}: {3}</title></path>",
                       x, kHeight, kNames[q], digits(spread.quantiles[q]));
  }
  svg += fmt::format(
      "<text x=\"0\" y=\"{0}\">{1}</text><text x=\"{2}\" y=\"{0}\" text-anchor=\"end\">{3}</text>",
      kHeight + 16.0, digits(axis.low), kWidth, digits(axis.high));
  return svg + "</svg>";
}

/// One bar of a tornado: a value with its interval, and a second value within.
struct Bar {
  std::string name;
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
  double within = 0.0;
  std::string told;
};

std::vector<Bar> bars_of(const Sweep& sweep, const SweepSummary& summary,
                         const std::optional<SobolEstimate>& indices, std::size_t number) {
  std::vector<Bar> bars;
  if (indices && !indices->varies(number)) return bars;
  const auto parts = indices ? indices->indices(number) : std::vector<SobolIndices>();
  for (std::size_t p = 0; p < sweep.varied.size(); ++p) {
    const std::string& name = sweep.varied[p].name;
    if (indices) {
      const auto& [first, total] = parts[p];
      bars.push_back(
          {name, total.value, total.low, total.high, first.value,
           fmt::format("{:.3f} ({:.3f} .. {:.3f}), alone {:.3f} ({:.3f} .. {:.3f})", total.value,
                       total.low, total.high, first.value, first.low, first.high)});
    } else if (const auto found = summary.correlation(number, p)) {
      bars.push_back(
          {name, found->value, found->low, found->high, 0.0,
           fmt::format("{:.3f} ({:.3f} .. {:.3f})", found->value, found->low, found->high)});
    }
  }
  std::stable_sort(bars.begin(), bars.end(), [](const Bar& a, const Bar& b) {
    return std::abs(a.value) > std::abs(b.value);
  });
  return bars;
}

std::string tornado(const std::vector<Bar>& bars, bool of_variance) {
  constexpr double kWidth = 300.0;
  constexpr double kRow = 22.0;
  if (bars.empty()) return {};
  const Axis axis{of_variance ? 0.0 : -1.0, 1.0};
  const auto x = [&](double value) { return kWidth * std::clamp(axis.place(value), 0.0, 1.0); };
  std::string html = "<div class=\"tornado\">";
  for (const Bar& bar : bars) {
    const double from = std::min(x(0.0), x(bar.value));
    html += fmt::format(
        "<span class=\"name\">{}</span><svg viewBox=\"0 0 {} {}\" role=\"img\" "
        "aria-label=\"{}\"><title>{}</title>",
        escape_html(bar.name), kWidth, kRow, escape_html(bar.told), escape_html(bar.told));
    html += fmt::format("<rect class=\"bar\" x=\"{:.2f}\" y=\"3\" width=\"{:.2f}\" height=\"16\"/>",
                        from, std::abs(x(bar.value) - x(0.0)));
    if (of_variance) {
      html += fmt::format("<rect class=\"alone\" x=\"0\" y=\"3\" width=\"{:.2f}\" height=\"16\"/>",
                          x(bar.within));
    }
    html +=
        fmt::format("<path class=\"whisker\" d=\"M{0:.2f} 11H{1:.2f}M{0:.2f} 7V15M{1:.2f} 7V15\"/>",
                    x(bar.low), x(bar.high));
    html += fmt::format(
        "<path class=\"rail\" d=\"M{0:.2f} 0V{1}\"/></svg><span class=\"told\">{2:.2f}</span>",
        x(0.0), kRow, std::abs(bar.value) < 0.005 ? 0.0 : bar.value);
  }
  return html + "</div>";
}

Axis axis_of_parameter(const Sweep& sweep, const KeptSamples& kept, std::size_t parameter) {
  const Distribution& distribution = sweep.varied[parameter].distribution;
  Axis axis{kept.value(0, parameter), kept.value(0, parameter)};
  for (std::size_t i = 0; i < kept.size(); ++i) {
    axis.low = std::min(axis.low, kept.value(i, parameter));
    axis.high = std::max(axis.high, kept.value(i, parameter));
  }
  axis.logarithmic = distribution.kind == Distribution::Kind::kLogUniform;
  if (!(axis.low < axis.high)) axis = {axis.low - 1.0, axis.high + 1.0};
  return axis;
}

std::string cell(const KeptSamples& kept, std::size_t parameter, std::size_t number, const Axis& x,
                 const Axis& y) {
  constexpr double kWidth = 150.0;
  constexpr double kHeight = 110.0;
  // One path of dots: a line of no length with round ends.
  std::string path;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const double value = kept.number(i, number);
    if (!std::isfinite(value)) continue;
    path +=
        fmt::format("M{:.1f} {:.1f}h0", 4.0 + (kWidth - 8.0) * x.place(kept.value(i, parameter)),
                    kHeight - 4.0 - (kHeight - 8.0) * y.place(value));
  }
  return fmt::format(
      "<td><svg class=\"scatter\" viewBox=\"0 0 {} {}\" aria-hidden=\"true\"><path "
      "d=\"{}\"/></svg></td>",
      kWidth, kHeight, path);
}

/// A matrix of the numbers that vary over the parameters.
std::string matrix(const Sweep& sweep, const SweepSummary& summary, const KeptSamples& kept) {
  constexpr std::size_t kMostColumns = 8;
  std::vector<std::size_t> numbers;
  for (std::size_t n = 0; n < sweep.collected.size(); ++n) {
    const auto spread = summary.spread(n);
    if (spread.count > 0 && spread.least < spread.most) numbers.push_back(n);
  }
  if (numbers.empty() || kept.size() == 0) return {};
  const std::size_t columns = std::min(kMostColumns, sweep.varied.size());
  std::string html = "<section><h2>Numbers over parameters</h2>\n<p class=\"soft\">";
  html += kept.stride() == 1 ? fmt::format("All {} samples.", summary.samples())
                             : fmt::format("Every {}th of {} samples: {} dots.", kept.stride(),
                                           summary.samples(), kept.size());
  if (columns < sweep.varied.size()) {
    html += fmt::format(" The first {} of {} parameters.", columns, sweep.varied.size());
  }
  html += "</p>\n<div class=\"wide\"><table class=\"matrix\"><tbody>\n";
  std::vector<Axis> axes;
  for (std::size_t p = 0; p < columns; ++p) axes.push_back(axis_of_parameter(sweep, kept, p));
  for (const std::size_t n : numbers) {
    const auto spread = summary.spread(n);
    html += fmt::format(
        "<tr><th scope=\"row\"><b>{}</b><span class=\"end\">{}</span><span "
        "class=\"end\">{}</span></th>",
        escape_html(sweep.collected[n].name), digits(spread.most), digits(spread.least));
    for (std::size_t p = 0; p < columns; ++p) {
      html += cell(kept, p, n, axes[p], {spread.least, spread.most});
    }
    html += "</tr>\n";
  }
  html += "<tr><td></td>";
  for (std::size_t p = 0; p < columns; ++p) {
    html += fmt::format(
        "<th scope=\"col\"><span "
        "class=\"ends\"><span>{}</span><span>{}</span></span><b>{}</b>{}</th>",
        digits(axes[p].low), digits(axes[p].high), escape_html(sweep.varied[p].name),
        axes[p].logarithmic ? " (logarithmic)" : "");
  }
  return html + "</tr>\n</tbody></table></div></section>\n";
}

/// The command that runs one sample alone, from where the sweep was run.
std::string command(const Sweep& sweep, std::size_t id) {
  std::vector<double> values(sweep.varied.size());
  Samples samples(sweep);
  samples.skip(id);
  samples.take(values);
  std::string text = "slipbench run " + base::shell_word(sweep.case_path);
  if (sweep.allow_outside) text += " --allow-outside";
  for (const base::ParameterText& one : overrides_of(sweep, values)) {
    text += " --set " + base::shell_word(setting_text(one));
  }
  return text;
}

std::string number_section(const Sweep& sweep, const SweepSummary& summary,
                           const std::optional<SobolEstimate>& indices, std::size_t number) {
  const auto spread = summary.spread(number);
  std::string html =
      fmt::format("<section><h2>{}</h2>\n", escape_html(sweep.collected[number].name));
  if (spread.count == 0) return html + "<p>No sample has a value.</p></section>\n";
  if (spread.least == spread.most) {
    return html + fmt::format("<p>{} in every sample that has a value ({}).</p></section>\n",
                              digits(spread.least), spread.count);
  }
  html += fmt::format(
      "<p>Mean {}, standard deviation {}; 5 %, median and 95 %: {}, {}, {}; {} samples.</p>\n",
      digits(spread.mean), digits(spread.deviation), digits(spread.quantiles[0]),
      digits(spread.quantiles[1]), digits(spread.quantiles[2]), spread.count);
  html += "<div class=\"pair\"><figure>" + histogram(spread) +
          "<figcaption>How often; lines at 5 %, median, 95 % (within 1 %)</figcaption></figure>\n";
  const std::vector<Bar> bars = bars_of(sweep, summary, indices, number);
  if (!bars.empty()) {
    html += "<figure>" + tornado(bars, indices.has_value()) + "<figcaption>" +
            (indices ? "Parts of the variance (Sobol' indices): total, the dark part alone; 95 % "
                       "intervals of the total"
                     : "Correlation (Pearson's) with each parameter, -1 .. 1; 95 % intervals") +
            "</figcaption></figure>";
  }
  html += "</div>\n<table class=\"extremes\"><tbody>\n";
  for (const auto& [name, value, id] : {std::tuple{"least", spread.least, spread.least_id},
                                        std::tuple{"most", spread.most, spread.most_id}}) {
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td>sample {}</td><td><code>{}</code></td></tr>\n",
        name, digits(value), id, escape_html(command(sweep, id)));
  }
  return html + "</tbody></table></section>\n";
}

std::string generator(const Sweep& sweep) {
  return "<meta name=\"generator\" content=\"slipbench sweep " + escape_html(file_name(sweep)) +
         "\">";
}

}  // namespace

std::string sweep_page(const Sweep& sweep, const SweepSummary& summary,
                       const std::optional<SobolEstimate>& indices, const KeptSamples& kept) {
  const std::string title = escape_html(sweep.title);
  std::string html = "<!doctype html>\n";
  html += fmt::format(
      "<html lang=\"en\"><head><meta charset=\"utf-8\">\n{}\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'\">\n<link rel=\"icon\" "
      "href=\"data:,\">\n<title>{}</title>\n"
      "<style>\n{}</style></head>\n<body><main>\n<h1>{}</h1>\n",
      generator(sweep), title, report::page_part::sweep_css(), title);
  const std::string settings = settings_text(sweep);
  html += fmt::format("<p class=\"soft\">{} samples of {}{}, by slipbench {}: {}.</p>\n",
                      summary.samples(),
                      escape_html(std::filesystem::path(sweep.case_path).filename().string()),
                      settings.empty() ? "" : " with " + escape_html(settings),
                      results::program_version(), escape_html(file_name(sweep)));
  if (summary.failed() > 0) {
    html += "<p class=\"bad\">" + escape_html(summary.failure()) + "</p>\n";
  }
  for (std::size_t n = 0; n < sweep.collected.size(); ++n) {
    html += number_section(sweep, summary, indices, n);
  }
  return html + matrix(sweep, summary, kept) + "</main></body></html>\n";
}

base::FileMark sweep_page_mark(const Sweep& sweep) {
  return {"the page of " + file_name(sweep), "<!doctype html>\n", generator(sweep)};
}

}  // namespace slipbench::driver::sweep
