// View: where points of bodies lie on the ground, and the other way round. With view.ts the only file that turns axes.
import type { Machine, Pose } from "../../../core/door";

export type Point = readonly [number, number];
export interface Frame { x: number; y: number; angle: number }

export function frameOf(machine: Machine, pose: Pose, body: string): Frame {
  const index = machine.bodies.findIndex((one) => one.name === body), at = 3 * index;
  if (index < 0 || machine.bodies[index].ground || at + 2 >= pose.bodies.length) return { x: 0, y: 0, angle: 0 };
  return { x: pose.bodies[at], y: pose.bodies[at + 1], angle: pose.bodies[at + 2] };
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
