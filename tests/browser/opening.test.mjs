// Every way a picture comes in, and every file that must be refused in plain words.
import assert from 'node:assert/strict';
import test from 'node:test';
import { validated } from './support/model_files.mjs';
import {
  done,
  dropFiles,
  exported,
  idle,
  onPage,
  openPicture,
  openWithPart,
  pictureSize,
  state,
  toastText,
  useSite,
  waitForPicture,
} from './support/page.mjs';
import { enlarged, greyPng, paintedPng, samples, tubePicture, withExifOrientation } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();

test('a picture dropped from the system opens', () =>
  onPage(kit, {}, async (page) => {
    await dropFiles(page, [kit.file('tube.png', tube.png)]);
    await waitForPicture(page);
    assert.deepEqual(await pictureSize(page), { width: tube.width, height: tube.height });
    assert.equal(await page.locator('#start').isVisible(), false);
    assert.equal(await page.locator('#status').innerText(), 'tube.png is open.');
    await done(page, 'draw-spine', { stroke: tube.middle });
    // What was said of the opening is over with the first step.
    assert.match(await page.locator('#status').innerText(), /^Part 1 is made\./);
  }));

test('a picture chosen in the file dialog opens', () =>
  onPage(kit, {}, async (page) => {
    const chooser = page.waitForEvent('filechooser');
    await page.getByRole('button', { name: 'Choose a picture' }).click();
    await (await chooser).setFiles({ name: 'tube.png', mimeType: 'image/png', buffer: tube.png });
    await waitForPicture(page);
    assert.deepEqual(await pictureSize(page), { width: tube.width, height: tube.height });
  }));

test('Ctrl+O opens the file dialog too', () =>
  onPage(kit, {}, async (page) => {
    const chooser = page.waitForEvent('filechooser');
    await state(page); // the driver listens from here on
    await page.keyboard.press('Control+o');
    await (await chooser).setFiles({ name: 'tube.png', mimeType: 'image/png', buffer: tube.png });
    await waitForPicture(page);
  }));

test('a picture pasted from the clipboard opens', () =>
  onPage(kit, { alone: true, permissions: ['clipboard-read', 'clipboard-write'] }, async (page) => {
    await page.evaluate(async (data) => {
      const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
      await navigator.clipboard.write([new ClipboardItem({ 'image/png': new Blob([bytes], { type: 'image/png' }) })]);
    }, tube.png.toString('base64'));
    await page.keyboard.press('Control+v');
    await waitForPicture(page);
    assert.deepEqual(await pictureSize(page), { width: tube.width, height: tube.height });
  }));

for (const [index, sample] of samples().entries()) {
  test(`the sample "${sample.title}" opens from the start page, and its line makes a part and a valid GLB`, () =>
    onPage(kit, {}, async (page) => {
      const image = page.locator('.sample img').nth(index);
      await image.scrollIntoViewIfNeeded();
      // A small copy of the whole picture.
      const [width, height] = await image.evaluate(async (element) => {
        await element.decode();
        return [element.naturalWidth, element.naturalHeight];
      });
      assert.ok(width <= 420 && Math.abs((width * sample.height) / sample.width - height) < 1, `${width} by ${height}`);
      await page.locator('.sample-open').nth(index).click();
      await waitForPicture(page);
      assert.deepEqual(await pictureSize(page), { width: sample.width, height: sample.height });
      await done(page, 'draw-spine', { stroke: sample.spine });
      const { parts } = await state(page);
      assert.equal(parts.length, 1);
      assert.ok(parts[0].ribs.length >= 8 && parts[0].triangles > 100, JSON.stringify(parts[0]).slice(0, 200));
      assert.equal(await page.locator('#hint').isVisible(), false);
      await validated(await exported(page, 'glb'));
    }));
}

