// The folder beside the script: what the browser keeps, and under it the examples with their data.

import { bytesOf } from "./link";

interface Kept {
  name: string;
  bytes: Uint8Array<ArrayBuffer>;
  /** When it was changed last, in milliseconds. */
  changed: number;
}

export interface Example {
  name: string;
  title: string;
}

/** Scripts end so; everything else is data. */
export function isScript(name: string): boolean {
  return name.endsWith(".geo");
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

export class Folder {
  readonly examples: Example[] = [];
  private readonly own = new Map<string, Kept>();
  /** Files of the link that is open, where the person has others of the same name. */
  private readonly lent = new Map<string, Uint8Array<ArrayBuffer>>();
  private readonly bundled = new Map<string, Uint8Array<ArrayBuffer>>();
  private database: IDBDatabase | null = null;
  private writes: Promise<unknown> = Promise.resolve();

  /** Opens what the browser keeps. Without storage the folder lives as long as the page. */
  async open(): Promise<void> {
    const request = indexedDB.open("virote", 1);
    request.onupgradeneeded = () => request.result.createObjectStore("files", { keyPath: "name" });
    this.database = await result(request);
    const all = await result(this.database.transaction("files").objectStore("files").getAll() as IDBRequest<Kept[]>);
    for (const one of all) this.own.set(one.name, one);
  }

  /** Fetches the examples that were put beside the page. */
  async fetchExamples(): Promise<void> {
    const response = await fetch("examples.json");
    if (!response.ok) throw new Error(`examples.json: ${response.status} ${response.statusText}`);
    const { examples, files } = (await response.json()) as { examples: Example[]; files: Record<string, string> };
    this.examples.push(...examples);
    for (const [name, text] of Object.entries(files)) this.bundled.set(name, bytesOf(text));
  }

  /** Every file: of one name that of the open link before the person's, and that before an example's. */
  files(): Iterable<readonly [string, Uint8Array]> {
    const own = [...this.own.values()].map(({ name, bytes }) => [name, bytes] as const);
    return new Map([...this.bundled, ...own, ...this.lent]);
  }

  /** Takes the files of a link: keeps those that are new, and lends those of which the person has others. */
  async lend(files: Record<string, string>): Promise<void> {
    this.lent.clear();
    for (const [name, text] of Object.entries(files)) {
      const own = this.own.get(name);
      const bytes = bytesOf(text);
      if (!own) await this.put(name, bytes);
      else if (decoder.decode(own.bytes) !== decoder.decode(bytes)) this.lent.set(name, bytes);
    }
  }

  /** The person's files, those that were changed last first. */
  list(): { name: string; size: number }[] {
    const all = [...this.own.values()].sort((a, b) => b.changed - a.changed || (a.name < b.name ? -1 : 1));
    return all.map(({ name, bytes }) => ({ name, size: bytes.length }));
  }

  has(name: string): boolean {
    return this.own.has(name);
  }

  bytes(name: string): Uint8Array<ArrayBuffer> | null {
    return this.own.get(name)?.bytes ?? null;
  }

  /** The text of a file of the person. */
  text(name: string): string | null {
    const kept = this.own.get(name);
    return kept ? decoder.decode(kept.bytes) : null;
  }

  /** The text of an example as it came. */
  example(name: string): string | null {
    const bytes = this.bundled.get(name);
    return bytes ? decoder.decode(bytes) : null;
  }

  /** Keeps a file; resolves once the browser has it, and fails where it takes no more. */
  put(name: string, content: string | Uint8Array<ArrayBuffer>): Promise<void> {
    const bytes = typeof content === "string" ? encoder.encode(content) : content;
    const kept = { name, bytes, changed: Date.now() };
    this.own.set(name, kept);
    return this.write((files) => files.put(kept));
  }

  remove(name: string): Promise<void> {
    this.own.delete(name);
    return this.write((files) => files.delete(name));
  }

  /** This name, or one like it that no file of the person has. */
  freeName(name: string): string {
    if (!this.own.has(name)) return name;
    const dot = name.lastIndexOf(".");
    const [stem, ending] = dot > 0 ? [name.slice(0, dot), name.slice(dot)] : [name, ""];
    let n = 2;
    while (this.own.has(`${stem}-${n}${ending}`)) n++;
    return `${stem}-${n}${ending}`;
  }

  /** The person's files that a script names, and those that the scripts among them name. */
  needs(text: string): string[] {
    const found = new Set<string>();
    const texts = [text];
    for (let next = texts.pop(); next !== undefined; next = texts.pop()) {
      for (const [, name] of next.matchAll(/"(?:\.\/)?([^"\n]+)"/g)) {
        if (found.has(name) || !this.own.has(name)) continue;
        found.add(name);
        if (isScript(name)) texts.push(this.text(name)!);
      }
    }
    return [...found];
  }

  private write(change: (files: IDBObjectStore) => IDBRequest): Promise<void> {
    const { database } = this;
    if (!database) return Promise.resolve();
    const written = this.writes.catch(() => {}).then(async () => {
      await result(change(database.transaction("files", "readwrite").objectStore("files")));
    });
    this.writes = written;
    return written;
  }
}

function result<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((done, fail) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => fail(request.error ?? new Error("the browser's storage cannot be used"));
  });
}
