// The door between the page and whatever evaluates: a few calls, and the data that pass through them.

export type Vector = [number, number, number];
export type Box = [Vector, Vector];
export type Kind = "surface" | "curve" | "mesh" | "points" | "polyline";

/** One thing of the model that can be drawn. The same key always stands for the same bytes. */
export interface Item {
  key: string;
  definition: string;
  path: string;
  kind: Kind;
  /** What the language calls its kind, such as "region". */
  form?: string;
  /** The region or solid that it is a part of. */
  owner?: Owner | null;
  /** Bytes of red, green and blue. */
  color: Vector | null;
  opacity: number | null;
  layer: string | null;
  isHidden: boolean;
  isShown?: boolean;
  isExported: boolean;
  facts: Record<string, string | number | boolean>;
  bounds: Box | null;
  span: { line: number; column: number } | null;
}

export interface Owner {
  path: string;
  kind: "region" | "solid";
}

export interface Parameter {
  name: string;
  label: string | null;
  docs: string | null;
  kind: "number" | "length" | "angle" | "bool" | "choice" | "text" | "other";
  value: string;
  default: string;
  number: number | null;
  least: number | null;
  most: number | null;
  step: number | null;
  unit: string | null;
  choices: string[] | null;
  isSet: boolean;
}

/** A file that the script imports, with its parameters and what the script gives them. */
export interface Import {
  path: string;
  line: number;
  parameters: ImportedParameter[];
}

export interface ImportedParameter {
  name: string;
  label: string | null;
  docs: string | null;
  default: string;
  /** A range or choices, as a script writes them. */
  allowed: string | null;
  /** What stands in the script for it, and where; null where it has its default. */
  given: string | null;
  line: number | null;
}

export interface Check {
  text: string;
  /** What the claim says in the script's own words. */
  message?: string | null;
  /** Both sides, or the margin, in a few words. */
  figures?: string | null;
  verdict: "pass" | "fail" | "error";
  left: string | null;
  right: string | null;
  distance: string | null;
  limit: string | null;
  line: number | null;
  /** Points that a claim which fails tells of. */
  places?: Vector[];
}

export interface Diagnostic {
  severity: "error" | "warning" | "failure";
  code: string | null;
  message: string;
  text: string;
  file?: string | null;
  line: number | null;
  column: number | null;
}

/** All that is known of one evaluation but the buffers of its items. */
export interface State {
  version: number;
  script: string;
  unit: string;
  millimetres: number;
  tolerance: number | null;
  isCurrent: boolean;
  /** Whether the script never was whole: the items are those of definitions without errors. */
  isPartial?: boolean;
  bounds: Box | null;
  items: Item[];
  parameters: Parameter[];
  imports?: Import[];
  checks: Check[];
  prints: { text: string; value: string; line: number | null }[];
  exports: { path: string; line: number | null }[];
  exportFolder?: string;
  diagnostics: Diagnostic[];
  milliseconds: { evaluate: number; mesh: number };
  definitions: { evaluated: number; reused: number };
}

/** A place on an item: (u, v) of a surface, t of a curve, or the number of a vertex of a mesh or of points. */
export type Place = { u: number; v: number } | { t: number } | { vertex: number };
export type Question = { item: string } & Place;

export interface Fact {
  label: string;
  /** k1, k2, gauss, mean, d1, d2, umbilic; tangent, curvature, radius, torsion. */
  name?: string;
  /** Null of what is no number. */
  value: number | Vector | null;
  text: string;
}

export interface Answer {
  definition: string;
  expression: string | null;
  point: Vector;
  normal: Vector | null;
  facts: Fact[];
}

/** Stripes whose borders are asked for: how many, from which light, and about which axis those of a zebra lie. */
export interface Stripes {
  kind: "zebra" | "isophotes";
  light: Vector;
  axis: Vector;
  stripes: number;
}

export type Measurable = "length" | "area" | "volume";
export type Values = Record<string, string | null>;
export type ExportRequest = { what: "script" } | { items: string[]; file: string };

export type DoorEvent =
  | { kind: "busy"; version: number }
  | { kind: "state"; version: number }
  /** `isForeign`: something else than the server of this page answers at its address. */
  | { kind: "connection"; isOpen: boolean; isForeign?: boolean };

/** A refusal whose message is meant for the person at the page. */
export class DoorError extends Error {
  constructor(
    message: string,
    readonly status = 0,
  ) {
    super(message);
  }
}

export interface Door {
  /** Whether anything behind the door can evaluate; an exported page only shows. */
  readonly canEvaluate: boolean;
  /** Whether exported files go to the person, and not into a folder. */
  readonly isDownloading?: boolean;
  state(): Promise<State>;
  /** The bytes of these items, in their order. */
  items(keys: string[]): Promise<ArrayBuffer[]>;
  ask(question: Question): Promise<Answer>;
  measure(kind: Measurable, items: string[]): Promise<{ value: number; text: string }>;
  /** How far each vertex of an item is from the nearest of others, negative behind their surfaces. */
  deviation(item: string, from: string[]): Promise<Float32Array>;
  /** The bytes of an item that has the lines of equal parameter of another one, so many inside in each direction. */
  isocurves(item: string, count: number): Promise<ArrayBuffer>;
  /** The borders of stripes on an item: pairs of places, relative to its centre. */
  stripes(item: string, stripes: Stripes): Promise<Float32Array>;
  set(change: { values: Values } | { reset: true }): Promise<void>;
  stop(): Promise<void>;
  write(values: Values): Promise<string[]>;
  export(request: ExportRequest): Promise<string[]>;
  /** Calls back at each event until the page ends. */
  listen(listener: (event: DoorEvent) => void): void;
}
