// The solver of solids as the page has it: one worker, which is started when the first solid is asked for and again
// after it died or was stopped. Answers go to the engine as they come.
import type { ExpectRequest, SolidMesh, SolidNode, SolveRequest, WarmRequest, WorkerMessage } from './protocol.ts';

/** What the engine asks: {type: 'solve'}; addresses are of its memory, valid while the event is delivered. */
export interface SolveEvent {
  type: 'solve';
  id: number;
  meshes: { key: string; vertices: number; triangles: number; positions: number; uv: number; corners: number }[];
  nodes: SolidNode[];
  wanted: string[];
}

/** As much of a Worker as is needed, so that tests can stand in for it. */
export interface SolidWorker {
  onmessage: ((event: { data: WorkerMessage }) => void) | null;
  onerror: ((event: unknown) => void) | null;
  postMessage(message: SolveRequest | ExpectRequest | WarmRequest, transfer: Transferable[]): void;
  terminate(): void;
}

export interface SolverHost {
  start(): SolidWorker;
  /** Floats and whole numbers of the engine's memory, copied. */
  floats(address: number, count: number): Float32Array;
  integers(address: number, count: number): Uint32Array;
  /** Hands an answer on; see web/app/solid_work.h. */
  answer(json: string, bytes: Uint8Array | null): void;
}

/** How many meshes the worker is counted on to still have. */
const kKnownRequests = 8;

export class Solver {
  private worker: SolidWorker | null = null;
  private asked: number | null = null;
  /** Meshes that the worker has, and the request that last named them. */
  private readonly known = new Map<string, number>();
  private requests = 0;
  private bytes = 0;
  private expected: number | null = null;
  private wasStarted = false;

  constructor(private readonly host: SolverHost) {}

  get isBusy(): boolean {
    return this.asked !== null;
  }

  /** Memory that the worker had grown to when it last answered; 0 without one. */
  get memory(): number {
    return this.worker ? this.bytes : 0;
  }

  /** Called while the event is delivered: what is not copied now may be gone. */
  ask(event: SolveEvent): void {
    this.requests += 1;
    for (const [key, request] of this.known) if (request + kKnownRequests < this.requests) this.known.delete(key);
    const meshes: SolveRequest['meshes'] = {},
      transfer: Transferable[] = [];
    for (const mesh of event.meshes) {
      if (!this.known.has(mesh.key) || !this.worker) {
        const data = {
          positions: this.host.floats(mesh.positions, 3 * mesh.vertices),
          uv: mesh.uv === 0 ? new Float32Array() : this.host.floats(mesh.uv, 2 * mesh.vertices),
          triangles: this.host.integers(mesh.corners, 3 * mesh.triangles),
        };
        meshes[mesh.key] = data;
        transfer.push(
          data.positions.buffer as ArrayBuffer,
          data.uv.buffer as ArrayBuffer,
          data.triangles.buffer as ArrayBuffer,
        );
      }
      this.known.set(mesh.key, this.requests);
    }
    this.asked = event.id;
    try {
      this.worker ??= this.start();
      this.worker.postMessage({ id: event.id, nodes: event.nodes, wanted: event.wanted, meshes }, transfer);
    } catch {
      this.lost();
    }
  }

  /** The part that is likely to be edited next, or null: a worker with nothing to do makes ready for it. */
  expect(part: number | null): void {
    this.expected = part;
    this.worker?.postMessage({ expect: part }, []);
  }

  /**
   * A solid is likely to be asked for soon, a large union where `large`: the worker starts and makes itself quick. Not
   * after one has died or was stopped: the next is started by a request.
   */
  warm(large: boolean): void {
    if (this.asked !== null || (!this.worker && this.wasStarted)) return;
    try {
      this.worker ??= this.start();
      this.worker.postMessage({ warm: { large } }, []);
    } catch {
      this.lost();
    }
  }

  /** Ends what the worker is at; the next request starts a fresh one. */
  stop(): void {
    this.asked = null;
    this.drop();
  }

  private start(): SolidWorker {
    const worker = this.host.start();
    this.wasStarted = true;
    worker.onmessage = ({ data }) => this.take(data);
    worker.onerror = () => {
      if (this.worker === worker) this.lost();
    };
    worker.postMessage({ expect: this.expected }, []);
    return worker;
  }

  private drop(): void {
    const { worker } = this;
    this.worker = null;
    this.known.clear();
    if (!worker) return;
    worker.onmessage = worker.onerror = null;
    worker.terminate();
  }

  private lost(): void {
    const id = this.asked;
    this.stop();
    if (id !== null) this.host.answer(JSON.stringify({ id, lost: true }), null);
  }

  private take(message: WorkerMessage): void {
    if (message.type === 'ready' || message.type === 'alive' || message.type === 'warm') return;
    if (message.type === 'solid') {
      const { mesh, ...rest } = message;
      this.host.answer(
        JSON.stringify({ ...rest, ...(mesh ? { mesh: headOf(mesh) } : {}) }),
        mesh ? packed(mesh) : null,
      );
      return;
    }
    if (message.type === 'done') {
      this.bytes = message.bytes;
      if (message.id === this.asked) this.asked = null;
      this.host.answer(JSON.stringify({ id: message.id, done: true }), null);
      return;
    }
    this.host.answer(JSON.stringify({ id: message.id, progress: message.done }), null);
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
