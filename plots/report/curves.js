// SPDX-License-Identifier: Apache-2.0
// The rows of a run and their curves: unpacks what the program packed (driver/report/packed_numbers.hpp), and draws as
// many points as there are pixels. Of a thinned run the page has some rows, and the extremes of pieces of equally many:
// nothing is ever drawn between rows that are not neighbours, but the range of their piece.

const kPackedBlock = 64;

/** A series of numbers; NaN where the run had none. */
function unpack(text) {
  const bytes = atob(text);
  const values = [];
  let at = 0;
  let decimals = 0;
  let power = 1;
  // The two numbers before, newest first: in units of 10^-decimals, and as they are.
  let k1 = 0;
  let k2 = 0;
  let v1 = 0;
  let v2 = 0;
  const next = () => {
    let number = 0;
    for (let unit = 1;; unit *= 128) {
      const byte = bytes.charCodeAt(at++);
      number += (byte & 127) * unit;
      if (byte < 128) return number;
    }
  };
  const unfold = (n) => (n % 2 === 1 ? -(n + 1) / 2 : n / 2);
  const whole = (value) => {
    const units = decimals < 0 ? value / power : value * power;
    return Math.abs(units) < 1e15 ? Math.floor(units + 0.5) : 0;
  };
  const put = (off) => {
    const k = 2 * k1 - k2 + off;
    [k2, v2] = [k1, v1];
    k1 = k;
    v1 = decimals < 0 ? k * power : k / power;
    values.push(v1);
  };
  let begun = -1;
  while (at < bytes.length) {
    if (values.length % kPackedBlock === 0 && begun !== values.length) {
      begun = values.length;
      const change = unfold(next());
      if (change !== 0) {
        decimals += change;
        power = Number("1e" + Math.abs(decimals));
        k1 = whole(v1);
        k2 = whole(v2);
      }
    }
    const token = next();
    if (token === 0) for (let count = next(); count > 0; --count) put(0);
    else if (token === 1) values.push(NaN);
    else put(unfold(token - 1));
  }
  return values;
}

/** Which rows follow each other; `index` says how many were before each, null where all are there. */
function neighbours(index, piece) {
  return {
    piece,
    /** Whether a row is the neighbour of that before it. */
    joined: (row) => !index || row === 0 || index[row] - index[row - 1] <= 1,
    /** The piece between two rows that are no neighbours. */
    pieceBefore: (row) => Math.floor(index[row - 1] / piece)
  };
}

/** Of a case: which rows the page has. `index` is null where all are there. */
function rowsOf(one) {
  if (one.known) return one.known;
  const index = one.index ? unpack(one.index) : null;
  const drawn = one.cycles ? one.cycles.drawn : [];
  one.known = {
    index, drawn, ...neighbours(index, one.pieces ? one.pieces.rows : 1),
    /** The place among the cycles drawn of one that leads to the row; -1 for none. */
    cycleOf: (row) => drawn.findIndex(([, first, last]) => row > first && row <= last)
  };
  return one.known;
}

/** A column of a case: its numbers row by row, and of a thinned run the extremes of each piece. */
function columnOf(one, name) {
  const at = (one.columns || []).findIndex((column) => column.name === name);
  if (at < 0) return null;
  const column = one.columns[at];
  if (!column.values) {
    column.values = unpack(one.rows[at]);
    if (one.pieces) [column.low, column.high] = [unpack(one.pieces.low[at]), unpack(one.pieces.high[at])];
  }
  return column;
}

/** Smallest and largest number of a column or line of the whole run. */
function wholeRange(line) {
  const all = [range(line.values || line.y), range(line.low), range(line.high)].filter(Boolean);
  return all.length === 0 ? null : {low: Math.min(...all.map(({low}) => low)), high: Math.max(...all.map(({high}) => high))};
}

// ------------------------------------------------------------------------------------------ drawing

/** The points of a line: its rows, with events between them, or the points of a check. */
function pointsOf(line) {
  const {x, y} = line.drawn || line;
  const row = line.drawn ? line.drawn.row : null;
  const rowAt = (i) => (row ? row[i] : i);
  const rows = line.rows || neighbours(line.index, line.piece);
  const band = (i) => (line.low ? rows.pieceBefore(rowAt(i)) : -1);
  return {x, y, rowAt, band, joined: (i) => i > 0 && rows.joined(rowAt(i))};
}

