// How long editing takes on the page in headless Chromium: from a pointer event to the new solid on the screen, with
// 8 parts of 60 ribs on the board, and what a move of the mouse costs that only lights something.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { openPage, startBrowser, startSite } from './browser.mjs';
import { root } from './paths.mjs';

const kParts = 8, kRibs = 60, kMoves = 60;

function summary(times) {
  const sorted = [...times].sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
  return { median_ms: at(0.5), p95_ms: at(0.95), count: sorted.length };
}

/** The first sample with its stroke eight times, a little apart. */
async function fill(page) {
  const [sample] = JSON.parse(readFileSync(join(root, 'assets/samples/samples.json'), 'utf8'));
  const bytes = readFileSync(join(root, 'assets/samples', sample.file)).toString('base64');
  await page.evaluate(async ([data, spine, parts, ribs]) => {
    const api = window.spineloft;
    await api.ready;
    await api.openImage(new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))]), 'bench');
    await api.idle();
    for (let i = 0; i < parts; ++i) {
      await api.run('draw-spine', { stroke: spine.map(([x, y]) => [x + 2 * i, y + i]) });
      await api.run('set-parameter', { part: i + 1, key: 'ribs', value: ribs });
    }
    await api.idle();
  }, [bytes, sample.spine, kParts, kRibs]);
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
  const send = (type, x, y, buttons) => canvas.dispatchEvent(new PointerEvent(type, {
    pointerId: 1, pointerType: 'mouse', button: type === 'pointermove' ? -1 : 0, buttons, clientX: x, clientY: y, bubbles: true, cancelable: true,
  }));
  // After the frame's own callbacks: what they drew has been handed over.
  const frame = () => new Promise((resolve) => requestAnimationFrame(() => {
    const channel = new MessageChannel();
    channel.port1.onmessage = resolve;
    channel.port2.postMessage(0);
  }));
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
  send('pointercancel', at.x, at.y, 0);
  await api.idle();
  return times;
}

/** Moves the mouse over one of the views and times what each event costs. Runs in the page. */
async function hoverTimes([view, moves]) {
  const canvas = document.querySelector('#canvas');
  const box = canvas.getBoundingClientRect();
  const times = [];
  for (let i = 0; i < moves; ++i) {
    const u = (i * 0.618) % 1, v = (i * 0.755) % 1;
    const x = box.left + box.width * (view === 'picture' ? 0.05 + 0.3 * u : 0.45 + 0.33 * u);
    const event = new PointerEvent('pointermove', { pointerId: 1, pointerType: 'mouse', buttons: 0, clientX: x, clientY: box.top + box.height * (0.15 + 0.6 * v), bubbles: true });
    const start = performance.now();
    canvas.dispatchEvent(event);
    times.push(performance.now() - start);
    await new Promise((resolve) => setTimeout(resolve, 4));
  }
  return times;
}

/** Median and 95th percentile of each kind of gesture; dist/ must be built. */
export async function editingTimes() {
  const site = await startSite({ isolated: true });
  const browser = await startBrowser();
  try {
    const { page } = await openPage(browser, site.url, { viewport: { width: 1440, height: 900 } });
    await fill(page);
    const result = { parts: kParts, ribs: kRibs };
    result['drag a rib end'] = summary(await page.evaluate(dragTimes, ['ribs', kMoves]));
    await page.evaluate(() => window.spineloft.run('keep-ribs'));
    result['bend the bone, ribs kept'] = summary(await page.evaluate(dragTimes, ['bone', kMoves]));
    await page.evaluate(() => window.spineloft.run('find-edges'));
    result['bend the bone, edges found again'] = summary(await page.evaluate(dragTimes, ['bone', kMoves]));
    result['hover over the picture'] = summary(await page.evaluate(hoverTimes, ['picture', kMoves]));
    result['hover over the solid'] = summary(await page.evaluate(hoverTimes, ['solid', kMoves]));
    return result;
  } finally {
    await browser.close();
    await site.close();
  }
}
