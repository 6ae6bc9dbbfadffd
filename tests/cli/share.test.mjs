// spineloft share: a model as a short text, which open takes instead of a file.
import assert from 'node:assert/strict';
import { existsSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { barFolder, dataFolder, fails, readJson, run, workFolder, works } from '../support/cli.mjs';

const glass = fileURLToPath(new URL('../../assets/docs/recipes/wine-glass.json', import.meta.url));

const shared = (file) => works('share', file).stdout.trim();

test('a model on paper is a text from which the same parts are made, alone and behind the # of a link', (t) => {
  const folder = workFolder(t);
  works('loft', '--recipe', glass, '--out', folder.path('glass.glb'));
  const text = shared(folder.path('glass.glb'));
  assert.match(text, /^3[\w-]+$/);
  assert.ok(text.length <= 170, `${text.length} characters`);
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
  assert.match(fails(3, 'open', `4${text.slice(1)}`), /newer SpineLoft/);
  assert.match(fails(3, 'open', 'no such file.glb'), /cannot be read/);
});

/** Of other pictures than the examples of engine/io/packed_traces.h, and but for a line of 3,800 pixels. */
const kTraced = [
  ...['photo_dutar', 'photo_kingfisher_branch', 'photo_swan_neck', 'photo_zucchini_hand'],
  ...['render_banana_occluded', 'render_beer_bottle', 'render_lamp_missing', 'render_palm_noise'],
  ...['render_vase_lowcontrast', 'sketch_bat_noisy', 'sketch_bottle', 'sketch_dino_tail'],
  ...['proc_bent_g25', 'proc_c_ring_g25', 'proc_s_shape_g50', 'proc_straight_g0', 'proc_taper_g25'],
  'proc_very_thin_g25',
];

test(
  'a part of 40 ribs that was traced in a real picture is a text of at most 125 characters',
  { skip: dataFolder ? false : 'there are no real pictures here' },
  (t) => {
    const folder = workFolder(t);
    writeFileSync(folder.path('40.json'), '{"spine": {"ribs": 40}}');
    for (const name of kTraced) {
      const at = (file) => join(dataFolder, name, file);
      const picture = ['image.png', 'image.jpg'].map(at).find(existsSync);
      const how = ['--stroke', at('case.json'), '--stroke-name', 'careful', '--recipe', folder.path('40.json')];
      works('loft', picture, ...how, '--out', folder.path('part.spineloft'));
      const { stdout } = run('share', folder.path('part.spineloft'));
      assert.ok(stdout.trim().length <= 125, `${name}: ${stdout.trim().length} characters`);
      works('open', stdout.trim(), '--report', folder.path('r.json'));
      const { parts, lawful, dropped, repaired } = readJson(folder.path('r.json'));
      assert.deepEqual({ parts, lawful, dropped, repaired }, { parts: 1, lawful: 1, dropped: 0, repaired: 0 }, name);
    }
  },
);
