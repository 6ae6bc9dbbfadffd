// A solver that is likely to be needed makes itself quick beforehand, and nothing of that is left.
import assert from 'node:assert/strict';
import test from 'node:test';
import { fresh, library, loft, near, node, rod, seeded, shell, solve, turned } from '../browser/support/solids.mjs';

const { Helper, SolidKernel, SolidWarmUp, Solver, rehearse, solidWorkersFor, wasWorkedAt } = shell;

/** Goes through it as a worker does: whatever came in between is let in. */
async function run(work, steps = Infinity) {
  for (let left = steps; left > 0 && !work.next().done; left -= 1)
    await new Promise((resolve) => setImmediate(resolve));
  work.return();
}

/** Notes what methods of the solver return while `work` runs. */
async function noted(names, work) {
  const found = Object.fromEntries(names.map((name) => [name, []])),
    before = names.map((name) => SolidKernel.prototype[name]);
  names.forEach((name, i) => {
    SolidKernel.prototype[name] = function noting(...args) {
      const made = before[i].apply(this, args);
      found[name].push(made);
      return made;
    };
  });
  try {
    await work();
  } finally {
    names.forEach((name, i) => {
      SolidKernel.prototype[name] = before[i];
    });
  }
  return found;
}

/** Five parts in one solid, ready for an edit of the second one. */
function model(seed) {
  const random = seeded(seed),
    meshes = Object.fromEntries(
      [0, 1, 2, 3, 4].map((i) => [
        `m${i}`,
        loft({ rings: 20, around: 12, radius: 0.06 + 0.05 * random(), bend: random() - 0.5 }),
      ]),
    );
  const operands = Object.keys(meshes).map((mesh, i) =>
    rod(i + 1, turned(6 * random(), 0.3 * random(), 0.3 * random()), mesh),
  );
  return { meshes, operands };
}

test('a rehearsal goes every way that unions and edits go: a half by another, edits with what is near, the mesh that goes back', async () => {
  const found = await noted(['unite', 'takeShare', 'withNear', 'meshOf'], () => run(rehearse(library)));
  const rounds = found.unite.length;
  assert.ok(rounds > 1, `${rounds} rounds`);
  assert.ok(
    found.unite.every((union) => union?.faces.triVerts.length > 0),
    'the second worker made its half',
  );
  assert.equal(found.takeShare.length, rounds, 'and the first one took it');
  assert.ok(
    found.withNear.length > rounds && found.withNear.every((made) => made?.faces),
    'every edit has to do with what is near alone',
  );
  assert.ok(
    found.meshOf.length >= 2 * rounds && found.meshOf.every(({ genus, runs }) => genus === 0 && runs.length > 3),
    'all rods are one solid',
  );
});

test('a rehearsal, also one given up at any moment, leaves no solid behind', async () => {
  const living = new Set(),
    { ofMesh } = library.Manifold,
    kind = Object.getPrototypeOf(library.Manifold.cube()),
    { delete: end } = kind;
  library.Manifold.ofMesh = (mesh) => {
    const solid = ofMesh(mesh);
    living.add(solid);
    return solid;
  };
  kind.delete = function ending() {
    living.delete(this);
    end.call(this);
  };
  try {
    for (let steps = 1; steps < 24; steps += 1) {
      await run(rehearse(library), steps);
      assert.equal(living.size, 0, `after ${steps} pieces`);
    }
    const { meshes, operands } = model(3),
      kernel = fresh();
    solve(kernel, [node(operands)], meshes);
    const before = living.size,
      sources = kernel.parts.sources.size;
    assert.ok(before >= operands.length, 'solids are counted');
    for (let steps = 1; steps < 16; steps += 1) {
      kernel.tries = 0;
      await run(kernel.ahead(2), steps);
      assert.deepEqual(
        [living.size, kernel.parts.sources.size],
        [before, sources],
        `an edit tried out for ${steps} pieces`,
      );
    }
  } finally {
    library.Manifold.ofMesh = ofMesh;
    kind.delete = end;
  }
});

