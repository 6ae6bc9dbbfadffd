// Writes down every step of the open model as it happens: one record a step, a burst in one transaction, in
// order; and the whole history anew when the journal has grown long or something went wrong.
import { packPhoto } from './pack.ts';
import type { PackedPhoto, RawPhoto } from './pack.ts';
import type { ModelInfo, ModelStore } from './store.ts';
import { StoreFailure, storeFailureOf } from './trouble.ts';

/** A step of the document: what the engine sends on commit, undo and redo. */
export interface JournalEvent {
  type: 'journal';
  record: string;
  /** Content hashes of the photos that this step brings. */
  photos: string[];
  name: string;
  pictures: number;
  parts: number;
}

/** What the list shows of a document. */
export interface About {
  name: string;
  pictures: number;
  parts: number;
}

/** The history that the engine holds. */
export interface HistorySource {
  /** The whole of it, as a new base. */
  history(): string;
  /** Content hashes of all its photos. */
  photos(): string[];
  photo(hash: string): RawPhoto | null;
  about(): About;
}

export interface WriterEvents {
  /** The first step of a new model: its id, already claimed. */
  begin(): Promise<string>;
  /** The store again after it failed. */
  reopen(): Promise<ModelStore>;
  kept(info: ModelInfo): void;
  /** Keeping does not work, since that time (null: it works again). Told once, not on every step. */
  trouble(failure: StoreFailure | null, since: number): void;
  /** What was done last is not on the disk yet, although a moment has gone by; false: it is. */
  late(isLate: boolean): void;
  /** Another tab writes this model now. */
  taken(): void;
}

/** A journal longer than this is folded into a new base. */
const kLongJournal = 256 * 1024,
  kLongestJournal = 4 * 1024 * 1024,
  kMostRecords = 400;
/** After a failure the next try waits that long, and twice as long after each further one, up to the longest. */
const kRetryMs = 5000,
  kLongestRetryMs = 5 * 60 * 1000;
/**
 * A write that takes longer is told as late, and as trouble when it takes far longer. A step waits in the engine for at most
 * 40 ms (session.cpp) and for one write before its own: within 100 ms it is on the disk, or that it is not is told.
 */
const kLateMs = 30,
  kSilentMs = 8000;
/** Deleted models can be brought back for that long. */
export const kTrashMs = 10 * 60 * 1000;

function isLong(info: ModelInfo): boolean {
  const most = Math.max(kLongJournal, Math.min(info.baseSize, kLongestJournal));
  return info.journalSize > most || info.next - info.start >= kMostRecords;
}

export class JournalWriter {
  private info: ModelInfo | null = null;
  private pending: JournalEvent[] = [];
  private wantsBase = false;
  private running: Promise<void> | null = null;
  private known = new Set<string>();
  private failure: StoreFailure | null = null;
  private failedAt = -Infinity;
  private failingSince = 0;
  private pause = kRetryMs;
  private cancelRetry: () => void = () => undefined;
  private stopped = false;
  private newId: string | null = null; // of a model whose first write is still to come
  private turn = 0; // counts models, and writes that were given up: what belongs to an earlier one changes nothing any more

  constructor(
    private readonly source: HistorySource,
    private store: ModelStore | null,
    private readonly token: string,
    private readonly events: WriterEvents,
    private readonly now: () => number = Date.now,
    /** Runs something later; what it returns calls that off. */
    private readonly later: (ms: number, work: () => void) => () => void = (ms, work) => {
      const timer = setTimeout(work, ms);
      return () => clearTimeout(timer);
    },
  ) {}

  get model(): string | null {
    return this.info?.id ?? null;
  }

  /** Something is being written, by a store that answers as far as is known. */
  get isBusy(): boolean {
    return this.running !== null && this.failure?.code !== 'silent';
  }

  /** True when every step is kept. */
  get isSafe(): boolean {
    return (
      this.store !== null &&
      this.failure === null &&
      !this.stopped &&
      this.running === null &&
      this.pending.length === 0
    );
  }

  get isInTrouble(): boolean {
    return this.failure !== null;
  }

  /** From now on steps belong to this model; null: to a new one, made with the first step. Call it when nothing is pending. */
  attach(info: ModelInfo | null): void {
    this.turn += 1;
    this.info = info;
    this.newId = null;
    this.pending = [];
    this.stopped = false;
    this.wantsBase = false;
    for (const hash of info?.photos ?? []) this.known.add(hash);
  }

  /** A tab that took the model over writes it now: nothing is written here any more. */
  stop(): void {
    this.cancelRetry();
    this.stopped = true;
    this.pending = [];
  }

  /** One step more; it is on its way to the disk when this returns to the event loop. */
  take(event: JournalEvent): void {
    if (this.stopped) return;
    this.pending.push(event);
    this.start();
  }

  /** Writes the whole history anew. */
  rewrite(): void {
    this.wantsBase = true;
    this.start();
  }

  /** Tries again after a failure, without waiting. */
  retry(): void {
    if (!this.failure) return;
    this.failedAt = -Infinity;
    this.rewrite();
  }

  /** Resolves when nothing is being written any more, or the store does not answer. */
  async settled(): Promise<void> {
    while (this.isBusy) await this.running;
  }

