// Figures of recipes of assets/docs/recipes: what is drawn, and the solid, as the page shows them.
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { openPage, startSite } from './browser.mjs';
import { presetDir } from './cmake.mjs';
import { root } from './paths.mjs';

/** What a figure shows: [recipe, words below, 'bones': with those of its first part; 'solid': without the picture]. */
export const kSolidFigures = {
  'fig-puffs': [
    ['waved-disc', '1: a point and a waved slice'],
    ['three-piece-slice', '11: a slice of three pieces'],
    ['one-smooth-bone', '12: one smooth bone', 'bones'],
    ['box', '13: a rectangle under a rectangle'],
    ['letters', '14: two letters and a frame'],
    ['bones-of-outlines', '16: outlines; the bones of the first', 'bones'],
  ],
  'fig-layers': [
    ['volcano', '5: four layers, a crater, bumps', 'solid'],
    ['terrain', '6: ground along a line', 'solid'],
    ['castle-wall', '7: four layers, twenty times', 'solid'],
    ['elliptical-ring', '8: one layer round an ellipse', 'solid'],
    ['y-fork', 'one becomes two', 'solid'],
    ['tooth', 'one becomes three', 'solid'],
    ['hand', 'one becomes five', 'solid'],
    ['crossed-pipes', 'two become two others', 'solid'],
    ['vase', 'circles and a square', 'solid'],
  ],
};

const kWindow = { width: 1100, height: 720 };
const kViews = { x: 0, y: 150, width: 858, height: 460 }; // of the picture and of the solid
const kSolidView = { x: 436, y: 144, width: 388, height: 472 };
const kFromAside = ['home-view', 'turn-up', 'turn-up', 'turn-up', 'turn-left', 'turn-left', 'fit'];

/** Writes a screenshot of each recipe into the folder; the site and the program are built. */
export async function shootSolids(browser, folder) {
  const program = join(presetDir('native-release'), 'spineloft');
  const site = await startSite();
  try {
    for (const [name, , shown] of Object.values(kSolidFigures).flat()) {
      const model = join(folder, `${name}.spineloft`);
      execFileSync(program, ['loft', '--recipe', join(root, `assets/docs/recipes/${name}.json`), '--out', model]);
      const link = execFileSync(program, ['share', model], { encoding: 'utf8' }).trim();
      const { page, close } = await openPage(browser, site.url, { viewport: kWindow });
      await page.evaluate(
        async ([text, ids, bones]) => {
          const { spineloft } = window;
          await spineloft.ready;
          await spineloft.openShareText(text);
          for (const id of ids) await spineloft.run(id);
          if (bones) {
            await spineloft.run('select-part', { id: 1 });
            await spineloft.run('bone');
          }
          await spineloft.idle();
        },
        [link, kFromAside, shown === 'bones'],
      );
      await page.waitForTimeout(600); // until what turns is at rest
      await page.screenshot({ path: join(folder, `${name}.png`), clip: shown === 'solid' ? kSolidView : kViews });
      await close();
    }
  } finally {
    await site.close();
  }
}
