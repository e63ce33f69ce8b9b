// How the person wants to look: everything that changes the picture and nothing of the model.

import type { Vector } from "../door/door";
import { Signal } from "../signal";

export type Shade =
  | "plain"
  | "zebra"
  | "isophotes"
  | "gauss"
  | "mean"
  | "k1"
  | "k2"
  | "draft"
  | "sides"
  | "deviation";
export type Theme = "auto" | "light" | "dark";
export type Direction = "x" | "y" | "z" | "view";

export interface Settings {
  theme: Theme;
  isOrthographic: boolean;
  grid: boolean;
  edges: boolean;
  isocurves: boolean;
  wireframe: boolean;
  control: boolean;
  knots: boolean;
  normals: boolean;
  combs: boolean;
  /** Open and shared edges. */
  shell: boolean;
  /** Whether clicks go to ends, knots, corners and vertices nearby. */
  snap: boolean;
  /** Lines of equal parameter inside a surface, in each direction. */
  isocurveCount: number;
  combsOf: "all" | "selection";
  combScale: number;
  /** Teeth are drawn at every n-th vertex. */
  combStride: number;
  shade: Shade;
  stripes: number;
  stripesAcross: boolean;
  /** Whether stripes are shown by the kernel's curves. */
  exactStripes: boolean;
  light: Direction;
  draftAxis: "x" | "y" | "z";
  draftDegrees: number;
  /** Names of the definitions of which, and from which, the deviation is shown; empty where nobody chose. */
  deviationOf: string;
  deviationFrom: string;
  section: boolean;
  sectionAxis: "x" | "y" | "z" | "free";
  sectionFlip: boolean;
  sectionNormal: Vector;
  /** Where the plane stands, from 0 to 1 across the model. */
  sectionPlace: number;
  leftPanel: boolean;
  rightPanel: boolean;
}

/** Lines of equal parameter with which items come. */
export const N_ISOCURVES = 7;

const DEFAULTS: Settings = {
  theme: "auto",
  isOrthographic: false,
  grid: true,
  edges: true,
  isocurves: true,
  wireframe: false,
  control: false,
  knots: false,
  normals: false,
  combs: false,
  shell: false,
  snap: true,
  isocurveCount: N_ISOCURVES,
  combsOf: "all",
  combScale: 1,
  combStride: 1,
  shade: "plain",
  stripes: 6,
  stripesAcross: true,
  exactStripes: false,
  light: "view",
  draftAxis: "z",
  draftDegrees: 3,
  deviationOf: "",
  deviationFrom: "",
  section: false,
  sectionAxis: "x",
  sectionFlip: false,
  sectionNormal: [1, 0, 0],
  sectionPlace: 0.5,
  leftPanel: true,
  rightPanel: true,
};

/** What is kept from one visit to the next; analyses begin switched off. */
const KEPT: (keyof Settings)[] = [
  "theme",
  "isOrthographic",
  "grid",
  "edges",
  "isocurves",
  "snap",
  "leftPanel",
  "rightPanel",
];
const STORE = "virote-view";

export class SettingsSignal extends Signal<Settings> {
  /** Whether nothing was kept from a visit before. */
  readonly isFirstVisit: boolean;
  /** What the width alone decides. */
  private narrow: Partial<Settings>;

  constructor() {
    const old = kept();
    const narrow = ofWidth(innerWidth);
    super({ ...DEFAULTS, ...old, ...narrow });
    this.narrow = narrow;
    this.isFirstVisit = Object.keys(old).length === 0;
    this.follow((settings) => {
      // That is not the person's wish.
      const isWish = (name: keyof Settings): boolean => !(name in this.narrow) || settings[name] !== this.narrow[name];
      const before = kept();
      const wishes = KEPT.map((name) => [name, isWish(name) ? settings[name] : (before[name] ?? DEFAULTS[name])]);
      try {
        localStorage.setItem(STORE, JSON.stringify(Object.fromEntries(wishes)));
      } catch {
        // A page without storage begins anew each time.
      }
    });
  }

  /** Changes some of the settings. */
  put(change: Partial<Settings>): void {
    this.set({ ...this.value, ...change });
  }

  /** Closes the panels for which a page that became narrower has no room; a wider one has those again that were closed so. */
  suit(width: number): void {
    const [before, now] = [this.narrow, ofWidth(width)];
    const panels = ["leftPanel", "rightPanel"] as const;
    const closed = panels.filter((name) => name in now && !(name in before));
    const opened = panels.filter((name) => name in before && !(name in now) && !this.value[name]);
    if (closed.length + opened.length === 0) return;
    const wishes = kept();
    this.narrow = now;
    this.put(Object.fromEntries([...closed.map((name) => [name, false]), ...opened.map((name) => [name, wishes[name] ?? DEFAULTS[name]])]));
  }

  /** Turns one switch over. */
  toggle(name: { [K in keyof Settings]: Settings[K] extends boolean ? K : never }[keyof Settings]): void {
    this.put({ [name]: !this.value[name] });
  }
}

/** Up to this width both panels lie over the picture, as the style says. */
export const NARROW = 560;

/** Panels that would lie over the picture of a page of this width are closed. */
function ofWidth(width: number): Partial<Settings> {
  if (width <= NARROW) return { leftPanel: false, rightPanel: false };
  return width <= 760 ? { rightPanel: false } : {};
}

function kept(): Partial<Settings> {
  try {
    const found = JSON.parse(localStorage.getItem(STORE) ?? "{}") as Partial<Settings>;
    const entries = KEPT.filter((name) => typeof found[name] === typeof DEFAULTS[name]);
    return Object.fromEntries(entries.map((name) => [name, found[name]])) as Partial<Settings>;
  } catch {
    return {};
  }
}
