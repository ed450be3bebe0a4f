// What the drawing shows besides the machine: a checkbox for every path, and for the arrows.
import { Arrows } from "./arrows";
import { Data } from "./data";

function tick(set: HTMLFieldSetElement, name: string, checked: boolean, changed: (checked: boolean) => void): void {
  const label = document.createElement("label"), box = document.createElement("input");
  box.type = "checkbox";
  box.checked = checked;
  box.addEventListener("change", () => changed(box.checked));
  label.append(box, name);
  set.append(label);
}

function fieldset(bar: HTMLElement, name: string): HTMLFieldSetElement {
  const set = document.createElement("fieldset"), legend = document.createElement("legend");
  legend.textContent = name;
  set.append(legend);
  bar.append(set);
  bar.hidden = false;
  return set;
}

export function addShows(data: Data, svg: SVGSVGElement, arrows: Record<string, Arrows>, at: () => number): void {
  const bar = document.getElementById("shows")!;
  if (data.points!.length > 0) {
    const set = fieldset(bar, "Paths");
    for (const { name, point, shown } of data.points!)
      tick(set, name, shown, (checked) => svg.querySelector(".t" + point)?.classList.toggle("off", !checked));
  }
  const known = Object.entries(arrows).filter(([, all]) => all.count > 0);
  if (known.length === 0) return;
  const set = fieldset(bar, "Arrows");
  for (const [name, all] of known) tick(set, name, false, (checked) => all.toggle(checked, at()));
}
