// SPDX-License-Identifier: Apache-2.0
// The bench in the page: the text of the case in an editor, its numbers as sliders, and a run after every change. The core
// of the program is here as WebAssembly (live/live.cpp), and what it answers is the document of a report: the page draws it.

/** Starts the core: WebAssembly, in memory of its own. */
async function startCore() {
  const packed = Uint8Array.from(atob(find("core").textContent), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const program = await slipbenchCore({wasmBinary: await new Response(unpacked).arrayBuffer()});
  const call = coreCalls(program);
  return {run: (name, text) => JSON.parse(call("run", name, text)), rows: (name, text) => call("csv", name, text), schema: JSON.parse(call("schema")),
          put: (name, text) => {
            program.FS.createPath("/", name.split("/").slice(0, -1).join("/"), true, true);
            program.FS.writeFile(name, text);
          }};
}

// ------------------------------------------------------------------------------- words from the schema

/** All that may stand where a schema does: its alternatives, one by one. */
const alternatives = (schema) => (schema ? [schema, ...(schema.anyOf || []).flatMap(alternatives)] : []);
const below = (schemas, key) => schemas.flatMap((schema) => (typeof key === "number"
    ? alternatives(schema.items) : alternatives((schema.properties || {})[key] || (typeof schema.additionalProperties === "object" ? schema.additionalProperties : null))));

/**
 * The keys that lead to the end of a text, numbers for lists, and what was begun there: of blocks the lines that are less
 * indented, and of the last line its braces.
 */
function pathTo(text) {
  const lines = text.split("\n");
  const last = lines.pop();
  const path = [];
  let indent = Infinity;
  /** Takes "- - key:" from a line: its dashes and its key count if they are further left than all below them. */
  const take = (line) => {
    let [, blanks, rest] = /^( *)(.*)$/.exec(line.replace(/(^| )#.*$/, "$1"));
    let at = blanks.length;
    const found = [];
    for (let dash = /^- +/.exec(rest + " "); dash; dash = /^- +/.exec(rest + " ")) {
      if (at < indent) found.push(0);
      at += dash[0].length;
      rest = rest.slice(dash[0].length);
    }
    const key = /^([^\s:{}[\],"']+):(\s|$)/.exec(rest);
    if (key && at < indent) found.push(key[1]);
    return {found, at, left: blanks.length, rest: key ? rest.slice(key[0].length) : rest, keyed: Boolean(key)};
  };
  // A flow that was begun on lines before belongs to the last line.
  let whole = last;
  const depth = (line) => [...line.replace(/"[^"]*"|'[^']*'|#.*$/g, "")].reduce((sum, letter) => sum + ("{[".includes(letter) ? 1 : "}]".includes(letter) ? -1 : 0), 0);
  while (lines.reduce((sum, line) => sum + depth(line), 0) > 0) whole = `${lines.pop()} ${whole.trim()}`;
  const here = take(whole);
  path.unshift(...here.found);
  indent = here.left;
  for (let i = lines.length - 1; i >= 0 && (indent > 0 || path[0] === 0); --i) {
    if (/^ *(#.*)?$/.test(lines[i])) continue;
    const {found, left, at} = take(lines[i]);
    // A list may stand no further right than its key.
    const opens = left === indent && path[0] === 0 && !/^ *-/.test(lines[i]);
    if (left >= indent && !opens && !(at < indent)) continue;
    const key = /([^\s:]+):/.exec(lines[i]);
    if (opens && key) found.splice(0, found.length, key[1]);
    path.unshift(...found);
    indent = left;
  }
  // Braces: each opens a place for keys, each comma forgets the one before.
  let rest = here.rest;
  let keyed = here.keyed;
  const stack = [];
  let word = "";
  for (const letter of rest.replace(/"[^"]*"|'[^']*'/g, "")) {
    if (letter === "{" || letter === "[") {
      stack.push(path.length);
      if (letter === "[") path.push(0);
      keyed = letter === "[";
      word = "";
    } else if (letter === "}" || letter === "]") {
      path.length = stack.pop() || 0;
      keyed = true;
      word = "";
    } else if (letter === ",") {
      const start = stack[stack.length - 1] || 0;
      keyed = path[start] === 0 && typeof path[start] === "number";
      path.length = start + (keyed ? 1 : 0);
      word = "";
    } else if (letter === ":" && !keyed) {
      path.push(word.trim());
      keyed = true;
      word = "";
    } else {
      word += letter;
    }
  }
  return {path, keyed, word: word.trim()};
}

/** What may be written at the end of a text: keys with what they are for, or words of a list. */
function wordsFor(schema, text) {
  const {path, keyed, word} = pathTo(text);
  const places = path.reduce(below, alternatives(schema));
  const found = new Map();
  for (const place of places) {
    if (!keyed) for (const [key, {description}] of Object.entries(place.properties || {})) found.set(key, {text: `${key}: `, displayText: key, description});
    else for (const value of place.enum || []) found.set(value, {text: String(value), displayText: String(value)});
  }
  return {word, words: [...found.values()].filter(({displayText}) => displayText.toLowerCase().startsWith(word.toLowerCase()))};
}

// --------------------------------------------------------------------------------------- one live case

/** The texts that were written, by case. */
const liveTexts = new Map();
let live = null;

/** Milliseconds of a run and its pictures that follow every change, and of the longest pause before one that takes longer. */
const kShortRun = 500;
const kLongestPause = 1500;

const kStale = "Not run; the pictures are of the last text that was.";

/** Limits of the slider of a number: from nothing to its double. */
const sliderLimits = (value) => (value === 0 ? [-1, 1] : [Math.min(0, 2 * value), Math.max(0, 2 * value)]);

class Live {
  constructor(bench) {
    this.core = bench;
    this.files = JSON.parse(find("live-files").textContent);
    this.sliders = new Map();
    this.rows = make("div", {class: "sliders"});
    this.messages = make("ul", {class: "live-messages", "aria-live": "polite"});
    this.state = make("p", {class: "soft", id: "live-state"});
    const place = make("div", {class: "editor"});
    const save = (name, type, content) => () => offer(`${this.name()}${name}`, new Blob([content()], {type}));
    const button = (words, title, action) => make("button", {type: "button", title, onclick: action}, words);
    this.element = make("section", {id: "live", "aria-labelledby": "live-title"},
        make("h3", {id: "live-title"}, "Change the case"),
        make("div", {class: "live-parts"}, place, make("div", {class: "live-side"}, this.rows, this.state, this.messages,
            make("p", {class: "live-tools"}, button("As it was", "The text that the page came with", () => this.editor.setValue(this.original())),
                 button("Save the case", "The text, as a YAML file", save(".yaml", "text/yaml", () => this.editor.getValue())),
                 button("Save its rows", "What 'slipbench run' writes (CSV)", save(".csv", "text/csv", () => this.savedRows()))))));
    // As the element of an editor has its editor.
    this.element.live = this;
    this.editor = CodeMirror(place, {mode: "yaml", lineNumbers: true, lineWrapping: true, gutters: ["faults", "CodeMirror-linenumbers"], indentUnit: 2, tabSize: 2, viewportMargin: Infinity,
                                     extraKeys: {"Ctrl-Space": () => this.complete(), Tab: false, "Shift-Tab": false}});
    this.editor.getInputField().setAttribute("aria-label", "The case file; Ctrl and Space complete a word");
    this.editor.on("change", () => {
      if (this.opening) return;
      liveTexts.set(view.one.id, this.editor.getValue());
      this.later();
    });
    this.editor.on("inputRead", (_, change) => { if (/^[\w{, ]$/.test(change.text[0])) this.complete(); });
  }

  name() { return view.one.name.split("/").pop(); }
  original() { return (view.one.original || (view.one.run || {}).text) || ""; }

  /** Gives the core the data files of a case. */
  putFiles(one) {
    for (const [name, text] of Object.entries(this.files[cases.indexOf(one)] || {})) this.core.put(name, text);
  }

  /** Shows the text of the case that the page shows. */
  open(one) {
    if (one.original === undefined) one.original = (one.run || {}).text || "";
    this.sliders.clear();
    this.rows.replaceChildren();
    clearTimeout(this.pause);
    this.putFiles(one);
    this.opening = true;
    this.editor.setValue(liveTexts.get(one.id) || one.original);
    this.opening = false;
    this.element.hidden = one.original === "";
    if (!this.element.hidden) this.run();
  }

  complete() {
    if (this.editor.state.completionActive && this.editor.state.completionActive.widget) return;
    this.editor.showHint({
      completeSingle: false,
      hint: () => {
        const to = this.editor.getCursor();
        const {word, words} = wordsFor(this.core.schema, this.editor.getRange({line: 0, ch: 0}, to));
        const list = words.map((one) => ({...one, render: (element) => element.append(make("b", {}, one.displayText), make("span", {class: "soft"}, one.description ? ` ${one.description}` : ""))}));
        return {list, from: {line: to.line, ch: to.ch - word.length}, to};
      }
    });
  }

  /** Runs when the browser draws next, or, where a run takes long, when no more is typed for as long: of many changes the last counts. */
  later() {
    clearTimeout(this.pause);
    if (this.took > kShortRun) {
      this.state.textContent = "Runs when you stop for a moment.";
      this.pause = setTimeout(() => this.run(), Math.min(this.took, kLongestPause));
      return;
    }
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.run();
    });
  }

  run() {
    this.pause = 0;
    if (this.starting) return;
    const {one} = view;
    const text = this.editor.getValue();
    const begin = performance.now();
    let answer;
    try {
      answer = this.core.run(`${this.name()}.yaml`, text);
    } catch (error) {
      this.took = performance.now() - begin;
      this.restart(error, text);
      return;
    }
    const ran = performance.now();
    const [fresh] = answer.document.cases;
    const refused = fresh.status === "not_run";
    this.tell(answer.messages, refused && answer.messages.every(({severity}) => severity !== "error") ? fresh.message : "");
    this.slide(answer.parameters);
    find("case").classList.toggle("stale", refused);
    if (!refused) this.show(one, fresh);
    this.took = performance.now() - begin;
    this.state.textContent = refused ? kStale : `${plural(one.increments, "increment")}, run in ${number(ran - begin, 2)} ms, drawn in ${number(this.took - (ran - begin), 2)} ms`;
  }

  /** Starts another core in place of one that failed (memory, depth of calls), and runs what is there by then, if it is another text. */
  async restart(error, text) {
    this.starting = true;
    find("case").classList.add("stale");
    this.tell([], `The bench cannot run this text: ${error.message || error}`);
    this.state.textContent = kStale;
    try {
      this.core = await startCore();
    } catch (fault) {
      this.tell([], `The bench has ended, and does not start again: ${fault.message || fault}; load the page again`);
      return;
    }
    this.starting = false;
    this.putFiles(view.one);
    if (this.editor.getValue() !== text) this.run();
  }

  /** The rows as 'slipbench run' writes them, or nothing. */
  savedRows() {
    const text = this.editor.getValue();
    try {
      return this.core.rows(`${this.name()}.yaml`, text);
    } catch (error) {
      this.restart(error, text);
      return "";
    }
  }

  /** Puts another run into the case that is shown. */
  show(one, fresh) {
    const {id, name, original} = one;
    const {definition} = view;
    const now = view.time();
    for (const key of Object.keys(one)) delete one[key];
    Object.assign(one, fresh, {id, name, original});
    view.definition = sameDefinition(one, definition);
    view.event = null;
    view.setTimes();
    view.setPlaces(nearestRow(view.times[0], now));
    const section = find("pictures") && find("pictures").closest("section");
    for (const picture of pictures.filter((other) => !section || !section.contains(other.element))) picture.destroy();
    layOut(one, section || pictureSection(), section ? redrawPictures : drawPictures);
  }

  /** Messages, each with its line, which a click goes to. */
  tell(messages, failure) {
    const {editor} = this;
    editor.clearGutter("faults");
    for (const mark of editor.getAllMarks()) mark.clear();
    const items = messages.map(({severity, line, column, length, path, message, hint}) => {
      const said = `${path ? `${path}: ` : ""}${message}${hint ? `; ${hint}` : ""}`;
      if (line === 0 || line > editor.lineCount()) return make("li", {class: severity}, make("b", {}, `${severity}: `), quoted(said));
      const from = {line: line - 1, ch: column - 1};
      if (severity !== "note") {
        editor.setGutterMarker(line - 1, "faults", make("span", {class: `fault ${severity}`, title: said}, "\u25cf"));
        editor.markText(from, {line: line - 1, ch: column - 1 + Math.max(length, 1)}, {className: `fault-text ${severity}`, title: said});
      }
      const go = () => { editor.setCursor(from); editor.focus(); };
      return make("li", {class: severity}, make("button", {type: "button", onclick: go}, `line ${line}`), ` ${severity}: `, quoted(said));
    });
    if (failure) items.push(make("li", {class: "error"}, make("pre", {}, failure)));
    this.messages.replaceChildren(...items);
  }

  /** A slider for each parameter that is a number; it writes into the text. */
  slide(parameters) {
    const names = new Set(parameters.map(({name}) => name));
    // Of a text that cannot be read no place is known to write to.
    const unread = parameters.length === 0 && this.messages.querySelector(".error") !== null;
    for (const {slider} of this.sliders.values()) slider.disabled = unread;
    if (unread) return;
    for (const [name, {row}] of this.sliders) {
      if (names.has(name)) continue;
      row.remove();
      this.sliders.delete(name);
    }
    for (const place of parameters) {
      const {name, value} = place;
      if (!this.sliders.has(name)) {
        const slider = make("input", {type: "range", id: `slider-${name}`, step: "any", oninput: () => this.write(name, Number(slider.value))});
        const told = make("output", {for: slider.id});
        const row = make("div", {class: "slider"}, make("label", {for: slider.id}, quoted(name)), slider, told);
        this.sliders.set(name, {row, slider, told});
        this.rows.append(row);
      }
      const entry = this.sliders.get(name);
      entry.mark = this.mark({line: place.line - 1, ch: place.column - 1}, place.length);
      if (entry.limits === undefined || value < entry.limits[0] || value > entry.limits[1]) {
        entry.limits = sliderLimits(value);
        [entry.slider.min, entry.slider.max] = entry.limits;
      }
      if (Number(entry.slider.value) !== value && document.activeElement !== entry.slider) entry.slider.value = value;
      entry.told.textContent = String(value);
    }
  }

  /** Marks a number, so that its place is known whatever is typed before it. */
  mark(from, length) { return this.editor.markText(from, {line: from.line, ch: from.ch + length}, {className: "live-number"}); }

  /** Writes a number where the text has that of a parameter. */
  write(name, wanted) {
    const entry = this.sliders.get(name);
    const place = entry.mark.find();
    if (entry.slider.disabled || !place || Number.isNaN(parseFloat(this.editor.getRange(place.from, place.to)))) return;
    const digits = Math.max(0, 2 - Math.floor(Math.log10((entry.limits[1] - entry.limits[0]) / 2)));
    const text = String(Number(wanted.toFixed(Math.min(digits, 100))));
    this.editor.replaceRange(text, place.from, place.to, "+slider");
    entry.mark.clear();
    entry.mark = this.mark(place.from, text.length);
  }
}

/** A text that came with the page's address takes the place of the first case's. */
function addressedText() {
  const found = /^#text=(.*)$/s.exec(location.hash);
  if (!found) return;
  let text = "";
  try {
    text = decodeURIComponent(found[1]);
  } catch {
    return;  // cut off on its way
  }
  Object.assign(cases[0], {name: "case", original: text});
  show(cases[0]);
}

async function startLive() {
  // In a frame of another page the case is all.
  document.body.classList.toggle("framed", window !== window.top);
  const main = find("case");
  const stage = make("div", {id: "stage"});
  main.replaceWith(stage);
  stage.append(main);
  try {
    live = new Live(await startCore());
  } catch (error) {
    stage.prepend(make("p", {class: "facts"}, `The bench does not run in this browser: ${error.message}`));
    return;
  }
  stage.prepend(live.element);
  const showCase = show;
  show = (one) => { showCase(one); live.open(one); };
  addressedText();
  if (view && !live.editor.getValue()) live.open(view.one);
  live.editor.refresh();
}
startLive();
