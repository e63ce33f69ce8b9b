// The parameters of the script: a control each that fits its declaration, alive while it is dragged.

import type { Import, ImportedParameter, Parameter, State, Values } from "../door/door";
import type { Document } from "../model/document";
import { button, copy, el, renew, say, section, type Section } from "./dom";
import { icon } from "./icons";

/** A drag waits so long for what became of its last value before it sends the next, in milliseconds. */
const PATIENCE = 400;

interface Control {
  root: HTMLElement;
  shape: string;
  show(parameter: Parameter): void;
}

export class ParameterPanel {
  readonly section: Section = section("parameters", "Parameters");
  private readonly controls = new Map<string, Control>();
  private readonly sender: Sender;
  private readonly empty = el("p", { class: "hint" });
  private readonly imports = el("div", { class: "imports" });

  constructor(private readonly doc: Document) {
    this.sender = new Sender(doc);
    const all: [HTMLButtonElement, boolean][] = [
      [button(icon("copy"), "Copy the changed values as --set", () => void this.copyAll(), { class: "tool" }), false],
      [button(icon("write"), "Write the changed values into the script", () => void this.write(), { class: "tool", "data-do": "write" }), true],
      [button(icon("reset"), "Reset all to the script's values", () => void doc.attempt(doc.door.set({ reset: true })), { class: "tool", "data-do": "reset" }), true],
    ];
    for (const [tool, needsDoor] of all) if (!needsDoor || doc.door.canEvaluate) this.section.tools.append(tool);
    doc.listed.watch((state) => state && this.show(state));
  }

  private show(state: State): void {
    const { body, note } = this.section;
    const n_set = state.parameters.filter((one) => one.isSet).length;
    say(note, n_set > 0 ? `${n_set} changed` : "");
    this.section.root.classList.toggle("has-changes", n_set > 0);
    const names = new Set(state.parameters.map((one) => one.name));
    for (const [name, { root }] of this.controls) {
      if (names.has(name)) continue;
      root.remove();
      this.controls.delete(name);
    }
    state.parameters.forEach((parameter, i) => {
      let control = this.controls.get(parameter.name);
      const shape = shapeOf(parameter);
      if (control?.shape !== shape) {
        control?.root.remove();
        control = this.make(parameter, shape);
        this.controls.set(parameter.name, control);
      }
      // A control that is held keeps what the hand says.
      if (body.children[i] !== control.root) body.insertBefore(control.root, body.children[i] ?? null);
      control.show(parameter);
    });
    // Of a script that never was whole nobody has read them.
    say(this.empty, state.isCurrent ? "The script has no param." : "The parameters are shown once the script is whole.");
    if (names.size === 0) body.append(this.empty);
    else this.empty.remove();
    body.append(this.imports);
    renew(this.imports, (state.imports ?? []).map((one) => imported(one, names)));
  }

  private make(parameter: Parameter, shape: string): Control {
    const { name } = parameter;
    const send = (text: string | null, isLast: boolean): void => this.sender.send(name, text, isLast);
    const input = this.input(parameter, send);
    const reset = button(icon("reset"), "Reset", () => send(null, true), { class: "tool reset" });
    const label = el("span", { class: "parameter-label" }, parameter.label ?? name);
    const tip = [parameter.label && name, parameter.docs, rangeText(parameter)].filter(Boolean).join("\n");
    const root = el("div", { class: `parameter ${parameter.kind}`, "data-parameter": name, title: tip });
    root.append(el("div", { class: "parameter-head" }, label, input.field, reset));
    if (input.track) root.append(input.track);
    if (!this.doc.door.canEvaluate) for (const one of root.querySelectorAll("input, select, button")) one.setAttribute("disabled", "");
    return {
      root,
      shape,
      show: (now) => {
        root.classList.toggle("is-set", now.isSet);
        reset.title = `Reset to ${now.default}`;
        if (!root.classList.contains("held")) input.show(now);
      },
    };
  }

  private input(parameter: Parameter, send: (text: string, isLast: boolean) => void): Input {
    if (parameter.kind === "bool") return checkbox(send);
    if (parameter.choices && parameter.choices.length > 0) return choice(parameter.choices, send);
    const field = text(send);
    const { least, most, number } = parameter;
    if (least === null || most === null || number === null || !(most > least)) return field;
    return withTrack(parameter, field, send);
  }

  private changed(): Parameter[] {
    return (this.doc.state.value?.parameters ?? []).filter((one) => one.isSet);
  }

  private async copyAll(): Promise<void> {
    const chosen = this.changed().length > 0 ? this.changed() : (this.doc.state.value?.parameters ?? []);
    const command = chosen.map(({ name, value }) => `--set ${quoted(`${name}=${value}`)}`).join(" ");
    if (await copy(command)) this.doc.tell(`Copied: ${command}`);
  }

  private async write(): Promise<void> {
    const values: Values = Object.fromEntries(this.changed().map(({ name, value }) => [name, value]));
    if (Object.keys(values).length === 0) return this.doc.tell("Nothing is changed.");
    const written = await this.doc.attempt(this.doc.door.write(values));
    if (written) this.doc.tell(`Written into the script: ${written.join(", ")}`);
  }
}

