// The worker: one module, which answers call after call until it is ended.

import { open, Refusal, type Virote } from "../../wasm/virote.mjs";
import type { FromWorker, ToWorker } from "./machine";

const scope = self as unknown as {
  onmessage: (event: MessageEvent<ToWorker>) => void;
  postMessage(message: FromWorker, transfer: Transferable[]): void;
};
let take: (virote: Promise<Virote>) => void;
/** The module may come after the first calls. */
const opened = new Promise<Virote>((done) => (take = done));

function answered(virote: Virote, { id, head, parts }: Extract<ToWorker, { id: number }>): FromWorker {
  try {
    const { value, attached } = virote.ask(head, parts);
    return { id, value, attached: attached.map((part) => part.buffer as ArrayBuffer) };
  } catch (trouble) {
    const message = trouble instanceof Error ? trouble.message : String(trouble);
    return trouble instanceof Refusal ? { id, refusal: message } : { fault: message };
  }
}

scope.onmessage = ({ data }) => {
  if ("module" in data) {
    const virote = open(data.module, data.process);
    virote.catch((trouble: unknown) => scope.postMessage({ fault: String(trouble) }, []));
    take(virote);
    return;
  }
  void opened.then((virote) => {
    const answer = answered(virote, data);
    scope.postMessage(answer, "attached" in answer ? answer.attached : []);
  }, () => {});
};
