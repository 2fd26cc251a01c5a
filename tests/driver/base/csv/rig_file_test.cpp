// SPDX-License-Identifier: Apache-2.0
// Files of numbers as rigs write them: read as a data source says, or refused with what it should.
#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "driver/base/csv/csv_reader.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::base {
namespace {

using Names = std::vector<std::string>;
using Rows = std::vector<std::vector<double>>;

const Rows kTwoRows = {{0.0, 1.5}, {1.0, -2.5}};

struct ReadFile {
  Rows rows;
  std::string missing;  ///< in words
  std::string fault;    ///< "line:column: message"; empty if it was read to its end
};

ReadFile read(const std::string& bytes, const CsvFormat& format,
              const Names& columns = {"t", "x"}) {
  const TemporaryFolder folder;
  ReadFile result;
  const auto fail = [&](const HistoryError& error) {
    result.fault = fmt::format("{}:{}: {}", error.line, error.column, error.message);
    return result;
  };
  auto reader = CsvReader::open({folder.write("rig.csv", bytes), "rig.csv", format}, columns);
  if (!reader) return fail(reader.error());
  std::vector<double> row(columns.size());
  for (;;) {
    const auto more = reader->next(row);
    if (!more) return fail(more.error());
    if (!*more) break;
    result.rows.push_back(row);
  }
  result.missing = in_words(reader->missing(), format.missing);
  return result;
}

TEST_CASE("decimal commas are read where the source says so, to the last bit") {
  CHECK(read("t;x\n0;1,5\n1,0;-2,5e0\n", {.decimal = ','}).rows == kTwoRows);
  CHECK(read("t\tx\n0\t1,5\n1\t-2,5\n", {.decimal = ','}).rows == kTwoRows);
  CHECK(read("x\n1,5\n-2,5\n", {.decimal = ','}, {"x"}).rows == Rows{{1.5}, {-2.5}});
  CHECK(
      read("x\n3,141592653589793238\n1,7976931348623157e308\n-4,9E-324\n", {.decimal = ','}, {"x"})
          .rows == Rows{{3.141592653589793}, {1.7976931348623157e308}, {-5e-324}});
  CHECK(read("t;x\n0;1.5\n", {.decimal = ','}).fault ==
        "2:3: column 'x' holds '1.5' with a decimal point; the decimal mark is ','; write {file: "
        "rig.csv}");
}

TEST_CASE("the separator is the stated one, and blanks separate in runs of any length") {
  CHECK(read("t;x,y\n0;1.5\n1;-2.5\n", {.separator = ';'}, {"t", "x,y"}).rows == kTwoRows);
  CHECK(read("  t   x \t note\n 0  1.5 \t a\n\t1  -2.5   b  \n", {.separator = ' '}).rows ==
        kTwoRows);
  CHECK(read("t \"x y\"\n0 1.5\n1 -2.5\n", {.separator = ' '}, {"t", "x y"}).rows == kTwoRows);
  CHECK(read("t (s)  x [mm]\n0 1.5\n1 -2.5\n", {.separator = ' '}).rows == kTwoRows);
  CHECK(read("t x\n0 1.5\n1\n", {.separator = ' '}).fault ==
        "3:1: 1 field where the header has 2 columns");
  CHECK(read("t x\n0 1.5\n", {}).fault ==
        "1:1: no column 't'; the columns are t x; write {file: rig.csv, separator: space}");
  CHECK(read("t,a;x,b;y\n0;1.5;2\n", {}, {"t,a", "x,b"}).fault == "");
  CHECK(read("t,a,b;x,c,d\n0;1.5\n", {}, {"t,a,b", "x,c,d"}).fault ==
        "1:1: no column 't,a,b'; the columns are t, a, b;x, c, d; write {file: rig.csv, separator: "
        "\";\"}");
}

TEST_CASE("lines before the header are passed over, and their number is found") {
  const std::string bytes =
      "Rig 7; operator Meier\r\nsampled; 2 kHz\r\n\r\n# a comment\r\nt;x\r\n0;1,5\r\n1;-2,5\r\n";
  CHECK(read(bytes, {.decimal = ',', .skip = 2}).rows == kTwoRows);
  CHECK(read(bytes, {.decimal = ',', .skip = 4}).rows == kTwoRows);
  CHECK(read(bytes, {}).fault ==
        "1:1: no column 't'; the columns are Rig 7, operator Meier; write {file: rig.csv, decimal: "
        "\",\", skip: 2}");
  CHECK(read(bytes, {.decimal = ',', .skip = 5}).fault ==
        "6:1: numbers where the header row with the columns' names is wanted; write {file: "
        "rig.csv, decimal: \",\", skip: 2}");
  CHECK(read("t,x\n0,1\n", {.skip = 9}).fault ==
        "2:1: there is no header row: the file has 2 lines, and 'skip' passes over 9; write {file: "
        "rig.csv}");
}

TEST_CASE("the advised number of lines leaves what states the units") {
  const TemporaryFolder folder;
  const std::string bytes = "Rig 7\n# columns: t [s], F [kN]\n\nt,F\n0,0.1\n1,0.2\n";
  CHECK(read(bytes, {}, {"t", "F"}).fault.ends_with("; write {file: rig.csv, skip: 1}"));
  const auto reader =
      CsvReader::open({folder.write("rig.csv", bytes), "", {.skip = 1}}, Names{"t", "F"});
  REQUIRE(reader);
  CHECK(reader->unit("F") == "kN");
}

TEST_CASE("another decimal mark is advised if the whole row has it, and thousands are told") {
  const std::string bytes = "t;x;F\n0,0;0,00;1.100\n";
  const Names names{"t", "x", "F"};
  CHECK(read(bytes, {}, names).fault ==
        "2:1: column 't' holds '0,0' with a decimal comma; the decimal mark is '.'");
  CHECK(read(bytes, {.decimal = ','}, names).fault ==
        "2:10: column 'F' holds '1.100' with a decimal point; the decimal mark is ','; a '.' "
        "between thousands is left out");
  CHECK(read("t;F\n0;1.100\n", {.decimal = ','}, {"t", "F"}).fault ==
        "2:3: column 'F' holds '1.100' with a decimal point; the decimal mark is ','; write {file: "
        "rig.csv}, but a '.' between thousands is left out");
  CHECK(read("t;F\n0;0.125\n", {.decimal = ','}, {"t", "F"}).fault ==
        "2:3: column 'F' holds '0.125' with a decimal point; the decimal mark is ','; write {file: "
        "rig.csv}");
}

TEST_CASE("what is missing is told, and whether it is most of the file") {
  const TemporaryFolder folder;
  const auto told = [&](const std::string& bytes, MissingSample answer) {
    const DataSource source{folder.write("rig.csv", bytes), "", {.missing = answer}};
    return count_missing(source, Names{"t", "x"}).value();
  };
  CHECK(told("t,x\n0,1\n1,\n2,3\n", MissingSample::kSkip) ==
        "1 row was left out, as it lacks a sample (line 3)");
  CHECK(told("t,x\n0,1\n1,\n2,\n", MissingSample::kSkip) ==
        "2 rows were left out, as they lack a sample (first in line 3); that is most of the file");
  CHECK(told("t,x\n0,1\n1,\n2,\n", MissingSample::kHold) ==
        "2 missing samples were held at the values before (first in line 3)");
}

TEST_CASE("the unit of a column is that of the row of units, or stands behind its name") {
  const TemporaryFolder folder;
  const auto unit = [&](const std::string& bytes, const CsvFormat& format, const char* column) {
    const auto reader = CsvReader::open({folder.write("rig.csv", bytes), "", format}, {});
    REQUIRE(reader);
    return std::string(reader->unit(column));
  };
  CHECK(read("t;x\n[s];mm\n0;1.5\n1;-2.5\n", {.units_row = true}).rows == kTwoRows);
  CHECK(unit("t;x\n[s];mm\n0;1\n", {.units_row = true}, "t") == "s");
  CHECK(unit("t;x\n(s);mm\n0;1\n", {.units_row = true}, "x") == "mm");
  CHECK(unit("t;x\n;-\n0;1\n", {.units_row = true}, "x") == "-");
  CHECK(unit("t;T\ns;\xb0"
             "C\n0;1\n",
             {.units_row = true}, "T") == "°C");
  CHECK(unit("Time (s),u [mm],Force / kN,v(mm/s)\n0,1,2,3\n", {}, "Time") == "s");
  CHECK(unit("Time (s),u [mm],Force / kN,v(mm/s)\n0,1,2,3\n", {}, "u [mm]") == "mm");
  CHECK(unit("Time (s),u [mm],Force / kN,v(mm/s)\n0,1,2,3\n", {}, "Force") == "kN");
  CHECK(unit("Time (s),u [mm],Force / kN,v(mm/s)\n0,1,2,3\n", {}, "v") == "mm/s");
  CHECK(unit("t,Force (left),Sensor (2)\n0,1,2\n", {}, "Force (left)") == "");
  CHECK(unit("t,Force (left),Sensor (2)\n0,1,2\n", {}, "Sensor (2)") == "");

  CHECK(read("t;x\n0;1\n", {.units_row = true}).fault ==
        "2:1: numbers where 'units_row' says the units of the columns stand; write {file: "
        "rig.csv}");
  CHECK(read("t;x\ns\n0;1\n", {.units_row = true}).fault ==
        "2:1: 1 field in the row of units where the header has 2 columns");
  CHECK(read("t;x\n", {.units_row = true}).fault == "1:1: no row of units follows the header");
}

TEST_CASE("a column is asked for by its name without the unit, unless that might be two") {
  CHECK(read("t (s),x (mm),x (in)\n0,1.5,9\n1,-2.5,9\n", {}, {"t", "x (mm)"}).rows == kTwoRows);
  CHECK(read("x,t,x (mm)\n1.5,0,9\n-2.5,1,9\n", {}).rows == kTwoRows);
  CHECK(read("t (s),x (mm),x (in)\n0,1,2\n", {}).fault ==
        "1:1: 'x' may be 'x (mm)' or 'x (in)': write one of them");
  CHECK(read("t,x (left)\n0,1\n", {}).fault == "1:1: no column 'x'; the columns are t, x (left)");
  // Names in Latin-1 are those of the case's UTF-8.
  CHECK(read("t;Gr\xf6\xdf"
             "e\n0;1.5\n1;-2.5\n",
             {}, {"t", "Größe"})
            .rows == kTwoRows);
}

TEST_CASE("rows that lack a sample are left out, and counted") {
  const auto file = read("t;x;y\n0;1.5;\n0.2;;1\n0.4;nan;1\n0.6;-;1\n0.8;NaN;1\n\n \n1;-2.5;\n",
                         {.missing = MissingSample::kSkip});
  CHECK(file.fault == "");
  CHECK(file.rows == kTwoRows);
  CHECK(file.missing == "6 rows were left out, as they lack a sample (first in line 3)");
  CHECK(read("t;x\n0;1.5\n;3\n1;-2.5\n", {.missing = MissingSample::kSkip}).missing ==
        "1 row was left out, as it lacks a sample (line 3)");
  CHECK(read("t;x\n0;\n1;\n", {.missing = MissingSample::kSkip}).fault ==
        "1:1: every row lacks a sample, so none is left");
  CHECK(read("t;x\n0;1\n1;abc\n", {.missing = MissingSample::kSkip}).fault ==
        "3:3: column 'x' holds 'abc', which is not a number");
  CHECK(read("t;x\n0;1\n1\n", {.missing = MissingSample::kSkip}).fault ==
        "3:1: 1 field where the header has 2 columns");
}

TEST_CASE("a missing sample is held at the value before, and counted") {
  const auto file =
      read("t;x;t\n0;1.5;\n1;;\n2;nan;\n3;4;\n", {.missing = MissingSample::kHold}, {"x"});
  CHECK(file.fault == "");
  CHECK(file.rows == Rows{{1.5}, {1.5}, {1.5}, {4.0}});
  CHECK(file.missing == "2 missing samples were held at the values before (first in line 3)");
  CHECK(read("t;x\n0;1\n1;\n", {.missing = MissingSample::kHold}).missing ==
        "1 missing sample was held at the value before (line 3)");
  CHECK(read("t;x\n0;\n1;2\n", {.missing = MissingSample::kHold}).fault ==
        "2:3: column 'x' has no value before the first row to hold; write {file: rig.csv, missing: "
        "skip} to leave such rows out");
  CHECK(read("t;x\n0;1\n\n1;2\n", {.missing = MissingSample::kHold}).fault ==
        "3:1: a blank line before the last row; write {file: rig.csv, missing: skip} to leave such "
        "rows out");
}

TEST_CASE("a reader that starts anew holds and counts as at first") {
  const TemporaryFolder folder;
  const std::string bytes = "t;x\ns;mm\n0;7\n1;\n";
  auto reader = CsvReader::open(
      {folder.write("rig.csv", bytes), "", {.units_row = true, .missing = MissingSample::kHold}},
      Names{"t", "x"});
  REQUIRE(reader);
  for (int pass = 0; pass < 2; ++pass) {
    std::array<double, 2> row{};
    REQUIRE(reader->next(row).value());
    CHECK(reader->line() == 3);
    REQUIRE(reader->next(row).value());
    CHECK(row == std::array{1.0, 7.0});
    CHECK_FALSE(reader->next(row).value());
    CHECK(reader->missing().count == 1);
    REQUIRE(reader->rewind());
    CHECK(reader->missing().count == 0);
  }
}

TEST_CASE("a source is written as a case would state it") {
  CHECK(in_words("rig.csv", {}) == "{file: rig.csv}");
  CHECK(in_words("a b, c's.csv", {}) == "{file: 'a b, c''s.csv'}");
  CHECK(in_words("x.txt", {',', '\t', 3, true, MissingSample::kHold}) ==
        "{file: x.txt, decimal: \",\", separator: tab, skip: 3, units_row: true, missing: hold}");
}

}  // namespace
}  // namespace slipbench::driver::base
