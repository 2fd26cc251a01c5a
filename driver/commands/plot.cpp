// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/plot.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/standard_input.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {

namespace fs = std::filesystem;

int plot_command(const plot::PlotOptions& asked, const std::string& size) {
  plot::PlotOptions options = asked;
  if (!size.empty()) {
    const auto look = plot::parse_size(size);
    if (!look) return terminal::refuse(base::kExitBadInput, look.error());
    options.look.width = look->width;
    options.look.height = look->height;
  }
  fs::path picture = options.output;
  std::error_code ignored;
  if (!picture.has_filename() || fs::is_directory(picture, ignored)) {
    const std::string kind = options.law ? "law" : options.kind;
    picture /= fs::path(base::source_name(options.input))
                   .filename()
                   .replace_extension(kind.empty() ? ".svg" : "." + kind + ".svg");
  }
  if (options.look.dpi > 0.0 && picture.extension() != ".png") {
    return terminal::refuse(
        base::kExitBadInput,
        fmt::format("--dpi is of pictures in pixels, .png; {} is none", picture.string()));
  }
  if (auto drawn = plot::draw_picture(options, picture); !drawn) {
    terminal::print_error(drawn.error().message);
    return drawn.error().code;
  }
  terminal::print(picture.lexically_normal().string() + "\n");
  return base::kExitOk;
}

}  // namespace slipbench::driver::commands
