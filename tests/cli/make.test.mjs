// spineloft make: recipes with several pictures, silhouettes, and what is measured of them.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { PNG } from 'pngjs';
import { barFolder, fails, readJson, workFolder, works } from '../support/cli.mjs';

const ball = fileURLToPath(new URL('../../assets/docs/recipes/ball-from-two-circles.json', import.meta.url));

const write = (folder, name, json) => {
  const file = folder.path(name);
  writeFileSync(file, JSON.stringify(json));
  return file;
};
/** What make says of a recipe. */
const reportOf = (folder, file, ...rest) => {
  works('make', '--recipe', file, '--report', folder.path('report.json'), ...rest);
  return readJson(folder.path('report.json'));
};

test('the ball from two circles is a ball of radius 80, whose silhouettes are the circles', (t) => {
  const folder = workFolder(t);
  const views = folder.path('views');
  const [part] = reportOf(folder, ball, '--out', folder.path('ball.glb'), '--silhouettes', views).parts;
  assert.ok(part.lawful && part.genus === 0 && part.shells === 1);
  assert.ok(Math.abs(part.volume / ((4 / 3) * Math.PI * 80 ** 3) - 1) <= 5e-3, `${part.volume}`);
  [120, -280, -80].forEach((low, axis) => assert.ok(Math.abs(part.low[axis] - low) <= 0.08, `${part.low}`));
  [280, -120, 80].forEach((high, axis) => assert.ok(Math.abs(part.high[axis] - high) <= 0.08, `${part.high}`));
  assert.deepEqual(
    part.views.map(({ view }) => view),
    ['front', 'right'],
  );
  for (const { iou, largest, mean } of part.views) assert.ok(iou >= 0.99 && largest <= 0.01 && mean <= 0.0015);
  for (const name of ['front', 'side', 'top']) {
    const png = PNG.sync.read(readFileSync(join(views, `${name}.png`)));
    assert.deepEqual([png.width, png.height], [400, 400]);
    let wrong = 0;
    for (let y = 0; y < 400; ++y) {
      for (let x = 0; x < 400; ++x) {
        const away = Math.hypot(x - 200, y - 200) - 80;
        if (Math.abs(away) > 0.6 && png.data[4 * (400 * y + x)] > 127 !== away < 0) ++wrong;
      }
    }
    // From the top, where nothing says it, depth 0 is in the middle of the picture: 199.5.
    assert.ok(wrong <= (name === 'top' ? 260 : 0), `${name}: ${wrong}`);
  }
});

test('lofts and puffs of the guide have the outline that is drawn from the side', (t) => {
  const folder = workFolder(t);
  for (const [name, least] of [
    ['puff-from-the-side', 0.985],
    ['loft-from-the-side', 0.99],
  ]) {
    const file = fileURLToPath(new URL(`../../assets/docs/recipes/${name}.json`, import.meta.url));
    const [part] = reportOf(folder, file, '--silhouettes', folder.path(name)).parts;
    assert.ok(part.lawful && part.genus === 0 && part.shells === 1);
    const [{ view, iou, mean }] = part.views;
    assert.ok(view === 'right' && iou >= least && mean <= 3e-3, `${name}: ${iou}, ${mean}`);
    assert.ok(existsSync(join(folder.path(name), 'side.png')));
    // Without it the front is the same.
    const recipe = readJson(file);
    delete recipe.parts[0].recipe.side;
    const [plain] = reportOf(folder, write(folder, 'plain.json', recipe), '--silhouettes', folder.path('plain')).parts;
    assert.deepEqual(
      [part.low, part.high].map((p) => p.slice(0, 2)),
      [plain.low, plain.high].map((p) => p.slice(0, 2)),
    );
    const front = (where) => readFileSync(join(folder.path(where), 'front.png'));
    assert.ok(front(name).equals(front('plain')));
  }
});

