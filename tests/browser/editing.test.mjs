// Editing on the page with real pointers and keys, on real pictures: ribs, outline, bone, depth, edges that do not count.
import assert from 'node:assert/strict';
import test from 'node:test';
import {
  drawWithMouse,
  drawWithPen,
  drawWithTouch,
  idle,
  onPage,
  openPicture,
  run,
  state,
  toClient,
  useSite,
} from './support/page.mjs';
import { samples } from './support/pictures.mjs';

const kit = useSite();
const [lemur] = samples();

/** The first sample with its part of about 40 ribs, and a tool in hand. */
async function withPart(tool, work, options = {}) {
  await onPage(kit, options, async (page) => {
    await openPicture(page, lemur.bytes, 'lemur');
    await run(page, 'draw-spine', { stroke: lemur.spine });
    await run(page, 'set-parameter', { part: 1, key: 'ribs', value: 40 });
    await run(page, tool);
    await idle(page);
    await work(page);
  });
}

const part = async (page) => (await state(page)).parts[0];
const away = ([ax, ay], [bx, by]) => Math.hypot(ax - bx, ay - by);

/** `count` points from one to the other. */
const line = ([ax, ay], [bx, by], count = 12) =>
  Array.from({ length: count }, (_, i) => [ax + ((bx - ax) * i) / (count - 1), ay + ((by - ay) * i) / (count - 1)]);

/** A point `pixels` further out than a rib's end. */
function outside(rib, side, pixels) {
  const [cx, cy] = rib.center;
  const [x, y] = rib[side];
  const length = Math.max(1, Math.hypot(x - cx, y - cy));
  return [x + ((x - cx) / length) * pixels, y + ((y - cy) / length) * pixels];
}

for (const [device, drag] of Object.entries({ mouse: drawWithMouse, finger: drawWithTouch, pen: drawWithPen })) {
  test(`a rib end is dragged with the ${device}, in one step of undo`, () =>
    withPart(
      'ribs',
      async (page) => {
        const { undo } = await state(page);
        const before = await part(page);
        const to = outside(before.ribs[20], 'left', 25);
        await drag(page, line(before.ribs[20].left, to));
        const after = await part(page);
        assert.ok(away(after.ribs[20].left, to) < 2, `${after.ribs[20].left} is not at ${to}`);
        assert.equal(after.ribs[20].leftState, 'edited');
        assert.deepEqual(after.ribs[20].right, before.ribs[20].right);
        assert.deepEqual(after.ribs[3], before.ribs[3], 'far ribs stay');
        assert.equal((await state(page)).undo, undo + 1);
        await run(page, 'undo');
        assert.deepEqual((await part(page)).ribs, before.ribs);
      },
      device === 'finger' ? { hasTouch: true } : {},
    ));
}

test('the ribs that a line moves are coloured and the solid follows before the button goes up', () =>
  withPart('shape', async (page) => {
    const before = await part(page);
    const stroke = before.ribs.slice(14, 26).map((rib) => outside(rib, 'left', 14));
    let touched = [];
    await drawWithMouse(page, stroke, async () => {
      await page.waitForFunction(() => window.spineloft.state().preview?.fresh, undefined, { timeout: 10000 });
      const during = await state(page);
      touched = during.touched;
      assert.equal(during.preview.part, 1);
      assert.deepEqual(during.parts[0].ribs, before.ribs, 'nothing is changed yet');
    });
    assert.ok(touched.length >= 3, `${touched.length} ends are coloured`);
    const after = await part(page);
    for (const { rib, side } of touched) assert.notDeepEqual(after.ribs[rib][side], before.ribs[rib][side]);
    assert.ok(after.edits.ends >= touched.length);
  }));

test('a stroke with the ribs kept poses the part, and it comes back to the picture', () =>
  withPart('bone', async (page) => {
    await run(page, 'keep-ribs');
    const before = await part(page);
    const { picture } = await state(page);
    const stroke = line([picture.width * 0.12, picture.height * 0.9], [picture.width * 0.85, picture.height * 0.93]);
    await drawWithMouse(page, stroke);
    const posed = await part(page);
    assert.ok(posed.pose.stroke.length > 2);
    assert.deepEqual(posed.ribs, before.ribs, 'the ribs stay as they were found');
    assert.ok(away(posed.bone[0], stroke[0]) < 6, `${posed.bone[0]} is not at ${stroke[0]}`);
    await run(page, 'reset-pose');
    assert.deepEqual((await part(page)).bone, before.bone);
  }));

