// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/results/events.hpp"
#include "driver/results/row_writer.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::results {
namespace {

namespace fs = std::filesystem;

const base::FileMark kMark{"a text of this test", "mine", ""};

void complete(base::OutputFile& file) {
  base::OutputFile* const files[] = {&file};
  REQUIRE(base::commit(files));
}

std::string fault_of(const fs::path& target, const std::vector<std::string>& inputs = {}) {
  const auto file = base::OutputFile::create(target, {}, {.inputs = inputs});
  return file ? "" : file.error();
}

TEST_CASE("a file has its name only once it is complete") {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "a.csv";
  {
    auto file = base::OutputFile::create(target, kMark);
    REQUIRE(file);
    file->append("text\n");
    CHECK_FALSE(fs::exists(target));
    complete(*file);
    CHECK(file_text(target) == "text\n");
  }
  CHECK(file_count(folder.path()) == 1);
}

TEST_CASE("a file that is dropped leaves nothing, and what was there stays") {
  const TemporaryFolder folder;
  const fs::path target = folder.write("a.csv", "mine before");
  {
    auto file = base::OutputFile::create(target, kMark);
    REQUIRE(file);
    file->append(std::string(1 << 20, 'x'));
  }
  CHECK(file_text(target) == "mine before");
  CHECK(file_count(folder.path()) == 1);
}

TEST_CASE("two programs may write the same file at once: the last one to end counts, whole") {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "a.csv";
  auto first = base::OutputFile::create(target, kMark);
  auto second = base::OutputFile::create(target, kMark);
  REQUIRE(first);
  REQUIRE(second);
  first->append("mine, first");
  second->append("mine, second");
  complete(*second);
  complete(*first);
  CHECK(file_text(target) == "mine, first");
}

TEST_CASE("a new file is as readable as any other") {
  const TemporaryFolder folder;
  const mode_t before = umask(022);
  auto file = base::OutputFile::create(folder.path() / "a.csv", kMark);
  umask(before);
  REQUIRE(file);
  complete(*file);
  CHECK(fs::status(folder.path() / "a.csv").permissions() == fs::perms(0644));
}

TEST_CASE("what cannot be a result file is refused before anything is written") {
  const TemporaryFolder folder;
  const std::string base = folder.path().string();
  folder.write("plain", "");
  fs::create_directory(folder.path() / "d.csv");
  fs::create_symlink("/dev/full", folder.path() / "full.csv");
  CHECK(fault_of(folder.path() / "plain" / "a.csv") ==
        base + "/plain/a.csv: " + base + "/plain is not a folder");
  CHECK(fault_of(folder.path() / "d.csv") == base + "/d.csv: is a folder");
  CHECK(fault_of(folder.path() / "full.csv") == base + "/full.csv: is no regular file");
  CHECK(file_count(folder.path()) == 3);
}

TEST_CASE("an input is never overwritten, whatever it is called") {
  const TemporaryFolder folder;
  const std::string input = folder.write("rig.csv", "data").string();
  fs::create_hard_link(input, folder.path() / "same.csv");
  CHECK_FALSE(fault_of(folder.path() / "rig.csv", {input}).empty());
  CHECK_FALSE(fault_of(folder.path() / "same.csv", {input}).empty());
  CHECK(fault_of(folder.path() / "other.csv", {input}).empty());
  CHECK(file_text(input) == "data");
}

TEST_CASE("a name that is a link stays one, and the file it leads to is written") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "store");
  const fs::path real = folder.write("store/real.csv", "mine");
  fs::create_symlink("store/real.csv", folder.path() / "link.csv");
  fs::create_symlink("link.csv", folder.path() / "link_to_link.csv");
  fs::create_symlink("store/new.csv", folder.path() / "to_new.csv");
  for (const char* name : {"link_to_link.csv", "to_new.csv"}) {
    auto file = base::OutputFile::create(folder.path() / name, kMark);
    REQUIRE(file);
    CHECK(file->target() == folder.path() / name);
    // A file without a name is shown by a link of /proc.
    const fs::path written =
        fs::is_symlink(file->temporary()) ? fs::read_symlink(file->temporary()) : file->temporary();
    CHECK(written.parent_path() == folder.path() / "store");
    file->append("after");
    complete(*file);
    CHECK(fs::is_symlink(folder.path() / name));
  }
  CHECK(file_text(real) == "after");
  CHECK(file_text(folder.path() / "store/new.csv") == "after");
  CHECK(file_count(folder.path()) == 4);
}

