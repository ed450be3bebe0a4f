// Design: a curve drawn by hand, and the linkages that the core finds for it, each as a small moving picture. They appear while
// the search runs. It has a core of its own, so that the drawing stays quick; stopping ends that core, and keeps its results so far.
import type { Core } from "../../../core/door";
import type { Canvas } from "../canvas/canvas";
import { FILE, inUnits, placesTask, taskOf } from "../document/task";
import { byId, el, fill } from "../dom";
import type { Session } from "../session";
import { words } from "../words";
import { Finds, readLines } from "./finds";
import type { Candidate } from "./finds";

type Worker = Core & { close(): void };
interface Found { candidates: Candidate[]; left_out: Record<string, number>; dyads: { fixed: [number, number]; moving: [number, number] }[] }

const WITHIN = "30s", MODEL = "machine.yaml", PICTURE = "moving.svg";
const DEGREES = 180 / Math.PI, EXACT = 1e-9; // m: what is left of rounding

export class Design {
  onDraw: () => void = () => {}; // the person wants to draw a curve
  onPlace: () => void = () => {}; // the person wants to set places of a body
  onTake: () => void = () => {}; // a linkage comes into the document: `coupler.P` draws the curve
  private finder: Worker | null = null;
  private painter: Worker | null = null;
  private follower: Worker | null = null; // finds links while a place is dragged
  private isFollowing = false;
  private painted: Promise<unknown> = Promise.resolve(); // one picture after the other
  private seed = 0;
  private pictures: string[] = [];
  private mechanism = el("select", { "aria-label": words.design.mechanism }, ...words.design.mechanisms.map(([value, name]) => el("option", { value }, name)));
  private task = el("textarea", { rows: 9, "aria-label": words.design.task, spellcheck: "false", autocomplete: "off", autocapitalize: "off" });
  private find = el("button", { class: "small", onclick: () => void this.search(true) }, words.design.find);
  private others = el("button", { class: "quiet", hidden: true, onclick: () => void this.search(false) }, words.design.others);
  private end = el("button", { class: "quiet", hidden: true, onclick: () => this.finder?.stop() }, words.design.stop);
  private part = el("progress", { max: "1", value: "0", hidden: true, "aria-label": words.design.progress });
  private note = el("pre", { class: "hint note", role: "status" });
  private cards = el("div", { class: "cards" });
  private finds = new Finds(this.cards, (one) => this.card(one));

  constructor(private session: Session, private canvas: Canvas, private start: () => Worker) {
    fill(byId("panel-design"), el("p", { class: "hint" }, words.design.how),
      el("div", { class: "row wrap" }, el("button", { class: "strong", onclick: () => this.onDraw() }, words.design.draw), el("button", { class: "strong", onclick: () => this.onPlace() }, words.design.place), this.mechanism, el("button", { class: "quiet", onclick: () => { session.want(null); session.place([], true); } }, words.design.clear)),
      el("details", {}, el("summary", {}, words.design.task), this.task), el("div", { class: "row wrap" }, this.find, this.others, this.end, this.part), this.note, this.cards);
    this.mechanism.addEventListener("change", () => this.write());
    session.on("posed", (isDone) => { if (isDone) this.placed(); else void this.follow(); });
    session.on("wanted", (wanted) => {
      if (wanted && !wanted.isDone) return;
      this.write();
      if (wanted) session.place([], true);
      if (wanted && wanted.points.length > 9) void this.search(true); // drawn in one stroke
    });
  }

  // Places were set: with two of them there is a task.
  private placed(): void {
    const { session } = this;
    if (!session.poses.length) return;
    if (session.wanted) session.want(null);
    this.write();
    if (session.poses.length > 1) void this.search(true);
  }

  // A place is dragged: the links for it are found meanwhile, one search after the other, as fast as the core can. Linkages wait for the end.
  private async follow(): Promise<void> {
    const { session } = this, { poses } = session;
    if (this.isFollowing || poses.length < 2) return;
    this.isFollowing = true;
    this.follower ??= this.start();
    const task = placesTask(poses, this.mechanism.value, this.canvas.units, this.canvas.resolution, false);
    const reply = await this.follower.run(["synthesize", FILE, "--format", "json", "--quiet"], { [FILE]: task }).catch(() => null);
    this.isFollowing = false;
    if (reply?.out.startsWith("{") && session.poses.length === poses.length) session.link((JSON.parse(reply.out) as Found).dyads ?? []);
    if (session.poses !== poses) void this.follow();
  }

