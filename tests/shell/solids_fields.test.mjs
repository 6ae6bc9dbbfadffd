// Distances on grids, and surfaces where they change their sign.
import assert from 'node:assert/strict';
import test from 'node:test';
import { library, measure, near, seeded, selfCrossing, shell } from '../browser/support/solids.mjs';

const { DistanceField, gridOver, sample, surfaceWhere } = shell;

test('distances on the grid are those to a ball', () => {
  const ball = library.Manifold.sphere(0.4, 96).getMesh();
  const field = new DistanceField(
    ball.vertProperties,
    ball.triVerts,
    gridOver({ min: [-0.5, -0.5, -0.5], max: [0.5, 0.5, 0.5] }, 0.02),
    1,
  );
  const random = seeded(5);
  for (let i = 0; i < 500; i += 1) {
    const p = [0, 1, 2].map(() => 0.9 * (random() - 0.5)),
      r = Math.hypot(...p);
    if (r > 0.05) assert.ok(Math.abs(field.at(...p) - (r - 0.4)) < 0.003, `${p}: ${field.at(...p)}`);
  }
});

test('distances on a grid are those to the faces, whatever lies beside these without an area', () => {
  const ball = library.Manifold.sphere(0.4, 24).getMesh(),
    grid = gridOver({ min: [-0.5, -0.5, -0.5], max: [0.5, 0.5, 0.5] }, 0.05);
  const { vertProperties: p, triVerts } = ball,
    n = p.length / 3,
    points = [...p],
    triangles = [...triVerts];
  // Along every edge two faces back to back whose third corner is where one end is, or between both ends.
  for (let t = 0; t < triVerts.length; t += 1) {
    const a = triVerts[t],
      b = triVerts[t % 3 === 2 ? t - 2 : t + 1],
      share = t % 2 === 0 ? 0 : 0.5,
      third = n + t;
    for (let k = 0; k < 3; k += 1) points.push(p[3 * a + k] + share * (p[3 * b + k] - p[3 * a + k]));
    triangles.push(a, third, b, a, b, third);
  }
  const plain = new DistanceField(p, triVerts, grid, 1).values,
    crowded = new DistanceField(Float32Array.from(points), Uint32Array.from(triangles), grid, 1).values;
  crowded.forEach((value, i) => assert.ok(Math.abs(value - plain[i]) < 1e-6, `${value} for ${plain[i]}`));
});

test('no line of a grid stays inside a solid that it has left, even one that runs along its edges', () => {
  // Lines run a little beside the points of a grid: here they go through the corners of a box, and along the splits of its faces.
  const grid = { min: [0, -1.37e-4, -2.11e-4], step: 1, size: [16, 12, 12] },
    ys = [2, 5, 6, 9],
    zs = [3, 4, 8],
    points = [],
    triangles = [];
  const at = (...point) => points.push(point) - 1;
  const quad = (a, b, c, d) => triangles.push(a, b, c, a, c, d);
  for (const [x, sign] of [
    [3.1, -1],
    [9.3, 1],
  ]) {
    const rows = zs.map((pz) => ys.map((py) => at(x, py, pz)));
    for (let i = 0; i + 1 < zs.length; i += 1) {
      for (let j = 0; j + 1 < ys.length; j += 1) {
        const four = [rows[i][j], rows[i][j + 1], rows[i + 1][j + 1], rows[i + 1][j]];
        quad(...(sign > 0 ? four : four.toReversed()));
      }
    }
  }
  const side = ys.length * zs.length,
    low = (i, j) => i * ys.length + j,
    high = (i, j) => side + low(i, j),
    lastRow = zs.length - 1,
    lastColumn = ys.length - 1;
  for (let j = 0; j < lastColumn; j += 1) {
    quad(low(0, j), low(0, j + 1), high(0, j + 1), high(0, j));
    quad(high(lastRow, j), high(lastRow, j + 1), low(lastRow, j + 1), low(lastRow, j));
  }
  for (let i = 0; i < lastRow; i += 1) {
    quad(low(i + 1, 0), low(i, 0), high(i, 0), high(i + 1, 0));
    quad(low(i, lastColumn), low(i + 1, lastColumn), high(i + 1, lastColumn), high(i, lastColumn));
  }
  const mesh = { positions: Float32Array.from(points.flat()), triangles: Uint32Array.from(triangles) };
  assert.equal(measure(mesh).open, 0);
  const { values } = new DistanceField(mesh.positions, mesh.triangles, grid, 1);
  let inside = 0;
  values.forEach((value, i) => {
    const [x, py, pz] = [i % 16, Math.floor(i / 16) % 12, Math.floor(i / 192)];
    if (value >= 0) return;
    inside += 1;
    assert.ok(x > 3 && x < 10 && py >= 2 && py <= 9 && pz >= 3 && pz <= 8, `${x} ${py} ${pz} is inside`);
  });
  // Points at its sides may be taken for either.
  assert.ok(inside >= 6 * 6 * 4, `${inside} points are inside`);
});

test('the surface on a grid is closed, outward and does not cross itself, whatever the numbers are', () => {
  for (let seed = 1; seed <= 60; seed += 1) {
    const random = seeded(seed),
      grid = { min: [0, 0, 0], step: 1, size: [7, 6, 8] };
    const surface = surfaceWhere(
        grid,
        sample(grid, () => random() - 0.4),
      ),
      { volume, open } = measure(surface);
    assert.ok(open === 0 && volume > 0, `seed ${seed}: ${open} open edges, volume ${volume}`);
    const edges = new Set(surface.triangles.map((a, i) => a * 10000 + surface.triangles[i % 3 === 2 ? i - 2 : i + 1]));
    assert.equal(edges.size, surface.triangles.length, `seed ${seed}: two faces at every edge`);
    assert.equal(selfCrossing(surface), null, `seed ${seed}`);
  }
  const grid = gridOver({ min: [-0.6, -0.6, -0.6], max: [0.6, 0.6, 0.6] }, 0.03);
  const ball = measure(
    surfaceWhere(
      grid,
      sample(grid, (x, y, z) => 0.5 - Math.hypot(x, y, z)),
    ),
  );
  near(ball.volume, (4 / 3) * Math.PI * 0.5 ** 3, 0.004, 'the volume of a ball');
  assert.equal(ball.euler, 2);
});
