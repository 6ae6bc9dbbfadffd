// Line drawings by real pointers: a body, two half hidden legs and a tail, bridges, rings and pens. What else the tool
// does is said by tests/unit/web/line_tool_test.cpp.
import assert from 'node:assert/strict';
import test from 'node:test';
import { findControl, onCanvas, press, strokeAlong } from './support/hands.mjs';
import { sample } from '../support/rounds.mjs';
import { exported, idle, kDesk, kHands, onPage, reload, run, state, toClient, useSite } from './support/page.mjs';

const kit = useSite();

const kBody = { x: 300, y: 190, a: 150, b: 90 };
/** A closed line, picture pixels. */
const ellipse = (x, y, a, b, count = 24) =>
  Array.from({ length: count + 1 }, (_, i) => {
    const t = (2 * Math.PI * i) / count;
    return [x + a * Math.sin(t), y + b * Math.cos(t)];
  });
const belly = (x) => kBody.y + kBody.b * Math.sqrt(1 - ((x - kBody.x) / kBody.a) ** 2);

/** What is seen of a leg of this width: from the belly down and back up. */
function leg(x, width = 44, foot = 390) {
  const down = [0, 0.3, 0.6, 0.9].map((t) => [x, belly(x) + (foot - belly(x)) * t]);
  const round = [0.1, 0.3, 0.5, 0.7, 0.9].map((t) => [
    x + (width / 2) * (1 - Math.cos(Math.PI * t)),
    foot + 22 * Math.sin(Math.PI * t),
  ]);
  const up = [0.9, 0.6, 0.3, 0].map((t) => [x + width, belly(x + width) + (foot - belly(x + width)) * t]);
  return [...down, ...round, ...up];
}
/** The rest of it, behind the body. */
const hip = (x, width = 44) =>
  [0, 0.25, 0.5, 0.75, 1].map((t) => [
    x + width * (1 - t),
    belly(x + width * (1 - t)) - 46 * Math.sin(Math.PI * t) - (t > 0 && t < 1 ? 4 : 0),
  ]);

const draw = async (page, device, points) => strokeAlong(page, device, await toClient(page, points));
const tapAt = async (page, device, place) => {
  const [at] = await onCanvas(page, place);
  await strokeAlong(page, device, [at]);
};

/** The model as it is saved. */
const model = (page) => exported(page, 'spineloft');

/** Body, legs and tail: six strokes, and the pens between them. */
async function drawCreature(page, device) {
  const tap = (words) => press(page, words, { touch: device === 'finger', kind: 'button' });
  await draw(page, device, ellipse(kBody.x, kBody.y, kBody.a, kBody.b, 32));
  for (const x of [215, 340]) {
    if (x !== 215) await tap('Seen');
    await draw(page, device, leg(x));
    await tap('Hidden');
    await draw(page, device, hip(x));
  }
  await tap('Seen');
  await draw(page, device, ellipse(480, 150, 56, 22));
}

async function paper(page, device) {
  await run(page, 'new-sketch', { width: 600, height: 450 });
  await idle(page);
  // What the page shows first is for the device that was used last.
  const [corner] = await toClient(page, [[5, 5]]);
  await strokeAlong(page, device, [corner]);
  const touch = device === 'finger';
  if (!(await findControl(page, 'Lines'))) await press(page, 'More', { touch }); // a phone has not room for all
  await press(page, 'Lines', { touch });
}

const pairs = (bridges) => bridges.map(({ over, under }) => [over, under]);

