// Reliefs by real pointers in the panel of a part, on a desk and on a phone. What else they do is said by
// tests/unit/relief and tests/unit/pipeline/relief_shape_test.cpp.
import assert from 'node:assert/strict';
import test from 'node:test';
import { sample } from '../support/rounds.mjs';
import { dragSlider, drawWithFinger, drawWithMouse, findControl, line, press } from './support/hands.mjs';
import { exported, idle, kDesk, kPhone, onPage, reload, run, state, useSite } from './support/page.mjs';

const kit = useSite();

const round = Array.from({ length: 48 }, (_, i) => (i * Math.PI) / 24).map((a) => [
  500 + 220 * Math.cos(a),
  380 + 220 * Math.sin(a),
]);

/** A puff on paper with a cross of ink on it, in hand. */
async function crossed(page, draw) {
  await page.getByRole('button', { name: 'Draw on paper' }).click();
  await idle(page);
  await run(page, 'puff');
  await draw(page, round, { count: 24 });
  await run(page, 'pen');
  await draw(page, line([400, 380], [600, 380]));
  await draw(page, line([500, 280], [500, 480]));
  await run(page, 'draw');
  const now = await state(page);
  assert.equal(now.parts.length, 1);
  assert.equal(now.parts[0].relief, null);
  return now;
}
/** Opens the panel of reliefs. */
async function openRelief(page, touch) {
  if (touch) return press(page, 'Look', { kind: 'tab', touch });
  await press(page, 'Relief', { kind: 'section' });
}

const kPlaces = [
  ['mouse on a desk', kDesk, drawWithMouse],
  ['finger on a phone', kPhone, drawWithFinger],
];
for (const [where, device, draw] of sample(kPlaces, 1))
  test(`ink on paper is cut into the part, higher by a slider, each one step of undo: ${where}`, () =>
    onPage(kit, device, async (page) => {
      const touch = device === kPhone;
      const before = await crossed(page, draw);
      await openRelief(page, touch);
      assert.equal(await findControl(page, 'Height of the relief', { kind: 'slider' }), null);
      await press(page, 'Strokes', { touch });
      let now = await state(page);
      assert.equal(now.undo, before.undo + 1);
      assert.deepEqual(now.parts[0].relief.made, { mode: 'ink', seen: true, raises: true, explained: 0, share: 1 });
      assert.ok(now.parts[0].triangles > before.parts[0].triangles);
      await dragSlider(page, 'Height of the relief', [0.4, 0.35, 0.3, 0.25], touch ? 'finger' : 'mouse');
      now = await state(page);
      assert.ok(now.parts[0].relief.height > 0.03, `${now.parts[0].relief.height}`);
      assert.equal(now.undo, before.undo + 2);
      const glb = await exported(page, 'glb');
      await reload(page);
      await idle(page);
      assert.deepEqual((await state(page)).parts[0].relief, now.parts[0].relief);
      assert.equal((await exported(page, 'glb')).length, glb.length);
      await run(page, 'undo');
      assert.equal((await state(page)).parts[0].relief.height, 0.02);
      await run(page, 'undo');
      assert.equal((await state(page)).parts[0].relief, null);
      assert.equal((await state(page)).parts[0].triangles, before.parts[0].triangles);
    }));

test('shading of a drawing says that there is none, and cuts its lines; another picture is laid on the part', () =>
  onPage(kit, kDesk, async (page) => {
    await crossed(page, drawWithMouse);
    await openRelief(page);
    await press(page, 'Shade');
    await idle(page);
    let { relief } = (await state(page)).parts[0];
    assert.equal(relief.mode, 'shade');
    assert.equal(relief.made.mode, 'ink');
    assert.ok(relief.made.explained < 0.1);
    const [part] = (await state(page)).parts;
    await run(page, 'new-sketch', { width: 400, height: 300 });
    await run(page, 'pen');
    await drawWithMouse(page, line([150, 150], [250, 150]));
    await run(page, 'select-part', { part: part.id });
    await run(page, 'relief', { mode: 'ink', from: 2 });
    await idle(page);
    ({ relief } = (await state(page)).parts[0]);
    assert.equal(relief.laid.picture, 2);
    assert.ok(Math.abs(relief.laid.at[0] - 500) < 5 && Math.abs(relief.laid.width - 220) < 30, `${relief.laid.width}`);
    assert.ok(relief.made.seen);
    assert.ok(await findControl(page, 'Picture on the part: size', { kind: 'slider' }));
    await run(page, 'relief', { from: null });
    assert.equal((await state(page)).parts[0].relief.laid, null);
    await run(page, 'relief', { mode: 'none' });
    assert.equal((await state(page)).parts[0].relief, null);
  }));
