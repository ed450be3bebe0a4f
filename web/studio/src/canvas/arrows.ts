// Arrows on the machine: velocities and accelerations of points, forces in joints. Values come from the core with each pose.
import { byId, el, fill, svg } from "../dom";
import { decimal } from "../document/numbers";
import { icon } from "../icons";
import type { Session } from "../session";
import { words } from "../words";
import { frameOf, toGround } from "./frames";
import type { Point } from "./frames";
import type { View } from "./view";

export type Kind = "none" | "velocity" | "acceleration" | "force";
interface Arrow { at: Point; value: Point; isOpen: boolean } // m; in the unit of its kind; one of many

const KINDS: Kind[] = ["none", "velocity", "acceleration", "force"];
const LONGEST = 90; // px, of the longest arrow when a kind is first shown
const LEAST = 1.5; // px: shorter ones are not drawn
const BAR = 80; // px: the legend's bar is no longer
const MOST = 1500; // points of a machine whose arrows are drawn

export class Arrows {
  readonly group = svg("g", { class: "arrows", "aria-hidden": "true" });
  kind: Kind = "none";
  private arrows: Arrow[] = [];
  private scale = 0; // px for each unit; 0: to be chosen
  private isAsking = false;
  private isLate = false; // a pose came while the core was asked
  private button = el("button", { id: "arrows-turn", title: `${words.arrows.turn} (A)`, "aria-label": words.arrows.turn, "aria-pressed": "false", onclick: () => this.turn() }, icon("arrows"));
  private bar = svg("line", { x1: 1, y1: 6, y2: 6, class: "arrow", "marker-end": "url(#arrow-tip)" });
  private amount = el("output", {});

  constructor(private session: Session, private view: View, private redraw: () => void) {
    session.on("pose", () => void this.ask());
    session.on("opened", (opened) => { if (!opened.machine) this.take([]); });
    byId("notes").prepend(el("div", { id: "arrows", role: "group", "aria-label": words.arrows.label, hidden: true }));
  }

  get control(): HTMLButtonElement {
    return this.button;
  }

  turn(): void {
    this.show(KINDS[(KINDS.indexOf(this.kind) + 1) % KINDS.length]);
  }

  show(kind: Kind): void {
    this.kind = kind;
    this.scale = 0;
    this.arrows = [];
    this.button.setAttribute("aria-pressed", String(kind !== "none"));
    byId("arrows").hidden = kind === "none";
    if (kind !== "none") {
      const button = (word: string, sign: string, factor: number) => el("button", { class: "quiet", title: word, "aria-label": word, onclick: () => { this.scale *= factor; this.redraw(); } }, icon(sign));
      fill(byId("arrows"), el("b", {}, words.arrows[kind][0]), svg("svg", { width: BAR + 12, height: 12, "aria-hidden": "true" }, this.bar), this.amount, button(words.arrows.shorter, "less", 1 / 1.5), button(words.arrows.longer, "in", 1.5));
    }
    void this.ask();
    this.redraw();
  }

  // Asks for the values at the pose; while it waits, newer poses wait for one more question.
  private async ask(): Promise<void> {
    const { session, kind } = this;
    if (kind === "none" || !session.machine || !session.isCurrent) return;
    if (this.isAsking) {
      this.isLate = true;
      return;
    }
    this.isAsking = true;
    const arrows = await session.ask(() => (kind === "force" ? this.forces() : this.rates(kind)));
    this.isAsking = false;
    if (arrows && this.kind === kind) this.take(arrows);
    if (this.isLate || this.kind !== kind) {
      this.isLate = false;
      void this.ask();
    }
  }

  private take(arrows: Arrow[]): void {
    this.arrows = arrows;
    this.redraw();
  }

  private async rates(kind: "velocity" | "acceleration"): Promise<Arrow[]> {
    const { session } = this, { machine, pose } = session, rates = await session.core.rates(), first = kind === "velocity" ? 0 : 2;
    if (!rates) session.emit("said", words.arrows.none);
    else if (rates.points.length > 4 * MOST) session.emit("said", words.arrows.tooMany(String(MOST)));
    if (!rates || !machine || !pose || rates.points.length > 4 * MOST) return [];
    const arrows: Arrow[] = [];
    let at = 0;
    for (const body of machine.bodies) {
      const frame = frameOf(machine, pose, body.name);
      for (const point of body.points) {
        const value: Point = [rates.points[at + first], rates.points[at + first + 1]];
        if (!body.ground) arrows.push({ at: toGround(frame, point.at), value, isOpen: false });
        at += 4;
      }
    }
    return arrows;
  }

  private async forces(): Promise<Arrow[]> {
    const { message, joints } = await this.session.core.forces(), arrows: Arrow[] = [];
    for (let k = 0; k + 4 < joints.length; k += 5) arrows.push({ at: [joints[k], joints[k + 1]], value: [joints[k + 2], joints[k + 3]], isOpen: joints[k + 4] === 0 });
    if (message) this.session.emit("said", message);
    else if (arrows.some((one) => one.isOpen)) this.session.emit("said", words.arrows.many);
    return arrows;
  }

  draw(): void {
    const isShown = this.kind !== "none" && this.session.isCurrent;
    const sizes = isShown ? this.arrows.flatMap(({ value }) => value.map(Math.abs)).filter(Number.isFinite) : [], largest = Math.max(0, ...sizes);
    if (this.scale === 0 && largest > 0) this.scale = LONGEST / largest;
    const seen = new Set<string>(), tip = svg("marker", { id: "arrow-tip", viewBox: "0 0 8 8", refX: 6.5, refY: 4, markerWidth: 8, markerHeight: 8, markerUnits: "userSpaceOnUse", orient: "auto" }, svg("path", { d: "M0 .8 7.5 4 0 7.2z" }));
    const lines = !isShown ? [] : this.arrows.flatMap(({ at, value, isOpen }) => {
      const [x, y] = this.view.toScreen(at), [dx, dy] = [this.scale * value[0], -this.scale * value[1]], key = [x, y, dx, dy].map((one) => one.toFixed(1)).join(" ");
      if (!(Math.abs(dx) + Math.abs(dy) > LEAST) || seen.has(key)) return []; // also what is not a number
      seen.add(key);
      return [svg("line", { x1: x.toFixed(1), y1: y.toFixed(1), x2: (x + dx).toFixed(1), y2: (y + dy).toFixed(1), class: isOpen ? "arrow open" : "arrow", "marker-end": "url(#arrow-tip)" })];
    });
    fill(this.group, tip, ...lines);
    if (this.kind !== "none") this.legend(this.kind);
  }

  // A bar of a round value.
  private legend(kind: "velocity" | "acceleration" | "force"): void {
    const most = BAR / this.scale, power = Math.pow(10, Math.floor(Math.log10(most))), value = [5, 2, 1].map((step) => step * power).find((one) => one <= most) ?? power;
    if (!(this.scale > 0 && Number.isFinite(value))) {
      this.bar.setAttribute("x2", "1");
      return fill(this.amount, words.arrows[kind][1]);
    }
    this.bar.setAttribute("x2", String(1 + value * this.scale));
    fill(this.amount, words.arrows.scale(value >= 1e5 || value < 1e-4 ? value.toExponential(0) : decimal(value, power), words.arrows[kind][1]));
  }
}
