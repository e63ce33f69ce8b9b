// What lies over the canvas and moves with the model: clicked places, their directions, measurements, the section's handle.

import { Vector3 } from "three";

import type { Vector } from "../door/door";
import type { Document, Hit } from "../model/document";
import type { SettingsSignal } from "../model/settings";
import { reachAlong, sectionFrame, sectionMiddle, sectionNormal } from "../view/section";
import type { Stage } from "../view/stage";
import { coordinate, el, figure, put, svg, say } from "./dom";
import { measurement, pointOf, sizeOf } from "./facts";
import { isStriped, stripesTold } from "./look";

/** Length of the drawn directions in pixels. */
const ARROW = 56;

export function overlay(doc: Document, stage: Stage, settings: SettingsSignal): HTMLElement {
  const drawing = svg("svg", { class: "marks" });
  const label = el("div", { class: "mark-label", hidden: true });
  const handle = el("button", {
    type: "button",
    class: "section-handle",
    title: "Drag to move the section",
    "aria-label": "Move the section",
    hidden: true,
  });
  const root = el("div", { class: "overlay" }, drawing, handle, label);
  dragHandle(handle, stage, settings);
  stage.afterFrame.add(() => {
    const shapes: SVGElement[] = [];
    const section = settings.value.section;
    const box = stage.box();
    handle.hidden = !section || box.isEmpty();
    if (section && !box.isEmpty()) {
      const corners = sectionFrame(settings.value, box).map((corner) => stage.rig.project(corner));
      shapes.push(svg("polygon", { class: "section-frame", points: corners.map(({ x, y }) => `${x},${y}`).join(" ") }));
      place(handle, stage.rig.project(sectionMiddle(settings.value, box)));
    }
    const marks = doc.marks.value;
    for (const mark of marks) shapes.push(dot(stage, pointOf(mark), "measured"));
    for (const point of doc.claimed()) shapes.push(...claimShapes(stage, point));
    const hit = doc.hit.value;
    if (hit && !marks.includes(hit)) shapes.push(...hitShapes(stage, hit));
    const lure = doc.lure.value;
    if (lure) shapes.push(...lureShapes(stage, lure));
    label.hidden = marks.length < 2;
    if (marks.length === 2) {
      const [a, b] = marks.map((mark) => stage.rig.project(new Vector3(...pointOf(mark))));
      shapes.unshift(svg("line", { class: "measure-line", x1: a.x, y1: a.y, x2: b.x, y2: b.y }));
      const { distance } = measurement(marks[0], marks[1]);
      label.textContent = `${coordinate(distance, sizeOf(doc.state.value?.bounds))} ${doc.state.value?.unit ?? ""}`;
      place(label, a.add(b).multiplyScalar(0.5));
    }
    if (shapes.length > 0 || drawing.firstChild) drawing.replaceChildren(...shapes);
    drawing.style.display = shapes.length > 0 ? "" : "none";
  });
  return root;
}

/** The dot of a hit with its normal, tangent and principal directions. */
function hitShapes(stage: Stage, hit: Hit): SVGElement[] {
  const point = pointOf(hit);
  const shapes: SVGElement[] = [];
  const facts = hit.answer?.facts ?? [];
  const directions: [Vector, string][] = [];
  for (const { label, value } of facts) {
    if (!Array.isArray(value)) continue;
    directions.push([value, label.toLowerCase().includes("tangent") ? "tangent" : "principal"]);
  }
  const normal = hit.answer?.normal ?? hit.normal;
  if (normal) directions.push([normal, "normal"]);
  for (const [direction, kind] of directions) {
    const length = ARROW * stage.rig.perPixel;
    const unit = new Vector3(...direction).normalize().multiplyScalar(length);
    const start = new Vector3(...point);
    const a = stage.rig.project(kind === "principal" ? start.clone().sub(unit) : start);
    const b = stage.rig.project(start.clone().add(unit));
    shapes.push(svg("line", { class: `arrow ${kind}`, x1: a.x, y1: a.y, x2: b.x, y2: b.y }));
  }
  shapes.push(dot(stage, point, "hit"));
  return shapes;
}

