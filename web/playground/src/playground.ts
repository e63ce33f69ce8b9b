// The playground: a script that is open, kept, shared and evaluated, with the viewer beside it.

import { App } from "../../src/app";
import { begunWith } from "../../src/begun";
import type { Command } from "../../src/commands";
import { button, copy, el } from "../../src/panels/dom";
import { begin } from "./begin";
import { Editor } from "./editor/editor";
import { Engine, type Script } from "./engine";
import { type FileActions, fileMenu } from "./fileMenu";
import { Folder, isScript } from "./folder";
import { gallery } from "./gallery";
import { base64, fragmentOf, type Shared, sharedIn } from "./link";
import { split } from "./split";
import { WorkerDoor } from "./workerDoor";
import { Writer } from "./writer";
import { zip } from "./zip";

/** A text is evaluated so long after the last key, in milliseconds. */
const PAUSE = 200;
/** The address follows the script so long after it, in milliseconds. */
const ADDRESS_PAUSE = 400;
/** A link is at most so long, in letters: what mail and chat still take whole. */
const LONGEST_LINK = 60_000;
/** A file of more bytes is not taken. */
const LARGEST_FILE = 64 << 20;
/** A picture between both panels is large enough from this width on, in pixels. */
const ROOM_FOR_PANELS = 820;
const LAST = "virote-last";
const FIRST_EXAMPLE = "bottle.geo";
const EMPTY = "geo 1\nunit mm\n\n";
/**
 * The viewer waits so long for the interpreter, in milliseconds: until it is built and has drawn, this thread cannot pass
 * on what comes over the network, while the first script may be evaluated beside it.
 */
const HEAD_START = 500;

export class Playground {
  readonly editor: Editor;
  readonly engine: Engine;
  private readonly module = begin().module;
  private readonly viewer = el("div", { id: "app" });
  private app: App | null = null;
  private show: () => void = () => {};
  /** Resolves once the first picture is there; until then the editor leaves it to itself, as far as it can. */
  private readonly shown = new Promise<void>((done) => (this.show = done));
  /** What is to be told once there is a viewer that tells it. */
  private untold: { message: string; isTrouble: boolean }[] = [];
  private readonly folder = new Folder();
  private readonly filled = Promise.allSettled([this.folder.open(), this.folder.fetchExamples()]);
  private readonly writer: Writer;
  private readonly name = el("input", { type: "text", class: "file-name", "aria-label": "Name of the script", spellcheck: "false" });
  private script = "script.geo";
  /** Whether the script is one that the browser keeps. */
  private isOwn = false;
  private evaluation = 0;
  private address = 0;
  private n_addresses = 0;
  private canKeep = true;

  /** `failed` is called when there is no interpreter, or no viewer. */
  constructor(
    host: HTMLElement,
    private readonly failed: (trouble: unknown) => void,
  ) {
    this.module.catch(failed);
    const files = (): Iterable<readonly [string, Uint8Array]> => this.folder.files();
    this.engine = new Engine(this.module, files);
    this.writer = new Writer(this.module, this.engine, files, this.shown);
    const pane = el("section", { class: "editor", "aria-label": "Script" });
    pane.append(this.bar());
    const text = el("div", { class: "editor-text" });
    pane.append(text);
    host.append(split(pane, this.viewer));
    this.editor = new Editor(text, this.writer.ask, (next) => this.changed(next));
    this.engine.findings.follow(({ text: of, all, state }) => void this.shown.then(() => this.editor.mark(of, all, state)));
    this.engine.news.follow((news) => this.tell(news, true));
    this.engine.state.follow(() => this.followAddress());
    this.takeDrops();
    addEventListener("hashchange", () => void this.openFragment());
  }

  /** Begins with a script, and then builds the viewer, which it gives back. */
  async begin(): Promise<App> {
    await this.openFirst();
    await Promise.race([this.module.catch(() => {}), new Promise((done) => setTimeout(done, HEAD_START))]);
    const door = new WorkerDoor(this.engine, {
      replace: (next) => this.editor.replace(next),
      deliver: (all) => this.deliver(all),
    });
    const app = new App(begunWith(door), this.viewer, this.commands());
    if (app.settings.isFirstVisit && this.viewer.clientWidth < ROOM_FOR_PANELS) app.settings.put({ rightPanel: false });
    app.doc.selection.follow((paths) => this.reveal(app, paths));
    this.app = app;
    app.shown.then(this.show, this.failed);
    for (const { message, isTrouble } of this.untold) app.doc.tell(message, isTrouble);
    this.untold = [];
    return app;
  }

