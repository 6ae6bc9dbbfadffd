// Our own pointer bridge: mouse, touch and pen with pressure and every coalesced move, without palms.
import { kDevice, kPointerKind } from './engine.ts';
import type { Engine, PointerSample } from './engine.ts';
import { modifiersOf } from './keyboard.ts';
import { PalmFilter } from './palm.ts';
import { TapFinder } from './taps.ts';
import { canvasUnit } from './text_size.ts';

export interface PointerPage {
  canvas: HTMLCanvasElement;
  engine: Engine;
  undo(): void;
  redo(): void;
}

const kLinePixels = 16;

function deviceOf(event: PointerEvent): number {
  if (event.pointerType === 'pen') return kDevice.pen;
  return event.pointerType === 'touch' ? kDevice.touch : kDevice.mouse;
}

/** Wheel travel in pixels, whatever unit the browser counts in. */
export function wheelPixels(delta: number, mode: number, pagePixels: number): number {
  if (mode === 1) return delta * kLinePixels;
  return mode === 2 ? delta * pagePixels : delta;
}

class PointerBridge {
  private readonly palms = new PalmFilter();
  private readonly taps = new TapFinder();
  private box: DOMRect;
  private unit: number;

  constructor(private readonly page: PointerPage) {
    this.box = page.canvas.getBoundingClientRect();
    this.unit = canvasUnit();
  }

  /** Looks where the canvas is now. */
  private look(): void {
    this.box = this.page.canvas.getBoundingClientRect();
    this.unit = canvasUnit();
  }

  /** Where the pointer is on the canvas, in its units. */
  private placeOf(event: MouseEvent): { x: number; y: number } {
    return { x: (event.clientX - this.box.left) / this.unit, y: (event.clientY - this.box.top) / this.unit };
  }

  down(event: PointerEvent): void {
    const { canvas } = this.page;
    this.look();
    event.preventDefault(); // no compatibility mouse events
    canvas.focus({ preventScroll: true });
    const device = deviceOf(event);
    const contact = { x: event.clientX, y: event.clientY, timeMs: event.timeStamp };
    if (device === kDevice.pen) {
      for (const id of this.palms.penDown(contact)) this.cancelTouch(id, event);
    }
    if (device === kDevice.touch) {
      if (!this.palms.touchDown(event.pointerId, contact)) return;
      this.taps.down(event.pointerId, event.clientX, event.clientY, event.timeStamp);
    }
    this.capture(event.pointerId);
    this.send(event, kPointerKind.down);
  }

  move(event: PointerEvent): void {
    this.look();
    const device = deviceOf(event);
    if (device === kDevice.touch) {
      if (!this.palms.isUsed(event.pointerId)) return;
      this.taps.move(event.pointerId, event.clientX, event.clientY);
    }
    if (device === kDevice.pen) {
      this.palms.penMoved({ x: event.clientX, y: event.clientY, timeMs: event.timeStamp });
    }
    const coalesced = event.getCoalescedEvents?.() ?? [];
    for (const sample of coalesced.length > 0 ? coalesced : [event]) this.send(sample, kPointerKind.move, event);
  }

  up(event: PointerEvent, kind: number): void {
    if (deviceOf(event) !== kDevice.touch) {
      this.send(event, kind);
      return;
    }
    if (!this.palms.isUsed(event.pointerId)) return;
    this.palms.touchUp(event.pointerId);
    this.send(event, kind);
    if (kind === kPointerKind.cancel) {
      this.taps.cancel(event.pointerId);
      return;
    }
    const fingers = this.taps.up(event.pointerId, event.timeStamp);
    if (fingers === 2) this.page.undo();
    if (fingers === 3) this.page.redo();
  }

  leave(event: PointerEvent): void {
    if (deviceOf(event) === kDevice.pen) this.palms.penLeft(event.timeStamp);
    if (deviceOf(event) !== kDevice.touch) this.send(event, kPointerKind.leave);
  }

  /** Before it comes to the canvas: what is there is as large as this kind of pointer needs, before it is pressed. */
  elsewhere(event: PointerEvent): void {
    if (event.target !== this.page.canvas) this.send(event, kPointerKind.leave);
  }

  wheel(event: WheelEvent): void {
    event.preventDefault(); // the page itself never scrolls or zooms under the drawing
    this.look();
    const pixels = (delta: number) => wheelPixels(delta, event.deltaMode, this.box.height) / this.unit;
    const { x, y } = this.placeOf(event);
    this.page.engine.wheel(x, y, pixels(event.deltaX), pixels(event.deltaY), modifiersOf(event));
  }

  private capture(id: number): void {
    try {
      this.page.canvas.setPointerCapture(id);
    } catch {
      // The pointer is gone already, or a script made it up: its stroke then ends at the canvas' edge.
    }
  }

  private cancelTouch(id: number, event: PointerEvent): void {
    this.taps.cancel(id);
    this.page.engine.pointer({
      ...this.sample(event, kPointerKind.cancel),
      id,
      device: kDevice.touch,
      buttons: 0,
      pressure: 0,
    });
  }

  private send(event: PointerEvent, kind: number, parent = event): void {
    this.page.engine.pointer({ ...this.sample(event, kind), id: parent.pointerId, device: deviceOf(parent) });
  }

  private sample(event: PointerEvent, kind: number): PointerSample {
    return {
      kind,
      id: event.pointerId,
      device: deviceOf(event),
      button: event.button,
      buttons: event.buttons,
      ...this.placeOf(event),
      pressure: event.pressure,
      timeMs: event.timeStamp,
      modifiers: modifiersOf(event),
    };
  }
}

/** Connects the canvas; nothing is sent before this. */
export function connectPointer(page: PointerPage): void {
  const { canvas } = page;
  const bridge = new PointerBridge(page);
  canvas.addEventListener('pointerdown', (event) => bridge.down(event));
  canvas.addEventListener('pointermove', (event) => bridge.move(event));
  canvas.addEventListener('pointerup', (event) => bridge.up(event, kPointerKind.up));
  canvas.addEventListener('pointercancel', (event) => bridge.up(event, kPointerKind.cancel));
  canvas.addEventListener('pointerleave', (event) => bridge.leave(event));
  window.addEventListener('pointerdown', (event) => bridge.elsewhere(event), { capture: true });
  canvas.addEventListener('wheel', (event) => bridge.wheel(event), { passive: false });
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  // iOS: a touch that begins on the drawing must not scroll, zoom or select.
  for (const type of ['touchstart', 'touchmove', 'gesturestart']) {
    canvas.addEventListener(type, (event) => event.preventDefault(), { passive: false });
  }
}
