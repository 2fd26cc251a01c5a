// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/resolve_varied.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include "driver/base/text/format_number.hpp"
#include "driver/base/text/in_quotes.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/calibrate/table_place.hpp"
#include "law/friction/tabular_coefficient.hpp"

namespace slipbench::driver::calibrate {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFromCase = std::numeric_limits<double>::quiet_NaN();

/// "between 0 and 1", "at least 0": bounds in words.
std::string range_text(double lower, double upper) {
  return yaml::in_words(law::Bounds{.lower = lower, .upper = upper});
}

/// Bounds and scale, checked against each other.
struct Range {
  double lower = 0.0;
  double upper = 0.0;
  bool sound = true;
};

Range range_of(yaml::Binder& binder, const yaml::At<BoundsText>& bounds,
               const yaml::At<fit::Scale>& scale, double default_lower) {
  const bool log = scale.value == fit::Scale::kLog;
  Range range{default_lower, kInfinity};
  if (!bounds.given()) {
    if (log) range.lower = std::max(range.lower, 0.0);
    return range;
  }
  range.sound = bounds.sound;
  if (!bounds.sound) return range;
  const auto& [lower, upper] = bounds.value;
  range.lower = lower.value_or(log ? 0.0 : default_lower);
  range.upper = upper.value_or(kInfinity);
  const auto error = [&](std::string message, std::string hint = {}) {
    binder.error(*bounds.node, bounds.path, std::move(message), std::move(hint));
    range.sound = false;
  };
  const auto found = [&] {
    return "[" + base::format_number(range.lower) + ", " + base::format_number(range.upper) + "]";
  };
  if (range.lower > range.upper) {
    error("the bounds stand upside down: " + found());
  } else if (range.lower == range.upper) {
    error("the bounds are equal: " + found() + " leaves nothing to vary",
          "a fixed number goes under 'set' of the experiments");
  } else if (log && lower && *lower <= 0.0) {
    error("a logarithmic scale has positive bounds, found " + base::format_number(*lower),
          "write 'none' for the lower bound, or a small number");
  }
  return range;
}

/// Tells whether a start lies within its range; says otherwise where `say` puts it.
template <class Say>
bool start_in_range(double start, const fit::UnknownRange& range, Say say) {
  if (range.scale == fit::Scale::kLog && !(start > 0.0)) {
    say("a logarithmic scale needs a positive start, found " + base::format_number(start));
    return false;
  }
  if (start >= range.lower && start <= range.upper) return true;
  say("the start " + base::format_number(start) + " is outside the bounds: it must be " +
      range_text(range.lower, range.upper));
  return false;
}

/// Names of a list, for messages.
std::string list_of(const std::vector<std::string>& names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  return base::few_in_words(views);
}

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

bool has_parameter(const ReadExperiment& experiment, const std::string& name) {
  return std::find(experiment.parameters.begin(), experiment.parameters.end(), name) !=
         experiment.parameters.end();
}

bool any_fitted(std::span<const ReadExperiment> experiments) {
  return std::any_of(experiments.begin(), experiments.end(),
                     [](const ReadExperiment& one) { return !one.fit.held_out; });
}

}  // namespace

std::vector<std::size_t> definitions_of(const cases::Case& problem, std::string_view definition) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < problem.definitions.size(); ++i) {
    const std::string_view name = problem.definitions[i].name;
    const bool part =
        name.starts_with(definition) && name.substr(definition.size()).starts_with('.');
    if (definition.empty() || name == definition || part) found.push_back(i);
  }
  return found;
}

std::vector<std::string> parameters_of(std::span<const ReadExperiment> experiments) {
  std::vector<std::string> names;
  std::set<std::string_view> met;
  for (const ReadExperiment& experiment : experiments) {
    for (const std::string& name : experiment.parameters) {
      if (met.insert(name).second) names.push_back(name);
    }
  }
  return names;
}

VariedParameter varied_parameter(yaml::Binder& binder, const yaml::Named<VaryText>& text) {
  VariedParameter result;
  result.name = text.name;
  result.where = text.key->where();
  const VaryText& vary = text.value;
  const Range range = range_of(binder, vary.bounds, vary.scale, -kInfinity);
  result.range = {kFromCase, range.lower, range.upper, vary.scale.value};
  if (!vary.start.sound) return result;
  // A start that is out of question is not tried on the cases.
  const auto say = [&](std::string message) {
    binder.error(*vary.start.node, vary.start.path, std::move(message));
  };
  if (!range.sound || start_in_range(vary.start.value, result.range, say)) {
    result.range.start = vary.start.value;
  }
  return result;
}

