// What is in the model files that the page saves, read without the programs that wrote them.
import assert from 'node:assert/strict';
import { validateBytes } from 'gltf-validator';
import { strFromU8, unzipSync } from 'three/addons/libs/fflate.module.js';

/** Edges that are not run through as often one way as the other, corners at one place being one. */
function openEdges(triangles) {
  const balance = new Map();
  for (const corners of triangles) {
    corners.forEach((point, k) => {
      const from = point.join(' '),
        to = corners[(k + 1) % 3].join(' ');
      if (from === to) return;
      const key = from < to ? `${from}, ${to}` : `${to}, ${from}`;
      balance.set(key, (balance.get(key) ?? 0) + (from < to ? 1 : -1));
    });
  }
  return [...balance.values()].filter((value) => value !== 0).length;
}

/** Edges that more or fewer than two faces have, and faces without three corners, corners at one place being one. */
function unsoundOf(triangles) {
  const faces = new Map();
  let flat = 0;
  for (const corners of triangles) {
    const keys = corners.map((point) => point.join(' '));
    if (new Set(keys).size < 3) flat += 1;
    keys.forEach((from, k) => {
      const to = keys[(k + 1) % 3],
        key = from < to ? `${from}, ${to}` : `${to}, ${from}`;
      faces.set(key, (faces.get(key) ?? 0) + 1);
    });
  }
  return flat + [...faces.values()].filter((count) => count !== 2).length;
}

/** How many pieces there are, corners at one place being one. */
function piecesOf(triangles) {
  const root = new Map();
  const find = (key) => {
    while (root.get(key) !== key) key = root.get(key);
    return key;
  };
  for (const corners of triangles) {
    const [first, ...others] = corners.map((point) => point.join(' '));
    if (!root.has(first)) root.set(first, first);
    const top = find(first);
    for (const other of others) root.set(root.has(other) ? find(other) : other, top);
  }
  return [...root].filter(([key, up]) => key === up).length;
}

/** Signed volume, sides of the box, open edges, edges and faces that programs stumble over, and pieces of the triangles of an OBJ or STL. */
export function measure(triangles) {
  let volume = 0;
  const low = [Infinity, Infinity, Infinity],
    high = [-Infinity, -Infinity, -Infinity];
  for (const [a, b, c] of triangles) {
    volume +=
      (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) /
      6;
    for (const point of [a, b, c]) {
      for (let k = 0; k < 3; ++k) {
        low[k] = Math.min(low[k], point[k]);
        high[k] = Math.max(high[k], point[k]);
      }
    }
  }
  return {
    volume,
    open: openEdges(triangles),
    unsound: unsoundOf(triangles),
    pieces: piecesOf(triangles),
    size: high.map((value, k) => value - low[k]),
    triangles: triangles.length,
  };
}

/** Of every object of a 3MF its triangles, with corners by number: that is what slicers go by. */
export function parse3mf(bytes) {
  const xml = strFromU8(unzipSync(new Uint8Array(bytes))['3D/3dmodel.model']);
  return [...xml.matchAll(/<mesh>(.*?)<\/mesh>/gs)].map(([, mesh]) =>
    [...mesh.matchAll(/<triangle v1="(\d+)" v2="(\d+)" v3="(\d+)"/g)].map(([, ...corners]) =>
      corners.map((v) => [Number(v), 0, 0]),
    ),
  );
}

export function parseObj(bytes) {
  const vertices = [],
    triangles = [];
  for (const line of bytes.toString('utf8').split('\n')) {
    const [key, ...values] = line.trim().split(/\s+/);
    if (key === 'v') vertices.push(values.slice(0, 3).map(Number));
    if (key === 'f') {
      assert.equal(values.length, 3);
      triangles.push(values.map((value) => vertices[Number.parseInt(value, 10) - 1]));
    }
  }
  return triangles;
}

export function parseStl(bytes) {
  const count = bytes.readUInt32LE(80);
  assert.equal(bytes.length, 84 + 50 * count);
  const point = (at) => [bytes.readFloatLE(at), bytes.readFloatLE(at + 4), bytes.readFloatLE(at + 8)];
  return Array.from({ length: count }, (_, i) => [0, 1, 2].map((k) => point(84 + 50 * i + 12 + 12 * k)));
}

/** What a GLB is, when the Khronos validator has neither errors nor warnings. */
export async function validated(bytes) {
  const report = await validateBytes(new Uint8Array(bytes), { maxIssues: 20 });
  assert.deepEqual(
    report.issues.messages.filter(({ severity }) => severity <= 1),
    [],
  );
  return report.info;
}
