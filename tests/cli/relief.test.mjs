// Reliefs from outside: recipes in, files and reports out.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { PNG } from 'pngjs';
import { fails, readJson, workFolder, works } from '../support/cli.mjs';

const leaf = JSON.parse(
  readFileSync(fileURLToPath(new URL('../../assets/docs/recipes/leaf.json', import.meta.url)), 'utf8'),
);
const kBadRecipe = 3;

const make = (folder, recipe, pictures = []) => {
  writeFileSync(folder.path('recipe.json'), JSON.stringify(recipe));
  works(
    'make',
    '--recipe',
    folder.path('recipe.json'),
    ...pictures.flatMap((picture) => ['--picture', picture]),
    '--out',
    folder.path('part.glb'),
    '--report',
    folder.path('report.json'),
  );
  return readJson(folder.path('report.json')).parts[0];
};
const withRelief = (relief) => {
  const recipe = structuredClone(leaf);
  recipe.parts[0].relief = relief;
  return recipe;
};

test('the leaf of the guide is one lawful solid whose veins are cut into its front', (t) => {
  const folder = workFolder(t);
  const cut = make(folder, leaf);
  assert.deepEqual(cut.relief, { mode: 'ink', seen: true, raises: true, explained: 0, share: 1 });
  const plain = make(folder, withRelief(undefined));
  assert.equal(plain.relief, null);
  const raised = make(folder, withRelief({ ...leaf.parts[0].relief, height: -0.02 }));
  for (const part of [cut, plain, raised]) assert.ok(part.lawful && part.genus === 0 && part.shells === 1, part.broken);
  assert.ok(cut.volume < plain.volume * 0.997 && raised.volume > plain.volume * 1.003);
  assert.ok(cut.triangles > plain.triangles && cut.triangles <= 60000);
  for (const axis of [0, 1]) {
    assert.ok(Math.abs(cut.low[axis] - plain.low[axis]) < 0.1 && Math.abs(cut.high[axis] - plain.high[axis]) < 0.1);
  }
  assert.equal(cut.low[2], plain.low[2]);
});

test('a photo of a lit surface becomes a relief by its shading, a drawing that has none by its lines', (t) => {
  const folder = workFolder(t);
  const side = 200;
  const photo = new PNG({ width: side, height: side });
  // A dome with bumps, lit from the upper left: the normal of its true surface.
  const height = (x, y) => {
    const r = Math.hypot(x, y);
    return 0.7 * Math.sqrt(Math.max(0, 1 - r * r)) + 0.035 * Math.sin(14 * x) * Math.sin(14 * y);
  };
  for (let y = 0; y < side; ++y) {
    for (let x = 0; x < side; ++x) {
      const [u, v] = [(x - 99.5) / 90, (99.5 - y) / 90];
      const e = 1e-3;
      const n = [-(height(u + e, v) - height(u - e, v)) / (2 * e), -(height(u, v + e) - height(u, v - e)) / (2 * e), 1];
      const light = (-0.5 * n[0] + 0.5 * n[1] + 0.7 * n[2]) / Math.hypot(...n) / Math.hypot(0.5, 0.5, 0.7);
      const linear = Math.min(1, 0.1 + 0.7 * Math.max(0, light));
      const srgb = linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
      photo.data.set([...Array(3).fill(Math.hypot(u, v) < 1 ? Math.round(255 * srgb) : 255), 255], 4 * (y * side + x));
    }
  }
  writeFileSync(folder.path('dome.png'), PNG.sync.write(photo));
  const circle = Array.from({ length: 60 }, (_, i) => (i * Math.PI) / 30).flatMap((a) => [
    99.5 + 88 * Math.cos(a),
    99.5 + 88 * Math.sin(a),
  ]);
  const dome = {
    pictures: [{ id: 1, size: [side, side] }],
    parts: [
      {
        id: 1,
        kind: 'puff',
        recipe: { region: { picture: 1, contours: [circle] }, puff: { height: 0.7 } },
        relief: { mode: 'shade', height: 0.03 },
      },
    ],
  };
  const shaded = make(folder, dome, [`1=${folder.path('dome.png')}`]);
  assert.equal(shaded.relief.mode, 'shade');
  assert.ok(shaded.relief.explained > 0.3, `${shaded.relief.explained}`);
  assert.ok(shaded.lawful && shaded.genus === 0);
  const drawing = make(folder, withRelief({ mode: 'shade' }));
  assert.equal(drawing.relief.mode, 'ink');
  assert.ok(drawing.relief.explained < 0.1);
});

test('another picture is laid on a part; one that is not there, and numbers out of range, are told', (t) => {
  const folder = workFolder(t);
  const emblem = new PNG({ width: 100, height: 100 });
  for (let i = 0; i < 10000; ++i) {
    const inside = Math.hypot((i % 100) - 49.5, Math.floor(i / 100) - 49.5) < 30;
    emblem.data.set([...Array(3).fill(inside ? 0 : 255), 255], 4 * i);
  }
  writeFileSync(folder.path('emblem.png'), PNG.sync.write(emblem));
  const recipe = withRelief({ mode: 'ink', laid: { picture: 2, at: [420, 340], width: 150 } });
  recipe.pictures.push({ id: 2, size: [100, 100] });
  const part = make(folder, recipe, [`2=${folder.path('emblem.png')}`]);
  assert.ok(part.lawful && part.relief.seen);
  assert.ok(part.volume < make(folder, withRelief(undefined)).volume - 5000);
  const refused = (relief) => {
    writeFileSync(folder.path('bad.json'), JSON.stringify(withRelief(relief)));
    return fails(kBadRecipe, 'make', '--recipe', folder.path('bad.json'), '--out', folder.path('bad.obj'));
  };
  assert.match(refused({ height: 3 }), /height of a relief/);
  assert.match(refused({ mode: 'deep' }), /ink, bright, shade|mode/);
  assert.match(refused({ laid: { picture: 9, at: [1, 1] } }), /relief\.laid/);
});
