// What a user gets: a saved GLB looks from the front as its picture does, pixel by pixel, and its atlas is sound.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { promisify } from 'node:util';
import { program, readObj } from '../support/cli.mjs';
import { atlasUse, frontView, likeness, placeOf, withoutRim } from '../support/front_view.mjs';
import { dataFolder } from '../../.ci/lib/paths.mjs';
import { frontViewer } from './support/front_view.mjs';
import { kTapPipes } from './support/model_strokes.mjs';
import { exported, idle, onPage, openPicture, run, state, useSite } from './support/page.mjs';

const kit = useSite();
const spawned = promisify(execFile);
/** Photos and renderings of the data folder: sketches have no surface to compare. */
const cases = (dataFolder ? readdirSync(dataFolder) : [])
  .filter((name) => /^(photo|render)_/.test(name) && existsSync(join(dataFolder, name, 'case.json')))
  .sort()
  .map((name) => {
    const file = (...names) =>
      join(
        dataFolder,
        name,
        names.find((each) => existsSync(join(dataFolder, name, each))),
      );
    const about = JSON.parse(readFileSync(file('case.json'), 'utf8'));
    return {
      name,
      image: file(about.image),
      mask: readFileSync(file('mask_visible.png', 'mask.png')),
      spine: about.spines.careful,
    };
  });

/** Texels around what is used that a filter may reach, and the most on a side of an atlas. */
const kReach = 6,
  kMostSide = 4096;

function isSoundAtlas(seen, name) {
  assert.deepEqual([seen.images, seen.drawn, seen.plain], [1, 1, 0], `${name}: one image that all wear`);
  assert.ok(seen.width <= kMostSide && seen.height <= kMostSide, `${name}: ${seen.width} × ${seen.height}`);
  assert.ok(seen.least >= 0 && seen.greatest <= 1, `${name}: UV from ${seen.least} to ${seen.greatest}`);
  assert.ok(seen.apart >= 2 * kReach, `${name}: ${seen.apart} texels between pictures of the atlas`);
  assert.equal(seen.bare, 0, `${name}: bare texels within reach of used ones`);
}

/** The GLB of a careful stroke, and the box around it in the picture, by the command line. */
async function lofted({ name, image, spine }) {
  const stroke = kit.file(`${name}.json`, JSON.stringify(spine)),
    glb = kit.file(`${name}.glb`, ''),
    obj = kit.file(`${name}.obj`, '');
  await Promise.all(
    [
      ['--out', glb],
      ['--out', obj, '--obj-space', 'image'],
    ].map((out) => spawned(program, ['loft', image, '--stroke', stroke, ...out])),
  );
  const { vertices } = readObj(obj),
    range = (pick) =>
      [0, 1].map((axis) => vertices.reduce((most, vertex) => pick(most, vertex[axis]), vertices[0][axis]));
  return { glb: readFileSync(glb), box: [range(Math.min), range(Math.max)] };
}

test(
  'parts saved by the command line look from the front as their pictures do, nearly all to 30 dB wherever a pixel is wholly inside',
  { skip: cases.length === 0 },
  async (t) => {
    const viewer = await frontViewer(kit.browser);
    try {
      let good = 0,
        clean = 0,
        sum = 0,
        next = lofted(cases[0]);
      for (const [i, each] of cases.entries()) {
        const { glb, box } = await next;
        next = i + 1 < cases.length ? lofted(cases[i + 1]) : null;
        const seen = await viewer.look({
          glb,
          picture: readFileSync(each.image),
          mask: each.mask,
          known: { box },
          reach: kReach,
        });
        t.diagnostic(
          `${each.name}: wholly inside ${seen.within.decibels.toFixed(1)} dB, with the rim ${seen.whole.decibels.toFixed(1)} dB`,
        );
        isSoundAtlas(seen, each.name);
        assert.ok(seen.within.pixels > 5000, `${each.name}: ${seen.within.pixels} pixels are compared`);
        assert.ok(seen.whole.decibels >= 20, `${each.name}: ${seen.whole.decibels} dB with its rim`);
        clean += seen.within.decibels >= 30 ? 1 : 0;
        sum += seen.within.decibels;
        good += seen.whole.decibels >= 30 ? 1 : 0;
      }
      // The outlines of a pale vase and of a noisy palm are not found exactly: what is taken for ground is partly theirs.
      assert.ok(clean >= cases.length - 2, `${clean} of ${cases.length} have 30 dB wholly inside`);
      // The atlas is packed so lightly that it hardly counts.
      assert.ok(sum / cases.length >= 39, `${sum / cases.length} dB wholly inside in the mean`);
      // Of the outermost pixels of the palm, the dutar and the bottle a good part is ground.
      assert.ok(good >= cases.length - 3, `${good} of ${cases.length} have 30 dB with their rims`);
    } finally {
      await viewer.close();
    }
  },
);

