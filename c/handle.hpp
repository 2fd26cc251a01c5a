// SPDX-License-Identifier: Apache-2.0
// Content of a slip_law, for C++ programs that hold definitions already.
#pragma once

#include <vector>

#include "c/slip_law.h"
#include "law/definition/friction_definition.hpp"

struct slip_law {
  std::vector<slipbench::law::FrictionDefinition> definitions;
};
