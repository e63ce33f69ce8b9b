// The borders of stripes as the kernel has them: asked of the door for each visible surface when the camera rests, kept by their questions.

import type { Item, Stripes } from "../door/door";
import { Signal } from "../signal";
import type { Document } from "./document";
import type { SettingsSignal } from "./settings";

/** Answers that are kept. */
const N_KEPT = 64;
/** Milliseconds for which nothing changes before the kernel is asked. */
const REST = 150;

export interface ExactLines {
  /** Pairs of ends by the key of the item; empty while the answer is under way. */
  lines: ReadonlyMap<string, Float32Array>;
  isWaiting: boolean;
  /** Items that have none, as meshes. */
  without: string[];
  trouble: string | null;
}

const NOTHING: ExactLines = { lines: new Map(), isWaiting: false, without: [], trouble: null };

export class ExactStripes extends Signal<ExactLines> {
  private readonly kept = new Map<string, Float32Array>();
  private asked = "";
  private run = 0;
  private timer = 0;

  /** `seen` tells how the stripes lie for the present camera. */
  constructor(
    private readonly doc: Document,
    private readonly settings: SettingsSignal,
    private readonly seen: () => Stripes,
  ) {
    super(NOTHING);
  }

  /** Whether the kernel's curves are wanted. */
  get isWanted(): boolean {
    const { shade, exactStripes } = this.settings.value;
    return exactStripes && this.doc.door.canEvaluate && (shade === "zebra" || shade === "isophotes");
  }

  /** Asks anew where something changed since the last question. */
  renew(): void {
    if (!this.isWanted) {
      if (this.asked === "") return;
      this.asked = "";
      clearTimeout(this.timer);
      this.run++;
      return this.set(NOTHING);
    }
    const stripes = this.seen();
    const items = this.doc.items().filter((item) => this.doc.isVisible(item) && (item.kind === "surface" || item.kind === "mesh"));
    const asked = JSON.stringify([stripes, items.map((item) => item.key)]);
    if (asked === this.asked) return;
    this.asked = asked;
    clearTimeout(this.timer);
    const run = ++this.run;
    if (!this.value.isWaiting || this.value.lines.size > 0) this.set({ ...NOTHING, isWaiting: true });
    this.timer = setTimeout(() => void this.ask(run, items, stripes), REST) as unknown as number;
  }

  private async ask(run: number, items: Item[], stripes: Stripes): Promise<void> {
    const lines = new Map<string, Float32Array>();
    const without: string[] = [];
    let trouble: string | null = null;
    for (const { key, kind, path } of items) {
      if (kind === "mesh") {
        without.push(path);
        continue;
      }
      try {
        lines.set(key, await this.of(key, stripes));
      } catch (refusal) {
        trouble = `${path}: ${refusal instanceof Error ? refusal.message : String(refusal)}`;
      }
      if (run !== this.run) return;
    }
    this.set({ lines, isWaiting: false, without, trouble });
  }

  private async of(key: string, stripes: Stripes): Promise<Float32Array> {
    const name = `${key} ${JSON.stringify(stripes)}`;
    let found = this.kept.get(name);
    if (!found) {
      found = await this.doc.door.stripes(key, stripes);
      this.kept.set(name, found);
      const [oldest] = this.kept.keys();
      if (this.kept.size > N_KEPT) this.kept.delete(oldest);
    }
    return found;
  }
}
