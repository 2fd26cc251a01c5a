// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/base/component.hpp"
#include "law/table/table_function.hpp"

namespace slipbench::law {

/// Prescription of one increment: the motion from begin to end, and at its end the
/// constraint forces, temperature and fields (the law is implicit in them).
struct ConnectorIncrement {
  double duration = 0.0;            ///< dt [T]; rates are taken as 0 if it is not positive
  RelativePosition begin_position;  ///< CP at the begin
  Ambient end;                      ///< CP, CCU, temperature, fields at the end
  ConnectorForce force;             ///< constraint forces and moments at the end [F], [F L]
};

}  // namespace slipbench::law
