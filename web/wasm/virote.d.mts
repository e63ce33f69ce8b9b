// Types of virote.mjs.

export class Refusal extends Error {}

export interface Virote {
  ask(head: object, parts?: Uint8Array[]): { value: unknown; attached: Uint8Array[] };
  /** Bytes of memory that the module holds. */
  memory(): number;
}

export function open(module: WebAssembly.Module, process: number): Promise<Virote>;
