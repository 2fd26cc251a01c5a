// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include "driver/case/case_codecs.hpp"
#include "driver/case/resolve.hpp"
#include "driver/results/columns.hpp"
#include "driver/text/format_number.hpp"
#include "reference/catalogue.hpp"

namespace slipbench::driver {
namespace {

/// What a check's expressions may name: time in the step, total time, result columns.
std::vector<std::string> check_variables(const Case& problem) {
  std::vector<std::string> names{"t", "T"};
  for (std::string& name : column_names(problem)) {
    if (name != "t") names.push_back(std::move(name));
  }
  return names;
}

struct Compiled {
  Expression expression;
  std::vector<std::string> variables;  ///< only those it uses
};

std::optional<Compiled> compile(Binder& binder, const At<std::string>& text,
                                const std::vector<std::string>& variables) {
  auto first = binder.expression(*text.node, text.path, variables);
  if (!first) return std::nullopt;
  std::vector<std::string> used(first->used_variables().begin(), first->used_variables().end());
  auto again = binder.expression(*text.node, text.path, used);
  if (!again) return std::nullopt;
  return Compiled{std::move(*again), std::move(used)};
}

/// The result columns that carry what a closed form's signals are called.
struct Meaning {
  std::string_view signal;
  std::string_view prefix;  ///< of the column's name
};
constexpr std::array kOutputs{Meaning{"accumulated_slip", "CASU"},  Meaning{"dissipation", "DISS"},
                              Meaning{"stored_energy", "STRAIN_E"}, Meaning{"work", "WORK"},
                              Meaning{"normal_force", "FN"},        Meaning{"normal_force", "CNF"},
                              Meaning{"normal_force", "CNM"}};

int output_of(const reference::ClosedForm& form, std::string_view quantity, const Case& problem) {
  const auto index = [&](std::string_view name) {
    for (std::size_t i = 0; i < form.outputs.size(); ++i) {
      if (form.outputs[i].name == name) return static_cast<int>(i);
    }
    return -1;
  };
  while (!quantity.empty() && (quantity.front() == '=' || quantity.front() == ' ')) {
    quantity.remove_prefix(1);
  }
  for (const Meaning& meaning : kOutputs) {
    if (quantity.starts_with(meaning.prefix) && index(meaning.signal) >= 0) {
      return index(meaning.signal);
    }
  }
  // The components of a planar slider, in the order of the first coupled definition.
  for (const CaseDefinition& definition : problem.definitions) {
    for (int i = 0; i < definition.law.slip.dimension; ++i) {
      const int c = definition.law.slip.component[static_cast<std::size_t>(i)];
      const int output = index("force" + std::to_string(i + 1));
      if (quantity == force_column("CSF", c) && output >= 0) return output;
    }
    break;
  }
  if (const int force = index("force"); force >= 0 && quantity.starts_with("CSF")) return force;
  return 0;
}

/// The column that feeds an input of a closed form when the case does not say so.
std::optional<std::string> default_input(std::string_view signal, const Case& problem) {
  std::vector<int> free;
  for (int c = 0; c < law::kComponents; ++c) {
    if (problem.connection.info.available.contains(c)) free.push_back(c);
  }
  const auto motion = [&](std::size_t i) -> std::optional<std::string> {
    if (i >= free.size()) return std::nullopt;
    return "CU" + component_suffix(free[i]);
  };
  if (signal == "motion" || signal == "motion1") return motion(0);
  if (signal == "motion2") return motion(1);
  if (signal == "alpha") return "CPR1";
  if (signal == "beta") return "CPR2";
  if (signal == "normal_force") {
    return problem.definitions.size() > 1 ? "FN." + problem.definitions[0].name : "FN";
  }
  if (const auto c = component_of_force(signal)) return force_column("CRF", *c);
  return std::nullopt;
}

std::optional<ClosedFormReference> closed_form(Binder& binder, const AgainstText& text,
                                               std::string_view quantity, const Case& problem,
                                               const std::vector<std::string>& variables) {
  const reference::ClosedForm* form = reference::find(text.closed_form.value);
  if (form == nullptr) {
    std::vector<std::string_view> names;
    for (const auto& known : reference::catalogue()) names.push_back(known.name);
    std::string hint = "known: " + in_words(names, "and");
    if (const auto nearest = nearest_name(text.closed_form.value, names)) {
      hint = "did you mean '" + std::string(*nearest) + "'?";
    }
    binder.error(*text.closed_form.node, text.closed_form.path,
                 "unknown closed form '" + printable(text.closed_form.value) + "'",
                 std::move(hint));
    return std::nullopt;
  }
  ClosedFormReference result;
  result.name = std::string(form->name);
  bool good = true;
  const auto known_names = [](const auto& list) {
    std::vector<std::string_view> names;
    for (const auto& item : list) names.push_back(item.name);
    return names;
  };

  result.parameters.resize(form->parameters.size());
  for (std::size_t i = 0; i < form->parameters.size(); ++i) {
    if (const auto value = form->parameters[i].default_value) result.parameters[i] = {*value};
  }
  for (const Named<NumberOrList>& given : text.with) {
    const auto p =
        std::find_if(form->parameters.begin(), form->parameters.end(),
                     [&](const auto& parameter) { return parameter.name == given.name; });
    if (p == form->parameters.end()) {
      binder.unknown_key(*given.key, given.path, known_names(form->parameters));
      good = false;
      continue;
    }
    if (p->list != given.value.list) {
      binder.error(*given.key, given.path,
                   p->list ? "wanted a list of numbers" : "wanted one number");
      good = false;
      continue;
    }
    for (const double value : given.value.values) {
      good =
          binder.in_bounds(value, *given.key, given.path,
                           {.lower = p->lower, .upper = p->upper, .lower_open = p->lower_open}) &&
          good;
    }
    result.parameters[static_cast<std::size_t>(p - form->parameters.begin())] = given.value.values;
  }
  for (std::size_t i = 0; i < form->parameters.size(); ++i) {
    const auto& parameter = form->parameters[i];
    const bool given = std::any_of(text.with.begin(), text.with.end(),
                                   [&](const auto& w) { return w.name == parameter.name; });
    if (!given && !parameter.default_value) {
      binder.missing_key(*text.closed_form.node, text.closed_form.path, parameter.name,
                         "under 'with:': " + std::string(parameter.text));
      good = false;
    }
  }

  for (const reference::Signal& signal : form->inputs) {
    const Named<std::string>* given = nullptr;
    for (const auto& entry : text.inputs) {
      if (entry.name == signal.name) given = &entry;
    }
    const std::optional<std::string> column =
        given != nullptr ? std::optional(given->value) : default_input(signal.name, problem);
    const bool known =
        column && std::find(variables.begin(), variables.end(), *column) != variables.end();
    if (known) {
      result.inputs.push_back(*column);
    } else if (given != nullptr) {
      const std::vector<std::string_view> names(variables.begin(), variables.end());
      std::string hint;
      if (const auto nearest = nearest_name(*column, names)) {
        hint = "did you mean '" + std::string(*nearest) + "'?";
      }
      binder.error(*given->key, given->path, "no result column '" + printable(*column) + "'",
                   std::move(hint));
      good = false;
    } else if (component_of_force(signal.name) || signal.name == "beta") {
      // A plane SLOT has no f3, a straight joint no angle: the closed form then sees 0.
      result.inputs.emplace_back();
    } else {
      binder.error(*text.closed_form.node, text.closed_form.path,
                   "the closed form needs '" + std::string(signal.name) +
                       "': say which result column it is under 'inputs:'");
      good = false;
    }
  }
  for (const auto& entry : text.inputs) {
    const auto names = known_names(form->inputs);
    if (std::find(names.begin(), names.end(), entry.name) == names.end()) {
      binder.unknown_key(*entry.key, entry.path, names);
      good = false;
    }
  }

  result.output = output_of(*form, quantity, problem);
  if (text.output.given()) {
    const auto names = known_names(form->outputs);
    const auto found = std::find(names.begin(), names.end(), text.output.value);
    if (found == names.end()) {
      binder.error(*text.output.node, text.output.path,
                   "wanted " + in_words(names) + ", found '" + printable(text.output.value) + "'");
      good = false;
    } else {
      result.output = static_cast<int>(found - names.begin());
    }
  }
  if (good) {
    if (const auto broken = form->violation(result.parameters)) {
      binder.error(*text.closed_form.node, text.closed_form.path, *broken);
      good = false;
    }
  }
  if (!good) return std::nullopt;
  return result;
}

void read_check(Binder& binder, const At<CheckText>& at, const std::vector<std::string>& variables,
                Case& out) {
  const CheckText& text = at.value;
  bool good = true;
  auto quantity = compile(binder, text.quantity, variables);
  const AgainstText& against = text.against.value;
  std::optional<std::variant<ExpressionReference, ClosedFormReference>> reference;
  if (against.expression.given() == against.closed_form.given()) {
    binder.error(*text.against.node, text.against.path,
                 "needs 'expression' or 'closed_form', and only one of them");
  } else if (against.expression.given()) {
    if (auto compiled = compile(binder, against.expression, variables)) {
      reference = ExpressionReference{std::move(compiled->expression), compiled->variables};
    }
  } else if (auto form = closed_form(binder, against, text.quantity.value, out, variables)) {
    reference = std::move(*form);
  }
  if (against.expression.given() &&
      (!against.with.empty() || !against.inputs.empty() || against.output.given())) {
    binder.error(*text.against.node, text.against.path,
                 "'with', 'inputs' and 'output' belong to a closed form");
  }
  if (!text.tolerance.value.absolute && !text.tolerance.value.relative) {
    binder.error(*text.tolerance.node, text.tolerance.path,
                 "needs 'absolute' or 'relative', or both (the larger counts)");
    good = false;
  }
  if (text.step.given()) {
    const auto same = [&](const Step& step) { return step.name == text.step.value; };
    if (std::none_of(out.steps.begin(), out.steps.end(), same)) {
      std::vector<std::string_view> names;
      for (const Step& step : out.steps) names.push_back(step.name);
      std::string hint =
          names.empty() ? "a measured history has no steps" : "steps: " + in_words(names, "and");
      if (const auto nearest = nearest_name(text.step.value, names)) {
        hint = "did you mean '" + std::string(*nearest) + "'?";
      }
      binder.error(*text.step.node, text.step.path, "no step '" + printable(text.step.value) + "'",
                   std::move(hint));
      good = false;
    }
  }
  const OverText& over = text.over.value;
  if (over.from && over.to && !(*over.from <= *over.to)) {
    binder.error(*text.over.node, text.over.path, "'from' must not be after 'to'");
    good = false;
  }
  if (!good || !quantity || !reference) return;
  Check check{.name = text.name.value,
              .quantity = std::move(quantity->expression),
              .quantity_text = text.quantity.value,
              .variables = std::move(quantity->variables),
              .against = std::move(*reference),
              .step = text.step.given() ? std::optional(text.step.value) : std::nullopt,
              .from = over.from,
              .to = over.to,
              .tolerance = {text.tolerance.value.absolute, text.tolerance.value.relative,
                            text.tolerance.value.why},
              .where = at.node->where()};
  out.checks.push_back(std::move(check));
}

}  // namespace

void resolve_output_and_checks(Binder& binder, const CaseText& text, Case& out) {
  out.output_every = text.output.every;
  const std::vector<std::string> variables = check_variables(out);
  const auto all = result_columns(out);
  std::vector<std::string_view> columns;
  for (const Column& column : all) columns.push_back(column.name);
  for (const At<std::string>& column : text.output.columns.value) {
    if (std::find(columns.begin(), columns.end(), column.value) == columns.end()) {
      std::string hint = "known: " + in_words(columns, "and");
      if (const auto nearest = nearest_name(column.value, columns)) {
        hint = "did you mean '" + std::string(*nearest) + "'?";
      }
      binder.error(*column.node, column.path, "no result column '" + printable(column.value) + "'",
                   std::move(hint));
    } else {
      out.output_columns.push_back(column.value);
    }
  }
  for (const At<CheckText>& check : text.checks) read_check(binder, check, variables, out);
}

}  // namespace slipbench::driver
