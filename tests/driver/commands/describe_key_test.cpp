// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/describe_key.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <map>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include "driver/base/text/source_text.hpp"
#include "driver/calibrate/fit_reference.hpp"
#include "driver/calibrate/fit_text.hpp"
#include "driver/read/keys/case_codecs.hpp"
#include "driver/read/keys/case_reference.hpp"
#include "driver/read/keys/key_examples.hpp"
#include "driver/read/keys/key_index.hpp"
#include "driver/yaml/parse.hpp"
#include "law/connection/connection_type.hpp"
#include "law/friction/law_list.hpp"
#include "tests/driver/commands/program_for_test.hpp"

namespace slipbench::driver::commands {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A path as a user types it: without the marks of lists, of names and of types.
std::string typed(std::string path) {
  for (const char* mark : {"[]", "NAME."}) {
    for (std::size_t at = 0; (at = path.find(mark)) != std::string::npos;) {
      path.erase(at, std::string(mark).size());
    }
  }
  for (std::size_t at = 0; (at = path.find(" (")) != std::string::npos;) {
    path.erase(at, path.find(')') + 1 - at);
  }
  for (std::size_t at = 0; (at = path.find('|')) != std::string::npos;) {
    path.erase(at, std::min(path.find('.', at), path.size()) - at);
  }
  return path;
}

using Reader = std::function<bool(yaml::Binder&, const yaml::Node&, const yaml::Path&)>;

/// Collects how the reader reads each key, by paths as the rows have them.
struct Readers {
  std::map<std::string, Reader> by_path;

  template <class T>
  void add_struct(const std::string& path) {
    yaml::for_each_key<T>([&](std::string_view key, auto member, const yaml::KeyInfo& info) {
      using Member = std::remove_reference_t<decltype(std::declval<T&>().*member)>;
      const std::string here = path.empty() ? std::string(key) : path + "." + std::string(key);
      by_path[here] = [info](yaml::Binder& binder, const yaml::Node& node, const yaml::Path& at) {
        Member value{};
        return yaml::Codec<Member>::read(binder, node, at, info, value);
      };
      add_below(here, std::type_identity<Member>{});
    });
  }

  template <class T>
  void add_below(const std::string& path, std::type_identity<yaml::At<T>>) {
    add_below(path, std::type_identity<T>{});
  }
  template <class T>
  void add_below(const std::string& path, std::type_identity<std::optional<T>>) {
    add_below(path, std::type_identity<T>{});
  }
  template <class T>
  void add_below(const std::string& path, std::type_identity<std::vector<yaml::Named<T>>>) {
    add_below(path + ".NAME", std::type_identity<T>{});
  }
  template <class T>
  void add_below(const std::string& path, std::type_identity<std::vector<T>>) {
    add_below(path + "[]", std::type_identity<T>{});
  }
  template <class T>
  void add_below(const std::string& path, std::type_identity<T>) {
    if constexpr (yaml::Declared<T> || yaml::HasFields<T>) add_struct<T>(path);
  }
};

Readers all_readers() {
  Readers readers;
  readers.add_struct<read::CaseText>("");
  readers.add_struct<calibrate::FitText>("");
  readers.add_struct<read::StepText>("history[]");
  readers.add_struct<read::MeasuredText>("history");
  readers.add_struct<read::TableText>("friction[].internal_contact_force");
  readers.add_struct<read::OrthotropicText>("friction[].coefficient.orthotropic");
  readers.add_struct<read::DirectionDependentText>("friction[].coefficient.direction_dependent");
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    (readers.add_below("friction[].coefficient." + std::string(Law::kName),
                       std::type_identity<Law>{}),
     ...);
  }(std::type_identity<law::LawList>{});
  law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    readers.add_below("friction[].predefined (" + std::string(Type::kInfo.name) + ")",
                      std::type_identity<Type>{});
  });
  return readers;
}

/// The reader of a row: coefficients and tables are the same wherever they stand. Null for the
/// parts of profiles and of columns with a unit and for the names of laws, which nothing reads
/// alone.
Reader reader_of(const Readers& readers, const std::string& path) {
  std::vector<std::string> places{path};
  const std::size_t coefficient = path.find(".coefficient.");
  if (coefficient != std::string::npos) places.push_back("friction[]" + path.substr(coefficient));
  if (const std::size_t dot = path.rfind('.'); dot != std::string::npos) {
    places.push_back("friction[].internal_contact_force" + path.substr(dot));
  }
  for (const std::string& place : places) {
    const auto found = readers.by_path.find(place);
    if (found != readers.by_path.end()) return found->second;
  }
  return nullptr;
}

