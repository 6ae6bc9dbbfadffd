// A first visit, and a later one: few commands in sight, all of them in the search, a way home, and what to do next.
import assert from 'node:assert/strict';
import test from 'node:test';
import { drawWithMouse } from './support/hands.mjs';
import {
  done,
  framed,
  idle,
  kPhone,
  onPage,
  openPicture,
  openWithPart,
  reload,
  run,
  state,
  useSite,
} from './support/page.mjs';
import { sample } from '../support/rounds.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();
const kMostInMenu = 14;

const oval = (x, y, rx, ry, count = 32) =>
  Array.from({ length: count + 1 }, (_, i) => {
    const turn = (2 * Math.PI * i) / count;
    return [x + rx * Math.cos(turn), y + ry * Math.sin(turn)];
  });

for (const [name, context] of Object.entries({ desktop: {}, phone: kPhone })) {
  test(`More is short, opens at its top and offers only what can be done (${name})`, () =>
    onPage(kit, context, async (page) => {
      await openWithPart(page, tube.png, tube.middle);
      for (const change of [null, ['duplicate'], ['select-all'], ['stick-together'], ['new-part']]) {
        if (change) await done(page, ...change);
        await page.locator('#bar-more').click();
        const items = page.locator('.menu [role^=menuitem]');
        const count = await items.count();
        assert.ok(count > 0 && count <= kMostInMenu, `${change}: ${count}`);
        assert.equal(await page.locator('.menu [aria-disabled=true]').count(), 0);
        assert.equal(await items.first().evaluate((item) => item === document.activeElement), true);
        assert.equal(await page.locator('.menu').evaluate((menu) => menu.scrollTop), 0);
        await page.keyboard.press('Escape');
      }
    }));
}

test('the search finds every command by its label, and runs what is chosen', () =>
  onPage(kit, {}, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await page.keyboard.press('/');
    const search = page.getByRole('combobox');
    await search.waitFor();
    const commands = await page.evaluate(() => window.spineloft.commands());
    for (const { id, label, argument } of commands) {
      if (argument?.kind === 'api') continue;
      await search.fill(label);
      assert.ok((await page.locator(`[role=option][data-command=${id}]`).count()) > 0, `${id}: ${label}`);
    }
    await search.fill('star');
    await page.keyboard.press('Enter');
    await idle(page);
    assert.equal((await state(page)).parts[0].section, 'star');
    assert.equal(await page.locator('dialog').count(), 0);
  }));

test('on a phone on its side all three ways to begin are in sight', () =>
  onPage(kit, { alone: true, viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true }, async (page) => {
    for (const id of ['#choose', '#camera', '#paper']) {
      const { y, height } = await page.locator(id).boundingBox();
      assert.ok(y >= 0 && y + height <= 390, id);
    }
  }));

test('the ways to another side have pictures in the menu', () =>
  onPage(kit, {}, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await page.locator('#bar-more').click();
    await page.locator('.menu [data-command=symmetry]').click();
    const drawn = await page
      .locator('.menu [data-command=symmetry]')
      .evaluateAll((items) => items.map((item) => item.querySelector('.icon')?.innerHTML ?? ''));
    assert.equal(drawn.length, 4);
    assert.equal(new Set(drawn).size, 4, 'each its own');
    assert.equal(
      drawn.filter((picture) => picture.split('<circle').length === 3).length,
      3,
      'a thing and its other side',
    );
    await page.keyboard.press('Escape');
  }));

/** A task of Help, begun. */
async function begin(page, id) {
  await page.locator('#things').click();
  await page.evaluate((task) => document.querySelector(`dialog button[value=${task}]`).click(), id);
  await page.waitForFunction(() => window.spineloft.state().picture !== null);
  await idle(page);
}

/** Where the ghost hand draws, picture pixels; null: it does not. It comes back a while after a pen was lifted. */
async function ghostOf(page) {
  await page.waitForTimeout(700);
  return page.evaluate(() => {
    const line = document.querySelector('#ghost-layer .ghost-line');
    return (
      line &&
      line
        .getAttribute('d')
        .slice(1)
        .split('L')
        .map((point) => point.split(' ').map(Number))
    );
  });
}

