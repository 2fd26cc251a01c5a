// SPDX-License-Identifier: Apache-2.0
// The report page: a list of cases, and of one case its pictures, events, energies, tables and checks.
//
// All pictures of a case share one instant: a drawn row, or an event with what is known of it. What
// is read off is never made up between rows. A picture is made of a plain description (a "panel": title, axes, series); runs laid over each other
// are panels of the same key. Text of the document only ever becomes text nodes.

const page = JSON.parse(document.getElementById("document").textContent);
const cases = page.cases;
const byId = new Map(cases.map((one) => [one.id, one]));

// ------------------------------------------------------------------------------------ the document

const kStatusWords = {passed: "passed", failed: "failed", not_run: "not run", no_checks: "no checks"};
const kStatusMarks = {passed: "\u2713", failed: "\u2717", not_run: "!", no_checks: "\u00b7"};
const isFailure = (one) => one.status === "failed" || one.status === "not_run";

/** The deviation as a part of its tolerance, in a few characters. */
function fraction(value) {
  if (value === null || value === undefined) return "\u2013";
  return value > 1 ? number(value, 2) + "\u00d7" : number(value, 2);
}

const timeOf = (one) => columnOf(one, "t") || {name: "t", unit: (one.units || {}).time || "", values: []};

function largestFraction(one) {
  const known = (one.checks || []).map((check) => check.worst_fraction);
  if (known.length === 0) return null;
  // JSON has no infinity: a failed check without a fraction has a tolerance of 0, or nothing to compare.
  return known.some((value) => !isNumber(value)) ? null : Math.max(...known);
}

/** The last index whose time is not after t; times never fall. */
function indexBefore(times, t) {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** The row whose time is nearest; of two at one time the later one. */
function nearestRow(times, t) {
  if (times.length === 0) return 0;
  const row = indexBefore(times, t);
  return row + 1 < times.length && times[row + 1] - t < t - times[row] ? row + 1 : row;
}

/** The first row that is not before a time. */
function rowFrom(times, t) {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] >= t) high = middle;
    else low = middle + 1;
  }
  return Math.max(low, 0);
}

/** The curve straight between its points: only for differences of curves that have points of their own. */
function between(x, y, at) {
  const row = indexBefore(x, at);
  if (row + 1 >= x.length || x[row] === at) return y[row];
  const part = (at - x[row]) / (x[row + 1] - x[row]);
  return isNumber(y[row]) && isNumber(y[row + 1]) ? y[row] + part * (y[row + 1] - y[row]) : null;
}

/** Of a series: what its numbers differ by from row to row, as a rule and at least. */
const knownSteps = new WeakMap();
function stepsOf(values) {
  if (!knownSteps.has(values)) {
    const size = values.reduce((largest, value) => (isNumber(value) ? Math.max(largest, Math.abs(value)) : largest), 0);
    const steps = [];
    let least = Infinity;
    // Of very many steps a thousand tell what is usual.
    const stride = Math.ceil(values.length / 1000);
    for (let i = 1; i < values.length; ++i) {
      const step = Math.abs(values[i] - values[i - 1]);
      if (!(step > 1e-9 * size)) continue;
      if (step < least) least = step;
      if (i % stride === 0) steps.push(step);
    }
    steps.sort((a, b) => a - b);
    knownSteps.set(values, {usual: steps[steps.length >> 1] || 0, least: least < Infinity ? least : 0});
  }
  return knownSteps.get(values);
}

const digitsFor = (value, step, least, most) =>
    Math.min(most, Math.max(least, step > 0 && value !== 0 ? Math.ceil(Math.log10(Math.abs(value) / step)) + 1 : least));
/** A number of a series, with the digits that tell its rows apart. */
const told = (value, values, unit) => withUnit(value, unit, isNumber(value) ? digitsFor(value, stepsOf(values).usual, 4, 10) : 4);
/** A time, with the digits that tell the instants of a run apart. */
const timeText = (one, t, more = 0) => number(t, isNumber(t) ? digitsFor(t, stepsOf(timeOf(one).values).least, 5, 14) + more : 5);

// -------------------------------------------------------------------------------- panels of a case

const series = (label, column, x, more = {}) => ({label, unit: column.unit || "", column: column.name, x, y: column.values, low: column.low, high: column.high, ...more});
const negated = (values) => values && values.map((value) => -value);
const negative = (column) => ({...column, values: negated(column.values), low: negated(column.high), high: negated(column.low)});

/** Definition of `one` that belongs to `definition` of another run: of that name, else the first. */
function sameDefinition(one, definition) {
  const own = one.definitions || [];
  return own.find((other) => definition && other.name === definition.name) || own[0] || null;
}

/** True where every slipping row lies on a circle of the limit: only then is the limit drawn as one. */
function limitIsCircle(first, second, limit, status) {
  let seen = 0;
  for (let i = 0; i < limit.length; ++i) {
    if (status[i] !== 2 || !isNumber(limit[i]) || limit[i] <= 0) continue;
    seen++;
    if (Math.abs(Math.hypot(first[i], second[i]) - limit[i]) > 2e-3 * limit[i]) return false;
  }
  return seen > 0;
}

/** False for a limit that swings so often that it would only cover the loop. */
function isCalm(values) {
  const found = range(values);
  if (!found || !varies(values)) return true;
  const way = values.reduce((sum, value, i) => sum + (i > 0 ? Math.abs(value - values[i - 1]) : 0), 0);
  return way < 5 * (found.high - found.low);
}

/**
 * Events between two rows as points of the drawn curves: there a corner is. Only what is known of an
 * event is drawn; `values` gives a coordinate of it, undefined where it is not known.
 */
function withEvents(one, definition, line, xOf, yOf) {
  const times = timeOf(one).values;
  const drawn = {x: [], y: [], row: [], status: []};
  const put = (x, y, row, status) => { drawn.x.push(x); drawn.y.push(y); drawn.row.push(row); drawn.status.push(status); };
  const events = (one.events || []).filter((event) => event.definition === definition.name);
  let next = 0;
  for (let row = 0; row < line.x.length; ++row) {
    for (; next < events.length && events[next].t < times[row]; ++next) {
      const event = events[next];
      const x = xOf(event);
      const y = yOf(event);
      if (row > 0 && event.t > times[row - 1] && isNumber(x) && isNumber(y)) put(x, y, row, event.from === "slip" ? 2 : 1);
    }
    while (next < events.length && events[next].t <= times[row]) ++next;
    put(line.x[row], line.y[row], row, line.status ? line.status[row] : null);
  }
  return drawn.x.length > line.x.length ? {...line, drawn} : line;
}

/** What an event tells of a column of its definition; undefined if nothing. */
function eventValue(one, event, name) {
  if (event.positions && isNumber(event.positions[name])) return event.positions[name];
  const definition = (one.definitions || []).find((other) => other.name === event.definition);
  if (!definition) return undefined;
  if (name === definition.limit_below) return event.force < 0 ? -event.limit : undefined;
  if (name === definition.limit) return definition.limit_below && event.force < 0 ? undefined : event.limit;
  // Of several components only the total is known, of a filter only the force before it.
  return name === definition.force && !definition.filtered ? event.force : undefined;
}

/** Puts the events into the curves of a panel that they are known of. */
function cornered(one, definition, panel) {
  const of = (line) => (event) => {
    const value = line.column ? eventValue(one, event, line.column) : undefined;
    return value !== undefined && line.mirrored ? -value : value;
  };
  panel.lines = panel.lines.map((line) => withEvents(one, definition, line,
      panel.kind === "loop" ? (event) => eventValue(one, event, panel.xName) : (event) => event.t, of(line)));
  return panel;
}

function forcePanels(one, definition, time) {
  const panels = [];
  const force = definition.force ? columnOf(one, definition.force) : null;
  const limit = definition.limit ? columnOf(one, definition.limit) : null;
  const below = definition.limit_below ? columnOf(one, definition.limit_below) : null;
  const parts = (definition.forces || []).map((name) => columnOf(one, name)).filter(Boolean);
  const main = force || parts[0];
  if (!main) return panels;
  const lines = [];
  parts.filter((part) => part.name !== main.name && part.unit === main.unit)
      .forEach((part, i) => lines.push(series(part.name, part, time.values, {colour: i + 1, dash: [[7, 2, 2, 2], [2, 2], [9, 3]][i % 3], thin: true})));
  lines.push(series(main.name, main, time.values, {main: true}));
  if (limit) {
    lines.push(series(limit.name, limit, time.values, {colour: "limit", dash: [6, 4]}));
    const signed = [main, ...parts].some((part) => part.unit === limit.unit && part.values.some((value) => value < 0));
    if (below) lines.push(series(below.name, below, time.values, {colour: "limit", dash: [6, 4]}));
    else if (signed) lines.push(series("\u2212" + limit.name, negative(limit), time.values, {colour: "limit", dash: [6, 4], silent: true, mirrored: true}));
  }
  panels.push({key: "force", title: main.name.startsWith("CSM") ? "Friction moment and limit" : "Friction force and limit", unit: main.unit, lines});
  const others = parts.filter((part) => part.unit !== main.unit);
  if (others.length > 0) {
    panels.push({key: "force:" + others[0].unit, title: "Other components", unit: others[0].unit,
                 lines: others.filter((part) => part.unit === others[0].unit)
                     .map((part, i) => series(part.name, part, time.values, {main: i === 0, colour: i || null, dash: i ? [7, 2, 2, 2] : []}))});
  }
  return panels;
}

function motionPanels(one, definition, time) {
  const positions = (definition.positions || []).map((name) => columnOf(one, name)).filter(Boolean);
  const units = [...new Set(positions.map((position) => position.unit))];
  return units.map((unit) => ({
    key: "motion:" + unit, title: unit === "rad" || unit === "deg" ? "Rotation" : "Motion", unit,
    lines: positions.filter((position) => position.unit === unit)
        .map((position, i) => series(position.name, position, time.values, {main: i === 0, colour: i || null, dash: i ? [[7, 2, 2, 2], [2, 2]][i % 2] : []}))
  }));
}

function energyLines(one, time) {
  const words = {work: "work", dissipated: "dissipated", stored: "stored", lost: "lost in jumps", kinetic: "of motion", external: "put in from outside"};
  const styles = {work: {colour: 1, dash: [7, 2, 2, 2]}, dissipated: {main: true}, stored: {colour: 3, dash: [2, 2]}};
  const lines = [];
  for (const [key, names] of Object.entries((one.energy || {}).columns || {})) {
    const columns = (names || []).map((name) => columnOf(one, name)).filter(Boolean);
    if (columns.length === 0) continue;
    const sum = columns[0].values.map((value, i) => columns.reduce((total, column) => total + (isNumber(column.values[i]) ? column.values[i] : NaN), 0));
    const style = styles[key] || {colour: 4 + (lines.length % 3), dash: [[12, 4], [8, 3, 2, 3], [4, 2]][lines.length % 3]};
    lines.push(series(words[key] || key.replace(/_/g, " "), {...columns[0], name: "", values: sum}, time.values, {...style, parts: columns}));
  }
  return lines;
}

