// The filled cuts of closed sets where the section plane goes through them.
//
// Each triangle that crosses the plane gives a segment. A fan from one place to all segments of a set covers
// every place inside an odd number of times, which the stencil counts; then one rectangle is painted where it is odd.

import {
  AlwaysStencilFunc,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  InvertStencilOp,
  KeepStencilOp,
  Mesh,
  NotEqualStencilFunc,
  type Plane,
  ShaderMaterial,
  Vector3,
  ZeroStencilOp,
} from "three";

import { Signal } from "../signal";
import type { DrawnItem } from "./drawn";
import { CAP_FRAGMENT, CAP_VERTEX } from "./glsl";
import { shared, wholeLineMaterial } from "./paint";
import { segmentGeometry } from "./segments";
import { closedSets } from "./shell";
import { colorOf, type Palette, raw } from "./theme";

/** Steps of depth by which each cap lies before the one before, since all are in one plane. */
const NEARER = 32;

/** What the cut goes through, by definitions; null while nothing is cut. */
export interface CutSets {
  filled: string[];
  open: string[];
}

export class SectionCaps {
  readonly group = new Group();
  readonly sets = new Signal<CutSets | null>(null);
  private readonly counting = new ShaderMaterial({
    vertexShader: CAP_VERTEX,
    fragmentShader: CAP_FRAGMENT,
    uniforms: { ...shared, color: { value: raw(0) }, isSelected: { value: 0 }, hatch: { value: 1 } },
    side: DoubleSide,
    colorWrite: false,
    depthTest: false,
    depthWrite: false,
    stencilWrite: true,
    stencilFunc: AlwaysStencilFunc,
    stencilZPass: InvertStencilOp,
  });
  private readonly outline = wholeLineMaterial(shared.accent.value, 2, 1, 0.0003);
  private closed: DrawnItem[][] = [];
  /** What is filled, the larger before what may lie within. */
  private cuts: { of: DrawnItem; ends: number[] }[] = [];
  private known = "";
  private made = "";

  /** Fills what the plane cuts of the visible items, or nothing without a plane. */
  show(plane: Plane | null, drawn: Iterable<DrawnItem>, weld: number): void {
    const visible = plane ? [...drawn].filter((one) => one.isVisible && one.hasSurface) : [];
    const known = visible.map((one) => one.item.key).join(" ");
    const made = plane ? `${known} ${plane.normal.toArray().join(" ")} ${plane.constant}` : "";
    if (made === this.made) return;
    this.made = made;
    if (known !== this.known) {
      this.known = known;
      this.closed = closedSets(visible, weld);
    }
    this.clear();
    if (!plane) return this.sets.set(null);
    const filled = new Set<string>();
    const cuts = this.closed.map((set) => ({ set, ends: set.flatMap((one) => segments(one, plane)) })).filter(({ ends }) => ends.length > 0);
    // What lies within another is painted over it.
    const caps = cuts.map((its) => ({ ...its, cap: rectangle(its.ends, plane.normal) }));
    caps.sort((a, b) => diagonal(b.cap) - diagonal(a.cap));
    this.cuts = caps.map(({ set, ends }) => ({ of: set[0], ends }));
    caps.forEach(({ set, ends, cap }, i) => {
      this.add(ends, cap, set[0], i);
      for (const { item } of set) filled.add(item.definition);
    });
    const inSets = new Set(this.closed.flat());
    const open = visible.filter((one) => !inSets.has(one) && segments(one, plane).length > 0);
    this.sets.set({ filled: [...filled], open: [...new Set(open.map(({ item }) => item.definition))] });
  }

  /** The item whose cut is filled at a place of the plane. */
  at(place: Vector3, plane: Plane): DrawnItem | null {
    const [a, b] = axesOf(plane.normal);
    const [x, y] = [a.dot(place), b.dot(place)];
    const isWithin = ({ ends }: { ends: number[] }): boolean => {
      let n_crossed = 0;
      const along = (axis: Vector3, i: number): number => axis.x * ends[i] + axis.y * ends[i + 1] + axis.z * ends[i + 2];
      for (let i = 0; i < ends.length; i += 6) {
        const [from, to] = [along(b, i) - y, along(b, i + 3) - y];
        if (from >= 0 === to >= 0) continue;
        const [start, end] = [along(a, i), along(a, i + 3)];
        if (start + (from / (from - to)) * (end - start) > x) n_crossed++;
      }
      return n_crossed % 2 === 1;
    };
    return [...this.cuts].reverse().find(isWithin)?.of ?? null;
  }

  /** Brings the colours up to date. */
  paint(palette: Palette, isSelected: (path: string) => boolean): void {
    this.outline.uniforms.color.value = palette.accent;
    for (const cap of this.group.children) {
      const { of } = cap.userData as { of?: DrawnItem };
      if (!of) continue;
      const { uniforms } = (cap as Mesh<BufferGeometry, ShaderMaterial>).material;
      uniforms.color.value = colorOf(of.item, palette);
      uniforms.isSelected.value = isSelected(of.item.path) ? 1 : 0;
    }
  }

