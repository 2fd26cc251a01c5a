// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/regular_file.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::base {
namespace {

TEST_CASE("a file is opened, a pipe or a folder refused before it is waited for") {
  const TemporaryFolder folder;
  folder.write("rows.csv", "t,u\n");
  auto opened = open_regular(folder.path() / "rows.csv");
  REQUIRE(opened);
  std::string line;
  CHECK(std::getline(*opened, line));
  CHECK(line == "t,u");

  const std::filesystem::path pipe = folder.path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(open_regular(pipe).error() == pipe.string() + ": is no regular file");
  CHECK(open_regular(folder.path()).error() == folder.path().string() + ": is no regular file");
  const std::filesystem::path missing = folder.path() / "missing";
  CHECK(open_regular(missing).error() ==
        missing.string() + ": cannot be read: No such file or directory");
}

}  // namespace
}  // namespace slipbench::driver::base
