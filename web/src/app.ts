// Puts the page together: document, picture, panels, and the commands that work on them.

import { type Command, listenToKeys } from "./commands";
import type { Begun } from "./begun";
import type { State } from "./door/door";
import { DeviationMap } from "./model/deviation";
import type { Document, Hit } from "./model/document";
import { NARROW, SettingsSignal, type Shade } from "./model/settings";
import { ClaimsPanel, diagnosticsPanel } from "./panels/claims";
import { copy, el, say } from "./panels/dom";
import { expressionOf, FactsPanel } from "./panels/facts";
import { legend } from "./panels/legend";
import { LookPanel } from "./panels/look";
import { combScale, overlay, scaleBar, stripesCaption, triad } from "./panels/overlay";
import { ParameterPanel } from "./panels/parameters";
import { helpSheet, Toolbar } from "./panels/toolbar";
import { TreePanel } from "./panels/tree";
import { savePicture } from "./picture";
import { sectionCommands } from "./sectionCommands";
import { follow } from "./view/pointer";
import { NAMED_VIEWS, type NamedView } from "./view/rig";
import { Stage } from "./view/stage";

const ANALYSES: Shade[] = ["plain", "zebra", "isophotes", "gauss", "mean", "k1", "k2", "draft", "sides", "deviation"];

/** Pixels that a key moves the model by. */
const STEP = 40;

/** Milliseconds after which what stands around the picture is there without one too. */
const BARE = 1000;

export class App {
  readonly settings = new SettingsSignal();
  readonly doc: Document;
  readonly stage: Stage;
  readonly canvas: HTMLCanvasElement;
  /** Resolves once the first picture is there, or has been waited for long enough, and with it what stands around it. */
  readonly shown: Promise<void>;
  isShown = false;
  private tree: TreePanel | null = null;
  private help: HTMLDialogElement | null = null;
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private hovering = 0;
  private readonly view: HTMLElement;
  private readonly bar = el("header", { class: "bar" });
  private readonly left = el("aside", { class: "panel left" });
  private readonly right = el("aside", { class: "panel right" });

  /** `more` are commands of the page around the model. */
  constructor({ doc, canvas }: Begun, host: HTMLElement, more: Command[] = []) {
    this.doc = doc;
    this.canvas = canvas;
    this.view = el("main", { class: "view" }, canvas);
    const { settings, left, right } = this;
    const work = el("div", { class: "work" }, left, this.view, right);
    host.append(this.bar, work);
    settings.watch(({ leftPanel, rightPanel }) => {
      left.hidden = !leftPanel;
      right.hidden = !rightPanel;
    });
    doc.start();
    const deviation = new DeviationMap(doc, settings);
    this.stage = new Stage(canvas, doc, settings, deviation);
    doc.keeper.forgotten = (key) => this.stage.forget(key);
    new ResizeObserver(() => settings.suit(work.clientWidth)).observe(work);
    this.dark.addEventListener("change", () => this.dress());
    settings.watch(() => this.dress());
    this.followPointer();
    doc.scene.follow(() => this.askAgain());
    const commands = [...this.commands(), ...more];
    listenToKeys(commands);
    this.shown = this.surround(host, deviation, commands);
  }

  /** Puts around the first picture what stands there, for which it would wait otherwise. */
  private async surround(host: HTMLElement, deviation: DeviationMap, commands: Command[]): Promise<void> {
    const { doc, stage, settings } = this;
    await this.pictured();
    this.tree = new TreePanel(doc, stage);
    const look = new LookPanel(doc, stage, settings, deviation);
    const facts = new FactsPanel(doc);
    const claims = new ClaimsPanel(doc);
    this.help = helpSheet(commands);
    this.left.append(this.tree.section.root, new ParameterPanel(doc).section.root);
    this.right.append(
      look.section.root,
      look.cutSection.root,
      facts.section.root,
      claims.claims.root,
      claims.prints.root,
      claims.output.root,
    );
    // What stands before the picture shares its room, so that nothing covers anything else.
    const front = el(
      "div",
      { class: "front" },
      el("div", { class: "front-top" }, legend(doc, stage, settings, deviation), this.greeting(), triad(stage)),
      this.toast(),
      el("div", { class: "front-foot" }, scaleBar(doc, stage, settings), combScale(doc, stage, settings), stripesCaption(stage, settings)),
      diagnosticsPanel(doc),
    );
    this.view.append(overlay(doc, stage, settings), front);
    this.bar.replaceWith(new Toolbar(doc, settings, commands).root);
    host.append(this.help);
    this.isShown = true;
    // Marks and scales follow frames.
    stage.ask();
  }

