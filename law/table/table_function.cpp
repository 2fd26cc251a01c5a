// SPDX-License-Identifier: Apache-2.0
#include "law/table/table_function.hpp"

namespace slipbench::law {
namespace {

bool is_motion(IndependentKind kind) {
  return kind == IndependentKind::kPosition || kind == IndependentKind::kConstitutiveMotion;
}

void set_slope(IndependentKind kind, double slope, SlipArguments* slopes) noexcept {
  switch (kind) {
    case IndependentKind::kSlipRate:
      slopes->slip_rate = slope;
      break;
    case IndependentKind::kContactForce:
      slopes->contact_force = slope;
      break;
    case IndependentKind::kAccumulatedSlip:
      slopes->accumulated_slip = slope;
      break;
    default:
      break;
  }
}

}  // namespace

TableFunction::TableFunction(Table table, std::vector<Independent> independents)
    : table_(std::move(table)), independents_(std::move(independents)) {
  for (const Independent& independent : independents_) {
    depends_on_motion_ = depends_on_motion_ || is_motion(independent.kind);
  }
}

int TableFunction::column_of(IndependentKind kind) const {
  for (std::size_t k = 0; k < independents_.size(); ++k) {
    if (independents_[k].kind == kind) return static_cast<int>(k);
  }
  return -1;
}

double TableFunction::value_and_slopes(const Ambient& ambient, const SlipArguments& slip,
                                       SlipArguments* slopes, int column) const noexcept {
  *slopes = {};
  if (independents_.size() == 1) {  // most tables have one, and need no lists
    const double x = argument(independents_[0], ambient, slip);
    double dx = 0.0;
    const double result = table_.value_and_slopes({&x, 1}, {&dx, 1}, column);
    set_slope(independents_[0].kind, dx, slopes);
    return result;
  }
  Arguments x;
  Arguments dx;
  const auto arguments = gather(ambient, slip, &x);
  for (std::size_t k = 0; k < arguments.size(); ++k) dx[k] = 0.0;
  const double result = table_.value_and_slopes(arguments, {dx.data(), arguments.size()}, column);
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    set_slope(independents_[k].kind, dx[k], slopes);
  }
  return result;
}

void TableFunction::add_motion_slopes(const Ambient& ambient, const SlipArguments& slip,
                                      double weight, RelativePosition* gradient,
                                      int column) const noexcept {
  if (!depends_on_motion_) return;
  Arguments x;
  Arguments dx;
  const auto arguments = gather(ambient, slip, &x);
  for (std::size_t k = 0; k < arguments.size(); ++k) dx[k] = 0.0;
  table_.value_and_slopes(arguments, {dx.data(), arguments.size()}, column, weight);
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    if (is_motion(independents_[k].kind)) (*gradient)[independents_[k].index] += dx[k];
  }
}

std::array<double, kMaxIndependents> TableFunction::arguments(
    const Ambient& ambient, const SlipArguments& slip) const noexcept {
  Arguments x{};
  gather(ambient, slip, &x);
  return x;
}

TableCell TableFunction::cell(const Ambient& ambient, const SlipArguments& slip) const noexcept {
  Arguments x;
  return table_.cell(gather(ambient, slip, &x));
}

bool TableFunction::outside(const Ambient& ambient, const SlipArguments& slip) const noexcept {
  Arguments x;
  return table_.outside(gather(ambient, slip, &x));
}

}  // namespace slipbench::law
