// A second worker for the worker of solids: large unions are halved in space, and each makes one half.
import { inWorld } from './rooms.ts';
import type { MeshData, PartOperand, ShareAnswer, SharedUnion, ShareRequest, WarmRequest } from './protocol.ts';

/** Fewer triangles are united sooner by one. */
export const kWorthSharing = 12000;
/** A worker that has had nothing to do for so long, in ms, is let go with its memory. */
const kIdle = 20000;
/** The same for one that was started because it is likely to be needed. */
const kExpected = 60000;
/** One that takes so long is not waited for. */
const kPatience = 10000;

/** As much of a Worker as is needed, so that tests can stand in for it. */
export interface HelperWorker {
  onmessage: ((event: { data: Partial<ShareAnswer> }) => void) | null;
  onerror: ((event: { preventDefault(): void }) => void) | null;
  postMessage(message: ShareRequest | WarmRequest): void;
  terminate(): void;
}

export class Helper {
  private worker: HelperWorker | null = null;
  private asked: { share: number; answer: (union: SharedUnion | null) => void } | null = null;
  private shares = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly start: () => HelperWorker,
    private readonly patience = kPatience,
  ) {}

  get isFree(): boolean {
    return this.asked === null;
  }

  /** Starts the worker, where it is not there, and has it make itself quick. */
  warm(): void {
    if (this.worker) return;
    this.wake();
    this.in(kExpected);
    this.worker!.postMessage({ warm: { large: false } });
  }

  /** Starts the worker, where it is not there. */
  wake(): void {
    if (this.worker) return;
    const worker = this.start();
    worker.onmessage = ({ data }) => {
      if (data.share !== undefined && data.share === this.asked?.share) this.take(data.union ?? null);
    };
    worker.onerror = (event) => {
      // Its end is not the end of this one.
      event.preventDefault();
      this.stop();
    };
    this.worker = worker;
    this.in(kIdle);
  }

  /** The union of these; null where it cannot be had, for whatever reason. */
  unite(operands: PartOperand[], meshes: Record<string, MeshData>): Promise<SharedUnion | null> {
    return new Promise((resolve) => {
      const share = (this.shares += 1);
      this.asked = { share, answer: resolve };
      try {
        this.wake();
        this.in(this.patience);
        this.worker!.postMessage({ share, operands, meshes });
      } catch {
        this.stop();
      }
    });
  }

  /** Lets the worker go; what it was at is not had. */
  stop(): void {
    clearTimeout(this.timer);
    const { worker } = this;
    this.worker = null;
    if (worker) {
      worker.onmessage = worker.onerror = null;
      worker.terminate();
    }
    this.take(null);
  }

  private in(ms: number): void {
    clearTimeout(this.timer);
    // In two steps: while the first worker was at its own half nothing came in, and it is no fault of the second one.
    this.timer = setTimeout(() => {
      this.timer = setTimeout(() => this.stop(), ms / 2);
    }, ms / 2);
  }

  private take(union: SharedUnion | null): void {
    const { asked } = this;
    this.asked = null;
    if (this.worker) this.in(kIdle);
    asked?.answer(union);
  }
}

/** Operands in two halves of about as many triangles, which lie side by side. */
export function halvesOf(
  operands: PartOperand[],
  meshOf: (operand: PartOperand) => MeshData,
): [PartOperand[], PartOperand[]] {
  const all = operands.map((operand) => ({
    operand,
    count: meshOf(operand).triangles.length,
    at: middleOf(operand, meshOf(operand)),
  }));
  const spread = [0, 1, 2].map(
      (k) => Math.max(...all.map(({ at }) => at[k]!)) - Math.min(...all.map(({ at }) => at[k]!)),
    ),
    axis = spread.indexOf(Math.max(...spread));
  all.sort((a, b) => a.at[axis]! - b.at[axis]!);
  const half = all.reduce((sum, { count }) => sum + count, 0) / 2,
    first: PartOperand[] = [],
    second: PartOperand[] = [];
  let sum = 0;
  for (const { operand, count } of all) {
    (sum + count / 2 < half ? first : second).push(operand);
    sum += count;
  }
  return [first, second];
}

/** The middle of all vertices, world. */
function middleOf({ matrix }: PartOperand, { positions }: MeshData): number[] {
  const sum = [0, 0, 0];
  for (let i = 0; i < positions.length; i += 1) sum[i % 3]! += positions[i]!;
  return inWorld(matrix, sum.map((each) => (3 * each) / positions.length) as [number, number, number]);
}
