// Models are kept on the device by themselves: what is said and done where the storage fails.
import assert from 'node:assert/strict';
import test from 'node:test';
import { done, idle, reload, reloadedToast, run, state, toastText, useSite } from './support/page.mjs';
import { asksBeforeLeaving, banner, drawPart, emptyDevice, history, inStore, models } from './support/keeping.mjs';

const kit = useSite();
const onEmptyDevice = emptyDevice(kit);

const withoutSession = () =>
  Object.defineProperty(window, 'sessionStorage', {
    get() {
      throw new DOMException('no', 'SecurityError');
    },
  });

for (const [what, spoil] of [
  [
    'missing',
    () => {
      delete globalThis.indexedDB;
      Object.defineProperty(globalThis, 'indexedDB', { value: undefined });
    },
  ],
  [
    'blocked',
    () => {
      IDBFactory.prototype.open = () => {
        throw new DOMException('no', 'SecurityError');
      };
    },
  ],
]) {
  test(`where storage is ${what} the page works on, says so once, and offers a file`, () =>
    onEmptyDevice(
      async (page) => {
        assert.equal(await banner(page).count(), 0, 'nothing to lose yet');
        await drawPart(page);
        assert.match(await banner(page).innerText(), /does not let the page keep your models/);
        assert.equal((await state(page)).parts.length, 1);
        assert.equal(await asksBeforeLeaving(page), true);
        await banner(page).getByRole('button', { name: 'Dismiss' }).click();
        for (const section of ['star', 'square', 'circle']) await done(page, 'set-section', { section });
        assert.equal(await banner(page).count(), 0, 'not on every stroke');
        await run(page, 'new-model');
        await page.getByRole('dialog').getByRole('button', { name: 'Let it go' }).click();
        await idle(page);
        assert.equal((await state(page)).picture, null);
      },
      [spoil, withoutSession],
    ));
}

test('a full disk is said once with a way out, and everything is kept again when there is room', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    // Chromium's own quota looks at usage only now and then, so the disk is full in the page.
    await page.evaluate(() => {
      const original = IDBDatabase.prototype.transaction;
      window.makeRoom_ = () => {
        IDBDatabase.prototype.transaction = original;
      };
      IDBDatabase.prototype.transaction = function transaction(names, mode, options) {
        if (mode === 'readwrite') throw new DOMException('full', 'QuotaExceededError');
        return original.call(this, names, mode, options);
      };
    });
    for (const section of ['star', 'square', 'hexagon']) {
      await done(page, 'set-section', { section });
    }
    assert.equal(await banner(page).count(), 1);
    assert.match(await banner(page).innerText(), /no room left[\s\S]*Save a file[\s\S]*Your models/);
    assert.equal(await asksBeforeLeaving(page), true);
    const now = await history(page);
    await page.evaluate(() => window.makeRoom_());
    await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
    await idle(page);
    assert.match(await toastText(page, 'status'), /kept on this device again/);
    assert.equal(await banner(page).count(), 0);
    await reload(page);
    assert.equal(await history(page), now);
  }));

/** In the page: what is written does not reach the disk before `letGo_()`. */
const holdWrites = () => {
  const original = IDBDatabase.prototype.transaction;
  let isHeld = true;
  window.letGo_ = () => {
    isHeld = false;
    IDBDatabase.prototype.transaction = original;
  };
  IDBDatabase.prototype.transaction = function transaction(names, mode, options) {
    const held = original.call(this, names, mode, options);
    const store = held.objectStore(held.objectStoreNames[0]);
    const again = () => {
      if (isHeld && mode === 'readwrite') store.count().onsuccess = again;
    };
    again();
    return held;
  };
};

test('what is not on the disk yet is said, storage that never answers too; a question about it goes when it answers', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    const sign = page.locator('#keeping');
    assert.equal(await sign.isVisible(), false);
    await page.evaluate(holdWrites);
    await run(page, 'set-section', { section: 'star' });
    await sign.waitFor();
    assert.match(await sign.innerText(), /Not kept yet/);
    assert.equal(await asksBeforeLeaving(page), true);
    await page.evaluate(() => window.letGo_());
    await sign.waitFor({ state: 'hidden' });
    await idle(page);
    assert.equal(await asksBeforeLeaving(page), false);

    await page.evaluate(holdWrites);
    await run(page, 'set-section', { section: 'square' });
    await banner(page).waitFor();
    assert.match(await banner(page).innerText(), /does not answer/);
    await done(page, 'set-section', { section: 'hexagon' });
    assert.equal(await asksBeforeLeaving(page), true);
    const now = await history(page);
    await run(page, 'new-model');
    const question = page.getByRole('dialog', { name: 'This model is not kept' });
    await question.waitFor();
    assert.equal(await history(page), now, 'nothing goes without an answer');
    await page.evaluate(() => window.letGo_());
    assert.match(await toastText(page, 'status'), /kept on this device again/);
    await question.waitFor({ state: 'hidden' });
    await page.waitForFunction(() => window.spineloft.state().picture === null);
    await idle(page);
    assert.equal(await asksBeforeLeaving(page), false);
    const [{ id }] = await models(page);
    await done(page, 'open-model', { id });
    await idle(page);
    assert.equal(await history(page), now);
    await reload(page);
    assert.equal(await history(page), now);
  }));

test('models of a newer page are left alone, and it is said what to do', () =>
  onEmptyDevice(async (page) => {
    await page.evaluate(
      () =>
        new Promise((resolve) => {
          const opening = indexedDB.open('spineloft', 77);
          opening.onsuccess = () => {
            opening.result.close();
            resolve();
          };
        }),
    );
    await reload(page);
    await drawPart(page);
    assert.match(await banner(page).innerText(), /newer SpineLoft/);
    assert.equal((await state(page)).parts.length, 1);
  }));

test('a damaged record is said, what came before it is there, and what comes after it is kept', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    for (const section of ['star', 'square', 'hexagon']) await done(page, 'set-section', { section });
    await inStore(page, 'journal', (store) => {
      const all = store.getAll();
      all.onsuccess = () => {
        const row = all.result.at(-2);
        store.put({ ...row, text: row.text.replace('square', 'sqvare') });
      };
    });
    assert.match(await reloadedToast(page), /The last 2 steps of tube could not be read/);
    assert.equal((await state(page)).parts[0].section, 'star');
    await done(page, 'set-caps', { both: 'flat', part: 1 });
    const now = await history(page);
    await reload(page);
    assert.equal(await history(page), now);
  }));

test('a model whose base is damaged is said and stays in the list; the page works', () =>
  onEmptyDevice(async (page) => {
    await drawPart(page);
    await inStore(page, 'bases', (store) => {
      const all = store.getAll();
      all.onsuccess = () => store.put({ ...all.result[0], text: all.result[0].text.slice(1) });
    });
    assert.match(await reloadedToast(page), /tube could not be brought back/);
    assert.equal((await models(page)).length, 1);
    await drawPart(page);
    assert.equal((await models(page)).length, 2);
  }));
