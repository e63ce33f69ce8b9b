// A script in the address: JSON, deflated, in the letters that an address may hold.

export interface Shared {
  name: string;
  text: string;
  /** Values of parameters that are set beside the script. */
  values?: Record<string, string>;
  /** Files that it reads, in base64. */
  files?: Record<string, string>;
}

/** So much may a link unpack to, in bytes. */
const MOST_BYTES = 16 << 20;
const MARK = "script=";

/** The fragment of an address that holds a script. */
export async function fragmentOf(shared: Shared): Promise<string> {
  const bytes = new TextEncoder().encode(JSON.stringify(shared));
  const packed = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  return MARK + base64(new Uint8Array(await new Response(packed).arrayBuffer())).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** The script that a fragment holds, or null where it holds none. Fails with a sentence where it is damaged. */
export async function sharedIn(fragment: string): Promise<Shared | null> {
  if (!fragment.startsWith(MARK)) return null;
  let found: unknown;
  try {
    const packed = bytesOf(fragment.slice(MARK.length).replaceAll("-", "+").replaceAll("_", "/"));
    found = JSON.parse(await unpacked(packed));
  } catch {
    throw new Error("the link is damaged: part of it may be missing");
  }
  if (!isShared(found)) throw new Error("the link holds no script");
  return found;
}

async function unpacked(packed: Uint8Array<ArrayBuffer>): Promise<string> {
  const reader = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let n_bytes = 0;
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    n_bytes += part.value.length;
    if (n_bytes > MOST_BYTES) throw new Error("too large");
    parts.push(part.value);
  }
  return new Blob(parts).text();
}

function isShared(found: unknown): found is Shared {
  const { name, text, values = {}, files = {} } = (found ?? {}) as Partial<Shared>;
  const areTexts = (all: unknown): boolean => typeof all === "object" && all !== null && Object.values(all).every((one) => typeof one === "string");
  return typeof name === "string" && name !== "" && typeof text === "string" && areTexts(values) && areTexts(files);
}

export function base64(bytes: Uint8Array): string {
  let letters = "";
  for (let i = 0; i < bytes.length; i += 0x8000) letters += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(letters);
}

export function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}
