// Questions about meshes, claims, deviations and edges, by closed forms.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { closeBrowser, colorAt, lookFromFront, openBrowser, openPage, serve, skip, until } from "./harness.mjs";

const SCRIPT = `geo 1
unit mm
mesh box = tessellate(edge_shell)
let edge_shell = [
    bilinear((-20, 0, 0), (-20, 0, 10), (-10, 0, 0), (-10, 0, 10)),
    bilinear((-10, 0, 0), (-10, 0, 10), (0, 10, 0), (0, 10, 10)),
]
surface ball = sphere((15, 0, 5), 8)
surface core = sphere((15, 0, 5), 6)
point top = (15, 0, 13)
check top.z < 10   "not so high"
check deviation(ball, core).max < 1
check norm(top) < 1
check top.z == 13
`;

let served;
let page;
before(async () => {
  if (skip) return;
  await openBrowser();
  served = await serve(SCRIPT);
  page = await openPage(served.url);
  await lookFromFront(page, 50);
}, { timeout: 120_000 });
after(async () => {
  served?.end();
  await closeBrowser();
});

const run = (name, body) => test(name, { skip, timeout: 120_000 }, body);
const clickAt = async (point) => page.mouse.click(...(await page.evaluate((place) => window.virote.pixel(place), point)));

