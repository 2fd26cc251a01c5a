// SPDX-License-Identifier: Apache-2.0
// Zooming, panning and saving. All histories of a case share one window of time (view.window); a loop or the curve of a
// check is zoomed by itself (picture.zoomed).

// ------------------------------------------------------------------------------------------- the window

/** The times of all histories together. */
const wholeWindow = () => {
  const panel = pictures.map((picture) => picture.panel).find((one) => one.windowed);
  return panel && panel.xLimits ? panel.xLimits : null;
};

/** Shows the histories from one time to another; null: all. */
function setWindow(wanted) {
  const whole = wholeWindow();
  if (!whole) return;
  view.window = null;
  if (wanted) {
    const [low, high] = whole;
    const length = Math.min(Math.max(wanted[1] - wanted[0], 1e-9 * (high - low), 1e-12 * Math.max(Math.abs(low), Math.abs(high))), high - low);
    const from = Math.min(Math.max(wanted[0], low), high - length);
    if (length < (1 - 1e-9) * (high - low)) view.window = [from, from + length];
  }
  for (const picture of pictures) if (picture.panel.windowed) picture.rescale();
  tellShown();
}

/** Makes the window so many times as long, about a time that stays where it is. */
function zoomWindow(factor, about = view.time()) {
  const [from, to] = view.window || wholeWindow() || [];
  if (from === undefined) return;
  const fixed = about >= from && about <= to ? about : (from + to) / 2;
  setWindow([fixed - (fixed - from) * factor, fixed + (to - fixed) * factor]);
}

/** Shifts the window by a part of its length. */
function panWindow(part) {
  if (!view.window) return;
  const [from, to] = view.window;
  setWindow([from + part * (to - from), to + part * (to - from)]);
}

/** The window goes along with an instant that would leave it. */
function followInstant() {
  if (!view.window) return;
  const [from, to] = view.window;
  const now = view.time();
  if (now < from || now > to) setWindow([now - (to - from) / 2, now + (to - from) / 2]);
}

/** What of the rows is drawn where the histories are now. */
function tellShown() {
  const place = find("shown");
  if (!place) return;
  const {one} = view;
  const times = view.times[0];
  const rows = rowsOf(one);
  const [from, to] = view.window || wholeWindow() || [times[0], times[times.length - 1]];
  const [first, last] = [firstFrom(times, from), Math.max(firstFrom(times, to), 1) - (times[firstFrom(times, to)] === to ? 0 : 1)];
  const count = rows.index ? rows.index[Math.min(last, times.length - 1)] - rows.index[Math.min(first, times.length - 1)] + 1 : last - first + 1;
  const drawn = pictures.find((picture) => picture.panel.windowed && picture.chart);
  const pixels = drawn ? Math.max(drawn.chart.chartArea.right - drawn.chart.chartArea.left, 1) : 1;
  const perPixel = count / pixels;
  const said = view.window ? [`t = ${timeText(one, from)} to ${timeText(one, to)}`] : [];
  if (rows.index && rows.piece > perPixel) said.push(`where a line is a band, it is the range of ${rows.piece} rows`);
  else if (perPixel > 2) said.push(`each column of pixels has about ${number(perPixel, 2)} rows: first, last, smallest and largest are drawn`);
  else said.push("every row is drawn");
  place.textContent = said.join(": ");
}

// ------------------------------------------------------------------------------------------ one picture

/** Zooms a picture to limits of both axes; null: all of it. */
function zoomPicture(picture, limits) {
  if (picture.panel.windowed) return setWindow(limits && limits.x);
  picture.zoomed = limits;
  picture.rescale();
}

