// Recorded answers of every verb (tests/bits/golden.txt) by yoke.wasm, all in one process, each in an instance of its own: one of eight, all
// of them with YOKE_FULL=1, or those of a range of lines. node test_recorded.mjs NODE.mjs YOKE.wasm [FROM TO]
import { createHash } from "node:crypto";
import { readFileSync, statSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const [, , library, module, from, to] = process.argv;
const { REPORT_SCRIPT, runCommand } = await import(pathToFileURL(resolve(library)).href);
const root = fileURLToPath(new URL("../../", import.meta.url));
if (!runCommand) {
  console.log("skipped: npm could not get esbuild");
  process.exit(77);
}
const compiled = new WebAssembly.Module(readFileSync(module));
const file = (path) => (statSync(path, { throwIfNoEntry: false })?.isFile() ? readFileSync(path) : null);
const script = join(dirname(module), "web/report.js"); // where the build leaves it
const read = (path) => (path === REPORT_SCRIPT ? readFileSync(script) : file(root + path) ?? file("/" + path));

// Returns the hash that golden.py has of an answer.
function hashOf(command) {
  const words = (command.match(/'[^']*'|\S+/g) ?? []).map((word) => word.replace(/^'|'$/g, "")), { exit, out, err } = runCommand(compiled, { words, files: new Map(), read });
  let text = Buffer.from(out);
  if (words[0] === "report") text = Buffer.from(text.toString("latin1").replace(/<script>[^]*?<\/script>/g, ""), "latin1");
  return createHash("sha256").update(`${exit}\n`).update(text).update("\n").update(err).digest("hex").slice(0, 16);
}

const all = readFileSync(root + "tests/bits/golden.txt", "utf8").trimEnd().split("\n");
const lines = from ? all.slice(Number(from), Number(to ?? all.length)) : all.filter((_, k) => process.env.YOKE_FULL || k % 8 === 5);
let wrong = 0;
lines.forEach((line, k) => {
  const space = line.indexOf(" ");
  if (hashOf(line.slice(space + 1)) !== line.slice(0, space)) {
    wrong++;
    console.log(`differs: ${line.slice(space + 1)}`);
  }
  if ((k + 1) % 50 === 0) console.log(`${k + 1} of ${lines.length}, ${wrong} differ`);
});
console.log(`${lines.length} answers, ${wrong} differ`);
process.exit(wrong ? 1 : 0);
