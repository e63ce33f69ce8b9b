// The module by itself: ceilings instead of traps, the calls of an editor. WASM names it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { open } from "../virote.mjs";
import { WALKS } from "./walks.mjs";

const root = resolve(import.meta.dirname, "../../..");
const wasm = process.env.WASM ?? join(root, "target/wasm32-unknown-unknown/page/virote_wasm.wasm");
const module = new WebAssembly.Module(readFileSync(wasm));

for (const [what, script] of Object.entries(WALKS)) {
  test(`${what} end at a ceiling, and the module lives on`, async () => {
    const virote = await open(module, 7);
    // What runs often is compiled anew, and may take more of the stack then.
    for (let i = 0; i < 200; i++) {
      assert.deepEqual(virote.ask({ call: "text", text: script(10 + (i % 30)) }).value.diagnostics, []);
    }
    await new Promise((done) => setTimeout(done, 100));
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
  assert.match(virote.ask({ call: "page", name: "circle" }).value, /radius/);
  assert.equal(virote.ask({ call: "page", name: "nothing" }).value, null);
  const words = virote.ask({ call: "tokens" }).value.filter((one) => one.range.from.line === 1);
  assert.deepEqual(words.map((one) => one.kind), ["comment", "keyword", "variable", "operator", "function", "number", "number"]);
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
  // A text that is only looked at changes nothing of what is shown.
  virote.ask({ call: "edit", text: "let other = 1\nlet b = o" });
  assert.ok(virote.ask({ call: "complete", line: 1, column: 9 }).value.some((one) => one.label === "other"));
  assert.equal(virote.ask({ call: "state" }).value.version, set.version);
  assert.throws(() => virote.ask({ call: "nothing" }), /there is no call/);
  const { attached, value } = virote.ask({ call: "export", items: ["s"], file: "s.obj" });
  assert.deepEqual(value.files, ["s.obj"]);
  assert.match(new TextDecoder().decode(attached[0]), /^v /m);
});
