// The session: the text, what the core makes of it, the pose, and what is selected. Everybody else listens.
import { CoreLost, Overtaken } from "../../core/door";
import type { Core, Machine, Opened, Pose } from "../../core/door";
import type { Dyad, Placed } from "./canvas/poses";
import type { Wanted } from "./canvas/stroke";
import { Draft } from "./document/gestures";
import { words } from "./words";

export type Selection = { kind: "body"; body: string } | { kind: "point"; body: string; point: string } | { kind: "joint"; joint: string } | null;
// The pose to which the machine was last moved, so that it stands there again after an edit.
export type Stand = { kind: "start" } | { kind: "time"; time: number } | { kind: "inputs"; inputs: Record<string, number> };

export interface Trial { text: string; machine: Machine; start: Pose; last: string /* shown last */ }

interface Events {
  text: string; // the text changed
  opened: Opened; // the core read it
  pose: Pose;
  scene: null; // it was drawn again, for another view
  selection: Selection;
  posed: boolean; // places for a body were set; true: by a hand that has done
  linked: null; // links that reach them were found
  wanted: Wanted | null; // the curve that a linkage is to draw
  said: string; // a sentence for the person
  lost: string; // the core died and was started anew
}

export class Session {
  text = "";
  name = "machine";
  opened: Opened | null = null;
  machine: Machine | null = null; // the last that could be drawn
  scene: string | null = null;
  start: Pose | null = null;
  pose: Pose | null = null;
  selection: Selection = null;
  wanted: Wanted | null = null;
  poses: Placed[] = []; // of a body that a linkage is to lead through them
  dyads: Dyad[] = []; // links that do
  stand: Stand = { kind: "start" };
  isCurrent = false; // the machine is that of the text
  settled: Promise<void> = Promise.resolve();
  // Puts an edit into the editor; set by it.
  write: (text: string) => void = () => {};
  private listeners = new Map<string, ((value: never) => void)[]>();
  private edition = 0;

  constructor(readonly core: Core) {}

  on<K extends keyof Events>(event: K, listener: (value: Events[K]) => void): void {
    this.listeners.set(event, [...(this.listeners.get(event) ?? []), listener as (value: never) => void]);
  }

  emit<K extends keyof Events>(event: K, value: Events[K]): void {
    for (const listener of this.listeners.get(event) ?? []) (listener as (value: Events[K]) => void)(value);
  }

  // Takes the text of the editor and reads it.
  take(text: string): void {
    this.text = text;
    this.emit("text", text);
    this.settled = this.open();
  }

  private async open(): Promise<void> {
    const edition = ++this.edition;
    this.isCurrent = false;
    const opened = await this.ask(() => this.core.open(this.text, this.name));
    if (!opened || edition !== this.edition) return;
    this.adopt(opened);
    if (this.stand.kind !== "start" && opened.machine) await this.standAgain(edition);
  }

  private adopt(opened: Opened): void {
    this.opened = opened;
    if (opened.machine && opened.pose) {
      [this.machine, this.scene, this.start, this.isCurrent] = [opened.machine, opened.scene, opened.pose, true];
      this.pose = opened.pose;
    } else if (this.text.trim() === "") [this.machine, this.scene, this.start, this.pose] = [null, null, null, null];
    this.emit("opened", opened);
    if (this.isCurrent) this.emit("pose", this.pose!);
  }

  private async standAgain(edition: number): Promise<void> {
    const stand = this.stand;
    const pose = await this.ask(() => (stand.kind === "time" ? this.core.time(stand.time) : this.core.at((stand as { inputs: Record<string, number> }).inputs)));
    if (!pose || edition !== this.edition) return;
    if (pose.status === "ok") this.show(pose);
    else this.stand = { kind: "start" };
  }

  // Sets the curve that a linkage is to draw.
  want(wanted: Wanted | null): void {
    this.wanted = wanted;
    this.emit("wanted", wanted);
  }

  // Sets the places that a body is to pass. Links found for the places before stay in sight until there are others.
  place(poses: Placed[], isDone: boolean): void {
    if (poses.length !== this.poses.length) this.dyads = [];
    this.poses = poses;
    this.emit("posed", isDone);
  }

  link(dyads: Dyad[]): void {
    this.dyads = dyads;
    this.emit("linked", null);
  }

  // Shows a slider's value before it is written.
  async preview(name: string, value: number): Promise<void> {
    const opened = await this.ask(() => this.core.parameter(name, value));
    if (!opened) return;
    this.adopt(opened);
    if (this.stand.kind !== "start") await this.standAgain(this.edition);
  }

