// Owns the modules: takes one request after the other and answers it. Runs in a worker of the page, or of Node in tests.
import type { Answer, Request, Source } from "./door";
import { Engine } from "./engine";
import { runCommand } from "./wasi";

interface Port { postMessage(answer: Answer): void; onmessage: ((event: { data: Request }) => void) | null }

async function compile(source: Source): Promise<WebAssembly.Module> {
  if (typeof source !== "string") return WebAssembly.compile(source);
  const answer = await fetch(source);
  if (!answer.ok) throw new Error(`${source}: ${answer.status}`);
  return WebAssembly.compile(await answer.arrayBuffer());
}

export function serve(port: Port): void {
  let engine: Engine | null = null, command: Promise<WebAssembly.Module> | null = null, whole: Source = "";

  async function start(small: Source, later: Source): Promise<string> {
    whole = later;
    engine = new Engine(await compile(small));
    return engine.version();
  }

  async function run(words: string[], texts: Record<string, string>): Promise<unknown> {
    command ??= compile(whole);
    command.catch(() => (command = null)); // asked again, it is fetched again
    const encode = new TextEncoder(), decode = new TextDecoder();
    const files = new Map(Object.entries(texts).map(([name, text]) => [name, encode.encode(text) as Uint8Array]));
    const given = new Map(files), reply = runCommand(await command, { words, files });
    const written = [...files].filter(([name, bytes]) => given.get(name) !== bytes);
    return {
      exit: reply.exit, out: decode.decode(reply.out), err: decode.decode(reply.err),
      files: Object.fromEntries(written.map(([name, bytes]) => [name, bytes.slice()])),
    };
  }

  async function answer({ kind, words }: Request): Promise<unknown> {
    if (kind === "start") return start(words[0] as Source, words[1] as Source);
    if (kind === "run") return run(words[0] as string[], words[1] as Record<string, string>);
    if (!engine) throw new Error("the core has not started");
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
