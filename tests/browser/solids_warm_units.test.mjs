// A solver that is likely to be needed makes itself quick beforehand, and nothing of that is left.
import assert from 'node:assert/strict';
import test from 'node:test';
import { fresh, library, loft, near, node, rod, seeded, shell, solve, turned } from './support/solids.mjs';

const { Helper, SolidKernel, Solver, rehearse, solidWorkersFor, wasWorkedAt } = shell;

/** Goes through it as a worker does: whatever came in between is let in. */
async function run(work, steps = Infinity) {
  for (let left = steps; left > 0 && !work.next().done; left -= 1) await new Promise((resolve) => setImmediate(resolve));
  work.return();
}

/** Notes what methods of the solver return while `work` runs. */
async function noted(names, work) {
  const found = Object.fromEntries(names.map((name) => [name, []])), before = names.map((name) => SolidKernel.prototype[name]);
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
    names.forEach((name, i) => { SolidKernel.prototype[name] = before[i]; });
  }
  return found;
}

/** Five parts in one solid, ready for an edit of the second one. */
function model(seed) {
  const random = seeded(seed), meshes = Object.fromEntries([0, 1, 2, 3, 4].map((i) => [`m${i}`, loft({ rings: 20, around: 12, radius: 0.06 + 0.05 * random(), bend: random() - 0.5 })]));
  const operands = Object.keys(meshes).map((mesh, i) => rod(i + 1, turned(6 * random(), 0.3 * random(), 0.3 * random()), mesh));
  return { meshes, operands };
}

test('a rehearsal goes every way that unions and edits go: a half by another, edits with what is near, the mesh that goes back', async () => {
  const found = await noted(['unite', 'takeShare', 'withNear', 'meshOf'], () => run(rehearse(library)));
  const rounds = found.unite.length;
  assert.ok(rounds > 1, `${rounds} rounds`);
  assert.ok(found.unite.every((union) => union?.faces.triVerts.length > 0), 'the second worker made its half');
  assert.equal(found.takeShare.length, rounds, 'and the first one took it');
  assert.ok(found.withNear.length > rounds && found.withNear.every((made) => made?.faces), 'every edit has to do with what is near alone');
  assert.ok(found.meshOf.length >= 2 * rounds && found.meshOf.every(({ genus, runs }) => genus === 0 && runs.length > 3), 'all rods are one solid');
});

test('a rehearsal, also one given up at any moment, leaves no solid behind', async () => {
  const living = new Set(), { ofMesh } = library.Manifold, kind = Object.getPrototypeOf(library.Manifold.cube()), { delete: end } = kind;
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
    const { meshes, operands } = model(3), kernel = fresh();
    solve(kernel, [node(operands)], meshes);
    const before = living.size, sources = kernel.sources.size;
    assert.ok(before >= operands.length, 'solids are counted');
    for (let steps = 1; steps < 16; steps += 1) {
      kernel.tries = 0;
      await run(kernel.ahead(2), steps);
      assert.deepEqual([living.size, kernel.sources.size], [before, sources], `an edit tried out for ${steps} pieces`);
    }
  } finally {
    library.Manifold.ofMesh = ofMesh;
    kind.delete = end;
  }
});

test('an edit is tried out before the first one, in pieces, and never again; the solid is the same', async () => {
  for (let seed = 1; seed <= 6; seed += 1) {
    const { meshes, operands } = model(seed), kernel = fresh(), kind = seed % 3 === 0 ? 'cut' : 'join';
    solve(kernel, [node(operands, { kind })], meshes);
    const { meshOf } = await noted(['meshOf'], () => run(kernel.ahead(2)));
    assert.ok(meshOf.length > 1, 'more than once');
    const { meshOf: again } = await noted(['meshOf'], () => run(kernel.ahead(4)));
    assert.equal(again.length, 0, 'for another part it is as quick');
    const edit = [node(operands.map((each, i) => (i === 3 ? { ...each, mesh: 'edit' } : each)), { kind })], given = { ...meshes, edit: loft({ rings: 22, around: 12, radius: 0.08 }) };
    const made = solve(kernel, edit, given), anew = solve(fresh(), edit, given);
    near(made.mesh.volume, anew.mesh.volume, 1e-6, `seed ${seed}: volume`);
    assert.equal(made.mesh.genus, anew.mesh.genus);
  }
});

