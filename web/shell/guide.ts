// What a newcomer sees over the canvas: one line of advice, and on the first sample the ghost hand.
import { byId } from './dom.ts';
import { ghostHand } from './ghost_hand.ts';
import type { ShellView } from './shell_view.ts';
import type { Sample } from './start_page.ts';
import { canvasLength, canvasUnit, putOver } from './text_size.ts';
import { t } from './words/words.ts';

/** Units of the canvas: around the hint, beside the view's title, over the view's buttons, under the strip of several pictures. */
const kGap = 12,
  kTitleRoom = 72,
  kToolsRoom = 56,
  kStripRoom = 60;
/** Under this width there is a strip of tabs below the views. */
const kCompactWidth = 1000;

/** One line about what to do next; '' where none is needed. */
function adviceFor({ picture, parts, tool, penMenu }: ShellView): string {
  if (!picture || parts > 0 || penMenu) return ''; // a menu needs the room
  if (tool === 'spin' || tool === 'layers' || tool === 'shapes' || tool === 'lines') return ''; // the view says what to draw
  if (picture.sketch && picture.strokes === 0) return 'Draw the outline of a thing';
  if (picture.sketch && tool !== 'draw') return picture.finished ? 'Take Line and draw through its middle' : '';
  if (picture.sketch && picture.finished) return ''; // line, puff and flat are offered beside the drawing
  if (tool === 'puff' || tool === 'sheet') return ''; // the bar of the tool is there
  return 'Draw a line through the middle of the thing';
}

export class Guide {
  private readonly hint = byId('hint');
  private readonly layer = byId('ghost-layer');
  private sample: Sample | null = null;
  private ghost: SVGElement | null = null;

  constructor() {
    // Who puts a pen down has understood.
    byId('canvas').addEventListener('pointerdown', () => this.offer(null));
  }

  /** The sample whose line is to be shown over the picture, or none. */
  offer(sample: Sample | null): void {
    this.sample = sample;
    this.ghost?.remove();
    this.ghost = null;
  }

  /** Follows the picture while there is no part; then it is gone for good. */
  update(view: ShellView): void {
    const advice = adviceFor(view);
    this.hint.hidden = advice === '';
    if (advice === '' || !view.picture) {
      this.offer(null);
      return;
    }
    const words = t(advice);
    if (this.hint.textContent !== words) this.hint.textContent = words;
    const { width, height, topLeft, bottomRight } = view.picture;
    this.placeHint(topLeft, bottomRight, view.pictures > 1 ? kStripRoom : 0);
    const fits = this.sample?.width === width && this.sample.height === height;
    if (this.sample && fits) this.placeGhost(this.sample, topLeft, bottomRight);
  }

  private placeHint(topLeft: { x: number; y: number }, bottomRight: { x: number; y: number }, strip: number): void {
    const box = byId('canvas');
    const unit = canvasUnit();
    const width = box.clientWidth / unit;
    const compact = width < kCompactWidth;
    const left = compact ? kTitleRoom : kGap,
      right = width - kGap;
    this.hint.style.maxWidth = canvasLength(right - left);
    const offsetWidth = this.hint.offsetWidth / unit,
      offsetHeight = this.hint.offsetHeight / unit;
    const middle = (topLeft.x + bottomRight.x) / 2 - offsetWidth / 2;
    const x = Math.max(left, Math.min(middle, right - offsetWidth));
    // Under the picture where nothing else is, otherwise beside the view's title.
    const below = bottomRight.y + kGap;
    const fitsBelow = !compact && below + offsetHeight + kToolsRoom <= box.clientHeight / unit;
    const y = fitsBelow ? below : kGap + strip;
    this.hint.style.transform = `translate(${canvasLength(Math.round(x))}, ${canvasLength(Math.round(y))})`;
  }

  private placeGhost(sample: Sample, topLeft: { x: number; y: number }, bottomRight: { x: number; y: number }): void {
    const width = bottomRight.x - topLeft.x;
    const isNew = this.ghost === null;
    const ghost = isNew ? ghostHand(sample, sample.width / Math.max(1, width)) : null;
    this.ghost ??= ghost!.element;
    if (isNew) this.layer.append(this.ghost);
    putOver(this.ghost, [topLeft.x, topLeft.y, width, bottomRight.y - topLeft.y]);
    ghost?.play();
  }
}
