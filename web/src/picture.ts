// The picture as a PNG: what is seen, on the background of the page, with the legend where there is one.

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
  context.fillStyle = style.color;
  context.font = "12px system-ui, sans-serif";
  const legend = app.canvas.parentElement!.querySelector<HTMLElement>(".legend:not([hidden])");
  const title = legend?.querySelector(".legend-title")?.textContent ?? "";
  const ends = [...(legend?.querySelectorAll<HTMLInputElement>(".legend-end") ?? [])].map((end) => end.value);
  const isMap = legend !== null && !["draft", "sides"].includes(legend.dataset.shade ?? "");
  if (title) context.fillText(isMap ? `${title}: ${ends[1]} … ${ends[0]}` : title, 16, seen.clientHeight - 16);
  return picture;
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
