// SPDX-License-Identifier: Apache-2.0
// The page of a fit: the verdict, the unknowns with their errors, each experiment before and after, what is left,
// tables, and how the optimum was found.
//
// The pictures of one compared quantity share one instant: a drawn point, never made up between points. A picture is
// made of a plain description (a "panel": title, axes, lines, what is behind them). Pictures are drawn when they come
// near the screen. Text of the document only ever becomes text nodes.

const page = JSON.parse(document.getElementById("document").textContent);
const {verdict, figures, unknowns, experiments, tables, searches, profiles} = page;

// ------------------------------------------------------------------------------------- words and numbers

const percent = (part, digits = 2) => (isNumber(part) ? number(100 * part, digits) + "\u00a0%" : "\u2013");
const confidence = percent(figures.confidence, 4);

/** A value with the digits that its error leaves meaningful: down to the second one of the error. */
function measured(value, error) {
  if (!isNumber(value) || !(error > 0)) return number(value, 6);
  const decimals = 1 - Math.floor(Math.log10(error));
  if (decimals > 8 || Math.abs(value) >= 1e7) return number(value, Math.min(12, Math.max(3, Math.ceil(Math.log10(Math.abs(value) / error)) + 2)));
  const unit = 10 ** Math.max(0, -decimals);
  return (Math.round(value / unit * 10 ** Math.max(0, decimals)) === 0 ? 0 : decimals > 0 ? value : Math.round(value / unit) * unit).toFixed(Math.max(0, decimals)).replace("-", "\u2212");
}
/** A correlation: two decimals, and no sign before a zero. */
const twoDecimals = (value) => (Math.round(100 * value) === 0 ? "0.00" : value.toFixed(2).replace("-", "\u2212"));

/** Why a search ended, without the verdict that stands beside it. */
function reason(sentence) {
  const rest = sentence.replace(/^(not )?converged: /, "");
  return rest.charAt(0).toUpperCase() + rest.slice(1) + (/[.!?]$/.test(rest) ? "" : ".");
}

/** What an unknown is called: an ordinate by its knots. */
const calledOf = (unknown) => unknown.told || unknown.name;
/** That with its unit. */
const nameOf = (unknown) => make("bdi", {title: unknown.told ? unknown.name : false}, breakable(labelled(calledOf(unknown), unknown.unit)));

const isNever = (one) => one.seen === "never_visited";
const kSeen = {good: "well seen", weak: "weakly seen", never_visited: "never visited"};
const head = (words) => make("thead", {}, make("tr", {}, words.map(([word, numeric, title]) => make("th", {scope: "col", class: numeric ? "number" : "", title: title || false}, word))));

/** A part of the page with its heading; an entry of the contents is made of it. */
function part(id, title, ...children) {
  return make("section", {id, "aria-labelledby": id + "-title"}, make("h3", {id: id + "-title"}, title), ...children);
}

// ---------------------------------------------------------------------------------------------- pictures

/** Pictures that are not drawn yet are drawn when they come near the screen. */
const nearScreen = new IntersectionObserver((entries) => {
  for (const entry of entries) if (entry.isIntersecting) drawn.get(entry.target).draw();
}, {rootMargin: "500px 0px"});
const drawn = new Map();

/** The shapes of points in a legend, about the place x of a box of 30 by 10. */
const kShapes = {
  circle: (x) => `M${x - 3} 5a3 3 0 1 0 6 0a3 3 0 1 0 -6 0Z`, rect: (x) => `M${x - 3} 2h6v6h-6Z`,
  triangle: (x) => `M${x - 4} 8h8l-4 -7Z`, rectRot: (x) => `M${x - 4} 5l4 -4l4 4l-4 4Z`
};

/** A panel as a Chart.js chart with a layer of marks and a legend that tells values. */
class Drawing {
  constructor(panel, size) {
    this.panel = panel;
    this.canvas = make("canvas", {role: "img", "aria-label": panel.words || `${panel.title}: ${panel.lines.map((line) => line.label).join(", ")} over ${panel.xName}`});
    this.layer = makeSvg("svg", {"aria-hidden": "true"});
    this.plot = make("div", {class: "plot " + size}, this.canvas, this.layer);
    this.legend = make("ul", {class: "legend"});
    this.element = make("figure", {class: "panel", "data-panel": panel.key},
                        make("div", {class: "panel-head"}, make("h4", {}, quoted(labelled(panel.title, panel.unit))), this.legend), this.plot,
                        panel.caption ? make("figcaption", {}, quoted(panel.caption)) : null);
    this.values = panel.lines.map((line, i) => this.legendEntry(line, i));
    drawn.set(this.element, this);
    pictures.push(this);
    nearScreen.observe(this.element);
  }

  legendEntry(line, i) {
    if (line.silent) return null;
    const swatch = makeSvg("svg", {viewBox: "0 0 30 10", "aria-hidden": "true"});
    line.swatch = [];
    const add = (tag, attributes) => { const mark = makeSvg(tag, attributes); swatch.append(mark); line.swatch.push(mark); };
    if (!line.pointsOnly) add("line", {x1: 0, x2: 30, y1: 5, y2: 5, "stroke-width": line.width || 2, "stroke-dasharray": (line.dash || []).join(" ")});
    if (line.point) for (const x of line.pointsOnly && line.x.length > 1 ? [5, 15, 25] : [15]) add("path", {d: kShapes[line.point](x)});
    this.tint(line);
    const value = make("span", {class: "value"});
    const button = make("button", {type: "button", "aria-pressed": String(!line.off), title: "Show or hide", onclick: () => this.toggle(i, button)}, swatch, quoted(line.label), value);
    if (!this.panel.view || line.told === false) value.remove();
    this.legend.append(make("li", {}, button));
    return value;
  }

  tint(line) {
    for (const mark of line.swatch || []) {
      mark.setAttribute("stroke", colourOf(line));
      if (mark.tagName === "path") mark.setAttribute("fill", colourOf(line));
    }
  }

  draw() {
    if (this.chart) return;
    nearScreen.unobserve(this.element);
    const {panel} = this;
    this.chart = new Chart(this.canvas, {
      type: "line",
      data: {datasets: panel.lines.map((line) => this.dataset(line))},
      options: {
        animation: false, responsive: true, maintainAspectRatio: false, events: [], normalized: false,
        devicePixelRatio: printing ? 2 : window.devicePixelRatio,
        layout: {padding: {top: kTop, right: kRight, left: 0, bottom: 0}},
        elements: {point: {radius: 0, hoverRadius: 0}, line: {tension: 0, borderJoinStyle: "round"}},
        plugins: {legend: {display: false}, tooltip: {enabled: false}, filler: false},
        scales: {
          x: this.axis("x", {title: labelled(panel.xName, panel.xUnit), limits: panel.xLimits || this.span("x", panel.view && !panel.loop ? 0 : 0.04)}),
          y: this.axis("y", {limits: panel.yLimits || this.span("y", 0.06), upright: true})
        }
      },
      plugins: [{
        id: "house",
        beforeDatasetsDraw: (chart) => this.behind(chart),
        afterDraw: (chart) => { this.chart = chart; this.placeMarks(); }
      }]
    });
    if (panel.view) for (const event of ["pointermove", "pointerdown"]) this.plot.addEventListener(event, (what) => this.pointed(what));
  }

