// The solver of solids without a page: whatever parts it is given, what comes out is closed and outward or says why
// there is none.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { crossingScene } from '../browser/support/crossing_scenes.mjs';
import {
  deepest,
  depthOf,
  diagonal,
  fresh,
  identity,
  lawful,
  library,
  loft,
  measure,
  merged,
  near,
  node,
  rod,
  seeded,
  shell,
  shifted,
  solve,
  turned,
  unsoundByPlace,
} from '../browser/support/solids.mjs';

const { SolidKernel, DistanceField, gridOver, sample, surfaceWhere, Solver, findCrossings, ringsOf } = shell;
test('join, cut and common of two parts hold what sets say', () => {
  const kernel = fresh(),
    meshes = { rod: loft() };
  const alone = measure({ ...meshes.rod, mergeFrom: [], mergeTo: [] }).volume;
  const pair = [rod(1), rod(2, turned(Math.PI / 2, 0.5, -0.5))];
  const [join, cut, common] = ['join', 'cut', 'common'].map(
    (kind) => lawful(solve(kernel, [node(pair, { kind })], meshes), kind).volume,
  );
  near(join, 2 * alone - common, 1e-5, 'join');
  near(cut, alone - common, 1e-5, 'cut');
  // Two round bars of radius r that cross share 16/3 r³ (Steinmetz); ours are 16-gons.
  near(common, (16 / 3) * 0.1 ** 3, 0.06, 'common');
});

test('every face belongs to its part and keeps its place in the picture', () => {
  const { mesh } = solve(fresh(), [node([rod(7), rod(9, shifted(0.4, 0.05))])], { rod: loft() });
  assert.deepEqual([...new Set(mesh.runs.map((run) => run.part))].sort(), [7, 9]);
  for (const { part, first, count } of mesh.runs) {
    for (const v of mesh.triangles.subarray(3 * first, 3 * (first + count))) {
      // u runs along the rod from 0 to 1.
      assert.ok(Math.abs(mesh.uv[2 * v] - (mesh.positions[3 * v] - (part === 9 ? 0.4 : 0))) < 1e-3);
    }
  }
});

test('parts that coincide, touch or lie a hair apart make solids', () => {
  const kernel = fresh(),
    meshes = { rod: loft() };
  const alone = measure({ ...meshes.rod, mergeFrom: [], mergeTo: [] }).volume;
  const volume = (operands, what) => lawful(solve(kernel, [node(operands)], meshes), what).volume;
  near(volume([rod(1), rod(2)], 'the same twice'), alone, 1e-4, 'the same twice');
  near(
    volume(
      Array.from({ length: 50 }, (_, i) => rod(i + 1)),
      'fifty times the same',
    ),
    alone,
    1e-4,
    'fifty times the same',
  );
  near(volume([rod(1), rod(2, shifted(1e-9, -1e-9, 1e-9))], 'a hair apart'), alone, 1e-4, 'a hair apart');
  near(volume([rod(1), rod(2, shifted(0, 0.2))], 'side by side'), 2 * alone, 1e-4, 'side by side');
  near(volume([rod(1), rod(2, shifted(1))], 'end to end'), 2 * alone, 1e-4, 'end to end');
  assert.deepEqual(solve(kernel, [node([rod(1), rod(2)], { kind: 'cut' })]).failure, { error: 'SolidEmpty' });
  assert.deepEqual(solve(kernel, [node([rod(1), rod(2, shifted(0, 5))], { kind: 'common' })]).failure, {
    error: 'SolidEmpty',
  });
});

test('random models of up to twenty parts are solids or empty', () => {
  for (let seed = 1; seed <= 25; seed += 1) {
    const random = seeded(seed),
      kernel = fresh();
    const meshes = Object.fromEntries(
      Array.from({ length: 4 }, (_, i) => [
        `m${i}`,
        loft({
          rings: 5 + Math.floor(20 * random()),
          around: 4 + Math.floor(14 * random()),
          radius: 0.04 + 0.15 * random(),
          bend: 2 * random(),
          wave: 0.3 * random(),
        }),
      ]),
    );
    const nodes = [];
    const operands = Array.from({ length: 2 + Math.floor(19 * random()) }, (_, i) => {
      const near = Math.floor(4 * random()) * 0.1;
      return {
        mesh: `m${Math.floor(4 * random())}`,
        part: i + 1,
        matrix: random() < 0.2 ? shifted(near) : turned(6 * random(), near, random() - 0.5, 0.2 * random()),
      };
    });
    while (operands.length > 1) {
      const taken = operands.splice(0, Math.min(operands.length, 2 + Math.floor(4 * random())));
      nodes.push(
        node(taken, {
          kind: ['join', 'join', 'join', 'cut', 'common'][Math.floor(5 * random())],
          step: nodes.length + 1,
        }),
      );
      operands.push({ node: nodes.at(-1).key });
    }
    const solved = solve(kernel, nodes, meshes);
    if (solved.failure) assert.equal(solved.failure.error, 'SolidEmpty', `seed ${seed}`);
    else {
      const { euler, shells } = lawful(solved, `seed ${seed}`);
      assert.equal(euler, 2 * shells - 2 * solved.mesh.genus, `seed ${seed}: genus`);
      assert.ok(solved.mesh.genus >= 0, `seed ${seed}: genus`);
    }
  }
});

