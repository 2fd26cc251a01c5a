#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests of report pages in headless Chromium: browser_test.py TEST --slipbench EXE --source DIR

TEST is one of
  loads      a page opens from a file without an error, a warning or any request to elsewhere; its content policy, and that of
             a sweep's page, refuses what is put in later
  linked     pointing at one curve marks the same instant in all, with the values of the result
  keyboard   all keys that the page promises; Tab reaches every part
  cases      choosing, filtering, definitions, the address of case and instant; going back
  rows       what is read off at rows, events and worst points is in the CSV and the events of `run`, coarse or late
  thinned    the same of a long run, and what the page says of its thinning
  worst      a failing check stands open, its worst point is that of the result, the instant goes there
  overlay    two runs in one picture, from the start and by choice
  looks      light, dark, a phone of 360 pixels: readable and nothing beside the screen
  print      the printed page has the verdicts and the pictures, on white, and the screen is as before
  hostile    titles, names of files, steps and checks, and reasons that look like HTML or steer a terminal stay text, in a sweep's
             page, too; nothing is run and nothing asked for
  large      fifty cases: less than 5 MB, there in less than a second; the next case in less than 200 ms
  press      a press fit of 100 cycles and 10001 rows: all of them, and 100 cycles in the pictures, in less than 1 MB
  squeal     a steady squeal has constant peaks at every zoom, however many rows
  zoom       dragging, wheel, fingers, keys and buttons zoom and pan; the instant takes the window along
  save       the picture on white, and the rows
  setting    the page says what was run: connection, laws, tables, history, the file; no folder of the machine
  part       a result of every tenth row says so
  long       size and time of loading at 10001 and 1000001 rows
The needs beyond python3 itself are python3-selenium, chromium and chromium-driver.
"""

import argparse
import base64
import bisect
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from browser_page import ActionChains, BrowserPage, Keys, as_number, close, expect, failures, finish, first_number, screen, unpack


def program_run(*arguments, wanted=0):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=120, cwd=folder)
    expect(done.returncode == wanted, f"{arguments} ended with {done.returncode}, wanted {wanted}:\n{done.stdout}{done.stderr}")


def report(*inputs, name="report.html", wanted=0):
    """A page of cases and results."""
    page = folder / name
    program_run("report", *inputs, "-o", page, wanted=wanted)
    if not page.exists():
        sys.exit("\n".join(failures))
    return page


def example(name):
    """A copy of an example beside the page; cases are named as they are given, without folders here."""
    path = f"{name}.yaml"
    (folder / path).write_text((source / "cases/examples" / path).read_text())
    return path


def sweep_page(case, title="A slot"):
    """A page of a sweep of two samples of a case over its mu; the sweep's file is named as the case."""
    file = f"sweep of {case}"
    sweep = {"case": case, "sampler": "grid", "vary": {"mu": {"grid": [0.1, 0.2]}}, "collect": {"peak": {"max": "CSF1"}}}
    (folder / file).write_text(json.dumps({"slipbench": 1, "title": title, "sweep": sweep}))
    program_run("sweep", file, "-o", "swept", "--report", "sweep.html")
    return folder / "sweep.html"


class Page(BrowserPage):
    """A report of cases."""

    def __init__(self, path, address="", **how):
        super().__init__(path, **how)
        self.cases = {case["id"]: case for case in self.document["cases"]}
        for case in self.cases.values():
            case["rows"] = [unpack(column) for column in case.get("rows", [])]
            case["index"] = [int(i) for i in unpack(case["index"])] if "index" in case else None
        self.go(address)

    def instant(self):
        """The time that the bar tells."""
        return as_number(re.match(r"t = (\S+)", self.text(".instant output").replace("\u00a0", " "))[1])

    def chosen(self):
        return self.text("#verdicts tr.chosen a").strip()

    def lines(self):
        """Where the line of the instant stands in each history: {panel: part of the plot's width}."""
        return self.run("""return Object.fromEntries([...document.querySelectorAll("#pictures figure")].map((figure) => {
            const line = figure.querySelector(".cursor-line");
            return [figure.dataset.panel, line && Number(line.getAttribute("x1"))];
        }).filter(([, x]) => x !== null))""")

    def values(self, panel):
        """What the legend of a panel tells: {name: text}."""
        return self.run("""return Object.fromEntries([...document.querySelectorAll(
            `figure[data-panel="${arguments[0]}"] .legend button`)].map((one) =>
                [one.querySelector("bdi").textContent, one.querySelector(".value").textContent.replace(/\\u00a0/g, " ")]))""", panel)

    def column(self, case, name):
        names = [column["name"] for column in case["columns"]]
        return case["rows"][names.index(name)]

    def painted(self, panel, line=0):
        """What is drawn of a line of a panel, in its own units: strokes and bands."""
        return self.run("""const {strokes, bands, dots} = Chart.getChart(document.querySelector(`figure[data-panel="${arguments[0]}"] canvas`)).picture.panel.lines[arguments[1]].painted;
                           return {strokes: strokes.map((one) => one.points || one), bands: bands || [], dots: dots || []};""", panel, line)

    def main_line(self, panel):
        return self.run("""return Chart.getChart(document.querySelector(`figure[data-panel="${arguments[0]}"] canvas`)).picture.panel.lines.findIndex((line) => line.main)""", panel)

    def points(self, panel, line=0):
        """The points of the strokes of a line."""
        strokes = self.painted(panel, line)["strokes"]
        return [(x, y) for stroke in strokes for x, y in zip(stroke[::2], stroke[1::2])]

    def window(self):
        return self.run("""const {min, max} = Chart.getChart(document.querySelector('figure[data-panel="force"] canvas')).scales.x; return [min, max]""")

    def hover(self, panel, part):
        """Points at the middle of a plot's height, at a part of its width."""
        plot = self.find(f'figure[data-panel="{panel}"] .plot')
        self.run("arguments[0].scrollIntoView({block: 'center'})", plot)
        size = plot.size
        ActionChains(self.driver).move_to_element_with_offset(plot, int((part - 0.5) * size["width"]), 0).perform()


class Result:
    """What `run` writes of a case: the oracle for what a page tells."""

    def __init__(self, case):
        name = pathlib.Path(case).stem
        (folder / "results").mkdir(exist_ok=True)
        done = subprocess.run([program, "run", case, "-o", "results"], capture_output=True, text=True, timeout=120, cwd=folder)
        expect(done.returncode in (0, 1), f"run {case} ended with {done.returncode}: {done.stderr}")
        self.rows = self.table(f"{name}.csv")
        self.events = self.table(f"{name}.events.csv")
        self.times = [float(row["t"]) for row in self.rows]

    def table(self, name):
        with open(folder / "results" / name, encoding="utf-8") as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    def place(self, t):
        """The row at a time that the page tells; None if there is none."""
        behind = bisect.bisect_left(self.times, t)
        row = min((i for i in (behind - 1, behind) if 0 <= i < len(self.times)), key=lambda i: abs(self.times[i] - t))
        step = min(abs(self.times[i] - self.times[row]) for i in (row - 1, row + 1) if 0 <= i < len(self.times))
        return row if abs(self.times[row] - t) < 0.2 * step else None


kRegimes = {"0": "no friction", "1": "stick", "2": "slip"}


def check_row(page, result, what, status="STATUS"):
    """The bar and the legends tell a row of the result, and no other."""
    row = result.place(page.instant())
    if row is None:
        expect(False, f"{what}: t = {page.instant()} is no row of the result")
        return
    wanted = result.rows[row]
    for panel in page.run("return [...document.querySelectorAll('#pictures figure')].map((one) => one.dataset.panel)"):
        for name, text in page.values(panel).items():
            if name in wanted:
                expect(close(first_number(text), float(wanted[name]), 4), f"{what}, t = {page.instant()}: {panel} tells {name} = {text}, the result {wanted[name]}")
    expect(page.text(".instant .state") == kRegimes[wanted[status]], f"{what}, t = {page.instant()}: the bar says {page.text('.instant .state')}, the result {wanted[status]}")


