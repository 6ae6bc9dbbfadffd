// Two-finger tap undoes, three-finger tap redoes: all fingers down and up again quickly, without moving.

const kDownWithinMs = 250;
const kUpWithinMs = 300;
const kMovedPixels = 12;

interface Finger {
  x: number;
  y: number;
}

export class TapFinder {
  private readonly fingers = new Map<number, Finger>();
  private firstDown = 0;
  private lastDown = 0;
  private most = 0;
  private spoiled = false;

  down(id: number, x: number, y: number, timeMs: number): void {
    if (this.fingers.size === 0) {
      this.firstDown = timeMs;
      this.most = 0;
      this.spoiled = false;
    }
    this.fingers.set(id, { x, y });
    this.lastDown = timeMs;
    this.most = Math.max(this.most, this.fingers.size);
    if (timeMs - this.firstDown > kDownWithinMs) this.spoiled = true;
  }

  move(id: number, x: number, y: number): void {
    const finger = this.fingers.get(id);
    if (finger && Math.hypot(x - finger.x, y - finger.y) > kMovedPixels) this.spoiled = true;
  }

  /** The number of fingers of a tap that ends now (2 or 3), else 0. */
  up(id: number, timeMs: number): number {
    this.fingers.delete(id);
    if (this.fingers.size > 0 || this.spoiled || timeMs - this.lastDown > kUpWithinMs) return 0;
    return this.most === 2 || this.most === 3 ? this.most : 0;
  }

  cancel(id: number): void {
    this.fingers.delete(id);
    this.spoiled = true;
  }
}