test('a loft that runs through itself is united with itself', () => {
  const loop = loft({ rings: 80, around: 24, length: 3, radius: 0.12, bend: 7 });
  assert.ok(findCrossings(loop.positions, loop.triangles, 1).length > 0);
  assert.equal(ringsOf(loop).size, 24);
  const { mesh } = solve(fresh(), [node([rod(1, identity, 'loop'), rod(2, shifted(0, 4), 'loop')])], { loop });
  const found = lawful({ mesh }, 'the loop');
  // Seven radians of a ring: a whole turn of the torus, whatever is passed twice.
  near(found.volume / 2, 2 * Math.PI * (3 / 7) * Math.PI * 0.12 ** 2, 0.04, 'volume');
});

test('a bend tighter than the part is thick becomes a solid', () => {
  const sharp = loft({ rings: 24, around: 16, length: 0.2, radius: 0.15, bend: 3 });
  assert.ok(findCrossings(sharp.positions, sharp.triangles, 1).length > 0);
  const { shells, euler } = lawful(
    solve(fresh(), [node([rod(1, identity, 'sharp'), rod(2, shifted(2), 'sharp')])], { sharp }),
    'the bend',
  );
  assert.deepEqual([shells, euler], [2, 4], 'two pieces, without splinters and voids');
  const { mesh } = solve(fresh(), [node([rod(1, identity, 'sharp')])], { sharp });
  assert.equal(mesh.mergeFrom.length, 0, 'no seam in its picture');
  assert.ok(mesh.triangles.length < 8 * sharp.triangles.length, 'few triangles where it crosses itself');
});

test('random lofts, bent and pulled out of shape, become solids or name the part and the place', () => {
  const told = { solid: 0, fault: 0 };
  for (let seed = 1; seed <= 40; seed += 1) {
    const random = seeded(seed),
      part = 1 + (seed % 5);
    const wild = loft({
      rings: 6 + Math.floor(30 * random()),
      around: 6 + Math.floor(16 * random()),
      length: 0.2 + random(),
      radius: 0.05 + 0.25 * random(),
      bend: 16 * (random() - 0.5),
      wave: 0.6 * random(),
    });
    if (random() < 0.5) {
      // A hand pulls ribs somewhere else.
      const n = wild.positions.length / 3,
        from = Math.floor(random() * n);
      for (let i = 3 * from; i < 3 * Math.min(n, from + 12); i += 1) wild.positions[i] += 0.15 * (random() - 0.5);
    }
    const solved = solve(fresh(), [node([rod(part, identity, 'wild'), rod(9, shifted(4), 'rod')])], {
      wild,
      rod: loft(),
    });
    if (solved.failure) {
      assert.deepEqual([solved.failure.error, solved.failure.part], ['PartCrossesItself', part], `seed ${seed}`);
      assert.ok(solved.failure.at.every(Number.isFinite), `seed ${seed}`);
      told.fault += 1;
    } else {
      lawful(solved, `seed ${seed}`);
      told.solid += 1;
    }
  }
  assert.ok(told.solid >= 35, `${told.solid} of 40 are solids`);
});

