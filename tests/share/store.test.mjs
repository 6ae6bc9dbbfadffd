// What a store promises (web/share/store.mjs), of SQLite and of PostgreSQL alike.
import assert from 'node:assert/strict';
import { randomBytes } from 'node:crypto';
import { statSync } from 'node:fs';
import { after, before, describe, test } from 'node:test';
import { StoreFull } from '../../web/share/store.mjs';
import { hash, id, kStoreKits } from './support/stores.mjs';

const kNow = 1_700_000_000_000,
  kHour = 3_600_000,
  kRoomy = { bytes: 1e6, posts: 1000 };

/** A room in a store, with the calls that tests need. */
async function withRoom(store) {
  const room = { id: id(), kind: 'room', owner: hash(), expires: kNow + kHour };
  assert.equal(await store.createBox(room, kNow), 'made');
  const seat = id();
  assert.equal((await store.putSeat({ box: room.id, seat, secret: hash() }, 30, kNow)).result, 'made');
  const post = (bytes, from = seat, limits = kRoomy, name = id()) =>
    store.putPost({ box: room.id, post: name, seat: from, bytes: Buffer.from(bytes) }, limits, kNow);
  return { ...room, seat, post };
}

for (const { name, make, skip } of kStoreKits) {
  describe(name, { skip }, () => {
    let kit;
    const open = [];
    before(() => {
      kit = make();
    });
    after(async () => {
      for (const store of open) await store.close();
      kit.close();
    });
    const fresh = async (options) => {
      const store = await kit.open(options);
      open.push(store);
      return store;
    };
    const second = async () => {
      const store = await kit.again();
      open.push(store);
      return store;
    };

    test('a model is there byte for byte until it expires, and its id is then free', async () => {
      const store = await fresh();
      const bytes = randomBytes(300_000);
      const model = { id: id(), owner: hash(), expires: kNow + kHour, bytes };
      assert.equal(await store.putModel(model, kNow), 'made');
      assert.deepEqual((await store.post(model.id, 'model')).bytes, bytes);
      assert.equal((await store.box(model.id, kNow + kHour - 1)).kind, 'model');
      assert.equal(await store.box(model.id, kNow + kHour), null);
      assert.equal(await store.sweep(kNow + kHour - 1), 0);
      assert.equal(await store.sweep(kNow + kHour), 1);
      assert.equal(await store.post(model.id, 'model'), null);
      const later = { ...model, owner: hash(), expires: kNow + 3 * kHour };
      assert.equal(await store.putModel(later, kNow + 2 * kHour), 'made');
    });

    test('the same put again changes nothing; other bytes or another owner are refused', async () => {
      const store = await fresh();
      const model = { id: id(), owner: hash(), expires: kNow + kHour, bytes: Buffer.from('abc') };
      assert.equal(await store.putModel(model, kNow), 'made');
      assert.equal(await store.putModel(model, kNow), 'same');
      assert.equal(await store.putModel({ ...model, bytes: Buffer.from('abd') }, kNow), 'taken');
      assert.equal(await store.putModel({ ...model, owner: hash() }, kNow), 'taken');
      assert.equal(await store.createBox({ ...model, kind: 'room' }, kNow), 'taken');
      assert.deepEqual((await store.post(model.id, 'model')).bytes, Buffer.from('abc'));
      assert.deepEqual(await store.totals(), { models: 1, rooms: 0, posts: 1, bytes: 3 });
    });

    test('posts are numbered 1, 2, 3 … in the order in which they are seen, whoever writes at once', async () => {
      const store = await fresh();
      const other = await second();
      const room = await withRoom(store);
      const names = Array.from({ length: 40 }, () => id());
      const put = (to, i) =>
        to.putPost({ box: room.id, post: names[i], seat: room.seat, bytes: Buffer.from([i]) }, kRoomy, kNow);
      const done = await Promise.all(names.map((_, i) => put(i % 2 ? store : other, i)));
      assert.deepEqual(
        done.map(({ seq }) => seq).sort((a, b) => a - b),
        names.map((_, i) => i + 1),
      );
      const listed = await other.posts(room.id, {});
      assert.deepEqual(
        listed.map(({ seq }) => seq),
        names.map((_, i) => i + 1),
      );
      for (const { post, seq } of listed) assert.equal(done[names.indexOf(post)].seq, seq);
      assert.deepEqual(
        (await store.posts(room.id, { after: 5, most: 3 })).map(({ seq }) => seq),
        [6, 7, 8],
      );
    });

    test("a post comes once however often it is sent, and another's post cannot be changed", async () => {
      const store = await fresh();
      const room = await withRoom(store);
      const name = id();
      assert.deepEqual(await room.post('one', room.seat, kRoomy, name), { result: 'stored', seq: 1 });
      assert.deepEqual(await room.post('one', room.seat, kRoomy, name), { result: 'same', seq: 1 });
      assert.equal((await room.post('two', room.seat, kRoomy, name)).result, 'taken');
      assert.equal((await room.post('one', null, kRoomy, name)).result, 'taken');
      assert.deepEqual(await room.post('three', null), { result: 'stored', seq: 2 });
      assert.deepEqual(
        (await store.posts(room.id, { ofOwner: true })).map(({ seq, seat }) => [seq, seat]),
        [[2, null]],
      );
      assert.equal((await store.post(room.id, name)).bytes.toString(), 'one');
    });

    test('a room takes as much as was agreed and no more, and a frozen one takes from its teacher alone', async () => {
      const store = await fresh();
      const room = await withRoom(store);
      const small = { bytes: 10, posts: 3 };
      assert.equal((await room.post('12345678', room.seat, small)).result, 'stored');
      assert.equal((await room.post('123', room.seat, small)).result, 'full');
      assert.equal((await room.post('12', room.seat, small)).result, 'stored');
      await store.setFrozen(room.id, true);
      assert.equal((await store.box(room.id, kNow)).frozen, true);
      assert.equal((await room.post('1')).result, 'frozen');
      assert.equal((await room.post('1', null)).result, 'stored');
      assert.equal((await room.post('1', null, { bytes: 1e6, posts: 3 })).result, 'full');
      await store.setFrozen(room.id, false);
      assert.equal((await room.post('1')).result, 'stored');
    });

    test('seats are as many as was agreed, each with its own secret', async () => {
      const store = await fresh();
      const room = await withRoom(store);
      const [seat, secret] = [id(), hash()];
      const sit = async (box, at, by) => Object.values(await store.putSeat({ box, seat: at, secret: by }, 2, kNow));
      assert.deepEqual(await sit(room.id, seat, secret), ['made', 2]);
      assert.deepEqual(await sit(room.id, seat, secret), ['same', 2]);
      assert.equal((await sit(room.id, seat, hash()))[0], 'taken');
      assert.equal((await sit(room.id, id(), secret))[0], 'full');
      assert.equal((await sit(id(), seat, secret))[0], 'none');
      assert.deepEqual(await store.seat(room.id, seat), secret);
      assert.equal(await store.seat(room.id, id()), null);
    });

    test('hiding is a mark on a post that can be taken off', async () => {
      const store = await fresh();
      const room = await withRoom(store);
      const name = id();
      await room.post('x', room.seat, kRoomy, name);
      await store.setHidden(room.id, name, true);
      assert.deepEqual(await store.state(room.id), { frozen: false, hidden: [name] });
      assert.equal((await store.post(room.id, name)).hidden, true);
      await store.setHidden(room.id, name, false);
      assert.deepEqual(await store.state(room.id), { frozen: false, hidden: [] });
    });

    test('words lead to one room until they expire, are replaced, or the room is gone', async () => {
      const store = await fresh();
      const [room, other] = [await withRoom(store), await withRoom(store)];
      const wrapped = randomBytes(80);
      const words = (box, locator) => ({ locator, box, wrapped, expires: kNow + kHour / 2 });
      const [first, next] = [id(), id()];
      assert.equal(await store.putWords(words(room.id, first), kNow), 'made');
      assert.deepEqual(await store.words(first, kNow), wrapped);
      assert.equal(await store.putWords(words(other.id, first), kNow), 'taken');
      assert.equal(await store.words(first, kNow + kHour / 2), null);
      assert.equal(await store.putWords(words(room.id, next), kNow), 'made');
      assert.equal(await store.words(first, kNow), null);
      await store.removeBox(room.id);
      assert.equal(await store.words(next, kNow), null);
      assert.equal(await store.putWords(words(other.id, first), kNow), 'made');
      assert.equal(await store.putWords(words((await withRoom(store)).id, first), kNow + kHour / 2), 'made');
      await store.dropWords(other.id);
    });

    test('whoever watches a room on this server or another hears of each change, and of no other room', async () => {
      const store = await fresh();
      const other = await second();
      const [room, quiet] = [await withRoom(store), await withRoom(store)];
      const heard = [],
        unheard = [];
      const watched = kit.name === 'SQLite' ? store : other;
      watched.watch(room.id, ({ what }) => heard.push(what));
      watched.watch(quiet.id, ({ what }) => unheard.push(what));
      await room.post('a');
      await room.post('b', null);
      await store.setFrozen(room.id, true);
      await store.removeBox(room.id);
      for (let tries = 0; heard.length < 4 && tries < 200; tries += 1)
        await new Promise((done) => setTimeout(done, 10));
      assert.deepEqual(heard, ['seat', 'owner', 'state', 'ended']);
      assert.deepEqual(unheard, []);
    });

    test('a removed box takes everything in it along', async () => {
      const store = await fresh();
      const room = await withRoom(store);
      const name = id();
      await room.post('gone', room.seat, kRoomy, name);
      await store.removeBox(room.id);
      assert.equal(await store.box(room.id, kNow), null);
      assert.equal(await store.post(room.id, name), null);
      assert.equal(await store.seat(room.id, room.seat), null);
      assert.deepEqual(await store.posts(room.id, {}), []);
      assert.deepEqual(await store.totals(), { models: 0, rooms: 0, posts: 0, bytes: 0 });
    });

    test('what was stored is there for the next server that opens the store', async () => {
      const store = await fresh();
      const model = { id: id(), owner: hash(), expires: kNow + kHour, bytes: randomBytes(1000) };
      await store.putModel(model, kNow);
      const other = await second();
      assert.deepEqual((await other.post(model.id, 'model')).bytes, model.bytes);
      assert.equal(await other.putModel(model, kNow), 'same');
    });

    const model = (bytes) => ({ id: id(), owner: hash(), expires: kNow + kHour, bytes });

    /** What is full takes nothing, and `stored` is there as before, also for a server that opens the store anew. */
    async function isFull(store, room, stored) {
      const before = await store.totals();
      await assert.rejects(store.putModel(model(randomBytes(200_000)), kNow), StoreFull);
      const post = { box: room.id, post: id(), seat: null, bytes: randomBytes(200_000) };
      await assert.rejects(store.putPost(post, kRoomy, kNow), StoreFull);
      assert.deepEqual(await store.totals(), before);
      const other = await second();
      for (const one of [store, other])
        for (const [name, bytes] of stored) assert.ok((await one.post(name, 'model')).bytes.equals(bytes));
    }

    if (name === 'SQLite')
      test('a file that may have no more bytes says that it is full, and takes again what has room', async () => {
        const diskBytes = 2 ** 20;
        const store = await fresh({ diskBytes });
        const room = await withRoom(store);
        const stored = new Map();
        let failure = null;
        while (!failure && stored.size < 100) {
          const one = model(randomBytes(50_000));
          failure = await store.putModel(one, kNow).then(
            () => void stored.set(one.id, one.bytes),
            (error) => error,
          );
        }
        assert.ok(failure instanceof StoreFull, String(failure));
        assert.ok(stored.size > 10, `${stored.size} stored`);
        await isFull(store, room, stored);
        await store.scrub();
        assert.ok(statSync(kit.address()).size <= diskBytes);
        for (const name of [...stored.keys()].slice(0, 5)) {
          await store.removeBox(name);
          stored.delete(name);
        }
        assert.equal(await store.putModel(model(randomBytes(200_000)), kNow), 'made');
      });
    else
      test('a database that has no more room on its disk or in its memory says that it is full', async () => {
        const store = await fresh();
        const room = await withRoom(store);
        const first = model(randomBytes(1000));
        await store.putModel(first, kNow);
        const stored = new Map([[first.id, first.bytes]]);
        const failWith = (sqlstate) =>
          store.ask(`
            CREATE OR REPLACE FUNCTION fail() RETURNS trigger LANGUAGE plpgsql AS
              $$ BEGIN RAISE EXCEPTION 'no more' USING ERRCODE = '${sqlstate}'; END $$;
            CREATE OR REPLACE TRIGGER fail BEFORE INSERT ON spineloft_posts EXECUTE FUNCTION fail();
            CREATE OR REPLACE TRIGGER fail BEFORE DELETE ON spineloft_words EXECUTE FUNCTION fail();`);
        for (const sqlstate of ['53100', '53200']) {
          await failWith(sqlstate);
          await isFull(store, room, stored);
          await assert.rejects(store.dropWords(room.id), StoreFull);
        }
        await failWith('57014'); // query_canceled
        await assert.rejects(store.putModel(model(randomBytes(10)), kNow), { code: '57014' });
        await store.ask('DROP FUNCTION fail CASCADE');
        assert.equal(await store.putModel(model(randomBytes(10)), kNow), 'made');
      });
  });
}
