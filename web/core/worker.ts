// Owns the modules: takes one request after the other and answers it. Runs in a worker of the page, or of Node in tests.
import type { Answer, Request, Source } from "./door";
import { Engine } from "./engine";
import { REPORT_SCRIPT, runCommand } from "./wasi";

interface Port { postMessage(answer: Answer): void; onmessage: ((event: { data: Request }) => void) | null }

async function load(source: Source): Promise<ArrayBuffer | Uint8Array<ArrayBuffer>> {
  if (typeof source !== "string") return source;
  const answer = await fetch(source);
  if (!answer.ok) throw new Error(`${source}: ${answer.status}`);
  return answer.arrayBuffer();
}

const compile = async (source: Source): Promise<WebAssembly.Module> => WebAssembly.compile(await load(source));

// The verbs of panels.wasm, and the calls that core.wasm does not have.
const PANELS = new Set(["check", "solve", "sweep", "simulate", "draw", "cam", "derive", "gears"]);
const BEHIND = new Set(["curves", "forces", "trace", "release", "step", "hold"]);
const LEAVES = /^yoke: error: this module does not /m; // what panels.wasm says of what it leaves to yoke.wasm
const SO_FAR = "--so-far"; // the command reports what it has found while it runs
const PAUSE = 400; // ms after the first machine, before the module behind is fetched

export function serve(port: Port): void {
  let engine: Engine | null = null, isWhole = false; // the engine is of panels.wasm
  let script: Source | undefined; // of reports: its address, then its bytes
  const sources: Record<string, Source> = {}, modules: Record<string, Promise<WebAssembly.Module>> = {};

  // Compiles a module once; where that fails, it is tried again when it is asked for again.
  function module(name: "panels" | "whole"): Promise<WebAssembly.Module> {
    modules[name] ??= compile(sources[name]);
    modules[name].catch(() => delete modules[name]);
    return modules[name];
  }

  async function start(small: Source, panels: Source, whole: Source, report?: Source): Promise<string> {
    [sources.panels, sources.whole, script] = [panels, whole, report];
    engine = new Engine(await compile(small));
    return engine.version();
  }

  // Lets the engine of panels.wasm take over the machine in its present state.
  async function grow(): Promise<void> {
    const larger = new Engine(await module("panels"));
    larger.adopt(engine!);
    engine = larger;
    isWhole = true;
  }

  // Loads it once; where that fails, it is tried again with the next report.
  async function scriptOfReports(): Promise<Uint8Array | null> {
    if (script !== undefined) script = new Uint8Array(await load(script));
    return script ?? null;
  }

  async function run(words: string[], texts: Record<string, string>, id: number): Promise<unknown> {
    const encode = new TextEncoder(), decode = new TextDecoder(), hearing = new TextDecoder(), command = await module(PANELS.has(words[0]) ? "panels" : "whole");
    const files = new Map(Object.entries(texts).map(([name, text]) => [name, encode.encode(text) as Uint8Array]));
    const given = new Map(files), isHeard = words.includes(SO_FAR);
    const hear = isHeard ? (bytes: Uint8Array) => port.postMessage({ id, heard: hearing.decode(bytes, { stream: true }) }) : undefined;
    const script = words.includes("report") ? await scriptOfReports() : null;
    const read = (path: string) => (path === REPORT_SCRIPT ? script : null);
    let reply = runCommand(command, { words, files, hear, read });
    if (PANELS.has(words[0]) && LEAVES.test(decode.decode(reply.err))) reply = runCommand(await module("whole"), { words, files, hear, read });
    const written = [...files].filter(([name, bytes]) => given.get(name) !== bytes);
    return {
      exit: reply.exit, out: decode.decode(reply.out), err: decode.decode(reply.err), complete: true,
      files: Object.fromEntries(written.map(([name, bytes]) => [name, bytes.slice()])),
    };
  }

  async function answer({ id, kind, words }: Request): Promise<unknown> {
    if (kind === "start") return start(...words as [Source, Source, Source, Source?]);
    if (kind === "run") return run(words[0] as string[], words[1] as Record<string, string>, id);
    if (!engine) throw new Error("the core has not started");
    if (BEHIND.has(kind) && !isWhole) await grow();
    if (kind === "open" && !modules.panels) setTimeout(() => void module("panels").catch(() => undefined), PAUSE);
    const ask = engine[kind as keyof Engine] as (...words: unknown[]) => unknown;
    return ask.apply(engine, words);
  }

  port.onmessage = async ({ data }) => {
    try {
      port.postMessage({ id: data.id, value: await answer(data) });
    } catch (problem) {
      // What the module itself threw (a trap, memory) leaves it half way; all else leaves it as it was.
      const words = problem instanceof Error ? `${problem.name}: ${problem.message}` : String(problem);
      const isLost = problem instanceof WebAssembly.RuntimeError || problem instanceof RangeError ||
        (problem instanceof Error && problem.name === "OutOfMemory");
      port.postMessage(isLost ? { id: data.id, lost: words } : { id: data.id, refused: words });
    }
  };
}

declare const self: Port & { document?: unknown };
if (typeof self !== "undefined" && typeof self.postMessage === "function" && self.document === undefined) serve(self);
