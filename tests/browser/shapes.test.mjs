// Shapes by real pointers: a shape in three gestures, its front and side drawn in six. What else the tool does is said
// by tests/unit/web/shape_tool_test.cpp.
import assert from 'node:assert/strict';
import test from 'node:test';
import { onCanvas, press, strokeAlong } from './support/hands.mjs';
import { parseStl } from './support/model_files.mjs';
import { sample } from '../support/rounds.mjs';
import {
  exported,
  idle,
  kDesk,
  kHands,
  kPhone,
  onPage,
  reload,
  run,
  state,
  toClient,
  useSite,
} from './support/page.mjs';

const kit = useSite();

/** A closed line, picture pixels. */
const ellipse = (x, y, a, b, count = 24) =>
  Array.from({ length: count + 1 }, (_, i) => {
    const t = (2 * Math.PI * i) / count;
    return [x + a * Math.sin(t), y + b * Math.cos(t)];
  });

const shape = async (page, at = -1) => (await state(page)).parts.at(at).shape;

const draw = async (page, device, points, options) => strokeAlong(page, device, await toClient(page, points), options);

/** Client position of a handle. */
async function hold(page, kind) {
  const handle = (await state(page)).shapeHandles.find((one) => one.hold === kind);
  assert.ok(handle, `no ${kind}`);
  return (await onCanvas(page, handle.at))[0];
}

/** Extents of a closed line along both axes. */
function extents(line) {
  const xs = line.map(([x]) => x);
  const ys = line.map(([, y]) => y);
  return { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), foot: Math.max(...ys) };
}

function near(actual, expected, slack, what) {
  for (const key of Object.keys(expected)) {
    assert.ok(
      Math.abs(actual[key] - expected[key]) <= slack,
      `${what}: ${key} is ${actual[key]}, not ${expected[key]}`,
    );
  }
}

/** Paper of 600 × 450, and one of 300 × 300 for the side; the first one is in view. */
async function twoSheets(page) {
  await run(page, 'new-sketch', { width: 600, height: 450 });
  await run(page, 'new-sketch', { width: 300, height: 300 });
  await run(page, 'select-picture', { picture: 1 });
  await idle(page);
}

for (const [device, size, options] of sample(kHands, 4)) {
  test(`a shape in three gestures, front and side in six: ${device}, ${size}`, () =>
    onPage(kit, options, async (page) => {
      await twoSheets(page);
      let seen = 0;
      const midway = async (shown) => {
        seen = (await state(shown)).preview?.triangles ?? 0;
      };
      // What the page shows first is for the device that was used last.
      const [corner] = await toClient(page, [[5, 5]]);
      await strokeAlong(page, device, [corner]);
      let gestures = 0;
      const count = async (gesture) => {
        await gesture;
        gestures += 1;
      };
      const tap = (words) => count(press(page, words, { touch: device === 'finger' }));
      const line = (points, which) => count(draw(page, device, points, which));

      await tap('Shapes');
      await line(
        [
          [300, 360],
          [300, 300],
          [300, 200],
          [301, 90],
        ],
        { midway },
      );
      assert.ok(seen > 100, 'the solid follows the pen');
      let made = await shape(page);
      assert.equal(made.kind, 'ball');
      assert.ok(Math.abs(made.axis[0][1] - 360) < 4 && Math.abs(made.axis[1][1] - 90) < 4, JSON.stringify(made.axis));
      assert.ok(gestures <= 3);

      const { undo } = await state(page);
      seen = 0;
      await line(ellipse(300, 225, 90, 140), { midway });
      assert.ok(seen > 100);
      assert.equal((await state(page)).undo, undo + 1);
      near(
        extents((await state(page)).shapeOutline),
        { left: 210, right: 390, top: 85, foot: 365 },
        4,
        'the front outline',
      );

      // The other picture is a side; it shows the thing half as high.
      await tap((await state(page)).pictureList[1].name);
      await tap('Looks left');
      assert.equal((await state(page)).pictureList[1].view.from, 'right');
      await line(ellipse(150, 150, 30, 70));
      assert.ok(gestures <= 6, `${gestures} gestures`);
      const now = await state(page);
      near(extents(now.shapeOutline), { left: 120, right: 180, top: 80, foot: 220 }, 3, 'the side outline');
      assert.ok(Math.abs(now.pictureList[1].view.scale - 2) < 0.06, `scale ${now.pictureList[1].view.scale}`);
      made = await shape(page);
      assert.deepEqual(
        made.outlines.map(({ picture }) => picture),
        [1, 2],
      );
      assert.equal(now.parts[0].failure, null);
    }));
}

