// spineloft loft --recipe: puffs with a slice, and the bones of their outlines in the report.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { barFolder, fails, readJson, works, workFolder } from '../support/cli.mjs';

const arc = (x, y, r, from, to, n = 60) =>
  Array.from({ length: n + 1 }, (_, i) => {
    const a = from + ((to - from) * i) / n;
    return [x + r * Math.cos(a), y + r * Math.sin(a)];
  }).flat();
const circle = (x, y, r) => arc(x, y, r, 0, 2 * Math.PI * (1 - 1 / 120), 119);
const disc = [circle(200, 200, 120)];
const stadium = [
  [...arc(320, 200, 60, -Math.PI / 2, Math.PI / 2), ...arc(80, 200, 60, Math.PI / 2, (3 * Math.PI) / 2)],
];
const ring = [circle(200, 200, 150), circle(200, 200, 70)];

const document = (contours, recipe = {}) => ({
  pictures: [{ id: 1, size: [400, 400] }],
  parts: [{ id: 1, kind: 'puff', recipe: { region: { picture: 1, contours }, ...recipe } }],
});
const sliced = (shape, more = {}) => ({ profile: { slices: [{ shape }], ...more } });

function write(folder, json) {
  writeFileSync(folder.path('puff.json'), JSON.stringify(json));
  return folder.path('puff.json');
}
function reported(folder, contours, recipe) {
  const file = write(folder, document(contours, recipe));
  works('loft', '--recipe', file, '--report', folder.path('report.json'));
  return readJson(folder.path('report.json'));
}

test('the report of a puff says where the bones of its outline are', (t) => {
  const folder = workFolder(t);
  const { bones } = reported(folder, stadium);
  assert.deepEqual([bones.ends, bones.forks, bones.rings, bones.branches.length], [2, 0, 0, 1]);
  assert.ok(Math.abs(bones.length - 240) < 6, `${bones.length}`);
  for (let i = 0; i < bones.branches[0].length; i += 3) {
    const [x, y, half] = bones.branches[0].slice(i, i + 3);
    assert.ok(x > 77 && x < 323 && Math.abs(y - 200) < 1 && Math.abs(half - 60) < 1, `${x} ${y} ${half}`);
  }
  assert.deepEqual([reported(folder, disc).bones.ends, reported(folder, ring).bones.rings], [0, 1]);
  const two = reported(folder, [...disc.map((line) => line.map((v) => v / 2)), circle(330, 330, 40)]).bones;
  assert.equal(two.branches.length, 2, 'a bone for each piece');
});

test('a slice makes a ball, a torus, a prism; shells and handles follow from its curves', (t) => {
  const folder = workFolder(t);
  const near = (mesh, volume, share) =>
    assert.ok(mesh.lawful && Math.abs(mesh.volume / volume - 1) < share, `${mesh.volume}, not ${volume}`);
  const points = { puff: { points: 4000 } };
  near(
    reported(folder, disc, { ...points, ...sliced({ preset: 'circle' }) }).mesh,
    (4 / 3) * Math.PI * 120 ** 3,
    0.015,
  );
  const torus = reported(folder, ring, { ...points, ...sliced({ preset: 'circle' }) }).mesh;
  near(torus, 2 * Math.PI ** 2 * 110 * 40 ** 2, 0.02);
  assert.equal(torus.genus, 1);
  assert.equal(torus.crossesItself, false);
  near(
    reported(folder, stadium, { ...points, ...sliced({ preset: 'square' }, { follow: 0 }) }).mesh,
    (Math.PI * 60 ** 2 + 240 * 120) * 120,
    0.01,
  );
  const box = (left, right) => [left, -0.3, right, -0.3, right, 0.3, left, 0.3];
  const rim = reported(folder, disc, sliced({ contours: [box(0.6, 0.9), box(-0.9, -0.6)] })).mesh;
  assert.deepEqual([rim.genus, rim.shells], [1, 1]);
  const both = reported(folder, ring, sliced({ contours: [box(0.6, 0.9), box(-0.9, -0.6), box(-0.3, 0.3)] })).mesh;
  assert.deepEqual([both.genus, both.shells], [3, 3]);
});

