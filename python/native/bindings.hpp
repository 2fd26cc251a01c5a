// SPDX-License-Identifier: Apache-2.0
// Parts of the module slipbench._native.
#pragma once

#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <thread>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/json.hpp"
#include "driver/base/text/source_text.hpp"

namespace slipbench::python {

namespace py = pybind11;

void bind_case(py::module_& module);
void bind_law(py::module_& module);
void bind_sweep(py::module_& module);
void bind_tools(py::module_& module);

/// Raises slipbench.CaseError with the messages of a text.
[[noreturn]] void raise_case_error(const driver::base::Diagnostics& diagnostics,
                                   std::span<const driver::base::SourceText> sources);
/// Raises an exception of the module slipbench._errors: RunError, ..
[[noreturn]] void raise_error(const char* type, const std::string& message);
/// Raises ValueError for a number of threads that the program would refuse; 0 stands for as many as
/// cores.
void check_threads(int threads);
/// Looks for Ctrl-C; false if there was one, whose exception is then set. Needs no lock, and is
/// true on threads but the one that made it.
class Interruption {
 public:
  bool none() const {
    if (std::this_thread::get_id() != caller_) return true;
    const py::gil_scoped_acquire locked;
    return PyErr_CheckSignals() == 0;
  }

 private:
  std::thread::id caller_ = std::this_thread::get_id();
};

/// Issues a Python warning slipbench.SlipbenchWarning for each warning among messages.
void warn_all(const driver::base::Diagnostics& diagnostics,
              std::span<const driver::base::SourceText> sources);

}  // namespace slipbench::python
