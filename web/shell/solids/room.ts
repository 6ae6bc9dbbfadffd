// Boxes round parts, which lie askew in the world as the parts do.
import type { Mat4, Vec3 } from 'manifold-3d';
import { inverseOf, mapped, rowsOf } from './affine.ts';
import type { Rows } from './affine.ts';

/** How far a room goes beyond its part, as a share of the part's length. */
const kAround = 0.1;
/** Ways in which a box may stand in the part's picture. */
const kTurns = 18;

/** Places of a part or a solid in its own space, and where that is in the world: 4 × 4 in columns. */
export interface Shape {
  positions: Float32Array;
  matrix: readonly number[];
}

/** A box along the axes of a space of its own. */
export interface Room {
  /** From the world into its space, and back as 4 × 4 in columns. */
  into: Rows;
  out: Mat4;
  low: Vec3;
  high: Vec3;
}

export function boxOf(places: ArrayLike<number>): { low: Vec3; high: Vec3 } {
  const low: Vec3 = [Infinity, Infinity, Infinity],
    high: Vec3 = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < places.length; i += 3) {
    for (let k = 0; k < 3; k += 1) {
      low[k] = Math.min(low[k]!, places[i + k]!);
      high[k] = Math.max(high[k]!, places[i + k]!);
    }
  }
  return { low, high };
}

/** A matrix after a turn about the z axis of the space it is for. */
function turnedBefore(m: readonly number[], cos: number, sin: number): Mat4 {
  const x = [0, 1, 2, 3].map((k) => cos * m[k]! + sin * m[4 + k]!),
    y = [0, 1, 2, 3].map((k) => cos * m[4 + k]! - sin * m[k]!);
  return [...x, ...y, ...m.slice(8)] as Mat4;
}

/** The smallest of the boxes that stand upright on the part's picture, with some space round the part. */
export function roomOf({ positions, matrix }: Shape): Room | null {
  let best: Room | null = null,
    least = Infinity;
  for (let turn = 0; turn < kTurns; turn += 1) {
    const angle = (turn * Math.PI) / (2 * kTurns),
      [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const { low, high } = boxOf(mapped(positions, Float64Array.of(cos, sin, 0, 0, -sin, cos, 0, 0, 0, 0, 1, 0))),
      size = high.map((x, k) => x - low[k]!),
      volume = size[0]! * size[1]! * size[2]!;
    if (!(volume < least)) continue;
    const out = turnedBefore(matrix, cos, sin),
      into = inverseOf(rowsOf(out, 4)),
      more = kAround * Math.max(...size);
    if (!into) return null;
    least = volume;
    best = { into, out, low: low.map((x) => x - more) as Vec3, high: high.map((x) => x + more) as Vec3 };
  }
  return best;
}

/** Whether all of a shape is in a room. */
export function isWithin({ into, low, high }: Room, { positions, matrix }: Shape): boolean {
  const box = boxOf(mapped(mapped(positions, rowsOf(matrix, 4)), into));
  return low.every((x, k) => x < box.low[k]! && box.high[k]! < high[k]!);
}
