// The bar at the top: the script and how it stands, the switches, and the help sheet.

import { type Command, keyName } from "../commands";
import type { Document } from "../model/document";
import type { SettingsSignal } from "../model/settings";
import { button, el, say } from "./dom";
import { icon } from "./icons";

/** Commands in the bar, in groups. */
const BAR = [
  ["fit", "projection", "grid"],
  ["edges", "isocurves", "wireframe"],
  ["zebra", "combs", "control", "knots", "normals", "shell"],
  ["section", "measure", "snap", "ghost"],
  ["photo", "theme", "help"],
];

export class Toolbar {
  readonly root: HTMLElement;
  private readonly buttons: [Command, HTMLButtonElement][] = [];

  constructor(doc: Document, settings: SettingsSignal, commands: Command[]) {
    const byId = new Map(commands.map((command) => [command.id, command]));
    const make = (id: string): HTMLButtonElement => {
      const command = byId.get(id)!;
      const made = button(icon(command.icon!), titleOf(command), command.run, { class: "tool", "data-command": id });
      made.setAttribute("aria-label", command.title);
      this.buttons.push([command, made]);
      return made;
    };
    const groups = BAR.map((ids) => el("div", { class: "tool-group" }, ...ids.map(make)));
    groups[0].append(viewMenu(commands));
    const more = moreMenu(groups, (id) => {
      const command = byId.get(id)!;
      const row = button(icon(command.icon!), titleOf(command), command.run, { class: "menu-row", "data-more": id });
      row.append(el("span", {}, command.title));
      this.buttons.push([command, row]);
      return row;
    });
    groups[groups.length - 1].prepend(more);
    this.root = el(
      "header",
      { class: "bar" },
      el("div", { class: "bar-side" }, make("left-panel"), title(doc), status(doc)),
      el("nav", { class: "bar-tools", "aria-label": "Tools" }, ...groups),
      el("div", { class: "bar-side end" }, make("right-panel")),
    );
    const show = (): void => this.show();
    settings.watch(show);
    doc.ghost.follow(show);
    doc.isMeasuring.follow(show);
  }

  private show(): void {
    for (const [command, made] of this.buttons) {
      if (command.isOn) made.setAttribute("aria-pressed", String(command.isOn()));
    }
  }
}

function titleOf({ title, keys }: Command): string {
  return keys.length > 0 ? `${title} (${keyName(keys[0])})` : title;
}

/** Groups of the bar that a narrow window has no room for: what they hold is listed in a menu. */
const FOLDED = [1, 2, 3];

/** The menu with what a narrow bar leaves out; shown where it does, as the style says. */
function moreMenu(groups: HTMLElement[], make: (id: string) => HTMLButtonElement): HTMLElement {
  const lists = FOLDED.map((i) => {
    groups[i].classList.add(`folded-${i}`);
    return el("div", { class: `menu-group folded-${i}` }, ...BAR[i].map(make));
  });
  return closing(el("details", { class: "menu more" }, el("summary", { class: "tool", title: "More" }, icon("more")), el("div", { class: "menu-list" }, ...lists)));
}

/** A menu that closes at a press anywhere else. */
function closing(menu: HTMLDetailsElement): HTMLDetailsElement {
  document.addEventListener("pointerdown", (event) => {
    if (!menu.contains(event.target as Node)) menu.open = false;
  });
  return menu;
}

function viewMenu(commands: Command[]): HTMLElement {
  const views = commands.filter((command) => command.id.startsWith("view-"));
  const rows = views.map((command) => {
    const row = button(command.title, "", () => {
      command.run();
      menu.open = false;
    }, { class: "menu-row", "data-command": command.id });
    row.append(el("kbd", {}, keyName(command.keys[0])));
    return row;
  });
  const menu = closing(el("details", { class: "menu" }, el("summary", { class: "tool", title: "Views" }, icon("views")), el("div", { class: "menu-list" }, ...rows)));
  return menu;
}

