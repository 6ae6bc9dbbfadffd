// Lofts are rings of vertices, one after the other: where one crosses itself, it comes apart between rings
// into pieces that do not.
import type { MeshData } from './protocol.ts';

/** Vertices 0 … rings · size − 1 are rings of one closed curve each; at most two more close the ends. */
export interface Rings {
  size: number;
  count: number;
  /** The last ring is joined to the first. */
  joined: boolean;
  /** Triangles run the other way round than along the rings. */
  flipped: boolean;
}

/** Whether the step from one place in a ring to another is none or to the next one. */
function isNear(a: number, b: number, size: number): boolean {
  const step = Math.abs(a - b);
  return step <= 1 || step === size - 1;
}

/** The rings of a mesh; null when it is not made of rings of one curve. */
export function ringsOf({ positions, triangles }: MeshData): Rings | null {
  const [i, j, k] = triangles;
  if (i === undefined || j === undefined || k === undefined) return null;
  const corners = [i, j, k].filter((v) => v !== 0);
  if (corners.length !== 2) return null;
  const size = corners.includes(1) ? Math.max(...corners) : Math.min(...corners);
  const vertices = positions.length / 3,
    count = Math.floor(vertices / size),
    body = count * size;
  if (size < 3 || count < 2 || vertices - body > 2) return null;
  let joined = false;
  for (let t = 0; t < triangles.length; t += 3) {
    for (let c = 0; c < 3; c += 1) {
      const a = triangles[t + c]!,
        b = triangles[t + ((c + 1) % 3)]!;
      if (a >= body || b >= body) continue;
      const ra = Math.floor(a / size),
        rb = Math.floor(b / size),
        step = Math.abs(ra - rb);
      if (step === 0) {
        // Lids join places of a ring that are far apart; between rings only neighbours meet.
        if (ra !== 0 && ra !== count - 1 && !isNear(a % size, b % size, size)) return null;
      } else if (!isNear(a % size, b % size, size)) {
        return null;
      } else if (step !== 1) {
        if (step !== count - 1) return null;
        joined = true;
      }
    }
  }
  const first = [i, j, k],
    at = first.indexOf(0);
  const next = first[(at + 1) % 3]!;
  return { size, count, joined, flipped: next === 1 || (next === size + 1 && !corners.includes(1)) };
}

/**
 * Whether the middles of the rings always go on to the side to which the rings face. They do however sharply a loft
 * bends, but not where the surface turns back inside itself as an inner wall: such a mesh is not the sum of its pieces.
 */
export function runForward({ positions: p }: MeshData, { size, count }: Rings): boolean {
  const frames = Array.from({ length: count }, (_, ring) => {
    const middle = [0, 0, 0],
      normal = [0, 0, 0];
    for (let k = 0; k < size; k += 1) {
      const a = 3 * (ring * size + k),
        b = 3 * (ring * size + ((k + 1) % size));
      for (let axis = 0; axis < 3; axis += 1) {
        const u = (axis + 1) % 3,
          v = (axis + 2) % 3;
        middle[axis]! += p[a + axis]! / size;
        normal[axis]! += p[a + u]! * p[b + v]! - p[a + v]! * p[b + u]!;
      }
    }
    return { middle, normal };
  });
  let ahead = 0,
    back = 0;
  for (let ring = 0; ring + 1 < count; ring += 1) {
    const from = frames[ring]!,
      to = frames[ring + 1]!;
    const way = [0, 1, 2].reduce(
      (sum, k) => sum + (to.middle[k]! - from.middle[k]!) * (from.normal[k]! + to.normal[k]!),
      0,
    );
    if (way > 0) ahead += way;
    else back -= way;
  }
  return Math.min(ahead, back) < 0.02 * Math.max(ahead, back);
}

/** Triangulates a closed curve in space; the triangles follow its direction. */
export type FillCurve = (points: Float64Array) => [number, number, number][];

