// Calls the flat functions of core.wasm: writes what goes in, reads what comes out. One machine in each engine.
import type { Forces, Opened, Pose, Rates } from "./door";
import { instanceOf } from "./wasi";

interface Exports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  ys_input(length: number): number;
  ys_numbers(): number;
  ys_number_count(): number;
  ys_number_room(count: number): number;
  ys_text(): number;
  ys_text_length(): number;
  ys_message(): number;
  ys_status_name(status: number): number;
  ys_version(): number;
  ys_open(length: number): number;
  ys_parameter(value: number): number;
  ys_scene(): number;
  ys_pose(): number;
  ys_time(): number;
  ys_at(count: number): number;
  ys_move_time(time: number): number;
  ys_drag(body: number, x: number, y: number, toX: number, toY: number): number;
  ys_look(scale: number): number;
  ys_ghosts(): number;
  ys_ghost(index: number): number;
  ys_choose(index: number): number;
  ys_curves(from: number, to: number, steps: number): number;
  ys_trace(body: number, x: number, y: number, from: number, to: number, steps: number): number;
  ys_release(): number;
  ys_pull(body: number, x: number, y: number, toX: number, toY: number, stiffness: number): number;
  ys_step(seconds: number): number;
  ys_hold(): number;
  ys_rates(): number;
  ys_forces(): number;
  ys_turn(coordinate: number): number;
  ys_save(): number;
  ys_restore(length: number): number;
}

export interface Pull { body: string; point: [number, number]; to: [number, number]; stiffness: number }

// The core has no memory left; it may be half way, so another one takes its place.
export class OutOfMemory extends Error { override name = "OutOfMemory"; }

const NO_MEMORY = -6; // YK_NO_MEMORY
const encoder = new TextEncoder(), decoder = new TextDecoder();

export class Engine {
  private readonly call: Exports;
  private names: string[] = []; // of the bodies
  private points = 0;
  private ghostCount = 0; // other assemblies that the page knows

  // Of core.wasm, or of panels.wasm, which imports a system (wasi.ts) that these functions do not use.
  constructor(module: WebAssembly.Module) {
    this.call = instanceOf(module) as unknown as Exports;
    this.call._initialize();
  }

  // Takes over from another engine, which ends: the machine in its present state, and the ghosts that were shown.
  adopt(from: Engine): void {
    if (from.call.ys_save() < 0) throw new OutOfMemory("out of memory");
    const bytes = new Uint8Array(from.call.memory.buffer, from.call.ys_text(), from.call.ys_text_length()), at = this.call.ys_input(bytes.length);
    if (at === 0) throw new OutOfMemory("out of memory");
    new Uint8Array(this.call.memory.buffer, at, bytes.length).set(bytes);
    if (this.call.ys_restore(bytes.length) < 0) throw new OutOfMemory("the machine could not be handed over");
    [this.names, this.points] = [from.names, from.points];
    if (from.ghostCount > 0) this.ghosts();
  }

  // --- in and out; memory may grow in every call, so views are made anew

  private put(text: string): number {
    const bytes = encoder.encode(text), at = this.call.ys_input(bytes.length);
    if (at === 0) throw new OutOfMemory("out of memory");
    new Uint8Array(this.call.memory.buffer, at, bytes.length).set(bytes);
    return bytes.length;
  }

  private string(at: number): string {
    const bytes = new Uint8Array(this.call.memory.buffer);
    return decoder.decode(bytes.subarray(at, bytes.indexOf(0, at)));
  }

  private text(): string {
    const at = this.call.ys_text();
    if (at === 0) throw new OutOfMemory("out of memory");
    return decoder.decode(new Uint8Array(this.call.memory.buffer, at, this.call.ys_text_length()));
  }

  private numbers(): Float64Array<ArrayBuffer> {
    const count = this.call.ys_number_count();
    return count === 0 ? new Float64Array(0) : new Float64Array(this.call.memory.buffer, this.call.ys_numbers(), count).slice();
  }

  private checked(status: number): number {
    if (status === NO_MEMORY) throw new OutOfMemory("out of memory");
    return status;
  }

  private told(status: number): { status: string; message: string } {
    return { status: this.string(this.call.ys_status_name(this.checked(status))), message: this.string(this.call.ys_message()) };
  }

  private pose(status: number): Pose {
    const { status: word, message } = this.told(status), numbers = this.numbers(), bodies = 3 * this.names.length;
    return {
      status: word, message, time: this.call.ys_time(), parts: this.text(),
      bodies: numbers.slice(0, bodies), coordinates: numbers.slice(bodies),
    };
  }

