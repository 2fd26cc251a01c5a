// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/kinds.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "driver/plot/law.hpp"

namespace slipbench::driver::plot {
namespace {

namespace fs = std::filesystem;

struct Kind {
  std::string_view name;
  tl::expected<void, PlotFailure> (*draw)(const PlotOptions&, const fs::path&);
};

constexpr std::array<Kind, 8> kKinds{{{"hysteresis", draw_hysteresis},
                                      {"history", draw_history},
                                      {"bands", draw_bands},
                                      {"shares", draw_shares},
                                      {"mu_map", draw_mu_map},
                                      {"residuals", draw_residuals},
                                      {"phase_portrait", draw_phase_portrait},
                                      {"spectrum", draw_spectrum}}};

}  // namespace

tl::expected<void, PlotFailure> draw_picture(const PlotOptions& options, const fs::path& picture) {
  const bool columns = !options.x.empty() || !options.y.empty();
  if (options.law && !options.kind.empty()) {
    return failed(base::kExitBadInput,
                  "--law and --as are two pictures; choose one (mu over two of its arguments as a "
                  "map is '--as mu_map', without --law)");
  }
  if (options.law && (columns || !options.more.empty())) {
    return failed(base::kExitBadInput,
                  "--law draws the coefficients of one case, without --x and --y");
  }
  const bool takes_columns = options.kind.empty() || options.kind == "phase_portrait";
  if (!takes_columns && !options.more.empty()) {
    return failed(base::kExitBadInput,
                  fmt::format("--as {} draws one case or result; several are drawn over each other "
                              "without --as, by --x and --y",
                              options.kind));
  }
  if (!takes_columns && columns && !(options.kind == "spectrum" && options.x.empty())) {
    return failed(base::kExitBadInput,
                  fmt::format("--as {} chooses its columns itself; {}", options.kind,
                              options.kind == "spectrum" ? "give it --y only"
                                                         : "leave out --as to draw --y over --x"));
  }
  if (options.law) return draw_laws(options, picture);
  if (options.kind.empty() && (columns || !options.more.empty())) {
    return draw_curves(options, picture);
  }
  if (options.kind.empty()) return draw_friction(options, picture);
  for (const Kind& kind : kKinds) {
    if (kind.name == options.kind) return kind.draw(options, picture);
  }
  return failed(base::kExitBadInput, "there is no picture '" + options.kind + "'");
}

std::vector<std::string> plot_kinds() {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

}  // namespace slipbench::driver::plot
