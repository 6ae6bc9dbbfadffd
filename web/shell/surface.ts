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

/** Tells whether the system asks for a dark page, now and whenever that changes. */
export function watchTheme(onTheme: (dark: boolean) => void): void {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  onTheme(dark.matches);
  dark.addEventListener('change', () => onTheme(dark.matches));
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
