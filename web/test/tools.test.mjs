// Snapping, combs and isocurves, narrow windows, and parameters of imported files, by closed forms.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { closeBrowser, lookFromFront, newPage, openBrowser, serve, skip, until } from "./harness.mjs";

const SCRIPT = `geo 1
unit mm
import "part.geo" as part with (size = width)
param width = 10mm in 5mm..20mm
curve ring = circle((10, 0, 0), 10, normal = (0, 1, 0))
curve stem = line((-20, 0, 1/3), (-20, 0, 10))
surface plate = bilinear((-15, 0, -18), (-15, 0, -8), (15, 0, -18), (15, 0, -8))
mesh tile = tessellate(bilinear((-18, 0, 2), (-18, 0, 18), (-2, 0, 2), (-2, 0, 18)))
curves comb = [for i in 0..1000: line((2 + i / 100, 0, 14), (2 + i / 100, 0, 18))]
`;

let served;
let page;
before(async () => {
  if (skip) return;
  await openBrowser();
  served = await serve(SCRIPT);
  page = await newPage();
  await page.goto(served.url);
}, { timeout: 300_000 });
after(async () => {
  served?.end();
  await closeBrowser();
});

const run = (name, body) => test(name, { skip, timeout: 180_000 }, body);
const pixel = (point) => page.evaluate((place) => window.virote.pixel(place), point);
const hit = () => page.evaluate(() => window.virote.hit);

run("the parameters of a script that begins with an error are there, and those of its imports once they can be read", async () => {
  await until(page, () => document.querySelector('[data-parameter="width"]'));
  assert.match(await page.$eval(".diagnostics", (list) => list.textContent), /part\.geo/);
  writeFileSync(join(served.folder, "part.geo"), 'param size = 3mm in 1mm..30mm "How large"\nparam depth = 2mm\nsurface face = bilinear((0, 0), (0, size), (size, 0), (size, depth))\n');
  await until(page, () => document.querySelector('[data-imported="size"]') && window.virote.isReady && window.virote.isCurrent);
  const rows = await page.$$eval(".imported", (all) => all.map((row) => row.textContent));
  assert.deepEqual(rows, ["How largewidthby width, line 3", "depth2mmits default"]);
});

run("a click near an end, a corner or a vertex is answered there, and not beside it", async () => {
  await lookFromFront(page, 50);
  await page.keyboard.press("o");
  const clickBeside = async ([x, y, z], gap = 5, down = -gap) => {
    const [px, py] = await pixel([x, y, z]);
    await page.mouse.move(px + gap, py + down);
    // What the click would be drawn to is shown before.
    await until(page, (sx, sy) => {
      const square = document.querySelector(".lure")?.getBoundingClientRect();
      return square && Math.hypot((square.left + square.right) / 2 - sx, (square.top + square.bottom) / 2 - sy) < 1;
    }, px, py);
    await page.mouse.click(px + gap, py + down);
    await until(page, () => window.virote.hit?.answer);
    const { snapped, answer } = await hit();
    return [snapped, answer.point];
  };
  assert.deepEqual(await clickBeside([-20, 0, 1 / 3]), ["end", [-20, 0, 1 / 3]]);
  assert.match(await page.$eval(".place", (facts) => facts.textContent), /Snapped toend/);
  assert.deepEqual(await clickBeside([15, 0, -8], -5), ["corner", [15, 0, -8]]);
  assert.deepEqual(await clickBeside([-18, 0, 18], 5, 5), ["vertex", [-18, 0, 18]]);
  // Beside the mesh, too.
  assert.deepEqual(await clickBeside([-18, 0, 18], -5, -5), ["vertex", [-18, 0, 18]]);
  // The curves of a long list have ends, of which the kernel is not asked.
  const [ex, ey] = await pixel([2, 0, 18]);
  await page.mouse.click(ex - 4, ey - 3);
  await until(page, () => window.virote.hit?.path === "comb");
  const { snapped, point, parameters } = await hit();
  assert.deepEqual([snapped, point.map((value) => Math.round(1e4 * value) / 1e4), parameters], ["end", [2, 0, 18], null]);
  // The distance of two ends is exact.
  await page.keyboard.press("m");
  await clickBeside([-20, 0, 1 / 3]);
  await clickBeside([-15, 0, -18], 4);
  await until(page, () => window.virote.marks.length === 2 && window.virote.marks.every((mark) => mark.answer));
  const [a, b] = (await page.evaluate(() => window.virote.marks)).map((mark) => mark.answer.point);
  assert.equal(Math.hypot(...a.map((value, k) => value - b[k])), Math.hypot(5, 0, 18 + 1 / 3));
  await page.keyboard.press("m");
  await page.keyboard.press("Escape");
  // Switched off, the place is the one that was clicked.
  await page.click('[data-command="snap"]');
  const [px, py] = await pixel([-10, 0, -8]);
  await page.mouse.click(px, py + 30);
  await until(page, () => window.virote.hit?.path === "plate");
  assert.equal((await hit()).snapped ?? null, null);
  await page.click('[data-command="snap"]');
});

