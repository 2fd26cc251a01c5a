// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/base/units/expression.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/case/case.hpp"
#include "driver/read/read_case.hpp"
#include "driver/sweep/distribution.hpp"

namespace slipbench::driver::sweep {

/// A parameter of the case, with what it is drawn from.
struct VariedParameter {
  std::string name;
  Distribution distribution;
};

/// Order in which the space of the parameters is filled. kCsv takes them from a file: each
/// parameter has the list of its column, and sample i the i-th of each.
enum class Sampler : std::uint8_t { kGrid, kSobol, kHalton, kLatinHypercube, kRandom, kCsv };

/// Number that is left of a quantity after a run; kMagnitude is its largest magnitude, kQuantile a
/// value that it is at or below for a part of the time, kFirstAbove and kFirstBelow the time at
/// which it first passes a level.
enum class Reduction : std::uint8_t {
  kMaximum,
  kMinimum,
  kMagnitude,
  kLast,
  kQuantile,
  kFirstAbove,
  kFirstBelow,
};

/// Events that are counted, of all friction definitions together.
enum class Counted : std::uint8_t { kStickToSlip, kSlipToStick, kReversal };

/// Whole cycle whose dissipated energy is collected, of all friction definitions together.
enum class Loop : std::uint8_t { kFirst, kLast };

/// One number of the result of a sample: of a quantity, how many events there were, or an energy.
struct Collected {
  std::string name;
  std::optional<Counted> counted = std::nullopt;
  std::optional<Loop> loop = std::nullopt;
  Reduction reduction = Reduction::kLast;
  double level = 0.0;  ///< that is passed; of a quantile the part of the time
  std::optional<base::Expression> quantity = std::nullopt;  ///< that is reduced
  std::vector<std::string> variables = {};                  ///< of `quantity`, in its order
};

/// Runs of one case with other parameters.
struct Sweep {
  std::string file;
  std::string title;
  std::string case_path;
  read::ParsedCase parsed;                         ///< of the case, resolved for each sample
  cases::Case base = {};                           ///< in the middle of what is varied
  std::vector<base::ParameterText> settings = {};  ///< --set
  bool allow_outside = false;
  std::vector<VariedParameter> varied = {};
  Sampler sampler = Sampler::kSobol;
  std::size_t samples = 0;     ///< of a grid: all of its points
  bool sobol_indices = false;  ///< the samples are laid out for them: sobol_indices.hpp
  std::uint64_t seed = 1;
  std::vector<Collected> collected = {};
};

/// Returns how many samples are drawn from one point of the sampler: with Sobol' indices a row of
/// them.
inline std::size_t row_length(const Sweep& sweep) {
  return sweep.sobol_indices ? sweep.varied.size() + 2 : 1;
}

/// Returns the overrides with which the case of one sample is resolved.
/// \param values of the varied parameters, in their order
std::vector<base::ParameterText> overrides_of(const Sweep& sweep, std::span<const double> values);

/// Returns an override as --set takes it: "mu=0.2".
std::string setting_text(const base::ParameterText& one);

/// Returns what --set gave to the whole sweep: "N=50, k=1e3"; empty for nothing.
std::string settings_text(const Sweep& sweep);

}  // namespace slipbench::driver::sweep
