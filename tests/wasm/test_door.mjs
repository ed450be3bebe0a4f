// Every example through all calls of the page's door: the same bits as golden.txt, which the same calls on other machines give
// (door.c). core.wasm begins, and panels.wasm takes the machine over on the way, as in the page; then panels.wasm alone.
// node test_door.mjs NODE.mjs CORE.wasm PANELS.wasm EXAMPLES
import { readdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { walk } from "./walk.mjs";

const [, , library, small, panels, examples] = process.argv;
const { Engine } = await import(pathToFileURL(resolve(library)).href);
if (!Engine) {
  console.log("skipped: npm could not get esbuild");
  process.exit(77);
}
const golden = readFileSync(new URL("golden.txt", import.meta.url), "utf8").trim().split("\n").sort();
const names = readdirSync(examples).filter((name) => name.endsWith(".yaml")).sort();
// One engine of each for all machines: what came before leaves nothing behind.
const [core, behind] = [small, panels].map((path) => new Engine(new WebAssembly.Module(readFileSync(path))));
let failed = 0;
for (const [how, grow] of [["handed over", (engine) => { behind.adopt(engine); return behind; }], ["alone", (engine) => engine]]) {
  const lines = names.map((name) => `${walk(how === "alone" ? behind : core, readFileSync(join(examples, name), "utf8"), grow)} ${name}`);
  const wrong = lines.filter((line) => !golden.includes(line));
  for (const line of wrong) console.log("differs: " + line);
  console.log(`${how}: ${lines.length} machines, ${wrong.length} differ`);
  failed += wrong.length + Math.abs(lines.length - golden.length);
}
process.exit(failed > 0 ? 1 : 0);
