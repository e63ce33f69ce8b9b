// The model that was drawn last, to know when another one is in its place, for which the camera must go elsewhere.

import { type Box3, Vector3 } from "three";

import type { State } from "../door/door";

/** What is so many times as large or as small is not looked at from the same place. */
const OTHER_SIZE = 3;

export class KnownModel {
  private last: { script: string; definitions: Set<string>; box: Box3 } | null = null;

  /** Takes the state whose model has this box, and says whether it is another model than the last: of another script and
   * with other definitions or elsewhere, or without any of that one and where or as large as that one was not. */
  isReplacedBy({ script, items }: State, box: Box3): boolean {
    const { last } = this;
    const definitions = new Set(items.map((item) => item.definition));
    this.last = { script, definitions, box };
    if (!last) return false;
    const n_common = [...definitions].filter((name) => last.definitions.has(name)).length;
    const [before, now] = [last.box, box].map((one) => one.getSize(new Vector3()).length());
    const isElsewhere = !last.box.intersectsBox(box) || now > OTHER_SIZE * before || before > OTHER_SIZE * now;
    // One that has got another name is the same.
    if (last.script !== script) return isElsewhere || n_common < Math.max(definitions.size, last.definitions.size);
    return n_common === 0 && isElsewhere;
  }
}
