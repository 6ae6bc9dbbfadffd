// Whether a closed mesh crosses itself: a tree of boxes over its triangles, and for every pair of triangles
// without a common corner whose boxes meet, whether an edge of one pierces the other.

const kLeaf = 4;

/** A balanced tree over triangles in an order in which neighbours are near: node k has the children 2k + 1 and 2k + 2. */
interface Tree {
  /** Six numbers a node: low x, y, z, high x, y, z. */
  boxes: Float32Array;
  /** Nodes from this one on are leaves; leaf i holds the places [starts[i], starts[i + 1]) of `order`. */
  firstLeaf: number;
  starts: Uint32Array;
  order: Uint32Array;
}

export interface Crossing {
  /** Two triangles that cross, by number. */
  a: number;
  b: number;
}

function triangleBoxes(positions: Float32Array, triangles: Uint32Array): Float32Array {
  const boxes = new Float32Array(triangles.length * 2);
  for (let t = 0, at = 0; t < triangles.length; t += 3, at += 6) {
    const i = 3 * triangles[t]!, j = 3 * triangles[t + 1]!, l = 3 * triangles[t + 2]!;
    for (let k = 0; k < 3; k += 1) {
      const a = positions[i + k]!, b = positions[j + k]!, c = positions[l + k]!;
      boxes[at + k] = a < b ? (a < c ? a : c) : b < c ? b : c;
      boxes[at + 3 + k] = a > b ? (a > c ? a : c) : b > c ? b : c;
    }
  }
  return boxes;
}

/** Whether triangles that follow one another are near, as those of a loft are, which run round its rings. */
function isNearOrder(of: Float32Array): boolean {
  let way = 0, size = 0;
  for (let t = 6; t < of.length; t += 6) {
    for (let k = 0; k < 3; k += 1) {
      way += Math.abs(of[t + k]! - of[t - 6 + k]!);
      size += of[t + 3 + k]! - of[t + k]!;
    }
  }
  return way < 2 * size;
}

/** Ten bits with two zeros between each and the next. */
function spaced(value: number): number {
  let v = value;
  v = (v | (v << 16)) & 0x030000ff;
  v = (v | (v << 8)) & 0x0300f00f;
  v = (v | (v << 4)) & 0x030c30c3;
  return (v | (v << 2)) & 0x09249249;
}

/** The boxes' numbers along a curve that fills space (Morton's), so that what follows one another is near. */
function nearOrder(of: Float32Array, whole: Float64Array): Uint32Array {
  const n = of.length / 6;
  const codes = new Uint32Array(n);
  const scale = [0, 1, 2].map((k) => 511.9 / Math.max(whole[3 + k]! - whole[k]!, 1e-30));
  for (let t = 0; t < n; t += 1) {
    let code = 0;
    for (let k = 0; k < 3; k += 1) code |= spaced((of[6 * t + k]! + of[6 * t + 3 + k]! - 2 * whole[k]!) * scale[k]!) << k;
    codes[t] = code;
  }
  let order = Uint32Array.from({ length: n }, (_, i) => i), other = new Uint32Array(n);
  for (let shift = 0; shift < 30; shift += 10) {
    const starts = new Uint32Array(1025);
    for (let i = 0; i < n; i += 1) starts[((codes[i]! >>> shift) & 1023) + 1]! += 1;
    for (let i = 0; i < 1024; i += 1) starts[i + 1]! += starts[i]!;
    for (let i = 0; i < n; i += 1) other[starts[(codes[order[i]!]! >>> shift) & 1023]!++] = order[i]!;
    [order, other] = [other, order];
  }
  return order;
}

function wholeBox(of: Float32Array): Float64Array {
  const whole = Float64Array.of(Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity);
  for (let t = 0; t < of.length; t += 6) {
    for (let k = 0; k < 3; k += 1) {
      whole[k] = Math.min(whole[k]!, of[t + k]!);
      whole[3 + k] = Math.max(whole[3 + k]!, of[t + 3 + k]!);
    }
  }
  return whole;
}

function buildTree(of: Float32Array, whole: Float64Array): Tree {
  const n = of.length / 6;
  let leaves = 1;
  while (leaves * kLeaf < n) leaves *= 2;
  const tree: Tree = { boxes: new Float32Array(6 * (2 * leaves - 1)), firstLeaf: leaves - 1, starts: new Uint32Array(leaves + 1), order: isNearOrder(of) ? Uint32Array.from({ length: n }, (_, i) => i) : nearOrder(of, whole) };
  const { boxes } = tree;
  for (let node = 0; node < 2 * leaves - 1; node += 1) {
    boxes.fill(Infinity, 6 * node, 6 * node + 3);
    boxes.fill(-Infinity, 6 * node + 3, 6 * node + 6);
  }
  const widen = (node: number, from: Float32Array, at: number) => {
    for (let k = 0; k < 3; k += 1) {
      if (from[at + k]! < boxes[6 * node + k]!) boxes[6 * node + k] = from[at + k]!;
      if (from[at + 3 + k]! > boxes[6 * node + 3 + k]!) boxes[6 * node + 3 + k] = from[at + 3 + k]!;
    }
  };
  for (let leaf = 0; leaf < leaves; leaf += 1) {
    tree.starts[leaf + 1] = Math.floor(((leaf + 1) * n) / leaves);
    for (let i = tree.starts[leaf]!; i < tree.starts[leaf + 1]!; i += 1) widen(tree.firstLeaf + leaf, of, 6 * tree.order[i]!);
  }
  for (let node = 2 * leaves - 2; node > 0; node -= 1) widen((node - 1) >> 1, boxes, 6 * node);
  return tree;
}

