# SPDX-License-Identifier: Apache-2.0
"""The documentation site in headless Chromium, opened as files: what it fetches and complains of, its search, whether it can be read by all, and
whether the sliders of its page to play with show what the program computes.

Called by site_test.py; the needs are those of tests/browser.
"""
import csv
import json
import math
import re
import subprocess
import sys
import pathlib

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "browser"))
from browser_page import ActionChains, By, browser, screen  # noqa: E402

# Those that are looked at in each way; the others of the site in one.
PAGES = ["index.html", "joints.html", "play.html", "gallery.html", "compare.html", "tutorials/index.html", "tutorials/hinge.html", "guide/friction.html",
         "reference/connections.html", "reference/columns.html", "theory/model.html", "notebooks/capstan.html",
         "case-reference.html", "dossier.html", "dossier/closed-forms.html", "dossier/evidence/hinge.html"]

# What a check of accessibility calls serious, and can be told without a person.
SERIOUS = """
const main = arguments[0] || ".md-content";
const faults = [], seen = new Set();
const shown = (one) => one.getClientRects().length && getComputedStyle(one).visibility !== "hidden" && !one.closest("[hidden], .md-search__suggest");
const named = (one) => (one.getAttribute("aria-label") || one.title || one.textContent || "").trim() || one.querySelector("img[alt]:not([alt=''])")
  || (one.labels && one.labels.length) || one.getAttribute("aria-labelledby") || one.placeholder;
if (!document.documentElement.lang) faults.push("no language");
if (!document.title.trim()) faults.push("no title");
if (!document.querySelector("main")) faults.push("no main landmark");
if (document.querySelectorAll("h1").length !== 1) faults.push(`${document.querySelectorAll("h1").length} h1`);
for (const one of document.querySelectorAll("[id]")) { if (seen.has(one.id)) faults.push(`id ${one.id} twice`); seen.add(one.id); }
for (const one of document.querySelectorAll("img:not([alt]), svg[role=img]:not([aria-label])")) faults.push(`no words for ${one.outerHTML.slice(0, 60)}`);
for (const one of document.querySelectorAll("a[href], button, input:not([type=hidden]):not(.md-toggle):not(.md-nav__toggle):not(.md-option)"))
  if (shown(one) && !named(one)) faults.push(`no name: ${one.outerHTML.slice(0, 80)}`);
let level = 1;
for (const one of document.querySelectorAll(`${main} :is(h1, h2, h3, h4, h5, h6)`)) {
  if (+one.tagName[1] > level + 1) faults.push(`${one.tagName} '${one.textContent.slice(0, 30)}' below h${level}`);
  level = +one.tagName[1];
}
const parse = (text) => { const [r, g, b, a = 1] = text.match(/[\\d.]+/g).map(Number); return {c: [r, g, b], a}; };
const over = (front, behind) => front.c.map((v, i) => front.a * v + (1 - front.a) * behind[i]);
const light = (c) => { const [r, g, b] = c.map((v) => { v /= 255; return v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; });
                       return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
const back = (one) => { if (!one) return [255, 255, 255]; const b = parse(getComputedStyle(one).backgroundColor); return b.a === 1 ? b.c : over(b, back(one.parentElement)); };
const poor = new Map();
for (const one of document.querySelectorAll("p, h1, h2, h3, h4, th, td, li, a, code, pre span, summary, dt, dd, label, svg text")) {
  if (!shown(one) || ![...one.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim()) || one.closest(".katex, .headerlink, .md-search, .md-skip")) continue;
  const style = getComputedStyle(one), behind = back(one), front = parse(one.closest("svg") ? style.fill : style.color);
  const a = light(over(front, behind)), b = light(behind), ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  const size = parseFloat(style.fontSize), large = size >= 24 || size >= 18.6 && +style.fontWeight >= 700;
  if (ratio < (large ? 3 : 4.5)) poor.set(`${one.tagName}.${one.className}`.slice(0, 50), `${ratio.toFixed(1)} '${one.textContent.trim().slice(0, 20)}'`);
}
for (const [what, how] of poor) faults.push(`contrast ${how} of ${what}`);
return faults;
"""


