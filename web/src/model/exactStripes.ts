// The borders of stripes as the kernel has them: asked of the door for each visible surface when the camera rests.

import type { Stripes } from "../door/door";
import { Signal } from "../signal";
import type { Document } from "./document";
import { ItemQuestions } from "./itemQuestions";
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
  private readonly questions = new ItemQuestions<Float32Array>(REST, N_KEPT);

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
    if (!this.isWanted) return void (this.questions.turnTo("") && this.set(NOTHING));
    const { doc } = this;
    const stripes = this.seen();
    const seen = doc.items().filter((item) => doc.isVisible(item) && (item.kind === "surface" || item.kind === "mesh"));
    if (!this.questions.turnTo(JSON.stringify([stripes, seen.map((item) => item.key)]))) return;
    if (!this.value.isWaiting || this.value.lines.size > 0) this.set({ ...NOTHING, isWaiting: true });
    const without = seen.filter((item) => item.kind === "mesh").map((item) => item.path);
    const surfaces = seen.filter((item) => item.kind === "surface");
    this.questions.ask(surfaces, JSON.stringify(stripes), (key) => doc.door.stripes(key, stripes), (lines, troubles) => {
      this.set({ lines, isWaiting: false, without, trouble: troubles.at(-1) ?? null });
    });
  }
}
