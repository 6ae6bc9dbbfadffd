// Real pointers on the canvas: mouse, finger and pen, and what the panels there show to press.
import assert from 'node:assert/strict';
import { framed, idle, state, toClient } from './page.mjs';

/** At most `count` of the points, ends included: as many frames as a stroke needs, drawn in software. */
function thinned(points, count) {
  if (points.length <= count) return points;
  return Array.from({ length: count }, (_, i) => points[Math.round((i * (points.length - 1)) / (count - 1))]);
}

const kHands = {
  mouse: (page) => ({
    down: async ({ x, y }) => {
      await page.mouse.move(x, y);
      await page.mouse.down();
    },
    move: ({ x, y }) => page.mouse.move(x, y),
    up: () => page.mouse.up(),
  }),
  finger: async (page) => {
    const session = await page.context().newCDPSession(page);
    const send = (type, at) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints: at ? [{ x: at.x, y: at.y, id: 1 }] : [] });
    return {
      down: (at) => send('touchStart', at),
      move: (at) => send('touchMove', at),
      up: async () => {
        await send('touchEnd');
        await session.detach();
      },
    };
  },
  pen: async (page, force) => {
    const session = await page.context().newCDPSession(page);
    let last;
    const send = (type, at, pressure) => {
      last = at;
      return session.send('Input.dispatchMouseEvent', {
        type,
        x: at.x,
        y: at.y,
        button: 'left',
        buttons: type === 'mouseReleased' ? 0 : 1,
        clickCount: 1,
        pointerType: 'pen',
        force: pressure,
      });
    };
    return {
      down: (at) => send('mousePressed', at, force),
      move: (at) => send('mouseMoved', at, force),
      up: async () => {
        await send('mouseReleased', last, 0);
        await session.detach();
      },
    };
  },
};

/** A pointer on the page, in client pixels: `down(at)`, `move(at)`, `up()`. A pen presses with `force`, 0…1. */
export const handOf = (page, device, force = 0.6) => kHands[device](page, force);

/** A stroke along these client positions; `midway(page)` is called before its last third. */
export async function strokeAlong(page, device, path, { midway, force } = {}) {
  const hand = await handOf(page, device, force);
  await hand.down(path[0]);
  for (const [i, at] of path.entries()) {
    if (i > 0) await hand.move(at);
    if (midway && i === Math.floor(path.length * 0.7)) await midway(page);
  }
  await hand.up();
  await idle(page);
}

const drawWith =
  (device) =>
  async (page, points, { count = 7, ...options } = {}) =>
    strokeAlong(page, device, await toClient(page, thinned(points, count)), options);

/** Strokes along picture points, at most `count` of them. */
export const drawWithMouse = drawWith('mouse');
export const drawWithFinger = drawWith('finger');
export const drawWithPen = drawWith('pen');

/** `count` points from one to the other. */
export const line = ([ax, ay], [bx, by], count = 7) =>
  Array.from({ length: count }, (_, i) => [ax + ((bx - ax) * i) / (count - 1), ay + ((by - ay) * i) / (count - 1)]);

/** Drags by the mouse from a client position; `midway` is called with the button still down. */
export async function dragMouse(page, from, dx, dy, midway) {
  const hand = await handOf(page, 'mouse');
  await hand.down(from);
  for (let i = 1; i <= 5; i += 1) await hand.move({ x: from.x + (dx * i) / 5, y: from.y + (dy * i) / 5 });
  if (midway) await midway();
  await hand.up();
  await idle(page);
}

/** Fingers from some client positions to others, all at once. */
export async function dragFingers(page, from, to) {
  const session = await page.context().newCDPSession(page);
  const send = (type, points) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map((p, id) => ({ ...p, id })) });
  for (let n = 1; n <= from.length; n += 1) await send('touchStart', from.slice(0, n));
  for (let i = 1; i <= 5; i += 1) {
    await send(
      'touchMove',
      from.map((p, k) => ({ x: p.x + ((to[k].x - p.x) * i) / 5, y: p.y + ((to[k].y - p.y) * i) / 5 })),
    );
  }
  await send('touchEnd', []);
  await session.detach();
  await idle(page);
}

