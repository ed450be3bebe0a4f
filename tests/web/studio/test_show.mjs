// What Studio shows beside its page: machines of very many links, machines inside other pages, films; and commands that are stopped.
// node test_show.mjs BUNDLED PAGE [PART OF A NAME]
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { deflateRawSync } from "node:zlib";
import { bodies, close, moves, open, runTests, start, turn, until } from "./browser.mjs";
import { rowOf } from "./crowds.mjs";

const world = await start(process.argv[2], process.argv[3]);
const isFull = Boolean(process.env.YOKE_FULL);
const chooseExample = async (page, id) => {
  await page.click("#examples");
  await page.click(`dialog [data-example="${id}"]`);
  await bodies(page, 2);
};
const FOUR_BAR = "bodies:\n  ground: {points: {O: [0, 0], D: [0.1, 0]}}\n  crank: {points: {O: [0, 0], A: [0.04, 0]}}\n  coupler: {points: {A: [0, 0], B: [0.12, 0]}}\n  rocker: {points: {D: [0, 0], B: [0.08, 0]}}\n" +
  "joints:\n  O: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, coupler], angle: gamma}\n  B: {pin: [coupler, rocker]}\n  D: {pin: [ground, rocker], angle: phi}\ndrives: {theta: 60 rpm * t}\nstart: {gamma: 0, phi: 1}\n";
const linkTo = (body) => `#m=1.${deflateRawSync(JSON.stringify(["bar", body])).toString("base64url")}`;
// The paint on the sheet: how many of some of its pixels have ink, and a number for their places.
const look = () => {
  const sheet = document.querySelector("#sheet"), { data } = sheet.getContext("2d").getImageData(0, 0, sheet.width, sheet.height);
  let [ink, sum] = [0, 0];
  for (let k = 3; k < data.length; k += 20) if (data[k] > 0) [ink, sum] = [ink + 1, (sum + data[k] * (k % 9973)) % 1e9];
  return { ink, sum };
};
async function take(page, id) {
  const [file] = await Promise.all([page.waitForEvent("download"), page.click(`[data-export="${id}"]`)]);
  return readFileSync(await file.path());
}

