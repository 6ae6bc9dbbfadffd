// Parts taken in hand in the solid view with real pointers: the gizmo by mouse, the body by fingers, and what that does
// to the files. What each handle and number means is said by tests/unit/web/placing_test.cpp.
import assert from 'node:assert/strict';
import test from 'node:test';
import { dragFingers, dragMouse, onCanvas } from './support/hands.mjs';
import {
  done,
  exported,
  idle,
  kPhone,
  kTablet,
  onPage,
  openPicture,
  openWithPart,
  run,
  state,
  useSite,
} from './support/page.mjs';
import { samples, tubePicture } from './support/pictures.mjs';

const kit = useSite();
const [lemur, other] = samples();

/** The first sample with its part in hand. */
const withPart = (work) =>
  onPage(kit, kTablet, async (page) => {
    await openWithPart(page, lemur.bytes, lemur.spine, 'lemur');
    await done(page, 'move');
    await work(page);
  });

const part = async (page, i = 0) => (await state(page)).parts[i];
const length = (v) => Math.hypot(...v);

/** Where a handle of the gizmo is, in client pixels. */
async function knob(page, handle) {
  const { gizmo } = await state(page);
  assert.ok(gizmo, 'there is a gizmo');
  const [at] = await onCanvas(page, gizmo.knobs.find((one) => one.handle === handle).at);
  return at;
}

test('an arrow moves a part along its axis in one step, Esc takes a drag back, and undo is exact', () =>
  withPart(async (page) => {
    const before = await state(page);
    await dragMouse(page, await knob(page, 'y'), 0, -40, async () => {
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

test('a finger drags the body, two fingers turn and grow it', () =>
  withPart(async (page) => {
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
  }));

test('the first part of a further picture stands beside the others, in the step that draws it', () =>
  withPart(async (page) => {
    await openPicture(page, other.bytes, 'second');
    const { undo } = await state(page);
    await done(page, 'draw-spine', { stroke: other.spine });
    const now = await state(page);
    assert.equal(now.undo, undo + 1);
    assert.ok(now.parts[1].placement.move[0] > 0.05, `${now.parts[1].placement.move}`);
    await run(page, 'undo');
    assert.equal((await state(page)).parts.length, 1);
  }));

/** Least and greatest depth of every part in its place, by an OBJ: millimetres, y up, z to the front. */
async function depths(page) {
  const parts = (await exported(page, 'obj'))
    .toString('utf8')
    .split(/^o .*$/m)
    .slice(1);
  return parts.map((text) => {
    const z = [...text.matchAll(/^v \S+ \S+ (\S+)/gm)].map(([, value]) => Number(value));
    return [Math.min(...z), Math.max(...z)];
  });
}

test('with Snap on, a part that is dragged over another one comes to lie on its surface; without, it goes into it', () =>
  onPage(kit, kTablet, async (page) => {
    const tube = tubePicture();
    await openWithPart(page, tube.png, tube.middle.slice(14, 41));
    await run(page, 'duplicate');
    await done(page, 'move');
    const {
      placement: { move: away },
    } = await part(page, 1);
    await done(page, 'select-part', { id: 1 });
    const target = await knob(page, 'plane');
    let inside = 0;
    for (const snap of [false, true]) {
      await done(page, 'select-part', { id: 2 });
      if (snap) await page.keyboard.press('Shift+S');
      assert.equal((await state(page)).snap, snap);
      const from = await knob(page, 'plane');
      await dragMouse(page, from, target.x - from.x, target.y - from.y);
      assert.ok(length((await part(page, 1)).placement.move.map((x, k) => x - away[k])) > 0.02, 'it was dragged');
      const [[low, high], [back, front]] = await depths(page);
      const thick = high - low,
        gap = Math.max(back - high, low - front);
      await done(page, 'keep-common', { parts: [1, 2] });
      const { status, failure, volume } = (await state(page)).steps[0];
      await run(page, 'undo');
      if (snap) {
        // They touch where one lies over the other; elsewhere one may be thicker than there.
        assert.ok(Math.abs(gap) < 0.1 * thick, `${gap} mm between parts of ${thick}`);
        assert.ok(failure === 'SolidEmpty' || volume < 0.05 * inside, `${status}: they have ${volume} in common`);
      } else {
        assert.ok(gap < -0.2 * thick, `${gap} mm between parts of ${thick}`);
        assert.ok(status === 'ready' && volume > 1e-4, `${status}: ${volume}`);
        inside = volume;
      }
      await run(page, 'undo');
      await idle(page);
    }
    await page.keyboard.press('Shift+S');
  }));

for (const [name, context] of Object.entries({
  phone: kPhone,
  'phone on its side': { ...kPhone, viewport: { width: 844, height: 390 } },
})) {
  test(`one row of buttons lies over the solid while parts are placed, below all handles of the gizmo (${name})`, () =>
    onPage(kit, context, async (page) => {
      await openWithPart(page, lemur.bytes, lemur.spine, 'lemur');
      await page.touchscreen.tap(context.viewport.width - 20, 20); // fingers are used, and nothing is there
      await page.keyboard.press('Escape');
      await done(page, 'move');
      const { controls, gizmo } = await state(page);
      const at = (words) => controls.find((one) => one.words === words && one.kind === 'button').at;
      const [, top, , height] = at('Home view');
      for (const words of ['Duplicate', 'Move']) {
        const [, y, , tall] = at(words);
        assert.ok(y < top + height && y + tall > top, `${words} is in the row of Home view`);
      }
      for (const {
        handle,
        at: [, y],
      } of gizmo.knobs)
        assert.ok(y + 16 < top, `${handle} is above the row`);
      const across = (handle) => gizmo.knobs.find((one) => one.handle === handle).at[0];
      assert.ok(across('scale') - across('depth') > 110, 'fingers tell the handles apart');
    }));
}
