// Solids from distance fields: the inside of a hollow, and the rounding at a seam.
import type { Manifold, ManifoldToplevel } from 'manifold-3d';
import { DistanceField } from './distance.ts';
import { at, gridOver, lowestOf, sample, signedVolume, surfaceWhere } from './grid.ts';
import type { Box, Grid, Point, Surface } from './grid.ts';
import type { SolidNode } from './protocol.ts';
import { countOf, rootsOf } from './topology.ts';
import { Unsolvable } from './unsolvable.ts';

/** What a maker of solids may do with what it makes on the way. */
export interface Making {
  /** Original id for the faces that are new, and the part whose they are. */
  id: number;
  part: number;
  /** Deleted when the step is done. */
  own: Manifold[];
}

/** Grid cells along the longest side, and all in all. */
const kHollowCells = 88,
  kSeamCells = 6,
  kMostCells = 1_500_000;

function surfaceOf(solid: Manifold): Surface {
  const { vertProperties, triVerts } = solid.getMesh();
  return { positions: vertProperties, triangles: triVerts };
}

function grown(box: Box, by: number): Box {
  return { min: box.min.map((x) => x - by) as Point, max: box.max.map((x) => x + by) as Point };
}

function sidesOf(box: Box): Point {
  return [0, 1, 2].map((k) => box.max[k]! - box.min[k]!) as Point;
}

/** At least `step`, and so large that the grid does not get too many points. */
function affordable(box: Box, step: number): number {
  const [x, y, z] = sidesOf(box);
  return Math.max(step, Math.cbrt((x * y * z) / kMostCells));
}

/** The surface with its triangles cut where `side` changes its sign, so that none lies on both sides. */
function cutAlong({ positions, triangles }: Surface, side: (x: number, y: number, z: number) => number): Surface {
  const n = positions.length / 3,
    points = Array.from(positions),
    corners: number[] = [],
    cuts = new Map<number, number>();
  const sides = Float64Array.from({ length: n }, (_, v) =>
    side(positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!),
  );
  const cut = (a: number, b: number): number => {
    const [from, to] = a < b ? [a, b] : [b, a],
      known = cuts.get(from * n + to);
    if (known !== undefined) return known;
    const t = Math.min(0.95, Math.max(0.05, sides[from]! / (sides[from]! - sides[to]!))),
      made = points.length / 3;
    for (let k = 0; k < 3; k += 1)
      points.push(positions[3 * from + k]! + t * (positions[3 * to + k]! - positions[3 * from + k]!));
    cuts.set(from * n + to, made);
    return made;
  };
  for (let i = 0; i < triangles.length; i += 3) {
    const three = [triangles[i]!, triangles[i + 1]!, triangles[i + 2]!],
      above = three.filter((v) => sides[v]! > 0).length;
    if (above === 0 || above === 3) {
      corners.push(...three);
      continue;
    }
    // The corner that is alone on its side comes first.
    const alone = three.findIndex((v) => sides[v]! > 0 === (above === 1));
    const [a, b, c] = [three[alone]!, three[(alone + 1) % 3]!, three[(alone + 2) % 3]!],
      ab = cut(a, b),
      ca = cut(c, a);
    corners.push(a, ab, ca, ab, b, c, ab, c, ca);
  }
  return { positions: Float32Array.from(points), triangles: Uint32Array.from(corners) };
}

/** The surface as a solid; `which` says which of the original ids a face at this place carries. */
function solidOf(
  library: ManifoldToplevel,
  { positions, triangles }: Surface,
  ids: number[],
  which: (x: number, y: number, z: number) => number = () => 0,
): Manifold {
  const faces = triangles.length / 3,
    of = new Uint8Array(faces),
    runIndex = new Uint32Array(ids.length + 1);
  for (let f = 0; f < faces; f += 1) {
    const a = 3 * triangles[3 * f]!,
      b = 3 * triangles[3 * f + 1]!,
      c = 3 * triangles[3 * f + 2]!;
    of[f] =
      ids.length < 2
        ? 0
        : which(
            (positions[a]! + positions[b]! + positions[c]!) / 3,
            (positions[a + 1]! + positions[b + 1]! + positions[c + 1]!) / 3,
            (positions[a + 2]! + positions[b + 2]! + positions[c + 2]!) / 3,
          );
    runIndex[of[f]! + 1]! += 3;
  }
  for (let id = 0; id < ids.length; id += 1) runIndex[id + 1]! += runIndex[id]!;
  const next = runIndex.slice(),
    triVerts = new Uint32Array(triangles.length);
  for (let f = 0; f < faces; f += 1) {
    triVerts.set(triangles.subarray(3 * f, 3 * f + 3), next[of[f]!]!);
    next[of[f]!]! += 3;
  }
  const solid = library.Manifold.ofMesh(
    new library.Mesh({
      numProp: 3,
      vertProperties: positions,
      triVerts,
      runOriginalID: Uint32Array.from(ids),
      runIndex,
    }),
  );
  if (solid.status() !== 'NoError') throw new Unsolvable({ error: 'SolidFailed' });
  return solid;
}

