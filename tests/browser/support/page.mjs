// The page as a visitor has it: the built site, pages that tests share, what the page shows and what it saves.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { chromium } from 'playwright-core';
import { PNG } from 'pngjs';
import { openPage, startBrowser, startSite } from '../../../.ci/lib/browser.mjs';

/** Window of the tests: wide enough for the side panel. */
export const kWindow = { width: 1100, height: 720 };
/** One device pixel for four of the window: drawing is what costs. Tests that look at pixels are `kSharp`. */
export const kQuick = { viewport: kWindow, deviceScaleFactor: 0.5 };
export const kSharp = { deviceScaleFactor: 1, draws: true };
export const kDesk = { viewport: { width: 1440, height: 900 }, hasTouch: true };
export const kPhone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
export const kTablet = { viewport: { width: 1024, height: 768 }, hasTouch: true };

/** The two engines, each served as it would be chosen; the first one is that of the tests, $SPINELOFT_ENGINE. */
export const kEngines = [
  { name: 'threads', isolated: true },
  { name: 'single thread', isolated: false },
];
if (process.env.SPINELOFT_ENGINE === 'single') kEngines.reverse();

/** Whether pages draw that no test looks at: in `npm run test:all`, and where somebody will look at pictures of them. */
const kAllDraw = Boolean(process.env.SPINELOFT_ALL_DRAW ?? process.env.SPINELOFT_PICTURES);

/** Pointers, each in a window. A finger comes before a pen: where a pen was in use, a finger moves the picture. */
export const kHands = [
  ['mouse', '1440×900', kDesk],
  ['finger', '1440×900', kDesk],
  ['pen', '1440×900', kDesk],
  ['mouse', '390×844', kPhone],
  ['finger', '390×844', kPhone],
  ['pen', '390×844', kPhone],
];

/**
 * In the page, before its own scripts: the engine's stages count as warmed up. Its twelve rounds take the processor for
 * longer than all else that a page does to start, and only tests of the warm-up itself need them.
 */
export const asWarm = () => performance.mark('spineloft-warm');

/**
 * In the page, before its own scripts: the renderer does all but draw, which takes a processor without a GPU longer than
 * all else.
 */
export function withoutDrawing() {
  for (const name of ['drawElements', 'drawArrays', 'clear', 'blitFramebuffer'])
    WebGL2RenderingContext.prototype[name] = () => undefined;
  window.drawsNothing = true;
}
/** Scripts of pages that no test looks at. */
export const kLight = kAllDraw ? [asWarm] : [asWarm, withoutDrawing];

const assertDraws = async (page) =>
  assert.ok(!(await page.evaluate(() => window.drawsNothing)), 'a test that looks at pixels wants a page that draws');

/** In the page, before its scripts: how WebAssembly programs are made, and how large they are. */
export function watchPrograms() {
  window.programs = [];
  for (const name of ['compileStreaming', 'instantiateStreaming', 'compile', 'instantiate']) {
    const real = WebAssembly[name].bind(WebAssembly);
    WebAssembly[name] = (source, ...rest) => {
      if (!(source instanceof WebAssembly.Module)) window.programs.push(name);
      return real(source, ...rest);
    };
  }
}

/** How the two programs of the page's engine were made, on a page with `watchPrograms`. */
export async function enginePrograms(page) {
  await page.waitForFunction(() => window.programs?.length === 2);
  return page.evaluate(() => window.programs);
}

/** In the page: an empty board, no models, nothing said; true when that is so. */
async function beginAnew() {
  const api = window.spineloft;
  await api.idle();
  await api.run('new-model').catch(() => undefined); // refused where the board is empty
  await api.idle();
  for (const { id } of await api.models()) await api.run('delete-model', { id });
  await api.idle();
  for (const close of document.querySelectorAll('#toasts .toast-close')) close.click();
  localStorage.clear();
  await api.run('more-tools', { on: true });
  await api.idle();
  const { picture, parts, undo, tool } = api.state();
  const isOpen = document.querySelector('dialog[open], [role=menu], #banners .banner') !== null;
  return picture === null && parts.length === 0 && undo === 0 && tool === 'draw' && !isOpen;
}

/**
 * One browser and the site with and without isolation for a test file. A browser that is there already is used where
 * $SPINELOFT_BROWSER_WS names it. `prepare(kit)` makes what all of the file's tests use.
 */
