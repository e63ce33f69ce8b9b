// How far one definition is from another, at the vertices of its triangles: asked of the door, kept by the keys of both.

import type { Item } from "../door/door";
import { Signal } from "../signal";
import type { Document } from "./document";
import type { SettingsSignal } from "./settings";

/** Measured items that are kept. */
const N_KEPT = 64;

export interface Measured {
  of: string;
  from: string;
  /** Distances by the key of the measured item. */
  values: ReadonlyMap<string, Float32Array>;
  isWaiting: boolean;
  trouble: string | null;
}

const NOTHING: Measured = { of: "", from: "", values: new Map(), isWaiting: false, trouble: null };

export class DeviationMap extends Signal<Measured> {
  private readonly kept = new Map<string, Float32Array>();
  private run = 0;
  private asked = "";

  constructor(
    private readonly doc: Document,
    private readonly settings: SettingsSignal,
  ) {
    super(NOTHING);
    settings.follow(() => void this.renew());
    doc.scene.follow(() => void this.renew());
  }

  /** The definitions that can be measured, or measured from. */
  definitions(): string[] {
    return [...new Set(this.doc.items().filter(canBeMeasured).map((item) => item.definition))];
  }

  /** What is measured from what: as chosen, or the selection, or the first two definitions. */
  pair(): [string, string] {
    const all = this.definitions();
    const { deviationOf, deviationFrom } = this.settings.value;
    const selected = this.doc.selected().find(canBeMeasured)?.definition;
    const of = [deviationOf, selected ?? "", all[0] ?? ""].find((name) => all.includes(name)) ?? "";
    const from = all.includes(deviationFrom) && deviationFrom !== of ? deviationFrom : all.find((name) => name !== of);
    return [of, from ?? ""];
  }

  /** The least and the greatest distance, and their mean. */
  figures(): { least: number; most: number; mean: number } | null {
    let [least, most, sum, n] = [Infinity, -Infinity, 0, 0];
    for (const values of this.value.values.values()) {
      for (const value of values) {
        if (!Number.isFinite(value)) continue;
        least = Math.min(least, value);
        most = Math.max(most, value);
        sum += Math.abs(value);
        n++;
      }
    }
    // What rounding leaves of nothing is nothing.
    const reach = Math.max(Math.abs(least), Math.abs(most));
    const clean = (value: number): number => (Math.abs(value) < 1e-9 * reach ? 0 : value);
    return n > 0 ? { least: clean(least), most: clean(most), mean: sum / n } : null;
  }

  private async renew(): Promise<void> {
    if (this.settings.value.shade !== "deviation" || !this.doc.door.canEvaluate) return;
    const [of, from] = this.pair();
    const items = this.doc.items().filter(canBeMeasured);
    const measured = items.filter((item) => item.definition === of).map((item) => item.key);
    const base = items.filter((item) => item.definition === from).map((item) => item.key);
    const asked = `${measured.join(" ")} from ${base.join(" ")}`;
    if (asked === this.asked) return;
    this.asked = asked;
    const run = ++this.run;
    if (measured.length === 0 || base.length === 0) {
      this.set({ ...NOTHING, of, from, trouble: "There must be two surfaces or meshes with names of their own." });
      return;
    }
    const values = new Map<string, Float32Array>();
    this.set({ of, from, values, isWaiting: true, trouble: null });
    let trouble: string | null = null;
    for (const key of measured) {
      try {
        values.set(key, await this.distances(key, base));
      } catch (refusal) {
        trouble = refusal instanceof Error ? refusal.message : String(refusal);
      }
      if (run !== this.run) return;
    }
    this.set({ of, from, values, isWaiting: false, trouble });
  }

  private async distances(key: string, base: string[]): Promise<Float32Array> {
    const name = `${key} from ${base.join(" ")}`;
    let found = this.kept.get(name);
    if (!found) {
      found = await this.doc.door.deviation(key, base);
      this.kept.set(name, found);
      const [oldest] = this.kept.keys();
      if (this.kept.size > N_KEPT) this.kept.delete(oldest);
    }
    return found;
  }
}

function canBeMeasured(item: Item): boolean {
  return item.kind === "surface" || item.kind === "mesh";
}
