// Fonts with the letters that Inter lacks, of the languages of the catalogue: Noto Sans with the letters of the
// catalogue alone, and of what a visitor types the kana and the Arabic alphabet.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './paths.mjs';
import { catalogue } from './words.mjs';

const folder = join(root, 'node_modules/@expo-google-fonts');
const range = (first, last) => Array.from({ length: last - first + 1 }, (_, i) => String.fromCodePoint(first + i));

const kScripts = {
  ja: {
    family: 'noto-sans-jp',
    file: 'NotoSansJP',
    typed: [...range(0x3001, 0x3011), ...range(0x3041, 0x3096), ...range(0x30a1, 0x30fc)],
    // Forms for vertical lines and the like make up a third of the file.
    options: { noLayoutClosure: true, dropTables: ['GSUB', 'GPOS', 'BASE', 'vhea', 'vmtx'] },
  },
  ar: {
    family: 'noto-sans-arabic',
    file: 'NotoSansArabic',
    // The canvas draws joined forms, the DOM letters that the font joins.
    typed: [...range(0x60c, 0x60c), ...range(0x61b, 0x61f), ...range(0x621, 0x652), ...range(0xfe80, 0xfefc)],
    options: {},
  },
};
const kWeights = { text: '400Regular', bold: '600SemiBold' };

export const scriptLanguages = Object.keys(kScripts);

// Packages are imported when a font is made: the set-up that installs them reads this file, too.

/** The letters that such a font has: those of the catalogue as they are written and as the canvas draws them. */
async function scriptLetters(id) {
  const { default: shapers } = await import('arabic-persian-reshaper');
  const words = Object.values(catalogue(id)).join(' ');
  const drawn = id === 'ar' ? shapers.ArabicShaper.convertArabic(words) : '';
  const own = [...words, ...drawn].filter((letter) => letter > '\u0500' && !/[\u2000-\u206f]/.test(letter));
  return [...new Set([...own, ...kScripts[id].typed])].sort().join('');
}

/** A TrueType file of a language: `weight` is "text" or "bold". */
export async function scriptFont(id, weight) {
  const { default: subsetFont } = await import('subset-font');
  const { family, file, options } = kScripts[id];
  const style = kWeights[weight];
  const font = readFileSync(join(folder, family, style, `${file}_${style}.ttf`));
  return subsetFont(font, await scriptLetters(id), { targetFormat: 'truetype', noHinting: true, ...options });
}
