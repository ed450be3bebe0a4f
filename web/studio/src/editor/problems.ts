// The core's problems as marks in the text, and its hints as mends that a click applies.
import type { Action, Diagnostic } from "@codemirror/lint";
import type { Text } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";
import type { Problem } from "../../../core/door";
import { Source, written } from "../document/source";
import type { Session } from "../session";
import { words } from "../words";

// Returns the place of a line and column of the core in the editor's text; the core counts bytes of UTF-8.
function offset(doc: Text, line: number, column: number): number {
  const row = doc.line(Math.min(Math.max(1, line), doc.lines));
  let bytes = 1, at = 0;
  for (const letter of row.text) {
    if (bytes >= column) break;
    const code = letter.codePointAt(0)!;
    bytes += code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    at += letter.length;
  }
  return row.from + at;
}

export function spanOf(problem: Problem, doc: Text): { from: number; to: number } {
  if (problem.line < 1) return { from: 0, to: 0 };
  const from = offset(doc, problem.line, problem.column), row = doc.lineAt(from);
  if (problem.endColumn && problem.endColumn > problem.column) return { from, to: offset(doc, problem.line, problem.endColumn) };
  const word = row.text.slice(from - row.from).match(/^[^\s,:{}[\]]+/);
  return { from, to: Math.min(row.to, from + (word?.[0].length ?? 1)) };
}

export interface Mend { label: string; apply(text: string, span: { from: number; to: number }): string }

// Returns what a hint offers that needs no further decision.
export function mendOf(hint: string | undefined): Mend | null {
  if (!hint) return null;
  const replaced = hint.match(/^did you mean `([^`]+)`\?/) ?? hint.match(/^write `([^`]+)`$/);
  if (replaced) {
    const word = replaced[1];
    return { label: words.editor.replace(word), apply: (text, { from, to }) => text.slice(0, from) + word + text.slice(to) };
  }
  const point = hint.match(/^add `([^`:]+): (\[[^`\]]*\])` to the points of `([^`]+)`/);
  if (point) return { label: words.editor.addPoint(point[1], point[3]), apply: (text) => new Source(text).set(["bodies", point[3], "points", point[1]], point[2]).text };
  const joint = hint.match(/^name it at the joint by/);
  if (joint) return null;
  const list = hint.match(/^add `(start|drives): \{([^`:{}]+): ([^`{}]+)\}`/);
  if (list) return { label: words.editor.add(`${list[1]}: ${list[2]}`), apply: (text) => new Source(text).set([list[1], list[2]], written(list[3])).text };
  return null;
}

export function diagnosticsOf(problems: Problem[], view: EditorView, session: Session): Diagnostic[] {
  const { doc } = view.state;
  return problems.filter((one) => one.line > 0).map((problem): Diagnostic => {
    const { from, to } = spanOf(problem, doc), mend = mendOf(problem.hint), actions: Action[] = [];
    if (mend) actions.push({ name: mend.label, apply: (editor, a, b) => session.write(mend.apply(editor.state.doc.toString(), { from: a, to: b })) });
    return {
      from, to: Math.max(from, to), severity: problem.severity === "note" ? "info" : problem.severity,
      message: problem.hint ? `${problem.message}\n${problem.hint}` : problem.message, source: problem.code, actions,
    };
  }).sort((a, b) => a.from - b.from);
}
