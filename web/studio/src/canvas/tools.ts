// The tools: what a click, or two, with each of them writes into the file.
import { addBelt, addCam, addDamper, addPolygon, addRack } from "../document/elements";
import type { Draft, Place } from "../document/gestures";
import type { Session } from "../session";
import { words } from "../words";
import { bearing, distance } from "./frames";
import type { Point } from "./frames";
import { MOST_POSES } from "./poses";
import type { At, Spot } from "./snap";
import { extended } from "./stroke";

export type ToolId = "select" | "bar" | "polygon" | "point" | "pin" | "slide" | "slot" | "ground" | "motor" | "gear" | "rack" | "belt" | "cam" | "mass"
  | "spring" | "damper" | "force" | "shape" | "curve" | "pose" | "delete";
export const MANY = 1000; // places of a gesture that ends where it began

export interface Tool {
  id: ToolId;
  key: string;
  places: 0 | 1 | 2 | typeof MANY; // how many clicks make one gesture
  chain?: boolean; // the next gesture begins where this one ended
  // Makes the gesture and returns a sentence where it cannot.
  finish?(session: Session, spots: Spot[], resolution: number): Promise<string | null | Place>;
}

const isGround = (at: At): boolean => at.body === "ground";
const moving = (spot: Spot): Place => {
  const at = spot.all.find((one) => !isGround(one));
  return at ? { world: spot.world, ...at } : { world: spot.world, body: spot.onBody };
};
const place = (spot: Spot): Place => ({ world: spot.world, body: spot.body ?? spot.onBody, point: spot.point });
const apart = (a: Point, b: Point): boolean => distance(a, b) > 1e-9;

function joined(session: Session, a: string, b: string): boolean {
  return session.machine?.joints.some((joint) => joint.bodies.includes(a) && joint.bodies.includes(b)) ?? false;
}

// Returns the two places of a spring or damper, or null where both are on one body.
function between(from: Spot, to: Spot): [Place, Place] | null {
  const [a, b] = [from, to].map((spot) => { const one = moving(spot); return one.body ? one : place(spot); });
  return (a.body ?? "ground") === (b.body ?? "ground") ? null : [a, b];
}

// Returns the place of a wheel's centre: the body that turns there, or the ground.
function centre(spot: Spot): Place {
  const at = spot.all.find((each) => !isGround(each));
  return at ? { world: spot.world, ...at } : place({ ...spot, onBody: undefined });
}

// Returns whether something on the ground can be driven from a wheel's centre: its body turns on the ground, or there is none yet.
const turnsOnGround = (session: Session, { body }: Place): boolean => !body || body === "ground" || joined(session, "ground", body);

// Runs a gesture; returns what it returns.
async function draw<T>(session: Session, resolution: number, gesture: (draft: Draft) => T): Promise<T | null> {
  let answer: T | null = null;
  await session.edit((draft) => { answer = gesture(draft); }, resolution);
  return answer;
}

// Returns the joint to drive at a place: one to the ground first, then one that is not driven.
function jointAt(session: Session, spot: Spot): string | null {
  const here = (session.machine?.joints ?? []).filter((joint) =>
    (joint.points.length ? joint.points : [joint.name, joint.name]).some((point, side) => spot.all.some((at) => at.body === joint.bodies[side] && at.point === point)));
  const rank = (name: string): number => {
    const joint = here.find((one) => one.name === name)!, own = session.machine!.coordinates.filter((one) => one.joint === name);
    return (own.length ? 4 : 0) + (joint.bodies.includes("ground") ? 2 : 0) + (own.some((one) => !one.driven) ? 1 : 0);
  };
  return here.map((joint) => joint.name).sort((a, b) => rank(b) - rank(a))[0] ?? null;
}