test('the samples show who made them and under which licence', () =>
  onPage(kit, {}, async (page) => {
    for (const [index, sample] of samples().entries()) {
      const credit = page.locator('.sample-credit').nth(index);
      assert.equal(await credit.innerText(), `${sample.credit} · ${sample.licence}`);
      assert.equal(await credit.locator('a').nth(1).getAttribute('href'), sample.licenceUrl);
    }
  }));

test('the EXIF turn is applied: a lying photo stands up', () =>
  onPage(kit, {}, async (page) => {
    const jpeg = Buffer.from(
      await page.evaluate(async (data) => {
        const bitmap = await createImageBitmap(
          await (await new Response(Uint8Array.from(atob(data), (c) => c.charCodeAt(0)))).blob(),
        );
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [bitmap.width, bitmap.height];
        canvas.getContext('2d').drawImage(bitmap, 0, 0);
        return canvas.toDataURL('image/jpeg', 0.9).split(',')[1];
      }, tube.png.toString('base64')),
      'base64',
    );
    await openPicture(page, jpeg, 'lying.jpg');
    assert.deepEqual(await pictureSize(page), { width: 480, height: 360 });
    await openPicture(page, withExifOrientation(jpeg, 6), 'standing.jpg');
    assert.deepEqual(await pictureSize(page), { width: 360, height: 480 });
    // The tube's middle (x, y) is now at (height − 1 − y, x).
    await done(page, 'draw-spine', { stroke: tube.middle.map(([x, y]) => [359 - y, x]) });
    const [part] = (await state(page)).parts;
    const sides = part.ribs
      .slice(3, -3)
      .map((rib) => Math.hypot(rib.left[0] - rib.right[0], rib.left[1] - rib.right[1]));
    const mean = sides.reduce((a, b) => a + b) / sides.length;
    assert.ok(Math.abs(mean - 2 * tube.half) < 0.2 * tube.half, `mean rib ${mean}`);
  }));

test('a large photo keeps its own coordinates', () =>
  onPage(kit, {}, async (page) => {
    const large = enlarged(tube, 7);
    await openPicture(page, large.png);
    assert.deepEqual(await pictureSize(page), { width: 3360, height: 2520 });
    await done(page, 'draw-spine', { stroke: large.middle });
    const [part] = (await state(page)).parts;
    const rib = part.ribs[Math.floor(part.ribs.length / 2)];
    const width = Math.hypot(rib.left[0] - rib.right[0], rib.left[1] - rib.right[1]);
    assert.ok(Math.abs(width - 2 * large.half) < 0.2 * large.half, `rib of ${width} picture pixels`);
  }));

test('a picture with transparent ground works like one on white', () =>
  onPage(kit, {}, async (page) => {
    const clear = tubePicture({ transparent: true });
    await openWithPart(page, clear.png, clear.middle);
    assert.equal((await state(page)).parts.length, 1);
  }));

const bad = {
  'an empty file': { bytes: Buffer.alloc(0), code: 'PictureEmpty', says: /empty/ },
  'a text file': {
    bytes: Buffer.from('Dear diary, today I drew nothing.\n'.repeat(40)),
    code: 'PictureUnreadable',
    says: /not a picture/,
  },
  'a cut-off PNG': {
    bytes: tube.png.subarray(0, Math.floor(tube.png.length / 2)),
    code: 'PictureTruncated',
    says: /damaged or cut off/,
  },
  'a PNG with rows missing inside': {
    bytes: greyPng(400, 300, 20),
    code: 'PictureTruncated',
    says: /damaged or cut off/,
  },
  'a picture of one pixel': { bytes: greyPng(1, 1), code: 'PictureTooSmall', says: /too small/ },
  'a picture of 20000 by 1': { bytes: greyPng(20000, 1), code: 'PictureTooSmall', says: /too small/ },
  'a header that declares 64250 by 64250': {
    bytes: greyPng(64250, 64250, 1),
    code: 'PictureTooLarge',
    says: /too large/,
  },
  'a header that declares 0 by 0': { bytes: greyPng(0, 0, 0), code: 'PictureEmpty', says: /./ },
};

