// P1: nothing a person drew is lost. Pages are killed in the middle of seeded random gestures, and each
// time the model comes back as it was, but for the gesture in hand.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { startSite } from '../../.ci/lib/browser.mjs';
import { seeded } from '../support/random.mjs';
import { idle, kRounds, openPicture, run, toClient } from './support/page.mjs';
import { history, smallTube, startKeptBrowser } from './support/keeping.mjs';

const kKills = 25 * kRounds;
/** Kills until a new model is begun. */
const kModelKills = 20;
/** A page that cannot be killed or does not come up in that time fails the test instead of holding it up. */
const kPatienceMs = 60_000;

const presentOf = (text) => JSON.stringify(JSON.parse(text).present);

/** A line along the tube, a little different each time. */
function strokeOf(random) {
  const shift = 6 * random() - 3;
  return smallTube.middle.filter((_, i) => i % 9 === 0).map(([x, y]) => [x, y + shift]);
}

async function drawQuickly(page, stroke) {
  const path = await toClient(page, stroke);
  await page.mouse.move(path[0].x, path[0].y);
  await page.mouse.down();
  for (const at of path.slice(1)) await page.mouse.move(at.x, at.y);
  await page.mouse.up();
}

/** The history once what was pressed last has reached the model: input is taken at the next frame. */
const historyAfter = (page) =>
  page.evaluate(
    () =>
      new Promise((resolve) => {
        requestAnimationFrame(() => requestAnimationFrame(() => resolve(window.spineloft.history())));
      }),
  );

async function patiently(work, what) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`${what} took too long`)), kPatienceMs);
  });
  work.catch(() => undefined);
  try {
    return await Promise.race([work, late]);
  } finally {
    clearTimeout(timer);
  }
}

/** One random thing that a visitor does; says how it is taken back. */
function gesture(page, random) {
  const choose = (list) => list[Math.floor(random() * list.length)];
  const kinds = [
    ['undo', () => drawQuickly(page, strokeOf(random))],
    ['undo', () => drawQuickly(page, strokeOf(random))],
    ['undo', () => run(page, 'set-section', { section: choose(['circle', 'square', 'star', 'hexagon']) })],
    ['undo', () => run(page, 'set-caps', { both: choose(['round', 'flat', 'pointed', 'open']) })],
    ['undo', () => run(page, 'rename-model', { name: `Model ${Math.floor(random() * 1e6)}` })],
    ['redo', () => page.keyboard.press('Control+z')],
    ['undo', () => page.keyboard.press('Control+Shift+z')],
    ['undo', () => page.keyboard.press('Delete')],
  ];
  const kind = choose(kinds);
  const [takenBack, act] = kind;
  return { takenBack, act, kind: kinds.indexOf(kind) };
}

/** Most gestures that are whole before the one in which the page dies, or after which it does. */
const kMostWhole = 3;

/** Works until it is killed; what it knows of the model before that is in `states`. */
async function workUntilKilled(page, random, states) {
  const session = await page.context().newCDPSession(page);
  // Calls into a page that died need not ever come back: its death ends them.
  const gone = new Promise((_, reject) => {
    page.once('crash', () => reject(new Error('crashed')));
    page.once('close', () => reject(new Error('closed')));
  });
  const untilGone = (work) => {
    work.catch(() => undefined);
    return Promise.race([work, gone]);
  };
  const crash = random() < 0.75;
  const close = () => page.close({ runBeforeUnload: false }).catch(() => undefined);
  const kill = () => {
    if (crash) session.send('Page.crash').catch(close);
    else close();
  };
  const doomed = Math.floor(random() * (kMostWhole + 1));
  let inHand = null;
  try {
    for (let count = 0; ; count += 1) {
      inHand = gesture(page, random);
      if (count === doomed) setTimeout(kill, 20 + random() * 600);
      // A refused command (nothing to undo, no part) is no gesture; a dead page ends the round.
      await untilGone(inHand.act()).catch((error) => {
        if (/crash|closed/i.test(error.message)) throw error;
      });
      const now = await untilGone(historyAfter(page));
      if (now !== states.at(-1)) states.push(now);
      inHand = null;
      // No hand is quicker than this between two gestures.
      await untilGone(
        new Promise((resolve) => {
          setTimeout(resolve, 20 + random() * 60);
        }),
      );
    }
  } catch (error) {
    if (!/crash|closed|destroyed|detached/i.test(error.message)) throw error;
  }
  await gone.catch(() => undefined);
  await page.close().catch(() => undefined);
  return inHand;
}