/** The pieces of a surface that reach as far as `rim` along a direction. */
function reaching(
  { positions, triangles }: Surface,
  along: (x: number, y: number, z: number) => number,
  rim: number,
): Surface {
  const n = positions.length / 3,
    root = rootsOf(n, triangles),
    reaches = new Uint8Array(n);
  for (let v = 0; v < n; v += 1)
    if (along(positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!) >= rim) reaches[root[v]!] = 1;
  return { positions, triangles: triangles.filter((_, i) => reaches[root[triangles[i]!]!] === 1) };
}

/**
 * Which way to open a body whose end towards the opening is a flat lid that leans a little: square to the lid, so that
 * all of it opens. Any other body is opened as it is asked for.
 */
function squareToLid(
  { positions: p, triangles }: { positions: Float32Array; triangles: Uint32Array },
  opening: readonly number[],
): Point {
  const facing = Math.cos(0.45),
    flat = Math.cos(0.02),
    most = 0.7;
  const asked = [...opening] as Point,
    [ox, oy, oz] = asked,
    lean: Point = [0, 0, 0];
  let all = 0;
  // Normals as long as twice the area of the faces that look towards the opening; 0 for the others.
  const normals = new Float64Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t]!,
      b = 3 * triangles[t + 1]!,
      c = 3 * triangles[t + 2]!;
    const ux = p[b]! - p[a]!,
      uy = p[b + 1]! - p[a + 1]!,
      uz = p[b + 2]! - p[a + 2]!,
      vx = p[c]! - p[a]!,
      vy = p[c + 1]! - p[a + 1]!,
      vz = p[c + 2]! - p[a + 2]!;
    const x = uy * vz - uz * vy,
      y = uz * vx - ux * vz,
      z = ux * vy - uy * vx,
      area = Math.sqrt(x * x + y * y + z * z);
    if (!(x * ox + y * oy + z * oz > facing * area)) continue;
    normals[t] = x;
    normals[t + 1] = y;
    normals[t + 2] = z;
    lean[0] += x;
    lean[1] += y;
    lean[2] += z;
    all += area;
  }
  const length = Math.hypot(...lean);
  if (!(length > 0)) return asked;
  const square = lean.map((x) => x / length) as Point;
  let lid = 0;
  for (let t = 0; t < normals.length; t += 3) {
    const x = normals[t]!,
      y = normals[t + 1]!,
      z = normals[t + 2]!,
      area = Math.sqrt(x * x + y * y + z * z);
    if (x * square[0] + y * square[1] + z * square[2] > flat * area) lid += area;
  }
  return lid > most * all ? square : asked;
}

/**
 * A cavity without passages through the handles of its body, which nobody scoops out of a mug: it has none where a ball
 * does not go that is just too large for them. Where there are none, or they are most of it, it stays as it is.
 */
function withoutPassages(
  grid: Grid,
  all: Surface,
  roomOf: () => Float32Array,
  scooped: (room: Float32Array) => Surface,
): Surface {
  const handlesOf = ({ positions, triangles }: Surface) => countOf(positions.length / 3, triangles).handles;
  if (handlesOf(all) === 0) return all;
  const { step } = grid,
    room = roomOf(),
    most = room.reduce((high, value) => Math.max(high, value), 0);
  for (let ball = step; ball < most / 2; ball += step) {
    const core = surfaceWhere(
      grid,
      room.map((value) => value - ball),
    );
    if (handlesOf(core) > 0) continue;
    // Half a step more, for the grid is only so fine.
    const away = new DistanceField(core.positions, core.triangles, grid, ball + 2 * step).values;
    const some = scooped(room.map((value, i) => Math.min(value, ball + 0.5 * step - away[i]!)));
    if (signedVolume(some) < 0.6 * signedVolume(all)) break;
    if (handlesOf(some) === 0) return some;
  }
  return all;
}

