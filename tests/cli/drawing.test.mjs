// spineloft loft --recipe with a bare drawing: seen and hidden lines become solids in the drawn order.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import validator from 'gltf-validator';
import { fails, glbJson, readJson, stlBounds, works, workFolder } from '../support/cli.mjs';

const recipes = fileURLToPath(new URL('../../assets/docs/recipes/', import.meta.url));
const recipe = (name) => join(recipes, `${name}.json`);

function write(folder, json) {
  writeFileSync(folder.path('drawing.json'), JSON.stringify(json));
  return folder.path('drawing.json');
}
function reportOf(folder, file) {
  works('loft', '--recipe', file, '--report', folder.path('report.json'));
  return readJson(folder.path('report.json')).drawing;
}

/** The objects of an OBJ by name, each a list of triangles of points. */
function objects(path) {
  const vertices = [];
  const all = new Map();
  let triangles;
  for (const line of readFileSync(path, 'utf8').split('\n')) {
    const [kind, ...rest] = line.trim().split(/\s+/);
    if (kind === 'o') all.set(rest.join(' '), (triangles = []));
    if (kind === 'v') vertices.push(rest.slice(0, 3).map(Number));
    if (kind === 'f') triangles.push(rest.map((corner) => vertices[parseInt(corner, 10) - 1]));
  }
  return all;
}

const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const boundsOf = (points) =>
  [0, 1].map((k) => [Math.min(...points.map((p) => p[k])), Math.max(...points.map((p) => p[k]))]);

/** Corners of a line in the picture, y up. */
function cornersOf({ points }) {
  const corners = [];
  for (let i = 0; i < points.length; i += 2) corners.push([points[i], -points[i + 1]]);
  return corners;
}

/** From the picture to the file: the rim of a round piece is its outline; flat ones are shifted a little where they lean. */
function toFile(drawing, meshes) {
  const flat = (i) => drawing.pieces !== 'auto' && drawing.pieces[i].kind === 'flat';
  const chosen = [...meshes.keys()].filter((i) => !flat(i));
  const used = chosen.length ? chosen : [...meshes.keys()];
  const from = boundsOf(used.flatMap((i) => cornersOf(drawing.lines[i])));
  const to = boundsOf(used.flatMap((i) => meshes[i].flat()));
  return (p) =>
    p.map((value, k) => to[k][0] + ((value - from[k][0]) / (from[k][1] - from[k][0])) * (to[k][1] - to[k][0]));
}

function holds(polygon, [x, y]) {
  let inside = false;
  for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
    const [[ax, ay], [bx, by]] = [polygon[i], polygon[j]];
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  }
  return inside;
}

/** Where a ray along z enters and leaves a mesh; nothing where it misses it. */
function through(triangles, [x, y]) {
  let hit;
  for (const [a, b, c] of triangles) {
    const whole = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (whole === 0) continue;
    const u = ((b[0] - x) * (c[1] - y) - (b[1] - y) * (c[0] - x)) / whole;
    const v = ((c[0] - x) * (a[1] - y) - (c[1] - y) * (a[0] - x)) / whole;
    if (u < 0 || v < 0 || u + v > 1) continue;
    const z = u * a[2] + v * b[2] + (1 - u - v) * c[2];
    hit = hit ? [Math.max(hit[0], z), Math.min(hit[1], z)] : [z, z];
  }
  return hit;
}

/** The triangles over each of `n` columns between two places. */
function columnsOf(triangles, from, to, n) {
  const columns = Array.from({ length: n }, () => []);
  const column = (x) => Math.min(n, Math.max(-1, Math.floor(((x - from) / (to - from)) * n)));
  for (const triangle of triangles) {
    const xs = triangle.map((p) => p[0]);
    for (let i = Math.max(0, column(Math.min(...xs))); i <= Math.min(n - 1, column(Math.max(...xs))); i++) {
      columns[i].push(triangle);
    }
  }
  return columns;
}

