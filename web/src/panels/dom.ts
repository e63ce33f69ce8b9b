// Elements of the page. Every text goes through `textContent`; nothing here reads markup.

type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | null | undefined>;

/** An element with attributes and children; an attribute that is null, undefined or false is left out. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  put(made, attributes);
  append(made, children);
  return made;
}

/** The same for the elements of SVG. */
export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  put(made, attributes);
  append(made, children);
  return made;
}

/** Gives an element a text, unless it is the one that it has: what stays need not be painted again. */
export function say(element: Node, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** Gives an element these children; those that are there already, and look alike, stay. */
export function renew(parent: Element, children: Node[]): void {
  children.forEach((child, i) => {
    const old = parent.childNodes[i];
    if (!old) parent.append(child);
    else if (!old.isEqualNode(child)) old.replaceWith(child);
  });
  while (parent.childNodes.length > children.length) parent.lastChild!.remove();
}

export function put(element: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) element.removeAttribute(name);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
}

function append(parent: Element, children: Child[]): void {
  for (const child of children) if (child) parent.append(child);
}

/** A button with a text or a picture, whose title becomes its tooltip. */
export function button(
  content: Node | string,
  title: string,
  action: (event: MouseEvent) => void,
  attributes: Attributes = {},
): HTMLButtonElement {
  const made = el("button", { type: "button", title, ...attributes }, content);
  made.addEventListener("click", action);
  return made;
}

export interface Section {
  root: HTMLElement;
  body: HTMLElement;
  /** What stands in the header beside the title. */
  note: HTMLElement;
  tools: HTMLElement;
}

/** A part of a panel that folds at a click on its header, and stays so at the next visit. */
export function section(name: string, title: string): Section {
  const body = el("div", { class: "section-body" });
  const note = el("span", { class: "note" });
  const tools = el("span", { class: "tools" });
  const head = button(title, "", () => fold(!root.classList.contains("folded")), {
    class: "section-title",
    "aria-expanded": "true",
  });
  const root = el("section", { class: "section", "data-section": name }, el("header", {}, head, note, tools), body);
  const fold = (isFolded: boolean): void => {
    root.classList.toggle("folded", isFolded);
    head.setAttribute("aria-expanded", String(!isFolded));
    try {
      localStorage.setItem(`virote-fold-${name}`, isFolded ? "1" : "0");
    } catch {
      // Without storage it opens again at the next visit.
    }
  };
  try {
    if (localStorage.getItem(`virote-fold-${name}`) === "1") fold(true);
  } catch {
    // Likewise.
  }
  return { root, body, note, tools };
}

export interface Slider {
  root: HTMLElement;
  set(value: number): void;
}

/** A labelled slider of the page's own settings. */
export function slider(
  label: string,
  [least, most, step]: [number, number, number],
  format: (value: number) => string,
  change: (value: number) => void,
): Slider {
  const input = el("input", { type: "range", min: least, max: most, step, "aria-label": label });
  const shown = el("output");
  const show = (value: number): void => {
    shown.textContent = format(value);
    input.style.setProperty("--share", String((input.valueAsNumber - least) / (most - least)));
  };
  input.addEventListener("input", () => {
    show(input.valueAsNumber);
    change(input.valueAsNumber);
  });
  return {
    root: el("label", { class: "row slider" }, el("span", {}, label), input, shown),
    set(value) {
      input.valueAsNumber = value;
      // The field rounds to its steps.
      show(value);
    },
  };
}

export interface Choice<T extends string> {
  root: HTMLElement;
  set(value: T): void;
}

/** A row of buttons of which one is pressed. */
export function segmented<T extends string>(
  label: string,
  choices: readonly (readonly [T, string])[],
  change: (value: T) => void,
): Choice<T> {
  const buttons = choices.map(([value, text]) => button(text, "", () => change(value), { "data-value": value }));
  return {
    root: el("div", { class: "row" }, el("span", {}, label), el("div", { class: "segmented" }, ...buttons)),
    set(value) {
      for (const one of buttons) one.setAttribute("aria-pressed", String(one.dataset.value === value));
    },
  };
}

/** Puts a text onto the clipboard; by the old way where the new one is refused. */
export async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = el("textarea", { class: "offscreen" });
    area.value = text;
    document.body.append(area);
    area.select();
    const isDone = document.execCommand("copy");
    area.remove();
    return isDone;
  }
}

/** A number in four digits, with the minus sign of print. */
export function figure(value: number, n_digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  const text = Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-3)
    ? value.toExponential(n_digits - 2).replace("e+", "e")
    : String(Number(value.toPrecision(n_digits)));
  return text.replaceAll("-", "−");
}

/** A coordinate or distance in a model of this size: to a millionth of the size or finer, up to 1e12 without an exponent. */
export function coordinate(value: number, size: number): string {
  if (!Number.isFinite(value) || Math.abs(value) >= 1e12) return figure(value, 7);
  const nDecimals = size > 0 && Number.isFinite(size) ? Math.ceil(6 - Math.log10(size)) : 6;
  return String(Number(value.toFixed(Math.min(Math.max(nDecimals, 0), 15))) + 0).replaceAll("-", "−");
}
