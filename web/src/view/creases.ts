// The edges of a mesh that an eye would draw: open ones, and those where its faces meet at an angle.

import type { Buffers } from "../model/bytes";

/** Faces whose normals are farther apart than this, as a cosine (25°), meet at a crease. */
const CREASE = Math.cos((25 * Math.PI) / 180);

/** Ends of the open and creased edges; vertices at one place count as one. */
export function creaseEnds({ positions, triangles }: Buffers): Float32Array {
  if (!positions || !triangles) return new Float32Array(0);
  const welded = weld(positions);
  const normals = faceNormals(positions, triangles);
  // A table of edges with open addressing: both ends, and the face that came first; -1 where there were two.
  const table = new EdgeTable(triangles.length);
  const found: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const a = welded[triangles[t + k]];
      const b = welded[triangles[k === 2 ? t : t + k + 1]];
      if (a === b) continue;
      const slot = a < b ? table.slot(a, b) : table.slot(b, a);
      const other = table.face[slot];
      if (other === NEW) {
        table.face[slot] = t;
        continue;
      }
      // An edge of more than two faces is drawn at the third.
      if (other < 0 || dot(normals, other, t) < CREASE) found.push(slot);
      table.face[slot] = DONE;
    }
  }
  for (let slot = 0; slot < table.face.length; slot++) if (table.face[slot] >= 0) found.push(slot);
  const ends = new Float32Array(6 * found.length);
  found.forEach((slot, i) => {
    ends.set(positions.subarray(3 * table.a[slot], 3 * table.a[slot] + 3), 6 * i);
    ends.set(positions.subarray(3 * table.b[slot], 3 * table.b[slot] + 3), 6 * i + 3);
  });
  return ends;
}

const NEW = -2;
const DONE = -1;

class EdgeTable {
  readonly a: Int32Array;
  readonly b: Int32Array;
  readonly face: Int32Array;
  private readonly mask: number;

  constructor(n_sides: number) {
    const size = powerAbove(1.4 * n_sides);
    this.mask = size - 1;
    this.a = new Int32Array(size).fill(-1);
    this.b = new Int32Array(size);
    this.face = new Int32Array(size).fill(NEW);
  }

  /** Where the edge between two vertices stands, or will. */
  slot(a: number, b: number): number {
    const { mask } = this;
    let slot = mixed(a, b, 0) & mask;
    while (this.a[slot] !== -1 && (this.a[slot] !== a || this.b[slot] !== b)) slot = (slot + 1) & mask;
    this.a[slot] = a;
    this.b[slot] = b;
    return slot;
  }
}

/** The first vertex at the place of each vertex. */
function weld(positions: Float32Array): Uint32Array {
  const bits = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
  const welded = new Uint32Array(positions.length / 3);
  const mask = powerAbove(1.4 * welded.length) - 1;
  const table = new Int32Array(mask + 1).fill(-1);
  for (let i = 0; i < welded.length; i++) {
    const x = bits[3 * i];
    const y = bits[3 * i + 1];
    const z = bits[3 * i + 2];
    let slot = mixed(x, y, z) & mask;
    let first = table[slot];
    while (first !== -1 && (bits[3 * first] !== x || bits[3 * first + 1] !== y || bits[3 * first + 2] !== z)) {
      slot = (slot + 1) & mask;
      first = table[slot];
    }
    if (first === -1) table[slot] = first = i;
    welded[i] = first;
  }
  return welded;
}

function powerAbove(n: number): number {
  return 2 ** Math.max(4, Math.ceil(Math.log2(n + 1)));
}

/** Three integers into one that tells nothing of their order. */
function mixed(x: number, y: number, z: number): number {
  let h = Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca6b) ^ Math.imul(z, 0xc2b2ae35);
  h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
  return (h ^ (h >>> 13)) >>> 0;
}

/** Unit normals of the faces, at the index of their first corner; of a face without area zero. Without lists, which would be made for every face. */
function faceNormals(p: Float32Array, triangles: Uint32Array): Float32Array {
  const normals = new Float32Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t];
    const b = 3 * triangles[t + 1];
    const c = 3 * triangles[t + 2];
    const ux = p[b] - p[a];
    const uy = p[b + 1] - p[a + 1];
    const uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a];
    const vy = p[c + 1] - p[a + 1];
    const vz = p[c + 2] - p[a + 2];
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    // No square of what a single number holds is beyond a double one.
    const length = Math.sqrt(x * x + y * y + z * z);
    if (length === 0) continue;
    normals[t] = x / length;
    normals[t + 1] = y / length;
    normals[t + 2] = z / length;
  }
  return normals;
}

function dot(normals: Float32Array, a: number, b: number): number {
  return normals[a] * normals[b] + normals[a + 1] * normals[b + 1] + normals[a + 2] * normals[b + 2];
}
