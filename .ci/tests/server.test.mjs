import assert from 'node:assert/strict';
import { copyFileSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { get } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { brotliDecompressSync, gunzipSync, brotliCompressSync, gzipSync } from 'node:zlib';
import { root } from '../lib/paths.mjs';
import { serveFolder } from '../lib/server.mjs';

const top = mkdtempSync(join(tmpdir(), 'spineloft-server-'));
const site = join(top, 'site');
const script = 'export const x = 1;\n'.repeat(100);
let server;

before(async () => {
  mkdirSync(join(site, 'assets'), { recursive: true });
  writeFileSync(join(top, 'secret.txt'), 'secret');
  mkdirSync(join(top, 'site-beside'));
  writeFileSync(join(top, 'site-beside/secret.txt'), 'secret');
  writeFileSync(join(site, 'index.html'), '<!doctype html><title>page</title>');
  writeFileSync(join(site, 'assets/main-0123456789.js'), script);
  writeFileSync(join(site, 'assets/main-0123456789.js.br'), brotliCompressSync(script));
  writeFileSync(join(site, 'assets/main-0123456789.js.gz'), gzipSync(script));
  for (const name of ['core-KZJGGTSH.wasm', 'plain.wasm', 'font.ttf', 'part.glb', 'list.json', 'module.mjs']) {
    writeFileSync(join(site, 'assets', name), 'x');
  }
  server = await serveFolder(site);
});

after(async () => {
  await server.close();
  rmSync(top, { recursive: true });
});

/** A request with the path exactly as given: fetch would tidy `..` away. */
function ask(path, headers = {}, port = server.port) {
  return new Promise((resolve, reject) => {
    get({ host: 'localhost', port, path, headers }, (response) => {
      const chunks = [];
      response.on('data', (chunk) => chunks.push(chunk));
      response.on('end', () =>
        resolve({ status: response.statusCode, headers: response.headers, body: Buffer.concat(chunks) }),
      );
    }).on('error', reject);
  });
}

test('the page comes at the root, uncached, isolated', async () => {
  const { status, headers, body } = await ask('/');
  assert.equal(status, 200);
  assert.match(body.toString(), /<title>page/);
  assert.equal(headers['content-type'], 'text/html; charset=utf-8');
  assert.equal(headers['cache-control'], 'no-cache');
  assert.equal(headers['cross-origin-opener-policy'], 'same-origin');
  assert.equal(headers['cross-origin-embedder-policy'], 'require-corp');
});

test("the policy of the site's page is a header of every answer, so that workers have it too, but on a bare host", async () => {
  const folder = join(top, 'strict');
  mkdirSync(folder);
  copyFileSync(join(root, 'web/shell/index.html'), join(folder, 'index.html'));
  writeFileSync(join(folder, 'worker.js'), script);
  const policies = async (options) => {
    const strict = await serveFolder(folder, options);
    try {
      const paths = ['/', '/worker.js', '/missing.js'];
      const answers = await Promise.all(paths.map((path) => ask(path, {}, strict.port)));
      return [answers[0].body.toString(), answers.map(({ headers }) => headers['content-security-policy'])];
    } finally {
      await strict.close();
    }
  };
  const [page, sent] = await policies();
  for (const policy of sent) {
    assert.match(policy, /connect-src 'self'/);
    assert.ok(page.includes(`<meta http-equiv="Content-Security-Policy" content="${policy}">`));
  }
  assert.deepEqual((await policies({ bare: true }))[1], [undefined, undefined, undefined]);
  assert.equal((await ask('/')).headers['content-security-policy'], undefined);
});

test('hashed names are cached for ever, others are asked about again', async () => {
  const cache = async (path) => (await ask(path)).headers['cache-control'];
  assert.equal(await cache('/assets/main-0123456789.js'), 'public, max-age=31536000, immutable');
  assert.equal(await cache('/assets/core-KZJGGTSH.wasm'), 'public, max-age=31536000, immutable');
  assert.equal(await cache('/assets/plain.wasm'), 'no-cache');
});

test('each kind of file has its type', async () => {
  const type = async (path) => (await ask(path)).headers['content-type'];
  assert.equal(await type('/assets/plain.wasm'), 'application/wasm');
  assert.match(await type('/assets/module.mjs'), /^text\/javascript/);
  assert.equal(await type('/assets/font.ttf'), 'font/ttf');
  assert.equal(await type('/assets/part.glb'), 'model/gltf-binary');
  assert.match(await type('/assets/list.json'), /^application\/json/);
});

test('a compressed twin is sent to those who accept it, and only to them', async () => {
  const path = '/assets/main-0123456789.js';
  const brotli = await ask(path, { 'Accept-Encoding': 'gzip, br' });
  assert.equal(brotli.headers['content-encoding'], 'br');
  assert.match(brotli.headers['content-type'], /^text\/javascript/);
  assert.equal(brotliDecompressSync(brotli.body).toString(), script);
  const gzip = await ask(path, { 'Accept-Encoding': 'gzip, br;q=0' });
  assert.equal(gzip.headers['content-encoding'], 'gzip');
  assert.equal(gunzipSync(gzip.body).toString(), script);
  const plain = await ask(path);
  assert.equal(plain.headers['content-encoding'], undefined);
  assert.equal(plain.body.toString(), script);
});

test('an unchanged file is answered with 304', async () => {
  const { headers } = await ask('/');
  assert.equal((await ask('/', { 'If-None-Match': headers.etag })).status, 304);
});

test('nothing outside the folder can be reached', async () => {
  const ways = [
    '/../secret.txt',
    '/%2e%2e/secret.txt',
    '/assets/..%2f..%2fsecret.txt',
    '/..%5csecret.txt',
    '/../site-beside/secret.txt',
    '/%00',
    '/%zz',
    '//etc/passwd',
  ];
  for (const way of ways) {
    const { status, body } = await ask(way);
    assert.equal(status, 404, way);
    assert.doesNotMatch(body.toString(), /^secret$/, way);
  }
});

test('a sub-path and a plain host can be imitated; a taken port moves on to the next', async () => {
  const other = await serveFolder(site, { basePath: '/deep/er/', isolated: false });
  try {
    assert.equal((await ask('/deep/er/', {}, other.port)).status, 200);
    assert.equal((await ask('/', {}, other.port)).status, 404);
    assert.equal((await ask('/deep/er/', {}, other.port)).headers['cross-origin-embedder-policy'], undefined);
    const next = await serveFolder(site, { port: other.port });
    assert.ok(next.port > other.port);
    await next.close();
  } finally {
    await other.close();
  }
});

test('who asks for a file that is still being made waits, and is sent on to it; where it cannot be made that is said', async () => {
  let finish;
  const whole = new Promise((resolve) => (finish = resolve));
  const later = new Map([
    ['assets/whole-later.js', whole],
    ['assets/broken-later.js', Promise.resolve(null)],
  ]);
  const other = await serveFolder(site, { basePath: '/deep/', later });
  try {
    let answered = false;
    const waiting = ask('/deep/assets/whole-later.js', {}, other.port).then((answer) => {
      answered = true;
      return answer;
    });
    assert.equal((await ask('/deep/', {}, other.port)).status, 200);
    assert.equal(answered, false);
    finish('assets/main-0123456789.js');
    const { status, headers } = await waiting;
    assert.equal(status, 302);
    assert.equal(headers.location, '/deep/assets/main-0123456789.js');
    assert.equal((await ask(headers.location, {}, other.port)).body.toString(), script);
    assert.equal((await ask('/deep/assets/broken-later.js', {}, other.port)).status, 503);
  } finally {
    await other.close();
  }
});

test('a share server answers below share/ alone, and share.json names it where there is one', async () => {
  writeFileSync(join(site, 'share.json'), '{"server": null}\n');
  assert.deepEqual(JSON.parse((await ask('/share.json')).body), { server: null });
  const seen = [];
  const share = {
    times: {},
    addresses: ['http://10.0.0.7:8080/'],
    handle(request, response) {
      seen.push(request.url);
      response.end('shared');
    },
  };
  const other = await serveFolder(site, { basePath: '/deep/', share });
  try {
    assert.equal((await ask('/deep/share/v1/models/x?a=b', {}, other.port)).body.toString(), 'shared');
    assert.deepEqual(seen, ['/share/v1/models/x?a=b']);
    const told = JSON.parse((await ask('/deep/share.json', {}, other.port)).body);
    assert.deepEqual(told, { server: 'share/v1/', addresses: ['http://10.0.0.7:8080/'] });
    for (const path of ['/share/v1/models/x', '/deep/shared', '/deep/assets/share/x'])
      assert.equal((await ask(path, {}, other.port)).status, 404, path);
    assert.equal((await ask('/deep/', {}, other.port)).status, 200);
    assert.equal(seen.length, 1);
  } finally {
    await other.close();
  }
});
