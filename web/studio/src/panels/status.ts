// The line of words: what was just said, how many problems the file has, and questions that need a choice.
import { byId, el, fill } from "../dom";
import type { Editor } from "../editor/editor";
import type { Session } from "../session";
import { mendOf, spanOf } from "../editor/problems";
import { words } from "../words";

export class Status {
  private said = byId("said");
  private problems = byId("problems");
  private question = byId("question");
  private timer = 0;

  constructor(private session: Session, private editor: Editor) {
    session.on("said", (text) => this.say(text));
    session.on("lost", (text) => this.say(text));
    session.on("opened", () => this.list());
  }

  private say(text: string): void {
    window.clearTimeout(this.timer);
    if (text) this.said.textContent = text;
    this.said.classList.toggle("shown", text !== "");
    if (text) this.timer = window.setTimeout(() => this.said.classList.remove("shown"), 9000);
  }

  // Problems, each with a way to its place and, where the hint needs no choice, a mend.
  private list(): void {
    const all = this.session.text.trim() ? this.session.opened?.problems ?? [] : [], worst = all.filter((one) => one.severity === "error"), shown = (worst.length ? worst : all.filter((one) => one.severity === "warning")).slice(0, 3);
    this.problems.hidden = shown.length === 0;
    fill(this.problems, worst.length > shown.length && el("b", {}, words.editor.problems(worst.length)), ...shown.map((problem) => {
      const mend = mendOf(problem.hint), { doc } = this.editor.view.state;
      return el("div", { class: `problem ${problem.severity}` },
        el("button", { class: "problem-text", title: problem.hint ?? "", onclick: () => this.goTo(problem.line ? spanOf(problem, doc) : { from: 0, to: 0 }) }, problem.line ? `${problem.line}: ${problem.message}` : problem.message),
        problem.hint && el("span", { class: "problem-hint" }, problem.hint),
        mend && el("button", { class: "small", onclick: () => this.session.write(mend.apply(this.session.text, spanOf(problem, this.editor.view.state.doc))) }, mend.label));
    }));
  }

  private goTo({ from, to }: { from: number; to: number }): void {
    byId("tab-text").click();
    this.editor.select(from, to);
  }

  ask(text: string, choices: [string, () => void][]): void {
    this.question.hidden = false;
    fill(this.question, el("span", {}, text), ...choices.map(([name, action]) => el("button", { class: "small", onclick: () => { this.question.hidden = true; action(); } }, name)));
  }
}
