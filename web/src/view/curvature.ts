// The range of a map that a legend begins with: that of the visible surfaces without their outliers.

import type { Buffers } from "../model/bytes";
import type { Shade } from "../model/settings";

export type CurvatureShade = "gauss" | "mean" | "k1" | "k2";
/** What is shown by colours between two numbers. */
export type MapShade = CurvatureShade | "deviation";
const N_SAMPLES = 20_000;
/** Share of the samples that may lie outside on either side. */
const TAIL = 0.02;

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

/** Least and greatest of what the legend shows, about zero where both signs occur. */
export function curvatureRange(all: Iterable<Buffers>, shade: CurvatureShade): [number, number] {
  const samples: number[] = [];
  const buffers = [...all].filter((one) => one.curvatures);
  const n_values = buffers.reduce((n, one) => n + one.curvatures!.length / 2, 0);
  const step = Math.max(1, Math.floor(n_values / N_SAMPLES));
  for (const { curvatures } of buffers) {
    for (let i = 0; i < curvatures!.length; i += 2 * step) {
      const value = valueOf(shade, curvatures![i], curvatures![i + 1]);
      if (Number.isFinite(value)) samples.push(value);
    }
  }
  if (samples.length === 0) return [-1, 1];
  samples.sort((a, b) => a - b);
  const at = (share: number): number => samples[Math.round(share * (samples.length - 1))];
  const reach = Math.max(Math.abs(at(TAIL)), Math.abs(at(1 - TAIL)));
  if (!(reach > 0)) return [-1, 1];
  return [-rounded(reach), rounded(reach)];
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
