// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/output_file.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "tests/driver/support/temporary_folder.hpp"

namespace {

/// Failures of the file system that a test asks for: of new names with this part in them.
struct Failing {
  std::string part = {};
  int error = 0;
  bool fails(const char* name) const {
    if (part.empty() || std::string_view(name).find(part) == std::string_view::npos) return false;
    errno = error;
    return true;
  }
};
Failing failing_links, failing_renames;

/// Errors of waiting for a disk, and of closing a second descriptor of a file; 0 for none.
int failing_sync = 0;
int failing_close = 0;
/// Steps of writing, in their order, if a test wants them: "file", "name", "folder".
std::vector<std::string>* done = nullptr;

bool is_folder(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode);
}

}  // namespace

// These take the place of the C library's in the whole program, and do what it does.
// NOLINTBEGIN(readability-identifier-naming)
extern "C" int linkat(int from, const char* source, int to, const char* name, int flags) noexcept {
  if (failing_links.fails(name)) return -1;
  if (done != nullptr) done->emplace_back("name");
  return static_cast<int>(syscall(SYS_linkat, from, source, to, name, flags));
}
extern "C" int renameat2(int from, const char* source, int to, const char* name,
                         unsigned int flags) noexcept {
  if (failing_renames.fails(name)) return -1;
  return static_cast<int>(syscall(SYS_renameat2, from, source, to, name, flags));
}
extern "C" int rename(const char* source, const char* name) noexcept {
  if (failing_renames.fails(name)) return -1;
  return static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, source, AT_FDCWD, name, 0U));
}
extern "C" int fsync(int descriptor) {
  if (done != nullptr) done->emplace_back(is_folder(descriptor) ? "folder" : "file");
  if (failing_sync != 0) {
    errno = failing_sync;
    return -1;
  }
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}
extern "C" int close(int descriptor) {
  struct stat status {};
  const bool fails =
      failing_close != 0 && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  const int result = static_cast<int>(syscall(SYS_close, descriptor));
  if (!fails) return result;
  errno = failing_close;
  return -1;
}
// NOLINTEND(readability-identifier-naming)

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

TEST_CASE("hidden files and folders of others are in nobody's way, and stay", "[files]") {
  const TemporaryFolder folder;
  const fs::path target = folder.write("one.csv", "before");
  folder.write(".one.csv.new", "precious");
  fs::create_directory(folder.path() / ".two.csv.new");
  OutputFile one = made(target, {.force = true});
  OutputFile two = made(folder.path() / "two.csv");
  one.append("after");
  OutputFile* const both[] = {&one, &two};
  REQUIRE(commit(both).has_value());
  CHECK(text_of(target) == "after");
  CHECK(text_of(folder.path() / ".one.csv.new") == "precious");
  CHECK(names_in(folder.path()) ==
        std::vector<std::string>{".one.csv.new", ".two.csv.new", "one.csv", "two.csv"});
}

/// Completes one new file, one in the place of another, and one more new one; returns the error.
std::string committed_three(const TemporaryFolder& folder) {
  folder.write("b.csv", "before");
  std::vector<OutputFile> files;
  for (const char* name : {"a.csv", "b.csv", "c.csv"}) {
    files.push_back(made(folder.path() / name, {.force = true}));
    files.back().append(std::string(600'000, *name));
  }
  OutputFile* const all[] = {&files[0], &files[1], &files[2]};
  const auto committed = commit(all);
  return committed ? "" : committed.error();
}

TEST_CASE("where one of several files cannot be named none is, and what was there is", "[files]") {
  for (const bool link : {true, false}) {
    if (link && !has_unnamed_files()) continue;
    for (const char* name : {"a.csv", "b.csv", "c.csv"}) {
      const TemporaryFolder folder;
      INFO(link << name);
      // New ones are renamed as well where no file gets a second name.
      failing_links = link ? Failing{name, ENOSPC} : Failing{"csv", EPERM};
      if (!link) failing_renames = {name, ENOSPC};
      const std::string error = committed_three(folder);
      failing_links = failing_renames = {};
      CHECK(error ==
            (folder.path() / name).string() + ": cannot be written: No space left on device");
      CHECK(names_in(folder.path()) == std::vector<std::string>{"b.csv"});
      CHECK(text_of(folder.path() / "b.csv") == "before");
    }
  }
}

TEST_CASE("where the file in another's place cannot be renamed, new ones are gone again",
          "[files]") {
  const TemporaryFolder folder;
  failing_renames = {"b.csv", ENOSPC};
  const std::string error = committed_three(folder);
  failing_renames = {};
  CHECK(error ==
        (folder.path() / "b.csv").string() + ": cannot be written: No space left on device");
  CHECK(names_in(folder.path()) == std::vector<std::string>{"b.csv"});
  CHECK(text_of(folder.path() / "b.csv") == "before");
}

TEST_CASE("bytes are on the disk before a name is, and names at the end", "[files]") {
  if (!has_unnamed_files()) return;
  const TemporaryFolder folder;
  std::vector<std::string> steps;
  done = &steps;
  const std::string error = committed_three(folder);
  done = nullptr;
  CHECK(error.empty());
  // The hidden name of b.csv, then those of the new files.
  CHECK(steps ==
        std::vector<std::string>{"file", "file", "file", "name", "name", "name", "folder"});
}

TEST_CASE("what the disk refuses at the end is told, and nothing is named", "[files]") {
  for (int* const failing : {&failing_sync, &failing_close}) {
    const TemporaryFolder folder;
    *failing = EIO;
    const std::string error = committed_three(folder);
    *failing = 0;
    CHECK(error == (folder.path() / "a.csv").string() + ": cannot be written: Input/output error");
    CHECK(names_in(folder.path()) == std::vector<std::string>{"b.csv"});
    CHECK(text_of(folder.path() / "b.csv") == "before");
  }
  // Some file systems cannot wait, and say so.
  const TemporaryFolder folder;
  failing_sync = EINVAL;
  CHECK(committed_three(folder).empty());
  failing_sync = 0;
}

TEST_CASE("where a file has one name only, it is copied to it", "[files]") {
  for (const int error : {EPERM, EOPNOTSUPP}) {
    const TemporaryFolder folder;
    failing_links = {"csv", error};
    CHECK(committed_three(folder).empty());
    OutputFile alone = made(folder.path() / "alone.csv");
    alone.append("alone");
    complete(alone);
    failing_links = {};
    CHECK(text_of(folder.path() / "b.csv") == std::string(600'000, 'b'));
    CHECK(text_of(folder.path() / "alone.csv") == "alone");
    CHECK(names_in(folder.path()) ==
          std::vector<std::string>{"a.csv", "alone.csv", "b.csv", "c.csv"});
  }
}

TEST_CASE("a name that is too long is refused before anything is written", "[files]") {
  const TemporaryFolder folder;
  const std::string longest(255, 'n');
  for (const std::string& before : {std::string(), std::string("mine")}) {
    if (!before.empty()) folder.write(longest, before);
    OutputFile file = made(folder.path() / longest, {.force = true});
    file.append("after");
    complete(file);
    CHECK(text_of(folder.path() / longest) == "after");
  }
  OutputFile named = made(folder.path() / longest, {.force = true});
  REQUIRE(named.need_name().has_value());
  complete(named);
  CHECK(names_in(folder.path()).size() == 1);
  const fs::path target = folder.path() / "new" / (longest + "n");
  const std::string fault = target.string() + ": cannot be written: File name too long";
  CHECK(target_fault(target, {}) == fault);
  CHECK(OutputFile::create(target, {}).error() == fault);
  CHECK_FALSE(fs::exists(folder.path() / "new"));
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
