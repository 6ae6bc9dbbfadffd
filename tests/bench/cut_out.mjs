// From a tap to its outlines in headless Chromium, from an empty cache: what a person waits for who cuts out a thing.
//
//   node tests/bench/cut_out.mjs [FOLDER OF A SITE]
//
// Puff is taken in hand on a sample of the start page, and a second later the sample's middle is tapped: the first cut-out of
// a visit; then once more. JSON: medians over the visits, in ms, and a hash of the outlines in all samples, which no change of
// speed alters.
import { createHash } from 'node:crypto';
import { openPage, startBrowser } from '../../.ci/lib/browser.mjs';
import { distDir } from '../../.ci/lib/paths.mjs';
import { serveFolder } from '../../.ci/lib/server.mjs';
import { samples } from '../browser/support/pictures.mjs';

const kVisits = 5;
const kHeadStartMs = 1000;

/** In the page: cuts out at the point; milliseconds until the outlines are there, and the outlines. */
async function cutAt(at) {
  const { spineloft } = window;
  const begun = performance.now();
  await spineloft.run('cut-start', { at });
  while (spineloft.state().cut?.searching) await new Promise((resolve) => setTimeout(resolve, 2));
  const ms = performance.now() - begun;
  const contours = spineloft.state().cut?.contours ?? null;
  await spineloft.run('cut-cancel');
  await spineloft.idle();
  return { ms, contours };
}

/** In the page: a picture is open, and the tool in hand. */
async function makeReady([data, wait]) {
  const { spineloft } = window;
  await spineloft.ready;
  await spineloft.openImage(new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))]), 'sample');
  await spineloft.idle();
  await spineloft.run('puff');
  await new Promise((resolve) => setTimeout(resolve, wait));
}

const middleOf = ({ spine }) => spine[spine.length >> 1];
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

export async function cutOutTimes(folder = distDir) {
  const times = {};
  for (const isolated of [true, false]) {
    const first = [],
      second = [],
      outlines = createHash('sha256');
    const site = await serveFolder(folder, { isolated });
    const browser = await startBrowser();
    try {
      const [sample, ...others] = samples();
      for (let visit = 0; visit < kVisits; visit += 1) {
        const { page, close } = await openPage(browser, site.url, { deviceScaleFactor: 0.5 });
        await page.evaluate(makeReady, [sample.bytes.toString('base64'), kHeadStartMs]);
        const one = await page.evaluate(cutAt, middleOf(sample));
        const two = await page.evaluate(cutAt, middleOf(sample));
        first.push(one.ms);
        second.push(two.ms);
        if (visit === kVisits - 1) {
          outlines.update(JSON.stringify([one.contours, two.contours]));
          for (const other of others) {
            await page.evaluate(makeReady, [other.bytes.toString('base64'), 0]);
            outlines.update(JSON.stringify((await page.evaluate(cutAt, middleOf(other))).contours));
          }
        }
        await close();
      }
    } finally {
      await browser.close();
      await site.close();
    }
    times[isolated ? 'with threads' : 'one thread'] = {
      first_ms: median(first),
      second_ms: median(second),
      outlines: outlines.digest('hex').slice(0, 16),
    };
  }
  return times;
}

if (import.meta.filename === process.argv[1])
  process.stdout.write(`${JSON.stringify(await cutOutTimes(process.argv[2]), null, 2)}\n`);
