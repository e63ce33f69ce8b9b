// Bad input and bad company: what never ends, what goes away, what is nothing, and texts that would be markup.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, rmSync, rmdirSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";

import { closeBrowser, colorAt, command, environment, lookFromFront, openBrowser, openPage, serve, serveFile, skip, until } from "./harness.mjs";

const BALL = "geo 1\nunit mm\nsurface ball = sphere((0, 0, 0), 10)\n";
/** Takes longer than anybody waits. */
const ENDLESS = "fn deep(m) = sum([for i in 0..<m: if i < 0 then 1 else i % 7])\nlet n = sum([for i in 0..<1000000: deep(1000000 + i)])\n";

before(async () => {
  if (!skip) await openBrowser();
}, { timeout: 120_000 });
after(closeBrowser);

/** A test with a script of its own, which `body` gets with an open page; the page must have no fault. */
function run(name, script, body, more = []) {
  test(name, { skip, timeout: 120_000 }, async () => {
    const served = await serve(script, more);
    let page;
    try {
      page = await openPage(served.url);
      await body(page, served);
      assert.deepEqual(page.faults, []);
    } finally {
      await page?.close();
      served.end();
    }
  });
}

const isStatus = (page, kind) => until(page, (wanted) => document.querySelector(".status").dataset.kind === wanted, kind);
const paths = (page) => page.evaluate(() => window.virote.items.map(({ path }) => path));

run("an endless evaluation is stopped by its button, and the model stays", BALL, async (page, served) => {
  served.save(BALL + ENDLESS);
  await isStatus(page, "busy");
  await page.waitForSelector(".stop:not([hidden])");
  await page.click(".stop");
  await isStatus(page, "error");
  assert.match(await page.$eval(".diagnostics", (element) => element.textContent), /stopped/);
  assert.deepEqual(await paths(page), ["ball"]);
  served.save(BALL);
  await isStatus(page, "good");
  assert.equal(await page.evaluate(() => window.virote.isCurrent), true);
}, ["--limit", "steps=1_000_000_000_000"]);

run("a save ends an endless evaluation", BALL, async (page, served) => {
  served.save(BALL + ENDLESS);
  await isStatus(page, "busy");
  served.save(`${BALL}surface core = sphere((0, 0, 0), 5)\n`);
  await until(page, () => window.virote.items.length === 2 && window.virote.isCurrent);
}, ["--limit", "steps=1_000_000_000_000"]);

run("a server that goes away is missed, and one in its place is told apart", BALL, async (page, served) => {
  const { port } = new URL(served.url);
  served.process.removeAllListeners("exit");
  served.process.kill();
  await isStatus(page, "offline");
  assert.match(await page.$eval(".status-text", (element) => element.textContent), /no connection/);
  assert.deepEqual(await paths(page), ["ball"], "the model stays in sight");
  const next = await serveFile(served.script, ["--port", port]);
  try {
    await until(page, () => document.querySelector(".status-text").textContent.includes("started anew"));
  } finally {
    next.end();
  }
});

run("what was saved while the page could not ask is shown once it can", BALL, async (page, served) => {
  await page.setOfflineMode(true);
  served.save(`${BALL}surface core = sphere((0, 0, 0), 5)\n`);
  await isStatus(page, "offline");
  assert.deepEqual(await paths(page), ["ball"]);
  await page.setOfflineMode(false);
  await until(page, () => window.virote.items.length === 2 && window.virote.isOnline);
});

run("a script that is deleted, replaced by a folder and restored leaves the model", BALL, async (page, served) => {
  rmSync(served.script);
  await isStatus(page, "error");
  assert.match(await page.$eval(".diagnostics", (element) => element.textContent), /model\.geo/);
  assert.deepEqual(await paths(page), ["ball"]);
  mkdirSync(served.script);
  await new Promise((done) => setTimeout(done, 300));
  assert.deepEqual(await paths(page), ["ball"]);
  rmdirSync(served.script);
  served.save(BALL.replace("10)", "8)"));
  await isStatus(page, "good");
  await until(page, () => window.virote.isCurrent && window.virote.isReady);
});

