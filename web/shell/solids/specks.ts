// What is as thin as rounding: left where surfaces all but coincide, and of no use to anyone.
import { facesWhere } from './flaps.ts';
import type { Faces } from './flaps.ts';
import { sizeOf } from './sizes.ts';
import { rootsOf } from './topology.ts';
import { kTouch } from './crossings.ts';

/** Whether something of this volume and area is thinner in the mean than coordinates of a thing of this diagonal are sure. */
export function isSpeck({ volume, area }: { volume: number; area: number }, diagonal: number): boolean {
  return 2 * Math.abs(volume) <= kTouch * diagonal * area;
}

function diagonalOf(positions: Float32Array): number {
  const low = [Infinity, Infinity, Infinity],
    high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    for (let k = 0; k < 3; k += 1) {
      low[k] = Math.min(low[k]!, positions[i + k]!);
      high[k] = Math.max(high[k]!, positions[i + k]!);
    }
  }
  return Math.hypot(high[0]! - low[0]!, high[1]! - low[1]!, high[2]! - low[2]!);
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
