// Paints the core's drawing on a sheet of pixels: for machines of more parts than a page can lay out in a frame, and for films.
// The drawing is taken apart once; then a pose is nothing but numbers.
import type { Machine } from "../../../core/door";
import { AXES, indexOf } from "./frames";

type Kind = "line" | "ring" | "word";
interface Style { fill: string; stroke: string; width: number /* m */; join: CanvasLineJoin; dash: number[] /* m */; cap: CanvasLineCap; font: string; opacity: number }
interface Mark { kind: Kind; body: number; isClosed: boolean; places: number[] /* m, in the body's axes: x, y; of a ring its middle */; radius: number /* m */; word: string; style: Style }
// Marks of one look, painted in one go. `starts`: where the places of each mark begin.
interface Batch { kind: Kind; style: Style; marks: Mark[]; bodies: Int32Array; starts: Int32Array; places: Float64Array }
// What of the plane the sheet shows: px for each metre, and where the ground's origin lies, px.
export interface Shot { scale: number; x: number; y: number }

const numbersOf = (text: string | null): number[] => (text?.match(/[-+.\d]+(?:e[-+]?\d+)?/gi) ?? []).map(Number);
const NONE: Style = { fill: "#000000", stroke: "none", width: 0, join: "miter", dash: [], cap: "butt", font: "", opacity: 1 };
const LEAST = 1.6; // px: of very many marks, smaller circles are left out, and thinner lines end plainly
const CIRCLE = 2 * Math.PI;

// Takes a drawing of lines, circles and words apart: what its elements inherit, and where their own axes lie in those of their body.
class Reader {
  readonly marks: Mark[] = [];
  constructor(private machine: Machine, private perMetre: number, private colour: (element: Element, kind: "fill" | "stroke", value: string) => string) {}

  read(parent: Element, axes: DOMMatrix, body: number, style: Style): void {
    for (const element of Array.from(parent.children)) {
      const name = element.getAttribute("data-body"), turned = (element as SVGGraphicsElement).transform?.baseVal.consolidate()?.matrix;
      const own = this.styled(element, style), isOf = name === null ? body : this.bodyOf(name);
      const there = name !== null ? new DOMMatrix() : turned ? axes.multiply(turned) : axes;
      if (element.localName === "g") this.read(element, there, isOf, own);
      else this.take(element, there, isOf, own);
    }
  }

  // The ground, and whatever has no pose, has the last axes.
  private bodyOf(name: string): number {
    const index = indexOf(this.machine, name);
    return index < 0 || this.machine.bodies[index].ground ? this.machine.bodies.length : index;
  }

  private styled(element: Element, from: Style): Style {
    const word = (name: string) => element.getAttribute(name), style = { ...from };
    for (const kind of ["fill", "stroke"] as const) { const value = word(kind); if (value) style[kind] = value === "none" ? "none" : this.colour(element, kind, value); }
    if (word("stroke-width")) style.width = Number(word("stroke-width")) / this.perMetre;
    if (word("stroke-linejoin")) style.join = word("stroke-linejoin") as CanvasLineJoin;
    if (word("stroke-linecap")) style.cap = word("stroke-linecap") as CanvasLineCap;
    if (word("stroke-dasharray")) style.dash = numbersOf(word("stroke-dasharray")).map((one) => one / this.perMetre);
    if (word("opacity")) style.opacity *= Number(word("opacity"));
    const how = [word("font-style"), word("font-weight")].filter(Boolean).join(" ");
    if (how) style.font = how;
    return style;
  }

  private take(element: Element, axes: DOMMatrix, body: number, style: Style): void {
    const number = (name: string) => Number(element.getAttribute(name) ?? 0);
    const add = (kind: Kind, pairs: number[], isClosed = false, radius = 0, word = "") => {
      const places = pairs.slice();
      for (let k = 0; k + 1 < pairs.length; k += 2) {
        const at = axes.transformPoint({ x: pairs[k], y: pairs[k + 1] });
        [places[k], places[k + 1]] = [at.x, at.y];
      }
      this.marks.push({ kind, body, isClosed, places, radius: radius / this.perMetre, word, style });
    };
    if (element.localName === "line") add("line", [number("x1"), number("y1"), number("x2"), number("y2")]);
    else if (element.localName === "polyline" || element.localName === "polygon") add("line", numbersOf(element.getAttribute("points")), element.localName === "polygon");
    else if (element.localName === "circle") add("ring", [number("cx"), number("cy")], false, number("r"));
    else if (element.localName === "text") add("word", [number("x"), number("y")], false, 0, element.textContent ?? "");
  }
}

