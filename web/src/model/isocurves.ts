// Lines of equal parameter in another number than items come with: asked of the door for each visible surface.

import { Signal } from "../signal";
import { type Buffers, decode } from "./bytes";
import type { Document } from "./document";
import { ItemQuestions } from "./itemQuestions";
import { N_ISOCURVES, type SettingsSignal } from "./settings";

export type Isocurves = Pick<Buffers, "isocurves" | "isocombs">;

/** Milliseconds for which nothing changes before the kernel is asked. */
const REST = 120;
/** Answers that are kept. */
const N_KEPT = 512;

/** The lines by the keys of items; an item that is not among them has those that came with it. */
export class ChosenIsocurves extends Signal<ReadonlyMap<string, Isocurves>> {
  private readonly questions = new ItemQuestions<Isocurves>(REST, N_KEPT);

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
    const { doc } = this;
    const { isocurveCount } = this.settings.value;
    const items = this.isWanted ? doc.items().filter((item) => item.kind === "surface" && doc.isVisible(item)) : [];
    const asked = items.length > 0 ? JSON.stringify([isocurveCount, items.map((item) => item.key)]) : "";
    if (!this.questions.turnTo(asked)) return;
    if (asked === "") return void (this.value.size > 0 && this.set(new Map()));
    const about = async (key: string): Promise<Isocurves> => {
      const { isocurves, isocombs } = decode(await doc.door.isocurves(key, isocurveCount));
      return { isocurves, isocombs };
    };
    this.questions.ask(items, String(isocurveCount), about, (lines, troubles) => {
      for (const trouble of troubles) doc.tell(trouble, true);
      this.set(lines);
    });
  }
}
