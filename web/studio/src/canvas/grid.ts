// The grid: fine and strong lines, with their unit in the corner.
import { svg } from "../dom";
import type { View } from "./view";

export class Grid {
  private fine = svg("path", { class: "fine" });
  private strong = svg("path", { class: "strong" });
  private axes = svg("path", { class: "axes" });
  readonly group = svg("g", { id: "grid", "aria-hidden": "true" }, this.fine, this.strong, this.axes);

  private drawn = ""; // the view in which the lines lie

  draw(view: View, unit: number): void {
    const key = view.key + unit;
    if (key === this.drawn) return;
    this.drawn = key;
    const step = view.gridStep(unit, 14), strongStep = view.gridStep(unit, 70);
    this.fine.setAttribute("d", this.lines(view, step));
    this.strong.setAttribute("d", this.lines(view, strongStep));
    const [x, y] = view.toScreen([0, 0]);
    this.axes.setAttribute("d", `M${px(x)} 0V${view.height}M0 ${px(y)}H${view.width}`);
  }

  private lines(view: View, step: number): string {
    const [left, top] = view.toWorld([0, 0]), [right, bottom] = view.toWorld([view.width, view.height]), parts: string[] = [];
    for (let k = Math.ceil(left / step); k * step <= right; k++) parts.push(`M${px(view.toScreen([k * step, 0])[0])} 0V${view.height}`);
    for (let k = Math.ceil(bottom / step); k * step <= top; k++) parts.push(`M0 ${px(view.toScreen([0, k * step])[1])}H${view.width}`);
    return parts.join("");
  }
}

const px = (value: number): string => (Math.round(value) + 0.5).toFixed(1);
