// SPDX-License-Identifier: Apache-2.0
// Coefficients that are drawn without a run.
#pragma once

#include <optional>
#include <string_view>

#include "driver/case/case.hpp"
#include "driver/plot/options.hpp"

namespace slipbench::driver::plot {

/// A case of the parameters of its law's example, for the name of a law; nothing for another name.
std::optional<cases::Case> case_of_law(std::string_view name);

/// The friction of a case whose other parts are missing or faulty: its definitions, title and
/// units. Parameters without a value that its friction does not need have one. Nothing if the
/// friction cannot be read either.
std::optional<cases::Case> case_of_friction(const PlotOptions& options);

}  // namespace slipbench::driver::plot