test('depth is dragged in the side view', () =>
  withPart('bone', async (page) => {
    await run(page, 'side-view');
    await idle(page);
    const box = await page.locator('#canvas').boundingBox();
    // The handle is where the page says that it is lit.
    let grip = null;
    for (let y = 90; y < box.height - 60 && !grip; y += 9) {
      for (let x = box.width * 0.42; x < box.width - 250 && !grip; x += 12) {
        await page.mouse.move(box.x + x, box.y + y);
        const { hover } = await state(page);
        if (hover.depth === 3) grip = { x: box.x + x, y: box.y + y };
      }
    }
    assert.ok(grip, 'a handle of the depth lies in the solid view');
    await page.mouse.move(grip.x, grip.y);
    await page.mouse.down();
    await page.mouse.move(grip.x - 30, grip.y + 30, { steps: 5 });
    await page.mouse.up();
    await idle(page);
    const { pose } = await part(page);
    assert.ok(
      pose.depth.length > 2 && Math.max(...pose.depth.map(([, z]) => Math.abs(z))) > 1,
      JSON.stringify(pose.depth),
    );
  }));

test('a scribble makes edges not count, for the part or for the picture, and a tap removes it', () =>
  withPart('ignore-edges', async (page) => {
    const before = await part(page);
    const stroke = before.ribs.slice(10, 20).map((rib) => rib.left);
    await drawWithMouse(page, stroke);
    assert.equal((await part(page)).ignored, 1);
    const [middle] = await toClient(page, [stroke[5]]);
    await page.mouse.click(middle.x, middle.y);
    await idle(page);
    assert.equal((await part(page)).ignored, 0);
    await run(page, 'ignore-whole-picture');
    await drawWithMouse(page, stroke);
    assert.equal((await state(page)).picture.ignored, 1);
    assert.equal((await state(page)).picture.paintedOver, 0);
    // What is painted over is not on the part: the picture in the file changes, its shape need not.
    const plain = await page.evaluate(async () => Array.from(await window.spineloft.exportModel('glb')).join());
    await run(page, 'paint-over');
    await drawWithMouse(
      page,
      before.ribs.slice(10, 20).map((rib) => rib.center),
    );
    assert.equal((await state(page)).picture.paintedOver, 1);
    assert.notEqual(
      await page.evaluate(async () => Array.from(await window.spineloft.exportModel('glb')).join()),
      plain,
    );
  }));

test('a gesture is taken back by Escape, the right button and a second finger, without a trace', () =>
  withPart(
    'ribs',
    async (page) => {
      const before = await state(page);
      const rib = before.parts[0].ribs[20];
      const [from, to] = await toClient(page, [rib.left, outside(rib, 'left', 30)]);
      const press = async () => {
        await page.mouse.move(from.x, from.y);
        await page.mouse.down();
        await page.mouse.move(to.x, to.y, { steps: 4 });
        assert.notEqual((await state(page)).preview, null);
      };
      await press();
      await page.keyboard.press('Escape');
      await page.mouse.up();
      await press();
      await page.mouse.down({ button: 'right' });
      await page.mouse.up({ button: 'right' });
      await page.mouse.up();
      const session = await page.context().newCDPSession(page);
      const touch = (type, ...points) =>
        session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(({ x, y }, id) => ({ x, y, id })) });
      // Far enough to be no part of a two-finger tap, which would undo.
      const far = { x: from.x + 40, y: from.y + 20 };
      await touch('touchStart', from);
      await touch('touchMove', far);
      assert.notEqual((await state(page)).preview, null);
      await touch('touchStart', far, { x: far.x + 90, y: far.y + 60 });
      await touch('touchEnd');
      await session.detach();
      await idle(page);
      const after = await state(page);
      assert.deepEqual([after.parts[0].ribs, after.preview], [before.parts[0].ribs, null]);
      assert.equal(after.undo, before.undo);
    },
    { hasTouch: true },
  ));

test('with the keyboard alone: a rib is chosen, named, moved, locked and deleted', () =>
  withPart('draw', async (page) => {
    await page.locator('#canvas').focus();
    await page.keyboard.press('g');
    for (let i = 0; i < 8; ++i) await page.keyboard.press('.');
    await page.keyboard.press('x');
    await page.waitForFunction(() => /Rib 8 of \d+, right end/.test(document.querySelector('#status').textContent));
    const before = await part(page);
    const { undo } = await state(page);
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
    await idle(page);
    const moved = await part(page);
    assert.ok(away(moved.ribs[7].right, [before.ribs[7].right[0] + 3, before.ribs[7].right[1]]) < 0.01);
    assert.equal((await state(page)).undo, undo + 1, 'a run of arrows is one step');
    await page.keyboard.press('l');
    assert.equal((await part(page)).ribs[7].rightState, 'locked');
    await page.keyboard.press('Delete');
    await idle(page);
    assert.equal((await part(page)).ribs.length, before.ribs.length - 1);
  }));
