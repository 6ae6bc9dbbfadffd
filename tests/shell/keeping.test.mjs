// The storage of models without a browser, on an IndexedDB of Node: whatever ends a page, and whenever, a model is
// kept up to a whole step, and nothing is stored twice.
import 'fake-indexeddb/auto';
import assert from 'node:assert/strict';
import test from 'node:test';
import { IDBFactory } from 'fake-indexeddb';
import { loadShell } from '../browser/support/shell.mjs';
import { seeded } from '../support/random.mjs';

const { JournalWriter, ModelStore, packPhoto, unpackPhoto, whenText } = await loadShell(`
  export { JournalWriter } from './keep/journal_writer.ts';
  export { ModelStore } from './keep/store.ts';
  export { packPhoto, unpackPhoto } from './keep/pack.ts';
  export { whenText } from './keep/models_view.ts';
`);

/** An engine in a few lines: its history is a list of words, a record is one word, a photo's pixels follow from its hash. */
class FakeEngine {
  words = [];
  shown = new Set();
  history() {
    return JSON.stringify(this.words);
  }
  photos() {
    return [...this.shown];
  }
  photo(hash) {
    const rgba = new Uint8Array(4 * 8 * 8).map((_, i) => (i * hash.length) & 255);
    return this.shown.has(hash) ? { hash, width: 8, height: 8, originalWidth: 80, originalHeight: 80, rgba } : null;
  }
  about() {
    return { name: `m${this.words.length}`, pictures: this.shown.size, parts: this.words.length };
  }
  step(word, photo) {
    this.words.push(word);
    if (photo) this.shown.add(photo);
    return { type: 'journal', record: word, photos: photo ? [photo] : [], ...this.about() };
  }
}

let ids = 0;
function writerOf(engine, store, more = {}) {
  const log = { kept: 0, troubles: [], since: [], taken: 0, late: [] };
  const writer = new JournalWriter(
    engine,
    store,
    more.token ?? 'me',
    {
      begin: async () => more.id ?? `model-${(ids += 1)}`,
      reopen: more.reopen ?? (async () => store),
      kept: () => {
        log.kept += 1;
      },
      trouble: (failure, since) => {
        log.troubles.push(failure?.code ?? null);
        if (failure) log.since.push(since);
      },
      taken: () => {
        log.taken += 1;
      },
      late: (isLate) => log.late.push(isLate),
    },
    more.now ?? (() => 1000),
    // No test waits: what is to run later is run by hand.
    more.later ?? (() => () => undefined),
  );
  return { writer, log };
}

/** Time that goes on by hand, and what waits for it. */
class Clock {
  now = 1000;
  timers = new Set();
  parts = {
    now: () => this.now,
    later: (ms, work) => {
      const timer = { at: this.now + ms, work };
      this.timers.add(timer);
      return () => this.timers.delete(timer);
    },
  };
  /** Goes on to the next thing that waits, and does it; how long that was. */
  next() {
    const timer = [...this.timers].sort((a, b) => a.at - b.at)[0],
      waited = timer.at - this.now;
    this.timers.delete(timer);
    this.now = timer.at;
    timer.work();
    return waited;
  }
}

/** Has the store answer writes only when it is told to; what it returns lets all of them go on. */
function silenced() {
  const original = ModelStore.prototype.write,
    held = [];
  ModelStore.prototype.write = async function write(change) {
    await new Promise((resolve) => held.push(resolve));
    return original.call(this, change);
  };
  return () => {
    ModelStore.prototype.write = original;
    for (const goOn of held) goOn();
  };
}

/** Lets everything run that waits for nothing. */
const breathe = () => new Promise((resolve) => setTimeout(resolve, 20));

async function untilSafe(writer) {
  for (let i = 0; i < 500 && !writer.isSafe; ++i) await breathe();
  assert.equal(writer.isSafe, true);
}

