// The shell's pure parts, without a browser: header probe, palms, taps, sizes, wheel.
import assert from 'node:assert/strict';
import test from 'node:test';
import { build } from 'esbuild';
import { root } from '../../.ci/lib/paths.mjs';
import { greyPng, samples, tubePicture } from '../browser/support/pictures.mjs';

async function load(file) {
  const result = await build({
    absWorkingDir: root,
    entryPoints: [`web/shell/${file}`],
    bundle: true,
    write: false,
    format: 'esm',
    logLevel: 'silent',
  });
  return import(`data:text/javascript;base64,${Buffer.from(result.outputFiles[0].text).toString('base64')}`);
}
const { probePicture } = await load('probe.ts');
const { PalmFilter } = await load('palm.ts');
const { TapFinder } = await load('taps.ts');
const { sizeError, workingSize } = await load('picture.ts');
const { wheelPixels } = await load('pointer.ts');

test('the probe reads format and size of every sample and finds it whole', () => {
  for (const sample of samples()) {
    const format = sample.file.endsWith('.png') ? 'png' : 'jpeg';
    assert.deepEqual(
      probePicture(sample.bytes),
      { format, width: sample.width, height: sample.height, complete: true },
      sample.id,
    );
  }
});

test('a picture cut off anywhere is found incomplete, and no prefix makes the probe throw', () => {
  for (const bytes of [
    tubePicture({ width: 64, height: 48, half: 6 }).png,
    samples().find(({ file }) => file.endsWith('.jpg')).bytes,
  ]) {
    for (let i = 0; i < 40; ++i) {
      const probe = probePicture(bytes.subarray(0, Math.floor((bytes.length * i) / 40)));
      assert.ok(probe === null || !probe.complete);
    }
    for (let length = 0; length < 64; ++length) probePicture(bytes.subarray(0, length));
  }
});

test('random bytes behind every signature never make the probe throw', () => {
  let seed = 12345;
  const random = () => (seed = (seed * 1103515245 + 12345) & 0x7fffffff) / 0x7fffffff;
  const heads = [
    '\x89PNG\r\n\x1a\n',
    '\xff\xd8\xff\xe0',
    'GIF89a',
    'RIFF\0\0\0\0WEBPVP8X',
    'RIFF\0\0\0\0WEBPVP8L',
    'BM',
    '\0\0\0\x18ftypavif',
    '\0\0\0\x18ftypheic',
  ];
  for (let round = 0; round < 2000; ++round) {
    const head = Buffer.from(heads[round % heads.length], 'latin1');
    const body = Buffer.from(Array.from({ length: Math.floor(random() * 80) }, () => Math.floor(random() * 256)));
    const probe = probePicture(Buffer.concat([head, body]));
    assert.ok(probe === null || typeof probe.complete === 'boolean');
  }
});

test('headers of GIF, WebP and BMP tell their size', () => {
  const gif = Buffer.concat([
    Buffer.from('GIF89a', 'latin1'),
    Buffer.from([0x2c, 1, 0xc8, 0, 0, 0, 0]),
    Buffer.alloc(4),
    Buffer.from([0x3b]),
  ]);
  assert.deepEqual(probePicture(gif), { format: 'gif', width: 300, height: 200, complete: true });
  const webp = Buffer.alloc(30);
  webp.write('RIFF', 0, 'latin1');
  webp.writeUInt32LE(22, 4);
  webp.write('WEBPVP8X', 8, 'latin1');
  webp.writeUIntLE(1999, 24, 3);
  webp.writeUIntLE(999, 27, 3);
  assert.deepEqual(probePicture(webp), { format: 'webp', width: 2000, height: 1000, complete: true });
  const bmp = Buffer.alloc(60);
  bmp.write('BM', 0, 'latin1');
  bmp.writeUInt32LE(60, 2);
  bmp.writeUInt32LE(40, 14);
  bmp.writeInt32LE(31, 18);
  bmp.writeInt32LE(-17, 22);
  assert.deepEqual(probePicture(bmp), { format: 'bmp', width: 31, height: 17, complete: true });
});

