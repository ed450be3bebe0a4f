// Studio in a real browser: draws, moves, mends, shares. node test_page.mjs BUNDLED PAGE
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { bodies, close, joints, moves, open, runTests, start, text, turn, until, write } from "./browser.mjs";

const world = await start(process.argv[2], process.argv[3]);
const isFull = Boolean(process.env.YOKE_FULL);
const chooseExample = async (page, id) => {
  await page.click("#examples");
  await page.click(`dialog [data-example="${id}"]`);
  await bodies(page, 2);
};
const pinNow = (page, body, last) => page.evaluate(([name, isLast]) => {
  const circles = Array.from(document.querySelectorAll(`#scene [data-body="${name}"] circle`)), box = circles.at(isLast ? -1 : 0).getBoundingClientRect();
  return [box.x + box.width / 2, box.y + box.height / 2];
}, [body, last]);
// Where the pin is once the view rests: it is fitted after the machine is drawn.
async function pinAt(page, body, last = true) {
  let at = await pinNow(page, body, last);
  for (let same = 0; same < 3;) {
    await page.waitForTimeout(100);
    const now = await pinNow(page, body, last);
    same = Math.hypot(now[0] - at[0], now[1] - at[1]) < 0.5 ? same + 1 : 0;
    at = now;
  }
  return at;
}

async function goTo(page, key, point) {
  for (let k = 0; k < 12 && !(await page.textContent("#said")).endsWith(point); k++) await page.keyboard.press(key);
  assert.ok((await page.textContent("#said")).endsWith(point), await page.textContent("#said"));
}

