// Edits of the file: each changes what it means and nothing else, in every example.
// node test_document.mjs BUNDLED EXAMPLES, where BUNDLED holds web/studio with its packages.
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const [, , bundled, folder] = process.argv;
if (!existsSync(join(bundled, "node_modules", "yaml"))) {
  console.log("skipped: npm could not get its packages");
  process.exit(77);
}
const require = createRequire(resolve(bundled) + "/");
const work = mkdtempSync(join(tmpdir(), "yoke-document-"));
process.on("exit", () => rmSync(work, { recursive: true, force: true }));
writeFileSync(join(work, "entry.ts"), ["document/source", "document/numbers", "document/gestures", "document/elements", "document/task", "canvas/stroke"].map((name) => `export * from "${resolve(bundled)}/src/${name}";`).join("\n") +
  `\nexport { split } from "${resolve(bundled)}/src/panels/command";\nexport { mendOf } from "${resolve(bundled)}/src/editor/problems";`);
await require("esbuild").build({ entryPoints: [join(work, "entry.ts")], bundle: true, format: "esm", platform: "browser", outfile: join(work, "out.mjs"), logLevel: "error" });
const { Source, Draft, addBelt, addCam, addDamper, addPolygon, addRack, difference, written, typed, decimal, split, mendOf, spaced, meant, extended, taskOf } = await import(pathToFileURL(join(work, "out.mjs")).href);
const { parse } = require("yaml");
const examples = readdirSync(folder).filter((name) => name.endsWith(".yaml")).map((name) => [name, readFileSync(join(folder, name), "utf8")]);
const EMPTY = { name: "", bodies: [], joints: [], coordinates: [], parameters: [], freedom: 0, moves: false };
const STILL = { bodies: new Float64Array(), coordinates: new Float64Array() };
const draft = (text, machine = EMPTY, pose = STILL) => new Draft(text, machine, pose, 1e-4);

test("what is set can be read again, and all else stays, letter by letter", () => {
  for (const [name, text] of examples) {
    const source = new Source(text), paths = [["parameters", "extra_length"], ["bodies", "extra_body"], ["joints", "extra_joint"], ["drives", "extra.angle"], ["gravity"]];
    for (const path of paths.filter((one) => !source.has(one))) {
      const value = path[0] === "bodies" ? "{points: {A: [0, 1]}}" : path[0] === "gravity" ? "[0, -9.81 m/s^2]" : path[0] === "joints" ? "{pin: [ground, extra_body]}" : "12 mm";
      const after = source.set(path, value), change = difference(text, after.text);
      assert.equal(after.value(path), value, `${name}: ${path}`);
      assert.deepEqual(change.to - change.from, 0, `${name}: setting ${path} only adds`);
      const back = after.remove(path), expected = structuredClone(parse(text));
      assert.deepEqual(parse(back.text), expected, `${name}: ${path} is gone again`);
    }
  }
});

test("a value is replaced in its place; comments, columns and numbers beside it stay", () => {
  const text = "# a machine\nparameters: {a: 0.10, b: 1e-3}  # lengths\nbodies:\n  ground:  {points: {O: [0, 0]}}\n  crank:   {points: {O: [0, 0]}} # turns\n";
  assert.equal(new Source(text).set(["parameters", "a"], "12 mm").text, text.replace("0.10", "12 mm"));
  assert.equal(new Source(text).set(["bodies", "rod"], "{}").text, text.replace("# turns\n", "# turns\n  rod:     {}\n"));
  assert.equal(new Source(text).remove(["bodies", "crank"]).text, text.replace("  crank:   {points: {O: [0, 0]}} # turns\n", ""));
  assert.equal(new Source(text).remove(["parameters", "a"]).text, text.replace("a: 0.10, ", ""));
  assert.equal(new Source(text).remove(["parameters", "b"]).text, text.replace(", b: 1e-3", ""));
});

