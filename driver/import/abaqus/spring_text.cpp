// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "driver/import/abaqus/case_parts.hpp"
#include "driver/import/abaqus/profile_text.hpp"

namespace slipbench::driver::abaqus {

std::string CaseParts::spring_text(const Spring& spring, bool damper) {
  const char* const motion = damper ? "velocity" : "displacement";
  const char* const key = damper ? "coefficient" : "stiffness";
  if (!spring.component) return coupled_text(spring);
  std::vector<std::string> independents = ambient_columns({}, spring.fields);
  std::vector<Row> rows = spring.rows;
  std::string text = fmt::format("  - {{component: {}, ", *spring.component);
  if (spring.nonlinear) independents.insert(independents.begin(), motion);
  const std::string table_text = table({"force"}, independents, rows, "");
  if (!spring.nonlinear && table_text.front() == '{') {
    // A stiffness over temperature or fields: the straight line through both sides of 0.
    std::vector<Row> both;
    for (const Row& row : rows) {
      Row left = row;
      left.insert(left.begin() + 1, -1.0);
      left[0] = -row[0].value_or(0.0);
      Row right = row;
      right.insert(right.begin() + 1, 1.0);
      both.push_back(left);
      both.push_back(right);
    }
    independents.insert(independents.begin(), motion);
    const std::string line = table({"force"}, independents, both, "linear");
    return text + line.substr(1) + "\n";
  }
  if (table_text.front() == '{') return text + table_text.substr(1) + "\n";
  if (spring.nonlinear)
    pass("a nonlinear spring has a single row (" + deck_.place(spring.where) + ")");
  return text + fmt::format("{}: {}}}\n", key, table_text);
}

std::string CaseParts::coupled_text(const Spring& spring) {
  const std::string place = deck_.place(spring.where);
  if (spring.nonlinear || spring.rows.size() != 1) {
    pass("a coupled spring that is nonlinear or has several rows is not modelled (" + place + ")");
  }
  std::array<std::array<double, 6>, 6> matrix{};
  std::size_t at = 0;
  for (std::size_t column = 0; column < 6; ++column) {
    for (std::size_t row = 0; row <= column; ++row, ++at) {
      const double value = at < spring.rows[0].size() ? spring.rows[0][at].value_or(0.0) : 0.0;
      matrix[row][column] = matrix[column][row] = value;
    }
  }
  std::vector<std::string> components;
  std::vector<std::string> lines;
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < 6; ++i) {
    const bool any =
        std::any_of(matrix[i].begin(), matrix[i].end(), [](double k) { return k != 0.0; });
    if (any) used.push_back(i);
  }
  for (const std::size_t i : used) {
    std::vector<std::string> numbers;
    numbers.reserve(used.size());
    for (const std::size_t k : used) numbers.push_back(number_text(matrix[i][k]));
    components.push_back(std::to_string(i + 1));
    lines.push_back("[" + join(numbers) + "]");
  }
  if (used.size() == 1) {
    return fmt::format("  - {{component: {}, stiffness: {}}}\n", components[0],
                       number_text(matrix[used[0]][used[0]]));
  }
  return fmt::format("  - {{components: [{}], stiffness: [{}]}}\n", join(components), join(lines));
}

std::string CaseParts::springs_text() {
  const Behavior& behavior = *connector_.behavior;
  std::string text;
  if (behavior.linear_extrapolation) text += "extrapolation: linear\n";
  if (!behavior.elasticity.empty()) text += "elasticity:\n";
  for (const Spring& one : behavior.elasticity) text += spring_text(one, false);
  if (!behavior.damping.empty()) text += "damping:\n";
  for (const Spring& one : behavior.damping) {
    if (!one.component) pass("a coupled damper is not modelled (" + deck_.place(one.where) + ")");
    text += spring_text(one, true);
  }
  if (!behavior.stops.empty()) text += "stops:\n";
  for (const Stop& stop : behavior.stops) {
    std::vector<std::string> entries{"component: " + std::to_string(stop.component)};
    if (stop.lower) entries.push_back("lower: " + number_text(*stop.lower));
    if (stop.upper) entries.push_back("upper: " + number_text(*stop.upper));
    text += "  - {" + join(entries) + "}\n";
  }
  return text;
}

}  // namespace slipbench::driver::abaqus