export function useSite(prepare) {
  const kit = { browser: null, sites: {}, folder: null, shared: new Map() };
  before(async () => {
    const address = process.env.SPINELOFT_BROWSER_WS;
    kit.browser = await (address ? chromium.connect(address) : startBrowser());
    kit.sites.true = await startSite({ isolated: true });
    kit.sites.false = await startSite({ isolated: false });
    kit.folder = mkdtempSync(join(tmpdir(), 'spineloft-'));
    await prepare?.(kit);
  });
  after(async () => {
    await kit.browser?.close();
    for (const site of Object.values(kit.sites)) await site.close();
    if (kit.folder) rmSync(kit.folder, { recursive: true });
  });
  /**
   * A ready page in a context of its own, with all tools; options are Playwright's, `isolated` and `query` of the
   * address, `firstVisit`: with the first tools only, `warmsUp`: with the engine's warm-up, and `scripts`, functions that
   * run in the page before its own.
   */
  kit.open = async ({
    isolated = kEngines[0].isolated,
    query = '',
    scripts = [],
    firstVisit,
    warmsUp,
    draws = false,
    ...context
  } = {}) => {
    const first = kLight.filter((script) => !(warmsUp && script === asWarm) && !(draws && script === withoutDrawing));
    const opened = await openPage(kit.browser, kit.sites[isolated].url + query, {
      ...kQuick,
      ...context,
      scripts: [...first, ...scripts],
    });
    await opened.page.evaluate(() => window.spineloft.ready);
    // The first tools are for a first visit; `firstVisit` tests what that shows.
    if (!firstVisit) await run(opened.page, 'more-tools', { on: true });
    return opened;
  };
  /** The page that the tests with these options share, begun anew; settings that outlast a model stay as they are. */
  kit.page = async (options) => {
    const key = JSON.stringify({ ...options, scripts: String(options.scripts) });
    const known = kit.shared.get(key);
    if (known) {
      if (await known.page.evaluate(beginAnew)) return known;
      await kit.close(known);
    }
    const opened = await kit.open(options);
    kit.shared.set(key, opened);
    return opened;
  };
  kit.close = async (opened) => {
    for (const [key, one] of kit.shared) if (one === opened) kit.shared.delete(key);
    await opened.close();
  };
  kit.file = (name, bytes) => {
    const path = join(kit.folder, name);
    writeFileSync(path, bytes);
    return path;
  };
  return kit;
}

/**
 * Runs `work(page, opened)` and asserts that nothing went wrong behind its back: on the page that the file's tests with
 * these options share, or, with `alone`, on a fresh one, for what concerns starting, storage, tabs and lasting settings.
 */
export async function onPage(kit, { alone = false, ...options }, work) {
  const opened = await (alone ? kit.open(options) : kit.page(options));
  let isGood = false;
  try {
    await work(opened.page, opened);
    assert.deepEqual(opened.troubles, []);
    isGood = true;
  } finally {
    if (alone || !isGood) await kit.close(opened);
  }
}

export const state = (page) => page.evaluate(() => window.spineloft.state());
export const pictureSize = (page) =>
  page.evaluate(() => {
    const { picture } = window.spineloft.state();
    return picture && { width: picture.width, height: picture.height };
  });
export const idle = (page) => page.evaluate(() => window.spineloft.idle());
/** Runs a command; what it began goes on: `idle`, or `done`. */
export const run = (page, id, args) =>
  page.evaluate(([name, values]) => window.spineloft.run(name, values), [id, args]);
/** Runs a command and waits until all that it began is done. */
export const done = (page, id, args) =>
  page.evaluate(
    async ([name, values]) => {
      await window.spineloft.run(name, values);
      await window.spineloft.idle();
    },
    [id, args],
  );
/** The error code of a call that must be refused; null where it was not. */
export const refusal = (page, id, args) =>
  page.evaluate(
    ([name, values]) =>
      window.spineloft.run(name, values).then(
        () => null,
        (error) => error.code,
      ),
    [id, args],
  );

/** Two frames have been drawn: what was pressed has reached the model. */
export const framed = (page) =>
  page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));

/** Loads the page again and waits until it runs. */
export async function reload(page) {
  await page.reload();
  await page.evaluate(() => window.spineloft.ready);
  await idle(page);
}