test('of 170 lofts that cross themselves in every way each is a solid that does not, or names the part and the place', () => {
  const told = { solid: 0, fault: 0 };
  for (let seed = 1; told.solid + told.fault < 170; seed += 1) {
    const random = seeded(7919 * seed),
      hard = random() < 0.3;
    const wild = loft({
      rings: 6 + Math.floor(18 * random()),
      around: 6 + Math.floor(8 * random()),
      length: 0.2 + random(),
      radius: 0.05 + 0.25 * random(),
      bend: (hard ? 30 : 16) * (random() - 0.5),
      wave: (hard ? 1.5 : 0.6) * random(),
    });
    for (let pulls = Math.floor((hard ? 6 : 2) * random()); pulls > 0; pulls -= 1) {
      const n = wild.positions.length,
        from = Math.floor(n * random()),
        to = from + 3 * Math.floor(12 * random());
      for (let i = from; i < Math.min(n, to); i += 1) wild.positions[i] += (hard ? 0.4 : 0.15) * (random() - 0.5);
    }
    const crossings = findCrossings(wild.positions, wild.triangles);
    if (crossings.length === 0) continue;
    const solved = solve(fresh(), [node([rod(1, identity, 'wild')], { kind: 'join' })], { wild });
    if (solved.failure) {
      assert.deepEqual([solved.failure.error, solved.failure.part], ['PartCrossesItself', 1], `seed ${seed}`);
      // It is shown where a crossing is.
      const away = Math.min(
        ...crossings.map(({ a, b }) =>
          Math.hypot(
            ...[0, 1, 2].map(
              (k) =>
                solved.failure.at[k] -
                [a, b].reduce(
                  (sum, t) =>
                    sum + [0, 1, 2].reduce((all, c) => all + wild.positions[3 * wild.triangles[3 * t + c] + k], 0),
                  0,
                ) /
                  6,
            ),
          ),
        ),
      );
      assert.ok(away < 1e-6, `seed ${seed}: shown ${away} away from every crossing`);
      told.fault += 1;
    } else {
      const { positions } = solved.mesh;
      lawful(solved, `seed ${seed}`);
      const depth = deepest(positions, merged(solved.mesh, positions.length / 3)) / diagonal(positions);
      assert.ok(depth < 1e-6, `seed ${seed}: triangles ${depth} of the size deep in one another`);
      told.solid += 1;
    }
  }
  assert.ok(told.solid >= 110, `${told.solid} are solids, ${told.fault} are told of`);
});

test('triangles cross exactly when no short shift takes them apart', () => {
  const random = seeded(77),
    told = { deep: 0, apart: 0 };
  const point = () => [random(), random(), random()];
  for (let i = 0; i < 3000; i += 1) {
    const one = [point(), point(), point()],
      other = [point(), point(), point()];
    // Some share a corner, some lie in one plane, some stand on the other by a hair.
    if (i % 4 === 1) other[0] = one[0];
    if (i % 4 === 2) for (const p of [...one, ...other]) p[2] = 0.25;
    if (i % 4 === 3)
      [one[0], one[1], one[2], other[0]] = [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
        [0.3, 0.3, -2e-3 * random()],
      ];
    const positions = Float32Array.from([...one, ...other].flat()),
      shares = i % 4 === 1;
    if (i % 4 === 3) for (let v = 4; v < 6; v += 1) positions[3 * v + 2] += 0.1;
    const at = (v) => [...positions.subarray(3 * v, 3 * v + 3)];
    const depth = depthOf([0, 1, 2].map(at), [3, 4, 5].map(at)),
      touch = 1e-3;
    if (Math.abs(depth - touch) < 1e-6) continue;
    const found = findCrossings(positions, Uint32Array.of(0, 1, 2, shares ? 0 : 3, 4, 5), 1, touch).length;
    assert.equal(found, depth > touch ? 1 : 0, `pair ${i}: ${depth} deep`);
    told[depth > touch ? 'deep' : 'apart'] += 1;
  }
  assert.ok(told.deep > 300 && told.apart > 300, JSON.stringify(told));
});

test('the solver and the engine give the same answers, which are those of trying every pair', () => {
  const verdicts = readFileSync(new URL('../golden/crossing_verdicts.txt', import.meta.url), 'utf8').replaceAll(
    '\n',
    '',
  );
  assert.equal(verdicts.length, 240);
  [...verdicts].forEach((verdict, i) => {
    const { positions, triangles } = crossingScene(i),
      depth = deepest(positions, triangles) / diagonal(positions);
    // Of what is just as deep as rounding either may be said.
    const isSure = depth < 0.4e-6 || depth > 2.5e-6;
    assert.equal(verdict, isSure ? String(+(depth > 1e-6)) : '?', `${i}`);
    if (isSure) assert.equal(findCrossings(positions, triangles, 1).length, +verdict, `${i}`);
  });
});