  axis(key, what) {
    const options = axisOptions(what);
    const text = this.panel[key + "Tick"];
    if (text) options.ticks.callback = text;
    if (this.panel.ticks && this.panel.ticks[key]) options.afterBuildTicks = (scale) => { scale.ticks = this.panel.ticks[key](scale).map((value) => ({value})); };
    return options;
  }

  dataset(line) {
    const radius = line.point ? line.radius || 3 : line.x.length < 2 ? 3 : 0;
    return {
      data: line.x.map((x, i) => ({x, y: line.y[i]})),
      showLine: !line.pointsOnly, hidden: line.off || false, borderColor: colourOf(line), borderDash: line.dash || [], borderWidth: line.width || 1.7,
      pointRadius: radius, pointBorderWidth: 1.4, pointStyle: line.point || "circle",
      pointBorderColor: colourOf(line), pointBackgroundColor: this.pointFill(line), spanGaps: false
    };
  }

  pointFill(line) { return line.x.map((_, i) => (line.hollow === true || (line.hollow && line.hollow[i]) ? colours.back : colourOf(line))); }

  /** From the smallest to the largest value shown, and a part of that as air. */
  span(key, air) {
    const shown = this.panel.lines.filter((line) => !line.off || key === "x");
    const edges = key === "y" ? shown.flatMap((line) => [...(line.low || []), ...(line.high || [])]) : [];
    const {low, high} = range([...shown.flatMap((line) => line[key]), ...edges]) || {low: -1, high: 1};
    const size = Math.max(Math.abs(low), Math.abs(high));
    if (high - low <= 1e-9 * size || size === 0) return [low - (0.05 * size || 1), high + (0.05 * size || 1)];
    return [low - air * (high - low), high + air * (high - low)];
  }

  /** Behind the curves: zero, bands, whiskers, and what the panel has of its own. */
  behind(chart) {
    const {ctx: pen, chartArea: area, scales} = chart;
    pen.save();
    pen.beginPath();
    pen.rect(area.left, area.top, area.right - area.left, area.bottom - area.top);
    pen.clip();
    const at = (x, y) => [scales.x.getPixelForValue(x), scales.y.getPixelForValue(y)];
    const [, zero] = at(0, 0);
    if (zero > area.top && zero < area.bottom) {
      pen.strokeStyle = colours.soft;
      pen.globalAlpha = 0.5;
      pen.beginPath();
      pen.moveTo(area.left, zero);
      pen.lineTo(area.right, zero);
      pen.stroke();
      pen.globalAlpha = 1;
    }
    if (this.panel.behind) this.panel.behind(pen, at, area);
    this.panel.lines.forEach((line) => { if (line.low && !line.off) (line.whiskers ? this.whiskers : this.band)(pen, at, line); });
    pen.restore();
  }

  band(pen, at, line) {
    const edge = (values, backwards) => {
      for (let i = 0; i < line.x.length; ++i) {
        const k = backwards ? line.x.length - 1 - i : i;
        if (isNumber(values[k])) pen.lineTo(...at(line.x[k], values[k]));
      }
    };
    pen.fillStyle = colours.tube;
    pen.beginPath();
    edge(line.high, false);
    edge(line.low, true);
    pen.fill();
    pen.strokeStyle = colourOf(line);
    pen.lineWidth = 0.8;
    for (const values of [line.high, line.low]) {
      pen.beginPath();
      edge(values, false);
      pen.stroke();
    }
  }

  whiskers(pen, at, line) {
    pen.strokeStyle = colourOf(line);
    pen.lineWidth = 1.2;
    line.x.forEach((x, i) => {
      if (!isNumber(line.low[i]) || !isNumber(line.high[i])) return;
      const [left, low] = at(x, line.low[i]);
      const [, high] = at(x, line.high[i]);
      pen.beginPath();
      pen.moveTo(left, low);
      pen.lineTo(left, high);
      for (const end of [low, high]) {
        pen.moveTo(left - 4, end);
        pen.lineTo(left + 4, end);
      }
      pen.stroke();
    });
  }

  toggle(i, button) {
    const line = this.panel.lines[i];
    line.off = !line.off;
    button.setAttribute("aria-pressed", String(!line.off));
    this.draw();
    this.chart.setDatasetVisibility(i, !line.off);
    if (!this.panel.yLimits) [this.chart.options.scales.y.min, this.chart.options.scales.y.max] = this.span("y", 0.06);
    this.chart.update("none");
  }

  recolour() {
    this.panel.lines.forEach((line) => this.tint(line));
    if (!this.chart) return;
    this.panel.lines.forEach((line, i) => {
      const dataset = this.chart.data.datasets[i];
      dataset.borderColor = dataset.pointBorderColor = colourOf(line);
      dataset.pointBackgroundColor = this.pointFill(line);
    });
    recolourAxes(this.chart);
  }

  /** Marks of the instant; kept apart from the curves, so that moving is cheap. */
  placeMarks() {
    const {view, lines, loop} = this.panel;
    if (!view || !this.chart) return;
    const {chartArea: area, scales} = this.chart;
    const parts = [];
    if (!loop) {
      const x = scales.x.getPixelForValue(lines[0].x[view.at]);
      parts.push(makeSvg("line", {x1: x, x2: x, y1: area.top, y2: area.bottom, class: "cursor-line"}));
    }
    lines.forEach((line, i) => {
      if (line.told === false) return;
      const [x, y] = [line.x[view.at], line.y[view.at]];
      if (this.values[i]) this.values[i].textContent = withUnit(y, line.unit, 5);
      if (!isNumber(x) || !isNumber(y) || line.off) return;
      parts.push(makeSvg("circle", {cx: scales.x.getPixelForValue(x), cy: scales.y.getPixelForValue(y), r: 5, fill: colourOf(line), class: "cursor-dot"}));
    });
    this.layer.replaceChildren(...parts);
  }

  /** The drawn point that is nearest to the pointer. */
  pointed(event) {
    const {view, lines, loop} = this.panel;
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const {scales, chartArea: area} = this.chart;
    if (x < area.left - 8 || x > area.right + 8 || y < area.top - 8 || y > area.bottom + 8) return;
    let best = 0;
    let least = Infinity;
    for (const line of loop ? lines : lines.slice(0, 1)) {
      for (let i = 0; i < line.x.length; ++i) {
        // A loop passes the same place often: of equally near points that nearest in history is meant.
        const far = (scales.x.getPixelForValue(line.x[i]) - x) ** 2 + (loop ? (scales.y.getPixelForValue(line.y[i]) - y) ** 2 + 40 * Math.abs(i - view.at) / line.x.length : 0);
        if (far < least) {
          least = far;
          best = i;
        }
      }
    }
    view.moveTo(best);
  }
}

