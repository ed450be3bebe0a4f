// Prints how long the core takes in Node: node bench/wasm_times.mjs build/wasm. Measure on an idle machine; nothing is asserted.
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const folder = resolve(process.argv[2] ?? "build/wasm"), root = new URL("../", import.meta.url);
const { Engine, runCommand } = await import(pathToFileURL(folder + "/js/node.mjs").href);
const example = (name) => readFileSync(new URL(`examples/${name}.yaml`, root), "utf8");

// Prints the least time of several runs, ms.
function time(what, runs, work, each = 1) {
  let best = Infinity;
  for (let k = 0; k < runs; k++) {
    const start = performance.now();
    work(k);
    best = Math.min(best, performance.now() - start);
  }
  console.log(`${what.padEnd(48)} ${(best / each).toPrecision(3)} ms`);
}

const bytes = readFileSync(folder + "/core.wasm"), whole = new WebAssembly.Module(readFileSync(folder + "/yoke.wasm"));
time("compile core.wasm", 5, () => new WebAssembly.Module(bytes));
const module = new WebAssembly.Module(bytes);
time("instantiate", 5, () => new Engine(module));
time("open a four-bar, first", 1, () => new Engine(module).open(example("four-bar"), "m.yaml"));
const engine = new Engine(module);
time("open a four-bar", 50, () => engine.open(example("four-bar"), "m.yaml"));
time("a slider: parameter of a four-bar", 50, (k) => engine.parameter("b", 0.12 + 1e-5 * k));
time("at: one pose of a four-bar with its parts", 20, (k) => { for (let i = 0; i < 100; i++) engine.at({ theta2: 0.7 + 0.001 * (i + 100 * k) }); }, 100);
time("drag a four-bar", 20, (k) => { for (let i = 0; i < 20; i++) engine.drag("coupler", [0, 0], [0.03 + 0.001 * i, 0.02 + 0.0001 * k]); }, 20);
const behind = new WebAssembly.Module(readFileSync(folder + "/panels.wasm")), larger = new Engine(behind);
time("panels.wasm takes a four-bar over", 10, () => larger.adopt(engine));
larger.open(example("four-bar"), "m.yaml");
time("curves of a four-bar, 360 poses", 10, () => larger.curves("theta2", 0, 6.28, 360, ["theta4", "coupler.P.x", "coupler.P.y"]));
larger.open(example("watt-with-masses"), "m.yaml");
const forces = ["A", "B", "C", "D", "E", "F", "G"].map((name) => `${name}.force`);
time("a Watt six-bar, 360 poses: 7 joint forces", 10, () => larger.curves("t", 0, 0.06, 360, forces));
time("a Watt six-bar: arrows of all joint forces", 20, () => larger.forces());
larger.open(example("gas-engine"), "m.yaml");
time("let go: 1/60 s of a gas engine", 1, () => { larger.release(); for (let i = 0; i < 30; i++) larger.step(1 / 60); }, 30);
// Returns a machine of so many links, one behind the other.
function chainOf(links) {
  let chain = "bodies:\n  ground: {points: {J0: [0, 0]}}\n", joints = "joints:\n";
  for (let k = 0; k < links; k++) {
    chain += `  b${k}: {points: {J${k}: [0, 0], J${k + 1}: [0.1, 0]}}\n`;
    joints += `  J${k}: {pin: [${k ? "b" + (k - 1) : "ground"}, b${k}], angle: t${k}}\n`;
  }
  return chain + joints;
}
engine.open(chainOf(100), "m.yaml");
time("at: 100 links", 20, (k) => engine.at({ t0: 0.01 * k }));
time("drag the end of 100 links", 5, (k) => engine.drag("b99", [0.1, 0], [9, 0.1 * k]));
engine.open(chainOf(1000), "m.yaml");
time("at: 1,000 links, a frame of the core", 10, (k) => engine.at({ t0: 0.01 * k }));
const files = () => new Map([["m.yaml", new TextEncoder().encode(example("quick-return"))]]);
time("run: solve", 10, () => runCommand(whole, { words: ["solve", "m.yaml"], files: files() }));
time("run: derive --format mathml", 5, () => runCommand(whole, { words: ["derive", "m.yaml", "--format", "mathml"], files: files() }));
