// The models that this browser keeps, in IndexedDB: of each what the list shows, the base of its history,
// the records after it (engine/io/journal.h), and the photos, stored once however many models show them.
// Every change is one transaction: whatever ends the page, all of it is there or nothing.
import { openDB } from 'idb';
import type { DBSchema, IDBPDatabase, IDBPTransaction, StoreNames } from 'idb';
import type { PackedPhoto } from './pack.ts';
import { StoreFailure, storeFailureOf } from './trouble.ts';

export const kDatabase = 'spineloft';
export const kDatabaseVersion = 1;
/** The setting that says which model was open last. */
export const kOpenModel = 'open';

/** A small picture of a model. */
export interface Thumbnail {
  type: string;
  bytes: Uint8Array;
}

/** What the list shows of a model, and how far its journal goes. */
export interface ModelInfo {
  id: string;
  name: string;
  /** Milliseconds since 1970. */
  created: number;
  modified: number;
  pictures: number;
  parts: number;
  thumbnail: Thumbnail | null;
  /** Content hashes of all photos of its history. */
  photos: string[];
  /** Sequence numbers: of the first record after the base, and of the next one to come. */
  start: number;
  next: number;
  /** UTF-16 units of the base and of the records after it. */
  baseSize: number;
  journalSize: number;
  /** Who may write: a token of the page that opened it last. */
  writer: string;
  /** A name given in the list, which its document does not know yet. */
  newName: string | null;
  /** When it was deleted; it can be brought back until it is swept away. */
  deleted: number | null;
  /** The animal that it is put away under (animals.ts); none: nobody's. */
  whose?: string | null;
}

/** One step of keeping: a new base, or records after the old one. */
export interface Change {
  id: string;
  writer: string;
  now: number;
  name: string;
  pictures: number;
  parts: number;
  /** Replaces the base and forgets the records before it; the model is made when it is not there. */
  base: string | null;
  records: string[];
  /** All photos of the history with a new base, else those that the records bring. */
  photos: string[];
  /** Those of them that are not in the store yet. */
  packed: PackedPhoto[];
}

/** A model as it is kept. */
export interface KeptModel {
  info: ModelInfo;
  base: string;
  records: string[];
  /** Records that are lost: the ones behind a gap. */
  lost: number;
}

interface Schema extends DBSchema {
  models: { key: string; value: ModelInfo };
  bases: { key: string; value: { id: string; text: string } };
  journal: { key: [string, number]; value: { model: string; sequence: number; text: string } };
  photos: { key: string; value: PackedPhoto };
  settings: { key: string; value: unknown };
  holders: { key: string; value: { id: string; tab: string; at: number } };
}

type Database = IDBPDatabase<Schema>;

function allRecords(id: string): IDBKeyRange {
  return IDBKeyRange.bound([id, 0], [id, Number.MAX_SAFE_INTEGER]);
}

function createStores(db: Database): void {
  db.createObjectStore('models', { keyPath: 'id' });
  db.createObjectStore('bases', { keyPath: 'id' });
  db.createObjectStore('journal', { keyPath: ['model', 'sequence'] });
  db.createObjectStore('photos', { keyPath: 'hash' });
  db.createObjectStore('settings');
  db.createObjectStore('holders', { keyPath: 'id' });
}

/** A new id that no other model has. */
export function newModelId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(12));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

export class ModelStore {
  private constructor(private readonly db: Database) {}

  /** Opens the database. Rejects with a StoreFailure: 'missing', 'newer', 'failed' or 'silent' (no answer in time). */
  static async open(limitMs = 4000, closed: () => void = () => undefined): Promise<ModelStore> {
    let timer: ReturnType<typeof setTimeout> | undefined;
    try {
      if (typeof indexedDB !== 'object' || indexedDB === null) throw new StoreFailure('missing');
      const late = new Promise<never>((_, reject) => {
        timer = setTimeout(() => reject(new StoreFailure('silent')), limitMs);
      });
      const opening = openDB<Schema>(kDatabase, kDatabaseVersion, {
        upgrade: (db) => createStores(db),
        // A newer page in another tab waits for us: let it pass; the next write says so.
        blocking: (_current, _next, event) => (event.target as IDBDatabase).close(),
        terminated: closed,
      });
      opening.catch(() => undefined);
      return new ModelStore(await Promise.race([opening, late]));
    } catch (thrown) {
      throw storeFailureOf(thrown);
    } finally {
      clearTimeout(timer);
    }
  }

  close(): void {
    this.db.close();
  }

  /** All models, the last changed first. */
  async list(): Promise<ModelInfo[]> {
    const models = await this.guard(() => this.db.getAll('models'));
    return models.filter((model) => model.deleted === null).sort((a, b) => b.modified - a.modified);
  }