/** The lines of the energies' picture: of a thinned run the pieces have no extremes of a sum, so that its parts are drawn. */
function energyCurves(one, time) {
  return energyLines(one, time).flatMap((line) => (one.thinned && line.parts.length > 1
      ? line.parts.map((part, i) => ({...line, ...series(`${line.label} (${part.name})`, part, time.values), main: line.main && i === 0, dash: i > 0 ? [3, 1 + 2 * i] : line.dash}))
      : [line]));
}

/** The histories of a case: panels over time. */
function histories(one, definition) {
  const time = timeOf(one);
  const panels = [];
  if (definition) {
    panels.push(...forcePanels(one, definition, time), ...motionPanels(one, definition, time));
    const normal = definition.normal_force ? columnOf(one, definition.normal_force) : null;
    const mu = definition.mu ? columnOf(one, definition.mu) : null;
    if (normal) panels.push({key: "normal", title: "Normal force", unit: normal.unit, lines: [series(normal.name, normal, time.values, {main: true})]});
    if (mu) panels.push({key: "mu", title: "Coefficient of friction", unit: "", lines: [series(mu.name, mu, time.values, {main: true})], optional: !varies(mu.values)});
  } else {
    // A table without friction: its first columns, one panel each.
    for (const column of (one.columns || []).filter((other) => other.name !== time.name && varies(columnOf(one, other.name).values)).slice(0, 4)) {
      panels.push(columnPanel(one, column.name));
    }
  }
  const energies = energyCurves(one, time);
  if (energies.length > 0) panels.push({key: "energy", title: "Energy", unit: energies[0].unit, lines: energies});
  for (const panel of panels) Object.assign(panel, {kind: "history", xName: time.name, xUnit: time.unit});
  return definition ? panels.map((panel) => cornered(one, definition, panel)) : panels;
}

/** A history of any one column. */
function columnPanel(one, name) {
  const column = columnOf(one, name);
  const time = timeOf(one);
  return column && {key: "column:" + name, kind: "history", title: column.text || name, unit: column.unit, xName: time.name, xUnit: time.unit,
                    lines: [series(name, column, time.values, {main: true})]};
}

/** A limit that stays is drawn once, not at every pass: dashes upon dashes are no dashes. */
function once(line) {
  const x = range(line.x);
  if (line.colour === "limit" && x && !varies(line.y)) line.drawn = {x: [x.low, x.high], y: [line.y[0], line.y[0]], row: [0, 0], status: []};
}

/** Force over motion, or, where two components move, the paths of force and motion. */
function loops(one, definition) {
  if (!definition) return [];
  const forces = (definition.forces || []).map((name) => columnOf(one, name));
  const positions = (definition.positions || []).map((name) => columnOf(one, name));
  const limit = definition.limit ? columnOf(one, definition.limit) : null;
  const status = definition.status ? columnOf(one, definition.status) : null;
  const below = definition.limit_below ? columnOf(one, definition.limit_below) : null;
  const path = (key, title, first, second, more = {}) => ({
    key, kind: "loop", title, unit: second.unit, yName: second.name, xName: first.name, xUnit: first.unit,
    lines: [{label: second.name, unit: second.unit, column: second.name, x: first.values, y: second.values, main: true, status: status && status.values}], ...more
  });
  const planar = forces[0] && forces[1] && positions[0] && positions[1] && forces[0].unit === forces[1].unit && varies(positions[0].values) && varies(positions[1].values);
  const panels = [];
  if (planar) {
    const circle = limit && limit.unit === forces[0].unit && status && limitIsCircle(forces[0].values, forces[1].values, limit.values, status.values) ? limit : null;
    panels.push(path("path:force", "Path of the force" + (circle ? " within its limit" : ""), forces[0], forces[1], {equal: true, circle}));
    if (positions[0].unit === positions[1].unit) panels.push(path("path:motion", "Path of the motion", positions[0], positions[1], {equal: true}));
  }
  const pairs = forces.map((force, i) => ({force, position: positions[i]})).filter(({force, position}) => force && position && varies(position.values));
  // What moves most comes first; a component that only stretches its contact comes last.
  const span = ({position}) => range(position.values).high - range(position.values).low;
  if (!planar) pairs.sort((a, b) => (a.position.unit === b.position.unit ? span(b) - span(a) : 0));
  for (const {force, position} of pairs.slice(0, planar ? 0 : 3)) {
    const panel = path(`loop:${force.name}:${position.name}`, `${force.name.startsWith("CSM") ? "Moment over rotation" : "Force over motion"}`, position, force);
    if (limit && forces.length === 1 && limit.unit === force.unit && isCalm(limit.values)) {
      const style = {colour: "limit", dash: [6, 4]};
      panel.lines.push({label: limit.name, unit: limit.unit, column: limit.name, x: position.values, y: limit.values, ...style},
                       {label: below ? below.name : "\u2212" + limit.name, unit: limit.unit, column: (below || limit).name, x: position.values, y: below ? below.values : negated(limit.values), ...style, silent: !below, mirrored: !below});
    }
    panels.push(panel);
  }
  for (const panel of panels) cornered(one, definition, panel).lines.forEach((line) => once(line));
  return panels;
}

function allPanels(one, definition, added) {
  const panels = [...loops(one, definition), ...histories(one, definition), ...added.map((name) => columnPanel(one, name)).filter(Boolean)];
  for (const panel of panels) for (const line of panel.lines) line.rows = rowsOf(one);
  return panels;
}

/** Dashes of the runs laid over the first; colours go along with them. */
const kRunDashes = [[8, 3], [2, 2], [8, 3, 2, 3], [12, 4], [4, 2], [1, 3]];

/** Adds the main curves of other runs to a panel of the same meaning. */
function layOver(panel, others) {
  // Beside other runs only what is compared stays, and its limit.
  const kept = panel.lines.filter((line) => others.length === 0 || line.main || line.colour === "limit");
  const lines = kept.map((line) => ({...line, run: 0}));
  others.forEach((other, i) => {
    const same = other.panels.find((candidate) => candidate.key === panel.key && candidate.unit === panel.unit && candidate.xUnit === panel.xUnit);
    const main = same && same.lines.find((line) => line.main);
    if (main) lines.push({...main, run: i + 1, label: other.name, colour: (i % 6) + 1, dash: kRunDashes[i % kRunDashes.length], main: false, status: null});
  });
  return {...panel, lines};
}

// ----------------------------------------------------------------------------------------- pictures

/** Limits of an axis about numbers from low to high, with a part of their range as air. */
function airy(low, high, air) {
  const size = Math.max(Math.abs(low), Math.abs(high));
  // Rounding is no range.
  if (high - low <= 1e-9 * size || size === 0) return [low - (0.05 * size || 1), high + (0.05 * size || 1)];
  return [low - air * (high - low), high + air * (high - low)];
}

/** A panel as a Chart.js chart with a layer of marks and a legend that tells values. */
class Picture {
  constructor(panel, height) {
    this.panel = panel;
    this.canvas = make("canvas", {role: "img", "aria-label": `${panel.title}: ${panel.yName || panel.lines.map((line) => line.label).join(", ")} over ${panel.xName}`});
    this.layer = makeSvg("svg", {"aria-hidden": "true"});
    this.plot = make("div", {class: "plot " + height}, this.canvas, this.layer);
    this.legend = make("ul", {class: "legend"});
    this.values = [];
    const title = panel.kind === "loop" ? `${labelled(panel.yName, panel.unit)} over ${panel.xName}` : labelled(panel.title, panel.unit);
    this.element = make("figure", {class: "panel", "data-panel": panel.key},
                        make("div", {class: "panel-head"}, make("h4", {}, panel.kind === "loop" && panel.title ? `${panel.title}: ` : "", quoted(title)), this.legend,
                             make("button", {type: "button", class: "save", "aria-label": `Save the picture: ${title}`, title: "Save this picture (PNG)", onclick: () => savePicture(this)}, "PNG")));
    this.element.append(this.plot);
    this.buildLegend();
  }

  /** Draws; the element must be in the page by now, since its size counts. */
  draw() {
    const {panel} = this;
    this.chart = new Chart(this.canvas, {
      type: "line",
      // Axes are the library's, curves our own: they are many.
      data: {datasets: []},
      options: {
        animation: false, responsive: true, maintainAspectRatio: false, events: [], normalized: false,
        layout: {padding: {top: kTop, right: kRight, left: 0, bottom: 0}},
        plugins: {legend: {display: false}, tooltip: {enabled: false}, filler: false},
        scales: {
          x: axisOptions({title: panel.kind === "history" && !panel.last ? null : labelled(panel.xName, panel.xUnit), limits: this.limits("x")}),
          y: axisOptions({limits: this.limits("y"), upright: true})
        }
      },
      plugins: [{
        id: "house",
        resize: (chart, {size}) => this.equalise(chart.options.scales, size),
        beforeDatasetsDraw: (chart) => { this.shade(chart); this.drawLines(chart); },
        // How wide a picture is is known only now, and anew where it becomes visible.
        afterDraw: (chart) => { this.chart = chart; this.placeMarks(); if (this.panel.windowed) tellShown(); }
      }]
    });
    if (panel.equal) {
      this.equalise(this.chart.options.scales, {width: this.plot.clientWidth, height: this.plot.clientHeight});
      this.chart.update("none");
    }
    this.chart.picture = this;
    listenTo(this);
  }

  drawLines(chart) {
    const {ctx: pen, chartArea: area} = chart;
    pen.save();
    pen.beginPath();
    // A line on the border keeps its width.
    pen.rect(area.left - 2, area.top - 2, area.right - area.left + 4, area.bottom - area.top + 4);
    pen.clip();
    const crowded = this.panel.kind === "history" && isCrowded(this.panel.lines, chart);
    // Where lines fill their place, dashes are no dashes and what matters lies on top.
    const lines = crowded ? [...this.panel.lines].sort((a, b) => Number(Boolean(a.main)) - Number(Boolean(b.main))) : this.panel.lines;
    for (const line of lines) if (!line.off) drawLine(pen, chart, this.panel, line, crowded);
    pen.restore();
  }

  /** The limits of a scale that show everything, or those of a place that is zoomed to. */
  limits(key) {
    if (this.zoomed) return this.zoomed[key];
    const {panel} = this;
    const whole = key === "x" ? panel.xLimits || this.span("x", panel.kind === "history" ? 0 : 0.04) : panel.yLimits || this.span("y", 0.06);
    if (!panel.windowed || !view.window) return whole;
    if (key === "x") return view.window;
    const seen = panel.lines.filter((line) => !line.off).map((line) => visibleRange(line, ...view.window)).filter(Boolean);
    return seen.length > 0 ? airy(Math.min(...seen.map(({low}) => low)), Math.max(...seen.map(({high}) => high)), 0.06) : whole;
  }

  /** Draws anew where it is zoomed to now. */
  rescale() {
    const {scales} = this.chart.options;
    for (const key of ["x", "y"]) [scales[key].min, scales[key].max] = this.limits(key);
    if (!this.zoomed) this.equalise(scales, {width: this.plot.clientWidth, height: this.plot.clientHeight});
    this.chart.update("none");
  }

  /** From the smallest to the largest value of the whole run, and a part of that as air. */
  span(key, air) {
    const ranges = this.panel.lines.map((line) => (key === "x" ? range((line.drawn || line).x) : wholeRange({...line, ...line.drawn}))).filter(Boolean);
    if (ranges.length === 0) return [-1, 1];
    return airy(Math.min(...ranges.map(({low}) => low)), Math.max(...ranges.map(({high}) => high)), air);
  }

