// What a person draws, as edits of the file: each function returns the text after one gesture. A body drawn from another
// is written in that body's axes, so that it stands where it was drawn without a word in `start:`.
import type { Machine, Pose } from "../../../core/door";
import { bearing, distance, frameOf, toBody } from "../canvas/frames";
import type { Point } from "../canvas/frames";
import { angle, length, point as pair, unitsOf } from "./numbers";
import type { Units } from "./numbers";
import { Source, written } from "./source";

// A place on the canvas: perhaps on a body, perhaps at one of its points.
export interface Place { world: Point; body?: string; point?: string }

const EMPTY_FILE = "units: {length: mm, angle: deg}\n";
// Sections whose entries mention bodies, points or coordinates.
const MENTIONS = ["joints", "gears", "racks", "belts", "cams", "forces", "springs", "stops", "drives", "efforts", "start", "locks"];

export class Draft {
  source: Source;
  readonly units: Units;

  constructor(text: string, private machine: Machine, private pose: Pose, readonly resolution: number) {
    this.source = new Source(text.trim() === "" ? EMPTY_FILE : text);
    this.units = unitsOf(this.source);
  }

  get text(): string {
    return this.source.text;
  }

  set(path: string[], value: string): void {
    this.source = this.source.set(path, value);
  }

  // Returns the first name of a kind that is free in a section: bar1, bar2, ...
  free(section: string[], stem: string): string {
    const taken = new Set(this.source.keys(section));
    for (let k = 1; ; k++) if (!taken.has(stem + k)) return stem + k;
  }

  // Returns the first letter that no joint and no point has: A, B, ..., Z, A2, ...
  letter(): string {
    const taken = new Set(this.source.keys(["joints"]));
    for (const body of this.source.keys(["bodies"])) for (const name of this.source.keys(["bodies", body, "points"])) taken.add(name);
    for (let k = 0; ; k++) {
      const name = String.fromCharCode(65 + (k % 26)) + (k < 26 ? "" : Math.floor(k / 26) + 1);
      if (!taken.has(name)) return name;
    }
  }

  axes(body: string | undefined) {
    return frameOf(this.machine, this.pose, body ?? "ground");
  }

  write(body: string, name: string, world: Point, axesOf = body): void {
    this.set(["bodies", body, "points", name], pair(toBody(this.axes(axesOf), world), this.units, this.resolution));
  }

  // Adds a point to a body and returns its name.
  addPoint(body: string, world: Point, name = this.letter()): string {
    this.write(body, name, world);
    return name;
  }

  // Returns the point of a place, made where the body has none there.
  pointAt(place: Place): string {
    return place.point ?? this.addPoint(place.body!, place.world);
  }

  // Pins two bodies that both have the point.
  pin(a: string, b: string, point: string): string {
    const isTaken = this.source.has(["joints", point]), name = isTaken ? this.free(["joints"], point + "_") : point;
    this.set(["joints", name], `{pin: [${written(a)}, ${written(b)}]${isTaken ? `, at: ${written(point)}` : ""}}`);
    return name;
  }

  // Draws a bar between two places; where they lie on bodies it is pinned to them. Returns where its far end is.
  addBar(from: Place, to: Place): Place {
    const name = this.free(["bodies"], "bar"), host = from.body ?? to.body ?? "ground", ends: string[] = [];
    for (const place of [from, to]) {
      let end = place.body ? this.pointAt(place) : this.letter();
      if (ends.includes(end)) end = this.letter();
      this.write(name, end, place.world, host);
      ends.push(end);
      if (!place.body) continue;
      if (place.point !== undefined && end !== place.point) this.addPoint(place.body, place.world, end);
      this.pin(place.body, name, end);
    }
    return { world: to.world, body: to.body ?? name, point: ends[1] };
  }

