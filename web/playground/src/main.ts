// Begins the playground, and says so where it cannot be begun.

import { el } from "../../src/panels/dom";
import { expose } from "../../src/virote";
import { Playground } from "./playground";

declare global {
  interface Window {
    /** What browser tests may read of the editor's side. */
    playground: Playground["face"];
  }
}

const host = document.getElementById("playground")!;
try {
  const playground = new Playground(host);
  expose(playground.app);
  Object.defineProperty(window, "playground", { get: () => playground.face });
  void playground.begin();
} catch (trouble) {
  const message = trouble instanceof Error ? trouble.message : String(trouble);
  host.replaceChildren(
    el("div", { class: "broken" }, el("h1", {}, "The playground could not be begun"), el("p", {}, message), el("p", {}, "It needs WebGL 2, WebAssembly and workers. Another browser, or hardware acceleration switched on, may have them.")),
  );
}
