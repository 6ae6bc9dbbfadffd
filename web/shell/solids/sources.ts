// Where faces of solids come from. The library unites places alone, which is quicker; whose a face is and what lies on
// it is found afterwards, from the source that it was a piece of.
import { inverseOf, rowsOf } from './affine.ts';
import type { Rows } from './affine.ts';
import type { Faces } from './flaps.ts';
import type { MeshData, PartRun } from './protocol.ts';

/** Less than a tenth of a pixel of a texture of 4,096. */
const kSameUv = 2e-5;

/** uv at a place of the source's own space. */
export type Paint = (x: number, y: number, z: number) => [number, number];

/** Whose faces they are, and what they look like: as on a mesh, or painted by place. */
export type Source = { part: number } & ({ mesh: MeshData } | { paint: Paint });

/** Sources by the library's original ids. */
export type Sources = ReadonlyMap<number, Source>;

/**
 * A mesh of the library with uv; vertices of several runs are there once for each,
 * where these differ.
 */
export interface Carried extends MeshData {
  /** Vertices at one place: `from[i]` stands where `to[i]` does. */
  mergeFrom: Uint32Array;
  mergeTo: Uint32Array;
}

/** From the world back to the space of a run's source, whose matrix has three numbers a column. Null: they are the same. */
function toSource(matrix: Float32Array): Rows | null {
  const isIdentity = matrix.every((x, i) => x === (i % 4 === 0 ? 1 : 0));
  return isIdentity ? null : inverseOf(rowsOf(matrix, 3));
}

/** Writes the uv of places on the faces of a source. */
class Painter {
  private readonly back: Rows | null;
  private readonly mesh: MeshData | null;

  constructor(
    private readonly source: Source | undefined,
    transform: Float32Array,
  ) {
    this.back = toSource(transform);
    this.mesh = source && 'mesh' in source ? source.mesh : null;
  }

  /** Of a place on `face` of the source, to `uv` from `to` on. */
  write(uv: Float32Array, to: number, face: number, wx: number, wy: number, wz: number): void {
    const { back, mesh, source } = this;
    let x = wx,
      y = wy,
      z = wz;
    if (back) {
      x = back[0]! * wx + back[1]! * wy + back[2]! * wz + back[3]!;
      y = back[4]! * wx + back[5]! * wy + back[6]! * wz + back[7]!;
      z = back[8]! * wx + back[9]! * wy + back[10]! * wz + back[11]!;
    }
    if (mesh) {
      if (mesh.uv.length > 0) onFace(mesh, face, x, y, z, uv, to);
    } else if (source && 'paint' in source) {
      [uv[to], uv[to + 1]] = source.paint(x, y, z);
    }
  }
}

/** Between the uv of a face's corners, as the place lies between them. */
function onFace(
  { positions: p, uv: from, triangles }: MeshData,
  face: number,
  x: number,
  y: number,
  z: number,
  uv: Float32Array,
  to: number,
): void {
  const i = triangles[3 * face]!,
    j = triangles[3 * face + 1]!,
    k = triangles[3 * face + 2]!,
    a = 3 * i,
    b = 3 * j,
    c = 3 * k;
  const ux = p[b]! - p[a]!,
    uy = p[b + 1]! - p[a + 1]!,
    uz = p[b + 2]! - p[a + 2]!,
    vx = p[c]! - p[a]!,
    vy = p[c + 1]! - p[a + 1]!,
    vz = p[c + 2]! - p[a + 2]!;
  const qx = x - p[a]!,
    qy = y - p[a + 1]!,
    qz = z - p[a + 2]!;
  const uu = ux * ux + uy * uy + uz * uz,
    uv2 = ux * vx + uy * vy + uz * vz,
    vv = vx * vx + vy * vy + vz * vz,
    qu = qx * ux + qy * uy + qz * uz,
    qv = qx * vx + qy * vy + qz * vz;
  const area = uu * vv - uv2 * uv2;
  // On a face without area the first corner stands for all.
  let s = area > 0 ? (vv * qu - uv2 * qv) / area : 0,
    t = area > 0 ? (uu * qv - uv2 * qu) / area : 0;
  s = s > 0 ? (s < 1 ? s : 1) : 0;
  t = t > 0 ? (t < 1 - s ? t : 1 - s) : 0;
  const r = 1 - s - t;
  uv[to] = Math.min(1, Math.max(0, r * from[2 * i]! + s * from[2 * j]! + t * from[2 * k]!));
  uv[to + 1] = Math.min(1, Math.max(0, r * from[2 * i + 1]! + s * from[2 * j + 1]! + t * from[2 * k + 1]!));
}