/** Taps with several fingers at once. */
export async function tapWith(page, fingers, at) {
  const session = await page.context().newCDPSession(page);
  const touchPoints = Array.from({ length: fingers }, (_, id) => ({ x: at.x + 70 * id, y: at.y, id }));
  // A tap is short by the events' own clock, however busy the page is.
  const timestamp = Date.now() / 1000;
  await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints, timestamp });
  await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [], timestamp: timestamp + 0.05 });
  await session.detach();
  await idle(page);
}

/** Clicks on a picture point. */
export async function clickPicture(page, point) {
  const [at] = await toClient(page, [point]);
  await page.mouse.click(at.x, at.y);
  await idle(page);
}

/** Points of the canvas in client pixels. */
export async function onCanvas(page, ...points) {
  const box = await page.locator('#canvas').boundingBox();
  return points.map(([x, y]) => ({ x: box.x + x, y: box.y + y }));
}

const middleOf = ({ at: [x, y, width, height] }) => [x + width / 2, y + height / 2];

/** Client positions of places of the square of the board for slices. */
export async function onBoard(page, points) {
  const [x, y, side] = (await state(page)).sliceBoard.square;
  const box = await page.locator('#canvas').boundingBox();
  const half = side / 2 / 1.18;
  return points.map(([px, py]) => ({ x: box.x + x + side / 2 + px * half, y: box.y + y + side / 2 - py * half }));
}

/**
 * What a panel on the canvas shows with these words, of this kind (button, row, grip, field, slider, section, tab) where
 * one is given; `row`: beside the row with that name. Null when there is none.
 */
export async function findControl(page, words, { kind, row } = {}) {
  await idle(page);
  const { controls } = await state(page);
  const beside = row && controls.find((one) => one.kind === 'row' && one.words === row);
  const level = (one) => beside === undefined || Math.abs(middleOf(one)[1] - middleOf(beside)[1]) < 2;
  const found = controls.filter(
    (one) => one.words === words && one.kind !== 'words' && (!kind || one.kind === kind) && level(one),
  );
  return found.find((one) => one.inSight) ?? found[0] ?? null;
}

/** The same, scrolled into sight by the wheel or, where `touch` is true, by a finger, and at rest. */
export async function control(page, words, { touch = false, ...which } = {}) {
  const box = await page.locator('#canvas').boundingBox();
  let before = null;
  for (let turns = 0; turns < 40; turns += 1) {
    const found = await findControl(page, words, which);
    if (!found) {
      const { controls } = await state(page);
      assert.fail(`"${words}" is not on the canvas, among ${controls.map((one) => one.words).join(' | ')}`);
    }
    const rests = before === null || `${before.at}` === `${found.at}`;
    if (found.inSight && rests) return found;
    before = found;
    if (found.inSight) {
      await framed(page);
      continue;
    }
    const [x, y] = middleOf(found);
    const [panel] = await onCanvas(page, [x, Math.min(Math.max(y, 60), box.height - 60)]);
    const isBelow = y > box.height / 2;
    if (touch) {
      await dragFingers(page, [panel], [{ x: panel.x, y: panel.y + (isBelow ? -60 : 60) }]);
      continue;
    }
    await page.mouse.move(panel.x, panel.y);
    await page.mouse.wheel(0, isBelow ? 120 : -120);
    await framed(page);
  }
  throw new Error(`"${words}" does not come into sight`);
}

/** Where to press it, in client pixels. */
export async function placeOf(page, words, which) {
  const [at] = await onCanvas(page, middleOf(await control(page, words, which)));
  return at;
}

/** Drags a slider over these shares of its width, frame by frame, a little downwards. */
export async function dragSlider(page, words, shares, device = 'mouse') {
  const { at } = await control(page, words, { kind: 'slider', touch: device === 'finger' });
  const [x, y, width, height] = at;
  const path = shares.map((share) => [x + share * width, y + height / 2 + 10 * share]);
  const [first, ...others] = await onCanvas(page, ...path);
  const pointer = await handOf(page, device);
  await pointer.down(first);
  for (const place of others) {
    await pointer.move(place);
    await framed(page);
  }
  await pointer.up();
  await idle(page);
}

/** Presses what the canvas shows with these words, with the mouse or, where `touch` is true, with a finger. */
export async function press(page, words, { touch = false, ...which } = {}) {
  const found = await control(page, words, { touch, ...which });
  assert.ok(found.enabled, `"${words}" can be pressed`);
  const [at] = await onCanvas(page, middleOf(found));
  if (touch) await page.touchscreen.tap(at.x, at.y);
  else await page.mouse.click(at.x, at.y);
  await idle(page);
}
