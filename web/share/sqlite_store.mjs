// The store as one SQLite file (store.mjs says what the methods do). A write is acknowledged when it is on the disk.
import { EventEmitter } from 'node:events';
import { mkdirSync } from 'node:fs';
import { dirname } from 'node:path';
import Database from 'better-sqlite3';
import { kStoreVersion, StoreFull, StoreTooNew } from './store.mjs';

const kTables = `
  CREATE TABLE boxes (
    id TEXT PRIMARY KEY, kind TEXT NOT NULL, owner BLOB NOT NULL, expires INTEGER NOT NULL,
    frozen INTEGER NOT NULL DEFAULT 0, next INTEGER NOT NULL DEFAULT 1, bytes INTEGER NOT NULL DEFAULT 0,
    seats INTEGER NOT NULL DEFAULT 0
  ) WITHOUT ROWID;
  CREATE INDEX boxes_by_end ON boxes (expires);
  CREATE TABLE seats (
    box TEXT NOT NULL REFERENCES boxes ON DELETE CASCADE, seat TEXT NOT NULL, secret BLOB NOT NULL,
    number INTEGER NOT NULL, PRIMARY KEY (box, seat)
  ) WITHOUT ROWID;
  CREATE TABLE posts (
    box TEXT NOT NULL REFERENCES boxes ON DELETE CASCADE, post TEXT NOT NULL, seq INTEGER NOT NULL, seat TEXT,
    size INTEGER NOT NULL, at INTEGER NOT NULL, hidden INTEGER NOT NULL DEFAULT 0, bytes BLOB NOT NULL,
    PRIMARY KEY (box, post)
  );
  CREATE UNIQUE INDEX posts_in_order ON posts (box, seq);
  CREATE TABLE words (
    locator TEXT PRIMARY KEY, box TEXT NOT NULL REFERENCES boxes ON DELETE CASCADE, wrapped BLOB NOT NULL,
    expires INTEGER NOT NULL
  ) WITHOUT ROWID;
  CREATE INDEX words_of ON words (box);
`;

const kStatements = {
  addBox: 'INSERT INTO boxes (id, kind, owner, expires) VALUES (?, ?, ?, ?)',
  box: 'SELECT kind, owner, expires, frozen, next, bytes, seats FROM boxes WHERE id = ? AND expires > ?',
  anyBox: 'SELECT kind, owner, expires FROM boxes WHERE id = ?',
  removeBox: 'DELETE FROM boxes WHERE id = ?',
  freeze: 'UPDATE boxes SET frozen = ? WHERE id = ?',
  hide: 'UPDATE posts SET hidden = ? WHERE box = ? AND post = ?',
  hidden: 'SELECT post FROM posts WHERE box = ? AND hidden = 1 ORDER BY seq',
  frozen: 'SELECT frozen FROM boxes WHERE id = ?',
  seat: 'SELECT secret, number FROM seats WHERE box = ? AND seat = ?',
  addSeat: 'INSERT INTO seats (box, seat, secret, number) VALUES (?, ?, ?, ?)',
  countSeat: 'UPDATE boxes SET seats = seats + 1 WHERE id = ?',
  addPost: 'INSERT INTO posts (box, post, seq, seat, size, at, bytes) VALUES (?, ?, ?, ?, ?, ?, ?)',
  countPost: 'UPDATE boxes SET next = next + 1, bytes = bytes + ? WHERE id = ?',
  post: 'SELECT seq, seat, hidden, bytes FROM posts WHERE box = ? AND post = ?',
  posts: 'SELECT seq, post, seat, size, at FROM posts WHERE box = ? AND seq > ? ORDER BY seq LIMIT ?',
  ownPosts:
    'SELECT seq, post, seat, size, at FROM posts WHERE box = ? AND seq > ? AND seat IS NULL ORDER BY seq LIMIT ?',
  dropWords: 'DELETE FROM words WHERE box = ? OR locator = ?',
  wordsOf: 'SELECT box FROM words WHERE locator = ? AND expires > ?',
  addWords: 'INSERT INTO words (locator, box, wrapped, expires) VALUES (?, ?, ?, ?)',
  words: 'SELECT wrapped FROM words WHERE locator = ? AND expires > ?',
  expired: 'SELECT id FROM boxes WHERE expires <= ?',
  expireWords: 'DELETE FROM words WHERE expires <= ?',
  totals: `SELECT (SELECT count(*) FROM boxes WHERE kind = 'model') AS models,
    (SELECT count(*) FROM boxes WHERE kind = 'room') AS rooms,
    (SELECT count(*) FROM posts) AS posts, (SELECT coalesce(sum(bytes), 0) FROM boxes) AS bytes`,
};

