// The canvas as a surface: its size in its own units, device pixels in a unit, and the WebGL context's life.
import { hideBanner, showBanner } from './banner.ts';
import type { Engine, Size } from './engine.ts';
import { canvasUnit } from './text_size.ts';

/** Browsers on tablets refuse canvases beyond this many pixels. */
const kMostPixels = 16_000_000;

/** Size of the canvas now; the ratio is lowered where the backing store would be too large. */
export function sizeOf(canvas: HTMLCanvasElement): Size {
  const unit = canvasUnit();
  const width = Math.max(1, canvas.clientWidth / unit);
  const height = Math.max(1, canvas.clientHeight / unit);
  const dpr = Math.min((window.devicePixelRatio || 1) * unit, Math.sqrt(kMostPixels / (width * height)));
  return { width, height, dpr };
}

/** True when this browser can draw with WebGL 2. */
export function hasWebGl2(): boolean {
  const probe = document.createElement('canvas');
  const context = probe.getContext('webgl2');
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return context !== null;
}

/** Watches size, zoom and screen changes. */
export function watchSize(canvas: HTMLCanvasElement, onSize: (size: Size) => void): void {
  const tell = () => onSize(sizeOf(canvas));
  new ResizeObserver(tell).observe(canvas);
  const watchRatio = () => {
    matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`).addEventListener(
      'change',
      () => {
        tell();
        watchRatio();
      },
      { once: true },
    );
  };
  watchRatio();
}

/** The colours of the style sheet that the canvas draws in, in the order of platform::Palette (web/platform/page.h). */
const kRoles = [
  ...['ink', 'muted', 'faint', 'paper', 'surface', 'line', 'canvas-accent', 'on-accent', 'accent-soft', 'hover'],
  ...['raised', 'trough', 'handle', 'warning', 'good', 'bubble', 'on-bubble', 'ground', 'ground-edge'],
];

/** Four bytes for each role: red, green, blue and an opacity that is always full. */
function paletteNow(): Uint8Array {
  const probe = document.createElement('span');
  probe.hidden = true;
  probe.style.setProperty('forced-color-adjust', 'none');
  document.body.append(probe);
  const bytes = kRoles.flatMap((role) => {
    probe.style.color = `var(--${role})`;
    const [red = 0, green = 0, blue = 0] =
      getComputedStyle(probe)
        .color.match(/[\d.]+/g)
        ?.map(Number) ?? [];
    return [red, green, blue, 255];
  });
  probe.remove();
  return Uint8Array.from(bytes);
}

/** Tells the colours of the canvas, now and whenever the system asks for others. */
export function watchPalette(onPalette: (palette: Uint8Array) => void): void {
  const tell = () => onPalette(paletteNow());
  tell();
  for (const asked of ['(prefers-color-scheme: dark)', '(prefers-contrast: more)', '(forced-colors: active)'])
    matchMedia(asked).addEventListener('change', tell);
}

export interface ContextPage {
  canvas: HTMLCanvasElement;
  engine: Engine;
  /** Says it to the visitor: the drawing comes back by itself. */
  say(text: string): void;
}

/** Graphics that are not back by then stay away. */
const kLongPauseMs = 5000;

/** The document lives in the engine, so a lost context costs nothing but the pixels. */
export function watchContext({ canvas, engine, say }: ContextPage): void {
  const id = 'graphics';
  let timer = 0;
  const stayAway = () =>
    showBanner({
      id,
      text: 'This device draws nothing any more. Your work is safe: save a file or load the page again.',
      actions: [
        { label: 'Save a file', command: 'save-project', run: () => engine.run('save-project') },
        { label: 'Load again', run: () => location.reload() },
      ],
      canDismiss: true,
    });
  canvas.addEventListener('webglcontextlost', (event) => {
    event.preventDefault(); // asks the browser to restore it
    engine.contextLost();
    say('The graphics paused; your work is kept.');
    timer = window.setTimeout(stayAway, kLongPauseMs);
  });
  canvas.addEventListener('webglcontextrestored', () => {
    clearTimeout(timer);
    hideBanner(id);
    engine.contextRestored();
    say('The graphics are back.');
  });
}
