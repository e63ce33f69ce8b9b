// What could stand at the cursor, as the interpreter tells it.

import { autocompletion, type Completion, type CompletionContext, type CompletionResult, insertCompletionText, snippet } from "@codemirror/autocomplete";
import type { Extension } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";
import { markdown } from "./markdown";
import { type Ask, offsetsOf, placeOf, type Range } from "./places";

interface Offer {
  label: string;
  detail: string;
  docs: string;
  kind: string;
  range: Range;
  insert: string;
  /** With `${1:name}` where something is to be filled in, and `$0` where the cursor ends. */
  snippet: string | null;
  /** Whether it is of a kind that is taken here. */
  fits: boolean;
}

/** Kinds of the interpreter as the editor has pictures for them. */
const TYPES: Record<string, string> = {
  label: "property",
  field: "property",
  choice: "enum",
  file: "text",
  unit: "constant",
  local: "variable",
  definition: "variable",
  function: "function",
  import: "namespace",
  builtin: "function",
  constant: "constant",
  keyword: "keyword",
};
const ORDER = Object.keys(TYPES);

/** Puts an offer in; `n_behind` letters behind the cursor belong to the word. */
function apply({ insert, snippet: template }: Offer, n_behind: number) {
  return (view: EditorView, completion: Completion, from: number, to: number): void => {
    const end = Math.min(to + n_behind, view.state.doc.length);
    if (template === null) return view.dispatch(insertCompletionText(view.state, insert, from, end));
    snippet(template.replace(/\$(\d)/g, (_, place: string) => (place === "0" ? "${}" : `\${${place}}`)))(view, completion, from, end);
  };
}

export function completion(ask: Ask): Extension {
  const source = async (context: CompletionContext): Promise<CompletionResult | null> => {
    const { state, pos, explicit } = context;
    if (!explicit && !context.matchBefore(/[\p{L}_][\p{L}\p{N}_]*$|[\p{L}\p{N}_)\]]\.$/u)) return null;
    const found = await ask<Offer[]>(state.doc.toString(), { call: "complete", ...placeOf(state.doc, pos) }, true).catch(() => null);
    if (!found || found.length === 0 || context.aborted) return null;
    const { from, to } = offsetsOf(state.doc, found[0].range);
    const options = found
      .filter((offer) => offsetsOf(state.doc, offer.range).from === from)
      .map((offer): Completion => {
        const { label, detail, docs, kind, fits } = offer;
        // The page of a built-in comes when it is looked at.
        const page = async (): Promise<Node | null> => {
          const text = await ask<string | null>(state.doc.toString(), { call: "page", name: label }).catch(() => null);
          return text ? markdown(text) : null;
        };
        const info = docs ? { info: () => markdown(docs) } : kind === "builtin" || kind === "constant" ? { info: page } : {};
        const boost = (fits ? ORDER.length : 0) - ORDER.indexOf(kind);
        return { label, detail, ...info, type: TYPES[kind] ?? "text", boost, apply: apply(offer, Math.max(0, to - pos)) };
      });
    return { from, options, validFor: /^[\p{L}\p{N}_]*$/u };
  };
  return autocompletion({ override: [source], icons: true });
}
