// More of what a person draws, as edits of the file: polygons, racks, belts, cams and dampers.
import { bearing, distance } from "../canvas/frames";
import type { Point } from "../canvas/frames";
import type { Draft, Place } from "./gestures";
import { length } from "./numbers";
import { written } from "./source";

const measure = (draft: Draft, metres: number): string => `${length(metres, draft.units, draft.resolution)} ${draft.units.length}`;

// Returns the body that turns about a place: the one there, or a new one pinned to the ground.
function turning(draft: Draft, place: Place, stem: string): string {
  return place.body && place.body !== "ground" ? place.body : draft.addGear(place, stem);
}

// Draws one body with a point at every corner; where a corner lies on another body, it is pinned there.
export function addPolygon(draft: Draft, corners: Place[]): string {
  const name = draft.free(["bodies"], "plate"), host = corners.find((one) => one.body)?.body ?? "ground", own: string[] = [];
  for (const place of corners) {
    const shared = place.body ? draft.pointAt(place) : draft.letter();
    const end = own.includes(shared) ? draft.letter() : shared;
    draft.write(name, end, place.world, host);
    own.push(end);
    if (!place.body) continue;
    if (end !== shared) draft.addPoint(place.body, place.world, end);
    draft.pin(place.body, name, end);
  }
  return name;
}

// Lets a rack of the ground roll on a pinion, whose pitch circle goes through the place: the rack's line is its tangent there.
export function addRack(draft: Draft, centre: Place, towards: Point): void {
  const pinion = turning(draft, centre, "pinion"), radius = distance(centre.world, towards), rack = draft.free(["bodies"], "rack");
  const from = draft.addPoint("ground", towards), turn = bearing(centre.world, towards) + Math.PI / 2, name = draft.free(["joints"], "S");
  draft.set(["bodies", rack], "{}");
  draft.set(["joints", name], `{slide: [ground, ${rack}], along: ${draft.line(turn)}, from: ${written(from)}}`);
  draft.set(["racks", draft.free(["racks"], "pair")], `{pinion: ${written(pinion)}, rack: ${rack}, radius: ${measure(draft, radius)}}`);
}

// Lays a belt round two pulleys, the second of half the radius.
export function addBelt(draft: Draft, a: Place, b: Place): void {
  const [first, second] = [a, b].map((place) => turning(draft, place, "pulley")), apart = distance(a.world, b.world);
  const radii = [apart / 5, apart / 10].map((one) => measure(draft, one)).join(", ");
  draft.set(["belts", draft.free(["belts"], "belt")], `{between: [${written(first)}, ${written(second)}], radii: [${radii}]}`);
}

// Gives a shaft a cam and a follower with a roller, whose centre stands at the place when it is lowest.
export function addCam(draft: Draft, centre: Place, roller: Point): void {
  const cam = turning(draft, centre, "disc"), apart = distance(centre.world, roller), follower = draft.free(["bodies"], "follower");
  const law = draft.free(["laws"], "lift"), by = measure(draft, apart / 4), from = groundPointAt(draft, centre);
  draft.set(["laws", law], `{period: 360 deg, segments: [{rise: {to: 120 deg, by: ${by}, law: 3-4-5}}, {dwell: {to: 180 deg}}, {fall: {to: 300 deg, by: ${by}, law: 3-4-5}}, {dwell: {to: 360 deg}}]}`);
  draft.set(["bodies", follower], "{}");
  draft.set(["joints", draft.free(["joints"], "S")], `{slide: [ground, ${follower}], along: ${draft.line(bearing(centre.world, roller))}, from: ${written(from)}}`);
  draft.set(["cams", draft.free(["cams"], "cam")], `{cam: ${written(cam)}, follower: ${follower}, law: ${law}, roller: ${measure(draft, apart / 5)}, base: ${measure(draft, 0.8 * apart)}}`);
}

// Returns the point of the ground at a place: the one that its pin has there, or a new one.
function groundPointAt(draft: Draft, place: Place): string {
  const names = draft.source.keys(["bodies", "ground", "points"]);
  if (place.point && names.includes(place.point)) return place.point;
  return !place.body && names.length ? names[names.length - 1] : draft.addPoint("ground", place.world);
}

// Puts a damper between two places.
export function addDamper(draft: Draft, a: Place, b: Place): void {
  const ends = [a, b].map((place) => written(`${place.body ?? "ground"}.${place.body ? draft.pointAt(place) : draft.addPoint("ground", place.world)}`));
  draft.set(["springs", draft.free(["springs"], "damper")], `{between: [${ends.join(", ")}], damping: 10 N*s/m}`);
}
