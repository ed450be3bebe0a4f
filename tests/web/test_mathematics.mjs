// Every formula of every example: KaTeX takes the LaTeX, and the MathML is valid and shows in a real browser; without
// YOKE_FULL KaTeX takes every second example, and the browser is shown every sixth.
// node test_mathematics.mjs YOKE FOLDER, where FOLDER holds node_modules.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const [, , yoke, folder] = process.argv;
const require = createRequire(resolve(folder) + "/");
if (!["katex", "playwright-core"].every((name) => existsSync(join(folder, "node_modules", name)))) {
  console.log("skipped: npm could not get its packages");
  process.exit(77);
}
const katex = require("katex");
const { chromium } = require("playwright-core");
const examples = join(fileURLToPath(import.meta.url), "../../../examples");

// What `derive` says of an example in a format; "" where the example does not close at its start.
function derive(name, format) {
  try {
    return execFileSync(yoke, ["derive", join(examples, name), "-q", "--numbers", "--format", format],
      { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"], maxBuffer: 1 << 28 });
  } catch (error) {
    assert.equal(error.status, 1, `${name}: ${format}`);
    return "";
  }
}
const names = readdirSync(examples).filter((name) => name.endsWith(".yaml")).sort();

// --- LaTeX

const take = (formula) => katex.renderToString(formula, { displayMode: true, throwOnError: true, strict: "error" });

const known = new Set(); // the page mostly repeats what is in the JSON

function takeAll(name) {
  const json = derive(name, "json"), page = derive(name, "latex");
  const formulas = json ? JSON.parse(json).sections.flatMap((section) => section.items).flatMap((item) => item.latex ?? []) : [];
  const shown = [...page.matchAll(/\\\[\n(.*?)\n\\\]|(\\begin\{multline\*\}.*?\\end\{multline\*\})/gs)]
    .map((found) => found[1] ?? found[2].replaceAll("multline*", "gathered").replaceAll("\\\\[-2pt]", "\\\\"));
  const legends = shown.filter((formula) => /^(\\begin\{gathered\}\n)?\\boxed\{\d+\} = /.test(formula)); // below a formula: what boxes stand for
  assert.equal(shown.length - legends.length, formulas.length, name);
  for (const formula of new Set([...formulas, ...shown])) {
    if (known.has(formula)) continue;
    known.add(formula);
    try {
      take(formula);
    } catch (error) {
      assert.fail(`${name}: KaTeX refuses ${formula.slice(0, 300)}\n${error.message}`);
    }
  }
  return formulas.length;
}

// --- MathML

// In the page: what is wrong with its formulas. Presentation MathML (MathML Core): known elements, as many children as
// each takes, words only in tokens, and a place on the page for all that is not empty.
function faults() {
  const arity = { mfrac: 2, msub: 2, msup: 2, msubsup: 3, mover: 2, munder: 2, munderover: 3 };
  const tokens = ["mi", "mn", "mo", "mtext"], others = ["math", "mrow", "msqrt", "mtable", "mtr", "mtd", "mspace", "mpadded", "mstyle"];
  const within = { mtr: "mtable", mtd: "mtr" }, found = [];
  let shown = 0;
  for (const element of document.querySelectorAll("math, math *")) {
    const tag = element.localName, say = (what) => found.push(`${what}: ${element.outerHTML.slice(0, 200)}`);
    if (element.namespaceURI !== "http://www.w3.org/1998/Math/MathML") say("not MathML");
    if (!tokens.includes(tag) && !others.includes(tag) && !(tag in arity)) say("unknown element");
    if (tag in arity && element.children.length !== arity[tag]) say("wrong number of children");
    if (within[tag] && element.parentElement.localName !== within[tag]) say("in the wrong place");
    if (tokens.includes(tag) ? element.children.length > 0 : [...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim()))
      say("words outside of tokens");
    const box = element.getBoundingClientRect();
    const isInvisible = tag === "mo" && ["\u2061", "\u2062"].includes(element.textContent); // applied to; times
    const isEmpty = tokens.includes(tag) ? isInvisible || !element.textContent.trim() : tag === "mspace" || element.children.length === 0;
    if ((tag === "math" || tokens.includes(tag)) && isEmpty && !isInvisible) say("empty");
    if (!isEmpty && !(box.width > 0 && box.height > 0)) say("not shown");
    shown += tag === "math";
  }
  return { found: found.slice(0, 5), shown };
}

async function show(page, name) {
  const html = derive(name, "mathml");
  if (!html) return 0;
  await page.setContent(html);
  const seen = await page.evaluate(faults);
  assert.deepEqual(seen.found, [], name);
  assert.equal(seen.shown, html.match(/<math/g)?.length ?? 0, name);
  return seen.shown;
}

const arguments_ = ["--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync"];
if (process.getuid() === 0) arguments_.push("--no-sandbox"); // a browser's own cage needs a user other than root
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: arguments_ });
const every = process.env.YOKE_FULL ? 1 : 2;
let taken = 0, shown = 0;
try {
  const page = await browser.newPage();
  for (const [k, name] of names.entries()) {
    if (k % every === 0) taken += takeAll(name);
    if (k % (3 * every) === 0 || every === 1) shown += await show(page, name);
  }
} finally {
  await browser.close();
}
console.log(`KaTeX takes ${taken} formulas, Chromium shows ${shown}`);
assert.ok(taken > 2000 / every && shown > 2000 / (3 * every));
