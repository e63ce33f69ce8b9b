// The page against the command itself, in a headless browser. Expected values come from closed forms or from `virote run`.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";

import { closeBrowser, colorAt, command, environment, evaluated, lookFromFront, openBrowser, openPage, serve, skip, until } from "./harness.mjs";

const SCRIPT = `geo 1
unit mm
param size = 10mm in 5mm..20mm step 1mm "Radius <b>of</b> <img src=x onerror=alert(1)>"
param n = 3 in 1..6 step 1 "How many"
surface ball = sphere((0, 0, 0), size)
surface sheet = ruled(line((-4, -18, -14), (4, -18, -14)), line((-4, -12, -14), (4, -12, -14)))
curves rings = [for i in 1..n: circle((0, 0, 0), size + 2mm * i)]
check size < 15mm "the ball is small"
print 2 * size
`;

let served;
let page;
before(async () => {
  if (skip) return;
  await openBrowser();
  served = await serve(SCRIPT);
  page = await openPage(served.url);
  await lookFromFront(page);
}, { timeout: 120_000 });
after(async () => {
  served?.end();
  await closeBrowser();
});

const option = { skip, timeout: 180_000 };
const run = (name, body) => test(name, option, body);
/** In front of the ball, a little aside of its middle. */
const FRONT = [3, -10, 4];

run("the model is where it should be and nowhere else", async () => {
  const [, , , opacity] = await colorAt(page, [0, -10, 0]);
  assert.equal(opacity, 255, "the ball");
  await page.keyboard.press("r");
  assert.equal((await colorAt(page, [0, 0, 17.5]))[3], 0, "beside it, without the grid");
  await page.keyboard.press("r");
  assert.deepEqual((await page.evaluate(() => window.virote.items.map(({ path }) => path))).sort(), ["ball", "rings[0]", "rings[1]", "rings[2]", "sheet"]);
});

run("no frame is drawn while nothing changes", async () => {
  const frames = () => page.evaluate(() => window.virote.n_frames);
  await until(page, () => window.virote.isSmooth);
  await page.evaluate(() => new Promise((done) => setTimeout(done, 300)));
  const n_frames = await frames();
  await page.evaluate(() => new Promise((done) => setTimeout(done, 600)));
  assert.equal(await frames(), n_frames);
});

run("a dragged parameter changes the mesh and leaves the camera", async () => {
  const before = await page.evaluate(() => ({ camera: window.virote.camera, key: window.virote.items[0].key, version: window.virote.stateVersion }));
  const track = await page.$('[data-parameter="size"] input[type=range]');
  const { x, y, width, height } = await track.boundingBox();
  await page.mouse.move(x + width / 3, y + height / 2);
  await page.mouse.down();
  for (const share of [0.4, 0.5, 0.6, 0.75]) await page.mouse.move(x + width * share, y + height / 2);
  await page.mouse.up();
  await until(page, (key) => window.virote.items[0]?.key !== key && window.virote.isReady, before.key);
  await until(page, () => document.querySelector('[data-parameter="size"]').classList.contains("is-set"));
  await until(page, () => document.querySelector('[data-parameter="size"] .value').value === `${document.querySelector('[data-parameter="size"] input[type=range]').value}mm` && window.virote.isReady);
  const after = await page.evaluate(() => ({ camera: window.virote.camera, items: window.virote.items.length }));
  assert.deepEqual(after, { camera: before.camera, items: 5 });
  await page.click('[data-do="reset"]');
  await until(page, () => !document.querySelector(".parameter.is-set") && window.virote.isReady);
});

run("texts of the script never become markup", async () => {
  const label = await page.$eval('[data-parameter="size"] .parameter-label', (element) => [element.textContent, element.children.length]);
  assert.deepEqual(label, ["Radius <b>of</b> <img src=x onerror=alert(1)>", 0]);
  assert.equal(await page.$("img"), null);
});

run("a broken script greys the model and says why, a whole one mends it", async () => {
  const sane = await colorAt(page, FRONT);
  served.save(SCRIPT.replace("sphere((0, 0, 0), size)", "sphere((0, 0, 0), sise)"));
  await until(page, () => document.querySelector(".diagnostic.error pre") && !window.virote.isCurrent);
  const text = await page.$eval(".diagnostics", (element) => element.textContent);
  assert.match(text, /E0201/);
  assert.match(text, /sise/);
  assert.equal(await page.$eval(".status", (element) => element.dataset.kind), "error");
  assert.equal((await page.evaluate(() => window.virote.items)).length, 5, "the last good model stands");
  assert.notDeepEqual(await colorAt(page, FRONT), sane);
  served.save(SCRIPT);
  await until(page, () => window.virote.isCurrent && document.querySelector(".diagnostics").hidden);
  assert.deepEqual(await colorAt(page, FRONT), sane);
});