  /** Opens the script of the address, the one that was open last, or an example. */
  private async openFirst(): Promise<void> {
    const [kept, examples] = await this.filled;
    if (kept.status === "rejected") this.cannotKeep(kept.reason);
    if (examples.status === "rejected") this.tell(`The examples could not be loaded: ${String(examples.reason)}`, true);
    if (await this.openFragment()) return;
    const last = remembered();
    if (last !== null && this.folder.has(last)) this.openOwn(last);
    else if (this.folder.example(FIRST_EXAMPLE) !== null) this.openExample(FIRST_EXAMPLE);
    else this.beginScript();
  }

  /** The name of the script, its text, and whether nothing is under way: for tests. */
  get face(): { name: string; text: string; isBusy: boolean; n_begun: number } {
    const { engine, editor, script } = this;
    return { name: script, text: editor.text, isBusy: engine.isBusy.value || this.evaluation !== 0, n_begun: engine.n_begun };
  }

  private tell(message: string, isTrouble = false): void {
    if (this.app) this.app.doc.tell(message, isTrouble);
    else this.untold.push({ message, isTrouble });
  }

  private commands(): Command[] {
    const group = "Writing";
    // These are the editor's own keys, told in the sheet of keys.
    const isPossible = (): boolean => false;
    return [
      { id: "again", title: "Evaluate again", keys: ["Ctrl+Enter"], group, run: () => this.engine.again() },
      { id: "keep", title: "Keep the script and its address", keys: ["Ctrl+s"], group, run: () => void this.keepNow() },
      { id: "format", title: "Bring the script into its usual form", keys: ["Shift+Alt+f"], group, run: () => void this.format(), isPossible },
      { id: "definition", title: "Go to the definition", keys: ["F12"], group, run: () => {}, isPossible },
      { id: "complete", title: "Complete", keys: ["Ctrl+ "], group, run: () => {}, isPossible },
      { id: "editor", title: "To the script, and back to the picture", keys: ["F6"], group, run: () => this.changeSides() },
    ];
  }

  private bar(): HTMLElement {
    this.name.addEventListener("change", () => this.rename(this.name.value.trim()));
    const actions: FileActions = {
      current: () => this.script,
      begin: () => this.beginScript(),
      open: (name) => this.openOwn(name),
      download: (name) => this.download(name),
      remove: (name) => void this.remove(name),
      take: (files) => void this.take(files),
    };
    const word = (text: string, title: string, name: string, action: () => void): HTMLElement => button(text, title, action, { class: "tool word", "data-do": name });
    return el(
      "header",
      { class: "bar" },
      this.name,
      fileMenu(this.folder, actions),
      word("Examples", "Open an example", "examples", () => this.showGallery()),
      word("Format", "Bring the script into its usual form (Shift Alt F)", "format", () => void this.format()),
      el("a", { class: "tool word", href: "book/language.html", target: "_blank", rel: "noopener" }, "Book"),
      word("Share", "Copy a link that holds the script", "share", () => void this.share()),
    );
  }

  /** Opens a script that stands on its own until it is changed. */
  private open(script: Script, isOwn: boolean): void {
    clearTimeout(this.evaluation);
    this.evaluation = 0;
    this.script = script.name;
    this.isOwn = isOwn;
    this.name.value = script.name;
    this.engine.open(script);
    this.writer.renew();
    this.editor.open(script.text);
    remember(script.name);
    this.followAddress();
  }

  private openOwn(name: string): void {
    const text = this.folder.text(name);
    if (text !== null) this.open({ name, text, values: {} }, true);
  }

  private openExample(name: string): void {
    const text = this.folder.example(name)!;
    // A changed copy of the example keeps its name.
    const isOwn = this.folder.text(name) === text;
    this.open({ name: isOwn ? name : this.folder.freeName(name), text, values: {} }, isOwn);
  }

