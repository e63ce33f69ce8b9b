// Lines as instances of one quadrilateral: each segment has a start and an end, and the shader makes it wide.

import {
  BufferAttribute,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  Sphere,
  Vector3,
} from "three";

const CORNERS = new BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]), 3);
const INDEX = new BufferAttribute(new Uint16Array([0, 1, 2, 0, 2, 3]), 1);

/** A geometry of segments whose ends stand in pairs: six numbers a segment. */
export function segmentGeometry(ends: Float32Array): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setIndex(INDEX);
  geometry.setAttribute("position", CORNERS);
  const buffer = new InstancedInterleavedBuffer(ends, 6, 1);
  geometry.setAttribute("start", new InterleavedBufferAttribute(buffer, 3, 0));
  geometry.setAttribute("end", new InterleavedBufferAttribute(buffer, 3, 3));
  geometry.instanceCount = ends.length / 6;
  geometry.boundingSphere = sphereOf(ends);
  return geometry;
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
