// SPDX-License-Identifier: Apache-2.0
#include "law/friction/at_radius.hpp"

#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "law/friction/law_list.hpp"

namespace slipbench::law {
namespace {

/// A number of dimension T^t stands beside V^t, and V = w R; one of F^f of a law without an area
/// beside M^-f = (F R)^-f.
template <class Law>
void convert(Law& law, double radius) {
  constexpr bool kHasArea = requires { law.area; };
  const auto scale = [&](auto& number, const Dimension& dimension) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(number)>, double>) {
      number *= std::pow(radius, dimension.time + (kHasArea ? 0 : dimension.force));
    }
  };
  std::apply([&](const auto&... field) { (scale(law.*field.member, field.dimension), ...); },
             Law::fields());
  if constexpr (kHasArea) law.area = law.area.value_or(1.0) * radius;  // p = M/(R A)
}

/// The last piece hides a unit of speed in a pure number: the speed is converted on its way in.
void convert(Renard& law, double radius) { law.speed_factor *= radius; }

void convert(TabularCoefficient& law, double radius) {
  const int rate = law.table.column_of(IndependentKind::kSlipRate);
  const int force = law.table.column_of(IndependentKind::kContactForce);
  const Table& old = law.table.table();
  std::vector<std::vector<double>> rows(old.rows());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<double> point = old.point(i);
    if (rate >= 0) point[static_cast<std::size_t>(rate)] /= radius;
    if (force >= 0) point[static_cast<std::size_t>(force)] *= radius;
    rows[i].push_back(old.ordinate(i));
    rows[i].insert(rows[i].end(), point.begin(), point.end());
  }
  // Points that were ascending still are.
  Table table;
  TableError error;
  if (!Table::build(rows, 1, old.independents(), old.extrapolation(), &table, &error)) return;
  const auto independents = law.table.independents();
  law.table = TableFunction(std::move(table), {independents.begin(), independents.end()});
}

}  // namespace

FrictionLaw at_radius(FrictionLaw law, double radius) {
  visit_law([&](auto& one) { convert(one, radius); }, law);
  return law;
}

}  // namespace slipbench::law
