// The viewer, view.html: it shows what is in a link or a GLB, alone and inside another page, and changes nothing.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { brotliCompressSync } from 'node:zlib';
import { distDir } from '../../.ci/lib/paths.mjs';
import { openPage } from '../../.ci/lib/browser.mjs';
import {
  difference,
  done,
  exported,
  idle,
  kQuick,
  kSharp,
  kWindow,
  onPage,
  pixels,
  state,
  useSite,
} from './support/page.mjs';
import { handOf } from './support/hands.mjs';
import { loadWithThree } from './support/three.mjs';

/** A second engine starts beside the first, and without a graphics card. */
const kPatience = 120_000;

/** A model on paper: a loft with a look of its own. */
async function drawOnPaper(page) {
  await done(page, 'new-sketch');
  const { width, height } = (await state(page)).picture;
  const at = (x, y) => [Math.round(x * width), Math.round(y * height)];
  await done(page, 'draw-spine', { stroke: [at(0.2, 0.3), at(0.35, 0.45), at(0.5, 0.5), at(0.75, 0.45)] });
  await done(page, 'set-colour', { colour: '#2e86c1' });
}

/** The same beside a puff. */
async function drawBoth(page) {
  await drawOnPaper(page);
  const { width, height } = (await state(page)).picture;
  const round = Array.from({ length: 24 }, (_, i) => (i * Math.PI) / 12);
  const contour = round.map((turn) => [width * (0.3 + 0.12 * Math.cos(turn)), height * (0.75 + 0.12 * Math.sin(turn))]);
  await done(page, 'draw-puff', { contours: [contour] });
  assert.deepEqual(
    (await state(page)).parts.map(({ kind }) => kind),
    ['loft', 'puff'],
  );
}

const linkOf = (page) => page.evaluate(() => window.spineloft.shareLink());

/** Both on paper as a link, its text and a GLB, for the tests that only look at it. */
const model = {};
const kit = useSite((site) =>
  onPage(site, { alone: true }, async (page) => {
    await drawBoth(page);
    const { url, text } = await linkOf(page);
    // A GLB of what the text keeps of it.
    await page.evaluate(async (one) => {
      await window.spineloft.openShareText(one);
      await window.spineloft.idle();
    }, text);
    Object.assign(model, { url, text, glb: await exported(page, 'glb') });
  }),
);

const shown = (page) => page.locator('body[data-state=shown]').waitFor({ timeout: kPatience });

/** Opens an address of the site in a page of its own, without the graphics' help, as whoever gets a link does. */
async function visit(url, work, options = {}) {
  const opened = await openPage(kit.browser, url, { ...kQuick, reducedMotion: 'reduce', ...options });
  try {
    await work(opened.page, opened);
    assert.deepEqual(opened.troubles, []);
  } finally {
    await opened.close();
  }
}

/** A page of somebody else around the viewer, which notes what it is told. */
async function visitEmbedded(address, work, options) {
  const site = kit.sites.false.url;
  const opened = await openPage(kit.browser, 'about:blank', { ...kQuick, ...options });
  try {
    const { page } = opened;
    page.setDefaultTimeout(kPatience);
    await page.route('**/host.html', (route) =>
      route.fulfill({
        contentType: 'text/html',
        body: `<!doctype html><link rel="icon" href="data:,"><script>
          window.told = [];
          addEventListener('message', ({ data }) => window.told.push(data));
        </script><iframe id="frame" width="640" height="480" src="${address}"></iframe>`,
      }),
    );
    await page.goto(`${site}host.html`);
    await work(page, page.frameLocator('#frame'));
    assert.deepEqual(opened.troubles, []);
  } finally {
    await opened.close();
  }
}
const told = (page, type) =>
  page
    .waitForFunction((wanted) => window.told.find((one) => one.type === wanted), type, {
      timeout: kPatience,
    })
    .then((found) => found.jsonValue());
const ask = (page, wish) =>
  page.evaluate((data) => document.querySelector('#frame').contentWindow.postMessage(data, '*'), wish);
