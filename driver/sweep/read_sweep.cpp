// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/read_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <string_view>
#include <utility>

#include "driver/base/csv/csv_reader.hpp"
#include "driver/base/text/in_quotes.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/read/file_kind.hpp"
#include "driver/read/keys/case_units.hpp"
#include "driver/read/keys/column_unit.hpp"
#include "driver/read/keys/data_source_text.hpp"
#include "driver/read/resolve/resolve_expression.hpp"
#include "driver/results/columns.hpp"
#include "driver/sweep/excess_of_sums.hpp"
#include "driver/sweep/samples.hpp"
#include "driver/sweep/sweep_reference.hpp"
#include "driver/sweep/sweep_text.hpp"
#include "driver/yaml/parse.hpp"

namespace slipbench::driver::sweep {
namespace {

namespace fs = std::filesystem;

/// The one of several keys that is given, by its number; nothing if it is one of `others`, of which
/// so many are given, or after reporting that there is none or more than one.
template <class T, std::size_t kCount>
std::optional<std::size_t> only_one(yaml::Binder& binder, const yaml::Node& node,
                                    const yaml::Path& path,
                                    const std::array<const yaml::At<T>*, kCount>& members,
                                    std::size_t others, std::string_view wanted) {
  std::optional<std::size_t> found;
  std::size_t given = others;
  for (std::size_t i = 0; i < kCount; ++i) {
    if (!members[i]->given()) continue;
    ++given;
    found = i;
  }
  if (given != 1) binder.error(node, path, "wants one of " + std::string(wanted));
  return given == 1 ? found : std::nullopt;
}

class SweepReader {
 public:
  SweepReader(const yaml::Node& root, const std::string& path, const ReadSweepOptions& options,
              ReadSweep& out)
      : root_(root),
        path_(path),
        folder_(fs::path(path).parent_path()),
        options_(options),
        out_(out),
        binder_(out.diagnostics, no_parameters_, {}, folder_, options.allow_outside, kSweepWords) {}

  void read() {
    binder_.set_units(units_of_case());
    SweepText text;
    const bool bound = yaml::read_struct(binder_, root_, yaml::Path(), text);
    const SweepKeysText& keys = text.sweep.value;
    auto parsed = keys.case_file.sound ? parse_case(keys.case_file) : std::nullopt;
    std::vector<VariedParameter> varied =
        keys.csv.given() ? read_drawn(keys, parsed) : read_varied(keys, parsed);
    const std::size_t samples = count_samples(keys, varied);
    if (parsed) {
      Sweep sweep{.file = path_,
                  .title = text.title.empty() ? fs::path(path_).stem().string() : text.title,
                  .case_path = case_path_.string(),
                  .parsed = std::move(*parsed),
                  .settings = options_.overrides,
                  .allow_outside = options_.allow_outside,
                  .varied = std::move(varied),
                  .sampler = keys.csv.given() ? Sampler::kCsv : keys.sampler.value,
                  .samples = samples,
                  .sobol_indices = keys.sobol_indices.value,
                  .seed = static_cast<std::uint64_t>(keys.seed)};
      finish(keys, bound, std::move(sweep));
    }
    out_.environment_failure |= binder_.environment_failed();
    const std::vector<std::string>& named = binder_.data_files();
    out_.data_files.insert(out_.data_files.end(), named.begin(), named.end());
  }

  /// Takes case and samples as they are given, and what is collected from the text.
  void read_around(GivenSamples&& given) {
    SweepText text;
    const bool bound = yaml::read_struct(binder_, root_, yaml::Path(), text);
    const SweepKeysText& keys = text.sweep.value;
    const std::vector<std::string> known = parameters_of(given.parsed);
    for (const VariedParameter& one : given.varied) check_varied(one.name, known, root_, {});
    Sweep sweep{.file = path_,
                .title = {},
                .case_path = {},
                .parsed = std::move(given.parsed),
                .settings = options_.overrides,
                .allow_outside = options_.allow_outside,
                .varied = std::move(given.varied),
                .sampler = Sampler::kCsv};
    sweep.samples = sweep.varied.empty() ? 0 : sweep.varied[0].distribution.numbers.size();
    finish(keys, bound, std::move(sweep));
  }

