// The page on bad days: lost contexts, odd hosts, missing features; and that it rests when nothing happens.
import assert from 'node:assert/strict';
import test from 'node:test';
import { openPage, startSite } from '../../.ci/lib/browser.mjs';
import { drawWithMouse } from './support/hands.mjs';
import {
  asWarm,
  kLight,
  difference,
  done,
  downloaded,
  exported,
  idle,
  kEngines,
  kSharp,
  kWindow,
  onPage,
  openPicture,
  openWithPart,
  pixels,
  run,
  state,
  toastText,
  useSite,
} from './support/page.mjs';
import { enlarged, tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();

/**
 * A page in a context of its own with what `prepare` does to it before the site is there. Without a service worker: what
 * it has kept already would come in spite of the spoilt network.
 */
async function onSpoiltPage(prepare, work) {
  const context = await kit.browser.newContext({ serviceWorkers: 'block' });
  await context.addInitScript(asWarm);
  const page = await context.newPage();
  try {
    await prepare(page);
    await page.goto(kit.sites.true.url);
    await work(page);
  } finally {
    await context.close();
  }
}

/** Nothing is said any more, and no frame is to come. */
async function atRest(page) {
  await page.mouse.move(5, 715);
  await page.evaluate(() => {
    for (const close of document.querySelectorAll('#toasts .toast-close')) close.click();
  });
  await page.locator('#toasts .toast').first().waitFor({ state: 'detached' });
  await idle(page);
}

test('with graphics that never come back an edit, exporting and saving go on, and a banner offers to load again', () =>
  onPage(kit, { alone: true }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await page.evaluate(() =>
      document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext(),
    );
    await run(page, 'set-section', { section: 'square' });
    await idle(page);
    assert.ok((await exported(page, 'glb')).length > 1000);
    const { name } = await downloaded(page, () => page.keyboard.press('Control+s'));
    assert.match(name, /\.spineloft$/);
    const banner = page.locator('#banners [data-id=graphics]');
    await banner.waitFor();
    await banner.getByRole('button', { name: 'Load again' }).click();
    await page.waitForFunction(() => window.spineloft?.state().parts.length === 1);
  }));

test('a lost WebGL context comes back with the same pixels and nothing lost', () =>
  onPage(kit, { alone: true, ...kSharp }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await atRest(page);
    const clip = { x: 0, y: 60, width: 1100, height: 630 };
    const before = await pixels(page, clip);
    const partsBefore = (await state(page)).parts;
    await page.evaluate(async () => {
      const canvas = document.getElementById('canvas');
      const extension = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
      const restored = new Promise((resolve) => {
        canvas.addEventListener('webglcontextrestored', resolve, { once: true });
      });
      extension.loseContext();
      await new Promise((resolve) => {
        setTimeout(resolve, 300);
      });
      extension.restoreContext();
      await restored;
    });
    await idle(page);
    assert.ok(difference(before, await pixels(page, clip)) < 0.002);
    assert.deepEqual((await state(page)).parts, partsBefore);
  }));

/** Steps that are done, taken back and done again without waiting. */
const kSteps = 361;
const kMegabyte = 2 ** 20;

test(`${kSteps} steps, undos and redos without waiting need the engine memory of a few`, (t) =>
  onPage(kit, { alone: true }, async (page) => {
    const large = enlarged(tubePicture({ width: 240, height: 180, half: 30 }), 4);
    await openWithPart(page, large.png, large.middle);
    const begun = await page.evaluate(() => window.spineloft.memory().engine);
    const reached = await page.evaluate(async (count) => {
      const api = window.spineloft;
      const twisted = (turn) => api.run('set-along', { kind: 'twist', points: [0, turn].map((y, x) => [x, y]) });
      for (let i = 1; i <= count; i += 1) void twisted(0.001 * i);
      let last;
      for (const command of ['undo', 'redo', 'undo']) for (let i = 0; i < count; i += 1) last = api.run(command);
      await last;
      await api.idle();
      return api.memory().engine;
    }, kSteps);
    t.diagnostic(`${begun / kMegabyte} MB, then ${reached / kMegabyte} MB`);
    // The memory of WebAssembly never shrinks: what is held afterwards is the most that was held.
    assert.ok(reached - begun <= 96 * kMegabyte, `${begun / kMegabyte} MB, then ${reached / kMegabyte} MB`);
  }));

