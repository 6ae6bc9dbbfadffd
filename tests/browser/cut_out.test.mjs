// Cutting a thing out by real pointers: a box, two brushes, undo, "Use this"; and regions that are no good.
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
  toastText,
  useSite,
  wordsInTheWay,
} from './support/page.mjs';
import { paintedPng, tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

/** Square picture pixels of outlines, holes and all. */
function areaOf(contours) {
  const twice = (points) =>
    points.reduce((sum, [x, y], i) => {
      const [px, py] = points[(i + points.length - 1) % points.length];
      return sum + px * y - x * py;
    }, 0);
  return Math.abs(contours.reduce((sum, points) => sum + twice(points) / 2, 0));
}

const boxRound = [
  [45, 85],
  [240, 160],
  [435, 235],
];

async function withPicture(options, work) {
  await onPage(kit, options, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await run(page, 'puff');
    await work(page);
  });
}

for (const [name, options, draw] of [
  ['the mouse', {}, drawWithMouse],
  ['a finger on a phone', phone, drawWithTouch],
  ['the mouse, without threads', { isolated: false }, drawWithMouse],
]) {
  test(`a box cuts the thing out, brushes correct it, and it becomes a part in one step, with ${name}`, () =>
    withPicture(options, async (page) => {
      const { undo } = await state(page);
      await run(page, 'cut-by-box');
      await idle(page);
      await draw(page, boxRound);
      await idle(page);
      const whole = (await state(page)).cut;
      assert.ok(whole && whole.contours.length >= 1, 'something is cut out');
      const area = areaOf(whole.contours);
      await run(page, 'cut-remove');
      const middle = tube.middle[30];
      await draw(page, [[middle[0], middle[1] - 45], middle, [middle[0], middle[1] + 45]]);
      await idle(page);
      const less = (await state(page)).cut;
      assert.equal(less.marks, 1);
      assert.ok(areaOf(less.contours) < area - 200, `${areaOf(less.contours)} of ${area}`);
      await run(page, 'undo');
      await idle(page);
      assert.ok(Math.abs(areaOf((await state(page)).cut.contours) - area) < 1);
      assert.equal((await state(page)).parts.length, 0);
      await run(page, 'cut-use');
      await idle(page);
      const now = await state(page);
      assert.equal(now.cut, null);
      assert.equal(now.parts.length, 1);
      assert.equal(now.undo, undo + 1);
      assert.ok(Math.abs(areaOf(now.parts[0].contours) - area) < 1);
      assert.ok((await exported(page, 'stl')).length > 1000);
    }));
}

for (const [name, options, draw] of [
  ['the mouse', {}, drawWithMouse],
  ['a finger on a phone', phone, drawWithTouch],
]) {
  test(`a scribble over a thing of two colours cuts out both, a tap one of them, with ${name}`, () =>
    onPage(kit, options, async (page) => {
      const within = (x, y) => x >= 120 && x < 320 && y >= 90 && y < 210;
      await openPicture(
        page,
        paintedPng(440, 300, (x, y) => (!within(x, y) ? [244, 242, 238] : x < 220 ? [40, 60, 140] : [200, 70, 40])),
        'two.png',
      );
      await run(page, 'puff');
      await run(page, 'cut-start', { at: [170, 150] });
      await idle(page);
      const tapped = areaOf((await state(page)).cut.contours);
      await run(page, 'cut-cancel');
      await run(page, 'cut-by-scribble');
      await idle(page);
      await draw(page, [
        [150, 130],
        [200, 170],
        [250, 130],
        [295, 165],
      ]);
      await idle(page);
      const { cut, parts, cutByScribble } = await state(page);
      assert.deepEqual([parts.length, cutByScribble], [0, true]);
      const scribbled = areaOf(cut.contours);
      assert.ok(Math.abs(scribbled - 200 * 120) < 0.06 * 200 * 120, `${scribbled} of ${200 * 120}`);
      assert.ok(tapped < 0.7 * scribbled, `${tapped} by a tap, ${scribbled} by a scribble`);
      await run(page, 'cut-use');
      await idle(page);
      assert.equal((await state(page)).parts.length, 1);
    }));
}