// ----------------------------------------------------------------------------------------------- verdict

function header() {
  const good = verdict.converged;
  const block = make("header", {id: "verdict"},
      make("p", {class: "case-name"}, quoted(page.file)),
      make("h2", {}, quoted(page.title)),
      make("p", {class: "facts"}, make("span", {class: "badge " + (good ? "passed" : "failed")}, good ? "\u2713 converged" : "\u2717 not converged"),
          make("span", {class: "soft"}, `${plural(verdict.iterations, "iteration")}${verdict.polished ? ", polished without derivatives" : ""}`)));
  block.append(make("p", {class: good ? "sentence" : "sentence note bad"}, quoted(reason(verdict.sentence))));
  const looked = [...new Set(page.notes)];
  if (looked.length > 0) {
    block.append(make("ul", {class: "notes", "aria-label": "What to look at"}, looked.map((line) => make("li", {class: "note"}, make("b", {}, "Look at: "), quoted(line)))));
  }
  const fitted = experiments.filter((one) => !one.held_out);
  const facts = [
    ["Cost", `${number(verdict.start_cost)} \u2192 ${number(verdict.cost)}`],
    ["Residual standard deviation", number(figures.deviation)],
    ["Points, free unknowns", `${figures.data}, ${figures.free}${figures.free < figures.unknowns ? ` of ${figures.unknowns}` : ""}`],
    ["Experiments", `${fitted.length} fitted` + (fitted.length < experiments.length ? `, ${experiments.length - fitted.length} held out` : "")],
    ["Loss", figures.loss]
  ];
  block.append(make("dl", {class: "key-figures"}, facts.map(([name, text]) => make("div", {}, make("dt", {}, name), make("dd", {}, text)))));
  return block;
}

// ---------------------------------------------------------------------------------------------- unknowns

function unknownsPart() {
  const sampled = figures.bootstrap > 0;
  const doubtful = unknowns.filter((one) => one.seen !== "good").length;
  const rows = unknowns.map((one) => make("tr", {},
      make("th", {scope: "row"}, nameOf(one)),
      make("td", {class: "number"}, number(one.start)),
      make("td", {class: "number"}, make("b", {}, one.frozen ? number(one.value) : measured(one.value, one.error))),
      make("td", {class: "number"}, number(one.error, 2)),
      make("td", {class: "number"}, isNumber(one.low) ? `${measured(one.low, one.error)} \u2026 ${measured(one.high, one.error)}` : "\u2013"),
      sampled ? make("td", {class: "number"}, isNumber(one.bootstrap_low) ? `${measured(one.bootstrap_low, one.bootstrap_error)} \u2026 ${measured(one.bootstrap_high, one.bootstrap_error)}` : "\u2013") : null,
      make("td", {class: "number"}, String(one.visits)),
      make("td", {class: "reason"}, seenWords(one))));
  const columns = [["Unknown"], ["Start", true], ["Value", true], ["Standard error", true], [confidence + " interval", true]];
  if (sampled) columns.push(["Resampled interval", true, `Bootstrap, ${figures.bootstrap} of ${figures.bootstrap_wanted} fits converged`]);
  columns.push(["Points", true, "Compared points that depend on it"], ["Seen by the data"]);
  return part("unknowns", "Unknowns",
      make("p", {class: "soft"}, doubtful > 0 ? `${doubtful} of ${plural(unknowns.length, "unknown")} ${doubtful === 1 ? "is" : "are"} not told by the data alone; the reasons stand in the last column.`
                                              : "The data tell all of them."),
      inScroll(make("table", {class: "plain", id: "unknown-table"}, make("caption", {class: "hidden"}, "Unknowns with their errors"), head(columns), make("tbody", {}, rows))),
      intervals());
}

function seenWords(one) {
  const words = [];
  if (one.at_lower || one.at_upper) words.push(`at its ${one.at_lower ? "lower" : "upper"} bound`);
  if (one.held_by) words.push(`held by ${one.held_by}`);
  if (one.why) words.push(one.why);
  return [make("span", {class: "badge " + {good: "passed", weak: "doubt", never_visited: "failed"}[one.seen]}, kSeen[one.seen]), quoted(words.join("; "))];
}

/** The places of an unknown's picture, in percent of its width: from bound to bound where there are two. */
function trackOf(one) {
  const logarithmic = one.scale === "log" && [one.start, one.value].every((value) => value > 0);
  const to = (value) => (logarithmic ? Math.log(value) : value);
  const usable = (value) => isNumber(value) && (!logarithmic || value > 0);
  const shown = range([one.start, one.value, one.low, one.high].filter(usable).map(to)) || {low: 0, high: 1};
  const room = 0.25 * (shown.high - shown.low) || 0.5 * Math.abs(shown.high) || 1;
  const bounded = [usable(one.lower), usable(one.upper)];
  const low = bounded[0] ? to(one.lower) : shown.low - room;
  const high = bounded[1] ? to(one.upper) : shown.high + room;
  const place = (value) => 2 + 96 * Math.min(1, Math.max(0, ((logarithmic && !(value > 0) ? low : to(value)) - low) / (high - low || 1)));
  return {place, bounded, logarithmic, beyond: (value) => isNumber(value) && place(value) !== 2 + 96 * ((to(value) - low) / (high - low || 1))};
}

function diamond(at) {
  const group = makeSvg("svg", {x: at + "%", y: "50%", width: 1, height: 1, overflow: "visible"});
  group.append(makeSvg("path", {d: "M0 -5L5 0L0 5L-5 0Z", class: "start"}));
  return group;
}

/** Bounds are told once below unknowns that share them. */
const sameTrack = (a, b) => a && b && ["lower", "upper", "scale", "unit"].every((key) => a[key] === b[key]) && isNumber(a.lower) && isNumber(a.upper);

