// The parts that the machine lacks, in the core's words; a click supplies those that leave no choice.
import type { Lack } from "../../../core/door";
import { byId, el, fill } from "../dom";
import type { Session } from "../session";
import { words } from "../words";

export class Lacks {
  private isOpen = false;
  private list = byId("lacks");

  constructor(private session: Session) {
    session.on("opened", () => this.draw());
  }

  private draw(): void {
    const { opened, isCurrent } = this.session;
    const all = isCurrent && opened ? [...opened.lacks].sort((a, b) => Number(a.optional) - Number(b.optional)) : [];
    const needed = all.filter((lack) => !lack.optional), shown = this.isOpen ? all : needed.slice(0, 2), hidden = all.length - shown.length;
    const isEmpty = !this.session.machine?.bodies.some((body) => !body.ground);
    this.list.hidden = all.length === 0 || isEmpty;
    fill(this.list, ...shown.map((lack) => this.line(lack)),
      (hidden > 0 || this.isOpen) && el("button", { class: "quiet", "aria-expanded": String(this.isOpen), onclick: () => { this.isOpen = !this.isOpen; this.draw(); } },
        this.isOpen ? words.lacks.fewer : (shown.length ? words.lacks.more : words.lacks.suggestions)(hidden)));
  }

  private line(lack: Lack): HTMLElement {
    const text = el("button", { class: "lack-text", title: lack.mend, onclick: () => this.point(lack) }, lack.text);
    const mend = this.mender(lack);
    return el("div", { class: lack.optional ? "lack optional" : "lack" }, text,
      mend && el("button", { class: "small", title: lack.mend, "aria-label": `${words.lacks.mend}: ${lack.mend}`, onclick: mend }, words.lacks.mend));
  }

  // Shows the part that is meant.
  private point(lack: Lack): void {
    const { machine } = this.session, coordinate = machine?.coordinates.find((one) => one.name === lack.coordinate);
    if (coordinate) this.session.select({ kind: "joint", joint: coordinate.joint });
    else if (lack.body && lack.point) this.session.select({ kind: "point", body: lack.body, point: lack.point });
    else if (lack.body) this.session.select({ kind: "body", body: lack.body });
    this.session.emit("said", lack.mend);
  }

  private mender(lack: Lack): (() => void) | null {
    const { session } = this, coordinate = session.machine?.coordinates.find((one) => one.name === lack.coordinate);
    if (lack.kind === "drive" && coordinate) {
      const value = session.start?.coordinates[session.machine!.coordinates.indexOf(coordinate)] ?? coordinate.value;
      return () => void session.edit((draft) => draft.drive({ ...coordinate, value }));
    }
    if (lack.path && lack.value) return () => void session.edit((draft) => { draft.source = draft.source.set(lack.path!.split("/"), lack.value!); });
    return null;
  }
}