test('a ring too thin to show is drawn thicker, and the report says so', (t) => {
  const folder = workFolder(t);
  const box = (left, right) => [left, -0.3, right, -0.3, right, 0.3, left, 0.3];
  for (const [right, thickened] of [
    [0.501, 1],
    [0.6, 0],
  ]) {
    const { mesh, profile } = reported(folder, disc, sliced({ contours: [box(0.5, right), box(-right, -0.5)] }));
    assert.deepEqual(
      { genus: mesh.genus, lawful: mesh.lawful, crosses: mesh.crossesItself },
      { genus: 1, lawful: true, crosses: false },
    );
    assert.equal(profile.thickened, thickened);
  }
});

test('without a slice a puff is what it was, and a recipe comes back from its file', (t) => {
  const folder = workFolder(t);
  const soft = reported(folder, stadium).mesh;
  assert.deepEqual(reported(folder, stadium, { profile: {} }).mesh, soft);
  const file = write(folder, document(stadium, sliced({ preset: 'hexagon' }, { follow: 0.5 })));
  works('loft', '--recipe', file, '--out', folder.path('one.glb'));
  works('open', folder.path('one.glb'), '--document', folder.path('again.json'), '--out', folder.path('two.stl'));
  const { recipe } = readJson(folder.path('again.json')).parts[0];
  assert.deepEqual(recipe.profile, { slices: [{ shape: { preset: 'hexagon' } }], follow: 0.5 });
});

test('what is wrong with a slice or an outline is named', (t) => {
  const folder = barFolder(t);
  const refused = (contours, recipe, words) => {
    const file = write(folder, document(contours, recipe));
    assert.match(fails(3, 'loft', '--recipe', file, '--report', folder.path('report.json')), words);
  };
  refused(disc, sliced({ preset: 'd' }), /mirror image/);
  refused(disc, sliced({ preset: 'round' }), /preset/);
  const pairs = [
    [100, 100],
    [300, 100],
    [200, 300],
  ];
  for (const contours of [pairs, [pairs]]) {
    refused(contours, {}, /not of pairs/);
    writeFileSync(folder.path('one.json'), JSON.stringify({ kind: 'puff', recipe: { region: { contours } } }));
    assert.match(
      fails(3, 'loft', folder.path('bar.png'), '--recipe', folder.path('one.json'), '--report', folder.path('r.json')),
      /not of pairs/,
    );
  }
  refused(disc, sliced({ preset: 'circle' }, { follow: 2 }), /follow/);
  refused(
    disc,
    sliced({
      contours: [
        [
          [0, 1],
          [1, 0],
          [0, -1],
          [-1, 0],
        ],
      ],
    }),
    /contours: .*not of pairs/,
  );
});

