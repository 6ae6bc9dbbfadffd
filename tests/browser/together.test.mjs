// Solids made on the page, with real pointers on real pictures and the real solver in its worker.
import assert from 'node:assert/strict';
import test from 'node:test';
import { measure, parseStl, validated } from './support/model_files.mjs';
import { dragMouse, drawWithMouse } from './support/hands.mjs';
import {
  done,
  exported,
  idle,
  onPage,
  openPicture,
  openWithPart,
  reload,
  run,
  state,
  toastText,
  toClient,
  useSite,
} from './support/page.mjs';
import { kRounds } from '../support/rounds.mjs';
import { samples } from './support/pictures.mjs';

const kit = useSite();
const [lemur] = samples();
/** The middle of the sample's line, moved across it: a second part that runs through the first. */
const beside = (spine) =>
  spine
    .slice(Math.floor(spine.length * 0.25), Math.ceil(spine.length * 0.75))
    .map(([x, y], i, all) => [x + 16 - (32 * i) / all.length, y + 8]);

/** The sample with its two parts. */
async function withBoth(page) {
  await openWithPart(page, lemur.bytes, lemur.spine, 'lemur');
  await run(page, 'new-part');
  await done(page, 'draw-spine', { stroke: beside(lemur.spine) });
  assert.equal((await state(page)).parts.length, 2);
}

const withTwo = (options, work) =>
  onPage(kit, options, async (page, opened) => {
    await withBoth(page);
    await work(page, opened);
  });

const steps = async (page) => (await state(page)).steps;
const root = async (page) => (await steps(page)).findLast((step) => step.root);

const measureStl = (bytes) => measure(parseStl(bytes));

/** In the page: workers that die with the next request, or get it damaged, when they are told to. */
function frailWorkers() {
  const Plain = window.Worker;
  window.endNext = false;
  window.damage = null;
  window.Worker = class extends Plain {
    postMessage(message, transfer) {
      const meshes = Object.values(message.meshes ?? {});
      if (window.damage && meshes.length > 0) {
        window.damage(meshes[0], message);
        window.damage = null;
      }
      super.postMessage(message, transfer);
      if (!window.endNext || !message.nodes) return;
      window.endNext = false;
      this.terminate();
    }
  };
}

/** Both parts stuck together. */
async function stuck(page) {
  await withBoth(page);
  await done(page, 'stick-together');
  const good = await root(page);
  assert.equal(good.status, 'ready');
  return good;
}

/** What is saved: a closed, outward STL and a GLB without a fault. */
async function lawful(page) {
  const found = measureStl(await exported(page, 'stl'));
  assert.equal(found.open, 0, 'closed');
  assert.ok(found.volume > 0, 'outward');
  await validated(await exported(page, 'glb'));
  return found;
}

/** Drags the end of a rib of a part outwards with the mouse. */
async function dragRib(page, part, by, midway) {
  await run(page, 'select-part', { id: part });
  await done(page, 'ribs');
  const { ribs } = (await state(page)).parts.find(({ id }) => id === part);
  const rib = ribs[Math.floor(ribs.length / 2)],
    away = Math.hypot(rib.left[0] - rib.center[0], rib.left[1] - rib.center[1]);
  const to = rib.left.map((x, k) => x + (by * (x - rib.center[k])) / away);
  const [from, till] = await toClient(page, [rib.left, to]);
  await dragMouse(page, from, till.x - from.x, till.y - from.y, midway);
}

test('two drawn parts are stuck together, and the solid follows a rib, undo, redo, a reload and release', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, lemur.bytes, 'lemur');
    await drawWithMouse(page, lemur.spine);
    await page.keyboard.press('n');
    await drawWithMouse(page, beside(lemur.spine));
    assert.equal((await state(page)).parts.length, 2);
    const apart = measureStl(await exported(page, 'stl')).volume;
    await done(page, 'stick-together');
    const joined = await root(page);
    assert.deepEqual([joined.kind, joined.status, joined.failure], ['join', 'ready', null]);
    assert.ok(joined.volume > 0 && joined.triangles > 1000);
    const first = await lawful(page);
    assert.ok(first.volume < apart, 'what both held is there once');

    await dragRib(page, 1, 25, async () => {
      // Parts that are only joined stand for themselves in the hand: nothing waits.
      assert.equal((await state(page)).busy, false);
    });
    const wider = await root(page);
    assert.equal(wider.status, 'ready');
    assert.ok(wider.volume > joined.volume * 1.001, `${wider.volume} is not more than ${joined.volume}`);
    await page.keyboard.press('Control+z');
    await idle(page);
    assert.ok(Math.abs((await root(page)).volume / joined.volume - 1) < 1e-5);
    await page.keyboard.press('Control+Shift+z');
    await idle(page);
    assert.ok(Math.abs((await root(page)).volume / wider.volume - 1) < 1e-5);

    await reload(page);
    assert.equal((await steps(page)).length, 1);
    assert.ok(Math.abs((await root(page)).volume / wider.volume - 1) < 1e-5, 'the solid is made again');
    await lawful(page);

    await run(page, 'select-step', { id: 1 });
    await done(page, 'release');
    const { parts, steps: left } = await state(page);
    assert.deepEqual([parts.length, left.length], [2, 0]);
  }));

