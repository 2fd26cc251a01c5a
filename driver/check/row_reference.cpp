// SPDX-License-Identifier: Apache-2.0
#include "driver/check/row_reference.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "driver/results/summary.hpp"
#include "reference/catalogue.hpp"

namespace slipbench::driver::check {

tl::expected<RowReference, std::string> RowReference::make(const cases::Case& problem,
                                                           std::span<const results::Column> columns,
                                                           const cases::Check& check) {
  RowReference result;
  const auto add = [&](const cases::ExpressionReference& text) -> tl::expected<void, std::string> {
    auto input = RowExpression::make(problem, columns, text.expression, text.variables);
    if (!input) return tl::unexpected(std::move(input.error()));
    result.inputs_.push_back(std::move(*input));
    return {};
  };
  if (const auto* expression = std::get_if<cases::ExpressionReference>(&check.against)) {
    if (auto added = add(*expression); !added) return tl::unexpected(std::move(added.error()));
    return result;
  }
  const auto& form = std::get<cases::ClosedFormReference>(check.against);
  const reference::ClosedForm* found = reference::find(form.name);
  if (found == nullptr) return tl::unexpected("there is no closed form '" + form.name + "'");
  for (const cases::ExpressionReference& input : form.inputs) {
    if (auto added = add(input); !added) return tl::unexpected(std::move(added.error()));
  }
  result.form_ = found->make(form.parameters);
  result.arguments_.resize(form.inputs.size());
  result.outputs_.resize(found->outputs.size());
  result.output_ = static_cast<std::size_t>(form.output);
  return result;
}

tl::expected<double, RowReference::Fault> RowReference::operator()(const bench::Row& row) {
  if (!form_) {
    auto value = inputs_.front()(row);
    if (value) return *value;
    return tl::unexpected(Fault{"the reference has no value: " + value.error().message});
  }
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const auto value = inputs_[i](row);
    if (!value) {
      return tl::unexpected(
          Fault{fmt::format("an input of the closed form, '{}', has no value: {} at t = {}",
                            inputs_[i].text(), value.error().message, base::rounded(row.time)),
                true});
    }
    arguments_[i] = *value;
  }
  form_(arguments_, outputs_);
  return outputs_[output_];
}

}  // namespace slipbench::driver::check
