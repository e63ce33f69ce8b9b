// What lies under a pixel: the nearest triangle along the ray, or a line that passes close by in front of it.

import { DoubleSide, Matrix4, type Plane, type Ray, Vector3 } from "three";

import type { Vector } from "../door/door";
import type { Hit } from "../model/document";
import type { SectionCaps } from "./caps";
import type { DrawnItem } from "./drawn";
import type { Rig } from "./rig";

/** Pixels within which a line is meant. */
const REACH = 7;

/** A place of an item that may be meant. */
export interface Place {
  drawn: DrawnItem;
  point: Vector3;
  normal?: Vector3 | null;
  parameters: Hit["parameters"];
  triangle?: number | null;
  /** The number of one of several points. */
  index?: number | null;
}

interface Candidate extends Place {
  distance: number;
}

/** What a click at a place tells before the kernel is asked. */
export function hitAt({ drawn: { item }, point, normal, parameters, triangle, index }: Place): Hit {
  return {
    path: item.path,
    item,
    point: point.toArray() as Vector,
    normal: (normal?.toArray() as Vector | undefined) ?? null,
    parameters,
    triangle: triangle ?? null,
    index: index ?? null,
    answer: null,
    trouble: null,
  };
}

/** The item under the pixel (x, y); `planes` cut away what lies behind them, and what is closed is filled there. */
export function pick(drawn: Iterable<DrawnItem>, rig: Rig, x: number, y: number, planes: Plane[], caps: SectionCaps): Hit | null {
  const ray = rig.ray(x, y);
  const visible = [...drawn].filter((one) => one.isVisible);
  let best: Candidate | null = null;
  for (const one of visible) {
    const found = one.hasSurface ? hitSurface(one, ray, planes) : null;
    if (found && (!best || found.distance < best.distance)) best = found;
  }
  const filled = planes.length > 0 ? hitCap(caps, ray, planes[0]) : null;
  if (filled && (!best || filled.distance < best.distance)) best = filled;
  const limit = best ? best.distance + 12 * rig.perPixel : Infinity;
  for (const one of visible) {
    const found = one.hasSurface ? null : hitLines(one, ray, rig, x, y, planes);
    if (found && found.distance < Math.min(limit, best && !best.drawn.hasSurface ? best.distance : Infinity)) {
      best = found;
    }
  }
  return best && hitAt(best);
}

/** Where the ray comes to a filled cut. */
function hitCap(caps: SectionCaps, ray: Ray, plane: Plane): Candidate | null {
  const point = ray.intersectPlane(plane, new Vector3());
  const drawn = point && caps.at(point, plane);
  if (!drawn) return null;
  const normal = plane.normal.clone().negate();
  return { drawn, distance: point.distanceTo(ray.origin), point, normal, parameters: null };
}

function hitSurface(drawn: DrawnItem, ray: Ray, planes: Plane[]): Candidate | null {
  const { shape } = drawn;
  const center = new Vector3(...shape.buffers.center);
  const local = ray.clone().applyMatrix4(new Matrix4().makeTranslation(center.clone().negate()));
  const sphere = shape.surface?.boundingSphere;
  if (sphere && !local.intersectsSphere(sphere)) return null;
  const hits = planes.length > 0 ? shape.bvh?.raycast(local, DoubleSide) : [shape.bvh?.raycastFirst(local, DoubleSide)];
  let best: Candidate | null = null;
  for (const hit of hits ?? []) {
    if (!hit?.face || (best && hit.distance >= best.distance)) continue;
    const point = hit.point.clone().add(center);
    if (planes.some((plane) => plane.distanceToPoint(point) < 0)) continue;
    const { a, b, c } = hit.face;
    const weights = barycentric(shape.buffers.positions!, [a, b, c], hit.point);
    best = {
      drawn,
      distance: hit.distance,
      point,
      normal: (drawn.item.kind === "mesh" ? null : weighted3(shape.buffers.normals, [a, b, c], weights)) ?? faceNormal(hit.face.normal),
      parameters: weighted2(shape.buffers.parameters, [a, b, c], weights),
      triangle: hit.faceIndex ?? null,
    };
  }
  return best;
}

