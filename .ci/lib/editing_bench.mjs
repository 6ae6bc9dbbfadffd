// How long editing takes on the page in headless Chromium: from a pointer event to the new solid on the screen, with
// 8 parts of 60 ribs on the board, what a move of the mouse costs that only lights something, and the tasks beyond 50 ms
// that hold the page up meanwhile: node .ci/lib/editing_bench.mjs, as a part of npm run bench.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { openPage, startBrowser, startSite } from './browser.mjs';
import { root } from './paths.mjs';

const kParts = 8,
  kRibs = 60,
  kMoves = 60,
  kPhotos = 5;

function summary(times) {
  const sorted = [...times].sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
  return { median_ms: at(0.5), p95_ms: at(0.95), count: sorted.length };
}

/** Opens the first sample; its stroke, in pixels of the picture. */
async function openSample(page) {
  const [sample] = JSON.parse(readFileSync(join(root, 'assets/samples/samples.json'), 'utf8'));
  const bytes = readFileSync(join(root, 'assets/samples', sample.file)).toString('base64');
  await page.evaluate(async (data) => {
    const api = window.spineloft;
    await api.ready;
    await api.openImage(new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))]), 'bench');
    await api.idle();
  }, bytes);
  return sample.spine;
}

/** The first sample with its stroke eight times, a little apart. */
async function fill(page) {
  const spine = await openSample(page);
  await page.evaluate(
    async ([spine, parts, ribs]) => {
      const api = window.spineloft;
      for (let i = 0; i < parts; ++i) {
        await api.run('draw-spine', { stroke: spine.map(([x, y]) => [x + 2 * i, y + i]) });
        await api.run('set-parameter', { part: i + 1, key: 'ribs', value: ribs });
      }
      await api.idle();
    },
    [spine, kParts, kRibs],
  );
}

/** What the page's own thread, and the process that draws, have taken of the processor so far, ms. */
async function processorMs({ page, whole }) {
  const { metrics } = await page.send('Performance.getMetrics');
  const { processInfo } = await whole.send('SystemInfo.getProcessInfo');
  return {
    thread: 1000 * metrics.find(({ name }) => name === 'TaskDuration').value,
    drawing: 1000 * processInfo.find(({ type }) => type === 'GPU').cpuTime,
  };
}

/**
 * Work that times itself, what a move of it takes of the processor on the page's own thread and in the process that draws,
 * which other programs on the machine do not lengthen, and the tasks beyond 50 ms while a hand moved: how many, and the
 * longest.
 */
async function watched(page, work, argument) {
  const sessions = {
    page: await page.context().newCDPSession(page),
    whole: await page.context().browser().newBrowserCDPSession(),
  };
  await sessions.page.send('Performance.enable', { timeDomain: 'threadTicks' });
  await page.evaluate(() => {
    window.longTasks = [];
    window.longTaskWatch ??= new PerformanceObserver((list) => {
      window.longTasks.push(...list.getEntries());
    });
    window.longTaskWatch.observe({ type: 'longtask' });
  });
  const before = await processorMs(sessions);
  const times = await page.evaluate(work, argument);
  const after = await processorMs(sessions);
  for (const session of Object.values(sessions)) await session.detach();
  const thread_ms = (after.thread - before.thread) / times.length,
    drawing_ms = (after.drawing - before.drawing) / times.length;
  const long = await page.evaluate(() => {
    window.longTasks.push(...window.longTaskWatch.takeRecords());
    window.longTaskWatch.disconnect();
    const { from, to } = window.handMoved;
    return window.longTasks
      .filter((task) => task.startTime >= from && task.startTime < to)
      .map((task) => task.duration);
  });
  return { ...summary(times), thread_ms, drawing_ms, long_tasks: long.length, longest_ms: Math.max(0, ...long) };
}

