// The model tree: definitions with what they are and how large, lists that unfold; only the rows in sight exist.

import type { Item } from "../door/door";
import type { Document } from "../model/document";
import type { Stage } from "../view/stage";
import { colorOf, cssOf } from "../view/theme";
import { button, el, renew, say, section, type Section } from "./dom";
import { icon } from "./icons";

const ROW_HEIGHT = 24;
/** Rows beyond the visible ones, so that a quick scroll finds them there. */
const N_SPARE = 8;

interface Row {
  label: string;
  items: Item[];
  /** The list that this row opens, or null for a single thing. */
  list: string | null;
  depth: number;
  /** What its only item, or all of them together are. */
  form: string;
}

export class TreePanel {
  readonly section: Section = section("model", "Model");
  readonly find: HTMLInputElement = el("input", {
    type: "search",
    placeholder: "Find",
    class: "find",
    "aria-label": "Find a definition",
  });
  private readonly scroll = el("div", { class: "tree", role: "tree", tabindex: "0" });
  private readonly space = el("div", { class: "tree-space" });
  private readonly open = new Set<string>();
  private rows: Row[] = [];
  private lastClicked = -1;

  constructor(
    private readonly doc: Document,
    private readonly stage: Stage,
  ) {
    this.scroll.append(this.space);
    this.section.body.append(this.find, this.scroll);
    this.find.addEventListener("input", () => this.rebuild());
    this.scroll.addEventListener("scroll", () => this.draw());
    this.scroll.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.draw()).observe(this.scroll);
    doc.listed.watch(() => this.rebuild());
    doc.choices.follow(() => this.draw());
    doc.selection.follow(() => this.reveal());
  }

  /** Repaints, for another theme. */
  draw(): void {
    const first = Math.max(0, Math.floor(this.scroll.scrollTop / ROW_HEIGHT) - N_SPARE);
    const last = Math.min(this.rows.length, first + Math.ceil(this.scroll.clientHeight / ROW_HEIGHT) + 2 * N_SPARE);
    this.space.style.height = `${this.rows.length * ROW_HEIGHT}px`;
    renew(this.space, this.rows.slice(first, last).map((row, i) => this.drawRow(row, first + i)));
  }

  private rebuild(): void {
    const items = this.doc.items();
    const wanted = this.find.value.trim().toLowerCase();
    const groups = new Map<string, Item[]>();
    for (const item of items) {
      if (wanted && !matches(item, wanted)) continue;
      const group = groups.get(item.definition);
      if (group) group.push(item);
      else groups.set(item.definition, [item]);
    }
    this.rows = [];
    for (const [definition, group] of groups) {
      const isList = group.length > 1 || group[0].path !== definition;
      const whole = group[0].owner?.path === definition ? group[0].owner.kind : "list";
      const form = isList ? whole : formOf(group[0]);
      this.rows.push({ label: definition, items: group, list: isList ? definition : null, depth: 0, form });
      if (isList && (this.open.has(definition) || wanted)) this.unfold(definition, group, 1, wanted !== "");
    }
    const n_hidden = items.filter((item) => !this.doc.isVisible(item)).length;
    say(this.section.note, items.length === 0 ? "" : n_hidden > 0 ? `${items.length}, ${n_hidden} hidden` : String(items.length));
    this.scroll.classList.toggle("empty", items.length === 0);
    this.draw();
  }

  /** Rows of what stands below one: pieces, and regions and solids that unfold into theirs. */
  private unfold(above: string, items: Item[], depth: number, areAllOpen: boolean): void {
    const label = (path: string): string => (path.startsWith(above) ? path.slice(above.length) || path : path);
    for (let i = 0; i < items.length; ) {
      const { owner } = items[i];
      let end = i + 1;
      if (!owner || owner.path === above) {
        this.rows.push({ label: label(items[i].path), items: [items[i]], list: null, depth, form: formOf(items[i]) });
      } else {
        while (end < items.length && items[end].owner?.path === owner.path) end++;
        const parts = items.slice(i, end);
        this.rows.push({ label: label(owner.path), items: parts, list: owner.path, depth, form: owner.kind });
        if (this.open.has(owner.path) || areAllOpen) this.unfold(owner.path, parts, depth + 1, areAllOpen);
      }
      i = end;
    }
  }

  /** A row by its number: what it was made of may be another one when it is clicked, if that looks alike. */
  private drawRow(row: Row, index: number): HTMLElement {
    const { items } = row;
    const [item] = items;
    const isVisible = items.some((one) => this.doc.isVisible(one));
    const isSelected = items.every((one) => this.doc.selection.value.has(one.path));
    const swatch = el("span", { class: "swatch" });
    swatch.style.background = cssOf(colorOf(item, this.stage.palette));
    const fold = row.list
      ? button(icon("chevron"), "Unfold the list", (event) => {
          event.stopPropagation();
          this.toggle(this.rows[index].list!);
        }, { class: `fold${this.open.has(row.list) ? " open" : ""}`, tabindex: "-1" })
      : el("span", { class: "fold" });
    const eye = button(icon(isVisible ? "eye" : "eyeOff"), isVisible ? "Hide" : "Show", (event) => {
      event.stopPropagation();
      this.doc.show(this.rows[index].items.map((one) => one.path), !isVisible);
    }, { class: "eye", tabindex: "-1" });
    const line = el(
      "div",
      {
        class: `tree-row depth-${row.depth}${isVisible ? "" : " invisible"}`,
        role: "treeitem",
        "aria-selected": String(isSelected),
        title: describe(row),
        "data-path": row.list ?? item.path,
      },
      fold,
      el("span", { class: "kind" }, icon(item.kind)),
      swatch,
      el("span", { class: "name" }, row.label),
      item.layer && el("span", { class: "layer" }, item.layer),
      el("span", { class: "size" }, size(row)),
      eye,
    );
    line.style.top = `${index * ROW_HEIGHT}px`;
    line.addEventListener("click", (event) => this.click(this.rows[index], index, event));
    line.addEventListener("dblclick", () => this.stage.fit(true));
    return line;
  }

  private click(row: Row, index: number, event: MouseEvent): void {
    if (event.shiftKey && this.lastClicked >= 0) {
      const [a, b] = [Math.min(index, this.lastClicked), Math.max(index, this.lastClicked)];
      this.doc.select(this.rows.slice(a, b + 1).flatMap((one) => one.items.map((item) => item.path)));
    } else {
      this.doc.select(row.items.map((item) => item.path), event.ctrlKey || event.metaKey);
      this.lastClicked = index;
    }
  }

  private key(event: KeyboardEvent): void {
    const step = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    const row = this.rows[this.lastClicked];
    if (step !== 0) {
      event.preventDefault();
      this.lastClicked = Math.max(0, Math.min(this.rows.length - 1, this.lastClicked + step));
      const next = this.rows[this.lastClicked];
      if (next) this.doc.select(next.items.map((item) => item.path));
    } else if (row?.list && (event.key === "ArrowRight" || event.key === "ArrowLeft")) {
      event.preventDefault();
      if (this.open.has(row.list) !== (event.key === "ArrowRight")) this.toggle(row.list);
    }
  }

  private toggle(list: string): void {
    if (!this.open.delete(list)) this.open.add(list);
    this.rebuild();
  }

  /** Scrolls the first selected row into sight, unfolding its list. */
  private reveal(): void {
    const selected = this.doc.selected();
    const [first] = selected;
    if (first && selected.length === 1) {
      const above = [first.definition, first.owner?.path ?? ""].filter((path) => path && path !== first.path);
      if (above.some((path) => !this.open.has(path))) {
        for (const path of above) this.open.add(path);
        this.rebuild();
      }
      const index = this.rows.findIndex((row) => !row.list && row.items[0].path === first.path);
      const top = index * ROW_HEIGHT;
      const { scrollTop, clientHeight } = this.scroll;
      if (index >= 0 && (top < scrollTop || top + ROW_HEIGHT > scrollTop + clientHeight)) {
        this.scroll.scrollTop = top - clientHeight / 2;
      }
      if (index >= 0) this.lastClicked = index;
    }
    this.draw();
  }
}

