// spineloft loft: what it writes, and that it agrees with itself.
import assert from 'node:assert/strict';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import validator from 'gltf-validator';
import {
  bar,
  barFolder,
  barStroke,
  glbJson,
  readJson,
  readObj,
  readPng,
  run,
  sixVolumes,
  stlBounds,
  works,
} from '../support/cli.mjs';

const loft = (folder, ...rest) =>
  works('loft', folder.path('bar.png'), '--stroke', folder.path('stroke.json'), ...rest);

/** Smallest and largest x, y of a mask's set pixels, and how many there are. */
function maskBounds({ width, height, data }) {
  const bounds = { left: width, right: -1, top: height, bottom: -1, count: 0 };
  for (let i = 0; i < width * height; i++) {
    if (data[4 * i] === 0) continue;
    assert.equal(data[4 * i], 255);
    const [x, y] = [i % width, Math.floor(i / width)];
    Object.assign(bounds, { left: Math.min(bounds.left, x), right: Math.max(bounds.right, x) });
    Object.assign(bounds, {
      top: Math.min(bounds.top, y),
      bottom: Math.max(bounds.bottom, y),
      count: bounds.count + 1,
    });
  }
  return bounds;
}

test('help names every option, version the version, both on standard output', () => {
  const help = works('--help').stdout;
  for (const word of [
    '--stroke',
    '--stroke-name',
    '--stroke-ends',
    '--recipe',
    '--section',
    '--caps',
    '--height-mm',
    '--out',
    '--obj-space',
    '--mask',
    '--ribs',
    '--report',
    '.spineloft',
    'open',
    '--document',
    'edges',
    'bench',
    '--json',
    '--jobs',
    '--overlays',
  ]) {
    assert.ok(help.includes(word), word);
  }
  assert.equal(works('loft', '--help').stdout, help);
  assert.match(works('--version').stdout, /^spineloft \d+\.\d+\.\d+\n$/);
});

test('the mask is as large as the picture and covers the bar', (t) => {
  const folder = barFolder(t);
  loft(folder, '--mask', folder.path('mask.png'), '--caps', 'flat');
  const mask = readPng(folder.path('mask.png'));
  assert.deepEqual([mask.width, mask.height], [bar.width, bar.height]);
  const bounds = maskBounds(mask);
  assert.ok(Math.abs(bounds.left - (bar.x - bar.radius)) <= 2, `left ${bounds.left}`);
  assert.ok(Math.abs(bounds.right - (bar.x + bar.radius)) <= 2, `right ${bounds.right}`);
  // The last ribs may lean into the round ends, but hardly beyond them.
  const [first, last] = [barStroke[0][1], barStroke.at(-1)[1]];
  assert.ok(bounds.top <= first + 3 && bounds.top >= bar.top - bar.radius - 15, `top ${bounds.top}`);
  assert.ok(bounds.bottom >= last - 3 && bounds.bottom <= bar.bottom + bar.radius + 15, `bottom ${bounds.bottom}`);
});

test('the ribs stand on the sides of the bar, in picture pixels, with their states', (t) => {
  const folder = barFolder(t);
  loft(folder, '--ribs', folder.path('ribs.json'));
  const { ribs } = readJson(folder.path('ribs.json'));
  assert.ok(ribs.length >= 50);
  let onEdge = 0;
  for (const rib of ribs) {
    assert.deepEqual(Object.keys(rib), ['center', 'left', 'right', 'leftState', 'rightState']);
    if (rib.center[1] < bar.top || rib.center[1] > bar.bottom) continue;
    // Drawn downwards, the stroke's left is the right of the screen.
    assert.ok(Math.abs(rib.left[0] - (bar.x + bar.radius)) < 2, JSON.stringify(rib));
    assert.ok(Math.abs(rib.right[0] - (bar.x - bar.radius)) < 2, JSON.stringify(rib));
    onEdge += (rib.leftState === 'edge') + (rib.rightState === 'edge');
  }
  assert.ok(onEdge > ribs.length, `${onEdge} ends on an edge`);
  for (const { leftState, rightState } of ribs) {
    for (const state of [leftState, rightState]) assert.ok(['edge', 'bridged', 'guessed'].includes(state));
  }
});

test('the report holds sizes, energy, a lawful mesh and the time of each stage', (t) => {
  const folder = barFolder(t);
  const { stdout } = loft(
    folder,
    '--report',
    folder.path('report.json'),
    '--ribs',
    folder.path('ribs.json'),
    '--out',
    folder.path('bar.stl'),
  );
  const report = readJson(folder.path('report.json'));
  assert.deepEqual(report.picture, { width: bar.width, height: bar.height });
  assert.equal(report.ribs, readJson(folder.path('ribs.json')).ribs.length);
  const { distance, neighbour, opposite, prior, total } = report.energy;
  assert.ok(Math.abs(distance + neighbour + opposite + prior - total) < 1e-6 * Math.max(1, total));
  assert.ok(report.mesh.closed && report.mesh.lawful);
  assert.equal(report.mesh.genus, 0);
  assert.equal(report.mesh.triangles, stlBounds(readFileSync(folder.path('bar.stl'))).count);
  assert.equal(report.mesh.triangles, 2 * report.mesh.vertices - 4, 'a sphere in topology');
  // A capsule of radius 40 and 160 px between the centres of its ends.
  const volume = Math.PI * 40 ** 2 * 160 + (4 / 3) * Math.PI * 40 ** 3;
  assert.ok(Math.abs(report.mesh.volume / volume - 1) < 0.12, `${report.mesh.volume} of ${volume}`);
  for (const stage of ['decode', 'edges', 'ribs', 'loft', 'write']) assert.ok(report.milliseconds[stage] >= 0, stage);
  assert.match(stdout, new RegExp(`${report.ribs} ribs, ${report.mesh.triangles} triangles`));
});

