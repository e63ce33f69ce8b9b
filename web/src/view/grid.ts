// The grid in the xy-plane: lines at round distances that thin out as one comes nearer, with the axes in it.

import { Color, DoubleSide, Mesh, PlaneGeometry, ShaderMaterial, Vector2, Vector3 } from "three";

import type { Rig } from "./rig";

const VERTEX = /* glsl */ `
uniform float reach;
varying vec2 vPlace;
void main() {
  vPlace = position.xy * reach;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(vPlace, 0.0, 1.0);
}`;

const FRAGMENT = /* glsl */ `
uniform float reach;
uniform float fine;
uniform float coarse;
uniform float blend;
uniform vec2 origin;
uniform vec3 ink;
uniform vec3 red;
uniform vec3 green;
varying vec2 vPlace;
float lines(vec2 p, float step) {
  vec2 x = p / step;
  vec2 w = max(fwidth(x), 1e-6);
  vec2 d = abs(fract(x - 0.5) - 0.5) / w;
  vec2 a = (1.0 - clamp(d, 0.0, 1.0)) * (1.0 - smoothstep(0.15, 0.5, w));
  return max(a.x, a.y);
}
void main() {
  float far = 1.0 - smoothstep(0.25, 1.0, length(vPlace) / reach);
  float a = max(lines(vPlace, fine) * blend * 0.45, lines(vPlace, coarse));
  vec2 w = fwidth(vPlace);
  vec2 d = abs(vPlace - origin) / max(w, 1e-12);
  vec2 axes = 1.0 - clamp(d - 0.1, 0.0, 1.0);
  vec3 c = ink;
  a *= 0.16;
  if (axes.y > 0.0) { c = mix(c, red, axes.y); a = max(a, axes.y * 0.75); }
  if (axes.x > 0.0) { c = mix(c, green, axes.x); a = max(a, axes.x * 0.75); }
  a *= far;
  if (a < 0.004) discard;
  gl_FragColor = vec4(c, a);
}`;

export class Grid {
  readonly mesh: Mesh;
  /** Distance of the coarse lines, in the document's unit. */
  step = 1;
  private readonly material = new ShaderMaterial({
    uniforms: {
      reach: { value: 1 },
      fine: { value: 1 },
      coarse: { value: 10 },
      blend: { value: 1 },
      origin: { value: new Vector2() },
      ink: { value: new Color() },
      red: { value: new Color() },
      green: { value: new Color() },
    },
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
      forceSinglePass: true,
  });

  constructor() {
    this.mesh = new Mesh(new PlaneGeometry(2, 2), this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -1;
  }

  paint(ink: Color, red: Color, green: Color): void {
    const { uniforms } = this.material;
    uniforms.ink.value = ink;
    uniforms.red.value = red;
    uniforms.green.value = green;
  }

  /** Places the grid under the target; its coordinates are taken from a line near by, so that they stay exact far out. */
  update(rig: Rig): void {
    const { target, height } = rig.pose;
    const coarse = 10 ** Math.round(Math.log10(height / 5));
    this.step = coarse;
    const snap = (x: number): number => Math.round(x / (coarse * 10)) * coarse * 10;
    const middle = new Vector3(snap(target[0]), snap(target[1]), 0);
    const away = Math.hypot(target[0] - middle.x, target[1] - middle.y);
    this.mesh.position.copy(middle);
    const { uniforms } = this.material;
    uniforms.reach.value = 3 * height + away;
    uniforms.fine.value = coarse / 10;
    uniforms.coarse.value = coarse;
    // Fine lines appear as their distance grows from 6 to 16 pixels.
    uniforms.blend.value = Math.min(1, Math.max(0, (coarse / 10 / rig.perPixel - 6) / 10));
    uniforms.origin.value.set(-middle.x, -middle.y);
  }
}
