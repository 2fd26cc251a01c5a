// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "driver/case/case.hpp"

namespace slipbench::driver::report {

/// A small table of texts.
struct TextTable {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::size_t left_out = 0;  ///< rows behind those
};

/// A case as its page tells it, besides its text: connection and friction in words, the tables of
/// its laws, and its history. Files are named without their folders: a page goes to other machines.
struct WhatWasRun {
  std::vector<std::pair<std::string, std::string>> facts;  ///< name and words
  std::vector<TextTable> tables;
  std::string text;  ///< of the case file
};

/// All but the text.
WhatWasRun what_was_run(const cases::Case& problem);

}  // namespace slipbench::driver::report
