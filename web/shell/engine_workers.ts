// The workers that the engine asks: what they are given is read from its memory, and what they say goes to it.
import { boundScript } from './bound_script.ts';
import { Cutter } from './cut_out/cutter.ts';
import type { CutAnswer, CutEvent, CutWorker } from './cut_out/cutter.ts';
import { waitForEnd } from './lifeline.ts';
import { Solver } from './solids/solver.ts';
import type { SolidWorker, SolveEvent } from './solids/solver.ts';

/** As much of the engine as they need. */
interface Asking {
  solved(json: string, bytes: Uint8Array | null): void;
  cutOutAnswered(answer: CutAnswer): void;
}

/** A worker of the site, whose end is heard of. */
function startWorker(which: 'solids' | 'cut_out'): Worker {
  const name = `spineloft-${which}-${Date.now()}-${Math.random()}`;
  const worker = new Worker(boundScript(SPINELOFT_SITE.workers[which]!), { type: 'module', name });
  worker.addEventListener('message', ({ data }) => {
    if (data.type === 'alive') waitForEnd(name, () => worker.onerror?.(new ErrorEvent('error')));
  });
  return worker;
}

export function solverOf(engine: Asking): Solver {
  return new Solver({
    start: () => startWorker('solids') as unknown as SolidWorker,
    answer: (json, bytes) => engine.solved(json, bytes),
  });
}

export function cutterOf(engine: Asking): Cutter {
  return new Cutter({
    start: () => startWorker('cut_out') as unknown as CutWorker,
    answer: (answer) => engine.cutOutAnswered(answer),
  });
}

/** The engine's arrays of these meshes: platform::SolverMesh of web/platform/host.h, five numbers each. */
export function meshesAt(memory: ArrayBufferLike, at: number, keys: string[]): SolveEvent['meshes'] {
  const table = new Uint32Array(memory, at, 5 * keys.length);
  return keys.map((key, i) => {
    const [vertices, triangles, positions, uv, corners] = [...table.subarray(5 * i, 5 * i + 5)] as [
      number,
      number,
      number,
      number,
      number,
    ];
    return {
      key,
      mesh: {
        positions: new Float32Array(memory, positions, 3 * vertices),
        uv: new Float32Array(memory, uv, uv === 0 ? 0 : 2 * vertices),
        triangles: new Uint32Array(memory, corners, 3 * triangles),
      },
    };
  });
}

/** The engine's arrays of a platform::CutRequest: its hints, its picture, and the four sizes of that. */
export interface CutPlaces {
  hints: number;
  count: number;
  rgba: number;
  sizes: number;
}

export function cutEventAt(memory: ArrayBufferLike, id: number, key: string, places: CutPlaces): CutEvent {
  const [width, height, originalWidth, originalHeight] = [...new Int32Array(memory, places.sizes, 4)] as [
    number,
    number,
    number,
    number,
  ];
  return {
    id,
    key,
    hints: new Float64Array(memory, places.hints, places.count),
    picture: {
      width,
      height,
      originalWidth,
      originalHeight,
      rgba: new Uint8Array(memory, places.rgba, 4 * width * height),
    },
  };
}
