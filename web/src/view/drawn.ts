// One item in the picture: its surface, its lines, and the overlays that are switched on.

import { BufferGeometry, Group, LineSegments, Mesh, Points, type Object3D, type ShaderMaterial } from "three";

import type { Item } from "../door/door";
import type { Isocurves } from "../model/isocurves";
import type { Settings } from "../model/settings";
import { dotMaterial, type HairMaterial, hairMaterial, lineMaterial, setOpacity, surfaceMaterial } from "./paint";
import { endsOf, hairGeometry, isWide } from "./segments";
import type { Shape } from "./shape";
import { colorOf, type Palette, raw } from "./theme";

/** The colour that stands until the theme gives one. */
const colorless = (): Palette["ink"] => raw(0x808080);
/** Triangles of a mesh whose creases are found before its first frame. */
const N_AT_ONCE = 50_000;
const SURFACE_LINE = 1.25;
const CURVE_LINE = 2.25;

/** Materials that all items share; their colours follow the theme. */
export class Overlays {
  readonly edge = lineMaterial(colorless(), SURFACE_LINE, 0.9);
  readonly edgeSelected = lineMaterial(colorless(), 2.5, 1, 0.0002);
  readonly isocurve = hairMaterial(colorless(), 0.32);
  readonly wires = hairMaterial(colorless(), 0.55);
  readonly net = lineMaterial(colorless(), 1.25, 0.85, 0.0004);
  readonly netDots = dotMaterial(colorless(), 8, 0.0005);
  readonly knots = lineMaterial(colorless(), 1.75, 1, 0.0003);
  readonly knotDots = dotMaterial(colorless(), 9, 0.0005);
  readonly normals = lineMaterial(colorless(), 1.25, 0.8);
  readonly comb = hairMaterial(colorless(), 0.8, 0.0002);
  /** Curves and points of the script: each puts its colour onto them when it is drawn. */
  readonly ownLine = lineMaterial(colorless(), CURVE_LINE, 1, 0.00015);
  readonly ownDots = dotMaterial(colorless(), 7);
  readonly ghostLine = lineMaterial(colorless(), 1.25, 0.55);

  /** What nearly every first picture has; its programs are those of what comes, as long as this lives. */
  private readonly first = surfaceMaterial({ color: colorless(), opacity: 1, hasTint: false, isFlat: false, hasCurvature: false });

  firsts(): Object3D[] {
    return [new Mesh(new BufferGeometry(), this.first), new Mesh(new BufferGeometry(), this.edge)];
  }

  paint(palette: Palette): void {
    // The two of hair share their uniforms.
    const colors: [ShaderMaterial, Palette["ink"]][] = [
      [this.edge, palette.edge],
      [this.edgeSelected, palette.accent],
      [this.isocurve.wide, palette.isocurve],
      [this.wires.wide, palette.edge],
      [this.net, palette.net],
      [this.netDots, palette.net],
      [this.knots, palette.knot],
      [this.knotDots, palette.knot],
      [this.normals, palette.normal],
      [this.comb.wide, palette.comb],
      [this.ghostLine, palette.ghost],
    ];
    for (const [material, color] of colors) material.uniforms.color.value = color;
  }
}

/** What decides how an item looks, besides its own data. */
export interface Look {
  settings: Settings;
  palette: Palette;
  isVisible: boolean;
  isSelected: boolean;
  /** Lines of equal parameter in the place of those that came with the item. */
  isocurves: Isocurves | null;
  /** Whether its comb is wanted. */
  isCombed: boolean;
  /** Length of a tooth of the comb for a curvature of 1. */
  combLength: number;
  normalLength: number;
  /** Distances by the keys of items, while they are shown. */
  deviations: ReadonlyMap<string, Float32Array> | null;
}

type Layer = "isocurves" | "wires" | "net" | "netDots" | "knots" | "knotDots" | "normals" | "comb";

