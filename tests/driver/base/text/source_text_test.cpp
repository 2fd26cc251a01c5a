// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/source_text.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace slipbench::driver::base {
namespace {

using namespace std::string_literals;

// An own folder that goes away with the test.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() /
              ("slipbench_source_text_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::string file(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

std::string write(const std::string& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

std::string complaint(const std::string& bytes) {
  const SourceText source("a.yaml", bytes);
  return render(check_text(source), {&source, 1});
}

void check_environment_error(const std::string& path, const std::string& message) {
  CAPTURE(path);
  const auto source = read_source(path);
  REQUIRE_FALSE(source.has_value());
  CHECK(source.error().failure == ReadFailure::kEnvironment);
  CHECK(render(source.error().diagnostic) == path + ": error: " + message + "\n");
}

TEST_CASE("A file is read as it is and keeps the name the user typed") {
  const Folder folder;
  const std::string path = write(folder.file("./a.yaml"), "a: 1\nb: 2\n");
  const auto source = read_source(path);
  REQUIRE(source.has_value());
  CHECK(source->name() == path);
  CHECK(source->text() == "a: 1\nb: 2\n");
  CHECK(source->line_count() == 2);
  CHECK(source->line(2) == "b: 2");
  CHECK(source->line(3).empty());
  CHECK(read_source(write(folder.file("empty"), "")).value().text().empty());
}

TEST_CASE("What is no regular file is an environment error, at once") {
  const Folder folder;
  check_environment_error(folder.file("missing.yaml"), "cannot be read: No such file or directory");
  check_environment_error(folder.file("."), "is a directory, not a file");
  check_environment_error("/dev/zero", "is a device, not a file");
  const std::string pipe = folder.file("pipe");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  check_environment_error(pipe, "is a pipe, not a file");
  if (::geteuid() != 0) {
    const std::string locked = write(folder.file("locked"), "a: 1\n");
    REQUIRE(::chmod(locked.c_str(), 0) == 0);
    check_environment_error(locked, "cannot be read: Permission denied");
  }
}

TEST_CASE("A file above the limit is refused by its size, before reading") {
  const Folder folder;
  const std::string path = write(folder.file("large.yaml"), "");
  // A file with a hole: reading it would take its time, asking for its size does not.
  std::filesystem::resize_file(path, (std::uintmax_t{1} << 36U) + 1);
  const auto source = read_source(path);
  REQUIRE_FALSE(source.has_value());
  CHECK(source.error().failure == ReadFailure::kBadInput);
  CHECK(render(source.error().diagnostic) ==
        path +
            ": error: is larger than the limit of 64 MiB; put long tables and histories into a "
            "CSV file\n");
  CHECK(read_source(write(path, "12345"), 5).has_value());
  CHECK(read_source(write(path, "123456"), 5).error().diagnostic.message ==
        "is larger than the limit of 5 bytes");
}

TEST_CASE("CRLF and a byte order mark leave no trace") {
  const SourceText source("a.yaml",
                          "\xEF\xBB\xBF"
                          "a: 1\r\nb: 2\r\n");
  CHECK(source.text() == "a: 1\nb: 2\n");
  CHECK(check_text(source).empty());
}

TEST_CASE("Places are counted in lines and code points") {
  const SourceText source("a.yaml", "\xC3\xA9\xC3\xA9: 1\nb\n\nc");
  CHECK(source.position(0) == SourcePosition{1, 1, 1});
  CHECK(source.position(6, 1) == SourcePosition{1, 5, 1});
  CHECK(source.position(0, 4) == SourcePosition{1, 1, 2});
  CHECK(source.position(6, 100) == SourcePosition{1, 5, 1});
  CHECK(source.position(8) == SourcePosition{2, 1, 1});
  CHECK(source.position(10) == SourcePosition{3, 1, 1});
  CHECK(source.position(11) == SourcePosition{4, 1, 1});
  CHECK(source.position(999) == SourcePosition{4, 2, 1});
  CHECK(SourceText("a", "").position(3) == SourcePosition{1, 1, 1});
}

TEST_CASE("Places in a very long line are exact and found quickly") {
  std::string text = "a\n";
  for (int i = 0; i < 500000; ++i) text += "\xC3\xA9-";
  const SourceText source("a.yaml", text + "\nb\n");
  for (int i = 0; i < 500000; i += 7) {
    const auto offset = 2 + 3 * static_cast<std::size_t>(i);
    if (source.position(offset, 3) != SourcePosition{2, 2 * i + 1, 2}) FAIL("wrong at " << i);
  }
  CHECK(source.position(2 + 1500000) == SourcePosition{2, 1000001, 1});
  CHECK(source.position(2 + 1500001) == SourcePosition{3, 1, 1});
}

TEST_CASE("Bytes that are no text are refused with their place") {
  const std::string dot = "\xEF\xBF\xBD";
  CHECK(complaint("a: \xC3\xA4\nb: \xFF\n") ==
        "a.yaml:2:4: error: byte 0xFF is not valid UTF-8; save the file as UTF-8\n"
        "    2 | b: " +
            dot + "\n      |    ^\n");
  CHECK(complaint("a: 1\nb: \0c\n"s) ==
        "a.yaml:2:4: error: NUL character; is this a text file?\n"
        "    2 | b: " +
            dot + "c\n      |    ^\n");
  CHECK(complaint("a: \x1B[0m\n") ==
        "a.yaml:1:4: error: control character U+001B; is this a text file?\n"
        "    1 | a: " +
            dot + "[0m\n      |    ^\n");
  CHECK(
      complaint("a: 1\rb: 2\r") ==
      "a.yaml:1:5: error: carriage return without a line feed; save the file with LF or CRLF line "
      "ends\n    1 | a: 1" +
          dot + "b: 2" + dot + "\n      |     ^\n");
}

TEST_CASE("Other encodings are named") {
  CHECK(complaint("\xFF\xFE"
                  "a\0:\0 \0"s)
            .starts_with("a.yaml:1:1: error: this is UTF-16 text; save it as UTF-8\n"));
  CHECK(complaint("\xFE\xFF\0a\0:"s).find("UTF-16") != std::string::npos);
  CHECK(complaint("a\0:\0 \0"
                  "1\0\n\0"s)
            .find("UTF-16") != std::string::npos);
  CHECK(complaint("\xFF\xFE\0\0a\0\0\0"s).find("UTF-32") != std::string::npos);
}

TEST_CASE("Overlong forms, surrogates and cut sequences are invalid UTF-8") {
  for (const char* bytes : {"\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                            "\xE2\x82", "\x80", "\xF8\x88\x80\x80\x80"}) {
    CAPTURE(bytes);
    CHECK(complaint(bytes).find("is not valid UTF-8") != std::string::npos);
  }
  CHECK(complaint("\xE2\x82\xAC \xF0\x9F\x98\x80 \xC2\xA7").empty());
}

TEST_CASE("A binary file gets a few messages, not thousands") {
  std::string bytes;
  for (int i = 0; i < 100000; ++i) bytes += static_cast<char>(i * 7919 % 256);
  const Diagnostics found = check_text(SourceText("a.yaml", bytes));
  CHECK(found.has_errors());
  CHECK(found.count(Severity::kError) <= 3);
}

}  // namespace
}  // namespace slipbench::driver::base
