// What Studio draws over the machine: points to take hold of, the selection, the crosshair, the gesture being made, traces.
import { fill, svg } from "../dom";
import type { Session } from "../session";
import { frameOf, indexOf, toGround } from "./frames";
import type { Point } from "./frames";
import { Poses } from "./poses";
import { corners } from "./snap";
import type { Spot } from "./snap";
import type { View } from "./view";

const MOST_HANDLES = 600;

export interface Sketching { from: Spot; to: Spot; label: string; corners?: Spot[] } // corners: of the polygon so far
export interface Shown {
  hover: Spot | null;
  crosshair: Spot | null; // of the keyboard
  sketching: Sketching | null;
  pull: { body: string; point: Point; to: Point } | null; // the string between a dragged point and the pointer
  tool: string;
}

export class Overlay {
  private traces = svg("g", { class: "traces" });
  private marks = svg("g", { class: "marks" });
  private poses: Poses;
  readonly group: SVGElement;
  private paths: { key: string; points: Float64Array }[] = [];

  constructor(private session: Session, private view: View) {
    this.poses = new Poses(view);
    this.group = svg("g", { id: "overlay", "aria-hidden": "true" }, this.traces, this.poses.group, this.marks);
  }

  private drawn = ""; // the view in which the traces lie

  setTraces(paths: { key: string; points: Float64Array }[]): void {
    this.paths = paths;
    this.drawn = "";
  }

  // Returns the paths of traced points, m.
  get traced(): Float64Array[] {
    return this.paths.map(({ points }) => points);
  }

  draw(shown: Shown): void {
    if (this.drawn !== this.view.key) {
      this.drawn = this.view.key;
      fill(this.traces, ...this.paths.map(({ points }, k) => svg("polyline", { points: this.line(points), class: `trace trace-${k % 4}` })));
    }
    this.poses.draw(this.session.poses, this.session.dyads);
    fill(this.marks, ...this.handles(shown.tool), ...this.selected(), ...this.hovered(shown), ...this.wanted(), ...this.sketched(shown), ...this.crossed(shown));
  }

  private line(points: ArrayLike<number>): string {
    const parts: string[] = [];
    for (let k = 0; k + 1 < points.length; k += 2) {
      if (!Number.isFinite(points[k])) continue;
      const [x, y] = this.view.toScreen([points[k], points[k + 1]]);
      parts.push(`${x.toFixed(1)},${y.toFixed(1)}`);
    }
    return parts.join(" ");
  }

  private circle(world: Point, r: number, name: string): SVGElement {
    const [cx, cy] = this.view.toScreen(world);
    return svg("circle", { cx: cx.toFixed(1), cy: cy.toFixed(1), r, class: name });
  }

  private segment(a: Point, b: Point, name: string): SVGElement {
    const [x1, y1] = this.view.toScreen(a), [x2, y2] = this.view.toScreen(b);
    return svg("line", { x1: x1.toFixed(1), y1: y1.toFixed(1), x2: x2.toFixed(1), y2: y2.toFixed(1), class: name });
  }

  // Points are shown while drawing; while moving they only answer the pointer.
  private handles(tool: string): SVGElement[] {
    if (tool === "select") return [];
    const all = corners(this.session);
    return all.length > MOST_HANDLES ? [] : all.map((corner) => this.circle(corner.world, 4, corner.body === "ground" ? "handle fixed" : "handle"));
  }

  private selected(): SVGElement[] {
    const { machine, pose, selection } = this.session;
    if (!machine || !pose || !selection) return [];
    const at = (body: string, point: string) => {
      const found = machine.bodies[indexOf(machine, body)]?.points.find((one) => one.name === point);
      return found ? [this.circle(toGround(frameOf(machine, pose, body), found.at), 9, "chosen")] : [];
    };
    if (selection.kind === "point") return at(selection.body, selection.point);
    if (selection.kind === "joint") {
      const joint = machine.joints.find((one) => one.name === selection.joint);
      return joint && joint.points.length ? at(joint.bodies[0], joint.points[0]!) : [];
    }
    const body = machine.bodies[indexOf(machine, selection.body)], frame = frameOf(machine, pose, selection.body);
    const places = (body?.points ?? []).map((point) => toGround(frame, point.at));
    return [...places.slice(1).map((place, k) => this.segment(places[k], place, "chosen-line")), ...places.map((place) => this.circle(place, 7, "chosen"))];
  }

  private hovered({ hover }: Shown): SVGElement[] {
    return hover?.snapped === "point" ? [this.circle(hover.world, 9, "near")] : [];
  }

  private sketched({ sketching, pull }: Shown): SVGElement[] {
    const marks: SVGElement[] = [];
    if (sketching) {
      (sketching.corners ?? []).slice(1).forEach((one, k) => marks.push(this.segment(sketching.corners![k].world, one.world, "sketch"), this.circle(sketching.corners![k].world, 5, "sketch-end")));
      marks.push(this.segment(sketching.from.world, sketching.to.world, "sketch"), this.circle(sketching.from.world, 5, "sketch-end"), this.circle(sketching.to.world, 5, "sketch-end"));
      const [x, y] = this.view.toScreen(sketching.to.world);
      marks.push(svg("text", { x: x + 14, y: y - 12, class: "sketch-label" }, sketching.label));
    }
    const { machine, pose } = this.session;
    if (pull && machine && pose) {
      const held = toGround(frameOf(machine, pose, pull.body), pull.point);
      marks.push(this.circle(held, 7, "held"), this.segment(held, pull.to, "string"));
    }
    return marks;
  }

  // The curve that a linkage is to draw.
  private wanted(): SVGElement[] {
    const { wanted } = this.session;
    if (!wanted?.points.length) return [];
    const round = wanted.isClosed ? [...wanted.points, wanted.points[0]] : wanted.points, line = svg("polyline", { points: this.line(round.flat()), class: "wanted" });
    return [line, ...(wanted.isDone ? wanted.points.map((one) => this.circle(one, 3.5, "wanted-point")) : [])];
  }

  private crossed({ crosshair }: Shown): SVGElement[] {
    if (!crosshair) return [];
    const [x, y] = this.view.toScreen(crosshair.world);
    return [svg("path", { d: `M${x - 16} ${y}H${x + 16}M${x} ${y - 16}V${y + 16}`, class: "crosshair" }), svg("circle", { cx: x, cy: y, r: 6, class: "crosshair" })];
  }
}
