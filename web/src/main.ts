// Begins: finds the door, builds the page, and tells tests what they may read.

import { App } from "./app";
import { EmbeddedDoor } from "./door/embedded";
import { HttpDoor } from "./door/http";
import { followEditor } from "./editor";
import { el } from "./panels/dom";
import { expose } from "./virote";

/** The token that the server put into the address. */
function token(): string {
  return new URLSearchParams(location.search).get("token") ?? "";
}

const host = document.getElementById("app")!;
try {
  const app = new App(EmbeddedDoor.find() ?? new HttpDoor(token()), host);
  expose(app);
  followEditor(app.doc, app.stage);
} catch (trouble) {
  const message = trouble instanceof Error ? trouble.message : String(trouble);
  host.replaceChildren(
    el("div", { class: "broken" }, el("h1", {}, "The picture could not be begun"), el("p", {}, message), el("p", {}, "The viewer needs WebGL 2. Another browser, or hardware acceleration switched on, may have it.")),
  );
}
