// What a photo's file says besides its pixels stays with the photo: where it was taken is in no file that the page writes.
import assert from 'node:assert/strict';
import test from 'node:test';
import { unzipSync } from 'three/addons/libs/fflate.module.js';
import { downloaded, exported, onPage, openWithPart, run, state, useSite } from './support/page.mjs';
import { tubePicture, withGps } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();

/** The tube as a JPEG, written by the browser. */
async function tubeJpeg(page) {
  const text = await page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))]));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    canvas.getContext('2d').drawImage(bitmap, 0, 0);
    const bytes = new Uint8Array(
      await (await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.9 })).arrayBuffer(),
    );
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  }, tube.png.toString('base64'));
  return Buffer.from(text, 'base64');
}

/** A file, and what is packed in it where it is a ZIP. */
function unpacked(name, bytes) {
  const inner =
    bytes.subarray(0, 2).toString('latin1') === 'PK' ? Object.entries(unzipSync(new Uint8Array(bytes))) : [];
  return [[name, bytes], ...inner.map(([file, content]) => [`${name}: ${file}`, Buffer.from(content)])];
}

test('where a photo was taken, by its EXIF block, is in no file that is saved', () =>
  onPage(kit, { alone: true }, async (page) => {
    const { jpeg, places } = withGps(await tubeJpeg(page));
    await openWithPart(page, jpeg, tube.middle, 'IMG_0001.jpg');
    const { picture } = await state(page);
    assert.deepEqual([picture.width, picture.height], [tube.width, tube.height]);
    assert.equal((await state(page)).parts.length, 1);
    const files = [];
    for (const format of ['glb', 'obj', 'zip', 'stl', '3mf', 'spineloft'])
      files.push(...unpacked(format, await exported(page, format)));
    for (const id of ['save-picture', 'save-turntable']) {
      const { name, bytes } = await downloaded(page, () => run(page, id));
      files.push(...unpacked(name, bytes));
    }
    // Packed ones were looked into, and pictures are among them.
    assert.ok(files.length >= 12, files.map(([name]) => name).join(', '));
    for (const [what, bytes] of Object.entries(places)) {
      assert.ok(jpeg.includes(bytes), `${what} is in the photo`);
      for (const [name, content] of files) assert.ok(!content.includes(bytes), `${what} is in ${name}`);
    }
  }));