 private:
  /// Checks the case in the middle of the samples, and reads what is collected of it.
  void finish(const SweepKeysText& keys, bool bound, Sweep&& sweep) {
    if (out_.diagnostics.has_errors() || !resolve_base(sweep)) return;
    read_collected(keys, sweep);
    if (bound && !out_.diagnostics.has_errors()) out_.value = std::move(sweep);
  }

  /// The system of units that the case states, for numbers with a unit.
  [[nodiscard]] base::UnitSystem units_of_case() const {
    const auto keys = root_.find("sweep");
    const auto file = keys && keys->is_map() ? keys->find("case") : std::nullopt;
    if (!file || !file->is_scalar()) return {};
    return read::units_of_file(folder_, file->text(), options_.allow_outside)
        .value_or(base::UnitSystem{});
  }

  std::optional<read::ParsedCase> parse_case(const yaml::At<std::string>& text) {
    const auto file = binder_.case_file(*text.node, text.path, text.value);
    if (!file) return std::nullopt;
    case_path_ = file->lexically_normal();
    const auto source = base::read_source(case_path_.string());
    if (!source) {
      binder_.error(*text.node, text.path, source.error().diagnostic.message);
      out_.environment_failure |= source.error().failure == base::ReadFailure::kEnvironment;
      return std::nullopt;
    }
    out_.sources.push_back(*source);
    const std::string folder = case_path_.parent_path().string();
    auto parsed = read::ParsedCase::parse(*source, folder.empty() ? "." : folder);
    if (!parsed) {
      for (const base::Diagnostic& one : parsed.error().sorted()) out_.diagnostics.add(one);
      return std::nullopt;
    }
    return std::move(*parsed);
  }

  static std::vector<std::string> parameters_of(const std::optional<read::ParsedCase>& parsed) {
    std::vector<std::string> known;
    if (const auto parameters = parsed ? parsed->root().find("parameters") : std::nullopt;
        parameters && parameters->is_map()) {
      for (const yaml::Entry entry : parameters->entries()) known.emplace_back(entry.key.text());
    }
    return known;
  }

  /// Says what is wrong with varying a parameter.
  void check_varied(const std::string& name, const std::vector<std::string>& known,
                    const yaml::Node& node, const yaml::Path& path) {
    const std::vector<std::string_view> names(known.begin(), known.end());
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      binder_.error(node, path, "the case has no parameter " + base::in_quotes(name),
                    binder_.nearest_or(name, names,
                                       known.empty() ? "it has no 'parameters:'"
                                                     : "it has " + base::few_in_words(names)));
    }
    for (const base::ParameterText& setting : options_.overrides) {
      if (setting.name != name) continue;
      binder_.error(node, path, "is varied: '--set " + name + "' cannot set it");
    }
  }

  /// The parameters and values of a file of samples.
  std::vector<VariedParameter> read_drawn(const SweepKeysText& keys,
                                          const std::optional<read::ParsedCase>& parsed) {
    const yaml::At<read::DataSourceText>& csv = keys.csv;
    const auto say = [&](const std::string& message) {
      binder_.error(*csv.node, csv.path, message);
      return std::vector<VariedParameter>();
    };
    if (keys.vary.given()) return say("a file of samples stands in place of 'vary'; one of them");
    if (keys.sampler.given() && keys.sampler.value != Sampler::kCsv) {
      return say("the samples are those of the file: 'sampler' is csv, or left out");
    }
    const auto source = csv.sound ? read::data_source(binder_, csv) : std::nullopt;
    if (!source) return {};
    const auto refuse = [&](const base::HistoryError& error) {
      binder_.history_error(*csv.node, csv.path, error);
      return std::vector<VariedParameter>();
    };
    std::vector<std::string> names;
    {
      const auto header = base::CsvReader::open(*source, {});
      if (!header) return refuse(header.error());
      for (const std::string& name : header->header()) {
        if (name != "id") names.push_back(name);
      }
    }
    if (names.empty()) return say("the file has no column of a parameter");
    if (parsed) {
      const std::size_t before = binder_.errors();
      const std::vector<std::string> known = parameters_of(parsed);
      for (const std::string& name : names) check_varied(name, known, *csv.node, csv.path);
      // A file may have far more columns than a case parameters.
      if (binder_.errors() > before) return {};
    }
    auto reader = base::CsvReader::open(*source, names);
    if (!reader) return refuse(reader.error());
    for (const std::string& name : names) {
      if (!read::is_in_units_of_case(binder_, *reader, name, "a sample", *csv.node, csv.path)) {
        return {};
      }
    }
    std::vector<VariedParameter> varied;
    varied.reserve(names.size());
    for (std::string& name : names) {
      varied.push_back({std::move(name), {.kind = Distribution::Kind::kList, .numbers = {}}});
    }
    std::vector<double> row(varied.size());
    while (true) {
      const auto more = reader->next(row);
      if (!more) return refuse(more.error());
      if (!*more) break;
      for (std::size_t p = 0; p < row.size(); ++p) {
        varied[p].distribution.numbers.push_back(row[p]);
      }
    }
    const std::string missing = base::in_words(reader->missing(), source->format.missing);
    if (!missing.empty()) binder_.note(*csv.node, csv.path, source->shown_name + ": " + missing);
    return varied;
  }

