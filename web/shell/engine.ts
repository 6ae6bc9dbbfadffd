// The engine as the shell sees it: loads one of the two WebAssembly variants and wraps its exported
// functions. Strings cross as UTF-8 in malloc'ed memory; everything that comes out is copied at once.
import type { Command, ExportFormat, State } from './api.ts';
import { boundScript } from './bound_script.ts';
import { compile } from './compile.ts';
import { Failure } from './failure.ts';
import type { CutAnswer, Cutter } from './cut_out/cutter.ts';
import type { EngineEvent, RawEvent } from './engine_events.ts';
import { cutEventAt, cutterOf, meshesAt, solverOf } from './engine_workers.ts';
import type { Fonts, Script } from './fonts.ts';
import type { About } from './keep/journal_writer.ts';
import type { RawPhoto } from './keep/pack.ts';
import { whereItIsMissing } from './missing_program.ts';
import type { ShellView } from './shell_view.ts';
import type { Probe, WorkingCopy } from './picture.ts';
import type { SolveEvent, Solver } from './solids/solver.ts';
import { forCanvas } from './words/words.ts';
import type { Language } from './words/words.ts';

export type { EngineEvent, Offer } from './engine_events.ts';

/** Pointer kinds, devices and modifiers as numbers of the C++ side. */
export const kPointerKind = { down: 0, move: 1, up: 2, cancel: 3, leave: 4 } as const;
export const kDevice = { mouse: 0, touch: 1, pen: 2 } as const;

export interface PointerSample {
  kind: number;
  id: number;
  device: number;
  button: number;
  buttons: number;
  x: number;
  y: number;
  pressure: number;
  timeMs: number;
  modifiers: number;
}

export interface Size {
  width: number;
  height: number;
  dpr: number;
}

interface Module {
  wasmMemory: WebAssembly.Memory;
  fetchSecond(compile: (address: string) => Promise<WebAssembly.Module>): Promise<void>;
  _malloc(size: number): number;
  _free(ptr: number): void;
  _spl_start(
    font: number,
    fontLength: number,
    bold: number,
    boldLength: number,
    icons: number,
    iconLength: number,
    width: number,
    height: number,
    dpr: number,
  ): number;
  _spl_speak(id: number, rightToLeft: number, font: number, fontLength: number, bold: number, boldLength: number): void;
  _spl_resize(width: number, height: number, dpr: number): void;
  _spl_setPalette(bytes: number, length: number): void;
  _spl_pointer(
    kind: number,
    id: number,
    device: number,
    button: number,
    buttons: number,
    x: number,
    y: number,
    pressure: number,
    timeMs: number,
    modifiers: number,
  ): void;
  _spl_wheel(x: number, y: number, deltaX: number, deltaY: number, modifiers: number): void;
  _spl_key(code: number, key: number, down: number, modifiers: number): number;
  _spl_addPicture(
    rgba: number,
    width: number,
    height: number,
    originalWidth: number,
    originalHeight: number,
    name: number,
  ): number;
  _spl_probe(bytes: number, length: number): number;
  _spl_state(): number;
  _spl_commands(): number;
  _spl_run(id: number, args: number): number;
  _spl_export(format: number, outLength: number): number;
  _spl_pictureWithModel(png: number, size: number, outLength: number): number;
  _spl_lastError(): number;
  _spl_sentence(code: number): number;
  _spl_imageToClient(x: number, y: number, out: number): void;
  _spl_contextLost(): void;
  _spl_contextRestored(): void;
  _spl_answer(id: number, text: number): void;
  _spl_idle(): number;
  _spl_workControl(id: number, value: number): void;
  _spl_showControl(id: number): void;
  _spl_warmUp(): number;
  _spl_finishParts(): void;
  _spl_cancelWork(): void;
  _spl_solved(answer: number, bytes: number, length: number): void;
  _spl_cutOutAnswered(id: number, kind: number, done: number, found: number, count: number): void;
  _spl_history(): number;
  _spl_photos(): number;
  _spl_photo(hash: number, outSizes: number): number;
  _spl_layPhotoBy(rgba: number, width: number, height: number, originalWidth: number, originalHeight: number): number;
  _spl_restore(base: number, records: number): number;
  _spl_shareText(copies: number): number;
  _spl_photosOfLink(bytes: number, length: number): number;
  _spl_openProject(bytes: number, length: number, photos: number): number;
  _spl_thumbnail(width: number, height: number): number;
  _spl_turntable(width: number, height: number, turn: number): number;
}

