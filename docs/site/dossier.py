# SPDX-License-Identifier: Apache-2.0
"""The validation dossier of the documentation site: what the program claims, and what holds each claim.

The claims are what the program lists of itself. Their evidence is a run of `slipbench check` over the cases, and of `slipbench export` over the
examples, made while the site is built: a check belongs to each claim that its case or it uses. A claim without evidence has its row as well.
"""
import collections
import concurrent.futures
import dataclasses
import html
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
CURVES, DECKS = ROOT / "reference/curves", ROOT / "tests/decks"
WRITTEN, APART, UNSTATED, BACK, DECK = "formula of the case", "computed apart", "origin not stated", "round trip", "deck of the repository"
BESIDE = "---\nhide: [navigation]\n---\n"  # head of a page that is reached from the table
OTHERS = ("run of another program", "published number", "measurement")  # truths that are not of this project


@dataclasses.dataclass
class Check:
    """One comparison: what was compared with which truth, what came out, and the tolerance with its reason."""
    case: str
    name: str
    kind: str
    quantity: str
    against: str
    why: str
    passed: bool
    deviation: float | None = None
    tolerance: float | None = None
    unit: str = ""
    criterion: str = ""
    message: str = "the case does not run"  # of a check that failed
    form: str = ""  # the closed form that it is held against
    part: float | None = None  # the deviation as a part of the largest value, where there is no tolerance

    def verdict(self):
        return "failed" if not self.passed else "told" if self.kind == BACK else "passed"

    def share(self):
        """The deviation as a part of its tolerance, or None; what may not be off at all is off by all of it or by nothing."""
        if self.deviation is None or self.tolerance is None:
            return None
        return self.deviation / self.tolerance if self.tolerance else float("inf") if self.deviation else 0.0

    def rank(self):
        return not self.passed, self.share() or 0.0


@dataclasses.dataclass
class Claim:
    """Something that the program says it does, with what holds it."""
    group: str
    name: str
    words: str
    source: str = ""
    checks: list = dataclasses.field(default_factory=list)
    missing: list = dataclasses.field(default_factory=list)
    refused: list = dataclasses.field(default_factory=list)  # reasons for which examples have no deck

    def cases(self):
        return list(dict.fromkeys(check.case for check in self.checks))

    def kinds(self):
        return collections.Counter(check.kind for check in self.checks)

    def worst(self):
        return max(self.checks, key=Check.rank)

    def verdict(self):
        """The worst of its checks; "told" where none of them has a tolerance to pass."""
        words = {check.verdict() for check in self.checks}
        return next((word for word in ("failed", "passed", "told") if word in words), "not shown")


GROUPS = {  # the page of each kind of claim: its title, what counts as evidence
    "laws": ("Laws of the coefficient", "Checks of the cases whose friction has a coefficient of this law."),
    "connections": ("Connection types", "Checks of the cases whose connector is of this type, or made of it by name, and of the case that "
                    "`slipbench new` writes."),
    "closed-forms": ("Closed forms", "Checks of results against this closed form. That a closed form is itself computed right is held by its own unit tests, "
                     "which are named and not counted."),
    "curves": ("Reference curves", "Checks of results against this curve."),
    "criteria": ("Criteria", "Checks by this criterion: bench and truth agree by it. That a criterion finds a fault is held by its own unit tests in "
                 "`tests/driver/check/criteria`, which are not counted."),
    "keys": ("Keys of a case", "Checks of the cases that use this key. Those that each case must have are in all of them and have no row."),
    "decks": ("Decks of solvers", "The decks of the repository, read, and the examples written as a deck, read back by `slipbench import` and "
              "run beside the case. The tests do the same with all cases (`ctest -R \"come back\"`). A difference is told and not judged here."),
}


def truth(words):
    """The kind of truth that words on an origin begin with, or None."""
    found = re.match(r"(Closed form|Run of \w+|Published|Measured)\b", words)
    return found and {"Published": "published number", "Measured": "measurement"}.get(found[1], found[1][0].lower() + found[1][1:])


