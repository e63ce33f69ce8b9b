// The kernel's borders of stripes in the picture.

import { Group, Mesh } from "three";

import type { ExactLines } from "../model/exactStripes";
import type { DrawnItem } from "./drawn";
import { lineMaterial } from "./paint";
import { segmentGeometry } from "./segments";
import { raw } from "./theme";

export class StripeLines {
  readonly group = new Group();
  private readonly material = lineMaterial(raw(0x14181e), 1.6, 1, 0.0004);
  private made: ReadonlyMap<string, Float32Array> | null = null;

  /** Draws the lines of these items. */
  show({ lines }: ExactLines, drawn: Iterable<DrawnItem>): void {
    if (lines === this.made) return;
    this.made = lines;
    for (const old of [...this.group.children] as Mesh[]) {
      old.removeFromParent();
      old.geometry.dispose();
    }
    for (const { item, shape } of drawn) {
      const ends = lines.get(item.key);
      if (!ends || ends.length === 0) continue;
      const mesh = new Mesh(segmentGeometry(ends), this.material);
      mesh.position.set(...shape.buffers.center);
      mesh.renderOrder = 3;
      this.group.add(mesh);
    }
  }
}
