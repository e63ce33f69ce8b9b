// The module as JavaScript calls it: messages of JSON with attachments (src/playground has them).

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** Where the next attachment begins. */
const aligned = (place) => Math.ceil(place / 8) * 8;

/** What was refused, as a sentence for the person; anything else that is thrown is the end of the module. */
export class Refusal extends Error {}

/** A playground out of a compiled module; `process` tells the keys of its items from those of others. */
export async function open(module, process) {
  const { exports } = await WebAssembly.instantiate(module, { page: { now: () => performance.now() } });
  exports.begin(process);

  /** Asks, and gives the answer with copies of its attachments; throws a Refusal where there is none. */
  function ask(head, parts = []) {
    const json = encoder.encode(JSON.stringify({ ...head, parts: parts.map((part) => part.length) }));
    let length = 4 + json.length;
    const places = parts.map((part) => {
      const start = aligned(length);
      length = start + part.length;
      return start;
    });
    // Memory that grows is another buffer: each call comes before the view of it.
    const room = exports.make_room(length) >>> 0;
    const message = new Uint8Array(exports.memory.buffer, room, length);
    new DataView(message.buffer, message.byteOffset).setUint32(0, json.length, true);
    message.set(json, 4);
    parts.forEach((part, i) => message.set(part, places[i]));
    const at = exports.answer() >>> 0;
    const answer = new Uint8Array(exports.memory.buffer, at, exports.answer_length());
    let end = 4 + new DataView(answer.buffer, at).getUint32(0, true);
    const value = JSON.parse(decoder.decode(answer.slice(4, end)));
    if (value?.error !== undefined) throw new Refusal(value.error);
    const attached = (value?.parts ?? []).map((size) => {
      const start = aligned(end);
      end = start + size;
      return answer.slice(start, end);
    });
    return { value, attached };
  }
  return { ask, memory: () => exports.memory.buffer.byteLength };
}
