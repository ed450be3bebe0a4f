// View: where points of bodies lie on the ground, and the other way round. With view.ts the only file that turns axes.
import type { Machine, Pose } from "../../../core/door";

export type Point = readonly [number, number];
export interface Frame { x: number; y: number; angle: number }

const orders = new WeakMap<Machine, Map<string, number>>(); // where each body stands in the list of a machine

// Returns where a body stands in the machine's list; -1: it has none of that name.
export function indexOf(machine: Machine, body: string): number {
  let order = orders.get(machine);
  if (!order) orders.set(machine, (order = new Map(machine.bodies.map((one, index) => [one.name, index]))));
  return order.get(body) ?? -1;
}

export function frameOf(machine: Machine, pose: Pose, body: string): Frame {
  const index = indexOf(machine, body), at = 3 * index;
  if (index < 0 || machine.bodies[index].ground || at + 2 >= pose.bodies.length) return { x: 0, y: 0, angle: 0 };
  return { x: pose.bodies[at], y: pose.bodies[at + 1], angle: pose.bodies[at + 2] };
}

export const AXES = 4; // numbers of a body in `axesOf`: where its origin is, m, and the direction of its x

// Writes the axes of all bodies at a pose; behind them the ground's, for what belongs to no body. A body without a pose keeps the axes it had.
export function axesOf(pose: Pose, into: Float64Array): void {
  const count = into.length / AXES - 1;
  for (let k = 0; k < count && 3 * k + 2 < pose.bodies.length; k++) {
    const x = pose.bodies[3 * k], y = pose.bodies[3 * k + 1], angle = pose.bodies[3 * k + 2], at = AXES * k;
    if (!Number.isFinite(x + y + angle)) continue;
    [into[at], into[at + 1], into[at + 2], into[at + 3]] = [x, y, Math.cos(angle), Math.sin(angle)];
  }
  into[AXES * count + 2] = 1;
}

export function toGround({ x, y, angle }: Frame, [px, py]: Point): [number, number] {
  const c = Math.cos(angle), s = Math.sin(angle);
  return [x + c * px - s * py, y + s * px + c * py];
}

export function toBody({ x, y, angle }: Frame, [gx, gy]: Point): [number, number] {
  const c = Math.cos(angle), s = Math.sin(angle);
  return [c * (gx - x) + s * (gy - y), -s * (gx - x) + c * (gy - y)];
}

export const distance = (a: Point, b: Point): number => Math.hypot(b[0] - a[0], b[1] - a[1]);
export const bearing = (a: Point, b: Point): number => Math.atan2(b[1] - a[1], b[0] - a[0]);
export const along = (a: Point, angle: number, length: number): [number, number] =>
  [a[0] + length * Math.cos(angle), a[1] + length * Math.sin(angle)];

// Returns the distance from p to the segment between a and b.
export function toSegment(p: Point, a: Point, b: Point): number {
  const [ux, uy] = [b[0] - a[0], b[1] - a[1]], square = ux * ux + uy * uy;
  const part = square > 0 ? Math.min(1, Math.max(0, ((p[0] - a[0]) * ux + (p[1] - a[1]) * uy) / square)) : 0;
  return distance(p, [a[0] + part * ux, a[1] + part * uy]);
}
