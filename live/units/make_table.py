#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""make_table.py XML TABLE: writes the units and prefixes of UDUNITS-2's data base as rows of C++, for udunits.cpp."""
import sys
import xml.etree.ElementTree as tree
from pathlib import Path


def plural(name):
    """The plural of an English noun, as UDUNITS-2 forms it."""
    if name.endswith("y") and name[-2:-1] not in "aeiou":
        return name[:-1] + "ies"
    return name + ("es" if name.endswith(("s", "x", "z", "ch", "sh")) else "s")


def names_of(unit):
    """Names (any case) and symbols (as they are) of a unit, its aliases among them."""
    for place in [unit, *unit.findall("aliases")]:
        for name in place.findall("name"):
            singular = name.findtext("singular").strip()
            yield singular, True
            if name.find("plural") is not None:
                yield name.findtext("plural").strip(), True
            elif name.find("noplural") is None:
                yield plural(singular), True
        for symbol in place.findall("symbol"):
            yield symbol.text.strip(), False


def quoted(text):
    return '"' + "".join(chr(b) if 32 <= b < 127 and b not in b'"\\' else f"\\{b:03o}" for b in text.encode()) + '"'


def rows(file, units, prefixes):
    """Adds what a file of the data base says, and those that it imports; a unit is only named once."""
    for element in tree.parse(file).getroot():
        if element.tag == "import":
            rows(file.parent / element.text.strip(), units, prefixes)
        elif element.tag == "prefix":
            value = float(element.findtext("value"))
            prefixes += [(word.text.strip(), value, word.tag == "name") for word in element if word.tag in ("name", "symbol")]
        elif element.tag == "unit":
            names = list(names_of(element))
            definition = element.findtext("def")
            if definition is None:  # a base unit stands for itself
                definition = "#" + names[0][0]
            units += [(name, definition.strip(), any_case) for name, any_case in names]


def main():
    units, prefixes = [], []
    rows(Path(sys.argv[1]), units, prefixes)
    text = "// Made from UDUNITS-2's unit data base.\nconstexpr Entry kEntries[] = {\n"
    text += "".join(f"    {{{quoted(name)}, {quoted(definition)}, {str(any_case).lower()}}},\n" for name, definition, any_case in units)
    text += "};\nconstexpr Prefix kPrefixes[] = {\n"
    text += "".join(f"    {{{quoted(word)}, {value!r}, {str(is_name).lower()}}},\n" for word, value, is_name in prefixes)
    Path(sys.argv[2]).write_text(text + "};\n", encoding="ascii")


main()
