// The clock by which things expire, and the counters of what goes wrong.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Clock } from '../../web/share/clock.mjs';
import { Addresses, Misses } from '../../web/share/limiting.mjs';

const kMinute = 60_000;

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