function meet(boxes: Float32Array, a: number, of: Float32Array, b: number): boolean {
  const i = 6 * a, j = 6 * b;
  return boxes[i]! <= of[j + 3]! && of[j]! <= boxes[i + 3]! && boxes[i + 1]! <= of[j + 4]! && of[j + 1]! <= boxes[i + 4]! && boxes[i + 2]! <= of[j + 5]! && of[j + 2]! <= boxes[i + 5]!;
}

/** Six times the volume of the tetrahedron; the sign says on which side of abc d lies. */
function side(p: Float32Array, a: number, b: number, c: number, d: number): number {
  const ax = p[a]! - p[d]!, ay = p[a + 1]! - p[d + 1]!, az = p[a + 2]! - p[d + 2]!;
  const bx = p[b]! - p[d]!, by = p[b + 1]! - p[d + 1]!, bz = p[b + 2]! - p[d + 2]!;
  const cx = p[c]! - p[d]!, cy = p[c + 1]! - p[d + 1]!, cz = p[c + 2]! - p[d + 2]!;
  return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
}

/** Whether the segment from d to e goes through the inside of abc, by more than `slack`. */
function pierces(p: Float32Array, abc: readonly [number, number, number], d: number, e: number, slack: number): boolean {
  const [a, b, c] = abc;
  const at = side(p, a, b, c, d), to = side(p, a, b, c, e);
  if (!((at > slack && to < -slack) || (at < -slack && to > slack))) return false;
  const x = side(p, d, e, a, b), y = side(p, d, e, b, c), z = side(p, d, e, c, a);
  return (x > slack && y > slack && z > slack) || (x < -slack && y < -slack && z < -slack);
}

/** Pairs of triangles that cross, at most `most`; vertices of one place are one vertex. */
export function findCrossings(positions: Float32Array, triangles: Uint32Array, most = Infinity): Crossing[] {
  const found: Crossing[] = [];
  if (triangles.length === 0) return found;
  const of = triangleBoxes(positions, triangles), whole = wholeBox(of);
  const { boxes, order, starts, firstLeaf } = buildTree(of, whole);
  // Float coordinates are sure to seven digits: what is closer than that only touches.
  const slack = Math.hypot(whole[3]! - whole[0]!, whole[4]! - whole[1]!, whole[5]! - whole[2]!) ** 3 * 1e-12;
  /** The place, 0 … 2, of the corner of s that t has as well; −1 for none, 3 for two or three. */
  const common = (s: number, t: number): number => {
    const a = triangles[3 * t]!, b = triangles[3 * t + 1]!, c = triangles[3 * t + 2]!;
    let found = -1;
    for (let k = 0; k < 3; k += 1) {
      const v = triangles[3 * s + k]!;
      if (v === a || v === b || v === c) found = found < 0 ? k : 3;
    }
    return found;
  };
  const cornersOf = (t: number) => [3 * triangles[3 * t]!, 3 * triangles[3 * t + 1]!, 3 * triangles[3 * t + 2]!] as const;
  const cross = (s: number, t: number): boolean => {
    // Neighbours, which are most of what meets, share an edge; of those that share a corner only the edges across may pierce.
    const corner = common(s, t);
    if (corner === 3) return false;
    const p = cornersOf(s), q = cornersOf(t);
    if (corner >= 0) {
      const other = common(t, s);
      return pierces(positions, q, p[(corner + 1) % 3]!, p[(corner + 2) % 3]!, slack) || pierces(positions, p, q[(other + 1) % 3]!, q[(other + 2) % 3]!, slack);
    }
    for (let k = 0; k < 3; k += 1) {
      if (pierces(positions, q, p[k]!, p[(k + 1) % 3]!, slack) || pierces(positions, p, q[k]!, q[(k + 1) % 3]!, slack)) return true;
    }
    return false;
  };
  const stack: number[] = [0, 0];
  while (stack.length > 0 && found.length < most) {
    const b = stack.pop()!, a = stack.pop()!;
    if (a !== b && !meet(boxes, a, boxes, b)) continue;
    // Both lie at the same depth.
    if (a >= firstLeaf) {
      const end = starts[b - firstLeaf + 1]!;
      for (let i = starts[a - firstLeaf]!; i < starts[a - firstLeaf + 1]!; i += 1) {
        const s = order[i]!;
        for (let j = a === b ? i + 1 : starts[b - firstLeaf]!; j < end; j += 1) {
          const t = order[j]!;
          if (meet(of, s, of, t) && cross(s, t)) found.push({ a: Math.min(s, t), b: Math.max(s, t) });
        }
      }
    } else if (a === b) {
      stack.push(2 * a + 1, 2 * a + 1, 2 * a + 2, 2 * a + 2, 2 * a + 1, 2 * a + 2);
    } else {
      stack.push(2 * a + 1, 2 * b + 1, 2 * a + 1, 2 * b + 2, 2 * a + 2, 2 * b + 1, 2 * a + 2, 2 * b + 2);
    }
  }
  return found.slice(0, Number.isFinite(most) ? most : undefined);
}

/** The middle of a crossing. */
export function placeOf(crossing: Crossing, positions: Float32Array, triangles: Uint32Array): [number, number, number] {
  const at: [number, number, number] = [0, 0, 0];
  for (const t of [crossing.a, crossing.b]) {
    for (let c = 0; c < 3; c += 1) {
      for (let k = 0; k < 3; k += 1) at[k]! += positions[3 * triangles[3 * t + c]! + k]! / 6;
    }
  }
  return at;
}