test("values are replaced in every example at every place where one stands", () => {
  for (const [name, text] of examples.filter((_, k) => process.env.YOKE_FULL || k % 6 === 0)) {
    const source = new Source(text);
    const walk = (path) => source.keys(path).forEach((key) => {
      const at = [...path, key], deeper = source.keys(at);
      if (deeper.length) return walk(at);
      const change = difference(text, source.set(at, "QQQ").text);
      assert.ok(source.set(at, "QQQ").isSound, `${name}: ${at}`);
      assert.equal(source.set(at, "QQQ").value(at), "QQQ", `${name}: ${at}`);
      assert.ok(change.insert.length <= 3);
    });
    walk([]);
  }
});

test("sections come in the usual order, also where there is none yet", () => {
  const text = new Source("").set(["joints", "A"], "{pin: [ground, bar1]}").set(["bodies", "bar1"], "{points: {A: [0, 0]}}").set(["drives", "A.angle"], "1 rad/s * t").set(["units", "length"], "mm")
    .set(["bodies", "ground", "points", "A"], "[0, 0]").text;
  assert.equal(text, "units: {length: mm}\nbodies:\n  ground: {points: {A: [0, 0]}}\n  bar1: {points: {A: [0, 0]}}\njoints:\n  A: {pin: [ground, bar1]}\ndrives: {A.angle: 1 rad/s * t}\n");
  assert.equal(new Source("bodies:\njoints: {}\n").set(["bodies", "b"], "{}").set(["joints", "J"], "{}").text, "bodies: {b: {}}\njoints: {J: {}}\n");
});

test("words of strangers stay words", () => {
  for (const word of ["a", "bar 1", "40 mm", "atan2(3, 1.5)", "{x", "- y", "# no", "yes", "a: b", "0.10", "3/4 m", "*a", "x\ny", "", '"', "é"]) {
    const text = `{k: ${written(word)}}`;
    assert.equal(String(parse(text).k), /^[-+]?[\d.]+$/.test(word) ? String(Number(word)) : word, text);
  }
});

test("a four-bar is drawn by seven gestures", () => {
  const drawing = draft("");
  let end = drawing.addBar({ world: [0, 0] }, { world: [0.02, 0.04] });
  end = drawing.addBar(end, { world: [0.12, 0.06] });
  end = drawing.addBar(end, { world: [0.1, 0] });
  drawing.ground({ world: [0, 0], body: "bar1", point: "A" });
  drawing.ground(end);
  drawing.drive({ name: "A.angle", kind: "angle", value: 0 });
  assert.deepEqual(parse(drawing.text), {
    units: { length: "mm", angle: "deg" },
    bodies: { ground: { points: { A: [0, 0], D: [100, 0] } }, bar1: { points: { A: [0, 0], B: [20, 40] } }, bar2: { points: { B: [20, 40], C: [120, 60] } }, bar3: { points: { C: [120, 60], D: [100, 0] } } },
    joints: { B: { pin: ["bar1", "bar2"] }, C: { pin: ["bar2", "bar3"] }, A: { pin: ["ground", "bar1"] }, D: { pin: ["ground", "bar3"] } },
    drives: { "A.angle": "30 rpm * t" },
  });
});

test("a plate is one body, pinned where its corners lie on others", () => {
  const drawing = draft("units: {length: mm}\nbodies: {a: {points: {P: [1, 1]}}}\n");
  addPolygon(drawing, [{ world: [0.001, 0.001], body: "a", point: "P" }, { world: [0.005, 0.001] }, { world: [0.005, 0.004], body: "ground" }, { world: [0.001, 0.004] }]);
  assert.deepEqual(parse(drawing.text), {
    units: { length: "mm" }, bodies: { ground: { points: { B: [5, 4] } }, a: { points: { P: [1, 1] } }, plate1: { points: { P: [1, 1], A: [5, 1], B: [5, 4], C: [1, 4] } } },
    joints: { P: { pin: ["a", "plate1"] }, B: { pin: ["ground", "plate1"] } },
  });
});

