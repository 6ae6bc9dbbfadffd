// A worker that the page keeps: started by the first request or when one is likely, and again, by a request, after it died
// or was stopped.

/** As much of a Worker as is needed, so that tests can stand in for it. */
export interface WorkerLike<Request, Message> {
  onmessage: ((event: { data: Message }) => void) | null;
  onerror: ((event: unknown) => void) | null;
  postMessage(message: Request, transfer: Transferable[]): void;
  terminate(): void;
}

/** What every worker says, besides its answers. */
export type LifeMessage =
  /** It has loaded all that it needs. */
  | { type: 'ready' }
  /** It holds the lock that ends with it (lifeline.ts). */
  | { type: 'alive' };

export interface Owner<Request, Message> {
  start(): WorkerLike<Request, Message>;
  /** A worker was started: it may be told something before it is asked. */
  started?(worker: WorkerLike<Request, Message>): void;
  take(message: Message): void;
  /** It died or could not be started; whether it had loaded all that it needs. */
  lost(isLoaded: boolean): void;
}

export class LiveWorker<Request, Message extends { type: string }> {
  private worker: WorkerLike<Request, Message> | null = null;
  private wasStarted = false;
  private isLoaded = false;

  constructor(private readonly owner: Owner<Request, Message>) {}

  get isRunning(): boolean {
    return this.worker !== null;
  }

  /** Starts it where it does not run. */
  ask(request: Request, transfer: Transferable[]): void {
    try {
      this.worker ??= this.started();
      this.worker.postMessage(request, transfer);
    } catch {
      this.lost();
    }
  }

  /** Says something to a worker that runs. */
  tell(message: Request): void {
    this.worker?.postMessage(message, []);
  }

  /** It is likely to be asked soon. What died or was stopped is started by a request alone. */
  start(): void {
    if (this.wasStarted) return;
    try {
      this.worker = this.started();
    } catch {
      // The first request tries again, and says so.
    }
  }

  /** Ends what it is at. */
  stop(): void {
    const { worker } = this;
    this.worker = null;
    if (!worker) return;
    worker.onmessage = worker.onerror = null;
    worker.terminate();
  }

  private started(): WorkerLike<Request, Message> {
    this.isLoaded = false;
    const worker = this.owner.start();
    this.wasStarted = true;
    worker.onmessage = ({ data }) => {
      if (data.type === 'ready') this.isLoaded = true;
      else if (data.type !== 'alive') this.owner.take(data);
    };
    worker.onerror = () => {
      if (this.worker === worker) this.lost();
    };
    this.owner.started?.(worker);
    return worker;
  }

  private lost(): void {
    this.stop();
    this.owner.lost(this.isLoaded);
  }
}
