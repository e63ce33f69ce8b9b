// What is known of the place that was clicked, of two such places together, and of the selection.

import type { Answer, Box, Item, Measurable, Owner, Vector } from "../door/door";
import type { Document, Hit } from "../model/document";
import { button, coordinate, copy, el, figure, section, type Section } from "./dom";
import { icon } from "./icons";

/** Names that fit the panel. */
const SHORT: Record<string, string> = {
  k1: "k1, least curvature",
  k2: "k2, greatest curvature",
  gauss: "Gaussian curvature",
  mean: "Mean curvature",
  umbilic: "Umbilic point",
  d1: "Direction of k1",
  d2: "Direction of k2",
  tangent: "Tangent",
  curvature: "Curvature",
  radius: "Radius",
  torsion: "Torsion",
};

export class FactsPanel {
  readonly section: Section = section("facts", "Selection");
  private readonly place = el("div", { class: "facts place" });
  private readonly pair = el("div", { class: "facts pair" });
  private readonly chosen = el("div", { class: "facts chosen" });
  private readonly hint = el("p", { class: "hint" }, "Click the model: the kernel answers for that very point.");

  constructor(private readonly doc: Document) {
    this.section.body.append(this.hint, this.place, this.pair, this.chosen);
    doc.hit.watch(() => this.show());
    doc.marks.follow(() => this.show());
    doc.selection.follow(() => this.show());
    doc.listed.follow(() => this.show());
    doc.isMeasuring.follow(() => this.show());
  }

  /** The diagonal of the model; 0 where it has none. */
  private size(): number {
    return sizeOf(this.doc.state.value?.bounds);
  }

  private show(): void {
    const hit = this.doc.hit.value;
    const items = this.doc.selected();
    this.place.replaceChildren(...(hit ? this.placeRows(hit) : []));
    this.pair.replaceChildren(...this.pairRows());
    this.chosen.replaceChildren(...(items.length > 0 ? this.itemRows(items) : []));
    this.hint.hidden = hit !== null || items.length > 0 || this.doc.isMeasuring.value;
    this.section.note.textContent =
      items.length === 1 ? items[0].path : items.length > 1 ? this.together(items) : (hit?.path ?? "");
  }

  private placeRows(hit: Hit): Node[] {
    const unit = this.doc.state.value?.unit ?? "";
    const { answer } = hit;
    const nodes: Node[] = [this.expression(hit)];
    nodes.push(row("Point", places(answer?.point ?? hit.point, this.size()), unit));
    if (hit.snapped) nodes.push(row("Snapped to", hit.snapped));
    const normal = answer?.normal ?? hit.normal;
    if (normal) nodes.push(row(isOnCut(hit) ? "Normal of the section" : hit.item.kind === "mesh" ? "Normal of the triangle" : "Normal", triple(normal, 4)));
    if (hit.item.kind === "mesh" && hit.triangle !== null) nodes.push(row("Triangle", String(hit.triangle)));
    for (const fact of answer?.facts ?? []) {
      const isVector = Array.isArray(fact.value);
      const label = SHORT[fact.name ?? ""] ?? fact.label;
      nodes.push(row(label, isVector ? triple(fact.value as Vector, 4) : fact.text));
    }
    if (hit.trouble) nodes.push(el("p", { class: "hint trouble" }, hit.trouble));
    else if (!answer) {
      nodes.push(el("p", { class: "hint" }, isOnCut(hit) ? "A place on the section plane, within what is closed." : this.whence(hit)));
    }
    return nodes;
  }

  /** Where a place comes from that the kernel has not answered. */
  private whence({ item, parameters }: Hit): string {
    if (parameters) return this.doc.door.canEvaluate ? "Asking the kernel …" : "From the triangles of the picture.";
    if (item.kind === "mesh") return "A mesh has triangles and no parameters: this is the point on its triangle.";
    return item.kind === "points" ? "A point of the script." : "A place on the drawn line.";
  }