/** Rays over all that two outlines both enclose: how many, and how many in the wrong order. */
function lookAt([over, under], [near, far], map) {
  const n = 60;
  const boxes = [over, under].map(boundsOf);
  const low = [0, 1].map((k) => Math.max(boxes[0][k][0], boxes[1][k][0]));
  const high = [0, 1].map((k) => Math.min(boxes[0][k][1], boxes[1][k][1]));
  const [from, to] = [map(low)[0], map(high)[0]];
  const [nearColumns, farColumns] = [near, far].map((mesh) => columnsOf(mesh, from, to, n));
  let all = 0;
  let wrong = 0;
  for (let i = 0; i < n * n && high[0] > low[0] && high[1] > low[1]; i++) {
    const share = [(i % n) + 0.5, Math.floor(i / n) + 0.5].map((value) => value / n);
    const p = share.map((value, k) => low[k] + (high[k] - low[k]) * value);
    if (!holds(over, p) || !holds(under, p)) continue;
    const [one, other] = [through(nearColumns[i % n], map(p)), through(farColumns[i % n], map(p))];
    if (!one || !other) continue;
    all += 1;
    if (!(one[0] > other[0] && one[1] > other[1])) wrong += 1;
  }
  return { all, wrong };
}

/** Of each recipe: who is drawn in front of whom wherever two pieces overlap, by their places in the list. */
/** By piece: of two that overlap the higher one is in front. */
const kHeights = {
  fish: [3, 2, 1, 5, 1, 5],
  airplane: [3, 5, 1, 1, 5],
  propeller: [5, 2, 2, 2],
  amphora: [3, 4, 1, 1],
  bear: [4, 6, 2, 2, 5, 7, 7, 3, 2, 2],
  kangaroo: [4, 6, 7, 5, 6, 1, 6, 2, 3],
  tree: [10, 9, 8, 7, 12, 5, 3],
  pipes: [3, 4, 2],
  doll: [4, 5, 2, 6, 3, 3],
  // Body, neck, tail, near legs, far legs.
  dinosaur: [3, 5, 2, 6, 6, 1, 0],
};

const kOrders = {
  'bars-in-a-cycle': (a, b) => (a + 1) % 3 === b,
  'woven-mat': (a, b) => a < 4 !== b < 4 && ((Math.min(a, b) + Math.max(a, b)) % 2 === 0) === a < b,
  table: (a) => a === 0,
  chair: (a) => a === 0,
  ...Object.fromEntries(Object.entries(kHeights).map(([name, high]) => [name, (a, b) => high[a] > high[b]])),
};

for (const [name, isOver] of Object.entries(kOrders)) {
  test(`${name}: one lawful solid and one node a piece, in the drawn order at every ray`, async (t) => {
    const folder = workFolder(t);
    const report = reportOf(folder, recipe(name));
    assert.deepEqual([report.contradictions, report.lost, report.openLines], [[], [], []]);
    for (const { mesh, name: piece } of report.pieces) {
      assert.ok(mesh.closed && mesh.lawful && mesh.genus === 0 && mesh.shells === 1 && mesh.volume > 0, piece);
    }
    const names = report.pieces.map((piece) => piece.name);
    for (const { over, under, from, kind } of report.orders) {
      assert.ok(isOver(names.indexOf(over), names.indexOf(under)) && kind === 'over' && from !== 'guessed', over);
    }
    works('loft', '--recipe', recipe(name), '--out', folder.path('model.glb'));
    const glb = readFileSync(folder.path('model.glb'));
    assert.deepEqual(
      glbJson(glb)
        .nodes.filter((node) => 'mesh' in node)
        .map((node) => node.name),
      names,
    );
    const { issues } = await validator.validateBytes(new Uint8Array(glb));
    assert.equal(issues.numErrors + issues.numWarnings, 0, JSON.stringify(issues.messages));
    works('loft', '--recipe', recipe(name), '--out', folder.path('model.obj'));
    const meshes = [...objects(folder.path('model.obj')).values()];
    // Nothing stands farther into the depth than the drawing is large.
    const span = (k) => Math.max(...meshes.flat(2).map((p) => p[k])) - Math.min(...meshes.flat(2).map((p) => p[k]));
    assert.ok(span(2) < Math.max(span(0), span(1)), `${span(2)} deep`);
    const { drawing } = readJson(recipe(name));
    const map = toFile(drawing, meshes);
    const outlines = drawing.lines.map(cornersOf);
    assert.equal(meshes.length, names.length);
    let seen = 0;
    for (let a = 0; a < meshes.length; a++) {
      for (let b = 0; b < meshes.length; b++) {
        if (a === b || !isOver(a, b)) continue;
        const { all, wrong } = lookAt([outlines[a], outlines[b]], [meshes[a], meshes[b]], map);
        assert.equal(wrong, 0, `${names[a]} over ${names[b]}: ${wrong} of ${all} rays`);
        seen += all;
      }
    }
    assert.ok(seen > 60 * report.orders.length, `${seen} rays`);
  });
}

