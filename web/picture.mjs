// Pictures of the window, as a person sees it: `node picture.mjs SCRIPT.geo PICTURE.png [COMMAND-ID …]`.
// The commands are those of the tool bar (data-command) or of the analyses (data-shade), carried out in turn.

import { closeBrowser, openBrowser, openPage, serveFile } from "./test/harness.mjs";

const [script, picture, ...commands] = process.argv.slice(2);
if (!picture) throw new Error("node picture.mjs SCRIPT.geo PICTURE.png [COMMAND …]");
await openBrowser();
const served = await serveFile(script);
try {
  const page = await openPage(served.url);
  await page.emulateMediaFeatures([
    { name: "prefers-reduced-motion", value: "reduce" },
    { name: "prefers-color-scheme", value: "light" },
  ]);
  for (const command of commands) await page.click(`[data-command="${command}"], [data-shade="${command}"]`);
  await page.mouse.move(0, 0);
  await page.evaluate(() => new Promise((done) => setTimeout(done, 500)));
  await page.screenshot({ path: picture });
  if (page.faults.length > 0) throw new Error(page.faults.join("\n"));
} finally {
  served.end();
  await closeBrowser();
}