def anchor(name):
    return re.sub(r"[^\w-]+", "-", name.lower())


def number(value):
    return f"{value:.3g}"


def percent(share):
    """Cut, not rounded: what is within its tolerance is not told as 100 %."""
    if share >= 10:
        return f"{share:.3g} times" if share < float("inf") else "beyond a tolerance of 0"
    return f"{math.floor(share * 1e4) / 100:.4g} %" if share >= 1e-4 else "0" if share == 0 else "< 0.01 %"


def walk(node, key=None):
    """All (key, value) of a tree of maps and lists; what stands in a list has the list's key."""
    for inner_key, inner in node.items() if isinstance(node, dict) else ((key, one) for one in node) if isinstance(node, list) else ():
        yield inner_key, inner
        yield from walk(inner, inner_key)


class Dossier:
    def __init__(self, site, cases):
        self.site, self.cases = site, pathlib.Path(cases)
        self.claims = {}
        self.tables = 0
        self.connections = site.connections()
        self.cases_of = {}  # case: what it says
        self.texts = {}  # case: (title, head comment, connector types)
        self.sources = dict(re.findall(r"^\| (\w+) \| (.*?) \|", (ROOT / "law/SOURCES.md").read_text(), re.MULTILINE))

    # What the program claims

    def listed(self, what):
        """What the program lists, {name: its words}."""
        return dict(line.split(maxsplit=1) for line in self.site.say("list", what).splitlines() if line.startswith("  "))

    def claim(self, group, name, words, source=""):
        self.claims[group, name] = Claim(group, name, words.strip(), source)

    def list_claims(self):
        required = json.loads(self.site.say("schema"))["required"]
        told = {name: self.site.say("describe", name) for what in ("laws", "closed-forms") for name in self.listed(what)}
        for group in ("laws", "connections", "closed-forms", "curves", "criteria", "keys"):
            if group == "connections":
                for name, (words, _, _) in self.connections.items():
                    self.claim(group, name, words.splitlines()[1])
                continue
            for name, words in self.listed(group).items():
                if group == "keys" and name in required:
                    continue
                source = re.search(r"^  source: (.*)$", told.get(name, ""), re.MULTILINE)
                self.claim(group, name, words, source[1] if source else "")
        for program in self.dialects():
            self.claim("decks", f"export --to {program}", "Writes a case for this program.")
        for program, what in self.readable().items():
            self.claim("decks", f"import {program}", f"Reads {what}.")

    def dialects(self):
        return re.search(r"^  --to (\S+) ", self.site.say("export", "--help"), re.MULTILINE)[1].split("|")

    def readable(self):
        """The kinds of decks that `import` reads, {word of --to: its words}."""
        words = re.search(r"DECK TEXT REQUIRED +(.*)$", self.site.say("import", "--help"), re.MULTILINE)[1]
        found = {one.split()[1].lower().replace("-", ""): one for one in re.split(r",? or |, ", words[0].lower() + words[1:])}
        if not set(found) <= set(self.dialects()):
            sys.exit(f"docs/site/dossier.py: 'import' reads {sorted(found)}, of which 'export' does not know all")
        return found

    # What holds it: cases

    def kind_of(self, against, why):
        """(kind of truth, where it is from) of a check; only what case and reference say."""
        if "closed_form" in against:
            source = self.claims.get(("closed-forms", against["closed_form"]))
            return "closed form", source.source if source else ""
        if "curve" in against:
            return self.kind_of_curve(against["curve"], str(against.get("column", "")))
        cited = next((key for key in re.findall(r"\[(\w+)\]", why) if key in self.sources), None)
        if cited and re.fullmatch(r"= *[-+.\deE]+", str(against["expression"]).strip()):
            return truth(self.sources[cited]) or "published number", cited
        return WRITTEN, ""

    def kind_of_curve(self, name, column):
        page = CURVES / f"{name}.md"
        if not page.exists():
            return UNSTATED, f"{name}, beside the case"
        meaning = next((row for row in re.findall(r"^\| `.*$", page.read_text(), re.MULTILINE) if f"`{column}`" in row), "")
        if APART in meaning:
            return APART, name
        origin = page.read_text().partition("## Origin\n")[2].partition("\n## ")[0]
        return next(filter(None, map(truth, origin.splitlines())), UNSTATED), name

    def laws_of(self, case):
        """The laws that coefficients of friction of a case have."""
        def inside(value):
            if not isinstance(value, dict):
                return {"constant"}
            if "columns" in value:
                return {"table"}
            named = {name for name in value if ("laws", name) in self.claims}
            return named or set().union(*map(inside, value.values()))
        parts = [case.get("friction"), case.get("friction_pairs"), [step.get("change_friction") for step in case["history"] if isinstance(step, dict)]]
        return set().union(*(inside(value) for part in parts for key, value in walk(part) if key == "coefficient"))

    def uses(self, case):
        """The claims that each check of a case bears on."""
        types = [case["connector"]["type"]] if isinstance(case["connector"]["type"], str) else case["connector"]["type"]
        body = {key: value for key, value in case.items() if key not in ("checks", "parameters", "title")}
        keys = {key for key, _ in walk(body)} | set(case)
        return types, {("laws", name) for name in self.laws_of(case)} | {("connections", name) for name in types} | {
            ("keys", name) for group, name in self.claims if group == "keys" and name in keys}

    def run_checks(self, folder, *paths):
        """The verdicts of cases, run in a folder."""
        with tempfile.TemporaryDirectory() as scratch:
            verdicts = pathlib.Path(scratch) / "verdicts.json"
            done = subprocess.run([self.site.program, "check", *paths, "-q", "--json", verdicts], cwd=folder, capture_output=True, text=True)
            if not verdicts.exists():
                sys.exit(f"docs/site/dossier.py: 'slipbench check' ended with {done.returncode}: {done.stderr}")
            return json.loads(verdicts.read_text())["cases"]

    def add_case(self, told, file, name):
        """The checks of a case and its verdicts, each to the claims that it bears on."""
        text = file.read_text()
        case = yaml.load(text, yaml.CSafeLoader)
        types, used = self.uses(case)
        head = " ".join(line[2:].strip() for line in re.match(r"(?:#.*\n)*", text)[0].splitlines())
        self.texts[name] = (case["title"], head, types)
        verdicts = {check["name"]: check for check in told["checks"]}
        for asked in case.get("checks", []):
            against, why = asked["against"], str(asked["tolerance"].get("why", "")).strip()
            kind, source = self.kind_of(against, why)
            criterion = asked.get("criterion", "pointwise")
            check = Check(name, str(asked["name"]), kind, str(asked["quantity"]), told_truth(against, source), why or "no reason stated",
                          False, criterion=criterion, form=against.get("closed_form", ""))
            if asked["name"] in verdicts:
                found = verdicts[asked["name"]]
                check.passed, check.message = found["passed"], found["message"]
                judged = [one for one in found["measures"] if one["tolerance"] is not None]
                deciding = max(judged, key=lambda one: (not one["passed"], Check.share(stand_in(one)) or 0)) if judged else None
                check.deviation, check.tolerance, check.unit = (
                    (deciding["deviation"], deciding["tolerance"], deciding["unit"]) if deciding
                    else (found["worst_deviation"], found["tolerance"], found["unit"]))
            for key in used | {("criteria", criterion), ("closed-forms", against.get("closed_form")), ("curves", against.get("curve"))}:
                if key in self.claims:
                    self.claims[key].checks.append(check)
        self.cases_of[name] = case

    def run_cases(self):
        for told in self.run_checks(self.cases.parent, self.cases.name):
            self.add_case(told, self.cases.parent / told["file"], told["file"])

    def run_minimal(self, scratch):
        """The case that `slipbench new` writes of each connection type."""
        for name in self.connections:
            (scratch / f"{anchor(name)}.yaml").write_text(self.site.say("new", name))
        for told in self.run_checks(scratch, "."):
            name = next(one for one in self.connections if anchor(one) == pathlib.Path(told["file"]).stem)
            self.add_case(told, scratch / told["file"], f"slipbench new {shlex.quote(name)}")

    # What holds it: decks

    def run_decks(self, scratch):
        examples = sorted((self.cases / "examples").glob("*.yaml"))
        jobs = [(program, case) for program in self.dialects() for case in examples]

        def export(job):
            program, case = job
            return subprocess.run([self.site.program, "export", case, "--to", program, "--json", "-o", scratch / f"{case.stem}.{program}"],
                                  capture_output=True, text=True)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            done = list(pool.map(export, jobs))
        for program in self.dialects():
            self.add_dialect(program, [(case, one) for (to, case), one in zip(jobs, done) if to == program])

    def add_dialect(self, program, done):
        out = self.claims["decks", f"export --to {program}"]
        refused, unread = [], 0
        for case, one in done:
            name = f"{self.cases.name}/examples/{case.name}"
            if one.returncode == 2 and "is not exported: " in one.stderr:
                refused.append(one.stderr.strip().rpartition("is not exported: ")[2])
                continue
            told = json.loads(one.stdout).get("on_the_history", {}) if one.returncode == 0 else {}
            if one.returncode == 0 and not told:
                unread += 1
                continue
            out.checks.append(Check(name, "the case, and its deck read back", BACK, "friction force", told.get("text") or one.stderr.strip(),
                                    "a difference is told, not judged", "force_most" in told, told.get("force_most"),
                                    unit=f"of {number(told['force_largest'])}" if "force_largest" in told else "",
                                    part=told["force_most"] / told["force_largest"] if told.get("force_largest") else None))
        if refused:
            counts = collections.Counter(refused)
            out.missing.append(f"{len(refused)} of {len(done)} examples, which are refused")
            out.refused = [f"{reason} ({count})" for reason, count in counts.items()]
        if unread:
            out.missing.append(f"the numbers of {unread} examples: what is written is not read back here")
        out.missing.append("a run of the other program")
        if program not in self.readable():
            return
        back = self.claims["decks", f"import {program}"]
        back.checks += out.checks
        back.missing.append("a deck of the other program's own")
        for deck in sorted((DECKS / program).iterdir()):
            with tempfile.TemporaryDirectory() as folder:
                one = subprocess.run([self.site.program, "import", deck, "--all", "--json", "-o", folder], capture_output=True, text=True)
            found = json.loads(one.stdout) if one.returncode == 0 else []
            back.checks.append(Check(f"{deck.relative_to(ROOT)}", f"reads {counted(len(found), 'case')}", DECK,
                                     "", one.stderr.strip() if one.returncode else "; ".join(case["of"] for case in found), "it is read or not", bool(found)))

    # What was not shown

    def find_missing(self):
        for claim in self.claims.values():
            if claim.group == "decks":
                continue
            if not claim.checks:
                claim.missing.append("all of it: no check of a case")
                continue
            find = getattr(self, "missing_" + claim.group.replace("-", "_"), None)
            if find:
                claim.missing += find(claim)
            if set(claim.kinds()) == {WRITTEN}:
                claim.missing.append("any truth but the cases' own formulas")
            elif not any(kind_is(kind, others) for kind in claim.kinds() for others in OTHERS):
                claim.missing.append("truths of others")

    def bodies(self, claim):
        return [self.cases_of[case] for case in claim.cases()]

    def missing_connections(self, claim):
        told, held, free = self.connections[claim.name]
        named = {str(key) for case in self.bodies(claim) for key, _ in walk({"history": case["history"]})}
        missing = [f"{what} {', '.join(left)}" for what, left in (("motion along", [one for one in free if one not in named]),
                                                                 ("a load of", [one for one in held if one not in named])) if left]
        return missing + ["predefined friction"] * ("predefined friction, parameters" in told and not any(
            key == "predefined" for case in self.bodies(claim) for key, _ in walk(case["friction"])))

    def missing_laws(self, claim):
        told = self.site.say("describe", claim.name)
        parameters = re.findall(r"^    (\w+) .*(?:required|default [^)]*)\)$", told.partition("  symbols\n")[2].partition("\n\n")[0], re.MULTILINE)
        given = {key for case in self.bodies(claim) for name, value in walk({key: case[key] for key in case if key != "checks"})
                 if name == claim.name and isinstance(value, dict) for key in value}
        return [f"parameter {one}" for one in parameters if one not in given] if given else []

    def missing_closed_forms(self, claim):
        told = self.site.say("describe", claim.name)
        outputs = re.findall(r"^    (\w+) ", told.partition("  outputs, ")[2].partition("\n")[2], re.MULTILINE)
        asked = [check["against"] for case in self.bodies(claim) for check in case["checks"] if check["against"].get("closed_form") == claim.name]
        if len(outputs) == 1 or any("output" not in one for one in asked):
            return []  # an output that is left out is that of the column's meaning
        left = [one for one in outputs if one not in {one["output"] for one in asked}]
        return [f"output {', '.join(left)}"] if left else []

    def missing_curves(self, claim):
        columns = re.findall(r"`(\w+)`", " ".join(re.findall(r"^\| (`.*?) \|", (CURVES / f"{claim.name}.md").read_text(), re.MULTILINE)))
        used = " ".join(str(check["against"]) for case in self.bodies(claim) for check in case["checks"])
        left = [one for one in columns if not re.search(rf"\b{one}\b", used)]
        return [f"column {', '.join(left)}"] if left else []

    def missing_keys(self, claim):
        below = re.findall(r"^    (\w+) ", self.site.say("describe", claim.name).partition("  keys below\n")[2], re.MULTILINE)
        used = {key for case in self.bodies(claim) for name, value in walk({key: case[key] for key in case if key != "checks"})
                if name == claim.name for key, _ in walk(value)}
        left = [one for one in below if one not in used]
        return [f"{', '.join(left)} below it"] if left else []

    # Pages

    def pick_pictures(self, scratch):
        """A picture for each claim, of a case that has a check of it: one of the gallery, or of as few others as show all; their jobs."""
        cases = {key: claim.cases() for key, claim in self.claims.items() if key[0] != "decks"}
        gallery = {case: f"gallery/{pathlib.Path(case).stem}" for case in self.texts if case.startswith(f"{self.cases.name}/examples/")}
        self.places = dict(gallery)
        self.pictures = {key: case for key, found in cases.items() for case in found[::-1] if case in gallery}
        jobs = []
        while left := {key: found for key, found in cases.items() if found and key not in self.pictures}:
            case = collections.Counter(one for found in left.values() for one in found).most_common(1)[0][0]
            minimal = case.startswith("slipbench new ")
            stem = anchor(shlex.split(case)[2]) if minimal else pathlib.Path(case).stem
            place = f"dossier/pictures/{stem}{'-minimal' * minimal}"
            jobs.append((scratch, [f"{stem}.yaml"], place) if minimal else (self.cases.parent, [case], place))
            self.places[case] = place
            self.pictures |= {key: case for key, found in left.items() if case in found}
        return jobs

    def command(self, case):
        if case.startswith("slipbench new "):
            return f"{case} | slipbench check -"
        return f"slipbench check {shlex.quote(case)}"

    def commands(self, claim):
        """What makes the evidence of a claim again, in the root of the repository."""
        if claim.group == "decks":
            program = claim.name.split()[-1]
            cases = [case for case in claim.cases() if not case.startswith("tests/")]
            return [f"slipbench import {case} --all -o imported" for case in claim.cases() if case.startswith("tests/")] + [
                f"slipbench export {case} --to {program} -o {pathlib.Path(case).stem}.{program}" for case in cases]
        files = [shlex.quote(case) for case in claim.cases() if not case.startswith("slipbench new ")]
        return [f"slipbench check {' '.join(files)}"] * bool(files) + [self.command(case) for case in claim.cases() if case.startswith("slipbench new ")]

    def page_of(self, case):
        """The page of the evidence that has a case, and its place there."""
        if case not in self.texts:
            return None
        return f"evidence/{anchor(self.texts[case][2][0])}", anchor(case.removeprefix(f"{self.cases.name}/").removesuffix(".yaml")).strip("-")

    def link(self, case, up):
        page = self.page_of(case)
        words = html.escape(case.removeprefix(f"{self.cases.name}/").removesuffix(".yaml"))
        return f'<a href="{up}{page[0]}.html#{page[1]}">{words}</a>' if page else words

    def table(self, heads, rows):
        """The place of a table in a page; the table itself is in a file that hooks.py puts there, as Markdown would read it for half a minute."""
        self.tables += 1
        self.site.write(f".tables/{self.tables}.html", '<div class="dossier"><table><thead><tr>' + "".join(f"<th>{head}</th>" for head in heads)
                        + "</tr></thead><tbody>\n" + "\n".join(rows) + "\n</tbody></table></div>\n")
        return f'<div data-table="{self.tables}"></div>'

    def head_table(self):
        """The one table: a row a claim."""
        heads = ("claim", "kind of truth", "cases", "checks", "worst of its tolerance", "verdict", "not shown")
        rows = []
        for group, (title, _) in GROUPS.items():
            rows.append(f'<tr class="group"><th colspan="{len(heads)}" scope="colgroup"><a href="dossier/{group}.html">{title}</a></th></tr>')
            for claim in (one for one in self.claims.values() if one.group == group):
                kinds = "<br>".join(f"<span>{html.escape(kind)} {count}</span>" for kind, count in claim.kinds().most_common()) or "none"
                rows.append(row(heads, claim.verdict(), (
                    f'<a href="dossier/{group}.html#{anchor(claim.name)}">{html.escape(claim.name)}</a>', kinds, len(claim.cases()), len(claim.checks),
                    worst_of(claim), f"<strong>{claim.verdict()}</strong>", html.escape("; ".join(claim.missing)) or "-"), f"{group}/{claim.name}"))
        return self.table(heads, rows)

    def check_table(self, checks, up=None):
        """The numbers of checks; with the case of each where up leads to the pages of the cases."""
        heads = ("case",) * (up is not None) + ("check", "kind of truth", "off by", "tolerance and its reason", "of it", "verdict")
        rows, back = [], "../" * (up is None)
        for check in checks:
            form = f'<a href="{back}closed-forms.html#{anchor(check.form)}">{html.escape(check.form)}</a> ' * bool(check.form)
            told = html.escape(check.against) if check.kind in (BACK, DECK) else f"against {form}{check.against}"
            asked = f"<br><code>{html.escape(check.quantity)}</code> {told}" + f", by {check.criterion}" * (check.criterion not in ("", "pointwise"))
            if not check.passed and check.kind not in (BACK, DECK):
                asked += f"<br>{html.escape(check.message)}"
            share = check.share()
            rows.append(row(heads, check.verdict(), (self.link(check.case, up),) * (up is not None) + (
                html.escape(check.name) + asked, html.escape(check.kind), "-" if check.deviation is None else f"{number(check.deviation)} {check.unit}",
                ("none" if check.tolerance is None else f"{number(check.tolerance)} {check.unit}") + f"<br>{html.escape(check.why)}",
                "-" if share is None else percent(share), f"<strong>{check.verdict()}</strong>")))
        return self.table(heads, rows)

    def section(self, claim):
        """What holds one claim: its numbers, a picture, the commands, and what was not shown."""
        verdict = claim.verdict()
        text = [f"## {claim.name} {{ #{anchor(claim.name)} }}\n\n<p>{html.escape(claim.words)}</p>\n"]
        if claim.source:
            text.append(f"<p>Source: {html.escape(claim.source)}. Its own tests, not counted here: {self.own_tests(claim.name)}.</p>\n")
        text.append(f'<p class="{verdict.replace(" ", "-")}">Verdict: <strong>{verdict}</strong>; {counted(len(claim.cases()), "case")}, '
                    f"{counted(len(claim.checks), 'check')}. Not shown: {html.escape('; '.join(claim.missing)) or '-'}.</p>\n")
        if claim.refused:
            text.append("<ul>" + "".join(f"<li>refused: {html.escape(one)}</li>" for one in claim.refused) + "</ul>\n")
        text += self.figure(self.pictures.get((claim.group, claim.name)), f"dossier/{claim.group}.md")
        if claim.checks:
            shown, words = sorted(claim.checks, key=Check.rank, reverse=True), "All checks"
            if claim.group in ("laws", "connections", "keys") or len(shown) > 100:  # all of them stand with their cases
                shown, words = list({check.case: check for check in reversed(shown)}.values())[::-1], "The worst check of each case"
            opened = " open" * (len(shown) <= 8)
            text.append(f"<details{opened}><summary>{words}: {counted(len(shown), 'row')}</summary>{self.check_table(shown, '')}</details>\n")
            text.append(f"<details><summary>Make it again</summary><pre><code>{html.escape(chr(10).join(self.commands(claim)))}</code></pre></details>\n")
        return "\n".join(text)

    def own_tests(self, name):
        """The unit tests of the header that has a closed form or a law."""
        header = next((path for folder in ("reference", "law/friction") for path in sorted((ROOT / folder).glob("*.hpp"))
                       if f'.name = "{name}"' in path.read_text() or f'kName = "{name}"' in path.read_text()), None)
        tests = header and [path for path in sorted((ROOT / "tests").rglob("*_test.cpp")) if f'#include "{header.relative_to(ROOT)}"' in path.read_text()]
        return ", ".join(f"<code>{path.relative_to(ROOT)}</code>" for path in tests or []) or "none of that name"

    def figure(self, case, page):
        """The picture of a case, if there is one."""
        place = self.places.get(case)
        if not place or not (self.site.folder / f"{place}.svg").exists():
            return []
        return [*self.site.figure(os.path.relpath(place, pathlib.Path(page).parent), f"{self.texts[case][0]}: friction force over time and motion", page), ""]

    def evidence(self):
        """A page for each connection type: its cases, each with all of its checks; {page: how many cases}."""
        checks = collections.defaultdict(dict)
        for claim in self.claims.values():
            for check in claim.checks:
                checks[check.case][id(check)] = check
        pages = collections.defaultdict(list)
        for case in self.texts:
            pages[self.page_of(case)[0]].append(case)
        for page, cases in pages.items():
            text = [BESIDE + f"# Cases of {self.texts[cases[0]][2][0]}\n\n"
                    "Each case with all of its checks; part of the [validation dossier](../../dossier.md).\n"]
            for case in cases:
                title, head, _ = self.texts[case]
                text.append(f"## {html.escape(title)} {{ #{self.page_of(case)[1]} }}\n\n<p>{html.escape(head)}</p>\n"
                            f"<p><code>{html.escape(self.command(case))}</code></p>\n")
                text += self.figure(case, f"dossier/{page}.md")
                text.append(self.check_table([check for check in checks[case].values() if check.kind != BACK]) + "\n")
            self.site.write(f"dossier/{page}.md", "\n".join(text))
        return {page: len(cases) for page, cases in pages.items()}

    def write(self):
        for group, (title, words) in GROUPS.items():
            claims = [claim for claim in self.claims.values() if claim.group == group]
            self.site.write(f"dossier/{group}.md", BESIDE + f"# What holds it: {title[0].lower()}{title[1:]}\n\n"
                            f"{words} Part of the [validation dossier](../dossier.md).\n\n" + "\n".join(map(self.section, claims)))
        pages = self.evidence()
        kinds = collections.Counter()
        for checks in {id(check): check for claim in self.claims.values() for check in claim.checks}.values():
            kinds[checks.kind] += 1
        verdicts = collections.Counter(claim.verdict() for claim in self.claims.values())
        summary = (f"{len(self.claims)} claims: {verdicts['passed']} passed, {verdicts['failed']} failed, {verdicts['told']} told without a tolerance, "
                   f"{verdicts['not shown']} not shown. "
                   f"{kinds.total()} checks: " + ", ".join(f"{count} by {kind}" for kind, count in kinds.most_common()) + ". "
                   + "No check is against " + ", ".join(f"a {kind}" for kind in OTHERS if not any(kind_is(one, kind) for one in kinds)) + ".")
        links = " · ".join(f'<a href="dossier/{page}.html">{html.escape(page.removeprefix("evidence/"))}</a> {count}' for page, count in sorted(pages.items()))
        words = self.site.folder / "dossier.md"
        self.site.write("dossier.md", (words.read_text() if words.exists() else "") + f"\n{summary}\n\n{self.head_table()}\n\n"
                        f"## The cases\n\n<p>By connection type: {links}.</p>\n")


