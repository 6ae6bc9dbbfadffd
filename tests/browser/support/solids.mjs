// Solids for tests without a page: the kernel of the worker on manifold-3d, simple parts, and the laws of a solid
// by counting and by rays, independent of the library.
import create from 'manifold-3d';
import { loadShell } from './shell.mjs';

export const shell = await loadShell(`
  export { SolidKernel } from './solids/kernel.ts';
  export { findCrossings } from './solids/crossings.ts';
  export { ringsOf } from './solids/rings.ts';
  export { DistanceField } from './solids/distance.ts';
  export { gridOver, sample, surfaceWhere } from './solids/grid.ts';
  export { Solver } from './solids/solver.ts';
`);
export const library = await create();
library.setup();

export function seeded(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
}

/** A loft as the engine makes it: rings of `around` points along a line that bends by `bend`, closed by hubs. */
export function loft({ rings = 24, around = 16, length = 1, radius = 0.1, bend = 0, wave = 0 } = {}) {
  const positions = [], uv = [], triangles = [];
  const at = (t) => {
    const a = bend * t, r = bend === 0 ? 0 : length / bend;
    return bend === 0 ? { x: length * t, y: 0, across: [0, 1] } : { x: r * Math.sin(a), y: r - r * Math.cos(a), across: [-Math.sin(a), Math.cos(a)] };
  };
  for (let i = 0; i < rings; i += 1) {
    const t = i / (rings - 1), { x, y, across } = at(t), r = radius * (1 + wave * Math.sin(9 * t));
    for (let j = 0; j < around; j += 1) {
      const angle = (2 * Math.PI * j) / around;
      positions.push(x + across[0] * r * Math.cos(angle), y + across[1] * r * Math.cos(angle), -r * Math.sin(angle));
      uv.push(t, j / around);
    }
  }
  for (let i = 0; i + 1 < rings; i += 1) {
    for (let j = 0; j < around; j += 1) {
      const l = (j + 1) % around, [a0, a1, b0, b1] = [i * around + j, i * around + l, (i + 1) * around + j, (i + 1) * around + l];
      triangles.push(a0, b0, b1, a0, b1, a1);
    }
  }
  for (const [ring, t] of [[0, 0], [rings - 1, 1]]) {
    const { x, y } = at(t), hub = positions.length / 3;
    positions.push(x, y, 0);
    uv.push(t, 0.5);
    for (let j = 0; j < around; j += 1) {
      const [a, b] = [ring * around + j, ring * around + ((j + 1) % around)];
      triangles.push(...(ring === 0 ? [hub, a, b] : [a, hub, b]));
    }
  }
  return { positions: new Float32Array(positions), uv: new Float32Array(uv), triangles: new Uint32Array(triangles) };
}

export const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
export const shifted = (x, y = 0, z = 0) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
export const turned = (angle, x = 0, y = 0, z = 0) => [Math.cos(angle), Math.sin(angle), 0, 0, -Math.sin(angle), Math.cos(angle), 0, 0, 0, 0, 1, 0, x, y, z, 1];

let keys = 0;
export const node = (operands, more = {}) => ({ key: `node ${(keys += 1)}`, step: 1, kind: 'join', operands, blend: 0, wall: 0.02, opening: null, cut: 0, coarse: false, ...more });

/** Solves the last of the nodes; the meshes are those that its parts name. */
export function solve(kernel, nodes, meshes = {}) {
  const solved = [];
  const work = kernel.solve({ id: 1, nodes, wanted: [nodes.at(-1).key], meshes }, (each) => solved.push(each));
  while (!work.next().done);
  return solved[0];
}

/** Volume, genus and what breaks the law that a solid is closed and outward, by counting. */
export function measure({ positions, triangles, mergeFrom, mergeTo }) {
  const place = Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  mergeFrom.forEach((from, i) => { place[from] = mergeTo[i]; });
  const find = (v) => (place[v] === v ? v : find(place[v]));
  const edges = new Map(), used = new Set();
  let volume = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [0, 1, 2].map((k) => find(triangles[t + k]));
    corners.forEach((a, k) => {
      used.add(a);
      const b = corners[(k + 1) % 3], key = `${a} ${b}`;
      edges.set(key, (edges.get(key) ?? 0) + 1);
    });
    const [a, b, c] = corners.map((v) => positions.subarray(3 * v, 3 * v + 3));
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }
  let open = 0;
  for (const [key, count] of edges) {
    const [a, b] = key.split(' ');
    if (edges.get(`${b} ${a}`) !== count) open += 1;
  }
  const euler = used.size - edges.size / 2 + triangles.length / 3;
  return { volume, open, euler, shells: shellsOf([...edges.keys()].map((key) => key.split(' '))), finite: positions.every(Number.isFinite) };
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
