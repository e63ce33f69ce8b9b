// The module against the native command: the same files, to the bit, for every example and golden
// program; ceilings instead of traps; the calls of an editor. WASM names the module, VIROTE the command.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, relative, resolve } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { open } from "../virote.mjs";
import { WALKS } from "./walks.mjs";

const root = resolve(import.meta.dirname, "../../..");
const wasm = process.env.WASM ?? join(root, "target/wasm32-unknown-unknown/release/virote_wasm.wasm");
const command = resolve(process.env.VIROTE ?? join(root, "target/release/virote"));
const bytes = readFileSync(wasm);
const module = new WebAssembly.Module(bytes);
/** The ceilings of `Limits::WEB` that the command's differ from. */
const CEILINGS = ["nesting=128", "chain=250", "call-depth=200", "evaluation-depth=1000", "value-depth=200"];

/** All files below a folder, but for what tests expect. */
function filesBelow(folder, below = folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (!entry.isDirectory()) return /\.(out|rs|sh|md)$/.test(entry.name) ? [] : [relative(below, path)];
    return /\.golden$|^gallery$/.test(entry.name) ? [] : filesBelow(path, below);
  });
}

/** A module with the files of a folder. */
async function withFiles(folder, name) {
  const virote = await open(module, 7);
  virote.ask({ call: "reset", name });
  for (const path of filesBelow(folder)) {
    if (statSync(join(folder, path)).size < 1 << 20) virote.ask({ call: "file", path }, [readFileSync(join(folder, path))]);
  }
  return virote;
}

test("the module is at most 3 MB compressed", () => {
  assert.ok(gzipSync(bytes, { level: 9 }).length <= 3_000_000);
});

for (const below of ["examples", "tests/golden"]) {
  test(`programs of ${below} say and write the same as those of the command`, { skip: !existsSync(command) }, async () => {
    const folder = join(root, below);
    const names = readdirSync(folder).filter((name) => name.endsWith(".geo"));
    let n_files = 0;
    for (const name of names) {
      const text = readFileSync(join(folder, name), "utf8");
      // A byte order mark would be lost on the way through JavaScript's texts.
      if (/^\/\/ --/m.test(text) || text.startsWith("\ufeff")) continue;
      const out = mkdtempSync(join(tmpdir(), "virote-module-"));
      const limits = CEILINGS.flatMap((ceiling) => ["--limit", ceiling]);
      const native = spawnSync(command, ["run", name, "--out", out, ...limits], { cwd: folder, encoding: "utf8" });
      const virote = await withFiles(folder, name);
      const { value: state } = virote.ask({ call: "text", text });
      const hasErrors = state.diagnostics.some((found) => found.severity === "error");
      assert.equal(hasErrors, native.stderr.includes("error"), `${name}: ${native.stderr} ${JSON.stringify(state.diagnostics)}`);
      for (const { text: source, value } of state.prints) {
        // The rows of a table are shown by the command alone.
        const told = value.startsWith("table of ") ? value.split(":")[0] : value;
        const line = told === "" ? source : `${source} = ${told}`;
        assert.ok(native.stdout.includes(line), `${name} prints ${line}, not ${native.stdout}`);
      }
      if (!hasErrors && state.exports.length > 0) {
        const { value, attached } = virote.ask({ call: "export", what: "script" });
        const written = filesBelow(out);
        assert.equal(value.files.length, written.length, name);
        value.files.forEach((path, i) => {
          assert.ok(Buffer.from(attached[i]).equals(readFileSync(join(out, path))), `${name}: ${path} differs`);
          n_files++;
        });
      }
      rmSync(out, { recursive: true });
    }
    console.log(`${names.length} programs, ${n_files} files`);
    assert.ok(n_files > 5);
  });
}

for (const [what, script] of Object.entries(WALKS)) {
  test(`${what} end at a ceiling, and the module lives on`, async () => {
    const virote = await open(module, 7);
    let first = null;
    for (const n of [50, 100, 190, 300, 490, 900, 3_000, 20_000]) {
      const { value: state } = virote.ask({ call: "text", text: script(n) });
      virote.ask({ call: "hover", line: 0, column: 4 });
      virote.ask({ call: "format" });
      if (state.diagnostics.length > 0) first ??= [n, state.diagnostics[0].code];
    }
    assert.ok(first !== null, "there is a ceiling");
    assert.equal(virote.ask({ call: "text", text: "print 1 + 1" }).value.prints[0].value, "2");
  });
}

test("the editor is helped, and mistakes are told at their places", async () => {
  const virote = await open(module, 7);
  const text = "param r = 2mm in 1mm..9mm\n/* 🫖 */ surface s = sphere((0, 0), radius)\nlet   b = r";
  const { value: broken } = virote.ask({ call: "text", text });
  assert.equal(broken.isCurrent, false);
  const [finding] = virote.ask({ call: "findings" }).value;
  assert.deepEqual(finding.range, { from: { line: 1, column: 36 }, to: { line: 1, column: 42 } });
  assert.match(virote.ask({ call: "hover", line: 2, column: 10 }).value.text, /2 mm/);
  assert.deepEqual(virote.ask({ call: "definition", line: 2, column: 10 }).value.from, { line: 0, column: 6 });
  assert.ok(virote.ask({ call: "complete", line: 2, column: 11 }).value.some((one) => one.label === "r"));
  assert.equal(virote.ask({ call: "signature", line: 1, column: 28 }).value[0].active, 0);
  assert.equal(virote.ask({ call: "format" }).value.length > 0, true);
  const { value: state } = virote.ask({ call: "text", text: text.replace("radius", "r") });
  assert.equal(state.isCurrent, true);
  const [item] = state.items;
  const area = virote.ask({ call: "measure", kind: "area", items: [item.key] }).value.value;
  assert.ok(Math.abs(area - 16 * Math.PI) < 1e-9, `${area}`);
  const { point } = virote.ask({ call: "ask", item: item.key, u: 0.1, v: 0.2 }).value;
  assert.ok(Math.abs(Math.hypot(...point) - 2) < 1e-12);
  assert.ok(virote.ask({ call: "items", items: [item.key] }).attached[0].length > 1000);
  const { value: set } = virote.ask({ call: "set", values: { r: "3mm" } });
  assert.equal(set.parameters[0].number, 3);
  assert.match(virote.ask({ call: "write", values: { r: "3mm" } }).value.text, /param r = 3mm/);
  assert.throws(() => virote.ask({ call: "nothing" }), /there is no call/);
  const { attached, value } = virote.ask({ call: "export", items: ["s"], file: "s.obj" });
  assert.deepEqual(value.files, ["s.obj"]);
  assert.match(new TextDecoder().decode(attached[0]), /^v /m);
});
