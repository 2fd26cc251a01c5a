// SPDX-License-Identifier: Apache-2.0
#include "python/native/bindings.hpp"

PYBIND11_MODULE(_native, module) {
  module.doc() = "The compiled part of slipbench; use the package slipbench.";
  module.attr("version") = SLIPBENCH_VERSION;
  slipbench::python::bind_case(module);
  slipbench::python::bind_law(module);
  slipbench::python::bind_sweep(module);
  slipbench::python::bind_tools(module);
}