export const TOOLS: Tool[] = [
  { id: "select", key: "v", places: 0 },
  {
    id: "bar", key: "b", places: 2, chain: true,
    async finish(session, [from, to], resolution) {
      if (!apart(from.world, to.world)) return null;
      return draw(session, resolution, (draft) => draft.addBar(place(from), place(to)));
    },
  },
  {
    id: "polygon", key: "y", places: MANY,
    async finish(session, spots, resolution) {
      const body = await draw(session, resolution, (draft) => addPolygon(draft, spots.map(place)));
      if (body) session.select({ kind: "body", body });
      return null;
    },
  },
  {
    id: "point", key: "p", places: 1,
    async finish(session, [spot], resolution) {
      const selected = session.selection && "body" in session.selection ? session.selection.body : undefined;
      const body = spot.onBody ?? selected ?? "ground";
      if (spot.all.some((at) => at.body === body)) return words.say.pointIsThere;
      const name = await draw(session, resolution, (draft) => draft.addPoint(body, spot.world));
      if (name) session.select({ kind: "point", body, point: name });
      return null;
    },
  },
  {
    id: "pin", key: "j", places: 2,
    async finish(session, [first, second], resolution) {
      let a: Place = moving(first), b: Place = moving(second);
      if (!a.body) a = place(first);
      if (a.body === b.body || !b.body) {
        const other = second.all.find((at) => at.body !== a.body && !joined(session, at.body, a.body!));
        if (!other) return words.say.pinTwo;
        b = { world: second.world, ...other };
      }
      if (!a.body) return words.say.pinTwo;
      await draw(session, resolution, (draft) => draft.join(a, b));
      return null;
    },
  },
  {
    id: "ground", key: "g", places: 1,
    async finish(session, [spot], resolution) {
      const at = moving(spot);
      if (at.body && spot.all.some(isGround) && joined(session, "ground", at.body)) return words.say.pinnedAlready;
      await draw(session, resolution, (draft) => draft.ground(at.body ? at : place(spot)));
      return null;
    },
  },
  {
    id: "slide", key: "s", places: 2,
    async finish(session, [from, to], resolution) {
      const at = moving(from);
      if (!at.body) return words.say.slideFrom;
      if (!apart(from.world, to.world)) return null;
      await draw(session, resolution, (draft) => draft.guide(at, to.world));
      return null;
    },
  },
  {
    id: "slot", key: "l", places: 2,
    async finish(session, [from, to], resolution) {
      const host = to.onBody ?? to.all.find((one) => !isGround(one))?.body;
      const at = from.all.find((one) => !isGround(one) && one.body !== host), body = at?.body ?? from.onBody;
      if (!body) return words.say.slideFrom;
      if (!host || host === body) return words.say.slotTwo;
      await draw(session, resolution, (draft) => draft.guide(at ? { world: from.world, ...at } : { world: from.world, body }, to.world, host));
      return null;
    },
  },
  {
    id: "motor", key: "m", places: 1,
    async finish(session, [spot], resolution) {
      const joint = jointAt(session, spot);
      if (!joint) return words.say.motorAt;
      const own = session.machine!.coordinates.filter((one) => one.joint === joint), one = own.find((each) => !each.driven) ?? own[0];
      if (one?.driven) return words.say.drivenAlready(one.name);
      const at = session.start!.coordinates[session.machine!.coordinates.indexOf(one)];
      if (one) await draw(session, resolution, (draft) => draft.drive({ ...one, value: at ?? one.value }));
      else await draw(session, resolution, (draft) => draft.driveUnnamed(joint));
      session.select({ kind: "joint", joint });
      return null;
    },
  },
  {
    id: "gear", key: "e", places: 2,
    async finish(session, [first, second], resolution) {
      if (!apart(first.world, second.world)) return null;
      await draw(session, resolution, (draft) => draft.mesh(centre(first), centre(second)));
      return null;
    },
  },
  {
    id: "rack", key: "h", places: 2,
    async finish(session, [from, to], resolution) {
      const pinion = centre(from);
      if (!turnsOnGround(session, pinion)) return words.say.turnsOnGround;
      await draw(session, resolution, (draft) => addRack(draft, pinion, to.world));
      return null;
    },
  },
  {
    id: "belt", key: "u", places: 2,
    async finish(session, [first, second], resolution) {
      const [a, b] = [centre(first), centre(second)];
      if (a.body && a.body === b.body && a.body !== "ground") return words.say.beltTwo;
      await draw(session, resolution, (draft) => addBelt(draft, a, b));
      return null;
    },
  },
  {
    id: "cam", key: "c", places: 2,
    async finish(session, [from, to], resolution) {
      const shaft = centre(from);
      if (!turnsOnGround(session, shaft)) return words.say.turnsOnGround;
      await draw(session, resolution, (draft) => addCam(draft, shaft, to.world));
      return null;
    },
  },
  {
    id: "spring", key: "k", places: 2,
    async finish(session, [from, to], resolution) {
      if (!apart(from.world, to.world)) return null;
      const ends = between(from, to);
      if (!ends) return words.say.springTwo;
      await draw(session, resolution, (draft) => draft.addSpring(...ends));
      return null;
    },
  },
  {
    id: "damper", key: "d", places: 2,
    async finish(session, [from, to], resolution) {
      const ends = between(from, to);
      if (!ends) return words.say.springTwo;
      await draw(session, resolution, (draft) => addDamper(draft, ...ends));
      return null;
    },
  },
  {
    id: "force", key: "f", places: 1,
    async finish(session, [spot], resolution) {
      const at = moving(spot);
      if (!at.body) return words.say.onBody;
      await draw(session, resolution, (draft) => draft.addForce(at));
      return null;
    },
  },
  {
    id: "mass", key: "w", places: 1,
    async finish(session, [spot], resolution) {
      const body = spot.onBody ?? moving(spot).body;
      if (!body) return words.say.onBody;
      if (!(await draw(session, resolution, (draft) => (draft.source.has(["bodies", body, "mass"]) ? false : (draft.addMass(body), true))))) return words.say.massAlready(body);
      session.select({ kind: "body", body });
      return null;
    },
  },
  { id: "shape", key: "r", places: 0 },
  {
    id: "curve", key: "q", places: 1,
    async finish(session, [spot]) {
      session.want(extended(session.wanted, spot.world));
      return null;
    },
  },
  {
    id: "pose", key: "i", places: 2,
    async finish(session, [from, to]) {
      if (session.poses.length >= MOST_POSES) return words.say.posesFull(MOST_POSES);
      session.place([...session.poses, { at: from.world, angle: bearing(from.world, to.world) }], true);
      return null;
    },
  },
  {
    id: "delete", key: "x", places: 1,
    async finish(session, [spot]) {
      const body = spot.onBody ?? moving(spot).body;
      if (!body && spot.body === "ground" && spot.point) await draw(session, 1e-4, (draft) => draft.removePoint("ground", spot.point!));
      else if (body) await draw(session, 1e-4, (draft) => draft.removeBody(body));
      else return words.say.onBody;
      session.select(null);
      return null;
    },
  },
];

export const toolOf = (id: ToolId): Tool => TOOLS.find((tool) => tool.id === id)!;