for (const [device, size, options] of sample(kHands, 0)) {
  test(`a body, two half hidden legs and a tail; a bridge swaps there only; undone to the start: ${device}, ${size}`, () =>
    onPage(kit, options, async (page) => {
      await paper(page, device);
      const start = await model(page);
      const { undo } = await state(page);
      await drawCreature(page, device);
      let now = await state(page);
      assert.equal(now.parts.length, 4);
      assert.equal(now.undo, undo + 6, 'each stroke is one step');
      for (const part of now.parts) {
        assert.equal(part.kind, 'element');
        assert.equal(part.failure, null);
        assert.ok(part.triangles > 500);
      }
      const [drawing] = now.drawings;
      assert.equal(drawing.lines.length, 6);
      assert.deepEqual(drawing.openEnds, []);
      assert.deepEqual(
        drawing.pieces.map(({ outlines }) => outlines[0].map(({ line }) => line).sort()),
        [[1], [2, 3], [4, 5], [6]],
      );
      // Both legs are behind the body, as their lines say.
      const legs = drawing.orders.filter(({ under }) => under === 2 || under === 3);
      assert.deepEqual(
        legs.map(({ over, from }) => [over, from]),
        [
          [1, 'drawn'],
          [1, 'drawn'],
        ],
      );
      assert.equal(now.bridges.length, 3);
      const which = now.bridges.findIndex(({ under }) => under === 2);
      const before = pairs(now.bridges);
      await tapAt(page, device, now.bridges[which].at);
      now = await state(page);
      assert.deepEqual(
        pairs(now.bridges),
        before.map(([over, under], i) => (i === which ? [under, over] : [over, under])),
      );
      assert.equal(now.undo, undo + 7);
      for (let i = 0; i < 7; i += 1) await run(page, 'undo');
      await idle(page);
      assert.equal((await state(page)).parts.length, 0);
      assert.ok((await model(page)).equals(start), 'byte-equal');
    }));
}

test('a line that is not closed waits with a ring, which a tap closes; the barrel of a pen is the hidden pen', () =>
  onPage(kit, kDesk, async (page) => {
    await paper(page, 'pen');
    await draw(page, 'pen', [
      [200, 150],
      [170, 200],
      [180, 260],
      [220, 300],
      [260, 290],
    ]);
    let now = await state(page);
    assert.equal(now.parts.length, 0);
    assert.equal(now.lineEnds.length, 2);
    await tapAt(page, 'pen', now.lineEnds[1]);
    now = await state(page);
    assert.equal(now.parts.length, 1);
    assert.deepEqual(now.lineEnds, []);
    const path = await toClient(page, ellipse(400, 200, 60, 60));
    const session = await page.context().newCDPSession(page);
    const send = (type, { x, y }, buttons) =>
      session.send('Input.dispatchMouseEvent', {
        type,
        x,
        y,
        button: 'right',
        buttons,
        clickCount: 1,
        pointerType: 'pen',
        force: 0.5,
      });
    await send('mousePressed', path[0], 2);
    for (const at of path.slice(1)) await send('mouseMoved', at, 2);
    await send('mouseReleased', path.at(-1), 0);
    await session.detach();
    await idle(page);
    const { drawings, parts } = await state(page);
    assert.equal(parts.length, 2);
    assert.deepEqual(drawings[0].lines[1].hidden, [[0, 1]]);
  }));

