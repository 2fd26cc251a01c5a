// SPDX-License-Identifier: Apache-2.0
// What the pages have in common: elements, numbers for people, colours, axes and printing. It stands before a page's
// own program, in the same function. Text of a document only ever becomes text nodes.

// ------------------------------------------------------------------------------------- small tools

/** A new element: attributes, listeners (on...), properties of the dataset; children are text or nodes. */
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

function makeSvg(tag, attributes = {}) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

/** What is wider than its place scrolls in itself; then Tab reaches it and arrow keys scroll it. */
const scrollWatch = new ResizeObserver((entries) => {
  for (const {target} of entries) {
    const box = target.closest(".sideways");
    if (!box) continue;
    const wide = box.scrollWidth > box.clientWidth + 1;
    for (const [name, value] of [["tabindex", "0"], ["role", "region"], ["aria-label", box.dataset.name]]) {
      if (wide) box.setAttribute(name, value);
      else box.removeAttribute(name);
    }
  }
});
function inScroll(table) {
  const box = make("div", {class: "sideways", "data-name": table.caption ? table.caption.textContent : "Table"}, table);
  scrollWatch.observe(box);
  scrollWatch.observe(table);
  return box;
}
const find = (id) => document.getElementById(id);
const isNumber = (value) => typeof value === "number" && Number.isFinite(value);
/** Somebody else's words: their direction must not turn that of the words around them. */
const quoted = (text) => make("bdi", {}, text);
/** A name that may be broken behind its joints. */
const breakable = (text) => text.split(/(?<=[_/.])/).flatMap((part, i) => (i > 0 ? [make("wbr"), part] : [part]));

const kSuperscripts = {"-": "\u207b", 0: "\u2070", 1: "\u00b9", 2: "\u00b2", 3: "\u00b3", 4: "\u2074", 5: "\u2075", 6: "\u2076", 7: "\u2077", 8: "\u2078", 9: "\u2079"};
const withPower = (mantissa, power) =>
    mantissa + "\u00b710" + [...String(power)].map((digit) => kSuperscripts[digit]).join("");

/** A number for people: so many significant digits, powers of ten only where zeros would be counted. */
function number(value, digits = 4) {
  if (!isNumber(value)) return "\u2013";
  if (value === 0) return "0";
  const size = Math.abs(value);
  let text;
  if (size >= 10 ** Math.max(6, digits) || size < 1e-3) {
    const [mantissa, power] = value.toExponential(digits - 1).split("e");
    text = withPower(Number(mantissa).toString(), Number(power));
  } else {
    text = size >= 10 ** digits ? value.toFixed(0) : Number(value.toPrecision(digits)).toString();
  }
  return text.replace("-", "\u2212");
}
const withUnit = (value, unit, digits) => number(value, digits) + (unit && isNumber(value) ? "\u00a0" + unit : "");
const plural = (count, one, many = one + "s") => `${count} ${count === 1 ? one : many}`;
const labelled = (name, unit) => (unit ? `${name} (${unit})` : name);

/** Round numbers from low to high, about `count` of them. */
function roundTicks(low, high, count) {
  const raw = (high - low) / Math.max(count, 1);
  if (!(raw > 0) || !Number.isFinite(raw)) return [low];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find((size) => raw <= size * power * 1.0001);
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-6); i <= high / step + 1e-6; ++i) ticks.push(Number((i * step).toPrecision(12)));
  return ticks;
}

/** The text of a tick: as many decimals as the ticks are apart. */
function tickText(value, index, ticks) {
  const step = ticks.length > 1 ? Math.abs(ticks[1].value - ticks[0].value) : Math.abs(value) || 1;
  const largest = Math.max(...ticks.map((tick) => Math.abs(tick.value)));
  if (Math.abs(value) < step * 1e-6) return "0";
  const decimals = (size) => {
    let count = 0;
    while (count < 8 && Math.abs(size * 10 ** count - Math.round(size * 10 ** count)) > 1e-6 * size * 10 ** count) count++;
    return count;
  };
  let text;
  if (largest >= 1e5 || largest < 1e-2) {
    const power = Math.floor(Math.log10(largest));
    text = withPower((value / 10 ** power).toFixed(decimals(step / 10 ** power)), power);
  } else {
    text = value.toFixed(decimals(step));
  }
  return text.replace("-", "\u2212");
}

