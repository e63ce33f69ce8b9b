// Open and shared edges of surfaces and meshes, by their triangles: surfaces of one list have the same vertices where they meet.

import type { DrawnItem } from "./drawn";

/** Edges by what lies at them. */
export interface ShellEdges {
  /** One triangle: here the shell ends. */
  open: Float32Array;
  /** Two triangles of different items: here they meet. */
  shared: Float32Array;
  /** More than two. */
  crowded: Float32Array;
}

interface Side {
  a: number;
  b: number;
  owners: number[];
}

/** The edges of all these items together, relative to `origin`; ends no further apart than `weld` are one. */
export function shellEdges(drawn: DrawnItem[], origin: [number, number, number], weld: number): ShellEdges {
  const welder = new Welder(weld);
  const sides = new Map<string, Side>();
  drawn.forEach(({ shape: { buffers } }, owner) => {
    const { positions, triangles, center } = buffers;
    if (!positions || !triangles) return;
    const place = (i: number): number =>
      welder.at(positions[3 * i] + center[0] - origin[0], positions[3 * i + 1] + center[1] - origin[1], positions[3 * i + 2] + center[2] - origin[2]);
    const welded = new Map<number, number>();
    const at = (i: number): number => {
      let found = welded.get(i);
      if (found === undefined) welded.set(i, (found = place(i)));
      return found;
    };
    for (const [i, j] of borderSides(triangles, positions.length / 3)) {
      const [a, b] = [at(i), at(j)];
      if (a === b) continue;
      const name = a < b ? `${a} ${b}` : `${b} ${a}`;
      const side = sides.get(name);
      if (side) side.owners.push(owner);
      else sides.set(name, { a, b, owners: [owner] });
    }
  });
  const ends: Record<keyof ShellEdges, number[]> = { open: [], shared: [], crowded: [] };
  for (const { a, b, owners } of sides.values()) {
    const kind = owners.length === 1 ? "open" : owners.length > 2 ? "crowded" : owners[0] !== owners[1] ? "shared" : null;
    // Two of one item are its seam.
    if (kind) ends[kind].push(...welder.point(a), ...welder.point(b));
  }
  return { open: new Float32Array(ends.open), shared: new Float32Array(ends.shared), crowded: new Float32Array(ends.crowded) };
}

/** Sides of triangles that no other triangle has with the same vertices, or more than one other. */
function borderSides(triangles: Uint32Array, n_vertices: number): [number, number][] {
  const counts = new Map<number, number>();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [triangles[t + k], triangles[t + ((k + 1) % 3)]];
      const side = Math.min(a, b) * n_vertices + Math.max(a, b);
      counts.set(side, (counts.get(side) ?? 0) + 1);
    }
  }
  const found: [number, number][] = [];
  for (const [side, count] of counts) {
    if (count === 2) continue;
    for (let i = 0; i < count; i++) found.push([Math.floor(side / n_vertices), side % n_vertices]);
  }
  return found;
}

/** Numbers of places: one number for all that are no further apart than the width of a weld. */
class Welder {
  private readonly cells = new Map<string, number[]>();
  private readonly places: number[] = [];

  constructor(private readonly width: number) {}

  at(x: number, y: number, z: number): number {
    const { width, cells, places } = this;
    const size = 2 * width;
    const [i, j, k] = [Math.floor(x / size), Math.floor(y / size), Math.floor(z / size)];
    for (let n = 0; n < 27; n++) {
      const near = cells.get(`${i + (n % 3) - 1} ${j + (Math.floor(n / 3) % 3) - 1} ${k + Math.floor(n / 9) - 1}`);
      for (const place of near ?? []) {
        if (Math.hypot(places[3 * place] - x, places[3 * place + 1] - y, places[3 * place + 2] - z) <= width) return place;
      }
    }
    const place = places.length / 3;
    places.push(x, y, z);
    const name = `${i} ${j} ${k}`;
    const cell = cells.get(name);
    if (cell) cell.push(place);
    else cells.set(name, [place]);
    return place;
  }

  point(place: number): number[] {
    return this.places.slice(3 * place, 3 * place + 3);
  }
}

/** The length of segments whose ends stand in pairs. */
export function lengthOf(ends: Float32Array): number {
  let length = 0;
  for (let i = 0; i < ends.length; i += 6) length += Math.hypot(ends[i] - ends[i + 3], ends[i + 1] - ends[i + 4], ends[i + 2] - ends[i + 5]);
  return length;
}