run("an empty script says so, and what is written then is seen", "", async (page, served) => {
  assert.match(await page.$eval(".greeting", (element) => element.textContent), /nothing to draw/);
  await page.keyboard.press("f");
  await page.keyboard.press("z");
  await page.keyboard.press("x");
  await page.keyboard.press("x");
  await page.keyboard.press("z");
  served.save(BALL);
  await until(page, () => window.virote.items.length === 1 && window.virote.isReady);
  assert.equal((await colorAt(page, [0, -10, 0]))[3], 255, "the camera has gone to it");
  served.save("");
  await until(page, () => window.virote.items.length === 0 && !document.querySelector(".greeting").hidden);
});

run("the camera stays at a save, and goes to a model that has nothing of the one before", BALL, async (page, served) => {
  const pose = () => page.evaluate(() => ({ camera: window.virote.camera, pixel: window.virote.pixel([0, 0, 0]) }));
  await page.evaluate(() => window.virote.look({ azimuth: 10, elevation: 20, height: 50 }));
  const mine = await pose();
  const next = async (text, path) => {
    served.save(text);
    await until(page, (name) => window.virote.isReady && window.virote.items.some((item) => item.path === name), path);
  };
  // Another name, another place beside, more beside it, nothing for a while.
  await next("geo 1\nunit mm\nsurface globe = sphere((2, 0, 0), 9)\n", "globe");
  await next("geo 1\nunit mm\nsurface globe = sphere((2, 0, 0), 9)\nsurface far = sphere((500, 0, 0), 100)\n", "far");
  served.save("geo 1\n");
  await until(page, () => window.virote.items.length === 0);
  await next("geo 1\nunit mm\nsurface far = sphere((500, 0, 0), 100)\n", "far");
  assert.deepEqual(await pose(), mine);
  await next("geo 1\nunit mm\nsurface pearl = sphere((0, 0, 0), 1)\n", "pearl");
  const { camera } = await pose();
  assert.ok(camera.height < 10 && Math.hypot(...camera.target) < 1, JSON.stringify(camera));
  assert.equal((await colorAt(page, [0, 0, 0]))[3], 255);
});

const BROKEN = `${BALL}surface lid = sphere((60, 0, 0), q)\n`;

run("a script with an error from the start shows what is whole, greyed, and the whole once it is there", BROKEN, async (page, served) => {
  const told = () => page.$eval(".diagnostics", (element) => element.textContent);
  assert.deepEqual(await paths(page), ["ball"]);
  assert.equal(await page.evaluate(() => window.virote.isCurrent), false);
  assert.match(await told(), /1 error · what has no errors is shown.*line 4/);
  assert.match(await page.$eval('[data-section="parameters"]', (section) => section.textContent), /once the script is whole/);
  assert.equal((await colorAt(page, [0, -10, 0]))[3], 255);
  served.save(BROKEN.replace("q)", "10)"));
  await until(page, () => window.virote.items.length === 2 && window.virote.isCurrent && window.virote.isReady);
  assert.equal((await colorAt(page, [60, -10, 0]))[3], 255, "the camera has gone to all of it");
  const whole = await colorAt(page, [0, -10, 0]);
  served.save(BROKEN);
  await until(page, () => !window.virote.isCurrent && window.virote.isReady);
  assert.deepEqual(await paths(page), ["ball", "lid"]);
  assert.match(await told(), /the model is that of the last good run/);
  assert.notDeepEqual(await colorAt(page, [0, -10, 0]), whole, "greyed");
});

const WRITTEN = `${BALL}surface wave = parametric((u, v) => (20 + u, v, u * v), 0..4, 0..4)\nsurface core = ball with (hidden = true)\n`;

run("what an edit evaluates to what it was is not sent again", WRITTEN, async (page, served) => {
  await page.evaluate(() => document.querySelector('.tree-row[data-path="core"] .eye').click());
  await until(page, () => window.virote.items.length === 3);
  const known = await page.evaluate(() => ({ version: window.virote.stateVersion, n_fetched: window.virote.n_fetched, keys: window.virote.items.map(({ key }) => key) }));
  served.save(WRITTEN.replace("10)", "5 + 5)").replace("u * v", "v * u"));
  await until(page, (version) => window.virote.stateVersion > version && window.virote.isReady, known.version);
  const after = await page.evaluate(() => ({ n_fetched: window.virote.n_fetched, keys: window.virote.items.map(({ key }) => key) }));
  assert.deepEqual(after, { n_fetched: known.n_fetched, keys: known.keys });
});