const tests = {
  async "a thousand links are painted, not laid out as elements; they play, and a link can be dragged"() {
    const page = await open(world);
    await page.setInputFiles("#file", { name: "crowd.yaml", mimeType: "text/yaml", buffer: Buffer.from(rowOf(1000)) });
    await until(page, () => !document.querySelector("#sheet").hidden && document.querySelector("#said").textContent.includes("very many parts"));
    await page.waitForTimeout(500);
    assert.equal(await page.locator("#scene *").count(), 0);
    const still = await page.evaluate(look);
    assert.ok(still.ink > 600, JSON.stringify(still));
    await page.locator("#canvas").focus();
    await page.keyboard.press("Space");
    await until(page, () => Number(document.querySelector("#motion .now").textContent.split(" ")[0]) > 0.3);
    await page.keyboard.press("Space");
    assert.notEqual((await page.evaluate(look)).sum, still.sum);
    await page.keyboard.press("Home");
    await until(page, () => document.querySelector("#motion .now").textContent.startsWith("0.00"));
    // Its nearest corner is taken hold of: the crank at the lower left turns on its pin, and all others with it.
    const at = await page.evaluate(() => {
      const sheet = document.querySelector("#sheet"), box = sheet.getBoundingClientRect(), { data } = sheet.getContext("2d").getImageData(0, 0, sheet.width, sheet.height);
      let best = [0, 0, -Infinity];
      for (let y = 0; y < sheet.height; y++) for (let x = 0; x < sheet.width; x++) if (data[4 * (y * sheet.width + x) + 3] > 200 && y - x > best[2]) best = [x, y, y - x];
      return [box.x + best[0] * box.width / sheet.width, box.y + best[1] * box.height / sheet.height];
    }), before = await page.evaluate(look);
    await page.mouse.move(at[0] + 4, at[1] - 7); // on the crank, off its pin
    await page.mouse.down();
    await page.mouse.move(at[0] + 20, at[1] - 4, { steps: 4 });
    for (let k = 0; k < 300 && (await page.evaluate(look)).sum === before.sum; k++) await page.waitForTimeout(100);
    assert.notEqual((await page.evaluate(look)).sum, before.sum);
    await page.mouse.up();
    await chooseExample(page, "four-bar");
    await page.locator("#sheet").waitFor({ state: "hidden" });
    await close(page);
  },
  async "inside another page the machine plays, can be dragged, and leads to all of Studio; nothing is kept"() {
    const page = await open(world, { reducedMotion: "no-preference" }, "?embed" + linkTo(FOUR_BAR));
    await moves(page, "crank", 0);
    for (const id of ["#top", "#tools", "#panel"]) assert.ok(await page.locator(id).isHidden(), id);
    assert.ok(await page.locator("#canvas").isVisible());
    const link = await page.getAttribute("#whole", "href");
    assert.ok(link.endsWith(linkTo(FOUR_BAR)) && !link.includes("embed"), link);
    await page.evaluate(world.axe);
    const found = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
    assert.deepEqual(found.violations.map((one) => `${one.id}: ${one.nodes[0].html}`), []);
    assert.equal(await page.evaluate(() => localStorage.length), 0);
    await close(page);
    const calm = await open(world, {}, "?embed" + linkTo(FOUR_BAR)); // who asked for less motion starts it by hand
    await bodies(calm, 2);
    await calm.waitForTimeout(300);
    assert.equal(await turn(calm, "crank"), 0);
    await calm.click("#motion .play");
    await moves(calm, "crank", 0);
    await close(calm);
  },
  async "a film of one turn as GIF: the browser's own decoder finds its pictures, which move"() {
    const page = await open(world);
    await chooseExample(page, "four-bar");
    const before = await turn(page, "crank");
    await page.click("#export");
    const gif = await take(page, "gif");
    assert.equal(await turn(page, "crank"), before, "the machine on the canvas stays");
    const told = await page.evaluate(async (bytes) => {
      const decoder = new ImageDecoder({ data: Uint8Array.from(atob(bytes), (letter) => letter.charCodeAt(0)), type: "image/gif" });
      await decoder.completed;
      await decoder.tracks.ready;
      const sheet = document.createElement("canvas"), context = sheet.getContext("2d", { willReadFrequently: true }), count = decoder.tracks.selectedTrack.frameCount, looks = [], at = [0, Math.floor(count / 4), Math.floor(count / 2), count - 1];
      for (const frameIndex of at) {
        const { image } = await decoder.decode({ frameIndex });
        [sheet.width, sheet.height] = [image.displayWidth, image.displayHeight];
        context.drawImage(image, 0, 0);
        const { data } = context.getImageData(0, 0, sheet.width, sheet.height), isOf = (k, r, g, b) => Math.abs(data[k] - r) + Math.abs(data[k + 1] - g) + Math.abs(data[k + 2] - b) < 24;
        let paper = 0;
        const crank = []; // its pixels
        for (let k = 0; k < data.length; k += 4) {
          if (isOf(k, 0xfc, 0xfc, 0xfa)) paper++;
          if (isOf(k, 0xbc, 0xd5, 0xea)) crank.push([(k / 4) % sheet.width, Math.floor(k / 4 / sheet.width)]);
        }
        const mean = (of) => crank.reduce((sum, one) => sum + of(one), 0) / crank.length, x = mean((one) => one[0]), y = mean((one) => one[1]);
        const [xx, xy, yy] = [mean((one) => (one[0] - x) ** 2), mean((one) => (one[0] - x) * (one[1] - y)), mean((one) => (one[1] - y) ** 2)];
        looks.push({ paper: paper / (data.length / 4), crank: crank.length, turned: (90 * Math.atan2(-2 * xy, xx - yy)) / Math.PI }); // its long axis, degrees
      }
      return { count, at, width: sheet.width, height: sheet.height, looks };
    }, gif.toString("base64"));
    assert.ok(told.count >= 30 && told.width <= 640 && told.height > 100, JSON.stringify(told));
    for (const look of told.looks) assert.ok(look.paper > 0.6 && look.crank > 100, JSON.stringify(told));
    // The crank begins at 40 degrees and turns evenly.
    told.looks.forEach(({ turned }, k) => {
      const off = turned - 40 - (360 * told.at[k]) / told.count, away = Math.abs(off - 180 * Math.round(off / 180));
      assert.ok(away < 6, `${away} degrees: ${JSON.stringify(told)}`);
    });
    await close(page);
  },
  async "a command that takes long is stopped: it says that its answer is not complete, and the core goes on"() {
    const page = await open(world);
    await chooseExample(page, "four-bar");
    await page.click("#tab-command");
    await page.fill("#panel-command input", "study FILE --vary b=110mm:130mm:100000 --over theta2=0:360deg --of coupler.P.y --quiet");
    await page.keyboard.press("Enter");
    await page.click("#panel-command >> text=Stop");
    await until(page, () => document.querySelector("#panel-command .answer").textContent.includes("not complete"));
    await page.fill("#panel-command input", "check FILE");
    await page.keyboard.press("Enter");
    await until(page, () => document.querySelector("#panel-command .answer").textContent.includes("crank-rocker"));
    assert.ok(await page.locator("#panel-command >> text=Stop").isHidden());
    await close(page);
  },
};