/** The mesh with the uv of what its faces were. */
export function carried(
  { vertProperties, triVerts, runIndex, runOriginalID, runTransform, faceID }: Faces,
  sources: Sources,
): Carried {
  const n = vertProperties.length / 3;
  const triangles = triVerts.slice(),
    copyOf: number[] = [];
  // The run that has each vertex, and the copy for the run that is at it; runs count from 1.
  const taken = new Uint32Array(n),
    copied = new Uint32Array(n),
    copy = new Uint32Array(n);
  let uv = new Float32Array(2 * n + 512);
  for (let run = 0; run < runOriginalID.length; run += 1) {
    const own = run + 1,
      source = sources.get(runOriginalID[run]!),
      part = source?.part,
      painter = new Painter(source, runTransform.subarray(12 * run, 12 * run + 12));
    for (let c = runIndex[run]!; c < runIndex[run + 1]!; c += 1) {
      const v = triangles[c]!;
      if (taken[v] === own) continue;
      if (taken[v] !== 0 && copied[v] === own) {
        triangles[c] = copy[v]!;
        continue;
      }
      const before = taken[v]!,
        at = before === 0 ? v : n + copyOf.length;
      if (2 * at + 2 > uv.length) uv = grown(uv);
      painter.write(
        uv,
        2 * at,
        faceID[(c / 3) | 0]!,
        vertProperties[3 * v]!,
        vertProperties[3 * v + 1]!,
        vertProperties[3 * v + 2]!,
      );
      if (before === 0) {
        taken[v] = own;
        continue;
      }
      // Pieces of one part that go on into one another need no seam.
      const goesOn =
        sources.get(runOriginalID[before - 1]!)?.part === part &&
        Math.abs(uv[2 * v]! - uv[2 * at]!) + Math.abs(uv[2 * v + 1]! - uv[2 * at + 1]!) < kSameUv;
      copied[v] = own;
      copy[v] = goesOn ? v : at;
      triangles[c] = copy[v]!;
      if (!goesOn) copyOf.push(v);
    }
  }
  const positions = new Float32Array(3 * (n + copyOf.length));
  positions.set(vertProperties);
  for (const [i, v] of copyOf.entries()) positions.copyWithin(3 * (n + i), 3 * v, 3 * v + 3);
  return {
    positions,
    uv: uv.slice(0, 2 * (n + copyOf.length)),
    triangles,
    mergeFrom: Uint32Array.from(copyOf, (_, i) => n + i),
    mergeTo: Uint32Array.from(copyOf),
  };
}

function grown(values: Float32Array): Float32Array<ArrayBuffer> {
  const more = new Float32Array(2 * values.length);
  more.set(values);
  return more;
}

/** Runs of faces of one part each. */
export function runsOf(
  { runIndex, runOriginalID }: Pick<Faces, 'runIndex' | 'runOriginalID'>,
  sources: Sources,
): PartRun[] {
  const runs: PartRun[] = [];
  for (let i = 0; i < runOriginalID.length; i += 1) {
    const first = runIndex[i]! / 3,
      count = runIndex[i + 1]! / 3 - first;
    const part = sources.get(runOriginalID[i]!)?.part ?? 0,
      last = runs[runs.length - 1];
    if (last && last.part === part && last.first + last.count === first) last.count += count;
    else if (count > 0) runs.push({ part, first, count });
  }
  return runs;
}
