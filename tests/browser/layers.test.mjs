// Parts drawn layer by layer, by real pointers. What else the tool does is said by tests/unit/web/layers_test.cpp.
import assert from 'node:assert/strict';
import test from 'node:test';
import { sample } from '../support/rounds.mjs';
import { control, findControl, onBoard, onCanvas, press, strokeAlong } from './support/hands.mjs';
import { exported, idle, kPhone, kSharp, onPage, pixels, run, state, useSite } from './support/page.mjs';

const kit = useSite();

async function paper(page) {
  await page.getByRole('button', { name: 'Draw on paper' }).click();
  await idle(page);
  await run(page, 'more-tools', { on: true });
  await run(page, 'layers');
  await idle(page);
}

/** Client positions of points of the sheet, of which [-1, -1] … [1, 1] are its corners: their images are projective. */
async function onSheet(page, points) {
  const { corners } = (await state(page)).sheet;
  const [a, b, c, d] = await onCanvas(page, ...corners);
  const minus = (p, q) => ({ x: p.x - q.x, y: p.y - q.y });
  const [e, f, g] = [minus({ x: a.x + c.x, y: a.y + c.y }, { x: b.x + d.x, y: b.y + d.y }), minus(b, c), minus(d, c)];
  const det = f.x * g.y - g.x * f.y;
  const [p, q] = [(e.x * g.y - g.x * e.y) / det, (f.x * e.y - e.x * f.y) / det];
  return points.map(([x, y]) => {
    const [u, v] = [(x + 1) / 2, (y + 1) / 2];
    const w = p * u + q * v + 1;
    const along = (k) => (a[k] + (b[k] * (1 + p) - a[k]) * u + (d[k] * (1 + q) - a[k]) * v) / w;
    return { x: along('x'), y: along('y') };
  });
}

const circle = (x, y, radius, count = 16) =>
  Array.from({ length: count + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });

const draw = async (page, device, points) => strokeAlong(page, device, await onSheet(page, points));

/** Drags the sheet's knob up by CSS pixels. */
async function lift(page, device, by) {
  const [knob] = await onCanvas(page, (await state(page)).sheet.knob);
  const path = [0, 0.3, 0.7, 1].map((t) => ({ x: knob.x, y: knob.y - t * by }));
  await strokeAlong(page, device, path);
}

for (const device of sample(['mouse', 'finger', 'pen'], 2)) {
  test(`a branch that forks takes four gestures: by ${device}`, () =>
    onPage(kit, { hasTouch: true }, async (page) => {
      await paper(page);
      await draw(page, device, circle(0, 0, 0.4));
      let now = await state(page);
      assert.equal(now.parts.length, 1);
      assert.equal(now.parts[0].kind, 'stack');
      await lift(page, device, 170);
      now = await state(page);
      assert.ok(now.sheet.at > 0.3, `${now.sheet.at}`);
      await draw(page, device, circle(-0.5, 0, 0.3));
      await draw(page, device, circle(0.5, 0, 0.3));
      now = await state(page);
      assert.deepEqual(
        now.sheet.layers.map((layer) => layer.curves),
        [1, 2],
      );
      assert.equal(now.parts[0].failure, null);
      assert.equal(now.undo, 4); // the paper, and three lines
      assert.ok((await exported(page, 'stl')).length > 50000);
    }));

  test(`a fork is moved by its knob, and an arm parted from it by a tap: by ${device}`, () =>
    onPage(kit, { hasTouch: true }, async (page) => {
      await paper(page);
      await draw(page, device, circle(0, 0, 0.4));
      await lift(page, device, 170);
      await draw(page, device, circle(-0.5, 0, 0.3));
      await draw(page, device, circle(0.5, 0, 0.3));
      let { sheet, undo } = await state(page);
      assert.deepEqual(
        sheet.links.map(({ on }) => on),
        [true, true],
      );
      const before = sheet.forks[0].at;
      const [knob] = await onCanvas(page, sheet.forks[0].knob);
      await strokeAlong(
        page,
        device,
        [0, 10, 20, 30].map((by) => ({ x: knob.x, y: knob.y + by })),
      );
      ({ sheet, undo } = await state(page));
      assert.ok(sheet.forks[0].at < before - 0.05, `${before} to ${sheet.forks[0].at}`);
      const [mark] = await onCanvas(page, sheet.links[1].mark);
      await strokeAlong(page, device, [mark]);
      const now = await state(page);
      assert.deepEqual(
        now.sheet.links.map(({ on }) => on),
        [true, false],
      );
      assert.deepEqual([now.sheet.forks.length, now.undo, now.parts[0].failure], [0, undo + 1, null]);
    }));
}

