// A pen for the keyboard: Enter brings it to the middle of the picture, arrows move it, Space puts it
// down and lifts it, Escape puts it away. What it draws is what a mouse would have drawn.
import { byId } from './dom.ts';
import { kDevice, kPointerKind } from './engine.ts';
import type { Engine } from './engine.ts';
import { sizeOf } from './surface.ts';
import { canvasLength } from './text_size.ts';

const kStep = 10,
  kLongStep = 40;
/** A moved pen leaves a point every so many pixels, as a hand would. */
const kTrail = 4;
const kPenId = 1 << 20; // no browser pointer has it

interface Point {
  x: number;
  y: number;
}

export interface PenPage {
  canvas: HTMLCanvasElement;
  engine: Engine;
  say(text: string): void;
}

export class KeyboardPen {
  private readonly cross = byId('pen');
  private at: Point | null = null;
  private isDown = false;

  constructor(private readonly page: PenPage) {
    page.canvas.addEventListener('blur', () => this.putAway());
    page.canvas.addEventListener('pointerdown', () => this.putAway());
  }

  get isOut(): boolean {
    return this.at !== null;
  }

  /** True when the pen used the key. */
  key(event: KeyboardEvent): boolean {
    if (document.activeElement !== this.page.canvas || event.ctrlKey || event.metaKey || event.altKey) return false;
    if (!this.at) return event.key === 'Enter' && this.take();
    const step = event.shiftKey ? kLongStep : kStep;
    switch (event.key) {
      case 'ArrowLeft':
        return this.move(-step, 0);
      case 'ArrowRight':
        return this.move(step, 0);
      case 'ArrowUp':
        return this.move(0, -step);
      case 'ArrowDown':
        return this.move(0, step);
      case ' ':
      case 'Enter':
        return this.press();
      case 'Escape':
        return this.putAway();
      default:
        return false;
    }
  }

  private take(): boolean {
    const { picture } = this.page.engine.view;
    if (!picture) return false;
    const { topLeft, bottomRight } = picture;
    this.at = { x: (topLeft.x + bottomRight.x) / 2, y: (topLeft.y + bottomRight.y) / 2 };
    this.show();
    this.page.say('Pen in the middle of the picture. Arrows move it, Space puts it down, Escape puts it away.');
    return true;
  }

  private press(): boolean {
    this.isDown = !this.isDown;
    this.send(this.isDown ? kPointerKind.down : kPointerKind.up);
    this.show();
    this.page.say(this.isDown ? 'Pen down. Arrows draw, Space lifts it.' : 'Pen up.');
    return true;
  }

  private move(dx: number, dy: number): boolean {
    const from = this.at!;
    const { width, height } = sizeOf(this.page.canvas);
    const to = {
      x: Math.max(0, Math.min(from.x + dx, width)),
      y: Math.max(0, Math.min(from.y + dy, height)),
    };
    const steps = Math.max(1, Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / kTrail));
    for (let i = 1; i <= steps; ++i) {
      this.at = { x: from.x + ((to.x - from.x) * i) / steps, y: from.y + ((to.y - from.y) * i) / steps };
      this.send(kPointerKind.move);
    }
    this.show();
    return true;
  }

  private putAway(): boolean {
    const wasOut = this.at !== null;
    if (this.isDown) this.send(kPointerKind.cancel);
    this.isDown = false;
    this.at = null;
    this.cross.hidden = true;
    return wasOut;
  }

  private show(): void {
    this.cross.hidden = false;
    this.cross.classList.toggle('pen-down', this.isDown);
    this.cross.style.transform = `translate(${canvasLength(this.at!.x)}, ${canvasLength(this.at!.y)})`;
  }

  private send(kind: number): void {
    this.page.engine.pointer({
      kind,
      id: kPenId,
      device: kDevice.mouse,
      button: kind === kPointerKind.move ? -1 : 0,
      buttons: this.isDown ? 1 : 0,
      x: this.at!.x,
      y: this.at!.y,
      pressure: this.isDown ? 0.5 : 0,
      timeMs: performance.now(),
      modifiers: 0,
    });
  }
}