test('cut, kept common and moved away: each is a solid, and sets say how large', () =>
  withTwo({}, async (page) => {
    const volumes = {};
    for (const kind of ['stick-together', 'cut', 'keep-common']) {
      await done(page, kind, { parts: [1, 2] });
      const step = await root(page);
      assert.equal(step.status, 'ready', `${kind}: ${step.sentence}`);
      volumes[kind] = step.volume;
      await lawful(page);
      if (kind !== 'keep-common') await run(page, 'undo');
    }
    await run(page, 'undo');
    await done(page, 'cut', { parts: [2, 1] });
    const other = (await root(page)).volume;
    const sum = volumes.cut + volumes['keep-common'] + other;
    assert.ok(Math.abs(sum / volumes['stick-together'] - 1) < 1e-4, `${sum} and ${volumes['stick-together']}`);
    // Away from each other nothing is cut, and nothing is shared.
    await done(page, 'move-parts', { parts: [1], mm: [0, 0, 500] });
    assert.ok((await root(page)).volume > other);
    await done(page, 'set-step', { kind: 'common' });
    const none = await root(page);
    assert.deepEqual([none.status, none.failure], ['failed', 'SolidEmpty']);
    assert.match(none.sentence, /Nothing is left/);
    assert.ok(none.triangles > 0, 'the last good one stays');
  }));

test('a scooped out part is as thin as its wall, open at its end, and says when the wall is too thick', () =>
  withTwo({}, async (page) => {
    await run(page, 'select-part', { id: 2 });
    await run(page, 'delete-part');
    await run(page, 'select-part', { id: 1 });
    await done(page, 'set-caps', { part: 1, start: 'flat', end: 'flat' });
    const full = measureStl(await exported(page, 'stl')).volume;
    const {
      parts: [{ ribs }],
      picture,
    } = await state(page);
    const widths = ribs.map(
      ({ left, right }) => Math.hypot(left[0] - right[0], left[1] - right[1]) / Math.max(picture.width, picture.height),
    );
    const wall = Math.min(0.02, widths.sort((a, b) => a - b)[widths.length >> 1] / 6);
    await done(page, 'scoop-out', { part: 1, wall, opening: 'start' });
    const hollow = await root(page);
    assert.deepEqual([hollow.kind, hollow.status], ['hollow', 'ready'], hollow.sentence);
    const found = await lawful(page);
    assert.ok(found.volume < 0.9 * full, `${found.volume} of ${full}`);
    await run(page, 'check-print');
    const { print } = await state(page);
    assert.ok(print.closed, 'the check sees a closed solid');
    const mm = wall * Math.cbrt(found.volume / hollow.volume);
    assert.ok(Math.abs(print.thinnest / mm - 1) < 0.1, `thinnest ${print.thinnest}, wall ${mm}`);

    await done(page, 'set-step', { wall: 0.4 });
    const thick = await root(page);
    assert.deepEqual([thick.status, thick.failure, thick.faulty], ['failed', 'WallTooThick', 1]);
    assert.equal(thick.at.length, 3);
    assert.match(await toastText(page), /wall is too thick.*The thickest that fits is [\d.]+ [cm]m\./);
    assert.equal(thick.triangles, hollow.triangles, 'the last good one stays');
    await done(page, 'show-trouble');
    assert.equal((await state(page)).selection, 1);
  }));

test('a worker that dies, a cancel and a deleted part each leave the model whole and say so', () =>
  onPage(kit, { scripts: [frailWorkers] }, async (page) => {
    const good = await stuck(page);

    // The browser ends the worker in the middle of a job, and tells nobody.
    await page.evaluate(() => {
      window.endNext = true;
      return window.spineloft.run('set-section', { part: 1, section: 'star' });
    });
    assert.match(await toastText(page), /interrupted/);
    await idle(page);
    const dead = await root(page);
    assert.deepEqual([dead.status, dead.failure, dead.triangles], ['failed', 'SolverStopped', good.triangles]);
    await done(page, 'solve-again');
    assert.equal((await root(page)).status, 'ready');

    // Stopped by hand.
    const before = await root(page);
    await page.evaluate(async () => {
      await window.spineloft.run('set-section', { part: 1, section: 'square' });
      window.spineloft.state();
      await window.spineloft.run('cancel');
    });
    await idle(page);
    const stopped = await root(page);
    assert.ok(
      stopped.failure === 'Cancelled' ? stopped.triangles === before.triangles : stopped.status === 'ready',
      JSON.stringify(stopped),
    );
    await done(page, 'solve-again').catch(() => {});
    assert.equal((await root(page)).status, 'ready');

    // A part that goes while it is put together.
    await page.evaluate(async () => {
      await window.spineloft.run('set-section', { part: 1, section: 'circle' });
      window.spineloft.state();
      await window.spineloft.run('select-part', { id: 2 });
      await window.spineloft.run('delete-part');
    });
    await idle(page);
    const { parts, steps: none, busy } = await state(page);
    assert.deepEqual([parts.length, none.length, busy], [1, 0, false]);
    await done(page, 'undo');
    assert.equal((await root(page)).status, 'ready');
    await lawful(page);
  }));