  private body(name: string): number {
    const index = this.names.indexOf(name);
    return index < 0 ? 0xffffffff : index;
  }

  // --- what may be asked

  private opened(status: number): Opened {
    if (status < 0) throw new OutOfMemory("out of memory");
    const told = JSON.parse(this.text()) as Pick<Opened, "problems" | "lacks" | "machine">;
    this.names = told.machine ? told.machine.bodies.map((body) => body.name) : [];
    this.points = told.machine ? told.machine.bodies.reduce((sum, body) => sum + body.points.length, 0) : 0;
    this.ghostCount = 0;
    if (!told.machine) return { ...told, scene: null, pose: null };
    const drawn = this.call.ys_scene();
    if (drawn < 0) throw new OutOfMemory("out of memory");
    const scene = drawn > 0 ? this.text() : null;
    return { ...told, scene, pose: this.pose(this.call.ys_pose()) };
  }

  open(text: string, name: string): Opened {
    const whole = text.replaceAll("\0", "\ufffd"), length = encoder.encode(whole).length;
    this.put(whole + "\0" + name);
    return this.opened(this.call.ys_open(length));
  }

  look(scale: number): { scene: string | null; pose: Pose } {
    const drawn = this.call.ys_look(scale);
    if (drawn < 0) throw new OutOfMemory("out of memory");
    return { scene: drawn > 0 ? this.text() : null, pose: this.pose(this.call.ys_pose()) };
  }

  parameter(name: string, value: number): Opened {
    this.put(name);
    return this.opened(this.call.ys_parameter(value));
  }

  at(inputs: Record<string, number>): Pose {
    const names = Object.keys(inputs), room = this.call.ys_number_room(Math.max(names.length, 1));
    if (room === 0) throw new OutOfMemory("out of memory");
    new Float64Array(this.call.memory.buffer, room, names.length).set(Object.values(inputs));
    this.put(names.join("\0") + "\0");
    return this.pose(this.call.ys_at(names.length));
  }

  time(t: number): Pose {
    return this.pose(this.call.ys_move_time(t));
  }

  drag(body: string, point: [number, number], to: [number, number]): Pose {
    return this.pose(this.call.ys_drag(this.body(body), point[0], point[1], to[0], to[1]));
  }

  ghosts(): Pose[] {
    this.ghostCount = this.checked(this.call.ys_ghosts());
    return Array.from({ length: this.ghostCount }, (_, k) => this.pose(this.call.ys_ghost(k)));
  }

  choose(index: number): Pose {
    return this.pose(this.call.ys_choose(index));
  }

  curves(over: string, from: number, to: number, steps: number, of: string[]):
    { x: Float64Array; of: Float64Array[]; status: string; message: string } {
    this.put([over, ...of].map((name) => name + "\0").join(""));
    const told = this.told(this.call.ys_curves(from, to, steps)), numbers = this.numbers();
    const rows = numbers.length / (1 + of.length), column = (k: number) => numbers.slice(k * rows, (k + 1) * rows);
    return { ...told, x: column(0), of: of.map((_, k) => column(1 + k)) };
  }

  trace(body: string, point: [number, number], over: string, from: number, to: number, steps: number): Float64Array {
    this.put(over + "\0");
    this.checked(this.call.ys_trace(this.body(body), point[0], point[1], from, to, steps));
    return this.numbers();
  }

  release(): Pose {
    return this.pose(this.call.ys_release());
  }

  step(seconds: number, pull?: Pull): Pose {
    if (pull)
      this.call.ys_pull(this.body(pull.body), pull.point[0], pull.point[1], pull.to[0], pull.to[1], pull.stiffness);
    else
      this.call.ys_pull(0, 0, 0, 0, 0, 0);
    return this.pose(this.call.ys_step(seconds));
  }

  hold(): Pose {
    return this.pose(this.call.ys_hold());
  }

  forces(): Forces {
    const told = this.told(this.call.ys_forces());
    return { ...told, joints: this.numbers() };
  }

  turn(coordinate: number): { from: number; rate: number } | null {
    this.checked(this.call.ys_turn(coordinate));
    const [from, rate] = this.numbers();
    return rate === undefined ? null : { from, rate };
  }

  rates(): Rates | null {
    const { status } = this.told(this.call.ys_rates()), numbers = this.numbers();
    return numbers.length > 0 ? { status, points: numbers.slice(0, 4 * this.points), coordinates: numbers.slice(4 * this.points) } : null;
  }

  version(): string {
    return this.string(this.call.ys_version());
  }
}
