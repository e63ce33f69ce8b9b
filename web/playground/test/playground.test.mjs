// The playground in a headless browser: a plain web server, no command behind it. What it evaluates and
// exports is compared with closed forms and with the command in VIROTE.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { inflateRawSync } from "node:zlib";

import { closeBrowser, colorAt, command, lookFromFront, openBrowser, openPage, skip, until } from "../../test/harness.mjs";
import { WALKS } from "../../wasm/test/walks.mjs";
import { folder, serveFolder } from "./harness.mjs";

const SCRIPT = `geo 1
unit mm
param size = 10mm in 5mm..20mm step 1mm "Radius <b>of</b> <img src=x onerror=alert(1)>"
/// The <img src=x onerror=alert(2)> ball.
surface ball = sphere((0, 0, 0), size)
check size < 15mm "the <i>ball</i> is small"
print "<img src=x onerror=alert(3)>"
`;
const FRONT = [3, -10, 4];

let served;
let page;
const downloads = mkdtempSync(join(tmpdir(), "virote-downloads-"));
before(async () => {
  if (skip) return;
  await openBrowser();
  served = await serveFolder();
  page = await openPage(served.url, { width: 1440, height: 860 });
}, { timeout: 180_000 });
after(async () => {
  await closeBrowser();
  served?.end();
  rmSync(downloads, { recursive: true });
});
const run = (name, body) => test(name, { skip, timeout: 180_000 }, body);

/** Waits until the newest text is evaluated and drawn. */
const settled = (of = page) => until(of, () => window.playground?.isBusy === false && window.virote.isReady);
const face = (of = page) => of.evaluate(() => window.playground);
/** Puts a text in the place of the script, as if it were pasted. */
async function write(text, of = page) {
  await of.focus(".cm-content");
  await of.keyboard.down("Control");
  await of.keyboard.press("a");
  await of.keyboard.up("Control");
  await of.keyboard.sendCharacter(text);
  await until(of, (wanted) => window.playground?.text === wanted, text);
}
/** Where the first word of the script stands in the window that is this one. */
async function place(word) {
  const found = await page.waitForFunction((wanted) => [...document.querySelectorAll(".cm-content [class^=word-]")].find((one) => one.textContent === wanted), {}, word);
  const { x, y, width, height } = await found.boundingBox();
  return [x + width / 2, y + height / 2];
}
/** Does something in every worker; what it does may end the worker before it answers. */
const inWorkers = (what) => Promise.all(page.workers().map((worker) => worker.evaluate(what).catch(() => {})));
const shared = (url) => JSON.parse(inflateRawSync(Buffer.from(new URL(url).hash.slice("#script=".length), "base64url")));
const said = (selector) => page.$eval(selector, (element) => element.textContent);

test("the module is at most 3 MB as it is sent", () => {
  assert.ok(statSync(join(folder, "virote.wasm.gz")).size <= 3_000_000);
});

run("the first visit shows an example, evaluated", async () => {
  assert.equal((await face()).name, "bottle.geo");
  assert.equal((await face()).text, readFileSync(join(import.meta.dirname, "../../../examples/bottle.geo"), "utf8"));
  assert.ok((await page.$$(".claim.pass")).length > 5);
});

run("what is typed is drawn where it should be", async () => {
  await write(SCRIPT);
  await settled();
  await lookFromFront(page);
  assert.equal((await colorAt(page, [0, -10, 0]))[3], 255, "the ball");
  await page.keyboard.press("F6");
  await page.keyboard.press("r");
  assert.equal((await colorAt(page, [0, 0, 17.5]))[3], 0, "beside it, without the grid");
  await page.keyboard.press("r");
  assert.ok(await page.$(".word-keyword"), "the words are coloured");
});

