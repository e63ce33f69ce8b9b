// The module against the native command: examples and golden programs say the same and write the same
// files, to the byte. WASM names the module, VIROTE the command. Of the golden programs one of three is tried, and none of
// the slowest; with ALL=1 all are.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, relative, resolve } from "node:path";
import { test } from "node:test";
import { open } from "../virote.mjs";

const root = resolve(import.meta.dirname, "../../..");
const wasm = process.env.WASM ?? join(root, "target/wasm32-unknown-unknown/page/virote_wasm.wasm");
const command = resolve(process.env.VIROTE ?? join(root, "target/release/virote"));
/** The ceilings of `Limits::WEB` that the command's differ from. */
const CEILINGS = ["nesting=128", "chain=250", "call-depth=160", "evaluation-depth=800", "value-depth=200"];
/** Where a message begins. */
const HEAD = /^\[[EW]\d{4}\] /;
/** What the command alone says when it writes files: which meshes it turned, and how far places are rounded. */
const OF_FILES = /^\[W0001\] Warning: (turned |the file has numbers of single precision)/;
/** Characters of a heading over a table. */
const HEADING = 60;
/** The slowest, which take the module as long as all others together. */
const SLOW = new Set([
  "approximation-keeps-its-tolerance.geo",
  "areas-and-volumes.geo",
  "areas-of-uneven-weights.geo",
  "bodies-on-one-surface.geo",
  "derivatives-of-solids-through-regions.geo",
  "gradients-agree-with-differences.geo",
  "gradients-through-geometry.geo",
  "integrals-over-areas.geo",
  "steep-waves-take-few-control-points.geo",
]);

/** All files below a folder, but for what tests expect. */
function filesBelow(folder, below = folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (!entry.isDirectory()) return /\.(out|rs|sh|md)$/.test(entry.name) ? [] : [relative(below, path)];
    return /\.golden$|^gallery$/.test(entry.name) ? [] : filesBelow(path, below);
  });
}

/** The files of a folder that a text names, and those that the scripts among them name. */
function filesNamed(text, folder, all) {
  const found = new Map();
  const texts = [text];
  for (let next = texts.pop(); next !== undefined; next = texts.pop()) {
    for (const path of all) {
      if (found.has(path) || !next.includes(path.split("/").at(-1))) continue;
      found.set(path, readFileSync(join(folder, path)));
      if (path.endsWith(".geo")) texts.push(found.get(path).toString());
    }
  }
  return found;
}

/** What the command said of a script of golden programs that writes nothing, as its tests hold it; else nothing. */
function golden(path) {
  if (!existsSync(path)) return null;
  const told = { "standard output": "", "standard error": "" };
  let section = null;
  for (const line of readFileSync(path, "utf8").split("\n")) {
    const title = /^--- (.*)$/.exec(line)?.[1];
    if (title?.startsWith("exit code ")) return { stdout: told["standard output"], stderr: told["standard error"] };
    if (title !== undefined) section = title;
    else if (section in told) told[section] += `${line}\n`;
    if (title !== undefined && !(title in told)) return null;
  }
  return null;
}

/** Whether two lists of messages are one. */
const areSame = (a, b) => a.length === b.length && a.every((message, i) => message === b[i]);

/** What the command says of a script, which it begins at once. */
function native(name, folder, out) {
  const limits = CEILINGS.flatMap((ceiling) => ["--limit", ceiling]);
  const told = { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 };
  return new Promise((done) => execFile(command, ["run", name, "--out", out, ...limits], told, (_, stdout, stderr) => done({ stdout, stderr })));
}

/** The messages in a text, but for how a ceiling is moved, which a page and the command do each in its own way. */
function messagesIn(text) {
  const found = [];
  let isInside = false;
  for (const line of text.split("\n").map((line) => line.trimEnd())) {
    if (HEAD.test(line)) found.push([]);
    isInside = HEAD.test(line) || (isInside && /^(\s|─|$)/.test(line));
    if (isInside && line !== "" && !/ Help( \d+)?: (the ceiling on|`--limit) /.test(line)) found.at(-1).push(line);
  }
  return found.map((lines) => lines.join("\n"));
}

/** The test over one of so many programs of a folder: one for each file of tests, which run side by side. */
export function testPrograms(below, everyNth = 1) {
  test(`programs of ${below} say and write the same as those of the command`, { skip: !existsSync(command) }, async () => {
    const module = new WebAssembly.Module(readFileSync(wasm));
    const folder = join(root, below);
    const all = filesBelow(folder);
    const programs = readdirSync(folder).filter((name) => name.endsWith(".geo"));
    const names = process.env.ALL ? programs : programs.filter((name, i) => i % everyNth === 0 && !SLOW.has(name));
    let [n_files, n_messages, n_asked] = [0, 0, 0];
    for (const name of names) {
      const text = readFileSync(join(folder, name), "utf8");
      // A byte order mark would be lost on the way through JavaScript's texts.
      if (/^\/\/ --/m.test(text) || text.startsWith("\ufeff")) continue;
      const out = mkdtempSync(join(tmpdir(), "virote-module-"));
      // Where the golden file agrees the command need not be asked; where a lower ceiling counts it is.
      const known = golden(join(folder, name.replace(/geo$/, "out")));
      const answer = known === null ? native(name, folder, out) : null;
      const virote = await open(module, 7);
      virote.ask({ call: "reset", name });
      for (const [path, bytes] of filesNamed(text, folder, all)) virote.ask({ call: "file", path }, [bytes]);
      const { value: state } = virote.ask({ call: "text", text });
      const hasErrors = state.diagnostics.some((found) => found.severity === "error");
      // A page alone tells, without a code, what it cannot draw.
      const messages = messagesIn(state.diagnostics.filter((found) => found.code !== null).map((found) => found.text).join("\n"));
      const expected = (stderr) => messagesIn(stderr).filter((message) => !OF_FILES.test(message));
      const isKnown = known !== null && areSame(messages, expected(known.stderr));
      const { stdout, stderr } = isKnown ? known : await (answer ?? native(name, folder, out));
      assert.deepEqual(messages, expected(stderr), `${name}: other messages`);
      n_asked += isKnown ? 0 : 1;
      n_messages += messages.length;
      for (const { text: source, value } of state.prints) {
        // The rows of a table are shown by the command alone, below a heading that is cut where it is long.
        const isTable = value.startsWith("table of ");
        const shown = isTable ? value.split(":")[0] : value;
        const heading = isTable && source.length > HEADING ? `${source.slice(0, HEADING)}…` : source;
        const line = shown === "" ? source : `${heading} = ${shown}`;
        assert.ok(stdout.includes(line), `${name} prints ${line}, not ${stdout}`);
      }
      if (!hasErrors && state.exports.length > 0) {
        const { value, attached } = virote.ask({ call: "export", what: "script" });
        const written = readdirSync(out, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
        assert.equal(value.files.length, written.length, name);
        value.files.forEach((path, i) => {
          assert.ok(Buffer.from(attached[i]).equals(readFileSync(join(out, path))), `${name}: ${path} differs`);
          n_files++;
        });
      }
      rmSync(out, { recursive: true });
    }
    console.log(`${names.length} programs, ${n_asked} of them by the command, ${n_files} files, ${n_messages} messages`);
    assert.ok(n_files > 5);
  });
}
