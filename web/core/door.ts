// The door between the page and the core: what may be asked, and the answers. All numbers are SI and radians; every text,
// message, picture and number comes from the core.
export interface Problem { code: string; severity: "error" | "warning" | "note"; message: string; hint?: string;
                           line: number; column: number; endColumn?: number }          // 1-based; 0 when it has no place
export interface Lack { kind: string; optional: boolean; text: string; mend: string; path?: string; value?: string; body?: string; point?: string; other?: string; coordinate?: string }
export interface Parameter { name: string; value: number; text: string; unit: string; line: number }
export interface Coordinate { name: string; kind: "angle" | "length"; joint: string; driven: boolean; free: boolean; value: number }
export interface Joint { name: string; kind: string; bodies: string[]; points: [string, string] | []; line: number }
export interface Body { name: string; ground: boolean; line: number; points: { name: string; at: [number, number] }[] }   // in the body's axes
export interface Machine { name: string; bodies: Body[]; joints: Joint[]; coordinates: Coordinate[]; parameters: Parameter[]; freedom: number; moves: boolean }
export interface Opened { problems: Problem[]; lacks: Lack[]; machine: Machine | null; scene: string | null; pose: Pose | null }
// scene: one SVG document by the core, with <g data-body="NAME"> in the body's own axes, so that a pose is one transform for each body;
// joints, springs and what spans bodies are drawn by the core again for each pose in `parts` (SVG fragments), empty if nothing spans
export interface Pose { status: string; message: string; time: number; bodies: Float64Array /* x, y, angle for each body */; coordinates: Float64Array; parts: string }
// Velocities and accelerations: vx, vy, ax, ay of every point, body by body, in the ground's axes; the rate and the acceleration of every coordinate.
export interface Rates { status: string; points: Float64Array; coordinates: Float64Array }
// For every joint: x, y, the force fx, fy of its first body on its second, N, and 1 if it is determinate. Empty if it cannot be computed; the message says why.
export interface Forces { status: string; message: string; joints: Float64Array }
// complete: false: the command was stopped; `out` is its output until then, and there is no exit status.
export interface Reply { exit: number; out: string; err: string; files: Record<string, Uint8Array>; complete: boolean }
export interface Core {
  open(text: string, name: string): Promise<Opened>;                      // reads as a sketch; never rejects because of the text
  parameter(name: string, value: number): Promise<Opened>;                // a slider: without parsing the text again where the engine can
  look(pixelsPerMetre: number): Promise<{ scene: string | null; pose: Pose }>; // draws the scene for this view, and all scenes after it: lines and names keep their width
  at(inputs: Record<string, number>): Promise<Pose>;                      // moves there (yk_state_move_to); a limit: last valid pose + message
  time(t: number): Promise<Pose>;
  drag(body: string, point: [number, number], to: [number, number]): Promise<Pose>;   // yk_state_drag; point in the body's axes, `to` in the ground's
  ghosts(): Promise<Pose[]>;                                              // other assemblies here
  choose(index: number): Promise<Pose>;
  curves(over: string, from: number, to: number, steps: number, of: string[]): Promise<{ x: Float64Array; of: Float64Array[]; status: string; message: string }>;
  trace(body: string, point: [number, number], over: string, from: number, to: number, steps: number): Promise<Float64Array>;  // x, y pairs
  release(): Promise<Pose>;                                               // simulation from here under loads and gravity
  step(seconds: number, pull?: { body: string; point: [number, number]; to: [number, number]; stiffness: number }): Promise<Pose>;
  hold(): Promise<Pose>;                                                  // ends the simulation
  rates(): Promise<Rates | null>;                                         // of the pose shown; null where it has no velocities
  forces(): Promise<Forces>;                                              // in the joints, with the inputs moving as they do in the pose
  turn(coordinate: number): Promise<{ from: number; rate: number } | null>; // where its drive begins at t = 0, and the rate, if that does not change
  run(words: string[], files: Record<string, string>, hear?: (text: string) => void): Promise<Reply>; // with --so-far `hear` takes what it prints, while it runs. The command itself: run(["derive", "machine.yaml", "--format", "mathml"], {"machine.yaml": text})
  stop(): void;                                                           // ends the command that runs, or waits to run: its reply comes at once, and is not complete. The machine stays as opened
}

// A newer request of its kind took the place of one that still waited.
export class Overtaken extends Error { override name = "Overtaken"; }
// The core died or ran out of memory during the request, and was started anew with the last text.
export class CoreLost extends Error { override name = "CoreLost"; }

// Where the modules come from: an address to fetch, or the bytes themselves (a page in one file).
export type Source = string | ArrayBuffer | Uint8Array<ArrayBuffer>;

// Between client and worker.
export interface Request { id: number; kind: string; words: unknown[] }
export interface Answer { id: number; value?: unknown; lost?: string; refused?: string; heard?: string /* of a command that still runs */ }
