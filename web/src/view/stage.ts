// The picture: draws the newest scene on demand, never oftener than something changes.

import { Box3, Group, type Material, Mesh, Scene as ThreeScene, Vector3 } from "three";

import type { Item, Stripes, Vector } from "../door/door";
import { type Document, type Hit, now } from "../model/document";
import { ExactStripes } from "../model/exactStripes";
import { ChosenIsocurves } from "../model/isocurves";
import type { Settings, SettingsSignal } from "../model/settings";
import { Signal } from "../signal";
import { SectionCaps } from "./caps";
import { greatestCurvature } from "./combs";
import type { DeviationMap } from "../model/deviation";
import { curvatureRange, deviationRange, isMap, type MapShade } from "./curvature";
import { DrawnItem, ghostOf, Overlays } from "./drawn";
import { MODES } from "./glsl";
import { Grid } from "./grid";
import { KnownModel } from "./known";
import { cut, setCut, setMode, shared } from "./paint";
import { Painter } from "./painter";
import { pick } from "./pick";
import { snapped } from "./snap";
import { NAMED_VIEWS, type NamedView, type Pose, Rig } from "./rig";
import { placeCut } from "./section";
import { Shape } from "./shape";
import { StripeLines } from "./stripeLines";
import { ShellLines, WELD } from "./shellLines";
import { DARK, LIGHT, type Palette } from "./theme";

/** How long the camera takes to a named view, in milliseconds. */
const TURN = 260;
/** Milliseconds from one frame to the next, about. */
const AT_ONCE = 16;
/** Share of the model's size that the longest tooth of a comb has at scale 1. */
const COMB_SHARE = 0.12;
const NORMAL_SHARE = 0.03;
/** Share of its size that a model is thick at least, to be first seen from aside. */
const FLAT = 1e-6;