/** The thickest wall that fits, a little less than what just does; 0: none that is worth it. */
function thickestThat(fits: (thick: number) => boolean, tooThick: number): number {
  let low = 0,
    high = tooThick;
  for (let halved = 0; halved < 8; halved += 1) {
    const middle = (low + high) / 2;
    if (fits(middle)) low = middle;
    else high = middle;
  }
  return 0.95 * low;
}

/** What is left of a body, and what was taken out of it. Both are the caller's. */
export interface Hollow {
  shell: Manifold;
  cavity: Manifold;
}

/**
 * A shell: the solid without everything that is deeper inside than the wall. Towards the opening the inside goes on
 * straight from where it is first as deep as the wall on all sides.
 */
export function hollowOf(
  library: ManifoldToplevel,
  body: Manifold,
  node: SolidNode,
  { id, part, own }: Making,
): Hollow {
  const surface = surfaceOf(body),
    { wall } = node;
  const opening = node.opening && node.cut === 0 ? squareToLid(surface, node.opening) : node.opening;
  const bounds = body.boundingBox() as Box;
  const longest = Math.max(...sidesOf(bounds));
  // Twice as fine as the wall is thick, as far as that can be paid for.
  const step = affordable(
    bounds,
    Math.max(longest / (node.coarse ? kHollowCells / 2 : kHollowCells), Math.min(wall / 2, longest / 40)),
  );
  const grid = gridOver(grown(bounds, 2.5 * step), step);
  const field = new DistanceField(surface.positions, surface.triangles, grid, wall + 3 * step, 'inside');
  let low = Infinity,
    high = -Infinity;
  const along = (x: number, y: number, z: number) => (opening ? x * opening[0] + y * opening[1] + z * opening[2] : 0);
  for (let v = 0; v < surface.positions.length; v += 3) {
    const s = along(surface.positions[v]!, surface.positions[v + 1]!, surface.positions[v + 2]!);
    low = Math.min(low, s);
    high = Math.max(high, s);
  }
  const rim = opening ? high - node.cut * (high - low) : Infinity;
  // What does not reach the opening, such as the inside of a handle, would be a void that nothing runs out of.
  const scoopedBehind = (thick: number, room: Float32Array) => {
    if (!opening) return surfaceWhere(grid, room);
    const throat = Math.min(rim, high - thick - step);
    return reaching(
      surfaceWhere(
        grid,
        sample(grid, (x, y, z, i) => {
          const beyond = along(x, y, z) - throat;
          return beyond > 0
            ? at(grid, room, x - beyond * opening[0], y - beyond * opening[1], z - beyond * opening[2])
            : room[i]!;
        }),
      ),
      along,
      rim,
    );
  };
  const scooped = (room: Float32Array) => scoopedBehind(wall, room);
  const roomBehind = (thick: number, { values }: DistanceField) => values.map((value) => -value - thick);
  const roomIn = (distances: DistanceField) => roomBehind(wall, distances),
    all = scooped(roomIn(field));
  const inside = opening
    ? withoutPassages(
        grid,
        all,
        () => roomIn(new DistanceField(surface.positions, surface.triangles, grid, longest, 'inside')),
        scooped,
      )
    : all;
  if (inside.triangles.length === 0) {
    const fits = (thick: number) => scoopedBehind(thick, roomBehind(thick, field)).triangles.length > 0;
    throw new Unsolvable({
      error: 'WallTooThick',
      part,
      at: lowestOf(grid, field.values),
      thickest: thickestThat(fits, wall),
    });
  }
  const cavity = solidOf(library, inside, [id]);
  let outside = body;
  if (opening && node.cut > 0) {
    // What is beyond the rim is taken away as a solid, so that the new faces have an id that is known.
    const around = grown(bounds, step),
      cube = library.Manifold.cube(sidesOf(around)),
      box = cube.translate(around.min),
      half = box.trimByPlane(opening as Point, rim),
      beyond = solidOf(library, surfaceOf(half), [id]);
    outside = body.subtract(beyond);
    own.push(cube, box, half, beyond, outside);
  }
  return { shell: outside.subtract(cavity), cavity };
}

/** Both distances as one, rounded where they are about equal (polynomial smooth minimum). */
function smoothMin(a: number, b: number, radius: number): number {
  const h = Math.max(radius - Math.abs(a - b), 0) / radius;
  return Math.min(a, b) - (h * h * radius) / 4;
}

export interface Seam {
  one: Manifold;
  other: Manifold;
  node: SolidNode;
  /** Original id for new faces that look as most of an operand does. */
  idOf(operand: Manifold): number;
}

