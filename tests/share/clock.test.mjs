// The clock by which things expire, alone and in a server, and the counters of what goes wrong.
import assert from 'node:assert/strict';
import { randomBytes } from 'node:crypto';
import { test } from 'node:test';
import { Clock } from '../../web/share/clock.mjs';
import { Addresses, Misses } from '../../web/share/limiting.mjs';
import { loadClient, rawAsk, startServer, until } from './support/server.mjs';
import { sqliteKit } from './support/stores.mjs';

const kMinute = 60_000,
  kDay = 24 * 60 * kMinute;

/** Two clocks that tests turn. */
function hands() {
  const now = { wall: 1_700_000_000_000, steady: 5000 };
  const clock = new Clock({ wall: () => now.wall, steady: () => now.steady, patience: 10 * kMinute });
  const pass = (milliseconds, wall = milliseconds) => {
    now.wall += wall;
    now.steady += milliseconds;
  };
  return { clock, now, pass };
}

test('a clock that jumps for a moment, forward or back, changes nothing', () => {
  for (const jump of [400 * 24 * 60 * kMinute, -400 * 24 * 60 * kMinute]) {
    const { clock, now, pass } = hands();
    const start = clock.now();
    now.wall += jump;
    for (let minute = 1; minute <= 9; minute += 1) {
      pass(kMinute);
      assert.equal(clock.now(), start + minute * kMinute);
    }
    now.wall -= jump;
    pass(kMinute);
    assert.equal(clock.now(), start + 10 * kMinute);
  }
});

test('a clock that stays where it jumped to is believed after ten minutes, as after a sleep', () => {
  const { clock, now, pass } = hands();
  clock.now();
  now.wall += 24 * 60 * kMinute;
  for (let minute = 0; minute <= 11; minute += 1) {
    clock.now();
    pass(kMinute);
  }
  assert.equal(clock.now(), now.wall);
});

test('a clock that drifts is followed', () => {
  const { clock, now, pass } = hands();
  for (let i = 0; i < 1000; i += 1) {
    pass(kMinute, kMinute + 1000);
    assert.ok(Math.abs(clock.now() - now.wall) <= 1);
  }
});

/** A server whose clock tests turn; `swept()` resolves when it has removed what was expired at that time. */
async function turnedServer(t) {
  const kit = sqliteKit();
  const turned = hands();
  const server = await startServer(await kit.open(), { clock: turned.clock, limits: { sweepMs: 10 } });
  t.after(async () => {
    await server.close();
    kit.close();
  });
  let sweeps = 0;
  const { sweep } = server.store;
  server.store.sweep = async (now) => {
    const count = await sweep.call(server.store, now);
    sweeps += 1;
    return count;
  };
  const swept = () => {
    const enough = sweeps + 3;
    return until(() => sweeps >= enough, 'the sweeps');
  };
  const { ShareServer, ...client } = await loadClient();
  return { ...turned, ...client, server, share: new ShareServer(server.url), swept };
}

test('a server whose clock jumps by 400 days and back keeps models, rooms and words; what has had its time goes', async (t) => {
  const { server, share, swept, now, pass } = await turnedServer(t);
  const bytes = randomBytes(1000);
  const [short, long] = [await share.storeModel(bytes, 1), await share.storeModel(bytes, 7)];
  const rooms = [await share.openRoom(1), await share.openRoom(14)];
  const { words } = await share.nameRoom(rooms[1]);
  const statuses = async () => {
    const asked = [...[short, long].map(({ id }) => `models/${id}`), ...rooms.map(({ id }) => `rooms/${id}`)];
    const answers = await Promise.all(asked.map((path) => rawAsk(server.port, `/share/v1/${path}`)));
    return answers.map(({ status }) => status);
  };
  for (const jump of [400 * kDay, -400 * kDay]) {
    now.wall += jump;
    await swept();
    assert.deepEqual(await statuses(), [200, 200, 200, 200]);
    pass(9 * kMinute);
    await swept();
    assert.deepEqual(await statuses(), [200, 200, 200, 200]);
    assert.equal((await share.findRoom(words)).id, rooms[1].id);
    now.wall -= jump;
    await swept();
    assert.deepEqual(await statuses(), [200, 200, 200, 200]);
  }
  assert.deepEqual(Buffer.from(await share.storedModel(long)), bytes);
  pass(kDay);
  await swept();
  assert.deepEqual(await statuses(), [404, 200, 404, 200]);
  pass(6 * kDay);
  await swept();
  assert.deepEqual(await statuses(), [404, 404, 404, 200]);
  pass(7 * kDay);
  await swept();
  assert.deepEqual(await statuses(), [404, 404, 404, 404]);
  assert.deepEqual(await server.store.totals(), { models: 0, rooms: 0, posts: 0, bytes: 0 });
  assert.deepEqual(server.said, []);
});

test('join words end after 90 minutes, and no later than their room', async (t) => {
  const { share, clock, pass } = await turnedServer(t);
  const room = await share.openRoom(1);
  const first = await share.nameRoom(room);
  assert.equal(first.expires, clock.now() + 90 * kMinute);
  pass(90 * kMinute - 1);
  assert.equal((await share.findRoom(first.words)).id, room.id);
  pass(1);
  await assert.rejects(share.findRoom(first.words), { code: 'NotThere' });
  pass(kDay - 120 * kMinute);
  assert.equal((await share.nameRoom(room)).expires, clock.now() + 30 * kMinute);
});

test('misses are counted for each and for all, and forgotten with their window', () => {
  let steady = 0;
  const misses = new Misses({ max: 2, all: 5, timeWindow: 1000 }, () => steady);
  const fail = (key) => {
    const wait = misses.wait(key);
    if (wait === 0) misses.add(key);
    return wait > 0;
  };
  assert.deepEqual([fail('a'), fail('a'), fail('a'), fail('b')], [false, false, true, false]);
  assert.deepEqual([fail('c'), fail('d'), fail('e')], [false, false, true]);
  steady = 1001;
  assert.equal(fail('a'), false);
});

test('an address is not in its name, and a network of IPv6 addresses is one', () => {
  const addresses = new Addresses();
  const of = (ip) => addresses.of({ ip });
  assert.equal(of('10.0.0.1'), of('10.0.0.1'));
  assert.notEqual(of('10.0.0.1'), of('10.0.0.2'));
  assert.equal(of('2001:db8::1'), of('2001:db8:0:0:5::9'));
  assert.notEqual(of('2001:db8::1'), of('2001:db8:0:1::1'));
  assert.notEqual(of('10.0.0.1'), new Addresses().of({ ip: '10.0.0.1' }));
  assert.ok(!of('10.0.0.1').includes('10.0'));
});
