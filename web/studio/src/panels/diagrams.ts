// Diagrams of whatever is selected, over time or a driven coordinate, linked to the pose.
import type { Coordinate, Machine } from "../../../core/door";
import { byId, eachFrame, el, fill } from "../dom";
import { later } from "../later";
import { unitsOf } from "../document/numbers";
import { Source } from "../document/source";
import type { Motion } from "../motion";
import type { Session } from "../session";
import { words } from "../words";
import type { Curves, Plot } from "./plot";

const STEPS = 180;
type PlotMaker = typeof Plot;
const plots = later<PlotMaker>("plot.js", "yokePlot", words.diagrams.noPlots);

interface Channel { name: string; unit: string; factor: number }
interface Chart { title: string; channels: Channel[] }

export class Diagrams {
  private over = el("select", { "aria-label": words.diagrams.over });
  private own = el("input", { type: "text", placeholder: words.diagrams.example, title: words.diagrams.hint, "aria-label": words.diagrams.custom, spellcheck: "false", autocomplete: "off" });
  private plots = el("div", { class: "plots" });
  private note = el("p", { class: "hint", role: "status" });
  private charts: { plot: Plot; toAxis: number }[] = [];
  private isShown = false;
  private asked = 0;
  private later = eachFrame(() => void this.draw());

  constructor(private session: Session, private motion: Motion) {
    fill(byId("panel-diagrams"), el("div", { class: "row" }, el("label", {}, words.diagrams.over, " ", this.over), this.own), this.note, this.plots);
    this.over.addEventListener("change", this.later);
    this.own.addEventListener("change", this.later);
    session.on("opened", () => { this.offer(); this.later(); });
    session.on("selection", this.later);
    session.on("pose", () => this.mark());
    new ResizeObserver(() => { for (const { plot } of this.charts) plot.fit(); this.mark(); }).observe(this.plots);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", this.later);
  }

  set visible(isShown: boolean) {
    this.isShown = isShown;
    if (isShown) this.later();
  }
  refresh(): void { this.later(); }

  private offer(): void {
    const driven = this.session.machine?.coordinates.filter((one) => one.driven && one.kind === "angle") ?? [], kept = this.over.value;
    fill(this.over, el("option", { value: "t" }, words.diagrams.time), ...driven.map((one) => el("option", { value: one.name }, one.name)));
    this.over.value = driven.some((one) => one.name === kept) ? kept : "t";
  }

  // Returns the charts of what is selected: positions, velocities and accelerations of it.
  private chartsOf(machine: Machine): Chart[] {
    const units = unitsOf(new Source(this.session.text)), { selection } = this.session;
    const angle = units.angle === "deg" ? { unit: "deg", factor: 180 / Math.PI } : { unit: "rad", factor: 1 }, length = { unit: units.length, factor: 1 / units.metre };
    const rates = (names: string[], { unit, factor }: { unit: string; factor: number }): Chart[] =>
      [["", ""], [".rate", "/s"], [".accel", "/s²"]].map(([suffix, per], k) => ({
        title: [words.diagrams.position, words.diagrams.velocity, words.diagrams.acceleration][k], channels: names.map((name) => ({ name: name + suffix, unit: unit + per, factor })),
      }));
    if (this.own.value.trim()) return [{ title: words.diagrams.custom, channels: this.own.value.split(",").map((name) => ({ name: name.trim(), unit: "SI, rad", factor: 1 })).filter((one) => one.name) }];
    if (selection?.kind === "point") return rates([`${selection.body}.${selection.point}.x`, `${selection.body}.${selection.point}.y`], length);
    if (selection?.kind === "body" && selection.body !== "ground") return rates([`${selection.body}.angle`], angle).map((chart, k) => (k ? { ...chart, channels: chart.channels.map((one) => ({ ...one, name: one.name.replace(".angle.", ".") })) } : chart));
    const own = (one: Coordinate) => rates([one.name], one.kind === "angle" ? angle : length);
    const chosen = selection?.kind === "joint" ? machine.coordinates.filter((one) => one.joint === selection.joint) : [];
    if (chosen.length) return chosen.flatMap(own);
    const joint = selection?.kind === "joint" ? machine.joints.find((one) => one.name === selection.joint) : null;
    if (joint?.points.length) return rates([`${joint.bodies[1]}.${joint.points[1]}.x`, `${joint.bodies[1]}.${joint.points[1]}.y`], length);
    const follow = machine.coordinates.filter((one) => !one.driven);
    return follow.length ? own(follow.find((one) => one.kind === "length") ?? follow[0]) : machine.coordinates.slice(0, 1).flatMap(own);
  }

