// The page and an editor around it: in the panel of the editor's extension, and by its address.

import assert from "node:assert/strict";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";

import { closeBrowser, newPage, openBrowser, openPage, serve, skip, until } from "./harness.mjs";

const { page: panelPage } = createRequire(import.meta.url)("../../editors/vscode/src/preview.js");

const SCRIPT = `geo 1
surface ball = sphere((0, 0, 0), 10)
curves rings = [for i in 1..3: circle((0, 0, 0), 10 + 2 * i)]
let _core = sphere((30, 0, 0), 5)
surface spare = _core with (hidden = true)
`;
const option = { skip, timeout: 180_000 };

let served;
before(async () => {
  if (skip) return;
  await openBrowser();
  served = await serve(SCRIPT);
}, { timeout: 120_000 });
after(async () => {
  served?.end();
  await closeBrowser();
});

const selected = (frame) => frame.evaluate(() => window.virote.items.filter((item) => item.isSelected).map(({ path }) => path).sort());

test("an address names the definition that is shown", option, async () => {
  const page = await openPage(`${served.url}#definition=spare`);
  await until(page, () => window.virote.items.some((item) => item.path === "spare" && item.isVisible && item.isSelected));
  // It is what the picture shows, once it is drawn.
  await until(page, () => Math.abs(window.virote.camera.target[0] - 30) < 1e-6);
  await page.evaluate(() => (location.hash = "definition=rings"));
  await until(page, () => window.virote.items.filter((item) => item.isSelected).length === 3);
  assert.deepEqual(await selected(page), ["rings[0]", "rings[1]", "rings[2]"]);
  assert.deepEqual(page.faults, []);
  await page.close();
});

test("in a narrow window the picture is not covered", option, async () => {
  const shown = (page) => page.$$eval(".panel", (panels) => panels.map((panel) => !panel.hidden));
  for (const [width, expected] of [[1200, [true, true]], [700, [true, false]], [380, [false, false]]]) {
    const page = await openPage(served.url, { width, height: 600 });
    await page.evaluate(() => localStorage.clear());
    await page.reload();
    await until(page, () => window.virote.items.length > 0);
    assert.deepEqual(await shown(page), expected, `${width}`);
    assert.deepEqual(page.faults, []);
    await page.close();
  }
});

test("a page that becomes narrower closes the panels that would cover it, and has them again when it is wider", option, async () => {
  const page = await openPage(served.url, { width: 1200, height: 600 });
  await page.evaluate(() => localStorage.clear());
  await page.reload();
  await until(page, () => window.virote.items.length > 0);
  const become = async (width, left, right) => {
    await page.setViewport({ width, height: 600 });
    const isSo = (...wanted) => [...document.querySelectorAll(".panel")].every((panel, i) => !panel.hidden === wanted[i]);
    await until(page, isSo, left, right);
  };
  await become(700, true, false);
  await become(380, false, false);
  await become(1200, true, true);
  // What the person opens there stays, and what they close is not opened by the width.
  await become(380, false, false);
  await page.keyboard.press("]");
  await become(400, false, true);
  await page.keyboard.press("]");
  await become(1200, true, true);
  await page.keyboard.press("[");
  await become(380, false, false);
  await become(1200, false, true);
  const { leftPanel, rightPanel } = await page.evaluate(() => JSON.parse(localStorage.getItem("virote-view")));
  assert.deepEqual([leftPanel, rightPanel], [false, true], "and what is kept for another visit is the wish");
  await page.evaluate(() => localStorage.clear());
  assert.deepEqual(page.faults, []);
  await page.close();
});

/** The panel of the extension with the page in its frame, and an editor that keeps what it hears. */
async function openPanel(t) {
  const html = panelPage(served.url);
  const server = createServer((_, response) => response.setHeader("Content-Type", "text/html").end(html));
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  t.after(() => server.close());
  const page = await newPage();
  t.after(() => page.close());
  await page.evaluateOnNewDocument(() => {
    window.heard = [];
    window.acquireVsCodeApi = () => ({ postMessage: (message) => window.heard.push(message) });
  });
  // The page lets nobody but the editor hold it, which a browser is not.
  await page.setRequestInterception(true);
  page.on("request", async (request) => {
    if (request.url() !== served.url) return request.continue();
    const response = await fetch(served.url);
    await request.respond({ status: response.status, contentType: "text/html", body: await response.text() });
  });
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  const element = await page.waitForSelector("iframe");
  const frame = await element.contentFrame();
  await frame.waitForFunction(() => window.virote?.isReady, { timeout: 90_000 });
  return { page, frame };
}

test("in the panel the page follows the editor, and tells what is clicked", option, async (t) => {
  const { page, frame } = await openPanel(t);
  const heard = async () => {
    await frame.evaluate(() => new Promise((done) => setTimeout(done, 100)));
    return page.evaluate(() => window.heard.splice(0));
  };
  const say = async (message) => {
    await page.evaluate((told) => window.postMessage(told, "*"), message);
    await frame.evaluate(() => new Promise((done) => setTimeout(done, 100)));
  };
  assert.deepEqual(await heard(), [{ virote: "ready" }]);

  await say({ virote: "select", definitions: ["size", "rings"] });
  assert.deepEqual(await selected(frame), ["rings[0]", "rings[1]", "rings[2]"]);
  await say({ virote: "select", definitions: ["ball"] });
  assert.deepEqual(await selected(frame), ["ball"]);
  for (const nonsense of [null, "ball", { virote: "select" }, { virote: "select", definitions: [] }, { definitions: ["rings"] }]) await say(nonsense);
  assert.deepEqual(await selected(frame), ["ball"]);
  assert.deepEqual(await heard(), [], "what the editor wanted is not told back");

  // A click on the model, and one beside it.
  await frame.evaluate(() => window.virote.look({ target: [0, 0, 0], azimuth: -90, elevation: 0, height: 80 }));
  const [x, y] = await frame.evaluate(() => window.virote.pixel([3, -9, 3]));
  await page.mouse.click(x, y);
  assert.deepEqual(await heard(), [{ virote: "selected", definition: "ball" }]);
  await page.mouse.click(...(await frame.evaluate(() => window.virote.pixel([0, 0, 30]))));
  assert.deepEqual(await heard(), []);
  // A click in the tree; what the editor wants of the same list leaves the element selected.
  await frame.click('[data-path="rings"] .fold');
  await frame.click('[data-path="rings[1]"]');
  assert.deepEqual(await heard(), [{ virote: "selected", definition: "rings" }]);
  await say({ virote: "select", definitions: ["rings"] });
  assert.deepEqual(await selected(frame), ["rings[1]"]);

  // A definition that is being written is selected as soon as it is saved.
  await say({ virote: "select", definitions: ["bar"] });
  assert.deepEqual(await selected(frame), ["rings[1]"]);
  served.save(`${SCRIPT}curve bar = line((0, 0, 0), (0, 0, 20))\n`);
  await frame.waitForFunction(() => window.virote.items.some((item) => item.path === "bar" && item.isSelected), { timeout: 90_000 });
  assert.deepEqual(await selected(frame), ["bar"]);
});
