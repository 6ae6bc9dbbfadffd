// A model in a link, on stickers, in a picture and on another page (view.test.mjs: what the viewer does with it). What the text keeps is said by
// tests/unit/io/share_text_test.cpp.
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import test from 'node:test';
import jsqr from 'jsqr';
import { PNG } from 'pngjs';
import {
  difference,
  done,
  downloaded,
  dropFiles,
  exported,
  idle,
  kSharp,
  onPage,
  openWithPart,
  run,
  state,
  toastText,
  useSite,
  waitForPicture,
} from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();

/** Opens the address `link` in a page of its own, as a visitor does, and makes the model hers. */
async function visit(page, link, work, look = async () => undefined) {
  const other = await page.context().newPage();
  try {
    await other.goto(link);
    await look(other);
    await other.getByRole('link', { name: 'Make it mine' }).click({ timeout: 120_000 });
    await other.waitForFunction(() => window.spineloft?.state().parts.length > 0, null, { timeout: 120_000 });
    await idle(other);
    await work(other);
  } finally {
    await other.close();
  }
}

const linkOf = (page) => page.evaluate(() => window.spineloft.shareLink());

/** Rib ends of the first part, in order. */
const ends = async (page) => (await state(page)).parts[0].ribs.flatMap(({ left, right }) => [left, right]);

test('Share shows a link and a QR code; who opens the link gets the model as one of her own', () =>
  onPage(kit, { alone: true, permissions: ['clipboard-read', 'clipboard-write'] }, async (page) => {
    const tube = tubePicture();
    await openWithPart(page, tube.png, tube.middle);
    const before = await ends(page);
    await run(page, 'rename-model', { name: 'A tube' });
    await page.getByRole('button', { name: 'Save', exact: true }).click();
    await page.getByRole('menuitem', { name: /^Share/ }).click();
    const dialog = page.getByRole('dialog', { name: 'Share' });
    const link = await dialog.getByRole('textbox', { name: 'Link' }).inputValue();
    assert.equal(link, (await linkOf(page)).url);
    assert.ok(await dialog.getByRole('img', { name: 'QR code of the link' }).isVisible());
    assert.ok(await dialog.getByText('Photos stay here').isVisible());
    await dialog.getByRole('button', { name: 'Copy link' }).click();
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), link);
    await visit(page, link, async (other) => {
      const now = await state(other);
      assert.equal(now.documentName, 'A tube');
      assert.equal(now.parts.length, 1);
      const after = await ends(other);
      assert.equal(after.length, before.length);
      const off = after.map(([x, y], i) => Math.hypot(x - before[i][0], y - before[i][1]));
      assert.ok(Math.max(...off) < 1, `${off.map((d) => d.toFixed(1))}`);
      assert.equal(new URL(other.url()).hash, '');
      // It is kept beside the one that was shared, and loading the page again does not open it a second time.
      await other.reload();
      await other.evaluate(() => window.spineloft.ready);
      await idle(other);
      assert.equal((await other.evaluate(() => window.spineloft.models())).length, 2);
    });
  }));

test('with small copies of its photos a link is long, and shows them: in the viewer, and to who makes it hers', () =>
  onPage(kit, { alone: true, draws: true, reducedMotion: 'reduce' }, async (page) => {
    const dialog = await openShare(page);
    const field = dialog.getByRole('textbox', { name: 'Link' });
    const code = dialog.getByRole('img', { name: 'QR code of the link' });
    const short = await field.inputValue();
    const choice = dialog.getByRole('checkbox', { name: 'With small copies of the photos' });
    assert.equal(await choice.isChecked(), false);
    await choice.check();
    const long = await field.inputValue();
    const asked = await page.evaluate(() => window.spineloft.shareLink({ photos: true }));
    assert.deepEqual([asked.url, asked.photosLeft], [long, 0]);
    assert.ok(asked.characters > 1900, `${asked.characters}`);
    assert.ok(await code.isHidden());
    assert.ok(await dialog.getByText('Photos stay here').isHidden());
    const said = await dialog.locator('.share-long').innerText();
    assert.match(said, /characters long, and some programs cut it off/);
    assert.match(said, /Without the photos it is short/);
    assert.match(said, /Or send the picture or the model file/);
    await choice.uncheck();
    assert.equal(await field.inputValue(), short);
    assert.ok(await code.isVisible());
    const before = await ends(page);
    const picture = PNG.sync.read(await exported(page, 'png'));
    // Both colours of the photo stand in the viewer, one in that of a link without it.
    const bands = async (viewer) => {
      await viewer.locator('body[data-state=shown]').waitFor({ timeout: 120_000 });
      await viewer.waitForTimeout(1000); // its first frame
      const { data } = PNG.sync.read(await viewer.locator('#canvas').screenshot());
      let blue = 0,
        green = 0;
      for (let i = 0; i < data.length; i += 4) {
        blue += data[i + 2] > data[i + 1] + 30 ? 1 : 0;
        green += data[i + 1] > data[i + 2] + 6 ? 1 : 0;
      }
      return Math.min(blue, green) / Math.max(blue, green, 1);
    };
    const shares = [];
    for (const link of [long, short]) {
      await visit(
        page,
        link,
        async (other) => {
          const { parts } = await state(other);
          assert.equal(parts[0].textured, link === long);
          const after = await ends(other);
          const off = after.map(([x, y], i) => Math.hypot(x - before[i][0], y - before[i][1]));
          assert.ok(Math.max(...off) < 1, `${off.map((d) => d.toFixed(1))}`);
          shares.push(difference(picture, PNG.sync.read(await exported(other, 'png'))));
        },
        async (viewer) => shares.push(await bands(viewer)),
      );
    }
    const [bandsLong, offLong, bandsShort, offShort] = shares;
    assert.ok(bandsLong > 0.2 && bandsShort < 0.05, `${shares}`);
    // Of both the outline is off by a fraction of a pixel.
    assert.ok(offLong < offShort / 3, `${shares}`);
  }));

