// Colours of the picture, light and dark. Those of the page are in the style sheet.

import { Color } from "three";

import type { Item } from "../door/door";

export interface Palette {
  isDark: boolean;
  ink: Color;
  edge: Color;
  isocurve: Color;
  curve: Color;
  surface: Color;
  point: Color;
  accent: Color;
  faded: Color;
  red: Color;
  green: Color;
  blue: Color;
  comb: Color;
  net: Color;
  knot: Color;
  normal: Color;
  ghost: Color;
}

/** A colour as it is written, without conversion: the shaders compute in shown colours. */
export function raw(hex: number): Color {
  return new Color(((hex >> 16) & 255) / 255, ((hex >> 8) & 255) / 255, (hex & 255) / 255);
}

export const LIGHT: Palette = {
  isDark: false,
  ink: raw(0x1c2330),
  edge: raw(0x202733),
  isocurve: raw(0x3a4656),
  curve: raw(0x1f4e79),
  surface: raw(0xb4bfcb),
  point: raw(0x1f4e79),
  accent: raw(0xe0702a),
  faded: raw(0xd9dde2),
  red: raw(0xc8443a),
  green: raw(0x4c9a3f),
  blue: raw(0x3a6fd0),
  comb: raw(0x9a3fb0),
  net: raw(0x8a5a14),
  knot: raw(0x0f7a68),
  normal: raw(0x3a6fd0),
  ghost: raw(0x5b6f8f),
};

export const DARK: Palette = {
  isDark: true,
  ink: raw(0xdfe5ee),
  edge: raw(0x0b0f15),
  isocurve: raw(0x161d27),
  curve: raw(0x8cc4f2),
  surface: raw(0xa3b0bf),
  point: raw(0x8cc4f2),
  accent: raw(0xff9a4d),
  faded: raw(0x2a3038),
  red: raw(0xe8685c),
  green: raw(0x74c365),
  blue: raw(0x6c9cf5),
  comb: raw(0xd58be6),
  net: raw(0xe6b35c),
  knot: raw(0x4fd1b5),
  normal: raw(0x6c9cf5),
  ghost: raw(0x8fa5c6),
};

/** The colour that the script gave, or the palette's for its kind. */
export function colorOf(item: Item, palette: Palette): Color {
  if (item.color) {
    const [r, g, b] = item.color;
    return new Color(r / 255, g / 255, b / 255);
  }
  if (item.kind === "surface" || item.kind === "mesh") return palette.surface;
  return item.kind === "points" ? palette.point : palette.curve;
}

/** The colour as the style sheets write it. */
export function cssOf({ r, g, b }: Color): string {
  return `rgb(${[r, g, b].map((part) => Math.round(part * 255)).join(" ")})`;
}
