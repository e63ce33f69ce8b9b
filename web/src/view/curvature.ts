// The range of a map that a legend begins with: that of the visible surfaces without their outliers.

import type { Buffers } from "../model/bytes";
import type { Shade } from "../model/settings";

export type CurvatureShade = "gauss" | "mean" | "k1" | "k2";
/** What is shown by colours between two numbers. */
export type MapShade = CurvatureShade | "deviation";
const N_SAMPLES = 20_000;
/** Share of the area whose values may lie outside. */
const TAIL = 0.03;

export function isCurvature(shade: Shade): shade is CurvatureShade {
  return shade === "gauss" || shade === "mean" || shade === "k1" || shade === "k2";
}

export function isMap(shade: Shade): shade is MapShade {
  return isCurvature(shade) || shade === "deviation";
}

/** The greatest distance on either side of zero. */
export function deviationRange(all: Iterable<Float32Array>): [number, number] {
  let reach = 0;
  for (const values of all) for (const value of values) if (Math.abs(value) > reach && Number.isFinite(value)) reach = Math.abs(value);
  return reach > 0 ? [-rounded(reach), rounded(reach)] : [-1, 1];
}

/** Least and greatest of what the legend shows, about zero: all but a small part of the area lies between. */
export function curvatureRange(all: Iterable<Buffers>, shade: CurvatureShade): [number, number] {
  const samples: [number, number][] = [];
  const buffers = [...all].filter((one) => one.curvatures && one.positions && one.triangles);
  const n_triangles = buffers.reduce((n, one) => n + one.triangles!.length / 3, 0);
  const step = Math.max(1, Math.floor(n_triangles / N_SAMPLES));
  let whole = 0;
  for (const { curvatures, positions, triangles } of buffers) {
    for (let t = 0; t + 2 < triangles!.length; t += 3 * step) {
      const corners = [triangles![t], triangles![t + 1], triangles![t + 2]];
      const [a, b, c] = corners.map((i) => Math.abs(valueOf(shade, curvatures![2 * i], curvatures![2 * i + 1])));
      const value = (a + b + c) / 3;
      const area = areaOf(positions!, corners);
      if (!Number.isFinite(value) || !(area > 0)) continue;
      samples.push([value, area]);
      whole += area;
    }
  }
  samples.sort((a, b) => a[0] - b[0]);
  let [reach, sum] = [0, 0];
  for (const [value, area] of samples) {
    if (reach > 0 && sum > (1 - TAIL) * whole) break;
    reach = value;
    sum += area;
  }
  return reach > 0 ? [-rounded(reach), rounded(reach)] : [-1, 1];
}

/** Twice the area of a triangle. */
function areaOf(p: Float32Array, [i, j, k]: number[]): number {
  const side = (from: number, to: number): number[] => [0, 1, 2].map((axis) => p[3 * to + axis] - p[3 * from + axis]);
  const [[ux, uy, uz], [vx, vy, vz]] = [side(i, j), side(i, k)];
  return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
}

function valueOf(shade: CurvatureShade, k1: number, k2: number): number {
  if (shade === "gauss") return k1 * k2;
  if (shade === "mean") return 0.5 * (k1 + k2);
  return shade === "k1" ? k1 : k2;
}

/** The next number with two digits. */
function rounded(value: number): number {
  const unit = 10 ** (Math.floor(Math.log10(value)) - 1);
  return Math.ceil(value / unit) * unit;
}