  /** One scale in both directions, for paths. */
  equalise(scales, size) {
    const {panel} = this;
    if (!panel.equal || this.zoomed) return;
    const joined = (key) => panel.lines.map((line) => range((line.drawn || line)[key])).filter(Boolean).reduce((a, b) => ({low: Math.min(a.low, b.low), high: Math.max(a.high, b.high)}));
    let x = joined("x");
    let y = joined("y");
    if (panel.circle) {
      const radius = range(panel.circle.values).high;
      const grown = ({low, high}) => ({low: Math.min(low, -radius), high: Math.max(high, radius)});
      x = grown(x);
      y = grown(y);
    }
    const width = Math.max(size.width - kLeft - kRight, 50);
    const height = Math.max(size.height - kTop - kBottomTitled, 50);
    const perPixel = 1.08 * Math.max((x.high - x.low) / width, (y.high - y.low) / height) || 1;
    const set = (scale, {low, high}, pixels) => {
      scale.min = (low + high - perPixel * pixels) / 2;
      scale.max = (low + high + perPixel * pixels) / 2;
    };
    set(scales.x, x, width);
    set(scales.y, y, height);
  }

  /** Behind the curves: slip light, no friction dark and hatched; the tube of a check. */
  shade(chart) {
    const {ctx: pen, chartArea: area} = chart;
    pen.save();
    pen.beginPath();
    pen.rect(area.left, area.top, area.right - area.left, area.bottom - area.top);
    pen.clip();
    const pattern = this.panel.spans ? pen.createPattern(colours.hatch, "repeat") : null;
    const mixed = this.panel.spans ? pen.createPattern(colours.mixed, "repeat") : null;
    for (const [from, to, status, merged] of this.panel.spans || []) {
      const left = chart.scales.x.getPixelForValue(from);
      pen.fillStyle = merged ? mixed : status === 2 ? colours.slip : pattern;
      pen.fillRect(left, area.top, Math.max(chart.scales.x.getPixelForValue(to) - left, 0.5), area.bottom - area.top);
    }
    if (this.panel.spans) {
      // The grid again, faintly, where the shade hides it.
      pen.strokeStyle = colours.back;
      pen.globalAlpha = 0.6;
      pen.lineWidth = 1;
      for (const tick of chart.scales.y.getTicks()) {
        const y = Math.round(chart.scales.y.getPixelForValue(tick.value)) + 0.5;
        pen.beginPath();
        pen.moveTo(area.left, y);
        pen.lineTo(area.right, y);
        pen.stroke();
      }
      pen.globalAlpha = 1;
    }
    if (this.panel.tube) this.drawTube(chart, pen);
    // Zero, where it is inside: the sign of a force is what one looks for first.
    const zero = chart.scales.y.getPixelForValue(0);
    if (zero > area.top && zero < area.bottom) {
      pen.strokeStyle = colours.soft;
      pen.globalAlpha = 0.5;
      pen.beginPath();
      pen.moveTo(area.left, zero);
      pen.lineTo(area.right, zero);
      pen.stroke();
    }
    pen.restore();
  }

  drawTube(chart, pen) {
    const {x, y, index, half, sorted} = this.panel.tube;
    const along = (sign, backwards) => {
      for (let i = 0; i < x.length; ++i) {
        const k = backwards ? x.length - 1 - i : i;
        if (!isNumber(x[k]) || !isNumber(y[k])) continue;
        // Not between points that are no neighbours.
        const gap = index && k > 0 && index[k] - index[k - 1] > 1;
        (gap ? pen.moveTo : pen.lineTo).call(pen, chart.scales.x.getPixelForValue(x[k]), chart.scales.y.getPixelForValue(y[k] + sign * half));
      }
    };
    pen.fillStyle = colours.tube;
    pen.strokeStyle = colours[1];
    pen.lineWidth = 0.8;
    if (sorted) {
      pen.beginPath();
      along(1, false);
      along(-1, true);
      pen.fill();
    }
    for (const sign of [1, -1]) {
      pen.beginPath();
      along(sign, false);
      pen.stroke();
    }
  }

  buildLegend() {
    this.legend.replaceChildren();
    this.values = this.panel.lines.map((line, i) => {
      if (line.silent) return null;
      const value = make("span", {class: "value"});
      const swatch = makeSvg("svg", {viewBox: "0 0 30 10", "aria-hidden": "true"});
      line.swatch = makeSvg("line", {x1: 0, x2: 30, y1: 5, y2: 5, stroke: colourOf(line), "stroke-width": 2.4, "stroke-dasharray": (line.dash || []).join(" ")});
      swatch.append(line.swatch);
      const button = make("button", {type: "button", "aria-pressed": String(!line.off), title: "Show or hide", onclick: () => this.toggle(i, button)}, swatch, quoted(line.label), value);
      this.legend.append(make("li", {}, button));
      return value;
    });
  }

  /** Other numbers in the same picture; what was hidden stays so. */
  renew(panel) {
    const off = new Set(this.panel.lines.filter((line) => line.off).map((line) => line.label));
    this.panel = panel;
    for (const line of panel.lines) line.off = off.has(line.label);
    this.buildLegend();
    this.rescale();
  }

  toggle(at, button) {
    const {lines} = this.panel;
    const off = !lines[at].off;
    lines[at].off = off;
    button.setAttribute("aria-pressed", String(!off));
    // The mirrored limit goes with the limit.
    if (lines[at + 1] && lines[at + 1].silent) lines[at + 1].off = off;
    this.rescale();
  }

  recolour() {
    if (!this.chart) return;
    for (const line of this.panel.lines) if (line.swatch) line.swatch.setAttribute("stroke", colourOf(line));
    recolourAxes(this.chart);
  }

  /** Marks of the instant, and of a check's worst point. Kept apart from the curves: moving is cheap. */
  placeMarks() {
    if (!this.chart || !view) return;
    const {chartArea: area, scales} = this.chart;
    const parts = [];
    const pixel = (x, y) => [scales.x.getPixelForValue(x), scales.y.getPixelForValue(y)];
    const inside = ([x, y]) => x >= area.left - 1 && x <= area.right + 1 && y >= area.top - 1 && y <= area.bottom + 1;
    const line = (from, to, name) => parts.push(makeSvg("line", {x1: from[0], y1: from[1], x2: to[0], y2: to[1], class: name}));
    if (this.panel.circle) {
      const radii = [["limit-circle", this.panel.circle.values[view.places[0]]], ["limit-circle largest", range(this.panel.circle.values).high]];
      for (const [name, radius] of radii) {
        if (!isNumber(radius)) continue;
        const [cx, cy] = pixel(0, 0);
        parts.push(makeSvg("circle", {cx, cy, r: Math.abs(scales.x.getPixelForValue(radius) - cx), class: name}));
      }
    }
    if (this.panel.linked) {
      const now = this.panel.kind === "history" ? view.time() : null;
      if (now !== null) {
        const x = scales.x.getPixelForValue(now);
        if (x >= area.left - 1 && x <= area.right + 1) line([x, area.top], [x, area.bottom], "cursor-line");
      }
      this.panel.lines.forEach((one, i) => {
        const {x, y, away} = this.reading(one, now);
        // Of another instant than that of the bar: a point of another run, of a curve, or the row behind an event.
        const place = this.panel.kind === "loop" ? (one.main ? ` at ${this.panel.xName} ${told(x, one.x, this.panel.xUnit)}` : "")
                                                 : away ? ` at ${timeText(view.one, x)}` : "";
        if (this.values[i]) this.values[i].textContent = told(y, one.y, one.unit) + place;
        if (one.off || one.silent || !isNumber(x) || !isNumber(y)) return;
        const at = pixel(x, y);
        if (inside(at)) parts.push(makeSvg("circle", {cx: at[0], cy: at[1], r: one.main ? 5 : 3.5, fill: colourOf(one), class: "cursor-dot"}));
      });
    }
    if (this.selection) {
      const {left, right, top, bottom} = this.selection;
      parts.push(makeSvg("rect", {x: left, y: top, width: right - left, height: bottom - top, class: "selection"}));
    }
    this.layer.replaceChildren(...parts);
    if (this.panel.worst) this.markWorst(pixel, inside, line, parts, area);
  }

  /** What a curve is at the instant: a point of its own, or what is known of the event that is chosen. */
  reading(line, now) {
    if (line.run === undefined) {
      // The curve of a check, over the time.
      const at = nearestRow(line.x, now);
      return {x: line.x[at], y: line.y[at], away: this.isAway(line.x[at], now)};
    }
    const row = view.places[line.run];
    const history = this.panel.kind === "history";
    if (line.run === 0 && view.event && line.column) {
      const known = eventValue(view.one, view.event, line.column);
      const x = history ? view.event.t : eventValue(view.one, view.event, this.panel.xName);
      if (known !== undefined && x !== undefined) return {x, y: line.mirrored ? -known : known, away: false};
    }
    const x = line.x[row];
    return {x, y: line.y[row], away: history && line.run > 0 && this.isAway(x, now)};
  }

  /** Another instant, not only the same one written with other digits. */
  isAway(x, now) { return isNumber(x) && Math.abs(x - now) > 0.5 * stepsOf(view.times[0]).least; }

  markWorst(pixel, inside, line, parts, area) {
    const {x, y, reference, text} = this.panel.worst;
    const at = pixel(x, y);
    if (!inside(at)) return;
    if (isNumber(reference)) line(at, pixel(x, reference), "worst-line");
    parts.push(makeSvg("circle", {cx: at[0], cy: at[1], r: 7, class: "worst-ring"}));
    const right = at[0] < (area.left + area.right) / 2;
    const high = at[1] < area.top + 26;
    const label = makeSvg("text", {y: at[1] + (high ? 18 : -9), class: "worst-label", "text-anchor": right ? "start" : "end"});
    label.textContent = text;
    parts.push(label);
    this.layer.replaceChildren(...parts);
    // On a phone the label is shifted until it is inside, and made narrower where it does not fit at all.
    const room = this.plot.clientWidth - 8;
    const width = Math.min(label.getComputedTextLength() + 4, room);
    if (width === room) {
      label.setAttribute("textLength", room);
      label.setAttribute("lengthAdjust", "spacingAndGlyphs");
    }
    label.setAttribute("x", right ? Math.max(4, Math.min(at[0] + 12, this.plot.clientWidth - 4 - width)) : Math.max(at[0] - 12, width + 4));
  }

  /** The instant that is nearest to the pointer. */
  pointed(event) {
    if (!this.panel.linked || !this.chart) return;
    const box = this.canvas.getBoundingClientRect();
    const x = event.clientX - box.left;
    const y = event.clientY - box.top;
    const {scales, chartArea: area} = this.chart;
    if (x < area.left - 8 || x > area.right + 8 || y < area.top - 8 || y > area.bottom + 8) return;
    if (this.panel.kind === "history") {
      const times = view.times[0];
      view.moveTo(nearestRow(times, scales.x.getValueForPixel(x)));
      return;
    }
    const main = this.panel.lines.find((line) => line.main);
    const xOf = (value) => scales.x.getPixelForValue(value);
    const yOf = (value) => scales.y.getPixelForValue(value);
    let best = null;
    let least = Infinity;
    for (let i = 0; i < main.x.length; ++i) {
      if (!isNumber(main.x[i]) || !isNumber(main.y[i])) continue;
      // A loop passes the same place often: of equally near rows that nearest in history is meant.
      const far = (xOf(main.x[i]) - x) ** 2 + (yOf(main.y[i]) - y) ** 2 + 40 * Math.abs(i - view.places[0]) / main.x.length;
      if (far < least) {
        least = far;
        best = i;
      }
    }
    if (best !== null) view.moveTo(best);
  }

