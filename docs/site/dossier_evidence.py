# SPDX-License-Identifier: Apache-2.0
"""What the program claims, and what holds each claim: the evidence of the validation dossier.

The claims are what the program lists of itself. Their evidence is a run of `slipbench check` over the cases, and of `slipbench export` over the
examples, made while the site is built: a check belongs to each claim that its case or it uses. A claim without evidence is one as well.
"""
import collections
import concurrent.futures
import dataclasses
import html
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
ASKED = {"normal_force": 100, "speed": 10, "time_step": 0.001, "K_t": 1000, "K": 1000, "m": 0.001, "area": 1, "part1": 1, "part2": 2}  # of what is drawn
CURVES, DECKS = ROOT / "reference/curves", ROOT / "tests/decks"
WRITTEN, APART, UNSTATED, BACK, DECK = "formula of the case", "computed apart", "origin not stated", "round trip", "deck of the repository"
# What an export tells that the law does not lose: a deck read back is put into the same joint, with the stiffness, history and checks of its case.
NO_LOSS = re.compile(r"(checks|units|history|stick|internal contact force|springs, dampers and stops|the mass and its belt): |stick stiffness$|"
                     r"OpenSees takes the velocity|[A-Z][A-Z, -]+: the contact force of its geometry")
ROUND_TRIP = 1e-12  # of the largest force
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
        return "failed" if not self.passed else "told" if self.kind == BACK and self.tolerance is None else "passed"

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


def truth(words):
    """The kind of truth that words on an origin begin with, or None."""
    found = re.match(r"(Closed form|Run of \w+|Published|Measured)\b", words)
    return found and {"Published": "published number", "Measured": "measurement"}.get(found[1], found[1][0].lower() + found[1][1:])


def anchor(name):
    return re.sub(r"[^\w-]+", "-", name.lower())


def number(value):
    return f"{value:.3g}"


def walk(node, key=None):
    """All (key, value) of a tree of maps and lists; what stands in a list has the list's key."""
    for inner_key, inner in node.items() if isinstance(node, dict) else ((key, one) for one in node) if isinstance(node, list) else ():
        yield inner_key, inner
        yield from walk(inner, inner_key)


class Evidence:
    """Claims of the program, with their checks."""

    def __init__(self, site, cases):
        self.site, self.cases = site, pathlib.Path(cases)
        self.claims = {}
        self.connections = site.connections()
        self.cases_of = {}  # case: what it says
        self.texts = {}  # case: (title, head comment, connector types)
        self.returned = {}  # program: (what is drawn of its decks as arguments of `plot`, in which folder, its example)
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
            sys.exit(f"docs/site/dossier_evidence.py: 'import' reads {sorted(found)}, of which 'export' does not know all")
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
                sys.exit(f"docs/site/dossier_evidence.py: 'slipbench check' ended with {done.returncode}: {done.stderr}")
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
            self.keep_returned(program, scratch)

    def keep_returned(self, program, scratch):
        """One case to be drawn of a program: the first whose deck `import` reads and that runs, or the example where `import` reads no such deck."""
        checks = [check for check in self.claims["decks", f"export --to {program}"].checks if check.passed]
        for check in sorted(checks, key=lambda one: one.tolerance is None):
            deck, back = scratch / f"{pathlib.Path(check.case).stem}.{program}", f"returned-{program}.yaml"
            if program not in self.readable():
                self.returned[program] = [check.case], self.cases.parent, check.case
                return
            read = subprocess.run([self.site.program, "import", deck, "--json", "--force", "-o", scratch / back], capture_output=True, text=True)
            if read.returncode:
                continue
            # Of a contact a deck has neither load nor motion.
            words = [back, *(word for name in json.loads(read.stdout)[0]["asked"] if name in ASKED for word in ("--set", f"{name}={ASKED[name]}"))]
            if subprocess.run([self.site.program, "run", *words, "--no-output"], cwd=scratch, capture_output=True).returncode == 0:
                self.returned[program] = words, scratch, check.case
                return

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
            out.checks.append(round_trip(name, told, json.loads(one.stdout)["losses"] if told else {}, one.stderr.strip()))
        judged = [check for check in out.checks if check.tolerance is not None]
        if len(judged) < len(out.checks):
            out.missing.append(f"a tolerance for {counted(len(out.checks) - len(judged), 'round trip')}, of which the export tells what is lost")
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


def counted(count, what):
    return f"{count} {what}{'s' * (count != 1)}"


def round_trip(name, told, losses, fault):
    """The check of an example and its deck read back: judged where the export tells no loss of its friction, else a difference is told."""
    most, largest = told.get("force_most"), told.get("force_largest")
    lost = [one for kind in ("approximated", "dropped") for one in losses.get(kind, []) if not NO_LOSS.match(one)]
    check = Check(name, "the case, and its deck read back", BACK, "friction force", told.get("text") or fault,
                  "a difference is told, not judged: the export tells of a loss", most is not None, most,
                  unit=f"of {number(largest)}" if largest is not None else "", part=most / largest if largest else None)
    if most is not None and not lost:
        check.tolerance, check.why = ROUND_TRIP * largest, "numbers are written with all their digits: what remains is rounding of the last one"
        check.passed = most <= check.tolerance and not told["rows_without_counterpart"]
    return check


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
