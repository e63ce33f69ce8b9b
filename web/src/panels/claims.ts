// What the script claims, prints and exports, and what went wrong in it.

import type { Check, State } from "../door/door";
import { claimName, type Document } from "../model/document";
import { button, copy, el, renew, say, section, type Section } from "./dom";
import { icon } from "./icons";

const N_AT_MOST = 500;

export class ClaimsPanel {
  readonly claims: Section = section("claims", "Claims");
  readonly prints: Section = section("prints", "Prints");
  readonly output: Section = section("output", "Output");

  constructor(private readonly doc: Document) {
    doc.listed.watch((state) => state && this.show(state));
    doc.selection.follow(() => doc.listed.value && this.showOutput(doc.listed.value));
    doc.claim.follow(() => doc.listed.value && this.showClaims(doc.listed.value));
  }

  private show(state: State): void {
    const { prints } = state;
    this.showClaims(state);
    this.prints.root.hidden = prints.length === 0;
    say(this.prints.note, String(prints.length));
    renew(
      this.prints.body,
      limited(prints, ({ text, value, line }) =>
        el("div", { class: "print", title: line === null ? "" : `line ${line}` }, el("code", {}, text), el("code", { class: "print-value" }, value)),
      ),
    );
    this.showOutput(state);
  }

  private showClaims({ checks }: State): void {
    const n_passed = checks.filter((check) => check.verdict === "pass").length;
    this.claims.root.hidden = checks.length === 0;
    say(this.claims.note, n_passed === checks.length ? `${n_passed} hold` : `${checks.length - n_passed} of ${checks.length} fail`);
    this.claims.note.classList.toggle("bad", n_passed < checks.length);
    const inOrder = [...checks].sort((a, b) => Number(a.verdict === "pass") - Number(b.verdict === "pass"));
    renew(this.claims.body, limited(inOrder, (check) => this.claim(check)));
  }

  /** A claim that shows its places at a click, and what of the model it names. */
  private claim(check: Check): HTMLElement {
    const { doc } = this;
    const root = claim(check);
    const isShown = doc.claim.value === claimName(check);
    root.classList.toggle("shown", isShown);
    root.querySelector("summary")!.addEventListener("click", (event) => {
      if (isShown) {
        doc.claim.set(null);
        return;
      }
      event.preventDefault();
      doc.select(this.named(check));
      doc.claim.set(claimName(check));
    });
    return root;
  }

  /** Paths of the items whose definitions stand in the text of a claim. */
  private named({ text }: Check): string[] {
    const words = new Set(text.match(/[\p{L}_][\p{L}\p{N}_]*/gu));
    return this.doc.items().filter((item) => words.has(item.definition)).map((item) => item.path);
  }

  private showOutput(state: State): void {
    const { body, root, note } = this.output;
    const { canEvaluate, isDownloading = false } = this.doc.door;
    root.hidden = state.exports.length === 0 && !(canEvaluate && this.doc.selection.value.size > 0);
    note.textContent = state.exports.length > 0 ? String(state.exports.length) : "";
    const rows: Node[] = state.exports.map(({ path, line }) =>
      el("div", { class: "print", title: line === null ? "" : `line ${line}` }, el("code", {}, path)),
    );
    if (canEvaluate) {
      if (state.exports.length > 0) {
        const verb = isDownloading ? "Download" : "Write";
        const where = state.exportFolder ? `${verb} what the script exports into ${state.exportFolder}` : `${verb} what the script exports`;
        rows.push(el("div", { class: "row actions" }, button(`${verb} the exports`, where, () => void this.export({ what: "script" }), { class: "plain" })));
      }
      rows.push(this.selectionForm());
    }
    if (body.contains(document.activeElement) && document.activeElement instanceof HTMLInputElement) return;
    renew(body, rows);
  }

  /** Writes the selected definitions to a file whose ending says the format. */
  private selectionForm(): HTMLElement {
    const names = [...new Set(this.doc.selected().map((item) => item.definition))];
    const field = el("input", { type: "text", class: "value wide", spellcheck: "false", "aria-label": "File of the selection" });
    field.value = names.length === 1 ? `${names[0]}.stl` : "selection.stl";
    field.dataset.of = names.join(" ");
    const form = el("form", { class: "row" }, field, el("button", { type: "submit", class: "plain" }, this.doc.door.isDownloading ? "Download selection" : "Write selection"));
    form.hidden = names.length === 0;
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.export({ items: names, file: field.value });
    });
    return form;
  }

  private async export(request: { what: "script" } | { items: string[]; file: string }): Promise<void> {
    const files = await this.doc.attempt(this.doc.door.export(request));
    if (files) this.doc.tell(`${this.doc.door.isDownloading ? "Downloaded" : "Written"}: ${files.join(", ")}`);
  }
}

