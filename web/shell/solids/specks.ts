// What is as thin as rounding: left where surfaces all but coincide, and of no use to anyone.
import { facesWhere } from './flaps.ts';
import type { Faces } from './flaps.ts';
import { sizeOf } from './sizes.ts';
import { rootsOf } from './topology.ts';
import { boxOf } from './room.ts';

/** Share of a thing's size down to which float coordinates are sure, seven digits. */
const kSure = 1e-6;

/** Whether something of this volume and area is thinner in the mean than coordinates of a thing of this diagonal are sure. */
export function isSpeck({ volume, area }: { volume: number; area: number }, diagonal: number): boolean {
  return 2 * Math.abs(volume) <= kSure * diagonal * area;
}

function diagonalOf(positions: Float32Array): number {
  const { low, high } = boxOf(positions);
  return Math.hypot(...high.map((x, k) => x - low[k]!));
}

/** A mesh of several pieces without those, and the voids, that are specks of it. */
export function withoutSpecks(mesh: Faces): Faces {
  const { vertProperties, triVerts } = mesh,
    root = rootsOf(vertProperties.length / 3, triVerts),
    pieces = new Map<number, number[]>();
  for (let t = 0; t < triVerts.length; t += 3) {
    const of = root[triVerts[t]!]!,
      piece = pieces.get(of);
    if (piece) piece.push(...triVerts.subarray(t, t + 3));
    else pieces.set(of, [...triVerts.subarray(t, t + 3)]);
  }
  const diagonal = diagonalOf(vertProperties),
    specks = new Set<number>();
  for (const [of, corners] of pieces)
    if (isSpeck(sizeOf({ vertProperties, triVerts: Uint32Array.from(corners) }), diagonal)) specks.add(of);
  return specks.size === 0 || specks.size === pieces.size
    ? mesh
    : facesWhere(mesh, (t) => !specks.has(root[triVerts[3 * t]!]!));
}
