// An edit of a part changes nothing away from it. So what the other parts make is cut down beforehand to what is near
// the part, an edit unites the part with that alone, and all that is away is put back face by face: where it was cut,
// whole faces stand again, as if it had never been.
import type { Manifold, ManifoldToplevel, Mesh, Vec3 } from 'manifold-3d';
import type { Faces } from './flaps.ts';
import { mapped } from './affine.ts';
import { isWithin, roomOf } from './room.ts';
import type { Room, Shape } from './room.ts';

/** Cut down to more than this share, it is not quicker. */
const kWorthwhile = 0.6;

/** Marks the faces that reach into a room, and makes it as large as these are. */
function takeNear(vertProperties: Float32Array, triVerts: Uint32Array, room: Room, near: Uint8Array): Room {
  const places = mapped(vertProperties, room.into),
    { low, high } = room,
    all = { low: [...low] as Vec3, high: [...high] as Vec3 };
  for (let t = 0; t < near.length; t += 1) {
    const a = 3 * triVerts[3 * t]!,
      b = 3 * triVerts[3 * t + 1]!,
      c = 3 * triVerts[3 * t + 2]!;
    let apart = false;
    for (let k = 0; k < 3 && !apart; k += 1) {
      const p = places[a + k]!,
        q = places[b + k]!,
        r = places[c + k]!;
      apart = Math.min(p, q, r) > high[k]! || Math.max(p, q, r) < low[k]!;
    }
    if (apart) continue;
    near[t] = 1;
    for (const v of [a, b, c]) {
      for (let k = 0; k < 3; k += 1) {
        all.low[k] = Math.min(all.low[k]!, places[v + k]!);
        all.high[k] = Math.max(all.high[k]!, places[v + k]!);
      }
    }
  }
  // Its sides go through no corner of these.
  const more = 1e-3 * Math.max(...high.map((x, k) => x - low[k]!));
  return { ...room, low: all.low.map((x) => x - more) as Vec3, high: all.high.map((x) => x + more) as Vec3 };
}

/** Directed edges of faces whose other side is not among them; the faces are chosen from a closed mesh. */
function rimOf(triangles: Uint32Array, isChosen: (face: number) => boolean, vertices: number): Set<number> {
  const rim = new Set<number>();
  for (let t = 0; t < triangles.length; t += 3) {
    if (!isChosen(t / 3)) continue;
    for (let k = 0; k < 3; k += 1) {
      const a = triangles[t + k]!,
        b = triangles[t + ((k + 1) % 3)]!;
      if (!rim.delete(b * vertices + a)) rim.add(a * vertices + b);
    }
  }
  return rim;
}

const placeAt = (positions: Float32Array, v: number) =>
  `${positions[3 * v]} ${positions[3 * v + 1]} ${positions[3 * v + 2]}`;

/** What is away: it stays as it is. */
interface Away {
  positions: Float32Array;
  /** By run of the mesh that all was. */
  corners: Uint32Array[];
  faces: Uint32Array[];
  /** Edges to what is near, first · vertices + second, and their corners by place. */
  rim: Set<number>;
  corner: Map<string, number>;
}

/** Null when two corners at the rim are at one place. */
function awayOf(
  { vertProperties, triVerts, runIndex, faceID }: Pick<Mesh, 'vertProperties' | 'triVerts' | 'runIndex' | 'faceID'>,
  near: Uint8Array,
): Away | null {
  const number = new Int32Array(vertProperties.length / 3).fill(-1),
    kept: number[] = [],
    corners: Uint32Array[] = [],
    faces: Uint32Array[] = [];
  for (let run = 0; run + 1 < runIndex.length; run += 1) {
    const triangles: number[] = [],
      ids: number[] = [];
    for (let t = runIndex[run]! / 3; t < runIndex[run + 1]! / 3; t += 1) {
      if (near[t]) continue;
      ids.push(faceID[t]!);
      for (const v of triVerts.subarray(3 * t, 3 * t + 3)) {
        if (number[v]! < 0) number[v] = kept.push(v) - 1;
        triangles.push(number[v]!);
      }
    }
    corners.push(Uint32Array.from(triangles));
    faces.push(Uint32Array.from(ids));
  }
  const positions = new Float32Array(3 * kept.length);
  for (const [i, v] of kept.entries()) positions.set(vertProperties.subarray(3 * v, 3 * v + 3), 3 * i);
  const vertices = number.length,
    rim = new Set<number>(),
    corner = new Map<string, number>(),
    onRim = new Set<number>();
  for (const edge of rimOf(triVerts, (face) => near[face] === 0, vertices)) {
    const a = number[Math.floor(edge / vertices)]!,
      b = number[edge % vertices]!;
    rim.add(a * kept.length + b);
    onRim.add(a).add(b);
  }
  for (const v of onRim) corner.set(placeAt(positions, v), v);
  return corner.size === onRim.size ? { positions, corners, faces, rim, corner } : null;
}

