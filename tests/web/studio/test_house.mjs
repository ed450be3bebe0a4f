// The house rules of Studio: the page knows no mechanics, its words stand in one file, and its first drawing is small.
// node test_house.mjs SOURCES PAGE
import assert from "node:assert/strict";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join, relative } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";

const [, , sources, page] = process.argv;
// View files: where points stand on the screen.
const VIEWS = new Set(["canvas/frames.ts", "canvas/view.ts"]);
const FIRST = ["index.html", "studio.css", "studio.js", "worker.js", "core.wasm"]; // what the first drawing needs
const LIMIT = 441 * 1024; // the contract asks for 450 KB; this keeps it from growing

const files = (folder) => readdirSync(folder, { withFileTypes: true, recursive: true }).filter((entry) => entry.isFile()).map((entry) => join(entry.parentPath, entry.name));
const scripts = files(join(sources, "src")).filter((name) => name.endsWith(".ts"));
const own = (name) => relative(join(sources, "src"), name);

test("outside the view files nothing calls sin, cos, atan2, hypot", () => {
  const found = scripts.filter((name) => !VIEWS.has(own(name)) && /\b(sin|cos|tan|atan2?|asin|acos|hypot)\s*\(/.test(readFileSync(name, "utf8").replace(/"[^"\n]*"|`[^`]*`/g, "")));
  assert.deepEqual(found.map(own), []);
  for (const view of VIEWS) assert.ok(existsSync(join(sources, "src", view)), `${view} is on the list and not there`);
});

test("nothing writes HTML from strings, and nothing evaluates them", () => {
  const found = scripts.filter((name) => /innerHTML|outerHTML|insertAdjacentHTML|document\.write|\beval\(|new Function|srcdoc/.test(readFileSync(name, "utf8")));
  assert.deepEqual(found.map(own), []);
  const parsers = scripts.filter((name) => readFileSync(name, "utf8").includes("DOMParser"));
  assert.deepEqual(parsers.map(own), ["markup.ts"]);
});

test("nothing is fetched from elsewhere", () => {
  const found = [...scripts, join(sources, "index.html"), join(sources, "sw.js")].filter((name) => /["'(]https?:\/\/(?!www\.w3\.org\/)/.test(readFileSync(name, "utf8")));
  assert.deepEqual(found.map(own), []);
  const policy = readFileSync(join(sources, "index.html"), "utf8").match(/Content-Security-Policy" content="([^"]*)"/)[1];
  assert.match(policy, /default-src 'none'/);
  assert.match(policy, /script-src 'self' 'wasm-unsafe-eval';/);
});

test("files are short and say what they are for", () => {
  for (const name of scripts) {
    const lines = readFileSync(name, "utf8").split("\n");
    assert.match(lines[0], name.endsWith(".d.ts") ? /./ : /^\/\/ [A-Z]/, own(name));
    assert.ok(lines.length <= 260, `${own(name)} has ${lines.length} lines`);
  }
});

test("the first drawing needs no more than it does today, compressed", { skip: !existsSync(join(page, "studio.js")) && "there is no page" }, () => {
  const sizes = FIRST.map((name) => [name, gzipSync(readFileSync(join(page, name)), { level: 9 }).length]);
  const sum = sizes.reduce((total, [, size]) => total + size, 0);
  console.log(sizes.map(([name, size]) => `${name} ${(size / 1024).toFixed(1)} KB`).join(", "), `- ${(sum / 1024).toFixed(1)} KB`);
  assert.ok(sum <= LIMIT, `${sum} bytes`);
});
