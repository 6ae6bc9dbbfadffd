// The fonts of the page: each file holds only the letters and icons that the page draws.
//  - Inter, text and bold, for the DOM and the canvas: the letters of the canvas's table (web/ui/fonts.cpp)
//  - Lucide: the icons of the canvas (web/ui/icons.h)
//  - Noto Sans for what Inter lacks, by language: the letters of its catalogue, and of what a visitor types the kana and
//    the Arabic alphabet
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './paths.mjs';
import { Stop } from './run.mjs';
import { catalogue } from './words.mjs';

const folder = join(root, 'node_modules/@expo-google-fonts');
const range = (first, last) => Array.from({ length: last - first + 1 }, (_, i) => String.fromCodePoint(first + i));
const source = (path) => readFileSync(join(root, path), 'utf8');

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

/** The letters that Inter has on the page. */
export function textLetters() {
  const table = /kTextRanges\[\] = \{([^}]*)\}/.exec(source('web/ui/fonts.cpp'));
  if (!table) throw new Stop('web/ui/fonts.cpp has no kTextRanges; .ci/lib/fonts.mjs must learn its new form.');
  const bounds = table[1].split(',').map((number) => parseInt(number, 16));
  return bounds.flatMap((first, i) => (i % 2 === 0 && first > 0 ? range(first, bounds[i + 1]) : [])).join('');
}

/** The code points of the canvas's icons. */
export const iconCodes = () =>
  [...source('web/ui/icons.h').matchAll(/Icon\{"[a-z0-9-]+",\s*(\d+)\}/g)].map(([, code]) => Number(code));

// Packages are imported when a font is made: the set-up that installs them reads this file, too.

/** A TrueType file with `letters` alone. */
async function subset(file, letters, options) {
  const { default: subsetFont } = await import('subset-font');
  return subsetFont(readFileSync(file), letters, { targetFormat: 'truetype', noHinting: true, ...options });
}

/** Without substitutions (ligatures, small capitals) and kerning, which the canvas does not know and half of the file is. */
const kPlain = { noLayoutClosure: true, dropTables: ['GSUB', 'GPOS'] };

export const textFont = (file) => subset(file, textLetters(), kPlain);
export const iconFont = (file) => subset(file, String.fromCodePoint(...iconCodes()), kPlain);

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
  const { family, file, options } = kScripts[id];
  const style = kWeights[weight];
  return subset(join(folder, family, style, `${file}_${style}.ttf`), await scriptLetters(id), options);
}
