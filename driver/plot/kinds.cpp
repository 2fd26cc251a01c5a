// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/kinds.hpp"

#include <array>
#include <string_view>

#include "driver/plot/law.hpp"

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

}  // namespace

tl::expected<void, PlotFailure> draw_picture(const PlotOptions& options, const fs::path& picture) {
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

std::vector<std::string> plot_kinds() {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

}  // namespace slipbench::driver
