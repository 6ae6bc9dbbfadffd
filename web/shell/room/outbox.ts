// Hand-ins that wait until the server has them: kept in the browser as they will be sent, so that a reload, a sleep or a
// lost network loses none, and the same bytes under the same ids arrive once.
import { openDB } from 'idb';
import type { IDBPDatabase, IDBPObjectStore } from 'idb';
import { ServerFailure } from './client.ts';

export interface Parcel {
  /** Of the card's post. */
  id: string;
  room: string;
  name: string;
  /** In the order in which they are sent. */
  posts: { post: string; body: Uint8Array }[];
}

export interface OutboxEvents {
  /** So many wait. */
  waiting(count: number, why: string | null): void;
  sent(parcel: Parcel): void;
  /** It can never be sent. */
  refused(parcel: Parcel, why: string): void;
}

const kStore = 'parcels';
type Shelf = IDBPObjectStore<unknown, string[], typeof kStore, 'readwrite'>;

async function openShelf(): Promise<IDBPDatabase | null> {
  try {
    return await openDB('spineloft-class', 1, {
      upgrade: (db) => void db.createObjectStore(kStore, { keyPath: 'id' }),
    });
  } catch {
    return null; // blocked: what waits is lost with the page
  }
}

/** Sends the parcels of one room, one after the other. */
export class Outbox {
  private readonly parcels: Parcel[] = [];
  private readonly shelf: Promise<IDBPDatabase | null>;
  private sending = false;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private ended = false;

  constructor(
    private readonly room: string,
    private readonly send: (post: string, body: Uint8Array) => Promise<void>,
    private readonly events: OutboxEvents,
    shelf = openShelf(),
  ) {
    this.shelf = shelf;
  }

  /** What waited when the page was closed is sent now; what belongs to other rooms is thrown away. */
  async begin(): Promise<void> {
    const shelf = await this.shelf;
    const kept = ((await shelf?.getAll(kStore).catch(() => [])) ?? []) as Parcel[];
    for (const parcel of kept) {
      if (parcel.room !== this.room) await this.forget(parcel);
      else if (!this.parcels.some(({ id }) => id === parcel.id)) this.parcels.push(parcel);
    }
    await this.flush();
  }

  /** Resolves when the parcel is kept or sent. */
  async add(parcel: Parcel): Promise<void> {
    await this.write((store) => store.put(parcel));
    this.parcels.push(parcel);
    void this.flush();
  }

  /** Tries now, and later again if it must. */
  async flush(): Promise<void> {
    if (this.sending || this.ended) return;
    this.sending = true;
    clearTimeout(this.timer);
    try {
      for (let parcel = this.parcels[0]; parcel; parcel = this.parcels[0]) {
        this.events.waiting(this.parcels.length, null);
        for (const { post, body } of parcel.posts) await this.send(post, body);
        await this.done(parcel);
        this.events.sent(parcel);
      }
      this.events.waiting(0, null);
    } catch (thrown) {
      const failure = thrown instanceof ServerFailure ? thrown : new ServerFailure('Failed', String(thrown), 3);
      const parcel = this.parcels[0]!;
      if (failure.retryAfter > 0 || failure.code === 'Offline') {
        this.events.waiting(this.parcels.length, failure.message);
        this.timer = setTimeout(() => void this.flush(), 1000 * Math.min(30, failure.retryAfter));
      } else {
        await this.done(parcel);
        this.events.refused(parcel, failure.message);
        this.timer = setTimeout(() => void this.flush());
      }
    } finally {
      this.sending = false;
    }
  }

  /** The room is left: nothing more is sent, and nothing is kept. */
  async end(): Promise<void> {
    this.ended = true;
    clearTimeout(this.timer);
    for (const parcel of this.parcels.splice(0)) await this.forget(parcel);
    (await this.shelf)?.close();
  }

  private async done(parcel: Parcel): Promise<void> {
    const at = this.parcels.indexOf(parcel);
    if (at >= 0) this.parcels.splice(at, 1);
    await this.forget(parcel);
  }

  private async forget({ id }: Parcel): Promise<void> {
    await this.write((store) => store.delete(id));
  }

  /** On the disk when it resolves. A browser that keeps nothing sends all the same. */
  private async write(work: (store: Shelf) => Promise<unknown>): Promise<void> {
    const tx = (await this.shelf)?.transaction(kStore, 'readwrite', { durability: 'strict' });
    if (tx) await Promise.all([work(tx.store), tx.done]).catch(() => undefined);
  }
}