test('each fault of a slice is told in words', (t) => {
  const folder = barFolder(t);
  const box = (left, low, right, high) => [left, low, right, low, right, high, left, high];
  const slices = (...all) => ({ profile: { slices: all } });
  const beside = { shape: { contours: [box(0.4, -0.3, 0.8, 0.3), box(-0.8, -0.3, -0.4, 0.3)] }, at: [200, 200] };
  const round = { shape: { preset: 'circle' } };
  for (const [recipe, words] of [
    [sliced({ preset: 'd' }), /preset: .*mirror image/],
    [sliced({ preset: 'round' }), /preset: it must be one of "circle", .*"square"/],
    [sliced({ contours: [box(-1.5, -1, 1.5, 1)] }), /contours: .*beyond/],
    [sliced({ contours: [box(0.2, -0.3, 0.6, 0.3)] }), /contours: .*mirror image/],
    [sliced({ contours: [[-1, -1, 1, 1, 1, -1, -1, 1]] }), /contours: .*cross/],
    [sliced({ contours: [[0, 0, 0, 0.5, 0, 1]] }), /contours: ./],
    [sliced({ contours: Array(17).fill(box(-1, -1, 1, 1)) }), /contours: .*16/],
    [sliced({ contours: [[0, 1, 2]] }), /contours: each .* one list x, y, x, y/],
    [sliced({ contours: 'x' }), /contours: it must be a list, each member one list x, y/],
    [sliced({ preset: 'circle' }, { follow: 2 }), /follow: .*0 … 1/],
    [sliced({ preset: 'circle' }, { across: 'length', reach: 5 }), /reach: .*0.002 … 0.5/],
    [sliced({ preset: 'circle' }, { across: 'wide' }), /across: it must be one of "share", "length"/],
    [slices(...Array(9).fill(round)), /slices: .*at most 8/],
    [slices(round, round), /no place/],
    [slices(round, beside), /as many bodies, rings and holes/],
    [{ puff: { sides: 'front' }, ...sliced({ contours: [box(-0.5, -1, 0.5, -0.2)] }) }, /on that side/],
    [{ bones: { heights: [{ at: [200, 200], factor: 9 }] }, ...sliced({ preset: 'circle' }) }, /factor.*0.1 … 4/],
    [{ bones: { detail: 3 }, ...sliced({ preset: 'circle' }) }, /detail: .*0 … 1/],
    [sliced({ preset: 7 }), /preset: it must be one of "circle"/],
    [sliced({ preset: null }), /preset: it must be one of "circle"/],
    [sliced('circle'), /shape: it must be an object with some of the keys preset, contours/],
    [{ profile: [] }, /profile: it must be an object with some of the keys across, reach, slices, follow/],
    [{ profile: { slices: round } }, /slices: it must be a list, each member an object .* shape, at/],
    [slices('circle'), /slices: each member .* an object .* shape, at/],
    [slices({ ...round, at: '200, 200' }), /slices\.0\.at: it must be null, or a list of two numbers: x, y/],
    [slices({ ...round, at: [200] }), /slices\.0\.at: .* two numbers/],
    [sliced({ preset: 'circle' }, { follow: 'much' }), /follow: it must be a number/],
    [sliced({ preset: 'circle' }, { reach: true }), /reach: it must be a number/],
    [{ puff: { points: 4000.5 } }, /puff\.points: it must be a whole number/],
    [{ puff: { points: 10 } }, /puff\.points: .*…/],
    [{ puff: { sides: 'left' } }, /puff\.sides: it must be one of "both", "front", "back"/],
    [{ puff: { height: '2' } }, /puff\.height: it must be a number/],
    [{ bones: 'few' }, /bones: it must be an object with some of the keys detail, drop, add, move, heights/],
    [{ bones: { detail: 'few' } }, /bones\.detail: it must be a number/],
    [{ bones: { drop: [200] } }, /bones\.drop: it must be one list x, y, x, y/],
    [{ bones: { drop: 'all' } }, /bones\.drop: it must be one list x, y, x, y/],
    [{ bones: { add: [1, 2, 3, 4] } }, /bones\.add: each member .* one list x, y, x, y/],
    [{ bones: { add: [[1, 'x']] } }, /bones\.add: each member .* one list x, y, x, y/],
    [{ bones: { move: [[1, 2, 3, 4]] } }, /bones\.move: each member .* an object .* from, to/],
    [{ bones: { heights: [[200, 200, 2]] } }, /bones\.heights: each member .* an object .* at, factor/],
    [{ bones: { heights: [{ at: [200, 200], factor: '2' }] } }, /heights\.0\.factor: it must be a number/],
    [{ bones: { drop: Array(200).fill(200) } }, /bones\.drop: more than 64/],
    [{ bones: { add: [Array(600).fill(200)] } }, /bones\.add: a bone of more than 256/],
    [sliced({ preset: 'circle' }, { folow: 1 }), /nothing named parts\.0\.recipe\.profile\.folow/],
    [slices({ ...round, there: [1, 2] }), /nothing named parts\.0\.recipe\.profile\.slices\.0\.there/],
    [sliced({ preset: 'circle', corners: 4 }), /nothing named parts\.0\.recipe\.profile\.slices\.0\.shape\.corners/],
    [{ bones: { remove: [200, 200] } }, /nothing named parts\.0\.recipe\.bones\.remove/],
    [
      { bones: { heights: [{ at: [200, 200], factr: 2 }] } },
      /nothing named parts\.0\.recipe\.bones\.heights\.0\.factr/,
    ],
    [{ bone: {} }, /nothing named parts\.0\.recipe\.bone/],
    [{ region: { picture: 1, contours: disc, widht: 2 } }, /nothing named parts\.0\.recipe\.region\.widht/],
  ]) {
    const said = fails(3, 'loft', '--recipe', write(folder, document(disc, recipe)), '--report', folder.path('r.json'));
    assert.match(said, words, JSON.stringify(recipe).slice(0, 200));
    assert.doesNotMatch(said, /damaged/);
  }
  for (const [contours, words] of [
    [[], /parts\.0: .*outline.*: draw a larger one/],
    [[[100, 100, 300, 300]], /parts\.0: .*outline.*: draw a larger one/],
    [[circle(900, 900, 50)], /parts\.0: .*outside the picture: draw it/],
    [Array(501).fill(circle(200, 200, 50)), /at most 500 outlines/],
    [[arc(200, 200, 150, 0, 2 * Math.PI, 100001)], /at most 100000 points/],
    [[[1e7, 0, 0, 1e7, 5, 5]], /parts\.0: ./],
    ['round', /contours: it must be a list, each member one list x, y/],
    [[[100, 100, 'x', 300]], /contours: each member .* one list x, y/],
  ]) {
    const file = write(folder, document(contours));
    assert.match(fails(3, 'loft', '--recipe', file, '--report', folder.path('r.json')), words);
  }
  const whole = document(disc);
  for (const [change, words] of [
    [{ parts: [{ ...whole.parts[0], kind: 'puf' }] }, /kind must be one of .*"puff"/],
    [{ parts: [{ ...whole.parts[0], colour: 'red' }] }, /nothing named parts\.0\.colour/],
    [{ pictures: [{ ...whole.pictures[0], paper: 'white' }] }, /nothing named pictures\.0\.paper/],
    [{ title: 'disc' }, /nothing named title/],
  ]) {
    const file = write(folder, { ...whole, ...change });
    assert.match(fails(3, 'loft', '--recipe', file, '--report', folder.path('r.json')), words);
  }
});

