// The icon font with only the icons that the page draws: of two thousand outlines some forty are left.
// Glyph numbers stay as they are; the others become empty, and tables that a rasteriser does not need are dropped.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './paths.mjs';

const kKept = ['cmap', 'glyf', 'head', 'hhea', 'hmtx', 'loca', 'maxp'];

/** The codepoints of web/ui/icons.h, which is the list of icons of the canvas. */
export function usedIconCodes(text = readFileSync(join(root, 'web/ui/icons.h'), 'utf8')) {
  return [...text.matchAll(/Icon\{"[a-z0-9-]+",\s*(\d+)\}/g)].map(([, code]) => Number(code));
}

function readTables(font) {
  const tables = {};
  for (let i = 0; i < font.readUInt16BE(4); ++i) {
    const at = 12 + 16 * i;
    const start = font.readUInt32BE(at + 8);
    tables[font.toString('latin1', at, at + 4)] = font.subarray(start, start + font.readUInt32BE(at + 12));
  }
  return tables;
}

/** Glyph of a codepoint by a format 4 subtable of `cmap`; 0 when it has none. */
function glyphOf(subtable, code) {
  const segments = subtable.readUInt16BE(6) / 2;
  const at = (array, i) => 14 + 2 * segments * array + (array > 0 ? 2 : 0) + 2 * i;
  for (let i = 0; i < segments; ++i) {
    if (code > subtable.readUInt16BE(at(0, i))) continue;
    const first = subtable.readUInt16BE(at(1, i));
    if (code < first) return 0;
    const delta = subtable.readUInt16BE(at(2, i));
    const offset = subtable.readUInt16BE(at(3, i));
    if (offset === 0) return (code + delta) & 0xffff;
    const glyph = subtable.readUInt16BE(at(3, i) + offset + 2 * (code - first));
    return glyph === 0 ? 0 : (glyph + delta) & 0xffff;
  }
  return 0;
}

function formatFour(cmap) {
  for (let i = 0; i < cmap.readUInt16BE(2); ++i) {
    const subtable = cmap.subarray(cmap.readUInt32BE(4 + 8 * i + 4));
    if (subtable.readUInt16BE(0) === 4) return subtable;
  }
  throw new Error('the icon font has no character map of format 4');
}

/** A glyph and the glyphs that it is composed of. */
function withComponents(glyph, outlines, seen) {
  const data = outlines[glyph];
  if (seen.has(glyph) || data === undefined) return;
  seen.add(glyph);
  if (data.length < 10 || data.readInt16BE(0) >= 0) return;
  for (let at = 10, more = true; more;) {
    const flags = data.readUInt16BE(at);
    withComponents(data.readUInt16BE(at + 2), outlines, seen);
    at += 4 + (flags & 1 ? 4 : 2) + (flags & 8 ? 2 : flags & 0x40 ? 4 : flags & 0x80 ? 8 : 0);
    more = (flags & 0x20) !== 0;
  }
}

function written(tables) {
  const names = Object.keys(tables).sort();
  const header = Buffer.alloc(12 + 16 * names.length);
  const power = 2 ** Math.floor(Math.log2(names.length));
  header.writeUInt32BE(0x00010000, 0);
  header.writeUInt16BE(names.length, 4);
  header.writeUInt16BE(16 * power, 6);
  header.writeUInt16BE(Math.log2(power), 8);
  header.writeUInt16BE(16 * (names.length - power), 10);
  const pieces = [header];
  let end = header.length;
  names.forEach((name, i) => {
    const padded = Buffer.concat([tables[name], Buffer.alloc(-tables[name].length & 3)]);
    let sum = 0;
    for (let at = 0; at < padded.length; at += 4) sum = (sum + padded.readUInt32BE(at)) >>> 0;
    header.write(name, 12 + 16 * i, 'latin1');
    header.writeUInt32BE(sum, 12 + 16 * i + 4);
    header.writeUInt32BE(end, 12 + 16 * i + 8);
    header.writeUInt32BE(tables[name].length, 12 + 16 * i + 12);
    pieces.push(padded);
    end += padded.length;
  });
  return Buffer.concat(pieces);
}

function outlinesOf(tables) {
  const long = tables.head.readInt16BE(50) === 1;
  const place = (i) => (long ? tables.loca.readUInt32BE(4 * i) : 2 * tables.loca.readUInt16BE(2 * i));
  return Array.from({ length: tables.maxp.readUInt16BE(4) }, (_, i) => tables.glyf.subarray(place(i), place(i + 1)));
}

/** The outline of a codepoint as the font stores it, and its advance width; null where it has none. */
export function iconOf(font, code) {
  const tables = readTables(font);
  const glyph = glyphOf(formatFour(tables.cmap), code);
  if (glyph === 0) return null;
  const widths = tables.hhea.readUInt16BE(34);
  return { outline: outlinesOf(tables)[glyph], advance: tables.hmtx.readUInt16BE(4 * Math.min(glyph, widths - 1)) };
}

/** The TrueType font with the outlines of `codes` alone. */
export function subsetFont(font, codes) {
  const tables = readTables(font);
  const outlines = outlinesOf(tables);
  const glyphs = outlines.length;
  const subtable = formatFour(tables.cmap);
  const kept = new Set();
  withComponents(0, outlines, kept);
  for (const code of codes) {
    const glyph = glyphOf(subtable, code);
    if (glyph === 0) throw new Error(`the icon font has no icon ${code}`);
    withComponents(glyph, outlines, kept);
  }
  const loca = Buffer.alloc(4 * (glyphs + 1));
  const data = [];
  let end = 0;
  outlines.forEach((outline, i) => {
    loca.writeUInt32BE(end, 4 * i);
    if (!kept.has(i)) return;
    data.push(outline, Buffer.alloc(-outline.length & 3));
    end += outline.length + (-outline.length & 3);
  });
  loca.writeUInt32BE(end, 4 * glyphs);
  const head = Buffer.from(tables.head);
  head.writeInt16BE(1, 50);
  const next = { ...tables, head, loca, glyf: Buffer.concat(data) };
  return written(Object.fromEntries(kKept.map((name) => [name, next[name]])));
}
