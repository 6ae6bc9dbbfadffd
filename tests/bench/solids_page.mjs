// How long the solver of solids takes in its worker in headless Chromium, as a fresh page has it: npm run bench.
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { openPage, startBrowser } from '../../.ci/lib/browser.mjs';
import { distDir } from '../../.ci/lib/paths.mjs';
import { serveFolder } from '../../.ci/lib/server.mjs';
import { loft, turned } from '../browser/support/lofts.mjs';
import { seeded } from '../support/random.mjs';
import { busiest, workerTimes } from './worker_cpu.mjs';

const kPages = 5;
const kPresses = 3;
const kEdits = 8;
const kLater = 4;

/** Runs in the page: one worker's first large unions and edits: ms from the request to the mesh, and what the busiest worker used meanwhile. */
async function timesOf({ address, isReady, edits, later, functions }) {
  const { loft, seeded, turned } = new Function(`${functions.join('\n')}; return { loft, seeded, turned };`)();
  const fine = { rings: 64, around: 64, length: 1, radius: 0.12 };
  const random = seeded(11),
    meshes = {},
    worker = new Worker(address, { type: 'module' });
  const operands = Array.from({ length: 10 }, (_, i) => {
    meshes[`m${i}`] = loft({ ...fine, bend: random() - 0.5, wave: 0.2 * random() });
    return { mesh: `m${i}`, part: i + 1, matrix: turned(i * 0.7, 0.25 * random(), 0.25 * random(), 0.04 * random()) };
  });
  const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
  let id = 0,
    bytes = 0;
  const answer = (of, given) =>
    new Promise((resolve, reject) => {
      const start = performance.now(),
        key = `node ${(id += 1)}`;
      worker.onerror = (event) => reject(new Error(event.message));
      let ms = 0;
      worker.onmessage = ({ data }) => {
        if (data.type === 'solid' && !data.mesh) reject(new Error(data.failure.error));
        if (data.type === 'solid') ms = performance.now() - start;
        if (data.type === 'done') bytes = data.bytes;
        if (data.type === 'done') resolve(ms);
      };
      worker.postMessage({
        id,
        nodes: [
          { key, step: 1, kind: 'join', operands: of, blend: 0, wall: 0.02, opening: null, cut: 0, coarse: false },
        ],
        wanted: [key],
        meshes: given,
      });
    });
  const ask = async (of, given) => {
    await window.look();
    const ms = await answer(of, given);
    return { ms, cpu: await window.look() };
  };
  if (isReady) {
    await new Promise((resolve) => {
      worker.onmessage = ({ data }) => {
        if (data.type === 'ready') resolve();
      };
    });
  }
  const union = [await ask(operands, meshes)];
  const known = bytes;
  worker.postMessage({ expect: 2 });
  // Long enough on a busy machine, too.
  await pause(6000);
  const edit = [];
  for (let i = 0; i < edits; i += 1) {
    const mesh = `edit ${i}`;
    edit.push(
      await ask(
        operands.map((each, k) => (k === 1 ? { ...each, mesh } : each)),
        { [mesh]: loft({ ...fine, bend: 0.3, wave: 0.03 * (i + 1) }) },
      ),
    );
    await pause(200);
  }
  for (let i = 0; i < later; i += 1) {
    const anew = {},
      others = operands.map((each, k) => ({
        ...each,
        mesh: `a${i} ${k}`,
        matrix: turned(k * 0.7 + 0.1 * i, 0.25 * random(), 0.25 * random(), 0.04 * random()),
      }));
    others.forEach(({ mesh }) => {
      anew[mesh] = loft({ ...fine, bend: random() - 0.5, wave: 0.2 * random() });
    });
    union.push(await ask(others, anew));
    await pause(100);
  }
  worker.terminate();
  return { union, edit, bytes: known };
}

