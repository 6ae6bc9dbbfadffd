// spineloft share: a model as a short text, which open takes instead of a file.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { barFolder, fails, readJson, run, workFolder, works } from '../support/cli.mjs';

const glass = fileURLToPath(new URL('../../assets/docs/recipes/wine-glass.json', import.meta.url));

const shared = (file) => works('share', file).stdout.trim();

test('a model on paper is a text from which the same parts are made, alone and behind the # of a link', (t) => {
  const folder = workFolder(t);
  works('loft', '--recipe', glass, '--out', folder.path('glass.glb'));
  const text = shared(folder.path('glass.glb'));
  assert.match(text, /^2[\w-]+$/);
  assert.ok(text.length <= 210, `${text.length} characters`);
  for (const link of [text, `https://example.org/#m=${text}`]) {
    works('open', link, '--document', folder.path('d.json'), '--report', folder.path('r.json'));
    const report = readJson(folder.path('r.json'));
    assert.deepEqual([report.parts, report.lawful, report.dropped, report.repaired], [1, 1, 0, 0]);
    const document = readJson(folder.path('d.json'));
    const recipe = readJson(glass);
    assert.equal(document.name, recipe.name);
    assert.deepEqual(document.parts[0].recipe.region.contours, recipe.parts[0].recipe.region.contours);
  }
  works('open', text, '--out', folder.path('again.glb'));
  assert.equal(shared(folder.path('again.glb')), text);
});

test('a photo stays at home: a sentence says so, and the part opens without it', (t) => {
  const folder = barFolder(t);
  works('loft', folder.path('bar.png'), '--stroke', folder.path('stroke.json'), '--out', folder.path('bar.spineloft'));
  const { status, stdout, stderr } = run('share', folder.path('bar.spineloft'));
  assert.equal(status, 0);
  assert.match(stderr, /no room for photos/);
  works('open', stdout.trim(), '--report', folder.path('r.json'));
  const report = readJson(folder.path('r.json'));
  assert.deepEqual([report.pictures, report.parts, report.lawful], [1, 1, 1]);
});

test('what is cut off, altered, foreign or too new is said in one sentence', (t) => {
  const folder = workFolder(t);
  works('loft', '--recipe', glass, '--out', folder.path('glass.glb'));
  const text = shared(folder.path('glass.glb'));
  assert.match(fails(3, 'open', text.slice(0, -7)), /end of that link is missing \(7 characters/);
  const other = text.at(-1) === 'A' ? 'B' : 'A';
  assert.match(fails(3, 'open', text.slice(0, -1) + other), /changed on its way/);
  assert.match(fails(3, 'open', 'https://example.org/#m=about'), /no model of SpineLoft in that link/);
  assert.match(fails(3, 'open', `3${text.slice(1)}`), /newer SpineLoft/);
  assert.match(fails(3, 'open', 'no such file.glb'), /cannot be read/);
});
