// `window.virote`: what browser tests, and whoever is curious, may read of the page.

import type { App } from "./app";
import type { Hit } from "./model/document";
import type { Settings } from "./model/settings";
import type { Pose } from "./view/rig";

export interface ViroteWindow {
  /** Version of this object. */
  readonly version: 1;
  /** Version of the state that is drawn; -1 before the first. */
  readonly stateVersion: number;
  /** Whether the newest state is drawn and listed, and nothing is under way. */
  readonly isReady: boolean;
  /** Whether the picture is smooth: behind a coarse one comes such a one when nothing changes. */
  readonly isSmooth: boolean;
  readonly isCurrent: boolean;
  readonly isOnline: boolean;
  readonly camera: Pose & { isOrthographic: boolean };
  readonly items: { path: string; key: string; kind: string; triangles: number; isocurves: number; isVisible: boolean; isSelected: boolean }[];
  readonly hit: Hit | null;
  readonly marks: Hit[];
  readonly settings: Settings;
  /** Frames drawn and items fetched since the page began. */
  readonly n_frames: number;
  readonly n_fetched: number;
  readonly n_kept: number;
  /** Milliseconds from the start of the page to the first frame that shows a model. */
  readonly firstPicture: number | null;
  /** When the newest state was told, arrived, had all its buffers, was in the scene, was handed to be drawn, and, where `isTimed`, had been drawn; on the clock of the machine. */
  readonly times: { event: number; state: number; buffers: number; scene: number; frame: number; drawn: number };
  isTimed: boolean;
  /** Moves the camera there at once. */
  look(pose: Partial<Pose>): void;
  /** The pixel of a point of the model, in the coordinates of the window. */
  pixel(point: [number, number, number]): [number, number];
  /** Red, green, blue and opacity of a pixel of the window, drawn anew. */
  color(x: number, y: number): number[];
}

declare global {
  interface Window {
    virote: ViroteWindow;
  }
}

export function expose(app: App): void {
  const { doc, stage, settings, canvas } = app;
  let firstPicture: number | null = null;
  let drawn = -1;
  stage.afterFrame.add(() => {
    drawn = doc.scene.value?.state.version ?? -1;
    if (firstPicture === null && doc.items().length > 0) firstPicture = performance.now();
  });
  const face: ViroteWindow = {
    version: 1,
    get stateVersion() {
      return drawn;
    },
    get isReady() {
      // What was told last may still wait for its buffers.
      return app.isShown && drawn > 0 && drawn >= doc.version && drawn === doc.listed.value?.version && drawn === doc.state.value?.version && !doc.isBusy.value;
    },
    get isSmooth() {
      return stage.isSmooth;
    },
    get isCurrent() {
      return doc.state.value?.isCurrent ?? false;
    },
    get isOnline() {
      return doc.isOnline.value;
    },
    get camera() {
      return { ...stage.rig.pose, isOrthographic: stage.rig.isOrthographic };
    },
    get items() {
      return [...stage.items].map(({ item, shape, isVisible }) => ({
        path: item.path,
        key: item.key,
        kind: item.kind,
        triangles: (shape.buffers.triangles?.length ?? 0) / 3,
        isocurves: (stage.isocurves.value.get(item.key) ?? shape.buffers).isocurves.length,
        isVisible,
        isSelected: doc.selection.value.has(item.path),
      }));
    },
    get hit() {
      return doc.hit.value;
    },
    get marks() {
      return doc.marks.value;
    },
    get settings() {
      return settings.value;
    },
    get n_frames() {
      return stage.n_frames;
    },
    get n_fetched() {
      return doc.keeper.n_fetched;
    },
    get n_kept() {
      return doc.keeper.n_kept;
    },
    get firstPicture() {
      return firstPicture;
    },
    get times() {
      return { ...doc.times, ...stage.times };
    },
    get isTimed() {
      return stage.isTimed;
    },
    set isTimed(isTimed) {
      stage.isTimed = isTimed;
    },
    look(pose) {
      stage.takeOver();
      stage.rig.pose = { ...stage.rig.pose, ...pose };
      stage.ask();
    },
    pixel(point) {
      const frame = canvas.getBoundingClientRect();
      const { x, y } = stage.pixelOf(point);
      return [x + frame.left, y + frame.top];
    },
    color(x, y) {
      const frame = canvas.getBoundingClientRect();
      return stage.colorAt(x - frame.left, y - frame.top);
    },
  };
  window.virote = face;
}
