// The language server, driven by the protocol's own client.

import assert from "node:assert/strict";
import test from "node:test";
import protocol from "vscode-languageserver-protocol/node.js";
import { connect } from "./client.mjs";

const uri = "file:///nowhere/main.geo";
const text = "/// How wide. 🫖\nlet width = 27.2mm\nprint /* 🫖 */ widht\n";
const document = { uri };

test("a document is opened, mended by its hint, asked about and formatted", async (t) => {
  const { connection, capabilities, findings, close } = await connect(t);
  assert.equal(capabilities.positionEncoding, "utf-16");
  const item = { uri, languageId: "virote", version: 1, text };
  await connection.sendNotification(protocol.DidOpenTextDocumentNotification.type, { textDocument: item });
  const [found] = await findings(uri, 1);
  assert.equal(found.code, "E0201");
  assert.deepEqual(found.range, { start: { line: 2, character: 15 }, end: { line: 2, character: 20 } });

  const [action] = await connection.sendRequest(protocol.CodeActionRequest.type, {
    textDocument: document,
    range: found.range,
    context: { diagnostics: [found] },
  });
  const [edit] = action.edit.changes[uri];
  assert.equal(edit.newText, "width");
  await connection.sendNotification(protocol.DidChangeTextDocumentNotification.type, {
    textDocument: { uri, version: 2 },
    contentChanges: [{ range: edit.range, text: edit.newText }],
  });
  assert.deepEqual(await findings(uri, 2), []);

  const position = { line: 2, character: 16 };
  const hover = await connection.sendRequest(protocol.HoverRequest.type, { textDocument: document, position });
  assert.match(hover.contents.value, /27\.2 mm\n\nHow wide\. 🫖$/);
  const items = await connection.sendRequest(protocol.CompletionRequest.type, { textDocument: document, position });
  assert.equal(items.find((one) => one.label === "width").detail, "27.2 mm");
  const target = await connection.sendRequest(protocol.DefinitionRequest.type, { textDocument: document, position });
  assert.deepEqual(target.range.start, { line: 1, character: 4 });
  const renamed = await connection.sendRequest(protocol.RenameRequest.type, { textDocument: document, position, newName: "w" });
  assert.equal(renamed.changes[uri].length, 2);
  const tokens = await connection.sendRequest(protocol.SemanticTokensRequest.type, { textDocument: document });
  assert.equal(tokens.data.length % 5, 0);
  const lens = await connection.sendRequest(protocol.CodeLensRequest.type, { textDocument: document });
  assert.deepEqual(lens, []);
  const edits = await connection.sendRequest(protocol.DocumentFormattingRequest.type, {
    textDocument: document,
    options: { tabSize: 4, insertSpaces: true },
  });
  assert.deepEqual(edits, []);
  await assert.rejects(connection.sendRequest("textDocument/noSuchThing", {}), { code: -32601 });
  assert.equal(await close(), 0);
});
