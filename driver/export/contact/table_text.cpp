// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdlib>
#include <sstream>
#include <utility>
#include <vector>

#include "driver/export/coefficient_grid.hpp"
#include "driver/export/contact/contact_block.hpp"
#include "driver/export/number_writer.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::exports {

std::string to_table(const FrictionStatement& statement, const ExportOptions& options,
                     ExportedDeck& deck) {
  if (!statement.pairs.empty() || statement.otherwise.second) {
    throw NotExported{
        "a table has one coefficient: its friction has pairs of parts, or directions"};
  }
  NumberWriter number(25, options.digits);
  const CoefficientGrid grid = tabulate(statement.otherwise.law, statement.run);
  const bool limited = statement.otherwise.force_limit < law::kNoForceLimit;
  const bool over_force = grid.forces.size() > 1;
  std::string text = over_force ? "mu,slip_rate,contact_force\n" : "mu,slip_rate\n";
  for (std::size_t j = 0; j < grid.forces.size(); ++j) {
    for (std::size_t i = 0; i < grid.rates.size(); ++i) {
      text += number(grid.mu[j][i]) + "," + number(grid.rates[i]) +
              (over_force ? "," + number(grid.forces[j]) : std::string()) + "\n";
    }
  }
  const auto note = [&](Loss::Kind kind, std::string what) {
    deck.losses.push_back({kind, std::move(what)});
  };
  note(grid.error > 0.0 ? Loss::Kind::kApproximated : Loss::Kind::kKept,
       fmt::format("coefficient: {} points over slip rate and contact force, off by at most {:.1e} "
                   "between them, constant outside",
                   grid.rates.size() * grid.forces.size(), grid.error));
  tell_rounding(number.rounded(), number.worst(), deck.losses);
  if (limited) note(Loss::Kind::kDropped, "force_limit: a table has none");
  note(Loss::Kind::kDropped, "stick stiffness");
  law_of_table(text);  // slip rates next to the smallest or largest number make none
  return text;
}

law::FrictionLaw law_of_table(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  std::vector<law::Independent> independents = {{law::IndependentKind::kSlipRate, 0}};
  if (line.find("contact_force") != std::string::npos) {
    independents.push_back({law::IndependentKind::kContactForce, 0});
  }
  for (std::string row_text; std::getline(lines, row_text);) {
    std::istringstream items(row_text);
    std::vector<double>& row = rows.emplace_back();
    for (std::string item; std::getline(items, item, ',');) {
      row.push_back(std::strtod(item.c_str(), nullptr));
    }
  }
  law::Table table;
  law::TableError error;
  if (!law::Table::build(rows, 1, static_cast<int>(independents.size()),
                         law::Extrapolation::kConstant, &table, &error)) {
    throw NotExported{"its coefficient makes no table"};
  }
  return law::TabularCoefficient{law::TableFunction(std::move(table), std::move(independents))};
}

}  // namespace slipbench::driver::exports
