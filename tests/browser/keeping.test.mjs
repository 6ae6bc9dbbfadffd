// Models are kept on the device by themselves: across reloads, in a list, in one tab at a time, and with words where it fails.
import assert from 'node:assert/strict';
import test from 'node:test';
import { drawWithMouse } from './support/hands.mjs';
import {
  done,
  downloaded,
  dropFiles,
  exported,
  idle,
  refusal,
  reload,
  reloadedToast,
  run,
  state,
  toClient,
  toastText,
  useSite,
} from './support/page.mjs';
import {
  banner,
  drawPart,
  emptyDevice,
  history,
  inStore,
  models,
  onceKept,
  smallTube as tube,
} from './support/keeping.mjs';

const kit = useSite();
const onEmptyDevice = emptyDevice(kit);

/** A second tab of the same browser profile. */
async function secondTab(page) {
  const other = await page.context().newPage();
  await other.goto(page.url());
  await other.evaluate(() => window.spineloft.ready);
  return other;
}

test('a reload brings back the model with undo and redo, and says so', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    await run(page, 'set-section', { section: 'star' });
    await run(page, 'set-height', { mm: 70 });
    await done(page, 'undo');
    const before = await history(page),
      looks = (await state(page)).parts;
    await onceKept(page);
    assert.match(await reloadedToast(page, 'status'), /Welcome back\. tube/);
    assert.equal(await history(page), before);
    assert.deepEqual((await state(page)).parts, looks);
    await page.keyboard.press('Control+Shift+z');
    assert.equal((await state(page)).heightMm, 70);
    for (let i = 0; i < 4; ++i) await run(page, 'undo');
    assert.equal((await state(page)).picture, null);
    await done(page, 'redo');
    await onceKept(page);
    await reload(page);
    assert.equal((await state(page)).redo, 3);
  }));

test('what is not finished yet, a stroke in hand, is all that a reload loses', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    const before = await history(page);
    const [from, to] = await toClient(page, [
      [20, 20],
      [60, 25],
    ]);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y);
    await onceKept(page);
    await reload(page);
    assert.equal(await history(page), before);
  }));

test('starting a new one leaves the old one in the list, from where it is opened again', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    const first = await history(page);
    await onceKept(page);
    await reload(page);
    await page.getByRole('button', { name: 'Start a new one' }).click();
    await idle(page);
    assert.equal(await page.locator('#start').isVisible(), true);
    assert.equal(await page.locator('#models-cards .model-name').innerText(), 'tube');
    assert.match(await page.locator('#models-cards .model-detail').innerText(), /1 part · today/);
    await page.locator('#models-cards img').waitFor();
    await onceKept(page);
    await reload(page);
    assert.equal(await page.locator('#start').isVisible(), true, 'a new one stays a new one');
    await page.locator('#models-cards .model-open').click();
    await page.waitForFunction(() => window.spineloft.state().picture !== null);
    await idle(page);
    assert.equal(await history(page), first);
  }));

test('models are duplicated, renamed and deleted from the list, and a deletion can be undone', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    await done(page, 'new-model');
    const more = async (name, action) => {
      await page.getByRole('button', { name: `More about ${name}` }).click();
      await page.getByRole('menuitem', { name: action }).click();
      await idle(page);
    };
    const names = async () => (await models(page)).map((model) => model.name).sort();
    await more('tube', 'Duplicate');
    assert.deepEqual(await names(), ['tube', 'tube copy']);
    await page.getByRole('button', { name: 'More about tube copy' }).click();
    await page.getByRole('menuitem', { name: 'Rename' }).click();
    await page.locator('dialog input').fill('Swan');
    await page.keyboard.press('Enter');
    await page.getByRole('button', { name: 'More about Swan' }).waitFor();
    assert.deepEqual(await names(), ['Swan', 'tube']);
    await page.locator('.model-open', { hasText: 'Swan' }).click();
    await page.waitForFunction(() => window.spineloft.state().picture !== null);
    assert.equal((await state(page)).documentName, 'Swan', 'the document learns its name');
    await page.keyboard.press('Control+Shift+o');
    await page.locator('.models-dialog').waitFor();
    await more('Swan', 'Delete');
    assert.deepEqual(await names(), ['tube']);
    assert.equal((await state(page)).picture, null);
    await page.locator('.models-dialog [aria-label=Close]').click();
    await page.getByRole('button', { name: 'Undo', exact: true }).last().click();
    await page.getByRole('button', { name: 'More about Swan' }).waitFor();
    await page.locator('.model-open', { hasText: 'Swan' }).click();
    await page.waitForFunction(() => window.spineloft.state().parts.length === 1);
  }));

