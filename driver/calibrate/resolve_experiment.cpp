// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/resolve_experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "driver/base/csv/csv_fields.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/base/text/in_quotes.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/read/file_kind.hpp"
#include "driver/read/keys/column_unit.hpp"
#include "driver/read/keys/key_index.hpp"
#include "driver/read/resolve/resolve_expression.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::calibrate {
namespace {

namespace fs = std::filesystem;

constexpr base::Dimension kSpeed{.length = 1, .time = -1};
constexpr base::Dimension kAngularSpeed{.time = -1, .angle = 1};

std::vector<std::string_view> views(const std::vector<std::string>& names) {
  return {names.begin(), names.end()};
}

/// A data column of one dimension, none if it is not known; `text` has unit, factor and offset.
/// \param name of the column, as the fit gives it
template <class Text>
DataColumn data_column(yaml::Binder& binder, const Text& text, const yaml::At<std::string>& name,
                       const base::CsvReader* file, std::span<const base::Dimension> dimensions,
                       const base::UnitSystem& system) {
  DataColumn result;
  result.name = name.value;
  result.factor = text.factor.value;
  result.offset = text.offset.value;
  if (text.factor.sound && text.factor.value == 0.0) {
    binder.error(*text.factor.node, text.factor.path, "the factor 0 turns every number into 0");
  }
  if (!name.sound) return result;
  const auto found = read::column_unit(binder, file, name.value, *name.node, name.path, text.unit,
                                       dimensions, system);
  if (!found) return result;
  result.conversion = found->conversion;
  const bool by_file = !text.unit.given() && found->conversion != base::UnitConversion{};
  if (by_file && std::abs(result.factor) != 1.0) {
    const std::string unit = base::printable(file->unit(name.value));
    binder.error(*text.factor.node, text.factor.path,
                 "the file gives column " + base::in_quotes(name.value) + " in " + unit +
                     ": is it to be converted before the factor?",
                 "say so: 'unit: " + unit + "', or 'unit: " +
                     base::unit_text(found->dimension, system) + "' for the factor alone");
  }
  return result;
}

std::optional<double> number(const yaml::At<double>& at) {
  return at.sound ? std::optional(at.value) : std::nullopt;
}

/// A range of times must have an extent.
void check_range(yaml::Binder& binder, const yaml::At<double>& from, const yaml::At<double>& to) {
  if (!from.sound || !to.sound || from.value < to.value) return;
  binder.error(*to.node, to.path,
               "'to' must be later than 'from', which is " + base::format_number(from.value) +
                   "; found " + base::format_number(to.value));
}

/// Every data column that an experiment names and was read without fault.
std::vector<const yaml::At<std::string>*> column_uses(const ExperimentText& text) {
  std::vector<const yaml::At<std::string>*> uses;
  const auto add = [&](const yaml::At<std::string>& at) {
    if (at.sound) uses.push_back(&at);
  };
  add(text.time.value.column);
  for (const yaml::Named<CompareText>& compare : text.compare.value) {
    add(compare.value.column);
    const OverColumnText& over = compare.value.over.value;
    add(over.column.given() ? over.column : over.quantity);
  }
  add(text.dead_band.value.column);
  add(text.dead_band.value.position);
  return uses;
}

}  // namespace

void ExperimentReader::pass_on(const base::Diagnostics& diagnostics) {
  const auto same = [](const base::Diagnostic& a, const base::Diagnostic& b) {
    return a.file == b.file && a.where == b.where && a.path == b.path && a.message == b.message;
  };
  const std::vector<base::Diagnostic> known = out_.diagnostics.sorted();
  for (base::Diagnostic& one : diagnostics.sorted()) {
    const bool said = std::any_of(known.begin(), known.end(),
                                  [&](const base::Diagnostic& other) { return same(one, other); });
    if (!said) out_.diagnostics.add(std::move(one));
  }
}

const ExperimentReader::Parsed& ExperimentReader::parse(const yaml::At<std::string>& name,
                                                        const fs::path& file) {
  const auto [entry, is_new] = parsed_.try_emplace(file.string());
  Parsed& parsed = entry->second;
  if (!is_new) return parsed;
  auto source = base::read_source(file.string());
  if (!source) {
    out_.environment_failure |= source.error().failure == base::ReadFailure::kEnvironment;
    binder_.error(*name.node, name.path,
                  base::printable(name.value) + ": " + source.error().diagnostic.message,
                  source.error().diagnostic.hint);
    return parsed;
  }
  out_.sources.push_back(*source);
  const std::string folder = file.parent_path().string();
  auto read = read::ParsedCase::parse(*source, folder.empty() ? "." : folder);
  if (read) {
    parsed = std::move(*read);
  } else {
    pass_on(read.error());
  }
  return parsed;
}