/** The closed piece between two rings; ends that were open are filled. */
export function pieceOf(mesh: MeshData, rings: Rings, from: number, to: number, fill: FillCurve): MeshData {
  const { size, count, flipped } = rings;
  const body = size * count,
    vertices = mesh.positions.length / 3;
  const firstVertex = from * size,
    taken = (to - from + 1) * size;
  const kept = new Map<number, number>();
  for (let v = 0; v < taken; v += 1) kept.set(firstVertex + v, v);
  const triangles: number[] = [];
  const ringAt = (v: number) => Math.floor(v / size);
  for (let t = 0; t < mesh.triangles.length; t += 3) {
    const corners = [mesh.triangles[t]!, mesh.triangles[t + 1]!, mesh.triangles[t + 2]!];
    const hub = corners.find((v) => v >= body);
    const onBody = corners.filter((v) => v < body).map(ringAt);
    const low = Math.min(...onBody),
      high = Math.max(...onBody);
    // The band that joins the last ring to the first belongs to no piece.
    if (low < from || high > to || high - low > 1) continue;
    const isLid = hub !== undefined || low === high;
    if (isLid && !((low === 0 && from === 0) || (high === count - 1 && to === count - 1))) continue;
    if (isLid && rings.joined) continue;
    for (const v of corners) {
      if (v >= body && !kept.has(v)) kept.set(v, kept.size);
      triangles.push(kept.get(v)!);
    }
  }
  const lid = (ring: number, start: boolean) => {
    const points = Float64Array.from(mesh.positions.subarray(3 * ring * size, 3 * (ring + 1) * size));
    for (const [a, b, c] of fill(points)) {
      const base = (ring - from) * size;
      if (start === flipped) triangles.push(base + a, base + c, base + b);
      else triangles.push(base + a, base + b, base + c);
    }
  };
  if (from > 0 || rings.joined) lid(from, true);
  if (to < count - 1 || rings.joined) lid(to, false);
  const positions = new Float32Array(3 * kept.size),
    uv = new Float32Array(mesh.uv.length > 0 ? 2 * kept.size : 0);
  for (const [old, at] of kept) {
    if (old >= vertices) continue;
    positions.set(mesh.positions.subarray(3 * old, 3 * old + 3), 3 * at);
    if (uv.length > 0) uv.set(mesh.uv.subarray(2 * old, 2 * old + 2), 2 * at);
  }
  return { positions, uv, triangles: Uint32Array.from(triangles) };
}

/** Whether a ring turns one way only, or next to it, and once. */
function isConvex({ positions: p }: MeshData, { size }: Rings, ring: number): boolean {
  const at = (k: number) => 3 * (ring * size + (k % size));
  const edge = (k: number) =>
    [0, 1, 2].map((axis) => p[at(k + 1) + axis]! - p[at(k) + axis]!) as [number, number, number];
  const cross = ([ax, ay, az]: number[], [bx, by, bz]: number[]) =>
    [ay! * bz! - az! * by!, az! * bx! - ax! * bz!, ax! * by! - ay! * bx!] as [number, number, number];
  const edges = Array.from({ length: size }, (_, k) => edge(k)),
    turns = edges.map((e, k) => cross(e, edges[(k + 1) % size]!));
  const normal = [0, 0, 0];
  for (let k = 0; k < size; k += 1)
    cross([p[at(k)]!, p[at(k) + 1]!, p[at(k) + 2]!], [p[at(k + 1)]!, p[at(k + 1) + 1]!, p[at(k + 1) + 2]!]).forEach(
      (x, axis) => {
        normal[axis]! += x;
      },
    );
  const length = Math.hypot(...normal);
  let back = 0,
    on = 0;
  for (const [k, turn] of turns.entries()) {
    const [a, b] = [edges[k]!, edges[(k + 1) % size]!];
    const angle = Math.atan2(
      (turn[0] * normal[0]! + turn[1] * normal[1]! + turn[2] * normal[2]!) / length,
      a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
    );
    if (angle < 0) back -= angle;
    else on += angle;
  }
  return length > 0 && back < 0.02 && on < 2 * Math.PI + 0.1;
}

type Corners = [number, number, number][];

/** A band's pieces, each by its corners: all of it where both of its rings are convex, otherwise its wedges. */
export function bandOf(mesh: MeshData, rings: Rings, from: number): Corners[] {
  const both = [from, (from + 1) % rings.count];
  if (!both.every((ring) => isConvex(mesh, rings, ring))) return wedgesOf(mesh, rings, from);
  return [
    both.flatMap((ring) =>
      Array.from(
        { length: rings.size },
        (_, k) =>
          [...mesh.positions.subarray(3 * (ring * rings.size + k), 3 * (ring * rings.size + k) + 3)] as [
            number,
            number,
            number,
          ],
      ),
    ),
  ];
}

/** The wedges of a piece of one band: for every two neighbours of its rings the corners of what lies between them and the middles. */
function wedgesOf(mesh: MeshData, rings: Rings, from: number): Corners[] {
  const at = (v: number): [number, number, number] => [
    mesh.positions[3 * v]!,
    mesh.positions[3 * v + 1]!,
    mesh.positions[3 * v + 2]!,
  ];
  const next = (from + 1) % rings.count;
  const middle = (ring: number): [number, number, number] => {
    const sum: [number, number, number] = [0, 0, 0];
    for (let k = 0; k < rings.size; k += 1)
      at(ring * rings.size + k).forEach((x, axis) => {
        sum[axis]! += x / rings.size;
      });
    return sum;
  };
  const a = middle(from),
    b = middle(next);
  return Array.from({ length: rings.size }, (_, k) => {
    const l = (k + 1) % rings.size;
    return [
      a,
      at(from * rings.size + k),
      at(from * rings.size + l),
      b,
      at(next * rings.size + k),
      at(next * rings.size + l),
    ];
  });
}
