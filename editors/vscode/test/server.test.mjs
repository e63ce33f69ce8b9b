// The language server, driven by the protocol's own client.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";
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
  const { items } = await connection.sendRequest(protocol.CompletionRequest.type, { textDocument: document, position });
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

/** A script for every kind of request. */
const script = [
  "// One",
  "// and two.",
  "fn f(x, by = 2) = {",
  "    let y = x * by",
  "    y",
  "}",
  "fn g(x) = f(x) + 1",
  'curve rail = line((0, 0), (3, 4)) with (color = "red")',
  "let  a = g(1mm)",
  "check length(rail) < 6",
  'test "a" { check a == 3mm }',
  'test "ab" { check false }',
  "",
].join("\n");

test("every kind of request is answered", async (t) => {
  const { connection, findings, close } = await connect(t, {
    capabilities: { general: { markdown: { parser: "marked" } }, textDocument: { completion: { completionItem: { snippetSupport: true } } } },
  });
  const item = { uri, languageId: "virote", version: 1, text: script };
  await connection.sendNotification(protocol.DidOpenTextDocumentNotification.type, { textDocument: item });
  await findings(uri, 1);
  const at = (line, character) => ({ textDocument: document, position: { line, character } });
  const range = { start: { line: 0, character: 0 }, end: { line: 13, character: 0 } };
  const ask = (type, params) => connection.sendRequest(type, params);

  // A picture that takes longer than a hover waits comes with the next one.
  let hover;
  do hover = await ask(protocol.HoverRequest.type, at(7, 8));
  while (!hover.contents.value.includes("!["));
  assert.match(hover.contents.value, /length 5 mm\n\n!\[\]\(data:image\/png;base64,[A-Za-z0-9+/=]+\)$/);
  assert.ok(hover.contents.value.length < 20_000);
  const { items } = await ask(protocol.CompletionRequest.type, at(8, 10));
  assert.equal(items.find((one) => one.label === "g").textEdit.range.start.character, 9);
  const circle = { label: "circle", kind: protocol.CompletionItemKind.Function };
  assert.match((await ask(protocol.CompletionResolveRequest.type, circle)).documentation.value, /radius/);
  const help = await ask(protocol.SignatureHelpRequest.type, at(8, 11));
  assert.equal(help.signatures[0].label, "fn g(x)");

  const references = await ask(protocol.ReferencesRequest.type, { ...at(2, 3), context: { includeDeclaration: true } });
  assert.equal(references.length, 2);
  assert.equal((await ask(protocol.DocumentHighlightRequest.type, at(2, 3))).length, 2);
  const place = await ask(protocol.PrepareRenameRequest.type, at(2, 3));
  assert.deepEqual(place, { start: { line: 2, character: 3 }, end: { line: 2, character: 4 } });
  const symbols = await ask(protocol.DocumentSymbolRequest.type, { textDocument: document });
  assert.deepEqual(symbols.map((one) => one.name), ["f", "g", "rail", "a", "a", "ab"]);
  const found = await ask(protocol.WorkspaceSymbolRequest.type, { query: "rai" });
  assert.deepEqual(found.map((one) => one.name), ["rail"]);
  const [call] = await ask(protocol.CallHierarchyPrepareRequest.type, at(2, 3));
  const [incoming] = await ask(protocol.CallHierarchyIncomingCallsRequest.type, { item: call });
  assert.equal(incoming.from.name, "g");
  const [outgoing] = await ask(protocol.CallHierarchyOutgoingCallsRequest.type, { item: incoming.from });
  assert.equal(outgoing.to.name, "f");

  const folds = await ask(protocol.FoldingRangeRequest.type, { textDocument: document });
  assert.deepEqual(folds.map((one) => [one.startLine, one.endLine]), [[0, 1], [2, 5]]);
  const [selection] = await ask(protocol.SelectionRangeRequest.type, { textDocument: document, positions: [{ line: 6, character: 12 }] });
  assert.equal(selection.range.start.line, 6);
  const tokens = await ask(protocol.SemanticTokensRangeRequest.type, { textDocument: document, range: { ...range, end: { line: 1, character: 0 } } });
  assert.equal(tokens.data.length, 5);

  const options = { tabSize: 4, insertSpaces: true };
  const line = { start: { line: 8, character: 0 }, end: { line: 8, character: 3 } };
  for (const edits of [
    await ask(protocol.DocumentRangeFormattingRequest.type, { textDocument: document, range: line, options }),
    await ask(protocol.DocumentOnTypeFormattingRequest.type, { ...at(9, 0), ch: "\n", options }),
  ]) assert.deepEqual(edits.map((edit) => edit.range.start.line), [8]);

  const hints = await ask(protocol.InlayHintRequest.type, { textDocument: document, range });
  assert.ok(hints.some((one) => one.label === " = 3 mm") && hints.some((one) => / margin 1mm/.test(one.label)), JSON.stringify(hints));
  const lenses = await ask(protocol.CodeLensRequest.type, { textDocument: document });
  const run = lenses.filter((one) => one.command.title === "run");
  const told = await ask(protocol.ExecuteCommandRequest.type, run[0].command);
  assert.deepEqual(told, { passed: true, tests: [{ name: "a", verdict: "passed", reasons: [] }] });
  assert.deepEqual(await ask(protocol.DocumentLinkRequest.type, { textDocument: document }), []);
  const [color] = await ask(protocol.DocumentColorRequest.type, { textDocument: document });
  assert.deepEqual([color.color.red, color.color.green], [1, 0]);
  const [spelling] = await ask(protocol.ColorPresentationRequest.type, { textDocument: document, range: color.range, color: color.color });
  assert.equal(spelling.label, '"red"');

  // Beyond the text, and of what is not open.
  assert.equal(await ask(protocol.HoverRequest.type, at(999, 999)), null);
  assert.equal(await ask(protocol.HoverRequest.type, { ...at(0, 0), textDocument: { uri: "file:///nowhere/else.geo" } }), null);
  assert.equal(await close(), 0);
});

test("a definition is followed into a file, renamed there, and linked to", async (t) => {
  const folder = mkdtempSync(join(tmpdir(), "virote-client-"));
  t.after(() => rmSync(folder, { recursive: true }));
  writeFileSync(join(folder, "part.geo"), "let size = 3mm\n");
  const main = { uri: pathToFileURL(join(folder, "main.geo")).href };
  const { connection, findings, close } = await connect(t, { rootUri: pathToFileURL(folder).href });
  const item = { ...main, languageId: "virote", version: 1, text: 'import "part.geo"\nprint part.size\n' };
  await connection.sendNotification(protocol.DidOpenTextDocumentNotification.type, { textDocument: item });
  assert.deepEqual(await findings(main.uri, 1), []);
  const at = { textDocument: main, position: { line: 1, character: 12 } };
  const part = pathToFileURL(join(folder, "part.geo")).href;
  assert.equal((await connection.sendRequest(protocol.DefinitionRequest.type, at)).uri, part);
  const { changes } = await connection.sendRequest(protocol.RenameRequest.type, { ...at, newName: "width" });
  assert.deepEqual(Object.keys(changes).sort(), [main.uri, part]);
  const { items } = await connection.sendRequest(protocol.CompletionRequest.type, { ...at, position: { line: 1, character: 11 } });
  assert.deepEqual(items.map((one) => one.label), ["size"]);
  const [link] = await connection.sendRequest(protocol.DocumentLinkRequest.type, { textDocument: main });
  assert.equal(link.target, part);
  assert.equal(await close(), 0);
});
