// What a script prints and whether its claims hold, behind their lines.

import { type Extension, StateEffect, StateField, type Text } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView, WidgetType } from "@codemirror/view";
import type { State } from "../../../src/door/door";
import { el } from "../../../src/panels/dom";

/** So many letters of a value stand behind its line; the panel has the rest. */
const LONGEST = 60;

type Kind = "print" | "pass" | "fail";

class Note extends WidgetType {
  constructor(
    readonly text: string,
    readonly kind: Kind,
  ) {
    super();
  }

  override eq(other: Note): boolean {
    return other.text === this.text && other.kind === this.kind;
  }

  override toDOM(): HTMLElement {
    return el("span", { class: `line-note note-${this.kind}` }, this.text);
  }
}

const put = StateEffect.define<DecorationSet>();

/** The notes that stand in the text; they move along with it. */
export const notes: Extension = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(put)) return effect.value;
    return value.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

function short(text: string): string {
  const [line] = text.split("\n");
  return line === text && text.length <= LONGEST ? text : `${line.slice(0, LONGEST)} …`;
}

/** The notes of a state, by the number of their line. */
function byLine({ prints, checks }: State): Map<number, [string[], Kind]> {
  const lines = new Map<number, [string[], Kind]>();
  const add = (line: number | null, text: string, kind: Kind): void => {
    if (line === null) return;
    const [texts, old] = lines.get(line) ?? [[], kind];
    lines.set(line, [[...texts, text], old === "fail" ? old : kind]);
  };
  for (const { value, line } of prints) if (value !== "") add(line, short(value), "print");
  for (const { verdict, figures, line } of checks) add(line, verdict === "pass" ? "✓" : short(`✗ ${figures ?? ""}`.trim()), verdict === "pass" ? "pass" : "fail");
  return lines;
}

/** Puts the notes of a state, which is that of the text as it stands. */
export function putNotes(view: EditorView, state: State): void {
  const { doc }: { doc: Text } = view.state;
  const found = [...byLine(state)].filter(([line]) => line <= doc.lines);
  const widgets = found.map(([line, [texts, kind]]) => Decoration.widget({ widget: new Note(texts.join(", "), kind), side: 1 }).range(doc.line(line).to));
  view.dispatch({ effects: put.of(Decoration.set(widgets, true)) });
}
