// SPDX-License-Identifier: Apache-2.0
// The program as a user runs it.
#pragma once

#include <sys/wait.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/support/project_paths.hpp"

namespace slipbench::driver::commands {

inline const std::string kProgram = test::binary_dir() + "/slipbench";

struct Ended {
  int code = -1;
  std::string output;  ///< of both streams
};

/// Runs a shell command line in `folder`.
inline Ended shell(const TemporaryFolder& folder, const std::string& line) {
  Ended ended;
  const std::string command = "cd '" + folder.path().string() + "' && { " + line + "; } 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 4096> piece{};
  for (std::size_t n = 0; (n = fread(piece.data(), 1, piece.size(), pipe)) > 0;) {
    ended.output.append(piece.data(), n);
  }
  const int status = pclose(pipe);
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ended;
}

inline Ended slipbench(const TemporaryFolder& folder, const std::string& arguments) {
  return shell(folder, "'" + kProgram + "' " + arguments);
}

}  // namespace slipbench::driver::commands
