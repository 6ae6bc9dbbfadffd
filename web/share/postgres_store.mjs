// The store in PostgreSQL, for any number of servers on one database (store.mjs says what the methods do). What happens in
// a box is told to all servers by NOTIFY, in the transaction that does it.
import { spawn } from 'node:child_process';
import { EventEmitter } from 'node:events';
import pg from 'pg';
import { kStoreVersion, StoreFull, StoreTooNew } from './store.mjs';

const kChannel = 'spineloft_share';
/** Any number: servers that start at once make the tables one after the other. */
const kTablesLock = 7_306_519;
const kListenAgainMs = 1000;

const kTables = `
  CREATE TABLE spineloft_version (version integer NOT NULL);
  INSERT INTO spineloft_version VALUES (${kStoreVersion});
  CREATE TABLE spineloft_boxes (
    id text PRIMARY KEY, kind text NOT NULL, owner bytea NOT NULL, expires bigint NOT NULL,
    frozen boolean NOT NULL DEFAULT false, next integer NOT NULL DEFAULT 1, bytes bigint NOT NULL DEFAULT 0,
    seats integer NOT NULL DEFAULT 0
  );
  CREATE INDEX ON spineloft_boxes (expires);
  CREATE TABLE spineloft_seats (
    box text NOT NULL REFERENCES spineloft_boxes ON DELETE CASCADE, seat text NOT NULL, secret bytea NOT NULL,
    number integer NOT NULL, PRIMARY KEY (box, seat)
  );
  CREATE TABLE spineloft_posts (
    box text NOT NULL REFERENCES spineloft_boxes ON DELETE CASCADE, post text NOT NULL, seq integer NOT NULL, seat text,
    size integer NOT NULL, at bigint NOT NULL, hidden boolean NOT NULL DEFAULT false, bytes bytea NOT NULL,
    PRIMARY KEY (box, post)
  );
  ALTER TABLE spineloft_posts ALTER bytes SET STORAGE EXTERNAL;
  CREATE UNIQUE INDEX ON spineloft_posts (box, seq);
  CREATE TABLE spineloft_words (
    locator text PRIMARY KEY, box text NOT NULL REFERENCES spineloft_boxes ON DELETE CASCADE, wrapped bytea NOT NULL,
    expires bigint NOT NULL
  );
  CREATE INDEX ON spineloft_words (box);
`;

const kBox = 'SELECT kind, owner, expires, frozen, next, bytes, seats FROM spineloft_boxes WHERE id = $1';
const kListed = 'SELECT seq, post, seat, size, at FROM spineloft_posts WHERE box = $1 AND seq > $2';

/** disk_full and the other shortages of class 53. */
const kFull = /^53(100|200)$/;

export class PostgresStore {
  static async open(address, { connections = 10 } = {}) {
    const store = new PostgresStore(address, connections);
    try {
      await store.makeTables();
      await store.listen();
    } catch (error) {
      await store.close();
      throw error;
    }
    return store;
  }

  constructor(address, connections) {
    // Sums and times fit a double.
    const types = { getTypeParser: (id, format) => (id === 20 ? Number : pg.types.getTypeParser(id, format)) };
    this.options = { connectionString: address, types };
    this.address = address;
    this.pool = new pg.Pool({ ...this.options, max: connections });
    this.pool.on('error', () => undefined); // an idle connection was lost: the pool makes another
    this.watchers = new EventEmitter().setMaxListeners(0);
    this.listener = null;
    this.closing = false;
  }

  async makeTables() {
    await this.write(async (ask) => {
      await ask('SELECT pg_advisory_xact_lock($1)', [kTablesLock]);
      const [{ there }] = await ask("SELECT to_regclass('spineloft_version') IS NOT NULL AS there");
      if (!there) return ask(kTables);
      const [{ version }] = await ask('SELECT version FROM spineloft_version');
      if (version > kStoreVersion) throw new StoreTooNew();
    });
  }

  /** Hears what other servers do; a lost connection is made anew, and everybody looks whether something was missed. */
  async listen() {
    const client = new pg.Client(this.options);
    client.on('notification', ({ payload }) => {
      const [box, what] = payload.split(' ');
      this.watchers.emit(box, { what });
    });
    const again = () => {
      if (this.closing || this.listener !== client) return;
      this.listener = null;
      const retry = () => {
        if (this.closing) return;
        this.listen().catch(() => setTimeout(retry, kListenAgainMs).unref());
      };
      setTimeout(retry, kListenAgainMs).unref();
    };
    client.on('error', again);
    client.on('end', again);
    await client.connect();
    this.listener = client;
    await client.query(`LISTEN ${kChannel}`);
    for (const box of this.watchers.eventNames()) this.watchers.emit(box, { what: 'state' });
  }

