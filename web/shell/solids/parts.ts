// Parts for manifold-3d: closed meshes that do not cross themselves. A loft that does comes apart between its
// rings into pieces that do not, and is united again.
import type { Manifold, ManifoldToplevel, Vec3 } from 'manifold-3d';
import { signedVolume } from './grid.ts';
import type { Point } from './grid.ts';
import type { MeshData } from './protocol.ts';
import { bandOf, pieceOf, ringsOf, runForward } from './rings.ts';
import type { FillCurve, Rings } from './rings.ts';
import type { SelfCrossing } from './self_crossing.ts';

/** What parts are looked over, mended and united with. */
export interface Tools {
  library: ManifoldToplevel;
  selfCrossing: SelfCrossing;
}

/** The part crosses itself at `at` (its own space) and cannot be mended. */
export class FaultyPart extends Error {
  constructor(readonly at: Point) {
    super('PartCrossesItself');
  }
}

/** Takes a mesh down as the source of faces; the original id that they are to carry. */
export type Register = (mesh: MeshData) => number;

/** The mesh as it is, as a solid. */
export function fromMesh(library: ManifoldToplevel, data: MeshData, register: Register): Manifold {
  const { positions, triangles } = data,
    faces = triangles.length / 3,
    faceID = new Uint32Array(faces);
  for (let f = 0; f < faces; f += 1) faceID[f] = f;
  const mesh = new library.Mesh({
    numProp: 3,
    vertProperties: positions,
    triVerts: triangles,
    runOriginalID: Uint32Array.of(register(data)),
    runIndex: Uint32Array.of(0, triangles.length),
    faceID,
  });
  const solid = library.Manifold.ofMesh(mesh);
  if (solid.status() !== 'NoError') throw new Error(solid.status());
  return solid;
}

/** Fills a curve in the plane that fits it best. */
function fillIn(library: ManifoldToplevel): FillCurve {
  return (points) => {
    const n = points.length / 3;
    const normal: [number, number, number] = [0, 0, 0];
    for (let i = 0; i < n; i += 1) {
      const a = 3 * i,
        b = 3 * ((i + 1) % n);
      normal[0] += (points[a + 1]! - points[b + 1]!) * (points[a + 2]! + points[b + 2]!);
      normal[1] += (points[a + 2]! - points[b + 2]!) * (points[a]! + points[b]!);
      normal[2] += (points[a]! - points[b]!) * (points[a + 1]! + points[b + 1]!);
    }
    const axis = [0, 1, 2].reduce((best, k) => (Math.abs(normal[k]!) > Math.abs(normal[best]!) ? k : best), 0);
    // Counter-clockwise seen against the normal's longest axis.
    const u = (axis + 1) % 3,
      v = (axis + 2) % 3,
      turned = normal[axis]! < 0;
    const flat = Array.from(
      { length: n },
      (_, i) => [points[3 * i + (turned ? v : u)]!, points[3 * i + (turned ? u : v)]!] as [number, number],
    );
    return library.triangulate([flat]) as [number, number, number][];
  };
}

/** Pieces between rings that do not cross themselves; none where that cannot be had. */
function piecesOf({ library, selfCrossing }: Tools, mesh: MeshData, rings: Rings): Manifold[] | null {
  const fill = fillIn(library);
  const pieces: Manifold[] = [];
  const fail = () => {
    for (const piece of pieces) piece.delete();
    return null;
  };
  const ranges: [number, number][] = [[0, rings.count - 1]];
  while (ranges.length > 0) {
    const [from, to] = ranges.pop()!;
    const piece = pieceOf(mesh, rings, from, to, fill);
    const clean = selfCrossing(piece) === null;
    if (clean && signedVolume(piece) <= 0) return fail();
    if (clean) pieces.push(bare(library, piece.positions, piece.triangles));
    else if (to - from > 1) ranges.push([from, (from + to) >> 1], [(from + to) >> 1, to]);
    else pieces.push(...hulls(library, mesh, rings, from));
  }
  if (rings.joined) pieces.push(...hulls(library, mesh, rings, rings.count - 1));
  return pieces;
}