test('an edit is tried out before the first one, in pieces, and never again; the solid is the same', async () => {
  for (let seed = 1; seed <= 6; seed += 1) {
    const { meshes, operands } = model(seed),
      kernel = fresh(),
      kind = seed % 3 === 0 ? 'cut' : 'join';
    solve(kernel, [node(operands, { kind })], meshes);
    const { meshOf } = await noted(['meshOf'], () => run(kernel.ahead(2)));
    assert.ok(meshOf.length > 1, 'more than once');
    const { meshOf: again } = await noted(['meshOf'], () => run(kernel.ahead(4)));
    assert.equal(again.length, 0, 'for another part it is as quick');
    const edit = [
        node(
          operands.map((each, i) => (i === 3 ? { ...each, mesh: 'edit' } : each)),
          { kind },
        ),
      ],
      given = { ...meshes, edit: loft({ rings: 22, around: 12, radius: 0.08 }) };
    const made = solve(kernel, edit, given),
      anew = solve(fresh(), edit, given);
    near(made.mesh.volume, anew.mesh.volume, 1e-6, `seed ${seed}: volume`);
    assert.equal(made.mesh.genus, anew.mesh.genus);
  }
});

test('a part at fault is no obstacle to what is tried out', async () => {
  const { meshes, operands } = model(2),
    kernel = fresh();
  solve(kernel, [node(operands)], meshes);
  // It goes through itself, and is mended.
  const edit = [node(operands.map((each, i) => (i === 1 ? { ...each, mesh: 'coil' } : each)))],
    coil = loft({ rings: 60, around: 24, length: 3, radius: 0.12, bend: 7 });
  kernel.tries = 0;
  assert.equal(solve(kernel, edit, { coil }).failure, undefined);
  await run(kernel.ahead(2));
  near(
    solve(kernel, [{ ...edit[0], key: 'once more' }]).mesh.volume,
    solve(fresh(), edit, { ...meshes, coil }).mesh.volume,
    1e-6,
    'volume',
  );
});

function pageSide() {
  const workers = [];
  const start = () => {
    workers.push({
      told: [],
      postMessage(message) {
        this.told.push(message);
      },
      terminate() {
        this.ended = true;
      },
    });
    return workers.at(-1);
  };
  return {
    workers,
    solver: new Solver({
      start,
      floats: (at, count) => new Float32Array(count),
      integers: (at, count) => new Uint32Array(count),
      answer: () => {},
    }),
  };
}
const warmings = ({ told }) => told.filter(({ warm }) => warm).map(({ warm }) => warm.large);

test('a worker is started before it is asked, once; not while it works, and not after one has died or was stopped', () => {
  const { workers, solver } = pageSide();
  solver.warm(false);
  solver.warm(true);
  assert.deepEqual(workers.map(warmings), [[false, true]]);
  solver.ask({ type: 'solve', id: 1, meshes: [], nodes: [], wanted: [] });
  solver.warm(true);
  assert.deepEqual(
    workers.map(warmings),
    [[false, true]],
    'the one that was warmed is asked, and left alone meanwhile',
  );
  workers[0].onmessage({ data: { type: 'done', id: 1 } });
  solver.warm(true);
  assert.deepEqual(workers.map(warmings), [[false, true, true]]);
  workers[0].onerror({});
  solver.warm(true);
  assert.equal(workers.length, 1, 'what died for want of memory is not started again unasked');
  solver.ask({ type: 'solve', id: 2, meshes: [], nodes: [], wanted: [] });
  assert.equal(workers.length, 2);
  solver.stop();
  solver.warm(false);
  assert.equal(workers.length, 2);
});

test('workers are started for a model that is worked at: one for two parts, two while a large union is picked', () => {
  const parts = (count, triangles) => Array.from({ length: count }, () => ({ triangles })),
    picked = (count) => Array.from({ length: count }, (_, i) => ({ part: i + 1 }));
  const workers = (count, triangles, of, isWorkedAt) =>
    solidWorkersFor({ parts: parts(count, triangles), picked: picked(of), undo: 5 }, isWorkedAt);
  assert.equal(workers(10, 8000, 0, false), 0, 'it is only looked at');
  assert.equal(workers(1, 8000, 0, true), 0, 'there is nothing to stick to');
  assert.deepEqual(
    [workers(2, 8000, 0, true), workers(2, 8000, 2, true), workers(10, 8000, 0, true), workers(10, 8000, 1, false)],
    [1, 1, 1, 1],
  );
  assert.equal(workers(10, 100, 5, false), 1, 'small ones are made by one worker');
  assert.deepEqual([workers(10, 8000, 2, false), workers(4, 3001, 2, true)], [2, 2]);
  const seen = (count, undo) => ({ parts: parts(count, 8000), picked: [], undo });
  assert.ok(wasWorkedAt(seen(1, 3), seen(2, 4)), 'a part was drawn');
  assert.ok(!wasWorkedAt(seen(0, 0), seen(2, 1)), 'a model was opened, with the step that its history holds');
  assert.ok(
    !wasWorkedAt(seen(2, 4), seen(2, 4)) && !wasWorkedAt(seen(2, 4), seen(2, 3)),
    'nothing was done, or undone',
  );
});

