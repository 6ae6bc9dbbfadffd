// What the workers of the page have in common, on their side.

/** Ends the worker for the page, which starts another one. */
export function rethrow(problem: unknown): void {
  setTimeout(() => {
    throw problem;
  });
}

/** The bytes of a file of the site at an address relative to `base`. */
export async function bytesOf(file: string, base: string): Promise<ArrayBuffer> {
  return (await fetch(new URL(file, base))).arrayBuffer();
}

/** Lets messages in that have arrived meanwhile. */
export const breathe = () =>
  new Promise<void>((resolve) => {
    const channel = new MessageChannel();
    channel.port1.onmessage = () => resolve();
    channel.port2.postMessage(null);
  });
