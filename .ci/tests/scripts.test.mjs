import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import {
  countsLine,
  doctestCounts,
  doctestTotal,
  nodeTestCounts,
  stretchCounts,
  sumCounts,
  testStretches,
} from '../lib/counts.mjs';
import { ownDebianSource } from '../lib/debian.mjs';
import { kLanesPerProcessor, Lanes } from '../lib/lanes.mjs';
import { lock, root } from '../lib/paths.mjs';

function inFolder(files, work) {
  const folder = mkdtempSync(join(tmpdir(), 'spineloft-scripts-'));
  mkdirSync(join(folder, 'sources.list.d'));
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
  try {
    return work(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('doctest summaries are counted, with and without colours', () => {
  const line = '[doctest] test cases:  12 |  10 passed | 2 failed | 3 skipped';
  assert.deepEqual(doctestCounts({ text: line, status: 1 }), { passed: 10, failed: 2, skipped: 0, note: '' });
  const coloured =
    '\x1b[0;36m[doctest] \x1b[0mtest cases:     6 | \x1b[0;32m    6 passed\x1b[0m | \x1b[0m0 failed\x1b[0m |';
  assert.deepEqual(doctestCounts({ text: coloured, status: 0 }), { passed: 6, failed: 0, skipped: 0, note: '' });
});

test('a test program that crashed, or ran nothing, counts as a failure', () => {
  assert.equal(doctestCounts({ text: 'Segmentation fault', status: null }).failed, 1);
  assert.equal(
    doctestCounts({ text: '[doctest] test cases: 0 | 0 passed | 0 failed | 0 skipped', status: 0 }).failed,
    1,
  );
  assert.equal(
    doctestCounts({ text: '[doctest] test cases: 5 | 5 passed | 0 failed | 0 skipped', status: 134 }).failed,
    1,
  );
  assert.equal(nodeTestCounts({ text: '', status: 1 }).failed, 1);
});

test('stretches of a test program hold every test case once, whatever the numbers', () => {
  for (const [total, count] of [
    [773, 6],
    [5, 6],
    [1, 1],
    [12, 12],
  ]) {
    const numbers = testStretches(total, count).flatMap(({ first, last }) =>
      Array.from({ length: last - first + 1 }, (_, k) => first + k),
    );
    assert.deepEqual(
      numbers,
      Array.from({ length: total }, (_, k) => k + 1),
    );
  }
});

test('what ran outside a stretch is not counted in it, and a stretch that broke off has failed', () => {
  assert.equal(doctestTotal('[doctest] unskipped test cases passing the current filters: 773\n'), 773);
  const ofAll = '[doctest] test cases: 773 | 772 passed | 1 failed | 0 skipped';
  assert.deepEqual(stretchCounts({ text: ofAll, status: 1 }, 100), { passed: 99, failed: 1, skipped: 0, note: '' });
  const brokenOff = stretchCounts({ text: 'Segmentation fault', status: null }, 100);
  assert.equal(brokenOff.failed, 1);
  const sum = sumCounts([stretchCounts({ text: ofAll, status: 1 }, 100), brokenOff]);
  assert.deepEqual({ passed: sum.passed, failed: sum.failed }, { passed: 99, failed: 2 });
  assert.match(sum.note, /before its summary/);
});

test('node:test summaries are counted; a cancelled test has failed, a skipped one has not passed', () => {
  const text = '# tests 7\n# pass 3\n# fail 1\n# cancelled 1\n# skipped 2\n';
  const counts = nodeTestCounts({ text, status: 1 });
  assert.deepEqual(counts, { passed: 3, failed: 2, skipped: 2, note: '' });
  assert.equal(countsLine(counts), '3 passed, 2 failed, 2 skipped');
  assert.equal(countsLine({ ...counts, skipped: 0 }), '3 passed, 2 failed');
});

test('jobs share the lanes out in the order in which they came; one that wants all of them runs alone', async () => {
  const lanes = new Lanes(2);
  const log = [];
  const job = (name) => async () => {
    log.push(`+${name}`);
    await new Promise((resolve) => setTimeout(resolve, 5));
    log.push(`-${name}`);
  };
  const failing = lanes.run(() => Promise.reject(new Error('no')));
  const rest = [lanes.run(job('a')), lanes.alone(job('all')), lanes.run(job('b')), lanes.run(job('c'))];
  await assert.rejects(failing, /no/);
  await Promise.all(rest);
  assert.deepEqual(log.slice(0, 4), ['+a', '-a', '+all', '-all']);
  assert.deepEqual(log.slice(4, 6), ['+b', '+c']);
});

test('jobs that take two thirds of a processor run three at a time on two', async () => {
  const lanes = new Lanes(2);
  let running = 0;
  let most = 0;
  const job = async () => {
    most = Math.max(most, ++running);
    await new Promise((resolve) => setTimeout(resolve, 5));
    --running;
  };
  await Promise.all(Array.from({ length: 7 }, () => lanes.run(job, (2 * kLanesPerProcessor) / 3)));
  assert.equal(most, 3);
});

test("the machine's own Debian is found in either format of its sources", () => {
  const modern = `# a comment
Types: deb
URIs: http://mirror.example/debian-security
Suites: bookworm-security
Components: main

Types: deb
# another comment
URIs: http://mirror.example/debian
Suites: bookworm bookworm-updates
Components: main
Signed-By: /usr/share/keyrings/own.gpg
`;
  inFolder({ 'sources.list.d/debian.sources': modern }, (folder) => {
    assert.deepEqual(ownDebianSource('bookworm', folder), {
      uri: 'http://mirror.example/debian',
      signedBy: '/usr/share/keyrings/own.gpg',
    });
  });
  const classic = `# deb http://off.example/debian bookworm main
deb http://security.example/ bookworm-security main
deb [arch=amd64 signed-by=/etc/own.gpg] https://mirror.example/debian/ bookworm main contrib
`;
  inFolder({ 'sources.list': classic }, (folder) => {
    assert.deepEqual(ownDebianSource('bookworm', folder), {
      uri: 'https://mirror.example/debian/',
      signedBy: '/etc/own.gpg',
    });
  });
  inFolder({ 'sources.list': 'deb http://other.example/x trixie main\n' }, (folder) => {
    assert.throws(() => ownDebianSource('bookworm', folder), /No Debian source for bookworm/);
  });
});

/** Runs a module text in its own process with its own cache folder, so that the real one is left alone. */
function script(text, cache) {
  const env = { ...process.env, XDG_CACHE_HOME: cache };
  const child = spawn(process.execPath, ['--input-type=module', '-e', text], {
    cwd: root,
    env,
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  const said = [];
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (chunk) => said.push(chunk));
  const done = new Promise((resolve) =>
    child.on('close', (status, signal) => resolve({ status, signal, text: Buffer.concat(said).toString() })),
  );
  const until = async (pattern) => {
    while (!pattern.test(Buffer.concat(said).toString())) {
      if (child.exitCode !== null) throw new Error(Buffer.concat(said).toString());
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  };
  return { child, done, until };
}

const kMake = (body) => `
import { cached, removeLeftovers, withSetupLock } from './.ci/lib/cache.mjs';
import { writeFileSync, appendFileSync } from 'node:fs';
import { join } from 'node:path';
await withSetupLock(async () => {
  removeLeftovers();
  const place = await cached('thing', { what: 'Thing', howLong: 'no time' }, async (folder) => { ${body} });
  console.log('place ' + place);
});`;

test('an interrupted making leaves nothing under the final name, and the next run makes it and tidies up', async () => {
  const cache = mkdtempSync(join(tmpdir(), 'spineloft-cache-'));
  try {
    const first = script(
      kMake(
        `writeFileSync(join(folder, 'half'), 'x'); console.log('half done'); await new Promise((r) => setTimeout(r, 60000));`,
      ),
      cache,
    );
    await first.until(/half done/);
    first.child.kill('SIGKILL');
    await first.done;
    assert.ok(!existsSync(join(cache, 'spineloft/thing')));
    const second = await script(kMake(`writeFileSync(join(folder, 'whole'), 'y');`), cache).done;
    assert.equal(second.status, 0, second.text);
    assert.equal(readFileSync(join(cache, 'spineloft/thing/whole'), 'utf8'), 'y');
    assert.ok(!existsSync(join(cache, 'spineloft/thing/half')));
    const { readdirSync } = await import('node:fs');
    assert.deepEqual(readdirSync(join(cache, 'spineloft')).sort(), ['lock', 'thing']);
  } finally {
    rmSync(cache, { recursive: true });
  }
});

test('two set-ups at once make a thing once; the second waits for the first', async () => {
  const cache = mkdtempSync(join(tmpdir(), 'spineloft-cache-'));
  try {
    const body = `appendFileSync(${JSON.stringify(join(cache, 'made'))}, 'm'); await new Promise((r) => setTimeout(r, 300));`;
    const runs = [1, 2, 3].map(() => script(kMake(body), cache).done);
    for (const { status, text } of await Promise.all(runs)) assert.equal(status, 0, text);
    assert.equal(readFileSync(join(cache, 'made'), 'utf8'), 'm');
  } finally {
    rmSync(cache, { recursive: true });
  }
});

test('the files of the set-up name no registry and no mirror', () => {
  assert.doesNotMatch(readFileSync(join(root, 'package-lock.json'), 'utf8'), /"resolved"/);
  assert.doesNotMatch(readFileSync(join(root, 'emsdk.lock'), 'utf8'), /https?:/);
  assert.equal(lock.emscripten.version, '3.1.69');
});

test('the scripts of a fresh clone import nothing that the set-up installs before it has run', () => {
  const seen = new Set();
  const visit = (file) => {
    if (seen.has(file)) return;
    seen.add(file);
    const imports = readFileSync(file, 'utf8').matchAll(
      /^(?:import|export) [^;]*?from '([^']+)';|^import '([^']+)';/gm,
    );
    for (const [, from, bare] of imports) {
      const name = from ?? bare;
      assert.match(name, /^(\.|node:)/, `${file} imports ${name}`);
      if (name.startsWith('.')) visit(join(dirname(file), name));
    }
  };
  for (const script of ['setup', 'start', 'serve_share', 'build', 'test', 'cli', 'bench', 'figures', 'fuzz'])
    visit(join(root, '.ci', `${script}.mjs`));
  assert.ok(seen.size > 15);
});