/** SQLite's own names for a disk that takes no more. */
const kFull = /^SQLITE_(FULL|IOERR_WRITE|IOERR_SHMSIZE|IOERR_FSYNC)/;

export class SqliteStore {
  static async open(file, { diskBytes = 0, onWrite } = {}) {
    mkdirSync(dirname(file), { recursive: true });
    const db = new Database(file, { timeout: 5000 });
    try {
      return new SqliteStore(db, diskBytes, onWrite);
    } catch (error) {
      db.close();
      throw error;
    }
  }

  /** `onWrite(name)` is called before every statement that writes: where a test may end the process. */
  constructor(db, diskBytes, onWrite) {
    db.pragma('journal_mode = WAL');
    db.pragma('synchronous = FULL');
    db.pragma('secure_delete = ON'); // what was removed is overwritten
    db.pragma('foreign_keys = ON');
    if (diskBytes > 0)
      db.pragma(`max_page_count = ${Math.max(16, Math.floor(diskBytes / db.pragma('page_size', { simple: true })))}`);
    const version = db.pragma('user_version', { simple: true });
    if (version > kStoreVersion) throw new StoreTooNew();
    if (version === 0)
      db.transaction(() => {
        db.exec(kTables);
        db.pragma(`user_version = ${kStoreVersion}`);
      }).immediate();
    this.db = db;
    this.onWrite = onWrite;
    this.dirty = false;
    this.watchers = new EventEmitter().setMaxListeners(0);
    this.statements = Object.fromEntries(Object.entries(kStatements).map(([name, sql]) => [name, db.prepare(sql)]));
  }

  get(name, ...values) {
    return this.statements[name].get(...values);
  }

  all(name, ...values) {
    return this.statements[name].all(...values);
  }

  run(name, ...values) {
    this.onWrite?.(name);
    return this.statements[name].run(...values);
  }

  /** One transaction; a full disk is told as such, and has changed nothing. */
  async write(work) {
    try {
      const done = this.db.transaction(work).immediate();
      this.onWrite?.('acknowledge');
      return done;
    } catch (error) {
      if (kFull.test(error.code ?? '')) throw new StoreFull();
      throw error;
    }
  }

  tell(box, what) {
    this.watchers.emit(box, { what });
  }

  addBox({ id, kind, owner, expires }, now) {
    const known = this.get('anyBox', id);
    if (known && known.expires > now) return known.owner.equals(owner) && known.kind === kind ? 'same' : 'taken';
    if (known) this.run('removeBox', id);
    this.run('addBox', id, kind, owner, expires);
    return 'made';
  }

  createBox(box, now) {
    return this.write(() => this.addBox(box, now));
  }

  putModel({ id, owner, expires, bytes }, now) {
    return this.write(() => {
      const result = this.addBox({ id, kind: 'model', owner, expires }, now);
      if (result === 'same') return this.get('post', id, 'model')?.bytes.equals(bytes) ? 'same' : 'taken';
      if (result === 'made') this.addPost({ box: id, post: 'model', seat: null, bytes }, 1, now);
      return result;
    });
  }

  async box(id, now) {
    const row = this.get('box', id, now);
    return row ? { ...row, frozen: row.frozen === 1 } : null;
  }

  async state(id) {
    return {
      frozen: this.get('frozen', id)?.frozen === 1,
      hidden: this.all('hidden', id).map(({ post }) => post),
    };
  }