  destroy() {
    if (this.chart) this.chart.destroy();
    pictures = pictures.filter((other) => other !== this);
  }
}

// ----------------------------------------------------------------------------------------- one case

/** What is shown: a case, a definition of it, runs laid over it, and the instant. */
let view = null;

class View {
  constructor(one) {
    this.one = one;
    this.definition = (one.definitions || [])[0] || null;
    this.others = (page.compare || []).filter((group) => group.includes(one.id)).flat().filter((id) => id !== one.id && byId.has(id)).map((id) => byId.get(id));
    this.others = [...new Set(this.others)];
    this.added = [];
    /** The row of each run. */
    this.places = [0];
    /** The event that is chosen, if one is. */
    this.event = null;
    /** What the histories show; null: all. */
    this.window = null;
    this.setTimes();
    const {event, t} = this.firstInstant();
    this.event = event;
    this.setPlaces(event ? rowFrom(this.times[0], event.t) : nearestRow(this.times[0], t));
  }

  setTimes() { this.times = [this.one, ...this.others].map((other) => timeOf(other).values || []); }
  time() { return this.event ? this.event.t : this.times[0][this.places[0]]; }
  /** Whether the chosen event is of the definition that is shown. */
  sameDefinition() { return this.event && this.definition && this.event.definition === this.definition.name; }

  /** Worth looking at first: a failing check's worst point, else where slip begins. */
  firstInstant() {
    const failing = failingChecks(this.one).find((check) => isNumber((worstOf(check) || {}).time));
    if (failing) return {event: null, t: worstOf(failing).time};
    const times = this.times[0];
    const slip = (this.one.events || []).find((event) => event.to === "slip" && event.t > times[0]);
    return {event: slip || null, t: (times[0] + times[times.length - 1]) / 2};
  }

  setPlaces(row) {
    this.places[0] = row;
    const now = this.time();
    for (let run = 1; run < this.times.length; ++run) this.places[run] = nearestRow(this.times[run], now);
  }

  moveTo(row, quietly, event = null) {
    const times = this.times[0];
    if (!times || times.length === 0) return;
    this.event = event;
    this.setPlaces(Math.min(Math.max(row, 0), times.length - 1));
    followInstant();
    showInstant();
    if (!quietly) keepAddress();
  }
  moveToTime(t, quietly) { this.moveTo(nearestRow(this.times[0], t), quietly); }
  /** To an event: what is not known of it is that of the first drawn row that is not before it. */
  choose(event, quietly) { this.moveTo(rowFrom(this.times[0], event.t), quietly, event); }

  statusNow() {
    const words = {0: "no friction", 1: "stick", 2: "slip"};
    if (!this.definition) return "";
    if (this.sameDefinition()) return {open: words[0], jump: words[2]}[this.event.to] || this.event.to;
    const column = this.definition.status ? columnOf(this.one, this.definition.status) : null;
    if (column) return words[column.values[this.places[0]]] || "";
    const now = this.time();
    const on = (this.definition.spans || []).find(([from, to]) => from <= now && now < to);
    return on ? (on[3] ? "" : words[on[2]]) : "stick";
  }
}

const failingChecks = (one) => (one.checks || []).filter((check) => !check.passed);

/** The number of an event in its run, from 1: in the middle of a long run events are left out of the list. */
function eventNumber(one, event) {
  const at = one.events.indexOf(event);
  const total = one.events_total || one.events.length;
  return at < leftOut(one).after ? at + 1 : total - (one.events.length - 1 - at);
}
/** How many events the list has before others are left out, and how many those are. */
function leftOut(one) {
  const listed = (one.events || []).length;
  const total = one.events_total || listed;
  return total > listed ? {after: listed >> 1, count: total - listed} : {after: listed, count: 0};
}

/** The measure that decides about a check of such a criterion. */
function worstMeasure(check) {
  const judged = (check.measures || []).filter((measure) => isNumber(measure.tolerance));
  const part = (measure) => (measure.tolerance > 0 ? measure.deviation / measure.tolerance : measure.deviation > 0 ? Infinity : 0);
  return judged.sort((a, b) => part(b) - part(a))[0] || null;
}

/** Where a check is worst: its own point, or that of its worst measure. */
function worstOf(check) {
  if (check.worst && isNumber(check.worst.value)) return check.worst;
  const measure = worstMeasure(check);
  return (measure && measure.where) || check.worst || null;
}

let instantParts = null;

function showInstant() {
  for (const picture of pictures) picture.placeMarks();
  if (!instantParts) return;
  const {output, state, word, slider} = instantParts;
  const now = view.time();
  const time = timeOf(view.one);
  const {event} = view;
  output.textContent = `t = ${timeText(view.one, now, event ? 1 : 0)}` + (time.unit ? "\u00a0" + time.unit : "");
  const row = view.times[0][view.places[0]];
  const total = view.one.events_total || (view.one.events || []).length;
  instantParts.note.textContent = event
      ? `event ${eventNumber(view.one, event)} of ${total}` + (row !== event.t ? `, between two rows: other numbers are those at t = ${timeText(view.one, row)}` : "") : "";
  for (const [button, step] of instantParts.steps) button.disabled = !nextEvent(step);
  const status = view.statusNow();
  state.className = "state-box " + {slip: "slip", "no friction": "open", stick: "stick"}[status];
  word.textContent = status;
  slider.value = String(view.places[0]);
  slider.setAttribute("aria-valuetext", `${output.textContent}, ${status}`);
  const energy = instantParts.energy;
  if (energy) energy.forEach(({cell, line}) => { cell.textContent = withUnit(line.y[view.places[0]], line.unit, 5); });
  if (instantParts.events) markEvent(now);
}

/** The last event not after the instant is marked in the list. */
function markEvent(now) {
  const {events, rows} = instantParts;
  let last = view.event ? events.indexOf(view.event) : -1;
  if (!view.event) {
    for (let i = 0; i < events.length; ++i) if (events[i].t <= now) last = i;
    // Among those that are left out nobody knows which is the last.
    const {after, count} = leftOut(view.one);
    if (count > 0 && last === after - 1 && now > events[last].t) last = -1;
  }
  if (instantParts.near === last) return;
  const reach = (at, index) => { rows[at].querySelector("button").tabIndex = index; };
  if (rows[instantParts.near]) rows[instantParts.near].classList.remove("near");
  reach(Math.max(instantParts.near, 0), -1);
  reach(Math.max(last, 0), 0);
  instantParts.near = last;
  if (!rows[last]) return;
  rows[last].classList.add("near");
  // Only the list is scrolled, never the page.
  const box = rows[last].closest(".scroll");
  const top = rows[last].offsetTop;
  if (top < box.scrollTop + 30 || top + 30 > box.scrollTop + box.clientHeight) box.scrollTop = top - box.clientHeight / 2;
}

function show(one) {
  for (const picture of [...pictures]) picture.destroy();
  view = new View(one);
  layOut(one, pictureSection(), drawPictures);
}

/** Fills the page with a case; `draw` draws into its pictures' section. */
function layOut(one, section, draw) {
  instantParts = null;
  const main = find("case");
  main.replaceChildren(header(one));
  if ((one.rows || []).length > 0) {
    main.append(instantBar(one), section);
    draw();
  }
  if ((one.checks || []).length > 0) {
    // A reviewer of a failing case comes for the check: it stands above the pictures.
    const checks = checkSection(one);
    if (failingChecks(one).length > 0 && main.querySelector(".instant")) main.querySelector(".instant").after(checks);
    else main.append(checks);
    openChecks();
  }
  if ((one.rows || []).length > 0) {
    main.append(...[runSection(one), eventSection(one), coverageSection(one), settingSection(one)].filter(Boolean));
    showInstant();
  }
  document.title = `${one.title || one.name} \u2013 ${page.title || "report"}`;
  markChosen();
}

function header(one) {
  const block = make("header", {},
      make("p", {class: "case-name"}, quoted(one.name)),
      make("h2", {}, quoted(one.title || one.name)));
  const facts = [make("span", {class: "badge " + one.status}, `${kStatusMarks[one.status]} ${kStatusWords[one.status]}`)];
  const said = [];
  if (one.increments > 0) said.push(plural(one.increments, "increment"));
  const parameters = Object.entries(one.parameters || {});
  if (parameters.length > 0) said.push(parameters.map(([name, value]) => `${name} = ${isNumber(value) ? number(value, 6) : value}`).join(", "));
  block.append(make("p", {class: "facts"}, facts, make("span", {class: "soft"}, quoted(said.join(" \u00b7 ")))));
  if ((one.summary || []).length > 0) block.append(make("ul", {class: "summary"}, one.summary.map((line) => make("li", {}, quoted(line)))));
  if ((one.warnings || []).length > 0) {
    block.append(make("ul", {class: "notes"}, [...new Set(one.warnings)].map((line) => make("li", {class: "note"}, make("b", {}, "Note: "), quoted(line)))));
  }
  if (one.rows_total > 0 && one.rows_total !== one.increments + 1) block.append(make("p", {class: "facts soft", id: "part"}, partWords(one)));
  if (one.thinned) block.append(make("p", {class: "facts soft", id: "thinned"}, thinnedWords(one)));
  if (one.details === false && one.status !== "not_run") {
    block.append(make("p", {class: "facts soft"}, "The curves of this case are left out to keep the page small; a report of this case alone draws them."));
  }
  if (one.message) block.append(make("pre", {tabindex: 0, "aria-label": "Why it was not run"}, one.message));
  if ((one.definitions || []).length > 1) block.append(definitionTabs(one));
  return block;
}

/** What is drawn of a thinned run, so that nobody takes the rest for a curve. */
function thinnedWords(one) {
  const {piece, drawn} = rowsOf(one);
  const loops = () => {
    if (!one.cycles) return `In loops every row that the page has (${one.rows_shown}) is a dot.`;
    const whole = drawn.map(([cycle]) => cycle).filter((cycle) => cycle > 0);
    const rest = drawn.some(([cycle]) => cycle === 0) ? ", and what comes after them" : "";
    return `In loops ${whole.length === 1 ? "cycle" : "the cycles"} ${whole.join(", ")} of ${one.cycles.total} (of ${one.cycles.of}) ${whole.length === 1 ? "is" : "are"} drawn with all rows${rest}; the first one light, the last one dark.`;
  };
  return `The run has ${one.rows_total} rows. Histories show the first, the last, the smallest and the largest value of every ${piece} rows, and every row about the first and last events. ` +
      `${loops()} Nothing is drawn between rows that are not neighbours.`;
}

