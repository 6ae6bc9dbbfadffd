// A part in no solid that goes through itself: what is saved does not, by the real solver in its worker.
import assert from 'node:assert/strict';
import test from 'node:test';
import { parseStl } from './support/model_files.mjs';
import { done, exported, onPage, openWithPart, state, useSite } from './support/page.mjs';
import { samples } from './support/pictures.mjs';
import { deepest, diagonal, measure } from './support/solids.mjs';

const kit = useSite();
const [lemur] = samples();

/** Corners of one place are one vertex. */
function welded(corners) {
  const places = new Map(),
    positions = [];
  const triangles = Uint32Array.from(corners, ([x, y, z]) => {
    const key = `${x} ${y} ${z}`;
    if (!places.has(key)) {
      places.set(key, positions.length / 3);
      positions.push(x, y, z);
    }
    return places.get(key);
  });
  return { positions: Float32Array.from(positions), triangles };
}

test('a lone part that is coiled through itself is saved as a solid that does not, and looks as it did', () =>
  onPage(kit, {}, async (page) => {
    await openWithPart(page, lemur.bytes, lemur.spine, 'lemur');
    assert.equal((await state(page)).parts[0].mended, false);
    await done(page, 'coil', { turns: 20, radius: 110 });
    const [before] = (await state(page)).parts;
    const mesh = welded(parseStl(await exported(page, 'stl')).flat());
    const [part] = (await state(page)).parts;
    assert.deepEqual([part.mended, part.crossesAt, part.triangles], [true, null, before.triangles]);
    // The solver keeps to a millionth of the size; millimetres as floats round a little.
    assert.ok(deepest(mesh.positions, mesh.triangles) <= 1.5e-6 * diagonal(mesh.positions));
    assert.ok(measure(mesh).volume > 0);
  }));
