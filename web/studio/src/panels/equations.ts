// Equations of the machine as the command derives them, and a line that proves or refutes a typed one.
import { byId, el, fill } from "../dom";
import { formulas } from "../markup";
import type { Session } from "../session";
import { words } from "../words";

const FILE = "machine.yaml";

export class Equations {
  private what = el("select", { "aria-label": words.equations.what }, ...words.equations.list.map(([value, text]) => el("option", { value }, text)));
  private page = el("div", { class: "formulas", role: "region", "aria-label": words.tabs.equations, tabindex: "0" });
  private line = el("input", { type: "text", placeholder: words.equations.check, "aria-label": words.equations.check, spellcheck: "false", autocomplete: "off" });
  private verdict = el("pre", { class: "verdict", role: "status" });
  private isShown = false;
  private shown = "";
  private timer = 0;

  constructor(private session: Session) {
    fill(byId("panel-equations"), el("form", { class: "row", onsubmit: (event: Event) => { event.preventDefault(); void this.check(); } }, this.line, el("button", { class: "small" }, words.equations.checkIt)),
      this.verdict, el("div", { class: "row" }, el("label", {}, words.equations.what, " ", this.what)), this.page);
    this.what.addEventListener("change", () => void this.draw());
    session.on("text", () => { window.clearTimeout(this.timer); this.timer = window.setTimeout(() => void this.draw(), 600); });
  }

  set visible(isShown: boolean) {
    this.isShown = isShown;
    if (isShown) void this.draw();
  }

  private async draw(): Promise<void> {
    const { session } = this, text = session.text, key = this.what.value + text;
    if (!this.isShown || key === this.shown || !text.trim()) return;
    this.page.setAttribute("aria-busy", "true");
    if (!this.shown) fill(this.page, el("p", { class: "hint" }, words.equations.wait));
    const reply = await session.ask(() => session.core.run(["derive", FILE, "--what", this.what.value, "--format", "mathml", "--quiet"], { [FILE]: text }));
    this.page.removeAttribute("aria-busy");
    if (!reply || text !== session.text) return;
    this.shown = key;
    fill(this.page);
    if (reply.exit === 0) this.page.append(formulas(reply.out));
    else fill(this.page, el("pre", {}, reply.err || words.say.noAnswer));
    this.page.querySelector("h1")?.remove();
  }

  private async check(): Promise<void> {
    const { session } = this, equation = this.line.value.trim();
    if (!equation) return;
    this.verdict.className = "verdict";
    this.verdict.textContent = words.command.wait;
    const reply = await session.ask(() => session.core.run(["derive", FILE, "--check", equation, "--quiet"], { [FILE]: session.text }));
    if (!reply) return;
    this.verdict.classList.add(reply.exit === 0 ? "true" : reply.exit === 1 ? "false" : "unknown");
    this.verdict.textContent = (reply.out + reply.err).trim();
  }
}
