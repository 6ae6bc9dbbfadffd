// Spun parts by real pointers. What else the tool does is said by tests/unit/web/spin_test.cpp.
import assert from 'node:assert/strict';
import test from 'node:test';
import { drawWithFinger, drawWithMouse, drawWithPen } from './support/hands.mjs';
import { exported, idle, onPage, run, state, toClient, useSite } from './support/page.mjs';

const kit = useSite();

/** One side of a wine glass on paper of 600 × 800, right of its middle, from the foot round the rim to the inside. */
const kGlass = [
  [299.5, 700],
  [420, 700],
  [420, 688],
  [316, 670],
  [312, 480],
  [380, 420],
  [400, 300],
  [392, 180],
  [386, 180],
  [394, 300],
  [372, 412],
  [299.5, 460],
];

async function paper(page) {
  await page.getByRole('button', { name: 'Draw on paper' }).click();
  await idle(page);
  await run(page, 'remove-picture');
  await run(page, 'new-sketch', { width: 600, height: 800 });
  await run(page, 'more-tools', { on: true });
  await run(page, 'spin');
}

test('one line on paper is a wine glass, by mouse, finger and pen', () =>
  onPage(kit, { hasTouch: true }, async (page) => {
    await paper(page);
    for (const [index, draw] of [drawWithMouse, drawWithFinger, drawWithPen].entries()) {
      const { undo } = await state(page);
      await draw(page, kGlass, { count: 60 });
      const now = await state(page);
      assert.equal(now.parts.length, index + 1);
      assert.equal(now.undo, undo + 1);
      assert.equal(now.parts[index].kind, 'lathe');
      assert.equal(now.parts[index].failure, null);
    }
    assert.ok((await exported(page, 'stl')).length > 100000);
    await run(page, 'undo');
    assert.equal((await state(page)).parts.length, 2);
  }));

test('the axis goes where the picture is tapped before the line is drawn, and is dragged by its ends after', () =>
  onPage(kit, {}, async (page) => {
    await paper(page);
    const [at] = await toClient(page, [[200, 500]]);
    await page.mouse.click(at.x, at.y);
    await idle(page);
    const moved = (await state(page)).axis;
    for (const [x] of moved) assert.ok(Math.abs(x - 200) < 3, `${x}`);
    await drawWithMouse(
      page,
      [
        [200, 600],
        [320, 600],
        [320, 300],
      ],
      { count: 12 },
    );
    let now = await state(page);
    assert.deepEqual(now.parts[0].axis, moved);
    const { undo } = now;
    await drawWithMouse(page, [now.axis[0], [240, now.axis[0][1]]], { count: 6 });
    now = await state(page);
    assert.equal(now.undo, undo + 1);
    assert.ok(Math.abs(now.parts[0].axis[0][0] - 240) < 3);
    assert.equal(now.parts[0].failure, null);
  }));
