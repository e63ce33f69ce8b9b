// A value that tells its readers when it changes.

export class Signal<T> {
  private readonly readers = new Set<(value: T) => void>();

  constructor(private current: T) {}

  get value(): T {
    return this.current;
  }

  /** Puts a new value in place and tells every reader, also where it equals the old one. */
  set(value: T): void {
    this.current = value;
    for (const reader of this.readers) reader(value);
  }

  /** Sets what `change` makes of the present value. */
  update(change: (value: T) => T): void {
    this.set(change(this.current));
  }

  /** Calls `reader` now and at each change. */
  watch(reader: (value: T) => void): void {
    this.readers.add(reader);
    reader(this.current);
  }

  /** Calls `reader` at each change from now on, until what it gives back is called. */
  follow(reader: (value: T) => void): () => void {
    this.readers.add(reader);
    return () => void this.readers.delete(reader);
  }
}
