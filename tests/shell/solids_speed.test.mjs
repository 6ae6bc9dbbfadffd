// What makes solids quicker changes none: edits united with what is near alone, and unions in two workers.
import assert from 'node:assert/strict';
import test from 'node:test';
import {
  fresh,
  identity,
  lawful,
  library,
  loft,
  near,
  node,
  rod,
  seeded,
  shell,
  shifted,
  solve,
  solveWithHelp,
  turned,
} from '../browser/support/solids.mjs';

const { Helper, SolidKernel, countOf, halvesOf } = shell;

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

/** The other parts of a model, that an edit of the last one is expected, and how it is edited. */
function readyForEdits(kind, random) {
  const meshes = Object.fromEntries(
    [0, 1, 2].map((i) => [
      `m${i}`,
      loft({ rings: 30, around: 16, radius: 0.06 + 0.05 * random(), bend: 2 * (random() - 0.5), wave: 0.2 * random() }),
    ]),
  );
  const place = () => turned(6 * random(), 0.3 * random(), 0.3 * random(), 0.06 * random()),
    one = fresh();
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
  return { one, edit };
}

test('an edit united with what is near alone is the solid that all of it anew is, for every kind', () => {
  let stitched = 0;
  for (let seed = 1; seed <= 12; seed += 1) {
    const random = seeded(101 * seed),
      kind = ['join', 'join', 'cut'][seed % 3],
      { one, edit } = readyForEdits(kind, random);
    for (let i = 0; i < 3; i += 1) {
      // The last one goes beyond what was made ready.
      const { nodes, meshes } = edit(i, i < 2 ? 0.05 : 2),
        what = `seed ${seed}, ${kind}, edit ${i}`;
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
      const byNear = one.solids.get(nodes[0].key).faces !== undefined;
      if (byNear) stitched += 1;
      assert.ok(!byNear || i < 2, `${what}: what goes beyond its room is made with all`);
    }
  }
  assert.ok(stitched >= 16, `${stitched} of 24 edits needed only what is near`);
});

test('where what is near and what is away do not fit together, all is made anew', () => {
  for (const spoil of [
    ({ away }) => away.corner.clear(),
    ({ away }) => away.rim.clear(),
    ({ isNear }) => isNear.fill(0, 0, isNear.lastIndexOf(1) + 1),
  ]) {
    const { one, edit } = readyForEdits('join', seeded(4));
    const { near: prepared } = [...one.solids.values()].find((kept) => kept.near);
    spoil(prepared);
    const { nodes, meshes } = edit(1, 0.05),
      again = solve(one, nodes, meshes);
    near(lawful(again, 'spoilt').volume, solve(fresh(), nodes, meshes).mesh.volume, 1e-6, 'volume');
    assert.equal(one.solids.get(nodes[0].key).faces, undefined);
  }
});

/** A second worker on the same library; `fault` says what becomes of a request in its stead. */
function standIn(fault, patience) {
  const told = { shares: 0, ended: 0 };
  const start = () => {
    const stand = {
      onmessage: null,
      onerror: null,
      terminate: () => {
        told.ended += 1;
      },
    };
    stand.postMessage = (message) => {
      told.shares += 1;
      const request = structuredClone(message);
      setImmediate(() =>
        fault
          ? fault(stand, request)
          : stand.onmessage?.({ data: { share: request.share, union: fresh().unite(request) } }),
      );
    };
    return stand;
  };
  return { helper: new Helper(start, patience), told };
}

/** Parts enough for two, each in a mesh of its own. */
function large(random, count = 5) {
  const meshes = Object.fromEntries(
    Array.from({ length: count }, (_, i) => [
      `m${i}`,
      loft({ rings: 40, around: 40, radius: 0.05 + 0.06 * random(), bend: random() - 0.5, wave: 0.2 * random() }),
    ]),
  );
  return {
    meshes,
    operands: Array.from({ length: count }, (_, i) =>
      rod(i + 1, turned(6 * random(), 0.3 * random(), 0.3 * random(), 0.06 * random()), `m${i}`),
    ),
  };
}

function same(solved, anew, what) {
  const found = lawful(solved, what);
  near(found.volume, anew.mesh.volume, 1e-6, `${what}: volume`);
  assert.equal(solved.mesh.genus, anew.mesh.genus, `${what}: handles`);
  const [own, wanted] = [solved, anew].map(({ mesh }) => areas(mesh));
  assert.deepEqual(Object.keys(own), Object.keys(wanted), `${what}: parts that show`);
  for (const part of Object.keys(own))
    assert.ok(Math.abs(own[part] - wanted[part]) < 1e-5 * anew.mesh.area, `${what}: area of part ${part}`);
}

