// Closing the page asks as long as work would be lost, and only then.
import assert from 'node:assert/strict';
import test from 'node:test';
import { sample } from '../support/rounds.mjs';
import { drawWithMouse } from './support/hands.mjs';
import { done, downloaded, idle, reload, run, state, useSite } from './support/page.mjs';
import { asksBeforeLeaving, banner, drawPart, emptyDevice, history } from './support/keeping.mjs';

const kit = useSite();
const onEmptyDevice = emptyDevice(kit);

/** Every way of saving, and whether the file holds the model. */
const kSaves = [
  ['save-project', true],
  ['save-glb', true],
  ['save-obj', false],
  ['save-stl', false],
  ['save-3mf', false],
  ['save-picture', false],
];

const kStorages = [
  ['on', null],
  ['off', () => Object.defineProperty(globalThis, 'indexedDB', { value: undefined })],
  // Opened and read, but nothing can be put into it.
  [
    'full',
    () => {
      const original = IDBDatabase.prototype.transaction;
      IDBDatabase.prototype.transaction = function transaction(names, mode, options) {
        if (mode === 'readwrite') throw new DOMException('full', 'QuotaExceededError');
        return original.call(this, names, mode, options);
      };
    },
  ],
];
for (const [storage, spoil] of sample(kStorages, 0, 2)) {
  test(`closing asks unless the work as it is is in a file or kept: every format, edited meanwhile or not, storage ${storage}`, () =>
    onEmptyDevice(
      async (page) => {
        const check = async (unsaved, what) => {
          assert.equal((await state(page)).unsaved, unsaved, what);
          assert.equal(await asksBeforeLeaving(page), unsaved && storage !== 'on', what);
        };
        await drawPart(page);
        await check(true, 'a part');
        let mm = 50;
        const edit = () => run(page, 'set-height', { mm: (mm += 1) });
        // Which file holds the model does not depend on the storage.
        for (const [command, holdsModel] of storage === 'on' ? kSaves : [kSaves[0], kSaves[3]]) {
          for (const edited of [false, true]) {
            await edit();
            await idle(page);
            await check(true, 'an edit');
            await downloaded(page, async () => {
              const saving = run(page, command);
              if (edited) await edit();
              await saving;
            });
            await idle(page);
            await check(edited || !holdsModel, `${command}${edited ? ', edited meanwhile' : ''}`);
          }
        }
        assert.equal(await banner(page).count(), storage === 'on' ? 0 : 1);
      },
      spoil ? [spoil] : [],
    ));

  test(`strokes on paper without a part are work: unsaved, asked about and kept as a part is, storage ${storage}`, () =>
    onEmptyDevice(
      async (page) => {
        await done(page, 'new-sketch', { width: 300, height: 200 });
        assert.equal(await asksBeforeLeaving(page), false, 'blank paper is no work');
        await drawWithMouse(page, [
          [60, 60],
          [150, 120],
          [240, 70],
        ]);
        assert.equal((await state(page)).unsaved, true);
        assert.equal(await asksBeforeLeaving(page), storage !== 'on');
        const before = await history(page);
        if (storage === 'on') {
          await reload(page);
          assert.equal(await history(page), before);
          return;
        }
        // The browser itself asks; the answer is to stay.
        const [dialog] = await Promise.all([page.waitForEvent('dialog'), page.close({ runBeforeUnload: true })]);
        assert.equal(dialog.type(), 'beforeunload');
        await dialog.dismiss();
        await downloaded(page, () => page.keyboard.press('Control+s'));
        await idle(page);
        assert.equal(await asksBeforeLeaving(page), false, 'a file holds it');
        assert.equal(await history(page), before);
      },
      spoil ? [spoil] : [],
    ));
}
