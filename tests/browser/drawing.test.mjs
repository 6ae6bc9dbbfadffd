// The main job, on both engines: one stroke becomes a solid while it is drawn, and leaves as a file that others open.
import assert from 'node:assert/strict';
import test from 'node:test';
import { measure, parseObj, parseStl, validated } from './support/model_files.mjs';
import {
  difference,
  drawWithMouse,
  exported,
  idle,
  kEngines,
  onPage,
  openPicture,
  pixels,
  run,
  state,
  toastText,
  useSite,
} from './support/page.mjs';
import { dataCases, paintedPng, samples, tubePicture } from './support/pictures.mjs';
import { loadWithThree } from './support/three.mjs';

const kit = useSite();
const tube = tubePicture();

async function withTube(engine, work) {
  await onPage(kit, { isolated: engine.isolated }, async (page, opened) => {
    await openPicture(page, tube.png, 'tube.png');
    await work(page, opened);
  });
}

/** The columns of a screenshot from one to another. */
function columns(shot, from, to) {
  const rows = Array.from({ length: shot.height }, (_, y) =>
    shot.data.subarray(4 * (y * shot.width + from), 4 * (y * shot.width + to)),
  );
  return { data: Buffer.concat(rows) };
}

for (const engine of kEngines) {
  test(`${engine.name}: the page says which engine runs`, () =>
    withTube(engine, async (page) => {
      const { threads, version } = await state(page);
      assert.equal(threads > 0, engine.isolated, `threads: ${threads}`);
      assert.match(version, /^\d+\.\d+\.\d+/);
      assert.equal(await page.evaluate(() => crossOriginIsolated), engine.isolated);
    }));

  test(`${engine.name}: ribs and solid appear while the pen moves`, () =>
    withTube(engine, async (page) => {
      const view = { x: 0, y: 60, width: 860, height: 560 };
      const empty = await pixels(page, view);
      await drawWithMouse(page, tube.middle, async () => {
        await page.waitForTimeout(400);
        const { preview } = await state(page);
        assert.ok(preview.ribs > 5 && preview.triangles > 100, JSON.stringify(preview));
        const during = await pixels(page, view);
        const split = Math.floor(view.width / 2);
        const [onPicture, beside] = [
          (shot) => columns(shot, 0, split - 20),
          (shot) => columns(shot, split + 20, view.width),
        ];
        assert.ok(difference(onPicture(empty), onPicture(during)) > 0.003, 'ribs grow on the picture');
        assert.ok(difference(beside(empty), beside(during)) > 0.01, 'a solid grows beside it');
      });
      const { parts, selection, undo, redo, lastMs, busy } = await state(page);
      assert.equal(parts.length, 1);
      const [part] = parts;
      assert.equal(selection, part.id);
      assert.deepEqual([part.kind, part.section, undo > 0, redo, busy], ['loft', 'circle', true, 0, false]);
      assert.ok(part.triangles > 200 && lastMs.ribs >= 0 && lastMs.loft >= 0 && lastMs.edges > 0);
      for (const rib of part.ribs.slice(3, -3)) {
        const width = Math.hypot(rib.left[0] - rib.right[0], rib.left[1] - rib.right[1]);
        assert.ok(Math.abs(width - 2 * tube.half) < 12, `rib of ${width} px on a tube of ${2 * tube.half}`);
        assert.deepEqual(
          [rib.leftState, rib.rightState].filter((side) => !['edge', 'bridged', 'guessed'].includes(side)),
          [],
        );
      }
    }));

  test(`${engine.name}: a line drawn past the ends of a thing stops where the thing does, and says so`, () =>
    onPage(kit, { isolated: engine.isolated }, async (page) => {
      const [from, to, middle, half] = [100, 380, 180, 30];
      const bar = paintedPng(480, 360, (x, y) =>
        x >= from && x <= to && Math.abs(y - middle) <= half ? [60, 90, 150] : [235, 230, 220],
      );
      await openPicture(page, bar, 'bar.png');
      const along = (first, last) => Array.from({ length: 30 }, (_, i) => [first + ((last - first) * i) / 29, middle]);
      const drawn = async (points) => {
        await drawWithMouse(page, points);
        await idle(page);
        return (await state(page)).parts.at(-1).ribs;
      };
      const past = await drawn(along(from - 40, to + 50));
      assert.match(await toastText(page, 'status'), /past the end/);
      for (const rib of past) {
        for (const [x] of [rib.left, rib.right]) assert.ok(x > from - 4 && x < to + 4, `a rib at ${x}`);
      }
      assert.ok(
        Math.min(...past.map((rib) => rib.left[0])) < from + 20 &&
          Math.max(...past.map((rib) => rib.left[0])) > to - 20,
        'and it reaches the ends',
      );
      const beside = await drawn(along(from - 40, to + 50));
      assert.ok(
        beside[0].center[0] < from - 30,
        'beside a part a line stays as it is: it may be meant to reach into it',
      );
      await run(page, 'undo');
      await run(page, 'undo');
      const within = await drawn(along(from + 30, to - 30));
      assert.ok(
        Math.abs(within[0].center[0] - (from + 30)) < 3 && Math.abs(within.at(-1).center[0] - (to - 30)) < 3,
        'a line on the thing stays as it is',
      );
    }));

  test(`${engine.name}: undo and redo by button, key and API`, () =>
    withTube(engine, async (page) => {
      await drawWithMouse(page, tube.middle);
      const drawn = (await state(page)).parts;
      const count = async () => (await state(page)).parts.length;
      await page.keyboard.press('Control+z');
      await idle(page);
      assert.equal(await count(), 0);
      await page.locator('[data-command=redo]').click();
      await idle(page);
      assert.deepEqual((await state(page)).parts, drawn);
      await page.locator('[data-command=undo]').click();
      assert.equal(await count(), 0);
      await run(page, 'redo');
      await idle(page);
      assert.deepEqual((await state(page)).parts, drawn);
      const failure = await page.evaluate(() =>
        window.spineloft.run('redo').then(
          () => null,
          (error) => error.code,
        ),
      );
      assert.notEqual(failure, null);
    }));

  test(`${engine.name}: slice and ends change the solid that is saved`, () =>
    withTube(engine, async (page) => {
      await drawWithMouse(page, tube.middle);
      const volume = async () => measure(parseStl(await exported(page, 'stl'))).volume;
      const round = await volume();
      await run(page, 'set-section', { section: 'square' });
      await idle(page);
      const square = await volume();
      assert.ok(square > 1.15 * round && square < 1.45 * round, `a square holds 4/π of a circle: ${square / round}`);
      assert.equal((await state(page)).parts[0].section, 'square');
      await run(page, 'set-caps', { start: 'flat', end: 'pointed' });
      await idle(page);
      assert.deepEqual((await state(page)).parts[0].caps, { start: 'flat', end: 'pointed' });
      assert.notEqual(await volume(), square);
      await run(page, 'undo');
      await run(page, 'undo');
      await idle(page);
      assert.equal(await volume(), round);
    }));

  test(`${engine.name}: GLB passes the validator and loads in three.js; OBJ and STL agree with it`, () =>
    withTube(engine, async (page) => {
      await drawWithMouse(page, tube.middle);
      const glb = await exported(page, 'glb');
      const info = await validated(glb);
      assert.equal(
        info.resources.filter((resource) => resource.mimeType?.startsWith('image/')).length,
        1,
        'the picture is on the part',
      );
      const loaded = await loadWithThree(kit.browser, glb);
      const stl = measure(parseStl(await exported(page, 'stl')));
      const obj = measure(parseObj(await exported(page, 'obj')));
      assert.equal(loaded.triangles, stl.triangles);
      assert.equal(obj.triangles, stl.triangles);
      assert.equal((await state(page)).parts[0].triangles, stl.triangles);
      assert.ok(stl.volume > 0 && obj.volume > 0 && loaded.volume > 0, 'outward');
      assert.equal(loaded.textured, true);
      // GLB in metres with y up; STL in millimetres with z up, as printers have it.
      const [width, height, depth] = loaded.size.map((side) => side * 1000);
      for (const [k, side] of [width, depth, height].entries()) {
        assert.ok(Math.abs(side - stl.size[k]) < 0.001 * side, `GLB ${loaded.size} m, STL ${stl.size} mm`);
      }
      await run(page, 'set-height', { mm: 250 });
      await idle(page);
      const tall = measure(parseStl(await exported(page, 'stl')));
      assert.ok(Math.abs(tall.size[2] - 250) < 0.01, `height ${tall.size[2]} mm`);
    }));

  test(`${engine.name}: a plain part has its colour and no picture`, () =>
    withTube(engine, async (page) => {
      await drawWithMouse(page, tube.middle);
      await run(page, 'set-colour', { colour: '#2457d6' });
      await idle(page);
      const glb = await exported(page, 'glb');
      const info = await validated(glb);
      assert.deepEqual(
        (info.resources ?? []).filter((resource) => resource.mimeType?.startsWith('image/')),
        [],
      );
      assert.equal((await loadWithThree(kit.browser, glb)).textured, false);
    }));

  test(`${engine.name}: several parts, each selected, renamed, hidden and deleted`, () =>
    withTube(engine, async (page) => {
      const middle = Math.floor(tube.middle.length / 2);
      await drawWithMouse(page, tube.middle.slice(0, middle));
      await run(page, 'new-part');
      await drawWithMouse(page, tube.middle.slice(middle));
      let { parts, selection } = await state(page);
      assert.equal(parts.length, 2);
      assert.equal(selection, parts[1].id);
      await run(page, 'select-part', { id: parts[0].id });
      await run(page, 'rename-part', { name: 'Häls & tail' });
      const both = measure(parseStl(await exported(page, 'stl'))).triangles;
      await run(page, 'show-part', { visible: false });
      await idle(page);
      assert.ok(measure(parseStl(await exported(page, 'stl'))).triangles < both, 'hidden parts are not saved');
      await page.keyboard.press('Delete');
      await idle(page);
      ({ parts } = await state(page));
      assert.equal(parts.length, 1);
      await run(page, 'undo');
      await idle(page);
      assert.equal((await state(page)).parts[0].name, 'Häls & tail');
      await validated(await exported(page, 'glb'));
    }));

  for (const picture of [
    ...samples()
      .slice(0, 3)
      .map((s) => ({ ...s, name: s.id })),
    ...dataCases(['photo_bottle', 'photo_swan_neck']),
  ]) {
    test(`${engine.name}: "${picture.name}" from one stroke, as a valid GLB`, () =>
      onPage(kit, { isolated: engine.isolated }, async (page) => {
        await openPicture(page, picture.bytes, picture.name);
        await drawWithMouse(page, picture.spine);
        assert.equal((await state(page)).parts.length, 1);
        await validated(await exported(page, 'glb'));
      }));
  }
}

