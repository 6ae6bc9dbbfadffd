// Everything that the canvas shows is in the DOM as well: a mug by keyboard alone, a bird by the accessibility tree.
import assert from 'node:assert/strict';
import test from 'node:test';
import { downloaded, idle, kPhone, onPage, openWithPart, run, state, useSite } from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';
import { readerOf } from './support/tree.mjs';

const kit = useSite();
const tube = tubePicture();

const key = async (page, name, times = 1) => {
  for (let i = 0; i < times; i += 1) await page.keyboard.press(name);
};

/** The keyboard's pen along moves such as 'Right 4': an arrow of 40 pixels and how often; down at the first one. */
async function draw(page, moves) {
  await key(page, 'Space');
  for (const move of moves) {
    const [way, times] = move.split(' ');
    await key(page, `Shift+Arrow${way}`, Number(times));
  }
  await key(page, 'Space');
  await idle(page);
}
const moveTo = async (page, moves) => {
  for (const move of moves) {
    const [way, times] = move.split(' ');
    await key(page, `Shift+Arrow${way}`, Number(times));
  }
};

/** By the search, as a keyboard finds what has no key. */
async function search(page, words) {
  await page.keyboard.press('/');
  await page.getByRole('combobox').waitFor();
  await page.keyboard.type(words);
  await page.keyboard.press('Enter');
  await idle(page);
}

test('a mug with a handle by keyboard alone: drawn, scooped out, stuck together and saved', () =>
  onPage(kit, { alone: true }, async (page) => {
    const focused = () => page.evaluate(() => document.activeElement.dataset.command ?? document.activeElement.id);
    for (let i = 0; i < 12 && (await focused()) !== 'new-sketch'; i += 1) await key(page, 'Tab');
    await key(page, 'Enter');
    await page.waitForFunction(() => window.spineloft.state().picture !== null);
    await idle(page);
    await key(page, 'Enter'); // the pen, in the middle
    await moveTo(page, ['Left 2', 'Up 2']);
    await draw(page, ['Right 3', 'Down 4', 'Left 3', 'Up 4']);
    assert.equal((await state(page)).tool, 'draw', 'after an outline the line is in hand');
    await key(page, 'ArrowRight', 6);
    await draw(page, ['Down 4']);
    assert.equal((await state(page)).parts.length, 1);
    assert.match(await page.locator('#status').innerText(), /^Part 1 is made\./);
    await search(page, 'scoop out');
    assert.equal((await state(page)).steps.length, 0, 'shown before it is done');
    await key(page, 'Enter');
    await idle(page);
    const [hollow] = (await state(page)).steps;
    assert.deepEqual([hollow.kind, hollow.opening !== 'none', hollow.failure], ['hollow', true, null]);
    await search(page, 'next part');
    await key(page, 'Escape');
    await run(page, 'draw'); // the tool, whose key is "1"
    await key(page, 'Enter');
    await moveTo(page, ['Right 1', 'Up 1']);
    await draw(page, ['Right 3', 'Down 3', 'Left 3']);
    assert.equal((await state(page)).parts.length, 2);
    await search(page, 'stick together');
    const { steps } = await state(page);
    assert.deepEqual(
      steps.map(({ kind }) => kind),
      ['hollow', 'join'],
    );
    assert.deepEqual(
      steps.map(({ failure }) => failure),
      [null, null],
    );
    const { name } = await downloaded(page, () => key(page, 'Control+s'));
    assert.match(name, /\.(spineloft|glb)$/);
  }));