run("a dragged parameter changes the model, and the address keeps its value", async () => {
  const { key, camera } = await page.evaluate(() => ({ key: window.virote.items[0].key, camera: window.virote.camera }));
  const track = await page.$('[data-parameter="size"] input[type=range]');
  const { x, y, width, height } = await track.boundingBox();
  await page.mouse.move(x + width / 3, y + height / 2);
  await page.mouse.down();
  for (const part of [0.4, 0.5, 0.6, 0.75]) await page.mouse.move(x + width * part, y + height / 2);
  await page.mouse.up();
  await until(page, (old) => window.virote.items[0]?.key !== old && document.querySelector('[data-parameter="size"]').classList.contains("is-set"), key);
  await settled();
  assert.deepEqual(await page.evaluate(() => window.virote.camera), camera);
  const value = await page.$eval('[data-parameter="size"] .value', (field) => field.value);
  const radius = Number.parseFloat(value);
  assert.ok(radius > 10, value);
  await until(page, () => document.querySelector(".claim")?.classList.contains("fail") === (Number.parseFloat(document.querySelector('[data-parameter="size"] .value').value) >= 15));
  // The address is written a little after the last change; the last change may come late.
  for (let look = 0; look < 50 && shared(page.url()).values?.size !== value; look++) {
    await new Promise((done) => setTimeout(done, 100));
  }
  assert.deepEqual(shared(page.url()).values, { size: value });
});

run("a link opens the same script with the same values elsewhere", async () => {
  await page.click('[data-do="share"]');
  await until(page, () => !document.querySelector(".toast").hidden);
  const other = await openPage(page.url(), { width: 900, height: 700 });
  await settled(other);
  assert.equal((await face(other)).text, SCRIPT);
  assert.equal(await other.$eval('[data-parameter="size"] .value', (field) => field.value), shared(page.url()).values.size);
  assert.deepEqual(other.faults, []);
  await other.close();
});

run("a link that is damaged is told of, and nothing is lost", async () => {
  const other = await openPage(`${served.url}#script=AAAA`);
  await until(other, () => /link is damaged/.test(document.querySelector(".toast").textContent));
  await settled(other);
  assert.equal((await face(other)).text, SCRIPT, "the script that was open last");
  await other.close();
});

run("values are written into the script, as an edit that can be undone", async () => {
  const value = await page.$eval('[data-parameter="size"] .value', (field) => field.value);
  await page.click('[data-do="write"]');
  await until(page, (wanted) => window.playground.text.includes(`param size = ${wanted} in`), value);
  await settled();
  await until(page, () => !document.querySelector(".parameter.is-set"));
  await page.focus(".cm-content");
  await page.keyboard.down("Control");
  await page.keyboard.press("z");
  await page.keyboard.up("Control");
  await until(page, (text) => window.playground.text === text, SCRIPT);
  await settled();
});

run("texts of a script never become markup", async () => {
  const [x, y] = await place("ball");
  await page.mouse.move(x, y);
  await until(page, () => document.querySelector(".cm-tooltip-hover .help-text"));
  assert.match(await said(".cm-tooltip-hover"), /<img src=x onerror=alert\(2\)>/);
  assert.match(await said(".cm-tooltip-hover"), /ball/);
  assert.match(await said('[data-parameter="size"] .parameter-label'), /<b>of<\/b>/);
  assert.match(await said(".print"), /<img src=x/);
  // The editor puts pictures without a source around its notes.
  assert.equal(await page.$("img:not(.cm-widgetBuffer), img[src], .cm-content :is(b, i)"), null);
  await page.mouse.move(2, 400);
});

run("a mistake is told at its place, the last model stays, and a fix mends it", async () => {
  await write(SCRIPT.replace("sphere((0, 0, 0), size)", "sphere((0, 0, 0), sise)"));
  await until(page, () => document.querySelector(".cm-lintRange-error") && !window.virote.isCurrent);
  assert.equal(await said(".cm-lintRange-error"), "sise");
  assert.match(await said(".diagnostics"), /E0201/);
  assert.equal((await page.evaluate(() => window.virote.items)).length, 1);
  await page.hover(".cm-lintRange-error");
  await until(page, () => document.querySelector(".cm-diagnosticAction"));
  await page.click(".cm-diagnosticAction");
  await until(page, (text) => window.playground.text === text, SCRIPT);
  await until(page, () => window.virote.isCurrent && document.querySelector(".diagnostics").hidden);
  await settled();
});

