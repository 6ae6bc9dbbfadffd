// Random models of lofts, puffs and flat pieces that coincide, touch or lie a hair apart, stuck together, cut, scooped
// out and with round seams: what comes out is a solid that holds what sets say, or says which part is at fault.
import assert from 'node:assert/strict';
import test from 'node:test';
import { puff, sheet } from '../browser/support/regions.mjs';
import {
  fresh,
  identity,
  lawful,
  loft,
  measure,
  node,
  seeded,
  shifted,
  solve,
  turned,
} from '../browser/support/solids.mjs';

const times = (a, b) =>
  Array.from({ length: 16 }, (_, i) =>
    [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + (i % 4)] * b[4 * Math.floor(i / 4) + k], 0),
  );
const tipped = (angle) => [
  1,
  0,
  0,
  0,
  0,
  Math.cos(angle),
  Math.sin(angle),
  0,
  0,
  -Math.sin(angle),
  Math.cos(angle),
  0,
  0,
  0,
  0,
  1,
];
const placed = ({ positions }, m) =>
  positions.map((_, i) => {
    const v = 3 * Math.floor(i / 3),
      k = i % 3;
    return m[k] * positions[v] + m[4 + k] * positions[v + 1] + m[8 + k] * positions[v + 2] + m[12 + k];
  });

/** How often a closed mesh goes round a point, by the solid angles of its triangles (Van Oosterom and Strackee). */
function rounds(positions, triangles, [x, y, z]) {
  let angle = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => {
      const v = 3 * triangles[t + k];
      return [positions[v] - x, positions[v + 1] - y, positions[v + 2] - z];
    });
    const [la, lb, lc] = [a, b, c].map((p) => Math.hypot(...p));
    const of = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    const volume =
      a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    angle += Math.atan2(volume, la * lb * lc + of(a, b) * lc + of(b, c) * la + of(c, a) * lb);
  }
  return Math.round(angle / (2 * Math.PI)) + 0;
}

/** What sets say of a point: 1 within, 0 outside; null where rounding, or what is scooped out, may say either. */
function expected(at, nodes, meshes, point) {
  const within = (operand) =>
    operand.node ? of(nodeOf(operand)) : rounds(at(operand), meshes[operand.mesh].triangles, point) > 0 ? 1 : 0;
  const nodeOf = (operand) => nodes.find(({ key }) => key === operand.node);
  const isHollow = (operand) =>
    operand.node && (nodeOf(operand).kind === 'hollow' || nodeOf(operand).operands.some(isHollow));
  const of = ({ kind, operands, blend }) => {
    const all = operands.map(within),
      [first, ...others] = all,
      any = (value) => (list) => list.includes(value);
    if (kind === 'hollow') return any(1)(all) || any(null)(all) ? null : 0;
    const sharp = {
      join: () => (any(1)(all) ? 1 : any(null)(all) ? null : 0),
      common: () => (any(0)(all) ? 0 : any(null)(all) ? null : 1),
      cut: () => (first === 0 || any(1)(others) ? 0 : first === null || any(null)(others) ? null : 1),
    }[kind]();
    // What is stuck to a hollow thing does not stand into its inside.
    if (kind === 'join' && sharp === 1 && operands.some(isHollow)) return null;
    // A round seam adds to a join, and takes from the others.
    return blend > 0 && sharp === (kind === 'join' ? 0 : 1) ? null : sharp;
  };
  return of(nodes.at(-1));
}

/** Points in the box of all parts; of each the answer of the solid must be that of sets, unless it is too near to a face to tell. */
function holdsWhatSetsSay({ positions, triangles }, nodes, meshes, random, what) {
  const places = new Map(),
    key = ({ mesh, matrix }) => `${mesh} ${matrix}`;
  const at = (operand) => {
    if (!places.has(key(operand))) places.set(key(operand), placed(meshes[operand.mesh], operand.matrix));
    return places.get(key(operand));
  };
  nodes.forEach(({ operands }) => operands.filter(({ mesh }) => mesh).forEach(at));
  const all = [...places.values()],
    bound = (k, best) =>
      all.reduce(
        (found, list) => list.reduce((m, x, i) => (i % 3 === k ? best(m, x) : m), found),
        best === Math.min ? Infinity : -Infinity,
      );
  const low = [0, 1, 2].map((k) => bound(k, Math.min)),
    high = [0, 1, 2].map((k) => bound(k, Math.max));
  let told = 0;
  for (let i = 0; i < 40; i += 1) {
    const point = low.map((x, k) => x + (high[k] - x) * random());
    const wanted = expected(at, nodes, meshes, point),
      near = (k, by) => point.map((x, j) => (j === k ? x + by : x));
    if (wanted === null) continue;
    const found = rounds(positions, triangles, point);
    if (
      found !== wanted &&
      [0, 1, 2].some((k) => [-2e-3, 2e-3].some((by) => expected(at, nodes, meshes, near(k, by)) !== wanted))
    )
      continue;
    assert.equal(found, wanted, `${what}: at ${point}`);
    told += 1;
  }
  return told;
}

