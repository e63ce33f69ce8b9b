// Places as the interpreter tells them, lines and columns from 0, and as the editor counts them.

import type { ChangeSpec, Text } from "@codemirror/state";

export interface Place {
  line: number;
  column: number;
}

export interface Range {
  from: Place;
  to: Place;
}

export interface Edit {
  range: Range;
  text: string;
}

export interface Finding {
  severity: "error" | "warning";
  code: string;
  text: string;
  range: Range;
  fixes: { title: string; edits: Edit[] }[];
}

/** Asks the interpreter about a text; null where there is no answer now. */
export type Ask = <T>(text: string, head: object, needsValues?: boolean) => Promise<T | null>;

export function placeOf(doc: Text, at: number): Place {
  const line = doc.lineAt(at);
  return { line: line.number - 1, column: at - line.from };
}

export function offsetOf(doc: Text, { line, column }: Place): number {
  const { from, to } = doc.line(Math.min(line + 1, doc.lines));
  return Math.min(from + column, to);
}

export function offsetsOf(doc: Text, { from, to }: Range): { from: number; to: number } {
  return { from: offsetOf(doc, from), to: offsetOf(doc, to) };
}

export function changesOf(doc: Text, edits: Edit[]): ChangeSpec[] {
  return edits.map(({ range, text }) => ({ ...offsetsOf(doc, range), insert: text }));
}
