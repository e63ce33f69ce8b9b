// What the browser can do while it still reads the page's script: fetch the model, and make the canvas with what draws on it.

import type { Door } from "./door/door";
import { EmbeddedDoor } from "./door/embedded";
import { HttpDoor } from "./door/http";
import { Document } from "./model/document";
import { el } from "./panels/dom";

/** What is under way for the page's script. */
export interface Begun {
  readonly doc: Document;
  readonly canvas: HTMLCanvasElement;
}

declare global {
  interface Window {
    ahead?: Begun;
  }
}

/** How the picture is to be drawn: smooth edges take a buffer of their own, and not the canvas's. */
export const DRAWING = { antialias: false, alpha: true, stencil: true, powerPreference: "high-performance" } as const;

/** Begins the page, unless that is done. */
export function begin(): Begun {
  return (window.ahead ??= begunWith(EmbeddedDoor.find() ?? new HttpDoor(token())));
}

/** Begins with this door. */
export function begunWith(door: Door): Begun {
  const doc = new Document(door);
  doc.fetchAhead();
  const canvas = el("canvas", { class: "canvas", "aria-label": "The model", tabindex: "0" });
  // Whoever asks again has the same; that there is none is told then.
  canvas.getContext("webgl2", DRAWING);
  return { doc, canvas };
}

/** The token that the server put into the address. */
function token(): string {
  return new URLSearchParams(location.search).get("token") ?? "";
}