run("a surface of a single point is no fault", "surface s = bilinear((1, 2, 3), (1, 2, 3), (1, 2, 3), (1, 2, 3))\npoint p = (1, 2, 3)\ncurve c = line((1, 2, 3), (1, 2, 3.000001))\n", async (page) => {
  for (const shade of ["gauss", "zebra", "plain"]) await page.click(`[data-shade="${shade}"]`);
  for (const id of ["combs", "control", "knots", "normals", "wireframe", "section", "shell"]) {
    await page.click(`[data-command="${id}"]`);
    await page.evaluate(() => window.virote.color(600, 350));
    await page.click(`[data-command="${id}"]`);
  }
  await page.keyboard.press("f");
  const { height, target } = await page.evaluate(() => window.virote.camera);
  assert.ok(height > 0 && target.every(Number.isFinite));
  for (const path of ["s", "p", "c"]) await page.click(`.tree-row[data-path="${path}"]`);
  assert.doesNotMatch(await page.evaluate(() => document.body.innerText), /NaN|undefined|Infinity/);
});

const EVIL = "<img src=x onerror=alert(1)>";
const MARKUP = `param a = 1 in 0..2 "${EVIL}"
param word = "${EVIL}"
surface ball = sphere((0, 0, 0), 1 + a) with (layer = "${EVIL}")
check a < 1 "${EVIL}"
print "${EVIL}"
export ball to "<b>x.stl"
`;

run("texts of the script are texts in every panel of both windows", MARKUP, async (page, served) => {
  const other = await openPage(served.url);
  await page.bringToFront();
  await page.click('.tree-row[data-path="ball"]');
  for (const one of [page, other]) {
    const text = await one.evaluate(() => document.body.textContent);
    assert.ok(text.split("<img src=x").length > 3, "label, value, layer, claim and print are shown");
    assert.equal(await one.$("img, .panel b:not(.diagnostic b)"), null);
    assert.deepEqual(one.faults, []);
  }
  served.save(`${MARKUP}let ${"x"} = "${EVIL}" + 1\n`);
  await until(page, () => document.querySelector(".diagnostic.error"));
  await until(other, () => document.querySelector(".diagnostic.error"));
  assert.equal(await page.$("img"), null);
  // What one window sets the other shows.
  served.save(MARKUP);
  await until(page, () => window.virote.isCurrent && window.virote.isReady);
  await page.$eval('[data-parameter="a"] .value', (field) => {
    field.value = "0.5";
    field.dispatchEvent(new Event("change"));
  });
  await until(other, () => document.querySelector('[data-parameter="a"]').classList.contains("is-set") && document.querySelector(".claim.pass"));
  await other.close();
});

run("an exported page has its analyses, and says what it cannot", `${BALL}check 1 < 0 "${EVIL}"\n`, async (_, served) => {
  const file = join(served.folder, "page.html");
  const made = spawnSync(command, ["view", "--export", file, served.script], { encoding: "utf8", env: environment });
  assert.ok(made.stdout.includes("page.html") || made.stderr.includes("page.html"), made.stderr);
  served.process.removeAllListeners("exit");
  served.process.kill();
  const page = await openPage(pathToFileURL(file).href);
  await lookFromFront(page);
  const front = [3, -9, 3];
  const plain = await colorAt(page, front);
  assert.equal(plain[3], 255);
  for (const shade of ["zebra", "isophotes", "gauss", "mean", "k1", "k2", "draft", "sides"]) {
    await page.click(`[data-shade="${shade}"]`);
    assert.notDeepEqual(await colorAt(page, front), plain, shade);
  }
  await page.click('[data-shade="plain"]');
  assert.deepEqual(await colorAt(page, front), plain);
  for (const id of ["combs", "control", "wireframe", "section", "ghost", "shell"]) await page.click(`[data-command="${id}"]`);
  await page.mouse.click(...(await page.evaluate((point) => window.virote.pixel(point), [-3, -9, 3])));
  await until(page, () => window.virote.hit !== null);
  assert.match(await page.$eval(".place", (element) => element.textContent), /From the triangles/);
  assert.equal(await page.$('[data-shade="deviation"]'), null, "what needs evaluation is not there");
  assert.equal(await page.$("img"), null);
  assert.deepEqual(page.faults, []);
  await page.close();
});
