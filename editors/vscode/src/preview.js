// The panel that shows `virote view` beside the text: the page of the viewer in a frame. What the cursor
// stands in is selected there, and what is selected there is revealed in the text.

"use strict";

const { spawn } = require("node:child_process");
const { randomBytes } = require("node:crypto");
const { createServer } = require("node:net");
const readline = require("node:readline");
const { definitionsAt, placeOf } = require("./cursor");

/** Milliseconds for which the cursor rests before the page follows it. */
const REST = 80;

/** A port of this machine that nobody uses. */
const freePort = () =>
  new Promise((resolve, reject) => {
    const server = createServer();
    server.once("error", reject);
    server.listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });

/**
 * Starts `virote view` for a script: the address of its page, and what ends it. `outside` tells under which address the person's
 * machine reaches one of this machine, which may be another.
 */
function serve(command, file, outside = async (address) => address) {
  let child;
  let isStopped = false;
  const begin = async () => {
    const port = await freePort();
    const here = `http://127.0.0.1:${port}/`;
    const [origin] = (await outside(here)).split("?");
    if (isStopped) throw new Error("the viewer ended");
    const reached = origin === here ? [] : ["--origin", origin];
    child = spawn(command, ["view", "--no-open", "--port", `${port}`, ...reached, file], { stdio: ["ignore", "pipe", "pipe"] });
    let trouble = "";
    child.stderr.on("data", (text) => (trouble += text));
    return new Promise((resolve, reject) => {
      readline.createInterface({ input: child.stdout }).once("line", resolve);
      child.once("error", reject);
      child.once("exit", () => reject(new Error(trouble.trim() || "the viewer ended")));
    });
  };
  const stop = () => {
    isStopped = true;
    child?.kill();
  };
  return { address: begin(), stop };
}

/** The panel's own page: a frame with that of the viewer, and what hands messages through. */
function page(address) {
  const { origin } = new URL(address);
  const nonce = randomBytes(16).toString("hex");
  return `<!doctype html>
<html>
  <head>
    <meta charset="utf-8">
    <meta http-equiv="Content-Security-Policy" content="default-src 'none'; frame-src ${origin}; script-src 'nonce-${nonce}'; style-src 'unsafe-inline'">
    <style>html, body, iframe { margin: 0; padding: 0; border: 0; width: 100%; height: 100vh; overflow: hidden; }</style>
  </head>
  <body>
    <script nonce="${nonce}">
      const editor = acquireVsCodeApi();
      addEventListener("message", ({ source, data }) => {
        const viewer = document.querySelector("iframe")?.contentWindow;
        if (source === viewer) editor.postMessage(data);
        else viewer?.postMessage(data, "${origin}");
      });
    </script>
    <iframe src="${address.replaceAll("&", "&amp;").replaceAll('"', "&quot;")}" allow="clipboard-write"></iframe>
  </body>
</html>`;
}

/** The panel of one script. */
class Panel {
  constructor(vscode, ask, document, panel, viewer) {
    Object.assign(this, { vscode, ask, document, panel, viewer });
    /** What the page is to show as soon as it listens. */
    this.wish = null;
    this.isListening = false;
    /** The definition that page and text agree upon. */
    this.shared = null;
    panel.webview.onDidReceiveMessage((message) => this.hear(message));
  }

  /** Has the page select the first of these definitions that the model has. */
  send(wish) {
    [this.shared] = wish.definitions;
    if (this.isListening) this.panel.webview.postMessage(wish);
    else this.wish = wish;
  }

  /** Has the page select what the cursor stands in. */
  async follow(position) {
    const definitions = await definitionsAt(this.ask, this.document.uri.toString(), position).catch(() => []);
    if (definitions.length > 0 && definitions[0] !== this.shared) this.send({ virote: "select", definitions });
  }

  async hear({ virote, definition }) {
    if (virote === "ready") {
      // It says so anew after each reload.
      this.isListening = true;
      if (this.wish) this.panel.webview.postMessage(this.wish);
      this.wish = null;
    } else if (virote === "selected") {
      this.shared = definition;
      await this.reveal(definition);
    }
  }

  /** Puts the cursor onto a definition; the panel keeps the focus. */
  async reveal(definition) {
    const { vscode, document } = this;
    const place = await placeOf(this.ask, document.uri.toString(), definition).catch(() => undefined);
    if (!place) return;
    const isOfScript = (editor) => editor.document.uri.toString() === document.uri.toString();
    const editor =
      vscode.window.visibleTextEditors.find(isOfScript) ??
      (await vscode.window.showTextDocument(document, { viewColumn: vscode.ViewColumn.One, preserveFocus: true }));
    const { start, end } = place;
    const range = new vscode.Range(start.line, start.character, end.line, end.character);
    editor.selection = new vscode.Selection(range.start, range.start);
    editor.revealRange(range, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
  }
}

class Preview {
  /** `command` names the command `virote`; `ask` sends a request to the language server. */
  constructor(vscode, command, ask) {
    this.vscode = vscode;
    this.command = command;
    this.ask = ask;
    /** Panels by the path of the script. */
    this.open = new Map();
    this.rest = undefined;
    this.following = vscode.window.onDidChangeTextEditorSelection(({ textEditor, selections }) => {
      const panel = this.open.get(textEditor.document.uri.fsPath);
      clearTimeout(this.rest);
      if (panel) this.rest = setTimeout(() => panel.follow(selections[0].active), REST);
    });
  }

  /** Shows a script, and in it this definition or else what the cursor stands in. */
  async show(document, definition) {
    const { vscode } = this;
    if (document?.languageId !== "virote") return;
    if (document.isUntitled) {
      vscode.window.showWarningMessage("Only a file can be shown: save it first.");
      return;
    }
    const file = document.uri.fsPath;
    const known = this.open.get(file);
    known?.panel.reveal(undefined, true);
    const panel = known ?? this.begin(document, file);
    if (definition) panel.send({ virote: "show", definitions: [definition] });
    else if (!known) {
      const editor = vscode.window.activeTextEditor;
      if (editor?.document === document) void panel.follow(editor.selection.active);
    }
    if (known) return;
    try {
      panel.panel.webview.html = page(await panel.viewer.address);
    } catch (error) {
      // Whoever closed the panel needs no message.
      if (this.open.get(file) !== panel) return;
      panel.panel.dispose();
      vscode.window.showErrorMessage(`\`virote view\` does not start: ${error.message}`);
    }
  }

  /** A panel for a script, and its viewer. */
  begin(document, file) {
    const { vscode } = this;
    const webview = vscode.window.createWebviewPanel(
      "virote.preview",
      `Model of ${file.split(/[\\/]/).pop()}`,
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true },
    );
    const outside = async (address) => (await vscode.env.asExternalUri(vscode.Uri.parse(address))).toString(true);
    const viewer = serve(this.command(), file, outside);
    const panel = new Panel(vscode, this.ask, document, webview, viewer);
    this.open.set(file, panel);
    webview.onDidDispose(() => {
      viewer.stop();
      this.open.delete(file);
    });
    return panel;
  }

  dispose() {
    clearTimeout(this.rest);
    this.following.dispose();
    for (const { panel } of [...this.open.values()]) panel.dispose();
  }
}

module.exports = { Preview, page, serve };