/** A flat square over all of a picture, of which it wears the block from `from` to `to`. */
function square(picture, from, to) {
  const uv = [
    [from, from],
    [to, from],
    [to, to],
    [from, to],
  ].flatMap(([x, y]) => [x / picture.width, y / picture.height]);
  return { positions: [1, 5, 0, 3, 5, 0, 3, 3, 0, 1, 3, 0], uv, corners: [0, 1, 2, 0, 2, 3], picture };
}

/** White, with a dark block of grain. */
function blockOnWhite(side, from, to) {
  const data = new Uint8Array(4 * side * side).fill(255),
    grain = (x, y) => 20 + ((37 * x + 91 * y) % 120);
  for (let y = from; y < to; y += 1)
    for (let x = from; x < to; x += 1) data.fill(grain(x, y), 4 * (y * side + x), 4 * (y * side + x) + 3);
  return { width: side, height: side, data };
}

test('what draws the front view gives a picture back as it is, sees one that is off by a pixel, and finds texels without padding', () => {
  const picture = blockOnWhite(40, 0, 40),
    place = placeOf(
      [
        [-0.5, -0.5],
        [39.5, 39.5],
      ],
      [
        [1, 5],
        [3, 3],
      ],
    ),
    all = () => true;
  const view = frontView([square(picture, 0, 40)], picture, place);
  assert.deepEqual(
    [likeness(view, picture, all).pixels, withoutRim(view, (i) => view.owner[i] >= 0).reduce((sum, one) => sum + one)],
    [1600, 38 * 38],
  );
  assert.ok(likeness(view, picture, all).decibels > 60);
  assert.ok(likeness(frontView([square(picture, 1, 39)], picture, place), picture, all).decibels < 25);
  const around = (from, to) => atlasUse([square(blockOnWhite(40, from, to), 15, 25)], kReach);
  assert.deepEqual([around(9, 31).bare, around(9, 31).least, around(9, 31).greatest], [0, 15 / 40, 25 / 40]);
  assert.ok(around(10, 30).bare > 0);
});

/** Two flat squares in corners of the picture: they tell where it lies in the file, whatever stands there. */
const kMarks = [
  [
    [20, 20],
    [60, 20],
    [60, 60],
    [20, 60],
  ],
  [
    [900, 660],
    [940, 660],
    [940, 700],
    [900, 700],
  ],
];

const tap = cases.find(({ name }) => name === 'render_faucet_spout');

test(
  'a tap of three pipes stuck together on the page looks from the front as its picture does, seams and all',
  { skip: !tap },
  (t) =>
    onPage(kit, {}, async (page) => {
      const viewer = await frontViewer(kit.browser);
      try {
        const picture = readFileSync(tap.image);
        await openPicture(page, picture, 'tap');
        for (const stroke of kTapPipes) await run(page, 'draw-spine', { stroke });
        await run(page, 'stick-together', { parts: [1, 2, 3] });
        for (const contour of kMarks) await run(page, 'draw-sheet', { contours: [contour] });
        for (const [how, round] of [
          ['sharp', 0],
          ['rounded', 6],
        ]) {
          if (round > 0)
            await run(page, 'set-step', {
              step: (await state(page)).steps.find((step) => step.root).id,
              blendMm: round,
            });
          await idle(page);
          assert.equal((await state(page)).steps.find((step) => step.root).status, 'ready');
          const seen = await viewer.look({
            glb: await exported(page, 'glb'),
            picture,
            known: { box: [kMarks[0][0], kMarks[1][2]], meshes: ['Part_4', 'Part_5'] },
            reach: kReach,
          });
          t.diagnostic(
            `seams ${how}: wholly inside ${seen.within.decibels.toFixed(1)} dB, with the rim ${seen.whole.decibels.toFixed(1)} dB`,
          );
          isSoundAtlas(seen, how);
          assert.ok(seen.within.pixels > 150_000, `${seen.within.pixels} pixels are compared`);
          assert.ok(
            seen.within.decibels >= 30 && seen.whole.decibels >= 30,
            `${how}: ${seen.within.decibels} dB wholly inside, ${seen.whole.decibels} dB with the rim`,
          );
        }
      } finally {
        await viewer.close();
      }
    }),
);