async function freshStore() {
  globalThis.indexedDB = new IDBFactory();
  return ModelStore.open();
}

/** The words that a page would read back. */
async function readBack(store, id, token = 'me') {
  const kept = await store.read(id, token);
  return kept && { words: [...JSON.parse(kept.base), ...kept.records], kept };
}

const settle = async (writer) => {
  await new Promise((resolve) => setTimeout(resolve));
  await writer.settled();
};

test('every step is a record of its own, a burst is one transaction, and what is read back is what was done', async () => {
  const store = await freshStore();
  const engine = new FakeEngine();
  const { writer, log } = writerOf(engine, store, { id: 'a' });
  writer.take(engine.step('one', 'photo'));
  await settle(writer);
  assert.equal(log.kept, 1);
  for (const word of ['two', 'three', 'four']) writer.take(engine.step(word));
  await settle(writer);
  assert.equal(log.kept, 2, 'three steps at once');
  assert.equal(writer.isSafe, true);
  const { words, kept } = await readBack(store, 'a');
  assert.deepEqual(words, engine.words);
  assert.equal(kept.records.length, 3);
  assert.equal(kept.info.parts, 4);
  assert.deepEqual(kept.info.photos, ['photo']);
  store.close();
});

test('a long journal is folded into a new base, and the old records are gone', async () => {
  const store = await freshStore();
  const engine = new FakeEngine();
  const { writer } = writerOf(engine, store, { id: 'a' });
  for (let i = 0; i < 900; ++i) {
    writer.take(engine.step(`w${i}`));
    if (i % 3 === 0) await settle(writer);
  }
  await settle(writer);
  const { words, kept } = await readBack(store, 'a');
  assert.deepEqual(words, engine.words);
  assert.ok(kept.records.length < 402, `${kept.records.length} records`);
  for (let i = 0; i < 40; ++i) writer.take(engine.step('x'.repeat(20000)));
  await settle(writer);
  writer.take(engine.step('last'));
  await settle(writer);
  const after = await store.read('a', 'me');
  assert.equal(after.records.length, 0, 'a heavy journal is folded too');
  store.close();
});

/** Makes the database fail at its n-th writing transaction, and from then on: the page is dead. */
function killAt(count, moment) {
  let left = count;
  const original = globalThis.IDBDatabase.prototype.transaction;
  globalThis.IDBDatabase.prototype.transaction = function transaction(names, mode, options) {
    if (mode !== 'readwrite') return original.call(this, names, mode, options);
    left -= 1;
    if (left < 0) throw new DOMException('dead', 'InvalidStateError');
    const made = original.call(this, names, mode, options);
    if (left === 0 && moment === 'within') {
      // In the middle of it: after its first request.
      const get = made.objectStore.bind(made);
      made.objectStore = (name) => {
        queueMicrotask(() => {
          try {
            made.abort();
          } catch {
            /* over already */
          }
        });
        return get(name);
      };
    }
    return made;
  };
  return () => {
    globalThis.IDBDatabase.prototype.transaction = original;
  };
}

for (const moment of ['before', 'within']) {
  test(`a page that dies ${moment} any transaction leaves a model that opens, at most the burst in hand old`, async () => {
    for (let death = 1; death <= 24; ++death) {
      const store = await freshStore();
      const engine = new FakeEngine();
      const { writer } = writerOf(engine, store, { id: 'a' });
      const random = seeded(death);
      const states = [[]];
      const revive = killAt(death, moment);
      for (let i = 0; i < 30; ++i) {
        writer.take(engine.step(`w${i}`, random() < 0.2 ? `photo${i}` : undefined));
        if (random() < 0.15) writer.rewrite();
        await settle(writer);
        if (!writer.isSafe) break;
        states.push([...engine.words]);
      }
      revive();
      store.close();
      const reopened = await ModelStore.open();
      const back = await readBack(reopened, 'a');
      if (back) {
        const last = states.at(-1);
        assert.ok(
          back.words.length >= last.length && back.words.length <= last.length + 1,
          `death ${death}: ${back.words.length} of ${last.length}`,
        );
        assert.deepEqual(back.words, engine.words.slice(0, back.words.length));
        assert.equal(back.kept.lost, 0);
        assert.deepEqual(await reopened.missingPhotos(back.kept.info.photos), []);
      } else {
        assert.equal(states.length, 1, 'only what was never kept may be missing');
      }
      reopened.close();
    }
  });
}

