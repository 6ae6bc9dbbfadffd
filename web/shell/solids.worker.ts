// The worker that makes solids: loads manifold-3d and the engine's test for meshes that go through themselves, and
// solves one request after the other. A newer request ends the older one at the next node.
import create from 'manifold-3d';
import manifoldFile from 'manifold-3d/manifold.wasm';
import selfCrossingFile from 'spineloft/self_crossing.wasm';
import { hold } from './lifeline.ts';
import { SolidKernel } from './solids/kernel.ts';
import type { Solved } from './solids/kernel.ts';
import type { ExpectRequest, SolveRequest, WorkerMessage } from './solids/protocol.ts';
import { loadSelfCrossing } from './solids/self_crossing.ts';
import { breathe, bytesOf, rethrow } from './worker_side.ts';

const scope = globalThis as unknown as {
  name: string;
  postMessage(message: WorkerMessage, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<SolveRequest | ExpectRequest>) => void) | null;
};

let memory: WebAssembly.Memory | null = null;

type Started = (instance: WebAssembly.Instance, module: WebAssembly.Module) => void;

/** Loads the library as it would itself, and keeps hold of its memory. */
async function instantiate(imports: WebAssembly.Imports, done: Started): Promise<void> {
  const { instance, module } = await WebAssembly.instantiate(await bytesOf(manifoldFile, import.meta.url), imports);
  memory = Object.values(instance.exports).find((each) => each instanceof WebAssembly.Memory) ?? null;
  done(instance, module);
}

// Its types do not tell of this option of every Emscripten program.
const load = create as unknown as (options: {
  instantiateWasm(imports: WebAssembly.Imports, done: Started): object;
}) => ReturnType<typeof create>;

async function start(): Promise<SolidKernel> {
  const [library, selfCrossing] = await Promise.all([
    load({
      instantiateWasm(imports, done) {
        instantiate(imports, done).catch(rethrow);
        return {};
      },
    }),
    bytesOf(selfCrossingFile, import.meta.url).then(loadSelfCrossing),
  ]);
  library.setup();
  return new SolidKernel(library, selfCrossing);
}

const starting = start();
starting.then(() => scope.postMessage({ type: 'ready' }, [])).catch(rethrow);

hold(scope.name, () => scope.postMessage({ type: 'alive' }, []));

let newest = 0,
  expected: number | null = null;
let queue = Promise.resolve();

function postSolid(id: number, { node, ms, mesh, failure }: Solved): void {
  const arrays = mesh ? [mesh.positions, mesh.uv, mesh.triangles, mesh.mergeFrom, mesh.mergeTo] : [];
  scope.postMessage(
    {
      type: 'solid',
      id,
      step: node.step,
      key: node.key,
      coarse: node.coarse,
      ms,
      ...(mesh ? { mesh } : {}),
      ...(failure ? { failure } : {}),
    },
    arrays.map((array) => array.buffer as ArrayBuffer),
  );
}

async function solve(request: SolveRequest): Promise<void> {
  const kernel = await starting,
    { id } = request;
  if (id === newest) {
    for (const done of kernel.solve(request, (solved) => postSolid(id, solved))) {
      scope.postMessage({ type: 'progress', id, done }, []);
      await breathe();
      if (id !== newest) break;
    }
  } else {
    // Its meshes may be what a later request counts on.
    kernel.keepMeshes(request.meshes);
  }
  scope.postMessage({ type: 'done', id, bytes: memory?.buffer.byteLength ?? 0 }, []);
}

/** While nothing is asked for: what an edit of the expected part will need. */
async function workAhead(): Promise<void> {
  const kernel = await starting,
    request = newest,
    part = expected,
    work = kernel.ahead(part);
  do await breathe();
  while (request === newest && part === expected && !work.next().done);
  work.return();
}

scope.onmessage = ({ data }) => {
  if ('expect' in data) {
    if (data.expect === expected) return;
    expected = data.expect;
  } else {
    newest = data.id;
    queue = queue.then(() => solve(data));
  }
  queue = queue.then(workAhead).catch(rethrow);
};
