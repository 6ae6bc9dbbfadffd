// What the tests of the command line share: running it, pictures made on the spot, reading its files.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { PNG } from 'pngjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
export const program = process.env.SPINELOFT_CLI ?? join(root, 'build/native-release/spineloft');

export { dataFolder } from '../../.ci/lib/paths.mjs';

export const run = (...args) => runProgram(program, args);

export function runProgram(program, args) {
  const { status, signal, stdout, stderr } = spawnSync(program, args, { encoding: 'utf8' });
  assert.equal(signal, null, `ended by ${signal}: ${stderr}`);
  return { status, stdout, stderr };
}

/** Runs and expects success. */
export function works(...args) {
  const done = run(...args);
  assert.equal(done.status, 0, done.stderr);
  assert.equal(done.stderr, '');
  return done;
}

/** Runs and expects this exit code and one sentence on standard error, which is returned. */
export function fails(status, ...args) {
  const done = run(...args);
  assert.equal(done.status, status, `${args.join(' ')}: ${done.stderr}`);
  assert.equal(done.stdout, '');
  assert.match(done.stderr, /^spineloft: [A-Z][^\n]*[^.\n]\.\n$/);
  assert.doesNotMatch(done.stderr.slice('spineloft: '.length, -2), /[a-z)]\. [A-Z]/, 'more than one sentence');
  return done.stderr;
}

/** A folder that is gone after the test. */
export function workFolder(t) {
  const folder = mkdtempSync(join(tmpdir(), 'spineloft-cli-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  return { path: (name) => join(folder, name), list: () => readdirSync(folder).sort(), folder };
}

/** An upright dark bar with round ends on light ground; the stroke runs down its middle. */
export const bar = { width: 240, height: 320, x: 120, radius: 40, top: 80, bottom: 240 };

export function barPng({ width, height, x: centre, radius, top, bottom } = bar) {
  const png = new PNG({ width, height });
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const away = Math.hypot(x - centre, y - Math.min(bottom, Math.max(top, y)));
      const inside = Math.min(1, Math.max(0, radius - away + 0.5));
      const value = Math.round(220 - 160 * inside);
      png.data.set([value, value, Math.min(255, value + 20), 255], 4 * (y * width + x));
    }
  }
  return PNG.sync.write(png);
}

export const barStroke = Array.from({ length: 41 }, (_, i) => [bar.x, bar.top - 20 + 5 * i]);

/** A folder with bar.png and stroke.json. */
export function barFolder(t) {
  const folder = workFolder(t);
  writeFileSync(folder.path('bar.png'), barPng());
  writeFileSync(folder.path('stroke.json'), JSON.stringify(barStroke));
  return folder;
}

/** A case folder of the bar; `mask(x, y)` gives the truth's value. */
export function writeCase(folder, id, changes = {}) {
  mkdirSync(folder.path(id));
  writeFileSync(folder.path(`${id}/image.png`), barPng());
  const mask = new PNG({ width: bar.width, height: bar.height, colorType: 0 });
  for (let y = 0; y < bar.height; y++) {
    for (let x = 0; x < bar.width; x++) {
      const away = Math.hypot(x - bar.x, y - Math.min(bar.bottom, Math.max(bar.top, y)));
      const value = away < bar.radius ? 255 : 0;
      mask.data.set([value, value, value, 255], 4 * (y * bar.width + x));
    }
  }
  writeFileSync(folder.path(`${id}/mask.png`), PNG.sync.write(mask, { colorType: 0 }));
  const axis = Array.from({ length: 49 }, (_, i) => [bar.x, 40 + 5 * i, 80]);
  const text = {
    id,
    category: 'made',
    image: 'image.png',
    mask: 'mask.png',
    boundary_tolerance_px: 1.5,
    axis,
    spines: { careful: barStroke, sloppy: barStroke.map(([x, y], i) => [x + 4 * Math.sin(i / 4), y]) },
    ...changes,
  };
  writeFileSync(folder.path(`${id}/case.json`), JSON.stringify(text));
}

export const readJson = (path) => JSON.parse(readFileSync(path, 'utf8'));
export const readPng = (path) => PNG.sync.read(readFileSync(path));

/** The JSON chunk of a GLB. */
export function glbJson(bytes) {
  assert.equal(bytes.toString('latin1', 0, 4), 'glTF');
  return JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)));
}

/** Least and greatest coordinate of a binary STL along each axis. */
export function stlBounds(bytes) {
  const count = bytes.readUInt32LE(80);
  assert.equal(bytes.length, 84 + 50 * count);
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let triangle = 0; triangle < count; triangle++) {
    for (let i = 0; i < 9; i++) {
      const value = bytes.readFloatLE(84 + 50 * triangle + 12 + 4 * i);
      low[i % 3] = Math.min(low[i % 3], value);
      high[i % 3] = Math.max(high[i % 3], value);
    }
  }
  return { low, high, count };
}

/** Vertices and faces (0-based corners) of an OBJ. */
export function readObj(path) {
  const vertices = [];
  const faces = [];
  for (const line of readFileSync(path, 'utf8').split('\n')) {
    const [kind, ...rest] = line.trim().split(/\s+/);
    if (kind === 'v') vertices.push(rest.slice(0, 3).map(Number));
    if (kind === 'f') faces.push(rest.map((corner) => parseInt(corner, 10) - 1));
  }
  return { vertices, faces };
}

/** Six times the signed volume of a closed triangle mesh. */
export function sixVolumes({ vertices, faces }) {
  let sum = 0;
  for (const [a, b, c] of faces.map((face) => face.map((i) => vertices[i]))) {
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}
