// The door of `virote view`: requests to the server that sent the page, and its stream of events.

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
} from "./door";

/** Waits between attempts to open a stream that the browser gave up, in milliseconds. */
const PAUSES = [250, 500, 1000, 2000, 4000];

export class HttpDoor implements Door {
  readonly canEvaluate = true;

  /** The state that came with the last event, until it is asked for. */
  private told: State | null = null;

  constructor(private readonly token: string) {}

  async state(): Promise<State> {
    const { told } = this;
    this.told = null;
    return told ?? ((await (await this.get("state")).json()) as State);
  }

  async items(keys: string[]): Promise<ArrayBuffer[]> {
    if (keys.length === 1) return [await (await this.get(`item/${encodeURIComponent(keys[0])}`)).arrayBuffer()];
    const bytes = await (await this.send("items", { items: keys })).arrayBuffer();
    const lengths = new Uint32Array(bytes, 4, keys.length);
    let start = aligned(4 + 4 * keys.length);
    return [...lengths].map((length, i) => {
      if (length === 0) throw new DoorError(`the item ${keys[i]} is not known any more`, 404);
      const item = bytes.slice(start, start + length);
      start = aligned(start + length);
      return item;
    });
  }

  ask(question: Question): Promise<Answer> {
    return this.post("ask", question);
  }

  measure(kind: Measurable, items: string[]): Promise<{ value: number; text: string }> {
    return this.post("measure", { kind, items });
  }

  async deviation(item: string, from: string[]): Promise<Float32Array> {
    return new Float32Array(await (await this.send("deviation", { item, from })).arrayBuffer());
  }

  async isocurves(item: string, count: number): Promise<ArrayBuffer> {
    return (await this.send("isocurves", { item, count })).arrayBuffer();
  }

  async stripes(item: string, stripes: Stripes): Promise<Float32Array> {
    return new Float32Array(await (await this.send("stripes", { item, ...stripes })).arrayBuffer());
  }

  async set(change: { values: Values } | { reset: true }): Promise<void> {
    await this.post("set", change);
  }

  async stop(): Promise<void> {
    await this.post("stop", {});
  }

  async write(values: Values): Promise<string[]> {
    return (await this.post<{ written: string[] }>("write", { values })).written;
  }

  async export(request: ExportRequest): Promise<string[]> {
    return (await this.post<{ files: string[] }>("export", request)).files;
  }

  /** Opens the stream, and opens it again for as long as the page lives. */
  listen(listener: (event: DoorEvent) => void): void {
    let n_failures = 0;
    const open = (): void => {
      const stream = new EventSource(`api/events?states=whole&token=${encodeURIComponent(this.token)}`);
      const tell = (kind: "busy" | "state") => (message: MessageEvent<string>) => {
        const { version, state } = JSON.parse(message.data) as { version: number; state?: State };
        if (kind === "state") this.told = state ?? null;
        listener({ kind, version });
      };
      stream.addEventListener("busy", tell("busy"));
      stream.addEventListener("state", tell("state"));
      stream.onopen = () => {
        n_failures = 0;
        listener({ kind: "connection", isOpen: true });
      };
      stream.onerror = () => {
        stream.close();
        this.told = null;
        listener({ kind: "connection", isOpen: false });
        // A stream does not tell why it was refused.
        this.state().catch((trouble: unknown) => {
          const isForeign = trouble instanceof DoorError && trouble.status === 403;
          if (isForeign) listener({ kind: "connection", isOpen: false, isForeign });
        });
        setTimeout(open, PAUSES[Math.min(n_failures++, PAUSES.length - 1)]);
      };
      addEventListener("pagehide", () => stream.close(), { once: true });
    };
    open();
  }

  private async get(path: string): Promise<Response> {
    return refuse(await fetch(`api/${path}`, { headers: { "X-Virote-Token": this.token } }));
  }

  private async post<T>(path: string, body: unknown): Promise<T> {
    return (await (await this.send(path, body)).json()) as T;
  }

  private async send(path: string, body: unknown): Promise<Response> {
    const response = await fetch(`api/${path}`, {
      method: "POST",
      headers: { "X-Virote-Token": this.token, "Content-Type": "application/json" },
      body: JSON.stringify(body),
    });
    return refuse(response);
  }
}

/** Where the next item of one answer begins. */
function aligned(place: number): number {
  return Math.ceil(place / 8) * 8;
}

/** The response itself, or the message that the server gave instead. */
async function refuse(response: Response): Promise<Response> {
  if (response.ok) return response;
  const text = await response.text();
  let message = text || response.statusText;
  try {
    const { error } = JSON.parse(text) as { error?: unknown };
    if (typeof error === "string") message = error;
  } catch {
    // The text stands as it is.
  }
  throw new DoorError(message, response.status);
}
