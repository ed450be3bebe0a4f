// Gives the page its core: starts the worker, hands it one request at a time, and starts another one when it dies.
import { CoreLost, Overtaken } from "./door";
import type { Answer, Core, Opened, Reply, Request, Source } from "./door";

export * from "./door";

// The interface of a browser's Worker; tests give one of Node.
export interface WorkerLike {
  postMessage(request: Request): void;
  terminate(): void;
  onmessage: ((event: { data: Answer }) => void) | null;
  onerror: ((event: unknown) => void) | null;
}

export interface CoreOptions {
  worker: () => WorkerLike; // a new worker that runs worker.ts
  small: Source; // core.wasm
  panels: Source; // panels.wasm, loaded behind core.wasm, or when curves, simulations or the verbs in it are first asked for
  whole: Source; // yoke.wasm, loaded when `run` first has a verb that panels.wasm has not
  report?: Source; // the report's script, handed to the verb `report`; without it reports do not move
  patience?: number; // ms that a newer request of its kind, or an opening, waits for one that takes long; default 3000
  onRestart?: (opened: Opened | null) => void; // the core was started anew, with the last text
}

interface Waiting { request: Request; key: string; resolve: (value: never) => void; reject: (problem: Error) => void; hear?: (text: string) => void; heard?: string }

// Requests that may take each other's place have one key.
function keyOf(kind: string, words: unknown[]): string {
  const own = kind === "run" ? (words[0] as string[])[0] : kind === "parameter" || kind === "choose" ? words[0]
    : kind === "curves" || kind === "trace" ? JSON.stringify(words) : "";
  return kind + ":" + own;
}

class Client {
  private port!: WorkerLike;
  private busy: Waiting | null = null;
  private readonly queue: Waiting[] = [];
  private count = 0;
  private text: [string, string] | null = null; // last opened
  private timer: ReturnType<typeof setTimeout> | undefined;
  private isStarting = true;

  constructor(private readonly options: CoreOptions) {
    this.start();
  }

  // --- the worker

  private start(): void {
    this.isStarting = true;
    this.port = this.options.worker();
    this.port.onmessage = ({ data }) => this.take(data);
    this.port.onerror = () => this.lose("the core died");
    this.send({ request: this.make("start", [this.options.small, this.options.panels, this.options.whole, this.options.report]), key: "start", resolve: () => this.started(),
      reject: (problem) => this.queue.splice(0).forEach((waiting) => waiting.reject(problem)) });
  }

  private started(): void {
    this.isStarting = false;
  }

  private make(kind: string, words: unknown[]): Request {
    return { id: ++this.count, kind, words };
  }

  private send(waiting: Waiting): void {
    this.busy = waiting;
    this.port.postMessage(waiting.request);
  }

  private take(answer: Answer): void {
    const asked = this.busy;
    if (!asked || answer.id !== asked.request.id) return;
    if (answer.heard !== undefined) {
      asked.heard = (asked.heard ?? "") + answer.heard;
      return asked.hear?.(answer.heard);
    }
    if (answer.lost !== undefined) return this.lose(answer.lost);
    this.busy = null;
    clearTimeout(this.timer);
    this.timer = undefined;
    if (answer.refused !== undefined) asked.reject(new Error(answer.refused));
    else asked.resolve(answer.value as never);
    this.next();
  }

  private next(): void {
    const waiting = this.busy ? undefined : this.queue.shift();
    if (waiting) this.send(waiting);
    this.watch();
  }

  // Ends the worker and starts another one with the last text; what it worked on is lost, but for a reply that was made of it.
  private lose(why: string, asOvertaken = false, reply?: Reply): void {
    const asked = this.busy;
    this.busy = null;
    clearTimeout(this.timer);
    this.timer = undefined;
    this.port.onmessage = this.port.onerror = null;
    this.port.terminate();
    if (reply) asked?.resolve(reply as never);
    else asked?.reject(asOvertaken ? new Overtaken(why) : new CoreLost(why));
    if (this.isStarting || !asked) { // it does not even start: not again by itself, but with the next request
      this.queue.splice(0).forEach((waiting) => waiting.reject(new CoreLost(why)));
      this.port = { postMessage: () => {}, terminate: () => {}, onmessage: null, onerror: null };
      this.isStarting = true;
      this.isDead = true;
      return;
    }
    const isOpening = asked.request.kind === "open";
    this.start();
    if (this.text && !isOpening) this.restore(this.text);
  }

