// Bridges by real pointers and keys. What else the tool does is said by tests/unit/web/bridge_tool_test.cpp.
import assert from 'node:assert/strict';
import test from 'node:test';
import { press, strokeAlong } from './support/hands.mjs';
import { exported, idle, kDesk, kPhone, onPage, reload, run, state, useSite } from './support/page.mjs';

const kit = useSite();

/** Two balls on paper, seen from the front, with the tool in hand by its button. */
async function balls(page, touch = false) {
  await page.getByRole('button', { name: 'Draw on paper' }).click();
  await idle(page);
  await run(page, 'remove-picture');
  await run(page, 'new-sketch', { width: 1000, height: 700 });
  for (const [x, size] of [
    [280, 320],
    [740, 240],
  ]) {
    await run(page, 'draw-shape', {
      kind: 'ball',
      axis: [
        [x, 350 + size / 2],
        [x, 350 - size / 2],
      ],
    });
  }
  await run(page, 'more-tools', { on: true });
  await run(page, 'home-view');
  await press(page, 'Bridge', { touch });
  assert.equal((await state(page)).tool, 'bridge');
}

async function toClient(page, [x, y]) {
  const box = await page.locator('#canvas').boundingBox();
  return { x: box.x + x, y: box.y + y };
}
/** Where places of the picture are on the fronts of the two balls, client pixels. */
async function onBalls(page, from, to) {
  await run(page, 'bridge', { from: { part: 1, at: from }, to: { part: 2, at: to }, width: 0.3 });
  const { bridgeKnobs } = await state(page);
  await run(page, 'undo');
  return Promise.all(bridgeKnobs.map((knob) => toClient(page, knob)));
}
const along = (from, to, count = 8) =>
  Array.from({ length: count + 1 }, (_, i) => ({
    x: from.x + ((to.x - from.x) * i) / count,
    y: from.y + ((to.y - from.y) * i) / count,
  }));

test('a drag from one ball to the other makes one solid of both, an end is dragged: mouse and pen, each one step', () =>
  onPage(kit, kDesk, async (page) => {
    await balls(page);
    // A finger after a pen moves the picture: it has a page of its own below.
    for (const device of ['mouse', 'pen']) {
      // Bars are as large as the pointer in use wants them.
      const [from, to] = await onBalls(page, [400, 350], [650, 350]);
      const { undo } = await state(page);
      await strokeAlong(page, device, along(from, to));
      let now = await state(page);
      assert.equal(now.parts.length, 3, device);
      assert.equal(now.undo, undo + 1);
      assert.equal(now.parts[2].kind, 'bridge');
      assert.deepEqual([now.parts[2].bridge.from.part, now.parts[2].bridge.to.part], [1, 2]);
      assert.equal(now.steps.length, 1);
      assert.equal(now.steps[0].failure, null);
      assert.equal(now.steps[0].genus, 0);
      const knob = await toClient(page, now.bridgeKnobs[0]);
      const { at } = now.parts[2].bridge.from;
      await strokeAlong(page, device, along(knob, { x: knob.x - 20, y: knob.y - 40 }));
      now = await state(page);
      assert.ok(now.parts[2].bridge.from.at[1] > at[1] + 10, device);
      assert.equal(now.undo, undo + 2);
      await run(page, 'undo');
      await run(page, 'undo');
      assert.equal((await state(page)).parts.length, 2);
    }
    assert.ok((await exported(page, 'glb')).length > 20000);
  }));

test('a finger on a phone makes one as well, and it is there after a reload', () =>
  onPage(kit, kPhone, async (page) => {
    await balls(page, true);
    const [from, to] = await onBalls(page, [390, 350], [660, 350]);
    await strokeAlong(page, 'finger', along(from, to));
    const { parts } = await state(page);
    assert.equal(parts.length, 3);
    await reload(page);
    await idle(page);
    const now = await state(page);
    assert.deepEqual(now.parts[2].bridge, parts[2].bridge);
    assert.equal(now.steps[0].failure, null);
  }));

test('two parts are joined by keys alone', () =>
  onPage(kit, {}, async (page) => {
    await balls(page);
    await run(page, 'draw');
    await page.locator('#canvas').focus();
    await page.keyboard.press('Control+a');
    await page.keyboard.press('Shift+J');
    await idle(page);
    const now = await state(page);
    assert.equal(now.parts.length, 3);
    assert.ok(now.parts[2].bridge.from.at[0] > 400);
    await page.keyboard.press(']');
    await idle(page);
    assert.ok((await state(page)).parts[2].bridge.from.radius > now.parts[2].bridge.from.radius);
  }));

test('a bridge goes along with a part that is moved', () =>
  onPage(kit, {}, async (page) => {
    await balls(page);
    await run(page, 'bridge', { from: { part: 1, at: [400, 350] }, to: { part: 2, at: [650, 350] } });
    await idle(page);
    const before = (await state(page)).parts[2].bridge.to.at;
    await run(page, 'move-parts', { parts: [2], move: [0, 0.1, 0] });
    await idle(page);
    const now = await state(page);
    assert.ok(Math.abs(now.parts[2].bridge.to.at[1] - before[1] - 100) < 15, `${now.parts[2].bridge.to.at} ${before}`);
    assert.equal(now.steps[0].failure, null);
  }));
