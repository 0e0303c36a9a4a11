// Holds the result documents of two builds against each other, number by number.
//   bash tests/results/write.sh OLD_PROGRAM old; bash tests/results/write.sh build/graze new
//   node tests/compare_results.mjs old new [--tolerance 1e-9]
// Documents must have the same shape: keys, kinds, ends, counts, outcomes and exit codes. Numbers may differ by
// the tolerance, relative to the larger of the two; numbers that are rounding beside the others of their column
// (1e-13 of its largest) are not compared. Computing times and counts of evaluations are effort, not results:
// they are left out. Tables, printed text, scripts of pictures and data of pages must be the same to the last
// character. Prints a line for every difference and exits with 1 if there is one.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

const effort = /^(seconds|seconds_per_period|evaluations|evaluations_per_period|starts|residual|version|iterations)$/;
const roundingShare = 1e-13;

function* leaves(value, path = "", column = "") {
  if (Array.isArray(value)) {
    yield { path: `${path}.length`, column: `${column}.length`, value: value.length };
    for (const [i, item] of value.entries()) yield* leaves(item, `${path}[${i}]`, `${column}[]`);
  } else if (value !== null && typeof value === "object") {
    for (const [key, item] of Object.entries(value)) {
      if (!effort.test(key)) yield* leaves(item, path ? `${path}.${key}` : key, column ? `${column}.${key}` : key);
    }
  } else {
    yield { path, column, value };
  }
}

function columnSizes(...lists) {
  const sizes = new Map();
  for (const { column, value } of lists.flat()) {
    if (typeof value === "number") sizes.set(column, Math.max(sizes.get(column) ?? 0, Math.abs(value)));
  }
  return sizes;
}

// Of numbers: the difference relative to the larger one; of anything else 0 if equal, infinite if not.
function difference(a, b, size) {
  if (Object.is(a, b) || a === b) return 0;
  if (typeof a !== "number" || typeof b !== "number") return Infinity;
  const apart = Math.abs(a - b);
  return apart <= roundingShare * size ? 0 : apart / Math.max(Math.abs(a), Math.abs(b));
}

function compare(name, old, now, tolerance) {
  const before = [...leaves(old)], after = new Map([...leaves(now)].map((leaf) => [leaf.path, leaf]));
  const sizes = columnSizes(before, [...after.values()]);
  const worst = new Map();
  const note = (column, apart, line) => {
    const known = worst.get(column) ?? { apart: 0, count: 0 };
    worst.set(column, { apart: Math.max(apart, known.apart), count: known.count + 1, line: apart > known.apart ? line : known.line });
  };
  for (const { path, column, value } of before) {
    const other = after.get(path);
    after.delete(path);
    if (!other) {
      note(column, Infinity, `${path}: ${JSON.stringify(value)} is gone`);
      continue;
    }
    const apart = difference(value, other.value, sizes.get(column));
    if (apart > (column.endsWith(".length") ? 0 : tolerance)) {
      note(column, apart, `${path}: ${JSON.stringify(value)} is now ${JSON.stringify(other.value)}`);
    }
  }
  for (const { path, column, value } of after.values()) note(column, Infinity, `${path}: ${JSON.stringify(value)} is new`);
  for (const [, { apart, count, line }] of worst) {
    const size = apart === Infinity ? "" : ` (relative ${apart.toExponential(1)})`;
    console.log(`${name}: ${line}${size}${count > 1 ? `, the largest of ${count} in its column` : ""}`);
  }
  return worst.size;
}

// Of the files that a command wrote beside its document: the first line of each that differs.
function compareFiles(name, old, now) {
  const list = (folder) => (existsSync(folder) ? readdirSync(folder) : []);
  let differences = 0;
  for (const file of new Set([...list(old), ...list(now)])) {
    const [before, after] = [old, now].map((folder) => (existsSync(join(folder, file)) ? readFileSync(join(folder, file), "utf8").split("\n") : null));
    const say = (text) => { ++differences; console.log(`${name}/${file}: ${text}`); };
    if (!before || !after) { say(before ? "is gone" : "is new"); continue; }
    const at = before.findIndex((line, i) => line !== after[i]);
    if (at < 0 && before.length === after.length) continue;
    const i = at < 0 ? before.length : at;
    // Of long lines the part from the first difference on.
    const [was, is] = [before[i] ?? "", after[i] ?? ""];
    let from = 0;
    while (from < was.length && was[from] === is[from]) ++from;
    const part = (line) => line.slice(Math.max(0, from - 60), from + 100);
    say(`line ${i + 1}: "${part(was)}" is now "${part(is)}"`);
  }
  return differences;
}

const [oldFolder, newFolder, option, given] = process.argv.slice(2);
if (!newFolder || (option && option !== "--tolerance")) {
  console.error("usage: node tests/compare_results.mjs OLD NEW [--tolerance 1e-9]");
  process.exit(2);
}
const tolerance = option ? Number(given) : 1e-9;
const read = (folder, file) => readFileSync(join(folder, file), "utf8");
const names = readdirSync(oldFolder).filter((file) => file.endsWith(".json")).map((file) => file.slice(0, -5));
let differences = 0;
for (const name of names) {
  const documents = [oldFolder, newFolder].map((folder) => ({
    code: Number(read(folder, `${name}.code`)), ...JSON.parse(read(folder, `${name}.json`) || "{}") }));
  differences += compare(name, ...documents, tolerance);
  differences += compareFiles(name, join(oldFolder, name), join(newFolder, name));
}
console.log(`${names.length} documents, ${differences} columns or files that differ (numbers by more than ${tolerance})`);
process.exit(differences > 0 ? 1 : 0);
