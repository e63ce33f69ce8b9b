// Keeps the script evaluated: the newest text and values, in a worker that may be stopped or die at any time.

import type { Diagnostic, State, Values } from "../../src/door/door";
import { Signal } from "../../src/signal";
import type { Finding } from "./editor/places";
import { type Answered, Ended, Machine } from "./machine";

/** A run is given up for a newer text once it has lasted so long, in milliseconds, or twice the longest good one. */
const PATIENCE = 2000;
/** So many workers may die one after the other before it is left at that. */
const MOST_DEATHS = 3;

/** Why a run did not come to its end. */
const STOPPED = "the evaluation was stopped";
const OVERTAKEN = "a newer text is evaluated";

export interface Script {
  name: string;
  text: string;
  /** Values of parameters that are set beside the script. */
  values: Record<string, string>;
}

export type Change = { values: Values } | { reset: true };

interface Wish {
  change: Change;
  done: () => void;
  fail: (why: unknown) => void;
}

export class Engine {
  /** The newest state; null before the first. */
  readonly state = new Signal<State | null>(null);
  readonly isBusy = new Signal(false);
  /** What was found in the text that was evaluated last, and its state where it came to one. */
  readonly findings = new Signal<{ text: string; all: Finding[]; state: State | null }>({ text: "", all: [], state: null });
  /** What happened that no state tells. */
  readonly news = new Signal("");
  /** How many workers were begun. */
  n_begun = 0;
  private machine: Machine | null = null;
  private script: Script = { name: "", text: "", values: {} };
  /** The last script that was evaluated to its end without errors, for a worker that begins anew. */
  private good: Script | null = null;
  private readonly wishes: Wish[] = [];
  private isTextNew = false;
  private isWorking = false;
  /** The text that the worker has. */
  private known = "";
  private begin = 0;
  private longest = 0;
  private n_deaths = 0;
  private version = 0;

  /** `files` are all that stand beside the script. */
  constructor(
    private readonly module: Promise<WebAssembly.Module>,
    private readonly files: () => Iterable<readonly [string, Uint8Array]>,
  ) {}

  /** Takes another script in the place of the present one. */
  open(script: Script): void {
    this.script = copied(script);
    this.good = null;
    this.beginAnew();
  }

  /** Evaluates in a new worker, with the files as they are now. */
  beginAnew(): void {
    this.giveUp(OVERTAKEN);
    this.again();
  }

  /** Evaluates a newer text of the script. */
  edit(text: string): void {
    this.script.text = text;
    this.again();
    const { begin } = this;
    const rest = Math.max(PATIENCE, 2 * this.longest) - (performance.now() - begin);
    const look = (): void => {
      if (this.isWorking && this.isTextNew && this.begin === begin) this.giveUp(OVERTAKEN);
    };
    setTimeout(look, Math.max(0, rest));
  }

  /** Evaluates the text once more. */
  again(): void {
    this.n_deaths = 0;
    this.isTextNew = true;
    void this.work();
  }

  /** Changes values of parameters; resolves once their model is there. */
  set(change: Change): Promise<void> {
    return new Promise((done, fail) => {
      this.wishes.push({ change, done, fail });
      void this.work();
    });
  }

  /** Ends the run under way; the last good model stays. */
  stop(): void {
    if (this.isWorking) this.giveUp(STOPPED);
  }

  /** Asks about the model that is shown. */
  async ask<T>(head: object): Promise<Answered<T>> {
    if (!this.machine) throw new Ended("there is no model yet");
    return this.machine.ask<T>(head);
  }

  /** Asks about the text as it is now, evaluated or not; null while a run is under way. */
  async askOfText<T>(text: string, head: object): Promise<Answered<T> | null> {
    const { machine } = this;
    if (this.isWorking || !machine) return null;
    if (this.known !== text) void machine.ask({ call: "edit", text }).catch(() => {});
    this.known = text;
    return machine.ask<T>(head);
  }

  /** Resolves once nothing is under way, or after so many milliseconds. */
  rest(patience: number): Promise<void> {
    return new Promise((done) => {
      const timer = setTimeout(done, patience);
      const look = (): void => {
        if (this.isWorking) return;
        clearTimeout(timer);
        leave();
        done();
      };
      const leave = this.isBusy.follow(look);
      look();
    });
  }

  /** Values that the person has set, as a link keeps them. */
  get values(): Record<string, string> {
    return this.script.values;
  }

  /** Tells that values have become defaults in the text. */
  forget(names: string[]): void {
    for (const name of names) delete this.script.values[name];
  }

  private giveUp(why: string): void {
    this.machine?.end(why);
    this.machine = null;
  }

  /** Evaluates until nothing newer is wanted. */
  private async work(): Promise<void> {
    if (this.isWorking) return;
    this.isWorking = true;
    while (this.isTextNew || this.wishes.length > 0) {
      this.isBusy.set(true);
      this.begin = performance.now();
      try {
        await this.run();
      } catch (why) {
        this.machine = null;
        const reason = why instanceof Error ? why.message : String(why);
        if (reason !== OVERTAKEN) await this.recover(reason);
      }
    }
    this.isWorking = false;
    this.isBusy.set(false);
  }