test('the GLB passes the Khronos validator without a remark and is as tall as asked, in metres', async (t) => {
  const folder = barFolder(t);
  for (const height of [1, 37.5, 100, 2000]) {
    loft(folder, '--out', folder.path('bar.glb'), '--height-mm', `${height}`);
    const bytes = readFileSync(folder.path('bar.glb'));
    const { issues } = await validator.validateBytes(new Uint8Array(bytes));
    assert.equal(issues.numErrors + issues.numWarnings, 0, JSON.stringify(issues.messages));
    const json = glbJson(bytes);
    const [{ POSITION }] = json.meshes.flatMap((mesh) => mesh.primitives.map((primitive) => primitive.attributes));
    const { min, max } = json.accessors[POSITION];
    assert.ok(Math.abs((max[1] - min[1]) * 1000 - height) < 1e-5 * height, `${(max[1] - min[1]) * 1000} mm`);
    assert.ok(Math.abs(min[1]) < 1e-6 * height, 'stands on the ground');
    assert.equal(json.images.length, 1, 'the picture is on the part');
  }
});

test('the STL is as tall as asked, in millimetres', (t) => {
  const folder = barFolder(t);
  loft(folder, '--out', folder.path('bar.stl'), '--height-mm', '250');
  const { low, high } = stlBounds(readFileSync(folder.path('bar.stl')));
  assert.ok(Math.abs(high[2] - low[2] - 250) < 1e-3, `${high[2] - low[2]}`);
  loft(folder, '--out', folder.path('same.stl'));
  const plain = stlBounds(readFileSync(folder.path('same.stl')));
  assert.ok(Math.abs(plain.high[2] - plain.low[2] - 100) < 1e-3, 'a hundred millimetres unless told');
});

test('an OBJ in picture space fits the mask, and in world space has y up and stands there in millimetres', (t) => {
  const folder = barFolder(t);
  loft(folder, '--out', folder.path('image.obj'), '--obj-space', 'image', '--mask', folder.path('mask.png'));
  loft(folder, '--out', folder.path('world.obj'));
  loft(folder, '--out', folder.path('told.obj'), '--obj-space=world');
  assert.deepEqual(readFileSync(folder.path('told.obj')), readFileSync(folder.path('world.obj')));
  const image = readObj(folder.path('image.obj'));
  const world = readObj(folder.path('world.obj'));
  const range = ({ vertices }, axis) => [
    Math.min(...vertices.map((v) => v[axis])),
    Math.max(...vertices.map((v) => v[axis])),
  ];
  const bounds = maskBounds(readPng(folder.path('mask.png')));
  assert.ok(Math.abs(range(image, 0)[0] - bounds.left) <= 1 && Math.abs(range(image, 0)[1] - bounds.right) <= 1);
  assert.ok(Math.abs(range(image, 1)[0] - bounds.top) <= 1 && Math.abs(range(image, 1)[1] - bounds.bottom) <= 1);
  assert.equal(image.vertices.length, world.vertices.length);
  const [[left, right], [top, bottom], [back, front]] = [0, 1, 2].map((axis) => range(image, axis));
  const scale = 100 / (bottom - top);
  image.vertices.forEach(([x, y, z], i) => {
    const wanted = [(x - (left + right) / 2) * scale, (bottom - y) * scale, (z - (back + front) / 2) * scale];
    wanted.forEach((value, axis) => assert.ok(Math.abs(value - world.vertices[i][axis]) < 1e-3, `vertex ${i}`));
  });
  assert.ok(sixVolumes(world) > 0 && sixVolumes(image) > 0, 'outward in their own axes');
});

test('every section and every cap makes a closed mesh', (t) => {
  const folder = barFolder(t);
  const sections = works('--help')
    .stdout.match(/--section NAME +(.*)/)[1]
    .split(', ');
  assert.equal(sections.length, 12);
  const volumes = new Set();
  for (const section of sections) {
    for (const caps of section === 'circle' ? ['flat', 'round', 'pointed', 'open'] : ['round']) {
      loft(folder, '--section', section, '--caps', caps, '--report', folder.path('report.json'));
      const { mesh } = readJson(folder.path('report.json'));
      assert.ok(mesh.closed && mesh.lawful, `${section} ${caps}`);
      volumes.add(mesh.volume.toPrecision(6));
    }
  }
  assert.ok(volumes.size >= 14, 'they are different shapes');
});

