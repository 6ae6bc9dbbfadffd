// spineloft loft --recipe: what a person authored, as JSON, becomes the model that the page would make.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import validator from 'gltf-validator';
import { barFolder, barStroke, fails, glbJson, readJson, readObj, run, works, workFolder } from '../support/cli.mjs';

const recipes = fileURLToPath(new URL('../../assets/docs/recipes/', import.meta.url));
const recipe = (name) => join(recipes, `${name}.json`);

function write(folder, name, json) {
  writeFileSync(folder.path(name), typeof json === 'string' ? json : JSON.stringify(json));
  return folder.path(name);
}

/** Lofts the recipe and returns the reports of its parts. */
function reports(folder, file, ...rest) {
  works('loft', ...rest, '--recipe', file, '--report', folder.path('report.json'));
  return [readJson(folder.path('report.json'))].flat();
}

test('every recipe of the guide makes closed solids and a GLB without a fault that can be edited again', async (t) => {
  // Bare drawings are no documents: drawing.test.mjs.
  const all = readdirSync(recipes).map((file) => file.replace(/\.json$/, ''));
  const names = all.filter((name) => !('drawing' in readJson(recipe(name))));
  assert.deepEqual(names.sort(), [
    'ball-from-two-circles',
    'bones-of-outlines',
    'box',
    'bridges',
    'castle-wall',
    'creature-of-lines',
    'crossed-pipes',
    'elliptical-ring',
    'face',
    'hand',
    'helix',
    'ladybird',
    'leaf',
    'letters',
    'loft-from-the-side',
    'one-smooth-bone',
    'puff-from-the-side',
    'ring',
    'terrain',
    'three-piece-slice',
    'tooth',
    'toothpaste-tube',
    'twisted-pasta',
    'vase',
    'volcano',
    'waved-disc',
    'wine-glass',
    'y-fork',
  ]);
  const folder = workFolder(t);
  // By part; where nothing is said there are none.
  const handles = {
    ring: [1],
    'elliptical-ring': [1],
    'crossed-pipes': [1],
    letters: [4, 0, 1],
    'three-piece-slice': [2],
    'bones-of-outlines': [0, 0, 0, 0, 0, 2],
  };
  for (const name of names) {
    const glb = folder.path(`${name}.glb`);
    works('loft', '--recipe', recipe(name), '--out', glb);
    for (const [part, { mesh }] of reports(folder, recipe(name)).entries()) {
      const genus = handles[name]?.[part] ?? 0;
      assert.ok(mesh.closed && mesh.lawful && mesh.genus === genus && mesh.volume > 0, `${name} ${part}`);
    }
    const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(glb)));
    assert.equal(issues.numErrors + issues.numWarnings, 0, JSON.stringify(issues.messages));
    works('open', glb, '--document', folder.path('again.json'));
    works('loft', '--recipe', folder.path('again.json'), '--out', folder.path('again.glb'));
    assert.deepEqual(readFileSync(folder.path('again.glb')), readFileSync(glb), `${name} from the document of its GLB`);
  }
});

test('the wine glass and the ring have the volumes that Pappus gives, and follow their numbers', (t) => {
  const folder = workFolder(t);
  const made = (name, lathe = {}, region = {}) => {
    const json = readJson(recipe(name));
    Object.assign(json.parts[0].recipe.lathe, lathe);
    Object.assign(json.parts[0].recipe.region, region);
    return reports(folder, write(folder, 'spun.json', json))[0].mesh;
  };
  const near = (mesh, volume, share) =>
    assert.ok(Math.abs(mesh.volume / volume - 1) <= share, `${mesh.volume}, not ${volume}`);
  const glass = made('wine-glass');
  near(glass, 274914, 1e-3);
  assert.deepEqual([glass.genus, glass.shells], [0, 1]);
  near(made('wine-glass', { sides: 6 }), 274914 * 0.82699, 1e-5);
  near(made('wine-glass', { turn: 180 }), 274914 / 2, 1e-3);
  const ring = made('ring');
  near(ring, 473741, 1e-3);
  assert.deepEqual([ring.genus, made('ring', { turn: 180 }).genus], [1, 0]);
  // A straight cup of a wall of 3: two cylinders and the floor.
  const cup = made('wine-glass', { wall: 3 / 360 }, { contours: [[160, 310, 200, 310, 200, 210]] });
  near(cup, Math.PI * (40 ** 2 * 3 + (40 ** 2 - 37 ** 2) * 97), 5e-3);
  assert.equal(cup.genus, 0);
});

