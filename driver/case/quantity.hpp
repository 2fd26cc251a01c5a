// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "law/base/notation.hpp"

namespace slipbench::driver::cases {

/// Quantities that a case can prescribe, in one flat numbering: 0..5 relative positions
/// CP1..CPR3, 6..11 constraint forces f1..m3, 12 temperature, 13.. fields; of a belt, behind the
/// fields, the tension f_bc; of a dynamic case the load on its driver; of a belt the coordinates of
/// its nodes a, b, c.
inline constexpr int kFirstMotion = 0;
inline constexpr int kFirstForce = law::kComponents;
inline constexpr int kTemperatureQuantity = 2 * law::kComponents;
inline constexpr int kFirstField = kTemperatureQuantity + 1;
inline constexpr int kTensionBehind = kFirstField + law::kMaxFields;
inline constexpr int kDriverLoad = kTensionBehind + 1;
inline constexpr int kFirstNode = kDriverLoad + 1;
inline constexpr int kNodeCoordinates = 9;  ///< x, y, z of a, then of b, then of c
inline constexpr int kQuantities = kFirstNode + kNodeCoordinates;

/// "1".."3" for translations, "R1".."R3" for rotations: what follows CP, CU, CASU.
std::string component_suffix(int component);
/// CP1..CP3, CPR1..CPR3.
std::string motion_name(int component);
/// f1..f3, m1..m3.
std::string force_name(int component);
/// Result columns of forces: prefix CSF gives CSF1..CSF3, CSM1..CSM3 (likewise CRF, CTF, CNF).
std::string force_column(std::string_view prefix, int component);
/// The user's name of a quantity of the flat numbering.
std::string quantity_name(int quantity);

/// The component of a name `prefix` + 1..3 or `prefix` + R1..R3, or nothing.
std::optional<int> component_of_motion(std::string_view name, std::string_view prefix = "CP");
/// The component of f1..f3, m1..m3, or nothing.
std::optional<int> component_of_force(std::string_view name);
/// The index 0.. of field1, field2, ..., or nothing.
std::optional<int> field_of(std::string_view name);

}  // namespace slipbench::driver::cases