test('a hand on a phone takes twelve gestures', () =>
  onPage(kit, kPhone, async (page) => {
    await paper(page);
    await run(page, 'focus-solid');
    await draw(page, 'finger', circle(0, 0, 0.35));
    await lift(page, 'finger', 60);
    await draw(page, 'finger', circle(0, 0, 0.62));
    await lift(page, 'finger', 60);
    for (let i = 0; i < 4; ++i) await draw(page, 'finger', circle(-0.6 + 0.4 * i, 0, 0.15, 8));
    const now = await state(page);
    assert.deepEqual(
      now.sheet.layers.map((layer) => layer.curves),
      [1, 1, 4],
    );
    assert.equal(now.parts[0].failure, null);
  }));

test('a wall by an open line, and a ring of bumps, are chosen in the panel', () =>
  onPage(kit, {}, async (page) => {
    await paper(page);
    await draw(page, 'mouse', [
      [-0.7, -0.3],
      [-0.2, 0.2],
      [0.3, 0.2],
      [0.7, -0.3],
    ]);
    let now = await state(page);
    assert.equal(now.parts.length, 1);
    assert.equal(now.parts[0].failure, null);
    assert.ok(await findControl(page, 'Wall', { kind: 'slider' }));
    assert.equal(await findControl(page, 'Times', { kind: 'slider' }), null); // one layer
    await run(page, 'undo');
    await draw(page, 'mouse', circle(0, 0, 0.2));
    await press(page, 'Ring');
    await run(page, 'layer-sheet', { at: 0.5 });
    await draw(page, 'mouse', circle(0, 0, 0.3));
    assert.ok(await findControl(page, 'Times', { kind: 'slider' }));
    await press(page, 'In steps');
    await run(page, 'layer-repeat', { times: 3 });
    await run(page, 'layer-bumps', { amount: 4, size: 30 });
    await press(page, 'Other lumps');
    now = await state(page);
    assert.equal(now.parts[0].failure, null);
    assert.equal(now.undo, 8); // the paper, two lines, and five settings
    assert.ok((await exported(page, 'stl')).length > 50000);
  }));

test('by keyboard alone: the tool, a circle, the sheet up, another circle', () =>
  onPage(kit, {}, async (page) => {
    await paper(page);
    await run(page, 'draw');
    await page.locator('#canvas').focus();
    await page.keyboard.press('q');
    await idle(page);
    assert.ok((await state(page)).sheet);
    const search = async (words) => {
      await page.keyboard.press('/');
      await page.keyboard.type(words);
      await page.keyboard.press('Enter');
      await idle(page);
    };
    await search('Circle on the sheet');
    await page.locator('#canvas').focus();
    for (let i = 0; i < 4; ++i) await page.keyboard.press('ArrowUp');
    await search('Square on the sheet');
    const now = await state(page);
    assert.equal(now.sheet.layers.length, 2);
    assert.equal(now.parts[0].failure, null);
  }));

const kLeaning = [
  ['mouse', { hasTouch: true }],
  ['finger', kPhone],
];
for (const [device, options] of sample(kLeaning, 0)) {
  test(`a sheet leans by its knob, and a line across the view is what the layers follow: by ${device}`, () =>
    onPage(kit, options, async (page) => {
      await paper(page);
      if (options === kPhone) await run(page, 'focus-solid');
      await draw(page, device, circle(0, 0, 0.25));
      await run(page, 'layer-sheet', { at: 0.7 });
      const [knob] = await onCanvas(page, (await state(page)).sheet.leanKnobs[1]);
      await strokeAlong(
        page,
        device,
        [0, 12, 24, 36].map((by) => ({ x: knob.x, y: knob.y - by })),
      );
      let now = await state(page);
      assert.ok(now.sheet.lean.side < -5, `${now.sheet.lean.side}`);
      await draw(page, device, circle(0, 0, 0.25));
      now = await state(page);
      assert.deepEqual([now.sheet.layers.length, now.parts[0].failure], [2, null]);
      const steps = now.undo;
      await run(page, 'layer-rail', { rail: 'draw' });
      const [middle] = await onSheet(page, [[0, 0]]);
      const wave = Array.from({ length: 25 }, (_, i) => ({
        x: middle.x + 4 * (i - 12),
        y: middle.y + 30 * Math.sin(i / 4),
      }));
      await strokeAlong(page, device, wave);
      now = await state(page);
      assert.deepEqual([now.undo, now.sheet.drawsRail, now.parts[0].failure], [steps + 1, false, null]);
      await run(page, 'undo');
      assert.equal((await state(page)).undo, steps);
    }));
}