/** Runs in the page: edits of one of nine limbs in a body, all rounded or scooped out, after it was chosen; previews as the hand moves, too. */
async function deepTimesOf({ address, kind, edits, functions }) {
  const { loft, turned } = new Function(`${functions.join('\n')}; return { loft, turned };`)();
  const fine = { rings: 64, around: 64, length: 1 },
    worker = new Worker(address, { type: 'module' }),
    found = { preview: [], edit: [] };
  const meshes = { body: loft({ ...fine, radius: 0.12 }), limb: loft({ ...fine, radius: 0.04, bend: 0.1 }) };
  const operands = Array.from({ length: 10 }, (_, i) => ({
    mesh: i ? 'limb' : 'body',
    part: i + 1,
    matrix: i ? turned(Math.PI / 2, 0.1 * i) : turned(0),
  }));
  let id = 0;
  const ask = async (of, given, coarse) => {
    await window.look();
    const join = {
      key: `join ${(id += 1)}`,
      step: 1,
      kind: 'join',
      operands: of,
      blend: kind === 'round' ? 0.02 : 0,
      wall: 0.03,
      opening: null,
      cut: 0,
      coarse,
    };
    const nodes =
        kind === 'round'
          ? [join]
          : [
              join,
              {
                ...join,
                key: `shell ${id}`,
                step: 2,
                kind: 'hollow',
                operands: [{ node: join.key }],
                opening: [1, 0, 0],
              },
            ],
      start = performance.now();
    worker.postMessage({ id, nodes, wanted: [nodes.at(-1).key], meshes: given });
    const ms = await new Promise((resolve, reject) => {
      let at = 0;
      worker.onmessage = ({ data }) => {
        if (data.type === 'solid' && !data.mesh) reject(new Error(data.failure.error));
        if (data.type === 'solid') at = performance.now() - start;
        if (data.type === 'done') resolve(at);
      };
    });
    return { ms, cpu: await window.look() };
  };
  await ask(operands, meshes, false);
  worker.postMessage({ expect: 3 });
  await new Promise((resolve) => setTimeout(resolve, 8000));
  for (let i = 0; i < 2 * edits; i += 1) {
    const mesh = `edit ${i}`,
      coarse = i % 2 === 0;
    found[coarse ? 'preview' : 'edit'].push(
      await ask(
        operands.map((each, k) => (k === 2 ? { ...each, mesh } : each)),
        { [mesh]: loft({ ...fine, radius: 0.04, bend: 0.1, wave: 0.01 * (i + 1) }) },
        coarse,
      ),
    );
  }
  worker.terminate();
  return found;
}

/** Times in a fresh browser of the site in `folder`, once the page has started; `isReady`: of a worker that has started. */
export function freshTimes(folder, isReady) {
  return timesIn(folder, timesOf, { isReady, edits: kEdits, later: kLater });
}

/** The same of edits below a step that is no plain union: 'round' or 'scoop'. */
export function deepTimes(folder, kind) {
  return timesIn(folder, deepTimesOf, { kind, edits: kEdits });
}

async function timesIn(folder, work, given) {
  const site = await serveFolder(folder, { isolated: true }),
    browser = await startBrowser();
  try {
    const { page } = await openPage(browser, site.url);
    let seen = {};
    await page.exposeFunction('look', () => {
      const before = seen;
      return busiest(before, (seen = workerTimes()));
    });
    // Nobody has ten parts while the page itself still starts and makes its own stages quick, which keeps its messages waiting.
    await page.waitForFunction(() => performance.getEntriesByName('spineloft-warm').length > 0, null, {
      timeout: 60000,
    });
    const file = readdirSync(join(folder, 'assets')).find((name) => /^solids\.worker-.*\.js$/.test(name));
    return await page.evaluate(work, {
      ...given,
      address: `assets/${file}`,
      functions: [loft, seeded, turned].map(String),
    });
  } finally {
    await browser.close();
    await site.close();
  }
}

