// Slices by real pointers: drawn on the board, dragged out of the panel, kept on the shelf, and what reaches the file.
import assert from 'node:assert/strict';
import test from 'node:test';
import { dragMouse, onBoard, placeOf, strokeAlong } from './support/hands.mjs';
import {
  done,
  exported,
  idle,
  kPhone,
  onPage,
  openPicture,
  openWithPart,
  reload,
  run,
  state,
  toClient,
  useSite,
} from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();

const withPart = (options, work) =>
  onPage(kit, options, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await work(page);
  });

const ring = (radius, count = 14) =>
  Array.from({ length: count }, (_, i) => {
    const angle = (6.15 * i) / (count - 1);
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });

/** Draws a slice with a hole on the board. */
async function drawWithHole(page, device) {
  const before = (await state(page)).undo;
  await done(page, 'edit-slice');
  for (const radius of [0.85, 0.4]) await strokeAlong(page, device, await onBoard(page, ring(radius)));
  assert.equal((await state(page)).sliceBoard.curves.length, 2);
  await done(page, 'slice-done');
  const now = await state(page);
  assert.equal(now.sliceBoard, null);
  assert.equal(now.undo, before + 1);
  assert.deepEqual([now.parts[0].slices[0].curves, now.parts[0].slices[0].holes], [1, 1]);
}

test('a slice with a hole is drawn with a finger on a phone, in one step', () =>
  withPart(kPhone, (page) => drawWithHole(page, 'finger')));

test('a slice with a hole is drawn with the mouse; it is on the shelf after a reload, and a shelf that is none does no harm', () =>
  withPart({}, async (page) => {
    await drawWithHole(page, 'mouse');
    await reload(page);
    assert.deepEqual(
      (await state(page)).shelf.map((slice) => slice.name),
      ['My slice 1'],
    );
    await page.evaluate(() => localStorage.setItem('spineloft.shelf.1', '{'));
    await reload(page);
    assert.deepEqual((await state(page)).shelf, []);
  }));

test('a slice is dragged out of the panel onto the part; Escape leaves it where it was', () =>
  withPart({}, async (page) => {
    const slices = async () => (await state(page)).parts[0].slices;
    const [onBone] = await toClient(page, [tube.middle[Math.floor(tube.middle.length / 2)]]);
    const { undo } = await state(page);
    const tile = await placeOf(page, 'Star');
    const [dx, dy] = [onBone.x - tile.x, onBone.y - tile.y];
    await dragMouse(page, tile, dx, dy);
    const [start, dropped] = await slices();
    assert.equal(start.at, 0);
    assert.ok(Math.abs(dropped.at - 0.5) < 0.1, `${dropped.at}`);
    assert.equal(dropped.section, 'star');
    assert.equal((await state(page)).undo, undo + 1, 'one gesture, one step');
    await done(page, 'undo');
    await dragMouse(page, await placeOf(page, 'Star'), dx, dy, () => page.keyboard.press('Escape'));
    assert.deepEqual([(await slices()).length, (await state(page)).undo], [1, undo]);
  }));

test('a slice is dropped on the part also where no frame is drawn between the panel and the release', () =>
  withPart({}, async (page) => {
    const [onBone] = await toClient(page, [tube.middle[Math.floor(tube.middle.length / 2)]]);
    const tile = await placeOf(page, 'Star');
    await page.evaluate(
      ([from, to]) => {
        const send = (type, at, buttons) =>
          document.getElementById('canvas').dispatchEvent(
            new PointerEvent(type, {
              ...{ bubbles: true, cancelable: true, pointerId: 1, pointerType: 'mouse', isPrimary: true },
              ...{ clientX: at.x, clientY: at.y, button: type === 'pointermove' ? -1 : 0, buttons },
            }),
          );
        send('pointermove', from, 0);
        send('pointerdown', from, 1);
        send('pointermove', { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 }, 1);
        send('pointermove', to, 1);
        send('pointerup', to, 0);
      },
      [tile, onBone],
    );
    await idle(page);
    const { slices } = (await state(page)).parts[0];
    assert.deepEqual(
      slices.map(({ section }) => section),
      ['circle', 'star', 'circle'],
    );
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
  withPart({}, async (page) => {
    const round = (radius, aside = 0) =>
      Array.from({ length: 24 }, (_, i) => [
        aside + radius * Math.cos((i * Math.PI) / 12),
        radius * Math.sin((i * Math.PI) / 12),
      ]);
    await run(page, 'set-caps', { start: 'flat', end: 'flat' });
    for (const [contours, genus] of [
      [[round(1)], 0],
      [[round(1), round(0.6)], 1],
      [[round(1), round(0.3, -0.5), round(0.3, 0.5)], 2],
    ]) {
      await run(page, 'set-section', { contours });
      assert.equal(genusOf(await exported(page, 'glb')), genus, `${contours.length} curves`);
    }
  }));

test('a puff takes a ready slice with one tap, and one drawn with the pen on the board; the file has its rings', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png);
    await done(page, 'draw-puff', {
      contours: [
        [
          [100, 60],
          [380, 60],
          [380, 300],
          [100, 300],
        ],
      ],
    });
    const slice = async () => (await state(page)).parts[0].slice;
    assert.equal(await slice(), 'soft');
    const { undo } = await state(page);
    const tile = await placeOf(page, 'Ring');
    await page.mouse.click(tile.x, tile.y);
    await idle(page);
    assert.deepEqual([await slice(), (await state(page)).undo], ['ring', undo + 1]);
    assert.equal(genusOf(await exported(page, 'glb')), 1);
    await done(page, 'edit-slice', { empty: true });
    const hill = Array.from({ length: 16 }, (_, i) => [0.06 * i, 0.5 - 0.03 * i]);
    const back = Array.from({ length: 16 }, (_, i) => [0.9 - 0.06 * i, 0.05 - 0.03 * i]);
    await strokeAlong(page, 'pen', await onBoard(page, [...hill, ...back]));
    await done(page, 'slice-done');
    assert.deepEqual([await slice(), (await state(page)).undo], ['own', undo + 2]);
    assert.equal(genusOf(await exported(page, 'glb')), 0);
  }));
