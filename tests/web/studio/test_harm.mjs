// Events that must not lose work: a core that dies, full storage, a reload amid a drag, links that are far too large. And fingers on a phone,
// and what the newer tools draw. node test_harm.mjs BUNDLED PAGE [PART OF A NAME]
import assert from "node:assert/strict";
import { deflateRawSync } from "node:zlib";
import { bodies, close, moves, open, runTests, start, text, turn, until } from "./browser.mjs";

const world = await start(process.argv[2], process.argv[3]);
const isFull = Boolean(process.env.YOKE_FULL);
const chooseExample = async (page, id) => {
  await page.click("#examples");
  await page.click(`dialog [data-example="${id}"]`);
  await bodies(page, 2);
};
const middleOf = (page, body) => page.evaluate((name) => {
  const circles = document.querySelectorAll(`#scene [data-body="${name}"] circle`), box = circles[circles.length - 1].getBoundingClientRect();
  return [box.x + box.width / 2, box.y + box.height / 2];
}, body);
// Waits until the page has said a sentence; some are shown for a moment only.
const listens = (page) => page.evaluate(() => {
  window.heard = [];
  new MutationObserver(() => window.heard.push(document.getElementById("said").textContent)).observe(document.getElementById("said"), { childList: true, characterData: true, subtree: true });
});
const hears = (page, sentence) => until(page, (one) => window.heard.some((said) => said.includes(one)), sentence);
const before = async (script, options = {}) => {
  const page = await open(world, options);
  await page.addInitScript(script);
  await page.reload();
  await page.locator("#tools button").first().waitFor();
  await listens(page);
  return page;
};
// Draws with a tool by clicks, drives the joint at `motor`, and plays.
async function drawn(page, key, places, motor) {
  await page.locator("#canvas").focus();
  await page.keyboard.press(key);
  for (const at of places) await page.mouse.click(...at);
  await bodies(page, 1);
  await page.keyboard.press("m");
  await page.mouse.click(...motor);
  await until(page, () => document.querySelector(".cm-content").textContent.includes("drives:"));
  await page.keyboard.press("v");
  await page.keyboard.press("Space");
}