/** Four points of a circle on a plane: the curve through them is within a thousandth of it. */
const circle = (r, x = 0, y = 0) => ({ through: [x + r, y, x, y + r, x - r, y, x, y - r] });
const stack = (recipe) => ({ kind: 'stack', recipe });

test('a stack needs no picture, and is as large as its curves say', (t) => {
  const folder = workFolder(t);
  const made = (recipe) => reports(folder, write(folder, 'stack.json', stack(recipe)))[0].mesh;
  const rail = { points: [0, 0, 0, 0, 100, 0] };
  const linear = { kind: 'linear' };
  const near = (mesh, volume, share) =>
    assert.ok(mesh.lawful && Math.abs(mesh.volume / volume - 1) <= share, `${mesh.volume}, not ${volume}`);
  near(
    made({
      rail,
      planes: [
        { at: 0, curves: [circle(40)], blend: linear },
        { at: 1, curves: [circle(20)] },
      ],
    }),
    293215,
    2e-3,
  );
  const ring = { closed: true, points: [100, 0, 0, 0, 100, 0, -100, 0, 0, 0, -100, 0] };
  const torus = made({ rail: ring, planes: [{ curves: [circle(20)] }] });
  near(torus, 2 * Math.PI ** 2 * 100 * 400, 5e-3);
  assert.equal(torus.genus, 1);
  // A GLB of it opens again, and so does the text of a link, which is short.
  const glb = folder.path('hand.glb');
  works('loft', '--recipe', recipe('hand'), '--out', glb);
  const text = works('share', glb).stdout.trim();
  assert.ok(text.length <= 900, `${text.length} characters`);
  works('open', text, '--out', folder.path('again.glb'));
});

/** Shoelace of x, y, x, y, … */
const areaOf = (through) => {
  let twice = 0;
  for (let i = 0; i < through.length; i += 2) {
    const [x, y, u, v] = [0, 1, 2, 3].map((k) => through[(i + k) % through.length]);
    twice += x * v - u * y;
  }
  return Math.abs(twice) / 2;
};

test('the castle wall is the sum of its prisms and a file of at most 700 bytes, and ground that of its trapezoids', (t) => {
  const folder = workFolder(t);
  const near = (mesh, volume, share) =>
    assert.ok(mesh.lawful && Math.abs(mesh.volume / volume - 1) <= share, `${mesh.volume}, not ${volume}`);
  assert.ok(readFileSync(recipe('castle-wall')).length <= 700);
  const wall = readJson(recipe('castle-wall')).recipe;
  const [pattern] = wall.stack.patterns;
  const places = [];
  for (let copy = 0; copy < pattern.times; ++copy) {
    for (const { at = 0, curves } of wall.planes) {
      places.push({ at: at + copy * pattern.spacing, area: areaOf(curves[0].through) });
    }
  }
  const length = wall.rail.points[3];
  const volume = places.slice(1).reduce((sum, { at }, i) => sum + (at - places[i].at) * length * places[i].area, 0);
  const [{ mesh }] = reports(folder, recipe('castle-wall'));
  near(mesh, volume, 5e-3);
  assert.deepEqual([mesh.genus, mesh.shells, mesh.crossesItself], [0, 1, false]);

  const line = [-40, 12, -10, 30, 15, 18, 40, 26];
  const curves = [{ through: line, corners: 'all', open: true, as: 'ground', base: -3 }];
  const rail = { points: [0, 0, 0, 0, 0, -200] };
  const planes = [
    { at: 0, curves },
    { at: 1, curves },
  ];
  const [ground] = reports(folder, write(folder, 'ground.json', stack({ rail, planes })));
  near(ground.mesh, 200 * areaOf([...line, 40, -3, -40, -3]), 1e-3);

  // Without an amount nothing is rough; with the same seed twice the same.
  const bytes = (rough) => {
    const file = write(folder, 'rough.json', stack({ rail, planes, stack: { rough } }));
    works('loft', '--recipe', file, '--out', folder.path('rough.stl'));
    return readFileSync(folder.path('rough.stl'));
  };
  assert.deepEqual(bytes({ size: 9, seed: 4 }), bytes({}));
  assert.deepEqual(bytes({ amount: 2, seed: 4 }), bytes({ amount: 2, seed: 4 }));
  assert.notDeepEqual(bytes({ amount: 2, seed: 4 }), bytes({ amount: 2, seed: 5 }));
});

