// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "driver/base/files/file_mark.hpp"
#include "driver/base/text/source_text.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::results {

/// The smallest case that fails as a run did: the text of the case with its numbers as they were
/// (`--set` included), its history up to the step that failed, no output selection and no checks.
/// Comments and layout are lost. Data files keep their names, relative to the case's folder.
/// \param source the case as it was read, without faults
std::string reproducer(const base::SourceText& source, const cases::Case& problem,
                       const bench::SimulationFailure& failure);

/// The mark of a reproducer of a case.
base::FileMark reproducer_mark(const cases::Case& problem);

}  // namespace slipbench::driver::results
