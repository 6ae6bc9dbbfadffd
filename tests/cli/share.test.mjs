// spineloft share: a model as a short text, which open takes instead of a file.
import assert from 'node:assert/strict';
import { copyFileSync, existsSync, readdirSync, writeFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { barFolder, dataFolder, fails, readJson, run, workFolder, works } from '../support/cli.mjs';

const glass = fileURLToPath(new URL('../../assets/docs/recipes/wine-glass.json', import.meta.url));

const shared = (file) => works('share', file).stdout.trim();

test('a model on paper is a text from which the same parts are made, alone and behind the # of a link', (t) => {
  const folder = workFolder(t);
  works('loft', '--recipe', glass, '--out', folder.path('glass.glb'));
  const text = shared(folder.path('glass.glb'));
  assert.match(text, /^[56][\w-]+$/);
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
  assert.match(fails(3, 'open', `7${text.slice(1)}`), /newer SpineLoft/);
  assert.match(fails(3, 'open', 'no such file.glb'), /cannot be read/);
});

/** The pictures with a stroke; none where there is no data folder. */
const realPictures = () => readdirSync(dataFolder).filter((name) => existsSync(join(dataFolder, name, 'case.json')));
const skip = dataFolder ? false : 'there are no real pictures here';

/** The text of a part of so many ribs along this stroke of the picture as a camera names it; opens again, as d.json. */
function tracedText(folder, name, stroke, ribs) {
  const at = (file) => join(dataFolder, name, file);
  const file = ['image.png', 'image.jpg'].map(at).find(existsSync);
  const picture = folder.path(`IMG_2041${extname(file)}`);
  copyFileSync(file, picture);
  writeFileSync(folder.path('ribs.json'), JSON.stringify({ spine: { ribs } }));
  const how = ['--stroke', at('case.json'), '--stroke-name', stroke, '--recipe', folder.path('ribs.json')];
  works('loft', picture, ...how, '--out', folder.path('part.spineloft'));
  const text = run('share', folder.path('part.spineloft')).stdout.trim();
  works('open', text, '--report', folder.path('r.json'), '--document', folder.path('d.json'));
  const { parts, lawful, dropped, repaired } = readJson(folder.path('r.json'));
  assert.deepEqual({ parts, lawful, dropped, repaired }, { parts: 1, lawful: 1, dropped: 0, repaired: 0 }, name);
  return text;
}

/** Per kind of stroke: the mean over the pictures, rounded up. */
const kMeans = { careful: 124, sloppy: 137, offcentre: 131 };

test(
  'of 78 parts of 40 ribs that were traced in real pictures, however they were drawn, 77 are texts of at most 150 characters, one is of at most 200',
  {
    skip,
  },
  (t) => {
    const folder = workFolder(t);
    const names = realPictures();
    assert.ok(names.length > 0);
    const long = [];
    for (const [stroke, most] of Object.entries(kMeans)) {
      const lengths = names.map((name) => [name, tracedText(folder, name, stroke, 40).length]);
      const mean = lengths.reduce((sum, [, length]) => sum + length, 0) / lengths.length;
      t.diagnostic(`${stroke}: mean ${mean.toFixed(1)}; ${lengths.map((one) => one.join(' ')).join(', ')}`);
      long.push(
        ...lengths.filter(([, length]) => length > 150).map(([name, length]) => `${name}, ${stroke}: ${length}`),
      );
      for (const [name, length] of lengths) assert.ok(length <= 200, `${name}, ${stroke}: ${length} characters`);
      assert.ok(mean <= most, `${stroke}: ${mean} characters on average`);
    }
    assert.ok(long.length <= 1, long.join('; '));
  },
);

/** One model of traced parts, each with its picture, which is paper here. */
function together(folder, names, stroke, ribs) {
  const model = { pictures: [], parts: [], lastPictureId: names.length, lastPartId: names.length };
  for (const [i, name] of names.entries()) {
    tracedText(folder, name, stroke, ribs);
    const [picture] = readJson(folder.path('d.json')).pictures;
    const [part] = readJson(folder.path('d.json')).parts;
    model.pictures.push({ id: i + 1, name: `Picture ${i + 1}`, size: picture.size });
    part.recipe.picture = i + 1;
    model.parts.push({ ...part, id: i + 1, name: `Part ${i + 1}` });
  }
  return model;
}

test(
  'seven traced parts of 40 ribs are a text of at most 1,000 characters, twelve of 60 ribs of at most 1,900',
  {
    skip,
  },
  (t) => {
    const folder = workFolder(t);
    for (const [count, ribs, most] of [
      [7, 40, 1000],
      [12, 60, 1900],
    ]) {
      const model = together(folder, realPictures().slice(0, count), 'sloppy', ribs);
      writeFileSync(folder.path('model.json'), JSON.stringify(model));
      works('loft', '--recipe', folder.path('model.json'), '--out', folder.path('model.spineloft'));
      const text = shared(folder.path('model.spineloft'));
      t.diagnostic(`${count} parts of ${ribs} ribs: ${text.length} characters`);
      assert.ok(text.length <= most, `${text.length} characters`);
      works('open', text, '--report', folder.path('r.json'));
      const { parts, lawful, dropped } = readJson(folder.path('r.json'));
      assert.deepEqual({ parts, lawful, dropped }, { parts: count, lawful: count, dropped: 0 });
    }
  },
);