/** How many things of the script these items are: a solid is one. */
function elements(items: Item[]): number {
  return new Set(items.map((item) => item.owner?.path ?? item.path)).size;
}

function formOf(item: Item): string {
  return item.form ?? item.kind;
}

function matches(item: Item, wanted: string): boolean {
  return [item.path, item.kind, formOf(item), item.owner?.kind ?? "", item.layer ?? ""].some((text) => text.toLowerCase().includes(wanted));
}

/** The size of a row in a word: of a list its length, of a surface degree and net. */
function size({ items, list, form }: Row): string {
  if (form === "solid" || form === "region") return form;
  if (list) return `${elements(items)}`;
  const { degree, points, triangles } = items[0].facts;
  if (degree) return String(degree).replace(" x ", "×");
  if (triangles) return `${short(Number(triangles))} △`;
  return points ? `${short(Number(points))} pt` : "";
}

function describe({ items, list, label, form }: Row): string {
  const [item] = items;
  if (form === "solid") return `${list}: a solid of ${items.length === 1 ? "one face" : `${items.length} faces`}`;
  if (list) return form === "region" ? `${list}: a region` : `${label}: a list of ${elements(items)}`;
  const { facts } = item;
  const parts = [
    `${item.path}: ${form}`,
    facts.degree && `degree ${facts.degree}`,
    facts.controlPoints && `${facts.controlPoints} control points`,
    facts.triangles && `${facts.triangles} triangles drawn`,
    item.kind === "points" && facts.points && `${facts.points} points`,
    item.layer && `layer ${item.layer}`,
    item.span && `line ${item.span.line}`,
  ];
  return parts.filter(Boolean).join(" · ");
}

function short(n: number): string {
  if (n >= 1e6) return `${(n / 1e6).toFixed(1)}M`;
  return n >= 1e4 ? `${Math.round(n / 1e3)}k` : String(n);
}