def all_pages(source):
    """The pages that the navigation of the site leads to, in its order."""
    nav = (source / "docs/site/mkdocs.yml").read_text().partition("\nnav:\n")[2]
    return [re.sub(r"README$", "index", name) + ".html" for name in re.findall(r"([\w/-]+)\.md$", nav, re.MULTILINE)]


def found(driver, site, words):
    """The pages that the site's search lists for some words, the best first."""
    driver.get((site / "index.html").as_uri())
    driver.execute_script("document.getElementById('__search').click()")
    field = driver.find_element(By.CSS_SELECTOR, ".md-search__input")
    driver.implicitly_wait(10)
    field.send_keys(words)
    links = driver.find_elements(By.CSS_SELECTOR, ".md-search-result__item > a")
    driver.implicitly_wait(0)
    return [link.get_attribute("href") for link in links]


def dissipated(rows):
    return rows[-1]["DISS"] - next(row["DISS"] for row in rows if row["t"] > 2 - 1e-9)


def swing(rows):
    way = [1000 * row["CU1"] for row in rows if row["t"] > 1.5 - 1e-9]
    return max(way) - min(way)


def off(rows, exact):
    there = {round(row["t"], 6): (row["CSF2"], row["CSF3"]) for row in exact}
    return max(math.dist((row["CSF2"], row["CSF3"]), there[t]) for row in rows for t in [round(row["t"], 6)] if t >= 1 and t in there)


# The first number that each picture tells, of the rows of a run; of the second case where there are two.
TOLD = {"stroke": dissipated, "direction": lambda rows: rows[-1]["CSF2"], "wrap": lambda rows: rows[-1]["f_bc"], "n": off, "belt": swing,
        "alpha": lambda rows: max(abs(row["CSF2"] - row["CSF3"]) for row in rows if row["t"] > 1 - 1e-9)}


def play(driver, site, page, program, folder, expect):
    """Drags each slider of the page to play with, and holds what it tells then against a run of the program made now."""
    cases = dict(re.findall(r"^ *```yaml case (\w+)\.yaml\n(.*?)^ *```", page.read_text(), re.MULTILINE | re.DOTALL))

    def run(name, number, more=""):
        text = re.sub(r"^    ", "", cases[name], flags=re.MULTILINE) + more
        (folder / f"{name}.yaml").write_text(text)
        parameter = re.search(r"^parameters: {(\w+):", text, re.MULTILINE)[1]
        done = subprocess.run([program, "run", f"{name}.yaml", "-o", "-", "--set", f"{parameter}={number}"], cwd=folder, capture_output=True, text=True, check=True)
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(line for line in done.stdout.splitlines() if line[0] != "#")]

    driver.get((site / "play.html").as_uri())
    figures = driver.find_elements(By.CSS_SELECTOR, "figure.play")
    expect({figure.get_attribute("data-play") for figure in figures} == set(TOLD), "play.html: other pictures than the test knows")
    for figure in figures:
        name, slider = figure.get_attribute("data-play"), figure.find_element(By.TAG_NAME, "input")
        drawn = driver.execute_script("return arguments[0].querySelector('svg').innerHTML", figure)
        for to in (0.3, -0.2):
            driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", slider)
            hand = slider.size["width"] * (int(slider.get_attribute("value")) / int(slider.get_attribute("max")) - 0.5) * 0.96
            ActionChains(driver).move_to_element_with_offset(slider, int(hand), 0).click_and_hold().move_to_element_with_offset(
                slider, int(slider.size["width"] * to), 0).release().perform()
            told = figure.find_element(By.TAG_NAME, "p").text
            number = re.match(r"[\d.]+", figure.find_element(By.TAG_NAME, "output").text)[0]
            sets = [run(name, number)] + ([run(name, 360, "integration: {method: exact}\n")] if name == "n" else [])
            shown, wanted = re.search(r"\d+(\.(\d+))?", told), TOLD[name](*sets)
            expect(abs(float(shown[0]) - wanted) <= 0.51 * 10.0 ** -len(shown[2] or ""), f"play.html: {name} at {number} tells '{told}', a run gives {wanted}")
            now = driver.execute_script("return arguments[0].querySelector('svg').innerHTML", figure)
            expect(now != drawn, f"play.html: {name} is drawn alike wherever its slider stands")
            drawn = now