void ExperimentReader::read_settings(const ExperimentText& text, ReadExperiment& result) {
  const auto is_known = [&](const std::string& name) {
    return std::find(result.parameters.begin(), result.parameters.end(), name) !=
           result.parameters.end();
  };
  const auto is_varied = [&](const std::string& name) {
    return std::any_of(varied_.begin(), varied_.end(),
                       [&](const VariedParameter& varied) { return varied.name == name; });
  };
  for (const yaml::Named<double>& set : text.set) {
    if (!is_known(set.name)) {
      binder_.error(*set.key, set.path,
                    result.case_name + " has no parameter " + base::in_quotes(set.name),
                    binder_.nearest_or(set.name, views(result.parameters),
                                       result.parameters.empty()
                                           ? "it has none at all"
                                           : "its parameters are: " +
                                                 base::few_in_words(views(result.parameters))));
      continue;
    }
    if (is_varied(set.name)) {
      binder_.error(*set.key, set.path,
                    base::in_quotes(set.name) + " is varied: it cannot be set as well",
                    "its start stands under 'vary'");
      continue;
    }
    if (set.sound) result.fit.settings.push_back({set.name, set.value});
  }
  for (const base::ParameterText& override : options_.overrides) {
    if (is_known(override.name) && !is_varied(override.name)) {
      result.fit.settings.push_back(override);
    }
  }
}

void ExperimentReader::read_case_file(const ExperimentText& text, ReadExperiment& result) {
  if (!text.case_file.sound) return;
  const auto file =
      binder_.case_file(*text.case_file.node, text.case_file.path, text.case_file.value);
  if (!file) return;
  result.fit.case_file = text.case_file.value;
  result.fit.case_path = file->lexically_normal();
  const Parsed& parsed = parse(text.case_file, result.fit.case_path);
  if (!parsed) return;
  const yaml::Node root = parsed->root();
  if (!read::key_of(root, read::FileKind::kFit)) result.root = root;
  if (const auto parameters = root.find("parameters")) {
    for (const yaml::Entry entry : parameters->entries()) {
      result.parameters.emplace_back(entry.key.text());
    }
  }
  read_settings(text, result);
  if (flooding_.contains(result.fit.case_path)) return;
  read::ReadOptions options;
  options.allow_outside = options_.allow_outside;
  options.overrides = result.fit.settings;
  for (const VariedParameter& varied : varied_) {
    const bool known = std::find(result.parameters.begin(), result.parameters.end(), varied.name) !=
                       result.parameters.end();
    if (known && std::isfinite(varied.range.start)) {
      options.overrides.push_back({varied.name, varied.range.start});
    }
  }
  read::ReadCase read = parsed->resolve(options);
  pass_on(read.diagnostics);
  if (read.diagnostics.count(base::Severity::kError) > base::Diagnostics::kMaxKept) {
    flooding_.insert(result.fit.case_path);
  }
  out_.environment_failure |= read.environment_failure;
  out_.data_files.insert(out_.data_files.end(), read.data_files.begin(), read.data_files.end());
  if (!read.value) return;
  result.fit.base = std::move(*read.value);
  result.read = true;
}