def check_event(page, result, number, what):
    """The bar, the legends and the list tell event `number` of the result, from 1."""
    wanted = result.events[number - 1]
    expect(close(page.instant(), float(wanted["t"]), 5), f"{what}: event {number} is at t = {wanted['t']}, shown is {page.instant()}")
    expect(f"event {number} of {len(result.events)}" in page.text(".event-note"), f"{what}: event {number} is told as '{page.text('.event-note')}'")
    expect(page.text(".instant .state") == {"open": "no friction"}.get(wanted["to"], wanted["to"]), f"{what}: event {number} ends in {wanted['to']}, the bar says {page.text('.instant .state')}")
    force = page.values("force")
    for name, column in (("CSF1", "force"), ("FLIM", "limit")):
        expect(close(first_number(force[name]), float(wanted[column]), 4), f"{what}: event {number} has {column} {wanted[column]}, shown is {force[name]}")
    for loop in page.run("return [...document.querySelectorAll('#pictures figure')].map((one) => one.dataset.panel).filter((one) => one.startsWith('loop'))"):
        at = page.values(loop)["CSF1"].split(" at CP1 ")[1]
        expect(close(first_number(at), float(wanted["CP1"]), 4), f"{what}: event {number} is at CP1 = {wanted['CP1']}, shown is {at}")
    expect("near" in page.run("return [...document.querySelectorAll('.scroll tr')].find((row) => row.classList.contains('near'))?.className || ''"), f"{what}: event {number} is not marked in the list")


def written(name, history, checks=""):
    """A slider of 100 N on 1000 N/mm."""
    (folder / f"{name}.yaml").write_text("slipbench: 1\ntitle: " + name + """
units: {length: mm, force: N, time: s}
connector: {type: SLOT}
friction:
  - {predefined: {}, coefficient: 0.2, stick: {stiffness: 1000}}
history:
""" + history + ("checks:\n" + checks if checks else ""))
    return f"{name}.yaml"


def coarse():
    """Twelve increments: all events lie inside of them, and a peak that is too low."""
    return written("coarse", "  - {step: run, duration: 1, increments: 12, force: {f2: 500}, motion: {CP1: {sine: {amplitude: 0.5, frequency: 1.25}}}}\n",
                   "  - {name: spoilt, quantity: CSF1, against: {expression: 'max(min(1000*CP1, 101), -101)'}, tolerance: {absolute: 0.5, why: a test}}\n"
                   "  - {name: peak, criterion: peak, quantity: CSF1, against: {expression: '90*sin(2.5*pi*T)'}, tolerance: {absolute: 0.5, why: a test}}\n")


def late():
    """A hundredth of a second after a thousand."""
    return written("late", "  - {step: wait, duration: 1000, increments: 10, force: {f2: 500}, motion: {CP1: {to: 1000}}}\n"
                           "  - {step: run, duration: 0.01, increments: 200, motion: {CP1: {sine: {amplitude: 0.5, frequency: 300, mean: 1000}}}}\n")


def endless():
    """A thousand cycles of 60 increments; one check is off in three rows after a minute of 200 s."""
    return written("endless", "  - {step: run, duration: 200, increments: 60000, force: {f2: 500}, motion: {CP1: {sine: {amplitude: 0.5, frequency: 5}}}}\n",
                   "  - {name: spike, quantity: CSF1, against: {expression: 'CSF1 + 30*max(0, 1 - abs(T - 60.43)/0.005)'}, tolerance: {absolute: 0.5, why: a test}}\n")


def failing_case():
    """A case one of whose checks is too high by 7 %, and fails."""
    text = (folder / example("shock_absorber")).read_text()
    changed = text.replace("mu*700*v/", "1.07*mu*700*v/").replace("1.07*mu*700*r", "mu*700*r")
    expect(changed != text, "the example has no formula to spoil any more")
    (folder / "spoilt.yaml").write_text(changed)
    return "spoilt.yaml"


def two_runs():
    """The same case with two coefficients, as results; both are named the same."""
    paths = []
    for name, mu in (("old", 0.15), ("new", 0.18)):
        (folder / name).mkdir()
        program_run("run", example("shock_absorber"), "-o", folder / name, "--set", f"mu={mu}")
        paths.append(f"{name}/shock_absorber.csv")
    return paths


# ---------------------------------------------------------------------------------------------------------------------


def loads():
    page_file = report(example("shock_absorber"), example("puck"), example("lift_off"))
    text = page_file.read_text()
    expect("Released under the MIT License" in text, "the chart library's licence is not in the page")
    with Page(page_file) as page:
        expect(page.run("return document.querySelectorAll('#verdicts tbody tr:not(.group)').length") == 3, "not three cases in the list")
        expect(len(page.all("#pictures canvas")) >= 4, "fewer than four pictures")
        drawn = page.run("""return [...document.querySelectorAll("#pictures canvas")].map((canvas) => {
            const pixels = new Set(new Uint32Array(canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.buffer));
            return pixels.size;
        })""")
        expect(min(drawn) > 3, f"an empty picture among {drawn}")
        page.check_requests("a report")
        for case in page.cases:
            page.go("#" + case)
            expect(page.all("#pictures canvas"), f"{case}: no pictures")
        expect(page.text("#totals").startswith("3 cases"), "the totals do not tell the cases")
        page.check_policy("a report")
    with BrowserPage(sweep_page(example("lift_off"))) as page:
        page.go("")
        expect(page.text("h1") == "A slot" and page.all("svg.histogram"), "the page of a sweep shows nothing")
        page.check_requests("a sweep")
        page.check_policy("a sweep", scripts=False)


def linked():
    with Page(report(example("shock_absorber"))) as page:
        case = next(iter(page.cases.values()))
        time_column, force = page.column(case, "t"), page.column(case, "CSF1")
        panels = page.run("return [...document.querySelectorAll('#pictures figure')].map((one) => one.dataset.panel)")
        histories = [panel for panel in panels if not panel.startswith(("loop", "path"))]
        loops = [panel for panel in panels if panel.startswith(("loop", "path"))]
        expect(len(histories) >= 4 and loops, f"panels are {panels}")
        seen = set()
        for panel, parts in ((histories[0], (0.35, 0.8)), (histories[-1], (0.5, 0.65))):
            for part in parts:
                page.hover(panel, part)
                marks = page.lines()
                expect(sorted(marks) == sorted(histories), f"no line in {set(histories) - set(marks)}")
                expect(max(marks.values()) - min(marks.values()) < 0.6, f"lines stand apart: {marks}")
                now = page.instant()
                seen.add(now)
                row = min(range(len(time_column)), key=lambda i: abs(time_column[i] - now))
                expect(close(now, time_column[row], 5), f"pointed at t = {now}, which is no row of the result")
                told = first_number(page.values("force")["CSF1"])
                expect(any(close(told, force[i], 4) for i in range(len(force)) if close(now, time_column[i], 5)),
                       f"at t = {now} the legend tells {told}, the result {force[row]}")
                expect(first_number(page.values(loops[0])["CSF1"]) == told, "loop and history tell different forces")
        expect(len(seen) == 4, f"pointing elsewhere changed nothing: {seen}")
        # The loop: its dot is at force and motion of the instant, so a point of it moves the histories too.
        before = page.lines()
        page.hover(loops[0], 0.9)
        expect(page.lines() != before, "pointing at the loop moves no line")
        expect(page.run("return document.querySelectorAll('#pictures .cursor-dot').length") >= len(panels), "a picture has no dot")


