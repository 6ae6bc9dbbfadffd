// What the tests of keeping models share: looking into the page's database, and hands that are quick.
import { chromium } from 'playwright-core';
import { browserFlags, browserPath } from '../../../.ci/lib/browser.mjs';
import { tubePicture } from './pictures.mjs';

/** A picture so small that everything about it is quick. */
export const smallTube = tubePicture({ width: 120, height: 90, half: 8 });

export const history = (page) => page.evaluate(() => window.spineloft.history());
export const models = (page) => page.evaluate(() => window.spineloft.models());

/** Reads all of a store of the page's database, or works on it: `work(store)` runs in the page. */
export function inStore(page, name, work) {
  return page.evaluate(([store, source]) => new Promise((resolve, reject) => {
    const opening = indexedDB.open('spineloft');
    opening.onerror = () => reject(opening.error);
    opening.onsuccess = () => {
      const tx = opening.result.transaction(store, 'readwrite');
      const done = source ? new Function('store', `return (${source})(store)`)(tx.objectStore(store)) : tx.objectStore(store).getAll();
      tx.oncomplete = () => {
        opening.result.close();
        resolve(source ? null : done.result.map((row) => ({ ...row, bytes: row.bytes?.length })));
      };
      tx.onerror = () => reject(tx.error);
    };
  }), [name, work ? String(work) : null]);
}

/** A browser with a profile on the disk: what it keeps outlives its pages. */
export function startKeptBrowser(folder, options = {}) {
  return chromium.launchPersistentContext(folder, {
    executablePath: browserPath(), args: browserFlags, headless: true, viewport: { width: 560, height: 400 }, ...options,
  });
}