TEST_CASE("links in a circle, pipes and links to open files are refused") {
  const TemporaryFolder folder;
  fs::create_symlink("b", folder.path() / "a");
  fs::create_symlink("a", folder.path() / "b");
  CHECK(fault_of(folder.path() / "a").find("a: cannot be written: ") != std::string::npos);
  REQUIRE(mkfifo((folder.path() / "pipe").c_str(), 0600) == 0);
  CHECK(fault_of(folder.path() / "pipe") ==
        (folder.path() / "pipe").string() + ": is no regular file");
  // As /dev/stdout is, while standard output goes to a file.
  const fs::path open_file = folder.write("open", "kept");
  const int descriptor = ::open(open_file.c_str(), O_RDONLY | O_CLOEXEC);
  REQUIRE(descriptor >= 0);
  fs::create_symlink("/proc/self/fd/" + std::to_string(descriptor), folder.path() / "out");
  CHECK(fault_of(folder.path() / "out") ==
        (folder.path() / "out").string() + ": is no regular file");
  ::close(descriptor);
  CHECK(file_text(open_file) == "kept");
}

TEST_CASE("two names are one file if they lead to it, be it there or not") {
  const TemporaryFolder folder;
  folder.write("a", "");
  fs::create_directory(folder.path() / "d");
  fs::create_directory_symlink("d", folder.path() / "e");
  fs::create_symlink("d/new", folder.path() / "link");
  const fs::path& base = folder.path();
  CHECK(base::is_same_file(base / "a", base / "d/../a"));
  CHECK(base::is_same_file(base / "d/new", base / "e/new"));
  CHECK(base::is_same_file(base / "link", base / "e/new"));
  CHECK_FALSE(base::is_same_file(base / "a", base / "d/new"));
  CHECK_FALSE(base::is_same_file(base / "d/new", base / "new"));
}

