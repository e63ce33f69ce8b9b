// What is seen, as a file and by keys: the PNG with its marks, legends, moving model and section plane from the keyboard.

import assert from "node:assert/strict";
import { mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { closeBrowser, colorAt, lookFromFront, newPage, openBrowser, openPage, serve, skip, until } from "./harness.mjs";

const SCRIPT = `geo 1
unit mm
surface ball = sphere((0, 0, 0), 10)
point top = (0, -10, 0)
check top.z > 1 "it is high"
`;

let served;
let page;
const downloads = mkdtempSync(join(tmpdir(), "virote-picture-"));
before(async () => {
  if (skip) return;
  await openBrowser();
  served = await serve(SCRIPT);
  page = await openPage(served.url);
  const session = await page.createCDPSession();
  await session.send("Page.setDownloadBehavior", { behavior: "allow", downloadPath: downloads });
  await lookFromFront(page);
}, { timeout: 120_000 });
after(async () => {
  served?.end();
  await closeBrowser();
  rmSync(downloads, { recursive: true });
});

const run = (name, body) => test(name, { skip, timeout: 180_000 }, body);
const camera = () => page.evaluate(() => window.virote.camera);
const settings = () => page.evaluate(() => window.virote.settings);
async function shifted(key) {
  await page.keyboard.down("Shift");
  await page.keyboard.press(key);
  await page.keyboard.up("Shift");
}

/** Size of the picture that the page saves, and its colours at these places of the canvas. */
async function savedPicture(places) {
  await page.keyboard.press("s");
  let name;
  for (let i = 0; i < 300 && !name; i++) {
    await new Promise((done) => setTimeout(done, 100));
    name = readdirSync(downloads).find((one) => one.endsWith(".png"));
  }
  assert.equal(name, "model.png");
  const bytes = readFileSync(join(downloads, name)).toString("base64");
  rmSync(join(downloads, name));
  const reader = await newPage();
  const found = await reader.evaluate(async (text, wanted) => {
    const picture = await createImageBitmap(new Blob([Uint8Array.from(atob(text), (one) => one.charCodeAt(0))], { type: "image/png" }));
    const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
    context.drawImage(picture, 0, 0);
    return { size: [picture.width, picture.height], colors: wanted.map(([x, y]) => [...context.getImageData(Math.round(x), Math.round(y), 1, 1).data]) };
  }, bytes, places);
  await reader.close();
  await page.bringToFront();
  return found;
}

run("the PNG is what is seen, with the ring of a claim and the legend", async () => {
  // Blue, where the ring is red.
  await page.click('[data-shade="mean"]');
  await page.click(".claim.fail summary");
  await until(page, () => document.querySelector(".claim-ring") && window.virote.isSmooth);
  const frame = await page.$eval(".canvas", (canvas) => ["left", "top", "width", "height"].map((name) => canvas.getBoundingClientRect()[name]));
  const [x, y] = await page.evaluate(() => window.virote.pixel([4, -9, -4]));
  const [cx, cy] = await page.evaluate(() => window.virote.pixel([0, -10, 0]));
  const swatch = await page.$eval(".legend-bar", (bar) => [bar.getBoundingClientRect().left + 9, bar.getBoundingClientRect().bottom - 8]);
  const onCanvas = ([px, py]) => [px - frame[0], py - frame[1]];
  const ring = await page.$eval(".claim-ring", (one) => getComputedStyle(one).stroke.match(/\d+/g).map(Number));
  const { size, colors } = await savedPicture([onCanvas([x, y]), onCanvas([cx + 11, cy]), onCanvas(swatch)]);
  assert.deepEqual(size, frame.slice(2).map(Math.round));
  const seen = await page.evaluate((at) => window.virote.color(...at), [x, y]);
  const isLike = (a, b, by) => a.slice(0, 3).every((value, k) => Math.abs(value - b[k]) <= by);
  assert.ok(isLike(colors[0], seen, 6), `the model: ${colors[0]} and ${seen}`);
  assert.ok(isLike(colors[1], ring, 50), `the ring: ${colors[1]} and ${ring}`);
  assert.ok(colors[2][2] > colors[2][0] + 60, `the blue end of the legend: ${colors[2]}`);
  await page.keyboard.press("Escape");
  await page.click('[data-shade="plain"]');
});

run("each class of a legend has its colour beside its text", async () => {
  for (const [shade, n_classes] of [["draft", 3], ["sides", 2]]) {
    await page.click(`[data-shade="${shade}"]`);
    const boxes = await page.$$eval(".legend-class", (rows) => rows.map((row) => {
      const [whole, swatch] = [row, row.querySelector(".legend-swatch")].map((part) => part.getBoundingClientRect());
      return { width: swatch.width, isInside: swatch.left >= whole.left && swatch.right <= whole.right && swatch.top >= whole.top && swatch.bottom <= whole.bottom };
    }));
    assert.deepEqual(boxes, Array(n_classes).fill({ width: 12, isInside: true }), shade);
  }
  await page.click('[data-shade="plain"]');
});

run("arrows with Shift move the model by as many pixels as they say", async () => {
  const middle = () => page.evaluate(() => window.virote.pixel([0, 0, 0]));
  const before = await middle();
  for (const [key, dx, dy] of [["ArrowRight", 40, 0], ["ArrowUp", 0, -40], ["ArrowLeft", -40, 0], ["ArrowDown", 0, 40]]) {
    const from = await middle();
    await shifted(key);
    const to = await middle();
    assert.ok(Math.hypot(to[0] - from[0] - dx, to[1] - from[1] - dy) < 0.5, `${key}: ${from} to ${to}`);
  }
  const end = await middle();
  assert.ok(Math.hypot(end[0] - before[0], end[1] - before[1]) < 0.5);
  // Without it they turn.
  const { azimuth, target } = await camera();
  await page.keyboard.press("ArrowRight");
  assert.notEqual((await camera()).azimuth, azimuth);
  assert.deepEqual((await camera()).target, target);
  await lookFromFront(page);
});

run("keys move the section plane, turn it, and change its side", async () => {
  await page.keyboard.press(".");
  assert.equal((await settings()).sectionPlace, 0.5, "without a section they do nothing");
  await page.keyboard.press("r");
  await page.keyboard.press("x");
  assert.equal((await colorAt(page, [1, -9, 4]))[3], 0, "cut away");
  for (let i = 0; i < 5; i++) await page.keyboard.press(".");
  assert.ok(Math.abs((await settings()).sectionPlace - 0.6) < 1e-9);
  assert.equal((await colorAt(page, [1, -9, 4]))[3], 255, "a fifth of the ball's radius further it is there");
  await page.keyboard.press(";");
  assert.equal((await colorAt(page, [1, -9, 4]))[3], 0, "the other side");
  await page.keyboard.press(";");
  for (let i = 0; i < 60; i++) await page.keyboard.press(",");
  assert.equal((await settings()).sectionPlace, 0);
  for (const axis of ["y", "z", "free", "x"]) {
    await shifted("x");
    assert.equal((await settings()).sectionAxis, axis);
  }
  await page.keyboard.press("x");
  await page.keyboard.press("r");
});

run("the page had no fault in all this", () => assert.deepEqual(page.faults, []));