  // Writes the task of the curve, or of the places; without one the present task stays.
  private write(): void {
    const { wanted, poses } = this.session, { units, resolution } = this.canvas;
    if (poses.length > 1) this.task.value = placesTask(poses, this.mechanism.value, units, resolution);
    else if (wanted && wanted.points.length > 1) this.task.value = taskOf(wanted, this.mechanism.value, units, resolution);
  }

  private stop(): void {
    this.finder?.close();
    this.finder = null;
  }

  private clear(): void {
    for (const address of this.pictures.splice(0)) URL.revokeObjectURL(address);
    this.finds.clear();
  }

  // Searches anew, or on, from other starts.
  private async search(isNew: boolean): Promise<void> {
    if (!this.task.value.trim()) return this.tell(words.design.none);
    this.stop();
    if (isNew) this.clear();
    this.seed = isNew ? 1 : this.seed + 1;
    const finder = (this.finder = this.start());
    this.finds.begin();
    this.busy(true);
    this.tell(words.design.wait);
    try {
      const hear = readLines((line) => { if (this.finder === finder) this.hear(line); });
      const reply = await finder.run(["synthesize", FILE, "--format", "json", "--so-far", "--seed", String(this.seed), "--within", WITHIN], { [FILE]: this.task.value }, hear);
      const answer = reply.out.search(/^\{$/m); // behind the lines that were heard
      if (!reply.complete) this.tell(words.design.stopped(this.finds.count));
      else if (answer < 0) this.tell(reply.err.trim() || words.say.noAnswer);
      else this.show(JSON.parse(reply.out.slice(answer)) as Found);
    } catch { /* a newer search took its place, or the core was lost, which is reported */ }
    if (this.finder !== finder) return;
    this.stop();
    this.busy(false);
  }

  private busy(isBusy: boolean): void {
    this.end.hidden = this.part.hidden = !isBusy;
    this.part.value = 0;
    this.find.hidden = isBusy;
    this.others.hidden = isBusy || this.finds.isEmpty;
    this.cards.setAttribute("aria-busy", String(isBusy));
  }

  private tell(text: string): void {
    this.note.textContent = text;
  }

  // Takes a line of the search's output: how far it is, or a linkage and its place among the best so far.
  private hear(line: string): void {
    const told = JSON.parse(line) as Candidate & { part?: number; rank: number; best: number };
    if (told.part !== undefined) {
      this.part.value = told.part;
      return;
    }
    this.finds.put(told, told.rank - 1, told.best);
    this.tell(words.design.soFar(this.finds.count));
  }

  private show(found: Found): void {
    const count = this.finds.settle(found.candidates), { session } = this, dyads = session.poses.length && found.dyads?.length ? words.design.dyads(found.dyads.length) + ". " : "";
    if (session.poses.length) session.link(found.dyads ?? []);
    this.tell(dyads + (count ? words.design.found(count) : words.design[session.poses.length ? "nothingThere" : "nothing"](Object.entries(found.left_out).map(([why, times]) => `${times} ${why}`).join(", "))));
  }

  // Has the command draw the linkage with its curve: moving, unless the person wants pages to be still.
  private async picture(model: string): Promise<Uint8Array | null> {
    const isStill = matchMedia("(prefers-reduced-motion: reduce)").matches, how = [isStill ? "-o" : "--animate", PICTURE];
    const trace = /\bcoupler:.*\bP:/.test(model) ? ["--trace", "coupler.P"] : [];
    this.painter ??= this.start();
    const reply = await this.painter.run(["draw", MODEL, "--no-labels", ...how, ...trace], { [MODEL]: model });
    return reply.files[PICTURE] ?? null;
  }

  private card(one: Candidate): HTMLElement {
    const name = one.type ?? one.mechanism, transmission = one.transmission ? (one.transmission[0] * DEGREES).toFixed(0) : null;
    const picture = el("span", { class: "card-picture" }), about = words.design.about(one.worst < EXACT ? null : inUnits(one.worst, this.canvas.units), transmission);
    const card = el("button", { class: "card", title: words.design.take, onclick: () => this.take(one) }, picture, el("b", {}, name), el("span", { class: "about" }, about));
    this.painted = this.painted.then(async () => {
      const drawing = card.isConnected ? await this.picture(one.model).catch(() => null) : null; // a better one may have taken its place
      if (drawing && card.isConnected) fill(picture, el("img", { src: this.address(drawing), alt: "" }));
    });
    return card;
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
