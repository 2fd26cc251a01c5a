// SPDX-License-Identifier: Apache-2.0
// Variables of the templates that draw a result: its rows, its spans of slip, and the
// columns of each friction definition. Columns count from 1 in gnuplot; 0 is none.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "driver/plot/script.hpp"
#include "driver/results/plot_data.hpp"

namespace slipbench::driver::plot {

/// Of more definitions the first are drawn.
inline constexpr std::size_t kMostDefinitions = 4;

std::size_t drawn_definitions(const results::PlotData& data);
/// "Title (the first 4 of 6 definitions)" where not all are drawn.
std::string drawn_title(const results::PlotData& data);
/// Rows as gnuplot reads them.
std::string rows_text(const results::PlotData& data, const std::vector<double>& rows);

const results::PlotColumn& column_of(const results::PlotData& data, int number);
/// The largest magnitude a column has; 0 for none.
double magnitude_of(const results::PlotData& data, int number);
/// Tells whether the numbers of a column differ.
bool moves(const results::PlotData& data, int number);

/// "friction force CSF1 [N]".
std::string axis_label(std::string_view what, const results::PlotColumn& column);
/// Tells whether all forces of a definition are moments.
bool is_moment(const results::PlotData& data, const results::PlotDefinition& definition);
std::string force_label(const results::PlotData& data, int force);
/// Names a position: "position CP1 [mm]" or "angle CPR1 [rad]".
std::string motion_label(const results::PlotData& data, int position);

/// CSFC of a coupled definition, else its only force.
int main_force(const results::PlotDefinition& definition);
/// The entries of `components` that are forces along axes with a position: two of a plane.
std::vector<std::size_t> translations_of(const results::PlotData& data,
                                         const results::PlotDefinition& definition);
/// The entry of `components` whose loop is drawn: the first that moves, or the first.
std::size_t shown_component(const results::PlotData& data,
                            const results::PlotDefinition& definition);

/// The axis of time: TIME_LABEL, TIME_FORMAT, TIME_STEP, BEGIN and END_TIME, which is later.
void tell_time(PlotScript& script, const std::string& unit, double begin, double end);
/// The number of a span's status in $SPANS: 0 open, 1 stick, 2 slip, 3 slip and others in turn,
/// 4 no contact and others in turn, each too short to be drawn.
int drawn_status(const results::RegimeSpan& span);
/// $DATA, $SPANS, and the axis of time.
void tell_rows(PlotScript& script, const results::PlotData& data);
/// Force and limit of a definition, and what stands around its panels: NAME, FORCE, FORCE_NAME,
/// FORCE_LABEL, SIGNED, BESIDE, BESIDE_NAMES, LIMIT, LIMIT_BELOW, TOP, SLIPS, OPENS,
/// TURNS.
void tell_force(PlotScript& script, const results::PlotData& data,
                const results::PlotDefinition& definition);
/// The path of a planar force and the ellipse of its largest limit: LIMIT_AXIS_1, LIMIT_AXIS_2,
/// DIRECTION_X, DIRECTION_Y and FORCE_STEP.
void tell_limit_ellipse(PlotScript& script, const results::PlotData& data,
                        const results::PlotDefinition& definition, double parts);
/// The largest force a definition has or could have; 1 if it has none.
double top_of(const results::PlotData& data, const results::PlotDefinition& definition);

}  // namespace slipbench::driver::plot