test("a rack touches its pinion's pitch circle, and a belt has two pulleys", () => {
  const rack = draft("units: {length: mm}\n");
  addRack(rack, { world: [0.01, 0.02] }, [0.01, -0.03]);
  assert.deepEqual(parse(rack.text), {
    units: { length: "mm" }, bodies: { ground: { points: { A: [10, 20], B: [10, -30] } }, pinion1: { points: { A: [0, 0] } }, rack1: {} },
    joints: { A: { pin: ["ground", "pinion1"] }, S1: { slide: ["ground", "rack1"], along: "x", from: "B" } }, racks: { pair1: { pinion: "pinion1", rack: "rack1", radius: "50 mm" } },
  });
  const belt = draft("units: {length: mm}\n");
  addBelt(belt, { world: [0, 0] }, { world: [0.1, 0] });
  assert.deepEqual(parse(belt.text).belts, { belt1: { between: ["pulley1", "pulley2"], radii: ["20 mm", "10 mm"] } });
  assert.deepEqual(parse(belt.text).joints, { A: { pin: ["ground", "pulley1"] }, B: { pin: ["ground", "pulley2"] } });
});

test("a cam's base circle and roller reach from its centre to where the roller was put", () => {
  const drawing = draft("units: {length: mm, angle: deg}\n");
  addCam(drawing, { world: [0.01, 0] }, [0.01, 0.05]);
  const { cams: { cam1 }, joints: { S1 } } = parse(drawing.text);
  assert.deepEqual(cam1, { cam: "disc1", follower: "follower1", law: "lift1", roller: "10 mm", base: "40 mm" });
  assert.deepEqual(S1, { slide: ["ground", "follower1"], along: "y", from: "A" });
});

test("a slot leads a point along another body, in its axes; a damper lies between two places", () => {
  const text = "units: {length: mm, angle: deg}\nbodies: {arm: {points: {A: [0, 0], B: [0, 9]}}, link: {points: {P: [0, 2]}}}\n";
  const drawing = draft(text, { ...EMPTY, bodies: [{ name: "arm" }, { name: "link" }] }, { bodies: new Float64Array([0, 0, Math.PI / 2, 0, 0, 0]), coordinates: new Float64Array() });
  drawing.guide({ world: [0, 0.002], body: "link", point: "P" }, [0, 0.009], "arm");
  addDamper(drawing, { world: [0, 0.002], body: "link", point: "P" }, { world: [0.005, 0] });
  const made = parse(drawing.text);
  assert.deepEqual(made.joints, { S1: { "pin-slot": ["arm", "link"], at: "P", from: "C", along: "x" } });
  assert.deepEqual(made.bodies.arm.points.C, [2, 0]);
  assert.deepEqual(made.springs, { damper1: { between: ["link.P", "ground.D"], damping: "10 N*s/m" } });
});

test("a third body on a pin gets a joint of its own at the same point", () => {
  const drawing = draft("units: {length: mm}\nbodies: {a: {points: {P: [1, 1]}}, b: {points: {P: [1, 1]}}}\njoints: {P: {pin: [a, b]}}\n");
  drawing.addBar({ world: [0.001, 0.001], body: "a", point: "P" }, { world: [0.002, 0.001] });
  const made = parse(drawing.text);
  assert.deepEqual(made.joints.P_1, { pin: ["a", "bar1"], at: "P" });
  assert.deepEqual(made.bodies.bar1.points.P, [1, 1]);
});

test("a removed body takes with it what mentions it, and nothing else", () => {
  const text = examples.find(([name]) => name === "quick-return.yaml")[1], bodies = parse(text).bodies;
  const machine = { ...EMPTY, joints: Object.entries(parse(text).joints).map(([name, joint]) => ({ name, bodies: joint.pin ?? joint.slide, points: [] })), coordinates: [{ name: "d5", joint: "R" }, { name: "theta4", joint: "B" }] };
  const drawing = draft(text, machine);
  drawing.removeBody("ram");
  const made = parse(drawing.text);
  assert.deepEqual(Object.keys(made.bodies), Object.keys(bodies).filter((name) => name !== "ram"));
  assert.deepEqual(Object.keys(made.joints), ["O1", "O2", "S", "A", "B"]);
  assert.deepEqual(Object.keys(made.start), ["theta2", "d3", "theta4"]);
});

