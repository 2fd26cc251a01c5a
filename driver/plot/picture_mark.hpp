// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "driver/base/files/file_mark.hpp"

namespace slipbench::driver::plot {

/// The mark of a picture of `input`, a case, a result or a fit: of any kind, of the same name
/// without folders and ending.
base::FileMark picture_mark(const std::string& input);

/// Writes the text of a mark into a picture that gnuplot has made, where no viewer shows it: behind
/// the end of an SVG or PDF as a comment, into a PNG as a chunk of text.
/// \param ending ".svg", ".png" or ".pdf"
/// \return whether it could be written, and the picture before it is whole: gnuplot does not tell
/// of a full disk
[[nodiscard]] bool write_mark(const std::filesystem::path& picture, std::string_view ending,
                              const std::string& text);

}  // namespace slipbench::driver::plot
