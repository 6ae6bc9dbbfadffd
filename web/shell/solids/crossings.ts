// Whether a closed mesh crosses itself: a tree of boxes over its triangles, and for every pair of triangles
// without a common corner whose boxes meet, whether an edge of one pierces the other.

const kLeaf = 8;

interface Tree {
  /** Six numbers a node: low x, y, z, high x, y, z. */
  boxes: Float64Array;
  /** First triangle of a leaf in `order`, or −1 − left child; the right child follows the left one's subtree. */
  first: Int32Array;
  count: Int32Array;
  right: Int32Array;
  order: Uint32Array;
}

export interface Crossing {
  /** Two triangles that cross, by number. */
  a: number;
  b: number;
}

function triangleBoxes(positions: Float32Array, triangles: Uint32Array): Float64Array {
  const boxes = new Float64Array(triangles.length * 2);
  for (let t = 0; t < triangles.length / 3; t += 1) {
    for (let k = 0; k < 3; k += 1) {
      const a = positions[3 * triangles[3 * t]! + k]!, b = positions[3 * triangles[3 * t + 1]! + k]!, c = positions[3 * triangles[3 * t + 2]! + k]!;
      boxes[6 * t + k] = Math.min(a, b, c);
      boxes[6 * t + 3 + k] = Math.max(a, b, c);
    }
  }
  return boxes;
}

function buildTree(of: Float64Array): Tree {
  const n = of.length / 6;
  const most = Math.max(1, 4 * Math.ceil(n / kLeaf) + 8);
  const tree: Tree = { boxes: new Float64Array(6 * most), first: new Int32Array(most), count: new Int32Array(most), right: new Int32Array(most), order: Uint32Array.from({ length: n }, (_, i) => i) };
  let nodes = 0;
  const build = (begin: number, end: number): number => {
    const node = nodes;
    nodes += 1;
    const box = tree.boxes.subarray(6 * node, 6 * node + 6);
    box.fill(Infinity, 0, 3);
    box.fill(-Infinity, 3, 6);
    for (let i = begin; i < end; i += 1) {
      const t = 6 * tree.order[i]!;
      for (let k = 0; k < 3; k += 1) {
        box[k] = Math.min(box[k]!, of[t + k]!);
        box[3 + k] = Math.max(box[3 + k]!, of[t + 3 + k]!);
      }
    }
    tree.first[node] = begin;
    tree.count[node] = end - begin;
    if (end - begin <= kLeaf) return node;
    let axis = 0;
    for (let k = 1; k < 3; k += 1) if (box[3 + k]! - box[k]! > box[3 + axis]! - box[axis]!) axis = k;
    const part = tree.order.subarray(begin, end);
    part.sort((a, b) => of[6 * a + axis]! + of[6 * a + 3 + axis]! - of[6 * b + axis]! - of[6 * b + 3 + axis]!);
    const middle = (begin + end) >> 1;
    tree.count[node] = 0;
    build(begin, middle);
    tree.right[node] = build(middle, end);
    return node;
  };
  if (n > 0) build(0, n);
  return tree;
}

function meet(boxes: Float64Array, a: number, of: Float64Array, b: number): boolean {
  for (let k = 0; k < 3; k += 1) {
    if (boxes[6 * a + k]! > of[6 * b + 3 + k]! || of[6 * b + k]! > boxes[6 * a + 3 + k]!) return false;
  }
  return true;
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
  const of = triangleBoxes(positions, triangles);
  const tree = buildTree(of);
  if (triangles.length === 0) return found;
  const { boxes } = tree;
  let diagonal = 0;
  for (let k = 0; k < 3; k += 1) diagonal += (boxes[3 + k]! - boxes[k]!) ** 2;
  // Float coordinates are sure to seven digits: what is closer than that only touches.
  const slack = Math.sqrt(diagonal) ** 3 * 1e-12;
  const corners = (t: number): [number, number, number] => [3 * triangles[3 * t]!, 3 * triangles[3 * t + 1]!, 3 * triangles[3 * t + 2]!];
  const cross = (s: number, t: number): boolean => {
    const a = corners(s), b = corners(t);
    for (const corner of a) if (b.includes(corner)) return false;
    for (let k = 0; k < 3; k += 1) {
      if (pierces(positions, b, a[k]!, a[(k + 1) % 3]!, slack) || pierces(positions, a, b[k]!, b[(k + 1) % 3]!, slack)) return true;
    }
    return false;
  };
  const stack: number[] = [0, 0];
  while (stack.length > 0 && found.length < most) {
    const b = stack.pop()!, a = stack.pop()!;
    if (a !== b && !meet(boxes, a, boxes, b)) continue;
    const ca = tree.count[a]!, cb = tree.count[b]!;
    if (ca > 0 && cb > 0) {
      for (let i = 0; i < ca; i += 1) {
        const s = tree.order[tree.first[a]! + i]!;
        for (let j = a === b ? i + 1 : 0; j < cb; j += 1) {
          const t = tree.order[tree.first[b]! + j]!;
          if (meet(of, s, of, t) && cross(s, t)) found.push({ a: Math.min(s, t), b: Math.max(s, t) });
        }
      }
    } else if (a === b) {
      stack.push(a + 1, a + 1, tree.right[a]!, tree.right[a]!, a + 1, tree.right[a]!);
    } else if (cb > 0 || (ca === 0 && tree.first[a]! <= tree.first[b]!)) {
      stack.push(a + 1, b, tree.right[a]!, b);
    } else {
      stack.push(a, b + 1, a, tree.right[b]!);
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