test('a mesh that crosses itself and is no loft names the part and the place', () => {
  const a = loft(),
    b = loft();
  const n = a.positions.length / 3;
  const both = {
    positions: Float32Array.from([
      ...a.positions,
      ...b.positions.map((x, i) => (i % 3 === 0 ? 0.05 + x * 0.9 : x * 1.2)),
    ]),
    uv: new Float32Array([...a.uv, ...b.uv]),
    triangles: Uint32Array.from([...a.triangles, ...b.triangles.map((v) => v + n)]),
  };
  const { failure } = solve(fresh(), [node([rod(3, shifted(10), 'both'), rod(4, identity, 'rod')])], { both, rod: a });
  assert.equal(failure.error, 'PartCrossesItself');
  assert.equal(failure.part, 3);
  assert.ok(failure.at[0] >= 10 && failure.at[0] <= 11);
});

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
  assert.equal(measure({ ...mesh, mergeFrom: [], mergeTo: [] }).open, 0);
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
      { volume, open } = measure({ ...surface, mergeFrom: [], mergeTo: [] });
    assert.ok(open === 0 && volume > 0, `seed ${seed}: ${open} open edges, volume ${volume}`);
    const edges = new Set(surface.triangles.map((a, i) => a * 10000 + surface.triangles[i % 3 === 2 ? i - 2 : i + 1]));
    assert.equal(edges.size, surface.triangles.length, `seed ${seed}: two faces at every edge`);
    assert.deepEqual(findCrossings(surface.positions, surface.triangles, 1), [], `seed ${seed}`);
  }
  const grid = gridOver({ min: [-0.6, -0.6, -0.6], max: [0.6, 0.6, 0.6] }, 0.03);
  const ball = measure({
    ...surfaceWhere(
      grid,
      sample(grid, (x, y, z) => 0.5 - Math.hypot(x, y, z)),
    ),
    mergeFrom: [],
    mergeTo: [],
  });
  near(ball.volume, (4 / 3) * Math.PI * 0.5 ** 3, 0.004, 'the volume of a ball');
  assert.equal(ball.euler, 2);
});

test('crossings are found whatever the order of the triangles, and only where they are', () => {
  const random = seeded(3),
    rod = loft(),
    n = rod.positions.length / 3;
  const through = loft({ length: 0.6, radius: 0.04 });
  const both = {
    positions: new Float32Array([
      ...rod.positions,
      ...through.positions.map((_, i) =>
        i % 3 === 0
          ? through.positions[i + 1] + 0.5
          : i % 3 === 1
            ? through.positions[i - 1] - 0.3
            : through.positions[i],
      ),
    ]),
    triangles: [...rod.triangles, ...through.triangles.map((v) => v + n)],
  };
  const sorted = findCrossings(both.positions, Uint32Array.from(both.triangles)).length;
  const order = Array.from({ length: both.triangles.length / 3 }, (_, i) => [random(), i]).sort((a, b) => a[0] - b[0]);
  const shuffled = Uint32Array.from(order.flatMap(([, t]) => both.triangles.slice(3 * t, 3 * t + 3)));
  // The thin bar goes in and out: two rings of crossings, each as long as the bar is round.
  assert.ok(sorted >= 32, `${sorted} crossings`);
  assert.equal(findCrossings(both.positions, shuffled).length, sorted);
  assert.equal(findCrossings(rod.positions, rod.triangles).length, 0);
});

test('a hollow is as thick as its wall, open where it should be', () => {
  const kernel = fresh(),
    meshes = { rod: loft({ rings: 40, around: 48, radius: 0.25 }) };
  const outer = measure({ ...meshes.rod, mergeFrom: [], mergeTo: [] }).volume;
  const closed = lawful(solve(kernel, [node([rod(1)], { kind: 'hollow', wall: 0.05 })], meshes), 'closed').volume;
  const open = lawful(
    solve(kernel, [node([rod(1)], { kind: 'hollow', wall: 0.05, opening: [1, 0, 0] })], meshes),
    'open',
  ).volume;
  near(outer - closed, Math.PI * 0.2 ** 2 * 0.9, 0.03, 'what is scooped out of the closed one');
  near(outer - open, Math.PI * 0.2 ** 2 * 0.95, 0.03, 'what is scooped out of the open one');
  const half = solve(kernel, [node([rod(1)], { kind: 'hollow', wall: 0.05, opening: [1, 0, 0], cut: 0.5 })], meshes);
  near(lawful(half, 'cut off').volume, outer / 2 - Math.PI * 0.2 ** 2 * 0.45, 0.04, 'what is left of half of it');
  assert.ok(half.mesh.positions.every((x, i) => i % 3 !== 0 || x < 0.5 + 1e-5));
  const thick = solve(kernel, [node([rod(1)], { kind: 'hollow', wall: 0.3 })], meshes).failure;
  assert.deepEqual([thick.error, thick.part], ['WallTooThick', 1]);
  assert.ok(Math.hypot(thick.at[1], thick.at[2]) < 0.05, 'it is shown on the middle line, where the most room is');
  for (const opening of [null, [1, 0, 0], [0, 1, 0]]) {
    const hollow = (wall) => solve(kernel, [node([rod(1)], { kind: 'hollow', wall, opening })], meshes);
    const { thickest } = hollow(0.3).failure;
    assert.ok(thickest > 0.2 && thickest < 0.25, `${thickest} of a rod whose radius is 0.25`);
    lawful(hollow(thickest), 'with the wall that is said to fit');
  }
});