run("combs have a scale, and are of all or of the selection", async () => {
  await page.keyboard.press("Escape");
  await page.click('[data-command="combs"]');
  await until(page, () => !document.querySelector(".comb-scale").hidden);
  const scale = () => page.$eval(".comb-scale", (part) => [part.textContent, part.querySelector(".scale-line").getBoundingClientRect().width]);
  const [text, width] = await scale();
  const [, tooth, radius] = /^1 tooth = (\S+) \/mm \(radius (\S+) mm\)$/.exec(text);
  assert.ok(Math.abs(Number(tooth) * Number(radius) - 1) < 1e-3, text);
  // The longest tooth, of the circle of radius 10, is 0.12 of the model's size.
  const [left, right] = [await pixel([0, 0, 0]), await pixel([1, 0, 0])];
  const size = Math.hypot(20 + 20, 0, 18 + 18);
  const expected = (Number(tooth) / 0.1) * 0.12 * size * (right[0] - left[0]);
  assert.ok(Math.abs(width - expected) < 1, `${width} and ${expected}`);
  await page.click('[data-setting="combs-of"] [data-value="selection"]');
  await until(page, () => document.querySelector(".comb-scale").hidden && !document.querySelector(".combs-told").hidden);
  await page.click('.tree-row[data-path="ring"] .name');
  await until(page, () => !document.querySelector(".comb-scale").hidden);
  await page.click('[data-setting="combs-of"] [data-value="all"]');
  await page.click('[data-command="combs"]');
});

run("isocurves are as many as are wanted", async () => {
  const lines = () => page.evaluate(() => window.virote.items.find((item) => item.path === "plate").isocurves);
  assert.equal(await lines(), 2 * 7);
  const put = (n) => page.$eval('[data-setting="isocurve-count"] input', (input, value) => {
    input.valueAsNumber = value;
    input.dispatchEvent(new Event("input"));
  }, n);
  await put(20);
  await until(page, () => window.virote.items.find((item) => item.path === "plate").isocurves === 2 * 20);
  await put(7);
  await until(page, () => window.virote.items.find((item) => item.path === "plate").isocurves === 2 * 7);
});

run("in a narrow window every tool is in the bar or in its menu", async () => {
  const all = await page.$$eval(".bar [data-command]", (tools) => tools.map((tool) => tool.dataset.command));
  for (const width of [880, 480]) {
    await page.setViewport({ width, height: 700 });
    await page.click(".menu.more > summary");
    await until(page, () => document.querySelector(".menu.more").open);
    const seen = await page.$$eval(".bar [data-command], .bar [data-more]", (tools) => tools.filter((tool) => {
      const { left, right, width: w } = tool.getBoundingClientRect();
      return w > 0 && left >= 0 && right <= innerWidth;
    }).map((tool) => tool.dataset.command ?? tool.dataset.more));
    const missing = all.filter((name) => !name.startsWith("view-") && !seen.includes(name));
    assert.deepEqual(missing, [], `at ${width}`);
    await page.click('[data-more="knots"]');
    assert.equal(await page.evaluate(() => window.virote.settings.knots), width === 880);
    await page.mouse.click(width / 2, 500);
    await until(page, () => !document.querySelector(".menu.more").open);
  }
  assert.deepEqual(page.faults, []);
});