/** Drags a rib end (or a bone point) and times each move until a frame shows its shape. Runs in the page. */
async function dragTimes([tool, moves]) {
  const api = window.spineloft;
  await api.run(tool);
  await api.idle();
  const canvas = document.querySelector('#canvas');
  const selected = api.state().parts.find(({ id }) => id === api.state().selection);
  const grip = tool === 'ribs' ? selected.ribs[Math.floor(selected.ribs.length / 2)].left : selected.bone[3];
  const at = api.imageToClient(...grip);
  const send = (type, x, y, buttons) =>
    canvas.dispatchEvent(
      new PointerEvent(type, {
        pointerId: 1,
        pointerType: 'mouse',
        button: type === 'pointermove' ? -1 : 0,
        buttons,
        clientX: x,
        clientY: y,
        bubbles: true,
        cancelable: true,
      }),
    );
  // After the frame's own callbacks: what they drew has been handed over.
  const frame = () =>
    new Promise((resolve) =>
      requestAnimationFrame(() => {
        const channel = new MessageChannel();
        channel.port1.onmessage = resolve;
        channel.port2.postMessage(0);
      }),
    );
  const from = performance.now();
  send('pointerdown', at.x, at.y, 1);
  const times = [];
  for (let i = 0; i < moves; ++i) {
    const t = (i + 1) / moves;
    const start = performance.now();
    send('pointermove', at.x + 30 * Math.sin(9 * t), at.y + 12 + 20 * t, 1);
    let now = 0;
    do {
      await frame();
      now = performance.now();
    } while (!api.state().preview?.fresh);
    times.push(now - start);
  }
  window.handMoved = { from, to: performance.now() };
  send('pointercancel', at.x, at.y, 0);
  await api.idle();
  return times;
}

/**
 * A hand that moves every 16 ms along a path on the page, with buttons held down, or else with a wheel that turns: times how
 * late the page is for each move. Runs in the page.
 */
async function steadyTimes([path, { buttons = 1, wheel = 0 } = {}]) {
  const canvas = document.querySelector('#canvas'),
    common = { bubbles: true, cancelable: true };
  const send = (type, [clientX, clientY], held) =>
    canvas.dispatchEvent(
      new PointerEvent(type, {
        ...common,
        pointerId: 1,
        pointerType: 'mouse',
        button: type === 'pointermove' ? -1 : buttons === 4 ? 1 : 0,
        buttons: held,
        clientX,
        clientY,
      }),
    );
  const move = ([clientX, clientY]) =>
    wheel
      ? canvas.dispatchEvent(new WheelEvent('wheel', { ...common, clientX, clientY, deltaY: wheel }))
      : send('pointermove', [clientX, clientY], buttons);
  const tick = () => new Promise((resolve) => setTimeout(resolve, 16));
  send('pointermove', path[0], 0);
  await tick();
  const from = performance.now();
  if (!wheel) send('pointerdown', path[0], buttons);
  const times = [];
  for (const at of path.slice(1)) {
    const start = performance.now();
    move(at);
    await tick();
    times.push(Math.max(0, performance.now() - start - 16));
  }
  window.handMoved = { from, to: performance.now() };
  if (!wheel) send('pointerup', path.at(-1), 0);
  await window.spineloft.idle();
  return times;
}

/** A closed curve of moves about a place in pixels of the page. */
const roundAbout = (x, y, radius, moves = kMoves) =>
  Array.from({ length: moves + 1 }, (_, i) => {
    const turn = (2 * Math.PI * 0.97 * i) / moves;
    return [x + radius * Math.cos(turn), y + radius * Math.sin(turn)];
  });

/** What moves all of a view, and a part by an arrow of its gizmo, with the parts of `fill`. */
async function viewTimes(page) {
  const timed = (path, how) => watched(page, steadyTimes, [path, how]);
  const place = (x, y) => page.evaluate(([x, y]) => Object.values(window.spineloft.imageToClient(x, y)), [x, y]);
  const [x, y] = await place(200, 200);
  const found = {
    'turn the solid': await timed(roundAbout(900, 500, 120)),
    'zoom into the solid': await timed(roundAbout(900, 500, 30), { wheel: -12 }),
    'pan the picture': await timed(roundAbout(x, y, 60), { buttons: 4 }),
    'zoom into the picture': await timed(roundAbout(x, y, 30), { wheel: -12 }),
  };
  const knob = await page.evaluate(async () => {
    const api = window.spineloft;
    await api.run('fit');
    await api.run('move');
    await api.idle();
    const { left, top } = document.querySelector('#canvas').getBoundingClientRect();
    const [x, y] = api.state().gizmo.knobs.find(({ handle }) => handle === 'y').at;
    return [x + left, y + top];
  });
  const upAndDown = Array.from({ length: kMoves + 1 }, (_, i) => [knob[0], knob[1] - 60 * Math.sin(i / 12)]);
  found['move a part by its arrow'] = await timed(upAndDown);
  return found;
}

