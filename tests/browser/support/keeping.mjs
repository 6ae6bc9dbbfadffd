// What the tests of keeping models share: looking into the page's database, and hands that are quick.
import { spawn } from 'node:child_process';
import { existsSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { browserFlags, browserPath } from '../../../.ci/lib/browser.mjs';
import { kLight, onPage, openWithPart } from './page.mjs';
import { tubePicture } from './pictures.mjs';

/** A picture so small that everything about it is quick. */
export const smallTube = tubePicture({ width: 120, height: 90, half: 8 });

/** Tests of this `kit` that begin on a device that has kept nothing; what is kept does not depend on the window. */
export const emptyDevice =
  (kit) =>
  (work, scripts = []) =>
    onPage(kit, { alone: true, viewport: { width: 640, height: 480 }, scripts }, work);

export const drawPart = (page) => openWithPart(page, smallTube.png, smallTube.middle);
export const banner = (page) => page.locator('#banners .banner');

/** In the page: whether it holds up who leaves it. */
function holdsUp() {
  const event = new Event('beforeunload', { cancelable: true });
  window.dispatchEvent(event);
  return event.defaultPrevented;
}
export const asksBeforeLeaving = (page) => page.evaluate(holdsUp);

/** Until every step is on the disk: a browser that is short of everything may take longer than the page waits. */
export async function onceKept(page) {
  while (await asksBeforeLeaving(page)) await page.waitForTimeout(50);
}

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

/** How long a browser may take to begin. */
const kStartMs = 180_000;

/**
 * A browser of its own with a profile in `folder`, and `kill()`, which ends all its processes at once and without a word, as
 * the system does that is short of memory. What it kept is there for the next one on the folder.
 */
export async function startMortalBrowser(folder) {
  const told = join(folder, 'DevToolsActivePort');
  rmSync(told, { force: true });
  const own = [`--user-data-dir=${folder}`, '--remote-debugging-port=0', '--headless', '--window-size=560,480'];
  const child = spawn(browserPath(), [...browserFlags, ...own, '--force-device-scale-factor=0.5', 'about:blank'], {
    detached: true, // a group of its own
    stdio: 'ignore',
  });
  const ended = new Promise((resolve) => child.once('exit', resolve));
  const kill = async () => {
    process.kill(-child.pid, 'SIGKILL');
    await ended;
  };
  try {
    const started = Date.now();
    // Two lines: the port and a path.
    while (!existsSync(told) || readFileSync(told, 'utf8').split('\n').length < 2) {
      if (Date.now() - started > kStartMs) throw new Error('the browser did not start');
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    const browser = await chromium.connectOverCDP(`http://127.0.0.1:${readFileSync(told, 'utf8').split('\n')[0]}`);
    const page = await browser.contexts()[0].newPage();
    for (const script of kLight) await page.addInitScript(script);
    return { page, kill };
  } catch (error) {
    await kill();
    throw error;
  }
}
