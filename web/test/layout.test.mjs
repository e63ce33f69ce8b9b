// What stands before the picture and beside it: at no usual size does one part cover another, or is one cut off.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { closeBrowser, newPage, openBrowser, openPage, serve, skip, until } from "./harness.mjs";

const SCRIPT = `geo 1
unit mm
param size = 10mm in 5mm..20mm step 1mm "How wide it is"
surface a_ball_with_quite_a_long_name = sphere((0, 0, 0), size)
check size < 5mm "it is smaller than it can be"
print 2 * size
`;
const SIZES = [
  { width: 1280, height: 800 },
  { width: 800, height: 600 },
  { width: 480, height: 800 },
  { width: 360, height: 640 },
];
const PARTS = [".bar .title", ".bar .lamp", ".bar .status-text", ".bar-tools", ".bar-side.end .tool", ".panel.left", ".panel.right", ".legend", ".triad", ".greeting p", ".toast", ".scale", ".stripes-caption", ".diagnostics"];

before(async () => {
  if (!skip) await openBrowser();
}, { timeout: 120_000 });
after(closeBrowser);

/** Pairs of parts that lie over one another, and parts that reach out of the window. */
function faults(page) {
  return page.evaluate((names) => {
    const seen = names.flatMap((name) => [...document.querySelectorAll(name)].map((part) => [name, part.getBoundingClientRect()]));
    const boxes = seen.filter(([, { width, height }]) => width > 0 && height > 0);
    const isOut = ([, box]) => box.left < -0.5 || box.top < -0.5 || box.right > innerWidth + 0.5 || box.bottom > innerHeight + 0.5;
    const found = boxes.filter(isOut).map(([name]) => `${name} reaches out`);
    boxes.forEach(([name, a], i) => {
      for (const [other, b] of boxes.slice(i + 1)) {
        const isApart = Math.min(a.right, b.right) - Math.max(a.left, b.left) < 0.5 || Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) < 0.5;
        if (!isApart) found.push(`${name} and ${other}`);
      }
    });
    return found;
  }, PARTS);
}

for (const size of SIZES) {
  test(`nothing covers anything at ${size.width} by ${size.height}`, { skip, timeout: 240_000 }, async () => {
    const served = await serve(SCRIPT);
    try {
      const page = await openPage(served.url, size);
      assert.equal(await page.$eval(".diagnostics", (part) => part.hidden), false);
      for (const key of ["z", "u", "d", "d"]) {
        await page.keyboard.press(key);
        assert.deepEqual(await faults(page), [], key);
      }
      // A message for a moment, and the list of findings, opened.
      await page.keyboard.press("u");
      served.save(SCRIPT.replace("size)", "q)"));
      await until(page, () => document.querySelector(".diagnostics.has-errors:not(.folded)"));
      assert.deepEqual(await faults(page), [], "with an error");
      // Where there is no room for both panels one closes the other.
      for (const key of ["[", "]", "["]) {
        await page.keyboard.press(key);
        const isOpen = await page.$$eval(".panel:not([hidden])", (panels) => panels.map((panel) => panel.getBoundingClientRect()).map(({ left, right }) => [left, right]));
        if (isOpen.length === 2) assert.ok(isOpen[0][1] <= isOpen[1][0], "panels lie beside each other");
      }
      assert.deepEqual(page.faults, []);
      await page.close();
    } finally {
      served.end();
    }
  });
}

test("an empty window says so in its middle", { skip, timeout: 240_000 }, async () => {
  const served = await serve("");
  try {
    for (const size of SIZES) {
      const page = await newPage(size);
      await page.goto(served.url);
      await until(page, () => /nothing to draw/.test(document.querySelector(".greeting").textContent));
      assert.deepEqual(await faults(page), []);
      await page.close();
    }
  } finally {
    served.end();
  }
});