/** A hand of layers, one to five: its sheet is lifted between them, and its last layer leans with the solid. */
async function sheetTimes(browser, site) {
  const page = await openWarm(browser, site);
  await page.getByRole('button', { name: 'Draw on paper' }).click();
  const knobs = await page.evaluate(async () => {
    const api = window.spineloft;
    const round = (x, y, radius) => {
      const points = Array.from({ length: 8 }, (_, i) => (2 * Math.PI * i) / 8);
      return points.map((turn) => [x + radius * Math.cos(turn), y + radius * Math.sin(turn)]);
    };
    await api.idle();
    await api.run('more-tools', { on: true });
    await api.run('layers');
    await api.run('draw-layer', { at: 0, through: round(0, 0, 80) });
    await api.run('draw-layer', { at: 0.5, through: round(0, 0, 150) });
    for (let i = -2; i <= 2; ++i) await api.run('draw-layer', { at: 1, through: round(90 * i, 0, 35) });
    await api.idle();
    const { left, top } = document.querySelector('#canvas').getBoundingClientRect();
    const { knob, leanKnobs } = api.state().sheet;
    return [knob, leanKnobs[1]].map(([x, y]) => [x + left, y + top]);
  });
  const downAndUp = ([x, y]) => Array.from({ length: kMoves + 1 }, (_, i) => [x, y + 60 * Math.abs(Math.sin(i / 12))]);
  const found = { 'lean a layer of a hand': await watched(page, steadyTimes, [downAndUp(knobs[1])]) };
  await page.evaluate(() => window.spineloft.run('undo'));
  found['lift the sheet of a hand'] = await watched(page, steadyTimes, [downAndUp(knobs[0])]);
  await page.context().close();
  return found;
}

/** The first lines of a visit: on a photo, and on a sheet of paper, each in a fresh page. */
async function firstLines(browser, site) {
  const photo = await openWarm(browser, site);
  const spine = await photo.evaluate(
    (spine) => spine.map(([x, y]) => Object.values(window.spineloft.imageToClient(x, y))),
    await openSample(photo),
  );
  const path = Array.from({ length: kMoves + 1 }, (_, i) => {
    const at = (i / kMoves) * (spine.length - 1.001),
      first = Math.floor(at);
    return [0, 1].map((axis) => spine[first][axis] + (at - first) * (spine[first + 1][axis] - spine[first][axis]));
  });
  const found = { 'draw a first line': await watched(photo, steadyTimes, [path]) };
  await photo.context().close();
  const paper = await openWarm(browser, site);
  await paper.getByRole('button', { name: 'Draw on paper' }).click();
  const [x, y] = await paper.evaluate(async () => {
    await window.spineloft.idle();
    return Object.values(window.spineloft.imageToClient(300, 300));
  });
  found['draw a first outline'] = await watched(paper, steadyTimes, [roundAbout(x, y, 90)]);
  await paper.context().close();
  return found;
}

/** Moves the mouse over one of the views and times what each event costs. Runs in the page. */
async function hoverTimes([view, moves]) {
  const canvas = document.querySelector('#canvas');
  const box = canvas.getBoundingClientRect();
  const from = performance.now();
  const times = [];
  for (let i = 0; i < moves; ++i) {
    const u = (i * 0.618) % 1,
      v = (i * 0.755) % 1;
    const x = box.left + box.width * (view === 'picture' ? 0.05 + 0.3 * u : 0.45 + 0.33 * u);
    const event = new PointerEvent('pointermove', {
      pointerId: 1,
      pointerType: 'mouse',
      buttons: 0,
      clientX: x,
      clientY: box.top + box.height * (0.15 + 0.6 * v),
      bubbles: true,
    });
    const start = performance.now();
    canvas.dispatchEvent(event);
    times.push(performance.now() - start);
    await new Promise((resolve) => setTimeout(resolve, 4));
  }
  window.handMoved = { from, to: performance.now() };
  return times;
}

/**
 * A photo of 12 megapixels with a pale bar on a patterned ground, and its bar drawn as soon as it is seen: ms until it is, and
 * from the line until there is a solid, and until its ribs, its texture and all else are settled. Runs in the page.
 */
