// Puffs and flat pieces by real pointers: drawn round a thing, and cut out by a box and two brushes. What else the tools
// do is said by tests/unit/web: cut_test, regions_test and words_test.
import assert from 'node:assert/strict';
import test from 'node:test';
import { drawWithFinger, drawWithMouse, press } from './support/hands.mjs';
import {
  done,
  exported,
  idle,
  onPage,
  openPicture,
  run,
  state,
  toastText,
  toClient,
  useSite,
} from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();

const boxRound = [
  [45, 85],
  [240, 160],
  [435, 235],
];

/** Square picture pixels of outlines, holes and all. */
function areaOf(contours) {
  const twice = (points) =>
    points.reduce((sum, [x, y], i) => {
      const [px, py] = points[(i + points.length - 1) % points.length];
      return sum + px * y - x * py;
    }, 0);
  return Math.abs(contours.reduce((sum, points) => sum + twice(points) / 2, 0));
}

test('a line round a thing becomes a puff and a flat piece with the mouse, in one step each', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    const before = (await state(page)).undo;
    for (const [index, tool] of ['puff', 'sheet'].entries()) {
      await run(page, tool);
      const loop = Array.from({ length: 14 }, (_, i) => {
        const angle = (2 * Math.PI * i) / 13;
        return [140 + 200 * index + 70 * Math.cos(angle), 180 + 60 * Math.sin(angle)];
      });
      await drawWithMouse(page, loop, { count: loop.length });
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

test('a box cuts the thing out, brushes correct it, and it becomes a part in one step', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await run(page, 'puff');
    const { undo } = await state(page);
    await done(page, 'cut-by-box');
    await drawWithMouse(page, boxRound);
    const whole = (await state(page)).cut;
    assert.ok(whole && whole.contours.length >= 1, 'something is cut out');
    const area = areaOf(whole.contours);
    await run(page, 'cut-remove');
    const middle = tube.middle[30];
    await drawWithMouse(page, [[middle[0], middle[1] - 45], middle, [middle[0], middle[1] + 45]]);
    const less = (await state(page)).cut;
    assert.equal(less.marks, 1);
    assert.ok(areaOf(less.contours) < area - 200, `${areaOf(less.contours)} of ${area}`);
    await done(page, 'undo');
    assert.ok(Math.abs(areaOf((await state(page)).cut.contours) - area) < 1);
    assert.equal((await state(page)).parts.length, 0);
    await done(page, 'cut-use');
    const now = await state(page);
    assert.equal(now.cut, null);
    assert.equal(now.parts.length, 1);
    assert.equal(now.undo, undo + 1);
    assert.ok(Math.abs(areaOf(now.parts[0].contours) - area) < 1);
    assert.ok((await exported(page, 'stl')).length > 1000);
  }));

test('on paper a tap in a line drawn by a pen cuts out what it encloses, with its gap; beside it a sentence says so', () =>
  onPage(kit, { hasTouch: true }, async (page) => {
    await page.locator('#paper').tap();
    await idle(page);
    const { width, height } = (await state(page)).picture;
    const [x, y, radius] = [width / 2, height / 2, width / 4];
    const ring = Array.from({ length: 40 }, (_, i) => {
      const angle = 0.2 + ((2 * Math.PI - 0.35) * i) / 39;
      return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
    });
    await drawWithFinger(page, ring, { count: ring.length });
    await press(page, 'Puff', { touch: true });
    assert.equal((await state(page)).tool, 'puff');
    const tap = async (at) => {
      const [client] = await toClient(page, [at]);
      await page.touchscreen.tap(client.x, client.y);
      await idle(page);
    };
    await tap([x, y - 1.5 * radius]);
    assert.equal((await state(page)).cut, null);
    assert.match(await page.locator('#toasts').innerText(), /no clear thing there/);
    await tap([x - radius / 3, y]);
    const { cut } = await state(page);
    const share = areaOf(cut.contours) / (Math.PI * radius * radius);
    assert.ok(share > 0.95 && share < 1.05, `${share}`);
    await run(page, 'cut-use');
    const { parts } = await state(page);
    assert.deepEqual([parts.length, parts[0].kind, parts[0].failure], [1, 'puff', null]);
  }));

test('the program that cuts out comes with the first tool that needs it; where it cannot be loaded that is said, and trying again is enough', () =>
  onPage(kit, { alone: true }, async (page, { context, troubles }) => {
    const asked = [];
    page.context().on('request', (request) => /cut_out/.test(request.url()) && asked.push(request.url()));
    await context.route(/cut_out.*\.wasm/, (route) => route.abort());
    await openPicture(page, tube.png, 'tube.png');
    await done(page, 'draw-spine', { stroke: tube.middle });
    assert.deepEqual(asked, [], 'a line needs no cut-out');
    await run(page, 'puff');
    await done(page, 'cut-start', { at: tube.middle[30] });
    assert.match(await toastText(page), /could not be loaded\. Nothing is lost: check the connection/);
    assert.equal((await state(page)).cut, null);
    await context.unroute(/cut_out.*\.wasm/);
    await done(page, 'cut-start', { at: tube.middle[30] });
    assert.ok(areaOf((await state(page)).cut.contours) > 1000);
    const { engine, cutter } = await page.evaluate(() => window.spineloft.memory());
    assert.ok(cutter > 0 && cutter < engine, `${cutter} of ${engine} bytes`);
    troubles.splice(0);
  }));