test('a photo is stored once however many models show it, and goes with the last of them', async () => {
  const store = await freshStore();
  for (const id of ['a', 'b']) {
    const engine = new FakeEngine();
    const { writer } = writerOf(engine, store, { id });
    writer.take(engine.step('one', 'shared'));
    writer.take(engine.step('two', `only-${id}`));
    await settle(writer);
  }
  const copy = await store.duplicate('a', 'copy', 5);
  await store.delete('a', 10);
  await store.sweep(10);
  assert.deepEqual(await store.missingPhotos(['shared', 'only-a', 'only-b']), [], 'the copy still shows them');
  await store.delete(copy.id, 20);
  await store.sweep(15);
  assert.deepEqual(await store.missingPhotos(['only-a']), [], 'not yet swept');
  await store.undelete(copy.id);
  assert.deepEqual((await readBack(store, copy.id)).words, ['one', 'two']);
  await store.delete(copy.id, 20);
  await store.sweep(20);
  assert.deepEqual(await store.missingPhotos(['shared', 'only-a', 'only-b']), ['only-a']);
  assert.deepEqual(
    (await store.list()).map((model) => model.id),
    ['b'],
  );
  store.close();
});

test('a photo that another tab swept away meanwhile is written again', async () => {
  const store = await freshStore();
  const engine = new FakeEngine();
  const { writer, log } = writerOf(engine, store, { id: 'a' });
  writer.take(engine.step('one', 'photo'));
  await settle(writer);
  const database = await new Promise((resolve) => {
    const open = indexedDB.open('spineloft');
    open.onsuccess = () => resolve(open.result);
  });
  await new Promise((resolve) => {
    const tx = database.transaction('photos', 'readwrite');
    tx.objectStore('photos').clear();
    tx.oncomplete = resolve;
  });
  database.close();
  writer.take(engine.step('two', 'photo'));
  await settle(writer);
  assert.deepEqual(log.troubles, []);
  assert.deepEqual(await store.missingPhotos(['photo']), []);
  assert.deepEqual((await readBack(store, 'a')).words, ['one', 'two']);
  store.close();
});

test('who opened a model last writes it: the page before finds out and writes nothing', async () => {
  const store = await freshStore();
  const engine = new FakeEngine();
  const { writer, log } = writerOf(engine, store, { id: 'a', token: 'first' });
  writer.take(engine.step('one'));
  await settle(writer);
  const { words } = await readBack(store, 'a', 'second');
  writer.take(engine.step('two'));
  await settle(writer);
  assert.equal(log.taken, 1);
  assert.equal(writer.isSafe, false);
  writer.take(engine.step('three'));
  await settle(writer);
  assert.deepEqual((await readBack(store, 'a', 'second')).words, words);
  store.close();
});

test('a full disk is told once, not on every step, and everything is kept as soon as there is room', async () => {
  const store = await freshStore();
  const engine = new FakeEngine();
  let now = 0;
  const { writer, log } = writerOf(engine, store, { id: 'a', now: () => now });
  writer.take(engine.step('one'));
  await settle(writer);
  const original = ModelStore.prototype.write;
  let tries = 0;
  ModelStore.prototype.write = async () => {
    tries += 1;
    throw Object.assign(new Error('full'), { name: 'QuotaExceededError' });
  };
  for (let i = 0; i < 50; ++i) {
    writer.take(engine.step(`lost${i}`));
    await settle(writer);
    now += 10;
  }
  assert.deepEqual(log.troubles, ['full']);
  assert.equal(tries, 1);
  now += 10000;
  writer.take(engine.step('later'));
  await settle(writer);
  assert.equal(tries, 2);
  ModelStore.prototype.write = original;
  writer.retry();
  await settle(writer);
  assert.deepEqual(log.troubles, ['full', null]);
  assert.deepEqual((await readBack(store, 'a')).words, engine.words);
  assert.equal(writer.isSafe, true);
  store.close();
});

