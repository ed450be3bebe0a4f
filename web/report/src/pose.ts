// Shows the drawing at a row: every group of a body is turned and shifted, and names follow their places.
import { between, Body, Data, Place } from "./data";

interface Shift { x: number; y: number; turn: number }

function shift(body: Body, at: number): Shift {
  return { x: between(body.x, at)!, y: between(body.y, at)!, turn: between(body.turn, at)! };
}

// Returns where a place on a body is, on the page.
export function placeAt(data: Data, place: Place, at: number): [number, number] {
  const body = data.bodies![place.body], to = shift(body, at), angle = (to.turn * Math.PI) / 180;
  const dx = place.at[0] - body.center[0], dy = place.at[1] - body.center[1], c = Math.cos(angle), s = Math.sin(angle);
  return [body.center[0] + to.x + c * dx - s * dy, body.center[1] + to.y + s * dx + c * dy];
}

export class Pose {
  private groups: { elements: SVGGElement[]; place: Place | null; body: Body }[] = [];

  constructor(private data: Data, svg: SVGSVGElement) {
    const find = (name: string) => Array.from(svg.querySelectorAll<SVGGElement>("g." + name));
    data.bodies!.forEach((body, k) => this.groups.push({ elements: find("b" + k), place: null, body }));
    const follow = (name: string) => (place: Place, k: number) =>
      this.groups.push({ elements: find(name + k), place, body: data.bodies![place.body] });
    data.joints!.forEach(follow("j"));
    data.middles!.forEach(follow("n"));
    this.groups = this.groups.filter((group) => group.elements.length > 0);
  }

  show(at: number): void {
    for (const { elements, place, body } of this.groups) {
      let transform: string;
      if (place) {
        const [x, y] = placeAt(this.data, place, at);
        transform = `translate(${(x - place.at[0]).toFixed(2)} ${(y - place.at[1]).toFixed(2)})`;
      } else {
        const to = shift(body, at);
        transform = `translate(${to.x.toFixed(2)} ${to.y.toFixed(2)}) ` +
          `rotate(${to.turn.toFixed(4)} ${body.center[0]} ${body.center[1]})`;
      }
      for (const element of elements) element.setAttribute("transform", transform);
    }
  }
}