export class DrawnItem {
  readonly group = new Group();
  private readonly surface: ShaderMaterial | null;
  private readonly body: Mesh | null = null;
  private edges: Mesh | null = null;
  /** Whether its edges are still to be found, because there are too many triangles for one frame. */
  isUnfinished = false;
  /** Of what has no surface; of curves one for all of them. */
  private readonly ownLine: ShaderMaterial | null;
  private ownColor = colorless();
  private ownWidth = CURVE_LINE;
  private readonly layers = new Map<Layer, Mesh | LineSegments | Points>();
  private combOf = "";
  private isocurvesOf: Isocurves | null = null;
  private normalsOf = 0;

  constructor(
    public item: Item,
    readonly shape: Shape,
    private readonly overlays: Overlays,
  ) {
    const { buffers } = shape;
    this.group.position.set(...buffers.center);
    const geometry = shape.surface;
    this.surface = geometry
      ? surfaceMaterial({
          color: colorless(),
          opacity: 1,
          hasTint: buffers.colors !== null,
          isFlat: buffers.normals === null,
          hasCurvature: buffers.curvatures !== null,
        })
      : null;
    if (geometry && this.surface) {
      this.body = new Mesh(geometry, this.surface);
      this.group.add(this.body);
    }
    this.ownLine = geometry ? null : this.makeOwn();
    this.isUnfinished = buffers.kind === "mesh" && (buffers.triangles?.length ?? 0) > 3 * N_AT_ONCE;
    if (!this.isUnfinished) this.finish();
    const points = shape.points();
    if (points && this.ownLine) {
      const own = new Points(points, this.ownLine);
      own.onBeforeRender = () => this.wear();
      this.group.add(own);
    }
  }

  /** Puts its colour and width onto the material that it shares with others, before it is drawn. */
  private wear(): void {
    const { uniforms } = this.ownLine!;
    uniforms.color.value = this.ownColor;
    if (uniforms.width) uniforms.width.value = this.ownWidth;
    this.ownLine!.uniformsNeedUpdate = true;
  }

  /** Adds the edges. */
  finish(): void {
    this.isUnfinished = false;
    const lines = this.shape.part("edges");
    if (!lines) return;
    this.edges = new Mesh(lines, this.ownLine ?? this.overlays.edge);
    this.edges.renderOrder = 2;
    if (this.ownLine) this.edges.onBeforeRender = () => this.wear();
    this.group.add(this.edges);
  }

  get hasSurface(): boolean {
    return this.body !== null;
  }

  get isVisible(): boolean {
    return this.group.visible;
  }

  /** Brings colours, switches and overlays up to date. */
  apply(look: Look): void {
    const { settings, palette } = look;
    this.group.visible = look.isVisible;
    if (!look.isVisible) return;
    if (this.surface) {
      this.surface.uniforms.color.value = colorOf(this.item, palette);
      this.surface.uniforms.isSelected.value = look.isSelected ? 1 : 0;
      const isMeasured = look.deviations !== null && this.shape.setDeviation(look.deviations.get(this.item.key));
      this.surface.uniforms.hasDeviation.value = isMeasured ? 1 : 0;
      setOpacity(this.surface, settings.shade === "plain" ? (this.item.opacity ?? 1) : 1);
    }
    if (this.ownLine) {
      this.ownColor = look.isSelected ? palette.accent : colorOf(this.item, palette);
      this.ownWidth = look.isSelected ? 3.25 : CURVE_LINE;
    } else if (this.edges) {
      // The creases of a mesh may be very many: its tint says that it is selected.
      const isBold = look.isSelected && this.item.kind !== "mesh";
      this.edges.visible = settings.edges || isBold;
      this.edges.material = isBold ? this.overlays.edgeSelected : this.overlays.edge;
    }
    const { shape, overlays } = this;
    if (this.isocurvesOf !== look.isocurves) {
      // Those that came with the item are its shape's.
      this.drop("isocurves", this.isocurvesOf !== null);
      this.drop("comb");
      this.isocurvesOf = look.isocurves;
    }
    this.layer("isocurves", settings.isocurves, () => hair(chosen(look.isocurves) ?? shape.part("isocurves"), overlays.isocurve, 1));
    this.layer("wires", settings.wireframe, () => hair(shape.part("wires"), overlays.wires, 1));
    this.layer("net", settings.control, () => line(shape.part("net"), overlays.net, 4));
    this.layer("netDots", settings.control, () => dots(shape.controlPoints(), overlays.netDots, 5));
    this.layer("knots", settings.knots, () => line(shape.part("knots"), overlays.knots, 3));
    this.layer("knotDots", settings.knots, () => dots(shape.knotPoints(), overlays.knotDots, 5));
    this.applyMeasured(look);
  }

