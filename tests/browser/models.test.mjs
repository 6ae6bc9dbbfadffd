// Whole models from real pictures, made as a visitor makes them, by pointers, buttons, menus and questions alone: a mug,
// a tap and a swan. With $SPINELOFT_PICTURES naming a folder, screenshots and the saved files go there.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { kRounds } from '../support/rounds.mjs';
import { measure, parse3mf, parseStl, validated } from './support/model_files.mjs';
import { drawWithMouse, press } from './support/hands.mjs';
import { kSwan, kTapPipes } from './support/model_strokes.mjs';
import {
  answer,
  chooseFromMore,
  chooseFromSearch,
  done,
  dropFiles,
  exported,
  idle,
  onPage,
  pressBar,
  state,
  toClient,
  useSite,
  waitForPicture,
} from './support/page.mjs';
import { dataCases } from './support/pictures.mjs';
import { isImported, isSliced, isWholeToAdmesh, missing } from '../support/readers.mjs';

const kit = useSite();
const kept = process.env.SPINELOFT_PICTURES;
const model = (title, name, work) => {
  const [found] = dataCases([name]);
  const options = { skip: found ? false : `there is no case ${name} in the data folder` };
  test(title, options, (t) =>
    onPage(kit, { alone: true, viewport: { width: 1440, height: 900 } }, async (page) => {
      await dropFiles(page, [kit.file(`${name}.png`, found.bytes)]);
      await waitForPicture(page);
      const { millimetres } = await work(page);
      await isRead(t, page, name, millimetres);
    }),
  );
};
/** In `npm run test:all`. */
const furtherModel = kRounds > 1 ? model : () => undefined;

/** What is saved is sound to the programs that people take it to. */
async function isRead(t, page, name, millimetres) {
  const files = {};
  for (const format of ['glb', 'stl', '3mf'])
    files[format] = kit.file(`${name}.${format}`, await exported(page, format));
  await t.test('admesh has nothing to mend', { skip: missing('admesh') }, () =>
    isWholeToAdmesh(files.stl, millimetres),
  );
  // What is in the STL is in the 3MF; one of the models is sliced from both.
  for (const format of name === 'sketch_mug' ? ['stl', '3mf'] : ['3mf']) {
    await t.test(`PrusaSlicer slices the ${format.toUpperCase()}`, { skip: missing('prusa-slicer') }, () =>
      isSliced(files[format], millimetres, kit.file(`${name}.gcode`, '')),
    );
  }
  await t.test('Blender imports the GLB, closed', { skip: missing('blender') }, () =>
    isImported(files.glb, millimetres),
  );
}

/** A stroke of as many points as these models need. */
const draw = (page, points) => drawWithMouse(page, points, { count: 12 });

/** A stroke of the pen for a new part; its ends by the bar's word, or each by that of the panel. */
async function loft(page, points, ends) {
  if ((await state(page)).parts.length > 0) await pressBar(page, 'new-part');
  await draw(page, dense(points));
  if (typeof ends === 'string') await pressBar(page, 'set-caps', ends);
  else for (const end of ends ?? []) await press(page, end);
}

/** Types a number of the part in hand under "Place". */
async function place(page, field, text) {
  await press(page, field, { kind: 'field' });
  await answer(page, text);
}

/** What is before is behind, too. */
async function alikeInDepth(page) {
  await press(page, 'Symmetry');
  await press(page, 'Front and back');
}

/** A tap on what is at this place of the picture. */
async function tapPicture(page, point, modifiers) {
  const [at] = await toClient(page, [point]);
  for (const key of modifiers ?? []) await page.keyboard.down(key);
  await page.mouse.click(at.x, at.y);
  for (const key of modifiers ?? []) await page.keyboard.up(key);
  await idle(page);
}

async function tall(page, text) {
  await chooseFromSearch(page, 'How tall?');
  await answer(page, text);
}

/** A hand does not jump from corner to corner. */
function dense(points) {
  return points
    .slice(1)
    .flatMap(([x, y], i) => {
      const [px, py] = points[i];
      return [0, 1, 2].map((k) => [px + ((x - px) * k) / 3, py + ((y - py) * k) / 3]);
    })
    .concat([points.at(-1)]);
}

/** For looking only: the solid from where these turns lead, and the files. */
async function keep(page, name, turns) {
  if (!kept) return;
  mkdirSync(kept, { recursive: true });
  for (const id of ['draw', 'focus-solid', ...turns]) await done(page, id);
  while (await page.locator('#toasts button').count()) await page.locator('#toasts button').first().click();
  await page.waitForTimeout(300);
  await page.screenshot({ path: join(kept, `${name}.png`) });
  for (const format of ['glb', 'stl', '3mf'])
    writeFileSync(join(kept, `${name}.${format}`), await exported(page, format));
}

