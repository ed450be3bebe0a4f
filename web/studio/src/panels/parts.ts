// Parts: what is selected, read from the file and changed in it; parameters with sliders; the list of all parts.
import type { Parameter } from "../../../core/door";
import { byId, el, fill } from "../dom";
import { decimal } from "../document/numbers";
import { Source, written } from "../document/source";
import type { Editor } from "../editor/editor";
import type { Session } from "../session";
import { words } from "../words";

type Path = string[];

export class Parts {
  private chosen = el("section", { class: "chosen-part", "aria-live": "polite" });
  private sliders = el("section", { class: "sliders" });
  private list = el("section", { class: "all-parts" });
  private isSliding = false;
  private kept = ""; // names and texts of the sliders shown

  constructor(private session: Session, private editor: Editor) {
    fill(byId("panel-parts"), this.chosen, this.sliders, this.list);
    session.on("opened", () => { this.drawSliders(); this.drawChosen(); this.drawList(); });
    session.on("selection", () => { this.drawChosen(); this.drawList(); });
  }

  // --- what is selected

  private drawChosen(): void {
    const { selection, machine } = this.session;
    if (this.chosen.contains(document.activeElement) && document.activeElement instanceof HTMLInputElement) return;
    if (!machine || !selection) return fill(this.chosen, machine && el("p", { class: "hint" }, words.parts.nothing));
    const source = new Source(this.session.text);
    if (selection.kind === "joint") {
      const driven = machine.coordinates.filter((one) => one.joint === selection.joint && source.has(["drives", one.name]));
      return this.form(words.parts.joint, selection.joint, source, ["joints", selection.joint], driven.map((one) => ["drives", one.name]));
    }
    if (selection.kind === "point") return this.form(words.parts.point, `${selection.body}.${selection.point}`, source, ["bodies", selection.body, "points", selection.point], []);
    this.form(words.parts.body, selection.body, source, ["bodies", selection.body], source.keys(["bodies", selection.body, "points"]).map((name) => ["bodies", selection.body, "points", name]));
  }

  private form(kind: string, name: string, source: Source, path: Path, more: Path[]): void {
    const keys = source.keys(path).filter((key) => key !== "points"), fields = keys.length ? keys.map((key) => [...path, key]) : source.has(path) && path.length > 2 ? [path] : [];
    const place = source.place(path);
    fill(this.chosen, el("header", {}, el("span", { class: "kind" }, kind), el("h2", {}, name)),
      ...fields.map((field) => this.field(source, field, name)), ...more.map((field) => this.field(source, field, name, field[0] === "drives" ? words.parts.drive : undefined)),
      el("div", { class: "row" }, place && el("button", { class: "quiet", onclick: () => this.editor.select(place.from, place.to) }, words.parts.show),
        name !== "ground" && el("button", { class: "quiet danger", onclick: () => void this.remove() }, words.parts.remove)));
  }

  private field(source: Source, path: Path, name: string, label?: string): HTMLElement {
    const key = path[path.length - 1], value = source.value(path) ?? "", text = label ? `${label} ${key}` : key;
    const input = el("input", { type: "text", value, spellcheck: "false", "aria-label": words.parts.of(text, name), autocomplete: "off" });
    const commit = () => { if (input.value !== value) void this.session.edit((draft) => { draft.source = draft.source.set(path, yamlOf(input.value)); }); };
    input.addEventListener("change", commit);
    input.addEventListener("keydown", (event) => { if (event.key === "Enter") input.blur(); });
    return el("label", { class: "field" }, el("span", {}, text), input);
  }

  async remove(): Promise<void> {
    const { selection } = this.session;
    if (!selection) return;
    this.session.select(null);
    await this.session.edit((draft) => {
      if (selection.kind === "joint") draft.removeJoint(selection.joint);
      else if (selection.kind === "point") draft.removePoint(selection.body, selection.point);
      else if (selection.body !== "ground") draft.removeBody(selection.body);
    });
  }

  // --- parameters

