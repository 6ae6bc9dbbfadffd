// What a newcomer sees over the canvas: one line of advice, and the ghost hand on the first sample and in tasks.
import { adviceFor } from './advice.ts';
import type { Advised } from './coach.ts';
import { byId } from './dom.ts';
import { ghostHand } from './ghost_hand.ts';
import type { GhostPath } from './ghost_hand.ts';
import type { ShellView } from './shell_view.ts';
import type { Sample } from './start_page.ts';
import { exampleOn } from './task_drawings.ts';
import type { Example } from './task_drawings.ts';
import { canvasLength, canvasUnit, putOver } from './text_size.ts';
import { t } from './words/words.ts';

type Picture = NonNullable<ShellView['picture']>;

/** Units of the canvas: around the hint, beside the view's title, under the strip of several pictures. */
const kGap = 12,
  kTitleRoom = 72,
  kStripRoom = 60;
/** Under this width there is a strip of tabs below the views. */
const kCompactWidth = 1000;

/** How long a pen is away before the ghost hand comes back, milliseconds: what it drew may be known by then. */
const kBackMs = 600;

export class Guide {
  private readonly hint = byId('hint');
  private readonly layer = byId('ghost-layer');
  private sample: Sample | null = null;
  private ghost: { element: SVGElement; of: Sample | Example; d: string } | null = null;
  /** Shows the ghost hand as things are; it stays away while a pen is down. */
  private show: () => void = () => undefined;
  /** Infinity while a pen is down, then the timer after which it comes back, then 0. */
  private away = 0;

  constructor() {
    byId('canvas').addEventListener('pointerdown', () => {
      clearTimeout(this.away);
      this.away = Infinity;
      this.clear();
    });
    for (const type of ['pointerup', 'pointercancel'])
      addEventListener(type, () => {
        if (this.away === Infinity) this.away = window.setTimeout(() => this.comeBack(), kBackMs);
      });
  }

  /** The sample whose line is to be shown over the picture, or none. */
  offer(sample: Sample | null): void {
    this.sample = sample;
    this.clear();
  }

  /**
   * Follows the picture: advice while there is no part, the ghost hand in every step that has something to draw. A step of a
   * task takes the place of the usual advice. What is left to be told elsewhere: words that would lie over the picture, and
   * steps that come after the first part.
   */
  update(view: ShellView, step: Advised | null): Advised | null {
    if (!view.picture || view.parts > 0) this.sample = null;
    this.show = () => this.showGhost(view, step);
    this.show();
    const tools = view.picture ? byId('canvas').clientHeight / canvasUnit() - view.picture.buttons : 0;
    byId('toasts').style.setProperty('--tools', canvasLength(tools));
    const advice = adviceFor(view);
    this.hint.hidden = advice === '';
    if (advice === '' || !view.picture) return step;
    const told = step ?? { words: t(advice), example: null };
    if (this.hint.textContent !== told.words) this.hint.textContent = told.words;
    this.hint.hidden = !this.placeHint(view.picture, view.pictures > 1 ? kStripRoom : 0);
    return this.hint.hidden ? told : null;
  }

  private comeBack(): void {
    this.away = 0;
    this.show();
  }

  private clear(): void {
    this.ghost?.element.remove();
    this.ghost = null;
  }

  private showGhost({ picture, tool }: ShellView, step: Advised | null): void {
    const hasPen = tool === 'pen' || tool === 'eraser';
    const shown = this.sample ?? step?.example ?? null;
    const path = picture && shown && this.away === 0 ? pathOf(shown, picture, hasPen) : null;
    if (!picture || !shown || !path) {
      this.clear();
      return;
    }
    const d = `${path.spine}`;
    if (this.ghost?.of !== shown || this.ghost.d !== d) this.clear();
    const { topLeft, bottomRight } = picture;
    const width = bottomRight.x - topLeft.x;
    const ghost = this.ghost ? null : ghostHand(path, path.width / Math.max(1, width));
    this.ghost ??= { element: ghost!.element, of: shown, d };
    if (ghost) this.layer.append(ghost.element);
    putOver(this.ghost.element, [topLeft.x, topLeft.y, width, bottomRight.y - topLeft.y]);
    ghost?.play();
  }

  /** True where it does not lie over the picture. */
  private placeHint({ topLeft, bottomRight, buttons }: Picture, strip: number): boolean {
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
    const fitsBelow = !compact && below + offsetHeight <= buttons;
    const y = fitsBelow ? below : kGap + strip;
    const isClear = fitsBelow || y + offsetHeight <= topLeft.y;
    this.hint.style.transform = `translate(${canvasLength(Math.round(x))}, ${canvasLength(Math.round(y))})`;
    return isClear;
  }
}

/** What the ghost draws on this picture; null: it does not belong on it, or asks for another tool than the pen. */
function pathOf(
  shown: Sample | Example,
  picture: NonNullable<ShellView['picture']>,
  hasPen: boolean,
): GhostPath | null {
  const { width, height } = picture;
  if ('spine' in shown) return shown.width === width && shown.height === height ? shown : null;
  const spine = shown.on !== null && hasPen ? null : exampleOn(shown, picture);
  return spine && { width, height, spine };
}
