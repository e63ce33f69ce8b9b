// The legend of a curvature map: its ends are dragged or typed, and the map follows.

import type { Document } from "../model/document";
import type { SettingsSignal } from "../model/settings";
import type { DeviationMap } from "../model/deviation";
import { isCurvature, isMap, type MapShade } from "../view/curvature";
import type { Stage } from "../view/stage";
import { button, el, figure } from "./dom";

const NAMES: Record<MapShade, string> = {
  deviation: "Deviation",
  gauss: "Gaussian curvature",
  mean: "Mean curvature",
  k1: "Principal curvature k1",
  k2: "Principal curvature k2",
};
const DRAFT_CLASSES = [
  ["positive", "draft at least"],
  ["between", "steeper than"],
  ["negative", "undercut beyond"],
] as const;

export function legend(doc: Document, stage: Stage, settings: SettingsSignal, deviation: DeviationMap): HTMLElement {
  const title = el("div", { class: "legend-title" });
  const most = end("most", "Greatest value: drag or type");
  const least = end("least", "Least value: drag or type");
  const middle = el("span", { class: "legend-middle" });
  const auto = button("Auto", "Fit the range to the model", () => stage.range.set(automatic()), { class: "plain small" });
  const both = button("±", "The same range on both sides of zero", () => {
    const reach = Math.max(Math.abs(stage.range.value.least), Math.abs(stage.range.value.most));
    stage.range.set({ least: -reach, most: reach, isAutomatic: false });
  }, { class: "plain small" });
  const bar = el("div", { class: "legend-bar" }, el("span", { class: "grip top" }), el("span", { class: "grip bottom" }));
  const scale = el("div", { class: "legend-scale" }, bar, el("div", { class: "legend-ends" }, most, middle, least));
  const classes = el("div", { class: "legend-classes" });
  const root = el("div", { class: "legend", hidden: true }, title, scale, classes, el("div", { class: "legend-tools" }, auto, both));
  const automatic = (): { least: number; most: number; isAutomatic: boolean } => {
    const { shade } = settings.value;
    const [low, high] = isMap(shade) ? stage.automaticRange(shade) : [-1, 1];
    return { least: low, most: high, isAutomatic: true };
  };
  const show = (): void => {
    const { shade, draftDegrees } = settings.value;
    const unit = doc.state.value?.unit ?? "";
    root.hidden = !isMap(shade) && shade !== "draft" && shade !== "sides";
    root.dataset.shade = shade;
    if (isMap(shade)) {
      const { of, from } = deviation.value;
      title.textContent = isCurvature(shade) ? `${NAMES[shade]} in 1/${unit}${shade === "gauss" ? "²" : ""}` : `Deviation of ${of} from ${from} in ${unit}`;
      const { value } = stage.range;
      if (document.activeElement !== most) most.value = figure(value.most);
      if (document.activeElement !== least) least.value = figure(value.least);
      middle.textContent = figure((value.least + value.most) / 2);
    } else if (shade === "draft") {
      title.textContent = `Draft along ${settings.value.draftAxis}`;
      classes.replaceChildren(...DRAFT_CLASSES.map(([name, text]) => classRow(name, `${text} ${draftDegrees}°`)));
    } else {
      title.textContent = "Sides";
      classes.replaceChildren(classRow("outward", "front (along the normal)"), classRow("inward", "back"));
    }
  };
  settings.follow(({ shade }) => {
    if (root.dataset.shade !== shade && isMap(shade)) stage.range.set(automatic());
  });
  settings.watch(show);
  stage.range.follow(show);
  deviation.follow(show);
  doc.listed.follow(show);
  dragEnds(bar, stage);
  for (const [field, which] of [[most, "most"], [least, "least"]] as const) {
    field.addEventListener("change", () => {
      const value = Number(field.value.replaceAll("−", "-"));
      const range = { ...stage.range.value, [which]: value, isAutomatic: false };
      if (Number.isFinite(value) && range.least < range.most) stage.range.set(range);
      field.blur();
      show();
    });
  }
  return root;
}

function end(name: string, title: string): HTMLInputElement {
  return el("input", { type: "text", class: "legend-end", "data-end": name, title, "aria-label": title });
}

function classRow(name: string, text: string): HTMLElement {
  return el("div", { class: "legend-class" }, el("span", { class: `legend-swatch ${name}` }), text);
}

/** A drag in the upper half of the bar scales the greatest value, in the lower half the least. */
function dragEnds(bar: HTMLElement, stage: Stage): void {
  bar.addEventListener("pointerdown", (down) => {
    bar.setPointerCapture(down.pointerId);
    const frame = bar.getBoundingClientRect();
    const isTop = down.clientY < frame.top + frame.height / 2;
    const from = stage.range.value;
    const span = from.most - from.least;
    const move = (event: PointerEvent): void => {
      const share = (event.clientY - down.clientY) / frame.height;
      const most = isTop ? from.least + span * Math.exp(2 * share) : from.most;
      const least = isTop ? from.least : from.most - span * Math.exp(-2 * share);
      stage.range.set({ least, most, isAutomatic: false });
    };
    bar.addEventListener("pointermove", move);
    bar.addEventListener("lostpointercapture", () => bar.removeEventListener("pointermove", move), { once: true });
  });
}