/** What is done before each line of a task that is drawn. */
const kBefore = {
  sausage: [[], []],
  vase: [[], []],
  mug: [[], [], [['hollow-show'], ['hollow-use'], ['new-part']]],
  zucchini: [[]],
  bird: [[], [['puff']]],
  robot: [[], [['set-section', { section: 'square' }], ['new-part']], [['new-part']], [['new-part']]],
};
for (const [id, lines] of sample(Object.entries(kBefore), 2, 5)) {
  test(`the ghost hand shows each line of a task until it is drawn, and it can be drawn as it is shown (${id})`, () =>
    onPage(kit, { alone: true, firstVisit: true }, async (page) => {
      await begin(page, id);
      const shown = [];
      for (const before of lines) {
        if (id === 'bird' && shown.length === 1) await run(page, 'draw-puff', { line: shown[0] });
        for (const command of before) await run(page, ...command);
        await idle(page);
        const line = await ghostOf(page);
        assert.ok(line, `line ${shown.length + 1}`);
        assert.notDeepEqual(line, shown.at(-1), 'what was drawn is not shown again');
        shown.push(line);
        await drawWithMouse(page, line);
        await idle(page);
      }
      assert.equal(await ghostOf(page), null);
      assert.equal((await state(page)).parts.length, { mug: 2, bird: 2, robot: 4 }[id] ?? 1);
    }));
}

test('the ghost hand leaves while a hand is down, and comes back when that drew nothing', () =>
  onPage(kit, { alone: true, firstVisit: true }, async (page) => {
    await begin(page, 'zucchini');
    const ghost = page.locator('#ghost-layer .ghost');
    await ghost.waitFor({ state: 'attached' });
    const { x, y, width } = await page.locator('#canvas').boundingBox();
    await page.mouse.move(x + width * 0.6, y + 200);
    await page.mouse.down();
    await ghost.waitFor({ state: 'detached' });
    await page.mouse.up();
    await ghost.waitFor({ state: 'attached' });
    assert.equal((await state(page)).parts.length, 0);
  }));

test('on a phone the words of a step are not over the paper: they stand in the line at the foot', () =>
  onPage(kit, { ...kPhone, alone: true, firstVisit: true }, async (page) => {
    await begin(page, 'sausage');
    assert.equal(await page.locator('#hint').isVisible(), false);
    assert.match(await page.locator('#coach').innerText(), /outline of a long sausage.*\(1 of 4\)/);
    const canvas = await page.locator('#canvas').boundingBox();
    const told = await page.locator('#coach').boundingBox();
    assert.ok(told.y >= canvas.y + canvas.height - 4, `${told.y} against ${canvas.y + canvas.height}`);
  }));

test('on a phone no advice is over a photo: it stands in the line at the foot, and can be closed for good', () =>
  onPage(kit, { ...kPhone, alone: true, firstVisit: true }, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    const hint = page.locator('#hint'),
      coach = page.locator('#coach');
    assert.match(await coach.innerText(), /Draw a line through the middle of the thing/);
    assert.equal(await hint.isVisible(), false);
    await page.locator('#coach-close').click();
    await run(page, 'puff');
    await run(page, 'draw');
    assert.equal(await coach.isVisible(), false);
    assert.equal(await hint.isVisible(), false);
  }));

test('on a phone the line at the foot shows a step until it can be read, then what is said, and the step again', () =>
  onPage(kit, { ...kPhone, alone: true, firstVisit: true }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    const isShown = (id) =>
      page.evaluate((name) => document.getElementById(name).getBoundingClientRect().width > 50, id);
    const becomes = (id) =>
      page.waitForFunction((name) => document.getElementById(name).getBoundingClientRect().width > 50, id);
    await run(page, 'cut-by-box');
    assert.deepEqual([await isShown('coach'), await isShown('status')], [true, false]);
    await page.waitForTimeout(6100);
    await run(page, 'cut-by-scribble');
    await becomes('status');
    assert.equal(await isShown('coach'), false);
    await becomes('coach');
    assert.equal(await isShown('status'), false);
    await run(page, 'shapes');
    await idle(page);
    assert.equal(await isShown('coach'), false, 'its steps are not about this tool');
  }));

