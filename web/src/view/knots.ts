// Where the knots lie: lines u = knot and v = knot through the triangles of a surface, points of a curve.

import type { Buffers } from "../model/bytes";

/** Segments on the mesh along which u or v is a knot inside the domain. */
export function knotLines(buffers: Buffers): Float32Array {
  const { knots, positions, parameters, triangles } = buffers;
  if (!knots || !("u" in knots) || !positions || !parameters || !triangles) return new Float32Array(0);
  const ends: number[] = [];
  for (const [axis, values] of [inner(knots.u), inner(knots.v)].entries()) {
    for (let t = 0; t < triangles.length; t += 3) {
      const corners = [triangles[t], triangles[t + 1], triangles[t + 2]];
      const at = corners.map((i) => parameters[2 * i + axis]);
      const least = Math.min(...at);
      const most = Math.max(...at);
      for (const knot of values) {
        if (knot >= least && knot <= most) ends.push(...crossing(positions, corners, at, knot));
      }
    }
  }
  return new Float32Array(ends);
}

/** Points of a curve at its knots, the ends too. */
export function knotPoints(buffers: Buffers): Float32Array {
  const { knots, parameters, edges } = buffers;
  if (!knots || !("t" in knots) || !parameters || edges.length === 0) return new Float32Array(0);
  const line = edges[0];
  const points: number[] = [];
  for (const knot of new Set(knots.t)) {
    for (let i = 0; i + 1 < parameters.length; i++) {
      if (knot < parameters[i] || knot > parameters[i + 1]) continue;
      const span = parameters[i + 1] - parameters[i];
      const share = span > 0 ? (knot - parameters[i]) / span : 0;
      for (let k = 0; k < 3; k++) points.push(line[3 * i + k] * (1 - share) + line[3 * i + 3 + k] * share);
      break;
    }
  }
  return new Float32Array(points);
}

/** The distinct knots but the first and the last. */
function inner(knots: number[]): number[] {
  return [...new Set(knots)].sort((a, b) => a - b).slice(1, -1);
}

/** The segment in a triangle where the parameter has that value; nothing where it only touches. */
function crossing(positions: Float32Array, corners: number[], at: number[], knot: number): number[] {
  const value = Math.fround(knot);
  const ends: number[] = [];
  const on = corners.filter((_, k) => at[k] === value);
  if (on.length === 2) return on.flatMap((i) => [...positions.subarray(3 * i, 3 * i + 3)]);
  for (let k = 0; k < 3; k++) {
    const [a, b] = [at[k], at[(k + 1) % 3]];
    if (a === b || (value - a) * (value - b) > 0 || value === b) continue;
    const share = (value - a) / (b - a);
    const [i, j] = [corners[k], corners[(k + 1) % 3]];
    for (let c = 0; c < 3; c++) ends.push(positions[3 * i + c] * (1 - share) + positions[3 * j + c] * share);
  }
  return ends.length === 6 ? ends : [];
}