test('an idle page with a part and a sketch draws no frame and runs no timer', () =>
  onPage(kit, { alone: true, warmsUp: true }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await run(page, 'new-sketch', { width: 768, height: 1024 });
    await drawWithMouse(page, [
      [240, 200],
      [250, 400],
      [240, 620],
    ]);
    // Until the engine and the models have had their idle moments.
    await page.waitForFunction(() => performance.getEntriesByName('spineloft-warm').length === 1, null, {
      timeout: 120_000,
    });
    await atRest(page);
    await page.waitForTimeout(1000);
    await page.evaluate(() => {
      window.work_ = { draws: 0, frames: 0, timers: 0 };
      const context = document.getElementById('canvas').getContext('webgl2');
      for (const name of ['clear', 'drawElements', 'drawArrays']) {
        const original = context[name].bind(context);
        context[name] = (...values) => {
          window.work_.draws += 1;
          return original(...values);
        };
      }
      const request = window.requestAnimationFrame.bind(window);
      window.requestAnimationFrame = (callback) => {
        window.work_.frames += 1;
        return request(callback);
      };
      for (const name of ['setTimeout', 'setInterval']) {
        const original = window[name].bind(window);
        window[name] = (...values) => {
          window.work_.timers += 1;
          return original(...values);
        };
      }
    });
    await page.waitForTimeout(1500);
    assert.deepEqual(await page.evaluate(() => window.work_), { draws: 0, frames: 0, timers: 0 });
    await page.mouse.move(300, 400);
    await page.mouse.wheel(0, -120);
    await page.waitForTimeout(600);
    assert.ok((await page.evaluate(() => window.work_.draws)) > 0, 'the counter itself works');
  }));

for (const isolated of [true, false]) {
  test(`the site works from a sub-path of a host ${isolated ? 'with' : 'without'} isolation headers`, async () => {
    const site = await startSite({ isolated, basePath: '/tools/spine/' });
    const { page, troubles, close } = await openPage(kit.browser, site.url, { viewport: kWindow, scripts: kLight });
    try {
      await page.evaluate(() => window.spineloft.ready);
      await openWithPart(page, tube.png, tube.middle);
      assert.equal((await state(page)).parts.length, 1);
      assert.deepEqual(troubles, []);
    } finally {
      await close();
      await site.close();
    }
  });
}

test('the API is there before the engine is, and waits for it', () => {
  const lookEarly = () =>
    addEventListener('DOMContentLoaded', () => {
      const early = window.spineloft;
      window.early_ = early && {
        state: early.state(),
        commands: early.commands(),
        at: early.imageToClient(1, 1),
        isPromise: early.ready instanceof Promise,
      };
    });
  return onSpoiltPage(
    (page) => page.addInitScript(lookEarly),
    async (page) => {
      const early = await page.evaluate(() => window.early_);
      assert.equal(early.state.picture, null);
      assert.equal(early.state.busy, true);
      assert.deepEqual(early.commands, []);
      assert.equal(early.isPromise, true);
      await idle(page);
      assert.equal((await state(page)).busy, false);
    },
  );
});

test('?threads=0 asks for the single-thread engine on an isolated page', () =>
  onPage(kit, { alone: true, isolated: true, query: '?threads=0' }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    const { threads, parts } = await state(page);
    assert.equal(threads, 0);
    assert.equal(parts.length, 1);
  }));

/** In the page, before its scripts: threads are asked for and never begin. */
function holdThreads() {
  const Real = window.Worker;
  window.Worker = class extends Real {
    constructor(address, options) {
      super(address, options);
      this.isHeld = options?.name === 'em-pthread';
      window.heldThreads = (window.heldThreads ?? 0) + this.isHeld;
    }
    postMessage(...message) {
      if (!this.isHeld) super.postMessage(...message);
    }
  };
}

test('where no thread ever begins the page does the work itself after a while', () =>
  onPage(kit, { alone: true, isolated: true, scripts: [holdThreads] }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    const { threads, parts } = await state(page);
    assert.ok(threads > 0);
    assert.ok((await page.evaluate(() => window.heldThreads)) > 0);
    assert.equal(parts.length, 1);
    assert.ok((await exported(page, 'glb')).length > 1000);
  }));

for (const [what, spoil, says] of [
  [
    'WebGL 2',
    () => {
      HTMLCanvasElement.prototype.getContext = () => null;
    },
    /WebGL 2/,
  ],
  [
    'WebAssembly',
    () => {
      delete globalThis.WebAssembly;
    },
    /WebAssembly/,
  ],
]) {
  test(`a browser without ${what} gets it said in plain words, and ready rejects`, () =>
    onSpoiltPage(
      (page) => page.addInitScript(spoil),
      async (page) => {
        const failure = page.locator('.start-failure');
        await failure.waitFor();
        assert.match(await failure.innerText(), says);
        const code = await page.evaluate(() =>
          window.spineloft.ready.then(
            () => null,
            (error) => error.code,
          ),
        );
        assert.match(code, /^No/);
      },
    ));
}

test('a picture chosen while the engine still loads is opened when it runs, and the wait is shown', () => {
  let goOn;
  const chosen = new Promise((resolve) => {
    goOn = resolve;
  });
  return onSpoiltPage(
    (page) => page.route('**/*.wasm', (route) => chosen.then(() => route.continue())),
    async (page) => {
      await page.locator('.sample-open').nth(1).click();
      await page.locator('#progress').waitFor();
      assert.match(await page.locator('#progress').innerText(), /Getting ready/);
      goOn();
      await page.waitForFunction(() => window.spineloft.state().picture !== null);
      assert.equal((await state(page)).picture.name, await page.locator('.sample-title').nth(1).textContent());
    },
  );
});