function hulls(library: ManifoldToplevel, mesh: MeshData, rings: Rings, from: number): Manifold[] {
  return bandOf(mesh, rings, from).flatMap((corners) => {
    const hull = library.Manifold.hull(corners as Vec3[]);
    if (!hull.isEmpty() && hull.status() === 'NoError') return [hull];
    hull.delete();
    return [];
  });
}

/** The part as a solid. Throws FaultyPart. */
export function importPart(tools: Tools, mesh: MeshData, register: Register): Manifold {
  const { library, selfCrossing } = tools,
    crossing = selfCrossing(mesh);
  if (!crossing) return fromMesh(library, mesh, register);
  const fault = new FaultyPart(crossing),
    rings = ringsOf(mesh),
    pieces = rings && runForward(mesh, rings) ? piecesOf(tools, { ...mesh, uv: new Float32Array() }, rings) : null;
  if (!pieces?.length) throw fault;
  const solid = withoutCrumbs(library, united(library, pieces)),
    { vertProperties: positions, triVerts: triangles } = solid.getMesh();
  const sound = solid.status() === 'NoError' && triangles.length > 0;
  solid.delete();
  if (!sound || selfCrossing({ positions, triangles })) throw fault;
  return fromMesh(library, { positions, triangles, uv: uvOn(mesh, positions) }, register);
}

/** The mesh as a solid whose faces nobody asks for. */
function bare(library: ManifoldToplevel, positions: Float32Array, triangles: Uint32Array): Manifold {
  const solid = library.Manifold.ofMesh(
    new library.Mesh({ numProp: 3, vertProperties: positions, triVerts: triangles }),
  );
  if (solid.status() !== 'NoError') throw new Error(solid.status());
  return solid;
}

function nearestOf(from: Float32Array, px: number, py: number, pz: number): number {
  let nearest = 0,
    least = Infinity;
  for (let v = 0; v < from.length; v += 3) {
    const x = from[v]! - px,
      y = from[v + 1]! - py,
      z = from[v + 2]! - pz,
      d = x * x + y * y + z * z;
    if (d >= least) continue;
    least = d;
    nearest = v / 3;
  }
  return nearest;
}

/** uv of places on a mesh: those of its vertices, and where it has none those of the nearest one. */
function uvOn({ positions: from, uv: known }: MeshData, places: Float32Array): Float32Array {
  const uv = new Float32Array(known.length > 0 ? (places.length / 3) * 2 : 0);
  if (uv.length === 0) return uv;
  const at = new Map<string, number>();
  for (let v = 0; v < from.length; v += 3) at.set(`${from[v]} ${from[v + 1]} ${from[v + 2]}`, v / 3);
  for (let p = 0; p < places.length; p += 3) {
    const vertex =
      at.get(`${places[p]} ${places[p + 1]} ${places[p + 2]}`) ??
      nearestOf(from, places[p]!, places[p + 1]!, places[p + 2]!);
    uv.set(known.subarray(2 * vertex, 2 * vertex + 2), (p / 3) * 2);
  }
  return uv;
}

/**
 * The union of pieces that follow one another, which it takes over. Where a loft bends about its own inside they all cross
 * there, in ever more splinters: so it is made of a few at a time, without what is as thin as rounding.
 */
function united(library: ManifoldToplevel, pieces: Manifold[]): Manifold {
  const few = 6,
    tolerance = 1e-5;
  let row = pieces;
  do {
    const next: Manifold[] = [];
    for (let i = 0; i < row.length; i += few) {
      const group = row.slice(i, i + few),
        whole = library.Manifold.union(group),
        plain = whole.asOriginal(),
        { min, max } = whole.boundingBox();
      next.push(plain.simplify(tolerance * Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2])));
      for (const each of [whole, plain, ...group]) each.delete();
    }
    row = next;
  } while (row.length > 1);
  return row[0]!;
}

/** Without the splinters and voids as thin as rounding that are left where pieces meet. */
function withoutCrumbs(library: ManifoldToplevel, solid: Manifold): Manifold {
  const pieces = solid.decompose(),
    least = 1e-5 * solid.volume(),
    large = pieces.filter((piece) => Math.abs(piece.volume()) > least);
  const some = large.length < pieces.length && large.length > 0 ? library.Manifold.compose(large) : null;
  for (const piece of pieces) piece.delete();
  if (!some) return solid;
  solid.delete();
  return some;
}