test('the next pupil begins with an empty page and few tools; the models stay, under an animal, with their pictures', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    const first = await history(page);
    await done(page, 'more-tools', { on: true });
    await run(page, 'next-pupil');
    await page.getByRole('dialog').getByRole('button', { name: 'Turtle' }).click();
    await idle(page);
    assert.equal((await state(page)).picture, null);
    assert.equal(await page.locator('#start').isVisible(), true);
    assert.equal(
      await page.evaluate(() => window.spineloft.commands().find(({ id }) => id === 'more-tools').toggled),
      false,
    );
    assert.equal(await page.locator('.model-animal').innerText(), 'Turtle');
    await page.locator('#models-cards img').waitFor();
    assert.equal(await page.locator('#models-next').isVisible(), false, 'nothing is nobody’s');
    await drawPart(page);
    await onceKept(page);
    await reload(page);
    await done(page, 'new-model');
    await page.locator('#models-next').click();
    await page.getByRole('dialog').getByRole('button', { name: 'Cat' }).click();
    await idle(page);
    assert.deepEqual((await page.locator('.model-animal').allInnerTexts()).sort(), ['Cat', 'Turtle']);
    await page.locator('.model-open', { hasText: 'Turtle' }).click();
    await page.waitForFunction(() => window.spineloft.state().picture !== null);
    assert.equal(await history(page), first, 'whoever comes back goes on with all of it');
  }));

test('paper that nobody has drawn on is gone when it is left; with a line it is kept', () =>
  onEmptyDevice(async (page) => {
    const paper = () => done(page, 'new-sketch');
    await paper();
    await onceKept(page);
    await done(page, 'next-pupil');
    assert.equal(await page.getByRole('dialog').count(), 0, 'there is nothing to put away');
    assert.deepEqual(await models(page), []);
    await paper();
    await onceKept(page);
    await reload(page);
    assert.notEqual((await state(page)).picture, null, 'it was not left');
    await done(page, 'new-model');
    assert.deepEqual(await models(page), []);
    await paper();
    await done(page, 'draw-on-sketch', { stroke: [40, 60, 80].map((x) => [x, 60]) });
    await done(page, 'new-model');
    assert.equal((await models(page)).length, 1);
  }));

test('without an answer nobody is sent away', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    await run(page, 'next-pupil');
    await page.keyboard.press('Escape');
    await idle(page);
    assert.equal((await state(page)).parts.length, 1);
  }));

test('a duplicate of the open model is worked on, and the original stays as it was', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    await onceKept(page);
    await done(page, 'duplicate-model');
    await done(page, 'set-section', { section: 'star' });
    await onceKept(page);
    assert.equal((await state(page)).documentName, 'tube copy');
    const original = (await models(page)).find((model) => model.name === 'tube');
    await done(page, 'open-model', { id: original.id });
    assert.equal((await state(page)).parts[0].section, 'circle');
  }));

test('an emptied board can be undone from the start page', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    await done(page, 'clear');
    await onceKept(page);
    await reload(page);
    await page.getByRole('button', { name: 'Undo', exact: true }).first().click();
    await idle(page);
    assert.equal((await state(page)).parts.length, 1);
  }));

test('a model whose steps were all taken back stays one: paper begins another, and its card does them again', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    const { undo } = await state(page);
    for (let step = 0; step < undo; ++step) await done(page, 'undo');
    await onceKept(page);
    const [{ id }] = await models(page);
    await page.locator('#paper').click();
    await page.waitForFunction(() => window.spineloft.state().picture !== null);
    await idle(page);
    assert.equal((await state(page)).redo, 0);
    await done(page, 'open-model', { id });
    assert.equal((await state(page)).redo, undo);
    await page.locator('#models-cards .model-open').first().click();
    await page.waitForFunction(() => window.spineloft.state().redo === 0);
    await idle(page);
    assert.equal((await state(page)).parts.length, 1);
    assert.equal((await state(page)).undo, undo);
  }));

test('a photo is stored once however many models show it, and a small one takes little room', () =>
  onEmptyDevice(async (page) => {
    for (let i = 0; i < 3; ++i) {
      await drawPart(page);
      await done(page, 'new-model');
    }
    assert.equal((await models(page)).length, 3);
    const photos = await inStore(page, 'photos');
    assert.equal(photos.length, 1);
    assert.ok(photos[0].bytes < 4 * tube.width * tube.height);
    assert.equal((await inStore(page, 'journal')).length, 3, 'one record for each line; the picture is in the base');
  }));