/** Runs in the page: from the button to the solid of ten parts that the pen made, ms. */
async function pressed() {
  const { spineloft } = window,
    pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms)),
    canvas = new OffscreenCanvas(640, 480),
    pen = canvas.getContext('2d');
  pen.fillStyle = '#fff';
  pen.fillRect(0, 0, 640, 480);
  // A lattice: five bars across five others.
  pen.fillStyle = '#456';
  const bars = [0, 1, 2, 3, 4].flatMap((i) => [
    [
      [60, 80 + 80 * i],
      [580, 80 + 80 * i],
    ],
    [
      [120 + 100 * i, 40],
      [120 + 100 * i, 440],
    ],
  ]);
  for (const [[x, y], [right, below]] of bars) pen.fillRect(x - 14, y - 14, right - x + 28, below - y + 28);
  await spineloft.openImage(await canvas.convertToBlob(), 'lattice');
  for (const [[x, y], [right, below]] of bars) {
    const stroke = Array.from({ length: 30 }, (_, k) => [x + ((right - x) * k) / 29, y + ((below - y) * k) / 29]);
    await spineloft.run('draw-spine', { stroke });
    await spineloft.idle();
  }
  const parts = spineloft.state().parts.map(({ id }) => id);
  await pause(3000);
  // Until the model has it, not until it is drawn, which without a graphics card takes longer.
  const start = performance.now(),
    drawn = spineloft.run('stick-together', { parts });
  while (!['ready', 'failed'].includes(spineloft.state().steps[0]?.status)) await pause(0);
  const ms = performance.now() - start,
    [{ status }] = spineloft.state().steps;
  if (status !== 'ready') throw new Error(`The benchmark's solid is ${status}.`);
  await drawn;
  return ms;
}

/** Times in a fresh browser of the site in `folder`, from the button to the solid. */
async function pressTimes(folder) {
  const site = await serveFolder(folder, { isolated: true }),
    browser = await startBrowser();
  try {
    const { page } = await openPage(browser, site.url);
    return await page.evaluate(pressed);
  } finally {
    await browser.close();
    await site.close();
  }
}

function summary(times) {
  const sorted = [...times].sort((a, b) => a - b);
  return { min_ms: sorted[0], median_ms: sorted[sorted.length >> 1], count: sorted.length };
}

/** The same with the median of what the busiest worker used of the processor, where that is known. */
function withProcessor(found) {
  const known = found.map(({ cpu }) => cpu).filter((cpu) => cpu !== null);
  return { ...summary(found.map(({ ms }) => ms)), ...(known.length > 0 ? { cpu_ms: summary(known).median_ms } : {}) };
}

/** Previews as the hand moves, and what they take of the solid that follows. */
function previewTimes(found) {
  const previews = withProcessor(found.flatMap(({ preview }) => preview));
  const full = summary(found.flatMap(({ edit }) => edit.slice(1)).map(({ ms }) => ms));
  return { ...previews, share_of_full: previews.median_ms / full.median_ms };
}

/** Times by name, {min_ms, median_ms, count}, some with cpu_ms, previews with share_of_full; dist/ must be built. */
export async function solidPageTimes(folder = distDir) {
  const cold = [],
    ready = [],
    pressedOnes = [],
    round = [],
    scoop = [];
  for (let i = 0; i < kPages; i += 1) {
    cold.push(await freshTimes(folder, false));
    ready.push(await freshTimes(folder, true));
  }
  for (let i = 0; i < kPresses; i += 1) {
    round.push(await deepTimes(folder, 'round'));
    scoop.push(await deepTimes(folder, 'scoop'));
    pressedOnes.push(await pressTimes(folder));
  }
  return {
    'stick ten lofts of 8,192 triangles together, a fresh worker': withProcessor(cold.map(({ union }) => union[0])),
    'the same, a worker that has started': withProcessor(ready.map(({ union }) => union[0])),
    'stick others together later': withProcessor([...cold, ...ready].flatMap(({ union }) => union.slice(1))),
    'the first rib of one of ten after it was chosen': withProcessor([...cold, ...ready].map(({ edit }) => edit[0])),
    'ribs after that': withProcessor([...cold, ...ready].flatMap(({ edit }) => edit.slice(1))),
    'the first rib of one of ten with rounded seams': withProcessor(round.map(({ edit }) => edit[0])),
    'ribs of it after that': withProcessor(round.flatMap(({ edit }) => edit.slice(1))),
    'a preview of it': previewTimes(round),
    'the first rib of one of ten that are scooped out': withProcessor(scoop.map(({ edit }) => edit[0])),
    'ribs of those after that': withProcessor(scoop.flatMap(({ edit }) => edit.slice(1))),
    'a preview of those': previewTimes(scoop),
    'from the button to the first solid, of a lattice of ten parts that the pen made': summary(pressedOnes),
  };
}

if (import.meta.filename === process.argv[1])
  process.stdout.write(`${JSON.stringify(await solidPageTimes(), null, 2)}\n`);
