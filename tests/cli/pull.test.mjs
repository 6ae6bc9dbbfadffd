// Pulls from outside: recipes in, files and reports out.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { fails, readJson, workFolder, works } from '../support/cli.mjs';

const face = fileURLToPath(new URL('../../assets/docs/recipes/face.json', import.meta.url));

const ladybird = fileURLToPath(new URL('../../assets/docs/recipes/ladybird.json', import.meta.url));

const kBadRecipe = 3;

/** A flat piece of 1,000 × 400, with these pulls. */
const strip = (pulls) => ({
  pictures: [{ id: 1, size: [1200, 600] }],
  parts: [
    {
      id: 1,
      kind: 'sheet',
      recipe: {
        region: { picture: 1, contours: [[100, 100, 1100, 100, 1100, 500, 100, 500]] },
        sheet: { thickness: 0.02, edge: 'sharp' },
      },
      pulls,
    },
  ],
});
const make = (folder, recipe, name = 'part') => {
  const [file, obj, report] = ['json', 'obj', 'report.json'].map((ending) => folder.path(`${name}.${ending}`));
  writeFileSync(file, JSON.stringify(recipe));
  works('make', '--recipe', file, '--out', obj, '--report', report);
  const places = readFileSync(obj, 'utf8').match(/^v .*$/gm);
  return { part: readJson(report).parts[0], places: places.map((line) => line.split(' ').slice(1, 4).map(Number)) };
};

test('a flat piece pulled along its middle by h has the height 1 - 3t² + 2t³, a crease 1 - t, and nothing beyond', (t) => {
  const folder = workFolder(t);
  const [h, radius] = [30, 80];
  const plain = make(folder, strip([]), 'plain');
  const depth = plain.part.high[2];
  const thick = depth - plain.part.low[2];
  const wide = Math.max(...plain.places.map(([x]) => x)) - Math.min(...plain.places.map(([x]) => x));
  for (const crease of [false, true]) {
    const { part, places } = make(
      folder,
      strip([{ line: [90, -300, depth, 1110, -300, depth], height: h, radius, crease }]),
    );
    assert.ok(part.lawful && part.genus === 0 && part.shells === 1, part.broken);
    assert.equal(part.pulls[0].share, 1);
    assert.ok(Math.abs(part.high[2] - depth - h) < 0.01 * h, `${part.high}`);
    // In a file the part stands elsewhere, in other units: its own places say how.
    const scale = 1000 / wide;
    const low = [0, 1, 2].map((axis) => Math.min(...places.map((p) => p[axis])) * scale);
    let seen = 0;
    for (const p of places) {
      const [x, y, z] = p.map((value, axis) => value * scale - low[axis]);
      const away = Math.abs(y - 200) / radius;
      if (x < 300 || x > 700 || y < 1 || y > 399 || z < thick / 2) continue;
      ++seen;
      const told = away >= 1 ? 0 : crease ? 1 - away : 1 - 3 * away ** 2 + 2 * away ** 3;
      assert.ok(Math.abs(z - thick - h * told) < 0.01 * h, `${x} ${y} ${z}: ${h * told}`);
      if (away >= 1.001) assert.ok(Math.abs(z - thick) < 0.01, `${y} ${z}`);
    }
    assert.ok(seen > 500, `${seen}`);
  }
});

/** A circle of 32 places on the front of the strip. */
const circle = (x, y, z, radius) =>
  Array.from({ length: 32 }, (_, i) => [
    x + radius * Math.cos((Math.PI * i) / 16),
    y + radius * Math.sin((Math.PI * i) / 16),
    z,
  ]).flat();

test('a bump goes through both of its profiles, and its ring stays', (t) => {
  const folder = workFolder(t);
  const plain = make(folder, strip([]), 'plain');
  const depth = plain.part.high[2];
  const thick = depth - plain.part.low[2];
  const wide = Math.max(...plain.places.map(([x]) => x)) - Math.min(...plain.places.map(([x]) => x));
  const [x, y, r, h] = [600, -300, 120, 70];
  const arch = (power, at) =>
    Array.from({ length: 33 }, (_, i) => {
      const t = i / 32;
      return [...at(-r + 2 * r * t), depth + h * Math.sin(Math.PI * t) ** power];
    }).flat();
  const bump = {
    line: [x - r, y, depth, x + r, y, depth],
    to: arch(1, (way) => [x + way, y]),
    across: [x, y - r, depth, x, y + r, depth],
    acrossTo: arch(2, (way) => [x, y + way]),
    ring: circle(x, y, depth, r),
    crease: true,
  };
  const { part, places } = make(folder, strip([bump]));
  assert.ok(part.lawful && part.genus === 0 && part.shells === 1, part.broken);
  assert.equal(part.pulls[0].share, 1);
  for (const [, , z] of part.pulls[0].ring) assert.ok(Math.abs(z - depth) < 0.01);
  const scale = 1000 / wide;
  const low = [0, 1, 2].map((axis) => Math.min(...places.map((p) => p[axis])) * scale);
  const over = [0, 0];
  for (const p of places) {
    const [px, py, pz] = p.map((value, axis) => value * scale - low[axis]);
    const [dx, dy, up] = [px - 500, py - 200, pz - thick];
    if (up < -0.01 || Math.hypot(dx, dy) > 1.01 * r) continue;
    for (const [which, beside, way] of [
      [0, dy, dx],
      [1, dx, dy],
    ]) {
      if (Math.abs(beside) > 0.01) continue;
      ++over[which];
      const told = h * Math.sin((Math.PI * (way + r)) / (2 * r)) ** (which + 1);
      // Between the points of a steep profile the height is less exact than the way to it.
      assert.ok(
        Math.abs(up - told) < 0.002 * 2 * r * Math.hypot(1, (Math.PI * h) / (2 * r)),
        `${which} ${way} ${up} ${told}`,
      );
    }
  }
  assert.ok(
    over.every((count) => count > 15),
    `${over}`,
  );
});

