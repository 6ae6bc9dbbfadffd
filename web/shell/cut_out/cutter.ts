// What cuts things out of pictures, as the page has it: one worker. What is asked for is the engine's to know (CutOutWork
// in web/model); answers go to it as they come.
import { LiveWorker } from '../live_worker.ts';
import type { WorkerLike } from '../live_worker.ts';
import type { CutMessage, CutPicture, CutRequest, CutStop } from './protocol.ts';

/** What the engine asks; the arrays are its own, and theirs only while it asks. */
export interface CutEvent {
  id: number;
  hints: Float64Array;
  /** Equal keys, equal pictures. */
  key: string;
  picture: CutPicture;
}

export type CutWorker = WorkerLike<CutRequest | CutStop, CutMessage>;

/** Kinds of answers as numbers of the C++ side: platform::CutAnswer. */
const kKind = { progress: 0, found: 1, stopped: 2, unreachable: 3 } as const;

export interface CutAnswer {
  id: number;
  kind: number;
  done: number;
  found: Float64Array | null;
}

export interface CutterHost {
  start(): CutWorker;
  /** Hands an answer on; see CutOutWork::take. */
  answer(answer: CutAnswer): void;
}

export class Cutter {
  private readonly worker: LiveWorker<CutRequest | CutStop, CutMessage>;
  /** The request whose end is waited for; 0: none. */
  private asked = 0;
  /** The picture that the worker has. */
  private shown: string | null = null;
  private bytes = 0;

  constructor(private readonly host: CutterHost) {
    this.worker = new LiveWorker({
      start: () => host.start(),
      take: (message) => this.take(message),
      lost: (isLoaded) => this.lost(isLoaded),
    });
  }

  /** Memory that the worker had grown to when it last answered; 0 without one. */
  get memory(): number {
    return this.worker.isRunning ? this.bytes : 0;
  }

  /** Called while the engine asks: what is not copied now may be gone. */
  ask({ id, hints: theirs, key, picture: whole }: CutEvent): void {
    this.asked = id;
    const hints = theirs.slice(),
      picture = key === this.shown ? null : { ...whole, rgba: whole.rgba.slice() };
    this.shown = key;
    const arrays = [hints, ...(picture ? [picture.rgba] : [])];
    this.worker.ask(
      { id, hints, picture },
      arrays.map((array) => array.buffer as ArrayBuffer),
    );
  }

  /** A cut-out is likely to be asked for soon. */
  start(): void {
    this.worker.start();
  }

  /** Nobody waits any more; the worker stays, with its picture. */
  stop(): void {
    this.asked = 0;
    this.worker.tell({ stop: true });
  }

  private lost(isLoaded: boolean): void {
    const id = this.asked,
      kind = isLoaded ? kKind.stopped : kKind.unreachable;
    this.asked = 0;
    this.shown = null;
    // Not from within a call of the engine.
    if (id !== 0) queueMicrotask(() => this.host.answer({ id, kind, done: 0, found: null }));
  }

  private take(message: CutMessage): void {
    if (message.type === 'found') {
      const { id, found, bytes } = message;
      this.bytes = bytes;
      if (id === this.asked) this.asked = 0;
      this.host.answer({ id, kind: kKind.found, done: 1, found });
    } else if (message.type === 'progress') {
      const { id, done } = message;
      this.host.answer({ id, kind: kKind.progress, done, found: null });
    }
  }
}
