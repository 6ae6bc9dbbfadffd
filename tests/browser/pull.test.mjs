// Pulling the surface by real pointers and keys. What else the tool does is said by tests/unit/web/pull_tool_test.cpp.
import assert from 'node:assert/strict';
import test from 'node:test';
import { press, strokeAlong } from './support/hands.mjs';
import { exported, idle, kDesk, kPhone, onPage, reload, run, state, useSite } from './support/page.mjs';

const kit = useSite();

const kEgg = Array.from({ length: 40 }, (_, i) => [
  500 + 230 * Math.cos((2 * Math.PI * i) / 40),
  400 + 280 * Math.sin((2 * Math.PI * i) / 40),
]);

/** A puff on paper, seen from the front, with the tool in hand by its button. */
async function egg(page, touch = false) {
  await page.getByRole('button', { name: 'Draw on paper' }).click();
  await idle(page);
  await run(page, 'remove-picture');
  await run(page, 'new-sketch', { width: 1000, height: 800 });
  await run(page, 'draw-puff', { contours: [kEgg] });
  await run(page, 'more-tools', { on: true });
  await run(page, 'home-view');
  await press(page, 'Pull', { touch });
  assert.equal((await state(page)).tool, 'pull');
}

/** Where a place of the picture is on the front of the solid, client pixels. */
async function onSolid(page, place) {
  await run(page, 'pull', { line: [place], height: 0 });
  const { pullKnobs } = await state(page);
  await run(page, 'undo');
  return toClient(page, pullKnobs.at(-1).at);
}
async function toClient(page, [x, y]) {
  const box = await page.locator('#canvas').boundingBox();
  return { x: box.x + x, y: box.y + y };
}
const along = (from, to, count = 8) =>
  Array.from({ length: count + 1 }, (_, i) => ({
    x: from.x + ((to.x - from.x) * i) / count,
    y: from.y + ((to.y - from.y) * i) / count,
  }));
const ringRound = ({ x, y }, radius) =>
  Array.from({ length: 33 }, (_, i) => ({
    x: x + radius * Math.cos((Math.PI * i) / 16.5),
    y: y + radius * Math.sin((Math.PI * i) / 16.5),
  }));
const pullsOf = async (page) => (await state(page)).parts[0].pulls;

test('a line on the solid bulges and its knob goes further out, by mouse, finger and pen, each one step', () =>
  onPage(kit, kDesk, async (page) => {
    await egg(page);
    for (const [index, device] of ['mouse', 'finger', 'pen'].entries()) {
      // Bars are as large as the pointer in use wants them: it turns the solid first.
      const middle = await onSolid(page, [500, 400]);
      await strokeAlong(
        page,
        device,
        along({ x: middle.x - 240, y: middle.y + 150 }, { x: middle.x - 200, y: middle.y + 150 }),
      );
      await run(page, 'home-view');
      const { undo } = await state(page);
      const [from, to] = [await onSolid(page, [430, 260 + 120 * index]), await onSolid(page, [570, 260 + 120 * index])];
      await strokeAlong(page, device, along(from, to));
      let pulls = await pullsOf(page);
      assert.equal(pulls.length, index + 1, device);
      assert.equal((await state(page)).undo, undo + 1);
      assert.ok(pulls[index].points > 3 && pulls[index].height > 0);
      for (let i = 0; i < 3; i += 1) await run(page, 'turn-left');
      const knob = await toClient(page, (await state(page)).pullKnobs[index].at);
      await strokeAlong(page, device, along(knob, { x: knob.x - 40, y: knob.y }));
      const before = pulls[index].height;
      pulls = await pullsOf(page);
      assert.ok(pulls[index].height > before + 5, `${device}: ${before} ${pulls[index].height}`);
      assert.equal((await state(page)).undo, undo + 2);
      await run(page, 'home-view');
    }
    assert.ok((await exported(page, 'glb')).length > 50000);
  }));

test('a ring on the solid is a bump, by mouse and pen, and its knob is its height', () =>
  onPage(kit, kDesk, async (page) => {
    await egg(page);
    // A finger after a pen moves the picture: it has a page of its own below.
    for (const device of ['mouse', 'pen']) {
      const middle = await onSolid(page, [500, 400]);
      await strokeAlong(page, device, along({ x: middle.x - 240, y: middle.y }, { x: middle.x - 200, y: middle.y }));
      await run(page, 'home-view');
      const { undo } = await state(page);
      const centre = await onSolid(page, [500, 400]);
      await strokeAlong(page, device, ringRound(centre, 50));
      let [bump] = await pullsOf(page);
      assert.ok(bump?.ring > 20 && bump.points === 1 && bump.height > 0, device);
      assert.equal((await state(page)).undo, undo + 1);
      for (let i = 0; i < 3; i += 1) await run(page, 'turn-left');
      const knob = await toClient(page, (await state(page)).pullKnobs[0].at);
      const { height } = bump;
      await strokeAlong(page, device, along(knob, { x: knob.x - 40, y: knob.y }));
      await run(page, 'home-view');
      [bump] = await pullsOf(page);
      assert.ok(bump.height > height + 5, `${device}: ${height} ${bump.height}`);
      assert.equal((await state(page)).undo, undo + 2);
      await run(page, 'undo');
      await run(page, 'undo');
      assert.deepEqual(await pullsOf(page), []);
    }
  }));

test('a ring on a phone is a bump as well, and is there after a reload', () =>
  onPage(kit, kPhone, async (page) => {
    await egg(page, true);
    await strokeAlong(page, 'finger', ringRound(await onSolid(page, [500, 400]), 30));
    const [bump] = await pullsOf(page);
    assert.ok(bump?.ring > 20 && bump.share === 1);
    await reload(page);
    await idle(page);
    assert.deepEqual(await pullsOf(page), [bump]);
  }));

test('a tap on a phone bulges, and a drag beside the solid turns it', () =>
  onPage(kit, kPhone, async (page) => {
    await egg(page, true);
    const middle = await onSolid(page, [500, 400]);
    await page.touchscreen.tap(middle.x, middle.y);
    await idle(page);
    assert.equal((await pullsOf(page)).length, 1);
    const { yaw } = (await state(page)).camera;
    const box = await page.locator('#canvas').boundingBox();
    const beside = { x: box.x + 12, y: middle.y };
    await strokeAlong(page, 'finger', along(beside, { x: beside.x + 40, y: beside.y }));
    assert.notEqual((await state(page)).camera.yaw, yaw);
    assert.equal((await pullsOf(page)).length, 1);
  }));

test('all by keyboard, and it is there after a reload', () =>
  onPage(kit, {}, async (page) => {
    await egg(page);
    await page.locator('#canvas').focus();
    for (const key of ['Enter', 'ArrowUp', 'ArrowUp', ']', 'e']) await page.keyboard.press(key);
    await idle(page);
    const [pull] = await pullsOf(page);
    assert.ok(pull.crease && pull.height > 0);
    await reload(page);
    await idle(page);
    assert.deepEqual(await pullsOf(page), [pull]);
    await run(page, 'pull');
    await page.locator('#canvas').focus();
    for (const key of ['.', 'Delete']) await page.keyboard.press(key);
    await idle(page);
    assert.deepEqual(await pullsOf(page), []);
    assert.equal((await state(page)).parts.length, 1);
  }));
