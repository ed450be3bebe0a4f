// The canvas: the core's drawing between the grid and Studio's marks, in one view.
import { byId, eachFrame, svg } from "../dom";
import { unitsOf } from "../document/numbers";
import type { Units } from "../document/numbers";
import { Source } from "../document/source";
import type { Session } from "../session";
import { Arrows } from "./arrows";
import { Grid } from "./grid";
import { Overlay } from "./overlay";
import type { Shown } from "./overlay";
import { Scene } from "./scene";
import { corners } from "./snap";
import { View } from "./view";
import type { Box, Insets } from "./view";

export class Canvas {
  readonly view = new View();
  readonly grid = new Grid();
  readonly scene: Scene;
  readonly overlay: Overlay;
  readonly arrows: Arrows;
  readonly shown: Shown = { hover: null, crosshair: null, sketching: null, pull: null, tool: "select" };
  units: Units = { length: "mm", metre: 1e-3, angle: "deg" };
  insets: Insets = { left: 40, top: 60, right: 40, bottom: 90 };
  private isFitted = false;
  private isMoved = false; // by hand since it was fitted: then it stays where the hand put it
  private looked = 0; // the scale for which the scene was drawn
  private timer = 0;
  readonly redraw = eachFrame(() => this.draw());

  constructor(readonly root: SVGSVGElement, private session: Session) {
    this.scene = new Scene(session);
    this.overlay = new Overlay(session, this.view);
    this.arrows = new Arrows(session, this.view, () => this.redraw());
    document.querySelector("#backdrop")!.append(this.grid.group);
    root.append(svg("g", {}, this.scene.group, this.arrows.group, this.overlay.group));
    new ResizeObserver(() => {
      const box = root.getBoundingClientRect(), isFirst = this.view.width <= 1;
      this.view.resize(box.width, box.height);
      if (!this.isFitted || isFirst || !this.isMoved) this.fit();
      this.redraw();
    }).observe(root);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.recolour());
    session.on("scene", () => { this.scene.mount(); this.redraw(); });
    session.on("opened", () => {
      if (session.text.trim() !== "") this.units = unitsOf(new Source(session.text));
      this.scene.mount();
      if (!this.isFitted && (session.machine || session.text.trim() === "")) this.fit();
      this.redraw();
    });
    session.on("pose", () => this.redraw());
    session.on("selection", () => this.redraw());
    session.on("wanted", () => this.redraw());
    session.on("posed", () => this.redraw());
    session.on("linked", () => this.redraw());
  }

  // Shows another machine: it is fitted into the canvas once it is there.
  begin(): void {
    this.isFitted = false;
    this.looked = 0;
    void this.session.ask(() => this.session.core.look(0)); // as large as it is: the view follows it
  }

  // The page went from day to night, or back.
  recolour(): void {
    this.scene.recolour();
    this.redraw();
  }

  get step(): number {
    return this.view.gridStep(this.units.metre, 14);
  }
  // The resolution of what is written, m: a tenth of a pixel or so, rounded to a decimal place.
  get resolution(): number {
    return Math.pow(10, Math.floor(Math.log10(0.5 / this.view.scale)));
  }

  fit(): void {
    const box = this.box();
    this.insets = this.covered();
    if (box && this.view.width > 1) {
      this.view.fit(box, this.insets);
      this.isFitted = true;
    } else if (!this.session.machine && this.view.width > 1) {
      this.view.fit({ left: -0.05, bottom: -0.04, right: 0.25, top: 0.16 }, this.insets);
      this.isFitted = true; // what is drawn from here on does not move the view
    }
    this.redraw();
    this.isMoved = false;
    this.sharpen();
  }

  // Returns the border that stays free: what floats over the canvas, and some room.
  private covered(): Insets {
    const { width, height } = this.view, isNarrow = width < 600, least = isNarrow ? 14 : 40;
    const stage = this.root.getBoundingClientRect(), [notes, motion] = ["notes", "motion"].map((id) => byId(id).getBoundingClientRect());
    const above = notes.height ? notes.bottom - stage.top : 0, below = motion.height ? stage.bottom - motion.top : 0;
    const [top, bottom] = isNarrow ? [20, 58] : [60, 80]; // also where nothing floats yet
    return { left: least, top: Math.min(height / 3, Math.max(top, above + 8)), right: isNarrow && height > width ? least : 60, bottom: Math.max(bottom, below + 8) };
  }

  // The view was moved by hand.
  onView(): void {
    this.isMoved = true;
    this.sharpen();
  }

  // After a zoom the core draws the scene anew, so that lines and names have the width of the screen.
  private sharpen(): void {
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      if (Math.abs(this.view.scale / this.looked - 1) < 0.01) return;
      this.looked = this.view.scale;
      void this.session.look(this.view.scale);
    }, 120);
  }

  private box(): Box | null {
    const drawn = this.scene.box, places = corners(this.session).map((corner) => corner.world);
    if (drawn) places.push([drawn.left, drawn.bottom], [drawn.right, drawn.top]);
    if (!places.length) return null;
    const xs = places.map((place) => place[0]), ys = places.map((place) => place[1]);
    const box = { left: Math.min(...xs), right: Math.max(...xs), bottom: Math.min(...ys), top: Math.max(...ys) };
    const size = Math.max(box.right - box.left, box.top - box.bottom) || 0.1, room = drawn ? 0 : 0.08 * size;
    return { left: box.left - room, right: box.right + room, bottom: box.bottom - room, top: box.top + room };
  }

  private draw(): void {
    this.grid.draw(this.view, this.units.metre);
    this.scene.draw(this.view);
    this.arrows.draw();
    this.overlay.draw(this.shown);
  }
}
