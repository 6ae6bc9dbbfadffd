// The bones of a puff on the picture, by real pointers and by keys. What else the tool does is said by
// tests/unit/web/puff_bones_test.cpp.
import assert from 'node:assert/strict';
import test from 'node:test';
import { onCanvas, strokeAlong } from './support/hands.mjs';
import { sample } from '../support/rounds.mjs';
import { exported, idle, kPhone, onPage, run, state, toClient, useSite } from './support/page.mjs';

const kit = useSite();

const kT = [
  [200, 150],
  [820, 150],
  [820, 290],
  [580, 290],
  [580, 640],
  [440, 640],
  [440, 290],
  [200, 290],
];

/** A T on paper as a puff with a round slice, and the tool in hand. */
async function boned(page) {
  await page.getByRole('button', { name: 'Draw on paper' }).click();
  await idle(page);
  await run(page, 'draw-puff', { contours: [kT] });
  await run(page, 'puff-slice', { slice: 'round' });
  await run(page, 'bone');
  await idle(page);
}

const bones = async (page) => (await state(page)).parts[0].bones;

/** Client position of the handle of this kind nearest to a point of the picture. */
async function hold(page, kind, at) {
  const [to] = await toClient(page, [at]);
  const all = (await state(page)).boneHandles.filter((handle) => handle.hold === kind);
  assert.ok(all.length > 0, `no ${kind}`);
  const places = await onCanvas(page, ...all.map((handle) => handle.at));
  const away = (p) => Math.hypot(p.x - to.x, p.y - to.y);
  return places.sort((a, b) => away(a) - away(b))[0];
}

const pull = (page, device, from, dx, dy, options) =>
  strokeAlong(
    page,
    device,
    [0, 0.2, 0.4, 0.6, 0.8, 1].map((t) => ({ x: from.x + t * dx, y: from.y + t * dy })),
    options,
  );

for (const device of sample(['mouse', 'finger', 'pen'], 0)) {
  test(`bones go and come back, ends are dragged, a new one drawn, a knob pulled: by ${device}`, () =>
    onPage(kit, { hasTouch: true }, async (page) => {
      await boned(page);
      let now = await bones(page);
      assert.equal(now.branches.length, 3);
      await strokeAlong(page, device, [await hold(page, 'bone', [510, 450])]);
      now = await bones(page);
      assert.deepEqual([now.branches.length, now.gone.length], [1, 1]);
      await strokeAlong(page, device, [await hold(page, 'gone', [510, 450])]);
      now = await bones(page);
      assert.deepEqual([now.branches.length, now.gone.length], [3, 0]);

      let seen = 0;
      const midway = async (shown) => {
        seen = (await state(shown)).preview?.triangles ?? 0;
      };
      const { undo } = await state(page);
      await pull(page, device, await hold(page, 'node', [790, 220]), -40, 5, { midway });
      assert.ok(seen > 100, 'the solid follows the pen');
      assert.equal((await state(page)).undo, undo + 1);

      await pull(page, device, await hold(page, 'knob', [510, 450]), 0, -16);
      assert.ok((await bones(page)).knobs.some(([, , factor]) => factor > 1.3));

      const { ends } = await bones(page);
      const [from, to] = await toClient(page, [
        [420, 222],
        [370, 276],
      ]);
      await pull(page, device, from, to.x - from.x, to.y - from.y);
      now = await bones(page);
      assert.equal(now.ends, ends + 1);
      assert.equal(now.asleep, 0);
      await run(page, 'reset-bones');
      await idle(page);
      assert.equal((await bones(page)).ends, 3);
      assert.ok((await exported(page, 'stl')).length > 50000);
    }));
}

test('a slice at a place is dragged along the bones and takes another look, by finger on a phone', () =>
  onPage(kit, kPhone, async (page) => {
    await boned(page);
    await run(page, 'slice-here', { at: [280, 220] });
    await idle(page);
    const before = (await bones(page)).slices[1].at;
    await pull(page, 'finger', await hold(page, 'slice', before), 60, 0);
    const after = (await bones(page)).slices[1].at;
    assert.ok(after[0] > before[0] + 30, `${before} to ${after}`);
    await run(page, 'puff-slice', { slice: 'roof', at: after });
    await idle(page);
    assert.deepEqual(
      (await bones(page)).slices.map(({ slice }) => slice),
      ['round', 'roof'],
    );
  }));

test('bones by keyboard alone, and by a screen reader', () =>
  onPage(kit, {}, async (page) => {
    await boned(page);
    await page.locator('#canvas').focus();
    await page.keyboard.press('.');
    await page.keyboard.press('ArrowUp');
    await idle(page);
    assert.equal((await state(page)).chosen.boneHandle, 0);
    const { undo } = await state(page);
    while ((await state(page)).boneHandles[(await state(page)).chosen.boneHandle].hold !== 'bone') {
      await page.keyboard.press('.');
      await idle(page);
    }
    await page.keyboard.press('Delete');
    await idle(page);
    assert.equal((await bones(page)).gone.length, 1);
    assert.equal((await state(page)).undo, undo + 1);
    await page.getByRole('button', { name: 'Take bone 1 back' }).press('Enter');
    await idle(page);
    assert.equal((await bones(page)).gone.length, 0);
    const knob = page.getByRole('slider', { name: 'Thickness at knob 1 of the bones' });
    await knob.press('ArrowRight');
    await idle(page);
    assert.ok((await bones(page)).knobs.some(([, , factor]) => factor > 1));
  }));