function claim({ text, message, figures, verdict, left, right, distance, limit, line, places }: Check): HTMLElement {
  const isPassed = verdict === "pass";
  const detail = el("div", { class: "claim-detail" });
  const known: [string, string | null | undefined][] = [
    ["claim", message ? text : null],
    ["left", left],
    ["right", right],
    ["distance", distance],
    ["limit", limit],
    ["in short", figures],
    ["places", places?.length ? `${places.length} shown by a click` : null],
  ];
  for (const [label, value] of known) {
    if (value) detail.append(el("span", { class: "fact-label" }, label), el("code", {}, value));
  }
  const summary = el(
    "summary",
    { title: line === null ? text : `line ${line}: ${text}` },
    icon(isPassed ? "check" : "cross"),
    el("span", { class: "claim-text" }, message || text),
    distance && limit && el("span", { class: "claim-margin" }, `${short(distance)} ${isPassed ? "≤" : ">"} ${short(limit)}`),
  );
  const root = el("details", { class: `claim ${verdict}` }, summary, detail);
  root.open = !isPassed;
  return root;
}

/** A text with its long numbers in three digits. */
function short(text: string): string {
  return text.replace(/\d[\d.]{4,}(?:e[+-]?\d+)?/g, (number) => String(Number(Number(number).toPrecision(3))));
}

/** The diagnostics over the picture, with the text as the terminal shows it. */
export function diagnosticsPanel(doc: Document): HTMLElement {
  const list = el("div", { class: "diagnostics-list" });
  const title = el("span", { class: "diagnostics-title" });
  const fold = button(icon("chevron"), "Fold", () => root.classList.toggle("folded"), { class: "tool fold-down" });
  const head = el("header", {}, title, fold);
  const root = el("div", { class: "diagnostics folded", role: "alert" }, head, list);
  let hadErrors = false;
  doc.listed.watch((state) => {
    const all = state?.diagnostics ?? [];
    const n_errors = all.filter((one) => one.severity === "error").length;
    root.hidden = all.length === 0;
    // Errors open the panel; failed claims and warnings stand elsewhere too, and leave the model in sight.
    if (n_errors > 0 !== hadErrors) root.classList.toggle("folded", n_errors === 0);
    hadErrors = n_errors > 0;
    root.classList.toggle("has-errors", hadErrors);
    say(title, titleOf(all.map((one) => one.severity), state));
    renew(
      list,
      limited(all, ({ severity, code, message, text, line }) => {
        const copier = button(icon("copy"), "Copy the message", () => void copy(text), { class: "tool" });
        const name = el("b", {}, code ? `${severity} ${code}` : severity);
        const place = line === null ? null : el("span", { class: "diagnostic-line" }, `line ${line}`);
        return el(
          "article",
          { class: `diagnostic ${severity}` },
          el("div", { class: "diagnostic-head" }, name, el("span", {}, message), place, copier),
          text && text.trim() !== message && el("pre", {}, text),
        );
      }),
    );
  });
  return root;
}

function titleOf(severities: string[], state: State | null): string {
  const count = (severity: string, one: string): string => {
    const n = severities.filter((each) => each === severity).length;
    return n === 0 ? "" : `${n} ${one}${n === 1 ? "" : "s"}`;
  };
  const parts = [count("error", "error"), count("failure", "failed claim"), count("warning", "warning")].filter(Boolean);
  const isOld = state !== null && !state.isCurrent && state.items.length > 0;
  const model = state?.isPartial ? "what has no errors is shown" : "the model is that of the last good run";
  return isOld ? `${parts.join(", ")} · ${model}` : parts.join(", ");
}

/** Elements of at most so many of a list, with a word about the rest. */
function limited<T>(all: T[], make: (one: T) => HTMLElement): HTMLElement[] {
  const made = all.slice(0, N_AT_MOST).map(make);
  if (all.length > N_AT_MOST) made.push(el("p", { class: "hint" }, `and ${all.length - N_AT_MOST} more`));
  return made;
}
