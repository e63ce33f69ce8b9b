// A stand-in for the server while the page is being worked on: a sphere, a wavy patch, a curve with its comb, a list of rings.
//   node mock.mjs [PORT] [TRIANGLES]
// It evaluates nothing; POST /mock/break and /mock/mend pretend that the script was edited.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";

const port = Number(process.argv[2] ?? 8017);
const n_wanted = Number(process.argv[3] ?? 8000);
const folder = new URL("dist/", import.meta.url);
const values = { height: 12, rings: 5, style: "calm", closed: true, title: "patch" };
let version = 1;
let isBroken = false;
const streams = new Set();

function encode(header, buffers) {
  let offset = 0;
  const places = [];
  for (const buffer of buffers) {
    places.push(offset);
    offset += Math.ceil(buffer.byteLength / 8) * 8;
  }
  const text = (base) => JSON.stringify(header(places.map((place) => base + place)));
  let base = 8;
  while (4 + Buffer.byteLength(text(base)) > base) base += 8;
  const bytes = Buffer.alloc(base + offset, " ");
  bytes.writeUInt32LE(base - 4, 0);
  bytes.write(text(base), 4);
  buffers.forEach((buffer, i) => Buffer.from(buffer.buffer, buffer.byteOffset, buffer.byteLength).copy(bytes, base + places[i]));
  return bytes;
}

/** A surface from its function, with derivatives by differences. */
function surface(at, n, center) {
  const d = 1e-3;
  const sub = (a, b) => a.map((x, k) => x - b[k]);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const positions = [], normals = [], parameters = [], curvatures = [], triangles = [];
  for (let i = 0; i <= n; i++) {
    for (let j = 0; j <= n; j++) {
      const [u, v] = [i / n, j / n];
      const [a, b] = [Math.min(Math.max(u, d), 1 - d), Math.min(Math.max(v, d), 1 - d)];
      const p = at(a, b);
      const [pu, mu, pv, mv] = [at(a + d, b), at(a - d, b), at(a, b + d), at(a, b - d)];
      const su = sub(pu, mu).map((x) => x / (2 * d));
      const sv = sub(pv, mv).map((x) => x / (2 * d));
      const suu = p.map((x, k) => (pu[k] - 2 * x + mu[k]) / d ** 2);
      const svv = p.map((x, k) => (pv[k] - 2 * x + mv[k]) / d ** 2);
      const [pp, pm, mp, mm] = [at(a + d, b + d), at(a + d, b - d), at(a - d, b + d), at(a - d, b - d)];
      const suv = p.map((_, k) => (pp[k] - pm[k] - mp[k] + mm[k]) / (4 * d * d));
      const c = cross(su, sv);
      const length = Math.hypot(...c) || 1;
      const normal = c.map((x) => x / length);
      const [E, F, G, L, M, N] = [dot(su, su), dot(su, sv), dot(sv, sv), dot(suu, normal), dot(suv, normal), dot(svv, normal)];
      const det = E * G - F * F;
      const K = (L * N - M * M) / det;
      const H = (E * N - 2 * F * M + G * L) / (2 * det);
      const root = Math.sqrt(Math.max(0, H * H - K));
      positions.push(...sub(at(u, v), center));
      normals.push(...normal);
      parameters.push(u, v);
      curvatures.push(H + root, H - root);
      if (i < n && j < n) {
        const q = i * (n + 1) + j;
        triangles.push(q, q + n + 1, q + 1, q + 1, q + n + 1, q + n + 2);
      }
    }
  }
  const iso = (line) => new Float32Array(Array.from({ length: 61 }, (_, k) => sub(line(k / 60), center)).flat());
  const edges = [(t) => at(t, 0), (t) => at(t, 1), (t) => at(0, t), (t) => at(1, t)].map(iso);
  const isocurves = [0.25, 0.5, 0.75].flatMap((c) => [(t) => at(t, c), (t) => at(c, t)]).map(iso);
  const control = [];
  for (let i = 0; i < 5; i++) for (let j = 0; j < 4; j++) control.push(...sub(at(i / 4, j / 3), center).map((x, k) => x + (k === 2 ? 0.3 : 0)));
  const buffers = [new Float32Array(positions), new Float32Array(normals), new Float32Array(parameters), new Float32Array(curvatures), new Uint32Array(triangles), new Float32Array(control), ...edges, ...isocurves];
  const count = positions.length / 3;
  return encode(
    (o) => ({
      kind: "surface", center,
      positions: { offset: o[0], count }, normals: { offset: o[1], count }, parameters: { offset: o[2], count },
      curvatures: { offset: o[3], count }, triangles: { offset: o[4], count: triangles.length / 3 },
      control: { points: { offset: o[5], count: 20 }, size: [5, 4] },
      edges: edges.map((e, i) => ({ offset: o[6 + i], count: e.length / 3 })),
      isocurves: isocurves.map((e, i) => ({ offset: o[10 + i], count: e.length / 3 })),
      knots: { u: [0, 0, 0, 0, 0.5, 1, 1, 1, 1], v: [0, 0, 0, 0, 1, 1, 1, 1] }, comb: null,
    }),
    buffers,
  );
}

