// The keyboard on the canvas: a crosshair moved by the arrow keys, Enter as the click, digits as typed lengths.
import { el } from "../dom";
import { decimal, typed } from "../document/numbers";
import type { Session } from "../session";
import { words } from "../words";
import type { Canvas } from "./canvas";
import { along, bearing, distance } from "./frames";
import { corners, snap } from "./snap";
import type { Spot } from "./snap";
import type { Hand } from "./pointer";

export class Keys {
  private world: [number, number] | null = null;
  private input = el("input", { type: "text", class: "typed", hidden: true, "aria-label": words.canvas.typedLabel, autocomplete: "off" });

  constructor(private canvas: Canvas, private hand: Hand, private session: Session) {
    canvas.root.parentElement!.append(this.input);
    canvas.root.addEventListener("keydown", (event) => this.key(event));
    canvas.root.addEventListener("pointerdown", () => { this.world = null; });
    this.input.addEventListener("keydown", (event) => {
      if (event.key === "Enter") void this.take();
      else if (event.key === "Escape") this.close();
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    this.input.addEventListener("blur", () => { this.input.hidden = true; });
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey) return;
    const moves: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    if (event.key in moves) this.step(moves[event.key], event.shiftKey ? 5 : 1);
    else if (event.key === "Enter") void this.click();
    else if (event.key === "n" || event.key === "N") this.next(event.shiftKey ? -1 : 1);
    else if (/^[0-9.]$/.test(event.key) && this.hand.tool.places >= 2 && this.hand.spots.length) this.open(event.key);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private step([dx, dy]: [number, number], count: number): void {
    const { step, view } = this.canvas, at = this.world ?? view.toWorld([view.width / 2, view.height / 2]);
    this.go([(Math.round(at[0] / step) + dx * count) * step, (Math.round(at[1] / step) + dy * count) * step]);
  }

  // Goes to the next point of a body, in the order of the file.
  private next(way: number): void {
    const places = corners(this.session);
    if (!places.length) return;
    const here = this.world, now = here ? places.findIndex((one) => distance(one.world, here) < 1e-9) : -1;
    for (let k = 1; k <= places.length; k++) {
      const place = places[(now + way * k + 2 * places.length) % places.length];
      if (!here || distance(place.world, here) > 1e-9) return this.go(place.world);
    }
  }

  private spot(): Spot {
    return snap(this.session, this.canvas.view, this.world!, { reach: 6, grid: this.canvas.step, isFree: false, client: null });
  }

  private go(world: [number, number]): void {
    this.world = world;
    const spot = this.spot(), { view, units, resolution } = this.canvas, [x, y] = view.toScreen(world);
    if (x < 20 || y < 20 || x > view.width - 20 || y > view.height - 20) view.pan(view.width / 2 - x, view.height / 2 - y);
    this.canvas.shown.crosshair = spot;
    this.hand.preview(spot);
    const tell = (value: number) => decimal(value / units.metre, resolution / units.metre);
    const what = spot.all.map((one) => `${one.body}.${one.point}`).join(", ") || spot.onBody;
    this.session.emit("said", words.canvas.at(tell(spot.world[0]), tell(spot.world[1]), units.length) + (what ? words.canvas.on(what) : ""));
    this.canvas.redraw();
  }

  private async click(): Promise<void> {
    if (!this.world) return this.step([0, 0], 0);
    if (this.hand.tool.id === "select") this.hand.select(this.spot());
    else await this.hand.later(() => this.hand.click(this.spot()));
    this.canvas.shown.crosshair = this.spot();
    this.canvas.redraw();
  }

  private open(first: string): void {
    const to = this.canvas.shown.sketching?.to.world ?? this.hand.spots.at(-1)!.world, [x, y] = this.canvas.view.toScreen(to);
    this.input.hidden = false;
    this.input.value = first;
    this.input.style.left = `${Math.min(x + 16, this.canvas.view.width - 190)}px`;
    this.input.style.top = `${Math.max(8, y - 40)}px`;
    this.input.focus();
  }

  private close(): void {
    this.input.hidden = true;
    this.canvas.root.focus();
  }

  // Ends the gesture at the typed distance, in the typed direction or the pointer's.
  private async take(): Promise<void> {
    const answer = typed(this.input.value, this.canvas.units), from = this.hand.spots.at(-1);
    if (!answer || !from) {
      this.session.emit("said", words.say.typedWrong);
      return;
    }
    const to = this.canvas.shown.sketching?.to.world ?? from.world, isApart = distance(from.world, to) > 1e-12;
    const world = along(from.world, answer.angle ?? (isApart ? bearing(from.world, to) : 0), answer.length ?? distance(from.world, to));
    this.close();
    this.world = world;
    const spot = snap(this.session, this.canvas.view, world, { reach: 1, grid: this.canvas.step, isFree: true, client: null });
    await this.hand.later(() => this.hand.click(spot));
  }
}
