// The engine is warmed up in idle moments, and nobody sees it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { onPage, state, useSite } from './support/page.mjs';

const kit = useSite();

test('the stages of a stroke have run before the first one, and left nothing behind', () =>
  onPage(kit, { alone: true, warmsUp: true }, async (page) => {
    const before = await state(page);
    await page.waitForFunction(() => performance.getEntriesByName('spineloft-warm').length === 1, null, {
      timeout: 120_000,
    });
    const after = await state(page);
    assert.deepEqual(after.parts, before.parts);
    assert.deepEqual(after.pictures, before.pictures);
    const { paint, warm } = await page.evaluate(() => ({
      paint: performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? 0,
      warm: performance.getEntriesByName('spineloft-warm')[0].startTime,
    }));
    assert.ok(paint < warm, `painted after ${paint} ms, warm after ${warm} ms`);
  }));
