// How the surface is shaded, what the combs measure and where the section stands.

import type { Document } from "../model/document";
import type { DeviationMap } from "../model/deviation";
import type { Settings, SettingsSignal, Shade } from "../model/settings";
import type { Stage } from "../view/stage";
import { sectionDistance } from "../view/section";
import { button, el, figure, section, type Section, segmented, slider } from "./dom";

const SHADES: readonly (readonly [Shade, string, string])[] = [
  ["plain", "Plain", "The colours of the script"],
  ["zebra", "Zebra", "Reflected stripes: breaks show breaks of tangents, kinks show breaks of curvature"],
  ["isophotes", "Isophotes", "Lines of equal angle to the light"],
  ["gauss", "Gauss", "Gaussian curvature, k1 · k2: zero where the surface unrolls"],
  ["mean", "Mean", "Mean curvature, (k1 + k2) / 2"],
  ["k1", "k1", "First principal curvature"],
  ["k2", "k2", "Second principal curvature"],
  ["draft", "Draft", "Angle to the direction of pull"],
  ["sides", "Sides", "Fronts and backs by the direction of the normals"],
  ["deviation", "Deviation", "Distance of one definition from another"],
];

export const isStriped = (shade: Shade): boolean => shade === "zebra" || shade === "isophotes";

/** Which stripes are seen: those of the shader, or the kernel's curves. */
export function stripesTold({ exact }: Stage, shade: Shade): string {
  const { lines, isWaiting, without, trouble } = exact.value;
  if (!exact.isWanted) return "By the shader, from the mesh’s normals.";
  if (isWaiting) return "By the shader, until the kernel has answered …";
  if (trouble) return trouble;
  if (lines.size === 0 && without.length === 0) return "There is no surface in sight.";
  const meshes = without.length > 0 ? `A mesh has no exact borders: ${without.join(", ")}.` : "";
  const seen = shade === "zebra" ? ", seen along parallel rays" : "";
  return lines.size === 0 ? meshes : `Exact borders by the kernel${seen}. ${meshes}`.trim();
}

export class LookPanel {
  readonly section: Section = section("look", "Analysis");
  readonly cutSection: Section = section("section", "Section");

  constructor(
    private readonly doc: Document,
    private readonly stage: Stage,
    private readonly settings: SettingsSignal,
    private readonly deviation: DeviationMap,
  ) {
    this.buildShades();
    this.buildDeviation();
    this.buildShell();
    this.buildStripes();
    this.buildDraft();
    this.buildCombs();
    this.buildCut();
  }

  private buildShades(): void {
    const shades = SHADES.filter(([shade]) => shade !== "deviation" || this.doc.door.canEvaluate);
    const buttons = shades.map(([shade, label, title]) =>
      button(label, title, () => this.settings.put({ shade }), { "data-shade": shade }),
    );
    const accuracy = el("p", { class: "hint accuracy" });
    this.section.body.append(el("div", { class: "shades" }, ...buttons), accuracy);
    this.settings.watch(({ shade }) => {
      for (const one of buttons) one.setAttribute("aria-pressed", String(one.dataset.shade === shade));
      accuracy.textContent =
        shade === "deviation"
          ? "Measured by the kernel at each vertex to the nearest place; negative behind the other’s normals."
          : "From the mesh’s exact normals and curvatures at its vertices; a click asks the kernel.";
      accuracy.hidden = shade === "plain" || isStriped(shade);
      this.section.note.textContent = shade === "plain" ? "" : (SHADES.find(([name]) => name === shade)?.[1] ?? "");
    });
  }

