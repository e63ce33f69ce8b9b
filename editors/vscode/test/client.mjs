// The protocol's own client from npm, over the streams of `virote lsp`.

import { spawn } from "node:child_process";
import protocol from "vscode-languageserver-protocol/node.js";

export const command = process.env.VIROTE;

/** Starts the server: a connection that is initialized, and what it told. */
export async function connect(t, options = {}) {
  const child = spawn(command, ["lsp"], { stdio: ["pipe", "pipe", "inherit"] });
  t.after(() => child.kill());
  const connection = protocol.createProtocolConnection(
    new protocol.StreamMessageReader(child.stdout),
    new protocol.StreamMessageWriter(child.stdin),
  );
  const told = [];
  const waiting = [];
  connection.onNotification(protocol.PublishDiagnosticsNotification.type, (params) => {
    told.push(params);
    waiting.splice(0).forEach((look) => look());
  });
  connection.onRequest(protocol.RegistrationRequest.type, () => {});
  connection.listen();
  const { capabilities } = await connection.sendRequest(protocol.InitializeRequest.type, {
    processId: process.pid,
    rootUri: null,
    capabilities: {},
    ...options,
  });
  await connection.sendNotification(protocol.InitializedNotification.type, {});
  /** The findings of a version of a document. */
  const findings = async (uri, version) => {
    for (;;) {
      const found = told.find((one) => one.uri === uri && one.version === version);
      if (found) return found.diagnostics;
      await new Promise((resolve) => waiting.push(resolve));
    }
  };
  const close = async () => {
    await connection.sendRequest(protocol.ShutdownRequest.type);
    await connection.sendNotification(protocol.ExitNotification.type);
    return new Promise((resolve) => child.once("exit", resolve));
  };
  return { connection, capabilities, findings, close };
}
