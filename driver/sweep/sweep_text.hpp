// SPDX-License-Identifier: Apache-2.0
// A sweep as it is written: the structs beside whose members every key of a sweep file is declared.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "driver/sweep/sweep.hpp"
#include "driver/yaml/binding.hpp"

// Specialisations belong to the namespace of their template.
namespace slipbench::driver::yaml {

template <>
struct EnumWords<sweep::Sampler> {
  static constexpr std::array<std::string_view, 5> kWords{"grid", "sobol", "halton", "lhs",
                                                          "random"};
};
template <>
struct EnumWords<sweep::Counted> {
  static constexpr std::array<std::string_view, 3> kWords{"stick_to_slip", "slip_to_stick",
                                                          "reversal"};
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

struct CollectText {
  yaml::At<std::string> max, min, magnitude, last;
  yaml::At<Counted> count;

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
  }
};

struct SweepKeysText {
  yaml::At<std::string> case_file;
  yaml::At<yaml::NamedMap<DistributionText>> vary;
  yaml::At<Sampler> sampler = yaml::default_of(Sampler::kSobol);
  yaml::At<int> samples;
  int seed = 1;
  yaml::At<yaml::NamedMap<CollectText>> collect;

  static void declare(auto& key) {
    key("case", &SweepKeysText::case_file,
        {.required = true, .text = "Case file that is run again and again."});
    key("vary", &SweepKeysText::vary,
        {.required = true,
         .text = "Parameters of the case, and what their values are drawn from."});
    key("sampler", &SweepKeysText::sampler,
        {.text = "Order in which the space of the parameters is filled; lhs is the Latin "
                 "hypercube.",
         .default_text = "sobol"});
    key("samples", &SweepKeysText::samples,
        {.text = "How many samples are run.",
         .default_text = "all combinations, of a grid; else required",
         .bounds = {.lower = 1, .upper = 2.0e9}});
    key("seed", &SweepKeysText::seed,
        {.text = "The same seed gives the same samples.",
         .default_text = "1",
         .bounds = law::kNotNegative});
    key("collect", &SweepKeysText::collect,
        {.required = true, .text = "Numbers of each run, by name: {peak: {max: CSF1}}."});
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
