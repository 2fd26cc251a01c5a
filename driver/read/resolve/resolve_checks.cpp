// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "driver/base/text/format_number.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/case/quantity.hpp"
#include "driver/check/curves/curve_series.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/keys/key_index.hpp"
#include "driver/read/resolve/resolve.hpp"
#include "driver/read/resolve/resolve_curve.hpp"
#include "driver/read/resolve/resolve_expression.hpp"
#include "driver/results/columns.hpp"
#include "reference/catalogue.hpp"

namespace slipbench::driver::read {
namespace {

/// Returns what a check's expressions may name: time in the step, total time, result columns.
std::vector<std::string> check_variables(const cases::Case& problem) {
  std::vector<std::string> names{"t", "T"};
  for (std::string& name : results::column_names(problem)) {
    if (name != "t") names.push_back(std::move(name));
  }
  return names;
}

/// The hint for a name that is no result column of this case.
std::string column_hint(const yaml::Binder& binder, std::string_view name,
                        std::span<const std::string_view> columns, std::string otherwise) {
  std::string origin = origin_of_column(name);
  return origin.empty() ? binder.nearest_or(name, columns, std::move(otherwise)) : origin;
}

/// The result columns that carry what a closed form's signals are called.
struct Meaning {
  std::string_view signal;
  std::string_view column;  ///< or how its name begins
};
constexpr std::array kInputs{
    Meaning{"time", "T"}, Meaning{"alpha", "CPR1"}, Meaning{"beta", "CPR2"}, Meaning{"mu", "MU"},
    Meaning{"velocity", "CV1"}, Meaning{"rotation_rate", "CVR1"},
    // of a belt
    Meaning{"distance", "CP1"}, Meaning{"flow", "CP2"}, Meaning{"flow_b", "CP2"},
    Meaning{"flow_a", "CP3"}, Meaning{"tension", "CTF1"}, Meaning{"tension_ab", "CTF1"},
    Meaning{"tension_bc", "f_bc"}, Meaning{"wrap_angle", "wrap_angle"}};
constexpr std::array kOutputs{Meaning{"accumulated_slip", "CASU"},  Meaning{"dissipation", "DISS"},
                              Meaning{"stored_energy", "STRAIN_E"}, Meaning{"work", "WORK"},
                              Meaning{"normal_force", "FN"},        Meaning{"normal_force", "CNF"},
                              Meaning{"normal_force", "CNM"}};

int output_of(const reference::ClosedForm& form, std::string_view quantity,
              const cases::Case& problem) {
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
    if (quantity.starts_with(meaning.column) && index(meaning.signal) >= 0) {
      return index(meaning.signal);
    }
  }
  // The components of a planar slider, in the order of the first coupled definition.
  for (const cases::CaseDefinition& definition : problem.definitions) {
    for (int i = 0; i < definition.law.slip.dimension; ++i) {
      const int c = definition.law.slip.component[static_cast<std::size_t>(i)];
      const int output = index("force" + std::to_string(i + 1));
      if (quantity == cases::force_column("CSF", c) && output >= 0) return output;
    }
    break;
  }
  if (const int force = index("force"); force >= 0 && quantity.starts_with("CSF")) return force;
  return 0;
}

/// The column that feeds an input of a closed form when the case does not say so.
std::optional<std::string> default_input(std::string_view signal, const cases::Case& problem) {
  std::vector<int> free;
  for (int c = 0; c < law::kComponents; ++c) {
    if (problem.connection.info.available.contains(c)) free.push_back(c);
  }
  const auto motion = [&](std::size_t i) -> std::optional<std::string> {
    if (i >= free.size()) return std::nullopt;
    return "CU" + cases::component_suffix(free[i]);
  };
  if (signal == "motion" || signal == "motion1") return motion(0);
  if (signal == "motion2") return motion(1);
  for (const Meaning& meaning : kInputs) {
    if (meaning.signal == signal) return std::string(meaning.column);
  }
  if (signal == "normal_force") {
    return problem.definitions.size() > 1 ? "FN." + problem.definitions[0].name : "FN";
  }
  if (const auto c = cases::component_of_force(signal)) return cases::force_column("CRF", *c);
  return std::nullopt;
}

/// Returns what drives one input of a closed form: the column or the expression that the case
/// names, else the column of the same meaning. Nothing after reporting an error.
std::optional<cases::ExpressionReference> input_of(yaml::Binder& binder, const AgainstText& text,
                                                   const reference::Signal& signal,
                                                   const cases::Case& problem,
                                                   const std::vector<std::string>& variables) {
  const auto is_column = [&](const std::string& name) {
    return std::find(variables.begin(), variables.end(), name) != variables.end();
  };
  const auto given = std::find_if(text.inputs.begin(), text.inputs.end(),
                                  [&](const auto& entry) { return entry.name == signal.name; });
  if (given == text.inputs.end()) {
    const std::optional<std::string> column = default_input(signal.name, problem);
    if (column && is_column(*column)) return plain_expression(*column, {*column});
    if (binder.unknown_names_excused()) return std::nullopt;
    // A plane SLOT has no f3, a straight joint no angle: the closed form then sees 0.
    if (cases::component_of_force(signal.name) || signal.name == "beta")
      return plain_expression("0", {});
    binder.error(*text.closed_form.node, text.closed_form.path,
                 "the closed form needs '" + std::string(signal.name) +
                     "': say which result column or expression it is under 'inputs:'");
    return std::nullopt;
  }
  if (!given->sound) return std::nullopt;
  if (yaml::Binder::is_expression(*given->node))
    return compile_expression(binder, *given, variables);
  if (is_column(given->value)) return plain_expression(given->value, {given->value});
  if (!binder.unknown_names_excused()) {
    const std::vector<std::string_view> names(variables.begin(), variables.end());
    binder.error(*given->node, given->path,
                 "no result column '" + base::printable(given->value) + "'",
                 column_hint(binder, given->value, names,
                             "an expression begins with '='; known: " + base::few_in_words(names)));
  }
  return std::nullopt;
}

std::optional<cases::ClosedFormReference> closed_form(yaml::Binder& binder, const AgainstText& text,
                                                      std::string_view quantity,
                                                      const cases::Case& problem,
                                                      const std::vector<std::string>& variables) {
  const reference::ClosedForm* form = reference::find(text.closed_form.value);
  if (form == nullptr) {
    std::vector<std::string_view> names;
    for (const auto& known : reference::catalogue()) names.push_back(known.name);
    binder.error(*text.closed_form.node, text.closed_form.path,
                 "unknown closed form '" + base::printable(text.closed_form.value) + "'",
                 base::did_you_mean(text.closed_form.value, names,
                                    "'slipbench list closed-forms' shows all"));
    return std::nullopt;
  }
  cases::ClosedFormReference result;
  result.name = std::string(form->name);
  bool good = !text.with.faulty();
  std::vector<std::string_view> misspelt;
  const auto known_names = [](const auto& list) {
    std::vector<std::string_view> names;
    for (const auto& item : list) names.push_back(item.name);
    return names;
  };

  result.parameters.resize(form->parameters.size());
  for (std::size_t i = 0; i < form->parameters.size(); ++i) {
    if (const auto value = form->parameters[i].default_value) result.parameters[i] = {*value};
  }
  for (const yaml::Named<NumberOrList>& given : text.with.value) {
    const auto p =
        std::find_if(form->parameters.begin(), form->parameters.end(),
                     [&](const auto& parameter) { return parameter.name == given.name; });
    if (p == form->parameters.end()) {
      const auto meant = binder.unknown_key(*given.key, given.path, known_names(form->parameters));
      if (meant) misspelt.push_back(*meant);
      good = false;
      continue;
    }
    if (!given.sound) continue;
    if (p->list != given.value.list) {
      binder.error(
          *given.node, given.path,
          p->list ? "wanted a list of numbers, found a number" : "wanted a number, found a list");
      good = false;
      continue;
    }
    // Each is gone through in every row.
    constexpr std::size_t kMostEntries = 1000;
    if (!binder.few_enough(*given.node, given.path, kMostEntries)) {
      good = false;
      continue;
    }
    for (const double value : given.value.values) {
      good =
          binder.in_bounds(value, *given.node, given.path,
                           {.lower = p->lower, .upper = p->upper, .lower_open = p->lower_open}) &&
          good;
    }
    result.parameters[static_cast<std::size_t>(p - form->parameters.begin())] = given.value.values;
  }
  for (std::size_t i = 0; i < form->parameters.size(); ++i) {
    const auto& parameter = form->parameters[i];
    const bool given = std::any_of(text.with.value.begin(), text.with.value.end(),
                                   [&](const auto& w) { return w.name == parameter.name; });
    if (given || parameter.default_value) continue;
    good = false;
    if (std::find(misspelt.begin(), misspelt.end(), parameter.name) != misspelt.end()) continue;
    if (text.with.given() && text.with.node->is_map()) {
      binder.missing_key(*text.with.node, text.with.path, parameter.name, parameter.text);
    } else if (!text.with.given()) {
      binder.missing_key(*text.closed_form.node, text.closed_form.path, parameter.name,
                         "under 'with:': " + std::string(parameter.text));
    }
  }

  misspelt.clear();
  for (const auto& entry : text.inputs) {
    const auto names = known_names(form->inputs);
    if (std::find(names.begin(), names.end(), entry.name) != names.end()) continue;
    if (const auto meant = binder.unknown_key(*entry.key, entry.path, names)) {
      misspelt.push_back(*meant);
    }
    good = false;
  }
  for (const reference::Signal& signal : form->inputs) {
    const bool given = std::any_of(text.inputs.begin(), text.inputs.end(),
                                   [&](const auto& entry) { return entry.name == signal.name; });
    if (!given && std::find(misspelt.begin(), misspelt.end(), signal.name) != misspelt.end()) {
      continue;
    }
    auto input = input_of(binder, text, signal, problem, variables);
    if (input) {
      result.inputs.push_back(std::move(*input));
    } else {
      good = false;
    }
  }
  result.output = output_of(*form, quantity, problem);
  if (text.output.faulty()) good = false;
  if (text.output.sound) {
    const auto names = known_names(form->outputs);
    const auto found = std::find(names.begin(), names.end(), text.output.value);
    if (found == names.end()) {
      binder.error(*text.output.node, text.output.path,
                   "wanted " + base::in_words(names) + ", found '" +
                       base::printable(text.output.value) + "'",
                   binder.nearest_or(text.output.value, names, ""));
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

std::optional<double> number(const yaml::At<double>& at) {
  return at.sound ? std::optional(at.value) : std::nullopt;
}

/// The names of the steps, as far as the history was understood.
struct StepNames {
  std::vector<std::string_view> names;
  bool known = true;
};

StepNames step_names(const CaseText& text) {
  const HistoryText& history = text.history.value;
  StepNames result;
  result.known = text.history.sound || !history.steps.empty();
  for (const yaml::At<StepText>& step : history.steps) {
    if (step.value.step.sound) result.names.push_back(step.value.step.value);
    result.known = result.known && step.value.step.sound;
  }
  return result;
}

/// Checks which of the three a quantity is held against; reports what does not go together.
/// \return whether it is one, and what stands beside it belongs to it
bool one_reference(yaml::Binder& binder, const yaml::At<AgainstText>& at) {
  if (!at.given() || !at.node->is_map()) return false;
  const AgainstText& against = at.value;
  std::vector<std::string_view> given;
  if (against.expression.given()) given.push_back("'expression'");
  if (against.closed_form.given()) given.push_back("'closed_form'");
  if (against.curve.given()) given.push_back("'curve'");
  if (given.size() > 1) {
    binder.error(*at.node, at.path,
                 "has " + base::in_words(given, "and") + ", a check takes one of them");
    return false;
  }
  if (given.empty()) {
    if (!yaml::has_unknown_key<AgainstText>(*at.node)) {
      binder.error(*at.node, at.path, "needs 'expression', 'closed_form' or 'curve'");
    }
    return false;
  }
  bool good = true;
  if (!against.closed_form.given() &&
      (against.with.given() || !against.inputs.empty() || against.output.given())) {
    binder.error(*at.node, at.path, "'with', 'inputs' and 'output' belong to a closed form");
    good = false;
  }
  if (!against.curve.given() && (against.abscissa.given() || against.column.given())) {
    binder.error(*at.node, at.path, "'abscissa' and 'column' belong to a curve",
                 against.abscissa.given()
                     ? "what a check is compared over is its own 'abscissa', beside 'against'"
                     : "");
    good = false;
  }
  return good;
}

bool judge_tolerance(yaml::Binder& binder, const CheckText& text) {
  const ToleranceText& tolerance = text.tolerance.value;
  if (!text.tolerance.given() || !text.tolerance.node->is_map()) return false;
  bool good = true;
  const check::CriterionInfo& criterion = check::info_of(text.criterion.value);
  if (tolerance.abscissa.given() && !criterion.compares_positions && !text.criterion.faulty()) {
    binder.error(
        *tolerance.abscissa.node, tolerance.abscissa.path,
        std::string(criterion.word) + " compares no positions; breakaway and reversals do");
    good = false;
  } else if (!tolerance.absolute.given() && !tolerance.relative.given() &&
             !tolerance.abscissa.given() &&
             !yaml::has_unknown_key<ToleranceText>(*text.tolerance.node)) {
    binder.error(*text.tolerance.node, text.tolerance.path,
                 "needs 'absolute' or 'relative', or both (the larger counts)");
    good = false;
  }
  if (text.criterion.sound && text.criterion.value == cases::Criterion::kIso18571) {
    for (const yaml::At<double>* bound : {&tolerance.absolute, &tolerance.relative}) {
      if (!bound->sound || bound->value < 1.0) continue;
      binder.error(*bound->node, bound->path,
                   "wanted less than 1, found " + base::format_number(bound->value) +
                       ": iso18571 compares one minus the rating, which no curve can exceed");
      good = false;
    }
  }
  return good;
}

/// A loop has no meaning over time.
bool judge_criterion(yaml::Binder& binder, const CheckText& text, const AbscissaChoice& abscissa,
                     const cases::Case& problem) {
  const check::CriterionInfo& criterion = check::info_of(text.criterion.value);
  if (!text.criterion.sound || abscissa.value || !criterion.needs_position) return true;
  const auto motion = default_input("motion", problem);
  binder.error(
      *text.criterion.node, text.criterion.path,
      std::string(criterion.word) + " needs a position to go over, not time",
      "say which under 'abscissa' of the check, as in 'abscissa: " + motion.value_or("CU1") + "'");
  return false;
}

/// A formula without '=' and blanks.
std::string formula_of(std::string_view text) {
  std::string formula;
  for (const char c : text.substr(text.starts_with('=') ? 1 : 0)) {
    if (c != ' ') formula += c;
  }
  return formula;
}

void read_check(yaml::Binder& binder, const yaml::At<CheckText>& at,
                const std::vector<std::string>& variables, const StepNames& steps,
                bool curves_may_be_missing, OpenCurve& open, cases::Case& out) {
  const CheckText& text = at.value;
  bool good = at.sound;
  auto quantity = compile_expression(binder, text.quantity, variables);
  if (quantity && quantity->variables.empty()) {
    binder.error(*text.quantity.node, text.quantity.path,
                 "names nothing of the result: this check would compare two constants");
    good = false;
  }
  const yaml::At<std::string>& own = text.against.value.expression;
  if (quantity && own.sound && formula_of(own.value) == formula_of(text.quantity.value)) {
    binder.error(*own.node, own.path, "is the quantity: this check would compare it with itself");
    good = false;
  }
  auto abscissa = read_abscissa(binder, text, variables, out);
  if (abscissa) good = judge_criterion(binder, text, *abscissa, out) && good;
  const AgainstText& against = text.against.value;
  std::optional<decltype(cases::Check::against)> reference;
  if (!one_reference(binder, text.against) ||
      (against.closed_form.given() && !against.closed_form.sound)) {
    good = false;
  } else if (against.expression.given()) {
    if (auto compiled = compile_expression(binder, against.expression, variables)) {
      reference = std::move(*compiled);
    }
  } else if (against.curve.given()) {
    auto curve = abscissa ? read_curve(binder, text, *abscissa, out, curves_may_be_missing, open)
                          : std::nullopt;
    if (curve) reference = std::move(*curve);
  } else if (auto form = closed_form(binder, against, text.quantity.value, out, variables)) {
    reference = std::move(*form);
  }
  good = judge_tolerance(binder, text) && good;
  if (text.step.sound && steps.known &&
      std::find(steps.names.begin(), steps.names.end(), text.step.value) == steps.names.end()) {
    binder.error(
        *text.step.node, text.step.path, "no step '" + base::printable(text.step.value) + "'",
        binder.nearest_or(text.step.value, steps.names,
                          steps.names.empty() ? "a measured history has no steps"
                                              : "steps: " + base::few_in_words(steps.names)));
    good = false;
  }
  const OverText& over = text.over.value;
  if (over.from.sound && over.to.sound && !(over.from.value <= over.to.value)) {
    binder.error(*text.over.node, text.over.path,
                 "'from' must not be after 'to', found " + base::format_number(over.from.value) +
                     " and " + base::format_number(over.to.value));
    good = false;
  }
  if (!good || !quantity || !reference || !abscissa) return;
  const ToleranceText& tolerance = text.tolerance.value;
  cases::Check check{.name = text.name.value,
                     .quantity = std::move(quantity->expression),
                     .quantity_text = text.quantity.value,
                     .variables = std::move(quantity->variables),
                     .against = std::move(*reference),
                     .criterion = text.criterion.value,
                     .abscissa = std::move(abscissa->value),
                     .abscissa_text = std::move(abscissa->text),
                     .step = text.step.given() ? std::optional(text.step.value) : std::nullopt,
                     .from = number(over.from),
                     .to = number(over.to),
                     .tolerance = {number(tolerance.absolute), number(tolerance.relative),
                                   tolerance.why, number(tolerance.abscissa)},
                     .where = at.node->where()};
  if (const auto* curve = std::get_if<cases::CurveReference>(&check.against)) {
    check::want_columns(*curve->data, check);
  }
  out.checks.push_back(std::move(check));
}

}  // namespace

void resolve_output_and_checks(yaml::Binder& binder, const CaseText& text, cases::Case& out,
                               bool columns_known, bool history_known, bool curves_may_be_missing) {
  out.output_every = text.output.every;
  const bool excused = binder.unknown_names_excused();
  binder.excuse_unknown_names(excused || !columns_known);
  std::vector<std::string> variables = check_variables(out);
  const auto all = results::result_columns(out);
  std::vector<std::string_view> columns;
  columns.reserve(all.size());
  for (const results::Column& column : all) columns.push_back(column.name);
  // What is driven has a column; a faulty history may have been meant to drive anything.
  std::vector<std::string> driven;
  for (int q = cases::kTemperatureQuantity; !history_known && q < cases::kTensionBehind; ++q) {
    driven.push_back(cases::quantity_name(q));
  }
  for (const std::string& name : driven) {
    if (std::find(variables.begin(), variables.end(), name) == variables.end()) {
      variables.push_back(name);
    }
    columns.push_back(name);
  }
  std::set<std::string_view> chosen;
  // With that many unknown ones, the next tell nothing new.
  int unknown = 0;
  constexpr int kMostUnknown = 100;
  for (const yaml::At<std::string>& column : text.output.columns.value) {
    if (!column.sound) continue;
    if (unknown > kMostUnknown) break;
    if (!chosen.insert(column.value).second) {
      binder.error(*column.node, column.path,
                   "the column '" + base::printable(column.value) + "' stands twice");
    } else if (std::find(columns.begin(), columns.end(), column.value) != columns.end()) {
      out.output_columns.push_back(column.value);
    } else if (!binder.unknown_names_excused()) {
      ++unknown;
      binder.error(
          *column.node, column.path, "no result column '" + base::printable(column.value) + "'",
          column_hint(binder, column.value, columns, "known: " + base::few_in_words(columns)));
    }
  }
  const StepNames steps = step_names(text);
  const std::vector<yaml::At<CheckText>>& checks = text.checks.value;
  std::map<std::string_view, std::size_t> names;
  OpenCurve open;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const yaml::At<std::string>& name = checks[i].value.name;
    if (name.sound && name.value.find_first_not_of(' ') == std::string::npos) {
      binder.error(*name.node, name.path, "the name of a check must not be empty");
    } else if (name.sound) {
      const auto [first, is_new] = names.try_emplace(name.value, i);
      if (!is_new) {
        binder.error(*name.node, name.path,
                     "the name '" + base::printable(name.value) + "' is already that of checks[" +
                         std::to_string(first->second) + "]");
      }
    }
    read_check(binder, checks[i], variables, steps, curves_may_be_missing, open, out);
    const cases::Criterion criterion = checks[i].value.criterion.value;
    const auto column = results::find_column(out, all, checks[i].value.quantity.value);
    if (column &&
        (criterion == cases::Criterion::kPointwise || criterion == cases::Criterion::kPeak)) {
      binder.settle_units(checks[i].path, column->dimension);
    }
  }
  binder.excuse_unknown_names(excused);
}

}  // namespace slipbench::driver::read
