// The scene: the core's drawing of the machine. Each body is one group, whose transform is its pose; what spans bodies
// comes from the core again with each pose.
import type { Pose } from "../../../core/door";
import { fill, svg } from "../dom";
import { picture, pieces } from "../markup";
import type { Session } from "../session";
import type { Box, View } from "./view";

const DEGREES = 180 / Math.PI;
const BORDER = 44; // px round the machine in the drawing that need not be seen

export class Scene {
  private bodies = svg("g", { id: "scene" });
  private parts = svg("g", { class: "parts" });
  private others = svg("g", { id: "ghosts" });
  readonly group = svg("g", {}, this.others, this.bodies, this.parts);
  onGhost: (index: number) => void = () => {};
  private shown: string | null = null;
  private pose: Pose | null = null;
  private groups: { element: Element; index: number }[] = [];
  private perMetre = 1; // px of the drawing
  private origin = [0, 0];
  private size = [0, 0];

  constructor(private session: Session) {}

  // Takes in the drawing of the machine that the session has.
  mount(): void {
    const { scene, machine, isCurrent } = this.session;
    this.group.classList.toggle("stale", !isCurrent);
    if (scene === this.shown) return;
    this.shown = scene;
    this.pose = null;
    this.ghosts([]);
    this.groups = [];
    fill(this.bodies);
    fill(this.parts);
    const root = scene ? picture(scene) : null;
    if (!root || !machine) return;
    this.perMetre = Number(root.getAttribute("data-scale")) || 1;
    this.origin = (root.getAttribute("data-origin") ?? "0 0").split(" ").map(Number);
    this.size = (root.getAttribute("viewBox") ?? "0 0 0 0").split(" ").slice(2).map(Number);
    for (const name of ["font-family", "font-size"]) this.group.setAttribute(name, root.getAttribute(name) ?? "");
    root.querySelector(":scope > title")?.remove();
    this.bodies.append(...Array.from(root.childNodes));
    this.groups = this.groupsOf(this.bodies);
  }

  private groupsOf(parent: Element): { element: Element; index: number }[] {
    const order = new Map(this.session.machine!.bodies.map((body, index) => [body.name, index]));
    return Array.from(parent.querySelectorAll("[data-body]"), (element) => ({ element, index: order.get(element.getAttribute("data-body")!) ?? -1 }))
      .filter((one) => one.index >= 0 && !this.session.machine!.bodies[one.index].ground);
  }

  // Returns where the drawing of the machine lies, m.
  get box(): Box | null {
    if (!this.shown || !this.groups.length) return null;
    const [x, y] = this.origin, [wide, high] = this.size, k = this.perMetre, border = Math.min(BORDER, wide / 3, high / 3);
    return { left: (border - x) / k, right: (wide - border - x) / k, top: (y - border) / k, bottom: (y - high + border) / k };
  }

  draw(view: View): void {
    const { pose } = this.session, zoom = view.scale / this.perMetre, [x, y] = view.toScreen([0, 0]);
    this.group.setAttribute("transform", `translate(${x - zoom * this.origin[0]} ${y - zoom * this.origin[1]}) scale(${zoom})`);
    if (!pose || pose === this.pose) return;
    this.pose = pose;
    place(this.groups, pose);
    fill(this.parts);
    this.parts.append(pieces(pose.parts));
  }

  get hasGhosts(): boolean {
    return this.others.childElementCount > 0;
  }

  // Shows the machine in other poses, each to be chosen with a click.
  ghosts(poses: Pose[]): void {
    fill(this.others, ...poses.map((pose, index) => {
      const copy = this.bodies.cloneNode(true) as SVGGElement, ghost = svg("g", { class: "ghost", onclick: () => this.onGhost(index) }, copy);
      copy.removeAttribute("id");
      place(this.groupsOf(copy), pose);
      return ghost;
    }));
  }
}

function place(groups: { element: Element; index: number }[], pose: Pose): void {
  for (const { element, index } of groups) {
    const [x, y, angle] = pose.bodies.subarray(3 * index, 3 * index + 3);
    if (Number.isFinite(x + y + angle)) element.setAttribute("transform", `translate(${x} ${y}) rotate(${angle * DEGREES})`);
  }
}
