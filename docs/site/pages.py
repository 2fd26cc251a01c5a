#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Lays the pages of the documentation site together: pages.py SLIPBENCH FOLDER

FOLDER gets what mkdocs reads: the pages of docs/ in the Markdown that mkdocs understands, those that the program tells (commands, types, laws, ..),
a gallery of cases/examples, the sketches of joints and the validation dossier. `scripts/docs.sh` calls it and builds the site.
"""
import ast
import concurrent.futures
import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

import dossier
import joints
import moving
import play

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS, EXAMPLES = ROOT / "docs", ROOT / "cases/examples"
FENCE = re.compile(r"^( *)(```+)(\w*) ?(.*)$")
LINK = re.compile(r"(\]\()([^)\s:]+?)(#[^)\s]*)?(\))")


class Site:
    def __init__(self, program, folder):
        self.program, self.folder = pathlib.Path(program).resolve(), pathlib.Path(folder)
        self.shown = set()  # files of the project beside docs/ that some page links to
        self.cases = {}  # of the tutorials, as each first was: name: text
        self.folder.mkdir(parents=True, exist_ok=True)
        # The bench in a page, if scripts/wasm.sh has built it; without it there is no other difference.
        made = subprocess.run([self.program, "report", "--live", EXAMPLES / "shock_absorber.yaml", "-o", self.folder / "live.html", "--title", "slipbench"],
                              capture_output=True, text=True)
        self.live = made.returncode == 0
        if not self.live and "scripts/wasm.sh" not in made.stderr:
            sys.exit(f"slipbench report --live ended with {made.returncode}: {made.stderr}")

    def say(self, *words):
        """What the program prints."""
        return subprocess.run([self.program, *words], capture_output=True, text=True, check=True, env={**os.environ, "LC_ALL": "C.UTF-8"}).stdout

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def place(self, file):
        """Where the site has a file of the project, or None."""
        if file.is_relative_to(DOCS):
            return file.relative_to(DOCS / "site" if file.is_relative_to(DOCS / "site") else DOCS)
        if file == EXAMPLES:
            return pathlib.Path("gallery.md")
        if file.parent == EXAMPLES and file.suffix == ".yaml":
            return pathlib.Path(f"gallery.md#{file.stem}")
        if not file.is_file():
            return None
        self.shown.add(file)
        return pathlib.Path("files") / (f"{file.relative_to(ROOT)}" + ("" if file.suffix == ".md" else ".md"))

    def links(self, line, source, page):
        """A line with its links as they are on the site; of what the site does not have only the words stay."""
        def change(match):
            to = self.place((source.parent / match[2]).resolve())
            if to is None:
                return "](#"
            return f"]({os.path.relpath(to, pathlib.Path(page).parent)}{match[3] or ''})"
        line = re.sub(r"(`[^`]*`)|" + LINK.pattern, lambda m: m[0] if m[1] else change(re.match(LINK, m[0])), line)
        return re.sub(r"\[([^\]]*)\]\(#(?=[\s.,;:)]|$)", r"\1", line)

    def page(self, source, page):
        """A page of the project: titles of blocks, lists and links in mkdocs' way."""
        lines, fence, last, shown, caption, case, text = [], None, "", [], "", "", source.read_text()
        tutorial = source.parent.name == "tutorials"
        if tutorial:
            lines.append("---\nhide: [toc]\n---")
        for line in text.splitlines():
            mark = FENCE.match(line)
            if fence:
                lines.append(line)
                shown.append(line)
                if line.strip() == fence:
                    fence = None
                    if case:
                        lines += self.live_case("\n".join(shown[:-1]) + "\n", case, page)
                    if caption:
                        lines += ["", *self.figure(re.search(r"[\w./-]+\.svg", "\n".join(shown))[0], caption, page)]
            elif mark:
                fence, shown, caption = mark[2], [], mark[4] if mark[3] in ("console", "python") else ""
                case = mark[4].split()[-1] if tutorial and mark[4].startswith("case ") else ""
                title = "" if caption or not mark[4] else f' title="{mark[4].split()[-1]}"'
                lines.append(f"{mark[1]}{mark[2]}{mark[3]}{title}")
            else:
                item = re.match(r"( *)([-*]|\d+\.) ", line)
                if item and last.strip() and not re.match(r" *([-*]|\d+\.) |  ", last):
                    lines.append("")  # GitHub begins a list below a line of text, mkdocs does not
                lines.append(self.links(line, source, page))
            last = line
        if tutorial and not re.search("^```yaml case ", text, re.MULTILINE):
            for name in self.named_cases(text)[:1]:
                lines += self.live_case(with_values(self.cases[name], text), name, page)
        self.write(page, "\n".join(lines) + "\n")

    def named_cases(self, text):
        """The cases of the tutorials that a text names, in its order."""
        return [name for name in re.findall(r"[\w.-]+\.yaml\b", text) if name in self.cases]

    def figure(self, name, words, page="index.md"):
        """A picture that the build has made, for light and dark pages, with words for who does not see it."""
        name, words = pathlib.Path(name).with_suffix(""), html.escape(words)
        here = (self.folder / page).parent
        both = [(name, "#only-light"), (f"{name}-dark", "#only-dark")] if (here / f"{name}-dark.svg").exists() else [(name, "")]
        return [f"![{words}]({one}.svg{look}){{ loading=lazy }}" for one, look in both]

    def live_case(self, text, name, page):
        """A case to be changed and run in the page, loaded when it is opened."""
        if not self.live:
            return []
        address = os.path.relpath("live.html", pathlib.Path(page).parent) + "#text=" + urllib.parse.quote(text, safe="")
        return ["", f'<details class="live"><summary>Change {name} and run it here</summary><iframe loading="lazy" title="{name}, to be changed and run" src="{address}"></iframe></details>', ""]

    def drawn_by(self, name):
        """Runs the cases and commands that the pages of a folder show, in one folder and in their order: the pictures drawn, {name: bytes}, and the
        cases that were written or imported, {name: text}, each before another command changes it."""
        pages = dict.fromkeys(re.findall(r"\]\((\w[\w-]*\.md)\)", (DOCS / name / "README.md").read_text()))
        environment = {**os.environ, "LC_ALL": "C.UTF-8", "MPLBACKEND": "Agg", "PYTHONPATH": str(self.program.parent / "python")}
        script, cases = "", {}
        block = re.compile(r"^```(\w+) ?([^\n]*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
        with tempfile.TemporaryDirectory() as scratch:
            (pathlib.Path(scratch) / "bin").mkdir()
            (pathlib.Path(scratch) / "bin/slipbench").symlink_to(self.program)
            for kind, title, body in (found for page in pages for found in block.findall((DOCS / name / page).read_text())):
                if kind == "console":
                    commands = "\n".join(line[2:] for line in body.splitlines() if line.startswith("$ "))
                    commands += "".join(f"\n{line[2:-4]}-dark.svg --dark" for line in body.splitlines() if re.match(r"\$ slipbench plot .*svg$", line))
                    subprocess.run(["bash", "-c", commands], cwd=scratch, stdin=subprocess.DEVNULL, capture_output=True,
                                   env={**environment, "PATH": f"{scratch}/bin:{os.environ['PATH']}"})
                elif kind == "python":
                    script += body
                    if title:  # it draws; what the blocks before it have made is needed for that
                        subprocess.run([sys.executable, "-c", script], cwd=scratch, stdin=subprocess.DEVNULL, capture_output=True, env=environment, check=True)
                elif kind == "csv" or title.startswith(("case ", "file ")):
                    (pathlib.Path(scratch) / title.split()[-1]).write_text(body)
                for file in pathlib.Path(scratch).glob("*.yaml"):
                    if file.name not in cases and re.search("^connector:", text := file.read_text(), re.MULTILINE):  # else a sweep or a fit
                        cases[file.name] = text
            return {picture.name: picture.read_bytes() for picture in pathlib.Path(scratch).glob("*.svg")}, cases

    def pictures(self):
        """Those of the tutorials, and anew those that the guide keeps for who reads it without a site."""
        (self.folder / "images").mkdir()
        pad = self.folder / "images/pad_on_a_belt.svg"
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            tutorials, guide = pool.submit(self.drawn_by, "tutorials"), pool.submit(self.drawn_by, "guide")
            subprocess.run([sys.executable, "-B", ROOT / "tests/fmu/squeal.py", self.program, pad], check=True, capture_output=True)
        drawn, self.cases = tutorials.result()
        for name, picture in drawn.items():
            (self.folder / "tutorials" / name).parent.mkdir(exist_ok=True)
            (self.folder / "tutorials" / name).write_bytes(picture)
        anew = {**guide.result()[0], "shock_absorber.svg": (self.folder / "gallery/shock_absorber.svg").read_bytes(), pad.name: pad.read_bytes(),
                "shaft.svg": moving.draw(self.program).encode()}
        for kept in (DOCS / "images").iterdir():
            (self.folder / "images" / kept.name).write_bytes(anew[kept.name])

    def pages(self):
        for source in sorted(DOCS.rglob("*")):
            if source.is_dir() or source.suffix == ".py" and source.parent.name == "site" or source.parent.name == "images" and source.parent.parent == DOCS or source.name in ("mkdocs.yml", "Doxyfile"):
                continue
            page = self.place(source)
            if source.suffix == ".md":
                self.page(source, page)
            elif "theme" not in page.parts:
                (self.folder / page).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(source, self.folder / page)

    def files(self):
        """Files that pages link to, and those which these link to."""
        done = set()
        while self.shown - done:
            for file in sorted(self.shown - done):
                done.add(file)
                page = self.place(file)
                if file.suffix == ".md":
                    self.page(file, page)
                else:
                    kind = {".yaml": "yaml", ".csv": "text", ".py": "python"}.get(file.suffix, "text")
                    self.write(page, f"# {file.name}\n\n`{file.relative_to(ROOT)}`\n\n````{kind}\n{file.read_text()}````\n")

    def reference(self):
        """What the program says of itself."""
        def listed(what):
            return [line.split(maxsplit=1) for line in self.say("list", what).splitlines() if line.startswith("  ")]

        def section(name):
            told = self.say("describe", name).rstrip().replace("```", "'''")
            return f"## {name}\n\n```text\n{told}\n```\n"

        commands = re.findall(r"^  (\w+) ", self.say("--help").partition("Subcommands:")[2].partition("Examples:")[0], re.MULTILINE)
        self.write("reference/commands.md", "# Commands\n\n```text\n" + self.say("--help") + "```\n\n" + "\n".join(
            f"## slipbench {name}\n\n```text\n{self.say(name, '--help')}```\n" for name in commands))
        for page, title, what, words in (
                ("laws", "Laws of the coefficient", "laws", "`coefficient` of a friction definition is a number, a table or one of these laws."),
                ("closed-forms", "Closed forms", "closed-forms", "What a check can hold a result against; [theory](../theory/closed-forms.md)."),
                ("curves", "Reference curves", "curves", "Curves that come with the program, for checks."),
                ("criteria", "Criteria", "criteria", "By what a check compares two curves; [theory](../theory/comparing.md).")):
            names = [words[0] for words in listed(what)]
            self.write(f"reference/{page}.md", f"# {title}\n\n{words} `slipbench describe NAME` tells the same.\n\n" + "\n".join(map(section, names)))
        rows = "\n".join(f"| `{name}` | {html.escape(words)} |" for name, words in listed("quantities"))
        self.write("reference/columns.md", f"# Columns\n\nWhat a case prescribes and a result has, as far as the connection does.\n\n| name | meaning |\n|---|---|\n{rows}\n")
        sections = "\n".join(section(name) for name in self.types())
        self.write("reference/connections.md", "# Connection types\n\nThe types of Abaqus' connector elements (`*CONNECTOR SECTION`) and a contact point of "
                   f"Radioss. [Find your joint](../joints.md) has a sketch of each.\n\n```text\n{self.say('list', 'connections')}```\n\n{sections}")
        self.write("reference/python.md", python_reference())

    def types(self):
        schema = json.loads(self.say("schema"))
        return schema["properties"]["connector"]["properties"]["type"]["anyOf"][0]["enum"]

    def connections(self):
        """{type: (what the program tells of it, [what it holds], [what it frees])}"""
        def words(told, which):
            found = re.search(rf"^  {which}, .*?:' +(.*)$", told, re.MULTILINE)[1].strip()
            return [] if found == "none" else found.split(", ")
        told = {name: self.say("describe", name).partition("  a minimal case")[0] for name in self.types()}
        return {name: (text, words(text, "holds"), words(text, "frees")) for name, text in told.items()}

    def joints(self):
        """A section for each connection type below the words of docs/site/joints.md."""
        text = [(self.folder / "joints.md").read_text()]
        if set(self.types()) != set(joints.SKETCHES):
            sys.exit(f"docs/site/joints.py and the program have other types: {sorted(set(self.types()) ^ set(joints.SKETCHES))}")
        text.append('<div class="joints">' + "".join(
            f'<a href="#{name.lower().replace(" ", "-")}"><svg viewBox="-210 -160 420 310" aria-hidden="true"><use href="#{joints.identity(name)}"/></svg>{name}</a>'
            for name in joints.SKETCHES) + "</div>\n")
        for name, (told, held, free) in self.connections().items():
            numbers = re.findall(r"^    (\w+) +([^(].*)$", told.partition("predefined friction, parameters")[2], re.MULTILINE)
            missing = {one for one, _ in numbers if one[0] in "RL"} - joints.labels(name)
            if missing:
                sys.exit(f"docs/site/joints.py: the sketch of {name} does not show {', '.join(sorted(missing))}")
            formula = re.search(r"^  contact force; .*\n((?: {4}.*\n)+)", told, re.MULTILINE)[1].replace("\n    ", "\n").strip()
            rows = "".join(f"| `{one}` | {words} |\n" for one, words in numbers)
            text.append(f"## {name}\n\n{told.splitlines()[1].strip()} {made_of(told)}\n\n{joints.sketch(name, held, free)}\n\n"
                        f"Free: {', '.join(free) or 'nothing'}. Held: {', '.join(held) or 'nothing'}.\n\n```text\n{formula}\n```\n"
                        + (f"\n| parameter | |\n|---|---|\n{rows}" if rows else "\nNo parameters of predefined friction.\n" if "'predefined: {}'" in told
                           else "\nFriction is written out, by `component` or `potential`.\n"))
        self.write("joints.md", "\n".join(text))

    def play(self):
        """The pictures of docs/site/play.md, and the positions of their sliders."""
        text = (self.folder / "play.md").read_text()
        figures, data = play.pictures((DOCS / "site/play.md").read_text(), self.program)
        for name, figure in figures.items():
            text = text.replace(f'<div id="play-{name}"></div>', figure)
        self.write("assets/play_data.js", data)
        self.write("play.md", text + '\n<script src="assets/play_data.js"></script>\n<script src="assets/play.js"></script>\n')

    def picture(self, job):
        """One picture, light or dark: (folder, words of the command, file)."""
        folder, words, file = job
        file.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run([self.program, "plot", *words, "-o", file], cwd=folder, check=True, capture_output=True)

    def light_and_dark(self, jobs):
        """Pictures (folder, words, name without ending), drawn by all cores."""
        both = [(folder, [*words, *dark], self.folder / f"{name}{'-dark' if dark else ''}.svg")
                for folder, words, name in jobs for dark in ([], ["--dark"])]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(self.picture, both))

    def gallery(self):
        text = ["---\nhide: [navigation]\n---\n# Gallery\n\nAll cases of `cases/examples`: what each is, what it gives, and the case. `slipbench check cases/examples` runs their checks.\n"]
        cases = sorted(EXAMPLES.glob("*.yaml"))
        self.light_and_dark([(EXAMPLES, [case.name], f"gallery/{case.stem}") for case in cases])
        for case in cases:
            body = case.read_text()
            title = re.search(r"^title: *(.*)$", body, re.MULTILINE)[1].strip("'\"")
            first = " ".join(line[2:].strip() for line in re.match(r"(# \S.*\n)+", body)[0].splitlines())
            sentence = re.match(r".*?[.](?= |$)|.*", first)[0].rstrip(":")
            text.append(f"## {title} {{ #{case.stem} }}\n\n{html.escape(sentence, quote=False)}{'' if sentence[-1] in '.?!' else '.'}\n\n"
                        + "\n".join(self.figure(f"gallery/{case.stem}", f"{title}: friction force over time and motion"))
                        + f'\n\n??? example "{case.name}"\n\n    ```yaml\n' + re.sub(r"^(?=.)", "    ", body, flags=re.MULTILINE) + "    ```\n"
                        + "\n".join(self.live_case(body, case.name, "gallery.md")))
        self.write("gallery.md", "\n".join(text))