run("a failed claim is told with both sides", async () => {
  served.save(SCRIPT.replace("size < 15mm", "size < 8mm"));
  await until(page, () => document.querySelector(".claim.fail"));
  assert.match(await page.$eval(".claim.fail", (element) => element.textContent), /the ball is small/);
  served.save(SCRIPT);
  await until(page, () => document.querySelector(".claim.pass"));
});

run("a click asks the kernel, which answers as the interpreter does", async () => {
  const [x, y] = await page.evaluate((point) => window.virote.pixel(point), FRONT);
  await page.mouse.click(x, y);
  await until(page, () => window.virote.hit?.answer);
  const { answer, parameters, path } = await page.evaluate(() => window.virote.hit);
  assert.equal(path, "ball");
  assert.ok(Math.abs(Math.hypot(...answer.point) - 10) < 1e-9, "the point is on the sphere, not on its mesh");
  const expected = evaluated(SCRIPT, `ball(${parameters.u}, ${parameters.v})`);
  answer.point.forEach((value, k) => assert.ok(Math.abs(value - expected[k]) < 1e-6, `${answer.point} and ${expected}`));
  const fact = (name) => answer.facts.find((one) => one.name === name).value;
  assert.ok(Math.abs(fact("gauss") - 0.01) < 1e-9);
  assert.ok(Math.abs(Math.abs(fact("mean")) - 0.1) < 1e-9);
  assert.match(await page.$eval(".expression code", (element) => element.textContent), /^ball\(/);
  assert.deepEqual(await page.evaluate(() => window.virote.items.filter((item) => item.isSelected).map((item) => item.path)), ["ball"]);
  assert.equal(await page.$eval('.tree-row[data-path="ball"]', (row) => row.getAttribute("aria-selected")), "true");
  await page.keyboard.press("Escape");
});

run("two clicks give the distance between exact points", async () => {
  await page.keyboard.press("m");
  for (const point of [[-6, -8, 0], [6, -8, 0]]) await page.mouse.click(...(await page.evaluate((place) => window.virote.pixel(place), point)));
  await until(page, () => window.virote.marks.length === 2 && window.virote.marks.every((mark) => mark.answer));
  const [a, b] = await page.evaluate(() => window.virote.marks.map((mark) => mark.answer.point));
  const distance = Math.hypot(...a.map((value, k) => value - b[k]));
  const shown = await page.$eval(".pair", (element) => element.textContent);
  assert.ok(shown.includes(String(Number(distance.toPrecision(7)))), `${shown} tells ${distance}`);
  assert.match(shown, /Angle/);
  await page.keyboard.press("Escape");
});

run("each analysis changes the picture, and the plain one brings it back", async () => {
  const plain = await colorAt(page, FRONT);
  for (const shade of ["zebra", "isophotes", "gauss", "mean", "k1", "k2", "draft", "sides"]) {
    await page.click(`[data-shade="${shade}"]`);
    assert.equal(await page.evaluate(() => window.virote.settings.shade), shade);
    assert.notDeepEqual(await colorAt(page, FRONT), plain, shade);
  }
  await page.click('[data-shade="gauss"]');
  const whole = await colorAt(page, FRONT);
  await page.$eval('[data-end="most"]', (field) => {
    field.value = "1";
    field.dispatchEvent(new Event("change"));
  });
  assert.notDeepEqual(await colorAt(page, FRONT), whole, "the range of the legend");
  await page.click('[data-shade="plain"]');
  assert.deepEqual(await colorAt(page, FRONT), plain);
});

run("each overlay draws something and goes again", async () => {
  const picture = async () => (await page.screenshot({ clip: await (await page.$(".canvas")).boundingBox() })).toString("base64");
  // The front shows the sheet from its side.
  await page.evaluate(() => window.virote.look({ azimuth: -30, elevation: 30 }));
  const plain = await picture();
  for (const id of ["edges", "isocurves", "wireframe", "combs", "control", "knots", "normals", "grid", "projection"]) {
    await page.click(`[data-command="${id}"]`);
    assert.ok((await picture()) !== plain, id);
    await page.click(`[data-command="${id}"]`);
  }
  await lookFromFront(page);
});

run("the section cuts one half away", async () => {
  await page.keyboard.press("r");
  await page.keyboard.press("x");
  assert.equal((await colorAt(page, [-4, -9, 4.5]))[3], 255, "the half that stays");
  assert.equal((await colorAt(page, [4, -9, 4.5]))[3], 0, "the half that goes");
  assert.ok(await page.$(".section-handle:not([hidden])"));
  await page.keyboard.press("x");
  await page.keyboard.press("r");
});

run("the section fills what is closed, and says what is open", async () => {
  await page.keyboard.press("r");
  await page.keyboard.press("x");
  // The ball is cut through its middle, where its inside is seen from the right.
  await page.evaluate(() => window.virote.look({ azimuth: 0, elevation: 0 }));
  const within = await colorAt(page, [0, 3, 4]);
  assert.equal(within[3], 255);
  assert.equal((await colorAt(page, [0, 12, -11]))[3], 0, "in the plane, beside the ball");
  const hatched = await page.evaluate(() => {
    const [x, y] = window.virote.pixel([0, 3, 4]);
    const colors = Array.from({ length: 20 }, (_, i) => window.virote.color(x + i, y).join());
    return new Set(colors).size;
  });
  assert.ok(hatched === 2, "it is hatched");
  const told = await page.$eval(".cut-told", (hint) => hint.textContent);
  assert.match(told, /^ball is closed\. sheet is open, and not filled\.$/);
  await page.mouse.click(...(await page.evaluate(() => window.virote.pixel([0, 3, 4]))));
  await until(page, () => window.virote.hit !== null);
  const hit = await page.evaluate(() => window.virote.hit);
  assert.equal(hit.path, "ball");
  [0, 3, 4].forEach((value, k) => assert.ok(Math.abs(hit.point[k] - value) < 0.05, String(hit.point)));
  assert.match(await page.$eval(".place", (element) => element.textContent), /on the section plane/);
  await page.keyboard.press("Escape");
  // The handle moves the plane out of the ball.
  await page.evaluate(() => window.virote.look({ azimuth: -90, elevation: 0 }));
  await colorAt(page, [0, 0, 0]);
  const handle = await (await page.$(".section-handle")).boundingBox();
  const [x, y] = [handle.x + handle.width / 2, handle.y + handle.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  const moved = await page.evaluate(() => window.virote.pixel([9.95, 0, 0])[0] - window.virote.pixel([0, 0, 0])[0]);
  await page.mouse.move(x + moved, y, { steps: 4 });
  await page.mouse.up();
  assert.ok((await page.evaluate(() => window.virote.settings.sectionPlace)) > 0.7);
  // Both places that tell where it stands say the same.
  const [row, note] = await page.$eval('.section[data-section="section"]', (part) => [part.querySelector('[data-setting="section-place"] output').textContent, part.querySelector(".note").textContent]);
  assert.equal(row, note);
  await page.$eval('[data-setting="section-place"] input', (track) => {
    track.valueAsNumber = 0.5;
    track.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await page.keyboard.press("x");
  await page.keyboard.press("r");
  await lookFromFront(page);
});

run("definitions are hidden, isolated and found", async () => {
  const visible = () => page.evaluate(() => window.virote.items.filter((item) => item.isVisible).map((item) => item.path));
  await page.click('.tree-row[data-path="ball"]');
  await page.keyboard.press("h");
  assert.deepEqual(await visible(), ["sheet", "rings[0]", "rings[1]", "rings[2]"]);
  await page.keyboard.down("Shift");
  await page.keyboard.press("h");
  await page.keyboard.up("Shift");
  assert.equal((await visible()).length, 5);
  await page.type(".find", "rings[1");
  assert.deepEqual(await page.$$eval(".tree-row", (rows) => rows.map((row) => row.dataset.path)), ["rings", "rings[1]"]);
  await page.click('.tree-row[data-path="rings[1]"]');
  await page.keyboard.press("l");
  assert.deepEqual(await visible(), ["rings[1]"]);
  await page.$eval(".find", (field) => {
    field.value = "";
    field.dispatchEvent(new Event("input"));
  });
  await page.keyboard.down("Shift");
  await page.keyboard.press("l");
  await page.keyboard.up("Shift");
  await page.keyboard.press("Escape");
  assert.equal((await visible()).length, 5);
});

run("named views and the wheel move the camera", async () => {
  await page.keyboard.press("5");
  assert.equal((await page.evaluate(() => window.virote.camera)).elevation, 90);
  const { height } = await page.evaluate(() => window.virote.camera);
  const [x, y] = await page.evaluate(() => window.virote.pixel([8, 4, 0]));
  await page.mouse.move(x, y);
  await page.mouse.wheel({ deltaY: -200 });
  await until(page, (old) => window.virote.camera.height < old, height);
  const [zoomedX, zoomedY] = await page.evaluate(() => window.virote.pixel([8, 4, 0]));
  assert.ok(Math.hypot(zoomedX - x, zoomedY - y) < 2, "the point under the pointer stays");
  await lookFromFront(page);
});

run("a ghost keeps what was to compare it with what is", async () => {
  await page.keyboard.press("r");
  await page.keyboard.press("g");
  await page.$eval('[data-parameter="size"] .value', (field) => {
    field.value = "5mm";
    field.dispatchEvent(new Event("change"));
  });
  await until(page, () => document.querySelector('[data-parameter="size"]').classList.contains("is-set") && window.virote.isReady);
  const [, , , opacity] = await colorAt(page, [0, -2, 8.2]);
  assert.ok(opacity > 20 && opacity < 200, `the ghost shines through, with ${opacity}`);
  await page.keyboard.press("g");
  assert.equal((await colorAt(page, [0, -2, 8.2]))[3], 0);
  await page.keyboard.press("r");
});

run("a changed parameter is written into the script and nothing else", async () => {
  await page.click('[data-do="write"]');
  await until(page, () => document.querySelector(".toast")?.textContent.startsWith("Written"));
  assert.equal(served.read(), SCRIPT.replace("size = 10mm", "size = 5mm"));
  served.save(SCRIPT);
  await page.click('[data-do="reset"]');
  await until(page, () => !document.querySelector(".parameter.is-set") && window.virote.isReady);
});

run("two windows show one model", async () => {
  const other = await openPage(served.url);
  await other.$eval('[data-parameter="n"] .value', (field) => {
    field.value = "5";
    field.dispatchEvent(new Event("change"));
  });
  for (const one of [page, other]) await until(one, () => window.virote.items.length === 7 && window.virote.isReady);
  assert.deepEqual(other.faults, []);
  await other.close();
});

run("an exported page shows the model without a server", async () => {
  const file = join(served.folder, "page.html");
  const made = spawnSync(command, ["view", "--export", file, served.script], { encoding: "utf8", env: environment });
  assert.equal(made.status, 0, made.stderr);
  const shown = await openPage(pathToFileURL(file).href);
  await lookFromFront(shown);
  assert.equal((await colorAt(shown, [0, -10, 0]))[3], 255);
  assert.equal(await shown.$('[data-do="write"]'), null, "what needs evaluation is not there");
  assert.deepEqual(shown.faults, []);
  await shown.close();
});

const PARTS = `unit mm
region plate = region(polyline((0, 0), (40, 0), (40, 25), (0, 25), closed = true), holes = [circle((20, 12, 0), 4)])
solids two = [solid(box((0, 40, 0), (10, 10, 10))), solid(box((20, 40, 0), (10, 10, 20)))]
points cloud = [(0, -20, 0), (10, -20, 3)]
`;

run("a solid and a region are one row each, and a face tells of its solid", async () => {
  const parts = await serve(PARTS);
  const shown = await openPage(parts.url);
  const selection = () => shown.$eval('[data-section="facts"]', (element) => element.innerText);
  try {
    await shown.waitForSelector('[data-path="two"] .fold');
    await shown.click('[data-path="two"] .fold');
    await shown.click('[data-path="two[1]"] .fold');
    await shown.click('[data-path="two[1].faces[0]"]');
    await shown.waitForSelector('.owner [data-ask="volume"]');
    await shown.click('.owner [data-ask="volume"]');
    await until(shown, () => /2000 mm³/.test(document.querySelector('[data-section="facts"]').innerText));
    assert.match(await selection(), /face two\[1\]\.faces\[0\]/);
    await shown.click('[data-path="plate"]');
    await shown.click('[data-ask="area"]');
    await until(shown, () => /949\.735 mm²/.test(document.querySelector('[data-section="facts"]').innerText));
    const [x, y] = await shown.evaluate(() => window.virote.pixel([10, -20, 3]));
    await shown.mouse.click(x, y);
    await until(shown, () => document.querySelector(".expression")?.innerText.startsWith("cloud[1]"));
    assert.deepEqual(shown.faults, []);
  } finally {
    await shown.close();
    parts.end();
  }
});

run("the page had no fault in all this", () => assert.deepEqual(page.faults, []));
