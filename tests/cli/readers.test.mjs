// Other people's programs read what we write, where they are installed: admesh, PrusaSlicer, Blender.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
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
    'import bpy', "bpy.ops.object.select_all(action='SELECT')", 'bpy.ops.object.delete()',
    `bpy.ops.import_scene.gltf(filepath=${JSON.stringify(file)})`,
    "meshes = [o for o in bpy.data.objects if o.type == 'MESH']",
    "print('SIZE', max((o.matrix_world @ v.co).z for o in meshes for v in o.data.vertices) - min((o.matrix_world @ v.co).z for o in meshes for v in o.data.vertices))",
  ].join('\n');
  isHeight(1000 * number(said('blender', '--background', '--factory-startup', '--python-expr', script), /SIZE ([\d.]+)/), 'GLB');
});