/** What a click would be drawn to: a square around it, and what it is. */
function lureShapes(stage: Stage, { point, snapped }: Hit): SVGElement[] {
  const { x, y } = stage.rig.project(new Vector3(...point));
  const square = (kind: string): SVGElement => svg("rect", { class: kind, x: x - 6, y: y - 6, width: 12, height: 12 });
  return [square("lure-halo"), square("lure"), svg("text", { class: "lure-name", x: x + 11, y: y - 8 }, snapped ?? "")];
}

/** A place that a failed claim tells of: a ring around it, seen through everything. */
function claimShapes(stage: Stage, point: Vector): SVGElement[] {
  const { x, y } = stage.rig.project(new Vector3(...point));
  const ring = (kind: string): SVGElement => svg("circle", { class: kind, cx: x, cy: y, r: 11 });
  return [ring("claim-halo"), ring("claim-ring"), dot(stage, point, "claimed")];
}

function dot(stage: Stage, point: Vector, kind: string): SVGElement {
  const { x, y } = stage.rig.project(new Vector3(...point));
  return svg("circle", { class: `dot ${kind}`, cx: x, cy: y, r: 4.5 });
}

function place(element: HTMLElement, { x, y }: Vector3): void {
  element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
}

/** Moves the section as far as the pointer goes along its normal on the screen. */
function dragHandle(handle: HTMLElement, stage: Stage, settings: SettingsSignal): void {
  handle.addEventListener("pointerdown", (down) => {
    handle.setPointerCapture(down.pointerId);
    const box = stage.box();
    const normal = sectionNormal(settings.value);
    const middle = sectionMiddle(settings.value, box);
    const [least, most] = reachAlong(box, normal);
    const from = stage.rig.project(middle);
    const to = stage.rig.project(middle.clone().addScaledVector(normal, 20 * stage.rig.perPixel));
    const [dx, dy] = [to.x - from.x, to.y - from.y];
    const length = dx * dx + dy * dy;
    const start = settings.value.sectionPlace;
    const move = (event: PointerEvent): void => {
      const [mx, my] = [event.clientX - down.clientX, event.clientY - down.clientY];
      // Seen along its normal the plane has no way on the screen: up and down move it then.
      const pixels = length > 16 ? (20 * (mx * dx + my * dy)) / length : -my;
      const sectionPlace = start + (pixels * stage.rig.perPixel) / Math.max(most - least, 1e-300);
      settings.put({ sectionPlace: Math.max(0, Math.min(1, sectionPlace)) });
    };
    handle.addEventListener("pointermove", move);
    handle.addEventListener("lostpointercapture", () => handle.removeEventListener("pointermove", move), { once: true });
  });
}

const AXES: [string, Vector][] = [
  ["x", [1, 0, 0]],
  ["y", [0, 1, 0]],
  ["z", [0, 0, 1]],
];
const NAMES = { x: ["right", "left"], y: ["back", "front"], z: ["top", "bottom"] } as const;