test('a flat lid that leans a little opens as a whole, a dome as far as it was asked to', () => {
  const meshes = { rod: loft({ rings: 40, around: 48, radius: 0.25 }) };
  const outer = measure({ ...meshes.rod, mergeFrom: [], mergeTo: [] }).volume;
  const scooped = (angle) =>
    outer -
    lawful(
      solve(fresh(), [node([rod(1, turned(angle))], { kind: 'hollow', wall: 0.04, opening: [1, 0, 0] })], meshes),
      'leaning',
    ).volume;
  const straight = scooped(0);
  near(straight, Math.PI * 0.21 ** 2 * 0.96, 0.03, 'what is scooped out of a straight one');
  for (const angle of [-0.2, 0.1, 0.3]) near(scooped(angle), straight, 0.03, `leaning by ${angle}`);
});

test('a mug: body, handle and hollow inside', () => {
  const meshes = {
    body: loft({ rings: 30, around: 40, radius: 0.3 }),
    handle: loft({ rings: 40, around: 12, length: 0.9, radius: 0.05, bend: 3.2 }),
  };
  const hollow = node([{ mesh: 'body', part: 1, matrix: identity }], {
    kind: 'hollow',
    wall: 0.04,
    opening: [1, 0, 0],
  });
  const mug = node(
    [{ node: hollow.key }, { mesh: 'handle', part: 2, matrix: [0, 1, 0, 0, 1, 0, 0, 0, 0, 0, -1, 0, 0.2, 0.28, 0, 1] }],
    { step: 2 },
  );
  const solved = solve(fresh(), [hollow, mug], meshes);
  lawful(solved, 'the mug');
  assert.equal(solved.mesh.genus, 1, 'one handle');
});

test('a scooped out mug is a solid for programs that join corners by place, in every mug of a row', () => {
  const random = seeded(5),
    between = (low, high) => low + (high - low) * random();
  for (let i = 0; i < 10; i += 1) {
    const meshes = {
      body: loft({ rings: 48, around: 64, radius: between(0.4, 0.5), wave: between(0, 0.1) }),
      handle: loft({ rings: 64, around: 32, length: 1.1, radius: between(0.04, 0.09), bend: between(3.4, 4.4) }),
    };
    const hollow = node([rod(1, identity, 'body')], { kind: 'hollow', wall: between(0.03, 0.06), opening: [1, 0, 0] });
    const handle = rod(2, turned(between(-0.3, -0.1), 0.2, between(0.35, 0.4), between(0, 0.01)), 'handle');
    const solved = solve(fresh(), [hollow, node([{ node: hollow.key }, handle], { step: 2 })], meshes);
    lawful(solved, `mug ${i}`);
    assert.equal(unsoundByPlace(solved.mesh), 0, `mug ${i}`);
  }
});

test('what is stuck to a hollow thing does not stand into its inside, however deep it is nested', () => {
  const meshes = {
    body: loft({ rings: 30, around: 40, radius: 0.3 }),
    bar: loft({ rings: 10, around: 12, length: 1.2, radius: 0.05 }),
  };
  const kernel = fresh();
  const hollow = node([{ mesh: 'body', part: 1, matrix: identity }], {
    kind: 'hollow',
    wall: 0.04,
    opening: [1, 0, 0],
  });
  const empty = lawful(solve(kernel, [hollow], meshes), 'the cup').volume;
  // A bar right through, square to the cup: what stands out of it on both sides is all that it adds.
  const bar = { mesh: 'bar', part: 2, matrix: turned(Math.PI / 2, 0.4, -0.6) };
  const inner = node([{ node: hollow.key }, bar], { step: 2 });
  const once = lawful(solve(kernel, [hollow, inner], meshes), 'a bar through it').volume;
  near(once - empty, Math.PI * 0.05 ** 2 * 0.6, 0.1, 'what the bar adds');
  const second = { mesh: 'bar', part: 3, matrix: turned(Math.PI / 2, 0.7, -0.6) };
  const twice = lawful(
    solve(kernel, [hollow, inner, node([{ node: inner.key }, second], { step: 3 })], meshes),
    'two bars',
  ).volume;
  near(twice - once, once - empty, 0.03, 'the second bar adds as much');
});

