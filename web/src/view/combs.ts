// Curvature combs: teeth along the curvature vector, turned outward, and the line through their tips.

import type { Buffers } from "../model/bytes";
import type { Isocurves } from "../model/isocurves";

/** Ends of the teeth at every `stride`-th vertex and of the outline through all tips. */
export function combEnds(line: Float32Array, comb: Float32Array, scale: number, stride: number): Float32Array {
  const n = Math.min(line.length, comb.length) / 3;
  const ends = new Float32Array(12 * n);
  let at = 0;
  const put = (i: number, isTip: boolean): void => {
    for (let k = 3 * i; k < 3 * i + 3; k++) ends[at++] = isTip ? line[k] - scale * comb[k] : line[k];
  };
  const isKnown = (i: number): boolean => Number.isFinite(comb[3 * i] + comb[3 * i + 1] + comb[3 * i + 2]);
  for (let i = 0; i < n; i++) {
    if (!isKnown(i)) continue;
    if (i % stride === 0 || i === n - 1) {
      put(i, false);
      put(i, true);
    }
    if (i + 1 < n && isKnown(i + 1)) {
      put(i, true);
      put(i + 1, true);
    }
  }
  return ends.subarray(0, at);
}

/** The combs of all isocurves whose curvature came along. */
export function isocombEnds({ isocurves, isocombs }: Isocurves, scale: number, stride: number): Float32Array {
  const combs = isocombs.map((comb, i) => combEnds(isocurves[i], comb, scale, stride));
  const all = new Float32Array(combs.reduce((n, comb) => n + comb.length, 0));
  let at = 0;
  for (const comb of combs) {
    all.set(comb, at);
    at += comb.length;
  }
  return all;
}

/** The greatest curvature of each comb that was asked for, as long as its buffers are there. */
const known = new WeakMap<Buffers, number>();

/** The greatest curvature of a comb, 0 where there is none. */
export function greatestCurvature(buffers: Buffers): number {
  let most = known.get(buffers);
  if (most !== undefined) return most;
  most = 0;
  for (const comb of buffers.comb ? [buffers.comb] : buffers.isocombs) {
    for (let i = 0; i + 2 < comb.length; i += 3) {
      const k = Math.hypot(comb[i], comb[i + 1], comb[i + 2]);
      if (Number.isFinite(k) && k > most) most = k;
    }
  }
  known.set(buffers, most);
  return most;
}