test('while the disk is full it is tried again by itself, with pauses that double up to five minutes, until all is kept', async () => {
  const store = await freshStore();
  const engine = new FakeEngine();
  const clock = new Clock();
  const { writer, log } = writerOf(engine, store, { id: 'a', ...clock.parts });
  const original = ModelStore.prototype.write;
  ModelStore.prototype.write = async () => {
    throw Object.assign(new Error('full'), { name: 'QuotaExceededError' });
  };
  writer.take(engine.step('one'));
  await settle(writer);
  const pauses = [];
  for (let i = 0; i < 10; ++i) {
    pauses.push(clock.next());
    await settle(writer);
  }
  ModelStore.prototype.write = original;
  assert.deepEqual(
    pauses,
    [5, 10, 20, 40, 80, 160, 300, 300, 300, 300].map((seconds) => 1000 * seconds),
  );
  assert.deepEqual([log.troubles, log.since], [['full'], [1000]]);
  clock.next();
  await settle(writer);
  assert.equal(clock.timers.size, 0);
  assert.deepEqual(log.troubles, ['full', null]);
  assert.deepEqual((await readBack(store, 'a')).words, ['one']);
  store.close();
});

test('a step is on the disk, or said to be late, within 100 ms of being taken, also when it comes during another write', async () => {
  const store = await freshStore();
  const engine = new FakeEngine();
  const clock = new Clock();
  const { writer, log } = writerOf(engine, store, { id: 'a', ...clock.parts });
  writer.take(engine.step('quick'));
  await settle(writer);
  assert.deepEqual([log.late, log.kept, clock.timers.size], [[], 1, 0], 'nothing is said of a quick one');
  const goOn = silenced();
  writer.take(engine.step('one'));
  await breathe();
  writer.take(engine.step('two'));
  const begun = clock.now;
  clock.next();
  assert.deepEqual(log.late, [true]);
  // It may have waited 40 ms in the engine, and for a write that took nearly as long as it may without a word.
  assert.ok(40 + 2 * (clock.now - begun) <= 100, `${clock.now - begun} ms`);
  assert.equal(writer.isSafe, false);
  goOn();
  await settle(writer);
  assert.deepEqual([log.late, log.troubles, writer.isSafe], [[true, false], [], true]);
  assert.deepEqual((await readBack(store, 'a')).words, engine.words);
  store.close();
});

test('a store that never answers is trouble that is told, holds nothing up, and gets everything once it answers', async () => {
  const store = await freshStore();
  const engine = new FakeEngine();
  const clock = new Clock();
  const { writer, log } = writerOf(engine, store, { id: 'a', ...clock.parts });
  writer.take(engine.step('one', 'photo'));
  await settle(writer);
  const goOn = silenced();
  writer.take(engine.step('two'));
  await breathe();
  const settled = writer.settled();
  clock.next();
  clock.next();
  await settled;
  assert.deepEqual([log.troubles, log.late], [['silent'], [true, false]]);
  assert.deepEqual([writer.isBusy, writer.isSafe, writer.isInTrouble], [false, false, true]);
  for (const word of ['three', 'four']) writer.take(engine.step(word));
  await writer.settled();
  goOn();
  await untilSafe(writer);
  assert.deepEqual([log.troubles, log.late, writer.isSafe], [['silent', null], [true, false], true]);
  assert.deepEqual((await readBack(store, 'a')).words, engine.words);
  store.close();
});

