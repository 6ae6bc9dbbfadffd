// Walls without thickness: where surfaces all but touch, places that the library tells apart become one as floats, and
// two triangles lie back to back on the same three places. Programs that join corners by place find edges of four
// faces there, so both go.
import type { Mesh } from 'manifold-3d';
import { countOf } from './topology.ts';

/** As much of the library's mesh as faces are. */
export type Faces = Pick<
  Mesh,
  'vertProperties' | 'triVerts' | 'runIndex' | 'runOriginalID' | 'runTransform' | 'faceID'
>;

/** For every vertex the first one at its place; null when all are at places of their own. */
export function placesOf(positions: Float32Array): Uint32Array | null {
  const count = positions.length / 3;
  let size = 16;
  while (size < 2 * count) size *= 2;
  // By the bits of the numbers; 0 and -0 are one place.
  const plain = positions.map((x) => x + 0),
    bits = new Int32Array(plain.buffer);
  const slots = new Uint32Array(size),
    places = new Uint32Array(count);
  let shared = false;
  for (let v = 0; v < count; v += 1) {
    const x = bits[3 * v]!,
      y = bits[3 * v + 1]!,
      z = bits[3 * v + 2]!;
    let hash = Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca6b) ^ Math.imul(z, 0xc2b2ae35);
    hash ^= hash >>> 15;
    let at = hash & (size - 1);
    // A slot holds a vertex and one.
    for (; slots[at] !== 0; at = (at + 1) & (size - 1)) {
      const other = 3 * (slots[at]! - 1);
      if (bits[other] === x && bits[other + 1] === y && bits[other + 2] === z) break;
    }
    if (slots[at] === 0) slots[at] = v + 1;
    places[v] = slots[at]! - 1;
    shared ||= places[v] !== v;
  }
  return shared ? places : null;
}

/** Triangles side by side that lie back to back on the same places. */
function flapsOf(triangles: Uint32Array, places: Uint32Array): Set<number> {
  const found = new Set<number>(),
    shared = new Uint8Array(places.length),
    open = new Map<string, number>();
  places.forEach((place, v) => {
    if (place !== v) shared[place] = shared[v] = 1;
  });
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k += 1) {
      const v = triangles[t + k]!,
        a = triangles[t + ((k + 1) % 3)]!,
        b = triangles[t + ((k + 2) % 3)]!;
      if (!shared[v]) continue;
      // The other one has the same edge the other way round, and a third corner at the same place.
      const other = open.get(`${places[v]} ${b} ${a}`);
      if (other === undefined) {
        open.set(`${places[v]} ${a} ${b}`, t / 3);
      } else if (!found.has(other) && !found.has(t / 3) && places[a] !== places[b]) {
        found.add(t / 3).add(other);
      }
    }
  }
  return found;
}

/** Some of the faces, each of the run that it was of; `corner` may put another vertex in the place of one. */
export function facesWhere(
  { vertProperties, triVerts, runIndex, runOriginalID, runTransform, faceID }: Faces,
  isKept: (face: number) => boolean,
  corner: (vertex: number) => number = (v) => v,
): Faces {
  const index = new Uint32Array(runIndex.length),
    corners: number[] = [],
    ids: number[] = [];
  for (let run = 0; run < runOriginalID.length; run += 1) {
    index[run] = corners.length;
    for (let t = runIndex[run]! / 3; t < runIndex[run + 1]! / 3; t += 1) {
      if (!isKept(t)) continue;
      for (let k = 0; k < 3; k += 1) corners.push(corner(triVerts[3 * t + k]!));
      ids.push(faceID[t]!);
    }
  }
  index[runOriginalID.length] = corners.length;
  return {
    vertProperties,
    triVerts: Uint32Array.from(corners),
    runIndex: index,
    runOriginalID,
    runTransform,
    faceID: Uint32Array.from(ids),
  };
}

/** The same solid without such walls where it hangs together as before; vertices whose triangles went are one where they were two at one place. */
export function withoutFlaps(mesh: Faces): Faces {
  const places = placesOf(mesh.vertProperties),
    flaps = places ? flapsOf(mesh.triVerts, places) : new Set<number>();
  if (!places || flaps.size === 0) return mesh;
  const joined = Uint32Array.from({ length: places.length }, (_, v) => v);
  for (const t of flaps) for (const v of mesh.triVerts.subarray(3 * t, 3 * t + 3)) joined[v] = places[v]!;
  const some = facesWhere(
    mesh,
    (t) => !flaps.has(t),
    (v) => joined[v]!,
  );
  const before = countOf(places.length, mesh.triVerts),
    after = countOf(places.length, some.triVerts);
  return before.pieces === after.pieces && before.handles === after.handles ? some : mesh;
}