test('Home shows the start page and keeps the model; Help tells and begins', () =>
  onPage(kit, { alone: true }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await page.locator('#home').click();
    await page.locator('#start').waitFor();
    assert.equal((await state(page)).picture, null);
    assert.equal(await page.locator('#home').isDisabled(), true, 'there is nowhere else to go home to');
    await page.locator('#models-cards .model-open').first().click();
    await page.waitForFunction(() => window.spineloft.state().parts.length === 1);
    await page.locator('#home').click();
    await page.locator('#things').click();
    const help = page.getByRole('dialog', { name: 'Help' });
    await help.getByText('A sausage').click();
    await help.getByRole('button', { name: 'Make one' }).first().click();
    await page.waitForFunction(() => window.spineloft.state().picture?.sketch === true);
    assert.equal((await state(page)).parts.length, 0, 'on a model of its own');
    const hint = page.locator('#hint'),
      coach = page.locator('#coach'),
      ghost = page.locator('#ghost-layer .ghost');
    assert.match(await hint.innerText(), /outline of a long sausage.*\(1 of 4\)/);
    assert.equal(await coach.isVisible(), false, 'once, not in both places');
    await ghost.waitFor({ state: 'attached' });
    const { width, height } = (await state(page)).picture;
    await drawWithMouse(page, oval(width / 2, height / 2, width * 0.3, height * 0.15));
    await page.waitForFunction(() => window.spineloft.state().tool === 'draw');
    assert.equal(await hint.isVisible(), false);
    assert.match(await coach.innerText(), /end to end \(2 of 4\)/);
    await run(page, 'puff');
    assert.equal(await hint.isVisible(), false, 'the tool says what it does');
    await run(page, 'draw');
    await drawWithMouse(page, [
      [width * 0.25, height / 2],
      [width * 0.75, height / 2],
    ]);
    assert.match(await coach.innerText(), /turn it round \(3 of 4\)/);
    await run(page, 'hollow-show');
    assert.equal(await coach.isVisible(), false, 'silent while something is asked');
    await run(page, 'hollow-cancel');
    assert.equal(await coach.isVisible(), true);
    await run(page, 'new-part');
    await drawWithMouse(page, [
      [width * 0.2, height * 0.1],
      [width * 0.8, height * 0.1],
    ]);
    const offer = page.locator('.toast').filter({ has: page.getByRole('button', { name: 'Try again' }) });
    await offer.waitFor();
    assert.equal(await coach.isVisible(), false, 'and while a toast asks');
    await offer.locator('.toast-close').click();
    await coach.waitFor();
  }));

test('a first visit has few tools, is led on after the first part, and what was chosen is remembered', () =>
  onPage(kit, { alone: true, firstVisit: true }, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    const words = async () => {
      await framed(page);
      return (await state(page)).controls.map((control) => control.words);
    };
    const few = await words();
    for (const label of ['Line', 'Puff', 'Flat piece', 'More tools']) assert.ok(few.includes(label), few.join());
    assert.ok(!few.includes('Ribs') && !few.includes('Bone'), few.join());
    await drawWithMouse(page, tube.middle);
    const coach = page.locator('#coach');
    assert.match(await coach.innerText(), /turn it round \(1 of/);
    await run(page, 'focus-solid');
    await run(page, 'turn-left');
    await page.waitForFunction(() => /\(2 of/.test(document.getElementById('coach-words').textContent));
    await page.locator('#coach-close').click();
    assert.equal(await coach.isVisible(), false);
    await run(page, 'more-tools');
    assert.ok((await words()).includes('Ribs'));
    await page.waitForFunction(() => localStorage.getItem('spineloft.tools') === 'all');
    await reload(page);
    await page.waitForFunction(() => window.spineloft.state().parts.length === 1);
    assert.ok((await words()).includes('Ribs'));
    assert.equal(await coach.isVisible(), false, 'what was closed stays closed');
  }));
