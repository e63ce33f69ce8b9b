// The panel with a stand-in for the editor and the language server itself: text and page follow each other.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";
import protocol from "vscode-languageserver-protocol/node.js";
import { command, connect } from "./client.mjs";

const require = createRequire(import.meta.url);
const { Preview } = require("../src/preview.js");
const { definitionsAt, placeOf } = require("../src/cursor.js");

const TEXT = `let size = 10mm
curve rib = line((0, 0), (size, 0))
// between
curves ribs = [for size_of in 1..3:
    rib |> translate((0, size_of, 0))]
test "rib" { check length(rib) == size }
`;

/** The language server with a script of this text open. */
async function opened(t) {
  const folder = mkdtempSync(join(tmpdir(), "virote-"));
  t.after(() => rmSync(folder, { recursive: true }));
  const path = join(folder, "model.geo");
  writeFileSync(path, TEXT);
  const uri = pathToFileURL(path).href;
  const { connection, findings, close } = await connect(t);
  const item = { uri, languageId: "virote", version: 1, text: TEXT };
  await connection.sendNotification(protocol.DidOpenTextDocumentNotification.type, { textDocument: item });
  assert.deepEqual(await findings(uri, 1), []);
  return { path, uri, close, ask: (method, parameters) => connection.sendRequest(method, parameters) };
}

test("a place means the name there, then the definition around it", async (t) => {
  const { uri, ask, close } = await opened(t);
  const at = (line, character) => definitionsAt(ask, uri, { line, character });
  assert.deepEqual(await at(1, 8), ["rib"]);
  assert.deepEqual(await at(1, 27), ["size", "rib"]);
  assert.deepEqual(await at(2, 4), []);
  assert.deepEqual(await at(4, 6), ["rib", "ribs"]);
  assert.deepEqual(await at(4, 24), ["ribs"]);
  assert.deepEqual(await placeOf(ask, uri, "ribs"), { start: { line: 3, character: 7 }, end: { line: 3, character: 11 } });
  assert.equal(await placeOf(ask, uri, "gone"), undefined);
  assert.equal(await close(), 0);
});

/** As much of the editor as the panel uses, with what became of it. */
function standIn(path, uri) {
  const document = { languageId: "virote", isUntitled: false, uri: { fsPath: path, toString: () => uri } };
  const editor = { document, selection: { active: { line: 1, character: 8 } }, revealRange: (range) => revealed.push(range.start.line) };
  const revealed = [];
  const panels = [];
  let select;
  const waiting = [];
  const webview = () => {
    const panel = { posted: [], n_reveals: 0, reveal: () => panel.n_reveals++, dispose: () => panel.end() };
    panel.onDidDispose = (end) => (panel.end = end);
    panel.webview = {
      postMessage: (message) => (panel.posted.push(message), waiting.splice(0).forEach((look) => look())),
      onDidReceiveMessage: (hear) => (panel.hear = hear),
    };
    panels.push(panel);
    return panel;
  };
  class Range {
    constructor(a, b, c, d) {
      [this.start, this.end] = [{ line: a, character: b }, { line: c, character: d }];
    }
  }
  class Selection {
    constructor(anchor, active) {
      Object.assign(this, { anchor, active });
    }
  }
  const vscode = {
    Range,
    Selection,
    ViewColumn: { One: 1, Beside: -2 },
    TextEditorRevealType: { InCenterIfOutsideViewport: 2 },
    Uri: { parse: (text) => ({ toString: () => text }) },
    env: { asExternalUri: async (address) => address },
    window: {
      activeTextEditor: editor,
      visibleTextEditors: [editor],
      createWebviewPanel: webview,
      showErrorMessage: (text) => assert.fail(text),
      onDidChangeTextEditorSelection: (listener) => ((select = listener), { dispose: () => (select = undefined) }),
    },
  };
  /** Moves the cursor as somebody at the keyboard does, or the extension. */
  const move = (line, character) => {
    editor.selection = new Selection({ line, character }, { line, character });
    select({ textEditor: editor, selections: [editor.selection] });
  };
  /** The next message to the page. */
  const posted = async (panel) => {
    while (panel.posted.length === 0) await new Promise((look) => waiting.push(look));
    return panel.posted.shift();
  };
  return { vscode, document, editor, panels, revealed, move, posted };
}

const pause = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

test("the page selects what the cursor stands in, and the text reveals what is selected in the page", async (t) => {
  const { path, uri, ask, close } = await opened(t);
  const { vscode, document, editor, panels, revealed, move, posted } = standIn(path, uri);
  const preview = new Preview(vscode, () => command, ask);
  t.after(() => preview.dispose());

  await preview.show(document);
  const [panel] = panels;
  assert.match(panel.webview.html, /<iframe src="http:/);
  await pause(200);
  assert.deepEqual(panel.posted, [], "nobody listens yet");
  await panel.hear({ virote: "ready" });
  assert.deepEqual(await posted(panel), { virote: "select", definitions: ["rib"] });
  move(4, 24);
  move(4, 25);
  assert.deepEqual(await posted(panel), { virote: "select", definitions: ["ribs"] });

  await panel.hear({ virote: "selected", definition: "rib" });
  assert.deepEqual([editor.selection.active, revealed], [{ line: 1, character: 6 }, [1]]);
  // The editor tells that its cursor moved; the page, which began, is told nothing.
  move(1, 6);
  await pause(300);
  assert.deepEqual(panel.posted, []);
  await panel.hear({ virote: "selected", definition: "gone" });
  assert.deepEqual(revealed, [1]);

  // A lens shows its definition in the panel that is there.
  await preview.show(document, "ribs");
  assert.deepEqual(await posted(panel), { virote: "show", definitions: ["ribs"] });
  assert.deepEqual([panels.length, panel.n_reveals], [1, 1]);
  panel.dispose();
  move(1, 6);
  await pause(200);
  assert.deepEqual(panel.posted, []);

  // And begins one where there is none.
  await preview.show(document, "rib");
  await panels[1].hear({ virote: "ready" });
  assert.deepEqual(await posted(panels[1]), { virote: "show", definitions: ["rib"] });
  assert.equal(await close(), 0);
});