const isAnywhereIn = (rooms: Room[], shape: Shape) => rooms.some((room) => isWithin(room, shape));

/** The rooms as one solid; what is made on the way, and it, go into `own`. */
function cutter(library: ManifoldToplevel, rooms: Room[], own: Manifold[]): Manifold {
  const made = (solid: Manifold) => {
    own.push(solid);
    return solid;
  };
  const boxes = rooms.map(({ out, low, high }) =>
    made(made(made(library.Manifold.cube(high.map((x, k) => x - low[k]!) as Vec3)).translate(low)).transform(out)),
  );
  return boxes.length > 1 ? made(library.Manifold.union(boxes)) : boxes[0]!;
}

/** What is near some parts of what others make, ready for their edits. */
export class Near {
  private constructor(
    /** That alone, closed where it was cut. */
    readonly solid: Manifold,
    private readonly rooms: Room[],
    /** All of it, before. */
    private readonly whole: Pick<Mesh, 'runIndex' | 'runOriginalID' | 'runTransform' | 'faceID'>,
    private readonly isNear: Uint8Array,
    private readonly away: Away,
    /** Original id of its faces, whose numbers are those of `whole`; all others are of the sides where it was cut. */
    private readonly id: number,
    private readonly sides: ReadonlySet<number>,
  ) {}

  /** What is near these shapes, a piece at a time; null where that is not worth it or cannot be had. */
  static *of(library: ManifoldToplevel, rest: Manifold, shapes: Shape[]): Generator<void, Near | null> {
    const rooms: Room[] = [];
    for (const shape of shapes) {
      const room = isAnywhereIn(rooms, shape) ? null : roomOf(shape);
      if (room) rooms.push(room);
      else if (!isAnywhereIn(rooms, shape)) return null;
    }
    if (rooms.length === 0) return null;
    const { vertProperties, triVerts, runIndex, runOriginalID, runTransform, faceID } = rest.getMesh(),
      isNear = new Uint8Array(faceID.length);
    const boxes = rooms.map((room) => takeNear(vertProperties, triVerts, room, isNear)),
      count = isNear.reduce((sum, each) => sum + each, 0);
    const away =
      count > kWorthwhile * isNear.length ? null : awayOf({ vertProperties, triVerts, runIndex, faceID }, isNear);
    if (!away) return null;
    yield;
    const own: Manifold[] = [],
      id = library.Manifold.reserveIDs(1);
    try {
      const mesh = new library.Mesh({
        numProp: 3,
        vertProperties,
        triVerts,
        runOriginalID: Uint32Array.of(id),
        runIndex: Uint32Array.of(0, triVerts.length),
        faceID: faceID.map((_, f) => f),
      });
      const all = library.Manifold.ofMesh(mesh);
      own.push(all);
      all.status();
      yield;
      const solid = all.intersect(cutter(library, boxes, own));
      if (solid.status() === 'NoError' && solid.numTri() <= kWorthwhile * isNear.length) {
        const sides = new Set(solid.getMesh().runOriginalID);
        sides.delete(id);
        return new Near(solid, rooms, { runIndex, runOriginalID, runTransform, faceID }, isNear, away, id, sides);
      }
      solid.delete();
      return null;
    } finally {
      for (const each of own) each.delete();
    }
  }

  /** Whether these shapes, as they are now, touch nothing that is away. */
  holds(shapes: Shape[]): boolean {
    return shapes.every((shape) => isAnywhereIn(this.rooms, shape));
  }

  /** What shapes in their rooms have made of what is near, with all that is away. Null where these do not fit together. */
  withAway(made: Mesh): Faces | null {
    const { away, id } = this,
      { vertProperties, triVerts, runOriginalID } = made;
    const isGone = this.goneFrom(made),
      number = this.joint(made, isGone);
    if (!number) return null;
    const added: number[] = [],
      kept = away.positions.length / 3;
    for (let c = 0; c < triVerts.length; c += 1) {
      const v = triVerts[c]!;
      if (isGone[(c / 3) | 0] || number[v]! >= 0) continue;
      number[v] = kept + added.push(v) - 1;
    }
    const positions = new Float32Array(away.positions.length + 3 * added.length);
    positions.set(away.positions);
    for (const [i, v] of added.entries()) positions.set(vertProperties.subarray(3 * v, 3 * v + 3), 3 * (kept + i));
    const others = [...runOriginalID.keys()].filter(
      (run) => runOriginalID[run] !== id && !this.sides.has(runOriginalID[run]!),
    );
    return { vertProperties: positions, ...this.facesWith(made, others, (t) => isGone[t] === 0, number) };
  }

