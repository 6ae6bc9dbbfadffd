// Surfaces and sizes on the page: paints and facets are seen, sizes are in the files as three.js reads them.
import assert from 'node:assert/strict';
import test from 'node:test';
import { difference, drawWithMouse, exported, idle, onPage, openPicture, pixels, run, state, useSite } from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';
import { loadWithThree } from './support/three.mjs';

const kit = useSite();
const tube = tubePicture();
const solidView = { x: 450, y: 120, width: 380, height: 480 };

async function withPart(work) {
  await onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await drawWithMouse(page, tube.middle);
    assert.equal((await state(page)).parts.length, 1);
    await work(page);
  });
}

test('every paint, a second colour and facets change what is seen, and undo brings it back', () => withPart(async (page) => {
  const looks = [
    ['set-colour', { colour: '#2a9d8f' }], ['set-paint', { paint: 'clay' }], ['set-paint', { paint: 'glaze' }], ['set-paint', { paint: 'metal' }],
    ['set-second-colour', { colour: '#e4572e' }],
  ];
  const first = await pixels(page, solidView);
  let before = first;
  for (const [id, args] of looks) {
    await run(page, id, args);
    await idle(page);
    const now = await pixels(page, solidView);
    assert.ok(difference(before, now) > 0.001, `${id} ${JSON.stringify(args)} is seen`);
    before = now;
  }
  // Of many small triangles facets are hardly seen; in the file no two of them share a corner.
  const smooth = (await exported(page, 'glb')).length;
  await run(page, 'toggle-facets', { faceted: true });
  assert.equal((await state(page)).parts[0].faceted, true);
  assert.ok((await exported(page, 'glb')).length > 1.3 * smooth);
  for (let i = 0; i <= looks.length; ++i) await run(page, 'undo');
  await idle(page);
  assert.ok(difference(first, await pixels(page, solidView)) < 0.001);
}));

test('a size is that size in GLB and 3MF as three.js reads them, and the picture is on both', () => withPart(async (page) => {
  await run(page, 'set-height', { typed: '4 cm' });
  const glb = await loadWithThree(kit.browser, await exported(page, 'glb'));
  const printed = await loadWithThree(kit.browser, await exported(page, '3mf'), '3mf');
  assert.ok(Math.abs(glb.size[1] * 1000 - 40) < 0.01, `${glb.size}`);
  assert.ok(Math.abs(printed.size[2] - 40) < 0.01, `${printed.size}`);
  assert.equal(printed.triangles, glb.triangles);
  assert.ok(glb.textured);
  assert.ok(glb.volume > 0 && printed.volume > 0);
  assert.ok(Math.abs(printed.volume / (glb.volume * 1e9) - 1) < 1e-3);
  await run(page, 'size-like', { thing: 'hand' });
  const { heightMm, beside } = await state(page);
  assert.deepEqual([heightMm, beside], [180, 'hand']);
}));

test('the check for printing says its four lines, and a picture and a turntable come as files', () => withPart(async (page) => {
  await run(page, 'check-print');
  const { print } = await state(page);
  assert.equal(print.lines.length, 4);
  for (const { text } of print.lines) assert.match(text, /^[A-Z].*[.]$/);
  assert.equal(print.closed, true);
  // What is not good looks like a warning, and is not lost among what is.
  const bad = print.lines.filter(({ good }) => !good), toast = page.locator('#toasts .toast').last();
  assert.match(await toast.getAttribute('class'), bad.length > 0 ? /toast-warning/ : /toast-info/);
  assert.equal(await toast.getAttribute('role'), bad.length > 0 ? 'alert' : 'status');
  for (const { text, good } of print.lines) assert.equal((await toast.innerText()).includes(text), bad.length === 0 || !good, text);
  await run(page, 'set-height', { mm: 1 });
  await run(page, 'check-print');
  const thin = page.locator('#toasts .toast').last();
  assert.match(await thin.getAttribute('class'), /toast-warning/);
  assert.match(await thin.innerText(), /thinnest place/);
  for (const [id, ending, magic] of [['save-picture', 'png', '89504e47'], ['save-turntable', 'gif', '47494638']]) {
    const [download] = await Promise.all([page.waitForEvent('download', { timeout: 60_000 }), run(page, id)]);
    assert.ok(download.suggestedFilename().endsWith(`.${ending}`), download.suggestedFilename());
    const chunks = [];
    for await (const chunk of await download.createReadStream()) chunks.push(chunk);
    assert.equal(Buffer.concat(chunks).subarray(0, 4).toString('hex'), magic);
  }
}));
