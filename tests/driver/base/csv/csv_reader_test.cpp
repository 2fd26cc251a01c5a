// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/csv_reader.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <array>
#include <catch2/catch.hpp>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <locale>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::base {
namespace {

using Names = std::vector<std::string>;
using Rows = std::vector<std::vector<double>>;

/// All rows, or the error that ends the reading.
tl::expected<Rows, HistoryError> read(const std::string& bytes, const Names& columns) {
  const TemporaryFolder folder;
  const DataSource source{folder.write("rig.csv", bytes), "rig.csv", {}};
  auto reader = CsvReader::open(source, columns);
  if (!reader) return tl::unexpected(reader.error());
  Rows rows;
  std::vector<double> row(columns.size());
  for (;;) {
    const auto next = reader->next(row);
    if (!next) return tl::unexpected(next.error());
    if (!*next) return rows;
    rows.push_back(row);
  }
}

/// "line:column: message" of the error that `bytes` get, and that it is the input's fault.
std::string error_of(const std::string& bytes, const Names& columns = {"t", "x"}) {
  const auto rows = read(bytes, columns);
  INFO(bytes);
  REQUIRE_FALSE(rows);
  CHECK(rows.error().kind == HistoryError::Kind::kInput);
  CHECK(rows.error().file == "rig.csv");
  return fmt::format("{}:{}: {}", rows.error().line, rows.error().column, rows.error().message);
}

const Rows kTwoRows = {{0.0, 1.5}, {1.0, -2.5}};

TEST_CASE("the chosen columns are read in the order in which they were asked for") {
  const std::string bytes = "t,note,x,y\n0,start,1.5,7\n1,\"a,b\"\"c\",-2.5,8\n";
  CHECK(read(bytes, {"t", "x"}).value() == kTwoRows);
  CHECK(read(bytes, {"y", "t"}).value() == Rows{{7.0, 0.0}, {8.0, 1.0}});
  CHECK(read(bytes, {"x", "t", "x"}).value() == Rows{{1.5, 0.0, 1.5}, {-2.5, 1.0, -2.5}});
}

TEST_CASE(
    "comments, CRLF, a byte order mark, blanks and the last line's missing end are accepted") {
  CHECK(read("\xef\xbb\xbft,x\r\n0,1.5\r\n1,-2.5\r\n", {"t", "x"}).value() == kTwoRows);
  CHECK(read("# rig 7\n\n# 2024\nt,x\n# start\n0,1.5\n  # pause\n1,-2.5", {"t", "x"}).value() ==
        kTwoRows);
  CHECK(read(" t , \"x\" \n 0 , 1.5 \n\"1\",\"-2.5\"\n", {"t", "x"}).value() == kTwoRows);
  CHECK(read("t,x\n0,1.5\n1,-2.5\n\n  \n\r\n", {"t", "x"}).value() == kTwoRows);
}

TEST_CASE("no other format is advised for a file whose format nobody can state: a result") {
  const TemporaryFolder folder;
  const auto fault = [&](const std::string& bytes) {
    auto reader = CsvReader::open(folder.write("run.csv", bytes), Names{"t", "x"}, "run.csv");
    if (!reader) return reader.error().message;
    std::array<double, 2> row{};
    for (;;) {
      const auto more = reader->next(row);
      if (!more) return more.error().message;
      REQUIRE(*more);
    }
  };
  CHECK(fault("t,x\n0,1\n1,nan\n") == "column 'x' holds 'nan'; a finite number is wanted");
  CHECK(fault("t,x\n0,1\n1,\n") == "column 'x' is empty");
  CHECK(fault("t,x\n0,1\n\n1,2\n") == "a blank line before the last row");
  CHECK(fault("t;x\n0;1,5\n") ==
        "column 'x' holds '1,5' with a decimal comma; the decimal mark is '.'");
}

TEST_CASE("the header shows whether commas, semicolons or tabs separate") {
  CHECK(read("t;x\n0;1.5\n1;-2.5\n", {"t", "x"}).value() == kTwoRows);
  CHECK(read("t\tx\n0\t1.5\n1\t-2.5\n", {"t", "x"}).value() == kTwoRows);
  CHECK(read("t;\"x, mm\"\n0;1.5\n1;-2.5\n", {"t", "x, mm"}).value() == kTwoRows);
  CHECK(read("x\n1.5\n2\n", {"x"}).value() == Rows{{1.5}, {2.0}});
}

TEST_CASE("a number is the double nearest to its text") {
  const Names texts = {"0",
                       "-0",
                       "+1.5",
                       ".5",
                       "5.",
                       "00.1",
                       "1e3",
                       "1E-3",
                       "0.1",
                       "123456789",
                       "1e22",
                       "1.7976931348623157e308",
                       "5e-324",
                       "1e-310",
                       "0.1000000000000000055511151231257827",
                       "9007199254740993",
                       "9007199254740992",
                       "12345678901234567890",
                       "0.00000000000000000000001",
                       "3.141592653589793"};
  for (const std::string& text : texts) {
    const auto rows = read("x\n" + text + "\n", {"x"});
    INFO(text);
    REQUIRE(rows);
    const double value = rows->front().front();
    // strtod rounds correctly too, by other code; it reads '+' and the subnormals.
    CHECK(value == std::strtod(text.c_str(), nullptr));
    CHECK(std::signbit(value) == (text[0] == '-'));
  }
}

TEST_CASE("short and long numbers agree with std::from_chars to the last bit") {
  std::mt19937_64 random(7);
  std::string bytes = "x\n";
  std::vector<double> wanted;
  for (int i = 0; i < 20000; ++i) {
    const auto digits = static_cast<std::int64_t>(random() >> (1 + random() % 60));
    std::string text = std::to_string(i % 2 == 0 ? digits : -digits);
    const std::size_t sign = text[0] == '-' ? 1 : 0;
    text.insert(sign + random() % (text.size() - sign + 1), ".");
    if (i % 5 == 0) text += fmt::format("e{}", static_cast<int>(random() % 40) - 20);
    double value = 0.0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    REQUIRE(result.ptr == text.data() + text.size());
    wanted.push_back(value);
    bytes += text + '\n';
  }
  const auto rows = read(bytes, {"x"});
  REQUIRE(rows);
  REQUIRE(rows->size() == wanted.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) different += (*rows)[i][0] == wanted[i] ? 0 : 1;
  CHECK(different == 0);
}

TEST_CASE("a file without rows or without a header is refused") {
  CHECK(error_of("") == "1:1: the file is empty; a header row and rows of numbers are wanted");
  CHECK(error_of("# only\n# comments\n") == "2:1: there is no header row with the columns' names");
  CHECK(error_of("t,x\n") == "1:1: no rows follow the header");
  CHECK(error_of("t,x\n\n# nothing\n") == "1:1: no rows follow the header");
  CHECK(error_of("0,1.5\n1,2\n") ==
        "1:1: numbers where the header row with the columns' names is wanted");
  CHECK(error_of("t,x\n[s],[mm]\n0,1\n") ==
        "2:1: column 't' holds '[s]', which is not a number; write {file: rig.csv, units_row: "
        "true}");
  CHECK(error_of("t,x\nzero,1\n") ==
        "2:1: column 't' holds 'zero', which is not a number (one header row is read, numbers "
        "follow it)");
}

TEST_CASE("a missing column is reported with the file's columns and the nearest") {
  CHECK(error_of("t,disp\n0,1\n", {"t", "dips"}) ==
        "1:1: no column 'dips'; the columns are t, disp; did you mean 'disp'?");
  CHECK(error_of("# rig\nt,y\n0,1\n", {"t", "force"}) ==
        "2:1: no column 'force'; the columns are t, y");
  CHECK(error_of("t,x,x\n0,1,2\n") == "1:1: two columns are named 'x'");
  CHECK(read("t,x,y,y\n0,1,2,3\n", {"t", "x"}).value() == Rows{{0.0, 1.0}});
}

TEST_CASE("a row with too few or too many fields is refused") {
  CHECK(error_of("t,x\n0,1\n1\n") == "3:1: 1 field where the header has 2 columns");
  CHECK(error_of("t,x\n0,1\n1,a,b\n") == "3:1: 3 fields where the header has 2 columns");
  CHECK(error_of("t,x,y\n0,1,2\n1,2\n") == "3:1: 2 fields where the header has 3 columns");
}

TEST_CASE("decimal commas are refused as such") {
  CHECK(error_of("t,x\n0,5,1,5\n") ==
        "2:1: 4 fields where the header has 2 columns (decimal commas between commas: nothing "
        "tells them apart; write the file anew with ';' between its columns)");
  CHECK(error_of("t;x\n0;1,5\n") ==
        "2:3: column 'x' holds '1,5' with a decimal comma; the decimal mark is '.'; write {file: "
        "rig.csv, decimal: \",\"}");
  CHECK(error_of("t\tx\n0\t1\n1\t1,5\n") ==
        "3:3: column 'x' holds '1,5' with a decimal comma; the decimal mark is '.'; write {file: "
        "rig.csv, decimal: \",\"}");
  CHECK(
      error_of("t,x\n0,1\n\"1,5\",2\n").find("3:2: column 't' holds '1,5' with a decimal comma") ==
      0);
}

const std::string kLeavingOut = "; write {file: rig.csv, missing: skip} to leave such rows out";
const std::string kMissing = kLeavingOut + ", or 'hold' for the value before";

TEST_CASE("a blank line between rows is refused, also one of blanks") {
  const std::string blank = "a blank line before the last row" + kLeavingOut;
  CHECK(error_of("t,x\n0,1\n\n1,2\n") == "3:1: " + blank);
  CHECK(error_of("t,x\n0,1\n \t \r\n\n1,2\n") == "3:1: " + blank);
  CHECK(error_of("t,x\n\n0,1\n") == "2:1: " + blank);
}

TEST_CASE("a trailing separator is refused, in the header and in a row") {
  CHECK(error_of("t,x,\n0,1,\n") ==
        "1:4: the header ends with a separator (','), as the rows do; to take it away: sed "
        "'s/,\\r*$//'");
  CHECK(error_of("t,x,\n0,1,7\n") ==
        "1:4: the header ends with a separator (','): its last column has no name");
  CHECK(error_of("t;x\n0;1;\n") ==
        "2:4: the row ends with a separator (';'); to take it away: sed 's/;\\r*$//'");
  CHECK(error_of("t,x\n0,1\n1,\n") == "3:3: column 'x' is empty" + kMissing);
}

TEST_CASE("what is not a finite number is refused with line and column") {
  CHECK(error_of("t,x\n0,1\n1,nan\n") ==
        "3:3: column 'x' holds 'nan'; a finite number is wanted" + kMissing);
  CHECK(error_of("t,x\n0,1\n1,-Inf\n") ==
        "3:3: column 'x' holds '-Inf'; a finite number is wanted");
  CHECK(error_of("t,x\n0,1\n1, 1e400\n") ==
        "3:4: column 'x' holds '1e400', which is outside the range of a double");
  CHECK(error_of("t,x\n0,1\n1,-1e-400\n") ==
        "3:3: column 'x' holds '-1e-400', which is outside the range of a double");
  CHECK(error_of("t,x\n0,1\n1,\n2,3\n") == "3:3: column 'x' is empty" + kMissing);
  for (const char* text : {"abc", "1.5mm", "1_000", "1.5D3", "5%", "0x10", "1/2", "--1", "+-1",
                           "1e", ".", "1.2.3", "#", "1 2"}) {
    CHECK(error_of(std::string("t,x\n0,1\n1,") + text + "\n") ==
          fmt::format("3:3: column 'x' holds '{}', which is not a number", text));
  }
  for (const char* text : {"-", "---", "NA", "n/a", "#N/A", "null", "1.#QNAN"}) {
    CHECK(error_of(std::string("t,x\n0,1\n1,") + text + "\n") ==
          fmt::format("3:3: column 'x' holds '{}', which is not a number{}", text, kMissing));
  }
  CHECK(error_of(std::string("t,x\n0,1\n1,\0002\n", 13)) ==
        "3:3: column 'x' holds '?2', which is not a number");
}

TEST_CASE("columns nobody asked for are not looked at") {
  CHECK(read("t,comment,x\n0,nan,1.5\n1,,-2.5\n", {"t", "x"}).value() == kTwoRows);
}

TEST_CASE("what is no text file of this kind is refused") {
  CHECK(error_of("t,x\r0,1\r1,2\r") ==
        "1:4: lines end with CR only; LF or CRLF is wanted: tr '\\r' '\\n' < 'rig.csv' > lf.csv");
  CHECK(error_of(std::string("\xff\xfet\0,\0x\0\n\0", 10)) ==
        "1:1: the file is UTF-16; UTF-8 is wanted: iconv -f UTF-16 -t UTF-8 'rig.csv' > utf8.csv");
  CHECK(error_of(std::string("t,x\0\n0,1\n", 9)) == "1:4: a control character: not a text file");
  CHECK(error_of("t,x\n0,1\n1," + std::string(3'000'000, '1')) ==
        "3:1: the line is longer than a megabyte: not a CSV file");
}

TEST_CASE("a file that is not there or not regular is the environment's fault, without waiting") {
  const TemporaryFolder folder;
  const Names columns = {"t"};
  const auto refusal = [&](const std::filesystem::path& file) {
    const auto reader = CsvReader::open(file, columns);
    REQUIRE_FALSE(reader);
    CHECK(reader.error().kind == HistoryError::Kind::kEnvironment);
    CHECK(reader.error().file == file.string());
    return reader.error().message;
  };
  CHECK(refusal(folder.path() / "missing.csv") == "cannot be opened: No such file or directory");
  CHECK(refusal(folder.path()) == "is a directory");
  CHECK(refusal("/dev/zero") == "is not a regular file");
  REQUIRE(::mkfifo((folder.path() / "fifo").c_str(), 0600) == 0);
  CHECK(refusal(folder.path() / "fifo") == "is not a regular file");
}

TEST_CASE("a file longer than the reader's block is read to its last row, twice") {
  const TemporaryFolder folder;
  constexpr int kRows = 40000;
  std::string bytes = "# long\nt,x\n";
  for (int i = 0; i < kRows; ++i) bytes += fmt::format("{},{}\n", i, 0.5 * i);
  auto reader = CsvReader::open(folder.write("long.csv", bytes), Names{"t", "x"});
  REQUIRE(reader);
  CHECK(reader->line() == 2);
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<double> row(2);
    int wrong = 0;
    int count = 0;
    for (auto next = reader->next(row); next && *next; next = reader->next(row), ++count) {
      wrong += row[0] == count && row[1] == 0.5 * count && reader->line() == count + 3 ? 0 : 1;
    }
    CHECK(count == kRows);
    CHECK(wrong == 0);
    CHECK(reader->next(row).value() == false);
    REQUIRE(reader->rewind());
  }
}

