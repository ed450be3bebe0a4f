// Design in a real browser: a curve drawn by hand, places of a body set by hand, a coupler point dragged. node test_design.mjs BUNDLED PAGE [PART OF A NAME]
import assert from "node:assert/strict";
import { bodies, close, open, runTests, start, text, until } from "./browser.mjs";

const world = await start(process.argv[2], process.argv[3]);
const isFull = Boolean(process.env.YOKE_FULL);
const chooseExample = async (page, id) => {
  await page.click("#examples");
  await page.click(`dialog [data-example="${id}"]`);
  await bodies(page, 2);
  await page.waitForTimeout(500); // the view is fitted
};
const trace = (page) => page.evaluate(() => document.querySelector(".trace")?.getAttribute("points") ?? "");
const dyads = (page) => page.evaluate(() => Array.from(document.querySelectorAll(".dyad"), (line) => ["x1", "y1", "x2", "y2"].map((name) => Number(line.getAttribute(name)))));
const searched = (page) => page.locator("#panel-design .cards[aria-busy=false]").waitFor();

const tests = {
  async "a curve is drawn by hand: linkages come, one is taken, its point passes the curve as near as told, and undo brings the old file back"() {
    const page = await open(world);
    await chooseExample(page, "four-bar");
    const before = await text(page);
    await page.keyboard.press("Escape");
    await page.click("#tab-design");
    await page.click("#panel-design .strong");
    const at = (k) => [420 + 150 * Math.cos(0.12 * k), 380 + 70 * Math.sin(0.12 * k)];
    await page.mouse.move(...at(0));
    await page.mouse.down();
    for (let k = 1; k < 50; k++) await page.mouse.move(...at(k));
    await page.mouse.up();
    const left = Date.now();
    await page.locator("#panel-design .card img").first().waitFor();
    if (isFull) console.log(`the first linkage stands there ${Date.now() - left} ms after the stroke`);
    await page.locator("#panel-design .cards[aria-busy=false]").waitFor();
    assert.ok(await page.evaluate(() => Array.from(document.querySelectorAll("#panel-design img"), (one) => one.complete && one.naturalWidth > 0).every(Boolean)));
    assert.equal(await text(page), before, "a search writes nothing into the file");
    const [, worst] = (await page.textContent("#panel-design .card")).match(/off by ([\d.]+) mm at most/);
    await page.click("#panel-design .card");
    await until(page, () => document.querySelector(".cm-content").textContent.includes("coupler: {points: {A: [0, 0], B: [b, 0], P:") && document.querySelectorAll(".trace").length === 1);
    await page.waitForTimeout(300);
    // The trace and the points of the curve as the canvas shows them; a millimetre from the task's own points.
    const far = await page.evaluate(() => {
      const line = document.querySelector(".trace").getAttribute("points").split(" ").map((one) => one.split(",").map(Number));
      const dots = Array.from(document.querySelectorAll(".wanted-point"), (one) => [Number(one.getAttribute("cx")), Number(one.getAttribute("cy"))]);
      const written = document.querySelector("#panel-design textarea").value.match(/points: \[([^:]*)\]/)[1].match(/[-\d.]+/g).map(Number);
      const scale = Math.hypot(dots[6][0] - dots[0][0], dots[6][1] - dots[0][1]) / Math.hypot(written[12] - written[0], written[13] - written[1]);
      const reach = ([x, y]) => Math.min(...line.slice(1).map(([u, v], k) => {
        const [p, q] = line[k], [dx, dy] = [u - p, v - q], part = Math.max(0, Math.min(1, ((x - p) * dx + (y - q) * dy) / (dx * dx + dy * dy || 1)));
        return Math.hypot(p + part * dx - x, q + part * dy - y);
      }));
      return { dots: dots.length, worst: Math.max(...dots.map(reach)) / scale, pixel: 1 / scale };
    });
    assert.equal(far.dots, 12);
    assert.ok(far.worst <= Number(worst) + 0.5 * far.pixel, `${JSON.stringify(far)} against ${worst} mm`);
    await page.click("#undo");
    await until(page, (old) => document.querySelector(".cm-content").textContent.includes(old), "Four-bar");
    assert.equal(await text(page), before);
    await page.click("#panel-design summary");
    await page.fill("#panel-design textarea", "synthesis: path\npoints: [[0, 0], [1, nonsense]]\n");
    await page.click("#panel-design .small");
    await until(page, () => /curve.yaml:2:\d+: error: .*nonsense/.test(document.querySelector("#panel-design .note").textContent));
    await page.fill("#panel-design textarea", `synthesis: path\npoints: [${Array.from({ length: 200 }, (_, k) => `[${k % 7}, ${(k * k) % 11}]`)}]\n`);
    await page.click("#panel-design .small");
    await page.click("#panel-design >> text=Stop");
    await until(page, () => document.querySelector("#panel-design .note").textContent.startsWith("Stopped"));
    assert.equal(await page.locator("#panel-design progress").isHidden(), true);
    // Linkages appear while the search runs, and stay when it is stopped: a tenth of it done, at most.
    await page.fill("#panel-design textarea", `synthesis: path\npoints: ${JSON.stringify(Array.from({ length: 40 }, (_, k) => [40 * Math.cos(0.157 * k) + 6 * Math.sin(0.6 * k), 20 * Math.sin(0.157 * k)]))}\nbest: 5\n`);
    await page.click("#panel-design .small");
    await page.locator("#panel-design .card").first().waitFor();
    await page.click("#panel-design >> text=Stop");
    await until(page, () => document.querySelector("#panel-design .note").textContent.startsWith("Stopped: the best so far"));
    const kept = await page.locator("#panel-design .card").count();
    assert.ok(kept > 0 && kept <= 5, String(kept));
    await page.locator("#panel-design .card img").first().waitFor();
    await page.click("#panel-design .card");
    await until(page, () => document.querySelector(".cm-content").textContent.includes("Found by"));
    await close(page);
  },
  async "a coupler point is dragged: machine and curve follow while it is held, the file is written once, and undo brings it back"() {
    const page = await open(world);
    await chooseExample(page, "four-bar");
    const before = await text(page), [x, y] = await page.evaluate(() => {
      const box = Array.from(document.querySelectorAll('#scene [data-body="coupler"] circle'), (one) => one.getBoundingClientRect()).sort((a, b) => a.y - b.y)[0]; // P is above A and B
      return [box.x + box.width / 2, box.y + box.height / 2];
    });
    await page.locator("#canvas").focus();
    await page.keyboard.press("r");
    await page.mouse.move(x, y);
    await page.mouse.down();
    await until(page, () => document.querySelectorAll(".trace").length === 1);
    const curves = new Set([await trace(page)]);
    for (let k = 1; k <= 3; k++) {
      const last = await trace(page);
      await page.mouse.move(x + 25 * k, y - 20 * k);
      await until(page, (old) => document.querySelector(".trace").getAttribute("points") !== old, last);
      curves.add(await trace(page));
    }
    assert.equal(curves.size, 4);
    assert.equal(await text(page), before, "a point that is held writes nothing");
    // The curve passes the point that is held.
    const far = await page.evaluate(([px, py]) => {
      const stage = document.querySelector("#canvas").getBoundingClientRect(), line = document.querySelector(".trace").getAttribute("points").split(" ").map((one) => one.split(",").map(Number));
      return Math.min(...line.map(([u, v]) => Math.hypot(u + stage.left - px, v + stage.top - py)));
    }, [x + 75, y - 60]);
    assert.ok(far < 12, `${far} px`); // the grid, and half a step of the curve
    await page.mouse.up();
    await until(page, (old) => document.querySelector(".cm-content").textContent.includes(old) === false, "P: [b/2, b/4]");
    const written = await text(page);
    assert.equal(written.replace(/P: \[[-\d.]+, [-\d.]+\]/, "P: [b/2, b/4]"), before);
    await page.click("#undo");
    await until(page, (old) => document.querySelector(".cm-content").textContent.includes(old), "P: [b/2, b/4]");
    assert.equal(await text(page), before);
    // Esc gives a point back that is held.
    await page.waitForTimeout(300);
    const still = await trace(page);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 30, y - 30, { steps: 2 });
    await until(page, (old) => document.querySelector(".trace").getAttribute("points") !== old, still);
    await page.keyboard.press("Escape");
    await until(page, (old) => document.querySelector(".trace").getAttribute("points") === old, still);
    await page.mouse.up();
    assert.equal(await text(page), before);
    await close(page);
  },
  async "places of a body are set by hand: links of one length reach them all, follow a place that is dragged, and a linkage is taken"() {
    const page = await open(world);
    await page.locator("#canvas").focus();
    await page.keyboard.press("i");
    await page.locator("#panel-design").waitFor();
    // The five poses of the issue, 90 px a metre: four links reach them.
    const [ox, oy, scale] = [330, 560, 90], arm = 200, poses = [[0, 0, 0], [0.5, 1, 20], [1.5, 1.5, 35], [2.5, 1.25, 40], [3, 0.5, 30]];
    await page.keyboard.down("Alt");
    for (const [px, py, degrees] of poses) {
      const at = [ox + scale * px, oy - scale * py], turn = (degrees * Math.PI) / 180;
      await page.mouse.click(...at);
      await page.mouse.click(at[0] + arm * Math.cos(turn), at[1] - arm * Math.sin(turn));
    }
    await page.keyboard.up("Alt");
    await until(page, () => document.querySelectorAll(".pose-at").length === 5 && document.querySelectorAll(".dyad").length === 20);
    const even = async () => {
      const links = new Map();
      for (const [x1, y1, x2, y2] of await dyads(page)) links.set(`${x1} ${y1}`, [...(links.get(`${x1} ${y1}`) ?? []), Math.hypot(x2 - x1, y2 - y1)]);
      for (const lengths of links.values()) assert.ok(Math.max(...lengths) - Math.min(...lengths) < 0.3, lengths.join(" ")); // px, drawn to a tenth
      return [...links.keys()];
    };
    const pivots = await even();
    assert.equal(pivots.length, 4);
    await searched(page);
    assert.match(await page.textContent("#panel-design .note"), /4 links reach all places/);
    const found = await page.locator("#panel-design .card").count();
    assert.ok(found > 0);
    await page.mouse.move(ox + 3 * scale, oy - 0.5 * scale);
    await page.mouse.down();
    await page.mouse.move(ox + 3 * scale + 9, oy - 0.5 * scale + 6, { steps: 3 });
    // While it is held the links follow; those of the place before last till they do.
    await until(page, ([first, count]) => {
      const now = Array.from(document.querySelectorAll(".dyad"), (line) => `${line.getAttribute("x1")} ${line.getAttribute("y1")}`);
      return now.length > 0 && (!now.includes(first) || now.length !== count);
    }, pivots[0], 20);
    for (let k = 0; k < 100; k++) {
      if (await even().then(() => true, () => false)) break;
      await page.waitForTimeout(100);
    }
    assert.notDeepEqual(await even(), pivots);
    await page.mouse.up();
    await searched(page);
    await even();
    await page.locator("#panel-design .card").first().click();
    await until(page, () => document.querySelector(".cm-content").textContent.includes("Found by"));
    assert.equal(await page.locator("#problems .error").count(), 0);
    await page.click("#tab-design");
    await page.click("#panel-design >> text=Clear");
    await until(page, () => document.querySelectorAll(".pose-at, .dyad, .pivot").length === 0);
    await close(page);
  },
};

await runTests(world, tests, process.argv[4]);
