// One test for each kind of gesture and each device: what mouse, finger, pen, wheel and keys do reaches the model. What a
// gesture means there is said by tests/unit/web.
import assert from 'node:assert/strict';
import test from 'node:test';
import {
  dragMouse,
  drawWithFinger,
  drawWithMouse,
  drawWithPen,
  line,
  press,
  strokeAlong,
  tapWith,
} from './support/hands.mjs';
import {
  difference,
  done,
  framed,
  idle,
  kPhone,
  kTablet,
  onPage,
  openPicture,
  openWithPart,
  pixels,
  run,
  state,
  toClient,
  useSite,
} from './support/page.mjs';
import { paintedPng, samples, tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();

/** A line where a photo shows nothing: its width is a guess, and the page offers to draw again. */
async function drawBesideAll(page) {
  const [width, height] = [480, 360];
  await openPicture(
    page,
    paintedPng(width, height, () => [250, 250, 250]),
  );
  await run(page, 'draw');
  await drawWithFinger(page, line([width / 2, height * 0.35], [width / 2, height * 0.7]));
}

const withTube = (options, work) =>
  onPage(kit, options, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await work(page);
  });

const partCount = async (page) => (await state(page)).parts.length;

for (const [name, screen] of Object.entries({ 'a tablet': kTablet, 'a phone': kPhone })) {
  test(`one finger draws on ${name}, two-finger tap undoes, three-finger tap redoes`, () =>
    withTube(screen, async (page) => {
      await drawWithFinger(page, tube.middle);
      assert.equal(await partCount(page), 1);
      const [corner] = await toClient(page, [[20, 20]]);
      await tapWith(page, 2, corner);
      assert.equal(await partCount(page), 0);
      await tapWith(page, 3, corner);
      assert.equal(await partCount(page), 1);
    }));
}

test('a phone: the page fits its width and every command is within reach', () =>
  withTube(kPhone, async (page) => {
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
    for (const id of ['#bar-more', '#bar-save', '[data-command=draw]', '[data-command=undo]']) {
      const box = await page.locator(id).first().boundingBox();
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
    for (const wanted of ['New part', 'Find a command', 'Help']) {
      assert.ok(
        labels.some((label) => label.startsWith(wanted)),
        labels.join(),
      );
    }
    await page.keyboard.press('Escape');
  }));

test('a phone: what is said lies on the panel and leaves its tabs free, with a button as well', () =>
  onPage(kit, kPhone, async (page) => {
    await drawBesideAll(page);
    const toast = page.locator('.toast').last();
    await toast.getByRole('button', { name: 'Try again' }).waitFor();
    const tabs = (await state(page)).controls.filter(({ kind }) => kind === 'tab');
    assert.ok(tabs.length > 2);
    const canvas = await page.locator('#canvas').boundingBox();
    const { y } = await toast.boundingBox();
    for (const { words, at } of tabs) assert.ok(canvas.y + at[1] + at[3] <= y + 1, words);
    // It goes when the hand goes on, once it could be read.
    const [{ at }] = tabs;
    const tap = () => page.touchscreen.tap(canvas.x + at[0] + at[2] / 2, canvas.y + at[1] + at[3] / 2);
    await page.waitForTimeout(1600);
    await tap();
    await toast.waitFor({ state: 'detached', timeout: 1000 });
  }));

test('on a tablet what is said leaves the tools at the foot of the views free', () =>
  onPage(kit, kTablet, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await done(page, 'check-print');
    await page.locator('.toast').last().waitFor();
    await framed(page);
    const said = await page.locator('.toast').last().boundingBox();
    const canvas = await page.locator('#canvas').boundingBox();
    const tools = (await state(page)).controls.filter(({ words }) => ['Puff', 'Home view'].includes(words));
    assert.ok(tools.length > 1);
    for (const { words, at } of tools) assert.ok(said.y + said.height <= canvas.y + at[1], words);
  }));

test('what a toast says of a model goes when another one is opened', () =>
  onPage(kit, kPhone, async (page) => {
    await drawBesideAll(page);
    const offer = page.locator('.toast').getByRole('button', { name: 'Try again' });
    await offer.waitFor();
    await done(page, 'new-model');
    assert.equal(await offer.count(), 0);
    await openWithPart(page, tube.png, tube.middle);
    await done(page, 'check-print');
    assert.notEqual(await page.locator('.toast').count(), 0);
    await done(page, 'new-model');
    assert.equal(await page.locator('.toast').count(), 0, 'what was said of the model is gone, too');
  }));

test('the smallest phone: one column of tools beside the picture, and a tap on the dots brings the others by their names', () =>
  withTube({ ...kPhone, draws: true }, async (page) => {
    await page.setViewportSize({ width: 320, height: 568 });
    await idle(page);
    await done(page, 'draw-spine', { stroke: tube.middle });
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
    await press(page, 'Layers', { touch: true });
    assert.equal((await state(page)).tool, 'layers');
    await page.setViewportSize(kPhone.viewport);
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
    const points = [
      [100, 200],
      [300, 200],
    ];
    const [anchor, other] = await toClient(page, points);
    await page.mouse.move(anchor.x, anchor.y);
    await page.mouse.wheel(0, -240);
    await page.waitForFunction((x) => window.spineloft.imageToClient(300, 200).x > x + 1, other.x);
    await idle(page);
    const [anchorAfter, otherAfter] = await toClient(page, points);
    assert.ok(Math.hypot(anchorAfter.x - anchor.x, anchorAfter.y - anchor.y) < 1.5, 'the point under the cursor stays');
    assert.ok(otherAfter.x - anchorAfter.x > 1.05 * (other.x - anchor.x), 'everything else spreads');
  }));