function title(doc: Document): HTMLElement {
  const name = el("span", { class: "script" });
  const unit = el("span", { class: "unit" });
  doc.listed.watch((state) => {
    say(name, state?.script ?? "");
    say(unit, state?.unit ?? "");
    name.title = state?.tolerance ? `${state.script}: tolerance ${state.tolerance} ${state.unit}` : (state?.script ?? "");
    if (state) document.title = `${state.script} · virote`;
  });
  return el("div", { class: "title" }, name, unit);
}

/** How the model stands: current, being evaluated (with a button to stop), in error, or out of reach. */
function status(doc: Document): HTMLElement {
  const text = el("span", { class: "status-text" });
  const stop = button(icon("stop"), "Stop the evaluation", () => void doc.attempt(doc.door.stop()), { class: "tool stop" });
  const root = el("div", { class: "status", role: "status" }, el("span", { class: "lamp" }), text, stop);
  let waiting = 0;
  const show = (): void => {
    const state = doc.listed.value;
    const isBusy = doc.isBusy.value && root.classList.contains("slow");
    const n_errors = state?.diagnostics.filter((one) => one.severity === "error").length ?? 0;
    const kind = !doc.isOnline.value ? "offline" : isBusy ? "busy" : n_errors > 0 || state?.isCurrent === false ? "error" : "good";
    root.dataset.kind = kind;
    stop.hidden = kind !== "busy" || !doc.door.canEvaluate;
    const { evaluate = 0, mesh = 0 } = state?.milliseconds ?? {};
    say(text, {
      offline: doc.isForeign ? "the command was started anew: open the address that it printed" : "no connection",
      busy: "evaluating",
      error: n_errors === 1 ? "1 error" : n_errors > 0 ? `${n_errors} errors` : "not current",
      good: doc.door.canEvaluate && state ? `${Math.round(evaluate + mesh)} ms` : "",
    }[kind]);
    const { evaluated = 0, reused = 0 } = state?.definitions ?? {};
    root.title = state ? `evaluated in ${evaluate.toFixed(1)} ms, meshed in ${mesh.toFixed(1)} ms; ${evaluated} definitions evaluated, ${reused} reused` : "";
  };
  doc.isBusy.watch((isBusy) => {
    clearTimeout(waiting);
    if (!isBusy) root.classList.remove("slow");
    // What is over in a moment would only flicker.
    else waiting = setTimeout(() => {
      root.classList.add("slow");
      show();
    }, 180) as unknown as number;
    show();
  });
  doc.isOnline.follow(show);
  doc.listed.follow(show);
  return root;
}

/** The sheet with every key. */
export function helpSheet(commands: Command[]): HTMLDialogElement {
  const groups = [...new Set(commands.map((command) => command.group))];
  const sheet = el("dialog", { class: "help" });
  const columns = groups.map((group) =>
    el(
      "section",
      {},
      el("h3", {}, group),
      ...commands
        .filter((command) => command.group === group && command.keys.length > 0)
        .map(({ title: text, keys }) => el("div", { class: "help-row" }, el("span", {}, text), el("span", {}, ...keys.slice(0, 2).map((key) => el("kbd", {}, keyName(key)))))),
    ),
  );
  const mouse: [string, string][] = [
    ["Turn", "drag"],
    ["Move", "right or middle drag, Shift drag"],
    ["Zoom to the pointer", "wheel, two fingers"],
    ["Ask for a point", "click"],
    ["Add to the selection", "Ctrl click"],
    ["Fit what is clicked", "double click"],
  ];
  columns.push(
    el("section", {}, el("h3", {}, "Mouse and fingers"), ...mouse.map(([what, how]) => el("div", { class: "help-row" }, el("span", {}, what), el("span", { class: "how" }, how)))),
  );
  const close = button(icon("cross"), "Close (Esc)", () => sheet.close(), { class: "tool" });
  sheet.append(el("header", {}, el("h2", {}, "Keys"), close), el("div", { class: "help-columns" }, ...columns));
  sheet.addEventListener("click", (event) => {
    if (event.target === sheet) sheet.close();
  });
  return sheet;
}
