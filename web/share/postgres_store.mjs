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

/**
 * What locks a box does so for one statement: a server that is busy with something else between two statements would keep
 * the whole class waiting. The row is locked until the end, so that posts of a box become visible in the order of their
 * numbers. Made anew by every server that starts.
 */
const kFunctions = `
  CREATE OR REPLACE FUNCTION spineloft_put_seat(
    in_box text, in_seat text, in_secret bytea, most integer, now bigint, OUT result text, OUT number integer
  ) LANGUAGE plpgsql AS $$
  DECLARE
    room spineloft_boxes;
    known spineloft_seats;
  BEGIN
    number := 0;
    SELECT * INTO room FROM spineloft_boxes WHERE id = in_box AND expires > now FOR UPDATE;
    IF room.id IS NULL THEN result := 'none'; RETURN; END IF;
    SELECT * INTO known FROM spineloft_seats WHERE box = in_box AND seat = in_seat;
    IF known.box IS NOT NULL THEN
      result := CASE WHEN known.secret = in_secret THEN 'same' ELSE 'taken' END;
      number := known.number;
      RETURN;
    END IF;
    IF room.seats >= most THEN result := 'full'; RETURN; END IF;
    number := room.seats + 1;
    INSERT INTO spineloft_seats (box, seat, secret, number) VALUES (in_box, in_seat, in_secret, number);
    UPDATE spineloft_boxes SET seats = number WHERE id = in_box;
    result := 'made';
  END $$;
  CREATE OR REPLACE FUNCTION spineloft_put_post(
    in_box text, in_post text, in_seat text, in_bytes bytea, most_bytes bigint, most_posts integer, now bigint,
    OUT result text, OUT seq integer
  ) LANGUAGE plpgsql AS $$
  DECLARE
    room spineloft_boxes;
    known spineloft_posts;
  BEGIN
    seq := 0;
    SELECT * INTO room FROM spineloft_boxes WHERE id = in_box AND expires > now FOR UPDATE;
    IF room.id IS NULL THEN result := 'none'; RETURN; END IF;
    SELECT * INTO known FROM spineloft_posts WHERE box = in_box AND post = in_post;
    IF known.box IS NOT NULL THEN
      result := CASE WHEN known.seat IS NOT DISTINCT FROM in_seat AND known.bytes = in_bytes
        THEN 'same' ELSE 'taken' END;
      seq := known.seq;
      RETURN;
    END IF;
    IF room.frozen AND in_seat IS NOT NULL THEN result := 'frozen'; RETURN; END IF;
    IF room.bytes + length(in_bytes) > most_bytes OR room.next > most_posts THEN result := 'full'; RETURN; END IF;
    seq := room.next;
    INSERT INTO spineloft_posts (box, post, seq, seat, size, at, bytes)
      VALUES (in_box, in_post, room.next, in_seat, length(in_bytes), now, in_bytes);
    UPDATE spineloft_boxes SET next = room.next + 1, bytes = room.bytes + length(in_bytes) WHERE id = in_box;
    PERFORM pg_notify('${kChannel}', in_box || CASE WHEN in_seat IS NULL THEN ' owner' ELSE ' seat' END);
    result := 'stored';
  END $$;
`;

const kBox = 'SELECT kind, owner, expires, frozen, next, bytes, seats FROM spineloft_boxes WHERE id = $1';
const kListed = 'SELECT seq, post, seat, size, at FROM spineloft_posts WHERE box = $1 AND seq > $2';

/** disk_full and out_of_memory (class 53). */
const kFull = /^53(100|200)$/;

/** What a failed statement is told as: it has changed nothing. */
const told = (error) => (kFull.test(error.code ?? '') ? new StoreFull() : error);

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
      if (!there) await ask(kTables);
      const [{ version }] = await ask('SELECT version FROM spineloft_version');
      if (version > kStoreVersion) throw new StoreTooNew();
      await ask(kFunctions);
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
    try {
      return (await this.pool.query(sql, values)).rows;
    } catch (error) {
      throw told(error);
    }
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
      throw told(error);
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

  /** One statement, which is a transaction of its own. */
  async call(name, values) {
    const places = values.map((_, i) => `$${i + 1}`).join(', ');
    const [row] = await this.ask(`SELECT * FROM ${name}(${places})`, values);
    return row;
  }

  putSeat({ box, seat, secret }, most, now) {
    return this.call('spineloft_put_seat', [box, seat, secret, most, now]);
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
    return this.call('spineloft_put_post', [box, post, seat, bytes, mostBytes, mostPosts, now]);
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
