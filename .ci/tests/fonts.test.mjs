// The fonts of the page: fewer letters, none of them changed.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { iconCodes, iconFont, textFont, textLetters } from '../lib/fonts.mjs';
import { root } from '../lib/paths.mjs';
import { catalogue, catalogueIds } from '../lib/words.mjs';
import { openFont } from './support/font_reader.mjs';

const file = (path) => join(root, 'node_modules', path);
const icons = file('lucide-static/font/lucide.ttf');
const codes = iconCodes();

test('the list of icons of the canvas is found, and its codes are those of the font', () => {
  assert.ok(codes.length >= 20);
  const names = JSON.parse(readFileSync(file('lucide-static/font/codepoints.json'), 'utf8'));
  const text = readFileSync(join(root, 'web/ui/icons.h'), 'utf8');
  for (const [, name, code] of text.matchAll(/Icon\{"([a-z0-9-]+)",\s*(\d+)\}/g))
    assert.equal(names[name], Number(code), name);
});

test('every icon that is used is in the font as it was, and no other', async () => {
  const [before, after] = [openFont(readFileSync(icons)), openFont(await iconFont(icons))];
  assert.deepEqual([...after.codes].sort(), [...new Set(codes)].sort());
  for (const code of codes) {
    assert.ok(before.outline(code).length > 0);
    assert.equal(after.outline(code), before.outline(code), `icon ${code}`);
    assert.equal(after.advance(code), before.advance(code), `icon ${code}`);
  }
});

for (const style of ['400Regular', '600SemiBold']) {
  test(`Inter ${style} has the letters of the canvas as they were, without kerning, which the canvas does not know`, async () => {
    const path = file(`@expo-google-fonts/inter/${style}/Inter_${style}.ttf`);
    const [before, after] = [openFont(readFileSync(path)), openFont(await textFont(path))];
    for (const letter of textLetters()) {
      const code = letter.codePointAt(0);
      if (!before.codes.has(code)) continue;
      assert.equal(after.outline(code), before.outline(code), letter);
      assert.equal(after.advance(code), before.advance(code), letter);
    }
    for (const pair of ['AV', 'To', 'Wä', 'Ту'])
      assert.equal(after.width(pair), after.width(pair[0]) + after.width(pair[1]), pair);
  });
}

test('Inter has every Latin letter of every catalogue', async () => {
  const font = openFont(await textFont(file('@expo-google-fonts/inter/400Regular/Inter_400Regular.ttf')));
  for (const id of catalogueIds()) {
    const words = Object.entries(catalogue(id)).flat().join(' ');
    const missing = [...new Set(words)].filter(
      (letter) => /\p{Script=Latin}/u.test(letter) && !font.codes.has(letter.codePointAt(0)),
    );
    assert.deepEqual(missing, [], id);
  }
});