const tests = {
  async "a core that dies amid its work is started anew, and no letter is lost"() {
    const page = await before(() => {
      [window.cores, window.kills] = [[], false];
      window.Worker = class extends Worker {
        constructor(...words) { super(...words); window.cores.push(this); }
        postMessage(...words) {
          if (!window.kills) return super.postMessage(...words);
          window.kills = false;
          this.terminate();
          setTimeout(() => this.dispatchEvent(new ErrorEvent("error", { message: "killed" })));
        }
      };
    });
    await chooseExample(page, "four-bar");
    const own = await text(page), stood = await turn(page, "crank");
    await page.evaluate(() => { window.kills = true; });
    await page.click("#canvas", { position: { x: 5, y: 300 } });
    await page.keyboard.press("Space");
    await hears(page, "The core stopped and was started again");
    assert.equal(await page.evaluate(() => window.cores.length), 2);
    await moves(page, "crank", stood);
    assert.equal(await text(page), own);
    await close(page);
  },
  async "a full storage is told, and the machine stays"() {
    const page = await before(() => { Storage.prototype.setItem = () => { throw new DOMException("full", "QuotaExceededError"); }; });
    await chooseExample(page, "four-bar");
    await hears(page, "storage is full");
    assert.match(await text(page), /coupler/);
    await close(page);
  },
  async "the served file is changed by another editor: taken where nothing is lost, else asked, and written over only when told to"() {
    // Stands for the server of `yoke studio`, whose own answers tests/cli/test_studio.py holds.
    const disk = { text: "# first\nbodies:\n  ground: {points: {O: [0, 0]}}\n  a: {points: {O: [0, 0], A: [1, 0]}}\njoints:\n  O: {pin: [ground, a]}\n", version: 1 }, puts = [];
    const browser = await world.browser.newContext({ viewport: { width: 1280, height: 800 } }), page = await browser.newPage();
    page.setDefaultTimeout(150_000);
    await page.route("**/machine?token=*", async (route) => {
      const request = route.request();
      if (request.method() === "PUT") {
        puts.push(request.headers()["if-match"]);
        if (request.headers()["if-match"] !== String(disk.version)) return route.fulfill({ status: 409, json: { text: disk.text } });
        disk.text = request.postData();
        return route.fulfill({ json: { version: String(++disk.version) } });
      }
      return route.fulfill({ json: { name: "served.yaml", text: disk.text, version: String(disk.version) } });
    });
    const change = (to) => { disk.text = to; disk.version++; };
    await page.goto(world.address + "?token=x");
    await until(page, () => document.querySelector(".cm-content").textContent.includes("# first"));
    change(disk.text.replace("first", "second"));
    await until(page, () => document.querySelector(".cm-content").textContent.includes("# second"));
    await page.click(".cm-content");
    await page.keyboard.press("Control+Home");
    await page.keyboard.insertText("# mine\n");
    change(disk.text.replace("second", "theirs"));
    await page.locator("#question").waitFor();
    assert.match(await text(page), /# mine/);
    assert.match(disk.text, /# theirs/, "nothing of the other editor is lost");
    await page.click("#question >> text=Overwrite");
    await until(page, () => document.querySelector("#question").hidden);
    for (let k = 0; k < 300 && !disk.text.includes("# mine"); k++) await page.waitForTimeout(50);
    assert.match(disk.text, /# mine/);
    assert.equal(puts.at(-1), "3"); // the version that was seen last, not blindly
    await page.keyboard.press("Control+Home");
    await page.click(".cm-content");
    await page.keyboard.insertText("# later\n");
    change(disk.text.replace("mine", "other"));
    await page.locator("#question").waitFor();
    await page.click("#question >> text=Take the file's");
    await until(page, () => document.querySelector(".cm-content").textContent.includes("# other"));
    await browser.close();
  },
  async "a browser without WebAssembly says so and shows the text"() {
    const page = await open(world), file = "name: plain\nbodies: {}\n";
    await page.addInitScript(() => { delete globalThis.WebAssembly; });
    await page.reload();
    await until(page, () => !document.body.inert);
    assert.match(await page.textContent("#question"), /needs WebAssembly/);
    await page.setInputFiles("#file", { name: "plain.yaml", mimeType: "text/yaml", buffer: Buffer.from(file) });
    await until(page, () => document.querySelector(".cm-content").textContent.includes("name: plain"));
    await close(page);
  },
  async "a reload amid a drag keeps the machine"() {
    const page = await open(world);
    await chooseExample(page, "four-bar");
    const own = await text(page), [x, y] = await middleOf(page, "coupler");
    await page.waitForTimeout(400);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 30, y + 20, { steps: 4 });
    await page.reload();
    await bodies(page, 2);
    assert.equal(await text(page), own);
    await close(page);
  },
  async "a link that unpacks to 10 MB is refused"() {
    const page = await open(world, {}, `#m=1.${deflateRawSync(Buffer.alloc(10 << 20, "a: ")).toString("base64url")}`);
    await until(page, () => /could not be read/.test(document.getElementById("said").textContent));
    assert.equal(await text(page), "");
    await close(page);
  },
  async "a finger drags the machine on a phone"() {
    const page = await open(world, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    await page.tap("#examples");
    await page.tap(`dialog [data-example="four-bar"]`);
    await bodies(page, 2);
    await page.waitForTimeout(400);
    const session = await page.context().newCDPSession(page), stood = await turn(page, "crank"), [x, y] = await middleOf(page, "coupler");
    const touch = (type, ...points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([px, py]) => ({ x: px, y: py })) });
    await touch("touchStart", [x, y]);
    for (let k = 1; k <= 12; k++) await touch("touchMove", [x + 4 * k, y + 3 * k]);
    await moves(page, "crank", stood);
    await touch("touchEnd");
    await close(page);
  },
};

const full = {
  async "a plate drawn by its corners turns"() {
    const page = await open(world);
    await page.locator("#canvas").focus();
    await page.keyboard.press("y");
    for (const at of [[300, 500], [420, 300], [560, 520], [300, 500]]) await page.mouse.click(...at);
    await bodies(page, 1);
    await page.keyboard.press("g");
    await page.mouse.click(300, 500);
    await until(page, () => document.querySelector(".cm-content").textContent.includes("{pin"));
    await page.keyboard.press("m");
    await page.mouse.click(300, 500);
    await until(page, () => document.querySelector(".cm-content").textContent.includes("drives:"));
    await page.keyboard.press("v");
    await page.keyboard.press("Space");
    await moves(page, "plate1", 0);
    await close(page);
  },
  async "rack, belt and cam turn as drawn"() {
    for (const [key, places, body] of [["h", [[400, 350], [400, 450]], "pinion1"], ["u", [[300, 400], [600, 400]], "pulley2"], ["c", [[400, 500], [400, 350]], "disc1"]]) {
      const page = await open(world);
      await drawn(page, key, places, places[0]);
      await moves(page, body, 0);
      assert.equal(await page.locator("#problems .error").count(), 0);
      await close(page);
    }
  },
};

await runTests(world, isFull ? { ...tests, ...full } : tests, process.argv[4]);
