// Measures the viewer against what it is to reach, and prints a table: `node test/figures.mjs [NAME …]`.
// It asserts nothing: figures depend on the machine and on who else works on it. VIROTE names the command.
// A headless Chromium draws with the processor, so what waits for a drawn frame is told beside what does not.

import { copyFileSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { gzipSync } from "node:zlib";

import { closeBrowser, command, openBrowser, openPage, replace, serveFile } from "./harness.mjs";

const examples = resolve(import.meta.dirname, "../../examples");
const folder = mkdtempSync(join(tmpdir(), "virote-figures-"));
const pause = (time) => new Promise((done) => setTimeout(done, time));
const now = () => performance.timeOrigin + performance.now();
const rows = [];
const tell = (what, goal, found) => {
  rows.push([what, goal, found]);
  console.log(`${what} | ${goal} | ${found}`);
};
const ms = (time) => `${time.toFixed(time < 10 ? 1 : 0)} ms`;
const median = (all) => [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)];
const spread = (all) => `${ms(median(all))} (${ms(Math.min(...all))} to ${ms(Math.max(...all))})`;

function example(name) {
  for (const file of readdirSync(examples)) if (/\.(geo|bpt)$/.test(file)) copyFileSync(join(examples, file), join(folder, file));
  return join(folder, name);
}

/** Asks the server as the page does. */
async function ask(served, path, body) {
  const { origin, searchParams } = new URL(served.url);
  const headers = { "X-Virote-Token": searchParams.get("token"), "Content-Type": "application/json" };
  const method = body ? "POST" : "GET";
  const send = () => fetch(`${origin}/api/${path}`, { method, headers, body: body && JSON.stringify(body) });
  // A server that is asked too much closes the connection.
  const answer = await send().catch(() => pause(100).then(send));
  return path === "items" ? answer.arrayBuffer() : answer.json();
}

async function current(served, after = 0) {
  for (;;) {
    const state = await ask(served, "state");
    if (state.version > after) return state;
    await pause(1);
  }
}

/** From the start of the command to its first state with all items, without a browser. */
async function firstItems(path, n_times) {
  const times = [];
  for (let i = 0; i < n_times; i++) {
    const start = now();
    const served = await serveFile(path);
    const state = await current(served);
    await ask(served, "items", { items: state.items.map(({ key }) => key) });
    times.push(now() - start);
    served.end();
  }
  return times;
}

/** From the start of the command to the first picture in a browser that is open already. */
async function firstPicture(path, n_times) {
  const [whole, alone] = [[], []];
  for (let i = 0; i < n_times; i++) {
    const start = now();
    const served = await serveFile(path);
    const page = await openPage(served.url);
    const { at, own } = await page.evaluate(() => ({ at: performance.timeOrigin + window.virote.firstPicture, own: window.virote.firstPicture }));
    whole.push(at - start);
    alone.push(own);
    await page.close();
    served.end();
  }
  return { whole, alone };
}

/** Times from a save to the buffers in the scene and to the drawn frame. */
async function saves(path, changes) {
  const served = await serveFile(path);
  const page = await openPage(served.url);
  await page.bringToFront();
  await page.evaluate(() => (window.virote.isTimed = true));
  const text = readFileSync(path, "utf8");
  const found = { event: [], scene: [], drawn: [], evaluate: [], mesh: [], bytes: [] };
  for (const change of changes) {
    const next = change(text);
    if (next === text) throw new Error("the change changes nothing");
    await pause(700);
    const version = await page.evaluate(() => window.virote.stateVersion);
    const start = now();
    replace(path, next);
    await page.waitForFunction((old) => window.virote.stateVersion > old && window.virote.times.drawn > window.virote.times.scene, { polling: 5 }, version);
    const times = await page.evaluate(() => window.virote.times);
    for (const name of ["event", "scene", "drawn"]) found[name].push(times[name] - start);
    const state = await ask(served, "state");
    if (!state.isCurrent) throw new Error(JSON.stringify(state.diagnostics));
    found.evaluate.push(state.milliseconds.evaluate);
    found.mesh.push(state.milliseconds.mesh);
  }
  writeFileSync(path, text);
  await page.close();
  served.end();
  return found;
}

function tellSaves(name, goal, found) {
  tell(`${name}: save to the buffers in the scene`, goal, spread(found.scene));
  tell(`${name}: save to the drawn frame`, goal, spread(found.drawn));
  tell(`${name}: of it until the page is told`, "", `${spread(found.event)}; evaluated in ${spread(found.evaluate)}, meshed in ${spread(found.mesh)}`);
}

