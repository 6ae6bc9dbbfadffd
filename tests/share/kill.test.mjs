// Whenever the server is killed, what it has acknowledged is there byte for byte, and half of something is never served;
// a full disk is said and harms nothing that is there.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { randomBytes } from 'node:crypto';
import { mkdtempSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { seeded } from '../support/random.mjs';
import { kRounds } from '../support/rounds.mjs';
import { id, kStoreKits } from './support/stores.mjs';
import { rawAsk } from './support/server.mjs';

const kKills = kRounds > 1 ? 200 : 25;
const kPostgresKills = kRounds > 1 ? 50 : 10;
/** Kills until a new file is begun. */
const kFileKills = 25;
const kProgram = fileURLToPath(new URL('./support/mortal_server.mjs', import.meta.url));

/** What runs still when a test fails. */
const children = new Set();
afterEach(() => children.forEach((child) => child.kill('SIGKILL')));

/** Starts the program; `port` when it listens, `ended` when it has. `blocks`: of 512 bytes, how large a file may get. */
async function start(args, blocks) {
  const words = blocks
    ? ['sh', ['-c', `ulimit -S -f ${blocks}; exec "$@"`, 'sh', process.execPath]]
    : [process.execPath, []];
  const child = spawn(words[0], [...words[1], kProgram, ...args], { stdio: ['ignore', 'pipe', 'inherit'] });
  children.add(child);
  const ended = new Promise((resolve) =>
    child.once('exit', (status, signal) => {
      children.delete(child);
      resolve(signal ?? status);
    }),
  );
  const port = await Promise.race([
    new Promise((resolve) => child.stdout.once('data', (text) => resolve(Number(String(text))))),
    ended.then((how) => {
      throw new Error(`the server ended with ${how}`);
    }),
  ]);
  return { child, port, ended };
}

const kSecret = id();
const headersOf = (body) => ({
  Authorization: `Bearer ${kSecret}`,
  'Content-Type': 'application/octet-stream',
  'Content-Length': body?.length ?? 0,
});
const put = (port, path, body) => rawAsk(port, `/share/v1/${path}`, { method: 'PUT', headers: headersOf(body), body });

/** What was sent, and what was acknowledged of it: by path, bytes; null was taken back. */
class Ledger {
  sent = new Map();
  acknowledged = new Map();
  /** Paths of which nobody knows whether they were taken back: the server was killed meanwhile. */
  open = new Set();
}

/** Stores models and posts, and takes some back, until the server is gone. */
async function work(port, random, ledger) {
  const room = id();
  const lane = async () => {
    for (;;) {
      const path = random() < 0.5 ? `models/${id()}` : `rooms/${room}/posts/${id()}`;
      const body = randomBytes(1 + Math.floor(random() ** 3 * 200_000));
      ledger.sent.set(path, body);
      const { status } = await put(port, path, body);
      assert.equal(status, 201);
      ledger.acknowledged.set(path, body);
      if (path.startsWith('models') && random() < 0.2) {
        ledger.open.add(path);
        const gone = await rawAsk(port, `/share/v1/${path}`, { method: 'DELETE', headers: headersOf() });
        assert.equal(gone.status, 204);
        ledger.open.delete(path);
        ledger.acknowledged.set(path, null);
      }
    }
  };
  const isGone = (error) => {
    if (error instanceof assert.AssertionError) throw error;
  };
  await put(port, `rooms/${room}`).then((answer) => assert.equal(answer.status, 201), isGone);
  await Promise.all([1, 2, 3, 4].map(() => lane().catch(isGone)));
}

/** Everything in the ledger, held against what a server serves. */
async function check(port, ledger) {
  for (const [path, body] of ledger.sent) {
    const response = await fetch(`http://127.0.0.1:${port}/share/v1/${path}`);
    const bytes = Buffer.from(await response.arrayBuffer());
    const known = ledger.acknowledged.get(path);
    if (response.status === 200) {
      assert.ok(bytes.equals(body), `${path} is whole`);
      assert.notEqual(known, null, `${path} was taken back`);
    } else {
      assert.equal(response.status, 404, path);
      assert.ok(!known || ledger.open.has(path), `${path} was acknowledged and is gone`);
      // Taken back before the answer could be sent: it must not come again.
      if (known) ledger.acknowledged.set(path, null);
    }
  }
}

/**
 * Kills servers on the store at `place` with the seeds from `first` on; how much was acknowledged. `counts`: every other
 * one is killed before a statement of its own, the rest at any moment until `latest` milliseconds have passed.
 */
async function killServers(place, { first, kills, counts, latest }) {
  const ledger = new Ledger();
  let acknowledged = 0;
  for (let seed = first; seed < first + kills; seed += 1) {
    const random = seeded(7919 * (seed + 1));
    const byCount = counts && seed % 2 === 0;
    const { child, port, ended } = await start(byCount ? [place, String(1 + Math.floor(random() * 60))] : [place]);
    const timer = byCount ? null : setTimeout(() => child.kill('SIGKILL'), 5 + latest * random());
    const before = ledger.acknowledged.size;
    await work(port, random, ledger);
    clearTimeout(timer);
    assert.equal(await ended, 'SIGKILL');
    acknowledged += ledger.acknowledged.size - before;
    if (seed % 5 === 4 || seed === first + kills - 1) {
      const next = await start([place]);
      await check(next.port, ledger);
      next.child.kill('SIGTERM');
      assert.equal(await next.ended, 0);
      ledger.open.clear();
      for (const path of ledger.sent.keys()) if (!ledger.acknowledged.has(path)) ledger.sent.delete(path);
    }
  }
  return acknowledged;
}

test(`after ${kKills} seeded kills everything that was acknowledged is there, and nothing is half there`, async () => {
  const folder = mkdtempSync(join(tmpdir(), 'spineloft-kill-'));
  let acknowledged = 0;
  try {
    for (let first = 0; first < kKills; first += kFileKills) {
      const kills = Math.min(kFileKills, kKills - first);
      acknowledged += await killServers(join(folder, `${first}.sqlite`), { first, kills, counts: true, latest: 250 });
    }
    assert.ok(acknowledged > 3 * kKills, `${acknowledged} acknowledged`);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});

const { make, skip } = kStoreKits.find(({ name }) => name === 'PostgreSQL');
test(`after ${kPostgresKills} seeded kills on PostgreSQL likewise`, { skip }, async () => {
  const kit = make();
  try {
    const acknowledged = await killServers(kit.place(), {
      first: 1000,
      kills: kPostgresKills,
      counts: false,
      latest: 700,
    });
    assert.ok(acknowledged > 3 * kPostgresKills, `${acknowledged} acknowledged`);
  } finally {
    kit.close();
  }
});

test('a full disk is said, what was stored stays, and with room again the server goes on', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'spineloft-full-'));
  const file = join(folder, 'store.sqlite');
  const blocks = 4000;
  const { child, port, ended } = await start([file], blocks);
  try {
    const ledger = new Ledger();
    const store = async () => {
      const path = `models/${id()}`;
      const body = randomBytes(100_000);
      ledger.sent.set(path, body);
      const answer = await put(port, path, body);
      if (answer.status === 201) ledger.acknowledged.set(path, body);
      return answer;
    };
    let answer;
    for (let tries = 0; tries < 100 && answer?.status !== 507; tries += 1) answer = await store();
    assert.equal(answer.status, 507);
    assert.equal(JSON.parse(answer.body).code, 'ServerFull');
    assert.ok(ledger.acknowledged.size > 5, `${ledger.acknowledged.size} stored`);
    assert.ok(statSync(file).size <= 512 * blocks);
    await check(port, ledger);
    assert.equal((await rawAsk(port, '/share/healthz')).status, 200);
    // prlimit (util-linux) gives the room back.
    const given = spawnSync('prlimit', ['--pid', String(child.pid), '--fsize=unlimited:unlimited']);
    assert.equal(given.status, 0, String(given.stderr));
    assert.equal((await store()).status, 201);
    await check(port, ledger);
  } finally {
    child.kill('SIGTERM');
    await ended;
    rmSync(folder, { recursive: true, force: true });
  }
});
