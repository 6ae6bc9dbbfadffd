// npm run figures: the pictures of assets/docs/accuracy.md, made anew from the cases of a data folder
// ($SPINELOFT_DATA, or ../shared/data/public), and those of method-inflate.md and method-stack.md, of recipes. Each is at
// most 150 KB.
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { buildSite } from './build.mjs';
import { startBrowser } from './lib/browser.mjs';
import { buildTargets, presetDir } from './lib/cmake.mjs';
import { dataFolder, root } from './lib/paths.mjs';
import { mainProgram, run, say, Stop } from './lib/run.mjs';
import { kSolidFigures, shootSolids } from './lib/solid_figures.mjs';
import { setup } from './setup.mjs';

const kMostBytes = 150000;
const kMinutes = 60000;

/** What a figure shows: [case, stroke, variation of `spineloft_accuracy`, words below]. */
const kFigures = {
  'fig-08-09-energy': [
    ['sketch_bat_noisy', 'sloppy', 'separate', 'every rib end to itself'],
    ['sketch_bat_noisy', 'sloppy', 'no-neighbours', 'without the neighbour term'],
    ['sketch_bat_noisy', 'sloppy', 'no-opposite', 'without the opposite term'],
    ['sketch_bat_noisy', 'sloppy', 'product', 'all terms'],
  ],
  'fig-12-sloppy': [
    ['photo_zucchini_hand', 'careful', 'product', 'drawn with care'],
    ['photo_zucchini_hand', 'sloppy', 'product', 'drawn in a hurry'],
    ['photo_zucchini_hand', 'offcentre', 'product', 'off the middle'],
    ['render_banana_occluded', 'careful', 'product', 'drawn with care'],
    ['render_banana_occluded', 'sloppy', 'product', 'drawn in a hurry'],
    ['render_banana_occluded', 'offcentre', 'product', 'off the middle'],
  ],
  'fig-17-distance': [
    ['proc_hook_g0', 'careful', 'd-inf-separate', 'd∞, no optimisation'],
    ['proc_hook_g0', 'careful', 'd-inf', 'd∞, optimised'],
    ['proc_hook_g0', 'careful', 'separate', 'd2, no optimisation'],
    ['proc_hook_g0', 'careful', 'product', 'd2, optimised'],
  ],
  'fig-22-hard': [
    ['sketch_mug', 'careful', 'product', 'a mug behind its handle'],
    ['sketch_snake', 'careful', 'product', 'an open outline'],
    ['photo_lemur_tail', 'sloppy', 'product', 'stripes'],
    ['render_banana_occluded', 'careful', 'product', 'a quarter hidden'],
    ['render_beer_bottle', 'careful', 'product', 'labels, highlights, a shadow'],
    ['proc_taper_g25', 'careful', 'product', 'a quarter of the outline erased'],
  ],
  failures: [
    ['render_vase_lowcontrast', 'careful', 'product', 'painted stripes, no contrast outside'],
    ['render_palm_noise', 'sloppy', 'product', 'noise, the shaded side of the trunk'],
    ['proc_very_long_g50', 'careful', 'product', 'half erased, noisy, very long'],
    ['photo_coffee_cup', 'careful', 'product', 'a cup on a saucer of its colour'],
    ['proc_c_ring_g25', 'sloppy', 'product', 'halos where the outline was erased'],
    ['render_lamp_missing', 'sloppy', 'product', 'pieces bitten out of both sides'],
  ],
};

const overlayPath = (folder, [name, stroke, variation]) => join(folder, variation, `${name}.${stroke}.png`);

async function drawOverlays(data, folder) {
  const wanted = new Set(
    Object.values(kFigures).flatMap((panels) => panels.map(([name, , variation]) => `${variation}/${name}`)),
  );
  for (const entry of wanted) {
    const [variation, name] = entry.split('/');
    const at = join(data, name);
    if (!existsSync(at)) throw new Stop(`There is no case ${name} in ${data}.`);
    await run(
      `${name}, ${variation}`,
      join(presetDir('native-release'), 'spineloft_accuracy'),
      [at, '--variation', variation, '--overlays', join(folder, variation)],
      { log: 'figures', timeout: 5 * kMinutes },
    );
  }
}

/** A grid of pictures, drawn through a filter, with words below: [path, words]. */
function pageOf(panels, filter) {
  const figures = panels.map(([path, words]) => {
    const bytes = readFileSync(path).toString('base64');
    return `<figure><div><img src="data:image/png;base64,${bytes}"></div><figcaption>${words}</figcaption></figure>`;
  });
  const columns = panels.length % 3 === 0 ? 3 : 4;
  return `<style>
    body { margin: 0; padding: 6px; display: grid; grid-template-columns: repeat(${columns}, 1fr); gap: 6px; background: #fff; font: 14px sans-serif; }
    figure { margin: 0; text-align: center; color: #222; }
    div { height: 270px; background: #111; display: grid; place-items: center; overflow: hidden; border-radius: 4px; }
    img { max-width: 100%; max-height: 270px; filter: ${filter}; }
    figcaption { padding: 3px; }
  </style>${figures.join('')}`;
}

/** As good as fits. */
async function shoot(page) {
  for (let quality = 88; quality >= 30; quality -= 8) {
    const bytes = await page.screenshot({ type: 'jpeg', quality, fullPage: true });
    if (bytes.length <= kMostBytes) return bytes;
  }
  throw new Stop('A figure does not fit into 150 KB.');
}

await mainProgram(async () => {
  if (!dataFolder) throw new Stop('There is no data folder beside the project: set SPINELOFT_DATA.');
  await setup(['native', 'wasm', 'opencv', 'node', 'browser']);
  await buildSite();
  await buildTargets('native-release', ['spineloft_accuracy', 'spineloft']);
  const folder = mkdtempSync(join(tmpdir(), 'spineloft-figures-'));
  const out = join(root, 'assets/docs/figures');
  mkdirSync(out, { recursive: true });
  const browser = await startBrowser();
  try {
    await drawOverlays(dataFolder, folder);
    await shootSolids(browser, folder);
    const overlays = Object.entries(kFigures).map(([name, panels]) => [
      name,
      panels.map((panel) => [overlayPath(folder, panel), panel[3]]),
      'brightness(1.5)',
    ]);
    const solids = Object.entries(kSolidFigures).map(([name, panels]) => [
      name,
      panels.map(([recipe, words]) => [join(folder, `${recipe}.png`), words]),
      'none',
    ]);
    const page = await browser.newPage({ viewport: { width: 1000, height: 300 } });
    for (const [name, panels, filter] of [...overlays, ...solids]) {
      await page.setContent(pageOf(panels, filter), { waitUntil: 'load' });
      writeFileSync(join(out, `${name}.jpg`), await shoot(page));
      say(`Written: assets/docs/figures/${name}.jpg`);
    }
  } finally {
    await browser.close();
    rmSync(folder, { recursive: true });
  }
});