  async ask(sql, values) {
    return (await this.pool.query(sql, values)).rows;
  }

  /** One transaction; a full disk is told as such, and has changed nothing. */
  async write(work) {
    const client = await this.pool.connect();
    let broken;
    try {
      await client.query('BEGIN');
      const done = await work(async (sql, values) => (await client.query(sql, values)).rows);
      await client.query('COMMIT');
      return done;
    } catch (error) {
      await client.query('ROLLBACK').catch((lost) => {
        broken = lost;
      });
      if (kFull.test(error.code ?? '')) throw new StoreFull();
      throw error;
    } finally {
      client.release(broken);
    }
  }

  tell(ask, box, what) {
    return ask('SELECT pg_notify($1, $2)', [kChannel, `${box} ${what}`]);
  }

  async addBox(ask, { id, kind, owner, expires }, now) {
    await ask('DELETE FROM spineloft_boxes WHERE id = $1 AND expires <= $2', [id, now]);
    const made = await ask(
      'INSERT INTO spineloft_boxes (id, kind, owner, expires) VALUES ($1, $2, $3, $4) ON CONFLICT DO NOTHING RETURNING id',
      [id, kind, owner, expires],
    );
    if (made.length) return 'made';
    const [known] = await ask(kBox, [id]);
    return known?.owner.equals(owner) && known.kind === kind ? 'same' : 'taken';
  }

  createBox(box, now) {
    return this.write((ask) => this.addBox(ask, box, now));
  }

  putModel({ id, owner, expires, bytes }, now) {
    return this.write(async (ask) => {
      const result = await this.addBox(ask, { id, kind: 'model', owner, expires }, now);
      if (result === 'same') {
        const [known] = await ask('SELECT bytes FROM spineloft_posts WHERE box = $1', [id]);
        return known?.bytes.equals(bytes) ? 'same' : 'taken';
      }
      if (result === 'made') await this.addPost(ask, { box: id, post: 'model', seat: null, bytes }, 1, now);
      return result;
    });
  }

  async box(id, now) {
    const [row] = await this.ask(`${kBox} AND expires > $2`, [id, now]);
    return row ?? null;
  }

  async state(id) {
    const [row] = await this.ask('SELECT frozen FROM spineloft_boxes WHERE id = $1', [id]);
    const hidden = await this.ask('SELECT post FROM spineloft_posts WHERE box = $1 AND hidden ORDER BY seq', [id]);
    return { frozen: row?.frozen === true, hidden: hidden.map(({ post }) => post) };
  }

  setFrozen(id, frozen) {
    return this.write(async (ask) => {
      await ask('UPDATE spineloft_boxes SET frozen = $2 WHERE id = $1', [id, frozen]);
      await this.tell(ask, id, 'state');
    });
  }

  setHidden(id, post, hidden) {
    return this.write(async (ask) => {
      await ask('UPDATE spineloft_posts SET hidden = $3 WHERE box = $1 AND post = $2', [id, post, hidden]);
      await this.tell(ask, id, 'state');
    });
  }

  removeBox(id) {
    return this.write(async (ask) => {
      await ask('DELETE FROM spineloft_boxes WHERE id = $1', [id]);
      await this.tell(ask, id, 'ended');
    });
  }

  putSeat({ box, seat, secret }, most, now) {
    return this.write(async (ask) => {
      const [room] = await ask(`${kBox} AND expires > $2 FOR UPDATE`, [box, now]);
      if (!room) return { result: 'none', number: 0 };
      const [known] = await ask('SELECT secret, number FROM spineloft_seats WHERE box = $1 AND seat = $2', [box, seat]);
      if (known) return { result: known.secret.equals(secret) ? 'same' : 'taken', number: known.number };
      if (room.seats >= most) return { result: 'full', number: 0 };
      const number = room.seats + 1;
      const values = [box, seat, secret, number];
      await ask('INSERT INTO spineloft_seats (box, seat, secret, number) VALUES ($1, $2, $3, $4)', values);
      await ask('UPDATE spineloft_boxes SET seats = $2 WHERE id = $1', [box, number]);
      return { result: 'made', number };
    });
  }

  async seat(box, seat) {
    const [row] = await this.ask('SELECT secret FROM spineloft_seats WHERE box = $1 AND seat = $2', [box, seat]);
    return row?.secret ?? null;
  }