const meshesOf = (random) => {
  const outline = () => ({
    radius: 0.15 + 0.25 * random(),
    lobes: 2 + Math.floor(4 * random()),
    wave: 0.2 * random(),
    turn: 6 * random(),
    around: 12 + Math.floor(20 * random()),
  });
  return {
    loft: loft({
      rings: 5 + Math.floor(14 * random()),
      around: 4 + Math.floor(12 * random()),
      radius: 0.05 + 0.1 * random(),
      bend: 2 * random(),
      wave: 0.3 * random(),
    }),
    bar: loft({ rings: 8, around: 4 * (2 + Math.floor(3 * random())), radius: 0.1 }),
    puff: puff(random, { ...outline(), height: 0.1 + 0.2 * random(), rings: 3 + Math.floor(4 * random()) }),
    half: puff(random, { ...outline(), height: 0.1 + 0.2 * random(), oneSided: true }),
    sheet: sheet(random, { ...outline(), thickness: 0.05 + 0.1 * random() }),
    ring: sheet(random, { ...outline(), thickness: 0.1, hole: 0.3 + 0.4 * random() }),
  };
};

/** A part anywhere; or just where another one is, a hair beside it, or so that the boxes of both touch. */
function anyPart(random, meshes, before, part) {
  const kinds = Object.keys(meshes),
    mesh = kinds[Math.floor(kinds.length * random())],
    draw = random();
  const like = before[Math.floor(before.length * random())];
  if (like && draw < 0.15) return { ...like, part };
  if (like && draw < 0.3)
    return {
      ...like,
      part,
      matrix: times(shifted(...[0, 1, 2].map(() => (random() < 0.5 ? 1e-9 : -1e-9))), like.matrix),
    };
  if (like && draw < 0.5) {
    const k = Math.floor(3 * random()),
      side = (of, matrix, best) =>
        placed(meshes[of], matrix).reduce(
          (m, x, i) => (i % 3 === k ? best(m, x) : m),
          best === Math.min ? Infinity : -Infinity,
        );
    const matrix = [...identity],
      straight = like.matrix;
    for (let j = 0; j < 3; j += 1) matrix[12 + j] = straight[12 + j];
    matrix[12 + k] += side(like.mesh, straight, Math.max) - side(mesh, matrix, Math.min);
    return { mesh, part, matrix };
  }
  const flat = random() < 0.4;
  const turn = flat ? identity : times(turned(6 * random()), tipped(6 * random()));
  return {
    mesh,
    part,
    matrix: times(shifted(0.8 * (random() - 0.5), 0.8 * (random() - 0.5), flat ? 0 : 0.4 * (random() - 0.5)), turn),
  };
}

/** Steps over up to five parts or solids each, until one solid is left; a round seam and a hollow are in some of them. */
function anySteps(random, operands) {
  const nodes = [],
    left = [...operands],
    soft = random() < 0.4 ? Math.floor(3 * random()) : -1,
    scooped = random() < 0.4 ? Math.floor(3 * random()) : -1;
  for (let i = 0; left.length > 1 || nodes.length === 0; i += 1) {
    const taken = left.splice(0, Math.min(left.length, 2 + Math.floor(4 * random())));
    const kind = ['join', 'join', 'join', 'join', 'join', 'join', 'cut', 'common'][Math.floor(8 * random())];
    nodes.push(
      node(taken, {
        kind,
        step: nodes.length + 1,
        blend: i === soft && kind !== 'common' ? 0.015 + 0.03 * random() : 0,
      }),
    );
    if (i === scooped) {
      const axis = Math.floor(3 * random()),
        opening = random() < 0.4 ? null : [0, 1, 2].map((k) => (k === axis ? 1 : 0));
      nodes.push(
        node([{ node: nodes.at(-1).key }], {
          kind: 'hollow',
          wall: 0.012 + 0.02 * random(),
          opening,
          step: nodes.length + 1,
        }),
      );
    }
    left.push({ node: nodes.at(-1).key });
  }
  return nodes;
}

test('puffs and flat pieces of these tests are closed and outward', () => {
  const random = seeded(2);
  for (let i = 0; i < 10; i += 1) {
    for (const [kind, mesh] of Object.entries(meshesOf(random))) {
      const { open, volume, euler } = measure(mesh);
      assert.deepEqual([open, euler, volume > 0], [0, kind === 'ring' ? 0 : 2, true], kind);
    }
  }
});

