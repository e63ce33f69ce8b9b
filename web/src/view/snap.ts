// Where a click is drawn to: the ends and knots of curves, the corners, vertices and knots of surfaces, the vertices of meshes, and points.

import { type Box3, DoubleSide, type Plane, type Ray, Vector3 } from "three";

import type { Hit } from "../model/document";
import type { DrawnItem } from "./drawn";
import { hitAt, type Place } from "./pick";
import type { Rig } from "./rig";

/** Pixels within which a place draws a click to itself. */
const REACH = 10;
/** Pixels by which an end is preferred to a knot, and what is in the item under the pointer to what is not. */
const PREFERENCE = 2;
/** How far in front of a vertex, in pixels, its own mesh does not hide it. */
const BEFORE = 0.5;
/** Triangles within reach beyond which a mesh is seen too small for one of its vertices to be meant. */
const TRIANGLES = 16384;

interface Lure extends Place {
  name: string;
}

/** The hit at the nearest such place within reach of the pixel (x, y) that is not behind `hit`; null where there is none. */
export function snapped(drawn: Iterable<DrawnItem>, rig: Rig, x: number, y: number, planes: Plane[], hit: Hit | null): Hit | null {
  const ray = rig.ray(x, y);
  const limit = hit ? new Vector3(...hit.point).distanceTo(ray.origin) + 2 * REACH * rig.perPixel : Infinity;
  const isSeen = (point: Vector3): boolean => point.distanceTo(ray.origin) <= limit && planes.every((plane) => plane.distanceToPoint(point) >= -rig.perPixel);
  let best: Lure | null = null;
  let least = Infinity;
  for (const one of drawn) {
    const { bounds } = one.item;
    if (!one.isVisible || !bounds || !isNear(new Vector3(...bounds[0]), new Vector3(...bounds[1]), rig, ray)) continue;
    for (const lure of lures(one, rig, ray)) {
      const { x: px, y: py, z } = rig.project(lure.point);
      const distance = Math.hypot(px - x, py - y);
      const gap = distance + (lure.name === "knot" ? PREFERENCE : 0) + (hit && one.item.path !== hit.path ? PREFERENCE : 0);
      if (z > 1 || distance > REACH || gap >= least || !isSeen(lure.point) || isHidden(lure, rig, px, py)) continue;
      least = gap;
      best = { ...lure, point: lure.point.clone() };
    }
  }
  if (!best) return null;
  const triangle = hit?.path === best.drawn.item.path ? hit.triangle : null;
  return { ...hitAt({ ...best, triangle }), snapped: best.name };
}

/** Whether a box may come within reach of the ray. */
function isNear(least: Vector3, most: Vector3, rig: Rig, ray: Ray): boolean {
  const middle = least.clone().add(most).multiplyScalar(0.5);
  const perPixel = rig.perPixel * (rig.isOrthographic ? 1 : Math.max(1, (2 * middle.distanceTo(ray.origin)) / rig.distance));
  return ray.distanceToPoint(middle) <= 0.5 * least.distanceTo(most) + REACH * perPixel;
}

/** Whether a vertex of a mesh lies behind the mesh; what else there is has ends that shine through. */
function isHidden({ drawn, point, name }: Lure, rig: Rig, x: number, y: number): boolean {
  if (name !== "vertex" || drawn.item.form !== "mesh") return false;
  const ray = rig.ray(x, y);
  const center = new Vector3(...drawn.shape.buffers.center);
  const far = point.distanceTo(ray.origin) - BEFORE * rig.perPixel;
  ray.origin.sub(center);
  return drawn.shape.bvh?.raycastFirst(ray, DoubleSide, 0, far) != null;
}

/** The places of an item; the point of one is used for the next. */
function* lures(drawn: DrawnItem, rig: Rig, ray: Ray): Iterable<Lure> {
  const { snaps, center, kind, positions } = drawn.shape.buffers;
  const point = new Vector3();
  const at = (places: Float32Array, i: number): Vector3 => point.set(places[3 * i] + center[0], places[3 * i + 1] + center[1], places[3 * i + 2] + center[2]);
  if (snaps) {
    const end = kind === "curve" || kind === "polyline" ? "end" : drawn.item.form === "face" ? "vertex" : "corner";
    for (const [i, numbers] of snaps.parameters.entries()) {
      const parameters = numbers.length === 2 ? { u: numbers[0], v: numbers[1] } : numbers.length === 1 ? { t: numbers[0] } : null;
      yield { drawn, point: at(snaps.points, i), parameters, name: i < snaps.n_ends ? end : "knot" };
    }
  } else if (kind === "points" && positions) {
    for (let i = 0; 3 * i < positions.length; i++) {
      yield { drawn, point: at(positions, i), parameters: { vertex: i }, name: "point", index: i };
    }
  } else if (drawn.item.form === "mesh" && positions) {
    for (const i of verticesNear(drawn, rig, ray)) yield { drawn, point: at(positions, i), parameters: { vertex: i }, name: "vertex" };
  }
}

/** The corners of the triangles of a mesh that may come within reach of the ray; none where these are too many. */
function verticesNear({ shape }: DrawnItem, rig: Rig, ray: Ray): Set<number> {
  const found = new Set<number>();
  const { triangles, center } = shape.buffers;
  const middle = new Vector3(...center);
  let n = 0;
  const isClose = (box: Box3): boolean => isNear(box.min.clone().add(middle), box.max.clone().add(middle), rig, ray);
  shape.bvh?.shapecast({
    intersectsBounds: isClose,
    intersectsTriangle: (_, i) => {
      if (++n > TRIANGLES) {
        found.clear();
        return true;
      }
      for (const corner of triangles!.subarray(3 * i, 3 * i + 3)) found.add(corner);
    },
  });
  return found;
}