/** What of the run a result has: a line then joins rows that are neighbours in the file. */
function partWords(one) {
  const step = Math.round(one.increments / Math.max(one.rows_total - 1, 1));
  return `The result has ${one.rows_total} of the run's ${one.increments + 1} rows` + (step > 1 ? `, one in ${step}` : "") + "; lines join those.";
}

function definitionTabs(one) {
  const tabs = make("div", {class: "tabs", role: "tablist", "aria-label": "Friction definitions"});
  const choose = (definition, focus) => {
    view.definition = definition;
    for (const tab of tabs.children) {
      const on = tab.dataset.name === definition.name;
      tab.setAttribute("aria-selected", String(on));
      tab.tabIndex = on ? 0 : -1;
      if (on && focus) tab.focus();
    }
    drawPictures();
    const run = find("run");
    if (run) run.replaceWith(runSection(one));
    showInstant();
  };
  one.definitions.forEach((definition, i) => {
    tabs.append(make("button", {
      type: "button", role: "tab", "aria-controls": "pictures", "aria-selected": String(i === 0), tabindex: i === 0 ? 0 : -1, "data-name": definition.name,
      onclick: () => choose(definition, false),
      onkeydown: (event) => {
        const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
        if (!step) return;
        event.preventDefault();
        choose(one.definitions[(i + step + one.definitions.length) % one.definitions.length], true);
      }
    }, quoted(definition.name)));
  });
  return tabs;
}

function instantBar(one) {
  const output = make("output", {"aria-live": "off"});
  const state = make("span", {class: "state-box", "aria-hidden": "true"});
  const word = make("span");
  const slider = make("input", {type: "range", id: "instant", min: 0, max: Math.max(view.times[0].length - 1, 0), step: 1, "aria-label": "Instant",
                                oninput: () => view.moveTo(Number(slider.value))});
  const note = make("span", {class: "soft event-note"});
  const back = make("button", {type: "button", title: "Previous event (p)", onclick: () => toEvent(-1)}, "\u2039 event");
  const on = make("button", {type: "button", title: "Next event (n)", onclick: () => toEvent(1)}, "event \u203a");
  instantParts = {output, state, word, slider, note, steps: [[back, -1], [on, 1]]};
  const steps = (one.events || []).length > 0 ? make("span", {class: "steps"}, back, on) : null;
  return make("div", {class: "instant", role: "group", "aria-label": "Instant shown in all pictures"}, output, make("span", {class: "state"}, state, word), slider, steps, note);
}

/** The listed event before or after the instant. */
function nextEvent(step) {
  const events = view.one.events || [];
  if (view.event) return events[events.indexOf(view.event) + step];
  const now = view.time();
  return step > 0 ? events.find((event) => event.t > now) : events.filter((event) => event.t < now).pop();
}

function toEvent(step) {
  const next = nextEvent(step);
  if (next) view.choose(next);
}

// --------------------------------------------------------------------- the pictures and their tools

function pictureSection() {
  return make("section", {"aria-labelledby": "pictures-title"},
      make("h3", {id: "pictures-title", class: "hidden"}, "Pictures"),
      make("div", {class: "row-of-tools"}, make("div", {class: "shades", id: "shades"}), compareBox(), windowTools()),
      make("p", {class: "soft", id: "shown"}),
      make("div", {class: "pictures", id: "pictures"}),
      addHistory());
}

/** The panels of what is shown: those of the case, with other runs laid over them. */
function panelsNow() {
  const {one, definition} = view;
  const mine = allPanels(one, definition, view.added);
  const others = view.others.map((other) => ({name: other.name, panels: allPanels(other, sameDefinition(other, definition), view.added)}));
  let panels = mine.map((panel) => layOver(panel, others));
  // A coefficient that never changes needs no picture, unless another run's does.
  panels = panels.filter((panel) => !panel.optional || panel.lines.length > 1);
  const shown = panels.filter((panel) => panel.kind === "history");
  const times = view.times.map((values) => range(values)).filter(Boolean);
  const limits = times.length > 0 ? [Math.min(...times.map((time) => time.low)), Math.max(...times.map((time) => time.high))] : undefined;
  shown.forEach((panel, i) => Object.assign(panel, {xLimits: limits && limits[0] < limits[1] ? limits : undefined, spans: definition ? definition.spans : null, last: i === shown.length - 1, windowed: true}));
  if (shown.length > 0 && !shown[0].last) shown[0].last = shown.length < 2;
  return panels.map((panel) => ({...panel, linked: true}));
}

const picturesShown = () => pictures.filter((other) => find("pictures").contains(other.element));

function drawPictures() {
  const box = find("pictures");
  for (const picture of picturesShown()) picture.destroy();
  const made = panelsNow().map((panel) => new Picture(panel, panel.kind === "loop" ? "loop" : panel.last ? "history last" : "history"));
  const left = make("div", {class: "column"}, made.filter((picture) => picture.panel.kind === "loop").map((picture) => picture.element));
  const right = make("div", {class: "column"}, made.filter((picture) => picture.panel.kind === "history").map((picture) => picture.element));
  box.replaceChildren(...[left, right].filter((column) => column.children.length > 0));
  box.classList.toggle("histories-only", left.children.length === 0);
  left.classList.toggle("stays", left.children.length === 1);
  pictures.push(...made);
  for (const picture of made) picture.draw();
  showShades();
  tellShown();
}

/** Draws other numbers of the same case into the pictures that are there, if they are the same ones. */
function redrawPictures() {
  const panels = panelsNow();
  const shown = picturesShown();
  const title = ({key, kind, title: words, unit, xName, xUnit, yName}) => [key, kind, words, unit, xName, xUnit, yName].join();
  if (shown.length !== panels.length || shown.some((picture, i) => title(picture.panel) !== title(panels[i]))) return drawPictures();
  shown.forEach((picture, i) => picture.renew(panels[i]));
  showShades();
  tellShown();
}

function showShades() {
  const {definition, one} = view;
  // As the summary tells it.
  const share = definition && isNumber(definition.slip_share) ? ` ${Math.round(100 * definition.slip_share)} % of the time` : "";
  const spans = (definition && definition.spans) || [];
  const open = spans.some((span) => span[2] === 0 && !span[3]);
  const mixed = [2, 0].filter((status) => spans.some((span) => span[2] === status && span[3]));
  find("shades").replaceChildren(...(definition ? [
    make("span", {}, make("i", {class: "state-box"}), "stick"),
    make("span", {}, make("i", {class: "state-box slip"}), "slip" + share),
    open ? make("span", {}, make("i", {class: "state-box open"}), "no friction") : null,
    ...mixed.map((status) => make("span", {}, make("i", {class: "state-box mixed"}), status === 2 ? "stick and slip, too fast to draw" : "friction lost and found, too fast to draw")),
    make("span", {}, "in loops, slip is the bolder line"),
    view.others.length > 0 ? make("span", {id: "shaded-run"}, "shades, state and limit are those of ", quoted(one.name)) : null
  ].filter(Boolean) : []));
}

/** True if some curve of `other` can be drawn over one of the case shown. */
function comparable(other) {
  if (other === view.one || (other.rows || []).length === 0) return false;
  const mine = new Map((view.one.columns || []).map((column) => [column.name, column.unit]));
  const shared = (other.columns || []).filter((column) => column.name !== "t" && mine.get(column.name) === column.unit);
  const forces = view.definition ? view.definition.forces || [] : [];
  return forces.length > 0 ? shared.some((column) => forces.includes(column.name)) : shared.length > 0;
}

const kMostRuns = 6;

function compareBox() {
  const list = make("div", {class: "choices"});
  const summary = make("summary");
  const tell = () => { summary.textContent = view.others.length > 0 ? `Compared with ${plural(view.others.length, "run")}` : "Compare with\u2026"; };
  const fill = () => {
    const candidates = cases.filter((other) => comparable(other) || view.others.includes(other));
    list.replaceChildren(...candidates.map((other) => make("label", {},
        make("input", {type: "checkbox", value: other.id, checked: view.others.includes(other), disabled: !view.others.includes(other) && view.others.length >= kMostRuns,
                       onchange: (event) => { choose(other, event.target.checked); }}), quoted(other.name))));
    if (candidates.length === 0) list.append(make("p", {class: "soft"}, "No other run has these quantities in these units."));
  };
  const choose = (other, on) => {
    const focused = document.activeElement && document.activeElement.value;
    view.others = on ? [...view.others, other] : view.others.filter((one) => one !== other);
    view.setTimes();
    view.places = [view.places[0]];
    drawPictures();
    view.moveTo(view.places[0], false, view.event);
    tell();
    fill();
    for (const box of list.querySelectorAll("input")) if (box.value === focused) box.focus();
  };
  tell();
  const box = make("details", {class: "compare", id: "compare", ontoggle: () => { if (box.open) fill(); }}, summary, list);
  return cases.length > 1 ? box : null;
}

function addHistory() {
  const select = make("select", {"aria-label": "Draw the history of another column", onchange: () => {
    if (!select.value) return;
    view.added.push(select.value);
    select.querySelector(`option[value="${CSS.escape(select.value)}"]`).remove();
    select.value = "";
    drawPictures();
    showInstant();
  }}, make("option", {value: ""}, "Draw another column\u2026"));
  for (const column of view.one.columns || []) {
    if (column.name !== "t") select.append(make("option", {value: column.name}, labelled(column.name, column.unit) + (column.text ? " \u2013 " + column.text : "")));
  }
  return make("p", {class: "add-history"}, select);
}

// ----------------------------------------------------------------------- limits, energies and events

function runSection(one) {
  const {definition} = view;
  const block = make("section", {id: "run", "aria-labelledby": "run-title"}, make("h3", {id: "run-title"}, "Limits and energy"));
  const tables = make("div", {class: "beside"});
  if (definition) {
    const names = [...new Set([definition.force, ...(definition.forces || []), definition.limit, definition.limit_below, definition.normal_force, definition.mu, ...(definition.positions || [])].filter(Boolean))];
    const rows = names.map((name) => columnOf(one, name)).filter(Boolean).map((column) => {
      const found = wholeRange(column) || {};
      const size = Math.max(Math.abs(found.low), Math.abs(found.high));
      // What rounding left of a number that returns to 0.
      const told = (value) => number(Math.abs(value) < 1e-12 * size ? 0 : value, 5);
      return make("tr", {}, make("th", {scope: "row", title: column.text || false}, labelled(column.name, column.unit)),
                  ...[found.low, found.high, column.values[column.values.length - 1]].map((value) => make("td", {class: "number"}, told(value))));
    });
    tables.append(inScroll(make("table", {class: "plain"}, make("caption", {}, "Smallest, largest and last values"),
        make("thead", {}, make("tr", {}, make("th", {scope: "col"}, "Quantity"), ...["Smallest", "Largest", "At the end"].map((word) => make("th", {scope: "col", class: "number"}, word)))),
        make("tbody", {}, rows))));
  }
  const lines = energyLines(one, timeOf(one));
  if (lines.length > 0) tables.append(energyTable(one, lines));
  if (tables.children.length === 0) return null;
  block.append(tables);
  return block;
}

