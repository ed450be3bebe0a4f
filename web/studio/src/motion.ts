// The motion: play, scrub, step, slow motion; letting go; the other assemblies; traces.
import type { Canvas } from "./canvas/canvas";
import type { Hand } from "./canvas/pointer";
import { byId, el, fill } from "./dom";
import { icon } from "./icons";
import { decimal } from "./document/numbers";
import type { Session } from "./session";
import { words } from "./words";

const SPEEDS = [["1", "1×"], ["0.5", "½×"], ["0.25", "¼×"], ["0.1", "⅒×"], ["0.01", "1/100×"]];
const SHORTEST = 0.6; // s, of a turn that can be seen
const STEPS = 240; // of the slider, of a trace
const STIFFNESS = 200; // N/m for each kilogram or so: the string of the pointer

export class Motion {
  time = 0;
  period = 2; // s
  private turn: { index: number; from: number; rate: number } | null = null; // the driven angle that a period belongs to
  private state: "still" | "playing" | "free" = "still";
  private isAsking = false;
  private isNew = true;
  private last = 0;
  private pulled: Parameters<Hand["onPull"]>[0] = null;
  private asked = 0; // for traces
  private traced = new Set<string>();
  private play = el("button", { class: "play", onclick: () => this.toggle() });
  private slider = el("input", { type: "range", min: 0, max: STEPS, step: "any", value: "0", "aria-label": words.motion.time });
  private now = el("output", { class: "now" });
  private speed = el("select", { "aria-label": words.motion.speed }, ...SPEEDS.map(([value, text]) => el("option", { value }, text)));
  private free = el("button", { class: "text", title: words.motion.releaseHow, "aria-pressed": "false", onclick: () => void this.letGo() }, words.motion.release);
  private ghosts = el("button", { title: `${words.motion.ghosts} (O)`, "aria-label": words.motion.ghosts, "aria-pressed": "false", onclick: () => void this.toggleGhosts() }, icon("ghosts"));

  constructor(private session: Session, private canvas: Canvas, hand: Hand) {
    const button = (name: string, word: string, action: () => void, key = "") => el("button", { title: word + key, "aria-label": word, onclick: action }, icon(name));
    fill(byId("motion"), button("start", words.motion.start, () => void this.restart(), " (Home)"), button("back", words.motion.back, () => this.step(-1), " ([)"), this.play,
      button("on", words.motion.on, () => this.step(1), " (])"), this.slider, this.now, this.speed, this.free, this.ghosts,
      button("trace", words.motion.trace, () => void this.trace(), " (T)"), canvas.arrows.control);
    this.slider.addEventListener("input", () => { this.stop(); void this.to((Number(this.slider.value) / STEPS) * this.period); });
    session.on("opened", (opened) => { if (opened.machine) void this.measure(); });
    session.on("pose", () => this.tell());
    hand.onGrab = () => { if (this.state === "playing") this.stop(); this.canvas.scene.ghosts([]); };
    hand.onPull = (pull) => {
      this.pulled = pull;
      return this.state === "free";
    };
    hand.shape.onHold = (body, point) => {
      this.keep(body, point);
      void this.retrace();
    };
    canvas.scene.onGhost = (index) => void this.choose(index);
    this.state = "still";
    this.tell();
  }

  // Another machine comes: its speed is chosen so that a turn can be seen.
  begin(): void {
    this.stop();
    this.isNew = true;
    this.time = 0;
  }

  // Finds how long one turn takes: of the first driven angle, if it turns evenly.
  private async measure(): Promise<void> {
    const { session } = this, machine = session.machine!, index = machine.coordinates.findIndex((one) => one.driven && one.kind === "angle");
    this.turn = null;
    if (index >= 0) {
      const turn = await session.ask(() => session.core.turn(index));
      if (turn && Math.abs(turn.rate) > 1e-6 && session.machine === machine) this.turn = { index, ...turn };
    }
    this.period = this.turn ? (2 * Math.PI) / Math.abs(this.turn.rate) : 5;
    if (this.isNew) this.speed.value = SPEEDS.find(([value]) => this.period / Number(value) >= SHORTEST)?.[0] ?? "0.01";
    this.isNew = false;
    this.tell();
    await this.retrace();
  }

  // How long a turn takes on the screen, s.
  get lasts(): number {
    return this.period / Number(this.speed.value);
  }

  get isDriven(): boolean {
    return this.session.machine?.coordinates.some((one) => one.driven) ?? false;
  }

  toggle(): void {
    if (this.state === "free") void this.letGo();
    else if (this.state === "playing") this.stop();
    else void this.start();
  }

  // Plays. The text is read first: who has just driven the machine and presses Space at once means this machine.
  private async start(): Promise<void> {
    await this.session.settled;
    if (this.state !== "still") return;
    if (!this.isDriven) return this.session.emit("said", words.say.steady);
    this.state = "playing";
    this.last = 0;
    this.canvas.scene.ghosts([]);
    this.tell();
    requestAnimationFrame((now) => void this.frame(now));
  }

  stop(): void {
    if (this.state !== "playing") return;
    this.state = "still";
    this.tell();
  }

  private async frame(now: number): Promise<void> {
    if (this.state === "still") return;
    const passed = this.last ? Math.min(0.1, (now - this.last) / 1000) : 0;
    if (!this.isAsking) {
      this.last = now;
      this.isAsking = true;
      if (this.state === "playing") await this.advance(passed * Number(this.speed.value));
      else await this.fall(passed * Number(this.speed.value));
      this.isAsking = false;
    }
    requestAnimationFrame((next) => void this.frame(next));
  }

