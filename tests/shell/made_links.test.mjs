// The short links that a browser made, also where it keeps nothing.
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { load } from './support/load.mjs';

const { keepLinks, madeLinks } = await load('room/made_links.ts');

const link = (id, until = Date.now() + 1000) => ({ id, key: 'k', secret: 's', name: id, url: `u${id}`, until });
const kept = new Map();
const storage = {
  getItem: (key) => kept.get(key) ?? null,
  setItem: (key, text) => kept.set(key, text),
};
const blocked = {
  getItem: () => {
    throw new Error('blocked');
  },
  setItem: () => {
    throw new Error('blocked');
  },
};

beforeEach(() => {
  kept.clear();
  globalThis.localStorage = storage;
  keepLinks([]);
});

test('links that were made are there in their order until they expire, and one that is taken back is not', () => {
  keepLinks([link('a'), link('b', Date.now() - 1), link('c')]);
  assert.deepEqual(
    madeLinks().map(({ id }) => id),
    ['a', 'c'],
  );
  keepLinks(madeLinks().filter(({ id }) => id !== 'a'));
  assert.deepEqual(
    madeLinks().map(({ id }) => id),
    ['c'],
  );
});

test('a browser that keeps nothing knows its links until the page is closed', () => {
  globalThis.localStorage = blocked;
  keepLinks([...madeLinks(), link('a')]);
  keepLinks([...madeLinks(), link('b')]);
  assert.deepEqual(
    madeLinks().map(({ id }) => id),
    ['a', 'b'],
  );
  keepLinks(madeLinks().filter(({ id }) => id !== 'a'));
  assert.deepEqual(
    madeLinks().map(({ id }) => id),
    ['b'],
  );
});

test('a full disk keeps what was there and knows what is new', () => {
  keepLinks([link('a')]);
  globalThis.localStorage = { ...storage, setItem: blocked.setItem };
  keepLinks([...madeLinks(), link('b')]);
  assert.deepEqual(
    madeLinks().map(({ id }) => id),
    ['a', 'b'],
  );
});