function interval(one, next) {
  const {place, bounded, logarithmic} = trackOf(one);
  const svg = makeSvg("svg", {role: "img", "aria-label": `${calledOf(one)}: ${number(one.value)}` + (isNumber(one.low) ? `, from ${number(one.low)} to ${number(one.high)}` : ", no interval")});
  const line = (x1, x2, y1, y2, name) => svg.append(makeSvg("line", {x1: x1 + "%", x2: x2 + "%", y1: y1 + "%", y2: y2 + "%", class: name}));
  if (one.seen === "never_visited") svg.append(makeSvg("rect", {x: "2%", width: "96%", y: "32%", height: "36%", class: "never-seen"}));
  line(2, 98, 50, 50, "rail");
  bounded.forEach((is, end) => { if (is) line(end ? 98 : 2, end ? 98 : 2, 25, 75, "bound"); });
  if (isNumber(one.low) && isNumber(one.high)) {
    line(place(one.low), place(one.high), 50, 50, "whisker");
    for (const end of [one.low, one.high]) line(place(end), place(end), 33, 67, "cap");
  }
  if (isNumber(one.bootstrap_low) && isNumber(one.bootstrap_high)) line(place(one.bootstrap_low), place(one.bootstrap_high), 82, 82, "resampled");
  svg.append(diamond(place(one.start)));
  if (!one.frozen || one.value !== one.start) svg.append(makeSvg("circle", {cx: place(one.value) + "%", cy: "50%", r: 5, class: "dot"}));
  const end = (value, is, words) => make("span", {}, is ? number(value) : words);
  return make("div", {class: "unknown"}, make("div", {class: "name"}, nameOf(one)),
      make("div", {class: "track"}, svg, sameTrack(one, next) ? null : make("div", {class: "ends"}, end(one.lower, bounded[0], "\u2190 no bound"), logarithmic ? make("span", {}, "logarithmic") : null, end(one.upper, bounded[1], "no bound \u2192"))));
}

/** A line of symbols with their words. */
function symbol(draw, words) {
  const svg = makeSvg("svg", {viewBox: "0 0 34 16", class: "track", "aria-hidden": "true"});
  draw((tag, attributes) => svg.append(makeSvg(tag, attributes)));
  return make("span", {class: "track"}, svg, words);
}

function intervals() {
  const some = (test) => unknowns.some(test);
  return make("figure", {"data-panel": "intervals"},
      make("div", {class: "intervals"}, unknowns.map((one, i) => interval(one, unknowns[i + 1]))),
      make("figcaption", {class: "symbols"},
          symbol((add) => add("circle", {cx: 17, cy: 8, r: 5, class: "dot"}), "value"),
          symbol((add) => { add("line", {x1: 2, x2: 32, y1: 8, y2: 8, class: "whisker"}); for (const x of [2, 32]) add("line", {x1: x, x2: x, y1: 3, y2: 13, class: "cap"}); }, confidence + " interval, where it is wider than its dot"),
          some((one) => isNumber(one.bootstrap_low)) ? symbol((add) => add("line", {x1: 0, x2: 34, y1: 8, y2: 8, class: "resampled"}), "resampled") : null,
          symbol((add) => add("path", {d: "M17 3L22 8L17 13L12 8Z", class: "start"}), "start"),
          symbol((add) => { add("line", {x1: 3, x2: 31, y1: 8, y2: 8, class: "rail"}); for (const x of [3, 31]) add("line", {x1: x, x2: x, y1: 2, y2: 14, class: "bound"}); }, "bounds"),
          some(isNever) ? make("span", {}, make("i", {class: "state-box open"}), "never visited: no compared point depends on it") : null));
}

