// Finger, pen, wheel and keys on the canvas.
import assert from 'node:assert/strict';
import test from 'node:test';
import {
  difference,
  drawWithMouse,
  drawWithPen,
  drawWithTouch,
  idle,
  onPage,
  openPicture,
  pixels,
  state,
  tapWith,
  toClient,
  useSite,
} from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();
const touchScreen = { viewport: { width: 1024, height: 768 }, hasTouch: true };
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

async function withTube(options, work) {
  await onPage(kit, options, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await work(page);
  });
}

for (const [name, screen] of Object.entries({ 'a tablet': touchScreen, 'a phone': phone })) {
  test(`one finger draws on ${name}, two-finger tap undoes, three-finger tap redoes`, () =>
    withTube(screen, async (page) => {
      await drawWithTouch(page, tube.middle);
      const count = async () => (await state(page)).parts.length;
      assert.equal(await count(), 1);
      const [corner] = await toClient(page, [[20, 20]]);
      await tapWith(page, 2, corner);
      assert.equal(await count(), 0);
      await tapWith(page, 3, corner);
      assert.equal(await count(), 1);
    }));
}

test('a phone: the page fits its width and every command is within reach', () =>
  withTube(phone, async (page) => {
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
    for (const id of ['#bar-more', '#bar-save', '[data-command=draw]', '[data-command=undo]']) {
      const box = await page.locator(id).boundingBox();
      assert.ok(
        box.x >= 0 && box.x + box.width <= 390 && box.width >= 40 && box.height >= 40,
        `${id}: ${JSON.stringify(box)}`,
      );
    }
    const [first, last] = await toClient(page, [
      [0, 0],
      [tube.width - 1, tube.height - 1],
    ]);
    assert.ok(first.x >= 0 && last.x <= 390 && last.y - first.y > 150, 'the picture is large enough to draw on');
    await page.locator('#bar-more').tap();
    const labels = await page.getByRole('menu').getByRole('menuitem').allInnerTexts();
    assert.ok(
      labels.some((label) => label.startsWith('Slice')),
      labels.join(),
    );
  }));

test('the smallest phone: one column of tools beside the picture, and a tap on the dots brings the others by their names', () =>
  withTube({ ...phone, viewport: { width: 320, height: 568 } }, async (page) => {
    await drawWithTouch(page, tube.middle);
    assert.equal((await state(page)).parts.length, 1);
    const [first, last] = await toClient(page, [
      [0, 0],
      [tube.width - 1, tube.height - 1],
    ]);
    const canvas = await page.locator('#canvas').boundingBox();
    const column = canvas.x + canvas.width - 10 - 52; // of finger-sized buttons
    assert.ok(first.x >= canvas.x && last.x <= column, 'the picture is clear of them');
    assert.ok(last.y - first.y > 110 || last.x - first.x > 200, 'and large enough to draw on');
    const views = canvas.height - Math.floor(0.3 * canvas.height);
    const foot = canvas.y + Math.round((views - 8) / 2);
    const closed = await pixels(page);
    await page.touchscreen.tap(column + 26, foot - 10 - 26);
    await idle(page);
    assert.ok(difference(closed, await pixels(page)) > 0.05, 'the menu opens');
    await page.touchscreen.tap(column - 60, canvas.y + 10 + 4 * 46 + 22);
    await idle(page);
    assert.equal((await state(page)).tool, 'hand');
  }));

test('a pen draws, the solid grows with it, and its palm does not disturb', () =>
  withTube(touchScreen, async (page) => {
    const before = await pixels(page);
    await drawWithPen(page, tube.middle, async () => {
      const session = await page.context().newCDPSession(page);
      const [palm] = await toClient(page, [[tube.width * 0.5, tube.height * 0.9]]);
      await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ ...palm, id: 5 }] });
      await session.send('Input.dispatchTouchEvent', {
        type: 'touchMove',
        touchPoints: [{ x: palm.x - 60, y: palm.y, id: 5 }],
      });
      await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
      await page.waitForTimeout(300);
      assert.ok(difference(before, await pixels(page)) > 0.01);
    });
    assert.equal((await state(page)).parts.length, 1);
  }));

