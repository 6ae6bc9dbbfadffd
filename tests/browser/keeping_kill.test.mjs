// P1: nothing a person drew is lost. The browser is killed with all its processes in the middle of seeded random acts, and
// each time the model comes back with all that the page had shown as done: 100 ms after an act it is on the disk, or the
// page says that it is not kept yet.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { startSite } from '../../.ci/lib/browser.mjs';
import { seeded } from '../support/random.mjs';
import { idle, kEngines, openPicture, run, toClient } from './support/page.mjs';
import { kRounds } from '../support/rounds.mjs';
import { tubePicture } from './support/pictures.mjs';
import { history, smallTube, startMortalBrowser } from './support/keeping.mjs';

const kKills = kRounds > 1 ? 200 : 12;
/** Kills until a new model is begun. */
const kModelKills = kRounds > 1 ? 20 : 4;
/** A browser that does not come up in that time fails the test instead of holding it up. */
const kPatienceMs = 180_000;
const kPromiseMs = 100;

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

/** Opens another picture, which has to be packed and put beside the model. */
const openAnother = (page, random) =>
  page.evaluate(
    ([data, name]) => window.spineloft.openImage(new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))]), name),
    [tubePicture({ width: 120, height: 90, half: 6 + 4 * random() }).png.toString('base64'), 'another.png'],
  );