TEST_CASE("a row that straddles two blocks is read whole, wherever it is cut") {
  const TemporaryFolder folder;
  constexpr std::size_t kBlock = 65536;
  for (std::size_t shift = 0; shift < 24; ++shift) {
    std::string bytes = "t,x\n#";
    bytes += std::string(kBlock - 12 - shift - bytes.size(), '-') + "\n";
    bytes += "0.125,1.5\r\n1.25,-2.5\r\n";
    auto reader = CsvReader::open(folder.write("cut.csv", bytes), Names{"t", "x"});
    REQUIRE(reader);
    std::vector<double> row(2);
    REQUIRE(reader->next(row).value());
    CHECK(row == std::vector{0.125, 1.5});
    REQUIRE(reader->next(row).value());
    CHECK(row == std::vector{1.25, -2.5});
    CHECK_FALSE(reader->next(row).value());
  }
}

TEST_CASE("a decimal comma in the locale changes nothing in the numbers read") {
  struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  const auto rows = read("t,x\n0,1.5\n1,-2.5e0\n", {"t", "x"});
  std::locale::global(before);
  CHECK(rows.value() == kTwoRows);
}

TEST_CASE("an error stays an error when the next row is asked for") {
  const TemporaryFolder folder;
  auto reader = CsvReader::open(folder.write("bad.csv", "t\n0\nx\n2\n"), Names{"t"});
  REQUIRE(reader);
  std::vector<double> row(1);
  REQUIRE(reader->next(row).value());
  CHECK(reader->next(row).error().line == 3);
  CHECK(reader->next(row).error().line == 3);
}

TEST_CASE("a row also gives its fields as they are written") {
  const TemporaryFolder folder;
  const auto file = folder.write("a.csv", "a;b;c\n 1.50 ; \"-2e1\" ;x\n");
  const std::vector<std::string> columns = {"b", "a", "b"};
  auto reader = CsvReader::open(file, columns);
  REQUIRE(reader);
  std::array<double, 3> values{};
  std::array<std::string_view, 3> texts{};
  REQUIRE(reader->next(values, texts).value());
  CHECK(values == std::array<double, 3>{-20.0, 1.5, -20.0});
  CHECK(texts == std::array<std::string_view, 3>{"-2e1", "1.50", "-2e1"});
}

}  // namespace
}  // namespace slipbench::driver::base
