// Lines of equal parameter in another number than items come with: asked of the door for each visible surface, kept by their questions.

import type { Item } from "../door/door";
import { Signal } from "../signal";
import { type Buffers, decode } from "./bytes";
import type { Document } from "./document";
import { N_ISOCURVES, type SettingsSignal } from "./settings";

export type Isocurves = Pick<Buffers, "isocurves" | "isocombs">;

/** Milliseconds for which nothing changes before the kernel is asked. */
const REST = 120;
/** Answers that are kept. */
const N_KEPT = 512;

/** The lines by the keys of items; an item that is not among them has those that came with it. */
export class ChosenIsocurves extends Signal<ReadonlyMap<string, Isocurves>> {
  private readonly kept = new Map<string, Isocurves>();
  private asked = "";
  private run = 0;
  private timer = 0;

  constructor(
    private readonly doc: Document,
    private readonly settings: SettingsSignal,
  ) {
    super(new Map());
    for (const signal of [doc.scene, doc.choices]) signal.follow(() => this.renew());
    settings.follow(() => this.renew());
  }

  private get isWanted(): boolean {
    const { isocurves, combs, isocurveCount } = this.settings.value;
    return (isocurves || combs) && isocurveCount !== N_ISOCURVES && this.doc.door.canEvaluate;
  }

  /** Asks anew where something changed since the last question. */
  private renew(): void {
    const { isocurveCount } = this.settings.value;
    const items = this.isWanted ? this.doc.items().filter((item) => item.kind === "surface" && this.doc.isVisible(item)) : [];
    const asked = items.length > 0 ? JSON.stringify([isocurveCount, items.map((item) => item.key)]) : "";
    if (asked === this.asked) return;
    this.asked = asked;
    clearTimeout(this.timer);
    const run = ++this.run;
    if (asked === "") return void (this.value.size > 0 && this.set(new Map()));
    this.timer = setTimeout(() => void this.ask(run, items, isocurveCount), REST) as unknown as number;
  }

  private async ask(run: number, items: Item[], count: number): Promise<void> {
    const lines = new Map<string, Isocurves>();
    for (const { key, path } of items) {
      try {
        lines.set(key, await this.of(key, count));
      } catch (refusal) {
        if (run === this.run) this.doc.tell(`${path}: ${refusal instanceof Error ? refusal.message : String(refusal)}`, true);
      }
      if (run !== this.run) return;
    }
    this.set(lines);
  }

  private async of(key: string, count: number): Promise<Isocurves> {
    const name = `${key} ${count}`;
    let found = this.kept.get(name);
    if (!found) {
      const { isocurves, isocombs } = decode(await this.doc.door.isocurves(key, count));
      found = { isocurves, isocombs };
      this.kept.set(name, found);
      const [oldest] = this.kept.keys();
      if (this.kept.size > N_KEPT) this.kept.delete(oldest);
    }
    return found;
  }
}
