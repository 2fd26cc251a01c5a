# SPDX-License-Identifier: Apache-2.0
"""The validation dossier of the documentation site: pages of what the program claims, and of what holds each claim (dossier_evidence.py)."""
import collections
import html
import math
import os
import pathlib
import shlex
import tempfile

from dossier_evidence import BACK, DECK, OTHERS, ROOT, Check, Evidence, anchor, counted, kind_is, number

BESIDE = "---\nhide: [navigation]\n---\n"  # head of a page that is reached from the table

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
              "run beside the case. The tests do the same with all cases (`ctest -R \"come back\"`). Where the export tells no loss of the friction the round "
              "trip is judged; else a difference is told, with what is lost. Drawn is a case that came back, of a contact "
              "with a load and a motion made up for it; the example itself where nothing is imported."),
}


def percent(share):
    """Cut, not rounded: what is within its tolerance is not told as 100 %."""
    if share >= 10:
        return f"{share:.3g} times" if share < float("inf") else "beyond a tolerance of 0"
    return f"{math.floor(share * 1e4) / 100:.4g} %" if share >= 1e-4 else "0" if share == 0 else "< 0.01 %"


class Dossier(Evidence):
    """The pages."""

    def __init__(self, site, cases):
        super().__init__(site, cases)
        self.tables = 0
        self.captions = {}  # of pictures that are not of a case of the repository

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

    def pick_returned(self):
        """A picture for the claims on the decks of each program, of what came back; their jobs."""
        jobs = []
        for program, (words, folder, case) in self.returned.items():
            key, place = f"returned {program}", f"dossier/pictures/returned-{program}"
            self.places[key] = place
            self.captions[key] = (f"{self.texts[case][0]}, written for {program}" + " and read back by import" * (program in self.readable())
                                  + ": friction force over time and motion")
            self.pictures |= {("decks", name): key for name in (f"export --to {program}", f"import {program}") if ("decks", name) in self.claims}
            jobs.append((folder, words, place))
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
        words = self.captions.get(case) or f"{self.texts[case][0]}: friction force over time and motion"
        return [*self.site.figure(os.path.relpath(place, pathlib.Path(page).parent), words, page), ""]

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


def worst_of(claim):
    """The worst deviation as a part of its tolerance, for the table."""
    if not claim.checks:
        return "-"
    share = max((check.share() for check in claim.checks if check.share() is not None), default=None)
    told = max((check.part or 0 for check in claim.checks if check.verdict() == "told"), default=None)
    both = ([] if share is None else [percent(share)]) + ([] if told is None else [f"told: {percent(told)} of the force"])
    return "; ".join(both) or "-"


def write(site, cases=ROOT / "cases", draw=True):
    """Writes the pages of the dossier into a site; without draw only with the pictures of decks, which are its own."""
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
        site.light_and_dark(pictures * draw + dossier.pick_returned())
    dossier.write()
    return dossier
