// Pointer and wheel on the canvas: dragging the machine, panning, zooming, and the clicks of the tools. One finger
// drags or pans, two zoom.
import type { Session } from "../session";
import type { Place } from "../document/gestures";
import { decimal } from "../document/numbers";
import type { Canvas } from "./canvas";
import { bearing, distance } from "./frames";
import type { Point } from "./frames";
import { words } from "../words";
import { grab, meantBy, middle } from "./grab";
import type { Drag } from "./grab";
import { gripAt, moved } from "./poses";
import { Shape } from "./shape";
import { snap } from "./snap";
import type { Spot } from "./snap";
import { meant } from "./stroke";
import { MANY, TOOLS, toolOf } from "./tools";
import type { Tool, ToolId } from "./tools";

export class Hand {
  tool: Tool = TOOLS[0];
  spots: Spot[] = [];
  onTool: (tool: Tool) => void = () => {};
  // Receives a pull on the machine while it is let go; true: the pull is taken.
  onPull: (pull: { body: string; point: [number, number]; to: [number, number] } | null) => boolean = () => false;
  onGrab: () => void = () => {};
  readonly shape: Shape;
  private fingers = new Map<number, [number, number]>();
  private drag: Drag | null = null;
  private pressed: [number, number] = [0, 0];
  private hasMoved = false;
  private waiting = 0;
  private line: Promise<void> = Promise.resolve();
  private isFresh = false; // this press began the gesture
  private stroke: Point[] = []; // of a curve drawn by hand

  constructor(private canvas: Canvas, private session: Session) {
    const { root } = canvas;
    this.shape = new Shape(canvas, session);
    root.addEventListener("pointerdown", (event) => this.down(event));
    root.addEventListener("pointermove", (event) => this.move(event));
    root.addEventListener("pointerup", (event) => void this.up(event));
    root.addEventListener("pointercancel", (event) => this.lost(event));
    root.addEventListener("pointerleave", () => { if (!this.drag) this.hover(null); });
    root.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    root.addEventListener("dblclick", () => this.cancel());
    root.addEventListener("contextmenu", (event) => { if (this.spots.length) { event.preventDefault(); this.cancel(); } });
  }

  choose(id: ToolId): void {
    this.cancel();
    this.tool = toolOf(id);
    this.canvas.shown.tool = id;
    if (id !== "select") {
      this.onGrab();
      void this.session.toStart();
    }
    this.onTool(this.tool);
    this.canvas.redraw();
  }

  cancel(): boolean {
    const shaped = this.drag?.kind === "shape" ? this.drag : null, had = this.spots.length > 0 || shaped !== null;
    if (shaped) [this.drag, this.hasMoved] = [{ kind: "pan" }, true];
    if (shaped) void this.shape.end(shaped.trial, false);
    this.spots = [];
    this.canvas.shown.sketching = null;
    if (this.session.wanted?.isDone === false) this.session.want(null);
    this.canvas.redraw();
    return had;
  }

  private at(event: PointerEvent | WheelEvent): [number, number] {
    const box = this.canvas.root.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  spot(screen: Point, event: PointerEvent): Spot {
    const reach = event.pointerType === "touch" ? 22 : 12, client: Point = [event.clientX, event.clientY];
    return snap(this.session, this.canvas.view, this.canvas.view.toWorld(screen), { reach, grid: this.canvas.step, isFree: event.altKey, client, from: this.spots.at(-1)?.world });
  }

  private down(event: PointerEvent): void {
    const at = this.at(event);
    this.canvas.root.focus({ preventScroll: true });
    this.canvas.shown.crosshair = null;
    this.canvas.root.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, at);
    if (this.fingers.size === 2) return this.pinch();
    if (this.fingers.size > 2) return;
    this.pressed = at;
    this.hasMoved = false;
    this.canvas.shown.hover = null;
    const spot = this.spot(at, event), grip = this.tool.id === "pose" && !this.spots.length ? gripAt(this.session.poses, this.canvas.view, spot.world) : null;
    if (event.button === 1 || event.button === 2) this.drag = { kind: "pan" };
    else if (this.tool.id === "select") this.drag = grab(this.session, spot);
    else if (this.tool.id === "shape") this.drag = this.shape.hold(spot);
    else if (grip) this.drag = { kind: "pose", grip };
    else {
      this.drag = { kind: "tool" };
      this.stroke = [spot.world];
      this.isFresh = this.tool.places === 2 && this.spots.length === 0 && this.waiting === 0;
      if (this.isFresh) this.spots = [spot];
      this.preview(spot);
    }
  }

  private pinch(): void {
    const [a, b] = Array.from(this.fingers.values());
    this.endPull();
    this.cancel();
    this.drag = { kind: "pinch", span: distance(a, b) };
  }

  private move(event: PointerEvent): void {
    const at = this.at(event), before = this.fingers.get(event.pointerId);
    if (!before || !this.drag) return this.hover(this.spot(at, event));
    const { view } = this.canvas, drag = this.drag;
    if (!this.hasMoved && drag.kind !== "pinch" && distance(at, this.pressed) < 4) return;
    this.hasMoved = true;
    if (drag.kind === "pinch") {
      const old = middle(this.fingers);
      this.fingers.set(event.pointerId, at);
      const now = middle(this.fingers), [a, b] = Array.from(this.fingers.values()), span = Math.max(1, distance(a, b));
      view.pan(now[0] - old[0], now[1] - old[1]);
      view.zoom(span / drag.span, now);
      drag.span = span;
      this.canvas.onView();
    } else if (drag.kind === "pan") {
      view.pan(at[0] - before[0], at[1] - before[1]);
      this.canvas.onView();
    } else if (drag.kind === "body") this.pull(drag.body, drag.point, view.toWorld(at));
    else if (drag.kind === "shape") this.shape.move(drag.spot, drag.trial, this.target(at, event));
    else if (drag.kind === "pose") this.session.place(moved(this.session.poses, drag.grip, this.spot(at, event).world), false);
    else if (this.tool.id === "curve") this.draw(view.toWorld(at));
    else this.preview(this.spot(at, event));
    this.fingers.set(event.pointerId, at);
    this.canvas.redraw();
  }