def keyboard():
    with Page(report(example("shock_absorber"), example("puck"), example("lift_off")), "#shock_absorber") as page:
        case = page.cases["shock_absorber"]
        times = page.column(case, "t")
        page.press(Keys.HOME)
        expect(page.instant() == times[0], f"Home goes to {page.instant()}")
        page.press(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
        expect(close(page.instant(), times[3], 5), f"three steps go to {page.instant()}, wanted {times[3]}")
        page.press(Keys.ARROW_LEFT)
        expect(close(page.instant(), times[2], 5), f"a step back goes to {page.instant()}, wanted {times[2]}")
        page.press(Keys.END)
        expect(close(page.instant(), times[-1], 5), f"End goes to {page.instant()}")
        page.press(Keys.HOME, "n")
        expect(close(page.instant(), case["events"][0]["t"], 5) or case["events"][0]["t"] == times[0], f"n goes to {page.instant()}")
        page.press("n")
        expect(page.run("return document.querySelectorAll('tr.near').length") == 1, "no event is marked")
        page.press("j")
        expect(page.chosen() == "puck", f"j goes to {page.chosen()}")
        page.press("k")
        expect(page.chosen() == "shock_absorber", f"k goes to {page.chosen()}")
        page.find("#verdicts tr.chosen a").send_keys(Keys.ARROW_DOWN)
        expect(page.chosen() == "puck", f"the arrow goes to {page.chosen()}")
        expect(page.run("return document.activeElement.textContent") == "puck", "the focus stays behind")
        page.press("t")
        expect(page.run("return document.querySelector('#theme').getAttribute('aria-label')").endswith("light"), "t changes no colours")
        page.press("?")
        expect(page.run("return document.querySelector('#help').open"), "? shows no keys")
        page.press(Keys.ESCAPE)
        expect(not page.run("return document.querySelector('#help').open"), "Escape leaves the keys open")
        page.press("/", *"lift", Keys.ESCAPE)
        expect(page.run("return document.querySelector('#filter').value") == "", "Escape keeps the filter")
        # Tab goes through the whole page, and every stop is named and seen.
        page.go("#shock_absorber")
        stops = []
        for _ in range(200):
            page.press(Keys.TAB)
            stop = page.run("""const on = document.activeElement;
                if (on === document.body) return null;
                const style = getComputedStyle(on);
                return [on.id || on.className || on.tagName, (on.getAttribute("aria-label") || on.textContent || "").trim() !== "" || on.labels?.length > 0,
                        style.outlineStyle !== "none" || on.id === "case"];""")
            if stop is None:
                break
            stops.append(stop)
        names = [stop[0] for stop in stops]
        for wanted in ("skip", "theme", "filter", "failures", "instant", "help-open", "print"):
            expect(wanted in names, f"Tab does not reach {wanted}: {names}")
        expect(len(names) < 200, "Tab finds no end")
        expect(all(named for _, named, _ in stops), f"stops without a name: {[name for name, named, _ in stops if not named]}")
        expect(all(seen for _, _, seen in stops), f"the focus is not seen on {[name for name, _, seen in stops if not seen]}")


def cases():
    with Page(report(example("shock_absorber"), example("puck"), example("lift_off")), "#puck") as page:
        expect(page.chosen() == "puck", "the address chooses no case")
        tabs = page.all("[role=tab]")
        expect([tab.text for tab in tabs] == ["sliding", "spinning"], f"definitions are {[tab.text for tab in tabs]}")
        expect(page.all('figure[data-panel="path:force"]'), "motion in a plane shows no path of the force")
        expect(len(page.all('figure[data-panel="path:force"] .limit-circle')) == 2, "the limit is no circle")
        tabs[1].click()
        expect(not page.all('figure[data-panel="path:force"]') and "CSM1" in page.values("force"), "the other definition is not drawn")
        page.find("#verdicts tbody tr:nth-child(3)").click()
        page.wait("return location.hash.startsWith('#lift_off')", "choosing a case leaves the address")
        expect(page.text("h2") == json.loads(json.dumps(page.cases["lift_off"]["title"])), "the title is another case's")
        page.run("history.back()")
        page.wait("return document.querySelector('#verdicts tr.chosen a').textContent === 'puck'", "going back does not")
        page.go("#lift_off@1.5")
        expect(close(page.instant(), 1.5, 5), f"the address names t = 1.5, shown is {page.instant()}")
        page.press(Keys.END)
        page.wait("return /@\\d/.test(location.hash) && !location.hash.endsWith('@1.5')", "the address does not follow the instant")
        page.find("#filter").send_keys("PUCK")
        visible = "return [...document.querySelectorAll('#verdicts tbody tr:not(.group)')].filter((row) => !row.hidden).length"
        expect(page.run(visible) == 1, "the filter keeps other cases")
        page.find("#filter").send_keys("xyz")
        expect(page.run(visible) == 0 and page.find("#none").is_displayed(), "an empty list says nothing")
        page.find("#filter").clear()
        page.find("#filter").send_keys(" ")
        page.find("#failures").click()
        expect(page.run(visible) == 0, "passed cases among the failures")
        page.find("#failures").click()
        # Events: choosing one shows its instant; arrows go through the list.
        events = page.cases["lift_off"]["events"]
        button = page.all(".scroll td button")[2]
        page.run("arguments[0].scrollIntoView({block: 'center'})", button)
        button.click()
        expect(close(page.instant(), events[2]["t"], 5), f"the third event is at {events[2]['t']}, shown is {page.instant()}")
        page.press(Keys.ARROW_DOWN)
        expect(close(page.instant(), events[3]["t"], 5), f"the fourth event is at {events[3]['t']}, shown is {page.instant()}")
        expect("no friction" in page.text("#shades"), "lift-off without a word of no friction")


def rows():
    paths = [coarse(), late()]
    results = {path.split(".")[0]: Result(path) for path in paths}
    with Page(report(*paths)) as page:
        for name, result in results.items():
            page.go("#" + name)
            case = page.cases[name]
            expect(len(set(case["rows"][0])) == len(set(result.times)), f"{name}: {len(set(case['rows'][0]))} times of {len(set(result.times))} are told apart")
            expect(case["rows_shown"] == len(result.rows), f"{name}: {case['rows_shown']} rows of {len(result.rows)}")
            page.press(Keys.HOME)
            check_row(page, result, name)
            for _ in range(6):
                page.press(Keys.ARROW_RIGHT)
                check_row(page, result, name)
            page.press(Keys.END)
            check_row(page, result, name)
            page.press(Keys.HOME)
            expect(close(page.instant(), result.times[0]), "Home is not at the first row")
            first = 1 if float(result.events[0]["t"]) > result.times[0] else 2
            for number in range(first, min(len(result.events), 9) + 1):
                page.press("n")
                check_event(page, result, number, name)
            page.press("p")
            check_event(page, result, min(len(result.events), 9) - 1, name)
            # The address leads to the event again, and without an instant to none.
            page.wait("return location.hash.includes('@event')", "no event in the address")
            page.go(page.run("return location.hash"))
            check_event(page, result, min(len(result.events), 9) - 1, name + ", by its address")
        page.go("#coarse@")
        expect(page.instant() > 0.0, "an address without an instant goes to t = 0")
        # The page opened at the worst point.
        page.go("#coarse")
        check_row(page, results["coarse"], "the worst point")
        check = next(one for one in page.cases["coarse"]["checks"] if one["name"] == "spoilt")
        expect(close(page.instant(), check["worst"]["time"], 5), f"opens at t = {page.instant()}, worst is {check['worst']['time']}")
        peak = [text.replace("\u00a0", " ") for text in page.texts(".worst-words")][1]
        expect(re.search(r"smallest value \S+ N, wanted is \S+ N", peak), f"a peak is told as '{peak}'")
        expect("against" not in page.texts(".worst-label")[-1], f"a peak is set against '{page.texts('.worst-label')[-1]}'")
        # The corner of the first slip is drawn: the loop has points that are no rows.
        drawn = page.points(page.run("return document.querySelector('figure[data-panel^=\"loop\"]').dataset.panel"))
        corner = [float(results["coarse"].events[0][name]) for name in ("CP1", "force")]
        expect(any(close(x, corner[0], 5) and close(y, corner[1], 5) for x, y in drawn), f"the loop has no corner at {corner}")
        units = set(re.findall(r"mJ|N mm", page.text("#run .beside").replace("\u00a0", " ") + page.text(".summary")))
        expect(units == {"mJ"}, f"energies in {units}")


def thinned():
    path = endless()
    result = Result(path)
    with Page(report(path)) as page:
        case = page.cases["endless"]
        said = page.text("#thinned").replace("\u00a0", " ")
        check_row(page, result, "the worst point")
        expect(result.times[result.place(page.instant())] == float(min(result.times, key=lambda t: abs(t - 60.43))), f"the worst row is at 60.43, shown is {page.instant()}")
        values = page.values("trace")
        expect(close(first_number(values["value"]), first_number(page.values("force")["CSF1"])), f"the check tells {values}, the history {page.values('force')}")
        # Every drawn row is a row, with its state.
        places = [result.place(t) for t in case["rows"][0]]
        expect(None not in places and len(set(places)) == len(places), "drawn rows that are none of the result")
        for name in ("CSF1", "CP1", "STATUS"):
            wrong = [t for t, place, value in zip(case["rows"][0], places, page.column(case, name)) if not close(value, float(result.rows[place][name]), 6)]
            expect(not wrong, f"{name} is another at {wrong[:3]}")
        for part in (0.1, 0.37, 0.62, 0.9):
            page.hover("force", part)
            check_row(page, result, "thinned")
        # What is said of the thinning is so.
        numbers = re.search(r"The run has (\d+) rows. Histories show .* of every (\d+) rows", said)
        expect(numbers, f"the thinning is told as '{said}'")
        rows_in_all, piece = map(int, numbers.groups())
        expect(rows_in_all == len(result.rows), f"'{said}' of {len(result.rows)} rows")
        expect(places == case["index"], "the page counts its rows differently")
        drawn = set(places)
        for begin in range(0, len(result.rows), piece):
            expect({begin, min(begin + piece, len(result.rows)) - 1} <= drawn, f"an end of the piece at {begin} is missing")
        cycles = re.search(r"the cycles ([\d, ]+) of (\d+) \(of CP1\)", said)
        expect(cycles and int(cycles[2]) == 1000, f"no 1000 cycles in '{said}'")
        named = [int(number) for number in cycles[1].split(",")]
        expect(named[0] == 1 and named[-1] == 1000 and 10 in named and 100 in named, f"cycles {named}")
        for number in named:
            from_row, to_row = 60 * (number - 1), 60 * number
            expect(set(range(from_row, to_row + 1)) <= drawn, f"cycle {number} is not whole")
        # A loop is drawn in whole cycles, and nothing between rows that are not neighbours.
        force, motion = ([float(row[name]) for row in result.rows] for name in ("CSF1", "CP1"))
        loop = page.run("return document.querySelector('figure[data-panel^=\"loop\"]').dataset.panel")
        shown = page.painted(loop)
        expect(len(shown["dots"]) == 0, "dots beside whole cycles")
        longest = max(abs(a - b) for a, b in zip(motion, motion[1:]))
        for stroke in shown["strokes"]:
            steps = [abs(b - a) for a, b in zip(stroke[:-2:2], stroke[2::2])]
            expect(max(steps) <= 1.001 * longest, f"a loop jumps by {max(steps)}, a row by {longest}")
        ways = sum(abs(b - a) for stroke in shown["strokes"] for a, b in zip(stroke[:-2:2], stroke[2::2]))
        cycle_way = 4 * 0.5
        expect(abs(ways / cycle_way - len(named)) < 0.2, f"the loops go {ways / cycle_way} cycles, named are {len(named)}")
        # Of each column of pixels the picture has the extremes, at any zoom.
        for window in ([0, 200], [60.2, 61.7], [100, 104]):
            page.run("location.hash = arguments[0]", f"#endless@{sum(window) / 2}")
            page.wait(f"return Math.abs(parseFloat(document.querySelector('.instant output').textContent.split(' ')[2]) - {sum(window) / 2}) < 1", "the address does not lead on")
            page.press("0")
            while page.window()[1] - page.window()[0] > 1.9 * (window[1] - window[0]):
                page.press("+")
            begin, end = page.window()
            painted = page.painted("force", page.main_line("force"))
            cells = 20
            for cell in range(cells):
                left, right = begin + cell * (end - begin) / cells, begin + (cell + 1) * (end - begin) / cells
                rows_in = [f for t, f in zip(result.times, force) if left <= t <= right]
                seen = [y for stroke in painted["strokes"] for x, y in zip(stroke[::2], stroke[1::2]) if left <= x <= right]
                seen += [y for x, until, low, high in painted["bands"] if x <= right and until >= left for y in (low, high)]
                # What a piece or a column of pixels has beside the border may be drawn, too.
                beside = max(piece * 200 / 60000, (end - begin) / 300)
                rows_about = [f for t, f in zip(result.times, force) if left - beside <= t <= right + beside]
                for name, pick, sign in (("smallest", min, -1), ("largest", max, 1)):
                    drawn_one = sign * pick(seen)
                    expect(sign * pick(rows_in) - 1e-3 <= drawn_one <= sign * pick(rows_about) + 1e-3,
                           f"t = {left} to {right}: the {name} force drawn is {pick(seen)}, that of the rows {pick(rows_in)}")
            for stroke in painted["strokes"]:
                times = stroke[::2]
                for one, other in zip(times, times[1:]):
                    gap = abs(other - one) > 1.5 * (200 / 60000) and abs(other - one) > 1.5 * (end - begin) / 300
                    expect(not gap, f"a line joins t = {one} and {other}, which are no neighbours")
        page.press("0")
        # Merged spans are no slip, and the part of slip is the summary's.
        percent = re.search(r"slips (\d+) % of the time", page.text(".summary"))[1]
        expect(f"slip {percent} % of the time" in page.text("#shades"), f"the summary says {percent} %, the page '{page.text('#shades')}'")
        expect("stick and slip, too fast to draw" in page.text("#shades"), "chatter is shaded without a word")
        status = page.column(case, "STATUS")
        for begin, end, regime, *merged in case["definitions"][0]["spans"]:
            inner = [s for t, s in zip(case["rows"][0], status) if begin * (1 + 1e-9) < t < end * (1 - 1e-9)]
            expect(merged or all(s == regime for s in inner), f"shaded as {regime} from {begin} to {end}, the rows say {set(inner)}")
        # The list of events: first and last, and nothing between them is marked.
        total = len(result.events)
        expect(f"The first 100 and the last 100 of {total} events" in page.text("#events-caption"), f"the list says '{page.text('#events-caption')}'")
        page.run("location.hash = '#endless@100'")
        page.wait("return document.querySelector('.instant output').textContent.startsWith('t = 9') || document.querySelector('.instant output').textContent.startsWith('t = 1')", "the address does not lead to t = 100")
        check_row(page, result, "t = 100")
        expect(page.run("return document.querySelectorAll('tr.near').length") == 0, "an event is marked though its neighbours are not listed")
        for number in (1, 100, total - 99, total):
            page.go(f"#endless@event{number}")
            check_event(page, result, number, "thinned")
            page.press("p" if number in (total, total - 99) else "n")
            other = {1: 2, 100: total - 99, total - 99: 100, total: total - 1}[number]
            check_event(page, result, other, "thinned, beside " + str(number))
        page.go(f"#endless@event{total}")
        expect(page.run("return [...document.querySelectorAll('.steps button')].map((one) => one.disabled)") == [False, True], "behind the last event there is another")
        page.go("#endless")
        page.find(".detail-tools button:last-child").click()
        limits = page.run("""const {min, max} = Chart.getChart(document.querySelector('figure[data-panel="trace"] canvas')).scales.x; return [min, max];""")
        expect(0.02 < limits[1] - limits[0] < 0.08, f"zoomed to {limits}, which is not eight rows on each side")


def worst():
    (folder / "bad.yaml").write_text("slipbench: 1\ntitel: x\n")
    with Page(report(example("shock_absorber"), failing_case(), "bad.yaml")) as page:
        case = page.cases["spoilt"]
        check = next(check for check in case["checks"] if not check["passed"])
        expect(page.chosen() == "spoilt", "the page does not open at the failing case")
        expect(close(page.instant(), check["worst"]["time"], 5), f"opens at t = {page.instant()}, worst is {check['worst']['time']}")
        first = page.run("return document.querySelector('.checks .name button').textContent")
        expect(first == check["name"], f"first of the checks is '{first}'")
        expect(page.find(".checks .detail").is_displayed(), "the failing check is closed")
        said = page.text(".worst-words").replace("\u00a0", " ")
        value, reference = re.match(r"Worst: (\S+).* where (\S+)", said).groups()
        expect(close(as_number(value), check["worst"]["value"], 6), f"'{said}' is not {check['worst']}")
        expect(close(as_number(reference), check["worst"]["reference"], 6), f"'{said}' is not {check['worst']}")
        # The ring is where the value is worst: its place in the trace against that of the result's rows.
        ring = 'figure[data-panel="trace"] .worst-ring'
        expect(len(page.all(ring)) == 1, "the worst point is not marked")
        expect("worst" in page.text('figure[data-panel="trace"] .worst-label'), "the worst point has no label")
        x = page.run("return Number(document.querySelector(arguments[0]).getAttribute('cx'))", ring)
        page.press(Keys.HOME)
        expect(not close(page.instant(), check["worst"]["time"], 5), "Home stays at the worst point")
        page.find(".go-worst").click()
        expect(close(page.instant(), check["worst"]["time"], 5), "the button does not lead to the worst point")
        line = page.run("return Number(document.querySelector('figure[data-panel=\"trace\"] .cursor-line').getAttribute('x1'))")
        expect(abs(x - line) < 0.6, f"ring at {x}, instant at {line}")
        result = Result("spoilt.yaml")
        check_row(page, result, "the worst point")
        told = first_number(page.values("trace")["value"])
        wanted = float(result.rows[result.place(page.instant())][check["quantity"]])
        expect(close(told, wanted, 4), f"the check's picture tells {told}, the result {wanted}")
        page.press(Keys.HOME, "w")
        expect(close(page.instant(), check["worst"]["time"], 5), "w does not lead to the worst point")
        # The tube: colour between reference and tolerance.
        expect(page.all('figure[data-panel="deviation"] canvas'), "no picture of the deviation")
        page.find("#failures").click()
        expect(page.run("return [...document.querySelectorAll('#verdicts tbody tr:not(.group)')].filter((row) => !row.hidden).length") == 2, "two do not pass")
        page.press("j")
        page.wait("return document.querySelector('main pre') !== null", "a case that was not run says nothing")
        expect("titel" in page.text("main pre"), "the reader's message is missing")


def overlay():
    with Page(report(*two_runs())) as page:
        ids = list(page.cases)
        expect(page.document["compare"] == [ids], f"{ids} are not compared: {page.document['compare']}")
        expect("Compared with 1 run" in page.text("#compare summary"), "nothing is compared from the start")
        told = page.values("force")
        other = page.cases[ids[1]]["name"]
        expect(other in told, f"the other run is not in the legend: {told}")
        page.hover("force", 0.5)
        now = page.instant()
        told = page.values("force")
        expect("are those of" in page.text("#shaded-run") and page.cases[ids[0]]["name"] in page.text("#shaded-run"), "nothing says whose shades these are")
        for run, name in (("old", "CSFC"), ("new", other)):
            with open(folder / run / "shock_absorber.csv", encoding="utf-8") as file:
                rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
            nearest = min(abs(float(row["t"]) - now) for row in rows)
            wanted = [float(row["CSFC"]) for row in rows if abs(float(row["t"]) - now) <= nearest + 1e-5]
            expect(any(close(first_number(told[name]), one, 3) for one in wanted), f"{name} tells {told[name]} at t = {now}, the result {wanted}")
        dashes = page.run("""return [...document.querySelectorAll('figure[data-panel="force"] .legend line')]
            .map((line) => line.getAttribute("stroke-dasharray"))""")
        expect(len(set(dashes)) == len(dashes), f"curves that are alike in grey: {dashes}")
        page.run("document.querySelector('#compare').scrollIntoView({block: 'center'})")
        page.find("#compare summary").click()
        box = page.wait("return document.querySelector('#compare input') !== null", "nothing to choose") and page.find("#compare input")
        box.click()
        expect(other not in page.values("force"), "the other run stays")
        page.find("#compare input").click()
        expect(other in page.values("force"), "the other run does not come back")


def looks():
    page_file = report(failing_case(), coarse(), example("puck"), example("press_fit"), example("hinge_wear"))
    back = "return getComputedStyle(document.body).backgroundColor"
    with Page(page_file) as page:
        for width, dark in ((1280, False), (1280, True), (768, False), (360, False), (360, True)):
            screen(page.driver, width, 900, dark)
            page.go("")
            light = page.run("const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number); return r + g + b") > 600
            expect(light != dark, f"{width} pixels, dark {dark}: background {page.run(back)}")
            for case in page.cases:
                page.run("location.hash = arguments[0]", "#" + case)
                page.wait(f"return document.querySelector('main .case-name').textContent === '{page.cases[case]['name']}'", f"{case} does not come")
                wide, there = page.overflow()
                expect(wide <= there, f"{case}: {wide} pixels wide on a screen of {there}")
                cut = page.run("""return [...document.querySelectorAll("main svg text, #pictures h4, .legend button")].filter((one) => {
                    const box = one.getBoundingClientRect();
                    const svg = one.closest("svg");
                    const place = svg ? svg.getBoundingClientRect() : {left: 0, right: innerWidth};
                    return box.right > place.right + 1 || box.left < place.left - 1;
                }).map((one) => one.textContent)""")
                expect(not cut, f"{case}, {width} pixels: cut off: {cut}")
                # What does not fit scrolls, and keys can scroll it.
                stuck = page.run("""return [...document.querySelectorAll(".sideways")]
                    .filter((one) => one.scrollWidth > one.clientWidth + 1 && one.tabIndex !== 0).map((one) => one.textContent.slice(0, 20))""")
                expect(not stuck, f"{case}, {width} pixels: no key reaches {stuck}")
                if width == 1280:
                    hidden = page.run("return [...document.querySelectorAll('.sideways')].filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => one.textContent.slice(0, 20))")
                    expect(not hidden, f"{case}: cut on a usual screen: {hidden}")
                if width == 360:
                    small = page.run("""return [...document.querySelectorAll("#verdicts a, input[type=checkbox], .legend button, .scroll td button, .checks .name button")]
                        .filter((one) => one.getBoundingClientRect().height > 0 && Math.min(one.getBoundingClientRect().height, one.getBoundingClientRect().width) < 23.9)
                        .map((one) => one.textContent || one.id)""")
                    expect(not small, f"{case}: too small for a finger: {small[:4]}")
                page.check_contrast(f"{case}, {width} pixels, dark {dark}")
            page.check_curves(f"dark {dark}")
        page.press("t")
        expect(page.run(back) == "rgb(255, 255, 255)", "light by choice stays dark")
        page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-reduced-motion", "value": "reduce"}]})
        page.go("#spoilt")
        turning = page.run("return getComputedStyle(document.querySelector('.checks .name button'), '::before').transitionProperty")
        expect(turning == "none", f"against the wish for no motion: transition {turning}")


def print_page():
    with Page(report(failing_case(), example("lift_off")), dark=True) as page:
        size = "return [...document.querySelectorAll('#pictures canvas')].map((canvas) => canvas.getBoundingClientRect().width)"
        before = page.run(size)
        pdf = base64.b64decode(page.driver.print_page())
        expect(pdf.startswith(b"%PDF") and len(pdf) > 60_000, f"a printed page of {len(pdf)} bytes")
        sheets = len(re.findall(rb"/Type\s*/Page\b", pdf))
        expect(2 <= sheets <= 8, f"{sheets} sheets")
        # Chromium keeps canvases as drawings where it can, as images where not.
        drawn = len(re.findall(rb"/Subtype\s*/(?:Image|Form)", pdf))
        expect(drawn >= 6, f"{drawn} pictures on paper")
        page.wait("return document.documentElement.dataset.theme === 'dark'", "after printing the page stays light")
        after = page.run(size)
        expect(len(after) == len(before) and all(abs(a - b) <= 2 for a, b in zip(after, before)), f"after printing the pictures are {after} wide, before {before}")
        # As on paper: white, nothing scrolls, no tools.
        page.run("window.dispatchEvent(new Event('beforeprint'))")
        expect(page.run("return getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)", "paper is not white")
        expect(page.run("return document.documentElement.dataset.theme") == "light", "curves for a dark screen on paper")
        expect(not page.find("#filter").is_displayed(), "the filter is printed")
        hidden = page.run("return [...document.querySelectorAll('.scroll, .cases')].filter((one) => one.scrollHeight > one.clientHeight + 2).length")
        expect(hidden == 0, "a printed table is cut off")
        # The marks lie over the curves: only a canvas of a whole ratio keeps its size on paper.
        ratios = page.run("return [...document.querySelectorAll('main canvas')].map((canvas) => [canvas.width / canvas.clientWidth, canvas.height / canvas.clientHeight])")
        expect(all(abs(ratio - 2) < 0.01 for pair in ratios for ratio in pair), f"canvases of the ratios {ratios}")
        wide = page.run("return Math.max(...[...document.querySelectorAll('main canvas')].map((canvas) => canvas.getBoundingClientRect().right))")
        expect(wide <= 701, f"pictures reach to {wide} of 700 pixels")


def renamed(text, word):
    """A case whose title, steps, checks and reasons begin with a word."""
    def quoted(rest=""):
        # Between single quotes of YAML a quote is doubled.
        return "'" + (word + rest).replace("'", "''") + "'"
    text = re.sub(r"^title:.*$", lambda _: "title: " + quoted(), text, count=1, flags=re.MULTILINE)
    for begin, rest in ((r"\bstep: ", "[a-z ]*[a-z]"), (r"- name: ", "[^\n]+"), (r"\bwhy: ", "[^}\n]+")):
        text, count = re.subn(f"({begin})({rest})", lambda found: found[1] + quoted(" " + found[2]), text)
        expect(count >= 3, f"the example has only {count} of '{begin}'")
    return text


def hostile():
    words = ["<script>window.broken = 1</script>", "</script><img src=x onerror='window.broken = 2'>", "<!-- ", "{{script}} &amp; \"'"]
    text = (folder / example("lift_off")).read_text()
    paths = []
    for i, word in enumerate(words):
        path = f"case_{i}.yaml"
        (folder / path).write_text(renamed(text, word))
        paths.append(path)
    strange = ["<b>bold<b> & #@1", "%1b[31m<u>gpj"]
    for name in strange:
        (folder / f"{name}.yaml").write_text(text)
    with Page(report(*paths, *(f"{name}.yaml" for name in strange))) as page:
        expect(page.run("return window.broken") is None, "a title was run as a script")
        untold = "return document.querySelectorAll('main img, main script, main u, aside b b, aside u, aside script').length"
        expect(page.run(untold) == 0, "a title became an element")
        for i, word in enumerate(words):
            page.run("location.hash = arguments[0]", f"#case_{i}")
            page.wait(f"return document.querySelector('main .case-name').textContent === 'case_{i}'", f"case_{i} does not come")
            case = page.cases[f"case_{i}"]
            expect(page.text("h2") == case["title"], f"the title is {page.text('h2')!r}, wanted {word!r}")
            page.run("document.querySelectorAll('main button[aria-expanded=\"false\"]').forEach((one) => one.click())")
            # The file's own text, which the page shows as well, is in none of these.
            shown = "\n".join(page.texts("main td, main button bdi, main p bdi")).replace("\u00a0", " ")
            steps = next(table for table in case["run"]["tables"] if table["title"] == "History")["rows"]
            told = [step[0] for step in steps] + [check[key] for check in case["checks"] for key in ("name", "why")]
            expect(len(told) == 11, f"case_{i} tells {told}")
            for one in told:
                expect(one.startswith(word.strip()), f"the program changes '{one}', so this proves nothing")
                expect(one in shown, f"case_{i} does not show {one!r}")
            expect(page.run(untold) == 0 and page.run("return window.broken") is None, f"a text of case_{i} became an element or was run")
        expect(page.cases["case_0"]["title"] == words[0], "the program changes titles, so this proves nothing")
        for name in strange:
            expect(name in page.cases, f"{name!r} is not one of {list(page.cases)}")
            page.run("""[...document.querySelectorAll("#verdicts tbody tr")].find((one) =>
                one.querySelector("a")?.textContent.trim() === arguments[0].trim())?.click()""", name)
            page.wait(f"return document.querySelector('main .case-name').textContent === {json.dumps(name)}", f"{name!r} does not come")
            page.press(Keys.END)
            page.wait("return location.hash.includes('@')", "no instant in the address")
            page.go(page.run("return location.hash"))
            expect(page.text("main .case-name") == name, f"{name!r} is not found by its address, but {page.text('main .case-name')!r}")
        expect(page.run(untold) == 0 and page.run("return window.broken") is None, "a name became an element or was run")
        page.check_requests("hostile texts")
    title = " ".join(words)
    with BrowserPage(sweep_page("<b>bold<b> & #@1.yaml", title)) as page:
        page.go("")
        expect(page.text("h1") == title and page.text("title") == title, f"a sweep's title is shown as {page.text('h1')!r} and {page.text('title')!r}")
        expect("<b>bold<b>" in page.text("main > p"), f"a sweep's case is shown as {page.text('main > p')!r}")
        expect(page.run("return document.querySelectorAll('script, img, b b').length") == 0, "a sweep's title became an element")
        expect(page.run("return window.broken") is None, "a sweep's title was run as a script")
        page.check_requests("a hostile sweep")


def press_fit_cycles(cycles, rows):
    """The press fit of the examples, to and fro by 0.5 mm."""
    text = (source / "cases/examples/press_fit.yaml").read_text()
    head = text[:text.index("history:")]
    (folder / "cycles.yaml").write_text(head + f"""history:
  - step: cycles
    duration: {cycles}
    increments: {rows - 1}
    motion: {{CP1: {{sine: {{amplitude: 0.5, frequency: 1}}}}}}
""")
    return "cycles.yaml"


def turns(points, part=0.5):
    """How often a curve turns downwards, by at least a part of its range."""
    values = [y for _, y in points]
    swing = part * (max(values) - min(values))
    count, extreme, up = 0, values[0], True
    for value in values:
        if (value > extreme) == up and value != extreme:
            extreme = value
        elif abs(value - extreme) >= swing:
            count += up
            extreme, up = value, not up
    return count


def press():
    page_file = report(press_fit_cycles(100, 10001))
    size = page_file.stat().st_size
    print(f"10001 rows: {size / 1e6:.2f} MB")
    expect(size < 1e6, f"10001 rows are {size / 1e6:.2f} MB")
    result = Result("cycles.yaml")
    with Page(page_file) as page:
        case = page.cases["cycles"]
        expect(case["rows_shown"] == len(result.rows) == 10001 and not case["thinned"], f"{case['rows_shown']} of {len(result.rows)} rows")
        for name in ("CSF1", "CP1", "FN", "DISS"):
            values = [float(row[name]) for row in result.rows]
            size = max(values) - min(values)
            wrong = max(abs(a - b) for a, b in zip(values, page.column(case, name)))
            expect(wrong <= 1e-6 * size, f"{name} is off by {wrong} of {size}")
        motion = page.run("return [...document.querySelectorAll('#pictures figure')].map((one) => one.dataset.panel).find((one) => one.startsWith('motion'))")
        for panel in (motion, "force"):
            points = page.points(panel, 0)
            expect(turns(points) == 100, f"{panel} turns {turns(points)} times, the press fit 100 times")
        # Zoomed in: as many as there are in the window.
        page.press(Keys.HOME)
        for _ in range(40):
            page.press(Keys.ARROW_RIGHT)
        for _ in range(3):
            page.press("+")
            begin, end = page.window()
            points = [(x, y) for x, y in page.points(motion, 0) if begin <= x <= end]
            wanted = sum(begin <= k + 0.25 <= end for k in range(100)) - sum(end - 0.4 < k + 0.25 <= end for k in range(100))
            expect(abs(turns(points) - wanted) <= 1, f"from t = {begin} to {end} the motion turns {turns(points)} times, wanted is {wanted}")
        # The loops: all of them.
        loop = page.run("return document.querySelector('figure[data-panel^=\"loop\"]').dataset.panel")
        points = page.points(loop, 0)
        expect(turns([(y, x) for x, y in points]) == 100, f"the loop turns {turns([(y, x) for x, y in points])} times")


def squeal():
    text = (source / "cases/examples/stick_slip_belt.yaml").read_text()
    head = text[:text.index("history:")]
    (folder / "squeal.yaml").write_text(head + """history:
  - {step: load, duration: 1, increments: 500, force: {f2: {to: 40}}}
  - {step: squeal, duration: 20, increments: 120000}
""")
    result = Result("squeal.yaml")
    motion = [float(row["CP1"]) for row in result.rows]
    steady = [value for t, value in zip(result.times, motion) if t > 5]
    top, bottom = max(steady), min(steady)
    with Page(report("squeal.yaml")) as page:
        expect(page.cases["squeal"]["thinned"], "a run of 120000 rows is not thinned")
        panel = page.run("return [...document.querySelectorAll('#pictures figure')].map((one) => one.dataset.panel).find((one) => one.startsWith('motion'))")
        page.run("location.hash = '#squeal@12'")
        page.wait("return document.querySelector('.instant output').textContent.startsWith('t = 1')", "the address does not lead on")
        for zoom in range(7):
            begin, end = page.window()
            painted = page.painted(panel, 0)
            peaks = []
            # Cells longer than a period of about a tenth of a second each have a peak.
            cell = max((end - begin) / 40, 0.25)
            left = max(begin, 5.0)
            while left + cell <= end:
                seen = [y for stroke in painted["strokes"] for x, y in zip(stroke[::2], stroke[1::2]) if left <= x <= left + cell]
                seen += [y for x, until, low, high in painted["bands"] if left <= x and until <= left + cell for y in (low, high)]
                peaks.append((max(seen), min(seen)))
                left += cell
            expect(peaks, f"zoom {zoom}: nothing to look at")
            off = max(max(abs(high - top), abs(low - bottom)) for high, low in peaks)
            expect(off < 0.01 * (top - bottom), f"zoom {zoom}, t = {begin} to {end}: the peaks of a steady squeal differ by {off} of {top - bottom}")
            page.press("+")


def zoom():
    with Page(report(example("shock_absorber"), example("puck"))) as page:
        whole = page.window()
        plot = page.find('figure[data-panel="force"] .plot')
        page.run("arguments[0].scrollIntoView({block: 'center'})", plot)
        width = plot.size["width"]

        def drag(element, begin, end, shift=False):
            actions = ActionChains(page.driver)
            if shift:
                actions.key_down(Keys.SHIFT)
            actions.move_to_element_with_offset(element, *begin).click_and_hold().move_by_offset((end[0] - begin[0]) // 2, (end[1] - begin[1]) // 2)
            actions.move_by_offset(end[0] - begin[0] - (end[0] - begin[0]) // 2, end[1] - begin[1] - (end[1] - begin[1]) // 2).release()
            if shift:
                actions.key_up(Keys.SHIFT)
            actions.perform()

        drag(plot, (0, 0), (int(0.2 * width), 10))
        near = page.window()
        length = near[1] - near[0]
        expect(abs(length / (whole[1] - whole[0]) - 0.2 * width / (width - 72)) < 0.01, f"a fifth of {whole} dragged over shows {near}")
        limits = page.run("return [...document.querySelectorAll('#pictures figure')].filter((one) => !/^(loop|path)/.test(one.dataset.panel)).map((one) => { const {min, max} = Chart.getChart(one.querySelector('canvas')).scales.x; return [min, max]; })")
        expect(all(one == near for one in limits), f"the histories show {limits}")
        expect("t = " in page.text("#shown") and "every row is drawn" in page.text("#shown"), f"the page says '{page.text('#shown')}'")
        # Shift and dragging to the left shows what comes later.
        drag(plot, (60, 0), (0, 0), shift=True)
        later = page.window()
        expect(later[0] > near[0] and abs(later[1] - later[0] - length) < 1e-9 * length, f"panning leads from {near} to {later}")
        page.press(",")
        expect(page.window()[0] < later[0], "the comma does not lead back")
        page.press("-")
        expect(abs(page.window()[1] - page.window()[0] - 2 * length) < 1e-6 * length, "minus does not zoom out")
        # The window goes along with the instant.
        page.press(Keys.END)
        expect(abs(page.window()[1] - whole[1]) < 1e-9 * whole[1], f"the last instant is not in {page.window()}")
        ActionChains(page.driver).double_click(plot).perform()
        expect(page.window() == whole, "a double click does not show all")
        page.find("#zoom-in").click()
        expect(abs((page.window()[1] - page.window()[0]) / (whole[1] - whole[0]) - 0.5) < 1e-6, "the button does not zoom")
        page.press("0")
        expect(page.window() == whole, "0 does not show all")
        # Ctrl and the wheel zoom about the pointer; the wheel alone scrolls the page.
        wheel = "arguments[0].dispatchEvent(new WheelEvent('wheel', {deltaY: -200, ctrlKey: arguments[1], clientX: arguments[0].getBoundingClientRect().left + 200, clientY: arguments[0].getBoundingClientRect().top + 50, bubbles: true, cancelable: true}))"
        page.run(wheel, plot, False)
        expect(page.window() == whole, "the wheel alone zooms")
        page.run(wheel, plot, True)
        expect(page.window()[1] - page.window()[0] < 0.8 * (whole[1] - whole[0]), "Ctrl and the wheel do not zoom")
        page.press("0")
        # A loop by itself, in both directions.
        loop = page.find('figure[data-panel^="loop"] .plot')
        page.run("arguments[0].scrollIntoView({block: 'center'})", loop)
        scales = "const {x, y} = Chart.getChart(document.querySelector('figure[data-panel^=\"loop\"] canvas')).scales; return [x.max - x.min, y.max - y.min]"
        before = page.run(scales)
        drag(loop, (-40, -40), (40, 40))
        after = page.run(scales)
        expect(after[0] < 0.5 * before[0] and after[1] < 0.5 * before[1] and page.window() == whole, f"the loop is zoomed from {before} to {after}")
        page.find("#zoom-all").click()
        expect(page.run(scales) == before, "the button does not show all of the loop")
        # Two fingers.
        page.run("""const plot = document.querySelector('figure[data-panel="force"] .plot');
            const box = plot.getBoundingClientRect();
            const send = (name, id, x) => plot.dispatchEvent(new PointerEvent(name, {pointerId: id, pointerType: "touch", clientX: box.left + x, clientY: box.top + 60, bubbles: true}));
            send("pointerdown", 11, 200); send("pointerdown", 12, 300); send("pointermove", 11, 150); send("pointermove", 12, 350);
            send("pointerup", 11, 150); send("pointerup", 12, 350);""")
        expect(abs((page.window()[1] - page.window()[0]) / (whole[1] - whole[0]) - 0.5) < 0.02, f"two fingers zoom to {page.window()} of {whole}")


def save():
    case = example("shock_absorber")
    result = Result(case)
    with Page(report(case), dark=True) as page:
        page.driver.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(folder / "saved")})

        def saved(pattern):
            for _ in range(200):
                # The browser holds the name with an empty file until the whole is moved there.
                files = [path for path in (folder / "saved").glob(pattern) if path.stat().st_size > 0]
                if files:
                    return files[0]
                time.sleep(0.05)
            sys.exit(f"no {pattern} is saved")

        page.find("#save-rows").click()
        text = saved("*.csv").read_text()
        lines = text.splitlines()
        expect(any(line.startswith("# title: ") for line in lines) and any("t [s]" in line for line in lines), f"the saved rows begin with {lines[:4]}")
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        expect(len(rows) == len(result.rows), f"{len(rows)} rows are saved of {len(result.rows)}")
        for name in ("t", "CSF1", "CP1"):
            values = [float(row[name]) for row in result.rows]
            off = max(abs(float(row[name]) - value) for row, value in zip(rows, values))
            expect(off <= 1e-6 * (max(values) - min(values)), f"{name} is saved off by {off}")
        page.find('figure[data-panel="force"] .save').click()
        picture = saved("*.png").read_bytes()
        expect(picture.startswith(b"\x89PNG") and len(picture) > 5000, f"a picture of {len(picture)} bytes")
        colours = page.driver.execute_async_script("""const done = arguments[1];
            const image = new Image();
            image.onload = () => { const sheet = document.createElement("canvas"); [sheet.width, sheet.height] = [image.width, image.height];
                const pen = sheet.getContext("2d"); pen.drawImage(image, 0, 0);
                const {data} = pen.getImageData(0, 0, image.width, image.height);
                let dark = 0; for (let i = 0; i < data.length; i += 4) if (data[i] + data[i + 1] + data[i + 2] < 200) dark++;
                done([[...data.slice(0, 4)], dark, image.width]); };
            image.src = "data:image/png;base64," + arguments[0];""", base64.b64encode(picture).decode())
        expect(colours[0] == [255, 255, 255, 255], f"the picture of a dark page is not on white but {colours[0]}")
        expect(colours[1] > 1000, f"only {colours[1]} dark pixels: no curve, no title")
        expect(page.run("return document.documentElement.dataset.theme") == "dark", "saving leaves the page light")


def setting():
    (folder / "deep").mkdir()
    (folder / "deep/setting.yaml").write_text((source / "cases/examples/press_fit.yaml").read_text())
    # Also of a case that is named with its whole path.
    page_file = report(folder / "deep/setting.yaml")
    expect(str(folder) not in page_file.read_text(), "the page names a folder of this machine")
    with Page(page_file) as page:
        said = page.text("#setting .setting")
        for words in ("connectionCYLINDRICAL, free: CP1, CPR1", "Exponential decay from static to kinetic friction: mu = kinetic + (static - kinetic) exp(-decay slip_rate)",
                      "static 0.25, kinetic 0.1, decay 0.2", "length mm, force kN, time s", "r = 0.24", "slipbench "):
            expect(words in said, f"'{words}' is not in '{said}'")
        tables = page.texts("#setting table")
        expect(any("internal contact force, held at its ends" in text and "-0.7854" in text for text in tables), f"the table is not told: {tables}")
        expect(any("press" in text and "CP1 to 1" in text and "CPR1 to 5" in text for text in tables), f"the history is not told: {tables}")
        expect(page.text("#setting pre") == (folder / "deep/setting.yaml").read_text(), "the case file is another")


def part():
    """A result with every tenth row of its run."""
    (folder / "some").mkdir()
    program_run("run", example("stick_slip_belt"), "-o", "some", "--every", "10")
    with Page(report("some/stick_slip_belt.csv")) as page:
        expect("The result has 301 of the run's 3001 rows, one in 10" in page.text("#part"), f"the page says '{page.text('#part')}'")


def load_times(page_file, tries=3):
    """Until the page is drawn, from its address on: the best of some, since the first load also starts the browser."""
    with Page(page_file) as page:
        times = []
        for _ in range(tries):
            page.go("")
            times.append(page.run("return performance.getEntriesByType('navigation')[0].loadEventEnd"))
        expect(page.all("#pictures canvas"), "no pictures")
        return min(times)


def long():
    for rows, most_size, most_time in ((10001, 1e6, 2000), (1000001, 8e6, 5000)):
        page_file = report(press_fit_cycles(100, rows))
        size = page_file.stat().st_size
        duration = load_times(page_file)
        print(f"{rows} rows: {size / 1e6:.2f} MB, loads in {duration:.0f} ms")
        expect(size < most_size, f"{rows} rows are {size / 1e6:.2f} MB")
        expect(duration < most_time, f"{rows} rows load in {duration} ms")


def large():
    # Fifty different runs of the examples, which have up to 3000 increments.
    names = [path for path in sorted((source / "cases/examples").glob("*.yaml"))]
    paths = []
    for i in range(50):
        copy = f"case_{i:02}.yaml"
        (folder / copy).write_text(names[i % len(names)].read_text())
        paths.append(copy)
    page_file = report(*paths)
    size = page_file.stat().st_size
    print(f"{size / 1e6:.2f} MB")
    expect(size < 5e6, f"fifty cases are {size / 1e6:.2f} MB")
    with Page(page_file) as page:
        expect(len(page.cases) == 50, f"{len(page.cases)} cases")
        # The first load also starts the browser; the best of three is the page's own.
        durations = []
        for _ in range(3):
            page.go("")
            durations.append(page.run("return performance.getEntriesByType('navigation')[0].loadEventEnd"))
        print(f"loads in {min(durations):.0f} ms")
        expect(min(durations) < 1000, f"opens in {durations} ms")
        # The time until the next frame has been painted.
        steps = []
        for _ in range(12):
            steps.append(page.driver.execute_async_script("""const done = arguments[0];
                const begin = performance.now();
                document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "j", bubbles: true}));
                requestAnimationFrame(() => setTimeout(() => done(performance.now() - begin)));"""))
        steps.sort()
        print(f"next case in {steps[len(steps) // 2]:.0f} ms, at most {steps[-1]:.0f} ms")
        expect(steps[len(steps) // 2] < 200, f"the next case takes {steps} ms")


tests = {f.__name__: f for f in (loads, linked, keyboard, cases, rows, thinned, worst, overlay, looks, hostile, large,
                              press, squeal, zoom, save, setting, part, long)}
tests["print"] = print_page
parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("test", choices=tests)
parser.add_argument("--slipbench", required=True, help="the program")
parser.add_argument("--source", required=True, type=pathlib.Path, help="the root of the repository")
options = parser.parse_args()
program = str(pathlib.Path(options.slipbench).resolve())
source = options.source.resolve()

with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as made:
    folder = pathlib.Path(made).resolve()
    tests[options.test]()
finish(options.test)