run("a click on a mesh tells its point, triangle and normal", async () => {
  await page.click('.tree-row[data-path="edge_shell"] .eye');
  await clickAt([-15, 0, 4]);
  await until(page, () => window.virote.hit?.path === "box");
  const hit = await page.evaluate(() => window.virote.hit);
  [-15, 0, 4].forEach((value, k) => assert.ok(Math.abs(hit.point[k] - value) < 0.05, String(hit.point)));
  assert.ok(Math.abs(Math.abs(hit.normal[1]) - 1) < 1e-6, "across the face");
  assert.equal(hit.parameters, null);
  const text = await page.$eval(".place", (element) => element.textContent);
  assert.match(text, /Normal of the triangle/);
  assert.match(text, /A mesh has triangles/);
  assert.doesNotMatch(text, /NaN|Asking/);
  assert.match(await page.$eval(".expression code", (element) => element.textContent), /^\(-15, 0, (4|3\.9)/);
  await page.keyboard.press("Escape");
  await page.click('.tree-row[data-path="edge_shell"] .eye');
});

run("a claim that fails shows its places and selects what it names", async () => {
  const names = await page.$$eval(".claim", (claims) => claims.map((claim) => claim.className));
  assert.deepEqual(names, ["claim fail", "claim fail", "claim fail", "claim pass"]);
  const click = (n) => page.$$eval(".claim summary", (all, i) => all[i].click(), n);
  const ring = () => page.evaluate(() => [...document.querySelectorAll(".claim-ring")].map((one) => [Number(one.getAttribute("cx")), Number(one.getAttribute("cy"))]));
  const frame = await page.$eval(".canvas", (canvas) => [canvas.getBoundingClientRect().left, canvas.getBoundingClientRect().top]);
  const at = async (point) => (await page.evaluate((place) => window.virote.pixel(place), point)).map((value, k) => value - frame[k]);
  const selected = () => page.evaluate(() => window.virote.items.filter((item) => item.isSelected).map((item) => item.path));
  await click(0);
  await until(page, () => document.querySelector(".claim-ring"));
  const [[x, y]] = await ring();
  const [a, b] = await at([15, 0, 13]);
  assert.ok(Math.hypot(x - a, y - b) < 0.6, "a ring around the point");
  assert.deepEqual(await selected(), ["top"]);
  await click(1);
  await until(page, () => window.virote.items.filter((item) => item.isSelected).length === 2);
  assert.deepEqual((await selected()).sort(), ["ball", "core"]);
  assert.equal((await ring()).length, 1, "where the deviation is greatest");
  await click(2);
  await until(page, () => window.virote.items.some((item) => item.path === "top" && item.isSelected));
  // A claim about a number has no place.
  await until(page, () => document.querySelector(".claim-ring") === null);
  await page.keyboard.press("Escape");
  assert.deepEqual(await selected(), []);
});

run("the deviation of one definition from another is mapped", async () => {
  const plain = await colorAt(page, [13, -7, 6]);
  await page.click('[data-shade="deviation"]');
  const choose = (which, name) => page.select(`[data-deviation="${which}"]`, name);
  await choose("of", "ball");
  await choose("from", "core");
  await until(page, () => /on average/.test(document.querySelector(".deviation-told").textContent) && document.querySelector(".legend-title").textContent.includes("ball from core"));
  assert.match(await page.$eval(".deviation-told", (element) => element.textContent), /From 2 to 2 mm, on average 2 mm/);
  assert.equal(await page.$eval('[data-end="most"]', (field) => field.value), "2");
  const [red, , blue] = await colorAt(page, [13, -7, 6]);
  assert.ok(red > blue + 40, "outside is red");
  assert.notDeepEqual(await colorAt(page, [13, -7, 6]), plain);
  await choose("of", "core");
  await choose("from", "ball");
  await until(page, () => /From −2 to −2/.test(document.querySelector(".deviation-told").textContent));
  await page.click('[data-shade="plain"]');
  assert.deepEqual(await colorAt(page, [13, -7, 6]), plain);
});

run("stripes are drawn by the shader or by the kernel, and the picture says by which", async () => {
  // Level stripes in 24 sectors: mirrored rays turn twice as fast as normals, so that a border is at 3.75 degrees.
  const at = (degrees) => [15, -8 * Math.cos((degrees * Math.PI) / 180), 5 + 8 * Math.sin((degrees * Math.PI) / 180)];
  const bright = async (degrees) => {
    const [red, green, blue] = await colorAt(page, at(degrees));
    return (red + green + blue) / 3;
  };
  const caption = () => page.$eval(".stripes-caption", (text) => text.textContent);
  const draw = (by) => page.$$eval('[data-setting="exact-stripes"] button', (all, name) => all.find((one) => one.textContent === name).click(), by);
  await page.keyboard.press("i");
  await page.click('[data-shade="zebra"]');
  await page.click('[data-setting="stripes-run"] [data-value="no"]');
  assert.match(await caption(), /^By the shader/);
  assert.ok((await bright(0.5)) > (await bright(7.5)) + 80, "light and dark stripes");
  await draw("kernel");
  await until(page, () => /^Exact borders by the kernel/.test(document.querySelector(".stripes-caption").textContent));
  assert.match(await caption(), /A mesh has no exact borders: box\.$/);
  const [border, before, behind] = [await bright(3.75), await bright(1.5), await bright(7.5)];
  assert.ok(before > border + 60 && behind > border + 60, `${border} is a line between ${before} and ${behind}`);
  // Seen from elsewhere the stripes are others: the shader's, until the kernel has answered.
  await page.evaluate(() => window.virote.look({ azimuth: -60 }));
  await until(page, () => /^By the shader, until/.test(document.querySelector(".stripes-caption").textContent));
  await until(page, () => /^Exact borders by the kernel/.test(document.querySelector(".stripes-caption").textContent));
  await draw("shader");
  assert.match(await caption(), /^By the shader, from/);
  await page.click('[data-shade="plain"]');
  await page.keyboard.press("i");
  await lookFromFront(page, 50);
});

run("open and shared edges of a shell are told apart", async () => {
  for (const path of ["box", "ball", "core"]) await page.click(`.tree-row[data-path="${path}"] .eye`);
  await page.click('[data-command="shell"]');
  await until(page, () => !document.querySelector(".shell-told").hidden);
  // Two faces of 10 by 10 and of 10 by 10 √2 that meet in one side of 10.
  const text = await page.$eval(".shell-told", (element) => element.textContent);
  const [open, shared] = [...text.matchAll(/([\d.]+) mm/g)].map(([, number]) => Number(number));
  assert.ok(Math.abs(open - (2 * 10 + 20 + 2 * 10 * Math.SQRT2)) < 0.01, text);
  assert.ok(Math.abs(shared - 10) < 0.01, text);
  const [red, green] = await colorAt(page, [-10, 0, 5]);
  assert.ok(green > red + 30, "they meet in green");
  const [openRed, openGreen] = await colorAt(page, [-20, 0, 5]);
  assert.ok(openRed > openGreen + 60, "and end in red");
  await page.click('[data-command="shell"]');
});

run("the page had no fault in all this", () => assert.deepEqual(page.faults, []));