test('what is likely is made once the hand rests, in a page that is seen; not for one part, nor where one only looks', (t) => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  let asked = 0,
    isIdle = true;
  globalThis.document = { visibilityState: 'visible' };
  t.after(() => {
    delete globalThis.document;
  });
  const engine = {
      isIdle: () => isIdle,
      prepareSolids: () => {
        asked += 1;
      },
      solver: null,
    },
    seen = (count, undo) => ({ parts: Array.from({ length: count }, () => ({ triangles: 8000 })), picked: [], undo });
  // Longer than any rest, in steps, for the one begins where the other ended.
  const rest = (ms = 5000) => {
    for (let i = 0; i < ms; i += 100) t.mock.timers.tick(100);
  };
  const looking = new SolidWarmUp(engine);
  for (const state of [seen(0, 0), seen(5, 1), seen(5, 1)]) looking.see(state);
  rest();
  const working = new SolidWarmUp(engine);
  working.see(seen(0, 0));
  working.see(seen(1, 1));
  rest();
  assert.equal(asked, 0);
  for (let undo = 2; undo < 30; undo += 1) {
    working.see(seen(2, undo));
    rest(500);
  }
  assert.equal(asked, 0, 'the hand does not rest');
  isIdle = false;
  rest();
  assert.equal(asked, 0, 'the engine is at something');
  isIdle = true;
  rest();
  assert.equal(asked, 1, 'later, once');
  document.visibilityState = 'hidden';
  working.see(seen(3, 31));
  rest();
  assert.equal(asked, 1, 'nobody sees the page');
});

test('a second worker is warmed once, and again after it was let go', () => {
  const workers = [],
    helper = new Helper(() => {
      workers.push({
        told: [],
        postMessage(message) {
          this.told.push(message);
        },
        terminate() {},
      });
      return workers.at(-1);
    });
  helper.warm();
  helper.warm();
  helper.wake();
  assert.deepEqual(workers.map(warmings), [[false]]);
  helper.stop();
  helper.warm();
  assert.deepEqual(workers.map(warmings), [[false], [false]]);
  helper.stop();
});

/** What is living of the library's solids, and of what they are made, while `work` runs. */
async function counted(work) {
  const living = new Set(),
    made = { parts: 0, unions: 0 },
    { Manifold } = library,
    { ofMesh, union } = Manifold,
    kind = Object.getPrototypeOf(Manifold.cube()),
    { delete: end, add } = kind;
  Manifold.ofMesh = (mesh) => {
    const solid = ofMesh(mesh);
    made.parts += 1;
    living.add(solid);
    return solid;
  };
  Manifold.union = (solids) => {
    made.unions += solids.length > 1 ? 1 : 0;
    return union(solids);
  };
  kind.add = function adding(other) {
    made.unions += 1;
    return add.call(this, other);
  };
  kind.delete = function ending() {
    living.delete(this);
    end.call(this);
  };
  try {
    await work(living, made);
  } finally {
    Object.assign(Manifold, { ofMesh, union });
    Object.assign(kind, { add, delete: end });
  }
}

const likely = (kernel, operands, meshes) => run(kernel.likely({ nodes: [node(operands)], meshes }));