/** A curve from its function, with the curvature vector by differences. */
function curve(at, center) {
  const n = 160, d = 1e-3;
  const line = [], comb = [], ts = [];
  for (let i = 0; i <= n; i++) {
    const t = i / n;
    const [p, a, b] = [at(t), at(t - d), at(t + d)];
    const first = p.map((_, k) => (b[k] - a[k]) / (2 * d));
    const second = p.map((x, k) => (b[k] - 2 * x + a[k]) / d ** 2);
    const speed = Math.hypot(...first) ** 2;
    const along = (first[0] * second[0] + first[1] * second[1] + first[2] * second[2]) / speed;
    line.push(...p.map((x, k) => x - center[k]));
    comb.push(...second.map((x, k) => (x - along * first[k]) / speed));
    ts.push(t);
  }
  return encode(
    (o) => ({
      kind: "curve", center, positions: null, normals: null, parameters: { offset: o[2], count: n + 1 }, curvatures: null, triangles: null,
      edges: [{ offset: o[0], count: n + 1 }], isocurves: [], control: null, knots: { t: [0, 0, 0, 0, 0.5, 1, 1, 1, 1] },
      comb: { offset: o[1], count: n + 1 },
    }),
    [new Float32Array(line), new Float32Array(comb), new Float32Array(ts)],
  );
}

const tau = 2 * Math.PI;
const ball = (u, v) => [26 + 8 * Math.cos(tau * u) * Math.sin(Math.PI * v), 8 * Math.sin(tau * u) * Math.sin(Math.PI * v), 8 - 8 * Math.cos(Math.PI * v)];
const wave = (h) => (u, v) => [30 * u - 15, 24 * v - 12, (h / 4) * Math.sin(3 * u) * Math.cos(4 * v) + h * u * v * 0.4];
const keel = (h) => (t) => [40 * t - 15, -16 + 4 * Math.sin(6 * t), (h / 3) * t * t];
const ring = (r) => (t) => [-24 + r * Math.cos(tau * t), r * Math.sin(tau * t), r];

function model() {
  const n = Math.max(4, Math.round(Math.sqrt(n_wanted / 4)));
  const h = values.height;
  const items = [
    ["patch", "patch", `patch-${h}-${n}`, "surface", [92, 138, 176], "hull", () => surface(wave(h), n, [0, 0, h / 4])],
    ["ball", "ball", `ball-${n}`, "surface", null, null, () => surface(ball, n, [26, 0, 8])],
    ["keel", "keel", `keel-${h}`, "curve", null, "lines", () => curve(keel(h), [5, -16, 0])],
  ];
  for (let i = 0; i < values.rings; i++) items.push(["rings", `rings[${i}]`, `ring-${i}`, "curve", [180, 90, 60], "lines", () => curve(ring(2 + i), [-24, 0, 0])]);
  return items;
}