run("completion offers what fits, with places to fill in", async () => {
  await write(`${SCRIPT}surface more = `);
  await page.keyboard.type("cyl", { delay: 30 });
  await until(page, () => document.querySelector("li[aria-selected] .cm-completionLabel")?.textContent === "cylinder" && document.querySelector(".cm-completionMatchedText")?.textContent === "cyl");
  await settled();
  // A list that has only just come takes no key.
  await page.evaluate(() => new Promise((done) => setTimeout(done, 300)));
  await page.keyboard.press("Enter");
  await until(page, () => /surface more = cylinder\(\w+/.test(window.playground.text));
  await until(page, () => document.querySelector(".cm-tooltip.signature b"));
  await write(SCRIPT);
  await settled();
});

run("a script is brought into its usual form", async () => {
  await write("geo 1\nlet   a=1+2\nprint a\n");
  await page.click('[data-do="format"]');
  await until(page, () => window.playground.text === "geo 1\nlet a = 1 + 2\nprint a\n");
  await settled();
  assert.match(await said(".print"), /3/);
  assert.equal(await said(".cm-line .note-print"), "3");
});

const ENDLESS = "geo 1\nlet a = sum([for i in 1..1000000: sum([for j in 1..1000: i * j])])\n";

run("an evaluation without end is stopped, and the model before it stays", async () => {
  await write(SCRIPT);
  await settled();
  const { n_begun } = await face();
  await write(SCRIPT + ENDLESS.slice(6));
  await page.waitForSelector(".status[data-kind=busy] .stop:not([hidden])", { timeout: 30_000 });
  // The editor helps meanwhile.
  const [x, y] = await place("sphere");
  await page.mouse.move(x, y);
  await until(page, () => /sphere/.test(document.querySelector(".cm-tooltip-hover .help-text")?.textContent ?? ""));
  assert.ok((await face()).isBusy, "it is still evaluating");
  await page.mouse.move(2, 400);
  await page.click(".status .stop");
  await until(page, () => /was stopped/.test(document.querySelector(".diagnostics").textContent));
  await settled();
  assert.equal((await page.evaluate(() => window.virote.items)).length, 1);
  assert.equal((await colorAt(page, FRONT))[3], 255);
  assert.equal((await face()).n_begun, n_begun + 1);
  assert.equal(await page.evaluate(() => window.virote.isCurrent), false);
});

run("a newer text ends an evaluation that takes long", async () => {
  await write(`${SCRIPT}${ENDLESS.slice(6)}// another`);
  await page.waitForSelector(".status[data-kind=busy]", { timeout: 30_000 });
  await write(SCRIPT);
  await settled();
  assert.ok(await page.evaluate(() => window.virote.isCurrent));
});

run("a worker that dies is begun anew, and the person is told", async () => {
  const { n_begun } = await face();
  await inWorkers(() => void setTimeout(() => { throw new Error("out of memory"); }, 50));
  await until(page, (n) => window.playground.n_begun > n && !window.playground.isBusy && window.virote.isCurrent, n_begun);
  assert.match(await said(".toast"), /out of memory.*begun anew/);
  await settled();
  // In the middle of a run, as a stack that overflows.
  await inWorkers(() => {
    self.onmessage = () => { throw new RangeError("Maximum call stack size exceeded"); };
  });
  await write(`${SCRIPT}print 1\n`);
  await until(page, () => /broke off: .*call stack/.test(document.querySelector(".diagnostics").textContent));
  await settled();
  assert.equal((await colorAt(page, FRONT))[3], 255, "the last model");
  await write(`${SCRIPT}print 2\n`);
  await settled();
  assert.ok(await page.evaluate(() => window.virote.isCurrent));
});

run("scripts that nest too deep are refused, and the worker lives on", async () => {
  // At the ceilings, where the stack is deepest, and far beyond.
  const texts = Object.values(WALKS).flatMap((script) => [120, 190, 245, 3_000].map(script));
  const answers = await page.evaluate(async (all) => {
    const body = (await fetch("virote.wasm.gz")).body.pipeThrough(new DecompressionStream("gzip"));
    const module = await WebAssembly.compileStreaming(new Response(body, { headers: { "Content-Type": "application/wasm" } }));
    const worker = new Worker("worker.js");
    worker.postMessage({ module, process: 99 });
    const found = [];
    for (const text of all) {
      worker.postMessage({ id: 0, head: { call: "text", text }, parts: [] });
      const { fault, value } = await new Promise((done) => (worker.onmessage = ({ data }) => done(data)));
      found.push(fault ?? value.diagnostics.map(({ code }) => code).join());
    }
    worker.terminate();
    return found;
  }, texts);
  answers.forEach((answer, i) => assert.match(answer, i % 4 < 3 ? /^(E\d+(,E\d+)*)?$/ : /^E\d+/, texts[i].slice(0, 60)));
});

/** The bytes of the next file that is downloaded. */
async function download(click) {
  for (const name of readdirSync(downloads)) rmSync(join(downloads, name));
  const session = await page.createCDPSession();
  await session.send("Page.setDownloadBehavior", { behavior: "allow", downloadPath: downloads });
  await click();
  for (let i = 0; i < 300; i++) {
    const [name] = readdirSync(downloads).filter((one) => !one.endsWith(".crdownload"));
    if (name) return [name, readFileSync(join(downloads, name))];
    await new Promise((done) => setTimeout(done, 100));
  }
  throw new Error("nothing was downloaded");
}

/** What the command writes for a script, by path. */
function written(text) {
  const folder = mkdtempSync(join(tmpdir(), "virote-native-"));
  writeFileSync(join(folder, "model.geo"), text);
  const native = spawnSync(command, ["run", "model.geo", "--out", "out"], { cwd: folder, encoding: "utf8" });
  assert.equal(native.status, 0, native.stderr);
  const files = Object.fromEntries(readdirSync(join(folder, "out")).map((name) => [name, readFileSync(join(folder, "out", name))]));
  rmSync(folder, { recursive: true });
  return files;
}

run("downloaded files are those of the command, to the byte", async () => {
  const one = `${SCRIPT}export ball to "ball.step"\n`;
  await write(one);
  await settled();
  const button = () => page.evaluate(() => [...document.querySelectorAll("button")].find((each) => each.textContent === "Download the exports").click());
  const [name, bytes] = await download(button);
  assert.equal(name, "ball.step");
  assert.ok(bytes.equals(written(one)["ball.step"]), "one file");
  const two = `${one}export ball to "ball.stl"\n`;
  await write(two);
  await settled();
  const [archive] = await download(button);
  assert.match(archive, /\.zip$/);
  const out = mkdtempSync(join(tmpdir(), "virote-zip-"));
  const unpacked = spawnSync("python3", ["-m", "zipfile", "-e", join(downloads, archive), out], { encoding: "utf8" });
  assert.equal(unpacked.status, 0, unpacked.stderr);
  for (const [path, native] of Object.entries(written(two))) assert.ok(native.equals(readFileSync(join(out, path))), path);
  rmSync(out, { recursive: true });
});

run("dropped data are read, and kept for the next visit", async () => {
  await write('geo 1\nlet rows = load("points.csv")\nprint len(rows)\n');
  await until(page, () => document.querySelector(".cm-lintRange-error"));
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File(["x,y\n1,2\n3,4\n5,6\n"], "points.csv"));
    document.querySelector(".cm-content").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  });
  await until(page, () => window.virote?.isCurrent && document.querySelector(".print-value")?.textContent === "3");
  await settled();
  await page.evaluate(() => new Promise((done) => setTimeout(done, 600)));
  const fragment = new URL(page.url()).hash;
  await page.goto(served.url);
  await until(page, () => window.virote?.isReady && document.querySelector(".print-value")?.textContent === "3");
  assert.match((await face()).text, /points\.csv/, "the script that was open last");
  // A link that is shared carries them; in another profile nothing else is there.
  await page.click('[data-do="share"]');
  await until(page, () => !document.querySelector(".toast").hidden);
  assert.ok(fragment.length < 400);
  await page.click('[data-menu="files"] summary');
  await page.waitForSelector('[data-file="points.csv"]');
  await page.click('[data-do="new"]');
  await settled();
  assert.equal((await face()).text, "geo 1\nunit mm\n\n");
});

