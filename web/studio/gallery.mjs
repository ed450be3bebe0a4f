// Writes the gallery: every example with its text and the core's picture of it.
// node gallery.mjs CORE-NODE.mjs YOKE.wasm EXAMPLES FILE
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [, , library, module, folder, output] = process.argv;
const { runCommand } = await import(pathToFileURL(resolve(library)).href);
const yoke = new WebAssembly.Module(readFileSync(module)), decoder = new TextDecoder();

function picture(text) {
  const reply = runCommand(yoke, { words: ["draw", "machine.yaml", "--no-labels", "-q"], files: new Map([["machine.yaml", new TextEncoder().encode(text)]]) });
  return reply.exit === 0 ? decoder.decode(reply.out) : "";
}

// The first comment of an example says what it shows; its first sentence is enough here.
const aboutOf = (text) => (text.match(/^(?:#.*\n)+/)?.[0] ?? "").replace(/^#\s?/gm, "").replace(/\s+/g, " ").trim().split(/(?<=[.:;])\s/)[0].replace(/[:;]$/, ".");
const all = readdirSync(folder).filter((name) => name.endsWith(".yaml")).sort().map((name) => {
  const text = readFileSync(join(folder, name), "utf8"), id = basename(name, ".yaml");
  return { id, name: text.match(/^name:\s*(.+?)\s*$/m)?.[1].replace(/^["']|["']$/g, "") ?? id, about: aboutOf(text), text, picture: picture(text) };
});
writeFileSync(output, JSON.stringify(all));
