// Pictures of the window, as a person sees it: `node picture.mjs SCRIPT.geo PICTURE.png [COMMAND …]`.
// COMMANDs are buttons of the tool bar (data-command) or of the analyses (data-shade), pressed one after another, or
// `key:` and a key. The picture of the README: `node picture.mjs ../examples/bottle.geo ../docs/view.png grid zebra`.

import { closeBrowser, openBrowser, openPage, serveFile } from "./test/harness.mjs";

const [script, picture, ...commands] = process.argv.slice(2);
if (!picture) throw new Error("node picture.mjs SCRIPT.geo PICTURE.png [COMMAND …]");
await openBrowser();
const served = await serveFile(script);
try {
  const page = await openPage(served.url, { width: 1080, height: 660 });
  for (const command of commands) {
    if (command.startsWith("key:")) await page.keyboard.press(command.slice(4));
    else await page.click(`[data-command="${command}"], [data-shade="${command}"]`);
  }
  await page.mouse.move(0, 0);
  await page.waitForFunction(() => window.virote.isReady);
  await page.evaluate(() => new Promise((done) => setTimeout(done, 500)));
  await page.waitForFunction(() => window.virote.isSmooth);
  await page.screenshot({ path: picture });
  if (page.faults.length > 0) throw new Error(page.faults.join("\n"));
} finally {
  served.end();
  await closeBrowser();
}