test('what is likely to be stuck together is made beforehand: at the button nothing is, in any order, and the solid is the same', async () => {
  for (let seed = 1; seed <= 4; seed += 1) {
    const { meshes, operands } = model(seed),
      kernel = fresh();
    await likely(kernel, operands, meshes);
    await counted(async (living, made) => {
      const asked = [node(seed % 2 ? operands : operands.toReversed())],
        { mesh } = solve(kernel, asked);
      assert.deepEqual(made, { parts: 0, unions: 0 }, `seed ${seed}`);
      const anew = solve(fresh(), asked, meshes).mesh;
      near(mesh.volume, anew.volume, 1e-6, 'volume');
      assert.deepEqual(
        [mesh.genus, mesh.runs.map(({ part }) => part).sort()],
        [anew.genus, anew.runs.map(({ part }) => part).sort()],
      );
      // Its mesh went to the page, which may write on it: whoever asks again gets another one.
      mesh.positions.fill(0);
      near(solve(kernel, [node(operands)]).mesh.volume, anew.volume, 1e-6, 'asked again');
      assert.ok(solve(kernel, [{ ...asked[0], key: 'again' }]).mesh.positions.some((x) => x !== 0));
    });
  }
});

test('of what is likely some alone, others too, cut or rounded are what they are anew', async () => {
  const { meshes, operands } = model(7),
    other = rod(6, turned(2, 0.1), 'other'),
    all = { ...meshes, other: loft({ rings: 16, around: 12, radius: 0.1 }) };
  for (const [of, more] of [
    [operands.slice(0, 2), {}],
    [operands.slice(1), {}],
    [[...operands, other], {}],
    [operands, { kind: 'cut' }],
    [operands, { kind: 'common' }],
    [operands.slice(0, 3), { blend: 0.02 }],
    [operands, { coarse: true }],
  ]) {
    const kernel = fresh(),
      asked = [node(of, more)];
    await likely(kernel, operands, meshes);
    const made = solve(kernel, asked, { other: all.other }),
      anew = solve(fresh(), asked, all);
    assert.deepEqual(made.failure, anew.failure);
    if (anew.mesh) near(made.mesh.volume, anew.mesh.volume, 1e-6, JSON.stringify(more));
  }
});

test('one more part, or an edit of the same part, is one union ahead; of what was likely before nothing is left', async () => {
  await counted(async (living, made) => {
    const { meshes, operands } = model(5),
      kernel = fresh(),
      sizes = [];
    for (let count = 2; count <= operands.length; count += 1) {
      made.unions = made.parts = 0;
      await likely(kernel, operands.slice(0, count), count === 2 ? meshes : {});
      assert.deepEqual(made, { parts: count === 2 ? 2 : 1, unions: 1 }, `${count} parts`);
    }
    for (let i = 0; i < 30; i += 1) {
      made.unions = made.parts = 0;
      await likely(
        kernel,
        operands.map((each, k) => (k === 1 ? { ...each, mesh: `edit ${i}` } : each)),
        { [`edit ${i}`]: loft({ rings: 20, around: 12, radius: 0.05 + 0.001 * i }) },
      );
      if (i > 0) assert.deepEqual(made, { parts: 1, unions: 1 }, `edit ${i}`);
      sizes.push([living.size, kernel.solids.size, kernel.parts.counts.parts, kernel.parts.sources.size].join());
    }
    assert.deepEqual(new Set(sizes.slice(1)).size, 1, sizes.join(' '));
    assert.ok(kernel.parts.counts.meshes < 24, 'meshes of old edits go, too');
  });
});

test('what is likely, given up at any moment, leaves the solver as sound as a fresh one; so does a part at fault', async () => {
  const { meshes, operands } = model(9),
    anew = solve(fresh(), [node(operands)], meshes).mesh;
  for (let steps = 0; steps < 16; steps += 1) {
    const kernel = fresh();
    await run(kernel.likely({ nodes: [node(operands)], meshes }), steps);
    kernel.keepMeshes(meshes);
    near(solve(kernel, [node(operands)]).mesh.volume, anew.volume, 1e-6, `after ${steps} pieces`);
  }
  const kernel = fresh(),
    broken = { ...meshes.m1, triangles: meshes.m1.triangles.slice(3) };
  await likely(
    kernel,
    operands.map((each, i) => (i === 1 ? { ...each, mesh: 'broken' } : each)),
    { ...meshes, broken },
  );
  assert.equal(solve(kernel, [node([operands[0], { ...operands[1], mesh: 'broken' }])]).failure.part, 2);
  near(solve(kernel, [node(operands)]).mesh.volume, anew.volume, 1e-6, 'without it');
});
