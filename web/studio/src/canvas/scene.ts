// The scene: the core's drawing of the machine. Each body is one group, whose transform is its pose; what spans bodies
// comes from the core again with each pose. A machine of very many parts is painted on a sheet of pixels instead.
import type { Machine, Pose } from "../../../core/door";
import { byId, fill, svg } from "../dom";
import { picture, pieces } from "../markup";
import { AXES, axesOf, indexOf } from "./frames";
import { Painter } from "./painter";
import type { Session } from "../session";
import { words } from "../words";
import type { Box, View } from "./view";

const MOST = 1500; // groups that move: beyond these the scene is painted
const BORDER = 44; // px round the machine in the drawing that need not be seen

interface Group { element: SVGGElement; index: number; turn: SVGTransform }

export class Scene {
  private bodies = svg("g", { id: "scene" });
  private parts = svg("g", { class: "parts" });
  private others = svg("g", { id: "ghosts" });
  readonly group = svg("g", {}, this.others, this.bodies, this.parts);
  onGhost: (index: number) => void = () => {};
  private shown: string | null = null;
  private pose: Pose | null = null;
  private groups: Group[] = [];
  private painter: Painter | null = null; // of a machine of very many parts
  private axes = new Float64Array();
  private told = ""; // the machine of which it was said that it has very many parts
  private painted = ""; // the view that the sheet shows
  private probe = svg("circle", { visibility: "hidden" }); // shows which colour the page gives to one of the core's
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
    this.painter = null;
    this.painted = "";
    fill(this.bodies);
    fill(this.parts);
    fill(this.group, this.others, this.bodies, this.parts);
    const root = scene ? picture(scene) : null;
    if (!root || !machine) return;
    this.perMetre = Number(root.getAttribute("data-scale")) || 1;
    this.origin = (root.getAttribute("data-origin") ?? "0 0").split(" ").map(Number);
    this.size = (root.getAttribute("viewBox") ?? "0 0 0 0").split(" ").slice(2).map(Number);
    for (const name of ["font-family", "font-size"]) this.group.setAttribute(name, root.getAttribute(name) ?? "");
    root.querySelector(":scope > title")?.remove();
    this.axes = new Float64Array(AXES * (machine.bodies.length + 1));
    if (root.querySelectorAll("[data-body]").length > MOST) return this.take(root, machine);
    this.sheets(true);
    this.bodies.append(...Array.from(root.childNodes));
    this.groups = groupsOf(this.bodies, machine);
  }

  // Takes the drawing in as numbers, in the colours that the page has now.
  private take(root: SVGSVGElement, machine: Machine): void {
    const known = new Map<string, string>();
    this.bodies.append(this.probe);
    this.painter = new Painter(root, machine, this.perMetre, this.origin, true, (element, kind, value) => {
      const key = `${element.localName} ${kind} ${value}`;
      if (!known.has(key)) known.set(key, this.colourOf(element, kind, value));
      return known.get(key)!;
    });
    fill(this.bodies);
    this.sheets(false);
    const key = `${this.session.name} ${machine.bodies.length}`;
    if (key !== this.told) this.session.emit("said", words.say.many);
    this.told = key;
  }

  private sheets(areHidden: boolean): void {
    for (const id of ["sheet", "still-sheet"]) byId(id).hidden = areHidden;
  }

  private colourOf(element: Element, kind: string, value: string): string {
    const probe = element.localName === "circle" ? this.probe : svg("g", {});
    if (probe !== this.probe) this.bodies.append(probe);
    probe.setAttribute(kind, value);
    const colour = getComputedStyle(probe).getPropertyValue(kind);
    probe.removeAttribute(kind);
    return colour;
  }

  // Has the colours taken again: the page went from day to night.
  recolour(): void {
    if (!this.painter) return;
    this.shown = null;
    this.mount();
  }

  // Returns where the drawing of the machine lies, m.
  get box(): Box | null {
    if (!this.shown || !this.groups.length) return null;
    const [x, y] = this.origin, [wide, high] = this.size, k = this.perMetre, border = Math.min(BORDER, wide / 3, high / 3);
    return { left: (border - x) / k, right: (wide - border - x) / k, top: (y - border) / k, bottom: (y - high + border) / k };
  }

  draw(view: View): void {
    const { pose } = this.session, zoom = view.scale / this.perMetre, [x, y] = view.toScreen([0, 0]);
    const isMoved = view.key !== this.painted;
    if (isMoved) this.group.setAttribute("transform", `translate(${x - zoom * this.origin[0]} ${y - zoom * this.origin[1]}) scale(${zoom})`);
    this.painted = view.key;
    if (pose && this.painter && (isMoved || pose !== this.pose)) this.paint(view, pose, isMoved);
    if (!pose || pose === this.pose) return;
    this.pose = pose;
    axesOf(pose, this.axes);
    place(this.groups, this.axes);
    if (!pose.parts && !this.parts.firstChild) return;
    fill(this.parts);
    this.parts.append(pieces(pose.parts));
  }

  // Paints the pose on the sheet behind the marks, at the sharpness of the screen; the ground's own sheet only where the view moved.
  private paint(view: View, pose: Pose, isMoved: boolean): void {
    const sharp = devicePixelRatio || 1, [x, y] = view.toScreen([0, 0]), shot = { scale: sharp * view.scale, x: sharp * x, y: sharp * y };
    axesOf(pose, this.axes);
    if (isMoved) this.painter!.paint(cleared("still-sheet", sharp, view), shot, this.axes, true);
    this.painter!.paint(cleared("sheet", sharp, view), shot, this.axes);
  }

  get hasGhosts(): boolean {
    return this.others.childElementCount > 0;
  }

  // Shows the machine in other poses, each to be chosen with a click.
  ghosts(poses: Pose[]): void {
    fill(this.others, ...poses.map((pose, index) => {
      const copy = this.bodies.cloneNode(true) as SVGGElement, ghost = svg("g", { class: "ghost", onclick: () => this.onGhost(index) }, copy), axes = this.axes.slice();
      copy.removeAttribute("id");
      axesOf(pose, axes);
      place(groupsOf(copy, this.session.machine!), axes);
      return ghost;
    }));
  }
}

// Returns a clean sheet of the size of the view.
function cleared(id: string, sharp: number, view: View): CanvasRenderingContext2D {
  const sheet = byId<HTMLCanvasElement>(id), context = sheet.getContext("2d")!, [width, height] = [Math.round(sharp * view.width), Math.round(sharp * view.height)];
  if (sheet.width !== width || sheet.height !== height) [sheet.width, sheet.height] = [width, height];
  else context.clearRect(0, 0, width, height);
  return context;
}

function groupsOf(parent: SVGElement, machine: Machine): Group[] {
  return Array.from(parent.querySelectorAll<SVGGElement>("[data-body]"), (element) => ({ element, index: indexOf(machine, element.getAttribute("data-body")!), turn: element.transform.baseVal.consolidate()! }))
    .filter((one) => one.index >= 0 && !machine.bodies[one.index].ground);
}

const matrix = svg("svg").createSVGMatrix();
// Moves the groups: one matrix each, and no text.
function place(groups: Group[], axes: Float64Array): void {
  for (const { index, turn } of groups) {
    const at = AXES * index;
    [matrix.a, matrix.b, matrix.c, matrix.d, matrix.e, matrix.f] = [axes[at + 2], axes[at + 3], -axes[at + 3], axes[at + 2], axes[at], axes[at + 1]];
    turn.setMatrix(matrix);
  }
}