const full = {
  // YOKE=build/release/apps/cli/yoke, which this build has not.
  async "the page in one file opens from disk, plays, plots, derives and makes a film"() {
    if (!process.env.YOKE) return console.log("skipped: no YOKE");
    const folder = mkdtempSync(join(tmpdir(), "yoke-page-")), file = join(folder, "page.html"), machine = join(folder, "bar.yaml");
    writeFileSync(machine, FOUR_BAR);
    execFileSync(process.env.YOKE, ["studio", machine, "-o", file], { env: { ...process.env, YOKE_STUDIO: process.argv[3] } });
    const context = await world.browser.newContext({ viewport: { width: 1280, height: 800 }, offline: true }), page = await context.newPage(), faults = [];
    page.setDefaultTimeout(150_000);
    page.on("pageerror", (error) => faults.push(error.message));
    page.on("console", (line) => line.type() === "error" && faults.push(line.text()));
    await page.goto(pathToFileURL(file).href);
    await bodies(page, 3);
    await page.locator("#canvas").focus();
    await page.keyboard.press("Space");
    await moves(page, "crank", 0);
    await page.click("#tab-diagrams");
    await page.locator(".plot canvas").first().waitFor();
    await page.click("#tab-equations");
    await page.locator(".formulas math").first().waitFor();
    await page.click("#export");
    assert.equal((await take(page, "gif")).subarray(0, 6).toString(), "GIF89a");
    assert.deepEqual(faults, []);
    await context.close();
    rmSync(folder, { recursive: true });
  },
  async "a film of one turn as the browser records it plays"() {
    const page = await open(world);
    await chooseExample(page, "four-bar");
    await page.click("#export");
    for (const kind of await page.evaluate(() => Array.from(document.querySelectorAll('[data-export="webm"], [data-export="mp4"]'), (one) => one.dataset.export))) {
      const bytes = await take(page, kind);
      console.log(`${kind}: ${bytes.length} bytes`);
      const told = await page.evaluate(async ([data, type]) => {
        const video = document.createElement("video");
        video.muted = true;
        video.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0))], { type }));
        await new Promise((done, fail) => { video.onloadeddata = done; video.onerror = () => fail(new Error(video.error.message)); });
        return [video.videoWidth, video.videoHeight];
      }, [bytes.toString("base64"), `video/${kind}`]).catch((error) => String(error)); // the page's policy lets no film in: then its head must do
      if (typeof told === "string") assert.ok(kind === "webm" ? bytes.subarray(0, 4).toString("hex") === "1a45dfa3" : bytes.subarray(4, 8).toString() === "ftyp", told);
      else assert.ok(told[0] > 300 && told[1] > 200, told.join(" x "));
      assert.ok(bytes.length > 5000);
    }
    page.faults.length = 0;
    await close(page);
  },
  async "5,000 links open, and say what is switched off"() {
    const page = await open(world);
    await page.setInputFiles("#file", { name: "crowd.yaml", mimeType: "text/yaml", buffer: Buffer.from(rowOf(5000)) });
    await until(page, () => !document.querySelector("#sheet").hidden && document.querySelector("#said").textContent.includes("very many parts"));
    await page.locator("#canvas").focus();
    await page.keyboard.press("Space");
    await until(page, () => Number(document.querySelector("#motion .now").textContent.split(" ")[0]) > 0.1);
    await close(page);
  },
};


await runTests(world, isFull ? { ...tests, ...full } : tests, process.argv[4]);
