// Paper, pen and eraser, and several pictures on one board.
import assert from 'node:assert/strict';
import test from 'node:test';
import { drawWithFinger, drawWithMouse, drawWithPen, tapWith } from './support/hands.mjs';
import {
  done,
  dropFiles,
  framed,
  idle,
  kPhone,
  kSharp,
  onPage,
  pixels,
  run,
  state,
  toClient,
  useSite,
} from './support/page.mjs';
import { paintedPng, tubePicture } from './support/pictures.mjs';

const kit = useSite();
const kPaper = { width: 768, height: 1024 };

/** Two sides of a jar, open above and below, and a line between them. */
const down = (x, from, to) => Array.from({ length: 7 }, (_, i) => [x, from + ((to - from) * i) / 6]);
const left = down(240, 200, 620);
const right = down(480, 200, 620);
const middle = down(360, 230, 593);

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

test('from the start page to paper, two lines, a bone and a solid', () =>
  onPage(kit, kSharp, async (page) => {
    await page.getByRole('button', { name: 'Draw on paper' }).click();
    await idle(page);
    let now = await state(page);
    assert.equal(now.tool, 'pen');
    assert.equal(now.picture.sketch, true);
    assert.match(await page.locator('#hint').innerText(), /outline/);
    await run(page, 'remove-picture');
    await run(page, 'new-sketch', kPaper);
    await drawWithMouse(page, left);
    assert.equal(await page.locator('#hint').isVisible(), false);
    await drawWithMouse(page, right);
    now = await state(page);
    assert.equal(now.picture.strokes, 2);
    assert.equal(now.parts.length, 0);
    assert.match(await page.locator('#hint').innerText(), /middle/);
    assert.ok((await inkAt(page, 240, 410)) > 10);
    await page.locator('#bar-items [data-command=draw]').click();
    await drawWithMouse(page, middle);
    now = await state(page);
    assert.equal(now.parts.length, 1);
    const ribs = now.parts[0].ribs;
    const near = ribs.filter((rib) => Math.abs(rib.left[0] - 480) < 8 && Math.abs(rib.right[0] - 240) < 8);
    assert.ok(near.length > 0.8 * ribs.length, `${near.length} of ${ribs.length} ribs reach the lines`);
  }));

test('a pen draws wider when it is pressed harder, with the ink on the screen before it lifts; the eraser makes paper again', () =>
  onPage(kit, kSharp, async (page) => {
    await run(page, 'new-sketch', kPaper);
    await run(page, 'pen-size', { size: 'bold' });
    const across = (y, from = 100, to = 600) => [
      [from, y],
      [(from + to) / 2, y],
      [(from + 2 * to) / 3, y],
      [to, y],
    ];
    await drawWithPen(page, across(300), {
      force: 0.15,
      midway: async () => {
        await page.waitForFunction(() => window.spineloft.state().pen.points > 2);
        await framed(page);
        assert.ok((await inkAt(page, 200, 300)) > 0, 'live ink');
        assert.equal((await state(page)).picture.strokes, 0);
      },
    });
    await drawWithPen(page, across(600), { force: 0.95 });
    const light = await inkAt(page, 350, 300),
      heavy = await inkAt(page, 350, 600);
    assert.ok(light > 0 && heavy > 1.5 * light, `${light} and ${heavy}`);
    await run(page, 'eraser');
    await run(page, 'pen-size', { size: 'bold' });
    await drawWithPen(page, across(600, 330, 370), { force: 0.5 });
    assert.equal(await inkAt(page, 350, 600, 5), 0);
    assert.ok((await inkAt(page, 150, 600)) > 0);
  }));

test('a phone: paper fits, a finger draws, two fingers take the stroke back', () =>
  onPage(kit, kPhone, async (page) => {
    await page.getByRole('button', { name: 'Draw on paper' }).tap();
    await idle(page);
    const { picture } = await state(page);
    const [a, b] = await toClient(page, [
      [0, 0],
      [picture.width - 1, picture.height - 1],
    ]);
    assert.ok(a.x >= 0 && b.x <= 390 && b.y - a.y > 150, JSON.stringify([a, b]));
    const { width, height } = picture;
    await drawWithFinger(page, [
      [width * 0.3, height * 0.3],
      [width * 0.5, height * 0.2],
      [width * 0.7, height * 0.3],
    ]);
    assert.equal((await state(page)).picture.strokes, 1);
    await tapWith(page, 2, a);
    assert.equal((await state(page)).picture.strokes, 0);
  }));

test('several files dropped at once all open, in their order; each part stays with its own', () =>
  onPage(kit, kSharp, async (page) => {
    const tube = tubePicture();
    const grey = paintedPng(300, 200, (x) => (x < 150 ? [40, 40, 40] : [230, 230, 230]));
    await dropFiles(page, [kit.file('one.png', tube.png), kit.file('two.png', grey)]);
    await page.waitForFunction(() => window.spineloft.state().pictures === 2);
    await idle(page);
    assert.deepEqual(
      (await state(page)).pictureList.map((entry) => entry.name),
      ['one.png', 'two.png'],
    );
    await done(page, 'draw-spine', { stroke: down(20, 60, 150) });
    await page.keyboard.press('PageUp');
    await idle(page);
    assert.equal((await state(page)).picture.name, 'one.png');
    await done(page, 'draw-spine', { stroke: tube.middle });
    const { parts } = await state(page);
    assert.equal(parts.length, 2);
    assert.notEqual(parts[0].picture, parts[1].picture);
  }));
