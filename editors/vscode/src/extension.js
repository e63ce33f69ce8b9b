// The extension: starts `virote lsp`, runs scripts as tasks, and shows `virote view` beside the text.

"use strict";

const vscode = require("vscode");
const { LanguageClient, State } = require("vscode-languageclient/node");
const { Preview } = require("./preview");
const { taskArguments } = require("./tasks");

let client;
let preview;

/** The command `virote` as the settings name it. */
const command = () => vscode.workspace.getConfiguration("virote").get("path", "virote");

const settings = () => {
  const { inlayHints, codeLens, hover } = vscode.workspace.getConfiguration("virote");
  return { inlayHints, codeLens, hover };
};

/** Commands of the server; what it would show in a browser is shown beside the text. */
async function executeCommand(command, parameters, next) {
  if (command !== "virote.openView") return next(command, parameters);
  const [address, definition] = parameters;
  const document = await vscode.workspace.openTextDocument(vscode.Uri.parse(address));
  return preview.show(document, definition);
}

async function start() {
  const server = { command: command(), args: ["lsp"] };
  client = new LanguageClient("virote", "Virote", server, {
    documentSelector: [{ language: "virote" }],
    initializationOptions: settings(),
    middleware: { executeCommand },
    synchronize: { configurationSection: "virote", fileEvents: vscode.workspace.createFileSystemWatcher("**/*") },
  });
  try {
    await client.start();
  } catch (error) {
    const choice = await vscode.window.showErrorMessage(
      `\`${server.command} lsp\` does not start: ${error?.message ?? error} Is virote installed, and is \`virote.path\` right?`,
      "Settings",
    );
    if (choice) vscode.commands.executeCommand("workbench.action.openSettings", "virote.path");
  }
}

async function stop() {
  if (client && client.state !== State.Stopped) await client.stop();
}

function task(definition, scope) {
  const execution = new vscode.ShellExecution(command(), taskArguments(definition));
  const name = `${definition.verb} ${definition.file ?? ""}`.trim();
  return new vscode.Task(definition, scope ?? vscode.TaskScope.Workspace, name, "virote", execution, "$virote");
}

const tasks = {
  provideTasks: () => {
    const file = vscode.window.activeTextEditor?.document;
    const path = file?.languageId === "virote" ? vscode.workspace.asRelativePath(file.uri) : undefined;
    const own = path ? ["run", "check", "test", "watch"].map((verb) => task({ type: "virote", verb, file: path })) : [];
    return [...own, task({ type: "virote", verb: "test" })];
  },
  resolveTask: (known) => task(known.definition, known.scope),
};

async function runScript() {
  const document = vscode.window.activeTextEditor?.document;
  if (document?.languageId !== "virote") return;
  await document.save();
  const file = vscode.workspace.asRelativePath(document.uri);
  await vscode.tasks.executeTask(task({ type: "virote", verb: "run", file }));
}

exports.activate = async (context) => {
  preview = new Preview(vscode, command, (method, parameters) => client.sendRequest(method, parameters));
  context.subscriptions.push(
    preview,
    vscode.tasks.registerTaskProvider("virote", tasks),
    vscode.commands.registerCommand("virote.preview", () => preview.show(vscode.window.activeTextEditor?.document)),
    vscode.commands.registerCommand("virote.run", runScript),
    vscode.commands.registerCommand("virote.restart", async () => {
      await stop();
      await start();
    }),
  );
  await start();
};

exports.deactivate = stop;
