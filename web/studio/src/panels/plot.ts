// One plot: curves over an axis, with a mark at the pose that the machine has. Pointing at it moves the machine there. A
// script of its own, loaded when the first diagram is shown.
import uPlot from "uplot";
import { el } from "../dom";

const COLOURS = { light: ["#1f5f99", "#b35a12", "#1d7350", "#8a3fa0", "#9a2f3f", "#4d5a66"], dark: ["#7fb6e8", "#f0a869", "#6fd0a3", "#d49be6", "#f08c9a", "#aab6c2"] };

export interface Curves { axis: string; axisUnit: string; x: Float64Array; names: string[]; unit: string; values: Float64Array[] }

export class Plot {
  private mark = el("div", { class: "plot-mark" });
  private plot: uPlot;

  constructor(readonly box: HTMLElement, curves: Curves, isDark: boolean, moved: (x: number) => void) {
    const [ink, line] = isDark ? ["#a3abb6", "#30353d"] : ["#5a6069", "#e3e4e2"];
    const colours = isDark ? COLOURS.dark : COLOURS.light, font = "12px system-ui, sans-serif";
    const axis = (label: string, size: number): uPlot.Axis => ({ label, stroke: ink, grid: { stroke: line, width: 1 }, ticks: { stroke: line, width: 1, size: 4 }, labelSize: 20, size, font, labelFont: font, gap: 4 });
    const bracket = (name: string, unit: string) => (unit ? `${name} [${unit}]` : name);
    this.plot = new uPlot({
      width: Math.max(200, box.clientWidth), height: 190, scales: { x: { time: false } },
      axes: [axis(bracket(curves.axis, curves.axisUnit), 32), axis(curves.unit ? `[${curves.unit}]` : "", 58)],
      series: [{ label: curves.axis, value: (_plot, value) => (value == null ? "–" : String(Number(value.toPrecision(5)))) }, ...curves.names.map((label, k): uPlot.Series => ({ label, stroke: colours[k % colours.length], width: 2, points: { show: false }, value: (_plot, value) => (value == null ? "–" : String(Number(value.toPrecision(5)))), dash: k >= colours.length ? [6, 4] : undefined }))],
      cursor: { drag: { x: false, y: false }, points: { size: 6 } }, legend: { live: true },
      hooks: { init: [(plot) => { plot.over.append(this.mark); }] },
    }, [Array.from(curves.x), ...curves.values.map((values) => Array.from(values, (value) => (Number.isFinite(value) ? value : null)))] as uPlot.AlignedData, box);
    let isDown = false;
    const go = (event: PointerEvent) => moved(this.plot.posToVal(event.clientX - this.plot.over.getBoundingClientRect().left, "x"));
    this.plot.over.addEventListener("pointerdown", (event) => { isDown = true; this.plot.over.setPointerCapture(event.pointerId); go(event); });
    this.plot.over.addEventListener("pointermove", (event) => { if (isDown) go(event); });
    this.plot.over.addEventListener("pointerup", () => { isDown = false; });
    this.plot.over.style.touchAction = "pan-y";
  }

  update(curves: Curves): void {
    this.plot.setData([Array.from(curves.x), ...curves.values.map((values) => Array.from(values))] as uPlot.AlignedData);
  }

  // Marks the place of the pose.
  show(x: number): void {
    const left = this.plot.valToPos(x, "x"), inside = left >= 0 && left <= this.plot.over.clientWidth;
    this.mark.style.transform = `translateX(${left.toFixed(1)}px)`;
    this.mark.style.display = inside ? "" : "none";
    if (!this.plot.over.matches(":hover")) {
      const xs = this.plot.data[0];
      let low = 0, high = xs.length - 1;
      while (low < high) {
        const middle = (low + high) >> 1;
        if (xs[middle] < x) low = middle + 1; else high = middle;
      }
      this.plot.setLegend({ idx: low }, false);
    }
  }

  fit(): void {
    if (this.box.clientWidth > 0 && this.box.clientWidth !== this.plot.width) this.plot.setSize({ width: this.box.clientWidth, height: 190 });
  }
  destroy(): void { this.plot.destroy(); }
}

(globalThis as { yokePlot?: typeof Plot }).yokePlot = Plot;