/** The one solid on the board: `millimetres` tall, closed, outward, one piece of `genus` handles, and a sound GLB. */
async function isWhole(page, { millimetres, genus }) {
  const { steps, heightMm } = await state(page),
    root = steps.find((step) => step.root);
  assert.equal(heightMm, millimetres);
  assert.deepEqual([root.status, root.failure, root.genus], ['ready', null, genus]);
  const { open, unsound, volume, size, pieces } = measure(parseStl(await exported(page, 'stl')));
  assert.equal(open, 0, 'closed');
  assert.equal(unsound, 0, 'two faces at every edge when corners are joined by place');
  assert.equal(pieces, 1, 'one piece');
  assert.ok(volume > 0, 'outward');
  assert.ok(Math.abs(size[2] - millimetres) < 0.01, `${size[2]} mm tall`);
  await validated(await exported(page, 'glb'));
  const objects = parse3mf(await exported(page, '3mf')).map(measure);
  assert.deepEqual(
    objects.map((object) => [object.open, object.pieces]),
    [[0, 1]],
    'one closed object in the 3MF',
  );
  await done(page, 'check-print'); // for asserting only: models are made by hand
  assert.ok((await state(page)).print.closed);
  return { millimetres };
}

model('a mug with its handle, scooped out', 'sketch_mug', async (page) => {
  await loft(
    page,
    [
      [300, 200],
      [310, 300],
      [318, 600],
      [318, 800],
    ],
    'Flat',
  );
  await loft(
    page,
    [
      [580, 185],
      [640, 175],
      [715, 220],
      [730, 350],
      [705, 480],
      [660, 570],
      [560, 620],
    ],
    'Round',
  );
  assert.deepEqual(
    (await state(page)).parts.map(({ caps }) => caps),
    [
      { start: 'flat', end: 'flat' },
      { start: 'round', end: 'round' },
    ],
  );
  const full = measure(parseStl(await exported(page, 'stl'))).volume;
  await tapPicture(page, [400, 500]);
  assert.equal((await state(page)).selection, 1, 'a tap takes the body');
  await chooseFromMore(page, 'Scoop out');
  assert.deepEqual((await state(page)).steps, [], 'shown before it is done');
  await done(page, 'hollow-open', { opening: 'start' });
  await page.locator('#canvas').focus();
  await page.keyboard.press('Enter');
  await idle(page);
  await chooseFromMore(page, 'Stick together');
  assert.ok(measure(parseStl(await exported(page, 'stl'))).volume < 0.5 * full, 'most of the body is air');
  await tall(page, '9.5 cm');
  const made = await isWhole(page, { millimetres: 95, genus: 1 });
  await keep(page, 'mug', ['turn-down', 'turn-down', 'turn-down', 'turn-left']);
  return made;
});

furtherModel('a tap of three pipes, taken in hand by taps in the picture', 'render_faucet_spout', async (page) => {
  const [body, neck, handle] = kTapPipes;
  await loft(page, body, 'Flat');
  await loft(page, neck);
  await loft(page, handle);
  await tapPicture(page, [650, 459]);
  await tapPicture(page, [452, 290], ['Shift']);
  await tapPicture(page, [330, 80], ['Shift']);
  assert.deepEqual((await state(page)).selected, [1, 2, 3]);
  await chooseFromMore(page, 'Stick together');
  await tall(page, '8 cm');
  const made = await isWhole(page, { millimetres: 80, genus: 0 });
  await keep(page, 'tap', ['turn-left', 'turn-left']);
  return made;
});

furtherModel('a swan of lofts, puffs and wings, ticked in the list', 'photo_swan_neck', async (page) => {
  await loft(page, kSwan.neck, 'Round');
  await loft(page, kSwan.beak, ['Round, where you began', 'Pointed, where you stopped']);
  await press(page, 'Puff');
  await draw(page, kSwan.body);
  await draw(page, kSwan.eye);
  await place(page, 'Front', '7');
  await alikeInDepth(page);
  await press(page, 'Flat piece');
  await draw(page, kSwan.wing);
  await place(page, 'Front', '26');
  await place(page, 'Turn', '-6');
  await alikeInDepth(page);
  const { parts } = await state(page);
  assert.deepEqual(
    parts.map((part) => part.kind),
    ['loft', 'loft', 'puff', 'puff', 'sheet'],
  );
  assert.deepEqual(
    parts.slice(0, 2).map((part) => part.caps.end),
    ['round', 'pointed'],
  );
  assert.deepEqual(
    parts.map((part) => part.mirror?.slice(3) ?? null),
    [null, null, null, [0, 0, 1], [0, 0, 1]],
  );
  assert.ok(Math.abs(parts[3].placement.mm[2] - 7) < 0.01 && Math.abs(parts[4].placement.mm[2] - 26) < 0.01);
  for (const id of [3, 1, 2, 4, 5])
    await press(page, 'Tick it, to put it together with others', { row: parts.find((part) => part.id === id).name });
  await press(page, 'Stick together');
  await tall(page, '12 cm');
  const made = await isWhole(page, { millimetres: 120, genus: 0 });
  await keep(page, 'swan', ['turn-left', 'turn-left', 'turn-up']);
  return made;
});