/** The hatching of what was never visited, for all SVG of the page. */
function patterns() {
  const svg = makeSvg("svg", {width: 0, height: 0, "aria-hidden": "true", style: "position: absolute"});
  const pattern = makeSvg("pattern", {id: "never-pattern", width: 6, height: 6, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)"});
  pattern.append(makeSvg("line", {x1: 0, x2: 0, y1: 0, y2: 6, style: "stroke: var(--open-line); stroke-width: 4"}));
  svg.append(pattern);
  return svg;
}

// ------------------------------------------------------------------------------------------- experiments

const experimentId = (i) => `experiment-${i + 1}`;

function errorsPart() {
  const rows = experiments.flatMap((one, i) => one.responses.map((response, r) => {
    const largest = Math.max(response.rmse_before, response.rmse_after) || 1;
    const bar = (value, name) => make("i", {class: name, style: `width: ${Math.max(1, 100 * value / largest).toFixed(1)}%`});
    return make("tr", {},
        make("th", {scope: "row"}, r === 0 ? make("a", {href: "#" + experimentId(i)}, make("bdi", {}, breakable(one.name))) : quoted(one.name), one.held_out ? make("span", {}, " ", make("span", {class: "badge held"}, "held out")) : ""),
        make("td", {class: "name"}, make("bdi", {}, breakable(labelled(response.quantity, response.unit)))),
        make("td", {class: "number"}, String(response.points)),
        make("td", {class: "number"}, number(response.rmse_before)),
        make("td", {class: "number"}, make("b", {}, number(response.rmse_after))),
        make("td", {class: "number"}, number(response.robust)),
        make("td", {class: "number"}, response.range > 0 ? percent(response.rmse_after / response.range) : "\u2013"),
        make("td", {}, make("span", {class: "pair", "aria-hidden": "true"}, bar(response.rmse_before, "before"), bar(response.rmse_after, "after"))),
        make("td", {class: "number"}, number(response.mean_error, 2)),
        make("td", {class: "number"}, number(response.autocorrelation, 2)),
        make("td", {class: "number"}, one.held_out || r > 0 ? "" : percent(one.share)));
  }));
  return part("errors", "Before and after",
      make("p", {class: "soft"}, "Root mean square of model minus measurement, at the start values and at the optimum" + (experiments.some((one) => one.held_out) ? ". Held out experiments were scored, never fitted: they tell whether the fit holds elsewhere." : ".")),
      inScroll(make("table", {class: "plain", id: "error-table"}, make("caption", {class: "hidden"}, "Errors before and after"),
          head([["Experiment"], ["Quantity"], ["Points", true], ["RMSE before", true], ["RMSE after", true], ["robust", true, "1.4826 times the median distance from the median: the standard deviation of noise, whatever outliers there are"], ["of the range", true, "RMSE after, as a part of the measured range"], ["Before over after"],
                ["Mean error", true, "Of model minus measurement"], ["Next-point correlation", true, "Near 0 is noise, near 1 a trend"], ["Part of the cost", true]]),
          make("tbody", {}, rows))));
}

/** The instant of the pictures of one compared quantity. */
class View {
  constructor(experiment, response) {
    Object.assign(this, {experiment, response, at: Math.floor(response.time.length / 2), pictures: []});
    this.output = make("output", {"aria-live": "off"});
    this.slider = make("input", {type: "range", min: 0, max: Math.max(response.time.length - 1, 0), step: 1, "aria-label": `Instant of ${response.quantity}`, oninput: () => this.moveTo(Number(this.slider.value))});
    this.element = make("div", {class: "fit-instant", role: "group", "aria-label": "Instant shown in these pictures"}, this.output, this.slider);
  }

  moveTo(at) {
    this.at = at;
    const t = `t = ${withUnit(this.response.time[at], this.experiment.time_unit, 6)}`;
    this.output.textContent = t;
    this.slider.value = String(at);
    this.slider.setAttribute("aria-valuetext", t);
    for (const picture of this.pictures) picture.placeMarks();
  }
}

function experimentPart(one, i) {
  const said = [`${one.rows_used} of ${plural(one.rows_read, "row")} of the data compared`];
  if (!one.held_out && experiments.length > 1) said.push(`${percent(one.share)} of the cost`);
  if (one.weight !== 1) said.push(`weight ${number(one.weight)}`);
  const block = part(experimentId(i), [quoted(one.name), one.held_out ? " " : "", one.held_out ? make("span", {class: "badge held"}, "held out: scored, never fitted") : ""],
      make("p", {class: "soft"}, quoted(said.join(" \u00b7 "))));
  if (one.cleaning.length > 0) block.append(make("ul", {class: "summary"}, one.cleaning.map((line) => make("li", {}, quoted(line)))));
  one.responses.forEach((response) => block.append(responseBlock(one, response, one.responses.length > 1)));
  return block;
}

const kMeasured = {label: "measured", colour: 2, pointsOnly: true, point: "circle", radius: 1.8};
const kBefore = {label: "before", colour: "soft", dash: [5, 3], width: 1.2};
const kAfter = {label: "after", width: 2.2};

/** A loop would be torn where points are left out: its lines are those of the points drawn. */
function responseBlock(one, response, several) {
  const view = new View(one, response);
  const {unit, left} = response;
  const common = {unit, view, yName: response.quantity};
  const curves = (x, more) => [{...kAfter, x, y: response.after, unit, ...more}, {...kMeasured, x, y: response.measured, unit, ...more}, {...kBefore, x, y: response.before, unit, ...more}];
  const residual = (values) => values.map((value, i) => (isNumber(value) && isNumber(response.measured[i]) ? value - response.measured[i] : null));
  const time = {xName: "t", xUnit: one.time_unit};
  const panels = [];
  const loop = response.position ? new Drawing({...common, key: "loop", title: `${response.quantity} over ${response.position}`, loop: true, xName: response.position, xUnit: response.position_unit, lines: curves(response.positions)}, "loop") : null;
  panels.push(new Drawing({...common, key: "history", title: `${response.quantity} over time`, ...time, lines: curves(response.time)}, "trace"));
  const after = residual(response.after);
  const strays = left.outliers.length === 0 ? [] : [{label: plural(left.outliers.length, "outlier"), colour: "limit", pointsOnly: true, point: "circle", radius: 5, hollow: true, told: false,
                                                     x: left.outliers.map((one) => one.time), y: left.outliers.map((one) => one.residual)}];
  panels.push(new Drawing({...common, key: "residuals", title: "Model minus measurement", ...time,
                           lines: [{label: "after", x: response.time, y: after, unit, width: 1.4}, {label: "before", colour: "soft", dash: [5, 3], width: 1, x: response.time, y: residual(response.before), unit, off: true}, ...strays]}, "history"));
  view.pictures = [loop, ...panels].filter(Boolean);
  const block = make("div", {class: "response"}, several ? make("h4", {}, quoted(labelled(response.quantity, unit))) : null,
      make("p", {class: left.trend ? "note words" : "words soft"}, left.trend ? make("b", {}, "What is left: ") : "What is left: ", quoted(left.words)),
      response.thinned ? make("p", {class: "soft thinned"}, `Drawn are ${response.time.length} of ${response.points} points: the first and the last, the extremes, and of the rest the smallest and largest of each stretch. Histogram, correlation and all numbers are those of all points.`) : null,
      view.element,
      make("div", {class: "pictures" + (loop ? "" : " histories-only")}, loop ? make("div", {class: "column"}, loop.element) : null, make("div", {class: "column"}, panels.map((picture) => picture.element))),
      make("div", {class: "small-pictures"}, [histogram(left, unit), correlogram(left)].filter(Boolean).map((picture) => picture.element)));
  view.moveTo(view.at);
  return block;
}

function histogram(left, unit) {
  const {counts, lowest, highest, mean, deviation} = left;
  if (counts.length === 0) return null;
  const total = counts.reduce((sum, count) => sum + count, 0);
  const width = (highest - lowest) / counts.length;
  const bell = {label: "of noise with this deviation", colour: 2, dash: [6, 3], x: [], y: []};
  for (let i = 0; i <= 120 && deviation > 0; ++i) {
    const x = lowest - 0.05 * (highest - lowest) + 1.1 * (highest - lowest) * i / 120;
    bell.x.push(x);
    bell.y.push(total * width * Math.exp(-0.5 * ((x - mean) / deviation) ** 2) / (deviation * Math.sqrt(2 * Math.PI)));
  }
  const top = Math.max(...counts, ...bell.y);
  return new Drawing({
    key: "histogram", title: "How often, points", unit: "", xName: "model minus measurement", xUnit: unit, lines: [bell], words: `Histogram of ${total} residuals`,
    xLimits: [lowest - 0.05 * (highest - lowest), highest + 0.05 * (highest - lowest)], yLimits: [0, 1.08 * top],
    behind: (pen, at) => counts.forEach((count, i) => {
      const [x0, y0] = at(lowest + i * width, count);
      const [x1, y1] = at(lowest + (i + 1) * width, 0);
      pen.fillStyle = colours.tube;
      pen.strokeStyle = colours[1];
      pen.lineWidth = 1;
      pen.fillRect(x0, y0, x1 - x0, y1 - y0);
      if (count > 0) pen.strokeRect(x0, y0, x1 - x0, y1 - y0);
    })
  }, "curve");
}

function correlogram(left) {
  const {lags, noise_band: band} = left;
  if (lags.length === 0) return null;
  const x = lags.map((_, i) => i + 1);
  return new Drawing({
    key: "correlation", title: "Are neighbours alike? Correlation of residuals", unit: "", xName: "points apart", xUnit: "",
    lines: [{label: "correlation", pointsOnly: true, point: "circle", radius: 2.6, x, y: lags}], xLimits: [0, lags.length + 1], yLimits: [Math.min(-0.4, ...lags) - 0.05, 1.05],
    caption: `Of noise 95 of 100 lie in the shaded band, within \u00b1${number(band, 2)}.`,
    behind: (pen, at, area) => {
      const [, top] = at(0, band);
      const [, bottom] = at(0, -band);
      pen.fillStyle = colours.tube;
      pen.fillRect(area.left, top, area.right - area.left, bottom - top);
      pen.strokeStyle = colours.text;
      pen.lineWidth = 1.3;
      lags.forEach((value, i) => {
        pen.beginPath();
        pen.moveTo(...at(i + 1, 0));
        pen.lineTo(...at(i + 1, value));
        pen.stroke();
      });
    }
  }, "curve");
}

// ------------------------------------------------------------------------------------------------ tables

const kMostBlocks = 6;
const kMostNamed = 12;
const kBlockDashes = [[], [7, 3], [2, 2], [8, 3, 2, 3], [12, 4], [4, 2]];
const kBlockPoints = ["circle", "rect", "triangle", "rectRot", "circle", "rect"];

function tablePart(table, t) {
  const own = unknowns.slice(table.first, table.first + table.count);
  const block = part(`table-${t + 1}`, ["Table ", quoted(table.name)]);
  const never = table.cells.filter((cell) => !cell.visited);
  if (never.length > 0) {
    const named = never.slice(0, kMostNamed).map((cell) => cell.text).join("; ");
    block.append(make("p", {class: "note words never-named"}, make("b", {}, `${never.length} of ${plural(table.cells.length, "cell")} never visited: `), quoted(named + (never.length > kMostNamed ? `; and ${never.length - kMostNamed} more` : ""))));
  }
  const [axis] = table.axes;
  const {even} = table;
  const lines = blockLines(table, own);
  const alone = table.blocks.length === 1;
  if (lines.length > 0) {
    block.append(new Drawing({
      key: "table", title: table.free, unit: table.unit, xName: axis.name, xUnit: axis.unit, lines,
      caption: (alone ? `The shade is the ${confidence} interval` : `Whiskers are ${confidence} intervals`) + ", dashed light lines the start" +
          (own.some(isNever) ? ", hollow points what was never visited." : ".") + (even ? " Knots are drawn equally far apart." : "") + (table.blocks.length > kMostBlocks ? ` Of ${table.blocks.length} curves ${kMostBlocks} are drawn.` : ""),
      behind: alone && table.cell_grid ? (pen, at, area) => unseen(pen, at, area, even ? axis.knots.map((_, i) => i) : axis.knots, table) : null,
      xTick: even ? (at) => number(axis.knots[at]) : null, ticks: even ? {x: () => axis.knots.map((_, i) => i)} : null
    }, "trace").element);
  }
  block.append(ordinates(table, own));
  if (table.cell_grid && table.axes.length <= 2) block.append(visits(table));
  return block;
}

/** The cells of one axis that were never visited, hatched. */
function unseen(pen, at, area, knots, table) {
  pen.fillStyle = pen.createPattern(colours.hatch, "repeat");
  pen.globalAlpha = 0.55;
  table.cells.forEach((cell, i) => {
    if (cell.visited) return;
    const [left] = at(knots[i], 0);
    const [right] = at(knots[i + 1], 0);
    pen.fillRect(left, area.top, right - left, area.bottom - area.top);
  });
  pen.globalAlpha = 1;
}

function blockLines(table, own) {
  const lines = [];
  const step = Math.max(1, Math.ceil(table.blocks.length / kMostBlocks));
  table.blocks.filter((_, i) => i % step === 0).forEach((block, i) => {
    const of = own.slice(block.first, block.first + block.x.length);
    const alone = table.blocks.length === 1;
    lines.push({label: alone ? "after" : block.label, colour: alone ? null : (i % 6) + 1, dash: alone ? [] : kBlockDashes[i % kBlockDashes.length], width: 2, point: kBlockPoints[i % kBlockPoints.length], radius: 4,
                x: block.place, y: of.map((one) => one.value), low: of.map((one) => one.low), high: of.map((one) => one.high), whiskers: !alone, hollow: of.map(isNever)});
    lines.push({label: "before", colour: alone ? "soft" : (i % 6) + 1, dash: [3, 4], width: 1, x: block.place, y: of.map((one) => one.start), silent: !alone});
  });
  return lines;
}

const axisLabel = (axis) => labelled(axis.name, axis.unit);

/** Values at the knots, with what they were and the half of their interval. */
function ordinates(table, own) {
  const {low, high} = range(own.filter((one) => !isNever(one)).map((one) => one.value)) || {low: 0, high: 1};
  const cell = (one) => {
    const never = one.seen === "never_visited";
    const weight = 0.08 + 0.4 * (high > low ? (one.value - low) / (high - low) : 0.5);
    const told = one.moved_by ? "moved by " + one.moved_by.replaceAll("`", "") : never || one.frozen ? "as at the start" : isNumber(one.error) ? "\u00b1\u00a0" + number((one.high - one.low) / 2, 2) : "no error";
    return make("td", {class: never ? "never" : "seen", style: never ? null : `background: rgba(var(--cell), ${weight.toFixed(3)})`, title: `${one.name}: ${number(one.start)} before, ${number(one.value)} after; ${plural(one.visits, "point")} depend on it`},
                make("span", {}, one.frozen ? number(one.value) : measured(one.value, one.error)), make("small", {}, make("span", {}, told)));
  };
  const columns = table.grid ? table.axes[0].knots : null;
  const titled = `${table.free} after the fit, with the half of its ${confidence} interval` + (own.some(isNever) ? "; hatched is what no compared point depends on" : "");
  let content;
  if (columns) {
    content = make("table", {class: "coverage"}, make("caption", {}, quoted(titled)),
        make("thead", {}, make("tr", {}, make("th", {scope: "col"}, (table.axes.length > 1 ? "\u2193  " : "") + axisLabel(table.axes[0]) + " \u2192"), columns.map((knot) => make("th", {scope: "col"}, number(knot))))),
        make("tbody", {}, table.blocks.map((block) => make("tr", {}, make("th", {scope: "row"}, quoted(block.label || labelled(table.free, table.unit))), own.slice(block.first, block.first + block.x.length).map(cell))).reverse()));
  } else {
    content = make("table", {class: "coverage"}, make("caption", {}, quoted(titled)),
        make("tbody", {}, table.blocks.flatMap((block) => [
          make("tr", {}, make("th", {scope: "row"}, quoted(`${block.label ? block.label + ", " : ""}${axisLabel(table.axes[0])}`)), block.x.map((knot) => make("th", {scope: "col"}, number(knot)))),
          make("tr", {}, make("th", {scope: "row"}, quoted(labelled(table.free, table.unit))), own.slice(block.first, block.first + block.x.length).map(cell))])));
  }
  return scrolling(content, "Values of " + table.name);
}

const scrolling = (table, name) => make("div", {class: "coverage-block", tabindex: 0, role: "region", "aria-label": name}, table);

/** Increments in each cell between knots. */
function visits(table) {
  const [across, up] = table.axes;
  const wide = across.knots.length - 1;
  const high = up ? up.knots.length - 1 : 1;
  const between = (axis, i) => `${number(axis.knots[i])} \u2026 ${number(axis.knots[i + 1])}`;
  const largest = Math.max(1, ...table.cells.map((cell) => cell.visits));
  const cell = (one) => {
    const seen = one.visited;
    const weight = 0.08 + 0.4 * Math.log1p(one.visits) / Math.log1p(largest);
    return make("td", {class: seen ? "seen" : "never", style: seen ? `background: rgba(var(--cell), ${weight.toFixed(3)})` : null, title: `${one.text}: ${seen ? plural(one.visits, "increment") : one.visits > 0 ? `never visited, ${plural(one.visits, "increment")} along its edge only` : "never visited"}`}, make("span", {}, String(one.visits)));
  };
  const rows = Array.from({length: high}, (_, i) => make("tr", {}, make("th", {scope: "row"}, up ? between(up, i) : "increments"), table.cells.slice(i * wide, (i + 1) * wide).map(cell)));
  return scrolling(make("table", {class: "coverage visits"}, make("caption", {}, "Increments of the fitted experiments in each cell between knots; hatched cells were never visited, or along their edge only"),
      make("thead", {}, make("tr", {}, make("th", {scope: "col"}, (up ? axisLabel(up) + " \u2193  " : "") + axisLabel(across) + " \u2192"), Array.from({length: wide}, (_, i) => make("th", {scope: "col"}, between(across, i))))),
      make("tbody", {}, rows.reverse())), "Visits of " + table.name);
}

// ------------------------------------------------------------------------------------------- correlation

const kStrong = 0.95;

function correlationPart() {
  const {unknowns: shown, rows} = page.correlation;
  if (shown.length < 2) return null;
  const pairs = [];
  rows.forEach((row, i) => row.forEach((value, k) => { if (k < i && Math.abs(value) >= kStrong) pairs.push([value, calledOf(unknowns[shown[k]]), calledOf(unknowns[shown[i]])]); }));
  pairs.sort((a, b) => Math.abs(b[0]) - Math.abs(a[0]));
  const cell = (value, i, k) => {
    if (i === k) return make("td", {class: "soft"}, "1");
    const name = `${calledOf(unknowns[shown[i]])}, ${calledOf(unknowns[shown[k]])}: ${number(value, 3)}`;
    return make("td", {class: i !== k && Math.abs(value) >= kStrong ? "strong" : "", style: isNumber(value) ? `background: rgba(var(${value < 0 ? "--push" : "--pull"}), ${(0.42 * Math.abs(value)).toFixed(3)})` : null, title: name},
                isNumber(value) ? twoDecimals(value) : "\u2013");
  };
  const block = part("correlation", "Correlation",
      make("p", {class: "soft"}, "Near \u00b11 two unknowns can take each other's place: the data tell their combination, not each. Outlined from \u00b10.95 on."
          + (shown.length < unknowns.length ? ` Shown are ${shown.length} of ${unknowns.length}${shown.length < figures.free ? ": those with the strongest ones" : ""}.` : "")));
  for (const [value, first, second] of pairs.slice(0, 5)) block.append(make("p", {class: "note words"}, quoted(first), " and ", quoted(second), `: ${value.toFixed(3).replace("-", "\u2212")}`));
  if (pairs.length > 5) block.append(make("p", {class: "soft"}, `and ${pairs.length - 5} more pairs`));
  block.append(scrolling(make("table", {class: "coverage", id: "correlations"}, make("caption", {class: "hidden"}, "Correlation of the unknowns"),
      make("thead", {}, make("tr", {}, make("th"), shown.map((index, i) => make("th", {scope: "col", title: calledOf(unknowns[index])}, String(i + 1))))),
      make("tbody", {}, rows.map((row, i) => make("tr", {}, make("th", {scope: "row", class: "long"}, `${i + 1}  `, make("bdi", {}, breakable(calledOf(unknowns[shown[i]])))), row.map((value, k) => cell(value, i, k)))))), "Correlation"));
  return block;
}

// ---------------------------------------------------------------------------------- profiles and searches

function profilesPart() {
  if (profiles.length === 0) return null;
  const made = profiles.map((profile) => {
    const one = unknowns[profile.unknown];
    const open = [profile.open_below ? "below" : "", profile.open_above ? "above" : ""].filter(Boolean).join(" and ");
    const best = {label: "optimum", pointsOnly: true, point: "circle", radius: 5, x: [one.value], y: [verdict.cost]};
    const top = profile.threshold + 1.2 * (profile.threshold - verdict.cost);
    const largest = range(profile.cost) || {high: top};
    return new Drawing({
      key: "profile", title: `Cost along ${calledOf(one)}`, unit: "", xName: calledOf(one), xUnit: one.unit, words: `Profile likelihood of ${calledOf(one)}`,
      lines: [best, {label: "cost, others fitted again", width: 2, point: "circle", radius: 2, x: profile.value, y: profile.cost},
              {label: "threshold", colour: "limit", dash: [6, 4], x: [profile.value[0], profile.value[profile.value.length - 1]], y: [profile.threshold, profile.threshold]}],
      yLimits: top > verdict.cost ? [verdict.cost - 0.08 * (top - verdict.cost), Math.min(top, Math.max(largest.high, profile.threshold) + 0.1 * (top - verdict.cost))] : undefined,
      caption: open ? `Not bounded ${open}: the data allow any value there.` : `${confidence} interval ${number(profile.low, 5)} \u2026 ${number(profile.high, 5)}, where the curve crosses the threshold.`
    }, "curve");
  });
  return part("profiles", "Profile likelihood",
      make("p", {class: "soft"}, "The least cost for each value of one unknown, all others fitted again. A parabola that crosses the threshold at both sides is well told; a flat side is not."),
      make("div", {class: "small-pictures"}, made.map((picture) => picture.element)));
}

function searchPart() {
  const best = Math.min(...searches.map((one) => (isNumber(one.cost) ? one.cost : Infinity)));
  const near = searches.filter((one) => one.found).length;
  const block = part("search", "How it was found",
      make("p", {class: "soft"}, quoted([figures.derivatives && figures.derivatives.charAt(0).toUpperCase() + figures.derivatives.slice(1) + ".", `${figures.runs} evaluations of the residuals and ${figures.derivative_runs} of their derivatives.`].filter(Boolean).join(" "))));
  if (searches.length > 1) {
    block.append(make("p", {class: near === 1 ? "note words" : "words"}, near === 1 ? make("b", {}, "Look at: ") : "", figures.starts + "." + (near === 1 && searches.some((one) => !one.found && isNumber(one.cost)) ? " Others ended elsewhere: there may be a lower one still; ask for more starts." : "")));
    block.append(waterfall().element);
  }
  block.append(inScroll(make("table", {class: "plain", id: "search-table"}, make("caption", {class: "hidden"}, "Searches"),
      head([["Start", true], ["Cost at the start", true], ["Cost at the end", true], ["Iterations", true], ["Why it ended"]]),
      make("tbody", {}, searches.map((one, i) => make("tr", {},
          make("td", {class: "number"}, i === 0 ? "as given" : String(i + 1)), make("td", {class: "number"}, number(one.start_cost)), make("td", {class: "number"}, one.cost === best ? make("b", {}, number(one.cost, 6)) : number(one.cost, 6)),
          make("td", {class: "number"}, String(one.iterations)), make("td", {class: "reason"}, make("span", {class: "mark " + (one.converged ? "passed" : "failed"), title: one.converged ? "converged" : "not converged"}, one.converged ? "\u2713" : "\u2717"), " ", quoted(reason(one.stop)))))))));
  return block;
}

/** Ticks of a scale in powers of ten: whole powers, or 1, 2 and 5 of them where those are few. */
function powerTicks(scale) {
  const ticks = [];
  const step = Math.max(1, Math.ceil((scale.max - scale.min) / 6));
  for (let power = Math.floor(scale.min); power <= scale.max; power += step) {
    for (const digit of scale.max - scale.min > 2.5 ? [1] : [1, 2, 5]) ticks.push(power + Math.log10(digit));
  }
  const inside = ticks.filter((tick) => tick >= scale.min && tick <= scale.max);
  return inside.length > 1 ? inside : roundTicks(scale.min, scale.max, 4);
}

/** The costs of all searches, the least first, in powers of ten. */
function waterfall() {
  const sorted = searches.filter((one) => isNumber(one.cost)).sort((a, b) => a.cost - b.cost);
  const floor = Math.max(1e-300, ...sorted.map((one) => one.start_cost || 0)) * 1e-18;
  const power = (cost) => Math.log10(Math.max(cost, floor));
  const x = sorted.map((_, i) => i + 1);
  return new Drawing({
    key: "searches", title: "Cost of each search, least first", unit: "", xName: "search", xUnit: "", xLimits: [0.5, sorted.length + 0.5],
    lines: [{label: "at the end", point: "circle", radius: 4, x, y: sorted.map((one) => power(one.cost))}, {label: "at the start", colour: "soft", pointsOnly: true, point: "triangle", radius: 4, x, y: sorted.map((one) => power(one.start_cost))}],
    yTick: (value) => number(10 ** value, 3),
    ticks: {x: (scale) => roundTicks(scale.min, scale.max, 10).filter(Number.isInteger), y: powerTicks}
  }, "curve");
}

// -------------------------------------------------------------------------------------------- provenance

function provenancePart() {
  const entries = [["Program", page.generator], ["Fit", page.file]];
  if (page.date) entries.push(["Date", page.date]);
  for (const one of experiments) {
    entries.push([one.held_out ? "Held out" : "Fitted", [quoted(one.name), ": case ", quoted(one.case), ", data ", quoted(one.data), one.hash ? [", SHA-256 ", make("span", {class: "hash"}, one.hash)] : ""].flat()]);
  }
  entries.push(["Condition", `${number(figures.condition, 3)} of the scaled derivatives; above 10\u2076 some combination of unknowns is hardly told`]);
  if (isNumber(figures.gradient)) entries.push(["Gradient", `${number(figures.gradient, 3)} at the optimum, the largest scaled component`]);
  if (figures.bootstrap_wanted > 0) entries.push(["Resampled", `${figures.bootstrap} of ${figures.bootstrap_wanted} fits converged`]);
  return part("provenance", "Provenance", make("dl", {class: "provenance"}, entries.map(([name, what]) => [make("dt", {}, name), make("dd", {}, [what].flat().map((one) => (typeof one === "string" ? one : one)))]).flat()));
}

// ---------------------------------------------------------------------------------------------- contents

const parts = [];

function build() {
  const sections = [unknownsPart(), errorsPart(), ...experiments.map(experimentPart), ...tables.map(tablePart), correlationPart(), profilesPart(), searchPart(), provenancePart()].filter(Boolean);
  find("fit").replaceChildren(header(), ...sections);
  const list = find("contents");
  const add = (element, title, inner, note) => {
    const link = make("a", {href: "#" + element.id}, make("span", {}, title), note ? make("span", {class: "soft"}, note) : "");
    list.append(make("li", {class: inner ? "inner" : ""}, link));
    parts.push({element, link});
  };
  add(find("verdict"), "Verdict");
  for (const section of sections) {
    const at = experiments.findIndex((_, i) => experimentId(i) === section.id);
    const one = experiments[at];
    if (one) {
      const [response] = one.responses;
      add(section, quoted(one.name), true, response && response.rmse_before > 0 ? `${one.held_out ? "held out " : ""}\u00d7${number(response.rmse_after / response.rmse_before, 2)}` : "");
    } else {
      add(section, quoted(section.querySelector("h3").textContent), false);
    }
  }
  markPart();
}

/** The part at the top of the screen is marked in the contents. */
function markPart() {
  const now = currentPart();
  parts.forEach(({link}, i) => {
    if (i === now) link.setAttribute("aria-current", "true");
    else link.removeAttribute("aria-current");
  });
}
function currentPart() {
  if (window.innerHeight + window.scrollY >= document.documentElement.scrollHeight - 2) {
    // Short last parts never come to the top: the one that was asked for counts.
    const asked = parts.findIndex(({element}) => "#" + element.id === location.hash);
    if (asked >= 0 && parts[asked].element.getBoundingClientRect().top < window.innerHeight) return asked;
    return parts.length - 1;
  }
  let now = 0;
  parts.forEach(({element}, i) => { if (element.getBoundingClientRect().top < 80) now = i; });
  return now;
}
function stepPart(step) {
  const next = parts[Math.min(Math.max(currentPart() + step, 0), parts.length - 1)];
  try { history.replaceState(null, "", "#" + next.element.id); } catch { /* a browser may forbid it for files */ }
  next.element.scrollIntoView({block: "start"});
  markPart();
}

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || find("help").open || event.target.matches("textarea")) return;
  const action = {j: () => stepPart(1), k: () => stepPart(-1), t: nextTheme, "?": () => find("help").showModal()}[event.key];
  if (!action) return;
  event.preventDefault();
  action();
}

// -------------------------------------------------------------------------------------------------- start

// On paper all of them are there.
window.addEventListener("beforeprint", () => { for (const picture of pictures) picture.draw(); });
document.body.append(patterns());
readColours();
build();
startPage();
document.addEventListener("keydown", onKey);
window.addEventListener("scroll", markPart, {passive: true});
window.addEventListener("hashchange", markPart);
find("skip").addEventListener("click", (event) => { event.preventDefault(); find("fit").focus(); });
find("title").replaceChildren(quoted(page.title));
find("title").setAttribute("title", page.generator);
find("totals").replaceChildren(make("span", {class: verdict.converged ? "" : "failed"}, make("b", {}, verdict.converged ? "Converged" : "Not converged")), `: ${plural(figures.free, "free unknown")}, ${plural(figures.data, "point")}`);
if (location.hash) {
  const asked = parts.find(({element}) => "#" + element.id === location.hash);
  if (asked) asked.element.scrollIntoView();
}