/** What came back, compared with what is known: 'whole', 'in-hand' (even the gesture in hand is there), 'one-lost' or 'lost'. */
async function verdict(page, states, inHand) {
  const back = await history(page);
  if (back === states.at(-1)) return 'whole';
  if (inHand) {
    await run(page, inHand.takenBack).catch(() => undefined);
    const before = presentOf(await history(page)) === presentOf(states.at(-1));
    await run(page, inHand.takenBack === 'undo' ? 'redo' : 'undo').catch(() => undefined);
    if (before) return 'in-hand';
  }
  return states.length > 1 && back === states.at(-2) ? 'one-lost' : 'lost';
}

/** What is known of a loss, to find its cause. */
async function told(page, states, inHand) {
  const back = await history(page);
  const steps = (text) => {
    const { past, future } = JSON.parse(text);
    return `${past?.length} steps back, ${future?.length} forth`;
  };
  return `${states.length} states, came back as ${states.indexOf(back)} (${steps(back)}; last known ${steps(states.at(-1))}), in hand ${inHand?.kind ?? 'nothing'}`;
}

test(
  `a page that is killed ${kKills} times at random comes back each time, at most the last gesture old`,
  { timeout: kKills * 12_000 },
  async (t) => {
    const folder = mkdtempSync(join(tmpdir(), 'spineloft-kill-'));
    const site = await startSite({ isolated: false });
    const context = await startKeptBrowser(folder);
    const random = seeded(20261121);
    const counts = { whole: 0, 'in-hand': 0, 'one-lost': 0, lost: 0 };
    let gestures = 0,
      inGesture = 0;
    const started = Date.now();
    try {
      let states = null,
        inHand = null;
      for (let round = 0; round <= kKills; ++round) {
        const page = await context.newPage();
        await page.goto(`${site.url}?threads=0`, { waitUntil: 'commit' });
        await page.waitForFunction(() => window.spineloft !== undefined);
        await patiently(
          page.evaluate(() => window.spineloft.ready),
          `starting round ${round}`,
        );
        if (states) {
          const result = await patiently(verdict(page, states, inHand), `looking at round ${round}`);
          counts[result] += 1;
          assert.notEqual(result, 'lost', `round ${round}: ${await told(page, states, inHand)}`);
        }
        if (round === kKills) break;
        if (round % kModelKills === 0) {
          await run(page, 'new-model').catch(() => undefined);
          await idle(page);
          await openPicture(page, smallTube.png, 'tube.png');
        }
        // What the verdict undid and did again was no hand's work: only from here on the page is in a hurry.
        await idle(page);
        states = [await history(page)];
        inHand = await patiently(workUntilKilled(page, random, states), `killing the page of round ${round}`);
        gestures += states.length - 1;
        inGesture += inHand ? 1 : 0;
      }
      // A machine that is too slow for gestures would prove nothing.
      assert.ok(gestures >= kKills / 2, `${gestures} gestures were whole`);
      t.diagnostic(
        `${kKills} kills (${inGesture} in the middle of a gesture), ${gestures} gestures, ${JSON.stringify(counts)}, ${Math.round((Date.now() - started) / 1000)} s`,
      );
    } finally {
      await context.close();
      await site.close();
      rmSync(folder, { recursive: true, force: true });
    }
  },
);
