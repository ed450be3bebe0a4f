// How quick Studio is, printed; nothing is asserted but that it moves. node test_speed.mjs BUNDLED PAGE [PART OF A NAME]
// Times are of the processor, as the browser's own trace counts them, so that what else runs on the machine matters little.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { deflateRawSync } from "node:zlib";
import { open, close, runTests, start, until } from "./browser.mjs";
import { chainOf, rowOf } from "./crowds.mjs";

const world = await start(process.argv[2], process.argv[3]);
const KINDS = { script: ["FunctionCall", "FireAnimationFrame", "EvaluateScript", "TimerFire", "EventDispatch", "HandlePostMessage", "RunMicrotasks", "V8.GCScavenger", "MinorGC", "MajorGC"], layout: ["UpdateLayoutTree", "Layout", "HitTest"], paint: ["PrePaint", "Paint", "Layerize", "Commit", "UpdateLayer", "CompositeLayers"] };

// Records what the page's threads do meanwhile; returns the events.
async function traced(page, work) {
  const session = await page.context().browser().newBrowserCDPSession(), events = [];
  session.on("Tracing.dataCollected", ({ value }) => events.push(...value));
  await session.send("Tracing.start", { transferMode: "ReportEvents", traceConfig: { includedCategories: ["devtools.timeline", "blink.user_timing", "v8", "toplevel", "disabled-by-default-devtools.timeline"] } });
  await work();
  const done = new Promise((resolve) => session.once("Tracing.tracingComplete", resolve));
  await session.send("Tracing.end");
  await done;
  await session.detach();
  return events;
}

// Sums the outermost events of some kinds, ms: processor time if the browser reports it.
function sumOf(events, names) {
  let end = -Infinity, sum = 0;
  for (const one of events.filter((event) => names.includes(event.name) && event.ph === "X").sort((a, b) => a.ts - b.ts)) {
    if (one.ts < end) continue;
    end = one.ts + one.dur;
    sum += (one.tdur ?? one.dur) / 1000;
  }
  return sum;
}

function told(events) {
  const renderers = new Map();
  for (const one of events) if (one.name === "FireAnimationFrame") renderers.set(one.pid, (renderers.get(one.pid) ?? 0) + 1);
  const pid = [...renderers].sort((a, b) => b[1] - a[1])[0]?.[0], own = events.filter((one) => one.pid === pid);
  const main = own.find((one) => one.name === "FireAnimationFrame")?.tid, mine = own.filter((one) => one.tid === main);
  const workers = [...new Set(own.filter((one) => one.name === "FunctionCall" || one.name === "HandlePostMessage").map((one) => one.tid))].filter((tid) => tid !== main);
  const core = workers.map((tid) => sumOf(own.filter((one) => one.tid === tid), KINDS.script)).reduce((a, b) => a + b, 0);
  if (process.env.SPEED_DETAIL) for (const name of [...KINDS.script, ...KINDS.layout, ...KINDS.paint]) console.log(`    ${name} ${sumOf(mine, [name]).toFixed(1)} ms in ${mine.filter((one) => one.name === name).length}`);
  return { core, ...Object.fromEntries(Object.entries(KINDS).map(([kind, names]) => [kind, sumOf(mine, names)])) };
}

const poses = (page) => page.evaluate(() => { window.poses ??= 0; return window.poses; });
const print = (what, { core, script, layout, paint }, count) =>
  console.log(`${what}: ${((core + script + layout + paint) / count).toFixed(2)} ms (core ${(core / count).toFixed(2)}, script ${(script / count).toFixed(2)}, layout ${(layout / count).toFixed(2)}, paint ${(paint / count).toFixed(2)}; ${count} poses)`);

// Counts the poses that come from the core.
const counting = () => {
  const Own = Worker;
  window.poses = 0;
  window.Worker = class extends Own {
    set onmessage(take) { super.onmessage = (event) => { if (event.data.value?.bodies) window.poses++; take(event); }; }
    get onmessage() { return super.onmessage; }
  };
};

async function opened(text) {
  const page = await open(world);
  await page.addInitScript(counting);
  await page.reload();
  await until(page, () => !document.body.inert);
  await page.setInputFiles("#file", { name: "crowd.yaml", mimeType: "text/yaml", buffer: Buffer.from(text) });
  await until(page, () => !document.querySelector("#motion").hidden);
  await page.waitForTimeout(3000);
  await page.locator("#canvas").focus();
  return page;
}

async function played(what, text) {
  const page = await opened(text);
  await page.keyboard.press("Space");
  await until(page, () => window.poses > 12);
  let before = 0, after = 0;
  const events = await traced(page, async () => {
    before = await poses(page);
    await page.waitForTimeout(4000);
    after = await poses(page);
  });
  assert.ok(after > before, "it plays");
  print(what, told(events), after - before);
  await close(page);
}

// The first drawing that can be dragged, from the address on: by the clock of the page, so the machine should be idle.
async function firstDrawing() {
  const file = readFileSync(new URL("../../../examples/four-bar.yaml", import.meta.url), "utf8"), times = [];
  for (let k = 0; k < 5; k++) {
    const context = await world.browser.newContext({ viewport: { width: 1280, height: 800 } }), page = await context.newPage();
    await page.addInitScript(() => {
      new MutationObserver(() => { if (window.drawn === undefined && document.querySelector("#scene [data-body]")) window.drawn = performance.now(); }).observe(document, { childList: true, subtree: true });
    });
    await page.goto(`${world.address}#m=1.${deflateRawSync(JSON.stringify(["four-bar", file])).toString("base64url")}`);
    await until(page, () => window.drawn !== undefined);
    times.push(await page.evaluate(() => window.drawn));
    await context.close();
  }
  console.log(`the first drawing: ${Math.min(...times).toFixed(0)} ms after the address, the best of ${times.length}`);
}

const tests = {
  "the first drawing": firstDrawing,
  "playing 1,000 links in a row of parallelograms": () => played("playing 1,000 links (row), a frame", rowOf(1000)),
  "playing a chain of 1,000 links": () => played("playing 1,000 links (chain), a frame", chainOf(1000)),
  "playing 100 links": () => played("playing 100 links (row), a frame", rowOf(100)),
  async "dragging 100 links"() {
    const page = await opened(chainOf(100)), box = await page.locator("#canvas").boundingBox();
    const at = await page.evaluate(() => { const all = document.querySelectorAll('#scene [data-body="b99"] circle'), one = all[all.length - 1].getBoundingClientRect(); return [one.x + one.width / 2, one.y + one.height / 2]; });
    await page.mouse.move(...at);
    await page.mouse.down();
    await page.mouse.move(at[0] - 8, at[1] + 8);
    let before = 0, after = 0;
    const events = await traced(page, async () => {
      before = await poses(page);
      for (let k = 0; k < 60; k++) {
        const had = await poses(page);
        await page.mouse.move(at[0] - 8 - k * 2, Math.min(box.y + box.height - 20, at[1] + 8 + k));
        await until(page, (n) => window.poses > n, had);
      }
      after = await poses(page);
    });
    await page.mouse.up();
    print("dragging the end of 100 links, a pointer event", told(events), after - before);
    await close(page);
  },
};

await runTests(world, tests, process.argv[4]);