type Factory = (argument: Record<string, unknown>) => Promise<Module>;

interface Outcome {
  ok: boolean;
  error?: string;
  sentence?: string;
  dropped?: number;
  text?: string;
  photos?: number | Record<string, string>;
}

/** True where worker threads can share memory and the address does not ask for the other build. */
export function wantsThreads(): boolean {
  const asked = new URLSearchParams(location.search).get('threads');
  return asked !== '0' && globalThis.crossOriginIsolated === true && typeof SharedArrayBuffer === 'function';
}

type Receive = (instance: WebAssembly.Instance, program: WebAssembly.Module) => void;

/** Starts what is compiled already; without it the script fetches its program itself. */
function startWith(create: Factory, program: WebAssembly.Module | null, argument: object): Promise<Module> {
  return new Promise((resolve, reject) => {
    const instantiateWasm = (imports: WebAssembly.Imports, receive: Receive) => {
      WebAssembly.instantiate(program!, imports).then((instance) => receive(instance, program!), reject);
      return {};
    };
    create({ ...argument, ...(program ? { instantiateWasm } : {}) }).then(resolve, reject);
  });
}

/** Loads the variant that fits this page; events arrive in order, never inside a call into the engine (but 'journal' at once). */
export async function loadEngine(canvas: HTMLCanvasElement, onEvent: (event: EngineEvent) => void): Promise<Engine> {
  const files = wantsThreads() ? SPINELOFT_SITE.threads : SPINELOFT_SITE.single;
  const script = new URL(files.js, document.baseURI).href;
  // An engine that is still being linked names no program yet.
  const program = files.wasm ? compile(new URL(files.wasm, document.baseURI).href) : null;
  const [{ default: create }, compiled] = await Promise.all([import(script) as Promise<{ default: Factory }>, program]);
  const queue: EngineEvent[] = [];
  let module: Module | null = null;
  let solver: Solver | null = null;
  let cutter: Cutter | null = null;
  let view: ShellView | null = null;
  const deliver = () => {
    for (let event = queue.shift(); event; event = queue.shift()) onEvent(event);
  };
  const host = {
    ...forCanvas,
    onEvent(json: string) {
      const raw = JSON.parse(json) as RawEvent;
      if (raw.type === 'journal') {
        // At once, so that whoever reads the history knows which steps it holds; nothing is called back from there.
        onEvent(raw);
        return;
      }
      if (raw.type === 'stopSolving') {
        solver?.stop();
        return;
      }
      if (raw.type === 'stopCuttingOut') {
        cutter?.stop();
        return;
      }
      if (raw.type === 'expectEdit') {
        solver?.expect(raw.part);
        return;
      }
      if (raw.type === 'changed') view = raw.view;
      if (queue.length === 0) queueMicrotask(deliver);
      queue.push(raw.type === 'file' && module ? withBytes(raw, module) : (raw as EngineEvent));
    },
    /** At once: the meshes are only there now. Answers come later, never from within. */
    onSolve(json: string, meshes: number) {
      const { meshes: keys, ...rest } = JSON.parse(json) as SolveRequestText;
      if (module) solver?.ask({ ...rest, meshes: meshesAt(module.wasmMemory.buffer, meshes, keys) });
    },
    /** Likewise. */
    onCutOut(id: number, hints: number, count: number, key: string, rgba: number, sizes: number) {
      if (module) cutter?.ask(cutEventAt(module.wasmMemory.buffer, id, key, { hints, count, rgba, sizes }));
    },
  };
  // For pictures of the page on a machine without a graphics card: full resolution, however slow.
  const sharp = new URLSearchParams(location.search).has('sharp');
  module = await startWith(create, compiled, {
    canvas,
    host,
    sharp,
    ...whereItIsMissing,
    mainScriptUrlOrBlob: boundScript(files.js), // of its threads
    locateFile: (name: string) => new URL(name, script).href,
  });
  const engine = new Engine(module, () => view);
  solver = engine.solver = solverOf(engine);
  cutter = engine.cutter = cutterOf(engine);
  return engine;
}

/** What the engine asks of the solver of solids, with the keys of its meshes. */
type SolveRequestText = Omit<SolveEvent, 'meshes'> & { meshes: string[] };

function withBytes(raw: Extract<RawEvent, { type: 'file' }>, module: Module): EngineEvent {
  const bytes = new Uint8Array(module.wasmMemory.buffer).slice(raw.ptr, raw.ptr + raw.length);
  return { type: 'file', name: raw.name, mediaType: raw.mediaType, bytes };
}

