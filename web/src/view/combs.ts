// Curvature combs: teeth along the curvature vector, turned outward, and the line through their tips.

import type { Buffers } from "../model/bytes";

/** Ends of the teeth at every `stride`-th vertex and of the outline through all tips. */
export function combEnds(line: Float32Array, comb: Float32Array, scale: number, stride: number): Float32Array {
  const n = Math.min(line.length, comb.length) / 3;
  const tip = (i: number, k: number): number => line[3 * i + k] - scale * comb[3 * i + k];
  const ends: number[] = [];
  for (let i = 0; i < n; i++) {
    const isKnown = Number.isFinite(comb[3 * i] + comb[3 * i + 1] + comb[3 * i + 2]);
    if (!isKnown) continue;
    if (i % stride === 0 || i === n - 1) {
      for (let k = 0; k < 3; k++) ends.push(line[3 * i + k]);
      for (let k = 0; k < 3; k++) ends.push(tip(i, k));
    }
    if (i + 1 < n && Number.isFinite(comb[3 * i + 3])) {
      for (let k = 0; k < 3; k++) ends.push(tip(i, k));
      for (let k = 0; k < 3; k++) ends.push(tip(i + 1, k));
    }
  }
  return new Float32Array(ends);
}

/** The combs of all isocurves whose curvature came along. */
export function isocombEnds({ isocurves, isocombs }: Buffers, scale: number, stride: number): Float32Array {
  const combs = isocombs.map((comb, i) => combEnds(isocurves[i], comb, scale, stride));
  const all = new Float32Array(combs.reduce((n, comb) => n + comb.length, 0));
  let at = 0;
  for (const comb of combs) {
    all.set(comb, at);
    at += comb.length;
  }
  return all;
}

/** The greatest curvature of a comb, 0 where there is none. */
export function greatestCurvature(buffers: Buffers): number {
  let most = 0;
  for (const comb of buffers.comb ? [buffers.comb] : buffers.isocombs) {
    for (let i = 0; i + 2 < comb.length; i += 3) {
      const k = Math.hypot(comb[i], comb[i + 1], comb[i + 2]);
      if (Number.isFinite(k) && k > most) most = k;
    }
  }
  return most;
}