test('scooping out a body with its handle leaves no void in the handle that nothing could run out of', () => {
  const meshes = {
    body: loft({ rings: 30, around: 40, radius: 0.3 }),
    handle: loft({ rings: 60, around: 16, length: 0.9, radius: 0.07, bend: 3.2 }),
  };
  const both = node([
    { mesh: 'body', part: 1, matrix: identity },
    { mesh: 'handle', part: 2, matrix: [0, 1, 0, 0, 1, 0, 0, 0, 0, 0, -1, 0, 0.2, 0.28, 0, 1] },
  ]);
  const mug = (opening) =>
    solve(fresh(), [both, node([{ node: both.key }], { step: 2, kind: 'hollow', wall: 0.05, opening })], meshes);
  const open = lawful(mug([1, 0, 0]), 'the mug');
  assert.equal(open.shells, 1);
  assert.equal(open.euler, 0, 'one handle');
  assert.ok(lawful(mug(null), 'closed').shells > 1, 'a closed hollow keeps all of its inside');
});

test('a handle stays solid when its mug is scooped out, however thick it is', () => {
  for (const radius of [0.05, 0.08, 0.1, 0.12, 0.14]) {
    const meshes = {
      body: loft({ rings: 30, around: 40, radius: 0.3 }),
      handle: loft({ rings: 60, around: 20, length: 1.1, radius, bend: 3.2 }),
    };
    const both = node([
      rod(1, identity, 'body'),
      rod(2, [0, 1, 0, 0, 1, 0, 0, 0, 0, 0, -1, 0, 0.15, 0.28, 0, 1], 'handle'),
    ]);
    const wall = 0.04,
      kernel = fresh(),
      whole = lawful(solve(kernel, [both], meshes), 'body and handle').volume;
    const mug = solve(kernel, [
      both,
      node([{ node: both.key }], { step: 2, kind: 'hollow', wall, opening: [1, 0, 0] }),
    ]);
    const { volume, shells, euler } = lawful(mug, `radius ${radius}`);
    assert.deepEqual([shells, euler], [1, 0], `radius ${radius}: one handle`);
    // All of the body's inside is scooped out, and at most a stub of the handle's.
    near(whole - volume, Math.PI * (0.3 - wall) ** 2 * (1 - wall), 0.06, `radius ${radius}: what is scooped out`);
  }
});

test('a rounded seam adds a little at a join, takes a little at a cut, and stays a solid', () => {
  const kernel = fresh(),
    meshes = { rod: loft({ rings: 30, around: 32 }) };
  const pair = [rod(1), rod(2, turned(Math.PI / 2, 0.5, 0))];
  for (const kind of ['join', 'cut']) {
    const sharp = lawful(solve(kernel, [node(pair, { kind })], meshes), kind).volume;
    const soft = lawful(solve(kernel, [node(pair, { kind, blend: 0.06 })], meshes), `${kind}, rounded`).volume;
    const change = (soft - sharp) * (kind === 'join' ? 1 : -1);
    assert.ok(change > 1e-5 && change < 0.003, `${kind}: ${change}`);
    // The rounding looks as the part that it is nearer to: no face of one part lies on the other's side.
    const { mesh } = solve(kernel, [node(pair, { kind, blend: 0.06 })], meshes);
    const axes = { 1: (x, y, z) => Math.hypot(y, z), 2: (x, y, z) => Math.hypot(x - 0.5, z) };
    for (const { part, first, count } of mesh.runs) {
      for (const v of mesh.triangles.subarray(3 * first, 3 * (first + count))) {
        const [own, other] = [part, 3 - part].map((which) =>
          Math.abs(axes[which](...mesh.positions.subarray(3 * v, 3 * v + 3)) - 0.1),
        );
        assert.ok(
          own < other + 0.02,
          `${kind}: a corner of part ${part} is ${own} from it, and ${other} from the other`,
        );
      }
    }
  }
});

test('an edited part of many gives the solid that all of it anew gives', () => {
  const meshes = { rod: loft() },
    one = fresh();
  const operands = Array.from({ length: 6 }, (_, i) => rod(i + 1, turned(i, 0.1 * i)));
  solve(one, [node(operands)], meshes);
  for (let i = 1; i <= 4; i += 1) {
    operands[2] = rod(3, turned(2 + 0.1 * i, 0.2));
    const again = lawful(solve(one, [node(operands)], meshes), `edit ${i}`).volume;
    near(again, lawful(solve(fresh(), [node(operands)], meshes), 'anew').volume, 1e-5, `edit ${i}`);
  }
});