/** The three axes in a corner; a click on an end looks from there. */
export function triad(stage: Stage): SVGSVGElement {
  const root = svg("svg", { class: "triad", viewBox: "-40 -40 80 80" });
  const ends = AXES.flatMap(([name, axis]) =>
    [1, -1].map((sign) => {
      const view = NAMES[name as keyof typeof NAMES][sign === 1 ? 0 : 1];
      const line = sign === 1 ? svg("line", { class: `triad-${name}` }) : null;
      const ball = svg("circle", { r: sign === 1 ? 7.5 : 5, class: `triad-ball triad-${name}${sign === 1 ? "" : " minus"}` });
      const text = sign === 1 ? svg("text", {}, name.toUpperCase()) : null;
      const group = svg("g", { class: "triad-end", "data-view": view }, svg("title", {}, view), ball, text);
      group.addEventListener("click", () => stage.view(view));
      return { group, line, ball, text, axis: new Vector3(...axis).multiplyScalar(sign) };
    }),
  );
  let known = "";
  stage.afterFrame.add(() => {
    const { azimuth, elevation } = stage.rig.pose;
    const pose = `${azimuth} ${elevation}`;
    if (pose === known) return;
    known = pose;
    const [right, up, back] = stage.rig.axes();
    const seen = ends.map((end) => ({
      end,
      x: 29 * end.axis.dot(right),
      y: -29 * end.axis.dot(up),
      depth: end.axis.dot(back),
    }));
    seen.sort((a, b) => a.depth - b.depth);
    const parts: SVGElement[] = [];
    for (const { end, x, y } of seen) {
      if (end.line) {
        put(end.line, { x1: 0, y1: 0, x2: x, y2: y });
        parts.push(end.line);
      }
      put(end.ball, { cx: x, cy: y });
      if (end.text) put(end.text, { x, y });
      parts.push(end.group);
    }
    root.replaceChildren(...parts);
  });
  return root;
}

/** What stripes are that one sees: those of the shader or of the kernel. */
export function stripesCaption(stage: Stage, settings: SettingsSignal): HTMLElement {
  const root = el("div", { class: "stripes-caption", role: "status" });
  const tell = (): void => {
    root.hidden = !isStriped(settings.value.shade);
    root.textContent = stripesTold(stage, settings.value.shade);
  };
  stage.exact.follow(tell);
  settings.watch(tell);
  return root;
}

/** Part of the picture's width that the scale may take; where the coarse lines of the grid are farther apart, it tells the fine ones. */
const SCALE_SHARE = 0.6;

/** The distance of the grid's lines in the document's unit. */
export function scaleBar(doc: Document, stage: Stage, settings: SettingsSignal): HTMLElement {
  const bar = el("span", { class: "scale-line" });
  const text = el("span");
  const root = el("div", { class: "scale", title: "Distance of the grid’s lines" }, bar, text);
  stage.afterFrame.add(() => {
    root.hidden = !settings.value.grid;
    const { step } = stage.grid;
    const isWide = step / stage.rig.perPixel > SCALE_SHARE * stage.rig.width;
    const length = isWide ? step / 10 : step;
    const width = `${(length / stage.rig.perPixel).toFixed(1)}px`;
    if (bar.style.width !== width) bar.style.width = width;
    say(text, `${figure(length)} ${doc.state.value?.unit ?? ""}`);
  });
  return root;
}

/** Pixels that the tooth of the scale has at least. */
const LEAST_TOOTH = 28;

/** What the teeth of combs mean: a tooth as long as the bar stands for so much curvature. */
export function combScale(doc: Document, stage: Stage, settings: SettingsSignal): HTMLElement {
  const bar = el("span", { class: "scale-line" });
  const text = el("span");
  const root = el("div", { class: "scale comb-scale", title: "Length of a tooth of a comb at this curvature" }, bar, text);
  stage.afterFrame.add(() => {
    const pixels = stage.combLength.value / stage.rig.perPixel;
    root.hidden = !settings.value.combs || !(pixels > 0);
    if (root.hidden) return;
    const curvature = roundAbove(LEAST_TOOTH / pixels);
    const width = `${(curvature * pixels).toFixed(1)}px`;
    if (bar.style.width !== width) bar.style.width = width;
    const unit = doc.state.value?.unit ?? "";
    say(text, `1 tooth = ${figure(curvature)} /${unit} (radius ${figure(1 / curvature)} ${unit})`);
  });
  return root;
}

/** The next 1, 2 or 5 times a power of ten. */
function roundAbove(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return (([1, 2, 5].find((digit) => digit * power >= value * (1 - 1e-9)) ?? 10) * power);
}
