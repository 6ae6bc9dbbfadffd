// Parts taken in hand in the solid view with real pointers and keys: gizmo, body, two fingers, copies, groups, numbers.
import assert from 'node:assert/strict';
import test from 'node:test';
import { exported, idle, onPage, openPicture, run, state, useSite } from './support/page.mjs';
import { samples, tubePicture } from './support/pictures.mjs';

const kit = useSite();
const [lemur] = samples();

/** The first sample with its part in hand. */
async function withPart(work, options = {}) {
  await onPage(kit, options, async (page) => {
    await openPicture(page, lemur.bytes, 'lemur');
    await run(page, 'draw-spine', { stroke: lemur.spine });
    await idle(page);
    await run(page, 'move');
    await idle(page);
    await work(page);
  });
}

const part = async (page, i = 0) => (await state(page)).parts[i];
const length = (v) => Math.hypot(...v);

/** A point of the canvas in client pixels. */
async function onCanvas(page, [x, y]) {
  const box = await page.locator('canvas').first().boundingBox();
  return { x: box.x + x, y: box.y + y };
}

async function knob(page, handle) {
  const { gizmo } = await state(page);
  assert.ok(gizmo, 'there is a gizmo');
  return onCanvas(page, gizmo.knobs.find((one) => one.handle === handle).at);
}

async function dragMouse(page, from, dx, dy, midway) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let i = 1; i <= 6; ++i) await page.mouse.move(from.x + (dx * i) / 6, from.y + (dy * i) / 6);
  if (midway) await midway();
  await page.mouse.up();
  await idle(page);
}

/** Fingers from some points to others, all at once. */
async function dragFingers(page, from, to) {
  const session = await page.context().newCDPSession(page);
  const send = (type, points) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map((p, id) => ({ ...p, id })) });
  for (let n = 1; n <= from.length; ++n) await send('touchStart', from.slice(0, n));
  for (let i = 1; i <= 6; ++i) {
    await send(
      'touchMove',
      from.map((p, k) => ({ x: p.x + ((to[k].x - p.x) * i) / 6, y: p.y + ((to[k].y - p.y) * i) / 6 })),
    );
  }
  await send('touchEnd', []);
  await session.detach();
  await idle(page);
}

test('an arrow moves a part along its axis in one step, Esc takes a drag back, and undo is exact', () =>
  withPart(async (page) => {
    const before = await state(page);
    const arrow = await knob(page, 'y');
    await dragMouse(page, arrow, 0, -40, async () => {
      assert.ok((await state(page)).gizmo.held);
      await page.keyboard.press('Escape');
    });
    assert.deepEqual((await part(page)).placement.move, [0, 0, 0]);
    assert.equal((await state(page)).undo, before.undo);
    await dragMouse(page, await knob(page, 'y'), 0, -40);
    const { placement } = await part(page);
    assert.ok(placement.move[1] > 0.02, `${placement.move}`);
    assert.equal(placement.move[0], 0);
    assert.equal((await state(page)).undo, before.undo + 1);
    await run(page, 'undo');
    assert.deepEqual((await part(page)).placement, before.parts[0].placement);
  }));

test('the ring turns, the lower right knob grows, the middle moves in the plane of the view', () =>
  withPart(async (page) => {
    const ring = await knob(page, 'turn-y');
    await dragMouse(page, ring, 45, 12);
    const turned = (await part(page)).placement;
    assert.ok(Math.abs(turned.degrees[1]) > 5, `${turned.degrees}`);
    const corner = await knob(page, 'scale');
    await dragMouse(page, corner, 40, 40);
    assert.ok((await part(page)).placement.scale > 1.2);
    await dragMouse(page, await knob(page, 'plane'), -50, 20);
    assert.ok(length((await part(page)).placement.move) > 0.02);
    const { undo } = await state(page);
    for (let i = 0; i < 3; ++i) await run(page, 'undo');
    assert.equal((await state(page)).undo, undo - 3);
    assert.deepEqual((await part(page)).placement.turn, [1, 0, 0, 0]);
  }));

test('a finger drags the body, two fingers turn and grow it', () =>
  withPart(
    async (page) => {
      const middle = await knob(page, 'plane');
      await dragFingers(page, [middle], [{ x: middle.x + 40, y: middle.y }]);
      assert.ok(length((await part(page)).placement.move) > 0.02);
      const at = await knob(page, 'plane');
      await dragFingers(
        page,
        [at, { x: at.x + 60, y: at.y }],
        [
          { x: at.x - 20, y: at.y - 10 },
          { x: at.x + 80, y: at.y + 40 },
        ],
      );
      const { placement } = await part(page);
      assert.ok(placement.scale > 1.3, `${placement.scale}`);
      assert.ok(length(placement.degrees) > 5, `${placement.degrees}`);
    },
    { hasTouch: true },
  ));

test('arrow keys move by a millimetre, with shift by ten', () =>
  withPart(async (page) => {
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Shift+ArrowUp');
    await idle(page);
    const { placement } = await part(page);
    assert.ok(Math.abs(placement.mm[1] - 11) < 0.02, `${placement.mm}`);
  }));

