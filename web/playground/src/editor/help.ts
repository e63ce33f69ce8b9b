// What the editor tells of names: what stands under the pointer, the call around the cursor, where a name is defined.

import { type Extension, StateEffect, StateField } from "@codemirror/state";
import { EditorView, hoverTooltip, keymap, showTooltip, type Tooltip, ViewPlugin, type ViewUpdate } from "@codemirror/view";
import { el } from "../../../src/panels/dom";
import { markdown } from "./markdown";
import { type Ask, offsetsOf, placeOf, type Range } from "./places";

export function hover(ask: Ask): Extension {
  return hoverTooltip(async ({ state }, at) => {
    const found = await ask<{ text: string; range: Range }>(state.doc.toString(), { call: "hover", ...placeOf(state.doc, at) }, true).catch(() => null);
    if (!found) return null;
    const { from, to } = offsetsOf(state.doc, found.range);
    return { pos: from, end: to, above: true, create: () => ({ dom: markdown(found.text) }) };
  });
}

interface Signature {
  label: string;
  docs: string;
  parameters: { label: string; docs: string }[];
  active: number | null;
}

/** The call with the parameter that is being written set apart. */
function signatureText({ label, parameters, active }: Signature): HTMLElement {
  const parameter = active === null ? undefined : parameters[active];
  const at = parameter ? label.indexOf(parameter.label) : -1;
  const root = el("div", { class: "help-text signature" });
  if (!parameter || at < 0) root.append(el("code", {}, label));
  else root.append(el("code", {}, label.slice(0, at), el("b", {}, parameter.label), label.slice(at + parameter.label.length)));
  if (parameter?.docs) root.append(el("p", {}, parameter.docs));
  return root;
}

const putSignature = StateEffect.define<Tooltip | null>();
const signatureShown = StateField.define<Tooltip | null>({
  create: () => null,
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(putSignature)) return effect.value;
    return value && transaction.docChanged ? { ...value, pos: transaction.changes.mapPos(value.pos) } : value;
  },
  provide: (field) => showTooltip.from(field),
});

/** The signature of the call that is being written, while it is. */
export function signature(ask: Ask): Extension {
  const plugin = ViewPlugin.define((view) => {
    let timer = 0;
    const put = (tooltip: Tooltip | null): void => {
      if (tooltip || view.state.field(signatureShown)) view.dispatch({ effects: putSignature.of(tooltip) });
    };
    const look = async (): Promise<void> => {
      const { doc, selection } = view.state;
      const at = selection.main.head;
      const found = await ask<Signature[]>(doc.toString(), { call: "signature", ...placeOf(doc, at) }).catch(() => null);
      if (view.state.doc !== doc || view.state.selection.main.head !== at) return;
      const first = found?.find((one) => one.active !== null) ?? found?.[0];
      put(first ? { pos: at, above: true, create: () => ({ dom: signatureText(first) }) } : null);
    };
    return {
      update(update: ViewUpdate) {
        const isShown = update.state.field(signatureShown) !== null;
        const isTyped = update.transactions.some((one) => one.isUserEvent("input"));
        if (!isTyped && !(isShown && (update.docChanged || update.selectionSet))) return;
        clearTimeout(timer);
        timer = setTimeout(() => void look(), 80) as unknown as number;
      },
      destroy: () => clearTimeout(timer),
    };
  });
  const close = (view: EditorView): boolean => {
    if (!view.state.field(signatureShown)) return false;
    view.dispatch({ effects: putSignature.of(null) });
    return true;
  };
  return [signatureShown, plugin, keymap.of([{ key: "Escape", run: close }])];
}

/** Goes to the definition of the name at a place. */
async function goTo(ask: Ask, view: EditorView, at: number): Promise<void> {
  const { doc } = view.state;
  const found = await ask<Range>(doc.toString(), { call: "definition", ...placeOf(doc, at) }).catch(() => null);
  if (!found || view.state.doc !== doc) return;
  const { from, to } = offsetsOf(doc, found);
  view.dispatch({ selection: { anchor: from, head: to }, effects: EditorView.scrollIntoView(from, { y: "center" }) });
}

/** F12, or a click with Ctrl or Command, goes to where a name is defined. */
export function definition(ask: Ask): Extension {
  return [
    keymap.of([{ key: "F12", run: (view) => (void goTo(ask, view, view.state.selection.main.head), true) }]),
    EditorView.domEventHandlers({
      mousedown(event, view) {
        if (!(event.ctrlKey || event.metaKey) || event.button !== 0) return false;
        const at = view.posAtCoords({ x: event.clientX, y: event.clientY });
        if (at === null) return false;
        event.preventDefault();
        void goTo(ask, view, at);
        return true;
      },
    }),
  ];
}
