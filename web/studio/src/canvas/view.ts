// View: which part of the plane the canvas shows, and how far it is zoomed.
import type { Point } from "./frames";

export interface Box { left: number; bottom: number; right: number; top: number }
export interface Insets { left: number; top: number; right: number; bottom: number } // px that panels cover

const STEPS = [1, 2, 5, 10];

export class View {
  scale = 2000; // px per metre
  width = 1;
  height = 1;
  private centre: [number, number] = [0.1, 0.05]; // m, in the middle of the canvas

  toScreen([x, y]: Point): [number, number] {
    return [this.width / 2 + this.scale * (x - this.centre[0]), this.height / 2 - this.scale * (y - this.centre[1])];
  }

  toWorld([x, y]: Point): [number, number] {
    return [this.centre[0] + (x - this.width / 2) / this.scale, this.centre[1] - (y - this.height / 2) / this.scale];
  }

  // Two views with one key show the same part of the plane.
  get key(): string {
    return [this.scale, ...this.centre, this.width, this.height].join(" ");
  }

  resize(width: number, height: number): void {
    [this.width, this.height] = [Math.max(1, width), Math.max(1, height)];
  }

  pan(dx: number, dy: number): void {
    this.centre = [this.centre[0] - dx / this.scale, this.centre[1] + dy / this.scale];
  }

  // Zooms by a factor about a place on the screen, which stays where it is.
  zoom(factor: number, at: Point): void {
    const before = this.toWorld(at);
    this.scale = Math.min(1e9, Math.max(1e-3, this.scale * factor));
    const after = this.toWorld(at);
    this.centre = [this.centre[0] + before[0] - after[0], this.centre[1] + before[1] - after[1]];
  }

  fit(box: Box, insets: Insets): void {
    const wide = Math.max(40, this.width - insets.left - insets.right), high = Math.max(40, this.height - insets.top - insets.bottom);
    const breadth = Math.max(box.right - box.left, 1e-9), height = Math.max(box.top - box.bottom, 1e-9);
    this.scale = Math.min(wide / breadth, high / height, 1e9);
    const dx = (insets.left - insets.right) / 2 / this.scale, dy = (insets.top - insets.bottom) / 2 / this.scale;
    this.centre = [(box.left + box.right) / 2 - dx, (box.top + box.bottom) / 2 + dy];
  }

  // Returns the distance between lines of the grid, m: 1, 2 or 5 by a power of ten of the unit, at least `pixels` apart.
  gridStep(unit: number, pixels: number): number {
    const least = pixels / this.scale / unit, power = Math.pow(10, Math.floor(Math.log10(least)));
    return unit * power * (STEPS.find((step) => step * power >= least * (1 - 1e-9)) ?? 10);
  }
}