  private beginScript(): void {
    this.open({ name: this.folder.freeName("script.geo"), text: EMPTY, values: {} }, false);
  }

  /** Opens what the address holds; false where it holds nothing. */
  private async openFragment(): Promise<boolean> {
    const fragment = location.hash.slice(1);
    const example = /^example=([\w.-]+)$/.exec(fragment)?.[1];
    if (example !== undefined) {
      if (this.folder.example(example) !== null) return this.openExample(example), true;
      this.tell(`There is no example ${example}`, true);
      return false;
    }
    let shared: Shared | null;
    try {
      shared = await sharedIn(fragment);
    } catch (trouble) {
      this.tell(messageOf(trouble), true);
      return false;
    }
    if (!shared) return false;
    const { text, values = {}, files = {} } = shared;
    const name = scriptName(shared.name);
    await this.folder.lend(files).catch((trouble: unknown) => this.cannotKeep(trouble));
    const isOwn = this.folder.text(name) === text;
    this.open({ name: isOwn ? name : this.folder.freeName(name), text, values }, isOwn);
    return true;
  }

  private changed(text: string): void {
    if (!this.isOwn) {
      // Another script of this name may have been kept meanwhile.
      this.script = this.name.value = this.folder.freeName(this.script);
      this.isOwn = true;
      remember(this.script);
    }
    this.keep(this.script, text);
    clearTimeout(this.evaluation);
    this.evaluation = setTimeout(() => {
      this.evaluation = 0;
      this.engine.edit(this.editor.text);
    }, PAUSE) as unknown as number;
    this.followAddress();
  }

  private keep(name: string, content: string | Uint8Array<ArrayBuffer>): void {
    this.folder.put(name, content).catch((trouble: unknown) => this.cannotKeep(trouble));
  }

  private cannotKeep(trouble: unknown): void {
    if (this.canKeep) this.tell(`This browser keeps nothing more (${messageOf(trouble)}); the address still holds the script.`, true);
    this.canKeep = false;
  }

  private async keepNow(): Promise<void> {
    this.keep(this.script, this.editor.text);
    this.isOwn = true;
    await this.writeAddress();
    if (this.canKeep) this.tell(`Kept in this browser: ${this.script}`);
  }

  private rename(wanted: string): void {
    const old = this.script;
    const name = scriptName(wanted);
    if (wanted === "" || name === old) {
      this.name.value = old;
      return;
    }
    const wasOwn = this.isOwn;
    const { values } = this.engine;
    this.open({ name: this.folder.freeName(name), text: this.editor.text, values }, true);
    this.keep(this.script, this.editor.text);
    if (wasOwn) this.folder.remove(old).catch((trouble: unknown) => this.cannotKeep(trouble));
  }

  private async remove(name: string): Promise<void> {
    if (!confirm(`Delete ${name} from this browser?`)) return;
    await this.folder.remove(name).catch((trouble: unknown) => this.cannotKeep(trouble));
    // The open script stays as it is, and is kept again when it changes.
    if (name === this.script) this.isOwn = false;
    this.renewFiles();
  }

  private async take(files: File[]): Promise<void> {
    const taken: string[] = [];
    for (const file of files) {
      if (file.size > LARGEST_FILE) {
        this.tell(`${file.name} is larger than 64 MB and was not taken.`, true);
        continue;
      }
      this.keep(file.name, new Uint8Array(await file.arrayBuffer()));
      taken.push(file.name);
    }
    if (taken.length === 0) return;
    const script = taken.filter(isScript).at(-1);
    if (script !== undefined) this.openOwn(script);
    else this.renewFiles();
    const first = taken.find((name) => !isScript(name));
    this.tell(first === undefined ? `Taken: ${taken.join(", ")}` : `Taken: ${taken.join(", ")}. A script reads it by load("${first}").`);
  }

  private renewFiles(): void {
    this.writer.renew();
    this.engine.beginAnew();
  }

