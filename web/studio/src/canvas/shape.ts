// Reshaping: a point is dragged, and the machine and all its curves are shown as they would be, before anything is written.
import type { Session, Trial } from "../session";
import { words } from "../words";
import type { Canvas } from "./canvas";
import type { Drag } from "./grab";
import type { Spot } from "./snap";

export class Shape {
  onHold: (body: string, point: string) => void = () => {}; // a point is taken hold of

  constructor(private canvas: Canvas, private session: Session) {}

  // Takes hold of a point of all bodies that have it.
  hold(spot: Spot): Drag {
    const trial = spot.all.length ? this.session.trial : null, at = spot.all.find((one) => one.body !== "ground");
    if (!trial) return { kind: "pan" };
    if (at) this.onHold(at.body, at.point);
    return { kind: "shape", spot, trial };
  }

  move(spot: Spot, trial: Trial, to: Spot): void {
    this.canvas.shown.sketching = { from: spot, to, label: "" };
    void this.session.tryOut(trial, (draft) => {
      const stays = draft.movePoint(spot.all, to.world);
      if (stays) this.session.emit("said", words.say.expression(stays));
    }, this.canvas.resolution);
  }

  async end(trial: Trial, isKept: boolean): Promise<void> {
    await this.session.endTrial(trial, isKept);
    this.canvas.shown.sketching = null;
    this.canvas.redraw();
  }
}
