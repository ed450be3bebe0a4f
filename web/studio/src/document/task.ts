// The task files that ask `yoke synthesize` for linkages that draw a curve, or lead a body through places.
import type { Point } from "../canvas/frames";
import type { Placed } from "../canvas/poses";
import type { Wanted } from "../canvas/stroke";
import { angle, length, point } from "./numbers";
import type { Units } from "./numbers";

export const FILE = "curve.yaml";
const MOST_EXACT = 5; // places
const A_LINE = 6; // points
const SMALL = 0.1, LARGE = 2; // of the curve's size: what links may be

// Returns two corners of the box round the points, and its longer side.
function boxOf(points: Point[]): { low: Point; high: Point; size: number } {
  const of = (pick: (...values: number[]) => number): Point => [pick(...points.map((one) => one[0])), pick(...points.map((one) => one[1]))];
  const low = of(Math.min), high = of(Math.max);
  return { low, high, size: Math.max(high[0] - low[0], high[1] - low[1]) };
}

export function taskOf(wanted: Wanted, mechanism: string, units: Units, resolution: number): string {
  const { points, isClosed } = wanted, lines: string[] = [], { low, high, size } = boxOf(points), round = size / 200;
  const part = (of: number) => length(of * size, units, round), corner = ([x, y]: Point, way: number) => point([x + way * size, y + way * size], units, round);
  for (let k = 0; k < points.length; k += A_LINE) lines.push(points.slice(k, k + A_LINE).map((one) => point(one, units, resolution)).join(", "));
  return `synthesis: path
points: [${lines.join(",\n  ")}]
closed: ${isClosed}
mechanisms: [${mechanism}]
bounds: {lengths: [${part(SMALL)}, ${part(LARGE)}], coupler_point: [${part(-LARGE)}, ${part(LARGE)}], pivots: [${corner(low, -1)}, ${corner(high, 1)}]}
require: {input: turns, transmission: 20 deg}
best: 6
units: {length: ${units.length}}
`;
}

// Five places leave nothing to choose; four and fewer do, and then links are asked to be of the size of the task, and linkages are judged unless
// the links alone are wanted.
export function placesTask(poses: Placed[], mechanism: string, units: Units, resolution: number, isJudged = true): string {
  const lines = poses.map((one) => `  - {at: ${point(one.at, units, resolution)}, angle: ${angle(one.angle, units)}}`);
  return `synthesis: motion
positions:
${lines.join("\n")}
${poses.length < MOST_EXACT ? `mechanisms: [${mechanism.startsWith("watt") ? "four-bar, slider-crank" : mechanism}]\nrequire: {size_ratio: 6}\n` : ""}best: ${isJudged ? 6 : 1}
units: {length: ${units.length}, angle: ${units.angle}}
`;
}

// Returns a length in the file's unit, in words.
export const inUnits = (metres: number, units: Units): string => `${length(metres, units, Math.max(1e-12, metres) / 100)} ${units.length}`;
