// Solids that are scooped out: walls, openings, handles, and what is stuck to them.
import assert from 'node:assert/strict';
import test from 'node:test';
import {
  fresh,
  identity,
  lawful,
  library,
  loft,
  measure,
  near,
  node,
  rod,
  seeded,
  shell,
  solve,
  turned,
  unsoundByPlace,
} from '../browser/support/solids.mjs';
import { kRounds } from '../support/rounds.mjs';

const { countOf } = shell;

/** The part `body`, scooped out from its end. */
const cup = (wall = 0.04) => node([rod(1, identity, 'body')], { kind: 'hollow', wall, opening: [1, 0, 0] });

test('a hollow is as thick as its wall, open where it should be', () => {
  const kernel = fresh(),
    meshes = { rod: loft({ rings: 40, around: 48, radius: 0.25 }) };
  const outer = measure(meshes.rod).volume;
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
  assert.deepEqual(
    half.mesh.runs.map(({ part }) => part),
    [1],
    'the rim looks as the body does',
  );
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
  const outer = measure(meshes.rod).volume;
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
  const hollow = cup();
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
    const hollow = cup(between(0.03, 0.06));
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
  const hollow = cup();
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

/** Two hollow rods that may reach into one another, and a bent one that starts in the wall of the first. */
function vessels(random) {
  const meshes = {
    rod: loft({ rings: 14, around: 16, radius: 0.2 + 0.05 * random(), wave: 0.2 * random() }),
    handle: loft({
      rings: 20,
      around: 10,
      length: 0.5 + 0.4 * random(),
      radius: 0.04 + 0.02 * random(),
      bend: 2.5 * random(),
    }),
  };
  const hollow = (part, matrix, opening) => ({
    ...node([rod(part, matrix)], { kind: 'hollow', wall: 0.03, opening }),
    step: part,
  });
  return {
    meshes,
    bodies: [hollow(1, identity, [1, 0, 0]), hollow(2, turned(0.4 + random(), 0.3, 0.3 * random()), null)],
    handle: (mesh) => rod(3, turned(6 * random(), 0.2 + 0.3 * random(), 0.2 * random()), mesh),
  };
}

/** A mesh of the solver as a solid of the library. */
function solidFrom({ positions, triangles, mergeFrom = [], mergeTo = [] }) {
  const [mergeFromVert, mergeToVert] = [mergeFrom, mergeTo].map((list) => Uint32Array.from(list));
  return library.Manifold.ofMesh(
    new library.Mesh({ numProp: 3, vertProperties: positions, triVerts: triangles, mergeFromVert, mergeToVert }),
  );
}

test('what is stuck to hollow things is cut by their insides alone, and that is the whole without the insides, also edit by edit', () => {
  for (let seed = 1; seed <= 4 * kRounds; seed += 1) {
    const random = seeded(31 * seed),
      { meshes, bodies, handle } = vessels(random),
      of = bodies.slice(0, 1 + (seed % 2)),
      own = [],
      made = (solid) => {
        own.push(solid);
        return solid;
      },
      taken = [],
      cavities = new Map(),
      kernel = fresh({
        ofMesh: (mesh) => {
          taken.push(library.Manifold.ofMesh(mesh));
          return taken.at(-1);
        },
      });
    for (let edit = 0; edit < 3; edit += 1) {
      const coarse = edit === 1,
        hollows = of.map((each) => ({ ...each, coarse })),
        last = handle('handle'),
        what = `seed ${seed}, edit ${edit}`;
      const shells = hollows.map((each) => {
        taken.length = 0;
        const { mesh } = solve(kernel, [each], meshes),
          key = `${each.key} ${coarse}`,
          shell = made(solidFrom(mesh));
        // What is scooped out is the last that is made from a mesh.
        if (taken.length > 0) cavities.set(key, taken.at(-1));
        return { shell, cavity: cavities.get(key) };
      });
      const all = node([...of.map(({ key }) => ({ node: key })), last], { coarse }),
        solved = solve(kernel, [...hollows, all], meshes);
      lawful(solved, what);
      const bar = made(made(solidFrom(meshes.handle)).transform(last.matrix)),
        filled = made(library.Manifold.union([...shells.map(({ shell: each }) => each), bar])),
        inside = made(library.Manifold.union(shells.map(({ cavity }) => cavity))),
        whole = made(filled.subtract(inside));
      near(solved.mesh.volume, whole.volume(), 2e-6, `${what}: volume`);
      const { vertProperties, triVerts } = whole.getMesh();
      assert.equal(solved.mesh.genus, countOf(vertProperties.length / 3, triVerts).handles, `${what}: handles`);
      for (const work = kernel.ahead(3); !work.next().done;);
    }
    // The library's memory ends at 4 GB.
    for (const solid of own) solid.delete();
    kernel.forgetAll();
  }
});