  /** Resolves with the first picture, or once it has been waited for long enough. */
  private pictured(): Promise<void> {
    const { afterFrame } = this.stage;
    return new Promise((done) => {
      const first = (): void => {
        afterFrame.delete(first);
        requestAnimationFrame(() => done());
      };
      afterFrame.add(first);
      setTimeout(done, BARE);
    });
  }

  /** Asks the door for the exact answer at a hit; the answer to an older question is dropped. */
  async question(hit: Hit): Promise<void> {
    const { doc } = this;
    if (!hit.parameters || !doc.door.canEvaluate) return;
    let found: Hit;
    try {
      found = { ...hit, answer: await doc.door.ask({ item: hit.item.key, ...hit.parameters }) };
    } catch (trouble) {
      found = { ...hit, trouble: trouble instanceof Error ? trouble.message : String(trouble) };
    }
    if (doc.marks.value.includes(hit)) doc.marks.update((marks) => marks.map((mark) => (mark === hit ? found : mark)));
    if (doc.hit.value === hit) doc.hit.set(found);
  }

  /** Asks anew for the places that stand marked: an item that is drawn as it was may differ in what single precision hides. */
  private askAgain(): void {
    const { doc } = this;
    const items = new Map(doc.items().map((item) => [item.path, item]));
    const renew = (hit: Hit): Hit | null => {
      const item = items.get(hit.path);
      if (!item || item === hit.item) return item ? hit : null;
      return { ...hit, item };
    };
    const old = [...doc.marks.value, ...(doc.hit.value ? [doc.hit.value] : [])];
    const renewed = new Map(old.map((hit) => [hit, renew(hit)]));
    if (old.every((hit) => renewed.get(hit) === hit)) return;
    doc.marks.update((marks) => marks.map((mark) => renewed.get(mark) ?? null).filter((mark) => mark !== null));
    doc.hit.update((hit) => (hit ? (renewed.get(hit) ?? null) : null));
    for (const hit of new Set(renewed.values())) if (hit && !renewed.has(hit)) void this.question(hit);
  }

  private click(x: number, y: number, isAdding: boolean): void {
    const { doc } = this;
    const hit = this.stage.pick(x, y);
    if (doc.isMeasuring.value) {
      if (!hit) return;
      doc.marks.update((marks) => (marks.length >= 2 ? [hit] : [...marks, hit]));
    } else if (hit || !isAdding) {
      doc.select(hit ? [hit.path] : [], isAdding);
    }
    doc.hit.set(hit);
    if (hit) void this.question(hit);
  }

  /** Shows what a click at a pixel would be drawn to. */
  private hover(place: [number, number] | null): void {
    cancelAnimationFrame(this.hovering);
    this.hovering = requestAnimationFrame(() => {
      const { lure } = this.doc;
      const found = place && this.settings.value.snap ? this.stage.lure(...place) : null;
      const old = lure.value;
      if (found?.path !== old?.path || found?.snapped !== old?.snapped || found?.point.join() !== old?.point.join()) lure.set(found);
    });
  }

  private followPointer(): void {
    const { stage } = this;
    const moved = (): void => {
      stage.takeOver();
      stage.ask();
    };
    follow(this.canvas, {
      orbit: (dx, dy) => (stage.rig.orbit(dx, dy), moved()),
      pan: (dx, dy) => (stage.rig.pan(dx, dy), moved()),
      zoom: (factor, x, y) => (stage.rig.zoom(factor, x, y), moved()),
      click: (x, y, isAdding) => this.click(x, y, isAdding),
      doubleClick: () => stage.fit(this.doc.selection.value.size > 0),
      settled: () => stage.ask(),
      hover: (place) => this.hover(place),
    });
  }

  /** Puts the theme onto the page and the picture. */
  private dress(): void {
    const { theme } = this.settings.value;
    const isDark = theme === "auto" ? this.dark.matches : theme === "dark";
    const name = isDark ? "dark" : "light";
    if (document.documentElement.dataset.theme === name) return;
    document.documentElement.dataset.theme = name;
    this.stage.setPalette(isDark);
    this.tree?.draw();
  }

  /** What an empty canvas says. */
  private greeting(): HTMLElement {
    const text = el("p");
    const root = el("div", { class: "greeting" }, text);
    const greet = (state: State | null): void => {
      root.hidden = state !== null && state.items.length > 0;
      const isBroken = state?.diagnostics.some((one) => one.severity === "error") ?? false;
      say(text, state === null || state.version === 0 ? "Evaluating the script …" : isBroken ? "Nothing to show until the script is whole." : "The script has nothing to draw yet.");
    };
    this.doc.state.watch(greet);
    return root;
  }