void ExperimentReader::read_data(const ExperimentText& text, ExperimentFit& fit) {
  data_.reset();
  const auto source = read::data_source(binder_, text.data);
  if (!source) return;
  fit.data_file = source->shown_name;
  fit.data_path = source->file.lexically_normal();
  fit.data_format = source->format;
  const auto fail = [&](const base::HistoryError& error) {
    binder_.history_error(*text.data.node, text.data.path, error);
  };
  auto header = base::CsvReader::open(*source, {});
  if (!header) return fail(header.error());
  const std::vector<std::string> names(header->header().begin(), header->header().end());
  std::vector<std::string> wanted;
  std::vector<const yaml::At<std::string>*> unknown;
  for (const yaml::At<std::string>* use : column_uses(text)) {
    // A name that may be two columns' is the reader's to refuse.
    if (const auto found = base::match_column(names, use->value); found && !*found) {
      unknown.push_back(use);
    } else {
      wanted.push_back(use->value);
    }
  }
  std::vector<std::string> all = wanted;
  for (const yaml::At<std::string>* use : unknown) all.push_back(use->value);
  const std::string remedy = unknown.empty() ? "" : header->remedy(all);
  const std::string columns = "its columns are: " + base::few_in_words(views(names));
  const auto is_position = [&](const yaml::At<std::string>* use) {
    return std::any_of(
        text.compare.value.begin(), text.compare.value.end(),
        [&](const auto& compare) { return use == &compare.value.over.value.quantity; });
  };
  for (const yaml::At<std::string>* use : unknown) {
    std::string hint = columns + remedy;
    if (is_position(use)) {
      hint = fmt::format("name the one that belongs to it, over: {{quantity: {}, column: ..}}; {}",
                         base::printable(use->value), hint);
    } else if (remedy.empty()) {
      hint = binder_.nearest_or(use->value, views(names), columns);
    }
    binder_.error(*use->node, use->path,
                  base::printable(fit.data_file) + " has no column " + base::in_quotes(use->value),
                  std::move(hint));
  }
  if (const auto chosen = base::CsvReader::open(*source, wanted); !chosen)
    return fail(chosen.error());
  data_ = std::move(*header);
}

void ExperimentReader::read_responses(const ExperimentText& text, ReadExperiment& result) {
  const cases::Case& problem = result.fit.base;
  const std::vector<results::Column> columns = results::result_columns(problem);
  std::vector<std::string> names = results::column_names(problem);
  std::vector<std::string> variables{"T"};
  variables.insert(variables.end(), names.begin(), names.end());
  if (std::find(names.begin(), names.end(), "t") == names.end()) variables.push_back("t");
  for (const std::string& parameter : result.parameters) {
    if (std::find(variables.begin(), variables.end(), parameter) == variables.end()) {
      variables.push_back(parameter);
    }
  }
  const auto no_column = [&](const yaml::Node& node, const yaml::Path& path,
                             const std::string& name, std::string otherwise) {
    std::string hint = read::origin_of_column(name);
    if (hint.empty()) hint = binder_.nearest_or(name, views(names), std::move(otherwise));
    binder_.error(node, path, result.case_name + " has no result column " + base::in_quotes(name),
                  std::move(hint));
  };
  for (const yaml::Named<CompareText>& compare : text.compare.value) {
    const CompareText& value = compare.value;
    const auto column = results::find_column(problem, columns, compare.name);
    if (!column && !yaml::Binder::is_expression(*compare.key)) {
      no_column(*compare.key, compare.path, compare.name,
                "an expression begins with '=', in quotes: \"= CSF1 + 10\"");
      continue;
    }
    yaml::At<std::string> quantity;
    quantity.value = compare.name;
    quantity.node = compare.key;
    quantity.path = compare.path;
    quantity.sound = true;
    auto compiled = read::compile_expression(binder_, quantity, variables);
    if (!compiled) continue;
    // Parameters alone would be fitted to the data without a model.
    if (std::ranges::none_of(compiled->variables, [&](const std::string& name) {
          return name != "t" && results::find_column(problem, columns, name).has_value();
        })) {
      binder_.error(*compare.key, compare.path, "is the same number whatever the model does",
                    "name a result column in it, such as CSF1");
      continue;
    }
    if (!column && value.unit.sound) {
      binder_.error(*value.unit.node, value.unit.path,
                    "the unit of an expression is not known, so nothing can be converted to it",
                    "compare the result column itself, with 'factor' and 'offset' for its data");
      continue;
    }
    const base::Dimension dimension = column ? column->dimension : base::Dimension{};
    ResponseFit response{.quantity_text = compare.name,
                         .quantity = std::move(compiled->expression),
                         .variables = std::move(compiled->variables)};
    if (column) response.dimension = dimension;
    const std::span<const base::Dimension> known(&dimension, column ? 1 : 0);
    response.column = data_column(binder_, value, value.column, data(), known, problem.units);
    response.weight = value.weight.value;
    response.sigma = number(value.sigma);
    response.from = number(value.from);
    response.to = number(value.to);
    if (const yaml::At<OverColumnText>& over = value.over; over.sound) {
      const yaml::At<std::string>& name = over.value.quantity;
      const auto position = results::find_column(problem, columns, name.value);
      if (name.value == "t" || name.value == "T" || name.value == "time") {
        binder_.error(*name.node, name.path, "quantities are compared over time anyway",
                      "leave 'over' out");
        continue;
      }
      if (!position) {
        no_column(*name.node, name.path, name.value,
                  "a position is wanted, such as CP1, and the data's column of it: over: "
                  "{quantity: CP1, column: ..}");
        continue;
      }
      response.over = name.value;
      response.over_dimension = position->dimension;
      response.over_column =
          data_column(binder_, over.value, over.value.column.given() ? over.value.column : name,
                      data(), std::span(&position->dimension, 1), problem.units);
    }
    result.fit.responses.push_back(std::move(response));
  }
}

