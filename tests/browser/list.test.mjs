// The list of parts by hand: rows dragged to order parts in depth, and what is then stuck together. With
// $SPINELOFT_PICTURES naming a folder, screenshots go there.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { control, findControl, handOf, placeOf, press, strokeAlong } from './support/hands.mjs';
import { measure, parseStl } from './support/model_files.mjs';
import { done, exported, framed, idle, kPhone, onPage, openWithPart, run, state, useSite } from './support/page.mjs';
import { paintedPng } from './support/pictures.mjs';

const kit = useSite();
const kept = process.env.SPINELOFT_PICTURES;
/** Two crossing bars. */
const crossing = paintedPng(400, 300, (x, y) =>
  y >= 130 && y < 170 && x >= 60 && x < 340
    ? [60, 90, 160]
    : x >= 185 && x < 215 && y >= 40 && y < 260
      ? [190, 80, 50]
      : [245, 243, 238],
);
const across = [
  [70, 150],
  [150, 151],
  [250, 150],
  [330, 150],
];
const upright = [
  [200, 50],
  [201, 110],
  [200, 190],
  [200, 250],
];

async function look(page, name) {
  if (!kept) return;
  mkdirSync(kept, { recursive: true });
  await page.screenshot({ path: join(kept, `list_${name}.png`) });
}

/** Drags a row of the list by its grip until it is above (or below) another one. */
async function dragRow(page, name, where, other, { touch = false, midway } = {}) {
  const from = await placeOf(page, name, { kind: 'grip' }),
    row = await placeOf(page, other, { kind: 'row' });
  const {
    at: [, , , height],
  } = await control(page, other, { kind: 'row' });
  const to = { x: from.x, y: row.y + (where === 'above' ? -height * 0.4 : height * 0.4) };
  const hand = await handOf(page, touch ? 'finger' : 'mouse');
  if (!touch) await page.mouse.move(from.x, from.y);
  await framed(page);
  await hand.down(from);
  // Before a finger has stayed it scrolls the list.
  if (touch) await page.waitForTimeout(600);
  for (let i = 1; i <= 5; i += 1) {
    await hand.move({ x: from.x, y: from.y + ((to.y - from.y) * i) / 5 });
    await framed(page);
  }
  if (midway) await midway();
  await hand.up();
  await framed(page);
  await idle(page);
}

/** A page with two parts that cross in the picture; the one that was drawn first lies above in the list. */
const withCrossing = (options, work) =>
  onPage(kit, options, async (page) => {
    await openWithPart(page, crossing, across, 'crossing.png');
    await run(page, 'new-part');
    await done(page, 'draw-spine', { stroke: upright });
    const { parts } = await state(page);
    assert.equal(parts.length, 2);
    await work(
      page,
      parts.map(({ name }) => name),
    );
  });

const order = async (page) => (await state(page)).parts.map(({ id }) => id);
const depth = async (page, id) => (await state(page)).parts.find((part) => part.id === id).placement.mm[2];

test('a row that a finger on a phone drags up past another brings its part before it, down again behind it, in one step each; stuck together they are one piece', () =>
  withCrossing(kPhone, async (page, [first, second]) => {
    const touch = true;
    await press(page, 'Parts', { kind: 'tab', touch });
    const { undo } = await state(page);
    assert.deepEqual(await order(page), [1, 2]);
    await dragRow(page, second, 'above', first, { touch, midway: () => look(page, 'finger') });
    assert.deepEqual(await order(page), [2, 1]);
    assert.equal((await state(page)).undo, undo + 1);
    const before = await depth(page, 2);
    assert.ok(before > 1, `${before} mm before where it was`);
    assert.equal(await depth(page, 1), 0);
    await look(page, 'finger_before');
    await dragRow(page, second, 'below', first, { touch });
    assert.deepEqual(await order(page), [1, 2]);
    const behind = await depth(page, 2);
    assert.ok(behind < -1, `${behind} mm: behind where it was`);
    assert.equal((await state(page)).undo, undo + 2);
    // A row that is let go where it was stays, and is chosen.
    await dragRow(page, first, 'above', first, { touch });
    assert.deepEqual(await order(page), [1, 2]);
    assert.equal((await state(page)).undo, undo + 2);
    // What was moved and is stuck together is one piece.
    const apart = measure(parseStl(await exported(page, 'stl')));
    assert.equal(apart.pieces, 2);
    await press(page, 'Stick together', { touch });
    const [root] = (await state(page)).steps;
    assert.deepEqual([root.kind, root.status, root.failure, root.operands.length], ['join', 'ready', null, 2]);
    const joined = measure(parseStl(await exported(page, 'stl')));
    assert.deepEqual([joined.open, joined.unsound, joined.pieces], [0, 0, 1]);
    assert.ok(joined.volume < apart.volume, 'what both held is there once');
    await look(page, 'stuck');
  }));

/** A page with five parts that cross one another, on a phone with its list open. */
const withFive = (work) =>
  onPage(kit, kPhone, async (page) => {
    await openWithPart(page, crossing, across, 'crossing.png');
    for (let i = 0; i < 4; i += 1) {
      await run(page, 'new-part');
      await done(page, 'draw-spine', { stroke: upright.map(([x, y]) => [x + 2 * i, y]) });
    }
    await press(page, 'Parts', { kind: 'tab', touch: true });
    assert.equal((await state(page)).parts.length, 5);
    await work(page);
  });

test('on a phone what can be made of five parts is in sight beside their list, and one tap without ticks makes one piece of all', () =>
  withFive(async (page) => {
    for (const words of ['Stick together', 'Cut out', 'Overlap', 'Scoop out']) {
      assert.equal((await findControl(page, words)).inSight, true, words);
    }
    await press(page, 'Stick together', { touch: true });
    const { steps } = await state(page);
    assert.deepEqual(
      steps.map(({ kind, status, operands }) => [kind, status, operands.length]),
      [['join', 'ready', 5]],
    );
  }));

test('a finger that goes up or down over the small pictures of the list scrolls it and moves no part; a tap chooses', () =>
  withFive(async (page) => {
    const { undo } = await state(page);
    const names = (await state(page)).parts.map(({ name }) => name);
    const before = (await findControl(page, names[1], { kind: 'grip' })).at;
    const from = await placeOf(page, names[1], { kind: 'grip' });
    await strokeAlong(page, 'finger', [from, { x: from.x, y: from.y - 20 }, { x: from.x, y: from.y - 45 }]);
    await framed(page);
    const after = (await findControl(page, names[1], { kind: 'grip' })).at;
    assert.ok(after[1] < before[1] - 25, `${before[1]} to ${after[1]}`);
    assert.deepEqual(await order(page), [1, 2, 3, 4, 5]);
    const third = await placeOf(page, names[2], { kind: 'grip' });
    await page.touchscreen.tap(third.x, third.y);
    await idle(page);
    assert.equal((await state(page)).selection, 3);
    assert.equal((await state(page)).undo, undo);
  }));
