// Driving the page as a visitor does: real files, real pointers, real keys.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { PNG } from 'pngjs';
import { openPage, startBrowser, startSite } from '../../../.ci/lib/browser.mjs';

/** Window of the tests: wide enough for the side panel. */
export const kWindow = { width: 1100, height: 720 };

/** The two engines, each served as it would be chosen. */
export const kEngines = [
  { name: 'threads', isolated: true },
  { name: 'single thread', isolated: false },
];

/**
 * One browser and the site with and without isolation for a test file. `open(options)` opens a ready page;
 * pages are closed, and checked for troubles, by `check(page)`.
 */
export function useSite() {
  const kit = { browser: null, sites: {}, folder: null };
  before(async () => {
    kit.browser = await startBrowser();
    kit.sites.true = await startSite({ isolated: true });
    kit.sites.false = await startSite({ isolated: false });
    kit.folder = mkdtempSync(join(tmpdir(), 'spineloft-'));
  });
  after(async () => {
    await kit.browser?.close();
    for (const site of Object.values(kit.sites)) await site.close();
    if (kit.folder) rmSync(kit.folder, { recursive: true });
  });
  kit.open = async ({ isolated = true, query = '', ...context } = {}) => {
    const opened = await openPage(kit.browser, kit.sites[isolated].url + query, { viewport: kWindow, ...context });
    await opened.page.evaluate(() => window.spineloft.ready);
    return opened;
  };
  kit.file = (name, bytes) => {
    const path = join(kit.folder, name);
    writeFileSync(path, bytes);
    return path;
  };
  return kit;
}

/** Runs `work(page, opened)` on a fresh page and asserts that nothing went wrong behind its back. */
export async function onPage(kit, options, work) {
  const opened = await kit.open(options);
  try {
    await work(opened.page, opened);
    assert.deepEqual(opened.troubles, []);
  } finally {
    await opened.close();
  }
}

export const state = (page) => page.evaluate(() => window.spineloft.state());
export const pictureSize = (page) =>
  page.evaluate(() => {
    const { picture } = window.spineloft.state();
    return picture && { width: picture.width, height: picture.height };
  });
export const idle = (page) => page.evaluate(() => window.spineloft.idle());
export const run = (page, id, args) =>
  page.evaluate(([name, values]) => window.spineloft.run(name, values), [id, args]);

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

/** Client positions of picture points now. */
export function toClient(page, points) {
  return page.evaluate((list) => list.map(([x, y]) => window.spineloft.imageToClient(x, y)), points);
}

/** At most `count` of the points, ends included: enough for a stroke, quick on a machine that draws in software. */
function thinned(points, count = 18) {
  if (points.length <= count) return points;
  return Array.from({ length: count }, (_, i) => points[Math.round((i * (points.length - 1)) / (count - 1))]);
}

/** Draws with the mouse; `midway(page)` is called with the button still down. */
export async function drawWithMouse(page, points, midway) {
  const path = await toClient(page, thinned(points));
  await page.mouse.move(path[0].x, path[0].y);
  await page.mouse.down();
  for (const [i, at] of path.entries()) {
    await page.mouse.move(at.x, at.y);
    if (midway && i === Math.floor(path.length * 0.7)) await midway(page);
  }
  await page.mouse.up();
  await idle(page);
}

/** Draws with a finger: real touch events. */
export async function drawWithTouch(page, points) {
  const path = await toClient(page, thinned(points));
  const session = await page.context().newCDPSession(page);
  const touch = (type, at) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: at ? [{ x: at.x, y: at.y, id: 1 }] : [] });
  await touch('touchStart', path[0]);
  for (const at of path.slice(1)) await touch('touchMove', at);
  await touch('touchEnd');
  await session.detach();
  await idle(page);
}

/** Draws with a pen and its pressure. */
export async function drawWithPen(page, points, midway) {
  const path = await toClient(page, thinned(points));
  const session = await page.context().newCDPSession(page);
  const pen = (type, at, force) =>
    session.send('Input.dispatchMouseEvent', {
      type,
      x: at.x,
      y: at.y,
      button: 'left',
      buttons: type === 'mouseReleased' ? 0 : 1,
      clickCount: 1,
      pointerType: 'pen',
      force,
    });
  await pen('mousePressed', path[0], 0.4);
  for (const at of path.slice(1)) await pen('mouseMoved', at, 0.6);
  if (midway) await midway(page);
  await pen('mouseReleased', path.at(-1), 0);
  await session.detach();
  await idle(page);
}