  /** Of which definition, from which other, and what it came to. */
  private buildDeviation(): void {
    const { deviation, settings } = this;
    const of = el("select", { class: "value", "aria-label": "Measured definition", "data-deviation": "of" });
    const from = el("select", { class: "value", "aria-label": "Definition to measure from", "data-deviation": "from" });
    const told = el("p", { class: "hint deviation-told" });
    const rows = [el("label", { class: "row" }, el("span", {}, "Of"), of), el("label", { class: "row" }, el("span", {}, "From"), from), told];
    this.section.body.append(...rows);
    of.addEventListener("change", () => settings.put({ deviationOf: of.value }));
    from.addEventListener("change", () => settings.put({ deviationFrom: from.value }));
    const show = (): void => {
      const isOn = settings.value.shade === "deviation";
      for (const one of rows) one.hidden = !isOn;
      if (!isOn) return;
      const chosen = deviation.pair();
      [of, from].forEach((select, i) => {
        select.replaceChildren(...deviation.definitions().map((name) => el("option", { value: name }, name)));
        select.value = chosen[i];
      });
      const { isWaiting, trouble } = deviation.value;
      const figures = deviation.figures();
      const unit = this.doc.state.value?.unit ?? "";
      const text = figures ? `From ${figure(figures.least)} to ${figure(figures.most)} ${unit}, on average ${figure(figures.mean)} ${unit} away.` : "";
      told.textContent = trouble ?? (isWaiting ? "Measuring …" : text);
      told.classList.toggle("trouble", trouble !== null);
    };
    settings.watch(show);
    deviation.follow(show);
    this.doc.listed.follow(show);
  }

  /** How long the edges are at which a shell is open, and at which its parts meet. */
  private buildShell(): void {
    const text = el("p", { class: "hint shell-told" });
    this.section.body.append(text);
    this.stage.shell.lengths.watch((lengths) => {
      text.hidden = lengths === null;
      if (!lengths) return;
      const unit = this.doc.state.value?.unit ?? "";
      if (lengths.open + lengths.shared + lengths.crowded === 0) {
        text.textContent = "Nothing is open: the edges of each item meet one another.";
        return;
      }
      const parts = [`Open edges (red) ${figure(lengths.open)} ${unit}`, `shared (green) ${figure(lengths.shared)} ${unit}`];
      if (lengths.crowded > 0) parts.push(`of more than two faces (purple) ${figure(lengths.crowded)} ${unit}`);
      text.textContent = `${parts.join(", ")}.`;
    });
  }

  private buildStripes(): void {
    const count = slider("Stripes", [2, 60, 1], String, (stripes) => this.settings.put({ stripes }));
    const way = segmented("Run", [["no", "level"], ["yes", "upright"]], (value) =>
      this.settings.put({ stripesAcross: value === "yes" }),
    );
    const light = segmented("Light from", [["view", "eye"], ["x", "x"], ["y", "y"], ["z", "z"]], (value) =>
      this.settings.put({ light: value }),
    );
    const exact = segmented("Drawn by", [["no", "shader"], ["yes", "kernel"]], (value) =>
      this.settings.put({ exactStripes: value === "yes" }),
    );
    exact.root.dataset.setting = "exact-stripes";
    way.root.dataset.setting = "stripes-run";
    const told = el("p", { class: "hint stripes-told" });
    this.section.body.append(exact.root, told, count.root, way.root, light.root);
    const tell = (): void => {
      told.hidden = !isStriped(this.settings.value.shade);
      told.textContent = stripesTold(this.stage, this.settings.value.shade);
      told.classList.toggle("trouble", this.stage.exact.value.trouble !== null);
    };
    this.stage.exact.follow(tell);
    this.settings.watch(({ shade, stripes, stripesAcross, exactStripes, light: from }) => {
      count.root.hidden = !isStriped(shade);
      exact.root.hidden = !isStriped(shade) || !this.doc.door.canEvaluate;
      exact.set(exactStripes ? "yes" : "no");
      tell();
      way.root.hidden = shade !== "zebra";
      light.root.hidden = shade !== "isophotes";
      count.set(stripes);
      way.set(stripesAcross ? "yes" : "no");
      light.set(from);
    });
  }