/** First index from `low` on whose number is at least `wanted`; of numbers that never fall. */
function firstFrom(numbers, wanted) {
  let low = 0;
  let high = numbers.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (numbers[middle] < wanted) low = middle + 1;
    else high = middle;
  }
  return low;
}

/**
 * A history from x = from to x = to on so many pixels, as strokes and bands: of each column of pixels the first, the
 * last, the smallest and the largest value. A stroke is a list of x and y one after the other.
 */
function reduceHistory(line, from, to, pixels) {
  const {x, y, band, joined} = pointsOf(line);
  const begin = Math.max(firstFrom(x, from) - 1, 0);
  let end = Math.min(firstFrom(x, to) + 1, x.length);
  while (end < x.length && x[end] === x[end - 1]) ++end;
  const perPixel = (to - from) / pixels;
  const strokes = [];
  const bands = [];
  let stroke = [];
  // Of the column of pixels that is being filled.
  let cell = null;
  const closeCell = () => {
    if (!cell) return;
    const {first, last, low, high} = cell;
    stroke.push(first.x, first.y);
    const between = low.x <= high.x ? [low, high] : [high, low];
    for (const one of [...between, last]) {
      if (one.x !== stroke[stroke.length - 2] || one.y !== stroke[stroke.length - 1]) stroke.push(one.x, one.y);
    }
    cell = null;
  };
  const closeStroke = () => {
    closeCell();
    if (stroke.length > 0) strokes.push(stroke);
    stroke = [];
  };
  const put = (at) => {
    const place = Math.floor((at.x - from) / perPixel);
    if (cell && cell.place !== place) closeCell();
    if (!cell) cell = {place, first: at, last: at, low: at, high: at};
    cell.last = at;
    if (at.y < cell.low.y) cell.low = at;
    if (at.y > cell.high.y) cell.high = at;
  };
  for (let i = begin; i < end; ++i) {
    if (!isNumber(x[i]) || !isNumber(y[i])) {
      closeStroke();
      continue;
    }
    if (i > begin && !joined(i)) {
      const piece = band(i);
      const [low, high] = piece >= 0 ? [line.low[piece], line.high[piece]] : [NaN, NaN];
      if (!isNumber(low)) {
        closeStroke();
      } else if (cell && x[i] - x[i - 1] < perPixel) {
        put({x: x[i], y: low});
        put({x: x[i], y: high});
      } else {
        closeStroke();
        bands.push([x[i - 1], x[i], low, high]);
      }
    }
    put({x: x[i], y: y[i]});
  }
  closeStroke();
  return {strokes, bands};
}

/** A loop as strokes, each with its manner ("slip", "stick" and the place of its cycle), and as dots without neighbours. */
function loopStrokes(line) {
  const {x, y, rowAt, joined} = pointsOf(line);
  const status = line.status && (line.drawn ? line.drawn.status : line.status);
  const cycles = line.rows && line.rows.index ? line.rows.drawn.length : 0;
  const strokes = [];
  const dots = [];
  let stroke = null;
  for (let i = 0; i < x.length; ++i) {
    const known = isNumber(x[i]) && isNumber(y[i]);
    const cycle = cycles > 0 ? line.rows.cycleOf(rowAt(i)) : 0;
    // Of a thinned run with cycles only those are drawn.
    if (!known || cycle < 0) {
      stroke = null;
      continue;
    }
    const slips = status ? status[i] === 2 : null;
    if (i === 0 || !joined(i) || !isNumber(x[i - 1]) || !isNumber(y[i - 1])) {
      if (cycles === 0 && i + 1 < x.length && !joined(i + 1)) dots.push(x[i], y[i]);
      if (cycles === 0 && i + 1 === x.length) dots.push(x[i], y[i]);
      stroke = null;
      continue;
    }
    if (!stroke || stroke.slips !== slips || stroke.cycle !== cycle) {
      stroke = {slips, cycle, points: [x[i - 1], y[i - 1]]};
      strokes.push(stroke);
    }
    stroke.points.push(x[i], y[i]);
  }
  return {strokes, dots, cycles};
}

/** Whether some line that varies has more rows in a chart than it has columns of pixels. */
function isCrowded(lines, chart) {
  const {min, max} = chart.scales.x;
  const pixels = chart.chartArea.right - chart.chartArea.left;
  const one = lines.find((line) => line.main) || lines[0];
  if (!one || firstFrom(one.x, max) - firstFrom(one.x, min) < 2 * pixels) return false;
  // A way to and fro that is longer than the picture is wide, many times over.
  const {strokes} = reduceHistory(one, min, max, pixels);
  const height = chart.scales.y.max - chart.scales.y.min;
  let way = 0;
  for (const stroke of strokes) for (let i = 3; i < stroke.length; i += 2) way += Math.abs(stroke[i] - stroke[i - 2]);
  return way > 20 * height;
}

