// SPDX-License-Identifier: Apache-2.0
// same_rows.cjs CORE SLIPBENCH CASE..: runs cases in the core of the page and in the program, and compares the rows that both
// write, byte by byte. Rows that differ are told with how far: libm is not the same. Exit: 0 no number is further off than
// kFarthest of the largest of its column, 1 one is, or a case runs on one side only.
"use strict";
const fs = require("fs");
const os = require("os");
const path = require("path");
const {execFileSync} = require("child_process");

const kFarthest = 1e-9;

async function startCore(file) {
  const program = await require(path.resolve(file))({wasmBinary: fs.readFileSync(file.replace(/\.js$/, ".wasm"))});
  const coreCalls = new Function(`${fs.readFileSync(path.join(__dirname, "../../live/call.js"), "utf8")} return coreCalls;`)();
  return {program, call: coreCalls(program)};
}

/** The largest difference of two tables of numbers, in parts of the largest number of its column; infinite if they are no such. */
function distance(one, other) {
  const table = (text) => text.split("\n").filter((line) => line !== "" && !line.startsWith("#")).map((line) => line.split(","));
  const [a, b] = [table(one), table(other)];
  if (a.length !== b.length || a[0].join() !== b[0].join()) return {far: Infinity};
  let worst = {far: 0};
  a[0].forEach((name, c) => {
    const largest = b.slice(1).reduce((most, row) => Math.max(most, Math.abs(Number(row[c])) || 0), 0);
    for (let r = 1; r < a.length; ++r) {
      if (a[r][c] === b[r][c]) continue;
      // A column of what rounding left of zero has no digits in common.
      const off = Math.abs(Number(a[r][c]) - Number(b[r][c])) / (largest > 1e-9 ? largest : 1);
      if (!(off <= worst.far)) worst = {far: Number.isNaN(off) ? Infinity : off, name, row: r, wasm: a[r][c], native: b[r][c]};
    }
  });
  return worst;
}

async function main([core, slipbench, ...cases]) {
  const {program, call} = await startCore(core);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "rows-"));
  let same = 0, off = 0, failed = 0;
  for (const one of cases) {
    const name = path.basename(one);
    // The core has no files but those it is given.
    for (const beside of fs.readdirSync(path.dirname(one))) {
      if (beside.endsWith(".csv")) program.FS.writeFile(beside, fs.readFileSync(path.join(path.dirname(one), beside)));
    }
    let native = "";
    try {
      execFileSync(slipbench, ["run", one, "-q", "--force", "-o", folder], {stdio: "ignore"});
    } catch (error) {
      if (error.status !== 1) native = null;
    }
    if (native !== null) native = fs.readFileSync(path.join(folder, name.replace(/\.yaml$/, ".csv")), "utf8");
    const rows = call("csv", name, fs.readFileSync(one, "utf8")) || null;
    if (rows !== null && rows === native) {
      ++same;
      continue;
    }
    const {far, name: column, row, wasm, native: wanted} = rows === null || native === null ? {far: Infinity} : distance(rows, native);
    if (far <= kFarthest) ++off;
    else ++failed;
    console.log(`${name}: ` + (far === Infinity ? `${rows === null ? "not run" : "run"} in the core, ${native === null ? "not run" : "run"} by the program`
                                                 : far === 0 ? "other words before the same rows" : `off by ${far.toExponential(1)}, ${column} in row ${row}: ${wasm}, the program's is ${wanted}`));
  }
  fs.rmSync(folder, {recursive: true});
  console.log(`${cases.length} cases: ${same} the same bytes, ${off} within ${kFarthest}, ${failed} not`);
  return failed > 0 ? 1 : 0;
}

main(process.argv.slice(2)).then((code) => process.exit(code));