async function firstSolidTimes([width, height]) {
  const api = window.spineloft,
    canvas = new OffscreenCanvas(width, height),
    pen = canvas.getContext('2d');
  await api.ready;
  await api.idle();
  for (let y = 0; y < height; y += 50) {
    for (let x = 0; x < width; x += 50) {
      pen.fillStyle = `hsl(${((x * 7 + y * 3) % 60) + 90} 30% ${25 + ((x * 13 + y * 29) % 97) / 8}%)`;
      pen.fillRect(x, y, 50, 50);
    }
  }
  pen.lineWidth = height / 6;
  pen.lineCap = 'round';
  pen.strokeStyle = '#e8d8b0';
  pen.beginPath();
  pen.moveTo(0.2 * width, 0.6 * height);
  pen.bezierCurveTo(0.4 * width, 0.3 * height, 0.6 * width, 0.3 * height, 0.8 * width, 0.6 * height);
  pen.stroke();
  const photo = await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.92 });
  const stroke = Array.from({ length: 60 }, (_, i) => {
    const t = i / 59,
      u = 1 - t;
    return [
      width * (0.2 * u ** 3 + 1.2 * u * u * t + 1.8 * u * t * t + 0.8 * t ** 3),
      height * (0.6 * u ** 3 + 0.9 * u * u * t + 0.9 * u * t * t + 0.6 * t ** 3),
    ];
  });
  const start = performance.now();
  await api.openImage(photo, 'photo');
  // The first frame after it shows it; the second one begins when that is on the screen.
  for (let i = 0; i < 2; ++i) await new Promise(requestAnimationFrame);
  const line = performance.now();
  const drawn = api.run('draw-spine', { stroke });
  while (!(api.state().parts[0]?.triangles > 0)) await new Promise((resolve) => setTimeout(resolve, 1));
  const solid = performance.now() - line;
  await drawn;
  await api.idle();
  return { opened: line - start, solid, settled: performance.now() - line };
}

/** A fresh page as whoever looks for a picture has it: it has made itself ready. */
async function openWarm(browser, site) {
  const { page } = await openPage(browser, site.url, { viewport: { width: 1440, height: 900 } });
  await page.waitForFunction(() => performance.getEntriesByName('spineloft-warm').length > 0, null, {
    timeout: 60000,
  });
  return page;
}

/** Each in a fresh page. */
async function firstSolids(browser, site) {
  const found = [];
  for (let i = 0; i < kPhotos; ++i) {
    const page = await openWarm(browser, site);
    found.push(await page.evaluate(firstSolidTimes, [4000, 3000]));
    await page.context().close();
  }
  return {
    'a photo of 12 megapixels until it is seen': summary(found.map(({ opened }) => opened)),
    'from a line on it to the first solid': summary(found.map(({ solid }) => solid)),
    'the same, until all is settled': summary(found.map(({ settled }) => settled)),
  };
}

/** Median and 95th percentile of each kind of gesture; dist/ must be built. */
export async function editingTimes() {
  const site = await startSite({ isolated: true });
  const browser = await startBrowser();
  try {
    const page = await openWarm(browser, site);
    await fill(page);
    const result = { parts: kParts, ribs: kRibs };
    const timed = (work, ...argument) => watched(page, work, argument);
    result['drag a rib end'] = await timed(dragTimes, 'ribs', kMoves);
    await page.evaluate(() => window.spineloft.run('keep-ribs'));
    result['bend the bone, ribs kept'] = await timed(dragTimes, 'bone', kMoves);
    await page.evaluate(() => window.spineloft.run('find-edges'));
    result['bend the bone, edges found again'] = await timed(dragTimes, 'bone', kMoves);
    result['hover over the picture'] = await timed(hoverTimes, 'picture', kMoves);
    result['hover over the solid'] = await timed(hoverTimes, 'solid', kMoves);
    Object.assign(result, await viewTimes(page));
    await page.context().close();
    Object.assign(result, await sheetTimes(browser, site));
    return { ...result, ...(await firstLines(browser, site)), ...(await firstSolids(browser, site)) };
  } finally {
    await browser.close();
    await site.close();
  }
}

if (process.argv[1] === import.meta.filename)
  process.stdout.write(`${JSON.stringify(await editingTimes(), null, 2)}\n`);