  std::vector<VariedParameter> read_varied(const SweepKeysText& keys,
                                           const std::optional<read::ParsedCase>& parsed) {
    const std::vector<std::string> known = parameters_of(parsed);
    std::vector<VariedParameter> varied;
    if (!keys.vary.given() && !keys.vary.faulty()) {
      const auto sweep = root_.find("sweep");
      if (sweep && sweep->is_map()) {
        binder_.error(*sweep, yaml::Path() / "sweep",
                      "nothing is varied: 'vary' or a file of samples, 'csv', is missing",
                      "name parameters of the case: {mu: {uniform: [0.1, 0.3]}}");
      }
    }
    if (keys.vary.sound && keys.vary.value.empty()) {
      binder_.error(*keys.vary.node, keys.vary.path, "nothing is varied",
                    "name parameters of the case: {mu: {uniform: [0.1, 0.3]}}");
    }
    for (const yaml::Named<DistributionText>& one : keys.vary.value) {
      if (parsed) check_varied(one.name, known, *one.key, one.path);
      if (auto distribution = read_distribution(one)) {
        varied.push_back({one.name, std::move(*distribution)});
      }
    }
    return varied;
  }

  std::optional<Distribution> read_distribution(const yaml::Named<DistributionText>& text) {
    if (!text.sound) return std::nullopt;
    const DistributionText& given = text.value;
    const std::array<const yaml::At<std::vector<double>>*, 4> members{
        &given.uniform, &given.loguniform, &given.normal, &given.grid};
    const auto which = only_one(binder_, *text.node, text.path, members, 0,
                                "'uniform', 'loguniform', 'normal' and 'grid'");
    if (!which || !members[*which]->sound) return std::nullopt;
    const yaml::At<std::vector<double>>& numbers = *members[*which];
    const std::vector<double>& value = numbers.value;
    const auto say = [&](std::string message) {
      binder_.error(*numbers.node, numbers.path, std::move(message));
      return std::nullopt;
    };
    const auto kind = static_cast<Distribution::Kind>(*which);
    if (kind == Distribution::Kind::kList) {
      if (value.empty()) return say("needs at least one value");
      return Distribution{kind, value};
    }
    if (value.size() != 2) return say("wants two numbers");
    if (kind == Distribution::Kind::kNormal) {
      if (!(value[1] > 0.0)) return say("the standard deviation must be greater than 0");
      return Distribution{kind, value};
    }
    if (!(value[0] < value[1])) return say("the first number must be below the second");
    if (kind == Distribution::Kind::kLogUniform && !(value[0] > 0.0)) {
      return say("only numbers greater than 0 have a logarithm");
    }
    return Distribution{kind, value};
  }