const kOnBoard = [
  ['mouse', {}],
  ['finger', kPhone],
];
for (const [device, options] of sample(kOnBoard, 1)) {
  test(`a layer is changed by its points on the board, and kept by another tool: by ${device}`, () =>
    onPage(kit, { hasTouch: true, ...options }, async (page) => {
      await paper(page);
      await draw(page, device, circle(0, 0, 0.4));
      const before = await exported(page, 'stl');
      const { undo } = await state(page);
      await run(page, 'edit-slice');
      await idle(page);
      const [[x, y]] = (await state(page)).sliceBoard.curves[0];
      const way = await onBoard(
        page,
        [1, 0.8, 0.6, 0.5].map((t) => [t * x, t * y]),
      );
      await strokeAlong(page, device, way);
      const { curves, undo: steps } = (await state(page)).sliceBoard;
      assert.ok(Math.hypot(curves[0][0][0] - x / 2, curves[0][0][1] - y / 2) < 0.05, `${curves[0][0]}`);
      assert.equal(steps, 1);
      await run(page, 'draw');
      await idle(page);
      const now = await state(page);
      assert.equal(now.sliceBoard, null);
      assert.equal(now.undo, undo + 1);
      assert.ok(!(await exported(page, 'stl')).equals(before));
      await run(page, 'undo');
      await idle(page);
      assert.ok((await exported(page, 'stl')).equals(before));
    }));
}

test('what lies before the sheet is faint, what lies behind it stays as it is', () =>
  onPage(kit, kSharp, async (page) => {
    await paper(page);
    await run(page, 'layer-circle');
    const box = { x: Infinity, y: Infinity, right: 0, bottom: 0 };
    for (const at of [0, 1]) {
      await run(page, 'layer-sheet', { at });
      for (const corner of await onCanvas(page, ...(await state(page)).sheet.corners)) {
        box.x = Math.min(box.x, Math.round(corner.x));
        box.y = Math.min(box.y, Math.round(corner.y));
        box.right = Math.max(box.right, Math.round(corner.x));
        box.bottom = Math.max(box.bottom, Math.round(corner.y));
      }
    }
    const clip = { x: box.x, y: box.y, width: box.right - box.x, height: box.bottom - box.y };
    // How much redder than blue each pixel is: the part is orange, the sheet is not.
    const warmth = async () => {
      const { data } = await pixels(page, clip);
      return Array.from({ length: data.length / 4 }, (_, i) => data[4 * i] - data[4 * i + 2]);
    };
    await run(page, 'draw');
    await idle(page);
    const whole = await warmth();
    await run(page, 'layers');
    await run(page, 'layer-sheet', { at: 0.5 });
    await idle(page);
    const cut = await warmth();
    const part = whole.flatMap((warm, i) => (warm > 50 ? [i] : []));
    assert.ok(part.length > 5000, `${part.length} pixels of the part`);
    const share = (holds) => part.filter((i) => holds(cut[i] / whole[i])).length / part.length;
    const faint = share((left) => left > 0.05 && left < 0.45);
    const full = share((left) => left > 0.6);
    assert.ok(faint > 0.2 && full > 0.35 && faint + full > 0.85, `${faint} faint, ${full} full`);
    const gone = share((left) => left <= 0.05);
    assert.ok(gone < 0.1, `${gone} gone`); // faint, not gone, but for what the lines of the sheet cover
    await run(page, 'layer-sheet', { at: 1 });
    await idle(page);
    const top = await warmth();
    assert.ok(part.filter((i) => top[i] < 0.6 * whole[i]).length < 0.1 * part.length);
  }));

test('a layer leaves the line, its part becomes another one by its slices, and the view flies along it', () =>
  onPage(kit, {}, async (page) => {
    await paper(page);
    await draw(page, 'mouse', circle(0, 0, 0.4));
    await lift(page, 'mouse', 150);
    await draw(page, 'mouse', circle(0, 0, 0.25));
    await press(page, 'Off the line');
    let now = await state(page);
    assert.deepEqual([now.sheet.free, now.sheet.layer], [true, 1]);
    const low = now.sheet.corners;
    await lift(page, 'mouse', 60);
    now = await state(page);
    assert.ok(now.sheet.corners[0][1] < low[0][1] - 20, 'it went up with its knob');
    assert.equal(now.parts[0].failure, null);

    await press(page, 'Copy slices');
    await run(page, 'new-part');
    await run(page, 'layers');
    await press(page, 'Paste slices');
    now = await state(page);
    assert.equal(now.parts.length, 2);
    assert.deepEqual([now.parts[1].kind, now.parts[1].failure, now.sheet.layers.length], ['stack', null, 2]);

    const { camera } = now;
    const [x, y, width, height] = (await control(page, 'Fly along')).at;
    const [button] = await onCanvas(page, [x + width / 2, y + height / 2]);
    await page.mouse.click(button.x, button.y);
    await page.waitForTimeout(500);
    assert.notDeepEqual((await state(page)).camera, camera);
    await page.mouse.click(button.x, button.y);
    await idle(page);
    assert.deepEqual((await state(page)).camera, camera);
  }));
