// What a photo's file says besides its pixels stays with the photo: where it was taken is in no file that the page
// writes. And neither the page nor any of its workers can ask another host, whatever the own host sends.
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import test from 'node:test';
import { unzipSync } from 'three/addons/libs/fflate.module.js';
import { openPage, startSite } from '../../.ci/lib/browser.mjs';
import {
  kLight,
  done,
  downloaded,
  exported,
  kWindow,
  onPage,
  openWithPart,
  run,
  state,
  useSite,
} from './support/page.mjs';
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

/** Another host, which answers everybody and counts who came. */
async function startListener(t) {
  const asked = [];
  const server = createServer((request, response) => {
    asked.push(request.url);
    const open = { 'Access-Control-Allow-Origin': '*', 'Cross-Origin-Resource-Policy': 'cross-origin' };
    response.writeHead(200, open).end();
  });
  await new Promise((resolve) => server.listen(0, 'localhost', resolve));
  t.after(() => server.close());
  return { url: `http://localhost:${server.address().port}/`, asked };
}

/** In a page or a worker: whether a request is answered. */
const isAnswered = (at) =>
  fetch(at).then(
    () => true,
    () => false,
  );

/** Notes the scripts of all workers that a page starts. */
const noteWorkers = () => {
  globalThis.started_ = [];
  globalThis.Worker = class extends Worker {
    constructor(address, options) {
      super(address, options);
      globalThis.started_.push([String(address), options]);
    }
  };
};

for (const isolated of [true, false]) {
  test(`on a host that sends no policy no worker of the page reaches another host, ${isolated ? 'with' : 'without'} threads`, async (t) => {
    const listener = await startListener(t);
    const site = await startSite({ isolated, bare: true });
    t.after(() => site.close());
    const { page, close } = await openPage(kit.browser, site.url, {
      viewport: kWindow,
      deviceScaleFactor: 0.5,
      scripts: [...kLight, noteWorkers],
    });
    t.after(close);
    await openWithPart(page, tube.png, tube.middle);
    await run(page, 'new-part');
    await done(page, 'draw-spine', { stroke: tube.middle.map(([x, y]) => [y + 60, x - 60]) });
    await done(page, 'stick-together');
    await done(page, 'cut-start', { at: tube.middle[30] });
    const started = await page.evaluate(() => globalThis.started_);
    const threads = started.filter(([, { name }]) => name === 'em-pthread').length;
    assert.equal(threads > 0, isolated);
    const others = started.map(([, { name }]) => /^spineloft-(\w+)-/.exec(name)?.[1]).filter(Boolean);
    assert.deepEqual(others.sort(), ['cut_out', 'solids']);
    // A thread of the engine sleeps and cannot be asked: another worker from the same script has the same policy.
    for (const [address, options] of new Map(started.map((one) => [one[1].name, one])).values()) {
      const [worker] = await Promise.all([
        page.waitForEvent('worker'),
        page.evaluate(([from, like]) => void new Worker(from, like), [address, options]),
      ]);
      assert.equal(await worker.evaluate(isAnswered, site.url), true, options.name);
      assert.equal(await worker.evaluate(isAnswered, listener.url), false, options.name);
    }
    assert.equal(await page.evaluate(isAnswered, listener.url), false);
    assert.deepEqual(listener.asked, []);
  });
}

test('on a host that sends no policy the service worker asks its own host alone', async (t) => {
  const listener = await startListener(t);
  const site = await startSite({ bare: true });
  t.after(() => site.close());
  const { page, context, close } = await openPage(kit.browser, site.url, {
    viewport: kWindow,
    serviceWorkers: 'allow',
    scripts: kLight,
  });
  t.after(close);
  await page.evaluate(() => navigator.serviceWorker.ready);
  const [worker] = context.serviceWorkers();
  assert.equal(await worker.evaluate(isAnswered, site.url), true);
  assert.equal(await worker.evaluate(isAnswered, listener.url), false);
  assert.equal(await worker.evaluate(isAnswered, 'index.html'), true);
  assert.deepEqual(listener.asked, []);
});