  private async draw(): Promise<void> {
    const { session } = this, machine = session.machine, ask = ++this.asked;
    if (!this.isShown) return;
    if (!machine || !session.isCurrent || !this.motion.isDriven) {
      this.clear();
      this.note.textContent = words.diagrams.none;
      return;
    }
    const charts = this.chartsOf(machine), channels = charts.flatMap((chart) => chart.channels), over = this.over.value || "t";
    const from = over === "t" ? 0 : this.startOf(over), to = over === "t" ? this.motion.period : from + 2 * Math.PI;
    const answer = await session.ask(() => session.core.curves(over, from, to, STEPS, channels.map((one) => one.name)));
    const Maker = await session.ask(plots);
    if (!answer || !Maker || ask !== this.asked) return;
    this.note.textContent = answer.status === "ok" ? "" : answer.message;
    const toAxis = over === "t" ? 1 : 180 / Math.PI, x = answer.x.map((value) => value * toAxis), kept = this.charts.length === charts.length;
    let at = 0;
    const curves = charts.map((chart): Curves => ({
      axis: over, axisUnit: over === "t" ? "s" : "deg", x, names: chart.channels.map((one) => one.name), unit: chart.channels[0]?.unit ?? "",
      values: chart.channels.map((one) => answer.of[at++]?.map((value) => value * one.factor) ?? new Float64Array(x.length)),
    }));
    const key = JSON.stringify([curves.map((one) => [one.names, one.unit, one.axis]), isDark()]);
    if (kept && key === this.kept) this.charts.forEach(({ plot }, k) => plot.update(curves[k]));
    else this.rebuild(Maker, charts, curves, toAxis);
    this.kept = key;
    this.mark();
  }
  private kept = "";

  private rebuild(Maker: PlotMaker, charts: Chart[], curves: Curves[], toAxis: number): void {
    this.clear();
    this.charts = curves.map((one, k) => {
      const box = el("div", { class: "plot", role: "img", "aria-label": `${words.diagrams.label}: ${one.names.join(", ")}` });
      this.plots.append(el("h2", {}, charts[k].title), box);
      return { plot: new Maker(box, one, isDark(), (x) => this.go(x / toAxis)), toAxis };
    });
  }

  private clear(): void {
    for (const { plot } of this.charts) plot.destroy();
    this.charts = [];
    this.kept = "";
    fill(this.plots);
  }

  private startOf(name: string): number {
    const index = this.session.machine!.coordinates.findIndex((one) => one.name === name);
    return this.session.start?.coordinates[index] ?? 0;
  }

  // Moves the machine to a place of the axis.
  private go(x: number): void {
    this.motion.stop();
    if ((this.over.value || "t") === "t") return void this.motion.to(x);
    const { session } = this, inputs = session.pose ? session.inputsOf(session.pose) : {};
    session.stand = { kind: "inputs", inputs: { ...inputs, [this.over.value]: x } };
    void session.ask(() => session.core.at({ ...inputs, [this.over.value]: x })).then((pose) => pose && session.show(pose));
  }

  private mark(): void {
    if (!this.isShown || !this.charts.length) return;
    const over = this.over.value || "t", pose = this.session.pose;
    const index = this.session.machine?.coordinates.findIndex((one) => one.name === over) ?? -1;
    const x = over === "t" ? this.motion.time : pose?.coordinates[index] ?? 0;
    for (const { plot, toAxis } of this.charts) plot.show(x * toAxis);
  }
}

export const isDark = (): boolean =>
  document.documentElement.dataset.theme === "dark" || (!document.documentElement.dataset.theme && matchMedia("(prefers-color-scheme: dark)").matches);