/// Returns what the reader says of an example; empty if nothing.
std::string faults_of_example(const Reader& reader, const std::string& example) {
  const base::SourceText source("c.yaml", "value: " + example + "\n");
  const auto tree = yaml::parse_yaml(source);
  if (!tree) return base::render(tree.error());
  base::Diagnostics out;
  const base::NamedNumbers parameters;
  yaml::Binder binder(out, parameters, {}, {}, false, read::kCaseWords);
  const bool good = reader(binder, *tree->root().find("value"), yaml::Path());
  return good && !out.has_errors() ? "" : "not read: " + base::render(out);
}

void check_rows(const std::vector<yaml::KeyRow>& rows) {
  const Readers readers = all_readers();
  REQUIRE(rows.size() > 20);
  for (const yaml::KeyRow& row : rows) {
    INFO(row.path);
    const std::string text = describe_entries(typed(row.path));
    CHECK(contains(text, "\n  type       "));
    CHECK(contains(text, "\n  unit       "));
    CHECK(contains(text, row.info.required ? "\n  required\n" : "\n  default: "));
    CHECK(contains(text, std::string(row.info.text)));
    const std::string example = read::example_of(row, rows);
    CHECK_FALSE(example.empty());
    CHECK(contains(text, ": " + example + "\n"));
    const Reader reader = reader_of(readers, row.path);
    const bool of_column = row.path.ends_with(".column") || row.path.ends_with(".unit");
    const bool alone = !of_column && row.path.find("temperature.") == std::string::npos &&
                       row.info.default_text != "-";
    CHECK((reader || !alone));
    if (reader) CHECK(faults_of_example(reader, example).empty());
  }
}

TEST_CASE("describe knows every key of cases and fits, with an example that the reader takes") {
  check_rows(read::case_rows());
  check_rows(calibrate::fit_rows());
}

TEST_CASE("an example that the reader refuses would be noticed") {
  const Reader reader = reader_of(all_readers(), "friction[].stick.elastic_slip");
  REQUIRE(reader);
  CHECK(faults_of_example(reader, "0.1").empty());
  CHECK(contains(faults_of_example(reader, "-0.1"), "must be greater than 0, found -0.1"));
}

TEST_CASE("describe tells a key by its name and by the end of its path, in its place") {
  const std::string expected =
      "elastic_slip (key of a case)\n"
      "  Allowable elastic slip g_c, in place of the slip tolerance.\n"
      "  stands in  friction[].stick and history[].change_friction.NAME.stick\n"
      "  type       a number, greater than 0\n"
      "  unit       length [L], such as mm\n"
      "  default: slip_tolerance * characteristic_length\n"
      "  example\n"
      "    friction:\n"
      "      - stick:\n"
      "          elastic_slip: 0.1\n";
  CHECK(describe_entries("elastic_slip") == expected);
  CHECK(describe_entries("stick.elastic_slip") == expected);
  CHECK(contains(describe_entries("friction[0].stick.elastic_slip"),
                 "  stands in  friction[].stick\n"));
  CHECK(describe_entries("history.elastic_slip").empty());
  // The same word means other things elsewhere.
  const std::string step = describe_entries("step");
  CHECK(contains(step, "stands in  history[]\n"));
  CHECK(contains(step, "stands in  checks[]\n"));
  CHECK(contains(describe_entries("stiffness"), "force/length [F L^-1], such as N/mm"));
  CHECK(contains(describe_entries("vary"), "vary (key of a fit)"));
  CHECK(contains(describe_entries("vary"), "    start "));
}

TEST_CASE("a name that describe does not know is answered by five at most") {
  const TemporaryFolder folder;
  const auto answer = [&](const std::string& name) {
    const Ended ended = slipbench(folder, "describe " + name);
    CHECK(ended.code == 2);
    return ended.output;
  };
  CHECK(contains(answer("coeficient"), "'coeficient'; did you mean 'coefficient'"));
  CHECK(contains(answer("HING"), "did you mean 'HINGE'"));
  CHECK(contains(answer("qqqqqqqq"), "'qqqqqqqq'; 'slipbench list' shows what there is\n"));
  for (const char* name : {"coeficient", "HING", "CRF", "contact", "elasti"}) {
    const std::string text = answer(name);
    CHECK(std::count(text.begin(), text.end(), '\'') <= 2 * (1 + 5));
  }
}

}  // namespace
}  // namespace slipbench::driver::commands
