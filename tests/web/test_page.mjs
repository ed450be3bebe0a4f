// The report in a real browser: its slider moves the machine to where the engine says, its keys and boxes work, nothing
// is fetched, nobody is shut out. node test_page.mjs YOKE FOLDER, where FOLDER holds node_modules and pictures are left.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const [, , yoke, folder] = process.argv;
const require = createRequire(resolve(folder) + "/");
if (!existsSync(join(folder, "node_modules", "playwright-core"))) {
  console.log("skipped: npm could not get its packages");
  process.exit(77);
}
const { chromium } = require("playwright-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const examples = join(fileURLToPath(import.meta.url), "../../../examples");
const work = mkdtempSync(join(tmpdir(), "yoke-page-"));
const arguments_ = ["--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync"];
if (process.getuid() === 0) arguments_.push("--no-sandbox"); // a browser's own cage needs a user other than root
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: arguments_ });

const run = (...words) => execFileSync(yoke, words, { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"], maxBuffer: 1 << 27 });
const machine = (name) => join(examples, name + ".yaml");

async function open(name, options = {}) {
  const file = join(work, name + ".html");
  run("report", machine(name), "-o", file);
  const page = await browser.newPage({ viewport: { width: 1000, height: 800 }, ...options });
  page.setDefaultTimeout(150_000); // no clock, but the end of a wait on a machine that is very busy
  page.faults = [];
  page.on("pageerror", (error) => page.faults.push(error.message));
  page.on("console", (line) => line.type() === "error" && page.faults.push(line.text()));
  page.on("request", (request) => request.url() !== "file://" + file && !request.url().startsWith("data:") &&
    page.faults.push("asked for " + request.url()));
  await page.goto("file://" + file);
  await page.locator("#controls").waitFor();
  return page;
}

async function close(page) {
  assert.deepEqual(page.faults, []);
  await page.close();
}

const shown = (page, column) => page.locator(`#readout [data-column="${column}"]`).textContent().then(Number);
const axisNow = (page) => page.locator("#now").textContent().then((text) => Number(text.match(/= (\S+)/)[1]));
const near = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a} is not ${b}`);

// Where the middle of the k-th circle of a body's group stands on the page of the drawing.
const pinAt = (page, group) => page.evaluate((name) => {
  const circle = Array.from(document.querySelectorAll(`#stage g.${name} circle`)).at(-1), svg = circle.ownerSVGElement;
  const point = new DOMPoint(circle.cx.baseVal.value, circle.cy.baseVal.value);
  const at = point.matrixTransform(svg.getCTM().inverse().multiply(circle.getCTM()));
  return [at.x, at.y];
}, group);