test('Send hands link and picture to the system where it takes them; what it refuses is saved, and closing it is no error', () =>
  onPage(kit, { alone: true, draws: true, reducedMotion: 'reduce' }, async (page) => {
    // Headless browsers have no share sheet.
    await page.evaluate(() => {
      window.sent = [];
      navigator.canShare = ({ files }) => files.length === 1;
      navigator.share = async (data) => {
        window.sent.push(data);
        if (window.refusal) throw new DOMException('no', window.refusal);
      };
    });
    const dialog = await openShare(page);
    const { url } = await linkOf(page);
    await dialog.getByRole('button', { name: 'Send' }).click();
    assert.deepEqual(await page.evaluate(() => window.sent.pop()), { url });
    const press = () => dialog.getByRole('button', { name: 'Picture' }).click();
    const sentFile = async () => {
      await page.waitForFunction(() => window.sent.length > 0);
      return page.evaluate(async () => {
        const { name, type, size } = window.sent.pop().files[0];
        return { name, type, size };
      });
    };
    await press();
    const { name, type, size } = await sentFile();
    assert.deepEqual([name, type, size], ['tube.png', 'image/png', (await exported(page, 'png')).length]);
    let saved = 0;
    page.on('download', () => (saved += 1));
    await page.evaluate(() => (window.refusal = 'AbortError'));
    await press();
    await sentFile();
    await dialog.getByRole('button', { name: 'Send' }).click();
    assert.equal(saved, 0);
    await page.evaluate(() => (window.refusal = 'NotAllowedError'));
    const file = await downloaded(page, press);
    assert.equal(file.bytes.length, size);
    assert.equal(saved, 1);
  }));

test('a text that is none opens nothing, and the model that is open stays', () =>
  onPage(kit, { alone: true }, async (page) => {
    const tube = tubePicture();
    await openWithPart(page, tube.png, tube.middle);
    const before = await page.evaluate(() => window.spineloft.history());
    const { text } = await linkOf(page);
    for (const [wrong, code] of [
      ['hello', 'NoProjectInside'],
      [text.slice(0, -5), 'LinkCut'],
      [`${text}A`, 'LinkAltered'],
      [`9${text.slice(1)}`, 'ProjectTooNew'],
    ]) {
      const refused = await page.evaluate(
        (one) =>
          window.spineloft.openShareText(one).then(
            () => null,
            (error) => error.code,
          ),
        wrong,
      );
      assert.equal(refused, code, wrong);
      await idle(page);
      assert.equal(await page.evaluate(() => window.spineloft.history()), before);
    }
  }));

/** Opens the dialog Share of a model with one part. */
async function openShare(page) {
  const tube = tubePicture();
  await openWithPart(page, tube.png, tube.middle);
  await run(page, 'share-model');
  return page.getByRole('dialog', { name: 'Share' });
}

/** What a camera reads in a picture of the page. */
function readCode({ data, width, height }) {
  return jsqr.default(new Uint8ClampedArray(data), width, height)?.data ?? null;
}

test('the QR code on the screen and every sticker on the printed sheet are read as the link', () =>
  onPage(kit, { alone: true, ...kSharp }, async (page) => {
    const dialog = await openShare(page);
    const { url } = await linkOf(page);
    const code = dialog.getByRole('img', { name: 'QR code of the link' });
    await code.scrollIntoViewIfNeeded();
    assert.equal(readCode(PNG.sync.read(await code.screenshot())), url);
    await page.evaluate(() => (window.print = () => undefined));
    await dialog.getByRole('button', { name: 'Stickers' }).click();
    await page.emulateMedia({ media: 'print' });
    const stickers = page.locator('.sticker');
    assert.ok((await stickers.count()) >= 6, `${await stickers.count()} stickers`);
    assert.ok(await page.locator('#bar').isHidden());
    for (const sticker of [stickers.first(), stickers.last()])
      assert.equal(readCode(PNG.sync.read(await sticker.screenshot())), url);
    // On paper the sheet is one page.
    const pdf = await page.pdf({ format: 'A4', preferCSSPageSize: true });
    assert.equal([...pdf.toString('latin1').matchAll(/\/Type\s*\/Page\b/g)].length, 1);
    await page.evaluate(() => window.dispatchEvent(new Event('afterprint')));
    assert.equal(await stickers.count(), 0);
  }));

