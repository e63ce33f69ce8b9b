// The panel that shows `virote view` beside the text: the page of the viewer in a frame.

"use strict";

const { spawn } = require("node:child_process");
const readline = require("node:readline");

/** Starts `virote view` for a script: the address of its page, and what ends it. */
function serve(command, file) {
  const child = spawn(command, ["view", "--no-open", file], { stdio: ["ignore", "pipe", "pipe"] });
  let trouble = "";
  child.stderr.on("data", (text) => (trouble += text));
  const address = new Promise((resolve, reject) => {
    readline.createInterface({ input: child.stdout }).once("line", resolve);
    child.once("error", reject);
    child.once("exit", () => reject(new Error(trouble.trim() || "the viewer ended")));
  });
  return { address, stop: () => child.kill() };
}

/** The panel's own page: a frame with that of the viewer. */
function page(address) {
  const origin = new URL(address).origin;
  return `<!doctype html>
<html>
  <head>
    <meta charset="utf-8">
    <meta http-equiv="Content-Security-Policy" content="default-src 'none'; frame-src ${origin}; style-src 'unsafe-inline'">
    <style>html, body, iframe { margin: 0; padding: 0; border: 0; width: 100%; height: 100vh; overflow: hidden; }</style>
  </head>
  <body><iframe src="${address.replaceAll("&", "&amp;").replaceAll('"', "&quot;")}" allow="clipboard-write"></iframe></body>
</html>`;
}

class Preview {
  constructor(vscode, command) {
    this.vscode = vscode;
    this.command = command;
    /** Panels with their viewers, by the path of the script. */
    this.open = new Map();
  }

  async show(document) {
    const { vscode } = this;
    if (document?.languageId !== "virote") return;
    if (document.isUntitled) {
      vscode.window.showWarningMessage("Only a file can be shown: save it first.");
      return;
    }
    const file = document.uri.fsPath;
    const known = this.open.get(file);
    if (known) {
      known.panel.reveal(undefined, true);
      return;
    }
    const title = `Model of ${file.split(/[\\/]/).pop()}`;
    const panel = vscode.window.createWebviewPanel(
      "virote.preview",
      title,
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true },
    );
    const viewer = serve(this.command(), file);
    this.open.set(file, { panel, viewer });
    panel.onDidDispose(() => {
      viewer.stop();
      this.open.delete(file);
    });
    try {
      const outside = await vscode.env.asExternalUri(vscode.Uri.parse(await viewer.address));
      panel.webview.html = page(outside.toString(true));
    } catch (error) {
      panel.dispose();
      vscode.window.showErrorMessage(`\`virote view\` does not start: ${error.message}`);
    }
  }

  dispose() {
    for (const { panel } of [...this.open.values()]) panel.dispose();
  }
}

module.exports = { Preview, page, serve };