run("an example with its data opens from the gallery", async () => {
  await page.click('[data-do="examples"]');
  await page.keyboard.press("Escape");
  await until(page, () => !document.querySelector("dialog.gallery"));
  await page.click('[data-do="examples"]');
  await page.click('[data-example="teapot.geo"]');
  await settled();
  assert.equal((await face()).name, "teapot.geo");
  assert.ok(await page.evaluate(() => window.virote.isCurrent && window.virote.items.length > 0));
  // The camera goes to each: the road is as many metres long as the teapot millimetres.
  const { height } = await page.evaluate(() => window.virote.camera);
  await page.click('[data-do="examples"]');
  await page.click('[data-example="road.geo"]');
  await settled();
  assert.ok((await page.evaluate(() => window.virote.camera)).height > height, "it has gone back");
  const [x] = await page.evaluate(() => window.virote.pixel(window.virote.camera.target));
  const { left, right } = await page.$eval(".canvas", (canvas) => canvas.getBoundingClientRect().toJSON());
  assert.ok(left < x && x < right);
  await page.goto(`${served.url}#example=circles.geo`);
  await until(page, () => window.playground?.name === "circles.geo");
  await settled();
});

run("scripts of the book open in the playground, and say what the book says", async () => {
  await page.goto(`${served.url}book/reference.html`);
  const index = await page.$$eval(".script", (all) => all.findIndex((one) => one.nextElementSibling?.textContent.trim() === "(8, 64, 0)"));
  assert.ok(index > 0 && (await page.$$(".script .word-built-in")).length > 100);
  await page.evaluate((i) => document.querySelectorAll(".script > a")[i].click(), index);
  await until(page, () => window.playground && window.virote?.isReady && document.querySelector(".print-value")?.textContent === "(8, 64, 0)");
  assert.equal((await face()).name, "approximate-2.geo");
});

