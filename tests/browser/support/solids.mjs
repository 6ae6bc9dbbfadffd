// Solids for tests without a page: the kernel of the worker on manifold-3d, simple parts, and the laws of a solid
// by counting and by rays, independent of the library.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import create from 'manifold-3d';
import { selfCrossingFile } from '../../../.ci/lib/site.mjs';
import { seeded } from '../../support/random.mjs';
import { identity, loft, shifted, turned } from './lofts.mjs';
import { loadShell } from './shell.mjs';

export { identity, loft, seeded, shifted, turned };

export const shell = await loadShell(`
  export { SolidKernel } from './solids/kernel.ts';
  export { Near } from './solids/near.ts';
  export { loadSelfCrossing } from './solids/self_crossing.ts';
  export { ringsOf } from './solids/rings.ts';
  export { DistanceField } from './solids/distance.ts';
  export { gridOver, sample, surfaceWhere } from './solids/grid.ts';
  export { meshesAt } from './engine_workers.ts';
  export { Solver } from './solids/solver.ts';
  export { countOf } from './solids/topology.ts';
  export { isSolidLikely } from './warm_up.ts';
`);
export const library = await create();
library.setup();
assert.ok(existsSync(selfCrossingFile), `${selfCrossingFile} is not built: npm run build makes it`);
export const selfCrossing = await shell.loadSelfCrossing(readFileSync(selfCrossingFile));

let keys = 0;
export const node = (operands, more = {}) => ({
  key: `node ${(keys += 1)}`,
  step: 1,
  kind: 'join',
  operands,
  blend: 0,
  wall: 0.02,
  opening: null,
  cut: 0,
  coarse: false,
  ...more,
});

/** Solves the last of the nodes; the meshes are those that its parts name. */
export function solve(kernel, nodes, meshes = {}) {
  const solved = [];
  const work = kernel.solve({ id: 1, nodes, wanted: [nodes.at(-1).key], meshes }, (each) => solved.push(each));
  while (!work.next().done);
  return solved[0];
}

/** The corners of the triangles, vertices of one place as one vertex. */
export function merged({ triangles, mergeFrom, mergeTo }, vertices) {
  const place = Uint32Array.from({ length: vertices }, (_, i) => i);
  mergeFrom.forEach((from, i) => {
    place[from] = mergeTo[i];
  });
  const find = (v) => (place[v] === v ? v : find(place[v]));
  return triangles.map(find);
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** How far triangles, three points each, must be shifted to part them; 0: they are apart. From the hull of all their differences. */
export function depthOf(one, other) {
  const size = Math.max(...[...one, ...other].flatMap((p) => minus(p, one[0]).map(Math.abs)));
  if (size === 0) return 0;
  const hull = library.Manifold.hull(one.flatMap((a) => other.map((b) => minus(a, b).map((x) => x / size))));
  const { vertProperties: p, triVerts } = hull.getMesh();
  hull.delete();
  let depth = Infinity;
  for (let t = 0; t < triVerts.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => p.subarray(3 * triVerts[t + k], 3 * triVerts[t + k] + 3));
    const normal = cross(minus(b, a), minus(c, a)),
      length = Math.hypot(...normal);
    if (length > 1e-9) depth = Math.min(depth, dot(normal, a) / length);
  }
  // What has no faces is flat.
  return Number.isFinite(depth) ? Math.max(0, depth) * size : 0;
}

/** Pairs of triangles that may cross, three points each, with how deep: by trying every pair that is not surely apart. */
export function* crossingPairs(positions, triangles) {
  const at = (v) => [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
  const all = Array.from({ length: triangles.length / 3 }, (_, t) => {
    const ids = [...triangles.subarray(3 * t, 3 * t + 3)],
      points = ids.map(at);
    return {
      ids,
      points,
      low: [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k]))),
      high: [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k]))),
    };
  }).sort((a, b) => a.low[0] - b.low[0]);
  const volume = (a, b, c, d) => {
    const x = d[0] - a[0],
      y = d[1] - a[1],
      z = d[2] - a[2],
      ux = b[0] - a[0],
      uy = b[1] - a[1],
      uz = b[2] - a[2],
      vx = c[0] - a[0],
      vy = c[1] - a[1],
      vz = c[2] - a[2];
    return x * (uy * vz - uz * vy) + y * (uz * vx - ux * vz) + z * (ux * vy - uy * vx);
  };
  /** An edge goes through a triangle, or it may with another rounding. */
  const mayPierce = ([a, b, c], d, e) => {
    if (volume(a, b, c, d) * volume(a, b, c, e) > 0) return false;
    const x = volume(d, e, a, b),
      y = volume(d, e, b, c),
      z = volume(d, e, c, a);
    return (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
  };
  /** Any edge of one without a corner of the other does. */
  const edgesMayPierce = (one, other) =>
    [0, 1, 2].some((k) => {
      const l = (k + 1) % 3;
      return (
        !other.ids.includes(one.ids[k]) &&
        !other.ids.includes(one.ids[l]) &&
        mayPierce(other.points, one.points[k], one.points[l])
      );
    });
  for (let i = 0; i < all.length; i += 1) {
    for (let j = i + 1; j < all.length && all[j].low[0] <= all[i].high[0]; j += 1) {
      const s = all[i],
        t = all[j];
      if (s.low[1] > t.high[1] || t.low[1] > s.high[1] || s.low[2] > t.high[2] || t.low[2] > s.high[2]) continue;
      if (s.ids.filter((v) => t.ids.includes(v)).length > 1) continue;
      if (edgesMayPierce(s, t) || edgesMayPierce(t, s))
        yield { points: [...s.points, ...t.points], depth: depthOf(s.points, t.points) };
    }
  }
}

