// What the page shares with an editor: the definition at the cursor is selected here, what is selected here is told there.
//
// To the page, from the window that holds it:
//   { virote: "select", definitions: ["wall"] }   selects the first of these definitions that the model has
//   { virote: "show", definitions: ["wall"] }     shows and frames it besides
// From the page, to that window:
//   { virote: "ready" }                           once it listens
//   { virote: "selected", definition: "wall" }    whenever the person selects something
// An address that ends with #definition=wall shows that definition once the model is there.

import type { Document } from "./model/document";
import type { Stage } from "./view/stage";

interface Wish {
  definitions: string[];
  isShown: boolean;
}

/** Follows the editor, and tells it what the person selects. */
export function followEditor(doc: Document, stage: Stage): void {
  let wish = wishOfAddress();
  /** Whether the selection that changes is what the editor wanted. */
  let isLed = false;
  /** Whether the selection is to be framed as soon as all of it is drawn. */
  let isUnframed = false;

  const follow = (): void => {
    if (!wish) return;
    const items = doc.items();
    const named = wish.definitions.find((name) => items.some(({ definition }) => definition === name));
    // A definition that is being written comes with a later state.
    if (named === undefined) return;
    const { isShown } = wish;
    wish = null;
    const paths = items.filter(({ definition }) => definition === named).map(({ path }) => path);
    if (isShown) doc.show(paths, true);
    // Of a list one element may be selected, and is meant as well.
    if (!paths.some((path) => doc.selection.value.has(path))) {
      isLed = true;
      doc.select(paths);
      isLed = false;
    }
    if (isShown) isUnframed = true;
    frame();
  };

  const frame = (): void => {
    const buffers = doc.scene.value?.buffers;
    if (!isUnframed || !doc.selected().every(({ key }) => buffers?.has(key))) return;
    isUnframed = false;
    stage.fit(true);
  };

  const tell = (message: object): void => parent.postMessage(message, "*");

  doc.scene.follow(() => {
    follow();
    frame();
  });
  doc.selection.follow((selection) => {
    if (isLed) return;
    wish = null;
    isUnframed = false;
    const newest = [...selection].at(-1);
    const item = doc.items().find(({ path }) => path === newest);
    if (item) tell({ virote: "selected", definition: item.definition });
  });
  addEventListener("message", ({ source, data }: MessageEvent<unknown>) => {
    const wanted = source === parent ? wishOf(data) : null;
    if (!wanted) return;
    wish = wanted;
    follow();
  });
  addEventListener("hashchange", () => {
    wish = wishOfAddress() ?? wish;
    follow();
  });
  tell({ virote: "ready" });
}

/** What a message wants selected, if it is one of an editor. */
function wishOf(message: unknown): Wish | null {
  if (typeof message !== "object" || message === null) return null;
  const { virote, definitions } = message as { virote?: unknown; definitions?: unknown };
  if ((virote !== "select" && virote !== "show") || !Array.isArray(definitions)) return null;
  return { definitions: definitions.map(String), isShown: virote === "show" };
}

/** What the address names. */
function wishOfAddress(): Wish | null {
  const definition = new URLSearchParams(location.hash.slice(1)).get("definition");
  return definition ? { definitions: [definition], isShown: true } : null;
}
