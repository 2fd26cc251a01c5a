// SPDX-License-Identifier: Apache-2.0
#include "c/slip_law_yaml.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string>
#include <vector>

#include "driver/base/text/source_text.hpp"
#include "driver/base/text/utf8.hpp"
#include "driver/read/law_only.hpp"
#include "law/definition/packed_definition.hpp"

namespace {

void note(slip_error* error, int status, const std::string& message) {
  if (error == nullptr) return;
  error->status = status;
  const auto fits = slipbench::driver::base::whole_characters(message, sizeof error->message - 1);
  error->message[fits.copy(error->message, fits.size())] = '\0';
}

/// "LINE:COLUMN: path: message; hint" of each error, a line each.
std::string lines_of(const slipbench::driver::base::Diagnostics& diagnostics) {
  std::string lines;
  for (const slipbench::driver::base::Diagnostic& one : diagnostics.sorted()) {
    if (one.severity != slipbench::driver::base::Severity::kError) continue;
    if (!lines.empty()) lines += '\n';
    if (one.where.line > 0) {
      lines += std::to_string(one.where.line) + ':' + std::to_string(one.where.column) + ": ";
    }
    if (!one.path.empty()) lines += one.path + ": ";
    lines += one.message;
    if (!one.hint.empty()) lines += "; " + one.hint;
  }
  return lines;
}

}  // namespace

slip_law* slip_law_create_from_yaml(const char* text, const char* folder, slip_error* error) {
  try {
    const slipbench::driver::base::SourceText source("", text == nullptr ? "" : text);
    const auto read =
        slipbench::driver::read::read_law_only(source, folder == nullptr ? "." : folder);
    if (!read) {
      note(error, SLIP_BAD_DEFINITION, lines_of(read.error()));
      return nullptr;
    }
    // By way of numbers: the two libraries have nothing but the C interface in common.
    const std::vector<double> numbers = slipbench::law::pack_all(read->definitions);
    return slip_law_unpack(numbers.data(), numbers.size(), error);
  } catch (const std::exception& exception) {
    note(error, SLIP_NO_MEMORY, exception.what());
    return nullptr;
  } catch (...) {
    note(error, SLIP_BAD_DEFINITION, "the text cannot be read");
    return nullptr;
  }
}
