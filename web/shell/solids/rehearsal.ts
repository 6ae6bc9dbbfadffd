// Browsers run what is new slowly: WebAssembly first in a slow tier, and scripts too. So a worker that is likely to be
// asked for a solid soon makes a few of its own while nobody waits, and lets go of them.
import type { ManifoldToplevel } from 'manifold-3d';
import { kWorthSharing } from './helper.ts';
import { SolidKernel } from './kernel.ts';
import type { MeshData, PartOperand, SolveRequest } from './protocol.ts';

/** Rounds after which what matters has been called often enough. */
const kRounds = 4;
/** Parts that reach into one another in a row, so that an edit of the first has to do with some of them alone. */
const kParts = 6;

/** A bent rod of `rings` rings of as many points each, from x = 0 to 1, closed by a hub at each end. */
function rod(rings: number, bend: number): MeshData {
  const count = rings * rings,
    positions = new Float32Array(3 * (count + 2)),
    uv = new Float32Array(2 * (count + 2)),
    triangles: number[] = [];
  const put = (v: number, t: number, radius: number, angle: number) => {
    positions.set([t, bend * t * t + radius * Math.cos(angle), -radius * Math.sin(angle)], 3 * v);
    uv.set([t, angle / (2 * Math.PI)], 2 * v);
  };
  for (let v = 0; v < count; v += 1) {
    const ring = Math.floor(v / rings),
      t = ring / (rings - 1);
    put(v, t, 0.1 + 0.02 * Math.sin(9 * t), (2 * Math.PI * (v % rings)) / rings);
  }
  put(count, 0, 0, 0);
  put(count + 1, 1, 0, 0);
  for (let v = 0; v < count; v += 1) {
    const first = v - (v % rings),
      beside = first + ((v + 1) % rings);
    if (first === 0) triangles.push(count, v, beside);
    if (first + rings < count) triangles.push(v, v + rings, beside + rings, v, beside + rings, beside);
    else triangles.push(v, count + 1, beside);
  }
  return { positions, uv, triangles: Uint32Array.from(triangles) };
}

/** A row of rods that is large enough for two workers. */
function row(): Pick<SolveRequest, 'meshes'> & { operands: PartOperand[] } {
  const rings = Math.ceil(Math.sqrt((1.1 * kWorthSharing) / kParts / 2)),
    meshes: SolveRequest['meshes'] = {};
  const operands = Array.from({ length: kParts }, (_, i) => {
    const angle = i % 2 ? 0.3 : -0.25,
      [c, s] = [Math.cos(angle), Math.sin(angle)];
    meshes[i] = rod(rings, 0.1 * (i % 3));
    return {
      mesh: String(i),
      part: i + 1,
      matrix: [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0.6 * i, 0.01 * i, 0.02 * (i % 2), 1],
    };
  });
  return { operands, meshes };
}

/** Makes unions, and an edit of one, as a solver does, a piece at a time; nothing of it stays but memory of the library. */
export function* rehearse(library: ManifoldToplevel): Generator<void, void> {
  for (let round = 0; round < kRounds; round += 1) {
    const second = new SolidKernel(library);
    const kernel = new SolidKernel(library, {
      isFree: true,
      unite: (operands, meshes) => Promise.resolve(second.unite({ share: 0, operands, meshes })),
    });
    const { operands, meshes } = row(),
      node = { step: 1, kind: 'join' as const, blend: 0, wall: 0, opening: null, cut: 0, coarse: false };
    const solve = function* (key: string, of: PartOperand[], given: SolveRequest['meshes']) {
      for (const _ of kernel.solve(
        { id: 1, nodes: [{ ...node, key, operands: of }], wanted: [key], meshes: given },
        () => {},
      ))
        yield;
    };
    try {
      yield* solve('union', operands, meshes);
      yield* kernel.ahead(1);
      yield* solve(
        'edit',
        operands.map((each, i) => (i === 0 ? { ...each, mesh: 'other' } : each)),
        { other: rod(30, 0.05) },
      );
    } finally {
      kernel.forgetAll();
    }
  }
}
