// The command as WebAssembly, run once like a program: node yoke.mjs NODE.mjs YOKE.wasm WORD... Reads files of the present folder,
// and writes none.
import { readFileSync, statSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [, , library, module, ...words] = process.argv;
const { REPORT_SCRIPT, runCommand } = await import(pathToFileURL(resolve(library)).href);
const file = (path) => (statSync(path, { throwIfNoEntry: false })?.isFile() ? readFileSync(path) : null);
const script = join(dirname(module), "web/report.js"); // where the build leaves it
const read = (path) => file(path === REPORT_SCRIPT ? script : path) ?? file("/" + path); // the command says no leading slash
const reply = runCommand(new WebAssembly.Module(readFileSync(module)), { words, files: new Map(), read });
process.stderr.write(reply.err);
process.stdout.write(reply.out, () => process.exit(reply.exit));
