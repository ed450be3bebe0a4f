// The page's side: requests overtake each other, a core that dies or runs out of memory is started anew with the last text.
// node test_client.mjs NODE.mjs WORKER.js CORE.wasm PANELS.wasm YOKE.wasm EXAMPLES
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Worker } from "node:worker_threads";

const [, , library, script, small, panels, whole, examples] = process.argv;
const { startCore, Overtaken, CoreLost } = await import(pathToFileURL(resolve(library)).href);
if (!startCore) {
  console.log("skipped: npm could not get esbuild");
  process.exit(77);
}
const bytes = (path) => new Uint8Array(readFileSync(path));
const machine = (name) => readFileSync(join(examples, name + ".yaml"), "utf8");

// A worker of Node that looks like one of a browser.
const shim = `const { parentPort } = require("node:worker_threads");
globalThis.self = { postMessage: (answer) => parentPort.postMessage(answer), onmessage: null };
parentPort.on("message", (data) => data === "die" ? process.exit(3) : globalThis.self.onmessage({ data }));\n`;
const source = shim + readFileSync(script, "utf8");
let workers = [];
function worker() {
  const inner = new Worker(source, { eval: true, stdout: false });
  const outer = {
    postMessage: (request) => inner.postMessage(request), terminate: () => inner.terminate(), onmessage: null, onerror: null, inner,
  };
  inner.on("message", (data) => outer.onmessage?.({ data }));
  inner.on("error", (problem) => outer.onerror?.(problem));
  inner.on("exit", (code) => code !== 0 && outer.onerror?.(code));
  workers.push(outer);
  return outer;
}
const start = (more = {}) => startCore({ worker, small: bytes(small), panels: bytes(panels), whole: bytes(whole), ...more });
const outcome = (promise) => promise.then((value) => value, (problem) => problem.name);

// Returns the module with a smaller limit on its memory, in pages of 64 KiB.
function limited(pages) {
  const module = bytes(small), varint = (at) => {
    let value = 0, shift = 0, byte;
    do { byte = module[at++]; value |= (byte & 127) << shift; shift += 7; } while (byte & 128);
    return [value, at];
  };
  for (let at = 8; at < module.length;) {
    const [size, body] = varint(at + 1);
    if (module[at] !== 5) { at = body + size; continue; }
    assert.deepEqual([module[body], module[body + 1]], [1, 1], "one memory, with a limit");
    const [, limit] = varint(body + 2), [, end] = varint(limit);
    for (let k = limit; k < end; k++, pages = Math.floor(pages / 128)) module[k] = (pages & 127) | (k + 1 < end ? 128 : 0);
    assert.equal(pages, 0);
    return module;
  }
}

