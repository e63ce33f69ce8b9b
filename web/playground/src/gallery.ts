// The examples with their pictures, to choose from.

import { button, el } from "../../src/panels/dom";
import { icon } from "../../src/panels/icons";
import type { Example } from "./folder";

/** A sheet of the examples; `open` is called with the one that was chosen. */
export function gallery(examples: readonly Example[], open: (name: string) => void): HTMLDialogElement {
  const sheet = el("dialog", { class: "help gallery", "aria-label": "Examples" });
  const cards = examples.map(({ name, title }) => {
    const picture = el("img", { src: `gallery/${name.replace(/\.geo$/, ".png")}`, alt: "", loading: "lazy" });
    const text = el("span", {}, el("b", {}, name), el("span", {}, title));
    const card = button(picture, title, () => {
      sheet.close();
      open(name);
    }, { class: "card", "data-example": name });
    card.append(text);
    return card;
  });
  const close = button(icon("cross"), "Close (Esc)", () => sheet.close(), { class: "tool" });
  sheet.append(el("header", {}, el("h2", {}, "Examples"), close), el("div", { class: "cards" }, ...cards));
  sheet.addEventListener("click", (event) => {
    if (event.target === sheet) sheet.close();
  });
  return sheet;
}
