// Whether a closed mesh crosses itself: a tree of boxes over its triangles, and for every pair of triangles whose
// boxes meet, how deep they are in one another: the shortest shift that takes them apart.

const kLeaf = 4;
/** Share of a mesh's diagonal: what is less deep only touches. Float coordinates are sure to seven digits. */
export const kTouch = 1e-6;

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
    const i = 3 * triangles[t]!,
      j = 3 * triangles[t + 1]!,
      l = 3 * triangles[t + 2]!;
    for (let k = 0; k < 3; k += 1) {
      const a = positions[i + k]!,
        b = positions[j + k]!,
        c = positions[l + k]!;
      boxes[at + k] = a < b ? (a < c ? a : c) : b < c ? b : c;
      boxes[at + 3 + k] = a > b ? (a > c ? a : c) : b > c ? b : c;
    }
  }
  return boxes;
}

/** Whether triangles that follow one another are near, as those of a loft are, which run round its rings. */
function isNearOrder(of: Float32Array): boolean {
  let way = 0,
    size = 0;
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
    for (let k = 0; k < 3; k += 1)
      code |= spaced((of[6 * t + k]! + of[6 * t + 3 + k]! - 2 * whole[k]!) * scale[k]!) << k;
    codes[t] = code;
  }
  let order = Uint32Array.from({ length: n }, (_, i) => i),
    other = new Uint32Array(n);
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
  const tree: Tree = {
    boxes: new Float32Array(6 * (2 * leaves - 1)),
    firstLeaf: leaves - 1,
    starts: new Uint32Array(leaves + 1),
    order: isNearOrder(of) ? Uint32Array.from({ length: n }, (_, i) => i) : nearOrder(of, whole),
  };
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
    for (let i = tree.starts[leaf]!; i < tree.starts[leaf + 1]!; i += 1)
      widen(tree.firstLeaf + leaf, of, 6 * tree.order[i]!);
  }
  for (let node = 2 * leaves - 2; node > 0; node -= 1) widen((node - 1) >> 1, boxes, 6 * node);
  return tree;
}

/** Unit normal and distance from the origin of every triangle's plane; all 0 where it has none. */
function planesOf(p: Float32Array, triangles: Uint32Array): Float64Array {
  const planes = new Float64Array((triangles.length / 3) * 4);
  for (let t = 0, at = 0; t < triangles.length; t += 3, at += 4) {
    const a = 3 * triangles[t]!,
      b = 3 * triangles[t + 1]!,
      c = 3 * triangles[t + 2]!;
    const ax = p[a]!,
      ay = p[a + 1]!,
      az = p[a + 2]!;
    const ux = p[b]! - ax,
      uy = p[b + 1]! - ay,
      uz = p[b + 2]! - az,
      vx = p[c]! - ax,
      vy = p[c + 1]! - ay,
      vz = p[c + 2]! - az;
    const x = uy * vz - uz * vy,
      y = uz * vx - ux * vz,
      z = ux * vy - uy * vx,
      length = Math.sqrt(x * x + y * y + z * z);
    if (!(length > 0)) continue;
    planes[at] = x / length;
    planes[at + 1] = y / length;
    planes[at + 2] = z / length;
    planes[at + 3] = (ax * x + ay * y + az * z) / length;
  }
  return planes;
}

/** The search for pairs that cross in one mesh. */
class Search {
  readonly found: Crossing[] = [];
  private readonly of: Float32Array;
  private readonly tree: Tree;
  private readonly planes: Float64Array;
  private readonly touch: number;
  /** Corners of two triangles, x, y, z each. */
  private readonly one = new Float64Array(9);
  private readonly other = new Float64Array(9);

  constructor(
    private readonly positions: Float32Array,
    private readonly triangles: Uint32Array,
    private readonly most: number,
    touch?: number,
  ) {
    this.of = triangleBoxes(positions, triangles);
    const whole = wholeBox(this.of);
    this.touch = touch ?? kTouch * Math.hypot(whole[3]! - whole[0]!, whole[4]! - whole[1]!, whole[5]! - whole[2]!);
    this.tree = buildTree(this.of, whole);
    this.planes = planesOf(positions, triangles);
  }

  run(): void {
    const { firstLeaf, boxes } = this.tree,
      stack: number[] = [0, 0];
    while (stack.length > 0 && this.found.length < this.most) {
      const b = stack.pop()!,
        a = stack.pop()!;
      if (a !== b && !this.meet(boxes, a, b)) continue;
      // Both lie at the same depth.
      if (a >= firstLeaf) this.leaves(a - firstLeaf, b - firstLeaf);
      else if (a === b) stack.push(2 * a + 1, 2 * a + 1, 2 * a + 2, 2 * a + 2, 2 * a + 1, 2 * a + 2);
      else stack.push(2 * a + 1, 2 * b + 1, 2 * a + 1, 2 * b + 2, 2 * a + 2, 2 * b + 1, 2 * a + 2, 2 * b + 2);
    }
  }

  private leaves(a: number, b: number): void {
    const { order, starts } = this.tree,
      end = starts[b + 1]!;
    for (let i = starts[a]!; i < starts[a + 1]!; i += 1) {
      const s = order[i]!;
      for (let j = a === b ? i + 1 : starts[b]!; j < end; j += 1) {
        const t = order[j]!;
        if (this.meet(this.of, s, t) && this.cross(s, t)) this.found.push({ a: Math.min(s, t), b: Math.max(s, t) });
      }
    }
  }

