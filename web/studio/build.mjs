// Bundles Studio into a folder: node build.mjs FOLDER. The build puts the core's modules and the gallery beside it.
import { build } from "esbuild";
import { cpSync, mkdirSync } from "node:fs";
import { join } from "node:path";

const folder = process.argv[2] ?? "dist";
mkdirSync(folder, { recursive: true });
const common = { bundle: true, minify: true, target: "es2022", legalComments: "eof", logLevel: "warning", outdir: folder };
await build({ ...common, entryPoints: { studio: "src/main.ts", plot: "src/panels/plot.ts", film: "src/keep/film.ts" }, format: "iife" });
await build({ ...common, entryPoints: { worker: "../core/worker.ts" }, format: "iife" });
await build({ ...common, entryPoints: { "core-node": "../core/node.ts" }, format: "esm", platform: "node", outdir: "tools", outExtension: { ".js": ".mjs" } });
for (const name of ["index.html", "sw.js"]) cpSync(name, join(folder, name));
