#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""rewrite.py PROJECT TREE COMPILE_COMMANDS: copies PROJECT to TREE with every mutant of law/ behind a switch, listed in
TREE/mutants.json.

COMPILE_COMMANDS says how the sources of PROJECT are compiled. The places come from Clang's syntax tree
(Debian: python3-clang-14); `a < b` becomes `slipbench::mutation::less(17, a, b)`, which is `<` unless this run has mutant
17 or 18. A place that the compiler evaluates (constexpr variables, static_assert, requires) stays as it is, and so does a
member that begins at 0: it says that it has a value, which others replace.
"""
import hashlib
import json
import pathlib
import re
import sys

from clang import cindex
from clang.cindex import CursorKind as Kind, TypeKind

NUMBERS = {TypeKind.DOUBLE, TypeKind.FLOAT, TypeKind.INT, TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG, TypeKind.BOOL,
           TypeKind.UCHAR, TypeKind.USHORT, TypeKind.SCHAR, TypeKind.SHORT, TypeKind.LONGLONG, TypeKind.ULONGLONG}
# Operator: function, mutants.
BINARY = {"<": ("less", ["<=", ">="]), "<=": ("less_equal", ["<", ">"]), ">": ("greater", [">=", "<="]),
          ">=": ("greater_equal", [">", "<"]), "==": ("equal", ["!="]), "!=": ("unequal", ["=="]),
          "+": ("plus", ["-"]), "-": ("minus", ["+"]), "*": ("times", ["/"]), "/": ("over", ["*"]),
          "+=": ("add_to", ["-="]), "-=": ("take_from", ["+="]), "*=": ("scale_by", ["/="]), "/=": ("divide_by", ["*="])}
MOST = 1 << 16  # of mutant.hpp
SPACE = "slipbench::mutation::"
EVALUATED = re.compile(r"(static\s+|inline\s+)*(constexpr|constinit)\b")


class File:
    """The text of one file, and what is put into it."""

    def __init__(self, path):
        self.bytes = path.read_bytes()
        self.edits = []  # (offset, 0 end / 1 begin, order, length replaced, text)
        self.sites = []

    def text(self, start, end):
        return self.bytes[start:end].decode()

    def put(self, offset, is_begin, depth, text, length=0):
        # At one offset an outer call begins before an inner one, and ends after it.
        self.edits.append((offset, is_begin, depth if is_begin else -depth, length, text))

    def around(self, node, depth, before, after=")"):
        self.put(node.extent.start.offset, 1, depth, before)
        self.put(node.extent.end.offset, 0, depth, after)

    def result(self):
        out, at = [], 0
        for offset, _, _, length, text in sorted(self.edits):
            out += [self.bytes[at:offset], text.encode()]
            at = offset + length
        return b"".join(out + [self.bytes[at:]])


class Rewriter:
    def __init__(self, tree, old):
        self.tree = tree
        self.mutants = []
        self.old = {}  # file: numbers that it had
        for mutant in old:
            self.old.setdefault(mutant["file"], []).append(mutant["id"])
        self.next = 1 + max((m["id"] for m in old), default=-1)

    def site(self, file, node, changes):
        """Adds mutants (original, mutant) of a node; returns the number of the first."""
        at = node.extent.start
        line = file.text(0, len(file.bytes)).splitlines()[at.line - 1].strip()
        first = self.base + len(self.found)
        for original, mutant in changes:
            self.found.append({"id": self.base + len(self.found), "site": first, "file": self.path, "line": at.line,
                               "text": line, "column": at.column, "from": original, "to": mutant})
        return first

    def file(self, path, nodes):
        """Returns the text of a file with its switches. One with as many mutants as before keeps their numbers, so that
        only what changed is compiled again."""
        self.path = path
        old = self.old.get(path, [])
        for base in (min(old, default=self.next), self.next):
            self.base, self.found, file = base, [], File(self.tree / path)
            for node in nodes:
                self.walk(file, node, 0)
            if base == self.next or len(self.found) == len(old):
                break
        if self.base == self.next:
            self.next += len(self.found)
        if self.next > MOST:
            sys.exit("error: no numbers left, remove the folder and begin anew")
        self.mutants += self.found
        text = file.result()
        # Inlined everywhere, the many calls would take hours to compile.
        anchor = re.search(rb"^#pragma once$|^#include", text, re.M)
        place = anchor.end() if anchor.group().startswith(b"#pragma") else anchor.start()
        text = text[:place] + b'\n#include "law/base/mutant.hpp"\n' + text[place:]
        return re.sub(rb"\[\[gnu::(flatten|always_inline)\]\]", b"", text)

    def walk(self, file, node, depth):
        start, end = node.extent.start.offset, node.extent.end.offset
        text = file.text(start, end)
        if node.kind in (Kind.STATIC_ASSERT, Kind.TYPE_ALIAS_DECL, Kind.TYPE_ALIAS_TEMPLATE_DECL, Kind.ENUM_DECL, Kind.CASE_STMT) \
                or text.startswith(("requires", "static_assert", "noexcept", "sizeof", "decltype")) \
                or (node.kind == Kind.UNEXPOSED_DECL and text.startswith("template")):
            if node.kind == Kind.CASE_STMT:
                for child in list(node.get_children())[1:]:
                    self.walk(file, child, depth + 1)
            return
        if node.kind in (Kind.VAR_DECL, Kind.FIELD_DECL) and EVALUATED.match(text):
            return
        if node.kind == Kind.FIELD_DECL and re.search(r"= *0(\.0)?$|\{\}$", text):
            return
        children = list(node.get_children())
        mutate = getattr(self, "on_" + node.kind.name.lower(), None)
        if mutate:
            mutate(file, node, children, depth, text)
        if node.kind in (Kind.VAR_DECL, Kind.FIELD_DECL, Kind.PARM_DECL):
            children = [c for c in children if "[" not in file.text(node.extent.start.offset, c.extent.start.offset) or
                        not node.type.spelling.endswith("]")]
        if node.kind == Kind.IF_STMT and re.match(r"if\s+constexpr\b", text):
            children = children[1:]
        for child in children:
            at = child.extent  # a default that is used here stands elsewhere
            if str(at.start.file) == str(node.extent.start.file) and start <= at.start.offset <= at.end.offset <= end:
                self.walk(file, child, depth + 1)

    def is_number(self, node):
        return node.type.get_canonical().kind in NUMBERS

    def is_template(self, node):
        return node.type.get_canonical().kind in (TypeKind.DEPENDENT, TypeKind.UNEXPOSED)

    def on_binary_operator(self, file, node, children, depth, text):
        if len(children) != 2:
            return
        left, right = children
        begin, end = left.extent.end.offset, right.extent.start.offset
        between = file.text(begin, end)
        sign = between.strip()
        if sign in ("&&", "||"):
            first = self.site(file, node, [(sign, "||" if sign == "&&" else "&&")])
            for part, deep in ((node, depth), (left, depth + 0.5), (right, depth + 0.5)):
                file.around(part, deep, f"{SPACE}truth({first}, ")
            return
        if sign not in BINARY:
            return
        if not all(self.is_number(c) or self.is_template(c) for c in children):
            return
        name, others = BINARY[sign]
        first = self.site(file, node, [(text, file.text(node.extent.start.offset, begin) + between.replace(sign, o) +
                                        file.text(end, node.extent.end.offset)) for o in others])
        file.around(node, depth, f"{SPACE}{name}({first}, ")
        file.put(begin + between.index(sign), 1, 0, ",", len(sign))

    on_compound_assignment_operator = on_binary_operator

    def on_unary_operator(self, file, node, children, depth, text):
        if not text.startswith("-") or text.startswith("--") or not (self.is_number(node) or self.is_template(node)):
            return
        first = self.site(file, node, [(text, text[1:])])
        file.put(node.extent.start.offset, 1, depth, f"{SPACE}negative({first}, ", 1)
        file.put(node.extent.end.offset, 0, depth, ")")

    def on_floating_literal(self, file, node, children, depth, text):
        if text.endswith(("f", "L")):
            return
        value = float(text.replace("'", ""))
        first = self.site(file, node, [(text, t) for t in (["1e-3", "1.0"] if value == 0.0 else [f"{2 * value!r}"])])
        file.around(node, depth, f"{SPACE}number({first}, ")

    def on_call_expr(self, file, node, children, depth, text):
        match = re.match(r"(?:std::)?(min|max)\s*\(", text)
        if match:
            name = match.group(1)
            first = self.site(file, node, [(name, "max" if name == "min" else "min")])
            new = f"{SPACE}{'smallest' if name == 'min' else 'largest'}({first}, "
            file.put(node.extent.start.offset, 1, depth, new, match.end())

    def condition(self, file, node, depth):
        if node.kind.is_declaration() or node.kind == Kind.DECL_STMT:
            return
        if node.kind == Kind.BINARY_OPERATOR:  # negated by its own mutants
            inner = list(node.get_children())
            if len(inner) == 2 and file.text(inner[0].extent.end.offset, inner[1].extent.start.offset).strip() in BINARY:
                return
        text = file.text(node.extent.start.offset, node.extent.end.offset)
        first = self.site(file, node, [(text, f"!({text})")])
        file.around(node, depth + 0.25, f"{SPACE}truth({first}, ")

    def on_conditional_operator(self, file, node, children, depth, text):
        self.condition(file, children[0], depth)

    def on_if_stmt(self, file, node, children, depth, text):
        start = node.extent.start.offset
        if re.fullmatch(r"(if|while)\s*\(\s*", file.text(start, children[0].extent.start.offset)):
            self.condition(file, children[0], depth)
            bodies = children[1:]
        else:
            bodies = [children[-1]]
        for body in bodies:
            self.drop(file, body, depth, braces=True)

    on_while_stmt = on_if_stmt

    def on_for_stmt(self, file, node, children, depth, text):
        self.drop(file, children[-1], depth, braces=True)

    on_cxx_for_range_stmt = on_for_stmt

    def on_compound_stmt(self, file, node, children, depth, text):
        for child in children:
            self.drop(file, child, depth)

    def drop(self, file, node, depth, braces=False):
        """Makes a mutant without an expression statement."""
        text = file.text(node.extent.start.offset, node.extent.end.offset)
        if not node.kind.is_expression() and node.kind != Kind.UNEXPOSED_EXPR:
            return
        if text.startswith(("++", "--")) or text.endswith(("++", "--")) or re.match(r"static_cast<void>|\(void\)|throw", text):
            return
        end = node.extent.end.offset
        semicolon = re.compile(rb"\s*;").match(file.bytes, end)
        if not semicolon:
            return
        first = self.site(file, node, [(text + ";", "without it")])
        file.put(node.extent.start.offset, 1, depth + 0.125, ("{ " if braces else "") + f"if (!{SPACE}is_chosen({first})) ")
        if braces:
            file.put(semicolon.end(), 0, depth + 0.125, " }")


def arguments(entry):
    """Reads what of a command of the compiler Clang needs."""
    words = entry["command"].split()
    return [w for w in words if w.startswith(("-I", "-D", "-std"))] + \
           [f"-isystem{words[i + 1]}" for i, w in enumerate(words) if w == "-isystem"]


def read_law(source, commands):
    """Reads law/ and returns the top of the syntax tree of each of its files. A header is read as a part of a source."""
    entries = {e["file"]: arguments(e) for e in json.loads(commands.read_text())}
    sources = sorted(source.glob("law/**/*.cpp"))
    index, units, found = cindex.Index.create(), [], {}
    for path in sources + sorted(source.glob("law/**/*.hpp")):
        if str(path.relative_to(source)) in found:
            continue
        unit = index.parse(str(path), ["-xc++", *entries.get(str(path), entries[str(sources[0])])])
        wrong = [str(d) for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
        if wrong:
            sys.exit(f"error: Clang cannot read {path}: {wrong[0]}")
        units.append(unit)  # nodes live no longer than it
        here = {}
        for node in unit.cursor.get_children():
            at = node.location.file
            if at and at.name.startswith(str(source / "law")):
                here.setdefault(str(pathlib.Path(at.name).resolve().relative_to(source)), []).append(node)
        for file, nodes in here.items():
            found.setdefault(file, nodes)
    return units, found


def write(path, text):
    """Writes a file, unless it is so already: what did not change is not compiled again."""
    if not path.exists() or path.read_bytes() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text)


def main():
    source, tree = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
    added = {"law/base/mutant.hpp": "mutant.hpp", "law/base/mutant.cpp": "mutant.cpp",
             "tests/law/reached_listener.cpp": "listener.cpp", "tests/property/reached_listener.cpp": "listener.cpp"}
    here = pathlib.Path(__file__).parent
    files = {str(p.relative_to(source)): p for p in source.glob("**/*") if p.is_file()}
    digest = hashlib.sha256()
    for path in [*(files[n] for n in sorted(files) if n.startswith("law/")), pathlib.Path(__file__)]:
        digest.update(path.read_bytes())
    listed = tree / "mutants.json"
    old = json.loads(listed.read_text()) if listed.exists() else {}

    for name, path in files.items():
        if name != "tests/CMakeLists.txt" and not (name.startswith("law/") and name.endswith("pp")):
            write(tree / name, path.read_bytes())
    for name, path in added.items():
        write(tree / name, (here / path).read_bytes())
    tests = "tests/CMakeLists.txt"  # the listener needs parts of Catch that the tests' precompiled headers leave out
    write(tree / tests, files[tests].read_bytes() + b"set_source_files_properties(law/reached_listener.cpp "
          b"property/reached_listener.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)\n")
    if old.get("digest") != digest.hexdigest():
        units, found = read_law(source, pathlib.Path(sys.argv[3]))
        rewriter = Rewriter(source, old.get("mutants", []))
        for name in sorted(n for n in files if n.startswith("law/") and n.endswith("pp")):
            write(tree / name, rewriter.file(name, found[name]) if name in found else files[name].read_bytes())
        old = {"digest": digest.hexdigest(), "mutants": rewriter.mutants}
    for path in [p for p in tree.glob("**/*") if p.is_file() and p != listed]:
        if str(path.relative_to(tree)) not in files and str(path.relative_to(tree)) not in added:
            path.unlink()
    write(listed, json.dumps(old, indent=0).encode())
    print(f"{len(old['mutants'])} mutants in {len({m['file'] for m in old['mutants']})} files")


if __name__ == "__main__":
    main()
