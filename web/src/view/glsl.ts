// The shaders of surfaces and lines. Colours are computed as they are shown (sRGB), so that nothing converts them again.

/** Numbers of the shader for each way of shading. */
export const MODES = {
  plain: 0,
  zebra: 1,
  isophotes: 2,
  gauss: 3,
  mean: 4,
  k1: 5,
  k2: 6,
  draft: 7,
  sides: 8,
  deviation: 9,
} as const;

// A surface has a program for each way of shading that was wanted (MODE): a processor that draws by itself goes
// through everything that a program holds, whatever it needs of it.
export const SURFACE_VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
varying vec3 vPlace;
#if IS_FLAT == 0
varying vec3 vNormal;
#endif
#if MODE >= 3 && MODE <= 6
attribute vec2 curvature;
varying vec2 vCurvature;
#endif
#if MODE == 9
attribute float deviation;
varying float vDeviation;
#endif
#if HAS_TINT == 1
attribute vec3 tint;
varying vec3 vTint;
#endif
void main() {
  #if IS_FLAT == 0
    vNormal = normalMatrix * normal;
  #endif
  #if MODE >= 3 && MODE <= 6
    vCurvature = curvature;
  #endif
  #if MODE == 9
    vDeviation = deviation;
  #endif
  #if HAS_TINT == 1
    vTint = tint;
  #endif
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  vPlace = mvPosition.xyz;
  gl_Position = projectionMatrix * mvPosition;
  #include <clipping_planes_vertex>
}`;

export const SURFACE_FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform vec3 color;
uniform float opacity;
uniform float hasCurvature;
uniform float hasDeviation;
uniform float isSelected;
uniform float fade;
uniform vec3 faded;
uniform vec3 accent;
uniform float isParallel;
uniform float isFromAfar;
uniform float stripes;
uniform vec3 axis;
uniform vec3 light;
uniform vec2 range;
uniform float draft;
varying vec3 vPlace;
#if IS_FLAT == 0
varying vec3 vNormal;
#endif
#if MODE >= 3 && MODE <= 6
varying vec2 vCurvature;
#endif
#if MODE == 9
varying float vDeviation;
#endif
#if HAS_TINT == 1
varying vec3 vTint;
#endif

// To light and back, by polynomials and roots: powers take a processor longer than all else.
vec3 linear(vec3 c) { return c * c * (0.305306 * c + 0.682171) + 0.012523 * c; }
vec3 shown(vec3 c) {
  vec3 a = sqrt(max(c, 0.0)), b = sqrt(a), d = sqrt(b);
  return max(0.662002687 * a + 0.684122060 * b - 0.323583601 * d - 0.0225411470 * c, 0.0);
}

// Blue over a quiet middle to red; both ends dark enough to stand on paper.
vec3 ramp(float t) {
  vec3 a = vec3(0.13, 0.27, 0.60), b = vec3(0.25, 0.60, 0.80), c = vec3(0.93, 0.92, 0.87);
  vec3 d = vec3(0.93, 0.60, 0.28), e = vec3(0.68, 0.13, 0.16);
  t = clamp(t, 0.0, 1.0) * 4.0;
  if (t < 1.0) return mix(a, b, t);
  if (t < 2.0) return mix(b, c, t - 1.0);
  if (t < 3.0) return mix(c, d, t - 2.0);
  return mix(d, e, t - 3.0);
}

// Edges of stripes as wide as a pixel; where stripes are finer than pixels, their mean.
float stripe(float x, float width) {
  float w = max(width, 1e-5);
  float d = abs(fract(x) - 0.5) - 0.25;
  return mix(smoothstep(-w, w, d), 0.5, smoothstep(0.35, 0.9, w));
}

// Directions of length 1 to the lamps: one above on the left, one on the right.
const vec3 KEY = vec3(-0.426162, 0.662919, 0.615568), FILL = vec3(0.799002, 0.049938, 0.599251);
vec3 lit(vec3 base, vec3 n, vec3 v, float gloss) {
  float key = max(dot(n, KEY), 0.0);
  float fill = max(dot(n, FILL), 0.0);
  float sky = 0.5 + 0.5 * n.y;
  vec3 warm = vec3(1.0, 0.985, 0.96), cool = vec3(0.90, 0.95, 1.0);
  float s = max(dot(n, normalize(KEY + v)), 0.0);
  float s4 = s * s * s * s, s12 = s4 * s4 * s4, s48 = s12 * s12 * s12 * s12;
  float shine = s48 * s12 * 0.22 + s12 * 0.06;
  float away = 1.0 - max(dot(n, v), 0.0);
  float rim = away * away * away * 0.10;
  vec3 c = linear(base) * (0.20 + 0.22 * sky * cool + 0.58 * key * warm + 0.20 * fill * cool);
  return shown(c + gloss * (shine + rim));
}

void main() {
  #include <clipping_planes_fragment>
  vec3 v = isParallel > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-vPlace);
  vec3 face = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  #if IS_FLAT == 1
    vec3 n = face;
    bool isBack = !gl_FrontFacing;
    vec3 outward = isBack ? -n : n;
  #else
    vec3 n = normalize(vNormal), outward = n;
    bool isBack = dot(n, face) < 0.0;
    if (isBack) n = -n;
  #endif
  #if HAS_TINT == 1
    vec3 base = vTint;
  #else
    vec3 base = color;
  #endif
  vec3 c;
  #if MODE == 1
    // By the sector, about an axis across the view, into which the ray is mirrored, as the kernel has them.
    vec3 ray = isFromAfar > 0.5 ? vec3(0.0, 0.0, 1.0) : v;
    vec3 r = reflect(-ray, n);
    vec2 q = vec2(dot(r, axis), dot(r, ray));
    vec2 turn = (q.y * vec2(dFdx(q.x), dFdy(q.x)) - q.x * vec2(dFdx(q.y), dFdy(q.y))) / max(dot(q, q), 1e-12);
    float scale = stripes / 3.14159265;
    float s = stripe(atan(q.x, q.y) * scale, (abs(turn.x) + abs(turn.y)) * scale);
    c = mix(vec3(0.07, 0.08, 0.10), vec3(0.97, 0.97, 0.96), s);
    c = mix(c, lit(c, n, v, 1.0), 0.35);
  #elif MODE == 2
    float x = acos(clamp(dot(outward, light), -1.0, 1.0)) * stripes / 1.57079633;
    float s = stripe(x, fwidth(x));
    c = lit(mix(base, vec3(0.14, 0.18, 0.24), s * 0.72), n, v, 0.4);
  #elif MODE >= 3 && MODE <= 6 || MODE == 9
    #if MODE == 9
      float k = vDeviation;
    #elif MODE == 3
      float k = vCurvature.x * vCurvature.y;
    #elif MODE == 4
      float k = 0.5 * (vCurvature.x + vCurvature.y);
    #elif MODE == 5
      float k = vCurvature.x;
    #else
      float k = vCurvature.y;
    #endif
    bool isKnown = (MODE == 9 || hasCurvature > 0.5) && k == k && abs(k) < 1e30;
    vec3 q = isKnown ? ramp((k - range.x) / (range.y - range.x)) : vec3(0.55);
    if (!isKnown && mod(gl_FragCoord.x + gl_FragCoord.y, 8.0) < 2.0) q = vec3(0.42);
    c = mix(q, lit(q, n, v, 0.25), 0.55);
    #if MODE == 9
      if (hasDeviation < 0.5) c = lit(mix(base, vec3(0.62, 0.66, 0.70), 0.7), n, v, 0.4);
    #endif
  #elif MODE == 7
    float angle = degrees(asin(clamp(dot(outward, axis), -1.0, 1.0)));
    float w = max(fwidth(angle), 1e-4);
    vec3 q = mix(vec3(0.76, 0.25, 0.22), vec3(0.95, 0.78, 0.35), smoothstep(-w, w, angle + draft));
    q = mix(q, vec3(0.25, 0.62, 0.45), smoothstep(-w, w, angle - draft));
    c = mix(q, lit(q, n, v, 0.25), 0.6);
  #elif MODE == 8
    c = lit(isBack ? vec3(0.80, 0.35, 0.62) : vec3(0.42, 0.66, 0.72), n, v, 0.5);
  #else
    c = lit(isBack ? mix(base, base * vec3(0.80, 0.84, 0.90), 0.8) : base, n, v, 1.0);
  #endif
  if (isSelected > 0.5) {
    float edge = 1.0 - max(dot(n, v), 0.0);
    c = mix(c, accent, MODE == 0 ? 0.16 + 0.40 * edge : 0.10 + 0.45 * edge * edge);
  }
  float grey = dot(c, vec3(0.30, 0.59, 0.11));
  c = mix(c, mix(vec3(grey), faded, 0.45), fade);
  #if NUM_CLIPPING_PLANES > 0
    float d = clippingPlanes[0].w - dot(vClipPosition, clippingPlanes[0].xyz);
    float w = fwidth(d);
    c = mix(accent, c, smoothstep(1.2, 2.2, d / max(w, 1e-12)));
  #endif
  gl_FragColor = vec4(c, opacity);
}`;

