// Slices and curves by hand in the panel, and what of it reaches the file.
import assert from 'node:assert/strict';
import test from 'node:test';
import { exported, idle, onPage, openPicture, run, state, toClient, useSite } from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();

async function withPart(work) {
  // High enough for all of the panel to be seen without scrolling.
  await onPage(kit, { isolated: false, viewport: { width: 1280, height: 1100 } }, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await run(page, 'draw-spine', { stroke: tube.middle });
    await idle(page);
    await work(page);
  });
}

const slices = async (page) => (await state(page)).parts[0].slices;

/** Where the cursor is this one, going down the middle of the panel's column. */
async function findByCursor(page, cursor) {
  const box = await page.locator('#canvas').boundingBox();
  const x = box.x + box.width - 120;
  const found = [];
  for (let y = box.y + 20; y < box.y + box.height - 4; y += 6) {
    await page.mouse.move(x, y);
    const now = await page.evaluate(() => getComputedStyle(document.querySelector('#canvas')).cursor);
    if (now === cursor) found.push({ x, y });
  }
  return found;
}

/** Presses, moves in steps, and lifts unless told otherwise. */
async function drag(page, from, to, { lift = true } = {}) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let i = 1; i <= 8; ++i) {
    await page.mouse.move(from.x + ((to.x - from.x) * i) / 8, from.y + ((to.y - from.y) * i) / 8);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  }
  if (lift) await page.mouse.up();
  await idle(page);
}

/** A tile of a slice: a press there, carried to the bone, becomes a slice of the part. */
async function findTile(page, onBone) {
  const box = await page.locator('#canvas').boundingBox();
  for (let y = box.y + 60; y < box.y + box.height - 40; y += 26) {
    const from = { x: box.x + box.width - 120, y };
    await drag(page, from, onBone);
    if ((await slices(page)).length > 1) return from;
  }
  return null;
}

test('a slice is dragged out of the panel onto the part; Escape and the right button leave it where it was', () =>
  withPart(async (page) => {
    const [onBone] = await toClient(page, [tube.middle[Math.floor(tube.middle.length / 2)]]);
    const undo = (await state(page)).undo;
    const tile = await findTile(page, onBone);
    assert.ok(tile, 'no tile could be dragged');
    const [start, dropped] = await slices(page);
    assert.equal(start.at, 0);
    assert.ok(Math.abs(dropped.at - 0.5) < 0.1, `${dropped.at}`);
    assert.equal((await state(page)).undo, undo + 1, 'one gesture, one step');
    await run(page, 'undo');
    await drag(page, tile, onBone, { lift: false });
    await page.keyboard.press('Escape');
    await page.mouse.up();
    await idle(page);
    const now = await state(page);
    assert.deepEqual([now.parts[0].slices.length, now.undo], [1, undo]);
  }));

test('a graph that is dragged is one step, and changes the file that is saved', () =>
  withPart(async (page) => {
    await run(page, 'show-along', { kind: 'squash' });
    await idle(page);
    const before = await exported(page, 'glb');
    const undo = (await state(page)).undo;
    const graph = await findByCursor(page, 'pointer');
    assert.ok(graph.length >= 8, `${graph.length} places over a graph`);
    const middle = graph[Math.floor(graph.length / 2)],
      foot = graph.at(-2);
    await drag(page, middle, { x: middle.x, y: foot.y });
    const now = await state(page);
    assert.equal(now.undo, undo + 1);
    const after = await exported(page, 'glb');
    assert.ok(!after.equals(before));
    await drag(page, middle, graph[1], { lift: false });
    await page.keyboard.press('Escape');
    await page.mouse.up();
    await idle(page);
    assert.ok(after.equals(await exported(page, 'glb')), 'Escape leaves the curve as it was');
    await run(page, 'undo');
    assert.ok(before.equals(await exported(page, 'glb')));
  }));

/** Genus over all meshes of a GLB, from the Euler number of its triangles; corners in one place are one. */
function genusOf(glb) {
  const json = JSON.parse(glb.toString('utf8', 20, 20 + glb.readUInt32LE(12)));
  const binary = glb.subarray(20 + glb.readUInt32LE(12) + 8);
  const view = (index) => {
    const accessor = json.accessors[index];
    const { byteOffset = 0 } = json.bufferViews[accessor.bufferView];
    return { ...accessor, from: byteOffset + (accessor.byteOffset ?? 0) };
  };
  const places = new Map();
  const edges = new Set();
  let faces = 0;
  for (const { attributes, indices } of json.meshes.flatMap((mesh) => mesh.primitives)) {
    const position = view(attributes.POSITION),
      index = view(indices);
    const place = Array.from({ length: position.count }, (_, i) => {
      const key = binary.toString('hex', position.from + 12 * i, position.from + 12 * i + 12);
      if (!places.has(key)) places.set(key, places.size);
      return places.get(key);
    });
    const wide = index.componentType === 5125;
    const corner = (i) =>
      place[wide ? binary.readUInt32LE(index.from + 4 * i) : binary.readUInt16LE(index.from + 2 * i)];
    for (let i = 0; i < index.count; i += 3) {
      const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
      for (const [p, q] of [
        [a, b],
        [b, c],
        [c, a],
      ])
        edges.add(p < q ? `${p} ${q}` : `${q} ${p}`);
      ++faces;
    }
  }
  return (2 - (places.size - edges.size + faces)) / 2;
}

test('a drawn slice with a hole is a tube in the file: genus 1; without, genus 0', () =>
  withPart(async (page) => {
    const ring = (radius) =>
      Array.from({ length: 24 }, (_, i) => [
        radius * Math.cos((i * Math.PI) / 12),
        radius * Math.sin((i * Math.PI) / 12),
      ]);
    await run(page, 'set-caps', { start: 'flat', end: 'flat' });
    for (const [contours, genus] of [
      [[ring(1)], 0],
      [[ring(1), ring(0.6)], 1],
      [[ring(1), ring(0.3).map(([x, y]) => [x - 0.5, y]), ring(0.3).map(([x, y]) => [x + 0.5, y])], 2],
    ]) {
      await run(page, 'set-section', { contours });
      await idle(page);
      assert.equal(genusOf(await exported(page, 'glb')), genus, `${contours.length} curves`);
    }
  }));