/** Typed calls into the running engine. */
export class Engine {
  private readonly encoder = new TextEncoder();
  private readonly decoder = new TextDecoder();
  private second: Promise<void> | null = null;
  /** The solver of solids, once there is one. */
  solver: Solver | null = null;
  /** What cuts out, likewise. */
  cutter: Cutter | null = null;

  constructor(
    private readonly module: Module,
    private readonly told: () => ShellView | null,
  ) {}

  /**
   * Resolves when the engine's second program is there as well (web/platform/second_program.js). Whoever calls a function
   * of it before makes the page wait, so what is likely to do so asks here first.
   */
  whole(): Promise<void> {
    this.second ??= this.module.fetchSecond(compile).catch((thrown: unknown) => {
      this.second = null; // another try may do better
      throw thrown;
    });
    return this.second;
  }

  start(fonts: Fonts, size: Size): boolean {
    const parts = [fonts.text, fonts.bold, fonts.icons].map((bytes) => ({ at: this.put(bytes), length: bytes.length }));
    const [text, bold, icons] = parts as [
      { at: number; length: number },
      { at: number; length: number },
      { at: number; length: number },
    ];
    try {
      return (
        this.module._spl_start(
          text.at,
          text.length,
          bold.at,
          bold.length,
          icons.at,
          icons.length,
          size.width,
          size.height,
          size.dpr,
        ) === 1
      );
    } finally {
      for (const part of parts) this.module._free(part.at);
    }
  }

  /** The canvas speaks this language; `script` has the letters that its fonts lack. */
  speak({ id, dir }: Language, script: Script | null): void {
    const none = new Uint8Array();
    const text = script?.text ?? none,
      bold = script?.bold ?? none;
    const parts = [this.put(text), this.put(bold)] as const;
    try {
      this.withStrings([id], ([at]) =>
        this.module._spl_speak(at!, dir === 'rtl' ? 1 : 0, parts[0], text.length, parts[1], bold.length),
      );
    } finally {
      for (const at of parts) this.module._free(at);
    }
  }

  resize(size: Size): void {
    this.module._spl_resize(size.width, size.height, size.dpr);
  }

  setPalette(palette: Uint8Array): void {
    const at = this.put(palette);
    this.module._spl_setPalette(at, palette.length);
    this.module._free(at);
  }

  pointer(p: PointerSample): void {
    this.module._spl_pointer(p.kind, p.id, p.device, p.button, p.buttons, p.x, p.y, p.pressure, p.timeMs, p.modifiers);
  }

  wheel(x: number, y: number, deltaX: number, deltaY: number, modifiers: number): void {
    this.module._spl_wheel(x, y, deltaX, deltaY, modifiers);
  }

  /** True when the engine used the key. */
  key(code: string, key: string, down: boolean, modifiers: number): boolean {
    return this.withStrings([code, key], (at) => this.module._spl_key(at[0]!, at[1]!, down ? 1 : 0, modifiers)) === 1;
  }

  addPicture(picture: WorkingCopy, name: string): void {
    const pixels = this.put(picture.rgba);
    try {
      const outcome = this.withStrings([name], (at) =>
        this.module._spl_addPicture(
          pixels,
          picture.width,
          picture.height,
          picture.originalWidth,
          picture.originalHeight,
          at[0]!,
        ),
      );
      this.check(this.text(outcome));
    } finally {
      this.module._free(pixels);
    }
  }

  /** What the engine says of a picture file before it is decoded. */
  probe(bytes: Uint8Array): Probe {
    return JSON.parse(this.withBytes(bytes, (at) => this.text(this.module._spl_probe(at, bytes.length)))) as Probe;
  }

  /** What the DOM shows, as the engine told it last: what a call changes is told before the call returns. */
  get view(): ShellView {
    const view = this.told();
    if (!view) throw new Failure('NotReady', 'The page is not ready yet. Wait for spineloft.ready.');
    return view;
  }

  state(): State {
    return JSON.parse(this.text(this.module._spl_state())) as State;
  }

  commands(): Command[] {
    return JSON.parse(this.text(this.module._spl_commands())) as Command[];
  }

  /** Runs a command; throws a Failure when the engine refuses. */
  run(id: string, args: Record<string, unknown> = {}): void {
    this.check(this.withStrings([id, JSON.stringify(args)], (at) => this.text(this.module._spl_run(at[0]!, at[1]!))));
  }