/** Wheel with Ctrl zooms, dragging zooms into a box, with Shift it pans; two fingers do both; a double click shows all. */
function listenTo(picture) {
  const {plot} = picture;
  const fingers = new Map();
  let drag = null;
  const scale = (key) => picture.chart.scales[key];
  const place = (event) => {
    const box = picture.canvas.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  };
  const now = () => ({x: [scale("x").min, scale("x").max], y: [scale("y").min, scale("y").max]});
  const value = (key, pixel) => scale(key).getValueForPixel(pixel);
  const inside = ({x, y}) => {
    const area = picture.chart.chartArea;
    return x >= area.left - 8 && x <= area.right + 8 && y >= area.top - 8 && y <= area.bottom + 8;
  };
  /** The limits that bring the values `held` to the pixels `at`, two of them along the abscissa. */
  const pinched = ([a, b], [left, right]) => {
    const {left: begin, right: end} = picture.chart.chartArea;
    const perPixel = (b - a) / (right - left);
    return [a - (left - begin) * perPixel, b + (end - right) * perPixel];
  };
  plot.addEventListener("pointerdown", (event) => {
    const at = place(event);
    if (event.pointerType === "touch") {
      fingers.set(event.pointerId, {...at, held: value("x", at.x)});
      if (fingers.size === 1) picture.pointed(event);
      return;
    }
    if (event.button !== 0 || !inside(at)) return;
    drag = {...at, limits: now(), pans: event.shiftKey};
    plot.setPointerCapture(event.pointerId);
    picture.pointed(event);
  });
  plot.addEventListener("pointermove", (event) => {
    const at = place(event);
    if (fingers.has(event.pointerId)) {
      Object.assign(fingers.get(event.pointerId), at);
      if (fingers.size < 2) return picture.pointed(event);
      const [a, b] = [...fingers.values()].sort((one, other) => one.x - other.x);
      if (b.x - a.x > 10 && b.held > a.held) zoomPicture(picture, {...now(), x: pinched([a.held, b.held], [a.x, b.x])});
      return;
    }
    if (!drag) return picture.pointed(event);
    if (drag.pans) {
      const shifted = (key, limits) => {
        const off = (at[key] - drag[key]) * (limits[1] - limits[0]) / (key === "x" ? scale("x").width : -scale("y").height);
        return limits.map((limit) => limit - off);
      };
      zoomPicture(picture, {x: shifted("x", drag.limits.x), y: shifted("y", drag.limits.y)});
      return;
    }
    picture.selection = boxOf(at);
    picture.placeMarks();
  });
  /** What is dragged over: of a history all of its height. */
  const boxOf = (at) => {
    const area = picture.chart.chartArea;
    const clipped = (one, low, high) => Math.min(Math.max(one, low), high);
    const high = picture.panel.windowed;
    return {
      left: clipped(Math.min(at.x, drag.x), area.left, area.right), right: clipped(Math.max(at.x, drag.x), area.left, area.right),
      top: high ? area.top : clipped(Math.min(at.y, drag.y), area.top, area.bottom), bottom: high ? area.bottom : clipped(Math.max(at.y, drag.y), area.top, area.bottom)
    };
  };
  const end = (event) => {
    fingers.delete(event.pointerId);
    if (!drag) return;
    const box = picture.selection;
    drag = null;
    picture.selection = null;
    // A click that trembles is no box.
    if (event.type === "pointerup" && box && box.right - box.left > 6 && box.bottom - box.top > 6) {
      zoomPicture(picture, {x: [value("x", box.left), value("x", box.right)], y: [value("y", box.bottom), value("y", box.top)]});
    }
    picture.placeMarks();
  };
  for (const name of ["pointerup", "pointercancel"]) plot.addEventListener(name, end);
  plot.addEventListener("pointerleave", (event) => fingers.delete(event.pointerId));
  plot.addEventListener("dblclick", () => zoomPicture(picture, null));
  plot.addEventListener("wheel", (event) => {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    const at = place(event);
    const factor = 1.002 ** event.deltaY;
    const about = (key) => {
      const fixed = value(key, at[key]);
      return now()[key].map((limit) => fixed + (limit - fixed) * factor);
    };
    zoomPicture(picture, {x: about("x"), y: about("y")});
  }, {passive: false});
}

// ----------------------------------------------------------------------------------------------- saving

