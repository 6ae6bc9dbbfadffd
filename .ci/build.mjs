// npm run build: set-up, both engines, and the self-contained static site in dist/.
import { pathToFileURL } from 'node:url';
import { buildTargets } from './lib/cmake.mjs';
import { duration, mainProgram, say } from './lib/run.mjs';
import { assembleSite, siteSizes, siteTargets } from './lib/site.mjs';
import { setup } from './setup.mjs';

function kilobytes(bytes) {
  return bytes === null ? '' : `${(bytes / 1024).toFixed(0)} KB`;
}

function printSizes() {
  const columns = (cells) => [cells[0].padEnd(36), ...cells.slice(1).map((cell) => cell.padStart(10))].join('');
  say(columns(['file', 'raw', 'gzip', 'brotli']));
  for (const { file, raw, gzip, brotli } of siteSizes()) {
    say(columns([file, kilobytes(raw), kilobytes(gzip), kilobytes(brotli)]));
  }
}

/** Builds the site; assumes that set-up has been done. */
export async function buildSite() {
  const started = Date.now();
  await buildTargets('wasm-release', siteTargets());
  await assembleSite();
  say(`dist: the site is ready (${duration(Date.now() - started)})`);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  await mainProgram(async () => {
    await setup(['wasm', 'opencv', 'node']);
    await buildSite();
    printSizes();
  });
}