  private add(ends: number[], cap: number[], of: DrawnItem, number: number): void {
    const base = new Vector3(ends[0], ends[1], ends[2]);
    const local = (places: number[]): number[] => places.map((place, i) => place - base.getComponent(i % 3));
    const border = local(ends);
    const fan: number[] = [];
    for (let i = 0; i < border.length; i += 6) fan.push(0, 0, 0, ...border.slice(i, i + 6));
    const order = 10 + this.group.children.length;
    const painting = new ShaderMaterial({
      vertexShader: CAP_VERTEX,
      fragmentShader: CAP_FRAGMENT,
      uniforms: { ...shared, color: { value: raw(0x808080) }, isSelected: { value: 0 }, hatch: { value: number % 2 === 0 ? 1 : -1 } },
      side: DoubleSide,
      stencilWrite: true,
      stencilFunc: NotEqualStencilFunc,
      stencilRef: 0,
      stencilFail: KeepStencilOp,
      stencilZFail: ZeroStencilOp,
      stencilZPass: ZeroStencilOp,
      polygonOffset: true,
      polygonOffsetFactor: -number,
      polygonOffsetUnits: -NEARER * number,
    });
    const parts: [BufferGeometry, ShaderMaterial][] = [
      [geometryOf(fan), this.counting],
      [geometryOf(local(cap)), painting],
      [segmentGeometry(new Float32Array(border)), this.outline],
    ];
    parts.forEach(([geometry, material], i) => {
      const mesh = new Mesh(geometry, material);
      mesh.position.copy(base);
      mesh.renderOrder = order + i;
      if (material === painting) mesh.userData = { of };
      this.group.add(mesh);
    });
  }

  private clear(): void {
    this.cuts = [];
    for (const old of [...this.group.children] as Mesh<BufferGeometry, ShaderMaterial>[]) {
      old.removeFromParent();
      old.geometry.dispose();
      if (old.userData.of) old.material.dispose();
    }
  }
}

/** Ends of the segments in which the plane cuts the triangles of an item, in pairs, in the model's coordinates. */
function segments({ shape: { buffers } }: DrawnItem, plane: Plane): number[] {
  const { positions, triangles, center } = buffers;
  if (!positions || !triangles) return [];
  const { x, y, z } = plane.normal;
  const offset = plane.constant + x * center[0] + y * center[1] + z * center[2];
  const heights = new Float64Array(positions.length / 3);
  for (let i = 0; i < heights.length; i++) heights[i] = x * positions[3 * i] + y * positions[3 * i + 1] + z * positions[3 * i + 2] + offset;
  const ends: number[] = [];
  // From the smaller number to the larger, so that both neighbours of a side find the same place.
  const cross = (i: number, j: number): void => {
    const [a, b] = i < j ? [i, j] : [j, i];
    const share = heights[a] / (heights[a] - heights[b]);
    for (let k = 0; k < 3; k++) ends.push(positions[3 * a + k] + share * (positions[3 * b + k] - positions[3 * a + k]) + center[k]);
  };
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [triangles[t], triangles[t + 1], triangles[t + 2]];
    const [isA, isB, isC] = [heights[a] >= 0, heights[b] >= 0, heights[c] >= 0];
    if (isA === isB && isB === isC) continue;
    if (isA !== isB) cross(a, b);
    if (isB !== isC) cross(b, c);
    if (isC !== isA) cross(c, a);
  }
  return ends;
}

/** Two directions across a normal, and across one another. */
function axesOf(normal: Vector3): [Vector3, Vector3] {
  const across = Math.abs(normal.z) < 0.9 ? new Vector3(0, 0, 1) : new Vector3(0, 1, 0);
  const a = new Vector3().crossVectors(normal, across).normalize();
  return [a, new Vector3().crossVectors(normal, a)];
}

/** Two triangles that cover all corners, which lie in one plane. */
function rectangle(corners: number[], normal: Vector3): number[] {
  const [a, b] = axesOf(normal);
  const reach = [a, b].map((axis) => {
    const range = [Infinity, -Infinity];
    for (let i = 0; i < corners.length; i += 3) {
      const at = axis.x * corners[i] + axis.y * corners[i + 1] + axis.z * corners[i + 2];
      range[0] = Math.min(range[0], at);
      range[1] = Math.max(range[1], at);
    }
    return range;
  });
  const height = normal.dot(new Vector3(corners[0], corners[1], corners[2]));
  const corner = (i: number, j: number): number[] =>
    a.clone().multiplyScalar(reach[0][i]).addScaledVector(b, reach[1][j]).addScaledVector(normal, height).toArray();
  return [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1)].flat();
}

/** The squared distance between the first and the third corner. */
function diagonal(corners: number[]): number {
  return [0, 1, 2].reduce((sum, k) => sum + (corners[6 + k] - corners[k]) ** 2, 0);
}

function geometryOf(corners: number[]): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
  return geometry;
}
