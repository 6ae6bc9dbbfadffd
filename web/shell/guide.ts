// What a newcomer sees over the canvas: one line of advice, and the ghost hand on the first sample and in tasks.
import { adviceFor } from './advice.ts';
import type { Advised } from './coach.ts';
import { byId } from './dom.ts';
import { ghostHand } from './ghost_hand.ts';
import type { GhostPath } from './ghost_hand.ts';
import type { ShellView } from './shell_view.ts';
import type { Sample } from './start_page.ts';
import type { Drawing } from './task_drawings.ts';
import { canvasLength, canvasUnit, putOver } from './text_size.ts';
import { t } from './words/words.ts';

/** Units of the canvas: around the hint, beside the view's title, over the view's buttons, under the strip of several pictures. */
const kGap = 12,
  kTitleRoom = 72,
  kToolsRoom = 56,
  kStripRoom = 60;
/** Under this width there is a strip of tabs below the views. */
const kCompactWidth = 1000;

export class Guide {
  private readonly hint = byId('hint');
  private readonly layer = byId('ghost-layer');
  private sample: Sample | null = null;
  /** What the ghost drew, and who puts a pen down has understood. */
  private understood: Drawing | null = null;
  private ghost: { element: SVGElement; of: Sample | Drawing } | null = null;

  constructor() {
    byId('canvas').addEventListener('pointerdown', () => this.offer(null));
  }

  /** The sample whose line is to be shown over the picture, or none. */
  offer(sample: Sample | null): void {
    this.sample = sample;
    if (this.ghost && !('spine' in this.ghost.of)) this.understood = this.ghost.of;
    this.clear();
  }

  /**
   * Follows the picture while there is no part; then it is gone for good. A step of a task takes the place of the usual advice.
   * True where the advice is shown.
   */
  update(view: ShellView, step: Advised | null): boolean {
    const advice = adviceFor(view);
    this.hint.hidden = advice === '';
    if (advice === '' || !view.picture) {
      this.sample = null;
      this.clear();
      return false;
    }
    const words = step?.words ?? t(advice);
    if (this.hint.textContent !== words) this.hint.textContent = words;
    const { topLeft, bottomRight } = view.picture;
    this.placeHint(topLeft, bottomRight, view.pictures > 1 ? kStripRoom : 0);
    const shown = this.sample ?? step?.drawing ?? null;
    if (this.ghost?.of !== shown) this.clear();
    const path = shown && this.pathOf(shown, view.picture);
    if (shown && path) this.placeGhost(shown, path, topLeft, bottomRight);
    return true;
  }

  private clear(): void {
    this.ghost?.element.remove();
    this.ghost = null;
  }

  /** What the ghost draws on this picture; null: it does not belong on it, or need not be shown again. */
  private pathOf(
    shown: Sample | Drawing,
    { width, height, strokes }: NonNullable<ShellView['picture']>,
  ): GhostPath | null {
    if ('spine' in shown) return shown.width === width && shown.height === height ? shown : null;
    if (shown === this.understood || strokes > 0) return null;
    const side = Math.min(width, height);
    return { width, height, spine: shown.map(([x, y]) => [width / 2 + x * side, height / 2 + y * side]) };
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

  private placeGhost(
    of: Sample | Drawing,
    path: GhostPath,
    topLeft: { x: number; y: number },
    bottomRight: { x: number; y: number },
  ): void {
    const width = bottomRight.x - topLeft.x;
    const ghost = this.ghost ? null : ghostHand(path, path.width / Math.max(1, width));
    this.ghost ??= { element: ghost!.element, of };
    if (ghost) this.layer.append(ghost.element);
    putOver(this.ghost.element, [topLeft.x, topLeft.y, width, bottomRight.y - topLeft.y]);
    ghost?.play();
  }
}