  exportModel(format: Exclude<ExportFormat, 'png'>): Uint8Array {
    return this.file((outLength) => this.withStrings([format], (ptr) => this.module._spl_export(ptr[0]!, outLength)));
  }

  /** A PNG picture of the model with the model inside. */
  pictureWithModel(png: Uint8Array): Uint8Array {
    return this.withBytes(png, (at) =>
      this.file((outLength) => this.module._spl_pictureWithModel(at, png.length, outLength)),
    );
  }

  /** The bytes whose place `write` returns; it leaves their number at `outLength`. */
  private file(write: (outLength: number) => number): Uint8Array {
    const outLength = this.module._malloc(4);
    try {
      const at = write(outLength);
      if (at === 0) {
        this.check(this.text(this.module._spl_lastError()));
        throw new Failure('NothingToExport', this.sentence('NothingToExport'));
      }
      const length = new DataView(this.module.wasmMemory.buffer).getUint32(outLength, true);
      return this.heap().slice(at, at + length);
    } finally {
      this.module._free(outLength);
    }
  }

  /** The engine's sentence for one of its errors. */
  sentence(code: string): string {
    return this.withStrings([code], (at) => this.text(this.module._spl_sentence(at[0]!)));
  }

  /** Where a picture pixel is on the canvas, in CSS pixels from its top left corner. */
  imageToCanvas(x: number, y: number): { x: number; y: number } {
    const out = this.module._malloc(16);
    try {
      this.module._spl_imageToClient(x, y, out);
      const view = new DataView(this.module.wasmMemory.buffer);
      return { x: view.getFloat64(out, true), y: view.getFloat64(out + 8, true) };
    } finally {
      this.module._free(out);
    }
  }

  contextLost(): void {
    this.module._spl_contextLost();
  }

  contextRestored(): void {
    this.module._spl_contextRestored();
  }

  answer(id: string, text: string): void {
    this.withStrings([id, text], (at) => this.module._spl_answer(at[0]!, at[1]!));
  }

  /** Works a control of the panels without a pointer: see 'controls'. */
  workControl(id: number, value = Number.NaN): void {
    this.module._spl_workControl(id, value);
  }

  /** Brings it into sight. */
  showControl(id: number): void {
    this.module._spl_showControl(id);
  }

  isIdle(): boolean {
    return this.module._spl_idle() === 1;
  }

  /** One round of the stages of a stroke on a tiny picture; false when there was no memory for it. */
  warmUp(): boolean {
    return this.module._spl_warmUp() === 1;
  }

  /** A file is wanted: the solver of solids mends the parts that go through themselves; idle when it has. */
  finishParts(): void {
    this.module._spl_finishParts();
  }

  cancelWork(): void {
    this.module._spl_cancelWork();
  }

  /** What the solver of solids says, with the arrays of a mesh. */
  solved(answer: string, bytes: Uint8Array | null): void {
    const at = bytes ? this.put(bytes) : 0;
    try {
      this.withStrings([answer], (text) => this.module._spl_solved(text[0]!, at, bytes?.length ?? 0));
    } finally {
      if (at !== 0) this.module._free(at);
    }
  }

  /** What the worker that cuts out says. */
  cutOutAnswered({ id, kind, done, found }: CutAnswer): void {
    const bytes = found ? new Uint8Array(found.buffer, found.byteOffset, found.byteLength) : null,
      at = bytes ? this.put(bytes) : 0;
    try {
      this.module._spl_cutOutAnswered(id, kind, done, at, found?.length ?? 0);
    } finally {
      if (at !== 0) this.module._free(at);
    }
  }

  /** Bytes that the memories of the engine, of the solver and of what cuts out have grown to. */
  memory(): { engine: number; solver: number; cutter: number } {
    return {
      engine: this.module.wasmMemory.buffer.byteLength,
      solver: this.solver?.memory ?? 0,
      cutter: this.cutter?.memory ?? 0,
    };
  }

  /** The whole history as text: a base of the journal. */
  history(): string {
    return this.text(this.module._spl_history());
  }

  /** Content hashes of the history's photos. */
  photos(): string[] {
    return JSON.parse(this.text(this.module._spl_photos())) as string[];
  }

