// SPDX-License-Identifier: Apache-2.0
// A sweep as it is written: the structs beside whose members every key of a sweep file is declared.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/units/parameters.hpp"
#include "driver/read/keys/data_source_text.hpp"
#include "driver/sweep/sweep.hpp"
#include "driver/yaml/binding.hpp"

// Specialisations belong to the namespace of their template.
namespace slipbench::driver::yaml {

template <>
struct EnumWords<sweep::Sampler> {
  static constexpr std::array<std::string_view, 6> kWords{"grid", "sobol",  "halton",
                                                          "lhs",  "random", "csv"};
};
template <>
struct EnumWords<sweep::Counted> {
  static constexpr std::array<std::string_view, 3> kWords{"stick_to_slip", "slip_to_stick",
                                                          "reversal"};
};
template <>
struct EnumWords<sweep::Loop> {
  static constexpr std::array<std::string_view, 2> kWords{"first", "last"};
};

}  // namespace slipbench::driver::yaml

namespace slipbench::driver::sweep {

struct DistributionText {
  yaml::At<std::vector<double>> uniform, loguniform, normal, grid;

  static void declare(auto& key) {
    key("uniform", &DistributionText::uniform,
        {.text = "Lowest and highest value, all between equally likely.",
         .default_text = "another distribution",
         .unit = yaml::UnitUse::kAny});
    key("loguniform", &DistributionText::loguniform,
        {.text = "The same for the logarithm; both greater than 0.",
         .default_text = "another distribution",
         .unit = yaml::UnitUse::kAny});
    key("normal", &DistributionText::normal,
        {.text = "Mean and standard deviation.",
         .default_text = "another distribution",
         .unit = yaml::UnitUse::kAny});
    key("grid", &DistributionText::grid,
        {.text = "A list of values; the sampler grid takes all combinations, others draw from it.",
         .default_text = "another distribution",
         .unit = yaml::UnitUse::kAny});
  }
};

struct QuantileText {
  yaml::At<std::string> of;
  yaml::At<double> part;

  static void declare(auto& key) {
    key("of", &QuantileText::of,
        {.required = true, .text = "A result column, or an expression over columns."});
    key("part", &QuantileText::part,
        {.required = true,
         .text = "The part of the time for which it is at or below the number: 0.95.",
         .bounds = {.lower = 0.0, .upper = 1.0}});
  }
};

struct PassageText {
  yaml::At<std::string> of;
  yaml::At<double> above, below;

  static void declare(auto& key) {
    key("of", &PassageText::of,
        {.required = true, .text = "A result column, or an expression over columns."});
    key("above", &PassageText::above,
        {.text = "The level that it rises above.", .default_text = "below"});
    key("below", &PassageText::below,
        {.text = "The level that it falls below.", .default_text = "above"});
  }
};

struct CollectText {
  yaml::At<std::string> max, min, magnitude, last;
  yaml::At<Counted> count;
  yaml::At<Loop> loop_energy;
  yaml::At<QuantileText> quantile;
  yaml::At<PassageText> first_passage;

  static void declare(auto& key) {
    key("max", &CollectText::max,
        {.text = "Highest value of a result column, or of an expression over columns.",
         .default_text = "another number"});
    key("min", &CollectText::min, {.text = "Lowest value.", .default_text = "another number"});
    key("magnitude", &CollectText::magnitude,
        {.text = "Largest magnitude.", .default_text = "another number"});
    key("last", &CollectText::last,
        {.text = "Value at the end of the run.", .default_text = "another number"});
    key("count", &CollectText::count,
        {.text = "How many events there are.", .default_text = "another number"});
    key("loop_energy", &CollectText::loop_energy,
        {.text = "Energy that friction dissipates in the first or the last whole cycle.",
         .default_text = "another number"});
    key("quantile", &CollectText::quantile,
        {.text = "Value that a quantity is at or below for a part of the time.",
         .default_text = "another number"});
    key("first_passage", &CollectText::first_passage,
        {.text = "Total time T at which a quantity first passes a level.",
         .default_text = "another number"});
  }
};

struct SweepKeysText {
  yaml::At<std::string> case_file;
  yaml::At<yaml::NamedMap<DistributionText>> vary;
  yaml::At<read::DataSourceText> csv;
  yaml::At<Sampler> sampler = yaml::default_of(Sampler::kSobol);
  yaml::At<int> samples;
  int seed = 1;
  yaml::At<bool> sobol_indices = yaml::default_of(false);
  yaml::At<yaml::NamedMap<CollectText>> collect;

  static void declare(auto& key) {
    key("case", &SweepKeysText::case_file,
        {.required = true, .text = "Case file that is run again and again."});
    key("vary", &SweepKeysText::vary,
        {.text = "Parameters of the case, and what their values are drawn from.",
         .default_text = "required without csv",
         .most = base::kMostParameters});
    key("csv", &SweepKeysText::csv,
        {.text = "File of samples: a column for each parameter that is varied, a row a sample; a "
                 "column id is passed over.",
         .default_text = "vary"});
    key("sampler", &SweepKeysText::sampler,
        {.text = "Order in which the space of the parameters is filled; lhs is the Latin "
                 "hypercube, csv the order of the file.",
         .default_text = "csv with that key, else sobol"});
    key("samples", &SweepKeysText::samples,
        {.text = "How many samples are run.",
         .default_text = "all of a grid, all rows of a file; else required",
         .bounds = {.lower = 1, .upper = 2.0e9}});
    key("seed", &SweepKeysText::seed,
        {.text = "The same seed gives the same samples.",
         .default_text = "1",
         .bounds = law::kNotNegative});
    key("sobol_indices", &SweepKeysText::sobol_indices,
        {.text = "true: parts of the variance by parameter; each of the samples then takes as "
                 "many runs as there are parameters, and two.",
         .default_text = "false"});
    key("collect", &SweepKeysText::collect,
        {.required = true,
         .text = "Numbers of each run, by name: {peak: {max: CSF1}}.",
         .most = 1000});
  }
};

struct SweepText {
  yaml::At<int> slipbench;
  std::string title;
  yaml::At<SweepKeysText> sweep;

  static void declare(auto& key) {
    key("slipbench", &SweepText::slipbench,
        {.required = true,
         .text = "Version of the format: 1.",
         .bounds = {.lower = 1, .upper = 1}});
    key("title", &SweepText::title,
        {.text = "One line for the result.", .default_text = "the file's name"});
    key("sweep", &SweepText::sweep, {.required = true, .text = "The sweep."});
  }
};

}  // namespace slipbench::driver::sweep
