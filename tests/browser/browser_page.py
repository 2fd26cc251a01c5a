# SPDX-License-Identifier: Apache-2.0
"""A page in headless Chromium, steered by selenium, and what its tests have in common.

The needs beyond python3 itself are python3-selenium, chromium and chromium-driver.
"""

import base64
import json
import math
import re
import shutil
import sys
import tempfile
import time

failures = []


def expect(condition, message):
    """Notes a failure and goes on, so that one run shows all of them."""
    if not condition:
        failures.append(message)


def need(condition, package, what):
    if not condition:
        sys.exit(f"{what} is not there: install the Debian package {package} (scripts/setup.sh tests)")


try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
except ImportError:
    need(False, "python3-selenium", "selenium")


def browser(folder, width=1280, height=900, dark=False):
    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    driver = shutil.which("chromedriver")
    need(chromium, "chromium", "Chromium")
    need(driver, "chromium-driver", "chromedriver")
    options = Options()
    options.binary_location = chromium
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", "--no-first-run",
                     "--disable-background-networking", "--disable-component-update", f"--user-data-dir={tempfile.mkdtemp(prefix='profile', dir=folder)}"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    started = webdriver.Chrome(service=Service(driver), options=options)
    started.set_page_load_timeout(30)
    screen(started, width, height, dark)
    return started


def screen(driver, width=1280, height=900, dark=False):
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})


def unpack(text):
    """The numbers of a packed series (driver/report/packed_numbers.hpp); None where the run had none."""
    data = iter(base64.b64decode(text))
    numbers = []
    decimals = 0
    known = [(0, 0.0), (0, 0.0)]

    def following():
        number = shift = 0
        for byte in data:
            number |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return number
        return None

    def unfold(n):
        return -(n + 1) // 2 if n % 2 else n // 2

    def put(off):
        k = 2 * known[0][0] - known[1][0] + off
        known[1] = known[0]
        known[0] = (k, k * float(f"1e{-decimals}") if decimals < 0 else k / float(f"1e{decimals}"))
        numbers.append(known[0][1])

    begun = -1
    while True:
        token = following()
        if token is None:
            return numbers
        if len(numbers) % 64 == 0 and begun != len(numbers):
            begun = len(numbers)
            change = unfold(token)
            decimals += change
            for i in range(2 if change else 0):
                units = known[i][1] / float(f"1e{-decimals}") if decimals < 0 else known[i][1] * float(f"1e{decimals}")
                known[i] = (math.floor(units + 0.5) if abs(units) < 1e15 else 0, known[i][1])
            continue
        if token == 0:
            for _ in range(following()):
                put(0)
        elif token == 1:
            numbers.append(None)
        else:
            put(unfold(token - 1))