/** The parameters of an imported file: to be read, since the script says what they are. */
function imported({ path, line, parameters }: Import, own: ReadonlySet<string>): HTMLElement {
  const rows = parameters.map((one) => importedRow(one, own));
  return el("div", { class: "import", "data-import": path }, el("h4", { title: `line ${line}` }, path), ...rows);
}

function importedRow({ name, label, docs, given, line, ...its }: ImportedParameter, own: ReadonlySet<string>): HTMLElement {
  const title = [label && name, docs, its.allowed].filter(Boolean).join("\n");
  const value = el("code", {}, given ?? its.default);
  // What is a parameter of the script has its control above.
  const whence = given === null ? "its default" : own.has(given) ? `by ${given}, line ${line}` : `given in line ${line}`;
  return el("div", { class: "imported", "data-imported": name, title }, el("span", {}, label ?? name), value, el("small", {}, whence));
}

interface Input {
  field: HTMLElement;
  track?: HTMLElement;
  show(parameter: Parameter): void;
}

function checkbox(send: (text: string, isLast: boolean) => void): Input {
  const field = el("input", { type: "checkbox", class: "switch" });
  field.addEventListener("change", () => send(String(field.checked), true));
  return { field, show: (now) => (field.checked = now.value === "true") };
}

function choice(choices: string[], send: (text: string, isLast: boolean) => void): Input {
  const field = el("select", {}, ...choices.map((word) => el("option", { value: word }, word)));
  field.addEventListener("change", () => send(field.value, true));
  return {
    field,
    show: (now) => {
      const word = now.value.replace(/^"(.*)"$/, "$1");
      field.value = choices.includes(now.value) ? now.value : word;
    },
  };
}

function text(send: (text: string, isLast: boolean) => void): Input & { field: HTMLInputElement } {
  const field = el("input", { type: "text", class: "value", spellcheck: "false", autocomplete: "off" });
  let shown = "";
  field.addEventListener("change", () => field.value !== shown && send(field.value.replaceAll("−", "-"), true));
  field.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      field.value = shown;
      field.blur();
    }
  });
  return {
    field,
    show: (now) => {
      shown = now.value;
      if (document.activeElement !== field) field.value = shown;
    },
  };
}

/** A slider over the range beside the field. */
function withTrack(
  parameter: Parameter,
  field: Input & { field: HTMLInputElement },
  send: (text: string, isLast: boolean) => void,
): Input {
  const [least, most] = [parameter.least!, parameter.most!];
  const unit = parameter.unit ?? "";
  const step = parameter.step ?? finestep(most - least);
  const track = el("input", { type: "range", min: least, max: most, step, "aria-label": parameter.label ?? parameter.name });
  const fill = (): void => track.style.setProperty("--share", String((track.valueAsNumber - least) / (most - least)));
  const spelled = (): string => `${Number(track.valueAsNumber.toPrecision(12))}${unit}`;
  const hold = (isHeld: boolean): void => {
    track.closest(".parameter")?.classList.toggle("held", isHeld);
  };
  track.addEventListener("pointerdown", () => hold(true));
  for (const end of ["pointerup", "pointercancel", "blur"] as const) track.addEventListener(end, () => hold(false));
  track.addEventListener("input", () => {
    fill();
    field.field.value = spelled();
    send(spelled(), false);
  });
  track.addEventListener("change", () => send(spelled(), true));
  return {
    field: field.field,
    track,
    show: (now) => {
      field.show(now);
      if (now.number !== null) track.valueAsNumber = now.number;
      fill();
    },
  };
}

/** Sends the newest values: those that follow as soon as these are evaluated, while they are drawn. What a newer one overtakes is never sent. */
class Sender {
  private waiting: Values = {};
  private isUnderWay = false;

  constructor(private readonly doc: Document) {}

  send(name: string, value: string | null, isLast: boolean): void {
    this.waiting[name] = value;
    if (!this.isUnderWay) void this.run();
    else if (isLast) void this.flush();
  }

  private async run(): Promise<void> {
    this.isUnderWay = true;
    while (Object.keys(this.waiting).length > 0) {
      const { version } = this.doc;
      await this.flush();
      await Promise.race([this.doc.passed(version), new Promise((done) => setTimeout(done, PATIENCE))]);
    }
    this.isUnderWay = false;
  }

  private async flush(): Promise<void> {
    const values = this.waiting;
    this.waiting = {};
    if (Object.keys(values).length > 0) await this.doc.attempt(this.doc.door.set({ values }));
  }
}

/** What decides which control a parameter needs. */
function shapeOf(parameter: Parameter): string {
  const { kind, label, docs, unit, least, most, step, choices } = parameter;
  return JSON.stringify([kind, label, docs, unit, least, most, step, choices, parameter.number === null]);
}

function rangeText({ least, most, step, unit }: Parameter): string {
  if (least === null && most === null) return "";
  const u = unit ?? "";
  return `${least ?? "…"}${u} to ${most ?? "…"}${u}${step === null ? "" : ` in steps of ${step}${u}`}`;
}

/** A round step of about a four-hundredth of the range. */
function finestep(range: number): number {
  return 10 ** Math.floor(Math.log10(range / 100));
}

/** As a shell reads one word. */
function quoted(word: string): string {
  return /^[\w=.,:+@%/-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}
