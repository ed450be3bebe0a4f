// Followers stand where they ride: at lift 0 a roller's centre is `base` + `roller` away from its cam's, as drawn and as taken hold of.
// node test_followers.mjs NODE.mjs CORE.wasm EXAMPLES
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [, , library, module, examples] = process.argv;
const { Engine } = await import(pathToFileURL(resolve(library)).href);
if (!Engine) {
  console.log("skipped: npm could not get esbuild");
  process.exit(77);
}
const engine = new Engine(new WebAssembly.Module(readFileSync(module)));

// Returns where a point of a body is drawn, m.
function place({ machine }, pose, name, at) {
  const index = machine.bodies.findIndex((one) => one.name === name), [x, y, angle] = pose.bodies.slice(3 * index, 3 * index + 3);
  return [x + Math.cos(angle) * at[0] - Math.sin(angle) * at[1], y + Math.sin(angle) * at[0] + Math.cos(angle) * at[1]];
}
const near = (a, b, what) => assert.ok(Math.abs(a - b) < 1e-9, `${what}: ${a} and ${b}`);

for (const [file, body, point, reach] of [["valve-cam", "valve", null, 0.025], ["cep-cam", "tappet", null, 0.07], ["swing-cam", "rocker", "P", 0.055]]) {
  const opened = engine.open(readFileSync(join(examples, `${file}.yaml`), "utf8"), "machine.yaml");
  const own = point ? opened.machine.bodies.find((one) => one.name === body).points.find((one) => one.name === point).at : [0, 0];
  const roller = place(opened, opened.pose, body, own);
  near(Math.hypot(...roller), reach, `${file}: roller of ${body}`);
  // Whoever drags it to where it stands moves nothing.
  const held = engine.drag(body, own, roller);
  held.bodies.forEach((value, k) => near(value, opened.pose.bodies[k], `${file}: number ${k} after a drag that goes nowhere`));
}
console.log("3 followers stand on their cams");
