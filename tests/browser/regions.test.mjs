// Puffs and flat pieces by real pointers: drawn round a thing, tapped, dragged, undone and exported.
import assert from 'node:assert/strict';
import test from 'node:test';
import {
  drawWithMouse,
  drawWithTouch,
  exported,
  idle,
  onPage,
  openPicture,
  run,
  state,
  toClient,
  useSite,
} from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

const loop = (x, y, rx, ry) =>
  Array.from({ length: 40 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 39;
    return [x + rx * Math.cos(angle), y + ry * Math.sin(angle)];
  });

async function withPicture(options, work) {
  await onPage(kit, options, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await work(page);
  });
}

for (const [name, options, draw] of [
  ['the mouse', {}, drawWithMouse],
  ['a finger on a phone', phone, drawWithTouch],
]) {
  test(`a line round a thing becomes a puff and a flat piece with ${name}, in one step each`, () =>
    withPicture(options, async (page) => {
      const before = (await state(page)).undo;
      for (const [index, tool] of ['puff', 'sheet'].entries()) {
        await run(page, tool);
        await draw(page, loop(140 + 200 * index, 180, 70, 60));
        await idle(page);
        const { parts, undo } = await state(page);
        assert.equal(parts.length, index + 1);
        assert.equal(parts[index].kind, tool);
        assert.ok(parts[index].triangles > 300);
        assert.equal(undo, before + index + 1);
      }
      assert.ok((await exported(page, 'glb')).length > 10000);
      await run(page, 'undo');
      assert.equal((await state(page)).parts.length, 1);
    }));
}

test('a tap cuts the thing out, used it is a part, its points are dragged, and it turns flat and back', () =>
  withPicture({}, async (page) => {
    await run(page, 'puff');
    const middle = tube.middle[Math.floor(tube.middle.length / 2)];
    const [at] = await toClient(page, [middle]);
    await page.mouse.click(at.x, at.y);
    await idle(page);
    await run(page, 'cut-use');
    let [part] = (await state(page)).parts;
    assert.equal(part.kind, 'puff');
    await run(page, 'make-sheet');
    [part] = (await state(page)).parts;
    assert.equal(part.kind, 'sheet');
    await page.mouse.click(at.x, at.y);
    const [x, y] = part.contours[0][0];
    await drawWithMouse(page, [
      [x, y],
      [x - 10, y - 6],
      [x - 20, y - 12],
    ]);
    await idle(page);
    [part] = (await state(page)).parts;
    assert.ok(Math.hypot(part.contours[0][0][0] - (x - 20), part.contours[0][0][1] - (y - 12)) < 3);
    await run(page, 'make-puff');
    assert.equal((await state(page)).parts[0].kind, 'puff');
  }));