test('a mesh that arrives damaged names its part, and one that breaks the solver down leaves the model whole', () =>
  onPage(kit, { scripts: [frailWorkers] }, async (page, { troubles }) => {
    const good = await stuck(page);

    // A face is missing: the library refuses the part.
    await page.evaluate(() => {
      window.damage = (mesh) => {
        mesh.triangles = mesh.triangles.slice(3);
      };
    });
    await dragRib(page, 1, 25);
    const damaged = await root(page);
    assert.deepEqual(
      [damaged.status, damaged.failure, damaged.faulty, damaged.triangles],
      ['failed', 'SolidFailed', 1, good.triangles],
    );
    const { name } = (await state(page)).parts.find(({ id }) => id === 1);
    assert.ok((await toastText(page)).includes(name), await toastText(page));
    // The next edit is as if nothing had been.
    await dragRib(page, 1, 12);
    const mended = await root(page);
    assert.deepEqual([mended.status, mended.failure], ['ready', null]);

    // The solver itself breaks down on what it is given.
    await page.evaluate(() => {
      window.damage = (mesh, message) => {
        message.nodes = [null];
      };
    });
    await dragRib(page, 1, 30);
    assert.match(await toastText(page), /interrupted/);
    const broken = await root(page);
    assert.deepEqual([broken.status, broken.failure, broken.triangles], ['failed', 'SolverStopped', mended.triangles]);
    await dragRib(page, 1, 20);
    assert.equal((await root(page)).status, 'ready');
    await lawful(page);
    // Of its end the browser writes to the console.
    troubles.splice(0);
  }));

/** A first share of what a model is opened and closed; in all it is five of them. */
const kOpenings = Math.min(10, 4 * kRounds);

test(`opening and closing a model with solids ${5 * kOpenings} times leaves the memory as it was`, () =>
  withTwo({}, async (page) => {
    await run(page, 'stick-together');
    await done(page, 'scoop-out', { step: 1, wall: 0.01 });
    const session = await page.context().newCDPSession(page);
    /** Bytes that the page's JavaScript holds on to, once everything that can go has gone. */
    const heap = async () => {
      for (let i = 0; i < 2; i += 1) await session.send('HeapProfiler.collectGarbage');
      return (await session.send('Runtime.getHeapUsage')).usedSize;
    };
    await page.evaluate(
      (text) => {
        window.kept = new Blob([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))]);
      },
      (await exported(page, 'spineloft')).toString('base64'),
    );
    /** The model is opened and closed so often; what the memories have grown to then. */
    const after = async (rounds) => {
      const sizes = await page.evaluate(async (count) => {
        for (let round = 0; round < count; round += 1) {
          await window.spineloft.openProject(window.kept);
          await window.spineloft.idle();
          if (window.spineloft.state().steps.some(({ root: outermost, status }) => outermost && status !== 'ready'))
            throw new Error(`round ${round}`);
          await window.spineloft.run('new-model');
          await window.spineloft.idle();
        }
        return window.spineloft.memory();
      }, rounds);
      return { ...sizes, heap: await heap() };
    };
    // What is kept for undo and for the next edit fills in the first rounds; from then on nothing may grow. What JavaScript
    // runs and remembers of it settles later, and every round keeps one more model in the browser: its list has a line more.
    const before = await after(kOpenings),
      settled = await after(kOpenings),
      last = await after(3 * kOpenings);
    const isSame = (what, from) =>
      assert.ok(last[what] <= 1.05 * from[what], `${what}: ${from[what]} to ${last[what]} bytes`);
    isSame('engine', before);
    isSame('solver', before);
    isSame('heap', settled);
  }));

test('the solver is there before it is asked, in a model of two parts that is worked at; not for one part, nor where one only looks', () =>
  onPage(kit, { alone: true }, async (page) => {
    // After the threads of the engine, which are there from the start.
    const threads = page.workers().length;
    const workers = () => page.workers().slice(threads);
    await openWithPart(page, lemur.bytes, lemur.spine, 'lemur');
    await page.waitForTimeout(500);
    assert.deepEqual(workers(), [], 'there is nothing to stick together');
    await run(page, 'new-part');
    await done(page, 'draw-spine', { stroke: beside(lemur.spine) });
    const first = workers()[0] ?? (await page.waitForEvent('worker'));
    await done(page, 'stick-together');
    assert.equal((await root(page)).status, 'ready');
    assert.deepEqual(workers(), [first], 'it is the one that was started');
    await done(page, 'undo');
    await reload(page);
    await page.waitForTimeout(500);
    assert.deepEqual(workers(), [], 'the model is only looked at');
  }));