def with_values(case, text):
    """An imported case whose parameters have the values that a page gives them by --set: 'f2:   # why' becomes 'f2: -80   # why'."""
    given = dict(re.findall(r"--set (\w+)=([^\s`]+)", text))
    return re.sub(r"^(  (\w+):)(?= +# )", lambda line: f"{line[1]} {given[line[2]]}" if line[2] in given else line[0], case, flags=re.MULTILINE)


def made_of(told):
    parts = re.search(r"connection type, (.* \+ .*)\)", told)
    return f"Made of {parts[1]}." if parts else ""


def python_reference():
    """The public classes and functions of the Python module, from their own words."""
    def signature(node):
        arguments = [one for one in (node.args.args[1:] if node.args.args and node.args.args[0].arg == "self" else node.args.args)]
        taken = ast.arguments(posonlyargs=[], args=arguments, vararg=node.args.vararg, kwonlyargs=node.args.kwonlyargs,
                              kw_defaults=node.args.kw_defaults, kwarg=node.args.kwarg, defaults=node.args.defaults)
        return f"{node.name}({ast.unparse(taken)})" + (f" -> {ast.unparse(node.returns)}" if node.returns else "")

    public = ast.literal_eval(re.search(r"__all__ = (\[.*?\])", (ROOT / "python/slipbench/__init__.py").read_text(), re.DOTALL)[1])
    text = ["# Python\n\nThe public names of the module `slipbench`; [From Python](../guide/python.md) shows them at work.\n"]
    for file in sorted((ROOT / "python/slipbench").glob("_*.py")):
        for node in ast.parse(file.read_text()).body:
            if getattr(node, "name", None) not in public:
                continue
            text.append(f"## {node.name}\n")
            if isinstance(node, ast.FunctionDef):
                text.append(f"```python\n{signature(node)}\n```\n")
            text.append(f"{ast.get_docstring(node) or ''}\n")
            for inner in getattr(node, "body", []) if isinstance(node, ast.ClassDef) else []:
                words = ast.get_docstring(inner) if isinstance(inner, ast.FunctionDef) else None
                if words and not inner.name.startswith("_"):
                    is_value = any(getattr(one, "id", "") == "property" for one in inner.decorator_list)
                    text.append(f"`{inner.name if is_value else signature(inner)}`\n:   " + words.replace("\n", "\n    ") + "\n")
    return "\n".join(text)


def main(program, folder):
    site = Site(program, folder)
    site.gallery()
    site.pictures()
    site.pages()
    site.reference()
    site.joints()
    site.play()
    dossier.write(site)
    site.files()


if __name__ == "__main__":
    main(*sys.argv[1:])