def live(site, source, driver, expect):
    """The cases of the tutorials in the bench that the pages carry, if scripts/wasm.sh has built that; in the gallery all are there, the first is run."""
    if not (site / "live.html").exists():
        return
    wanted = {page: 1 for page in all_pages(source) if page.startswith("tutorials/") and page != "tutorials/index.html"}
    wanted["gallery.html"] = len(list((source / "cases/examples").glob("*.yaml")))
    for page, least in wanted.items():
        driver.get((site / page).as_uri())
        there = len(driver.find_elements(By.CSS_SELECTOR, "details.live"))
        expect(there == least if page == "gallery.html" else there >= least, f"{page}: {there} cases to be run in the page in place of {least}")
        if not there:
            continue
        driver.implicitly_wait(30)
        driver.find_element(By.CSS_SELECTOR, "details.live summary").click()
        driver.switch_to.frame(driver.find_element(By.CSS_SELECTOR, "details.live[open] iframe"))
        expect("increments, run in" in driver.find_element(By.CSS_SELECTOR, "#live-state:not(:empty)").text, f"{page}: its case does not run in the page")
        shown = driver.find_element(By.CSS_SELECTOR, "#shown").text
        rows = re.search(r"about ([\d.]+) rows", shown)
        expect(shown and (not rows or float(rows[1]) < 100), f"{page}: its pictures are some hundred pixels wide, and it says '{shown}'")
        driver.implicitly_wait(0)
        driver.switch_to.default_content()


def look(site, folder, source, program, expect):
    driver = browser(pathlib.Path(folder))
    for dark, width in ((False, 1280), (True, 1280), (False, 390)):
        screen(driver, width=width, dark=dark)
        driver.get((site / PAGES[0]).as_uri())
        driver.execute_script("localStorage.clear()")  # the palette of the visit before
        # Which colours and how wide is the same style sheet on all pages.
        for page in PAGES if dark or width < 1280 else dict.fromkeys([*PAGES, *all_pages(source)]):
            driver.get((site / page).as_uri())
            what = f"{page}, {'dark' if dark else 'light'}, {width} wide"
            scheme = driver.find_element(By.TAG_NAME, "body").get_attribute("data-md-color-scheme")
            expect(scheme == ("slate" if dark else "default"), f"{what}: its colours are those of {scheme}")
            expect(not driver.find_elements(By.CSS_SELECTOR, ".katex-error, .arithmatex:not(:has(.katex))"), f"{what}: a formula is not drawn")
            wide = driver.execute_script("return document.documentElement.scrollWidth")
            expect(wide <= width, f"{what}: {wide} pixels wide")
            for fault in driver.execute_script(SERIOUS):
                expect(False, f"{what}: {fault}")
    screen(driver)
    play(driver, site, source / "docs/site/play.md", program, pathlib.Path(folder), expect)
    for words, wanted in (("CONNECTOR FRICTION", "guide/decks.html"), ("*CONNECTOR FRICTION", "guide/decks.html"),
                          ("hinge", "tutorials/hinge.html"), ("capstan", "capstan")):
        hits = found(driver, site, words)
        expect(any(wanted in hit for hit in hits[:8]), f"the search for '{words}' finds {hits[:8]}")
    live(site, source, driver, expect)
    for line in driver.get_log("browser"):
        expect(False, f"the browser says: {line['message'][:300]}")
    for entry in driver.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            address = message["params"]["request"]["url"]
            # The browser's own first tab is of chrome: and chrome-untrusted:.
            expect(address.startswith(("file:", "data:", "blob:", "about:", "chrome:", "chrome-untrusted:")), f"{address} is fetched")
    driver.quit()