void settle_parameters(yaml::Binder& binder, const yaml::NamedMap<VaryText>& texts,
                       std::span<const ReadExperiment> experiments,
                       std::vector<VariedParameter>& parameters) {
  const std::vector<std::string> known = parameters_of(experiments);
  // Without a fitted experiment, or a case that was understood, more words would only repeat that.
  bool all_parsed = any_fitted(experiments);
  for (const ReadExperiment& experiment : experiments) {
    all_parsed = all_parsed && experiment.root.has_value();
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    VariedParameter& parameter = parameters[i];
    const yaml::Named<VaryText>& text = texts[i];
    const ReadExperiment* first = nullptr;
    bool fitted = false;
    for (const ReadExperiment& experiment : experiments) {
      if (!has_parameter(experiment, parameter.name)) continue;
      if (first == nullptr) first = &experiment;
      fitted = fitted || !experiment.fit.held_out;
    }
    if (first == nullptr) {
      if (!all_parsed) continue;
      const std::vector<std::string_view> names(known.begin(), known.end());
      binder.error(
          *text.key, text.path, "no case has a parameter " + base::in_quotes(text.name),
          binder.nearest_or(text.name, names,
                            known.empty() ? "give the number a name under 'parameters:' of its "
                                            "case, and write '= NAME' in its place"
                                          : "parameters there are: " + list_of(known)));
      continue;
    }
    if (!fitted && all_parsed) {
      binder.error(*text.key, text.path,
                   "only experiments that are held out have the parameter " +
                       base::in_quotes(text.name) + ": nothing tells its value");
      continue;
    }
    if (text.value.start.given()) continue;
    const ReadExperiment* from = nullptr;
    for (const ReadExperiment& experiment : experiments) {
      if (!experiment.read || !has_parameter(experiment, parameter.name)) continue;
      const double value = experiment.fit.base.parameters.find(parameter.name)->second;
      if (from == nullptr) {
        from = &experiment;
        parameter.range.start = value;
      } else if (value != parameter.range.start) {
        binder.error(*text.key, text.path,
                     "is " + base::format_number(parameter.range.start) + " in " + from->case_name +
                         " and " + base::format_number(value) + " in " + experiment.case_name +
                         ": where is the search to begin?",
                     "give it a 'start'");
        break;
      }
    }
    if (from == nullptr || text.value.bounds.faulty()) continue;
    start_in_range(parameter.range.start, parameter.range, [&](const std::string& message) {
      binder.error(*text.key, text.path, message + " (the value of " + from->case_name + ")",
                   "give it a 'start'");
    });
  }
}

namespace {

/// A key of `tables:` taken apart.
struct TableName {
  std::string definition;
  VariedTable::Use use = VariedTable::Use::kCoefficient;
};

std::optional<TableName> table_name(std::string_view key) {
  const std::size_t dot = key.rfind('.');
  const std::string_view last = dot == std::string_view::npos ? key : key.substr(dot + 1);
  TableName name;
  if (dot != std::string_view::npos) name.definition = std::string(key.substr(0, dot));
  for (const auto use : {VariedTable::Use::kCoefficient, VariedTable::Use::kInternalContactForce}) {
    name.use = use;
    if (last == word_of(use)) return name;
  }
  return std::nullopt;
}

/// The table that a definition has; null if it has none.
const law::TableFunction* table_of(const cases::CaseDefinition& definition, VariedTable::Use use) {
  if (use == VariedTable::Use::kInternalContactForce) {
    return std::get_if<law::TableFunction>(&definition.law.internal_contact_force);
  }
  const auto* tabular = std::get_if<law::TabularCoefficient>(&definition.law.law);
  return tabular == nullptr ? nullptr : &tabular->table;
}

bool has_two_laws(const cases::CaseDefinition& definition) {
  return definition.backward ||
         (definition.law.formulation && definition.law.formulation->orthotropy);
}

/// A table of one case.
struct FoundTable {
  const ReadExperiment* experiment = nullptr;
  const law::TableFunction* table = nullptr;
  std::vector<std::string> columns;
};

/// Search of the cases for one key of `tables:`.
class TableSearch {
 public:
  TableSearch(yaml::Binder& binder, const yaml::Named<VariedTableText>& text,
              std::span<const ReadExperiment> experiments)
      : binder_(binder), text_(text), experiments_(experiments) {}