test('the picture has the model inside: dropped on the page it opens with its photo; without the model it is a picture', () =>
  onPage(kit, { alone: true, draws: true, reducedMotion: 'reduce' }, async (page) => {
    const dialog = await openShare(page);
    const before = await ends(page);
    const { name, bytes } = await downloaded(page, () => dialog.getByRole('button', { name: 'Picture' }).click());
    assert.match(name, /\.png$/);
    const { width, height } = PNG.sync.read(bytes);
    assert.deepEqual([width, height], [1024, 1024]);
    assert.deepEqual(await exported(page, 'png'), bytes);
    await page.keyboard.press('Escape');
    await done(page, 'new-model');
    await dropFiles(page, [kit.file('model.png', bytes)]);
    await page.waitForFunction(() => window.spineloft.state().parts.length === 1);
    await idle(page);
    assert.deepEqual(await ends(page), before);
    assert.equal((await state(page)).pictureList.length, 1);
    // Programs that write a picture anew leave out what they do not know.
    const plain = PNG.sync.write(PNG.sync.read(bytes));
    await done(page, 'new-model');
    await dropFiles(page, [kit.file('plain.png', plain)]);
    await waitForPicture(page);
    assert.equal((await state(page)).parts.length, 0);
    // One that was spoilt on its way says so.
    const spoilt = Buffer.from(bytes);
    spoilt[spoilt.indexOf('spLf') + 40] ^= 1;
    await dropFiles(page, [kit.file('spoilt.png', spoilt)]);
    assert.match(await toastText(page), /model file is damaged.*changed on its way/);
  }));

test('the HTML for another page has the viewer with its poster; a long link offers picture and file instead of a code', (t) =>
  onPage(kit, { alone: true, draws: true, reducedMotion: 'reduce' }, async (page) => {
    const dialog = await openShare(page);
    await dialog.getByText('On your own page').click();
    // The field is filled once the fold has opened.
    await page.waitForFunction(() => document.querySelector('#share-snippet').value !== '');
    const html = await dialog.getByRole('textbox', { name: 'Put this into the HTML of the page' }).inputValue();
    const [, address] = /^<iframe src="([^"]+)"/.exec(html) ?? [];
    const { url } = await linkOf(page);
    assert.ok(address.replaceAll('&#38;', '&').startsWith(`${url}&poster=data:image/webp;base64,`), address);
    // What is copied shows the model in the page of another site, when it is asked for.
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await dialog.getByRole('button', { name: 'Copy', exact: true }).click();
    assert.match(await toastText(page, 'status'), /The HTML is copied/);
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    assert.equal(copied, html);
    // A server of its own: Chromium lets no page that a test makes up ask for something on this machine.
    const server = createServer((request, response) => {
      response.setHeader('Content-Type', 'text/html');
      response.end(`<!doctype html><title>A class</title><link rel="icon" href="data:,"><p>Ours:</p>${copied}`);
    });
    t.after(() => server.close());
    await new Promise((resolve) => server.listen(0, 'localhost', resolve));
    const host = await page.context().newPage();
    await host.goto(`http://localhost:${server.address().port}/`);
    assert.notEqual(new URL(host.url()).origin, new URL(url).origin);
    const frame = host.frameLocator('iframe');
    await frame.getByRole('button', { name: 'Show the model' }).click();
    await frame.locator('body[data-state=shown]').waitFor({ timeout: 120_000 });
    assert.equal(await frame.locator('#name').innerText(), (await state(page)).documentName);
    await host.close();
    await page.keyboard.press('Escape');
    // Thousands of points on paper make a long one.
    await done(page, 'new-sketch');
    const { width } = (await state(page)).picture;
    for (let i = 0; i < 12; ++i) {
      const stroke = Array.from({ length: 600 }, (_, k) => [
        100 + ((k * 7919 + i * 104729) % (width - 200)),
        100 + ((k * 6007 + i * 7001) % 400),
      ]);
      await run(page, 'draw-on-sketch', { stroke });
    }
    await idle(page);
    await run(page, 'share-model');
    assert.match(await dialog.innerText(), /characters long, and some programs cut it off. Or send the picture/);
    assert.equal(await dialog.getByRole('img', { name: 'QR code of the link' }).count(), 0);
    assert.ok(await dialog.getByRole('button', { name: 'Save model' }).isVisible());
    assert.ok(await dialog.getByRole('button', { name: 'Picture' }).isVisible());
  }));
