// Other people's programs read what we write: three.js always, admesh, PrusaSlicer and Blender where they are installed.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { Box3, Mesh, Vector3 } from 'three';
import { unzipSync } from 'three/addons/libs/fflate.module.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { barFolder, works } from '../support/cli.mjs';

const kHeight = 40;

/** Why a test cannot run here, or false. */
function missing(name) {
  const found = spawnSync('sh', ['-c', `command -v ${name}`]).status === 0;
  return found ? false : `${name} is not installed (apt-get install ${name})`;
}

/** What a reader says of a file, on both of its outputs. */
function said(name, ...args) {
  const { status, stdout, stderr, error } = spawnSync(name, args, { encoding: 'utf8', timeout: 300_000, maxBuffer: 1 << 26 });
  assert.equal(error, undefined);
  assert.equal(status, 0, `${name}: ${stdout.slice(-1500)}${stderr.slice(-1500)}`);
  return stdout + stderr;
}

/** A bar of 40 mm as a file of this ending; its path. */
function saved(folder, ending) {
  const path = folder.path(`bar.${ending}`);
  works('loft', folder.path('bar.png'), '--stroke', folder.path('stroke.json'), '--height-mm', String(kHeight), '--out', path);
  return path;
}

const number = (text, pattern) => Number(text.match(pattern)?.[1]);
const isHeight = (value, where) => assert.ok(Math.abs(value - kHeight) <= 0.01, `${where}: ${value} mm`);

/** Of three's objects: the size, the number of triangles and the signed volume. */
function measured(object) {
  const size = new Box3().setFromObject(object, true).getSize(new Vector3());
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  let triangles = 0, volume = 0;
  object.traverse(({ geometry }) => {
    if (!geometry) return;
    const { position } = (geometry.index ? geometry.toNonIndexed() : geometry).attributes;
    for (let i = 0; i < position.count; i += 3, ++triangles) {
      a.fromBufferAttribute(position, i);
      b.fromBufferAttribute(position, i + 1);
      c.fromBufferAttribute(position, i + 2);
      volume += a.dot(b.cross(c)) / 6;
    }
  });
  return { size, triangles, volume };
}

test('three.js reads an OBJ and an STL as the same solid, as tall as it was asked for', (t) => {
  const folder = barFolder(t);
  const files = unzipSync(new Uint8Array(readFileSync(saved(folder, 'zip'))));
  const name = Object.keys(files).find((file) => file.endsWith('.obj'));
  const obj = measured(new OBJLoader().parse(Buffer.from(files[name]).toString('utf8')));
  const stl = new STLLoader().parse(new Uint8Array(readFileSync(saved(folder, 'stl'))).buffer);
  const solid = measured(new Mesh(stl));
  isHeight(obj.size.y, 'OBJ');
  isHeight(solid.size.z, 'STL');
  assert.ok(obj.triangles > 500);
  assert.equal(solid.triangles, obj.triangles);
  assert.ok(obj.volume > 0);
  assert.ok(Math.abs(solid.volume / obj.volume - 1) < 1e-3, `${solid.volume} and ${obj.volume}`);
});

test('admesh finds an STL whole, and as tall as it was asked for', { skip: missing('admesh') }, (t) => {
  const report = said('admesh', saved(barFolder(t), 'stl'));
  isHeight(number(report, /Max Z =\s*([\d.]+)/) - number(report, /Min Z =\s*(-?[\d.]+)/), 'STL');
  for (const fault of [/Total disconnected facets\s*:\s*(\d+)/, /Degenerate facets\s*:\s*(\d+)/, /Facets reversed\s*:\s*(\d+)/, /Facets added\s*:\s*(\d+)/]) {
    assert.equal(number(report, fault), 0, report);
  }
  assert.ok(number(report, /Volume\s*:\s*(-?[\d.]+)/) > 0);
});

for (const ending of ['stl', '3mf']) {
  test(`PrusaSlicer measures and slices a ${ending.toUpperCase()}`, { skip: missing('prusa-slicer') }, (t) => {
    const folder = barFolder(t);
    const file = saved(folder, ending);
    const info = said('prusa-slicer', '--info', file);
    isHeight(number(info, /size_z = ([\d.]+)/), ending);
    assert.match(info, /manifold = yes/);
    const code = folder.path('bar.gcode');
    said('prusa-slicer', '--export-gcode', '--output', code, file);
    const moves = readFileSync(code, 'utf8').split('\n').filter((line) => /^G1 .*E/.test(line));
    assert.ok(moves.length > 500, `${moves.length} moves`);
  });
}

test('Blender imports a GLB at its size in metres', { skip: missing('blender') }, (t) => {
  const file = saved(barFolder(t), 'glb');
  const script = [
    // Debian's Blender 3.4 asks its numpy 1.24 for a name that this one no longer has.
    'import bpy, numpy', 'numpy.bool = bool', "bpy.ops.object.select_all(action='SELECT')", 'bpy.ops.object.delete()',
    `bpy.ops.import_scene.gltf(filepath=${JSON.stringify(file)})`,
    "meshes = [o for o in bpy.data.objects if o.type == 'MESH']",
    "print('SIZE', max((o.matrix_world @ v.co).z for o in meshes for v in o.data.vertices) - min((o.matrix_world @ v.co).z for o in meshes for v in o.data.vertices))",
  ].join('\n');
  isHeight(1000 * number(said('blender', '--background', '--factory-startup', '--python-expr', script), /SIZE ([\d.]+)/), 'GLB');
});
