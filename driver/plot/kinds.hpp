// SPDX-License-Identifier: Apache-2.0
// The pictures of `slipbench plot`, one function each. All of them fail with the faults of their
// input, of the picture's name and of gnuplot, and with exit code 2 where the input has nothing
// that the picture could show.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/plot/gnuplot.hpp"
#include "driver/plot/options.hpp"

namespace slipbench::driver::plot {

/// The pictures there are besides the one of friction.gp; each has a template of its name in
/// plots/.
std::vector<std::string> plot_kinds();

/// The picture that the options ask for: one of plot_kinds(), friction.gp or the law's. Exit code 2
/// if there is none of that name, or two are asked for.
tl::expected<void, PlotFailure> draw_picture(const PlotOptions& options,
                                             const std::filesystem::path& picture);

/// Force over time and over motion (plots/friction.gp).
tl::expected<void, PlotFailure> draw_friction(const PlotOptions& options,
                                              const std::filesystem::path& picture);
/// Force over motion for each component that moves, or the paths in a plane; the last full cycle
/// stands out and the dissipated energy is told (plots/hysteresis.gp).
tl::expected<void, PlotFailure> draw_hysteresis(const PlotOptions& options,
                                                const std::filesystem::path& picture);
/// Motion, force with its limit, normal force with mu, and energies over one time axis
/// (plots/history.gp).
tl::expected<void, PlotFailure> draw_history(const PlotOptions& options,
                                             const std::filesystem::path& picture);
/// Stick, slip and no contact over time, a band for each definition, with the changes marked
/// (plots/bands.gp).
tl::expected<void, PlotFailure> draw_bands(const PlotOptions& options,
                                           const std::filesystem::path& picture);
/// Draws what the normal force is made of, over time (plots/shares.gp). A result does not say it: a
/// case is needed.
tl::expected<void, PlotFailure> draw_shares(const PlotOptions& options,
                                            const std::filesystem::path& picture);
/// The coefficient over two of its arguments with the states that the run visited
/// (plots/mu_map.gp). A result does not say its law: a case is needed.
tl::expected<void, PlotFailure> draw_mu_map(const PlotOptions& options,
                                            const std::filesystem::path& picture);
/// Columns of one or several cases or results over another column, --y over --x
/// (plots/curves.gp). Exit code 2: a column that an input has not, units that differ.
tl::expected<void, PlotFailure> draw_curves(const PlotOptions& options,
                                            const std::filesystem::path& picture);
/// Velocity over position, from light to dark as time goes on (plots/curves.gp).
tl::expected<void, PlotFailure> draw_phase_portrait(const PlotOptions& options,
                                                    const std::filesystem::path& picture);
/// The amplitudes of a column over frequency, with its highest peak (plots/spectrum.gp).
tl::expected<void, PlotFailure> draw_spectrum(const PlotOptions& options,
                                              const std::filesystem::path& picture);
/// For each check of a case the quantity less its reference, with the tolerance
/// (plots/residuals.gp). A result has no checks: a case is needed.
tl::expected<void, PlotFailure> draw_residuals(const PlotOptions& options,
                                               const std::filesystem::path& picture);

}  // namespace slipbench::driver::plot
