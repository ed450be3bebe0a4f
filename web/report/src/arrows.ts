// Velocities of points and forces in joints as arrows over the drawing.
import { between, Data, Place } from "./data";
import { placeAt } from "./pose";

type From = Place & { columns: number[]; turned?: number };
interface Arrow { place: From; columns: number[]; path: SVGPathElement }

// Returns a length that all but a few values stay below, since velocities are unbounded near a limit.
function usual(data: Data, places: { columns: number[] }[]): number {
  const sizes: number[] = [];
  for (const { columns: [x, y] } of places)
    data.columns[x].values.forEach((vx, row) => {
      const vy = data.columns[y].values[row];
      if (vx !== null && vy !== null) sizes.push(Math.hypot(vx, vy));
    });
  sizes.sort((a, b) => a - b);
  return sizes[Math.floor(0.95 * (sizes.length - 1))] ?? 0;
}

export class Arrows {
  private arrows: Arrow[] = [];
  private scale: number;
  private most: number;
  shown = false;

  constructor(private data: Data, svg: SVGSVGElement, kind: string, places: From[]) {
    const known = places.filter((place) => place.columns.length === 2), size = usual(data, known);
    const width = svg.viewBox.baseVal.width;
    this.scale = size > 0 ? (0.14 * width) / size : 0;
    this.most = 0.3 * width;
    for (const place of this.scale > 0 ? known : []) {
      const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
      path.setAttribute("class", `arrow ${kind} off`);
      svg.append(path);
      this.arrows.push({ place, columns: place.columns, path });
    }
  }

  get count(): number { return this.arrows.length; }

  toggle(shown: boolean, at: number): void {
    this.shown = shown;
    for (const { path } of this.arrows) path.classList.toggle("off", !shown);
    this.show(at);
  }

  show(at: number): void {
    if (!this.shown) return;
    for (const { place, columns: [cx, cy], path } of this.arrows) {
      const vx = between(this.data.columns[cx].values, at), vy = between(this.data.columns[cy].values, at);
      const c = Math.cos(place.turned ?? 0), s = Math.sin(place.turned ?? 0); // on the page y is down
      path.setAttribute("d", vx === null || vy === null ? "" :
        this.draw(placeAt(this.data, place, at), c * vx + s * vy, s * vx - c * vy));
    }
  }

  private draw([x, y]: [number, number], vx: number, vy: number): string {
    const size = Math.hypot(vx, vy) * this.scale, length = Math.min(size, this.most);
    if (length < 1) return "";
    const ux = (vx * this.scale) / size, uy = (vy * this.scale) / size, head = Math.min(9, 0.4 * length);
    const tip = [x + length * ux, y + length * uy];
    const side = (way: number) =>
      `M${(tip[0] - head * (ux - 0.5 * way * uy)).toFixed(1)} ${(tip[1] - head * (uy + 0.5 * way * ux)).toFixed(1)}` +
      `L${tip[0].toFixed(1)} ${tip[1].toFixed(1)}`;
    return `M${x.toFixed(1)} ${y.toFixed(1)}L${tip[0].toFixed(1)} ${tip[1].toFixed(1)}` + side(1) + side(-1);
  }
}
