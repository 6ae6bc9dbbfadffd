// A whole lesson of five pages, a teacher, two pupils at desks, one on a phone and a screen, on one wall; a shorter one on
// a plain http address. What the server promises is said by tests/share.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { networkInterfaces, tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { unzipSync } from 'fflate';
import jsqr from 'jsqr';
import { PNG } from 'pngjs';
import { openPage, startSite } from '../../.ci/lib/browser.mjs';
import { makeShare } from '../../web/share/server.mjs';
import { openStore } from '../../web/share/store.mjs';
import {
  done,
  downloaded,
  idle,
  kLight,
  kPhone,
  kSharp,
  kWindow,
  onPage,
  openPicture,
  openWithPart,
  reload,
  run,
  state,
  useSite,
  waitForPicture,
} from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture({ width: 120, height: 90, half: 8 });
const said = [];
let folder, share, site, store;

/** An address of this machine that is not the machine's own name: there a page has no secure context. */
const plainAddress = Object.values(networkInterfaces())
  .flat()
  .find(({ family, internal }) => family === 'IPv4' && !internal)?.address;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'spineloft-lesson-'));
  store = await openStore(join(folder, 'share.sqlite'));
  share = await makeShare({ store, log: (line) => said.push(line), limits: { sweepMs: 200 } });
  site = await startSite({ share, host: '0.0.0.0' });
});
after(async () => {
  share?.endStreams();
  await site?.close();
  await share?.close();
  if (folder) rmSync(folder, { recursive: true, force: true });
});

const button = (page, name) => page.getByRole('button', { name, exact: true });
const strip = (page) => page.getByRole('region', { name: 'Class', exact: true });
const wall = (page) => page.getByRole('region', { name: 'Our wall' });
const cards = (page) => wall(page).locator('.wall-card');
const wordsOn = (page) => wall(page).locator('.wall-words').innerText();
const handIn = (page) => strip(page).getByRole('button', { name: 'Hand in' }).click();
const sentence = (page, text) => page.getByText(text).first().waitFor();

async function open(options = {}, address = site.url) {
  const light = { viewport: kWindow, deviceScaleFactor: 0.5, scripts: kLight };
  const opened = await openPage(kit.browser, address, { ...light, ...options });
  await opened.page.evaluate(() => window.spineloft.ready);
  return opened;
}

async function openClass(options, address) {
  const opened = await open(options, address);
  await button(opened.page, 'Open a class').click();
  const isPlain = await opened.page.getByRole('dialog').getByText(kPlainNote).isVisible();
  assert.equal(isPlain, address !== undefined);
  await button(opened.page, 'Open the class').click();
  await wall(opened.page).locator('.wall-words').waitFor();
  return opened;
}

/** What a page on a plain http address says of https. */
const kPlainNote = 'This address is plain http. Everything works; with https the page would be faster';

/** A pupil who types the words and picks an animal; `sees(dialog)` looks at the animals before. */
async function joinAs(page, words, animal, sees = () => undefined) {
  await button(page, 'Join a class').click();
  await page.getByRole('textbox', { name: 'The four words on the wall' }).fill(words);
  await button(page, 'Join').click();
  const dialog = page.getByRole('dialog', { name: 'Which animal are you?' });
  await dialog.waitFor();
  await sees(dialog);
  await dialog.getByRole('button', { name: animal }).click();
  await strip(page)
    .getByText(new RegExp(`${animal} \\d+`))
    .waitFor();
}

async function make(page, name) {
  await openWithPart(page, tube.png, tube.middle);
  await run(page, 'rename-model', { name });
  await idle(page);
}

/** In the page: how many hand-ins wait in the browser. */
const waitingParcels = () =>
  new Promise((resolve) => {
    const request = indexedDB.open('spineloft-class');
    request.onsuccess = () => {
      const count = request.result.transaction('parcels').objectStore('parcels').count();
      count.onsuccess = () => {
        request.result.close();
        resolve(count.result);
      };
    };
  });

/** The link to the class on the address of the teacher's page. */
const linkOf = (page) =>
  page.evaluate(() => {
    const { room } = JSON.parse(localStorage.getItem('spineloft.class.1'));
    return `${location.origin}${location.pathname}#class=${room.id}.${room.key}`;
  });

/** What a camera reads on the wall. */
async function codeOn(page) {
  const picture = await wall(page).getByRole('img', { name: 'QR code to join the class' }).screenshot();
  const { data, width, height } = PNG.sync.read(picture);
  return jsqr.default(new Uint8ClampedArray(data), width, height)?.data ?? null;
}