  std::optional<VariedTable> read() {
    const auto name = table_name(text_.name);
    if (!name) {
      unknown();
      return std::nullopt;
    }
    VariedTable result;
    result.name = text_.name;
    result.use = name->use;
    result.where = text_.key->where();
    if (!find(*name)) return std::nullopt;
    result.definition = definition_.value_or(std::string());
    if (!text_.sound || !options(result)) return std::nullopt;
    return result;
  }
  /// Rows of the table that was read.
  std::size_t rows() const { return found_.front().table->table().rows(); }

 private:
  void error(std::string message, std::string hint = {}) {
    binder_.error(*text_.key, text_.path, std::move(message), std::move(hint));
  }

  /// All tables that the cases have, as a fit would name them.
  std::vector<std::string> all_tables() const {
    std::vector<std::string> names;
    for (const ReadExperiment& experiment : experiments_) {
      if (!experiment.read) continue;
      const std::vector<std::string> entries = entry_names(*experiment.root);
      for (const cases::CaseDefinition& definition : experiment.fit.base.definitions) {
        for (const auto& [use, name] :
             {std::pair{VariedTable::Use::kCoefficient, &entries[definition.entry]},
              std::pair{VariedTable::Use::kInternalContactForce, &definition.name}}) {
          if (table_of(definition, use) != nullptr) {
            add_once(names, *name + "." + std::string(word_of(use)));
          }
        }
      }
    }
    return names;
  }

  void unknown() {
    const std::vector<std::string> tables = all_tables();
    const std::vector<std::string_view> names(tables.begin(), tables.end());
    error("no case has a table " + base::in_quotes(text_.name),
          binder_.nearest_or(text_.name, names,
                             tables.empty() ? how_to_write(VariedTable::Use::kCoefficient)
                                            : "tables there are: " + list_of(tables)));
  }

  static std::string how_to_write(VariedTable::Use use) {
    return use == VariedTable::Use::kCoefficient
               ? "a table is written 'coefficient: {columns: [mu, slip_rate], rows: [[0.3, 0], "
                 "[0.2, 10]]}'; a single number is varied as a parameter"
               : "a table is written 'internal_contact_force: {columns: [force, CP1], rows: [[10, "
                 "0], [12, 5]]}'; a single number is varied as a parameter";
  }

  /// Looks the table up in every case.
  /// \return whether a fitted one has it
  bool find(const TableName& name) {
    bool fitted = false;
    bool all_read = any_fitted(experiments_);
    bool defined = false;
    const ReadExperiment* without = nullptr;
    std::string found;
    for (const ReadExperiment& experiment : experiments_) {
      all_read = all_read && experiment.read;
      if (!experiment.read) continue;
      const std::vector<std::string> entries = entry_names(*experiment.root);
      if (name.definition.empty() && entries.size() > 1) {
        error(experiment.case_name + " has " + std::to_string(entries.size()) +
                  " friction definitions: which of them?",
              "write " + base::in_quotes(entries[0] + "." + text_.name) + " or " +
                  base::in_quotes(entries[1] + "." + text_.name));
        return false;
      }
      std::vector<std::string> names;
      const std::string* entry_name = nullptr;
      const cases::Case& problem = experiment.fit.base;
      for (std::size_t i = 0; i < problem.definitions.size(); ++i) {
        const cases::CaseDefinition& definition = problem.definitions[i];
        const std::string& entry = entries[definition.entry];
        if (!name.definition.empty() && entry != name.definition &&
            definition.name != name.definition) {
          continue;
        }
        defined = true;
        if (name.use == VariedTable::Use::kCoefficient && has_two_laws(definition)) {
          error("the coefficient of " + experiment.case_name +
                    " depends on the direction: its tables are not varied",
                "write its numbers as parameters and vary those");
          return false;
        }
        const auto place = table_place(*experiment.root, problem, i, name.use);
        const law::TableFunction* table = table_of(definition, name.use);
        if (table == nullptr) {
          without = &experiment;
          found = !place                    ? "is not given"
                  : place->node.is_scalar() ? "is " + base::in_quotes(place->node.text())
                                            : "is a law";
          continue;
        }
        // Sliding and spinning share one table, at a friction radius with its points converted.
        const bool again = name.use == VariedTable::Use::kCoefficient && entry_name != nullptr &&
                           *entry_name == entry;
        if (!again) found_.push_back({&experiment, table, columns_of(place)});
        fitted = fitted || !experiment.fit.held_out;
        names.push_back(definition.name);
        entry_name = &entry;
      }
      if (names.size() > 1 && name.use == VariedTable::Use::kInternalContactForce) {
        error(experiment.case_name + " has " + std::to_string(names.size()) +
                  " internal contact forces: which of them?",
              "write " + base::in_quotes(names[0] + "." + text_.name) + " or " +
                  base::in_quotes(names[1] + "." + text_.name));
        return false;
      }
      if (!names.empty()) note_name(names, *entry_name);
    }
    if (found_.empty()) {
      if (!all_read) return false;
      if (!defined) {
        unknown();
      } else {
        error(std::string(word_of(name.use)) + " of " + without->case_name + " " + found +
                  ", and no table",
              how_to_write(name.use));
      }
      return false;
    }
    if (!fitted && all_read) {
      error("only experiments that are held out have this table: nothing tells its numbers");
      return false;
    }
    return same_everywhere();
  }

