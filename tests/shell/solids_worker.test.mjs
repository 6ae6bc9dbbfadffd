// The page's side of the solver: one worker, what it is told, and its end.
import assert from 'node:assert/strict';
import test from 'node:test';
import { shell } from '../browser/support/solids.mjs';
import { FakeWorker } from './support/fake_worker.mjs';

const { Solver, isSolidLikely, meshesAt } = shell;

const memory = (workers, answers) => ({
  start: () => {
    workers.push(new FakeWorker());
    return workers.at(-1);
  },
  answer: (json, bytes) => answers.push({ ...JSON.parse(json), bytes }),
});
/** What a worker was asked to solve. */
const requestsOf = ({ asked }) => asked.filter(({ meshes }) => meshes);
/** A mesh in the engine's memory, which changes afterwards. */
const solveEvent = (id, key = 'a') => ({
  id,
  meshes: [{ key, mesh: { positions: new Float32Array(12), uv: new Float32Array(8), triangles: new Uint32Array(12) } }],
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
  assert.ok(workers[0].ended);
  const again = solveEvent(4, 'b');
  solver.ask(solveEvent(3));
  solver.ask(again);
  const [first, second] = requestsOf(workers[1]);
  assert.deepEqual(Object.keys(first.meshes), ['a']);
  again.meshes[0].mesh.positions.fill(7);
  assert.ok(
    second.meshes.b.positions.every((x) => x === 0),
    'it is copied while the engine asks',
  );
});

test('meshes are read from the memory of the engine as it lays them out; one without uv has none', () => {
  const buffer = new ArrayBuffer(256),
    floats = new Float32Array(buffer),
    numbers = new Uint32Array(buffer);
  // Two meshes: vertices, triangles, and where positions, uv and corners are.
  numbers.set([2, 1, 64, 96, 128, 1, 1, 160, 0, 176], 2);
  floats.set([1, 2, 3, 4, 5, 6], 16);
  floats.set([0.1, 0.2, 0.3, 0.4], 24);
  numbers.set([1, 0, 1], 32);
  floats.set([7, 8, 9], 40);
  numbers.set([0, 0, 0], 44);
  const [first, second, ...others] = meshesAt(buffer, 8, ['a', 'b']);
  assert.deepEqual(first, {
    key: 'a',
    mesh: {
      positions: Float32Array.of(1, 2, 3, 4, 5, 6),
      uv: Float32Array.of(0.1, 0.2, 0.3, 0.4),
      triangles: Uint32Array.of(1, 0, 1),
    },
  });
  assert.deepEqual([second.key, [...second.mesh.positions], second.mesh.uv.length], ['b', [7, 8, 9], 0]);
  assert.deepEqual(others, []);
  assert.deepEqual(meshesAt(buffer, 0, []), []);
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

test('a worker is started before it is asked, once; not after one has died or was stopped', () => {
  const workers = [],
    solver = new Solver(memory(workers, []));
  solver.start();
  solver.start();
  solver.ask(solveEvent(1));
  assert.equal(workers.length, 1, 'the one that was started is asked');
  workers[0].onerror({});
  solver.start();
  assert.equal(workers.length, 1, 'what died for want of memory is not started again unasked');
  solver.ask(solveEvent(2));
  assert.equal(workers.length, 2);
  solver.stop();
  solver.start();
  assert.equal(workers.length, 2);
});

test('a worker that dies is said and started anew; a hundred cancels leave nothing behind', () => {
  const workers = [],
    answers = [],
    solver = new Solver(memory(workers, answers));
  solver.ask(solveEvent(1));
  workers[0].onerror({});
  assert.deepEqual(answers, [{ lost: true, loaded: false, bytes: null }]);
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

test('a worker that cannot start is said at the first request, and tried again at the next', () => {
  const workers = [],
    answers = [],
    host = memory(workers, answers);
  let isRefused = true;
  const solver = new Solver({
    ...host,
    start: () => {
      if (isRefused) throw new Error('no workers here');
      return host.start();
    },
  });
  solver.start();
  assert.deepEqual(answers, []);
  solver.ask(solveEvent(1));
  assert.deepEqual(answers, [{ lost: true, loaded: false, bytes: null }]);
  isRefused = false;
  solver.ask(solveEvent(2));
  assert.deepEqual(Object.keys(requestsOf(workers[0])[0].meshes), ['a']);
});

test('a solid is likely in a model of two parts that is worked at, or where parts are ticked; not where one only looks', () => {
  const seen = (parts, undo, picked = 0) => ({ parts, picked, undo });
  assert.ok(isSolidLikely(seen(1, 3), seen(2, 4)), 'a part was drawn');
  assert.ok(isSolidLikely(seen(5, 1), seen(5, 1, 1)), 'a part is ticked');
  assert.ok(!isSolidLikely(seen(0, 0), seen(1, 1)), 'there is nothing to stick to');
  assert.ok(!isSolidLikely(null, seen(5, 1)) && !isSolidLikely(seen(0, 0), seen(2, 1)), 'a model was opened');
  assert.ok(
    !isSolidLikely(seen(2, 4), seen(2, 4)) && !isSolidLikely(seen(2, 4), seen(2, 3)),
    'nothing was done, or undone',
  );
});