test('a figure of ten shapes is a small document that comes back equal from a GLB and a project', (t) => {
  const folder = workFolder(t);
  const kinds = ['ball', 'egg', 'box', 'cylinder', 'capsule', 'cone', 'pyramid', 'half-ball', 'ball', 'box'];
  const parts = kinds.map((primitive, i) => ({
    id: i + 1,
    kind: 'shape',
    recipe: {
      picture: 1,
      primitive,
      axis: [
        [40 + 30 * i, 200],
        [45 + 30 * i, 120],
      ],
      width: 28,
      depth: { ratio: 0.8 },
      caps: { end: 'round' },
      outlines: i % 3 ? [] : [{ picture: 1, lines: [[30 + 30 * i, 200, 55 + 30 * i, 190, 48 + 30 * i, 120]] }],
    },
  }));
  const pictures = [
    { id: 1, size: [400, 300] },
    { id: 2, size: [200, 300], view: { of: 1, from: 'left', middle: 99, shift: -4 } },
  ];
  const figure = write(folder, 'figure.json', { pictures, parts });
  const report = reportOf(folder, figure, '--out', folder.path('figure.spineloft'), '--silhouettes', folder.path('v'));
  assert.ok(report.parts.every(({ lawful, kind }) => lawful && kind === 'shape'));
  assert.ok(existsSync(folder.path('v/10-side.png')) && !existsSync(folder.path('v/front.png')));
  works('make', '--recipe', figure, '--out', folder.path('figure.glb'));
  const documents = ['figure.spineloft', 'figure.glb'].map((name) => {
    works('open', folder.path(name), '--document', folder.path('again.json'));
    return readFileSync(folder.path('again.json'), 'utf8');
  });
  assert.equal(documents[0], documents[1]);
  assert.ok(documents[0].length <= 4096, `${documents[0].length} bytes`);
  works('make', '--recipe', folder.path('again.json'), '--out', folder.path('again.glb'));
  assert.deepEqual(readFileSync(folder.path('again.glb')), readFileSync(folder.path('figure.glb')));
  const text = works('share', folder.path('figure.glb')).stdout.trim();
  works('open', text, '--document', folder.path('shared.json'));
  assert.deepEqual(readJson(folder.path('shared.json')).pictures[1].view, pictures[1].view);
});

test('every photo of a recipe has a file of its own', (t) => {
  const folder = barFolder(t);
  const bar = folder.path('bar.png');
  const shape = {
    picture: 1,
    axis: [
      [20, 40],
      [20, 10],
    ].map(([x, y]) => [x, y]),
    width: 20,
  };
  const file = write(folder, 'two.json', {
    pictures: [{ id: 1 }, { id: 2, view: { of: 1 } }],
    parts: [{ id: 1, kind: 'shape', recipe: shape }],
  });
  works('make', '--recipe', file, '--picture', `1=${bar}`, '--picture', `2=${bar}`, '--out', folder.path('two.glb'));
  assert.match(fails(3, 'make', '--recipe', file, '--picture', `7=${bar}`), /picture that it has not/);
  assert.match(fails(2, 'make', '--recipe', file, '--picture', bar), /ID=FILE/);
  assert.match(fails(2, 'make', '--recipe', file, '--picture', `1=${bar}`, '--picture', `1=${bar}`), /named twice/);
  assert.match(fails(2, 'make', '--picture', `1=${bar}`), /--recipe/);
});

test('outlines and views that make no shape are refused with one sentence', (t) => {
  const folder = workFolder(t);
  const json = readJson(ball);
  const refused = (change, words) => {
    const other = structuredClone(json);
    change(other);
    const bad = write(folder, 'bad.json', other);
    assert.match(fails(3, 'make', '--recipe', bad, '--out', folder.path('bad.glb')), words);
    assert.ok(!existsSync(folder.path('bad.glb')));
  };
  const recipe = (other) => other.parts[0].recipe;
  refused((other) => (recipe(other).outlines[0].lines = [[150, 100, 250, 300, 150, 300, 250, 100]]), /crosses itself/);
  refused((other) => (recipe(other).outlines[1].lines = [[200, 60, 280, 200, 200, 340, 120, 200]]), /longer than/);
  refused((other) => (recipe(other).width = -1), /recipe/);
  refused((other) => (recipe(other).primitive = 'sphere'), /primitive/);
  refused((other) => (other.pictures[1].view.of = 2), /view|outlines/);
  refused((other) => (other.pictures[0].view = { of: 2 }), /view|outlines/);
  refused((other) => delete other.pictures[1].view, /outlines/);
});
