// Load on the share server by real clients of its protocol (the page's own code), only on this machine: pupils join and hand
// in, and a wall for each room reads what comes. JSON on standard output.
//
//   node tests/bench/class_load.mjs [--pupils 250] [--rooms 1] [--bytes 200000] [--join 60] [--hand-in 60]
//                                   [--store sqlite|postgres] [--servers 1] [--most-p95 MS] [--most-mb MB]
//
// It ends with 1 when something was lost or failed, when 95 of 100 hand-ins took longer than --most-p95 until the wall had
// them, or a server needed more memory than --most-mb.
//
// Servers are processes of their own, so that their memory is theirs. Bounded: at most 1000 pupils, 5 minutes.
import { fork } from 'node:child_process';
import { randomBytes } from 'node:crypto';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { loadClient } from '../share/support/server.mjs';
import { startPostgres } from '../share/support/postgres.mjs';

const kMost = { pupils: 1000, rooms: 50, bytes: 8_000_000, join: 120, handIn: 120, servers: 4 };
const kCardBytes = 30_000;
const kPatienceMs = 300_000;

function numbers() {
  const { values } = parseArgs({
    options: {
      pupils: { type: 'string', default: '250' },
      rooms: { type: 'string', default: '1' },
      bytes: { type: 'string', default: '200000' },
      join: { type: 'string', default: '60' },
      'hand-in': { type: 'string', default: '60' },
      servers: { type: 'string', default: '1' },
      store: { type: 'string', default: 'sqlite' },
      'most-p95': { type: 'string', default: 'Infinity' },
      'most-mb': { type: 'string', default: 'Infinity' },
    },
  });
  const { 'hand-in': handIn, store, 'most-p95': p95, 'most-mb': mb, ...rest } = values;
  const most = { p95_ms: Number(p95), memory_mb: Number(mb) };
  if (!(most.p95_ms > 0 && most.memory_mb > 0)) throw new Error('--most-p95 and --most-mb are numbers.');
  const all = Object.entries({ ...rest, handIn }).map(([name, text]) => {
    const value = Number(text);
    if (!(value >= 1 && value <= kMost[name])) throw new Error(`${name} is from 1 to ${kMost[name]}.`);
    return [name, value];
  });
  return { wanted: { store, ...Object.fromEntries(all) }, most };
}

const share = (sorted, part) => sorted[Math.min(sorted.length - 1, Math.ceil(part * sorted.length) - 1)];
const figures = (times) => {
  const sorted = [...times].sort((a, b) => a - b);
  const round = (value) => Math.round(10 * value) / 10;
  return {
    count: sorted.length,
    median_ms: round(share(sorted, 0.5)),
    p95_ms: round(share(sorted, 0.95)),
    max_ms: round(sorted.at(-1)),
  };
};
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

let retried = 0;
/** Asks again as the page does, where that may help. */
async function patiently(work) {
  for (let tries = 0; ; tries += 1) {
    try {
      return await work();
    } catch (thrown) {
      if (!thrown.retryAfter || tries >= 5) throw thrown;
      retried += 1;
      await pause(1000 * thrown.retryAfter);
    }
  }
}

/** A server as a process; `url` when it listens. */
async function startServer(store) {
  const child = fork(fileURLToPath(import.meta.url), ['--as-server', store], { stdio: ['ignore', 2, 2, 'ipc'] });
  const port = await new Promise((resolve, reject) => {
    child.once('message', resolve);
    child.once('exit', (status) => reject(new Error(`a server ended with ${status}`)));
  });
  const peak = () => Number(/VmHWM:\s+(\d+)/.exec(readFileSync(`/proc/${child.pid}/status`, 'utf8'))[1]) / 1024;
  return { url: `http://127.0.0.1:${port}/share/v1/`, peak, end: () => child.kill('SIGTERM') };
}

