// What makes edits of solids quicker changes none: what is kept, made ahead, or united with what is near alone.
import assert from 'node:assert/strict';
import test from 'node:test';
import {
  counted,
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
  shifted,
  solve,
  turned,
} from '../browser/support/solids.mjs';

const { Near } = shell;

/** What came of an edit is what comes of all of it anew. */
function alike(again, anew, what) {
  assert.deepEqual(again.failure, anew.failure, what);
  if (!again.failure) near(lawful(again, what).volume, anew.mesh.volume, 1e-5, what);
}

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
      alike(again, anew, `${kind}, edit ${i}`);
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
    const size = one.counts.solids;
    // As when one part after the other is chosen, and none is edited.
    for (let part = 1; part <= operands.length; part += 1) for (const work = one.ahead(part); !work.next().done;);
    for (const work = one.ahead(null); !work.next().done;);
    assert.equal(one.counts.solids, size, `${kind}: nothing is left of it`);
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
      alike(again, anew, `${kind}, edit ${i}`);
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

/** Area of the faces of each part. */
function areas({ positions, triangles, runs }) {
  const found = {};
  for (const { part, first, count } of runs) {
    for (let t = first; t < first + count; t += 1) {
      const [a, b, c] = [0, 1, 2].map((k) =>
        positions.subarray(3 * triangles[3 * t + k], 3 * triangles[3 * t + k] + 3),
      );
      const u = [0, 1, 2].map((k) => b[k] - a[k]),
        v = [0, 1, 2].map((k) => c[k] - a[k]);
      found[part] =
        (found[part] ?? 0) +
        Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
    }
  }
  return found;
}

/** A model whose solver expects edits of one part, these edits, and of how many triangles is what the library is given. */
function readyForEdits(kind, random) {
  const meshes = Object.fromEntries(
    [0, 1, 2].map((i) => [
      `m${i}`,
      loft({ rings: 30, around: 16, radius: 0.06 + 0.05 * random(), bend: 2 * (random() - 0.5), wave: 0.2 * random() }),
    ]),
  );
  const place = () => turned(6 * random(), 0.3 * random(), 0.3 * random(), 0.06 * random()),
    given = [];
  const noting = (name) => (solids) => {
    given.push(...solids.map((solid) => solid.numTri()));
    return library.Manifold[name](solids);
  };
  const one = fresh({ union: noting('union'), difference: noting('difference') });
  const operands = Array.from({ length: 6 }, (_, i) => rod(i + 1, place(), `m${i % 3}`)),
    edited = kind === 'cut' ? 1 + Math.floor(5 * random()) : Math.floor(6 * random());
  solve(one, [node(operands, { kind })], meshes);
  for (const work = one.ahead(edited + 1); !work.next().done;);
  const { mesh, matrix } = operands[edited];
  // Its vertices are shaken too little to make it cross itself.
  const edit = (number, shift) => {
    const key = `edit ${number}`,
      positions = meshes[mesh].positions.map((x) => x + 0.002 * random());
    operands[edited] = rod(
      edited + 1,
      matrix.map((x, i) => (i > 11 && i < 15 ? x + shift * (random() - 0.5) : x)),
      key,
    );
    return { nodes: [node(operands, { kind })], meshes: { ...meshes, [key]: { ...meshes[mesh], positions } } };
  };
  return { one, edit, given };
}