  // Pins a point of a body to the ground where it stands; on nothing, marks a point of the ground.
  ground(place: Place): void {
    if (!place.body || place.body === "ground") {
      if (!place.point) this.addPoint("ground", place.world);
      return;
    }
    const name = this.pointAt(place);
    const other = this.source.has(["bodies", "ground", "points", name]) ? this.letter() : name;
    if (other !== name) this.addPoint(place.body, place.world, other);
    this.write("ground", other, place.world);
    this.pin("ground", place.body, other);
  }

  // Pins two points of two bodies onto each other.
  join(a: Place, b: Place): void {
    const name = this.pointAt(a), other = b.body!;
    if (!this.source.has(["bodies", other, "points", name])) {
      if (b.point) this.set(["bodies", other, "points", name], this.source.value(["bodies", other, "points", b.point]) ?? "[0, 0]");
      else this.addPoint(other, b.world, name);
    }
    this.pin(a.body!, other, name);
  }

  // Guides a point of a body along a line of the ground, or of another body, which then has a slot; it stays free to turn.
  guide(place: Place, towards: Point, host = "ground"): void {
    const at = this.pointAt(place), from = this.addPoint(host, place.world), turn = bearing(place.world, towards) - this.axes(host).angle;
    const name = this.free(["joints"], "S");
    this.set(["joints", name], `{pin-slot: [${written(host)}, ${written(place.body!)}], at: ${written(at)}, from: ${written(from)}, along: ${this.line(turn)}}`);
  }

  // Writes the direction of a line: an axis by its letter.
  line(turn: number): string {
    const degrees = Math.round((turn * 180) / Math.PI * 1e6) / 1e6;
    return degrees % 180 === 0 ? "x" : degrees % 180 === 90 || degrees % 180 === -90 ? "y" : angle(turn, this.units);
  }

  // Drives a coordinate: an angle evenly, a distance to and fro, from where it stands.
  drive(coordinate: { name: string; kind: "angle" | "length"; value: number }): void {
    const isAngle = coordinate.kind === "angle";
    const value = isAngle ? `${angle(coordinate.value, this.units)} deg`.replace(" deg deg", " deg") : `${length(coordinate.value, this.units, this.resolution)} ${this.units.length}`;
    const move = isAngle ? "30 rpm * t" : `${length(0.02, { ...this.units }, 1e-3)} ${this.units.length} * sin(2 rad/s * t)`;
    this.set(["drives", coordinate.name], parseFloat(value) === 0 ? move : `${value} + ${move}`);
  }

  // Gives a body mass: a bar of two points is a uniform rod. The first mass brings gravity.
  addMass(body: string): void {
    const points = this.source.keys(["bodies", body, "points"]);
    this.set(["bodies", body, "mass"], "1 kg");
    if (points.length === 2 && !this.source.has(["bodies", body, "inertia"]) && !this.source.has(["bodies", body, "rod"]))
      this.set(["bodies", body, "rod"], `[${points.map(written).join(", ")}]`);
    if (!this.source.has(["gravity"])) this.set(["gravity"], "[0, -9.81 m/s^2]");
  }

  addSpring(a: Place, b: Place): void {
    const ends = [a, b].map((place) => {
      const body = place.body ?? "ground";
      return written(`${body}.${place.body ? this.pointAt(place) : this.addPoint("ground", place.world)}`);
    });
    const rest = `${length(distance(a.world, b.world), this.units, this.resolution)} ${this.units.length}`;
    this.set(["springs", this.free(["springs"], "k")], `{between: [${ends.join(", ")}], stiffness: 100 N/m, length: ${rest}}`);
  }

  addForce(place: Place): void {
    const value = `{body: ${written(place.body!)}, at: ${written(this.pointAt(place))}, value: [0, -10 N]}`;
    this.set(["forces", this.free(["forces"], "F")], value);
  }

  // Drives the angle of a joint that names none, and gives it a name.
  driveUnnamed(joint: string): void {
    const name = `theta_${joint}`;
    this.set(["joints", joint, "angle"], written(name));
    this.set(["drives", name], "30 rpm * t");
  }