export const CAP_VERTEX = /* glsl */ `
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// Hatched, as a drawing shows what is cut; `hatch` is 1 or -1.
export const CAP_FRAGMENT = /* glsl */ `
uniform vec3 color;
uniform vec3 accent;
uniform float isSelected;
uniform float hatch;
uniform float fade;
uniform vec3 faded;
void main() {
  vec3 c = mix(color, vec3(1.0), 0.30);
  float x = abs(mod(gl_FragCoord.x + hatch * gl_FragCoord.y, 9.0) - 4.5);
  c = mix(c, color * 0.82, 1.0 - smoothstep(0.3, 1.3, x));
  if (isSelected > 0.5) c = mix(c, accent, 0.3);
  float grey = dot(c, vec3(0.30, 0.59, 0.11));
  gl_FragColor = vec4(mix(c, mix(vec3(grey), faded, 0.45), fade), 1.0);
}`;

export const LINE_VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
attribute vec3 start;
attribute vec3 end;
uniform vec2 screen;
uniform float width;
uniform float lift;
varying float vAcross;
varying float vHalf;
void main() {
  vec4 a = modelViewMatrix * vec4(start, 1.0);
  vec4 b = modelViewMatrix * vec4(end, 1.0);
  // Cut what lies behind the eye, where division would turn it around.
  bool isPerspective = projectionMatrix[2][3] == -1.0;
  if (isPerspective) {
    float near = -0.5 * projectionMatrix[3][2] / projectionMatrix[2][2];
    if (a.z > near && b.z < near) a.xyz = mix(b.xyz, a.xyz, (near - b.z) / (a.z - b.z));
    else if (b.z > near && a.z < near) b.xyz = mix(a.xyz, b.xyz, (near - a.z) / (b.z - a.z));
  }
  vec4 p = projectionMatrix * a, q = projectionMatrix * b;
  vec2 along = (q.xy / q.w - p.xy / p.w) * screen;
  float n = length(along);
  along = n > 1e-6 ? along / n : vec2(1.0, 0.0);
  vHalf = 0.5 * width;
  float reach = vHalf + 1.0;
  vAcross = position.y * reach;
  vec4 mvPosition = position.x < 0.5 ? a : b;
  vec4 clip = position.x < 0.5 ? p : q;
  vec2 offset = vec2(-along.y, along.x) * position.y * reach + along * (position.x * 2.0 - 1.0) * vHalf * 0.6;
  clip.xy += offset * 2.0 / screen * clip.w;
  clip.z -= lift * clip.w;
  gl_Position = clip;
  #include <clipping_planes_vertex>
}`;

