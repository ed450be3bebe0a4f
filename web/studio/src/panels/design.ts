// Design: a curve drawn by hand, and the linkages that the core finds for it, each as a small moving picture. The search
// has a core of its own, so that the drawing stays quick, and stopping ends it at once.
import type { Core, Reply } from "../../../core/door";
import type { Canvas } from "../canvas/canvas";
import { FILE, inUnits, taskOf } from "../document/task";
import { byId, el, fill } from "../dom";
import type { Session } from "../session";
import { words } from "../words";

type Finder = Core & { close(): void };
interface Candidate { model: string; mechanism: string; type?: string; worst: number; transmission: [number, number]; lengths?: Record<string, number>; parameters: Record<string, number> }
interface Found { candidates: Candidate[]; left_out: Record<string, number> }

const WITHIN = "30s", MODEL = "machine.yaml", PICTURE = "moving.svg";
const DEGREES = 180 / Math.PI;

export class Design {
  onDraw: () => void = () => {}; // the person wants to draw a curve
  onTake: () => void = () => {}; // a linkage comes into the document: `coupler.P` draws the curve
  private finder: Finder | null = null;
  private seed = 0;
  private known = new Set<string>();
  private pictures: string[] = [];
  private mechanism = el("select", { "aria-label": words.design.mechanism }, ...words.design.mechanisms.map(([value, name]) => el("option", { value }, name)));
  private task = el("textarea", { rows: 9, "aria-label": words.design.task, spellcheck: "false", autocomplete: "off", autocapitalize: "off" });
  private find = el("button", { class: "small", onclick: () => void this.search(true) }, words.design.find);
  private others = el("button", { class: "quiet", hidden: true, onclick: () => void this.search(false) }, words.design.others);
  private end = el("button", { class: "quiet", hidden: true, onclick: () => this.stop() }, words.design.stop);
  private note = el("pre", { class: "hint note", role: "status" });
  private cards = el("div", { class: "cards" });

  constructor(private session: Session, private canvas: Canvas, private start: () => Finder) {
    fill(byId("panel-design"), el("p", { class: "hint" }, words.design.how),
      el("div", { class: "row wrap" }, el("button", { class: "strong", onclick: () => this.onDraw() }, words.design.draw), this.mechanism, el("button", { class: "quiet", onclick: () => session.want(null) }, words.design.clear)),
      el("details", {}, el("summary", {}, words.design.task), this.task), el("div", { class: "row wrap" }, this.find, this.others, this.end), this.note, this.cards);
    this.mechanism.addEventListener("change", () => this.write());
    session.on("wanted", (wanted) => {
      if (wanted && !wanted.isDone) return;
      this.write();
      if (wanted && wanted.points.length > 9) void this.search(true); // drawn in one stroke
    });
  }

  // Writes the task of the curve; without one the task that stands there stays.
  private write(): void {
    const { wanted } = this.session;
    if (wanted && wanted.points.length > 1) this.task.value = taskOf(wanted, this.mechanism.value, this.canvas.units, this.canvas.resolution);
  }

  private stop(): void {
    this.finder?.close();
    this.finder = null;
  }

  private clear(): void {
    for (const address of this.pictures.splice(0)) URL.revokeObjectURL(address);
    this.known.clear();
    fill(this.cards);
  }

  // Searches anew, or on, from other starts.
  private async search(isNew: boolean): Promise<void> {
    if (!this.task.value.trim()) return this.tell(words.design.none);
    this.stop();
    if (isNew) this.clear();
    this.seed = isNew ? 1 : this.seed + 1;
    const finder = (this.finder = this.start());
    this.busy(true);
    this.tell(words.design.wait);
    try {
      const reply = await finder.run(["synthesize", FILE, "--format", "json", "--seed", String(this.seed), "--within", WITHIN], { [FILE]: this.task.value });
      await this.show(finder, reply);
    } catch { // stopped, or a newer search took its place
      if (this.finder === null) this.tell(words.design.stopped);
    }
    if (this.finder !== null && this.finder !== finder) return;
    this.stop();
    this.busy(false);
  }

  private busy(isBusy: boolean): void {
    this.end.hidden = !isBusy;
    this.find.hidden = isBusy;
    this.others.hidden = isBusy || this.known.size === 0;
    this.cards.setAttribute("aria-busy", String(isBusy));
  }

  private tell(text: string): void {
    this.note.textContent = text;
  }

  private async show(finder: Finder, reply: Reply): Promise<void> {
    if (!reply.out) return this.tell(reply.err.trim() || words.say.noAnswer);
    const found = JSON.parse(reply.out) as Found, fresh = found.candidates.filter((one) => !this.known.has(keyOf(one)));
    for (const one of fresh) {
      this.known.add(keyOf(one));
      const drawing = await this.picture(finder, one.model);
      this.cards.append(this.card(one, drawing));
    }
    this.tell(fresh.length ? words.design.found(fresh.length) : words.design.nothing(Object.entries(found.left_out).map(([why, count]) => `${count} ${why}`).join(", ")));
  }

  // Has the command draw the linkage with its curve: moving, unless the person wants pages to be still.
  private async picture(finder: Finder, model: string): Promise<Uint8Array | null> {
    const isStill = matchMedia("(prefers-reduced-motion: reduce)").matches, how = [isStill ? "-o" : "--animate", PICTURE];
    const trace = /\bcoupler:.*\bP:/.test(model) ? ["--trace", "coupler.P"] : [];
    const reply = await finder.run(["draw", MODEL, "--no-labels", ...how, ...trace], { [MODEL]: model });
    return reply.files[PICTURE] ?? null;
  }

  private card(one: Candidate, drawing: Uint8Array | null): HTMLElement {
    const name = one.type ?? one.mechanism, about = words.design.about(inUnits(one.worst, this.canvas.units), (one.transmission[0] * DEGREES).toFixed(0));
    const image = drawing && el("img", { src: this.address(drawing), alt: "" });
    return el("button", { class: "card", title: words.design.take, onclick: () => this.take(one) }, el("span", { class: "card-picture" }, image), el("b", {}, name), el("span", { class: "about" }, about));
  }

  private address(drawing: Uint8Array): string {
    const address = URL.createObjectURL(new Blob([drawing.slice()], { type: "image/svg+xml" }));
    this.pictures.push(address);
    return address;
  }

  // Takes a linkage into the document, as one edit.
  private take(one: Candidate): void {
    this.onTake();
    this.session.stand = { kind: "start" };
    this.session.write(one.model);
    void this.session.settled.then(() => this.canvas.fit());
    this.session.emit("said", words.design.taken);
  }
}

// Other starts find the same linkage again, but for its last digits.
const keyOf = (one: Candidate): string => [one.mechanism, ...Object.values(one.lengths ?? one.parameters).map((value) => value.toPrecision(3))].join(" ");
