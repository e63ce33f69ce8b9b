// The edges of a mesh that an eye would draw: open ones, and those where its faces meet at an angle.

import type { Buffers } from "../model/bytes";

/** Faces whose normals are farther apart than this, as a cosine (25°), meet at a crease. */
const CREASE = Math.cos((25 * Math.PI) / 180);

/** Ends of the open and creased edges; vertices at one place count as one. */
export function creaseEnds({ positions, triangles }: Buffers): Float32Array {
  if (!positions || !triangles) return new Float32Array(0);
  const welded = weld(positions);
  const n_vertices = positions.length / 3;
  const faces = new Map<number, number>();
  const normals = faceNormals(positions, triangles);
  const ends: number[] = [];
  const draw = (edge: number): void => {
    for (const i of [Math.floor(edge / n_vertices), edge % n_vertices]) ends.push(...positions.subarray(3 * i, 3 * i + 3));
  };
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const a = welded[triangles[t + k]];
      const b = welded[triangles[t + ((k + 1) % 3)]];
      if (a === b) continue;
      const edge = Math.min(a, b) * n_vertices + Math.max(a, b);
      const other = faces.get(edge);
      if (other === undefined) {
        faces.set(edge, t);
        continue;
      }
      // An edge of more than two faces is drawn at the third.
      if (other < 0 || dot(normals, other, t) < CREASE) draw(edge);
      faces.set(edge, -1);
    }
  }
  for (const [edge, face] of faces) if (face >= 0) draw(edge);
  return new Float32Array(ends);
}

/** The first vertex at the place of each vertex. */
function weld(positions: Float32Array): Uint32Array {
  const bits = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
  const first = new Map<string, number>();
  const welded = new Uint32Array(positions.length / 3);
  for (let i = 0; i < welded.length; i++) {
    const place = `${bits[3 * i]} ${bits[3 * i + 1]} ${bits[3 * i + 2]}`;
    let found = first.get(place);
    if (found === undefined) first.set(place, (found = i));
    welded[i] = found;
  }
  return welded;
}

/** Unit normals of the faces, at the index of their first corner; of a face without area zero. */
function faceNormals(p: Float32Array, triangles: Uint32Array): Float32Array {
  const normals = new Float32Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const length = Math.hypot(x, y, z);
    if (length > 0) normals.set([x / length, y / length, z / length], t);
  }
  return normals;
}

function dot(normals: Float32Array, a: number, b: number): number {
  return normals[a] * normals[b] + normals[a + 1] * normals[b + 1] + normals[a + 2] * normals[b + 2];
}