test('a write that never ends is given up, and the next try keeps everything', async () => {
  const store = await freshStore();
  const engine = new FakeEngine();
  const clock = new Clock();
  const { writer, log } = writerOf(engine, store, { id: 'a', ...clock.parts });
  const original = ModelStore.prototype.missingPhotos;
  ModelStore.prototype.missingPhotos = () => new Promise(() => undefined);
  writer.take(engine.step('one', 'photo'));
  await breathe();
  clock.next();
  clock.next();
  ModelStore.prototype.missingPhotos = original;
  writer.take(engine.step('two'));
  await settle(writer);
  assert.deepEqual([log.troubles, log.kept], [['silent'], 0]);
  clock.next();
  await untilSafe(writer);
  assert.deepEqual([log.troubles, clock.timers.size], [['silent', null], 0]);
  assert.deepEqual((await readBack(store, 'a')).words, engine.words);
  store.close();
});

test('a model that is left while the store does not answer is not mixed with the next one', async () => {
  for (const isNew of [true, false]) {
    const store = await freshStore();
    const engine = new FakeEngine();
    const clock = new Clock();
    const { writer } = writerOf(engine, store, clock.parts);
    if (!isNew) {
      writer.take(engine.step('one'));
      await settle(writer);
    }
    const goOn = silenced();
    writer.take(engine.step('old'));
    await breathe();
    clock.next();
    clock.next();
    const next = new FakeEngine();
    Object.assign(engine, { words: next.words, shown: next.shown });
    writer.attach(null);
    writer.take(engine.step('new'));
    goOn();
    await untilSafe(writer);
    const kept = await store.list();
    const words = await Promise.all(kept.map(async ({ id }) => (await readBack(store, id)).words.join()));
    assert.deepEqual(words.sort(), isNew ? ['new', 'old'] : ['new', 'one,old']);
    store.close();
  }
});

test("when the site's data is cleared under an open page, the next step keeps everything anew", async () => {
  const store = await freshStore();
  const engine = new FakeEngine();
  const { writer, log } = writerOf(engine, store, { id: 'a', reopen: () => ModelStore.open() });
  writer.take(engine.step('one', 'photo'));
  await settle(writer);
  store.close();
  await new Promise((resolve) => {
    indexedDB.deleteDatabase('spineloft').onsuccess = resolve;
  });
  writer.take(engine.step('two'));
  await settle(writer);
  assert.deepEqual(log.troubles, []);
  assert.equal(writer.isSafe, true);
  const fresh = await ModelStore.open();
  assert.deepEqual(await fresh.missingPhotos(['photo']), []);
  assert.deepEqual((await readBack(fresh, 'a')).words, ['one', 'two']);
  fresh.close();
});

test('without a store every page goes on, and trouble is told at the first step only', async () => {
  const engine = new FakeEngine();
  const { writer, log } = writerOf(engine, null);
  await settle(writer);
  assert.deepEqual(log.troubles, []);
  for (let i = 0; i < 5; ++i) {
    writer.take(engine.step('word'));
    await settle(writer);
  }
  assert.deepEqual(log.troubles, ['missing']);
  assert.equal(writer.isSafe, false);
});

test('storage that is missing, blocked, too new or silent is named', async () => {
  const code = (work) =>
    work.then(
      () => null,
      (failure) => failure.code,
    );
  globalThis.indexedDB = undefined;
  assert.equal(await code(ModelStore.open()), 'missing');
  globalThis.indexedDB = {
    open() {
      throw Object.assign(new Error('no'), { name: 'SecurityError' });
    },
  };
  assert.equal(await code(ModelStore.open()), 'missing');
  globalThis.indexedDB = {
    open: () => Object.assign(Object.create(IDBOpenDBRequest.prototype), { addEventListener() {} }),
  };
  assert.equal(await code(ModelStore.open(20)), 'silent');
  const factory = new IDBFactory();
  globalThis.indexedDB = factory;
  await new Promise((resolve) => {
    const open = factory.open('spineloft', 99);
    open.onsuccess = () => {
      open.result.close();
      resolve();
    };
  });
  assert.equal(await code(ModelStore.open()), 'newer');
});

