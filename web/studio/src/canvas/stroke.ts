// A curve drawn by hand, and the few points of it that linkages are asked to pass.
import { distance } from "./frames";
import type { Point } from "./frames";

export interface Wanted { points: Point[]; isClosed: boolean; isDone: boolean } // isDone: the hand has left it

const MOST = 12; // points of a task that a stroke makes
const GAP = 0.15; // of its length: a stroke whose ends are nearer than that goes round

const lengthOf = (places: Point[]): number => places.slice(1).reduce((sum, place, k) => sum + distance(places[k], place), 0);

// Returns `count` places on a line of straight pieces, at equal distances along it, from its first to its last one.
export function spaced(places: Point[], count: number): Point[] {
  const step = lengthOf(places) / (count - 1), chosen: Point[] = [places[0]];
  let passed = 0;
  for (let k = 1; k < places.length && chosen.length < count - 1; k++) {
    const [a, b] = [places[k - 1], places[k]], far = distance(a, b);
    for (; chosen.length < count - 1 && passed + far >= chosen.length * step; ) {
      const part = (chosen.length * step - passed) / far;
      chosen.push([a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])]);
    }
    passed += far;
  }
  return [...chosen, places[places.length - 1]];
}

// Returns the curve that a stroke of the pointer means.
export function meant(places: Point[]): Wanted | null {
  const length = lengthOf(places);
  if (!(length > 0)) return null;
  const isClosed = distance(places[0], places[places.length - 1]) < GAP * length;
  const round = isClosed ? [...places, places[0]] : places, points = spaced(round, isClosed ? MOST + 1 : MOST);
  return { points: isClosed ? points.slice(0, -1) : points, isClosed, isDone: true };
}

// Adds a point to the curve; the first one again closes it.
export function extended(wanted: Wanted | null, at: Point): Wanted {
  const before = wanted && !wanted.isClosed ? wanted.points : [], isBack = before.length > 2 && distance(before[0], at) < 1e-9;
  return { points: isBack ? before : [...before, at], isClosed: isBack, isDone: true };
}
