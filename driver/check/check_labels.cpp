// SPDX-License-Identifier: Apache-2.0
#include "driver/check/check_labels.hpp"

#include <optional>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/check/row_values.hpp"
#include "driver/results/columns.hpp"
#include "driver/results/summary.hpp"

namespace slipbench::driver::check {
namespace {

std::string product_text(const base::Dimension& quantity, const base::Dimension& abscissa,
                         const base::UnitSystem& units) {
  base::Dimension product{quantity.force + abscissa.force, quantity.length + abscissa.length,
                          quantity.time + abscissa.time,
                          quantity.temperature + abscissa.temperature,
                          quantity.angle + abscissa.angle};
  // A moment's work over an angle is an energy, too.
  base::Dimension without_angle = product;
  without_angle.angle = 0;
  if (without_angle == base::kMoment) return base::energy_unit(units);
  return base::unit_text(product, units);
}

}  // namespace

CheckLabels labels_of(const cases::Case& problem, const cases::Check& check) {
  const std::vector<results::Column> columns = results::result_columns(problem);
  const auto dimension_of = [&](const std::string& name) -> std::optional<base::Dimension> {
    const auto column = results::find_column(problem, columns, name);
    if (!column) return std::nullopt;
    return column->dimension;
  };
  CheckLabels labels;
  labels.time_unit = problem.units.time;
  if (const auto definition = friction_of(problem, columns, check)) {
    labels.stiffness_follows_limit =
        problem.definitions[*definition].law.stick.mode == law::StickStiffness::Mode::kElasticSlip;
  }
  const auto quantity = dimension_of(check.quantity_text);
  if (quantity) labels.unit = base::unit_text(*quantity, problem.units);
  std::optional<base::Dimension> abscissa = base::kTime;
  labels.abscissa = "t";
  if (check.abscissa) {
    labels.abscissa = base::printable(check.abscissa_text);
    abscissa = dimension_of(check.abscissa->expression.text());
  }
  if (abscissa) labels.abscissa_unit = base::unit_text(*abscissa, problem.units);
  if (quantity && abscissa) {
    labels.product_unit = product_text(*quantity, *abscissa, problem.units);
  }
  return labels;
}

}  // namespace slipbench::driver::check
