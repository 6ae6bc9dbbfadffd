// Affine maps of space. A matrix is given in columns, with four numbers each or the first three of them; what is
// computed with has three rows of four numbers.

/** Three rows of four. */
export type Rows = Float64Array;

/** A matrix, of `stride` numbers a column, as rows. */
export function rowsOf(matrix: ArrayLike<number>, stride: 3 | 4): Rows {
  return Float64Array.from({ length: 12 }, (_, i) => matrix[stride * (i % 4) + Math.floor(i / 4)]!);
}

/** The map that undoes another; null where that is flat. */
export function inverseOf(m: Rows): Rows | null {
  const minor = (row: number, column: number) => {
    const [r, s] = [4 * ((row + 1) % 3), 4 * ((row + 2) % 3)],
      [c, d] = [(column + 1) % 3, (column + 2) % 3];
    return m[r + c]! * m[s + d]! - m[r + d]! * m[s + c]!;
  };
  const det = m[0]! * minor(0, 0) + m[1]! * minor(0, 1) + m[2]! * minor(0, 2),
    back = new Float64Array(12);
  for (let row = 0; row < 3; row += 1) {
    for (let column = 0; column < 3; column += 1) back[4 * row + column] = minor(column, row) / det;
    back[4 * row + 3] = -[0, 1, 2].reduce((sum, k) => sum + back[4 * row + k]! * m[4 * k + 3]!, 0);
  }
  return back.every(Number.isFinite) ? back : null;
}

/** All places of a list, x, y and z each, mapped. */
export function mapped(places: ArrayLike<number>, m: Rows): Float64Array {
  const to = new Float64Array(places.length);
  for (let v = 0; v < places.length; v += 3) {
    const x = places[v]!,
      y = places[v + 1]!,
      z = places[v + 2]!;
    to[v] = m[0]! * x + m[1]! * y + m[2]! * z + m[3]!;
    to[v + 1] = m[4]! * x + m[5]! * y + m[6]! * z + m[7]!;
    to[v + 2] = m[8]! * x + m[9]! * y + m[10]! * z + m[11]!;
  }
  return to;
}

/** One place, mapped by a matrix of four numbers a column. */
export function mappedPlace(matrix: readonly number[], place: readonly number[]): [number, number, number] {
  return [...mapped(place, rowsOf(matrix, 4))] as [number, number, number];
}