test('the ladybird of the guide is one lawful solid whose spots and eyes all rise', (t) => {
  const folder = workFolder(t);
  works('make', '--recipe', ladybird, '--out', folder.path('ladybird.glb'), '--report', folder.path('report.json'));
  const [part] = readJson(folder.path('report.json')).parts;
  assert.ok(part.lawful && part.genus === 0 && part.shells === 1, part.broken);
  assert.equal(part.pulls.filter(({ ring }) => ring?.length > 60).length, 8);
  for (const { share } of part.pulls) assert.equal(share, 1);
});

test('a ring of two places, and a line across that alone is told where to go, are refused with a sentence', (t) => {
  const folder = workFolder(t);
  const refused = (pull) => {
    writeFileSync(folder.path('bad.json'), JSON.stringify(strip([pull])));
    return fails(kBadRecipe, 'make', '--recipe', folder.path('bad.json'), '--out', folder.path('bad.obj'));
  };
  assert.match(refused({ line: [600, -300, 10], ring: [600, -300, 10, 610, -300, 10] }), /the ring of a bump has 3/);
  assert.match(
    refused({ line: [600, -300, 10], across: [600, -300, 10], acrossTo: [600, -300, 20] }),
    /the line across is told where it goes if the first one is/,
  );
});

test('the face of the guide is one lawful solid, whose pulls all go as far as they are told', (t) => {
  const folder = workFolder(t);
  works('make', '--recipe', face, '--out', folder.path('face.glb'), '--report', folder.path('report.json'));
  const [part] = readJson(folder.path('report.json')).parts;
  assert.ok(part.lawful && part.genus === 0 && part.shells === 1, part.broken);
  assert.equal(part.pulls.length, 10);
  for (const { share, line } of part.pulls) assert.ok(share === 1 && line.length > 0);
});

test('a model that was pulled is the same after a GLB and after the text of a link', (t) => {
  const folder = workFolder(t);
  works('make', '--recipe', face, '--out', folder.path('face.glb'));
  works('open', folder.path('face.glb'), '--out', folder.path('again.obj'));
  works('make', '--recipe', face, '--out', folder.path('face.obj'));
  assert.equal(readFileSync(folder.path('again.obj'), 'utf8'), readFileSync(folder.path('face.obj'), 'utf8'));
  const text = works('share', folder.path('face.glb')).stdout.trim();
  assert.ok(text.length < 900, `${text.length} characters`);
  // A link keeps quarters of a pixel.
  const told = (name) => readFileSync(folder.path(name), 'utf8').match(/^v .*$/gm);
  works('open', text, '--out', folder.path('link.obj'));
  const [linked, own] = [told('link.obj'), told('face.obj')];
  assert.ok(Math.abs(linked.length / own.length - 1) < 0.1, `${linked.length} ${own.length}`);
  const tallest = (places) => Math.max(...places.map((line) => Number(line.split(' ')[3])));
  assert.ok(Math.abs(tallest(linked) / tallest(own) - 1) < 0.01, `${tallest(linked)} ${tallest(own)}`);
});

test('a pull that cannot be is named, and so is a key that is not known', (t) => {
  const folder = workFolder(t);
  const bad = [{ line: [100, -300, 10], height: 10, radius: -5 }];
  writeFileSync(folder.path('bad.json'), JSON.stringify(strip(bad)));
  const said = fails(kBadRecipe, 'make', '--recipe', folder.path('bad.json'), '--out', folder.path('bad.obj'));
  assert.match(said, /radius of a pull/);
  writeFileSync(folder.path('unknown.json'), JSON.stringify(strip([{ line: [100, -300, 10], heigth: 10 }])));
  assert.match(
    fails(kBadRecipe, 'make', '--recipe', folder.path('unknown.json'), '--out', folder.path('bad.obj')),
    /heigth/,
  );
});