const showGlb = (page, glb, name) =>
  page.evaluate(
    ([base64, title]) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      const wish = { type: 'spineloft:show', glb: bytes.buffer, name: title };
      document.querySelector('#frame').contentWindow.postMessage(wish, '*', [bytes.buffer]);
    },
    [glb.toString('base64'), name],
  );

test('a link shows the model first and touches nothing; "Make it mine" opens a copy that can be changed', () =>
  onPage(kit, { alone: true }, async (page, { context }) => {
    await drawOnPaper(page);
    await done(page, 'rename-model', { name: 'A <b>swan' });
    const { url } = await linkOf(page);
    const before = await page.evaluate(() => window.spineloft.models());
    const other = await context.newPage();
    await other.goto(url);
    await shown(other);
    assert.equal(await other.locator('#name').innerText(), 'A <b>swan');
    assert.deepEqual(await page.evaluate(() => window.spineloft.models()), before);
    await other.getByRole('link', { name: 'Make it mine' }).click();
    await other.waitForFunction(() => window.spineloft?.state().parts.length === 1, null, { timeout: kPatience });
    await idle(other);
    assert.equal((await state(other)).documentName, 'A <b>swan');
    assert.equal(new URL(other.url()).hash, '');
    assert.equal((await other.evaluate(() => window.spineloft.models())).length, before.length + 1);
    await done(other, 'rename-model', { name: 'Mine' });
    assert.equal((await state(page)).documentName, 'A <b>swan');
    // A link of the page's own address, as they were before there was a viewer, shows the model first, too.
    await other.goto(url.replace('view.html', ''));
    await shown(other);
    await other.close();
  }));

test('a model without a name is called so in the language of who opens its link', () =>
  visit(
    model.url,
    async (page) => {
      await shown(page);
      assert.equal(await page.locator('#name').innerText(), 'Modell');
      assert.equal(await page.title(), 'Modell · SpineLoft');
    },
    { locale: 'de' },
  ));

test('a link that is cut off, altered, of a later version or none says which, and offers the page', async () => {
  const { text, url } = model;
  const start = url.slice(0, -text.length);
  await visit('about:blank', async (page) => {
    for (const [link, sentence] of [
      [url.slice(0, -5), /^The end of that link is missing.*5 characters/],
      [`${url.slice(0, -5)}-----`, /^That link has been changed on its way/],
      [`${start}9${text.slice(1)}`, /newer SpineLoft/],
      [`${start}hello!`, /no model of SpineLoft in that link/],
      [`${start}${'1'.padEnd(1_048_600, 'A')}`, /not enough memory|changed on its way/],
      [start.replace('#m=', ''), /no model of SpineLoft in that link/],
    ]) {
      await page.goto('about:blank');
      await page.goto(link);
      await page.locator('body[data-state=failed]').waitFor({ timeout: kPatience });
      assert.match(await page.getByRole('status').first().innerText(), sentence);
      assert.ok(await page.getByRole('link', { name: 'Go to SpineLoft' }).isVisible());
      assert.ok(await page.locator('#foot').isHidden());
    }
  });
});

function coloursOf({ data }) {
  const colours = new Set();
  for (let i = 0; i < data.length; i += 4) colours.add(data.readUIntBE(i, 3));
  return colours.size;
}

/** How many pixels are not as the corner, which is empty. */
function inkOf({ data }) {
  let count = 0;
  for (let i = 0; i < data.length; i += 4) if ([0, 1, 2].some((k) => Math.abs(data[i + k] - data[k]) > 16)) count += 1;
  return count;
}

/** What the embedded viewer shows when it has drawn: the first frame of a model takes its time without a GPU. */
async function drawnPicture(host) {
  const take = () => pixels(host, { x: 8, y: 8, width: 640, height: 420 });
  let last = await take();
  for (const end = Date.now() + kPatience; Date.now() < end;) {
    await host.waitForTimeout(400);
    const next = await take();
    if (coloursOf(next) > 100 && difference(last, next) === 0) return next;
    last = next;
  }
  return last;
}

