// Every example through all calls of the page's door: the same bits as golden.txt, which the same calls on other machines give
// (door.c). node test_door.mjs NODE.mjs CORE.wasm EXAMPLES
import { readdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { walk } from "./walk.mjs";

const [, , library, module, examples] = process.argv;
const { Engine } = await import(pathToFileURL(resolve(library)).href);
if (!Engine) {
  console.log("skipped: npm could not get esbuild");
  process.exit(77);
}
const compiled = new WebAssembly.Module(readFileSync(module));
const golden = readFileSync(new URL("golden.txt", import.meta.url), "utf8").trim().split("\n").sort();
const names = readdirSync(examples).filter((name) => name.endsWith(".yaml")).sort();
const engine = new Engine(compiled); // one for all: what came before leaves nothing behind
const lines = names.map((name) => `${walk(engine, readFileSync(join(examples, name), "utf8"))} ${name}`).sort();
const wrong = lines.filter((line) => !golden.includes(line));
for (const line of wrong) console.log("differs: " + line);
console.log(`${lines.length} machines, ${wrong.length} differ`);
process.exit(wrong.length > 0 || lines.length !== golden.length ? 1 : 0);