test('Escape leaves a cut-out, and everything is as before', () =>
  withPicture({}, async (page) => {
    const [at] = await toClient(page, [tube.middle[30]]);
    await page.mouse.click(at.x, at.y);
    await idle(page);
    assert.notEqual((await state(page)).cut, null);
    await page.keyboard.press('Escape');
    await idle(page);
    const { cut, parts, undo } = await state(page);
    assert.deepEqual([cut, parts.length, undo], [null, 0, 1]);
  }));

test('regions that are no good are a sentence each, and nothing is lost', () =>
  withPicture({}, async (page) => {
    const loop = (x, y, rx, ry) =>
      Array.from({ length: 30 }, (_, i) => [
        x + rx * Math.cos((i / 29) * 2 * Math.PI),
        y + ry * Math.sin((i / 29) * 2 * Math.PI),
      ]);
    await drawWithMouse(page, loop(120, 260, 40, 40));
    assert.equal((await state(page)).parts.length, 1);
    await run(page, 'select-part', { id: null });
    const refused = async (args, code) => {
      const error = await page.evaluate(
        (values) =>
          window.spineloft.run('draw-puff', values).then(
            () => null,
            (e) => [e.code, e.message],
          ),
        args,
      );
      assert.equal(error?.[0], code);
      assert.match(error[1], /^[A-Z].*[.]$/);
      assert.equal((await state(page)).parts.length, 1);
    };
    await refused({ contours: [] }, 'RegionEmpty');
    await refused(
      {
        contours: [
          [
            [50, 50],
            [51, 50],
            [51, 51],
            [50, 51],
          ],
        ],
      },
      'RegionEmpty',
    );
    await refused(
      {
        contours: [
          [
            [900, 900],
            [990, 900],
            [990, 990],
          ],
        ],
      },
      'RegionOutside',
    );
    // Larger than the picture: cut off at its rim. Crossing itself: untangled.
    await run(page, 'draw-puff', {
      contours: [
        [
          [-200, -200],
          [700, -200],
          [700, 600],
          [-200, 600],
        ],
      ],
    });
    await run(page, 'draw-sheet', {
      contours: [
        [
          [60, 60],
          [200, 200],
          [200, 60],
          [60, 200],
        ],
      ],
    });
    const { parts } = await state(page);
    assert.equal(parts.length, 3);
    for (const part of parts) assert.ok(part.triangles > 100 && part.failure === null);
  }));

test('where there is nothing to cut out the page says so, and goes on', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(
      page,
      paintedPng(300, 200, () => [240, 240, 240]),
      'blank.png',
    );
    await run(page, 'puff');
    const [at] = await toClient(page, [[150, 100]]);
    await page.mouse.click(at.x, at.y);
    assert.match(await toastText(page), /[.]$/);
    await idle(page);
    const { cut, parts } = await state(page);
    assert.deepEqual([cut, parts.length], [null, 0]);
  }));

for (const [width, height] of [
  [1440, 900],
  [1024, 768],
  [390, 844],
  [320, 568],
]) {
  const small = width < 500 ? { hasTouch: true, isMobile: true, deviceScaleFactor: 2 } : {};
  test(`what is to be done with a cut-out covers neither the legend of the ribs nor a button, at ${width} x ${height}`, () =>
    onPage(kit, { viewport: { width, height }, ...small }, async (page) => {
      await openPicture(page, tube.png, 'tube.png');
      await (small.hasTouch ? drawWithTouch : drawWithMouse)(page, tube.middle);
      await run(page, 'puff');
      await run(page, 'cut-start', { at: tube.middle[30] });
      for (const [brush, words] of [
        ['cut-add', 'Draw over what is missing'],
        ['cut-remove', 'Draw over what is too much'],
      ]) {
        await run(page, brush);
        await idle(page);
        assert.deepEqual(await wordsInTheWay(page), []);
        const told = (await state(page)).controls.some(
          (control) => control.kind === 'words' && control.words === words,
        );
        assert.ok(told || height < 600, 'it is told, but in the lowest view');
        if (process.env.SPINELOFT_PICTURES)
          await page.screenshot({ path: `${process.env.SPINELOFT_PICTURES}/words_${width}_${brush}.png` });
      }
    }));
}
