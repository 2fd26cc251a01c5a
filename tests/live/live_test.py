#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""live_test.py SLIPBENCH: a page of 'slipbench report --live' in headless Chromium. A slider is dragged and a number compared with the
program's, as are the events, and loop and history are drawn anew; faults stand at their lines, the editor completes words of the schema,
rows are those of 'slipbench run', the page can be read by all, and 10,000 increments take less than 30 ms. Needs build/wasm/live.html
(scripts/wasm.sh) and what tests/browser needs.
"""
import csv
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
for beside in ("browser", "site"):
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / beside))
from browse import SERIOUS  # noqa: E402
from browser_page import ActionChains, By, Keys, browser, expect, failures, screen  # noqa: E402

CASE = """slipbench: 1
title: Shaft in a sleeve
parameters: {mu: 0.15, amplitude: 5}
units: {length: mm, force: N, time: s}
connector: {type: CYLINDRICAL}
friction:
  - {predefined: {R: 12, L: 40}, coefficient: = mu, stick: {elastic_slip: 0.2}}
history:
  - {step: load, increments: 10, force: {f2: {to: 300}, m3: {to: 4000}}}
  - {step: stroke, duration: 20, increments: 10000, motion: {CP1: {triangle: {amplitude: = amplitude, period: 1}}, CPR1: {to: 3}}}
"""
MOST_MS = 30


class LivePage:
    def __init__(self, program, folder, name, text):
        self.program, self.case, self.page = program, folder / f"{name}.yaml", folder / f"{name}.html"
        self.case.write_text(text)
        subprocess.run([program, "report", "--live", self.case, "-o", self.page, "--force"], check=True, capture_output=True)

    def rows(self, *settings):
        """The bytes that the program writes of the case."""
        subprocess.run([self.program, "run", self.case, "-q", "--force", "-o", self.case.parent, *settings], check=True, capture_output=True)
        return self.case.with_suffix(".csv").read_text()


def editor(driver, script, *arguments):
    return driver.execute_script(f"const editor = document.querySelector('.CodeMirror').CodeMirror; {script}", *arguments)


def settled(driver):
    """Waits until what was changed is run and drawn."""
    driver.execute_async_script("""
        const done = arguments[0], {live} = document.getElementById("live");
        const wait = () => (!live.waiting && !live.pause ? setTimeout(done, 30) : requestAnimationFrame(wait));
        requestAnimationFrame(() => requestAnimationFrame(wait));""")


def wait_for(driver, selector):
    driver.implicitly_wait(20)
    found = driver.find_element(By.CSS_SELECTOR, selector)
    driver.implicitly_wait(0)
    return found


def smallest_and_largest(driver, name):
    """Of a column, as the page's table tells them."""
    for row in driver.find_elements(By.CSS_SELECTOR, "#run tbody tr"):
        cells = [cell.text for cell in row.find_elements(By.CSS_SELECTOR, "th, td")]
        if cells[0].startswith(name):
            return [float(cell.replace("\u2212", "-").split()[0]) for cell in cells[1:3]]
    return None


def events_of(driver):
    """The events as the page lists them: how many it says there are, and the texts of each one's cells."""
    told = driver.find_element(By.ID, "events-caption").text
    rows = driver.execute_script("""
        return [...document.querySelectorAll("table[aria-describedby=events-caption] tbody tr")].map(
            (row) => [...row.cells].map((cell) => cell.textContent));""")
    return int(re.search(r"(\d+) events?;", told)[1]), rows


def told_number(text):
    return float(text.replace("\u2212", "-").split()[0])


def pictures_of(driver, kind):
    """Of each loop or history: how many colours it has, and its picture as a text."""
    return driver.execute_script("""
        return [...document.querySelectorAll(`#pictures .plot.${arguments[0]} canvas`)].map((canvas) => {
          const {width, height} = canvas, copy = Object.assign(document.createElement("canvas"), {width, height});
          const context = copy.getContext("2d", {willReadFrequently: true});
          context.drawImage(canvas, 0, 0);
          return [new Set(new Uint32Array(context.getImageData(0, 0, width, height).data.buffer)).size, canvas.toDataURL()]; });""", kind)


