// What a browser can do while it still reads the page's script: fetch and compile the module, and begin a worker.

/** What is under way for those who will want it. */
export interface Begun {
  readonly module: Promise<WebAssembly.Module>;
  /** Workers that nobody has yet. */
  readonly workers: Worker[];
}

declare global {
  interface Window {
    begun?: Begun;
  }
}

/** Begins, unless that is done. */
export function begin(): Begun {
  return (window.begun ??= underWay());
}

function underWay(): Begun {
  try {
    return { workers: [new Worker("worker.js")], module: fetchModule() };
  } catch (trouble) {
    // Where there are no workers. Whoever waits for the module is told.
    return { workers: [], module: Promise.reject(trouble) };
  }
}

/** Fetches and compiles the module; it lies compressed beside the page, whatever its server does. */
async function fetchModule(): Promise<WebAssembly.Module> {
  const response = await fetch("virote.wasm.gz");
  if (!response.ok) throw new Error(`virote.wasm.gz: ${response.status} ${response.statusText}`);
  // Some servers say themselves that it is compressed; then the browser has unpacked it already.
  const isUnpacked = response.headers.get("Content-Encoding") !== null;
  const body = isUnpacked ? response.body! : response.body!.pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compileStreaming(new Response(body, { headers: { "Content-Type": "application/wasm" } }));
}

// The page's script tells what went wrong; until it is there nobody listens.
begin().module.catch(() => {});
