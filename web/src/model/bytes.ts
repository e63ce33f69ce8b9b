// The bytes of one item into typed arrays that look into them, without a copy.

import type { Kind, Vector } from "../door/door";

interface Slice {
  offset: number;
  count: number;
}

interface Header {
  kind: Kind;
  center: Vector;
  positions: Slice | null;
  normals: Slice | null;
  parameters: Slice | null;
  curvatures: Slice | null;
  triangles: Slice | null;
  edges?: Slice[] | null;
  isocurves?: Slice[] | null;
  isocombs?: Slice[] | null;
  segments?: Slice | null;
  colors?: Slice | null;
  control: { points: Slice; size: number[] } | null;
  knots: { u: number[]; v: number[] } | { t: number[] } | null;
  comb: Slice | null;
  snaps?: { parameters: number[][]; points: Slice; ends: number } | null;
}

/** The buffers of one item; coordinates are relative to `center`, in the document's unit. */
export interface Buffers {
  kind: Kind;
  center: Vector;
  positions: Float32Array | null;
  normals: Float32Array | null;
  /** (u, v) of each vertex of a surface, t of each vertex of a curve's polyline. */
  parameters: Float32Array | null;
  /** k1 and k2 of each vertex; NaN where there is none. */
  curvatures: Float32Array | null;
  triangles: Uint32Array | null;
  edges: Float32Array[];
  isocurves: Float32Array[];
  isocombs: Float32Array[];
  /** Ends of separate segments, in pairs. */
  segments: Float32Array | null;
  colors: Uint8Array | null;
  control: { points: Float32Array; size: number[] } | null;
  knots: { u: number[]; v: number[] } | { t: number[] } | null;
  comb: Float32Array | null;
  /** Places that a click near them means, with their parameters; the first so many are ends, corners or vertices, the rest knots. */
  snaps: { parameters: number[][]; points: Float32Array; n_ends: number } | null;
  n_bytes: number;
}

/** Reads one item. Throws a `RangeError` where the header points outside of the bytes. */
export function decode(bytes: ArrayBuffer): Buffers {
  const n_header = new DataView(bytes).getUint32(0, true);
  const text = new TextDecoder().decode(new Uint8Array(bytes, 4, n_header));
  const header = JSON.parse(text) as Header;
  const floats = (slice: Slice, width: number): Float32Array =>
    new Float32Array(bytes, slice.offset, slice.count * width);
  const maybe = (slice: Slice | null | undefined, width: number): Float32Array | null =>
    slice ? floats(slice, width) : null;
  const lines = (slices: Slice[] | null | undefined): Float32Array[] =>
    (slices ?? []).map((slice) => floats(slice, 3));
  const isSurface = header.kind === "surface";
  return {
    kind: header.kind,
    center: header.center,
    positions: maybe(header.positions, 3),
    normals: maybe(header.normals, 3),
    parameters: isSurface || header.kind === "curve" ? maybe(header.parameters, isSurface ? 2 : 1) : null,
    curvatures: maybe(header.curvatures, 2),
    triangles: header.triangles
      ? new Uint32Array(bytes, header.triangles.offset, header.triangles.count * 3)
      : null,
    edges: lines(header.edges),
    isocurves: lines(header.isocurves),
    isocombs: lines(header.isocombs),
    segments: maybe(header.segments, 3),
    colors: header.colors ? new Uint8Array(bytes, header.colors.offset, header.colors.count * 4) : null,
    control: header.control
      ? { points: floats(header.control.points, 3), size: header.control.size }
      : null,
    knots: header.knots,
    comb: maybe(header.comb, 3),
    snaps: header.snaps ? { parameters: header.snaps.parameters, points: floats(header.snaps.points, 3), n_ends: header.snaps.ends } : null,
    n_bytes: bytes.byteLength,
  };
}
