// What the page asks of the device and its browser, and what these hand over.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { distDir } from '../../.ci/lib/paths.mjs';
import {
  enginePrograms,
  idle,
  kEngines,
  onPage,
  openWithPart,
  run,
  state,
  useSite,
  watchPrograms,
} from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();

for (const { name, isolated } of kEngines) {
  test(`each program of the engine is compiled once, while it comes (${name})`, () =>
    onPage(kit, { alone: true, isolated, scripts: [watchPrograms] }, async (page) => {
      assert.deepEqual(await enginePrograms(page), ['compileStreaming', 'compileStreaming']);
    }));
}

test('the engine starts where the host does not say what it sends', () =>
  onPage(kit, {}, async (page) => {
    const other = await page.context().newPage();
    await other.route('**/*.wasm', async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, headers: { ...response.headers(), 'content-type': 'application/octet-stream' } });
    });
    await other.addInitScript(watchPrograms);
    await other.goto(page.url());
    await other.evaluate(() => window.spineloft.ready);
    assert.deepEqual(await enginePrograms(other), ['compile', 'compile']);
    await other.close();
  }));

test('that models are to stay is asked once, after the first real work', () =>
  onPage(
    kit,
    {
      alone: true,
      scripts: [
        () => {
          window.asked = 0;
          StorageManager.prototype.persist = () => Promise.resolve((window.asked += 1) > 0);
        },
      ],
    },
    async (page) => {
      assert.equal(await page.evaluate(() => window.asked), 0);
      await openWithPart(page, tube.png, tube.middle);
      await page.waitForFunction(() => window.asked === 1);
      await run(page, 'set-colour', { colour: '#ff0000' });
      await idle(page);
      assert.equal(await page.evaluate(() => window.asked), 1);
    },
  ));

test('a picture that the file manager opens with the page is opened', () =>
  onPage(
    kit,
    {
      alone: true,
      scripts: [
        () => {
          const queue = { setConsumer: (take) => (window.launch = take) };
          Object.defineProperty(window, 'launchQueue', { value: queue, configurable: true });
        },
      ],
    },
    async (page) => {
      await page.evaluate(async (data) => {
        const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
        const file = new File([bytes], 'tube.png', { type: 'image/png' });
        window.launch({ files: [{ getFile: () => Promise.resolve(file) }] });
      }, Buffer.from(tube.png).toString('base64'));
      await page.waitForFunction(() => window.spineloft.state().picture !== null);
      assert.equal((await state(page)).pictures, 1);
    },
  ));

test('the manifest takes from the share sheet and the file manager what the page opens', () => {
  const { share_target: shared, file_handlers: handlers } = JSON.parse(
    readFileSync(join(distDir, 'site.webmanifest'), 'utf8'),
  );
  assert.equal(shared.method, 'POST');
  const types = handlers.flatMap(({ accept }) => Object.values(accept).flat());
  for (const type of ['.spineloft', '.glb', '.png', '.jpg']) assert.ok(types.includes(type), type);
  for (const type of ['image/*', '.spineloft', '.glb']) assert.ok(shared.params.files[0].accept.includes(type), type);
});

test('the first visit fetches at most 1.2 MB before the page can be used', () =>
  onPage(kit, {}, async (page) => {
    const other = await page.context().browser().newContext();
    try {
      const first = await other.newPage();
      const session = await other.newCDPSession(first);
      await session.send('Network.enable');
      let bytes = 0;
      session.on('Network.loadingFinished', ({ encodedDataLength }) => (bytes += encodedDataLength));
      await first.goto(page.url());
      await first.evaluate(() => window.spineloft.ready);
      assert.ok(bytes > 500_000 && bytes <= 1_200_000, `${bytes} bytes`);
    } finally {
      await other.close();
    }
  }));