def row(heads, verdict, cells, name=""):
    """A row of a table, whose cells know their heads: on a phone they stand below each other."""
    claim = f' data-claim="{html.escape(name)}"' if name else ""
    return f'<tr class="{verdict.replace(" ", "-")}"{claim}>' + "".join(f'<td data-head="{head}">{cell}</td>' for head, cell in zip(heads, cells)) + "</tr>"


def counted(count, what):
    return f"{count} {what}{'s' * (count != 1)}"


def stand_in(measure):
    return Check("", "", "", "", "", "", measure["passed"], measure["deviation"], measure["tolerance"])


def kind_is(kind, wanted):
    return kind == wanted or wanted == "run of another program" and kind.startswith("run of ")


def told_truth(against, source):
    """What a check is held against, as HTML; beside the closed form's name."""
    words = plain({key: value for key, value in against.items() if key != "closed_form"}) if "expression" not in against else str(against["expression"])
    cited = f" [{html.escape(source)}]" if "expression" in against and source else ""
    return f"<code>{html.escape(words)}</code>{cited}" if words else ""


def plain(node):
    """A tree as the words of a case."""
    if isinstance(node, dict):
        return ", ".join(f"{key}: {'{' + plain(value) + '}' if isinstance(value, dict) else plain(value)}" for key, value in node.items())
    return f"[{', '.join(map(plain, node))}]" if isinstance(node, list) else str(node)


def worst_of(claim):
    """The worst deviation as a part of its tolerance, for the table."""
    if not claim.checks:
        return "-"
    worst = claim.worst()
    share = max((check.part or 0 for check in claim.checks)) if claim.group == "decks" else worst.share()
    return "-" if share is None else percent(share) + " of the force" * (claim.group == "decks")


def write(site, cases=ROOT / "cases", draw=True):
    """Writes the pages of the dossier into a site."""
    dossier = Dossier(site, cases)
    with tempfile.TemporaryDirectory() as name:
        scratch = pathlib.Path(name)
        (scratch / "new").mkdir()
        dossier.list_claims()
        dossier.run_cases()
        dossier.run_minimal(scratch / "new")
        dossier.run_decks(scratch)
        dossier.find_missing()
        pictures = dossier.pick_pictures(scratch / "new")
        if draw:
            site.light_and_dark(pictures)
    dossier.write()
    return dossier
