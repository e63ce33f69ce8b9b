// Lines as quadrilaterals: each segment has a start and an end, and the shader makes it wide.
//
// Instances of one quadrilateral take 24 bytes a segment. A renderer without a graphics processor draws each of them as if it
// were a geometry of its own, some ten times as slowly; there all corners are written out, and fine lines are the renderer's.

import {
  BufferAttribute,
  BufferGeometry,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Sphere,
  Vector3,
} from "three";

/** How far along and across the segment each corner lies. */
const CORNERS = [0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0];
const SIDES = [0, 1, 2, 0, 2, 3];
const CORNER = new BufferAttribute(new Float32Array(CORNERS), 3);
const INDEX = new BufferAttribute(new Uint16Array(SIDES), 1);

let isWrittenOut = false;

/** Whether geometries that are made from now on hold all their corners. */
export function writeOutCorners(wanted: boolean): void {
  isWrittenOut = wanted;
}

/** A geometry of segments whose ends stand in pairs: six numbers a segment. */
export function segmentGeometry(ends: Float32Array): BufferGeometry {
  const geometry = isWrittenOut ? writtenOut(ends) : instances(ends);
  geometry.boundingSphere = sphereOf(ends);
  return geometry;
}

/** The same of lines a pixel wide, which a renderer without a graphics processor draws as its own: they may be very many. */
export function hairGeometry(ends: Float32Array): BufferGeometry {
  if (!isWrittenOut) return segmentGeometry(ends);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(ends, 3));
  geometry.boundingSphere = sphereOf(ends);
  return geometry;
}

/** Whether the shader makes the lines of a geometry wide. */
export const isWide = (geometry: BufferGeometry): boolean => geometry.hasAttribute("start");

function instances(ends: Float32Array): BufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setIndex(INDEX);
  geometry.setAttribute("position", CORNER);
  setEnds(geometry, new InstancedInterleavedBuffer(ends, 6, 1));
  geometry.instanceCount = ends.length / 6;
  return geometry;
}

function writtenOut(ends: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  const n_segments = ends.length / 6;
  const corners = new Int8Array(12 * n_segments);
  const fourfold = new Float32Array(24 * n_segments);
  const sides = new Uint32Array(6 * n_segments);
  for (let i = 0; i < n_segments; i++) {
    corners.set(CORNERS, 12 * i);
    const segment = ends.subarray(6 * i, 6 * i + 6);
    for (let k = 0; k < 4; k++) fourfold.set(segment, 24 * i + 6 * k);
    for (let k = 0; k < 6; k++) sides[6 * i + k] = 4 * i + SIDES[k];
  }
  geometry.setIndex(new BufferAttribute(sides, 1));
  geometry.setAttribute("position", new BufferAttribute(corners, 3));
  setEnds(geometry, new InterleavedBuffer(fourfold, 6));
  return geometry;
}

function setEnds(geometry: BufferGeometry, buffer: InterleavedBuffer): void {
  geometry.setAttribute("start", new InterleavedBufferAttribute(buffer, 3, 0));
  geometry.setAttribute("end", new InterleavedBufferAttribute(buffer, 3, 3));
}

/** The ends of the segments of these polylines. */
export function endsOf(polylines: Float32Array[]): Float32Array {
  let n_segments = 0;
  for (const line of polylines) n_segments += Math.max(0, line.length / 3 - 1);
  const ends = new Float32Array(n_segments * 6);
  let at = 0;
  for (const line of polylines) {
    for (let i = 0; i + 5 < line.length; i += 3) {
      for (let k = 0; k < 6; k++) ends[at + k] = line[i + k];
      at += 6;
    }
  }
  return ends;
}

/** A sphere around all points: about the middle of their box. */
export function sphereOf(points: Float32Array): Sphere {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i++) {
    const k = i % 3;
    if (points[i] < least[k]) least[k] = points[i];
    if (points[i] > most[k]) most[k] = points[i];
  }
  if (!(least[0] <= most[0])) return new Sphere(new Vector3(), 0);
  const low = new Vector3(...(least as [number, number, number]));
  const high = new Vector3(...(most as [number, number, number]));
  return new Sphere(low.clone().add(high).multiplyScalar(0.5), 0.5 * low.distanceTo(high));
}
