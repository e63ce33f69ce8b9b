// The door of an exported page: everything lies in the page itself, and nothing is evaluated.

import { type Answer, type Door, DoorError, type DoorEvent, type State } from "./door";

interface Embedded {
  state: State;
  items: Record<string, string>;
}

export class EmbeddedDoor implements Door {
  readonly canEvaluate = false;

  constructor(private readonly data: Embedded) {}

  /** The door of the data in this page, if it holds any. */
  static find(): EmbeddedDoor | null {
    const text = document.getElementById("virote-data")?.textContent;
    return text ? new EmbeddedDoor(JSON.parse(text) as Embedded) : null;
  }

  state(): Promise<State> {
    return Promise.resolve(this.data.state);
  }

  async items(keys: string[]): Promise<ArrayBuffer[]> {
    return keys.map((key) => this.item(key));
  }

  private item(key: string): ArrayBuffer {
    const text = this.data.items[key];
    if (text === undefined) throw new DoorError(`the page holds no item ${key}`, 404);
    const letters = atob(text);
    const bytes = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
    return bytes.buffer;
  }

  listen(listener: (event: DoorEvent) => void): void {
    queueMicrotask(() => listener({ kind: "state", version: this.data.state.version }));
  }

  ask(): Promise<Answer> {
    return cannot();
  }
  measure(): Promise<never> {
    return cannot();
  }
  deviation(): Promise<never> {
    return cannot();
  }
  isocurves(): Promise<never> {
    return cannot();
  }
  stripes(): Promise<never> {
    return cannot();
  }
  set(): Promise<void> {
    return cannot();
  }
  stop(): Promise<void> {
    return cannot();
  }
  write(): Promise<never> {
    return cannot();
  }
  export(): Promise<never> {
    return cannot();
  }
}

function cannot(): Promise<never> {
  return Promise.reject(new DoorError("this page shows a model; it cannot evaluate"));
}