test('strokes that make no part say why and change nothing', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    const before = await state(page);
    const codes = {};
    const strokes = {
      StrokeTooShort: [[10, 10]],
      StrokeOutsidePicture: [
        [-900, -900],
        [-800, -900],
        [-700, -880],
      ],
      StrokeLoops: Array.from({ length: 60 }, (_, i) => [240 + 90 * Math.cos(i / 6), 180 + 90 * Math.sin(i / 6)]),
    };
    for (const [code, stroke] of Object.entries(strokes)) {
      codes[code] = await page.evaluate(
        (points) =>
          window.spineloft.run('draw-spine', { stroke: points }).then(
            () => 'no error',
            (error) => (error.message.length > 10 ? error.code : 'no sentence'),
          ),
        stroke,
      );
    }
    assert.deepEqual(codes, {
      StrokeTooShort: 'StrokeTooShort',
      StrokeOutsidePicture: 'StrokeOutsidePicture',
      StrokeLoops: 'StrokeLoops',
    });
    const { parts, undo } = await state(page);
    assert.deepEqual([parts, undo], [[], before.undo]);
    const empty = await page.evaluate(() =>
      window.spineloft.exportModel('glb').then(
        () => null,
        (error) => error.code,
      ),
    );
    assert.equal(empty, 'NothingToExport');
    const unknown = await page.evaluate(() =>
      window.spineloft.exportModel('dwg').then(
        () => null,
        (error) => error.code,
      ),
    );
    assert.equal(unknown, 'ValueOutOfRange');
  }));

test("Save offers a file that has the model's name", () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await drawWithMouse(page, tube.middle);
    assert.equal((await state(page)).unsaved, true);
    const coming = page.waitForEvent('download');
    await page.locator('#bar-save').click();
    await page.getByRole('menuitem', { name: /GLB/ }).click();
    const file = await coming;
    assert.match(file.suggestedFilename(), /\.glb$/);
    await page.waitForFunction(() => window.spineloft.state().unsaved === false);
    await run(page, 'set-section', { section: 'hexagon' });
    assert.equal((await state(page)).unsaved, true);
  }));

test('what is changed while a file is written stays unsaved', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await drawWithMouse(page, tube.middle);
    const coming = page.waitForEvent('download');
    await page.evaluate(() =>
      Promise.all([window.spineloft.run('save-project'), window.spineloft.run('set-section', { section: 'hexagon' })]),
    );
    await coming;
    await page.getByText(/^Saved tube\.spineloft/).waitFor();
    assert.equal((await state(page)).unsaved, true);
    await run(page, 'undo');
    assert.equal((await state(page)).unsaved, false, 'the file holds what was there when it was saved');
  }));