test('edits of any part in any order give what all of it anew gives, for every kind', () => {
  const random = seeded(8),
    meshes = { rod: loft({ rings: 12, around: 12 }) };
  for (const kind of ['join', 'cut', 'common']) {
    const one = fresh(),
      place = () => turned(3 * random(), 0.15 * random(), 0.15 * random(), 0.05 * random());
    const operands = Array.from({ length: kind === 'join' ? 9 : 4 }, (_, i) => rod(i + 1, place()));
    solve(one, [node(operands, { kind })], meshes);
    for (let i = 0; i < 16; i += 1) {
      const edited = i % 3 === 2 ? Math.floor(operands.length * random()) : i < 8 ? 0 : operands.length - 1;
      operands[edited] = rod(edited + 1, place());
      const coarse = random() < 0.3,
        request = node(operands, { kind, coarse });
      const again = solve(one, [request], meshes),
        anew = solve(fresh(), [node(operands, { kind })], meshes);
      assert.deepEqual(again.failure, anew.failure, `${kind}, edit ${i}`);
      if (!again.failure)
        near(lawful(again, `${kind}, edit ${i}`).volume, anew.mesh.volume, 1e-5, `${kind}, edit ${i}`);
    }
  }
});

test('what is made ahead for an edit, or half of it, changes no solid, and what nobody needs is let go', () => {
  const random = seeded(31),
    meshes = { rod: loft({ rings: 12, around: 12 }) };
  const place = () => turned(3 * random(), 0.15 * random(), 0.15 * random(), 0.05 * random());
  for (const kind of ['join', 'cut', 'common']) {
    const one = fresh(),
      operands = Array.from({ length: kind === 'join' ? 9 : 5 }, (_, i) => rod(i + 1, place()));
    const inner = node(operands.slice(0, 4), { step: 1 }),
      model = () => [inner, node([{ node: inner.key }, ...operands.slice(4)], { kind, step: 2 })];
    solve(one, model(), meshes);
    const size = one.solids.size;
    // As when one part after the other is chosen, and none is edited.
    for (let part = 1; part <= operands.length; part += 1) for (const work = one.ahead(part); !work.next().done;);
    for (const work = one.ahead(null); !work.next().done;);
    assert.equal(one.solids.size, size, `${kind}: nothing is left of it`);
    for (let i = 0; i < 12; i += 1) {
      const chosen = 4 + Math.floor((operands.length - 4) * random()),
        edited = random() < 0.8 ? chosen : operands.length - 1;
      const work = one.ahead(chosen + 1);
      for (let steps = Math.floor(8 * random()); steps > 0 && !work.next().done; steps -= 1);
      work.return();
      operands[edited] = rod(edited + 1, place());
      const nodes = model(),
        again = solve(one, nodes, meshes),
        anew = solve(fresh(), nodes, meshes);
      assert.deepEqual(again.failure, anew.failure, `${kind}, edit ${i}`);
      if (!again.failure)
        near(lawful(again, `${kind}, edit ${i}`).volume, anew.mesh.volume, 1e-5, `${kind}, edit ${i}`);
    }
  }
});

test('a hundred requests given up half-way, at any moment, leave the solver as sound as a fresh one', () => {
  const random = seeded(21),
    kernel = fresh(),
    meshes = { rod: loft({ rings: 14, around: 12 }), body: loft({ rings: 20, around: 24, radius: 0.25 }) };
  const place = () => turned(3 * random(), 0.15 * random(), 0.15 * random(), 0.05 * random());
  const operands = Array.from({ length: 7 }, (_, i) => rod(i + 1, place()));
  const model = (coarse) => {
    const hollow = node([rod(9, identity, 'body')], {
      kind: 'hollow',
      wall: random() < 0.5 ? 0.05 : 0.07,
      step: 3,
      coarse,
    });
    const first = node(operands.slice(0, 4), { step: 1, coarse }),
      second = node([{ node: first.key }, ...operands.slice(4)], {
        kind: random() < 0.5 ? 'join' : 'cut',
        step: 2,
        coarse,
      });
    return [hollow, first, second, node([{ node: hollow.key }, { node: second.key }], { step: 4, coarse })];
  };
  for (let i = 0; i < 100; i += 1) {
    const edited = Math.floor(operands.length * random());
    operands[edited] = rod(edited + 1, place());
    const nodes = model(random() < 0.4);
    const work = kernel.solve({ id: i, nodes, wanted: [nodes.at(-1).key], meshes: i === 0 ? meshes : {} }, () => {});
    for (let steps = Math.floor((nodes.length + 1) * random()); steps > 0; steps -= 1) work.next();
    work.return();
    kernel.keepMeshes(meshes);
  }
  const nodes = model(false),
    after = solve(kernel, nodes);
  near(lawful(after, 'after a hundred').volume, lawful(solve(fresh(), nodes, meshes), 'afresh').volume, 1e-5, 'volume');
});

