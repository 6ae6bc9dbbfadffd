// The list of parts by hand: rows dragged to order parts in depth, and what is then stuck together. With
// $SPINELOFT_PICTURES naming a folder, screenshots go there.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { measure, parseStl } from './support/model_files.mjs';
import {
  control,
  drawWithMouse,
  drawWithTouch,
  exported,
  idle,
  onPage,
  openPicture,
  placeOf,
  press,
  state,
  useSite,
} from './support/page.mjs';
import { paintedPng } from './support/pictures.mjs';

const kit = useSite();
const kept = process.env.SPINELOFT_PICTURES;
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };
/** Two crossing bars. */
const crossing = paintedPng(400, 300, (x, y) =>
  y >= 130 && y < 170 && x >= 60 && x < 340
    ? [60, 90, 160]
    : x >= 185 && x < 215 && y >= 40 && y < 260
      ? [190, 80, 50]
      : [245, 243, 238],
);

async function look(page, name) {
  if (!kept) return;
  mkdirSync(kept, { recursive: true });
  await page.screenshot({ path: join(kept, `list_${name}.png`) });
}

const framed = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** A hand with one pointer on the canvas: `down(at)`, `move(at)`, `up()`. */
async function handOf(page, touch) {
  if (!touch) {
    return {
      down: async ({ x, y }) => {
        await page.mouse.move(x, y);
        await framed(page);
        await page.mouse.down();
      },
      move: ({ x, y }) => page.mouse.move(x, y),
      up: () => page.mouse.up(),
    };
  }
  const session = await page.context().newCDPSession(page);
  const send = (type, at) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: at ? [{ x: at.x, y: at.y, id: 1 }] : [] });
  return {
    down: (at) => send('touchStart', at),
    move: (at) => send('touchMove', at),
    up: async () => {
      await send('touchEnd');
      await session.detach();
    },
  };
}

/** Drags a row of the list by its grip until it is above (or below) another one. */
async function dragRow(page, name, where, other, { touch = false, midway } = {}) {
  const from = await placeOf(page, name, { kind: 'grip' }),
    row = await placeOf(page, other, { kind: 'row' });
  const {
    at: [, , , height],
  } = await control(page, other, { kind: 'row' });
  const to = { x: from.x, y: row.y + (where === 'above' ? -height * 0.4 : height * 0.4) };
  const hand = await handOf(page, touch);
  await hand.down(from);
  for (let i = 1; i <= 8; i += 1) {
    await hand.move({ x: from.x, y: from.y + ((to.y - from.y) * i) / 8 });
    await framed(page);
  }
  if (midway) await midway();
  await hand.up();
  await framed(page);
  await idle(page);
}

/** A page with two parts that cross in the picture; the one that was drawn first lies above in the list. */
async function withCrossing(options, work) {
  await onPage(kit, options, async (page) => {
    await openPicture(page, crossing, 'crossing.png');
    const draw = options.hasTouch ? drawWithTouch : drawWithMouse;
    await draw(page, [
      [70, 150],
      [150, 151],
      [250, 150],
      [330, 150],
    ]);
    if (options.hasTouch) await page.locator('#bar-more').tap();
    if (options.hasTouch)
      await page.getByRole('menu').locator('[role^=menuitem]').filter({ hasText: 'New part' }).first().tap();
    else await page.locator('#bar-items [data-command=new-part]').click();
    await draw(page, [
      [200, 50],
      [201, 110],
      [200, 190],
      [200, 250],
    ]);
    assert.equal((await state(page)).parts.length, 2);
    await work(
      page,
      (await state(page)).parts.map(({ name }) => name),
    );
  });
}

const order = async (page) => (await state(page)).parts.map(({ id }) => id);
const depth = async (page, id) => (await state(page)).parts.find((part) => part.id === id).placement.mm[2];

for (const [hand, options] of [
  ['the mouse', {}],
  ['a finger on a phone', phone],
]) {
  test(`a row that is dragged up past another brings its part before it, down again behind it, in one step each, with ${hand}`, () =>
    withCrossing(options, async (page, [first, second]) => {
      const touch = options.hasTouch === true;
      if (touch) await press(page, 'Parts', { kind: 'tab', touch });
      const { undo } = await state(page);
      assert.deepEqual(await order(page), [1, 2]);
      await dragRow(page, second, 'above', first, { touch, midway: () => look(page, touch ? 'finger' : 'mouse') });
      assert.deepEqual(await order(page), [2, 1]);
      assert.equal((await state(page)).undo, undo + 1);
      const before = await depth(page, 2);
      assert.ok(before > 1, `${before} mm before where it was`);
      assert.equal(await depth(page, 1), 0);
      await look(page, touch ? 'finger_before' : 'mouse_before');
      await dragRow(page, second, 'below', first, { touch });
      assert.deepEqual(await order(page), [1, 2]);
      const behind = await depth(page, 2);
      assert.ok(behind < -1, `${behind} mm: behind where it was`);
      assert.equal((await state(page)).undo, undo + 2);
      // A row that is let go where it was stays, and is chosen.
      await dragRow(page, first, 'above', first, { touch });
      assert.deepEqual(await order(page), [1, 2]);
      assert.equal((await state(page)).undo, undo + 2);
    }));
}

test('what was moved in the list and is stuck together is one piece, with the part that was brought forward before the other', () =>
  withCrossing({}, async (page, [first, second]) => {
    await dragRow(page, second, 'above', first);
    const apart = measure(parseStl(await exported(page, 'stl')));
    assert.equal(apart.pieces, 2);
    await press(page, 'Stick together');
    const [root] = (await state(page)).steps;
    assert.deepEqual([root.kind, root.status, root.failure, root.operands.length], ['join', 'ready', null, 2]);
    const { open, unsound, pieces, volume } = measure(parseStl(await exported(page, 'stl')));
    assert.deepEqual([open, unsound, pieces], [0, 0, 1]);
    assert.ok(volume < apart.volume, 'what both held is there once');
    await look(page, 'stuck');
  }));