  private toast(): HTMLElement {
    const root = el("div", { class: "toast", role: "status", hidden: true });
    let timer = 0;
    this.doc.message.watch((message) => {
      clearTimeout(timer);
      root.hidden = message === null;
      if (!message) return;
      root.textContent = message.text;
      root.classList.toggle("trouble", message.isTrouble);
      timer = setTimeout(() => (root.hidden = true), message.isTrouble ? 8000 : 3000) as unknown as number;
    });
    return root;
  }

  private commands(): Command[] {
    return [...this.lookingCommands(), ...this.showingCommands(), ...this.analysisCommands(), ...this.modelCommands(), ...this.pageCommands()];
  }

  private lookingCommands(): Command[] {
    const { stage, settings } = this;
    const group = "Looking";
    const names = Object.keys(NAMED_VIEWS) as NamedView[];
    const views = names.map((name, i): Command => ({
      id: `view-${name}`,
      title: name[0].toUpperCase() + name.slice(1),
      keys: [String((i + 1) % 10)],
      group,
      run: () => stage.view(name),
    }));
    const turn = (key: string, dx: number, dy: number): Command => ({
      id: `turn-${key}`,
      title: `Turn ${key.slice(5).toLowerCase()}`,
      keys: [key],
      group,
      run: () => (stage.takeOver(), stage.rig.orbit(dx, dy), stage.ask()),
    });
    const move = (key: string, dx: number, dy: number): Command => ({
      id: `move-${key}`,
      title: `Move ${key.slice(5).toLowerCase()}`,
      keys: [`Shift+${key}`],
      group,
      run: () => (stage.takeOver(), stage.rig.pan(dx, dy), stage.ask()),
    });
    const zoom = (factor: number) => () => {
      stage.takeOver();
      stage.rig.zoom(factor, this.canvas.clientWidth / 2, this.canvas.clientHeight / 2);
      stage.ask();
    };
    return [
      { id: "fit", title: "Fit all", keys: ["f"], group, icon: "fit", run: () => stage.fit() },
      { id: "fit-selection", title: "Fit the selection", keys: ["Shift+f"], group, run: () => stage.fit(true) },
      ...views,
      { id: "projection", title: "Orthographic or perspective", keys: ["o", "p"], group, icon: "orthographic", isOn: () => settings.value.isOrthographic, run: () => settings.toggle("isOrthographic") },
      turn("ArrowLeft", -15, 0),
      turn("ArrowRight", 15, 0),
      turn("ArrowUp", 0, 15),
      turn("ArrowDown", 0, -15),
      move("ArrowLeft", -STEP, 0),
      move("ArrowRight", STEP, 0),
      move("ArrowUp", 0, -STEP),
      move("ArrowDown", 0, STEP),
      { id: "nearer", title: "Zoom in", keys: ["+", "="], group, run: zoom(1.25) },
      { id: "farther", title: "Zoom out", keys: ["-"], group, run: zoom(0.8) },
    ];
  }

  private showingCommands(): Command[] {
    const { settings, doc } = this;
    const group = "Showing";
    const toggle = (id: "grid" | "edges" | "isocurves" | "wireframe" | "section", title: string, key: string): Command => ({
      id,
      title,
      keys: [key],
      group,
      icon: id,
      isOn: () => settings.value[id],
      run: () => settings.toggle(id),
    });
    return [
      toggle("grid", "Grid and axes", "r"),
      toggle("edges", "Edges", "e"),
      toggle("isocurves", "Isocurves", "i"),
      toggle("wireframe", "Wireframe of the mesh", "w"),
      toggle("section", "Section plane", "x"),
      ...sectionCommands(this.stage, settings),
      { id: "ghost", title: "Keep this state as a ghost to compare", keys: ["g"], group, icon: "ghost", isOn: () => doc.ghost.value !== null, run: () => doc.toggleGhost() },
    ];
  }