test('a union of which a second worker makes one half is the one that one worker makes, and so are its edits', async () => {
  for (let seed = 1; seed <= 5; seed += 1) {
    const random = seeded(17 * seed),
      { meshes, operands } = large(random),
      { helper, told } = standIn(),
      kernel = new SolidKernel(library, helper);
    // One part goes through itself, and one is there twice.
    if (seed % 2) meshes.m4 = loft({ rings: 60, around: 24, length: 3, radius: 0.12, bend: 7 });
    operands.push({ ...operands[1], matrix: shifted(0.1 * random()) });
    same(
      await solveWithHelp(kernel, [node(operands)], meshes),
      solve(fresh(), [node(operands)], meshes),
      `seed ${seed}`,
    );
    assert.equal(told.shares, 1, 'it was asked');
    for (const edited of [0, 3, 4]) {
      for (const work = kernel.ahead(edited + 1); random() < 0.9 && !work.next().done;);
      operands[edited] = { ...operands[edited], matrix: turned(6 * random(), 0.2 * random()) };
      same(
        await solveWithHelp(kernel, [node(operands)]),
        solve(fresh(), [node(operands)], meshes),
        `seed ${seed}, edit of ${edited}`,
      );
    }
    assert.equal(told.shares, 1, 'what is known is not shared again');
    helper.stop();
  }
});

test('the first worker pauses after each part of its half, so that a second one that has yet to start can', () => {
  const { meshes, operands } = large(seeded(3)),
    given = [];
  const kernel = new SolidKernel(library, {
    isFree: true,
    unite: (share) => {
      given.push(...share);
      return Promise.resolve(null);
    },
  });
  let pauses = 0;
  for (const work = kernel.solve({ id: 1, nodes: [node(operands)], wanted: [], meshes }, () => {}); ; pauses += 1) {
    const { done, value } = work.next();
    if (done || value.wait) break;
  }
  assert.ok(given.length > 1);
  assert.equal(pauses, operands.length - given.length);
});

test('the uv of what the second worker made are those of its parts', async () => {
  const { helper } = standIn(),
    meshes = { rod: loft({ rings: 44, around: 44 }) };
  const operands = [0, 0.4, 0.8, 1.2, 1.6].map((x, i) => rod(i + 1, shifted(x, 0.01 * i)));
  const { mesh } = await solveWithHelp(new SolidKernel(library, helper), [node(operands)], meshes);
  helper.stop();
  assert.deepEqual([...new Set(mesh.runs.map(({ part }) => part))].sort(), [1, 2, 3, 4, 5]);
  for (const { part, first, count } of mesh.runs) {
    for (const v of mesh.triangles.subarray(3 * first, 3 * (first + count)))
      assert.ok(Math.abs(mesh.uv[2 * v] - (mesh.positions[3 * v] - 0.4 * (part - 1))) < 1e-3);
  }
});

test('a second worker that fails, dies, cannot start or answers late leaves the union to the first one', async () => {
  const random = seeded(9),
    { meshes, operands } = large(random),
    anew = solve(fresh(), [node(operands)], meshes);
  const faults = [
    (stand, { share }) => stand.onmessage?.({ data: { share, union: null } }),
    (stand) => stand.onerror?.(new Event('error')),
    (stand, { share }) => {
      stand.onmessage?.({ data: { share: share - 1, union: null } });
      stand.onerror?.(new Event('error'));
    },
    () => {},
  ];
  for (const [i, fault] of faults.entries()) {
    const { helper } = standIn(fault, 50);
    same(await solveWithHelp(new SolidKernel(library, helper), [node(operands)], meshes), anew, `fault ${i}`);
    assert.ok(helper.isFree);
    helper.stop();
  }
  const none = new Helper(() => {
    throw new Error('no workers here');
  });
  same(await solveWithHelp(new SolidKernel(library, none), [node(operands)], meshes), anew, 'no worker');
  assert.ok(none.isFree);
});