const tests = {
  async "a four-bar is drawn by mouse and turns; undone to the beginning, and done again"() {
    const page = await open(world);
    await page.click("#invite .strong");
    const places = [[300, 500], [350, 400], [560, 340], [500, 500]];
    for (const [x, y] of places) await page.mouse.click(x, y);
    await bodies(page, 3);
    await page.keyboard.press("Escape");
    await page.keyboard.press("g");
    await page.mouse.click(...places[0]);
    await joints(page, "A");
    await page.mouse.click(...places[3]);
    await joints(page, "D");
    await page.keyboard.press("m");
    await page.mouse.click(...places[0]);
    await until(page, () => document.querySelector(".cm-content").textContent.includes("drives:"));
    await page.keyboard.press("v");
    await page.locator("#lacks").waitFor({ state: "hidden" });
    await page.keyboard.press("Space");
    await moves(page, "bar1", 0);
    await moves(page, "bar3", 0);
    await page.keyboard.press("Space");
    const drawn = await text(page);
    for (let k = 0; k < 30 && !(await page.locator("#undo").isDisabled()); k++) await page.keyboard.press("Control+z");
    await until(page, () => document.querySelector(".cm-content").textContent === "");
    for (let k = 0; k < 30 && !(await page.locator("#redo").isDisabled()); k++) await page.keyboard.press("Control+y");
    await bodies(page, 3);
    assert.equal(await text(page), drawn);
    await close(page);
  },
  async "the same by keyboard alone"() {
    const page = await open(world);
    await page.locator("#canvas").focus();
    const press = async (...keys) => { for (const key of keys) await page.keyboard.press(key); };
    const move = async (key, count) => { for (let k = 0; k < count; k++) await page.keyboard.press(key); };
    await press("b", "ArrowRight", "Enter");
    await move("ArrowUp", 6);
    await press("Enter");
    await bodies(page, 1);
    await move("ArrowRight", 20);
    await move("ArrowUp", 4);
    await press("Enter");
    await bodies(page, 2);
    for (const letter of "110 mm -90 deg") await page.keyboard.press(letter === " " ? "Space" : letter);
    await page.keyboard.press("Enter");
    await bodies(page, 3);
    const [, points] = (await text(page)).match(/bar3: \{points: (.*)\}\}/);
    const [, ax, ay, bx, by] = points.match(/\[([-\d.]+), ([-\d.]+)\].*\[([-\d.]+), ([-\d.]+)\]/).map(Number);
    assert.equal(ax, bx);
    assert.ok(Math.abs(ay - by - 110) < 0.2, points); // as typed, to what the view can show
    await press("Escape", "g", "n", "Enter");
    await joints(page, "A");
    await goTo(page, "Shift+N", "bar3.D");
    await press("Enter");
    await joints(page, "D");
    await press("m");
    await goTo(page, "n", "bar1.A");
    await press("Enter");
    await until(page, () => document.querySelector(".cm-content").textContent.includes("drives:"));
    await press("v", "Space");
    await moves(page, "bar1", 0);
    await close(page);
  },
  async "a broken file is told at its place and mended by the offered hint"() {
    const page = await open(world);
    await chooseExample(page, "four-bar");
    const good = await text(page);
    await write(page, good.replace("[crank, coupler]", "[crnak, coupler]"));
    await page.locator("#problems .error").waitFor();
    assert.match(await page.textContent("#problems"), /crnak/);
    assert.ok((await page.locator(".cm-lintRange-error").count()) > 0);
    await page.click("#problems .small");
    await page.locator("#problems").waitFor({ state: "hidden" });
    assert.equal(await text(page), good);
    await close(page);
  },
  async "a parameter's slider changes the machine at once and the file once; comments stay"() {
    const page = await open(world);
    await chooseExample(page, "four-bar");
    const before = await text(page), turned = await turn(page, "rocker");
    await page.click("#tab-parts");
    const slider = page.locator(`input[aria-label="Slider of b"]`), box = await slider.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.55 * box.width, box.y + box.height / 2, { steps: 4 });
    await moves(page, "rocker", turned);
    assert.equal(await text(page), before, "a slider that is held writes nothing");
    await page.mouse.up();
    await until(page, (old) => !document.querySelector(".cm-content").textContent.includes(old), "b: 120,");
    const value = (await text(page)).match(/b: ([\d.]+), c: 80/);
    assert.ok(Number(value[1]) > 125 && Number(value[1]) < 140, value[0]);
    assert.equal((await text(page)).replace(value[0], "b: 120, c: 80"), before);
    await page.click("#undo");
    await until(page, (old) => document.querySelector(".cm-content").textContent.includes(old), "b: 120,");
    assert.equal(await text(page), before);
    await close(page);
  },
  async "a point is dragged: the machine follows, tells its limit, and stands there after a reload"() {
    const page = await open(world);
    await chooseExample(page, "rocking-four-bar");
    const before = await turn(page, "left"), [x, y] = await pinAt(page, "coupler");
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let k = 1; k <= 40; k++) await page.mouse.move(x - 5 * k, y + 12 * k);
    await moves(page, "left", before);
    await until(page, () => document.getElementById("said").classList.contains("shown"));
    assert.match(await page.textContent("#said"), /does not close/);
    await page.mouse.up();
    await page.reload();
    await bodies(page, 2);
    assert.match(await text(page), /rock/i);
    await close(page);
  },
  async "arrows: velocities at right angles to a crank, then accelerations, then forces with a legend; longer by hand"() {
    const page = await open(world);
    await chooseExample(page, "watt-with-masses");
    await page.keyboard.press("Escape");
    const arrows = () => page.evaluate(() => Array.from(document.querySelectorAll(".arrows line"), (line) => ["x1", "y1", "x2", "y2"].map((name) => Number(line.getAttribute(name)))));
    await page.click("#arrows-turn");
    await until(page, () => document.querySelectorAll(".arrows line").length > 2);
    const [first] = await arrows(), [ax, ay] = await page.evaluate(([x, y]) => { // the crank's pin on the ground: the circle of AB farthest from the arrow
      const { left, top } = document.querySelector("#canvas").getBoundingClientRect();
      const places = Array.from(document.querySelectorAll('#scene [data-body="AB"] circle'), (one) => one.getBoundingClientRect()).map((box) => [box.x + box.width / 2 - left, box.y + box.height / 2 - top]);
      return places.sort((p, q) => Math.hypot(q[0] - x, q[1] - y) - Math.hypot(p[0] - x, p[1] - y))[0];
    }, first), crank = [first[0] - ax, first[1] - ay];
    const [dx, dy] = [first[2] - first[0], first[3] - first[1]], cosine = (dx * crank[0] + dy * crank[1]) / Math.hypot(dx, dy) / Math.hypot(...crank);
    assert.ok(Math.abs(cosine) < 0.02, `${cosine}`);
    assert.match(await page.textContent("#arrows"), /Velocities[\d.]+ m\/s$/);
    await page.click("#arrows button >> nth=1");
    await until(page, (long) => { const line = document.querySelector(".arrows line"); return Math.abs(line.getAttribute("x2") - line.getAttribute("x1")) > long; }, 1.4 * Math.abs(dx));
    for (const unit of ["m/s²", "N"]) {
      await page.click("#arrows-turn");
      await until(page, (one) => document.querySelector("#arrows output").textContent.endsWith(" " + one), unit);
    }
    await until(page, () => document.querySelectorAll(".arrows line").length > 4);
    await page.click("#arrows-turn");
    await until(page, () => document.querySelectorAll(".arrows line").length === 0 && document.querySelector("#arrows").hidden);
    await close(page);
  },
  async "exports a PNG"() {
    const page = await open(world);
    await chooseExample(page, "four-bar");
    await page.click("#export");
    const take = async (id) => {
      const [file] = await Promise.all([page.waitForEvent("download"), page.click(`[data-export="${id}"]`)]);
      return readFileSync(await file.path());
    };
    const png = await take("png");
    assert.equal(png.subarray(1, 4).toString(), "PNG");
    assert.ok(png.length > 5000, `${png.length} bytes`);
    await close(page);
  },
  async "a link carries the machine to another profile, letter by letter"() {
    const page = await open(world);
    await chooseExample(page, "quick-return");
    const own = await text(page);
    await page.click("#share");
    const link = await page.inputValue("dialog .link");
    assert.match(link, /#m=1\.[A-Za-z0-9_-]+$/);
    await close(page);
    const other = await open(world, {}, link.slice(link.indexOf("#")));
    await bodies(other, 5);
    assert.equal(await text(other), own);
    assert.ok(Math.abs((await turn(other, "crank")) - 30) < 1e-9);
    await close(other);
  },
  async "a hostile link does no harm"() {
    const page = await open(world);
    const evil = `"><script>document.title=1</script><img src=x onerror=document.title=1>`;
    await write(page, `name: '${evil}'\nbodies:\n  '${evil}': {points: {'<b>A': [0, 0], B: [1, 0]}}\n  b: {points: {B: [0, 0]}}\njoints:\n  '<script>document.title=2</script>': {pin: [ground, b], at: B}\n`);
    await page.waitForTimeout(500);
    await page.click("#tab-parts");
    await page.click("#tab-equations");
    await page.waitForTimeout(1500);
    assert.equal(await page.title(), "Yoke Studio");
    assert.equal(await page.locator("#scene script, #stage img, #panel script, #panel img, [onerror]").count(), 0);
    await close(page);
    for (const hash of ["#m=1.AAAA", "#m=9.x", "#m=1." + "A".repeat(200_000)]) {
      const broken = await open(world, {}, hash);
      await until(broken, () => /could not be read/.test(document.getElementById("said").textContent));
      await close(broken);
    }
    const deep = await open(world);
    await write(deep, "a: ".padEnd(20_000, "[")); // more than the stack of the colours' parser holds
    await deep.locator("#problems .error").waitFor();
    await close(deep);
  },
  async "a false equation is refuted and a true one proved"() {
    const page = await open(world);
    await chooseExample(page, "four-bar");
    await page.click("#tab-equations");
    await page.locator(".formulas math").first().waitFor();
    const check = async (equation, kind) => {
      await page.fill("#panel-equations input", equation);
      await page.keyboard.press("Enter");
      await page.locator(`.verdict.${kind}`).waitFor();
    };
    await check("a*cos(theta2) + b*cos(theta2 + gamma) - c*cos(theta4) - d = 0", "true");
    await check("a*cos(theta2) + b*cos(theta2 + gamma) + c*cos(theta4) - d = 0", "false");
    await close(page);
  },
  async "on a phone the machine stays in sight as the panel folds and the window turns, and where the hand put it"() {
    const page = await open(world, { viewport: { width: 390, height: 844 } });
    await chooseExample(page, "jansen");
    // How much of the drawing lies beyond the free part of the stage, px, and how much of that it fills.
    const look = () => page.evaluate(() => {
      const box = (id) => document.getElementById(id).getBoundingClientRect(), stage = box("stage"), motion = box("motion");
      const marks = Array.from(document.querySelectorAll("#scene [data-body] circle"), (one) => one.getBoundingClientRect()).map((one) => new DOMRect(one.x + one.width / 2, one.y + one.height / 2));
      const high = Math.max(...marks.map((one) => one.bottom)) - Math.min(...marks.map((one) => one.top)), wide = Math.max(...marks.map((one) => one.right)) - Math.min(...marks.map((one) => one.left));
      const out = Math.max(...marks.flatMap((one) => [stage.left - one.left, one.right - stage.right, stage.top - one.top, one.bottom - motion.top]));
      return { out, fills: Math.max(high / (motion.top - stage.top), wide / stage.width), wide };
    });
    const isSeen = async () => {
      const good = (one) => one.out <= 0 && one.fills > 0.55;
      for (let k = 0; k < 600 && !good(await look()); k++) await page.waitForTimeout(50);
      assert.ok(good(await look()), JSON.stringify(await look()));
    };
    await isSeen();
    const before = (await look()).wide;
    await page.click("#tab-text");
    await page.locator("#panel-text").waitFor({ state: "hidden" });
    await isSeen();
    await page.setViewportSize({ width: 844, height: 390 });
    await isSeen();
    await page.setViewportSize({ width: 390, height: 844 });
    await page.click("#tab-text");
    await page.locator("#panel-text").waitFor();
    await isSeen();
    assert.ok(Math.abs((await look()).wide / before - 1) < 0.25); // names of the drawing leave it more or less room
    const fitted = (await look()).wide;
    await page.mouse.move(200, 250);
    await page.mouse.wheel(0, -100);
    for (let k = 0; k < 600 && (await look()).wide < 1.2 * fitted; k++) await page.waitForTimeout(50);
    const zoomed = (await look()).wide;
    await page.click("#tab-text");
    await page.locator("#panel-text").waitFor({ state: "hidden" });
    await page.waitForTimeout(300);
    assert.ok(zoomed > 1.2 * fitted && Math.abs((await look()).wide - zoomed) < 2, "a view zoomed by hand keeps its scale");
    await close(page);
  },
  async "axe finds nothing, in light and dark, wide and narrow"() {
    const kinds = [{}, { colorScheme: "dark", viewport: { width: 390, height: 844 } }, ...(isFull ? [{ colorScheme: "dark" }, { viewport: { width: 390, height: 844 } }] : [])];
    for (const kind of kinds) {
      const page = await open(world, kind), views = isFull ? ["text", "parts", "diagrams", "equations", "design", "command"] : kind.viewport ? ["text"] : ["parts", "diagrams", "design"];
      const look = async (view) => {
        await page.evaluate(world.axe);
        const found = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
        assert.deepEqual(found.violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`), [], `${view} ${JSON.stringify(kind)}`);
      };
      await look("empty");
      await chooseExample(page, "four-bar");
      for (const view of views) {
        await page.click(`#tab-${view}`);
        await page.waitForTimeout(300);
        await look(view);
      }
      await close(page);
    }
  },
};

const full = {
  async "axe finds nothing in dialogs, beside places set by hand, arrows and other assemblies"() {
    for (const kind of [{}, { colorScheme: "dark", viewport: { width: 390, height: 844 } }]) {
      const page = await open(world, kind), look = async (view) => {
        await page.waitForTimeout(300);
        await page.evaluate(world.axe);
        const found = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
        assert.deepEqual(found.violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`), [], `${view} ${JSON.stringify(kind)}`);
      };
      await chooseExample(page, "four-bar");
      for (const id of ["examples", "export", "help", "share"]) {
        await page.click(`#${id}`);
        await page.locator("dialog").waitFor();
        await look(id);
        await page.keyboard.press("Escape");
        await page.locator("dialog").waitFor({ state: "detached" });
      }
      await page.locator("#canvas").focus();
      await page.keyboard.press("a");
      await page.keyboard.press("o");
      await look("arrows and assemblies");
      await page.keyboard.press("i");
      for (const key of ["ArrowRight", "Enter", "ArrowUp", "Enter"]) await page.keyboard.press(key); // a place by keys alone
      for (let k = 0; k < 6; k++) await page.keyboard.press("ArrowLeft");
      for (const key of ["Enter", "ArrowRight", "Enter"]) await page.keyboard.press(key);
      await until(page, () => document.querySelectorAll(".pose-at").length === 2);
      await page.locator("#panel-design .cards[aria-busy=false]").waitFor({ state: "attached" });
      await look("places");
      await close(page);
    }
  },
  async "by touch on a phone: drags, pinches, draws"() {
    const page = await open(world, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    await page.tap("#invite .strong");
    for (const [x, y] of [[80, 300], [120, 220], [280, 200]]) await page.touchscreen.tap(x, y);
    await bodies(page, 2);
    await close(page);
  },
  async "it works without a network after the first visit"() {
    const page = await open(world);
    await page.evaluate(() => navigator.serviceWorker.ready);
    await page.waitForTimeout(1500);
    await page.context().setOffline(true);
    await page.reload();
    await page.locator("#tools button").first().waitFor();
    await chooseExample(page, "four-bar");
    await close(page);
  },
  async "two tabs keep two machines"() {
    const page = await open(world);
    await chooseExample(page, "four-bar");
    const other = await page.context().newPage();
    await other.goto(world.address);
    await bodies(other, 2);
    await chooseExample(other, "quick-return");
    await page.waitForTimeout(500);
    await page.reload();
    await bodies(page, 2);
    assert.match(await text(page), /Four-bar/);
    await close(page);
  },
  async "every example opens and is drawn"() {
    const page = await open(world), all = await page.evaluate(() => fetch("gallery.json").then((reply) => reply.json()));
    for (const { id } of all) {
      await page.click("#examples");
      await page.click(`dialog [data-example="${id}"]`);
      await until(page, (name) => document.querySelector("#name").value === name && document.querySelectorAll("#scene [data-body]").length > 0, id);
    }
    await close(page);
  },
};

await runTests(world, isFull ? { ...tests, ...full } : tests, process.argv[4]);
