// The parts of the extension, one by one.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { command } from "./client.mjs";

const require = createRequire(import.meta.url);
const manifest = require("../package.json");
const { page, serve } = require("../src/preview.js");
const { taskArguments } = require("../src/tasks.js");

function scratch(text) {
  const folder = mkdtempSync(join(tmpdir(), "virote-"));
  const file = join(folder, "script.geo");
  writeFileSync(file, text);
  return { file, remove: () => rmSync(folder, { recursive: true }) };
}

test("the problem matcher reads what the command tells", () => {
  const [first, second] = manifest.contributes.problemMatchers[0].pattern;
  for (const [text, code, line] of [["let a = 1\nprint b\n", "E0201", "2"], ["\ncheck 1 > 2\n", "E1001", "2"]]) {
    const { file, remove } = scratch(text);
    const { stderr } = spawnSync(command, ["check", file], { encoding: "utf8" });
    const lines = stderr.split("\n");
    const at = lines.findIndex((one) => new RegExp(first.regexp).test(one));
    assert.notEqual(at, -1, stderr);
    assert.equal(lines[at].match(first.regexp)[first.code], code);
    const place = lines[at + 1].match(second.regexp);
    assert.deepEqual([place[second.file], place[second.line]], [file, line]);
    remove();
  }
});

test("each snippet is a script that runs", () => {
  const snippets = JSON.parse(readFileSync(new URL("../snippets/virote.json", import.meta.url), "utf8"));
  for (const [name, { body }] of Object.entries(snippets)) {
    const text = [body].flat().join("\n").replace(/\$\{\d+:([^}]*)\}/g, "$1");
    const { file, remove } = scratch(`${text}\n`);
    const { status, stderr } = spawnSync(command, ["check", file], { encoding: "utf8" });
    assert.equal(status, 0, `${name}: ${text}\n${stderr}`);
    remove();
  }
});

test("tasks are verbs of the command", () => {
  assert.deepEqual(taskArguments({ verb: "run", file: "a.geo" }), ["run", "a.geo"]);
  const { file, remove } = scratch("test \"sums\" { check 1 + 1 == 2 }\n");
  const { status } = spawnSync(command, taskArguments({ verb: "test", file }));
  assert.equal(status, 0);
  remove();
});

test("the panel shows the page of the viewer and nothing else", async (t) => {
  const { file, remove } = scratch("curve c = line((0, 0), (1, 0))\n");
  const viewer = serve(command, file);
  t.after(() => viewer.stop());
  const address = await viewer.address;
  const html = page(address);
  assert.ok(html.includes(`frame-src ${new URL(address).origin};`));
  const response = await fetch(address);
  assert.equal(response.status, 200);
  // The viewer lets itself be shown in a panel of the editor, and in no page.
  assert.equal(response.headers.get("x-frame-options"), null);
  assert.match(response.headers.get("content-security-policy"), /frame-ancestors 'self' vscode-webview: vscode-file:;/);
  remove();
  await assert.rejects(serve(join(tmpdir(), "no-such-command"), file).address);
});

test("the package holds what the manifest names", () => {
  const { stdout } = spawnSync("unzip", ["-l", new URL("../dist/virote.vsix", import.meta.url).pathname], { encoding: "utf8" });
  for (const path of ["package.json", "dist/extension.js", "syntaxes/virote.tmLanguage.json", "snippets/virote.json", "language-configuration.json"]) {
    assert.ok(stdout.includes(`extension/${path}`), `${path}: ${stdout}`);
  }
});