  /** One run: of the text, if it is new, and then with the values that are wished for. */
  private async run(): Promise<void> {
    const script = copied(this.script);
    const isTextNew = this.isTextNew || !this.machine;
    this.isTextNew = false;
    let state: State | null = null;
    if (!this.machine) state = await this.load(script);
    else if (isTextNew) state = await this.evaluate(this.machine, script.text);
    const { machine } = this;
    if (!machine) throw new Ended(OVERTAKEN);
    for (let wish = this.wishes.shift(); wish; wish = this.wishes.shift()) {
      state = (await granted(wish, machine, script)) ?? state;
    }
    if (!state) return;
    this.script.values = { ...script.values };
    if (state.isCurrent) {
      this.longest = Math.max(this.longest, performance.now() - this.begin);
      this.good = script;
    }
    const { value: all } = await machine.ask<Finding[]>({ call: "findings" });
    this.show(state);
    this.findings.set({ text: script.text, all, state });
  }

  /** A new worker with the files beside the script. */
  private machineFor({ name }: Script): Machine {
    const machine: Machine = new Machine(this.module, (why) => this.died(machine, why));
    this.machine = machine;
    this.n_begun++;
    this.known = "";
    // Should the worker end, the call that is waited for tells it.
    const send = (head: object, parts?: Uint8Array[]): void => void machine.ask(head, parts).catch(() => {});
    send({ call: "reset", name });
    for (const [path, bytes] of this.files()) if (path !== name) send({ call: "file", path }, [bytes]);
    return machine;
  }

  /** A script with its values in a new worker. */
  private async load(script: Script): Promise<State> {
    const machine = this.machineFor(script);
    const state = await this.evaluate(machine, script.text);
    const names = new Set(state.parameters.map((one) => one.name));
    const values = Object.fromEntries(Object.entries(script.values).filter(([name]) => names.has(name)));
    if (Object.keys(values).length === 0) return state;
    return (await machine.ask<State>({ call: "set", values })).value;
  }

  private async evaluate(machine: Machine, text: string): Promise<State> {
    this.known = text;
    return (await machine.ask<State>({ call: "text", text })).value;
  }

  /** After a run that was stopped, or in which the worker died: the last good model again, and why. */
  private async recover(reason: string): Promise<void> {
    for (const wish of this.wishes.splice(0)) wish.fail(unchanged(reason));
    const { good } = this;
    const told = reason === STOPPED ? reason : `the evaluation broke off: ${reason}`;
    try {
      const state = good ? await this.load(good) : await this.empty();
      if (good) this.script.values = { ...good.values };
      const rest = good ? "what stands here is the last whole model" : "change the script, or evaluate it again with Ctrl Enter";
      this.showTrouble(state, `${told}; ${rest}`);
    } catch (why) {
      this.machine = null;
      if (why instanceof Ended && why.message === OVERTAKEN) return;
      this.good = null;
      const state = await this.empty().catch(() => null);
      if (state) this.showTrouble(state, told);
      else this.news.set(told);
    }
  }

  /** The state of a worker that has evaluated nothing. */
  private async empty(): Promise<State> {
    return (await this.machineFor(this.script).ask<State>({ call: "state" })).value;
  }

  /** A worker died; in a run that one fails, and otherwise it is only begun anew. */
  private died(machine: Machine, why: string): void {
    if (this.isWorking || machine !== this.machine) return;
    this.machine = null;
    const isTooMuch = ++this.n_deaths >= MOST_DEATHS;
    this.news.set(`the interpreter broke off (${why}); ${isTooMuch ? "evaluate again with Ctrl Enter" : "it was begun anew"}`);
    if (isTooMuch) return;
    this.isTextNew = true;
    void this.work();
  }

  private showTrouble(state: State, message: string): void {
    const trouble: Diagnostic = { severity: "error", code: null, message, text: message, file: null, line: null, column: null };
    this.show({ ...state, isCurrent: false, diagnostics: [trouble] });
    this.findings.set({ text: this.script.text, all: [], state: null });
  }

  private show(state: State): void {
    // Each worker counts from the beginning; the page does not.
    this.state.set({ ...state, version: ++this.version });
  }
}

function copied(script: Script): Script {
  return { ...script, values: { ...script.values } };
}

/** The state with the values that are wished for, which the script then has; null where they are refused. */
async function granted({ change, done, fail }: Wish, machine: Machine, script: Script): Promise<State | null> {
  try {
    const { value } = await machine.ask<State>({ call: "set", ...change });
    if ("reset" in change) script.values = {};
    else for (const [name, text] of Object.entries(change.values)) {
      if (text === null) delete script.values[name];
      else script.values[name] = text;
    }
    done();
    return value;
  } catch (why) {
    fail(why instanceof Ended ? unchanged(why.message) : why);
    if (why instanceof Ended) throw why;
    return null;
  }
}

function unchanged(reason: string): Error {
  return new Error(`${reason}; the values are as they were`);
}
