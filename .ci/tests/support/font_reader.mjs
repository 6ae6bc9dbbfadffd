// Reading a font's letters with HarfBuzz.
import * as hb from 'harfbuzzjs';

/** A font file: its code points, and the outlines (SVG paths) and widths of letters in font units. */
export function openFont(bytes) {
  const face = new hb.Face(new hb.Blob(new Uint8Array(bytes)));
  const font = new hb.Font(face);
  const glyph = (code) => font.nominalGlyph(code);
  return {
    codes: new Set(face.collectUnicodes()),
    outline: (code) => font.glyphToPath(glyph(code)),
    advance: (code) => font.glyphHAdvance(glyph(code)),
    /** Of a text, with its kerning. */
    width(text) {
      const buffer = new hb.Buffer();
      buffer.addText(text);
      buffer.guessSegmentProperties();
      hb.shape(font, buffer);
      return buffer.getGlyphPositions().reduce((sum, { xAdvance }) => sum + xAdvance, 0);
    },
  };
}
