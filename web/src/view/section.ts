// The section plane: across the model's box along an axis, or square to the view it was made in.

import { type Box3, Vector3 } from "three";

import type { Settings } from "../model/settings";
import { cut } from "./paint";

/** The unit normal of the side that goes away. */
export function sectionNormal(settings: Settings): Vector3 {
  const { sectionAxis, sectionNormal: free } = settings;
  if (sectionAxis === "free") return new Vector3(...free).normalize();
  return new Vector3(Number(sectionAxis === "x"), Number(sectionAxis === "y"), Number(sectionAxis === "z"));
}

/** The least and the greatest place of a box along the normal. */
export function reachAlong(box: Box3, normal: Vector3): [number, number] {
  const centre = box.getCenter(new Vector3()).dot(normal);
  const size = box.getSize(new Vector3());
  const half = 0.5 * (Math.abs(normal.x) * size.x + Math.abs(normal.y) * size.y + Math.abs(normal.z) * size.z);
  return [centre - half, centre + half];
}

/** Where along its normal the plane stands. */
export function sectionDistance(settings: Settings, box: Box3): number {
  const [least, most] = reachAlong(box, sectionNormal(settings));
  return least + settings.sectionPlace * (most - least);
}

/** Puts the cutting plane of the materials where the settings say. */
export function placeCut(settings: Settings, box: Box3): void {
  const normal = sectionNormal(settings);
  const distance = sectionDistance(settings, box);
  const sign = settings.sectionFlip ? 1 : -1;
  cut.plane.normal.copy(normal).multiplyScalar(sign);
  cut.plane.constant = -sign * distance;
}

/** The middle of the section: where its handle is. */
export function sectionMiddle(settings: Settings, box: Box3): Vector3 {
  const normal = sectionNormal(settings);
  const centre = box.getCenter(new Vector3());
  return centre.addScaledVector(normal, sectionDistance(settings, box) - centre.dot(normal));
}

/** Corners of the rectangle that shows the plane around the box, in turn. */
export function sectionFrame(settings: Settings, box: Box3): Vector3[] {
  const normal = sectionNormal(settings);
  const middle = sectionMiddle(settings, box);
  const across = Math.abs(normal.z) < 0.9 ? new Vector3(0, 0, 1) : new Vector3(0, 1, 0);
  const a = new Vector3().crossVectors(normal, across).normalize();
  const b = new Vector3().crossVectors(normal, a);
  const [la, ma] = reachAlong(box, a);
  const [lb, mb] = reachAlong(box, b);
  const [ra, rb] = [0.55 * (ma - la), 0.55 * (mb - lb)];
  const corners: [number, number][] = [[-ra, -rb], [ra, -rb], [ra, rb], [-ra, rb]];
  return corners.map(([x, y]) => middle.clone().addScaledVector(a, x).addScaledVector(b, y));
}