  photo(hash: string): RawPhoto | null {
    const sizes = this.module._malloc(16);
    try {
      const at = this.withStrings([hash], (ptr) => this.module._spl_photo(ptr[0]!, sizes));
      if (at === 0) return null;
      const view = new DataView(this.module.wasmMemory.buffer, sizes, 16);
      const [width, height, originalWidth, originalHeight] = [0, 4, 8, 12].map((offset) =>
        view.getInt32(offset, true),
      ) as [number, number, number, number];
      return {
        hash,
        width,
        height,
        originalWidth,
        originalHeight,
        rgba: this.heap().slice(at, at + 4 * width * height),
      };
    } finally {
      this.module._free(sizes);
    }
  }

  /** Name and size of the document. */
  about(): About {
    const { documentName, pictures, parts } = this.view;
    return { name: documentName, pictures, parts };
  }

  /** Lays a photo by for the next `restore`; its content hash. */
  layPhotoBy(photo: RawPhoto): string {
    const { width, height, originalWidth, originalHeight } = photo;
    return this.withBytes(photo.rgba, (pixels) =>
      this.text(this.module._spl_layPhotoBy(pixels, width, height, originalWidth, originalHeight)),
    );
  }

  /** Replaces the model by one that was kept; how many of its records were damaged. */
  restore(base: string, records: string[]): number {
    const answer = this.withStrings([base, JSON.stringify(records)], (at) =>
      this.text(this.module._spl_restore(at[0]!, at[1]!)),
    );
    return this.check(answer).dropped ?? 0;
  }

  /** The model as the text of a link with these copies of photos (base64url by content hash), and how many photos are not in it. */
  shareText(copies: Record<string, string>): { text: string; photos: number } {
    const { text, photos } = this.check(
      this.withStrings([JSON.stringify(copies)], ([at]) => this.text(this.module._spl_shareText(at!))),
    );
    return { text: text ?? '', photos: (photos as number | undefined) ?? 0 };
  }

  /** Copies of photos in a link, base64url by picture; none in a project file. */
  photosOfLink(bytes: Uint8Array): Record<string, string> {
    const answer = this.withBytes(bytes, (at) => this.text(this.module._spl_photosOfLink(at, bytes.length)));
    return (this.check(answer).photos as Record<string, string> | undefined) ?? {};
  }

  /** Replaces the model by the one in a project file or in a link, whose pictures show these photos. */
  openProject(bytes: Uint8Array, photos: Record<string, RawPhoto> = {}): void {
    const hashes = Object.entries(photos).map(([picture, photo]) => [picture, this.layPhotoBy(photo)]);
    const answer = this.withStrings([JSON.stringify(Object.fromEntries(hashes))], ([named]) =>
      this.withBytes(bytes, (at) => this.text(this.module._spl_openProject(at, bytes.length, named!))),
    );
    this.check(answer);
  }

  /** RGBA pixels of a small picture of the model; null while there is nothing to show. */
  thumbnail(width: number, height: number): Uint8ClampedArray | null {
    const at = this.module._spl_thumbnail(width, height);
    return at === 0 ? null : new Uint8ClampedArray(this.heap().slice(at, at + 4 * width * height));
  }

  /** The same from home, turned by `turn` (0…1 of the way round). */
  turntable(width: number, height: number, turn: number): Uint8ClampedArray | null {
    const at = this.module._spl_turntable(width, height, turn);
    return at === 0 ? null : new Uint8ClampedArray(this.heap().slice(at, at + 4 * width * height));
  }

  private check(json: string): Outcome {
    const outcome = JSON.parse(json) as Outcome;
    if (outcome.ok) return outcome;
    const code = outcome.error ?? 'Unknown';
    throw new Failure(code, outcome.sentence ?? this.sentence(code));
  }

  private heap(): Uint8Array {
    return new Uint8Array(this.module.wasmMemory.buffer);
  }

  private put(bytes: ArrayLike<number> & { length: number }): number {
    const at = this.module._malloc(Math.max(1, bytes.length));
    if (at === 0) throw new Failure('OutOfMemory', this.sentence('OutOfMemory'));
    this.heap().set(bytes, at);
    return at;
  }

  private withBytes<T>(bytes: ArrayLike<number> & { length: number }, call: (at: number) => T): T {
    const at = this.put(bytes);
    try {
      return call(at);
    } finally {
      this.module._free(at);
    }
  }

  private withStrings<T>(strings: string[], call: (at: number[]) => T): T {
    const at = strings.map((text) => this.put(this.encoder.encode(`${text}\0`)));
    try {
      return call(at);
    } finally {
      for (const ptr of at) this.module._free(ptr);
    }
  }

  private text(at: number): string {
    const heap = this.heap();
    return this.decoder.decode(heap.slice(at, heap.indexOf(0, at)));
  }
}
