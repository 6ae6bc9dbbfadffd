// The page without a network, a new release under an open page, and files that the system sends.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { cpSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { openPage } from '../../.ci/lib/browser.mjs';
import { distDir } from '../../.ci/lib/paths.mjs';
import { serveFolder } from '../../.ci/lib/server.mjs';
import {
  enginePrograms,
  kLight,
  done,
  idle,
  kEngines,
  kWindow,
  onPage,
  openWithPart,
  run,
  state,
  toastText,
  useSite,
  watchPrograms,
} from './support/page.mjs';
import { samples, tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();
const [lemur] = samples();

/** The site on a server that can be taken away, and its folder, to put another release in. */
async function ownSite(t) {
  const folder = join(kit.folder, `site-${Math.random()}`);
  cpSync(distDir, folder, { recursive: true });
  const site = await serveFolder(folder, { isolated: kEngines[0].isolated });
  t.after(() => site.close());
  return { ...site, folder };
}

/** A page that has a service worker, once that has stored all. */
async function visit(t, { url }) {
  const opened = await openPage(kit.browser, url, {
    viewport: kWindow,
    deviceScaleFactor: 0.5,
    serviceWorkers: 'allow',
    scripts: kLight,
  });
  t.after(() => opened.close());
  await opened.page.evaluate(async () => {
    await window.spineloft.ready;
    await navigator.serviceWorker.ready;
  });
  await opened.page.waitForFunction(() => navigator.serviceWorker.controller?.state === 'activated');
  return opened;
}

/** Puts another release in place: its page says so, and its service worker knows that page. */
function release(folder, name, { half = false } = {}) {
  const page = join(folder, 'index.html'),
    worker = join(folder, 'service_worker.js');
  const old = readFileSync(page),
    fresh = Buffer.from(old.toString().replace(/<html lang="en"[^>]*>/, `<html lang="en" data-release="${name}">`));
  const sum = (bytes) => createHash('sha256').update(bytes);
  const text = readFileSync(worker, 'utf8');
  assert.ok(text.includes(sum(old).digest('base64')), 'the service worker knows the page by its sum');
  // Of a release that is half in place the worker is there and the page is not.
  if (!half) writeFileSync(page, fresh);
  writeFileSync(
    worker,
    text
      .replace(sum(old).digest('base64'), sum(fresh).digest('base64'))
      .replace(sum(old).digest('hex').slice(0, 10), sum(fresh).digest('hex').slice(0, 10)),
  );
  for (const twin of ['br', 'gz']) for (const file of [page, worker]) rmSync(`${file}.${twin}`, { force: true });
}

const releaseOf = (page) => page.evaluate(() => document.documentElement.dataset.release ?? null);
/** Looks for a new release, as an open page does from time to time. */
const look = (page) =>
  page.evaluate(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    await registration.update().catch(() => undefined);
    const { installing } = registration;
    if (installing)
      await new Promise((resolve) => {
        installing.onstatechange = () => ['installed', 'redundant'].includes(installing.state) && resolve();
      });
  });

test('after one visit the page opens without a network: a sample becomes a part, two parts one solid, and a thing is cut out', async (t) => {
  const site = await ownSite(t);
  const { page } = await visit(t, site);
  await site.close();
  await page.addInitScript(watchPrograms);
  await page.reload();
  await page.evaluate(() => window.spineloft.ready);
  assert.deepEqual(
    await enginePrograms(page),
    ['compileStreaming', 'compileStreaming'],
    'what is stored comes as a stream',
  );
  await page.locator('.sample-open').first().click();
  await page.waitForFunction(() => window.spineloft.state().picture !== null);
  await idle(page);
  await done(page, 'draw-spine', { stroke: lemur.spine });
  await run(page, 'new-part');
  await done(page, 'draw-spine', { stroke: lemur.spine.slice(4).map(([x, y]) => [x + 10, y + 6]) });
  await done(page, 'stick-together');
  const { steps, threads } = await state(page);
  assert.equal(steps.at(-1).status, 'ready');
  assert.equal(threads > 0, kEngines[0].isolated, 'the headers that threads need are stored too');
  await done(page, 'cut-out', { at: lemur.spine[4], as: 'sheet' });
  const { parts } = await state(page);
  assert.deepEqual([parts.at(-1).kind, parts.at(-1).failure], ['sheet', null]);
});

