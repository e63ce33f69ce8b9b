// Colours of the words, as the interpreter knows them.

import { type EditorState, type Extension, RangeSetBuilder, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView, ViewPlugin, type ViewUpdate } from "@codemirror/view";
import { type Ask, offsetsOf, type Range } from "./places";

interface Token {
  range: Range;
  kind: string;
  isDeclaration: boolean;
  isBuiltIn: boolean;
}

const put = StateEffect.define<DecorationSet>();

const painted = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(put)) return effect.value;
    return value.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

function marks({ doc }: EditorState, tokens: Token[]): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>();
  for (const { range, kind, isDeclaration, isBuiltIn } of tokens) {
    const { from, to } = offsetsOf(doc, range);
    const classes = `word-${kind}${isDeclaration ? " word-declared" : ""}${isBuiltIn ? " word-built-in" : ""}`;
    if (from < to) builder.add(from, to, Decoration.mark({ class: classes }));
  }
  return builder.finish();
}

/** Paints the words anew after each change. */
export function tokens(ask: Ask): Extension {
  const plugin = ViewPlugin.define((view) => {
    let isAsking = false;
    const paint = async (): Promise<void> => {
      const { doc } = view.state;
      // Before a script is open nobody need be woken.
      if (isAsking || doc.length === 0) return;
      isAsking = true;
      const found = await ask<Token[]>(doc.toString(), { call: "tokens" }).catch(() => null);
      isAsking = false;
      if (view.state.doc !== doc) return paint();
      if (found) view.dispatch({ effects: put.of(marks(view.state, found)) });
    };
    void paint();
    return { update: (update: ViewUpdate) => void (update.docChanged && paint()) };
  });
  return [painted, plugin];
}
