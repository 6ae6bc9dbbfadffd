// The solver of solids as the page has it: one worker, which is started when a solid is likely to be asked for and
// again, by a request, after it died or was stopped. What is asked for is the engine's to know (SolidWork in web);
// answers go to it as they come.
import type { ExpectRequest, MeshData, SolidMesh, SolidNode, SolveRequest, WorkerMessage } from './protocol.ts';

/** What the engine asks; meshes are its own arrays, and theirs only while it asks. */
export interface SolveEvent {
  id: number;
  meshes: { key: string; mesh: MeshData }[];
  nodes: SolidNode[];
  wanted: string[];
}

/** As much of a Worker as is needed, so that tests can stand in for it. */
export interface SolidWorker {
  onmessage: ((event: { data: WorkerMessage }) => void) | null;
  onerror: ((event: unknown) => void) | null;
  postMessage(message: SolveRequest | ExpectRequest, transfer: Transferable[]): void;
  terminate(): void;
}

export interface SolverHost {
  start(): SolidWorker;
  /** Hands an answer on; see SolidWork::take. */
  answer(json: string, bytes: Uint8Array | null): void;
}

/** How many requests long the worker is counted on to still have a mesh. */
const kKnownRequests = 8;

export class Solver {
  private worker: SolidWorker | null = null;
  /** Meshes that the worker has, and the request that last named them. */
  private readonly known = new Map<string, number>();
  private requests = 0;
  private bytes = 0;
  private expected: number | null = null;
  private wasStarted = false;
  /** The worker has loaded all that it needs. */
  private isLoaded = false;

  constructor(private readonly host: SolverHost) {}

  /** Memory that the worker had grown to when it last answered; 0 without one. */
  get memory(): number {
    return this.worker ? this.bytes : 0;
  }

  /** Called while the engine asks: what is not copied now may be gone. */
  ask({ id, nodes, wanted, meshes: named }: SolveEvent): void {
    this.requests += 1;
    for (const [key, request] of this.known) if (request + kKnownRequests < this.requests) this.known.delete(key);
    const meshes: SolveRequest['meshes'] = {};
    for (const { key, mesh } of named) {
      if (!this.known.has(key) || !this.worker)
        meshes[key] = { positions: mesh.positions.slice(), uv: mesh.uv.slice(), triangles: mesh.triangles.slice() };
      this.known.set(key, this.requests);
    }
    const arrays = Object.values(meshes).flatMap(({ positions, uv, triangles }) => [positions, uv, triangles]);
    try {
      this.worker ??= this.started();
      this.worker.postMessage(
        { id, nodes, wanted, meshes },
        arrays.map((array) => array.buffer as ArrayBuffer),
      );
    } catch {
      this.lost();
    }
  }

  /** The part that is likely to be edited next, or null: a worker with nothing to do makes ready for it. */
  expect(part: number | null): void {
    this.expected = part;
    this.worker?.postMessage({ expect: part }, []);
  }

  /** A solid is likely to be asked for soon. What died or was stopped is started by a request alone. */
  start(): void {
    if (this.wasStarted) return;
    try {
      this.worker = this.started();
    } catch {
      // The first request tries again, and says so.
    }
  }

  /** Ends what the worker is at; the next request starts a fresh one. */
  stop(): void {
    const { worker } = this;
    this.worker = null;
    this.known.clear();
    if (!worker) return;
    worker.onmessage = worker.onerror = null;
    worker.terminate();
  }

  private started(): SolidWorker {
    const worker = this.host.start();
    this.wasStarted = true;
    this.isLoaded = false;
    worker.onmessage = ({ data }) => this.take(data);
    worker.onerror = () => {
      if (this.worker === worker) this.lost();
    };
    worker.postMessage({ expect: this.expected }, []);
    return worker;
  }

  private lost(): void {
    this.stop();
    this.host.answer(JSON.stringify({ lost: true, loaded: this.isLoaded }), null);
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
      case 'ready':
        this.isLoaded = true;
        break;
      default: // it is alive
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