test('records behind a gap, or that are no text, are left out and counted', async () => {
  const store = await freshStore();
  const engine = new FakeEngine();
  const { writer } = writerOf(engine, store, { id: 'a' });
  writer.take(engine.step('base'));
  await settle(writer);
  for (let i = 0; i < 6; ++i) writer.take(engine.step(`w${i}`));
  await settle(writer);
  const database = await new Promise((resolve) => {
    const open = indexedDB.open('spineloft');
    open.onsuccess = () => resolve(open.result);
  });
  const change = (work) =>
    new Promise((resolve) => {
      const tx = database.transaction('journal', 'readwrite');
      work(tx.objectStore('journal'));
      tx.oncomplete = resolve;
    });
  await change((journal) => journal.put({ model: 'a', sequence: 4, text: 7 }));
  let back = await readBack(store, 'a', 'me');
  assert.deepEqual(back.words, ['base', 'w0', 'w1', 'w2', 'w3']);
  assert.equal(back.kept.lost, 2);
  await change((journal) => journal.delete(['a', 1]));
  back = await readBack(store, 'a', 'me');
  assert.deepEqual(back.words, ['base', 'w0']);
  assert.equal(back.kept.lost, 5);
  database.close();
  store.close();
});

test('for browsers without locks: a model is held by signs of life, and free when they end', async () => {
  const store = await freshStore();
  assert.equal(await store.hold('a', 'tab1', 1000, 0), true);
  assert.equal(await store.hold('a', 'tab2', 2000, 500), false);
  assert.deepEqual(await store.held(500), ['a']);
  assert.equal(await store.hold('a', 'tab1', 3000, 0), true);
  assert.equal(await store.hold('a', 'tab2', 9000, 3000), true, 'no life for long enough');
  assert.equal(await store.hold('a', 'tab1', 9001, 3001), false);
  await store.letGo('a', 'tab1');
  assert.deepEqual(await store.held(0), ['a'], 'only its holder lets it go');
  await store.letGo('a', 'tab2');
  assert.deepEqual(await store.held(0), []);
  store.close();
});

test('a photo comes back bit for bit, smaller where it can be, and a damaged one not at all', async () => {
  const random = seeded(7);
  for (const noisy of [false, true]) {
    const rgba = new Uint8Array(4 * 64 * 48).map((_, i) => (noisy ? random() * 256 : i >> 6));
    const photo = { hash: 'h', width: 64, height: 48, originalWidth: 640, originalHeight: 480, rgba };
    const packed = await packPhoto(photo);
    assert.ok(packed.bytes.length <= rgba.length);
    assert.equal(packed.packing, noisy ? 'none' : 'deflate-raw');
    assert.deepEqual(await unpackPhoto(packed), photo);
    for (const bad of [{ bytes: packed.bytes.slice(0, packed.bytes.length >> 1) }, { width: 65 }, { width: 32 }]) {
      assert.equal(await unpackPhoto({ ...packed, ...bad }), null);
    }
  }
});

test('dates read as people say them', () => {
  const now = new Date(2026, 4, 20, 15, 0).getTime();
  assert.equal(whenText(new Date(2026, 4, 20, 9, 5).getTime(), now), 'today, 9:05 AM');
  assert.equal(whenText(new Date(2026, 4, 19, 23, 59).getTime(), now), 'yesterday, 11:59 PM');
  assert.equal(whenText(new Date(2025, 11, 24, 12, 0).getTime(), now), 'Dec 24, 2025');
});