function state() {
  const items = model().map(([definition, path, key, kind, color, layer]) => ({
    key, definition, path, kind, color, opacity: null, layer, isHidden: false, isShown: true, isExported: true,
    facts: kind === "surface" ? { degree: "3 x 3", controlPoints: "5 x 4", triangles: n_wanted / 2 } : { degree: "3", controlPoints: "5", points: 161 },
    bounds: kind === "surface" ? (path === "ball" ? [[18, -8, 0], [34, 8, 16]] : [[-15, -12, -values.height / 4], [15, 12, values.height / 2]]) : path === "keel" ? [[-15, -20, 0], [25, -12, 4]] : [[-31, -7, 2], [-17, 7, 7]],
    span: { line: 7, column: 1 },
  }));
  const number = (name, value, fallback, least, most, step, unit, label) => ({ name, label, docs: `How ${label.toLowerCase()} it is.`, kind: unit ? "length" : "number", value: `${value}${unit ?? ""}`, default: `${fallback}${unit ?? ""}`, number: value, least, most, step, unit, choices: null, isSet: value !== fallback });
  const plain = (name, kind, value, fallback, choices = null) => ({ name, label: null, docs: null, kind, value: String(value), default: String(fallback), number: null, least: null, most: null, step: null, unit: null, choices, isSet: value !== fallback });
  return {
    version, script: "mock.geo", unit: "mm", millimetres: 1, tolerance: 1e-3, isCurrent: !isBroken, isPartial: false, bounds: [[-31, -20, -4], [34, 12, 16]], items,
    parameters: [
      number("height", values.height, 12, 4, 20, null, "mm", "Height of the wave"),
      number("rings", values.rings, 5, 1, 9, 1, null, "Rings"),
      plain("style", "choice", values.style, "calm", ["calm", "rough", "flat"]),
      plain("closed", "bool", values.closed, true),
      plain("title", "text", values.title, "patch"),
    ],
    checks: [
      { text: "area(patch) < 900mm^2", verdict: "pass", left: "812.4 mm²", right: "900 mm²", distance: "87.6", limit: "0", line: 12 },
      { text: "volume(ball) == 2144.66 within 0.01", verdict: "fail", left: "2144.6605", right: "2144.64", distance: "0.0205", limit: "0.01", line: 13 },
      { text: "closed(rings[0])", verdict: "pass", left: null, right: null, distance: null, limit: null, line: 14 },
    ],
    prints: [{ text: "length(keel)", value: "43.217 mm", line: 16 }],
    exports: [{ path: "mock.stl", line: 18 }], exportFolder: "/tmp/out",
    diagnostics: isBroken ? [{ severity: "error", code: "E0201", message: "nothing is called c", text: "error[E0201]: nothing is called c\n  ┌─ mock.geo:9:11\n  │\n9 │ surface c2 = c\n  │              ^ not defined\n  = did you mean `keel`?", file: "mock.geo", line: 9, column: 14 }] : [],
    milliseconds: { evaluate: 3.1, mesh: 8.4 }, definitions: { evaluated: 2, reused: 6 },
  };
}

function next() {
  version++;
  for (const stream of streams) {
    stream.write(`event: busy\ndata: {"version":${version}}\n\n`);
    setTimeout(() => stream.write(`event: state\ndata: {"version":${version}}\n\n`), 10);
  }
}

