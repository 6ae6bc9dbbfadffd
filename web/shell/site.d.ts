// What the build tells the shell: the hashed names of everything in dist/, relative to index.html.
// esbuild replaces SPINELOFT_SITE by its value. The page chooses `threads` where `crossOriginIsolated` is true:
//   const { default: createSpineLoft } = await import(new URL(SPINELOFT_SITE.threads.js, document.baseURI).href);
// The loaders are told where they are (locateFile) and what their threads run (mainScriptUrlOrBlob).

interface SpineLoftVariant {
  readonly js: string;
  readonly wasm: string;
  /** What the loader fetches behind it by itself. */
  readonly second: string;
}

interface SpineLoftSite {
  readonly version: string;
  readonly threads: SpineLoftVariant;
  readonly single: SpineLoftVariant;
  /** The program of the worker that cuts out. */
  readonly cutOut: string;
  /** Every file of the repository's assets/ folder: 'samples/cup.jpg' → 'assets/samples/cup-0123456789.jpg'. */
  readonly assets: Readonly<Record<string, string>>;
  /** Every web/shell/NAME.worker.ts, bundled on its own: 'NAME' → its path, for boundScript. */
  readonly workers: Readonly<Record<string, string>>;
  /** The module of web/shell/words/speaker.ts. */
  readonly speaker: string;
  /** The module of web/shell/room/server_side.ts. */
  readonly serverSide: string;
  /** By language: fonts with the letters of its script, as TrueType files. */
  readonly scripts: Readonly<Record<string, { readonly text: string; readonly bold: string }>>;
  /** What view.html loads when it needs it: web/shell/view/derive.ts and room.ts. */
  readonly viewer: { readonly derive: string; readonly room: string };
  /** The service worker beside index.html; empty while the site is not whole. */
  readonly serviceWorker: string;
}

declare const SPINELOFT_SITE: SpineLoftSite;

/** In the service worker: all files of the release, by who needs them. `revision` is null where the name has a hash. */
declare const SPINELOFT_FILES: Readonly<
  Record<
    'page' | 'threads' | 'single' | 'rare',
    readonly { url: string; revision: string | null; integrity?: string }[]
  >
>;

// Files that can be imported: SVG as text (lucide-static/icons/NAME.svg), fonts and pictures as their hashed URL,
// relative to the importing script: new URL(interUrl, import.meta.url).
declare module '*.svg' {
  const text: string;
  export default text;
}
declare module '*.ttf' {
  const url: string;
  export default url;
}
declare module '*.png' {
  const url: string;
  export default url;
}
declare module '*.jpg' {
  const url: string;
  export default url;
}
declare module '*.css';

// <model-viewer> is an element; its types are in the way of a page without React.
declare module '@google/model-viewer';

// The part of the reshaper that is used; it has no types of its own.
declare module 'arabic-persian-reshaper' {
  export const ArabicShaper: { convertArabic(text: string): string };
}

// The part of qrcode that is used, without its drawing and its files; it has no types of its own.
declare module 'qrcode/lib/core/qrcode.js' {
  /** `data` is 1 for every dark module, `size` modules a row. Throws when the text is too long. */
  export function create(
    text: string,
    options: { errorCorrectionLevel: 'L' | 'M' },
  ): { modules: { size: number; data: Uint8Array } };
}

// The parts of gifenc that are used; it has no types of its own.
declare module 'gifenc' {
  export type Palette = number[][];
  export interface Encoder {
    writeFrame(
      index: Uint8Array,
      width: number,
      height: number,
      options: { palette: Palette; delay: number; repeat: number },
    ): void;
    finish(): void;
    bytes(): Uint8Array;
  }
  export function GIFEncoder(): Encoder;
  export function quantize(rgba: Uint8Array | Uint8ClampedArray, colours: number): Palette;
  export function applyPalette(rgba: Uint8Array | Uint8ClampedArray, palette: Palette): Uint8Array;
}
