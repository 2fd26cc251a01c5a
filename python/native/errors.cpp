// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "driver/base/files/work_crew.hpp"
#include "python/native/bindings.hpp"

namespace slipbench::python {
namespace {

using driver::base::Diagnostic;
using driver::base::Severity;
using driver::base::SourceText;

py::object errors_module() { return py::module_::import("slipbench._errors"); }

py::dict message_of(const Diagnostic& one, std::span<const SourceText> sources) {
  const SourceText* source = nullptr;
  for (const SourceText& each : sources) {
    if (each.name() == one.file) source = &each;
  }
  py::dict entry;
  entry["severity"] = one.severity == Severity::kError     ? "error"
                      : one.severity == Severity::kWarning ? "warning"
                                                           : "note";
  entry["file"] = one.file;
  entry["line"] = one.where.line;
  entry["column"] = one.where.column;
  entry["path"] = one.path;
  entry["message"] = one.message;
  entry["hint"] = one.hint;
  entry["text"] = driver::base::render(one, source);
  return entry;
}

[[noreturn]] void raise(const py::object& error) {
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
  throw py::error_already_set();
}

}  // namespace

void raise_case_error(const driver::base::Diagnostics& diagnostics,
                      std::span<const SourceText> sources) {
  py::list messages;
  for (const Diagnostic& one : diagnostics.sorted()) messages.append(message_of(one, sources));
  raise(errors_module().attr("CaseError")(messages));
}

void raise_error(const char* type, const std::string& message) {
  raise(errors_module().attr(type)(message));
}

void check_threads(int threads) {
  if (threads >= 0 && threads <= driver::base::kMostThreads) return;
  throw py::value_error("threads: wanted 0 to " + std::to_string(driver::base::kMostThreads) +
                        ", found " + std::to_string(threads));
}

void warn_all(const driver::base::Diagnostics& diagnostics, std::span<const SourceText> sources) {
  for (const Diagnostic& one : diagnostics.sorted()) {
    if (one.severity != Severity::kWarning) continue;
    errors_module().attr("warn")(message_of(one, sources));
  }
}

}  // namespace slipbench::python