test('bridges by keyboard and by a screen reader; round and flat; a reload and the GLB have all of it', () =>
  onPage(kit, { alone: true }, async (page) => {
    await run(page, 'new-sketch', { width: 600, height: 450 });
    await idle(page);
    await page.locator('#canvas').focus();
    await page.keyboard.press('Shift+L');
    await idle(page);
    assert.equal((await state(page)).tool, 'lines');
    const lines = [
      [ellipse(kBody.x, kBody.y, kBody.a, kBody.b, 32).slice(0, -1), false, true],
      [leg(215), false, false],
      [hip(215), true, false],
      [ellipse(480, 150, 56, 22).slice(0, -1), false, true],
    ];
    for (const [points, hidden, closed] of lines) await run(page, 'draw-line', { points, hidden, closed });
    await idle(page);
    const before = (await state(page)).bridges;
    assert.equal(before.length, 2);
    await page.locator('#canvas').focus();
    await page.keyboard.press('.');
    await idle(page);
    assert.equal((await state(page)).chosen.bridge, 0);
    await page.keyboard.press('Enter');
    await idle(page);
    assert.deepEqual(pairs((await state(page)).bridges)[0], pairs(before)[0].toReversed());
    await page.getByRole('button', { name: 'Part 2 is in front of Part 1 here. Swap them here.' }).press('Enter');
    await idle(page);
    assert.deepEqual(pairs((await state(page)).bridges), pairs(before));
    await run(page, 'select-part', { part: 3 });
    await press(page, 'Flat', { kind: 'button' });
    assert.equal((await state(page)).drawings[0].pieces[2].kind, 'flat');
    await run(page, 'pin-depth', { line: 2, at: 0.5, z: 30 });
    await idle(page);
    const kept = (await state(page)).drawings;
    const glb = await exported(page, 'glb');
    assert.ok(glb.length > 5000);
    await reload(page);
    assert.deepEqual((await state(page)).drawings, kept);
    assert.ok((await exported(page, 'glb')).equals(glb));
    await run(page, 'undo');
    await run(page, 'undo');
    await run(page, 'redo');
    await run(page, 'redo');
    await idle(page);
    assert.ok((await exported(page, 'glb')).equals(glb));
  }));

/** The nine edges of a box that are seen, each drawn by a hand that trembles by 2 pixels. */
const kBoxCorners = [
  [180, 150],
  [330, 185],
  [420, 135],
  [276, 108],
  [180, 300],
  [330, 345],
  [420, 285],
];
const kBoxEdges = [
  [0, 1],
  [1, 2],
  [2, 3],
  [3, 0],
  [0, 4],
  [1, 5],
  [2, 6],
  [4, 5],
  [5, 6],
];
const edge = ([from, to], k) =>
  Array.from({ length: 9 }, (_, i) =>
    [0, 1].map((axis) => {
      const [a, b] = [kBoxCorners[from][axis], kBoxCorners[to][axis]];
      return a + ((b - a) * i) / 8 + 2 * Math.sin(7 * i + 3 * k + 2 * axis);
    }),
  );

for (const [device, size, options] of sample(kHands, 4)) {
  test(`the nine seen edges of a box make a box with plane faces, which is undone line by line: ${device}, ${size}`, () =>
    onPage(kit, options, async (page) => {
      await paper(page, device);
      for (const [k, ends] of kBoxEdges.entries()) await draw(page, device, edge(ends, k));
      await idle(page);
      const { drawings, parts } = await state(page);
      assert.equal(parts.length, 1);
      assert.equal(drawings[0].lines.length, 12);
      assert.equal(drawings[0].pieces[0].kind, 'solid');
      assert.equal(drawings[0].pieces[0].outlines.length, 6);
      const before = await model(page);
      await run(page, 'undo');
      await idle(page);
      assert.equal((await state(page)).drawings[0].lines.length, 8);
      await run(page, 'redo');
      await idle(page);
      assert.ok((await model(page)).equals(before));
      await run(page, 'shape-piece', { kind: 'round' });
      await idle(page);
      assert.equal((await state(page)).drawings[0].pieces[0].outlines.length, 1);
      await run(page, 'shape-piece', { kind: 'solid' });
      await idle(page);
      assert.ok((await model(page)).equals(before));
      await reload(page);
      assert.equal((await state(page)).drawings[0].pieces[0].kind, 'solid');
    }));

  test(`legs without hidden lines go behind the body; a dot is dragged nearer; all of it undone: ${device}, ${size}`, () =>
    onPage(kit, options, async (page) => {
      await paper(page, device);
      const start = await model(page);
      await draw(page, device, ellipse(kBody.x, kBody.y, kBody.a, kBody.b, 32));
      for (const x of [215, 340]) await draw(page, device, leg(x));
      const { drawings, parts, undo, depthDots } = await state(page);
      assert.equal(parts.length, 3);
      assert.deepEqual(
        drawings[0].orders.map(({ over, under, from }) => [over, under, from]),
        [
          [1, 2, 'drawn'],
          [1, 3, 'drawn'],
        ],
      );
      assert.ok(depthDots.length > 4, 'the leg in hand has dots');
      const lowest = depthDots.reduce((a, b) => (b.at[1] > a.at[1] ? b : a));
      const from = lowest.at;
      await strokeAlong(
        page,
        device,
        await onCanvas(page, ...[0, 10, 20, 30, 40].map((by) => [from[0] - by, from[1] + by / 4])),
      );
      await idle(page);
      const after = await state(page);
      assert.equal(after.undo, undo + 1);
      assert.equal(after.drawings[0].pins.length, 1);
      assert.ok(Math.abs(after.drawings[0].pins[0].z - lowest.z) > 5);
      assert.equal(after.depthDots[0].pinned, true);
      for (let i = 0; i < 4; i += 1) await run(page, 'undo');
      await idle(page);
      assert.ok((await model(page)).equals(start), 'byte-equal');
    }));
}