test('a bird with wings by the accessibility tree alone: all that is pressed is found there by role and name', () =>
  onPage(kit, { alone: true }, async (page) => {
    const reader = await readerOf(page);
    await reader.press('button', 'Draw on paper');
    await reader.focus('application', 'Drawing: picture and solid');
    await key(page, 'Enter');
    await moveTo(page, ['Left 3', 'Up 1']);
    await draw(page, ['Right 4', 'Up 1', 'Right 1', 'Down 3', 'Left 5', 'Up 2']);
    await reader.press('button', 'Puff');
    await reader.focus('application', 'Drawing: picture and solid');
    await moveTo(page, ['Right 3', 'Down 1']); // the pen is where it was: in the middle of the bird now
    await key(page, 'Space', 2);
    await idle(page);
    await reader.press('button', 'Use this');
    assert.equal((await state(page)).parts.length, 1);
    assert.match(await reader.said(), /^Part 1 is made\./);
    await reader.focus('application', 'Drawing: picture and solid');
    await moveTo(page, ['Left 1']);
    await draw(page, ['Right 1', 'Down 1', 'Left 1', 'Up 1']);
    assert.equal((await state(page)).parts.length, 2);
    const row = await reader.one('button', 'Part 2');
    assert.equal(reader.property(row, 'pressed'), 'true', 'the new part is in hand, and that is said');
    await reader.press('button', 'More');
    await reader.press('menuitem', 'Symmetry');
    await reader.press('menuitemradio', 'Front and back');
    assert.ok((await state(page)).parts[1].mirror, 'the wing is on the other side, too');
    await reader.press('button', 'Stick together');
    const [bird] = (await state(page)).steps;
    assert.deepEqual([bird.kind, bird.failure, bird.operands.length], ['join', null, 2]);
    assert.match(await reader.said(), /are together now/);
    await reader.press('button', 'Save');
    const { name } = await downloaded(page, () => reader.press('menuitem', /GLB/));
    assert.match(name, /\.glb$/);
  }));

test('a slider is read with its value and unit, and set; ribs are read with their state, and chosen', () =>
  onPage(kit, {}, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    const reader = await readerOf(page);
    await run(page, 'scoop-out', { part: 1 });
    await idle(page);
    await reader.one('slider', 'Wall');
    assert.match(await page.locator('#mirror [aria-label=Wall]').getAttribute('aria-valuetext'), / mm$/);
    const before = (await state(page)).steps[0].wall;
    const { slide } = (await state(page)).controls.find(({ words }) => words === 'Wall');
    await reader.set('slider', 'Wall', String(slide.value * 1.4));
    await page.waitForFunction((old) => window.spineloft.state().steps[0].wall > old * 1.2, before);
    await run(page, 'ribs');
    await reader.press('button', /^Rib 20 of \d+, left end, on an edge/);
    const chosen = await reader.one('button', /^Rib 20 of \d+, left end/);
    assert.equal(reader.property(chosen, 'pressed'), 'true');
  }));

test('points of a graph are read with their numbers and moved, added and taken away; what happened is said', () =>
  onPage(kit, {}, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await run(page, 'set-along', {
      kind: 'twist',
      points: [
        [0, 0],
        [0.5, 1],
        [1, 0],
      ],
    });
    await run(page, 'show-along', { kind: 'twist' });
    await idle(page);
    const points = async () => (await state(page)).parts[0].along.twist;
    const reader = await readerOf(page);
    await reader.set('slider', 'Twist, point 2 of 3: value', '0.5');
    await page.waitForFunction(() => Math.abs(window.spineloft.state().parts[0].along.twist[1][1] - 0.5) < 0.05);
    assert.match(await page.locator('#status').innerText(), /^Done: Twist and depth \(Part 1\)\.$/);
    await reader.press('button', 'Twist: add a point');
    assert.equal((await points()).length, 4);
    await reader.press('button', 'Twist, point 1 of 4: take it away');
    assert.equal((await points()).length, 3);
    await key(page, 'Control+z');
    await idle(page);
    assert.equal((await points()).length, 4);
    assert.match(await page.locator('#status').innerText(), /^Undone: Twist and depth \(Part 1\)\.$/);
  }));

test('keys go through the panels on the canvas, what is out of sight comes into sight, and the focus stays', () =>
  onPage(kit, {}, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await page.locator('#canvas').focus();
    await key(page, 'Tab');
    const name = () => page.evaluate(() => document.activeElement.getAttribute('aria-label'));
    const isMirrored = () => page.evaluate(() => document.activeElement.closest('#mirror') !== null);
    assert.ok(await isMirrored());
    const first = await name();
    await key(page, 'ArrowDown');
    assert.notEqual(await name(), first);
    await key(page, 'End');
    const last = await name();
    await page.waitForFunction(
      (words) => window.spineloft.state().controls.some((one) => one.words === words && one.inSight),
      last,
    );
    assert.equal(await name(), last);
    await key(page, 'Tab');
    assert.equal(await isMirrored(), false, 'one stop for all of them');
  }));

test('on a phone the tabs of the panel are there, and what they show', () =>
  onPage(kit, kPhone, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    const reader = await readerOf(page);
    await reader.press('button', 'Look');
    const tab = await reader.one('button', 'Look');
    assert.equal(reader.property(tab, 'pressed'), 'true');
    await reader.press('button', 'Metal');
    assert.equal((await state(page)).parts[0].paint, 'metal');
  }));