test('an engine that does not arrive is said, not left spinning', () =>
  onSpoiltPage(
    (page) => page.route('**/*.wasm', (route) => route.abort()),
    async (page) => {
      await page.locator('.start-failure').waitFor();
      assert.match(await page.locator('.start-failure').innerText(), /did not load completely/);
    },
  ));

/** In the page, before its scripts: requests that its own thread waits for. */
function watchWaiting() {
  window.waited = [];
  const open = XMLHttpRequest.prototype.open;
  XMLHttpRequest.prototype.open = function (method, address, ...rest) {
    window.waited.push(String(address));
    return open.call(this, method, address, ...rest);
  };
}

test('a part along a spine is made, undone and kept without the second program of the engine', () =>
  onSpoiltPage(
    async (page) => {
      await page.addInitScript(watchWaiting);
      await page.route('**/*-second-*.wasm', () => undefined); // never answered
    },
    async (page) => {
      await openWithPart(page, tube.png, tube.middle);
      await run(page, 'undo');
      await run(page, 'redo');
      assert.equal((await state(page)).parts.length, 1);
      await page.waitForFunction(async () => (await window.spineloft.models()).length === 1);
      assert.deepEqual(await page.evaluate(() => window.waited), []);
    },
  ));

const squareOutline = [
  [100, 60],
  [300, 60],
  [300, 240],
  [100, 240],
];

test('what needs the second program while it is away waits for it, says so, and goes on', () => {
  let isAway = true;
  return onSpoiltPage(
    (page) => page.route('**/*-second-*.wasm', (route) => (isAway ? route.abort() : route.continue())),
    async (page) => {
      await page.evaluate(() => window.spineloft.ready);
      const asked = [];
      page.on('dialog', (dialog) => {
        asked.push(dialog.message());
        isAway = false;
        void dialog.accept();
      });
      await run(page, 'new-sketch', { width: 400, height: 300 });
      await run(page, 'draw-puff', {
        contours: [squareOutline],
      });
      assert.equal((await state(page)).parts.length, 1);
      assert.equal(asked.length, 1);
      assert.match(asked[0], /still missing. Check the connection/);
    },
  );
});

test('a page whose second program is gone from the server says so once and is loaded again, with what was kept', () => {
  let isGone = true;
  return onSpoiltPage(
    (page) => page.route('**/*-second-*.wasm', (route) => (isGone ? route.fulfill({ status: 404 }) : route.continue())),
    async (page) => {
      await openWithPart(page, tube.png, tube.middle);
      await page.waitForFunction(async () => (await window.spineloft.models()).length === 1);
      const asked = [];
      page.on('dialog', (dialog) => {
        asked.push(dialog.message());
        isGone = false;
        void dialog.accept();
      });
      const loaded = page.waitForEvent('load');
      void run(page, 'draw-puff', { contours: [squareOutline] }).catch(() => undefined); // the page is left
      await loaded;
      await page.evaluate(() => window.spineloft.ready);
      await page.waitForFunction(() => window.spineloft.state().parts.length === 1);
      assert.equal(asked.length, 1);
      assert.match(asked[0], /no longer on its server/);
    },
  );
});

test('a sample that does not load says so and leaves the start page usable', () =>
  onSpoiltPage(
    () => undefined,
    async (page) => {
      await page.evaluate(() => window.spineloft.ready);
      await page.route('**/samples/**', (route) => route.fulfill({ status: 404, body: '' }));
      await page.locator('.sample-open').first().click();
      assert.match(await toastText(page), /did not load/);
      assert.equal(await page.locator('#start').isVisible(), true);
    },
  ));

// ?sharp: a machine that draws with its processor otherwise saves pixels while something moves.
test('resizing and zooming keep the drawing crisp: the canvas has as many pixels as the screen', () =>
  onPage(
    kit,
    { alone: true, query: '?sharp', deviceScaleFactor: 2, viewport: { width: 900, height: 700 } },
    async (page) => {
      await openPicture(page, tube.png, 'tube.png');
      const sizes = () =>
        page.evaluate(() => {
          const canvas = document.getElementById('canvas');
          return {
            backing: [canvas.width, canvas.height],
            css: [canvas.clientWidth, canvas.clientHeight],
            ratio: devicePixelRatio,
          };
        });
      for (const viewport of [
        { width: 900, height: 700 },
        { width: 640, height: 900 },
        { width: 1300, height: 600 },
      ]) {
        await page.setViewportSize(viewport);
        await page.waitForTimeout(250);
        await idle(page);
        const { backing, css, ratio } = await sizes();
        assert.deepEqual(
          backing,
          css.map((side) => Math.round(side * ratio)),
          JSON.stringify(viewport),
        );
      }
    },
  ));