  private start(): void {
    if (this.running || this.stopped) return;
    if (this.failure && this.now() - this.failedAt < this.pause) {
      this.pending = [];
      this.wantsBase = true;
      return;
    }
    // A microtask later: not inside a call into the engine. It ends when the store does not answer: the next try is another.
    let giveUp = (): void => undefined;
    const silence = new Promise<void>((resolve) => (giveUp = resolve));
    const run = Promise.race([Promise.resolve().then(() => this.writeAll(giveUp)), silence]).finally(() => {
      this.running = null;
      // A step that came after the last look; after a failure the next step tries again.
      if (!this.failure && this.pending.length > 0) this.start();
    });
    this.running = run;
  }

  private async writeAll(giveUp: () => void): Promise<void> {
    let second = false;
    while (!this.stopped && (this.pending.length > 0 || this.wantsBase)) {
      const { turn } = this;
      const over = this.watch(giveUp);
      const failure = await this.writeOnce().then(
        () => null,
        (thrown: unknown) => storeFailureOf(thrown),
      );
      over();
      if (turn !== this.turn) {
        // The visitor has left this model, or the store answers late: what came meanwhile is written now.
        if (failure || this.failure?.code !== 'silent') return;
        this.report(null);
        if (this.pending.length > 0 || this.wantsBase) this.start();
        return;
      }
      if (!failure) {
        second = false;
        this.report(null);
        continue;
      }
      if (failure.code === 'taken') {
        this.stop();
        this.events.taken();
        return;
      }
      this.wantsBase = true;
      if (second || !(await this.mend(failure))) {
        this.report(failure);
        return;
      }
      second = true;
    }
  }

  /** Tells when a write takes long, until the function that it returns is called; gives it up when it takes far longer. */
  private watch(giveUp: () => void): () => void {
    let isLate = false;
    const notLate = this.later(kLateMs, () => {
      isLate = true;
      this.events.late(true);
    });
    const notSilent = this.later(kSilentMs, () => {
      over();
      this.turn += 1;
      this.wantsBase = true;
      this.report(new StoreFailure('silent'));
      giveUp();
    });
    const over = (): void => {
      notLate();
      notSilent();
      if (isLate) this.events.late(false);
      isLate = false;
    };
    return over;
  }

  /** True when a second try makes sense. */
  private async mend(failure: StoreFailure): Promise<boolean> {
    // The visitor may have cleared the site's data: nothing counts as kept.
    this.known.clear();
    if (failure.code === 'photo-missing') return true;
    if (failure.code !== 'failed' || !this.store) return false;
    this.store = await this.events.reopen().catch(() => this.store);
    return true;
  }

  private report(failure: StoreFailure | null): void {
    const changed = failure?.code !== this.failure?.code;
    this.cancelRetry();
    if (failure) {
      this.failedAt = this.now();
      if (!this.failure) [this.failingSince, this.pause] = [this.failedAt, kRetryMs];
      else this.pause = Math.min(2 * this.pause, kLongestRetryMs);
      this.pending = [];
      // Without a store there is nothing to wait for.
      if (this.store) this.cancelRetry = this.later(this.pause, () => this.retry());
    }
    this.failure = failure;
    if (changed) this.events.trouble(failure, this.failingSince);
  }

  /** One transaction. What is asked of the engine is asked before the first await: it all belongs together. */
  private async writeOnce(): Promise<void> {
    const batch = this.pending.splice(0),
      { turn } = this;
    const wanted = [...new Set(batch.flatMap((event) => event.photos))];
    let whole = this.wantsBase || !this.info || isLong(this.info);
    let photos = whole ? this.source.photos() : wanted;
    let fresh = this.unknown(photos);
    if (!whole && fresh === null) {
      // A step whose photo the history has forgotten already: only the whole can be written.
      whole = true;
      photos = this.source.photos();
      fresh = this.unknown(photos);
    }
    const base = whole ? this.source.history() : null;
    const { name, pictures, parts } = batch.at(-1) ?? this.source.about();
    this.wantsBase = false;
    if (!this.store) throw new StoreFailure('missing');
    const packed = await this.pack(this.store, fresh ?? []);
    if (turn !== this.turn) return;
    const id = this.info?.id ?? this.newId ?? (await this.events.begin());
    if (turn !== this.turn) return;
    this.newId = id;
    const records = batch.map((event) => event.record);
    const before = this.info?.photos ?? [];
    const info = await this.store.write({
      id,
      writer: this.token,
      now: this.now(),
      name,
      pictures,
      parts,
      base,
      records,
      photos,
      packed,
    });
    if (turn !== this.turn) return;
    this.info = info;
    for (const hash of photos) this.known.add(hash);
    this.events.kept(this.info);
    if (whole && before.some((hash) => !photos.includes(hash))) await this.store.sweep(this.now() - kTrashMs);
  }

  /** The photos that may not be in the store yet; null when the history lacks one. */
  private unknown(hashes: string[]): RawPhoto[] | null {
    const photos = hashes.filter((hash) => !this.known.has(hash)).map((hash) => this.source.photo(hash));
    return photos.includes(null) ? null : (photos as RawPhoto[]);
  }

  private async pack(store: ModelStore, photos: RawPhoto[]): Promise<PackedPhoto[]> {
    if (photos.length === 0) return [];
    const missing = new Set(await store.missingPhotos(photos.map((photo) => photo.hash)));
    return Promise.all(photos.filter((photo) => missing.has(photo.hash)).map(packPhoto));
  }
}
