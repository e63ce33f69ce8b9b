// The door of the playground: the calls of `virote view`, answered by the worker.

import {
  type Answer,
  type Door,
  DoorError,
  type DoorEvent,
  type ExportRequest,
  type Measurable,
  type Question,
  type State,
  type Stripes,
  type Values,
} from "../../src/door/door";
import type { Change, Engine } from "./engine";
import { type Answered, Ended } from "./machine";

/** What the door asks of the page around it. */
export interface Surroundings {
  /** Puts a text in the place of the script's. */
  replace(text: string): void;
  /** Hands files to the person. */
  deliver(files: [string, ArrayBuffer][]): void;
}

export class WorkerDoor implements Door {
  readonly canEvaluate = true;
  readonly isDownloading = true;

  constructor(
    private readonly engine: Engine,
    private readonly page: Surroundings,
  ) {}

  state(): Promise<State> {
    const { state } = this.engine;
    if (state.value) return Promise.resolve(state.value);
    return new Promise((done) => {
      const leave = state.follow((first) => {
        leave();
        done(first!);
      });
    });
  }

  async items(keys: string[]): Promise<ArrayBuffer[]> {
    const { attached } = await this.call({ call: "items", items: keys }, 404);
    const lost = attached.findIndex((bytes) => bytes.byteLength === 0);
    if (lost >= 0) throw new DoorError(`the item ${keys[lost]} is not known any more`, 404);
    return attached;
  }

  async ask(question: Question): Promise<Answer> {
    return (await this.call<Answer>({ call: "ask", ...question })).value;
  }

  async measure(kind: Measurable, items: string[]): Promise<{ value: number; text: string }> {
    return (await this.call<{ value: number; text: string }>({ call: "measure", kind, items })).value;
  }

  async deviation(item: string, from: string[]): Promise<Float32Array> {
    return new Float32Array((await this.call({ call: "deviation", item, from })).attached[0]);
  }

  async isocurves(item: string, count: number): Promise<ArrayBuffer> {
    return (await this.call({ call: "isocurves", item, count })).attached[0];
  }

  async stripes(item: string, stripes: Stripes): Promise<Float32Array> {
    return new Float32Array((await this.call({ call: "stripes", item, ...stripes })).attached[0]);
  }

  set(change: Change): Promise<void> {
    return this.engine.set(change);
  }

  async stop(): Promise<void> {
    this.engine.stop();
  }

  async write(values: Values): Promise<string[]> {
    const { written, text } = (await this.call<{ written: string[]; text: string }>({ call: "write", values })).value;
    this.engine.forget(written);
    this.page.replace(text);
    return written;
  }

  async export(request: ExportRequest): Promise<string[]> {
    // After a run that was stopped the worker has the model before it.
    if (!this.engine.state.value?.isCurrent) throw new DoorError("the script has errors or was stopped; nothing is written");
    const { value, attached } = await this.call<{ files: string[] }>({ call: "export", ...request });
    this.page.deliver(value.files.map((path, i) => [path, attached[i]]));
    return value.files;
  }

  listen(listener: (event: DoorEvent) => void): void {
    const { state, isBusy } = this.engine;
    const version = (): number => state.value?.version ?? 0;
    isBusy.watch((busy) => listener({ kind: busy ? "busy" : "state", version: version() }));
    state.follow(() => listener({ kind: "state", version: version() }));
  }

  /** Asks the worker; `status` is that of the refusal when it ends meanwhile. */
  private async call<T = object>(head: object, status = 0): Promise<Answered<T>> {
    try {
      return await this.engine.ask<T>(head);
    } catch (why) {
      throw new DoorError(why instanceof Error ? why.message : String(why), why instanceof Ended ? status : 0);
    }
  }
}
