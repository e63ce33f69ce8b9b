// Buffers of items by key: fetched once, kept while they are shown, and a while longer.

import type { Door, Item } from "../door/door";
import { type Buffers, decode } from "./bytes";

/** Bytes that may lie here unused, for who drags a parameter to and fro. */
const SPARE_BYTES = 64 * 1024 * 1024;
/** Requests under way at once; browsers allow six to one host, and one is the stream of events. */
const N_AT_ONCE = 4;
/** Small items that come in one answer, and how many triangles an item may have to be small. */
const N_TOGETHER = 200;
const N_TRIANGLES = 20_000;

export class Keeper {
  private readonly kept = new Map<string, Buffers>();
  private pinned = new Set<string>();
  n_fetched = 0;

  /** Called with the key of what goes. */
  forgotten: (key: string) => void = () => {};

  constructor(private readonly door: Door) {}

  /** The buffers of all these keys; those that are not here are fetched. */
  async gather(items: Item[]): Promise<Map<string, Buffers>> {
    const missing = new Map(items.filter(({ key }) => !this.kept.has(key)).map((item) => [item.key, item]));
    const portions = portioned([...missing.values()]);
    let n_next = 0;
    const fetchInTurn = async (): Promise<void> => {
      while (n_next < portions.length) {
        const portion = portions[n_next++];
        const all = await this.door.items(portion);
        all.forEach((bytes, i) => {
          this.n_fetched++;
          this.kept.set(portion[i], decode(bytes));
        });
      }
    };
    await Promise.all(Array.from({ length: N_AT_ONCE }, fetchInTurn));
    const found = new Map<string, Buffers>();
    for (const { key } of items) {
      const buffers = this.kept.get(key);
      if (buffers) found.set(key, buffers);
    }
    return found;
  }

  /** Says which keys must stay; of the others the longest unused go first. */
  pin(keys: Iterable<string>): void {
    this.pinned = new Set(keys);
    for (const key of this.pinned) {
      const buffers = this.kept.get(key);
      if (buffers) {
        this.kept.delete(key);
        this.kept.set(key, buffers);
      }
    }
    let n_spare = 0;
    for (const [key, buffers] of this.kept) if (!this.pinned.has(key)) n_spare += buffers.n_bytes;
    for (const [key, buffers] of this.kept) {
      if (n_spare <= SPARE_BYTES) break;
      if (this.pinned.has(key)) continue;
      n_spare -= buffers.n_bytes;
      this.kept.delete(key);
      this.forgotten(key);
    }
  }

  get n_kept(): number {
    return this.kept.size;
  }
}

/** Keys by the answers in which they come: large items alone, small ones together. */
function portioned(items: Item[]): string[][] {
  const portions: string[][] = [];
  let small: string[] = [];
  for (const { key, facts } of items) {
    if (Number(facts.triangles ?? 0) > N_TRIANGLES) {
      portions.push([key]);
      continue;
    }
    small.push(key);
    if (small.length === N_TOGETHER) portions.push(small.splice(0));
  }
  if (small.length > 0) portions.push(small);
  return portions;
}