void ExperimentReader::read_cleaning(const ExperimentText& text, const ReadExperiment& known,
                                     ExperimentFit& fit) {
  check_range(binder_, text.from, text.to);
  for (const yaml::Named<CompareText>& compare : text.compare.value) {
    check_range(binder_, compare.value.from, compare.value.to);
  }
  fit.from = number(text.from);
  fit.to = number(text.to);
  if (text.resample.given() && text.resample.node->is_map()) {
    const ResampleText& resample = text.resample.value;
    if (resample.every.given() == resample.points.given() &&
        !yaml::has_unknown_key<ResampleText>(*text.resample.node)) {
      binder_.error(*text.resample.node, text.resample.path,
                    resample.every.given() ? "takes 'every' or 'points', not both"
                                           : "needs 'every' or 'points'");
    }
    Resampling resampling;
    resampling.every = number(resample.every);
    if (resample.points.sound) resampling.points = resample.points.value;
    fit.resample = resampling;
  }
  if (text.average_cycles.sound) {
    fit.average_cycles = {text.average_cycles.value.period.value,
                          text.average_cycles.value.points.value};
  }
  if (text.dead_band.given() && text.dead_band.node->is_map()) {
    const DeadBandText& band = text.dead_band.value;
    if (band.column.given() == band.position.given() &&
        !yaml::has_unknown_key<DeadBandText>(*text.dead_band.node)) {
      binder_.error(*text.dead_band.node, text.dead_band.path,
                    band.column.given() ? "takes 'column' or 'position', not both"
                                        : "needs the 'column' of a speed, or a 'position'");
    }
    DeadBand result;
    result.of_position = band.position.given();
    result.column.name = result.of_position ? band.position.value : band.column.value;
    result.below = band.below.value;
    if (known.read) {
      const std::array<base::Dimension, 2> dimensions =
          result.of_position ? std::array{base::kLength, base::kAngle}
                             : std::array{kSpeed, kAngularSpeed};
      const yaml::At<std::string>& column = result.of_position ? band.position : band.column;
      const auto found =
          column.sound ? read::column_unit(binder_, data(), column.value, *column.node, column.path,
                                           band.unit, dimensions, known.fit.base.units)
                       : std::nullopt;
      if (found) {
        result.column.conversion = found->conversion;
        if (found->dimension == dimensions[1]) result.speed = kAngularSpeed;
      }
    }
    fit.dead_band = result;
  }
}

ReadExperiment ExperimentReader::read(const ExperimentText& text, const yaml::Node& node) {
  ReadExperiment result;
  ExperimentFit& fit = result.fit;
  fit.where = node.where();
  fit.weight = text.weight.value;
  if (text.name.sound) fit.name = text.name.value;
  result.case_name = base::printable(text.case_file.value);
  read_case_file(text, result);
  read_data(text, fit);
  if (text.compare.sound && text.compare.value.empty()) {
    binder_.error(*text.compare.node, text.compare.path, "nothing is compared",
                  "name a result column and a column of the data: {CSF1: force}");
  }
  if (result.read) {
    const DataColumnText& time = text.time.value;
    if (time.column.sound) {
      fit.time = data_column(binder_, time, time.column, data(), std::span(&base::kTime, 1),
                             fit.base.units);
      if (time.factor.sound && time.factor.value < 0.0) {
        binder_.error(*time.factor.node, time.factor.path,
                      "time cannot run backwards: the factor must be greater than 0, found " +
                          base::format_number(time.factor.value));
      }
    }
    read_responses(text, result);
  }
  read_cleaning(text, result, fit);
  if (text.name.sound) {
    const std::string& name = text.name.value;
    if (name.empty() || name.front() == '.' || name.find('/') != std::string::npos ||
        base::printable(name) != name) {
      binder_.error(*text.name.node, text.name.path,
                    "files are called by this name: it must not be empty, begin with '.' or "
                    "contain '/', found " +
                        base::in_quotes(name));
    }
  }
  return result;
}

}  // namespace slipbench::driver::calibrate