  // The machine on which an edit is tried: as it is before the hand takes hold of a point.
  get trial(): Trial | null {
    return this.isCurrent && this.machine && this.start ? { text: this.text, machine: this.machine, start: this.start, last: this.text } : null;
  }

  // Shows the machine that a gesture would make, before it is written; one that makes none is reported, and shows nothing.
  async tryOut(trial: Trial, gesture: (draft: Draft) => void, resolution: number): Promise<void> {
    const draft = new Draft(trial.text, trial.machine, trial.start, resolution);
    gesture(draft);
    if (draft.text === trial.last) return;
    trial.last = draft.text;
    const opened = await this.ask(() => this.core.open(draft.text, this.name));
    if (!opened || trial.last !== draft.text) return;
    if (!opened.machine || !opened.pose) return this.emit("said", opened.problems[0]?.message ?? words.say.noAnswer);
    this.adopt(opened);
    if (this.stand.kind !== "start") await this.standAgain(this.edition);
  }

  // Ends a trial: what was shown last is written, or the machine stands as it was.
  async endTrial(trial: Trial, isKept: boolean): Promise<void> {
    const text = isKept ? trial.last : trial.text;
    trial.last = trial.text; // what is still on its way shows nothing
    this.stand = { kind: "start" };
    if (text !== this.text) this.write(text);
    else this.settled = this.open();
    await this.settled;
  }

  // Asks the core. Answers that were overtaken, and a core that was lost, answer null.
  async ask<T>(question: () => Promise<T>): Promise<T | null> {
    try {
      return await question();
    } catch (error) {
      if (error instanceof CoreLost) this.emit("lost", words.coreLost);
      else if (!(error instanceof Overtaken)) this.emit("said", String((error as Error).message ?? error));
      return null;
    }
  }

  show(pose: Pose): void {
    this.pose = pose;
    this.emit("pose", pose);
    this.emit("said", pose.message);
  }

  // Has the scene drawn for a view with this number of pixels to the metre.
  async look(scale: number): Promise<void> {
    const edition = this.edition, looked = await this.ask(() => this.core.look(scale));
    if (!looked || edition !== this.edition || !this.isCurrent) return;
    this.scene = looked.scene;
    this.emit("scene", null);
    this.pose = looked.pose;
    this.emit("pose", looked.pose);
  }

  async toStart(): Promise<void> {
    this.stand = { kind: "start" };
    if (!this.start || this.pose === this.start) return;
    const pose = await this.ask(() => this.core.time(0));
    if (pose) this.show(pose);
  }

  async toTime(time: number): Promise<Pose | null> {
    const pose = await this.ask(() => this.core.time(time));
    if (pose) {
      this.stand = { kind: "time", time: pose.time };
      this.show(pose);
    }
    return pose;
  }

  async drag(body: string, point: [number, number], to: [number, number]): Promise<void> {
    const pose = await this.ask(() => this.core.drag(body, point, to));
    if (!pose) return;
    this.stand = { kind: "inputs", inputs: this.inputsOf(pose) };
    this.show(pose);
  }

  inputsOf(pose: Pose): Record<string, number> {
    const inputs: Record<string, number> = {};
    this.machine?.coordinates.forEach((one, k) => {
      if (one.free || one.driven) inputs[one.name] = pose.coordinates[k];
    });
    return inputs;
  }

  select(selection: Selection): void {
    if (JSON.stringify(selection) === JSON.stringify(this.selection)) return;
    this.selection = selection;
    this.emit("selection", selection);
  }

  // Makes one edit of the text by gestures, on the machine at its start. False: it could not be made.
  async edit(gesture: (draft: Draft) => void, resolution = 1e-4): Promise<boolean> {
    await this.settled;
    const empty: Machine = { name: "", bodies: [], joints: [], coordinates: [], parameters: [], freedom: 0, moves: false };
    const none = { bodies: new Float64Array(), coordinates: new Float64Array() } as unknown as Pose;
    const draft = new Draft(this.text, this.machine ?? empty, this.start ?? none, resolution);
    if (!draft.source.isSound || (!this.isCurrent && this.text.trim() !== "" && this.machine)) {
      this.emit("said", words.mendFirst);
      return false;
    }
    gesture(draft);
    this.stand = { kind: "start" };
    if (draft.text !== this.text) this.write(draft.text);
    await this.settled;
    return true;
  }
}
