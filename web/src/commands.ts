// Everything that a button or a key can do, once: tool bar, keyboard and help sheet read this list.

import type { IconName } from "./panels/icons";

export interface Command {
  id: string;
  title: string;
  /** Keys as `KeyboardEvent.key` tells them; "Shift+h", "Ctrl+s" with modifiers, of which Ctrl may be Command. */
  keys: string[];
  group: "Looking" | "Showing" | "Analysis" | "Model" | "Page" | "Writing";
  icon?: IconName;
  /** Whether the switch is on, for commands that are switches. */
  isOn?: () => boolean;
  /** Whether it can be done now. */
  isPossible?: () => boolean;
  run: () => void;
}

/** Calls the command of a key; while the person is typing into a field, only of one that types nothing. */
export function listenToKeys(commands: Command[]): void {
  const byKey = new Map(commands.flatMap((command) => command.keys.map((key) => [key, command] as const)));
  addEventListener("keydown", (event) => {
    const hasCtrl = event.ctrlKey || event.metaKey;
    if (event.altKey || event.defaultPrevented) return;
    // Under a sheet nothing is commanded; "?" puts that of the keys away again.
    if (event.key !== "?" && document.querySelector("dialog[open]")) return;
    // Of a slider that has the focus they are the steps.
    if (event.shiftKey && event.key.startsWith("Arrow") && event.target instanceof HTMLInputElement && event.target.type === "range") return;
    if (isTyping(event.target) && !hasCtrl && !/^(Escape|F\d+)$/.test(event.key)) return;
    const letter = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const isShifted = event.shiftKey && /^[a-z]$|^Arrow/.test(letter);
    const command = byKey.get(`${hasCtrl ? "Ctrl+" : ""}${isShifted ? "Shift+" : ""}${letter}`);
    if (!command || command.isPossible?.() === false) return;
    event.preventDefault();
    command.run();
  });
}

function isTyping(target: EventTarget | null): boolean {
  if (target instanceof HTMLInputElement) return !["checkbox", "range"].includes(target.type);
  return target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement || (target instanceof HTMLElement && target.isContentEditable);
}

/** A key as a person reads it. */
export function keyName(key: string): string {
  const names: Record<string, string> = {
    ArrowLeft: "←",
    ArrowRight: "→",
    ArrowUp: "↑",
    ArrowDown: "↓",
    Escape: "Esc",
    " ": "Space",
  };
  if (key === "+") return key;
  return key
    .split("+")
    .map((part) => names[part] ?? (part.length === 1 ? part.toUpperCase() : part))
    .join(" ");
}
