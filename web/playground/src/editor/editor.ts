// The editor: CodeMirror, helped by the interpreter.

import { closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, indentService, indentUnit } from "@codemirror/language";
import { type Diagnostic, lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState, type Extension, Prec } from "@codemirror/state";
import {
  crosshairCursor,
  drawSelection,
  dropCursor,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  highlightSpecialChars,
  keymap,
  lineNumbers,
  rectangularSelection,
} from "@codemirror/view";
import type { State } from "../../../src/door/door";
import { el } from "../../../src/panels/dom";
import { completion } from "./completion";
import { definition, hover, signature } from "./help";
import { notes, putNotes } from "./notes";
import { type Ask, changesOf, type Edit, type Finding, offsetsOf } from "./places";
import { tokens } from "./tokens";

export class Editor {
  readonly view: EditorView;

  /** `changed` is called after each change of the text. */
  constructor(
    host: HTMLElement,
    private readonly ask: Ask,
    private readonly changed: (text: string) => void,
  ) {
    this.view = new EditorView({ parent: host, state: this.begin("") });
  }

  get text(): string {
    return this.view.state.doc.toString();
  }

  /** Takes another script: what was done to the one before cannot be undone any more. */
  open(text: string): void {
    this.view.setState(this.begin(text));
    this.view.focus();
  }

  /** Puts a text in the place of the present one, as an edit that can be undone. */
  replace(text: string): void {
    const { doc } = this.view.state;
    const old = doc.toString();
    const next = EditorState.create({ doc: text }).doc.toString();
    const most = Math.min(old.length, next.length);
    let from = 0;
    while (from < most && old[from] === next[from]) from++;
    let n_last = 0;
    while (n_last < most - from && old[old.length - 1 - n_last] === next[next.length - 1 - n_last]) n_last++;
    this.view.dispatch({ changes: { from, to: old.length - n_last, insert: next.slice(from, next.length - n_last) } });
  }

  /** Brings the text into the form of `virote fmt`; tells whether it had another. */
  async format(): Promise<boolean> {
    const { doc } = this.view.state;
    const edits = await this.ask<Edit[]>(doc.toString(), { call: "format" });
    if (!edits || edits.length === 0 || this.view.state.doc !== doc) return false;
    this.view.dispatch({ changes: changesOf(doc, edits), userEvent: "format" });
    return true;
  }

  /** Marks what was found in a text and what it came to, if it still stands here. */
  mark(text: string, findings: Finding[], result: State | null): void {
    const { state } = this.view;
    const { doc } = state;
    if (doc.toString() !== text) return;
    if (result) putNotes(this.view, result);
    const marked = findings.map((finding): Diagnostic => {
      const { from, to } = offsetsOf(doc, finding.range);
      const actions = finding.fixes.map(({ title, edits }) => ({
        name: title,
        apply: (view: EditorView) => {
          if (view.state.doc === doc) view.dispatch({ changes: changesOf(doc, edits) });
        },
      }));
      const message = `${finding.code}: ${finding.text}`;
      return { from, to, severity: finding.severity, message, actions, renderMessage: () => el("span", { class: "finding-text" }, message) };
    });
    this.view.dispatch(setDiagnostics(this.view.state, marked));
  }

  /** Shows a place without taking the keyboard. */
  reveal(line: number, column: number): void {
    const { doc } = this.view.state;
    if (line > doc.lines) return;
    const at = Math.min(doc.line(line).from + column - 1, doc.line(line).to);
    this.view.dispatch({ selection: { anchor: at }, effects: EditorView.scrollIntoView(at, { y: "nearest", yMargin: 60 }) });
  }

  private begin(doc: string): EditorState {
    return EditorState.create({ doc, extensions: this.extensions() });
  }

  private extensions(): Extension {
    const { ask } = this;
    return [
      lineNumbers(),
      lintGutter(),
      highlightActiveLineGutter(),
      highlightSpecialChars(),
      history(),
      drawSelection(),
      dropCursor(),
      EditorState.allowMultipleSelections.of(true),
      EditorState.languageData.of(() => [{ commentTokens: { line: "//", block: { open: "/*", close: "*/" } }, closeBrackets: { brackets: ["(", "[", "{", '"'] } }]),
      indentUnit.of("    "),
      indented,
      EditorView.lineWrapping,
      EditorView.contentAttributes.of({ "aria-label": "The script", spellcheck: "false", autocorrect: "off", autocapitalize: "off" }),
      bracketMatching(),
      closeBrackets(),
      rectangularSelection(),
      crosshairCursor(),
      highlightActiveLine(),
      highlightSelectionMatches(),
      tokens(ask),
      notes,
      completion(ask),
      hover(ask),
      Prec.low(signature(ask)),
      definition(ask),
      keymap.of([{ key: "Shift-Alt-f", run: () => (void this.format(), true) }]),
      // Evaluating again belongs to the page.
      keymap.of([...closeBracketsKeymap, ...defaultKeymap.filter(({ key }) => key !== "Mod-Enter"), ...searchKeymap, ...historyKeymap, ...completionKeymap, ...lintKeymap, indentWithTab]),
      EditorView.updateListener.of((update) => {
        if (update.docChanged) this.changed(this.text);
      }),
    ];
  }
}

/** A new line begins where the one before does, or further in behind an open bracket. */
const indented = indentService.of((context, at) => {
  if (context.simulatedBreak !== at) return null;
  const { text } = context.lineAt(at, -1);
  return /^ */.exec(text)![0].length + (/[([{]\s*$/.test(text) ? context.unit : 0);
});
