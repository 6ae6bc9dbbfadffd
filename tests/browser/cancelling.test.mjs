// Work on a solid that takes its time: it is seen to go on, and can be stopped at the button.
import assert from 'node:assert/strict';
import test from 'node:test';
import { measure, parseStl } from './support/model_files.mjs';
import { done, exported, idle, onPage, openWithPart, run, state, useSite } from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();
const root = async (page) => (await state(page)).steps.findLast((step) => step.root);

/** Workers whose answers wait, while `window.held` is an array, until `window.hand()` gives out the first of them. */
function heldWorkers() {
  const Plain = window.Worker,
    handler = Object.getOwnPropertyDescriptor(Plain.prototype, 'onmessage');
  window.held = null;
  window.hand = () => window.held?.shift()?.give();
  window.Worker = class extends Plain {
    /** What a worker has not said by then it never says. */
    terminate() {
      window.held = window.held?.filter(({ worker }) => worker !== this) ?? null;
      super.terminate();
    }

    set onmessage(told) {
      const give = (event) => {
        if (window.held) window.held.push({ worker: this, give: () => told.call(this, event) });
        else told.call(this, event);
      };
      handler.set.call(this, told && give);
    }

    get onmessage() {
      return handler.get.call(this);
    }
  };
}

test('while a solid takes long, a bar shows how far it is, and its button keeps the last good solid', () =>
  onPage(kit, { scripts: [heldWorkers] }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await run(page, 'new-part');
    await run(page, 'draw-spine', { stroke: tube.middle.slice(15, 40).map(([x, y], i) => [x, y + 2 * (i - 12)]) });
    await run(page, 'stick-together', { parts: [1, 2] });
    await done(page, 'scoop-out', { step: 1, wall: 0.01 });
    const good = await root(page);
    assert.equal(good.status, 'ready', good.sentence);
    const box = page.locator('#progress'),
      bar = page.locator('#progress-bar');
    assert.equal(await box.isVisible(), false);

    await page.evaluate(() => {
      window.held = [];
      window.steps = [];
      window.timer = setInterval(() => {
        const { hidden } = document.getElementById('progress'),
          { value } = document.getElementById('progress-bar');
        if (!hidden && window.steps.at(-1) !== value) window.steps.push(value);
      }, 20);
      return window.spineloft.run('set-section', { part: 1, section: 'star' });
    });
    await box.waitFor({ state: 'visible' });
    assert.match(await page.locator('#progress-label').innerText(), /\S/);
    await page.waitForFunction(() => window.steps.length > 1 || void window.hand(), null, { polling: 200 });
    assert.ok((await bar.evaluate(({ value }) => value)) > 0);
    await page.locator('#progress-cancel').click();
    await box.waitFor({ state: 'hidden' });
    const steps = await page.evaluate(() => {
      clearInterval(window.timer);
      while (window.held.length > 0) window.hand();
      window.held = null;
      return window.steps;
    });
    assert.ok(
      steps.length > 1 && steps.every((value, i) => i === 0 || value > steps[i - 1]),
      `it only goes on: ${steps}`,
    );
    await idle(page);
    const stopped = await root(page);
    assert.deepEqual(
      [stopped.status, stopped.failure, stopped.triangles, stopped.volume],
      ['failed', 'Cancelled', good.triangles, good.volume],
    );

    await done(page, 'solve-again');
    const again = await root(page);
    assert.equal(again.status, 'ready', again.sentence);
    assert.notEqual(again.triangles, good.triangles);
    assert.equal(measure(parseStl(await exported(page, 'stl'))).open, 0);
  }));
