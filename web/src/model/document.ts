// What the page knows of the model: the newest state, its buffers, what is selected and what is hidden.

import { type Answer, type Check, type Door, DoorError, type Item, type Place, type State, type Vector } from "../door/door";
import { Signal } from "../signal";
import type { Buffers } from "./bytes";
import { Keeper } from "./keeper";

/** A state with the buffers of its visible items: what can be drawn. */
export interface Scene {
  state: State;
  buffers: Map<string, Buffers>;
}

/** A place that was clicked, first as the mesh has it, then as the door answers. */
export interface Hit {
  path: string;
  item: Item;
  point: Vector;
  normal: Vector | null;
  parameters: Place | null;
  /** What the click was drawn to, such as the end of a curve. */
  snapped?: string | null;
  /** The triangle, where the place is on one. */
  triangle: number | null;
  /** Which of its points, where the place is one of many. */
  index?: number | null;
  answer: Answer | null;
  trouble: string | null;
}

/** Milliseconds on the clock of the machine. */
export function now(): number {
  return performance.timeOrigin + performance.now();
}

/** What tells a claim from the others of its script. */
export function claimName({ text, line }: Check): string {
  return `${line ?? ""} ${text}`;
}

export interface Ghost {
  scene: Scene;
  hidden: Set<string>;
}

/** Milliseconds until the door is asked again that gave no answer. */
const AGAIN = 1000;
/** Milliseconds between two states that are listed: nobody reads faster, and lists take longer to paint than pictures. */
const LISTING = 400;

export class Document {
  readonly state = new Signal<State | null>(null);
  readonly scene = new Signal<Scene | null>(null);
  /** The state that the panels list: the newest one, soon after its picture, but not each of many in a row. */
  readonly listed = new Signal<State | null>(null);
  readonly isBusy = new Signal(false);
  readonly isOnline = new Signal(true);
  /** Whether another server answers in the place of the one that sent this page. */
  isForeign = false;
  /** Paths of the selected items. */
  readonly selection = new Signal<ReadonlySet<string>>(new Set());
  /** Paths whose visibility the person chose. */
  readonly choices = new Signal<ReadonlyMap<string, boolean>>(new Map());
  readonly hit = new Signal<Hit | null>(null);
  /** The place that a click would be drawn to. */
  readonly lure = new Signal<Hit | null>(null);
  /** The hits of a measurement, one or two. */
  readonly marks = new Signal<Hit[]>([]);
  readonly isMeasuring = new Signal(false);
  /** The claim whose places are shown, by its name. */
  readonly claim = new Signal<string | null>(null);
  readonly ghost = new Signal<Ghost | null>(null);
  readonly message = new Signal<{ text: string; isTrouble: boolean } | null>(null);
  readonly keeper: Keeper;
  /** When the newest state was told, arrived, and had all its buffers. */
  readonly times = { event: 0, state: 0, buffers: 0 };
  private loaded = -1;
  /** The version that the door told last. */
  private told = -1;
  private isStale = true;
  private isLoading = false;
  private isUnreached = false;
  private timer = 0;
  private isListing = false;
  private listedAt = -LISTING;
  /** The version that is drawn. */
  private pictured = -1;
  private awaiting: { after: number; done: () => void }[] = [];

  /** The first state, where it is fetched before anybody follows. */
  private ahead: Promise<State> | null = null;

  constructor(readonly door: Door) {
    this.keeper = new Keeper(door);
    this.choices.follow(() => void this.complete());
  }

  /** Fetches the first state and its items before anybody follows; what fails is asked for again then. */
  fetchAhead(): void {
    const fetched = this.door.state().then(async (state) => {
      await this.keeper.gather(state.items.filter((item) => this.isVisible(item))).catch(() => {});
      return state;
    });
    fetched.catch(() => {});
    this.ahead = fetched;
  }

  /** Asks for the first state and begins to follow the door. */
  start(): void {
    void this.refresh();
    this.door.listen((event) => {
      if (event.kind === "connection") {
        // Behind a new connection may be a new server, which counts from the beginning.
        if (event.isOpen && !this.isOnline.value) this.loaded = this.told = -1;
        this.isForeign = event.isForeign ?? false;
        this.isOnline.set(event.isOpen);
      } else if (event.kind === "busy") {
        this.isBusy.set(true);
      } else {
        this.isBusy.set(false);
        const isLoaded = event.version === this.loaded;
        this.told = event.version;
        this.release();
        if (isLoaded) return;
        this.times.event = now();
        this.isStale = true;
        void this.refresh();
      }
    });
  }

  /** The version that the door told last; -1 before the first. */
  get version(): number {
    return this.told;
  }

  /** Resolves once the door has told a newer version than this, and the one before it is drawn. */
  passed(after: number): Promise<void> {
    return new Promise((done) => {
      this.awaiting.push({ after, done });
      this.release();
    });
  }

  /** The scene is drawn. */
  drawn(): void {
    this.pictured = this.scene.value?.state.version ?? -1;
    this.release();
  }

  private release(): void {
    const isOver = ({ after }: { after: number }): boolean => this.told > after && this.told <= this.pictured + 1;
    const over = this.awaiting.filter(isOver);
    if (over.length === 0) return;
    this.awaiting = this.awaiting.filter((one) => !isOver(one));
    for (const { done } of over) done();
  }

