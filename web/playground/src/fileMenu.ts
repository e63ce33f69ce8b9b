// The menu of files: what the browser keeps, new scripts, data from the machine.

import { button, el } from "../../src/panels/dom";
import { icon } from "../../src/panels/icons";
import { type Folder, isScript } from "./folder";

export interface FileActions {
  /** The script that is open. */
  current(): string;
  begin(): void;
  open(name: string): void;
  download(name: string): void;
  remove(name: string): void;
  take(files: File[]): void;
}

/** How large a file is, in a few letters. */
function sizeText(n_bytes: number): string {
  return n_bytes < 1000 ? `${n_bytes} B` : n_bytes < 1e6 ? `${(n_bytes / 1e3).toPrecision(3)} kB` : `${(n_bytes / 1e6).toPrecision(3)} MB`;
}

export function fileMenu(folder: Folder, actions: FileActions): HTMLDetailsElement {
  const list = el("div", { class: "menu-list files" });
  const menu = el("details", { class: "menu", "data-menu": "files" }, el("summary", { class: "tool word", title: "Scripts and data" }, "Files"), list);
  const chooser = el("input", { type: "file", multiple: "", class: "offscreen", tabindex: "-1", "aria-label": "Files of this machine" });
  chooser.addEventListener("change", () => {
    actions.take([...(chooser.files ?? [])]);
    chooser.value = "";
  });
  const leave = (action: () => void) => (): void => {
    menu.open = false;
    action();
  };
  const row = (name: string, size: number): HTMLElement => {
    const main = isScript(name)
      ? button(name, `Open ${name}`, leave(() => actions.open(name)), { class: "menu-row", "data-file": name, "aria-current": name === actions.current() ? "true" : null })
      : el("span", { class: "menu-row data", "data-file": name }, name);
    return el(
      "div",
      { class: "file" },
      main,
      el("span", { class: "unit" }, sizeText(size)),
      button(icon("download"), `Download ${name}`, () => actions.download(name), { class: "tool" }),
      button(icon("cross"), `Delete ${name} from this browser`, leave(() => actions.remove(name)), { class: "tool" }),
    );
  };
  const draw = (): void => {
    const all = folder.list();
    const part = (title: string, rows: HTMLElement[]): Node[] => (rows.length > 0 ? [el("h4", {}, title), ...rows] : []);
    const rows = (wanted: boolean): HTMLElement[] => all.filter(({ name }) => isScript(name) === wanted).map(({ name, size }) => row(name, size));
    list.replaceChildren(
      button("New script", "Begin an empty script", leave(actions.begin), { class: "menu-row", "data-do": "new" }),
      button("Add files …", "Scripts, and data that scripts load", leave(() => chooser.click()), { class: "menu-row", "data-do": "add" }),
      chooser,
      ...part("Scripts in this browser", rows(true)),
      ...part("Data", rows(false)),
    );
  };
  menu.addEventListener("toggle", () => menu.open && draw());
  document.addEventListener("pointerdown", (event) => {
    if (!menu.contains(event.target as Node)) menu.open = false;
  });
  menu.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !menu.open) return;
    event.stopPropagation();
    menu.open = false;
  });
  return menu;
}