const measures = {
  async sizes() {
    const sizeOf = (name) => statSync(resolve(import.meta.dirname, "../dist", name)).size;
    const page = ["index.html", "begin.js.gz", "app.js.gz", "app.css.gz"].reduce((sum, name) => sum + sizeOf(name), 0);
    tell("the page, compressed", "1 MB", `${(page / 1e3).toFixed(0)} kB`);
    tell("the command", "", `${(statSync(command).size / 1e6).toFixed(2)} MB, ${(gzipSync(readFileSync(command)).length / 1e6).toFixed(2)} MB compressed`);
  },
  async first() {
    const path = example("first-steps.geo");
    tell("first-steps: start of the command to state and items", "300 ms", spread(await firstItems(path, 9)));
    const { whole, alone } = await firstPicture(path, 7);
    tell("first-steps: start of the command to the first frame, browser open", "300 ms", spread(whole));
    tell("first-steps: of it the page", "", spread(alone));
  },
  async bottle() {
    const changes = Array.from({ length: 11 }, (_, i) => (text) => text.replace("param body   = 34mm", `param body   = ${34.1 + i / 10}mm`));
    tellSaves("bottle", "50 ms", await saves(example("bottle.geo"), changes));
  },
  async teapot() {
    const changes = Array.from({ length: 9 }, (_, i) => (text) => text.replace("= 0.2mm in", `= 0.2${i + 1}mm in`));
    tellSaves("teapot", "150 ms", await saves(example("teapot.geo"), changes));
  },
  async drag() {
    const served = await serveFile(example("bottle.geo"));
    // Without a picture: what the evaluation can do.
    await current(served);
    const start = now();
    let n_states = 0;
    for (; now() - start < 4000; n_states++) {
      const { version } = await ask(served, "state");
      await ask(served, "set", { values: { body: `${30 + ((n_states * 0.01) % 10)}mm` } });
      await current(served, version);
    }
    tell("bottle: values set one after another, without a browser", "30/s", `${(n_states / ((now() - start) / 1000)).toFixed(1)}/s`);
    const page = await openPage(served.url);
    await page.bringToFront();
    const count = await page.evaluate(async () => {
      const track = document.querySelector('[data-parameter="body"] input[type=range]');
      const versions = new Set();
      const [least, most] = [Number(track.min), Number(track.max)];
      const begin = performance.now();
      const frames = window.virote.n_frames;
      for (let share = 0; performance.now() - begin < 5000; share = (share + 0.01) % 1) {
        track.valueAsNumber = least + share * (most - least);
        track.dispatchEvent(new Event("input", { bubbles: true }));
        await new Promise((done) => setTimeout(done, 4));
        versions.add(window.virote.stateVersion);
      }
      const time = (performance.now() - begin) / 1000;
      return { updates: versions.size / time, frames: (window.virote.n_frames - frames) / time };
    });
    tell("bottle: a slider dragged in the page, pictures shown", "30/s", `${count.updates.toFixed(1)}/s (${count.frames.toFixed(1)} frames/s)`);
    await page.close();
    served.end();
  },
  async million() {
    const path = join(folder, "million.geo");
    writeFileSync(path, MILLION);
    const start = now();
    const served = await serveFile(path);
    const state = await current(served);
    const told = now() - start;
    const bytes = await ask(served, "items", { items: state.items.map(({ key }) => key) });
    const sent = now() - start;
    const n_triangles = state.items.reduce((sum, { facts }) => sum + (facts.triangles ?? 0), 0);
    tell("a million triangles: start to state", "", `${ms(told)}, of it evaluated in ${ms(state.milliseconds.evaluate)}, meshed in ${ms(state.milliseconds.mesh)}`);
    tell("a million triangles: start to all bytes", "1500 ms", `${ms(sent)} for ${n_triangles} triangles`);
    tell("a million triangles: bytes of each", "100", (bytes.byteLength / n_triangles).toFixed(1));
    served.end();
    const begin = now();
    const again = await serveFile(path);
    const page = await openPage(again.url);
    const { at, times } = await page.evaluate(() => ({ at: performance.timeOrigin + window.virote.firstPicture, times: window.virote.times }));
    tell("a million triangles: start to the first frame, browser open", "1500 ms", `${ms(at - begin)}; state ${ms(times.state - begin)}, buffers ${ms(times.buffers - begin)}, scene ${ms(times.scene - begin)}`);
    const turn = await page.evaluate(async () => {
      window.virote.isTimed = true;
      const begin = performance.now();
      for (let i = 0; i < 10; i++) {
        window.virote.look({ azimuth: i });
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      }
      return (performance.now() - begin) / 10;
    });
    tell("a million triangles: a frame while it turns, drawn by the processor", "", ms(turn));
    await page.close();
    again.end();
  },
  async memory() {
    const path = join(folder, "small.geo");
    const text = (i) => `param r = 5 in 1..20000\nsurface ball = sphere((0, 0, 0), r)\ncurve c = circle((0, 0), r + ${i})\nprint r\n`;
    writeFileSync(path, text(0));
    const served = await serveFile(path);
    await current(served);
    const resident = () => Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${served.process.pid}/status`, "utf8"))[1]) / 1024;
    const found = [];
    const start = now();
    for (let i = 0; i <= 10_000; i++) {
      if (i % 1000 === 0) found.push(resident().toFixed(1));
      const { version } = await ask(served, "state");
      // Most edits set the parameter; every tenth saves the script.
      if (i % 10 === 9) writeFileSync(path, text(i));
      else await ask(served, "set", { values: { r: `${1 + i}` } });
      await current(served, version);
    }
    tell("memory at each thousand of 10,000 edits", "level", `${found.join(", ")} MB; ${((now() - start) / 10_000).toFixed(1)} ms an edit`);
    served.end();
  },
};

/** A torus of 1000 by 500 cells. */
const MILLION = `geo 1
unit mm
mesh fine = grid_mesh(torus((0, 0, 0), 30, 10), 1000, 500)
`;

const wanted = process.argv.slice(2);
try {
  await openBrowser();
  for (const [name, measure] of Object.entries(measures)) if (wanted.length === 0 || wanted.includes(name)) await measure();
} finally {
  await closeBrowser();
  rmSync(folder, { recursive: true, force: true });
}
