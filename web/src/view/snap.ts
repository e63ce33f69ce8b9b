// Where a click is drawn to: the ends and knots of curves, the corners, vertices and knots of surfaces, the vertices of meshes, and points.

import { type Plane, type Ray, Vector3 } from "three";

import type { Vector } from "../door/door";
import type { Hit } from "../model/document";
import type { DrawnItem } from "./drawn";
import type { Rig } from "./rig";

/** Pixels within which a place draws a click to itself. */
const REACH = 10;
/** Pixels by which an end is preferred to a knot, and what is in the item under the pointer to what is not. */
const PREFERENCE = 2;

interface Lure {
  drawn: DrawnItem;
  gap: number;
  point: Vector3;
  parameters: Hit["parameters"];
  name: string;
  index: number | null;
}

/** The hit at the nearest such place within reach of the pixel (x, y) that is not behind `hit`; null where there is none. */
export function snapped(drawn: Iterable<DrawnItem>, rig: Rig, x: number, y: number, planes: Plane[], hit: Hit | null): Hit | null {
  const ray = rig.ray(x, y);
  const limit = hit ? new Vector3(...hit.point).distanceTo(ray.origin) + 2 * REACH * rig.perPixel : Infinity;
  const isSeen = (point: Vector3): boolean => point.distanceTo(ray.origin) <= limit && planes.every((plane) => plane.distanceToPoint(point) >= -rig.perPixel);
  let best: Lure | null = null;
  for (const one of drawn) {
    if (!one.isVisible || !isNear(one, rig, ray)) continue;
    for (const lure of lures(one, hit)) {
      const { x: px, y: py, z } = rig.project(lure.point);
      const distance = Math.hypot(px - x, py - y);
      if (z > 1 || distance > REACH || !isSeen(lure.point)) continue;
      lure.gap = distance + (lure.name === "knot" ? PREFERENCE : 0) + (hit && one.item.path !== hit.path ? PREFERENCE : 0);
      if (!best || lure.gap < best.gap) best = { ...lure, point: lure.point.clone() };
    }
  }
  if (!best) return null;
  const { item } = best.drawn;
  return {
    path: item.path,
    item,
    point: best.point.toArray() as Vector,
    normal: null,
    parameters: best.parameters,
    triangle: hit?.path === item.path ? hit.triangle : null,
    index: best.index,
    snapped: best.name,
    answer: null,
    trouble: null,
  };
}

/** Whether an item's box may come within reach of the ray. */
function isNear({ item: { bounds } }: DrawnItem, rig: Rig, ray: Ray): boolean {
  if (!bounds) return false;
  const [least, most] = bounds.map((corner) => new Vector3(...corner));
  const middle = least.clone().add(most).multiplyScalar(0.5);
  const perPixel = rig.perPixel * (rig.isOrthographic ? 1 : Math.max(1, (2 * middle.distanceTo(ray.origin)) / rig.distance));
  return ray.distanceToPoint(middle) <= 0.5 * least.distanceTo(most) + REACH * perPixel;
}

/** The places of an item; the point of one is used for the next. */
function* lures(drawn: DrawnItem, hit: Hit | null): Iterable<Lure> {
  const { buffers } = drawn.shape;
  const { snaps, center, kind, positions, triangles } = buffers;
  const point = new Vector3();
  const at = (places: Float32Array, i: number): Vector3 => point.set(places[3 * i] + center[0], places[3 * i + 1] + center[1], places[3 * i + 2] + center[2]);
  if (snaps) {
    const end = kind === "curve" ? "end" : drawn.item.form === "face" ? "vertex" : "corner";
    for (const [i, numbers] of snaps.parameters.entries()) {
      const parameters = numbers.length === 2 ? { u: numbers[0], v: numbers[1] } : { t: numbers[0] };
      yield { drawn, gap: 0, point: at(snaps.points, i), parameters, name: i < snaps.n_ends ? end : "knot", index: null };
    }
  } else if (kind === "points" && positions) {
    for (let i = 0; 3 * i < positions.length; i++) {
      yield { drawn, gap: 0, point: at(positions, i), parameters: { vertex: i }, name: "point", index: i };
    }
  } else if (drawn.item.form === "mesh" && positions && triangles && hit?.path === drawn.item.path && hit.triangle !== null) {
    // Of a mesh the corners of the triangle under the pointer: others are as near only where it is small.
    for (const i of triangles.subarray(3 * hit.triangle, 3 * hit.triangle + 3)) {
      yield { drawn, gap: 0, point: at(positions, i), parameters: { vertex: i }, name: "vertex", index: null };
    }
  }
}
