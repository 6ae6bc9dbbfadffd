// A model in a link: by the command, opened in another page, and links that are broken. What the text keeps is said by
// tests/unit/io/share_text_test.cpp.
import assert from 'node:assert/strict';
import test from 'node:test';
import { idle, onPage, openWithPart, run, state, useSite } from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();

/** Opens the address `link` of this page in a page of its own, as a visitor does. */
async function visit(page, link, work) {
  const other = await page.context().newPage();
  try {
    await other.goto(link);
    await other.evaluate(() => window.spineloft.ready);
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

test('a link that is cut off, altered or none is said in a sentence, and the model that is open stays', () =>
  onPage(kit, { alone: true }, async (page) => {
    const tube = tubePicture();
    await openWithPart(page, tube.png, tube.middle);
    const before = await page.evaluate(() => window.spineloft.history());
    const { url } = await linkOf(page);
    for (const [link, sentence] of [
      [url.slice(0, -5), /end of that link is missing/],
      [url.slice(0, -5) + '-----', /changed on its way/],
      [`${url.slice(0, url.indexOf('#'))}#m=?`, /no model of SpineLoft in that link/],
    ]) {
      await page.evaluate((address) => (location.href = address), link);
      await page.getByText(sentence).first().waitFor();
      await idle(page);
      assert.equal(await page.evaluate(() => window.spineloft.history()), before);
    }
    const refused = await page.evaluate(() =>
      window.spineloft.openShareText('hello').then(
        () => null,
        ({ code }) => code,
      ),
    );
    assert.equal(refused, 'NoProjectInside');
  }));
