// Play, pause, slider and keys: the position in the motion, from 0 to the last row.
import { between, Data, number } from "./data";

export class Player {
  at = 0;
  private playing = false;
  private way = 1;
  private before = 0;
  private last: number;
  private slider = document.getElementById("slider") as HTMLInputElement;
  private button = document.getElementById("play") as HTMLButtonElement;
  private speed = document.getElementById("speed") as HTMLSelectElement;
  private now = document.getElementById("now")!;

  constructor(private data: Data, private show: (at: number) => void) {
    this.last = data.axis.values.length - 1;
    this.button.addEventListener("click", () => this.play(!this.playing));
    this.slider.addEventListener("input", () => { this.play(false); this.go(Number(this.slider.value)); });
    this.slider.addEventListener("keydown", (event) => this.step(event));
    addEventListener("keydown", (event) => {
      const on = event.target as HTMLElement;
      if (event.key !== " " || on.closest("button, input, select, a, summary, [role=region]")) return;
      event.preventDefault();
      this.play(!this.playing);
    });
    for (const id of ["controls", "keys"]) document.getElementById(id)!.hidden = false;
    this.go(Math.min(Math.max(data.start, 0), this.last));
  }

  private step(event: KeyboardEvent): void {
    const steps: Record<string, number> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };
    if (!(event.key in steps)) return;
    event.preventDefault();
    this.play(false);
    this.go(Math.min(Math.max(Math.round(this.at) + steps[event.key], 0), this.last));
  }

  go(at: number): void {
    this.at = at;
    this.slider.value = String(at);
    const { name, unit, values } = this.data.axis, text = `${name} = ${number(between(values, at))} ${unit}`;
    this.now.textContent = text;
    this.slider.setAttribute("aria-valuetext", text);
    this.show(at);
  }

  play(playing: boolean): void {
    if (playing === this.playing) return;
    this.playing = playing;
    this.button.textContent = playing ? "Pause" : "Play";
    this.button.setAttribute("aria-pressed", String(playing));
    this.before = performance.now();
    if (playing) requestAnimationFrame((time) => this.frame(time));
  }

  private frame(time: number): void {
    if (!this.playing) return;
    const seconds = Math.min(Math.max(time - this.before, 0), 100) / 1000;
    this.before = time;
    let at = this.at + (this.way * seconds * Number(this.speed.value) * this.last) / this.data.seconds;
    if (this.data.goes_back) {
      if (at > this.last || at < 0) {
        this.way = at > 0 ? -1 : 1;
        at = Math.min(Math.max(at, 0), this.last);
      }
    } else if (at > this.last) {
      at %= this.last;
    }
    this.go(at);
    requestAnimationFrame((next) => this.frame(next));
  }
}
