// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/read_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "driver/base/text/in_quotes.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/calibrate/fit_reference.hpp"
#include "driver/calibrate/fit_text.hpp"
#include "driver/calibrate/resolve_experiment.hpp"
#include "driver/calibrate/resolve_varied.hpp"
#include "driver/read/file_kind.hpp"
#include "driver/read/keys/case_units.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver::calibrate {
namespace {

namespace fs = std::filesystem;

/// Names for experiments that have none: the case's, else the data's, with a number if need be.
void name_experiments(std::vector<ReadExperiment>& experiments) {
  const auto count = [&](const std::string& name) {
    return std::count_if(experiments.begin(), experiments.end(),
                         [&](const ReadExperiment& one) { return one.fit.name == name; });
  };
  const auto stem = [](const fs::path& file) { return file.stem().string(); };
  std::map<std::string, int> of_case;
  for (const ReadExperiment& one : experiments) ++of_case[stem(one.fit.case_path)];
  for (ReadExperiment& one : experiments) {
    if (!one.fit.name.empty()) continue;
    const std::string by_case = stem(one.fit.case_path);
    const std::string wanted = of_case[by_case] > 1 ? stem(one.fit.data_file) : by_case;
    std::string name = wanted;
    for (int number = 2; count(name) > 0; ++number) name = wanted + "_" + std::to_string(number);
    one.fit.name = std::move(name);
  }
}

/// Tells whether a text is a day of the calendar, YYYY-MM-DD.
bool is_date(std::string_view text) {
  constexpr std::string_view kForm = "dddd-dd-dd";
  const bool formed =
      std::equal(text.begin(), text.end(), kForm.begin(), kForm.end(),
                 [](char c, char form) { return form == 'd' ? c >= '0' && c <= '9' : c == form; });
  if (!formed) return false;
  const auto number = [&](std::size_t first, std::size_t count) {
    int value = 0;
    for (const char digit : text.substr(first, count)) value = 10 * value + (digit - '0');
    return value;
  };
  return std::chrono::year_month_day(std::chrono::year(number(0, 4)),
                                     std::chrono::month(static_cast<unsigned>(number(5, 2))),
                                     std::chrono::day(static_cast<unsigned>(number(8, 2))))
      .ok();
}

/// Reader of a fit and of the faults among its experiments as a whole.
class FitReader {
 public:
  FitReader(const yaml::Node& root, const std::string& path, const ReadFitOptions& options,
            ReadFit& out)
      : root_(root),
        options_(options),
        out_(out),
        folder_(fs::path(path).parent_path()),
        binder_(out.diagnostics, no_parameters_, {}, folder_, options.allow_outside, kFitWords) {
    fit_.file = path;
    fit_.folder = folder_.empty() ? fs::path(".") : folder_;
  }

  void read() {
    if (has_too_many_experiments()) return;
    binder_.set_units(units_of_cases());
    FitText text;
    const bool bound = yaml::read_struct(binder_, root_, yaml::Path(), text);
    const CalibrateText& calibrate = text.calibrate.value;
    fit_.title = text.title.empty() ? fs::path(fit_.file).stem().string() : text.title;
    for (const yaml::Named<VaryText>& vary : calibrate.vary.value) {
      fit_.vary.push_back(varied_parameter(binder_, vary));
    }
    reader_.emplace(binder_, options_, fit_.vary, out_);
    read_experiments(calibrate);
    check_something_is_varied(text.calibrate);
    settle_parameters(binder_, calibrate.vary.value, experiments_, fit_.vary);
    fit_.tables = varied_tables(binder_, calibrate.tables.value, experiments_);
    check_shapes();
    check_weights(calibrate);
    check_overrides();
    fit_.loss = calibrate.loss.loss;
    fit_.solver.starts = calibrate.multistart;
    fit_.solver.seed = static_cast<std::uint64_t>(calibrate.seed);
    fit_.solver.most_iterations = calibrate.stop.iterations;
    fit_.solver.step_tolerance = calibrate.stop.step;
    fit_.solver.gradient_tolerance = calibrate.stop.gradient;
    fit_.solver.polish = calibrate.polish;
    fit_.confidence = calibrate.confidence;
    fit_.bootstrap = calibrate.bootstrap;
    fit_.profile = calibrate.profile;
    if (calibrate.date.sound) fit_.date = calibrate.date.value;
    check_date(calibrate.date);
    out_.environment_failure |= binder_.environment_failed();
    const std::vector<std::string>& named = binder_.data_files();
    out_.data_files.insert(out_.data_files.end(), named.begin(), named.end());
    if (!bound || out_.diagnostics.has_errors()) return;
    for (ReadExperiment& one : experiments_) {
      // What has no weight is no data of the fit: it is scored.
      const auto& responses = one.fit.responses;
      one.fit.held_out |= std::none_of(
          responses.begin(), responses.end(),
          [&](const ResponseFit& response) { return one.fit.weight * response.weight > 0.0; });
    }
    std::stable_partition(experiments_.begin(), experiments_.end(),
                          [](const ReadExperiment& one) { return !one.fit.held_out; });
    for (ReadExperiment& one : experiments_) fit_.experiments.push_back(std::move(one.fit));
    out_.value = std::move(fit_);
  }

