// What a press of the pointer takes hold of, and where two fingers have their middle.
import type { Selection, Session, Trial } from "../session";
import { frameOf, toBody } from "./frames";
import type { Grip } from "./poses";
import type { Spot } from "./snap";

export type Drag = { kind: "pan" } | { kind: "body"; body: string; point: [number, number] } | { kind: "shape"; spot: Spot; trial: Trial } | { kind: "pose"; grip: Grip } | { kind: "tool" } | { kind: "pinch"; span: number };

// Takes hold of the body under the pointer; of the plane if there is none.
export function grab({ machine, pose }: Session, spot: Spot): Drag {
  const held = spot.all.find((one) => one.body !== "ground") ?? spot.all[0], body = held?.body ?? spot.onBody;
  if (!machine || !pose || !body || body === "ground") return { kind: "pan" };
  const point = held ? machine.bodies.find((one) => one.name === body)!.points.find((one) => one.name === held.point)!.at : toBody(frameOf(machine, pose, body), spot.world);
  return { kind: "body", body, point: [point[0], point[1]] };
}

// Returns what a click on a place selects: its joint, its point, or the body there.
export function meantBy({ machine }: Session, spot: Spot): Selection {
  const joint = machine?.joints.find((one) => one.points.some((point, side) => spot.all.some((at) => at.point === point && at.body === one.bodies[side])));
  if (joint) return { kind: "joint", joint: joint.name };
  if (spot.all.length) return { kind: "point", ...spot.all[0] };
  return spot.onBody ? { kind: "body", body: spot.onBody } : null;
}

export function middle(fingers: Map<number, [number, number]>): [number, number] {
  const [a, b] = Array.from(fingers.values());
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}