  isVisible(item: Item): boolean {
    return this.choices.value.get(item.path) ?? (!item.isHidden && item.isShown !== false);
  }

  /** The selected items of the newest scene, in the order of the script. */
  selected(): Item[] {
    const { value } = this.selection;
    return this.items().filter((item) => value.has(item.path));
  }

  items(): Item[] {
    return this.scene.value?.state.items ?? [];
  }

  /** The points of the claim that was clicked, as the newest state has them. */
  claimed(): Vector[] {
    const { value } = this.claim;
    const found = value === null ? undefined : this.state.value?.checks.find((check) => claimName(check) === value);
    return found?.places ?? [];
  }

  show(paths: Iterable<string>, isVisible: boolean): void {
    const choices = new Map(this.choices.value);
    for (const path of paths) choices.set(path, isVisible);
    this.choices.set(choices);
  }

  /** Shows these paths and nothing else. */
  isolate(paths: ReadonlySet<string>): void {
    this.choices.set(new Map(this.items().map((item) => [item.path, paths.has(item.path)])));
  }

  select(paths: Iterable<string>, isAdded = false): void {
    const chosen = new Set(isAdded ? this.selection.value : []);
    for (const path of paths) {
      if (isAdded && chosen.has(path)) chosen.delete(path);
      else chosen.add(path);
    }
    this.selection.set(chosen);
  }

  /** Keeps the present picture to compare the next ones with, or lets it go. */
  toggleGhost(): void {
    const scene = this.scene.value;
    if (this.ghost.value || !scene) this.ghost.set(null);
    else {
      const hidden = scene.state.items.filter((item) => !this.isVisible(item));
      this.ghost.set({ scene, hidden: new Set(hidden.map((item) => item.path)) });
    }
    this.pin();
  }

  /** Tells the person something for a moment. */
  tell(text: string, isTrouble = false): void {
    this.message.set({ text, isTrouble });
  }

  /** Carries out a call of the door and tells the person when it is refused. */
  async attempt<T>(call: Promise<T>): Promise<T | null> {
    try {
      return await call;
    } catch (trouble) {
      this.tell(trouble instanceof Error ? trouble.message : String(trouble), true);
      return null;
    }
  }

  /** Fetches the newest state and what it needs; states that came meanwhile are skipped but for the last. */
  private async refresh(): Promise<void> {
    if (this.isLoading) return;
    this.isLoading = true;
    let n_lost = 0;
    try {
      while (this.isStale) {
        this.isStale = false;
        const { ahead } = this;
        this.ahead = null;
        const state = await (ahead ?? this.door.state());
        if (!this.isOnline.value) this.isOnline.set(true);
        // What was told meanwhile is this very state, or one that it has overtaken.
        if (this.told <= state.version && this.told >= 0) this.isStale = false;
        try {
          this.times.state = now();
          const buffers = await this.keeper.gather(state.items.filter((item) => this.isVisible(item)));
          this.times.buffers = now();
          this.loaded = state.version;
          if (this.told === state.version) this.isStale = false;
          this.state.set(state);
          this.scene.set({ state, buffers });
          this.pin();
          this.list();
        } catch (trouble) {
          // The server forgot an item of a state that is no longer the newest: ask again.
          if (!(trouble instanceof DoorError && trouble.status === 404) || ++n_lost > 5) throw trouble;
          this.isStale = true;
          continue;
        }
      }
    } catch (trouble) {
      if (trouble instanceof TypeError) this.isUnreached = true;
      else this.tell(String(trouble instanceof Error ? trouble.message : trouble), true);
    } finally {
      this.isLoading = false;
    }
    if (this.isUnreached) this.tryAgain();
  }

  /** Lets the panels list the newest state, behind its frame where there is one soon. */
  private list(): void {
    if (this.isListing) return;
    this.isListing = true;
    const tell = (): void => {
      if (!this.isListing) return;
      this.isListing = false;
      this.listedAt = performance.now();
      this.listed.set(this.state.value);
    };
    const wait = Math.max(0, this.listedAt + LISTING - performance.now());
    requestAnimationFrame(() => setTimeout(tell, wait));
    // A hidden page has no frames.
    setTimeout(tell, wait + LISTING);
  }

  /** Nobody answered, though something may have been told: asks again until somebody does. */
  private tryAgain(): void {
    this.isUnreached = false;
    this.isStale = true;
    this.isOnline.set(false);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.refresh(), AGAIN) as unknown as number;
  }

  /** Fetches what has become visible; a state that comes meanwhile brings its own. */
  private async complete(): Promise<void> {
    const scene = this.scene.value;
    const wanted = scene?.state.items.filter((item) => this.isVisible(item)) ?? [];
    if (!scene || wanted.every(({ key }) => scene.buffers.has(key))) return;
    const buffers = await this.attempt(this.keeper.gather(wanted));
    if (!buffers || this.scene.value !== scene) return;
    this.scene.set({ state: scene.state, buffers });
    this.pin();
  }

  private pin(): void {
    const scenes = [this.scene.value, this.ghost.value?.scene];
    this.keeper.pin(scenes.flatMap((scene) => scene?.state.items.map((item) => item.key) ?? []));
  }
}