const tests = {
  async "opens, moves, and runs the command"() {
    const core = start(), { machine: told, pose, scene } = await core.open(machine("four-bar"), "four-bar.yaml");
    assert.equal(told.name, "Four-bar linkage");
    assert.equal(pose.status, "ok");
    assert.match(scene, /<g data-body="coupler" transform="translate\(/);
    const there = await core.at({ theta2: 1 });
    assert.equal(there.coordinates[0], 1);
    const reply = await core.run(["solve", "m.yaml", "-o", "out.txt"], { "m.yaml": machine("four-bar") });
    assert.deepEqual([reply.exit, reply.out, Object.keys(reply.files)], [0, "", ["out.txt"]]);
    assert.match(new TextDecoder().decode(reply.files["out.txt"]), /^Four-bar linkage/);
    core.close();
  },
  async "the module behind takes the machine over as it stands: slider, view, inputs, assembly"() {
    const core = start(), alone = start({ small: bytes(panels) }), text = machine("four-bar"), name = "four-bar.yaml";
    const told = [];
    for (const one of [core, alone]) {
      await one.open(text, name);
      await one.parameter("b", 0.115);
      await one.look(900);
      const away = await one.at({ theta4: 1.9 }), ghosts = await one.ghosts();
      const curves = one === alone ? null : await one.curves("theta4", 1.9, 2, 3, ["theta2", "theta2.rate"]);
      const after = await one.choose(0), dragged = await one.drag("coupler", [0.05, 0], [0.1, 0.1]), { scene } = await one.look(900);
      told.push([away, ghosts, after, dragged, scene]);
      if (curves) assert.equal(curves.status, "ok");
      one.close();
    }
    assert.deepEqual(told[0], told[1]);
    assert.ok(told[0][1].length > 0);
  },
  async "rates are those of the command"() {
    const core = start(), text = machine("four-bar"), { machine: told } = await core.open(text, "m.yaml");
    const { out } = await core.run(["solve", "m.yaml", "--format", "json"], { "m.yaml": text });
    const answer = JSON.parse(out).configurations[0], rates = await core.rates();
    told.coordinates.forEach(({ name }, k) => assert.deepEqual([...rates.coordinates.slice(2 * k, 2 * k + 2)], [answer.coordinates[name].velocity, answer.coordinates[name].acceleration]));
    told.bodies.flatMap((body) => body.points.map((point) => `${body.name}.${point.name}`)).forEach((name, p) => {
      if (answer.points[name]) assert.deepEqual([...rates.points.slice(4 * p, 4 * p + 4)], [...answer.points[name].velocity, ...answer.points[name].acceleration], name);
    });
    assert.equal(rates.points.length, 4 * told.bodies.flatMap(({ points }) => points).length);
    core.close();
  },
  async "forces in joints are those of the command, and a machine without masses says why it has none"() {
    const core = start(), text = machine("watt-with-masses"), { machine: told } = await core.open(text, "m.yaml");
    const { out } = await core.run(["solve", "m.yaml", "--format", "json"], { "m.yaml": text });
    const { reactions } = JSON.parse(out).configurations[0], { joints, message } = await core.forces();
    assert.equal(message, "");
    told.joints.forEach(({ name }, j) => assert.deepEqual([...joints.slice(5 * j + 2, 5 * j + 5)], [...reactions[name].force, 1], name));
    await core.open(machine("four-bar"), "m.yaml");
    const none = await core.forces();
    assert.match(none.message, /neither masses nor loads/);
    assert.ok(none.joints.every((value, k) => k % 5 !== 2 || value === 0));
    core.close();
  },
  async "an even turn is told, an uneven one is not, not even if it begins without acceleration"() {
    const core = start(), text = machine("four-bar"), turn = async (drive) => {
      const { machine: told } = await core.open(text.replace(/^drives:.*$/m, `drives: {theta2: ${drive}}`), "m.yaml");
      return core.turn(told.coordinates.findIndex(({ name }) => name === "theta2"));
    };
    const even = await turn("40 + 60 rpm * t");
    assert.ok(Math.abs(even.from - (40 * Math.PI) / 180) < 1e-15 && Math.abs(even.rate - 2 * Math.PI) < 1e-14);
    assert.equal(await turn("40 + 10 * sin(60 rpm * t)"), null);
    assert.equal((await turn("40")).rate, 0);
    core.close();
  },
  async "a search tells what it has found while it runs; ended, it leaves that"() {
    const core = start(), points = Array.from({ length: 12 }, (_, k) => [(k * 7) % 12, (k * k) % 11]), heard = [];
    const task = (more) => ({ "t.yaml": `synthesis: path\npoints: ${JSON.stringify(points)}\n${more}` }), verb = ["synthesize", "t.yaml", "--format", "json"];
    const soFar = await core.run([...verb, "--so-far"], task("best: 2\n"), (text) => heard.push(text)), silent = await core.run(verb, task("best: 2\n"), () => assert.fail("heard"));
    assert.equal(soFar.out, heard.join(""));
    assert.ok(heard.length > 3 && soFar.out.endsWith(silent.out));
    let first;
    const ended = new Promise((done) => { first = done; }), lost = outcome(core.run([...verb, "--so-far"], task(""), first));
    assert.match(await ended, /^\{"(part|rank)"/);
    core.close();
    assert.equal(await lost, "CoreLost");
  },
  async "a command that is stopped answers at once with what it has told, not complete; the machine stays"() {
    const core = start(), points = Array.from({ length: 12 }, (_, k) => [(k * 7) % 12, (k * k) % 11]), heard = [];
    const { machine: told } = await core.open(machine("slider-crank"), "slider-crank.yaml");
    let first;
    const begun = new Promise((done) => { first = done; });
    const reply = core.run(["synthesize", "t.yaml", "--format", "json", "--so-far"], { "t.yaml": `synthesis: path\npoints: ${JSON.stringify(points)}\n` }, (text) => { heard.push(text); first(); });
    const waiting = core.run(["check", "m.yaml"], { "m.yaml": machine("four-bar") });
    await begun;
    core.stop();
    assert.deepEqual(await reply, { exit: -1, out: heard.join(""), err: "", files: {}, complete: false });
    assert.deepEqual(await waiting, { exit: -1, out: "", err: "", files: {}, complete: false });
    assert.equal((await core.at({ theta: 1 })).bodies.length, 3 * told.bodies.length);
    const whole = await core.run(["check", "m.yaml"], { "m.yaml": machine("four-bar") });
    assert.deepEqual([whole.exit, whole.complete], [0, true]);
    core.close();
  },
  async "panels.wasm answers its verbs as yoke.wasm does, and leaves it the others"() {
    const core = start(), alone = start({ panels: bytes(whole) }), files = { "m.yaml": machine("four-bar") };
    for (const words of [["check", "m.yaml"], ["solve", "m.yaml"], ["derive", "m.yaml"], ["sweep", "m.yaml", "--over", "t=0:1s"], ["draw", "m.yaml"], ["cam", "m.yaml"], ["gears", "m.yaml"],
      ["rest", "m.yaml"], ["simulate", "m.yaml", "--to", "0.1s"], ["explain", "E0401"],
      ["draw", "m.yaml", "--animate", "m.svg", "--to", "0.1s"], ["solve", "m.yaml", "--all"], ["solve", "m.yaml", "--all", "--within", "-1s"], ["solve", "m.yaml", "--solver", "paths"],
      ["solve", "m.yaml", "--assembly", "2"]])
      assert.deepEqual(await core.run(words, files), await alone.run(words, files), words[0]);
    const group = { "m.yaml": machine("double-butterfly") }; // its motion is proved by yoke.wasm, which panels.wasm leaves it to
    for (const words of [["solve", "m.yaml", "--at", "lambda=20deg"], ["sweep", "m.yaml", "--over", "lambda=0:20deg", "--steps", "4", "--format", "json"]]) {
      const reply = await core.run(words, group);
      assert.deepEqual(reply, await alone.run(words, group), words[0]);
      assert.match(reply.out, /\bcertified\b/);
    }
    for (const words of [["solve", "m.yaml", "--trust"], ["solve", "m.yaml", "--all"]]) assert.deepEqual(await core.run(words, group), await alone.run(words, group), "names");
    const short = { "m.yaml": machine("non-grashof") }, beyond = ["solve", "m.yaml", "--at", "theta2=170deg"]; // what closes there is counted
    assert.deepEqual(await core.run(beyond, short), await alone.run(beyond, short));
    for (const words of [["new"], ["study", "m.yaml", "--vary", "b=110mm:130mm:3"], ["code", "m.yaml"], ["report", "m.yaml"], ["map", "m.yaml", "--over", "theta4"], ["cognates", "m.yaml"], ["balance", "m.yaml"], ["--version"]])
      assert.ok(!(await core.run(words, files)).err.includes("this module"), words[0]);
    const script = new TextEncoder().encode("var report = 1;\n"), moving = start({ report: script });
    const page = async (from) => (await from.run(["report", "m.yaml"], files)).out;
    assert.match(await page(moving), /<script>\nvar report = 1;\n<\/script>/);
    assert.equal(await page(moving), await page(moving), "it is loaded once");
    assert.match((await moving.run(["--quiet", "report", "m.yaml"], files)).out, /<script>/, "options may stand before the verb");
    assert.doesNotMatch(await page(core), /<script>/);
    const lacking = start({ report: "data:nothing" });
    await assert.rejects(lacking.run(["report", "m.yaml"], files), /TypeError/, "a script that cannot be loaded is told");
    assert.equal((await lacking.run(["check", "m.yaml"], files)).exit, 0);
    for (const one of [moving, lacking]) one.close();
    assert.match((await core.run(["new", "four-bar"], {})).out, /^# A four-bar linkage/);
    assert.match((await core.run(["new", "jansen"], {})).err, /press Examples/); // the page has the gallery's other files
    for (const one of [core, alone]) one.close();
  },
  async "a newer request overtakes one that waits, never one that works"() {
    const core = start();
    await core.open(machine("four-bar"), "four-bar.yaml");
    const asked = [0.7, 0.8, 0.9, 1].map((theta2) => outcome(core.at({ theta2 }))), time = outcome(core.time(0.5));
    const [first, second, third, last] = await Promise.all(asked);
    assert.equal(first.coordinates[0], 0.7);
    assert.deepEqual([second, third], ["Overtaken", "Overtaken"]);
    assert.equal(last.coordinates[0], 1);
    assert.equal((await time).time, 0.5);
    const runs = await Promise.all(["check", "solve"].map((verb) => core.run([verb, "m.yaml"], { "m.yaml": machine("four-bar") })));
    assert.deepEqual(runs.map(({ exit }) => exit), [0, 0]);
    core.close();
  },
  async "a core that dies is started anew with the last text"() {
    let opened = null;
    const core = start({ onRestart: (told) => { opened = told; } });
    await core.open(machine("slider-crank"), "slider-crank.yaml");
    const lost = outcome(core.run(["study", "m.yaml"], { "m.yaml": machine("four-bar") })), waiting = outcome(core.at({ theta: 1 }));
    workers.at(-1).inner.postMessage("die");
    assert.equal(await lost, "CoreLost");
    assert.equal((await waiting).status, "ok");
    assert.match(opened.machine.name, /lider/);
    core.close();
  },
  async "a long request is given up when a newer one of its kind waits"() {
    const core = start({ patience: 50 }), text = machine("four-bar");
    await core.open(text, "four-bar.yaml");
    const long = ["study", "m.yaml", "--vary", "b=110mm:130mm:3000", "--over", "theta2=0:360deg", "--of", "coupler.P.y", "--quiet"];
    const first = outcome(core.run(long, { "m.yaml": text })), second = outcome(core.run(["study", "--help"], {}));
    assert.equal(await first, "Overtaken");
    assert.equal((await second).exit, 0);
    assert.equal((await core.at({ theta2: 1 })).status, "ok");
    core.close();
  },
  async "memory that runs out is told, and the next text opens"() {
    const core = start({ small: limited(96) }), link = (k) => `  b${k}: {points: {A: [0, 0], B: [1, 0]}}\n`;
    let huge = "bodies:\n  ground: {points: {A: [0, 0]}}\n";
    for (let k = 0; k < 30000; k++) huge += link(k);
    const told = await outcome(core.open(huge, "huge.yaml"));
    assert.ok(told === "CoreLost" || (told.machine === null && told.problems.some(({ code }) => code === "E0100")), JSON.stringify(told).slice(0, 200));
    const { pose } = await core.open(machine("four-bar"), "four-bar.yaml");
    assert.equal(pose.status, "ok");
    core.close();
  },
  async "a core that cannot start says so, and so does the next request"() {
    const core = start({ small: new Uint8Array([1, 2, 3]) });
    assert.match(await outcome(core.open("", "x.yaml")), /Error|CoreLost/);
    core.close();
  },
  async "nothing in a text or a name breaks the door"() {
    const core = start();
    for (const text of ["", "\0", "a: \0", "{", "bodies: {}", "\ufeff", "# only a comment", "name: <script>alert(1)</script>\nbodies: {a: {points: {\"<\": [0, 0]}}}"]) {
      const { machine: told, scene } = await core.open(text, "x\0y.yaml");
      assert.ok(told === null || told.bodies.length > 0);
      assert.ok(!scene?.includes("<script"));
    }
    assert.equal((await core.drag("nobody", [0, 0], [1, 1])).status, "bad-argument");
    assert.equal((await core.drag("ground", [NaN, 0], [1, 1])).status.length > 0, true);
    assert.match((await core.curves("nobody", 0, 1, 3, ["x"])).status, /bad/);
    core.close();
  },
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  try {
    await test();
    console.log("ok      " + name);
  } catch (problem) {
    failed++;
    console.log(`FAILED  ${name}\n${problem.stack}`);
  }
}
await Promise.all(workers.map(({ inner }) => inner.terminate()));
process.exit(failed > 0 ? 1 : 0);