test('the recipes after Levet and Granier have the bones, pieces and handles of their figures', (t) => {
  const folder = workFolder(t);
  const file = (name) => new URL(`../../assets/docs/recipes/${name}.json`, import.meta.url).pathname;
  const of = (name) => {
    works('loft', '--recipe', file(name), '--report', folder.path('report.json'));
    return [readJson(folder.path('report.json'))].flat();
  };
  const nodes = (parts) => parts.map(({ bones }) => [bones.ends, bones.rings]);
  assert.deepEqual(nodes(of('waved-disc')), [[0, 0]]);
  const [pieces] = of('three-piece-slice');
  assert.deepEqual([pieces.mesh.shells, pieces.mesh.genus], [3, 2]);
  assert.deepEqual(nodes(of('one-smooth-bone')), [[2, 0]]);
  const [box] = of('box');
  assert.ok(Math.abs(box.mesh.volume / (240 * 120 * 120) - 1) < 0.002, `${box.mesh.volume}`);
  assert.deepEqual(
    of('letters').map(({ mesh }) => mesh.genus),
    [4, 0, 1],
  );
  assert.deepEqual(nodes(of('bones-of-outlines')), [
    [5, 0],
    [3, 0],
    [2, 0],
    [4, 0],
    [4, 0],
    [0, 2],
  ]);
});