for (const [name, faces] of Object.entries({ cube: 6, house: 7, 'box-of-nine-lines': 6 })) {
  test(`${name}: the lines of its edges are one solid of plane faces with right angles`, (t) => {
    const folder = workFolder(t);
    const report = reportOf(folder, recipe(name));
    assert.deepEqual([report.contradictions, report.lost, report.openLines], [[], [], []]);
    assert.equal(report.pieces.length, 1);
    const [{ kind, outlines, planarity, mesh }] = report.pieces;
    assert.deepEqual([kind, outlines], ['solid', faces]);
    assert.ok(mesh.closed && mesh.lawful && mesh.genus === 0 && mesh.shells === 1 && mesh.volume > 0);
    assert.ok(planarity < 1e-6);
    works('loft', '--recipe', recipe(name), '--out', folder.path('model.obj'));
    const [triangles] = [...objects(folder.path('model.obj')).values()];
    // Normals of the file's triangles: as many as faces, and all but those of the roof at right angles or opposite.
    const normals = [];
    for (const [a, b, c] of triangles) {
      const [p, q] = [b, c].map((corner) => corner.map((x, k) => x - a[k]));
      const n = [0, 1, 2].map((k) => p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3]);
      const unit = n.map((x) => x / Math.hypot(...n));
      if (!normals.some((other) => dot(other, unit) > 0.9999)) normals.push(unit);
    }
    assert.equal(normals.length, faces);
    const isRight = (a, b) => Math.abs(dot(a, b)) < 0.002 || Math.abs(dot(a, b)) > 0.9999;
    const skew = normals.filter((n) => normals.filter((other) => !isRight(n, other)).length > 2);
    assert.equal(skew.length, name === 'house' ? 2 : 0);
  });
}

test('bars in a cycle are flat to a millionth, and the rods of the mat bend by at most 7 %', (t) => {
  const folder = workFolder(t);
  for (const piece of reportOf(folder, recipe('bars-in-a-cycle')).pieces) assert.ok(piece.planarity < 1e-6);
  const mat = reportOf(folder, recipe('woven-mat'));
  for (const piece of mat.pieces) assert.ok(piece.planarity > 0.01 && piece.planarity < 0.07, piece.name);
  assert.equal(mat.nodes.crossing, 64);
});

