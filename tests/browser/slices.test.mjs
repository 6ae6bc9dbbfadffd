// Drawing slices with real pointers, several slices along a bone, curves along it, and the shelf.
import assert from 'node:assert/strict';
import test from 'node:test';
import { exported, idle, onPage, openPicture, run, state, useSite } from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

async function withPart(options, work) {
  await onPage(kit, options, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await run(page, 'draw-spine', { stroke: tube.middle });
    await idle(page);
    await work(page);
  });
}

/** Client positions of places of the board's square. */
async function onBoard(page, points) {
  const [x, y, side] = (await state(page)).sliceBoard.square;
  const box = await page.locator('#canvas').boundingBox();
  const half = side / 2 / 1.18;
  return points.map(([px, py]) => ({ x: box.x + x + side / 2 + px * half, y: box.y + y + side / 2 - py * half }));
}

const ring = (radius, count = 30) =>
  Array.from({ length: count }, (_, i) => {
    const angle = (6.15 * i) / (count - 1);
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });

async function mouse(page, path) {
  await page.mouse.move(path[0].x, path[0].y);
  await page.mouse.down();
  for (const at of path) await page.mouse.move(at.x, at.y);
  await page.mouse.up();
  await idle(page);
}

async function touch(page, path) {
  const session = await page.context().newCDPSession(page);
  const send = (type, at) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: at ? [{ x: at.x, y: at.y, id: 1 }] : [] });
  await send('touchStart', path[0]);
  for (const at of path.slice(1)) await send('touchMove', at);
  await send('touchEnd');
  await session.detach();
  await idle(page);
}

for (const [name, options, draw] of [
  ['the mouse', {}, mouse],
  ['a finger on a phone', phone, touch],
]) {
  test(`a slice with a hole is drawn with ${name}; it is one step, and on the shelf after a reload`, () =>
    withPart(options, async (page) => {
      const before = (await state(page)).undo;
      await run(page, 'edit-slice');
      await idle(page);
      await draw(page, await onBoard(page, ring(0.85)));
      await draw(page, await onBoard(page, ring(0.4)));
      assert.equal((await state(page)).sliceBoard.curves.length, 2);
      await run(page, 'slice-done');
      await idle(page);
      const now = await state(page);
      assert.equal(now.sliceBoard, null);
      assert.equal(now.undo, before + 1);
      assert.deepEqual([now.parts[0].slices[0].curves, now.parts[0].slices[0].holes], [1, 1]);
      await page.reload();
      await page.evaluate(() => window.spineloft.ready);
      assert.deepEqual(
        (await state(page)).shelf.map((slice) => slice.name),
        ['My slice 1'],
      );
    }));
}

test('leaving the board with Escape leaves the part as it was', () =>
  withPart({}, async (page) => {
    const before = await exported(page, 'glb');
    await run(page, 'edit-slice');
    await idle(page);
    await mouse(page, await onBoard(page, ring(0.7)));
    await page.keyboard.press('Escape');
    await idle(page);
    assert.equal((await state(page)).sliceBoard, null);
    assert.ok(before.equals(await exported(page, 'glb')));
  }));

test('slices along the bone are added, moved and taken away', () =>
  withPart({}, async (page) => {
    await run(page, 'add-slice', { at: 1, section: 'star' });
    await run(page, 'add-slice', { at: 0.5, section: 'square' });
    await run(page, 'move-slice', { slice: 1, to: 0.3 });
    assert.deepEqual(
      (await state(page)).parts[0].slices.map((slice) => [slice.at, slice.section]),
      [
        [0, 'circle'],
        [0.3, 'square'],
        [1, 'star'],
      ],
    );
    await run(page, 'remove-slice', { slice: 1 });
    assert.equal((await state(page)).parts[0].slices.length, 2);
    await run(page, 'undo');
    assert.equal((await state(page)).parts[0].slices.length, 3);
  }));

test('a shelf that is no shelf, or too much, does no harm', () =>
  onPage(kit, {}, async (page) => {
    for (const text of ['{', '[1, {"contours": [[[0, 0]]]}]', 'null']) {
      await page.evaluate((value) => localStorage.setItem('spineloft.shelf.1', value), text);
      await page.reload();
      await page.evaluate(() => window.spineloft.ready);
      assert.deepEqual((await state(page)).shelf, []);
    }
  }));