  async setFrozen(id, frozen) {
    await this.write(() => this.run('freeze', frozen ? 1 : 0, id));
    this.tell(id, 'state');
  }

  async setHidden(id, post, hidden) {
    await this.write(() => this.run('hide', hidden ? 1 : 0, id, post));
    this.tell(id, 'state');
  }

  async removeBox(id) {
    const { changes } = await this.write(() => this.run('removeBox', id));
    this.dirty ||= changes > 0;
    this.tell(id, 'ended');
  }

  putSeat({ box, seat, secret }, most, now) {
    return this.write(() => {
      const room = this.get('box', box, now);
      if (!room) return { result: 'none', number: 0 };
      const known = this.get('seat', box, seat);
      if (known) return { result: known.secret.equals(secret) ? 'same' : 'taken', number: known.number };
      if (room.seats >= most) return { result: 'full', number: 0 };
      const number = room.seats + 1;
      this.run('addSeat', box, seat, secret, number);
      this.run('countSeat', box);
      return { result: 'made', number };
    });
  }

  async seat(box, seat) {
    return this.get('seat', box, seat)?.secret ?? null;
  }

  addPost({ box, post, seat, bytes }, seq, now) {
    this.run('addPost', box, post, seq, seat, bytes.length, now, bytes);
    this.run('countPost', bytes.length, box);
  }

  async putPost({ box, post, seat, bytes }, { bytes: mostBytes, posts: mostPosts }, now) {
    const done = await this.write(() => {
      const room = this.get('box', box, now);
      if (!room) return { result: 'none', seq: 0 };
      const known = this.get('post', box, post);
      if (known) {
        const isSame = known.seat === seat && known.bytes.equals(bytes);
        return { result: isSame ? 'same' : 'taken', seq: known.seq };
      }
      if (room.frozen && seat !== null) return { result: 'frozen', seq: 0 };
      if (room.bytes + bytes.length > mostBytes || room.next > mostPosts) return { result: 'full', seq: 0 };
      this.addPost({ box, post, seat, bytes }, room.next, now);
      return { result: 'stored', seq: room.next };
    });
    if (done.result === 'stored') this.tell(box, seat === null ? 'owner' : 'seat');
    return done;
  }

  async posts(box, { after = 0, ofOwner = false, most = 200 } = {}) {
    return this.all(ofOwner ? 'ownPosts' : 'posts', box, after, most);
  }

  async post(box, post) {
    const row = this.get('post', box, post);
    return row ? { seat: row.seat, hidden: row.hidden === 1, bytes: row.bytes } : null;
  }

  putWords({ locator, box, wrapped, expires }, now) {
    return this.write(() => {
      const known = this.get('wordsOf', locator, now);
      if (known && known.box !== box) return 'taken';
      this.dropBoth(box, locator);
      this.run('addWords', locator, box, wrapped, expires);
      return 'made';
    });
  }

  /** The words of a box, and those that stand in the way of new ones and have expired. */
  dropBoth(box, locator) {
    this.run('dropWords', box, locator);
    this.dirty = true;
  }

  async words(locator, now) {
    return this.get('words', locator, now)?.wrapped ?? null;
  }

  dropWords(box) {
    return this.write(() => this.dropBoth(box, ''));
  }

  async sweep(now) {
    const ids = this.all('expired', now).map(({ id }) => id);
    for (const id of ids) await this.removeBox(id);
    const { changes } = await this.write(() => this.run('expireWords', now));
    this.dirty ||= changes > 0;
    return ids.length;
  }

  async scrub() {
    if (!this.dirty) return;
    // Busy while somebody reads: then the next time.
    const [{ busy }] = this.db.pragma('wal_checkpoint(TRUNCATE)');
    if (busy === 0) this.dirty = false;
  }

  watch(box, listener) {
    this.watchers.on(box, listener);
    return () => this.watchers.off(box, listener);
  }

  async totals() {
    return this.get('totals');
  }

  async backup(file) {
    await this.db.backup(file);
  }

  async close() {
    this.watchers.removeAllListeners();
    this.db.close();
  }
}