  private async advance(passed: number): Promise<void> {
    let time = this.time + passed;
    if (this.turn && time > this.period) time -= this.period * Math.floor(time / this.period);
    const pose = await this.to(time);
    if (pose && pose.status !== "ok" && this.state === "playing") {
      this.stop();
      this.session.emit("said", pose.message);
    }
  }

  private async fall(passed: number): Promise<void> {
    const pull = this.pulled ? { ...this.pulled, stiffness: STIFFNESS } : undefined;
    const pose = await this.session.ask(() => this.session.core.step(passed, pull));
    if (!pose || this.state !== "free") return;
    this.session.show(pose);
    if (pose.status !== "ok") await this.letGo();
  }

  async to(time: number) {
    this.time = Math.max(0, time);
    return this.session.toTime(this.time);
  }

  step(way: number): void {
    this.stop();
    void this.to(this.time + (way * this.period) / 120);
  }

  async restart(): Promise<void> {
    this.stop();
    if (this.state === "free") await this.letGo();
    this.time = 0;
    await this.session.toStart();
    this.tell();
  }

  // Lets the machine go, or takes hold of it again.
  async letGo(): Promise<void> {
    const { session } = this;
    if (this.state === "free") {
      this.state = "still";
      const pose = await session.ask(() => session.core.hold());
      if (pose) {
        session.stand = { kind: "inputs", inputs: session.inputsOf(pose) };
        session.show(pose);
      }
    } else if (session.machine) {
      this.stop();
      const pose = await session.ask(() => session.core.release());
      if (!pose) return;
      session.show(pose);
      if (pose.status !== "ok") return;
      this.state = "free";
      this.last = 0;
      requestAnimationFrame((now) => void this.frame(now));
    }
    this.tell();
  }

  async toggleGhosts(): Promise<void> {
    if (this.canvas.scene.hasGhosts) this.canvas.scene.ghosts([]);
    else {
      this.stop();
      const poses = (await this.session.ask(() => this.session.core.ghosts())) ?? [];
      this.canvas.scene.ghosts(poses);
      this.session.emit("said", words.say.ghosts(poses.length));
    }
    this.ghosts.setAttribute("aria-pressed", String(this.canvas.scene.hasGhosts));
    this.canvas.redraw();
  }

  private async choose(index: number): Promise<void> {
    const pose = await this.session.ask(() => this.session.core.choose(index));
    this.canvas.scene.ghosts([]);
    this.ghosts.setAttribute("aria-pressed", "false");
    if (!pose) return;
    this.session.stand = { kind: "inputs", inputs: this.session.inputsOf(pose) };
    this.session.show(pose);
  }

  // Traces the selected point over a turn, or no longer.
  async trace(): Promise<void> {
    const { selection, machine } = this.session;
    if (!selection || !machine) return;
    const joint = selection.kind === "joint" ? machine.joints.find((one) => one.name === selection.joint) : null;
    const side = joint && joint.bodies[0] === "ground" ? 1 : 0;
    const at = selection.kind === "point" ? selection : joint?.points.length ? { body: joint.bodies[side], point: joint.points[side]! } : null;
    const body = at?.body ?? (selection.kind === "body" ? selection.body : null);
    const names = at ? [at.point] : machine.bodies.find((one) => one.name === body)?.points.map((one) => one.name) ?? [];
    const keys = names.map((name) => JSON.stringify([body, name])), isOn = keys.every((key) => this.traced.has(key));
    for (const key of keys) if (isOn) this.traced.delete(key); else this.traced.add(key);
    await this.retrace();
  }

  // Traces a point from the next machine on.
  keep(body: string, point: string): void {
    this.traced.add(JSON.stringify([body, point]));
  }

  private async retrace(): Promise<void> {
    const paths: { key: string; points: Float64Array }[] = [], { session } = this, asked = ++this.asked;
    for (const key of this.traced) {
      const [body, name] = JSON.parse(key) as [string, string];
      const point = session.machine?.bodies.find((one) => one.name === body)?.points.find((one) => one.name === name);
      if (!point) continue;
      const points = await session.ask(() => session.core.trace(body, point.at, "t", 0, this.period, STEPS));
      if (asked !== this.asked) return; // a newer machine has been asked for
      if (points) paths.push({ key, points });
    }
    this.canvas.overlay.setTraces(paths);
    this.canvas.redraw();
  }

  private tell(): void {
    const { pose, machine } = this.session;
    if (pose && this.session.stand.kind === "inputs" && this.turn && this.state === "still") {
      const turned = (pose.coordinates[this.turn.index] - this.turn.from) / this.turn.rate;
      this.time = turned - this.period * Math.floor(turned / this.period);
    } else if (pose && this.session.stand.kind === "start") this.time = 0;
    const shown = this.state === "free" && pose ? pose.time : this.time, text = decimal(shown, 0.001);
    this.slider.value = String(Math.min(1, this.time / this.period) * STEPS);
    this.slider.setAttribute("aria-valuetext", words.motion.seconds(text));
    this.now.textContent = words.motion.seconds(shown.toFixed(this.period < 0.5 ? 3 : 2));
    const name = this.state === "playing" ? words.motion.pause : words.motion.play;
    if (this.play.getAttribute("aria-label") !== name) {
      this.play.setAttribute("aria-label", name);
      this.play.title = `${name} (Space)`;
      fill(this.play, icon(this.state === "playing" ? "pause" : "play"));
    }
    const isFree = this.state === "free", word = isFree ? words.motion.hold : words.motion.release;
    if (this.free.textContent !== word) { // nothing is written that stays as it is: each frame would lay the bar out anew
      this.free.setAttribute("aria-pressed", String(isFree));
      this.free.textContent = word;
    }
    if (byId("motion").hidden !== !machine) byId("motion").hidden = !machine;
  }
}
