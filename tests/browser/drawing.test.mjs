// The main job: one stroke becomes a solid while it is drawn, and leaves as a file that others open.
import assert from 'node:assert/strict';
import test from 'node:test';
import { drawWithMouse, line } from './support/hands.mjs';
import { measure, parseObj, parseStl, validated } from './support/model_files.mjs';
import {
  difference,
  done,
  downloaded,
  exported,
  idle,
  kEngines,
  onPage,
  openPicture,
  openWithPart,
  pixels,
  refusal,
  run,
  state,
  toastText,
  useSite,
} from './support/page.mjs';
import { dataCases, paintedPng, tubePicture } from './support/pictures.mjs';
import { loadWithThree } from './support/three.mjs';

const kit = useSite();
const tube = tubePicture();

const withTube = (work) =>
  onPage(kit, {}, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await work(page);
  });

/** The columns of a screenshot from one to another. */
function columns(shot, from, to) {
  const rows = Array.from({ length: shot.height }, (_, y) =>
    shot.data.subarray(4 * (y * shot.width + from), 4 * (y * shot.width + to)),
  );
  return { data: Buffer.concat(rows) };
}

const measuredStl = async (page) => measure(parseStl(await exported(page, 'stl')));

for (const { name, isolated } of kEngines) {
  test(`${name}: the page says which engine runs; ribs and solid appear while the pen moves, and are saved`, () =>
    onPage(kit, { draws: true, ...(isolated === kEngines[0].isolated ? {} : { isolated }) }, async (page) => {
      const { threads, version } = await state(page);
      assert.equal(threads > 0, isolated, `threads: ${threads}`);
      assert.match(version, /^\d+\.\d+\.\d+/);
      assert.equal(await page.evaluate(() => crossOriginIsolated), isolated);
      await openPicture(page, tube.png, 'tube.png');
      const view = { x: 0, y: 60, width: 860, height: 560 };
      const empty = await pixels(page, view);
      await drawWithMouse(page, tube.middle, {
        midway: async () => {
          await page.waitForFunction(() => window.spineloft.state().preview?.fresh);
          const { preview } = await state(page);
          assert.ok(preview.ribs > 5 && preview.triangles > 100, JSON.stringify(preview));
          const during = await pixels(page, view),
            split = during.width / 2,
            gap = Math.round(during.width / 40);
          const onPicture = (shot) => columns(shot, 0, split - gap),
            beside = (shot) => columns(shot, split + gap, during.width);
          assert.ok(difference(onPicture(empty), onPicture(during)) > 0.003, 'ribs grow on the picture');
          assert.ok(difference(beside(empty), beside(during)) > 0.01, 'a solid grows beside it');
        },
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
        for (const side of [rib.leftState, rib.rightState])
          assert.ok(['edge', 'bridged', 'guessed'].includes(side), side);
      }
      const info = await validated(await exported(page, 'glb'));
      assert.equal(info.totalTriangleCount, part.triangles);
    }));
}

test('a line drawn past the ends of a thing stops where the thing does, and says so', () =>
  onPage(kit, {}, async (page) => {
    const [from, to, middle, half] = [100, 380, 180, 30];
    const bar = paintedPng(480, 360, (x, y) =>
      x >= from && x <= to && Math.abs(y - middle) <= half ? [60, 90, 150] : [235, 230, 220],
    );
    await openPicture(page, bar, 'bar.png');
    const drawn = async (first, last) => {
      await drawWithMouse(page, line([first, middle], [last, middle]));
      return (await state(page)).parts.at(-1).ribs;
    };
    const past = await drawn(from - 40, to + 50);
    assert.match(await toastText(page, 'status'), /past the end/);
    for (const rib of past) {
      // To a quarter of the width: the line ran on by two thirds of it and more.
      for (const [x] of [rib.left, rib.right]) assert.ok(x > from - half / 2 && x < to + half / 2, `a rib at ${x}`);
    }
    const lefts = past.map((rib) => rib.left[0]);
    assert.ok(Math.min(...lefts) < from + 20 && Math.max(...lefts) > to - 20, 'and it reaches the ends');
    const beside = await drawn(from - 40, to + 50);
    assert.ok(beside[0].center[0] < from - 30, 'beside a part a line stays as it is: it may be meant to reach into it');
    await run(page, 'undo');
    await run(page, 'undo');
    const within = await drawn(from + 30, to - 30);
    assert.ok(
      Math.abs(within[0].center[0] - (from + 30)) < 3 && Math.abs(within.at(-1).center[0] - (to - 30)) < 3,
      'a line on the thing stays as it is',
    );
  }));

test('undo and redo by button, key and API', () =>
  withTube(async (page) => {
    const drawn = (await state(page)).parts;
    const count = async () => (await state(page)).parts.length;
    const bar = (id) => page.locator(`#bar-items [data-command=${id}]`);
    await page.keyboard.press('Control+z');
    await idle(page);
    assert.equal(await count(), 0);
    await bar('redo').click();
    await idle(page);
    assert.deepEqual((await state(page)).parts, drawn);
    await bar('undo').click();
    assert.equal(await count(), 0);
    await done(page, 'redo');
    assert.deepEqual((await state(page)).parts, drawn);
    assert.notEqual(await refusal(page, 'redo'), null);
  }));

test('slice and ends change the solid that is saved', () =>
  withTube(async (page) => {
    const volume = async () => (await measuredStl(page)).volume;
    const round = await volume();
    await run(page, 'set-section', { section: 'square' });
    const square = await volume();
    assert.ok(square > 1.15 * round && square < 1.45 * round, `a square holds 4/π of a circle: ${square / round}`);
    assert.equal((await state(page)).parts[0].section, 'square');
    await run(page, 'set-caps', { start: 'flat', end: 'pointed' });
    assert.deepEqual((await state(page)).parts[0].caps, { start: 'flat', end: 'pointed' });
    assert.notEqual(await volume(), square);
    await run(page, 'undo');
    await run(page, 'undo');
    assert.equal(await volume(), round);
    // The next part is made like the last one: later tests on this page want a circle again.
    await run(page, 'set-section', { section: 'circle' });
    await run(page, 'set-caps', { both: 'round' });
  }));

test('GLB passes the validator and loads in three.js; OBJ and STL agree with it', () =>
  withTube(async (page) => {
    const glb = await exported(page, 'glb');
    const info = await validated(glb);
    assert.equal(
      info.resources.filter((resource) => resource.mimeType?.startsWith('image/')).length,
      1,
      'the picture is on the part',
    );
    const loaded = await loadWithThree(kit.browser, glb);
    const stl = await measuredStl(page);
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
    const tall = await measuredStl(page);
    assert.ok(Math.abs(tall.size[2] - 250) < 0.01, `height ${tall.size[2]} mm`);
  }));

test('several parts, each selected, renamed, hidden and deleted', () =>
  onPage(kit, {}, async (page) => {
    const middle = Math.floor(tube.middle.length / 2);
    await openWithPart(page, tube.png, tube.middle.slice(0, middle));
    await run(page, 'new-part');
    await run(page, 'draw-spine', { stroke: tube.middle.slice(middle) });
    let { parts, selection } = await state(page);
    assert.equal(parts.length, 2);
    assert.equal(selection, parts[1].id);
    await run(page, 'select-part', { id: parts[0].id });
    await run(page, 'rename-part', { name: 'Häls & tail' });
    const both = (await measuredStl(page)).triangles;
    await run(page, 'show-part', { visible: false });
    assert.ok((await measuredStl(page)).triangles < both, 'hidden parts are not saved');
    await page.keyboard.press('Delete');
    await idle(page);
    ({ parts } = await state(page));
    assert.equal(parts.length, 1);
    await done(page, 'undo');
    assert.equal((await state(page)).parts[0].name, 'Häls & tail');
    await validated(await exported(page, 'glb'));
  }));

for (const picture of dataCases(['photo_bottle', 'photo_swan_neck'])) {
  test(`"${picture.name}" from one stroke of the mouse, as a valid GLB`, () =>
    onPage(kit, {}, async (page) => {
      await openPicture(page, picture.bytes, picture.name);
      await drawWithMouse(page, picture.spine, { count: 18 });
      assert.equal((await state(page)).parts.length, 1);
      await validated(await exported(page, 'glb'));
    }));
}

test('strokes that make no part say why and change nothing', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    const before = await state(page);
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
      const refused = await page.evaluate(
        (points) =>
          window.spineloft.run('draw-spine', { stroke: points }).then(
            () => 'no error',
            (error) => (error.message.length > 10 ? error.code : 'no sentence'),
          ),
        stroke,
      );
      assert.equal(refused, code);
    }
    const { parts, undo } = await state(page);
    assert.deepEqual([parts, undo], [[], before.undo]);
    const refusedExport = (format) =>
      page.evaluate(
        (kind) =>
          window.spineloft.exportModel(kind).then(
            () => null,
            (error) => error.code,
          ),
        format,
      );
    assert.equal(await refusedExport('glb'), 'NothingToExport');
    assert.equal(await refusedExport('dwg'), 'ValueOutOfRange');
  }));

test("Save offers a file that has the model's name", () =>
  withTube(async (page) => {
    assert.equal((await state(page)).unsaved, true);
    const file = await downloaded(page, async () => {
      await page.locator('#bar-save').click();
      await page.getByRole('menuitem', { name: /GLB/ }).click();
    });
    assert.match(file.name, /^tube.*\.glb$/);
    await page.waitForFunction(() => window.spineloft.state().unsaved === false);
    await run(page, 'set-section', { section: 'hexagon' });
    assert.equal((await state(page)).unsaved, true);
    await run(page, 'set-section', { section: 'circle' });
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

// The last one: what is drawn after it is plain, too.
test('a plain part has its colour and no picture', () =>
  withTube(async (page) => {
    await run(page, 'set-colour', { colour: '#2457d6' });
    const glb = await exported(page, 'glb');
    const info = await validated(glb);
    assert.deepEqual(
      (info.resources ?? []).filter((resource) => resource.mimeType?.startsWith('image/')),
      [],
    );
    assert.equal((await loadWithThree(kit.browser, glb)).textured, false);
  }));
