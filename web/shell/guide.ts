// What a newcomer sees over the canvas: one line of advice, and on the first sample the ghost hand.
import type { State } from './api.ts';
import { byId } from './dom.ts';
import { ghostHand } from './ghost_hand.ts';
import type { Sample } from './start_page.ts';

/** CSS pixels around the hint, and what the view's title needs at the top. */
const kGap = 12, kTitleRoom = 44;

type ToCanvas = (x: number, y: number) => { x: number; y: number };

export class Guide {
  private readonly hint = byId('hint');
  private readonly layer = byId('ghost-layer');
  private sample: Sample | null = null;
  private ghost: SVGElement | null = null;

  /** The sample whose line is to be shown over the picture, or none. */
  offer(sample: Sample | null): void {
    this.sample = sample;
    this.ghost?.remove();
    this.ghost = null;
  }

  /** Follows the picture while there is no part; then it is gone for good. */
  update(state: State, toCanvas: ToCanvas): void {
    const needed = state.picture !== null && state.parts.length === 0;
    this.hint.hidden = !needed;
    if (!needed || !state.picture) {
      this.offer(null);
      return;
    }
    const { width, height } = state.picture;
    const topLeft = toCanvas(-0.5, -0.5);
    const bottomRight = toCanvas(width - 0.5, height - 0.5);
    this.placeHint(topLeft, bottomRight);
    const fits = this.sample?.width === width && this.sample.height === height;
    if (this.sample && fits) this.placeGhost(this.sample, topLeft, bottomRight);
  }

  private placeHint(topLeft: { x: number; y: number }, bottomRight: { x: number; y: number }): void {
    const box = byId('canvas');
    const half = this.hint.offsetWidth / 2 + 8;
    const x = Math.max(half, Math.min((topLeft.x + bottomRight.x) / 2, box.clientWidth - half));
    const below = bottomRight.y + kGap, above = topLeft.y - kGap - this.hint.offsetHeight;
    const fitsBelow = below + this.hint.offsetHeight + kGap <= box.clientHeight;
    // On a picture that fills the view the hint covers its foot rather than nothing at all.
    const y = fitsBelow ? below : above >= kTitleRoom ? above : Math.min(bottomRight.y, box.clientHeight) - kGap - this.hint.offsetHeight;
    this.hint.style.transform = `translate(${Math.round(x - this.hint.offsetWidth / 2)}px, ${Math.round(y)}px)`;
  }

  private placeGhost(sample: Sample, topLeft: { x: number; y: number }, bottomRight: { x: number; y: number }): void {
    const width = bottomRight.x - topLeft.x;
    const isNew = this.ghost === null;
    const ghost = isNew ? ghostHand(sample, sample.width / Math.max(1, width)) : null;
    this.ghost ??= ghost!.element;
    if (isNew) this.layer.append(this.ghost);
    this.ghost.style.left = `${topLeft.x}px`;
    this.ghost.style.top = `${topLeft.y}px`;
    this.ghost.style.width = `${width}px`;
    this.ghost.style.height = `${bottomRight.y - topLeft.y}px`;
    ghost?.play();
  }
}