  /** Faces that go again: the sides where it was cut, and those that these cut. */
  private goneFrom({ runIndex, runOriginalID, faceID }: Mesh): Uint8Array {
    const isGone = new Uint8Array(faceID.length);
    for (const [run, original] of runOriginalID.entries()) {
      const first = runIndex[run]! / 3,
        end = runIndex[run + 1]! / 3;
      if (this.sides.has(original)) isGone.fill(1, first, end);
      else if (original === this.id) for (let t = first; t < end; t += 1) isGone[t] = 1 - this.isNear[faceID[t]!]!;
    }
    return isGone;
  }

  /** For corners at the rim their numbers among what is away, for all others −1. Null where the two rims are not one. */
  private joint({ vertProperties, triVerts }: Mesh, isGone: Uint8Array): Int32Array | null {
    const { away } = this,
      vertices = vertProperties.length / 3,
      number = new Int32Array(vertices).fill(-1),
      rim = rimOf(triVerts, (face) => isGone[face] === 1, vertices);
    const taken = new Set<number>(),
      numberOf = (v: number) => {
        if (number[v]! < 0) {
          const at = away.corner.get(placeAt(vertProperties, v)) ?? -1;
          if (at < 0 || taken.has(at)) return -1;
          taken.add(at);
          number[v] = at;
        }
        return number[v]!;
      };
    if (rim.size !== away.rim.size) return null;
    for (const edge of rim) {
      const a = numberOf(Math.floor(edge / vertices)),
        b = numberOf(edge % vertices);
      if (a < 0 || b < 0 || !away.rim.has((a * away.positions.length) / 3 + b)) return null;
    }
    return number;
  }

  /** All faces: run by run what is away and what is kept of what is near, then those of the parts. */
  private facesWith(
    made: Mesh,
    others: number[],
    isKept: (t: number) => boolean,
    number: Int32Array,
  ): Omit<Faces, 'vertProperties'> {
    const { away, whole } = this,
      runs = whole.runOriginalID.length,
      near: number[][] = Array.from({ length: runs }, () => []);
    const ownRun = made.runOriginalID.indexOf(this.id);
    if (ownRun >= 0) {
      // Their faces are in the order of the library.
      const runOf = (face: number) => {
        let run = 0;
        while (whole.runIndex[run + 1]! <= 3 * face) run += 1;
        return run;
      };
      for (let t = made.runIndex[ownRun]! / 3; t < made.runIndex[ownRun + 1]! / 3; t += 1)
        if (isKept(t)) near[runOf(made.faceID[t]!)]!.push(t);
    }
    const count =
      [...away.faces, ...near].reduce((sum, each) => sum + each.length, 0) +
      others.reduce((sum, run) => sum + (made.runIndex[run + 1]! - made.runIndex[run]!) / 3, 0);
    const triVerts = new Uint32Array(3 * count),
      faceID = new Uint32Array(count),
      runIndex = new Uint32Array(runs + others.length + 1);
    let at = 0;
    const add = (t: number, face: number) => {
      for (let k = 0; k < 3; k += 1) triVerts[3 * at + k] = number[made.triVerts[3 * t + k]!]!;
      faceID[at] = face;
      at += 1;
    };
    for (let run = 0; run < runs; run += 1) {
      runIndex[run] = 3 * at;
      triVerts.set(away.corners[run]!, 3 * at);
      faceID.set(away.faces[run]!, at);
      at += away.faces[run]!.length;
      for (const t of near[run]!) add(t, whole.faceID[made.faceID[t]!]!);
    }
    for (const [i, run] of others.entries()) {
      runIndex[runs + i] = 3 * at;
      for (let t = made.runIndex[run]! / 3; t < made.runIndex[run + 1]! / 3; t += 1) add(t, made.faceID[t]!);
    }
    runIndex[runs + others.length] = 3 * at;
    const runTransform = Float32Array.from([
      ...whole.runTransform,
      ...others.flatMap((run) => [...made.runTransform.subarray(12 * run, 12 * run + 12)]),
    ]);
    return {
      triVerts,
      faceID,
      runIndex,
      runOriginalID: Uint32Array.from([...whole.runOriginalID, ...others.map((run) => made.runOriginalID[run]!)]),
      runTransform,
    };
  }
}