test('after the pen, one finger does not draw', () =>
  withTube(touchScreen, async (page) => {
    await drawWithPen(page, tube.middle);
    await page.waitForTimeout(700);
    await drawWithTouch(page, tube.middle.slice(0, 20));
    assert.equal((await state(page)).parts.length, 1);
  }));

test('every coalesced move of a fast pen arrives, and a pen that lifts ends the stroke', () =>
  withTube({}, async (page) => {
    const path = await toClient(page, tube.middle);
    const points = await page.evaluate(async (list) => {
      const canvas = document.getElementById('canvas');
      const event = (type, at, more = {}) =>
        new PointerEvent(type, {
          pointerId: 77,
          pointerType: 'pen',
          isPrimary: true,
          bubbles: true,
          cancelable: true,
          button: 0,
          buttons: 1,
          pressure: 0.5,
          clientX: at.x,
          clientY: at.y,
          ...more,
        });
      canvas.dispatchEvent(event('pointerdown', list[0]));
      const moves = list.slice(1).map((at) => event('pointermove', at, { button: -1 }));
      canvas.dispatchEvent(event('pointermove', list.at(-1), { button: -1, coalescedEvents: moves }));
      const drawn = window.spineloft.state().preview.points;
      canvas.dispatchEvent(event('pointerup', list.at(-1), { buttons: 0, pressure: 0 }));
      await window.spineloft.idle();
      return drawn;
    }, path);
    assert.ok(points >= 20, `${points} points of ${path.length} from one event`);
    const { parts, preview } = await state(page);
    assert.deepEqual([parts.length, preview], [1, null]);
  }));

test('the wheel zooms to the cursor and the picture follows', () =>
  withTube({}, async (page) => {
    const [anchor, other] = await toClient(page, [
      [100, 200],
      [300, 200],
    ]);
    await page.mouse.move(anchor.x, anchor.y);
    await page.mouse.wheel(0, -240);
    await idle(page);
    const [anchorAfter, otherAfter] = await toClient(page, [
      [100, 200],
      [300, 200],
    ]);
    assert.ok(Math.hypot(anchorAfter.x - anchor.x, anchorAfter.y - anchor.y) < 1.5, 'the point under the cursor stays');
    assert.ok(otherAfter.x - anchorAfter.x > 1.05 * (other.x - anchor.x), 'everything else spreads');
  }));

test('dragging in the solid view turns it, and Home brings it back', () =>
  withTube({}, async (page) => {
    await drawWithMouse(page, tube.middle);
    await page.keyboard.press('h');
    await page.waitForTimeout(900);
    const clip = { x: 460, y: 130, width: 270, height: 480 };
    const home = await pixels(page, clip);
    await page.mouse.move(600, 380);
    await page.mouse.down();
    await page.mouse.move(720, 420, { steps: 8 });
    await page.mouse.up();
    await page.mouse.move(600, 715);
    await idle(page);
    assert.ok(difference(home, await pixels(page, clip)) > 0.01, 'turned');
    await page.keyboard.press('h');
    await page.waitForTimeout(900);
    assert.ok(difference(home, await pixels(page, clip)) < 0.004, 'home again');
    assert.equal((await state(page)).parts.length, 1);
  }));

test('Escape drops the stroke in hand without trace', () =>
  withTube({}, async (page) => {
    const before = await state(page);
    const path = await toClient(page, tube.middle);
    await page.mouse.move(path[0].x, path[0].y);
    await page.mouse.down();
    for (const at of path.slice(1, 40)) await page.mouse.move(at.x, at.y);
    await page.keyboard.press('Escape');
    await page.mouse.move(path[45].x, path[45].y);
    await page.mouse.up();
    await idle(page);
    const { parts, undo, preview } = await state(page);
    assert.deepEqual([parts, undo, preview], [[], before.undo, null]);
  }));

test('a stroke that ends outside of the canvas still ends', () =>
  withTube({}, async (page) => {
    const path = await toClient(page, tube.middle);
    await page.mouse.move(path[0].x, path[0].y);
    await page.mouse.down();
    for (const at of path.slice(1)) await page.mouse.move(at.x, at.y);
    await page.mouse.move(path.at(-1).x, 20);
    await page.mouse.up();
    await idle(page);
    await page.mouse.move(300, 600);
    await idle(page);
    assert.ok((await state(page)).parts.length <= 1);
    assert.equal((await state(page)).busy, false);
  }));