/** Gives a file to the reader. */
function offer(name, blob) {
  const link = make("a", {href: URL.createObjectURL(blob), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
const fileName = (...parts) => parts.join("-").replace(/[^\w.-]+/g, "_");

/** The picture as a PNG on white, with its title, its legend, and the case it is of. */
function savePicture(picture) {
  const {one} = view;
  const ratio = 2;
  printing = true;
  applyTheme("light");
  resizeNow(picture);
  const {clientWidth: width, clientHeight: height} = picture.plot;
  const sheet = make("canvas");
  const pen = sheet.getContext("2d");
  const font = getComputedStyle(document.body).fontFamily;
  const entries = picture.panel.lines.filter((line) => !line.silent && !line.off);
  pen.font = `12px ${font}`;
  // The legend, in as many rows as it needs.
  const places = [];
  let [x, y] = [8, 34];
  for (const line of entries) {
    const wide = 34 + pen.measureText(line.label).width + 16;
    if (x > 8 && x + wide > width) [x, y] = [8, y + 16];
    places.push([x, y]);
    x += wide;
  }
  const top = y + 10;
  [sheet.width, sheet.height] = [ratio * width, ratio * (top + height + 22)];
  pen.scale(ratio, ratio);
  pen.fillStyle = "#ffffff";
  pen.fillRect(0, 0, width, top + height + 22);
  pen.fillStyle = colours.text;
  pen.font = `600 13px ${font}`;
  pen.fillText(picture.element.querySelector("h4").textContent, 8, 17);
  pen.font = `12px ${font}`;
  entries.forEach((line, i) => {
    const [left, middle] = places[i];
    pen.strokeStyle = colourOf(line);
    pen.lineWidth = 2.2;
    pen.setLineDash(line.dash || []);
    pen.beginPath();
    pen.moveTo(left, middle - 4);
    pen.lineTo(left + 28, middle - 4);
    pen.stroke();
    pen.fillStyle = colours.text;
    pen.fillText(line.label, left + 34, middle);
  });
  pen.setLineDash([]);
  pen.drawImage(picture.canvas, 0, top, width, height);
  pen.fillStyle = colours.soft;
  pen.font = `11px ${font}`;
  pen.fillText(`${one.title || one.name} \u00b7 ${page.generator || ""}`, 8, top + height + 14);
  printing = false;
  applyTheme();
  resizeNow(picture);
  sheet.toBlob((blob) => offer(fileName(one.name, picture.panel.key) + ".png", blob));
}

/** The rows that the page has, as a result file has them: what they are, and which are missing, stands before them. */
function rowsText(one) {
  const columns = one.columns.map((column) => columnOf(one, column.name));
  const {index, piece} = rowsOf(one);
  const count = columns[0].values.length;
  const flat = (text) => text.replace(/\s+/g, " ");
  const lines = [`# ${page.generator || "slipbench"}, saved from the page of ${flat(one.name)}`, `# title: ${flat(one.title || "")}`,
                 `# columns: ${columns.map(({name, unit}) => (unit ? `${name} [${unit}]` : name)).join(", ")}`,
                 "# numbers are rounded: to a millionth of the column's range, or finer where the steps are small"];
  if (index) lines.push(`# rows: ${count} of ${one.rows_total}; row is the number of rows before; missing ones lie between first and last of pieces of ${piece}`);
  else if (one.rows_total !== one.increments + 1) lines.push(`# rows: ${count}, those of the result; the run had ${one.increments + 1}`);
  lines.push((index ? ["row"] : []).concat(columns.map(({name}) => name)).join(","));
  for (let i = 0; i < count; ++i) {
    const numbers = columns.map(({values}) => (isNumber(values[i]) ? String(values[i]) : "nan"));
    lines.push((index ? [String(index[i])] : []).concat(numbers).join(","));
  }
  return lines.join("\n") + "\n";
}
const saveRows = () => offer(fileName(view.one.name, "rows") + ".csv", new Blob([rowsText(view.one)], {type: "text/csv"}));

/** The buttons of all histories. */
function windowTools() {
  const button = (id, sign, words, action) => make("button", {type: "button", id, "aria-label": words, title: words, onclick: action}, sign);
  return make("div", {class: "window-tools", role: "group", "aria-label": "Zoom of the histories"},
      button("zoom-in", "+", "Zoom in about the instant (+)", () => zoomWindow(0.5)), button("zoom-out", "\u2212", "Zoom out (-)", () => zoomWindow(2)),
      button("pan-back", "\u2039", "Earlier (,)", () => panWindow(-0.5)), button("pan-on", "\u203a", "Later (.)", () => panWindow(0.5)),
      button("zoom-all", "all", "The whole run (0); of one picture: double click", () => { for (const picture of pictures) if (picture.zoomed) zoomPicture(picture, null); setWindow(null); }),
      button("save-rows", "Save rows", "Save the rows that the page has (CSV)", saveRows));
}