test('random models of up to twenty lofts, puffs and flat pieces that coincide, touch or nearly do are solids as sets say, or name what is at fault', () => {
  const told = { solid: 0, empty: 0, thick: 0, points: 0 };
  for (let seed = 1; seed <= 26; seed += 1) {
    const random = seeded(104729 * seed),
      meshes = meshesOf(random),
      operands = [];
    for (let count = 2 + Math.floor(19 * random()); operands.length < count;)
      operands.push(anyPart(random, meshes, operands, operands.length + 1));
    const nodes = anySteps(random, operands),
      what = `seed ${seed}`;
    const solved = solve(fresh(), nodes, meshes);
    if (solved.failure) {
      const { error, part } = solved.failure;
      if (error === 'SolidEmpty') told.empty += 1;
      else {
        assert.equal(error, 'WallTooThick', `${what}: ${JSON.stringify(solved.failure)}`);
        assert.ok(
          operands.some((operand) => operand.part === part),
          `${what}: part ${part}`,
        );
        told.thick += 1;
      }
      continue;
    }
    const { euler, shells } = lawful(solved, what);
    assert.equal(euler, 2 * shells - 2 * solved.mesh.genus, `${what}: genus`);
    assert.ok(solved.mesh.genus >= 0, `${what}: genus`);
    told.points += holdsWhatSetsSay(solved.mesh, nodes, meshes, random, what);
    told.solid += 1;
  }
  assert.ok(told.solid >= 16 && told.points >= 400, JSON.stringify(told));
});

test('what random models are scooped out to is a solid, or empty, or has a part whose wall is too thick', () => {
  const told = {},
    kernel = fresh();
  for (let seed = 1; seed <= 40; seed += 1) {
    const random = seeded(7919 * seed + 13),
      meshes = meshesOf(random),
      operands = [];
    for (let count = 2 + Math.floor(8 * random()); operands.length < count;)
      operands.push(anyPart(random, meshes, operands, operands.length + 1));
    const kind = ['join', 'join', 'cut', 'common'][Math.floor(4 * random())],
      axis = Math.floor(3 * random());
    const body = node(operands, { kind, blend: random() < 0.2 && kind !== 'common' ? 0.02 : 0 }),
      opening = random() < 0.5 ? null : [0, 1, 2].map((k) => (k === axis ? 1 : 0));
    const nodes = [
        body,
        node([{ node: body.key }], { kind: 'hollow', wall: 0.006 + 0.02 * random(), opening, step: 2 }),
      ],
      solved = solve(kernel, nodes, meshes),
      { error, part } = solved.failure ?? { error: 'solid' };
    told[error] = (told[error] ?? 0) + 1;
    if (error === 'solid') lawful(solved, `seed ${seed}`);
    else if (error !== 'SolidEmpty')
      assert.deepEqual(
        [error, operands.some((operand) => operand.part === part)],
        ['WallTooThick', true],
        `seed ${seed}: ${JSON.stringify(solved.failure)}`,
      );
    kernel.forgetAll();
  }
  assert.ok(told.solid >= 24, JSON.stringify(told));
});

test('parts that only touch have nothing in common, and nothing is left of a part less itself', () => {
  const bar = loft({ rings: 8, around: 12, radius: 0.1 }),
    meshes = { bar };
  for (const apart of [0, 1e-9, 1e-8]) {
    for (const [kind, matrix] of [
      ['common', shifted(1 - apart)],
      ['cut', shifted(0, apart)],
      ['cut', shifted(apart, -apart, apart)],
    ]) {
      const { failure } = solve(
        fresh(),
        [
          node(
            [
              { mesh: 'bar', part: 1, matrix: identity },
              { mesh: 'bar', part: 2, matrix },
            ],
            { kind },
          ),
        ],
        meshes,
      );
      assert.equal(failure?.error, 'SolidEmpty', `${kind} of ${matrix}`);
    }
  }
});

test('fifty times the same puff or flat piece, a hair apart or not, is that one', () => {
  const random = seeded(12),
    meshes = meshesOf(random);
  for (const mesh of ['puff', 'half', 'sheet', 'ring', 'loft']) {
    for (const apart of [0, 1e-9]) {
      const operands = Array.from({ length: 50 }, (_, i) => ({
        mesh,
        part: i + 1,
        matrix: shifted(...[0, 1, 2].map(() => apart * (random() - 0.5))),
      }));
      const alone = measure(meshes[mesh]);
      const { volume, euler, shells } = lawful(solve(fresh(), [node(operands)], meshes), mesh);
      assert.ok(Math.abs(volume / alone.volume - 1) < 1e-7, `${mesh}: ${volume} and ${alone.volume}`);
      assert.deepEqual([euler, shells], [alone.euler, 1], `${mesh} ${apart} apart`);
    }
  }
});