  static std::vector<std::string> columns_of(const std::optional<Place>& place) {
    std::vector<std::string> names;
    const auto columns = place ? place->node.find("columns") : std::nullopt;
    if (!columns || !columns->is_sequence()) return names;
    for (const yaml::Node column : columns->items()) names.emplace_back(column.text());
    return names;
  }

  /// One set of numbers has to stand for the table of every case.
  bool same_everywhere() {
    const FoundTable& first = found_.front();
    const law::Table& table = first.table->table();
    for (const FoundTable& other : found_) {
      const law::Table& compared = other.table->table();
      const std::string both = first.experiment->case_name + " and " + other.experiment->case_name;
      if (!table.same_grid(compared) ||
          !std::equal(first.table->independents().begin(), first.table->independents().end(),
                      other.table->independents().begin(), other.table->independents().end())) {
        error("the tables of " + both + " have different points",
              "give the two definitions different names to vary them apart");
        return false;
      }
      for (std::size_t row = 0; row < table.rows(); ++row) {
        const double here = table.ordinate(row, 0);
        const double there = compared.ordinate(row, 0);
        if (here == there) continue;
        error("row " + std::to_string(row + 1) + " of the tables of " + both + " begins at " +
                  base::format_number(here) + " and " + base::format_number(there),
              "write the same numbers: they are where the search begins");
        return false;
      }
    }
    return true;
  }

  /// Keeps what definitions_of finds the definitions of all cases by.
  void note_name(const std::vector<std::string>& names, const std::string& entry) {
    const bool parts = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
      return name.starts_with(entry + ".");
    });
    const std::string name = names.size() == 1 ? names.front() : parts ? entry : std::string();
    if (!definition_) definition_ = name;
    if (*definition_ != name) definition_ = std::string();
  }

  /// The keys of the table.
  bool options(VariedTable& result) {
    const VariedTableText& text = text_.value;
    const FoundTable& table = found_.front();
    const std::vector<std::string>& columns = table.columns;
    result.free = columns.empty() ? (result.use == VariedTable::Use::kCoefficient ? "mu" : "force")
                                  : columns.front();
    bool good = true;
    if (text.free.sound && text.free.value != result.free) {
      const bool independent =
          std::find(columns.begin(), columns.end(), text.free.value) != columns.end();
      binder_.error(*text.free.node, text.free.path,
                    independent
                        ? base::in_quotes(text.free.value) + " is an independent of the table"
                        : "the table has no column " + base::in_quotes(text.free.value),
                    "what can be varied is its dependent column, " + base::in_quotes(result.free));
      good = false;
    }
    const Range range = range_of(binder_, text.bounds, text.scale, 0.0);
    result.lower = range.lower;
    result.upper = range.upper;
    result.scale = text.scale.value;
    result.shape = {text.monotone.value, text.shape.value};
    result.smoothness = text.smoothness.value;
    if (range.sound && range.lower < 0.0) {
      binder_.error(*text.bounds.node, text.bounds.path,
                    "the numbers of this table must be at least 0, found the bound " +
                        base::format_number(range.lower));
      good = false;
    }
    return good && range.sound && starts_in_range(result);
  }

  bool starts_in_range(const VariedTable& result) {
    const law::Table& table = found_.front().table->table();
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const double start = table.ordinate(row, 0);
      const fit::UnknownRange range{start, result.lower, result.upper, result.scale};
      if (!start_in_range(start, range, [&](const std::string& message) {
            error("row " + std::to_string(row + 1) + " of the table in " +
                  found_.front().experiment->case_name + ": " + message);
          })) {
        return false;
      }
    }
    return true;
  }

  yaml::Binder& binder_;
  const yaml::Named<VariedTableText>& text_;
  std::span<const ReadExperiment> experiments_;
  std::vector<FoundTable> found_;
  std::optional<std::string> definition_;  ///< name in all cases; empty: every definition
};

}  // namespace