test('an edit united with what is near alone is the solid that all of it anew is, for every kind', () => {
  let stitched = 0;
  for (let seed = 1; seed <= 12; seed += 1) {
    const random = seeded(101 * seed),
      kind = ['join', 'join', 'cut'][seed % 3],
      { one, edit, given } = readyForEdits(kind, random);
    for (let i = 0; i < 3; i += 1) {
      // The last one goes beyond what was made ready.
      const { nodes, meshes } = edit(i, i < 2 ? 0.05 : 2),
        what = `seed ${seed}, ${kind}, edit ${i}`;
      given.length = 0;
      const again = solve(one, nodes, meshes),
        anew = solve(fresh(), nodes, meshes);
      assert.equal(again.failure?.error, anew.failure?.error, what);
      if (again.failure) continue;
      const found = lawful(again, what);
      near(found.volume, anew.mesh.volume, 1e-6, `${what}: volume`);
      near(again.mesh.area, anew.mesh.area, 1e-5, `${what}: area`);
      assert.equal(again.mesh.genus, anew.mesh.genus, `${what}: handles`);
      assert.equal(found.euler, 2 * found.shells - 2 * again.mesh.genus, `${what}: handles as counted`);
      const [own, wanted] = [again, anew].map(({ mesh }) => areas(mesh));
      assert.deepEqual(Object.keys(own), Object.keys(wanted), `${what}: parts that show`);
      for (const part of Object.keys(own))
        assert.ok(Math.abs(own[part] - wanted[part]) < 1e-5 * anew.mesh.area, `${what}: area of part ${part}`);
      const byNear = Math.max(...given) < 0.75 * (again.mesh.triangles.length / 3);
      if (byNear) stitched += 1;
      assert.ok(!byNear || i < 2, `${what}: what goes beyond its room is made with all`);
    }
  }
  assert.ok(stitched >= 16, `${stitched} of 24 edits needed only what is near`);
});

test('what does not fit to what is away is not put together with it: what goes beyond its room, or is none of it', () => {
  const rest = library.Manifold.cylinder(2, 0.2, 0.2, 32).refine(4),
    ball = library.Manifold.sphere(0.15, 24),
    { vertProperties: positions } = ball.getMesh(),
    work = Near.of(library, rest, [{ positions, matrix: shifted(0.2, 0, 1) }]);
  let step = work.next();
  while (!step.done) step = work.next();
  const { value: near } = step;
  assert.ok(near.solid.numTri() < 0.6 * rest.numTri());
  assert.ok(near.holds([{ positions, matrix: shifted(0.21, 0, 1) }]));
  assert.ok(!near.holds([{ positions, matrix: shifted(0.2, 0, 1.4) }]));
  const faces = (solid) => near.withAway(solid.getMesh());
  const fits = faces(near.solid.add(ball.translate([0.21, 0, 1]))),
    whole = rest.add(ball.translate([0.21, 0, 1])),
    made = measure({ positions: fits.vertProperties, triangles: fits.triVerts });
  assert.equal(made.open, 0);
  assert.ok(Math.abs(made.volume - whole.volume()) < 1e-6 * made.volume);
  assert.equal(faces(near.solid.add(library.Manifold.cube([1, 1, 4], true))), null, 'it goes beyond the room');
  assert.equal(faces(near.solid.translate([1e-4, 0, 0])), null, 'it is a hair beside it');
  assert.equal(faces(ball), null, 'it is nothing of it');
});

test('what is made ahead, given up at any moment, leaves nothing behind', () => {
  const meshes = { rod: loft({ rings: 20, around: 12 }) },
    operands = Array.from({ length: 6 }, (_, i) => rod(i + 1, turned(i, 0.1 * i)));
  counted(({ living }) => {
    const kernel = fresh();
    solve(kernel, [node(operands)], meshes);
    const size = living.size,
      before = kernel.counts;
    assert.ok(size > 0, 'solids are counted');
    for (let steps = 0; steps < 16; steps += 1) {
      const work = kernel.ahead(2);
      for (let left = steps; left > 0 && !work.next().done; left -= 1);
      work.return();
      for (const rest = kernel.ahead(null); !rest.next().done;);
      assert.deepEqual([living.size, kernel.counts], [size, before], `after ${steps} pieces`);
    }
  });
});

test('an edit of a part that goes through itself is got ready and made as any other', () => {
  const meshes = { rod: loft(), coil: loft({ rings: 60, around: 24, length: 3, radius: 0.12, bend: 7 }) },
    operands = [rod(1), rod(2, turned(1, 0.3), 'coil'), rod(3, turned(2, 0.2)), rod(4, turned(3, 0.4))],
    kernel = fresh();
  lawful(solve(kernel, [node(operands)], meshes), 'with a coil');
  for (const work = kernel.ahead(2); !work.next().done;);
  operands[1] = rod(2, turned(1.1, 0.3), 'coil');
  const made = lawful(solve(kernel, [node(operands)]), 'its edit');
  near(made.volume, solve(fresh(), [node(operands)], meshes).mesh.volume, 1e-6, 'volume');
});
