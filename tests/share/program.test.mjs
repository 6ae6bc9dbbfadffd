// The program around the server: its options, back-ups while it runs, an end that answers what was asked before, and that
// what is deleted leaves the files.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { randomBytes } from 'node:crypto';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { openStore } from '../../web/share/store.mjs';
import { backUp, serveMain, serveOptions, startShare, UsageError } from '../../web/share/serve.mjs';
import { startPostgres } from './support/postgres.mjs';
import { id, kStoreKits } from './support/stores.mjs';
import { startServer, until } from './support/server.mjs';

const folder = mkdtempSync(join(tmpdir(), 'spineloft-program-'));
after(() => rmSync(folder, { recursive: true, force: true }));
const file = (name) => join(folder, name);
const { skip } = kStoreKits.find(({ name }) => name === 'PostgreSQL');

const putOptions = (path, secret, length) => ({
  method: 'PUT',
  path,
  headers: {
    Authorization: `Bearer ${secret}`,
    'Content-Type': 'application/octet-stream',
    'Content-Length': length,
  },
});

test('options that are none are told with how it is used', () => {
  for (const args of [['--nothing'], ['--port', 'x'], ['--disk', '-1'], ['left over']])
    assert.throws(() => serveOptions(args), UsageError);
  assert.equal(serveOptions(['--store', 'x.sqlite']).store, 'x.sqlite');
});

test('a back-up while the server runs holds everything that was acknowledged before, and is a store', async () => {
  const options = serveOptions(['--port', '0', '--store', file('a.sqlite'), '--backup', file('b.sqlite')]);
  const share = await startShare(options, () => undefined);
  const models = new Map();
  for (let i = 0; i < 5; i += 1) {
    const [name, bytes] = [id(), randomBytes(50_000)];
    const { path, ...rest } = putOptions(`share/v1/models/${name}`, id(), bytes.length);
    assert.equal((await fetch(`${share.url}${path}`, { ...rest, body: bytes })).status, 201);
    models.set(name, bytes);
  }
  const said = [];
  await serveMain(['--store', file('a.sqlite'), '--backup', file('b.sqlite')], {
    say: (line) => said.push(line),
    stopped: null,
  });
  assert.match(said.join(), /Written/);
  assert.equal((await fetch(`${share.url}share/healthz`)).status, 200);
  await share.close();
  const copy = await openStore(file('b.sqlite'));
  for (const [name, bytes] of models) assert.ok((await copy.post(name, 'model')).bytes.equals(bytes));
  await copy.close();
  await backUp(options); // again, over the first
});

test(
  'a back-up of PostgreSQL is restored into another database, and a server on that serves the same models',
  { skip },
  async () => {
    const cluster = startPostgres();
    const servers = [];
    try {
      const first = cluster.address('first');
      servers.push(await startServer(await openStore(first)));
      const models = new Map();
      const put = async (server, name, secret, bytes) => {
        const options = putOptions(`models/${name}`, secret, bytes.length);
        return (await fetch(`${server.url}${options.path}`, { ...options, body: bytes })).status;
      };
      for (let i = 0; i < 3; i += 1) {
        const [name, secret, bytes] = [id(), id(), randomBytes(50_000)];
        assert.equal(await put(servers[0], name, secret, bytes), 201);
        models.set(name, { secret, bytes });
      }
      await serveMain(['--store', first, '--backup', file('first.dump')], { say: () => undefined, stopped: null });
      const late = id();
      assert.equal(await put(servers[0], late, id(), randomBytes(10)), 201);

      const next = cluster.address('next');
      const done = spawnSync('pg_restore', ['--exit-on-error', `--dbname=${next}`, file('first.dump')], {
        encoding: 'utf8',
      });
      assert.equal(done.status, 0, done.stderr);
      servers.push(await startServer(await openStore(next)));
      const get = (name) => fetch(`${servers[1].url}models/${name}`);
      for (const [name, { secret, bytes }] of models) {
        assert.ok(Buffer.from(await (await get(name)).arrayBuffer()).equals(bytes));
        assert.equal(await put(servers[1], name, secret, bytes), 200, 'its maker is known');
      }
      assert.equal((await get(late)).status, 404, 'it came after the back-up');
      assert.equal(await put(servers[1], late, id(), randomBytes(10)), 201);
      assert.equal((await servers[0].store.totals()).models, 4);
    } finally {
      for (const server of servers) await server.close();
      cluster.close();
    }
  },
);

