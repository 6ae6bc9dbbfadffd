// A ghost hand that shows what to do: it draws a bone through the first sample, three times, and rests.
import { icon } from './icons.ts';

export interface GhostPath {
  /** Picture pixels. */
  spine: [number, number][];
  width: number;
  height: number;
}

const kSvg = 'http://www.w3.org/2000/svg';
const kRounds = 3;
const kRoundMs = 3400;
const kDrawnAt = 0.62; // share of a round that is drawing; the rest holds and fades
const kSteps = 30;

function svgElement(name: string, attributes: Record<string, string>): SVGElement {
  const element = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

/** Points at equal steps along a polyline. */
function stepsAlong(points: [number, number][]): [number, number][] {
  const lengths = [0];
  for (let i = 1; i < points.length; ++i) {
    const [a, b] = [points[i - 1]!, points[i]!];
    lengths.push(lengths[i - 1]! + Math.hypot(b[0] - a[0], b[1] - a[1]));
  }
  const total = lengths.at(-1) ?? 0;
  return Array.from({ length: kSteps + 1 }, (_, step) => {
    const at = (total * step) / kSteps;
    const i = Math.max(
      1,
      lengths.findIndex((length) => length >= at),
    );
    const [a, b] = [points[i - 1]!, points[i]!];
    const t = (at - lengths[i - 1]!) / Math.max(1e-9, lengths[i]! - lengths[i - 1]!);
    return [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
  });
}

/** The drawing over a picture of the given size; `scale` = picture pixels per CSS pixel. */
export function ghostHand({ spine, width, height }: GhostPath, scale: number): { element: SVGElement; play(): void } {
  const svg = svgElement('svg', {
    viewBox: `-0.5 -0.5 ${width} ${height}`,
    class: 'ghost',
    'aria-hidden': 'true',
    preserveAspectRatio: 'none',
  });
  const outline = svgElement('path', { class: 'ghost-halo', pathLength: '1' });
  const line = svgElement('path', { class: 'ghost-line', pathLength: '1' });
  const d = `M${spine.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}`;
  for (const [path, cssPixels] of [
    [outline, 7],
    [line, 4],
  ] as const) {
    path.setAttribute('d', d);
    path.setAttribute('stroke-width', String(cssPixels * scale));
  }
  const hand = svgElement('g', { class: 'ghost-hand' });
  const pencil = icon('pencil');
  const size = 26 * scale;
  pencil.setAttribute('width', String(size));
  pencil.setAttribute('height', String(size));
  pencil.setAttribute('x', String(-0.09 * size));
  pencil.setAttribute('y', String(-0.91 * size)); // the tip of the drawn pencil
  const disc = svgElement('circle', { class: 'ghost-tip', r: String(6 * scale) });
  hand.append(disc, pencil);
  svg.append(outline, line, hand);
  const points = stepsAlong(spine);
  const end = points.at(-1) ?? [0, 0];
  hand.style.transform = `translate(${end[0]}px, ${end[1]}px)`;
  return { element: svg, play: () => play(svg, [outline, line], hand, points) };
}

function play(svg: SVGElement, paths: SVGElement[], hand: SVGElement, points: [number, number][]): void {
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) return; // the finished line says enough
  const timing = { duration: kRoundMs, iterations: kRounds, easing: 'linear' };
  for (const path of paths) {
    path.style.strokeDasharray = '1 1';
    path.animate({ strokeDashoffset: [1, 0, 0], offset: [0, kDrawnAt, 1] }, timing);
  }
  const moves = points.map(([x, y], i) => ({
    transform: `translate(${x}px, ${y}px)`,
    offset: (kDrawnAt * i) / kSteps,
  }));
  hand.animate([...moves, { ...moves.at(-1)!, offset: 1 }], timing);
  svg.animate({ opacity: [0, 1, 1, 0], offset: [0, 0.06, 0.9, 1] }, timing);
}