test('every outline, slice and bone of a list of bad ones makes a lawful solid or is refused with what is wrong', (t) => {
  const folder = workFolder(t);
  const round = { shape: { preset: 'circle' } };
  const square = [100, 100, 300, 100, 300, 300, 100, 300];
  const box = (left, right) => [left, -0.3, right, -0.3, right, 0.3, left, 0.3];
  const rings = (count) =>
    Array.from({ length: count }, (_, i) => [(0.05 + 0.9 * i) / count, (0.7 + 0.9 * i) / count])
      .map(([left, right]) => [box(left, right), box(-right, -left)])
      .flat();
  const sound = {
    'a line that crosses itself': [[[100, 100, 300, 300, 300, 100, 100, 300]]],
    '500 pieces': [
      Array.from({ length: 500 }, (_, i) =>
        arc(10 + (i % 25) * 15.5, 10 + Math.floor(i / 25) * 19, 5, 0, (11 / 6) * Math.PI, 11),
      ),
    ],
    '100,000 points': [[arc(200, 200, 150, 0, 2 * Math.PI, 99999)]],
    'points in a line and twice': [[[100, 100, 150, 100, 200, 100, 200, 100, 300, 100, 300, 300, 300, 300, 100, 300]]],
    'a spike of no width': [[[100, 100, 300, 100, 300, 300, 200, 300, 200, 390, 200, 300, 100, 300]]],
    'a square': [[square]],
    'an octagon': [[arc(200, 200, 100, 0, (7 / 4) * Math.PI, 7)]],
    'a bone outside': [disc, { bones: { add: [[5, 5, 10, 10]] } }, 1],
    'a slice where the outline is not': [
      disc,
      { profile: { slices: [round, { shape: { preset: 'square' }, at: [5, 5] }] } },
      1,
    ],
    '16 curves': [disc, sliced({ contours: rings(8) })],
    'a ring 0.001 wide': [disc, sliced({ contours: [box(0.5, 0.501), box(-0.501, -0.5)] })],
    'an edge on one side': [
      disc,
      { puff: { sides: 'front' }, ...sliced({ preset: 'circle' }, { follow: 0.3, across: 'length', reach: 0.05 }) },
    ],
  };
  for (const [what, [contours, more = {}, asleep = 0]] of Object.entries(sound)) {
    const { mesh, bones } = reported(folder, contours, { ...sliced({ preset: 'circle' }), ...more });
    assert.ok(mesh.lawful && mesh.volume > 0, what);
    assert.equal(bones.asleep, asleep, what);
  }
  const refused = {
    'no area': [[[100, 100, 300, 100, 200, 100]], {}, /too small/],
    'one pixel': [[[100, 100, 101, 100, 101, 101, 100, 101]], {}, /too small/],
    'a hole at the outline': [[square, [100.02, 101, 100.02, 299, 299, 299, 299, 101]], {}, /too tangled/],
    lopsided: [disc, sliced({ contours: [[-1, 0, 0, -1, 0.5, 0, 0, 1]] }), /slices\.0\.shape/],
    'touches itself': [disc, sliced({ contours: [[-1, -1, 1, -1, 0, 0, 1, 1, -1, 1, 0, 0]] }), /slices\.0\.shape/],
    'on the axis': [disc, sliced({ contours: [[0, -1, 0, 0, 0, 1]] }), /slices\.0\.shape/],
    'too many slices': [
      disc,
      { profile: { slices: Array.from({ length: 9 }, (_, i) => ({ ...round, at: [100 + 20 * i, 200] })) } },
      /slices/,
    ],
    'too thick': [disc, { ...sliced({ preset: 'circle' }), bones: { heights: [[200, 200, 9]] } }, /heights/],
    'half a place': [disc, { ...sliced({ preset: 'circle' }), bones: { drop: [200] } }, /drop/],
    'too wide an edge': [disc, sliced({ preset: 'circle' }, { across: 'length', reach: 9 }), /reach/],
  };
  for (const [what, [contours, more, words]] of Object.entries(refused)) {
    const file = write(folder, document(contours, { ...sliced({ preset: 'circle' }), ...more }));
    assert.match(fails(3, 'loft', '--recipe', file, '--report', folder.path('report.json')), words, what);
  }
});