  async info(id: string): Promise<ModelInfo | null> {
    return (await this.guard(() => this.db.get('models', id))) ?? null;
  }

  /** Those of the photos that are not kept yet. */
  async missingPhotos(hashes: string[]): Promise<string[]> {
    return this.guard(async () => {
      const photos = this.db.transaction('photos').store;
      const keys = await Promise.all(hashes.map((hash) => photos.getKey(hash)));
      return hashes.filter((_, i) => keys[i] === undefined);
    });
  }

  /**
   * Keeps one change, all of it or nothing; the model is the one to open next time. Rejects with a StoreFailure: 'taken' (another page writes this model
   * now, or it is gone), 'photo-missing' (a photo is neither given nor kept), 'full', 'failed'.
   */
  async write(change: Change): Promise<ModelInfo> {
    return this.transact(['models', 'bases', 'journal', 'photos', 'settings'], async (tx) => {
      const models = tx.objectStore('models'),
        photos = tx.objectStore('photos'),
        journal = tx.objectStore('journal');
      const old = await models.get(change.id);
      if (old ? old.writer !== change.writer || old.deleted !== null : change.base === null)
        throw new StoreFailure('taken');
      for (const photo of change.packed) quietly(photos.put(photo));
      for (const hash of change.photos) {
        if ((await photos.getKey(hash)) === undefined) throw new StoreFailure('photo-missing');
      }
      const info = advanced(old ?? null, change);
      if (change.base !== null) {
        quietly(tx.objectStore('bases').put({ id: change.id, text: change.base }));
        quietly(journal.delete(allRecords(change.id)));
      } else {
        const first = info.next - change.records.length;
        for (const [i, text] of change.records.entries())
          quietly(journal.add({ model: change.id, sequence: first + i, text }));
      }
      quietly(models.put(info));
      quietly(tx.objectStore('settings').put(change.id, kOpenModel));
      return info;
    });
  }

  /** A model with its records in order; from now on `writer` may write it. None when it is not there. */
  async read(id: string, writer: string): Promise<KeptModel | null> {
    return this.transact(['models', 'bases', 'journal'], async (tx) => {
      const info = await tx.objectStore('models').get(id);
      const base = await tx.objectStore('bases').get(id);
      const rows = await tx.objectStore('journal').getAll(allRecords(id));
      if (!info || !base || info.deleted !== null) return null;
      info.writer = writer;
      quietly(tx.objectStore('models').put(info));
      const records = rows.slice(0, firstGap(rows, info.start)).map((row) => row.text);
      const lost = Math.max(info.next - info.start, rows.length) - records.length;
      return { info, base: base.text, records, lost };
    });
  }

  photo(hash: string): Promise<PackedPhoto | undefined> {
    return this.guard(() => this.db.get('photos', hash));
  }

  /** A copy with a new id and name, with history and all. None when the model is not there. */
  async duplicate(id: string, name: string, now: number): Promise<ModelInfo | null> {
    return this.transact(['models', 'bases', 'journal'], async (tx) => {
      const old = await tx.objectStore('models').get(id);
      const base = await tx.objectStore('bases').get(id);
      if (!old || !base) return null;
      const info: ModelInfo = {
        ...old,
        id: newModelId(),
        name,
        newName: name,
        created: now,
        modified: now,
        writer: '',
        deleted: null,
      };
      for (const row of await tx.objectStore('journal').getAll(allRecords(id))) {
        quietly(tx.objectStore('journal').add({ ...row, model: info.id }));
      }
      quietly(tx.objectStore('bases').put({ ...base, id: info.id }));
      quietly(tx.objectStore('models').put(info));
      return info;
    });
  }

  /** Names a model that is not open; its document learns it when it is opened. */
  rename(id: string, name: string): Promise<void> {
    return this.change(id, (info) => ({ ...info, name, newName: name }));
  }

  setThumbnail(id: string, writer: string, thumbnail: Thumbnail): Promise<void> {
    return this.change(id, (info) => (info.writer === writer ? { ...info, thumbnail } : info));
  }

  /** Puts a model away under an animal. */
  setWhose(id: string, animal: string): Promise<void> {
    return this.change(id, (info) => ({ ...info, whose: animal }));
  }

  /** Takes a model off the list; `undelete` brings it back until `sweep`. */
  delete(id: string, now: number): Promise<void> {
    return this.change(id, (info) => ({ ...info, deleted: now }));
  }

  undelete(id: string): Promise<void> {
    return this.change(id, (info) => ({ ...info, deleted: null }));
  }

