// What the tests of the page share: the command, a folder for its script, and a browser.

import { spawn, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import puppeteer from "puppeteer-core";

const root = resolve(import.meta.dirname, "../..");
const WAIT = { timeout: 90_000 };

/** The command under test: VIROTE, or what lies in the target folder. */
export const command = [process.env.VIROTE, join(root, "target/debug/virote"), join(root, "target/release/virote")]
  .filter(Boolean)
  .map((path) => resolve(path))
  .find(existsSync);

/** The page comes from `dist`, whatever the command was built with. */
export const environment = { ...process.env, VIROTE_WEB: join(root, "web/dist") };

const chromium = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"]
  .filter(Boolean)
  .find(existsSync);

/** Why the tests cannot run here, or false. */
export const skip = chromium ? (command ? false : "there is no virote to test: set VIROTE") : "there is no Chromium: set CHROMIUM";

let browser;
export async function openBrowser() {
  browser = await puppeteer.launch({
    executablePath: chromium,
    headless: true,
    protocolTimeout: 300_000,
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--allow-file-access-from-files"],
  });
}

export async function closeBrowser() {
  await browser?.close();
}

/** An empty page; its errors are collected in `page.faults`. */
export async function newPage(size = { width: 1200, height: 700 }) {
  const page = await browser.newPage();
  page.setDefaultNavigationTimeout(WAIT.timeout);
  page.faults = [];
  page.on("pageerror", (fault) => page.faults.push(fault.message));
  page.on("console", (message) => {
    if (message.type() === "error" && !message.text().includes("Failed to load resource")) page.faults.push(message.text());
  });
  await page.setViewport(size);
  await page.emulateMediaFeatures([
    { name: "prefers-reduced-motion", value: "reduce" },
    { name: "prefers-color-scheme", value: "light" },
  ]);
  return page;
}

/** A page that has drawn its model. */
export async function openPage(url, size) {
  const page = await newPage(size);
  await page.goto(url);
  await page.waitForFunction(() => window.virote?.isReady, WAIT);
  return page;
}

/** Serves a script of this text, in a folder of its own, until `end` is called. */
export async function serve(text, more = []) {
  const folder = mkdtempSync(join(tmpdir(), "virote-page-"));
  const script = join(folder, "model.geo");
  writeFileSync(script, text);
  const served = await serveFile(script, more);
  return {
    ...served,
    folder,
    read: () => readFileSync(script, "utf8"),
    save: (next) => replace(script, next),
    end() {
      served.end();
      rmSync(folder, { recursive: true, force: true });
    },
  };
}

/** Puts a new text in the place of the old one at once, so that nobody reads half of it. */
export function replace(path, text) {
  writeFileSync(`${path}.new`, text);
  renameSync(`${path}.new`, path);
}

/** Serves the script of a path until `end` is called. */
export async function serveFile(path, more = []) {
  const script = resolve(path);
  const child = spawn(command, ["view", script, "--no-open", ...more], {
    cwd: dirname(script),
    env: environment,
  });
  const url = await new Promise((done, fail) => {
    let said = "";
    child.stdout.on("data", (bytes) => {
      said += bytes;
      const found = /http:\/\/\S+/.exec(said);
      if (found) done(found[0]);
    });
    child.on("exit", (code) => fail(new Error(`virote view ended with ${code}: ${said}`)));
  });
  return {
    url,
    script,
    process: child,
    end() {
      child.removeAllListeners("exit");
      child.kill();
    },
  };
}

/** What `virote run` prints of an expression that is put behind the script. */
export function evaluated(script, expression) {
  const run = spawnSync(command, ["run", "-"], { input: `${script}\nprint ${expression}\n`, encoding: "utf8" });
  const found = [...run.stdout.matchAll(/ = (.*)$/gm)].at(-1);
  if (!found) throw new Error(run.stdout + run.stderr);
  return found[1].replace(/[()]/g, "").split(",").map(Number);
}

/** Waits for a condition in the page, which is brought to the front because a hidden one draws nothing. */
export async function until(page, condition, ...values) {
  await page.bringToFront();
  await page.waitForFunction(condition, WAIT, ...values);
}

/** The colour of the picture at the pixel of a point of the model. */
export async function colorAt(page, point) {
  return page.evaluate((place) => window.virote.color(...window.virote.pixel(place)), point);
}

/** Puts the camera in front of the model, in parallel projection, at rest. */
export async function lookFromFront(page, height = 40) {
  await page.evaluate((size) => window.virote.look({ target: [0, 0, 0], azimuth: -90, elevation: 0, height: size }), height);
}
