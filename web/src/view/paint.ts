// Materials: one for surfaces, one for lines, one for dots. What all share is one object, changed in one place.

import { Color, DoubleSide, Plane, ShaderMaterial, Vector2, Vector3 } from "three";

import { DOT_FRAGMENT, DOT_VERTEX, HAIR_FRAGMENT, HAIR_VERTEX, LINE_FRAGMENT, LINE_VERTEX, MODES, SURFACE_FRAGMENT, SURFACE_VERTEX } from "./glsl";

/** Uniforms that every material reads; changing a value here changes the whole picture. */
export const shared = {
  isParallel: { value: 0 },
  /** Whether stripes are seen along parallel rays, however the picture is projected. */
  isFromAfar: { value: 0 },
  stripes: { value: 6 },
  axis: { value: new Vector3(0, 1, 0) },
  light: { value: new Vector3(0, 0, 1) },
  range: { value: new Vector2(-1, 1) },
  draft: { value: 3 },
  fade: { value: 0 },
  faded: { value: new Color() },
  accent: { value: new Color() },
  screen: { value: new Vector2(1, 1) },
  /** How large dots are, in proportion to what they should be: a coarse frame has fewer pixels. */
  dots: { value: 1 },
};

/** The section plane; the list is empty while nothing is cut. */
export const cut: { plane: Plane; planes: Plane[] } = { plane: new Plane(), planes: [] };
const clipped = new Set<ShaderMaterial>();

/** Switches the section on or off in every material. */
export function setCut(isCut: boolean): void {
  cut.planes = isCut ? [cut.plane] : [];
  for (const material of clipped) material.clippingPlanes = cut.planes;
}

/** How all surfaces are shaded. */
let mode: number = MODES.plain;
const shaded = new Set<ShaderMaterial>();

/** Shades all surfaces in this way; a program for it is made when it is first drawn. */
export function setMode(wanted: number): void {
  if (wanted === mode) return;
  mode = wanted;
  for (const material of shaded) {
    material.defines.MODE = mode;
    material.needsUpdate = true;
  }
}

export interface SurfaceLook {
  color: Color;
  opacity: number;
  hasTint: boolean;
  isFlat: boolean;
  hasCurvature: boolean;
}

export function surfaceMaterial(look: SurfaceLook): ShaderMaterial {
  const material = new ShaderMaterial({
    defines: { MODE: mode, IS_FLAT: look.isFlat ? 1 : 0, HAS_TINT: look.hasTint ? 1 : 0 },
    uniforms: {
      ...shared,
      color: { value: look.color },
      opacity: { value: look.opacity },
      hasCurvature: { value: look.hasCurvature ? 1 : 0 },
      hasDeviation: { value: 0 },
      isSelected: { value: 0 },
    },
    vertexShader: SURFACE_VERTEX,
    fragmentShader: SURFACE_FRAGMENT,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  setOpacity(material, look.opacity);
  shaded.add(material);
  material.addEventListener("dispose", () => shaded.delete(material));
  return clip(material);
}

export function setOpacity(material: ShaderMaterial, opacity: number): void {
  material.uniforms.opacity.value = opacity;
  material.transparent = opacity < 1;
  material.depthWrite = opacity >= 1;
}

/** Lines `width` pixels wide; `lift` brings them nearer than the surface that they lie in. */
export function lineMaterial(color: Color, width: number, opacity = 1, lift = 0.00012): ShaderMaterial {
  return clip(wholeLineMaterial(color, width, opacity, lift));
}

/** The same of lines that the section plane does not cut. */
export function wholeLineMaterial(color: Color, width: number, opacity = 1, lift = 0.00012): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: {
      screen: shared.screen,
      fade: shared.fade,
      faded: shared.faded,
      color: { value: color },
      width: { value: width },
      opacity: { value: opacity },
      lift: { value: lift },
    },
    vertexShader: LINE_VERTEX,
    fragmentShader: LINE_FRAGMENT,
    side: DoubleSide,
    forceSinglePass: true,
    transparent: true,
    depthWrite: false,
  });
}

/** Lines a pixel wide, for geometries of both kinds: those that the shader makes wide, and those that the renderer draws. */
export interface HairMaterial {
  wide: ShaderMaterial;
  thin: ShaderMaterial;
}

export function hairMaterial(color: Color, opacity: number, lift?: number): HairMaterial {
  const wide = lineMaterial(color, 1, opacity, lift);
  const { uniforms } = wide;
  const thin = new ShaderMaterial({ uniforms, vertexShader: HAIR_VERTEX, fragmentShader: HAIR_FRAGMENT, transparent: true, depthWrite: false });
  return { wide, thin: clip(thin) };
}

export function dotMaterial(color: Color, size: number, lift = 0.0003): ShaderMaterial {
  return clip(
    new ShaderMaterial({
      uniforms: {
        fade: shared.fade,
        faded: shared.faded,
        dots: shared.dots,
        color: { value: color },
        size: { value: size },
        opacity: { value: 1 },
        lift: { value: lift },
      },
      vertexShader: DOT_VERTEX,
      fragmentShader: DOT_FRAGMENT,
      transparent: true,
      depthWrite: false,
    }),
  );
}

/** Lets the section plane cut what this material paints, until the material is disposed of. */
function clip(material: ShaderMaterial): ShaderMaterial {
  material.clipping = true;
  material.clippingPlanes = cut.planes;
  clipped.add(material);
  material.addEventListener("dispose", () => clipped.delete(material));
  return material;
}
