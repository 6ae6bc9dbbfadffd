// What cuts out: the program itself, and the page's side of its worker.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { cutOutFile } from '../../.ci/lib/site.mjs';
import { FakeWorker } from './support/fake_worker.mjs';
import { load } from './support/load.mjs';

const [{ CutOut }, { Cutter }, { cutEventAt }, { isCutOutLikely }] = await Promise.all(
  ['cut_out/program.ts', 'cut_out/cutter.ts', 'engine_workers.ts', 'warm_up.ts'].map(load),
);
const program = await CutOut.load(readFileSync(cutOutFile));

/** A red disc on blue ground, both with grain; the original is twice as large. */
function disc({ width = 160, height = 120, radius = 40 } = {}) {
  const rgba = new Uint8Array(4 * width * height);
  for (let i = 0; i < width * height; i += 1) {
    const inside = Math.hypot((i % width) - width / 2, Math.floor(i / width) - height / 2) < radius;
    const grain = (i * 7919) % 25;
    rgba.set([...(inside ? [200, 60, 40] : [150, 190, 220]).map((v) => v + grain), 255], 4 * i);
  }
  return { width, height, originalWidth: 2 * width, originalHeight: 2 * height, rgba };
}

/** Hints as engine/vision/cut_out_numbers.h lays them out. */
const hints = ({ inside = [], outside = [], box = null, marks = [] }) => {
  const line = (points) => [points.length, ...points.flat()];
  const mark = ({ points, radius, within }) => [...line(points), radius, Number(within)];
  return Float64Array.of(
    ...line(inside),
    ...line(outside),
    ...(box ? [1, ...box.flat()] : [0]),
    marks.length,
    ...marks.flatMap(mark),
  );
};

/** The rounds of a search and the outlines that it found; or the number of its error. */
function search(numbers) {
  const rounds = [],
    running = program.search(numbers);
  let step = running.next();
  for (; !step.done; step = running.next()) rounds.push(step.value);
  const [kind, ...rest] = step.value;
  const contours = [];
  while (kind === 0 && rest.length > 0) {
    const flat = rest.splice(0, 1 + 2 * rest[0]).slice(1);
    contours.push(Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1]]));
  }
  return { rounds, kind, contours };
}

function areaOf(points) {
  const twice = points.reduce((sum, [x, y], i) => {
    const [px, py] = points.at(i - 1);
    return sum + px * y - x * py;
  }, 0);
  return Math.abs(twice) / 2;
}

test('the program cuts out what hints say, round by round, and the same each time', () => {
  program.show(disc());
  const tap = search(hints({ inside: [[160, 120]] }));
  assert.equal(tap.kind, 0);
  assert.ok(tap.rounds.length > 1 && tap.rounds.every((done, i) => done > (tap.rounds[i - 1] ?? 0) && done < 1));
  assert.equal(tap.contours.length, 1);
  const area = areaOf(tap.contours[0]);
  assert.ok(Math.abs(area / (Math.PI * 80 ** 2) - 1) < 0.03, `${area} original pixels`);
  assert.deepEqual(search(hints({ inside: [[160, 120]] })), tap);
  const box = [
    [70, 30],
    [250, 210],
  ];
  const boxed = search(hints({ box }));
  assert.ok(Math.abs(areaOf(boxed.contours[0]) / area - 1) < 0.03);
  const points = [
    [160, 200],
    [160, 230],
  ];
  const more = search(hints({ box, marks: [{ points, radius: 12, within: true }] }));
  const now = more.contours.reduce((sum, contour) => sum + areaOf(contour), 0);
  assert.ok(now > area + 300 && now < 1.2 * area, `a mark adds: ${area} to ${now}`);
});

test('another picture takes the place of the last one; where nothing is found an error says so, and it goes on', () => {
  program.show(disc({ radius: 0 }));
  const nothing = search(hints({ inside: [[160, 120]] }));
  assert.ok(nothing.kind > 0 && nothing.contours.length === 0);
  const beside = search(hints({ inside: [[9000, 120]] }));
  assert.ok(beside.kind > 0 && beside.kind !== nothing.kind, 'the errors differ');
  assert.equal(search(Float64Array.of(5, 5)).kind, beside.kind, 'numbers that are no hints');
  const before = program.memory;
  for (let round = 0; round < 10; round += 1) {
    program.show(disc({ width: 200, height: 100, radius: 30 }));
    const { contours } = search(hints({ inside: [[200, 100]] }));
    assert.ok(Math.abs(areaOf(contours[0]) / (Math.PI * 60 ** 2) - 1) < 0.05);
  }
  assert.ok(program.memory <= before + 2 ** 21, `${before} to ${program.memory} bytes`);
});

