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

function broken(trouble: unknown): void {
  const message = trouble instanceof Error ? trouble.message : String(trouble);
  const needs = "It needs WebGL 2, WebAssembly, workers, and a web server that has all its files. Another browser, or hardware acceleration switched on, may help.";
  host.replaceChildren(el("div", { class: "broken" }, el("h1", {}, "The playground could not be begun"), el("p", {}, message), el("p", {}, needs)));
}

async function begin(): Promise<void> {
  const playground = new Playground(host, broken);
  expose(await playground.begin());
  Object.defineProperty(window, "playground", { get: () => playground.face });
}

begin().catch(broken);