  // Reshaping goes to the grid, not to points of its own.
  private target(at: Point, event: PointerEvent): Spot {
    const world = this.canvas.view.toWorld(at), step = this.canvas.step;
    return { world: event.altKey ? world : [Math.round(world[0] / step) * step, Math.round(world[1] / step) * step], all: [], snapped: "grid" };
  }

  private pull(body: string, point: [number, number], to: [number, number]): void {
    this.canvas.shown.pull = { body, point, to };
    this.onGrab();
    if (!this.onPull({ body, point, to })) void this.session.drag(body, point, to);
  }

  private draw(world: Point): void {
    this.stroke.push(world);
    this.session.want({ points: this.stroke, isClosed: false, isDone: false });
  }

  private endPull(): void {
    if (this.canvas.shown.pull) this.onPull(null);
    this.canvas.shown.pull = null;
  }

  private async up(event: PointerEvent): Promise<void> {
    const at = this.at(event), drag = this.drag;
    this.fingers.delete(event.pointerId);
    this.drag = this.fingers.size > 0 ? { kind: "pan" } : null;
    if (this.drag) return;
    this.endPull();
    if (drag?.kind === "tool" && this.tool.id === "curve" && this.hasMoved) this.session.want(meant(this.stroke));
    else if (drag?.kind === "tool") await this.release(() => this.spot(at, event), this.hasMoved && distance(at, this.pressed) > 12);
    else if (drag?.kind === "shape" && this.hasMoved) await this.shape.end(drag.trial, true);
    else if (drag?.kind === "pose") this.session.place(this.session.poses, true);
    else if (!this.hasMoved && drag && drag.kind !== "pinch") this.select(this.spot(at, event));
    this.canvas.redraw();
  }

  private lost(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.endPull();
    this.cancel();
    this.drag = null;
  }

  select(spot: Spot): void {
    this.session.select(meantBy(this.session, spot));
  }

  // A gesture of two places is two clicks, or one drag.
  private async release(spot: () => Spot, isDragged: boolean): Promise<void> {
    if (this.isFresh && !isDragged) this.isFresh = false;
    else await this.later(() => this.click(spot(), isDragged));
  }

  // Clicks that come while the core still reads the last gesture wait for it.
  later(click: () => Promise<void>): Promise<void> {
    this.waiting++;
    this.line = this.line.then(click).finally(() => { this.waiting--; });
    return this.line;
  }

  // One click of a tool: begins its gesture, ends it, or at the place where it began ends a chain.
  async click(spot: Spot, isDragged = false): Promise<void> {
    const { tool } = this, first = this.spots[0];
    if (!tool.finish) return;
    if (tool.places >= 2 && !first) {
      this.spots = [spot];
      return this.preview(spot);
    }
    if (tool.places === MANY) return this.corner(spot);
    if (tool.places === 2 && tool.id !== "pin" && distance(first.world, spot.world) < 1e-9) return void this.cancel();
    const answer = await tool.finish(this.session, tool.places === 2 ? [first, spot] : [spot], this.canvas.resolution);
    this.cancel();
    if (typeof answer === "string") this.session.emit("said", answer);
    else if (answer && tool.chain && !isDragged && this.tool === tool) this.goOn(answer);
  }

  // Adds a corner to a polygon; at its first corner, or twice at the last one, the polygon ends.
  private async corner(spot: Spot): Promise<void> {
    const { spots } = this, near = (one: Spot) => distance(one.world, spot.world) * this.canvas.view.scale < 8;
    if (!near(spots[0]) && !near(spots[spots.length - 1])) {
      this.spots = [...spots, spot];
      return this.preview(spot);
    }
    if (spots.length < 3) return this.session.emit("said", words.say.cornersMore);
    await this.tool.finish!(this.session, spots, this.canvas.resolution);
    this.cancel();
  }

  private goOn({ world, body, point }: Place): void {
    this.spots = [{ world, body, point, all: body && point ? [{ body, point }] : [], snapped: "point" }];
    this.preview(this.spots[0]);
  }

  hover(spot: Spot | null): void {
    this.canvas.shown.hover = spot;
    if (spot) this.preview(spot);
    this.canvas.root.classList.toggle("over", this.tool.id === "select" && spot !== null && (spot.all.length > 0 || spot.onBody !== undefined));
    this.canvas.redraw();
  }

  preview(spot: Spot): void {
    const from = this.spots.at(-1), { units } = this.canvas;
    if (!from) return;
    const far = decimal(distance(from.world, spot.world) / units.metre, this.canvas.resolution / units.metre);
    const turn = decimal((bearing(from.world, spot.world) * 180) / Math.PI, 0.1);
    this.canvas.shown.sketching = { from, to: spot, label: `${far} ${units.length}  ${turn}°`, corners: this.spots };
    this.canvas.redraw();
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaMode === 1 ? 16 * event.deltaY : event.deltaY;
    this.canvas.view.zoom(Math.exp(-Math.max(-60, Math.min(60, pixels)) * (event.ctrlKey ? 0.01 : 0.004)), this.at(event));
    this.canvas.onView();
    this.canvas.redraw();
  }
}