test('a server that ends answers what was begun, and its streams end', async () => {
  const share = await startShare(serveOptions(['--port', '0', '--store', file('c.sqlite')]), () => undefined);
  const bytes = randomBytes(100_000);
  const name = id();
  const { port } = new URL(share.url);
  const answered = new Promise((resolve, reject) => {
    const sent = request({ host: 'localhost', port, ...putOptions(`/share/v1/models/${name}`, id(), bytes.length) });
    sent.on('response', (response) => resolve(response.resume().statusCode));
    sent.on('error', reject);
    sent.write(bytes.subarray(0, 1000));
    setTimeout(() => sent.end(bytes.subarray(1000)), 300);
  });
  await new Promise((resolve) => setTimeout(resolve, 100));
  const closed = share.close();
  assert.equal(await answered, 201);
  await closed;
  const store = await openStore(file('c.sqlite'));
  assert.ok((await store.post(name, 'model')).bytes.equals(bytes));
  await store.close();
  await assert.rejects(fetch(`${share.url}share/healthz`));
});

test('what was deleted is in none of the files a sweep later, far within a minute', async () => {
  const place = file('d.sqlite');
  const server = await startServer(await openStore(place), { limits: { sweepMs: 100 } });
  const marks = Array.from({ length: 20 }, () => randomBytes(5000));
  const [room, secret] = [id(), id()];
  const ask = async (path, body = Buffer.alloc(0), method = 'PUT') => {
    const options = putOptions(path, secret, body.length);
    const { status } = await fetch(`${server.url}${path}`, { ...options, method, ...(body.length ? { body } : {}) });
    assert.ok(status < 300, `${path}: ${status}`);
  };
  await ask(`rooms/${room}`);
  for (const mark of marks) await ask(`rooms/${room}/posts/${id()}`, mark);
  const found = () => {
    const files = ['', '-wal'].map((end) => place + end).filter((name) => existsSync(name));
    const text = Buffer.concat(files.map((name) => readFileSync(name)));
    // The middle of a mark is in one piece, wherever pages cut it.
    return marks.filter((mark) => text.includes(mark.subarray(2400, 2432))).length;
  };
  assert.ok(found() > 15, 'they are in the files before');
  await ask(`rooms/${room}`, undefined, 'DELETE');
  await until(() => found() === 0, 'they are gone');
  await server.close();
});

test('a store of a later version is left alone, and that is said', async () => {
  const place = file('e.sqlite');
  const store = await openStore(place);
  store.db.pragma('user_version = 99');
  await store.close();
  await assert.rejects(openStore(place), /later version/);
});

test('no answer sets a cookie, and an address is neither in the store nor in what is said', async () => {
  const place = file('f.sqlite');
  const share = await startServer(await openStore(place));
  // Of the own machine, as 127.0.0.1 is; found by its text and by its bytes.
  const address = '127.83.59.241';
  const [model, room, secret, seat] = [id(), id(), id(), id()];
  const ask = (method, path, body = Buffer.alloc(0)) =>
    new Promise((resolve, reject) => {
      const { headers } = putOptions(path, secret, body.length);
      const options = { host: '127.0.0.1', port: share.port, localAddress: address, method, path, headers };
      const sent = request(options, (response) => {
        response.resume();
        response.on('end', () => resolve({ status: response.statusCode, headers: response.headers }));
      });
      sent.on('error', reject);
      sent.end(body);
    });
  const answers = [
    await ask('PUT', `/share/v1/models/${model}`, randomBytes(3000)),
    await ask('GET', `/share/v1/models/${model}`),
    await ask('PUT', `/share/v1/rooms/${room}`),
    await ask('PUT', `/share/v1/rooms/${room}/posts/${id()}`, randomBytes(3000)),
    await ask('GET', `/share/v1/words/${id()}`),
    await ask('GET', `/share/v1/models/${seat}`),
    await ask('GET', '/share/healthz'),
    await ask('DELETE', `/share/v1/models/${seat}`),
    await ask('GET', '/share/nothing'),
  ];
  const statuses = answers.map(({ status }) => status);
  assert.deepEqual(statuses.slice(0, 4), [201, 200, 201, 201]);
  assert.ok(
    statuses.slice(4).some((status) => status >= 400),
    `${statuses}`,
  );
  for (const { headers } of answers) assert.equal(headers['set-cookie'], undefined);
  const files = () =>
    Buffer.concat(
      ['', '-wal', '-shm']
        .map((end) => place + end)
        .filter(existsSync)
        .map((name) => readFileSync(name)),
    );
  const kept = [files()];
  await share.close();
  kept.push(files(), Buffer.from(share.said.join('\n')));
  assert.ok(kept[0].includes(Buffer.from(model)) || kept[1].includes(Buffer.from(model)), 'what is kept is looked at');
  for (const bytes of kept) {
    assert.ok(!bytes.includes(address));
    assert.ok(!bytes.includes(Buffer.from(address.split('.').map(Number))));
  }
});