/** The middle of the sixth of a leg that is farthest along a direction. */
function endOf(triangles, direction) {
  const points = triangles.flat();
  const along = points.map((p) => dot(p, direction));
  const [low, high] = [Math.min(...along), Math.max(...along)];
  const end = points.filter((_, i) => along[i] > high - (high - low) / 6);
  return [0, 1, 2].map((k) => end.reduce((sum, p) => sum + p[k], 0) / end.length);
}
const minus = (a, b) => a.map((value, k) => value - b[k]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((value) => value / Math.hypot(...a));
/** The normal of the largest triangle that is seen. */
function normalOf(triangles) {
  const normals = triangles.map(([a, b, c]) => cross(minus(b, a), minus(c, a))).filter((n) => n[2] > 0);
  return unit(normals.reduce((best, n) => (Math.hypot(...n) > Math.hypot(...best) ? n : best)));
}

for (const name of ['table', 'chair']) {
  test(`${name}: nothing is pinned, and its legs are upright and stand on one floor`, (t) => {
    const folder = workFolder(t);
    const { pins, pieces } = readJson(recipe(name)).drawing;
    assert.equal(pins, undefined);
    works('loft', '--recipe', recipe(name), '--out', folder.path('model.obj'), '--height-mm', '500');
    const meshes = [...objects(folder.path('model.obj')).values()];
    const up = normalOf(meshes[0]);
    const legs = meshes.filter((_, i) => pieces[i].kind === 'round');
    assert.equal(legs.length, 4);
    const feet = legs.map((leg) => endOf(leg, [0, -1, 0]));
    const axes = legs.map((leg, i) => minus(endOf(leg, [0, 1, 0]), feet[i]));
    for (const axis of axes) assert.ok((Math.acos(dot(unit(axis), up)) * 180) / Math.PI < 3);
    const levels = feet.map((foot) => dot(foot, up));
    const height = Math.min(...axes.map((axis) => Math.hypot(...axis)));
    assert.ok(Math.max(...levels) - Math.min(...levels) < 0.06 * height, `${levels} of ${height}`);
  });
}

test('lines alone give the pieces that were meant, in every drawing', (t) => {
  const folder = workFolder(t);
  for (const name of [...Object.keys(kHeights), 'table', 'chair', 'bars-in-a-cycle']) {
    const { drawing } = readJson(recipe(name));
    const pieces =
      drawing.pieces === 'auto' ? undefined : drawing.pieces?.map((piece) => ({ ...piece, kind: 'round' }));
    assert.ok(pieces, name);
    const meant = reportOf(folder, write(folder, { drawing: { ...drawing, pieces } }));
    const found = reportOf(folder, write(folder, { drawing: { ...drawing, pieces: 'auto' } }));
    assert.equal(found.pieces.length, meant.pieces.length, name);
    for (const [i, { mesh }] of meant.pieces.entries()) {
      assert.ok(Math.abs(found.pieces[i].mesh.volume / mesh.volume - 1) < 0.005, `${name}, piece ${i}`);
    }
    assert.deepEqual([found.openLines, found.lost, found.contradictions], [[], [], []], name);
  }
});

test('turtle: head, legs and tail go on behind the shell though only what is seen of them is drawn', (t) => {
  const folder = workFolder(t);
  const report = reportOf(folder, recipe('turtle'));
  assert.deepEqual([report.contradictions, report.lost, report.openLines], [[], [], []]);
  assert.equal(report.pieces.length, 5);
  for (const { mesh } of report.pieces) assert.ok(mesh.lawful && mesh.genus === 0 && mesh.shells === 1);
  const [shell, ...others] = report.pieces.map(({ name }) => name);
  assert.deepEqual(
    report.orders.map(({ over, under, from }) => [over, under, from]),
    others.map((name) => [shell, name, 'drawn']),
  );
});

test('pins win over right angles, and hold in the file', (t) => {
  const folder = workFolder(t);
  const { drawing } = readJson(recipe('table'));
  const pins = [
    { line: 0, at: 0, z: -60 },
    { line: 0, at: 0.3281, z: -260 },
    { line: 0, at: 0.828, z: 90 },
  ];
  const file = write(folder, { drawing: { ...drawing, pins } });
  works('loft', '--recipe', file, '--out', folder.path('table.obj'), '--height-mm', '500');
  const [left, back, front] = pins.map((pin) => pin.z);
  const corners = objects(folder.path('table.obj')).get('Top').flat();
  const at = (k, pick) => corners.reduce((best, p) => (pick(p[k], best[k]) ? p : best));
  const less = (a, b) => a < b;
  const more = (a, b) => a > b;
  // Corners of the top: the leftmost, the highest, the lowest; their depths differ as the pins do.
  const [l, b, f] = [at(0, less), at(1, more), at(1, less)];
  const share = (f[2] - l[2]) / (l[2] - b[2]);
  assert.ok(Math.abs(share / ((front - left) / (left - back)) - 1) < 0.12, share);
});

test('a drawing without pieces gets one for every closed outline, also from strokes', (t) => {
  const folder = workFolder(t);
  const box = { points: [100, 100, 300, 100, 300, 300, 100, 300], closed: true };
  const strokes = [{ points: [400, 100, 600, 100, 600, 300] }, { points: [601, 301, 400, 300, 401, 101] }];
  const file = write(folder, {
    drawing: { size: [700, 400], lines: [box, ...strokes, { points: [20, 20, 60, 350] }] },
  });
  const report = reportOf(folder, file);
  assert.equal(report.pieces.length, 2);
  assert.deepEqual(report.openLines, [3]);
  assert.ok(Math.abs(report.pieces[0].mesh.volume / report.pieces[1].mesh.volume - 1) < 0.02);
  works('loft', '--recipe', file, '--out', folder.path('model.stl'), '--height-mm', '40');
  const { low, high } = stlBounds(readFileSync(folder.path('model.stl')));
  assert.ok(Math.abs(high[2] - low[2] - 40) < 1e-3);
});

test('dashes that join the ends of a line are its hidden part', (t) => {
  const folder = workFolder(t);
  const body = { points: [100, 100, 600, 100, 600, 300, 100, 300], closed: true };
  const leg = { points: [200, 300, 200, 500, 300, 500, 300, 300] };
  const dashes = [200, 230, 260].map((x) => ({ points: [x + 8, 292, x + 28, 291] }));
  const up = { points: [150, 250, 151, 262] };
  const down = { points: [400, 200, 410, 205] };
  const pieces = (lines) => reportOf(folder, write(folder, { drawing: { size: [700, 600], lines } })).pieces;
  assert.equal(pieces([body, leg]).length, 2);
  const { drawing } = readJson(write(folder, { drawing: { size: [700, 600], lines: [body, leg, ...dashes] } }));
  const report = reportOf(folder, write(folder, { drawing }));
  assert.deepEqual([report.openLines, report.contradictions], [[], []]);
  assert.deepEqual(
    report.orders.map(({ over, under, from }) => [over, under, from]),
    [['Piece 1', 'Piece 2', 'drawn']],
  );
  // Strokes this short and in all directions are none.
  assert.deepEqual(
    reportOf(folder, write(folder, { drawing: { ...drawing, lines: [body, leg, up, down] } })).openLines,
    [2, 3],
  );
});

test('what is wrong with a drawing is said with its key', (t) => {
  const folder = workFolder(t);
  const refused = (drawing, what, ...rest) => {
    const file = write(folder, drawing);
    assert.match(fails(3, 'loft', '--recipe', file, '--out', folder.path('x.glb'), ...rest), what);
  };
  const line = { points: [0, 0, 50, 0, 50, 50], closed: true };
  refused({ drawing: { lines: [line] } }, /drawing\.size/);
  refused({ drawing: { size: [99, 99], lines: [{ points: [1, 2, 3] }] } }, /drawing\.lines\[0\]\.points/);
  refused(
    { drawing: { size: [99, 99], lines: [{ ...line, dashed: true }] } },
    /nothing named drawing\.lines\[0\]\.dashed/,
  );
  refused({ drawing: { size: [99, 99], lines: [{ ...line, hidden: [[1]] }] } }, /hidden\[0\] is not \[from, to\]/);
  refused(
    { drawing: { size: [99, 99], lines: [line], pieces: [{ kind: 'cube', outlines: [] }] } },
    /pieces\[0\]\.kind/,
  );
  refused({ drawing: { size: [99, 99], lines: [line], pins: [{ line: -1, z: 3 }] } }, /pins\[0\]\.line/);
  refused({ drawing: { size: [99, 99], lines: [line], seenFrom: 'aside' } }, /seenFrom is none of/);
  refused({ drawing: { size: [99, 99], lines: [line] }, parts: [] }, /nothing named recipe\.parts/);
  refused({ drawing: { size: [99, 99], lines: [] } }, /./);
  refused({ drawing: { size: [99, 99], lines: [line] } }, /needs no picture/, '--mask', folder.path('mask.png'));
  assert.deepEqual(folder.list(), ['drawing.json']);
});