function energyTable(one, lines) {
  const last = (line) => line.y[line.y.length - 1];
  const cells = [];
  const rows = lines.map((line) => {
    const cell = make("td", {class: "number"});
    cells.push({cell, line});
    return make("tr", {}, make("th", {scope: "row"}, line.label), cell, make("td", {class: "number"}, withUnit(last(line), line.unit, 5)));
  });
  const named = (name) => lines.find((line) => line.label === name);
  const [work, dissipated, stored, lost] = ["work", "dissipated", "stored", "lost in jumps"].map(named);
  // The work of friction alone says nothing about springs, dampers and masses.
  const alone = (one.energy.columns.dissipated || []).concat(one.energy.columns.stored || []).every((name) => /^(DISS|STRAIN_E)(\.|$)/.test(name));
  if (work && dissipated && stored && alone && lines.length === (lost ? 4 : 3)) {
    const rest = work.y.map((value, i) => value - dissipated.y[i] - stored.y[i] - (lost ? lost.y[i] : 0));
    const line = {y: rest, unit: work.unit};
    const scale = Math.max(...[work, dissipated, stored].map((part) => Math.abs(last(part))));
    const cell = make("td", {class: "number"});
    cells.push({cell, line});
    rows.push(make("tr", {}, make("th", {scope: "row"}, "not accounted for"), cell,
                   make("td", {class: "number"}, withUnit(last(line), line.unit, 2))));
    if (scale > 0) rows.push(make("tr", {}, make("th", {scope: "row"}, "as a part of the whole"), make("td"), make("td", {class: "number"}, number(last(line) / scale, 2))));
  }
  if (instantParts) instantParts.energy = cells;
  return inScroll(make("table", {class: "plain"}, make("caption", {}, "Energy balance"),
      make("thead", {}, make("tr", {}, make("th", {scope: "col"}, "Energy"), ...["At the instant", "At the end"].map((word) => make("th", {scope: "col", class: "number"}, word)))),
      make("tbody", {}, rows)));
}

function eventSection(one) {
  const events = one.events || [];
  if (events.length === 0) return null;
  const time = timeOf(one);
  const several = (one.definitions || []).length > 1;
  const positions = Object.keys(events[0].positions || {});
  const unitOf = (name) => (columnOf(one, name) || {unit: ""}).unit;
  const rows = events.map((event, i) => {
    const force = (one.definitions || []).find((definition) => definition.name === event.definition) || {};
    return make("tr", {},
        make("td", {class: "number"}, make("button", {type: "button", tabindex: i === 0 ? 0 : -1, onclick: () => view.choose(event)}, timeText(one, event.t, 2))),
        several ? make("td", {}, quoted(event.definition)) : null,
        make("td", {}, event.reversal ? "slip turns round" : `${event.from} \u2192 ${event.to}`),
        make("td", {class: "number"}, withUnit(event.force, unitOf(force.force))),
        make("td", {class: "number"}, withUnit(event.limit, unitOf(force.limit))),
        positions.map((name) => make("td", {class: "number"}, withUnit(event.positions[name], unitOf(name)))));
  });
  const total = one.events_total || events.length;
  const {after, count} = leftOut(one);
  const caption = (count > 0 ? `The first ${after} and the last ${events.length - after} of ${total} events` : plural(total, "event")) + "; choose one to see its instant";
  const lines = [...rows];
  if (count > 0) lines.splice(after, 0, make("tr", {class: "gap"}, make("td", {colspan: rows[0].children.length}, `${count} events are not listed: the list goes on with event ${after + count + 1}`)));
  const column = (word, numeric = true) => make("th", {scope: "col", class: numeric ? "number" : ""}, word);
  Object.assign(instantParts, {events, rows, near: -1});
  // One stop of Tab for the whole list; arrows go through it.
  const step = (key) => {
    const at = rows.indexOf(document.activeElement.closest("tr"));
    const next = rows[at + {ArrowDown: 1, ArrowUp: -1}[key.key]];
    if (at < 0 || !next) return;
    key.preventDefault();
    const button = next.querySelector("button");
    button.focus({preventScroll: true});
    button.click();
  };
  return make("section", {"aria-labelledby": "events-title"}, make("h3", {id: "events-title"}, "Events"),
      make("p", {class: "soft", id: "events-caption"}, caption),
      make("div", {class: "scroll", tabindex: 0, role: "region", "aria-label": "Events", onkeydown: step},
          make("table", {"aria-describedby": "events-caption"}, make("caption", {class: "hidden"}, "Events"),
              make("thead", {}, make("tr", {}, column(labelled("t", time.unit)), several ? column("Definition", false) : null, column("Change", false), column("Force"), column("Limit"), positions.map((name) => column(name)))),
              make("tbody", {}, lines))));
}

// ------------------------------------------------------------------------------------ what was run

/** The setting of a case: connection and friction in words, units, parameters, tables, history, and its file. */
function settingSection(one) {
  const units = Object.entries(one.units || {}).filter(([name]) => name !== "energy");
  const parameters = Object.entries(one.parameters || {});
  const said = [...((one.run || {}).facts || []),
                ["units", units.map(([name, unit]) => `${name} ${unit}`).join(", ") || "not stated"],
                ["parameters", parameters.map(([name, value]) => `${name} = ${isNumber(value) ? number(value, 10) : value}`).join(", ")],
                ["program", page.generator || ""]].filter(([, words]) => words);
  const facts = make("dl", {class: "setting"}, said.map(([name, words]) => make("div", {}, make("dt", {}, quoted(name)), make("dd", {}, quoted(words)))));
  const tables = ((one.run || {}).tables || []).map(({title, head, rows, left_out}) => {
    const numeric = head.map((_, c) => rows.every((row) => row[c] !== "" && Number.isFinite(Number(row[c]))));
    const style = (c) => (numeric[c] ? "number" : "");
    const caption = title + (left_out > 0 ? `; ${plural(left_out, "more row")} in the file` : "");
    return inScroll(make("table", {class: "plain"}, make("caption", {}, quoted(caption)),
        make("thead", {}, make("tr", {}, head.map((word, c) => make("th", {scope: "col", class: style(c)}, quoted(word))))),
        make("tbody", {}, rows.map((row) => make("tr", {}, row.map((cell, c) => make("td", {class: style(c)}, quoted(cell))))))));
  });
  const text = (one.run || {}).text;
  return make("section", {id: "setting", "aria-labelledby": "setting-title"}, make("h3", {id: "setting-title"}, "What was run"), facts,
      one.kind === "result" ? make("p", {class: "soft"}, "A result does not say more of its case; a page of the case itself tells connection, laws and history.") : null,
      tables.length > 0 ? make("div", {class: "beside"}, tables) : null,
      text ? make("details", {class: "file"}, make("summary", {}, "The case file"), make("pre", {tabindex: 0, "aria-label": "The case file"}, text)) : null);
}

// ------------------------------------------------------------------------------- coverage of tables

const axisName = (axis) => axis.name.replace(/_/g, " ");

/** The words over the cells of an axis: between its knots, or at them where a cell is a knot. */
function cellNames(axis, cells) {
  const knots = axis.knots || [];
  if (cells === knots.length) return knots.map((knot) => number(knot));
  return Array.from({length: cells}, (_, i) => (i + 1 < knots.length ? `${number(knots[i])} \u2026 ${number(knots[i + 1])}` : `cell ${i + 1}`));
}

function coverageCell(count, largest, words) {
  const seen = count > 0;
  const weight = seen ? 0.12 + 0.68 * Math.log1p(count) / Math.log1p(largest) : 0;
  return make("td", {class: seen ? "seen" : "never", style: seen ? `background: rgba(var(--cell), ${weight.toFixed(3)})` : null, title: `${words}: ${seen ? plural(count, "increment") : "never visited"}`},
              make("span", {}, seen ? String(count) : "0"));
}

function coverageMap(title, columns, rows, visits, bounds) {
  const names = cellNames(columns, visits[0].length);
  const rowNames = rows ? cellNames(rows, visits.length) : [""];
  const largest = Math.max(1, ...visits.flat());
  const table = make("table", {class: "coverage"},
      make("caption", {}, quoted(title)),
      make("thead", {}, make("tr", {}, make("th", {scope: "col"}, rows ? `${axisName(rows)} \u2193  ${axisName(columns)} \u2192` : axisName(columns)), names.map((name) => make("th", {scope: "col"}, name)))),
      // The second axis grows upwards, as in a diagram.
      make("tbody", {}, visits.map((row, i) => make("tr", {}, make("th", {scope: "row"}, rows ? rowNames[i] : "increments"),
          row.map((count, k) => coverageCell(count, largest, [names[k], rowNames[i]].filter(Boolean).join(", "))))).reverse()));
  return make("div", {class: "coverage-block", tabindex: 0, role: "region", "aria-label": "Coverage of " + title}, table, make("p", {class: "soft"}, bounds));
}

function coverageSection(one) {
  const tables = one.coverage || [];
  if (tables.length === 0) return null;
  const block = make("section", {"aria-labelledby": "coverage-title"}, make("h3", {id: "coverage-title"}, "Where the tables were used"),
      make("p", {class: "soft"}, "Increments in each cell between knots; hatched cells were never visited, so nothing here has tried them."));
  for (const table of tables) {
    const axes = table.axes || [];
    const beyond = axes.filter((axis) => axis.below > 0 || axis.above > 0)
        .map((axis) => `${axisName(axis)}: ${[axis.below > 0 ? `${axis.below} below` : "", axis.above > 0 ? `${axis.above} above` : ""].filter(Boolean).join(", ")}`);
    if (table.coarser) block.querySelector("p").textContent += " Of large tables several cells are taken together.";
    const bounds = table.outside > 0 ? `${table.outside} of ${plural(table.increments, "increment")} outside of the table${beyond.length > 0 ? " (" + beyond.join("; ") + ")" : ""}`
                                     : `all ${plural(table.increments, "increment")} inside of the table`;
    if (axes.length === 0) continue;
    if (table.visits && axes.length === 1) block.append(coverageMap(table.table, axes[0], null, [table.visits], bounds));
    else if (table.visits && axes.length === 2) block.append(coverageMap(table.table, axes[0], axes[1], table.visits, bounds));
    else (table.marginals || []).forEach((visits, i) => block.append(coverageMap(`${table.table}, along ${axisName(axes[i])}`, axes[i], null, [visits], bounds)));
  }
  return block;
}

// ------------------------------------------------------------------------------------------- checks

let checkRows = [];

function bar(check) {
  const part = check.worst_fraction;
  const shown = isNumber(part) ? Math.min(part, 1.3) * 75 : check.passed ? 0 : 100;
  const fill = make("i");
  // Anything above 0 stays visible.
  fill.style.width = `${shown > 0 ? Math.max(shown, 1) : 0}%`;
  return make("span", {class: "bar " + (check.passed ? "passed" : "failed"), "aria-hidden": "true", title: "The line is the tolerance"}, fill);
}