/** Draws one line of a panel into the area of a chart. What was drawn stays with the line, for those who look it up. */
function drawLine(pen, chart, panel, line, crowded = false) {
  const {x: xScale, y: yScale} = chart.scales;
  const xOf = (value) => xScale.getPixelForValue(value);
  const yOf = (value) => yScale.getPixelForValue(value);
  pen.strokeStyle = pen.fillStyle = colourOf(line);
  pen.lineJoin = "round";
  pen.setLineDash(crowded ? [] : line.dash || []);
  const way = (points, path) => {
    let [px, py] = [xOf(points[0]), yOf(points[1])];
    path.moveTo(px, py);
    for (let i = 2; i < points.length; i += 2) {
      const [qx, qy] = [xOf(points[i]), yOf(points[i + 1])];
      // Steps that nobody sees, but for the last.
      if (Math.abs(qx - px) + Math.abs(qy - py) < 0.3 && i + 2 < points.length) continue;
      path.lineTo(qx, qy);
      [px, py] = [qx, qy];
    }
  };
  const dot = (x, y, size) => pen.fillRect(xOf(x) - size / 2, yOf(y) - size / 2, size, size);
  if (panel.kind === "history") {
    const drawn = reduceHistory(line, xScale.min, xScale.max, chart.chartArea.right - chart.chartArea.left);
    line.painted = drawn;
    pen.lineWidth = line.thin ? 1.3 : 1.7;
    for (const [from, to, low, high] of drawn.bands) {
      const [top, bottom] = [yOf(high), yOf(low)];
      // A band that is no higher than a line is one.
      const flat = bottom - top < pen.lineWidth;
      const middle = (top + bottom) / 2;
      pen.globalAlpha = flat ? 1 : 0.45;
      pen.fillRect(xOf(from), flat ? middle - pen.lineWidth / 2 : top, xOf(to) - xOf(from), flat ? pen.lineWidth : bottom - top);
    }
    pen.globalAlpha = 1;
    const path = new Path2D();
    for (const stroke of drawn.strokes) {
      if (stroke.length === 2) dot(stroke[0], stroke[1], line.x.length < 3 ? 5 : 1.7);
      else way(stroke, path);
    }
    pen.stroke(path);
    return;
  }
  if (!line.loop) line.loop = loopStrokes(line);
  const {strokes, dots, cycles} = line.loop;
  line.painted = line.loop;
  const paths = new Map();
  for (const {slips, cycle, points} of strokes) {
    const key = `${cycle} ${slips}`;
    if (!paths.has(key)) paths.set(key, {path: new Path2D(), cycle, slips});
    way(points, paths.get(key).path);
  }
  // The first cycle is light, the last one dark; in a loop, where nothing can be shaded, slip is bolder than stick.
  for (const {path, cycle, slips} of [...paths.values()].sort((a, b) => a.cycle - b.cycle)) {
    pen.globalAlpha = cycles > 1 ? 0.35 + 0.65 * cycle / (cycles - 1) : 1;
    pen.lineWidth = slips === null ? (line.thin ? 1.3 : 1.7) : slips ? 2.6 : 1.1;
    pen.stroke(path);
  }
  pen.globalAlpha = 1;
  for (let i = 0; i < dots.length; i += 2) dot(dots[i], dots[i + 1], line.x.length < 3 ? 5 : 1.5);
}

/** Smallest and largest value of a line between two places of a history. */
function visibleRange(line, from, to) {
  const {strokes, bands} = reduceHistory(line, from, to, 800);
  let low = Infinity;
  let high = -Infinity;
  const take = (x, y) => {
    if (x < from || x > to || !isNumber(y)) return;
    low = Math.min(low, y);
    high = Math.max(high, y);
  };
  for (const stroke of strokes) for (let i = 0; i < stroke.length; i += 2) take(stroke[i], stroke[i + 1]);
  for (const [left, right, least, most] of bands) {
    if (right < from || left > to) continue;
    take(Math.max(left, from), least);
    take(Math.max(left, from), most);
  }
  return low <= high ? {low, high} : null;
}
