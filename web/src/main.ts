// Builds the page around what has begun, and tells tests what they may read.

import { App } from "./app";
import { begin } from "./begun";
import { followEditor } from "./editor";
import { el } from "./panels/dom";
import { expose } from "./virote";

const host = document.getElementById("app")!;

function broken(trouble: unknown): void {
  const message = trouble instanceof Error ? trouble.message : String(trouble);
  host.replaceChildren(
    el("div", { class: "broken" }, el("h1", {}, "The picture could not be begun"), el("p", {}, message), el("p", {}, "The viewer needs WebGL 2. Another browser, or hardware acceleration switched on, may have it.")),
  );
}

try {
  const app = new App(begin(), host);
  expose(app);
  followEditor(app.doc, app.stage);
  app.shown.catch(broken);
} catch (trouble) {
  broken(trouble);
}