test('slices that make no solid are refused with one sentence that names them', (t) => {
  const folder = workFolder(t);
  const refused = (recipe, words) => {
    const bad = write(folder, 'bad.json', stack(recipe));
    assert.match(fails(3, 'loft', '--recipe', bad, '--out', folder.path('bad.glb')), words);
  };
  const rail = { points: [0, 0, 0, 0, 100, 0] };
  const planes = (...curves) =>
    curves.map((curve, i) => ({ at: i / (curves.length - 1 || 1), curves: [curve].flat() }));
  refused({ rail, planes: [] }, /no curve on a sheet/);
  refused({ planes: [{ origin: [0, 0, 0], curves: [circle(9)] }] }, /one sheet alone/);
  refused({ planes: planes(circle(9), circle(9)) }, /sheet 1 has no origin/);
  const eight = { through: [-9, -9, 9, 9, 9, -9, -9, 9], corners: 'all' };
  refused({ rail, planes: planes(circle(9), eight) }, /curve 1 on sheet 2 crosses itself/);
  refused({ rail, planes: planes([circle(9), circle(9, 12)], circle(9)) }, /curves on sheet 1 cross/);
  refused(
    {
      rail,
      planes: [
        { at: 0.5, curves: [circle(9)] },
        { at: 0.5, curves: [circle(9)] },
      ],
    },
    /sheet 1 and sheet 2/,
  );
  refused({ rail: { points: [0, 0, 0, 1] }, planes: planes(circle(9), circle(9)) }, /rail\.points/);
  refused({ rail, planes: [{ at: 7, curves: [circle(9)] }] }, /sheet 1/);
  const open = { through: [-20, 5, 20, 5], open: true };
  const beside = (curve) => ({ rail, planes: planes([circle(3, 90), { ...open, ...curve }], circle(9)) });
  refused(beside({}), /curve 2 on sheet 1 is open: make it a ribbon or ground/);
  refused(beside({ as: 'ribbon' }), /curve 2 on sheet 1 is a ribbon without a width/);
  refused(beside({ as: 'ground', base: 9 }), /curve 2 on sheet 1 goes below its base/);
  refused(beside({ as: 'ribbon', width: 1e9 }), /curve 2 on sheet 1/);
  refused(beside({ as: 'river' }), /as.*"closed", "ribbon", "ground"/);
  const patterned = (...patterns) => ({ rail, planes: planes(circle(9), circle(8)), stack: { patterns } });
  refused(patterned({ last: 2, times: 2, spacing: 0.5 }), /pattern 1 ends with sheet 3, but there are 2/);
  refused(patterned({ times: 4, spacing: 0.5 }), /pattern 1 goes beyond the end of the rail/);
  refused(patterned({ times: 300, spacing: 0.001 }), /301 curves/);
  refused(patterned({ times: 0 }), /pattern 1 is repeated 0 times: choose 1 to 1000/);
  refused(patterned({ times: 2 }), /pattern 1 has no spacing/);
});

test('a profile that cannot be turned is refused with one sentence', (t) => {
  const folder = workFolder(t);
  const refused = (region, lathe, words) => {
    const json = readJson(recipe('wine-glass'));
    Object.assign(json.parts[0].recipe.region, region);
    Object.assign(json.parts[0].recipe.lathe, lathe);
    const bad = write(folder, 'bad.json', json);
    assert.match(fails(3, 'loft', '--recipe', bad, '--report', folder.path('report.json')), words);
  };
  refused({ contours: [[160, 310, 160, 200]] }, {}, /lies on its axis/);
  refused({ contours: [[160, 310, 200, 310, 200, 210]] }, { wall: 0.19 }, /wall is too thick/);
  const zigzag = Array.from({ length: 10000 }, (_, i) => (i % 2 ? 300 - i / 50 : 190 + ((i * 7919) % 13)));
  refused({ contours: [zigzag] }, {}, /too tangled/);
  refused({}, { axisTo: [160, 310] }, /lathe\.axis/);
  refused({}, { sides: 2 }, /sides/);
});