  async addPost(ask, { box, post, seat, bytes }, seq, now) {
    await ask(
      'INSERT INTO spineloft_posts (box, post, seq, seat, size, at, bytes) VALUES ($1, $2, $3, $4, $5, $6, $7)',
      [box, post, seq, seat, bytes.length, now, bytes],
    );
    await ask('UPDATE spineloft_boxes SET next = next + 1, bytes = bytes + $2 WHERE id = $1', [box, bytes.length]);
  }

  putPost({ box, post, seat, bytes }, { bytes: mostBytes, posts: mostPosts }, now) {
    return this.write(async (ask) => {
      // The row is locked until the end: posts of a box become visible in the order of their numbers.
      const [room] = await ask(`${kBox} AND expires > $2 FOR UPDATE`, [box, now]);
      if (!room) return { result: 'none', seq: 0 };
      const [known] = await ask('SELECT seq, seat, bytes FROM spineloft_posts WHERE box = $1 AND post = $2', [
        box,
        post,
      ]);
      if (known) {
        const isSame = known.seat === seat && known.bytes.equals(bytes);
        return { result: isSame ? 'same' : 'taken', seq: known.seq };
      }
      if (room.frozen && seat !== null) return { result: 'frozen', seq: 0 };
      if (room.bytes + bytes.length > mostBytes || room.next > mostPosts) return { result: 'full', seq: 0 };
      await this.addPost(ask, { box, post, seat, bytes }, room.next, now);
      await this.tell(ask, box, seat === null ? 'owner' : 'seat');
      return { result: 'stored', seq: room.next };
    });
  }

  posts(box, { after = 0, ofOwner = false, most = 200 } = {}) {
    return this.ask(`${kListed}${ofOwner ? ' AND seat IS NULL' : ''} ORDER BY seq LIMIT $3`, [box, after, most]);
  }

  async post(box, post) {
    const [row] = await this.ask('SELECT seat, hidden, bytes FROM spineloft_posts WHERE box = $1 AND post = $2', [
      box,
      post,
    ]);
    return row ?? null;
  }

  putWords({ locator, box, wrapped, expires }, now) {
    return this.write(async (ask) => {
      await ask('DELETE FROM spineloft_words WHERE box = $1 OR (locator = $2 AND expires <= $3)', [box, locator, now]);
      const made = await ask(
        `INSERT INTO spineloft_words (locator, box, wrapped, expires) VALUES ($1, $2, $3, $4)
          ON CONFLICT DO NOTHING RETURNING box`,
        [locator, box, wrapped, expires],
      );
      return made.length ? 'made' : 'taken';
    });
  }

  async words(locator, now) {
    const [row] = await this.ask('SELECT wrapped FROM spineloft_words WHERE locator = $1 AND expires > $2', [
      locator,
      now,
    ]);
    return row?.wrapped ?? null;
  }

  async dropWords(box) {
    await this.ask('DELETE FROM spineloft_words WHERE box = $1', [box]);
  }

  async sweep(now) {
    const ids = await this.ask('SELECT id FROM spineloft_boxes WHERE expires <= $1', [now]);
    for (const { id } of ids) await this.removeBox(id);
    await this.ask('DELETE FROM spineloft_words WHERE expires <= $1', [now]);
    return ids.length;
  }

  /** PostgreSQL's own housekeeping frees the rows; see the hosting page. */
  async scrub() {}

  watch(box, listener) {
    this.watchers.on(box, listener);
    return () => this.watchers.off(box, listener);
  }

  async totals() {
    const [row] = await this.ask(
      `SELECT (SELECT count(*) FROM spineloft_boxes WHERE kind = 'model') AS models,
        (SELECT count(*) FROM spineloft_boxes WHERE kind = 'room') AS rooms,
        (SELECT count(*) FROM spineloft_posts) AS posts,
        (SELECT coalesce(sum(bytes), 0)::bigint FROM spineloft_boxes) AS bytes`,
    );
    return row;
  }

  /** By PostgreSQL's own program. */
  async backup(file) {
    const child = spawn('pg_dump', ['--format=custom', `--file=${file}`, this.address], {
      stdio: ['ignore', 'ignore', 'inherit'],
    });
    await new Promise((resolve, reject) => {
      child.on('error', reject);
      child.on('close', (status) => (status === 0 ? resolve() : reject(new Error(`pg_dump ended with ${status}.`))));
    });
  }

  async close() {
    this.closing = true;
    this.watchers.removeAllListeners();
    await this.listener?.end().catch(() => undefined);
    await this.pool.end();
  }
}