test('the viewer shows what the GLB of the page shows: as many triangles, the same size, the same pixels', async () => {
  const { glb, text, url } = model;
  const measured = await loadWithThree(kit.browser, glb);
  const pictures = [];
  const options = { reducedMotion: 'reduce', ...kSharp };
  await visitEmbedded(
    'view.html',
    async (host) => {
      await told(host, 'spineloft:ready');
      for (const show of [() => showGlb(host, glb, 'By hand'), () => ask(host, { type: 'spineloft:show', text })]) {
        await host.evaluate(() => (window.told.length = 0));
        await show();
        const facts = await told(host, 'spineloft:shown');
        assert.equal(facts.triangles, measured.triangles);
        facts.size.forEach((side, i) => assert.ok(Math.abs(side / measured.size[i] - 1) < 1e-5, `${facts.size}`));
        await ask(host, { type: 'spineloft:look', yaw: 20, pitch: 10 });
        pictures.push(await drawnPicture(host));
      }
    },
    options,
  );
  assert.ok(difference(pictures[0], pictures[1]) < 0.002, `${difference(pictures[0], pictures[1])}`);
  // Something is there to see.
  assert.ok(coloursOf(pictures[0]) > 100, `${coloursOf(pictures[0])} colours`);
  assert.match(url, /view\.html#m=/);
});

test('a viewer of a GLB loads at most 300 KB without the model, needs no header, and asks no other host', async () => {
  const { glb, url } = model;
  const asked = new Set();
  await visitEmbedded('about:blank', async (host) => {
    host.on('request', (request) => asked.add(request.url()));
    await host.evaluate(() => document.querySelector('#frame').setAttribute('src', 'view.html'));
    await told(host, 'spineloft:ready');
    await showGlb(host, glb, 'Small');
    await told(host, 'spineloft:shown');
  });
  const addresses = [...asked].filter((url) => /^(http|ws)/.test(url)).map((url) => new URL(url));
  assert.deepEqual([...new Set(addresses.map(({ origin }) => origin))], [new URL(kit.sites.false.url).origin]);
  const files = addresses.map(({ pathname }) => pathname);
  assert.ok(files.includes('/view.html') && files.length >= 3, files.join(' '));
  const bytes = files.reduce((sum, file) => sum + brotliCompressSync(readFileSync(join(distDir, file))).length, 0);
  assert.ok(bytes <= 300 * 1024, `${bytes} bytes: ${files.join(' ')}`);
});

test('inside another page the poster is first, and the page is told what happens', async () => {
  const { text } = model;
  const dot =
    'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAChwGA60e6kgAAAABJRU5ErkJggg==';
  await visitEmbedded(`view.html#m=${text}&poster=${dot}`, async (host, frame) => {
    await told(host, 'spineloft:ready');
    assert.equal(await frame.locator('#poster').getAttribute('src'), dot);
    assert.equal(await host.evaluate(() => window.told.length), 1);
    await frame.getByRole('button', { name: 'Show the model' }).click();
    const { name, triangles } = await told(host, 'spineloft:shown');
    assert.ok(triangles > 100 && name.length > 0);
    assert.equal(await frame.getByRole('link', { name: 'Make it mine' }).getAttribute('target'), '_blank');
    // It turns by itself until somebody takes hold of it.
    const turn = frame.getByRole('button', { name: 'Turn' });
    assert.equal(await turn.getAttribute('aria-pressed'), 'true');
    await frame.locator('#canvas').press('ArrowLeft');
    assert.equal(await turn.getAttribute('aria-pressed'), 'false');
    await ask(host, { type: 'spineloft:turn', on: true });
    await frame.locator('#spin[aria-pressed=true]').waitFor();
    await ask(host, { type: 'spineloft:show', text: `${text}A` });
    assert.equal((await told(host, 'spineloft:failed')).code, 'LinkAltered');
  });
});

test('a poster is a picture in the address and nothing else, and a GLB is of the own site', async () => {
  const site = kit.sites.false.url;
  await visit(`${site}view.html#m=1A&poster=https://example.org/a.png`, async (page) => {
    assert.match(await page.locator('#poster').getAttribute('src'), /mark-/);
  });
  await visit(`${site}view.html#glb=https://example.org/a.glb`, async (page) => {
    await page.getByText('models of its own site only').waitFor();
  });
});

test('mouse, finger and keys turn and zoom the model; who wants less motion sees it stand still until space is pressed', async () => {
  const { url } = model;
  const small = { width: 600, height: 400 };
  await visit(
    url,
    async (other) => {
      await shown(other);
      const spin = other.locator('#spin');
      const canvas = other.locator('#canvas');
      assert.equal(await spin.getAttribute('aria-pressed'), 'false');
      const middle = { x: small.width / 2, y: small.height / 2 };
      const clip = { x: middle.x - 200, y: middle.y - 150, width: 400, height: 300 };
      const settled = async () => {
        await other.waitForTimeout(300);
        return pixels(other, clip);
      };
      const areSame = (a, b, what) => assert.ok(difference(a, b) < 0.002, `${what}: ${difference(a, b)}`);
      const differ = (a, b, what) => assert.ok(difference(a, b) > 0.01, `${what}: ${difference(a, b)}`);
      const first = await settled();
      assert.equal(difference(first, await settled()), 0);
      for (const hand of ['mouse', 'finger']) {
        const before = await settled();
        const pointer = await handOf(other, hand);
        await pointer.down(middle);
        for (let i = 1; i <= 4; i += 1) await pointer.move({ x: middle.x + 30 * i, y: middle.y + 2 * i });
        await pointer.up();
        differ(before, await settled(), hand);
      }
      const dragged = await settled();
      await canvas.press('ArrowUp');
      differ(dragged, await settled(), 'a key');
      await canvas.press('h');
      areSame(first, await settled(), 'home');
      await canvas.press('+');
      const near = await settled();
      differ(first, near, '+');
      assert.ok(inkOf(near) > 1.2 * inkOf(first), `${inkOf(near)}, ${inkOf(first)}`);
      await canvas.press('-');
      areSame(first, await settled(), '+ and -');
      await canvas.press('-');
      const far = await settled();
      assert.ok(inkOf(far) < inkOf(first) / 1.2, `${inkOf(far)}, ${inkOf(first)}`);
      await canvas.press(' ');
      await other.locator('#spin[aria-pressed=true]').waitFor();
      await other.waitForTimeout(700);
      differ(far, await settled(), 'turning');
      await canvas.press(' ');
      await other.locator('#spin[aria-pressed=false]').waitFor();
      const still = await settled();
      await other.waitForTimeout(1000);
      assert.equal(difference(still, await settled()), 0);
    },
    { hasTouch: true, viewport: small },
  );
});

test('"In your room" loads <model-viewer> from the own site when the device can show it', async () => {
  const { url } = model;
  await visit(url, async (other) => {
    await shown(other);
    assert.ok(await other.locator('#ar').isHidden());
  });
  const opened = await openPage(kit.browser, 'about:blank', { ...kQuick, reducedMotion: 'reduce' });
  try {
    const other = opened.page;
    await other.addInitScript(() => {
      Object.defineProperty(navigator, 'xr', { value: { isSessionSupported: async () => true } });
    });
    const away = [];
    other.on('request', (request) => {
      if (/^http/.test(request.url()) && new URL(request.url()).origin !== new URL(url).origin)
        away.push(request.url());
    });
    await other.goto(url);
    await shown(other);
    await other.getByRole('button', { name: 'In your room' }).click();
    await other.waitForFunction(() => document.querySelector('model-viewer')?.loaded === true, null, {
      timeout: kPatience,
    });
    await other.getByRole('button', { name: 'Close' }).click();
    assert.equal(await other.locator('model-viewer').count(), 0);
    assert.deepEqual(away, []);
  } finally {
    await opened.close();
  }
});