test('copies, mirrored copies, symmetry and groups by keys and commands; a typed place reads back', () =>
  withPart(async (page) => {
    await page.keyboard.press('Control+d');
    await idle(page);
    let now = await state(page);
    assert.equal(now.parts.length, 2);
    assert.deepEqual(now.selected, [2]);
    await run(page, 'mirror-copy', { axis: 'x' });
    await run(page, 'symmetry', { axis: 'z' });
    await idle(page);
    now = await state(page);
    assert.ok(now.parts.some((one) => one.placement.mirrored) && now.parts.some((one) => one.mirror));
    const glb = await exported(page, 'glb');
    assert.ok(glb.length > 1000);
    await page.keyboard.press('Control+a');
    await page.keyboard.press('Control+g');
    await idle(page);
    now = await state(page);
    assert.equal(now.groups.length, 1);
    assert.equal(new Set(now.parts.map((one) => one.group)).size, 1);
    await page.keyboard.press('Control+Shift+G');
    await run(page, 'set-place', { part: 1, x: 12.5, turn: 30 });
    await idle(page);
    const { placement } = await part(page);
    assert.ok(Math.abs(placement.mm[0] - 12.5) < 0.02, `${placement.mm}`);
    assert.ok(Math.abs(placement.degrees[1] - 30) < 1e-6);
  }));

test('the first part of a further picture stands beside the others, in the step that draws it', () =>
  withPart(async (page) => {
    await openPicture(page, samples()[1].bytes, 'second');
    const { undo } = await state(page);
    await run(page, 'draw-spine', { stroke: samples()[1].spine });
    await idle(page);
    const now = await state(page);
    assert.equal(now.undo, undo + 1);
    assert.ok(now.parts[1].placement.move[0] > 0.05, `${now.parts[1].placement.move}`);
    await run(page, 'undo');
    assert.equal((await state(page)).parts.length, 1);
  }));

/** Corners of every part in its place, by an OBJ: millimetres, y up, z to the front. */
async function corners(page) {
  const parts = (await exported(page, 'obj'))
    .toString('utf8')
    .split(/^o .*$/m)
    .slice(1);
  return parts.map((text) => [...text.matchAll(/^v (\S+) (\S+) (\S+)/gm)].map(([, ...at]) => at.map(Number)));
}

const extent = (points, k) => {
  const along = points.map((p) => p[k]);
  return [Math.min(...along), Math.max(...along)];
};

test('with Snap on, a part that is dragged over another one comes to lie on its surface; without, it goes into it', () =>
  onPage(kit, {}, async (page) => {
    const tube = tubePicture();
    await openPicture(page, tube.png, 'tube.png');
    await run(page, 'draw-spine', { stroke: tube.middle.slice(14, 41) });
    await run(page, 'duplicate');
    await run(page, 'move');
    await idle(page);
    const {
      placement: { move: away },
    } = await part(page, 1);
    await run(page, 'select-part', { id: 1 });
    await idle(page);
    const target = await knob(page, 'plane');
    for (const snap of [false, true]) {
      await run(page, 'select-part', { id: 2 });
      await idle(page);
      if (snap) await page.keyboard.press('Shift+S');
      assert.equal((await state(page)).snap, snap);
      const from = await knob(page, 'plane');
      await dragMouse(page, from, target.x - from.x, target.y - from.y);
      assert.ok(length((await part(page, 1)).placement.move.map((x, k) => x - away[k])) > 0.02, 'it was dragged');
      const [still, dragged] = await corners(page);
      const [low, high] = extent(still, 2),
        [back, front] = extent(dragged, 2),
        thick = high - low,
        gap = Math.max(back - high, low - front);
      await run(page, 'keep-common', { parts: [1, 2] });
      await idle(page);
      const { status, failure, volume } = (await state(page)).steps[0];
      await run(page, 'undo');
      if (snap) {
        assert.ok(Math.abs(gap) < 0.05 * thick, `${gap} mm between parts of ${thick}`);
        assert.ok(failure === 'SolidEmpty' || volume < 1e-7, `${status}: they have ${volume} in common`);
      } else {
        assert.ok(gap < -0.2 * thick, `${gap} mm between parts of ${thick}`);
        assert.ok(status === 'ready' && volume > 1e-4, `${status}: ${volume}`);
      }
      await run(page, 'undo');
      await idle(page);
    }
  }));

test('Face front turns a part back as it was drawn, from wherever it is seen and however it is turned', () =>
  withPart(async (page) => {
    const [drawn] = await corners(page);
    for (const [i, angles] of [{ turn: 90 }, { tip: -35, turn: 120 }, { tip: 20, turn: -75, lean: 160 }].entries()) {
      await run(page, 'set-place', { part: 1, ...angles });
      for (let k = 0; k < i; k += 1) await run(page, k % 2 ? 'turn-up' : 'turn-left');
      await idle(page);
      const [turned] = await corners(page);
      assert.ok(
        [0, 1, 2].some(
          (k) =>
            Math.abs((extent(turned, k)[1] - extent(turned, k)[0]) / (extent(drawn, k)[1] - extent(drawn, k)[0]) - 1) >
            0.05,
        ),
        'it is turned',
      );
      await page.keyboard.press('Shift+H');
      await idle(page);
      const { placement } = await part(page);
      assert.ok(
        placement.degrees.every((angle) => Math.abs(angle) < 1e-3),
        `${placement.degrees}`,
      );
      const [again] = await corners(page);
      for (const k of [0, 1, 2])
        assert.ok(
          Math.abs(extent(again, k)[1] - extent(again, k)[0] - (extent(drawn, k)[1] - extent(drawn, k)[0])) < 0.02,
          `axis ${k}`,
        );
    }
  }));