const tests = {
  async "the slider moves the machine to where the engine says"() {
    const page = await open("gas-engine");
    const scale = await page.evaluate(() => JSON.parse(document.getElementById("data").textContent).bodies[1].center);
    let before = null;
    for (const row of [5, 30, 77, 131]) {
      await page.locator("#slider").fill(String(row));
      const theta = await axisNow(page);
      const answer = JSON.parse(run("sweep", machine("gas-engine"), "--over", `theta=0:${theta}deg`, "--steps", "1", "--of",
        "x,x.rate,rod.A.x,rod.A.y,rod.B.x,rod.B.y", "--format", "json"));
      const [x, rate, ax, ay, bx, by] = answer.rows[1].slice(1);
      near(await shown(page, "x"), 1000 * x, 1e-3, "x");
      near(await shown(page, "x.rate"), 1000 * rate, 1e-1, "x.rate");
      // the crank's pin and the piston's, in metres by the scale that both give
      const crank = await pinAt(page, "b2"), piston = await pinAt(page, "b3");
      const pixels = Math.hypot(crank[0] - piston[0], crank[1] - piston[1]) / Math.hypot(ax - bx, ay - by);
      if (before) near(pixels, before, 1e-3 * before, "px per metre");
      before = pixels;
      near(crank[0] - scale[0], pixels * ax, 0.05, "A.x on the page");
      near(scale[1] - crank[1], pixels * ay, 0.05, "A.y on the page");
    }
    await close(page);
  },
  async "a simulation is shown as it was computed"() {
    const page = await open("double-pendulum");
    await page.locator("#slider").fill("120");
    const t = await axisNow(page);
    const answer = JSON.parse(run("simulate", machine("double-pendulum"), "--to", `${t}s`, "--steps", "1", "--of", "theta1,theta2", "--format", "json"));
    const last = answer.rows.at(-1);
    near(await shown(page, "theta1"), (last[1] * 180) / Math.PI, 1e-2, "theta1"); // t is told to six digits
    near(await shown(page, "theta2"), (last[2] * 180) / Math.PI, 1e-2, "theta2");
    await close(page);
  },
  async "it plays, pauses and steps by keys"() {
    const page = await open("quick-return");
    near(await axisNow(page), 30, 1e-3, "it opens at the start");
    await page.locator("h1").click();
    await page.keyboard.press("Space");
    await page.waitForTimeout(300);
    assert.equal(await page.locator("#play").textContent(), "Pause");
    await page.keyboard.press("Space");
    const stopped = await axisNow(page);
    assert.ok(Math.abs(stopped - 30) > 1e-3);
    await page.waitForTimeout(100);
    assert.equal(await axisNow(page), stopped);
    await page.locator("#slider").focus();
    await page.keyboard.press("Home");
    const first = await axisNow(page);
    await page.keyboard.press("ArrowRight");
    assert.notEqual(await axisNow(page), first);
    await page.keyboard.press("ArrowLeft");
    assert.equal(await axisNow(page), first);
    await close(page);
  },
  async "paths and arrows can be shown and hidden"() {
    const page = await open("gas-engine");
    const visible = (selector) => page.locator(selector).evaluateAll((all) => all.filter((e) => getComputedStyle(e).display !== "none").length);
    const paths = await visible("#stage .trace");
    assert.ok(paths > 0);
    await page.locator("#shows input").first().uncheck();
    assert.equal(await visible("#stage .trace"), paths - 1);
    assert.equal(await visible("#stage .arrow"), 0);
    await page.getByRole("checkbox", { name: "velocities" }).check();
    await page.getByRole("checkbox", { name: "forces" }).check();
    await page.locator("#slider").fill("40");
    // the arrow at the crank's pin is square to the crank, as its velocity is
    const arrow = await page.evaluate(() => document.querySelector("#stage .arrow.velocity").getAttribute("d").match(/-?[\d.]+/g).map(Number));
    const centre = await page.evaluate(() => JSON.parse(document.getElementById("data").textContent).bodies[1].center);
    const along = [arrow[2] - arrow[0], arrow[3] - arrow[1]], crank = [arrow[0] - centre[0], arrow[1] - centre[1]];
    near((along[0] * crank[0] + along[1] * crank[1]) / Math.hypot(...along) / Math.hypot(...crank), 0, 5e-3, "cosine");
    await close(page);
  },
  async "diagrams are drawn, and hovering over one moves the machine"() {
    const page = await open("quick-return");
    await page.locator(".plot canvas").nth(5).waitFor();
    await page.locator(".u-over").first().scrollIntoViewIfNeeded();
    const box = await page.locator(".u-over").first().boundingBox();
    await page.mouse.move(box.x + box.width - 2, box.y + 20);
    await page.mouse.move(box.x + 2, box.y + 20);
    await page.waitForTimeout(100);
    const left = await axisNow(page);
    await page.mouse.move(box.x + 0.75 * box.width, box.y + 20);
    await page.waitForTimeout(100);
    assert.ok(Math.abs((await axisNow(page)) - left) > 50);
    await close(page);
  },
  async "nothing keeps anybody out (axe), light and dark, wide and narrow"() {
    for (const [name, options] of [["gas-engine", {}], ["quick-return", { colorScheme: "dark" }],
      ["gearbox-8hp70", { viewport: { width: 390, height: 800 } }], ["valve-cam", { colorScheme: "dark", viewport: { width: 390, height: 800 } }]]) {
      const page = await open(name, options);
      await page.locator(".plot canvas").first().waitFor();
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.ok(wide <= 0, `${name} is ${wide} px too wide`);
      await page.evaluate(axe);
      // formulas are many and all alike: one stands for them
      await page.evaluate(() => document.querySelectorAll("math").forEach((formula, k) => k > 0 && formula.remove()));
      const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
      assert.deepEqual(violations.map((v) => `${name}: ${v.id} (${v.impact}) ${v.nodes[0].html}`), []);
      await page.screenshot({ path: join(folder, `report-${name}.png`), fullPage: false });
      await close(page);
    }
  },
  // What stands before the first picture in the page is all that has to be read before it is seen; a first paint took 90 to 180 ms.
  async "the page is seen before its script runs"() {
    const page = await open("quick-return");
    const paint = await page.evaluate(() => new Promise((done) => {
      const known = performance.getEntriesByName("first-contentful-paint")[0];
      if (known) done(known.startTime);
      new PerformanceObserver((list) => done(list.getEntries()[0].startTime)).observe({ type: "paint", buffered: true });
    }));
    console.log(`  first paint after ${Math.round(paint)} ms`);
    const { before, scripts } = await page.evaluate(() => {
      const text = document.documentElement.outerHTML, head = document.head.outerHTML;
      return { before: text.indexOf("<svg"), scripts: [...head.matchAll(/<script(?![^>]*type="application\/json")/g)].length };
    });
    assert.ok(before > 0 && before < 65536, `${before} bytes before the first picture`);
    assert.equal(scripts, 0);
    await close(page);
  },
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  const start = performance.now();
  try {
    await test();
    console.log(`ok ${name} (${((performance.now() - start) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failed++;
    console.log(`FAILED ${name}\n${error.stack}`);
  }
}
await browser.close();
rmSync(work, { recursive: true });
console.log(`${Object.keys(tests).length - failed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