/** The same; returns the toast that the page greets with, which may be gone before a busy page is idle. */
export async function reloadedToast(page, role = 'alert') {
  await page.reload();
  const text = await toastText(page, role);
  await page.evaluate(() => window.spineloft.ready);
  await idle(page);
  return text;
}

/** Opens a picture through the API and waits for its edges. */
export async function openPicture(page, bytes, name = 'picture.png') {
  await page.evaluate(
    async ([data, title]) => {
      const binary = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
      await window.spineloft.openImage(new Blob([binary]), title);
      await window.spineloft.idle();
    },
    [Buffer.from(bytes).toString('base64'), name],
  );
}

/** A picture, and a part by the command that a pen's stroke becomes. */
export async function openWithPart(page, bytes, stroke, name = 'tube.png') {
  await openPicture(page, bytes, name);
  await done(page, 'draw-spine', { stroke });
}

/** Client positions of picture points now. */
export function toClient(page, points) {
  return page.evaluate((list) => list.map(([x, y]) => window.spineloft.imageToClient(x, y)), points);
}

/** Drops files from the system on the page. */
export async function dropFiles(page, paths, at = { x: 300, y: 300 }) {
  const session = await page.context().newCDPSession(page);
  const data = { items: [], files: paths, dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop']) {
    await session.send('Input.dispatchDragEvent', { type, x: at.x, y: at.y, data });
  }
  await session.detach();
}

/** Waits until the page shows a picture, then until its work is done. */
export async function waitForPicture(page) {
  await page.waitForFunction(() => window.spineloft.state().picture !== null);
  await idle(page);
}

/** The text of the toast that appears with this role. */
export async function toastText(page, role = 'alert') {
  const toast = page.locator(`#toasts [role=${role}]`).last();
  await toast.waitFor();
  return toast.locator('p').innerText();
}

/** Decoded pixels of a part of the screen. */
export async function pixels(page, clip) {
  await assertDraws(page);
  return PNG.sync.read(await page.screenshot(clip ? { clip } : {}));
}

/** Share of pixels that differ clearly between two screenshots of the same size. */
export function difference(a, b) {
  assert.equal(a.data.length, b.data.length);
  let count = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    const d =
      Math.abs(a.data[i] - b.data[i]) +
      Math.abs(a.data[i + 1] - b.data[i + 1]) +
      Math.abs(a.data[i + 2] - b.data[i + 2]);
    if (d > 48) count += 1;
  }
  return count / (a.data.length / 4);
}

/** A model file of what is on the page. */
export async function exported(page, format) {
  if (format === 'png') await assertDraws(page);
  const text = await page.evaluate(async (kind) => {
    const bytes = await window.spineloft.exportModel(kind);
    let binary = '';
    for (let at = 0; at < bytes.length; at += 8192) binary += String.fromCharCode(...bytes.subarray(at, at + 8192));
    return btoa(binary);
  }, format);
  return Buffer.from(text, 'base64');
}

/** Goes through the bar's More menu by its words, one list after the other, as a hand does. */
export async function chooseFromMore(page, ...words) {
  await page.locator('#bar-more').click();
  for (const word of words)
    await page
      .getByRole('menu')
      .locator('[role^=menuitem]')
      .filter({ has: page.locator('.menu-label').getByText(word, { exact: true }) })
      .click();
  await idle(page);
}

/** Finds a command by its words, as a hand does, and runs it. */
export async function chooseFromSearch(page, words) {
  await page.keyboard.press('/');
  await page.getByRole('combobox').fill(words);
  await page.keyboard.press('Enter');
  await idle(page);
}

/** Presses a button of the bar, and what comes up then by its words. */
export async function pressBar(page, id, word) {
  await page.locator(`#bar-items [data-command=${id}]`).click();
  if (word) await page.getByRole('menu').locator('[role^=menuitem]').filter({ hasText: word }).click();
  await idle(page);
}

/** The file that comes when this is done: its name and bytes. */
export async function downloaded(page, work) {
  const [download] = await Promise.all([page.waitForEvent('download', { timeout: 60_000 }), work()]);
  const chunks = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk);
  return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) };
}

/** Answers the question that the page asks. */
export async function answer(page, text) {
  await page.getByRole('textbox').fill(text);
  await page.keyboard.press('Enter');
  await page.locator('dialog').waitFor({ state: 'detached' });
  await idle(page);
}
