// Geometry for the graphics processor of one item, made from its buffers when it is first wanted.

import { BufferAttribute, BufferGeometry } from "three";
import { MeshBVH } from "three-mesh-bvh";

import type { Buffers } from "../model/bytes";
import type { Isocurves } from "../model/isocurves";
import { combEnds, isocombEnds } from "./combs";
import { creaseEnds } from "./creases";
import { knotLines, knotPoints } from "./knots";
import { endsOf, hairGeometry, segmentGeometry, sphereOf } from "./segments";

/** About as many normals as are drawn of one surface. */
const N_NORMALS = 500;

type Part = "edges" | "isocurves" | "net" | "knots" | "wires";

export class Shape {
  private surfaceMade: BufferGeometry | null | undefined;
  private readonly lines = new Map<Part, BufferGeometry | null>();
  private bvhMade: MeshBVH | null | undefined;

  constructor(readonly buffers: Buffers) {}

  /** The triangles, or null where the item has none. */
  get surface(): BufferGeometry | null {
    if (this.surfaceMade === undefined) this.surfaceMade = surfaceOf(this.buffers);
    return this.surfaceMade;
  }

  /** Segments of one kind, or null where the item has none. */
  part(part: Part): BufferGeometry | null {
    let made = this.lines.get(part);
    if (made === undefined) {
      const ends = this.ends(part);
      const isHair = part === "isocurves" || part === "wires";
      made = ends.length > 0 ? (isHair ? hairGeometry : segmentGeometry)(ends) : null;
      this.lines.set(part, made);
    }
    return made;
  }

  /** Puts a distance at each vertex; whether they fit. */
  setDeviation(values: Float32Array | undefined): boolean {
    const { surface } = this;
    if (!surface || !values || 3 * values.length !== this.buffers.positions?.length) return false;
    if (surface.getAttribute("deviation")?.array !== values) surface.setAttribute("deviation", new BufferAttribute(values, 1));
    return true;
  }

  /** The control points. */
  controlPoints(): BufferGeometry | null {
    return this.buffers.control ? dots(this.buffers.control.points) : null;
  }

  /** The points of a curve at its knots. */
  knotPoints(): BufferGeometry | null {
    const points = knotPoints(this.buffers);
    return points.length > 0 ? dots(points) : null;
  }

  /** Points that are the item itself. */
  points(): BufferGeometry | null {
    const { positions, kind } = this.buffers;
    return kind === "points" && positions ? dots(positions) : null;
  }

  /** Teeth and outline of the comb of a curve, or of these isocurves; `scale` makes a length of a curvature. */
  comb(isocurves: Isocurves, scale: number, stride: number): BufferGeometry | null {
    const ends = this.buffers.comb
      ? combEnds(this.buffers.edges[0], this.buffers.comb, scale, stride)
      : isocombEnds(isocurves, scale, stride);
    return ends.length > 0 ? hairGeometry(ends) : null;
  }

  /** Normals of that length at vertices spread over the surface. */
  normals(length: number): BufferGeometry | null {
    const { positions, normals } = this.buffers;
    if (!positions || !normals) return null;
    const n_vertices = positions.length / 3;
    const step = Math.max(1, Math.floor(n_vertices / N_NORMALS));
    const ends = new Float32Array(Math.ceil(n_vertices / step) * 6);
    let at = 0;
    for (let i = 0; i < n_vertices; i += step) {
      for (let k = 0; k < 3; k++) {
        ends[at + k] = positions[3 * i + k];
        ends[at + 3 + k] = positions[3 * i + k] + length * normals[3 * i + k];
      }
      at += 6;
    }
    return segmentGeometry(ends);
  }

  /** The tree that answers rays, built at the first question. */
  get bvh(): MeshBVH | null {
    if (this.bvhMade === undefined) {
      this.bvhMade = this.surface ? new MeshBVH(this.surface, { indirect: true }) : null;
    }
    return this.bvhMade;
  }

  /** All segments that a click on a line can hit. */
  clickable(): Float32Array[] {
    return [...this.buffers.edges, ...this.buffers.isocurves];
  }

  dispose(): void {
    this.surfaceMade?.dispose();
    for (const line of this.lines.values()) line?.dispose();
    this.lines.clear();
    this.surfaceMade = this.bvhMade = undefined;
  }

  private ends(part: Part): Float32Array {
    const { buffers } = this;
    switch (part) {
      case "edges": {
        // Of a mesh come the sides of all its faces: they are its wires, and its creases are found here.
        if (buffers.kind === "mesh" && buffers.triangles) return creaseEnds(buffers);
        const ends = endsOf(buffers.edges);
        return buffers.segments ? joined(ends, buffers.segments) : ends;
      }
      case "isocurves":
        return endsOf(buffers.isocurves);
      case "net":
        return buffers.control ? netEnds(buffers.control.points, buffers.control.size) : new Float32Array(0);
      case "knots":
        return knotLines(buffers);
      case "wires":
        return wireEnds(buffers);
    }
  }
}

function surfaceOf(buffers: Buffers): BufferGeometry | null {
  const { positions, triangles } = buffers;
  if (!positions || !triangles || triangles.length === 0) return null;
  const geometry = new BufferGeometry();
  const n_vertices = positions.length / 3;
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  geometry.setAttribute("normal", new BufferAttribute(buffers.normals ?? new Float32Array(positions.length), 3));
  const { curvatures, colors } = buffers;
  if (curvatures) geometry.setAttribute("curvature", new BufferAttribute(curvatures, 2));
  if (colors) {
    const tints = new Uint8Array(n_vertices * 3);
    for (let i = 0; i < n_vertices; i++) for (let k = 0; k < 3; k++) tints[3 * i + k] = colors[4 * i + k];
    geometry.setAttribute("tint", new BufferAttribute(tints, 3, true));
  }
  geometry.boundingSphere = sphereOf(positions);
  return geometry;
}

function dots(points: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.boundingSphere = sphereOf(points);
  return geometry;
}

/** Segments between neighbours of a net of n by m points, or of a polygon of n. */
function netEnds(points: Float32Array, size: number[]): Float32Array {
  const [n, m = 1] = size;
  const ends: number[] = [];
  const push = (a: number, b: number): void => {
    for (const i of [a, b]) ends.push(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
  };
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < m; j++) {
      if (i + 1 < n) push(i * m + j, (i + 1) * m + j);
      if (j + 1 < m) push(i * m + j, i * m + j + 1);
    }
  }
  return new Float32Array(ends);
}

/** The sides of all triangles, each once where both neighbours share its vertices. */
function wireEnds({ kind, segments, positions, triangles }: Buffers): Float32Array {
  if (kind === "mesh" && segments) return segments;
  if (!positions || !triangles) return new Float32Array(0);
  const n_vertices = positions.length / 3;
  const seen = new Set<number>();
  const sides: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const a = triangles[t + k];
      const b = triangles[t + ((k + 1) % 3)];
      const side = Math.min(a, b) * n_vertices + Math.max(a, b);
      if (seen.has(side)) continue;
      seen.add(side);
      sides.push(a, b);
    }
  }
  const ends = new Float32Array(sides.length * 3);
  for (let i = 0; i < sides.length; i++) {
    for (let k = 0; k < 3; k++) ends[3 * i + k] = positions[3 * sides[i] + k];
  }
  return ends;
}

function joined(a: Float32Array, b: Float32Array): Float32Array {
  const both = new Float32Array(a.length + b.length);
  both.set(a);
  both.set(b, a.length);
  return both;
}
