// Diagrams over the motion. Hovering over one moves the machine; a line in each marks the pose shown.
import uPlot from "uplot";
import style from "uplot/dist/uPlot.min.css";
import { Data, Panel } from "./data";

const light = ["#1f5f99", "#b35a12", "#1d7350", "#8a4480", "#8f7400", "#2b7fa3", "#a93f22", "#554aa0", "#647a14", "#6a5a48"];
const dark = ["#7fb6e6", "#f0a562", "#6cc79e", "#d79ccd", "#dcc25a", "#7fc9e6", "#ef8f73", "#aba1ef", "#b4cc5e", "#c7b39c"];
const HEIGHT = 250;

// Returns the range of a diagram: all of it, unless a few values near a limit would flatten the rest.
function range(columns: (number | null | undefined)[][]): [number, number] {
  const values = columns.flat().filter((v): v is number => typeof v === "number").sort((a, b) => a - b);
  if (values.length === 0) return [-1, 1];
  const quantile = (q: number) => values[Math.round(q * (values.length - 1))];
  let low = values[0], high = values[values.length - 1];
  const inner = quantile(0.95) - quantile(0.05);
  if (inner > 0 && high - low > 5 * inner) {
    low = Math.max(low, quantile(0.05) - 0.75 * inner);
    high = Math.min(high, quantile(0.95) + 0.75 * inner);
  }
  const room = 0.05 * (high - low) || Math.abs(0.1 * high) || 1;
  return [low - room, high + room];
}

interface Chart { plot: uPlot; mark: HTMLElement; box: HTMLElement }

export class Charts {
  private charts: Chart[] = [];
  private at = 0;

  constructor(private data: Data, private moved: (row: number) => void) {
    const sheet = document.createElement("style");
    sheet.textContent = style;
    document.head.append(sheet);
    this.draw();
    const theme = matchMedia("(prefers-color-scheme: dark)");
    theme.addEventListener("change", () => this.draw());
    addEventListener("beforeprint", () => this.draw(true));
    addEventListener("afterprint", () => this.draw());
    new ResizeObserver(() => this.fit()).observe(document.querySelector("#diagrams .charts")!);
  }

  private draw(forPaper = false): void {
    const isDark = !forPaper && matchMedia("(prefers-color-scheme: dark)").matches;
    for (const { plot } of this.charts) plot.destroy();
    this.charts = [];
    for (const panel of this.data.panels) {
      const box = document.querySelector<HTMLElement>(`#chart-${panel.id} .plot`)!;
      this.charts.push(this.chart(panel, box, isDark));
    }
    this.show(this.at);
  }

  private chart(panel: Panel, box: HTMLElement, isDark: boolean): Chart {
    const { axis, columns } = this.data, colours = isDark ? dark : light;
    const ink = isDark ? "#a9b0b9" : "#555b63", line = isDark ? "#2e343c" : "#e4e6e9";
    const axisOf = (label: string): uPlot.Axis => ({
      label, stroke: ink, grid: { stroke: line, width: 1 }, ticks: { stroke: line, width: 1 }, labelSize: 22, size: 50,
      font: "12px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif",
    });
    const name = (word: string, unit: string) => (unit ? `${word} [${unit}]` : word);
    const mark = document.createElement("div");
    const plot = new uPlot({
      width: box.clientWidth, height: HEIGHT,
      scales: { x: { time: false }, y: { range: (u) => range(u.data.slice(1).filter((_, k) => u.series[k + 1].show) as (number | null)[][]) } },
      axes: [{ ...axisOf(name(axis.name, axis.unit)), size: 34 }, { ...axisOf(panel.unit), size: 56 }],
      series: [{ label: axis.name }, ...panel.columns.map((column, k): uPlot.Series => ({
        label: columns[column].name, stroke: colours[k % colours.length], width: 2, spanGaps: false, points: { show: false },
        dash: k >= colours.length ? [6, 4] : undefined,
      }))],
      cursor: { drag: { x: true, y: false }, points: { size: 6 } },
      hooks: {
        init: [(u) => {
          mark.style.cssText = `position:absolute;top:0;bottom:0;left:0;width:0;border-left:1.5px solid ${ink};pointer-events:none`;
          u.over.append(mark);
        }],
        setCursor: [(u) => { if (u.over.matches(":hover") && u.cursor.idx != null) this.moved(u.cursor.idx); }],
        setScale: [() => this.show(this.at)],
      },
    }, [axis.values as number[], ...panel.columns.map((column) => columns[column].values)], box);
    return { plot, mark, box };
  }

  private fit(): void {
    for (const { plot, box } of this.charts)
      if (box.clientWidth > 0 && box.clientWidth !== plot.width) plot.setSize({ width: box.clientWidth, height: HEIGHT });
    this.show(this.at);
  }

  show(at: number): void {
    this.at = at;
    const values = this.data.axis.values as number[], row = Math.min(Math.floor(at), values.length - 1);
    const x = values[row] + (at - row) * ((values[row + 1] ?? values[row]) - values[row]);
    for (const { plot, mark } of this.charts) {
      const left = plot.valToPos(x, "x"), inside = left >= 0 && left <= plot.over.clientWidth;
      mark.style.transform = `translateX(${left.toFixed(1)}px)`;
      mark.style.display = inside ? "" : "none";
      if (!plot.over.matches(":hover")) plot.setLegend({ idx: Math.round(at) }, false);
    }
  }
}
