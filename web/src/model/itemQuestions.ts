// What is asked of the door for each of several items when nothing has changed for a moment; answers are kept by their questions.

import type { Item } from "../door/door";

export class ItemQuestions<Answer> {
  private readonly kept = new Map<string, Answer>();
  private asked = "";
  private run = 0;
  private timer = 0;

  /** Nothing is asked before it has rested for so many milliseconds; so many answers are kept. */
  constructor(
    private readonly rest: number,
    private readonly n_kept: number,
  ) {}

  /** Whether this is another question than the last one, which is in vain then; nothing is asked by an empty one. */
  turnTo(asked: string): boolean {
    if (asked === this.asked) return false;
    this.asked = asked;
    clearTimeout(this.timer);
    this.run++;
    return true;
  }

  /** Asks `about` each item in a moment, by `name`, and tells the answers by the keys of the items, with why others are missing, unless another question came. */
  ask(items: Item[], name: string, about: (key: string) => Promise<Answer>, tell: (answers: Map<string, Answer>, troubles: string[]) => void): void {
    const { run } = this;
    this.timer = setTimeout(async () => {
      const answers = new Map<string, Answer>();
      const troubles: string[] = [];
      for (const { key, path } of items) {
        try {
          answers.set(key, await this.answer(`${key} ${name}`, () => about(key)));
        } catch (refusal) {
          troubles.push(`${path}: ${refusal instanceof Error ? refusal.message : String(refusal)}`);
        }
        if (run !== this.run) return;
      }
      tell(answers, troubles);
    }, this.rest) as unknown as number;
  }

  private async answer(name: string, ask: () => Promise<Answer>): Promise<Answer> {
    let found = this.kept.get(name);
    if (!found) {
      found = await ask();
      this.kept.set(name, found);
      const [oldest] = this.kept.keys();
      if (this.kept.size > this.n_kept) this.kept.delete(oldest);
    }
    return found;
  }
}
