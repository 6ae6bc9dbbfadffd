// Texts that others give, made to run as a program: wherever they are shown, they are shown as text and nothing runs.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { openPage, startSite } from '../../.ci/lib/browser.mjs';
import { makeShare } from '../../web/share/server.mjs';
import { openStore } from '../../web/share/store.mjs';
import { loadClient } from '../share/support/server.mjs';
import {
  kLight,
  downloaded,
  done,
  dropFiles,
  idle,
  kWindow,
  openWithPart,
  run,
  state,
  useSite,
} from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kTexts = [
  '<img data-hostile src=x onerror=hit()>',
  '"><svg data-hostile onload=hit()>',
  "' autofocus onfocus=hit() data-hostile='",
  '<script data-hostile>hit()</script>',
  '</title></style></textarea><b data-hostile>',
  '<a data-hostile href=javascript:hit()>x</a>',
  '<iframe data-hostile srcdoc=hit()>',
  'javascript:hit()//',
  '&lt;b data-hostile&gt;&#60;b&#62;',
  '{n, plural, other{<b data-hostile>}}',
  '${hit()}{{hit()}}<%=hit()%>',
  '__proto__',
  '../../<x data-hostile>.glb',
];

const kit = useSite();
const tube = tubePicture({ width: 120, height: 90, half: 8 });
const { newId, Room, ShareServer } = await loadClient();
let folder, share, site;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'spineloft-hostile-'));
  share = await makeShare({ store: await openStore(join(folder, 'share.sqlite')) });
  site = await startSite({ share });
});
after(async () => {
  share?.endStreams();
  await site?.close();
  await share?.close();
  if (folder) rmSync(folder, { recursive: true, force: true });
});

/** In the page, before its own scripts: notes what ran, what became an element, and what the policy had to stop. */
function watchHits() {
  window.hits = [];
  window.hit = () => window.hits.push('ran');
  document.addEventListener('securitypolicyviolation', ({ blockedURI }) => window.hits.push(`stopped: ${blockedURI}`));
  new MutationObserver(() => {
    if (document.querySelector('[data-hostile]')) window.hits.push('an element');
  }).observe(document, { subtree: true, childList: true, attributes: true });
}

/** Runs `work` in a page of the site with the server, in which nothing may be hit. */
async function visit(url, work) {
  const opened = await openPage(kit.browser, url, {
    viewport: kWindow,
    deviceScaleFactor: 0.5,
    scripts: [...kLight, watchHits],
  });
  opened.page.setDefaultTimeout(120_000);
  try {
    if (!url.includes('view.html')) await opened.page.evaluate(() => window.spineloft.ready);
    await work(opened.page, opened);
    assert.deepEqual(await opened.page.evaluate(() => window.hits), []);
    // Streams end with what they are for.
    const expected = /status of (400|404)|^status (400|404)|^request failed: .*\/events\?/;
    assert.deepEqual(
      opened.troubles.filter((trouble) => !expected.test(trouble)),
      [],
    );
  } finally {
    await opened.close();
  }
}

/** In the page: which of these texts no element and no field shows. */
const notShown = (texts) => {
  const shown = new Set();
  for (const element of document.querySelectorAll('body *')) {
    shown.add(element.textContent.trim());
    if (typeof element.value === 'string') shown.add(element.value);
  }
  return texts.filter((text) => !shown.has(text));
};
const allShown = async (page, texts) => {
  await page.waitForFunction((all) => document.body.textContent.includes(all.at(-1)), texts);
  assert.deepEqual(await page.evaluate(notShown, texts), []);
};
const button = (page, name) => page.getByRole('button', { name, exact: true });

async function open(work) {
  await visit(site.url, async (page, opened) => {
    await openWithPart(page, tube.png, tube.middle);
    await work(page, opened);
  });
}