test('after one visit every language is there without a network', async (t) => {
  const site = await ownSite(t);
  const { page } = await visit(t, site);
  await site.close();
  for (const id of ['ja', 'ar', 'de']) {
    await run(page, 'language', { language: id });
    await page.locator(`body[data-language=${id}]`).waitFor();
    await page.reload();
    await page.evaluate(() => window.spineloft.ready);
    assert.equal(await page.evaluate(() => document.documentElement.lang), id);
  }
});

test('a new release is offered, waits for other tabs, and is used when asked; models stay', async (t) => {
  const site = await ownSite(t);
  const { page, context } = await visit(t, site);
  await openWithPart(page, tube.png, tube.middle);
  const other = await context.newPage();
  await other.goto(site.url);
  release(site.folder, 'two');
  await look(page);
  const banner = page.locator('#banners [data-id=new-release]');
  await banner.waitFor();
  assert.equal(await releaseOf(other), null);
  await banner.getByRole('button', { name: 'Use it now' }).click();
  assert.match(await toastText(page), /open in another tab/);
  assert.equal(await releaseOf(page), null);
  await other.reload();
  assert.equal(await releaseOf(other), null, 'another tab stays on the release in use');
  await other.close();
  let loaded = false;
  page.once('load', () => (loaded = true));
  // The browser may count the closed tab for a moment longer: what the page says then is "press again".
  for (const giveUp = Date.now() + 60_000; !loaded && Date.now() < giveUp; await sleep(500))
    await banner
      .getByRole('button', { name: 'Use it now' })
      .click({ timeout: 2000 })
      .catch(() => undefined);
  assert.ok(loaded, 'the page loads the new release');
  await page.evaluate(() => window.spineloft.ready);
  assert.equal(await releaseOf(page), 'two');
  await idle(page);
  assert.equal((await state(page)).parts.length, 1);
});

test('a release that is half in place is not used', async (t) => {
  const site = await ownSite(t);
  const { page, troubles } = await visit(t, site);
  release(site.folder, 'two', { half: true });
  await look(page);
  assert.equal(await page.locator('#banners .banner').count(), 0);
  await site.close();
  await page.reload();
  await page.evaluate(() => window.spineloft.ready);
  assert.equal(await releaseOf(page), null);
  troubles.splice(0);
});

test("a picture from the system's share sheet opens", async (t) => {
  const site = await ownSite(t);
  const { context } = await visit(t, site);
  // The system sends a form as another page would.
  const sender = await context.newPage();
  await sender.setContent(
    `<form action="${site.url}share" method="post" enctype="multipart/form-data"><input type="file" name="files"><button>`,
  );
  await sender.locator('input').setInputFiles({ name: 'grüße.png', mimeType: 'image/png', buffer: tube.png });
  await sender.locator('button').click();
  await sender.waitForURL(site.url);
  await sender.waitForFunction(() => window.spineloft?.state().picture !== null);
  assert.match((await state(sender)).pictureList[0].name, /grüße/);
});

test('where what puts parts together cannot be loaded, that is said, and trying again is enough', () =>
  onPage(kit, { alone: true }, async (page, { context, troubles }) => {
    await openWithPart(page, lemur.bytes, lemur.spine);
    await context.route(/manifold.*\.wasm/, (route) => route.abort());
    await run(page, 'new-part');
    await done(page, 'draw-spine', { stroke: lemur.spine.slice(4).map(([x, y]) => [x + 10, y + 6]) });
    await done(page, 'stick-together');
    assert.match(await toastText(page), /could not be loaded\. Nothing is lost: check the connection/);
    await context.unroute(/manifold.*\.wasm/);
    await done(page, 'solve-again');
    assert.equal((await state(page)).steps.at(-1).status, 'ready');
    troubles.splice(0);
  }));