  /** Whether two boxes reach into one another. */
  private meet(boxes: Float32Array, a: number, b: number): boolean {
    const i = 6 * a,
      j = 6 * b,
      { touch } = this;
    return (
      boxes[j + 3]! - boxes[i]! > touch &&
      boxes[i + 3]! - boxes[j]! > touch &&
      boxes[j + 4]! - boxes[i + 1]! > touch &&
      boxes[i + 4]! - boxes[j + 1]! > touch &&
      boxes[j + 5]! - boxes[i + 2]! > touch &&
      boxes[i + 5]! - boxes[j + 2]! > touch
    );
  }

  private cross(s: number, t: number): boolean {
    // Next to everything that is not apart by the planes is a neighbour. Those that share an edge only touch.
    return !this.beside(s, t) && !this.beside(t, s) && this.shared(s, t) < 2 && this.isDeep(s, t);
  }

  /** Whether all of t lies on one side of the plane of s. */
  private beside(s: number, t: number): boolean {
    const { planes, positions: p, triangles, touch } = this;
    const x = planes[4 * s]!,
      y = planes[4 * s + 1]!,
      z = planes[4 * s + 2]!,
      d = planes[4 * s + 3]!;
    const i = 3 * triangles[3 * t]!,
      j = 3 * triangles[3 * t + 1]!,
      k = 3 * triangles[3 * t + 2]!;
    const a = x * p[i]! + y * p[i + 1]! + z * p[i + 2]! - d;
    const b = x * p[j]! + y * p[j + 1]! + z * p[j + 2]! - d;
    const c = x * p[k]! + y * p[k + 1]! + z * p[k + 2]! - d;
    // A triangle without a plane says nothing: its distances are all 0, and its edges decide.
    return (
      ((a <= touch && b <= touch && c <= touch) || (a >= -touch && b >= -touch && c >= -touch)) &&
      (x !== 0 || y !== 0 || z !== 0)
    );
  }

  /** How many corners both have. */
  private shared(s: number, t: number): number {
    const { triangles } = this;
    const a = triangles[3 * t]!,
      b = triangles[3 * t + 1]!,
      c = triangles[3 * t + 2]!;
    let count = 0;
    for (let k = 3 * s; k < 3 * s + 3; k += 1) {
      const v = triangles[k]!;
      if (v === a || v === b || v === c) count += 1;
    }
    return count;
  }

  /**
   * Whether no shift as short as `touch` takes the triangles, which no plane of theirs parts, out of one another: the
   * shortest one that does is square to an edge of each (the faces of their Minkowski difference).
   */
  private isDeep(s: number, t: number): boolean {
    const { positions: p, triangles, one, other, touch } = this;
    for (let c = 0; c < 3; c += 1) {
      for (let k = 0; k < 3; k += 1) {
        one[3 * c + k] = p[3 * triangles[3 * s + c]! + k]!;
        other[3 * c + k] = p[3 * triangles[3 * t + c]! + k]!;
      }
    }
    let axes = 0;
    for (let a = 0; a < 9; a += 3) {
      const b = (a + 3) % 9,
        ux = one[b]! - one[a]!,
        uy = one[b + 1]! - one[a + 1]!,
        uz = one[b + 2]! - one[a + 2]!;
      for (let c = 0; c < 9; c += 3) {
        const d = (c + 3) % 9,
          vx = other[d]! - other[c]!,
          vy = other[d + 1]! - other[c + 1]!,
          vz = other[d + 2]! - other[c + 2]!;
        const x = uy * vz - uz * vy,
          y = uz * vx - ux * vz,
          z = ux * vy - uy * vx,
          length = Math.sqrt(x * x + y * y + z * z);
        if (!(length > 0)) continue;
        if (isApart(one, other, x, y, z, touch * length)) return false;
        axes += 1;
      }
    }
    // Without any, both are pieces of parallel lines.
    return axes > 0;
  }
}

/** Whether two triangles overlap no further than `limit` as seen along an axis. */
function isApart(one: Float64Array, other: Float64Array, x: number, y: number, z: number, limit: number): boolean {
  const a = x * one[0]! + y * one[1]! + z * one[2]!,
    b = x * one[3]! + y * one[4]! + z * one[5]!,
    c = x * one[6]! + y * one[7]! + z * one[8]!;
  const d = x * other[0]! + y * other[1]! + z * other[2]!,
    e = x * other[3]! + y * other[4]! + z * other[5]!,
    f = x * other[6]! + y * other[7]! + z * other[8]!;
  return Math.max(a, b, c) - Math.min(d, e, f) <= limit || Math.max(d, e, f) - Math.min(a, b, c) <= limit;
}

/**
 * Pairs of triangles that cross, at most `most`; vertices of one place are one vertex. Two cross when nothing shorter
 * than `touch` parts them (left out: that share of the mesh's diagonal): what is less deep is the rounding of float
 * coordinates, or lies in one plane.
 */
export function findCrossings(
  positions: Float32Array,
  triangles: Uint32Array,
  most = Infinity,
  touch?: number,
): Crossing[] {
  if (triangles.length === 0) return [];
  const search = new Search(positions, triangles, most, touch);
  search.run();
  return search.found.slice(0, Number.isFinite(most) ? most : undefined);
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