test('what pupils send, whatever their program is, is text on the wall, on the projector, and for other pupils', async () => {
  await visit(site.url, async (desk) => {
    await button(desk, 'Open a class').click();
    await button(desk, 'Open the class').click();
    await desk.locator('.wall-words').waitFor();
    const { room } = await desk.evaluate(() => JSON.parse(localStorage.getItem('spineloft.class.1')));
    const server = new ShareServer(`${site.url}share/v1/`);
    const cards = [];
    for (const text of kTexts) {
      const pupil = new Room(server, { id: room.id, key: room.key }, { id: newId(), secret: newId() });
      await pupil.post({ type: 'seat', animal: text.slice(0, 40), number: await pupil.sit() }).catch(assert.fail);
      const card = { type: 'card', name: text, model: newId(), frames: 1, text, from: text.slice(0, 40) };
      cards.push(await pupil.post(card, Buffer.from(text)));
    }
    await allShown(desk, kTexts);
    // What is no picture is not shown as one.
    await desk.waitForFunction(() => document.querySelector('#wall .turning img') === null);
    for (const card of cards.slice(0, 3)) {
      await desk.locator(`[data-post="${card}"] button`).click();
      await desk.getByRole('dialog').waitFor();
      await desk.keyboard.press('Escape');
    }
    await button(desk, 'Projector view').click();
    await allShown(desk, kTexts);
    const link = (kind) => `${site.url}#${kind}=${room.id}.${room.key}`;
    await visit(link('wall'), (screen) => allShown(screen, kTexts));
    await visit(link('class'), async (pupil) => {
      await pupil.getByRole('dialog').getByRole('button', { name: 'Turtle' }).click();
      await pupil.getByRole('region', { name: 'Class', exact: true }).getByRole('button', { name: 'Our wall' }).click();
      await allShown(pupil, kTexts);
      // What comes from the teacher's address, likewise.
      const { seat } = await pupil.evaluate(() => JSON.parse(localStorage.getItem('spineloft.class.1')));
      const teacher = new Room(server, room, null);
      const mine = new Room(server, { id: room.id, key: room.key }, seat);
      const card = { type: 'card', name: kTexts[0], model: newId(), frames: 1, text: '', from: null };
      const post = await mine.post(card, Buffer.from(kTexts[0]));
      await teacher.post({ type: 'start', model: newId(), name: kTexts[0] });
      await teacher.post({ type: 'spotlight', card: post });
      await teacher.post({ type: 'back', card: post, to: seat.id, at: [0.5, 0.5], words: kTexts[0] });
      const back = pupil.getByRole('dialog', { name: 'Your teacher handed your model back' });
      await back.getByText(kTexts[0], { exact: true }).waitFor();
    });
    await button(desk, "Teacher's view").click();
    await desk.evaluate(() => (window.print = () => (window.printed = document.querySelectorAll('.sticker').length)));
    await button(desk, 'Print stickers').click();
    await desk.waitForFunction(() => window.printed > 0);
  });
});

test('names of models, parts, pictures and files are text in the editor, in its lists and in what it shares', () =>
  open(async (page) => {
    for (const name of kTexts) {
      await done(page, 'rename-part', { name });
      await done(page, 'rename-picture', { name });
      await done(page, 'rename-model', { name });
      await page.waitForFunction(isShown, name);
    }
    const [name] = kTexts;
    await done(page, 'rename-model', { name });
    await run(page, 'share-model');
    const dialog = page.getByRole('dialog', { name: 'Share' });
    await dialog.getByText('On your own page').click();
    await page.waitForFunction(() => document.querySelector('#share-snippet').value !== '');
    const snippet = await dialog.getByRole('textbox', { name: 'Put this into the HTML of the page' }).inputValue();
    const found = await page.evaluate((html) => {
      const { body } = new DOMParser().parseFromString(html, 'text/html');
      return [...body.querySelectorAll('*')].map(({ localName, title }) => [localName, title]);
    }, snippet);
    assert.deepEqual(found, [['iframe', name]]);
    await page.keyboard.press('Escape');
    await dropFiles(page, [kit.file('<img data-hostile src=x onerror=hit()>.png', tube.png)]);
    await page.waitForFunction(() => window.spineloft.state().pictureList.length === 2);
    await idle(page);
    const { name: file } = await downloaded(page, () => run(page, 'save-project'));
    assert.doesNotMatch(file, /[<>"/\\]/);
    await button(page, 'Home').click();
    await page.waitForFunction(isShown, name);
  }));

/** In the page: whether some element or field shows this text and nothing else. */
function isShown(text) {
  return [...document.querySelectorAll('body *')].some(
    (element) => element.textContent.trim() === text || element.value === text || element.ariaLabel === text,
  );
}

test('a link, a stored model and the answers of a server are text for who opens them', () =>
  open(async (page, { context }) => {
    const [name] = kTexts;
    await done(page, 'rename-model', { name });
    const { url } = await page.evaluate(() => window.spineloft.shareLink());
    await visit(url, async (viewer) => {
      await viewer.locator('body[data-state=shown]').waitFor();
      assert.equal(await viewer.locator('#name').innerText(), name);
    });
    for (const text of kTexts) {
      await visit(`${site.url}view.html#m=${encodeURI(text)}`, async (viewer) => {
        await viewer.locator('body[data-state=failed]').waitFor();
      });
    }
    const stored = await page.evaluate(() => window.spineloft.shareLink({ stored: true }));
    await visit(stored.url, async (other) => {
      await other.locator('body[data-state=shown]').waitFor();
      assert.equal(await other.locator('#name').innerText(), name);
      await other.getByRole('link', { name: 'Make it mine' }).click();
      await other.waitForFunction((wanted) => window.spineloft?.state().documentName === wanted, name);
      await idle(other);
      assert.equal((await state(other)).parts.length, 1);
    });
    await context.route('**/share/v1/**', (route) =>
      route.fulfill({ status: 400, json: { code: name, message: name }, headers: { 'Retry-After': name } }),
    );
    const sentence = await page.evaluate(
      (link) =>
        window.spineloft.openShareText(link).then(
          () => '',
          ({ message }) => message,
        ),
      stored.url,
    );
    assert.ok(sentence.length > 0 && !sentence.includes(name), sentence);
  }));