  private takeDrops(): void {
    const hasFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;
    const root = document.documentElement;
    // Before the editor, which would write the file's text into the script.
    const over = (event: DragEvent): void => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      root.classList.toggle("dropping", event.type !== "dragleave" || event.relatedTarget !== null);
    };
    addEventListener("dragover", over, true);
    addEventListener("dragleave", over, true);
    addEventListener("drop", (event) => {
      root.classList.remove("dropping");
      if (!hasFiles(event)) return;
      event.preventDefault();
      event.stopPropagation();
      void this.take([...event.dataTransfer!.files]);
    }, true);
  }

  private async format(): Promise<void> {
    if (!(await this.editor.format())) this.tell("The script has its usual form, or mistakes that must be mended first.");
  }

  /** The script as a link, with the files that it reads as long as they fit. */
  private async share(): Promise<void> {
    const shared = this.shared();
    const files: Record<string, string> = {};
    const left: string[] = [];
    let fragment = await fragmentOf(shared);
    for (const name of this.folder.needs(shared.text)) {
      const longer = await fragmentOf({ ...shared, files: { ...files, [name]: base64(this.folder.bytes(name)!) } });
      if (longer.length > LONGEST_LINK) left.push(name);
      else {
        files[name] = base64(this.folder.bytes(name)!);
        fragment = longer;
      }
    }
    const url = new URL(location.href);
    url.hash = fragment;
    const isCopied = await copy(url.href);
    const without = left.length > 0 ? ` It leaves out ${left.join(", ")}: whoever opens it adds ${left.length === 1 ? "that file" : "those files"}.` : "";
    this.tell(isCopied ? `The link is on the clipboard.${without}` : `Copy the address: it holds the script.${without}`, !isCopied);
    if (!isCopied) history.replaceState(null, "", `#${fragment}`);
  }

  private shared(): Shared {
    const { values } = this.engine;
    return { name: this.script, text: this.editor.text, ...(Object.keys(values).length > 0 ? { values } : {}) };
  }

  private followAddress(): void {
    clearTimeout(this.address);
    this.address = setTimeout(() => void this.writeAddress(), ADDRESS_PAUSE) as unknown as number;
  }

  private async writeAddress(): Promise<void> {
    const number = ++this.n_addresses;
    const fragment = await fragmentOf(this.shared());
    if (number === this.n_addresses) history.replaceState(null, "", `#${fragment}`);
  }

  private showGallery(): void {
    const sheet = gallery(this.folder.examples, (name) => this.openExample(name));
    document.body.append(sheet);
    sheet.addEventListener("close", () => sheet.remove());
    sheet.showModal();
  }

  private deliver(files: [string, ArrayBuffer][]): void {
    const [path, bytes] = files[0];
    if (files.length === 1) save(path.replace(/^.*\//, ""), new Blob([bytes]));
    else save(this.script.replace(/\.geo$/, ".zip"), zip(files));
  }

  private download(name: string): void {
    const bytes = this.folder.bytes(name);
    if (bytes) save(name, new Blob([bytes]));
  }

  /** Shows where the one definition that was chosen stands in the script. */
  private reveal(app: App, paths: ReadonlySet<string>): void {
    const chosen = app.doc.items().filter((item) => paths.has(item.path));
    const [first] = chosen;
    if (first?.span && chosen.every(({ definition }) => definition === first.definition)) this.editor.reveal(first.span.line, first.span.column);
  }

  private changeSides(): void {
    if (this.editor.view.hasFocus) this.app?.canvas.focus();
    else this.editor.view.focus();
  }
}

function save(name: string, blob: Blob): void {
  const link = el("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** A name that a script may have in the folder: without folders of its own, and with the ending of scripts. */
function scriptName(wanted: string): string {
  const name = wanted.replace(/^.*[\\/]/, "").slice(0, 100) || "script";
  return isScript(name) ? name : `${name}.geo`;
}

function messageOf(trouble: unknown): string {
  return trouble instanceof Error ? trouble.message : String(trouble);
}

function remember(name: string): void {
  try {
    localStorage.setItem(LAST, name);
  } catch {
    // Without storage the next visit begins with an example.
  }
}

function remembered(): string | null {
  try {
    return localStorage.getItem(LAST);
  } catch {
    return null;
  }
}
