// The worker that makes solids: loads manifold-3d, solves one request after the other. A newer request ends the
// older one at the next node.
import create from 'manifold-3d';
import wasm from 'manifold-3d/manifold.wasm';
import { SolidKernel } from './solids/kernel.ts';
import type { SolveRequest, WorkerMessage } from './solids/protocol.ts';

const scope = globalThis as unknown as { postMessage(message: WorkerMessage, transfer: Transferable[]): void; onmessage: ((event: MessageEvent<SolveRequest>) => void) | null };

const loading = create({ locateFile: () => new URL(wasm, import.meta.url).href }).then((library) => {
  library.setup();
  return new SolidKernel(library);
});
loading.then(() => scope.postMessage({ type: 'ready' }, []));

let newest = 0;
let queue = Promise.resolve();

/** Lets messages in that have arrived meanwhile. */
const breathe = () => new Promise<void>((resolve) => {
  const channel = new MessageChannel();
  channel.port1.onmessage = () => resolve();
  channel.port2.postMessage(null);
});

async function solve(request: SolveRequest): Promise<void> {
  const kernel = await loading;
  if (request.id !== newest) {
    // Its meshes may be what a later request counts on.
    kernel.keepMeshes(request.meshes);
    scope.postMessage({ type: 'done', id: request.id }, []);
    return;
  }
  const work = kernel.solve(request, (solved) => {
    const { node, ms, mesh, failure } = solved;
    const transfer = mesh ? [mesh.positions, mesh.uv, mesh.triangles, mesh.mergeFrom, mesh.mergeTo].map((array) => array.buffer as ArrayBuffer) : [];
    scope.postMessage({ type: 'solid', id: request.id, step: node.step, key: node.key, coarse: node.coarse, ms, ...(mesh ? { mesh } : {}), ...(failure ? { failure } : {}) }, transfer);
  });
  for (let step = work.next(); !step.done; step = work.next()) {
    scope.postMessage({ type: 'progress', id: request.id, done: step.value.done }, []);
    await breathe();
    if (request.id !== newest) {
      work.return();
      break;
    }
  }
  scope.postMessage({ type: 'done', id: request.id }, []);
}

scope.onmessage = ({ data }) => {
  newest = data.id;
  queue = queue.then(() => solve(data));
};
