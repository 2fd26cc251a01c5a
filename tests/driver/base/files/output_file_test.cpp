// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/output_file.hpp"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::base {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

OutputFile made(const fs::path& target, const Overwriting& overwriting = {}) {
  auto file = OutputFile::create(target, {}, overwriting);
  INFO((file ? std::string() : file.error()));
  REQUIRE(file.has_value());
  return std::move(*file);
}

void complete(OutputFile& file) {
  OutputFile* const alone[] = {&file};
  const auto committed = commit(alone);
  INFO((committed ? std::string() : committed.error()));
  REQUIRE(committed.has_value());
}

/// Tells whether the file system of the temporary folder writes files without a name.
bool has_unnamed_files() {
  const TemporaryFolder folder;
  return made(folder.path() / "one.csv").temporary().string().starts_with("/proc/");
}

}  // namespace

TEST_CASE("a file that is being written has no name, and can be read", "[files]") {
  if (!has_unnamed_files()) return;
  const TemporaryFolder folder;
  OutputFile file = made(folder.path() / "one.csv");
  file.append("all of it");
  REQUIRE(file.close().has_value());
  CHECK(names_in(folder.path()).empty());
  CHECK(text_of(file.temporary()) == "all of it");
  complete(file);
  CHECK(names_in(folder.path()) == std::vector<std::string>{"one.csv"});
  CHECK(text_of(folder.path() / "one.csv") == "all of it");
}

TEST_CASE("a file takes the place of another in one step", "[files]") {
  const TemporaryFolder folder;
  const fs::path target = folder.write("one.csv", "before");
  OutputFile file = made(target, {.force = true});
  file.append("after");
  CHECK(text_of(target) == "before");
  complete(file);
  CHECK(text_of(target) == "after");
  CHECK(names_in(folder.path()) == std::vector<std::string>{"one.csv"});
}

TEST_CASE("what a killed program left between two calls is in nobody's way", "[files]") {
  const TemporaryFolder folder;
  const fs::path target = folder.write("one.csv", "before");
  if (has_unnamed_files()) folder.write(".one.csv.new", "of a killed program");
  OutputFile file = made(target, {.force = true});
  file.append("after");
  complete(file);
  CHECK(text_of(target) == "after");
  CHECK(names_in(folder.path()) == std::vector<std::string>{"one.csv"});
}

TEST_CASE("a file that a library writes by its name has one", "[files]") {
  const TemporaryFolder folder;
  OutputFile file = made(folder.path() / "one.h5");
  REQUIRE(file.need_name().has_value());
  CHECK(file.temporary().parent_path() == folder.path());
  CHECK(names_in(folder.path()).size() == 1);
  std::ofstream(file.temporary()) << "of a library";
  complete(file);
  CHECK(names_in(folder.path()) == std::vector<std::string>{"one.h5"});
  CHECK(text_of(folder.path() / "one.h5") == "of a library");
}

TEST_CASE("a dropped file leaves neither itself nor the folders made for it", "[files]") {
  const TemporaryFolder folder;
  {
    OutputFile file = made(folder.path() / "new" / "inner" / "one.csv");
    file.append("half of");
  }
  CHECK(names_in(folder.path()).empty());
}

TEST_CASE("a folder stays as long as a file without a name is written in it", "[files]") {
  const TemporaryFolder folder;
  OutputFile first = made(folder.path() / "new" / "first.csv");
  first.append("first");
  { const OutputFile dropped = made(folder.path() / "new" / "dropped.csv"); }
  complete(first);
  CHECK(names_in(folder.path() / "new") == std::vector<std::string>{"first.csv"});
}

TEST_CASE("a folder that another program has removed is made again", "[files]") {
  const TemporaryFolder folder;
  if (!has_unnamed_files()) return;
  OutputFile file = made(folder.path() / "new" / "one.csv");
  file.append("first");
  fs::remove(folder.path() / "new");
  complete(file);
  CHECK(text_of(folder.path() / "new" / "one.csv") == "first");
}

TEST_CASE("a write that fails is told, and nothing is there", "[files]") {
  const TemporaryFolder folder;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 4096;
  setrlimit(RLIMIT_FSIZE, &small);
  std::string message;
  {
    OutputFile file = made(folder.path() / "one.csv");
    file.append(std::string(10'000, 'x'));
    OutputFile* const alone[] = {&file};
    if (const auto committed = commit(alone); !committed) message = committed.error();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(message == (folder.path() / "one.csv").string() + ": cannot be written: File too large");
  CHECK(names_in(folder.path()).empty());
}

}  // namespace slipbench::driver::base
