// Parts that go through themselves: the test for that is exact, and they become solids that do not, or are named.
import assert from 'node:assert/strict';
import test from 'node:test';
import { readFileSync } from 'node:fs';
import { crossingScene } from '../browser/support/crossing_scenes.mjs';
import {
  crossingPairs,
  deepest,
  depthOf,
  diagonal,
  fresh,
  identity,
  lawful,
  loft,
  merged,
  near,
  node,
  rod,
  seeded,
  selfCrossing,
  shell,
  shifted,
  solve,
} from '../browser/support/solids.mjs';

const { ringsOf } = shell;

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
    // A third one far away: what is less deep than a millionth of the size only touches, which is a thousandth then.
    const positions = Float32Array.from([...one, ...other, [1000, 0, 0], [1000, 1, 0], [1000, 0, 1]].flat()),
      shares = i % 4 === 1;
    if (i % 4 === 3) for (let v = 4; v < 6; v += 1) positions[3 * v + 2] += 0.1;
    const at = (v) => [...positions.subarray(3 * v, 3 * v + 3)];
    const depth = depthOf([0, 1, 2].map(at), [3, 4, 5].map(at)),
      touch = 1e-6 * diagonal(positions);
    if (Math.abs(depth - touch) < 1e-6) continue;
    const found = selfCrossing({ positions, triangles: Uint32Array.of(0, 1, 2, shares ? 0 : 3, 4, 5, 6, 7, 8) });
    assert.equal(found !== null, depth > touch, `pair ${i}: ${depth} deep`);
    told[depth > touch ? 'deep' : 'apart'] += 1;
  }
  assert.ok(told.deep > 300 && told.apart > 300, JSON.stringify(told));
});

test('the answers that the engine is held to, too, are those of trying every pair', () => {
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
    if (isSure) assert.equal(selfCrossing({ positions, triangles }) !== null, verdict === '1', `${i}`);
  });
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
  for (let round = 0; round < 10; round += 1) {
    const order = Array.from({ length: both.triangles.length / 3 }, (_, i) => [round && random(), i]),
      shuffled = order.sort((a, b) => a[0] - b[0]).flatMap(([, t]) => both.triangles.slice(3 * t, 3 * t + 3));
    const [x, y, z] = selfCrossing({ positions: both.positions, triangles: Uint32Array.from(shuffled) });
    // The thin bar goes in and out of the thick one.
    near(Math.hypot(y, z), 0.1, 0.2, `order ${round}: on the thick one`);
    near(Math.hypot(x - 0.5, z), 0.04, 0.5, `order ${round}: on the thin one`);
  }
  assert.equal(selfCrossing(rod), null);
  assert.equal(selfCrossing(through), null);
});

test('a loft that runs through itself is united with itself', () => {
  const loop = loft({ rings: 80, around: 24, length: 3, radius: 0.12, bend: 7 });
  assert.notEqual(selfCrossing(loop), null);
  assert.equal(ringsOf(loop).size, 24);
  const { mesh } = solve(fresh(), [node([rod(1, identity, 'loop'), rod(2, shifted(0, 4), 'loop')])], { loop });
  const found = lawful({ mesh }, 'the loop');
  // Seven radians of a ring: a whole turn of the torus, whatever is passed twice.
  near(found.volume / 2, 2 * Math.PI * (3 / 7) * Math.PI * 0.12 ** 2, 0.04, 'volume');
});

test('a bend tighter than the part is thick becomes a solid', () => {
  const sharp = loft({ rings: 24, around: 16, length: 0.2, radius: 0.15, bend: 3 });
  assert.notEqual(selfCrossing(sharp), null);
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
    if (!selfCrossing(wild)) continue;
    const solved = solve(fresh(), [node([rod(1, identity, 'wild')], { kind: 'join' })], { wild });
    if (solved.failure) {
      assert.deepEqual([solved.failure.error, solved.failure.part], ['PartCrossesItself', 1], `seed ${seed}`);
      // It is shown where a crossing is.
      const least = 0.5e-6 * diagonal(wild.positions),
        isThere = ({ points, depth }) =>
          depth > least &&
          Math.hypot(...solved.failure.at.map((x, k) => x - points.reduce((sum, p) => sum + p[k] / 6, 0))) < 1e-6;
      assert.ok([...crossingPairs(wild.positions, wild.triangles)].some(isThere), `seed ${seed}: shown where none is`);
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
