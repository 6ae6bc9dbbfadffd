// Boxes round parts, askew as these lie.
import type { Mat4, Vec3 } from 'manifold-3d';

/** How far round a part its room goes, as a share of its length. */
const kAround = 0.1;

/** Places of a part or a solid in its own space, and where that is in the world: 4 × 4 in columns. */
export interface Shape {
  positions: Float32Array;
  matrix: readonly number[];
}

/** A box that lies askew in the world. */
export interface Room {
  /** From the world to where its sides run along the axes; three rows of four, and back as 4 × 4 in columns. */
  into: Float64Array;
  out: Mat4;
  low: Vec3;
  high: Vec3;
}

function times(a: readonly number[], b: readonly number[]): number[] {
  return Array.from({ length: 16 }, (_, i) =>
    [0, 1, 2, 3].reduce((sum, k) => sum + a[(i & 3) + 4 * k]! * b[k + (i & 12)]!, 0),
  );
}

/** A place as a matrix, 4 × 4 in columns, takes it. */
export function inWorld(m: readonly number[], [x, y, z]: readonly [number, number, number]): [number, number, number] {
  return [0, 1, 2].map((k) => m[k]! * x + m[4 + k]! * y + m[8 + k]! * z + m[12 + k]!) as [number, number, number];
}

/** Three rows of four that undo a matrix; null where it is flat. */
function undone(m: readonly number[]): Float64Array | null {
  const [a, b, c, , d, e, f, , g, h, i, , x, y, z] = m as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  const det = a * (e * i - f * h) - d * (b * i - c * h) + g * (b * f - c * e);
  const back = new Float64Array(12);
  const rows = [
    e * i - f * h,
    g * f - d * i,
    d * h - g * e,
    c * h - b * i,
    a * i - g * c,
    g * b - a * h,
    b * f - c * e,
    d * c - a * f,
    a * e - d * b,
  ].map((n) => n / det);
  if (!rows.every(Number.isFinite)) return null;
  for (let row = 0; row < 3; row += 1) {
    const [p, q, r] = rows.slice(3 * row, 3 * row + 3) as [number, number, number];
    back.set([p, q, r, -(p * x + q * y + r * z)], 4 * row);
  }
  return back;
}

/** Places as three rows of four take them. */
export function mapped(positions: Float32Array, m: Float64Array): Float64Array {
  const to = new Float64Array(positions.length);
  for (let v = 0; v < positions.length; v += 3) {
    const x = positions[v]!,
      y = positions[v + 1]!,
      z = positions[v + 2]!;
    to[v] = m[0]! * x + m[1]! * y + m[2]! * z + m[3]!;
    to[v + 1] = m[4]! * x + m[5]! * y + m[6]! * z + m[7]!;
    to[v + 2] = m[8]! * x + m[9]! * y + m[10]! * z + m[11]!;
  }
  return to;
}

function boxOf(places: ArrayLike<number>): { low: Vec3; high: Vec3 } {
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

/** The room that a part has for its edits: of the boxes that stand upright in its picture the smallest, and some more. */
export function roomOf({ positions, matrix }: Shape): Room | null {
  let best: Room | null = null,
    least = Infinity;
  for (let turn = 0; turn < 18; turn += 1) {
    const c = Math.cos((turn * Math.PI) / 36),
      s = Math.sin((turn * Math.PI) / 36);
    const { low, high } = boxOf(mapped(positions, Float64Array.of(c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0)));
    const size = high.map((x, k) => x - low[k]!),
      volume = size[0]! * size[1]! * size[2]!;
    if (!(volume < least)) continue;
    const out = times(matrix, [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]) as Mat4,
      into = undone(out);
    if (!into) return null;
    const more = kAround * Math.max(...size);
    least = volume;
    best = { into, out, low: low.map((x) => x - more) as Vec3, high: high.map((x) => x + more) as Vec3 };
  }
  return best;
}

/** Whether all of a shape is in a room. */
export function isWithin({ into, low, high }: Room, { positions, matrix }: Shape): boolean {
  const rows = Float64Array.from([0, 1, 2].flatMap((row) => [0, 1, 2, 3].map((column) => matrix[4 * column + row]!)));
  const world = mapped(positions, rows),
    box = boxOf(mapped(Float32Array.from(world), into));
  return low.every((x, k) => x < box.low[k]! && box.high[k]! < high[k]!);
}
