// What a child makes of a puff with a slice, by the mouse or a finger alone: a coin with a rim, a leaf with a ridge, a letter
// that is a doughnut. An action is a press or a stroke.
import assert from 'node:assert/strict';
import test from 'node:test';
import { control, dragSlider, press, strokeAlong } from './support/hands.mjs';
import { exported, idle, kPhone, kTablet, onPage, run, state, toastText, toClient, useSite } from './support/page.mjs';
import { kRounds, sample } from '../support/rounds.mjs';

const kit = useSite();
const kMostActions = 5; // 9 seconds for each of 45

const round = (x, y, rx, ry, count = 40) =>
  Array.from({ length: count + 1 }, (_, i) => [
    x + rx * Math.cos((6.28 * i) / count),
    y + ry * Math.sin((6.28 * i) / count),
  ]);
const leaf = [
  ...Array.from({ length: 21 }, (_, i) => [200 + 30 * i, 380 - 130 * Math.sin((Math.PI * i) / 20)]),
  ...Array.from({ length: 20 }, (_, i) => [770 - 30 * i, 380 + 130 * Math.sin((Math.PI * (i + 1)) / 20)]),
];

class Child {
  actions = 0;
  constructor(page, hand) {
    this.page = page;
    this.hand = hand;
  }
  async press(words) {
    this.actions += 1;
    await press(this.page, words, { touch: this.hand === 'finger' });
    await idle(this.page);
  }
  async draw(line) {
    this.actions += 1;
    await strokeAlong(this.page, this.hand, await toClient(this.page, line));
    await idle(this.page);
  }
}

const tasks = {
  'a coin with a rim': [round(510, 384, 190, 190), 'Bowl', 'bowl'],
  'a leaf with a ridge': [leaf, 'Roof', 'roof'],
  'a letter O that is a doughnut': [round(510, 384, 170, 230), 'Ring', 'ring'],
};
const devices = {
  'by mouse': ['mouse', { viewport: { width: 1440, height: 900 } }],
  'by finger on a tablet': ['finger', kTablet],
  'by finger on a phone': ['finger', kPhone],
};
for (const [i, [how, [hand, device]]] of Object.entries(devices).entries())
  for (const [j, [what, [line, words, slice]]] of Object.entries(tasks).entries()) {
    if (kRounds === 1 && i !== j) continue; // each once in `npm test`
    test(`${what}, ${how}`, () =>
      onPage(kit, device, async (page) => {
        const paper = page.getByRole('button', { name: 'Draw on paper' });
        await (hand === 'finger' ? paper.tap() : paper.click());
        await idle(page);
        const child = new Child(page, hand);
        await child.press('Puff');
        await child.draw(line);
        await child.press(words);
        const { parts } = await state(page);
        assert.deepEqual([parts.length, parts[0].kind, parts[0].slice], [1, 'puff', slice]);
        assert.ok(child.actions <= kMostActions, `${child.actions} actions`);
        assert.ok((await exported(page, 'glb')).length > 1000);
      }));
  }

test('a ring too thin to show is drawn thicker, and the page says so', () =>
  onPage(kit, {}, async (page) => {
    await page.getByRole('button', { name: 'Draw on paper' }).click();
    await run(page, 'draw-puff', { contours: [round(510, 384, 190, 190)] });
    const box = (left, right) => [
      [left, -0.3],
      [right, -0.3],
      [right, 0.3],
      [left, 0.3],
    ];
    await run(page, 'puff-slice', { contours: [box(0.5, 0.53), box(-0.53, -0.5)] });
    assert.equal((await state(page)).parts[0].bones.thickened, 0);
    await run(page, 'slice-edge');
    await run(page, 'set-parameter', { key: 'reach', value: 0.02 });
    assert.match(await toastText(page, 'status'), /too thin to show/);
    assert.equal((await state(page)).parts[0].bones.thickened, 1);
    await run(page, 'slice-whole');
    assert.equal((await state(page)).parts[0].bones.thickened, 0);
  }));

for (const hand of sample(['mouse', 'finger', 'pen'], 2))
  test(`the height is dragged by its slider in a panel that scrolls, in one step: by ${hand}`, () =>
    onPage(kit, { viewport: { width: 1280, height: 640 }, hasTouch: true }, async (page) => {
      await page.getByRole('button', { name: 'Draw on paper' }).click();
      await idle(page);
      await run(page, 'puff');
      await strokeAlong(page, hand, await toClient(page, round(510, 384, 190, 190)));
      const { slide } = await control(page, 'Height', { kind: 'slider', touch: hand === 'finger' });
      const { undo } = await state(page);
      await dragSlider(page, 'Height', [0.55, 0.6, 0.66, 0.72, 0.8], hand);
      const after = await state(page);
      assert.equal(after.undo, undo + 1);
      const now = after.controls.find(({ words, kind }) => words === 'Height' && kind === 'slider');
      assert.ok(now.slide.value > 1.5 * slide.value, `${slide.value} -> ${now.slide.value}`);
      await run(page, 'undo');
      assert.equal((await state(page)).parts.length, 1);
    }));
