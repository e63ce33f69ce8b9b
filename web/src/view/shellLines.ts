// The open and shared edges in the picture, made when they are first wanted and when the items change.

import { type Box3, Group, Mesh, Vector3 } from "three";

import { Signal } from "../signal";
import type { DrawnItem } from "./drawn";
import { lineMaterial } from "./paint";
import { segmentGeometry } from "./segments";
import { lengthOf, type ShellEdges, shellEdges } from "./shell";
import { raw } from "./theme";

/** Share of the model's size below which two vertices are one: single precision knows no less. */
export const WELD = 2e-6;

export interface ShellLengths {
  open: number;
  shared: number;
  crowded: number;
}

export class ShellLines {
  readonly group = new Group();
  /** Lengths of the edges; null while they are not wanted. */
  readonly lengths = new Signal<ShellLengths | null>(null);
  private readonly materials = {
    open: lineMaterial(raw(0xd0342c), 3.5, 1, 0.0006),
    shared: lineMaterial(raw(0x2e8b57), 3, 1, 0.0005),
    crowded: lineMaterial(raw(0x8e24aa), 4, 1, 0.0007),
  };
  private made: string | null = null;

  /** Draws the edges of what is visible, or nothing. */
  show(isOn: boolean, drawn: DrawnItem[], box: Box3): void {
    this.group.visible = isOn;
    const visible = drawn.filter((one) => one.isVisible && one.hasSurface);
    const wanted = isOn ? visible.map((one) => one.item.key).join(" ") : null;
    if (wanted === this.made) return;
    this.made = wanted;
    for (const old of [...this.group.children]) {
      old.removeFromParent();
      (old as Mesh).geometry.dispose();
    }
    if (!isOn) return this.lengths.set(null);
    const center = box.isEmpty() ? new Vector3() : box.getCenter(new Vector3());
    const size = box.isEmpty() ? 1 : box.max.distanceTo(box.min);
    this.group.position.copy(center);
    const edges: ShellEdges = shellEdges(visible, center.toArray(), WELD * size);
    for (const kind of ["shared", "open", "crowded"] as const) {
      if (edges[kind].length === 0) continue;
      const lines = new Mesh(segmentGeometry(edges[kind]), this.materials[kind]);
      lines.renderOrder = 4;
      this.group.add(lines);
    }
    this.lengths.set({ open: lengthOf(edges.open), shared: lengthOf(edges.shared), crowded: lengthOf(edges.crowded) });
  }
}