/** Taps with several fingers at once. */
export async function tapWith(page, fingers, at) {
  const session = await page.context().newCDPSession(page);
  const touchPoints = Array.from({ length: fingers }, (_, id) => ({ x: at.x + 70 * id, y: at.y, id }));
  await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints });
  await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await session.detach();
  await idle(page);
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
  await page.waitForFunction(() => window.spineloft.state().picture !== null, undefined, { timeout: 15000 });
  await idle(page);
}

/** The text of the toast that appears with this role. */
export async function toastText(page, role = 'alert') {
  const toast = page.locator(`#toasts [role=${role}]`).last();
  await toast.waitFor({ timeout: 15000 });
  return toast.locator('p').innerText();
}

/** Decoded pixels of a part of the screen. */
export async function pixels(page, clip) {
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

/** Points of the canvas in client pixels. */
export async function onCanvas(page, ...points) {
  const box = await page.locator('#canvas').boundingBox();
  return points.map(([x, y]) => ({ x: box.x + x, y: box.y + y }));
}

const middleOf = ({ at: [x, y, width, height] }) => [x + width / 2, y + height / 2];

/**
 * What a panel on the canvas shows with these words, of this kind (button, row, grip, field, slider, section, tab) where
 * one is given; `row`: beside the row with that name. Null when there is none.
 */
export async function findControl(page, words, { kind, row } = {}) {
  await idle(page);
  const { controls } = await state(page);
  const beside = row && controls.find((one) => one.kind === 'row' && one.words === row);
  const level = (one) => beside === undefined || Math.abs(middleOf(one)[1] - middleOf(beside)[1]) < 2;
  const found = controls.filter(
    (one) => one.words === words && one.kind !== 'words' && (!kind || one.kind === kind) && level(one),
  );
  return found.find((one) => one.inSight) ?? found[0] ?? null;
}

/** The same, scrolled into sight by the wheel. */
export async function control(page, words, which = {}) {
  const box = await page.locator('#canvas').boundingBox();
  for (let turns = 0; turns < 40; turns += 1) {
    const found = await findControl(page, words, which);
    const { controls } = await state(page);
    assert.ok(found, `"${words}" is on the canvas, among ${controls.map((one) => one.words).join(' | ')}`);
    if (found.inSight) return found;
    const [x, y] = middleOf(found);
    const [panel] = await onCanvas(page, [x, Math.min(Math.max(y, 60), box.height - 60)]);
    await page.mouse.move(panel.x, panel.y);
    await page.mouse.wheel(0, y > box.height / 2 ? 120 : -120);
    await page.waitForTimeout(30);
  }
  throw new Error(`"${words}" does not come into sight`);
}

/** Where to press it, in client pixels. */
export async function placeOf(page, words, which) {
  const [at] = await onCanvas(page, middleOf(await control(page, words, which)));
  return at;
}

/** Presses what the canvas shows with these words, with the mouse or, where `touch` is true, with a finger. */
export async function press(page, words, { touch = false, ...which } = {}) {
  const found = await control(page, words, which);
  assert.ok(found.enabled, `"${words}" can be pressed`);
  const [at] = await onCanvas(page, middleOf(found));
  if (touch) await page.touchscreen.tap(at.x, at.y);
  else await page.mouse.click(at.x, at.y);
  await idle(page);
}

/** Answers the question that the page asks. */
export async function answer(page, text) {
  await page.getByRole('textbox').fill(text);
  await page.keyboard.press('Enter');
  await page.locator('dialog').waitFor({ state: 'detached' });
  await idle(page);
}

/** Pairs of words above the views and of what they cover; none where all is well. */
export async function wordsInTheWay(page) {
  await idle(page);
  const shown = (await state(page)).controls.filter(({ inSight }) => inSight);
  const meet = ([ax, ay, aw, ah], [bx, by, bw, bh]) => ax < bx + bw && bx < ax + aw && ay < by + bh && by < ay + ah;
  return shown
    .filter(({ kind }) => kind === 'words')
    .flatMap((words) =>
      shown.filter((other) => other !== words && meet(words.at, other.at)).map((other) => [words.words, other.words]),
    );
}