/** The link with the address that others reach, which is what the wall shows. */
async function reachableLink(link) {
  const { addresses } = await (await fetch(`${site.url}share.json`)).json();
  return addresses.length ? addresses[0] + new URL(link).hash : link;
}

/** Hands in and resolves to the milliseconds from the server's answer until `card` is seen. */
async function handedInAndSeen(page, card) {
  let acknowledged = 0;
  const note = (response) => {
    if (/\/posts\//.test(response.url()) && response.request().method() === 'PUT') acknowledged = performance.now();
  };
  page.on('response', note);
  await handIn(page);
  await card.waitFor();
  const seen = performance.now();
  await sentence(page, 'is on the wall.');
  page.off('response', note);
  assert.ok(acknowledged > 0);
  return Math.max(0, seen - acknowledged);
}

test('five pages play a lesson from the words to the end of the class', async (t) => {
  const teacher = await openClass();
  const pupils = [await open(), await open(), await open(kPhone)];
  const all = [teacher, ...pupils];
  t.after(() => Promise.all(all.map(({ close }) => close())));
  const [one, two, phone] = pupils.map(({ page }) => page);
  const desk = teacher.page;

  const evil = `<img src=x onerror="document.title='hit'">`;
  let screen;

  await t.test('two come with the words, one by the QR code', async () => {
    const words = await wordsOn(desk);
    assert.match(words, /^[a-z]+( [a-z]+){3}$/);
    await joinAs(one, words, 'Cat');
    await joinAs(two, words.toUpperCase(), 'Cat');
    await phone.evaluate((link) => (location.href = link), await linkOf(desk));
    await phone.getByRole('dialog').getByRole('button', { name: 'Turtle' }).click();
    await strip(phone).getByText('Turtle 3').waitFor();
    assert.equal(new URL(phone.url()).hash, '');
    await sentence(desk, '3 animals are here');
  });

  await t.test('a screen for the projector takes no part', async () => {
    const link = await linkOf(desk);
    screen = await open(kSharp, link.replace('#class=', '#wall='));
    all.push(screen);
    await wall(screen.page).getByText('3 animals are here').waitFor();
    assert.equal(await strip(screen.page).isVisible(), false);
    // It does not know the words, so it says nothing of them.
    assert.equal(await wall(screen.page).getByText('four words').count(), 0);
    assert.equal(await codeOn(screen.page), await reachableLink(link));
  });

  await t.test('everybody hands in; names are shown as they are, whatever they look like', async () => {
    await make(one, evil);
    await handIn(one);
    await cards(desk).getByText(evil).waitFor();
    await cards(screen.page).getByText(evil).waitFor();
    await make(two, 'A tube');
    const taken = await handedInAndSeen(two, cards(screen.page).getByText('A tube'));
    await cards(desk).getByText('A tube').waitFor();
    assert.equal(await cards(desk).count(), 2);
    // 1 s is promised, on a machine that does not run five pages.
    t.diagnostic(`from the acknowledged hand-in to the card on the wall: ${Math.round(taken)} ms`);
    assert.ok(taken < 5000, `${taken} ms`);
    assert.equal(
      await cards(desk)
        .locator('.turning img')
        .first()
        .evaluate((image) => image.decode().then(() => image.naturalWidth)),
      12 * 160,
    );
    for (const { page } of all) assert.notEqual(await page.title(), 'hit');
  });

  await t.test('paused: the hand-in waits, also through a reload, and then comes once', async () => {
    await button(desk, 'Pause').click();
    await sentence(phone, 'Your teacher has paused the class.');
    await make(phone, 'Late one');
    await handIn(phone);
    while ((await phone.evaluate(waitingParcels)) === 0) await phone.waitForTimeout(100);
    await reload(phone);
    await strip(phone).getByText('Turtle 3').waitFor();
    assert.equal((await state(phone)).documentName, 'Late one');
    assert.equal(await cards(desk).count(), 2);
    await button(desk, 'Go on').click();
    await cards(desk).getByText('Late one').waitFor();
    await sentence(phone, 'Late one is on the wall.');
    assert.equal(await cards(desk).count(), 3);
  });

  await t.test('without a network likewise', async () => {
    await pupils[1].context.setOffline(true);
    await run(two, 'rename-model', { name: 'Better tube' });
    await handIn(two);
    await sentence(two, 'Waiting to be sent');
    await pupils[1].context.setOffline(false);
    await cards(desk).getByText('Better tube').waitFor();
    assert.equal(await cards(desk).count(), 3);
  });

  await t.test('a screen that comes late shows all that was handed in', async () => {
    const late = await open({}, (await linkOf(desk)).replace('#class=', '#wall='));
    await cards(late.page).getByText('Better tube').waitFor();
    assert.equal(await cards(late.page).count(), 3);
    await wall(late.page).getByText('3 animals are here').waitFor();
    await late.context.close();
  });

  await t.test("hidden: on nobody's wall but the teacher's. Shown to all: large", async () => {
    await cards(desk).getByText('Late one').click();
    await button(desk, 'Hide').click();
    await cards(desk).getByText('Hidden', { exact: true }).waitFor();
    await cards(screen.page).getByText('Late one').waitFor({ state: 'detached' });
    await cards(desk).getByText('Better tube').click();
    await button(desk, 'Show to all').click();
    await screen.page.locator('.wall-spot-name', { hasText: 'Better tube' }).waitFor();
    await sentence(one, 'Look: your teacher shows a model on the wall.');
  });

  await t.test('handed back with a mark: its maker alone sees it, once', async () => {
    await cards(desk).getByText(evil).click();
    await desk.locator('.class-picture img').click({ position: { x: 40, y: 60 } });
    await desk.getByLabel('Press the picture').fill('Make it longer <b>here</b>');
    await button(desk, 'Hand it back').click();
    const back = one.getByRole('dialog', { name: 'Your teacher handed your model back' });
    await back.getByText('Make it longer <b>here</b>').waitFor();
    assert.ok(await back.locator('.class-mark').isVisible());
    await button(one, 'Go on').click();
    assert.equal(await two.getByRole('dialog').count(), 0);
    await reload(one);
    await strip(one).getByText('Cat 1').waitFor();
    await idle(one);
    assert.equal(await one.getByRole('dialog').count(), 0);
  });

  await t.test('a remix says whose model it was', async () => {
    await strip(one).getByRole('button', { name: 'Our wall' }).click();
    await cards(one).getByText('Better tube').click();
    await button(one, 'Remix').click();
    await wall(one).waitFor({ state: 'hidden' });
    await idle(one);
    assert.equal((await state(one)).documentName, 'Better tube');
    await handIn(one);
    await cards(desk).getByText('made from the model of Cat 2').waitFor();
  });

  await t.test('all as one file; the sheet of stickers', async () => {
    const { name, bytes } = await downloaded(desk, () => button(desk, 'Download all').click());
    assert.equal(name, 'class.zip');
    const files = Object.entries(unzipSync(new Uint8Array(bytes)));
    const ending = (end) => files.filter(([file]) => file.endsWith(end));
    for (const [end, magic] of [
      ['model.glb', 'glTF'],
      ['model.3mf', 'PK'],
      ['picture.png', '\x89PNG'],
    ]) {
      assert.equal(ending(end).length, 2, end);
      for (const [file, content] of ending(end))
        assert.ok(Buffer.from(content).toString('latin1').startsWith(magic), file);
    }
    assert.ok(
      files.every(([file]) => !/[<>"]|\.\./.test(file)),
      files.map(([file]) => file).join(),
    );
    await desk.evaluate(() => (window.print = () => (window.printed = document.querySelectorAll('.sticker').length)));
    await button(desk, 'Print stickers').click();
    await desk.waitForFunction(() => window.printed === 2);
    await desk.evaluate(() => window.dispatchEvent(new Event('afterprint')));
  });

  await t.test('everybody begins with what the teacher has open', async () => {
    await button(desk, 'Back to the model').click();
    await make(desk, 'The start');
    await strip(desk).getByRole('button', { name: 'Our wall' }).click();
    await button(desk, 'Start everybody').click();
    await button(two, 'Begin with it').click();
    await two.waitForFunction(() => window.spineloft.state().documentName === 'The start');
  });

  await t.test('… or with a picture alone, or with a model of the wall', async () => {
    await button(desk, 'Back to the model').click();
    await done(desk, 'new-model');
    await openPicture(desk, tube.png, 'only.png');
    await strip(desk).getByRole('button', { name: 'Our wall' }).click();
    await button(desk, 'Start everybody').click();
    await button(two, 'Begin with it').click();
    await two.waitForFunction(() => window.spineloft.state().parts.length === 0);
    await idle(two);
    const alone = await state(two);
    assert.deepEqual([alone.pictures, alone.parts.length], [1, 0]);
    assert.deepEqual([alone.picture.width, alone.picture.height], [120, 90]);
    await cards(desk).getByText('Late one').click();
    await button(desk, 'Start everybody with it').click();
    await button(two, 'Begin with it').click();
    await two.waitForFunction(() => window.spineloft.state().documentName === 'Late one');
    await idle(two);
    assert.equal((await state(two)).parts.length, 1);
  });

  await t.test('the end: everybody is told, and the server has nothing left', async () => {
    await button(desk, 'End the class').click();
    await desk.getByRole('dialog').getByRole('button', { name: 'End the class' }).click();
    for (const page of [one, two, phone]) await sentence(page, 'This class is over.');
    assert.deepEqual(await store.totals(), { models: 0, rooms: 0, posts: 0, bytes: 0 });
    assert.equal((await state(two)).documentName, 'Late one');
    await reload(two);
    assert.equal(await strip(two).isVisible(), false);
  });

  for (const opened of all) {
    const known =
      /net::ERR_INTERNET_DISCONNECTED|status (423|404)|the server responded with a status of (423|404)|request failed/;
    assert.deepEqual(
      opened.troubles.filter((trouble) => !known.test(trouble)),
      [],
    );
  }
  assert.deepEqual(said, []);
});

const kNothingSecure = [false, 'undefined', 'undefined', 'undefined'];
const secureThings = () => [
  isSecureContext,
  typeof crypto.subtle,
  typeof SharedArrayBuffer,
  typeof navigator.clipboard,
];

/** What is pasted in the page: where it has no clipboard of its own, too. */
async function pasted(page) {
  await page.evaluate(() => {
    const field = document.createElement('textarea');
    field.id = 'pasted';
    (document.querySelector('dialog[open]') ?? document.body).append(field);
    field.focus();
  });
  await page.keyboard.press('Control+V');
  const text = await page.locator('#pasted').inputValue();
  await page.locator('#pasted').evaluate((field) => field.remove());
  return text;
}

const skip = plainAddress ? false : 'no network';
test(
  'on a plain http address a class works like any other, and says what https would make better',
  { skip },
  async (t) => {
    const address = site.url.replace('localhost', plainAddress);
    const teacher = await openClass(kSharp, address);
    t.after(teacher.close);
    const pupil = await open({}, address);
    t.after(pupil.close);
    const desk = teacher.page;
    const { page } = pupil;

    await t.test('nothing that https gives is there; the code on the wall leads to the class', async () => {
      for (const one of [desk, page]) assert.deepEqual(await one.evaluate(secureThings), kNothingSecure);
      await button(desk, 'Projector view').click();
      const link = await linkOf(desk);
      assert.equal(await codeOn(desk), link);
      assert.ok(link.startsWith(address));
      await button(desk, "Teacher's view").click();
    });

    await t.test('a pupil reads what https would make better, joins, hands in and comes back', async () => {
      await joinAs(page, await wordsOn(desk), 'Snail', (dialog) => dialog.getByText(kPlainNote).waitFor());
      const photo = { name: 'photo.png', mimeType: 'image/png', buffer: tube.png };
      await page.locator('#file-picker').setInputFiles(photo);
      await waitForPicture(page);
      await run(page, 'draw-spine', { stroke: tube.middle });
      await run(page, 'rename-model', { name: 'Plain' });
      await idle(page);
      await handIn(page);
      await cards(desk).getByText('Plain').waitFor();
      await reload(page);
      await strip(page).getByText('Snail 1').waitFor();
      const { documentName, pictures, parts } = await state(page);
      assert.deepEqual([documentName, pictures, parts.length], ['Plain', 1, 1]);
    });

    await t.test('a hand-in waits while there is no network', async () => {
      await pupil.context.setOffline(true);
      await run(page, 'rename-model', { name: 'Later' });
      await handIn(page);
      await sentence(page, 'Waiting to be sent');
      assert.equal(await cards(desk).getByText('Later').count(), 0);
      await pupil.context.setOffline(false);
      await cards(desk).getByText('Later').waitFor();
      assert.equal(await cards(desk).count(), 1);
    });

    await t.test('all as one file', async () => {
      const { name, bytes } = await downloaded(desk, () => button(desk, 'Download all').click());
      assert.equal(name, 'class.zip');
      const files = Object.keys(unzipSync(new Uint8Array(bytes))).map((file) => file.split('/').at(-1));
      for (const file of ['model.glb', 'model.3mf', 'picture.png']) assert.ok(files.includes(file), files.join());
    });

    await t.test('links are copied; a short link is stored', async () => {
      await button(page, 'Save').click();
      await page.getByRole('menuitem', { name: /^Share/ }).click();
      await button(page, 'Copy link').click();
      await sentence(page, 'The link is copied.');
      const url = await page.getByRole('textbox', { name: 'Link', exact: true }).inputValue();
      assert.ok(url.startsWith(`${address}view.html#m=`), url);
      assert.equal(await pasted(page), url);
      await page.keyboard.press('Escape');
      const link = await page.evaluate(() => window.spineloft.shareLink({ stored: true }));
      assert.ok(link.stored && link.url.startsWith(address), link.url);
    });
  },
);

test('a short link opens the model with its photo in another browser until it is taken back', async (t) => {
  const maker = await open();
  t.after(maker.close);
  const large = tubePicture();
  await openWithPart(maker.page, large.png, large.middle);
  await run(maker.page, 'rename-model', { name: 'A stored tube' });
  await idle(maker.page);
  await button(maker.page, 'Save').click();
  await maker.page.getByRole('menuitem', { name: /^Share/ }).click();
  // A link that is too long names the short one, where there is a server.
  const withPhotos = maker.page.getByRole('checkbox', { name: 'With small copies of the photos' });
  await withPhotos.check();
  await maker.page.getByText('Make a short link below').waitFor();
  await withPhotos.uncheck();
  await button(maker.page, 'Make a short link').click();
  const url = await maker.page.getByRole('textbox', { name: 'Short link' }).inputValue();
  assert.match(url, /view\.html#stored=/);
  assert.ok(url.length < 120, url);
  // It is looked at first, with its photo and its name; nothing of the visitor's own is touched.
  const visitor = await openPage(kit.browser, url, { viewport: kWindow, deviceScaleFactor: 0.5 });
  t.after(visitor.close);
  await visitor.page.locator('body[data-state=shown]').waitFor({ timeout: 60_000 });
  assert.equal(await visitor.page.locator('#name').innerText(), 'A stored tube');
  await visitor.page.getByRole('link', { name: 'Make it mine' }).click();
  await visitor.page.waitForFunction(() => window.spineloft?.state().documentName === 'A stored tube');
  await idle(visitor.page);
  const { pictures, parts } = await state(visitor.page);
  assert.deepEqual([pictures, parts.length], [1, 1]);
  assert.equal(new URL(visitor.page.url()).hash, '');
  // The server has neither name nor picture.
  const [id] = url.split('=')[1].split('.');
  const kept = Buffer.from(await (await fetch(`${site.url}share/v1/models/${id}`)).arrayBuffer());
  for (const text of ['A stored tube', '\r\n\x1a\n\0\0\0\rIHDR', 'spineloft']) assert.ok(!kept.includes(text), text);
  await button(maker.page, 'Take it back').click();
  await sentence(maker.page, 'nobody can open it any more');
  await visitor.page.evaluate((link) => (location.href = link), url);
  await sentence(visitor.page, 'It has expired or was taken back.');
  const code = await maker.page.evaluate(() =>
    window.spineloft.takeBackLink('nothing').then(
      () => null,
      (failure) => failure.code,
    ),
  );
  assert.equal(code, 'NotThere');
});

test('a site without a server offers neither classes nor short links, and says so to programs', () =>
  onPage(kit, { alone: true }, async (page) => {
    assert.equal(await button(page, 'Join a class').isVisible(), false);
    await openWithPart(page, tube.png, tube.middle);
    await button(page, 'Save').click();
    await page.getByRole('menuitem', { name: /^Share/ }).click();
    await page.getByRole('dialog', { name: 'Share' }).getByText('The whole model is in this link').waitFor();
    assert.equal(await button(page, 'Make a short link').count(), 0);
    // The small copy of a small picture fits: it goes along by itself, also in the QR code.
    assert.ok(await page.getByRole('checkbox', { name: 'With small copies of the photos' }).isChecked());
    assert.ok(await page.getByRole('img', { name: 'QR code of the link' }).isVisible());
    const code = await page.evaluate(() =>
      window.spineloft.shareLink({ stored: true }).then(
        () => null,
        (failure) => failure.code,
      ),
    );
    assert.equal(code, 'NoServer');
  }));