test('a part at fault is named, whichever worker has it', async () => {
  const a = loft(),
    b = loft(),
    n = a.positions.length / 3;
  const both = {
    positions: Float32Array.from([
      ...a.positions,
      ...b.positions.map((x, i) => (i % 3 === 0 ? 0.05 + x * 0.9 : x * 1.2)),
    ]),
    uv: new Float32Array([...a.uv, ...b.uv]),
    triangles: Uint32Array.from([...a.triangles, ...b.triangles.map((v) => v + n)]),
  };
  for (let faulty = 0; faulty < 6; faulty += 1) {
    const { meshes, operands } = large(seeded(5), 6),
      { helper, told } = standIn();
    operands[faulty] = rod(faulty + 1, identity, 'both');
    const { failure } = await solveWithHelp(new SolidKernel(library, helper), [node(operands)], { ...meshes, both });
    assert.deepEqual([failure.error, failure.part, told.shares], ['PartCrossesItself', faulty + 1, 1]);
    helper.stop();
  }
});

test('a shared union given up half-way leaves the solver as sound as a fresh one', async () => {
  const random = seeded(12),
    { meshes, operands } = large(random),
    { helper } = standIn(),
    kernel = new SolidKernel(library, helper);
  kernel.keepMeshes(meshes);
  for (let i = 0; i < 4; i += 1) {
    const work = kernel.solve({ id: i, nodes: [node(operands)], wanted: [], meshes: {} }, () => {});
    for (let steps = i; steps > 0; steps -= 1) work.next();
    work.return();
    operands[i] = { ...operands[i], matrix: turned(random()) };
  }
  same(await solveWithHelp(kernel, [node(operands)]), solve(fresh(), [node(operands)], meshes), 'after it');
  helper.stop();
});