/** Smallest and largest number of a list, null if there is none. */
function range(values) {
  let low = Infinity;
  let high = -Infinity;
  for (const value of values || []) {
    if (!isNumber(value)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? {low, high} : null;
}
const varies = (values) => {
  const found = range(values);
  return found !== null && found.high - found.low > 1e-9 * Math.max(Math.abs(found.high), Math.abs(found.low));
};

// ------------------------------------------------------------------------------------------ colours

const kThemes = ["auto", "light", "dark"];
const darkSystem = window.matchMedia("(prefers-color-scheme: dark)");
let theme = "auto";
let colours = {};

function readColours() {
  const style = getComputedStyle(document.documentElement);
  colours = {};
  for (const name of ["text", "soft", "rule", "grid", "back", "slip", "open", "open-line", "mixed-line", "faint", "limit", "tube", "bad", "accent"]) {
    colours[name] = style.getPropertyValue("--" + name).trim();
  }
  for (let i = 1; i <= 6; ++i) colours[i] = style.getPropertyValue("--curve-" + i).trim();
  colours.hatch = hatch(colours.open, colours["open-line"]);
  colours.mixed = hatch(colours.slip, colours["mixed-line"], true);
}

/** The pattern of "no friction"; upright, that of regimes in turn. */
function hatch(back, line, upright) {
  const tile = document.createElement("canvas");
  tile.width = tile.height = 8;
  const pen = tile.getContext("2d");
  pen.fillStyle = back;
  pen.fillRect(0, 0, 8, 8);
  pen.strokeStyle = line;
  pen.lineWidth = 1.2;
  for (const shift of [-8, 0, 8]) {
    pen.beginPath();
    pen.moveTo(upright ? shift + 4 : shift - 1, 9);
    pen.lineTo(upright ? shift + 4 : shift + 9, -1);
    pen.stroke();
  }
  return tile;
}

function applyTheme(forced) {
  const dark = forced ? forced === "dark" : theme === "dark" || (theme === "auto" && darkSystem.matches);
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  readColours();
  for (const picture of pictures) picture.recolour();
}

function nextTheme() {
  theme = kThemes[(kThemes.indexOf(theme) + 1) % kThemes.length];
  const words = {auto: "as the system has them", light: "light", dark: "dark"};
  find("theme").textContent = {auto: "\u25d0", light: "\u25cb", dark: "\u25cf"}[theme];
  find("theme").setAttribute("aria-label", "Colours: " + words[theme]);
  try { localStorage.setItem("slipbench-theme", theme); } catch { /* a browser may forbid it for files */ }
  applyTheme();
}

const colourOf = (line) => colours[line.colour || "text"];

// -------------------------------------------------------------------------------------- axes of pictures

/** Room left of and under a plot: fixed, so that instants stand under each other. */
const kLeft = 58;
const kRight = 14;
const kTop = 8;
const kBottom = 24;
const kBottomTitled = 42;

/** All that is drawn: each has a chart, its place `plot`, and recolour(). */
let pictures = [];

/** The options of a Chart.js scale from limits[0] to limits[1]. */
function axisOptions({title, limits, upright}) {
  return {
    type: "linear", bounds: "data", min: limits[0], max: limits[1],
    grid: {color: colours.grid, borderColor: colours.soft, drawTicks: false},
    ticks: {color: colours.soft, font: {size: 11}, autoSkip: false, maxRotation: 0, padding: 5, callback: tickText},
    title: {display: Boolean(title), text: title || "", color: colours.soft, font: {size: 12}, padding: 2},
    afterBuildTicks: (scale) => {
      const room = upright ? (scale.chart.height - kTop - kBottom) / 28 : (scale.chart.width - kLeft - kRight) / 75;
      scale.ticks = roundTicks(scale.min, scale.max, Math.min(room, upright ? 6 : 10)).map((value) => ({value}));
    },
    afterFit: (scale) => {
      if (upright) scale.width = kLeft;
      else scale.height = title ? kBottomTitled : kBottom;
    }
  };
}

/** The axes of a chart in the colours that hold now. */
function recolourAxes(chart) {
  for (const scale of Object.values(chart.options.scales)) {
    scale.grid.color = colours.grid;
    scale.grid.borderColor = colours.soft;
    scale.ticks.color = scale.title.color = colours.soft;
  }
  chart.update("none");
}

// ----------------------------------------------------------------------------------- printing and start

let printing = false;

function beforePrint() {
  printing = true;
  document.documentElement.classList.add("printing");
  applyTheme("light");
  for (const picture of pictures) resizeNow(picture);
}

function afterPrint() {
  printing = false;
  document.documentElement.classList.remove("printing");
  applyTheme();
  for (const picture of pictures) resizeNow(picture);
}

/** To the size its place has now; Chart.js itself would only see it in the next frame. */
function resizeNow(picture) {
  if (!picture.chart) return;
  // On paper a canvas of a broken ratio is drawn a little smaller than the marks over it.
  picture.chart.options.devicePixelRatio = printing ? 2 : window.devicePixelRatio;
  picture.chart.resize(picture.plot.clientWidth, picture.plot.clientHeight);
  picture.chart.update("none");
}

/** Colours, printing and the buttons of the masthead. */
function startPage() {
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  try {
    const kept = localStorage.getItem("slipbench-theme");
    if (kThemes.includes(kept)) while (theme !== kept) nextTheme();
  } catch { /* a browser may forbid it for files */ }
  applyTheme();
  darkSystem.addEventListener("change", () => applyTheme());
  window.addEventListener("beforeprint", beforePrint);
  window.addEventListener("afterprint", afterPrint);
  find("theme").addEventListener("click", nextTheme);
  find("print").addEventListener("click", () => window.print());
  find("help-open").addEventListener("click", () => find("help").showModal());
}
