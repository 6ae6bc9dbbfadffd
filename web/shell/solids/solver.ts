// The solver of solids as the page has it: one worker. What is asked for is the engine's to know (SolidWork in web);
// answers go to it as they come.
import { LiveWorker } from '../live_worker.ts';
import type { WorkerLike } from '../live_worker.ts';
import type { ExpectRequest, MeshData, SolidMesh, SolidNode, SolveRequest, WorkerMessage } from './protocol.ts';

/** What the engine asks; meshes are its own arrays, and theirs only while it asks. */
export interface SolveEvent {
  id: number;
  meshes: { key: string; mesh: MeshData }[];
  nodes: SolidNode[];
  wanted: string[];
}

export type SolidWorker = WorkerLike<SolveRequest | ExpectRequest, WorkerMessage>;

export interface SolverHost {
  start(): SolidWorker;
  /** Hands an answer on; see SolidWork::take. */
  answer(json: string, bytes: Uint8Array | null): void;
}

/** How many requests long the worker is counted on to still have a mesh. */
const kKnownRequests = 8;

export class Solver {
  private readonly worker: LiveWorker<SolveRequest | ExpectRequest, WorkerMessage>;
  /** Meshes that the worker has, and the request that last named them. */
  private readonly known = new Map<string, number>();
  private requests = 0;
  private bytes = 0;
  private expected: number | null = null;

  constructor(private readonly host: SolverHost) {
    this.worker = new LiveWorker({
      start: () => host.start(),
      started: (worker) => worker.postMessage({ expect: this.expected }, []),
      take: (message) => this.take(message),
      lost: (isLoaded) => {
        this.known.clear();
        host.answer(JSON.stringify({ lost: true, loaded: isLoaded }), null);
      },
    });
  }

  /** Memory that the worker had grown to when it last answered; 0 without one. */
  get memory(): number {
    return this.worker.isRunning ? this.bytes : 0;
  }

  /** Called while the engine asks: what is not copied now may be gone. */
  ask({ id, nodes, wanted, meshes: named }: SolveEvent): void {
    this.requests += 1;
    for (const [key, request] of this.known) if (request + kKnownRequests < this.requests) this.known.delete(key);
    const meshes: SolveRequest['meshes'] = {};
    for (const { key, mesh } of named) {
      if (!this.known.has(key))
        meshes[key] = { positions: mesh.positions.slice(), uv: mesh.uv.slice(), triangles: mesh.triangles.slice() };
      this.known.set(key, this.requests);
    }
    const arrays = Object.values(meshes).flatMap(({ positions, uv, triangles }) => [positions, uv, triangles]);
    this.worker.ask(
      { id, nodes, wanted, meshes },
      arrays.map((array) => array.buffer as ArrayBuffer),
    );
  }

  /** The part that is likely to be edited next, or null: a worker with nothing to do makes ready for it. */
  expect(part: number | null): void {
    this.expected = part;
    this.worker.tell({ expect: part });
  }

  /** A solid is likely to be asked for soon. */
  start(): void {
    this.worker.start();
  }

  /** Ends what the worker is at; the next request starts a fresh one. */
  stop(): void {
    this.known.clear();
    this.worker.stop();
  }

  private take(message: WorkerMessage): void {
    switch (message.type) {
      case 'solid': {
        const { mesh, ...rest } = message;
        const head = mesh ? { mesh: headOf(mesh) } : {};
        this.host.answer(JSON.stringify({ ...rest, ...head }), mesh ? packed(mesh) : null);
        break;
      }
      case 'done':
        this.bytes = message.bytes;
        this.host.answer(JSON.stringify({ id: message.id, done: true }), null);
        break;
      case 'progress':
        this.host.answer(JSON.stringify({ id: message.id, progress: message.done }), null);
        break;
    }
  }
}

function headOf({ positions, triangles, mergeFrom, runs, volume, area, genus }: SolidMesh): Record<string, unknown> {
  return {
    vertices: positions.length / 3,
    triangles: triangles.length / 3,
    merges: mergeFrom.length,
    runs,
    volume,
    area,
    genus,
  };
}

function packed(mesh: SolidMesh): Uint8Array {
  const arrays = [mesh.positions, mesh.uv, mesh.triangles, mesh.mergeFrom, mesh.mergeTo];
  const bytes = new Uint8Array(arrays.reduce((sum, array) => sum + array.byteLength, 0));
  let at = 0;
  for (const array of arrays) {
    bytes.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), at);
    at += array.byteLength;
  }
  return bytes;
}