for (const locks of [true, false]) {
  test(`two tabs never write the same model: a copy or taking over, ${locks ? 'with Web Locks' : 'by signs of life'}`, () =>
    onEmptyDevice(
      async (page) => {
        await drawPart(page);
        await onceKept(page);
        const before = await history(page);
        const other = await secondTab(page);
        await other.bringToFront();
        assert.match(await banner(other).innerText(), /tube is open in another tab/);
        assert.equal((await state(other)).picture, null);
        assert.match(await other.locator('#models-cards .model-badge').innerText(), /another tab/);

        await banner(other).getByRole('button', { name: 'Take over here' }).click();
        await other.waitForFunction(() => window.spineloft.state().picture !== null);
        await idle(other);
        assert.equal(await history(other), before);
        await done(other, 'set-section', { section: 'star', part: 1 });
        await onceKept(other);

        await page.bringToFront();
        await banner(page).waitFor();
        assert.match(await banner(page).innerText(), /open in another tab now/);
        assert.equal(await refusal(page, 'undo'), 'OpenElsewhere');
        await page.keyboard.press('Control+z');
        await drawWithMouse(page, tube.middle);
        assert.equal(await history(page), before, 'here it can only be looked at');
        await banner(page).getByRole('button', { name: 'Open a copy' }).click();
        await idle(page);
        assert.equal(await banner(page).count(), 0);
        await done(page, 'set-section', { section: 'hexagon', part: 1 });
        await onceKept(page);

        await reload(other);
        assert.equal((await state(other)).parts[0].section, 'star');
        await reload(page);
        assert.equal((await state(page)).parts[0].section, 'hexagon');
        assert.deepEqual((await models(page)).map((model) => model.name).sort(), ['tube', 'tube copy']);
      },
      locks ? [] : [() => Object.defineProperty(Navigator.prototype, 'locks', { value: undefined })],
    ));
}

test('a model that another tab has open is opened as a copy from the list', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    const other = await secondTab(page);
    await other.bringToFront();
    await other.locator('.model-open').click();
    await banner(other).getByRole('button', { name: 'Open a copy' }).click();
    await other.waitForFunction(() => window.spineloft.state().documentName === 'tube copy');
    assert.equal((await state(page)).documentName, 'tube');
  }));

test('Help tells how many steps can be taken back, behind its heading', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    await page.locator('#bar-help').click();
    await page.getByText('More about this model').click();
    assert.match(await page.getByRole('dialog', { name: 'Help' }).innerText(), /Steps that can be taken back: [1-9]/);
  }));

test('Ctrl+S saves a project file; dropped on the page it opens as a model of its own, and the open one stays', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    await run(page, 'rename-model', { name: 'Swan neck' });
    const saved = await downloaded(page, () => page.keyboard.press('Control+s'));
    assert.equal(saved.name, 'swan-neck.spineloft');
    const file = kit.file(saved.name, saved.bytes);
    await done(page, 'set-section', { section: 'star', part: 1 });
    await dropFiles(page, [file]);
    await page.waitForFunction(
      () => window.spineloft.state().undo === 0 && window.spineloft.state().parts.length === 1,
    );
    await idle(page);
    assert.equal((await state(page)).parts[0].section, 'circle');
    assert.equal((await state(page)).documentName, 'Swan neck');
    assert.equal((await models(page)).length, 2);
    assert.equal((await inStore(page, 'photos')).length, 1, 'the file brings the same photo');
    await onceKept(page);
    await reload(page);
    assert.equal((await state(page)).parts[0].section, 'circle');
  }));

test('a GLB that was saved here goes on; one of another program or a damaged file gets a sentence and changes nothing', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    const glb = await exported(page, 'glb');
    const before = await history(page);
    const json = Buffer.from('{"asset":{"version":"2.0"}} ');
    const head = Buffer.alloc(20);
    for (const [i, value] of [0x46546c67, 2, 20 + json.length, json.length, 0x4e4f534a].entries())
      head.writeUInt32LE(value, 4 * i);
    for (const [name, bytes, says] of [
      ['foreign.glb', Buffer.concat([head, json]), /no model of SpineLoft/],
      ['cut.spineloft', glb.subarray(0, glb.length >> 1), /damaged/i],
      ['text.spineloft', Buffer.from('hello'), /./],
    ]) {
      await dropFiles(page, [kit.file(name, bytes)]);
      assert.match(await toastText(page), says, name);
      assert.equal(await history(page), before, name);
      await page.locator('#toasts [role=alert] .toast-close').last().click();
    }
    await done(page, 'new-model');
    await page.locator('#model-picker').setInputFiles(kit.file('ours.glb', glb));
    await page.waitForFunction(() => window.spineloft.state().parts.length === 1);
    const code = await page.evaluate(() =>
      window.spineloft.openProject(new Blob(['x'])).then(
        () => null,
        (error) => error.code,
      ),
    );
    assert.equal(code, 'NoProjectInside');
  }));