  private isDead = false;

  private restore(text: [string, string]): void {
    const told = (opened: Opened | null) => this.options.onRestart?.(opened);
    this.queue.unshift({ request: this.make("open", text), key: "restore", resolve: told as (value: never) => void, reject: () => told(null) });
  }

  // A request that takes long while a newer one of its kind waits, or another text, is given up.
  private watch(): void {
    const asked = this.busy;
    if (this.timer !== undefined || !asked || asked.key === "start") return;
    if (!this.queue.some((waiting) => waiting.key === asked.key || waiting.request.kind === "open")) return;
    this.timer = setTimeout(() => this.lose("a newer request took its place", true), this.options.patience ?? 3000);
  }

  // --- requests

  ask<T>(kind: string, ...words: unknown[]): Promise<T> {
    return this.listen<T>(undefined, kind, words);
  }

  // Asks, and hears meanwhile what a command prints.
  listen<T>(hear: ((text: string) => void) | undefined, kind: string, words: unknown[]): Promise<T> {
    if (this.isDead) {
      this.isDead = false;
      this.start();
      if (this.text && kind !== "open") this.restore(this.text);
    }
    if (kind === "open") this.text = words as [string, string];
    const key = keyOf(kind, words), older = this.queue.findIndex((waiting) => waiting.key === key);
    if (older >= 0) this.queue.splice(older, 1)[0].reject(new Overtaken("a newer request took its place"));
    return new Promise<T>((resolve, reject) => {
      this.queue.push({ request: this.make(kind, words), key, resolve: resolve as (value: never) => void, reject, hear });
      this.next();
    });
  }

  // Ends the command that runs, and those that wait.
  stop(): void {
    const soFar = (waiting: Waiting): Reply => ({ exit: -1, out: waiting.heard ?? "", err: "", files: {}, complete: false });
    for (let k = this.queue.length - 1; k >= 0; k--) if (this.queue[k].request.kind === "run") {
      const [waiting] = this.queue.splice(k, 1);
      waiting.resolve(soFar(waiting) as never);
    }
    if (this.busy?.request.kind === "run") this.lose("it was stopped", false, soFar(this.busy));
  }

  close(): void {
    this.port.onmessage = this.port.onerror = null;
    this.port.terminate();
    clearTimeout(this.timer);
    const all = this.busy ? [this.busy, ...this.queue.splice(0)] : this.queue.splice(0);
    this.busy = null;
    all.forEach((waiting) => waiting.reject(new CoreLost("the core was closed")));
  }
}

// Starts a core. close() ends its worker.
export function startCore(options: CoreOptions): Core & { close(): void } {
  const client = new Client(options);
  return {
    open: (text, name) => client.ask("open", text, name),
    parameter: (name, value) => client.ask("parameter", name, value),
    look: (scale) => client.ask("look", scale),
    at: (inputs) => client.ask("at", inputs),
    time: (t) => client.ask("time", t),
    drag: (body, point, to) => client.ask("drag", body, point, to),
    ghosts: () => client.ask("ghosts"),
    choose: (index) => client.ask("choose", index),
    curves: (over, from, to, steps, of) => client.ask("curves", over, from, to, steps, of),
    trace: (body, point, over, from, to, steps) => client.ask("trace", body, point, over, from, to, steps),
    release: () => client.ask("release"),
    step: (seconds, pull) => client.ask("step", seconds, pull),
    hold: () => client.ask("hold"),
    rates: () => client.ask("rates"),
    forces: () => client.ask("forces"),
    turn: (coordinate) => client.ask("turn", coordinate),
    run: (words, files, hear) => client.listen(hear, "run", [words, files]),
    stop: () => client.stop(),
    close: () => client.close(),
  };
}
