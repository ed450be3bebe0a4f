// The command itself: forces, tables, gears, cams and all else that `yoke` answers, about the machine in its present state.
import { byId, el, fill } from "../dom";
import { download } from "../keep/files";
import type { Session } from "../session";
import { words } from "../words";

const FILE = "machine.yaml";

// Splits a line into words as a shell does with blanks and quotes.
export function split(line: string): string[] {
  return Array.from(line.matchAll(/'([^']*)'|"([^"]*)"|(\S+)/g), (found) => found[1] ?? found[2] ?? found[3]);
}

export class Command {
  private line = el("input", { type: "text", value: "solve FILE", "aria-label": words.command.label, title: words.command.hint, spellcheck: "false", autocomplete: "off", autocapitalize: "off" });
  private end = el("button", { class: "quiet", type: "button", hidden: true, onclick: () => this.session.core.stop() }, words.design.stop);
  private out = el("pre", { class: "answer", role: "region", "aria-label": words.command.out, tabindex: "0" });

  constructor(private session: Session) {
    const choose = (line: string) => { this.line.value = line; void this.run(); };
    fill(byId("panel-command"), el("form", { class: "row command", onsubmit: (event: Event) => { event.preventDefault(); void this.run(); } }, el("span", { "aria-hidden": "true" }, "yoke"), this.line, el("button", { class: "small" }, words.command.run), this.end),
      el("div", { class: "row wrap" }, ...words.command.list.map(([name, line]) => el("button", { class: "quiet", title: `yoke ${line}`, onclick: () => choose(line) }, name))), this.out);
  }

  private async run(): Promise<void> {
    const { session } = this, list = split(this.line.value.trim().replace(/^yoke\s+/, "")).map((word) => (word === "FILE" ? FILE : word));
    if (!list.length) return;
    this.out.setAttribute("aria-busy", "true");
    this.out.textContent = words.command.wait;
    this.end.hidden = false;
    const reply = await session.ask(() => session.core.run(list, { [FILE]: session.text }));
    this.out.removeAttribute("aria-busy");
    this.end.hidden = true;
    const told = reply ? [reply.out, reply.err, reply.complete ? "" : words.command.stopped].map((part) => part.trimEnd()).filter(Boolean).join("\n\n") : words.say.noAnswer;
    this.out.textContent = told;
    for (const [name, bytes] of Object.entries(reply?.files ?? {})) if (name !== FILE) download(name, bytes);
  }
}
