// SPDX-License-Identifier: Apache-2.0
// Common parts of the commands that draw: gnuplot's terminals, texts and tics, and running it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/plot/look.hpp"

namespace slipbench::driver::plot {

/// Reason why no picture came about.
struct PlotFailure {
  int code = base::kExitEnvironment;
  std::string message;  ///< whole, with its line feed
};

/// "slipbench: error: message" with an exit code.
tl::unexpected<PlotFailure> failed(int code, const std::string& message);

/// gnuplot's terminal for a picture's file name; empty if its ending is not .svg, .png or .pdf. An
/// SVG is of the canvas' size, not yet of its scale.
std::string terminal_for(const std::filesystem::path& picture, const Canvas& canvas,
                         const PictureLook& look);

/// A template of plots/, as it is installed beside the program or in the source folder.
std::optional<std::filesystem::path> find_template(std::string_view name);

/// A text as a gnuplot string that shows it as it is: single quotes know no escapes, double ones
/// are for texts with apostrophes, of which the characters that mean something are octal numbers.
/// The characters of the enhanced mode are text here.
std::string gnuplot_string(std::string_view text);

/// Runs gnuplot on a script that writes `output`, and puts the picture in its place.
/// \param picture its final name, beside which the script is kept meanwhile
/// \param scale of an SVG: how much smaller it is shown than it is laid out
tl::expected<void, PlotFailure> draw_script(const std::string& script,
                                            const std::filesystem::path& picture, double scale,
                                            base::OutputFile& output);

}  // namespace slipbench::driver::plot