/** The depth of the deepest crossing of a mesh. */
export function deepest(positions, triangles) {
  let most = 0;
  for (const { depth } of crossingPairs(positions, triangles)) most = Math.max(most, depth);
  return most;
}

/** The diagonal of the box round all points. */
export function diagonal(positions) {
  const low = [Infinity, Infinity, Infinity],
    high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  return Math.hypot(...minus(high, low));
}

/** Volume, genus and what breaks the law that a solid is closed and outward, by counting. */
export function measure({ positions, triangles, mergeFrom = [], mergeTo = [] }) {
  const together = merged({ triangles, mergeFrom, mergeTo }, positions.length / 3);
  const edges = new Map(),
    used = new Set();
  let volume = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [...together.subarray(t, t + 3)];
    corners.forEach((a, k) => {
      used.add(a);
      const b = corners[(k + 1) % 3],
        key = `${a} ${b}`;
      edges.set(key, (edges.get(key) ?? 0) + 1);
    });
    const [a, b, c] = corners.map((v) => positions.subarray(3 * v, 3 * v + 3));
    volume +=
      (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) /
      6;
  }
  let open = 0;
  for (const [key, count] of edges) {
    const [a, b] = key.split(' ');
    if (edges.get(`${b} ${a}`) !== count) open += 1;
  }
  const euler = used.size - edges.size / 2 + triangles.length / 3;
  return {
    volume,
    open,
    euler,
    shells: shellsOf([...edges.keys()].map((key) => key.split(' '))),
    finite: positions.every(Number.isFinite),
  };
}

/** Edges that more or fewer than two faces have, and faces without three corners, when corners at one place are one. */
export function unsoundByPlace({ positions, triangles }) {
  const numbers = new Map(),
    faces = new Map();
  const numberOf = (v) => {
    const key = positions.subarray(3 * v, 3 * v + 3).join(' ');
    if (!numbers.has(key)) numbers.set(key, numbers.size);
    return numbers.get(key);
  };
  let flat = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [0, 1, 2].map((k) => numberOf(triangles[t + k]));
    if (new Set(corners).size < 3) flat += 1;
    corners.forEach((a, k) => {
      const b = corners[(k + 1) % 3],
        key = a < b ? `${a} ${b}` : `${b} ${a}`;
      faces.set(key, (faces.get(key) ?? 0) + 1);
    });
  }
  return flat + [...faces.values()].filter((count) => count !== 2).length;
}

/** How many pieces the edges fall into: walked through one after the other. */
function shellsOf(edges) {
  const beside = new Map();
  for (const [a, b] of edges) {
    beside.set(a, [...(beside.get(a) ?? []), b]);
  }
  let shells = 0;
  while (beside.size) {
    shells += 1;
    const open = [beside.keys().next().value];
    while (open.length) {
      const at = open.pop();
      for (const next of beside.get(at) ?? []) open.push(next);
      beside.delete(at);
    }
  }
  return shells;
}

/** A solver; on a library that does some things otherwise, where one is given. */
export const fresh = (overrides = {}) => {
  const Manifold = Object.assign(Object.create(library.Manifold), overrides);
  return new shell.SolidKernel({ ...library, Manifold }, selfCrossing);
};

/** Counts what the library is asked for, and which of its solids live, while `work` runs. */
export function counted(work) {
  const living = new Set(),
    asked = { parts: 0, intersections: 0, decompositions: 0 },
    { Manifold } = library,
    { ofMesh } = Manifold,
    kind = Object.getPrototypeOf(Manifold.cube()),
    { delete: end, decompose, intersect } = kind;
  Manifold.ofMesh = (mesh) => {
    const solid = ofMesh(mesh);
    asked.parts += 1;
    living.add(solid);
    return solid;
  };
  Object.assign(kind, {
    decompose() {
      asked.decompositions += 1;
      return decompose.call(this);
    },
    intersect(other) {
      asked.intersections += 1;
      return intersect.call(this, other);
    },
    delete() {
      living.delete(this);
      end.call(this);
    },
  });
  try {
    return work({ asked, living });
  } finally {
    Manifold.ofMesh = ofMesh;
    Object.assign(kind, { delete: end, decompose, intersect });
  }
}

export const near = (actual, wanted, share, what) =>
  assert.ok(Math.abs(actual - wanted) <= share * Math.abs(wanted), `${what}: ${actual} is not ${wanted}`);

/** What every solid is held to; its measures by counting. */
export function lawful(solved, what) {
  assert.equal(solved.failure, undefined, `${what}: ${JSON.stringify(solved.failure)}`);
  const { mesh } = solved,
    found = measure(mesh);
  assert.equal(found.open, 0, `${what} is closed`);
  assert.ok(found.finite && found.volume > 0, `${what} is finite and outward`);
  near(found.volume, mesh.volume, 1e-3, `${what}: volume as counted`);
  assert.equal(
    mesh.runs.reduce((sum, run) => sum + run.count, 0),
    mesh.triangles.length / 3,
    `${what}: every face has an owner`,
  );
  assert.ok(
    mesh.uv.every((value) => value >= 0 && value <= 1),
    `${what}: uv in range`,
  );
  const triangles = merged(mesh, mesh.positions.length / 3);
  assert.equal(selfCrossing({ positions: mesh.positions, triangles }), null, `${what} does not cross itself`);
  return found;
}

/** A part of the mesh `rod` as an operand. */
export const rod = (part, matrix = identity, mesh = 'rod') => ({ mesh, part, matrix });