function checkSection(one) {
  checkRows = [];
  const body = make("tbody");
  for (const check of [...one.checks].sort((a, b) => Number(a.passed) - Number(b.passed))) {
    const cell = make("td", {colspan: 5});
    const detail = make("tr", {class: "detail", hidden: true}, cell);
    const button = make("button", {type: "button", "aria-expanded": "false", onclick: () => toggleCheck(entry)}, quoted(check.name));
    const entry = {check, button, detail, cell, pictures: null};
    checkRows.push(entry);
    const state = check.passed ? "passed" : "failed";
    body.append(make("tr", {class: "check"},
        make("td", {}, make("span", {class: "mark " + state, title: state}, kStatusMarks[state]), make("span", {class: "hidden"}, state)),
        make("td", {class: "name"}, button),
        make("td", {class: "wide"}, quoted(labelled(check.quantity || "", check.unit))),
        make("td", {class: "wide"}, quoted((check.criterion || "").replace(/_/g, " "))),
        make("td", {class: "number"}, bar(check), make("span", {class: "part"}, fraction(check.worst_fraction)))), detail);
  }
  const failing = failingChecks(one).length;
  return make("section", {id: "checks", "aria-labelledby": "checks-title"}, make("h3", {id: "checks-title"}, failing > 0 ? `Checks: ${failing} of ${one.checks.length} failed` : "Checks"),
      make("table", {class: "checks"}, make("caption", {class: "hidden"}, "Checks with their worst deviation as a part of the tolerance"),
          make("thead", {}, make("tr", {}, make("th", {scope: "col"}, make("span", {class: "hidden"}, "Verdict")), make("th", {scope: "col"}, "Check"),
              make("th", {scope: "col", class: "wide"}, "Quantity"), make("th", {scope: "col", class: "wide"}, "Criterion"), make("th", {scope: "col", class: "number"}, "Worst / tolerance"))),
          body));
}

/** The first failing checks stand open; many at once would only hide each other. */
function openChecks() {
  for (const entry of checkRows.filter((one) => !one.check.passed).slice(0, 3)) toggleCheck(entry);
}

function toggleCheck(entry, open = entry.detail.hidden) {
  entry.detail.hidden = !open;
  entry.button.setAttribute("aria-expanded", String(open));
  if (!open) {
    for (const picture of entry.pictures || []) picture.destroy();
    entry.cell.replaceChildren();
    return;
  }
  fillCheck(entry);
}

function fillCheck(entry) {
  const {check, cell} = entry;
  const worst = worstOf(check);
  const time = timeOf(view.one);
  const parts = [];
  // The cause has a line of its own.
  const message = (check.message || "").replace(check.likely_cause ? "; " + check.likely_cause : "", "");
  if (message) parts.push(make("p", {class: "note bad"}, quoted(message)));
  if (check.likely_cause) parts.push(make("p", {class: "note"}, make("b", {}, "Perhaps: "), quoted(check.likely_cause.replace(/^looks like/, "it looks like"))));
  for (const warning of check.warnings || []) parts.push(make("p", {class: "note"}, make("b", {}, "Note: "), quoted(warning)));
  const said = [`against ${check.against || "its reference"}`];
  if (isNumber(check.tolerance)) said.push(`tolerance ${withUnit(check.tolerance, check.unit, 3)}${check.why ? " (" + check.why + ")" : ""}`);
  if (isNumber(check.compared)) said.push(`${check.failing || 0} of ${plural(check.compared, "point")} beyond it`);
  if (isNumber(check.first_failing) && isNumber(check.last_failing)) said.push(`from t = ${timeText(view.one, check.first_failing)} to ${timeText(view.one, check.last_failing)}` + (time.unit ? "\u00a0" + time.unit : ""));
  if (check.trace && check.trace.thinned) said.push("the curves are thinned but for the points around the worst one");
  parts.push(make("p", {class: "soft"}, quoted(said.join(" \u00b7 "))));
  if (worst && isNumber(worst.value)) {
    const where = isNumber(worst.time) ? `t = ${timeText(view.one, worst.time)}` + (time.unit ? "\u00a0" + time.unit : "") : `${number(worst.abscissa, 5)}`;
    const measure = worstMeasure(check);
    // What a measure is compared with stands elsewhere on the reference, or is no point of it at all.
    const words = measure ? `Worst: ${measure.name} ${withUnit(measure.value, measure.unit, 6)}, wanted is ${withUnit(measure.reference, measure.unit, 6)}; at ${where}`
                          : `Worst: ${withUnit(worst.value, check.unit, 6)}` + (isNumber(worst.reference) ? ` where ${withUnit(worst.reference, check.unit, 6)} is wanted, ` : " ") + `at ${where}`;
    parts.push(make("p", {class: "worst-words"}, quoted(words)));
  }
  entry.pictures = check.trace ? tracePictures(check, worst) : [];
  const zoom = make("button", {type: "button", "aria-pressed": "false", onclick: () => zoomTo(entry, worst, zoom)}, "Zoom in on it");
  const canMove = worst && isNumber(worst.time);
  const canZoom = worst && isNumber(worst.abscissa) && entry.pictures.length > 0;
  if (canMove || canZoom) {
    parts.push(make("div", {class: "detail-tools"},
        canMove ? make("button", {type: "button", class: "go-worst", onclick: () => view.moveToTime(worst.time)}, "Go to the worst point") : null, canZoom ? zoom : null));
  }
  cell.replaceChildren(...parts, ...entry.pictures.map((picture) => picture.element), ...((check.measures || []).length > 0 ? [measureTable(check)] : []));
  pictures.push(...entry.pictures);
  for (const picture of entry.pictures) picture.draw();
}

const rising = (values) => values.every((value, i) => i === 0 || !isNumber(value) || !isNumber(values[i - 1]) || value >= values[i - 1]);

/** Value minus reference at the reference's points, where both go forwards over the same abscissa. */
function deviations(trace) {
  const {value, reference} = trace;
  if (!value || !reference || !rising(value.x) || !rising(reference.x)) return null;
  const x = [];
  const y = [];
  const index = [];
  reference.x.forEach((at, i) => {
    if (!isNumber(at) || !isNumber(reference.y[i]) || at < value.x[0] || at > value.x[value.x.length - 1]) return;
    // Two rows at one abscissa are the two sides of a jump: each is compared with its own.
    const twin = value.x[i] === at ? value.y[i] : between(value.x, value.y, at);
    if (!isNumber(twin)) return;
    x.push(at);
    y.push(twin - reference.y[i]);
    index.push(reference.index ? reference.index[i] : i);
  });
  const extremes = trace.difference_low ? {piece: reference.piece, low: unpack(trace.difference_low), high: unpack(trace.difference_high)} : {};
  return x.length > 1 ? {x, y, index, ...extremes} : null;
}

const largestSize = (values) => values.reduce((largest, value) => Math.max(largest, Math.abs(value)), 0);

/** True if the drawn points resolve the deviation: they have their digits and may be thinned. */
function resolves(check, differences, worst) {
  const size = Math.max(...Object.values(range(check.trace.reference.y) || {low: 0, high: 0}).map(Math.abs));
  const known = worst && isNumber(worst.value) && isNumber(worst.reference) ? Math.abs(worst.value - worst.reference) : null;
  if (!(Math.max(check.trace.tube, known || 0) > 2e-5 * size)) return false;
  return known === null || largestSize(differences.y) <= 1.02 * known + 2e-6 * size;
}

function tracePictures(check, worst) {
  const {trace} = check;
  const overTime = ["t", "time", "T"].includes(trace.abscissa);
  for (const curve of [trace.value, trace.reference].filter(Boolean)) {
    for (const key of ["x", "y", "index", "low", "high"]) if (typeof curve[key] === "string") curve[key] = unpack(curve[key]);
  }
  const lines = [];
  if (trace.reference) lines.push({label: "reference", unit: check.unit, ...trace.reference, colour: 1, dash: [7, 3]});
  if (trace.value) lines.push({label: "value", unit: check.unit, ...trace.value, main: true});
  if (lines.length === 0) return [];
  const forwards = lines.every((line) => rising(line.x));
  const common = {xName: trace.abscissa, xUnit: trace.abscissa_unit, unit: check.unit, last: true, linked: overTime};
  const mark = worst && isNumber(worst.abscissa) && isNumber(worst.value);
  const measure = worstMeasure(check);
  const panels = [{
    ...common, key: "trace", title: overTime ? check.quantity || "Value" : "", kind: overTime ? "history" : "loop", yName: check.quantity || "Value", lines,
    tube: isNumber(trace.tube) && trace.reference ? {...trace.reference, half: trace.tube, sorted: forwards && !check.trace.thinned} : null,
    worst: mark ? {x: worst.abscissa, y: worst.value, reference: measure ? null : worst.reference,
                   text: measure ? `worst: ${measure.name}` : `worst: ${withUnit(worst.value, check.unit)}` + (isNumber(worst.reference) ? ` against ${number(worst.reference)}` : "")} : null
  }];
  if (panels[0].tube) {
    const {low, high} = range(lines.flatMap((line) => [...line.y, ...(line.low || []), ...(line.high || [])])) || {low: 0, high: 0};
    const wanted = range(trace.reference.y) || {low, high};
    const [bottom, top] = [Math.min(low, wanted.low - trace.tube), Math.max(high, wanted.high + trace.tube)];
    if (top > bottom) panels[0].yLimits = [bottom - 0.06 * (top - bottom), top + 0.06 * (top - bottom)];
  }
  const differences = deviations(trace);
  if (differences && isNumber(trace.tube) && resolves(check, differences, worst)) {
    const off = mark && !measure && isNumber(worst.reference) ? worst.value - worst.reference : null;
    const largest = Math.max(trace.tube, largestSize(differences.y), Math.abs(off || 0));
    panels.push({
      ...common, key: "deviation", title: "Value minus reference, and the tolerance", kind: "history", lines: [{label: "deviation", unit: check.unit, ...differences, main: true}],
      linked: overTime, yLimits: largest > 0 ? [-1.15 * largest, 1.15 * largest] : undefined,
      tube: {x: [differences.x[0], differences.x[differences.x.length - 1]], y: [0, 0], half: trace.tube, sorted: true},
      worst: isNumber(off) ? {x: worst.abscissa, y: off, text: `${off > 0 ? "+" : ""}${withUnit(off, check.unit, 3)}`} : null
    });
  }
  return panels.map((panel) => new Picture(panel, panel.key === "trace" ? "trace" : "small"));
}

/**
 * What is zoomed to: a tenth of the abscissa around the worst point, or a tenth of the points, whichever is less; of a
 * curve that is thinned, the points around it of which none is left out.
 */
function zoomHalf(check, whole, at) {
  const x = ((check.trace.value || {}).x || []).filter(isNumber);
  const nearest = x.reduce((best, value, i) => (Math.abs(value - at) < Math.abs(x[best] - at) ? i : best), 0);
  const count = check.trace.thinned ? kNeighbours : Math.max(kNeighbours, Math.round(x.length / 20));
  const near = [x[Math.max(nearest - count, 0)], x[Math.min(nearest + count, x.length - 1)]].map((value) => Math.abs(value - at)).filter((size) => size > 0);
  const half = (whole.high - whole.low) / 20;
  if (near.length === 0) return half;
  return Math.min(half, check.trace.thinned ? Math.min(...near) : Math.max(...near));
}
/** Points on each side of the worst one that no thinning leaves out. */
const kNeighbours = 8;