/** In the page, once what was done last has reached the model and the time of the promise is over. */
const shownAsDone = (page) =>
  page.evaluate(
    (promiseMs) =>
      new Promise((resolve) => {
        const over = performance.now() + promiseMs;
        const look = () =>
          resolve({
            now: window.spineloft.history(),
            isPromised: document.getElementById('keeping')?.hidden !== false,
          });
        // Input is taken at the next frame.
        requestAnimationFrame(() =>
          requestAnimationFrame(() => setTimeout(look, Math.max(0, over - performance.now()))),
        );
      }),
    kPromiseMs,
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

/** Random things that a visitor does, each with the command that takes it back; null: the model stays as it is. */
const kActs = {
  draw: ['undo', (page, random) => drawQuickly(page, strokeOf(random))],
  slice: ['undo', (page, random) => run(page, 'set-section', { section: oneOf(random, ['circle', 'square', 'star']) })],
  ends: ['undo', (page, random) => run(page, 'set-caps', { both: oneOf(random, ['round', 'flat', 'pointed']) })],
  name: ['undo', (page, random) => run(page, 'rename-model', { name: `Model ${Math.floor(random() * 1e6)}` })],
  place: ['undo', (page, random) => run(page, 'move-parts', { mm: [20 * random() - 10, 0, 5] })],
  photo: ['undo', openAnother],
  stick: ['undo', (page) => run(page, 'stick-together', { parts: [1, 2] })],
  release: ['undo', (page) => run(page, 'release')],
  erase: ['undo', (page) => page.keyboard.press('Delete')],
  undo: ['redo', (page) => page.keyboard.press('Control+z')],
  redo: ['undo', (page) => page.keyboard.press('Control+Shift+z')],
  save: [null, (page) => page.keyboard.press('Control+s')],
  'save-glb': [null, (page) => run(page, 'save-glb')],
};
/** What is done more often than the rest. */
const kOften = ['draw', 'draw', 'undo', 'undo', 'stick'];

const oneOf = (random, list) => list[Math.floor(random() * list.length)];

/** Most acts that are whole before the one in which the browser dies, or after which it does. */
const kMostWhole = 3;

/** Works until the browser is killed. `known.states` are those that were seen, the first `known.promised` shown as done. */
async function workUntilKilled({ page, kill }, random, known) {
  let isKilled = null;
  // Calls into a page that died need not ever come back.
  const gone = new Promise((resolve) => page.once('close', resolve)).then(() => {
    throw new Error('closed');
  });
  gone.catch(() => undefined);
  const untilGone = (work) => {
    work.catch(() => undefined);
    return Promise.race([work, gone]);
  };
  const doomed = Math.floor(random() * (kMostWhole + 1));
  let inHand = null;
  try {
    for (let count = 0; ; count += 1) {
      const name = oneOf(random, [...Object.keys(kActs), ...kOften]);
      const [takenBack, act] = kActs[name];
      inHand = { name, takenBack };
      if (count === doomed) setTimeout(() => (isKilled = kill()), 20 + random() * 600);
      // A refused command (nothing to undo, no part) is no act; a dead browser ends the round.
      await untilGone(act(page, random)).catch((error) => {
        if (isKilled) throw error;
      });
      const { now, isPromised } = await untilGone(shownAsDone(page));
      if (now !== known.states.at(-1)) known.states.push(now);
      if (isPromised) known.promised = known.states.length;
      inHand = null;
    }
  } catch (error) {
    if (!isKilled) throw error;
  }
  await isKilled;
  return inHand;
}

/** What came back, compared with what is known: 'whole', 'in-hand' (even the act in hand is there), 'late' or 'lost'. */
async function verdict(page, { states, promised }, inHand) {
  const back = await history(page),
    at = states.lastIndexOf(back);
  if (at === states.length - 1) return 'whole';
  if (inHand?.takenBack) {
    await run(page, inHand.takenBack).catch(() => undefined);
    const before = presentOf(await history(page)) === presentOf(states.at(-1));
    await run(page, inHand.takenBack === 'undo' ? 'redo' : 'undo').catch(() => undefined);
    if (before) return 'in-hand';
  }
  // It was said that the rest was not kept yet.
  return at >= promised - 1 ? 'late' : 'lost';
}

/** What is known of a loss, to find its cause. */
async function told(page, { states, promised }, inHand) {
  const back = await history(page);
  const steps = (text) => {
    const { past, future } = JSON.parse(text);
    return `${past?.length} steps back, ${future?.length} forth`;
  };
  return `${states.length} states, ${promised} promised, came back as ${states.indexOf(back)} (${steps(back)}; last known ${steps(states.at(-1))}), in hand ${inHand?.name ?? 'nothing'}`;
}

/** A model of two parts, which can be put together. */
async function beginModel(page) {
  await run(page, 'new-model').catch(() => undefined);
  await idle(page);
  await openPicture(page, smallTube.png, 'tube.png');
  for (const shift of [-2, 2]) {
    await run(page, 'new-part').catch(() => undefined);
    await run(page, 'draw-spine', { stroke: smallTube.middle.map(([x, y]) => [x, y + shift]) });
  }
}

test(
  `a browser that is killed ${kKills} times at random comes back each time with all that was shown as done`,
  { timeout: kKills * 30_000 },
  async (t) => {
    const folder = mkdtempSync(join(tmpdir(), 'spineloft-kill-'));
    const site = await startSite({ isolated: kEngines[0].isolated });
    const random = seeded(20261121);
    const counts = { whole: 0, 'in-hand': 0, late: 0, lost: 0 };
    let acts = 0,
      inAct = 0,
      browser = null;
    const started = Date.now();
    try {
      let known = null,
        inHand = null;
      for (let round = 0; round <= kKills; ++round) {
        browser = await startMortalBrowser(folder);
        const { page } = browser;
        await page.goto(site.url, { waitUntil: 'commit' });
        await page.waitForFunction(() => window.spineloft !== undefined);
        await patiently(
          page.evaluate(() => window.spineloft.ready),
          `starting round ${round}`,
        );
        if (known) {
          const result = await patiently(verdict(page, known, inHand), `looking at round ${round}`);
          counts[result] += 1;
          assert.notEqual(result, 'lost', `round ${round}: ${await told(page, known, inHand)}`);
        }
        if (round === kKills) break;
        if (round % kModelKills === 0) await beginModel(page);
        // What the verdict undid and did again was no hand's work: only from here on the page is in a hurry.
        await idle(page);
        known = { states: [await history(page)], promised: 1 };
        inHand = await patiently(workUntilKilled(browser, random, known), `killing in round ${round}`);
        acts += known.states.length - 1;
        inAct += inHand ? 1 : 0;
      }
      // A machine that is too slow for acts would prove nothing.
      assert.ok(acts >= kKills / 2, `${acts} acts were whole`);
      t.diagnostic(
        `${kKills} kills (${inAct} in the middle of an act), ${acts} acts, ${JSON.stringify(counts)}, ${Math.round((Date.now() - started) / 1000)} s`,
      );
    } finally {
      await browser?.kill().catch(() => undefined);
      await site.close();
      rmSync(folder, { recursive: true, force: true });
    }
  },
);
