// The page's numbers are the command's: every example opened, swept over time and over its first input, against the JSON that the
// command prints for the same. node test_answers.mjs NODE.mjs PANELS.wasm YOKE.wasm EXAMPLES
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [, , library, small, whole, examples] = process.argv;
const { Engine, runCommand } = await import(pathToFileURL(resolve(library)).href);
if (!Engine) {
  console.log("skipped: npm could not get esbuild");
  process.exit(77);
}
const engine = new Engine(new WebAssembly.Module(readFileSync(small)));
const command = new WebAssembly.Module(readFileSync(whole));
const tested = { poses: 0, sweeps: 0 };

function ask(text, ...words) {
  const files = new Map([["machine.yaml", new TextEncoder().encode(text)]]);
  const { exit, out } = runCommand(command, { words: [words[0], "machine.yaml", ...words.slice(1), "--format", "json"], files });
  return exit === 2 ? null : JSON.parse(new TextDecoder().decode(out));
}

function testPose(text, { machine, pose }) {
  const answer = ask(text, "solve")?.configurations[0];
  if (!answer || pose.bodies.length === 0) return;
  machine.coordinates.forEach(({ name, value }, k) => {
    assert.ok(Object.is(pose.coordinates[k], answer.coordinates[name].position) || pose.coordinates[k] === 0, name);
    assert.equal(value, pose.coordinates[k]);
  });
  // The door places followers of cams where they are drawn, off by base and roller: test_followers.mjs checks where that is.
  const followers = new Set([...text.matchAll(/\bfollower:\s*([\w-]+)/g)].map(([, name]) => name));
  machine.bodies.forEach(({ name, points }, b) => {
    if (b === 0 || followers.has(name)) return;
    const [x, y, angle] = pose.bodies.subarray(3 * b), size = 1 + Math.abs(x) + Math.abs(y);
    assert.ok(angle === answer.bodies[name].angle, name);
    for (const { name: point, at: [u, v] } of points) { // where the body's axes put a point is where the command has it
      const [px, py] = answer.points[name + "." + point].position, c = Math.cos(angle), s = Math.sin(angle);
      assert.ok(Math.abs(x + c * u - s * v - px) < 1e-13 * size && Math.abs(y + s * u + c * v - py) < 1e-13 * size, name + "." + point);
    }
  });
  tested.poses++;
}

function testSweep(text, machine, over, from, to, unit) {
  const names = machine.coordinates.map(({ name }) => name).filter((name) => name !== over);
  const answer = names.length > 0 ? ask(text, "sweep", "--over", `${over}=${from}:${to}${unit}`, "--steps", "8", "--of", names.join(",")) : null;
  if (!answer || answer.status === "no-assembly") return;
  engine.open(text, "machine.yaml");
  const curves = engine.curves(over, from, to, 8, names);
  assert.equal(curves.status, answer.status);
  assert.equal(curves.x.length, answer.rows.length, "rows");
  const columns = answer.columns.map((column) => column.name ?? column);
  names.forEach((name, k) => answer.rows.forEach((row, r) => {
    const wanted = row[columns.indexOf(name)] ?? NaN;
    assert.ok(curves.of[k][r] === wanted || (Number.isNaN(wanted) && Number.isNaN(curves.of[k][r])),
      `${over}, row ${r}, ${name}: ${curves.of[k][r]} is not ${wanted}`);
  }));
  tested.sweeps++;
}

let failed = 0;
for (const file of readdirSync(examples).filter((name) => name.endsWith(".yaml")).sort()) {
  const text = readFileSync(join(examples, file), "utf8");
  try {
    const opened = engine.open(text, "machine.yaml");
    assert.ok(opened.machine, "opens");
    testPose(text, opened);
    testSweep(text, opened.machine, "t", 0, 1, "s");
    const input = opened.machine.coordinates.find(({ driven, free }) => driven || free);
    if (input) testSweep(text, opened.machine, input.name, input.value, input.value + 0.5, input.kind === "angle" ? "rad" : "m");
  } catch (problem) {
    failed++;
    console.log(`${file}: ${problem.message.split("\n")[0]}`);
  }
}
console.log(`${tested.poses} poses and ${tested.sweeps} sweeps are the command's; ${failed} machines are not`);
assert.ok(tested.poses > 50 && tested.sweeps > 60, "there is something to compare");
process.exit(failed > 0 ? 1 : 0);