/** The surroundings of the worst point, or all again. */
function zoomTo(entry, worst, button) {
  const on = button.getAttribute("aria-pressed") !== "true";
  button.setAttribute("aria-pressed", String(on));
  button.textContent = on ? "Show all" : "Zoom in on it";
  for (const picture of entry.pictures) {
    const whole = range(picture.panel.lines.flatMap((line) => line.x));
    const half = zoomHalf(entry.check, whole, worst.abscissa);
    picture.zoomed = null;
    const limits = {x: [worst.abscissa - half, worst.abscissa + half], y: picture.limits("y")};
    if (picture.panel.key === "trace") {
      const near = range(picture.panel.lines.flatMap((line) => line.y.filter((_, i) => Math.abs(line.x[i] - worst.abscissa) <= half)));
      const tube = picture.panel.tube ? picture.panel.tube.half : 0;
      const room = near ? 0.1 * (near.high - near.low) + 1.2 * tube : 0;
      if (near && room > 0) limits.y = [near.low - room, near.high + room];
    }
    zoomPicture(picture, on ? limits : null);
  }
}

function measureTable(check) {
  const several = check.measures.length > 1;
  return inScroll(make("table", {class: "plain"}, make("caption", {}, several ? "Measures" : "Measure"),
      make("thead", {}, make("tr", {}, make("th", {scope: "col"}, ""), make("th", {scope: "col"}, "Measure"), ...["Value", "Reference", "Deviation", "Tolerance"].map((word) => make("th", {scope: "col", class: "number"}, word)))),
      make("tbody", {}, check.measures.map((measure) => {
        const judged = isNumber(measure.tolerance);
        const state = measure.passed ? "passed" : "failed";
        return make("tr", {}, make("td", {}, judged ? make("span", {class: "mark " + state, title: state}, kStatusMarks[state]) : ""),
            make("th", {scope: "row"}, quoted(labelled(measure.name, measure.unit))),
            ...[measure.value, measure.reference, measure.deviation].map((value) => make("td", {class: "number"}, number(value, 5))),
            make("td", {class: "number"}, judged ? number(measure.tolerance, 3) : "only told"));
      }))));
}

let lastWorst = -1;

/** The worst points of the failing checks, one after the other. */
function nextWorst() {
  const entries = checkRows.filter((entry) => !entry.check.passed && isNumber((worstOf(entry.check) || {}).time));
  if (entries.length === 0 || !view) return;
  lastWorst = (lastWorst + 1) % entries.length;
  const entry = entries[lastWorst];
  if (entry.detail.hidden) toggleCheck(entry, true);
  view.moveToTime(worstOf(entry.check).time);
  entry.button.scrollIntoView({block: "nearest"});
}

// -------------------------------------------------------------------------------- the list of cases

const caseRows = new Map();

function fillList() {
  const body = find("verdicts").tBodies[0];
  let folder = "";
  let group = null;
  for (const one of cases) {
    const slash = one.name.lastIndexOf("/") + 1;
    if (one.name.slice(0, slash) !== folder) {
      folder = one.name.slice(0, slash);
      group = make("tr", {class: "group"}, make("th", {scope: "rowgroup", colspan: 4}, folder ? make("bdi", {}, breakable(folder)) : ""));
      body.append(group);
    }
    const checks = one.checks || [];
    const link = make("a", {href: address(one), tabindex: -1}, make("bdi", {}, breakable(one.name.slice(slash))));
    const row = make("tr", {title: one.title || one.name, onclick: (event) => { if (!event.target.closest("a")) link.click(); }},
        make("td", {}, make("span", {class: "mark " + one.status, "aria-hidden": "true"}, kStatusMarks[one.status]), make("span", {class: "hidden"}, kStatusWords[one.status])),
        make("td", {}, link),
        make("td", {class: "number"}, checks.length > 0 ? (isFailure(one) ? `${checks.filter((check) => check.passed).length}/${checks.length}` : String(checks.length)) : ""),
        make("td", {class: "number"}, checks.length > 0 ? fraction(largestFraction(one)) : ""));
    caseRows.set(one.id, {one, row, link, group});
    body.append(row);
  }
}

function tellTotals() {
  const totals = page.totals || {};
  const parts = [];
  const add = (name, count, words) => { if (count > 0) parts.push(make("span", {class: name}, parts.length > 0 ? ", " : "", make("b", {}, String(count)), " " + words)); };
  add("passed", totals.passed, "passed");
  add("failed", totals.failed, "failed");
  add("not_run", totals.not_run, "not run");
  add("no_checks", totals.no_checks, "without checks");
  find("totals").replaceChildren(`${plural(cases.length, "case")}${totals.checks > 0 ? ", " + plural(totals.checks, "check") : ""}: `, ...parts);
}

function visibleCases() { return cases.filter((one) => !caseRows.get(one.id).row.hidden); }

function applyFilter() {
  const wanted = find("filter").value.trim().toLowerCase().split(/\s+/).filter(Boolean);
  const onlyFailures = find("failures").checked;
  for (const {one, row} of caseRows.values()) {
    const text = `${one.name} ${one.title || ""} ${kStatusWords[one.status]}`.toLowerCase();
    row.hidden = !(wanted.every((word) => text.includes(word)) && (!onlyFailures || isFailure(one)));
  }
  const groups = new Set([...caseRows.values()].map(({group}) => group).filter(Boolean));
  for (const group of groups) group.hidden = [...caseRows.values()].every((entry) => entry.group !== group || entry.row.hidden);
  find("none").hidden = visibleCases().length > 0;
  markChosen();
}

/** The case shown is marked, and is the one that Tab reaches in the list. */
function markChosen() {
  let reachable = false;
  for (const {one, row, link} of caseRows.values()) {
    const on = view !== null && one === view.one;
    row.classList.toggle("chosen", on);
    if (on) link.setAttribute("aria-current", "true");
    else link.removeAttribute("aria-current");
    link.tabIndex = on && !row.hidden ? 0 : -1;
    reachable = reachable || link.tabIndex === 0;
  }
  const first = visibleCases()[0];
  if (!reachable && first) caseRows.get(first.id).link.tabIndex = 0;
}

function stepCase(step, focus) {
  const shown = visibleCases();
  if (shown.length === 0) return;
  const at = shown.indexOf(view && view.one);
  const next = shown[at < 0 ? 0 : Math.min(Math.max(at + step, 0), shown.length - 1)];
  if (!view || next !== view.one) go(next);
  const {link, row} = caseRows.get(next.id);
  if (focus) link.focus({preventScroll: true});
  const box = row.closest(".cases");
  const top = row.offsetTop;
  if (top < box.scrollTop + 30) box.scrollTop = top - 40;
  else if (top + row.offsetHeight > box.scrollTop + box.clientHeight) box.scrollTop = top + row.offsetHeight - box.clientHeight;
}

// ------------------------------------------------------------------------------ address of the page

function address(one, instant) {
  const name = encodeURIComponent(one.id).replace(/%2F/g, "/");
  return "#" + name + (instant === undefined ? "" : "@" + instant);
}

/** The instant in words of the address: the time of a row, or the number of an event. */
const instantName = () => (view.event ? "event" + eventNumber(view.one, view.event) : String(view.time()));

/** Case and instant that the page's address names, if any. */
function addressed() {
  let text = location.hash.slice(1);
  try { text = decodeURIComponent(text); } catch { /* kept as it is */ }
  if (byId.has(text)) return {one: byId.get(text)};
  const at = text.lastIndexOf("@");
  const one = at > 0 ? byId.get(text.slice(0, at)) : null;
  if (!one) return null;
  const instant = text.slice(at + 1).trim();
  const event = /^event\d+$/.test(instant) ? (one.events || []).find((other) => "event" + eventNumber(one, other) === instant) : null;
  const t = instant === "" ? NaN : Number(instant);
  return {one, event: event || null, t: isNumber(t) ? t : null};
}

let writeLater = 0;

/** The instant goes to the address when it has come to rest; it makes no entry of its own to go back to. */
function keepAddress() {
  clearTimeout(writeLater);
  writeLater = setTimeout(() => {
    try { history.replaceState(null, "", address(view.one, instantName())); } catch { /* a browser may forbid it for files */ }
  }, 300);
}

function go(one) {
  clearTimeout(writeLater);
  lastWorst = -1;
  show(one);
  const target = address(one);
  // The page is there already when the address changes.
  if (location.hash !== target) location.hash = target;
}

function followAddress() {
  const wanted = addressed();
  if (!wanted) return;
  if (!view || wanted.one !== view.one) show(wanted.one);
  if (wanted.event) view.choose(wanted.event, true);
  else if (isNumber(wanted.t)) view.moveToTime(wanted.t, true);
}

// --------------------------------------------------------------------------------- keys and printing

function isTyping(target) {
  return target.matches("input[type=search], select, textarea, dialog *");
}

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || find("help").open) return;
  const {target, key} = event;
  if (isTyping(target)) {
    if (key === "Escape" && target.id === "filter") {
      target.value = "";
      applyFilter();
      target.blur();
    }
    return;
  }
  const inList = target.closest("#verdicts") !== null;
  const inTabs = target.getAttribute("role") === "tab";
  const slider = target.matches("input[type=range]");
  // Regions that scroll keep their own arrow keys.
  const scrolls = target.matches("pre, .coverage-block, .sideways");
  const step = event.shiftKey && view ? Math.max(1, Math.round(view.times[0].length / 50)) : 1;
  const place = view ? view.places[0] : 0;
  // Behind an event between two rows comes the row that is already the place.
  const betweenRows = view && view.event && view.event.t < view.times[0][place];
  const actions = {
    j: () => stepCase(1, inList), k: () => stepCase(-1, inList),
    n: () => view && toEvent(1), p: () => view && toEvent(-1), w: nextWorst, t: nextTheme,
    f: () => { find("failures").checked = !find("failures").checked; applyFilter(); },
    "/": () => find("filter").focus(), "?": () => find("help").showModal(),
    "+": () => view && zoomWindow(0.5), "=": () => view && zoomWindow(0.5), "-": () => view && zoomWindow(2),
    0: () => view && setWindow(null), ",": () => panWindow(-0.5), ".": () => panWindow(0.5)
  };
  if (inList) Object.assign(actions, {ArrowDown: () => stepCase(1, true), ArrowUp: () => stepCase(-1, true)});
  // A slider without Shift moves by itself.
  if (view && !inTabs && !scrolls && (!slider || event.shiftKey)) {
    Object.assign(actions, {
      ArrowLeft: () => view.moveTo(place - step), ArrowRight: () => view.moveTo(betweenRows && !event.shiftKey ? place : place + step),
      Home: () => view.moveTo(0), End: () => view.moveTo(Infinity)
    });
  }
  const action = actions[key];
  if (!action || (event.shiftKey && key.length === 1 && !"?/+".includes(key))) return;
  event.preventDefault();
  action();
}

// -------------------------------------------------------------------------------------------- start

startPage();
window.addEventListener("hashchange", followAddress);
document.addEventListener("keydown", onKey);
find("filter").addEventListener("input", applyFilter);
find("failures").addEventListener("change", applyFilter);
find("skip").addEventListener("click", (event) => { event.preventDefault(); find("case").focus(); });
find("title").replaceChildren(quoted(page.title || "Report"));
find("title").setAttribute("title", page.generator || "");
tellTotals();
fillList();
followAddress();
if (!view && cases.length > 0) show(cases.find((one) => one.status === "failed") || cases.find(isFailure) || cases[0]);
if (view) stepCase(0, false);
