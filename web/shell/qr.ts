// QR codes as SVG.
import { create } from 'qrcode/lib/core/qrcode.js';
import { t } from './words/words.ts';

/** Modules of white round a QR code (ISO/IEC 18004). */
const kQuiet = 4;

/** Longest text that a QR code holds, characters (ISO/IEC 18004, version 40-L). */
export const kMostInCode = 2953;

/** A QR code black on white in any theme, so that every camera reads it, and how many modules wide it is with its margin. */
export function qrCode(text: string): { svg: SVGElement; modules: number } {
  const { size, data } = create(text, { errorCorrectionLevel: 'L' }).modules;
  const rows = Array.from({ length: size }, (_, y) =>
    Array.from(data.subarray(y * size, (y + 1) * size), (dark, x) => (dark ? `M${x} ${y}h1v1h-1z` : '')).join(''),
  );
  const modules = size + 2 * kQuiet;
  const holder = document.createElement('template');
  holder.innerHTML =
    `<svg viewBox="${-kQuiet} ${-kQuiet} ${modules} ${modules}" shape-rendering="crispEdges" role="img">` +
    `<path fill="#fff" d="M${-kQuiet} ${-kQuiet}h${modules}v${modules}h${-modules}z"/><path d="${rows.join('')}"/></svg>`;
  const svg = holder.content.querySelector('svg') as SVGElement;
  svg.setAttribute('class', 'share-code');
  svg.setAttribute('aria-label', t('QR code of the link'));
  return { svg, modules };
}
