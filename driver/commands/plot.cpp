// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/plot.hpp"

#include <filesystem>

#include "driver/commands/shared.hpp"
#include "driver/plot/kinds.hpp"

namespace slipbench::driver {

namespace fs = std::filesystem;

int plot_command(const PlotOptions& options) {
  fs::path picture = options.output;
  if (picture.empty()) {
    const std::string kind = options.law ? "law" : options.kind;
    picture = fs::path(options.input)
                  .filename()
                  .replace_extension(kind.empty() ? ".svg" : "." + kind + ".svg");
  }
  if (auto drawn = draw_picture(options, picture); !drawn) {
    print_error(drawn.error().message);
    return drawn.error().code;
  }
  print(picture.lexically_normal().string() + "\n");
  return kExitOk;
}

}  // namespace slipbench::driver