test('the helix winds three times round its line and its bar stays as thick', (t) => {
  const folder = workFolder(t);
  const json = readJson(recipe('helix'));
  const [{ mesh }] = reports(folder, recipe('helix'), '--out', folder.path('helix.obj'), '--obj-space', 'image');
  delete json.parts[0].recipe.pose;
  const [straight] = reports(
    folder,
    write(folder, 'straight.json', json),
    '--out',
    folder.path('bar.obj'),
    '--obj-space',
    'image',
  );
  const extent = (name, axis) => {
    const along = readObj(folder.path(name)).vertices.map((vertex) => vertex[axis]);
    return Math.max(...along) - Math.min(...along);
  };
  const thick = extent('bar.obj', 0);
  for (const axis of [0, 2]) {
    assert.ok(
      Math.abs(extent('helix.obj', axis) / (220 + thick) - 1) < 0.03,
      `axis ${axis}: ${extent('helix.obj', axis)}`,
    );
  }
  // The volume grows as the length of the line: the first and the last half turn grow out of it.
  const longer = (turns) => Math.hypot(2 * Math.PI * 110 * turns, 512) / 512;
  const times = mesh.volume / straight.mesh.volume;
  assert.ok(times > longer(2) && times < longer(3), `${times}`);
});

test('a coil so tight that it goes through itself is written, and one sentence names the part; one that does not, none', (t) => {
  const folder = workFolder(t),
    json = readJson(recipe('helix'));
  const write20 = (more) => {
    Object.assign(json.parts[0], more);
    json.parts[0].recipe.pose.coilTurns = 20;
    return run('loft', '--recipe', write(folder, 'tight.json', json), '--out', folder.path('tight.glb'));
  };
  const tight = write20({});
  assert.deepEqual(
    [tight.status, /^spineloft: [^\n]*go through themselves[^\n]*\(Spring\)\.\n$/.test(tight.stderr)],
    [0, true],
    tight.stderr,
  );
  assert.ok(existsSync(folder.path('tight.glb')));
  // What is not seen is not written.
  json.parts.push({ ...readJson(recipe('helix')).parts[0], id: 2, name: 'Wide' });
  json.lastPartId = 2;
  assert.deepEqual([write20({ visible: false }).status, write20({ visible: false }).stderr], [0, '']);
});

test('a twist turns the pasta and leaves its volume', (t) => {
  const folder = workFolder(t);
  const json = readJson(recipe('twisted-pasta'));
  const [twisted] = reports(folder, recipe('twisted-pasta'));
  json.parts[0].recipe.loft.twist = [];
  const [straight] = reports(folder, write(folder, 'straight.json', json));
  assert.ok(
    Math.abs(twisted.mesh.volume / straight.mesh.volume - 1) < 0.03,
    `${twisted.mesh.volume} and ${straight.mesh.volume}`,
  );
  assert.ok(twisted.mesh.area > 1.02 * straight.mesh.area);
});

test('a part is put on the picture, with its own stroke or with one that is named', (t) => {
  const folder = barFolder(t);
  const loft = { sections: [{ shape: { preset: 'square' } }], startCap: 'flat', endCap: 'flat' };
  const part = write(folder, 'part.json', { name: 'Post', recipe: { stroke: barStroke.flat(), loft } });
  const bare = write(folder, 'bare.json', { stroke: barStroke.flat(), loft });
  const style = write(folder, 'style.json', { recipe: { loft } });
  const stroke = ['--stroke', folder.path('stroke.json')];
  const stl = (...args) => {
    works('loft', folder.path('bar.png'), ...args, '--out', folder.path('a.stl'));
    return readFileSync(folder.path('a.stl'));
  };
  const wanted = stl(...stroke, '--section', 'square', '--caps', 'flat');
  assert.deepEqual(stl('--recipe', part), wanted);
  assert.deepEqual(stl('--recipe', bare), wanted);
  assert.deepEqual(stl('--recipe', style, ...stroke), wanted);
  works('loft', folder.path('bar.png'), '--recipe', part, '--out', folder.path('a.glb'), '--height-mm', '50');
  const { name, parts, height } = glbJson(readFileSync(folder.path('a.glb'))).extensions.SPINELOFT_project.document;
  assert.deepEqual([name, parts[0].name, height], ['bar', 'Post', 50]);
});

