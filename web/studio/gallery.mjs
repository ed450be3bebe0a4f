// Writes the gallery: every example with its text and the core's picture of it. node gallery.mjs YOKE EXAMPLES FILE
import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";

const [, , yoke, folder, output] = process.argv;

function picture(file) {
  try {
    return execFileSync(yoke, ["draw", file, "--no-labels", "-q"], { encoding: "utf8", maxBuffer: 1 << 26, stdio: ["ignore", "pipe", "ignore"] });
  } catch {
    return "";
  }
}

// The first comment of an example says what it shows; its first sentence is enough here.
const aboutOf = (text) => (text.match(/^(?:#.*\n)+/)?.[0] ?? "").replace(/^#\s?/gm, "").replace(/\s+/g, " ").trim().split(/(?<=[.:;])\s/)[0].replace(/[:;]$/, ".");
const all = readdirSync(folder).filter((name) => name.endsWith(".yaml")).sort().map((name) => {
  const text = readFileSync(join(folder, name), "utf8"), id = basename(name, ".yaml");
  return { id, name: text.match(/^name:\s*(.+?)\s*$/m)?.[1].replace(/^["']|["']$/g, "") ?? id, about: aboutOf(text), text, picture: picture(join(folder, name)) };
});
writeFileSync(output, JSON.stringify(all));