test('halves lie side by side and are as large as one another', () => {
  for (let seed = 1; seed <= 40; seed += 1) {
    const random = seeded(seed),
      meshes = Array.from({ length: 3 }, () => loft({ rings: 4 + Math.floor(20 * random()), around: 8 }));
    const operands = Array.from({ length: 4 + Math.floor(8 * random()) }, (_, i) =>
      rod(i, shifted(9 * random(), random(), random()), String(i % 3)),
    );
    const meshOf = ({ mesh }) => meshes[mesh],
      [first, second] = halvesOf(operands, meshOf),
      count = (half) => half.reduce((sum, operand) => sum + meshOf(operand).triangles.length, 0);
    assert.deepEqual(
      [...first, ...second].map(({ part }) => part).sort((a, b) => a - b),
      operands.map(({ part }) => part),
    );
    assert.ok(
      Math.abs(count(first) - count(second)) <=
        Math.max(...operands.map((operand) => meshOf(operand).triangles.length)),
      `seed ${seed}`,
    );
    assert.ok(
      Math.max(...first.map(({ matrix }) => matrix[12])) < Math.min(...second.map(({ matrix }) => matrix[12])) + 1e-9,
      `seed ${seed}: along their longest side`,
    );
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

test('what is stuck to hollow things is cut by their insides alone, and that is the whole without the insides, also edit by edit', () => {
  for (let seed = 1; seed <= 8; seed += 1) {
    const random = seeded(31 * seed),
      { meshes, bodies, handle } = vessels(random),
      of = bodies.slice(0, 1 + (seed % 2)),
      kernel = fresh();
    for (let edit = 0; edit < 3; edit += 1) {
      const last = handle('handle'),
        all = node([...of.map(({ key }) => ({ node: key })), last], { coarse: edit === 1 }),
        nodes = [...of.map((each) => ({ ...each, coarse: edit === 1 })), all];
      const made = solve(kernel, nodes, meshes),
        what = `seed ${seed}, edit ${edit}`;
      lawful(made, what);
      const kept = of.map(({ key }) => kernel.solids.get(edit === 1 ? `${key}~` : key)),
        plain = library.Manifold.ofMesh(
          new library.Mesh({ numProp: 3, vertProperties: meshes.handle.positions, triVerts: meshes.handle.triangles }),
        );
      const whole = library.Manifold.union([...kept.map(({ solid }) => solid), plain.transform(last.matrix)]).subtract(
        library.Manifold.union(kept.flatMap(({ free }) => free)),
      );
      near(made.mesh.volume, whole.volume(), 1e-6, `${what}: volume`);
      const { vertProperties, triVerts } = whole.getMesh();
      assert.equal(made.mesh.genus, countOf(vertProperties.length / 3, triVerts).handles, `${what}: handles`);
      for (const work = kernel.ahead(3); !work.next().done;);
    }
  }
});

/** A body and limbs that stand in it side by side, away from one another. */
function limbs(kind, blend) {
  const meshes = {
    body: loft({ rings: 24, around: 20, radius: 0.14 }),
    limb: loft({ rings: 20, around: 16, radius: 0.05 }),
  };
  const operands = [
    rod(1, shifted(0), 'body'),
    ...[0.15, 0.4, 0.65, 0.9].map((x, i) => rod(i + 2, turned(1.6, x), 'limb')),
  ];
  const edit = (i, k) => ({
    meshes: { [`edit ${i}`]: loft({ rings: 20, around: 16, radius: 0.05 + 0.002 * (i % 7), bend: 0.1 }) },
    operands: operands.map((each, n) => (n === k ? { ...each, mesh: `edit ${i}` } : each)),
  });
  return { meshes, operands, edit, plan: (of, more = {}) => [node(of, { kind, blend, ...more })] };
}

/** How many seams are rounded while `work` runs. */
function roundedIn(work) {
  const { rounding } = SolidKernel.prototype;
  let count = 0;
  SolidKernel.prototype.rounding = function counting(...of) {
    count += 1;
    return rounding.apply(this, of);
  };
  try {
    work();
  } finally {
    SolidKernel.prototype.rounding = rounding;
  }
  return count;
}

test('an edit of a part with rounded seams rounds its own seams alone, also in a preview; the solid is the one that all of it anew is', () => {
  for (const kind of ['join', 'cut']) {
    const { meshes, operands, edit, plan } = limbs(kind, 0.02),
      kernel = fresh(),
      all = kind === 'join' ? 10 : 4,
      own = kind === 'join' ? 4 : 1,
      sizes = [];
    assert.equal(
      roundedIn(() => solve(kernel, plan(operands), meshes)),
      all,
      `${kind}: of any two, or of the first one and any other`,
    );
    assert.equal(
      roundedIn(() => {
        for (const work = kernel.ahead(3); !work.next().done;);
      }),
      0,
      `${kind}: they are there`,
    );
    for (let i = 0; i < 30; i += 1) {
      const what = `${kind}, edit ${i}`,
        edited = edit(i, 2),
        coarse = i % 3 === 1,
        asked = plan(edited.operands, { coarse });
      let made = null;
      assert.equal(
        roundedIn(() => {
          made = solve(kernel, asked, edited.meshes);
        }),
        own,
        what,
      );
      if (i < 4) {
        const anew = solve(fresh(), plan(edited.operands, { coarse: false }), { ...meshes, ...edited.meshes }).mesh,
          found = lawful(made, what);
        near(found.volume, anew.volume, coarse ? 1e-3 : 1e-5, `${what}: volume`);
        assert.equal(made.mesh.genus, anew.genus, `${what}: handles`);
        assert.deepEqual(
          [...new Set(made.mesh.runs.map(({ part }) => part))].sort(),
          [...new Set(anew.runs.map(({ part }) => part))].sort(),
          `${what}: parts that show`,
        );
      }
      sizes.push(kernel.solids.size + kernel.parts.sources.size);
    }
    // What is kept for undo fills in the first ones.
    assert.ok(sizes.at(-1) <= Math.max(...sizes.slice(0, 15)), `${kind}: ${sizes.join(' ')}`);
    // Of the first one every seam is its own; where nothing is known all is made.
    const wide = loft({ rings: 24, around: 20, radius: 0.15 }),
      others = operands.map((each, i) => (i === 0 ? { ...each, mesh: 'wider' } : each));
    const wider = solve(kernel, plan(others), { ...meshes, wider: wide }).mesh;
    near(
      wider.volume,
      solve(fresh(), plan(others), { ...meshes, wider: wide }).mesh.volume,
      1e-5,
      `${kind}: the first one`,
    );
  }
});

test('a part that comes to a join or leaves it is what all of it anew is, sharp or rounded, in any order', () => {
  for (const blend of [0, 0.02]) {
    const { meshes, operands, plan } = limbs('join', blend),
      kernel = fresh(),
      random = seeded(5);
    for (let i = 0; i < 12; i += 1) {
      const some = operands.filter(() => random() < 0.7).toSorted(() => random() - 0.5);
      if (some.length < 2) continue;
      const asked = plan(some),
        made = lawful(solve(kernel, asked, meshes), `${i}`);
      near(made.volume, solve(fresh(), asked, meshes).mesh.volume, 1e-5, `blend ${blend}, ${i}`);
    }
  }
});
