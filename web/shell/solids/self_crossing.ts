// Whether a mesh goes through itself: the engine's own test (engine/mesh/self_crossing.h), which is a small program of
// its own for this worker (web/self_crossing.cpp).
import type { Point, Surface } from './grid.ts';

/** A place where a closed mesh goes through itself; null where it does not. Every corner is the number of a vertex. */
export type SelfCrossing = (mesh: Surface) => Point | null;

interface Program {
  memory: WebAssembly.Memory;
  malloc(bytes: number): number;
  free(address: number): void;
  spl_selfCrossing(positions: number, vertices: number, corners: number, triangles: number, at: number): number;
  _initialize?(): void;
}

/** What the program asks of its surroundings. */
const kImports = { env: { emscripten_notify_memory_growth: () => {} } };
const kPlaceBytes = 3 * Float64Array.BYTES_PER_ELEMENT;

/** Starts the program in these bytes. */
export async function loadSelfCrossing(bytes: BufferSource): Promise<SelfCrossing> {
  const { instance } = await WebAssembly.instantiate(bytes, kImports),
    program = instance.exports as unknown as Program;
  program._initialize?.();
  return ({ positions, triangles }) => {
    const place = program.malloc(kPlaceBytes + positions.byteLength + triangles.byteLength);
    if (place === 0) throw new RangeError('no memory for a mesh');
    try {
      const vertices = place + kPlaceBytes,
        corners = vertices + positions.byteLength;
      new Float32Array(program.memory.buffer, vertices, positions.length).set(positions);
      new Uint32Array(program.memory.buffer, corners, triangles.length).set(triangles);
      const crosses = program.spl_selfCrossing(vertices, positions.length / 3, corners, triangles.length / 3, place);
      return crosses ? ([...new Float64Array(program.memory.buffer, place, 3)] as Point) : null;
    } finally {
      program.free(place);
    }
  };
}