  /** The expression that gives this point in a script, to be copied. */
  private expression(hit: Hit): HTMLElement {
    const text = expressionOf(hit);
    const copier = button(icon("copy"), "Copy the expression (Y)", () => {
      void copy(text).then((isDone) => isDone && this.doc.tell(`Copied: ${text}`));
    }, { class: "tool" });
    return el("div", { class: "expression" }, el("code", { title: text }, text), copier);
  }

  private pairRows(): Node[] {
    const { isMeasuring, marks, state } = this.doc;
    if (!isMeasuring.value && marks.value.length < 2) return [];
    const unit = state.value?.unit ?? "";
    if (marks.value.length < 2) {
      return [el("p", { class: "hint" }, marks.value.length === 0 ? "Measure: click the first point." : "Click the second point.")];
    }
    const [a, b] = marks.value;
    const { distance, delta, angle } = measurement(a, b);
    const rows = [row("Distance", coordinate(distance, this.size()), unit), row("Δ x, y, z", places(delta, this.size()), unit)];
    if (angle !== null) rows.push(row("Angle of normals", `${figure(angle, 6)}°`));
    return [el("h4", {}, "Two points"), ...rows];
  }

  private itemRows(items: Item[]): Node[] {
    const nodes: Node[] = [];
    if (items.length === 1) {
      const [item] = items;
      const { facts } = item;
      nodes.push(el("h4", {}, `${item.form ?? item.kind} ${item.path}`));
      const known: [string, unknown][] = [
        ["Degree", facts.degree],
        ["Control points", facts.controlPoints],
        [item.kind === "mesh" ? "Triangles" : "Triangles drawn", item.form === "region" ? null : facts.triangles],
        ["Points", item.kind === "points" ? facts.points : null],
        ["Layer", item.layer],
        ["Line", item.span?.line],
      ];
      for (const [label, value] of known) if (value || value === 0) nodes.push(row(label, String(value)));
    } else nodes.push(el("h4", {}, this.together(items)));
    if (this.doc.door.canEvaluate) {
      nodes.push(this.measures(items));
      const owner = items.length === 1 && items[0].owner?.kind === "solid" ? items[0].owner : null;
      if (owner) nodes.push(this.whole(owner));
    }
    return nodes;
  }

  /** What these items are together: one region or solid, or so many items. */
  private together(items: Item[]): string {
    const { owner } = items[0];
    const isOne = owner && items.every((item) => item.owner?.path === owner.path);
    const parts = isOne ? this.doc.items().filter((item) => item.owner?.path === owner.path).length : 0;
    return owner && parts === items.length ? `${owner.kind} ${owner.path}` : `${items.length} items`;
  }

  /** The solid that a face belongs to. */
  private whole(owner: Owner): HTMLElement {
    const parts = this.doc.items().filter((item) => item.owner?.path === owner.path);
    const select = button(`${owner.kind} ${owner.path}`, "Select all of it", () => this.doc.select(parts.map((part) => part.path)), { class: "plain" });
    return el("div", { class: "owner" }, el("h4", {}, "Part of ", select), this.measures(parts));
  }

  private measures(selected: Item[]): HTMLElement {
    const items = measured(selected);
    const kinds = measurables(items);
    const results = el("div", {});
    const ask = async (kind: Measurable): Promise<void> => {
      const found = await this.doc.attempt(this.doc.door.measure(kind, items.map((item) => item.key)));
      if (!found) return;
      results.querySelector(`[data-measure=${kind}]`)?.remove();
      const line = row(kind[0].toUpperCase() + kind.slice(1), found.text);
      line.dataset.measure = kind;
      results.append(line);
    };
    const buttons = kinds.map((kind) =>
      button(kind[0].toUpperCase() + kind.slice(1), `Exact ${kind} of the selection`, () => void ask(kind), { class: "plain", "data-ask": kind }),
    );
    return el("div", {}, el("div", { class: "row actions" }, ...buttons), results);
  }
}