TEST_CASE("who completes files waits for those that hold the folder") {
  const TemporaryFolder folder;
  auto file = base::OutputFile::create(folder.path() / "a.csv", kMark);
  REQUIRE(file);
  const fs::path places[] = {folder.path() / "other.csv"};
  std::atomic<bool> released{false};
  std::jthread other;
  {
    const base::FolderLocks locks(places);
    other = std::jthread([&] {
      base::OutputFile* const files[] = {&*file};
      CHECK(base::commit(files));
      CHECK(released);
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    released = true;
  }
  other.join();
  CHECK(fs::exists(folder.path() / "a.csv"));
}

TEST_CASE("a file takes the place of one with its mark or without a byte, and of no other") {
  const TemporaryFolder folder;
  const fs::path target = folder.write("a.csv", "rig data\n");
  const std::string kept = target.string() +
                           ": is there already and is not a text of this test, and is kept; choose "
                           "another folder or name, or replace it with --force";
  CHECK(base::target_fault(target, kMark) == kept);
  CHECK(base::OutputFile::create(target, kMark).error() == kept);
  CHECK(base::target_fault(target, {}) ==
        target.string() +
            ": is there already, and is kept; choose another folder or name, or "
            "replace it with --force");
  CHECK(base::target_fault(target, kMark, {.force = true}).empty());
  const std::vector<std::string> inputs = {target.string()};
  CHECK_FALSE(base::target_fault(target, kMark, {.inputs = inputs, .force = true}).empty());
  folder.write("a.csv", "mine");
  CHECK(base::target_fault(target, kMark).empty());
  CHECK_FALSE(base::target_fault(target, {}).empty());
  folder.write("a.csv", "");
  CHECK(base::target_fault(target, {}).empty());
  CHECK(file_count(folder.path()) == 1);
}

TEST_CASE("a mark is looked for at both ends of a file, and nowhere between them") {
  const TemporaryFolder folder;
  const std::string filling(10 * base::kMarkedBytes, 'x');
  const base::FileMark mark{"mine", "%PDF", "slipbench picture (a)"};
  CHECK(base::carries(folder.write("head", "%PDF" + mark.text + filling), mark));
  CHECK(base::carries(folder.write("tail", "%PDF" + filling + mark.text + "\n"), mark));
  CHECK_FALSE(base::carries(folder.write("middle", "%PDF" + filling + mark.text + filling), mark));
  CHECK_FALSE(base::carries(folder.write("other", "%PNG" + filling + mark.text), mark));
  CHECK_FALSE(base::carries(folder.path() / "missing", mark));
}

TEST_CASE("a sealed text carries its mark only as it was made, whatever its line ends") {
  const TemporaryFolder folder;
  const base::FileMark mark{.owner = "", .start = "# mine", .sealed = true};
  for (const std::string text : {"# mine\na: 1\n", "# mine\r\na: 1\r\n", "# mine\na: 1"}) {
    INFO(text);
    CHECK_FALSE(base::carries(folder.write("a.yaml", text), mark));
    CHECK(base::carries(folder.write("a.yaml", base::sealed(text)), mark));
    CHECK(base::carries(folder.write("a.yaml", base::sealed(base::sealed(text))), mark));
    CHECK_FALSE(base::carries(folder.write("a.yaml", base::sealed(text) + "# more\n"), mark));
    std::string changed = base::sealed(text);
    changed[changed.find('1')] = '2';
    CHECK_FALSE(base::carries(folder.write("a.yaml", changed), mark));
  }
  CHECK(base::sealed("a: 1\r\n").ends_with("\r\n"));
}

TEST_CASE("a file that comes while another is written is kept, and so are all that go with it") {
  const TemporaryFolder folder;
  auto first = base::OutputFile::create(folder.path() / "a.csv", kMark);
  auto second = base::OutputFile::create(folder.path() / "b.csv", kMark);
  REQUIRE(first);
  REQUIRE(second);
  folder.write("b.csv", "rig data\n");
  base::OutputFile* const files[] = {&*first, &*second};
  CHECK_FALSE(base::commit(files));
  CHECK_FALSE(fs::exists(folder.path() / "a.csv"));
  CHECK(file_text(folder.path() / "b.csv") == "rig data\n");
}

TEST_CASE("missing folders are made, and go again with a file that did not come about") {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "new" / "deep" / "a.csv";
  CHECK(base::target_fault(target, kMark).empty());
  CHECK(file_count(folder.path()) == 0);
  {
    auto first = base::OutputFile::create(target, kMark);
    auto second = base::OutputFile::create(target.parent_path() / "b.csv", kMark);
    REQUIRE(second);
    const auto moved = std::move(first);  // the first goes before the last
  }
  CHECK(file_count(folder.path()) == 0);
  auto file = base::OutputFile::create(target, kMark);
  REQUIRE(file);
  file->append("mine");
  complete(*file);
  CHECK(file_text(target) == "mine");
}

std::string written_rows(const cases::Case& problem, const fs::path& target) {
  auto file = base::OutputFile::create(target, kMark);
  REQUIRE(file);
  const auto writer =
      RowWriter::create(problem, output_columns(problem), table::TableFormat::kCsv, *file);
  REQUIRE(writer);
  for (const bench::Row& row : bench::rows_of(problem)) (*writer)->write(row);
  REQUIRE((*writer)->finish());
  complete(*file);
  return file_text(target);
}

TEST_CASE("rows are written with their origin, a header and the shortest numbers") {
  const TemporaryFolder folder;
  cases::Case problem = bench::slider_case({bench::step("slide", 2, 0, history::LinearTo{0.1})});
  problem.output_columns = {"CP1", "CSF1", "STATUS"};
  const std::string text = written_rows(problem, folder.path() / "a.csv");
  const std::string start = text.substr(0, text.find('\n'));
  CHECK(start.starts_with("# slipbench "));
  CHECK(text.substr(start.size()) ==
        "\n# case: slider.yaml\n# title: Slider\n# units: length mm, force N, time s\n"
        "# parameters: mu = 0.2\n# friction: sleeve = CSF1\n"
        "# columns: t [s], CP1 [mm], CSF1 [N], STATUS []\n"
        "t,CP1,CSF1,STATUS\n0,0,0,1\n0.5,0.05,20,2\n1,0.1,20,2\n");
}

TEST_CASE("the same case gives the same bytes") {
  const TemporaryFolder folder;
  const cases::Case problem = bench::slider_case(
      {bench::step("cycle", 50, 0, history::Wave{history::WaveShape::kSine, 0.1, 1.0, 0.0, 0.3})});
  CHECK(written_rows(problem, folder.path() / "a.csv") ==
        written_rows(problem, folder.path() / "b.csv"));
}

TEST_CASE("events are the changes of regime, the first slip included") {
  const TemporaryFolder folder;
  const cases::Case problem =
      bench::slider_case({bench::step("out", 4, 0, history::LinearTo{0.1}),
                          bench::step("back", 8, 0, history::LinearTo{-0.1})});
  auto file = base::OutputFile::create(folder.path() / "a.csv", kMark);
  REQUIRE(file);
  EventWriter writer(problem, *file);
  for (const bench::Row& row : bench::rows_of(problem)) writer.write({&row, 1});
  complete(*file);
  std::string text = file_text(folder.path() / "a.csv");
  text.erase(0, text.find("\nt,") + 1);
  // Out: slip from 0.02 mm on. Back: from the turn at t = 1 it sticks over 0.04 mm of 0.2 mm.
  CHECK(text.find("t,definition,from,to,force,limit,accumulated_slip,CP1\n"
                  "0.2,sleeve,stick,slip,20,20,0,0.02") == 0);
  CHECK(text.find("\n1,sleeve,slip,stick,20,20,0.08,0.1\n1.2") != std::string::npos);
  std::size_t lines = 0;
  for (const char c : text) lines += c == '\n' ? 1 : 0;
  CHECK(lines == 4);
  CHECK(text.find(",sleeve,stick,slip,-20,20,0.08") != std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::results
