// Which touches are a palm. The first pen contact switches to pen mode; from then on a touch that
// comes within kPalmMs of the pen, or within kPalmPixels of a pen that is near the glass, is a palm.

export const kPalmMs = 500;
export const kPalmPixels = 200;

interface Contact {
  x: number;
  y: number;
  timeMs: number;
}

export class PalmFilter {
  private penMode = false;
  private penInRange = false;
  private lastPen: Contact | null = null;
  private readonly touches = new Map<number, Contact>();

  /** True after the first pen contact on this page. */
  get isPenMode(): boolean {
    return this.penMode;
  }

  /** The pen touches the glass; returns the touches that were palms all along and must be cancelled. */
  penDown(contact: Contact): number[] {
    this.penMode = true;
    this.penMoved(contact);
    const palms = [...this.touches].filter(([, touch]) => this.isNear(touch, contact)).map(([id]) => id);
    for (const id of palms) this.touches.delete(id);
    return palms;
  }

  /** The pen moves on the glass or hovers over it. */
  penMoved(contact: Contact): void {
    this.penInRange = true;
    this.lastPen = contact;
  }

  penLeft(timeMs: number): void {
    this.penInRange = false;
    if (this.lastPen) this.lastPen = { ...this.lastPen, timeMs };
  }

  /** A finger or a palm comes down: true when it is to be used. */
  touchDown(id: number, contact: Contact): boolean {
    const pen = this.lastPen;
    if (this.penMode && pen) {
      const soon = contact.timeMs - pen.timeMs < kPalmMs;
      const near = this.penInRange && Math.hypot(contact.x - pen.x, contact.y - pen.y) < kPalmPixels;
      if (soon || near) return false;
    }
    this.touches.set(id, contact);
    return true;
  }

  /** True for a touch that was used when it came down and has not turned out to be a palm. */
  isUsed(id: number): boolean {
    return this.touches.has(id);
  }

  touchUp(id: number): void {
    this.touches.delete(id);
  }

  private isNear(touch: Contact, pen: Contact): boolean {
    return pen.timeMs - touch.timeMs < kPalmMs || Math.hypot(touch.x - pen.x, touch.y - pen.y) < kPalmPixels;
  }
}
