// A second worker that evaluates nothing: it colours, completes and explains while the first one is busy.

import type { Ask } from "./editor/places";
import type { Engine } from "./engine";
import { Machine } from "./machine";

/** So long may a run under way delay what needs its values, in milliseconds. */
const PATIENCE = 150;

export class Writer {
  private machine: Machine | null = null;
  private known = "";

  /** Its worker is begun after what would take longer beside it. */
  constructor(
    private readonly module: Promise<WebAssembly.Module>,
    private readonly engine: Engine,
    private readonly files: () => Iterable<readonly [string, Uint8Array]>,
    private readonly after: Promise<void>,
  ) {}

  /** Begins anew: files have changed, or another script is open. */
  renew(): void {
    this.machine?.end("another script was opened");
    this.machine = null;
  }

  readonly ask: Ask = async <T>(text: string, head: object, needsValues = false): Promise<T | null> => {
    if (needsValues) {
      await this.engine.rest(PATIENCE);
      const answer = await this.engine.askOfText<T>(text, head);
      if (answer) return answer.value;
    }
    if (!this.machine) await this.after;
    const machine = this.machine ?? this.begin();
    if (this.known !== text) void machine.ask({ call: "edit", text }).catch(() => {});
    this.known = text;
    return (await machine.ask<T>(head)).value;
  };

  private begin(): Machine {
    const machine: Machine = new Machine(this.module, () => {
      if (this.machine === machine) this.machine = null;
    });
    this.known = "";
    for (const [path, bytes] of this.files()) void machine.ask({ call: "file", path }, [bytes]).catch(() => {});
    this.machine = machine;
    return machine;
  }
}