class BrowserPage:
    """A page in a browser; on leaving, what the browser complained about is a failure."""

    def __init__(self, path, **how):
        self.path = path
        self.driver = browser(path.parent, **how)
        embedded = re.search(r'<script type="application/json" id="document">(.*?)</script>', path.read_text(), re.DOTALL)
        # Pages of sweeps have none, and no script.
        self.document = json.loads(embedded[1]) if embedded else None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for line in self.driver.get_log("browser"):
            expect(False, f"the browser says: {line['level']}: {line['message']}")
        self.driver.quit()

    def go(self, address):
        self.driver.get("about:blank")
        self.driver.get(self.path.as_uri() + address)

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def text(self, selector):
        return self.run("return document.querySelector(arguments[0]).textContent", selector)

    def texts(self, selector):
        return self.run("return [...document.querySelectorAll(arguments[0])].map((one) => one.textContent)", selector)

    def asked(self):
        """The addresses that the page has asked for since this was called last; its own is one of them."""
        requests = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        # Of this document only: the browser's own first page asks for things, too.
        return [one["params"]["request"]["url"] for one in requests
                if one["method"] == "Network.requestWillBeSent" and one["params"]["documentURL"].startswith("file://")]

    def check_requests(self, what):
        """The page has asked for nothing but itself since `asked` was called last."""
        asked = self.asked()
        expect(any(url.startswith("file://") for url in asked), f"{what}: the log of requests is empty, so this proves nothing")
        elsewhere = [url for url in asked if not url.startswith((self.path.as_uri(), "data:", "about:"))]
        expect(not elsewhere, f"{what}: the page asks for {elsewhere}")

    def check_policy(self, what, scripts=True):
        """The whole content policy of the page, and what it is for: pictures, requests, bases and forms of elsewhere are refused."""
        wanted = {"default-src": "'none'", "style-src": "'unsafe-inline'", "img-src": "data:", "base-uri": "'none'", "form-action": "'none'"}
        if scripts:
            wanted["script-src"] = "'unsafe-inline'"
        found = self.run("return [...document.querySelectorAll('meta[http-equiv=\"Content-Security-Policy\"]')].map((one) => one.content)")
        policies = [dict(part.strip().split(" ", 1) for part in one.split(";")) for one in found]
        expect(policies == [wanted], f"{what}: the content policy is {found}, wanted {wanted}")
        if policies != [wanted]:
            return  # what is put in below might be let through, and lead the browser elsewhere
        early = self.run("""const policy = document.querySelector('head > meta[http-equiv="Content-Security-Policy"]');
            return [...document.querySelectorAll("script, style, link, img")].filter((one) => !policy ||
                !(policy.compareDocumentPosition(one) & Node.DOCUMENT_POSITION_FOLLOWING)).map((one) => one.tagName)""")
        expect(not early, f"{what}: {early} stand before the content policy")
        refused = self.driver.execute_async_script("""const elsewhere = "http://127.0.0.1:9/", done = arguments[0], refused = [];
            document.addEventListener("securitypolicyviolation", (event) => {
                if (refused.push([event.effectiveDirective, event.blockedURI]) === 4) done(refused);
            });
            setTimeout(() => done(refused), 5000);
            const put = (into, name, values) => into.appendChild(Object.assign(document.createElement(name), values));
            put(document.body, "img", {src: elsewhere + "x.png"});
            fetch(elsewhere).catch(() => {});
            put(document.body, "form", {action: elsewhere, method: "post"}).submit();
            put(document.head, "base", {href: elsewhere});""")
        elsewhere = "http://127.0.0.1:9/"
        expect(sorted(refused) == [["base-uri", elsewhere], ["connect-src", elsewhere], ["form-action", elsewhere], ["img-src", elsewhere + "x.png"]],
               f"{what}: refused are {refused}")
        expect(self.run("return document.baseURI").startswith(self.path.as_uri()), f"{what}: addresses count from {self.run('return document.baseURI')}")
        # The browser complains about what was just put in, and about nothing else.
        other = [line["message"] for line in self.driver.get_log("browser") if "Content Security Policy" not in line["message"]]
        expect(not other, f"{what}: the browser says: {other}")

    def press(self, *keys):
        for key in keys:
            ActionChains(self.driver).send_keys(key).perform()

    def wait(self, script, message, seconds=5.0):
        """Until the script is true; what settles by itself is waited for, never slept for."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.run(script):
                return True
            time.sleep(0.02)
        expect(False, message)
        return False

    def check_contrast(self, what):
        """Words against their background: at least 4.5 to 1."""
        poor = self.run("""
                const over = (front, behind) => front.c.map((v, i) => front.a * v + (1 - front.a) * behind[i]);
                const parse = (text) => { const [r, g, b, a = 1] = text.match(/[\\d.]+/g).map(Number); return {c: [r, g, b], a}; };
                const light = (c) => { const [r, g, b] = c.map((v) => { v /= 255; return v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; });
                                       return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
                const back = (one) => { if (!one) return [255, 255, 255]; const b = parse(getComputedStyle(one).backgroundColor); return b.a === 1 ? b.c : over(b, back(one.parentElement)); };
                const poor = [];
                for (const one of document.querySelectorAll("p, h1, h2, h3, h4, th, td, li, button, .mark, .badge, b, output")) {
                  // Of what was never visited the words stand on a patch of their own.
                  if (!one.textContent.trim() || one.closest(".hidden, dialog, .skip") || one.disabled || one.matches(".never")) continue;
                  const a = light(parse(getComputedStyle(one).color).c), b = light(back(one));
                  const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
                  if (ratio < 4.5) poor.push(`${one.tagName}.${one.className} '${one.textContent.slice(0, 20)}' ${ratio.toFixed(1)}`);
                }
                return [...new Set(poor)].slice(0, 5);""")
        expect(not poor, f"{what}: hard to read: {poor}")

    def check_curves(self, what):
        """Curves against the screen and the shade of slip: at least 3 to 1 (WCAG 1.4.11)."""
        poor = self.run("""
                const probe = document.body.appendChild(document.createElement("i"));
                const light = (name) => { probe.style.color = `var(--${name})`;
                  const [r, g, b] = getComputedStyle(probe).color.match(/[\\d.]+/g).map((v) => { v /= 255; return v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; });
                  return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
                const poor = [];
                for (const name of ["text", "limit", "bad", 1, 2, 3, 4, 5, 6].map((one) => (typeof one === "number" ? "curve-" + one : one))) {
                  for (const back of ["back", "slip"]) {
                    const a = light(name), b = light(back);
                    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
                    if (ratio < 3) poor.push(`${name} on ${back} ${ratio.toFixed(2)}`);
                  }
                }
                probe.remove();
                return poor;""")
        expect(not poor, f"{what}: hard to see: {poor}")

    def overflow(self):
        return self.run("return [document.documentElement.scrollWidth, window.innerWidth]")


def as_number(text):
    text = text.replace("\u2212", "-")
    powers = str.maketrans("\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079", "-0123456789")
    if "\u00b710" in text:
        mantissa, power = text.split("\u00b710")
        return float(mantissa) * 10 ** int(power.translate(powers))
    return float(text)


def first_number(text):
    return as_number(text.split()[0])


def close(found, wanted, digits=4):
    """True if `found` is `wanted` as people are told it, in so many digits."""
    return math.isclose(found, wanted, rel_tol=2 * 10.0 ** (1 - digits), abs_tol=1e-12)


def finish(test):
    """Tells the failures of a test and ends the program."""
    for message in failures:
        print(message, file=sys.stderr)
    print(f"{test}: {len(failures)} failures")
    sys.exit(1 if failures else 0)