test('handles by pen: an end, the width, and the depth in the side picture', () =>
  onPage(kit, kDesk, async (page) => {
    await twoSheets(page);
    await run(page, 'draw-shape', {
      kind: 'cylinder',
      axis: [
        [300, 350],
        [300, 150],
      ],
      width: 100,
    });
    await run(page, 'shapes');
    await idle(page);
    const pull = async (kind, dx, dy) => {
      const from = await hold(page, kind);
      await strokeAlong(
        page,
        'pen',
        [0, 0.3, 0.6, 1].map((t) => ({ x: from.x + t * dx, y: from.y + t * dy })),
      );
    };
    const before = await shape(page);
    await pull('to', 0, 30);
    assert.ok((await shape(page)).axis[1][1] > before.axis[1][1] + 5);
    await pull('width', 20, 0);
    assert.ok((await shape(page)).width > before.width + 5);
    await run(page, 'side-picture', { picture: 2, from: 'left' });
    await idle(page);
    assert.equal((await state(page)).picture.id, 2);
    await pull('depth', 15, 0);
    assert.ok((await shape(page)).ratio > 1.05);
  }));

// A page of their own: where a pen was in use, a finger moves the picture.
const kSides = [
  ['mouse', '1440×900', kDesk],
  ['finger', '390×844', kPhone],
];
for (const [device, size, options] of sample(kSides, 0)) {
  test(`a puff is as deep as the line round it in the side picture says, until that goes: ${device}, ${size}`, () =>
    onPage(kit, { alone: true, ...options }, async (page) => {
      await twoSheets(page);
      const [corner] = await toClient(page, [[5, 5]]);
      await strokeAlong(page, device, [corner]);
      await run(page, 'draw-puff', { contours: [ellipse(300, 225, 90, 140).slice(0, -1)] });
      await idle(page);
      /** Depth over height. */
      const depth = async () => {
        const corners = parseStl(await exported(page, 'stl')).flat();
        const extent = (axis) => {
          const all = corners.map((corner) => corner[axis]);
          return Math.max(...all) - Math.min(...all);
        };
        return extent(1) / extent(2); // millimetres, z up
      };
      const before = await depth();
      const touch = device === 'finger';
      await run(page, 'shapes'); // on a phone it is among what the page shows on demand
      await press(page, (await state(page)).pictureList[1].name, { touch });
      await press(page, 'Looks left', { touch });
      const { undo } = await state(page);
      await draw(page, device, ellipse(150, 150, 30, 100));
      const now = await state(page);
      assert.equal(now.undo, undo + 1);
      assert.equal(now.parts[0].failure, null);
      assert.equal(now.parts[0].side.picture, 2);
      near({ ratio: await depth() }, { ratio: 0.3 }, 0.01, 'the depth');
      await run(page, 'plain-side');
      await idle(page);
      near({ ratio: await depth() }, { ratio: before }, 1e-6, 'the depth as it was');
    }));
}

test('shapes by keyboard alone, and by a screen reader; a reload and the GLB have them', () =>
  onPage(kit, { alone: true }, async (page) => {
    await run(page, 'new-sketch', { width: 600, height: 450 });
    await idle(page);
    await page.locator('#canvas').focus();
    await page.keyboard.press('0');
    await idle(page);
    assert.equal((await state(page)).tool, 'shapes');
    await page.getByRole('button', { name: 'Cone', exact: true }).press('Enter');
    await idle(page);
    assert.equal((await state(page)).nextShape, 'cone');
    await run(page, 'draw-shape', {
      kind: 'cone',
      axis: [
        [300, 350],
        [300, 150],
      ],
      width: 100,
    });
    await idle(page);
    await page.locator('#canvas').focus();
    await page.keyboard.press('.');
    await page.keyboard.press('.');
    await page.keyboard.press('Shift+ArrowUp');
    await page.keyboard.press('Shift+ArrowUp');
    await idle(page);
    assert.equal((await state(page)).chosen.shapeHandle, 1);
    assert.equal(Math.round((await shape(page)).axis[1][1]), 130);
    const slider = page.getByRole('slider', { name: 'End of the shape: from above' });
    await slider.press('ArrowRight');
    await idle(page);
    assert.ok((await shape(page)).axis[1][1] > 130);
    const kept = await shape(page);
    const glb = await exported(page, 'glb');
    assert.ok(glb.length > 5000);
    await reload(page);
    assert.deepEqual(await shape(page), kept);
    assert.deepEqual(await exported(page, 'glb'), glb);
  }));
