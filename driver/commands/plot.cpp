// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/plot.hpp"

#include <array>
#include <filesystem>
#include <string_view>

#include "driver/commands/plot_kinds.hpp"
#include "driver/commands/plot_law.hpp"
#include "driver/commands/shared.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

struct Kind {
  std::string_view name;
  tl::expected<void, PlotFailure> (*draw)(const PlotOptions&, const fs::path&);
};

constexpr std::array<Kind, 6> kKinds{{{"hysteresis", draw_hysteresis},
                                      {"history", draw_history},
                                      {"bands", draw_bands},
                                      {"shares", draw_shares},
                                      {"mu_map", draw_mu_map},
                                      {"residuals", draw_residuals}}};

tl::expected<void, PlotFailure> draw_kind(const PlotOptions& options, const fs::path& picture) {
  if (options.law) {
    if (!options.kind.empty()) {
      return failed(kExitBadInput, "--law and --as are two pictures; choose one");
    }
    return draw_laws(options, picture);
  }
  if (options.kind.empty()) return draw_friction(options, picture);
  for (const Kind& kind : kKinds) {
    if (kind.name == options.kind) return kind.draw(options, picture);
  }
  return failed(kExitBadInput, "there is no picture '" + options.kind + "'");
}

}  // namespace

std::vector<std::string> plot_kinds() {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

int plot_command(const PlotOptions& options) {
  fs::path picture = options.output;
  if (picture.empty()) {
    const std::string kind = options.law ? "law" : options.kind;
    picture = fs::path(options.input)
                  .filename()
                  .replace_extension(kind.empty() ? ".svg" : "." + kind + ".svg");
  }
  if (auto drawn = draw_kind(options, picture); !drawn) {
    print_error(drawn.error().message);
    return drawn.error().code;
  }
  print(picture.lexically_normal().string() + "\n");
  return kExitOk;
}

}  // namespace slipbench::driver
