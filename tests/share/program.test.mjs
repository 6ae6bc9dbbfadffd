// The program around the server: its options, back-ups while it runs, an end that answers what was asked before, and that
// what is deleted leaves the files.
import assert from 'node:assert/strict';
import { randomBytes } from 'node:crypto';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { openStore } from '../../web/share/store.mjs';
import { backUp, serveMain, serveOptions, startShare, UsageError } from '../../web/share/serve.mjs';
import { id } from './support/stores.mjs';
import { startServer, until } from './support/server.mjs';

const folder = mkdtempSync(join(tmpdir(), 'spineloft-program-'));
after(() => rmSync(folder, { recursive: true, force: true }));
const file = (name) => join(folder, name);

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
