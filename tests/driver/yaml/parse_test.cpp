// SPDX-License-Identifier: Apache-2.0
#include "driver/yaml/parse.hpp"

#include <catch2/catch.hpp>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

namespace slipbench::driver::yaml {
namespace {

using namespace std::string_literals;

// One line for a whole tree: texts as they are, quoted ones in quotes, nulls as "null".
std::string outline(const Node& node) {
  std::string result;
  switch (node.kind()) {
    case NodeKind::kNull:
      return "null";
    case NodeKind::kScalar:
      return node.quoted() ? "\"" + std::string(node.text()) + "\"" : std::string(node.text());
    case NodeKind::kSequence:
      for (const Node item : node.items()) result += (result.empty() ? "" : ", ") + outline(item);
      return "[" + result + "]";
    case NodeKind::kMap:
      break;
  }
  for (const Entry entry : node.entries()) {
    result += (result.empty() ? "" : ", ") + std::string(entry.key.text()) + ": ";
    result += outline(entry.value);
  }
  return "{" + result + "}";
}

std::string outline(const std::string& text) {
  const auto tree = parse_yaml(base::SourceText("c.yaml", text));
  return tree ? outline(tree->root()) : base::render(tree.error());
}

// The messages for a bad text as the user sees them; empty if it is not bad.
std::string complaint(const std::string& text) {
  const base::SourceText source("c.yaml", text);
  const auto tree = parse_yaml(source);
  return tree ? "" : base::render(tree.error(), {&source, 1});
}

Tree parsed(const std::string& text) {
  auto tree = parse_yaml(base::SourceText("c.yaml", text));
  REQUIRE(tree.has_value());
  return *tree;
}

/// Seconds of the processor: other work on the machine does not count.
double seconds(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST_CASE("Maps, lists and texts become a tree") {
  CHECK(outline("a: 1\nb: [x, {c: 2}]\nd:\n  - e\n  - f: g\n    h: i\n") ==
        "{a: 1, b: [x, {c: 2}], d: [e, {f: g, h: i}]}");
  CHECK(outline("a:\n- 1\n- 2\nb: 3\n") == "{a: [1, 2], b: 3}");
  CHECK(outline("---\na: 1\n...\n") == "{a: 1}");
  CHECK(outline("{\"a\": 1,\n\"b\": [1, \"x\"]}\n") == "{a: 1, b: [1, \"x\"]}");
  CHECK(outline("a: [\n  [1, 2],\n  [3, 4],\n]\n") == "{a: [[1, 2], [3, 4]]}");
  CHECK(outline("a: {}\nb: []\nc: ''\n") == "{a: {}, b: [], c: \"\"}");
  CHECK(outline("a: 1 # one\n\n# two\nb: x#y\n") == "{a: 1, b: x#y}");
}

TEST_CASE("Numbers, truth values and expressions stay texts") {
  CHECK(outline("a: 010\nb: yes\nc: = 2/li\nd: [= r, -1e3, +.5]\ne: .nan\n") ==
        "{a: 010, b: yes, c: = 2/li, d: [= r, -1e3, +.5], e: .nan}");
}

TEST_CASE("Quotes and block texts are resolved and marked as quoted") {
  CHECK(outline("a: \"x\\ty\\u00e9\"\nb: 'it''s'\nc: \"5\"\n") ==
        "{a: \"x\ty\xC3\xA9\", b: \"it's\", c: \"5\"}");
  CHECK(outline("a: |\n  one: [1, 2]\n  \"two\n\n   three\nb: >-\n  x\n  y\n") ==
        "{a: \"one: [1, 2]\n\"two\n\n three\n\", b: \"x y\"}");
  CHECK(outline("- 1") == outline("- 1\n"));
}

TEST_CASE("A text may go on over several lines") {
  CHECK(outline("why: the force\n  wears, that's [1, 2, 3] \"all\"\n  of it\nb: 2\n") ==
        "{why: the force wears, that's [1, 2, 3] \"all\" of it, b: 2}");
  CHECK(outline("why:\n  on its\n  own lines\nb: \"one\n  two\"\n") ==
        "{why: on its own lines, b: \"one two\"}");
}

TEST_CASE("Rows of numbers are read in every layout") {
  CHECK(outline("r: [[1,2],[ 3 , -4.5e1 ],[6]]\n") == "{r: [[1, 2], [3, -4.5e1], [6]]}");
  CHECK(outline("r:\n  - [1, 2]\n  - [= x, 2]\n  - [3, 4] # c\n") ==
        "{r: [[1, 2], [= x, 2], [3, 4]]}");
  CHECK(outline("r: &r [1, 2]\nq: *r\n") == "{r: [1, 2], q: [1, 2]}");
  CHECK(outline("r: {a: [1, 2], b: [3, x]}\ns: [4, 5]\n") ==
        "{r: {a: [1, 2], b: [3, x]}, s: [4, 5]}");
}

TEST_CASE("CRLF and a byte order mark change nothing") {
  CHECK(outline("\xEF\xBB\xBF"
                "a: 1\r\nb: |\r\n  x\r\n  y\r\n") == "{a: 1, b: \"x\ny\n\"}");
}

TEST_CASE("Nodes are found by key, index and loop") {
  const Tree tree = parsed("a: 1\nb: [x, y]\n");
  const Node root = tree.root();
  REQUIRE(root.size() == 2);
  CHECK(root.find("a")->text() == "1");
  CHECK_FALSE(root.find("c").has_value());
  CHECK_FALSE(root.find("a")->find("x").has_value());
  CHECK((*root.find("b"))[1].text() == "y");
  CHECK(root[1].is_sequence());
  CHECK(root.entry(1).key.text() == "b");
  CHECK(root.find("a")->size() == 0);
  CHECK(root.text().empty());
  CHECK(name_of(root[1].kind()) == "a list");
}

TEST_CASE("Every node knows its place and length") {
  const Tree tree = parsed(
      "gr\xC3\xB6\xC3\x9F"
      "e: 1.25\nq: \"a b\" # c\nl: [10, {k: v}]\nm:\n  n: 'x'\n");
  const Node root = tree.root();
  CHECK(root.entry(0).key.where() == base::SourcePosition{1, 1, 5});
  CHECK(root[0].where() == base::SourcePosition{1, 8, 4});
  CHECK(root[1].where() == base::SourcePosition{2, 4, 5});
  CHECK(root[2].where() == base::SourcePosition{3, 4, 1});
  CHECK(root[2][0].where() == base::SourcePosition{3, 5, 2});
  CHECK(root[2][1].where() == base::SourcePosition{3, 9, 1});
  CHECK(root[2][1][0].where() == base::SourcePosition{3, 13, 1});
  CHECK(root[3].where() == base::SourcePosition{5, 3, 1});
  CHECK(root[3][0].where() == base::SourcePosition{5, 6, 3});
}

TEST_CASE("A value left empty is shown at its key or dash") {
  const Tree tree =
      parsed("a:\nb: null\nc: ~ # x\nd:\n  -\n  # c\n  - 1\n  - # - y\n\n  -\n\"e f\":\n");
  const Node root = tree.root();
  CHECK(root[0].is_null());
  CHECK(root[0].text().empty());
  CHECK(root[0].where() == base::SourcePosition{1, 1, 1});
  CHECK(root[1].text() == "null");
  CHECK(root[1].where() == base::SourcePosition{2, 4, 1});
  CHECK(root[2].text() == "~");
  CHECK(root[2].where() == base::SourcePosition{3, 4, 1});
  const Node list = *root.find("d");
  REQUIRE(list.size() == 4);
  CHECK(list[0].where() == base::SourcePosition{5, 3, 1});
  CHECK(list[2].where() == base::SourcePosition{8, 3, 1});
  CHECK(list[3].where() == base::SourcePosition{10, 3, 1});
  CHECK(root[4].where() == base::SourcePosition{11, 1, 5});
}

TEST_CASE("An alias stands for its anchor but points at itself") {
  const Tree tree =
      parsed("a: &a 5\nb: *a\nc: &c {d: &d [1, 2]}\ne: *c\nf: [*d, *a]\ng: &g\nh: *g\n");
  const Node root = tree.root();
  CHECK(outline(root) ==
        "{a: 5, b: 5, c: {d: [1, 2]}, e: {d: [1, 2]}, f: [[1, 2], 5], g: null, h: null}");
  CHECK(root[0].where() == base::SourcePosition{1, 7, 1});
  CHECK(root[1].where() == base::SourcePosition{2, 4, 2});
  CHECK(root[3].where() == base::SourcePosition{4, 4, 2});
  CHECK(root[3][0][1].where() == base::SourcePosition{3, 18, 1});
  CHECK(root[4][1].where() == base::SourcePosition{5, 9, 2});
  CHECK(root[6].where() == base::SourcePosition{7, 4, 2});
}

TEST_CASE("Paths are written as messages show them") {
  CHECK((Path{} / "friction" / 0 / "coefficient").text() == "friction[0].coefficient");
  CHECK((Path{} / "parameters" / "my mu").text() == "parameters.'my mu'");
  CHECK((Path{} / 2).text() == "[2]");
  CHECK(Path{}.text().empty());
}

struct Bad {
  std::string text;
  std::string message;
};

void check_all(const std::vector<Bad>& all) {
  for (const Bad& bad : all) {
    CAPTURE(bad.text);
    CHECK(complaint(bad.text) == bad.message);
  }
}

TEST_CASE("Duplicate keys are errors that name both lines") {
  check_all({{"a: 1\nb:\n  - c: 1\n    d: 2\n    c: 3\na: 4\na: 5\n",
              "c.yaml:5:5: error: b[0].c: duplicate key, first given in line 3\n"
              "    5 |     c: 3\n      |     ^\n"
              "c.yaml:6:1: error: a: duplicate key, first given in line 1\n"
              "    6 | a: 4\n      | ^\n"
              "c.yaml:7:1: error: a: duplicate key, first given in line 1\n"
              "    7 | a: 5\n      | ^\n"},
             {"m: {x: 1, \"x\": 2}\n",
              "c.yaml:1:11: error: m.x: duplicate key, first given in line 1\n"
              "    1 | m: {x: 1, \"x\": 2}\n      |           ^~~\n"}});
}

TEST_CASE("A quote that is not closed is shown where it opens") {
  const std::string what =
      " is not closed; close it in this line, or indent the lines that belong to the text\n";
  check_all(
      {{"a: \"Shock\nunits: 1\nname: \"x\"\nb: 2\n",
        "c.yaml:1:4: error: the quote \"" + what + "    1 | a: \"Shock\n      |    ^\n"},
       {"a: 'Shock\n",
        "c.yaml:1:4: error: the quote '" + what + "    1 | a: 'Shock\n      |    ^\n"},
       {"a: {b: \"x, c: 1}\nd: 2\n",
        "c.yaml:1:8: error: the quote \"" + what + "    1 | a: {b: \"x, c: 1}\n      |        ^\n"},
       {"- s: \"press\n  d: \"1\"\n",
        "c.yaml:1:6: error: the quote \"" + what + "    1 | - s: \"press\n      |      ^\n"},
       {"a: \"x\" y\n",
        "c.yaml:1:8: error: text after the closing quote; write a quote inside the text as \\\"\n"
        "    1 | a: \"x\" y\n      |        ^\n"},
       {"'b':2\n", "c.yaml:1:4: error: missing blank after ':'\n    1 | 'b':2\n      |    ^\n"},
       {"a: \"x\\qy\"\n",
        "c.yaml:1:8: error: unknown escape in a quoted text; in single quotes a backslash is only "
        "a backslash\n    1 | a: \"x\\qy\"\n      |        ^\n"}});
}

TEST_CASE("A missing colon is shown at the word that lacks it") {
  check_all(
      {{"a:\n  b: 1\nword\n",
        "c.yaml:3:1: error: missing ':' after 'word'\n    3 | word\n      | ^~~~\n"},
       {"a: 1\nword", "c.yaml:2:1: error: missing ':' after 'word'\n    2 | word\n      | ^~~~\n"},
       {"a:\n  type SLOT\n  r: 1\n",
        "c.yaml:2:3: error: missing ':' after 'type SLOT'\n    2 |   type SLOT\n      |   "
        "^~~~~~~~~\n"},
       {"a: 1\nb 2\nc: 3\nd 4\n",
        "c.yaml:2:1: error: missing ':' after 'b 2'\n    2 | b 2\n      | ^~~\n"
        "c.yaml:4:1: error: missing ':' after 'd 4'\n    4 | d 4\n      | ^~~\n"},
       {"a: {b: 1, c 2, d}\n",
        "c.yaml:1:11: error: a: missing ':' after 'c 2'\n    1 | a: {b: 1, c 2, d}\n      |        "
        "   ^~~\n"
        "c.yaml:1:16: error: a: missing ':' after 'd'\n    1 | a: {b: 1, c 2, d}\n"
        "      |                ^\n"},
       {"a: 1\nb:2\n",
        "c.yaml:2:1: error: missing blank after ':'; write 'b: 2'\n    2 | b:2\n      | ^~~\n"},
       {"a:1\n",
        "c.yaml:1:1: error: a map ('key: value') is wanted, this is a text; a blank stands after "
        "the ':' "
        "of a key\n    1 | a:1\n      | ^~~\n"}});
}

TEST_CASE("Brackets that do not match are shown where they stand") {
  check_all({{"a: [1,2\nb: 3\nc: {x: 1\n",
              "c.yaml:1:4: error: '[' is not closed; line 2 begins something new\n"
              "    1 | a: [1,2\n      |    ^\n"
              "c.yaml:3:4: error: '{' is not closed; the file ends before\n"
              "    3 | c: {x: 1\n      |    ^\n"},
             {"a: {b: [1, 2}\nc: 1\n",
              "c.yaml:1:8: error: '[' is not closed; '}' on line 1 comes before\n"
              "    1 | a: {b: [1, 2}\n      |        ^\n"},
             {"a: [1, 2]]\n",
              "c.yaml:1:10: error: ']' without '['\n    1 | a: [1, 2]]\n      |          ^\n"},
             {"a: {b: 1 c: 2}\n",
              "c.yaml:1:11: error: ',' or '}' is wanted before this\n    1 | a: {b: 1 c: 2}\n"
              "      |           ^\n"},
             {"a: [1,,2]\n",
              "c.yaml:1:7: error: a[1]: nothing stands before this ','\n    1 | a: [1,,2]\n      | "
              "      ^\n"},
             {"a: {x: 1, , y: 2}\n",
              "c.yaml:1:11: error: a: nothing stands before this ','\n    1 | a: {x: 1, , y: 2}\n"
              "      |           ^\n"},
             {"a: [= max(1, 2), 3]\n",
              "c.yaml:1:5: error: the ',' cuts the expression '= max(1' in two; put the whole "
              "expression in "
              "quotes\n    1 | a: [= max(1, 2), 3]\n      |     ^~~~~~~\n"}});
}

TEST_CASE("A second document is refused where it begins") {
  const std::string what = "a second document begins here; one file holds one document\n";
  check_all({{"a: 1\n---\nb: 2\n", "c.yaml:2:1: error: " + what + "    2 | ---\n      | ^~~\n"},
             {"---\na: 1\n---\n", "c.yaml:3:1: error: " + what + "    3 | ---\n      | ^~~\n"},
             {"a: 1\n...\nb: 2\n", "c.yaml:3:1: error: " + what + "    3 | b: 2\n      | ^~~~\n"},
             {"%YAML 1.2\n---\na: 1\n",
              "c.yaml:1:1: error: directives are not accepted; remove this line\n"
              "    1 | %YAML 1.2\n      | ^~~~~~~~~\n"}});
}

TEST_CASE("A file must hold a map") {
  const std::string empty =
      "c.yaml:1:1: error: the file is empty; nothing but blanks and comments is in it\n";
  const auto null_at = [](const std::string& column) {
    return "c.yaml:1:" + column + ": error: a map ('key: value') is wanted, this is null\n";
  };
  check_all(
      {{"", empty + "    1 | \n      | ^\n"},
       {"\n\n", empty + "    1 | \n      | ^\n"},
       {"# only\n", empty + "    1 | # only\n      | ^\n"},
       {"---\n", null_at("4") + "    1 | ---\n      |    ^\n"},
       {"~\n", null_at("1") + "    1 | ~\n      | ^\n"},
       {"- a\n- b\n",
        "c.yaml:1:1: error: a map ('key: value') is wanted, this is a list\n"
        "    1 | - a\n      | ^\n"},
       {"[1, 2]\n",
        "c.yaml:1:1: error: a map ('key: value') is wanted, this is a list\n"
        "    1 | [1, 2]\n      | ^\n"},
       {"some text\n",
        "c.yaml:1:1: error: a map ('key: value') is wanted, this is a text; a ':' and a blank "
        "stand after a key\n    1 | some text\n      | ^~~~~~~~~\n"}});
}

TEST_CASE("Indentation that cannot be meant is an error at its line") {
  check_all({{"a: 1\n\tb: 2\n\tc: 3\n",
              "c.yaml:2:1: error: tab in the indentation; indent with blanks (1 more line)\n"
              "    2 |  b: 2\n      | ^\n"},
             {"a:\n  \tb: 2\n",
              "c.yaml:2:3: error: tab in the indentation; indent with blanks\n    2 |    b: 2\n    "
              "  |   ^\n"},
             {"a:\n\xC2\xA0 b: 2\n",
              "c.yaml:2:1: error: no-break space in the indentation; indent with blanks\n"
              "    2 | \xC2\xA0 b: 2\n      | ^\n"},
             {"a: 1\n  b: 2\n",
              "c.yaml:2:3: error: 'b' stands below a value and is indented like a part of it; line "
              "1 already "
              "has the value '1'; keys of one map stand in one column, items begin with '- '\n    "
              "2 |   b: 2\n      |   ^\n"},
             {"a:\n    b: 1\n  c: 2\n",
              "c.yaml:3:3: error: this does not continue what stands above; check the indentation\n"
              "    3 |   c: 2\n      |   ^\n"},
             {"- a\nb: 1\n",
              "c.yaml:2:1: error: this does not belong to what stands above; one file holds one "
              "map; check "
              "the indentation\n    2 | b: 1\n      | ^\n"},
             {"a: b: c\n",
              "c.yaml:1:5: error: a second ':' in one line; put a text that holds ': ' in quotes\n"
              "    1 | a: b: c\n      |     ^\n"},
             {"a: -\n",
              "c.yaml:1:4: error: a list's '- ' cannot stand here; begin it on a line of its own\n"
              "    1 | a: -\n      |    ^\n"},
             {"a: @x\n",
              "c.yaml:1:4: error: '@' cannot begin a text; put the text in quotes\n"
              "    1 | a: @x\n      |    ^\n"}});
}

TEST_CASE("Bytes that are no text are refused before anything else") {
  check_all({{"a: 1\rb: 2\r",
              "c.yaml:1:5: error: carriage return without a line feed; save the file with LF or "
              "CRLF line "
              "ends\n    1 | a: 1\xEF\xBF\xBD"
              "b: 2\xEF\xBF\xBD\n      |     ^\n"},
             {"a: \0\n"s,
              "c.yaml:1:4: error: NUL character; is this a text file?\n"
              "    1 | a: \xEF\xBF\xBD\n      |    ^\n"}});
}

TEST_CASE("Tags, merge keys and keys that are no words are refused") {
  check_all({{"a: !!str 5\nb: !foo {x: 1}\nc: ! z\n",
              "c.yaml:1:4: error: the tag '!!str' is not accepted; remove it\n"
              "    1 | a: !!str 5\n      |    ^~~~~\n"
              "c.yaml:2:4: error: the tag '!foo' is not accepted; remove it\n"
              "    2 | b: !foo {x: 1}\n      |    ^~~~\n"
              "c.yaml:3:4: error: the tag '!' is not accepted; remove it\n"
              "    3 | c: ! z\n      |    ^\n"},
             {"<<: {a: 1}\nb: {<<: 3}\n",
              "c.yaml:1:1: error: the merge key '<<' is not accepted; write the keys out\n"
              "    1 | <<: {a: 1}\n      | ^~\n"
              "c.yaml:2:5: error: b: the merge key '<<' is not accepted; write the keys out\n"
              "    2 | b: {<<: 3}\n      |     ^~\n"},
             {"[a, b]: 1\n{x: 1}: 2\n~: 3\nc: &c 4\n*c : 5\n",
              "c.yaml:1:1: error: a list cannot be a key; write a word\n"
              "    1 | [a, b]: 1\n      | ^\n"
              "c.yaml:2:1: error: a map cannot be a key; write a word\n"
              "    2 | {x: 1}: 2\n      | ^\n"
              "c.yaml:3:1: error: a null cannot be a key; write a word\n"
              "    3 | ~: 3\n      | ^\n"
              "c.yaml:5:1: error: an alias cannot be a key\n"
              "    5 | *c : 5\n      | ^~\n"},
             {": 1\nb: {c: : 2}\n",
              "c.yaml:1:1: error: nothing stands before this ':'; a key is wanted\n"
              "    1 | : 1\n      | ^\n"
              "c.yaml:2:8: error: b.c: nothing stands before this ':'; a key is wanted\n"
              "    2 | b: {c: : 2}\n      |        ^\n"},
             {"? a\n: b\n",
              "c.yaml:1:1: error: an explicit key '?' is not accepted; write 'key: value'\n"
              "    1 | ? a\n      | ^\n"}});
}

TEST_CASE("Aliases that lead nowhere or back to themselves are refused") {
  check_all({{"a: &x [*x]\nb: *x\n",
              "c.yaml:1:8: error: a[0]: the alias '*x' stands inside what it stands for\n"
              "    1 | a: &x [*x]\n      |        ^~\n"},
             {"a: {b: *y}\n",
              "c.yaml:1:8: error: the alias '*y' is not defined; '&y' must stand before it\n"
              "    1 | a: {b: *y}\n      |        ^~\n"}});
}

TEST_CASE("Nesting deeper than 64 is refused, at any depth in no time") {
  CHECK(complaint("a: " + std::string(63, '[') + std::string(63, ']') + "\n").empty());
  const std::clock_t start = std::clock();
  for (const int depth : {65, 1000, 1000000}) {
    const auto size = static_cast<std::size_t>(depth);
    CHECK(complaint("a: " + std::string(size, '[')).find("nested deeper than 64") !=
          std::string::npos);
    CHECK(complaint("a: " + std::string(size, '{')).find("nested deeper than 64") !=
          std::string::npos);
    std::string dashes;
    for (int i = 0; i < depth; ++i) dashes += "- ";
    CHECK(complaint(dashes).find("nested deeper than 64") != std::string::npos);
  }
  std::string block;
  for (std::size_t i = 0; i < 70; ++i) block += std::string(i, ' ') + "a:\n";
  CHECK(complaint(block).find("c.yaml:65:65: error: nested deeper than 64\n") == 0);
  // Aliases must not build what brackets may not.
  std::string chain = "a0: &a0 [x]\n";
  for (int i = 1; i < 70; ++i) {
    const std::string name = "a" + std::to_string(i);
    chain += name + ": &" + name + " [*a" + std::to_string(i - 1) + "]\n";
  }
  CHECK(complaint(chain).find("c.yaml:64:12: error: nested deeper than 64\n") == 0);
  CHECK(seconds(start) < 5.0);
}

TEST_CASE("An alias bomb is refused before it goes off") {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 20; ++i) {
    const std::string name = "a" + std::to_string(i);
    bomb += name + ": &" + name + " [";
    for (int k = 0; k < 10; ++k) bomb += (k > 0 ? ", *a" : "*a") + std::to_string(i - 1);
    bomb += "]\n";
  }
  const std::clock_t start = std::clock();
  const std::string message = complaint(bomb);
  CHECK(seconds(start) < 1.0);
  CHECK(message.find(
            "c.yaml:6:45: error: a5[7]: the aliases of this file stand for more than 1000000 "
            "values\n") == 0);
}

TEST_CASE("Independent errors are told in one go") {
  const std::string message = complaint("a: 1\na: 2\nb: !!int 3\nc: {d 4}\ne: *e\nf: \"x\ng: 1\n");
  CHECK(message.find("c.yaml:2:1: error: a: duplicate key") != std::string::npos);
  CHECK(message.find("c.yaml:3:4: error: the tag '!!int'") != std::string::npos);
  CHECK(message.find("c.yaml:4:5: error: c: missing ':' after 'd 4'") != std::string::npos);
  CHECK(message.find("c.yaml:5:4: error: the alias '*e' is not defined") != std::string::npos);
  CHECK(message.find("c.yaml:6:4: error: the quote \" is not closed") != std::string::npos);
}

TEST_CASE("A flood of errors costs neither time nor memory") {
  std::string text = "m: {";
  for (int i = 0; i < 200000; ++i) text += "a: 1, ";
  text += "}\n";
  for (int i = 0; i < 100000; ++i) text += "word\n";
  const std::clock_t start = std::clock();
  const base::SourceText source("c.yaml", text);
  const auto tree = parse_yaml(source);
  REQUIRE_FALSE(tree.has_value());
  CHECK(tree.error().sorted().size() <= base::Diagnostics::kMaxKept);
  CHECK(base::render(tree.error(), {&source, 1}).size() < 10000);
  CHECK(seconds(start) < 10.0);
}

TEST_CASE("A table of a hundred thousand rows is read quickly and keeps its places") {
  std::string text = "rows:\n";
  for (int i = 0; i < 100000; ++i) text += "  - [" + std::to_string(i) + ", 0.25, 1e3, -4, 5]\n";
  const std::clock_t start = std::clock();
  const Tree tree = parsed(text);
  CHECK(seconds(start) < 5.0);
  const Node rows = *tree.root().find("rows");
  REQUIRE(rows.size() == 100000);
  CHECK(rows[99999].size() == 5);
  CHECK(rows[99999][0].text() == "99999");
  CHECK(rows[99999][3].text() == "-4");
  CHECK(rows[99999][3].where() == base::SourcePosition{100001, 24, 2});
}

}  // namespace
}  // namespace slipbench::driver::yaml