test('a stroke may be a list, points, or one of several by name, the first if none is named', (t) => {
  const folder = barFolder(t);
  const short = barStroke.slice(10, 30);
  writeFileSync(folder.path('points.json'), JSON.stringify({ points: barStroke }));
  writeFileSync(folder.path('spines.json'), JSON.stringify({ id: 'bar', spines: { zebra: barStroke, ape: short } }));
  writeFileSync(folder.path('short.json'), JSON.stringify(short.map(([x, y]) => [x, y, 0.5])));
  const mask = (file, ...rest) => {
    works('loft', folder.path('bar.png'), '--stroke', folder.path(file), '--mask', folder.path('mask.png'), ...rest);
    return readFileSync(folder.path('mask.png'));
  };
  const whole = mask('stroke.json');
  assert.deepEqual(mask('points.json'), whole);
  assert.deepEqual(mask('spines.json'), whole);
  assert.deepEqual(mask('spines.json', '--stroke-name', 'zebra'), whole);
  assert.deepEqual(mask('spines.json', '--stroke-name', 'ape'), mask('short.json'));
  assert.notDeepEqual(mask('short.json'), whole);
});

test('a stroke drawn past both ends of the bar is cut to it, unless it is to be kept', (t) => {
  const folder = barFolder(t);
  const [top, bottom] = [bar.top - bar.radius, bar.bottom + bar.radius];
  writeFileSync(
    folder.path('past.json'),
    JSON.stringify([
      [bar.x, top - 35],
      [bar.x, bottom + 35],
    ]),
  );
  const centres = (...rest) => {
    works(
      'loft',
      folder.path('bar.png'),
      '--stroke',
      folder.path('past.json'),
      '--ribs',
      folder.path('ribs.json'),
      ...rest,
    );
    return readJson(folder.path('ribs.json')).ribs.map((rib) => rib.center[1]);
  };
  for (const cut of [centres(), centres('--stroke-ends', 'cut')]) {
    assert.ok(
      cut[0] > top && cut[0] < bar.top && cut.at(-1) < bottom && cut.at(-1) > bar.bottom,
      `from ${cut[0]} to ${cut.at(-1)}`,
    );
  }
  const kept = centres('--stroke-ends', 'keep');
  assert.ok(
    Math.abs(kept[0] - (top - 35)) < 1 && Math.abs(kept.at(-1) - (bottom + 35)) < 1,
    `from ${kept[0]} to ${kept.at(-1)}`,
  );
  const wrong = run(
    'loft',
    folder.path('bar.png'),
    '--stroke',
    folder.path('past.json'),
    '--stroke-ends',
    'some',
    '--ribs',
    folder.path('ribs.json'),
  );
  assert.equal(wrong.status, 2);
  assert.match(wrong.stderr, /cut, keep/);
});

test('equal input gives equal files', (t) => {
  const folder = barFolder(t);
  const files = ['glb', 'obj', 'stl'].flatMap((format) =>
    ['a', 'b'].map((name) => {
      loft(folder, '--out', folder.path(`${name}.${format}`));
      return readFileSync(folder.path(`${name}.${format}`));
    }),
  );
  for (let i = 0; i < files.length; i += 2) assert.deepEqual(files[i], files[i + 1]);
});

test('edges are as large as the picture and follow the outline of the bar', (t) => {
  const folder = barFolder(t);
  works('edges', folder.path('bar.png'), '--out', folder.path('edges.png'));
  const edges = readPng(folder.path('edges.png'));
  assert.deepEqual([edges.width, edges.height], [bar.width, bar.height]);
  let count = 0;
  for (let i = 0; i < bar.width * bar.height; i++) {
    if (edges.data[4 * i] === 0) continue;
    count++;
    const [x, y] = [i % bar.width, Math.floor(i / bar.width)];
    const away = Math.hypot(x - bar.x, y - Math.min(bar.bottom, Math.max(bar.top, y)));
    assert.ok(Math.abs(away - bar.radius) < 3, `an edge at ${x}, ${y}`);
  }
  assert.ok(count > 2 * (bar.bottom - bar.top) + 4 * bar.radius, `${count} edge pixels`);
});

test('without any output it says what it made', (t) => {
  const folder = barFolder(t);
  assert.match(loft(folder).stdout, /^\d+ ribs, \d+ triangles\n$/);
  assert.deepEqual(folder.list(), ['bar.png', 'stroke.json']);
});

test('an output replaces the file of that name and leaves its neighbours alone', (t) => {
  const folder = barFolder(t);
  writeFileSync(folder.path('bar.stl'), 'old');
  writeFileSync(folder.path('.bar.stl.note'), 'mine');
  loft(folder, '--out', folder.path('bar.stl'));
  assert.ok(statSync(folder.path('bar.stl')).size > 1000);
  assert.deepEqual(folder.list(), ['.bar.stl.note', 'bar.png', 'bar.stl', 'stroke.json']);
  assert.equal(
    run('loft', folder.path('bar.png'), '--stroke', folder.path('stroke.json'), '--out', folder.path('bar.stl')).status,
    0,
  );
});