test('a header alone is enough to refuse a bomb', () => {
  const probe = probePicture(greyPng(64250, 64250, 1));
  assert.equal(sizeError(probe.width, probe.height), 'PictureTooLarge');
  assert.equal(sizeError(32769, 100), 'PictureTooLarge');
  assert.equal(sizeError(12000, 9000), null);
  assert.equal(sizeError(15, 100), 'PictureTooSmall');
  assert.equal(sizeError(0, 100), 'PictureEmpty');
});

test('the working copy has at most four megapixels and the same shape', () => {
  for (const [width, height] of [
    [10, 10],
    [2000, 2000],
    [6000, 4000],
    [12000, 9000],
    [30000, 100],
    [16, 32768],
  ]) {
    const size = workingSize(width, height);
    assert.ok(size.width * size.height <= 4_000_000 && size.width <= width && size.height <= height);
    assert.ok(Math.abs(size.width / size.height / (width / height) - 1) < 0.08, `${width}×${height}`);
    if (width * height <= 4_000_000) assert.deepEqual(size, { width, height });
  }
});

const contact = (x, y, timeMs) => ({ x, y, timeMs });

test('before the first pen contact every touch counts', () => {
  const palms = new PalmFilter();
  assert.equal(palms.isPenMode, false);
  assert.equal(palms.touchDown(1, contact(10, 10, 0)), true);
  assert.equal(palms.isUsed(1), true);
});

test('touches within 500 ms of the pen, or 200 px of a pen in range, are palms', () => {
  const palms = new PalmFilter();
  palms.penDown(contact(500, 500, 1000));
  assert.equal(palms.isPenMode, true);
  assert.equal(palms.touchDown(1, contact(900, 900, 1400)), false, 'soon after the pen');
  assert.equal(palms.touchDown(2, contact(600, 600, 5000)), false, 'near a pen that is still there');
  assert.equal(palms.touchDown(3, contact(900, 900, 5000)), true, 'far away and much later');
  palms.penLeft(6000);
  assert.equal(palms.touchDown(4, contact(510, 510, 6400)), false, 'just after the pen left');
  assert.equal(palms.touchDown(5, contact(510, 510, 6600)), true, 'the pen is gone');
});

test('a palm that lay there before the pen came is cancelled', () => {
  const palms = new PalmFilter();
  palms.touchDown(7, contact(560, 560, 100));
  palms.touchDown(8, contact(20, 20, 100));
  assert.deepEqual(palms.penDown(contact(500, 500, 5000)), [7]);
  assert.equal(palms.isUsed(7), false);
  assert.equal(palms.isUsed(8), true);
});

test('two and three quick fingers are taps; slow, moving or single ones are not', () => {
  const tap = (fingers, { gap = 20, hold = 100, move = 0 } = {}) => {
    const finder = new TapFinder();
    let time = 0,
      found = 0;
    for (let i = 0; i < fingers; ++i) finder.down(i, 100 * i, 0, (time += gap));
    for (let i = 0; i < fingers; ++i) finder.move(i, 100 * i + move, 0);
    for (let i = 0; i < fingers; ++i) found = Math.max(found, finder.up(i, time + hold));
    return found;
  };
  assert.deepEqual([tap(1), tap(2), tap(3), tap(4)], [0, 2, 3, 0]);
  assert.deepEqual([tap(2, { gap: 400 }), tap(2, { hold: 600 }), tap(2, { move: 40 })], [0, 0, 0]);
});

test('the wheel is counted in pixels whatever the browser counts in', () => {
  assert.deepEqual([wheelPixels(120, 0, 800), wheelPixels(3, 1, 800), wheelPixels(-1, 2, 800)], [120, 48, -800]);
});
