// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace slipbench::driver::base {

/// Fault met while a history, its data file or its units were read.
struct HistoryError {
  enum class Kind {
    kInput,        ///< The user's text or data is wrong.
    kEnvironment,  ///< The file system or an installed data base is at fault.
  };

  Kind kind = Kind::kInput;
  std::string file;     ///< The data file as the user named it; empty when no file is concerned.
  long line = 0;        ///< Line in `file`, counted from 1; 0 when unknown.
  int column = 0;       ///< Byte in the line, counted from 1; 0 when unknown.
  std::string message;  ///< What was found and what was wanted, without the position.
};

/// The error value for wrong input that has no position of its own.
inline tl::unexpected<HistoryError> input_error(std::string message) {
  return tl::unexpected(HistoryError{HistoryError::Kind::kInput, {}, 0, 0, std::move(message)});
}

/// The error value for a failure of the environment, concerning `file` (may be empty).
inline tl::unexpected<HistoryError> environment_error(std::string file, std::string message) {
  return tl::unexpected(
      HistoryError{HistoryError::Kind::kEnvironment, std::move(file), 0, 0, std::move(message)});
}

}  // namespace slipbench::driver::base