def saved_rows(driver):
    """The text that "Save its rows" offers."""
    return driver.execute_async_script("""
        const done = arguments[0], create = URL.createObjectURL;
        URL.createObjectURL = (blob) => { blob.text().then(done); URL.createObjectURL = create; return create.call(URL, blob); };
        [...document.querySelectorAll("#live button")].find((one) => one.textContent === "Save its rows").click();""")


def drag(driver, page):
    slider = wait_for(driver, "#slider-mu")
    before, events_before = smallest_and_largest(driver, "CSF1"), events_of(driver)
    drawn_before = {kind: pictures_of(driver, kind) for kind in ("loop", "history")}
    ActionChains(driver).click_and_hold(slider).move_by_offset(slider.size["width"] // 5, 0).move_by_offset(7, 0).release().perform()
    settled(driver)
    value = driver.find_element(By.CSS_SELECTOR, "output[for='slider-mu']").text
    expect(value != "0.15", "the slider does not move its number")
    expect(f"mu: {value}," in editor(driver, "return editor.getValue();"), f"the text does not say mu: {value}")
    # The rows of the program, of a case with that number.
    page.case.write_text(CASE.replace("mu: 0.15", f"mu: {value}"))
    table = list(csv.DictReader(line for line in page.rows().splitlines() if not line.startswith("#")))
    wanted = [pick(float(row["CSF1"]) for row in table) for pick in (min, max)]
    told = smallest_and_largest(driver, "CSF1")
    expect(told != before and all(abs(a - b) <= 1e-4 * abs(b) for a, b in zip(told, wanted)), f"with mu = {value} the page says CSF1 {told}, the program {wanted}")
    print(f"slider: mu 0.15 -> {value}, CSF1 {before} -> {told}; slipbench run: {wanted}")
    for kind, pictures in drawn_before.items():
        now = pictures_of(driver, kind)
        expect(now and all(colours > 3 for colours, _ in [*pictures, *now]), f"no {kind} is drawn, or an empty one: {[colours for colours, _ in now]} colours")
        expect({picture for _, picture in now} != {picture for _, picture in pictures}, f"the slider does not change any {kind}")
    same_events(driver, page, events_before)
    kept = saved_rows(driver)
    expect(kept == page.rows(), f"the rows that the page saves are not those of 'slipbench run': {kept[:200]!r}")


def same_events(driver, page, before):
    """The list of events is another one than before, and that of the program's last run."""
    count, rows = events_of(driver)
    wanted = list(csv.DictReader(line for line in page.case.with_suffix(".events.csv").read_text().splitlines() if not line.startswith("#")))
    expect(rows != before[1], "the slider does not change the list of events")
    expect(count == len(rows) == len(wanted) > 40, f"the page tells {count} events and lists {len(rows)}, the program has {len(wanted)}")
    first = next(event for event in wanted if event["to"] == "slip")
    listed = next((row for row in rows if row[1].endswith("slip")), None)
    expect(listed and abs(told_number(listed[0]) - float(first["t"])) <= 1e-5 * float(first["t"]),
           f"the first slip is listed as {listed}, the program has {first}")
    for row, event in zip(rows, wanted):
        for text, exact in ((row[0], float(event["t"])), (row[2], float(event["force"])), (row[3], float(event["limit"]))):
            expect(abs(told_number(text) - exact) <= 1e-3 * abs(exact), f"an event is listed as {row}, the program has {event}")


def readable(driver):
    """What a check of accessibility calls serious, light and dark, also beside a message."""
    for dark in (False, True):
        screen(driver, dark=dark)
        for text in (CASE, CASE.replace("coefficient:", "coeficient:")):
            editor(driver, "editor.setValue(arguments[0]);", text)
            settled(driver)
            wrong = bool(driver.find_elements(By.CSS_SELECTOR, ".live-messages .error"))
            expect(wrong == (text != CASE), f"a message of an error is{' not' * (not wrong)} shown")
            for fault in driver.execute_script(SERIOUS, "main"):
                expect(False, f"{'dark' if dark else 'light'}{', with a message' * wrong}: {fault}")
    screen(driver)
    editor(driver, "editor.setValue(arguments[0]);", CASE)
    settled(driver)


def faults(driver):
    editor(driver, "editor.setValue(arguments[0]);", CASE.replace("coefficient:", "coeficient:").replace("increments: 10,", "incremets: 10,"))
    settled(driver)
    messages = [one.text for one in driver.find_elements(By.CSS_SELECTOR, ".live-messages li")]
    for line, words in ((7, "did you mean 'coefficient'"), (9, "did you mean 'increments'")):
        expect(any(one.startswith(f"line {line} error") and words in one for one in messages), f"no message of line {line} with {words!r}: {messages}")
    expect(len(driver.find_elements(By.CSS_SELECTOR, ".fault.error")) == 2, "the lines are not marked")
    expect(driver.find_elements(By.CSS_SELECTOR, "#case.stale"), "the pictures are not marked as those of another text")
    driver.find_element(By.CSS_SELECTOR, ".live-messages button").click()
    expect(editor(driver, "return editor.getCursor().line;") == 6, "a message does not lead to its line")
    editor(driver, "editor.setValue(arguments[0]);", CASE)
    settled(driver)
    expect(not driver.find_elements(By.CSS_SELECTOR, "#case.stale, .live-messages .error"), "a mended text is still refused")


def unreadable(driver):
    """A text that cannot be read has no place for a slider to write to; a core that fails is replaced by another one."""
    broken = CASE.replace("title: Shaft in a sleeve", "title: {")
    editor(driver, "editor.setValue(arguments[0]);", broken)
    settled(driver)
    slider = driver.find_element(By.ID, "slider-mu")
    expect(not slider.is_enabled(), "a slider can be moved while the text cannot be read")
    driver.execute_script("arguments[0].value = 0.01; arguments[0].dispatchEvent(new Event('input'));", slider)
    expect(editor(driver, "return editor.getValue();") == broken, "a slider wrote into a text that cannot be read")
    driver.execute_script("window.failed = document.getElementById('live').live.core; window.failed.run = () => { throw new Error('no more memory'); };")
    editor(driver, "editor.setValue(arguments[0]);", CASE)
    settled(driver)
    said = driver.find_element(By.CSS_SELECTOR, ".live-messages").text
    expect("no more memory" in said and driver.find_elements(By.CSS_SELECTOR, "#case.stale"), f"a failed core is not told: {said!r}")
    driver.execute_async_script("const done = arguments[0], {live} = document.getElementById('live'); const wait = () => (live.core === window.failed ? setTimeout(wait, 20) : done()); wait();")
    editor(driver, "editor.setValue(arguments[0]);", CASE)
    settled(driver)
    expect(not driver.find_elements(By.CSS_SELECTOR, "#case.stale, .live-messages .error") and slider.is_enabled(), "no other core runs the case")


def follows_its_number(driver):
    """A slider writes where its number is, before what was typed above it has been run."""
    editor(driver, "editor.setValue(arguments[0]);", CASE)
    settled(driver)
    text = editor(driver, """
        editor.replaceRange("# a note\\n", {line: 0, ch: 0});
        for (const [name, value] of [["mu", 0.2], ["amplitude", 7.5], ["mu", 0.125]]) {
          const slider = document.getElementById(`slider-${name}`);
          slider.value = value;
          slider.dispatchEvent(new Event("input"));
        }
        return editor.getValue();""")
    wanted = "# a note\n" + CASE.replace("mu: 0.15", "mu: 0.125").replace("amplitude: 5}", "amplitude: 7.5}")
    expect(text == wanted, f"sliders wrote elsewhere: {text!r}")
    settled(driver)


def completes(driver):
    for before, word, wanted in (
            ("slipbench: 1\nconn", "", "connector"), ("connector:\n  ty", "", "type"), ("connector: {type: CYL", "", "CYLINDRICAL"),
            ("friction:\n  - predefined: {}\n    coef", "", "coefficient"), ("friction:\n  - {predefined: {R: 1}, st", "", "stick"),
            ("friction:\n  - {stick: {ela", "", "elastic_slip"), ("history:\n- step: a\n  incr", "", "increments"),
            ("history:\n  - step: a\n    motion:\n      CP1: {tri", "", "triangle"), ("checks:\n  - name: a\n    criterion: sprag", "", "sprague_geers")):
        editor(driver, "editor.setValue(arguments[0]); editor.setCursor(editor.lineCount(), 0); editor.focus();", before)
        settled(driver)
        ActionChains(driver).key_down(Keys.CONTROL).send_keys(" ").key_up(Keys.CONTROL).perform()
        hints = [one.text for one in driver.find_elements(By.CSS_SELECTOR, ".CodeMirror-hint b")]
        expect(hints[:1] == [wanted], f"after {before!r} {wanted} should be offered, not {hints}")
        ActionChains(driver).send_keys(Keys.ENTER).perform()
        text = editor(driver, "return editor.getValue();")
        expect(wanted in text, f"{wanted} is not put in: {text!r}")


def reads_data(program, folder, driver):
    """A case with a file of data: the page has its text, and saves the rows that the program writes."""
    (folder / "rig.csv").write_text("time,disp,load\n0,0.000,22.5\n50,0.002,22.5\n100,0.004,22.5\n150,0.001,22.5\n200,-0.003,22.5\n")
    page = LivePage(program, folder, "measured", """slipbench: 1
units: {length: mm, force: N, time: s}
connector: {type: SLOT}
friction:
  - {predefined: {}, coefficient: 0.2, stick: {stiffness: 1000}}
history:
  csv: rig.csv
  time: time
  unit: ms
  columns: {CP1: {column: disp, unit: in}, f2: {column: load, unit: lbf}}
""")
    driver.get(page.page.as_uri())
    wait_for(driver, "#live-state")
    settled(driver)
    expect(saved_rows(driver) == page.rows(), "a case with data is not run as 'slipbench run' runs it")


def speed(driver):
    editor(driver, "editor.setValue(arguments[0]);", CASE)
    settled(driver)
    times = []
    for i in range(15):
        editor(driver, "editor.setValue(arguments[0]);", CASE.replace("mu: 0.15", f"mu: 0.{16 + i}"))
        settled(driver)
        told = driver.find_element(By.ID, "live-state").text
        found = re.fullmatch(r"(\S+) increments, run in (\S+) ms, drawn in (\S+) ms", told)
        expect(found, f"the page tells no times: {told!r}")
        times += [[float(word) for word in found.groups()]] if found else []
    expect(all(one[0] >= 10000 for one in times), f"not 10,000 increments: {times[0]}")
    ran = statistics.median(one[1] for one in times)
    drawn = statistics.median(one[2] for one in times)
    print(f"10,000 increments: run in {ran} ms, drawn in {drawn} ms (medians of {len(times)})")
    expect(ran < MOST_MS, f"10,000 increments take {ran} ms")


def main(program):
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        page = LivePage(program, folder, "shaft", CASE)
        whole = page.page.read_text()
        for words in ("University Corporation", "GNU GENERAL PUBLIC LICENSE", "Permission is hereby granted", "Mozilla Public License", "musl", "LLVM"):
            expect(words in whole, f"the licence with '{words}' is not in the page")
        driver = browser(folder)
        driver.get(page.page.as_uri())
        drag(driver, page)
        faults(driver)
        readable(driver)
        unreadable(driver)
        follows_its_number(driver)
        completes(driver)
        speed(driver)
        reads_data(program, folder, driver)
        screen(driver, width=390)
        wide = driver.execute_script("return document.documentElement.scrollWidth")
        expect(wide <= 390, f"{wide} pixels wide on a phone")
        for line in driver.get_log("browser"):
            expect(False, f"the browser says: {line['message'][:300]}")
        for entry in driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                address = message["params"]["request"]["url"]
                expect(address.startswith(("file:", "data:", "blob:", "about:", "chrome:", "chrome-untrusted:")), f"{address} is fetched")
        driver.quit()
    for failure in failures:
        print(failure)
    print(f"{'FAILED' if failures else 'passed'}: {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
