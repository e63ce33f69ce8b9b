// Mouse, pen and fingers on the canvas: turn, move, zoom to the pointer, and click.

/** Pixels that a press may wander and still be a click. */
const CLICK = 4;

export interface PointerTarget {
  orbit(dx: number, dy: number): void;
  pan(dx: number, dy: number): void;
  zoom(factor: number, x: number, y: number): void;
  click(x: number, y: number, isAdding: boolean): void;
  doubleClick(x: number, y: number): void;
  settled(): void;
  /** The pointer is over a pixel with no button down, or gone from the canvas. */
  hover(place: [number, number] | null): void;
}

interface Contact {
  x: number;
  y: number;
}

export function follow(canvas: HTMLCanvasElement, target: PointerTarget): void {
  const contacts = new Map<number, Contact>();
  let wandered = 0;
  let button = 0;
  const place = (event: PointerEvent | WheelEvent | MouseEvent): [number, number] => {
    const frame = canvas.getBoundingClientRect();
    return [event.clientX - frame.left, event.clientY - frame.top];
  };
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    contacts.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (contacts.size === 1) {
      wandered = 0;
      button = event.button;
    }
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = contacts.get(event.pointerId);
    if (!last) {
      if (event.pointerType === "mouse") target.hover(place(event));
      return;
    }
    const [dx, dy] = [event.clientX - last.x, event.clientY - last.y];
    wandered += Math.abs(dx) + Math.abs(dy);
    if (contacts.size === 2) pinch(event, last);
    else if (wandered > CLICK) {
      const isPan = button === 1 || button === 2 || event.shiftKey || event.ctrlKey || event.metaKey;
      if (isPan) target.pan(dx, dy);
      else target.orbit(dx * 0.35, dy * 0.35);
    }
    last.x = event.clientX;
    last.y = event.clientY;
  });
  /** Two fingers: their middle moves the model, their distance zooms. */
  const pinch = (event: PointerEvent, moved: Contact): void => {
    const other = [...contacts.values()].find((contact) => contact !== moved);
    if (!other) return;
    const before = Math.hypot(moved.x - other.x, moved.y - other.y);
    const after = Math.hypot(event.clientX - other.x, event.clientY - other.y);
    const [x, y] = place(event);
    target.pan((event.clientX - moved.x) / 2, (event.clientY - moved.y) / 2);
    if (before > 0 && after > 0) target.zoom(after / before, x, y);
  };
  const release = (event: PointerEvent): void => {
    if (!contacts.delete(event.pointerId)) return;
    if (contacts.size > 0) return;
    if (wandered <= CLICK && event.type === "pointerup" && button === 0) {
      target.click(...place(event), event.shiftKey || event.ctrlKey || event.metaKey);
    }
    target.settled();
  };
  canvas.addEventListener("pointerleave", () => target.hover(null));
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("dblclick", (event) => target.doubleClick(...place(event)));
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const unit = event.deltaMode === 1 ? 18 : event.deltaMode === 2 ? 240 : 1;
      const step = Math.max(-240, Math.min(240, event.deltaY * unit));
      target.zoom(Math.exp(-step * 0.0016), ...place(event));
      target.settled();
    },
    { passive: false },
  );
}