test("typed lengths and angles are understood, or refused", () => {
  const units = { length: "mm", metre: 1e-3, angle: "deg" };
  assert.deepEqual(typed("120", units), { length: 0.12 });
  assert.deepEqual(typed("1.5 in 30", units), { length: 1.5 * 0.0254, angle: Math.PI / 6 });
  assert.deepEqual(typed("12cm -45 deg", units), { length: 0.12, angle: -Math.PI / 4 });
  assert.deepEqual(typed("90 deg", units), { angle: Math.PI / 2 });
  for (const wrong of ["", "abc", "12 parsec", "-5 mm", "3 + x", "1 2 3 deg x"]) assert.equal(typed(wrong, units), null, wrong);
  assert.equal(decimal(0.1 + 0.2, 1e-3), "0.3");
});

test("a command's line is split as a shell does", () => {
  assert.deepEqual(split(`solve FILE --check 'a = b' "c d"`), ["solve", "FILE", "--check", "a = b", "c d"]);
});

test("hints that need no choice are mends", () => {
  assert.equal(mendOf("did you mean `crank`?").apply("pin: [crnak, a]", { from: 6, to: 11 }), "pin: [crank, a]");
  assert.equal(parse(mendOf("add `P: [0, 0]` to the points of `rod`, in its own axes").apply("bodies: {rod: {}}", { from: 0, to: 0 })).bodies.rod.points.P[0], 0);
  assert.equal(mendOf("pin one of them to another point of the body that carries both"), null);
});

test("a stroke becomes points at equal distances along it; one that comes back goes round", () => {
  const along = [[0, 0], [1, 0], [1, 3], [5, 3]]; // 8 long
  assert.deepEqual(spaced(along, 5), [[0, 0], [1, 1], [1, 3], [3, 3], [5, 3]]);
  assert.deepEqual(spaced(along, 2), [[0, 0], [5, 3]]);
  const open = meant(along), circle = Array.from({ length: 100 }, (_, k) => [Math.cos(0.0628 * k), Math.sin(0.0628 * k)]), closed = meant(circle);
  assert.deepEqual([open.isClosed, open.points[0], open.points.at(-1)], [false, [0, 0], [5, 3]]);
  assert.equal(closed.isClosed, true);
  const gaps = closed.points.map(([x, y], k) => { const [u, v] = closed.points[(k + 1) % closed.points.length]; return Math.hypot(x - u, y - v); });
  for (const gap of gaps) assert.ok(Math.abs(gap - 2 * Math.sin(Math.PI / gaps.length)) < 2e-3, `${gap}`); // sides of a regular polygon
  assert.equal(meant([[1, 1]]), null);
  assert.equal(meant([[1, 1], [1, 1]]), null);
  let wanted = null;
  for (const at of [[0, 0], [1, 0], [1, 1], [0, 0]]) wanted = extended(wanted, at);
  assert.deepEqual([wanted.points.length, wanted.isClosed], [3, true]);
  assert.deepEqual(extended(wanted, [2, 2]).points, [[2, 2]]);
});

test("the task of a curve is in the file's unit, with bounds of the curve's size", () => {
  const points = [[0, 0], [0.1, 0.02], [0.2, 0.05]], mm = { length: "mm", metre: 1e-3, angle: "deg" };
  assert.deepEqual(parse(taskOf({ points, isClosed: false, isDone: true }, "four-bar, slider-crank", mm, 1e-4)), {
    synthesis: "path", points: [[0, 0], [100, 20], [200, 50]], closed: false, mechanisms: ["four-bar", "slider-crank"],
    bounds: { lengths: [20, 400], coupler_point: [-400, 400], pivots: [[-200, -200], [400, 250]] }, require: { input: "turns", transmission: "20 deg" }, best: 6, units: { length: "mm" },
  });
  assert.deepEqual(parse(taskOf({ points, isClosed: true, isDone: true }, "four-bar", { length: "m", metre: 1, angle: "rad" }, 1e-4)).points, points);
});
