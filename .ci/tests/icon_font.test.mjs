// The icon font of the page: fewer outlines, none of them changed.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { iconOf, subsetFont, usedIconCodes } from '../lib/icon_font.mjs';
import { root } from '../lib/paths.mjs';

const folder = join(root, 'node_modules/lucide-static/font');
const font = readFileSync(join(folder, 'lucide.ttf'));
const codes = usedIconCodes();

test('the list of icons of the canvas is found, and its codes are those of the font', () => {
  assert.ok(codes.length >= 20);
  const names = JSON.parse(readFileSync(join(folder, 'codepoints.json'), 'utf8'));
  const text = readFileSync(join(root, 'web/ui/icons.h'), 'utf8');
  for (const [, name, code] of text.matchAll(/Icon\{"([a-z0-9-]+)",\s*(\d+)\}/g))
    assert.equal(names[name], Number(code), name);
});

test('every icon that is used keeps its outline and width; the others are empty', () => {
  const small = subsetFont(font, codes);
  assert.ok(small.length < font.length / 8, `${small.length} of ${font.length} bytes`);
  const trimmed = (outline) => outline.toString('hex').replace(/(00)+$/, '');
  for (const code of codes) {
    const [before, after] = [iconOf(font, code), iconOf(small, code)];
    assert.ok(before.outline.length > 0);
    assert.deepEqual(
      [trimmed(after.outline), after.advance],
      [trimmed(before.outline), before.advance],
      `icon ${code}`,
    );
  }
  const names = JSON.parse(readFileSync(join(folder, 'codepoints.json'), 'utf8'));
  const unused = Object.values(names)
    .filter((code) => !codes.includes(code) && iconOf(font, code))
    .slice(0, 50);
  for (const code of unused)
    assert.ok(
      codes.some((used) => iconOf(font, used).outline.equals(iconOf(font, code).outline)) ||
        iconOf(small, code).outline.length === 0,
    );
});

test('an icon that the font lacks stops the build', () => {
  assert.throws(() => subsetFont(font, [...codes, 0x41]), /no icon 65/);
});
