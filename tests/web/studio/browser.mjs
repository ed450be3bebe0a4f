// Shared by the tests of the page: a server for it, a browser, and how to look at the machine.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { extname, join, resolve } from "node:path";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".json": "application/json" };

// How long anything may take, in ms: no clock, but the end of a wait on a machine that is very busy.
const PATIENCE = 150_000;

export async function start(bundled, page) {
  if (!existsSync(join(bundled, "node_modules", "playwright-core")) || !existsSync(join(page, "index.html"))) {
    console.log("skipped: npm could not get its packages");
    process.exit(77);
  }
  const require = createRequire(resolve(bundled) + "/"), { chromium } = require("playwright-core");
  const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
  const server = createServer((request, reply) => {
    const name = new URL(request.url, "http://here").pathname.slice(1) || "index.html", file = join(page, name);
    if (name.includes("..") || !existsSync(file)) return reply.writeHead(404).end();
    reply.writeHead(200, { "Content-Type": TYPES[extname(name)] ?? "text/plain" }).end(readFileSync(file));
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const address = `http://127.0.0.1:${server.address().port}/`;
  const flags = ["--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
  if (process.getuid() === 0) flags.push("--no-sandbox"); // a browser's own cage needs a user other than root
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: flags });
  return { browser, address, axe, stop: async () => { await browser.close(); server.close(); } };
}

// Opens Studio in a profile of its own; all that goes wrong there is kept in page.faults.
export async function open({ browser, address }, options = {}, hash = "") {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  page.faults = [];
  page.on("pageerror", (error) => page.faults.push(error.message));
  page.on("console", (line) => line.type() === "error" && page.faults.push(line.text()));
  page.on("request", (request) => !request.url().startsWith(address) && !/^(data|blob):/.test(request.url()) && page.faults.push("asked for " + request.url()));
  await page.goto(address + hash);
  await page.locator("#tools button").first().waitFor({ state: "attached" });
  await until(page, () => !document.body.inert);
  return page;
}

export async function close(page) {
  assert.deepEqual(page.faults, []);
  await page.context().close();
}

export const text = (page) => page.evaluate(() => Array.from(document.querySelectorAll(".cm-line"), (line) => line.textContent).join("\n"));
// Replaces the file as a person does: everything selected, and the new text put in.
export async function write(page, content) {
  await page.click("#tab-text");
  await page.click(".cm-content");
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText(content);
}
// How far a body is turned on the canvas, degrees.
export const turn = (page, body) => page.evaluate((name) => {
  const found = document.querySelector(`#scene [data-body="${name}"]`)?.transform.baseVal.getItem(0).matrix;
  return found ? (Math.atan2(found.b, found.a) * 180) / Math.PI : null;
}, body);
export const until = async (page, what, ...values) => page.waitForFunction(what, values.length > 1 ? values : values[0], { timeout: PATIENCE });
export const bodies = (page, count) => until(page, (n) => new Set(Array.from(document.querySelectorAll("#scene [data-body]"), (one) => one.dataset.body)).size >= n, count);
export const joints = (page, name) => until(page, (one) => document.querySelector(".cm-content").textContent.includes(`${one}: {pin`), name);
export const moves = async (page, body, from) => until(page, ([name, before]) => {
  const found = document.querySelector(`#scene [data-body="${name}"]`)?.transform.baseVal.getItem(0).matrix;
  return found && Math.abs((Math.atan2(found.b, found.a) * 180) / Math.PI - before) > 1;
}, body, from);

// Runs tests one after the other (those whose name contains `only`, if it is given), reports how each went, and ends the process.
export async function runTests(world, tests, only) {
  let failed = 0;
  for (const [name, test] of Object.entries(tests)) {
    if (only && !name.includes(only)) continue;
    const begun = Date.now();
    try {
      await test();
      console.log(`ok - ${name} (${((Date.now() - begun) / 1000).toFixed(1)} s)`);
    } catch (error) {
      failed++;
      console.log(`not ok - ${name}\n${error.stack}`);
    }
  }
  await world.stop();
  process.exit(failed ? 1 : 0);
}