/** What is measured of a selection: of a region its area, and not the borders with it. */
function measured(items: Item[]): Item[] {
  const regions = new Set(items.filter((item) => item.form === "region").map((item) => item.path));
  return items.filter((item) => item.kind !== "curve" || !regions.has(item.owner?.path ?? ""));
}

/** What can be asked of all these items together. */
function measurables(items: Item[]): Measurable[] {
  const are = (...kinds: string[]): boolean => items.every((item) => kinds.includes(item.kind));
  if (are("curve", "polyline")) return ["length"];
  if (!are("surface", "mesh")) return [];
  return items.some((item) => item.form === "region") ? ["area"] : ["area", "volume"];
}

/** Whether a place lies on a filled cut. */
function isOnCut({ item, parameters, triangle }: Hit): boolean {
  return (item.kind === "surface" || item.kind === "mesh") && !parameters && triangle === null;
}

/** What a script writes for this point. */
export function expressionOf(hit: Hit): string {
  const { answer, item, parameters } = hit;
  if (answer?.expression) return answer.expression;
  if (item.form === "point") return item.path;
  if (item.form === "points" && typeof hit.index === "number") return `${item.path}[${hit.index}]`;
  if (!parameters) return `(${rounded(pointOf(hit)).join(", ")})`;
  if ("vertex" in parameters) return `(${pointOf(hit).join(", ")})`;
  const at = "u" in parameters ? [parameters.u, parameters.v] : [parameters.t];
  return `${item.path}(${at.map((value) => Number(value.toPrecision(6))).join(", ")})`;
}

/** A place in as many digits as the single precision of the picture has. */
function rounded(point: Vector): number[] {
  const unit = 10 ** (Math.floor(Math.log10(Math.max(...point.map(Math.abs), 1e-300))) - 6);
  return point.map((value) => Number((Math.round(value / unit) * unit).toPrecision(7)) + 0);
}

/** Distance and difference of two places, with the angle between their normals in degrees. */
export function measurement(a: Hit, b: Hit): { distance: number; delta: Vector; angle: number | null } {
  const [p, q] = [pointOf(a), pointOf(b)];
  const delta: Vector = [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
  const [m, n] = [directionOf(a.answer, a), directionOf(b.answer, b)];
  let angle: number | null = null;
  if (m && n) {
    const cosine = (m[0] * n[0] + m[1] * n[1] + m[2] * n[2]) / (Math.hypot(...m) * Math.hypot(...n));
    angle = (Math.acos(Math.max(-1, Math.min(1, cosine))) * 180) / Math.PI;
  }
  return { distance: Math.hypot(...delta), delta, angle };
}

export function pointOf(hit: Hit): Vector {
  return hit.answer?.point ?? hit.point;
}

/** The normal of a surface or the tangent of a curve there. */
function directionOf(answer: Answer | null, hit: Hit): Vector | null {
  const tangent = answer?.facts.find((fact) => fact.label.toLowerCase() === "tangent")?.value;
  return answer?.normal ?? hit.normal ?? (Array.isArray(tangent) ? tangent : null);
}

function row(label: string, value: string, unit = ""): HTMLElement {
  return el(
    "div",
    { class: "fact" },
    el("span", { class: "fact-label" }, label),
    el("span", { class: "fact-value" }, value.replace(/(^|[\s(e])-/g, "$1−"), unit && el("small", {}, ` ${unit}`)),
  );
}

/** The diagonal of a box. */
export function sizeOf(box: Box | null | undefined): number {
  return box ? Math.hypot(...box[0].map((least, i) => box[1][i] - least)) : 0;
}

/** Coordinates in a model of this size. */
function places(vector: Vector, size: number): string {
  return vector.map((value) => coordinate(value, size)).join("  ");
}

function triple(vector: Vector, n_digits: number): string {
  // What is below the last digit of the largest is no figure of its own.
  const least = Math.max(...vector.map(Math.abs)) * 10 ** -n_digits;
  return vector.map((value) => figure(Math.abs(value) < least ? 0 : value, n_digits)).join("  ");
}