async function post(path, body) {
  if (path === "/mock/break" || path === "/mock/mend") {
    isBroken = path === "/mock/break";
    next();
    return {};
  }
  if (path === "/api/set") {
    if (body.reset) Object.assign(values, { height: 12, rings: 5, style: "calm", closed: true, title: "patch" });
    for (const [name, text] of Object.entries(body.values ?? {})) {
      const fallback = { height: 12, rings: 5, style: "calm", closed: true, title: "patch" }[name];
      if (text === null) values[name] = fallback;
      else values[name] = typeof fallback === "number" ? parseFloat(text) : typeof fallback === "boolean" ? text === "true" : text;
    }
    next();
    return { accepted: true };
  }
  if (path === "/api/ask") {
    const name = body.item.split("-")[0];
    const isCurve = body.t !== undefined;
    const point = name === "ball" ? ball(body.u, body.v) : name === "patch" ? wave(values.height)(body.u, body.v) : keel(values.height)(body.t);
    return isCurve
      ? { definition: name, expression: `${name}(${body.t})`, point, normal: null, facts: [{ label: "Curvature", value: 0.02, text: "0.02 /mm" }, { label: "Tangent", value: [1, 0, 0], text: "1 0 0" }] }
      : { definition: name, expression: `${name}(${body.u.toFixed(4)}, ${body.v.toFixed(4)})`, point, normal: name === "ball" ? point.map((x, k) => (x - [26, 0, 8][k]) / 8) : [0, 0, 1],
          facts: [{ label: "k1", value: 0.125, text: "0.125 /mm" }, { label: "k2", value: 0.125, text: "0.125 /mm" }, { label: "Gaussian curvature", value: 0.0156, text: "0.0156 /mm²" }, { label: "Direction of k1", value: [1, 0, 0], text: "" }, { label: "Direction of k2", value: [0, 1, 0], text: "" }] };
  }
  if (path === "/api/measure") return { value: 12.5, text: "12.5 mm" };
  if (path === "/api/write") return { written: Object.keys(body.values) };
  if (path === "/api/export") return { files: [body.file ?? "mock.stl"] };
  return { stopped: true };
}

/** Items in one answer: how many, their lengths, and the bytes of each from a multiple of 8 on. */
function together(keys) {
  const all = keys.map((key) => Buffer.from(model().find(([, , known]) => known === key)?.[6]() ?? ""));
  const head = Buffer.alloc(4 + 4 * all.length);
  [all.length, ...all.map((bytes) => bytes.length)].forEach((n, i) => head.writeUInt32LE(n, 4 * i));
  return Buffer.concat([head, ...all].map((bytes) => Buffer.concat([bytes, Buffer.alloc((8 - (bytes.length % 8)) % 8)])));
}

createServer(async (request, response) => {
  const path = new URL(request.url, "http://x").pathname;
  const send = (type, bytes, headers = {}) => response.writeHead(200, { "Content-Type": type, ...headers }).end(bytes);
  if (request.method === "POST") {
    let text = "";
    for await (const part of request) text += part;
    if (path === "/api/items") return send("application/octet-stream", together(JSON.parse(text).items));
    return send("application/json", JSON.stringify(await post(path, JSON.parse(text || "{}"))));
  }
  if (path === "/") return send("text/html", readFileSync(new URL("index.html", folder)));
  if (path === "/app.js") return send("text/javascript", readFileSync(new URL("app.js.gz", folder)), { "Content-Encoding": "gzip" });
  if (path === "/begin.js") return send("text/javascript", readFileSync(new URL("begin.js.gz", folder)), { "Content-Encoding": "gzip" });
  if (path === "/app.css") return send("text/css", readFileSync(new URL("app.css.gz", folder)), { "Content-Encoding": "gzip" });
  if (path === "/api/state") return send("application/json", JSON.stringify(state()));
  if (path.startsWith("/api/item/")) {
    const found = model().find(([, , key]) => key === path.slice("/api/item/".length));
    return found ? send("application/octet-stream", found[6]()) : response.writeHead(404).end();
  }
  if (path === "/api/events") {
    response.writeHead(200, { "Content-Type": "text/event-stream" }).write(`event: state\ndata: {"version":${version}}\n\n`);
    streams.add(response);
    return request.on("close", () => streams.delete(response));
  }
  response.writeHead(404).end();
}).listen(port, "127.0.0.1", () => console.log(`http://127.0.0.1:${port}/?token=mock`));
