// Surfaces and sizes on the page: paints and facets are seen, sizes are in the files as three.js reads them.
import assert from 'node:assert/strict';
import test from 'node:test';
import { PNG } from 'pngjs';
import {
  difference,
  done,
  downloaded,
  exported,
  kSharp,
  onPage,
  openWithPart,
  pixels,
  run,
  state,
  useSite,
} from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';
import { loadWithThree } from './support/three.mjs';

const kit = useSite();
const tube = tubePicture();
/** The colours of the tube's bands. */
const kBands = [
  [40, 70, 130],
  [60, 110, 90],
];
const solidView = { x: 450, y: 120, width: 380, height: 480 };

/** Share of the pixels that are not as the corner is. */
function shareSeen(data) {
  let seen = 0;
  for (let i = 0; i < data.length; i += 4)
    seen += [0, 1, 2, 3].some((k) => Math.abs(data[i + k] - data[k]) > 12) ? 1 : 0;
  return (4 * seen) / data.length;
}

/** Size and frames of a GIF, as the browser decodes them. */
async function gifFrames(page, bytes) {
  const { size, frames } = await page.evaluate(async (text) => {
    const decoder = new ImageDecoder({ data: Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), type: 'image/gif' });
    await decoder.tracks.ready;
    await decoder.completed;
    const count = decoder.tracks.selectedTrack.frameCount,
      found = [];
    let size = null;
    for (let frameIndex = 0; frameIndex < count; frameIndex += 1) {
      const { image } = await decoder.decode({ frameIndex });
      size = [image.displayWidth, image.displayHeight];
      const canvas = new OffscreenCanvas(...size),
        context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      // Every second pixel of every second line says enough.
      const { data } = context.getImageData(0, 0, ...size);
      let few = '';
      for (let y = 0; y < size[1]; y += 2)
        for (let x = 0; x < size[0]; x += 2)
          few += String.fromCharCode(...data.subarray(4 * (y * size[0] + x), 4 * (y * size[0] + x) + 4));
      found.push(btoa(few));
      image.close();
    }
    return { size, frames: found };
  }, bytes.toString('base64'));
  return { size, frames: frames.map((text) => Buffer.from(text, 'base64')) };
}

const withPart = (work) =>
  onPage(kit, kSharp, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    assert.equal((await state(page)).parts.length, 1);
    await work(page);
  });

test('a size is that size in GLB and 3MF as three.js reads them, and the picture is on both, in its colours', () =>
  withPart(async (page) => {
    await run(page, 'set-height', { typed: '4 cm' });
    const files = { glb: await exported(page, 'glb'), '3mf': await exported(page, '3mf') };
    const glb = await loadWithThree(kit.browser, files.glb, 'glb', kBands);
    const printed = await loadWithThree(kit.browser, files['3mf'], '3mf', kBands);
    assert.ok(Math.abs(glb.size[1] * 1000 - 40) < 0.01, `${glb.size}`);
    assert.ok(Math.abs(printed.size[2] - 40) < 0.01, `${printed.size}`);
    assert.equal(printed.triangles, glb.triangles);
    assert.ok(glb.textured && printed.textured);
    glb.painted.forEach((share, i) => {
      assert.ok(share > 0.25, `${share} of the GLB has the band's colour ${kBands[i]}`);
      assert.ok(Math.abs(printed.painted[i] - share) < 0.02, `${printed.painted[i]} of the 3MF, ${share} of the GLB`);
    });
    assert.ok(glb.painted[0] + glb.painted[1] > 0.8, `${glb.painted}`);
    assert.ok(glb.volume > 0 && printed.volume > 0);
    assert.ok(Math.abs(printed.volume / (glb.volume * 1e9) - 1) < 1e-3);
    await run(page, 'size-like', { thing: 'hand' });
    const { heightMm, beside } = await state(page);
    assert.deepEqual([heightMm, beside], [180, 'hand']);
  }));

test('the check for printing says its four lines, and a picture and a turntable come as files', () =>
  withPart(async (page) => {
    await run(page, 'check-print');
    const { print } = await state(page);
    assert.equal(print.lines.length, 4);
    for (const { text } of print.lines) assert.match(text, /^[A-Z].*[.]$/);
    assert.equal(print.closed, true);
    // What is not good looks like a warning, and is not lost among what is.
    const bad = print.lines.filter(({ good }) => !good),
      toast = page.locator('#toasts .toast').last();
    assert.match(await toast.getAttribute('class'), bad.length > 0 ? /toast-warning/ : /toast-info/);
    assert.equal(await toast.getAttribute('role'), bad.length > 0 ? 'alert' : 'status');
    for (const { text, good } of print.lines)
      assert.equal((await toast.innerText()).includes(text), bad.length === 0 || !good, text);
    await run(page, 'set-height', { mm: 1 });
    await run(page, 'check-print');
    const thin = page.locator('#toasts .toast').last();
    assert.match(await thin.getAttribute('class'), /toast-warning/);
    assert.match(await thin.innerText(), /thinnest place/);
    const picture = await downloaded(page, () => run(page, 'save-picture'));
    assert.ok(picture.name.endsWith('.png'), picture.name);
    const { width, height, data } = PNG.sync.read(picture.bytes);
    assert.deepEqual([width, height], [1024, 1024]);
    assert.ok(shareSeen(data) > 0.01 && shareSeen(data) < 0.9, `the model fills ${shareSeen(data)} of its picture`);

    const turning = await downloaded(page, () => run(page, 'save-turntable'));
    assert.ok(turning.name.endsWith('.gif'), turning.name);
    const { size, frames } = await gifFrames(page, turning.bytes);
    assert.deepEqual([size, frames.length], [[320, 320], 30]);
    // Half a turn on, it is seen from behind: a bent tube lies the other way.
    const apart = (a, b) => difference({ data: frames[a] }, { data: frames[b] });
    assert.ok(apart(0, 15) > 0.005 && apart(0, 8) > 0.005, `${apart(0, 15)} and ${apart(0, 8)} of the pixels`);
    assert.ok(apart(0, 29) < apart(0, 15), 'the last frame leads to the first');
  }));

// The last one: what is drawn after it wears these.
test('every paint, a second colour and facets change what is seen, and undo brings it back', () =>
  withPart(async (page) => {
    const looks = [
      ['set-colour', { colour: '#2a9d8f' }],
      ['set-paint', { paint: 'clay' }],
      ['set-paint', { paint: 'glaze' }],
      ['set-paint', { paint: 'metal' }],
      ['set-second-colour', { colour: '#e4572e' }],
    ];
    const first = await pixels(page, solidView);
    let before = first;
    for (const [id, args] of looks) {
      await done(page, id, args);
      const now = await pixels(page, solidView);
      assert.ok(difference(before, now) > 0.001, `${id} ${JSON.stringify(args)} is seen`);
      before = now;
    }
    // Of many small triangles facets are hardly seen; in the file no two of them share a corner.
    const smooth = (await exported(page, 'glb')).length;
    await run(page, 'toggle-facets', { faceted: true });
    assert.equal((await state(page)).parts[0].faceted, true);
    assert.ok((await exported(page, 'glb')).length > 1.3 * smooth);
    for (let i = 0; i < looks.length; ++i) await run(page, 'undo');
    await done(page, 'undo');
    assert.ok(difference(first, await pixels(page, solidView)) < 0.001);
  }));
