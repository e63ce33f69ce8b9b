// A worker with the module: asked from here, ended when it takes too long, and missed when it dies.

import { begin } from "./begin";

export type ToWorker =
  | { module: WebAssembly.Module; process: number }
  | { id: number; head: object; parts: Uint8Array[] };
export type FromWorker =
  | { id: number; value: unknown; attached: ArrayBuffer[] }
  | { id: number; refusal: string }
  | { fault: string };

export interface Answered<T> {
  value: T;
  attached: ArrayBuffer[];
}

/** The worker ended before it could answer. */
export class Ended extends Error {}

/** What a module refused, as a sentence for the person. */
export class Refused extends Error {}

interface Waiting {
  done: (answer: Answered<unknown>) => void;
  fail: (why: Error) => void;
}

/** Tells the keys of each worker's items from those of the others. */
let n_workers = 0;

export class Machine {
  private readonly worker = begin().workers.pop() ?? new Worker("worker.js");
  private readonly waiting = new Map<number, Waiting>();
  private n_calls = 0;
  private ending: Ended | null = null;

  /** `died` is told when the worker ends by itself. */
  constructor(
    module: Promise<WebAssembly.Module>,
    private readonly died: (why: string) => void,
  ) {
    this.worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.hear(data);
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.die(event.message || "the worker could not be started");
    };
    this.worker.onmessageerror = () => this.die("an answer could not be read");
    const process = ++n_workers;
    module.then((compiled) => this.send({ module: compiled, process }), (trouble: unknown) => this.die(`the interpreter could not be loaded: ${String(trouble)}`));
  }

  /** Asks; calls are answered one after the other. Fails with `Refused` or, when the worker ends, `Ended`. */
  ask<T>(head: object, parts: Uint8Array[] = []): Promise<Answered<T>> {
    if (this.ending) return Promise.reject(this.ending);
    return new Promise((done, fail) => {
      const id = this.n_calls++;
      this.waiting.set(id, { done: done as Waiting["done"], fail });
      this.send({ id, head, parts });
    });
  }

  /** Ends the worker at once; every call that waits fails. */
  end(why: string): void {
    if (this.ending) return;
    this.ending = new Ended(why);
    this.worker.terminate();
    for (const { fail } of this.waiting.values()) fail(this.ending);
    this.waiting.clear();
  }

  private die(why: string): void {
    if (this.ending) return;
    this.end(why);
    this.died(why);
  }

  private send(message: ToWorker): void {
    this.worker.postMessage(message);
  }

  private hear(answer: FromWorker): void {
    if ("fault" in answer) return this.die(answer.fault);
    const waiting = this.waiting.get(answer.id);
    this.waiting.delete(answer.id);
    if ("refusal" in answer) waiting?.fail(new Refused(answer.refusal));
    else waiting?.done(answer);
  }
}
