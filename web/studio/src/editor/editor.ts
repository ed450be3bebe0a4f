// The editor: the machine's file, with its problems at their places. Its undo is the undo of everything.
import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab, isolateHistory, redo, redoDepth, undo, undoDepth } from "@codemirror/commands";
import { bracketMatching, HighlightStyle, indentUnit, syntaxHighlighting } from "@codemirror/language";
import { lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { EditorState } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { difference } from "../document/source";
import type { Session } from "../session";
import { words } from "../words";
import { complete } from "./complete";
import { yaml } from "./language";
import { diagnosticsOf } from "./problems";

const colours = HighlightStyle.define([
  { tag: [tags.propertyName, tags.definition(tags.propertyName)], color: "var(--code-key)" },
  { tag: [tags.string, tags.content], color: "var(--ink)" },
  { tag: [tags.number, tags.bool, tags.literal], color: "var(--code-value)" },
  { tag: tags.comment, color: "var(--ink-soft)", fontStyle: "italic" },
  { tag: [tags.punctuation, tags.separator, tags.squareBracket, tags.brace], color: "var(--ink-soft)" },
]);

export class Editor {
  readonly view: EditorView;

  constructor(parent: HTMLElement, private session: Session) {
    this.view = new EditorView({ parent, state: this.stateOf("") });
    session.write = (text) => this.replace(text);
    session.on("opened", ({ problems }) => this.view.dispatch(setDiagnostics(this.view.state, session.text.trim() ? diagnosticsOf(problems, this.view, session) : [])));
  }

  private stateOf(doc: string): EditorState {
    return EditorState.create({
      doc,
      extensions: [
        lineNumbers(), lintGutter(), history(), drawSelection(), highlightActiveLine(), bracketMatching(), closeBrackets(), yaml(),
        indentUnit.of("  "), EditorState.tabSize.of(2), syntaxHighlighting(colours),
        autocompletion({ override: [complete(() => this.session)], icons: false }),
        keymap.of([...closeBracketsKeymap, ...completionKeymap, ...lintKeymap, ...historyKeymap, ...defaultKeymap, indentWithTab]),
        EditorView.lineWrapping,
        EditorView.contentAttributes.of({ "aria-label": words.editor.label, tabindex: "0", spellcheck: "false", autocorrect: "off", autocapitalize: "off" }),
        EditorView.updateListener.of((update) => { if (update.docChanged) this.session.take(update.state.doc.toString()); }),
      ],
    });
  }

  // Starts with another file: its history begins here.
  load(text: string): void {
    this.view.setState(this.stateOf(text.replace(/\r\n?/g, "\n")));
    this.session.take(this.view.state.doc.toString());
  }

  // Puts a gesture's text there as one step of the history.
  replace(text: string): void {
    const change = difference(this.view.state.doc.toString(), text);
    if (change) this.view.dispatch({ changes: change, annotations: isolateHistory.of("full"), userEvent: "input.gesture" });
  }

  undo = (): boolean => undo(this.view);
  redo = (): boolean => redo(this.view);
  get canUndo(): boolean { return undoDepth(this.view.state) > 0; }
  get canRedo(): boolean { return redoDepth(this.view.state) > 0; }

  // Shows a place of the file, lines and columns from 1 (columns count bytes of UTF-8, as compilers do).
  goTo(line: number, column = 1): void {
    const { doc } = this.view.state, row = doc.line(Math.min(Math.max(1, line), doc.lines));
    this.select(Math.min(row.from + column - 1, row.to));
  }

  select(from: number, to = from): void {
    this.view.dispatch({ selection: { anchor: from, head: to }, effects: EditorView.scrollIntoView(from, { y: "center" }) });
    this.view.focus();
  }
}