test('files that are no good are refused in words, each in its own, and nothing is lost', () =>
  onPage(kit, {}, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    const before = await state(page);
    for (const [what, { bytes, code, says }] of Object.entries(bad)) {
      await dropFiles(page, [kit.file('bad.png', bytes)]);
      const text = await toastText(page);
      assert.match(text, says, `${what}: ${text}`);
      await page.locator('#toasts .toast-close').last().click();
      const failure = await page.evaluate(async (data) => {
        const blob = new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))]);
        return window.spineloft.openImage(blob, 'bad.png').then(
          () => null,
          (error) => ({ code: error.code, message: error.message, isError: error instanceof Error }),
        );
      }, bytes.toString('base64'));
      assert.deepEqual(failure, { code, message: text, isError: true }, what);
    }
    await idle(page);
    const after = await state(page);
    assert.deepEqual(after.parts, before.parts);
    assert.deepEqual(after.picture, before.picture);
  }));

test('a HEIC photo is refused with what to do instead', () =>
  onPage(kit, {}, async (page) => {
    const heic = Buffer.concat([
      Buffer.from([0, 0, 0, 24]),
      Buffer.from('ftypheic\0\0\0\0heicmif1', 'latin1'),
      Buffer.alloc(64),
    ]);
    await dropFiles(page, [kit.file('photo.heic', heic)]);
    assert.match(await toastText(page), /HEIC.*JPEG/);
  }));

test('dropping something that is no file says so', () =>
  onPage(kit, {}, async (page) => {
    await page.evaluate(() => {
      const data = new DataTransfer();
      data.setData('text/plain', 'hello');
      document.body.dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer: data }));
    });
    assert.match(await toastText(page), /was not a file/);
  }));

test('errors stay at least six seconds and can be dismissed', () =>
  onPage(kit, {}, async (page) => {
    await dropFiles(page, [kit.file('empty.png', Buffer.alloc(0))]);
    await toastText(page);
    await page.waitForTimeout(6000);
    assert.equal(await page.locator('#toasts [role=alert]').count(), 1);
    await page.getByRole('button', { name: 'Dismiss' }).click();
    assert.equal(await page.locator('#toasts [role=alert]').count(), 0);
  }));

test('pictures of every common format open', () =>
  onPage(kit, {}, async (page) => {
    const png = paintedPng(64, 48, (x) => [x * 4, 90, 120]);
    for (const type of ['image/png', 'image/jpeg', 'image/webp']) {
      const size = await page.evaluate(
        async ([data, kind]) => {
          const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))]));
          const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
          canvas.getContext('2d').drawImage(bitmap, 0, 0);
          await window.spineloft.openImage(await canvas.convertToBlob({ type: kind }), kind);
          const { width, height } = window.spineloft.state().picture;
          return { width, height };
        },
        [png.toString('base64'), type],
      );
      assert.deepEqual(size, { width: 64, height: 48 }, type);
    }
  }));

test('opening that takes long shows progress after a blink and can be cancelled without loss', () =>
  onPage(kit, { alone: true }, async (page) => {
    await page.evaluate(() => {
      const decode = window.createImageBitmap.bind(window);
      window.createImageBitmap = async (...values) => {
        await new Promise((resolve) => {
          window.goOn = resolve;
        });
        return decode(...values);
      };
    });
    assert.equal(await page.locator('#progress').isVisible(), false);
    await dropFiles(page, [kit.file('slow.png', tube.png)]);
    await page.locator('#progress').waitFor();
    assert.match(await page.locator('#progress').innerText(), /Opening/);
    await page.getByRole('button', { name: 'Cancel' }).click();
    await page.evaluate(() => window.goOn());
    assert.match(await toastText(page, 'status'), /Cancelled/);
    assert.equal((await state(page)).picture, null);
    await page.locator('#progress').waitFor({ state: 'hidden' });
  }));