std::vector<VariedTable> varied_tables(yaml::Binder& binder,
                                       const yaml::NamedMap<VariedTableText>& texts,
                                       std::span<const ReadExperiment> experiments) {
  // A fit keeps a square of numbers over its unknowns, and solves it again and again.
  constexpr std::size_t kMostRows = 500;
  std::vector<VariedTable> tables;
  std::size_t rows = 0;
  for (const yaml::Named<VariedTableText>& text : texts) {
    TableSearch search(binder, text, experiments);
    auto table = search.read();
    if (!table) continue;
    rows += search.rows();
    if (rows > kMostRows) {
      binder.error(*text.key, text.path,
                   "the tables up to this one have " + std::to_string(rows) + " rows, at most " +
                       std::to_string(kMostRows) + " are fitted");
      break;
    }
    for (const VariedTable& other : tables) {
      const bool same =
          other.use == table->use && (other.definition.empty() || table->definition.empty() ||
                                      other.definition == table->definition);
      if (!same) continue;
      binder.error(*text.key, text.path, "is the same table as " + base::in_quotes(other.name));
      break;
    }
    tables.push_back(std::move(*table));
  }
  return tables;
}

namespace {

/// Tells whether the ordinates of one block keep a shape.
bool has_shape(std::span<const double> x, std::span<const double> y, const fit::Shape& shape) {
  double before = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double slope = (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
    if (shape.monotone == fit::Shape::Monotone::kIncreasing && slope < 0.0) return false;
    if (shape.monotone == fit::Shape::Monotone::kDecreasing && slope > 0.0) return false;
    // Slopes that are equal but for rounding are a straight line.
    const double rounding = 1e-12 * (std::abs(slope) + std::abs(before));
    if (i > 1 && shape.curvature == fit::Shape::Curvature::kConvex && slope < before - rounding) {
      return false;
    }
    if (i > 1 && shape.curvature == fit::Shape::Curvature::kConcave && slope > before + rounding) {
      return false;
    }
    before = slope;
  }
  return true;
}

}  // namespace

bool has_shape(const cases::Case& problem, const VariedTable& table) {
  for (const std::size_t i : definitions_of(problem, table.definition)) {
    const law::TableFunction* function = table_of(problem.definitions[i], table.use);
    if (function == nullptr) continue;
    const law::Table& numbers = function->table();
    std::vector<double> x, y;
    std::vector<double> block;  // the later independents, which are the same within a block
    for (std::size_t row = 0; row < numbers.rows(); ++row) {
      const std::vector<double> point = numbers.point(row);
      const std::vector<double> rest(point.begin() + (point.empty() ? 0 : 1), point.end());
      if (row > 0 && rest != block) {
        if (!has_shape(x, y, table.shape)) return false;
        x.clear();
        y.clear();
      }
      block = rest;
      x.push_back(point.empty() ? static_cast<double>(row) : point.front());
      y.push_back(numbers.ordinate(row, 0));
    }
    if (!has_shape(x, y, table.shape)) return false;
  }
  return true;
}

}  // namespace slipbench::driver::calibrate
