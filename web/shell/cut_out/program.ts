// The search for cut-outs: a program of its own for its worker (web/cut_out.cpp).
import type { CutPicture } from './protocol.ts';

interface Program {
  memory: WebAssembly.Memory;
  malloc(bytes: number): number;
  free(address: number): void;
  spl_picture(width: number, height: number, originalWidth: number, originalHeight: number): number;
  spl_begin(hints: number, count: number): void;
  spl_step(): number;
  spl_done(): number;
  spl_found(): number;
  _initialize?(): void;
}

/** What WASI answers where something is not there. */
const kNotThere = 52;

/** What the program asks of a system: a clock, which OpenCV reads when it starts. Files and settings are not there. */
function system(program: WebAssembly.Module, memory: () => WebAssembly.Memory): WebAssembly.Imports {
  const all: WebAssembly.Imports = {};
  for (const { module, name } of WebAssembly.Module.imports(program)) (all[module] ??= {})[name] = () => kNotThere;
  const clock = (_which: number, _precision: bigint, at: number): number => {
    new DataView(memory().buffer).setBigUint64(at, BigInt(Math.round(1e6 * performance.now())), true);
    return 0;
  };
  Object.assign(all['wasi_snapshot_preview1'] ?? {}, { clock_time_get: clock });
  return all;
}

export class CutOut {
  private constructor(private readonly program: Program) {}

  /** Starts the program in these bytes. */
  static async load(bytes: BufferSource): Promise<CutOut> {
    const module = await WebAssembly.compile(bytes),
      instance = await WebAssembly.instantiate(
        module,
        system(module, () => program.memory),
      ),
      program = instance.exports as unknown as Program;
    program._initialize?.();
    return new CutOut(program);
  }

  /** Bytes that its memory has grown to. */
  get memory(): number {
    return this.program.memory.buffer.byteLength;
  }

  /** The picture that is searched from now on. */
  show({ width, height, originalWidth, originalHeight, rgba }: CutPicture): void {
    const place = this.program.spl_picture(width, height, originalWidth, originalHeight);
    if (place === 0) throw new RangeError('no memory for a picture');
    new Uint8Array(this.program.memory.buffer, place, rgba.length).set(rgba);
  }

  /** A round a step, each of which says how far it is; in the end what was found, as the engine reads it. */
  *search(hints: Float64Array): Generator<number, Float64Array> {
    const { program } = this,
      place = program.malloc(Math.max(1, hints.byteLength));
    if (place === 0) throw new RangeError('no memory for hints');
    new Float64Array(program.memory.buffer, place, hints.length).set(hints);
    program.spl_begin(place, hints.length);
    program.free(place);
    while (program.spl_step() !== 0) yield program.spl_done();
    const found = program.spl_found(),
      [count] = new Float64Array(program.memory.buffer, found, 1);
    return new Float64Array(program.memory.buffer, found + Float64Array.BYTES_PER_ELEMENT, count).slice();
  }
}