test('a box drawn from above leans until it is stood upright from its panel', () =>
  onPage(kit, kDesk, async (page) => {
    await paper(page, 'mouse');
    for (const [k, ends] of kBoxEdges.entries()) await draw(page, 'mouse', edge(ends, k));
    await idle(page);
    await press(page, 'Stand upright', { kind: 'button' });
    await idle(page);
    const { parts } = await state(page);
    const [w] = parts[0].placement.turn;
    assert.ok(w < 0.99 && w > 0.8, 'turned by 16 to 74 degrees');
    assert.equal(await findControl(page, 'Stand upright'), null);
  }));

/** Drawn with the front as it is and what goes back slanted: strokes by the corners they lead through. */
const kObliques = {
  'a box': {
    strokes: [
      '200,250 400,250 400,450 200,450 200,250',
      '200,250 270,180',
      '400,250 470,180',
      '400,450 470,380',
      '270,180 470,180 470,380',
    ],
    faces: 6,
  },
  'a house': {
    strokes: [
      '200,300 300,180 400,300 400,450 200,450 200,300',
      '300,180 420,110',
      '400,300 520,230',
      '400,450 520,380',
      '420,110 520,230 520,380',
    ],
    faces: 7,
  },
  'a tent': {
    strokes: ['200,400 300,220 400,400 200,400', '300,220 420,160', '400,400 520,340', '420,160 520,340'],
    faces: 5,
  },
  'a stair': {
    strokes: [
      '150,200 250,200 250,300 350,300 350,400 150,400 150,200',
      '150,200 210,150',
      '250,200 310,150',
      '250,300 310,250',
      '350,300 410,250',
      '350,400 410,350',
      '210,150 310,150 310,250 410,250 410,350',
    ],
    faces: 8,
  },
};
const stroke = (corners) => {
  const places = corners.split(' ').map((place) => place.split(',').map(Number));
  return places
    .slice(1)
    .flatMap((to, k) =>
      Array.from({ length: 9 }, (_, i) =>
        [0, 1].map(
          (axis) => places[k][axis] + ((to[axis] - places[k][axis]) * i) / 8 + 2 * Math.sin(5 * i + 3 * k + 2 * axis),
        ),
      ),
    );
};
for (const [what, { strokes, faces }] of sample(Object.entries(kObliques), 3)) {
  test(`${what} with its front drawn as it is becomes one piece with plane faces`, () =>
    onPage(kit, kDesk, async (page) => {
      await paper(page, 'mouse');
      for (const corners of strokes) await draw(page, 'mouse', stroke(corners));
      await idle(page);
      const { drawings, parts } = await state(page);
      assert.equal(parts.length, 1);
      assert.equal(drawings[0].pieces[0].kind, 'solid');
      assert.equal(drawings[0].pieces[0].outlines.length, faces);
    }));
}