async function load({ pupils, rooms, bytes, join: joinSeconds, handIn: handInSeconds, servers }, urls) {
  const { keyOfWords, newId, Room, ShareServer } = await loadClient();
  const at = (i) => new ShareServer(urls[i % servers]);
  const begun = new Map(); // by the card's post: when its hand-in began, and when it was acknowledged
  const seen = new Map();
  const failures = [];
  const classes = [];
  for (let i = 0; i < rooms; i += 1) {
    const server = at(i);
    const key = await server.openRoom(1);
    const { words } = await server.nameRoom(key);
    // The wall reads at another server than the room was opened at, where there are several.
    const wall = new Room(at(i + 1), key, null);
    const stop = wall.follow(
      {
        post({ post, seat, size }) {
          if (size > 160_000) return;
          patiently(() => wall.read(post, seat)).then(
            (read) => read?.message.type === 'card' && seen.set(post, performance.now()),
            (failure) => failures.push(failure.message),
          );
        },
        state: () => undefined,
        ended: () => undefined,
        connected: () => undefined,
      },
      { of: 'all' },
    );
    // Pupils derive it each on a machine of their own: here it would be one processor's work for all of them.
    const { locator } = keyOfWords(words);
    classes.push({ key, locator, stop });
  }
  const joins = [];
  const stops = [];
  const model = randomBytes(bytes);
  const pictures = randomBytes(kCardBytes);
  const started = performance.now();
  const pupil = async (i) => {
    const server = at(i);
    const { key, locator } = classes[i % rooms];
    await pause((1000 * joinSeconds * i) / pupils);
    const before = performance.now();
    await patiently(() => server.bytes(`words/${locator}`));
    const room = new Room(server, { id: key.id, key: key.key }, { id: newId(), secret: newId() });
    const number = await patiently(() => room.sit());
    await room.post({ type: 'seat', animal: 'cat', number });
    joins.push(performance.now() - before);
    const quiet = () => undefined;
    stops.push(room.follow({ post: quiet, state: quiet, ended: quiet, connected: quiet }, { of: 'teacher' }));
    await pause(started + 1000 * (joinSeconds + (handInSeconds * i) / pupils) - performance.now());
    const [modelPost, card] = [newId(), newId()];
    const message = { type: 'card', name: `Model ${i}`, model: modelPost, frames: 12, text: '', from: null };
    const bodies = [room.sealed(modelPost, { type: 'model' }, model), room.sealed(card, message, pictures)];
    await pause(0); // encrypting is the pupil's own work, too
    const start = performance.now();
    await patiently(() => room.send(modelPost, bodies[0]));
    await patiently(() => room.send(card, bodies[1]));
    begun.set(card, { start, acknowledged: performance.now() });
  };
  await Promise.all(
    Array.from({ length: pupils }, (_, i) => pupil(i).catch((failure) => failures.push(failure.message))),
  );
  for (let tries = 0; seen.size < begun.size && tries < 100; tries += 1) await pause(100);
  const lost = [...begun.keys()].filter((post) => !seen.has(post)).length;
  for (const stop of [...stops, ...classes.map(({ stop: end }) => end)]) stop();
  return {
    joins: figures(joins),
    // From the first byte that a pupil sends, its model included, until the wall has read the card.
    hand_in_to_wall: figures([...seen].map(([post, when]) => when - begun.get(post).start)),
    acknowledged_to_wall: figures([...seen].map(([post, when]) => Math.max(0, when - begun.get(post).acknowledged))),
    handed_in: begun.size,
    retried,
    lost,
    failures: failures.slice(0, 5),
    failure_count: failures.length,
  };
}

/** In sentences: what a run did not keep. */
function faultsOf({ hand_in_to_wall, handed_in, lost, failure_count, peak_memory_mb }, { pupils }, most) {
  const faults = [];
  if (handed_in < pupils) faults.push(`${pupils - handed_in} pupils did not hand in.`);
  if (lost > 0) faults.push(`${lost} hand-ins were lost.`);
  if (failure_count > 0) faults.push(`${failure_count} requests failed.`);
  // A run without hand-ins has no figures.
  if (!(hand_in_to_wall.p95_ms <= most.p95_ms))
    faults.push(`95 of 100 took ${hand_in_to_wall.p95_ms} ms, more than ${most.p95_ms}.`);
  const memory = Math.max(...peak_memory_mb);
  if (!(memory <= most.memory_mb)) faults.push(`A server needed ${memory} MB, more than ${most.memory_mb}.`);
  return faults;
}

async function serve(store) {
  const { openStore } = await import('../../web/share/store.mjs');
  const { startServer: listen } = await import('../share/support/server.mjs');
  const server = await listen(await openStore(store));
  process.send(server.port);
  process.on('SIGTERM', () => void server.close().then(() => process.exit(0)));
}

if (process.argv[2] === '--as-server') {
  await serve(process.argv[3]);
} else {
  const { wanted, most } = numbers();
  setTimeout(() => {
    process.stderr.write('This takes too long.\n');
    process.exit(1);
  }, kPatienceMs).unref();
  const folder = mkdtempSync(join(tmpdir(), 'spineloft-load-'));
  const cluster = wanted.store === 'postgres' ? startPostgres() : null;
  const store = cluster ? cluster.address('load') : join(folder, 'load.sqlite');
  const servers = [];
  try {
    for (let i = 0; i < wanted.servers; i += 1) servers.push(await startServer(store));
    const result = await load(
      wanted,
      servers.map(({ url }) => url),
    );
    const peak_memory_mb = servers.map(({ peak }) => Math.round(peak()));
    process.stdout.write(`${JSON.stringify({ ...wanted, ...result, peak_memory_mb }, null, 2)}\n`);
    const faults = faultsOf({ ...result, peak_memory_mb }, wanted, most);
    if (faults.length) process.stderr.write(`${faults.join('\n')}\n`);
    process.exitCode = faults.length ? 1 : 0;
  } finally {
    for (const { end } of servers) end();
    await pause(500);
    cluster?.close();
    rmSync(folder, { recursive: true, force: true });
  }
}