// Gathers marks. One after the other keeps what lies over what; `isMany` lets all marks of one look be painted at once.
function gather(marks: Mark[], isMany: boolean): Batch[] {
  const groups: Mark[][] = [], places = new Map<string, number>();
  let last = "";
  for (const mark of marks) {
    const key = JSON.stringify([mark.kind, mark.isClosed, mark.style]), known = isMany ? places.get(key) : key === last ? groups.length - 1 : undefined;
    last = key;
    if (known !== undefined && mark.kind !== "word" && (isMany || mark.style.fill === "none")) groups[known].push(mark);
    else places.set(key, groups.push([mark]) - 1);
  }
  return groups.map((group) => {
    const starts = new Int32Array(group.length + 1);
    group.forEach((mark, k) => { starts[k + 1] = starts[k] + mark.places.length; });
    return { kind: group[0].kind, style: group[0].style, marks: group, bodies: Int32Array.from(group, (mark) => mark.body), starts, places: Float64Array.from(group.flatMap((mark) => mark.places)) };
  });
}

export type Colour = (element: Element, kind: "fill" | "stroke", value: string) => string;
const asWritten: Colour = (_element, _kind, value) => value;

export class Painter {
  private batches: Batch[];
  private still: Batch[]; // of the ground

  // Of a scene, or of the parts that go with it (`perMetre`, `origin`: of the scene).
  constructor(root: Element, machine: Machine, private perMetre: number, origin: number[], private isMany: boolean, colour: Colour = asWritten) {
    const reader = new Reader(machine, perMetre, colour), ground = new DOMMatrix([1 / perMetre, 0, 0, -1 / perMetre, -origin[0] / perMetre, origin[1] / perMetre]);
    reader.read(root, ground, machine.bodies.length, NONE);
    this.batches = gather(isMany ? reader.marks.filter((mark) => mark.body < machine.bodies.length) : reader.marks, isMany);
    this.still = gather(isMany ? reader.marks.filter((mark) => mark.body === machine.bodies.length) : [], isMany);
  }

  // Paints the pose whose axes are given (axesOf), over the present picture. Of many marks those of the ground are painted apart, once a view.
  paint(context: CanvasRenderingContext2D, shot: Shot, axes: Float64Array, isStill = false): void {
    for (const batch of isStill ? this.still : this.batches) {
      const { style } = batch;
      if (this.isMany && batch.kind === "ring" && batch.marks[0].radius * shot.scale < LEAST) continue;
      context.globalAlpha = style.opacity;
      context.fillStyle = style.fill === "none" ? "#000" : style.fill;
      context.strokeStyle = style.stroke === "none" ? "#000" : style.stroke;
      context.lineWidth = style.width * shot.scale;
      [context.lineJoin, context.lineCap] = this.isMany && context.lineWidth < 2 * LEAST ? ["bevel", "butt"] : [style.join, style.cap];
      context.setLineDash(style.dash.map((one) => one * shot.scale));
      if (batch.kind === "word") this.write(context, shot, axes, batch);
      else this.trace(context, shot, axes, batch);
    }
    context.globalAlpha = 1;
  }

  private trace(context: CanvasRenderingContext2D, { scale, x: left, y: top }: Shot, axes: Float64Array, { kind, style, marks, bodies, starts, places }: Batch): void {
    const isRing = kind === "ring";
    context.beginPath();
    for (let k = 0; k < bodies.length; k++) {
      const at = AXES * bodies[k], ox = axes[at], oy = axes[at + 1], c = axes[at + 2], s = axes[at + 3];
      for (let i = starts[k]; i + 1 < starts[k + 1]; i += 2) {
        const x = left + scale * (ox + c * places[i] - s * places[i + 1]), y = top - scale * (oy + s * places[i] + c * places[i + 1]);
        if (isRing) {
          const r = marks[k].radius * scale;
          context.moveTo(x + r, y);
          context.arc(x, y, r, 0, CIRCLE);
        } else if (i === starts[k]) context.moveTo(x, y);
        else context.lineTo(x, y);
      }
      if (marks[k].isClosed) context.closePath();
    }
    if (style.fill !== "none") context.fill();
    if (style.stroke !== "none" && style.width > 0) context.stroke();
  }

  private write(context: CanvasRenderingContext2D, shot: Shot, axes: Float64Array, { style, marks }: Batch): void {
    const size = (13 * shot.scale) / this.perMetre;
    context.font = `${style.font} ${size}px Helvetica, Arial, "DejaVu Sans", sans-serif`;
    context.textAlign = "center";
    for (const { body, places: [px, py], word } of marks) {
      const at = AXES * body, c = axes[at + 2], s = axes[at + 3];
      const x = shot.x + shot.scale * (axes[at] + c * px - s * py), y = shot.y - shot.scale * (axes[at + 1] + s * px + c * py);
      if (style.stroke !== "none") context.strokeText(word, x, y);
      if (style.fill !== "none") context.fillText(word, x, y);
    }
  }
}
