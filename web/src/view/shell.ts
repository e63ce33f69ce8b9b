// Open and shared edges of surfaces and meshes, by their triangles: surfaces of one list have the same vertices where they meet.

import type { Buffers } from "../model/bytes";
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
  const ends: Record<keyof ShellEdges, number[]> = { open: [], shared: [], crowded: [] };
  for (const { a, b, owners } of borders(drawn, origin, welder)) {
    const kind = owners.length === 1 ? "open" : owners.length > 2 ? "crowded" : owners[0] !== owners[1] ? "shared" : null;
    // Two of one item are its seam.
    if (kind) ends[kind].push(...welder.point(a), ...welder.point(b));
  }
  return { open: new Float32Array(ends.open), shared: new Float32Array(ends.shared), crowded: new Float32Array(ends.crowded) };
}

/** The sets of items that close: those of one definition together, and what else has its edges in common. */
export function closedSets(drawn: DrawnItem[], weld: number): DrawnItem[][] {
  const definitions = new Map<string, DrawnItem[]>();
  for (const one of drawn) {
    const { definition } = one.item;
    const others = definitions.get(definition);
    if (others) others.push(one);
    else definitions.set(definition, [one]);
  }
  const closed: DrawnItem[][] = [];
  const rest: DrawnItem[] = [];
  for (const set of definitions.values()) {
    const parts = connected(set, weld);
    for (const part of parts) if (part.isClosed) closed.push(part.items);
    rest.push(...parts.filter((part) => !part.isClosed).flatMap((part) => part.items));
  }
  for (const part of connected(rest, weld)) if (part.isClosed) closed.push(part.items);
  return closed;
}

/** Items that have edges in common, and whether no edge of theirs is open. */
function connected(drawn: DrawnItem[], weld: number): { items: DrawnItem[]; isClosed: boolean }[] {
  if (drawn.length === 0) return [];
  const origin = drawn[0].shape.buffers.center;
  const parents = drawn.map((_, i) => i);
  const rootOf = (i: number): number => {
    while (parents[i] !== i) i = parents[i] = parents[parents[i]];
    return i;
  };
  const sides = [...borders(drawn, origin, new Welder(weld))];
  for (const { owners } of sides) for (const owner of owners) parents[rootOf(owner)] = rootOf(owners[0]);
  const open = new Set(sides.filter(({ owners }) => owners.length % 2 === 1).map(({ owners }) => rootOf(owners[0])));
  const parts = new Map<number, DrawnItem[]>();
  drawn.forEach((one, i) => {
    const part = parts.get(rootOf(i));
    if (part) part.push(one);
    else parts.set(rootOf(i), [one]);
  });
  return [...parts].map(([root, items]) => ({ items, isClosed: !open.has(root) }));
}

/** The sides at which triangles of an item have no neighbour with the same vertices, each with the items there. */
function borders(drawn: DrawnItem[], origin: [number, number, number], welder: Welder): Iterable<Side> {
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
    for (const [i, j] of borderSides(buffers, triangles)) {
      const [a, b] = [at(i), at(j)];
      if (a === b) continue;
      const name = a < b ? `${a} ${b}` : `${b} ${a}`;
      const side = sides.get(name);
      if (side) side.owners.push(owner);
      else sides.set(name, { a, b, owners: [owner] });
    }
  });
  return sides.values();
}

/** What is known of buffers, as long as these are. */
const knownSides = new WeakMap<Buffers, [number, number][]>();

/** Sides of triangles that no other triangle has with the same vertices, or more than one other. */
function borderSides(buffers: Buffers, triangles: Uint32Array): [number, number][] {
  const known = knownSides.get(buffers);
  if (known) return known;
  // A table with open addresses: there may be millions of sides.
  const size = 2 ** Math.ceil(Math.log2(2 * triangles.length + 1));
  const [lows, highs, counts] = [new Uint32Array(size), new Uint32Array(size), new Uint32Array(size)];
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [triangles[t + k], triangles[t + ((k + 1) % 3)]];
      const [low, high] = a < b ? [a, b] : [b, a];
      let at = (Math.imul(low, 0x9e3779b1) ^ Math.imul(high, 0x85ebca6b)) & (size - 1);
      while (counts[at] > 0 && (lows[at] !== low || highs[at] !== high)) at = (at + 1) & (size - 1);
      [lows[at], highs[at]] = [low, high];
      counts[at]++;
    }
  }
  const found: [number, number][] = [];
  counts.forEach((count, at) => {
    if (count !== 2) for (let i = 0; i < count; i++) found.push([lows[at], highs[at]]);
  });
  knownSides.set(buffers, found);
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
