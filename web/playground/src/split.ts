// The border between the editor and the picture: dragged, or moved by keys, and kept for the next visit.

import { el } from "../../src/panels/dom";

const STORE = "virote-split";
const [LEAST, FIRST, MOST] = [15, 38, 85];

/** Both parts side by side, or one over the other where the window is narrow. */
export function split(first: HTMLElement, second: HTMLElement): HTMLElement {
  const border = el("div", { class: "split-border", role: "separator", tabindex: "0", "aria-label": "Width of the editor", "aria-valuemin": LEAST, "aria-valuemax": MOST });
  const root = el("div", { class: "split" }, first, border, second);
  let share = FIRST;
  const put = (next: number): void => {
    share = Math.min(Math.max(next, LEAST), MOST);
    root.style.setProperty("--split", `${share}%`);
    border.setAttribute("aria-valuenow", String(Math.round(share)));
  };
  const keep = (): void => {
    try {
      localStorage.setItem(STORE, String(share));
    } catch {
      // Without storage it begins anew at the next visit.
    }
  };
  border.addEventListener("pointerdown", (event) => {
    border.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  border.addEventListener("pointermove", (event) => {
    if (!border.hasPointerCapture(event.pointerId)) return;
    const frame = root.getBoundingClientRect();
    const isStacked = getComputedStyle(root).flexDirection === "column";
    put(isStacked ? (100 * (event.clientY - frame.top)) / frame.height : (100 * (event.clientX - frame.left)) / frame.width);
  });
  border.addEventListener("pointerup", keep);
  border.addEventListener("dblclick", () => (put(FIRST), keep()));
  border.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -2, ArrowUp: -2, ArrowRight: 2, ArrowDown: 2 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    put(share + step);
    keep();
  });
  let kept = FIRST;
  try {
    kept = Number(localStorage.getItem(STORE)) || FIRST;
  } catch {
    // Likewise.
  }
  put(kept);
  return root;
}