run("an interpreter that cannot be loaded is told of", async () => {
  const other = await openPage(served.url);
  await other.setRequestInterception(true);
  other.on("request", (request) => (request.url().endsWith(".wasm.gz") ? request.respond({ status: 404 }) : request.continue()));
  await other.goto(`${served.url}?again`);
  await until(other, () => /virote\.wasm\.gz: 404/.test(document.querySelector(".broken")?.textContent ?? ""));
  await other.close();
});

run("a window that becomes small shows script and model, uncovered, and both panels again when it is large", async () => {
  const shown = () => page.evaluate(() => ({
    isWithin: document.documentElement.scrollWidth <= innerWidth,
    boxes: [".cm-editor", ".canvas"].map((name) => document.querySelector(name).getBoundingClientRect()).map(({ width, height }) => width > 250 && height > 150),
    panels: [...document.querySelectorAll(".panel")].map((panel) => !panel.hidden),
  }));
  const before = (await shown()).panels;
  for (const [width, height] of [[800, 600], [480, 800], [360, 640]]) {
    await page.setViewport({ width, height });
    await until(page, () => [...document.querySelectorAll(".panel")].every((panel) => panel.hidden));
    assert.deepEqual(await shown(), { isWithin: true, boxes: [true, true], panels: [false, false] }, `at ${width}`);
  }
  await page.setViewport({ width: 1440, height: 860 });
  await until(page, (wanted) => [...document.querySelectorAll(".panel")].every((panel, i) => !panel.hidden === wanted[i]), before);
});

run("the border moves by keys, and the theme turns both sides", async () => {
  const width = () => page.$eval(".editor", (element) => element.getBoundingClientRect().width);
  const before = await width();
  await page.focus(".split-border");
  for (let i = 0; i < 3; i++) await page.keyboard.press("ArrowRight");
  assert.ok((await width()) > before + 40);
  await page.focus(".canvas");
  await page.keyboard.press("t");
  const ground = await page.$eval(".cm-editor", (element) => getComputedStyle(element).backgroundColor);
  assert.equal(ground, "rgb(31, 36, 44)");
  await page.keyboard.press("t");
  assert.deepEqual(page.faults, []);
});
