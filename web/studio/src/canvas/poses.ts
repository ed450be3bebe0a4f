// Places of a body set by hand: where its origin is to be, and how far it is to be turned; and the links that the core finds for them.
import { svg } from "../dom";
import { along, bearing, distance, toGround } from "./frames";
import type { Point } from "./frames";
import type { View } from "./view";

export interface Placed { at: Point; angle: number }
// A link between the ground and the body; `moving` in the body's axes.
export interface Dyad { fixed: Point; moving: Point }
export interface Grip { index: number; isTip: boolean }

export const MOST_POSES = 5; // what four-bars can be led through
const ARM = 42, SIDE = 16, REACH = 14; // px
const FEW = 8; // dyads of which the links are drawn; of more only the pivots

const tipOf = ({ at, angle }: Placed, view: View): Point => along(at, angle, ARM / view.scale);

// Returns the place of which the pointer takes hold: at its origin, or at the tip of its arrow.
export function gripAt(poses: Placed[], view: View, world: Point, reach = REACH): Grip | null {
  const near = (place: Point) => distance(place, world) * view.scale < reach;
  for (const isTip of [true, false]) {
    const index = poses.findIndex((one) => near(isTip ? tipOf(one, view) : one.at));
    if (index >= 0) return { index, isTip };
  }
  return null;
}

// Returns the places with one of them moved, or turned.
export const moved = (poses: Placed[], { index, isTip }: Grip, to: Point): Placed[] =>
  poses.map((one, k) => (k !== index ? one : isTip ? { ...one, angle: bearing(one.at, to) } : { ...one, at: to }));

export class Poses {
  readonly group = svg("g", { class: "poses" });
  constructor(private view: View) {}

  draw(poses: Placed[], dyads: Dyad[]): void {
    this.group.replaceChildren(...(dyads.length <= FEW && poses.length ? dyads.flatMap((one) => this.link(one, poses)) : []),
      ...(poses.length ? dyads.flatMap(({ fixed, moving }) => [this.dot(fixed, 4, "pivot"), this.dot(toGround(frame(poses[0]), moving), 3, "moving")]) : []), ...poses.flatMap((one, k) => this.frame(one, k)));
  }

  private dot(world: Point, r: number, name: string): SVGElement {
    const [cx, cy] = this.view.toScreen(world);
    return svg("circle", { cx: cx.toFixed(1), cy: cy.toFixed(1), r, class: name });
  }

  private line(a: Point, b: Point, name: string): SVGElement {
    const [x1, y1] = this.view.toScreen(a), [x2, y2] = this.view.toScreen(b);
    return svg("line", { x1: x1.toFixed(1), y1: y1.toFixed(1), x2: x2.toFixed(1), y2: y2.toFixed(1), class: name });
  }

  // A link at the first place in full, at the others faintly.
  private link({ fixed, moving }: Dyad, poses: Placed[]): SVGElement[] {
    return poses.map((one, k) => this.line(fixed, toGround(frame(one), moving), k ? "dyad faint" : "dyad")).reverse();
  }

  private frame(one: Placed, k: number): SVGElement[] {
    const tip = tipOf(one, this.view), side = along(one.at, one.angle + Math.PI / 2, SIDE / this.view.scale), [x, y] = this.view.toScreen(along(one.at, one.angle, -14 / this.view.scale));
    return [this.line(one.at, side, "pose-side"), this.line(one.at, tip, "pose-arm"), this.dot(one.at, 5, "pose-at"), this.dot(tip, 3.5, "pose-tip"),
      svg("text", { x: x.toFixed(1), y: (y + 4).toFixed(1), class: "pose-name" }, String(k + 1))];
  }
}

const frame = ({ at: [x, y], angle }: Placed) => ({ x, y, angle });