  /// Samples, of a file and of a grid too; with Sobol' indices all that are run.
  std::size_t count_samples(const SweepKeysText& keys, const std::vector<VariedParameter>& varied) {
    constexpr std::size_t kMost = 2'000'000'000;
    const yaml::At<int>& samples = keys.samples;
    const auto say = [&](std::string message, std::string hint = {}) {
      const bool has = samples.given();
      const auto sweep = root_.find("sweep");
      binder_.error(has ? *samples.node : sweep.value_or(root_),
                    has ? samples.path : yaml::Path() / "sweep", std::move(message),
                    std::move(hint));
      return std::size_t{0};
    };
    if (keys.sobol_indices.value && (keys.csv.given() || keys.sampler.value == Sampler::kGrid)) {
      binder_.error(*keys.sobol_indices.node, keys.sobol_indices.path,
                    "needs samples that are drawn: not a grid, nor a file");
      return 0;
    }
    if (keys.csv.given()) {
      const std::size_t rows = varied.empty() ? 0 : varied[0].distribution.numbers.size();
      if (!samples.sound) return rows;
      const auto wanted = static_cast<std::size_t>(samples.value);
      if (rows > 0 && wanted > rows) {
        return say("the file has " + std::to_string(rows) + " samples");
      }
      return wanted;
    }
    if (keys.sampler.value == Sampler::kCsv) {
      return say("the sampler csv wants a file of samples: csv: drawn.csv");
    }
    if (keys.sampler.value != Sampler::kGrid) {
      const std::size_t coordinates = keys.sobol_indices.value ? 2 : 1;
      const std::size_t most = most_coordinates(keys.sampler.value) / coordinates;
      if (varied.size() > most) {
        return say("this sampler has at most " + std::to_string(most) + " parameters" +
                       (coordinates > 1 ? " for Sobol' indices" : ""),
                   "'halton' has more, 'lhs' and 'random' any number");
      }
      if (!samples.given()) return say("'samples' is missing: only a grid knows how many it has");
      if (!samples.sound) return 0;
      const auto rows = static_cast<std::size_t>(samples.value);
      const std::size_t length = keys.sobol_indices.value ? varied.size() + 2 : 1;
      if (rows > kMost / length) {
        return say("Sobol' indices take " + std::to_string(length) +
                   " runs a sample: more than 2e9 in all");
      }
      return rows * length;
    }
    std::size_t all = 1;
    for (const VariedParameter& one : varied) {
      if (one.distribution.kind != Distribution::Kind::kList) {
        return say("the sampler grid takes lists only: {" + one.name + ": {grid: [..]}}",
                   "'sampler: sobol' draws from distributions and lists");
      }
      if (one.distribution.numbers.size() > kMost / all) {
        return say("the grid has more than 2e9 combinations", "'sampler: sobol' takes a part");
      }
      all *= one.distribution.numbers.size();
    }
    if (samples.sound && static_cast<std::size_t>(samples.value) != all) {
      return say("the grid has " + std::to_string(all) + " combinations",
                 "leave 'samples' out: a grid is run whole");
    }
    return all;
  }

  /// The case in the middle of what is varied: what is wrong with it is wrong with all. Of a file
  /// of samples the first that is right: the others fail by themselves.
  bool resolve_base(Sweep& sweep) {
    constexpr std::size_t kTried = 100;
    std::vector<double> values(sweep.varied.size());
    const bool drawn = sweep.sampler == Sampler::kCsv;
    read::ReadCase read;
    for (std::size_t i = 0; !read.value && i < (drawn ? std::min(sweep.samples, kTried) : 1); ++i) {
      for (std::size_t p = 0; p < values.size(); ++p) {
        const Distribution& distribution = sweep.varied[p].distribution;
        values[p] = drawn ? distribution.numbers[i] : distribution.at(0.5);
      }
      read = sweep.parsed.resolve({.overrides = overrides_of(sweep, values),
                                   .allow_outside = options_.allow_outside,
                                   .curves_may_be_missing = true});
    }
    for (const base::Diagnostic& one : read.diagnostics.sorted()) {
      if (one.severity == base::Severity::kError) out_.diagnostics.add(one);
    }
    out_.environment_failure |= read.environment_failure;
    out_.data_files.insert(out_.data_files.end(), read.data_files.begin(), read.data_files.end());
    if (!read.value) return false;
    sweep.base = std::move(*read.value);
    return true;
  }

