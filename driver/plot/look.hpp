// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace slipbench::driver::plot {

/// Size and colours of a picture. Templates lay out a canvas of at least kLayoutWidth and the
/// height that their panels need; a picture of another size is that canvas, made larger to have the
/// size's proportions and then drawn to scale. Texts of a small picture are small, but whole.
struct PictureLook {
  double width = 0.0;   ///< [px]; 0: that of the layout
  double height = 0.0;  ///< [px]; 0: that of the layout
  double dpi = 0.0;   ///< of .png, whose pixels are then finer than kPixelsPerInch; 0: as they are
  bool dark = false;  ///< for a dark background
};

inline constexpr double kLayoutWidth = 1200.0;
inline constexpr double kPixelsPerInch = 96.0;

/// The canvas that a template lays out [px], and the part of it that one of its pixels becomes.
struct Canvas {
  double width = kLayoutWidth;
  double height = 0.0;
  double scale = 1.0;
};

/// \param height that the panels need [px]
Canvas canvas_of(const PictureLook& look, double height);

/// "800x500" as a look of this size. Errors: another form, a side below 200 or above 10000.
tl::expected<PictureLook, std::string> parse_size(std::string_view text);

}  // namespace slipbench::driver::plot