 private:
  /// The items of a list of experiments, as far as there is one.
  [[nodiscard]] std::optional<yaml::Node> list_of(std::string_view name) const {
    const auto calibrate = root_.find("calibrate");
    const auto all = calibrate && calibrate->is_map() ? calibrate->find(name) : std::nullopt;
    return all && all->is_sequence() ? all : std::nullopt;
  }

  /// Reports a list of so many experiments, each with a case to be read, that it must be a mistake.
  bool has_too_many_experiments() {
    constexpr std::size_t kMostExperiments = 1000;
    for (const char* list : kLists) {
      const auto all = list_of(list);
      const yaml::Path path = yaml::Path() / "calibrate" / list;
      if (all && !binder_.few_enough(*all, path, kMostExperiments)) return true;
    }
    return false;
  }

  /// The system of units that all cases state, for numbers with a unit; nothing if they differ.
  [[nodiscard]] std::optional<base::UnitSystem> units_of_cases() const {
    std::optional<base::UnitSystem> units;
    std::set<std::string_view> met;
    for (const char* list : kLists) {
      const auto all = list_of(list);
      for (std::size_t i = 0; all && i < all->size(); ++i) {
        const auto file = (*all)[i].is_map() ? (*all)[i].find("case") : std::nullopt;
        if (!file || !file->is_scalar() || !met.insert(file->text()).second) continue;
        const auto here = read::units_of_file(folder_, file->text(), options_.allow_outside);
        if (!here) continue;
        const auto names = [](const base::UnitSystem& of) {
          return std::tie(of.length, of.force, of.time, of.temperature);
        };
        if (units && names(*units) != names(*here)) return std::nullopt;
        units = here;
      }
    }
    return units.value_or(base::UnitSystem{});
  }

  void read_experiments(const CalibrateText& text) {
    for (const yaml::At<ExperimentText>& one : text.experiments.value) {
      read_experiment(one, one.value, false);
    }
    for (const yaml::At<HoldoutText>& one : text.holdout.value) {
      read_experiment(one, one.value.experiment, true);
    }
    if (text.experiments.sound && text.experiments.value.empty()) {
      binder_.error(*text.experiments.node, text.experiments.path,
                    text.holdout.value.empty()
                        ? "needs at least one experiment"
                        : "needs at least one experiment: those held out are scored only");
    }
    check_names(text);
    name_experiments(experiments_);
  }

  /// Reads an experiment, unless those before it have more columns to compare, or parameters, than
  /// are read.
  void read_experiment(const auto& at, const ExperimentText& text, bool held_out) {
    constexpr std::size_t kMostResponses = 2000;
    constexpr std::size_t kMostNames = 50 * base::kMostParameters;
    if (responses_ > kMostResponses || names_ > kMostNames) return;
    experiments_.push_back(reader_->read(text, *at.node));
    ReadExperiment& read = experiments_.back();
    read.fit.held_out = held_out;
    responses_ += read.fit.responses.size();
    names_ += read.parameters.size();
    const auto refuse = [&](std::size_t found, const char* what, std::size_t most) {
      if (found <= most) return;
      binder_.error(*at.node, at.path,
                    fmt::format("the experiments up to this one have {} {}, at most {} are read",
                                found, what, most));
    };
    refuse(responses_, "columns to compare", kMostResponses);
    refuse(names_, "parameters in all", kMostNames);
    check_shared_rows(text.data);
  }