// Lines a pixel wide, as the renderer has them.
export const HAIR_VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
uniform float lift;
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  gl_Position.z -= lift * gl_Position.w;
  #include <clipping_planes_vertex>
}`;

export const HAIR_FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform vec3 color;
uniform float opacity;
uniform float fade;
uniform vec3 faded;
void main() {
  #include <clipping_planes_fragment>
  gl_FragColor = vec4(mix(color, faded, fade * 0.6), opacity);
}`;

export const LINE_FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform vec3 color;
uniform float opacity;
uniform float fade;
uniform vec3 faded;
varying float vAcross;
varying float vHalf;
void main() {
  #include <clipping_planes_fragment>
  float a = clamp(vHalf + 0.5 - abs(vAcross), 0.0, 1.0) * min(1.0, vHalf * 2.0);
  if (a < 0.02) discard;
  gl_FragColor = vec4(mix(color, faded, fade * 0.6), a * opacity);
}`;

export const DOT_VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
uniform float size;
uniform float dots;
uniform float lift;
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  gl_Position.z -= lift * gl_Position.w;
  gl_PointSize = size * dots;
  #include <clipping_planes_vertex>
}`;

export const DOT_FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform vec3 color;
uniform float opacity;
uniform float size;
uniform float fade;
uniform vec3 faded;
void main() {
  #include <clipping_planes_fragment>
  float r = length(gl_PointCoord - 0.5) * size;
  float a = clamp(size * 0.5 - r, 0.0, 1.0);
  if (a < 0.02) discard;
  float rim = smoothstep(size * 0.5 - 2.2, size * 0.5 - 1.2, r);
  gl_FragColor = vec4(mix(mix(color, vec3(1.0), rim * 0.55), faded, fade * 0.6), a * opacity);
}`;
