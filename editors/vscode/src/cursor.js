// Definitions of a script and places in its text, as the language server knows them.

"use strict";

/** Whether a range of the protocol holds a position. */
function holds({ start, end }, { line, character }) {
  const isBehind = line > start.line || (line === start.line && character >= start.character);
  const isBefore = line < end.line || (line === end.line && character <= end.character);
  return isBehind && isBefore;
}

const isSame = (a, b) => a.line === b.line && a.character === b.character;

/**
 * The names of the definitions that a place of a document means, the likeliest first: what the name
 * there stands for, then the definition around it. `ask` sends a request to the server.
 */
async function definitionsAt(ask, uri, position) {
  const textDocument = { uri };
  const [target, symbols] = await Promise.all([
    ask("textDocument/definition", { textDocument, position }),
    ask("textDocument/documentSymbol", { textDocument }),
  ]);
  const isMeant = (one) => target?.uri === uri && isSame(target.range.start, one.selectionRange.start);
  const meant = (symbols ?? []).filter(isMeant);
  const around = (symbols ?? []).filter((one) => holds(one.range, position));
  return [...new Set([...meant, ...around].map(({ name }) => name))];
}

/** The place of a definition's name in a document; none where it defines no such name. */
async function placeOf(ask, uri, definition) {
  const symbols = await ask("textDocument/documentSymbol", { textDocument: { uri } });
  return symbols?.find(({ name }) => name === definition)?.selectionRange;
}

module.exports = { definitionsAt, placeOf };