export class Stage {
  readonly rig = new Rig();
  readonly grid = new Grid();
  readonly shell = new ShellLines();
  readonly caps = new SectionCaps();
  readonly exact: ExactStripes;
  readonly isocurves: ChosenIsocurves;
  /** Length of a tooth for a curvature of 1, in the document's units; 0 where there is no comb. */
  readonly combLength = new Signal(0);
  private readonly stripeLines = new StripeLines();
  /** The range of the legend. */
  readonly range = new Signal<{ least: number; most: number; isAutomatic: boolean }>({
    least: -1,
    most: 1,
    isAutomatic: true,
  });
  /** Called after each frame, for what lies over the canvas. */
  readonly afterFrame = new Set<() => void>();
  palette: Palette = LIGHT;
  n_frames = 0;
  /** When the newest scene stood, when the last frame was handed over, and, where somebody wants to know, when it had been
   * drawn. */
  readonly times = { scene: 0, frame: 0, drawn: 0 };
  isTimed = false;
  private readonly painter: Painter;
  private readonly world = new ThreeScene();
  private readonly models = new Group();
  private readonly ghosts = new Group();
  private readonly overlays = new Overlays();
  private readonly shapes = new Map<string, Shape>();
  private drawn = new Map<string, DrawnItem>();
  /** Shown no more; their programs must live until those that come have been drawn with them, or they are made anew. */
  private readonly leaving: DrawnItem[] = [];
  /** The frame that is wanted, by its number; 0 for none. */
  private asked = 0;
  /** Whether the camera stays where it is: it has gone to the whole model, or the person has moved it. */
  private hasFitted = false;
  private readonly known = new KnownModel();
  private turning = 0;
  private smoothing = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly doc: Document,
    private readonly settings: SettingsSignal,
    private readonly deviation: DeviationMap,
  ) {
    this.exact = new ExactStripes(doc, settings, () => this.stripes());
    this.isocurves = new ChosenIsocurves(doc, settings);
    this.isocurves.follow(() => this.restyle());
    this.painter = new Painter(canvas);
    this.world.add(this.grid.mesh, this.models, this.ghosts, this.shell.group, this.caps.group, this.stripeLines.group);
    this.world.matrixWorldAutoUpdate = true;
    this.painter.prepare(new Group().add(this.grid.mesh.clone(), ...this.overlays.firsts()), this.rig.camera);
    new ResizeObserver(() => this.resize()).observe(canvas);
    canvas.addEventListener("webglcontextrestored", () => this.ask());
    this.resize();
    settings.watch(() => this.restyle());
    doc.scene.follow(() => {
      this.reconcile();
      this.times.scene = now();
      this.drawSoon();
    });
    this.exact.follow(() => this.restyle());
    doc.selection.follow(() => this.restyle());
    doc.choices.follow(() => this.restyle());
    doc.ghost.follow(() => this.rebuildGhost());
    doc.claim.follow(() => this.ask());
    deviation.follow(() => this.restyle());
    doc.hit.follow(() => this.ask());
    doc.marks.follow(() => this.ask());
    doc.lure.follow(() => this.ask());
    this.range.follow(() => this.ask());
  }

  /** Wants one more frame; where frames take long a quick one, and a smooth one when nothing changes any more. */
  ask(): void {
    if (this.asked === 0) this.asked = requestAnimationFrame(() => this.frame(this.painter.isSlow));
  }

  /** Draws at once, for the browser to show it next; not behind a frame that it may not have shown yet. */
  private drawSoon(): void {
    if (document.hidden || now() - this.times.frame < AT_ONCE) this.ask();
    else this.frame(this.painter.isSlow);
  }

  setPalette(isDark: boolean): void {
    this.palette = isDark ? DARK : LIGHT;
    const { palette } = this;
    this.overlays.paint(palette);
    this.grid.paint(palette.ink, palette.red, palette.green);
    shared.accent.value = palette.accent;
    shared.faded.value = palette.faded;
    this.rebuildGhost();
    this.restyle();
  }

  /** Whether the last frame is as smooth as can be. */
  get isSmooth(): boolean {
    return this.painter.isSmooth;
  }

  get items(): Iterable<DrawnItem> {
    return this.drawn.values();
  }

  /** The box of all that is visible, or of the selection where there is one. */
  box(isSelection = false): Box3 {
    const { selection } = this.doc;
    const box = new Box3();
    for (const { item, isVisible } of this.drawn.values()) {
      if (!isVisible || !item.bounds || (isSelection && !selection.value.has(item.path))) continue;
      box.expandByPoint(new Vector3(...item.bounds[0])).expandByPoint(new Vector3(...item.bounds[1]));
    }
    return box;
  }

  fit(isSelection = false): void {
    const box = this.box(isSelection);
    if (!box.isEmpty()) this.turnTo(this.rig.fitted(box));
  }

  view(name: NamedView): void {
    const box = this.box();
    const [azimuth, elevation] = NAMED_VIEWS[name];
    this.turnTo(box.isEmpty() ? { ...this.rig.pose, azimuth, elevation } : this.rig.fitted(box, [azimuth, elevation]));
  }

  /** Moves the camera there, smoothly where the person likes motion. */
  turnTo(goal: Pose): void {
    const from = this.rig.pose;
    const run = ++this.turning;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.rig.pose = goal;
      return this.ask();
    }
    const swing = ((((goal.azimuth - from.azimuth + 180) % 360) + 360) % 360) - 180;
    const start = performance.now();
    const step = (): void => {
      if (run !== this.turning) return;
      const share = Math.min(1, (performance.now() - start) / TURN);
      const s = 1 - (1 - share) ** 3;
      const mix = (a: number, b: number): number => a + (b - a) * s;
      this.rig.pose =
        share === 1
          ? goal
          : {
              target: [0, 1, 2].map((k) => mix(from.target[k], goal.target[k])) as Pose["target"],
              azimuth: from.azimuth + swing * s,
              elevation: mix(from.elevation, goal.elevation),
              height: from.height * (goal.height / from.height) ** s,
            };
      this.frame(this.painter.isSlow);
      if (share < 1) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  /** Ends a motion that is under way, because the person takes over. */
  takeOver(): void {
    this.turning++;
    this.hasFitted ||= this.drawn.size > 0;
  }

  /** What is under a pixel, drawn to an end, a knot, a corner or a vertex nearby where the person likes that. */
  pick(x: number, y: number): Hit | null {
    const hit = pick(this.drawn.values(), this.rig, x, y, cut.planes, this.caps);
    return this.settings.value.snap ? (snapped(this.drawn.values(), this.rig, x, y, cut.planes, hit) ?? hit) : hit;
  }

  /** The place that a click at a pixel would be drawn to. */
  lure(x: number, y: number): Hit | null {
    const hit = this.pick(x, y);
    return hit?.snapped ? hit : null;
  }

  /** Forgets what was made of buffers that are gone. */
  forget(key: string): void {
    this.shapes.get(key)?.dispose();
    this.shapes.delete(key);
  }

  /** The canvas with a picture that was drawn this moment. */
  snapshot(): HTMLCanvasElement {
    this.frame();
    return this.canvas;
  }

  /** Where a point of the model is on the canvas. */
  pixelOf(point: [number, number, number]): Vector3 {
    this.rig.update();
    return this.rig.project(new Vector3(...point));
  }

  /** Red, green, blue and opacity of a pixel of the canvas, drawn anew. */
  colorAt(x: number, y: number): number[] {
    this.frame();
    const ratio = this.painter.pixelRatio;
    return this.painter.read(Math.floor(x * ratio), Math.floor(this.canvas.height - y * ratio));
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.painter.resize(width, height);
    shared.screen.value.set(width, height);
    this.rig.resize(width, height);
    this.frame(this.painter.isSlow);
  }

  /** Makes the drawn items those of the newest scene; what has its key already stays as it is. */
  private reconcile(): void {
    const scene = this.doc.scene.value;
    if (!scene) return;
    const drawn = new Map<string, DrawnItem>();
    for (const item of scene.state.items) {
      const old = this.drawn.get(item.path);
      const shape = this.shapeOf(item, scene.buffers);
      if (!shape) continue;
      if (old && old.shape === shape) {
        old.item = item;
        this.drawn.delete(item.path);
        drawn.set(item.path, old);
      } else {
        const made = new DrawnItem(item, shape, this.overlays);
        this.models.add(made.group);
        drawn.set(item.path, made);
      }
    }
    for (const gone of this.drawn.values()) {
      gone.group.removeFromParent();
      // Where nobody looks no frame comes.
      if (document.hidden) gone.dispose();
      else this.leaving.push(gone);
    }
    this.drawn = drawn;
    shared.fade.value = scene.state.isCurrent ? 0 : 1;
    this.restyle();
    const unfinished = [...drawn.values()].filter((one) => one.isUnfinished);
    // They would hold up the picture of what is there.
    if (unfinished.length > 0) requestAnimationFrame(() => setTimeout(() => this.finish(unfinished)));
    const box = this.box();
    if (box.isEmpty()) return;
    if (this.known.isReplacedBy(scene.state, box)) this.hasFitted = false;
    if (this.hasFitted) return;
    this.hasFitted = !scene.state.isPartial;
    this.turning++;
    this.rig.pose = this.rig.fitted(box, flatView(box));
  }

  private finish(unfinished: DrawnItem[]): void {
    for (const one of unfinished) if (this.drawn.get(one.item.path) === one) one.finish();
    this.restyle();
  }

  private shapeOf(item: Item, buffers: ReadonlyMap<string, Shape["buffers"]>): Shape | null {
    let shape = this.shapes.get(item.key);
    if (!shape) {
      const found = buffers.get(item.key);
      if (!found) return null;
      shape = new Shape(found);
      this.shapes.set(item.key, shape);
    }
    return shape;
  }

  private rebuildGhost(): void {
    for (const old of [...this.ghosts.children]) {
      old.removeFromParent();
      old.traverse((part) => {
        // Lines of ghosts share their material; that of a surface is its own.
        if (part instanceof Mesh && part.material !== this.overlays.ghostLine) (part.material as Material).dispose();
      });
    }
    const ghost = this.doc.ghost.value;
    for (const item of ghost?.scene.state.items ?? []) {
      const shape = this.shapeOf(item, ghost!.scene.buffers);
      if (shape && !ghost!.hidden.has(item.path)) this.ghosts.add(ghostOf(item, shape, this.palette, this.overlays));
    }
    this.ask();
  }

  /** Brings everything that settings, selection and visibility decide up to date. */
  private restyle(): void {
    const settings = this.settings.value;
    this.rig.isOrthographic = settings.isOrthographic;
    this.grid.mesh.visible = settings.grid;
    // The shader shows stripes until the kernel's curves are there.
    const { value: exact } = this.exact;
    setMode(MODES[this.exact.isWanted && !exact.isWaiting ? "plain" : settings.shade]);
    this.stripeLines.show(exact, this.drawn.values());
    shared.stripes.value = settings.stripes;
    shared.draft.value = settings.draftDegrees;
    const bounds = this.doc.state.value?.bounds;
    const size = bounds ? new Vector3(...bounds[0]).distanceTo(new Vector3(...bounds[1])) : 1;
    const greatest = settings.combs ? this.greatestCurvature() : 0;
    const combLength = greatest > 0 ? (settings.combScale * COMB_SHARE * size) / greatest : 0;
    for (const one of this.drawn.values()) {
      const isSelected = this.doc.selection.value.has(one.item.path);
      one.apply({
        settings,
        palette: this.palette,
        isVisible: this.doc.isVisible(one.item),
        isSelected,
        isocurves: this.isocurves.value.get(one.item.key) ?? null,
        isCombed: settings.combs && combLength > 0 && (settings.combsOf === "all" || isSelected),
        combLength,
        normalLength: NORMAL_SHARE * size,
        deviations: settings.shade === "deviation" ? this.deviation.value.values : null,
      });
    }
    this.combLength.set(combLength);
    this.shell.show(settings.shell, [...this.drawn.values()], this.box());
    this.followRange(settings);
    this.ask();
  }

  private greatestCurvature(): number {
    let most = 0;
    const { combsOf } = this.settings.value;
    for (const { item, shape } of this.drawn.values()) {
      if (!this.doc.isVisible(item) || (combsOf === "selection" && !this.doc.selection.value.has(item.path))) continue;
      most = Math.max(most, greatestCurvature(shape.buffers));
    }
    return most;
  }

  /** The legend follows the model until the person drags it, and begins anew with another map. */
  private followRange(settings: Settings): void {
    const { shade } = settings;
    if (!isMap(shade) || !this.range.value.isAutomatic) return;
    const [least, most] = this.automaticRange(shade);
    const { value } = this.range;
    if (value.least !== least || value.most !== most) this.range.set({ least, most, isAutomatic: true });
  }

  automaticRange(shade: MapShade): [number, number] {
    if (shade === "deviation") return deviationRange(this.deviation.value.values.values());
    const visible = [...this.drawn.values()].filter((one) => one.isVisible);
    return curvatureRange(visible.map((one) => one.shape.buffers), shade);
  }

  /** The stripes as the present camera sees them, in the model's coordinates. */
  private stripes(): Stripes {
    const { shade, light, stripes, stripesAcross } = this.settings.value;
    const [right, up, back] = this.rig.axes().map((axis) => axis.toArray() as Vector);
    const axes: Record<string, Vector> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], view: back };
    const isZebra = shade === "zebra";
    return { kind: isZebra ? "zebra" : "isophotes", light: isZebra ? back : axes[light], axis: stripesAcross ? up : right, stripes };
  }

  private frame(isQuick = false): void {
    cancelAnimationFrame(this.asked);
    this.asked = 0;
    if (!this.doc.scene.value) return;
    clearTimeout(this.smoothing);
    if (isQuick) this.smoothing = setTimeout(() => this.smooth(), this.painter.rest) as unknown as number;
    const settings = this.settings.value;
    const box = this.box();
    const ghost = this.doc.ghost.value?.scene.state.bounds;
    const enclosed = box.clone();
    if (ghost) enclosed.expandByPoint(new Vector3(...ghost[0])).expandByPoint(new Vector3(...ghost[1]));
    this.rig.enclose(enclosed);
    this.rig.update();
    if (settings.section !== cut.planes.length > 0) setCut(settings.section);
    if (settings.section) placeCut(settings, box);
    const size = box.isEmpty() ? 1 : box.max.distanceTo(box.min);
    this.caps.show(settings.section ? cut.plane : null, this.drawn.values(), WELD * size);
    this.caps.paint(this.palette, (path) => this.doc.selection.value.has(path));
    this.aim(settings);
    if (settings.grid) this.grid.update(this.rig);
    this.exact.renew();
    this.painter.draw(this.world, this.rig.camera, isQuick);
    for (const gone of this.leaving.splice(0)) gone.dispose();
    this.n_frames++;
    this.times.frame = now();
    if (this.isTimed) {
      this.painter.read(0, 0);
      this.times.drawn = now();
    }
    for (const call of this.afterFrame) call();
    this.doc.drawn();
  }

  /** Draws the frame anew as it should be, unless another one is on its way. */
  private smooth(): void {
    if (this.doc.isBusy.value) this.smoothing = setTimeout(() => this.smooth(), this.painter.rest) as unknown as number;
    else if (this.asked === 0) this.frame();
  }

  /** Directions of the analyses, as the camera sees them. */
  private aim(settings: Settings): void {
    shared.isParallel.value = settings.isOrthographic ? 1 : 0;
    shared.isFromAfar.value = this.exact.isWanted ? 1 : shared.isParallel.value;
    shared.range.value.set(this.range.value.least, this.range.value.most);
    const seen = (name: string): Vector3 =>
      new Vector3(Number(name === "x"), Number(name === "y"), Number(name === "z")).transformDirection(
        this.rig.camera.matrixWorldInverse,
      );
    if (settings.shade === "draft") shared.axis.value.copy(seen(settings.draftAxis));
    else shared.axis.value.set(settings.stripesAcross ? 1 : 0, settings.stripesAcross ? 0 : 1, 0);
    if (settings.light === "view") shared.light.value.set(0, 0, 1);
    else shared.light.value.copy(seen(settings.light));
  }
}

/** A drawing in one plane of the axes is first seen from the front. */
function flatView(box: Box3): [number, number] | undefined {
  const size = box.getSize(new Vector3());
  const least = FLAT * Math.max(size.x, size.y, size.z);
  if (size.z < least) return NAMED_VIEWS.top;
  if (size.y < least) return NAMED_VIEWS.front;
  return size.x < least ? NAMED_VIEWS.right : undefined;
}
