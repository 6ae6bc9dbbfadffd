// The first visit in headless Chromium, from an empty cache: npm run bench. What is fetched until the page can be used,
// and when that is, over loopback and on a slow device behind a slow line.
import { startBrowser } from '../../.ci/lib/browser.mjs';
import { distDir } from '../../.ci/lib/paths.mjs';
import { serveFolder } from '../../.ci/lib/server.mjs';

const kVisits = 5;
/** 10 Mbit/s with the way there and back of a mobile line. */
const kLine = { offline: false, latency: 40, downloadThroughput: 1.25e6, uploadThroughput: 1.25e6 };
const kDevices = {
  'over loopback': {},
  'a 4 times slower processor at 10 Mbit/s': { slower: 4, line: kLine },
};

/** In the page, before its scripts: when it can be used. */
function watchReady() {
  const isReady = () => document.body?.dataset.engine === 'ready';
  const seen = new MutationObserver(() => {
    if (!isReady()) return;
    seen.disconnect();
    window.usableMs = performance.now();
  });
  seen.observe(document, { subtree: true, childList: true, attributes: true });
}

/** One visit: milliseconds from the start of the navigation, and bytes as they come over the line. */
async function visit(browser, url, { slower, line }) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  try {
    await context.addInitScript(watchReady);
    const page = await context.newPage();
    const session = await context.newCDPSession(page);
    await session.send('Network.enable');
    if (line) await session.send('Network.emulateNetworkConditions', line);
    if (slower) await session.send('Emulation.setCPUThrottlingRate', { rate: slower });
    const files = new Map();
    session.on('Network.responseReceived', ({ requestId, response }) => files.set(requestId, { url: response.url }));
    session.on('Network.loadingFinished', ({ requestId, encodedDataLength }) => {
      if (files.has(requestId)) files.get(requestId).bytes = encodedDataLength;
    });
    await page.goto(url, { waitUntil: 'commit' });
    await page.waitForFunction(() => window.usableMs > 0, null, { timeout: 60_000 });
    const fetched = [...files.values()].filter(({ bytes }) => bytes > 0);
    const painted = await page.evaluate(
      () => performance.getEntriesByType('paint').find(({ name }) => name === 'first-contentful-paint')?.startTime ?? 0,
    );
    return {
      ms: await page.evaluate(() => window.usableMs),
      painted,
      bytes: fetched.reduce((sum, { bytes }) => sum + bytes, 0),
      files: fetched.map(({ url: address, bytes }) => [new URL(address).pathname.split('/').at(-1), bytes]),
    };
  } finally {
    await context.close();
  }
}

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

/** By device: medians of the visits; dist/ must be built. The last visit's files, the largest first. */
export async function firstLoadTimes(folder = distDir) {
  const found = {};
  for (const isolated of [true, false]) {
    const site = await serveFolder(folder, { isolated });
    const browser = await startBrowser();
    try {
      for (const [device, conditions] of Object.entries(kDevices)) {
        const visits = [];
        for (let i = 0; i < kVisits; i += 1) visits.push(await visit(browser, site.url, conditions));
        found[`${device}, ${isolated ? 'with threads' : 'one thread'}`] = {
          usable_ms: median(visits.map(({ ms }) => ms)),
          painted_ms: median(visits.map(({ painted }) => painted)),
          bytes: median(visits.map(({ bytes }) => bytes)),
          files: visits.at(-1).files.sort((a, b) => b[1] - a[1]),
        };
      }
    } finally {
      await browser.close();
      await site.close();
    }
  }
  return found;
}

if (import.meta.filename === process.argv[1])
  process.stdout.write(`${JSON.stringify(await firstLoadTimes(process.argv[2]), null, 2)}\n`);