  /// Reports rows of the last experiment that one before it has as well: they would be scored as if
  /// the fit did not know them, or count twice.
  void check_shared_rows(const yaml::At<read::DataSourceText>& data) {
    const ExperimentFit& last = experiments_.back().fit;
    if (last.data_path.empty() || !data.given()) return;
    for (std::size_t i = 0; i + 1 < experiments_.size(); ++i) {
      const ExperimentFit& other = experiments_[i].fit;
      if (other.held_out || !shares_rows(last, other)) continue;
      if (last.held_out) {
        binder_.error(*data.node, data.path, "holds out rows that are fitted: that tests nothing",
                      "hold out another file, or other rows by 'from' and 'to'");
      } else if (last.case_path == other.case_path && last.weight * other.weight > 0.0) {
        binder_.warning(*data.node, data.path,
                        "its rows are those of another experiment, and count twice",
                        "to count an experiment more, give it a 'weight'");
      }
      return;
    }
  }

  /// Tells whether two experiments compare the same column with the same quantity in some rows.
  static bool shares_rows(const ExperimentFit& a, const ExperimentFit& b) {
    // Times in other units or from another zero are not compared.
    if (a.data_path != b.data_path || a.time.name != b.time.name ||
        a.time.conversion != b.time.conversion || a.time.factor != b.time.factor ||
        a.time.offset != b.time.offset) {
      return false;
    }
    constexpr double kEver = std::numeric_limits<double>::infinity();
    for (const ResponseFit& one : a.responses) {
      for (const ResponseFit& other : b.responses) {
        if (one.column.name != other.column.name || one.quantity_text != other.quantity_text) {
          continue;
        }
        const double from = std::max({a.from.value_or(-kEver), one.from.value_or(-kEver),
                                      b.from.value_or(-kEver), other.from.value_or(-kEver)});
        const double to = std::min({a.to.value_or(kEver), one.to.value_or(kEver),
                                    b.to.value_or(kEver), other.to.value_or(kEver)});
        if (from < to) return true;
      }
    }
    return false;
  }

  void check_names(const CalibrateText& text) {
    const std::size_t fitted = text.experiments.value.size();
    const auto name_of = [&](std::size_t i) -> const yaml::At<std::string>& {
      return i < fitted ? text.experiments.value[i].value.name
                        : text.holdout.value[i - fitted].value.experiment.name;
    };
    for (std::size_t i = 0; i < experiments_.size(); ++i) {
      const yaml::At<std::string>& name = name_of(i);
      for (std::size_t j = 0; j < i && name.sound; ++j) {
        if (!name_of(j).sound || name_of(j).value != name.value) continue;
        binder_.error(*name.node, name.path,
                      "another experiment is called " + base::in_quotes(name.value) + " as well");
        break;
      }
    }
  }

  void check_something_is_varied(const yaml::At<CalibrateText>& text) {
    const CalibrateText& calibrate = text.value;
    if (!text.given() || !text.node->is_map()) return;
    const bool misspelt = yaml::is_misspelt<CalibrateText>(*text.node, "vary") ||
                          yaml::is_misspelt<CalibrateText>(*text.node, "tables");
    if (misspelt || calibrate.vary.faulty() || calibrate.tables.faulty()) return;
    if (!calibrate.vary.value.empty() || !calibrate.tables.value.empty()) return;
    binder_.error(*text.node, text.path, "nothing is varied",
                  "name parameters of the cases under 'vary', {mu: {start: 0.3}}, or tables under "
                  "'tables'");
  }