test('dragging in the solid view turns it, and Home brings it back', () =>
  withTube({}, async (page) => {
    await done(page, 'draw-spine', { stroke: tube.middle });
    const yaw = async () => (await state(page)).camera.yaw;
    const home = await yaw();
    await dragMouse(page, { x: 600, y: 380 }, 120, 40);
    assert.ok(Math.abs((await yaw()) - home) > 0.1, 'turned');
    assert.equal(await partCount(page), 1);
    await page.keyboard.press('h');
    await idle(page);
    assert.ok(Math.abs((await yaw()) - home) < 1e-6, 'home again');
  }));

test('a stroke in hand is dropped without a trace by Escape, the right button and a second finger', () =>
  withTube(kTablet, async (page) => {
    const before = await state(page);
    const path = await toClient(page, line([90, 190], [300, 150], 5));
    const pressed = async () => {
      await page.mouse.move(path[0].x, path[0].y);
      await page.mouse.down();
      for (const at of path.slice(1)) await page.mouse.move(at.x, at.y);
      assert.notEqual((await state(page)).preview, null);
    };
    const dropped = async (how) => {
      await idle(page);
      const { parts, undo, preview } = await state(page);
      assert.deepEqual([parts, undo, preview], [[], before.undo, null], how);
    };
    await pressed();
    await page.keyboard.press('Escape');
    await page.mouse.move(path[1].x, path[1].y);
    await page.mouse.up();
    await dropped('Escape');
    await pressed();
    await page.mouse.down({ button: 'right' });
    await page.mouse.up({ button: 'right' });
    await page.mouse.up();
    await dropped('the right button');
    const session = await page.context().newCDPSession(page);
    const touch = (type, ...points) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(({ x, y }, id) => ({ x, y, id })) });
    // Far enough to be no part of a two-finger tap, which would undo.
    await touch('touchStart', path[0]);
    await touch('touchMove', path[2]);
    assert.notEqual((await state(page)).preview, null);
    await touch('touchStart', path[2], { x: path[2].x + 90, y: path[2].y + 60 });
    await touch('touchEnd');
    await session.detach();
    await dropped('a second finger');
  }));

// After the finger's: once a pen was seen, fingers move the picture.
test('a pen draws, the solid grows with it, and its palm does not disturb', () =>
  withTube({ ...kTablet, draws: true }, async (page) => {
    const before = await pixels(page);
    await drawWithPen(page, tube.middle, {
      midway: async () => {
        const session = await page.context().newCDPSession(page);
        const touch = (type, ...touchPoints) => session.send('Input.dispatchTouchEvent', { type, touchPoints });
        const [palm] = await toClient(page, [[tube.width * 0.5, tube.height * 0.9]]);
        await touch('touchStart', { ...palm, id: 5 });
        await touch('touchMove', { x: palm.x - 60, y: palm.y, id: 5 });
        await touch('touchEnd');
        await page.waitForFunction(() => window.spineloft.state().preview?.fresh);
        await framed(page);
        assert.ok(difference(before, await pixels(page)) > 0.01);
      },
    });
    assert.equal(await partCount(page), 1);
  }));

test('a stroke that ends outside of the canvas still ends', () =>
  withTube({}, async (page) => {
    const path = await toClient(page, line(tube.middle[0], tube.middle.at(-1), 5));
    await strokeAlong(page, 'mouse', [...path, { x: path.at(-1).x, y: 20 }]);
    await page.mouse.move(300, 600);
    await idle(page);
    const { parts, busy, preview } = await state(page);
    assert.ok(parts.length <= 1);
    assert.deepEqual([busy, preview], [false, null]);
  }));

test('a handle is dragged in the picture: a rib end goes with the mouse, in one step of undo', () =>
  onPage(kit, {}, async (page) => {
    const [lemur] = samples();
    await openWithPart(page, lemur.bytes, lemur.spine, 'lemur');
    await run(page, 'set-parameter', { part: 1, key: 'ribs', value: 40 });
    await done(page, 'ribs');
    const ribs = async () => (await state(page)).parts[0].ribs;
    const before = await ribs(),
      { undo } = await state(page);
    const { left, center } = before[20];
    const away = Math.hypot(left[0] - center[0], left[1] - center[1]);
    const to = left.map((x, k) => x + (25 * (x - center[k])) / away);
    await drawWithMouse(page, line(left, to));
    const after = await ribs();
    assert.ok(
      Math.hypot(after[20].left[0] - to[0], after[20].left[1] - to[1]) < 2,
      `${after[20].left} is not at ${to}`,
    );
    assert.equal(after[20].leftState, 'edited');
    assert.deepEqual(after[20].right, before[20].right);
    assert.deepEqual(after[3], before[3], 'far ribs stay');
    assert.equal((await state(page)).undo, undo + 1);
    await run(page, 'undo');
    assert.deepEqual(await ribs(), before);
  }));

test('a finger that comes from the start page presses what it touches on the canvas with its first tap', () =>
  onPage(kit, { hasTouch: true, viewport: { width: 1024, height: 768 } }, async (page) => {
    await page.locator('#paper').tap();
    await idle(page);
    await press(page, 'Line', { touch: true });
    assert.equal((await state(page)).tool, 'draw');
  }));