/** Two operands, with the distances to both on one grid round a place where they meet, as far as both are near. */
interface Meeting {
  grid: Grid;
  first: Float32Array;
  second: Float32Array;
  near(index: number): boolean;
}

/** Marks the points of a grid that may be as near to a surface as `reach`, by blocks of points. */
function around(
  { min, step, size: [nx, ny, nz] }: Grid,
  { positions: p, triangles }: Surface,
  reach: number,
): Uint8Array {
  const side = 4 * step,
    count = [nx, ny, nz].map((n) => (n + 3) >> 2) as Point,
    blocks = new Uint8Array(count[0] * count[1] * count[2]);
  const low: Point = [0, 0, 0],
    high: Point = [0, 0, 0];
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t]!,
      b = 3 * triangles[t + 1]!,
      c = 3 * triangles[t + 2]!;
    for (let k = 0; k < 3; k += 1) {
      low[k] = Math.max(0, Math.floor((Math.min(p[a + k]!, p[b + k]!, p[c + k]!) - reach - min[k]!) / side));
      high[k] = Math.min(
        count[k]! - 1,
        Math.floor((Math.max(p[a + k]!, p[b + k]!, p[c + k]!) + reach - min[k]!) / side),
      );
    }
    for (let z = low[2]; z <= high[2]; z += 1) {
      for (let y = low[1]; y <= high[1]; y += 1) {
        if (low[0] <= high[0])
          blocks.fill(1, low[0] + count[0] * (y + count[1] * z), high[0] + 1 + count[0] * (y + count[1] * z));
      }
    }
  }
  const marks = new Uint8Array(nx * ny * nz);
  for (let z = 0, i = 0; z < nz; z += 1) {
    for (let y = 0; y < ny; y += 1) {
      for (let x = 0; x < nx; x += 1, i += 1)
        marks[i] = blocks[(x >> 2) + count[0] * ((y >> 2) + count[1] * (z >> 2))]!;
    }
  }
  return marks;
}

function meetingAt(place: Manifold, [a, b]: readonly [Surface, Surface], radius: number, cells: number): Meeting {
  const box = grown(place.boundingBox() as Box, 1.6 * radius),
    reach = Math.fround(1.1 * radius);
  const grid = gridOver(box, affordable(box, radius / cells));
  // Only what is near to both is round.
  const first = new DistanceField(a.positions, a.triangles, grid, reach, around(grid, b, reach)).values;
  const near = first.map((value) => (Math.abs(value) < reach ? 1 : 0));
  const second = new DistanceField(b.positions, b.triangles, grid, reach, Uint8Array.from(near)).values;
  return { grid, first, second, near: (i) => near[i] === 1 && Math.abs(second[i]!) < reach };
}

/**
 * What rounds the seam of two operands of a join or a cut: round every place where they meet, what lies within the
 * smooth minimum of both distances is to be added (join), or what lies within that of the inverse is to be taken away
 * (cut). Each face looks as the operand that it is nearer to. Null where they do not meet.
 */
export function seamOf(library: ManifoldToplevel, { one, other, node, idOf }: Seam, own: Manifold[]): Manifold | null {
  const radius = node.blend,
    cut = node.kind === 'cut',
    cells = node.coarse ? kSeamCells / 2 : kSeamCells,
    shared = one.intersect(other);
  own.push(shared);
  if (shared.isEmpty()) return null;
  const surfaces = [surfaceOf(one), surfaceOf(other)] as const,
    ids = [idOf(one), idOf(other)],
    roundings: Manifold[] = [];
  for (const place of shared.decompose()) {
    own.push(place);
    const { grid, first, second, near } = meetingAt(place, surfaces, radius, cells);
    // A little within, so that only the rounding itself looks out of what is there already.
    const rounding = surfaceWhere(
      grid,
      first.map((d, n) => (near(n) ? -smoothMin(cut ? -d : d, second[n]!, radius) - 0.06 * grid.step : -grid.step)),
    );
    if (rounding.triangles.length === 0) continue;
    const side = (x: number, y: number, z: number) =>
      Math.abs(at(grid, first, x, y, z)) - Math.abs(at(grid, second, x, y, z));
    roundings.push(solidOf(library, cutAlong(rounding, side), ids, (x, y, z) => (side(x, y, z) > 0 ? 1 : 0)));
  }
  if (roundings.length < 2) return roundings[0] ?? null;
  own.push(...roundings);
  return library.Manifold.union(roundings);
}