  private buildDraft(): void {
    const pull = segmented("Pull", [["x", "x"], ["y", "y"], ["z", "z"]], (draftAxis) => this.settings.put({ draftAxis }));
    const angle = slider("Draft", [0, 30, 0.5], (degrees) => `${degrees}°`, (draftDegrees) =>
      this.settings.put({ draftDegrees }),
    );
    this.section.body.append(pull.root, angle.root);
    this.settings.watch(({ shade, draftAxis, draftDegrees }) => {
      pull.root.hidden = angle.root.hidden = shade !== "draft";
      pull.set(draftAxis);
      angle.set(draftDegrees);
    });
  }

  private buildCombs(): void {
    const count = slider("Isocurves", [1, 31, 1], String, (isocurveCount) => this.settings.put({ isocurveCount }));
    count.root.dataset.setting = "isocurve-count";
    const of = segmented("Combs of", [["all", "all"], ["selection", "selection"]], (combsOf) => this.settings.put({ combsOf }));
    of.root.dataset.setting = "combs-of";
    const scale = slider("Comb", [-1.5, 1.5, 0.05], (power) => `× ${figure(10 ** power, 2)}`, (power) =>
      this.settings.put({ combScale: 10 ** power }),
    );
    const stride = slider("Spacing", [1, 16, 1], (n) => (n === 1 ? "every" : `${n}th`), (combStride) =>
      this.settings.put({ combStride }),
    );
    scale.root.dataset.setting = "comb-scale";
    stride.root.dataset.setting = "comb-spacing";
    const told = el("p", { class: "hint combs-told" }, "Select a curve or a surface to see its comb.");
    this.section.body.append(count.root, of.root, scale.root, stride.root, told);
    const tell = (): void => {
      const { combs, combsOf } = this.settings.value;
      told.hidden = !combs || combsOf === "all" || this.doc.selection.value.size > 0;
    };
    this.doc.selection.follow(tell);
    this.settings.watch(({ combs, combsOf, isocurves, isocurveCount, combScale, combStride }) => {
      scale.root.hidden = stride.root.hidden = of.root.hidden = !combs;
      // How many lines there are is the kernel's to change.
      count.root.hidden = !(combs || isocurves) || !this.doc.door.canEvaluate;
      count.set(isocurveCount);
      of.set(combsOf);
      tell();
      scale.set(Math.log10(combScale));
      stride.set(combStride);
    });
  }

  private buildCut(): void {
    const { body, note, root } = this.cutSection;
    const axis = segmented("Across", [["x", "x"], ["y", "y"], ["z", "z"], ["free", "view"]], (sectionAxis) => {
      const [, , back] = this.stage.rig.axes();
      this.settings.put({ sectionAxis, sectionNormal: back.toArray() });
    });
    const place = slider("Place", [0, 1, 0.001], (share) => this.placeText(share), (sectionPlace) =>
      this.settings.put({ sectionPlace }),
    );
    place.root.dataset.setting = "section-place";
    const flip = button("Other side", "Show what is cut away", () => this.settings.toggle("sectionFlip"), { class: "plain" });
    const filled = el("p", { class: "hint cut-told" });
    body.append(axis.root, place.root, el("div", { class: "row actions" }, flip), filled);
    this.stage.caps.sets.watch((sets) => {
      const is = (names: string[], what: string): string => `${names.join(", ")} ${names.length === 1 ? "is" : "are"} ${what}`;
      const parts = sets ? [sets.filled.length > 0 ? `${is(sets.filled, "closed")}.` : "", sets.open.length > 0 ? `${is(sets.open, "open, and not filled")}.` : ""] : [];
      filled.textContent = parts.filter(Boolean).join(" ");
    });
    const show = (settings: Settings): void => {
      root.hidden = !settings.section;
      axis.set(settings.sectionAxis);
      place.set(settings.sectionPlace);
      note.textContent = settings.section ? this.placeText(settings.sectionPlace) : "";
    };
    this.settings.watch(show);
    this.doc.listed.follow(() => show(this.settings.value));
  }

  private placeText(sectionPlace: number): string {
    const box = this.stage.box();
    if (box.isEmpty()) return "";
    const distance = sectionDistance({ ...this.settings.value, sectionPlace }, box);
    return `${figure(distance)} ${this.doc.state.value?.unit ?? ""}`;
  }
}
