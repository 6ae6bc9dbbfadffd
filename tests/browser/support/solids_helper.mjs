// The second worker of solids as a thread of Node; see web/shell/solids/helper.ts.
import { Worker, isMainThread, parentPort } from 'node:worker_threads';
import { library, shell } from './solids.mjs';

if (!isMainThread && parentPort) {
  const kernel = new shell.SolidKernel(library);
  parentPort.on('message', (request) => parentPort.postMessage({ share: request.share, union: kernel.unite(request) }));
  parentPort.postMessage({ ready: true });
}

/** A helper whose thread is ready; `stop` ends it. */
export async function startHelper() {
  const thread = new Worker(new URL(import.meta.url));
  await new Promise((resolve) => {
    thread.once('message', resolve);
  });
  const stand = {
    onmessage: null,
    onerror: null,
    postMessage: (message) => thread.postMessage(message),
    terminate: () => {
      void thread.terminate();
    },
  };
  thread.on('message', (data) => stand.onmessage?.({ data }));
  thread.on('error', () => stand.onerror?.(new Event('error')));
  return new shell.Helper(() => stand);
}
