# SPDX-License-Identifier: Apache-2.0
"""The documentation site in headless Chromium, opened as files: what it fetches and complains of, its search, and whether it can be read by all.

Called by site_test.py; the needs are those of tests/browser.
"""
import json
import sys
import pathlib

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "browser"))
from browser_page import By, browser, screen  # noqa: E402

PAGES = ["index.html", "joints.html", "gallery.html", "compare.html", "tutorials/index.html", "tutorials/hinge.html", "guide/friction.html",
         "reference/connections.html", "reference/columns.html", "theory/model.html", "notebooks/capstan.html",
         "case-reference.html", "dossier.html", "dossier/closed-forms.html", "dossier/evidence/hinge.html"]

# What a check of accessibility calls serious, and can be told without a person.
SERIOUS = """
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
for (const one of document.querySelectorAll(".md-content :is(h1, h2, h3, h4, h5, h6)")) {
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


def look(site, folder, expect):
    driver = browser(pathlib.Path(folder))
    for dark, width in ((False, 1280), (True, 1280), (False, 390)):
        screen(driver, width=width, dark=dark)
        driver.get((site / PAGES[0]).as_uri())
        driver.execute_script("localStorage.clear()")  # the palette of the visit before
        for page in PAGES:
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
    for words, wanted in (("CONNECTOR FRICTION", "guide/decks.html"), ("hinge", "tutorials/hinge.html"), ("capstan", "capstan")):
        hits = found(driver, site, words)
        expect(any(wanted in hit for hit in hits[:8]), f"the search for '{words}' finds {hits[:8]}")
    for line in driver.get_log("browser"):
        expect(False, f"the browser says: {line['message'][:300]}")
    for entry in driver.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            address = message["params"]["request"]["url"]
            # The browser's own first tab is of chrome: and chrome-untrusted:.
            expect(address.startswith(("file:", "data:", "blob:", "about:", "chrome:", "chrome-untrusted:")), f"{address} is fetched")
    driver.quit()