test('a part at fault is no obstacle to what is tried out', async () => {
  const { meshes, operands } = model(2), kernel = fresh();
  solve(kernel, [node(operands)], meshes);
  // It goes through itself, and is mended.
  const edit = [node(operands.map((each, i) => (i === 1 ? { ...each, mesh: 'coil' } : each)))], coil = loft({ rings: 60, around: 24, length: 3, radius: 0.12, bend: 7 });
  kernel.tries = 0;
  assert.equal(solve(kernel, edit, { coil }).failure, undefined);
  await run(kernel.ahead(2));
  near(solve(kernel, [{ ...edit[0], key: 'once more' }]).mesh.volume, solve(fresh(), edit, { ...meshes, coil }).mesh.volume, 1e-6, 'volume');
});

function pageSide() {
  const workers = [];
  const start = () => {
    workers.push({ told: [], postMessage(message) { this.told.push(message); }, terminate() { this.ended = true; } });
    return workers.at(-1);
  };
  return { workers, solver: new Solver({ start, floats: (at, count) => new Float32Array(count), integers: (at, count) => new Uint32Array(count), answer: () => {} }) };
}
const warmings = ({ told }) => told.filter(({ warm }) => warm).map(({ warm }) => warm.large);

test('a worker is started before it is asked, once; not while it works, and not after one has died or was stopped', () => {
  const { workers, solver } = pageSide();
  solver.warm(false);
  solver.warm(true);
  assert.deepEqual(workers.map(warmings), [[false, true]]);
  solver.ask({ type: 'solve', id: 1, meshes: [], nodes: [], wanted: [] });
  solver.warm(true);
  assert.deepEqual(workers.map(warmings), [[false, true]], 'the one that was warmed is asked, and left alone meanwhile');
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
  const parts = (count, triangles) => Array.from({ length: count }, () => ({ triangles })), picked = (count) => Array.from({ length: count }, (_, i) => ({ part: i + 1 }));
  const workers = (count, triangles, of, isWorkedAt) => solidWorkersFor({ parts: parts(count, triangles), picked: picked(of), undo: 5 }, isWorkedAt);
  assert.equal(workers(10, 8000, 0, false), 0, 'it is only looked at');
  assert.equal(workers(1, 8000, 0, true), 0, 'there is nothing to stick to');
  assert.deepEqual([workers(2, 8000, 0, true), workers(2, 8000, 2, true), workers(10, 8000, 0, true), workers(10, 8000, 1, false)], [1, 1, 1, 1]);
  assert.equal(workers(10, 100, 5, false), 1, 'small ones are made by one worker');
  assert.deepEqual([workers(10, 8000, 2, false), workers(4, 3001, 2, true)], [2, 2]);
  const seen = (count, undo) => ({ parts: parts(count, 8000), picked: [], undo });
  assert.ok(wasWorkedAt(seen(1, 3), seen(2, 4)), 'a part was drawn');
  assert.ok(!wasWorkedAt(seen(0, 0), seen(2, 1)), 'a model was opened, with the step that its history holds');
  assert.ok(!wasWorkedAt(seen(2, 4), seen(2, 4)) && !wasWorkedAt(seen(2, 4), seen(2, 3)), 'nothing was done, or undone');
});

test('a second worker is warmed once, and again after it was let go', () => {
  const workers = [], helper = new Helper(() => {
    workers.push({ told: [], postMessage(message) { this.told.push(message); }, terminate() {} });
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
