// The worker that makes solids: loads manifold-3d, solves one request after the other. A newer request ends the
// older one at the next node.
import create from 'manifold-3d';
import wasm from 'manifold-3d/manifold.wasm';
import { Helper, kWorthSharing } from './solids/helper.ts';
import type { HelperWorker } from './solids/helper.ts';
import { hold } from './solids/lifeline.ts';
import { SolidKernel } from './solids/kernel.ts';
import { rehearse } from './solids/rehearsal.ts';
import type {
  ExpectRequest,
  ShareAnswer,
  ShareRequest,
  SolveRequest,
  WarmRequest,
  WorkerMessage,
} from './solids/protocol.ts';

const scope = globalThis as unknown as {
  name: string;
  postMessage(message: WorkerMessage | ShareAnswer, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<SolveRequest | ExpectRequest | ShareRequest | WarmRequest>) => void) | null;
};

/** The same program in a worker of this one, which ends with it. */
const helper =
  navigator.hardwareConcurrency > 1
    ? new Helper(() => new Worker(import.meta.url, { type: 'module' }) as unknown as HelperWorker)
    : null;

let memory: WebAssembly.Memory | null = null;

/** Ends the worker for the page, or for the first one. */
function rethrow(problem: unknown): void {
  setTimeout(() => {
    throw problem;
  });
}

/** Loads the library as it would itself, and keeps hold of its memory. */
async function instantiate(
  imports: WebAssembly.Imports,
  done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
): Promise<void> {
  const bytes = await (await fetch(new URL(wasm, import.meta.url))).arrayBuffer();
  const { instance, module } = await WebAssembly.instantiate(bytes, imports);
  memory = Object.values(instance.exports).find((each) => each instanceof WebAssembly.Memory) ?? null;
  done(instance, module);
}

// Its types do not tell of this option of every Emscripten program.
const load = create as unknown as (options: {
  instantiateWasm(
    imports: WebAssembly.Imports,
    done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ): object;
}) => ReturnType<typeof create>;
const loading = load({
  instantiateWasm(imports, done) {
    instantiate(imports, done).catch(rethrow);
    return {};
  },
});
const starting = loading.then((library) => {
  library.setup();
  return new SolidKernel(library, helper);
});
starting.then(() => scope.postMessage({ type: 'ready' }, []));

hold(scope.name, () => scope.postMessage({ type: 'alive' }, []));

let newest = 0,
  expected: number | null = null;
/** Something was asked for: nothing is warmed up any more. */
let isNeeded = false;
/** Ends the wait for the second worker. */
let interrupt = () => {};
let queue = Promise.resolve();

/** Lets messages in that have arrived meanwhile. */
const breathe = () =>
  new Promise<void>((resolve) => {
    const channel = new MessageChannel();
    channel.port1.onmessage = () => resolve();
    channel.port2.postMessage(null);
  });

async function solve(request: SolveRequest): Promise<void> {
  const kernel = await starting;
  if (request.id !== newest) {
    // Its meshes may be what a later request counts on.
    kernel.keepMeshes(request.meshes);
    scope.postMessage({ type: 'done', id: request.id, bytes: memory?.buffer.byteLength ?? 0 }, []);
    return;
  }
  const work = kernel.solve(request, (solved) => {
    const { node, ms, mesh, failure } = solved;
    const transfer = mesh
      ? [mesh.positions, mesh.uv, mesh.triangles, mesh.mergeFrom, mesh.mergeTo].map(
          (array) => array.buffer as ArrayBuffer,
        )
      : [];
    scope.postMessage(
      {
        type: 'solid',
        id: request.id,
        step: node.step,
        key: node.key,
        coarse: node.coarse,
        ms,
        ...(mesh ? { mesh } : {}),
        ...(failure ? { failure } : {}),
      },
      transfer,
    );
  });
  let told = -1;
  for (let step = work.next(); !step.done; step = work.next()) {
    const { done } = step.value;
    if (done > told) scope.postMessage({ type: 'progress', id: request.id, done }, []);
    told = Math.max(told, done);
    await breathe();
    if (request.id === newest && step.value.wait)
      await Promise.race([
        step.value.wait,
        new Promise<void>((resolve) => {
          interrupt = resolve;
        }),
      ]);
    if (request.id !== newest) {
      work.return();
      break;
    }
  }
  scope.postMessage({ type: 'done', id: request.id, bytes: memory?.buffer.byteLength ?? 0 }, []);
}

/** For whoever may ask for it, until somebody asks for something. */
async function makeLikely(request: SolveRequest): Promise<void> {
  const kernel = await starting;
  kernel.keepMeshes(request.meshes);
  const work = kernel.likely(request);
  while (request.id === newest && !work.next().done) await breathe();
  work.return();
  scope.postMessage({ type: 'done', id: request.id, bytes: memory?.buffer.byteLength ?? 0 }, []);
}

/** While nothing is asked for: what an edit of the expected part will need. */
async function workAhead(): Promise<void> {
  const kernel = await starting,
    request = newest,
    part = expected;
  for (const work = kernel.ahead(part); ;) {
    await breathe();
    if (request !== newest || part !== expected) {
      work.return();
      return;
    }
    if (work.next().done) return;
  }
}

async function unite(request: ShareRequest): Promise<void> {
  const union = (await starting).unite(request),
    { faces } = union ?? {};
  const arrays = faces
    ? [faces.vertProperties, faces.triVerts, faces.runIndex, faces.runOriginalID, faces.runTransform, faces.faceID]
    : [];
  scope.postMessage(
    { share: request.share, union },
    arrays.map((array) => array.buffer as ArrayBuffer),
  );
}

/** While nothing was asked for yet: makes itself quick. */
async function warmUp(): Promise<void> {
  await starting;
  for (const work = rehearse(await loading); ;) {
    await breathe();
    if (isNeeded) {
      work.return();
      return;
    }
    isNeeded = work.next().done === true;
    if (isNeeded) scope.postMessage({ type: 'warm' }, []);
  }
}

/** Large unions need a second worker, which loads while this one does. */
function isLarge({ meshes, nodes }: SolveRequest): boolean {
  return (
    nodes.some(({ kind, coarse }) => kind === 'join' && !coarse) &&
    Object.values(meshes).reduce((sum, { triangles }) => sum + triangles.length / 3, 0) >= kWorthSharing
  );
}

scope.onmessage = ({ data }) => {
  if ('warm' in data) {
    if (data.warm.large) helper?.warm();
    queue = queue.then(warmUp).catch(rethrow);
    return;
  }
  if ('share' in data) {
    isNeeded = true;
    queue = queue.then(() => unite(data)).catch(rethrow);
    return;
  }
  if ('expect' in data) {
    if (data.expect === expected) return;
    expected = data.expect;
  } else {
    const isWanted = data.wanted.length > 0;
    newest = data.id;
    isNeeded ||= isWanted;
    interrupt();
    if (isWanted && isLarge(data)) helper?.wake();
    queue = queue.then(() => (isWanted ? solve(data) : makeLikely(data)));
  }
  // What is thrown here ends the worker for the page, which starts another one.
  queue = queue.then(workAhead).catch(rethrow);
};