test('the document of a saved model is a recipe on its photo, and needs it', (t) => {
  const folder = barFolder(t);
  works('loft', folder.path('bar.png'), '--stroke', folder.path('stroke.json'), '--out', folder.path('bar.glb'));
  works('open', folder.path('bar.glb'), '--document', folder.path('bar.json'));
  works('loft', folder.path('bar.png'), '--recipe', folder.path('bar.json'), '--out', folder.path('again.glb'));
  assert.deepEqual(readFileSync(folder.path('again.glb')), readFileSync(folder.path('bar.glb')));
  assert.match(fails(3, 'loft', '--recipe', folder.path('bar.json')), /stands on a photo/);
  assert.match(fails(3, 'loft', folder.path('bar.png'), '--recipe', recipe('helix')), /brings its own pictures/);
  assert.match(
    fails(
      3,
      'loft',
      folder.path('bar.png'),
      '--recipe',
      folder.path('bar.json'),
      '--stroke',
      folder.path('stroke.json'),
    ),
    /lines of its own/,
  );
  const twice = readJson(folder.path('bar.json'));
  twice.pictures.push({ ...twice.pictures[0], id: 2, photo: '0123456789abcdef' });
  assert.match(
    fails(3, 'loft', folder.path('bar.png'), '--recipe', write(folder, 'twice.json', twice)),
    /several photos/,
  );
});

test('a bad recipe ends with 3, says where it is bad, and leaves nothing behind', (t) => {
  const folder = barFolder(t);
  const stroke = barStroke.flat();
  const bad = [
    ['', /empty/],
    ['{', /not JSON/],
    ['[]', /no object/],
    ['['.repeat(100000), /too deep/],
    [{ recipe: 7 }, /recipe is no object/],
    [{ recipe: {} }, /too short/],
    [{ stroke: [1, 2, 3] }, /recipe\.stroke/],
    [{ stroke: [1, 2, 'x', 4] }, /recipe\.stroke/],
    [{ stroke: [-500, -500, -400, -500] }, /outside/],
    [{ stroke, loft: { twist: [0, 0, 1, 1e9] } }, /recipe\.loft\.twist is damaged or out of range/],
    [
      { stroke, loft: { sections: [{}, { at: 0.5, shape: { preset: 'banana' } }] } },
      /recipe\.loft\.sections\.1\.shape\.preset/,
    ],
    [{ stroke, pose: { coilTurns: 1000, coilRadius: 5 } }, /recipe\.pose\.coilTurns/],
    [{ stroke, spine: { ribs: 'many' } }, /recipe\.spine\.ribs/],
    [{ stroke, loft: { twsit: [0, 0, 1, 1] } }, /nothing named recipe\.loft\.twsit/],
    [{ recipe: { stroke }, look: { colour: 'red' } }, /look\.colour/],
    [{ parts: 3 }, /parts is damaged/],
    [{ version: 1000, parts: [] }, /newer/],
  ];
  for (const [json, words] of bad) {
    const file = write(folder, 'bad.json', json);
    const before = folder.list();
    const picture = json.parts === undefined ? [folder.path('bar.png')] : [];
    const sentence = fails(3, 'loft', ...picture, '--recipe', file, '--out', folder.path('a.glb'));
    assert.match(sentence, words, JSON.stringify(json).slice(0, 200));
    assert.match(sentence, /bad\.json/);
    assert.deepEqual(folder.list(), before);
  }
  const tube = readJson(recipe('toothpaste-tube'));
  tube.parts[1].recipe.loft.sections[0].shape.preset = 'geer';
  assert.match(
    fails(3, 'loft', '--recipe', write(folder, 'tube.json', tube)),
    /parts\.1\.recipe\.loft\.sections\.0\.shape\.preset/,
  );
  assert.match(fails(3, 'loft', '--recipe', folder.path('none.json')), /none\.json/);
  assert.match(fails(3, 'loft', '--recipe', write(folder, 'empty.json', { parts: [] })), /no part/);
  assert.match(
    fails(3, 'loft', '--recipe', recipe('toothpaste-tube'), '--mask', folder.path('m.png')),
    /2 parts.*for one/,
  );
});

test('a recipe says section and caps itself, and is no output', (t) => {
  const folder = barFolder(t);
  for (const word of ['--section', '--caps']) {
    assert.match(
      fails(2, 'loft', '--recipe', recipe('helix'), word, word === '--caps' ? 'flat' : 'star'),
      /stand in the recipe/,
    );
  }
  const part = write(folder, 'part.json', { stroke: barStroke.flat() });
  assert.match(fails(2, 'loft', folder.path('bar.png'), '--recipe', part, '--report', part), /replace an input/);
  assert.match(fails(2, 'loft', 'one.png', 'two.png', '--recipe', part), /two\.png/);
});