  private drawSliders(): void {
    const parameters = this.session.machine?.parameters ?? [], kept = JSON.stringify(parameters.map(({ name, text }) => [name, text]));
    if (this.isSliding || (kept === this.kept && this.sliders.childElementCount)) return;
    this.kept = kept;
    fill(this.sliders, el("h2", {}, words.parts.parameters), !parameters.length && el("p", { class: "hint" }, words.parts.noParameters),
      ...parameters.map((one) => this.slider(one)), this.session.machine && this.adder());
  }

  // A slider goes from nothing to twice the number, in the number's own unit. Expressions have none.
  private slider(parameter: Parameter): HTMLElement {
    const { name } = parameter, written = new Source(this.session.text).value(["parameters", name]) ?? parameter.text;
    const found = written.match(/^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)(\s*[^\d\s*+/^()-][^*+/()]*)?$/i), number = found ? Number(found[1]) : 0;
    const text = el("input", { type: "text", value: written, "aria-label": words.parts.of(words.parts.value, name), spellcheck: "false", autocomplete: "off" });
    const set = (value: string) => void this.session.edit((draft) => { draft.source = draft.source.set(["parameters", name], value); });
    text.addEventListener("change", () => set(yamlOf(text.value)));
    const head = el("div", { class: "slider-head" }, el("span", { class: "name" }, name), text);
    if (!found || number === 0 || !Number.isFinite(parameter.value)) return el("div", { class: "slider" }, head);
    const step = Math.pow(10, Math.floor(Math.log10(Math.abs(number))) - 2), unit = found[2] ?? "", factor = parameter.value / number;
    const range = el("input", { type: "range", min: Math.min(0, 2 * number), max: Math.max(0, 2 * number), step: "any", value: String(number), "aria-label": words.parts.slider(name) });
    range.setAttribute("aria-valuetext", written);
    const shown = () => decimal(Math.round(Number(range.value) / step) * step, step) + unit;
    range.addEventListener("input", () => {
      this.isSliding = true;
      text.value = shown();
      range.setAttribute("aria-valuetext", text.value);
      void this.session.preview(name, parseFloat(text.value) * factor);
    });
    range.addEventListener("change", () => { this.isSliding = false; set(shown()); });
    return el("div", { class: "slider" }, head, range);
  }

  private adder(): HTMLElement {
    const name = el("input", { type: "text", placeholder: "l1", "aria-label": words.parts.name, spellcheck: "false", autocomplete: "off" });
    const value = el("input", { type: "text", placeholder: "40 mm", "aria-label": words.parts.value, spellcheck: "false", autocomplete: "off" });
    return el("form", { class: "adder", onsubmit: (event: Event) => {
      event.preventDefault();
      if (/^[A-Za-z_]\w*$/.test(name.value) && value.value.trim()) void this.session.edit((draft) => { draft.source = draft.source.set(["parameters", name.value], yamlOf(value.value)); });
      else name.focus();
    } }, name, value, el("button", { class: "small" }, words.parts.addIt));
  }

  // --- all parts

  private drawList(): void {
    const { machine, selection } = this.session;
    if (!machine) return fill(this.list);
    const entry = (label: string, detail: string, chosen: boolean, select: () => void) =>
      el("li", {}, el("button", { class: "part", "aria-pressed": String(chosen), onclick: select }, el("b", {}, label), el("span", {}, detail)));
    fill(this.list, el("h2", {}, words.parts.list), el("p", { class: "hint" }, `${words.parts.counts(machine.bodies.filter((body) => !body.ground).length, machine.joints.length)}, ${words.parts.freedom(machine.freedom)}`),
      el("ul", {}, ...machine.bodies.map((body) => entry(body.name, body.points.map((point) => point.name).join(" "), selection?.kind === "body" && selection.body === body.name, () => this.session.select({ kind: "body", body: body.name }))),
        ...machine.joints.map((joint) => entry(joint.name, `${joint.kind}  ${joint.bodies.join(" – ")}`, selection?.kind === "joint" && selection.joint === joint.name, () => this.session.select({ kind: "joint", joint: joint.name })))));
  }
}

// Returns what was typed as YAML that stands between braces: lists and maps as they are, words quoted where they must be.
function yamlOf(typed: string): string {
  const text = typed.trim();
  if (/^[[{"']/.test(text)) return new Source(`k: ${text}`).isSound ? text : JSON.stringify(text);
  return text === "" ? '""' : written(text);
}
