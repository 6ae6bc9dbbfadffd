// What the tests of keeping models share: looking into the page's database, and hands that are quick.
import { chromium } from 'playwright-core';
import { browserFlags, browserPath } from '../../../.ci/lib/browser.mjs';
import { tubePicture } from './pictures.mjs';

/** A picture so small that everything about it is quick. */
export const smallTube = tubePicture({ width: 120, height: 90, half: 8 });

export const history = (page) => page.evaluate(() => window.spineloft.history());
export const models = (page) => page.evaluate(() => window.spineloft.models());

/** In the page: all rows of a store of its database, or what `work(store)` does to it. */
function withStore(name, work) {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open('spineloft');
    opening.onerror = () => reject(opening.error);
    opening.onsuccess = () => {
      const tx = opening.result.transaction(name, 'readwrite');
      const all = work ? work(tx.objectStore(name)) : tx.objectStore(name).getAll();
      tx.oncomplete = () => {
        opening.result.close();
        resolve(work ? null : all.result.map((row) => ({ ...row, bytes: row.bytes?.length })));
      };
      tx.onerror = () => reject(tx.error);
    };
  });
}

/** Reads all of a store of the page's database, or works on it: `work(store)` runs in the page. */
export function inStore(page, name, work) {
  // As one text: the page's policy forbids it to make functions of texts.
  return page.evaluate(`(${withStore})(${JSON.stringify(name)}, ${work ?? 'null'})`);
}

/** A browser with a profile on the disk: what it keeps outlives its pages. */
export function startKeptBrowser(folder, options = {}) {
  return chromium.launchPersistentContext(folder, {
    executablePath: browserPath(),
    args: browserFlags,
    headless: true,
    viewport: { width: 560, height: 400 },
    deviceScaleFactor: 0.5,
    ...options,
  });
}
