// Paper, pen and eraser, and several pictures on one board.
import assert from 'node:assert/strict';
import test from 'node:test';
import {
  dropFiles,
  drawWithMouse,
  drawWithTouch,
  idle,
  kEngines,
  onPage,
  openPicture,
  pixels,
  run,
  state,
  tapWith,
  toastText,
  toClient,
  useSite,
  waitForPicture,
} from './support/page.mjs';
import { paintedPng, tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();
const tablet = { viewport: { width: 1024, height: 768 }, hasTouch: true };
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

/** Two sides of a jar, open above and below, and a line between them. */
const left = Array.from({ length: 15 }, (_, i) => [240, 200 + 30 * i]);
const right = Array.from({ length: 15 }, (_, i) => [480, 200 + 30 * i]);
const middle = Array.from({ length: 12 }, (_, i) => [360, 230 + 33 * i]);

/** A pen line with this pressure all along. */
async function penLine(page, points, force) {
  const path = await toClient(page, points);
  const session = await page.context().newCDPSession(page);
  const send = (type, at, buttons) =>
    session.send('Input.dispatchMouseEvent', {
      type,
      x: at.x,
      y: at.y,
      button: 'left',
      buttons,
      clickCount: 1,
      pointerType: 'pen',
      force: buttons ? force : 0,
    });
  await send('mousePressed', path[0], 1);
  for (const at of path.slice(1)) await send('mouseMoved', at, 1);
  await send('mouseReleased', path.at(-1), 0);
  await session.detach();
  await idle(page);
}

/** How much ink is on the screen round a picture point: dark pixels of a small square. */
async function inkAt(page, x, y, reach = 12) {
  const [at] = await toClient(page, [[x, y]]);
  const shot = await pixels(page, {
    x: Math.round(at.x) - reach,
    y: Math.round(at.y) - reach,
    width: 2 * reach,
    height: 2 * reach,
  });
  // By darkness, so that a fine line between two rows of pixels counts as much as one on a row.
  let dark = 0;
  for (let i = 0; i < shot.data.length; i += 4) dark += 1 - shot.data[i] / 255;
  return Math.round(dark);
}

for (const { name, isolated } of kEngines) {
  test(`from the start page to paper, two lines, a bone and a solid (${name})`, () =>
    onPage(kit, { isolated }, async (page) => {
      await page.getByRole('button', { name: 'Draw on paper' }).click();
      await idle(page);
      let now = await state(page);
      assert.equal(now.tool, 'pen');
      assert.equal(now.picture.sketch, true);
      assert.match(await page.locator('#hint').innerText(), /outline/);
      await run(page, 'remove-picture');
      await run(page, 'new-sketch', { width: 768, height: 1024 });
      await drawWithMouse(page, left);
      assert.equal(await page.locator('#hint').isVisible(), false);
      await drawWithMouse(page, right);
      now = await state(page);
      assert.equal(now.picture.strokes, 2);
      assert.equal(now.parts.length, 0);
      assert.match(await page.locator('#hint').innerText(), /bone/);
      assert.ok((await inkAt(page, 240, 410)) > 10);
      await page.locator('[data-command=draw]').click();
      await drawWithMouse(page, middle);
      now = await state(page);
      assert.equal(now.parts.length, 1);
      const ribs = now.parts[0].ribs;
      const near = ribs.filter((rib) => Math.abs(rib.left[0] - 480) < 8 && Math.abs(rib.right[0] - 240) < 8);
      assert.ok(near.length > 0.8 * ribs.length, `${near.length} of ${ribs.length} ribs reach the lines`);
    }));
}

test('undo takes one stroke, by key and by button, and redo brings it back', () =>
  onPage(kit, {}, async (page) => {
    await run(page, 'new-sketch', { width: 768, height: 1024 });
    await drawWithMouse(page, left);
    await drawWithMouse(page, right);
    const strokes = async () => (await state(page)).picture.strokes;
    await page.keyboard.press('Control+z');
    await idle(page);
    assert.equal(await strokes(), 1);
    assert.equal(await inkAt(page, 480, 410), 0);
    await page.locator('[data-command=redo]').click();
    await idle(page);
    assert.equal(await strokes(), 2);
    assert.ok((await inkAt(page, 480, 410)) > 10);
  }));

test('ink is on the screen while the pen is down; Escape takes it back', () =>
  onPage(kit, {}, async (page) => {
    await run(page, 'new-sketch', { width: 768, height: 1024 });
    const [from, to] = await toClient(page, [
      [240, 300],
      [480, 300],
    ]);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move((from.x + to.x) / 2, from.y);
    await page.mouse.move(to.x, to.y);
    await page.waitForFunction(() => window.spineloft.state().pen.points > 2);
    await page.waitForTimeout(120);
    assert.ok((await inkAt(page, 300, 300)) > 10, 'live ink');
    assert.equal((await state(page)).picture.strokes, 0);
    await page.keyboard.press('Escape');
    await page.mouse.up();
    await idle(page);
    assert.equal((await state(page)).picture.strokes, 0);
    assert.equal(await inkAt(page, 300, 300), 0);
  }));

test('a pen draws wider when it is pressed harder; the eraser makes paper again', () =>
  onPage(kit, tablet, async (page) => {
    await run(page, 'new-sketch', { width: 768, height: 1024 });
    await run(page, 'pen-size', { size: 'bold' });
    await penLine(
      page,
      [
        [100, 300],
        [300, 300],
        [600, 300],
      ],
      0.15,
    );
    await penLine(
      page,
      [
        [100, 600],
        [300, 600],
        [600, 600],
      ],
      0.95,
    );
    const light = await inkAt(page, 350, 300),
      heavy = await inkAt(page, 350, 600);
    assert.ok(light > 0 && heavy > 1.5 * light, `${light} and ${heavy}`);
    await run(page, 'eraser');
    await run(page, 'pen-size', { size: 'bold' });
    await penLine(
      page,
      [
        [330, 600],
        [350, 600],
        [370, 600],
      ],
      0.5,
    );
    assert.equal(await inkAt(page, 350, 600, 5), 0);
    assert.ok((await inkAt(page, 150, 600)) > 0);
  }));

test('a phone: paper fits, a finger draws, two fingers take the stroke back', () =>
  onPage(kit, phone, async (page) => {
    await page.getByRole('button', { name: 'Draw on paper' }).tap();
    await idle(page);
    const { picture } = await state(page);
    const [a, b] = await toClient(page, [
      [0, 0],
      [picture.width - 1, picture.height - 1],
    ]);
    assert.ok(a.x >= 0 && b.x <= 390 && b.y - a.y > 150, JSON.stringify([a, b]));
    const { width, height } = picture;
    await drawWithTouch(page, [
      [width * 0.3, height * 0.3],
      [width * 0.5, height * 0.2],
      [width * 0.7, height * 0.3],
    ]);
    assert.equal((await state(page)).picture.strokes, 1);
    await tapWith(page, 2, a);
    assert.equal((await state(page)).picture.strokes, 0);
  }));

test('several files dropped at once all open; keys go from picture to picture, parts stay together', () =>
  onPage(kit, {}, async (page) => {
    const grey = paintedPng(300, 200, (x) => (x < 150 ? [40, 40, 40] : [230, 230, 230]));
    await dropFiles(page, [kit.file('one.png', tube.png), kit.file('two.png', grey)]);
    await page.waitForFunction(() => window.spineloft.state().pictures === 2, undefined, { timeout: 15000 });
    await waitForPicture(page);
    assert.deepEqual(
      (await state(page)).pictureList.map((entry) => entry.name),
      ['one.png', 'two.png'],
    );
    await page.keyboard.press('PageUp');
    await idle(page);
    assert.equal((await state(page)).picture.name, 'one.png');
    await drawWithMouse(page, tube.middle);
    await page.keyboard.press('PageDown');
    await idle(page);
    await run(page, 'draw-spine', {
      stroke: [
        [20, 60],
        [20, 150],
      ],
    });
    await idle(page);
    const { parts } = await state(page);
    assert.equal(parts.length, 2);
    assert.notEqual(parts[0].picture, parts[1].picture);
    await run(page, 'select-part', { id: parts[0].id });
    await idle(page);
    assert.equal((await state(page)).picture.name, 'one.png');
    await run(page, 'remove-picture');
    assert.match(await toastText(page, 'status'), /one\.png and its part.*Undo/);
    await idle(page);
    assert.equal((await state(page)).parts.length, 1);
    await page.keyboard.press('Control+z');
    await idle(page);
    assert.equal((await state(page)).parts.length, 2);
    assert.equal((await state(page)).pictures, 2);
  }));

test('an idle page with a sketch and two pictures draws nothing', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await run(page, 'new-sketch', { width: 768, height: 1024 });
    await drawWithMouse(page, left);
    await page.mouse.move(2, 2);
    await page.waitForTimeout(1200);
    const { frames } = await state(page);
    await page.waitForTimeout(700);
    assert.equal((await state(page)).frames, frames);
  }));
