// The shell's pure parts, without a browser: palms, taps, sizes, wheel.
import assert from 'node:assert/strict';
import test from 'node:test';
import { load } from './support/load.mjs';

const { PalmFilter } = await load('palm.ts');
const { TapFinder } = await load('taps.ts');
const { sizeError, workingSize } = await load('picture.ts');
const { wheelPixels } = await load('pointer.ts');

test('a decoded picture is held to the limits of the engine', () => {
  const limits = { minSide: 16, maxSide: 32768, mostPixels: 120_000_000 };
  assert.equal(sizeError(32769, 100, limits), 'PictureTooLarge');
  assert.equal(sizeError(12000, 10001, limits), 'PictureTooLarge');
  assert.equal(sizeError(12000, 9000, limits), null);
  assert.equal(sizeError(15, 100, limits), 'PictureTooSmall');
  assert.equal(sizeError(0, 100, limits), 'PictureEmpty');
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
    const size = workingSize(width, height, 4_000_000);
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
