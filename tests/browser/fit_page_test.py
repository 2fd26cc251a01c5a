#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests of the pages of fits in headless Chromium: fit_page_test.py TEST --pages EXE

EXE writes the pages of fits made by hand (write_fit_pages.cpp). TEST is one of
  fit_loads     every page opens from a file without an error, a warning or any request to elsewhere; its content policy
                refuses what is put in later
  fit_figures   what is told is what the document has: verdict, unknowns, errors, tables, correlations, searches
  fit_linked    pointing at a curve or moving the slider tells one instant in all pictures of a quantity
  fit_keyboard  all keys that the page promises; Tab reaches every part
  fit_looks     light, dark, a phone of 360 pixels: readable and nothing beside the screen
  fit_print     the printed page has all pictures, on white
  fit_hostile   titles and names that look like HTML stay text
  fit_large     twenty thousand points: there in less than a second; what is drawn is told
"""

import argparse
import base64
import pathlib
import re
import subprocess
import tempfile

from browser_page import ActionChains, BrowserPage, Keys, as_number, close, expect, finish, first_number, screen


class FitPage(BrowserPage):
    def __init__(self, name, address="", **how):
        subprocess.run([writer, folder, name], check=True, timeout=120)
        super().__init__(folder / f"{name}.html", **how)
        self.go(address)

    def picture(self, key, within="main"):
        """The figure of a picture, brought to the screen and drawn."""
        figure = self.find(f'{within} figure[data-panel="{key}"]')
        self.run("arguments[0].scrollIntoView({block: 'center'})", figure)
        self.wait(f"return Chart.getChart(document.querySelector('{within} figure[data-panel=\"{key}\"] canvas')) !== undefined", f"{key} is not drawn")
        return figure

    def told(self, key, within):
        """What the legend of a picture tells: {name: text}."""
        return self.run("""return Object.fromEntries([...document.querySelectorAll(arguments[0])].map((one) =>
            [one.querySelector("bdi").textContent, one.querySelector(".value").textContent.replace(/\\u00a0/g, " ")]))""", f'{within} figure[data-panel="{key}"] .legend button')

    def rows(self, table):
        return self.run("return [...document.querySelectorAll(arguments[0] + ' tbody tr')].map((row) => [...row.children].map((cell) => cell.textContent.replace(/\\u00a0/g, ' ')))", table)

    def draw_all(self):
        """As somebody who reads the page from top to bottom."""
        self.driver.execute_async_script("""const done = arguments[0];
            const step = (top) => {
              window.scrollTo(0, top);
              if (top > document.documentElement.scrollHeight) done();
              else requestAnimationFrame(() => setTimeout(() => step(top + 500)));
            };
            step(0);""")
        self.wait("return [...document.querySelectorAll('main canvas')].every((one) => Chart.getChart(one))", "some pictures are never drawn")


kNames = ("slider", "table", "curve", "unconverged", "large", "hostile")


def fit_loads():
    for name in kNames:
        with FitPage(name) as page:
            page.draw_all()
            page.check_requests(name)
            expect(page.text("h2") == page.document["title"], f"{name}: the title is '{page.text('h2')}'")
            page.check_policy(name)


def fit_figures():
    with FitPage("slider") as page:
        document = page.document
        expect("converged" in page.text("#verdict .badge") and "not" not in page.text("#verdict .badge"), "the verdict is another")
        for row, one in zip(page.rows("#unknown-table"), document["unknowns"], strict=True):
            expect(row[0].startswith(one.get("told", one["name"])), f"{one['name']} is told as '{row[0]}'")
            for cell, wanted in ((row[1], one["start"]), (row[2], one["value"])):
                expect(close(as_number(cell), wanted, 3), f"{one['name']}: '{cell}' is not {wanted}")
            expect(close(as_number(row[3]), one["error"], 2), f"{one['name']}: error '{row[3]}' is not {one['error']}")
            low, high = (as_number(part) for part in row[4].split(" \u2026 "))
            expect(close(low, one["low"], 3) and close(high, one["high"], 3), f"{one['name']}: '{row[4]}' is not {one['low']} to {one['high']}")
        expect("only its product with mu is told" in page.rows("#unknown-table")[2][-1], "the reason of a weak unknown is not told")
        for row, one in zip(page.rows("#error-table"), document["experiments"], strict=True):
            response = one["responses"][0]
            expect(close(as_number(row[3]), response["rmse_before"]) and close(as_number(row[4]), response["rmse_after"]), f"{one['name']}: errors {row[3:5]}")
            expect(("held out" in row[0]) == one["held_out"], f"{one['name']}: held out or not")
        # Dots and whiskers stand where the numbers are, within the bounds.
        places = page.run("""return [...document.querySelectorAll(".intervals .unknown svg.x, .intervals .track > svg")].map((svg) =>
            [parseFloat(svg.querySelector("circle").getAttribute("cx")), parseFloat(svg.querySelector(".whisker").getAttribute("x1"))])""")
        mu = document["unknowns"][0]
        place = lambda value: 2 + 96 * (value - mu["lower"]) / (mu["upper"] - mu["lower"])
        expect(abs(places[0][0] - place(mu["value"])) < 0.01 and abs(places[0][1] - place(mu["low"])) < 0.01, f"mu is drawn at {places[0]}, wanted {place(mu['value'])}, {place(mu['low'])}")
        strong = page.texts("#correlations td.strong")
        expect([as_number(one) for one in strong] == [-0.99, -0.99], f"strong correlations {strong}")
        expect("6 of 8 starts found this minimum" in page.text("#search"), "the searches are told otherwise")
        expect(len(page.rows("#search-table")) == 8, "some searches are missing")
        expect("Not bounded above" in page.text("#profiles"), "an open profile is not told")
        expect(document["experiments"][0]["hash"] in page.text("#provenance"), "the data's hash is not told")
    with FitPage("table") as page:
        expect("6 of 12 cells never visited" in page.text(".never-named"), "cells never visited are not named")
        expect(page.text(".never-named").count("temperature 250 .. 400") == 4, "another cell is named")
        expect(len(page.all("table.visits td.never")) == 6, "cells never visited are not hatched")
        hatched = page.run("return getComputedStyle(document.querySelector('td.never')).backgroundImage")
        expect("repeating-linear-gradient" in hatched, f"a cell never visited has the background {hatched}")
        expect(len(page.all("#table-1 .coverage:not(.visits) td.never")) == 8, "ordinates never visited are not hatched")
        page.picture("table")
        line = page.run("const {data} = Chart.getChart(document.querySelector('figure[data-panel=table] canvas')).data.datasets[0]; return data.map(({y}) => y);")
        wanted = [one["value"] for one in page.document["unknowns"][:5]]
        expect(line == wanted, f"the first curve is {line}, wanted {wanted}")
    with FitPage("unconverged") as page:
        expect("not converged" in page.text("#verdict .badge"), "the verdict is another")
        expect("allow" in page.text("#verdict .sentence"), "what to do is not told")
        expect("A trend, no noise" in page.text("#experiment-1"), "a trend is not told")
        expect("at its upper bound" in page.rows("#unknown-table")[2][-1], "a bound is not told")
        expect(page.run("return document.getElementById('correlation')") is None, "correlations that are not known are drawn")


def fit_linked():
    with FitPage("slider") as page:
        within = "#experiment-2"
        response = page.document["experiments"][1]["responses"][0]

        def check(what):
            at = int(page.run("return document.querySelector('#experiment-2 input[type=range]').value"))
            told = page.text(f"{within} output").replace("\u00a0", " ")
            expect(close(first_number(told.removeprefix("t = ")), response["time"][at], 5), f"{what}: '{told}' is not {response['time'][at]}")
            for key in ("loop", "history"):
                for name, text in page.told(key, within).items():
                    expect(close(first_number(text), response[name][at], 4), f"{what}: {key} tells {name} = {text}, wanted {response[name][at]}")
            left = first_number(page.told("residuals", within)["after"])
            expect(abs(left - (response["after"][at] - response["measured"][at])) < 1e-4, f"{what}: the residual is {left}")
            return at

        for key in ("loop", "residuals", "history"):
            page.picture(key, within)
        check("at first")
        plot = page.find(f'{within} figure[data-panel="history"] .plot')
        width = plot.size["width"]
        for part in (0.2, 0.55, 0.9):
            ActionChains(page.driver).move_to_element_with_offset(plot, int((part - 0.5) * width), 0).perform()
            at = check(f"at {part}")
            pixel = page.run("""const chart = Chart.getChart(document.querySelector('#experiment-2 figure[data-panel="history"] canvas'));
                return chart.scales.x.getPixelForValue(arguments[0]);""", response["time"][at])
            expect(abs(pixel - part * width) < 3, f"pointed at {part * width}, marked is {pixel}")
        slider = page.find(f"{within} input[type=range]")
        slider.send_keys(Keys.HOME)
        expect(check("Home") == 0, "Home does not lead to the first point")
        slider.send_keys(Keys.ARROW_RIGHT)
        expect(check("right") == 1, "an arrow does not move by one point")
        # A loop that was pointed at leads to a point of it.
        loop = page.picture("loop", within)
        ActionChains(page.driver).move_to_element_with_offset(loop.find_element("css selector", ".plot"), 20, -60).perform()
        check("in the loop")
        # The errors before the fit are hidden until they are asked for; then there is room for them.
        page.picture("residuals", within)
        limits = "const {min, max} = Chart.getChart(document.querySelector('#experiment-2 figure[data-panel=residuals] canvas')).scales.y; return max - min;"
        small = page.run(limits)
        page.find(f'{within} figure[data-panel="residuals"] .legend li:nth-child(2) button').click()
        expect(page.run(limits) > 5 * small, "the residuals before the fit do not fit into the picture")


def fit_keyboard():
    with FitPage("slider") as page:
        current = lambda: page.text("#contents a[aria-current] span")
        expect(current() == "Verdict", f"at first the part is '{current()}'")
        names = page.texts("#contents a span:first-child")
        page.press("j")
        page.wait("return document.querySelector('#contents a[aria-current] span').textContent === 'Unknowns'", "j does not lead to the next part")
        page.press("j", "j")
        page.wait(f"return document.querySelector('#contents a[aria-current] span').textContent === '{names[3]}'", "j does not go on")
        page.press("k")
        page.wait(f"return document.querySelector('#contents a[aria-current] span').textContent === '{names[2]}'", "k does not lead back")
        page.press("?")
        expect(page.find("#help").is_displayed(), "the keys are not told")
        page.press(Keys.ESCAPE)
        page.press("t")
        expect(page.run("return document.documentElement.dataset.theme") == "light", "t does not change the colours")
        page.press("t")
        expect(page.run("return document.documentElement.dataset.theme") == "dark", "t does not change the colours again")
        # Tab comes to the contents, the sliders and the legends.
        page.go("")
        reached = set()
        for _ in range(120):
            page.press(Keys.TAB)
            reached.add(page.run("const one = document.activeElement; return one.closest('#contents') ? 'contents' : one.matches('input[type=range]') ? 'slider' : one.closest('.legend') ? 'legend' : one.id || one.tagName"))
        expect({"contents", "slider", "legend", "theme", "print", "help-open"} <= reached, f"Tab reaches only {reached}")
        page.go("#experiment-2")
        expect(abs(page.run("return document.getElementById('experiment-2').getBoundingClientRect().top")) < 40, "the address does not lead to a part")


def fit_looks():
    for name in kNames:
        with FitPage(name) as page:
            for width, dark in ((1280, False), (1280, True), (360, False), (360, True)):
                screen(page.driver, width, 900, dark)
                page.go("")
                what = f"{name}, {width} pixels, dark {dark}"
                light = page.run("const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number); return r + g + b") > 600
                expect(light != dark, f"{what}: another background")
                page.draw_all()
                wide, there = page.overflow()
                expect(wide <= there, f"{what}: {wide} pixels wide")
                cut = page.run("""return [...document.querySelectorAll("main h3, main h4, main p, main dd, .legend button, figcaption")].filter((one) => {
                    const box = one.getBoundingClientRect();
                    return box.width > 0 && (box.right > innerWidth + 1 || box.left < -1 || one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).display !== "inline" && one.clientWidth > 0);
                }).map((one) => one.tagName + " " + one.textContent.slice(0, 30))""")
                expect(not cut, f"{what}: cut off: {cut[:3]}")
                stuck = page.run("""return [...document.querySelectorAll(".sideways, .coverage-block")]
                    .filter((one) => one.scrollWidth > one.clientWidth + 1 && one.tabIndex !== 0).map((one) => one.textContent.slice(0, 20))""")
                expect(not stuck, f"{what}: no key reaches {stuck}")
                if width == 360:
                    small = page.run("""return [...document.querySelectorAll("#contents a, .legend button, input[type=range]")]
                        .filter((one) => one.getBoundingClientRect().height > 0 && one.getBoundingClientRect().height < 23.9).map((one) => one.textContent)""")
                    expect(not small, f"{what}: too small for a finger: {small[:4]}")
                page.check_contrast(what)
                page.check_curves(what)


def fit_print():
    with FitPage("slider", dark=True) as page:
        pdf = base64.b64decode(page.driver.print_page())
        expect(pdf.startswith(b"%PDF") and len(pdf) > 60_000, f"a printed page of {len(pdf)} bytes")
        sheets = len(re.findall(rb"/Type\s*/Page\b", pdf))
        expect(3 <= sheets <= 14, f"{sheets} sheets")
        page.wait("return document.documentElement.dataset.theme === 'dark'", "after printing the page stays light")
        page.run("window.dispatchEvent(new Event('beforeprint'))")
        expect(page.run("return getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)", "paper is not white")
        undrawn = page.run("return [...document.querySelectorAll('main canvas')].filter((one) => !Chart.getChart(one)).length")
        expect(undrawn == 0, f"{undrawn} pictures are not on paper")
        wide = page.run("return Math.max(...[...document.querySelectorAll('main canvas, main table')].map((one) => one.getBoundingClientRect().right))")
        expect(wide <= 701, f"pictures and tables reach to {wide} of 700 pixels")
        expect(not page.find("#contents").is_displayed(), "the contents are printed")


def fit_hostile():
    with FitPage("hostile") as page:
        page.draw_all()
        nasty = page.document["title"]
        expect("<script>" in nasty, "the names are tame")
        expect(page.text("#title") == nasty and page.text("h2") == nasty, f"the title is shown as {page.text('h2')!r}")
        expect(page.run("return window.broken") is None, "a name was run as a script")
        expect(page.run("return document.querySelectorAll('main b').length") == page.run("return [...document.querySelectorAll('main b')].filter((one) => one.textContent !== 'bold').length"), "a name became an element")
        expect(page.document["unknowns"][0]["name"] in page.rows("#unknown-table")[0][0], "an unknown's name is another")
        expect(page.document["tables"][0]["name"] in page.text("#table-1 h3"), "a table's name is another")


def fit_large():
    with FitPage("large") as page:
        durations = []
        for _ in range(3):
            page.go("")
            durations.append(page.run("return performance.getEntriesByType('navigation')[0].loadEventEnd"))
        print(f"loads in {min(durations):.0f} ms, {page.path.stat().st_size / 1e6:.2f} MB")
        expect(min(durations) < 1000, f"opens in {durations} ms")
        expect(page.path.stat().st_size < 2e6, "20000 points are more than 2 MB")
        response = page.document["experiments"][0]["responses"][0]
        numbers = re.search(r"Drawn are (\d+) of (\d+) points", page.text(".thinned"))
        expect(numbers and [int(one) for one in numbers.groups()] == [len(response["time"]), response["points"]], f"the thinning is told as '{page.text('.thinned')}'")


tests = {f.__name__: f for f in (fit_loads, fit_figures, fit_linked, fit_keyboard, fit_looks, fit_print, fit_hostile, fit_large)}
parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("test", choices=tests)
parser.add_argument("--pages", required=True, type=pathlib.Path, help="the program that writes the pages")
options = parser.parse_args()
writer = options.pages.resolve()

with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as made:
    folder = pathlib.Path(made).resolve()
    tests[options.test]()
finish(options.test)