  void read_collected(const SweepKeysText& keys, Sweep& sweep) {
    std::vector<std::string> variables{"T", "t"};
    for (std::string& name : results::column_names(sweep.base)) {
      if (name != "t") variables.push_back(std::move(name));
    }
    if (keys.collect.sound && keys.collect.value.empty()) {
      binder_.error(*keys.collect.node, keys.collect.path, "nothing is collected",
                    "name numbers of a run: {peak: {max: CSF1}}");
    }
    for (const yaml::Named<CollectText>& one : keys.collect.value) {
      check_name(one, sweep);
      const CollectText& text = one.value;
      const std::array<const yaml::At<std::string>*, 4> members{&text.max, &text.min,
                                                                &text.magnitude, &text.last};
      if (!one.sound) continue;
      const auto others = std::array{text.count.given(), text.loop_energy.given(),
                                     text.quantile.given(), text.first_passage.given()};
      const auto which =
          only_one(binder_, *one.node, one.path, members,
                   static_cast<std::size_t>(std::count(others.begin(), others.end(), true)),
                   "'max', 'min', 'magnitude', 'last', 'count', 'loop_energy', 'quantile' and "
                   "'first_passage'");
      Collected collected{.name = one.name};
      const yaml::At<std::string>* quantity = which ? members[*which] : nullptr;
      if (which) collected.reduction = static_cast<Reduction>(*which);
      if (text.count.sound) collected.counted = text.count.value;
      if (text.loop_energy.sound) collected.loop = text.loop_energy.value;
      if (text.quantile.sound) {
        collected.reduction = Reduction::kQuantile;
        collected.level = text.quantile.value.part.value;
        quantity = &text.quantile.value.of;
      }
      if (text.first_passage.sound) {
        if (!read_passage(text.first_passage, collected)) continue;
        quantity = &text.first_passage.value.of;
      }
      if (quantity != nullptr) {
        auto compiled = read::compile_expression(binder_, *quantity, variables);
        if (!compiled) continue;
        if (compiled->variables.empty()) {
          binder_.error(*quantity->node, quantity->path, "is the same number in every sample",
                        "name a result column in it, such as CSF1");
          continue;
        }
        collected.quantity = std::move(compiled->expression);
        collected.variables = std::move(compiled->variables);
      }
      sweep.collected.push_back(std::move(collected));
    }
    if (auto excess = excess_of_sums(sweep)) {
      binder_.error(*keys.collect.node, keys.collect.path, std::move(*excess));
    }
  }

  bool read_passage(const yaml::At<PassageText>& text, Collected& collected) {
    const PassageText& given = text.value;
    const std::array<const yaml::At<double>*, 2> members{&given.above, &given.below};
    const auto which = only_one(binder_, *text.node, text.path, members, 0, "'above' and 'below'");
    if (!which) return false;
    collected.reduction = *which == 0 ? Reduction::kFirstAbove : Reduction::kFirstBelow;
    collected.level = members[*which]->value;
    return true;
  }

  /// Names are those of columns: `id`, the varied parameters, what is collected.
  void check_name(const yaml::Named<CollectText>& one, const Sweep& sweep) {
    const bool taken = one.name == "id" ||
                       std::any_of(sweep.varied.begin(), sweep.varied.end(),
                                   [&](const auto& varied) { return varied.name == one.name; });
    if (taken) {
      binder_.error(*one.key, one.path, "another column of the result is called so as well");
    }
    if (one.name.empty() || one.name.find_first_of(",\"\n\r") != std::string::npos) {
      binder_.error(*one.key, one.path, "is no name for a column of a CSV file");
    }
  }

  yaml::Node root_;
  std::string path_;
  fs::path folder_;
  fs::path case_path_;
  const ReadSweepOptions& options_;
  ReadSweep& out_;
  base::NamedNumbers no_parameters_;
  yaml::Binder binder_;
};

}  // namespace

ReadSweep sweep_of_samples(GivenSamples given, const std::string& collect,
                           const ReadSweepOptions& options) {
  ReadSweep result;
  const std::string name = "<collect>";
  result.sources.emplace_back(name,
                              "slipbench: 1\nsweep: {case: given, collect: " + collect + "}\n");
  const auto tree = yaml::parse_yaml(result.sources.front());
  if (!tree) {
    result.diagnostics = tree.error();
  } else {
    SweepReader(tree->root(), name, options, result).read_around(std::move(given));
  }
  return result;
}

ReadSweep read_sweep(const std::string& path, const ReadSweepOptions& options) {
  ReadSweep result;
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
  if (const auto other = read::other_kind(tree->root(), read::FileKind::kSweep)) {
    result.diagnostics.error(source->name(), other->key.where(), std::string(other->key.text()),
                             other->sentence, "a sweep file has 'sweep:' and names its case");
    return result;
  }
  SweepReader(tree->root(), path, options, result).read();
  return result;
}

}  // namespace slipbench::driver::sweep