function desk() {
  const workers = [],
    answers = [];
  const host = {
    isRefused: false,
    start() {
      if (this.isRefused) throw new Error('no workers here');
      workers.push(new FakeWorker());
      return workers.at(-1);
    },
    answer: (answer) => answers.push(answer),
  };
  return { workers, answers, host, cutter: new Cutter(host) };
}
const kinds = { progress: 0, found: 1, stopped: 2, unreachable: 3 };
const event = (id, key = 'a') => ({
  id,
  key,
  hints: Float64Array.of(1, 2, 3),
  picture: { width: 2, height: 1, originalWidth: 4, originalHeight: 2, rgba: new Uint8Array(8) },
});

test('a picture goes to the worker once, as it is when the engine asks, and again to a fresh one', () => {
  const { workers, cutter } = desk();
  const first = event(1);
  cutter.ask(first);
  first.picture.rgba.fill(9);
  first.hints.fill(9);
  cutter.ask(event(2));
  cutter.ask(event(3, 'b'));
  cutter.ask(event(4));
  const [asked] = workers;
  assert.deepEqual(
    asked.asked.map(({ id, picture }) => [id, picture !== null]),
    [
      [1, true],
      [2, false],
      [3, true],
      [4, true],
    ],
  );
  assert.deepEqual([...asked.asked[0].picture.rgba], Array(8).fill(0));
  assert.deepEqual([...asked.asked[0].hints], [1, 2, 3]);
  asked.onerror({});
  cutter.ask(event(5));
  assert.equal(workers.length, 2);
  assert.ok(asked.ended && workers[1].asked[0].picture !== null);
});

test('what the worker says goes to the engine; who stops waiting keeps the worker, and it hears so', () => {
  const { workers, answers, cutter } = desk();
  cutter.ask(event(1));
  const [worker] = workers;
  const say = (data) => worker.onmessage({ data });
  say({ type: 'ready' });
  say({ type: 'alive' });
  say({ type: 'progress', id: 1, done: 0.25 });
  say({ type: 'found', id: 1, found: Float64Array.of(0), bytes: 77 });
  assert.deepEqual(answers, [
    { id: 1, kind: kinds.progress, done: 0.25, found: null },
    { id: 1, kind: kinds.found, done: 1, found: Float64Array.of(0) },
  ]);
  assert.equal(cutter.memory, 77);
  cutter.ask(event(2));
  cutter.stop();
  assert.deepEqual(worker.asked.at(-1), { stop: true });
  assert.equal(worker.ended, false);
});

test('a worker that ends is told apart from one that was never there, once, and only where somebody waits', async () => {
  const { workers, answers, host, cutter } = desk();
  cutter.start();
  cutter.start();
  assert.equal(workers.length, 1, 'it is started before it is asked');
  cutter.ask(event(1));
  workers[0].onerror({});
  await null;
  assert.deepEqual(answers.splice(0), [{ id: 1, kind: kinds.unreachable, done: 0, found: null }]);
  cutter.start();
  assert.equal(workers.length, 1, 'what died is started by a request alone');
  cutter.ask(event(2));
  workers[1].onmessage({ data: { type: 'ready' } });
  workers[1].onerror({});
  await null;
  assert.deepEqual(answers.splice(0), [{ id: 2, kind: kinds.stopped, done: 0, found: null }]);
  host.isRefused = true;
  cutter.ask(event(3));
  assert.deepEqual(answers, [], 'never from within a call of the engine');
  await null;
  assert.deepEqual(answers.splice(0), [{ id: 3, kind: kinds.unreachable, done: 0, found: null }]);
  host.isRefused = false;
  cutter.ask(event(4));
  cutter.stop();
  workers[2].onerror({});
  await null;
  assert.deepEqual(answers, []);
});

test('a request is read from the memory of the engine as it lays it out', () => {
  const buffer = new ArrayBuffer(128);
  new Float64Array(buffer, 16, 3).set([1.5, -2, 3]);
  new Int32Array(buffer, 64, 4).set([2, 1, 40, 20]);
  new Uint8Array(buffer, 100, 8).set([1, 2, 3, 4, 5, 6, 7, 8]);
  assert.deepEqual(cutEventAt(buffer, 7, 'key', { hints: 16, count: 3, sizes: 64, rgba: 100 }), {
    id: 7,
    key: 'key',
    hints: Float64Array.of(1.5, -2, 3),
    picture: {
      width: 2,
      height: 1,
      originalWidth: 40,
      originalHeight: 20,
      rgba: Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 8),
    },
  });
});

test('a cut-out becomes likely when a tool that cuts out is taken in hand on a picture, and not again while it stays', () => {
  const seen = (tool, picture = {}) => ({ tool, picture });
  assert.ok(isCutOutLikely(null, seen('puff')) && isCutOutLikely(seen('draw'), seen('sheet')));
  assert.ok(isCutOutLikely(seen('puff', null), seen('puff')));
  assert.ok(!isCutOutLikely(seen('puff'), seen('sheet')) && !isCutOutLikely(null, seen('draw')));
  assert.ok(!isCutOutLikely(null, seen('puff', null)));
});
