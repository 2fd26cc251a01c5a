#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A friction law that lacks a piece, or has one of another form, does not compile, and the compiler's first error says which.

usage: missing_piece_test.py COMPILER SOURCE_DIR
"""
import pathlib
import re
import subprocess
import sys
import tempfile

# The text of the Stribeck law that is left out, and what the compiler says then.
PIECES = [
    ("kName", r"  static constexpr std::string_view kName[^;]*;\n", "lacks its key"),
    ("kTitle", r"  static constexpr std::string_view kTitle[^;]*;\n", "lacks its title"),
    ("kFormula", r"  static constexpr std::string_view kFormula[^;]*;\n", "lacks its formula"),
    ("kSource", r"  static constexpr std::string_view kSource[^;]*;\n", "lacks its source"),
    ("kRules", r"  static constexpr std::array<std::string_view, 1> kRules[^;]*;\n", "lacks the rules"),
    ("fields", r"  static constexpr auto fields[\s\S]*?\n  }\n", "lacks the list of its numbers"),
    ("violation", r"  std::optional<std::string_view> violation[\s\S]*?\n  }\n", "lacks the broken one"),
    ("example", r"  static Stribeck example[^\n]*\n", "lacks a set of numbers to show it with"),
    ("coefficient", r"  Number coefficient[\s\S]*?\n  }\n", "lacks Number coefficient(V), (V, F_N)"),
]

# The text that another one takes the place of, and what the compiler says then.
FIELD = "a Field lacks a piece, or one has another type"
NUMBER = "write Number, which carries the derivatives along"
EXAMPLE = "  static Stribeck example"
OTHERS = [
    ("a dimension that is a word", "dimension::kNone", '"none"', FIELD),
    ("bounds left out", "Bounds{.lower = 1.0}, ", "", FIELD),
    ("required or not left out", "kNotNegative, true,", "kNotNegative,", FIELD),
    ("a sentence left out", ',\n              "Growth c of the coefficient with the slip rate."', "", FIELD),
    ("a number in the place of the member", "&Stribeck::viscous", "1e-4", FIELD),
    ("a number of type double", ", viscous{};", "; double viscous{};", NUMBER),
    ("an argument of type double", "coefficient(const Number& slip_rate)", "coefficient(double slip_rate)", NUMBER),
    ("a next_bend() that no const law has", EXAMPLE,
     "  double next_bend(const SlipLine&) { return kNoBend; }\n" + EXAMPLE, "next_bend is double next_bend(const SlipLine&) const"),
    ("a range() of a number", EXAMPLE, "  double range() const { return 1.0; }\n" + EXAMPLE, "range is LawRange range() const"),
]


def first_error(compiler, root, header):
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "law.cpp")
        source.write_text('#include "law/friction/slip_line.hpp"\n' + header + '#include "law/friction/law_contract.hpp"\nnamespace slipbench::law {\n'
                          "static_assert(keep_contract(std::type_identity<std::variant<Stribeck<>>>{}));\n}\n")
        run = subprocess.run([compiler, "-std=c++20", "-fsyntax-only", "-I", root, str(source)],
                             capture_output=True, text=True, check=False)
    return next((line for line in run.stderr.splitlines() if "error:" in line), "")


def main(compiler, root):
    header = pathlib.Path(root, "law/friction/stribeck.hpp").read_text().replace("#pragma once", "")
    failures = []
    if first := first_error(compiler, root, header):
        failures.append(f"the whole law does not compile: {first}")
    for name, pattern, sentence in PIECES:
        without, count = re.subn(pattern, "", header)
        if name == "kRules":  # what names them goes along
            without = re.sub(r"  std::optional<std::string_view> violation[\s\S]*?\n  }\n", "", without)
        first = first_error(compiler, root, without)
        if count != 1 or sentence not in first:
            failures.append(f"{name}: the first error is '{first}', not one with '{sentence}'")
    for name, text, other, sentence in OTHERS:
        first = first_error(compiler, root, header.replace(text, other, 1))
        if text not in header or sentence not in first:
            failures.append(f"{name}: the first error is '{first}', not one with '{sentence}'")
    print("\n".join(failures) or f"{len(PIECES)} missing pieces and {len(OTHERS)} of another form are told")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