  dispose(): void {
    this.group.removeFromParent();
    this.surface?.dispose();
    for (const layer of ["comb", "normals", "netDots", "knotDots"] as const) {
      this.layers.get(layer)?.geometry.dispose();
    }
    if (this.isocurvesOf) this.layers.get("isocurves")?.geometry.dispose();
  }

  /** Overlays whose geometry depends on a length that the person chooses. */
  private applyMeasured(look: Look): void {
    const { settings } = look;
    const combOf = `${look.combLength} ${settings.combStride}`;
    if (look.isCombed && this.combOf !== combOf) this.drop("comb");
    this.layer("comb", look.isCombed, () => {
      this.combOf = combOf;
      return hair(this.shape.comb(look.isocurves ?? this.shape.buffers, look.combLength, settings.combStride), this.overlays.comb, 3);
    });
    if (settings.normals && this.normalsOf !== look.normalLength) this.drop("normals");
    this.layer("normals", settings.normals, () => {
      this.normalsOf = look.normalLength;
      return line(this.shape.normals(look.normalLength), this.overlays.normals, 3);
    });
  }

  private layer(name: Layer, isOn: boolean, make: () => Mesh | LineSegments | Points | null): void {
    let made = this.layers.get(name);
    if (!made && isOn) {
      made = make() ?? new Mesh();
      this.layers.set(name, made);
      if (made.geometry.attributes.position) this.group.add(made);
    }
    if (made) made.visible = isOn;
  }

  private drop(name: Layer, isOwn = true): void {
    const made = this.layers.get(name);
    made?.removeFromParent();
    if (isOwn) made?.geometry.dispose();
    this.layers.delete(name);
  }

  private makeOwn(): ShaderMaterial {
    return this.shape.buffers.kind === "points" ? this.overlays.ownDots : this.overlays.ownLine;
  }
}

/** How far a ghost stands back, so that what has not changed is seen alone, though it was meshed anew. */
const GHOST_BEHIND = { factor: 4, units: 400 };

/** A translucent likeness of an item, for comparison. */
export function ghostOf(item: Item, shape: Shape, palette: Palette, overlays: Overlays): Group {
  const group = new Group();
  group.position.set(...shape.buffers.center);
  if (shape.surface) {
    const { buffers } = shape;
    const material = surfaceMaterial({
      color: palette.ghost,
      opacity: 0.22,
      hasTint: false,
      isFlat: buffers.normals === null,
      hasCurvature: false,
    });
    material.polygonOffsetFactor = GHOST_BEHIND.factor;
    material.polygonOffsetUnits = GHOST_BEHIND.units;
    const body = new Mesh(shape.surface, material);
    body.renderOrder = 6;
    group.add(body);
  }
  const edges = line(shape.part("edges"), overlays.ghostLine, 7);
  if (edges) group.add(edges);
  group.name = item.path;
  return group;
}

/** Lines that were asked for; null where none were. */
function chosen(isocurves: Isocurves | null): BufferGeometry | null {
  const ends = isocurves ? endsOf(isocurves.isocurves) : null;
  return ends && ends.length > 0 ? hairGeometry(ends) : null;
}

function line(geometry: BufferGeometry | null, material: ShaderMaterial, order: number): Mesh | null {
  if (!geometry) return null;
  const made = new Mesh(geometry, material);
  made.renderOrder = order;
  return made;
}

function hair(geometry: BufferGeometry | null, { wide, thin }: HairMaterial, order: number): Mesh | LineSegments | null {
  if (!geometry || isWide(geometry)) return line(geometry, wide, order);
  const made = new LineSegments(geometry, thin);
  made.renderOrder = order;
  return made;
}

function dots(geometry: BufferGeometry | null, material: ShaderMaterial, order: number): Points | null {
  if (!geometry) return null;
  const made = new Points(geometry, material);
  made.renderOrder = order;
  return made;
}
