// What lies under the pointer: points first, then bodies, then the grid.
import type { Session } from "../session";
import type { Place } from "../document/gestures";
import type { Machine, Pose } from "../../../core/door";
import { distance, frameOf, indexOf, toGround, toSegment } from "./frames";
import type { Point } from "./frames";
import type { View } from "./view";

export interface At { body: string; point: string }
// A place with everything that lies there: several bodies share a pin.
export interface Spot extends Place { all: At[]; onBody?: string; snapped: "point" | "body" | "grid" | "free" }

export interface Corner extends At { world: [number, number] }

// The points of the pose last asked for: the pointer asks many times about one pose.
let known: { machine: Machine; pose: Pose; corners: Corner[] } | null = null;

// Returns all points of all bodies where they stand now, body by body.
export function corners(session: Session): Corner[] {
  const { machine, pose } = session;
  if (!machine || !pose) return [];
  if (known?.machine === machine && known.pose === pose) return known.corners;
  const found = machine.bodies.flatMap((body) => {
    const frame = frameOf(machine, pose, body.name);
    return body.points.map((point) => ({ body: body.name, point: point.name, world: toGround(frame, point.at) }));
  });
  known = { machine, pose, corners: found };
  return found;
}

// Returns the body whose drawing lies under a place on the screen, or whose line between two points is near.
function bodyAt(session: Session, view: View, world: Point, client: Point | null, reach: number, places: Corner[]): string | undefined {
  if (client) {
    for (const element of document.elementsFromPoint(client[0], client[1])) {
      const name = element.closest?.("#scene [data-body]")?.getAttribute("data-body");
      const index = name && session.machine ? indexOf(session.machine, name) : -1;
      if (index >= 0 && !session.machine!.bodies[index].ground) return name!;
    }
  }
  let best: string | undefined, least = reach / view.scale;
  let first = 0; // of the body's own among the places
  for (const body of session.machine?.bodies ?? []) {
    const own = places.slice(first, (first += body.points.length));
    if (body.ground) continue;
    own.forEach((corner, k) => {
      const far = toSegment(world, corner.world, own[(k + 1) % own.length].world);
      if (far < least) [best, least] = [body.name, far];
    });
  }
  return best;
}

export interface SnapOptions { reach: number; grid: number; isFree: boolean; client: Point | null; from?: Point }

export function snap(session: Session, view: View, world: Point, options: SnapOptions): Spot {
  const places = corners(session), reach = options.reach / view.scale;
  let nearest: Corner | null = null, least = reach;
  for (const corner of places) {
    const far = distance(world, corner.world);
    if (far < least) [nearest, least] = [corner, far];
  }
  if (nearest) {
    const same = 1e-6 + 0.75 / view.scale, at = nearest.world;
    const all = places.filter((corner) => distance(corner.world, at) < same).map(({ body, point }) => ({ body, point }));
    const first = all.find((one) => one.body === "ground") ?? all[0];
    return { world: nearest.world, body: first.body, point: first.point, all, snapped: "point" };
  }
  const onBody = bodyAt(session, view, world, options.client, 0.6 * options.reach, places);
  if (options.isFree) return { world, all: [], onBody, snapped: "free" };
  const step = options.grid, gridded: [number, number] = [Math.round(world[0] / step) * step, Math.round(world[1] / step) * step];
  if (onBody) return { world: gridIfNear(world, gridded, step), all: [], onBody, snapped: "body" };
  // a line from the last place stays level or upright where it nearly is
  if (options.from) {
    if (Math.abs(world[0] - options.from[0]) < reach) gridded[0] = options.from[0];
    if (Math.abs(world[1] - options.from[1]) < reach) gridded[1] = options.from[1];
  }
  return { world: gridded, all: [], snapped: "grid" };
}

const gridIfNear = (world: Point, gridded: [number, number], step: number): [number, number] =>
  distance(world, gridded) < 0.35 * step ? gridded : [world[0], world[1]];
