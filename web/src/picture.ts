// The picture as a PNG: what is seen, on the background of the page, with marks over the model, and the legend where there is one.

import type { App } from "./app";
import { el } from "./panels/dom";

/** Paints what is seen onto a canvas of its own. */
export function paintPicture(app: App): HTMLCanvasElement {
  const seen = app.stage.snapshot();
  const picture = el("canvas", { width: seen.width, height: seen.height });
  const context = picture.getContext("2d")!;
  const style = getComputedStyle(app.canvas.parentElement!);
  const ground = context.createLinearGradient(0, 0, 0, picture.height);
  ground.addColorStop(0, style.getPropertyValue("--ground-top"));
  ground.addColorStop(1, style.getPropertyValue("--ground-bottom"));
  context.fillStyle = ground;
  context.fillRect(0, 0, picture.width, picture.height);
  context.drawImage(seen, 0, 0);
  const ratio = seen.width / seen.clientWidth;
  context.scale(ratio, ratio);
  const over = app.canvas.parentElement!;
  for (const shape of over.querySelectorAll<SVGElement>(".marks > *")) paintShape(context, shape);
  for (const legend of over.querySelectorAll<HTMLElement>(".legend:not([hidden])")) paintLegend(context, legend, over);
  for (const caption of over.querySelectorAll<HTMLElement>(".scale, .stripes-caption, .mark-label")) paintCaption(context, caption, over);
  return picture;
}

/** Where an element stands over the picture. */
function frameIn(element: Element, over: HTMLElement): DOMRect {
  const [frame, from] = [element.getBoundingClientRect(), over.getBoundingClientRect()];
  return new DOMRect(frame.x - from.x, frame.y - from.y, frame.width, frame.height);
}

/** The text of an element in its own font and colour, in the middle of its height. */
function paintText(context: CanvasRenderingContext2D, element: HTMLElement, over: HTMLElement, text = element.textContent ?? ""): void {
  const { x, y, height } = frameIn(element, over);
  const style = getComputedStyle(element);
  context.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
  context.fillStyle = style.color;
  context.textBaseline = "middle";
  context.fillText(text, x + (parseFloat(style.paddingLeft) || 0), y + height / 2);
}

function paintBox(context: CanvasRenderingContext2D, element: Element, over: HTMLElement, fill: string | CanvasGradient): void {
  const { x, y, width, height } = frameIn(element, over);
  context.beginPath();
  context.roundRect(x, y, width, height, parseFloat(getComputedStyle(element).borderTopLeftRadius) || 0);
  context.fillStyle = fill;
  context.fill();
}

/** A mark over the model, such as the ring of a claim, as its style has it; what only follows the pointer is left out. */
function paintShape(context: CanvasRenderingContext2D, shape: SVGElement): void {
  const path = pathOf(shape);
  if (!path) return;
  const style = getComputedStyle(shape);
  context.save();
  context.lineCap = style.strokeLinecap as CanvasLineCap;
  if (style.fill !== "none") {
    context.globalAlpha = Number(style.fillOpacity);
    context.fillStyle = style.fill;
    context.fill(path);
  }
  if (style.stroke !== "none") {
    context.globalAlpha = Number(style.strokeOpacity);
    context.strokeStyle = style.stroke;
    context.lineWidth = parseFloat(style.strokeWidth);
    context.setLineDash((style.strokeDasharray.match(/[\d.]+/g) ?? []).map(Number));
    context.stroke(path);
  }
  context.restore();
}

function pathOf(shape: SVGElement): Path2D | null {
  const path = new Path2D();
  if (shape instanceof SVGCircleElement) path.arc(shape.cx.baseVal.value, shape.cy.baseVal.value, shape.r.baseVal.value, 0, 2 * Math.PI);
  else if (shape instanceof SVGPolygonElement) {
    for (const { x, y } of shape.points) path.lineTo(x, y);
    path.closePath();
  } else if (shape instanceof SVGLineElement) {
    path.moveTo(shape.x1.baseVal.value, shape.y1.baseVal.value);
    path.lineTo(shape.x2.baseVal.value, shape.y2.baseVal.value);
  } else return null;
  return path;
}

/** The legend without its buttons: the bar with its ends, or the classes. */
function paintLegend(context: CanvasRenderingContext2D, legend: HTMLElement, over: HTMLElement): void {
  paintBox(context, legend, over, getComputedStyle(legend).backgroundColor);
  const isSeen = (element: HTMLElement): boolean => element.offsetParent !== null;
  for (const bar of legend.querySelectorAll<HTMLElement>(".legend-bar")) {
    if (!isSeen(bar)) continue;
    const { y, height } = frameIn(bar, over);
    const colors = getComputedStyle(bar).backgroundImage.match(/rgb\([^)]*\)/g) ?? [];
    const ramp = context.createLinearGradient(0, y + height, 0, y);
    colors.forEach((color, i) => ramp.addColorStop(colors.length > 1 ? i / (colors.length - 1) : 0, color));
    paintBox(context, bar, over, ramp);
  }
  for (const swatch of legend.querySelectorAll<HTMLElement>(".legend-swatch")) {
    if (isSeen(swatch)) paintBox(context, swatch, over, getComputedStyle(swatch).backgroundColor);
  }
  for (const text of legend.querySelectorAll<HTMLElement>(".legend-title, .legend-middle")) {
    if (isSeen(text)) paintText(context, text, over);
  }
  for (const end of legend.querySelectorAll<HTMLInputElement>(".legend-end")) {
    if (isSeen(end)) paintText(context, end, over, end.value);
  }
  for (const row of legend.querySelectorAll<HTMLElement>(".legend-class")) {
    if (!isSeen(row)) continue;
    const { x, y, height } = frameIn(row, over);
    const style = getComputedStyle(row);
    context.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    context.fillStyle = style.color;
    context.textBaseline = "middle";
    context.fillText(row.textContent ?? "", x + 19, y + height / 2);
  }
}

/** A line of text over the model, and the line of the scale bar. */
function paintCaption(context: CanvasRenderingContext2D, caption: HTMLElement, over: HTMLElement): void {
  const { display, backgroundColor } = getComputedStyle(caption);
  if (caption.hidden || display === "none") return;
  paintBox(context, caption, over, backgroundColor);
  for (const line of caption.querySelectorAll<HTMLElement>(".scale-line")) {
    const { x, y, width, height } = frameIn(line, over);
    context.strokeStyle = getComputedStyle(line).color;
    context.lineWidth = 1.25;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x, y + height);
    context.lineTo(x + width, y + height);
    context.lineTo(x + width, y);
    context.stroke();
  }
  for (const text of caption.children.length > 0 ? caption.querySelectorAll<HTMLElement>("span, output") : [caption]) {
    paintText(context, text as HTMLElement, over);
  }
}

export function savePicture(app: App): void {
  const name = (app.doc.state.value?.script ?? "model").replace(/^.*[\\/]/, "").replace(/\.[^.]*$/, "");
  paintPicture(app).toBlob((blob) => {
    if (!blob) return app.doc.tell("the browser gave no picture", true);
    const link = el("a", { href: URL.createObjectURL(blob), download: `${name}.png` });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
    app.doc.tell(`Saved: ${name}.png`);
  });
}