  // Meshes two gears, by a module that makes 20 and 40 teeth fit their distance; a place without a body gets a gear.
  mesh(a: Place, b: Place): void {
    const [first, second] = [a, b].map((place) => (place.body && place.body !== "ground" ? place.body : this.addGear(place)));
    const module = `${length((2 * distance(a.world, b.world)) / 60, this.units, 1e-7)} ${this.units.length}`;
    this.set(["gears", this.free(["gears"], "mesh")], `{mesh: [${written(first)}, ${written(second)}], teeth: [20, 40], module: ${module}}`);
  }

  // Pins a new gear to the ground; its centre is its origin.
  addGear(place: Place, stem = "gear"): string {
    const name = this.free(["bodies"], stem), centre = place.point ?? this.addPoint("ground", place.world);
    const joint = this.source.has(["joints", centre]) ? this.free(["joints"], centre + "_") : centre;
    this.set(["bodies", name], `{points: {${written(centre)}: [0, 0]}}`);
    this.set(["joints", joint], `{pin: [ground, ${name}]${joint === centre ? "" : `, at: ${written(centre)}`}}`);
    return name;
  }

  // Moves the points of all bodies at a joint; returns the path of a value that is an expression and stays. A point of one body alone, in no
  // joint, gives up its expression.
  movePoint(places: { body: string; point: string }[], world: Point): string | null {
    const isAlone = places.length === 1 && !this.machine.joints.some((joint) => joint.points.some((name, side) => name === places[0].point && joint.bodies[side] === places[0].body));
    if (!isAlone) for (const { body, point } of places) {
      const path = ["bodies", body, "points", point], value = this.source.value(path);
      if (value !== null && !/^\[\s*[-+\d.e]+(\s*[a-z]+)?\s*,\s*[-+\d.e]+(\s*[a-z]+)?\s*\]$/i.test(value)) return path.join("/");
    }
    for (const { body, point } of places) this.write(body, point, world);
    return null;
  }

  // Removes a body with all that mentions it.
  removeBody(body: string): void {
    const joints = this.machine.joints.filter((joint) => joint.bodies.includes(body)).map((joint) => joint.name);
    for (const section of MENTIONS) this.removeMentions(section, (word) => word === body || word.startsWith(`${body}.`));
    for (const joint of joints) this.removeJoint(joint);
    this.source = this.source.remove(["bodies", body]);
  }

  // Removes a joint, and what is said of its coordinates.
  removeJoint(joint: string): void {
    const coordinates = this.machine.coordinates.filter((one) => one.joint === joint).map((one) => one.name);
    this.source = this.source.remove(["joints", joint]);
    const isGone = (word: string) => coordinates.some((name) => word === name || word.startsWith(`${name}.`)) || word.startsWith(`${joint}.`);
    for (const section of MENTIONS.slice(1)) this.removeMentions(section, isGone);
  }

  // Removes a point with the joints that need it.
  removePoint(body: string, point: string): void {
    for (const joint of this.machine.joints)
      if (joint.bodies.includes(body) && joint.points.some((name, side) => name === point && joint.bodies[side] === body)) this.removeJoint(joint.name);
    this.source = this.source.remove(["bodies", body, "points", point]);
    for (const section of MENTIONS.slice(1)) this.removeMentions(section, (word) => word === `${body}.${point}`);
  }

  removeEntry(section: string, name: string): void {
    if (section === "joints") this.removeJoint(name);
    else this.source = this.source.remove([section, name]);
  }

  private removeMentions(section: string, isGone: (word: string) => boolean): void {
    for (const name of this.source.keys([section])) {
      let gone = section !== "joints" && isGone(name);
      this.source.words([section, name], (word) => (gone ||= isGone(word)));
      if (gone) this.source = this.source.remove([section, name]);
    }
  }
}