/** Shares of the corners in a point of their triangle; of a triangle without area, of the first. */
function barycentric(positions: Float32Array, corners: number[], p: Vector3): Vector {
  const [a, b, c] = corners.map((i) => new Vector3().fromArray(positions, 3 * i));
  const [ab, ac, ap] = [b.sub(a), c.sub(a), p.clone().sub(a)];
  const [bb, bc, cc] = [ab.dot(ab), ab.dot(ac), ac.dot(ac)];
  const area = bb * cc - bc * bc;
  if (!(area > 0)) return [1, 0, 0];
  const v = (cc * ap.dot(ab) - bc * ap.dot(ac)) / area;
  const w = (bb * ap.dot(ac) - bc * ap.dot(ab)) / area;
  return [1 - v - w, v, w];
}

function weighted2(values: Float32Array | null, corners: number[], shares: Vector): { u: number; v: number } | null {
  if (!values) return null;
  const at = (axis: number): number => corners.reduce((sum, i, k) => sum + shares[k] * values[2 * i + axis], 0);
  const [u, v] = [at(0), at(1)];
  return Number.isFinite(u + v) ? { u, v } : null;
}

function weighted3(values: Float32Array | null, corners: number[], shares: Vector): Vector3 | null {
  if (!values) return null;
  const sum = new Vector3();
  corners.forEach((i, k) => sum.addScaledVector(new Vector3().fromArray(values, 3 * i), shares[k]));
  return faceNormal(sum);
}

/** A direction of length 1; null where there is none, as on a triangle without area. */
function faceNormal(direction: Vector3): Vector3 | null {
  const length = direction.length();
  return length > 0 && Number.isFinite(length) ? direction.clone().divideScalar(length) : null;
}

/** The nearest place of an item's polylines within reach of the pixel. */
function hitLines(drawn: DrawnItem, ray: Ray, rig: Rig, x: number, y: number, planes: Plane[]): Candidate | null {
  const { buffers } = drawn.shape;
  const center = new Vector3(...buffers.center);
  const along = drawn.shape.clickable();
  if (buffers.segments) for (let i = 0; i < buffers.segments.length; i += 6) along.push(buffers.segments.subarray(i, i + 6));
  const n_lines = along.length;
  if (buffers.kind === "points" && buffers.positions) {
    for (let i = 0; i < buffers.positions.length; i += 3) along.push(buffers.positions.subarray(i, i + 3));
  }
  let best: Candidate | null = null;
  let nearest = REACH;
  for (const [which, line] of along.entries()) {
    const pixels = projected(line, center, rig);
    for (let i = 0; i === 0 || i + 1 < pixels.length; i++) {
      const a = pixels[i];
      const b = pixels[i + 1] ?? a;
      if (!a || a.z > 1 || b.z > 1) continue;
      const [dx, dy] = [b.x - a.x, b.y - a.y];
      const length = dx * dx + dy * dy;
      const share = length > 0 ? Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / length)) : 0;
      const gap = Math.hypot(a.x + share * dx - x, a.y + share * dy - y);
      if (gap >= nearest) continue;
      const start = new Vector3().fromArray(line, 3 * i);
      const end = new Vector3().fromArray(line, Math.min(3 * i + 3, line.length - 3));
      const point = start.lerp(end, share).add(center);
      if (planes.some((plane) => plane.distanceToPoint(point) < 0)) continue;
      nearest = gap;
      const t = line === buffers.edges[0] ? buffers.parameters : null;
      best = {
        drawn,
        distance: point.distanceTo(ray.origin),
        point,
        parameters: t && Number.isFinite(t[i]) ? { t: t[i] * (1 - share) + (t[i + 1] ?? t[i]) * share } : null,
        index: which < n_lines ? null : which - n_lines,
      };
    }
  }
  return best;
}

function projected(line: Float32Array, center: Vector3, rig: Rig): Vector3[] {
  const pixels: Vector3[] = [];
  for (let i = 0; i + 2 < line.length; i += 3) {
    pixels.push(rig.project(new Vector3().fromArray(line, i).add(center)));
  }
  return pixels;
}