test('a step that the library refuses names the part that it fails with, and where that is', () => {
  /** Refuses unions of three and more, and every mesh without a source. */
  const { Manifold } = library,
    refuse = () => {
      throw new Error('refused');
    };
  const fussy = (overrides) =>
    new SolidKernel({ ...library, Manifold: Object.assign(Object.create(Manifold), overrides) });
  const meshes = { rod: loft() },
    parts = [rod(7), rod(8, shifted(0, 0.05)), rod(9, shifted(0, 3))];
  const { failure } = solve(
    fussy({ union: (solids) => (solids.length > 2 ? refuse() : Manifold.union(solids)) }),
    [node(parts)],
    meshes,
  );
  assert.deepEqual([failure.error, failure.part, Math.round(failure.at[1])], ['SolidFailed', 9, 3]);
  const hollow = solve(
    fussy({ ofMesh: (mesh) => (mesh.numTri > 1000 ? refuse() : Manifold.ofMesh(mesh)) }),
    [node([rod(7)], { kind: 'hollow' })],
    meshes,
  );
  assert.deepEqual([hollow.failure.error, hollow.failure.part], ['SolidFailed', 7]);
});

test('a library that breaks down is not asked again: its worker ends', () => {
  const broken = Object.create(library, {
    Manifold: {
      value: Object.create(library.Manifold, {
        union: {
          value: () => {
            throw new WebAssembly.RuntimeError('memory access out of bounds');
          },
        },
      }),
    },
  });
  assert.throws(
    () => solve(new SolidKernel(broken), [node([rod(1), rod(2, shifted(0.4))])], { rod: loft() }),
    WebAssembly.RuntimeError,
  );
});

/** A worker that answers when it is told to. */
class FakeWorker {
  asked = [];
  ended = false;
  postMessage(message) {
    this.asked.push(message);
  }
  terminate() {
    this.ended = true;
  }
}
const memory = (workers, answers) => ({
  start: () => {
    workers.push(new FakeWorker());
    return workers.at(-1);
  },
  floats: (at, count) => new Float32Array(count).fill(at),
  integers: (at, count) => new Uint32Array(count).fill(at),
  answer: (json, bytes) => answers.push({ ...JSON.parse(json), bytes }),
});
/** What a worker was asked to solve. */
const requestsOf = ({ asked }) => asked.filter(({ meshes }) => meshes);
const solveEvent = (id, key = 'a') => ({
  type: 'solve',
  id,
  meshes: [{ key, vertices: 4, triangles: 4, positions: 8, uv: 0, corners: 16 }],
  nodes: [],
  wanted: [],
});

test('meshes go to the worker once, and again after it was stopped', () => {
  const workers = [],
    solver = new Solver(memory(workers, []));
  solver.ask(solveEvent(1));
  solver.ask(solveEvent(2));
  assert.deepEqual(
    requestsOf(workers[0]).map((each) => Object.keys(each.meshes)),
    [['a'], []],
  );
  solver.stop();
  assert.ok(workers[0].ended && !solver.isBusy);
  solver.ask(solveEvent(3));
  assert.deepEqual(Object.keys(requestsOf(workers[1])[0].meshes), ['a']);
});

test('a worker hears which part is chosen before it is asked, and again when another one is', () => {
  const workers = [],
    solver = new Solver(memory(workers, []));
  solver.expect(3);
  assert.equal(workers.length, 0, 'choosing a part starts no worker');
  solver.ask(solveEvent(1));
  solver.expect(4);
  assert.deepEqual(
    workers[0].asked.map(({ id, expect }) => id ?? expect),
    [3, 1, 4],
  );
  solver.stop();
  solver.ask(solveEvent(2));
  assert.deepEqual(
    workers[1].asked.map(({ id, expect }) => id ?? expect),
    [4, 2],
  );
});

test('a worker that dies is said and started anew; a hundred cancels leave nothing behind', () => {
  const workers = [],
    answers = [],
    solver = new Solver(memory(workers, answers));
  solver.ask(solveEvent(1));
  workers[0].onerror({});
  assert.deepEqual(
    answers.map(({ id, lost }) => [id, lost]),
    [[1, true]],
  );
  for (let id = 2; id < 102; id += 1) {
    solver.ask(solveEvent(id));
    const worker = workers.at(-1);
    solver.stop();
    worker.onmessage?.({ data: { type: 'done', id } });
  }
  assert.equal(answers.length, 1);
  assert.ok(workers.slice(0, -1).every((worker) => worker.ended));
  solver.ask(solveEvent(200));
  workers.at(-1).onmessage({ data: { type: 'done', id: 200 } });
  assert.deepEqual(answers.at(-1).done, true);
});
