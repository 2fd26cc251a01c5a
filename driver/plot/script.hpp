// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/plot/gnuplot.hpp"
#include "driver/plot/options.hpp"

namespace slipbench::driver::plot {

/// A picture that is being drawn.
struct Picture {
  std::filesystem::path name;     ///< its final name; the ending says what it is
  std::filesystem::path pattern;  ///< the template of plots/
  PictureLook look;
  base::OutputFile output;
};

/// Errors: an ending that is not .svg, .png or .pdf, a template that is not installed, a picture
/// that cannot be written or would take the place of the input, or of a file that is no picture of
/// it.
tl::expected<Picture, PlotFailure> begin_picture(const std::filesystem::path& name,
                                                 const PlotOptions& options,
                                                 std::string_view pattern);

/// Input of a template: variables, arrays with an entry for each panel, and blocks of data.
class PlotScript {
 public:
  void set(std::string_view name, std::string_view text);
  void set(std::string_view name, double number);
  void set(std::string_view name, int number);

  /// Appends an entry to an array. gnuplot counts entries from 1.
  void add(std::string_view array, std::string_view text);
  void add(std::string_view array, double number);
  void add(std::string_view array, int number);

  /// A data block, `$NAME` in the template. Its rows end in line feeds; an empty one cannot be
  /// plotted.
  void block(std::string_view name, std::string rows);

  /// The whole script for a picture whose panels need this height [px], one line of title included.
  std::string text(const Picture& picture, const std::string& title, std::size_t height) const;

 private:
  std::vector<std::string>& entries(std::string_view array);

  std::string variables_;
  std::map<std::string, std::vector<std::string>, std::less<>> arrays_;
  std::vector<std::pair<std::string, std::string>> blocks_;
};

/// Runs gnuplot on a script and puts the picture in its place.
tl::expected<void, PlotFailure> draw(const PlotScript& script, const std::string& title,
                                     std::size_t height, Picture& picture);

}  // namespace slipbench::driver::plot