  /// The search begins at the nearest table of the wanted shape: worth a note.
  void check_shapes() {
    for (const VariedTable& table : fit_.tables) {
      if (!table.shape.any() || keeps_shape(table)) continue;
      const yaml::Path path = yaml::Path() / "calibrate" / "tables" / table.name;
      out_.diagnostics.note(root_.source().name(), table.where, path.text(),
                            "the numbers of the case do not have the wanted shape: the search "
                            "begins at near ones that have");
    }
  }

  bool keeps_shape(const VariedTable& table) const {
    return std::all_of(experiments_.begin(), experiments_.end(), [&](const ReadExperiment& one) {
      return !one.read || has_shape(one.fit.base, table);
    });
  }

  void check_weights(const CalibrateText& text) {
    bool any = false;
    bool all_read = !experiments_.empty();
    for (const ReadExperiment& one : experiments_) {
      if (one.fit.held_out) continue;
      all_read = all_read && one.read;
      for (const ResponseFit& response : one.fit.responses) {
        any = any || one.fit.weight * response.weight > 0.0;
      }
    }
    const bool bad = text.experiments.faulty() || text.experiments.value.empty();
    if (any || bad || !all_read || out_.diagnostics.has_errors()) return;
    binder_.error(*text.experiments.node, text.experiments.path,
                  "every weight is 0: nothing is left to fit");
  }

  void check_date(const yaml::At<std::string>& date) {
    if (!date.sound || is_date(date.value)) return;
    binder_.error(
        *date.node, date.path,
        "a date is wanted, YYYY-MM-DD, such as 2026-03-01; found " + base::in_quotes(date.value));
  }

  /// Settings of the command line that no case takes.
  void check_overrides() {
    const std::vector<std::string> known = parameters_of(experiments_);
    const bool all_parsed =
        std::all_of(experiments_.begin(), experiments_.end(),
                    [](const ReadExperiment& one) { return one.root.has_value(); });
    const std::vector<std::string_view> names(known.begin(), known.end());
    for (const base::ParameterText& override : options_.overrides) {
      const auto say = [&](std::string message, std::string hint) {
        out_.diagnostics.error(root_.source().name(), {}, "--set " + override.name,
                               std::move(message), std::move(hint));
      };
      if (std::any_of(fit_.vary.begin(), fit_.vary.end(),
                      [&](const VariedParameter& one) { return one.name == override.name; })) {
        say(base::in_quotes(override.name) + " is varied: it cannot be set as well",
            "its start stands under 'vary'");
      } else if (all_parsed &&
                 std::find(known.begin(), known.end(), override.name) == known.end()) {
        say("no case has a parameter " + base::in_quotes(override.name),
            binder_.nearest_or(
                override.name, names,
                known.empty() ? "" : "parameters there are: " + base::few_in_words(names)));
      }
    }
  }

  static constexpr std::array kLists{"experiments", "holdout"};

  yaml::Node root_;
  const ReadFitOptions& options_;
  ReadFit& out_;
  fs::path folder_;
  base::NamedNumbers no_parameters_;
  yaml::Binder binder_;
  Fit fit_;
  std::optional<ExperimentReader> reader_;  ///< owns the texts that the experiments point into
  std::vector<ReadExperiment> experiments_;
  std::size_t responses_ = 0;  ///< of all of them
  std::size_t names_ = 0;      ///< of the parameters of their cases
};

}  // namespace

ReadFit read_fit(const std::string& path, const ReadFitOptions& options) {
  ReadFit result;
  const auto source = base::read_source(path);
  if (!source) {
    result.diagnostics.add(source.error().diagnostic);
    result.environment_failure = source.error().failure == base::ReadFailure::kEnvironment;
    return result;
  }
  result.sources.push_back(*source);
  const auto tree = yaml::parse_yaml(*source);
  if (!tree) {
    result.diagnostics = tree.error();
    return result;
  }
  if (const auto other = read::other_kind(tree->root(), read::FileKind::kFit)) {
    result.diagnostics.error(source->name(), other->key.where(), std::string(other->key.text()),
                             other->sentence, "a fit file has 'calibrate:' and names its cases");
    return result;
  }
  FitReader(tree->root(), path, options, result).read();
  return result;
}

}  // namespace slipbench::driver::calibrate