  private analysisCommands(): Command[] {
    const { settings } = this;
    const group = "Analysis";
    const toggle = (id: "control" | "knots" | "normals" | "combs" | "shell", title: string, key: string): Command => ({
      id,
      title,
      keys: [key],
      group,
      icon: id,
      isOn: () => settings.value[id],
      run: () => settings.toggle(id),
    });
    const shade = (id: Shade, title: string, key: string): Command => ({
      id,
      title,
      keys: [key],
      group,
      icon: "zebra",
      isOn: () => settings.value.shade === id,
      run: () => settings.put({ shade: settings.value.shade === id ? "plain" : id }),
    });
    const next = (step: number) => () => {
      const all = ANALYSES.filter((one) => one !== "deviation" || this.doc.door.canEvaluate);
      const at = all.indexOf(settings.value.shade);
      settings.put({ shade: all[(at + step + all.length) % all.length] });
    };
    return [
      shade("zebra", "Zebra stripes", "z"),
      shade("isophotes", "Isophotes", "j"),
      shade("gauss", "Gaussian curvature", "u"),
      shade("draft", "Draft angle", "d"),
      shade("sides", "Fronts and backs", "b"),
      { id: "next-analysis", title: "Next analysis", keys: ["a"], group, run: next(1) },
      { id: "last-analysis", title: "Previous analysis", keys: ["Shift+a"], group, run: next(-1) },
      toggle("combs", "Curvature combs", "c"),
      toggle("control", "Control nets", "q"),
      toggle("knots", "Knots", "k"),
      toggle("normals", "Normals", "n"),
      toggle("shell", "Open and shared edges", "v"),
    ];
  }

  private modelCommands(): Command[] {
    const { doc, settings } = this;
    const group = "Model";
    const isPossible = (): boolean => doc.selection.value.size > 0;
    return [
      { id: "find", title: "Find a definition", keys: ["/"], group, run: () => (settings.put({ leftPanel: true }), this.tree?.find.focus()) },
      { id: "hide", title: "Hide the selection", keys: ["h"], group, isPossible, run: () => (doc.show(doc.selection.value, false), doc.select([])) },
      { id: "show-all", title: "Show all", keys: ["Shift+h"], group, run: () => doc.show(doc.items().map((item) => item.path), true) },
      { id: "isolate", title: "Isolate the selection", keys: ["l"], group, icon: "isolate", isPossible, run: () => doc.isolate(doc.selection.value) },
      { id: "as-script", title: "Visibility of the script", keys: ["Shift+l"], group, run: () => doc.choices.set(new Map()) },
      { id: "measure", title: "Measure between two points", keys: ["m"], group, icon: "measure", isOn: () => doc.isMeasuring.value, run: () => this.toggleMeasuring() },
      { id: "snap", title: "Snap clicks to ends, knots, corners and vertices", keys: ["Shift+m"], group, icon: "snap", isOn: () => settings.value.snap, run: () => (settings.toggle("snap"), doc.lure.set(null)) },
      { id: "copy-point", title: "Copy the clicked point’s expression", keys: ["y"], group, isPossible: () => doc.hit.value !== null, run: () => this.copyPoint() },
      { id: "none", title: "Let go: selection, point, measurement", keys: ["Escape"], group, run: () => this.letGo() },
    ];
  }

  private pageCommands(): Command[] {
    const { settings } = this;
    const group = "Page";
    return [
      { id: "left-panel", title: "Model and parameters", keys: ["["], group, icon: "left", isOn: () => settings.value.leftPanel, run: () => this.togglePanel("leftPanel", "rightPanel") },
      { id: "right-panel", title: "Analysis and claims", keys: ["]"], group, icon: "right", isOn: () => settings.value.rightPanel, run: () => this.togglePanel("rightPanel", "leftPanel") },
      { id: "photo", title: "Save a picture (PNG)", keys: ["s"], group, icon: "photo", run: () => savePicture(this) },
      { id: "theme", title: "Light or dark", keys: ["t"], group, icon: "theme", run: () => settings.put({ theme: document.documentElement.dataset.theme === "dark" ? "light" : "dark" }) },
      { id: "help", title: "All keys", keys: ["?"], group, icon: "help", run: () => (this.help?.open ? this.help.close() : this.help?.showModal()) },
    ];
  }

  /** Opens or closes a panel; the other one closes where there is no room for both. */
  private togglePanel(name: "leftPanel" | "rightPanel", other: "leftPanel" | "rightPanel"): void {
    const { settings } = this;
    const isOpen = !settings.value[name];
    const isNarrow = (this.view.parentElement?.clientWidth ?? innerWidth) <= NARROW;
    settings.put({ [name]: isOpen, ...(isOpen && isNarrow ? { [other]: false } : {}) });
  }

  private toggleMeasuring(): void {
    const { doc } = this;
    doc.marks.set([]);
    doc.isMeasuring.update((isOn) => !isOn);
  }

  private copyPoint(): void {
    const hit = this.doc.hit.value;
    if (!hit) return;
    const text = expressionOf(hit);
    void copy(text).then((isDone) => isDone && this.doc.tell(`Copied: ${text}`));
  }

  private letGo(): void {
    const { doc } = this;
    if (doc.isMeasuring.value) this.toggleMeasuring();
    doc.marks.set([]);
    doc.hit.set(null);
    doc.claim.set(null);
    doc.select([]);
    if (document.activeElement instanceof HTMLInputElement) document.activeElement.blur();
  }
}
