// Films of one turn: poses of the core, painted as the core draws them, recorded by the browser (WebM, MP4) or written as GIF. A core of
// its own moves the machine, so that what is on the canvas stays. A script of its own, loaded with the first film.
import type { Core, Machine, Pose } from "../../../core/door";
import { AXES, axesOf, frameOf, toGround } from "../canvas/frames";
import { Painter } from "../canvas/painter";
import type { Shot } from "../canvas/painter";
import { picture } from "../markup";
import { gifOf } from "./gif";
import type { Picture } from "./gif";

type Worker = Core & { close(): void };
export interface Order { text: string; name: string; seconds: number /* of the machine, a turn */; lasts: number /* s, the film */; traces: Float64Array[]; tell: (part: number) => void }

const PER_SECOND = 25, LONGEST = 20, SHORTEST = 1.5; // s
const WIDE = 1280, WIDE_GIF = 640, PICTURES = 60; // px; of a GIF
const BORDER = 70; // px round the points of the machine, at the width of a film
const FEW = 24; // poses that say how much of the plane is needed
const PAPER = "#fcfcfa", TRACE = "#4149c3";
class Studio {
  private scene: Painter;
  private axes: Float64Array;
  readonly context: CanvasRenderingContext2D;

  constructor(private machine: Machine, scene: string, private shot: Shot, width: number, height: number, private traces: Float64Array[]) {
    const root = picture(scene)!, sheet = document.createElement("canvas");
    [this.perMetre, this.origin] = [Number(root.getAttribute("data-scale")), (root.getAttribute("data-origin") ?? "0 0").split(" ").map(Number)];
    [sheet.width, sheet.height] = [width, height];
    this.context = sheet.getContext("2d", { willReadFrequently: true })!;
    this.scene = new Painter(root, machine, this.perMetre, this.origin, false);
    this.axes = new Float64Array(AXES * (machine.bodies.length + 1));
  }
  private perMetre: number;
  private origin: number[];

  paint(pose: Pose): void {
    const { context, shot } = this, { width, height } = context.canvas;
    context.setLineDash([]);
    context.fillStyle = PAPER;
    context.fillRect(0, 0, width, height);
    axesOf(pose, this.axes);
    for (const points of this.traces) this.trace(points);
    this.scene.paint(context, shot, this.axes);
    const parts = pose.parts ? picture(`<svg xmlns="http://www.w3.org/2000/svg">${pose.parts}</svg>`) : null;
    if (parts) new Painter(parts, this.machine, this.perMetre, this.origin, false).paint(context, shot, this.axes);
  }

  private trace(points: Float64Array): void {
    const { context, shot } = this;
    context.beginPath();
    for (let k = 0; k + 1 < points.length; k += 2) context[k ? "lineTo" : "moveTo"](shot.x + shot.scale * points[k], shot.y - shot.scale * points[k + 1]);
    [context.strokeStyle, context.lineWidth] = [TRACE, 1.6];
    context.stroke();
  }

  get picture(): Picture {
    const { width, height } = this.context.canvas;
    return this.context.getImageData(0, 0, width, height);
  }
}

// Returns the poses at even times of the turn, up to where the machine cannot go on.
async function posesOf(core: Worker, seconds: number, count: number, tell: (part: number) => void): Promise<Pose[]> {
  const poses: Pose[] = [];
  for (let k = 0; k < count; k++) {
    const pose = await core.time((k * seconds) / count);
    if (pose.status !== "ok" && k > 0) break;
    poses.push(pose);
    tell(k / count);
  }
  return poses;
}

// Returns a shot that shows all points of all poses, and its size in px.
function shotOf(machine: Machine, poses: Pose[], wide: number): { shot: Shot; width: number; height: number } {
  const places = poses.flatMap((pose) => machine.bodies.flatMap((body) => body.points.map((point) => toGround(frameOf(machine, pose, body.name), point.at))));
  const border = (BORDER * wide) / WIDE;
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const [x, y] of places) [left, right, low, high] = [Math.min(left, x), Math.max(right, x), Math.min(low, y), Math.max(high, y)];
  const breadth = Math.max(right - left, 1e-9), tall = Math.max(high - low, 1e-9), most = 0.75 * wide;
  const scale = Math.min((wide - 2 * border) / breadth, (most - 2 * border) / tall), even = (size: number) => 2 * Math.ceil(size / 2);
  const width = even(Math.max(scale * breadth + 2 * border, wide / 3)), height = even(Math.max(scale * tall + 2 * border, wide / 4));
  return { shot: { scale, x: width / 2 - scale * (left + breadth / 2), y: height / 2 + scale * (low + tall / 2) }, width, height };
}

async function shoot(core: Worker, order: Order, wide: number, count: number): Promise<{ studio: Studio; poses: Pose[] }> {
  const { machine } = await core.open(order.text, order.name);
  if (!machine) throw new Error("there is no machine");
  const { shot, width, height } = shotOf(machine, await posesOf(core, order.seconds, FEW, () => {}), wide), { scene } = await core.look(shot.scale);
  if (!scene) throw new Error("there is no drawing");
  const poses = await posesOf(core, order.seconds, count, (part) => order.tell(part / 2));
  return { studio: new Studio(machine, scene, shot, width, height, order.traces), poses };
}

const lastsFor = ({ lasts }: Order): number => Math.min(LONGEST, Math.max(SHORTEST, lasts));
const after = (ms: number) => new Promise((done) => setTimeout(done, Math.max(0, ms)));

async function gif(core: Worker, order: Order): Promise<Uint8Array<ArrayBuffer>> {
  const hundredths = Math.max(3, Math.round((100 * lastsFor(order)) / PICTURES)), { studio, poses } = await shoot(core, order, WIDE_GIF, Math.round((100 * lastsFor(order)) / hundredths)), pictures: Picture[] = [];
  for (const [k, pose] of poses.entries()) {
    studio.paint(pose);
    pictures.push(studio.picture);
    order.tell(0.5 + (0.5 * k) / poses.length);
    await after(0);
  }
  return gifOf(pictures, hundredths);
}

// Records in real time, as browsers do.
async function film(core: Worker, order: Order, type: string): Promise<Uint8Array<ArrayBuffer>> {
  const { studio, poses } = await shoot(core, order, WIDE, Math.round(PER_SECOND * lastsFor(order))), stream = studio.context.canvas.captureStream(0);
  const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: 6e6 }), parts: Blob[] = [], track = stream.getVideoTracks()[0] as CanvasCaptureMediaStreamTrack;
  const done = new Promise<void>((resolve, reject) => { recorder.onstop = () => resolve(); recorder.onerror = () => reject(new Error("the browser could not record")); });
  recorder.ondataavailable = (event) => parts.push(event.data);
  recorder.start();
  const begun = performance.now();
  for (const [k, pose] of [...poses, poses[0]].entries()) {
    studio.paint(pose);
    track.requestFrame();
    order.tell(0.5 + (0.5 * k) / poses.length);
    await after(begun + ((k + 1) * 1000) / PER_SECOND - performance.now());
  }
  recorder.stop();
  await done;
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

export type Films = { gif: typeof gif; film: typeof film };
(globalThis as { yokeFilm?: Films }).yokeFilm = { gif, film };
