// Measures the playground against what it is to reach, and prints a table: `node playground/test/figures.mjs [STARTS]`.
// It asserts nothing: figures depend on the machine and on who else works on it. PLAYGROUND names its folder
// (playground/dist without it), VIROTE the command that it is compared with, which should be a release build.

import { gunzipSync } from "node:zlib";
import { copyFileSync, mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

import { closeBrowser, newPage, openBrowser, serveFile } from "../../test/harness.mjs";
import { open } from "../../wasm/virote.mjs";
import { folder, serveFolder } from "./harness.mjs";

const examples = resolve(import.meta.dirname, "../../../examples");
const median = (all) => [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)];
const N_STARTS = Number(process.argv[2] ?? 7);
const N_RUNS = 5;
/** Shorter ones are mostly beginnings and ends. */
const LEAST = 5;

/** From a browser that has never seen the page to its first model, in milliseconds. */
async function coldStart(url) {
  await openBrowser();
  const page = await newPage();
  await page.goto(url);
  const { firstPicture } = await (await page.waitForFunction(() => window.virote?.firstPicture && { ...window.virote }, { timeout: 90_000 })).jsonValue();
  await closeBrowser();
  return firstPicture;
}

/** Milliseconds of the evaluation of an example in a module: the first, whose code is yet to be compiled, and the best. */
async function inModule(module, name, files) {
  const virote = await open(module, 7);
  const times = [];
  for (let i = 0; i < N_RUNS; i++) {
    virote.ask({ call: "reset", name });
    for (const [path, bytes] of files) virote.ask({ call: "file", path }, [bytes]);
    const { value } = virote.ask({ call: "text", text: files.get(name).toString() });
    // Another script in between, so that nothing of this one is remembered.
    virote.ask({ call: "text", text: "let other = 1" });
    if (value.definitions.reused > 0) throw new Error(`${name} is not evaluated anew`);
    if (value.diagnostics.some(({ severity }) => severity === "error")) return null;
    times.push(value.milliseconds.evaluate);
  }
  return { first: times[0], best: Math.min(...times) };
}

/** The best by the command on one thread, as it tells its page. */
async function byCommand(path) {
  const times = [];
  for (let i = 0; i < N_RUNS; i++) {
    const served = await serveFile(path, ["--threads", "1"]);
    const { origin, searchParams } = new URL(served.url);
    let state = { version: 0 };
    while (state.version === 0) {
      await new Promise((done) => setTimeout(done, 20));
      state = await (await fetch(`${origin}/api/state`, { headers: { "X-Virote-Token": searchParams.get("token") } })).json();
    }
    served.end();
    times.push(state.milliseconds.evaluate);
  }
  return Math.min(...times);
}

const served = await serveFolder();
const starts = [];
for (let i = 0; i < N_STARTS; i++) starts.push(await coldStart(served.url));
served.end();
console.log(`cold start of the page to its first model | 1500 ms | ${median(starts).toFixed(0)} ms (${Math.min(...starts).toFixed(0)} to ${Math.max(...starts).toFixed(0)} ms)`);

const module = new WebAssembly.Module(gunzipSync(readFileSync(join(folder, "virote.wasm.gz"))));
const scratch = mkdtempSync(join(tmpdir(), "virote-figures-"));
const files = new Map();
for (const entry of readdirSync(examples, { withFileTypes: true })) {
  if (!entry.isFile()) continue;
  files.set(entry.name, readFileSync(join(examples, entry.name)));
  copyFileSync(join(examples, entry.name), join(scratch, entry.name));
}
const ratios = [];
for (const name of [...files.keys()].filter((path) => path.endsWith(".geo")).sort()) {
  const native = await byCommand(join(scratch, name));
  const ours = native < LEAST ? null : await inModule(module, name, files);
  if (ours === null) continue;
  const ratio = ours.best / native;
  ratios.push(ratio);
  console.log(`${name} | 2.5 times | ${ours.best.toFixed(0)} ms, at first ${ours.first.toFixed(0)} ms, the command ${native.toFixed(0)} ms: ${ratio.toFixed(1)} times`);
}
rmSync(scratch, { recursive: true });
console.log(`${ratios.length} examples evaluated in the module, beside the command on one thread | 2.5 times | ${median(ratios).toFixed(1)} times (${Math.min(...ratios).toFixed(1)} to ${Math.max(...ratios).toFixed(1)})`);
