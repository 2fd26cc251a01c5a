// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/plot.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/standard_input.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver {

namespace fs = std::filesystem;

int plot_command(const PlotOptions& asked, const std::string& size) {
  PlotOptions options = asked;
  if (!size.empty()) {
    const auto look = parse_size(size);
    if (!look) return refuse(kExitBadInput, look.error());
    options.look.width = look->width;
    options.look.height = look->height;
  }
  fs::path picture = options.output;
  std::error_code ignored;
  if (!picture.has_filename() || fs::is_directory(picture, ignored)) {
    const std::string kind = options.law ? "law" : options.kind;
    picture /= fs::path(source_name(options.input))
                   .filename()
                   .replace_extension(kind.empty() ? ".svg" : "." + kind + ".svg");
  }
  if (options.look.dpi > 0.0 && picture.extension() != ".png") {
    return refuse(kExitBadInput, fmt::format("--dpi is of pictures in pixels, .png; {} is none",
                                             picture.string()));
  }
  if (auto drawn = draw_picture(options, picture); !drawn) {
    print_error(drawn.error().message);
    return drawn.error().code;
  }
  print(picture.lexically_normal().string() + "\n");
  return kExitOk;
}

}  // namespace slipbench::driver