  /** Forgets models that were deleted before that time, and photos that no model shows. */
  async sweep(before: number): Promise<void> {
    await this.transact(['models', 'bases', 'journal', 'photos'], async (tx) => {
      const models = await tx.objectStore('models').getAll();
      const gone = models.filter((model) => model.deleted !== null && model.deleted <= before);
      for (const { id } of gone) {
        quietly(tx.objectStore('models').delete(id));
        quietly(tx.objectStore('bases').delete(id));
        quietly(tx.objectStore('journal').delete(allRecords(id)));
      }
      const used = new Set(models.filter((model) => !gone.includes(model)).flatMap((model) => model.photos));
      for (const hash of await tx.objectStore('photos').getAllKeys()) {
        if (!used.has(hash)) quietly(tx.objectStore('photos').delete(hash));
      }
    });
  }

  setting(key: string): Promise<unknown> {
    return this.guard(() => this.db.get('settings', key));
  }

  async set(key: string, value: unknown): Promise<void> {
    await this.guard(() => this.db.put('settings', value, key));
  }

  /** For browsers without Web Locks: holds a model for a tab unless another one has shown life since `stale`. True when it is held. */
  async hold(id: string, tab: string, now: number, stale: number): Promise<boolean> {
    return this.transact(['holders'], async (tx) => {
      const holder = await tx.objectStore('holders').get(id);
      const free = !holder || holder.tab === tab || holder.at <= stale;
      if (free) quietly(tx.objectStore('holders').put({ id, tab, at: now }));
      return free;
    });
  }

  async letGo(id: string, tab: string): Promise<void> {
    await this.transact(['holders'], async (tx) => {
      if ((await tx.objectStore('holders').get(id))?.tab === tab) quietly(tx.objectStore('holders').delete(id));
    });
  }

  /** Models whose holder has shown life since `stale`. */
  async held(stale: number): Promise<string[]> {
    const holders = await this.guard(() => this.db.getAll('holders'));
    return holders.filter((holder) => holder.at > stale).map((holder) => holder.id);
  }

  private change(id: string, next: (info: ModelInfo) => ModelInfo): Promise<void> {
    return this.transact(['models'], async (tx) => {
      const info = await tx.objectStore('models').get(id);
      if (info) quietly(tx.objectStore('models').put(next(info)));
    });
  }

  /** One transaction: what `work` asks for happens as a whole, or not at all when anything fails. */
  private transact<Names extends StoreNames<Schema>[], T>(
    names: Names,
    work: (tx: IDBPTransaction<Schema, Names, 'readwrite'>) => Promise<T>,
  ): Promise<T> {
    return this.guard(async () => {
      // What is told as kept has reached the disk, not only the system.
      const tx = this.db.transaction(names, 'readwrite', { durability: 'strict' });
      try {
        const value = await work(tx);
        await tx.done;
        return value;
      } catch (thrown) {
        await abandon(tx);
        throw tx.error ?? thrown;
      }
    });
  }

  private async guard<T>(work: () => Promise<T>): Promise<T> {
    try {
      return await work();
    } catch (thrown) {
      throw storeFailureOf(thrown);
    }
  }
}

function firstGap(rows: { sequence: number; text: unknown }[], start: number): number {
  const at = rows.findIndex((row, i) => row.sequence !== start + i || typeof row.text !== 'string');
  return at < 0 ? rows.length : at;
}

/** The list's entry after a change. */
function advanced(old: ModelInfo | null, change: Change): ModelInfo {
  const isBase = change.base !== null;
  const before = old?.next ?? 0;
  const added = isBase ? [] : change.records;
  return {
    id: change.id,
    name: change.name,
    created: old?.created ?? change.now,
    modified: change.now,
    pictures: change.pictures,
    parts: change.parts,
    thumbnail: old?.thumbnail ?? null,
    photos: isBase ? [...change.photos] : [...new Set([...(old?.photos ?? []), ...change.photos])],
    start: isBase ? before : old!.start,
    next: before + added.length,
    baseSize: isBase ? change.base!.length : old!.baseSize,
    journalSize: isBase ? 0 : old!.journalSize + added.reduce((sum, text) => sum + text.length, 0),
    writer: change.writer,
    newName: null,
    deleted: null,
    whose: old?.whose ?? null,
  };
}

/** A request whose failure is told by its transaction. */
function quietly(request: Promise<unknown>): void {
  request.catch(() => undefined);
}

/** Ends a transaction without its changes; it may have ended already. */
async function abandon(tx: { abort(): void; done: Promise<void> }): Promise<void> {
  try {
    tx.abort();
  } catch {
    // It has ended by itself.
  }
  await tx.done.catch(() => undefined);
}
