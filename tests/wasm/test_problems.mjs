// Files that are wrong: the page gets the same problems as the command prints, at the same places.
// node test_problems.mjs NODE.mjs CORE.wasm YOKE.wasm FOLDER
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [, , library, small, whole, folder] = process.argv;
const { Engine, runCommand } = await import(pathToFileURL(resolve(library)).href);
if (!Engine) {
  console.log("skipped: npm could not get esbuild");
  process.exit(77);
}
const engine = new Engine(new WebAssembly.Module(readFileSync(small)));
const command = new WebAssembly.Module(readFileSync(whole));
const head = /^[^ ].*: (error|warning|note): .*\[[NWE]\d{4}\]$|^hint: /;
let failed = 0, found = 0;

// `text` as the file has it, byte for byte: some are not UTF-8, which a page never is.
for (const file of readdirSync(folder).filter((name) => name.endsWith(".yaml")).sort()) {
  const bytes = readFileSync(join(folder, file)), text = bytes.toString("utf8");
  if (Buffer.compare(Buffer.from(text.replaceAll("\0", "\ufffd")), bytes) !== 0) continue;
  const { problems, machine } = engine.open(text, file);
  const { err, exit } = runCommand(command, { words: ["check", "--sketch", file], files: new Map([[file, new Uint8Array(bytes)]]) });
  const wanted = new TextDecoder().decode(err).split("\n").filter((line) => head.test(line));
  const told = problems.flatMap(({ code, severity, message, hint, line, column }) =>
    [`${file}:${line > 0 ? `${line}:${column}:` : ""} ${severity}: ${message} [${code}]`, ...(hint ? ["hint: " + hint] : [])]);
  found += problems.length;
  try {
    assert.deepEqual(told, wanted);
    assert.equal(machine === null, exit === 2);
  } catch (problem) {
    failed++;
    console.log(`${file}: ${problem.message}`);
  }
}
console.log(`${found} problems compared; ${failed} files differ`);
assert.ok(found > 80, "there is something to compare");
process.exit(failed > 0 ? 1 : 0);
