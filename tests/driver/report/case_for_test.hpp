// SPDX-License-Identifier: Apache-2.0
// A case to report on, and the document of a page taken apart again.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/check/check.hpp"
#include "driver/read/read_case.hpp"
#include "driver/report/collect.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver::report {

/// A slider of 20 N (mu N) on a stick stiffness of 1000 N/mm, to and fro by 0.1 mm: it slips from
/// 0.02 mm on, and after the turn at t = 1 from 0.06 mm on. `mu` is what its check expects.
inline std::string slider_text(const std::string& mu, int increments = 10) {
  const std::string n = std::to_string(increments);
  return "slipbench: 1\n"
         "title: Slider\n"
         "units: {length: mm, force: N, time: s}\n"
         "parameters: {mu: 0.2}\n"
         "connector: {type: SLOT}\n"
         "friction:\n"
         "  - predefined: {}\n"
         "    name: sleeve\n"
         "    coefficient: = mu\n"
         "    stick: {stiffness: 1000}\n"
         "history:\n"
         "  - {step: out, duration: 1, increments: " +
         n +
         ", motion: {CP1: {to: 0.1}}, force: {f2: 100}}\n"
         "  - {step: back, duration: 1, increments: " +
         n +
         ", motion: {CP1: {to: 0}}}\n"
         "checks:\n"
         "  - name: limit\n"
         "    quantity: FLIM\n"
         "    against: {expression: \"= 100*" +
         mu +
         "\"}\n"
         "    tolerance: {absolute: 0.5, why: a guess}\n";
}

inline cases::Case read_text(const std::string& text) {
  read::ReadCase read = read::read_case_text(base::SourceText("case.yaml", text), ".");
  if (!read.value || read.diagnostics.has_errors()) {
    throw std::runtime_error(base::render(read.diagnostics, read.sources));
  }
  return std::move(*read.value);
}

inline cases::Case read_slider(const std::string& mu, int increments = 10) {
  return read_text(slider_text(mu, increments));
}

/// The slider in cycles of a second, so many increments each: +-0.1 mm, four events a cycle. Its
/// check is off in one row of the 40th cycle only, by 3 N where the tolerance is 0.5 N.
inline std::string cycles_text(int cycles, int increments) {
  const std::string n = std::to_string(cycles);
  const std::string all = std::to_string(cycles * increments);
  const std::string width = std::to_string(1.0 / increments);
  return "slipbench: 1\n"
         "units: {length: mm, force: N, time: s}\n"
         "connector: {type: SLOT}\n"
         "friction:\n"
         "  - predefined: {}\n"
         "    coefficient: 0.2\n"
         "    stick: {stiffness: 1000}\n"
         "history:\n"
         "  - {step: run, duration: " +
         n + ", increments: " + all +
         ", motion: {CP1: {sine: {amplitude: 0.1, frequency: 1}}}, force: {f2: 100}}\n"
         "checks:\n"
         "  - name: spike\n"
         "    quantity: FLIM\n"
         "    against: {expression: \"20 + 3*max(0, 1 - abs(T - 39.37)/" +
         width +
         ")\"}\n"
         "    tolerance: {absolute: 0.5, why: a guess}\n";
}

inline cases::Case read_cycles(int cycles, int increments) {
  return read_text(cycles_text(cycles, increments));
}

/// The report of a case, run as the commands run it.
inline CaseReport report_of(const cases::Case& problem, const std::string& name = "case",
                            std::size_t most_rows = kMostRows) {
  CaseCollector collector(problem, most_rows);
  std::vector<check::CheckProgress> checks;
  for (const cases::Check& check : problem.checks)
    checks.emplace_back(problem, check, check::Trace::kKeep);
  auto simulation = bench::Simulation::start(problem);
  if (!simulation) throw std::runtime_error(simulation.error().message);
  while (true) {
    collector.add(simulation->row());
    for (check::CheckProgress& check : checks) check.add(simulation->row());
    const auto more = simulation->advance();
    if (!more) throw std::runtime_error(more.error().message);
    if (!*more) break;
  }
  return collector.finish(name, checks, simulation->jumps());
}

/// The numbers of a packed series, as a page unpacks them.
inline std::vector<double> unpacked(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int known = 0;
  for (const char digit : text) {
    static const std::string kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t place = kDigits.find(digit);
    if (place == std::string::npos) continue;
    bits = bits << 6 | static_cast<std::uint32_t>(place);
    known += 6;
    if (known < 8) continue;
    known -= 8;
    bytes += static_cast<char>(bits >> known & 255U);
  }
  std::size_t at = 0;
  const auto next = [&] {
    double number = 0.0;
    for (double unit = 1.0;; unit *= 128.0) {
      const auto byte = static_cast<unsigned char>(bytes.at(at++));
      number += unit * (byte & 127U);
      if (byte < 128) return number;
    }
  };
  const auto unfold = [](double n) {
    return std::fmod(n, 2.0) == 1.0 ? -(n + 1.0) / 2.0 : n / 2.0;
  };
  std::vector<double> numbers;
  double decimals = 0.0;
  double k[2] = {0.0, 0.0};
  double value[2] = {0.0, 0.0};
  const auto power = [&] {
    return std::stod("1e" + std::to_string(std::lround(std::abs(decimals))));
  };
  const auto put = [&](double off) {
    const double here = 2.0 * k[0] - k[1] + off;
    k[1] = std::exchange(k[0], here);
    value[1] = std::exchange(value[0], decimals < 0.0 ? here * power() : here / power());
    numbers.push_back(value[0]);
  };
  for (std::size_t begun = 1; at < bytes.size();) {
    if (numbers.size() % 64 == 0 && begun != numbers.size()) {
      begun = numbers.size();
      const double change = unfold(next());
      decimals += change;
      for (int i = 0; i < 2 && change != 0.0; ++i) {
        const double units = decimals < 0.0 ? value[i] / power() : value[i] * power();
        k[i] = std::abs(units) < 1e15 ? std::floor(units + 0.5) : 0.0;
      }
    }
    const double token = next();
    if (token == 0.0) {
      for (double count = next(); count > 0.0; --count) put(0.0);
    } else if (token == 1.0) {
      numbers.push_back(std::numeric_limits<double>::quiet_NaN());
    } else {
      put(unfold(token - 1.0));
    }
  }
  return numbers;
}

/// A document as a tree: JSON is YAML.
inline yaml::Tree tree_of(const std::string& document) {
  auto tree = yaml::parse_yaml(base::SourceText("page.json", document));
  if (!tree) throw std::runtime_error("no JSON: " + document);
  return std::move(*tree);
}

/// The number of a column in a row of a report.
inline double number_at(const CaseReport& report, std::size_t row, const std::string& column) {
  for (std::size_t c = 0; c < report.columns.size(); ++c) {
    if (report.columns[c].name == column)
      return report.drawn.rows.numbers[row * report.columns.size() + c];
  }
  throw std::runtime_error("no column " + column);
}

}  // namespace slipbench::driver::report
